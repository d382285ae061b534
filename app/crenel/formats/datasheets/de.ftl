arm-angles-converted-twice = { $field } erreicht { $largest }: dies sind Grad, die noch einmal umgerechnet wurden, als wären sie Bogenmaß
arm-angles-in-radians = kein { $field } übersteigt { $largest }: dies ist Bogenmaß, aber Grad werden erwartet
arm-with-joints-needed = dafür ist ein Messarm nötig, der seine Gelenkwinkel meldet
bayer-needs-wavelength = { $bayer } braucht { $wavelength }: gemessen werden die Pixel dieser Farbe
contacts-stripe-several-levels-need-crenellated = für Antastpunkte und Laserlinie auf mehreren Höhenstufen ist ein Zinnenkörper nötig
convention-is-pose = { $path }: convention ist „pose“
crest-z-mm-must-above-floor = { $crest } muss über { $floor } liegen und { $floor } über { $base }
dictionary-unknown = { $field } ist eines von { $names }
edges-x-mm-must-ascend-follows = die Werte in { $edges } müssen ansteigen: { $right } folgt auf { $left }
edges-x-mm-odd-count =
    { $edges } enthält { $count ->
        [one] { $count } Kante
       *[other] { $count } Kanten
    }; jede Zinne hat zwei, eine linke und eine rechte
field-must-be-less-than-half-square = { $field } muss kleiner als ein halbes Feld sein; ist der Wert in Mikrometern angegeben?
first-id-too-large = { $field }: höchstens { $most } bei diesen Markierungen aus { $dictionary }
front-y-mm-must-less-than = { $front } muss kleiner als { $back } sein
give-certificate-crenellated-object-calibrate-command = Kalibrierschein eines Zinnenkörpers angeben oder auf der Kommandozeile kalibrieren
give-denavit-hartenberg-model = Denavit-Hartenberg-Modell des Messarms angeben (convention „dh-standard“)
joint-name-twice = zwei Gelenke heißen { $name }; Aufzeichnungen unterscheiden Gelenke nach ihrem Namen
kind-chessboard-not-supported = { $path }: kind „chessboard“ wird hier nicht unterstützt
kind-is-block-or-board = es ist „crenellated“, „chessboard“ oder „charuco“
kind-unknown = { $path }: kind { $kind } ist unbekannt
lengths-are-in-metres = kein a_mm oder d_mm ist größer als { $longest }: Das sind Meter, erwartet werden Millimeter
lengths-of-no-arm = a_mm und d_mm aller Gelenke sind zusammen { $length }: dies sind Zoll oder Zentimeter, aber Millimeter werden erwartet
limits-deg-must-ascend = die Werte in { $limits } von { $name } müssen ansteigen
marker-mm-less-than-square-mm = { $marker } muss kleiner als { $square } sein
merlons-not-distinct-from-mirror-image = { $edges }: Breiten und Abstände der Zinnen sind von beiden Enden aus gleich, sodass sich der Zinnenkörper nicht von seinem Spiegelbild unterscheiden lässt
rotation-of-poses = rotation { $name } ist nicht bekannt, oder der Arm meldet Gelenke: Die eines Roboters ist eine von { $names }
square-mm-too-small = { $field } muss mindestens { $least } betragen; ist der Wert in Metern angegeben?
standard-uncertainty-mm-too-large = { $field } darf höchstens { $most } betragen; ist der Wert in Mikrometern angegeben? Für einen Block, den niemand gemessen hat, stattdessen { $tolerance } angeben
tip-missing-place-flange-diameter = { $tip } fehlt: Lage der Tastkugel am Flansch und ihr Durchmesser
tolerance-mm-out-of-range = { $field } muss größer als 0 und höchstens { $most } sein; einen gröber gefertigten Block messen und aus den Messwerten sein Zertifikat erstellen
too-few-markers = { $field }: die Tafel hat { $count } Markierungen, { $dictionary } aber nur { $known }
uncertainties-above-largest = { $field } braucht daneben { $one }, den größten dieser Werte
uncertainties-of-edges-count = { $field } hat { $found } Kanten, der Block hat { $wanted }
uncertainty-or-tolerance = genau eines von { $one } und { $tolerance } ist nötig: das erste, wenn der Block gemessen wurde, das zweite, wenn nur seine Zeichnung bekannt ist

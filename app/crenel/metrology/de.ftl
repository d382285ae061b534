bring-more-object-into-picture = mehr vom Objekt ins Bild bringen
bring-more-object-into-picture-sharp = mehr vom Objekt ins Bild bringen, scharf und gut beleuchtet
certificate-says = laut Kalibrierschein { $square }
channel-of-colour =
    { $colour ->
        [red] Rot
        [green] Grün
       *[blue] Blau
    }
channel-raw = Pixel der Farbe { $colour } von { $pattern }
channel-share = { $share } { $colour }
check-arms-file-lengths-angles-signs = Armdatei prüfen: Längen und Winkel, Vorzeichen und Reihenfolge der Gelenke sowie die Tastkugel; dann prüfen, auf welcher Fläche jeder Punkt angetastet wurde, und den Kalibrierschein des Objekts
check-session-taken-arm = prüfen, ob die Sitzung mit diesem Messarm aufgenommen wurde
clean-blocks-edges-check-focus-lighting = Kanten des Zinnenkörpers reinigen; Schärfe, Beleuchtung und Kalibrierschein prüfen.
contacts = die Antastpunkte
contacts-tips-sphere = Antastpunkte entstehen mit einer Tastkugel
fitting-contact-points = Antastpunkte werden ausgeglichen
give-laser-on-off-pair = Ein Bild mit eingeschaltetem Laser und eines derselben Szene ohne Laser angeben
give-tip-or-leave-out-probing = Tastkugel in arm.json angeben oder probing.csv weglassen
image-shape-type = ein Bild der Form { $shape } und des Typs { $dtype }
laser-off-or-covered = der Laser ist aus, verdeckt oder zu schwach
laser-on-not-brighter = das Bild mit Laser ist nicht heller als das ohne Laser
laser-on-off-differ = die Bilder mit und ohne Laser sind verschieden: { $on } und { $off } Pixel
lengths-of-unit-expected-mm =
    { $unit ->
        [m] dies sind Meter, aber Millimeter werden erwartet
        [cm] dies sind Zentimeter, aber Millimeter werden erwartet
       *[inch] dies sind Zoll, aber Millimeter werden erwartet
    }
needs-least-three-conjugated-pairs = sie braucht mindestens drei zugeordnete Paare
on-face =
    { $face ->
        [crest] auf den Zinnenoberseiten
        [floor] auf den Nutgründen
        [front] auf der Vorderseite
        [back] auf der Rückseite
        [left] auf der linken Stirnseite
        [right] auf der rechten Stirnseite
       *[other] auf der Fläche „{ $face }“
    }
rigid-fit-given-points = eine starre Einpassung erhielt { $a } und { $b } Punkte
rigid-fit-given-points-one-line = eine starre Einpassung erhielt Punkte auf einer Geraden
same-camera-both = beide kommen von einer Kamera in einer Betriebsart
they-do-not-determine-camera = sie bestimmen die Kamera nicht

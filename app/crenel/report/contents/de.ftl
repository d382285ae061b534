across-mm = quer, mm
after = Nachher
after-mark = nachher
against-use-before-points-measuring-volume = Gegenüber der zuvor verwendeten { $name }: Punkte im Messvolumen haben sich um { $rms } ({ $rms_mm }) rms verschoben, höchstens um { $largest } ({ $largest_mm }).
arm-by-its-datasheet = der Messarm entspricht seinem Datenblatt
arm-check = Armprüfung
arm-check-uncertainty-is-zero = Angewendet auf (max − min)/2 jeder Achse mit der Unsicherheit null, da der Beitrag der Form von Pfanne und Tastkugel nicht angegeben ist: Der Wert wird unmittelbar mit dem Grenzwert verglichen. Die räumlichen Kennwerte stehen ohne Grenzwert.
arms-parameters = Parameter des Messarms
axes = Achsen
ball-bars = Kugelstäbe
before = Vorher
before-after-identification = Vor und nach der Identifikation
before-mark = vorher
behind = von hinten
beyond-limit = Grenzwert überschritten
block-certificate = Zertifikat des Blocks
block-certified-by-readings =
    { $count ->
        [one] Koordinaten aus einem Messwert; die größte Standardunsicherheit ist { $largest } (k = 1).
       *[other] Koordinaten durch Ausgleichung von { $count } Messwerten; die größte Standardunsicherheit ist { $largest } (k = 1).
    }
block-certified-by-touches = Koordinaten durch Ausgleichung von { $touches } Antastungen und { $readings } Messwerten; die größte Standardunsicherheit ist { $largest } (k = 1).
calibrated = Kalibriert
calibrated-distance-camera = Kalibrierter Abstand von der Kamera
calibration-acceptance-test-no-characteristic-iso = Dies ist eine Kalibrierung, keine Annahmeprüfung: Es werden keine Kenngrößen nach ISO 10360-8 oder ISO 10360-12 angegeben. Den Scanner prüft eine Verifizierung an Prüfnormalen.
calibration-not-accepted-at-station = Diese Kalibrierung wurde nicht an einer Station angenommen.
calibration-report = Kalibrierbericht
change = Änderung
coefficient = Koeffizient
contact-points-heading = Antastpunkte
contact-points-label = Antastpunkte
contacts-rms =
    Antastpunkte, rms von { $count ->
        [one] { $count } Punkt
       *[other] { $count } Punkten
    }
contacts-rms-outliers = Antastpunkte, rms von { $count } Punkten, { $outliers } ausgeschlossen
coordinate = Koordinate
coordinates = Koordinaten des Objekts
coordinates-held-out = Gemessene Koordinaten, kreuzvalidiert
corners-px = Ecken, px
corners-rms = Ecken, rms
correlated-known-together = Korreliert: gemeinsam gut bestimmt, einzeln weniger gut
decision-rule-limits-set-standard-uncertainty = Entscheidungsregel: Die Grenzwerte gelten für die Standardunsicherheit selbst und werden unmittelbar mit ihr verglichen, ohne Schutzabstand.
depth-mm = Tiefe, mm
diameter-of-tip-by-datasheet = Tastkugeldurchmesser laut Datenblatt
diameter-tip-found = Gemessener Tastkugeldurchmesser
distance-each-touch-face-times-larger = Abstand jedes Antastpunkts von seiner Fläche, { $factor }-fach vergrößert: Blau innen, Orange außen, Kreuze ausgeschlossen. Der längste Strich entspricht { $largest } ({ $largest_mm }).
distance-each-touch-sphere-through-all = Abstand jedes Antastpunkts von der Ausgleichskugel derer, die übereinstimmen.
distortion = Verzeichnung
do-not-use = Nicht verwenden
each-point-swing-about-middle-all = Jeder Punkt des Schwenks relativ zur Mitte aller Punkte, im Koordinatensystem des Messarms.
each-touchs-distance-sphere = Abstand jedes Antastpunkts von der Kugel
edges-corners-rms = Kanten und Ecken, rms
edges-px = Kanten, px
end-name = Der Name muss auf .html oder .pdf enden
error = Durchmesserabweichung
error-budget = Unsicherheitsbudget
error-budget-with-limits = Beiträge zur Standardunsicherheit (k = 1) eines gescannten Punkts. Grenzwerte: gut bis { $good }, brauchbar bis { $usable }.
excluded-because-within-sentence = ausgeschlossen: { $reason }
face = Fläche
face-of-block = Fläche
faces-as-touched = Flächen, wie angetastet
file-carries-no-verdict = Die Datei enthält keine Entscheidung.
findings = Befunde
flange-frame-of-this-arm-former-calibrations-not-valid = Das Flanschsystem ist jetzt das dieses Messarms: Kalibrierungen mit dem bisherigen Messarm gehören nicht dazu.
flatness-of-touches = Ebenheit
focal-length = Brennweite
focal-lengths = { $u } × { $v }
folder-their-own = aus einem eigenen Ordner
form-max-min-m = Form (max − min), µm
form-of-faces-is = Ebenheit ist die Spanne der Antastungen um ihre eigene Ausgleichsebene; Parallelitätsabweichung ist, was diese Ebene über die angetastete Fläche gegen die Achse des Blocks ansteigt. Drei Antastungen zeigen keine Form.
from = Von
front = von vorn
good-m-usable-m = gut ≤ { $good }, brauchbar ≤ { $usable }
good-up-m = gut bis { $limit }
held-out-places-fit-did-see = Kreuzvalidierung an { $places } Positionen, die nicht in die Ausgleichung eingingen, { $how }; das Rauschen der Winkelgeber ist enthalten. In Standardabweichungen der Punkte { $before } vorher und { $after } nachher; 1 entspricht dem Rauschen allein.
held-out-turn = reihum ausgelassen
holds-no-record-one = er enthält keinen solchen Eintrag
how-arm-swung = Verlauf des Schwenks
identification-arm = Identifikation des Messarms
identified = Identifiziert
identify-arm-folders-again = Identifikation mit { $arm } des Ordners erneut ausführen
inner-corners-mm-apart = { $columns } × { $rows } innere Ecken, Abstand { $square }, { $known }
joint = Gelenk
joint-adjustment-all-poses = gemeinsame Ausgleichung aller Posen
known-k-1 = Standardunsicherheit { $known } (k = 1)
largest-distance-from-mean = Größter Abstand vom Mittelwert, räumlich
largest-distance-touch-sphere = Größter Abstand eines Antastpunkts von der Kugel
laser-plane = Laserebene
laser-stripe-sensor-measuring-arm = Lichtschnittsensor an einem Messarm
laser-wavelength = Laser { $wavelength }
lengths-ball-bars-held-out = Längen der Kugelstäbe, kreuzvalidiert
limit-k-1 = Grenzwert, k = 1
max-min-2-along = (max − min)/2 entlang { $axis }
measured-channel = gemessen: { $channel }
measuring-arm = Messarm
merged-in-frame-of-arm-not-moved = Alle Punkte liegen im Koordinatensystem des Messarms. Wurde Messarm oder Teil zwischen den Scans bewegt, passen sie nicht zusammen: Ein Vergleich zweier Scans zeigt, um wie viel.
merged-of = Zusammengeführt aus
merged-with-own-calibrations = Die Scans wurden mit verschiedenen Kalibrierungen aufgenommen; die Punkte jedes Scans entstanden mit der eigenen.
method = Verfahren
n-2-along = 2σ entlang { $axis }
n-2-encoders-alone = 2σ allein durch die Winkelgeber, { $axis }
name-folder-calibration-check-verification-has = Ordner einer Kalibrierung, einer Prüfung, einer Verifizierung oder einer Leistungsprüfung angeben: Er enthält eine der Dateien { $files }
named-value = { $name } { $value }
no-limit-set-identification-check-arm = Für eine Identifikation ist kein Grenzwert festgelegt: Eine Armprüfung beurteilt sie.
none-significant = kein Koeffizient signifikant
none-yet = noch keine
not-by-standard-one-seat = Nicht normgerecht: eine Pfanne und ein stetiger Schwenk statt der Positionen und Punkte nach ASME B89.4.22 oder ISO 10360-12. Ein Ergebnis nach diesen Normen wird nicht angegeben.
not-by-standard-other-touches = Nicht normgerecht: Die Antastpunkte sind nicht die der Kugelprüfungen nach ISO 10360-12; daher wird keines ihrer Formelzeichen verwendet.
not-judged = Nicht beurteilt
object-off-m = Objektabw., µm
one-pose-faugeras-contact-alignment = eine Pose (Faugeras, Ausrichtung über Antastpunkte)
origin-mm = Ursprung, mm
out-of-parallel = Parallelitätsabweichung
over-reach-before-difference-arm-identified = Über die Reichweite: vorher die Abweichung vom identifizierten Messarm, nachher die Standardunsicherheit, k = 1.
over-reach-tip-off-rms-now = Über die Reichweite wich die Tastkugel um { $before } rms ab; die Standardunsicherheit beträgt jetzt { $after } (k = 1).
parameter = Parameter
parameters = Parameter
picture-of-cloud = Bild der Punktwolke
picture-of-cloud-seen-from = { $name }, von oben vorn, nach Höhe gefärbt.
plane-equation = ({ $x }; { $y }; { $z }) · x = { $offset }
plane-swept-straight-across-angle = Gerade überfahrene Ebene: Winkel
point-expanded-uncertainty = Gescannter Punkt, rms im Messvolumen: erweiterte Unsicherheit
point-judged-with-guard =
    Für ein Merkmal, das durch einen einzelnen gescannten Punkt gegeben ist, beträgt der Schutzabstand { $guard } ({ $guard_mm }): { $bearer ->
        [supplier] Es ist nur konform, wenn der Punkt um mehr als diesen innerhalb der Toleranz liegt.
        [user] Es ist nur nicht konform, wenn der Punkt um mehr als diesen außerhalb der Toleranz liegt.
       *[prover] Die Konformität ist nachgewiesen, wenn der Punkt um mehr als diesen innerhalb der Toleranz liegt, die Nichtkonformität, wenn er um mehr außerhalb liegt.
    }
point-judged-without-guard = Ein Merkmal, das durch einen einzelnen gescannten Punkt gegeben ist, ist konform, wenn der Punkt innerhalb der Toleranz liegt.
point-standard-uncertainty = Gescannter Punkt, rms im Messvolumen: Standardunsicherheit
pose = Pose
pose-found-minus-computed-times-larger =
    Pose { $number }: gemessen minus berechnet, { $factor }-fach vergrößert; Ecken gelb, höchstens { $largest }; Laserlinie rot. { $fitted ->
        [corners] Ecken { $rms }
       *[edges] Kanten { $rms }
    }, Laserlinie { $stripe_rms } rms.
pose-residuals-corners-without-stripe =
    Pose { $number }: gemessen minus berechnet, { $factor }-fach vergrößert; Ecken gelb, höchstens { $largest }; keine Laserlinie. { $fitted ->
        [corners] Ecken { $rms }
       *[edges] Kanten { $rms }
    } rms.
poses-heading = Posen
poses-measured =
    { $points ->
        [one] { $points } Punkt
       *[other] { $points } Punkte
    } in { $frames ->
        [one] { $frames } Koordinatensystem
       *[other] { $frames } Koordinatensystemen
    }
poses-touches = Posen und Antastpunkte
positions =
    { $bars } in { $positions ->
        [one] { $positions } Lage
       *[other] { $positions } Lagen
    }
principal-point = Hauptpunkt
principal-point-at = { $u }; { $v }
probe-matrix-sensors-frame-arms-last = Tastermatrix: Koordinatensystem des Sensors in dem des letzten Gelenks des Messarms.
reading-minus-fit = Messwert − Ausgleichung
reading-of-certificate = Messwert
readings-agree = Messwerte passen zusammen
readings-of-certificate = Messwerte
report-cannot-written = ein Bericht lässt sich nicht als „{ $suffix }“ schreiben
report-customer = Kunde
report-duration = Dauer
report-name = Name
report-number = Nummer
report-order = Auftrag
report-part = Teil
report-pictures = Bilder
report-point-uncertainty = Gescannter Punkt
report-scan = Scan
report-serial-number = Seriennummer
residuals-contacts-object = Residuen der Antastpunkte am Objekt
residuals-image = Residuen in den Bildern
residuals-image-worst-poses = Residuen in den Bildern (die { $count } am schlechtesten passenden von { $used } Posen)
residuals-object = Residuen am Objekt
residuals-pose-picture = Residuen von Pose { $number } im Bild
result-rms = Ergebnis, rms
rms-before-after-each-pair-scale = Effektivwerte (rms) vorher und nachher, jedes Paar in eigenem Maßstab.
same-offset = Gerade überfahrene Ebene: Versatz
says-nothing-identification = { $folder } enthält keine Identifikation
scan-complete = Vollständig
scan-ended-early = Vorzeitig beendet
scan-frames-lost =
    { $count ->
        [one] { $count } Bild ging verloren.
       *[other] { $count } Bilder gingen verloren.
    }
scan-frames-too-fast =
    { $count ->
        [one] { $count } Bild wurde zu schnell aufgenommen: Seine Punkte sind längs der Bewegung verwischt.
       *[other] { $count } Bilder wurden zu schnell aufgenommen: Ihre Punkte sind längs der Bewegung verwischt.
    }
scan-frames-without-points =
    { $count ->
        [one] { $count } Bild mit Linie ergab keine Punkte.
       *[other] { $count } Bilder mit Linie ergaben keine Punkte.
    }
scan-has-points =
    { $count ->
        [one] { $count } Punkt.
       *[other] { $count } Punkte.
    }
scan-incomplete = Unvollständig
scan-report = Scanbericht
scatter-coordinates-beyond-uncertainty = Streuung der Koordinaten über die angegebene Unsicherheit hinaus
scatter-single-points-beyond-encoders = Streuung einzelner Punkte über die Winkelgeber hinaus
seats-held-out = Pfannen, kreuzvalidiert
sphere-known-to = Ø { $diameter }, Standardunsicherheit { $known } (k = 1)
sphere-of-unknown-uncertainty = Ø { $diameter }, Unsicherheit nicht angegeben
spheres-held-out = Kugeln, kreuzvalidiert
standard-uncertainty-k-1 = u, k = 1
standard-uncertainty-k-1-scanned-point = Standardunsicherheit (k = 1) eines gescannten Punkts über der Laserebene, von { $low } ({ $low_mm }) bis { $high } ({ $high_mm }). Durchgestrichen: extrapoliert, näher oder weiter als die kalibrierten { $near } bis { $far } von der Kamera.
stripe-about-laser-plane-rms-points =
    Laserlinie um die Laserebene, rms von { $points ->
        [one] { $points } Punkt
       *[other] { $points } Punkten
    }
stripe-px = Laserlinie, px
swing = Schwenk
swing-about-middle-limit = Jeder Punkt des Schwenks relativ zur Mitte aller Punkte, im Koordinatensystem des Messarms. Gestrichelt: der Grenzwert von { $limit }.
tip-check = Tastkugelprüfung
tip-held-seat-moved-max-min = Die Tastkugel hat sich in einer Pfanne um { $worst } bewegt, (max − min)/2 auf der schlechtesten Achse.
tip-in-seat-moved-limit = Die Tastkugel hat sich in einer Pfanne um { $worst } bewegt, (max − min)/2 auf der schlechtesten Achse; der Grenzwert ist { $limit }.
tip-known-without-size = Über die Reichweite wich die Tastkugel um { $before } rms ab; die Standardunsicherheit beträgt jetzt { $after } (k = 1), ohne den Maßstab des Messarms.
tip-off-place-arm = Abweichung der Tastkugel von ihrer Lage am Messarm
tip-over-whole-reach = Tastkugel über die ganze Reichweite
tip-rule-applies-to-error-alone = Die Regel gilt für die Durchmesserabweichung. Die Streuung wird unmittelbar mit ihrem Grenzwert verglichen.
tips-places = Positionen der Tastkugel
tips-places-about-their-middle = Positionen der Tastkugel relativ zu ihrer Mitte
to = Bis
together = Gesamt
tool-found = { $value }, Standardunsicherheit { $known } (k = 1)
tool-of-reading = Gerät
touches-about-sphere-limit = Abstand jedes Antastpunkts von der Ausgleichskugel. Gestrichelt: der Grenzwert von { $limit }.
touches-of-face = Antastungen
two-s-of-distances = 2 s dieser Abstände
uncertainty-over-measuring-volume = Unsicherheit im Messvolumen
unchanged = Unverändert
unit = Einheit
usable-attention = Brauchbar, mit Vorbehalt
used-but-within-sentence = verwendet, aber { $reason }
what-calibrated = Gegenstand der Kalibrierung
what-checked = Gegenstand der Prüfung
what-identified = Gegenstand der Identifikation
what-standard-uncertainty-k-1-scanned = Beiträge zur Standardunsicherheit (k = 1) eines gescannten Punkts.
why = Warum
with-tip = Tastkugel { $diameter }
within-limit = Innerhalb des Grenzwerts
word-no = nein
word-used = verwendet

add-picture-delete-pose = Bild ergänzen oder Pose löschen
angles-are-in-other-unit =
    { $unit ->
        [deg] das ist Bogenmaß, wo Grad erwartet werden
       *[rad] das sind Grad, wo Bogenmaß erwartet wird
    }
arm-json-states-rotation = rotation in arm.json ist { $name }
bar-has-two-ends = ein Kugelstab hat zwei Enden
bar-named = Kugelstab { $name }
bar-position-has-ends = { $path }: Kugelstab { $bar }, Lage { $position } hat die Enden { $ends }
column-is = { $place }: { $column } ist { $value }
complete-or-delete-rows-of-position = Zeilen dieser Lage ergänzen oder löschen
convert-columns-degrees = Spalten in Grad umrechnen
convert-lengths-mm-name-columns = Längen in mm umrechnen und die Spalten { $names } nennen
convert-them-name-columns = Werte umrechnen und die Spalten { $first } bis { $last } nennen
correct-name = Namen berichtigen
correct-place-or-name-marker-differently = Ort berichtigen oder der Messmarke einen anderen Namen geben
correct-value-or-give-arm-json = Wert berichtigen oder die richtige arm.json angeben
correct-value-or-name-artefact-differently = Wert berichtigen oder einen anderen Prüfkörper anders benennen
degrees-converted-twice = So weit dreht kein Gelenk: Wurden Grad für Bogenmaß gehalten und umgerechnet, sie angeben, wie sie waren; sonst den Wert berichtigen
delete-columns-of-one = Die Spalten einer der beiden löschen
delete-one-rows = Eine der Zeilen löschen
file-has-no-pictures = { $path } enthält keine Bilder
file-has-no-pictures-with-laser = { $path } enthält keine Bilder mit eingeschaltetem Laser
file-has-no-points = { $path } enthält keine Punkte
file-has-no-readings = { $path } enthält keine Messwerte des Arms
flange-differs = der Flansch weicht um { $moved } ab
flange-lies-far = { $path }: der Flansch liegt { $furthest } von der Basis entfernt
folder-has-none-of = er enthält keine der Dateien { $names }
give-arms-own-model-columns = Modell dieses Messarms oder die Spalten { $names } angeben
give-picture-as-taken-and-sensor-json = Das Bild so angeben, wie die Kamera es aufgenommen hat, und die richtige sensor.json
give-quaternions-with-more-digits = qx, qy, qz, qw mit mindestens vier Nachkommastellen angeben, den Skalar zuletzt
give-qx-qy-qz-qw-order = qx, qy, qz, qw in dieser Reihenfolge angeben, den Skalarteil zuletzt
give-right-arm-json-columns = Richtige arm.json oder die Spalten { $first } bis { $last } angeben
give-rows-different-pose-numbers-take = Den Zeilen verschiedene Posennummern geben oder die Bilder neu aufnehmen
give-standard-uncertainty-of-certificate = Standardunsicherheit (k = 1) laut Kalibrierschein in Millimetern angeben
give-standard-uncertainty-of-instrument = Standardunsicherheit (k = 1) einer Koordinate oder eines Winkels angeben
give-times-in-seconds = Zeiten in Sekunden angeben, ab einem beliebigen Anfang
give-times-of-one-clock = Bildern und Messwerten Zeiten derselben Uhr geben
it-is-a-file = es ist eine Datei
joint-angles-given-degrees = Gelenkwinkel werden in Grad angegeben
joint-column-differs = q{ $joint }_deg weicht um { $moved } ab
joint-columns-or-none =
    { $count ->
        [0] { $path } hat keine Gelenkspalten
        [one] { $path } hat { $count } Gelenkspalte ({ $names })
       *[other] { $path } hat { $count } Gelenkspalten ({ $names })
    }
largest-angle-of-poses = { $path }: der größte Wert von { $names } ist { $largest }
lengths-of-smaller-unit =
    { $unit ->
        [m] dies sind Millimeter, wo Meter erwartet werden
       *[mm] dies sind Mikrometer oder eine andere Einheit als Millimeter
    }
line-gives-other-length = Zeile { $line } gibt { $length } für denselben Prüfkörper an: { $label }
line-gives-other-place = Zeile { $line } nennt einen anderen
marker-place-differs = { $place }: Messmarke { $marker } hat einen anderen Ort am Flansch
name-a-folder = Ordner angeben
name-columns-by-unit =
    { $unit ->
        [deg] Nennen Sie die Spalten mit _rad, oder rechnen Sie die Winkel um
       *[rad] Nennen Sie die Spalten mit _deg, oder rechnen Sie die Winkel um
    }
name-columns-of-degrees = Sie enthalten Grad: die Spalten { $first } … { $last } nennen
name-folder-of-seats-spheres-bars = Ordner mit Pfannen, Kugeln oder Kugelstäben angeben, die mit dem Messarm angetastet wurden, oder mit Koordinaten eines Lasertrackers
name-sessions-folder = Ordner einer Sitzung angeben
named-joint-range = Gelenk { $joint } dreht von { $low } bis { $high }
no-flange-further-than = { $path }: Kein Flansch ist weiter als { $furthest } von der Basis des Messarms entfernt
no-joint-angle-exceeds = { $path }: Kein Gelenkwinkel übersteigt { $largest }
no-picture-within-readings = kein Bild von { $path } wurde während der Messwerte von { $readings } aufgenommen, von { $begin } bis { $end }
no-rotation-exceeds = { $path }: Kein Wert von rx_deg, ry_deg und rz_deg ist größer als { $largest }
one-of = es ist eines von { $names }
one-picture-at-a-time = ein Sensor nimmt nur ein Bild zur selben Zeit auf
one-rotation-expected = eine Drehung wird nur auf eine Weise angegeben
one-used-each-lighting = je Beleuchtung wird eines verwendet
one-value-expected-for = erwartet wird für { $label } ein Wert von 0 bis { $largest }
picture-at-time-of-line = { $place } hat dieselbe time_s wie Zeile { $line }
pictures-are-at = die Bilder beginnen bei { $begin }
pictures-of-one-pose-need-still-arm = die Bilder einer Pose werden bei ruhendem Messarm aufgenommen
pose-differs-from-line = { $place }: { $moved } Abweichung von Zeile { $line } derselben Pose { $pose }
pose-has-no-picture = { $place }: Pose { $pose } hat kein { $missing }-Bild
pose-needs-a-lit-picture = für eine Pose ist ein Bild „ambient“ nötig oder eines mit beiden Beleuchtungen („both“); auf einem Schachbrett darf das Bild „laser“ fehlen
pose-needs-both-lightings = für eine Pose sind ein Bild „ambient“ und ein Bild „laser“ nötig oder eines mit beiden Beleuchtungen („both“)
quaternion-length = { $place }: (qx, qy, qz, qw) hat die Länge { $length }
restore-picture-delete-row = Bild wiederherstellen oder Zeile löschen
rotation-means-several = sie können je nach Steuerung Verschiedenes bedeuten: { $names }
rotation-not-stated = { $path }: Nichts sagt, wie { $columns } eine Drehung ergeben
rotations-quaternion-has-length-1 = das Quaternion einer Drehung hat die Länge 1
row-feature = { $place }: feature { $feature }
row-file = { $place }: Datei { $file }
row-lighting = { $place }: lighting { $lighting }
second-picture-pose = { $place }: ein zweites { $lighting }-Bild der Pose { $pose }
sensor-has-pixels = der Sensor hat { $width } × { $height } Pixel
sessions-pictures-lie-inside-folder = die Bilder einer Sitzung liegen in ihrem Ordner
state-rotation-in-arm-json = Nennen Sie die Steuerung als rotation in arm.json, etwa "rotation": "kuka"
table-first-line-names = { $path }: Die erste Zeile nennt { $names }
table-has-both = { $path } hat die Spalten { $first } und { $second }
take-picture-object = Bild des Objekts aufnehmen
take-points-or-delete-file = Punkte aufnehmen oder die Datei löschen
these-joint-angles-but-arm-json = dies sind Gelenkwinkel, aber laut arm.json meldet der Messarm Posen
these-metres-where-millimetres-expected = dies sind Meter; erwartet werden Millimeter
these-radians-where-degrees-expected = dies sind Radiant; erwartet werden Grad
time-from-zero-to = eine Zeit liegt zwischen 0 und { $latest }
value-expected-between = erwartet wird ein Wert von 0 bis { $largest }
write-readings-of-arm = Die Messwerte des Arms mit ihren Zeiten eintragen

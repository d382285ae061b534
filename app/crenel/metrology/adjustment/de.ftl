a-laser-plane-is-of-one-laser = eine Laserebene ist die eines Lasers
add-pictures-turned-about-another-axis = Bilder aufnehmen, die um eine andere Achse gedreht sind
adjusting-all-poses-together = Alle Posen werden gemeinsam ausgeglichen
all-poses-turn-flange-about-one = alle { $count } Posen drehen den Flansch um dieselbe Achse, ({ $x } { $y } { $z }) im Flanschsystem
arms-motion-moves-other-way-than = nach der Bewegung des Messarms müsste sich „{ $name }“ andersherum bewegen als in den Bildern
arms-motion-object-than-certificate-says =
    { $sign ->
        [larger] Nach der Bewegung des Messarms ist das Objekt { $share } (± { $uncertainty }) größer als laut Kalibrierschein: Alle Längen würden im selben Verhältnis falsch.
       *[smaller] Nach der Bewegung des Messarms ist das Objekt { $share } (± { $uncertainty }) kleiner als laut Kalibrierschein: Alle Längen würden im selben Verhältnis falsch.
    }
arms-motion-squares-wide = nach der Bewegung des Messarms sind die Felder von „{ $name }“ { $width } breit
arms-motion-squares-wide-certificate = Nach der Bewegung des Messarms sind die Felder { $width } breit (± { $uncertainty }), laut Kalibrierschein { $nominal }: Alle Längen würden im selben Verhältnis falsch.
autofocus-or-zoom-changed-it = Autofokus oder Zoom haben sie verändert, und eine Kalibrierung gilt für eine Brennweite
block-dimension =
    { $name ->
        [base] Höhe der Böden über der Unterseite
        [depth] Tiefe von vorn bis hinten
        [height] Höhe der Kronen über den Böden
       *[width] Breite von links bis rechts
    }
block-dimensions-undetermined = Weder Bilder noch Antastpunkte zeigen vom Block: { $names }; dort zählt die Toleranz.
block-edges-estimated = Vom Block ist nur die Zeichnung bekannt: seine Kanten wurden mit der Kalibrierung geschätzt. Sie liegen bis zu { $beside } neben der Zeichnung, mit einer Standardunsicherheit von { $known }, die in allen Posen dieselbe ist.
board-bends-over-pattern-allowed = Die Tafel ist über das Muster um { $bend } durchgebogen; das ist berücksichtigt.
board-bends-over-pattern-flat-expected = Die Tafel ist über das Muster um { $bend } durchgebogen; erwartet wurde eine Ebenheit von { $flatness }.
board-tilted-most-between-pictures = die Tafel ist in den { $seen } Bildern höchstens um { $tilt } gegeneinander geneigt
calibrate-camera-and-laser-together = Kamera, Anbau und Laser gemeinsam aus diesen Bildern kalibrieren
calibrations-unknowns-did-settle-what-seen = die Unbekannten der Kalibrierung konvergieren mit diesen Bildern und Antastpunkten nicht
check-arm-play-tip-sensor-loose = Messarm auf Spiel, Tastkugel und Sensor auf festen Sitz prüfen; ruhig halten.
check-board-how-exact-certificate-takes = Prüfen, ob es diese Tafel ist und welche Unsicherheit ihr Kalibrierschein angibt.
check-each-laser-picture-own-pose-laser-not-moved = Prüfen, ob jedes Laserbild zu seiner Pose gehört und bei unbewegtem Sensor aufgenommen wurde und ob der Laser fest sitzt; dann den Fokus des Lasers.
check-each-laser-picture-own-pose-no-reflection = prüfen, ob jedes Laserbild zu seiner Pose gehört, ob der Laser gegenüber der Kamera verstellt wurde und ob die Linie im Bild die des Lasers und keine Reflexion ist
check-laser-board-camera-not-moved = Prüfen, ob Laser, Tafel und Kamera in Ruhe waren und ob Bild und Pose vom selben Zeitpunkt stammen.
check-laser-line-crossed-object-exposure = Prüfen, ob der Laser eingeschaltet war, ob seine Linie das Objekt kreuzte und ob die Belichtung passt; die Pose neu aufnehmen.
check-laser-not-moved-and-no-reflection = prüfen, ob der Laser gegenüber der Kamera verstellt wurde und ob die Linie im Bild die des Lasers und keine Reflexion ist
check-laser-picture-pose-sensor-held = Prüfen, ob das Laserbild zu dieser Pose gehört, ob der Sensor zwischen ihren beiden Bildern ruhig gehalten wurde und ob der Laser fest sitzt; die Pose neu aufnehmen.
check-mounted-tip-and-nothing-moved = Die montierte Tastkugel mit der Armdatei vergleichen und prüfen, ob sich nichts bewegt hat; das Armmodell neu identifizieren lassen.
check-mounted-tip-and-object-not-moved = Montierten Taster prüfen, seinen Durchmesser und seine Länge; ebenso, ob das Objekt nach dem Antasten bewegt wurde.
check-not-moved-every-picture-has-readings =
    { $thing ->
        [board] prüfen, ob die Tafel unbewegt blieb und ob zu jedem Bild die Messarmwerte seiner Pose gehören
       *[object] prüfen, ob das Objekt unbewegt blieb und ob zu jedem Bild die Messarmwerte seiner Pose gehören
    }
check-object-certificate-lengths-mm = Prüfen, ob dies das Objekt des Kalibrierscheins ist und ob seine Längen in mm angegeben sind.
check-object-pictures-every-picture-belongs = prüfen, ob dies das Objekt in den Bildern ist und ob jedes Bild zu seiner Armpose gehört
check-picture-joint-angles-one-moment = Prüfen, ob Bild und Gelenkwinkel vom selben Zeitpunkt stammen, oder die Pose neu aufnehmen.
check-pictures-joint-angles-those-their = Prüfen, ob die Gelenkwinkel der Bilder zu ihren Posen gehören.
check-pictures-not-mirrored-poses-of-flange = prüfen, ob die Bilder gespiegelt sind und ob die Posen den Flansch im Koordinatensystem des Messarms beschreiben, in mm, qw zuletzt, und nicht die inverse Transformation
check-square-tip-and-board-not-moved = square_mm und die Tastkugel in arm.json prüfen; ebenso, ob die Tafel bewegt wurde
check-tip-one-arms-file-board = Prüfen, ob die Tastkugel die der Armdatei ist und ob Tafel und Messarm fest standen.
check-which-tip-mounted-diameter-object = Montierten Taster und seinen Durchmesser prüfen; ebenso, ob dies das gewählte Objekt ist.
check-which-tip-mounted-stylus-straight = Prüfen, welcher Taster montiert ist und ob sein Schaft gerade ist und fest sitzt; seine Lage neu bestimmen lassen und das Objekt neu antasten.
contacts-arm-has-no-tip = { $readings } Antastpunkte, aber der Messarm { $name } hat keine Tastkugel
contacts-lie-board-rms = { $count } Antastpunkte liegen mit { $rms } rms auf der Tafel.
contacts-lie-board-rms-up-good = { $count } Antastpunkte liegen mit { $rms } rms auf der Tafel; gut ist bis { $good }.
contacts-lie-off-board-pictures-show = die { $touches } Antastpunkte liegen { $usual } neben der Tafel, die in den Bildern zu sehen ist
contacts-pictures-agree-better-tip-than = Antastpunkte und Bilder stimmen mit einem Tastkugeldurchmesser von { $fitted } (± { $known }) besser überein als mit { $given }.
contacts-pictures-agree-better-tips-centre = Antastpunkte und Bilder stimmen besser überein, wenn die Tastkugelmitte { $off } neben ihrer Lage laut Armdatei liegt: um { $x }; { $y }; { $z } (± { $known }) im Flanschsystem. Gescannte Punkte können um ebenso viel falsch liegen.
convert-poses-read-otherwise =
    { $fault ->
        [inverted] die Posen des Flanschs im Koordinatensystem des Messarms angeben; bei feststehendem Sensor jede Pose invertiert angeben, in Kalibrierungen wie in Scans: Das Ergebnis hat den Sensor dann im Koordinatensystem der Basis des Messarms, und Scans liegen im Koordinatensystem des Flanschs
        [mirrored] das Spiegeln (horizontal oder vertikal) in den Einstellungen der Kamera oder im Programm, das die Bilder gespeichert hat, ausschalten und diese Bilder zurückspiegeln
        [scalar-first] qx, qy, qz, qw in dieser Reihenfolge schreiben
        [scalar-first-inverted] die Posen des Flanschs im Koordinatensystem des Messarms angeben und qx, qy, qz, qw in dieser Reihenfolge schreiben
        [turns-inverted] die Drehungen des Flanschs im Koordinatensystem des Messarms angeben: das Vorzeichen von qw umkehren
        [rotations] die eigenen Spalten der Steuerung schreiben und sie als rotation in arm.json nennen: { $controllers }
        [unit] die Positionen in mm umrechnen oder ihre Spalten nach ihrer Einheit benennen
        [late] jedem Bild ab Pose { $first } die Pose geben, in der es aufgenommen wurde
        [early] jedem Bild ab Pose { $first } die Pose geben, in der es aufgenommen wurde
        [tool-changed] alle Posen in einem Werkzeug-Koordinatensystem angeben oder die Posen vor { $first } und die ab dort getrennt kalibrieren
        [object-moved] die Posen vor { $first } und die ab dort getrennt kalibrieren
       *[other] jedem Bild die Pose geben, in der es aufgenommen wurde
    }
corners-lie-off-regular-pattern-certificate = Die Ecken weichen um { $off } von einem regelmäßigen Muster ab, laut Kalibrierschein um { $standard_uncertainty }; das ist berücksichtigt.
data-speak-errors-arms-links-each = Die Daten deuten auf Fehler der Armglieder von je { $links } und { $turns } hin; was davon bleibt, macht { $share } der Unsicherheit eines Punkts aus.
expected = erwartet wird { $wanted }
finding-start = Startwerte werden bestimmt
fix-board-flat-plate = Tafel auf einer ebenen Platte befestigen.
fix-board-so-cannot-rock-warp = Tafel so befestigen, dass sie nicht wackeln oder sich verziehen kann, und das Objektiv der Kamera feststellen.
fix-focus-and-zoom-and-take-all-pictures-again = Autofokus abschalten, Fokus und Zoom feststellen und alle Bilder neu aufnehmen
fix-object-arm-so-neither-can = Objekt und Messarm so befestigen, dass sich keines bewegen kann, das Objekt antasten und die Bilder neu aufnehmen.
flange-turned-most-between-poses = der Flansch hat sich zwischen den { $count } Posen höchstens um { $turn } gedreht
flat-board-one-direction-does-not-tell-focal-length = Bilder einer ebenen Tafel aus einer Richtung bestimmen die Brennweite nicht
flat-board-tells-cameras-focal-length = eine ebene Tafel bestimmt die Brennweite der Kamera ab { $fewest_poses } gegeneinander geneigten Bildern
focal-length-differs-between-pictures = die Brennweite ist nicht in allen Bildern gleich (Unterschied { $span }): in den Posen { $poses } ist sie länger als in den übrigen
focus-zoom-or-lens-changed-since = Fokus, Zoom oder Objektiv haben sich seit ihrer Kalibrierung geändert
give-square-in-mm = square_mm in Millimetern angeben
half-them-more-contradicting-others-none = widerspricht mindestens die Hälfte den übrigen, ist keiner zu trauen
higher-by = { $distance } höher
how-sensor-sits-flange-shows-only = die Lage des Sensors am Flansch zeigt sich nur, wenn sich der Flansch dreht: mindestens drei Posen, um zwei verschiedene Achsen gedreht
identical-pictures-count-once = Die Bilder der Posen { $poses } sind noch einmal die anderer Posen. Sie zählen einmal.
keep-this-pose = so halten
kept-camera-does-not-fit = die Ecken liegen { $rms } (RMS) neben ihrem Ort nach der beibehaltenen Kamera, { $own } mit einer Kamera aus diesen Bildern
kept-camera-does-not-fit-the-arm = mit der behaltenen Kamera weichen Bilder und Arm { $times }-mal so stark voneinander ab wie mit einer eigenen Kamera
laser-line-left-out-off-plane = ihre Laserlinie wurde ausgeschlossen, { $off } neben der Ebene der übrigen
laser-line-lies-off-plane-others = ihre Laserlinie liegt { $off } neben der Ebene der übrigen
laser-lines-off-their-plane = die Laserlinien der Posen { $poses } liegen { $usual } neben der am besten passenden Ebene
laser-moved-by-lines-off-plane = Die Laserlinien der Posen { $poses } liegen { $off } neben der Ebene der übrigen: Der Laser hat sich gegenüber der Kamera bewegt; alle Linien gehen ein.
laser-plane-does-not-cross-board-sharply = eine Ebene, die nahezu in der Tafel liegt, schneidet sie nicht in einer scharfen Linie
lasers-line-lies-board-pictures = die Laserlinie liegt in { $enough } von { $views } Bildern auf der Tafel
lasers-line-lies-one-place-plane = die Laserlinie liegt in allen Bildern an derselben Stelle ihrer Ebene
lasers-line-pose-lies-off-plane = Die Laserlinie von Pose { $number } liegt { $off } neben der Ebene der übrigen und wurde ausgeschlossen.
lasers-lines-poses-lie-off-plane = Die Laserlinien der Posen { $poses } liegen { $off } neben der Ebene der übrigen: Der Laser hat sich gegenüber der Kamera bewegt; diese Linien wurden ausgeschlossen.
lasers-lines-poses-lie-up-off = die Laserlinien der Posen { $poses } liegen bis zu { $most } neben einer Ebene
lasers-plane-stands-board-limit = der Winkel zwischen Laserebene und Tafel beträgt { $angle } (Grenzwert { $least_laser_angle_deg })
let-laser-come-rest-take-pictures = Laser zur Ruhe kommen lassen und die Bilder neu aufnehmen.
let-laser-warm-up-check-mount = Laser warmlaufen lassen, seine Befestigung prüfen und die Bilder neu aufnehmen.
let-line-cross-board-in-more-pictures =
    { $more ->
        [one] ein weiteres Bild aufnehmen, in dem die Linie über die Tafel verläuft
       *[other] { $more } weitere Bilder aufnehmen, in denen die Linie über die Tafel verläuft
    }
light-board-evenly-sharp-large-picture = Tafel gleichmäßig beleuchten und scharf und groß ins Bild bringen.
limit-is-value = der Grenzwert ist { $limit }
lines-run-along-other-axis =
    { $axis ->
        [u] Die Laserlinien verlaufen in den Bildern von oben nach unten, gemessen wird aber ein Punkt je Spalte, sodass das meiste von ihnen verloren geht.
       *[v] Die Laserlinien verlaufen quer durch die Bilder, gemessen wird aber ein Punkt je Zeile, sodass das meiste von ihnen verloren geht.
    }
lower-by = { $distance } tiefer
measure-pattern-over-all-squares-correct = Muster über alle Felder messen und den Kalibrierschein berichtigen.
measure-patterns-width-height-fix-flat = Breite und Höhe des Musters messen und es auf einer ebenen Platte befestigen.
measure-squares-correct-certificate-check-every = Felder messen und den Kalibrierschein berichtigen; oder prüfen, ob zu jedem Bild seine eigene Pose in mm gehört
more-touches-on-face = { $count } weitere { $where }
needed-place = mindestens { $fewest_corners } sind nötig, um seine Lage zu bestimmen
neither-colours-nor-arms-poses-tell = weder die Farben noch die Posen des Messarms legen fest, welche Ecke die erste ist
no-laser-plane-yet = Kamera und Anbau sind kalibriert. Eine Laserebene gibt es noch nicht: Gescannt werden kann nicht.
no-picture-was-taken-with-the-laser = der Laser war in allen Bildern aus: Es gibt keine Ebene zu ergänzen
no-pose-given = es wurde keine Pose angegeben
no-size-squares-makes-them-agree = bei keiner Feldgröße stimmen sie überein
object-points-do-not-fit-pixels = die Punkte des Objekts passen nicht zu ihren Pixeln
one-line-alone-does-fix-lasers = eine einzelne Linie legt die Laserebene nicht fest
one-pose-alone-used-errors-arms = Es wurde nur eine Pose verwendet: Fehler der Armglieder zeigen sich nur in den Antastpunkten; nicht zum Bild gehörende Gelenkwinkel und ein nach dem Antasten bewegtes Objekt zeigen sich nicht.
picture-shows-no-laser-line-object = ihr Bild zeigt keine Laserlinie auf dem Objekt
pictures-contacts-certificate-contradict-each-other = Bilder, Antastpunkte und Kalibrierschein widersprechen sich
pictures-different-sizes = die Bilder sind verschieden groß: { $sizes }
pictures-have-object-turned-how-touched = In den Bildern ist das Objekt gegenüber der angetasteten Lage um { $turned } gedreht. Gescannte Punkte können um ebenso viel falsch liegen.
pictures-have-object-where-touched-turned = In den Bildern liegt das Objekt { $off } (± { $known }) neben der angetasteten Lage, um { $turned } gedreht. Gescannte Punkte können um ebenso viel falsch liegen.
pictures-show =
    { $seen ->
        [one] { $seen } Bild zeigt „{ $name }“
       *[other] { $seen } Bilder zeigen „{ $name }“
    }
plane-needs-lines = die Laserebene braucht Linien in mindestens { $fewest } Bildern; die übrigen Bilder bestimmen Kamera und Lage des Sensors
points-blocks-edges-fit-camera-rms = { $points } Punkte auf den Kanten des Zinnenkörpers passen zur Kamera mit { $rms } rms (Grenzwert { $edge_rms_px }), am schlechtesten in Pose { $number }: { $edges_rms } (Grenzwert { $worst_limit }).
points-lasers-line-lie-board-but-poses =
    { $count ->
        [one] { $points } Punkte der Laserlinie liegen auf der Tafel, { $rms } rms neben der Ebene. Pose { $poses } zeigt keine und bestimmt nur Kamera und Lage des Sensors.
       *[other] { $points } Punkte der Laserlinie liegen auf der Tafel, { $rms } rms neben der Ebene. Die Posen { $poses } zeigen keine und bestimmen nur Kamera und Lage des Sensors.
    }
points-lasers-line-lie-board-rms = { $points } Punkte der Laserlinie liegen auf der Tafel, { $rms } rms neben der Ebene.
pose-at-pixel = Pose { $number } ({ $u }, { $v })
pose-for-reason = Pose { $number }: { CLAUSE($reason) }.
pose-left-out = Pose { $number } wurde ausgeschlossen: { CLAUSE($reason) }.
pose-looks-same-turned-round = Pose { $number }: „{ $name }“ sieht gedreht gleich aus
pose-named = Pose { $number }: { $name }
pose-shows-corners = Pose { $number } zeigt { $found } Ecken von „{ $name }“
pose-shows-no-laser-line-object = Pose { $number } zeigt keine Laserlinie auf dem Objekt und wird ohne diese verwendet.
poses = die Posen
poses-agree-boards-place-pose-furthest = { $used } Posen stimmen in der Lage der Tafel auf { $median } überein; Pose { $number } weicht am weitesten ab, um { $off }.
poses-agree-objects-place-pose-furthest = { $used } Posen stimmen in der Lage des Objekts auf { $median } überein; Pose { $number } weicht am weitesten ab, um { $off }.
poses-agree-read-otherwise =
    { $fault ->
        [inverted] invertiert stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; so, wie sie angegeben sind, widersprechen sie ihnen
        [mirrored] mit gespiegelten Bildern stimmen { $agree } von { $count } Posen auf { $apart } mit „{ $name }“ überein; mit den Bildern, wie sie sind, widersprechen sie einander
        [scalar-first] mit dem Skalar der Quaternion zuerst stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; so, wie sie angegeben sind, widersprechen sie ihnen
        [scalar-first-inverted] invertiert und mit dem Skalar der Quaternion zuerst stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; so, wie sie angegeben sind, widersprechen sie ihnen
        [turns-inverted] mit invertierten Drehungen stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; so, wie sie angegeben sind, widersprechen sie ihnen
        [rotations] { $right ->
            [vector] mit Drehvektoren
           *[other] mit den Winkeln als { $right }
        } stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; so, wie sie angegeben sind, widersprechen sie ihnen
        [unit] mit den Positionen in { $unit } stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; so, wie sie angegeben sind, widersprechen sie ihnen
        [late] ab Pose { $first } sind die Posen { $rows ->
            [one] eine Zeile
           *[other] { $rows } Zeilen
        } zu spät: mit der Pose, die so viel weiter unten steht, stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein
        [early] ab Pose { $first } sind die Posen { $rows ->
            [one] eine Zeile
           *[other] { $rows } Zeilen
        } zu früh: mit der Pose, die so viel weiter oben steht, stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein
        [reversed] in umgekehrter Reihenfolge stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; in der angegebenen Reihenfolge widersprechen sie ihnen
        [sorted] wenn eine Spalte nach Namen (1, 10, 11, 2) und die andere nach Nummern sortiert ist, stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; in der angegebenen Reihenfolge widersprechen sie ihnen
        [swapped] mit vertauschten Posen { $first } und { $other } stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein
        [mixed] in anderer Reihenfolge stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; in der angegebenen Reihenfolge widersprechen sie ihnen
        [tool-changed] mit einem anderen Werkzeug-Koordinatensystem ab Pose { $first } stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; mit einem einzigen widersprechen sie ihnen
        [object-moved] mit „{ $name }“ an einem anderen Ort ab Pose { $first } stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern überein; mit einem einzigen Ort widersprechen sie ihnen
        [before] { $agree } von { $count } Posen stimmen auf { $apart } mit den Bildern von „{ $name }“ überein, wenn jede zum nächsten Bild gehört; mit dem eigenen nicht
       *[after] { $agree } von { $count } Posen stimmen auf { $apart } mit den Bildern von „{ $name }“ überein, wenn jede zum Bild davor gehört; mit dem eigenen nicht
    }
poses-all-alike-do-not-tell-mounting = gleichartige Posen bestimmen die Lage des Sensors am Flansch in keiner Richtung
poses-contacts-scatter-times-more-than = Posen und Antastpunkte streuen { $noise }-mal mehr, als die Winkelgeber des Messarms erklären (Grenzwert { $noisy }).
poses-move-too-little = images.csv: nach den Bildern bewegt sich der Arm { $ratio }-mal so weit, wie seine Posen sagen
poses-put-up-apart =
    { $thing ->
        [board] nach den Posen { $poses } liegen die Lagen der Tafel bis zu { $apart } auseinander
       *[object] nach den Posen { $poses } liegen die Lagen des Objekts bis zu { $apart } auseinander
    }
poses-without-contact-points = { $count } Posen ohne Antastpunkte
puts-object-fits-other-pose =
    { $readings ->
        [pose] danach läge das Objekt { $off } neben seiner Lage nach den übrigen Posen; sie passt zur Roboterpose von Pose { $other }
       *[angles] danach läge das Objekt { $off } neben seiner Lage nach den übrigen Posen; sie passt zu den Gelenkwinkeln von Pose { $other }
    }
puts-object-where-others-put = danach läge das Objekt { $off } neben seiner Lage nach den übrigen Posen
reading-of-arm-not-a-number = ein Wert des Messarms { $name } ist keine Zahl
readings-shape-arm = Werte der Form { $shape } für den Messarm { $name }
robot-pictures-agree-boards-place-but = Roboter und Bilder stimmen in der Position der Tafel überein, in ihrer Neigung aber nur auf { $tilt } (eigene Drehungen des Roboters: { $turn }).
sensor-turned-most-between-poses-wanted = Der Sensor hat sich zwischen den Posen um höchstens { $turn } gedreht (Soll: mindestens { $alike_deg }), sodass sie kaum mehr bestimmen als eine einzige.
set-stripe-axis = stripe_axis im Datenblatt des Sensors auf { $axis } setzen und neu kalibrieren.
so-poses-are-not-what-is-expected =
    { $fault ->
        [inverted] dies sind Posen der Basis des Messarms im Koordinatensystem des Flanschs, oder der Sensor steht fest und der Roboter trägt die Tafel
        [mirrored] die Bilder sind gespiegelt
        [scalar-first] in den Spalten stehen qw, qx, qy, qz
        [scalar-first-inverted] dies sind Posen der Basis des Messarms im Koordinatensystem des Flanschs, und in den Spalten stehen qw, qx, qy, qz
        [turns-inverted] die Drehungen sind die der Basis des Messarms im Koordinatensystem des Flanschs
        [rotations] { $given ->
            [vector] ihre Zahlen wurden für Drehvektoren gehalten
           *[other] ihre Zahlen wurden für Winkel als { $given } gehalten
        }
        [unit] die Positionen sind nicht in mm
        [late] es fehlen Bilder zu den Posen, oder eine Pose wurde doppelt geschrieben
        [early] es fehlt eine Pose, oder ein Bild wurde doppelt aufgenommen
        [reversed] Bilder und Posen stehen in umgekehrter Reihenfolge
        [sorted] Bilder und Posen stehen in verschiedener Reihenfolge
        [swapped] jede gehört zum Bild der anderen
        [mixed] diese Bilder haben die Posen anderer (Bild: seine Pose): { $pairs }
        [tool-changed] das Werkzeug-Koordinatensystem des Roboters wurde geändert oder der Sensor neu montiert
        [object-moved] die Tafel wurde bewegt oder das Basis- oder Benutzer-Koordinatensystem des Roboters geändert
       *[other] Posen und Bilder sind um eins gegeneinander verschoben
    }
take-more-pictures-8-more-them = weitere Bilder aufnehmen, mindestens 8, um 20° und mehr geneigt
take-more-pictures-all-sides-have = Weitere Bilder von allen Seiten aufnehmen; das Armmodell neu identifizieren lassen.
take-more-pictures-all-sides-hold = Weitere Bilder von allen Seiten aufnehmen; den Messarm dabei in kompakter Haltung führen.
take-more-pictures-board-all-corners = Weitere Bilder aufnehmen, mit der Tafel in allen Ecken des Bildes.
take-more-pictures-each-turned-against = weitere Bilder aufnehmen, jedes gegenüber den anderen gedreht, oder das Objekt antasten
take-more-pictures-for-camera-and-mounting = Kamera und Anbau aus mehr Bildern kalibrieren.
take-more-pictures-lasers-line-flat = Weitere Bilder aufnehmen, mit der Laserlinie auf der Fläche der Tafel.
take-more-pictures-like-these = Weitere Bilder aufnehmen, nach allen Seiten geneigt: Insgesamt würden etwa { $asked } wie diese ausreichen. Erreicht der Roboter nicht mehr, die Grenzwerte nach dem Bedarf der Scans festlegen (--good-um, --usable-um).
take-more-pictures-robot-at-fault = Weitere Bilder aufnehmen, nach allen Seiten geneigt; bei so großen Abweichungen liegt es an der Genauigkeit des Roboters, oder seine Posen beschreiben nicht den Flansch im Koordinatensystem des Messarms. Erreicht der Roboter nicht mehr, die Grenzwerte nach dem Bedarf der Scans festlegen (--good-um, --usable-um).
take-more-pictures-tilted = Weitere Bilder aufnehmen, nach allen Seiten geneigt.
take-more-poses-tilted-turned = Weitere Posen aufnehmen, geneigt und gedreht.
take-picture-of-target =
    { $thing ->
        [board] ein Bild der Tafel aufnehmen
       *[object] ein Bild des Objekts aufnehmen
    }
take-pictures-different-distances-tilted-different = Bilder aus verschiedenen Abständen aufnehmen oder nach verschiedenen Seiten geneigt
take-pictures-tilted-20-more-two = Bilder aufnehmen, die um 20° und mehr geneigt sind, nach zwei Seiten
take-pictures-turned-20-more-about = Bilder aufnehmen, die um 20° und mehr gedreht sind, um zwei verschiedene Achsen
take-poses-tilted-left-right-front = Posen aufnehmen, die nach links, rechts, vorn und hinten geneigt und um die Blickrichtung gedreht sind.
they-come-more-than-one-camera = sie stammen von mehr als einer Kamera oder wurden skaliert
they-do-not-lie-in-one-plane = sie liegen nicht in einer Ebene
tilt-back-by = { $angle } nach hinten neigen
tilt-front-by = { $angle } nach vorn neigen
tilt-left-by = { $angle } nach links neigen
tilt-right-by = { $angle } nach rechts neigen
touch-more-points-spread-wide-over = Weitere Punkte antasten, weit über die Tafel verteilt.
touch-opposite-faces-tilt-more = Gegenüberliegende Flächen antasten (links und rechts, vorn und hinten, Kronen und Böden) und den Sensor zwischen den Posen stärker neigen
touches-on-face = { $count } { $where }
turn-anticlockwise-by = { $angle } gegen den Uhrzeigersinn drehen
turn-clockwise-by = { $angle } im Uhrzeigersinn drehen
turn-sensor-so-laser-falls-onto = Sensor so drehen, dass der Laser von oben auf die Tafel fällt
two-lines-in-the-pictures-of-poses = in den Bildern der Posen { $poses } sind zwei Laserlinien
usable-edge-stripe-points-poses = { $found } brauchbare Kanten- und Laserpunkte in { $views } Posen
use-board-even-odd-count-inner = eine Tafel verwenden, deren Anzahl innerer Ecken in einer Richtung gerade und in der anderen ungerade ist
use-full-pictures-one-sensor = vollständige Bilder eines einzigen Sensors verwenden
where-sensor-sits-along-axis-cannot = die Lage des Sensors entlang dieser Achse lässt sich nicht bestimmen
working-out-uncertainty = Unsicherheit wird berechnet

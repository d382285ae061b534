another-unit-arm-or-marker = sie haben eine andere Einheit, stammen von einem anderen Arm, oder die Gelenkwinkel gehören zu anderen Posen
arm-and-frame-have-unknowns = Arm, Messmarken und Koordinatensysteme haben { $unknown } Unbekannte
arm-has-no-tip = der Messarm { $name } hat keine Tastkugel
arm-json-tip-goes-far-while = nach dieser arm.json wandert die Tastkugel weit, obwohl sie in einer Pfanne sitzt: { $far } von der Mitte der Pfanne { $name }
arm-json-tip-goes-fro = { $label }: Nach arm.json wandert die Tastkugel um { $distance } hin und her
arm-sees-bar-given = der Messarm misst Kugelstab { $bar } mit { $measured }, angegeben sind { $given }
arm-stays-shows-nothing-errors = ein unbewegter Messarm zeigt nichts von seinen Fehlern
arms-parameters-already-explain-points-well = die Parameter des Messarms erklären die Punkte bereits so gut, wie diese gemessen sind
bar-end-of-position = Kugelstab { $name } { $position }, Ende { $end }
bar-position-arm-json-ends-lie = Kugelstab { $name }, Lage { $position }: Nach arm.json liegen seine Enden { $measured } auseinander, angegeben sind { $length }
bars-length-hardly-known = Kugelstab { $bar }: seine Länge ist auf ± { $uncertainty } (k = 1) angegeben, was den Maßstab des Arms kaum bestimmt: prüfen, ob standard_uncertainty_mm in mm angegeben ist
bars-lengths-coordinates-scatter-without-them = mit den Längen der Kugelstäbe streuen die Koordinaten um { $scatter }, ohne sie um { $without }
bars-lengths-points-scatter-without-them = mit den Längen der Kugelstäbe streuen die Punkte um { $scatter }, ohne sie um { $without }
bring-joint-reference-switch-arm-off = Gelenk auf seine Referenz bringen und den Messarm aus- und wieder einschalten; tritt es weiter auf, das Datenblatt dieses Messarms wählen
change-theta-of-joint = theta_deg des Gelenks { $joint } in arm.json um { $turn } ändern (bei sign −1 um ebenso viel andersherum)
check-arm-json-against-arm-signs = arm.json mit dem Messarm vergleichen: Vorzeichen, Einheiten, Längen, Reihenfolge der Gelenke; auch die Punkte dieser Position prüfen
check-arm-software-and-network = prüfen Sie die Software des Arms und die Verbindung zu ihm
check-arms-cable-then-switch-arm = Kabel des Messarms prüfen, dann den Messarm aus- und wieder einschalten
check-diameter = { $finding }: Durchmesser prüfen
check-diameter-mm-spheres-take-sphere = diameter_mm der Kugeln prüfen; diese Kugel neu aufnehmen oder ihre Zeilen löschen
check-encoder-swing-arm-so-every = Winkelgeber prüfen; den Messarm so schwenken, dass sich jedes Gelenk dreht
check-encoders-arm-json-how-points = Winkelgeber, arm.json und die Aufnahme der Punkte prüfen
check-frame-and-tool-of-arm = prüfen Sie, ob Basis oder Werkzeug in der Software des Arms geändert wurde; wenn ja, stellen Sie zurück
check-joints-encoder-cable-then-bring = Winkelgeber und Kabel des Gelenks prüfen, dann den Messarm auf seine Referenz bringen
check-length-mm-bar-ends = length_mm des Kugelstabs { $bar } und seine Enden prüfen
check-length-of-bar-and-coordinates = Länge und Enden des Kugelstabs { $bar } sowie den Maßstab der Koordinaten prüfen
check-length-unless-datasheet-is-as-far-off = { $finding }: Länge prüfen, sofern nicht das Datenblatt des Messarms ebenso weit abweicht
check-order-and-signs-of-coordinates = Reihenfolge und Vorzeichen von x_mm, y_mm und z_mm prüfen: das Koordinatensystem muss rechtshändig sein
check-signs-lengths-joints-order = Vorzeichen, Längen und Reihenfolge der Gelenke in arm.json prüfen
check-unit-arm-and-rows = Einheit, Koordinatensystem und Gelenkwinkel der Zeilen prüfen, und ob es dieser Messarm ist
checking-places-held-out = Kreuzvalidierung der Positionen
clamp-seat-take-place-again-delete = Pfanne festspannen und diese Position neu aufnehmen oder ihre Zeilen löschen
coordinates-fit-otherwise = { $reason }, lägen sie typischerweise { $off } von der Stelle, an der sie laut arm.json sind
coordinates-give-figures = coordinates.csv: { $poses } Posen ergeben { $figures } Werte
coordinates-spread = coordinates.csv: Die Punkte im Koordinatensystem { $name } liegen typisch { $measured } von ihrer Mitte, laut arm.json aber { $expected }
correct-tips-diameter-arm-json-what = Durchmesser der Tastkugel in arm.json oder die Angaben der Tabellen berichtigen
datasheet-lets-turn = laut Datenblatt dreht es von { $low } bis { $high }
delete-what-stands-there-twice = Doppelte Einträge löschen
denavit-hartenberg-parameters-do-same = die Denavit-Hartenberg-Parameter haben dieselbe Wirkung
encoder-stands-still-switch-arm-off = sein Winkelgeber ändert sich nicht: Messarm aus- und wieder einschalten und das Kabel des Gelenks prüfen
even-best-arm-points-still-scatter = selbst mit dem besten Armmodell streuen die Punkte noch um { $scatter }
few-poses = { $poses } Posen ergeben { $figures } Werte für { $unknown } Unbekannte und prüfen sie kaum: { $wanted } Posen messen, über die ganze Reichweite verteilt
fit-does-not-converge = die Ausgleichung konvergiert nicht
fit-follows-these-points-arm = die Ausgleichung folgt diesen Punkten und nicht dem Messarm
fitting-arm = Armparameter werden ausgeglichen
frame-has-points = coordinates.csv: Koordinatensystem { $name } hat { $count } Punkte
frame-named = Koordinatensystem { $name }
give-each-row-angles-of-its-pose = Jeder Zeile die Gelenkwinkel ihrer eigenen Pose geben
give-each-seat-name-own = Jeder Pfanne einen eigenen Namen geben
give-length-mm-bar-millimetres-check = length_mm von Kugelstab { $name } in Millimetern angeben und seine Zeilen prüfen
give-pose-of-marker-in-frame = Die Pose der Messmarke im Koordinatensystem des Messgeräts angeben
give-rotation-of-marker-in-frame = Die Drehung der Messmarke im Koordinatensystem des Messgeräts angeben: qx, qy, qz, qw mit dem Skalarteil zuletzt, oder rx_deg, ry_deg, rz_deg
give-seat-own-name-check-arm-json = Jeder Pfanne einen eigenen Namen geben; arm.json prüfen
has-points = { $label } hat { $count } Punkte
if-angles-of-next-row =
    { $row ->
        [before] wenn jede Zeile die Gelenkwinkel der vorherigen Zeile hätte
       *[after] wenn jede Zeile die Gelenkwinkel der nächsten Zeile hätte
    }
if-coordinates-in-unit =
    { $unit ->
        [inches] wenn sie in Zoll angegeben wären
       *[centimetres] wenn sie in Zentimetern angegeben wären
    }
if-coordinates-mirrored = wenn die Koordinaten gespiegelt wären
if-frame-is-not-base = wenn ihr Koordinatensystem das des Messgeräts und nicht die Basis wäre
if-instrument-moved = wenn das Messgerät oder die Basis des Arms vor Zeile { $line } bewegt worden wäre
if-joint-turned-other-way = wenn sich das Gelenk { $joint } andersherum drehte
if-joint-zero-elsewhere = wenn das Gelenk { $joint } { $turn } mehr anzeigte
if-poses-inverted = wenn dies die Posen des Messgeräts im Koordinatensystem der Messmarke wären
instrument-moved-or-angles-of-other-pose = das Messgerät wurde bewegt, hat die Messmarke verloren, oder die Gelenkwinkel gehören zu anderen Posen
instrument-or-base-moved = das Messgerät oder die Basis des Arms wurde bewegt, oder die Punkte stammen aus zwei Aufstellungen
joint-angle-not-a-number = { $name }: Ein Gelenkwinkel ist keine Zahl
joint-angles = { $name }: { $count } Gelenkwinkel
joint-jumped-stayed-there = Gelenk { $joint } ist um { $step } gesprungen und dort geblieben
joint-reads = Gelenk { $joint } meldet { $reading }
joint-reads-again-again = Gelenk { $joint } meldet immer wieder { $reading }
joint-reads-no-number = Gelenk { $joint } meldet keine Zahl
joint-reads-off-readings-before-after = Gelenk { $joint } meldet { $reading }, { $step } neben den Messwerten davor und danach
joint-reads-same-all-points = Gelenk { $joint } meldet in allen Punkten denselben Wert
joint-reads-where-can = Gelenk { $joint } meldet { $reading }, { $step } außerhalb seines Bereichs
keep-arm-json-use = Bisherige arm.json weiterverwenden
least-needed-tell-arms-errors-own = mindestens { $least } sind nötig, um die Fehler des Messarms vom Mittelpunkt der Position zu trennen
least-needed-to-know-frame = mindestens { $least } sind nötig, damit die Aufstellung des Messgeräts bekannt ist
least-seats-spheres-bar-positions-needed = mindestens { $least_places } Pfannen, Kugeln und Stablagen sind nötig, damit einige für die Kreuzvalidierung bleiben
length-another-bar-another-unit-ends = die Länge gehört zu einem anderen Kugelstab oder hat eine andere Einheit, oder die Enden gehören nicht zu diesem Kugelstab
lengths-of-bars-contradict = die Längen der Kugelstäbe { $bars } widersprechen sich um { $off }; welche davon falsch ist, steht nicht fest
many-points-have-very-same-angles = viele Punkte haben exakt dieselben Winkel
markers-lie-far = coordinates.csv: Im Koordinatensystem { $name } liegen die Punkte typisch { $off } von der Stelle, an der sie laut arm.json sind
markers-place-is-estimated-instead = stattdessen wird der Ort des Markers am Flansch geschätzt
measure-again-or-delete-rows = Erneut messen oder die Zeilen löschen
measure-more-poses = Mindestens { $least } Posen messen, besser { $wanted }, über die ganze Reichweite verteilt
measure-more-there-or-delete-rows = Dort mehr Punkte messen oder die Zeilen löschen
measured-points-not-tip = coordinates.csv: Die gemessenen Punkte liegen { $far } neben der Tastkugel
move-joint-to-reference-within-sentence = Gelenk auf seine Referenz bringen und den Messarm aus- und wieder einschalten
moves-check-arm-json =
    { $beside ->
        [bars] { $name } ändert sich um { $change }: arm.json und die Längen der Kugelstäbe prüfen
        [marker] { $name } ändert sich um { $change }: arm.json und den Marker prüfen: seinen Namen in der Spalte marker, wenn er nicht die Tastkugel ist, und seinen Ort, wenn er angegeben ist
       *[arm] { $name } ändert sich um { $change }: arm.json prüfen
    }
moving-only-moves-whole-arm-space = eine Änderung verschiebt nur den ganzen Messarm im Raum
name-folder-other-places-none-some = Einen Ordner mit anderen Positionen angeben oder keinen: Dann wird reihum ein Teil der Positionen ausgelassen
name-frame-of-each-set-up = Jeder Aufstellung in der Spalte frame einen eigenen Namen geben
name-frame-otherwise-than-base = Dem Koordinatensystem einen anderen Namen als base geben
name-marker-in-column = Die Messmarke in der Spalte marker benennen oder die Tastkugel in arm.json berichtigen
no-arm-moves-that-fast = so schnell bewegt sich kein Arm
no-arm-near-given-one-explains = kein Messarm nahe dem angegebenen erklärt die Punkte; die von { $label } streuen um { $rms } (rms)
no-ball-bar-measured-arms-size = es wurde kein Kugelstab gemessen: Der Maßstab des Messarms ist der seines Datenblatts; ein Fehler von { $error } im längsten Glied ergibt { $size } über die Reichweite
no-hand-no-knock-moves-joint = weder Hand noch Stoß bewegt ein Gelenk in so kurzer Zeit so weit
no-joint-goes-there-back-between = kein Gelenk bewegt sich zwischen zwei Messwerten hin und zurück
no-joint-turned-more-than = { $label }: Kein Gelenk hat sich um mehr als { $swing } gedreht ({ $joint })
no-seated-tip-does-points-another = bei einer Tastkugel in einer Pfanne ist das nicht möglich: Punkte einer anderen Position sind darunter, oder die Datei gehört zu einem anderen Messarm
not-moved-or-encoder-not-read = es wurde nicht bewegt, oder sein Winkelgeber wird nicht gelesen
not-of-such-an-arm-or-tip-not-seated = sie stammen nicht von einem Messarm dieser Art, oder die Tastkugel saß nicht in der Pfanne
nothing-taken-such-reading = ein solcher Messwert wird nicht verwendet
one-diameter-wrong-or-sphere-not-clean = ein Durchmesser gehört nicht zu dieser Kugel, oder die Kugel war nicht sauber
one-of-touches-off = mindestens einer dieser Punkte liegt daneben, und die übrigen zeigen nicht, welcher: { $points }. Dort zwei weitere Punkte antasten
parameters-moved-do-same-together = die geänderten Parameter haben zusammen dieselbe Wirkung
places-held-out-agree-too-well = in der Kreuzvalidierung weichen die Positionen nur um das { $times }-Fache des angegebenen Rauschens ab: standard_uncertainty_mm ist zu groß oder in einer anderen Einheit
places-held-out-arms-errors-go = in der Kreuzvalidierung ändern sich die Fehler des Messarms vom { $before }-Fachen auf das { $after }-Fache ihres Rauschens
places-held-out-still-deviate = in der Kreuzvalidierung weichen die Positionen noch um das { $times }-Fache ihres Rauschens ab: weitere Positionen aufnehmen, gleichmäßiger über die Reichweite verteilt
point-at-place = { $place }, Punkt { $number }
points-1-lie-apart-while-single = { $label }: Die Punkte 1 bis { $split } und { $next } bis { $points } liegen { $gap } auseinander, während einzelne Punkte um { $sd } streuen
points-check-among-those-fit = { $shared } der { $count } Prüfpunkte gehören auch zu den Punkten der Ausgleichung
points-disagree-rest = { $label }: { $out } von { $points } Punkten widersprechen den übrigen
points-do-not-tell-better-than-tolerance = diese Punkte bestimmen ihn nicht genauer als die Fertigung
points-lie-in-another-frame = coordinates.csv: { $far } von { $points } Punkten im Koordinatensystem { $name }, von Zeile { $first } bis Zeile { $last }, passen zueinander, liegen aber { $off } neben den anderen
points-moved-from-line-on = coordinates.csv: im Koordinatensystem { $name } liegen die Punkte ab Zeile { $line } um { $off } neben denen davor, gemessen am besten Arm
points-of-frame-disagree = coordinates.csv: { $out } von { $points } Punkten im Koordinatensystem { $name } passen nicht zu den übrigen
points-places = { $points } Punkte an { $places } Positionen
points-scatter-less-than-stated = die Punkte streuen nur um einen kleinen Teil des Angegebenen: standard_uncertainty_mm ist zu groß oder in einer anderen Einheit
points-were-taken-another-arm-file = die Punkte wurden mit einem anderen Messarm aufgenommen, oder die Datei ist falsch
pose-jumped = der Arm meldet eine Pose, die { $step } und { $turn } von der vorigen abweicht
pose-jumped-and-stayed = die Pose des Arms sprang um { $step } und { $turn } und blieb dort
pose-no-number = der Arm meldet eine Pose, die keine Zahl ist
pose-no-rotation = der Arm meldet eine Pose, deren Quaternion nicht die Länge 1 hat
pose-repeats = der Messarm meldet immer wieder dieselbe Pose
poses-equal-to-last-digit = seine Posen zeigten immer Rauschen und sind jetzt bis auf die letzte Stelle gleich: er sendet eine alte Pose
readings-equal-as-never-of-encoder = mindestens { $equal_frozen } Messwerte nacheinander sind bis auf die letzte Stelle gleich; das kommt bei einem intakten Winkelgeber nie vor
reverse-sign-of-joint = Das Vorzeichen (sign) des Gelenks { $joint } in arm.json umkehren
rotations-differ = coordinates.csv: Die gemessenen Drehungen weichen typisch um { $angle } von denen des Arms ab
rotations-other-order-or-direction = sie haben eine andere Reihenfolge oder Richtung oder gehören zu anderen Posen
rows-copied-or-arm-not-moved = Zeilen wurden kopiert, oder der Messarm wurde nicht bewegt: Derselbe Punkt bringt zweimal nichts Neues
seat-moved-between = die Pfanne hat sich zwischendurch bewegt
seat-points-1-lie-apart = Pfanne { $name }: Die Punkte 1 bis { $split } und { $next } bis { $points } liegen { $gap } auseinander
seen-than-against-diameters-given =
    { $sign ->
        [larger]
            { $label } erscheint gegenüber den angegebenen Durchmessern { $off } (± { $uncertainty }) größer als { $others ->
                [1] die andere
               *[other] die anderen
            }
       *[smaller]
            { $label } erscheint gegenüber den angegebenen Durchmessern { $off } (± { $uncertainty }) kleiner als { $others ->
                [1] die andere
               *[other] die anderen
            }
    }
spheres-seen-against-their-diameters-tips = die Kugeln weichen um { $excess } (± { $uncertainty }) von ihren Durchmessern ab, bei einer Tastkugel von { $diameter }
spheres-seen-than-stated-tips-diameter =
    { $sign ->
        [larger] die Kugeln erscheinen { $excess } größer als angegeben: Der Durchmesser der Tastkugel könnte { $diameter } betragen
       *[smaller] die Kugeln erscheinen { $excess } kleiner als angegeben: Der Durchmesser der Tastkugel könnte { $diameter } betragen
    }
spheres-size-by-certificate-or-datasheet =
    { $sign ->
        [larger] laut Datenblatt des Messarms haben die Kugeln ihre angegebene Größe, nach der Länge dieses Kugelstabs wären sie { $excess } größer
       *[smaller] laut Datenblatt des Messarms haben die Kugeln ihre angegebene Größe, nach der Länge dieses Kugelstabs wären sie { $excess } kleiner
    }
state-uncertainty-in-mm = standard_uncertainty_mm in mm angeben, k = 1
swing-elbow-one-side-other-while = Den Ellbogen von einer Seite zur anderen schwenken, während die Tastkugel in der Pfanne bleibt
take-more-places-all-over-arms = Weitere Positionen aufnehmen, über die ganze Reichweite des Messarms verteilt
take-more-places-all-over-reach = Weitere Positionen über die ganze Reichweite aufnehmen und den Messarm an jeder von Seite zu Seite schwenken
take-more-points-more-places = Weitere Punkte an weiteren Positionen aufnehmen
take-more-there-delete-rows = Dort weitere Punkte aufnehmen oder die Zeilen löschen
take-more-while-arm-swings = Weitere Punkte aufnehmen, während der Messarm schwenkt
take-place-again-delete-rows = Diese Position neu aufnehmen oder ihre Zeilen löschen
the-seat = die Pfanne
they-cannot-show-whether-arm-better = sie können nicht zeigen, ob der Messarm anderswo genauer ist
they-leave-nothing-over-check-parameters = damit bleibt kein Überschuss, um { $columns } Parameter zu prüfen
tip-itself-was-not-measured = die Tastkugel selbst wurde nicht gemessen
tip-not-seated-or-seat-loose = die Tastkugel saß nicht, die Pfanne war locker, oder Punkte einer anderen Position sind darunter
tip-rather-has = der Durchmesser der Tastkugel beträgt eher { $diameter }, oder die angegebenen Durchmesser gehören nicht zu diesen Kugeln
tip-rather-has-or-bar-wrong = der Durchmesser der Tastkugel beträgt eher { $diameter }, oder die angegebenen Durchmesser gehören nicht zu diesen Kugeln, oder die Länge eines Kugelstabs ist falsch
tips-coordinates-moved-instead = stattdessen werden die Koordinaten der Tastkugel geändert
too-few-places-were-touched = zu wenige Positionen wurden angetastet: { $count }
touch-more-sphere = Mehr von der Kugel antasten
two-reasons = { $first } und { $second }
two-seats-or-seat-carried = sie gehören zu zwei Pfannen, oder die Pfanne wurde zwischendurch versetzt
two-seats-or-seat-carried-or-arm = sie gehören zu zwei Pfannen, oder die Pfanne wurde zwischendurch versetzt, oder arm.json gehört nicht zu diesem Messarm: Auch in anderen Pfannen wandert die Tastkugel { $far }
without-ball-bar-arms-size-observable = ohne Kugelstab ist der Maßstab des Messarms nicht bestimmbar
without-marker-coordinates-are-tips = ohne die Spalte marker gelten Koordinaten für die Tastkugel

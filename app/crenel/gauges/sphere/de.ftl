articulation-scanned-otherwise = Aufstellung { $position }, Stellung { $number }: Die Kamera blickte { $off } neben der gewünschten Richtung (höchstens { $most }).
articulation-touched-otherwise = Aufstellung { $position }, Stellung { $number }: Der Taster wurde { $off } neben der gewünschten Richtung gehalten (höchstens { $most }).
articulations-nearly-same = die Stellungen { $first } und { $second } sind fast gleich, { $apart } auseinander; nötig sind mindestens { $least }
articulations-not-scanned = nur { $count } der { $needed } Stellungen wurden gescannt
articulations-too-alike = der Sensor sah die Kugel von zu ähnlichen Seiten
articulations-without-touches = in den Stellungen { $names } fehlen Antastungen
at-position = Position { $position }: { $text }
centres-of-articulations-or-none =
    { $title }: { $count ->
        [one] der Mittelpunkt von { $count } Stellung
       *[other] die Mittelpunkte von { $count } Stellungen
    } von oben (x, y) und von der Seite (x, z), { $factor }-fach vergrößert. Der Kreis ist die kleinste Kugel um sie mit dem Durchmesser { $diameter }: die Lageabweichung. { $others ->
        [yes] Offene Punkte: Mittelpunkte mit dem kalibrierten Durchmesser.
       *[no] { "" }
    }
implied-offset-caption =
    Im Koordinatensystem des Sensors liegt der Sensor in Wirklichkeit { $size } neben der Stelle, an der die Messkopfmatrix ihn hat; dünne Balken sind die zweifache Standardunsicherheit. { $significant ->
        [yes] Das ist mehr als Zufall: Den Sensor erneut kalibrieren.
       *[no] Das ist nicht mehr als Zufall.
    } Ohne diesen Fehler bliebe eine Lageabweichung von { $left }.
offset-not-separable = ein Fehler der Tastermatrix lässt sich nicht von der Lage der Kugel trennen
offset-not-significant = Die Lageabweichung bedeutet keinen Fehler der Tastermatrix: { $size } lassen sich nicht vom Zufall unterscheiden, { $left } blieben.
offset-worth-calibrating = Die Lageabweichung bedeutet, dass die Tastermatrix um { $size } falsch ist, oder der Maßstab des Sensors, was hier gleich aussieht; nach Berichtigung blieben { $left }. Neu zu kalibrieren würde helfen.
patches-not-covered = die Scans decken die Flecken { $patches } der Kugel nicht ab
performance-all-scanned = Alle fünf Stellungen sind gescannt.
performance-articulation =
    { $number ->
        [1] Von oben
        [2] Vom Arm weg geneigt
        [3] Nach rechts geneigt
        [4] Zum Arm hin geneigt
       *[other] Nach links geneigt
    }
performance-articulations-missing =
    { $missing ->
        [one] Eine Stellung ist noch nicht gescannt.
       *[other] { $missing } Stellungen sind noch nicht gescannt.
    }
performance-camera-off-articulation = Die Kamera blickt { $off } neben der gewünschten Richtung (höchstens { $most }).
performance-cause-arm = Die angetasteten Mittelpunkte liegen { $apart } auseinander, die Streuung der Antastungen erklärt { $usual }: Glieder oder Winkelgeber des Arms weichen je nach Haltung ab.
performance-cause-outliers = { $share } der Punkte der Scans liegen weit neben der Kugel: Reflexe oder Ausreißer des Sensors.
performance-cause-tip =
    { $way ->
        [large] Die angetastete Kugel ist { $size } zu groß: Der Taster ist größer als angegeben.
       *[small] Die angetastete Kugel ist { $size } zu klein: Der Taster ist abgenutzt oder kleiner als angegeben, oder die Kugel gibt beim Antasten nach.
    }
performance-do-end = Die Kugel noch fünfmal antasten: Das zeigt, ob sie sich bewegt hat.
performance-gate = Auswahlbereich: { $shell } um die kalibrierte Kugel, Einfallswinkel bis { $incidence }, bis { $cone } vom Pol; vor der Prüfung festgelegt.
performance-hold-sensor =
    { $number ->
        [1] Den Sensor über die Kugel halten, Blick senkrecht nach unten. Den Scan beginnen und die Laserlinie über die Kugel führen.
        [2] Den Sensor auf der vom Arm abgewandten Seite halten, etwa 45° geneigt. Den Scan beginnen und die Laserlinie über die Kugel führen.
        [3] Den Sensor vom Arm aus gesehen rechts halten, etwa 45° geneigt. Den Scan beginnen und die Laserlinie über die Kugel führen.
        [4] Den Sensor auf der Seite des Arms halten, etwa 45° geneigt. Den Scan beginnen und die Laserlinie über die Kugel führen.
       *[other] Den Sensor vom Arm aus gesehen links halten, etwa 45° geneigt. Den Scan beginnen und die Laserlinie über die Kugel führen.
    }
performance-measuring-scan = Der Scan der Stellung { $articulation } wird ausgewertet
performance-move-sphere = Die Kugel an ihre zweite Position in einem anderen Teil des Arbeitsraums setzen und befestigen. Dann oben antasten.
performance-no-filter = Alle Punkte im Auswahlbereich zählen; kein Filter wird angewendet.
performance-no-free-place = Diese Antastung liegt nicht nahe einer noch freien Stelle und wurde nicht übernommen
performance-one-position = Die Kugel wurde an einer Position gemessen; die Norm verlangt zwei.
performance-pass-slowly = Die Laserlinie langsam über die ganze Kugel führen, dann den Scan beenden.
performance-repeat-scan = Scan { $number } nochmals
performance-run = Position { $position }, Scan der Stellung { $articulation }
performance-scan-again = Diese Stellung nochmals scannen, langsam über die ganze Kugel
performance-scan-done = Stellung { $articulation } ist gescannt.
performance-scan-missing = Die Stellung, auf deren Seite sie liegen, nochmals scannen.
performance-scan-name = Leistungsprüfung, Stellung { $articulation }
performance-scan-shows = { $patches } von 25 Feldern, { $points } Punkte
performance-scan-too-small = Der Scan deckt nur { $count } der 25 Felder der Kugel ab
performance-scans-done = { $done } von { $of } Stellungen
performance-simulation-scans = Der simulierte Bediener scannt Stellung { $articulation }
performance-step-end = Nochmals antasten
performance-step-location = Lage durch Antasten
performance-step-pattern = 25 Antastungen
performance-step-scan = Fünf Scans
performance-stylus-off-articulation = Der Taster ist { $off } neben der gewünschten Richtung (höchstens { $most }).
performance-touch-location =
    { $number ->
        [1] Das Handgelenk über der Kugel halten, der Taster zeigt senkrecht nach unten. Oben und an vier Stellen ringsum antasten, ohne den Taster zu drehen.
        [2] Den Taster etwa 45° neigen, das Handgelenk auf der vom Arm abgewandten Seite. Die fünf markierten Stellen antasten, ohne den Taster zu drehen.
        [3] Den Taster etwa 45° neigen, das Handgelenk vom Arm aus gesehen rechts. Die fünf markierten Stellen antasten, ohne den Taster zu drehen.
        [4] Den Taster etwa 45° neigen, das Handgelenk auf der Seite des Arms. Die fünf markierten Stellen antasten, ohne den Taster zu drehen.
       *[other] Den Taster etwa 45° neigen, das Handgelenk vom Arm aus gesehen links. Die fünf markierten Stellen antasten, ohne den Taster zu drehen.
    }
performance-touch-pattern = Die markierten Stellen in beliebiger Reihenfolge antasten, das Handgelenk dabei frei drehen. Die nächste freie ist hervorgehoben.
performance-touch-place = Stelle { $number } der Zeichnung antasten
performance-touch-top-first = Die Kugel zuerst ganz oben antasten; daraus folgen die anderen Stellen. Von da an stehen Kugel und Grenzwerte fest.
performance-turn-towards-articulation = Das Handgelenk drehen, bis diese Meldung verschwindet; anders genommene Punkte werden im Ergebnis vermerkt
places-of-hemisphere =
    { $title }, vom Pol gesehen: { $count ->
        [one] { $count } Stelle
       *[other] { $count } Stellen
    } mit dem Abstand von der Ausgleichskugel in µm, blau innen, orange außen, höchstens { $largest }. Die Kreise liegen 22,5°, 45°, 67,5° und 90° vom Pol.
scan-covers-patches = der Scan { $name } deckt nur { $count } Flecken der Kugel ab
scan-sphere-from-other-sides = scannen Sie sie von Seiten, die sich um 45° oder mehr unterscheiden
scanned-centres-of-position = Durch Scannen, Position { $position }
scanned-places-of-position = Gescannte Kugel, Position { $position }
sphere-not-touched-again = die Kugel wurde am Ende nicht noch einmal angetastet, sodass nicht bekannt ist, ob sie oder der Arm sich bewegt hat
sphere-or-arm-moved = Kugel oder Arm haben sich während der Prüfung um { $moved } bewegt; die Grenze ist { $limit }
sphere-was-not-scanned = die Kugel wurde nicht gescannt
touched-centres-of-position = Durch Antasten, Position { $position }
touched-places-of-position = Angetastete Kugel, Position { $position }
touches-miss-places = keine Antastung liegt nahe den Stellen { $places } der Kugel
touches-missing-of-pattern = nur { $count } der { $needed } Antastungen wurden genommen
value-with-spread = { $value } { $spread }

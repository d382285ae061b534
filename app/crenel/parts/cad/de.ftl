mesh-contains-triangles-of = { $path } enthält { $found } von { $announced } Dreiecken
mesh-export-again = Das Werkstück noch einmal exportieren, als binäres STL
mesh-format-unknown = sie enthält kein Werkstück in einem bekannten Format
mesh-give-known-format = Eine Datei .stl, .step oder .stp angeben
mesh-header-is-not-complete = der Dateikopf ist nicht vollständig
mesh-line-decimal-commas = die Zahlen in Zeile { $line } haben Dezimalkommas ({ $text })
mesh-line-not-three-numbers = in Zeile { $line } stehen keine drei Zahlen ({ $text })
mesh-of-too-many-triangles = sie hat mehr als { $most } Dreiecke
mesh-state-unit = Die Einheit der Zahlen angeben (mm, cm, m oder inch) oder in Millimetern exportieren
mesh-text-ends-early = sie endet in Zeile { $line } innerhalb eines Dreiecks oder ohne endsolid
mesh-without-triangles = sie hat kein Dreieck mit einer Fläche
part-bodies-there = { $count ->
        [one] sie hat einen Körper
       *[other] sie hat { $count } Körper
    }
part-edges-of-many-triangles = { $count ->
        [one] Eine Kante gehört zu mehr als zwei Dreiecken.
       *[other] { $count } Kanten gehören zu mehr als zwei Dreiecken.
    }
part-has-bodies = Die Datei hat { $count } Körper, die zusammen genommen werden; mit --body einen wählen.
part-has-no-such-body = { $path } hat keinen Körper { $body }
part-normals-inward-turned = Alle Dreiecke zeigten nach innen, wie das eingeschlossene Volumen zeigt; sie sind umgedreht.
part-size = { $x } × { $y } × { $z }
part-surface-one-sided = Die Oberfläche hat nur eine Seite wie ein Möbiusband: Vorzeichen von Abweichungen sagen dort nichts.
part-surface-open = Die Oberfläche ist offen: { $count ->
        [one] eine Kante gehört
       *[other] { $count } Kanten gehören
    } nur zu einem Dreieck, die längsten bei { $places }.
part-triangles-not-numbers = { $count ->
        [one] Ein Dreieck hat eine Ecke, die keine Zahl ist, und wird weggelassen.
       *[other] { $count } Dreiecke haben Ecken, die keine Zahlen sind, und werden weggelassen.
    }
part-triangles-turned = { $count ->
        [one] Ein Dreieck zeigte anders herum als die benachbarten und ist umgedreht.
       *[other] { $count } Dreiecke zeigten anders herum als die benachbarten und sind umgedreht.
    }
part-triangles-without-area = { $count ->
        [one] Ein Dreieck hat keine Fläche und wird weggelassen.
       *[other] { $count } Dreiecke haben keine Fläche und werden weggelassen.
    }
part-without-unit = Die Datei nennt keine Einheit. In { $unit } ist das Werkstück { $size } groß; eine andere mit --unit angeben.
step-cannot-be-read = sie lässt sich nicht als STEP lesen, oder nicht in 2 GB Speicher
step-export-again = Das Werkstück noch einmal als STEP (AP214 oder AP242) oder als STL exportieren
step-install-package = Installieren mit: { $command }; oder das Werkstück als STL exportieren
step-package-missing = STEP-Dateien brauchen das Paket cadquery-ocp-novtk, das nicht installiert ist
step-takes-too-long = sie braucht länger als { $most }, um zu Dreiecken zu werden
step-without-surface = sie hat keine Oberfläche

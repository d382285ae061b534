part-alignment-without-covariance = Die Ausrichtung nennt keine Kovarianz: nichts wird entschieden.
part-cells-with-coarse-facets = { $count ->
        [one] Eine Zelle liegt
       *[other] { $count } Zellen liegen
    } auf Facetten, die bis zu { $worst } von der gekrümmten Fläche entfernt sind, für die sie stehen; zulässig ist { $most }, ein Fünftel der Toleranz. Dort wird nichts entschieden: das Werkstück feiner oder als STEP exportieren.
part-cloud-has-scatter-only = Eine Punktwolke sagt nicht, was Kalibrierung und Arm zu ihrer Unsicherheit beitragen: nur die Streuung ist bekannt, und nichts wird entschieden. Stattdessen die Aufnahme angeben.
part-deciding-cells = Unsicherheit und Entscheidung jeder Zelle werden berechnet
part-direction = ({ $x }, { $y }, { $z })
part-export-without-mirroring = Das Werkstück ungespiegelt exportieren oder das der anderen Seite angeben
part-facets-are-coarse = Die Facetten des Werkstücks sind bis zu { $worst } von der gekrümmten Fläche entfernt, für die sie stehen
part-facets-finer = Das Werkstück mit feineren Facetten oder als STEP exportieren
part-facets-permitted = zulässig ist ein Fünftel der Toleranz, { $most }
part-finding-where-it-lies = Lage des Werkstücks wird gesucht
part-fit-is-not-fixed = die gescannte Fläche legt das nicht fest
part-fit-leaves-free = Die Bestanpassung lässt frei: { $motions }
part-fits-mirror-image = Der Scan passt zum Spiegelbild des Werkstücks (im Mittel { $mirrored }), nicht zum Werkstück ({ $residual })
part-fits-not = Der Scan passt nicht zum Werkstück: die Hälfte der Punkte ist weiter als { $residual } entfernt, und { $share } liegen in der Nähe
part-fits-not-remedy = Die Einheit des Werkstücks prüfen, und ob es gespiegelt ist; oder eine Ausrichtung angeben
part-fits-not-share = Der Scan passt nicht zum Werkstück: { $share } der Punkte liegen in der Nähe
part-fits-not-why = ein anderes Werkstück, ein gespiegeltes oder eine andere Einheit
part-free-shift = eine Verschiebung längs { $axis }
part-free-turn = eine Drehung um { $axis } durch { $place }
part-give-unit-of-it = { $unit } als Einheit des Werkstücks angeben, oder den Scan dieses Werkstücks allein
part-is-of-size = Das Werkstück ist { $size } groß, der Scan misst { $scan } über alles
part-lock-or-scan-more = { $names } festhalten, oder weitere Flächen scannen
part-map-needs-part-and-scan = { $folder }: Eine Karte braucht einen Scan und die Sollgeometrie als eine von { $names }
part-of-other-unit = beide stimmten überein, wenn die Einheit des Werkstücks { $unit } wäre
part-put-part-or-leave-map = beides in den Ordner legen, oder --map weglassen
part-second-pose-fits = Eine zweite Lage passt etwa gleich gut ({ $second } neben { $first }): das Werkstück ist fast symmetrisch. Kommt es auf die Lage an, eine Ausrichtung angeben.

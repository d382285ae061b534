calibration-has-no-covariance = { $file } nennt nicht, wie genau Kamera und Anbau bekannt sind
calibration-has-no-laser-plane = diese Kalibrierung hat Kamera und Anbau, aber noch keine Laserebene
decision-rule-guard =
    Schutzabstand: das { $factor }-Fache der Standardunsicherheit. { $bearer ->
        [supplier] Der Lieferant trägt die Unsicherheit: Ein Wert, der näher am Grenzwert liegt als der Schutzabstand, ist nicht bestanden.
        [user] Der Anwender trägt die Unsicherheit: Ein Wert, der näher am Grenzwert liegt als der Schutzabstand, ist bestanden.
       *[prover] Wer etwas nachweisen muss, trägt die Unsicherheit: Ein Wert, der näher am Grenzwert liegt als der Schutzabstand, ist nicht entschieden.
    }
decision-rule-named =
    Entscheidungsregel: { $name ->
        [guarded-95] Annahme mit Schutzabstand für 95 %
        [expanded-k2] Annahme mit der erweiterten Unsicherheit (k = 2) als Schutzabstand
        [simple] einfache Annahme
       *[other] { $name }
    }, { $standard }:{ $edition }.
decision-rule-without-guard = Es gibt keinen Schutzabstand: Die Werte werden unmittelbar mit ihren Grenzwerten verglichen, die Unsicherheit wird nur angegeben, und beide Seiten tragen ihr Risiko.
distortion-not-invertible = die Verzeichnung lässt sich nicht im ganzen Bild umkehren
give-a-calibration-of-several-poses = Eine Kalibrierung angeben, die Crenel aus mehreren Posen erstellt hat
last-row-must-0-0-0 = die letzte Zeile von { $name } muss 0 0 0 1 lauten
links-one-for-each-parameter =
    { $count ->
        [one] links muss einen Wert haben, für den einen Parameter eines Glieds
       *[other] links muss { $count } Werte haben, einen für jeden Parameter eines Glieds
    }
matrix-is-no-rotation = { $name } enthält keine Drehung: R·Rᵀ weicht um { $difference } von 1 ab
normal-must-have-unit-length = normal muss die Länge 1 haben
projection-matrix-is-not-product = projection_matrix ist nicht matrix · [rotation | translation_mm]

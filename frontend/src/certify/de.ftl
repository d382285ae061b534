ui-add-a-table = Tabelle hinzufügen (CSV)
ui-as-a-check = { $label }, zur Kontrolle
ui-as-drawn = Laut Zeichnung
ui-as-measured = Gemessen
ui-block-depth = Tiefe, vorn bis hinten
ui-block-height = Höhe
ui-block-with-dimension = Der Block mit dem Maß, das eingegeben wird
ui-calliper = Messschieber
ui-certified-by = Bescheinigt durch
ui-certified-by-help = Wie es in Berichten steht, mit der Nummer des Kalibrierscheins, falls es eine gibt.
ui-certify-a-block = Block vermessen
ui-correct-what-is-said = Berichtigen, was neben der Zeichnung steht
ui-else-as-identified = Quadratisches Mittel über den Arbeitsraum; sonst wie identifiziert
ui-else-unknown = Seines Durchmessers, k = 1; sonst gilt der Durchmesser als unbekannt
ui-enter-readings-or-points = Messwerte eingeben oder eine Tabelle hinzufügen
ui-error-of-the-arm = Abweichung des Arms
ui-expanded-uncertainty-k-2 = U, k = 2
ui-faces-as-measured = Flächen entlang ihrer Achsen
ui-from-face-to-face = { $from } bis { $to }
ui-groove-n = Nut { $n }
ui-height-of-floors = Höhe der Böden
ui-leave-it-out = Weglassen
ui-measured-with = Gemessen mit
ui-merlon-n = Zinne { $n }
ui-merlons-n-to-m = Zinnen { $n } bis { $m }
ui-micrometer = Bügelmessschraube
ui-not-chosen = Nicht gewählt
ui-overall-length = Gesamtlänge
ui-points-alone = Nur Punkte
ui-points-of-file = Punkte: { $name }
ui-readings-of-file = Messwerte: { $name }
ui-resolution = Auflösung
ui-some-faces-are-not-reached = Einige Flächen sind noch nicht erreicht
ui-store-the-certificate = Kalibrierschein speichern
ui-table-is-not-utf-8 = { $name } ist kein UTF-8-Text: Tabelle als CSV speichern.
ui-table-is-too-large = { $name } ist größer als 200 kB: Punkte gleichmäßig über alle Flächen weglassen.
ui-tool-was-found = { $tool }: Nullpunktfehler oder Durchmesser { $value } ± { $known }, k = 2.
ui-uncertainty-counts-twice = Der Kalibrierschein des Messmittels sagt nicht, welchen Teil seiner Unsicherheit alle Messwerte gemeinsam haben: Sie zählt für jeden Messwert allein und für das Gemeinsame.
ui-uncertainty-of-instrument = Seine Unsicherheit, k = 2
ui-uncertainty-of-the-tip = Unsicherheit des Tasters
ui-what-certifying-is = Geben Sie ein, was an { $name } gemessen wurde. Die Flächen folgen nach kleinsten Quadraten; Messwerte, die sich widersprechen, werden genannt.
ui-what-tables-are = Punkte einer Koordinatenmessmaschine, Antastungen mit dem Taster des Arms (auch probing.csv einer Sitzung) oder Messwerte. Sie können hereingezogen werden.

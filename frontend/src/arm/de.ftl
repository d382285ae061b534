ui-after = Nachher
ui-after-lowercase = nachher
ui-arm-checks-max-min-2-worst = Armprüfungen: (max − min)/2 auf der schlechtesten Achse
ui-arm-identification = Identifikation des Messarms
ui-arm-identifications = Identifikationen des Messarms
ui-arm-swings-side-side-while-tip = Ein Messarm schwenkt hin und her, während seine Tastkugel in einer Pfanne bleibt
ui-artefact = Prüfkörper
ui-before-and-after = Vorher und nachher
ui-before-difference-identified-arm-after-standard = Vorher: Abweichung vom identifizierten Messarm. Nachher: Standardunsicherheit, k = 1. Beides rms.
ui-before-lowercase = vorher
ui-changed-parameters-arm-uncertainty-k-1 = Geänderte Parameter des Messarms, Unsicherheit k = 1
ui-checks-could-not-loaded-they-reload = Die Prüfungen konnten nicht geladen werden. Sie werden neu geladen, sobald die Station wieder da ist.
ui-checks-over-time = Prüfungen im zeitlichen Verlauf
ui-choose-the-arm = Messarm wählen
ui-coefficient = Koeffizient
ui-coordinates-of-a-tracker = Koordinaten eines Lasertrackers (coordinates.csv)
ui-coordinates-points-taken = Koordinaten eines Lasertrackers: { $points } Punkte übernommen
ui-correlated-well-determined-together-less-well = Korreliert: gemeinsam gut bestimmt, einzeln weniger gut
ui-cross-validated-places-left-out-fit = { $n ->
        [one] Kreuzvalidiert an { $n } Position, die nicht in die Ausgleichung eingeht: rms, einschließlich des Rauschens der Winkelgeber.
       *[other] Kreuzvalidiert an { $n } Positionen, die reihum nicht in die Ausgleichung eingehen: rms, einschließlich des Rauschens der Winkelgeber.
    }
ui-dashed-the-limit = Gestrichelt: der Grenzwert, ±{ $value }.
ui-diameter-error = Durchmesserabweichung
ui-diameter-from-the-certificate = Durchmesser laut Kalibrierschein
ui-distance-tips-centre-place = Abstand des Tastkugelmittelpunkts von seiner Soll-Lage
ui-every-arm-check-appears-over-time = Hier erscheint jede Armprüfung im zeitlichen Verlauf: (max − min)/2 der Tastkugel auf der schlechtesten Achse im Vergleich zu Ihrem Grenzwert.
ui-identification-appears-arms-deviation-datasheet-uncertainty = Hier erscheint jede Identifikation mit der Abweichung des Messarms von seinem Datenblatt, der erreichten Unsicherheit und dem Bericht.
ui-in-space = Räumlich
ui-in-space-largest-2s = Räumlich: größter, 2s
ui-largest-distance-from-mean = größter Abstand vom Mittelwert
ui-largest-distance-of-a-contact-point = Größter Abstand eines Antastpunkts
ui-last-points-order-capture-about-mean = Die letzten { $n } Punkte in der Reihenfolge der Aufnahme, relativ zu ihrem Mittelwert.
ui-length-from-the-certificate = Länge laut Kalibrierschein
ui-limit-diameter-error-scatter = Grenzwert für Durchmesserabweichung und Streuung
ui-limit-max-min-2-axis = Grenzwert für (max − min)/2 je Achse
ui-no-check-yet = Noch keine Prüfung
ui-no-limit-set = kein Grenzwert festgelegt
ui-no-tip-check-yet = Noch keine Tastkugelprüfung
ui-not-yet-identified-here = Hier noch nicht identifiziert
ui-parameter = Parameter
ui-parameters = Parameter
ui-places-far-apparent-motion-tip-max = Bisherige Positionen: scheinbare Bewegung der Tastkugel, (max − min)/2
ui-points-appear-arm-swings = Punkte erscheinen hier, während der Messarm schwenkt.
ui-points-appear-fifth-contact-point = Ab dem fünften Antastpunkt erscheinen hier Punkte.
ui-scale-from-the-datasheet = Maßstab laut Datenblatt
ui-seat = Pfanne
ui-seat-end-ball-bar-tip-stays = In einer Pfanne oder am Ende eines Kugelstabs bleibt die Tastkugel an ihrer Stelle, während der Messarm schwenkt; eine Kugel wird von allen Seiten angetastet. Die Positionen über die ganze Reichweite verteilen: nah und fern, links und rechts, hoch und tief. Dann mit dem Ellbogen auf der anderen Seite wiederholen. Ein Kugelstab bestimmt auch den Maßstab des Messarms.
ui-six-places-determine-the-arms-geometry = Sechs Positionen bestimmen die Geometrie des Messarms
ui-standard-uncertainty-of-the-length = Standardunsicherheit der Länge
ui-the-tip-along-points = Die Tastkugel entlang { $axis }, { $n } Punkte
ui-tip-checks = Tastkugelprüfungen
ui-tip-error-over-the-reach-rms = Abweichung der Tastkugel über die Reichweite, rms
ui-tip-error-over-the-whole-reach = Abweichung der Tastkugel über die ganze Reichweite
ui-tip-error-over-whole-reach-without = Abweichung der Tastkugel über die ganze Reichweite, ohne den Maßstab des Messarms
ui-touch-sphere-known-diameter-nine-places = Eine Kugel mit bekanntem Durchmesser an neun Stellen mit gedrehtem Handgelenk antasten. So zeigt sich eine abgenutzte, verbogene oder falsche Tastkugel, bevor sie die Messungen eines Tages verdirbt.
ui-unchanged-parameters = Unveränderte Parameter

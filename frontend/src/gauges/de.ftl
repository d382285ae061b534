ui-add-a-certificate-dcc = Kalibrierschein (DCC) hinzufügen
ui-against-the-mean-of-all = gegenüber dem Mittelwert aller
ui-against-the-touched-gauge = gegenüber dem angetasteten Prüfnormal
ui-also-rebuild-with-the-newer-ones = Auch mit den neueren neu berechnen
ui-angle = Winkel
ui-angle-between-the-normals = Winkel zwischen den Normalen
ui-angle-lowercase = Winkel
ui-articulations = Stellungen
ui-band-is-permissible-error = das Band ist die zulässige Abweichung
ui-bars-test-value-uncertainty-dashed-limit-as-of-test = Balken: Unsicherheit des Prüfwerts, k = 2. Gestrichelt: der Grenzwert der jeweiligen Prüfung.
ui-being-measured = wird ausgewertet
ui-being-scanned = wird gescannt
ui-beyond-the-chart = außerhalb des Diagramms
ui-by-scan = Durch Scannen
ui-by-scan-takes-three-scans = Durch Scannen kommen in jeder Lage nach den Antastungen drei Scans des ganzen Stabs hinzu. Das steht mit der ersten Antastung fest.
ui-by-touch = Durch Antasten
ui-by-touch-and-by-scan = Durch Antasten und Scannen
ui-calibration-certificate-dcc = Digitaler Kalibrierschein
ui-calibration-good-check-gauge = Ist die Kalibrierung in Ordnung? Mit einem Prüfnormal prüfen
ui-cancel-the-test = Prüfung abbrechen
ui-cancelled = Abgebrochen
ui-cell-mean-points = jede Zelle von { $size } ist der Mittelwert ihrer Punkte
ui-centre-error = Mittelpunktabweichung
ui-centre-error-lowercase = Mittelpunktabweichung
ui-certificate-is-not-signed = Der Kalibrierschein (DCC) ist deutsch und englisch. Er ist nicht signiert und nicht gegen das Schema geprüft.
ui-certificate-is-not-utf-8 = { $name } ist kein UTF-8-Text: Den Kalibrierschein als XML wählen.
ui-clamp-gauge-within-arms-reach = Prüfnormal in Reichweite des Messarms aufspannen.
ui-cloud = Punktwolke
ui-cloud-n = Punktwolke { $n }
ui-clouds = Punktwolken
ui-clouds-and-calibrations = Punktwolken und Kalibrierungen
ui-compared-with-the-probe = mit dem Taster verglichen
ui-contact-about = Die Antastprüfungen nach ASME B89.4.22: wirksamer Durchmesser an einer Meisterkugel, drei Pfannen und ein Kugelstab in zwanzig Lagen. 217 Antastungen, von Hand etwa 40 Minuten.
ui-contact-needs = Eine kalibrierte Meisterkugel, eine Kegelpfanne, die sich an drei Stellen festklemmen lässt, und ein Kugelstab mit Kalibrierschein. Kugel oder Stab können entfallen.
ui-contact-points-from-above = Antastpunkte von oben
ui-contact-test = Antastprüfungen
ui-contact-test-title = Antastprüfungen
ui-continue-the-test = Prüfung fortsetzen
ui-continue-verification = Verifizierung fortsetzen
ui-country-of-the-laboratory = Land, zwei Buchstaben
ui-dashed = gestrichelt
ui-dashed-is-permissible-error = gestrichelt die zulässige Abweichung
ui-decision = Entscheidung
ui-decision-rule-changed-values-comparable = Die Entscheidungsregel hat sich zwischen diesen Prüfungen geändert; Werte, Unsicherheiten und Grenzwerte bleiben vergleichbar.
ui-deviations-from-the-fitted-shape = Abweichungen von der eingepassten Form
ui-distance = Abstand
ui-distance-between-the-centres = Abstand der Mittelpunkte
ui-errors-of-length = Längenabweichungen
ui-errors-of-length-by-scan = Längenabweichungen durch Scannen
ui-every-cloud-verification-rebuilt-accepted-calibrations = Jede Punktwolke dieser Verifizierung wird mit jeder der { $n } angenommenen Kalibrierungen neu berechnet. Unterschiede zwischen den Kalibrierungen stammen von den Kalibrierungen, Unterschiede zwischen den Punktwolken vom Messarm und vom Scannen. Die Berechnung läuft im Hintergrund.
ui-fail = Nicht bestanden
ui-figure = Kenngröße
ui-figure-over-clouds = 
    { $title }: { $of ->
        [mean] Mittelwert
        [range] Spannweite
       *[standard_deviation] Standardabweichung
    } der Punktwolken
ui-figures = Kenngrößen
ui-filters-used = Filter: Punkte, die weiter als { $sigmas } Standardabweichungen vom Ausgleich entfernt sind, und Bilder innerhalb von { $place } eines früheren werden nicht verwendet; für die Form aller Punkte werden sie verwendet.
ui-fitted-plane-outward-positive = von der eingepassten Ebene: Blau innen, Orange außen (positiv)
ui-fitted-sphere-outward-positive = von der eingepassten Kugel: Blau innen, Orange außen (positiv)
ui-for-information-without-a-limit = zur Information, ohne Grenzwert
ui-form-filtered = Form, gefiltert
ui-form-of-all = Form aller
ui-from-above-arm-below = Von oben, der Arm unten
ui-from-the-side-arm-left = Von der Seite, der Arm links
ui-gate-of-plane = Auswahl aller Punkte: die gescannte Fläche, bis { $gate } von der Ebene.
ui-gate-of-sphere = Auswahl aller Punkte: bis { $gate } von der kalibrierten Kugel und bis { $angle } von der Mitte des Scans.
ui-gauge = Prüfnormal
ui-how-lengths-are-measured = Wie die Längen gemessen werden
ui-implied-probe-matrix-error = Was die Stellungen über die Kalibrierung sagen
ui-in-gate = Ausgewählt
ui-include = Einbeziehen
ui-its-figures-are-left-out = Die zugehörigen Kenngrößen entfallen.
ui-judged-by = Beurteilt nach
ui-keep-stripe-gauge-move-slowly-points = Die Laserlinie auf dem Prüfnormal halten und langsam führen; die Punkte erscheinen beim Überfahren.
ui-kind-of-test = Art der Prüfung
ui-laboratory = Laboratorium
ui-latest-decided = Zuletzt: { $value } ({ $decision }).
ui-left-out-sentence = Ausgeschlossen:
ui-length-error-by-scan-of = Lage { $place }, Scan { $repeat }: { $error }
ui-length-error-of = Lage { $place }, Wiederholung { $repeat }: { $error }
ui-length-standard = Längennormal
ui-length-test = Längenprüfung
ui-lengths-and-scans-done-of = { $done } von { $of } Längen angetastet, { $scanned } von { $scans } Scans
ui-lengths-done-of = { $done } von { $of } Längen
ui-lengths-first-text = Die Längenprüfung nach ISO 10360 misst kalibrierte Längen in sieben Lagen im Arbeitsraum des Arms: 105 Längen, wenn das Normal fünf hat. Mit einem Stufenendmaß sind das 210 Antastungen, von Hand etwa eine halbe Stunde.
ui-lengths-largest-error =
    { $count ->
        [one] eine Länge
       *[other] { $count } Längen
    }, größte Abweichung { $value }
ui-lengths-need = Ein Kugelstab, Maßstab oder Stufenendmaß mit Kalibrierschein und ein fester Halt dafür in sieben Lagen. Sieben Lagen, fünf Längen, drei Wiederholungen durch Antasten, bei einem Kugelstab auch durch Scannen.
ui-limit-grows-with-length = A + L/K, höchstens B; K und B dürfen leer bleiben
ui-limits-by-the-datasheet = Grenzwerte nach Datenblatt (MPE)
ui-limits-fixed-at-first-touch = Eine Kenngröße ohne Grenzwert wird angegeben, aber nicht beurteilt. Die Grenzwerte stehen ab der ersten Antastung oder dem ersten Scan fest und bleiben für die nächste Prüfung erhalten.
ui-limits-judged-by-uncertainty-on-bar = Der Grenzwert wird nach der Unsicherheit beurteilt, die auf dem Balken gezeichnet und zuerst genannt ist. U der Prüfung: Prüfwertunsicherheit allein aus dem Normal und seinem Aufbau (ISO 14253-5), für die Leistung des Scanners. U der Messung: aus Normal, Taster und Streuung der Punkte, für den Ort des Normals; U der Prüfung ist ein Teil davon.
ui-loading-the-map = Karte wird geladen …
ui-map-appears-after-first-cloud = Die Karte erscheint hier nach der ersten Punktwolke.
ui-map-outliers = 
    { $points ->
        [0] Kein Punkt liegt weiter ab, als Rauschen erklärt.
        [one] { $points } Punkt liegt weiter ab, als Rauschen erklärt (Ring; drücken Sie ihn).
       *[other] { $points } Punkte liegen weiter ab, als Rauschen erklärt (Ringe; drücken Sie einen).
    } Die Spannweite aller Punkte, { $range }, liegt zwischen den dicken Ringen, { $low } und { $high }.
ui-master-sphere = Meisterkugel
ui-mean = Mittelwert { $value }
ui-measurements = Messungen
ui-no-calibration-use-yet-calibrate-first = Noch keine Kalibrierung in Verwendung. Zuerst kalibrieren.
ui-no-gauge-yet = Noch kein Prüfnormal
ui-no-length-standard-yet = Noch kein Längennormal
ui-no-length-yet = noch keine Länge
ui-no-limit = Kein Grenzwert
ui-off-best-fitting-gauge-outward-positive = { $end } Abweichung vom am besten passenden Prüfnormal: Blau innen, Orange außen (positiv)
ui-one-position = Eine
ui-one-sphere = Eine Kugel
ui-orientations = Ausrichtungen
ui-outlier-at = 
    { $deviation }{ $end ->
        [highest] { "" }, der höchste Punkt von allen
        [lowest] { "" }, der tiefste Punkt von allen
       *[none] { "" }
    }; { $points ->
        [0] kein Ausreißer
        [one] ein Ausreißer hier
       *[other] { $points } Ausreißer hier
    }; bei X, Y, Z = { $at } { $unit } des Arms; Bild { $frame }
ui-pass = Bestanden
ui-pass-becomes-map-clouds-deviations-gauge = Jede Überfahrt ergibt eine Karte der Abweichungen der Punktwolke vom Prüfnormal.
ui-patch-covered = abgedeckt
ui-patch-holds = { $points } Punkte aus { $frames } Bildern
ui-patch-open = noch nicht abgedeckt
ui-patch-partly = begonnen
ui-patches-missing = Es fehlen noch { $count } von 25 ({ $patches })
ui-patches-missing-many = Es fehlen noch { $count } von 25
ui-performance-first-text = Die Ein-Kugel-Prüfung nach ISO 10360 dauert von Hand etwa 25 Minuten: 55 Antastungen und fünf Scans einer kalibrierten Kugel.
ui-performance-first-title = Hält das Gerät sein Datenblatt ein?
ui-performance-needs = Eine kalibrierte Kugel von mindestens 10 mm auf festem Fuß, nicht die zum Kalibrieren verwendete.
ui-place-done = angetastet
ui-place-next = als Nächstes
ui-place-tip = Tastkugel
ui-placements = Lagen
ui-places = Lagen
ui-plane-about = Die Form einer gescannten Platte, eine Ergänzung zu den Normen: Die Platte wird zweimal gescannt, die Laserlinie dazwischen um 90° gedreht. Von Hand etwa fünf Minuten.
ui-plane-needs = Eine ebene Platte, mindestens 50 mm breit, mit Kalibrierschein ihrer Ebenheit, matt und fest aufgelegt.
ui-plane-test = Ebene
ui-plane-test-title = Ebenenprüfung
ui-plate-from-above = Die Platte von oben, mit den Streifen des Scans
ui-positions-of-the-sphere = Positionen der Kugel
ui-probe = Taster
ui-put-datasheet-plate-sphere-into-folder = Eine Platte oder Kugel unter Datenblätter eingeben, oder dort ihre Datei oder den digitalen Kalibrierschein (DCC) einer Kugel hinzufügen. Das Datenblatt enthält Nennmaß, Kalibrierschein und Grenzwerte. Das Prüfnormal erscheint sofort hier.
ui-put-length-standard-into-folder = Die Datei eines Kugelstabs, Maßstabs oder Stufenendmaßes unter Datenblätter hinzufügen; crenel certificate read macht sie aus einem Kalibrierschein. Sie erscheint hier sofort.
ui-radius-error = Radiusabweichung
ui-radius-error-lowercase = Radiusabweichung
ui-range-of-all = Spannweite aller
ui-range-over-the-calibrations = { $figure }: Spannweite über die Kalibrierungen
ui-range-over-the-clouds = { $figure }: Spannweite über die Punktwolken
ui-reason-device = Gerät ausgefallen
ui-reason-moved = Normal oder Messarm bewegt
ui-reason-operating = Bedienfehler
ui-reason-other = Anderer Grund
ui-rebuild-with-calibrations = { $n ->
        [one] Mit der Kalibrierung neu berechnen
       *[other] Mit { $n } Kalibrierungen neu berechnen
    }
ui-rebuilding-the-clouds = Punktwolken werden neu berechnet …
ui-record-of = Eintrag vom { $when }
ui-rule-guard =
    Schutzabstand: das { $factor }-Fache der Standardunsicherheit; { $bearer ->
        [supplier] der Lieferant trägt die Unsicherheit, daher ist ein Wert, der näher am Grenzwert liegt, nicht bestanden.
        [user] der Anwender trägt die Unsicherheit, daher ist ein Wert, der näher am Grenzwert liegt, bestanden.
       *[prover] wer etwas nachweisen muss, trägt die Unsicherheit, daher ist ein Wert, der näher am Grenzwert liegt, nicht entschieden.
    }
ui-rule-named =
    Entscheidungsregel: { $name ->
        [guarded-95] Annahme mit Schutzabstand für 95 %
        [expanded-k2] Annahme mit der erweiterten Unsicherheit (k = 2) als Schutzabstand
        [simple] einfache Annahme
       *[other] { $name }
    }, { $standard }:{ $edition }.
ui-rule-without-guard = Kein Schutzabstand: Die Werte werden unmittelbar mit ihren Grenzwerten verglichen, die Unsicherheit wird nur angegeben, und beide Seiten tragen ihr Risiko.
ui-save-the-certificate = Kalibrierschein speichern
ui-scan-accepted = angenommen
ui-scan-again = Nochmals scannen
ui-scan-gauge-plate-sphere = Eine Prüfplatte oder Prüfkugel einige Male scannen. Die Punktwolken werden mit dem Kalibrierschein des Prüfnormals verglichen, anhand Ihrer Grenzwerte und mit ihrer Unsicherheit. Das dauert zwei Minuten.
ui-scan-the-part = Teil scannen
ui-scans-of-the-bar-in-place = Scans des Stabs in Lage { $place }
ui-seats = Pfannen
ui-seen-from-above-arm-below = Von oben gesehen, unten steht der Arm
ui-since-moved-by = Seit { $date }: { $change }.
ui-sphere-from-above = Die Kugel von oben
ui-start-the-test = Prüfung beginnen
ui-start-verification = Verifizierung starten
ui-symbols-over-time-appear-after-second-test = Ab der zweiten Prüfung mit demselben Arm und derselben Art von Prüfkörper erscheint hier jedes Symbol im zeitlichen Verlauf.
ui-taken-after-few-more-they-drawn = { $n } aufgenommen. Nach einigen weiteren werden sie hier dargestellt.
ui-temperature-of-the-arm = Temperatur des Arms
ui-temperature-of-the-artefact = Temperatur des Prüfkörpers
ui-temperature-uncertainty = Unsicherheit der Temperatur (k = 2)
ui-temperatures = Temperaturen
ui-temperatures-at-the-end = Temperaturen am Ende
ui-temperatures-at-the-end-why = Eingetragen sind die Werte vom Anfang. Hat sich einer geändert, ihn eintragen und übernehmen.
ui-temperatures-why = Größen und Längen werden mit der Temperatur des Prüfkörpers auf 20 °C bezogen; ohne sie gelten sie als bei 20 °C gemessen. Nach beiden wird am Ende noch einmal gefragt.
ui-temperatures-why-of-a-plane = Die Form einer Ebene hängt nicht von ihnen ab. Sie zeigen, ob die Bedingungen beständig waren: Nach beiden wird am Ende noch einmal gefragt.
ui-test-sphere = Prüfkugel
ui-test-the-performance = Ein-Kugel-Prüfung
ui-the-certificate-was-not-added = der Kalibrierschein wurde nicht hinzugefügt
ui-the-map-could-not-be-loaded = Die Karte konnte nicht geladen werden.
ui-the-same-clouds-with-every-calibration = Dieselben Punktwolken mit jeder Kalibrierung
ui-the-sphere-can-be-chosen = Diese Kugel kann für die Prüfung gewählt werden.
ui-touch-dots-any-order = An den Punkten antasten, in beliebiger Reihenfolge.
ui-touch-gauge-plate-sphere-probe-then = Eine Prüfplatte oder Prüfkugel mit dem Taster antasten, dann einige Male scannen. Die Punktwolken werden mit dem Kalibrierschein des Prüfnormals und mit dem Taster verglichen, anhand Ihrer Grenzwerte und mit ihrer Unsicherheit. Das dauert zwei Minuten.
ui-two-positions = Zwei, wie die Norm verlangt
ui-u-from-parts = { $whole }: Wurzel der Quadrate von { $parts }
ui-u-k-2 = U (k = 2)
ui-u-measurement = U
ui-u-part = 
    { $source ->
        [gauge] Prüfnormal { $value }
        [probe] Taster { $value }
        [points] Punkte { $value }
       *[clouds] Punktwolken { $value }
    }
ui-u-test = U der Prüfung
ui-u-test-k-2 = U der Prüfung (k = 2)
ui-u-value =
    U{ $by ->
        [test] { " " }der Prüfung
        [measurement] { " " }der Messung
       *[other] { "" }
    } = { $value }, k = 2
ui-uncertain = Nicht entschieden
ui-uncertainty-budgets = Unsicherheitsbudgets (k = 2): U ist die Wurzel der Quadratsumme seiner Anteile
ui-unusable = unbrauchbar
ui-used = Verwendet
ui-verify-again = Erneut verifizieren
ui-verify-the-calibration = Kalibrierung verifizieren
ui-why-is-the-test-cancelled = Warum wird die Prüfung abgebrochen?
ui-without-a-ball-bar = Ohne Kugelstab
ui-without-a-sphere = Ohne Kugel
ui-z-error = Z-Abweichung
ui-z-error-in-the-clouds-middle = Z-Abweichung in der Mitte der Punktwolke

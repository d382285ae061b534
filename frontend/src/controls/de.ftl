ui-arm-sensor-detected-automatically-missing-device = Messarm und Sensor werden automatisch erkannt. Fehlt ein Gerät, wird der Grund angezeigt; es verbindet sich automatisch wieder.
ui-arms-main-button-continues-long-press = Mit der Haupttaste am Messarm geht es weiter; langes Drücken der Rücknahmetaste führt einen Schritt zurück.
ui-arms-main-button-starts-ends-cloud = Die Haupttaste am Messarm beginnt eine Punktwolke und schließt sie ab. Die Rücknahmetaste schließt die letzte aus; langes Drücken führt einen Schritt zurück.
ui-arms-main-button-takes-contact-point = Die Haupttaste am Messarm nimmt einen Antastpunkt auf. Die Rücknahmetaste entfernt ihn; langes Drücken führt einen Schritt zurück.
ui-arms-main-button-takes-long-press = Die Haupttaste am Messarm nimmt das Bild auf; langes Drücken der Rücknahmetaste führt einen Schritt zurück.
ui-arms-main-button-takes-point-undo = Die Haupttaste am Messarm nimmt einen Punkt auf. Die Rücknahmetaste entfernt ihn; langes Drücken führt einen Schritt zurück.
ui-arms-main-button-triggers-large-button = Die Haupttaste am Messarm löst die große Schaltfläche hier aus.
ui-attention = Achtung
ui-check-where-largest-residuals-pose-excluded = Prüfen, wo die größten Residuen liegen. Eine Pose lässt sich ausschließen und wieder einbeziehen.
ui-clamp-must-not-move-between-first = Prüfnormal aufspannen. Zwischen dem ersten Antastpunkt und der letzten Punktwolke darf es sich nicht bewegen.
ui-clamp-object-cannot-move-until-last = Objekt so aufspannen, dass es sich bis zum letzten Bild nicht bewegen kann.
ui-copied-in-mm-and-m = Kopiert, in mm und µm
ui-copy-as-csv = Als CSV kopieren
ui-days = { $n ->
        [one] { $n } Tag
       *[other] { $n } Tage
    }
ui-days-ago = { $n ->
        [one] vor { $n } Tag
       *[other] vor { $n } Tagen
    }
ui-findings = Befunde
ui-help = Hilfe
ui-hold-sensor-object-fills-picture-laser = Sensor so halten, dass das Objekt das Bild füllt und die Laserlinie darüber verläuft.
ui-hold-still-place-arms-main-button = An jeder Stelle ruhig halten; die Haupttaste am Messarm nimmt den Punkt auf.
ui-hours = { $n ->
        [one] { $n } Stunde
       *[other] { $n } Stunden
    }
ui-hours-ago = { $n ->
        [one] vor { $n } Stunde
       *[other] vor { $n } Stunden
    }
ui-k-1-about-two-three-points = k = 1: Etwa zwei von drei Punkten liegen darin. k = 2: etwa neunzehn von zwanzig.
ui-keep-elbow-and-wrist-as-they-are = Ellbogen und Handgelenk des Arms von den Punkten bis zu den Bildern so lassen: Fehler seiner Glieder heben sich dann auf
ui-leave-tip-seat-turn-every-joint = Die Tastkugel in der Pfanne lassen und jedes Gelenk langsam über seinen ganzen Bereich drehen. Punkte werden automatisch aufgenommen.
ui-move-slowly-evenly-green-range-distance = Langsam und gleichmäßig im grünen Bereich der Abstandsanzeige führen.
ui-no-continue = Nein, fortfahren
ui-nothing-takes-effect-before-you-accept = Nichts wird wirksam, bevor Sie es annehmen.
ui-part-help-frame = Drei nicht parallele Flächen legen das Teil fest. Wie genau das Koordinatensystem bekannt ist, erscheint, sobald sie angetastet sind.
ui-part-help-next = Nach den empfohlenen Antastungen gehört der nächste Druck zum nächsten Merkmal. „Nächstes Merkmal“ geht mit weniger weiter; ein Feld nimmt jedes Merkmal vor.
ui-part-help-review = Der Prüfordner hat alles: crenel inspect liefert aus ihm dasselbe Ergebnis.
ui-part-help-touch = Die Haupttaste des Arms übernimmt eine Antastung, die Rücknahmetaste nimmt die letzte zurück; gehalten geht sie einen Schritt zurück.
ui-part-help-u = U ist die erweiterte Unsicherheit, k = 2. Unentschieden: Die Grenze ist dafür zu nah.
ui-pass-over-place-again-fill-gaps = Lücken durch erneutes Überfahren füllen. Gescannte Daten werden sofort aufgezeichnet und gehen nicht verloren.
ui-pass-value-within-by-guard-band = Bestanden: Der Wert liegt um mehr als den Schutzabstand innerhalb des Grenzwerts. Nicht bestanden: Er überschreitet ihn um mehr als den Schutzabstand. Dazwischen gilt, was die Entscheidungsregel unter den Kennwerten sagt.
ui-performance-help-end = Haben sich Kugel oder Arm mehr bewegt, als die Unsicherheit zulässt, wird keine Kenngröße angegeben.
ui-performance-help-length = Die erste Antastung der nächsten Länge bestätigt die vorige. Danach steht sie fest.
ui-performance-help-limits = Die größten zulässigen Abweichungen (MPE) eintragen, die der Hersteller von Arm oder Scanner angibt.
ui-performance-help-location = Innerhalb einer Stellung behält der Taster seine Richtung; dazwischen Handgelenk und Ellbogen so weit wie möglich drehen.
ui-performance-help-patches = Ein Feld ist mit 20 Punkten aus zwei Bildern abgedeckt. In einem Scan sind mehrere Überfahrten möglich.
ui-performance-help-places = Eine Antastung zählt für die nächste freie Stelle innerhalb von 12°; jede andere wird abgelehnt.
ui-performance-help-review = Alle Punkte innerhalb der festgelegten Grenzen zählen; keiner wird wegen seiner Abweichung entfernt.
ui-performance-help-scan = Die Haupttaste des Arms beginnt und beendet einen Scan.
ui-performance-help-sphere = Die Datei der Kugel im Ordner gauges nennt Durchmesser, Form und ihre Unsicherheiten nach dem Kalibrierschein.
ui-performance-help-temperatures = Eine Änderung während der Prüfung vergrößert die Unsicherheit von Größen und Längen. Ist sie zu groß, wird kein Wert entschieden.
ui-performance-help-touch = Die Haupttaste des Arms nimmt eine Antastung auf, die Rücknahmetaste nimmt die letzte zurück.
ui-picture-taken-only-while-arm-still = Das Bild wird nur aufgenommen, während der Messarm in Ruhe ist. Nehmen Sie sich Zeit.
ui-poses-another-tilt-rotation-improve-result = Posen mit anderer Neigung oder Drehung verbessern das Ergebnis. Die wirksamste wird vorgeschlagen.
ui-report = Bericht
ui-seat-cone-three-balls-which-tip = Eine Pfanne ist ein Kegel oder besteht aus drei Kugeln; die Tastkugel sitzt darin und dreht sich ohne Spiel.
ui-select-datasheets-clamped-mounted-result-only = Die Datenblätter der aufgespannten und montierten Teile wählen. Das Ergebnis ist nur so genau wie sie.
ui-sensor-selected = Sensor
ui-show-pose = Pose { $n } anzeigen
ui-spread-points-over-face-away-edges = Die Punkte über jede Fläche verteilen, mit Abstand zu den Kanten. Einen Punkt in der Zeichnung antippen, um ihn anzusehen oder zu entfernen.
ui-stay-green-range-distance-indicator-if = Im grünen Bereich der Abstandsanzeige bleiben. Meldet sie „zu schnell“, langsamer führen: Die Linie ist unscharf.
ui-the-arms-main-button-begins = Mit der Haupttaste am Messarm beginnen.
ui-the-arms-main-button-ends-it = Mit der Haupttaste am Messarm abschließen.
ui-this-browser-does-not-allow-copying = Dieser Browser erlaubt das Kopieren nicht
ui-time-ago = vor { $time }
ui-use-gauge-certificate-size-form-uncertainty = Ein Prüfnormal mit Kalibrierschein verwenden: Maß, Form und Unsicherheit gehen in die Entscheidung ein.
ui-without-contact-points-only-form-size = Ohne Antastpunkte werden nur Form, Maß und Streuung beurteilt, nicht die Lage.
ui-wrong-tip-object-appears-residuals-later = Eine falsche Tastkugel oder ein falsches Objekt zeigt sich später in den Residuen und wird dann gemeldet.
ui-you-reload-page-switch-another-tablet = Sie können die Seite jederzeit neu laden oder zu einem anderen Tablet wechseln; es geht nichts verloren.

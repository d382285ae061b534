performance-measuring-plate-scan = Der Scan der Platte in Ausrichtung { $number } wird ausgewertet
performance-orientation =
    { $number ->
        [1] Laserlinie unter 45°
       *[other] Laserlinie um 90° gedreht
    }
performance-orientation-missing = Die Platte ist noch nicht in beiden Ausrichtungen gescannt.
performance-pass-over-plate = Die Laserlinie langsam in Streifen nebeneinander, die sich überlappen, über die Platte führen, dann den Scan beenden.
performance-plane-gate =
    { $count ->
        [one] Es zählen Punkte über der Platte, mindestens { $rim } innerhalb ihres Umrisses und höchstens { $shell } von ihrer Ebene; ein Punkt der Scans zählt nicht. Keiner wird wegen seines Residuums entfernt.
       *[other] Es zählen Punkte über der Platte, mindestens { $rim } innerhalb ihres Umrisses und höchstens { $shell } von ihrer Ebene; { $count } Punkte der Scans zählen nicht. Keiner wird wegen seines Residuums entfernt.
    }
performance-plane-is-addition = Die Form einer Ebene ist eine Ergänzung: Die Prüfung der Norm gilt für flächenhafte Sensoren.
performance-plate-form = Form { $form }
performance-plate-run = Platte, Ausrichtung { $number }
performance-plate-scan-done = Die Platte ist in Ausrichtung { $number } gescannt.
performance-plate-scan-name = Leistungsprüfung, Platte, Ausrichtung { $number }
performance-plate-scanned = Die Platte ist in beiden Ausrichtungen gescannt.
performance-plate-scans-done = { $done } von { $of } Ausrichtungen
performance-plate-width = { $width } breit
performance-scan-plate =
    { $number ->
        [1] Den Sensor so drehen, dass die Laserlinie etwa 45° zu den Kanten der Platte oder zu den Achsen des Arms liegt. Den Scan beginnen. Von da an stehen Platte und Grenzwert fest.
       *[other] Den Sensor um seine Blickrichtung drehen, bis die Laserlinie quer zu ihrer Richtung im ersten Scan liegt. Den Scan beginnen.
    }
performance-scan-plate-again = Diese Ausrichtung noch einmal scannen
performance-simulation-scans-plate = Der simulierte Bediener scannt die Platte in Ausrichtung { $number }
performance-step-plate = Zwei Scans
performance-turn-sensor = Den Sensor um seine Blickrichtung drehen und diese Ausrichtung noch einmal scannen
plate-not-in-enough-orientations = die Platte wurde nicht in { $count } Ausrichtungen gescannt
plate-orientations-alike = der Sensor wurde zwischen den beiden Ausrichtungen nur um { $turn } gedreht; nötig sind { $least }
plate-scan-too-few-points = der Scan hat nur { $count } Punkte; nötig sind { $least }
plate-scan-too-narrow = der Scan zeigt nur einen { $width } breiten Streifen der Platte; nötig sind { $least }
plate-was-not-scanned = die Platte wurde nicht gescannt
scan-plate-in-strips = Die Platte noch einmal scannen, in Streifen nebeneinander

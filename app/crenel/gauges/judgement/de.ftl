artefact-gives-way =
    { $test ->
        [sphere] die Kugel wackelt in Messung { $place }: Ihre Antastungen streuen um { $scatter }, ruhige um bis zu { $expected }
        [contact] der Stab wackelt in Lage { $place }, oder der Durchmesser seiner Kugeln ist falsch eingegeben: Die Antastungen seiner Kugeln streuen um { $scatter }, ruhige um bis zu { $expected }
       *[lengths] das Normal wackelt in Lage { $place }: Die Antastungen seiner Kugeln streuen um { $scatter }, ruhige um bis zu { $expected }
    }
performance-beyond-limit = { $title }: { $value }, jenseits der Grenze von { $limit }; Unsicherheit des Prüfwerts { $uncertainty } (k = 2).
performance-brought-to-20 = Größen und Längen sind auf 20 °C bezogen; der Prüfkörper hatte { $celsius }.
performance-conditions-not-met = { $title }: { $value }; nicht entschieden, denn { $problem }.
performance-expansion-unknown = der Prüfkörper { $name } hatte { $celsius }, mehr als { $most } von 20 °C entfernt, und sein Kalibrierschein enthält keinen Ausdehnungskoeffizienten: expansion_per_c und dessen Standardunsicherheit expansion_sd_per_c in der Datei des Prüfkörpers eintragen (dehnt er sich nicht aus: 0 und eine Unsicherheit über 0)
performance-extracted-by = Alle Punkte im Auswahlbereich zählen. Die Linie wurde in den Bildern der Scans mit diesen Einstellungen gesucht: { $names }.
performance-limit-unused = Der Plan enthält einen Grenzwert für „{ $title }“; dieser Test misst diese Größe nicht, der Grenzwert bleibt ungenutzt.
performance-limits-broken = Ein Wert hält seinen Grenzwert nicht ein.
performance-limits-kept = Jeder Wert, der einen Grenzwert hat, hält ihn ein.
performance-near-limit = { $title }: { $value }, für eine Entscheidung zu nahe an der Grenze von { $limit }; Unsicherheit des Prüfwerts { $uncertainty } (k = 2).
performance-no-limit-entered = Es ist kein Grenzwert eingetragen: Die Werte werden angegeben und nicht beurteilt.
performance-no-value = { $title }: kein Wert, denn { $problem }.
performance-not-brought-to-20 = Der Prüfkörper hatte { $celsius }. Sein Ausdehnungskoeffizient ist nicht angegeben: Größen und Längen sind nicht auf 20 °C bezogen.
performance-not-decided = Nicht jeder Wert ist entschieden.
performance-scans-set-otherwise = der Scan { $scan } wurde mit anderen Einstellungen aufgenommen als { $other }: Alle Scans einer Prüfung brauchen dieselben
performance-smoothed =
    Alle Punkte im Auswahlbereich zählen. Sie wurden bei der Aufnahme längs der Laserlinie um { $smoothing } geglättet, was Formabweichungen und Streuung kleiner macht.{ $others ->
        [none] { "" }
       *[other] { " " }Weitere Einstellungen: { $others }.
    }
performance-steadiness-unknown = Ob die Temperaturen beständig waren, ist nicht bekannt: Prüfkörper und Arm wurden nicht beide am Anfang und am Ende gemessen.
performance-temperature-changed =
    { $which ->
        [arm] die Temperatur des Arms änderte sich während der Prüfung um { $change }, um mehr als { $most }
       *[other] die Temperatur des Prüfkörpers änderte sich während der Prüfung um { $change }, um mehr als { $most }
    }
performance-temperature-far =
    { $which ->
        [arm] der Arm hatte { $celsius }, mehr als { $most } von 20 °C entfernt
       *[other] der Prüfkörper hatte { $celsius }, mehr als { $most } von 20 °C entfernt
    }
performance-temperature-not-stated = Die Temperatur des Prüfkörpers wurde nicht angegeben: Größen und Längen gelten als bei 20 °C gemessen, und ihre Unsicherheit enthält die Temperatur nicht.
performance-temperatures-steady = Die Temperaturen von Prüfkörper und Arm änderten sich um höchstens { $change } (Grenze { $most }) und blieben innerhalb von { $off } um 20 °C.
performance-within-limit = { $title }: { $value }, innerhalb der Grenze von { $limit }; Unsicherheit des Prüfwerts { $uncertainty } (k = 2).
scans-need-a-calibration = calibration.json fehlt: Scans lassen sich nicht rekonstruieren
seat-gives-way = Pfanne { $seat } ist lose: Der Taster streut darin um { $scatter }, in den anderen um höchstens { $expected }
sphere-gives-way =
    in Position { $position } gibt die Kugel oder der Taster beim Antasten nach, { $part ->
        [pattern] an den 25 Stellen
        [location] in den Stellungen
       *[end] am Ende
    }: Die Antastungen streuen um { $scatter }, die Punkte der Scans um { $expected }

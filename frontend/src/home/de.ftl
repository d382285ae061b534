ui-ambient-temperature = Raumtemperatur
ui-enter-it = Wert eingeben
ui-next = Weiter: { $what }
ui-recommended = Empfohlen
ui-the-temperature-was-not-saved = die Temperatur wurde nicht gespeichert
ui-valid = gültig
ui-validity = Gültigkeit
ui-way-to-the-first-calibration = Der Weg zur ersten Kalibrierung

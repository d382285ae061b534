arm-check-no-limit = { $half_range }, kein Grenzwert festgelegt.
arm-check-with-limit = { $half_range }, Grenzwert { $limit }.
backup-being-made-already = Es läuft bereits eine Sicherung
backup-is-in = Die Sicherung liegt in { $folder }.
calibrate-this-sensor = Diesen Sensor kalibrieren
calibration-cannot-read = Die Kalibrierung { $name } ist nicht lesbar.
calibration-in-use-unreadable = Die verwendete Kalibrierung ist nicht lesbar: { $error }
calibration-known-here = ihre Kalibrierung ist hier nicht bekannt
calibration-use-cannot-read = Die verwendete Kalibrierung ist nicht lesbar
change-them-in-file = ihre Tabellen [sensor.NAME] in { $file } ändern und die Station neu starten
demonstration = Die Vorführung
demonstration-accepts = Der simulierte Bediener nimmt diese Kalibrierung an. Ein Mensch sähe sich zuerst die Werte an.
demonstration-calibrates = Der simulierte Bediener kalibriert den Sensor: Antastpunkte, dann Bilder.
demonstration-not-calibrated = Die Vorführung ist ohne Kalibrierung zu Ende gegangen.
demonstration-scans = Der simulierte Bediener scannt die Teile auf dem Tisch.
demonstration-scans-soon = Der simulierte Bediener beginnt einen Scan. Der Laser geht an.
demonstration-stopped = Die Vorführung wurde angehalten. Alles bisher Getane bleibt: von Hand geht es weiter.
device-was-chosen = Die Station verwendet jetzt ein anderes Gerät: { $title }
devices-of-replay-are-fixed = Eine Wiedergabe hat die Geräte ihrer Aufzeichnung
journal-has-rows-cannot-read-first =
    { $count ->
        [one] Das Journal enthält { $count } nicht lesbare Zeile: Zeile { $first }.
       *[other] Das Journal enthält { $count } nicht lesbare Zeilen, die erste ist Zeile { $first }.
    }
no-backup-made = Es wurde keine Sicherung angelegt: { $error }
no-points-can-made = { $interrupted } Daraus lassen sich keine Punkte berechnen: { CLAUSE($why) }.
no-readable-figures = { $name } enthält keine lesbaren Kenngrößen
nothing-runs = Nichts läuft
performance-cannot-read = Der Eintrag der Leistungsprüfung { $one } ist nicht lesbar.
points-made = { $name }: { $points } Punkte berechnet.
points-made-again-while-no-scan = Die Punkte werden aus der Aufzeichnung berechnet, sobald kein Scan läuft.
points-made-when-there-room-no = { $interrupted } Die Punkte werden berechnet, sobald Speicherplatz frei ist und kein Scan läuft.
points-not-made-again = Die Punkte lassen sich nicht berechnen: { CLAUSE($why) }.
put-file-back-last-backup-restart = Datei aus der letzten Sicherung wiederherstellen und die Station neu starten oder neu kalibrieren
recording-kept = { $name }: Die Aufzeichnung ist erhalten.
sensor-calibrated = { $name }: { $calibration }, { $total } (k = 1)
sensor-cannot-be-selected-now = ein anderer Sensor lässt sich jetzt nicht auswählen
sensor-without-calibration = { $name }: noch nicht kalibriert
station-ended-during-scan = Die Station wurde während dieses Scans beendet.
station-has-several-sensors-not-changed-here = diese Station hat mehrere Sensoren, die hier nicht geändert werden
uncertainty-missing = { $file }: uncertainty fehlt
verification-cannot-read = Die Verifizierung { $one } ist nicht lesbar.
what-recorded-kept = { $interrupted } Alles Aufgezeichnete bleibt erhalten.
writing-scan = Scan wird geschrieben

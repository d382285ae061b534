begin-new-one = Eine neue beginnen
calibrate-first = Zuerst kalibrieren
hold-the-arm-still = Messarm ruhig halten.
no-calibration-use-yet = es wird noch keine Kalibrierung verwendet
no-touch-taken-back-since-last = Seit dem letzten Antastpunkt wurde keiner zurückgenommen.
performance-another-length-not-taken = Diese Antastung ergibt eine Länge von { $found } statt { $wanted }; sie wurde nicht übernommen
performance-no-arm = kein Datenblatt im Ordner arms gehört zum angeschlossenen Messarm, oder es nennt keine Tastkugel
performance-nothing-to-test = Es gibt nichts zu prüfen
performance-put-arm-json = Die arm.json des Messarms mit Seriennummer und Tastkugel in den Ordner arms legen
performance-scan-is-measured = Der letzte Scan wird noch ausgewertet.
performance-sphere-touch-not-taken = Die Kugel wurde dort schon angetastet; diese Antastung wurde nicht übernommen
performance-touch-ends-of-length = Das andere Ende der genannten Länge antasten
performance-touch-off-sphere = Diese Antastung liegt { $off } neben der Kugel, die vorher angetastet wurde; sie wurde nicht übernommen
performance-touch-same-sphere = Dieselbe Kugel antasten, oder ihre Antastungen zurücknehmen und neu beginnen
performance-touch-sphere-elsewhere = Die Antastungen über die Kugel verteilen
performance-touches-missing =
    { $missing ->
        [one] Eine Antastung fehlt.
       *[other] { $missing } Antastungen fehlen.
    }
sessions-arm-cannot-read = Die Armdatei der Sitzung ist nicht lesbar
touch-off-plane = Diese Antastung liegt { $off } neben der Ebene, die vorher angetastet wurde; sie wurde nicht übernommen
touch-same-plane = Dieselbe Fläche antasten, oder ihre Antastungen zurücknehmen und neu beginnen

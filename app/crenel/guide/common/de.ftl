abandoned = Sitzung abgebrochen
accepted-result = Ergebnis angenommen
arm-at-stop = Ein Gelenk des Arms ist am Anschlag.
arm-near-base = Der Arm ist dicht an seinem Fuß zusammengefaltet.
arm-session-under-way-go-where-stands = Eine Prüfung oder Identifikation des Arms läuft. Beim aktuellen Schritt fortfahren.
arm-stretched-out = Der Arm ist durchgestreckt.
began-again = neu begonnen
began-cloud = Punktwolke begonnen
began-seat = Position begonnen
calibrate-again = Neu kalibrieren
calibrate-sensor-arm-pictures-of-board = Sensor am Messarm kalibrieren: Bilder eines Schachbretts von verschiedenen Seiten aufnehmen.
calibrate-sensor-arm-touch-object-then = Sensor am Messarm kalibrieren: Objekt antasten, dann einige Bilder aufnehmen.
calibration-age-and-temperature = { $text }, { $ago } alt; Frist { $limit }, zulässiger Temperaturunterschied { $change } (jetzt { $now }).
calibration-due = Die Kalibrierung ist fällig. { $text }
calibration-not-verified-yet = Diese Kalibrierung ist noch nicht verifiziert.
calibration-under-way-go-where-stands = Eine Kalibrierung läuft. Beim aktuellen Schritt fortfahren.
calibration-valid-verified-scan-part = Die Kalibrierung ist gültig und verifiziert. Das Teil scannen.
cannot-read = Die Kalibrierung ist nicht lesbar: { $text }
certificate-set-aside = { $file }: { CLAUSE($why) }.
check-ago-failed = Prüfung nicht bestanden ({ $ago } her): { $text }
check-arm = Messarm prüfen
check-arm-again = Messarm erneut prüfen
check-first-page-arm-tip-takes = Zuerst auf der Seite „Messarm und Tastkugel“ prüfen; das dauert eine Minute.
check-tip = Tastkugel prüfen
check-tip-again = Tastkugel erneut prüfen
checked-ago = Geprüft ({ $ago } her): { $text }
checked-ago-after-check-due = Zuletzt geprüft: { $ago } her; Frist { $limit }. Eine Prüfung ist fällig.
chose-arm = Messarm gewählt
chose-artefact = Prüfkörper gewählt
chose-face = Fläche gewählt
chose-feature = hat ein Merkmal gewählt
chose-gauge = Prüfnormal gewählt
chose-program = hat ein Programm gewählt
chose-what-use = Ausrüstung gewählt
comes-after-calibration = Zuerst kalibrieren, dann verifizieren.
confirmed-devices = Geräte bestätigt
confirmed-gauge = Prüfnormal bestätigt
confirmed-object-picture = Objekt im Bild bestätigt
confirmed-touches = Antastpunkte bestätigt
confirmed-what-use = Ausrüstung bestätigt
datasheet-says-raw = laut { $path } liefert der Sensor Rohbilder (bayer)
driver-selects-raw-pixels = an einer Station wählt der Treiber die Pixel der Laserfarbe aus
dropped-cloud = Punktwolke verworfen
dropped-coordinates = hat Koordinaten eines Lasertrackers verworfen
dropped-seat = Position verworfen
dropped-swing = Punkte einer Position verworfen
duration-days =
    { $count ->
        [one] { $count } Tag
       *[other] { $count } Tage
    }
duration-hours =
    { $count ->
        [one] { $count } Stunde
       *[other] { $count } Stunden
    }
duration-minutes =
    { $count ->
        [one] { $count } Minute
       *[other] { $count } Minuten
    }
ended = Sitzung beendet
ended-pictures-by-themselves = beendete die Bilder von selbst
finished-cloud = Punktwolke abgeschlossen
finished-seat = Position abgeschlossen
go-calibrating = Kalibrierung fortsetzen
go-checking-arm = Mit dem Arm fortfahren
go-inspecting = Prüfung fortsetzen
go-testing = Leistungsprüfung fortsetzen
go-verifying = Verifizierung fortsetzen
had-begun-adding-the-laser = begonnen, den Laser hinzuzufügen
had-calculated = Berechnung gestartet
had-calculated-without-laser = Berechnung ohne den Laser gestartet
inspection-under-way-go-where-stands = Eine Prüfung ist im Gang. Setzen Sie sie fort, wo sie steht.
kept-picture = Bild behalten
last-verification-older-than-calibration = Die letzte Verifizierung ist älter als diese Kalibrierung.
less-than-minute = weniger als eine Minute
let-simulation-do = Simulierten Bediener starten
let-simulation-do-everything = Simulierten Bediener alles ausführen lassen
move-bayer-to-station-toml = bayer und laser_colour in [sensor] von station.toml setzen; bayer aus dem Datenblatt entfernen und width_px und height_px halbieren
move-sensor-over-part-yourself = Sensor selbst über das Teil führen
named-inspected-part = hat das zu prüfende Teil benannt
never-checked = Noch nie geprüft.
never-tested = Noch nie geprüft.
no-simulation-of-real-devices = Echte Geräte haben keinen simulierten Bediener
old-after-days-due = Sie ist { $ago } alt; Frist { $limit }. Sie ist fällig.
old-due-after-days = { $text }, { $ago } alt; Frist { $limit }.
passed-ago-due-after-days = Bestanden ({ $ago } her); Frist { $limit }.
performance-began-scan = hat einen Scan des Prüfkörpers begonnen
performance-chose-bar = hat den Kugelstab gewählt
performance-confirmed-artefact = hat den Prüfkörper bestätigt
performance-confirmed-step = hat einen Schritt bestätigt
performance-dropped-scan = hat einen Scan des Prüfkörpers verworfen
performance-finished-scan = hat einen Scan des Prüfkörpers beendet
performance-set-by-scan = hat Antasten oder Scannen gewählt
performance-set-positions = hat die Zahl der Positionen gewählt
performance-test-under-way-go-where-stands = Eine Leistungsprüfung läuft. Beim aktuellen Schritt fortfahren.
put-back-what-there-before = vorherigen Messarm wiederhergestellt
put-last-one-back = letzte Eingabe wiederhergestellt
removed-point = Punkt entfernt
request-invalid = Die Anfrage ist ungültig
saved-result = Ergebnis gespeichert
scan = Scannen
scan-under-way-go-where-stands = Ein Scan läuft. Weiter zum Stand des Scans.
send-support-bundle = Diagnosepaket senden
session-cannot-read-set-aside = Die Sitzung { $session_id } ist nicht lesbar und wird beiseitegelegt: { $error }.
session-not-readable-with-change = die Sitzung wäre damit nicht mehr lesbar
set-cloud-aside = Punktwolke ausgeschlossen
set-limit = Grenzwert festgelegt
set-pose-aside = Pose ausgeschlossen
set-temperature = Temperaturen von Prüfkörper und Arm eingegeben
set-what-line-is-like = legte fest, wie die Laserlinie aussieht
simulation-not-moving = Der simulierte Bediener bewegt sich nicht.
simulation-scanning = Der simulierte Bediener scannt
simulation-scans = Der simulierte Bediener scannt: { $part }
simulation-work = Der simulierte Bediener arbeitet
skipped-feature = hat ein Merkmal übersprungen
started-pictures-by-themselves = ließ Bilder von selbst aufnehmen
started-simulation = simulierten Bediener gestartet
stop-first = Zuerst stoppen
stop-simulation = Simulierten Bediener stoppen
stopped-simulation = simulierten Bediener gestoppt
test-performance = Leistung prüfen
test-performance-again = Erneut prüfen
than-when-made-beyond-c-due =
    { $how ->
        [warmer] Es ist { $difference } wärmer als bei der Kalibrierung; bei mehr als { $limit } Unterschied ist sie fällig.
       *[colder] Es ist { $difference } kälter als bei der Kalibrierung; bei mehr als { $limit } Unterschied ist sie fällig.
    }
there-no-command = Den Befehl „{ $name }“ gibt es nicht.
there-no-simulation-real-devices = Echte Geräte haben keinen simulierten Bediener.
tip-never-checked = Die Tastkugel wurde noch nie geprüft.
tip-says = Tastkugel: { $text }
title-performance-test = Leistungsprüfung
took-cloud-back = Punktwolke wieder einbezogen
took-coordinates = hat Koordinaten eines Lasertrackers übernommen
took-feature-again = hat ein Merkmal erneut angetastet
took-last-one-back = letzte Eingabe zurückgenommen
took-picture = Bild aufgenommen
took-picture-again = Bild neu aufgenommen
took-point = Punkt aufgenommen
took-pose-back = Pose wieder einbezogen
touch-in-another-posture = So genommene Punkte sind schlechter: Nehmen Sie eine andere Stellung, oder versetzen Sie das Objekt
touch-scan-gauge-takes-two-minutes = { $text } Ein Prüfnormal antasten und scannen: Das dauert zwei Minuten.
verification = Verifizierung
verification-failed-ago = Nicht bestanden ({ $ago } her). { $text }
verification-undecided-ago = Nicht entschieden ({ $ago } her). { $text }
verification-under-way-go-where-stands = Eine Verifizierung läuft. Beim aktuellen Schritt fortfahren.
verify = Verifizieren
verify-again = Erneut verifizieren
wait-because = Warten: { CLAUSE($text) }.
wait-check-what-taken-kept = Warten oder das Gerät prüfen. Alles Aufgenommene bleibt erhalten.
went-another-pose = zu einer weiteren Pose gewechselt
went-back-points = zu den Punkten zurückgekehrt
went-more-clouds = zu weiteren Punktwolken gewechselt
went-next-feature = ist zum nächsten Merkmal gegangen
went-result = zum Ergebnis gewechselt
went-step-back = einen Schritt zurückgegangen
went-without-probe = ohne Taster fortgefahren

bring-part-into-sensors-range-if = Das Teil in den Messbereich des Sensors bringen; liegt es darin, die Belichtung prüfen.
calibrate-first-within-sentence = zuerst kalibrieren
calibration-is-for-joints = die Kalibrierung gilt für einen Messarm mit { $joints } Gelenken
calibration-is-for-poses = die Kalibrierung gilt für einen Arm, der Posen meldet
calibration-is-for-serial-number = die Kalibrierung gilt für { $serial_number }
check-sensors-cable-close-other-programs = Kabel des Sensors prüfen oder andere Programme schließen.
computer-cannot-keep-up = Der Rechner kommt nicht nach: Seine Warteschlange ist zu { $share } voll
connect-arm-calibrate-one = den passenden Messarm anschließen oder mit diesem kalibrieren
connect-calibrate-one =
    { $device ->
        [arm] den passenden Messarm anschließen oder mit diesem kalibrieren
       *[sensor] den passenden Sensor anschließen oder mit diesem kalibrieren
    }
connected-arm-has-joints = der angeschlossene Messarm hat { $joints } Gelenke
connected-arm-reports-poses = der angeschlossene Arm meldet Posen
connected-has-serial-number =
    { $device ->
        [arm] der angeschlossene Messarm hat die Seriennummer { $serial_number }
       *[sensor] der angeschlossene Sensor hat die Seriennummer { $serial_number }
    }
disk-full-during-scan = Der Datenträger war während dieses Scans voll.
every-stripe-pictures-wait-them = Alle Laserlinien sind aufgezeichnet; sie haben Vorrang vor Bildern.
frames-lost-when-full-scan-more = Ist sie voll, gehen Bilder verloren; langsamer scannen oder andere Programme schließen.
go-over-these-places-again-slower = Diese Stellen noch einmal langsamer überfahren.
go-slower-shorten-exposure = Langsamer führen oder kürzer belichten.
line-stands-still = Die Linie steht still: Nach ihren ersten { $most } Bildern ergibt sie keine Punkte; Bilder ohne Punkte bisher: { $count }
move-sensor-or-stop-scan = Den Sensor über das Teil bewegen oder den Scan stoppen.
no-free-name-scan = kein freier Name für einen Scan in { $folder }
no-laser-line-visible = Keine Linie zu sehen
nothing-made-them = Sie wurden nicht verwendet. { CAPITAL(CLAUSE($remedy)) }.
only-free-disk = nur { $free } sind auf dem Datenträger von { $folder } frei
pictures-came-without-arms-position = { $count } von { $total } Bildern kamen ohne Stellung des Messarms
pictures-left-out = Bilder werden übersprungen: { $what }
pictures-recording-were-left-out = Die Aufzeichnung enthält { $kept } Bilder, { $left_out } wurden übersprungen
pictures-were-lost = { $count } von { $total } Bildern gingen verloren
pictures-were-taken-too-fast-up = { $count } von { $total } Bildern wurden in zu schneller Bewegung aufgenommen: bis { $worst } Unschärfe
points-saved =
    { $count ->
        [one] { $name }: { $count } Punkt gespeichert
       *[other] { $name }: { $count } Punkte gespeichert
    }
readings-arm-could-true-last =
    { $count ->
        [one] { $count } Messwert des Messarms war unplausibel: { $what }
       *[other] { $count } Messwerte des Messarms waren unplausibel; der letzte: { $what }
    }
recorded-data-kept = Alles Aufgezeichnete bleibt erhalten.
recording-keeps-still-lines = Die Aufzeichnung enthält sie alle.
recording-stopped = die Aufzeichnung wurde abgebrochen
scan-cut-short = Dieser Scan wurde vorzeitig beendet: { CLAUSE($reason) }.
scan-gap-again = Noch einmal scannen, was inzwischen überfahren wurde; den Rechner nicht einschlafen lassen.
scan-goes-when-back = Der Scan läuft weiter, sobald das Gerät wieder verbunden ist.
scan-incomplete-again = Der Rest des Teils fehlt in der Punktwolke: Ursache beheben und erneut scannen.
scan-needs = ein Scan benötigt { $needed }
scan-started-at = Scan { $started }
scan-stopped = Der Scan wurde abgebrochen: { $error }
scan-stopped-within-sentence = der Scan wurde abgebrochen
scan-was-suspended-nothing-recorded = Das Programm war während dieses Scans { $duration } lang angehalten und hat in dieser Zeit nichts aufgezeichnet.
sends-nothing =
    { $device ->
        [arm] der Messarm sendet nichts
       *[sensor] der Sensor sendet nichts
    }
sensor-now-sends-pictures-pixels = der Sensor sendet jetzt Bilder mit { $size } Pixeln
sensors-image-has-pixels = das Bild des Sensors hat { $width } × { $height } Pixel
sensors-line-lists-differ = die Punkte der Linie des Sensors sind unvollständig
set-sensor-back-calibrate-again = Einstellungen des Sensors wiederherstellen oder neu kalibrieren
set-sensor-back-scan-again = Einstellungen des Sensors wiederherstellen und erneut scannen
start-again-within-sentence = erneut starten
stop-before-next = vor dem nächsten stoppen
switch-stop-scan = Laser einschalten oder den Scan stoppen.
the-laser-is-off = Der Laser ist aus
there-no-valid-calibration = es gibt keine gültige Kalibrierung
they-recording-but-gave-no-points = Sie sind in der Aufzeichnung, ergaben aber keine Punkte; Kabel des Messarms prüfen.
too-fast-blur-limit = Zu schnell: { $blur } Unschärfe; der Grenzwert ist { $limit }
wait-until-does = warten, bis das Gerät sendet
without-one-pixels-cannot-become-points = ohne Kalibrierung lassen sich aus Pixeln keine Punkte berechnen

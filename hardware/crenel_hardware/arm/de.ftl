another-arm-answers = Unter { $url } antwortet ein anderer Messarm: { $name } { $serial_number } ({ $joints } Gelenke) statt { $expected_name } { $expected_serial_number }
arm-announced-joints-sends-poses = Der Messarm unter { $url } hat Gelenkwinkel angekündigt, sendet aber Posen
arm-closed-while-opening = Der Messarm unter { $url } wurde beim Öffnen geschlossen
arm-counts-pulses-from-start-again = Der Messarm unter { $url } ist neu gestartet, während die Kamera seine Auslöseimpulse zählte
arm-does-not-answer-pulse-request = Der Messarm unter { $url } hat Auslöseimpulse, antwortet aber nicht auf die Aufforderung, sie zu starten oder anzuhalten
arm-has-joints-station-toml-asks = Der Messarm unter { $url } ({ $name } { $serial_number }) hat { $joints } Gelenke, station.toml verlangt joint_count = { $joint_count }
arm-has-no-trigger-pulses = Der Messarm unter { $url } hat keinen Ausgang für Auslöseimpulse
arm-not-open = Der Messarm unter { $url } ist nicht geöffnet
arm-poses-other-setting = Die Posen des Messarms unter { $url } gelten für die Einstellung { $setting } von Werkzeug und Koordinatensystem statt für { $expected }
arm-refuses-pulse-rate = Der Messarm unter { $url } kann nicht mit { $rate } auslösen
arm-reports-joints =
    Der Messarm unter { $url } meldet { $joints ->
        [one] { $joints } Gelenk
       *[other] { $joints } Gelenke
    }
arm-reports-no-counts-per-revolution = Der Messarm unter { $url } meldet für Gelenk { $joint } 0 Inkremente je Umdrehung
arm-sends-hello-but-no-samples = Der Messarm unter { $url } meldet sich ({ $name }), sendet aber keine Messwerte
arm-sends-no-valid-poses = Die letzten { $count } Posen des Messarms unter { $url } enthalten eine nicht endliche Zahl oder eine Quaternion, deren Länge nicht 1 ist
arm-sends-other-joint-count = Der Messarm unter { $url } hat { $expected } Gelenke angekündigt, sendet aber { $count }
arm-sends-samples-but-no-hello = Der Messarm unter { $url } sendet Messwerte, aber kein Hello
arm-speaks-version-protocol-driver-speaks = Der Messarm unter { $url } verwendet Version { $other_version } des Protokolls, dieser Treiber die Versionen 1 und 2
arm-url-cannot-be-opened = Die url { $url } des Messarms lässt sich nicht öffnen ({ $reason })
arms-5-6-7-joints-served = Unterstützt werden Messarme mit 5, 6 oder 7 Gelenken.
arms-adapter-running = Prüfen, ob der Adapter des Messarms läuft.
bridge-must-send-finite-unit-quaternions = Seine Brücke muss Einheitsquaternionen senden, und nichts, solange die Pose unbekannt ist.
bytes-but-no-packet =
    { $count ->
        [one] { $count } Byte kam von { $url }, aber kein Paket eines Messarms mit Winkelgebern
       *[other] { $count } Bytes kamen von { $url }, aber kein Paket eines Messarms mit Winkelgebern
    }
check-address-network = Adresse und Netz prüfen.
check-arm-power-and-no-second-program = Prüfen Sie die Stromversorgung des Messarms, und dass kein anderes Programm seine Impulse startet.
check-arm-url = Die url des Messarms prüfen.
check-baud-rate-arm-port-another = Baudrate prüfen; sicherstellen, dass an diesem Anschluss der Messarm und kein anderes Gerät hängt.
check-robot-network = Prüfen, ob die Robotersteuerung eingeschaltet ist; Adresse, Netzwerkkabel und Firewalls prüfen.
check-which-arm-plugged = Prüfen, welcher Messarm angeschlossen ist.
choose-pulse-rate = Wählen Sie eine Rate von { $low } bis { $high }.
close-program-second-station-same-port = Das andere Programm oder eine zweite Station am selben Anschluss schließen.
driver-bridge = Encoder-Messarm oder Brücke, an serieller Schnittstelle oder im Netz
driver-microscribe = MicroScribe-Messarm
enter-device-address = Gerätepfad wie /dev/ttyUSB0, Anschluss wie COM5, socket://HOST:PORT oder rfc2217://HOST:PORT eingeben.
enter-network-address-as = Geben Sie eine Adresse im Netz als { $url } ein.
firmware-must-answer-hello = Die Firmware muss die Hello-Anfrage beantworten (crenel_hardware.arm.protocol).
firmware-must-answer-pulse-request = Seine Firmware muss Impulsanforderungen beantworten (crenel_hardware.arm.protocol).
firmware-must-send-counts-of-hello = Die Firmware muss so viele Werte senden, wie ihr Hello ankündigt.
firmware-must-send-what-hello-announces = Seine Firmware muss senden, was ihr Hello ankündigt.
give-one-number-all-joints-one = Einen Wert für alle Gelenke oder für jedes Gelenk einen angeben.
host-not-known = Der Rechner in { $url } ist nicht bekannt
it-is-no-device = das ist keine Adresse eines Geräts
line-to-arm-closed = Die Verbindung zum Messarm unter { $url } ist geschlossen
line-to-arm-gone = Die Verbindung zum Messarm unter { $url } ist unterbrochen
line-to-arm-lost = Die Verbindung zum Messarm unter { $url } ist unterbrochen ({ $reason })
linux-add-user-group-owns-port = Unter Linux den Benutzer in die Gruppe aufnehmen, der der Anschluss gehört (oft dialout).
microscribe-needs-five-joints = Dieser Treiber ist nur für MicroScribe mit fünf Gelenken.
microscribe-no-answer = Unter { $url } antwortet kein MicroScribe
microscribe-other-device = Das Gerät unter { $url } antwortet nicht wie ein MicroScribe
microscribe-stopped-answering = Der MicroScribe unter { $url } antwortet nicht mehr
no-answer-from = Von { $url } kommt keine Antwort
no-serial-port-named = Der serielle Anschluss { $url } existiert nicht
no-serial-port-plugged = Es ist kein serieller Anschluss vorhanden.
nothing-came-for = Von { $url } kam { $time } lang nichts
nothing-can-be-sent-to-arm = An den Messarm unter { $url } lässt sich nichts senden ({ $reason })
nothing-listens = Unter { $url } antwortet kein Dienst
option-counts-per-revolution = Zählschritte je Umdrehung
option-help-setting = Nummer von Werkzeug und Koordinatensystem, die die Brücke sendet; Posen mit einer anderen werden abgelehnt
option-joint-count = Anzahl der Gelenke
option-setting = Einstellung der Posen
plug-right-arm-correct-arm-joint = Richtigen Messarm anschließen oder [arm] joint_count berichtigen.
ports-are = Vorhandene Anschlüsse: { $names }.
restart-robot-controller = Die Steuerung des Arms neu starten.
restore-tool-and-coordinate-system = Wählen Sie am Messarm wieder das frühere Werkzeug und Koordinatensystem, oder kalibrieren Sie mit den neuen.
robot-clock-jumped = Die Uhr des Arms unter { $address } ist gesprungen: Die Steuerung wurde neu gestartet oder ihre Zeit gestellt
serial-port-use-another-program = Der serielle Anschluss { $url } wird von einem anderen Programm verwendet
set-arm-counts-per-revolution-station = { "[" }arm] counts_per_revolution in station.toml angeben.
station-toml-gives-counts-per-revolution = station.toml gibt { $counts } counts_per_revolution an, der Messarm hat { $joints } Gelenke
switch-arm-check-cable-port = Messarm einschalten; Kabel prüfen; ebenso, ob dies der richtige Anschluss ist.
switch-arm-off = Messarm aus- und wieder einschalten.
trigger-camera-otherwise = Schließen Sie einen Messarm mit Auslöseausgang an, oder lassen Sie die Kamera frei laufen.
update-program-arms-firmware = Dieses Programm oder die Firmware des Messarms aktualisieren.
user-may-not-open-serial-port = Dieser Benutzer darf den seriellen Anschluss { $url } nicht öffnen, oder ein anderes Programm hat ihn offen

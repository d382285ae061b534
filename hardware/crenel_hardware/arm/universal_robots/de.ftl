check-address-and-port = Adresse und Port in station.toml prüfen.
driver-ur-rtde = Roboter von Universal Robots (RTDE)
robot-said = { $text }. Der Roboter meldet: { $said }
ur-arm-off = Die Gelenke des Roboters unter { $address } sind ohne Strom; ihre Winkel werden nicht gemessen
ur-does-not-speak-rtde-2 = Der Roboter unter { $address } spricht Version 2 von RTDE nicht
ur-has-not = Der Roboter unter { $address } bietet { $names } nicht an
ur-keep-tool = Während einer Sitzung dasselbe aktive Werkzeug verwenden. Die Verbindung öffnet sich von selbst wieder; danach den letzten Schritt wiederholen.
ur-no-answer = Der Roboter unter { $address } nimmt die Verbindung an, antwortet aber nicht wie RTDE
ur-no-rtde = Was von { $address } kommt, ist kein RTDE ({ $reason })
ur-rate-too-high = Der Roboter unter { $address } sendet höchstens mit { $fastest }, station.toml nennt aber { $rate }
ur-refuses-start = Der Roboter unter { $address } weigert sich, Daten zu senden
ur-switch-on = Den Roboterarm am Handbediengerät einschalten.
ur-tool-changed = Das aktive Werkzeug (TCP) des Roboters unter { $address } wurde gewechselt
ur-update-polyscope = PolyScope, die Software des Roboters, mindestens auf 3.12 (CB3) oder 5.5.1 (e-Series) aktualisieren; mit älterer Software report = "joints" verwenden.

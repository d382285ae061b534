ui-against-a-gauge = an einem Prüfnormal
ui-alarm-and-more = { $alarm } (und { $n } weitere)
ui-alarms = Alarme
ui-ambient = Umgebung
ui-as-of = Stand { $when }
ui-current-activity = Aktueller Vorgang
ui-disk = Datenträger
ui-due-old = fällig, { $age } alt
ui-for = seit { $age }
ui-frames-lost = { $n ->
        [one] { $n } Bild verloren
       *[other] { $n } Bilder verloren
    }
ui-free = frei
ui-hz = { $n } Hz
ui-idle = Bereit
ui-job = Auftrag
ui-laser-is-off-lowercase = Laser ist aus
ui-laser-is-on-lowercase = Laser ist an
ui-laser-is-unknown-lowercase = Laser unbekannt
ui-live-cloud = Live-Punktwolke
ui-lost-and-corrupt = { $lost } verloren, { $corrupt } beschädigt
ui-no-alarms = Keine Alarme
ui-no-data-yet-lowercase = noch keine Daten
ui-not-yet = noch nicht
ui-passed-lowercase = bestanden
ui-points-s = Punkte/s
ui-scanning-is-not-possible = Scannen nicht möglich
ui-stamps-by = Zeitstempel: { $stamps }
ui-switched-off = ausgeschaltet
ui-unknown-the-broker-is-offline = unbekannt, der Broker ist nicht erreichbar
ui-valid-old = gültig, { $age } alt
ui-verified = Verifiziert
ui-waiting = wird erwartet

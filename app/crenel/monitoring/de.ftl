ages-calibrations-order-records-go-measuring = Nach der Uhr richten sich das Alter der Kalibrierungen und die Reihenfolge im Archiv, nicht aber das Messen.
all-datasheets-can-read = Alle Datenblätter und Kalibrierscheine sind lesbar.
all-kept-can-read = Alles Gespeicherte ist lesbar.
all-there-they-were-recorded = Alle Aufzeichnungen sind vorhanden und unverändert.
and-more-records = Und { $count } weitere.
another-station-publishes-under-ones-name = Eine andere Station veröffentlicht unter dem Namen dieser Station.
answers-browsers = Antworten an Browser
archive = Archiv
archive-complete = Alles Abgeschlossene ist in { $place }, dort gelesen und verglichen. Auch auf dieser Platte: { $archived }. Nur dort: { $away }.
archive-copying =
    { $waiting ->
        [one] { $waiting } Datensatz ({ $size }) wird nach { $place } kopiert.
       *[other] { $waiting } Datensätze ({ $size }) werden nach { $place } kopiert.
    }
archive-disk = Datenträger des Archivs
archive-disk-why = Fällt ein Datenträger aus, ist alles verloren, was darauf liegt.
archive-look-at-log = Sehen Sie im Protokoll unten nach, oder senden Sie ein Supportpaket.
archive-name-other-disk = Nennen Sie als url in [archive] von station.toml einen Ordner auf einem anderen Datenträger oder einen Speicher eines anderen Rechners.
archive-on-own-disk = Das Archiv { $place } liegt nicht auf dem Datenträger des Datenordners.
archive-trouble =
    { $waiting ->
        [0] { $trouble } Nichts wartet; der nächste Versuch ist in { $minutes }.
        [one] { $trouble } { $waiting } Datensatz wartet; der nächste Versuch ist in { $minutes }.
       *[other] { $trouble } { $waiting } Datensätze warten; der nächste Versuch ist in { $minutes }.
    }
archive-why = Was nicht im Archiv ist, gibt es nur auf dem Datenträger dieser Station.
background-work = Hintergrundarbeit
background-work-remedy = Das Protokoll unten ansehen und das Diagnosepaket senden. Die Station neu starten, wenn ein Teil weiter scheitert.
background-work-runs =
    { $count ->
        [one] Ein Teil läuft.
       *[other] Alle { $count } Teile laufen.
    }
background-work-why = Sie hält aktuell, was Browser zeigen, und überwacht Geräte, Scans und den Datenträger.
backup = Sicherung
bring-back-last-backup-delete-under = Aus der letzten Sicherung wiederherstellen oder im Archiv löschen.
broker = Broker
broker-messages-not-read =
    { $count ->
        [one] { $count } Nachricht auf dem Broker wurde nicht gelesen: { $reasons }.
       *[other] { $count } Nachrichten auf dem Broker wurden nicht gelesen: { $reasons }.
    }
can-written = Der Datenordner ist beschreibbar.
cannot-written = Der Datenordner ist nicht beschreibbar: { CLAUSE($trouble) }.
check-address-below-try = Adresse unten prüfen und testen.
check-cable-power-looked-again-itself = Kabel und Stromversorgung prüfen. Das Gerät wird automatisch wieder gesucht.
check-cannot-made = Die Prüfung { $name } ist nicht möglich: { CLAUSE($reason) }.
check-failed = Fehlgeschlagene Prüfung
check-folders-owner-whether-disk-mounted = Prüfen, wem der Ordner gehört und ob der Datenträger eingehängt ist.
check-sensor = Temperaturfühler prüfen.
clock = Uhr
clock-set-since-start-last =
    { $count ->
        [one] Die Uhr wurde seit dem Start einmal verstellt, um { $last_jump }.
       *[other] Die Uhr wurde seit dem Start { $count }-mal verstellt, zuletzt um { $last_jump }.
    }
close-other-programs-restart-station-between = Andere Programme schließen oder die Station zwischen zwei Scans neu starten.
close-what-else-uses-machine = Andere Programme auf diesem Rechner schließen.
connected = Verbunden mit { $host }.
correct-remove-files-named = Die genannten Dateien berichtigen oder entfernen.
could-true-last-ago =
    { $count ->
        [one] { $count } war unplausibel, vor { $ago }: { CLAUSE($what) }.
       *[other] { $count } waren unplausibel, der letzte vor { $ago }: { CLAUSE($what) }.
    }
damaged = Die Datenbank ist beschädigt: { $trouble }.
database = Datenbank
datasheets = Datenblätter
datasheets-set-aside-everything = Nicht lesbare Dateien in arms, objects, sensors und gauges werden unverändert beiseitegelegt; alles andere steht zur Verfügung.
delete-scans-under-records-use-larger = Scans im Archiv löschen oder einen größeren Datenträger verwenden.
disk = Datenträger
disk-fails-takes-every-calibration-scan = Mit einem defekten Datenträger gehen alle Kalibrierungen und Scans verloren.
error-not-foreseen = Ein Fehler im Protokoll ist ein nicht vorhergesehener Fall.
errors-or-none-last-hour =
    { $count ->
        [0] Kein Fehler in der letzten Stunde.
        [one] Ein Fehler in der letzten Stunde.
       *[other] { $count } Fehler in der letzten Stunde.
    }
every-reading-joints-could-true = Alle Messwerte der Gelenke sind plausibel.
everything-grows-metre-aluminium = Mit der Temperatur dehnt sich alles aus, ein Meter Aluminium um { $growth } je Grad.
frame-without-joints-around-gives-no = Ein Bild ohne benachbarte Messwerte des Messarms ergibt keine Punkte.
free = { $free } sind frei.
free-enough-for-hours = { $free } sind frei, genug für { $hours } Stunden dieses Scans.
give-each-own-name-station-mqtt = Jeder Station mit station in [mqtt] der station.toml einen eigenen Namen geben.
held-up-live-numbers-stand-press = Bei Verzögerungen bleiben Anzeigen stehen und Eingaben werden verspätet beantwortet; die Geräte werden weiter gelesen.
held-up-more-than-longest =
    { $count ->
        [one] einmal um mehr als { $limit } verzögert, um { $longest }
       *[other] { $count }-mal um mehr als { $limit } verzögert, höchstens um { $longest }
    }
holds-journal-every-step-accounts-what = Die Datenbank enthält das Journal aller Schritte, die Konten und die Angabe der verwendeten Kalibrierung.
last-days-old = Die letzte Sicherung ist { $days } Tage alt, in { $place }.
last-days-old-same-disk = Die letzte Sicherung ist { $days } Tage alt, in { $place }. Sie liegt auf demselben Datenträger wie die Daten.
let-each-station-write-under-own = Jede Station darf nur unter ihrem eigenen Topic schreiben; die vom Broker gespeicherten Nachrichten anderer entfernen.
let-kept-time-server-which-moves = Von einem Zeitserver führen lassen, der sie gleitend nachstellt.
log = Protokoll
log-cannot-written-health-page-says = Das Protokoll lässt sich nicht schreiben; Näheres steht auf der Seite „Zustand“.
log-event-loop-goes-on = die Ereignisschleife läuft nach { $duration } weiter
log-event-loop-held-up = die Ereignisschleife ist seit mehr als { $limit } blockiert
log-has-what-held-up-send = Die Ursache steht im Protokoll; tritt es wieder auf, das Diagnosepaket senden.
log-lines-lost =
    { $count ->
        [one] eine Zeile des Protokolls ging verloren, weil der Datenträger zu langsam war
       *[other] { $count } Zeilen des Protokolls gingen verloren, weil der Datenträger zu langsam war
    }
log-program-stood-still = das gesamte Programm stand { $duration } lang still
log-repeated = ({ $count } davon seit { $since })
logs-cannot-written = Die Protokolle in { $folder } lassen sich nicht schreiben
look-log-below-send-support-bundle = Protokoll unten ansehen und das Diagnosepaket an den Support senden.
look-them-below-send-support-bundle = Fehler unten ansehen und das Diagnosepaket senden.
loop-fails-now =
    { $count ->
        [one] Scheitert gerade und wird wieder versucht: { $part } ({ CLAUSE($error) }).
       *[other] Scheitert gerade und wird wieder versucht, bisher { $count }-mal: { $part } ({ CLAUSE($error) }).
    }
loop-goes-on = Stand { $stood } lang bis vor { $ago } und arbeitet weiter: { $part } (in { $where }).
loop-name =
    { $name ->
        [rig-state] Zustand der Geräte
        [scan-state] Zustand des Scans
        [scene] Zeichnen der 3D-Ansicht
        [view] Zustand der 3D-Ansicht
        [pulse-trigger] Triggerpulse
        [arm-reader] Lesen des Messarms
        [sensor-reader] Lesen des Sensors
        [awake] Uhr des Programms
        [preview] Livebild
        [object-watch] Erkennung des Objekts
        [device-trial] Erprobung eines Geräts
        [loop-watchdog] Überwachung der Ereignisschleife
        [hang-watch] Suche nach stehenden Schleifen
        [log-writer] Schreiben des Protokolls
        [archive] Archivierung
        [scan-sync] Sichern der Aufnahme
        [live-state] geführte Abläufe und Start
        [report] Bericht der Station
        [unattended] Aufsicht über unbeaufsichtigte Scans
        [stations] andere Stationen
        [events] Weitergabe von Ereignissen
        [health] Zustandsprüfungen
        [temperature] Lesen der Temperatur
        [notifications] Benachrichtigungen
        [broker] Verbindung zum Broker
       *[other] { $name }
    }
loop-stands-now = Steht seit { $stood }: { $part } (in { $where }).
loop-works-again =
    { $count ->
        [one] Vor { $ago } gescheitert, neu gestartet und arbeitet: { $part } ({ CLAUSE($error) }).
       *[other] { $count }-mal gescheitert, zuletzt vor { $ago }, neu gestartet und arbeitet: { $part } ({ CLAUSE($error) }).
    }
losses =
    { $device ->
        [arm] Datenverluste des Messarms
       *[sensor] Datenverluste des Sensors
    }
lost-garbled-last-ten-minutes = { $missing } von { $total } in den letzten zehn Minuten verloren oder beschädigt ({ $share }).
make-one-below-crenel-backup = Unten oder mit crenel backup eine anlegen.
memory = Arbeitsspeicher
messages-of-no-station = { $count } ohne das Format einer Station
messages-of-too-many-stations = { $count } von mehr Stationen, als angezeigt werden
messages-stations = Nachrichten von Stationen
messages-too-long = { $count } zu lang
messages-too-often = { $count } schneller, als sie gelesen werden
name-folder-another-disk-backups-station = Mit backups in station.toml einen Ordner auf einem anderen Datenträger angeben.
name-tls-certificate-tls-key-station = tls_certificate und tls_key in station.toml angeben oder einen Proxy vorschalten.
network = Netz
never-held-up-more-than = Nie um mehr als { $limit } verzögert.
newest-record-days-later-than-clock = Der neueste Eintrag liegt { $days } Tage nach der aktuellen Uhrzeit.
no-connection-for = Seit { $duration } nicht mit { $host } verbunden: { CLAUSE($reason) }.
no-data-yet = Noch keine Daten.
not-read-yet = Noch nicht gelesen.
nothing-taken-reading-cannot-true-no = Unplausible Messwerte werden nicht verwendet: nicht für Antastpunkte, Posen oder gescannte Punkte.
notifications-not-accepted = { $host } nimmt keine Benachrichtigungen an: { $trouble } ({ $failed } nicht zugestellt).
only-machines-browsers-reach-station = Nur Browser auf diesem Rechner erreichen die Station.
other-machines-reach-encrypted = Andere Rechner erreichen die Station, verschlüsselt.
other-machines-reach-nothing-encrypted = Andere Rechner erreichen die Station, unverschlüsselt.
other-machines-reach-proxy = Andere Rechner erreichen die Station über einen Proxy.
other-stations-see-one-one-them = Über den Broker sehen die Stationen einander. Sonst wird er nicht benötigt.
put-file-back-last-backup-leave = Datei aus der letzten Sicherung wiederherstellen oder ohne sie fortfahren.
readings-arm = Messwerte des Messarms
recordings = Aufzeichnungen
recordings-calibrations-journal-kept-there = Dort werden Aufzeichnungen, Kalibrierungen und das Journal gespeichert.
recordings-damaged =
    { $more ->
        [0] { CLAUSE($first) }.
       *[other] { CLAUSE($first) }, und { $more } weitere.
    }
records = Archiv
runs-steadily = Sie läuft gleichmäßig.
scan-can-made-again-recording-verification = Aus der Aufzeichnung lässt sich ein Scan neu berechnen und eine Verifizierung belegen.
scan-does-start-less-than-0 = Ein Scan startet nicht mit weniger als 0,5 GB und stoppt bei 0,1 GB.
second-newest-old = { CLAUSE($text) }: { $rate } je Sekunde, der neueste Wert { $age } alt.
set-machines-clock-let-kept-time = Uhr des Rechners stellen und von einem Zeitserver führen lassen.
sign-in-health = Anmeldung mit Konten des Werks
sign-in-health-remedy = Konten dieser Station können sich anmelden. Prüfen Sie das Netz, den Anbieter und [sign_in] der station.toml
sign-in-health-why = Ohne den Anbieter können sich nur Konten dieser Station anmelden; wer angemeldet ist, bleibt es.
sign-in-provider-answers = { $name } antwortet.
since-calibration = { $celsius }, { $change } seit der Kalibrierung.
software-part =
    { $part ->
        [system] System { $version }
        [machine] Rechner { $version }
        [processors] { $version } Prozessoren
        [arm] Messarm { $version }
        [sensor] Sensor { $version }
       *[other] { $part } { $version }
    }
somebody-publishes-what-no-station-does = Diese Nachrichten stammen nicht von einer Station und können Angezeigtes verdecken oder verfälschen.
station-uses = Die Station belegt { $process }.
station-uses-and-free = Die Station belegt { $process }; { $free } sind frei.
stop-station-keep-copy-data-folder = Station beenden, eine Kopie des Datenordners aufbewahren und mit der letzten Sicherung starten.
takes-notifications = { $host } nimmt Benachrichtigungen an.
tells-whoever-away-what-done-fault = Der Webhook benachrichtigt Abwesende über Fertiges, Störungen und Fälliges.
there-none-yet = Es gibt noch keine Sicherung.
thread-has-died = Vor { $ago } durch einen Fehler beendet: { $name } ({ CLAUSE($error) }).
time-stamps-come-from =
    { $stamps ->
        [arrival] Vom Eintreffen der Daten an diesem Rechner.
        [pulse] Von Triggerimpulsen, die Messarm und Kamera beide zählen.
       *[device] Von der eigenen Uhr des Geräts.
    }
time-stamps-explained = Das Eintreffen schwankt um Millisekunden, was Genauigkeit kostet, während der Arm sich bewegt. Besser ist die eigene Uhr des Geräts, am besten sind Triggerimpulse.
time-stamps-of =
    { $device ->
        [arm] Zeitstempel, Messarm
       *[sensor] Zeitstempel, Kamera
    }
verify-against-gauge-calibrate-again = An einem Prüfnormal verifizieren oder neu kalibrieren.
webhook = Webhook
what-cannot-read-set-aside-everything = Nicht Lesbares wird unverändert beiseitegelegt; alles andere steht zur Verfügung.
what-looks-may-good-bad = Der Zustand dessen, was sie prüft, ist damit unbekannt.
who-reads-along-has-passwords-can = Wer mitliest, kennt Passwörter und kann unter fremdem Namen handeln.
whoever-helps-you-asks-first = Der Support fragt zuerst danach.
whole = Sie ist intakt, { $size_mb }.
whole-program-stood-still-longest =
    { $count ->
        [one] das gesamte Programm stand einmal still, für { $longest }
       *[other] das gesamte Programm stand { $count }-mal still, am längsten für { $longest }
    }
without-free-memory-whole-machine-slows = Ohne freien Arbeitsspeicher wird der ganze Rechner langsam, und Bilder gehen verloren.
without-nothing-measured-what-taken-kept = Ohne dieses Gerät wird nicht gemessen; alles Aufgenommene bleibt erhalten.

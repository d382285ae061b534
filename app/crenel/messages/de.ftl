a-calibration-belongs-to-one-sensor = eine Kalibrierung gehört zu einem von ihnen
a-laser-plane-is-of-one-laser = eine Laserebene ist die eines Lasers
abandon-calibration-calibration-use-stays = Diese Kalibrierung abbrechen? Eine Kalibrierung in Gebrauch bleibt unverändert.
abandoned = Sitzung abgebrochen
about-missing-places-longest-start =
    { $stream ->
        [joints]
            { $missing ->
                [one] es fehlt etwa ein Messwert
               *[other] es fehlen etwa { $missing } Messwerte
            } des Messarms an { $holes ->
                [one] { $holes } Stelle
               *[other] { $holes } Stellen
            }, die längste { $longest } lang, { $at } nach Beginn
       *[frames]
            { $missing ->
                [one] es fehlt etwa ein Bild
               *[other] es fehlen etwa { $missing } Bilder
            } an { $holes ->
                [one] { $holes } Stelle
               *[other] { $holes } Stellen
            }, die längste { $longest } lang, { $at } nach Beginn
    }
accept-calibration = Diese Kalibrierung annehmen
accept-verification = Diese Verifizierung annehmen
acceptance-limit-lower = Untere Annahmegrenze
acceptance-limit-upper = Obere Annahmegrenze
accepted = Angenommen
accepted-result = Ergebnis angenommen
account-belongs-to-another = An dieser Station gibt es bereits ein anderes Konto { $name }
account-change-at-provider = Ändern Sie es beim Anbieter; es gilt ab der nächsten Anmeldung
account-has-no-name = Das Konto hat keinen Namen
account-is-of-provider = Über Passwort und Rolle von { $name } entscheidet der Anbieter
account-name-length = Zulässig sind 1 bis { $most } Buchstaben, Ziffern und Zeichen
account-not-there = Es gibt kein Konto { $name }
account-remove-or-use-password = Melden Sie sich mit dessen Passwort an, oder bitten Sie einen Administrator, es zu entfernen
account-taken = Das Konto { $name } gibt es bereits
accounts-are = Konten: { $names }
accounts-none = Konten: noch keines
across-mm = quer, mm
act-failed = fehlgeschlagen
act-with-detail = { $act }: { $detail }
activity-arm = Armprüfung
activity-calibration = Kalibrierung
activity-delay = Bestimmung des Zeitversatzes
activity-ended = { $who } hat beendet: { $title }.
activity-performance = Leistungsprüfung
activity-scan = Scan
activity-verification = Verifizierung
add-column-or-leave-both = Spalte ergänzen oder beide weglassen
add-dh-row = Geben Sie je Gelenk eine Zeile an, der Reihe nach
add-exposure-us-line = Zeile exposure_us = … hinzufügen
add-line = Zeile { $key } = … hinzufügen
add-micrometer-reading-of-width = Die Breite eines Zahns mit der Messschraube messen und ergänzen, oder den Tasterdurchmesser abziehen und seine Unsicherheit als tool_uncertainty_mm unter einem anderen Gerät angeben
add-picture-delete-pose = Bild ergänzen oder Pose löschen
add-pictures-turned-about-another-axis = Bilder aufnehmen, die um eine andere Achse gedreht sind
add-readings-from-face-known = Messwerte dieser Flächen gegen andere ergänzen
add-the-laser = Laser hinzufügen
add-the-laser-to-camera-and-mounting = Bilder aufnehmen, in denen die Laserlinie über die Tafel verläuft, und mit dieser Kalibrierung kalibrieren: mit „Laser hinzufügen“ auf der Seite Kalibrieren oder auf der Kommandozeile mit --camera-from
added-a-datasheet = fügte ein Datenblatt hinzu
added-account = Konto angelegt
added-gauge-certificate = Kalibrierschein eines Prüfnormals hinzugefügt
address-none-message-can-sent = An diese Adresse lässt sich keine Nachricht senden
adjusting-all-poses-together = Alle Posen werden gemeinsam ausgeglichen
after = Nachher
after-advised-pose = { $then } nach der empfohlenen Pose
after-few-more-touches = nach einigen weiteren Antastpunkten
after-mark = nachher
after-three-points-three-faces = nach drei Punkten auf drei Flächen
against-limits = Vergleich mit den Grenzwerten
against-use-before-points-measuring-volume = Gegenüber der zuvor verwendeten { $name }: Punkte im Messvolumen haben sich um { $rms } ({ $rms_mm }) rms verschoben, höchstens um { $largest } ({ $largest_mm }).
ages-calibrations-order-records-go-measuring = Nach der Uhr richten sich das Alter der Kalibrierungen und die Reihenfolge im Archiv, nicht aber das Messen.
all-corners-lie-one-level-z = alle { $points } Ecken liegen auf einer Höhenstufe, z = { $z }
all-corners-lie-one-plane-normal = alle { $points } Ecken liegen in einer Ebene mit der Normalen ({ $normal })
all-corners-were-given-same-pixel = alle Ecken haben dieselben Pixelkoordinaten
all-datasheets-can-read = Alle Datenblätter und Kalibrierscheine sind lesbar.
all-kept-can-read = Alles Gespeicherte ist lesbar.
all-pictures-one-sensor-must-have = Alle Bilder eines Sensors müssen gleich groß sein.
all-points-there-go-add =
    { $more ->
        [yes] Alle Punkte sind aufgenommen. Fortfahren oder weitere antasten, wie unten angegeben.
       *[no] Alle Punkte sind aufgenommen. Fortfahren oder weitere antasten.
    }
all-points-there-go-pictures = Alle Punkte sind aufgenommen. Weiter zu den Bildern.
all-poses-turn-flange-about-one = alle { $count } Posen drehen den Flansch um dieselbe Achse, ({ $x } { $y } { $z }) im Flanschsystem
all-there-calibrate = Alles, was sie braucht, ist da.
all-there-they-were-recorded = Alle Aufzeichnungen sind vorhanden und unverändert.
and-more-records = Und { $count } weitere.
angle = Winkel, ″
angle-between-clouds = Winkel zwischen den Punktwolken
angle-beyond-a-turn = darunter steht { $value }, mehr als eine volle Umdrehung im Bogenmaß: Das sind Grad
angle-touched-plane = Winkel zur angetasteten Ebene
angles-are-in-other-unit =
    { $unit ->
        [deg] das ist Bogenmaß, wo Grad erwartet werden
       *[rad] das sind Grad, wo Bogenmaß erwartet wird
    }
angles-are-multiples = alle sind Vielfache von π/2, etwa { $value }: Das ist Bogenmaß
angles-called =
    { $unit ->
        [rad] Die Winkel heißen Bogenmaß
       *[deg] Die Winkel heißen Grad
    }
another-arm-answers = Unter { $url } antwortet ein anderer Messarm: { $name } { $serial_number } ({ $joints } Gelenke) statt { $expected_name } { $expected_serial_number }
another-calibration-came-into-use-meanwhile = Inzwischen wird eine andere Kalibrierung verwendet. Mit dieser neu beginnen.
another-device-is-tried = Ein anderes Gerät wird ausprobiert
another-programs-database = { $path } ist die Datenbank eines anderen Programms
another-station-publishes-under-ones-name = Eine andere Station veröffentlicht unter dem Namen dieser Station.
another-tip-mounted-another-sphere-touched = Der Durchmesser der Tastkugel beträgt anscheinend { $diameter }, laut Datenblatt des Messarms { $expected }: Es ist ein anderer Taster montiert, oder es wurde eine andere Kugel angetastet.
another-unit-arm-or-marker = sie haben eine andere Einheit, stammen von einem anderen Arm, oder die Gelenkwinkel gehören zu anderen Posen
answered-who-asked-control = Anfrage nach der Bedienung beantwortet
answers-browsers = Antworten an Browser
applied-dropped-arms-delay = Zeitversatz des Messarms übernommen oder verworfen
approved = Freigegeben
aravis-missing = Die Bibliothek Aravis fehlt, über die Industriekameras gelesen werden
archive = Archiv
archive-away = Das Archiv { $place } ist nicht erreichbar
archive-cannot-hold-name = Das Archiv kann keine Datei mit dem Namen { $path } aufnehmen
archive-check-disk = Prüfen Sie den Datenträger des Archivs; die Aufnahme wird erneut kopiert
archive-check-id = crenel archive status zeigt, was im Archiv ist
archive-check-keys = Prüfen Sie access_key, secret_file und die Rechte des Archivs; die Station versucht es von selbst wieder
archive-check-network = Prüfen Sie das Netz, den endpoint und ob der Server des Archivs läuft; die Station versucht es von selbst wieder
archive-check-url = Hängen Sie den Datenträger ein, legen Sie den Ordner oder Bucket an, oder berichtigen Sie url in [archive] der station.toml
archive-complete = Alles Abgeschlossene ist in { $place }, dort gelesen und verglichen. Auch auf dieser Platte: { $archived }. Nur dort: { $away }.
archive-copies-itself = Aufzeichnungen würden in sich selbst kopiert, und ihre einzigen Kopien könnten auf einem Datenträger verschoben werden
archive-copy-differs = { $name } weicht im Archiv von dem ab, was geschrieben wurde
archive-copying =
    { $waiting ->
        [one] { $waiting } Datensatz ({ $size }) wird nach { $place } kopiert.
       *[other] { $waiting } Datensätze ({ $size }) werden nach { $place } kopiert.
    }
archive-disk = Datenträger des Archivs
archive-disk-why = Fällt ein Datenträger aus, ist alles verloren, was darauf liegt.
archive-fetch-record = Nur im Archiv. Zurückholen mit: crenel archive fetch { $kind } { $id }
archive-fetched = { $name } ist aus dem Archiv zurück.
archive-fetching = { $name } wird aus dem Archiv geholt
archive-forbidden = Das Archiv { $place } verweigert den Zugriff
archive-full = Das Archiv { $place } ist voll
archive-give-both-keys = Geben Sie access_key und secret_file an, oder keines von beiden
archive-goes-on-later = Die Kopie ins Archiv geht nach dem nächsten Start weiter
archive-has-no-record = Das Archiv { $place } hat keinen vollständigen Datensatz { $id }
archive-install-library = Installieren Sie sie, zum Beispiel mit: pip install '{ $library }'
archive-is-here = { $id } ist bereits auf diesem Datenträger
archive-key-alone = { $file }, [archive]: access_key oder secret_file steht ohne das andere
archive-keys-belong-together = ein Schlüssel und sein Geheimnis gehören zusammen
archive-lacks-file = die Datei fehlt dort
archive-library-missing = Die Bibliothek für das Archiv { $place } fehlt
archive-look-at-log = Sehen Sie im Protokoll unten nach, oder senden Sie ein Supportpaket.
archive-loses-data = das Archiv hält nicht, was geschrieben wird
archive-make-room = Schaffen Sie dort Platz, oder nennen Sie ein anderes Archiv; die Station versucht es von selbst wieder
archive-manifest-damaged = { $name } im Archiv ist beschädigt
archive-missing = Das Archiv { $place } ist nicht da
archive-name-other-disk = Nennen Sie als url in [archive] von station.toml einen Ordner auf einem anderen Datenträger oder einen Speicher eines anderen Rechners.
archive-name-place-apart = Nennen Sie als url in [archive] von station.toml einen Ordner außerhalb, am besten auf einem anderen Datenträger; sind schon Aufzeichnungen archiviert, kopieren Sie deren Ordner zuerst dorthin, mit crenel-archive.txt
archive-name-secret-file = Nennen Sie eine Datei, die nur den geheimen Schlüssel enthält
archive-needs-space = Der Datensatz braucht { $size }
archive-no-marker = dort fehlt crenel-archive.txt, die diese Station dort geschrieben hat
archive-not-set = station.toml nennt kein Archiv
archive-of-another = Das Archiv { $place } ist das einer anderen Station: es enthält keinen Datensatz dieser Station
archive-of-station = Das Archiv { $place } ist das der Station { $station }
archive-on-own-disk = Das Archiv { $place } liegt nicht auf dem Datenträger des Datenordners.
archive-on-same-disk = Das Archiv { $place } liegt auf demselben Datenträger wie der Datenordner: Es schützt nur vor gelöschten Dateien.
archive-overlaps-data = Das Archiv { $place } und der Datenordner { $folder } überschneiden sich
archive-own-place = Nennen Sie für diese Station einen eigenen Ort als url in [archive] der station.toml; wenn diese Station jenes Archiv mit einem neuen Datenordner fortsetzt, entfernen Sie dort crenel-archive.txt
archive-path-leads-out = { $path } führt aus dem Ordner des Datensatzes hinaus
archive-record-changes = { $path } ändert sich beim Kopieren
archive-tried-again = Der Datensatz wird kopiert, wenn er sich nicht mehr ändert
archive-trouble =
    { $waiting ->
        [0] { $trouble } Nichts wartet; der nächste Versuch ist in { $minutes }.
        [one] { $trouble } { $waiting } Datensatz wartet; der nächste Versuch ist in { $minutes }.
       *[other] { $trouble } { $waiting } Datensätze warten; der nächste Versuch ist in { $minutes }.
    }
archive-used-by-another = Ein anderer Prozess benutzt das Archiv
archive-wait-for-other = Warten Sie, bis er fertig ist; eine laufende Station kopiert von selbst
archive-why = Was nicht im Archiv ist, gibt es nur auf dem Datenträger dieser Station.
archive-write-table = Ergänzen Sie [archive] in station.toml, wie docs/formats.md zeigt
arm-says = Der Messarm: { $text }
arm-unchanged = Der Messarm ist unverändert.
arm = Messarm
arm-and-frame-have-unknowns = Arm, Messmarken und Koordinatensysteme haben { $unknown } Unbekannte
arm-angles-converted-twice = { $field } erreicht { $largest }: dies sind Grad, die noch einmal umgerechnet wurden, als wären sie Bogenmaß
arm-angles-in-radians = kein { $field } übersteigt { $largest }: dies ist Bogenmaß, aber Grad werden erwartet
arm-announced-joints-sends-poses = Der Messarm unter { $url } hat Gelenkwinkel angekündigt, sendet aber Posen
arm-at-stop = Ein Gelenk des Arms ist am Anschlag.
arm-before = Der vorherige Messarm wird wieder verwendet.
arm-before-arms-put-back-hand = die vorige Armdatei liegt in arms/{ $replaced }/{ $name }; von Hand zurücklegen
arm-by-its-datasheet = der Messarm entspricht seinem Datenblatt
arm-check = Armprüfung
arm-check-within-sentence = Armprüfung
arm-check-no-limit = { $half_range }, kein Grenzwert festgelegt.
arm-check-uncertainty-is-zero = Angewendet auf (max − min)/2 jeder Achse mit der Unsicherheit null, da der Beitrag der Form von Pfanne und Tastkugel nicht angegeben ist: Der Wert wird unmittelbar mit dem Grenzwert verglichen. Die räumlichen Kennwerte stehen ohne Grenzwert.
arm-check-with-limit = { $half_range }, Grenzwert { $limit }.
arm-checked = Der Messarm ist geprüft: { $worst }.
arm-chosen-cannot-read-any-more = Die Datei des gewählten Messarms ist nicht mehr lesbar
arm-closed-while-opening = Der Messarm unter { $url } wurde beim Öffnen geschlossen
arm-counts-pulses-from-start-again = Der Messarm unter { $url } ist neu gestartet, während die Kamera seine Auslöseimpulse zählte
arm-does-not-answer-pulse-request = Der Messarm unter { $url } hat Auslöseimpulse, antwortet aber nicht auf die Aufforderung, sie zu starten oder anzuhalten
arm-encoders = Winkelgeber des Messarms
arm-geometry = Geometrie des Messarms
arm-has-joint-number = der Messarm { $arm } hat { $count } Gelenke
arm-has-joints = der Messarm { $arm } hat { $count } Gelenke
arm-has-joints-station-toml-asks = Der Messarm unter { $url } ({ $name } { $serial_number }) hat { $joints } Gelenke, station.toml verlangt joint_count = { $joint_count }
arm-has-no-tip = der Messarm { $name } hat keine Tastkugel
arm-has-no-trigger-pulses = Der Messarm unter { $url } hat keinen Ausgang für Auslöseimpulse
arm-has-other-joints = Der angeschlossene Messarm hat { $joints } Gelenke, dieses Modell hat { $rows }: Eine Kalibrierung damit wird abgelehnt. Für jedes Gelenk eine Zeile eintragen oder die Seriennummer des Messarms, den es beschreibt.
arm-identified = Der Messarm ist identifiziert.
arm-is-in-use = Der Messarm ist in Gebrauch: { $title }
arm-is-where-scan-ended = Der Messarm ist, wo der Scan endete
arm-joints-not-among-them = von den Gelenken in arm.json fehlen darunter { $names }
arm-json-has-joints = die arm.json von { $arm } beschreibt Gelenke
arm-json-is-of-poses = die arm.json von { $arm } gehört zu einem Arm, der Posen meldet
arm-json-states-rotation = rotation in arm.json ist { $name }
arm-json-tip-goes-far-while = nach dieser arm.json wandert die Tastkugel weit, obwohl sie in einer Pfanne sitzt: { $far } von der Mitte der Pfanne { $name }
arm-json-tip-goes-fro = { $label }: Nach arm.json wandert die Tastkugel um { $distance } hin und her
arm-measures-within = ein Messarm misst bis höchstens { $farthest }
arm-model-arm = das Armmodell gehört zum Messarm { $serial_number }
arm-near-base = Der Arm ist dicht an seinem Fuß zusammengefaltet.
arm-not-open = Der Messarm unter { $url } ist nicht geöffnet
arm-object-chosen-cannot-read-any = Die Datei des gewählten Messarms oder Objekts ist nicht mehr lesbar.
arm-place-name =
    { $kind ->
        [bar] Kugelstab { $number }, Ende { $end }
        [sphere] Kugel { $number }
       *[seat] Pfanne { $number }
    }
arm-place-title =
    { $kind ->
        [bar] Kugelstab { $number }, Ende { $end }
        [sphere] Kugel { $number }
       *[seat] Pfanne { $number }
    }
arm-poses-other-setting = Die Posen des Messarms unter { $url } gelten für die Einstellung { $setting } von Werkzeug und Koordinatensystem statt für { $expected }
arm-reaches-no-place-for-block = { $arm } erreicht keine Stelle auf einem Tisch, an der sich der Zinnenkörper antasten und der Sensor über ihn halten lässt
arm-refuses-pulse-rate = Der Messarm unter { $url } kann nicht mit { $rate } auslösen
arm-reports-joints =
    Der Messarm unter { $url } meldet { $joints ->
        [one] { $joints } Gelenk
       *[other] { $joints } Gelenke
    }
arm-reports-no-counts-per-revolution = Der Messarm unter { $url } meldet für Gelenk { $joint } 0 Inkremente je Umdrehung
arm-reports-poses-not-checked-here = Der angeschlossene Arm meldet Posen: Seine eigene Software prüft seine Gelenke und seine Tastkugel.
arm-sees-bar-given = der Messarm misst Kugelstab { $bar } mit { $measured }, angegeben sind { $given }
arm-sends-hello-but-no-samples = Der Messarm unter { $url } meldet sich ({ $name }), sendet aber keine Messwerte
arm-sends-no-joint-angles = der Messarm sendet keine Gelenkwinkel
arm-sends-no-valid-poses = Die letzten { $count } Posen des Messarms unter { $url } enthalten eine nicht endliche Zahl oder eine Quaternion, deren Länge nicht 1 ist
arm-sends-other-joint-count = Der Messarm unter { $url } hat { $expected } Gelenke angekündigt, sendet aber { $count }
arm-sends-samples-but-no-hello = Der Messarm unter { $url } sendet Messwerte, aber kein Hello
arm-sent-too-little-arm-camera = der Messarm hat zu wenig gesendet, oder vieles auf einmal mit Lücken dazwischen, oder Messarm und Kamera haben nicht dieselbe Zeitbasis
arm-session-under-way-go-where-stands = Eine Prüfung oder Identifikation des Arms läuft. Beim aktuellen Schritt fortfahren.
arm-speaks-version-protocol-driver-speaks = Der Messarm unter { $url } verwendet Version { $other_version } des Protokolls, dieser Treiber die Versionen 1 und 2
arm-stays-shows-nothing-errors = ein unbewegter Messarm zeigt nichts von seinen Fehlern
arm-not-held-still = der Messarm war nicht in Ruhe
arm-stretched-out = Der Arm ist durchgestreckt.
arm-temperature = Temperatur des Arms
arm-tip = Messarm und Tastkugel
arm-url-cannot-be-opened = Die url { $url } des Messarms lässt sich nicht öffnen ({ $reason })
arm-use-already = Dieser Messarm wird bereits verwendet.
arm-used-since = seit { $since } UTC
arm-used-since-by = seit { $since } UTC, durch { $who }
arm-with-joints-needed = dafür ist ein Messarm nötig, der seine Gelenkwinkel meldet
arm-without-tip-touches-nothing = { $name } hat keine Tastkugel und tastet nichts an. Fahren Sie ohne Punkte fort.
arms-5-6-7-joints-served = Unterstützt werden Messarme mit 5, 6 oder 7 Gelenken.
arms-adapter-running = Prüfen, ob der Adapter des Messarms läuft.
arms-data-has-gap-there = die Daten des Messarms haben dort eine Lücke
arms-motion-moves-other-way-than = nach der Bewegung des Messarms müsste sich „{ $name }“ andersherum bewegen als in den Bildern
arms-motion-object-than-certificate-says =
    { $sign ->
        [larger] Nach der Bewegung des Messarms ist das Objekt { $share } (± { $uncertainty }) größer als laut Kalibrierschein: Alle Längen würden im selben Verhältnis falsch.
       *[smaller] Nach der Bewegung des Messarms ist das Objekt { $share } (± { $uncertainty }) kleiner als laut Kalibrierschein: Alle Längen würden im selben Verhältnis falsch.
    }
arms-motion-squares-wide = nach der Bewegung des Messarms sind die Felder von „{ $name }“ { $width } breit
arms-motion-squares-wide-certificate = Nach der Bewegung des Messarms sind die Felder { $width } breit (± { $uncertainty }), laut Kalibrierschein { $nominal }: Alle Längen würden im selben Verhältnis falsch.
arms-parameters = Parameter des Messarms
arms-parameters-already-explain-points-well = die Parameter des Messarms erklären die Punkte bereits so gut, wie diese gemessen sind
arms-position-known-around-most-pictures = die Stellung des Messarms ist für die meisten Bilder nicht bekannt
arms-zero = Abstand vom Nullpunkt des Messarms
artefact-is-calibration-object = der Prüfkörper { $serial_number } ist das Objekt, mit dem der Sensor kalibriert wurde
artefact-gives-way =
    { $test ->
        [sphere] die Kugel wackelt in Messung { $place }: Ihre Antastungen streuen um { $scatter }, ruhige um bis zu { $expected }
        [contact] der Stab wackelt in Lage { $place }, oder der Durchmesser seiner Kugeln ist falsch eingegeben: Die Antastungen seiner Kugeln streuen um { $scatter }, ruhige um bis zu { $expected }
       *[lengths] das Normal wackelt in Lage { $place }: Die Antastungen seiner Kugeln streuen um { $scatter }, ruhige um bis zu { $expected }
    }
artefact-missing = der Plan nennt keinen Prüfkörper
artefact-temperature = Temperatur des Prüfkörpers
articulation-scanned-otherwise = Aufstellung { $position }, Stellung { $number }: Die Kamera blickte { $off } neben der gewünschten Richtung (höchstens { $most }).
articulation-touched-otherwise = Aufstellung { $position }, Stellung { $number }: Der Taster wurde { $off } neben der gewünschten Richtung gehalten (höchstens { $most }).
articulations-nearly-same = die Stellungen { $first } und { $second } sind fast gleich, { $apart } auseinander; nötig sind mindestens { $least }
articulations-not-scanned = nur { $count } der { $needed } Stellungen wurden gescannt
articulations-too-alike = der Sensor sah die Kugel von zu ähnlichen Seiten
articulations-without-touches = in den Stellungen { $names } fehlen Antastungen
ask-administrator-for-access = Bitten Sie den Verwalter des Systems um Zugriff auf { $device }, oder reichen Sie das Gerät an den Container weiter.
ask-administrator-new-one = Einen Administrator um einen neuen Link bitten
ask-control-take-over = Bedienung anfragen oder übernehmen
ask-somebody-with-role =
    { $role ->
        [admin] An einen Administrator wenden
       *[operator] An einen Bediener wenden
    }
asked-control = Bedienung angefragt
asks-control = { $name } bittet { $holder } um die Bedienung.
at-beginning = Am Anfang
at-end = Am Ende
at-least-limit = ≥ { $limit }
at-most-limit = ≤ { $limit }
at-position = Position { $position }: { $text }
attention = Achtung
authority-give-for-broker = Die Zertifikate der Zertifizierungsstelle des Brokers im PEM-Format angeben
authority-give-for-provider = Die Zertifikate der Zertifizierungsstelle des Anbieters im PEM-Format angeben
authority-holds-none = die Datei enthält keine Zertifikate
autofocus-or-zoom-changed-it = Autofokus oder Zoom haben sie verändert, und eine Kalibrierung gilt für eine Brennweite
channel-less-laser-off = { $channel }, abzüglich des Bildes ohne Laser
line-as-bright-as-clutter = keine Linie: anderes in ihren Spalten ist ebenso hell
line-as-bright-as-picture = keine Linie: das Bild ist ebenso hell
line-bright-in-the-dark = Linie: sie ist hell im Dunkeln
line-crosses-most-of-picture = Linie: sie durchquert das Bild fast ganz
line-hardly-rivalled = Linie: sonst ist kaum etwas im Bild
line-in-nearly-all-columns = Linie: sie ist in fast allen Spalten
line-outshines-picture = Linie: sie überstrahlt das Bild
line-stands-alone = Linie: sie steht nahezu allein
line-widths-do-not-ascend = die Höchstbreite muss die Mindestbreite übersteigen
line-without-points = keine Linie: keine Spitzen setzen sich von Spalte zu Spalte fort
look-for-line-again = Linie erneut suchen
looks-for-line-again = Linie wird erneut gesucht
piece-left-beneath-line = verworfen: geht unter der Linie weiter
piece-left-dim-as-clutter = verworfen: so dunkel wie das Übrige
piece-left-without-line = verworfen: keine Linie im Bild
piece-taken-brighter-than-clutter = genommen: heller als das Übrige
piece-taken-line-goes-on = genommen: die Linie geht darin weiter
piece-taken-most-light = genommen: das meiste Licht
set-what-line-is-like = legte fest, wie die Laserlinie aussieht
part-add-datum-or-lock = einen Bezug hinzufügen, oder { $name } sperren
part-alignment-leaves-free =
    die Ausrichtung lässt dem Werkstück eine { $kind ->
        [turn] Drehung um
       *[shift] Verschiebung entlang
    } { $axis } frei
part-alignment-without-covariance = Die Ausrichtung nennt keine Kovarianz: nichts wird entschieden.
part-arm-errors-unknown = Weder calibration.json noch arm.json sagt, wie gut die Glieder des Arms bekannt sind: Es wird nur die Streuung angegeben und nichts entschieden.
part-best-fit-without-features = eine Besteinpassung braucht Merkmale
part-bodies-there = { $count ->
        [one] sie hat einen Körper
       *[other] sie hat { $count } Körper
    }
part-box-corners-must-ascend = die zweite Ecke eines Quaders muss entlang jeder Achse jenseits der ersten liegen
part-calibration-without-covariance = calibration.json enthält keine Kovarianz: Es wird nur die Streuung angegeben und nichts entschieden.
part-cells-with-coarse-facets = { $count ->
        [one] Eine Zelle liegt
       *[other] { $count } Zellen liegen
    } auf Facetten, die bis zu { $worst } von der gekrümmten Fläche entfernt sind, für die sie stehen; zulässig ist { $most }, ein Fünftel der Toleranz. Dort wird nichts entschieden: das Werkstück feiner oder als STEP exportieren.
part-cloud-has-scatter-only = Eine Punktwolke sagt nicht, was Kalibrierung und Arm zu ihrer Unsicherheit beitragen: nur die Streuung ist bekannt, und nichts wird entschieden. Stattdessen die Aufnahme angeben.
part-coordinate-without-axis = eine Koordinate braucht eine Achse: x, y oder z
part-correlation-unknown = calibration.json enthält keine Fehler der Glieder: Die des Arms gelten als unabhängig von denen des Sensors; ihre Korrelation ist unbekannt.
part-datums-do-not-fix-it = die Bezüge legen sie nicht fest
part-datums-without-primary = Bezüge brauchen einen primären
part-dimension-features =
    das Maß { $kind } gehört zu { $count ->
        [one] einem Merkmal
       *[other] { $count } Merkmalen
    }
part-dimension-of-one-feature-twice = die beiden Merkmale müssen verschieden sein
part-direction = ({ $x }, { $y }, { $z })
part-direction-without-length = eine Richtung darf nicht null sein
part-encoder-noise-unknown = Das Rauschen der Winkelgeber ist unbekannt: arm.json nennt 0, und keine Kalibrierung hat es geschätzt. Es wird nur die Streuung angegeben und nichts entschieden.
part-export-without-mirroring = Das Werkstück ungespiegelt exportieren oder das der anderen Seite angeben
part-facets-are-coarse = Die Facetten des Werkstücks sind bis zu { $worst } von der gekrümmten Fläche entfernt, für die sie stehen
part-facets-finer = Das Werkstück mit feineren Facetten oder als STEP exportieren
part-facets-permitted = zulässig ist ein Fünftel der Toleranz, { $most }
part-feature-has-points =
    Merkmal { $feature }: { $count ->
        [0] kein Punkt
        [one] ein Punkt
       *[other] { $count } Punkte
    } des Scans darauf
part-feature-not-determined =
    Merkmal { $feature }: { $count ->
        [one] ein Punkt legt
       *[other] { $count } Punkte legen
    } es nicht fest
part-feature-seen-flat = Merkmal { $feature } wurde fast überall mehr als 70° von seiner Normalen aus gesehen; seine Punkte werden trotzdem genommen.
part-feature-unknown = { $place }: Es gibt kein Merkmal { $feature }; die Merkmale sind { $names }
part-features-by-scan = Merkmale sollen mit dem Scan gemessen werden
part-features-by-touch = Merkmale sollen mit dem Taster gemessen werden
part-fit-is-not-fixed = die gescannte Fläche legt das nicht fest
part-fit-leaves-free = Die Bestanpassung lässt frei: { $motions }
part-fits-mirror-image = Der Scan passt zum Spiegelbild des Werkstücks (im Mittel { $mirrored }), nicht zum Werkstück ({ $residual })
part-fits-not = Der Scan passt nicht zum Werkstück: die Hälfte der Punkte ist weiter als { $residual } entfernt, und { $share } liegen in der Nähe
part-fits-not-remedy = Die Einheit des Werkstücks prüfen, und ob es gespiegelt ist; oder eine Ausrichtung angeben
part-fits-not-share = Der Scan passt nicht zum Werkstück: { $share } der Punkte liegen in der Nähe
part-fits-not-why = ein anderes Werkstück, ein gespiegeltes oder eine andere Einheit
part-folder-has = einen Ordner mit { $program }, calibration.json, arm.json, scans und touches.csv angeben
part-form-limit-below-noise = { $dimension }: Ein Grenzwert von { $limit } ist mit diesem Sensor nicht entscheidbar, dessen Rauschen allein { $noise } zeigt.
part-free-shift = eine Verschiebung längs { $axis }
part-free-turn = eine Drehung um { $axis } durch { $place }
part-give-unit-of-it = Die Einheit des Werkstücks angeben (--unit { $unit }) oder den Scan dieses Werkstücks allein
part-has-bodies = Die Datei hat { $count } Körper, die zusammen genommen werden; mit --body einen wählen.
part-has-no-such-body = { $path } hat keinen Körper { $body }
part-id-twice = { $place }: Die Kennung { $id } kommt zweimal vor
part-is-of-size = Das Werkstück ist { $size } groß, der Scan misst { $scan } über alles
part-length-is-range = length_mm von { $kind } ist ein Bereich: [von, bis] entlang der Richtung
part-lock-or-scan-more = Die Bewegung ({ $names }) mit --lock festhalten oder weitere Flächen scannen
part-lower-above-upper = lower ({ $lower }) darf nicht über upper ({ $upper }) liegen
part-means-disagree = Merkmal { $feature }: Laserlinie und Taster unterscheiden sich um { $off } in Durchmesser oder Breite, bei einer Standardunsicherheit von { $u }.
part-measure-more-of-feature = mehr davon messen
part-no-folder = { $folder }: Diesen Ordner gibt es nicht
part-no-scans = { $program }: Es gibt keinen Scan
part-no-such-size = { $place }: { $kind } gibt es bei { $feature } nicht
part-no-touches = { $program }: Es gibt keine Antastungen
part-nominal-lacks = dem Nennmaß von { $kind } fehlt { $names }
part-not-found = das Werkstück wurde nicht gefunden: Das Gemessene liegt { $off } neben seinen Nennmerkmalen
part-not-found-remedy = Programm, Antastungen und Scan prüfen, oder drei Bezüge antasten
part-not-found-why = es ist ein anderes Werkstück, oder zu wenig davon wurde gemessen
part-points-on-too-small-piece = sie liegen auf einem zu kleinen Stück davon
part-position-needs-upper = eine Position braucht einen oberen Grenzwert
part-put-scans = Aufnahmen in { $folder } legen, oder --scan angeben
part-put-touches = sie in { $file } ablegen, oder --touches angeben
part-range-must-ascend = ein Bereich muss ansteigen
part-reference-is-no-plane = { $place }: reference muss eine Ebene sein
part-robot-noise-unknown = Wie gut ein Roboter seine Posen kennt, ist nicht angegeben: Es wird nur die Streuung angegeben und nichts entschieden.
part-scan-does-not-show-it = der Scan zeigt es nicht dort, wo das Programm es hat
part-scan-feature-or-check-alignment = es scannen, oder Nennmaß und Ausrichtung prüfen
part-second-pose-fits = Eine zweite Lage passt etwa gleich gut ({ $second } neben { $first }): das Werkstück ist fast symmetrisch. Kommt es auf die Lage an, eine Ausrichtung angeben.
part-slot-direction-along-normal = direction und normal eines Langlochs müssen verschieden sein
part-slot-length-is-one-number = length_mm eines Langlochs ist eine Zahl: seine Gesamtlänge
part-slot-shorter-than-wide = ein Langloch muss länger als breit sein
part-spread-touches = die Antastungen über das Merkmal verteilen
part-temperature-not-compensated = Die Temperatur ist nicht berücksichtigt: Längen gelten bei der Temperatur des Werkstücks.
part-tertiary-without-secondary = ein tertiärer Bezug braucht einen sekundären
part-too-few-touches =
    { $file }: Merkmal { $feature } hat { $count ->
        [0] keine Antastung
        [one] eine Antastung
       *[other] { $count } Antastungen
    }, nötig sind { $least }
part-touch-far-off = { $place }: Die Antastung liegt { $away } neben Merkmal { $feature }; sie wird ausgelassen.
part-touch-it-more = es an mindestens { $least } Stellen antasten
part-touch-on-other = { $place }: Die Antastung liegt { $away } neben Merkmal { $feature } und auf { $other }; sie wird ausgelassen.
part-touch-on-wrong-side = { $place }: Die Antastung liegt auf der falschen Seite von Merkmal { $feature }; sie wird ausgelassen.
part-touches-at-one-place = Merkmal { $feature }: Seine { $count } Antastungen liegen an einer Stelle
part-touches-extent = sie liegen innerhalb von { $extent }
part-unit-of-other-kind = { $unit } ist keine Einheit von { $kind }
tilt-board-against-reflection-or-shorten-exposure = die Tafel so neigen, dass sie kein Licht in die Kamera spiegelt, oder kürzer belichten
away = nur { $min } entfernt
axes = Achsen
axis-component = Achse { $axis }
axis-level = Achse gegen die Waagerechte
back = Zurück
back-face = Rückseite
back-places = Zurück zu den Positionen
back-points = Zurück zu den Punkten
background-work = Hintergrundarbeit
background-work-remedy = Das Protokoll unten ansehen und das Diagnosepaket senden. Die Station neu starten, wenn ein Teil weiter scheitert.
background-work-runs =
    { $count ->
        [one] Ein Teil läuft.
       *[other] Alle { $count } Teile laufen.
    }
background-work-why = Sie hält aktuell, was Browser zeigen, und überwacht Geräte, Scans und den Datenträger.
backup = Sicherung
backup-is-in = Die Sicherung liegt in { $folder }.
backup-being-made-already = Es läuft bereits eine Sicherung
backup-needs = Die Sicherung benötigt { $total }
backup-replaces-nothing = eine Sicherung überschreibt nichts
bad = Schlecht
ball-bars = Kugelstäbe
ball-bars-lengths = Längen der Kugelstäbe
ball-diameter = Ø { $diameter }
bar-end-of-position = Kugelstab { $name } { $position }, Ende { $end }
bar-has-two-ends = ein Kugelstab hat zwei Enden
bar-named = Kugelstab { $name }
bar-not-placed = der Kugelstab wurde in { $count } von { $needed } Lagen gemessen
bar-position-arm-json-ends-lie = Kugelstab { $name }, Lage { $position }: Nach arm.json liegen seine Enden { $measured } auseinander, angegeben sind { $length }
bar-position-has-ends = { $path }: Kugelstab { $bar }, Lage { $position } hat die Enden { $ends }
bar-without-sphere-diameter = die Datei des Kugelstabs nennt keinen Durchmesser seiner Kugeln: sphere_diameter_mm eintragen
bars-end = Stabende { $value }
bars-length-hardly-known = Kugelstab { $bar }: seine Länge ist auf ± { $uncertainty } (k = 1) angegeben, was den Maßstab des Arms kaum bestimmt: prüfen, ob standard_uncertainty_mm in mm angegeben ist
bars-lengths-coordinates-scatter-without-them = mit den Längen der Kugelstäbe streuen die Koordinaten um { $scatter }, ohne sie um { $without }
bars-lengths-points-scatter-without-them = mit den Längen der Kugelstäbe streuen die Punkte um { $scatter }, ohne sie um { $without }
batch-calibration-unusable = Die Kalibrierung { $id } kann nicht verwendet werden
batch-choose-of-same-arm = Wählen Sie Kalibrierungen aller Sensoren, die mit derselben arm.json entstanden
batch-choose-quantity = Eine von { $names } wählen
batch-different-arms = Die Kalibrierungen der Sensoren haben verschiedene arm.json
batch-first-arm-for-all = Die Kalibrierungen der Sensoren haben verschiedene arm.json; die von { $sensor } gilt für alle
batch-give-address = Als tcp://host:8786 angeben
batch-give-period = Einen Tag, einen Monat oder ein Jahr angeben, oder zwei mit .. dazwischen, zum Beispiel 2026-05-13, 2026-05 oder 2026-05-01..2026-06-15
batch-install-dask = Installieren mit: pip install 'crenel[fleet]'
batch-name-a-place = Das Archiv oder den Datenordner einer Station angeben, oder worin mehrere Archive sind
batch-name-another-output = Mit -o einen eigenen Ordner angeben
batch-name-calibration = Auch den Ort angeben, der sie hat, oder mit --calibration eine andere
batch-no-address = { $address } ist keine Adresse eines Schedulers
batch-no-calibration = Die Kalibrierung { $id } ist an keinem der Orte
batch-no-certificates = TLS braucht Zertifikate in den Einstellungen von Dask
batch-no-dask = Die Arbeit an vielen Aufnahmen braucht Dask
batch-no-marker = { $name } fehlt darin
batch-no-period = { $period } ist kein Zeitraum
batch-no-place = { $place } ist weder Archiv noch Datenordner und enthält kein Archiv
batch-no-quantity = { $quantity } ist keine Kenngröße einer Prüfung, die neu gemessen werden kann
batch-no-recording = Die Aufnahme des Scans { $id } ist weder im Archiv noch im Datenordner ihrer Station
batch-no-scheduler = Der Scheduler { $address } antwortet nicht
batch-none-named = Weder Archiv noch Datenordner ist angegeben, und hier gibt es keine station.toml
batch-other-device = Die Kalibrierung { $id } gehört zu einem anderen Arm oder Sensor als der Scan { $scan }
batch-other-version = Die Worker haben Crenel { $there }, hier läuft Crenel { $here }
batch-output-in-source = { $place } liegt innerhalb der gelesenen Datensätze
batch-run-again-nothing-done-twice = Den Scheduler und denselben Befehl wieder starten: Erledigtes wird nicht wiederholt
batch-same-sensor = { $id } und { $other } sind Kalibrierungen desselben Sensors
batch-scheduler-away = Die Verbindung zum Scheduler { $address } ist abgebrochen; die Arbeit geht weiter, sobald er wieder da ist.
batch-scheduler-back = Der Scheduler ist wieder da.
batch-start-scheduler = Starten mit: dask scheduler
batch-store-away = { $why }; die Arbeit wartet so lange
batch-store-back = Der Speicher ist wieder da.
batch-waited = er wurde { $time } lang erwartet
batch-worker-failed = Ein Worker ist mit { $error } ausgefallen
bayer-needs-wavelength = { $bayer } braucht { $wavelength }: gemessen werden die Pixel dieser Farbe
before = Vorher
before-after = Vorher und nachher
before-after-identification = Vor und nach der Identifikation
before-mark = vorher
before-poses-were-changed-since = Nicht mehr aktuell: Die Posen wurden geändert.
began-again = neu begonnen
began-backup = Sicherung gestartet
began-cloud = Punktwolke begonnen
began-demonstration = Vorführung begonnen
began-resumed-arm-check = Armprüfung begonnen oder fortgesetzt
began-resumed-calibration = Kalibrierung begonnen oder fortgesetzt
began-resumed-performance-test = hat eine Leistungsprüfung begonnen oder fortgesetzt
began-resumed-verification = Verifizierung begonnen oder fortgesetzt
began-seat = Position begonnen
begin-again = Neu beginnen
begin-new-one = Eine neue beginnen
begun = Begonnen
behind = von hinten
being-recorded = der Scan wird gerade aufgezeichnet
belongs-another-step-calibration-stands =
    { $step ->
        [devices] Das gehört zu einem anderen Schritt; die Kalibrierung ist beim Schritt „Geräte“.
        [setup] Das gehört zu einem anderen Schritt; die Kalibrierung ist beim Schritt „Einrichten“.
        [touch] Das gehört zu einem anderen Schritt; die Kalibrierung ist beim Schritt „Antasten“.
        [place] Das gehört zu einem anderen Schritt; die Kalibrierung ist beim Schritt „Halten“.
        [capture] Das gehört zu einem anderen Schritt; die Kalibrierung ist beim Schritt „Aufnehmen“.
        [solve] Das gehört zu einem anderen Schritt; die Kalibrierung ist beim Schritt „Kalibrieren“.
       *[review] Das gehört zu einem anderen Schritt; die Kalibrierung ist beim Schritt „Beurteilen“.
    }
belongs-another-step-session-stands =
    { $step ->
        [seat] Das gehört zu einem anderen Schritt; die Sitzung ist beim Schritt „Tastkugel einsetzen“.
        [swing] Das gehört zu einem anderen Schritt; die Sitzung ist beim Schritt „Messarm schwenken“.
       *[result] Das gehört zu einem anderen Schritt; die Sitzung ist beim Schritt „Ergebnis“.
    }
belongs-another-step-verification-stands =
    { $step ->
        [gauge] Das gehört zu einem anderen Schritt; die Verifizierung ist beim Schritt „Prüfnormal wählen“.
        [touch] Das gehört zu einem anderen Schritt; die Verifizierung ist beim Schritt „Prüfnormal antasten“.
        [scan] Das gehört zu einem anderen Schritt; die Verifizierung ist beim Schritt „Prüfnormal scannen“.
       *[review] Das gehört zu einem anderen Schritt; die Verifizierung ist beim Schritt „Ergebnis“.
    }
beyond-limit = Grenzwert überschritten
bits-expected = erwartet werden 8 oder 16 Bit
bits-per-pixel = { $bits } Bit je Pixel
block-as-drawn = wie gezeichnet, gefertigt auf ± { $value }
block-certificate = Zertifikat des Blocks
block-certified-by-readings =
    { $count ->
        [one] Koordinaten aus einem Messwert; die größte Standardunsicherheit ist { $largest } (k = 1).
       *[other] Koordinaten durch Ausgleichung von { $count } Messwerten; die größte Standardunsicherheit ist { $largest } (k = 1).
    }
block-certified-by-touches = Koordinaten durch Ausgleichung von { $touches } Antastungen und { $readings } Messwerten; die größte Standardunsicherheit ist { $largest } (k = 1).
block-corner =
    { $level ->
        [crest] Zinnenoberseite { $number }
        [floor] Nutgrund { $number }
       *[base] Grundfläche
    }, { $place ->
        [L-front] vorn links
        [R-front] vorn rechts
        [L-back] hinten links
       *[R-back] hinten rechts
    }
block-dimension =
    { $name ->
        [base] Höhe der Böden über der Unterseite
        [depth] Tiefe von vorn bis hinten
        [height] Höhe der Kronen über den Böden
       *[width] Breite von links bis rechts
    }
block-dimensions-undetermined = Weder Bilder noch Antastpunkte zeigen vom Block: { $names }; dort zählt die Toleranz.
block-edges-estimated = Vom Block ist nur die Zeichnung bekannt: seine Kanten wurden mit der Kalibrierung geschätzt. Sie liegen bis zu { $beside } neben der Zeichnung, mit einer Standardunsicherheit von { $known }, die in allen Posen dieselbe ist.
block-known-by-drawing = Der Block ist nur durch seine Zeichnung bekannt. Vermessen ist er besser bekannt.
block-measured-to = gemessen auf { $value } (k = 1)
block-needs-depth = Zinnenoberseiten und Nutgründe des Zinnenkörpers müssen zugleich scharf sein.
block-wider-than-view = ein Zinnenkörper von { $width } ist breiter als { $most }, die das Bild mit Spielraum für die Hand ganz zeigt
board-bar = Diese Linie ist { $length } lang; sonst hat der Drucker die Seite skaliert: mit 100 % drucken.
board-bends-over-pattern-allowed = Die Tafel ist über das Muster um { $bend } durchgebogen; das ist berücksichtigt.
board-bends-over-pattern-flat-expected = Die Tafel ist über das Muster um { $bend } durchgebogen; erwartet wurde eine Ebenheit von { $flatness }.
board-fewer-or-smaller-squares = Weniger oder kleinere Felder wählen.
board-fewer-squares-or-lower-first-id = Weniger Felder nehmen, oder eine kleinere Nummer des ersten Markers.
board-has-4-to-60-squares = ein Brett hat 4 bis 60 Felder in jeder Richtung und höchstens 1000 Marker
board-has-corners = „{ $name }“ hat { $columns } × { $rows }
board-has-corners-why = „{ $name }“ hat { $columns } × { $rows }, und { $why }
board-larger-page-or-fewer-squares = Ein größeres Papierformat oder weniger oder kleinere Felder wählen.
board-has-ids = „{ $name }“ hat die Nummern { $first } bis { $last }
board-has-squares = „{ $name }“ hat { $columns } × { $rows } Felder
board-is-otherwise = „{ $name }“ ist nach legacy_pattern umgekehrt angeordnet
board-does-not-fit-a0 = ein Muster von { $width } × { $height } passt nicht auf A0
board-does-not-fit-page = ein Muster von { $width } × { $height } mit Prüfstrecke und Rändern passt nicht auf { $page }
board-measure-whole-pattern = Das ganze Muster messen, vom ersten bis zum letzten Feld, und mit 100 % drucken.
board-measures-otherwise = { $measured } wurden gemessen, wo { $expected } gedruckt werden sollten
board-needs-ids-beyond = ihre Marker brauchen die Nummern { $first } bis { $last }, und { $dictionary } endet bei { $most }
board-nominal-size = Das Muster ist { $width } breit und { $height } hoch. Beides am Ausdruck messen: die zwei Längen skalieren das Brett.
board-partly-out-of-picture = die Tafel liegt zum Teil außerhalb des Bildes
board-print-and-glue = Auf { $page } mit 100 % drucken, auf mattes Papier, und auf eine ebene Platte kleben.
board-printed-side = Tafel (bedruckte Seite)
board-seen-at-a-slant = die Tafel ist schräg zu sehen, unter etwa { $slant }: ihre Felder erscheinen { $times }-mal so breit wie hoch
board-states-dictionary = „{ $name }“ nennt { $dictionary }
board-tilted-most-between-pictures = die Tafel ist in den { $seen } Bildern höchstens um { $tilt } gegeneinander geneigt
both-devices-answer-go = Beide Geräte antworten. Fortfahren.
bridge-must-send-finite-unit-quaternions = Seine Brücke muss Einheitsquaternionen senden, und nichts, solange die Pose unbekannt ist.
brightness = Helligkeit
bring-back-last-backup-delete-under = Aus der letzten Sicherung wiederherstellen oder im Archiv löschen.
bring-block-closer-so-fills-picture = Zinnenkörper näher heranbringen, sodass er das Bild füllt.
bring-block-middle-stripe = Zinnenkörper in die Mitte der Laserlinie bringen.
bring-board-with-markers-into-picture = die Tafel mit ihren Markierungen ins Bild bringen, größer, scharf und gleichmäßig beleuchtet
bring-camera-nearer-to-board = die Kamera näher an die Tafel bringen oder eine Tafel mit größeren Feldern verwenden
bring-front-back-edge-level-into = vordere und hintere Kante einer Höhenstufe ins Bild bringen
bring-joint-reference-switch-arm-off = Gelenk auf seine Referenz bringen und den Messarm aus- und wieder einschalten; tritt es weiter auf, das Datenblatt dieses Messarms wählen
move-joint-to-reference-within-sentence = Gelenk auf seine Referenz bringen und den Messarm aus- und wieder einschalten
bring-more-object-into-picture = mehr vom Objekt ins Bild bringen
bring-more-object-into-picture-sharp = mehr vom Objekt ins Bild bringen, scharf und gut beleuchtet
bring-more-of-board-into-picture = mehr von der Tafel ins Bild bringen, scharf und gleichmäßig beleuchtet
bring-part-into-sensors-range = ein Teil in den Messbereich des Sensors bringen
bring-part-into-sensors-range-if = Das Teil in den Messbereich des Sensors bringen; liegt es darin, die Belichtung prüfen.
bring-whole-board-into-picture = die ganze Tafel ins Bild bringen
bring-whole-board-into-picture-sharp = die ganze Tafel ins Bild bringen, scharf, gleichmäßig beleuchtet und um höchstens 60° geneigt
bring-whole-object-into-view-front = das ganze Objekt ins Bild bringen, von vorn oben, und gleichmäßig beleuchten
broker = Broker
brought-a-datasheet-back = holte ein Datenblatt zurück
but-what-marked-below-needs-attention = Das unten Markierte ist aber zu beachten.
pictures-by-themselves-only-for-robot-and-board = von selbst werden Bilder nur von einer Tafel aufgenommen, und mit einem Roboter ohne Tastkugel
byte-is-not-utf-8 = Byte { $byte } ist kein gültiger UTF-8-Text
bytes-but-no-packet =
    { $count ->
        [one] { $count } Byte kam von { $url }, aber kein Paket eines Messarms mit Winkelgebern
       *[other] { $count } Bytes kamen von { $url }, aber kein Paket eines Messarms mit Winkelgebern
    }
calibrate = Kalibrieren
calibrate-again = Neu kalibrieren
calibrate-camera-and-laser-together = Kamera, Anbau und Laser gemeinsam aus diesen Bildern kalibrieren
calibrate-camera-mounting-and-laser = Kamera, Anbau und Laser kalibrieren
calibrate-first = Zuerst kalibrieren
calibrate-first-within-sentence = zuerst kalibrieren
calibrate-sensor-arm-pictures-of-board = Sensor am Messarm kalibrieren: Bilder eines Schachbretts von verschiedenen Seiten aufnehmen.
calibrate-sensor-arm-touch-object-then = Sensor am Messarm kalibrieren: Objekt antasten, dann einige Bilder aufnehmen.
calibrate-sensors-again-their-place-belongs = Die Sensoren neu kalibrieren: Ihre Lage wurde mit dem bisherigen Messarm bestimmt.
calibrate-this-sensor = Diesen Sensor kalibrieren
calibrate-without-the-laser = Ohne Laser kalibrieren
calibrated = Kalibriert
calibrated-distance-camera = Kalibrierter Abstand von der Kamera
calibrating = Kalibrierung läuft
calibration = Kalibrierung
calibration-acceptance-test-no-characteristic-iso = Dies ist eine Kalibrierung, keine Annahmeprüfung: Es werden keine Kenngrößen nach ISO 10360-8 oder ISO 10360-12 angegeben. Den Scanner prüft eine Verifizierung an Prüfnormalen.
calibration-not-accepted-at-station = Diese Kalibrierung wurde nicht an einer Station angenommen.
calibration-age-and-temperature = { $text }, { $ago } alt; Frist { $limit }, zulässiger Temperaturunterschied { $change } (jetzt { $now }).
calibration-arm = die Kalibrierung gilt für den Messarm { $known }
calibration-cannot-read = Die Kalibrierung { $name } ist nicht lesbar.
calibration-cannot-shown = die Kalibrierung { $session_id } lässt sich nicht anzeigen
calibration-closed-start-new-one = Diese Kalibrierung ist abgeschlossen. Eine neue starten.
calibration-computed = Die Kalibrierung ist berechnet.
calibration-due = Die Kalibrierung ist fällig. { $text }
calibration-has-no-covariance = { $file } nennt nicht, wie genau Kamera und Anbau bekannt sind
calibration-has-no-laser-plane = diese Kalibrierung hat Kamera und Anbau, aber noch keine Laserebene
calibration-has-no-picture = Diese Kalibrierung hat kein Bild { $name }.
calibration-has-other-version = Die verwendete Kalibrierung { $name } beruht auf einer anderen Fassung dieses Datenblatts und behält sie: Neu kalibrieren, um diese zu verwenden.
calibration-no-longer-here = Die Kalibrierung von { $name } ist nicht mehr vorhanden
calibration-in-use-unreadable = Die verwendete Kalibrierung ist nicht lesbar: { $error }
calibration-is-for-joints = die Kalibrierung gilt für einen Messarm mit { $joints } Gelenken
calibration-is-for-pixels = die Kalibrierung gilt für { $width } × { $height } Pixel
calibration-is-for-poses = die Kalibrierung gilt für einen Arm, der Posen meldet
calibration-is-for-serial-number = die Kalibrierung gilt für { $serial_number }
calibration-known-here = ihre Kalibrierung ist hier nicht bekannt
calibration-not-kept-any-more = die Kalibrierung in Gebrauch ist für diese Geräte keine mehr, die nur Kamera und Anbau hat
calibration-pose = die Kalibrierpose
calibration-report = Kalibrierbericht
calibration-not-to-be-used-findings-say-what = Diese Kalibrierung sollte nicht verwendet werden. Die Befunde nennen die Abhilfe.
calibration-under-way-go-where-stands = Eine Kalibrierung läuft. Beim aktuellen Schritt fortfahren.
calibration-use = Die Kalibrierung wird verwendet
calibration-use-cannot-read = Die verwendete Kalibrierung ist nicht lesbar
calibration-utc = Kalibrierung { $now } UTC
calibration-valid-verified-scan-part = Die Kalibrierung ist gültig und verifiziert. Das Teil scannen.
calibration-not-verified-yet = Diese Kalibrierung ist noch nicht verifiziert.
calibration-with-total = { $name }, { $total } (k = 1)
calibrations-unknowns-did-settle-what-seen = die Unbekannten der Kalibrierung konvergieren mit diesen Bildern und Antastpunkten nicht
camera = Die Kamera { $source }
camera-address-not-known = Es gibt kein Gerät mit der Adresse oder dem Namen { $address }
camera-and-laser-apart-on-a-board-only = Kamera und Laser werden nur auf einem Schachbrett getrennt kalibriert
camera-and-mounting = Kamera und Anbau
camera-and-mounting-are-kept = Kamera und Anbau sind aus der vorigen Kalibrierung beibehalten; neu ist nur die Laserebene.
camera-and-mounting-are-stored = Kamera und Anbau sind in Gebrauch und liegen im Archiv. Zum Scannen den Laser hinzufügen: Bilder aufnehmen, in denen seine Linie über die Tafel verläuft.
camera-answers-but-does-not-open = { $title } antwortet, lässt sich aber nicht öffnen ({ $reason })
camera-cannot-do = { $title } unterstützt { $key } = { $value } nicht; möglich ist { $given }
camera-clock-jumped = { $title } nennt eine andere Zeit als eben: Sie wurde neu gestartet, oder ihre Uhr wurde gestellt
camera-control-lost = { $title } gehorcht diesem Programm nicht mehr
camera-looks-along-laser-plane-deg = die Kamera blickt nahezu in der Laserebene, { $angle } Abweichung (Grenzwert { $limit })
camera-must-look-stripe-side-check = die Kamera muss die Laserlinie von der Seite sehen: Aufbau des Sensors prüfen
camera-needs-two-levels-four-sides = für eine Kamera sind zwei Höhenstufen und vier Seiten der Zinnen nötig
camera-refused-settings = { $title } hat eine Einstellung abgelehnt ({ $reason })
camera-sends-colour-not-raw = das Bild ist farbig, laut station.toml (bayer) aber ein Rohbild
camera-sends-several-profiles = { $title } sammelt { $count } Profile in einem Puffer, aber jedes braucht einen eigenen Zeitstempel
camera-used-by-other-program = { $title } wird von einem anderen Programm benutzt
cameras-are = Vorhandene Kameras: { $names }.
cameras-matrix-needs-least-six-crests = für die Kameramatrix sind mindestens sechs nötig, auf Zinnenoberseiten und Nutgründen
camera-parameters-do-not-converge = die Kameraparameter konvergieren mit den Kanten im Bild nicht
cameras-pixels-come-out-out-square = Die Pixel der Kamera weichen um { $difference } von der quadratischen Form ab; bei heutigen Sensoren sind sie quadratisch (Grenzwert { $limit }).
can-read-more-than-one-way = es ist nicht eindeutig
can-written = Der Datenordner ist beschreibbar.
cancel-calibration = Kalibrierung abbrechen
cancel-session = Sitzung abbrechen
cancel-test = Prüfung abbrechen
cancel-verification = Verifizierung abbrechen
cannot-be-copied = { $path } lässt sich nicht kopieren
cannot-be-opened-for-writing = { $path } lässt sich nicht zum Schreiben öffnen
cannot-deleted-now = Löschen ist jetzt nicht möglich
cannot-hidden-now = Ausblenden ist jetzt nicht möglich
cannot-read = Die Kalibrierung ist nicht lesbar: { $text }
password-file-cannot-be-read = { $password_file } ist nicht lesbar
cannot-shown = { $name } lässt sich nicht anzeigen: { $error }
cannot-be-displayed = { $name } lässt sich nicht anzeigen.
cannot-start = { $title }: Start nicht möglich
cannot-written = Der Datenordner ist nicht beschreibbar: { CLAUSE($trouble) }.
capital = { CAPITAL($text) }
capture = Aufnehmen
catalogue-away = Der Katalog { $place } ist jetzt nicht benutzbar
catalogue-check-folder = Prüfen Sie, ob es seinen Ordner gibt und er beschrieben werden kann; nichts geht verloren, und das Sammeln geht von selbst weiter
catalogue-check-user = Prüfen Sie den Benutzer, password_file und den Namen der Datenbank in [catalogue], und ob die Datenbank angelegt wurde; nichts geht verloren, und das Sammeln geht von selbst weiter
catalogue-give-address = Geben Sie sqlite:///katalog.db oder postgresql://benutzer:passwort@rechner/name an
catalogue-in-memory = sie nennt keine Datei, und was im Arbeitsspeicher liegt, geht verloren
catalogue-let-user-own = Machen Sie den Benutzer zum Eigentümer der Datenbank oder ihres Schemas; nichts geht verloren, und das Sammeln geht von selbst weiter
catalogue-newer = Der Katalog { $place } stammt von einer neueren Version von Crenel
catalogue-no-address = { $url } ist keine Adresse eines Katalogs
catalogue-tried-again = Prüfen Sie seinen Server und seine Festplatte; nichts geht verloren, und das Sammeln geht von selbst weiter
centre = Mittelpunkt { $axis }
centre-m = Mittelpunkt, µm
centre-radius-cannot-be-separated = Mittelpunkt und Radius lassen sich nicht trennen
centres-of-articulations-or-none =
    { $title }: { $count ->
        [one] der Mittelpunkt von { $count } Stellung
       *[other] die Mittelpunkte von { $count } Stellungen
    } von oben (x, y) und von der Seite (x, z), { $factor }-fach vergrößert. Der Kreis ist die kleinste Kugel um sie mit dem Durchmesser { $diameter }: die Lageabweichung. { $others ->
        [yes] Offene Punkte: Mittelpunkte mit dem kalibrierten Durchmesser.
       *[no] { "" }
    }
certificate = Kalibrierschein
certificate-named = Kalibrierschein { $certificate }
certificate-date-unreadable = { $until } ist kein Datum; die Gültigkeit des Kalibrierscheins wird als 2027-03-31 angegeben
certificate-days-reversed = nach der Uhr der Station begann die Prüfung am { $begun } und endete am { $ended }; der Kalibrierschein braucht beide Tage in ihrer Reihenfolge
certificate-has-lengths = der Kalibrierschein nennt: { $names }
certificate-has-no-length = der Kalibrierschein nennt keine Länge
certificate-issued-later = Der Kalibrierschein soll am { $day } ausgestellt sein, was noch bevorsteht: Datum berichtigen.
certificate-must-be-known-to = ein Zertifikat ist auf { $most } bekannt
certificate-needs-country = der Kalibrierschein braucht das Land des Laboratoriums als zwei Großbuchstaben, nicht { $country }
certificate-needs-date = der Kalibrierschein braucht den Tag der Prüfung, und { $text } ist keiner
certificate-needs-laboratory = der Kalibrierschein braucht den Namen des Laboratoriums
certificate-needs-one =
    { $path }: { $what ->
        [form] Eine Form
        [length] Eine Länge
       *[diameter] Ein Durchmesser
    } wird gebraucht, gefunden: { $count ->
        [0] nichts
       *[other] { $count }
    }
certificate-not-signed = dieser Kalibrierschein ist nicht signiert
certificate-not-validated = dieser Kalibrierschein ist nicht signiert. Er folgt dem Schema des DCC 3.3.0, wurde aber selbst nicht dagegen geprüft: vor der Ausgabe prüfen
certificate-out-of-date = der Kalibrierschein des Prüfkörpers galt bis { $until }
certificate-says = laut Kalibrierschein { $square }
certificate-set-aside = { $file }: { CLAUSE($why) }.
certificate-not-trusted-here = dem Zertifikat des Empfängers wird hier nicht vertraut
certificate-valid-until = { $name }, gültig bis { $date }
certificate-without-uncertainty = der Kalibrierschein des Prüfkörpers nennt keine Unsicherheit
certificate-without-values = Kein Wert konnte angegeben werden.
certified-size-impossible = { $name } ist { $size }, bekannt auf { $known } (k = 1): Das ist kein Maß eines Normals
certified-size-without-uncertainty = { $name } hat keine Unsicherheit mit Erweiterungsfaktor
certified-values = Laut Kalibrierschein
certify-the-block = Block vermessen
change = Änderung
change-one-them = eine von beiden ändern
change-permissions-place = Zugriffsrechte oder Speicherort ändern
change-place = Speicherort ändern
change-them-in-file = ihre Tabellen [sensor.NAME] in { $file } ändern und die Station neu starten
change-theta-of-joint = theta_deg des Gelenks { $joint } in arm.json um { $turn } ändern (bei sign −1 um ebenso viel andersherum)
changed-account = Konto geändert
changed-after-session-had-written = { $name } wurde geändert, nachdem diese Sitzung die Datei geschrieben hatte
changed-logo = Logo der Berichte geändert
changed-notifications = Benachrichtigungen geändert
changed-own-password = eigenes Passwort geändert
changed-settings = Einstellungen geändert
channel-beyond-others = { $colour } über die anderen Kanäle hinaus
channel-grey = Grau
channel-mean-of-all = Mittel aller Kanäle
channel-of-colour =
    { $colour ->
        [red] Rot
        [green] Grün
       *[blue] Blau
    }
channel-raw = Pixel der Farbe { $colour } von { $pattern }
channel-share = { $share } { $colour }
charuco-squares-mm-markers = ChArUco-Tafel, { $columns } × { $rows } Felder zu { $square }, { $dictionary }
check-address-and-port = Adresse und Port in station.toml prüfen.
check-address-below-try = Adresse unten prüfen und testen.
check-address-network = Adresse und Netz prüfen.
check-address-network-and-power = Adresse und Netz prüfen; sicherstellen, dass die Kamera eingeschaltet ist.
check-again = Erneut prüfen
check-ago-failed = Prüfung nicht bestanden ({ $ago } her): { $text }
check-arm = Messarm prüfen
check-arm-again = Messarm erneut prüfen
check-arm-json-against-arm-signs = arm.json mit dem Messarm vergleichen: Vorzeichen, Einheiten, Längen, Reihenfolge der Gelenke; auch die Punkte dieser Position prüfen
check-arm-play-tip-sensor-loose = Messarm auf Spiel, Tastkugel und Sensor auf festen Sitz prüfen; ruhig halten.
check-arm-power-and-no-second-program = Prüfen Sie die Stromversorgung des Messarms, und dass kein anderes Programm seine Impulse startet.
check-arm-software-and-network = prüfen Sie die Software des Arms und die Verbindung zu ihm
check-arm-tip-object-sensor-those = Prüfen, ob Messarm, Tastkugel, Objekt und Sensor die verwendeten sind.
check-arm-url = Die url des Messarms prüfen.
check-arms-cable-then-switch-arm = Kabel des Messarms prüfen, dann den Messarm aus- und wieder einschalten
check-arms-file-lengths-angles-signs = Armdatei prüfen: Längen und Winkel, Vorzeichen und Reihenfolge der Gelenke sowie die Tastkugel; dann prüfen, auf welcher Fläche jeder Punkt angetastet wurde, und den Kalibrierschein des Objekts
check-baud-rate-arm-port-another = Baudrate prüfen; sicherstellen, dass an diesem Anschluss der Messarm und kein anderes Gerät hängt.
check-board-how-exact-certificate-takes = Prüfen, ob es diese Tafel ist und welche Unsicherheit ihr Kalibrierschein angibt.
broker-gives-no-answer = dort antwortet etwas, aber nicht wie ein Broker ohne Verschlüsselung ({ $reason })
broker-speaks-no-tls = was dort antwortet, verschlüsselt nicht ({ $reason })
check-broker-certificate = ca_file unter [mqtt] auf das Zertifikat der Stelle setzen, die das des Brokers ausgestellt hat, und host auf den Namen in dessen Zertifikat. Die Station versucht es selbst erneut.
check-broker-runs = Prüfen, ob der Broker läuft, und host und port unter [mqtt]. Die Station versucht es selbst erneut.
check-broker-tls-off = port unter [mqtt] auf den verschlüsselten Port des Brokers setzen (oft 8883), oder tls und ca_file entfernen. Die Station versucht es selbst erneut.
check-broker-tls-on = tls = true unter [mqtt] setzen, wenn der Broker an diesem Port verschlüsselt, und den Port prüfen. Die Station versucht es selbst erneut.
check-broker-user-and-password = user und password_file unter [mqtt] prüfen. Die Station versucht es selbst erneut.
check-cable-no-other-program-uses = Kabel prüfen; sicherstellen, dass kein anderes Programm das Gerät verwendet.
check-cable-power = Kabel und Stromversorgung prüfen.
check-cable-power-looked-again-itself = Kabel und Stromversorgung prüfen. Das Gerät wird automatisch wieder gesucht.
check-camera-power-cable-network = Prüfen Sie Stromversorgung und Kabel der Kamera, und ob ihre Adresse im Netz dieses Rechners liegt
check-cannot-made = Die Prüfung { $name } ist nicht möglich: { CLAUSE($reason) }.
check-chosen-gauge-tip-arms-own = Prüfen, ob dies das gewählte Prüfnormal ist und die Tastkugel zum Messarm gehört.
check-connection = Verbindung prüfen.
check-devices = Geräte prüfen
check-diameter = { $finding }: Durchmesser prüfen
check-diameter-mm-spheres-take-sphere = diameter_mm der Kugeln prüfen; diese Kugel neu aufnehmen oder ihre Zeilen löschen
check-each-laser-picture-own-pose-laser-not-moved = Prüfen, ob jedes Laserbild zu seiner Pose gehört und bei unbewegtem Sensor aufgenommen wurde und ob der Laser fest sitzt; dann den Fokus des Lasers.
check-each-laser-picture-own-pose-no-reflection = prüfen, ob jedes Laserbild zu seiner Pose gehört, ob der Laser gegenüber der Kamera verstellt wurde und ob die Linie im Bild die des Lasers und keine Reflexion ist
check-encoder-swing-arm-so-every = Winkelgeber prüfen; den Messarm so schwenken, dass sich jedes Gelenk dreht
check-encoders-arm-json-how-points = Winkelgeber, arm.json und die Aufnahme der Punkte prüfen
check-failed = Fehlgeschlagene Prüfung
check-firewall-for-pictures = Lassen Sie die UDP-Pakete der Kamera durch die Firewall dieses Rechners; prüfen Sie packet_size und das Kabel
check-first-page-arm-tip-takes = Zuerst auf der Seite „Messarm und Tastkugel“ prüfen; das dauert eine Minute.
check-folders-owner-whether-disk-mounted = Prüfen, wem der Ordner gehört und ob der Datenträger eingehängt ist.
check-frame-and-tool-of-arm = prüfen Sie, ob Basis oder Werkzeug in der Software des Arms geändert wurde; wenn ja, stellen Sie zurück
check-joints-encoder-cable-then-bring = Winkelgeber und Kabel des Gelenks prüfen, dann den Messarm auf seine Referenz bringen
check-laser-board-camera-not-moved = Prüfen, ob Laser, Tafel und Kamera in Ruhe waren und ob Bild und Pose vom selben Zeitpunkt stammen.
check-laser-exposure-sensors-stripe-axis = Laser, Belichtung und stripe_axis des Sensors prüfen und die Laserlinie über die Mitte des Objekts führen
check-laser-exposure-then-take-new = Laser und Belichtung prüfen, dann ein neues Bild aufnehmen.
check-laser-line-crossed-object-exposure = Prüfen, ob der Laser eingeschaltet war, ob seine Linie das Objekt kreuzte und ob die Belichtung passt; die Pose neu aufnehmen.
check-laser-not-moved-and-no-reflection = prüfen, ob der Laser gegenüber der Kamera verstellt wurde und ob die Linie im Bild die des Lasers und keine Reflexion ist
check-laser-picture-pose-sensor-held = Prüfen, ob das Laserbild zu dieser Pose gehört, ob der Sensor zwischen ihren beiden Bildern ruhig gehalten wurde und ob der Laser fest sitzt; die Pose neu aufnehmen.
check-lasers-interlock-key-switch-capture = Verriegelung und Schlüsselschalter des Lasers prüfen und neu aufnehmen
check-length-mm-bar-ends = length_mm des Kugelstabs { $bar } und seine Enden prüfen
check-length-of-bar-and-coordinates = Länge und Enden des Kugelstabs { $bar } sowie den Maßstab der Koordinaten prüfen
check-length-unless-datasheet-is-as-far-off = { $finding }: Länge prüfen, sofern nicht das Datenblatt des Messarms ebenso weit abweicht
check-not-moved-every-picture-has-readings =
    { $thing ->
        [board] prüfen, ob die Tafel unbewegt blieb und ob zu jedem Bild die Messarmwerte seiner Pose gehören
       *[object] prüfen, ob das Objekt unbewegt blieb und ob zu jedem Bild die Messarmwerte seiner Pose gehören
    }
check-names-of-faces-and-axes = Die Namen der Flächen und die Richtungen der Maschinenachsen prüfen
check-network-load-or-power = Das Netz war unterbrochen, oder die Kamera hat neu gestartet: Prüfen Sie ihr Kabel und ihre Stromversorgung
check-object-certificate-lengths-mm = Prüfen, ob dies das Objekt des Kalibrierscheins ist und ob seine Längen in mm angegeben sind.
check-object-picture-take-picture-again = prüfen, ob dies das Objekt im Bild ist, und das Bild neu aufnehmen
check-object-pictures-every-picture-belongs = prüfen, ob dies das Objekt in den Bildern ist und ob jedes Bild zu seiner Armpose gehört
check-objects-certificate-cameras-flip-setting = Kalibrierschein des Objekts und Spiegelungseinstellung der Kamera prüfen
check-objects-certificate-which-sides-front = Kalibrierschein des Objekts prüfen, ebenso die Lage seiner Vorderseite
check-one-seat = Diese Prüfung gilt für eine einzige Pfanne.
check-options-or-restart-camera = Prüfen Sie die Optionen in station.toml, oder schalten Sie die Kamera aus und wieder ein
check-order-and-signs-of-coordinates = Reihenfolge und Vorzeichen von x_mm, y_mm und z_mm prüfen: das Koordinatensystem muss rechtshändig sein
check-owner-and-permissions = Eigentümer und Zugriffsrechte prüfen; ebenso, ob der Datenträger schreibgeschützt eingehängt ist
check-packet-size-and-network = Setzen Sie packet_size auf einen Wert, den das Netz überträgt, etwa 1400; senken Sie rate_hz; schließen Sie die Kamera direkt an
check-path = Pfad prüfen
check-picture-joint-angles-one-moment = Prüfen, ob Bild und Gelenkwinkel vom selben Zeitpunkt stammen, oder die Pose neu aufnehmen.
check-pictures-joint-angles-own = Prüfen, ob die Gelenkwinkel zu diesem Bild gehören.
check-pictures-joint-angles-those-their = Prüfen, ob die Gelenkwinkel der Bilder zu ihren Posen gehören.
check-pictures-not-mirrored-poses-of-flange = prüfen, ob die Bilder gespiegelt sind und ob die Posen den Flansch im Koordinatensystem des Messarms beschreiben, in mm, qw zuletzt, und nicht die inverse Transformation
check-recorded-limit-set-before-next = Diese Prüfung ist mit ihrem Grenzwert aufgezeichnet. Den Grenzwert vor der nächsten festlegen.
check-robot-interface = Adresse prüfen, und ob die Schnittstelle an der Robotersteuerung freigegeben ist.
check-robot-network = Prüfen, ob die Robotersteuerung eingeschaltet ist; Adresse, Netzwerkkabel und Firewalls prüfen.
check-robot-on-and-not-too-many-clients = Prüfen, ob die Steuerung eingeschaltet ist und nicht zu viele andere Programme mit ihr verbunden sind.
check-sensor = Temperaturfühler prüfen.
check-sensor-address = Korrigieren Sie address oder serial_number in der Tabelle [sensor] von station.toml
check-sensor-numbers = Messfeld, Arbeitsabstand und Schärfentiefe des Sensors prüfen.
check-sensor-path = { "[" }sensor] path prüfen.
check-sensor-source = { "[" }sensor] source prüfen.
check-sensors-cable-close-other-programs = Kabel des Sensors prüfen oder andere Programme schließen.
check-session-taken-arm = prüfen, ob die Sitzung mit diesem Messarm aufgenommen wurde
check-signs-lengths-joints-order = Vorzeichen, Längen und Reihenfolge der Gelenke in arm.json prüfen
check-square-tip-and-board-not-moved = square_mm und die Tastkugel in arm.json prüfen; ebenso, ob die Tafel bewegt wurde
check-station-disk = Datenträger der Station prüfen
check-system-log-and-disk = Systemprotokoll und Datenträger prüfen; den Datenordner nicht verändern
check-tip = Tastkugel prüfen
check-tip-again = Tastkugel erneut prüfen
check-mounted-tip-and-nothing-moved = Die montierte Tastkugel mit der Armdatei vergleichen und prüfen, ob sich nichts bewegt hat; das Armmodell neu identifizieren lassen.
check-tip-one-arms-file-block = Prüfen, ob die Tastkugel die der Armdatei ist und ob Zinnenkörper und Messarm fest standen; dann das Armmodell.
check-tip-one-arms-file-board = Prüfen, ob die Tastkugel die der Armdatei ist und ob Tafel und Messarm fest standen.
check-tip-play-faces-dirt-have = Tastkugel auf Spiel und Flächen auf Schmutz prüfen; das Armmodell prüfen lassen.
check-tips-diameter-block-then-arms = Tastkugeldurchmesser prüfen; ebenso, ob dies der Zinnenkörper ist; dann das Armmodell.
check-unit-arm-and-rows = Einheit, Koordinatensystem und Gelenkwinkel der Zeilen prüfen, und ob es dieser Messarm ist
check-what-robot-sends = Prüfen, was die Steuerung des Arms senden soll.
check-which-arm-plugged = Prüfen, welcher Messarm angeschlossen ist.
check-which-face-each-contact-taken = Prüfen, auf welcher Fläche jeder Punkt angetastet wurde, außerdem die Tastkugel und den Kalibrierschein des Objekts
check-mounted-tip-and-object-not-moved = Montierten Taster prüfen, seinen Durchmesser und seine Länge; ebenso, ob das Objekt nach dem Antasten bewegt wurde.
check-which-tip-mounted-diameter-object = Montierten Taster und seinen Durchmesser prüfen; ebenso, ob dies das gewählte Objekt ist.
check-which-tip-mounted-stylus-straight = Prüfen, welcher Taster montiert ist und ob sein Schaft gerade ist und fest sitzt; seine Lage neu bestimmen lassen und das Objekt neu antasten.
checked = Geprüft
checked-ago = Geprüft ({ $ago } her): { $text }
checked-ago-after-check-due = Zuletzt geprüft: { $ago } her; Frist { $limit }. Eine Prüfung ist fällig.
checking-places-held-out = Kreuzvalidierung der Positionen
checksum-wrong-at-byte = { $name }: Die Prüfsumme bei Byte { $byte } ist falsch
chessboard-inner-corners-squares-mm = Schachbrett, { $columns } × { $rows } innere Ecken, Felder von { $square }
chessboard-seen-several-sides-take-more = Ein Schachbrett muss von mehreren Seiten zu sehen sein: noch { $more } Bilder aufnehmen.
chessboard-seen-several-sides-take-one = Ein Schachbrett muss von mehreren Seiten zu sehen sein: noch ein Bild aufnehmen.
chessboard-x-inner-corners-found = es wurde ein Schachbrett mit { $columns } × { $rows } inneren Ecken gefunden
choice-needs-field-id = Eine Auswahl braucht ein Feld und eine Kennung.
choose-datasheet-or-certificate = Ein Datenblatt wählen, wie es hier heruntergeladen wird, oder den Kalibrierschein einer Kugel; oder ein Formular ausfüllen
choose-another = Einen anderen wählen
choose-another-end = Wählen Sie ein anderes Ende, oder geben Sie das URDF eines einzelnen Arms an
choose-another-name = Einen anderen Namen wählen
choose-another-picture = Ein anderes Bild wählen oder es kleiner speichern
choose-another-place = Einen anderen Speicherort wählen
choose-another-port = Hier und an der Robotersteuerung einen anderen Port wählen.
choose-arm-first = Zuerst den Messarm wählen.
choose-arm-first-within-sentence = zuerst den Messarm wählen
choose-bayer-or-grey-pictures = Unter den Optionen das Bayer-Muster und die Farbe des Lasers wählen, oder die Kamera graue Bilder senden lassen
choose-chessboard-for-poses = { $name } meldet Posen: Wählen Sie ein Schachbrett als Objekt.
choose-datasheet-connect-other = Datenblatt dieses Geräts ({ $name }) wählen oder das andere Gerät anschließen.
choose-first = Zuerst wählen: { $things }.
choose-folder-elsewhere-best-another-disk = Einen anderen Ordner wählen, am besten auf einem anderen Datenträger
choose-gauge = Prüfnormal wählen
choose-gauge-first = Zuerst das Prüfnormal wählen.
choose-gauge-scanned = Das gescannte Prüfnormal wählen
choose-object-before-camera-if-one = das Objekt wählen, das vor der Kamera liegt; ist es dieses, prüfen, ob seine Kanten sauber und unbeschädigt sind
choose-of-several = { $count } zur Wahl
choose-pulse-rate = Wählen Sie eine Rate von { $low } bis { $high }.
choose-one-under-devices = Wählen Sie einen auf der Seite „Geräte“
choose-other-scans = Andere Scans wählen
choose-shorter-one = Einen kürzeren Namen wählen
choose-what-use = Ausrüstung wählen
chose-a-device = wählte ein Gerät
chose-arm = Messarm gewählt
chose-artefact = Prüfkörper gewählt
chose-face = Fläche gewählt
chose-gauge = Prüfnormal gewählt
chose-what-use = Ausrüstung gewählt
chosen-gauge-has = das gewählte Prüfnormal hat { $diameter }
chosen-picture = Das gewählte Bild
clamp-bar-firmly-reach-put-tip = Kugelstab in Reichweite fest einspannen, { $where }, und die Tastkugel in ein Ende setzen.
clamp-cone-ball-seat-about-two = Kegel- oder Kugelpfanne bei etwa zwei Dritteln der Reichweite festspannen und die Tastkugel hineinsetzen.
clamp-firmly-reach = In Reichweite fest aufspannen, { $where }.
clamp-firmly-within-arms-reach-sphere = In Reichweite des Messarms fest aufspannen. Eine Kugel ist am aussagekräftigsten, eine Ebene geht schneller.
clamp-seat-firmly-reach-put-tip = Pfanne in Reichweite fest aufspannen, { $where }, und die Tastkugel hineinsetzen.
clamp-seat-take-place-again-delete = Pfanne festspannen und diese Position neu aufnehmen oder ihre Zeilen löschen
clamp-sphere = Kugel festspannen
clean-blocks-edges-check-focus-lighting = Kanten des Zinnenkörpers reinigen; Schärfe, Beleuchtung und Kalibrierschein prüfen.
clean-both-check-again = Beide reinigen und erneut prüfen.
clean-gauge-tip-check-clamps-verify = Prüfnormal und Tastkugel reinigen, Aufspannung prüfen und erneut verifizieren; dann neu kalibrieren.
clean-tip-clamp-sphere = Tastkugel reinigen und die Kugel festspannen
clean-tip-seat-check-clamps-repeat = Tastkugel und Pfanne reinigen, Aufspannung prüfen und wiederholen. Bleibt es dabei, den Messarm identifizieren.
clear-them-draw-them-again = Löschen und neu zeichnen.
clock = Uhr
clock-jumps-times-first-start-points =
    { $stream ->
        [joints]
            die Uhr der Messwerte des Messarms springt { $jumps ->
                [one] einmal, { $first } nach Beginn
               *[other] { $jumps }-mal, zuerst { $first } nach Beginn
            }; Punkte nahe einem Sprung können falsch liegen
       *[frames]
            die Uhr der Bilder springt { $jumps ->
                [one] einmal, { $first } nach Beginn
               *[other] { $jumps }-mal, zuerst { $first } nach Beginn
            }; Punkte nahe einem Sprung können falsch liegen
    }
clock-set-since-start-last =
    { $count ->
        [one] Die Uhr wurde seit dem Start einmal verstellt, um { $last_jump }.
       *[other] Die Uhr wurde seit dem Start { $count }-mal verstellt, zuletzt um { $last_jump }.
    }
close-other-program-or-wait = Schließen Sie das andere Programm; nach einem Absturz ist die Kamera nach wenigen Sekunden wieder frei
close-other-programs-restart-station-between = Andere Programme schließen oder die Station zwischen zwei Scans neu starten.
close-program-second-station-same-port = Das andere Programm oder eine zweite Station am selben Anschluss schließen.
close-program-with-port = Das andere Programm oder die zweite Station mit demselben Port schließen.
close-what-else-uses-machine = Andere Programme auf diesem Rechner schließen.
cloud-arrays-there = die Felder heißen { $names }
cloud-bytes-do-not-match-points = { $bytes } Byte sind für { $points } Punkte angegeben
cloud-cannot-be-expanded = die komprimierten Daten lassen sich nicht entpacken
cloud-check-shape-and-unit = Nur die Punktwolke des Normals angeben, seine Form und die Einheit (--unit)
cloud-choose-another-location = Speicherplatz freigeben oder einen anderen Ort wählen
cloud-columns-are-fixed-give-none = das Format legt fest, welche Spalten x, y und z sind: --columns weglassen
cloud-rows-without-column-names = eine Zeile lautet { $cells }, und keine Zeile benennt die Spalten
cloud-columns-of-several-units = die Spalten { $names } haben verschiedene Einheiten
cloud-columns-there = die Spalten heißen { $names }
cloud-contains-points-of = { $path } enthält { $found } von { $announced } Punkten
cloud-convert-to-one-unit = Alle drei in einer Einheit exportieren
cloud-correct-line = Diese Zeile berichtigen oder die Punktwolke als PLY exportieren
cloud-covers-little = { $file }: die Punkte zeigen { $share } der Kugel; ihr Radius ist daher auf ± { $uncertainty } bekannt (k = 2). Mehr von der Kugel scannen
cloud-data-of-unknown-kind = die Daten sind { $kind }, also weder ascii noch binary noch binary_compressed
cloud-decimal-commas = die Zahlen haben Dezimalkommas
cloud-disk-accepts-no-more = der Datenträger nimmt keine Daten mehr an ({ $reason })
cloud-disk-took-points = der Datenträger nahm { $found } von { $count } Punkten an
cloud-element-repeats-property = das Element { $name } hat zwei Eigenschaften desselben Namens
cloud-exact = { $used } von { $points } Punkten liegen genau auf einer { $shape ->
        [plane] Ebene
       *[sphere] Kugel
    }, wie es gemessene Punkte nie tun, und die anderen daneben
cloud-exact-remedy = Nicht gemessene Punkte weglassen und die Spalten prüfen (--columns)
cloud-export-again = Punktwolke erneut exportieren
cloud-export-binary-pcd = Als binäres PCD oder als PLY exportieren
cloud-export-cartesian = Kartesische Koordinaten exportieren
cloud-export-decimal-points = Mit Dezimalpunkten exportieren, oder jedes Komma durch einen Punkt ersetzen
cloud-fetch-from-lfs = Die Datei selbst holen mit: git lfs pull
cloud-file-empty = die Datei ist leer
cloud-first-column-counts-without-names = die erste Spalte nummeriert die Punkte, und keine Zeile benennt die Spalten
cloud-format-package-missing = für { $format }-Dateien ist das Paket { $package } nötig, das nicht installiert ist
cloud-format-unknown = es ist keine Punktwolke eines bekannten Formats
cloud-give-columns = Die Spalten der Koordinaten x, y und z nennen oder ihre Namen oder Nummern angeben, etwa --columns 2,3,4
cloud-give-known-format = Eine Punktwolke .ply, .pcd, .e57, .las, .laz, .xyz, .ptx, .obj, .stl, .off oder .npy angeben
cloud-header-announces-more = der Dateikopf gibt mehr an, als die Datei enthält
cloud-header-contains = der Dateikopf enthält { $line }
cloud-header-does-not-end = der Dateikopf endet nicht
cloud-header-is-invalid = der Dateikopf ist ungültig ({ $reason })
cloud-in-other-coordinates = { $file } liegt { $distance } vom Nennort entfernt: die Koordinaten sind andere, und Abweichungen des Ortes werden nicht angegeben
cloud-install-package = Installieren mit: { $command }; oder PLY, PCD oder XYZ verwenden
cloud-is-a-line = { $file }: die meisten Punkte liegen in einem Streifen von { $length } × { $width }: sie bestimmen kaum eine Ebene. Mehr von der Platte scannen
cloud-is-lfs-pointer = sie steht nur für eine Datei, die Git LFS anderswo aufbewahrt
cloud-is-packed = sie ist gepackt ({ $format })
cloud-is-recording-not-cloud = sie ist eine Aufzeichnung (MCAP), keine Punktwolke
cloud-las-counts-up-to = LAS zählt in Schritten von 0,1 µm, bis { $limit }
cloud-left-out-deleted = { $file }: { $points } Punkte sind als gelöscht markiert und zählen nicht
cloud-left-out-missing = { $file }: { $points } Punkte wurden nicht gemessen und zählen nicht: sie liegen bei 0, 0, 0 oder an einem anderen Ort, der für keinen steht
cloud-left-out-repeated = { $file }: { $points } Punkte wiederholen andere genau und zählen nicht
cloud-line-of-numbers-expected = erwartet wird eine Zeile mit den Zahlen x y z, aber { $reason }
cloud-list-below-zero = eine Liste in Zeile { $row } hat eine Länge unter null
cloud-no-element-vertex = der Dateikopf nennt kein Element vertex
cloud-no-ply-format = der Dateikopf nennt kein gültiges PLY-Format
cloud-no-such-column = { $path } hat keine Spalte { $name }
cloud-not-cartesian = die Punkte sind nicht kartesisch
cloud-not-complete-format = es ist keine vollständige { $format }-Datei ({ $reason })
cloud-of-another-shape = { $file }: Die Punkte liegen { $rms } (rms) um die { $shape ->
        [plane] Ebene
       *[sphere] Kugel
    }: Sie gehören kaum zu einer. Nur die Punktwolke des Normals angeben
cloud-of-another-unit = { $file } hat den Nennradius, wenn die Einheit { $unit } ist. --unit { $unit } angeben
cloud-of-format = sie ist eine Datei anderer Art ({ $format })
cloud-of-odd-size = { $file } ist { $size } groß, wenn die Einheit { $unit } ist. Die Einheit mit --unit m, mm oder inch angeben
cloud-ptx-head = die zehn Zeilen vor den Punkten einer PTX werden erwartet, aber eine lautet { $line }
cloud-reconstruct-first = Die Punktwolke daraus mit crenel reconstruct herstellen
cloud-row-is-not-complete = eine Zeile ist nicht vollständig ({ $line })
cloud-save-one-array = Die Koordinaten als ein Feld der Form (N, 3) oder als Felder x, y und z speichern
cloud-too-large-for-a-gauge = die { $shape ->
        [plane] Ebene
       *[sphere] Kugel
    } durch die Punkte ist { $size } groß
cloud-points-none-measured = keiner der { $points } Punkte wurde gemessen: sie sind als gelöscht markiert oder haben die Koordinaten 0, 0, 0 oder andere, die für keine stehen
cloud = Punktwolke
cloud-being-scanned-already = Es wird bereits eine Punktwolke gescannt.
cloud-cloud = { $title }, je Punktwolke.
cloud-not-in-data-folder = Die Punktwolke von { $name } ist nicht im Datenordner
cloud-formats = Punktwolken werden als { $suffixes } geschrieben
cloud-has-no-points = sie enthält keine Punkte
cloud-has-points = Die Punktwolke hat { $points } Punkte
cloud-has-points-of = { $path } enthält { $count } von { $announced } Punkten
cloud-holds-usable-points =
    { $points ->
        [one] die Punktwolke enthält { $points } brauchbaren Punkt
       *[other] die Punktwolke enthält { $points } brauchbare Punkte
    }
cloud-name-proposal = { $name } als Namen verwenden
cloud-no-points-lie-rms-off =
    { $shape ->
        [sphere] Die Punktwolke ist keine Kugel: Ihre Punkte weichen um { $rms } rms ab
       *[plane] Die Punktwolke ist keine Ebene: Ihre Punkte weichen um { $rms } rms ab
    }
cloud-no-use = Punktwolke { $number } ist nicht brauchbar.
cloud-not-as-scan-wrote-it = { $path } ist nicht so, wie ein Scan die Datei hinterlässt
cloud-pcd-rounds-beyond = die Gleitkommazahlen von PCD runden jenseits von { $limit } auf mehr als 1 µm
cloud-points-not-of-plane = { $left_out } der Punkte von Punktwolke { $number } gehören nicht zur Ebene.
cloud-point-lies-at = { $path }: ein Punkt liegt bei { $axis } = ±{ $distance }
cloud-point-lies-away = { $path }: ein Punkt liegt bei { $distance }
cloud-points-have-no = den Punkten fehlt { $axes }
cloud-rms-about-gauge = Punktwolke { $number }: { $rms } rms Abweichung vom Prüfnormal.
cloud-scan-number = { $path }: Scan { $number }
cloud-shows-cap-sphere = Die Punktwolke zeigt eine Kugelkappe von { $angle }
cloud-strip-wide = Die Punktwolke ist ein { $width } breiter Streifen
cloud-unpack-first = Zuerst entpacken
cloud-write-ply = PLY schreiben
cloud-write-ply-or-e57 = PLY oder E57 schreiben
cloud-xyz-written-up-to = XYZ wird bis { $limit } geschrieben
clouds = { $done } von { $clouds_wanted } Punktwolken
clouds-heading = Punktwolken
clouds-do-not-overlap = Nur { $count } von { $total } verglichenen Punkten liegen auf dem anderen Scan
clouds-enough = { $clouds_most } Punktwolken genügen.
clouds-rebuilt-every-calibration = Die Punktwolken sind mit jeder Kalibrierung neu berechnet.
clouds-taken-enough = { $done } Punktwolken reichen aus
code-wrong = Der Code ist falsch.
coefficient = Koeffizient
column-cell-is = { $place }: Spalte { $column } ist { $value }
column-empty = { $place }: Spalte { $column } ist leer
column-is = { $place }: { $column } ist { $value }
column-stands-there-twice = { $path }: Spalte { $names } kommt zweimal vor
columns-not-read = Nicht gelesene Spalten: { $names }
columns-not-separated-by-commas = die Spalten sind nicht durch Kommas getrennt
come-nearer-object-fills-wanted = Näher heran: Das Objekt füllt { $fills }, Soll { $least }
comes-after-calibration = Zuerst kalibrieren, dann verifizieren.
comes-last = Sie kommt, wenn der Rest da ist.
compare-blocks-depth-heights-certificate = Tiefe und Höhen des Zinnenkörpers mit dem Kalibrierschein vergleichen.
compare-no-arms = Scans eines Messarms zusammenführen
compare-scans-of-one-place = Scans desselben Teils an derselben Stelle vergleichen
comparing-scans = { $name } wird mit { $reference } verglichen
comparison-needs-points = Der Scan zum Vergleich hat { $count } Punkte; nötig sind { $needed }
complete-delete-row = Zeile ergänzen oder löschen
complete-or-delete-rows-of-position = Zeilen dieser Lage ergänzen oder löschen
compute-calibration-take-another-pose = { $taken } Kalibrierung berechnen oder eine weitere Pose aufnehmen.
computed-from = Berechnet aus den Antastungen und Scans
computer-cannot-keep-up = Der Rechner kommt nicht nach: Seine Warteschlange ist zu { $share } voll
confirmed-devices = Geräte bestätigt
confirmed-gauge = Prüfnormal bestätigt
confirmed-object-picture = Objekt im Bild bestätigt
confirmed-touches = Antastpunkte bestätigt
confirmed-what-use = Ausrüstung bestätigt
connect-arm-calibrate-one = den passenden Messarm anschließen oder mit diesem kalibrieren
connect-calibrate-one =
    { $device ->
        [arm] den passenden Messarm anschließen oder mit diesem kalibrieren
       *[sensor] den passenden Sensor anschließen oder mit diesem kalibrieren
    }
connect-the-arm = Arm verbinden
connect-the-sensor = Sensor verbinden
connected = Verbunden mit { $host }.
no-connection-for = Seit { $duration } nicht mit { $host } verbunden: { CLAUSE($reason) }.
device-connected = { $title } verbunden
connected-arm-has-joints = der angeschlossene Messarm hat { $joints } Gelenke
connected-arm-has-joints-has-choose = Der angeschlossene Messarm hat { $connected_joints } Gelenke, { $name } hat { $joint_count }. Den angeschlossenen Messarm wählen.
connected-arm-reports-joints-choose = Der angeschlossene Arm meldet Gelenkwinkel, { $name } aber Posen. Wählen Sie den angeschlossenen Arm.
connected-arm-reports-poses = der angeschlossene Arm meldet Posen
connected-arm-reports-poses-choose = Der angeschlossene Arm meldet Posen, { $name } aber hat Gelenke. Wählen Sie den angeschlossenen Arm.
connected-has-serial-number =
    { $device ->
        [arm] der angeschlossene Messarm hat die Seriennummer { $serial_number }
       *[sensor] der angeschlossene Sensor hat die Seriennummer { $serial_number }
    }
connected-has-serial-number-chosen-datasheet = Das angeschlossene Gerät ({ $name }) hat die Seriennummer { $serial_number }, das gewählte Datenblatt gilt für { $serial_number2 }.
connected-sensor = Angeschlossener Sensor
connected-sensors-picture-has-pixels-choose = Das Bild des angeschlossenen Sensors hat { $width_px } × { $height_px } Pixel, das von { $name } { $size } × { $size2 }. Den angeschlossenen Sensor wählen.
not-connected-yet = noch nicht verbunden
connecting = { $title } wird verbunden
contact-labelled-but-misses-face = Antastpunkt { $number } ist der Fläche „{ $face }“ zugeordnet, verfehlt sie aber um { $distance }
contact-limit = zwei Punkte des Objekts liegen höchstens { $limit } auseinander
contact-off-by = { $number } ({ $face }, { $off })
contact-points = Antastpunkte
contact-too-far = Dieser Punkt liegt { $apart } von Punkt { $number } entfernt, weiter als das Objekt reicht; er wurde nicht übernommen
contact-unknown-face = Antastpunkt { $number } liegt auf der unbekannten Fläche „{ $face }“
contacts = die Antastpunkte
contacts-agree-blocks-size-tips-diameter = Die Antastpunkte stimmen mit der Größe des Zinnenkörpers und dem Tastkugeldurchmesser überein: { $checked }.
contacts-arm-has-no-tip = { $readings } Antastpunkte, aber der Messarm { $name } hat keine Tastkugel
contacts-disagree-others-were-left-out =
    { $left_out ->
        [one] { $left_out } von { $count } Antastpunkten widerspricht den anderen und wurde ausgeschlossen: { $named }.
       *[other] { $left_out } von { $count } Antastpunkten widersprechen den anderen und wurden ausgeschlossen: { $named }.
    }
contacts-do-not-determine-object = { $count } Antastpunkte legen die Lage des Objekts nicht fest
contacts-face-lie-one-line = die { $count } Antastpunkte { $where } liegen auf einer Geraden
contacts-fit-block-rms = { $count } Antastpunkte passen zum Zinnenkörper mit { $rms } rms.
contacts-fit-block-rms-only-all = die Antastpunkte passen zum Zinnenkörper nur mit { $rms } rms, { $beside } von { $count } gar nicht
contacts-fit-block-rms-up-good = { $count } Antastpunkte passen zum Zinnenkörper mit { $rms } rms; gut ist bis { $good }.
contacts-lie-beside-crests-floors-were = { $off_face } von { $contacts } Antastpunkten liegen neben den angetasteten Zinnenoberseiten oder Nutgründen
contacts-lie-beside-face-they-labelled = { $beside } von { $count } Antastpunkten liegen neben der Fläche, der sie zugeordnet sind ({ $faces })
contacts-lie-board-rms = { $count } Antastpunkte liegen mit { $rms } rms auf der Tafel.
contacts-lie-board-rms-up-good = { $count } Antastpunkte liegen mit { $rms } rms auf der Tafel; gut ist bis { $good }.
contacts-lie-off-board-pictures-show = die { $touches } Antastpunkte liegen { $usual } neben der Tafel, die in den Bildern zu sehen ist
contacts-lie-than-blocks-size-tips =
    { $sign ->
        [apart]
            Die Antastpunkte auf { $pair ->
                [left] der linken und der rechten Stirnseite
               *[front] Vorder- und Rückseite
            } liegen { $opening } weiter auseinander, als sich aus Zinnenkörper und Tastkugeldurchmesser ergibt (Grenzwert { $limit }).
       *[together]
            Die Antastpunkte auf { $pair ->
                [left] der linken und der rechten Stirnseite
               *[front] Vorder- und Rückseite
            } liegen { $opening } näher beieinander, als sich aus Zinnenkörper und Tastkugeldurchmesser ergibt (Grenzwert { $limit }).
    }
contacts-pictures-agree-better-tip-than = Antastpunkte und Bilder stimmen mit einem Tastkugeldurchmesser von { $fitted } (± { $known }) besser überein als mit { $given }.
contacts-pictures-agree-better-tips-centre = Antastpunkte und Bilder stimmen besser überein, wenn die Tastkugelmitte { $off } neben ihrer Lage laut Armdatei liegt: um { $x }; { $y }; { $z } (± { $known }) im Flanschsystem. Gescannte Punkte können um ebenso viel falsch liegen.
contacts-rms =
    Antastpunkte, rms von { $count ->
        [one] { $count } Punkt
       *[other] { $count } Punkten
    }
contacts-rms-outliers = Antastpunkte, rms von { $count } Punkten, { $outliers } ausgeschlossen
contacts-scatter-times-what-arms-encoders = Die Antastpunkte streuen um { $sigma }, das { $arm_excess }-Fache dessen, was die Winkelgeber des Messarms erklären (Grenzwert { $excess }).
contacts-stripe-several-levels-need-crenellated = für Antastpunkte und Laserlinie auf mehreren Höhenstufen ist ein Zinnenkörper nötig
contacts-tips-sphere = Antastpunkte entstehen mit einer Tastkugel
contacts-were-given-positions = { $count } Antastpunkte mit Positionen der Form { $shape } wurden angegeben
continue = Weiter
continued-has-other-calibration = er wurde mit der Kalibrierung { $own } aufgenommen, in Gebrauch ist { $used }
continued-scan = Fortsetzen eines Scans begonnen oder beendet
continued-scan-no-longer-there = Den Scan, der fortgesetzt wurde, gibt es nicht mehr
convention-is-pose = { $path }: convention ist „pose“
convert-columns-degrees = Spalten in Grad umrechnen
convert-columns-x-mm-y-mm = Spalten x_mm, y_mm und z_mm in Millimeter umrechnen
convert-lengths-mm-name-columns = Längen in mm umrechnen und die Spalten { $names } nennen
convert-poses-read-otherwise =
    { $fault ->
        [inverted] die Posen des Flanschs im Koordinatensystem des Messarms angeben; bei feststehendem Sensor jede Pose invertiert angeben, in Kalibrierungen wie in Scans: Das Ergebnis hat den Sensor dann im Koordinatensystem der Basis des Messarms, und Scans liegen im Koordinatensystem des Flanschs
        [mirrored] das Spiegeln (horizontal oder vertikal) in den Einstellungen der Kamera oder im Programm, das die Bilder gespeichert hat, ausschalten und diese Bilder zurückspiegeln
        [scalar-first] qx, qy, qz, qw in dieser Reihenfolge schreiben
        [scalar-first-inverted] die Posen des Flanschs im Koordinatensystem des Messarms angeben und qx, qy, qz, qw in dieser Reihenfolge schreiben
        [turns-inverted] die Drehungen des Flanschs im Koordinatensystem des Messarms angeben: das Vorzeichen von qw umkehren
        [rotations] die eigenen Spalten der Steuerung schreiben und sie als rotation in arm.json nennen: { $controllers }
        [unit] die Positionen in mm umrechnen oder ihre Spalten nach ihrer Einheit benennen
        [late] jedem Bild ab Pose { $first } die Pose geben, in der es aufgenommen wurde
        [early] jedem Bild ab Pose { $first } die Pose geben, in der es aufgenommen wurde
        [tool-changed] alle Posen in einem Werkzeug-Koordinatensystem angeben oder die Posen vor { $first } und die ab dort getrennt kalibrieren
        [object-moved] die Posen vor { $first } und die ab dort getrennt kalibrieren
       *[other] jedem Bild die Pose geben, in der es aufgenommen wurde
    }
convert-them-name-columns = Werte umrechnen und die Spalten { $first } bis { $last } nennen
coordinate = Koordinate
coordinate-left-out-off = coordinates.csv Zeile { $number } ({ $place }): { $distance } Abweichung
coordinates = Koordinaten des Objekts
coordinates-about-mean-of-faces = Die Unsicherheiten gelten gegen den Mittelwert der Flächen jeder Achse, so dass der Abstand zweier Flächen die Wurzel aus der Summe ihrer Quadrate hat.
coordinates-fit-otherwise = { $reason }, lägen sie typischerweise { $off } von der Stelle, an der sie laut arm.json sind
coordinates-give-figures = coordinates.csv: { $poses } Posen ergeben { $figures } Werte
coordinates-held-out = Gemessene Koordinaten, kreuzvalidiert
coordinates-identify-only = Koordinaten dienen nur der Identifikation des Messarms
coordinates-measured = Gemessene Koordinaten
coordinates-spread = coordinates.csv: Die Punkte im Koordinatensystem { $name } liegen typisch { $measured } von ihrer Mitte, laut arm.json aber { $expected }
copy-differs-from-source = Die Kopie weicht von dem ab, was aus { $path } gelesen wurde
copy-whole-service-receives = Die vollständige Adresse aus dem empfangenden Dienst kopieren
corner = Ecke { $column },{ $row }
corners-can-measured = { $found } von { $corners } Ecken von „{ $name }“ sind messbar
corners-fix-camera-badly-condition-number = die { $points } Ecken bestimmen die Kamera schlecht (Konditionszahl { $condition }, Grenzwert { $limit })
corners-fix-camera-weakly-condition-number = Die Ecken bestimmen die Kamera nur schwach: Konditionszahl { $condition } (gut unter { $good }, abgelehnt über { $limit }).
corners-lie-off-regular-pattern-certificate = Die Ecken weichen um { $off } von einem regelmäßigen Muster ab, laut Kalibrierschein um { $standard_uncertainty }; das ist berücksichtigt.
corners-object-found = { $corners_detected } Ecken des Objekts gefunden.
corners-px = Ecken, px
corners-rms = Ecken, rms
corners-were-found = { $found } von { $corners } Ecken von „{ $name }“ wurden gefunden
corners-were-found-picture = { $points } Ecken wurden im Bild gefunden
corners-mistaken-or-not-of-object = die Ecken wurden verwechselt oder gehören nicht zu diesem Objekt
corners-would-lie-behind-camera = { $behind } von { $points } Ecken lägen hinter der Kamera
correct-cell-delete-row = Zelle berichtigen oder Zeile löschen
correct-it = Berichtigen
correct-marker-size = eine Markierung und ein Feld messen und marker_mm oder square_mm im Kalibrierschein berichtigen
correct-name = Namen berichtigen
correct-option = { $key } berichtigen.
correct-place-or-name-marker-differently = Ort berichtigen oder der Messmarke einen anderen Namen geben
correct-reading-or-leave-out = Messwert berichtigen oder weglassen
correct-remove-file = Datei berichtigen oder entfernen.
correct-remove-files-named = Die genannten Dateien berichtigen oder entfernen.
correct-sensor-exposure-us-take-out = { "[" }sensor] exposure_us berichtigen oder entfernen.
correct-sensor-take-out = { "[" }sensor] { $key } berichtigen oder entfernen.
correct-the-file-first = Berichtigen Sie zuerst die Datei, und wählen Sie das Gerät dann noch einmal
correct-tips-diameter-arm-json-what = Durchmesser der Tastkugel in arm.json oder die Angaben der Tabellen berichtigen
correct-value-or-give-arm-json = Wert berichtigen oder die richtige arm.json angeben
correct-value-or-name-artefact-differently = Wert berichtigen oder einen anderen Prüfkörper anders benennen
correlated-known-together = Korreliert: gemeinsam gut bestimmt, einzeln weniger gut
not-computed-data-kept = Die Berechnung war nicht möglich. Alles Aufgenommene bleibt erhalten.
could-true-last-ago =
    { $count ->
        [one] { $count } war unplausibel, vor { $ago }: { CLAUSE($what) }.
       *[other] { $count } waren unplausibel, der letzte vor { $ago }: { CLAUSE($what) }.
    }
count-inner-corners = Falls { $columns } × { $rows } die Zahl der Felder ist, die Zahl der Ecken zwischen ihnen angeben, je eine weniger; sonst den Kalibrierschein der Tafel im Bild angeben oder den Rest dieser Tafel freilegen
cover-one-board = eine davon abdecken oder aus dem Bild nehmen
create-choose-another-place = Ordner anlegen oder einen anderen wählen
crenel = Crenel { $version }
crest-z-mm-must-above-floor = { $crest } muss über { $floor } liegen und { $floor } über { $base }
crests-top = Zinnen oben
cut-points-away = Punkte in der Ansicht weggeschnitten
damaged = Die Datenbank ist beschädigt: { $trouble }.
dark-brightest-pixel = es ist dunkel: Das hellste Pixel hat { $brightest } von { $full } Graustufen
data-folder = Datenordner
no-longer-in-data-folder = { $name } ist nicht mehr im Datenordner.
data-folder-cannot-be-used = Der Datenordner { $folder } ist nicht verwendbar
data-folder-in-use = Der Datenordner { $folder } wird von einem anderen Crenel-Server verwendet (Prozess { $process })
data-lost-now = Vom { $title } gehen viele Daten verloren, oder sie kommen verspätet.
data-speak-errors-arms-links-each = Die Daten deuten auf Fehler der Armglieder von je { $links } und { $turns } hin; was davon bleibt, macht { $share } der Unsicherheit eines Punkts aus.
database = Datenbank
database-cannot-be-written = in die Datenbank lässt sich nicht schreiben: { $error }
database-is-empty = { $database } ist leer
database-is-not-there = { $database } ist nicht vorhanden
database-not-damaged = die Datenbank der Station lässt sich dort nicht öffnen; sie ist nicht beschädigt
database-of-later-version = { $path } wurde von einer neueren Version von Crenel geschrieben (Schema { $version }; diese Version kennt { $known })
datasheet-changed-meanwhile = { $file } wurde inzwischen geändert oder abgelegt; nichts wurde gespeichert
datasheet-lets-turn = laut Datenblatt dreht es von { $low } bis { $high }
datasheet-not-there = Das Datenblatt { $file } gibt es nicht mehr
datasheet-of-name-exists = { $name } hat schon ein Datenblatt: { $files }
datasheet-of-number-exists = { $name } mit der Seriennummer { $serial_number } hat schon ein Datenblatt: { $files }
datasheet-says-raw = laut { $path } liefert der Sensor Rohbilder (bayer)
datasheet-twice = { $files } beschreibt dasselbe: eines davon ablegen oder dessen Seriennummer oder Namen berichtigen.
datasheets = Datenblätter
datasheets-set-aside-everything = Nicht lesbare Dateien in arms, objects, sensors und gauges werden unverändert beiseitegelegt; alles andere steht zur Verfügung.
date = Datum
dcc-version-needed = Gelesen werden Kalibrierscheine der Version 3
dcc-version-unknown = der Kalibrierschein hat die Version { $version }
decimal-commas-read = Kommas wurden als Dezimalzeichen gelesen.
decimal-signs-mixed = Einige Zahlen haben ein Dezimalkomma ({ $one }), andere einen Dezimalpunkt ({ $other })
decision = Entscheidung
decision-rule-guard =
    Schutzabstand: das { $factor }-Fache der Standardunsicherheit. { $bearer ->
        [supplier] Der Lieferant trägt die Unsicherheit: Ein Wert, der näher am Grenzwert liegt als der Schutzabstand, ist nicht bestanden.
        [user] Der Anwender trägt die Unsicherheit: Ein Wert, der näher am Grenzwert liegt als der Schutzabstand, ist bestanden.
       *[prover] Wer etwas nachweisen muss, trägt die Unsicherheit: Ein Wert, der näher am Grenzwert liegt als der Schutzabstand, ist nicht entschieden.
    }
decision-rule-limits-set-standard-uncertainty = Entscheidungsregel: Die Grenzwerte gelten für die Standardunsicherheit selbst und werden unmittelbar mit ihr verglichen, ohne Schutzabstand.
decision-rule-named =
    Entscheidungsregel: { $name ->
        [guarded-95] Annahme mit Schutzabstand für 95 %
        [expanded-k2] Annahme mit der erweiterten Unsicherheit (k = 2) als Schutzabstand
        [simple] einfache Annahme
       *[other] { $name }
    }, { $standard }:{ $edition }.
decision-rule-without-guard = Es gibt keinen Schutzabstand: Die Werte werden unmittelbar mit ihren Grenzwerten verglichen, die Unsicherheit wird nur angegeben, und beide Seiten tragen ihr Risiko.
degrees-converted-twice = So weit dreht kein Gelenk: Wurden Grad für Bogenmaß gehalten und umgerechnet, sie angeben, wie sie waren; sonst den Wert berichtigen
delay-drifts = Der Zeitversatz driftet um { $drift } (k = 1: { $u }), { $change } während der Überfahrt: Die Uhren von Messarm und Kamera gehen verschieden schnell.
delay-drifts-its-pass-is-away = der Zeitversatz driftet um { $drift }, und die Überfahrt, aus der er stammt, liegt { $away } entfernt
delay-jumped = Der Zeitversatz änderte sich { $at } nach dem ersten Bild (k = 1: { $at_u }) um { $change } (k = 1: { $u }): Eine Uhr wurde gestellt.
delay-varies = Der Zeitversatz schwankt während der Überfahrt, wie bei Paketen des Messarms, die verschieden spät ankommen: { $u } (k = 1) seiner Unsicherheit kommen daher.
delay-varies-known = der Zeitversatz schwankt während der Überfahrt um { $varies } (k = 1), wie bei Paketen des Messarms, die verschieden spät oder zu mehreren auf einmal ankommen: { $known }; der Grenzwert ist { $limit }
delay-pictures-in-gaps = { $gaps } von { $pictures } Bildern liegen in Lücken zwischen den Werten des Messarms: Seine Pakete kommen verschieden spät, zu mehreren auf einmal oder gar nicht an
delay-would-not-be-determined = der Zeitversatz wäre nicht bestimmbar
delay-would-known-k-1 = die Standardunsicherheit des Zeitversatzes betrüge { $u } (k = 1)
delete-columns-of-one = Die Spalten einer der beiden löschen
delete-one-rows = Eine der Zeilen löschen
delete-scans-under-records-use-larger = Scans im Archiv löschen oder einen größeren Datenträger verwenden.
delete-what-stands-there-twice = Doppelte Einträge löschen
deleted = { $name } wurde gelöscht
deleted-scan = Scan gelöscht
demonstration = Die Vorführung
demonstration-accepts = Der simulierte Bediener nimmt diese Kalibrierung an. Ein Mensch sähe sich zuerst die Werte an.
demonstration-calibrates = Der simulierte Bediener kalibriert den Sensor: Antastpunkte, dann Bilder.
demonstration-not-calibrated = Die Vorführung ist ohne Kalibrierung zu Ende gegangen.
demonstration-scans = Der simulierte Bediener scannt die Teile auf dem Tisch.
demonstration-scans-soon = Der simulierte Bediener beginnt einen Scan. Der Laser geht an.
demonstration-stopped = Die Vorführung wurde angehalten. Alles bisher Getane bleibt: von Hand geht es weiter.
denavit-hartenberg-parameters-do-same = die Denavit-Hartenberg-Parameter haben dieselbe Wirkung
depth-mm = Tiefe, mm
depth-of-field-too-small = die Schärfentiefe ist { $depth }, bei diesem Messfeld müssen es mindestens { $least } sein
described-a-camera = beschrieb eine Kamera
described-an-arm = beschrieb einen Messarm
design-compares-blocks = Zinnenkörper werden verglichen
design-edge-break = Kanten gebrochen um höchstens
design-give-pixels-and-standoff = Als Optionen angeben, oder eine sensor.json, in der sie stehen.
design-groove-depth = Tiefe der Nuten
design-grooves = Nuten, von links
design-height = Höhe
design-length = Länge der Nuten
design-merlons = Zinnen, von links
design-mirror = Abstand vom eigenen Spiegelbild
design-needs-pixels-and-standoff = die Bildgröße (mindestens 64 × 64 Pixel) und der Arbeitsabstand des Sensors werden gebraucht
design-not-kept = Der Entwurf wird nicht mehr aufbewahrt
design-plans-poses = Posen und Antastpunkte werden geplant
design-predicts-accuracy = Genauigkeit wird vorausberechnet
design-tolerance = Toleranz, wenn wie gezeichnet verwendet
design-width = Breite
determine-delay-again-pass-close = Den Zeitversatz neu bestimmen, aus einer Überfahrt kurz vor oder nach dem Scan
deviations-distances-one = Abweichungen sind Abstände von einer Form
deviations-of-places = Abweichungen der 25 Stellen
device-cannot-be-opened = { $title } lässt sich nicht öffnen
device-cannot-be-played = { $title } lässt sich nicht wiedergeben
device-closed = { $title } ist geschlossen
device-closed-while-opening = { $title } wurde beim Öffnen geschlossen
device-failed = { $title } ist ausgefallen: { $error }
device-lost = { $title } ist nicht mehr verbunden
device-not-open = { $title } ist nicht geöffnet
device-without-pictures = { $title } ist ein Gerät, das keine Bilder sendet
device-not-permitted = { $name } ist angeschlossen, aber dieser Benutzer darf { $device } nicht öffnen
device-was-chosen = Die Station verwendet jetzt ein anderes Gerät: { $title }
devices = Geräte
devices-cannot-be-changed-now = Die Geräte können jetzt nicht geändert werden
devices-of-replay-are-fixed = Eine Wiedergabe hat die Geräte ihrer Aufzeichnung
dh-cell = Zeile { $line }: { $column } { $value }
dh-column-missing = Keine Spalte für { $names }
dh-column-twice = Zwei Spalten für { $names }
dh-commas-between-cells = Hier stehen Kommas zwischen den Zellen: Schreiben Sie Zahlen mit Dezimalpunkt
dh-needs-four-numbers = jede Zeile braucht a, alpha, d und theta und darf mit dem Namen des Gelenks beginnen
dh-number-expected = erwartet wird eine Zahl, ein Vielfaches von π oder ein Gelenkwinkel wie q1 + 90
dh-row-has-cells =
    { $count ->
        [one] Zeile { $line } hat eine Zelle
       *[other] Zeile { $line } hat { $count } Zellen
    }
dh-rows-missing = Die Zeile von Gelenk { $names } fehlt
dh-rows-out-of-order = Die Zeilen gehören zu den Gelenken { $names }, in dieser Reihenfolge
dh-rows-there = vorhanden sind die Zeilen { $names }
dh-table-has-columns = die Tabelle hat { $count } Spalten
dh-variable-not-an-angle = das Gelenk schiebt: Seine Variable ist eine Länge
diameter = Durchmesser
diameter-of-tip-by-datasheet = Tastkugeldurchmesser laut Datenblatt
diameter-tip-found = Gemessener Tastkugeldurchmesser
diameter-up-to-or-unknown = erwartet wird ein Durchmesser in mm bis { $most }, 0 für Punkte, die die Maschine korrigiert hat, oder unknown
dictionary-unknown = { $field } ist eines von { $names }
did-you-mean = Meinen Sie { $name }?
direction-points-into-block = { $place }: die Richtung i, j, k zeigt bei { $face } in den Block
directions-point-out-of-surface = Richtungen zeigen aus der Oberfläche heraus; die Antastung gehört zu einer anderen Fläche, oder die Vorzeichen sind vertauscht
disk = Datenträger
disk-fails = Der Datenträger von { $folder } liest oder schreibt fehlerhaft
disk-fails-takes-every-calibration-scan = Mit einem defekten Datenträger gehen alle Kalibrierungen und Scans verloren.
disk-full = der Datenträger ist voll
disk-full-during-scan = Der Datenträger war während dieses Scans voll.
disk-of-backup-loses-data = der Datenträger der Sicherung speichert nicht, was darauf geschrieben wird
disk-of-data-folder-full = Der Datenträger des Datenordners { $folder } ist voll
disk-of-folder-full = Der Datenträger von { $folder } ist voll
disk-quota-used-up = das Speicherkontingent ist aufgebraucht
disk-read-only = der Datenträger ist schreibgeschützt
disks-largest-file-size-reached = die maximale Dateigröße des Datenträgers ist erreicht
dispersion-free-centre = 95 %, freier Mittelpunkt
distance = Abstand
distance-between-clouds = Abstand zwischen den Punktwolken
distance-between-clouds-centres = Abstand der Mittelpunkte der Punktwolken
distance-each-touch-face-times-larger = Abstand jedes Antastpunkts von seiner Fläche, { $factor }-fach vergrößert: Blau innen, Orange außen, Kreuze ausgeschlossen. Der längste Strich entspricht { $largest } ({ $largest_mm }).
distance-each-touch-sphere-through-all = Abstand jedes Antastpunkts von der Ausgleichskugel derer, die übereinstimmen.
distance-fitted-shape-blue-inside-orange-outside = { $name }: Abstand von der eingepassten Form, Blau innen, Orange außen.
distance-out-of-range =
    { $side ->
        [near] Zu nah: { $distance }, Soll { $low } bis { $high }
       *[far] Zu weit: { $distance }, Soll { $low } bis { $high }
    }
distance-touched-centre = Abstand vom angetasteten Mittelpunkt
distance-touched-plane = Abstand von der angetasteten Ebene
distortion = Verzeichnung
distortion-not-invertible = die Verzeichnung lässt sich nicht im ganzen Bild umkehren
document-format = { $path }: format ist { $format }
document-states-no-format = { $path }: nennt kein Format (format)
document-version = { $path }: version ist { $version }
does-not-take-exposure = { $title } unterstützt keine Belichtung von { $exposure }
method-not-accepted = { $path } unterstützt { $method } nicht.
notifications-not-accepted = { $host } nimmt keine Benachrichtigungen an: { $trouble } ({ $failed } nicht zugestellt).
done = Fertig
draw-over-part-cloud = das Rechteck über einen Teil der Punktwolke ziehen
draw-pictures-of-each-folder-apart = Die Bilder jedes Ordners für sich zeichnen
drawing-edges = Kanten scharf: gratfrei, höchstens { $largest } gebrochen.
drawing-flat = Flächen eben sowie parallel oder rechtwinklig zueinander, innerhalb von { $within }.
drawing-front-view = Vorderansicht
drawing-material = Aluminium oder Stahl, spannungsarm; alle Maße bei 20 °C, in mm.
drawing-scale = Maßstab { $scale } (A4)
drawing-side-view = Seitenansicht
drawing-surface-without-gloss = Alle Flächen hell, gleichmäßig und matt (zum Beispiel glasperlengestrahlt), ohne glänzende Bearbeitungsspuren.
drawing-tolerance = Maße ± { $tolerance }, wenn der Zinnenkörper wie gezeichnet verwendet wird; ± { $loose } genügen, wenn ein Labor danach jedes Maß misst.
drifting-delay-ended-with-restart = Der Zeitversatz zwischen Messarm und Kamera driftet und gilt nach dem Neustart nicht mehr. Unter Einstellungen neu bestimmen.
driver-cannot-be-loaded = Der Treiber { $name } ({ $table }) aus { $package } lässt sich nicht laden: { $kind }: { $error }
driver-not-callable = Der Treiber { $name } ({ $table }) aus { $package } lässt sich nicht aufrufen: { $value }
driver-offered = Der Treiber { $name } ({ $table }) ist mehrfach vorhanden: { $packages }
driver-selects-raw-pixels = an einer Station wählt der Treiber die Pixel der Laserfarbe aus
driver-takes = Zulässig sind { $names }.
driver-abb-egm = Roboter von ABB (EGM)
driver-bridge = Encoder-Messarm oder Brücke, an serieller Schnittstelle oder im Netz
driver-fanuc = Roboter von FANUC
driver-folder = Ordner mit Bildern
driver-genicam = Industriekamera (GigE Vision, USB3 Vision)
driver-gentl = Kamera mit dem GenTL-Producer ihres Herstellers
driver-kuka-rsi = Roboter von KUKA (RSI)
driver-microscribe = MicroScribe-Messarm
driver-opencv = USB-Kamera, Netzwerkstrom oder Video
driver-pylon = Basler-Kamera (pylon)
driver-ros2 = ROS-2-Topic
driver-ur-rtde = Roboter von Universal Robots (RTDE)
option-address = Adresse
option-base = Basiskoordinatensystem
option-baudrate = Baudrate
option-bayer = Bayer-Muster roher Bilder
option-child-frame = Koordinatensystem des Flansches
option-choice-arrival = Ankunft der Nachricht
option-choice-blue = blau
option-choice-exposure-end = Ende der Belichtung
option-choice-exposure-start = Beginn der Belichtung
option-choice-falling = fallend
option-choice-flange = Pose des Flansches
option-choice-frame-end = Ende der Übertragung
option-choice-green = grün
option-choice-header = Kopf der Nachricht
option-choice-joints = Winkel der Gelenke
option-choice-mid-exposure = Mitte der Belichtung
option-choice-other-axis = Verfahrachse oder Drehtisch (muss stillstehen)
option-choice-pose = Pose
option-choice-red = rot
option-choice-region = erste Zeile des Bildausschnitts
option-choice-rising = steigend
option-choice-sensor = erste Zeile des Sensors
option-choice-tf = Transformationen (tf)
option-choice-third-axis = drittes von sieben Gelenken
option-chunks = Chunk-Daten
option-counts-per-revolution = Zählschritte je Umdrehung
option-domain-id = Domain-Nummer
option-exposure = Belichtung
option-exposure-range = Bereich der Belichtungszeit
option-external-axis = Externe Achse
option-gain = Verstärkung (dB)
option-height = Höhe
option-help-base = Im Koordinatensystem des Messarms: Position in mm, dann Orientierung wie an der Steuerung
option-help-chunks = Mit jedem Bild gesendet: ExposureTime, Timestamp
option-help-exposure-range = Kürzeste und längste, die der Bediener einstellen darf
option-help-external-axis = Nur für Gelenke: was die Achse ist, die der Roboter neben seinen sechs sendet
option-help-joint-names = Wie in den Nachrichten, von der Basis aus, mit Kommas
option-help-laser-line = Bilder kommen dann paarweise, mit und ohne Laser
option-help-latency = Kleinste Verzögerung, die von jedem Zeitstempel abgezogen wird
option-help-line-offset = 0.5 für eine Kamera, die ab dem Rand der ersten Zeile zählt
option-help-line-rate = Leer: wie in der Kamera eingestellt
option-help-line-rows = Bei einer Kamera, die die Laserlinie selbst findet; siehe ihr Handbuch
option-help-line-sigma = Einer Zeile, laut Handbuch der Kamera; leer: wird gemessen
option-help-packet-size = In Byte; 8192 mit Jumbo-Frames
option-help-region = x, y, Breite, Höhe in Pixeln
option-help-setting = Nummer von Werkzeug und Koordinatensystem, die die Brücke sendet; Posen mit einer anderen werden abgelehnt
option-help-stamp-at = Siehe Handbuch der Kamera
option-help-tool = Im Flansch-Koordinatensystem: Position in mm, dann Orientierung wie an der Steuerung
option-help-trigger = Eingang, an dessen Flanke ein Bild entsteht; leer: läuft von selbst
option-help-url = /dev/ttyUSB0, im Netz socket://192.168.1.20:7431
option-joint-count = Anzahl der Gelenke
option-joint-names = Namen der Gelenke
option-kind = Art der Nachrichten
option-laser-colour = Farbe des Lasers
option-laser-line = Ausgang, der den Laser schaltet
option-latency = Verzögerung
option-line-offset = Linien: Zuschlag zu den Zeilen
option-line-rate = Linien: Rate
option-line-rows = Linien: Zeilen zählen ab
option-line-sigma = Linien: Standardabweichung
option-loop = Am Ende von vorn beginnen
option-packet-size = Paketgröße
option-parent-frame = Koordinatensystem der Basis
option-path = Ordner
option-pixel-format = Pixelformat
option-port = Anschluss
option-producer = GenTL-Producer (.cti-Datei)
option-rate = Rate
option-region = Bildausschnitt
option-report = Was gelesen wird
option-serial = Seriennummer
option-setting = Einstellung der Posen
option-source = Kameranummer, Gerät, Adresse oder Datei
option-stamp-at = Ereignis des Zeitstempels
option-stamps = Zeitstempel
option-timeout = Zeitgrenze
option-tool = Werkzeugkoordinatensystem
option-topic = Topic
option-trigger = Trigger
option-trigger-edge = Flanke des Triggers
option-url = Anschluss oder Adresse
option-width = Breite
drivers-are = Vorhandene Treiber: { $names }.
drop-cloud = Diese Punktwolke verwerfen
drop-coordinates = Koordinaten verwerfen
drop-last-place = Letzte Position verwerfen
dropped-cloud = Punktwolke verworfen
dropped-coordinates = hat Koordinaten eines Lasertrackers verworfen
dropped-seat = Position verworfen
dropped-swing = Punkte einer Position verworfen
dropping-cloud = Punktwolke wird verworfen
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
dxf-requires-package = DXF braucht das Paket ezdxf
each-point-needs-three-coordinates-one = jeder Punkt braucht drei Koordinaten und ein Pixel (u, v)
each-point-swing-about-middle-all = Jeder Punkt des Schwenks relativ zur Mitte aller Punkte, im Koordinatensystem des Messarms.
each-touchs-distance-sphere = Abstand jedes Antastpunkts von der Kugel
edge-of-base =
    { $side ->
        [left] die linke Kante der Grundfläche
        [right] die rechte Kante der Grundfläche
        [front] die vordere Kante der Grundfläche
       *[back] die hintere Kante der Grundfläche
    }
edge-of-crest =
    { $side ->
        [left] die linke Oberkante der Zinne { $number }
        [right] die rechte Oberkante der Zinne { $number }
        [front] die vordere Oberkante der Zinne { $number }
       *[back] die hintere Oberkante der Zinne { $number }
    }
edge-of-floor =
    { $side ->
        [left] die linke Kante des Nutgrunds { $number }
        [right] die rechte Kante des Nutgrunds { $number }
        [front] die vordere Kante des Nutgrunds { $number }
       *[back] die hintere Kante des Nutgrunds { $number }
    }
edge-width = Kantenbreite
edges-corners = Kanten und Ecken
edges-corners-rms = Kanten und Ecken, rms
edges-lie-off-average-where-certificate = seine Kanten liegen im Mittel { $usual } und { $edge } { $distance } neben der Lage laut Kalibrierschein
edges-px = Kanten, px
edges-would-fit-only-if-cameras = seine Kanten würden nur passen, wenn die Pixel der Kamera um { $off_square } von der quadratischen Form abwichen
edges-would-fit-only-lens-distorted = seine Kanten würden nur zu einem Objektiv mit der Verzeichnung k1 = { $k1 }, k2 = { $k2 } passen
edges-x-mm-must-ascend-follows = die Werte in { $edges } müssen ansteigen: { $right } folgt auf { $left }
edges-x-mm-odd-count =
    { $edges } enthält { $count ->
        [one] { $count } Kante
       *[other] { $count } Kanten
    }; jede Zinne hat zwei, eine linke und eine rechte
edition-has-no-symbol = die Ausgabe { $edition } hat kein Symbol für { $quantity }
editions-are = Ausgaben sind { $names }
egm-external-axis = Der Roboter unter { $address } sendet neben seinen Gelenken eine externe Achse
error-of-arm-over-reach-unknown = { $path } nennt den Fehler des Arms über seine Reichweite nicht
errors-of-links-counted = Fehler der Armglieder zählen, mit allem, was den Antastungen davon gemeinsam ist: { $error } (Effektivwert) des Tasters über die Reichweite des Arms.
exchange-faces-or-touch-again = Die Namen tauschen, oder beide noch einmal antasten
face-has-touches =
    { $count ->
        [one] { $face } wurde einmal angetastet
       *[other] { $face } wurde { $count }-mal angetastet
    }
faces-as-touched = Flächen, wie angetastet
faces-beyond-tolerance = Um mehr als die Toleranz von ± { $tolerance } neben der Zeichnung: { $faces }. Diese Messwerte prüfen, auch ob zwei vertauscht sind.
file-has-touches = { $path } hat { $count } Antastungen
first-id-too-large = { $field }: höchstens { $most } bei diesen Markierungen aus { $dictionary }
fix-focus-and-zoom-and-take-all-pictures-again = Autofokus abschalten, Fokus und Zoom feststellen und alle Bilder neu aufnehmen
flatness-of-touches = Ebenheit
focal-length-differs-between-pictures = die Brennweite ist nicht in allen Bildern gleich (Unterschied { $span }): in den Posen { $poses } ist sie länger als in den übrigen
focus-zoom-or-lens-changed-since = Fokus, Zoom oder Objektiv haben sich seit ihrer Kalibrierung geändert
form-of-faces-is = Ebenheit ist die Spanne der Antastungen um ihre eigene Ausgleichsebene; Parallelitätsabweichung ist, was diese Ebene über die angetastete Fläche gegen die Achse des Blocks ansteigt. Drei Antastungen zeigen keine Form.
give-a-calibration-of-several-poses = Eine Kalibrierung angeben, die Crenel aus mehreren Posen erstellt hat
give-arm-of-touches = Die Datei des Arms mit --arm angeben
give-other-sizes-or-leave-them = Dieses Maß ändern oder dem Entwurf überlassen.
give-kind-chessboard = falls es ein einfaches Schachbrett ist, es in object.json mit kind chessboard beschreiben; sonst die Tafel mit den Markierungen ins Bild bringen und das Wörterbuch in ihrem Kalibrierschein prüfen
give-readings-points-or-both = readings.csv, --points oder beides angeben
groove-deeper-than-sharp = Nuten von { $groove } sind tiefer als die Schärfentiefe von { $depth }
groove-too-deep-to-cut = Nuten von { $groove } sind zu tief zum Fräsen; mit diesen Zinnen höchstens { $most }
give-each-pose-its-own-picture = Jeder Zeile von images.csv ein eigenes Bild geben
had-begun-adding-the-laser = begonnen, den Laser hinzuzufügen
identical-pictures-count-once = Die Bilder der Posen { $poses } sind noch einmal die anderer Posen. Sie zählen einmal.
identify-arm-or-state-arm-um = Den Arm identifizieren, oder den Effektivwert des Fehlers seines Tasters über die Reichweite mit --arm-um angeben
joints-of-others-left-out = Gelenke, die arm.json nicht hat, sind weggelassen: { $names }
kept-camera-does-not-fit = die Ecken liegen { $rms } (RMS) neben ihrem Ort nach der beibehaltenen Kamera, { $own } mit einer Kamera aus diesen Bildern
kept-camera-does-not-fit-the-arm = mit der behaltenen Kamera weichen Bilder und Arm { $times }-mal so stark voneinander ab wie mit einer eigenen Kamera
last-result-has-other-version = Das letzte Ergebnis damit entstand mit einer anderen Fassung dieses Datenblatts, die es behält.
leave-out-touches-evenly = Antastungen gleichmäßig auf allen Flächen weglassen
links-errors-do-not-average-out = Fehler der Glieder sind bei jeder Antastung gleich und mitteln sich nicht heraus
measure-width-and-height-of-print = Breite und Höhe des ganzen Musters messen, oder keine von beiden.
merlons-too-narrow = mit { $merlons } Zinnen ist die schmalste { $narrowest } breit und muss mindestens { $least } haben, um im Bild messbar zu sein
merlons-would-be-mirror = { $merlons } Zinnen auf { $width } wären so gleich breit, dass der Zinnenkörper für sein Spiegelbild gehalten werden könnte
marker-cells-too-small = die Zellen ihrer Markierungen sind im Bild { $width } breit; mindestens { $least } sind nötig
markers-arranged-so = die Markierungen sind angeordnet wie auf einer Tafel mit { $columns } Feldern nebeneinander und mindestens { $rows } untereinander
markers-covered-too-small-or-blurred = die Tafel ist nicht im Bild, verdeckt, zu klein, unscharf oder zu schräg gesehen, oder es ist ein anderer Gegenstand
markers-have-ids = Markierungen aus { $dictionary } mit den Nummern { $first } bis { $last } gefunden
markers-of-board-read = { $found } von { $count } Markierungen von „{ $name }“ wurden gelesen
markers-read-if-mirrored = in seinem Spiegelbild sind { $count } Markierungen aus { $dictionary } angeordnet wie auf einer Tafel
most-touches-are = höchstens { $most } sind verwendbar
multiply-coordinates-by = Die Koordinaten mit { $factor } multiplizieren
need-certificate = Kalibrierschein des Blocks
neither-readings-nor-points = weder Messwerte noch Punkte wurden angegeben
no-page-of-this-name = { $name } ist kein Papierformat
no-width-for-given-merlons = kein Zinnenkörper mit { $merlons } Zinnen lässt sich herstellen und ist für diesen Sensor ganz zu sehen
no-width-for-given-sizes = kein Zinnenkörper mit { $merlons } Zinnen und Nuten von { $groove } lässt sich herstellen und ist für diesen Sensor ganz zu sehen
one-length-of-print-alone = vom Druck wurde eine Länge ohne die andere gemessen
no-laser-plane-yet = Kamera und Anbau sind kalibriert. Eine Laserebene gibt es noch nicht: Gescannt werden kann nicht.
no-picture-was-taken-with-the-laser = der Laser war in allen Bildern aus: Es gibt keine Ebene zu ergänzen
none-yet = noch keine
opposite-faces-exchanged-or-left-handed = gegenüberliegende Flächen wie front und back sind vertauscht, oder die Maschinenachsen sind linkshändig
out-of-parallel = Parallelitätsabweichung
picture-mirrored = das Bild ist gespiegelt
posture-and-its-uncertainty = posture und posture_uncertainty_mm werden zusammen angegeben
scan-under-way-go-where-stands = Ein Scan läuft. Weiter zum Stand des Scans.
shape-label = { $shape ->
    [plane] Ebene
    [sphere] Kugel
   *[cylinder] Zylinder
} { $n }
sizes-not-shown-as-a-whole = ein Zinnenkörper von { $width } mit diesen Maßen ist nicht bis auf den Grund seiner Nuten ganz zu sehen
so-few-markers-tell-nothing = weniger als { $fewest } sagen nicht, wo die Tafel ist: die anderen sind verdeckt, außerhalb des Bildes, zu klein oder unscharf
squares-without-markers = Felder eines Schachbretts gefunden, aber keine Markierungen darin
state-dictionary = falls dies die Tafel ist, in ihrer object.json dictionary: { $dictionary } angeben
same-picture-as-before = { $name } ist noch einmal das Bild davor
same-picture-as-pose = { $name } ist noch einmal das Bild der Pose { $number }
same-picture-counts-once = dasselbe Bild zählt einmal
state-external-axis = external_axis auf "third" setzen, wenn der Roboter sieben Achsen hat, oder auf "other" für eine Verfahrachse oder einen Drehtisch, die stillstehen müssen
egm-lacks = Die Pakete des Roboters unter { $address } enthalten kein { $name }
egm-no-egm = Was der Roboter unter { $address } sendet, ist kein EGM
egm-start-stream = Das RAPID-Programm ausführen, das den Datenstrom startet (EGMStreamStart). Sein UDPUC-Gerät muss Adresse und Port dieses Rechners haben.
empty = sie ist leer
encoder-stands-still-switch-arm-off = sein Winkelgeber ändert sich nicht: Messarm aus- und wieder einschalten und das Kabel des Gelenks prüfen
end-cloud = Punktwolke abschließen
end-it-first = Beenden Sie das zuerst
end-name = Der Name muss auf .html oder .pdf enden
end-pictures-by-themselves = Die Bilder beenden
ended = Sitzung beendet
ended-activity = beendete, was den Messarm hatte
ended-pictures-by-themselves = beendete die Bilder von selbst
ended-token-metrics = Token für Metriken widerrufen
enough-places = Genügend Positionen
enter-device-address = Gerätepfad wie /dev/ttyUSB0, Anschluss wie COM5, socket://HOST:PORT oder rfc2217://HOST:PORT eingeben.
enter-network-address-as = Geben Sie eine Adresse im Netz als { $url } ein.
enter-artefact-by-hand = Das Normal von Hand eingeben, mit den Angaben seines Kalibrierscheins
enter-country = Es angeben, etwa DE; auf der Befehlszeile mit --country DE
enter-laboratory = Ihn angeben; auf der Befehlszeile mit --laboratory NAME
enter-stream-address = Die Adresse eines Videostroms beginnt mit einem von { $kinds }.
enter-the-arm = Arm eingeben
enter-the-sensor = Sensor eingeben
enter-the-target = Zinnenkörper oder Tafel eingeben
entered-consoles-code = mit dem Code der Konsole angemeldet
entered-the-temperature = Temperatur eingegeben
entry-point-must-name-function-takes = Sein Einstiegspunkt muss eine Funktion sein, die die Optionen entgegennimmt.
error = Durchmesserabweichung
error-arm-joints = Spiel und Geber der Gelenke
error-arm-links = Längen und Winkel der Glieder des Arms
error-budget = Unsicherheitsbudget
error-budget-with-limits = Beiträge zur Standardunsicherheit (k = 1) eines gescannten Punkts. Grenzwerte: gut bis { $good }, brauchbar bis { $usable }.
error-clock = Verzögerung zwischen Arm und Sensor
error-hides-in = Zeigt sich kaum in
error-in-column = Spalte { $place }
error-in-row = Zeile { $place }
error-laser-plane = Laserebene, gebogen oder gekippt
error-of = Fehler
error-probe-matrix = Messkopfmatrix, Verschiebung um d falsch
error-radius = Radiusabweichung
error-sensor-scale = Maßstab des Sensors
error-shows-in = Zeigt sich in
error-stripe-noise = Rauschen des Streifens
error-not-foreseen = Ein Fehler im Protokoll ist ein nicht vorhergesehener Fall.
error-tip-diameter = Durchmesser der Tastkugel
error-what = { CLAUSE($what) }.
error-what-and-why = { CLAUSE($what) }: { CLAUSE($why) }.
one-pose-does-not-show-arm-errors = Fehler des Armmodells selbst, nicht zum Bild gehörende Gelenkwinkel und ein nach dem Antasten bewegtes Objekt lassen sich aus einem Bild in einer Pose nicht erkennen und sind in diesem Wert nicht enthalten.
errors-or-none-last-hour =
    { $count ->
        [0] Kein Fehler in der letzten Stunde.
        [one] Ein Fehler in der letzten Stunde.
       *[other] { $count } Fehler in der letzten Stunde.
    }
errors-of-lengths = Längenabweichungen
errors-of-lengths-caption =
    { $count ->
        [one] { $count } Längenabweichung
       *[other] { $count } Längenabweichungen
    } { $by ->
        [scan] durch Scannen
       *[touch] durch Antasten
    } über der Länge; die Aufstellungen nebeneinander. Gestrichelt: die größte zulässige Abweichung. Rot: darüber, mit der Nummer der Aufstellung.
even-best-arm-points-still-scatter = selbst mit dem besten Armmodell streuen die Punkte noch um { $scatter }
every-figure-keeps-limit = Alle Kenngrößen halten ihren Grenzwert ein.
not-every-figure-keeps-limit = Nicht alle Kenngrößen halten ihren Grenzwert ein.
not-every-figure-known-well-enough = Nicht alle Kenngrößen sind für eine Entscheidung genau genug bestimmt.
every-file-has-content-result-made = Jede Datei hat noch den Inhalt, aus dem das Ergebnis berechnet wurde.
every-reading-joints-could-true = Alle Messwerte der Gelenke sind plausibel.
every-stripe-pictures-wait-them = Alle Laserlinien sind aufgezeichnet; sie haben Vorrang vor Bildern.
everything-grows-metre-aluminium = Mit der Temperatur dehnt sich alles aus, ein Meter Aluminium um { $growth } je Grad.
exceed-limit-m = { $half_range } überschreiten den Grenzwert von { $limit }.
exchange-readings-or-read-again = Tauschen, oder beide noch einmal messen
expand-xacro = Wandeln Sie es mit xacro DATEI > robot.urdf um, und geben Sie das Ergebnis an
expanded-uncertainty-note = U = { $expanded_uncertainty }, k = 2
expansion-not-read = der Ausdehnungskoeffizient des Kalibrierscheins wird nicht gelesen: expansion_per_c in der Datei eintragen
face-known-only-to = die Messwerte lassen eine Fläche um { $known } unsicher
face-of-block = Fläche
faces-are-not-parallel = das sind nicht zwei parallele Flächen
faces-of-readings-are = die Flächen sind edge_1 bis edge_{ $edges }, { $names }
figure-over-clouds = 
    { $title }: { $of ->
        [mean] Mittelwert
        [range] Spannweite
       *[standard_deviation] Standardabweichung
    }
file-cannot-be-evaluated = sie lässt sich nicht auswerten ({ $error })
file-has-no-pictures-with-laser = { $path } enthält keine Bilder mit eingeschaltetem Laser
file-has-no-readings = { $path } enthält keine Messwerte des Arms
first-row-empty = Länge und Verdrehung der ersten Zeile sind null, die der letzten nicht
flange-lies-far = { $path }: der Flansch liegt { $furthest } von der Basis entfernt
flange-row-turns-no-joint = Die Zeile { $name } dreht um kein Gelenk: Sie gilt als feste Transformation hinter dem letzten Gelenk.
frames-left-out-clock-set = { $count } von { $frames } Bildern ausgelassen: Um ihre Zeitstempel wurde eine Uhr zurückgestellt
frames-moved-near-the-arm = Koordinatensysteme der Glieder mit fast parallelen Achsen lagen in arm.json bis zu { $far } entfernt: Sie wurden in die Nähe des Arms verlegt und beschreiben denselben Arm
give-arm-and-camera-one-clock = Beide an einer Uhr betreiben (PTP oder Pulse des Messarms), oder den Zeitversatz vor jedem Scan bestimmen.
give-each-row-angles-of-its-pose = Jeder Zeile die Gelenkwinkel ihrer eigenen Pose geben
give-kind-charuco = Die Tafel in object.json mit kind charuco, dictionary und marker_mm beschreiben
give-one-of = Möglich sind { $names }
give-pose-of-marker-in-frame = Die Pose der Messmarke im Koordinatensystem des Messgeräts angeben
give-quaternions-with-more-digits = qx, qy, qz, qw mit mindestens vier Nachkommastellen angeben, den Skalar zuletzt
give-row-of-each-joint = Geben Sie je Gelenk eine Zeile an; eine Zeile des Flanschs kommt zuletzt und heißt flange
give-square-in-mm = square_mm in Millimetern angeben
give-times-in-seconds = Zeiten in Sekunden angeben, ab einem beliebigen Anfang
give-times-in-seconds-readings-closer = Alle Zeiten in Sekunden angeben, und Messwerte des Messarms im Abstand von höchstens { $longest }
give-times-of-one-clock = Bildern und Messwerten Zeiten derselben Uhr geben
give-unit-of-angles = Wählen Sie die Einheit der Winkel
give-lengths-of-links = a und d jedes Gelenks eintragen
give-unit-of-lengths = Wählen Sie die Einheit der Längen
give-ur-files = Geben Sie calibration.conf des Arms an, allein oder gefolgt von urcontrol.conf
give-urdf = Geben Sie das URDF des Roboters an, wie ROS es liest
if-angles-of-next-row =
    { $row ->
        [before] wenn jede Zeile die Gelenkwinkel der vorherigen Zeile hätte
       *[after] wenn jede Zeile die Gelenkwinkel der nächsten Zeile hätte
    }
if-coordinates-in-unit =
    { $unit ->
        [inches] wenn sie in Zoll angegeben wären
       *[centimetres] wenn sie in Zentimetern angegeben wären
    }
if-coordinates-mirrored = wenn die Koordinaten gespiegelt wären
if-frame-is-not-base = wenn ihr Koordinatensystem das des Messgeräts und nicht die Basis wäre
if-instrument-moved = wenn das Messgerät oder die Basis des Arms vor Zeile { $line } bewegt worden wäre
if-joint-turned-other-way = wenn sich das Gelenk { $joint } andersherum drehte
if-joint-zero-elsewhere = wenn das Gelenk { $joint } { $turn } mehr anzeigte
if-poses-inverted = wenn dies die Posen des Messgeräts im Koordinatensystem der Messmarke wären
import-with-stripe-axis = stripe_axis in sensor.json auf { $axis } setzen und erneut einlesen
index-before = Längen oder Verdrehungen haben den Index i − 1
it-is-known-to-limit = er ist dann auf { $u } (k = 1) bekannt; die Grenze ist { $limit }
it-is-no-device = das ist keine Adresse eines Geräts
largest-angle-of-poses = { $path }: der größte Wert von { $names } ist { $largest }
last-row-empty = Länge und Verdrehung der letzten Zeile sind null, die der ersten nicht
lengths-add-up = seine Längen ergeben zusammen { $total }, in { $unit } also einen Arm von { $length }
lengths-all-zero = alle Längen sind 0: die Glieder eines Arms haben Längen
lengths-are-in-metres = kein a_mm oder d_mm ist größer als { $longest }: Das sind Meter, erwartet werden Millimeter
lengths-in-unit = In { $unit } gelesen misst der Arm { $length }
limits-judged-by-marked-uncertainty = U: Messunsicherheit des Werts aus Normal, Taster und Punkten. U der Prüfung: Prüfwertunsicherheit allein aus dem Normal und seinem Aufbau (ISO 14253-5), ein Anteil von U. Jeder Grenzwert wird nach der mit{ $mark } gekennzeichneten beurteilt.
limits-not-stated = Der Text nennt keine Grenzen der Gelenke: ±180° wurden eingesetzt.
line-moved-arm-did-not = die Laserlinie bewegte sich um { $line }, die Messwerte des Messarms änderten sich aber nicht
line-stands-still = Die Linie steht still: Nach ihren ersten { $most } Bildern ergibt sie keine Punkte; Bilder ohne Punkte bisher: { $count }
listen-choose-higher-port = Mit --port einen Port ab 1024 wählen
listen-failed = Port { $port } von { $host } lässt sich nicht öffnen
listen-free-port = Beenden, was ihn verwendet, oder mit --port einen anderen wählen
listen-give-own-address = Mit --host eine Adresse dieses Rechners angeben
map-outliers-or-none = 
    { $points ->
        [0] Kein Punkt liegt weiter ab, als Rauschen erklärt.
        [one] Ringe: { $points } Punkt liegt weiter ab, als Rauschen erklärt.
       *[other] Ringe: { $points } Punkte liegen weiter ab, als Rauschen erklärt.
    } Dicke Ringe: der tiefste und der höchste Punkt, { $low } und { $high }; die Spannweite aller Punkte liegt zwischen ihnen.
load-the-list-again = Liste neu laden
load-the-page-again = Seite neu laden
markers-in-white-squares = in ihren weißen Feldern sind Marker: sie ist eine ChArUco-Tafel
markers-place-is-estimated-instead = stattdessen wird der Ort des Markers am Flansch geschätzt
model-answer-unknown = { $key } kann nicht { $answer } sein
model-leaves-open = { $path } lässt offen, was es bedeutet
model-open = { $key } ({ $options })
model-open-likely = { $key } ({ $options }; wahrscheinlich { $likely }: { $why })
move-tip-to-object = Den Taster an das Objekt setzen, dann den Punkt aufnehmen
move-sensor-or-stop-scan = Den Sensor über das Teil bewegen oder den Scan stoppen.
moves-check-arm-json =
    { $beside ->
        [bars] { $name } ändert sich um { $change }: arm.json und die Längen der Kugelstäbe prüfen
        [marker] { $name } ändert sich um { $change }: arm.json und den Marker prüfen: seinen Namen in der Spalte marker, wenn er nicht die Tastkugel ist, und seinen Ort, wenn er angegeben ist
       *[arm] { $name } ändert sich um { $change }: arm.json prüfen
    }
multiply-readings-by-inch = Mit 25,4 multiplizieren
name-columns-by-unit =
    { $unit ->
        [deg] Nennen Sie die Spalten mit _rad, oder rechnen Sie die Winkel um
       *[rad] Nennen Sie die Spalten mit _deg, oder rechnen Sie die Winkel um
    }
name-columns-of-degrees = Sie enthalten Grad: die Spalten { $first } … { $last } nennen
name-dh-columns = Nennen Sie die Spalten in einer ersten Zeile, etwa: joint, a [mm], alpha [deg], d [mm], theta [deg]
name-frame-otherwise-than-base = Dem Koordinatensystem einen anderen Namen als base geben
no-arm-has-such-lengths = so klein oder groß ist kein Arm
no-block-fits-sensor = kein Zinnenkörper, der sich fertigen und antasten lässt, passt in dieses Messfeld und diese Schärfentiefe
no-dh-table = Der Text enthält keine Denavit-Hartenberg-Tabelle
no-picture-between-readings = kein Bild von { $path } liegt zwischen zwei Messwerten von { $readings }, die dicht beieinander liegen
no-picture-of-folder-can-be-used = keines der { $count } Bilder ist verwendbar; das erste: { $first }
no-pictures-by-themselves = es werden keine Bilder von selbst aufgenommen
nominal-is-not-this-arm = Ein Nennmodell passt zu jedem Arm seiner Bauart, und zu keinem genau: Identifizieren Sie Ihren Arm, oder geben Sie seine Werkskalibrierung an.
one-of-readings-is-wrong = die Messwerte zeigen nicht, welcher davon falsch ist
only-order-with-right-angles = nur in dieser Reihenfolge sind alle Verdrehungen Vielfache von 90°
pass-over-one-flat-plate = Eine einzige ebene Platte überfahren und ihren Rand auslassen.
paste-dh-table = Fügen Sie je Gelenk eine Zeile mit a, alpha, d und theta ein
picture-whenever-robot-rests = Bei jedem Halt des Roboters ein Bild
pictures-by-themselves = Bilder von selbst
pictures-do-not-fit-delay = { $off } von { $pictures } Bildern passen bei diesem Zeitversatz nicht zu einer Ebene.
nothing-touched-there = er hat sich seither nicht bewegt, der Taster berührt also nichts
picture-of-pixels = { $width_px } × { $height_px } Pixel
one-of-points-off = Mindestens einer der Punkte { $points } liegt neben der Fläche
one-of-touches-off = mindestens einer dieser Punkte liegt daneben, und die übrigen zeigen nicht, welcher: { $points }. Dort zwei weitere Punkte antasten
others-cannot-tell-which = die übrigen zeigen nicht, welcher
places-held-out-agree-too-well = in der Kreuzvalidierung weichen die Positionen nur um das { $times }-Fache des angegebenen Rauschens ab: standard_uncertainty_mm ist zu groß oder in einer anderen Einheit
plus-minus = ± { $uncertainty }
point-off-surface-left-out = Punkt { $index } liegt { $off } neben der Fläche der übrigen. Er ist ausgeschlossen.
point-off-others = Punkt { $index } liegt { $off } neben der Ebene der anderen Punkte { $where }.
point-taken-for = Punkt { $index }, gemeint { $where }; noch nicht beurteilt.
point-beside-face = Punkt { $index } liegt neben der Fläche „{ $face }“: Dort hat er nichts berührt.
points-moved-from-line-on = coordinates.csv: im Koordinatensystem { $name } liegen die Punkte ab Zeile { $line } um { $off } neben denen davor, gemessen am besten Arm
points-scatter-less-than-stated = die Punkte streuen nur um einen kleinen Teil des Angegebenen: standard_uncertainty_mm ist zu groß oder in einer anderen Einheit
poses-agree-read-otherwise =
    { $fault ->
        [inverted] invertiert stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; so, wie sie angegeben sind, widersprechen sie ihnen
        [mirrored] mit gespiegelten Bildern stimmen { $agree } von { $count } Posen auf { $apart } mit „{ $name }“ überein; mit den Bildern, wie sie sind, widersprechen sie einander
        [scalar-first] mit dem Skalar der Quaternion zuerst stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; so, wie sie angegeben sind, widersprechen sie ihnen
        [scalar-first-inverted] invertiert und mit dem Skalar der Quaternion zuerst stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; so, wie sie angegeben sind, widersprechen sie ihnen
        [turns-inverted] mit invertierten Drehungen stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; so, wie sie angegeben sind, widersprechen sie ihnen
        [rotations] { $right ->
            [vector] mit Drehvektoren
           *[other] mit den Winkeln als { $right }
        } stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; so, wie sie angegeben sind, widersprechen sie ihnen
        [unit] mit den Positionen in { $unit } stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; so, wie sie angegeben sind, widersprechen sie ihnen
        [late] ab Pose { $first } sind die Posen { $rows ->
            [one] eine Zeile
           *[other] { $rows } Zeilen
        } zu spät: mit der Pose, die so viel weiter unten steht, stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein
        [early] ab Pose { $first } sind die Posen { $rows ->
            [one] eine Zeile
           *[other] { $rows } Zeilen
        } zu früh: mit der Pose, die so viel weiter oben steht, stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein
        [reversed] in umgekehrter Reihenfolge stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; in der angegebenen Reihenfolge widersprechen sie ihnen
        [sorted] wenn eine Spalte nach Namen (1, 10, 11, 2) und die andere nach Nummern sortiert ist, stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; in der angegebenen Reihenfolge widersprechen sie ihnen
        [swapped] mit vertauschten Posen { $first } und { $other } stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein
        [mixed] in anderer Reihenfolge stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; in der angegebenen Reihenfolge widersprechen sie ihnen
        [tool-changed] mit einem anderen Werkzeug-Koordinatensystem ab Pose { $first } stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern von „{ $name }“ überein; mit einem einzigen widersprechen sie ihnen
        [object-moved] mit „{ $name }“ an einem anderen Ort ab Pose { $first } stimmen { $agree } von { $count } Posen auf { $apart } mit den Bildern überein; mit einem einzigen Ort widersprechen sie ihnen
        [before] { $agree } von { $count } Posen stimmen auf { $apart } mit den Bildern von „{ $name }“ überein, wenn jede zum nächsten Bild gehört; mit dem eigenen nicht
       *[after] { $agree } von { $count } Posen stimmen auf { $apart } mit den Bildern von „{ $name }“ überein, wenn jede zum Bild davor gehört; mit dem eigenen nicht
    }
probe = Taster
range-too-large-for-standoff = ein Messfeld von { $field } und eine Schärfentiefe von { $depth } gehören nicht zu einem Arbeitsabstand von { $standoff }
proxy-changes-host = Die Seite ist unter { $page }, aber ihre Anfrage kam hier für { $host } an.
proxy-does-not-pass-upgrade = Eine Live-Verbindung kam ohne ihr Upgrade an: Ein Proxy reicht WebSockets nicht weiter.
proxy-list-it = Wenn es Ihr Proxy ist, seine Adresse in den Einstellungen unter proxies eintragen.
proxy-not-listed = X-Forwarded-Prefix von { $address } wird nicht verwendet: Kein eingetragener Proxy hat diese Adresse.
proxy-pass-host = Steht ein Proxy vor dem Server, soll er den Host des Browsers weiterreichen; in nginx: proxy_set_header Host $http_host;
proxy-pass-upgrade = Der Proxy soll das Upgrade weiterreichen; in nginx: proxy_http_version 1.1; proxy_set_header Upgrade $http_upgrade; proxy_set_header Connection $http_connection;
proxy-sub-path-unusable = X-Forwarded-Prefix des Proxys wird nicht verwendet: Es ist kein Unterpfad.
read-these-again = Diese noch einmal messen
reading-between-faces = { $place }: ein Messwert von { $first } bis { $second }
reading-far-beside-drawing = { $place }: { $reading } gemessen, wo die Zeichnung { $drawn } hat
reading-in-row = Messwert { $number } ({ $first } bis { $second })
reading-minus-fit = Messwert − Ausgleichung
reading-of-certificate = Messwert
reading-of-other-faces = die Zeile gehört zu anderen Flächen, einem anderen Block oder einer anderen Einheit
reading-off-by = { $reading } um { $off }
readings-agree = Messwerte passen zusammen
readings-agree-if-exchanged = alle Messwerte passen zusammen, wenn { $one } und { $other } getauscht werden
readings-are-apart-nothing-between = die Messwerte liegen im Mittel { $period } auseinander; über mehr als { $longest } wird nicht interpoliert
no-picture-of-folder-has-a-line = keines der { $count } Bilder zeigt eine Linie; das erste: { $first }
no-picture-within-readings = kein Bild von { $path } wurde während der Messwerte von { $readings } aufgenommen, von { $begin } bis { $end }
one-picture-at-a-time = ein Sensor nimmt nur ein Bild zur selben Zeit auf
picture-at-time-of-line = { $place } hat dieselbe time_s wie Zeile { $line }
pictures-are-at = die Bilder beginnen bei { $begin }
readings-are-inches =
    { $count ->
        [one] { $place }: der Messwert passt zur Zeichnung, wenn er in Zoll ist
       *[other] { $place } und die folgenden: { $count } Messwerte passen zur Zeichnung, wenn sie in Zoll sind
    }
readings-contradict-others =
    { $count ->
        [one] ein Messwert widerspricht den anderen: { $first }
       *[other] { $count } Messwerte widersprechen den anderen, vor allem { $first }
    }
readings-expected-in-mm = erwartet werden Millimeter
readings-miss-faces =
    { $count ->
        [one] keine Kette von Messwerten erreicht { $faces }
       *[other] keine Kette von Messwerten erreicht die Flächen { $faces }
    }
readings-must-connect-faces = die Messwerte müssen alle Kanten entlang X verbinden, vorn mit hinten, und Krone, Boden und Unterseite
readings-of-certificate = Messwerte
readings-scatter-more = Die Messwerte streuen { $times }-mal so stark wie angegeben; die Unsicherheiten sind um diesen Faktor größer.
recording-has-joints-named = { $path } hat { $count } Gelenke ({ $names })
recording-keeps-still-lines = Die Aufzeichnung enthält sie alle.
replace-the-datasheet = Das Datenblatt ersetzen; das jetzige bleibt unter den abgelegten erhalten
retired-a-datasheet = legte ein Datenblatt ab
reverse-sign-of-joint = Das Vorzeichen (sign) des Gelenks { $joint } in arm.json umkehren
rotary-joints-only = Verwendbar sind Arme mit Drehgelenken
rotation-means-several = sie können je nach Steuerung Verschiedenes bedeuten: { $names }
rotation-not-stated = { $path }: Nichts sagt, wie { $columns } eine Drehung ergeben
rotation-of-poses = rotation { $name } ist nicht bekannt, oder der Arm meldet Gelenke: Die eines Roboters ist eine von { $names }
save-table-as-csv = Als CSV (UTF-8) mit Kommas zwischen den Spalten speichern
say-what-is-open = Geben Sie für jedes --say KEY=VALUE an
scatter-of-clouds = Punktwolken
scatter-of-points = Punkte
see-that-arm-sends-its-positions = Prüfen, ob der Messarm seine Stellungen sendet, während er sich bewegt
sensor-did-not-move = der Sensor hat sich nicht bewegt
scan-incomplete-again = Der Rest des Teils fehlt in der Punktwolke: Ursache beheben und erneut scannen.
scan-incomplete-remedy = Ursache beheben und erneut scannen; crenel reconstruct --allow-incomplete berechnet die möglichen Punkte, mit Lücken
scan-incomplete-unread = der Rest der Aufzeichnung ist nicht lesbar und kann mehr enthalten als alle bisherigen Punkte
scan-is-incomplete = { $count } von { $total } Bildern mit Linie ({ $share }; Grenze { $limit }) ergaben keine Punkte, weil die Stellung des Messarms unbekannt oder unmöglich war
scan-is-missing-parts = { $path } ist unvollständig: { $missing }
scan-saved-incomplete = { $name } ist mit { $count } Punkten gespeichert, aber unvollständig: { $missing }.
settings-add-as-shown = Ergänzen, wie { $document } es zeigt
settings-certificate-and-key = Zertifikat und Schlüssel gehören zusammen
settings-correct-name = Den Namen berichtigen
settings-give-both-tls = Entweder tls_certificate und tls_key angeben oder keines von beiden
settings-give-pem = Die Datei im PEM-Format angeben
settings-give-proxy = Die Adresse angeben, von der aus der Proxy sich verbindet, als "10.0.0.5" oder "10.0.0.0/24"
settings-give-root-path = Als „/crenel“ angeben: Buchstaben, Ziffern und . _ ~ - zwischen Schrägstrichen, und nicht /api, /assets, /metrics oder /viewer
settings-is-missing = { $named } fehlt
settings-is-unknown = { $named } ist unbekannt
settings-key = { $file }, [{ $table }]: { $key }
settings-key-alone = { $file }: { $key } ist ohne den anderen Schlüssel angegeben
settings-limits-order = was gut ist, muss auch brauchbar sein
settings-limits-reversed = { $file }, [limits]: usable_um = { $usable } ist kleiner als good_um = { $good }
settings-limits-swap = usable_um den größeren Wert geben
settings-missing = { $path }: diese Datei gibt es nicht
settings-must-be-list = der Wert muss eine Liste sein, wie ["eins", "zwei"]
settings-must-be-quoted = der Wert muss ein Text in Anführungszeichen sein
settings-must-be-station-name = erlaubt sind Kleinbuchstaben, Ziffern und Bindestriche, höchstens 40
settings-must-be-table = es muss eine Tabelle sein
settings-must-be-topic-prefix = der Wert muss aus Wörtern mit / dazwischen bestehen, ohne Leerzeichen, # und +
settings-must-be-web-address = der Wert muss mit http:// oder https:// beginnen und einen Rechner nennen
settings-name-as-tables = Die Sensoren so nennen wie ihre Tabellen; delay_us gilt für alle anderen
settings-name-otherwise = Einen anderen Namen geben
settings-name-sensor-tables = Jeden Sensor benennen, wie in [sensor.left]
settings-no-such-sensor = einen Sensor mit diesem Namen gibt es nicht
settings-not-as-shown = er ist nicht so, wie { $document } es zeigt
settings-not-toml = die Datei ist kein TOML: { $reason }
settings-proxy-is = { $file }: proxies enthält { $proxy }
settings-proxy-no-address = das ist keine Adresse
settings-root-path-is = { $place }: Der Unterpfad (root path) ist { $path }
settings-root-path-unusable = das ist kein Unterpfad, den ein Proxy anbieten könnte
settings-sensor-name = der Name eines Sensors besteht aus Buchstaben, Ziffern und Unterstrichen und beginnt mit einem Buchstaben
settings-states-devices = sie nennt den angeschlossenen Messarm und den Sensor
settings-table = { $file }: die Tabelle [{ $table }]
settings-table-name = { $file }: der Name der Tabelle [{ $table }]
settings-trigger-names = { $file }, [trigger]: delays_us nennt { $names }
settings-value-is = { $named } = { $value }
settings-value-of = { $file }: { $key } = { $value }
settings-write-one = Eine schreiben, wie docs/operating.md es zeigt, mit --config eine andere nennen oder crenel demo versuchen
sign-in-add-openid = "openid" ergänzen
sign-in-give-issuer = issuer so angeben, wie die Konfiguration des Anbieters ihn nennt
sign-in-install-library = Installieren mit: pip install 'crenel[oidc]'
sign-in-issuer-is = { $file }, [sign_in]: issuer = { $issuer }
sign-in-issuer-must-be = der Wert muss eine https-Adresse ohne ? und # sein; http nur für einen Anbieter auf diesem Rechner
sign-in-library-missing = die Bibliothek joserfc ist nicht installiert
sign-in-needs-openid = ohne ihn sagt der Anbieter nicht, wer sich anmeldet
sign-in-scopes-lack-openid = { $file }, [sign_in]: scopes enthält 'openid' nicht
sign-in-unusable = { $file }: [sign_in] lässt sich nicht verwenden
so-poses-are-not-what-is-expected =
    { $fault ->
        [inverted] dies sind Posen der Basis des Messarms im Koordinatensystem des Flanschs, oder der Sensor steht fest und der Roboter trägt die Tafel
        [mirrored] die Bilder sind gespiegelt
        [scalar-first] in den Spalten stehen qw, qx, qy, qz
        [scalar-first-inverted] dies sind Posen der Basis des Messarms im Koordinatensystem des Flanschs, und in den Spalten stehen qw, qx, qy, qz
        [turns-inverted] die Drehungen sind die der Basis des Messarms im Koordinatensystem des Flanschs
        [rotations] { $given ->
            [vector] ihre Zahlen wurden für Drehvektoren gehalten
           *[other] ihre Zahlen wurden für Winkel als { $given } gehalten
        }
        [unit] die Positionen sind nicht in mm
        [late] es fehlen Bilder zu den Posen, oder eine Pose wurde doppelt geschrieben
        [early] es fehlt eine Pose, oder ein Bild wurde doppelt aufgenommen
        [reversed] Bilder und Posen stehen in umgekehrter Reihenfolge
        [sorted] Bilder und Posen stehen in verschiedener Reihenfolge
        [swapped] jede gehört zum Bild der anderen
        [mixed] diese Bilder haben die Posen anderer (Bild: seine Pose): { $pairs }
        [tool-changed] das Werkzeug-Koordinatensystem des Roboters wurde geändert oder der Sensor neu montiert
        [object-moved] die Tafel wurde bewegt oder das Basis- oder Benutzer-Koordinatensystem des Roboters geändert
       *[other] Posen und Bilder sind um eins gegeneinander verschoben
    }
source-dh-table =
    { $rows ->
        [one] Denavit-Hartenberg-Tabelle mit einer Zeile
       *[other] Denavit-Hartenberg-Tabelle mit { $rows } Zeilen
    }
source-nominal-arm = { $name }, nach { $source }
source-robot-of-the-list = Ohne Text: ein Roboter der Liste
source-ur-calibration =
    { $calibrated ->
        [yes] Werkskalibrierung eines Arms von Universal Robots
       *[no] Nennmodell eines Arms von Universal Robots (urcontrol.conf)
    }
give-ros-kinematics = Geben Sie die YAML-Datei mit kinematics an, wie der Treiber des Roboters für ROS sie schreibt
ros-has-metres = Geben Sie die Längen in Metern an, wie ROS sie hat
ros-link-count =
    { $count ->
        [0] es fehlt
       *[other] es steht { $count }-mal da
    }
ros-link-cannot-be-used = Das Glied { $link } der Kinematik lässt sich nicht verwenden
ros-number =
    { $there ->
        [yes] { $name } ist { $text }; das ist keine Zahl
       *[no] { $name } fehlt
    }
source-ros-kinematics = Kinematik eines Arms von Universal Robots, wie ROS dessen Werkskalibrierung aufbewahrt
source-urdf = URDF von { $name }
sphere-diameter-not-read = der Kalibrierschein nennt keinen Durchmesser der Kugeln oder mehrere: sphere_diameter_mm in der Datei eintragen
expected = erwartet wird { $wanted }
expected-by-datasheet-and-expanded-uncertainty = laut Datenblatt { $expected }; U = { $expanded_uncertainty }, k = 2
exposure-cannot-be-set-by-line = Die Belichtung lässt sich nicht an die Laserlinie anpassen
extracting-laser-stripe = Laserlinie wird ausgewertet
extraction-detection = Extraktion und Erkennung
face = Fläche
face-and-number = { $face } { $number }
face-can-turn-about-line = die Fläche lässt sich um diese Gerade drehen
face-has-points-go = Diese Fläche hat genügend Punkte. Weiter mit: { $face }.
faces-agree-to = { $first } und { $second } auf { $opening }
faces-are = die Flächen sind { $names }
faces-contacts = { $faces } Flächen für { $contacts } Antastpunkte
fail = Nicht bestanden
activity-failed = { $title }: fehlgeschlagen
fanuc-check-option = Adresse prüfen, und ob die Steuerung die Option Stream Motion hat.
fanuc-check-other-client = Prüfen, dass kein anderes Programm Stream Motion dieser Steuerung verwendet, dann die Steuerung neu starten.
fanuc-no-answer = Der Roboter unter { $address } antwortet nicht wie Stream Motion
fanuc-old-version = Der Roboter unter { $address } bietet Version { $version } von Stream Motion, nötig ist Version 3
fanuc-report-faceplate = Stream Motion an der Steuerung auf den Flansch einstellen oder report = "joints" verwenden.
fanuc-reports-tool = Stream Motion des Roboters unter { $address } meldet die Pose des Werkzeugs statt der des Flansches
fanuc-sends-no-status = Der Roboter unter { $address } antwortet, sendet aber keinen Status
fanuc-update = Die Software der Steuerung aktualisieren.
far-out = weit außen
fault = Ursache: { CAPITAL($fault) }. { $text }
fetch-it-first = Zuerst holen
fetched-scan = Scan aus dem Archiv geholt
few-poses = { $poses } Posen ergeben { $figures } Werte für { $unknown } Unbekannte und prüfen sie kaum: { $wanted } Posen messen, über die ganze Reichweite verteilt
fewest-in-patch = Wenigste je Stelle
field-is = { $path }: { $place } ist { $value }
field-missing =
    { $more ->
        [0] { $path }: { $place } fehlt
       *[other] { $path }: { $place } fehlt (und { $more } weitere)
    }
field-must-be-less-than-half-square = { $field } muss kleiner als ein halbes Feld sein; ist der Wert in Mikrometern angegeben?
field-name = { $name }
figure = Kenngröße
figure-between-close-limits =
    { $title }: { $value }; die Grenzwerte von ±{ $limit } liegen im Vergleich zum Schutzabstand von { $guard } nahe beieinander: { $decision ->
        [pass] nach der Regel bestanden.
        [fail] nach der Regel nicht bestanden.
       *[uncertain] nicht entschieden.
    }
figure-beyond-guard = { $title }: { $value }, über dem Grenzwert von { $limit }, um mehr als den Schutzabstand von { $guard }.
figure-beyond-limit = { $title }: { $value }, über dem Grenzwert von { $limit }, um mehr als die Unsicherheit von { $uncertainty } (k = 2).
figure-near-guard =
    { $title }: { $value }, näher am Grenzwert von { $limit } als der Schutzabstand von { $guard }: { $decision ->
        [pass] bestanden, da der Anwender die Unsicherheit trägt.
        [fail] nicht bestanden, da der Lieferant die Unsicherheit trägt.
       *[uncertain] nicht entschieden.
    }
figure-near-limit = { $title }: { $value }, näher am Grenzwert von { $limit } als die Unsicherheit von { $uncertainty } (k = 2), daher nicht entschieden.
figure-within-guard = { $title }: { $value }, innerhalb des Grenzwerts von { $limit }, um mehr als den Schutzabstand von { $guard }.
figure-within-limit = { $title }: { $value }, innerhalb des Grenzwerts von { $limit }, um mehr als die Unsicherheit von { $uncertainty } (k = 2).
figure-without-guard =
    { $title }: { $value }, { $how ->
        [beyond] über dem Grenzwert
       *[within] innerhalb des Grenzwerts
    } von { $limit }.
figures-against-their-limits = Kenngrößen und ihre Grenzwerte
figures-before = { $text }: Die Werte sind nicht mehr aktuell.
figures-break-limits-not-compared = Nicht alle Kenngrößen halten ihren Grenzwert ein; Scan und Taster wurden nicht verglichen.
figures-keep-limits-not-compared = Alle Kenngrößen halten ihren Grenzwert ein; Scan und Taster wurden nicht verglichen.
figures-undecided-not-compared = Nicht alle Kenngrößen sind für eine Entscheidung genau genug bestimmt; Scan und Taster wurden nicht verglichen.
file = eine Datei
file-column = Datei
file-carries-no-verdict = Die Datei enthält keine Entscheidung.
file-cut-off = die Datei ist unvollständig
file-damaged = die Datei ist beschädigt
file-has-name-folder-needed = eine Datei trägt den Namen eines benötigten Ordners
file-has-no-contact-points = { $path } enthält keine Antastpunkte
file-has-no-pictures = { $path } enthält keine Bilder
file-has-no-points = { $path } enthält keine Punkte
file-larger-than-any-read = so große Dateien werden hier nicht gelesen
file-name-is-not-utf-8 = Der Name von { $name } ist kein gültiger UTF-8-Text
files-no-longer-in-data-folder = ihre Dateien sind nicht mehr im Datenordner
files-searched = Gesucht wird nach { $suffixes }.
filters-of-figures = Filter: Punkte, die weiter als { $sigmas } Standardabweichungen vom Ausgleich entfernt sind, und Bilder innerhalb von { $place } eines früheren werden nicht verwendet. Für die Form über alle Punkte werden sie verwendet.
finder-failed = Die Suche { $name } von { $package } ist fehlgeschlagen: { $kind }: { $error }
finder-takes-too-long = Die Suche { $name } wurde nicht rechtzeitig fertig
finding-objects-edges = Kanten des Objekts werden gesucht
finding-start = Startwerte werden bestimmt
finding-what-and-why = { CAPITAL(CLAUSE($what)) }: { CLAUSE($why) }
findings = Befunde
finish-cloud-drop = Diese Punktwolke abschließen oder verwerfen.
finish-cloud-first = Zuerst diese Punktwolke abschließen.
finish-sphere = Kugel abschließen
finish-swing = Schwenk abschließen
finished-cloud = Punktwolke abgeschlossen
finished-seat = Position abgeschlossen
finite-number-decimal-point-expected = erwartet wird eine endliche Zahl mit Dezimalpunkt
firmware-must-answer-hello = Die Firmware muss die Hello-Anfrage beantworten (crenel_hardware.arm.protocol).
firmware-must-answer-pulse-request = Seine Firmware muss Impulsanforderungen beantworten (crenel_hardware.arm.protocol).
firmware-must-send-counts-of-hello = Die Firmware muss so viele Werte senden, wie ihr Hello ankündigt.
firmware-must-send-what-hello-announces = Seine Firmware muss senden, was ihr Hello ankündigt.
first-basler-camera = Die Kamera von Basler
first-genicam-camera = Die GenICam-Kamera
first-gentl-camera = Die GenTL-Kamera
first-line-names = die erste Zeile nennt { $names }
first-line-names-column-count =
    die erste Zeile nennt { $count ->
        [one] { $count } Spalte
       *[other] { $count } Spalten
    }
first-to-last-group =
    { $first } bis { $last }: { $count ->
        [one] { $count } Gruppe
       *[other] { $count } Gruppen
    }
fit-does-not-converge = die Ausgleichung konvergiert nicht
fit-follows-these-points-arm = die Ausgleichung folgt diesen Punkten und nicht dem Messarm
fit-plane-sphere-cylinder-first = zuerst eine Ebene, eine Kugel oder einen Zylinder einpassen
fitting =
    { $shape ->
        [plane] Ebene wird eingepasst
        [sphere] Kugel wird eingepasst
       *[cylinder] Zylinder wird eingepasst
    }
fitting-arm = Armparameter werden ausgeglichen
fitting-contact-points = Antastpunkte werden ausgeglichen
not-five-to-seven-joints = { $field }: erwartet werden fünf bis sieben Gelenke, nicht { $joints }
fix-board-flat-plate = Tafel auf einer ebenen Platte befestigen.
fix-board-so-cannot-rock-warp = Tafel so befestigen, dass sie nicht wackeln oder sich verziehen kann, und das Objektiv der Kamera feststellen.
fix-object-arm-so-neither-can = Objekt und Messarm so befestigen, dass sich keines bewegen kann, das Objekt antasten und die Bilder neu aufnehmen.
flange-differs = der Flansch weicht um { $moved } ab
flange-turned-most-between-poses = der Flansch hat sich zwischen den { $count } Posen höchstens um { $turn } gedreht
flange-frame-of-this-arm-former-calibrations-not-valid = Das Flanschsystem ist jetzt das dieses Messarms: Kalibrierungen mit dem bisherigen Messarm gehören nicht dazu.
flat-board-tells-cameras-focal-length = eine ebene Tafel bestimmt die Brennweite der Kamera ab { $fewest_poses } gegeneinander geneigten Bildern
fleet-arm-half-range = Armprüfung: halbe Spannweite längs der schlechtesten Achse
fleet-arm-largest = Armprüfung: größter Abstand vom Mittelwert, räumlich
fleet-arm-two-sigma = Armprüfung: 2 Sigma längs der schlechtesten Achse
fleet-cloud-process-ended = Der Prozess für die Punktwolke endete mit Status { $status }
fleet-clouds-make-room = Schaffen Sie dort Platz, oder verkleinern Sie limit_gb in [clouds] der fleet.toml
fleet-clouds-no-place = fleet.toml nennt keinen Ort mit den Datensätzen von { $station }: Mit archive oder data in [stations.{ $station }] können hier Punktwolken berechnet werden
fleet-clouds-queue-full = Es warten schon zu viele Punktwolken; versuchen Sie es mit dieser später
fleet-contacts-rms = Antastpunkte zu ihren Flächen, rms
fleet-focal-length-u = Brennweite längs der Zeilen
fleet-focal-length-v = Brennweite längs der Spalten
fleet-give-own-place = Geben Sie jeder Station ein eigenes Archiv und einen eigenen Datenordner
fleet-give-place = Geben Sie archive = {"{"} url = "…" {"}"} oder data = "…" an
fleet-laser-plane-offset = Abstand der Laserebene vom Ursprung
fleet-laser-plane-rms = Linienpunkte zur Laserebene, rms
fleet-library-missing = Die Bibliotheken der Flotte fehlen: { $libraries }
fleet-name-cloud-folder = Nennen Sie in [clouds] der fleet.toml einen eigenen Ordner
fleet-name-page-password = Nennen Sie eine Datei, die nur das Passwort der Seite enthält
fleet-name-password-file = Nennen Sie eine Datei, die nur das Passwort der Datenbank enthält
fleet-no-cloud = Diese Punktwolke gibt es nicht mehr: { $name }
fleet-no-marker = crenel-archive.txt fehlt darin; die Station schreibt es mit ihrem ersten Datensatz
fleet-no-record = Der Katalog hat keinen solchen Datensatz: { $id }
fleet-of-gauge = Prüfnormal: { $title }
fleet-open-to-all = Jeder, der { $host } erreicht, könnte den Katalog lesen
fleet-password-empty = { $file } ist leer
fleet-point-uncertainty = Standardunsicherheit eines Punktes (k = 1)
fleet-probe-translation = Messkopfmatrix, Verschiebung längs { $axis }
fleet-reprojection-rms = Rückprojektionsfehler, rms
fleet-set-password = Setzen Sie password_file in [server] oder [sign_in] der fleet.toml, oder lassen Sie --host bei 127.0.0.1
fleet-station-has-no-place = { $file }, [stations.{ $station }]: es gibt weder ein Archiv noch einen Datenordner
fleet-stations-share-place = { $file }: die Stationen { $other } und { $station } haben denselben Ort, { $place }
fleet-tip-diameter-error = Tastkugelprüfung: Durchmesserabweichung
fleet-tip-scatter = Tastkugelprüfung: Streuung der Antastpunkte
fleet-write-settings = Schreiben Sie eine, wie docs/fleet.md zeigt, oder nennen Sie eine andere mit --config
floors-grooves = Nutgründe
focal-length = Brennweite
focal-lengths = { $u } × { $v }
focus-camera-object-bring-into-working = Kamera auf das Objekt scharf stellen, es in den Arbeitsabstand bringen, ruhig halten
focus-camera-bring-object-and-hold-still = Kamera auf das Objekt scharf stellen, es in den Arbeitsabstand bringen und ruhig halten
focus-light-board-evenly = Kamera scharf stellen und die Tafel gleichmäßig beleuchten
folder-cannot-be-written = in den Ordner { $folder } lässt sich nicht schreiben
folder-has-none-of = er enthält keine der Dateien { $names }
folder-inside-data-folder = { $folder } liegt im Datenordner
folder-named = Der Ordner { $folder }
folder-their-own = aus einem eigenen Ordner
folder-there-already = { $folder } existiert bereits
folders-next-to-it-not-empty = daneben liegen bereits Daten, in { $folders }
form-95-m = Form 95 %, gefiltert, µm
form-all-m = Form 95 % aller, µm
form-all-points-in-gate = Form aller Punkte (95 %)
form-cloud-95-points = Form, gefiltert (95 % der Punkte)
form-max-min-m = Form (max − min), µm
format-expected = erwartet wird hier { $format }
frame-has-pixels = { $path }: Bild { $number } hat { $width_px } × { $height_px } Pixel
frame-has-points = coordinates.csv: Koordinatensystem { $name } hat { $count } Punkte
frame-named = Koordinatensystem { $name }
frame-shows-only-s-visible-edges = das Bild zeigt nur { $share } der sichtbaren Kanten von „{ $name }“
frame-without-joints-around-gives-no = Ein Bild ohne benachbarte Messwerte des Messarms ergibt keine Punkte.
frames-joint-samples-which-neighbours-up = Bilder von { $frames_from } bis { $frames_to }, Messwerte des Messarms von { $joints_from } bis { $joints_to }; verwendet werden Nachbarn mit höchstens { $gap } Abstand
frames-left-out-no-joints-around = { $count } von { $frames } Bildern ausgelassen: keine Messwerte des Messarms um ihre Zeitstempel, das erste { $first } nach Beginn; { $beyond } vor dem ersten oder nach dem letzten Messwert, { $gaps } in Lücken
frames-lost-when-full-scan-more = Ist sie voll, gehen Bilder verloren; langsamer scannen oder andere Programme schließen.
free = { $free } sind frei.
free-enough-for-hours = { $free } sind frei, genug für { $hours } Stunden dieses Scans.
free-on-disk = { $free } sind auf dem Datenträger von { $folder } frei
free-some-space = Speicherplatz freigeben
free-some-space-choose-another-disk = Speicherplatz freigeben oder einen anderen Datenträger wählen
free-some-space-start-again = Speicherplatz freigeben und neu starten
free-some-space-then-do-again = Speicherplatz freigeben, dann erneut versuchen
free-some-space-try-again = Speicherplatz freigeben und erneut versuchen
from = Von
from-to = { $low } bis { $high }
front = von vorn
front-face = Vorderseite
front-y-mm-must-less-than = { $front } muss kleiner als { $back } sein
further-cloud-aside-one-other-s =
    { $aside ->
        [one] { $aside } weitere Punktwolke wurde ausgeschlossen.
       *[other] { $aside } weitere Punktwolken wurden ausgeschlossen.
    }
gate-and-filters = Welche Punkte zählen
gate-of-plane = Auswahl aller Punkte: die gescannte Fläche, bis { $gate } von der Ebene.
gate-of-sphere = Auswahl aller Punkte: bis { $gate } von der kalibrierten Kugel und bis { $angle } von der Mitte des Scans.
gauge = Prüfnormal
gauge-clamped = Dieses Prüfnormal ist aufgespannt
gauge-shape = { $path }: shape ist { $shape }
gauge-touched-only-shape-size-judged = Das Prüfnormal wurde nicht angetastet: Beurteilt werden nur Form und Größe.
gauge-touched-shape-size-only = das Prüfnormal wurde nicht angetastet: nur Form und Größe
gauges-are-plane-or-sphere = Prüfnormale sind eine Ebene oder eine Kugel
gave-no-picture-within = { $title } hat innerhalb von { $time } kein Bild geliefert
gentl-producer-missing = Es gibt keinen GenTL-Producer ({ $producer })
gentl-producer-unusable = Die Datei { $producer } ist kein GenTL-Producer für diesen Rechner ({ $reason })
give-a-calibration-for-each-sensor = die Kalibrierung jedes Sensors mit seinem Namen angeben, z. B. { $name }=calibration.json
give-arm-its-own-times-or-no-other-traffic = Den Messarm die Zeit jeder Messung selbst angeben oder jede sofort senden lassen, über ein Kabel und ohne anderen Datenverkehr
give-arm-json-arm-took = arm.json des Messarms angeben, mit dem aufgenommen wurde
give-arm-json-arm-took-recording = arm.json des Messarms angeben, mit dem diese Aufzeichnung entstand
give-arms-own-model-columns = Modell dieses Messarms oder die Spalten { $names } angeben
give-axis = --axis { $axis } angeben
give-calibration-sensor-took-picture = Kalibrierung des Sensors angeben, der dieses Bild aufgenommen hat
give-calibration-sensor-took-recording = Kalibrierung des Sensors angeben, mit dem diese Aufzeichnung entstand
give-calibration-without-name = seine Kalibrierung ohne Namen angeben
give-cameras-own-picture = Unverändertes Bild der Kamera angeben
give-certificate-board-picture = den Kalibrierschein der Tafel im Bild angeben
give-certificate-crenellated-object-calibrate-command = Kalibrierschein eines Zinnenkörpers angeben oder auf der Kommandozeile kalibrieren
give-certificate-first =
    { $kind ->
        [bar] Zuerst die Länge des Kugelstabs laut Kalibrierschein angeben.
       *[sphere] Zuerst den Durchmesser der Kugel laut Kalibrierschein angeben.
    }
give-certificate-of-charuco-board = den Kalibrierschein der Tafel im Bild angeben; squares_x, squares_y und legacy_pattern prüfen
give-certificate-or-uncover-board = den Kalibrierschein der Tafel im Bild angeben oder den Rest dieser Tafel freilegen
give-cloud-millimetres = Eine Punktwolke in Millimetern angeben
give-denavit-hartenberg-model = Denavit-Hartenberg-Modell des Messarms angeben (convention „dh-standard“)
give-each-own-name-station-mqtt = Jeder Station mit station in [mqtt] der station.toml einen eigenen Namen geben.
give-each-seat-name-own = Jeder Pfanne einen eigenen Namen geben
give-files-belong-together = Zusammengehörige Dateien angeben
give-folder-station-started = Den Ordner angeben, mit dem die Station gestartet wurde
give-folder-user-may-write-data = Mit --data einen Ordner angeben, in den dieser Benutzer schreiben darf
give-gauges-own-nominal = Sollwerte dieses Prüfnormals angeben
give-laser-on-off-pair = Ein Bild mit eingeschaltetem Laser und eines derselben Szene ohne Laser angeben
give-length-mm-bar-millimetres-check = length_mm von Kugelstab { $name } in Millimetern angeben und seine Zeilen prüfen
give-mask-sensor-took-picture = Maske des Sensors angeben, der dieses Bild aufgenommen hat
give-more-recordings-plane-more-calibrations = Weitere Aufzeichnungen der Ebene oder weitere Kalibrierungen angeben
give-one-first = Zuerst eine Adresse angeben
give-one-number-all-joints-one = Einen Wert für alle Gelenke oder für jedes Gelenk einen angeben.
give-picture-as-taken-and-sensor-json = Das Bild so angeben, wie die Kamera es aufgenommen hat, und die richtige sensor.json
give-planes-own-nominal = Sollwerte dieser Ebene angeben
give-qx-qy-qz-qw-order = qx, qy, qz, qw in dieser Reihenfolge angeben, den Skalarteil zuletzt
give-raw-or-without-bayer = Rohbilder der Kamera angeben oder bayer weglassen
give-recording-as-documented = Eine Aufzeichnung nach docs/formats.md angeben
give-right-arm-json-columns = Richtige arm.json oder die Spalten { $first } bis { $last } angeben
give-right-file = Richtige Datei angeben
give-rotation-of-marker-in-frame = Die Drehung der Messmarke im Koordinatensystem des Messgeräts angeben: qx, qy, qz, qw mit dem Skalarteil zuletzt, oder rx_deg, ry_deg, rz_deg
give-rows-different-pose-numbers-take = Den Zeilen verschiedene Posennummern geben oder die Bilder neu aufnehmen
give-seat-own-name-check-arm-json = Jeder Pfanne einen eigenen Namen geben; arm.json prüfen
give-standard-uncertainty-of-certificate = Standardunsicherheit (k = 1) laut Kalibrierschein in Millimetern angeben
give-standard-uncertainty-of-instrument = Standardunsicherheit (k = 1) einer Koordinate oder eines Winkels angeben
give-station-data-folder-own = Der Station einen eigenen Datenordner geben
give-tip-or-leave-out-probing = Tastkugel in arm.json angeben oder probing.csv weglassen
go-back-take-picture-points-again = Zurückgehen und das Bild oder die Punkte neu aufnehmen.
go-calibrating = Kalibrierung fortsetzen
go-checking-arm = Mit dem Arm fortfahren
go-faster = Schneller führen, { $speed } oder mehr
go-faster-farther-over-plate-nearer = Den Sensor schneller und weiter über die Platte führen, mehrmals näher heran und wieder weg
go-further-away-object-does-fit = Weiter weg: Das Objekt passt nicht ganz ins Bild
go-over-these-places-again-slower = Diese Stellen noch einmal langsamer überfahren.
go-pictures-touches-spread-over-printed = Weiter zu den Bildern. Mit { $wanted } über die bedruckte Seite verteilten Antastpunkten ließe sich die Größe der Felder prüfen.
go-pose-count-one-other-s =
    { $count ->
        [one] Weiter mit { $count } Pose
       *[other] Weiter mit { $count } Posen
    }
go-scanning = Weiter zum Scannen
go-slower-shorten-exposure = Langsamer führen oder kürzer belichten.
go-swinging-least-points = Weiter schwenken: { $taken } von mindestens { $least } Punkten.
go-testing = Leistungsprüfung fortsetzen
go-verifying = Verifizierung fortsetzen
go-without-probe = Ohne Taster fortfahren
goes-beyond-end =
    { $side ->
        [right] { $edge } reicht über ihr rechtes Ende hinaus
       *[left] { $edge } reicht über ihr linkes Ende hinaus
    }
good = Gut
good-m-usable-m = gut ≤ { $good }, brauchbar ≤ { $usable }
good-up-m = gut bis { $limit }
grey-encodings-expected = erwartet wird Grau: { $encodings }
grey-levels = Graustufen
guided-session-is-open =
    auf der Seite { $kind ->
        [calibration] „Kalibrieren“
        [verification] „Verifizieren“
        [performance] „Leistung“
       *[arm] „Messarm und Tastkugel“
    } ist eine geführte Sitzung offen
guided-steps = Geführte Schritte
had-calculated = Berechnung gestartet
had-calculated-without-laser = Berechnung ohne den Laser gestartet
had-simulation-pass-over-plate = simulierte Überfahrt über die Platte gestartet
half-them-more-contradicting-others-none = widerspricht mindestens die Hälfte den übrigen, ist keiner zu trauen
hides-arm-joints = Längenabweichungen zwischen Kugeln, die über viele Antastungen mitteln
hides-arm-links = Form einer kleinen Kugel
hides-clock = alle Werte durch Antasten, und langsame Scans
hides-laser-plane = alle Werte durch Antasten
hides-probe-matrix = alle Werte durch Antasten; Form und Streuung einer Kugel, die in einer Orientierung gescannt wurde
hides-sensor-scale = Lage der gescannten Kugel
hides-stripe-noise = Lage und Größe: Sie mitteln über viele Punkte
hides-tip-diameter = Lage, und Längen von Mittelpunkt zu Mittelpunkt
implied-offset = Fehler der Messkopfmatrix, auf den die Mittelpunkte schließen lassen
implied-offset-caption =
    Im Koordinatensystem des Sensors liegt der Sensor in Wirklichkeit { $size } neben der Stelle, an der die Messkopfmatrix ihn hat; dünne Balken sind die zweifache Standardunsicherheit. { $significant ->
        [yes] Das ist mehr als Zufall: Den Sensor erneut kalibrieren.
       *[no] Das ist nicht mehr als Zufall.
    } Ohne diesen Fehler bliebe eine Lageabweichung von { $left }.
in-space-largest-and-two-s = Räumlich: größter Abstand vom Mittelwert { $largest }, 2 s { $two_s } (Kennwerte nach ASME B89.4.22, hier für eine Pfanne).
install-extra-xlsx = Mit pip install 'crenel[xlsx]' installieren oder CSV verwenden
its-sensor-has-no-name = ihr Sensor hat keinen Namen
its-sensors-are = ihre Sensoren sind { $names }
join-group-of-device = Führen Sie „{ $command }“ aus, melden Sie sich dann neu am System an und starten Sie Crenel neu.
kuka-add-element = In der Ethernet-Konfiguration der Steuerung unter SEND ein Element mit TAG="DEF_{ $name }" ergänzen.
kuka-lacks-element = Die Pakete des Roboters unter { $address } enthalten kein { $name }
kuka-no-rsi = Was der Roboter unter { $address } sendet, ist kein RSI
kuka-start-rsi = RSI an der Steuerung starten (RSI_ON). In ihrer Ethernet-Konfiguration muss ONLYSEND auf TRUE stehen, mit Adresse und Port dieses Rechners.
largest-distance-from-mean = Größter Abstand vom Mittelwert, räumlich
laser-off-or-covered = der Laser ist aus, verdeckt oder zu schwach
laser-on-not-brighter = das Bild mit Laser ist nicht heller als das ohne Laser
laser-on-off-differ = die Bilder mit und ohne Laser sind verschieden: { $on } und { $off } Pixel
length-standard = Längennormal
line-along-other-axis =
    { $axis ->
        [u] eine Linie mit { $points } Punkten verläuft von oben nach unten
       *[v] eine Linie mit { $points } Punkten verläuft quer
    }
location-fixed-diameter = Lage, fester Durchmesser
location-over-articulations = Lage über die Stellungen
maximum-permissible-error = Größte zulässige Abweichung
measured-channel = gemessen: { $channel }
measurement-u = U, k = 2
microscribe-needs-five-joints = Dieser Treiber ist nur für MicroScribe mit fünf Gelenken.
microscribe-no-answer = Unter { $url } antwortet kein MicroScribe
microscribe-other-device = Das Gerät unter { $url } antwortet nicht wie ein MicroScribe
microscribe-stopped-answering = Der MicroScribe unter { $url } antwortet nicht mehr
move-bayer-to-station-toml = bayer und laser_colour in [sensor] von station.toml setzen; bayer aus dem Datenblatt entfernen und width_px und height_px halbieren
name-joints-as-recording = Die Gelenke in arm.json nennen, wie die Aufzeichnung sie nennt, oder die arm.json des Arms angeben, der die Aufzeichnung gemacht hat
name-quantity = Die Größe mit { $option } benennen
need-arm-model = Modell des Arms
need-first-calibration = Erste Kalibrierung
need-sensor-datasheet = Datenblatt des Sensors
need-target = Zinnenkörper oder Tafel
never-tested = Noch nie geprüft.
no-arm-model-yet = Wie der Arm gebaut ist, ist noch nicht bekannt. Seine Gelenke eingeben (D-H-Tabelle), oder dass er ein Roboter ist, der Posen meldet.
no-arm-without-datasheet = Es ist kein Messarm ohne Datenblatt angeschlossen, der Posen meldet
no-board-yet = Ein Roboter, der Posen meldet, wird mit einer Tafel kalibriert. Noch ist keine bekannt.
no-camera-without-datasheet = Es ist keine Kamera ohne Datenblatt angeschlossen
no-datasheet-fits-sensor = Keiner der eingegebenen Sensoren ist der verbundene. Auch ihn eingeben.
no-dcc = die Datei ist kein digitaler Kalibrierschein (DCC)
no-device-chosen = Es ist kein { $title } gewählt
no-model-fits-connected-arm = Keiner der eingegebenen Arme ist der verbundene. Auch ihn eingeben.
no-sensor-datasheet-yet = Die Pixel des Sensors und die Richtung seiner Linie sind noch nicht bekannt. Danach wird gefragt, sobald er angeschlossen ist.
no-sensor-named = diese Station hat keinen Sensor namens { $name }
no-target-yet = Noch ist kein Zinnenkörper und keine Tafel bekannt.
one-pose-takes-no-raw = eine einzelne Pose lässt sich nicht aus Bayer-Rohbildern kalibrieren
opens-again = Die Verbindung öffnet sich von selbst wieder; danach den letzten Schritt wiederholen.
origin-of-figures = Herkunft der Werte
output-away = Die Ausgabe { $place } ist nicht erreichbar
output-check-access = Prüfen Sie die Schlüssel und die Rechte dort, oder geben Sie mit -o eine andere Ausgabe an
output-create = Legen Sie den Ordner oder Bucket an, oder geben Sie mit -o eine andere Ausgabe an
output-forbidden = Die Ausgabe { $place } verweigert den Zugriff
output-full = Die Ausgabe { $place } ist voll
output-make-room = Schaffen Sie dort Platz, oder geben Sie mit -o eine andere Ausgabe an
output-missing = Die Ausgabe { $place } ist nicht da
performance-accept = Prüfung abschließen
performance-all-scanned = Alle fünf Stellungen sind gescannt.
performance-all-touched = Alle Stellen dieses Schritts sind angetastet. Weiter.
performance-another-length-not-taken = Diese Antastung ergibt eine Länge von { $found } statt { $wanted }; sie wurde nicht übernommen
performance-another-step =
    { $step ->
        [artefact] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Prüfkörper und Grenzwerte“.
        [pattern] Das gehört zu einem anderen Schritt; die Prüfung steht bei „25 Antastungen“.
        [location] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Lage durch Antasten“.
        [scan] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Fünf Scans“.
        [end] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Nochmals antasten“.
        [lengths] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Längen“.
        [plate] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Zwei Scans“.
        [diameter] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Meisterkugel“.
        [seats] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Drei Pfannen“.
        [bar] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Kugelstab“.
        [temperatures] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Temperaturen“.
       *[review] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Ergebnis“.
    }
performance-arm-not-turned-enough = Der Arm steht wie bei einer früheren Antastung in dieser Pfanne: Er drehte sich um { $turned }, nötig sind { $least }. Diese Antastung wurde nicht übernommen
performance-artefact-is-ready =
    { $test ->
        [lengths] Das Normal ist bereit
        [plane] Die Platte liegt fest
        [contact] Die Prüfkörper sind bereit
       *[other] Die Kugel ist fest
    }
performance-articulate-arm = Den Ellbogen bewegen oder das Handgelenk drehen und noch einmal antasten
performance-articulation =
    { $number ->
        [1] Von oben
        [2] Vom Arm weg geneigt
        [3] Nach rechts geneigt
        [4] Zum Arm hin geneigt
       *[other] Nach links geneigt
    }
performance-articulations-missing =
    { $missing ->
        [one] Eine Stellung ist noch nicht gescannt.
       *[other] { $missing } Stellungen sind noch nicht gescannt.
    }
performance-aside-note = { $title }: { $reason }
performance-bar-of-contact-test = Nur die Antastprüfung hat neben der Kugel einen Kugelstab.
performance-bar-run = Lage { $place }, Scan { $repeat } des Stabs
performance-bar-scan = Scan { $repeat }
performance-bar-scan-done = Scan { $repeat } des Stabs in Lage { $place } ist übernommen.
performance-bar-scan-name = Leistungsprüfung, Lage { $place }, Scan { $repeat }
performance-bar-scan-of-length = Scan { $repeat }, die Kugeln von { $length }
performance-bar-was-moved = Der Stab wurde seither in einer anderen Lage angetastet: Die Scans der Lage davor gelten.
performance-began-scan = hat einen Scan des Prüfkörpers begonnen
performance-begin-scan = Scan beginnen
performance-brought-to-20 = Größen und Längen sind auf 20 °C bezogen; der Prüfkörper hatte { $celsius }.
performance-not-brought-to-20 = Der Prüfkörper hatte { $celsius }. Sein Ausdehnungskoeffizient ist nicht angegeben: Größen und Längen sind nicht auf 20 °C bezogen.
performance-by-touch-alone = Die Längen dieser Prüfung werden nur durch Antasten gemessen.
performance-camera-off-articulation = Die Kamera blickt { $off } neben der gewünschten Richtung (höchstens { $most }).
performance-cancelled-device = Abgebrochen: Ein Gerät ist ausgefallen.
performance-cancelled-moved = Abgebrochen: Prüfkörper oder Arm hat sich bewegt.
performance-cancelled-operating = Abgebrochen: Bedienfehler, wiederholt.
performance-cancelled-other = Vom Bediener abgebrochen.
performance-cancelled-plan = Abgebrochen: Plan, Kalibrierung oder Einstellungen wurden geändert.
performance-cannot-read = Der Eintrag der Leistungsprüfung { $one } ist nicht lesbar.
performance-cap-not-below-a = Die Obergrenze B darf nicht kleiner als A sein.
performance-change-temperatures = Temperaturen ändern
performance-choose-artefact =
    { $test ->
        [lengths] Zuerst ein Längennormal wählen.
        [plane] Zuerst eine Platte wählen.
        [contact] Zuerst eine Kugel oder einen Kugelstab wählen.
       *[other] Zuerst eine Kugel wählen.
    }
performance-chose-bar = hat den Kugelstab gewählt
performance-clamp-seat =
    { $number ->
        [1] Die Pfanne nahe der Schulter festklemmen, bei höchstens einem Fünftel der Reichweite.
        [2] Die Pfanne etwa bei halber Reichweite festklemmen.
       *[other] Die Pfanne bei vier Fünfteln der Reichweite oder weiter festklemmen.
    }
performance-confirm-temperatures = Temperaturen bestätigen
performance-confirmed-artefact = hat den Prüfkörper bestätigt
performance-confirmed-step = hat einen Schritt bestätigt
performance-contact-title =
    { $step ->
        [diameter] Kugel, Messung { $number }
        [seats] { $number ->
            [1] Nahe Pfanne
            [2] Mittlere Pfanne
           *[other] Ferne Pfanne
        }
       *[bar] Lage { $number }
    }
performance-correct-gauge = Die Datei im Ordner gauges berichtigen oder eine andere wählen.
performance-diameter-error = Abweichung des Durchmessers { $error }
performance-do-artefact-and-limits =
    { $test ->
        [lengths] Das Längennormal wählen. Sollen die Längen beurteilt werden, A, K und B aus dem Datenblatt eintragen.
        [plane] Die Platte wählen und in den Arbeitsraum des Arms legen. Soll ihre Form beurteilt werden, den Grenzwert eintragen.
        [contact] Meisterkugel und Kugelstab wählen und die Kugel in der Mitte der Reichweite befestigen. Was nicht vorhanden ist, entfällt. Sollen Grenzwerte beurteilt werden, sie aus dem Datenblatt eintragen.
       *[other] Die Prüfkugel wählen und im Arbeitsraum des Arms befestigen. Sollen Grenzwerte beurteilt werden, sie aus dem Datenblatt eintragen.
    }
performance-do-end = Die Kugel noch fünfmal antasten: Das zeigt, ob sie sich bewegt hat.
performance-do-review =
    { $test ->
        [lengths] Die Abweichungen aller Längen gegenüber der zulässigen.
        [plane] Die Form der gescannten Platte: die schmalste Schicht, die 95 % aller Punkte enthält, in der schlechteren Ausrichtung.
        [contact] Wirksamer Durchmesser, Einzelpunkt-Schwenkprüfung und räumliche Länge.
       *[other] Maß, Form und Lage der Kugel durch Antasten, durch Scannen und aus beidem zusammen.
    }
performance-do-temperatures = Die Temperaturen von Prüfkörper und Arm noch einmal messen. Die vom Anfang sind eingetragen: Ändern, was sich geändert hat, dann bestätigen.
performance-drop-scan = Scan verwerfen
performance-dropped-scan = hat einen Scan des Prüfkörpers verworfen
performance-dropping-scan = Der Scan wird verworfen
performance-editions = Normen
performance-end-scan = Scan beenden
performance-ended = Beendet
performance-evaluating = Die Kenngrößen werden berechnet
performance-finish-scan-first = Zuerst den laufenden Scan beenden oder verwerfen.
performance-finished-scan = hat einen Scan des Prüfkörpers beendet
performance-nothing-decided-standard-rocks = Mit Längen eines wackelnden Normals lässt sich nichts entscheiden. Das Normal befestigen und die Prüfung wiederholen.
performance-gate-points = Punkte eines Scans nehmen teil, wenn sie höchstens { $shell } von der Oberfläche der kalibrierten Kugel und höchstens { $cone } von ihrem Pol ({ $pole }) entfernt liegen und der Sensor diese Oberfläche unter höchstens { $incidence } zu ihrer Normalen sieht. Alle diese Punkte zählen; keiner wird wegen seines Residuums entfernt.
performance-go-on = Weiter
performance-hold-sensor =
    { $number ->
        [1] Den Sensor über die Kugel halten, Blick senkrecht nach unten. Den Scan beginnen und die Laserlinie über die Kugel führen.
        [2] Den Sensor auf der vom Arm abgewandten Seite halten, etwa 45° geneigt. Den Scan beginnen und die Laserlinie über die Kugel führen.
        [3] Den Sensor vom Arm aus gesehen rechts halten, etwa 45° geneigt. Den Scan beginnen und die Laserlinie über die Kugel führen.
        [4] Den Sensor auf der Seite des Arms halten, etwa 45° geneigt. Den Scan beginnen und die Laserlinie über die Kugel führen.
       *[other] Den Sensor vom Arm aus gesehen links halten, etwa 45° geneigt. Den Scan beginnen und die Laserlinie über die Kugel führen.
    }
performance-is-closed = Diese Prüfung ist abgeschlossen. Eine neue beginnen.
performance-is-evaluated = Die Kenngrößen werden noch berechnet.
performance-last-error = Abweichung der letzten Länge, { $length }
performance-leave-question = Diese Prüfung abbrechen? Sie bleibt erhalten und wird mit dem Grund aufgeführt.
performance-judged-by-test-uncertainty = U ist die Prüfwertunsicherheit: die von Normal und Aufbau, nicht die Streuung von Arm und Sensor. Diese misst die Prüfung.
performance-length-is-confirmed = Die letzte Länge ist mit der ersten Antastung der nächsten oder mit dem ersten Scan bestätigt; ihre Antastungen stehen fest.
performance-lengths-and-scans = { $done } von { $of } Längen angetastet, { $scanned } von { $scans } Scans
performance-lengths-done = Alle Längen sind gemessen. Weiter zum Ergebnis.
performance-lengths-measured = { $done } von { $of } Längen
performance-let-temperatures-settle =
    { $when ->
        [end] So wird kein Wert entschieden. Die Prüfung wiederholen, sobald die Temperaturen beständig sind.
       *[begin] So wird kein Wert entschieden. Warten, bis sich Prüfkörper und Arm angeglichen haben, dann noch einmal messen.
    }
performance-measuring-bar-scan = Der Scan des Stabs wird ausgewertet: { $scan }
performance-measuring-plate-scan = Der Scan der Platte in Ausrichtung { $number } wird ausgewertet
performance-measuring-scan = Der Scan der Stellung { $articulation } wird ausgewertet
performance-move-seat = Die Pfanne zuerst an ihrer nächsten Stelle festklemmen
performance-move-sphere = Die Kugel an ihre zweite Position in einem anderen Teil des Arbeitsraums setzen und befestigen. Dann oben antasten.
performance-no-artefact =
    { $test ->
        [lengths] Im Ordner gauges ist noch kein Längennormal.
        [plane] Im Ordner gauges ist noch keine Platte.
        [contact] Im Ordner gauges ist noch weder eine Kugel noch ein Kugelstab.
       *[other] Im Ordner gauges ist noch keine Kugel.
    }
performance-no-free-place = Diese Antastung liegt nicht nahe einer noch freien Stelle und wurde nicht übernommen
performance-no-limit-entered = Es ist kein Grenzwert eingetragen: Die Werte werden angegeben und nicht beurteilt.
performance-no-scan-runs = Es läuft kein Scan.
performance-no-way-back = Das Gemessene gilt: Nach der ersten Antastung oder dem ersten Scan geht die Prüfung nicht zurück.
performance-nothing-to-test = Es gibt nichts zu prüfen
performance-off-direction = Das Normal liegt { $angle } neben der gezeichneten Richtung.
performance-only-lengths-have-choice = Nur bei der Längenprüfung kann gewählt werden, ob auch gescannt wird.
performance-orientation =
    { $number ->
        [1] Laserlinie unter 45°
       *[other] Laserlinie um 90° gedreht
    }
performance-orientation-missing = Die Platte ist noch nicht in beiden Ausrichtungen gescannt.
performance-other-calibration = Seit Beginn der Prüfung wurde die verwendete Kalibrierung gewechselt.
performance-pass-over-plate = Die Laserlinie langsam in Streifen nebeneinander, die sich überlappen, über die Platte führen, dann den Scan beenden.
performance-pass-over-spheres = Die Laserlinie langsam über jede Kugel des Stabs führen, von Seiten quer zum Stab, dann den Scan beenden.
performance-pass-slowly = Die Laserlinie langsam über die ganze Kugel führen, dann den Scan beenden.
performance-patches =
    { $count ->
        [one] { $count } Stelle eines Scans ist der mittlere Abstand
       *[other] { $count } Stellen eines Scans sind die mittleren Abstände
    } aller Punkte innerhalb von { $half } um die Richtungen des Musters.
performance-place =
    { $number ->
        [1] waagerecht, vom Arm weg
        [2] waagerecht, quer, nah links
        [3] waagerecht, quer, fern rechts
        [4] senkrecht
        [5] 45° geneigt, quer, links
        [6] 45° geneigt, vom Arm weg, rechts
       *[other] Raumdiagonale
    }
performance-place-bar = Den Stab wie in Lage { $number } gezeichnet aufstellen ({ $words }) und festklemmen.
performance-place-title = Lage { $number } von 7
performance-placement =
    { $lies ->
        [away] waagerecht, vom Arm weg
        [across] waagerecht, quer
        [up] senkrecht
        [rising-away] vom Arm weg ansteigend
        [rising-left] nach links ansteigend
        [rising-away-left] vom Arm weg nach links ansteigend
       *[rising-away-right] vom Arm weg nach rechts ansteigend
    }, { $at ->
        [near] nah
        [far] fern
       *[middle] in mittlerer Entfernung
    }, { $side ->
        [left] { $bearing }° links
        [right] { $bearing }° rechts
       *[ahead] geradeaus
    }
performance-plan-changed = Der Plan dieser Prüfung wurde geändert, nachdem die Messung begonnen hatte.
performance-plan-is-frozen = Prüfkörper und Grenzwerte stehen seit Beginn der Messung fest.
performance-plate-form = Form { $form }
performance-plate-run = Platte, Ausrichtung { $number }
performance-plate-scan-done = Die Platte ist in Ausrichtung { $number } gescannt.
performance-plate-scan-name = Leistungsprüfung, Platte, Ausrichtung { $number }
performance-plate-scanned = Die Platte ist in beiden Ausrichtungen gescannt.
performance-plate-scans-done = { $done } von { $of } Ausrichtungen
performance-plate-width = { $width } breit
performance-put-back = Antastung zurückholen
performance-repeat = Prüfung wiederholen
performance-repeat-question = Die Prüfung wiederholen? Dieser Durchgang bleibt erhalten und wird als wiederholt aufgeführt.
performance-repeat-scan = Scan { $number } nochmals
performance-run = Position { $position }, Scan der Stellung { $articulation }
performance-run-dropped = Während des Scannens verworfen.
performance-run-repeated = Vom Bediener wiederholt.
performance-seat-not-another = Die Tastkugel ist nur { $away } von einer früheren Pfanne entfernt; diese Antastung wurde nicht übernommen
performance-scan-again = Diese Stellung nochmals scannen, langsam über die ganze Kugel
performance-scan-bar = Das Normal so liegen lassen und den ganzen Stab scannen, { $repeat } von { $of }: alle seine Kugeln, von Seiten quer zum Stab.
performance-scan-bar-again = Den Stab noch einmal scannen, langsam über jede Kugel
performance-scan-bar-first = Zuerst den Stab in dieser Lage scannen.
performance-scan-done = Stellung { $articulation } ist gescannt.
performance-scan-is-measured = Der letzte Scan wird noch ausgewertet.
performance-scan-length-alone = Zwei Paare von Kugeln haben den Abstand { $length }. Das Normal so liegen lassen und nur die beiden Kugeln dieser Länge scannen.
performance-scan-missing = Die Stellung, auf deren Seite sie liegen, nochmals scannen.
performance-scan-name = Leistungsprüfung, Stellung { $articulation }
performance-scan-plate =
    { $number ->
        [1] Den Sensor so drehen, dass die Laserlinie etwa 45° zu den Kanten der Platte oder zu den Achsen des Arms liegt. Den Scan beginnen. Von da an stehen Platte und Grenzwert fest.
       *[other] Den Sensor um seine Blickrichtung drehen, bis die Laserlinie quer zu ihrer Richtung im ersten Scan liegt. Den Scan beginnen.
    }
performance-scan-plate-again = Diese Ausrichtung noch einmal scannen
performance-scan-shows = { $patches } von 25 Feldern, { $points } Punkte
performance-scan-too-small = Der Scan deckt nur { $count } der 25 Felder der Kugel ab
performance-scanned-length = { $length } (Abweichung { $error })
performance-scans-done = { $done } von { $of } Stellungen
performance-put-arm-json = Die arm.json des Messarms mit Seriennummer und Tastkugel in den Ordner arms legen
performance-seat-has-no-certificate = Die Pfannen haben kein kalibriertes Maß, daher ist die Prüfwertunsicherheit der Einzelpunkt-Schwenkprüfung 0: Spiel und Bewegung einer Pfanne zählen wie Abweichungen des Arms.
performance-seat-largest = größter Abstand { $largest }
performance-seat-not-far = Die ferne Pfanne steht bei { $share } % der Reichweite; die Norm verlangt mindestens { $least } %.
performance-seat-not-near = Die nahe Pfanne steht bei { $share } % der Reichweite; die Norm verlangt höchstens { $most } %.
performance-seat-share = bei { $share } % der Reichweite
performance-set-by-scan = hat Antasten oder Scannen gewählt
performance-set-is-invalid = Das Gemessene gehört zum alten Stand und ist als Prüfung ungültig. Neu beginnen; die Daten bleiben erhalten.
performance-set-positions = hat die Zahl der Positionen gewählt
performance-set-standard-up = Das Normal wie gezeichnet aufstellen: { $place }. Befestigen. { $text }
performance-settings-changed = Die Einstellungen für Scans wurden geändert, nachdem die Messung begonnen hatte.
performance-single-values =
    { $test ->
        [plane] Die Ausrichtungen
       *[contact] Meisterkugel, Pfannen und Lagen
    }
performance-simulation-contacts = Der simulierte Bediener tastet an: { $done } von { $of }
performance-simulation-scans = Der simulierte Bediener scannt Stellung { $articulation }
performance-simulation-scans-bar = Der simulierte Bediener scannt den Stab in Lage { $place }, Scan { $repeat }
performance-simulation-scans-plate = Der simulierte Bediener scannt die Platte in Ausrichtung { $number }
performance-simulation-touches =
    { $test ->
        [lengths] Der simulierte Bediener tastet das Längennormal an: { $done } von { $of }
       *[other] Der simulierte Bediener tastet die Kugel an: { $done } von { $of }
    }
performance-sphere-touch-not-taken = Die Kugel wurde dort schon angetastet; diese Antastung wurde nicht übernommen
performance-standard-lengths =
    { $kind ->
        [step-gauge] Stufenendmaß
       *[other] Stab
    }, { $count ->
        [one] eine Länge, { $longest }
       *[other] { $count } Längen, { $shortest } bis { $longest }
    }
performance-step-artefact = Prüfkörper und Grenzwerte
performance-step-bar = Kugelstab
performance-step-diameter = Meisterkugel
performance-step-end = Nochmals antasten
performance-step-lengths = Längen
performance-step-location = Lage durch Antasten
performance-step-pattern = 25 Antastungen
performance-step-plate = Zwei Scans
performance-step-scan = Fünf Scans
performance-step-seats = Drei Pfannen
performance-step-temperatures = Temperaturen
performance-stylus-off-articulation = Der Taster ist { $off } neben der gewünschten Richtung (höchstens { $most }).
performance-symbol = Symbol
performance-temperature-not-stated = Die Temperatur des Prüfkörpers wurde nicht angegeben: Größen und Längen gelten als bei 20 °C gemessen, und ihre Unsicherheit enthält die Temperatur nicht.
performance-test =
    { $kind ->
        [lengths] Leistungsprüfung: Längen
        [plane] Leistungsprüfung: Ebene
        [contact] Leistungsprüfung: Antastprüfungen
       *[sphere] Leistungsprüfung: eine Kugel
    }
performance-test-under-way-go-where-stands = Eine Leistungsprüfung läuft. Beim aktuellen Schritt fortfahren.
performance-touch-bar = Die { $end ->
        [1] erste
       *[other] zweite
    } Kugel des Stabs an { $touches } Stellen rundum antasten.
performance-touch-bar-first = Zuerst alle Längen dieser Lage antasten.
performance-touch-ends-of-length = Das andere Ende der genannten Länge antasten
performance-touch-length =
    Länge { $length }, Wiederholung { $repeat } von { $of }: { $kind ->
        [face] { $end ->
            [1] die erste Fläche
           *[other] die zweite Fläche
        } antasten. Beide in gleicher Richtung und auf gleicher Höhe und Seite antasten.
       *[sphere] { $end ->
            [1] die erste Kugel
           *[other] die zweite Kugel
        } an { $touches } Stellen ringsum antasten.
    }
performance-touch-location =
    { $number ->
        [1] Das Handgelenk über der Kugel halten, der Taster zeigt senkrecht nach unten. Oben und an vier Stellen ringsum antasten, ohne den Taster zu drehen.
        [2] Den Taster etwa 45° neigen, das Handgelenk auf der vom Arm abgewandten Seite. Die fünf markierten Stellen antasten, ohne den Taster zu drehen.
        [3] Den Taster etwa 45° neigen, das Handgelenk vom Arm aus gesehen rechts. Die fünf markierten Stellen antasten, ohne den Taster zu drehen.
        [4] Den Taster etwa 45° neigen, das Handgelenk auf der Seite des Arms. Die fünf markierten Stellen antasten, ohne den Taster zu drehen.
       *[other] Den Taster etwa 45° neigen, das Handgelenk vom Arm aus gesehen links. Die fünf markierten Stellen antasten, ohne den Taster zu drehen.
    }
performance-touch-master = Die Kugel ganz oben und an acht Stellen rundum antasten: Messung { $number } von { $of }.
performance-touch-off-seat = Die Tastkugel ist { $off } von den Antastungen davor entfernt: Sie sitzt nicht in der Pfanne. Diese Antastung wurde nicht übernommen
performance-touch-off-sphere = Diese Antastung liegt { $off } neben der Kugel, die vorher angetastet wurde; sie wurde nicht übernommen
performance-touch-pattern = Die markierten Stellen in beliebiger Reihenfolge antasten, das Handgelenk dabei frei drehen. Die nächste freie ist hervorgehoben.
performance-touch-place = Stelle { $number } der Zeichnung antasten
performance-touch-same-seat = Die Tastkugel in die Pfanne setzen oder den Punkt davor entfernen, falls er der falsche ist
performance-touch-same-sphere = Dieselbe Kugel antasten, oder ihre Antastungen zurücknehmen und neu beginnen
performance-touch-seat = Die Tastkugel in die Pfanne setzen und { $count } Antastpunkte aufnehmen. Dazwischen den Ellbogen bewegen und das Handgelenk drehen, zu beiden Seiten.
performance-touch-sphere-elsewhere = Die Antastungen über die Kugel verteilen
performance-touch-taken =
    { $test ->
        [lengths] Antastung { $count } der Längen
        [contact] Antastung { $count } dieses Schritts
       *[other] Antastung { $count } an der Kugel
    }
performance-touch-top-first = Die Kugel zuerst ganz oben antasten; daraus folgen die anderen Stellen. Von da an stehen Kugel und Grenzwerte fest.
performance-touches-missing =
    { $missing ->
        [one] Eine Antastung fehlt.
       *[other] { $missing } Antastungen fehlen.
    }
performance-turn-sensor = Den Sensor um seine Blickrichtung drehen und diese Ausrichtung noch einmal scannen
performance-turn-standard = Die sieben Lagen decken den Raum des Arms nur ab, wenn das Normal etwa wie gezeichnet liegt.
performance-turn-towards-articulation = Das Handgelenk drehen, bis diese Meldung verschwindet; anders genommene Punkte werden im Ergebnis vermerkt
performance-valid-until = Kalibrierschein gültig bis { $until }
performance-values-against-limits = Werte als Anteile ihrer größten zulässigen Abweichungen, mit der Prüfwertunsicherheit (k = 2) als Balken. Der gefüllte Punkt ist der Wert, der zählt; offene Punkte sind die einzelnen Werte, aus denen er folgt.
pictures-were-taken-with-other-sensor = Es wurden Bilder mit einem anderen Sensor aufgenommen. Für diesen eine neue Kalibrierung beginnen.
places-of-hemisphere =
    { $title }, vom Pol gesehen: { $count ->
        [one] { $count } Stelle
       *[other] { $count } Stellen
    } mit dem Abstand von der Ausgleichskugel in µm, blau innen, orange außen, höchstens { $largest }. Die Kreise liegen 22,5°, 45°, 67,5° und 90° vom Pol.
plate = Ebenes Normal
plate-by-certificate = eben auf { $flatness }
plate-orientations-alike = der Sensor wurde zwischen den beiden Ausrichtungen nur um { $turn } gedreht; nötig sind { $least }
plate-scan-too-few-points = der Scan hat nur { $count } Punkte; nötig sind { $least }
plate-too-narrow = die Platte ist { $width } breit; nötig sind { $least }
point-judged-with-guard =
    Für ein Merkmal, das durch einen einzelnen gescannten Punkt gegeben ist, beträgt der Schutzabstand { $guard } ({ $guard_mm }): { $bearer ->
        [supplier] Es ist nur konform, wenn der Punkt um mehr als diesen innerhalb der Toleranz liegt.
        [user] Es ist nur nicht konform, wenn der Punkt um mehr als diesen außerhalb der Toleranz liegt.
       *[prover] Die Konformität ist nachgewiesen, wenn der Punkt um mehr als diesen innerhalb der Toleranz liegt, die Nichtkonformität, wenn er um mehr außerhalb liegt.
    }
point-judged-without-guard = Ein Merkmal, das durch einen einzelnen gescannten Punkt gegeben ist, ist konform, wenn der Punkt innerhalb der Toleranz liegt.
points-in-gate = Punkte
points-outside-gate = Punkte außerhalb
pose-repeats = der Messarm meldet immer wieder dieselbe Pose
poses-equal-to-last-digit = seine Posen zeigten immer Rauschen und sind jetzt bis auf die letzte Stelle gleich: er sendet eine alte Pose
qif-not-validated = diese Datei folgt dem Schema von QIF 3.0, wurde aber selbst nicht dagegen geprüft
quaternion-must-be-unit = die letzten vier Zahlen müssen ein Einheitsquaternion sein, w zuerst
range-all-m = Spannweite aller, µm
range-all-points-in-gate = Spannweite aller Punkte
raw-bayer-has-one-channel = ein Bayer-Rohbild (bayer) hat nur einen Kanal
recording-has-no-sensor-named = { $path } enthält keinen Sensor namens { $name }
recording-has-one-sensor = { $path } ist eine Aufzeichnung eines einzigen Sensors
recording-has-sensors = { $path } ist eine Aufzeichnung mehrerer Sensoren ({ $names })
restart-robot-controller = Die Steuerung des Arms neu starten.
restore-tool-and-coordinate-system = Wählen Sie am Messarm wieder das frühere Werkzeug und Koordinatensystem, oder kalibrieren Sie mit den neuen.
robot-cannot-be-reached = Der Roboter unter { $where } ist nicht erreichbar: { $reason }
robot-clock-jumped = Die Uhr des Arms unter { $address } ist gesprungen: Die Steuerung wurde neu gestartet oder ihre Zeit gestellt
robot-closed-connection = Der Roboter unter { $address } hat die Verbindung geschlossen
robot-does-not-answer = Keine Antwort von { $where }
robot-frames-changed = Die Pose des Roboters unter { $address } ist um { $step } und { $turn } gesprungen, ohne dass sich ein Gelenk bewegt hat: Ein anderes Werkzeug oder eine andere Basis ist aktiv
robot-host-not-known = Es gibt keinen Rechner mit dem Namen { $address }
robot-link-closed = Die Verbindung zum Roboter unter { $address } ist geschlossen
robot-link-lost = Die Verbindung zum Roboter unter { $address } ist abgebrochen: { $reason }
robot-quaternion-not-unit = Der Arm unter { $address } sendet eine Orientierung, die keine Drehung ist: Ihr Quaternion hat die Länge { $length }
reports-poses-no-tip = meldet Posen, keine Tastkugel
robot-no-program-listens = Unter { $where } nimmt kein Programm Verbindungen an
robot-said = { $text }. Der Roboter meldet: { $said }
robot-select-former-frames = An der Steuerung das frühere Werkzeug und die frühere Basis wählen. Die Verbindung öffnet sich von selbst wieder.
robot-sends-no-numbers = Der Arm unter { $address } sendet Werte, die keine Zahlen oder unmöglich groß sind
robot-sends-nothing = Der Arm unter { $address } hat seit { $time } nichts Neues gesendet
robot-sends-only-useless = Der Arm unter { $address } hat seit { $time } nur Pakete gesendet, die nicht lesbar sind oder das letzte wiederholen ({ $count })
robot-sends-not-from-address = Was am UDP-Port { $port } ankommt, kommt von { $sender }, nicht vom Roboter unter { $address }
robot-sends-nothing-to-port = Der Roboter unter { $address } sendet nichts an den UDP-Port { $port } dieses Rechners
ros2-nothing-of-chain-moves = Zwischen { $base } und { $tool } bewegt sich nichts: { $topic } enthält keine Transformation dieser Kette
ros2-check-publisher = Prüfen, ob der veröffentlichende Knoten läuft und beide dieselbe ROS_DOMAIN_ID und Middleware (RMW_IMPLEMENTATION) haben.
ros2-check-transform-node = Den Knoten prüfen, der diese Transformation veröffentlicht.
ros2-failed = ROS 2 lehnt das Abonnement von { $topic } ab: { $reason }
ros2-frame-changed = Die Posen von { $topic } sind jetzt im Koordinatensystem { $frame } statt { $expected }
ros2-frames-are = parent_frame und child_frame berichtigen; die Koordinatensysteme sind { $names }.
ros2-joints-are = joint_names berichtigen; die Gelenke sind { $names }.
ros2-lacks-joint = Die Nachrichten von { $topic } enthalten kein Gelenk { $name }
ros2-needs-joint-names = Fünf bis sieben Gelenke nennen, das der Basis zuerst.
ros2-no-chain = Keine Transformationen von { $topic } führen von { $base } zu { $tool }
ros2-no-stamp = Die Nachrichten von { $topic } haben keine Zeitstempel
ros2-not-found = ROS 2 ist hier nicht installiert, oder seine Umgebung ist nicht eingerichtet: { $reason }
ros2-nothing-published = Auf { $topic } wird nichts als { $kind } veröffentlicht
ros2-parent-changed = Das Koordinatensystem { $frame } von { $topic } liegt jetzt in { $parent } statt in { $expected }
ros2-same-frames = parent_frame und child_frame sind beide { $frame }
ros2-source-setup = In der Shell, die das Programm startet, die Setup-Datei von ROS 2 einlesen (source /opt/ros/…/setup.bash) und das Python von ROS 2 verwenden.
ros2-topics-are = topic berichtigen; Topics dieser Art sind { $names }.
ros2-transform-stale = Die Transformation von { $parent } zu { $child } von { $topic } liegt { $behind } hinter den anderen zurück
ros2-use-arrival = Der Absender muss header.stamp setzen; sonst stamps = "arrival" ergänzen, was in Bewegung ungenauer ist.
same-camera-both = beide kommen von einer Kamera in einer Betriebsart
scanned-centres-of-position = Durch Scannen, Position { $position }
scanned-places-of-position = Gescannte Kugel, Position { $position }
search-again-for-devices = Suchen Sie noch einmal; wenn das nicht hilft, prüfen Sie Netzwerk und Kabel.
selected-sensor = Sensor ausgewählt
sensor-calibrated = { $name }: { $calibration }, { $total } (k = 1)
sensor-cannot-be-selected-now = ein anderer Sensor lässt sich jetzt nicht auswählen
sensor-left-out =
    { $count ->
        [one] ein Bild
       *[other] { $count } Bilder
    } des Sensors { $name } ausgelassen: für ihn wurde keine Kalibrierung angegeben
sensor-sends-lines-no-pictures = der Sensor sendet Laserlinien und keine Bilder
sensor-without-calibration = { $name }: noch nicht kalibriert
sensors-line-lists-differ = die Punkte der Linie des Sensors sind unvollständig
set-sensor-send-pictures = den Sensor auf Bilder umstellen oder einen anderen Sensor verwenden
set-stripe-axis = stripe_axis im Datenblatt des Sensors auf { $axis } setzen und neu kalibrieren.
shows-arm-joints = Form der angetasteten Kugel; Einzelpunkt-Schwenkprüfung
shows-arm-links = Längenabweichungen; Lage über die Stellungen, durch Antasten wie durch Scannen; Größe, wo sich der Taststift nach außen neigt
shows-clock = Form und Streuung der gescannten Kugel; sie wachsen mit der Scangeschwindigkeit
shows-laser-plane = Form der gescannten Kugel und Ebene; Größe der gescannten Kugel
shows-probe-matrix = Lage der gescannten Kugel: bis 2 d längs einer Achse, die die Stellungen neigen, weniger längs einer, die ihre Richtung behält; ihre Größe, und ihr Abstand von der angetasteten Kugel
shows-sensor-scale = Größe der gescannten Kugel, zu einem Teil
shows-stripe-noise = Streuung von 95 % aller Punkte
shows-tip-diameter = Größe der angetasteten Kugel; wirksamer Durchmesser
sign-in-ask-for-group = Bitten Sie einen Administrator des Anbieters um eine Gruppe mit Zugang
sign-in-begin-again = Beginnen Sie die Anmeldung noch einmal
sign-in-cancelled = Die Anmeldung mit { $name } wurde abgebrochen oder abgelehnt
sign-in-certificate-not-trusted = Das Zertifikat von { $name } ist nicht gültig, oder ihm wird hier nicht vertraut
sign-in-check-clocks = Bitten Sie einen Administrator, die Uhren dieses Servers und des Anbieters zu stellen
sign-in-check-issuer = Bitten Sie einen Administrator, issuer in [sign_in] der Einstellungen zu prüfen
sign-in-code-refused = { $name } nimmt diese Anmeldung nicht mehr an
sign-in-correct-secret = Bitten Sie einen Administrator, das Client-Secret zu berichtigen; melden Sie sich bis dahin ohne den Anbieter an
sign-in-give-ca-file = Melden Sie sich ohne den Anbieter an, und bitten Sie einen Administrator, die Zertifizierungsstelle des Anbieters als ca_file in [sign_in] anzugeben
sign-in-health = Anmeldung mit Konten des Werks
sign-in-health-remedy = Konten dieser Station können sich anmelden. Prüfen Sie das Netz, den Anbieter und [sign_in] der station.toml
sign-in-health-why = Ohne den Anbieter können sich nur Konten dieser Station anmelden; wer angemeldet ist, bleibt es.
sign-in-map-claim = Bitten Sie einen Administrator, name_claim in [sign_in] zu berichtigen oder den Anbieter die Angabe senden zu lassen
sign-in-name-secret-file = Geben Sie als client_secret_file in [sign_in] eine Datei an, die nur das Client-Secret enthält
sign-in-no-group = { $person } ist in keiner Gruppe von { $name }, die sich hier anmelden darf
sign-in-no-name = { $name } sagt nicht, wer sich angemeldet hat: Die Angabe { $claim } fehlt
sign-in-no-provider = Hier gibt es keinen Anbieter von Konten
sign-in-not-pending = Diese Anmeldung wurde nicht in diesem Browser begonnen, ist zu alt oder wurde schon benutzt
sign-in-not-registered = { $name } nimmt die Client-ID oder die Redirect-URI dieses Servers nicht an
sign-in-other-issuer = { $name } nennt einen anderen Issuer als die Einstellungen hier
sign-in-provider-answers = { $name } antwortet.
sign-in-provider-away = { $name } ist nicht erreichbar
sign-in-provider-unusable = { $name } antwortet nicht wie ein Anbieter von OpenID Connect
sign-in-refused = { $name } hat die Anmeldung abgelehnt ({ $error })
sign-in-register = Bitten Sie einen Administrator, { $address } als Redirect-URI des Clients { $client } einzutragen
sign-in-not-signed-by-provider = Die Antwort auf die Anmeldung ist nicht von { $name } signiert
sign-in-tell-administrator = Sagen Sie es einem Administrator, und melden Sie sich ohne den Anbieter an
sign-in-token-expired = Die Antwort von { $name } ist abgelaufen oder in der Zukunft datiert
sign-in-token-foreign = Die Antwort von { $name } gehört zu einer anderen Anmeldung oder einem anderen Client
sign-in-too-many = Im Augenblick melden sich zu viele mit { $name } an
sign-in-use-local-account = Melden Sie sich ohne den Anbieter an, oder versuchen Sie es später noch einmal
sign-in-wrong-secret = { $name } nimmt das Client-Secret dieses Servers nicht an
signed-in-with = mit { $name } angemeldet
silent-but-there = { $title }: verbunden, wartet auf einen Trigger oder eine Änderung
simulated-sensor-cannot-deliver = Der simulierte Sensor kann das nicht liefern
simulation-goes = Der simulierte Bediener führt den Messarm zu: { $name }
simulation-goes-next-pose = Der simulierte Bediener führt den Sensor zur nächsten Pose: { $words }
simulation-holds-sensor-over-object = Der simulierte Bediener hält den Sensor über das Objekt
simulation-holds-still = Der simulierte Bediener hält den Messarm ruhig
simulation-not-moving = Der simulierte Bediener bewegt sich nicht.
simulation-scanning = Der simulierte Bediener scannt
simulation-scans = Der simulierte Bediener scannt: { $part }
simulation-scans-cloud = Der simulierte Bediener scannt: { $name }, Punktwolke { $done }
simulation-swings-arm-about = Der simulierte Bediener schwenkt den Messarm um: { $name }
simulation-touches = Der simulierte Bediener tastet an: { $face }
simulation-touches-gauge = Der simulierte Bediener tastet an: { $name }
simulation-touches-sphere = Der simulierte Bediener tastet die Kugel an
simulation-work = Der simulierte Bediener arbeitet
hands-point-face-declined-times = Punkt { $index } des simulierten Bedieners { $where } wurde { $attempts }-mal abgelehnt
hands-touch-declined-times = Antastpunkt { $index } des simulierten Bedieners wurde { $attempts }-mal abgelehnt
has-control = { $name } hat die Bedienung
has-control-in-another-browser = { $name } hat die Bedienung in einem anderen Browser
has-control-now = { $name } hat jetzt die Bedienung.
has-coordinate = { $path } enthält eine Koordinate von { $coordinate }
joint-columns-or-none =
    { $count ->
        [0] { $path } hat keine Gelenkspalten
        [one] { $path } hat { $count } Gelenkspalte ({ $names })
       *[other] { $path } hat { $count } Gelenkspalten ({ $names })
    }
has-mm =
    { $kind ->
        [bar] Für einen Kugelstab sind { $low } bis { $high } zulässig.
       *[sphere] Für eine Kugel sind { $low } bis { $high } zulässig.
    }
has-points = { $label } hat { $count } Punkte
has-touches =
    { $shape ->
        [sphere] Die Kugel hat { $count } Antastpunkte
       *[plane] Die Ebene hat { $count } Antastpunkte
    }
have-arms-calibration-checked-hold-compact = Kalibrierung des Messarms prüfen lassen; den Messarm in kompakter Haltung führen.
height-above-touched-plane-along-z = Höhe über der angetasteten Ebene, entlang Z
height-of-level =
    { $level ->
        [base] die Höhe seiner Grundfläche
        [floors] die Höhe seiner Nutgründe
       *[crests] die Höhe seiner Zinnenoberseiten
    }
held-out-places-fit-did-see = Kreuzvalidierung an { $places } Positionen, die nicht in die Ausgleichung eingingen, { $how }; das Rauschen der Winkelgeber ist enthalten. In Standardabweichungen der Punkte { $before } vorher und { $after } nachher; 1 entspricht dem Rauschen allein.
held-out-turn = reihum ausgelassen
held-up-live-numbers-stand-press = Bei Verzögerungen bleiben Anzeigen stehen und Eingaben werden verspätet beantwortet; die Geräte werden weiter gelesen.
held-up-more-than-longest =
    { $count ->
        [one] einmal um mehr als { $limit } verzögert, um { $longest }
       *[other] { $count }-mal um mehr als { $limit } verzögert, höchstens um { $longest }
    }
high-up = weit oben
higher-by = { $distance } höher
hold = Halten
keep-this-pose = so halten
hold-arm-still = Messarm ruhig halten. { $text }.
hold-the-arm-still = Messarm ruhig halten.
hold-sensor-over-object = Sensor über das Objekt halten
hold-sensor-over-object-another-way = Sensor anders als bisher über das Objekt halten.
hold-sensor-over-object-so-lies = Sensor so über das Objekt halten, dass es etwa mit dem gestrichelten Umriss übereinstimmt.
hold-sensor-straight-above-chessboard-longer = Sensor senkrecht über das Schachbrett halten, dessen längere Seite parallel zur Längsseite des Bildes.
hold-still = Ruhig halten
hold-still-again = noch einmal ruhig halten
hold-still-take-picture-laser-switches = Ruhig halten und das Bild aufnehmen. Der Laser schaltet automatisch.
hold-there = So halten
holds-journal-every-step-accounts-what = Die Datenbank enthält das Journal aller Schritte, die Konten und die Angabe der verwendeten Kalibrierung.
holds-more-than-frames = { $path } enthält mehr als { $most } Bilder
holds-no-record-one = er enthält keinen solchen Eintrag
holds-no-topics = { $path } enthält keine Topics
holds-topics = { $path } enthält { $topics }
host-not-known = Der Rechner in { $url } ist nicht bekannt
how-arm-swung = Verlauf des Schwenks
how-sensor-sits-flange-shows-only = die Lage des Sensors am Flansch zeigt sich nur, wenn sich der Flansch dreht: mindestens drei Posen, um zwei verschiedene Achsen gedreht
http-status = Status { $status }
identification-arm = Identifikation des Messarms
identified = Identifiziert
identified-arm-use = Der identifizierte Messarm wird verwendet.
identify-arm = Messarm identifizieren
identify-arm-first = Zuerst den Messarm identifizieren.
identify-arm-folders-again = Identifikation mit { $arm } des Ordners erneut ausführen
identify-arm-take-more-know-better = Messarm identifizieren oder weitere Positionen aufnehmen, um ihn genauer zu bestimmen.
identifying-arm = Messarm wird identifiziert
image-encoding = { $name }: Kodierung { $encoding }
image-ends-after-bytes =
    { $name } endet nach { $bytes ->
        [one] { $bytes } Byte
       *[other] { $bytes } Bytes
    }
image-has-depth = { $name } enthält { $depth }
image-has-pages = { $name } hat mehr als eine Seite
image-has-pixels = { $name } hat { $width } × { $height } Pixel
image-in-colour = { $name } ist ein Farbbild
image-processing = Bildverarbeitung
image-shape-type = ein Bild der Form { $shape } und des Typs { $dtype }
inner-corners-mm-apart = { $columns } × { $rows } innere Ecken, Abstand { $square }, { $known }
inputs = Eingangsdaten
install-extra = Installieren Sie es mit pip install "crenel[{ $extra }]"
install-gentl-producer = Installieren Sie die Software des Kameraherstellers, und setzen Sie producer auf deren Datei mit der Endung .cti
install-system-package = Installieren Sie das Systempaket { $package } (apt install { $package })
install-version-later-one = Diese oder eine neuere Version installieren
instrument-moved-or-angles-of-other-pose = das Messgerät wurde bewegt, hat die Messmarke verloren, oder die Gelenkwinkel gehören zu anderen Posen
instrument-or-base-moved = das Messgerät oder die Basis des Arms wurde bewegt, oder die Punkte stammen aus zwei Aufstellungen
is-file-complete = Prüfen, ob die Datei vollständig ist.
is-it-a-complete-video = Prüfen, ob es ein vollständiges Video ist.
is-it-there-and-complete = Prüfen, ob die Datei vorhanden und vollständig ist.
is-no-station-database = { $path } lässt sich nicht als Datenbank einer Station lesen
is-of = { $path } gehört zu { $device } { $of }
is-to-be-verified =
    { $shape ->
        [sphere] eine Kugel soll verifiziert werden
       *[plane] eine Ebene soll verifiziert werden
    }
it-is-a-file = es ist eine Datei
it-is-a-folder = es ist ein Ordner
it-is-no-ordinary-file = es ist eine Pipe, ein Socket oder ein Gerät
joint = Gelenk
joint-adjustment-all-poses = gemeinsame Ausgleichung aller Posen
joint-angle-not-a-number = { $name }: Ein Gelenkwinkel ist keine Zahl
joint-angles = { $name }: { $count } Gelenkwinkel
joint-angles-given-degrees = Gelenkwinkel werden in Grad angegeben
joint-at-stamp = { $path } bei { $stamp_ns } ns: Gelenk { $joint } steht auf { $reading }
joint-column-differs = q{ $joint }_deg weicht um { $moved } ab
joint-jumped-stayed-there = Gelenk { $joint } ist um { $step } gesprungen und dort geblieben
joint-name-twice = zwei Gelenke heißen { $name }; Aufzeichnungen unterscheiden Gelenke nach ihrem Namen
joint-range = es dreht von { $low } bis { $high }
joint-range-in-radians = es dreht von { $low } bis { $high }; dies sind Grad, erwartet werden Radiant
joint-reads = Gelenk { $joint } meldet { $reading }
joint-reads-again-again = Gelenk { $joint } meldet immer wieder { $reading }
joint-reads-no-number = Gelenk { $joint } meldet keine Zahl
joint-reads-off-readings-before-after = Gelenk { $joint } meldet { $reading }, { $step } neben den Messwerten davor und danach
joint-reads-same-all-points = Gelenk { $joint } meldet in allen Punkten denselben Wert
joint-reads-where-can = Gelenk { $joint } meldet { $reading }, { $step } außerhalb seines Bereichs
joint-samples-left-out-cannot-true =
    { $count ->
        [one] { $count } unplausibler Messwert des Messarms ausgelassen, { $first } nach Beginn: { CLAUSE($error) }
       *[other] { $count } unplausible Messwerte des Messarms ausgelassen, der erste { $first } nach Beginn: { CLAUSE($error) }
    }
joint-samples-left-out-numbers =
    { $unusable ->
        [one] { $unusable } Messwert des Messarms ausgelassen: keine Zahl
       *[other] { $unusable } Messwerte des Messarms ausgelassen: keine Zahlen
    }
journal-has-rows-cannot-read-first =
    { $count ->
        [one] Das Journal enthält { $count } nicht lesbare Zeile: Zeile { $first }.
       *[other] Das Journal enthält { $count } nicht lesbare Zeilen, die erste ist Zeile { $first }.
    }
json-cut-off = es ist kein JSON oder unvollständig: { $reason }
json-cut-off-line = es ist kein JSON oder unvollständig: { $reason } in Zeile { $line }
json-object-expected = erwartet wird ein JSON-Objekt { "{" } … { "}" }
not-judged = Nicht beurteilt
keep-arm-json-use = Bisherige arm.json weiterverwenden
keep-data-folder-start-earlier-backup = Datenordner unverändert lassen und mit einer früheren Sicherung starten
keep-line-off-outermost-corners = die Laserlinie neben die äußersten Ecken der Tafel legen
keep-reflections-out-grooves-matt-spray = Reflexionen in den Nuten vermeiden: Mattierungsspray, kürzere Belichtung.
keep-tip-seat-swing-elbow-one = Tastkugel in der Pfanne lassen. Den Ellbogen von einer Seite zur anderen und zurück schwenken und das Handgelenk in alle Richtungen neigen.
keeps-control = { $name } behält die Bedienung.
unchanged = Unverändert
kept-picture = Bild behalten
kind-chessboard-not-supported = { $path }: kind „chessboard“ wird hier nicht unterstützt
kind-is-block-or-board = es ist „crenellated“, „chessboard“ oder „charuco“
kind-unknown = { $path }: kind { $kind } ist unbekannt
known-k-1 = Standardunsicherheit { $known } (k = 1)
known-limit-is = { $known }; der Grenzwert ist { $limit }
known-m-k-1-form-m = { $certificate }; Standardunsicherheit { $known } (k = 1), Form { $form }
largest-distance = Größter Abstand
largest-distance-touch-sphere = Größter Abstand eines Antastpunkts von der Kugel
largest-half-range = Größtes (max − min)/2
largest-swing = { $points }, größter Schwenk { $swing }
laser-beside-object-may-too-dark = Der Laser ist an; neben der Linie ist das Objekt für die Erkennung vielleicht zu dunkel.
laser-colour-not-known = die Farbe des Lasers, in deren Kanal gemessen würde, ist nicht angegeben
laser-did-not-switch-on = Der Laser hat sich nicht eingeschaltet: Dieses Bild bestimmt nur Kamera und Lage des Sensors.
laser-line-covers-others = die Laserlinie verdeckt die übrigen
laser-line-left-out-off-plane = ihre Laserlinie wurde ausgeschlossen, { $off } neben der Ebene der übrigen
laser-line-lies-off-plane-others = ihre Laserlinie liegt { $off } neben der Ebene der übrigen
laser-off = der Laser ist aus
the-laser-is-off = Der Laser ist aus
laser-off-covered-beside-object-too = der Laser ist aus, verdeckt, neben dem Objekt oder zu schwach für diese Belichtung
laser-off-too-weak-does-cross = der Laser ist aus, zu schwach oder kreuzt das Objekt nicht
laser-off-too-weak-part-out = der Laser war aus oder zu schwach, oder das Teil lag außerhalb des Messbereichs
laser-on-or-expose-longer = Laser einschalten oder länger belichten
laser-plane = Laserebene
laser-stripe-sensor-measuring-arm = Lichtschnittsensor an einem Messarm
laser-stripe-shows-points-s =
    { $missing ->
        [crest] die Laserlinie zeigt { $count } Punkte auf den Zinnenoberseiten
       *[floor] die Laserlinie zeigt { $count } Punkte auf den Nutgründen
    }
laser-wavelength = Laser { $wavelength }
lasers-line-lies-board-pictures = die Laserlinie liegt in { $enough } von { $views } Bildern auf der Tafel
lasers-line-lies-one-place-plane = die Laserlinie liegt in allen Bildern an derselben Stelle ihrer Ebene
lasers-line-must-cross-chessboard = Die Laserlinie muss in mindestens { $fewest } Bildern über das Schachbrett verlaufen, besser in jedem.
lasers-line-pose-lies-off-plane = Die Laserlinie von Pose { $number } liegt { $off } neben der Ebene der übrigen und wurde ausgeschlossen.
lasers-lines-poses-lie-off-plane = Die Laserlinien der Posen { $poses } liegen { $off } neben der Ebene der übrigen: Der Laser hat sich gegenüber der Kamera bewegt; diese Linien wurden ausgeschlossen.
laser-moved-by-lines-off-plane = Die Laserlinien der Posen { $poses } liegen { $off } neben der Ebene der übrigen: Der Laser hat sich gegenüber der Kamera bewegt; alle Linien gehen ein.
laser-lines-off-their-plane = die Laserlinien der Posen { $poses } liegen { $usual } neben der am besten passenden Ebene
lasers-lines-poses-lie-up-off = die Laserlinien der Posen { $poses } liegen bis zu { $most } neben einer Ebene
lasers-plane-stands-board-limit = der Winkel zwischen Laserebene und Tafel beträgt { $angle } (Grenzwert { $least_laser_angle_deg })
last-cloud-not-evaluated-yet = Die letzte Punktwolke muss noch ausgewertet werden.
last-days-old = Die letzte Sicherung ist { $days } Tage alt, in { $place }.
last-days-old-same-disk = Die letzte Sicherung ist { $days } Tage alt, in { $place }. Sie liegt auf demselben Datenträger wie die Daten.
last-row-must-0-0-0 = die letzte Zeile von { $name } muss 0 0 0 1 lauten
last-verification-older-than-calibration = Die letzte Verifizierung ist älter als diese Kalibrierung.
least-middle-needed = mindestens { $angle } von ihrer Mitte aus sind nötig
least-needed = mindestens { $least } sind nötig
least-needed-each-three-non-parallel = auf jeder von drei nicht parallelen Flächen sind mindestens { $least } nötig
least-needed-tell-arms-errors-own = mindestens { $least } sind nötig, um die Fehler des Messarms vom Mittelpunkt der Position zu trennen
least-needed-to-know-frame = mindestens { $least } sind nötig, damit die Aufstellung des Messgeräts bekannt ist
least-places-taken = { $places_taken } von mindestens { $seats_least } Positionen sind aufgenommen.
least-seats-spheres-bar-positions-needed = mindestens { $least_places } Pfannen, Kugeln und Stablagen sind nötig, damit einige für die Kreuzvalidierung bleiben
leave-bar-where = Den Kugelstab liegen lassen.
leave-session-unused-points-kept = Diese Sitzung abbrechen? Noch nicht verwendete Punkte bleiben gespeichert.
leave-verification-clouds-kept-folder = Diese Verifizierung abbrechen? Ihre Punktwolken bleiben in ihrem Ordner.
left = links
left-end = Linke Stirnseite
left-out = Ausgeschlossen: { $reason }
excluded-because-within-sentence = ausgeschlossen: { $reason }
excluded-for-reason = Ausgeschlossen: { CLAUSE($text) }.
left-right-corners-were-exchanged-image = linke und rechte Ecken sind vertauscht, oder das Bild ist gespiegelt
length = Länge { $longer }
length-another-bar-another-unit-ends = die Länge gehört zu einem anderen Kugelstab oder hat eine andere Einheit, oder die Enden gehören nicht zu diesem Kugelstab
lengths-ball-bars-held-out = Längen der Kugelstäbe, kreuzvalidiert
lengths-of-bars-contradict = die Längen der Kugelstäbe { $bars } widersprechen sich um { $off }; welche davon falsch ist, steht nicht fest
less-than-minute = weniger als eine Minute
less-than-pictures-edges-wide = { $text }, weniger als die Kantenbreite von { $width } im Bild
let-each-station-write-under-own = Jede Station darf nur unter ihrem eigenen Topic schreiben; die vom Broker gespeicherten Nachrichten anderer entfernen.
let-go-control = Bedienung abgegeben
let-simulation-do = Simulierten Bediener starten
let-simulation-do-everything = Simulierten Bediener alles ausführen lassen
let-kept-time-server-which-moves = Von einem Zeitserver führen lassen, der sie gleitend nachstellt.
let-laser-come-rest-take-pictures = Laser zur Ruhe kommen lassen und die Bilder neu aufnehmen.
let-laser-warm-up-check-mount = Laser warmlaufen lassen, seine Befestigung prüfen und die Bilder neu aufnehmen.
let-line-cross-board-in-more-pictures =
    { $more ->
        [one] ein weiteres Bild aufnehmen, in dem die Linie über die Tafel verläuft
       *[other] { $more } weitere Bilder aufnehmen, in denen die Linie über die Tafel verläuft
    }
so-many-values =
    { $count ->
        [one] { $count } Wert
       *[other] { $count } Werte
    }
sphere-by-certificate = Durchmesser { $diameter }, bekannt auf { $known } (k = 1), Form { $form }
sphere-gives-way =
    in Position { $position } gibt die Kugel oder der Taster beim Antasten nach, { $part ->
        [pattern] an den 25 Stellen
        [location] in den Stellungen
       *[end] am Ende
    }: Die Antastungen streuen um { $scatter }, die Punkte der Scans um { $expected }
sphere-moved = Bewegt um
sphere-position = Position
standard-uncertainty-k-1 = u, k = 1
started-pictures-by-themselves = ließ Bilder von selbst aufnehmen
started-simulation = simulierten Bediener gestartet
lies-face = er liegt { $where }
lies-no-face-all = er liegt auf keiner Fläche
lies-where-certificate-puts = { $edge } liegt { $distance } neben der Lage laut Kalibrierschein
light-block-evenly-sharp-large-picture = Zinnenkörper gleichmäßig beleuchten und scharf und groß ins Bild bringen.
light-board-evenly-sharp-large-picture = Tafel gleichmäßig beleuchten und scharf und groß ins Bild bringen.
light-front-above-so-crests-floors = von vorn oben beleuchten, sodass sich Zinnenoberseiten, Nutgründe und Vorderseite unterscheiden, näher herangehen und entfernen, was davor liegt
limit-of-figure = Grenzwert { $limit }
limit = Grenzwert
limit-is = Der Grenzwert ist { $limit }.
limit-is-value = der Grenzwert ist { $limit }
limit-k-1 = Grenzwert, k = 1
limit-with-expanded-uncertainty = Grenzwert { $limit }; U = { $expanded_uncertainty }, k = 2
limit-mark = Grenzwert
limit-number-micrometres-1-100-000 = Ein Grenzwert ist eine Zahl von 1 bis 100 000 Mikrometern.
limits-deg-must-ascend = die Werte in { $limits } von { $name } müssen ansteigen
line-brightness = Linienhelligkeit
line-gives-other-length = Zeile { $line } gibt { $length } für denselben Prüfkörper an: { $label }
line-gives-other-place = Zeile { $line } nennt einen anderen
line-saturated = Linie übersteuert
line-to-arm-closed = Die Verbindung zum Messarm unter { $url } ist geschlossen
line-to-arm-gone = Die Verbindung zum Messarm unter { $url } ist unterbrochen
line-to-arm-lost = Die Verbindung zum Messarm unter { $url } ist unterbrochen ({ $reason })
line-too-bright-saturated = Linie zu hell: { $clipped } übersteuert
line-too-dark = Linie zu dunkel: { $level }
lines-along-other-axis =
    { $pictures ->
        [one] in einem Bild findet --axis { $better } { $other } Punkte und --axis { $axis } { $found }
       *[other] in { $pictures } Bildern findet --axis { $better } { $other } Punkte und --axis { $axis } { $found }
    }: die Linie verläuft in der anderen Richtung. --axis { $better } angeben
lines-run-along-other-axis =
    { $axis ->
        [u] Die Laserlinien verlaufen in den Bildern von oben nach unten, gemessen wird aber ein Punkt je Spalte, sodass das meiste von ihnen verloren geht.
       *[v] Die Laserlinien verlaufen quer durch die Bilder, gemessen wird aber ein Punkt je Zeile, sodass das meiste von ihnen verloren geht.
    }
link-no-longer-valid = Dieser Link ist nicht mehr gültig.
link-leads-itself = es ist ein Link, der auf sich selbst verweist
linux-add-user-group-owns-port = Unter Linux den Benutzer in die Gruppe aufnehmen, der der Anschluss gehört (oft dialout).
lists-stripe-differ-length = die Listen einer Laserlinie sind verschieden lang
load-page-again = Seite neu laden.
log = Protokoll
log-broker-connected = mit dem Broker unter { $host }:{ $port } verbunden
log-broker-lost = die Verbindung zum Broker ist unterbrochen: { $reason }
log-cannot-written-health-page-says = Das Protokoll lässt sich nicht schreiben; Näheres steht auf der Seite „Zustand“.
log-event-loop-goes-on = die Ereignisschleife läuft nach { $duration } weiter
log-event-loop-held-up = die Ereignisschleife ist seit mehr als { $limit } blockiert
log-file-not-used = { $file } wird nicht verwendet: { $reason }
log-has-what-held-up-send = Die Ursache steht im Protokoll; tritt es wieder auf, das Diagnosepaket senden.
log-lines-lost =
    { $count ->
        [one] eine Zeile des Protokolls ging verloren, weil der Datenträger zu langsam war
       *[other] { $count } Zeilen des Protokolls gingen verloren, weil der Datenträger zu langsam war
    }
log-loop-failed = die Schleife { $name } ist gescheitert; sie wird neu gestartet, und dieser Fehler wird erst wieder protokolliert, wenn sie gearbeitet hat
log-loop-goes-on = die Schleife { $name } arbeitet nach { $stood } weiter
log-loop-refused = die Schleife { $name } ist gescheitert und wird neu gestartet: { CLAUSE($reason) }
log-loop-stands = die Schleife { $name } steht seit { $stood } in { $where }
log-loop-works-again = die Schleife { $name } arbeitet wieder
log-not-saved = { $method } { $path } wurde nicht gespeichert: { $reason }
log-notification-not-delivered = eine Benachrichtigung wurde nicht zugestellt: { $reason }
log-program-stood-still = das gesamte Programm stand { $duration } lang still
log-repeated = ({ $count } davon seit { $since })
log-thread-died = { $name } wurde durch einen Fehler beendet
logo-cannot-be-used = das ist kein PNG oder JPEG von höchstens { $largest }
logs-cannot-written = Die Protokolle in { $folder } lassen sich nicht schreiben
look-change = Ansehen und tauschen.
look-last-message-let-simulation-try = Letzte Meldung prüfen und den simulierten Bediener erneut starten
look-log-below-send-support-bundle = Protokoll unten ansehen und das Diagnosepaket an den Support senden.
look-numbers-then-accept-calibration-repeat = Werte ansehen, dann die Kalibrierung annehmen oder wiederholen.
check-current-step = Aktuellen Schritt ansehen und dort handeln
look-them-below-send-support-bundle = Fehler unten ansehen und das Diagnosepaket senden.
looked-arms-delay = Zeitversatz des Messarms bestimmt
looked-pose = Pose { $number } ausgewertet
looking-delay = Zeitversatz wird bestimmt
looking-object-picture = Objekt wird im Bild gesucht
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
lost-reconnecting = Verbindung zum Gerät ({ $title }) unterbrochen; sie wird wiederhergestellt
low-down = weit unten
lower-by = { $distance } tiefer
lower-limit-not-below-upper = Die untere Grenze liegt nicht unter der oberen
made-first-administrator = ersten Administrator angelegt
made-simulated-hardware-demonstration = Mit simulierten Geräten erstellt: Demonstration.
made-token-metrics = Token für Metriken angelegt
length-below-spheres = die Länge { $length } ist kleiner als der Durchmesser der Kugeln, { $diameter }: Eine der beiden Angaben ist falsch
length-beyond-reach = das Längennormal ist { $length } lang, der Arm reicht nur { $reach } weit
lengths-are-missing = nur { $count } von { $wanted } Längen wurden gemessen: jede an { $places } Orten, { $repeats }-mal
lengths-of-no-arm = a_mm und d_mm aller Gelenke sind zusammen { $length }: dies sind Zoll oder Zentimeter, aber Millimeter werden erwartet
lengths-of-smaller-unit =
    { $unit ->
        [m] dies sind Millimeter, wo Meter erwartet werden
       *[mm] dies sind Mikrometer oder eine andere Einheit als Millimeter
    }
lengths-of-unit-expected-mm =
    { $unit ->
        [m] dies sind Meter, aber Millimeter werden erwartet
        [cm] dies sind Zentimeter, aber Millimeter werden erwartet
       *[inch] dies sind Zoll, aber Millimeter werden erwartet
    }
length-standard-rocks =
    { $of ->
        [places] das Normal wackelt in Lage { $place }: Wiederholungen einer Länge streuen um { $scatter }, in ruhigen Lagen um höchstens { $expected }
       *[touches] das Normal wackelt in Lage { $place }: Wiederholungen einer Länge streuen um { $scatter }, Antastungen um { $expected }
    }
made-kiosk-link = Kiosk-Link angelegt
make-backup-another-disk = Sicherung auf einem anderen Datenträger anlegen
make-one-below-crenel-backup = Unten oder mit crenel backup eine anlegen.
make-somebody-else-administrator-first = Zuerst jemand anderen zum Administrator machen
many-points-have-very-same-angles = viele Punkte haben exakt dieselben Winkel
marker-mm-less-than-square-mm = { $marker } muss kleiner als { $square } sein
marker-place-differs = { $place }: Messmarke { $marker } hat einen anderen Ort am Flansch
markers-are-wide = die Markierungen von „{ $name }“ sind im Verhältnis zu den Feldern { $width } breit
markers-lie-far = coordinates.csv: Im Koordinatensystem { $name } liegen die Punkte typisch { $off } von der Stelle, an der sie laut arm.json sind
markers-not-arranged-so = sie sind nicht wie auf „{ $name }“ angeordnet
markers-were-found = { $count } Markierungen aus { $dictionary } gefunden
mask-has-pixels = die Maske gilt für { $width } × { $height } Pixel
mask-pixels-image-another-size = eine Maske von { $shape } Pixeln für ein Bild anderer Größe
mask-says-every-pixel-whether-stripe = eine Maske gibt für jedes Pixel an, ob die Laserlinie dort liegen darf
master-sphere-not-measured = die Meisterkugel wird { $count }-mal mit je { $points } Punkten gemessen
matrix-is-no-rotation = { $name } enthält keine Drehung: R·Rᵀ weicht um { $difference } von 1 ab
max-min-2-along = (max − min)/2 entlang { $axis }
may-not-do-this =
    { $role ->
        [admin] { $name } ist dazu nicht berechtigt: Das darf nur ein Administrator.
       *[operator] { $name } ist dazu nicht berechtigt: Das darf nur ein Bediener.
    }
measure-again-or-delete-rows = Erneut messen oder die Zeilen löschen
measure-more-poses = Mindestens { $least } Posen messen, besser { $wanted }, über die ganze Reichweite verteilt
measure-more-there-or-delete-rows = Dort mehr Punkte messen oder die Zeilen löschen
measure-pattern-over-all-squares-correct = Muster über alle Felder messen und den Kalibrierschein berichtigen.
measure-patterns-width-height-fix-flat = Breite und Höhe des Musters messen und es auf einer ebenen Platte befestigen.
measure-squares-correct-certificate-check-every = Felder messen und den Kalibrierschein berichtigen; oder prüfen, ob zu jedem Bild seine eigene Pose in mm gehört
not-measured = nicht gemessen
measured-points-not-tip = coordinates.csv: Die gemessenen Punkte liegen { $far } neben der Tastkugel
measuring-arm = Messarm
measuring-cloud = Punktwolke wird ausgewertet
measuring-cloud-of-number = Punktwolke { $number } wird ausgewertet
memory = Arbeitsspeicher
merge-takes-some = von { $fewest } bis { $most } Scans lassen sich zusammenführen
merged-in-frame-of-arm-not-moved = Alle Punkte liegen im Koordinatensystem des Messarms. Wurde Messarm oder Teil zwischen den Scans bewegt, passen sie nicht zusammen: Ein Vergleich zweier Scans zeigt, um wie viel.
merged-of = Zusammengeführt aus
merged-scan = { $name }, zusammengeführt
merged-scans = Scans zusammengeführt
merged-with-own-calibrations = Die Scans wurden mit verschiedenen Kalibrierungen aufgenommen; die Punkte jedes Scans entstanden mit der eigenen.
merging-scans = { $count } Scans werden zusammengeführt
merlons-not-distinct-from-mirror-image = { $edges }: Breiten und Abstände der Zinnen sind von beiden Enden aus gleich, sodass sich der Zinnenkörper nicht von seinem Spiegelbild unterscheiden lässt
merlons-read-alike-either-side = seine Zinnen sehen von beiden Seiten gleich aus
merlons-read-mirrored-order = die Zinnen von „{ $name }“ erscheinen in gespiegelter Reihenfolge
merlons-stand-mirrored-order = die Zinnen liegen in gespiegelter Reihenfolge
mesh-contains-triangles-of = { $path } enthält { $found } von { $announced } Dreiecken
mesh-export-again = Das Werkstück noch einmal exportieren, als binäres STL
mesh-format-unknown = sie enthält kein Werkstück in einem bekannten Format
mesh-give-known-format = Eine Datei .stl, .step oder .stp angeben
mesh-header-is-not-complete = der Dateikopf ist nicht vollständig
mesh-line-decimal-commas = die Zahlen in Zeile { $line } haben Dezimalkommas ({ $text })
mesh-line-not-three-numbers = in Zeile { $line } stehen keine drei Zahlen ({ $text })
mesh-of-too-many-triangles = sie hat mehr als { $most } Dreiecke
mesh-state-unit = Die Einheit der Zahlen angeben (--unit mm, cm, m oder inch) oder in Millimetern exportieren
mesh-text-ends-early = sie endet in Zeile { $line } innerhalb eines Dreiecks oder ohne endsolid
mesh-without-triangles = sie hat kein Dreieck mit einer Fläche
message-too-large = { $size } Bytes sind mehr, als zulässig ist
broker-messages-not-read =
    { $count ->
        [one] { $count } Nachricht auf dem Broker wurde nicht gelesen: { $reasons }.
       *[other] { $count } Nachrichten auf dem Broker wurden nicht gelesen: { $reasons }.
    }
messages-of-no-station = { $count } ohne das Format einer Station
messages-of-too-many-stations = { $count } von mehr Stationen, als angezeigt werden
messages-stations = Nachrichten von Stationen
messages-too-long = { $count } zu lang
messages-too-often = { $count } schneller, als sie gelesen werden
method = Verfahren
mm = In mm
more-on-either-face =
    { $pair ->
        [crest] { $count } weitere auf den Zinnenoberseiten oder auf den Nutgründen
        [front] { $count } weitere auf der Vorder- oder Rückseite
       *[left] { $count } weitere auf der linken oder rechten Stirnseite
    }
more-poses-would-bring-little = Weitere Posen bringen kaum Verbesserung.
more-than-kb-were-sent = Die Anfrage ist größer als { $limit }.
more-touches-on-face = { $count } weitere { $where }
most-pixels-read = gelesen werden höchstens { $millions } Millionen
mount-tip-of-datasheet-or-give-diameter = Taster laut Datenblatt montieren oder den Durchmesser der Kugel selbst angeben.
move-away = Datei verschieben
move-away-start-again = Datei verschieben und neu starten
move-sensor-nearer-away-again-several = Den Sensor beim Überfahren der Platte mehrmals näher heran- und wieder wegführen
move-sensor-over-part-yourself = Sensor selbst über das Teil führen
move-sensor-until-whole-object-picture = den Sensor bewegen, bis das ganze Objekt im Bild ist
move-tip-another-place = Tastkugel an eine andere Stelle führen
not-moved-or-encoder-not-read = es wurde nicht bewegt, oder sein Winkelgeber wird nicht gelesen
moved-simulation-stopped = simulierten Bediener gestartet oder gestoppt
moved-turned = In { $duration } um { $moved } bewegt und um { $turned } gedreht
movement-tip = Bewegung der Tastkugel
moving-only-moves-whole-arm-space = eine Änderung verschiebt nur den ganzen Messarm im Raum
must-begin-http-https-name-machine = die Adresse muss mit http:// oder https:// beginnen und einen Rechner nennen
must-name = Erforderliche Spalten: { $names }
n-2-along = 2σ entlang { $axis }
n-2-encoders-alone = 2σ allein durch die Winkelgeber, { $axis }
n-2-worst-axis = 2σ beträgt auf der schlechtesten Achse { $two_sigma }; das Rauschen der Winkelgeber allein ergibt { $encoders }.
n-3d-view = 3D-Ansicht
view-3d-does-not-answer = Die 3D-Ansicht antwortet nicht.
view-3d-not-connected = Die 3D-Ansicht dieser Seite ist nicht verbunden
name-a-file = Datei angeben
name-a-folder = Ordner angeben
name-and-serial-number = { $name }, Seriennummer { $serial_number }
name-another-file = Eine andere Datei angeben
name-file-holds-brokers-password-alone = Eine für die Station lesbare Datei angeben, die nur das Passwort des Brokers enthält
name-folder-another-disk-backups-station = Mit backups in station.toml einen Ordner auf einem anderen Datenträger angeben.
name-folder-calibration-check-verification-has = Ordner einer Kalibrierung, einer Prüfung, einer Verifizierung oder einer Leistungsprüfung angeben: Er enthält eine der Dateien { $files }
name-folder-of-seats-spheres-bars = Ordner mit Pfannen, Kugeln oder Kugelstäben angeben, die mit dem Messarm angetastet wurden, oder mit Koordinaten eines Lasertrackers
name-folder-other-places-none-some = Einen Ordner mit anderen Positionen angeben oder keinen: Dann wird reihum ein Teil der Positionen ausgelassen
name-folder-that-is-not-there = Einen noch nicht vorhandenen Ordner angeben
name-frame-of-each-set-up = Jeder Aufstellung in der Spalte frame einen eigenen Namen geben
name-marker-in-column = Die Messmarke in der Spalte marker benennen oder die Tastkugel in arm.json berichtigen
name-password-do-belong-together = Name oder Passwort ist falsch.
name-recording = Aufzeichnung angeben
name-scan-mcap = scan.mcap angeben
name-sessions-folder = Ordner einer Sitzung angeben
name-tls-certificate-tls-key-station = tls_certificate und tls_key in station.toml angeben oder einen Proxy vorschalten.
name-too-long = der Name ist zu lang
named-joint-range = Gelenk { $joint } dreht von { $low } bis { $high }
named-next-part = Teil des nächsten Scans benannt
named-part = Teil eines Scans benannt
named-value = { $name } { $value }
near-base = nahe am Armfuß
needed = mindestens { $least_frames } sind nötig
needed-place = mindestens { $fewest_corners } sind nötig, um seine Lage zu bestimmen
needs-least =
    { $shape ->
        [plane] eine Ebene braucht mindestens { $least }
        [sphere] eine Kugel braucht mindestens { $least }
        [cylinder] ein Zylinder braucht mindestens { $least }
       *[other] mindestens { $least } sind nötig
    }
needs-least-three-conjugated-pairs = sie braucht mindestens drei zugeordnete Paare
neither-colours-nor-arms-poses-tell = weder die Farben noch die Posen des Messarms legen fest, welche Ecke die erste ist
nested-too-deeply = es ist zu tief verschachtelt
network = Netz
never-checked = Noch nie geprüft.
never-held-up-more-than = Nie um mehr als { $limit } verzögert.
new-password = neues Passwort
newest-record-days-later-than-clock = Der neueste Eintrag liegt { $days } Tage nach der aktuellen Uhrzeit.
next = Weiter: { $title }.
next-backup-would-include-this = die nächste Sicherung würde diese enthalten
next-pose-follow-dashed-outline = Für die nächste Pose: { $words }. Dem gestrichelten Umriss folgen.
no-account-name = { $name } ist kein zulässiger Kontoname
no-answer-from = Von { $url } kommt keine Antwort
no-answer-within = keine Antwort innerhalb von { $limit }
no-arm-model-joints-chosen = es ist kein Armmodell mit { $joint_count } Gelenken gewählt
no-arm-model-poses-chosen = kein Arm ist gewählt, der Posen meldet
no-arm-moves-that-fast = so schnell bewegt sich kein Arm
no-arm-near-given-one-explains = kein Messarm nahe dem angegebenen erklärt die Punkte; die von { $label } streuen um { $rms } (rms)
no-backup-made = Es wurde keine Sicherung angelegt: { $error }
no-ball-bar-measured-arms-size = es wurde kein Kugelstab gemessen: Der Maßstab des Messarms ist der seines Datenblatts; ein Fehler von { $error } im längsten Glied ergibt { $size } über die Reichweite
no-bright-line-runs =
    { $axis ->
        [u] keine helle Linie verläuft quer durch das Bild
       *[v] keine helle Linie verläuft von oben nach unten durch das Bild
    }
no-calibration-use-yet = es wird noch keine Kalibrierung verwendet
no-camera-answers = { $title } antwortet nicht
no-camera-found = { $title } wurde nicht gefunden
no-certificate-stated = kein Kalibrierschein angegeben
no-chessboard-x-inner-corners-found = es wurde kein Schachbrett mit { $columns } × { $rows } inneren Ecken gefunden
no-cloud-being-scanned = Es wird keine Punktwolke gescannt.
no-cloud-shows-gauge-yet-scan = Noch keine Punktwolke zeigt das Prüfnormal. Eine scannen.
no-cloud-taken-yet = Noch keine Punktwolke aufgenommen.
no-column = { $path }: Spalte { $names } fehlt
no-connection = keine Verbindung
no-coordinates-taken-yet = noch keine Koordinaten übernommen
no-crenellated-object-found-picture = im Bild wurde kein Zinnenkörper gefunden
no-data = Seit { $silent } keine Daten vom { $title }
no-data-yet = Noch keine Daten.
no-database-there = dort gibt es keine Datei { $database }
no-delay-found-yet = Es ist noch kein Zeitversatz bestimmt
no-file = es ist keine Datei
no-fitted =
    { $shape ->
        [plane] Keine Ebene eingepasst: { $error }
        [sphere] Keine Kugel eingepasst: { $error }
       *[cylinder] Kein Zylinder eingepasst: { $error }
    }
no-fitted-program-failed =
    { $shape ->
        [plane] Keine Ebene eingepasst: Ein Programmfehler ist aufgetreten.
        [sphere] Keine Kugel eingepasst: Ein Programmfehler ist aufgetreten.
       *[cylinder] Kein Zylinder eingepasst: Ein Programmfehler ist aufgetreten.
    }
no-flange-further-than = { $path }: Kein Flansch ist weiter als { $furthest } von der Basis des Messarms entfernt
no-folder-named = der Ordner { $folder } existiert nicht
no-frames = { $named }: keine Bilder
no-free-name-scan = kein freier Name für einen Scan in { $folder }
no-hand-no-knock-moves-joint = weder Hand noch Stoß bewegt ein Gelenk in so kurzer Zeit so weit
no-image-or-cut-off = es ist kein Bild oder unvollständig
no-joint-angle-exceeds = { $path }: Kein Gelenkwinkel übersteigt { $largest }
no-joint-angles = { $named }: keine Gelenkwinkel
no-joint-goes-there-back-between = kein Gelenk bewegt sich zwischen zwei Messwerten hin und zurück
no-joint-turned-more-than = { $label }: Kein Gelenk hat sich um mehr als { $swing } gedreht ({ $joint })
no-joints-around-any-frames-stamp = { $named }: keine Messwerte des Messarms um die Zeitstempel der Bilder
no-json = es ist kein JSON: { $error }
no-laser-stripe-found-object = auf dem Objekt wurde keine Laserlinie gefunden
no-laser-stripe-front-sensor-any = { $named }: in keinem der { $numbered } Bilder ist eine Laserlinie vor dem Sensor
no-laser-stripe-picture = Im Bild ist keine Laserlinie.
no-laser-stripe-picture-serves-camera = Im Bild ist keine Laserlinie: Es bestimmt nur Kamera und Lage des Sensors.
no-lengths-measured = keine Länge wurde gemessen
no-limit = kein Grenzwert
no-limit-set = kein Grenzwert festgelegt
no-limit-set-heading = Kein Grenzwert festgelegt
no-limit-set-identification-check-arm = Für eine Identifikation ist kein Grenzwert festgelegt: Eine Armprüfung beurteilt sie.
no-limit-set-so-check-neither = Es ist kein Grenzwert festgelegt, daher ist diese Prüfung nicht entschieden.
no-line-seen = keine Linie zu sehen
no-laser-line-visible = Keine Linie zu sehen
no-markers-found = keine Markierung aus { $dictionary } gefunden: „{ $name }“ wurde nicht erkannt
no-mcap-recording = es ist keine MCAP-Aufzeichnung
no-page-file-has-such-address = Unter dieser Adresse gibt es keine Seite und keine Datei.
no-picture-came-sensor = vom Sensor kam kein Bild
no-picture-came-within = innerhalb von { $limit } kam kein Bild
no-picture-in-folder = Im Ordner { $folder } gibt es kein Bild
no-picture-laser-came-within =
    { $state ->
        [on] innerhalb von { $limit } kam kein Bild mit eingeschaltetem Laser
       *[off] innerhalb von { $limit } kam kein Bild mit ausgeschaltetem Laser
    }
no-picture-shows-object-yet-take = Noch kein Bild zeigt das Objekt. Ein weiteres aufnehmen.
no-placing-edges-explains-those-picture = keine Lage des Objekts erklärt die Kanten im Bild
no-point-taken-back-since-last = Seit dem letzten Punkt wurde keiner zurückgenommen.
no-point-taken-yet = Noch kein Punkt aufgenommen.
no-points-can-made = { $interrupted } Daraus lassen sich keine Punkte berechnen: { CLAUSE($why) }.
no-pose-given = es wurde keine Pose angegeben
no-position-block-brings-them-onto = in keiner Lage dieses Zinnenkörpers liegen sie auf ihm
no-readable-figures = { $name } enthält keine lesbaren Kenngrößen
no-reason-given = Es ist kein Grund angegeben
no-record-is-open = In der Ansicht ist keine Aufnahme geöffnet
no-rotation-exceeds = { $path }: Kein Wert von rx_deg, ry_deg und rz_deg ist größer als { $largest }
no-seat-taken-yet = Noch keine Position aufgenommen.
no-seated-tip-does-points-another = bei einer Tastkugel in einer Pfanne ist das nicht möglich: Punkte einer anderen Position sind darunter, oder die Datei gehört zu einem anderen Messarm
no-serial-port-named = Der serielle Anschluss { $url } existiert nicht
no-serial-port-plugged = Es ist kein serieller Anschluss vorhanden.
no-single-contact-fault = es liegt nicht an einem einzelnen Antastpunkt
no-size-squares-makes-them-agree = bei keiner Feldgröße stimmen sie überein
no-station-data-folder = { $folder } ist kein Datenordner einer Station
no-such-file = die Datei existiert nicht
no-such-file-or-folder = die Datei oder der Ordner existiert nicht
no-such-folder-named = Der Ordner { $folder } existiert nicht
no-touch-taken-back-since-last = Seit dem letzten Antastpunkt wurde keiner zurückgenommen.
no-touch-taken-yet = Noch kein Antastpunkt aufgenommen.
no-two-opposite-sides-were-touched = Es wurden keine zwei gegenüberliegenden Seiten angetastet: Tastkugeldurchmesser und Größe des Zinnenkörpers entsprechen ihren Kalibrierscheinen und sind nicht geprüft.
no-video-file-named = Die Videodatei { $path } existiert nicht
nobody-asks-control = Niemand bittet um die Bedienung
nobody-may-use = { $path } darf niemand verwenden.
nobody-signed-here = Sie sind nicht angemeldet.
nominal-is-of =
    { $shape ->
        [sphere] die Sollwerte gehören zu einer Kugel
       *[plane] die Sollwerte gehören zu einer Ebene
    }
none-calibrations-belongs-these-recordings = Keine der Kalibrierungen gehört zu diesen Aufzeichnungen
none-edges-floors-base-shows-picture = im Bild ist keine Kante seiner Nutgründe und seiner Grundfläche zu sehen
none-significant = kein Koeffizient signifikant
normal-component = Normale { $axis }
normal-must-be-of-unit-length = normal muss die Länge 1 haben, nicht { $length }
covariance-must-be-symmetric-over-parameters =
    { $count ->
        [one] die Kovarianz muss eine Varianz von mindestens 0 sein, für { $count } Parameter
       *[other] die Kovarianz muss symmetrisch sein, mit einer Zeile und einer Spalte für jeden von { $count } Parametern und Varianzen von mindestens 0
    }
links-one-for-each-parameter =
    { $count ->
        [one] links muss einen Wert haben, für den einen Parameter eines Glieds
       *[other] links muss { $count } Werte haben, einen für jeden Parameter eines Glieds
    }
normal-must-have-unit-length = normal muss die Länge 1 haben
not-saved = Die Änderung wurde nicht gespeichert
not-usable-next-to-database = { $path } ist neben der Datenbank der Station nicht verwendbar
note = Hinweis
nothing-came-for = Von { $url } kam { $time } lang nichts
nothing-can-be-sent-to-arm = An den Messarm unter { $url } lässt sich nichts senden ({ $reason })
nothing-changed-since-solved = Seit der Berechnung hat sich nichts geändert.
nothing-changed-stations-log-has-details = es wurde nichts geändert; Näheres steht im Protokoll der Station
nothing-else-bears-out-shadow-highlight = { $text }, und nichts anderes bestätigt dies: Ein Schatten, ein Glanzlicht oder etwas davor kann so aussehen
nothing-listens = Unter { $url } antwortet kein Dienst
nothing-made-them = Sie wurden nicht verwendet. { CAPITAL(CLAUSE($remedy)) }.
nothing-runs = Nichts läuft
nothing-seen-no-contrast = Nichts zu erkennen: kein Kontrast
nothing-taken-reading-cannot-true-no = Unplausible Messwerte werden nicht verwendet: nicht für Antastpunkte, Posen oder gescannte Punkte.
nothing-taken-such-reading = ein solcher Messwert wird nicht verwendet
now = Jetzt
number-expected-here = erwartet wird hier eine Zahl
number-too-large = so große Werte werden hier nicht gemessen
numbers-without-decimal-comma = Zahlen brauchen einen Dezimalpunkt statt eines Kommas; Namen dürfen kein Komma enthalten
numerics = Numerik
object = Objekt
object-certificate = Kalibrierschein des Objekts
object-fills = Objekt füllt
object-not-found = das Objekt wurde nicht gefunden
object-looked-grey-images-8-16 = das Objekt wird in Graubildern mit 8 bis 16 Bit und mindestens 64 Pixeln je Richtung gesucht
object-off-m = Objektabw., µm
object-picture = Das Objekt ist im Bild
object-does-not-match-certificate = das Objekt im Bild passt nicht zum Kalibrierschein von „{ $name }“ ({ $serial_number })
object-picture-hold-arm-there-clamp = Das Objekt ist im Bild. Messarm dort halten oder festklemmen.
object-point-or-pixel-not-a-number = ein Objektpunkt oder ein Pixel ist keine Zahl
object-points-shape-pixels-shape = Objektpunkte der Form { $points } und Pixel der Form { $pixels }
object-too-far =
    { $side ->
        [left] Das Objekt liegt zu weit links
        [right] Das Objekt liegt zu weit rechts
        [up] Das Objekt liegt zu weit oben
       *[down] Das Objekt liegt zu weit unten
    }
objects-place-k-1 = Lage des Objekts (k = 1)
object-points-do-not-fit-pixels = die Punkte des Objekts passen nicht zu ihren Pixeln
of = { $page } von { $pages }
off = { $title } ist aus
offset-m = Versatz, µm
offset-not-separable = ein Fehler der Tastermatrix lässt sich nicht von der Lage der Kugel trennen
offset-not-significant = Die Lageabweichung bedeutet keinen Fehler der Tastermatrix: { $size } lassen sich nicht vom Zufall unterscheiden, { $left } blieben.
offset-worth-calibrating = Die Lageabweichung bedeutet, dass die Tastermatrix um { $size } falsch ist, oder der Maßstab des Sensors, was hier gleich aussieht; nach Berichtigung blieben { $left }. Neu zu kalibrieren würde helfen.
old-after-days-due = Sie ist { $ago } alt; Frist { $limit }. Sie ist fällig.
old-due-after-days = { $text }, { $ago } alt; Frist { $limit }.
old-password-wrong = Das alte Passwort ist falsch.
on-board = auf der Tafel
on-face =
    { $face ->
        [crest] auf den Zinnenoberseiten
        [floor] auf den Nutgründen
        [front] auf der Vorderseite
        [back] auf der Rückseite
        [left] auf der linken Stirnseite
        [right] auf der rechten Stirnseite
       *[other] auf der Fläche „{ $face }“
    }
one-browser-acts-time = bedienen kann jeweils nur ein Browser
one-diameter-wrong-or-sphere-not-clean = ein Durchmesser gehört nicht zu dieser Kugel, oder die Kugel war nicht sauber
one-line-alone-does-fix-lasers = eine einzelne Linie legt die Laserebene nicht fest
one-numbers-has-too-many-digits = eine ihrer Zahlen hat zu viele Ziffern
one-of = es ist eines von { $names }
one-picture-flat-board-tells-neither = ein Bild einer ebenen Tafel bestimmt weder die Brennweite noch die Laserebene
one-picture-per-file = eine Datei wird als ein Bild gelesen
one-plane-does-not-determine-camera = eine Ebene legt Brennweite, Abstand und Laserebene nicht gemeinsam fest
one-pose-alone-used-errors-arms = Es wurde nur eine Pose verwendet: Fehler der Armglieder zeigen sich nur in den Antastpunkten; nicht zum Bild gehörende Gelenkwinkel und ein nach dem Antasten bewegtes Objekt zeigen sich nicht.
one-pose-not-enough = eine Pose reicht bei „{ $name }“ nicht aus
one-pose-faugeras-contact-alignment = eine Pose (Faugeras, Ausrichtung über Antastpunkte)
one-recording-one-calibration-give-one = eine Aufzeichnung und eine Kalibrierung ergeben eine Ebene
one-rotation-expected = eine Drehung wird nur auf eine Weise angegeben
one-used-each-lighting = je Beleuchtung wird eines verwendet
one-value-expected-for = erwartet wird für { $label } ein Wert von 0 bis { $largest }
one-who-loses-control-reads-why = wer die Bedienung abgibt, erfährt den Grund
only-administrator = { $name } ist der einzige Administrator
only-ball-bars-are-scanned = durch Scannen werden nur die Kugeln eines Kugelstabs gemessen, und dieses Normal hat keine
only-corners-can-measured = nur { $found } seiner Ecken sind messbar
only-edge-points-lie-edges = nur { $agreeing } der Kantenpunkte liegen auf seinen Kanten
only-free-disk = nur { $free } sind auf dem Datenträger von { $folder } frei
only-joint-samples-came = nur { $count } Messwerte des Messarms in { $duration } empfangen
only-machines-browsers-reach-station = Nur Browser auf diesem Rechner erreichen die Station.
only-one-row-corners-each-level = mit nur einer Eckenreihe je Höhenstufe ist die Kamera nicht bestimmt
only-pose-take-another-first = Dies ist die einzige Pose. Zuerst eine weitere aufnehmen.
only-stations-own-pages-may-do = Das dürfen nur die Seiten dieses Servers.
only-visible-edges-show-picture = nur { $shown } seiner sichtbaren Kanten sind im Bild zu sehen
open-again = Erneut öffnen.
open-one-first = Zuerst eine öffnen
opened-kiosk = als Kiosk-Anzeige geöffnet
operation-not-permitted = der Vorgang ist nicht erlaubt
operator = Bediener
origin-mm = Ursprung, mm
other-files = die anderen Dateien gehören zu { $device } { $known }
other-sphere-measured = die angetastete Kugel hat einen Durchmesser, der um { $off } vom Kalibrierschein abweicht: Es ist eine andere Kugel, oder ein Durchmesser ist falsch eingetragen
other-bar-measured = Lage { $placement } ergab eine Länge von { $measured }, die nächste Länge des Kalibrierscheins ist { $certified }: Es ist ein anderer Kugelstab, oder eine Länge oder ein Durchmesser ist falsch eingetragen
other-machines-reach-encrypted = Andere Rechner erreichen die Station, verschlüsselt.
other-machines-reach-nothing-encrypted = Andere Rechner erreichen die Station, unverschlüsselt.
other-machines-reach-proxy = Andere Rechner erreichen die Station über einen Proxy.
other-serial-number = { $title } hat die Seriennummer { $found }, nicht { $wanted }
other-stations-see-one-one-them = Über den Broker sehen die Stationen einander. Sonst wird er nicht benötigt.
others-are-covered = die übrigen sind verdeckt, im Schatten oder zu schwach
others-are-overexposed = die übrigen sind überbelichtet
out-focus-edges-wide-wanted = Unscharf: Kanten { $width } breit, Soll { $wanted }
out-picture-covered-too-small-or-another-object = es liegt außerhalb des Bildes, ist verdeckt, zu klein oder zu schräg gesehen, oder dort liegt ein anderes Objekt
over-clouds = Über alle Punktwolken
over-reach-before-difference-arm-identified = Über die Reichweite: vorher die Abweichung vom identifizierten Messarm, nachher die Standardunsicherheit, k = 1.
over-reach-tip-off-rms-now = Über die Reichweite wich die Tastkugel um { $before } rms ab; die Standardunsicherheit beträgt jetzt { $after } (k = 1).
overexposed-share-at-full-scale = es ist überbelichtet: { $share } seiner Pixel sind in der Sättigung
package-named = das Paket { $name } { $version }
parameter = Parameter
parameters = Parameter
parameters-moved-do-same-together = die geänderten Parameter haben zusammen dieselbe Wirkung
part-edges-of-many-triangles = { $count ->
        [one] Eine Kante gehört zu mehr als zwei Dreiecken.
       *[other] { $count } Kanten gehören zu mehr als zwei Dreiecken.
    }
part-normals-inward-turned = Alle Dreiecke zeigten nach innen, wie das eingeschlossene Volumen zeigt; sie sind umgedreht.
part-of-other-unit = beide stimmten überein, wenn die Einheit des Werkstücks { $unit } wäre
part-of-path-is-no-folder = ein Teil des Pfads ist kein Ordner
part-of-second-board-in-picture = neben einer Tafel mit { $columns } × { $rows } inneren Ecken ist ein Teil einer zweiten im Bild
part-place = { $x }, { $y }, { $z }
part-size = { $x } × { $y } × { $z }
part-surface-one-sided = Die Oberfläche hat nur eine Seite wie ein Möbiusband: Vorzeichen von Abweichungen sagen dort nichts.
part-surface-open = Die Oberfläche ist offen: { $count ->
        [one] eine Kante gehört
       *[other] { $count } Kanten gehören
    } nur zu einem Dreieck, die längsten bei { $places }.
part-triangles-not-numbers = { $count ->
        [one] Ein Dreieck hat eine Ecke, die keine Zahl ist, und wird weggelassen.
       *[other] { $count } Dreiecke haben Ecken, die keine Zahlen sind, und werden weggelassen.
    }
part-triangles-turned = { $count ->
        [one] Ein Dreieck zeigte anders herum als die benachbarten und ist umgedreht.
       *[other] { $count } Dreiecke zeigten anders herum als die benachbarten und sind umgedreht.
    }
part-triangles-without-area = { $count ->
        [one] Ein Dreieck hat keine Fläche und wird weggelassen.
       *[other] { $count } Dreiecke haben keine Fläche und werden weggelassen.
    }
part-without-unit = Die Datei nennt keine Einheit. In { $unit } ist das Werkstück { $size } groß; eine andere mit --unit angeben.
pass = Bestanden
pass-does-not-tell-delay = diese Überfahrt zeigt den Zeitversatz nicht
pass-half-minute-enough = eine Überfahrt von einer halben Minute reicht
pass-has-pictures-lasers-line-plane = die Überfahrt enthält { $count } Bilder mit der Laserlinie auf der Ebene
pass-over-flat-plate-fills-lasers = Über eine ebene Platte fahren, die die Laserlinie ausfüllt
pass-over-more-gauge = Mehr vom Prüfnormal überfahren
pass-over-plane-find = Über eine Ebene fahren und den Zeitversatz bestimmen
pass-over-plate = Überfahrt über die Platte
pass-over-several-sides = Aus mehreren Richtungen überfahren
pass-stopped = Die Überfahrt wurde abgebrochen
pass-stripe-slowly-each-pass-cloud =
    { $shape ->
        [plane] Laserlinie langsam über das ganze Prüfnormal führen. Jede Überfahrt ist eine eigene Punktwolke.
       *[sphere] Laserlinie langsam von drei Seiten über die Kugel führen. Jede Überfahrt ist eine eigene Punktwolke.
    }
pass-stripe-slowly-over-gauge = Laserlinie langsam über das Prüfnormal führen
pass-stripe-slowly-over-whole-gauge = Laserlinie langsam über das ganze Prüfnormal führen, dann die Punktwolke abschließen.
passed-ago-due-after-days = Bestanden ({ $ago } her); Frist { $limit }.
password-has-characters = Das Passwort hat { $count } Zeichen
password-is-name = Das Passwort ist mit dem Namen identisch
password-length-wanted = { $least } bis { $most } sind erforderlich
patches-not-covered = die Scans decken die Flecken { $patches } der Kugel nicht ab
performance-articulation-largest = Einzelpunkt-Schwenkprüfung, größter Abstand
performance-articulation-two-s = Einzelpunkt-Schwenkprüfung, zweifache Standardabweichung
performance-beyond-limit = { $title }: { $value }, jenseits der Grenze von { $limit }; Unsicherheit des Prüfwerts { $uncertainty } (k = 2).
performance-cause-arm = Die angetasteten Mittelpunkte liegen { $apart } auseinander, die Streuung der Antastungen erklärt { $usual }: Glieder oder Winkelgeber des Arms weichen je nach Haltung ab.
performance-cause-outliers = { $share } der Punkte der Scans liegen weit neben der Kugel: Reflexe oder Ausreißer des Sensors.
performance-cause-tip =
    { $way ->
        [large] Die angetastete Kugel ist { $size } zu groß: Der Taster ist größer als angegeben.
       *[small] Die angetastete Kugel ist { $size } zu klein: Der Taster ist abgenutzt oder kleiner als angegeben, oder die Kugel gibt beim Antasten nach.
    }
performance-conditions-not-met = { $title }: { $value }; nicht entschieden, denn { $problem }.
performance-dispersion-scan = Streuung der gescannten Kugel, 95 % aller Punkte
performance-bars-caption =
    { CAPITAL($title) }, in µm, { $of ->
        [measurement] nach Messung
        [orientation] nach Ausrichtung des Sensors
        [seat] nach Pfanne: 1 nahe der Schulter, 2 in der Mitte, 3 fern
       *[placement] nach Lage des Kugelstabs
    }.{ $limited ->
        [yes] { " " }Gestrichelt: die größte zulässige Abweichung.
       *[no] { "" }
    }
performance-effective-diameter = wirksamer Durchmesser der Meisterkugel
performance-expansion-unknown = der Prüfkörper { $name } hatte { $celsius }, mehr als { $most } von 20 °C entfernt, und sein Kalibrierschein enthält keinen Ausdehnungskoeffizienten: expansion_per_c und dessen Standardunsicherheit expansion_sd_per_c in der Datei des Prüfkörpers eintragen (dehnt er sich nicht aus: 0 und eine Unsicherheit über 0)
performance-form-unknown = der Kalibrierschein von { $name } nennt keine Formabweichung: Form und Streuung werden nicht entschieden; form_um und deren Standardunsicherheit form_sd_um in der Datei der Kugel eintragen
performance-fewer-lengths =
    { $count ->
        [one] das Normal hat nur eine Länge, und das Verfahren verlangt fünf
       *[other] das Normal hat nur { $count } Längen, und das Verfahren verlangt fünf
    }
performance-form-both = Form, angetastet und gescannt zusammen
performance-form-scan = Form der gescannten Kugel, 25 Stellen
performance-form-touch = Form der angetasteten Kugel
performance-gate = Auswahlbereich: { $shell } um die kalibrierte Kugel, Einfallswinkel bis { $incidence }, bis { $cone } vom Pol; vor der Prüfung festgelegt.
performance-length-gate = Zählbereich der Scans: { $shell } um die kalibrierten Kugeln, Einfallswinkel bis { $incidence }, mehr als { $cone } von der Richtung des Stabs; alle Punkte darin zählen.
performance-length-scan = Längenabweichung durch Scannen
performance-length-touch = Längenabweichung durch Antasten
performance-left-out =
    { $which ->
        [sphere] Ohne Meisterkugel: Der wirksame Durchmesser wurde ausgelassen.
       *[bar] Ohne Kugelstab: Die räumlichen Längen wurden ausgelassen.
    }
performance-limit-twice = Die Größe { $quantity } hat mehr als einen Grenzwert.
performance-limit-unused = Der Plan enthält einen Grenzwert für „{ $title }“; dieser Test misst diese Größe nicht, der Grenzwert bleibt ungenutzt.
performance-limits-broken = Ein Wert hält seinen Grenzwert nicht ein.
performance-limits-kept = Jeder Wert, der einen Grenzwert hat, hält ihn ein.
performance-location-both = Abstand der gescannten von der angetasteten Kugel
performance-location-scan = Lage der gescannten Kugel über die Stellungen
performance-location-touch = Lage der angetasteten Kugel über die Stellungen
performance-near-limit = { $title }: { $value }, für eine Entscheidung zu nahe an der Grenze von { $limit }; Unsicherheit des Prüfwerts { $uncertainty } (k = 2).
performance-no-arm = kein Datenblatt im Ordner arms gehört zum angeschlossenen Messarm, oder es nennt keine Tastkugel
performance-extracted-by = Alle Punkte im Auswahlbereich zählen. Die Linie wurde in den Bildern der Scans mit diesen Einstellungen gesucht: { $names }.
performance-scans-set-otherwise = der Scan { $scan } wurde mit anderen Einstellungen aufgenommen als { $other }: Alle Scans einer Prüfung brauchen dieselben
performance-smoothed =
    Alle Punkte im Auswahlbereich zählen. Sie wurden bei der Aufnahme längs der Laserlinie um { $smoothing } geglättet, was Formabweichungen und Streuung kleiner macht.{ $others ->
        [none] { "" }
       *[other] { " " }Weitere Einstellungen: { $others }.
    }
performance-no-filter = Alle Punkte im Auswahlbereich zählen; kein Filter wird angewendet.
performance-no-value = { $title }: kein Wert, denn { $problem }.
performance-not-decided = Nicht jeder Wert ist entschieden.
performance-one-position = Die Kugel wurde an einer Position gemessen; die Norm verlangt zwei.
performance-plane-is-addition = Die Form einer Ebene ist eine Ergänzung: Die Prüfung der Norm gilt für flächenhafte Sensoren.
performance-plane-scan = Form der gescannten Ebene, 95 % aller Punkte
performance-size-all-scan = Größenabweichung der gescannten Kugel, alle Punkte
performance-size-both = Größenabweichung, angetastet und gescannt zusammen
performance-size-scan = Größenabweichung der gescannten Kugel, 25 Stellen
performance-size-touch = Größenabweichung der angetasteten Kugel
performance-status-no-conformity-claimed = Verfahren nach ISO 10360-12:2016, ISO 10360-8:2013 und ASME B89.4.22-2004, wie im Handbuch von Crenel beschrieben; eine Übereinstimmung mit diesen Normen wird nicht behauptet.
performance-steadiness-unknown = Ob die Temperaturen beständig waren, ist nicht bekannt: Prüfkörper und Arm wurden nicht beide am Anfang und am Ende gemessen.
performance-temperature-changed =
    { $which ->
        [arm] die Temperatur des Arms änderte sich während der Prüfung um { $change }, um mehr als { $most }
       *[other] die Temperatur des Prüfkörpers änderte sich während der Prüfung um { $change }, um mehr als { $most }
    }
plan-without-artefact =
    { $which ->
        [master] der Plan nennt keine Meisterkugel
        [sphere] der Plan nennt keine Kugel
        [lengths] der Plan nennt kein Längennormal
        [plane] der Plan nennt keine Platte
       *[bar] der Plan nennt keinen Kugelstab
    }
performance-temperature-far =
    { $which ->
        [arm] der Arm hatte { $celsius }, mehr als { $most } von 20 °C entfernt
       *[other] der Prüfkörper hatte { $celsius }, mehr als { $most } von 20 °C entfernt
    }
performance-temperatures-steady = Die Temperaturen von Prüfkörper und Arm änderten sich um höchstens { $change } (Grenze { $most }) und blieben innerhalb von { $off } um 20 °C.
performance-volumetric-largest = räumliche Länge, größte Abweichung
performance-volumetric-two-rms = räumliche Länge, zweifacher quadratischer Mittelwert
performance-plane-gate =
    { $count ->
        [one] Es zählen Punkte über der Platte, mindestens { $rim } innerhalb ihres Umrisses und höchstens { $shell } von ihrer Ebene; ein Punkt der Scans zählt nicht. Keiner wird wegen seines Residuums entfernt.
       *[other] Es zählen Punkte über der Platte, mindestens { $rim } innerhalb ihres Umrisses und höchstens { $shell } von ihrer Ebene; { $count } Punkte der Scans zählen nicht. Keiner wird wegen seines Residuums entfernt.
    }
performance-touches-taken-back =
    { $count ->
        [one] Eine Antastung wurde vom Bediener zurückgenommen.
       *[other] { $count } Antastungen wurden vom Bediener zurückgenommen.
    }
performance-within-limit = { $title }: { $value }, innerhalb der Grenze von { $limit }; Unsicherheit des Prüfwerts { $uncertainty } (k = 2).
permission-denied = Zugriff verweigert
pick-more-way-round-fit-plane = Mehr vom Umfang auswählen oder eine Ebene einpassen
picture-being-taken-already = es wird bereits ein Bild aufgenommen
picture-blurred-edges-wide = das Bild ist unscharf: Seine Kanten sind { $width } breit
picture-blurred-edges-wide-most-can = das Bild ist unscharf: Seine Kanten sind { $blur } breit, messbar sind höchstens { $limit }
picture-blurred-noisy = das Bild ist unscharf oder verrauscht
picture-bytes-do-not-fit = { $name }: { $bytes } Bytes für { $width } × { $height } Pixel, { $row } je Zeile
picture-can-read-more-than-one = das Bild von „{ $name }“ ist nicht eindeutig
picture-cannot-be-encoded = das Bild ließ sich nicht als PNG kodieren
picture-cannot-be-used-take-it-again =
    { $others ->
        [yes] Dieses Bild ist nicht brauchbar. Neu aufnehmen oder ohne dieses Bild fortfahren.
       *[no] Dieses Bild ist nicht brauchbar. Neu aufnehmen.
    }
picture-cannot-read = Das Bild { $path } ist nicht lesbar
picture-dim-bright-parts-reach-full = das Bild ist dunkel: Die hellen Bereiche erreichen { $high } des Aussteuerbereichs
picture-has-size =
    { $picture ->
        [laser] das Laserbild hat { $width } × { $height } Pixel
       *[ambient] das Kalibrierbild hat { $width } × { $height } Pixel
    }
picture-incomplete = das Bild ist nicht vollständig
picture-mirrored-camera-looks-objects-back = das Bild ist gespiegelt, oder die Kamera sieht die Rückseite des Objekts
picture-objects-certificate-contradict-each-other = Bild und Kalibrierschein des Objekts widersprechen sich
picture-of-cloud = Bild der Punktwolke
picture-of-cloud-seen-from = { $name }, von oben vorn, nach Höhe gefärbt.
picture-of-kind-that-is-not-read = es ist eine { $kind }-Datei, die nicht gelesen wird
picture-of-numbers = Das Bild { $path } besteht aus { $kind }-Zahlen
hold-still-for-both-pictures = Sensor und Objekt ruhig halten, bis beide Bilder aufgenommen sind, oder den Raum abdunkeln
pictures-with-and-without-laser-differ-by-motion = zwischen dem Bild mit Laser und dem ohne hat sich etwas bewegt ({ $shifted } des Bildes), sodass das Raumlicht nicht abgezogen werden konnte
picture-overexposed = { $saturated } des Bildes sind überbelichtet
picture-shows-no-contrast-full-scale = das Bild zeigt keinen Kontrast: { $contrast } des Aussteuerbereichs
picture-shows-no-laser-line-object = ihr Bild zeigt keine Laserlinie auf dem Objekt
picture-shows-objects-mirror-image = das Bild zeigt das Spiegelbild des Objekts
picture-size-changed = { $title } hat sein Bild von { $width } × { $height } auf { $new_width } × { $new_height } Pixel geändert
picture-soft-edges-wide = das Bild ist etwas unscharf: Seine Kanten sind { $width } breit
pictures-arrive-incomplete = { $title } sendet Bilder, die unvollständig ankommen
pictures-came-without-arms-position = { $count } von { $total } Bildern kamen ohne Stellung des Messarms
pictures-contacts-certificate-contradict-each-other = Bilder, Antastpunkte und Kalibrierschein widersprechen sich
pictures-different-sizes = die Bilder sind verschieden groß: { $sizes }
flat-board-one-direction-does-not-tell-focal-length = Bilder einer ebenen Tafel aus einer Richtung bestimmen die Brennweite nicht
pictures-have-object-turned-how-touched = In den Bildern ist das Objekt gegenüber der angetasteten Lage um { $turned } gedreht. Gescannte Punkte können um ebenso viel falsch liegen.
pictures-have-object-where-touched-turned = In den Bildern liegt das Objekt { $off } (± { $known }) neben der angetasteten Lage, um { $turned } gedreht. Gescannte Punkte können um ebenso viel falsch liegen.
pictures-left-out = Bilder werden übersprungen: { $what }
pictures-of-one-pose-need-still-arm = die Bilder einer Pose werden bei ruhendem Messarm aufgenommen
pictures-recording-were-left-out = Die Aufzeichnung enthält { $kept } Bilder, { $left_out } wurden übersprungen
pictures-show =
    { $seen ->
        [one] { $seen } Bild zeigt „{ $name }“
       *[other] { $seen } Bilder zeigen „{ $name }“
    }
pictures-were-lost = { $count } von { $total } Bildern gingen verloren
pictures-were-taken-too-fast-up = { $count } von { $total } Bildern wurden in zu schneller Bewegung aufgenommen: bis { $worst } Unschärfe
pixel-format-unknown = { $title } sendet Bilder im Pixelformat { $name }, das nicht unterstützt wird
pixel-formats-are = Setzen Sie pixel_format auf eines von { $names }
pixels-alternate-as-raw = die Pixel wechseln sich ab wie im Rohbild einer Farbkamera, werden aber als Grau gemessen
place-sensor-so-both-crests-floors = Sensor so halten, dass Zinnenoberseiten und Nutgründe im Bild sind
place-sensor-so-stripe-crosses-crests = Sensor so halten, dass die Laserlinie Zinnenoberseiten und Nutgründe kreuzt
place-touch = Das ist die Stelle von Antastpunkt { $number }
placed = Lage
places = { $done } von { $seats_wanted } Positionen
places-done = { $done } Positionen
places-held-out-arms-errors-go = in der Kreuzvalidierung ändern sich die Fehler des Messarms vom { $before }-Fachen auf das { $after }-Fache ihres Rauschens
places-held-out-still-deviate = in der Kreuzvalidierung weichen die Positionen noch um das { $times }-Fache ihres Rauschens ab: weitere Positionen aufnehmen, gleichmäßiger über die Reichweite verteilt
places-were-held-out-fit-over = An Positionen, die nicht in die Ausgleichung eingingen, und über die gesamte Reichweite des Messarms.
plane-equation = ({ $x }; { $y }; { $z }) · x = { $offset }
laser-plane-does-not-cross-board-sharply = eine Ebene, die nahezu in der Tafel liegt, schneidet sie nicht in einer scharfen Linie
plane-needs-both-directions = für eine Ebene sind { $width } in beiden Richtungen nötig
plane-needs-lines = die Laserebene braucht Linien in mindestens { $fewest } Bildern; die übrigen Bilder bestimmen Kamera und Lage des Sensors
plane-needs-lines-in-some = Für diese Pose genügt das. In mindestens { $fewest } anderen Bildern muss die Laserlinie über die Tafel verlaufen.
plane-swept-straight-across-angle = Gerade überfahrene Ebene: Winkel
plane-through-cameras-centre-gives-no = eine Ebene durch den Mittelpunkt der Kamera ergibt keine Tiefe
plate-not-in-enough-orientations = die Platte wurde nicht in { $count } Ausrichtungen gescannt
plate-scan-too-narrow = der Scan zeigt nur einen { $width } breiten Streifen der Platte; nötig sind { $least }
plate-was-not-scanned = die Platte wurde nicht gescannt
plug-right-arm-correct-arm-joint = Richtigen Messarm anschließen oder [arm] joint_count berichtigen.
point = Punkt { $number }, { $place }.
point-of-face = { $face }, Punkt { $index }
point-again = Das ist erneut Punkt { $point }
point-back = Punkt { $index } ist wiederhergestellt.
point-cannot-true = Punkt { $index } ist unplausibel: { $what }; { $why }.
point-expanded-uncertainty = Gescannter Punkt, rms im Messvolumen: erweiterte Unsicherheit
point-known-good =
    { $point ->
        [seen] Standardunsicherheit eines im Abstand der Tafel gesehenen Punkts im Flanschsystem: { $total } (k = 1); gut ist bis { $good }.
       *[scanned] Standardunsicherheit eines gescannten Punkts im Flanschsystem: { $total } (k = 1); gut ist bis { $good }.
    }
point-known-k-1 = { $name }, Standardunsicherheit eines Punkts { $total } (k = 1)
point-known-mostly-by =
    { $point ->
        [seen] Standardunsicherheit eines im Abstand der Tafel gesehenen Punkts im Flanschsystem: { $total } (k = 1), größter Beitrag: { $source } ({ $value }); der Grenzwert ist { $limit }.
       *[scanned] Standardunsicherheit eines gescannten Punkts im Flanschsystem: { $total } (k = 1), größter Beitrag: { $source } ({ $value }); der Grenzwert ist { $limit }.
    }
point-at-place = { $place }, Punkt { $number }
point-left-out-off = { $place }, Punkt { $number }: { $distance } Abweichung
point-lies-on-other-face = Punkt { $index } verfehlt die Fläche „{ $face }“ um { $off } und liegt { $where }.
point-misses-face = Punkt { $index } verfehlt die Fläche „{ $face }“ um { $off }.
point-off-face = Punkt { $index } liegt { $off } neben der Fläche „{ $face }“; die übrigen stimmen auf { $rms } überein.
point-off-face-remove-then-go = Punkt { $point } liegt nicht auf seiner Fläche. Punkt entfernen, dann fortfahren.
point-off-plane-others = Punkt { $index } liegt { $off } neben der Ebene der übrigen.
point-removed = Punkt { $index } ist entfernt.
point-standard-uncertainty = Gescannter Punkt, rms im Messvolumen: Standardunsicherheit
point-taken-off = Punkt { $index } { $where }: { $off }.
point-no-longer-there = Diesen Punkt gibt es nicht mehr.
points-1-lie-apart-while-single = { $label }: Die Punkte 1 bis { $split } und { $next } bis { $points } liegen { $gap } auseinander, während einzelne Punkte um { $sd } streuen
points-taken = { $taken } Punkte
points = Punkte
points-blocks-edges-fit-camera-rms = { $points } Punkte auf den Kanten des Zinnenkörpers passen zur Kamera mit { $rms } rms (Grenzwert { $edge_rms_px }), am schlechtesten in Pose { $number }: { $edges_rms } (Grenzwert { $worst_limit }).
points-check-among-those-fit = { $shared } der { $count } Prüfpunkte gehören auch zu den Punkten der Ausgleichung
points-disagree-rest = { $label }: { $out } von { $points } Punkten widersprechen den übrigen
points-not-on-sphere = ihre Punkte liegen nicht auf einer solchen Kugel
points-edges-fit-camera-rms-limit = { $points } Punkte auf { $edges } Kanten passen zur Kamera mit { $rms } rms; der Grenzwert ist { $edge_rms_px }.
points-fix-no-cylinder = die Punkte legen keinen Zylinder fest
points-here-welcome-beside-those-other = { $place } Punkte hier sind hilfreich, zusätzlich zu denen auf den anderen Flächen.
points-laser-stripe-lie-object-levels = { $points } Punkte der Laserlinie liegen auf dem Objekt (von { $found } auf seinen Höhenstufen; { $least } sind auf Zinnenoberseiten und auf Nutgründen nötig)
points-lasers-line-lie-board-but-poses =
    { $count ->
        [one] { $points } Punkte der Laserlinie liegen auf der Tafel, { $rms } rms neben der Ebene. Pose { $poses } zeigt keine und bestimmt nur Kamera und Lage des Sensors.
       *[other] { $points } Punkte der Laserlinie liegen auf der Tafel, { $rms } rms neben der Ebene. Die Posen { $poses } zeigen keine und bestimmen nur Kamera und Lage des Sensors.
    }
points-lasers-line-lie-board-rms = { $points } Punkte der Laserlinie liegen auf der Tafel, { $rms } rms neben der Ebene.
points-lie-about-nearest-plane = bei jedem Zeitversatz streuen die Punkte um { $spread } (k = 1) um die Ausgleichsebene
points-lie-in-another-frame = coordinates.csv: { $far } von { $points } Punkten im Koordinatensystem { $name }, von Zeile { $first } bis Zeile { $last }, passen zueinander, liegen aber { $off } neben den anderen
points-lie-one-line = die Punkte liegen auf einer Geraden
points-lie-one-plane = die Punkte liegen in einer Ebene
points-lie-too-small-piece = die Punkte liegen auf einem zu kleinen Ausschnitt
points-lie-too-small-piece-sphere = die Punkte liegen auf einem zu kleinen Ausschnitt einer Kugel oder gehören zu einer anderen Form
points-not-within-one-plane = kein Zeitversatz bis ± { $range } bringt mehr als { $share } der Punkte auf { $distance } an eine Ebene: sie ist keine, oder die Uhren weichen stärker ab
points-made = { $name }: { $points } Punkte berechnet.
points-made-again-while-no-scan = Die Punkte werden aus der Aufzeichnung berechnet, sobald kein Scan läuft.
points-made-when-there-room-no = { $interrupted } Die Punkte werden berechnet, sobald Speicherplatz frei ist und kein Scan läuft.
points-not-made-again = Die Punkte lassen sich nicht berechnen: { CLAUSE($why) }.
points-of = { $taken } von { $wanted } Punkten
points-of-frame-disagree = coordinates.csv: { $out } von { $points } Punkten im Koordinatensystem { $name } passen nicht zu den übrigen
points-places = { $points } Punkte an { $places } Positionen
points-saved =
    { $count ->
        [one] { $name }: { $count } Punkt gespeichert
       *[other] { $name }: { $count } Punkte gespeichert
    }
points-taken-themselves-while-arm-swings = Punkte werden automatisch aufgenommen, während der Messarm schwenkt.
points-used = Verwendete Punkte
points-were-taken-another-arm-file = die Punkte wurden mit einem anderen Messarm aufgenommen, oder die Datei ist falsch
ports-are = Vorhandene Anschlüsse: { $names }.
pose-for-reason = Pose { $number }: { CLAUSE($reason) }.
pose-named = Pose { $number }: { $name }
pose-at-pixel = Pose { $number } ({ $u }, { $v })
pose = Pose
pose-count-one-other-s-taken =
    { $count ->
        [one] { $count } Pose ist aufgenommen.
       *[other] { $count } Posen sind aufgenommen.
    }
pose-differs-from-line = { $place }: { $moved } Abweichung von Zeile { $line } derselben Pose { $pose }
pose-found-minus-computed-times-larger =
    Pose { $number }: gemessen minus berechnet, { $factor }-fach vergrößert; Ecken gelb, höchstens { $largest }; Laserlinie rot. { $fitted ->
        [corners] Ecken { $rms }
       *[edges] Kanten { $rms }
    }, Laserlinie { $stripe_rms } rms.
pose-residuals-corners-without-stripe =
    Pose { $number }: gemessen minus berechnet, { $factor }-fach vergrößert; Ecken gelb, höchstens { $largest }; keine Laserlinie. { $fitted ->
        [corners] Ecken { $rms }
       *[edges] Kanten { $rms }
    } rms.
pose-has-no-picture = { $place }: Pose { $pose } hat kein { $missing }-Bild
pose-is-set-aside = Ausgeschlossen
pose-jumped = der Arm meldet eine Pose, die { $step } und { $turn } von der vorigen abweicht
pose-jumped-and-stayed = die Pose des Arms sprang um { $step } und { $turn } und blieb dort
pose-left-out = Pose { $number } wurde ausgeschlossen: { CLAUSE($reason) }.
pose-looks-same-turned-round = Pose { $number }: „{ $name }“ sieht gedreht gleich aus
pose-needs-a-lit-picture = für eine Pose ist ein Bild „ambient“ nötig oder eines mit beiden Beleuchtungen („both“); auf einem Schachbrett darf das Bild „laser“ fehlen
pose-needs-both-lightings = für eine Pose sind ein Bild „ambient“ und ein Bild „laser“ nötig oder eines mit beiden Beleuchtungen („both“)
pose-no-number = der Arm meldet eine Pose, die keine Zahl ist
pose-no-rotation = der Arm meldet eine Pose, deren Quaternion nicht die Länge 1 hat
pose-not-set-aside = Diese Pose ist nicht ausgeschlossen.
pose-excluded = Pose { $n } ist ausgeschlossen
pose-shows-corners = Pose { $number } zeigt { $found } Ecken von „{ $name }“
pose-shows-no-laser-line-object = Pose { $number } zeigt keine Laserlinie auf dem Objekt und wird ohne diese verwendet.
pose-taken = Pose { $number } ist aufgenommen.
pose-taken-back = Pose { $n } ist wieder einbezogen
pose-no-longer-there = Diese Pose gibt es nicht mehr.
pose-used-other-one-pose =
    { $unused ->
        [one] Pose { $number } wurde verwendet; beim Verfahren one-pose bleibt die andere unberücksichtigt
       *[other] Pose { $number } wurde verwendet; beim Verfahren one-pose bleiben die anderen { $unused } unberücksichtigt
    }
pose-would-help-most-scanned-point = Die wirksamste Pose: { $words }. Unsicherheit eines gescannten Punkts: { $now } → { $then } (k = 1).
poses = die Posen
poses-heading = Posen
poses-agree-boards-place-pose-furthest = { $used } Posen stimmen in der Lage der Tafel auf { $median } überein; Pose { $number } weicht am weitesten ab, um { $off }.
poses-agree-objects-place-pose-furthest = { $used } Posen stimmen in der Lage des Objekts auf { $median } überein; Pose { $number } weicht am weitesten ab, um { $off }.
poses-all-alike-do-not-tell-mounting = gleichartige Posen bestimmen die Lage des Sensors am Flansch in keiner Richtung
poses-contacts-scatter-times-more-than = Posen und Antastpunkte streuen { $noise }-mal mehr, als die Winkelgeber des Messarms erklären (Grenzwert { $noisy }).
poses-enough = { $done } Posen reichen aus
poses-measured =
    { $points ->
        [one] { $points } Punkt
       *[other] { $points } Punkte
    } in { $frames ->
        [one] { $frames } Koordinatensystem
       *[other] { $frames } Koordinatensystemen
    }
poses-move-too-little = images.csv: nach den Bildern bewegt sich der Arm { $ratio }-mal so weit, wie seine Posen sagen
poses-put-up-apart =
    { $thing ->
        [board] nach den Posen { $poses } liegen die Lagen der Tafel bis zu { $apart } auseinander
       *[object] nach den Posen { $poses } liegen die Lagen des Objekts bis zu { $apart } auseinander
    }
poses-touches = Posen und Antastpunkte
poses-were-changed-solve-again-undo = Die Posen wurden geändert. Neu berechnen oder die Änderung zurücknehmen.
poses-without-contact-points = { $count } Posen ohne Antastpunkte
positions =
    { $bars } in { $positions ->
        [one] { $positions } Lage
       *[other] { $positions } Lagen
    }
pressed-stop = „Stopp“ gedrückt
principal-point = Hauptpunkt
principal-point-at = { $u }; { $v }
probe-matrix-sensors-frame-arms-last = Tastermatrix: Koordinatensystem des Sensors in dem des letzten Gelenks des Messarms.
probe-object = Objekt antasten
program-failed = ein Programmfehler ist aufgetreten
program-reads-version = dieses Programm liest Version { $version } von { $format }
projection-matrix-is-not-product = projection_matrix ist nicht matrix · [rotation | translation_mm]
protobuf-expected = erwartet wird { $schemas } in Protobuf
put-another-logo = Ein anderes Bild dorthin legen oder es entfernen
put-arm-back = Vorherigen Messarm wiederherstellen
put-back-end-swing = Wieder einsetzen oder den Schwenk abschließen.
put-back-what-there-before = vorherigen Messarm wiederhergestellt
put-certificate-into-folder-gauges = Datenblatt eines Prüfnormals oder digitalen Kalibrierschein (DCC) einer Kugel unter Datenblätter hinzufügen.
put-file-back-last-backup-leave = Datei aus der letzten Sicherung wiederherstellen oder ohne sie fortfahren.
put-file-back-last-backup-restart = Datei aus der letzten Sicherung wiederherstellen und die Station neu starten oder neu kalibrieren
put-file-place = Durch eine normale Datei ersetzen
put-last-one-back = letzte Eingabe wiederhergestellt
put-point-back = Punkt { $i } wiederherstellen
put-tip-into-bars-other-end = Tastkugel in das andere Stabende setzen
put-tip-into-end-ball-bar = Tastkugel in ein Ende des Kugelstabs setzen
put-tip-into-seat = Tastkugel in die Pfanne setzen
put-tip-into-seat-of-number = Tastkugel in Pfanne { $done } setzen
put-touch-back = Antastpunkt { $i } wiederherstellen
puts-object-fits-other-pose =
    { $readings ->
        [pose] danach läge das Objekt { $off } neben seiner Lage nach den übrigen Posen; sie passt zur Roboterpose von Pose { $other }
       *[angles] danach läge das Objekt { $off } neben seiner Lage nach den übrigen Posen; sie passt zu den Gelenkwinkeln von Pose { $other }
    }
puts-object-where-others-put = danach läge das Objekt { $off } neben seiner Lage nach den übrigen Posen
python-package-missing = Das Python-Paket { $package } fehlt
quaternion-length = { $place }: (qx, qy, qz, qw) hat die Länge { $length }
radius-m = Radius, µm
radius-mm-missing-sphere-judged-size = { $radius } fehlt: Eine Kugel wird nach ihrer Größe beurteilt
raise-receive-buffer = Der Empfangspuffer dieses Rechners ({ $limit }) ist kleiner als ein Bild ({ $picture }). Ausführen: { $command }
not-read-yet = Noch nicht gelesen.
reading-of-arm-not-a-number = ein Wert des Messarms { $name } ist keine Zahl
readings-arm = Messwerte des Messarms
readings-arm-could-true-last =
    { $count ->
        [one] { $count } Messwert des Messarms war unplausibel: { $what }
       *[other] { $count } Messwerte des Messarms waren unplausibel; der letzte: { $what }
    }
readings-equal-as-never-of-encoder = mindestens { $equal_frozen } Messwerte nacheinander sind bis auf die letzte Stelle gleich; das kommt bei einem intakten Winkelgeber nie vor
readings-shape-arm = Werte der Form { $shape } für den Messarm { $name }
reason-and-more = { $reason } (und { $more } weitere)
reasons = Gründe
rebuild-recording-crenel-reconstruct = aus der Aufzeichnung mit crenel reconstruct neu berechnen
rebuilding-clouds-every-calibration = Punktwolken werden mit jeder Kalibrierung neu berechnet
rebuilt-verification-every-calibration = Verifizierung mit jeder Kalibrierung neu berechnet
record-cannot-be-opened = Die Aufnahme lässt sich jetzt nicht öffnen
record-no-longer-in-data-folder = Der Eintrag ist nicht mehr im Datenordner.
record-one-pass-over-plane = Eine Überfahrt über eine Ebene aufzeichnen
record-pictures-instead = Beim Scannen Bilder aufzeichnen, oder die Kamera auf ein Profil je Puffer einstellen (Height = 1).
record-radians = In Radiant aufzeichnen
recording-cannot-read = die Aufzeichnung ist nicht lesbar: { $reason }
recording-cut-off = die Aufzeichnung ist unvollständig
recording-cut-off-after = { $path } ist nach { $bytes } von { $size } Bytes ({ $share }) abgeschnitten oder beschädigt; gelesen bis { $end } nach Beginn
recording-cut-off-before-first-message = { $path } ist nach { $bytes } von { $size } Bytes ({ $share }) abgeschnitten oder beschädigt, vor der ersten Nachricht
recording-cut-off-bytes-left = die Aufzeichnung ist unvollständig: { $size } von { $written } Bytes sind vorhanden
recording-damaged = die Aufzeichnung ist beschädigt
recording-empty = die Aufzeichnung ist leer
recording-has-joints =
    { $path } enthält { $count ->
        [one] { $count } Gelenk
       *[other] { $count } Gelenke
    }
recording-has-no-joints = { $path }: keine Messwerte eines Messarms
recording-has-poses = { $path } enthält Posen eines Arms
recording-kept = { $name }: Die Aufzeichnung ist erhalten.
recording-message-at = { $path } { $topic } bei { $stamp_ns } ns
recording-missing = die Aufzeichnung fehlt
recording-names-joints = in { $path } heißen die Gelenke { $names }
recording-no-file = die Aufzeichnung ist keine Datei
recording-stopped = die Aufzeichnung wurde abgebrochen
recordings = Aufzeichnungen
recordings-calibrations-journal-kept-there = Dort werden Aufzeichnungen, Kalibrierungen und das Journal gespeichert.
recordings-damaged =
    { $more ->
        [0] { CLAUSE($first) }.
       *[other] { CLAUSE($first) }, und { $more } weitere.
    }
recordings-not-of-one-plane = die Aufzeichnungen sind gegeneinander um bis zu { $angle } gedreht: Sie stammen nicht von einer Ebene, und ihre Spannweiten sind nicht aussagekräftig
records = Archiv
refining-camera-lens-laser-plane = Kamera, Objektiv und Laserebene werden verfeinert
reinstall-update-package = Das Paket neu installieren oder aktualisieren.
rejected-and-few-edges-show = { $text }, und nur { $shown } seiner sichtbaren Kanten sind im Bild zu sehen
remove = Link entfernen
remove-point = Punkt { $index } entfernen
remove-point-first-not-there = Zuerst Punkt { $index } entfernen: Er liegt nicht { $where }.
remove-then-touch-face-marked-drawing = Entfernen, dann die in der Zeichnung markierte Fläche antasten.
remove-touch-there-again = Entfernen und dort neu antasten.
remove-touch-there-again-rest = Entfernen und dort in Ruhe neu antasten.
remove-touch-there-again-rest-clear = Entfernen und dort neu antasten, in Ruhe und mit Abstand zur Kante.
removed-account = Konto entfernt
removed-point = Punkt entfernt
removed-kiosk-link = Kiosk-Link widerrufen
removed-logo = Logo der Berichte entfernt
rename = Umbenennen
renamed-scan = Scan umbenannt
repeat-first-point = Ab dem ersten Punkt wiederholen
repeat-start = Von vorn wiederholen
replay-points-shown =
    { $count ->
        [one] { $name }: { $count } Punkt angezeigt
       *[other] { $name }: { $count } Punkte angezeigt
    }
report-cannot-written = ein Bericht lässt sich nicht als „{ $suffix }“ schreiben
report-customer = Kunde
report-duration = Dauer
report-made-crenel-files-session-alone = Bericht von Crenel { $version }, ausschließlich aus den Dateien der Sitzung erstellt.
report-name = Name
report-number = Nummer
report-order = Auftrag
report-part = Teil
report-pictures = Bilder
report-point-uncertainty = Gescannter Punkt
report-scan = Scan
report-serial-number = Seriennummer
request-failed = die Anfrage ist fehlgeschlagen
request-understood = Die Anfrage ist ungültig: { $text }.
request-invalid = Die Anfrage ist ungültig
residuals-contacts-object = Residuen der Antastpunkte am Objekt
residuals-gauge = Residuen am Prüfnormal: { $name }
residuals-on-gauge = Residuen am Prüfnormal
residuals-image = Residuen in den Bildern
residuals-image-worst-poses = Residuen in den Bildern (die { $count } am schlechtesten passenden von { $used } Posen)
residuals-object = Residuen am Objekt
residuals-pose-picture = Residuen von Pose { $number } im Bild
restore-backup-or-start-over = Durch die letzte Sicherung ersetzen oder verschieben, um neu zu beginnen
restore-database-from = { $database } aus { $folder } wiederherstellen oder mit --data in einem anderen Ordner starten
restore-database-from-last-backup = { $database } aus der letzten Sicherung wiederherstellen oder mit --data in einem anderen Ordner starten
restore-file-source = Datei aus ihrer Quelle wiederherstellen
restore-picture-delete-row = Bild wiederherstellen oder Zeile löschen
restore-sessions-folder-backup = Ordner der Sitzung aus einer Sicherung wiederherstellen
restore-take-picture-again = Wiederherstellen oder das Bild neu aufnehmen
result = Ergebnis
the-result = das Ergebnis
result-cannot-traced-them = Das Ergebnis lässt sich nicht auf sie zurückführen.
result-rms = Ergebnis, rms
result-would-replace-file-made = das Ergebnis würde eine Datei überschreiben, aus der es berechnet wird
results = Ergebnisse
review = Beurteilen
review-calibration = Kalibrierung beurteilen
rewritten-by-another-program = sie wurde von einem anderen Programm neu geschrieben
right = rechts
right-end = Rechte Stirnseite
rigid-fit-given-points = eine starre Einpassung erhielt { $a } und { $b } Punkte
rigid-fit-given-points-one-line = eine starre Einpassung erhielt Punkte auf einer Geraden
rms-before-after-each-pair-scale = Effektivwerte (rms) vorher und nachher, jedes Paar in eigenem Maßstab.
robot-pictures-agree-boards-place-but = Roboter und Bilder stimmen in der Position der Tafel überein, in ihrer Neigung aber nur auf { $tilt } (eigene Drehungen des Roboters: { $turn }).
robots-poses = Posen des Roboters
role-and-name = { $role }: { $name }
rotations-differ = coordinates.csv: Die gemessenen Drehungen weichen typisch um { $angle } von denen des Arms ab
rotations-other-order-or-direction = sie haben eine andere Reihenfolge oder Richtung oder gehören zu anderen Posen
rotations-quaternion-has-length-1 = das Quaternion einer Drehung hat die Länge 1
row-feature = { $place }: feature { $feature }
row-file = { $place }: Datei { $file }
row-has-cells =
    { $path } Zeile { $line }: { $count ->
        [one] { $count } Zelle
       *[other] { $count } Zellen
    }
row-lighting = { $place }: lighting { $lighting }
row-place = { $path } Zeile { $line }
rows-copied-or-arm-not-moved = Zeilen wurden kopiert, oder der Messarm wurde nicht bewegt: Derselbe Punkt bringt zweimal nichts Neues
runs-steadily = Sie läuft gleichmäßig.
s-driver-failed = Treiber fehlgeschlagen ({ $title }): { $error }
s-stripe-spans-blocks =
    { $level ->
        [crest] Auf den Zinnenoberseiten überdeckt die Laserlinie { $span } von { $width } Breite des Zinnenkörpers.
       *[floor] Auf den Nutgründen überdeckt die Laserlinie { $span } von { $width } Breite des Zinnenkörpers.
    }
same-offset = Gerade überfahrene Ebene: Versatz
saturated = Übersteuert
save-8-16-bits = Mit 8 oder 16 Bit speichern.
save-as-png-tiff-or-jpeg = Als PNG, TIFF, BMP, PGM oder JPEG speichern
save-pages-apart = Jede Seite als eigene Datei speichern
save-commas-between-columns-point-numbers = Mit Komma als Spaltentrenner und Punkt als Dezimalzeichen speichern
save-utf-8 = Als UTF-8 speichern
saved-result = Ergebnis gespeichert
say-few-words-why-you-take = Den Grund der Übernahme kurz angeben
says-hello = Testnachricht von { $name }.
says-nothing-identification = { $folder } enthält keine Identifikation
scan = Scannen
scan-started-at = Scan { $started }
scan-added-to-record = { $name } hat jetzt { $count } Scans, { $points } Punkte
scan-again = Erneut scannen
scan-again-arm-camera-one-clock = Mit gemeinsamer Zeitbasis von Messarm und Kamera erneut scannen
scan-alone-then-merge = Scannen, ohne ihn fortzusetzen, und beide unter „Archiv“ zusammenführen: Jeder behält seine Kalibrierung
scan-can-made-again-recording-verification = Aus der Aufzeichnung lässt sich ein Scan neu berechnen und eine Verifizierung belegen.
scan-cannot-be-continued = { $name } lässt sich nicht fortsetzen
scan-cannot-start-now = Ein Scan kann jetzt nicht starten
scan-cloud = Punktwolke { $clouds } scannen
scan-complete = Vollständig
scan-covers-patches = der Scan { $name } deckt nur { $count } Flecken der Kugel ab
scan-cut-short = Dieser Scan wurde vorzeitig beendet: { CLAUSE($reason) }.
scan-does-start-less-than-0 = Ein Scan startet nicht mit weniger als 0,5 GB und stoppt bei 0,1 GB.
scan-ended-early = Vorzeitig beendet
scan-flat-plate-nearer-away-again = Eine ebene Platte scannen, mehrmals näher heran und wieder weg, dann den Zeitversatz bestimmen
scan-frames-lost =
    { $count ->
        [one] { $count } Bild ging verloren.
       *[other] { $count } Bilder gingen verloren.
    }
scan-frames-too-fast =
    { $count ->
        [one] { $count } Bild wurde zu schnell aufgenommen: Seine Punkte sind längs der Bewegung verwischt.
       *[other] { $count } Bilder wurden zu schnell aufgenommen: Ihre Punkte sind längs der Bewegung verwischt.
    }
scan-frames-without-points =
    { $count ->
        [one] { $count } Bild mit Linie ergab keine Punkte.
       *[other] { $count } Bilder mit Linie ergaben keine Punkte.
    }
scan-gap-again = Noch einmal scannen, was inzwischen überfahren wurde; den Rechner nicht einschlafen lassen.
scan-gauge = Prüfnormal scannen
scan-gauge-again = Prüfnormal erneut scannen
scan-gauge-chosen = Gewähltes Prüfnormal scannen
scan-gauge-chosen-nothing-beside = Nur das gewählte Prüfnormal scannen, nichts daneben
scan-gauge-nothing-beside = Nur das Prüfnormal scannen, nichts daneben.
scan-goes-when-back = Der Scan läuft weiter, sobald das Gerät wieder verbunden ist.
scan-has = ein Scan enthält { $joints_topic } und { $image_topic } oder { $stripe_topic }
scan-has-length-twice = mehr als ein Paar von Kugeln im Scan hat den Abstand { $length }; die beiden Kugeln dieser Länge einzeln scannen
scan-has-points =
    { $count ->
        [one] { $count } Punkt.
       *[other] { $count } Punkte.
    }
scan-incomplete = Unvollständig
scan-more-clouds = Weitere Punktwolken scannen
scan-more-sphere = Mehr von der Kugel scannen
scan-needs = ein Scan benötigt { $needed }
scan-needs-name = Ein Scan braucht einen Namen
scan-plate-in-strips = Die Platte noch einmal scannen, in Streifen nebeneinander
scan-and-probe-errors-in-common-not-shown = Scan und Taster verwenden denselben Messarm: Gemeinsame Abweichungen sind hier nicht zu erkennen.
scan-report = Scanbericht
scan-running-already = es läuft bereits ein Scan
scan-running-has-laser-stop-first = Ein Scan läuft und verwendet den Laser. Zuerst den Scan stoppen.
scan-shows-little-of-sphere = der Scan zeigt zu wenig von einer Kugel am Ende von { $length }: nötig sind mindestens { $points } Punkte aus { $frames } Bildern, auf einer Kappe von 25° oder mehr in jeder Richtung
scan-sphere-from-other-sides = scannen Sie sie von Seiten, die sich um 45° oder mehr unterscheiden
scan-stopped = Der Scan wurde abgebrochen: { $error }
scan-stopped-within-sentence = der Scan wurde abgebrochen
scan-was-suspended-nothing-recorded = Das Programm war während dieses Scans { $duration } lang angehalten und hat in dieser Zeit nichts aufgezeichnet.
scan-without-length =
    { $count ->
        [one] der Scan zeigt eine Kugel statt zweier im Abstand von { $length }
       *[other] von den { $count } Kugeln im Scan haben keine zwei den Abstand { $length }
    }
scan-would-be-twice = einer der Scans wäre doppelt darin
scanned-sphere-has-diameter = Die gescannte Kugel hat einen Durchmesser von { $diameter }
scanning = Scan läuft
scanning-cloud = Punktwolke { $number } wird gescannt
scans-are-merged = { $name }: zusammengeführt, { $points } Punkte
scans-cannot-be-merged = Die Scans lassen sich nicht zusammenführen
scans-need-a-calibration = calibration.json fehlt: Scans lassen sich nicht rekonstruieren
scans-of-several-arms = sie sind von verschiedenen Messarmen, jeder mit eigenem Koordinatensystem: { $arms }
scatter-coordinates-beyond-uncertainty = Streuung der Koordinaten über die angegebene Unsicherheit hinaus
scatter-grows-with-speed = je schneller sich der Sensor der Ebene nähert oder von ihr entfernt, desto weiter liegen seine Punkte daneben, bei jedem Zeitversatz: Der Zeitversatz schwankt, wie bei Paketen des Messarms, die verschieden spät oder zu mehreren auf einmal ankommen
scatter-points-rms = Streuung der Punkte (rms)
scatter-single-points-beyond-encoders = Streuung einzelner Punkte über die Winkelgeber hinaus
schema-error = Zeile { $line }: { $error }
schema-errors-more =
    { $count ->
        [one] und ein weiterer Fehler
       *[other] und { $count } weitere Fehler
    }
schema-fetch = { $name } nach { $folder } legen
schema-imports-missing = es bindet { $location } ein, und diese Datei fehlt; aus dem Netz wird nichts geladen
schema-is-none = das ist kein XML-Schema (XSD)
schema-is-of-xml = ein Schema prüft nur QIF und Kalibrierscheine
schema-leave-out = --format qif oder --format dcc verwenden oder --schema weglassen
schema-nothing-written = es wurde nichts geschrieben
schema-package-missing = die Prüfung benötigt das Paket lxml, das nicht installiert ist
schema-unusable = das Schema ist nicht verwendbar: { $error }
schema-not-complied-with = die Datei entspräche nicht { $schema }: { $errors }
screw-home-check-again-change-if = Fest einschrauben und erneut prüfen; bleibt es dabei, tauschen.
check-tip-again-holding-still = Erneut prüfen, an jedem Punkt in Ruhe.
screw-tip-home-clamp-sphere-check = Taster fest einschrauben, Kugel festspannen und erneut prüfen.
search-object-failed = Die Suche nach dem Objekt ist fehlgeschlagen
the-seat = die Pfanne
seat-moved-between = die Pfanne hat sich zwischendurch bewegt
seat-named = Pfanne { $name }
seat-needs-two-points = eine Pfanne braucht zwei Punkte oder mehr
seat-points-1-lie-apart = Pfanne { $name }: Die Punkte 1 bis { $split } und { $next } bis { $points } liegen { $gap } auseinander
seat-tip = Tastkugel einsetzen
seat-gives-way = Pfanne { $seat } ist lose: Der Taster streut darin um { $scatter }, in den anderen um höchstens { $expected }
seats = Pfannen
seats-held-out = Pfannen, kreuzvalidiert
seats-not-measured = { $count } Pfannen mit je { $points } Punkten sind nötig
seats-were-taken-another-arm = Die Pfannen wurden mit einem anderen Messarm aufgenommen.
second = { $text }, { $rate } je Sekunde
second-newest-old = { CLAUSE($text) }: { $rate } je Sekunde, der neueste Wert { $age } alt.
second-picture-pose = { $place }: ein zweites { $lighting }-Bild der Pose { $pose }
see-result = Ergebnis ansehen
seems-lie-where-certificate-puts = { $edge } liegt anscheinend { $off } neben der Lage laut Kalibrierschein
not-sharp-enough = „{ $name }“ ist für eine sichere Erkennung nicht scharf genug zu sehen
seen-than-against-diameters-given =
    { $sign ->
        [larger]
            { $label } erscheint gegenüber den angegebenen Durchmessern { $off } (± { $uncertainty }) größer als { $others ->
                [1] die andere
               *[other] die anderen
            }
       *[smaller]
            { $label } erscheint gegenüber den angegebenen Durchmessern { $off } (± { $uncertainty }) kleiner als { $others ->
                [1] die andere
               *[other] die anderen
            }
    }
not-visible-enough = „{ $name }“ ist für eine sichere Erkennung nicht gut genug zu sehen
send-support-bundle = Diagnosepaket senden
sends-nothing =
    { $device ->
        [arm] der Messarm sendet nichts
       *[sensor] der Sensor sendet nichts
    }
sensor = Der Sensor: { $text }
sensor-heading = Sensor
sensor-not-connected = der Sensor ist nicht verbunden
sensor-did-answer-laser-off = Der Sensor hat auf „Laser aus“ nicht geantwortet
sensor-does-not-switch = { $title } wechselt nicht zwischen Bildern und Linien
sensor-has-pixels = der Sensor hat { $width } × { $height } Pixel
sensor-lost-exposure-longer-than = der Sensor ist nicht mehr verbunden, oder seine Belichtung dauert länger
sensor-measures-away-arms-last-joint = Der Sensor misst { $away } vom letzten Gelenk des Messarms entfernt (Grenzwert { $farthest_mm }).
sensor-now-sends-pictures-pixels = der Sensor sendet jetzt Bilder mit { $size } Pixeln
sensor-only-went-one-way-delay = der Sensor wurde nur in eine Richtung bewegt; ein Zeitversatz sieht dann aus wie eine andere Lage der Ebene
sensor-reports-laser-other-state = der Sensor meldet den entgegengesetzten Zustand des Lasers
sensor-sends-pictures-alone = { $title } sendet nur Bilder
sensor-turned-most-between-poses-wanted = Der Sensor hat sich zwischen den Posen um höchstens { $turn } gedreht (Soll: mindestens { $alike_deg }), sodass sie kaum mehr bestimmen als eine einzige.
sensor-went = der Sensor bewegte sich mit { $speed }; { $known }
sensor-moved-along-plane-without-effect = der Sensor bewegte sich mit { $along } entlang der Ebene und mit { $across } quer dazu; entlang der Ebene ändert ein Zeitversatz nichts
sensors-image-has-pixels = das Bild des Sensors hat { $width } × { $height } Pixel
sensors-laser-cannot-switched-here = der Laser dieses Sensors lässt sich von hier nicht schalten
sent-nothing-opening-again = { $title }: Seit { $silence } keine Daten; das Gerät wird neu geöffnet
sentence = { CAPITAL(CLAUSE($text)) }.
serial-number = Seriennummer { $serial_number }
serial-number-charuco-squares-markers = { $serial_number }: ChArUco-Tafel, { $columns } × { $rows } Felder zu { $square }, { $dictionary }
serial-number-chessboard-inner-corners-squares = Seriennummer { $serial_number }, Schachbrett, { $columns } × { $rows } innere Ecken, Felder von { $square }
serial-number-joints-tip = Seriennummer { $serial_number }, { $joint_count } Gelenke, Tastkugel Ø { $diameter }
serial-number-merlons = Seriennummer { $serial_number }, { $merlon_count } Zinnen, { $size } × { $size2 } × { $size3 }
serial-number-pixels = Seriennummer { $serial_number }, { $width_px } × { $height_px } Pixel
serial-number-poses-no-tip = Seriennummer { $serial_number }, meldet Posen, keine Tastkugel
serial-number-poses-tip = Seriennummer { $serial_number }, meldet Posen, Tastkugel Ø { $diameter }
serial-port-use-another-program = Der serielle Anschluss { $url } wird von einem anderen Programm verwendet
server-failed-what-taken-before-kept = Auf dem Server ist ein Fehler aufgetreten; alles zuvor Aufgenommene bleibt erhalten.
session-cannot-read-set-aside = Die Sitzung { $session_id } ist nicht lesbar und wird beiseitegelegt: { $error }.
session-closed-start-new-one = Diese Sitzung ist abgeschlossen. Eine neue starten.
session-not-readable-with-change = die Sitzung wäre damit nicht mehr lesbar
session-has-no-picture = Diese Sitzung hat kein Bild { $name }.
session-has-no-pose = in dieser Sitzung gibt es keine Pose { $number }
session-went-meanwhile-nothing-done = Die Sitzung ist inzwischen weiter; es wurde nichts ausgeführt
sessions-arm-cannot-read = Die Armdatei der Sitzung ist nicht lesbar
sessions-gauge-arm-cannot-read-any = Prüfnormal- oder Armdatei der Sitzung ist nicht mehr lesbar
sessions-pictures-lie-inside-folder = die Bilder einer Sitzung liegen in ihrem Ordner
set = Satz { $name }
set-arm-counts-per-revolution-station = { "[" }arm] counts_per_revolution in station.toml angeben.
set-arms-specification-limit-where-next = Bei Beginn der nächsten Prüfung die Spezifikation des Messarms als Grenzwert festlegen.
set-aside = Ausschließen
set-calibration-aside-start-again-beginning = Diese Kalibrierung beiseitelegen und von vorn beginnen?
set-cloud-aside = Punktwolke ausgeschlossen
set-exposure-picture = Belichtung nach dem Bild eingestellt
set-exposure-stripe-bright-not-clipped = So belichten, dass die Laserlinie hell, aber nicht übersteuert ist.
set-limit = Grenzwert festgelegt
set-temperature = Temperaturen von Prüfkörper und Arm eingegeben
set-machines-clock-let-kept-time = Uhr des Rechners stellen und von einem Zeitserver führen lassen.
set-pose-aside = Pose ausgeschlossen
set-sensor-back-calibrate-again = Einstellungen des Sensors wiederherstellen oder neu kalibrieren
set-sensor-back-scan-again = Einstellungen des Sensors wiederherstellen und erneut scannen
set-sensor-rate-hz = { "[" }sensor] rate_hz angeben.
set-up = Einrichten
settings-are-lost = Die Einstellungen sind verloren: { $error }
shorten-exposure-or-darken-room = Kürzer belichten oder die Umgebung abdunkeln
not-to-be-used-findings-say-why = Sie sollte nicht verwendet werden: Die Befunde nennen den Grund.
show-more-block-crests-floors-front = Mehr vom Zinnenkörper ins Bild bringen: Zinnenoberseiten und Nutgründe, vorn und hinten.
picture-does-not-show-certificate-not-checked =
    { $detections ->
        [one] Im Bild nicht zu sehen: { $hidden }. Dort ist nicht geprüft, ob der Kalibrierschein stimmt.
       *[other] In den Bildern nicht zu sehen: { $hidden }. Dort ist nicht geprüft, ob der Kalibrierschein stimmt.
    }
shows-no-stripe = { $path } zeigt keine Laserlinie
shows-no-stripe-outside-mask = { $path } zeigt außerhalb der Maske keine Laserlinie
side-merlon =
    { $side ->
        [right] die rechte Seite der Zinne { $number }
       *[left] die linke Seite der Zinne { $number }
    }
side-of-block =
    { $side ->
        [back] die Rückseite des Zinnenkörpers
       *[front] die Vorderseite des Zinnenkörpers
    }
sign-ask-administrator-account = Anmelden oder den Administrator um ein Konto bitten
sign-browser-your-own = In einem eigenen Browser anmelden
sign-go = Anmelden und fortfahren
signatures = Unterschriften
signed = angemeldet
signed-out = abgemeldet
simulated-camera-is-lost = Die simulierte Kamera ist nicht mehr verbunden
simulated-sensor-is-not-open = Der simulierte Sensor ist nicht geöffnet
since-calibration = { $celsius }, { $change } seit der Kalibrierung.
size-expected = erwartet werden { $width } × { $height } Pixel
so-centre-known-k-1 = Standardunsicherheit des Mittelpunkts { $centre_sd }, k = 1
so-plane-known-k-1 = Standardunsicherheit der Ebene { $at } und { $arcsec }, k = 1
software = Software
software-part =
    { $part ->
        [system] System { $version }
        [machine] Rechner { $version }
        [processors] { $version } Prozessoren
        [arm] Messarm { $version }
        [sensor] Sensor { $version }
       *[other] { $part } { $version }
    }
solve-again = Neu berechnen.
compute-again = Neu berechnen
solving-camera = Kamera wird berechnet
some-points-off-their-face-remove = Einige Punkte liegen nicht auf ihrer Fläche. Diese entfernen, dann fortfahren.
somebody-must-able-give-people-access = jemand muss Zugänge vergeben können
somebody-publishes-what-no-station-does = Diese Nachrichten stammen nicht von einer Station und können Angezeigtes verdecken oder verfälschen.
something-changed-since-solved-solve-again = Seit der Berechnung hat sich etwas geändert. Neu berechnen.
sphere = Kugel
sphere-of-diameter = Kugel, { $diameter }
file-describes-sphere = { $path }: beschreibt eine Kugel
sphere-clamped = Die Kugel ist festgespannt
sphere-known-diameter-clamped-firmly-within = Eine Kugel mit bekanntem Durchmesser, gut erreichbar festgespannt.
sphere-known-to = Ø { $diameter }, Standardunsicherheit { $known } (k = 1)
sphere-named = Kugel { $name }
sphere-of-unknown-uncertainty = Ø { $diameter }, Unsicherheit nicht angegeben
sphere-not-touched-again = die Kugel wurde am Ende nicht noch einmal angetastet, sodass nicht bekannt ist, ob sie oder der Arm sich bewegt hat
sphere-or-arm-moved = Kugel oder Arm haben sich während der Prüfung um { $moved } bewegt; die Grenze ist { $limit }
sphere-too-small = die Kugel hat einen Durchmesser von { $diameter }; nötig sind mindestens { $least }
sphere-was-not-scanned = die Kugel wurde nicht gescannt
spheres = Kugeln
spheres-held-out = Kugeln, kreuzvalidiert
spheres-seen-against-their-diameters-tips = die Kugeln weichen um { $excess } (± { $uncertainty }) von ihren Durchmessern ab, bei einer Tastkugel von { $diameter }
spheres-seen-than-stated-tips-diameter =
    { $sign ->
        [larger] die Kugeln erscheinen { $excess } größer als angegeben: Der Durchmesser der Tastkugel könnte { $diameter } betragen
       *[smaller] die Kugeln erscheinen { $excess } kleiner als angegeben: Der Durchmesser der Tastkugel könnte { $diameter } betragen
    }
spheres-size-by-certificate-or-datasheet =
    { $sign ->
        [larger] laut Datenblatt des Messarms haben die Kugeln ihre angegebene Größe, nach der Länge dieses Kugelstabs wären sie { $excess } größer
       *[smaller] laut Datenblatt des Messarms haben die Kugeln ihre angegebene Größe, nach der Länge dieses Kugelstabs wären sie { $excess } kleiner
    }
spread-needs-least-two-clouds = für eine Spannweite sind mindestens zwei Punktwolken nötig
spread-points-hold-still-press-arms = { $place } { $wanted } Punkte verteilt aufnehmen: an jedem ruhig halten und die Taste am Messarm drücken.
spread-them-wide-clear-edges = Weit verteilen, mit Abstand zu den Kanten.
square-mm-too-small = { $field } muss mindestens { $least } betragen; ist der Wert in Metern angegeben?
squares-too-small-in-picture = ihre Felder sind im Bild nur { $width } breit; mindestens { $least } sind nötig
not-by-standard-one-seat = Nicht normgerecht: eine Pfanne und ein stetiger Schwenk statt der Positionen und Punkte nach ASME B89.4.22 oder ISO 10360-12. Ein Ergebnis nach diesen Normen wird nicht angegeben.
not-by-standard-other-positions = Nicht normgerecht: Positionen, Gelenkstellungen und Anzahlen nach ISO 10360-8 und ISO 10360-12 werden nicht genau eingehalten; daher wird keines ihrer Formelzeichen verwendet.
not-by-standard-other-touches = Nicht normgerecht: Die Antastpunkte sind nicht die der Kugelprüfungen nach ISO 10360-12; daher wird keines ihrer Formelzeichen verwendet.
standard-uncertainty-0-mm = Eine Standardunsicherheit beträgt 0 bis { $largest }.
standard-uncertainty-k-1-scanned-point = Standardunsicherheit (k = 1) eines gescannten Punkts über der Laserebene, von { $low } ({ $low_mm }) bis { $high } ({ $high_mm }). Durchgestrichen: extrapoliert, näher oder weiter als die kalibrierten { $near } bis { $far } von der Kamera.
standard-uncertainty-mm-too-large = { $field } darf höchstens { $most } betragen; ist der Wert in Mikrometern angegeben? Für einen Block, den niemand gemessen hat, stattdessen { $tolerance } angeben
start-again = Erneut starten
start-again-within-sentence = erneut starten
start-new-calibration = Neue Kalibrierung starten
started-scan = Scan gestartet
state-bayer = --bayer und --colour angeben (bei einem Ordner: bayer und laser_wavelength_nm in sensor.json; bei der Kamera einer Station: bayer und laser_colour)
state-first-id = falls dies die Tafel ist, in ihrer object.json first_id: { $first } angeben; sonst die Tafel mit den eigenen Nummern ins Bild bringen
state-laser-colour = laser_wavelength_nm im Datenblatt des Sensors angeben (crenel extract, crenel detect: --colour), oder Graubilder verwenden
state-legacy-pattern = falls dies die Tafel ist, in ihrer object.json legacy_pattern: { $legacy } angeben
state-rotation-in-arm-json = Nennen Sie die Steuerung als rotation in arm.json, etwa "rotation": "kuka"
state-squares = falls dies die Tafel ist, in ihrer object.json squares_x: { $columns } und squares_y: { $rows } angeben, wie auf der Tafel gezählt
state-squares-and-first-id = falls dies die Tafel ist, in ihrer object.json squares_x: { $columns }, squares_y: { $rows } und first_id: { $first } angeben, wie auf der Tafel gezählt
state-tip-uncertainty-or-unknown = tip_uncertainty_mm angeben, oder als Durchmesser unknown schreiben und eine Breite mit einem anderen Gerät ergänzen
state-uncertainty-in-mm = standard_uncertainty_mm in mm angeben, k = 1
not-stated = nicht angegeben
station-does-not-answer-to-name = Dieser Server ist unter dem Namen „{ $name }“ nicht erreichbar. Namen lassen sich mit hosts in { $file } ergänzen.
station-ended-during-scan = Die Station wurde während dieses Scans beendet.
station-has-administrator-already = Die Station hat bereits einen Administrator
station-has-several-sensors-not-changed-here = diese Station hat mehrere Sensoren, die hier nicht geändert werden
station-starting = Die Station startet.
station-toml-bayer-alone = station.toml, [sensor]: bayer braucht laser_colour: gemessen werden die Pixel dieser Farbe
station-toml-driver-has-no-option = station.toml, [{ $table }]: Der Treiber hat keine Option { $key }
station-toml-error-in-key = ihr Schlüssel { $key } hat einen Fehler
station-toml-error-in-line = sie hat einen Fehler in Zeile { $line }
station-toml-exposure-range-alone = station.toml, [sensor]: exposure_range_us erfordert exposure_us als Anfangswert
station-toml-gives-counts-per-revolution = station.toml gibt { $counts } counts_per_revolution an, der Messarm hat { $joints } Gelenke
station-toml-is-not-toml = sie ist kein gültiges TOML
station-toml-key-not-for-video = station.toml, [sensor]: { $key } ist bei einer Videodatei nicht zulässig
station-toml-no-such-driver = station.toml, [{ $table }]: Den Treiber { $name } gibt es nicht
station-toml-not-changed = { $file } wurde nicht geändert
station-toml-option-missing = station.toml, [{ $table }]: Die Option { $key } fehlt
station-toml-value-unusable = station.toml, [{ $table }]: { $key } = { $value } ist nicht verwendbar: { $reason }
station-uses = Die Station belegt { $process }.
station-uses-and-free = Die Station belegt { $process }; { $free } sind frei.
stations-disk-full = der Datenträger der Station ist voll
step-before-one = Das ist kein früherer Schritt.
step-cannot-be-read = sie lässt sich nicht als STEP lesen, oder nicht in 2 GB Speicher
step-export-again = Das Werkstück noch einmal als STEP (AP214 oder AP242) oder als STL exportieren
step-install-package = Installieren mit: { $command }; oder das Werkstück als STL exportieren
step-package-missing = STEP-Dateien brauchen das Paket cadquery-ocp-novtk, das nicht installiert ist
step-takes-too-long = sie braucht länger als { $most }, um zu Dreiecken zu werden
step-without-surface = sie hat keine Oberfläche
still = In Ruhe
still-lines-left-out = { $count } von { $frames } Bildern zeigen eine Linie, die stillstand: Von einer solchen Linie ergeben { $most } Bilder Punkte
still-running = { $title } läuft noch
still-turn = Noch zu drehen
stop-before-next = vor dem nächsten stoppen
stop-first = Zuerst stoppen
stop-simulation = Simulierten Bediener stoppen
stop-scan-first = zuerst den Scan stoppen
stop-server-give-one-data-folder = Den anderen Server beenden oder diesem mit --data einen eigenen Datenordner geben
stop-station-keep-copy-data-folder = Station beenden, eine Kopie des Datenordners aufbewahren und mit der letzten Sicherung starten.
stopped-by = { $name } hat in einem anderen Browser „Stopp“ gedrückt: Der Laser ist aus.
stopped-by-what-kept =
    { $scan ->
        [yes] Der laufende Scan ist beendet. Seine Punkte liegen im Archiv.
       *[no] Es lief kein Scan.
    }
stopped-demonstration = Vorführung angehalten
stopped-laser-off = Gestoppt: Der Laser ist aus.
stopped-scan = Scan gestoppt
stopped-simulation = simulierten Bediener gestoppt
store-check-access = Prüfen Sie die Schlüssel und die Rechte des Speichers
store-check-address = Hängen Sie den Datenträger ein, oder berichtigen Sie die Adresse
store-check-network = Prüfen Sie das Netz, den endpoint und ob der Server des Speichers läuft
store-make-room = Schaffen Sie dort Platz
stored-under-records-scan-or-calibrate-again = Sie ist in Gebrauch und liegt im Archiv. Die erste Schaltfläche ist der nächste Schritt; auch scannen lässt sich mit ihr sofort.
straight-above-chessboard-follow-dashed-outline = Senkrecht über dem Schachbrett beginnen: { $words }. Dem gestrichelten Umriss folgen.
straight-edges-do-not-form-block = seine { $segment_count } geraden Kanten ergeben keinen Zinnenkörper
stripe-about-laser-plane-rms-points =
    Laserlinie um die Laserebene, rms von { $points ->
        [one] { $points } Punkt
       *[other] { $points } Punkten
    }
stripe-axis = Richtung der Laserlinie „{ $axis }“
stripe-choice-is = die Auswahl der Laserlinie ist „{ $choice }“
stripe-extracted-grey-images-8-16 = eine Laserlinie wird aus Graubildern mit 8 bis 16 Bit extrahiert, Höhe mal Breite
stripe-maximum-width-is = die Höchstbreite der Laserlinie ist { $width }
stripe-minimum-width-is = die Mindestbreite der Laserlinie ist { $width }
stripe-one-level-alone-does-fix = eine Laserlinie auf nur einer Höhenstufe legt die Laserebene nicht fest
stripe-pieces-of =
    { $points ->
        [one] die Mindestlänge eines Teilstücks der Laserlinie ist { $points } Punkt
       *[other] die Mindestlänge eines Teilstücks der Laserlinie ist { $points } Punkte
    }
stripe-points-fit-one-laser-plane = { $points } Punkte der Laserlinie passen mit { $rms } rms zu einer Laserebene (Grenzwert { $stripe_rms_px }), { $share } der Punkte auf dem Objekt (Grenzwert { $agreeing }).
stripe-px = Laserlinie, px
stripe-smoothing-is = die Glättung der Laserlinie ist { $smoothing }
stripe-threshold-is = die Schwelle der Laserlinie ist { $threshold }
stripes-were-smoothed = Punkte bei der Aufnahme entlang der Laserlinie um { $smoothing } geglättet: Strukturen kürzer als { $half } behalten weniger als die halbe Höhe, benachbarte Punkte teilen ihr Rauschen
study-compares-several = eine Studie vergleicht mehrere
study-left-out = { $name }: { CLAUSE($reason) }.
study-plane = die Studie bezieht sich auf eine Ebene
support-bundle-being-made-already = Ein Diagnosepaket wird bereits erstellt
surface-not-curved = die Fläche ist nicht gekrümmt
swing = Schwenk
swing-about-middle-limit = Jeder Punkt des Schwenks relativ zur Mitte aller Punkte, im Koordinatensystem des Messarms. Gestrichelt: der Grenzwert von { $limit }.
swing-arm = Messarm schwenken
swing-arm-about = Messarm schwenken um: { $place }
swing-elbow-one-side-other-while = Den Ellbogen von einer Seite zur anderen schwenken, während die Tastkugel in der Pfanne bleibt
swing-further-least = Weiter schwenken: { $swing } von mindestens { $least_swing_deg }.
switch-arm-check-cable-port = Messarm einschalten; Kabel prüfen; ebenso, ob dies der richtige Anschluss ist.
switch-arm-off = Messarm aus- und wieder einschalten.
switch-arm-sensor-connect-them = Messarm und Sensor einschalten und anschließen.
switch-laser-look-where-lies = Laser einschalten, um zu sehen, wo die Linie liegt.
switch-off-aim-picture-switched-itself = Zum Ausrichten ausschalten. Für das Bild schaltet er automatisch.
switch-off-mirroring = das Spiegeln (horizontal oder vertikal) in den Einstellungen der Kamera ausschalten, oder im Programm, das das Bild gespeichert hat
switch-one-laser-off-or-cover-it = Einen Laser abschalten oder abdecken und die Bilder neu aufnehmen
switch-one-laser-off-or-mask-its-place = Einen Laser abschalten oder den Ort seiner Linie maskieren
switch-over-part = Laser über einem Teil einschalten
switch-stop-scan = Laser einschalten oder den Scan stoppen.
switch-to-raw-or-take-out-bayer = Die Kamera auf Rohbilder umstellen oder bayer entfernen
switched-laser = Laser eingeschaltet
switched-laser-off = Laser ausgeschaltet
table-first-line-names = { $path }: Die erste Zeile nennt { $names }
table-has-both = { $path } hat die Spalten { $first } und { $second }
table-is-empty = sie ist leer; erwartet wird eine Zeile mit Spaltennamen
table-is-workbook-or-no-text = dies ist die Datei einer Tabellenkalkulation oder kein Text
table-lacks-column = in ihrer Tabelle { $table } fehlt { $column }
take-model-over-in-form-of-arm = Es ist das Modell eines Messarms: „Neu: Messarm mit Gelenken“ wählen, dann „Modell aus Text, Datei oder Liste übernehmen“
take-a-picture-in-each-pose = In jeder Pose ein neues Bild aufnehmen und es einmal aufführen
take-again = Neu aufnehmen
repeat-it = neu aufnehmen
take-another = { $taken } Eine weitere aufnehmen: { $words }.
take-another-password = Ein anderes wählen
take-another-pose = Weitere Pose aufnehmen
take-back = Einbeziehen
take-bars-other-end-first-drop = Zuerst das andere Stabende aufnehmen oder das letzte verwerfen.
take-longer-one-three-unrelated-words = Ein längeres wählen; gut sind drei Wörter ohne Zusammenhang
take-longer-pass-five-seconds-more = Eine längere Überfahrt aufnehmen, mindestens fünf Sekunden
take-more-pictures-8-more-them = weitere Bilder aufnehmen, mindestens 8, um 20° und mehr geneigt
take-more-pictures-all-sides-have = Weitere Bilder von allen Seiten aufnehmen; das Armmodell neu identifizieren lassen.
take-more-pictures-all-sides-hold = Weitere Bilder von allen Seiten aufnehmen; den Messarm dabei in kompakter Haltung führen.
take-more-pictures-board-all-corners = Weitere Bilder aufnehmen, mit der Tafel in allen Ecken des Bildes.
take-more-pictures-each-turned-against = weitere Bilder aufnehmen, jedes gegenüber den anderen gedreht, oder das Objekt antasten
take-more-pictures-for-camera-and-mounting = Kamera und Anbau aus mehr Bildern kalibrieren.
take-more-pictures-lasers-line-flat = Weitere Bilder aufnehmen, mit der Laserlinie auf der Fläche der Tafel.
take-more-pictures-like-these = Weitere Bilder aufnehmen, nach allen Seiten geneigt: Insgesamt würden etwa { $asked } wie diese ausreichen. Erreicht der Roboter nicht mehr, die Grenzwerte nach dem Bedarf der Scans festlegen (--good-um, --usable-um).
take-more-pictures-robot-at-fault = Weitere Bilder aufnehmen, nach allen Seiten geneigt; bei so großen Abweichungen liegt es an der Genauigkeit des Roboters, oder seine Posen beschreiben nicht den Flansch im Koordinatensystem des Messarms. Erreicht der Roboter nicht mehr, die Grenzwerte nach dem Bedarf der Scans festlegen (--good-um, --usable-um).
take-more-pictures-tilted = Weitere Bilder aufnehmen, nach allen Seiten geneigt.
take-more-places-all-over-arms = Weitere Positionen aufnehmen, über die ganze Reichweite des Messarms verteilt
take-more-places-all-over-reach = Weitere Positionen über die ganze Reichweite aufnehmen und den Messarm an jeder von Seite zu Seite schwenken
take-more-points-more-places = Weitere Punkte an weiteren Positionen aufnehmen
take-more-poses-tilted-turned = Weitere Posen aufnehmen, geneigt und gedreht.
take-more-poses-tilted-turned-have = Weitere Posen aufnehmen, geneigt und gedreht; das Armmodell neu identifizieren lassen.
take-more-there-delete-rows = Dort weitere Punkte aufnehmen oder die Zeilen löschen
take-more-while-arm-swings = Weitere Punkte aufnehmen, während der Messarm schwenkt
take-one = Eine davon wählen: { $languages }
take-one-console-shows-since-stations = Den Code verwenden, den die Konsole seit dem letzten Start der Station anzeigt
take-one-place-two-if-there = An ein oder zwei Positionen einen Kugelstab messen, falls vorhanden.
take-out = { $key } entfernen.
take-out-label-face-touched = Punkt entfernen oder der angetasteten Fläche zuordnen
take-pass-again = Überfahrt neu aufnehmen
take-picture = Bild aufnehmen
take-picture-of-target =
    { $thing ->
        [board] ein Bild der Tafel aufnehmen
       *[object] ein Bild des Objekts aufnehmen
    }
take-picture-again = Dieses Bild neu aufnehmen
take-picture-object = Bild des Objekts aufnehmen
take-pictures-different-distances-tilted-different = Bilder aus verschiedenen Abständen aufnehmen oder nach verschiedenen Seiten geneigt
take-pictures-tilted-20-more-two = Bilder aufnehmen, die um 20° und mehr geneigt sind, nach zwei Seiten
take-pictures-turned-20-more-about = Bilder aufnehmen, die um 20° und mehr gedreht sind, um zwei verschiedene Achsen
take-place-again-delete-rows = Diese Position neu aufnehmen oder ihre Zeilen löschen
take-point = Punkt aufnehmen
take-points-or-delete-file = Punkte aufnehmen oder die Datei löschen
take-poses-tilted-left-right-front = Posen aufnehmen, die nach links, rechts, vorn und hinten geneigt und um die Blickrichtung gedreht sind.
take-these-points-again = Diese Punkte neu aufnehmen.
take-touch = Antastpunkt aufnehmen
take-with-laser-or-describe-line = Mit eingeschaltetem Laser und passender Belichtung aufnehmen oder angeben, wie die Linie aussieht (--threshold, --min-width, --max-width): Anderes im Bild hebt sich ebenso ab
taken = { $path } wurde mit { $device } { $recorded } aufgenommen
takes-notifications = { $host } nimmt Benachrichtigungen an.
taking-picture = Bild wird aufgenommen
tells-whoever-away-what-done-fault = Der Webhook benachrichtigt Abwesende über Fertiges, Störungen und Fälliges.
temperature = Temperatur
test-performance = Leistung prüfen
test-performance-again = Erneut prüfen
test-u = U der Prüfung, k = 2
test-value-uncertainty = Prüfwertunsicherheit
test-value-uncertainty-text = Erweiterte Unsicherheit von Normal und Aufbau, k = 2. Die Streuung von Arm und Sensor gehört nicht dazu: Die Prüfung misst sie.
text-is-no-datasheet = es ist kein Datenblatt als JSON und kein Kalibrierschein als XML
text-has-half-character = einer ihrer Texte enthält ein unvollständiges Zeichen
than-when-made-beyond-c-due =
    { $how ->
        [warmer] Es ist { $difference } wärmer als bei der Kalibrierung; bei mehr als { $limit } Unterschied ist sie fällig.
       *[colder] Es ist { $difference } kälter als bei der Kalibrierung; bei mehr als { $limit } Unterschied ist sie fällig.
    }
the-is-for =
    { $device ->
        [sensor] die Kalibrierung gilt für { $known }
       *[arm] die arm.json gilt für { $known }
    }
there-dirt-tip-sphere = Der Durchmesser der Tastkugel beträgt anscheinend { $diameter }, laut Datenblatt des Messarms { $expected }: Auf der Tastkugel oder der Kugel ist Schmutz.
there-no-account = Das Konto { $name } gibt es nicht.
there-no-address-yet = Es ist noch keine Adresse angegeben
there-no-calibration = Die Kalibrierung { $calibration_id } gibt es nicht.
there-no-calibration-use-calibrate-first = Es wird keine Kalibrierung verwendet. Zuerst kalibrieren.
there-no-calibration-use-yet = Es wird noch keine Kalibrierung verwendet.
there-no-check-arm = Die Armprüfung { $record_id } gibt es nicht.
there-no-check-tip = Die Tastkugelprüfung { $record_id } gibt es nicht.
there-no-command = Den Befehl „{ $name }“ gibt es nicht.
there-no-earlier-step = Einen früheren Schritt „{ $to }“ gibt es nicht.
there-no-face = Die Fläche „{ $face }“ gibt es nicht.
there-no-fitted-shape-yet = Es ist noch keine Form eingepasst
there-no-gauge-data-folder-yet = Es gibt noch kein Datenblatt eines Prüfnormals.
there-no-here =
    { $field ->
        [arm] Den Messarm „{ $chosen }“ gibt es hier nicht.
        [object] Das Objekt „{ $chosen }“ gibt es hier nicht.
       *[sensor] Den Sensor „{ $chosen }“ gibt es hier nicht.
    }
there-no-identification-arm = Die Identifikation des Messarms { $record_id } gibt es nicht.
there-no-language = die Sprache „{ $language }“ gibt es nicht
there-no-limit = { $title }: { $value }; kein Grenzwert.
there-no-map-cloud = Zu Punktwolke { $number } gibt es keine Karte.
there-no-performance = Es gibt keine Leistungsprüfung { $record_id }
there-no-picture-object-sensor-take = Es gibt noch kein Bild dieses Objekts mit diesem Sensor. Eines aufnehmen.
there-no-picture-yet-take-one = Es gibt noch kein Bild. Eines aufnehmen.
there-no-points-rectangle = Im Rechteck sind keine Punkte
there-no-scan = Den Scan { $scan_id } gibt es nicht.
there-no-scan-find-delay = Es gibt keinen Scan, aus dem sich der Zeitversatz bestimmen lässt
there-no-simulation-real-devices = Echte Geräte haben keinen simulierten Bediener.
no-simulation-of-real-devices = Echte Geräte haben keinen simulierten Bediener
there-no-sphere-diameter-cloud = In dieser Punktwolke gibt es keine Kugel mit { $diameter } Durchmesser
there-no-such-arm = Diesen Messarm gibt es nicht.
there-no-such-artefact-here = Diesen Prüfkörper gibt es hier nicht.
there-no-such-cloud = Diese Punktwolke gibt es nicht.
there-no-such-folder = der Ordner existiert nicht
there-no-such-gauge = Dieses Prüfnormal gibt es nicht.
there-no-such-page-3d-view = Diese Seite der 3D-Ansicht gibt es nicht.
there-no-such-touch = Diesen Antastpunkt gibt es nicht.
there-no-token = Den Token { $token_id } gibt es nicht.
there-no-valid-calibration = es gibt keine gültige Kalibrierung
there-no-verification = Die Verifizierung { $record_id } gibt es nicht.
there-no-kiosk-link = Den Kiosk-Link { $link_id } gibt es nicht.
there-none-yet = Es gibt noch keine Sicherung.
there-nothing = Unter { $path } gibt es nichts.
there-nothing-verify = Es gibt nichts zu verifizieren
thermometer-cannot-read = Das Thermometer { $path } lässt sich nicht auslesen: { $error }
thermometer-reads = Das Thermometer { $path } zeigt { $celsius }
these-files-what-result-made-accepted =
    { $changed ->
        [one] { $changed } dieser Dateien ist nicht mehr die, aus der das Ergebnis berechnet und mit der es angenommen wurde.
       *[other] { $changed } dieser Dateien sind nicht mehr die, aus denen das Ergebnis berechnet und mit denen es angenommen wurde.
    }
these-joint-angles-but-arm-json = dies sind Gelenkwinkel, aber laut arm.json meldet der Messarm Posen
these-metres-where-millimetres-expected = dies sind Meter; erwartet werden Millimeter
points-do-not-tell-better-than-tolerance = diese Punkte bestimmen ihn nicht genauer als die Fertigung
these-radians-where-degrees-expected = dies sind Radiant; erwartet werden Grad
these-use = Diese verwenden
these-use-and-pictures = Diese verwenden, dann bei jedem Halt ein Bild
they-cannot-show-whether-arm-better = sie können nicht zeigen, ob der Messarm anderswo genauer ist
they-come-more-than-one-camera = sie stammen von mehr als einer Kamera oder wurden skaliert
not-of-such-an-arm-or-tip-not-seated = sie stammen nicht von einem Messarm dieser Art, oder die Tastkugel saß nicht in der Pfanne
they-do-not-determine-camera = sie bestimmen die Kamera nicht
they-do-not-determine-centre = sie legen ihren Mittelpunkt nicht fest
they-do-not-lie-in-one-plane = sie liegen nicht in einer Ebene
they-fix-no-plane = sie legen keine Ebene fest
they-fix-no-sphere = sie legen keine Kugel fest
they-leave-nothing-over-check-parameters = damit bleibt kein Überschuss, um { $columns } Parameter zu prüfen
they-lie-almost-one-plane-almost = sie liegen fast in einer Ebene oder fast in einer Reihe je Höhenstufe
they-recording-but-gave-no-points = Sie sind in der Aufzeichnung, ergaben aber keine Punkte; Kabel des Messarms prüfen.
this-needs-pictures = hierfür wird ein Bild der Kamera benötigt
this-program = dieses Programm
thread-has-died = Vor { $ago } durch einen Fehler beendet: { $name } ({ CLAUSE($error) }).
tilt-back-by = { $angle } nach hinten neigen
tilt-board-less = die Tafel weniger gegen die Kamera neigen
tilt-front-by = { $angle } nach vorn neigen
tilt-left-by = { $angle } nach links neigen
tilt-level = Neigung gegen die Waagerechte
tilt-right-by = { $angle } nach rechts neigen
time-from-zero-to = eine Zeit liegt zwischen 0 und { $latest }
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
tip = Tastkugel
tip-says = Tastkugel: { $text }
tip-alone-never-shows-diameter = ein kleinerer Taster und ein größerer Block ergeben dieselben Messwerte
tip-bars-end = Die Tastkugel sitzt im Stabende
tip-check = Tastkugelprüfung
tip-diameter-not-shown = kein Messwert zeigt den Durchmesser des Tasters „{ $tool }“
tip-error-is-in-every-width = der Fehler des Durchmessers steckt in jeder Breite
tip-held-seat-moved-max-min = Die Tastkugel hat sich in einer Pfanne um { $worst } bewegt, (max − min)/2 auf der schlechtesten Achse.
tip-in-seat-moved-limit = Die Tastkugel hat sich in einer Pfanne um { $worst } bewegt, (max − min)/2 auf der schlechtesten Achse; der Grenzwert ist { $limit }.
tip-is-checked-in-a-seat = Um seine Spitze in einem Sitz gedreht, zeigt der Arm, ob die Spitze da ist, wo sein Modell sie hat.
tip-itself-was-not-measured = die Tastkugel selbst wurde nicht gemessen
tip-known = Unsicherheit der Tastkugel
tip-known-without-size = Über die Reichweite wich die Tastkugel um { $before } rms ab; die Standardunsicherheit beträgt jetzt { $after } (k = 1), ohne den Maßstab des Messarms.
tip-lies-within-mm = die Tastkugel liegt weniger als { $distance } davon entfernt
tip-missing-place-flange-diameter = { $tip } fehlt: Lage der Tastkugel am Flansch und ihr Durchmesser
tip-never-checked = Die Tastkugel wurde noch nie geprüft.
tip-off-place-arm = Abweichung der Tastkugel von ihrer Lage am Messarm
tip-over-whole-reach = Tastkugel über die ganze Reichweite
tip-rather-has = der Durchmesser der Tastkugel beträgt eher { $diameter }, oder die angegebenen Durchmesser gehören nicht zu diesen Kugeln
tip-rather-has-or-bar-wrong = der Durchmesser der Tastkugel beträgt eher { $diameter }, oder die angegebenen Durchmesser gehören nicht zu diesen Kugeln, oder die Länge eines Kugelstabs ist falsch
tip-rule-applies-to-error-alone = Die Regel gilt für die Durchmesserabweichung. Die Streuung wird unmittelbar mit ihrem Grenzwert verglichen.
tip-seat = Die Tastkugel sitzt in der Pfanne
tip-seat-no-points-taken-there = Die Tastkugel ist { $left } von der Pfanne entfernt; dort werden keine Punkte aufgenommen.
tip-not-seated-or-seat-loose = die Tastkugel saß nicht, die Pfanne war locker, oder Punkte einer anderen Position sind darunter
tip-sits-off-its-place = Die Tastkugel sitzt { $off } neben ihrer Lage laut Datenblatt: Der Schaft ist verbogen oder nicht fest eingeschraubt.
tip-sound-diameter-off-touches-agree = Die Tastkugel ist in Ordnung: Ihr Durchmesser weicht um { $off } ab, ihre Antastpunkte stimmen auf { $scatter } überein.
tip-sphere-diameter-arm = der Tastkugel von einer Kugel dieses Durchmessers, mit dem bisherigen Armmodell
tip-uncertainty-before =
    { $size_known ->
        [yes] war { $before }; k = 1, rms über die Reichweite
       *[no] war { $before }; k = 1, rms über die Reichweite; ohne den Maßstab des Messarms
    }
tips-coordinates-moved-instead = stattdessen werden die Koordinaten der Tastkugel geändert
tips-diameter = Tastkugeldurchmesser
tips-diameter-has-no-uncertainty = { $place }: der Tasterdurchmesser hat keine Unsicherheit
tips-diameter-how-well-touches-agree = Durchmesser der Tastkugel und Übereinstimmung ihrer Antastpunkte.
tips-diameter-off-known-only-k = Der Durchmesser der Tastkugel weicht um { $off } ab; die erweiterte Unsicherheit von { $known } (k = 2) ist zu groß, um die Einhaltung des Grenzwerts nachzuweisen.
tips-places = Positionen der Tastkugel
tips-places-about-their-middle = Positionen der Tastkugel relativ zu ihrer Mitte
title-performance-test = Leistungsprüfung
titled-text = { $title }: { $text }
tls-give-own-key = Das Zertifikat mit seiner Kette und den dazugehörigen Schlüssel angeben
tls-give-plain-key = Den Schlüssel ohne Passwort angeben, lesbar nur für die Station
tls-key-encrypted-nobody-to-ask = er ist verschlüsselt, und niemand ist da, der sein Passwort eingibt
tls-key-unusable = { $file } lässt sich nicht verwenden
tls-no-pair = sie sind kein Zertifikat mit seinem Schlüssel im PEM-Format
tls-no-pair-reason = sie sind kein Zertifikat mit seinem Schlüssel im PEM-Format ({ $reason })
tls-pair-unusable = { $certificate } und { $key } lassen sich nicht verwenden
to = Bis
to-calibration = Behält Kamera und Anbau von { $name }. Die Tafel darf anders liegen.
together = Gesamt
tolerance-mm-out-of-range = { $field } muss größer als 0 und höchstens { $most } sein; einen gröber gefertigten Block messen und aus den Messwerten sein Zertifikat erstellen
too-bright-saturated = Zu hell: { $share } übersteuert
too-dark-brightest-parts = Zu dunkel: hellste Stellen bei { $level }
too-fast-blur-limit = Zu schnell: { $blur } Unschärfe; der Grenzwert ist { $limit }
too-few-edges-could-measured = zu wenige seiner Kanten ließen sich messen
too-few-markers = { $field }: die Tafel hat { $count } Markierungen, { $dictionary } aber nur { $known }
too-few-places-were-touched = zu wenige Positionen wurden angetastet: { $count }
too-little-arm-data-yet = Noch zu wenig Daten vom Messarm
too-many-wrong-tries = Zu viele Fehlversuche.
took-a-device-out = entfernte ein Gerät
took-cloud-back = Punktwolke wieder einbezogen
took-control-over = Bedienung übernommen
took-coordinates = hat Koordinaten eines Lasertrackers übernommen
took-last-one-back = letzte Eingabe zurückgenommen
took-over-control = { $name } hat die Bedienung von { $holder } übernommen: { $reason }
took-picture = Bild aufgenommen
took-picture-again = Bild neu aufgenommen
took-picture-bundle = Bild für den Support gespeichert
took-point = Punkt aufgenommen
took-pose-back = Pose wieder einbezogen
took-support-bundle = Diagnosepaket gespeichert
tool-found = { $value }, Standardunsicherheit { $known } (k = 1)
tool-of-reading = Gerät
tool-zero-or-diameter = Nullfehler oder Tasterdurchmesser, { $tool }
top-all-around-side-wrist-turned = Oben und ringsum an der Seite, mit jedes Mal anders gedrehtem Handgelenk. An jeder Stelle ruhig halten und die Taste am Messarm drücken.
topic-holds = { $path }: { $topic } enthält { $schema } ({ $encoding })
total-k-1 = { $total } (k = 1)
touch = Antasten
touch-place = { $place } antasten
touch-heading = Antasten
touch-again-beside-these = Auf jeder ihrer Flächen zwei weitere Stellen antasten.
touch-all-over-upper-half-every = Die ganze obere Hälfte von allen Seiten antasten, mit dem Messarm in vielen Haltungen. An jedem Punkt ruhig halten und die Taste am Messarm drücken.
touch-back-face = Rückseite antasten.
touch-elsewhere = An anderer Stelle antasten
touch-face-also-beside-line =
    { $face ->
        [crest] Die Zinnenoberseiten auch neben dieser Geraden antasten
        [floor] Die Nutgründe auch neben dieser Geraden antasten
        [front] Die Vorderseite auch neben dieser Geraden antasten
        [back] Die Rückseite auch neben dieser Geraden antasten
        [left] Die linke Stirnseite auch neben dieser Geraden antasten
        [right] Die rechte Stirnseite auch neben dieser Geraden antasten
       *[other] Die Fläche „{ $face }“ auch neben dieser Geraden antasten
    }
touch-floors-grooves = Nutgründe antasten.
touch-front-back-left-right-face = Vorder- und Rückseite oder linke und rechte Stirnseite antasten.
touch-front-face = Vorderseite antasten.
touch-gauge = Prüfnormal antasten
contact-point-on-gauge = Antastpunkt { $counted } am Prüfnormal.
touch-gauge-more-places-scan-more = Prüfnormal an mehr Stellen antasten und langsamer scannen.
touch-in-another-posture = So genommene Punkte sind schlechter: Nehmen Sie eine andere Stellung, oder versetzen Sie das Objekt
touch-in-row = Antastung in Zeile { $line } ({ $face })
touch-left-end = Linke Stirnseite antasten.
touch-lies-beside-face = { $place }: die Antastung liegt { $off } neben { $face }
touch-lies-on-face = sie liegt auf { $face }
touch-lies-on-no-face = sie liegt auf keiner anderen Fläche oder auf mehreren
touch-more-contacts = Antasten: { $contacts }
touch-more-least-places = Weiter antasten: { $taken } von mindestens { $touches_needed } Stellen.
touch-more-least-points = Weiter antasten: { $taken } von mindestens { $least } Punkten.
touch-more-places = An mehr Stellen antasten
touch-more-points-spread-wide-over = Weitere Punkte antasten, weit über die Tafel verteilt.
touch-more-points-on-all-faces = Weitere Punkte antasten, weit über alle sechs Flächen verteilt.
touch-more-sphere = Mehr von der Kugel antasten
touch-near-corners-too = Auch nahe den Ecken antasten
touch-object = Objekt antasten
touch-object-or-remove-wrong = Das Objekt antasten, oder Punkt { $number } entfernen, wenn der falsch ist
touch-off-plane = Diese Antastung liegt { $off } neben der Ebene, die vorher angetastet wurde; sie wurde nicht übernommen
touch-opposite-faces-tilt-more = Gegenüberliegende Flächen antasten (links und rechts, vorn und hinten, Kronen und Böden) und den Sensor zwischen den Posen stärker neigen
touch-printed-side-more-times-spread = Die bedruckte Seite noch { $left }-mal antasten, weit verteilt. Oder fortfahren.
touch-printed-side-once-more-far = Die bedruckte Seite noch einmal antasten, weit weg von den anderen Punkten. Oder fortfahren.
touch-probe-press-arms-button-each =
    { $shape ->
        [plane] Mit dem Taster nahe den Ecken und in der Mitte antasten und an jeder Stelle die Taste am Messarm drücken.
       *[sphere] Mit dem Taster oben und ringsum an der Seite antasten und an jeder Stelle die Taste am Messarm drücken.
    }
touch-right-end = Rechte Stirnseite antasten.
touch-same-plane = Dieselbe Fläche antasten, oder ihre Antastungen zurücknehmen und neu beginnen
touch-scan-gauge-takes-two-minutes = { $text } Ein Prüfnormal antasten und scannen: Das dauert zwei Minuten.
touch-sphere = Kugel antasten
touch-sphere-more-spread-over-all = Kugel weiter antasten, über die ganze obere Hälfte verteilt.
touch-top-all-around-side = Oben und ringsum an der Seite antasten
touch-tops-merlons = Zinnenoberseiten antasten.
touch-two-faces-of-two-axes = nötig sind Antastungen auf je zwei Flächen von zwei Achsen, etwa alle Kanten, front und back
touched-centres-of-position = Durch Antasten, Position { $position }
touched-places-of-position = Angetastete Kugel, Position { $position }
touched-sphere-seems-to-have-diameter = Die angetastete Kugel hat anscheinend einen Durchmesser von { $radius }, laut Kalibrierschein { $radius2 }.
touches = { $done } von { $of } Antastpunkten
contact-points-label = Antastpunkte
contact-points-heading = Antastpunkte
touches-about-sphere-limit = Abstand jedes Antastpunkts von der Ausgleichskugel. Gestrichelt: der Grenzwert von { $limit }.
touches-agree = Übereinstimmung der Antastpunkte
tip-points-off-sphere-of-others =
    { $count ->
        [one] Punkt { $points } liegt { $scatter } neben der Kugel der übrigen.
       *[other] Die Punkte { $points } liegen bis zu { $scatter } neben der Kugel der übrigen.
    }
touches-agree-if-exchanged = alle Antastungen passen zusammen, wenn die Namen von { $one } und { $other } getauscht werden
touches-agree-in-unit = { $place } und die folgenden: die Antastungen passen zur Zeichnung, wenn sie in { $unit } sind
touches-are-joint-angles = { $path } hat die Gelenkwinkel eines Arms
touches-are-mirror-image = die Antastungen gehören zum Spiegelbild des Blocks
touches-disagree-up-tip-sphere-loose = Die Antastpunkte weichen um bis zu { $scatter } voneinander ab: Tastkugel oder Kugel ist locker, oder der Messarm ist gerutscht.
touches-do-not-show-place = die Antastungen zeigen nicht, wo der Block steht
touches-enough = { $done } Antastpunkte reichen aus
touches-lie-too-near-together-one = Die Antastpunkte liegen zu nah beieinander oder auf einem Ring um die Kugel
touches-lie-within-one-line = Die Antastpunkte liegen innerhalb von { $width } um eine Gerade
touches-miss-places = keine Antastung liegt nahe den Stellen { $places } der Kugel
touches-missing-of-pattern = nur { $count } der { $needed } Antastungen wurden genommen
touches-of-face = Antastungen
touches-on-face = { $count } { $where }
touches-over-all-faces = { $total } weitere auf allen Flächen, davon { $most } { $where },
touches-rms-known-k-1 = { $touches } Antastpunkte, { $rms } rms, Standardunsicherheit { $known } (k = 1)
touches-scatter-more = Die Antastungen streuen { $times }-mal so stark wie angegeben; die Unsicherheiten jeder für sich sind um diesen Faktor größer.
touches-would-bring =
    { $total ->
        [one] Standardunsicherheit des Objekts: { $now } (k = 1); { $words } ergibt { $then }.
       *[other] Standardunsicherheit des Objekts: { $now } (k = 1); { $words } ergeben { $then }.
    }
touches-would-not-reach =
    { $total ->
        [one] Standardunsicherheit des Objekts: { $now } (k = 1); { $words } ergibt { $then }, Soll { $target }.
       *[other] Standardunsicherheit des Objekts: { $now } (k = 1); { $words } ergeben { $then }, Soll { $target }.
    }
trial-nobody-looked = Geschlossen, weil niemand mehr zusah
trial-takes-too-long = Nach { $limit } geschlossen
trial-was-ended = Das Gerät wurde geschlossen
tried-a-device = probierte ein Gerät aus
tried-notifications = Benachrichtigungen getestet
trigger-camera-otherwise = Schließen Sie einen Messarm mit Auslöseausgang an, oder lassen Sie die Kamera frei laufen.
try-again = Erneut versuchen
try-again-ask-administrator-new-password = Erneut versuchen oder einen Administrator um ein neues Passwort bitten
try-again-if-happens-again-stations = Erneut versuchen. Tritt der Fehler wieder auf, steht Näheres im Protokoll der Station.
try-again-moment = Gleich noch einmal versuchen
turn-anticlockwise-by = { $angle } gegen den Uhrzeigersinn drehen
turn-clockwise-by = { $angle } im Uhrzeigersinn drehen
turn-down-exposure-until-objects-faces = kürzer belichten, bis die Flächen des Objekts nicht mehr überbelichtet sind
turn-fault-switch-camera-lost-off = Der Fehlerschalter camera_faults.lost ist eingeschaltet; ausschalten.
turn-lamp-until-all-edges-block = Lampe drehen, bis alle Kanten des Zinnenkörpers zu sehen sind, und ein weiteres Bild aufnehmen.
turn-off-cameras-mirroring-turn-object = Spiegelung der Kamera ausschalten oder das Objekt so drehen, dass seine Vorderseite zur Kamera zeigt
turn-sensor-so-laser-falls-onto = Sensor so drehen, dass der Laser von oben auf die Tafel fällt
turn-up-light-exposure = mehr beleuchten oder länger belichten
turn-up-light-exposure-look-object = mehr beleuchten oder länger belichten und den Sensor auf das Objekt richten
two-lines-in-pictures = in { $two } von { $of } Bildern sind zwei Laserlinien, und die Punkte können zwischen ihnen springen. Einen Laser abschalten, ihn maskieren (--mask) oder in jeder Spalte einen von beiden nehmen (--choice first oder last)
two-lines-in-the-pictures-of-poses = in den Bildern der Posen { $poses } sind zwei Laserlinien
two-lines-in-this-picture = In diesem Bild sind zwei Laserlinien.
two-reasons = { $first } und { $second }
two-boards-in-picture = zwei Tafeln mit { $columns } × { $rows } inneren Ecken sind im Bild
two-pictures-named = zwei Bilder heißen { $name } und wären eine Datei in { $folder }
two-s-of-distances = 2 s dieser Abstände
two-seats-or-seat-carried = sie gehören zu zwei Pfannen, oder die Pfanne wurde zwischendurch versetzt
two-seats-or-seat-carried-or-arm = sie gehören zu zwei Pfannen, oder die Pfanne wurde zwischendurch versetzt, oder arm.json gehört nicht zu diesem Messarm: Auch in anderen Pfannen wandert die Tastkugel { $far }
two-units-of-length = Die Tabelle nennt zwei Einheiten der Länge: { $units }
u-v = es ist „u“ oder „v“
udp-port-cannot-be-opened = Der UDP-Port { $port } dieses Rechners lässt sich nicht öffnen: { $reason }
udp-port-in-use = Ein anderes Programm auf diesem Rechner empfängt am UDP-Port { $port }
uncertainties-above-largest = { $field } braucht daneben { $one }, den größten dieser Werte
uncertainties-of-edges-count = { $field } hat { $found } Kanten, der Block hat { $wanted }
uncertainty-above-zero-up-to = erwartet wird eine Unsicherheit in mm über 0 und bis { $most }
uncertainty-budgets = Unsicherheitsbudgets
uncertainty-is-not-the-root-of-its-budget = expanded_uncertainty ist nicht das Doppelte der Wurzel der Quadratsumme seines Budgets
uncertainty-is-root-of-parts = U ist die Wurzel der Quadratsumme seiner Anteile, alle mit k = 2. Prüfnormal: U der Prüfung. Taster: aus den Antastpunkten. Punkte: aus der Streuung der Punkte einer Punktwolke. Punktwolken: aus deren Streuung. Mittelwert, Standardabweichung und Spannweite sind die der Punktwolken.
unattended-stop = Scan und Laser wurden gestoppt: { $limit } lang hatte niemand die Bedienung, und der Messarm stand still.
unattended-stop-remedy = Was aufgenommen wurde, bleibt. Um fortzufahren, neu starten; die Zeit steht in den Einstellungen.
uncertainty-missing = { $file }: uncertainty fehlt
uncertainty-or-tolerance = genau eines von { $one } und { $tolerance } ist nötig: das erste, wenn der Block gemessen wurde, das zweite, wenn nur seine Zeichnung bekannt ist
uncertainty-over-measuring-volume = Unsicherheit im Messvolumen
uncertainty-scanned-point-k-1 = Unsicherheit eines gescannten Punkts (k = 1)
uncertainty-scanned-point-so-far-k = Bisherige Unsicherheit eines gescannten Punkts (k = 1)
uncertainty-seen-point-k-1 = Unsicherheit eines gesehenen Punkts (k = 1)
uncover-board-light-evenly = die ganze Tafel aufdecken, die Kamera scharf stellen und die Tafel gleichmäßig beleuchten
uncover-board-or-give-its-certificate = die ganze Tafel freilegen und gleichmäßig beleuchten; hat die Tafel nicht mehr Ecken, ihren eigenen Kalibrierschein angeben
uncover-or-bring-more-of-board = die Tafel aufdecken und mehr von ihr ins Bild bringen, scharf und gleichmäßig beleuchtet
undecided = Nicht entschieden
undid-a-cut = weggeschnittene Punkte zurückgeholt
undo = Zurücknehmen
undo-last-point = Letzten Punkt zurücknehmen
uninstall-one-them = Eines davon deinstallieren.
unit = Einheit
up-poses = { $done } von bis zu { $of } Posen
up-to-taken-one = bis { $rms } sind zulässig
update-program-arms-firmware = Dieses Programm oder die Firmware des Messarms aktualisieren.
upper-left-square-black = das obere linke Feld der Tafel im Bild ist schwarz
upper-left-square-white = das obere linke Feld der Tafel im Bild ist weiß
upright-edge-of-merlon =
    { $end ->
        [back]
            die hintere senkrechte Kante { $side ->
                [right] rechts
               *[left] links
            } an Zinne { $number }
       *[front]
            die vordere senkrechte Kante { $side ->
                [right] rechts
               *[left] links
            } an Zinne { $number }
    }
ur-arm-off = Die Gelenke des Roboters unter { $address } sind ohne Strom; ihre Winkel werden nicht gemessen
ur-has-not = Der Roboter unter { $address } bietet { $names } nicht an
ur-keep-tool = Während einer Sitzung dasselbe aktive Werkzeug verwenden. Die Verbindung öffnet sich von selbst wieder; danach den letzten Schritt wiederholen.
ur-no-answer = Der Roboter unter { $address } nimmt die Verbindung an, antwortet aber nicht wie RTDE
ur-no-rtde = Was von { $address } kommt, ist kein RTDE ({ $reason })
ur-nominal-only = Der Text hat keine Werkskalibrierung: Die Zeilen delta_theta, delta_a, delta_d und delta_alpha stehen in calibration.conf.
ur-not-calibrated = Nach eigener Angabe der Datei wurde der Arm nicht kalibriert (calibration_status = 0)
ur-rate-too-high = Der Roboter unter { $address } sendet höchstens mit { $fastest }, station.toml nennt aber { $rate }
ur-does-not-speak-rtde-2 = Der Roboter unter { $address } spricht Version 2 von RTDE nicht
ur-refuses-start = Der Roboter unter { $address } weigert sich, Daten zu senden
ur-row-malformed =
    { $there ->
        [yes] Die Zeile { $name } ist beschädigt
       *[no] Die Zeile { $name } fehlt
    }
ur-six-numbers = erwartet werden sechs Zahlen in Klammern je Zeile
ur-switch-on = Den Roboterarm am Handbediengerät einschalten.
ur-tool-changed = Das aktive Werkzeug (TCP) des Roboters unter { $address } wurde gewechselt
ur-update-polyscope = PolyScope, die Software des Roboters, mindestens auf 3.12 (CB3) oder 5.5.1 (e-Series) aktualisieren; mit älterer Software report = "joints" verwenden.
urdf-axis-is-zero = Gelenk { $name }: Seine Achse hat keine Richtung
urdf-branches = Bei Glied { $link } verzweigt sich der Roboter: { $links }
urdf-chain-too-long = Zu Glied { $end } führen { $joints } Drehgelenke: Ein Arm hat fünf bis sieben
urdf-chain-too-short =
    { $joints ->
        [0] Kein Glied des Roboters folgt auf ein Drehgelenk
       *[other] Kein Glied des Roboters folgt auf fünf Drehgelenke: Es sind höchstens { $joints }
    }
urdf-circle = Die Glieder vor { $link } folgen im Kreis aufeinander
urdf-continuous = Endlos drehende Gelenke (continuous) haben die Grenzen ±360°.
urdf-first-link = es ist das erste Glied vor den Gelenken des Arms
urdf-flange = dem Namen nach sitzt dort ein Werkzeug
urdf-has-metres = Geben Sie die Längen eines URDF in Metern an
urdf-is-xacro = Der Text ist ein xacro, aus dem ein URDF entsteht
urdf-joint-cannot-be-used = Gelenk { $joint } zwischen { $base } und { $end } lässt sich nicht verwenden
urdf-joint-follows-not-reported = es folgt Gelenk { $other } (mimic), der Arm meldet seinen Winkel also nicht
urdf-joint-kind =
    { $kind ->
        [prismatic] es schiebt (prismatic)
       *[other] seine Art ist { $kind }
    }
urdf-kinds = der Roboter hat diese Gelenke: { $kinds }
urdf-meshes =
    { $count ->
        [one] Die Datei nennt ein Netz (mesh): Es wird nicht gebraucht und nicht gelesen.
       *[other] Die Datei nennt { $count } Netze (mesh): Sie werden nicht gebraucht und nicht gelesen.
    }
urdf-numbers = Gelenk { $joint }: { $name } ist { $text }
urdf-numbers-expected =
    { $count ->
        [one] erwartet wird eine Zahl
       *[other] erwartet werden { $count } Zahlen, durch Leerzeichen getrennt
    }
urdf-only-end = dort endet der Roboter
urdf-without-joints = Das URDF hat kein Gelenk
not-usable-because = Nicht brauchbar: { $fault }
not-usable = Nicht brauchbar
usable-attention = Brauchbar, mit Vorbehalt
usable-edge-stripe-points = { $found } brauchbare Kanten- und Laserpunkte
usable-edge-stripe-points-poses = { $found } brauchbare Kanten- und Laserpunkte in { $views } Posen
usable-most = { $total }; der Grenzwert für „brauchbar“ ist { $usable }.
use = In Verwendung
in-use-named = { $name } wird jetzt verwendet.
use-a-chessboard-or-leave-out-the-option = Schachbrett verwenden oder die Option weglassen
use-arm-before-what-identified-kept = Den vorherigen Messarm verwenden? Das Ergebnis der Identifikation bleibt in dieser Sitzung erhalten.
use-arm-now = Diesen Messarm ab jetzt verwenden
use-block-better-certificate = Einen Zinnenkörper mit besserem Kalibrierschein verwenden.
use-board-even-odd-count-inner = eine Tafel verwenden, deren Anzahl innerer Ecken in einer Richtung gerade und in der anderen ungerade ist
use-full-pictures-one-sensor = vollständige Bilder eines einzigen Sensors verwenden
use-full-pictures-one-sensor-neither = vollständige Bilder eines einzigen Sensors verwenden, weder beschnitten noch skaliert
use-method-joint = --method joint verwenden
use-method-joint-pictures-board-several = --method joint verwenden, mit Bildern der Tafel von mehreren Seiten
use-object-higher-step-show-crests = ein Objekt mit höherer Stufe verwenden und Zinnenoberseiten und Nutgründe, vorn und hinten, ins Bild bringen
use-object-whose-merlons-differ-width = ein Objekt verwenden, dessen Zinnen verschieden breit sind
use-shorter-cable-port-own-close = Ein kürzeres Kabel und einen eigenen Anschluss verwenden; andere Programme auf diesem Rechner schließen.
use-switch-sensor = den Schalter am Sensor verwenden
do-not-use = Nicht verwenden
used-but = Verwendet, aber { $reason }
used-but-within-sentence = verwendet, aber { $reason }
user-may-not-open-serial-port = Dieser Benutzer darf den seriellen Anschluss { $url } nicht öffnen, oder ein anderes Programm hat ihn offen
value = Wert
value-empty = der Wert ist leer
value-expected-between = erwartet wird ein Wert von 0 bis { $largest }
value-missing = der Wert fehlt
value-must-be = der Wert muss { $expected } sein
value-must-be-at-least = der Wert muss mindestens { $limit } sein
value-must-be-at-most = der Wert darf höchstens { $limit } sein
value-must-be-date = der Wert muss ein Datum der Jahre 1 bis 9999 sein
value-must-be-finite = der Wert muss eine endliche Zahl sein
value-must-be-greater = der Wert muss größer als { $limit } sein
value-must-be-iso-date = der Wert muss ein Datum wie 2026-03-31 sein
value-must-be-less = der Wert muss kleiner als { $limit } sein
value-must-be-list = der Wert muss eine Liste sein
value-must-be-number = der Wert muss eine Zahl sein
value-must-be-object = der Wert muss ein Objekt mit Feldern sein
value-must-be-one-of = der Wert muss einer von { $expected } sein
value-must-be-text = der Wert muss ein Text sein
value-must-be-true-or-false = der Wert muss true oder false sein
value-must-be-whole-number = der Wert muss eine ganze Zahl sein
value-must-match-pattern = der Text muss dem Muster { $pattern } entsprechen
value-not-known = dieses Feld ist nicht bekannt
value-too-long-list =
    { $count ->
        [one] die Liste darf höchstens { $count } Eintrag haben
       *[other] die Liste darf höchstens { $count } Einträge haben
    }
value-too-long-text = der Text darf höchstens { $count } Zeichen haben
value-too-short-list =
    { $count ->
        [one] die Liste muss mindestens { $count } Eintrag haben
       *[other] die Liste muss mindestens { $count } Einträge haben
    }
value-too-short-text = der Text muss mindestens { $count } Zeichen haben
value-with-spread = { $value } { $spread }
values-in-micrometres = Werte, µm
values-shares-their-limits-bar-expanded = Werte im Verhältnis zu ihren Grenzwerten: Der Balken ist die erweiterte Unsicherheit (k = 2), nach der der Grenzwert beurteilt wird, die Kreise sind die einzelnen Punktwolken.
verification = Verifizierung
verification-cannot-read = Die Verifizierung { $one } ist nicht lesbar.
verification-closed-start-new-one = Diese Verifizierung ist abgeschlossen. Eine neue starten.
verification-cloud = Verifizierung, Punktwolke { $number }
verification-failed-ago = Nicht bestanden ({ $ago } her). { $text }
verification-gauge =
    { $shape ->
        [sphere] Verifizierung an einer Prüfkugel
       *[plane] Verifizierung an einer Prüfebene
    }
verification-undecided-ago = Nicht entschieden ({ $ago } her). { $text }
verification-under-way-go-where-stands = Eine Verifizierung läuft. Beim aktuellen Schritt fortfahren.
verified = Verifiziert: { $text }
verify = Verifizieren
verify-again = Erneut verifizieren
verify-against-gauge-calibrate-again = An einem Prüfnormal verifizieren oder neu kalibrieren.
video-file = Die Videodatei { $source }
video-has-no-picture = { $title } enthält kein Bild
video-stream = Der Videostream { $source }
video-without-rate = { $title } gibt keine Bildrate an
wait = Darauf warten
wait-because = Warten: { CLAUSE($text) }.
wait-check-what-taken-kept = Warten oder das Gerät prüfen. Alles Aufgenommene bleibt erhalten.
wait-moment-load-page-again = kurz warten oder die Seite neu laden
wait-s-then-try-again = { $wait } warten, dann erneut versuchen
wait-stop = Warten oder stoppen
wait-until = warten, bis er verbunden ist
wait-until-arm-connected-again-nothing = warten, bis der Messarm wieder verbunden ist; es geht nichts verloren
wait-until-back = warten, bis der Sensor wieder verbunden ist
wait-until-connected = warten, bis er verbunden ist
wait-until-does = warten, bis das Gerät sendet
wait-until-done = warten, bis der Vorgang fertig ist
wait-until-has-ended = warten, bis der Vorgang beendet ist
wait-until-sensor-connected-capture-again = warten, bis der Sensor verbunden ist, und neu aufnehmen
waiting-s-first-data = Warten auf die ersten Daten: { $title }
kiosk-can-only-view = Eine Kiosk-Anzeige zeigt nur an.
waits-for-new-rest = Wartet, bis der Roboter in einer neuen Pose ruht und die Tafel im Bild ist
wanted-points-fit = Soll: { $target }; Punkte passen auf { $rms }
webhook = Webhook
went-another-pose = zu einer weiteren Pose gewechselt
went-back-points = zu den Punkten zurückgekehrt
went-more-clouds = zu weiteren Punktwolken gewechselt
went-result = zum Ergebnis gewechselt
went-step-back = einen Schritt zurückgegangen
went-without-probe = ohne Taster fortgefahren
what-and-why = { CAPITAL(CLAUSE($what)) }: { CLAUSE($why) }.
what-calibrated = Gegenstand der Kalibrierung
what-cannot-read-set-aside-everything = Nicht Lesbares wird unverändert beiseitegelegt; alles andere steht zur Verfügung.
what-checked = Gegenstand der Prüfung
what-clouds-show-against-certificate = Vergleich der Punktwolken mit dem Kalibrierschein des Prüfnormals und mit dem Taster.
what-figures-mean = Was die Werte bedeuten
what-figures-mean-text = Jeder Fehler von Arm und Sensor zeigt sich in manchen Werten und bleibt in anderen verborgen. Überschreiten mehrere Werte ihre Grenzen, sagt diese Tabelle, wo zuerst zu suchen ist.
what-identified = Gegenstand der Identifikation
what-is-calibrated = Was kalibriert wird
what-looks-may-good-bad = Der Zustand dessen, was sie prüft, ist damit unbekannt.
surface-is-not-a-plane = die überfahrene Fläche ist keine Ebene
what-recorded-kept = { $interrupted } Alles Aufgezeichnete bleibt erhalten.
recorded-data-kept = Alles Aufgezeichnete bleibt erhalten.
request-did-not-arrive = Die Anfrage ist nicht innerhalb von { $limit } angekommen.
what-shows-could-more-than-one = das Sichtbare könnte zu mehr als einem Teil des Objekts gehören
what-shows-reads-rather-like-objects = das Sichtbare entspricht eher dem Spiegelbild des Objekts
what-standard-uncertainty-k-1-scanned = Beiträge zur Standardunsicherheit (k = 1) eines gescannten Punkts.
what-taken-kept-folder = Alles Aufgenommene bleibt im Ordner der Sitzung.
what-tested = Was geprüft wurde
what-tip-moved-while-held-one = Scheinbare Bewegung der Tastkugel, während sie an einer Position gehalten wurde.
what-verified = Gegenstand der Verifizierung
where-sensor-sits-along-axis-cannot = die Lage des Sensors entlang dieser Achse lässt sich nicht bestimmen
which-board-not-certain = welche davon { $name } ist, steht nicht fest
who-reads-along-has-passwords-can = Wer mitliest, kennt Passwörter und kann unter fremdem Namen handeln.
whoever-helps-you-asks-first = Der Support fragt zuerst danach.
whole = Sie ist intakt, { $size_mb }.
whole-number-zero-more-expected = erwartet wird eine ganze Zahl ab null
whole-program-stood-still-longest =
    { $count ->
        [one] das gesamte Programm stand einmal still, für { $longest }
       *[other] das gesamte Programm stand { $count }-mal still, am längsten für { $longest }
    }
why = Warum
wide = { $wide } breit
widths-positive-ascend-choice-one = Breiten sind positiv und ansteigend; die Auswahl ist eine von { $choices }; die Glättung ist mindestens 0 und höchstens { $smoothing }
with-radius = Radius { $radius }
with-tip = Tastkugel { $diameter }
within-limit = Innerhalb des Grenzwerts
within-limit-m = { $half_range }, innerhalb des Grenzwerts von { $limit }.
without-ball-bar-arm-keeps-size = Ohne Kugelstab behält der Messarm den Maßstab seines Datenblatts.
without-ball-bar-arms-size-observable = ohne Kugelstab ist der Maßstab des Messarms nicht bestimmbar
without-free-memory-whole-machine-slows = Ohne freien Arbeitsspeicher wird der ganze Rechner langsam, und Bilder gehen verloren.
without-marker-coordinates-are-tips = ohne die Spalte marker gelten Koordinaten für die Tastkugel
without-nothing-measured-what-taken-kept = Ohne dieses Gerät wird nicht gemessen; alles Aufgenommene bleibt erhalten.
without-one-pixels-cannot-become-points = ohne Kalibrierung lassen sich aus Pixeln keine Punkte berechnen
without-schema = ohne Schema
write-all-numbers-with-point = Schreiben Sie alle Zahlen mit Dezimalpunkt
write-readings-of-arm = Die Messwerte des Arms mit ihren Zeiten eintragen
xlsx-extra-missing = Braucht XlsxWriter auf der Station: pip install 'crenel[xlsx]'
xlsx-package-missing = XLSX-Dateien benötigen das Paket XlsxWriter, das nicht installiert ist
xml-document-type-refused = die Datei hat einen Dokumenttyp (DOCTYPE oder ENTITY) und wird deshalb nicht gelesen
xml-is-no-urdf = Der Text ist XML mit dem äußeren Element { $name }; das eines URDF ist robot
xml-not-well-formed = die Datei ist kein wohlgeformtes XML: { $error }
word-above = oben
word-ambient = Umgebungslicht
word-arm = Messarm
word-back = Rückseite
word-ball = Kugel
word-bar = Kugelstab
word-below = unten
word-block = Zinnenkörper
word-board = Tafel
word-boolean = Ja/Nein
word-both = beide
word-calibration = Kalibrierung
word-camera = Kamera
word-changed = geändert
word-colder = kälter
word-contact = Antastpunkt
word-corner = Ecke
word-crest = Zinnenoberseiten
word-crests = Zinnenoberseiten
word-cylinder = Zylinder
word-depth = Tiefe
word-distortion = Verzeichnung
word-edges = Kanten
word-exposure = Belichtung
word-fail = nicht bestanden
word-floor = Nutgründe
word-floors = Nutgründe
word-focus = Schärfe
word-frames = Bilder
word-framing = Bildausschnitt
word-front = Vorderseite
word-gauge = Prüfnormal
word-groove = Nut
word-integer = ganze Zahl
word-laser = Laser
word-left = linke Stirnseite
word-left-of = links von
word-lighting = Beleuchtung
word-merlon = Zinne
word-missing = fehlt
word-no = nein
word-none = keine
word-number = Zahl
word-object = Objekt
word-off = aus
word-on = an
word-once = einmal
word-part = Teil
word-pass = bestanden
word-performance-test = Leistungsprüfung
word-pictures = Bilder
word-plane = Ebene
word-plate = Platte
word-points = Punkte
word-right = rechte Stirnseite
word-right-of = rechts von
word-scan = Scan
word-seat = Pfanne
word-sensor = Sensor
word-shell = Schale
word-sphere = Kugel
word-step = Stufe
word-string = Text
word-stripe = Laserlinie
word-tip = Tastkugel
word-unchanged = unverändert
word-undecided = nicht entschieden
word-unknown = unbekannt
word-used = verwendet
word-verification = Verifizierung
word-warmer = wärmer
working-out-error-budget = Unsicherheitsbudget wird berechnet
working-out-uncertainty = Unsicherheit wird berechnet
working-out-which-pose-would-help = Wirksamste Pose wird berechnet
worn-has-flat = Der Durchmesser der Tastkugel beträgt anscheinend { $diameter }, laut Datenblatt des Messarms { $expected }: Sie ist abgenutzt oder hat eine Abflachung.
write-one = einen Namen eingeben
writing-cloud = Punktwolke wird geschrieben
writing-scan = Scan wird geschrieben
wrong-code = falscher Code
wrong-password = falsches Passwort
you-do-not-have-control = Sie haben die Bedienung nicht
zone-has-no-area = Zone { $number } hat keine Fläche
zone-outside-picture = Zone { $number } liegt außerhalb des Bildes
zone-reaches-far-beyond-picture = Zone { $number } reicht weit über das Bild hinaus
zones-cannot-set-now = Zonen lassen sich jetzt nicht festlegen
zones-picture-pixels-left-out-sensors = Die Zonen gelten für ein Bild mit { $width_px } × { $height_px } Pixeln und werden nicht verwendet; das Bild des Sensors hat { $width_px2 } × { $height_px2 }

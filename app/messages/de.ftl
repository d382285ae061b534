abandon = Abbrechen
abandon-calibration-calibration-use-stays = Diese Kalibrierung abbrechen? Die Kalibrierung in Gebrauch bleibt, wie sie ist.
abandoned = sie abgebrochen
about-missing-places-longest-start =
    { $stream ->
        [joints]
            etwa { $missing } Gelenkwerte fehlen an { $holes ->
                [one] { $holes } Stelle
               *[other] { $holes } Stellen
            }, die längste { $longest }, { $at } nach dem Beginn
       *[frames]
            etwa { $missing } Bilder fehlen an { $holes ->
                [one] { $holes } Stelle
               *[other] { $holes } Stellen
            }, die längste { $longest }, { $at } nach dem Beginn
    }
accept-calibration = Kalibrierung annehmen
accept-verification = Diese Verifizierung annehmen
accepted = Angenommen
accepted-result = das Ergebnis angenommen
account-has-no-name = Das Konto hat keinen Namen
account-name-length = 1 bis { $most } Buchstaben, Ziffern und Zeichen
account-taken = Ein Konto { $name } gibt es schon
across-mm = quer, mm
act-failed = gescheitert
act-with-detail = { $act }: { $detail }
add-exposure-us-line = Eine Zeile exposure_us = … hinzufügen
add-line = Eine Zeile { $key } = … hinzufügen
add-picture-delete-pose = Das Bild ergänzen oder die Pose löschen
add-pictures-turned-about-another-axis = Bilder hinzufügen, die um eine andere Achse gedreht sind
added-account = ein Konto angelegt
address-none-message-can-sent = An diese Adresse lässt sich keine Nachricht senden
adjusting-all-poses-together = Alle Posen werden gemeinsam ausgeglichen
after = Nachher
after-advised-pose = { $then } nach der empfohlenen Pose
after-few-more-touches = nach einigen weiteren Antastungen
after-mark = nachher
after-three-points-three-faces = nach drei Punkten auf drei Flächen
against-limits = Gegen die Grenzen
against-use-before-points-measuring-volume = Gegen { $name }, vorher in Gebrauch: Punkte des Messvolumens wanderten um { $rms } ({ $rms_mm }) rms, höchstens um { $largest } ({ $largest_mm }).
ages-calibrations-order-records-go-measuring = Das Alter von Kalibrierungen und die Ordnung im Archiv richten sich danach; das Messen nicht.
all-corners-lie-one-level-z = alle { $points } Ecken liegen auf einer Ebene, z = { $z }
all-corners-lie-one-plane-normal = alle { $points } Ecken liegen in einer Ebene mit der Normalen ({ $normal })
all-corners-were-given-same-pixel = alle Ecken haben denselben Pixel
all-kept-can-read = Alles Aufbewahrte ist lesbar.
all-pictures-one-sensor-must-have = Alle Bilder eines Sensors müssen gleich groß sein.
all-points-there-go-add =
    { $more ->
        [yes] Alle Punkte sind da. Weitermachen oder mehr antasten, wie unten angegeben.
       *[no] Alle Punkte sind da. Weitermachen oder einige mehr antasten.
    }
all-points-there-go-pictures = Alle Punkte sind da. Weiter zu den Bildern.
all-poses-turn-flange-about-one = alle { $count } Posen drehen den Flansch um eine Achse, ({ $x } { $y } { $z }) in seinem eigenen Koordinatensystem
all-there-they-were-recorded = Alle sind da, wie sie aufgezeichnet wurden.
and-more-records = Und { $count } weitere.
angle = Winkel, ″
angle-between-clouds = Winkel zwischen Wolken
angle-touched-plane = Winkel zur angetasteten Ebene
another-arm-answers = An { $url } antwortet ein anderer Messarm: { $name } { $serial_number } ({ $joints } Gelenke) statt { $expected_name } { $expected_serial_number }
another-calibration-came-into-use-meanwhile = Inzwischen kam eine andere Kalibrierung in Gebrauch. Mit ihr neu beginnen.
another-programs-database = { $path } ist die Datenbank eines anderen Programms
another-station-publishes-under-ones-name = Eine andere Station veröffentlicht unter dem Namen dieser.
another-tip-mounted-another-sphere-touched = Die Tastkugel hat anscheinend { $diameter }, nach dem Datenblatt des Messarms { $expected }: Ein anderer Taster ist montiert, oder eine andere Kugel wurde angetastet.
answered-who-asked-control = auf die Bitte um die Bedienung geantwortet
answers-browsers = Antworten an Browser
applied-dropped-arms-delay = den Verzug des Messarms angewandt oder verworfen
approved = Freigegeben
arm-2 = Der Messarm: { $text }
arm-3 = Der Messarm ist, wie er war.
arm-4 = Messarm
arm-before = Der Messarm ist wieder wie vorher.
arm-before-arms-put-back-hand = der Messarm von vorher liegt in arms/{ $replaced }/{ $name }; ihn von Hand zurücklegen
arm-by-its-datasheet = es ist ein Messarm nach seinem Datenblatt
arm-check = Armprüfung
arm-check-2 = Armprüfung
arm-check-no-limit = { $half_range }, keine Grenze war gesetzt.
arm-check-with-limit = { $half_range }, Grenze { $limit }.
arm-checked = Der Messarm ist geprüft: { $worst }.
arm-chosen-cannot-read-any-more = Der gewählte Messarm lässt sich nicht mehr lesen
arm-closed-while-opening = Der Messarm an { $url } wurde beim Öffnen geschlossen
arm-encoders = Messgeber des Arms
arm-geometry = Geometrie des Arms
arm-has-joint-number = der Messarm { $arm } hat { $count }
arm-has-joints = der Messarm { $arm } hat { $count } Gelenke
arm-has-joints-station-toml-asks = Der Messarm an { $url } ({ $name } { $serial_number }) hat { $joints } Gelenke, und station.toml verlangt joint_count = { $joint_count }
arm-identified = Der Messarm ist identifiziert.
arm-json-names-joints = arm.json nennt sie { $names }
arm-json-tip-goes-far-while = nach dieser arm.json wandert die Tastkugel weit, während sie in einer Pfanne sitzt: { $far } von der Mitte der Pfanne { $name }
arm-json-tip-goes-fro = { $label }: Nach arm.json wandert die Tastkugel um { $distance } hin und her
arm-measures-within = ein Messarm misst innerhalb von { $farthest }
arm-model-arm = das Armmodell gehört zum Messarm { $serial_number }
arm-not-open = Der Messarm an { $url } ist nicht offen
arm-object-chosen-cannot-read-any = Der gewählte Messarm oder das gewählte Objekt lässt sich nicht mehr lesen.
arm-place-name =
    { $kind ->
        [bar] Stab { $number }, Ende { $end }
        [sphere] Kugel { $number }
       *[seat] Pfanne { $number }
    }
arm-place-title =
    { $kind ->
        [bar] Stab { $number }, Ende { $end }
        [sphere] Kugel { $number }
       *[seat] Pfanne { $number }
    }
arm-reports-joints =
    Der Messarm an { $url } meldet { $joints ->
        [one] { $joints } Gelenk
       *[other] { $joints } Gelenke
    }
arm-reports-no-counts-per-revolution = Der Messarm an { $url } meldet 0 Schritte je Umdrehung für Gelenk { $joint }
arm-sees-bar-given = der Messarm sieht Stab { $bar } mit { $measured }, angegeben sind { $given }
arm-sends-hello-but-no-samples = Der Messarm an { $url } meldet sich ({ $name }), sendet aber keine Werte
arm-sends-no-joint-angles = der Messarm sendet keine Gelenkwinkel
arm-sends-other-joint-count = Der Messarm an { $url } hat { $expected } Gelenke angekündigt, sendet aber { $count }
arm-sends-samples-but-no-hello = Der Messarm an { $url } sendet Werte, aber kein Hello
arm-sent-too-little-arm-camera = der Messarm sendete zu wenig, oder Messarm und Kamera laufen nicht auf einer Uhr
arm-speaks-version-protocol-driver-speaks = Der Messarm an { $url } spricht Version { $other_version } des Protokolls; dieser Treiber spricht Version 1
arm-stays-shows-nothing-errors = ein Messarm, der bleibt, wie er ist, zeigt nichts von seinen Fehlern
arm-still = der Messarm war nicht still
arm-tip = Messarm und Tastkugel
arm-url-cannot-be-opened = Die url { $url } des Messarms lässt sich nicht öffnen ({ $reason })
arm-use-already = Dieser Messarm ist schon in Gebrauch.
arm-with-joints-needed = hier wird ein Messarm gebraucht, der seine Gelenkwinkel meldet
arms-6-7-joints-served = Messarme mit 6 oder 7 Gelenken werden bedient.
arms-adapter-running = Läuft der Adapter des Messarms?
arms-data-has-gap-there = die Daten des Messarms haben dort eine Lücke
arms-motion-moves-other-way-than = nach der Bewegung des Messarms bewegt sich „{ $name }“ andersherum als in den Bildern
arms-motion-object-than-certificate-says =
    { $sign ->
        [larger] Nach der Bewegung des Arms ist das Objekt { $share } (± { $uncertainty }) größer als laut Kalibrierschein: Alle Längen wären um ebenso viel falsch.
       *[smaller] Nach der Bewegung des Arms ist das Objekt { $share } (± { $uncertainty }) kleiner als laut Kalibrierschein: Alle Längen wären um ebenso viel falsch.
    }
arms-motion-squares-wide = nach der Bewegung des Messarms sind die Felder von „{ $name }“ { $width } breit
arms-motion-squares-wide-certificate = Nach der Bewegung des Arms sind die Felder { $width } breit (± { $uncertainty }), laut Kalibrierschein { $nominal }: Alle Längen wären um ebenso viel falsch.
arms-parameters = Parameter des Messarms
arms-parameters-already-explain-points-well = die Parameter des Messarms erklären die Punkte schon so gut, wie sie gemessen sind
arms-position-known-around-most-pictures = die Lage des Messarms ist um die meisten Bilder herum nicht bekannt
arms-zero = Vom Nullpunkt des Messarms
ask-administrator-new-one = Einen Administrator um einen neuen bitten
ask-control-take-over = Die Bedienung anfragen oder übernehmen
ask-somebody-with-role =
    { $role ->
        [admin] Einen Administrator fragen
       *[operator] Einen Bediener fragen
    }
asked-control = um die Bedienung gebeten
asks-control = { $name } bittet { $holder } um die Bedienung.
at-least-limit = ≥ { $limit }
at-most-limit = ≤ { $limit }
attention = Achtung
away = { $min } entfernt
axes = Achsen
axis-component = Achse { $axis }
axis-level = Achse gegen die Waagerechte
back = Zurück
back-face = Rückseite
back-places = Zurück zu den Orten
back-points = Zurück zu den Punkten
backup = Sicherung
backup-2 = Die Sicherung liegt in { $folder }.
backup-being-made-already = Es wird schon eine Sicherung angelegt
backup-needs = Die Sicherung braucht { $total }
backup-replaces-nothing = eine Sicherung ersetzt nichts
bad = Schlecht
ball-bars = Kugelstäbe
ball-bars-lengths = Kugelstablängen
ball-diameter = Ø { $diameter }
bar-end-2 = Stab { $name } { $position }, Ende { $end }
bar-has-two-ends = ein Kugelstab hat zwei Enden
bar-named = Kugelstab { $name }
bar-position-arm-json-ends-lie = Stab { $name }, Stellung { $position }: Nach arm.json liegen seine Enden { $measured } auseinander, angegeben sind { $length }
bar-position-has-ends = { $path }: Kugelstab { $bar }, Position { $position } hat die Enden { $ends }
bars-end = Stabende { $value }
bars-lengths-points-scatter-without-them = mit den Stablängen streuen die Punkte um { $scatter }, ohne sie um { $without }
before = Vorher
before-after = Vorher und nachher
before-after-identification = Vor und nach der Identifikation
before-mark = vorher
before-poses-were-changed-since = Von vorher: Die Posen wurden seitdem geändert.
began-again = neu begonnen
began-backup = eine Sicherung begonnen
began-cloud = eine Wolke begonnen
began-resumed-arm-check = eine Armprüfung begonnen oder fortgesetzt
began-resumed-calibration = eine Kalibrierung begonnen oder fortgesetzt
began-resumed-verification = eine Verifizierung begonnen oder fortgesetzt
began-seat = einen Sitz begonnen
begin-again = Neu beginnen
begin-new-one = Eine neue beginnen
begun = Begonnen
behind = von hinten
being-recorded = er wird gerade aufgezeichnet
belongs-another-step-calibration-stands =
    { $step ->
        [devices] Das gehört zu einem anderen Schritt; die Kalibrierung steht bei „Geräte“.
        [setup] Das gehört zu einem anderen Schritt; die Kalibrierung steht bei „Einrichten“.
        [touch] Das gehört zu einem anderen Schritt; die Kalibrierung steht bei „Antasten“.
        [place] Das gehört zu einem anderen Schritt; die Kalibrierung steht bei „Halten“.
        [capture] Das gehört zu einem anderen Schritt; die Kalibrierung steht bei „Aufnehmen“.
        [solve] Das gehört zu einem anderen Schritt; die Kalibrierung steht bei „Kalibrieren“.
       *[review] Das gehört zu einem anderen Schritt; die Kalibrierung steht bei „Beurteilen“.
    }
belongs-another-step-session-stands =
    { $step ->
        [seat] Das gehört zu einem anderen Schritt; die Sitzung steht bei „Tastkugel einsetzen“.
        [swing] Das gehört zu einem anderen Schritt; die Sitzung steht bei „Arm schwenken“.
       *[result] Das gehört zu einem anderen Schritt; die Sitzung steht bei „Ergebnis“.
    }
belongs-another-step-verification-stands =
    { $step ->
        [gauge] Das gehört zu einem anderen Schritt; die Verifizierung steht bei „Prüfnormal wählen“.
        [touch] Das gehört zu einem anderen Schritt; die Verifizierung steht bei „Prüfnormal antasten“.
        [scan] Das gehört zu einem anderen Schritt; die Verifizierung steht bei „Prüfnormal scannen“.
       *[review] Das gehört zu einem anderen Schritt; die Verifizierung steht bei „Ergebnis“.
    }
beyond-limit = Jenseits der Grenze
bits-expected = 8 oder 16 Bit werden erwartet
bits-per-pixel = { $bits } Bit je Pixel
block-corner =
    { $level ->
        [crest] Zinne { $number }
        [floor] Nutgrund { $number }
       *[base] Sockel
    }, { $place ->
        [L-front] vorn links
        [R-front] vorn rechts
        [L-back] hinten links
       *[R-back] hinten rechts
    }
board-bends-over-pattern-allowed = Das Blatt biegt sich über das Muster um { $bend }: berücksichtigt.
board-bends-over-pattern-flat-expected = Das Blatt biegt sich über das Muster um { $bend }; erwartet war eine Ebenheit von { $flatness }.
board-has-corners = „{ $name }“ hat { $columns } × { $rows }
board-has-corners-outermost-missing = „{ $name }“ hat { $columns } × { $rows }; ohne die äußersten Ecken lassen sich die anderen nicht nummerieren
board-printed-side = Tafel (bedruckte Seite)
board-tilted-most-between-pictures = die Tafel ist zwischen den { $seen } Bildern höchstens um { $tilt } geneigt
both-devices-answer-go = Beide Geräte antworten. Weitermachen.
brightness = Helligkeit
bring-back-last-backup-delete-under = Aus der letzten Sicherung zurückholen oder unter Archiv löschen.
bring-block-closer-so-fills-picture = Den Zinnenkörper näher bringen, sodass er das Bild füllt.
bring-block-middle-stripe = Den Zinnenkörper in die Mitte der Laserlinie bringen.
bring-front-back-edge-level-into = die vordere und die hintere Kante einer Ebene ins Bild bringen
bring-joint-reference-switch-arm-off = Gelenk in seine Referenz bringen und den Messarm aus- und einschalten; bleibt es dabei, das Datenblatt dieses Messarms wählen
bring-joint-reference-switch-arm-off-2 = das Gelenk auf seine Referenz bringen und den Messarm aus- und einschalten
bring-more-object-into-picture = mehr vom Objekt ins Bild bringen
bring-more-object-into-picture-sharp = mehr vom Objekt ins Bild bringen, scharf und gut beleuchtet
bring-part-into-sensors-range = ein Teil in den Messbereich des Sensors bringen
bring-part-into-sensors-range-if = Das Teil in den Messbereich des Sensors bringen; ist es dort, die Belichtung ansehen.
bring-whole-board-into-picture-outermost = die ganze Tafel ins Bild bringen, ihre äußersten Ecken neben den Laser; hat die Tafel nicht mehr, ihren eigenen Kalibrierschein angeben
bring-whole-board-into-picture-sharp = die ganze Tafel ins Bild bringen, scharf und gleichmäßig beleuchtet
bring-whole-object-into-view-front = das ganze Objekt ins Bild bringen, von vorn oben, und gleichmäßig beleuchten
broker = Broker
but-what-marked-below-needs-attention = Aber was unten markiert ist, braucht Aufmerksamkeit.
byte-is-not-utf-8 = Byte { $byte } ist kein UTF-8-Text
bytes-but-no-packet =
    { $count ->
        [one] { $count } Byte kam von { $url }, aber kein Paket eines Messarms
       *[other] { $count } Bytes kamen von { $url }, aber kein Paket eines Messarms
    }
calibrate = Kalibrieren
calibrate-again = Neu kalibrieren
calibrate-first = Zuerst kalibrieren
calibrate-first-2 = zuerst kalibrieren
calibrate-sensor-arm-touch-object-then = Den Sensor am Messarm kalibrieren: das Objekt antasten, dann einige Bilder aufnehmen.
calibrate-sensors-again-their-place-belongs = Die Sensoren neu kalibrieren: Ihr Ort gehört zum Messarm, wie er war.
calibrated = Kalibriert
calibrated-distance-camera = Kalibrierter Abstand von der Kamera
calibrating = Kalibrierung läuft
calibration = Kalibrierung
calibration-acceptance-test-no-characteristic-iso = Dies ist eine Kalibrierung, keine Annahmeprüfung: Keine Kenngröße nach ISO 10360-8 oder ISO 10360-12 wird behauptet. Eine Verifizierung an Prüfnormalen prüft den Scanner.
calibration-accepted-station = Diese Kalibrierung wurde nicht an einer Station angenommen.
calibration-age-and-temperature = { $text }, { $ago } alt; die Frist beträgt { $limit }, der zulässige Temperaturunterschied { $change } (jetzt { $now }).
calibration-arm = die Kalibrierung gilt für den Messarm { $known }
calibration-cannot-read = Die Kalibrierung { $name } ist nicht zu lesen.
calibration-cannot-shown = die Kalibrierung { $session_id } lässt sich nicht zeigen
calibration-closed-start-new-one = Diese Kalibrierung ist geschlossen. Eine neue beginnen.
calibration-computed = Die Kalibrierung ist berechnet.
calibration-due = Die Kalibrierung ist fällig. { $text }
calibration-has-no-picture = Diese Kalibrierung hat kein Bild { $name }.
calibration-here-any-more = Die Kalibrierung von { $name } ist nicht mehr hier
calibration-in-use-unreadable = Die Kalibrierung in Gebrauch ist nicht lesbar: { $error }
calibration-is-for-joints = die Kalibrierung gilt für einen mit { $joints }
calibration-is-for-pixels = die Kalibrierung gilt für { $width } × { $height }
calibration-is-for-serial-number = die Kalibrierung gilt für { $serial_number }
calibration-known-here = ihre Kalibrierung ist hier nicht bekannt
calibration-pose = die Kalibrierpose
calibration-report = Kalibrierbericht
calibration-should-used-findings-say-what = Diese Kalibrierung sollte nicht benutzt werden. Die Befunde sagen, was zu tun ist.
calibration-under-way-go-where-stands = Eine Kalibrierung läuft. Dort weitermachen, wo sie steht.
calibration-use = Die Kalibrierung ist in Gebrauch
calibration-use-cannot-read = Die verwendete Kalibrierung lässt sich nicht lesen
calibration-utc = Kalibrierung { $now } UTC
calibration-valid-verified-scan-part = Die Kalibrierung ist gültig und verifiziert. Das Teil scannen.
calibration-verified-yet = Diese Kalibrierung wurde noch nicht verifiziert.
calibrations-unknowns-did-settle-what-seen = die Unbekannten der Kalibrierung konvergieren nicht mit den Bildern und Antastpunkten
camera = Die Kamera { $source }
camera-cannot-do = { $title } kann { $key } = { $value } nicht; möglich ist { $given }
camera-looks-along-laser-plane-deg = die Kamera blickt entlang der Laserebene, { $angle } daneben (Grenze { $limit })
camera-must-look-stripe-side-check = die Kamera muss von der Seite auf die Laserlinie blicken: den Aufbau des Sensors prüfen
camera-needs-two-levels-four-sides = eine Kamera braucht zwei Ebenen und vier Seiten der Zinnen
cameras-are = Vorhandene Kameras: { $names }.
cameras-matrix-needs-least-six-crests = die Kameramatrix braucht mindestens sechs, auf Zinnen und Nutgründen
cameras-parameters-did-settle-pictures-edges = die Parameter der Kamera konvergieren nicht mit den Kanten des Bilds
cameras-pixels-come-out-out-square = Die Pixel der Kamera weichen um { $difference } vom Quadrat ab; die heutiger Sensoren sind quadratisch (Grenze { $limit }).
can-read-more-than-one-way = es lässt sich auf mehr als eine Art lesen
can-written = Er lässt sich beschreiben.
cannot-be-copied = { $path } lässt sich nicht kopieren
cannot-be-opened-for-writing = { $path } lässt sich nicht zum Schreiben öffnen
cannot-deleted-now = Das lässt sich jetzt nicht löschen
cannot-hidden-now = Das lässt sich jetzt nicht ausblenden
cannot-read = Sie ist nicht zu lesen: { $text }
cannot-read-2 = { $password_file } lässt sich nicht lesen
cannot-shown = { $name } lässt sich nicht zeigen: { $error }
cannot-shown-2 = { $name } lässt sich nicht zeigen.
cannot-start = { $title }: kann nicht beginnen
cannot-written = Er lässt sich nicht beschreiben: { CLAUSE($trouble) }.
capital = { CAPITAL($text) }
capture = Aufnehmen
centre = Mittelpunkt { $axis }
centre-m = Mittelpunkt, µm
centre-radius-cannot-be-separated = Mittelpunkt und Radius lassen sich nicht trennen
certificate = Kalibrierschein
certificate-2 = Kalibrierschein { $certificate }
certificate-says = laut Kalibrierschein { $square }
certificate-trusted-here = seinem Zertifikat wird hier nicht vertraut
change = Änderung
change-one-them = eine von beiden ändern
change-permissions-place = Die Rechte oder den Ort ändern
change-place = Den Ort ändern
changed-account = ein Konto geändert
changed-after-session-had-written = { $name } wurde geändert, nachdem diese Sitzung die Datei geschrieben hatte
changed-notifications = die Benachrichtigungen geändert
changed-own-password = das eigene Passwort geändert
changed-settings = die Einstellungen geändert
check-address-below-try = Die Adresse unten prüfen und ausprobieren.
check-address-network = Adresse und Netz prüfen.
check-address-network-and-power = Adresse und Netz prüfen, und ob sie eingeschaltet ist.
check-again = Erneut prüfen
check-ago-failed = Prüfung nicht bestanden, { $ago } her: { $text }
check-arm = Messarm prüfen
check-arm-again = Messarm erneut prüfen
check-arm-json-against-arm-signs = arm.json mit dem Messarm vergleichen: Vorzeichen, Einheiten, Längen, Reihenfolge der Gelenke; und die Punkte dieses Orts
check-arm-play-tip-sensor-loose = Den Messarm auf Spiel, Tastkugel und Sensor auf festen Sitz prüfen; still halten.
check-arm-tip-object-sensor-those = Prüfen, ob der Messarm mit seiner Tastkugel, das Objekt und der Sensor die sind, die in Gebrauch sind.
check-arm-url = Die url des Messarms prüfen.
check-arms-cable-then-switch-arm = Kabel des Messarms prüfen, dann den Messarm aus- und einschalten
check-arms-file-lengths-angles-signs = Die Armdatei prüfen: Längen und Winkel, Vorzeichen und Reihenfolge der Gelenke und den Taster; dann, auf welcher Fläche jeder Punkt angetastet wurde, und den Kalibrierschein des Objekts
check-baud-rate-arm-port-another = Die Baudrate prüfen, und ob an diesem Anschluss der Messarm hängt und kein anderes Gerät.
check-board-how-exact-certificate-takes = Prüfen, ob dies die Tafel ist, und für wie genau ihr Kalibrierschein sie hält.
check-broker-runs-user-password-right = Prüfen, ob der Broker läuft und Benutzer und Passwort stimmen. Es wird weiter versucht.
check-cable-no-other-program-uses = Das Kabel prüfen, und ob ein anderes Programm es benutzt.
check-cable-power = Kabel und Strom prüfen.
check-cable-power-looked-again-itself = Kabel und Strom prüfen. Es wird von selbst wieder gesucht.
check-cannot-made = Die Prüfung { $name } ist nicht möglich: { CLAUSE($reason) }.
check-chosen-gauge-tip-arms-own = Prüfen, ob dies das gewählte Prüfnormal ist und die Tastkugel die des Messarms.
check-connection = Die Verbindung prüfen.
check-devices = Geräte prüfen
check-diameter = { $finding }: ihren Durchmesser prüfen
check-diameter-mm-spheres-take-sphere = diameter_mm der Kugeln prüfen; diese Kugel erneut aufnehmen oder ihre Zeilen löschen
check-each-laser-picture-own-pose = Prüfen, ob jedes Laserbild zu seiner eigenen Pose gehört und ohne Bewegung des Sensors aufgenommen wurde und ob der Laser fest sitzt; dann seine Schärfe.
check-each-laser-picture-own-pose-2 = prüfen, ob jedes Laserbild zu seiner eigenen Pose gehört, ob der Laser gegen die Kamera nicht bewegt wurde und ob die Linie im Bild seine eigene und keine Spiegelung ist
check-encoder-swing-arm-so-every = Den Messgeber prüfen; den Arm so schwenken, dass jedes Gelenk dreht
check-encoders-arm-json-how-points = Messgeber, arm.json und die Aufnahme der Punkte prüfen
check-failed = Eine Prüfung, die fehlschlug
check-first-page-arm-tip-takes = Zuerst prüfen, auf der Seite von Arm und Tastkugel; es dauert eine Minute.
check-folders-owner-whether-disk-mounted = Den Eigentümer des Ordners prüfen, und ob der Datenträger eingehängt ist.
check-joints-encoder-cable-then-bring = Messgeber und Kabel des Gelenks prüfen, dann den Messarm in seine Referenz bringen
check-laser-board-camera-kept-still = Prüfen, ob Laser, Tafel und Kamera still blieben und Bild und Pose vom selben Augenblick sind.
check-laser-exposure-sensors-stripe-axis = Laser, Belichtung und stripe_axis des Sensors prüfen und die Laserlinie über die Mitte des Objekts führen
check-laser-exposure-then-take-new = Laser und Belichtung prüfen, dann ein neues Bild aufnehmen.
check-laser-line-crossed-object-exposure = Prüfen, ob der Laser an war und seine Linie das Objekt kreuzte, und die Belichtung; die Pose neu aufnehmen.
check-laser-moved-against-camera-line = prüfen, ob der Laser gegen die Kamera verstellt wurde und ob die Linie im Bild seine eigene ist und keine Spiegelung
check-laser-picture-pose-sensor-held = Prüfen, ob ihr Laserbild zu dieser Pose gehört, ob der Sensor zwischen ihren beiden Bildern stillgehalten wurde und ob der Laser fest sitzt; die Pose noch einmal aufnehmen.
check-lasers-interlock-key-switch-capture = Verriegelung und Schlüsselschalter des Lasers prüfen und neu aufnehmen
check-length-mm-bar-ends = length_mm des Stabs { $bar } und seine Enden prüfen
check-length-unless-datasheet-is-as-far-off = { $finding }: seine Länge prüfen, sofern das Datenblatt des Messarms nicht ebenso weit abweicht
check-moved-every-picture-has-arms =
    { $thing ->
        [board] prüfen, ob die Tafel unbewegt blieb und ob jedes Bild die Messarmwerte seiner eigenen Pose hat
       *[object] prüfen, ob das Objekt unbewegt blieb und ob jedes Bild die Messarmwerte seiner eigenen Pose hat
    }
check-object-certificate-lengths-mm = Prüfen, ob dies das Objekt des Kalibrierscheins ist, und seine Längen in mm.
check-object-picture-take-picture-again = prüfen, ob dies das Objekt im Bild ist, und das Bild neu aufnehmen
check-object-pictures-every-picture-belongs = prüfen, ob dies das Objekt in den Bildern ist und jedes Bild zu seiner Armpose gehört
check-objects-certificate-cameras-flip-setting = den Kalibrierschein des Objekts und die Spiegelung der Kamera prüfen
check-objects-certificate-which-sides-front = Den Kalibrierschein des Objekts prüfen, und welche Seite die Vorderseite ist
check-one-seat = Dies ist die Prüfung einer einzigen Pfanne.
check-owner-and-permissions = Eigentümer und Rechte prüfen, und ob der Datenträger nur lesbar eingehängt ist
check-path = Den Pfad prüfen
check-picture-joint-angles-one-moment = Prüfen, ob Bild und Gelenkwinkel vom selben Augenblick sind, oder die Pose neu aufnehmen.
check-pictures-joint-angles-own = Prüfen, ob die Gelenkwinkel des Bilds die seinen sind.
check-pictures-joint-angles-those-their = Prüfen, ob die Gelenkwinkel der Bilder die ihrer Posen sind.
check-pictures-mirrored-poses-those-flange = prüfen, ob die Bilder gespiegelt sind und ob die Posen die des Flansches im Koordinatensystem des Arms sind, in mm, qw zuletzt, und nicht deren Umkehrung
check-recorded-limit-set-before-next = Diese Prüfung ist mit ihrer Grenze aufgezeichnet. Die Grenze vor der nächsten setzen.
check-sensor = Den Fühler prüfen.
check-sensor-path = { "[" }sensor] path prüfen.
check-sensor-source = { "[" }sensor] source prüfen.
check-sensors-cable-close-other-programs = Das Kabel des Sensors prüfen oder andere Programme schließen.
check-session-taken-arm = prüfen, ob die Sitzung mit diesem Messarm aufgenommen wurde
check-signs-lengths-joints-order = Vorzeichen, Längen und Reihenfolge der Gelenke in arm.json prüfen
check-square-mm-tip-arm-json = square_mm, die Tastkugel in arm.json und den unveränderten Stand der Tafel prüfen
check-station-disk = Sehen Sie nach der Platte der Station
check-system-log-and-disk = Systemprotokoll und Datenträger prüfen; den Datenordner lassen, wie er ist
check-tip = Tastkugel prüfen
check-tip-again = Tastkugel erneut prüfen
check-tip-mounted-against-arms-file = Den montierten Taster mit der Armdatei vergleichen und prüfen, ob sich nichts bewegt hat; das Modell des Arms neu bestimmen lassen.
check-tip-one-arms-file-block = Prüfen, ob der Taster der aus der Armdatei ist und ob Zinnenkörper und Arm fest standen; dann das Modell des Arms.
check-tip-one-arms-file-board = Prüfen, ob die Tastkugel die der Armdatei ist und ob Tafel und Arm fest standen.
check-tip-play-faces-dirt-have = Die Tastkugel auf Spiel, die Flächen auf Schmutz prüfen; das Armmodell prüfen lassen.
check-tips-diameter-block-then-arms = Den Tastkugeldurchmesser prüfen, und ob dies der Zinnenkörper ist; dann das Armmodell.
check-which-arm-plugged = Prüfen, welcher Messarm angeschlossen ist.
check-which-face-each-contact-taken = Prüfen, auf welcher Fläche jeder Punkt angetastet wurde, dazu die Tastkugel und den Kalibrierschein des Objekts
check-which-tip-mounted-diameter-length = Prüfen, welcher Taster montiert ist, seinen Durchmesser und seine Länge, und ob das Objekt nach dem Antasten bewegt wurde.
check-which-tip-mounted-diameter-object = Prüfen, welcher Taster montiert ist, seinen Durchmesser, und ob das dieses Objekt ist.
check-which-tip-mounted-stylus-straight = Prüfen, welcher Taster montiert ist und ob sein Schaft gerade ist und fest sitzt; seine Lage neu bestimmen lassen und das Objekt noch einmal antasten.
checked = Geprüft
checked-ago = Geprüft, { $ago } her: { $text }
checked-ago-after-check-due = Geprüft, { $ago } her; die Frist beträgt { $limit }.
checking-places-held-out = Prüfung an zurückgehaltenen Orten
checksum-wrong-at-byte = { $name }: Die Prüfsumme bei Byte { $byte } ist falsch
chessboard-inner-corners-squares-mm = Schachbrett, { $columns } × { $rows } innere Ecken, Felder von { $square }
chessboard-seen-several-sides-take-more = Ein Schachbrett wird von mehreren Seiten gesehen: { $more } Bilder mehr aufnehmen.
chessboard-seen-several-sides-take-one = Ein Schachbrett wird von mehreren Seiten gesehen: ein Bild mehr aufnehmen.
chessboard-x-inner-corners-found = ein Schachbrett mit { $columns } × { $rows } inneren Ecken wurde gefunden
choice-needs-field-id = Eine Wahl braucht ein Feld und eine Kennung.
choose-another = Einen anderen wählen
choose-another-name = Einen anderen Namen wählen
choose-another-place = Einen anderen Ort wählen
choose-arm-first = Zuerst den Messarm wählen.
choose-arm-first-2 = zuerst den Messarm wählen
choose-datasheet-connect-other = Das Datenblatt für diesen { $name } wählen oder den anderen { $name } anschließen.
choose-first = Zuerst wählen: { $things }.
choose-folder-elsewhere-best-another-disk = Einen Ordner anderswo wählen, am besten auf einem anderen Datenträger
choose-gauge = Prüfnormal wählen
choose-gauge-first = Zuerst das Prüfnormal wählen.
choose-gauge-scanned = Das Prüfnormal wählen, das gescannt wird
choose-object-before-camera-if-one = das Objekt wählen, das vor der Kamera liegt; ist es dieses, nachsehen, ob seine Kanten sauber und unbeschädigt sind
choose-shorter-one = Einen kürzeren wählen
choose-what-use = Wählen, was in Gebrauch ist
chose-arm = den Messarm gewählt
chose-artefact = das Normal gewählt
chose-face = eine Fläche gewählt
chose-gauge = das Prüfnormal gewählt
chose-what-use = gewählt, was benutzt wird
chosen-gauge-has = das gewählte Prüfnormal hat { $diameter }
clamp-bar-firmly-reach-put-tip = Den Stab im Arbeitsraum festspannen, { $where }, und die Tastkugel in ein Ende setzen.
clamp-cone-ball-seat-about-two = Die Kegel- oder Kugelpfanne bei etwa zwei Dritteln der Reichweite festspannen und die Tastkugel hineinsetzen.
clamp-firmly-reach = Im Arbeitsraum festspannen, { $where }.
clamp-firmly-within-arms-reach-sphere = Fest in Reichweite des Messarms aufspannen. Eine Kugel zeigt am meisten; eine Ebene geht schneller.
clamp-seat-firmly-reach-put-tip = Die Pfanne im Arbeitsraum festspannen, { $where }, und die Tastkugel hineinsetzen.
clamp-seat-take-place-again-delete = Die Pfanne festspannen und diesen Ort neu aufnehmen oder seine Zeilen löschen
clamp-sphere = Kugel festspannen
clean-blocks-edges-check-focus-lighting = Die Kanten des Zinnenkörpers reinigen; Schärfe, Licht und Kalibrierschein prüfen.
clean-both-check-again = Beide reinigen und erneut prüfen.
clean-gauge-tip-check-clamps-verify = Prüfnormal und Tastkugel reinigen, die Spannung prüfen und erneut verifizieren; dann neu kalibrieren.
clean-tip-clamp-sphere = Tastkugel reinigen und die Kugel festspannen
clean-tip-seat-check-clamps-repeat = Tastkugel und Pfanne reinigen, die Spannung prüfen und wiederholen. Bleibt es so, den Messarm identifizieren.
clear-them-draw-them-again = Löschen und neu zeichnen.
clock = Uhr
clock-jumps-times-first-start-points =
    { $stream ->
        [joints]
            die Uhr der Gelenkwerte springt { $jumps ->
                [one] einmal, { $first } nach dem Beginn
               *[other] { $jumps }-mal, zuerst { $first } nach dem Beginn
            }; Punkte um einen Sprung können falsch liegen
       *[frames]
            die Uhr der Bilder springt { $jumps ->
                [one] einmal, { $first } nach dem Beginn
               *[other] { $jumps }-mal, zuerst { $first } nach dem Beginn
            }; Punkte um einen Sprung können falsch liegen
    }
clock-set-since-start-last =
    { $count ->
        [one] Die Uhr wurde seit dem Start einmal verstellt, um { $last_jump }.
       *[other] Die Uhr wurde seit dem Start { $count }-mal verstellt, zuletzt um { $last_jump }.
    }
close-other-programs-restart-station-between = Andere Programme schließen oder die Station zwischen zwei Scans neu starten.
close-program-second-station-same-port = Jenes Programm oder eine zweite Station am selben Anschluss schließen.
close-what-else-uses-machine = Schließen, was den Rechner sonst beansprucht.
cloud-of-another-shape = { $file }: Die Punkte liegen { $rms } (rms) um die { $shape ->
        [plane] Ebene
       *[sphere] Kugel
    }: Sie gehören kaum zu einer. Nur die Punktwolke des Normals angeben
cloud-of-odd-size = { $file } ist { $size } groß, wenn die Einheit { $unit } ist. Die Einheit mit --unit m, mm oder inch angeben
cloud = Wolke
cloud-being-scanned-already = Eine Wolke wird schon gescannt.
cloud-cloud = { $title }, Wolke für Wolke.
cloud-data-folder = Die Wolke von { $name } ist nicht im Datenordner
cloud-formats = Punktwolken werden als { $suffixes } geschrieben
cloud-has-no-points = sie enthält keine Punkte
cloud-has-points = Die Wolke hat { $points } Punkte
cloud-has-points-of = { $path } enthält { $count } von { $announced } Punkten
cloud-holds-usable-points =
    { $points ->
        [one] die Wolke enthält { $points } brauchbaren Punkt
       *[other] die Wolke enthält { $points } brauchbare Punkte
    }
cloud-name-proposal = Sie { $name } nennen
cloud-no-points-lie-rms-off =
    { $shape ->
        [sphere] Die Wolke ist keine Kugel: Ihre Punkte liegen { $rms } rms neben einer
       *[plane] Die Wolke ist keine Ebene: Ihre Punkte liegen { $rms } rms neben einer
    }
cloud-no-use = Wolke { $number } ist unbrauchbar.
cloud-not-as-scan-wrote-it = { $path } ist nicht so, wie ein Scan sie hinterlässt
cloud-plane = { $left_out } von Wolke { $number } gehören nicht zur Ebene.
cloud-rms-about-gauge = Wolke { $number }: { $rms } rms um das Prüfnormal.
cloud-shows-cap-sphere = Die Wolke zeigt eine Kappe von { $angle } der Kugel
cloud-strip-wide = Die Wolke ist ein { $width } breiter Streifen
clouds = { $done } von { $clouds_wanted } Wolken
clouds-2 = Wolken
clouds-enough = { $clouds_most } Wolken genügen.
clouds-rebuilt-every-calibration = Die Wolken sind mit jeder Kalibrierung neu berechnet.
code-wrong = Der Code ist falsch.
coefficient = Koeffizient
column-cell-is = { $place }: Spalte { $column } ist { $value }
column-empty = { $place }: Spalte { $column } ist leer
column-is = { $place }: { $column } ist { $value }
column-stands-there-twice = { $path }: Spalte { $names } kommt zweimal vor
columns-not-separated-by-commas = die Spalten sind nicht durch Kommas getrennt
come-nearer-object-fills-wanted = Näher kommen: Das Objekt füllt { $fills }, gewünscht { $least }
comes-after-calibration = Sie kommt nach der Kalibrierung.
compare-blocks-depth-heights-certificate = Tiefe und Höhen des Zinnenkörpers mit dem Kalibrierschein vergleichen.
complete-delete-row = Die Zeile ergänzen oder löschen
complete-or-delete-rows-of-position = Die Zeilen dieser Position ergänzen oder löschen
compute-calibration-take-another-pose = { $taken } Die Kalibrierung berechnen oder eine weitere Pose aufnehmen.
computer-behind-queue-full = Der Rechner kommt nicht nach: Seine Warteschlange ist zu { $share } voll
confirmed-devices = die Geräte bestätigt
confirmed-gauge = das Prüfnormal bestätigt
confirmed-object-picture = bestätigt, dass das Objekt im Bild ist
confirmed-touches = die Antastungen bestätigt
confirmed-what-use = bestätigt, was benutzt wird
connect-arm-calibrate-one = diesen Messarm anschließen oder mit dem jetzigen kalibrieren
connect-calibrate-one =
    { $device ->
        [arm] den passenden Messarm anschließen oder mit diesem kalibrieren
       *[sensor] den passenden Sensor anschließen oder mit diesem kalibrieren
    }
connected = Verbunden mit { $host }.
connected-2 = Seit { $duration } nicht mit { $host } verbunden: { CLAUSE($reason) }.
connected-3 = Verbunden: { $title }
connected-arm-has-joints = der angeschlossene Messarm hat { $joints } Gelenke
connected-arm-has-joints-has-choose = Der angeschlossene Messarm hat { $connected_joints } Gelenke, { $name } hat { $joint_count }. Den angeschlossenen Messarm wählen.
connected-has-serial-number =
    { $device ->
        [arm] der angeschlossene Messarm hat die Seriennummer { $serial_number }
       *[sensor] der angeschlossene Sensor hat die Seriennummer { $serial_number }
    }
connected-has-serial-number-chosen-datasheet = Der angeschlossene { $name } hat die Seriennummer { $serial_number }, das gewählte Datenblatt ist für { $serial_number2 }.
connected-sensors-picture-has-pixels-choose = Das Bild des angeschlossenen Sensors hat { $width_px } × { $height_px }, { $name } hat { $size } × { $size2 } Pixel. Den angeschlossenen Sensor wählen.
connected-yet = noch nicht verbunden
connecting = Wird verbunden: { $title }
contact-labelled-but-misses-face = Antastpunkt { $number } ist als „{ $face }“ bezeichnet, verfehlt diese Fläche aber um { $distance }
contact-off-by = { $number } ({ $face }, { $off })
contact-points = Antastpunkte
contact-unknown-face = Antastpunkt { $number } liegt auf einer unbekannten Fläche „{ $face }“
contacts = die Antastpunkte
contacts-agree-blocks-size-tips-diameter = Die Antastpunkte stimmen mit Größe des Zinnenkörpers und Tastkugeldurchmesser überein: { $checked }.
contacts-arm-has-no-tip = { $readings } Antastpunkte, und der Messarm { $name } hat keine Tastkugel
contacts-disagree-others-were-left-out =
    { $left_out ->
        [one] { $left_out } von { $count } Antastpunkten widerspricht den anderen und wurde ausgelassen: { $named }.
       *[other] { $left_out } von { $count } Antastpunkten widersprechen den anderen und wurden ausgelassen: { $named }.
    }
contacts-do-fix-objects-position = { $count } Antastpunkte legen die Lage des Objekts nicht fest
contacts-face-lie-one-line = die { $count } Antastpunkte { $where } liegen auf einer Geraden
contacts-fit-block-rms = { $count } Antastpunkte passen auf { $rms } rms zum Zinnenkörper.
contacts-fit-block-rms-only-all = die Antastpunkte passen nur auf { $rms } rms zum Zinnenkörper, { $beside } von { $count } gar nicht
contacts-fit-block-rms-up-good = { $count } Antastpunkte passen auf { $rms } rms zum Zinnenkörper; bis { $good } ist gut.
contacts-lie-beside-crests-floors-were = { $off_face } von { $contacts } Antastpunkten liegen neben den angetasteten Zinnen oder Nutgründen
contacts-lie-beside-face-they-labelled = { $beside } von { $count } Antastpunkten liegen neben der Fläche, mit der sie bezeichnet sind ({ $faces })
contacts-lie-board-rms = { $count } Antastpunkte liegen auf { $rms } rms auf der Tafel.
contacts-lie-board-rms-up-good = { $count } Antastpunkte liegen auf { $rms } rms auf der Tafel; bis { $good } ist gut.
contacts-lie-off-board-pictures-show = die { $touches } Antastpunkte liegen { $usual } neben der Tafel, die die Bilder zeigen
contacts-lie-than-blocks-size-tips =
    { $sign ->
        [apart]
            Die Antastpunkte auf { $pair ->
                [left] der linken und der rechten Stirnseite
               *[front] Vorder- und Rückseite
            } liegen { $opening } weiter auseinander, als Größe des Zinnenkörpers und Tastkugeldurchmesser ergeben (Grenze { $limit }).
       *[together]
            Die Antastpunkte auf { $pair ->
                [left] der linken und der rechten Stirnseite
               *[front] Vorder- und Rückseite
            } liegen { $opening } näher beieinander, als Größe des Zinnenkörpers und Tastkugeldurchmesser ergeben (Grenze { $limit }).
    }
contacts-pictures-agree-better-tip-than = Antastpunkte und Bilder passen besser zu einer Tastkugel von { $fitted } (± { $known }) als von { $given }.
contacts-pictures-agree-better-tips-centre = Antastpunkte und Bilder passen besser zu einer Tastkugelmitte, die { $off } neben der Stelle liegt, die in der Armdatei steht: um { $x }; { $y }; { $z } (± { $known }) im Flanschsystem. Gescannte Punkte können um ebenso viel falsch liegen.
contacts-rms =
    Antastpunkte, rms von { $count ->
        [one] { $count } Antastung
       *[other] { $count } Antastungen
    }
contacts-rms-outliers = Antastpunkte, rms von { $count } Antastungen, { $outliers } ausgelassen
contacts-scatter-times-what-arms-encoders = Die Antastpunkte streuen um { $sigma }, { $arm_excess }-mal so viel, wie die Messgeber des Arms erklären (Grenze { $excess }).
contacts-stripe-several-levels-need-crenellated = Antastungen und Laserlinie auf mehreren Ebenen brauchen einen Zinnenkörper
contacts-tips-sphere = Antastpunkte gehören zur Kugel eines Tasters
contacts-were-given-positions = { $count } Antastpunkte mit Orten { $shape } wurden angegeben
continue = Weiter
convention-is-pose = { $path }: convention ist 'pose'
convert-columns-degrees = Die Spalten in Grad umrechnen
convert-columns-x-mm-y-mm = Die Spalten x_mm, y_mm und z_mm in Millimeter umrechnen
convert-lengths-mm-name-columns = Längen in mm umrechnen und die Spalten { $names } nennen
convert-them-name-columns = Sie umrechnen und die Spalten { $first } bis { $last } nennen
coordinates = Dessen Koordinaten
copy-differs-from-source = Die Kopie ist nicht, was aus { $path } gelesen wurde
copy-whole-service-receives = Sie ganz aus dem empfangenden Dienst kopieren
corner = Ecke { $column },{ $row }
corners-can-measured = { $found } von { $corners } Ecken von „{ $name }“ lassen sich messen
corners-fix-camera-badly-condition-number = die { $points } Ecken legen die Kamera schlecht fest (Konditionszahl { $condition }, Grenze { $limit })
corners-fix-camera-weakly-condition-number = Die Ecken legen die Kamera schwach fest: Konditionszahl { $condition } (gut unter { $good }, abgelehnt über { $limit }).
corners-lie-off-regular-pattern-certificate = Die Ecken liegen { $off } neben einem regelmäßigen Muster, laut Kalibrierschein { $standard_uncertainty }: berücksichtigt.
corners-object-found = { $corners_detected } Ecken des Objekts sind gefunden.
corners-px = Ecken, px
corners-rms = Ecken, rms
corners-were-found = { $found } von { $corners } Ecken von „{ $name }“ wurden gefunden
corners-were-found-picture = { $points } Ecken wurden im Bild gefunden
corners-were-taken-others-do-belong = die Ecken wurden verwechselt oder gehören nicht zu diesem Objekt
corners-would-lie-behind-camera = { $behind } von { $points } Ecken lägen hinter der Kamera
correct-cell-delete-row = Die Zelle berichtigen oder die Zeile löschen
correct-it = Berichtigen
correct-name = Den Namen berichtigen
correct-option = { $key } berichtigen.
correct-remove-file = Die Datei berichtigen oder entfernen.
correct-sensor-exposure-us-take-out = { "[" }sensor] exposure_us berichtigen oder herausnehmen.
correct-sensor-take-out = { "[" }sensor] { $key } berichtigen oder herausnehmen.
correct-tips-diameter-arm-json-what = Den Durchmesser der Tastkugel in arm.json berichtigen oder die Angaben der Tabellen
correct-value-or-give-arm-json = Den Wert berichtigen oder die richtige arm.json angeben
correct-value-or-name-artefact-differently = Den Wert berichtigen oder einen anderen Prüfkörper anders benennen
correlated-known-together = Korreliert: gemeinsam bekannt, einzeln weniger gut
could-solved-what-taken-kept = Das ließ sich nicht berechnen. Was aufgenommen wurde, ist erhalten.
could-true-last-ago =
    { $count ->
        [one] { $count } war unmöglich, vor { $ago }: { CLAUSE($what) }.
       *[other] { $count } waren unmöglich, der letzte vor { $ago }: { CLAUSE($what) }.
    }
create-choose-another-place = Ihn anlegen oder einen anderen Ort wählen
crenel = Crenel { $version }
crest-z-mm-must-above-floor = crest_z_mm muss über floor_z_mm liegen und dieses über base_z_mm
crests-top = Zinnen (oben)
damaged = Sie ist beschädigt: { $trouble }.
dark-brightest-pixel = es ist dunkel: Sein hellster Pixel hat { $brightest } von { $full } Graustufen
data-folder = Datenordner
data-folder-any-more = { $name } ist nicht mehr im Datenordner.
data-folder-cannot-be-used = Der Datenordner { $folder } ist nicht verwendbar
data-folder-in-use = Der Datenordner { $folder } wird von einem anderen Crenel-Server benutzt (Prozess { $process })
data-speak-errors-arms-links-each = Die Daten sprechen für Fehler der Armglieder von je { $links } und { $turns }; was davon bleibt, macht { $share } der Unsicherheit eines Punkts aus.
database = Datenbank
database-cannot-be-written = in die Datenbank kann nicht geschrieben werden: { $error }
database-is-empty = { $database } ist leer
database-is-not-there = { $database } ist nicht da
database-not-damaged = die Datenbank der Station lässt sich dort nicht öffnen; beschädigt ist sie nicht
database-of-later-version = { $path } wurde von einer späteren Version von Crenel geschrieben (Schema { $version }, diese kennt { $known })
datasheet-lets-turn = nach seinem Datenblatt dreht es von { $low } bis { $high }
date = Datum
decision = Entscheidung
decision-rule-iso-14253-1-error = Entscheidungsregel nach ISO 14253-1: Die Durchmesserabweichung ist bestanden, wo sie um mehr als ihre erweiterte Unsicherheit (k = 2) nachweislich innerhalb der Grenze liegt; nicht bestanden, wo sie nachweislich jenseits liegt. Die Streuung wird unmittelbar mit ihrer Grenze verglichen.
decision-rule-iso-14253-1-pass = Entscheidungsregel nach ISO 14253-1: bestanden, wo der Wert um mehr als seine erweiterte Unsicherheit (k = 2) nachweislich innerhalb der Grenze liegt; nicht bestanden, wo er nachweislich jenseits liegt; sonst nicht entschieden.
decision-rule-limits-set-standard-uncertainty = Entscheidungsregel: Die Grenzen gelten für die Standardunsicherheit selbst und werden unmittelbar mit ihr verglichen, ohne Sicherheitsabstand.
decision-rule-max-min-2-each = Entscheidungsregel: (max − min)/2 jeder Achse wird unmittelbar mit der Grenze verglichen; es gibt keinen Sicherheitsabstand: Was die Form von Pfanne und Tastkugel beiträgt, ist nicht angegeben.
delay-would-known-all = der Verzug wäre gar nicht bekannt
delay-would-known-k-1 = der Verzug wäre auf { $u } bekannt (k = 1)
delete-one-rows = Eine der Zeilen löschen
delete-scans-under-records-use-larger = Scans im Archiv löschen oder einen größeren Datenträger benutzen.
delete-what-stands-there-twice = Die doppelten Zeilen löschen
deleted = { $name } wurde gelöscht
deleted-scan = einen Scan gelöscht
denavit-hartenberg-parameters-do-same = die Denavit-Hartenberg-Parameter leisten dasselbe
depth-mm = Tiefe, mm
deviations-distances-one = Abweichungen sind Abstände von einer
device-cannot-be-opened = { $title } lässt sich nicht öffnen
device-cannot-be-played = { $title } lässt sich nicht abspielen
device-closed = { $title } ist geschlossen
device-closed-while-opening = { $title } wurde beim Öffnen geschlossen
device-failed = { $title } ist gescheitert: { $error }
device-lost = { $title } ging verloren
device-not-open = { $title } ist nicht offen
devices = Geräte
diameter = Durchmesser
diameter-of-tip-by-datasheet = Tastkugeldurchmesser nach dem Datenblatt
diameter-tip-found = Gemessener Tastkugeldurchmesser
did-you-mean = Meinen Sie { $name }?
disk = Datenträger
disk-fails = Der Datenträger von { $folder } liest oder schreibt nicht, wie er soll
disk-fails-takes-every-calibration-scan = Ein defekter Datenträger nimmt jede Kalibrierung und jeden Scan mit.
disk-full = der Datenträger ist voll
disk-full-during-scan = Der Datenträger war während dieses Scans voll.
disk-of-backup-loses-data = der Datenträger der Sicherung speichert nicht, was darauf geschrieben wird
disk-of-data-folder-full = Der Datenträger des Datenordners { $folder } ist voll
disk-of-folder-full = Der Datenträger von { $folder } ist voll
disk-quota-used-up = das Speicherkontingent ist aufgebraucht
disk-read-only = der Datenträger ist schreibgeschützt
disks-largest-file-size-reached = die größte Dateigröße des Datenträgers ist erreicht
distance = Abstand
distance-between-clouds = Abstand zwischen Wolken
distance-between-clouds-centres = Abstand zwischen den Mittelpunkten der Wolken
distance-each-touch-face-times-larger = Abstand jeder Antastung von ihrer Fläche, { $factor }-fach vergrößert: Blau außen, Orange innen, Kreuze ausgelassen. Der längste Strich ist { $largest } ({ $largest_mm }).
distance-each-touch-sphere-through-all = Abstand jeder Antastung von der Kugel durch alle.
distance-fitted-shape-blue-outside-orange = { $name }: Abstand von der angepassten Form, Blau außen, Orange innen.
distance-out-of-range =
    { $side ->
        [near] Zu nah: { $distance }, gewünscht { $low } bis { $high }
       *[far] Zu weit: { $distance }, gewünscht { $low } bis { $high }
    }
distance-touched-centre = Abstand vom angetasteten Mittelpunkt
distance-touched-plane = Abstand von der angetasteten Ebene
distortion = Verzeichnung
distortion-not-invertible = die Verzeichnung lässt sich nicht im ganzen Bild umkehren
document-format = { $path }: format ist { $format }
document-version = { $path }: version ist { $version }
does-not-take-exposure = { $title } nimmt eine Belichtung von { $exposure } nicht an
does-take = { $path } nimmt { $method } nicht an.
does-take-notifications-given-up = { $host } nimmt Benachrichtigungen nicht an: { $trouble } ({ $failed } aufgegeben).
done = Fertig
draw-over-part-cloud = es über einen Teil der Wolke ziehen
draw-pictures-of-each-folder-apart = Die Bilder jedes Ordners für sich zeichnen
driver-cannot-be-loaded = Der Treiber { $name } ({ $table }) aus { $package } lässt sich nicht laden: { $kind }: { $error }
driver-not-callable = Der Treiber { $name } ({ $table }) aus { $package } lässt sich nicht aufrufen: { $value }
driver-offered = Den Treiber { $name } ({ $table }) bieten mehrere an: { $packages }
driver-takes = Er nimmt { $names }.
drivers-are = Vorhandene Treiber: { $names }.
drop-cloud = Diese Wolke verwerfen
drop-last-place = Letzten Ort verwerfen
dropped-cloud = eine Wolke verworfen
dropped-seat = einen Sitz verworfen
dropped-swing = einen Schwenk verworfen
dropping-cloud = Wolke wird verworfen
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
each-point-needs-three-coordinates-one = jeder Punkt braucht drei Koordinaten und einen Pixel (u, v)
each-point-swing-about-middle-all = Jeder Punkt des Schwenks um die Mitte aller, im Koordinatensystem des Messarms.
each-touchs-distance-sphere = Abstand jeder Antastung von der Kugel
edge-of-base =
    { $side ->
        [left] die linke Kante der Grundfläche
        [right] die rechte Kante der Grundfläche
        [front] die vordere Kante der Grundfläche
       *[back] die hintere Kante der Grundfläche
    }
edge-of-crest =
    { $side ->
        [left] die linke obere Kante der Zinne { $number }
        [right] die rechte obere Kante der Zinne { $number }
        [front] die vordere obere Kante der Zinne { $number }
       *[back] die hintere obere Kante der Zinne { $number }
    }
edge-of-floor =
    { $side ->
        [left] die linke Kante des Grunds der Nut { $number }
        [right] die rechte Kante des Grunds der Nut { $number }
        [front] die vordere Kante des Grunds der Nut { $number }
       *[back] die hintere Kante des Grunds der Nut { $number }
    }
edge-width = Kantenbreite
edges-corners = Kanten und Ecken
edges-corners-rms = Kanten und Ecken, rms
edges-lie-off-average-where-certificate = seine Kanten liegen im Mittel { $usual }, { $edge } { $distance } neben dem Ort des Kalibrierscheins
edges-px = Kanten, px
edges-would-fit-only-if-cameras = seine Kanten passten nur, wenn die Pixel der Kamera um { $off_square } vom Quadrat abwichen
edges-would-fit-only-lens-distorted = seine Kanten passten nur zu einem Objektiv mit der Verzeichnung k1 = { $k1 }, k2 = { $k2 }
edges-x-mm-must-ascend-follows = edges_x_mm muss ansteigen: { $right } folgt auf { $left }
edges-x-mm-odd-count =
    edges_x_mm enthält { $count ->
        [one] { $count } Kante
       *[other] { $count } Kanten
    }; jede Zinne hat zwei, eine linke und eine rechte
empty = sie ist leer
encoder-stands-still-switch-arm-off = sein Messgeber bewegt sich nicht: Messarm aus- und einschalten und das Kabel des Gelenks prüfen
end-cloud = Wolke beenden
end-name = Den Namen mit .html oder .pdf enden lassen
ended = sie beendet
ended-token-metrics = einen Schlüssel für Messwerte beendet
enough-places = Genug Orte
entered-consoles-code = mit dem Code der Konsole eingetreten
entered-the-temperature = die Temperatur angegeben
entry-point-must-name-function-takes = Sein Einstiegspunkt muss eine Funktion nennen, die die Optionen nimmt.
error = Abweichung
error-budget = Unsicherheitsbudget
error-budget-with-limits = Quellen der Standardunsicherheit (k = 1) eines gescannten Punkts. Grenzen: gut bis { $good }, brauchbar bis { $usable }.
error-in-column = Spalte { $place }
error-in-row = Zeile { $place }
error-radius = Radiusabweichung
error-there-something-program-did-foresee = Ein Fehler dort ist etwas, was das Programm nicht vorhersah.
error-what = { CLAUSE($what) }.
error-what-and-why = { CLAUSE($what) }: { CLAUSE($why) }.
errors-arms-own-model-joint-angles = Fehler des Armmodells selbst, Gelenkwinkel, die nicht die des Bildes sind, und ein Objekt, das seit dem Antasten bewegt wurde, sind aus einem Bild in einer Pose nicht zu sehen und stecken nicht in dieser Zahl.
errors-last-hour =
    { $count ->
        [0] Kein Fehler in der letzten Stunde.
        [one] Ein Fehler in der letzten Stunde.
       *[other] { $count } Fehler in der letzten Stunde.
    }
even-best-arm-points-still-scatter = selbst mit dem besten Armmodell streuen die Punkte noch um { $scatter }
every-figure-keeps-limit = Jede Kenngröße hält ihre Grenze ein.
every-figure-keeps-limit-2 = Nicht jede Kenngröße hält ihre Grenze ein.
every-figure-known-well-enough-judged = Nicht jede Kenngröße ist genau genug bekannt, um sie zu beurteilen.
every-file-has-content-result-made = Jede Datei hat den Inhalt, aus dem das Ergebnis entstand.
every-reading-joints-could-true = Jeder Messwert der Gelenke war möglich.
every-stripe-pictures-wait-them = Jede Laserlinie ist darin; Bilder warten auf sie.
everything-grows-metre-aluminium = Alles wächst mit ihr, ein Meter Aluminium um { $growth } je Grad.
exceed-limit-m = { $half_range } überschreiten die Grenze von { $limit }.
expanded-uncertainty-note = U = { $expanded_uncertainty }, k = 2
expected = { $wanted } wird erwartet
expected-by-datasheet-and-expanded-uncertainty = { $expected } nach dem Datenblatt; U = { $expanded_uncertainty }, k = 2
exposure-set-lasers-line = Die Belichtung richtet sich nach der Laserlinie
extracting-laser-stripe = Laserlinie wird ausgewertet
extraction-detection = Extraktion und Erkennung
face-3 = Fläche
face-and-number = { $face } { $number }
face-can-turn-about-line = die Fläche kann sich um diese Gerade drehen
face-has-points-go = Diese Fläche hat ihre Punkte. Weiter mit: { $face }.
faces-agree-to = { $first } und { $second } auf { $opening }
faces-are = die Flächen sind { $names }
faces-contacts = { $faces } Flächen für { $contacts } Antastpunkte
fail = Nicht bestanden
failed-2 = { $title }: gescheitert
far-out = weit außen
fault = Ursache: { CAPITAL($fault) }. { $text }
feature-given-single-scanned-point-iso = Für ein Merkmal, das ein einzelner gescannter Punkt bestimmt, beweist ISO 14253-1 mit ihren voreingestellten 95 % die Konformität, wo der Punkt um { $guard } ({ $guard_mm }, { $factor } Standardunsicherheiten) innerhalb der Toleranz bleibt; die Nichtkonformität ebenso weit außerhalb.
field-is = { $path }: { $place } ist { $value }
field-missing =
    { $more ->
        [0] { $path }: { $place } fehlt
       *[other] { $path }: { $place } fehlt (und { $more } weitere)
    }
field-must-be-less-than-half-square = { $field } muss kleiner als ein halbes Feld sein; ist es in Mikrometern angegeben?
figure = Kenngröße
figure-beyond-limit = { $title }: { $value }, jenseits der Grenze von { $limit }, um mehr als die Unsicherheit von { $uncertainty } (k = 2).
figure-near-limit = { $title }: { $value }, näher an der Grenze von { $limit } als die Unsicherheit von { $uncertainty } (k = 2), daher nicht entschieden.
figure-within-limit = { $title }: { $value }, innerhalb der Grenze von { $limit }, um mehr als die Unsicherheit von { $uncertainty } (k = 2).
figures-against-their-limits = Die Kenngrößen gegen ihre Grenzen
figures-before = { $text }: Die Zahlen sind von vorher.
figures-break-limits-not-compared = Nicht jede Kenngröße hält ihre Grenze ein; Scan und Taster wurden nicht verglichen.
figures-keep-limits-not-compared = Jede Kenngröße hält ihre Grenze ein; Scan und Taster wurden nicht verglichen.
figures-undecided-not-compared = Nicht jede Kenngröße ist genau genug bekannt, um sie zu beurteilen; Scan und Taster wurden nicht verglichen.
file = eine Datei
file-4 = Datei
file-carries-no-verdict = Die Datei enthält kein Urteil.
file-cut-off = die Datei wurde abgeschnitten
file-damaged = die Datei wurde beschädigt
file-has-name-folder-needed = eine Datei trägt den Namen eines Ordners, der gebraucht wird
file-has-no-contact-points = { $path } enthält keine Antastpunkte
file-has-no-pictures = { $path } enthält keine Bilder
file-has-no-points = { $path } enthält keine Punkte
file-larger-than-any-read = nichts, was hier gelesen wird, ist so groß
file-name-is-not-utf-8 = Der Name von { $name } ist kein UTF-8-Text
files-data-folder-any-more = ihre Dateien sind nicht mehr im Datenordner
files-searched = Gesucht wird nach { $suffixes }.
finding-objects-edges = Kanten des Objekts werden gesucht
finding-start = Startwerte werden gesucht
finding-what-and-why = { CAPITAL(CLAUSE($what)) }: { CLAUSE($why) }
findings = Befunde
finish-cloud-drop = Diese Wolke beenden oder verwerfen.
finish-cloud-first = Zuerst diese Wolke beenden.
finish-sphere = Kugel abschließen
finish-swing = Schwenk beenden
finished-cloud = eine Wolke abgeschlossen
finished-seat = einen Sitz abgeschlossen
finite-number-decimal-point-expected = eine endliche Zahl mit Dezimalpunkt wird erwartet
firmware-must-answer-hello = Seine Firmware muss die Hello-Anfrage beantworten (hardware/arm/protocol.py).
firmware-must-send-counts-of-hello = Seine Firmware muss so viele Werte senden, wie ihr Hello ankündigt.
first-line-names = die erste Zeile nennt { $names }
first-line-names-column-count =
    die erste Zeile nennt { $count ->
        [one] { $count } Spalte
       *[other] { $count } Spalten
    }
fit-does-settle = die Anpassung konvergiert nicht
fit-follows-these-points-arm = die Anpassung folgt diesen Punkten und nicht dem Messarm
fit-plane-sphere-cylinder-first = zuerst eine Ebene, eine Kugel oder einen Zylinder anpassen
fitting =
    { $shape ->
        [plane] Eine Ebene wird angepasst
        [sphere] Eine Kugel wird angepasst
       *[cylinder] Ein Zylinder wird angepasst
    }
fitting-arm = Der Messarm wird angepasst
fitting-contact-points = Antastpunkte werden angepasst
fix-board-flat-plate = Die Tafel auf einer ebenen Platte befestigen.
fix-board-so-cannot-rock-warp = Die Tafel so befestigen, dass sie nicht wackeln oder sich verziehen kann, und das Objektiv feststellen.
fix-object-arm-so-neither-can = Objekt und Arm so befestigen, dass sich keines bewegen kann, das Objekt antasten und die Bilder noch einmal aufnehmen.
flange-differs = der Flansch weicht um { $moved } ab
flange-turned-most-between-poses = der Flansch drehte sich zwischen den { $count } Posen höchstens um { $turn }
flanges-frame-now-arms-calibrations-made = Das Flanschsystem ist nun das dieses Messarms: Kalibrierungen mit dem Messarm von vorher gehören nicht dazu.
flat-board-tells-cameras-focal-length = eine ebene Tafel bestimmt die Brennweite der Kamera ab { $fewest_poses } Bildern, die gegeneinander geneigt sind
floors-grooves = Nutgründe
focal-length = Brennweite
focal-lengths = { $u } × { $v }
focus-camera-object-bring-into-working = die Kamera auf das Objekt scharfstellen, es in den Arbeitsabstand bringen, still halten
focus-camera-object-bring-into-working-2 = die Kamera auf das Objekt scharfstellen, es in den Arbeitsabstand bringen und still halten
focus-light-board-evenly = scharf stellen und die Tafel gleichmäßig beleuchten
folder-cannot-be-written = in den Ordner { $folder } kann nicht geschrieben werden
folder-has-none-of = er enthält nichts von { $names }
folder-inside-data-folder = { $folder } liegt im Datenordner
folder-named = Der Ordner { $folder }
folder-their-own = in einem eigenen Ordner
folder-there-already = { $folder } gibt es schon
folders-next-to-it-not-empty = daneben liegen Daten, in { $folders }
form-95-m = Form 95 %, µm
form-cloud-95-points = Form der Wolke (95 % der Punkte)
form-max-min-m = Form (max − min), µm
format-expected = { $format } wird hier erwartet
frame-has-pixels = { $path }: Bild { $number } hat { $width_px } × { $height_px } Pixel
frame-shows-only-s-visible-edges = das Bild zeigt nur { $share } der sichtbaren Kanten von „{ $name }“
frame-without-joints-around-gives-no = Ein Bild ohne Gelenkwerte darum gibt keine Punkte.
frames-joint-samples-which-neighbours-up = Bilder von { $frames_from } bis { $frames_to }, Gelenkwerte von { $joints_from } bis { $joints_to }, von denen Nachbarn bis { $gap } Abstand benutzt werden
frames-left-out-no-joints-around = { $count } von { $frames } Bildern ausgelassen: keine Gelenkwerte um ihre Zeitstempel, das erste { $first } nach dem Beginn; { $beyond } vor dem ersten oder nach dem letzten Wert, { $gaps } in Lücken
frames-lost-when-full-scan-more = Wenn sie voll ist, gehen Bilder verloren; langsamer scannen oder andere Programme schließen.
free = { $free } sind frei.
free-enough-for-hours = { $free } sind frei, genug für { $hours } Stunden dieses Scans.
free-on-disk = { $free } sind auf dem Datenträger von { $folder } frei
free-some-space = Platz schaffen
free-some-space-choose-another-disk = Platz schaffen oder einen anderen Datenträger wählen
free-some-space-start-again = Speicherplatz freigeben und neu starten
free-some-space-then-do-again = Schaffen Sie Platz, dann noch einmal
free-some-space-try-again = Platz schaffen und erneut versuchen
from = Von
from-to = { $low } bis { $high }
front = von vorn
front-face = Vorderseite
front-y-mm-must-less-than = front_y_mm muss kleiner als back_y_mm sein
further-cloud-aside-one-other-s =
    { $aside ->
        [one] { $aside } weitere Wolke wurde nicht benutzt.
       *[other] { $aside } weitere Wolken wurden nicht benutzt.
    }
gauge = Prüfnormal
gauge-clamped = Dieses Prüfnormal ist aufgespannt
gauge-shape = { $path }: shape ist { $shape }
gauge-touched-only-shape-size-judged = Das Prüfnormal wurde nicht angetastet: Nur Form und Größe werden beurteilt.
gauge-touched-shape-size-only = das Prüfnormal wurde nicht angetastet: nur Form und Größe
gauges-are-plane-or-sphere = Prüfnormale sind eine Ebene oder eine Kugel
gave-no-picture-within = { $title } gab innerhalb { $time } kein Bild
give-arm-json-arm-took = Die arm.json des Messarms angeben, der dies aufgenommen hat
give-arm-json-arm-took-recording = Die arm.json des Messarms angeben, der dies aufgezeichnet hat
give-arms-own-model-columns = Das Modell dieses Arms angeben, oder die Spalten { $names }
give-calibration-sensor-took-recording = Die Kalibrierung des Sensors angeben, der dies aufgezeichnet hat
give-cameras-own-picture = Das eigene Bild der Kamera angeben
give-certificate-board-picture = den Kalibrierschein der Tafel im Bild angeben
give-certificate-crenellated-object-calibrate-command = Den Kalibrierschein eines Zinnenkörpers angeben oder auf der Kommandozeile kalibrieren
give-certificate-first =
    { $kind ->
        [bar] Zuerst die Länge des Stabs nach seinem Kalibrierschein angeben.
       *[sphere] Zuerst den Durchmesser der Kugel nach ihrem Kalibrierschein angeben.
    }
give-cloud-millimetres = Eine Punktwolke in Millimetern angeben
give-denavit-hartenberg-model = Das Denavit-Hartenberg-Modell des Messarms angeben (convention 'dh-standard')
give-each-own-name-station-mqtt = Jeder mit station in [mqtt] der station.toml einen eigenen Namen geben.
give-each-seat-name-own = Jeder Pfanne einen eigenen Namen geben
give-files-belong-together = Die Dateien angeben, die zusammengehören
give-folder-station-started = Den Ordner angeben, mit dem die Station gestartet wurde
give-folder-user-may-write-data = Mit --data einen Ordner angeben, in den dieser Benutzer schreiben darf
give-gauges-own-nominal = Die Sollwerte dieses Prüfnormals angeben
give-length-mm-bar-millimetres-check = length_mm von Stab { $name } in Millimetern angeben und seine Zeilen prüfen
give-mask-sensor-took-picture = Die Maske des Sensors angeben, der dieses Bild aufgenommen hat
give-more-recordings-plane-more-calibrations = Mehr Aufzeichnungen der Ebene oder mehr Kalibrierungen angeben
give-one-first = Zuerst eine angeben
give-one-number-all-joints-one = Eine Zahl für alle Gelenke angeben oder für jedes eine.
give-picture-as-taken-and-sensor-json = Das Bild so angeben, wie die Kamera es aufgenommen hat, und die richtige sensor.json
give-planes-own-nominal = Die Sollwerte der Ebene angeben
give-qx-qy-qz-qw-order = qx, qy, qz, qw in dieser Reihenfolge angeben, den Skalar zuletzt
give-recording-as-documented = Eine Aufzeichnung angeben, wie docs/formats.md sie beschreibt
give-right-arm-json-columns = Die richtige arm.json angeben oder die Spalten { $first } bis { $last }
give-right-file = Die richtige Datei angeben
give-rows-different-pose-numbers-take = Den Zeilen verschiedene Posennummern geben oder die Bilder neu aufnehmen
give-seat-own-name-check-arm-json = Jeder Pfanne einen eigenen Namen geben; arm.json prüfen
give-standard-uncertainty-of-certificate = Die Standardunsicherheit (k = 1) des Kalibrierscheins in Millimetern angeben
give-station-data-folder-own = Geben Sie der Station einen eigenen Datenordner
give-tip-or-leave-out-probing = die Tastkugel in arm.json angeben oder probing.csv weglassen
go-back-take-picture-points-again = Zurückgehen und das Bild oder die Punkte neu aufnehmen.
go-calibrating = Weiter kalibrieren
go-faster = Schneller fahren, { $speed } oder mehr
go-faster-farther-over-plate-nearer = Schneller und weiter über die Platte fahren, mehrmals näher und wieder weiter weg
go-further-away-object-does-fit = Weiter weg: Das Objekt passt nicht hinein
go-over-these-places-again-slower = Diese Stellen noch einmal überfahren, langsamer.
go-pictures-touches-spread-over-printed = Weiter zu den Bildern. { $wanted } Antastpunkte, über die bedruckte Seite verteilt, würden die Größe der Felder prüfen.
go-pose-count-one-other-s =
    { $count ->
        [one] Weiter mit { $count } Pose
       *[other] Weiter mit { $count } Posen
    }
go-scanning = Weiter zum Scannen
go-slower-shorten-exposure = Langsamer fahren oder kürzer belichten.
go-swinging-least-points = Weiter schwenken: { $taken } von mindestens { $least } Punkten.
go-verifying = Weiter verifizieren
go-without-probe = Ohne Taster weiter
goes-beyond-end =
    { $side ->
        [right] { $edge } geht über ihr rechtes Ende hinaus
       *[left] { $edge } geht über ihr linkes Ende hinaus
    }
good = Gut
good-m-usable-m = gut ≤ { $good }, brauchbar ≤ { $usable }
good-up-m = gut bis { $limit }
grey-encodings-expected = Grau wird erwartet: { $encodings }
grey-levels = Graustufen
guided-steps = Geführte Schritte
had-calculated = rechnen lassen
had-simulation-pass-over-plate = die simulierte Fahrt über die Platte gestartet
half-them-more-contradicting-others-none = wenn die Hälfte von ihnen oder mehr den anderen widerspricht, ist keiner zu trauen
simulation-goes = Der simulierte Bediener geht zu: { $name }
simulation-goes-next-pose = Der simulierte Bediener geht zur nächsten Pose: { $words }
simulation-holds-sensor-over-object = Der simulierte Bediener hält den Sensor über das Objekt
simulation-holds-still = Der simulierte Bediener hält still
simulation-moving = Der simulierte Bediener bewegt sich nicht.
simulation-scanning = Der simulierte Bediener scannt
simulation-scans = Der simulierte Bediener scannt: { $part }
simulation-scans-cloud = Der simulierte Bediener scannt: { $name }, Wolke { $done }
simulation-swings-arm-about = Der simulierte Bediener schwenkt den Messarm um: { $name }
simulation-touches = Der simulierte Bediener tastet an: { $face }
simulation-touches-2 = Der simulierte Bediener tastet an: { $name }
simulation-touches-sphere = Der simulierte Bediener tastet die Kugel an
simulation-work = Der simulierte Bediener läuft
hands-point-face-declined-times = Punkt { $index } des simulierten Bedieners { $where } wurde { $attempts }-mal abgelehnt
hands-touch-declined-times = Antastung { $index } des simulierten Bedieners wurde { $attempts }-mal abgelehnt
has-control = { $name } hat die Bedienung
has-control-in-another-browser = { $name } hat die Bedienung in einem anderen Browser
has-control-now = { $name } hat jetzt die Bedienung.
has-coordinate = { $path } hat eine Koordinate von { $coordinate }
has-joint-columns =
    { $count ->
        [0] { $path } hat keine Gelenkspalten
        [one] { $path } hat { $count } Gelenkspalte ({ $names })
       *[other] { $path } hat { $count } Gelenkspalten ({ $names })
    }
has-mm =
    { $kind ->
        [bar] Für einen Stab sind { $low } bis { $high } zulässig.
       *[sphere] Für eine Kugel sind { $low } bis { $high } zulässig.
    }
has-points = { $label } hat { $count } Punkte
has-touches =
    { $shape ->
        [sphere] Die Kugel hat { $count } Antastungen
       *[plane] Die Ebene hat { $count } Antastungen
    }
have-arms-calibration-checked-hold-compact = Die Kalibrierung des Messarms prüfen lassen; ihn gedrungen halten.
height-above-touched-plane-along-z = Höhe über der angetasteten Ebene, entlang Z
height-of-level =
    { $level ->
        [base] die Höhe seiner Grundfläche
        [floors] die Höhe seiner Nutgründe
       *[crests] die Höhe seiner Zinnen
    }
held-out-places-fit-did-see = Zurückgehalten: an { $places } Orten, die die Ausgleichung nicht benutzte, { $how }; das Rauschen der Winkelgeber ist enthalten. In Standardabweichungen der Punkte { $before } vorher und { $after } nachher; 1 wäre das Rauschen allein.
held-out-turn = reihum zurückgehalten
held-up-live-numbers-stand-press = Wenn sie aufgehalten wird, stehen Anzeigen, und ein Druck wird spät beantwortet; Geräte werden weiter gelesen.
held-up-more-than-longest =
    { $count ->
        [one] einmal länger als { $limit } aufgehalten, { $longest } lang
       *[other] { $count }-mal länger als { $limit } aufgehalten, am längsten { $longest }
    }
high-up = hoch oben
higher-by = { $distance } höher
hold = Halten
hold-2 = so halten, wie er ist
hold-arm-still = Den Messarm still halten. { $text }.
hold-arm-still-2 = Den Messarm still halten.
hold-sensor-over-object = Den Sensor über das Objekt halten
hold-sensor-over-object-another-way = Den Sensor anders als bisher über das Objekt halten.
hold-sensor-over-object-so-lies = Den Sensor so über das Objekt halten, dass es etwa wie der gestrichelte Umriss liegt.
hold-sensor-straight-above-chessboard-longer = Den Sensor senkrecht über das Schachbrett halten, dessen längere Seite längs im Bild.
hold-still = Still halten
hold-still-again = noch einmal, still halten
hold-still-take-picture-laser-switches = Still halten und das Bild aufnehmen. Der Laser schaltet sich selbst.
hold-there = So halten
holds-journal-every-step-accounts-what = Sie enthält das Journal jedes Schritts, die Konten und welche Kalibrierung in Gebrauch ist.
holds-more-than-frames = { $path } enthält mehr als { $most } Bilder
holds-no-record-one = er enthält keine Aufzeichnung davon
holds-no-topics = { $path } enthält keine Topics
holds-topics = { $path } enthält { $topics }
host-not-known = Der Rechner in { $url } ist nicht bekannt
how-arm-swung = Wie der Arm schwenkte
how-sensor-sits-flange-shows-only = wie der Sensor am Flansch sitzt, zeigt sich nur, wenn der Flansch sich dreht: mindestens drei Posen, um zwei verschiedene Achsen gedreht
http-status = Status { $status }
identification-arm = Identifikation des Messarms
identified = Identifiziert
identified-arm-use = Der identifizierte Messarm ist in Gebrauch.
identify-arm = Messarm identifizieren
identify-arm-first = Zuerst den Messarm identifizieren.
identify-arm-folders-again = Den Messarm aus { $arm } des Ordners erneut identifizieren
identify-arm-take-more-know-better = Den Messarm identifizieren oder mehr aufnehmen, um ihn genauer zu kennen.
identifying-arm = Messarm wird identifiziert
image-encoding = { $name }: Kodierung { $encoding }
image-ends-after-bytes =
    { $name } endet nach { $bytes ->
        [one] { $bytes } Byte
       *[other] { $bytes } Bytes
    }
image-has-depth = { $name } enthält { $depth }
image-has-pixels = { $name } hat { $width } × { $height } Pixel
image-in-colour = { $name } ist ein Farbbild
image-processing = Bildverarbeitung
image-shape-type = ein Bild der Form { $shape } und des Typs { $dtype }
inner-corners-mm-apart = { $columns } × { $rows } innere Ecken, Abstand { $square }, { $known }
inputs = Eingangsdaten
install-version-later-one = Diese Version oder eine spätere installieren
is-file-complete = Ist die Datei vollständig?
is-it-a-complete-video = Ist es ein Video und vollständig?
is-it-there-and-complete = Ist es da und vollständig?
is-no-station-database = { $path } lässt sich nicht als Datenbank einer Station lesen
is-of = { $path } gehört zu { $device } { $of }
is-to-be-verified =
    { $shape ->
        [sphere] eine Kugel soll geprüft werden
       *[plane] eine Ebene soll geprüft werden
    }
it-is-a-file = es ist eine Datei
it-is-a-folder = es ist ein Ordner
it-is-no-ordinary-file = es ist eine Pipe, ein Socket oder ein Gerät
joint = Gelenk
joint-adjustment-all-poses = gemeinsame Ausgleichung aller Posen
joint-angle-number = { $name }: Ein Gelenkwinkel ist keine Zahl
joint-angles = { $name }: { $count } Gelenkwinkel
joint-angles-given-degrees = Gelenkwinkel werden in Grad angegeben
joint-at-stamp = { $path } bei { $stamp_ns } ns: Gelenk { $joint } steht auf { $reading }
joint-column-differs = q{ $joint }_deg weicht um { $moved } ab
joint-jumped-stayed-there = Gelenk { $joint } ist um { $step } gesprungen und dort geblieben
joint-name-twice = zwei Gelenke heißen { $name }; Aufzeichnungen unterscheiden Gelenke am Namen
joint-range = es dreht von { $low } bis { $high }
joint-range-in-radians = es dreht von { $low } bis { $high }; dies sind Grad, erwartet werden Radiant
joint-reads = Gelenk { $joint } meldet { $reading }
joint-reads-again-again = Gelenk { $joint } meldet immer wieder { $reading }
joint-reads-no-number = Gelenk { $joint } meldet keine Zahl
joint-reads-off-readings-before-after = Gelenk { $joint } meldet { $reading }, { $step } neben seinen Messwerten davor und danach
joint-reads-same-all-points = Gelenk { $joint } zeigt in allen Punkten dasselbe
joint-reads-where-can = Gelenk { $joint } meldet { $reading }, { $step } neben dem, wo es sein kann
joint-samples-left-out-cannot-true =
    { $count ->
        [one] { $count } unmöglicher Gelenkwert ausgelassen, { $first } nach dem Beginn: { CLAUSE($error) }
       *[other] { $count } unmögliche Gelenkwerte ausgelassen, der erste { $first } nach dem Beginn: { CLAUSE($error) }
    }
joint-samples-left-out-numbers =
    { $unusable ->
        [one] { $unusable } Gelenkwert ausgelassen: keine Zahl
       *[other] { $unusable } Gelenkwerte ausgelassen: keine Zahlen
    }
journal-has-rows-cannot-read-first =
    { $count ->
        [one] Das Journal hat { $count } Zeile, die nicht zu lesen ist: Zeile { $first }.
       *[other] Das Journal hat { $count } Zeilen, die nicht zu lesen sind, zuerst Zeile { $first }.
    }
json-cut-off = es ist kein JSON oder wurde abgeschnitten: { $reason }
json-cut-off-line = es ist kein JSON oder wurde abgeschnitten: { $reason } in Zeile { $line }
json-object-expected = ein JSON-Objekt { "{" } … { "}" } wird erwartet
judged = Nicht beurteilt
keep-arm-json-use = Die arm.json in Gebrauch behalten
keep-data-folder-start-earlier-backup = Den Datenordner behalten, wie er ist, und mit einer früheren Sicherung starten
keep-reflections-out-grooves-matt-spray = Spiegelungen aus den Nuten fernhalten: Mattierungsspray, kürzere Belichtung.
keep-tip-seat-swing-elbow-one = Die Tastkugel in der Pfanne lassen. Den Ellbogen von einer Seite zur anderen und zurück schwenken und das Handgelenk in alle Richtungen neigen.
keeps-control = { $name } behält die Bedienung.
kept-2 = Beibehalten
kept-picture = das Bild behalten
kind-chessboard-not-supported = { $path }: kind 'chessboard' geht hier nicht
kind-is-crenellated-or-chessboard = es ist 'crenellated' oder 'chessboard'
kind-unknown = { $path }: kind { $kind } ist unbekannt
known-k-1 = bekannt auf { $known } (k = 1)
known-limit-is = { $known }; { $limit } ist die Grenze
known-m-k-1-form-m = { $certificate }; bekannt auf { $known } (k = 1), Form { $form }
largest-distance = Größter Abstand
largest-distance-touch-sphere = Größter Abstand einer Antastung von der Kugel
largest-max-min-2 = Größtes (max − min)/2
largest-swing = { $points }, größter Schwenk { $swing }
laser-beside-object-may-too-dark = Der Laser ist an, und daneben ist das Objekt vielleicht zu dunkel, um gefunden zu werden.
laser-colour-not-known = die Farbe des Lasers, in deren Kanal gemessen würde, ist nicht angegeben
laser-line-left-out-off-plane = ihre Laserlinie wurde ausgelassen, { $off } neben der Ebene der anderen
laser-line-lies-off-plane-others = ihre Laserlinie liegt { $off } neben der Ebene der anderen
laser-off = der Laser ist aus
laser-off-2 = Der Laser ist aus
laser-off-covered-beside-object-too = der Laser ist aus, verdeckt, neben dem Objekt oder zu schwach für diese Belichtung
laser-off-too-weak-does-cross = der Laser ist aus, zu schwach oder kreuzt das Objekt nicht
laser-off-too-weak-part-out = der Laser war aus, zu schwach oder das Teil außer Reichweite
laser-on-or-expose-longer = Den Laser einschalten oder länger belichten
laser-plane = Laserebene
laser-stripe-sensor-measuring-arm = Lichtschnittsensor an einem Messarm
laser-stripe-shows-points-s =
    { $missing ->
        [crest] die Laserlinie zeigt { $count } Punkte auf den Zinnen
       *[floor] die Laserlinie zeigt { $count } Punkte auf den Nutgründen
    }
laser-wavelength = Laser { $wavelength }
lasers-line-lies-board-pictures = die Laserlinie liegt in { $enough } von { $views } Bildern auf der Tafel
lasers-line-lies-one-place-plane = die Laserlinie liegt in allen Bildern an einer Stelle ihrer Ebene
lasers-line-must-cross-chessboard-every = Die Laserlinie muss in jedem Bild über das Schachbrett laufen.
lasers-line-pose-lies-off-plane = Die Laserlinie von Pose { $number } liegt { $off } neben der Ebene der anderen und wurde ausgelassen.
lasers-lines-poses-lie-off-plane = Die Laserlinien der Posen { $poses } liegen { $off } neben der Ebene der anderen: Der Laser hat sich gegen die Kamera bewegt, und diese Linien wurden ausgelassen.
lasers-lines-poses-lie-off-plane-2 = Die Laserlinien der Posen { $poses } liegen { $off } neben der Ebene der anderen: Der Laser hat sich gegen die Kamera bewegt, und alle Linien zählen.
lasers-lines-poses-lie-off-plane-3 = die Laserlinien der Posen { $poses } liegen { $usual } neben der Ebene, die ihnen am besten passt
lasers-lines-poses-lie-up-off = die Laserlinien der Posen { $poses } liegen bis zu { $most } neben einer Ebene
lasers-plane-stands-board-limit = der Winkel zwischen Laserebene und Tafel ist { $angle } (Grenze { $least_laser_angle_deg })
last-cloud-still-measured = Die letzte Wolke ist noch zu messen.
last-days-old = Die letzte ist { $days } Tage alt, in { $place }.
last-days-old-same-disk = Die letzte ist { $days } Tage alt, in { $place }. Sie liegt auf demselben Datenträger wie die Daten.
last-row-must-0-0-0 = die letzte Zeile von { $name } muss 0 0 0 1 sein
last-verification-older-than-calibration = Die letzte Verifizierung ist älter als diese Kalibrierung.
least-middle-needed = mindestens { $angle } von ihrer Mitte aus sind nötig
least-needed = mindestens { $least } sind nötig
least-needed-each-three-non-parallel = mindestens { $least } sind auf jeder von drei nicht parallelen Flächen nötig
least-needed-tell-arms-errors-own = mindestens { $least } sind nötig, um die Fehler des Messarms vom Mittelpunkt zu trennen
least-places-taken = { $places_taken } von mindestens { $seats_least } Orten sind aufgenommen.
least-seats-spheres-bar-positions-needed = mindestens { $least_places } Pfannen, Kugeln und Stablagen sind nötig, damit einige zurückgehalten werden können
leave = Verlassen
leave-bar-where = Den Stab liegen lassen, wo er ist.
leave-session-points-yet-used-kept = Diese Sitzung verlassen? Noch nicht benutzte Punkte werden aufbewahrt.
leave-verification-clouds-kept-folder = Diese Verifizierung verlassen? Ihre Wolken bleiben in ihrem Ordner.
left = links
left-end = Linke Stirnseite
left-out = Ausgelassen: { $reason }
left-out-2 = ausgelassen: { $reason }
left-out-3 = Ausgelassen: { CLAUSE($text) }.
left-right-corners-were-exchanged-image = linke und rechte Ecken sind vertauscht, oder das Bild ist gespiegelt
length = Länge { $longer }
length-another-bar-another-unit-ends = die Länge gehört zu einem anderen Stab oder hat eine andere Einheit, oder die Enden sind nicht die dieses Stabs
lengths-ball-bars-held-out = Längen der Kugelstäbe, zurückgehalten
less-than-minute = weniger als eine Minute
less-than-pictures-edges-wide = { $text }, weniger als die { $width }, die die Kanten des Bilds breit sind
let-each-station-write-under-own = Jede Station nur unter ihrem eigenen Thema schreiben lassen und vom Broker entfernen, was er von anderen aufbewahrt.
let-go-control = die Bedienung abgegeben
let-simulation-do = Den simulierten Bediener machen lassen
let-simulation-do-everything = Den simulierten Bediener alles machen lassen
let-kept-time-server-which-moves = Von einem Zeitserver führen lassen, der sie sanft verstellt.
let-laser-come-rest-take-pictures = Den Laser zur Ruhe kommen lassen und die Bilder neu aufnehmen.
let-laser-warm-up-check-mount = Den Laser warmlaufen lassen, seine Halterung prüfen und die Bilder neu aufnehmen.
let-line-cross-board-every-picture = die Linie in jedem Bild über die Tafel laufen lassen
started-simulation = den simulierten Bediener machen lassen
lies-face = er liegt { $where }
lies-no-face-all = er liegt auf gar keiner Fläche
lies-where-certificate-puts = { $edge } liegt { $distance } neben dem Ort des Kalibrierscheins
light-block-evenly-sharp-large-picture = Den Zinnenkörper gleichmäßig beleuchten, scharf und groß im Bild.
light-board-evenly-sharp-large-picture = Die Tafel gleichmäßig beleuchten, scharf und groß im Bild.
light-front-above-so-crests-floors = von vorn oben beleuchten, sodass sich Zinnen, Nutgründe und Vorderseite unterscheiden, näher kommen und wegräumen, was davor ist
limit-2 = Grenze { $limit }
limit-3 = Grenze
limit-is = Die Grenze ist { $limit }.
limit-is-value = die Grenze ist { $limit }
limit-k-1 = Grenze, k = 1
limit-m-2 = Grenze { $limit }; U = { $expanded_uncertainty }, k = 2
limit-mark = Grenze
limit-number-micrometres-1-100-000 = Eine Grenze ist eine Zahl von 1 bis 100 000 Mikrometern.
limits-deg-must-ascend = limits_deg von { $name } muss ansteigen
line-brightness = Linienhelligkeit
line-gives-other-length = Zeile { $line } gibt { $length } an, für denselben Prüfkörper: { $label }
line-saturated = Linie übersteuert
line-to-arm-closed = Die Leitung zum Messarm an { $url } ist geschlossen
line-to-arm-lost = Die Leitung zum Messarm an { $url } ging verloren ({ $reason })
line-too-bright-saturated = Linie zu hell: { $clipped } übersteuert
line-too-dark = Linie zu dunkel: { $level }
link-good-any-more = Dieser Link gilt nicht mehr.
link-leads-itself = es ist ein Verweis, der auf sich selbst führt
linux-add-user-group-owns-port = Unter Linux den Benutzer in die Gruppe aufnehmen, der der Anschluss gehört (oft dialout).
lists-stripe-differ-length = die Listen einer Laserlinie sind verschieden lang
load-page-again = Die Seite neu laden.
log = Protokoll
log-broker-connected = mit dem Broker unter { $host }:{ $port } verbunden
log-broker-lost = die Verbindung zum Broker ging verloren: { $reason }
log-cannot-written-health-page-says = Das Protokoll kann nicht geschrieben werden; die Seite Zustand sagt mehr.
log-event-loop-goes-on = die Ereignisschleife geht nach { $duration } weiter
log-event-loop-held-up = die Ereignisschleife ist seit mehr als { $limit } aufgehalten
log-file-not-used = { $file } wird nicht verwendet: { $reason }
log-has-what-held-up-send = Im Protokoll steht, was sie aufhielt; das Diagnosepaket senden, wenn es wieder geschieht.
log-not-saved = { $method } { $path } wurde nicht gespeichert: { $reason }
log-notification-given-up = eine Benachrichtigung wurde aufgegeben: { $reason }
log-program-stood-still = das ganze Programm stand { $duration } lang still
log-repeated = ({ $count } davon seit { $since })
logs-cannot-written = Die Protokolle in { $folder } lassen sich nicht schreiben
look-change = Ansehen und tauschen.
look-last-message-let-simulation-try = Die letzte Meldung ansehen und den simulierten Bediener es erneut versuchen lassen
look-log-below-send-support-bundle = Das Protokoll unten ansehen, und das Paket für den Support an den schicken, der hilft.
look-numbers-then-accept-calibration-repeat = Die Zahlen ansehen, dann die Kalibrierung annehmen oder wiederholen.
look-present-step-act-2 = Den jetzigen Schritt ansehen und danach handeln
look-them-below-send-support-bundle = Unten ansehen und das Diagnosepaket senden.
looked-arms-delay = den Verzug des Messarms bestimmt
looked-pose = Pose { $number } angesehen
looking-delay = Verzug wird gesucht
looking-object-picture = Das Objekt wird im Bild gesucht
losses =
    { $device ->
        [arm] Verluste des Messarms
       *[sensor] Verluste des Sensors
    }
lost-garbled-last-ten-minutes = { $missing } von { $total } in den letzten zehn Minuten verloren oder verstümmelt ({ $share }).
lost-reconnecting = Verloren: { $title }; wird neu verbunden
low-down = tief unten
lower-by = { $distance } tiefer
lower-limit-below-upper = Die untere Grenze liegt nicht unter der oberen
made-first-administrator = den ersten Administrator angelegt
made-simulated-hardware-demonstration = An simulierten Geräten entstanden: eine Vorführung.
made-token-metrics = einen Schlüssel für Messwerte angelegt
made-kiosk-link = einen Kiosk-Link angelegt
make-backup-another-disk = Die Sicherung auf einem anderen Datenträger anlegen
make-one-below-crenel-backup = Unten eine anlegen oder mit crenel backup.
make-somebody-else-administrator-first = Zuerst jemand anderen zum Administrator machen
many-points-have-very-same-angles = viele Punkte haben genau dieselben Winkel
mask-has-pixels = die Maske gilt für { $width } × { $height }
mask-pixels-image-another-size = eine Maske von { $shape } Pixeln für ein Bild anderer Größe
mask-says-every-pixel-whether-stripe = eine Maske gibt für jedes Pixel an, ob die Laserlinie dort liegen darf
matrix-is-no-rotation = { $name } enthält keine Drehung: R·Rᵀ weicht um { $difference } von 1 ab
max-min-2-along = (max − min)/2 entlang { $axis }
may-not-do-this =
    { $role ->
        [admin] { $name } darf das nicht: dafür braucht es einen Administrator.
       *[operator] { $name } darf das nicht: dafür braucht es einen Bediener.
    }
measure-pattern-over-all-squares-correct = Das Muster über alle Felder messen und den Kalibrierschein berichtigen.
measure-patterns-width-height-fix-flat = Breite und Höhe des Musters messen und es auf einer ebenen Platte befestigen.
measure-squares-correct-certificate-check-every = die Felder messen und den Kalibrierschein berichtigen; oder prüfen, ob jedes Bild seine eigene Pose hat, in mm
measured = nicht gemessen
measuring-arm = Messarm
measuring-cloud = Wolke wird gemessen
measuring-cloud-2 = Wolke { $number } wird gemessen
memory = Arbeitsspeicher
merlons-are-symmetric = Breiten und Lücken der Zinnen lesen sich von beiden Enden gleich, sodass der Zinnenkörper nicht von seinem Spiegelbild zu unterscheiden ist
merlons-read-alike-either-side = seine Zinnen lesen sich von beiden Seiten gleich
merlons-read-mirrored-order = die Zinnen von „{ $name }“ lesen sich in gespiegelter Reihenfolge
merlons-stand-mirrored-order = die Zinnen liegen in gespiegelter Reihenfolge
message-too-large = { $size } Bytes sind mehr, als sie haben kann
messages-broker-were-read =
    { $count ->
        [one] { $count } Nachricht auf dem Broker wurde nicht gelesen: { $reasons }.
       *[other] { $count } Nachrichten auf dem Broker wurden nicht gelesen: { $reasons }.
    }
messages-of-no-station = { $count } nicht von der Art einer Station
messages-of-too-many-stations = { $count } von mehr Stationen, als gezeigt werden
messages-stations = Nachrichten von Stationen
messages-too-long = { $count } zu lang
messages-too-often = { $count } schneller, als sie gelesen werden
method = Verfahren
mm = In mm
more-on-either-face =
    { $pair ->
        [crest] { $count } weitere oben auf den Zinnen oder auf den Nutgründen
        [front] { $count } weitere auf der Vorder- oder Rückseite
       *[left] { $count } weitere auf der linken oder rechten Stirnseite
    }
more-poses-would-bring-little = Weitere Posen brächten wenig.
more-than-kb-were-sent = Es wurden mehr als { $limit } gesendet.
more-touches-on-face = { $count } weitere { $where }
most-pixels-read = höchstens { $millions } Millionen werden gelesen
mount-tip-of-datasheet-or-give-diameter = Den Taster des Datenblatts montieren oder den Durchmesser der Kugel selbst angeben.
move-away = Räumen Sie sie weg
move-away-start-again = Verschieben, dann neu starten
move-recording-keeps-them-all = Weiterfahren; die Aufzeichnung behält sie alle.
move-sensor-nearer-away-again-several = Den Sensor auf dem Weg über die Platte mehrmals näher und wieder weiter weg führen
move-sensor-over-part-yourself = Den Sensor selbst über das Teil führen
move-sensor-until-whole-object-picture = den Sensor bewegen, bis das ganze Objekt im Bild ist
move-tip-another-place = Die Tastkugel an eine andere Stelle führen
moved-encoder-read = es wurde nicht bewegt, oder sein Messgeber wird nicht gelesen
moved-simulation-stopped = den simulierten Bediener gestartet oder angehalten
moved-turned = In { $duration } um { $moved } bewegt und um { $turned } gedreht
movement-tip = Bewegung der Tastkugel
moves-check-arm-json-bars-lengths = { $name } ändert sich um { $change }: arm.json und die Stablängen prüfen
moving-only-moves-whole-arm-space = ihn zu ändern bewegt nur den ganzen Messarm im Raum
must-begin-http-https-name-machine = sie muss mit http:// oder https:// beginnen und einen Rechner nennen
must-name = Sie muss { $names } nennen
n-2-along = 2σ entlang { $axis }
n-2-encoders-alone = 2σ allein durch die Messgeber, { $axis }
n-2-worst-axis = 2σ beträgt { $two_sigma } auf der schlechtesten Achse; das Rauschen der Messgeber allein ergibt { $encoders }.
n-3d-view = 3D-Ansicht
n-3d-view-does-answer = Die 3D-Ansicht antwortet nicht.
n-3d-view-page-connected = Die 3D-Ansicht dieser Seite ist nicht verbunden
name-a-file = Eine Datei angeben
name-a-folder = Einen Ordner angeben
name-and-serial-number = { $name }, Seriennummer { $serial_number }
name-another-file = Eine andere Datei angeben
name-file-holds-brokers-password-alone = Eine Datei nennen, die nur das Passwort des Brokers enthält und die die Station lesen darf
name-folder-another-disk-backups-station = Mit backups in station.toml einen Ordner auf einem anderen Datenträger nennen.
name-folder-calibration-check-verification-has = Den Ordner einer Kalibrierung, einer Prüfung oder einer Verifizierung nennen: Er enthält eine von { $files }
name-folder-of-seats-spheres-bars = Einen Ordner mit Pfannen, Kugeln oder Kugelstäben angeben, die mit dem Messarm angetastet wurden
name-folder-other-places-none-some = Einen Ordner mit anderen Orten angeben oder keinen: dann wird reihum ein Teil zurückgehalten
name-folder-that-is-not-there = Einen Ordner angeben, den es noch nicht gibt
name-password-do-belong-together = Name und Passwort gehören nicht zusammen.
name-recording = Eine Aufzeichnung angeben
name-scan-mcap = Eine scan.mcap angeben
name-sessions-folder = Den Ordner einer Sitzung angeben
name-tls-certificate-tls-key-station = Nennen Sie tls_certificate und tls_key in station.toml, oder setzen Sie einen Proxy davor.
name-too-long = der Name ist zu lang
named-joint-range = Gelenk { $joint } dreht von { $low } bis { $high }
named-value = { $name } { $value }
near-base = nahe am Sockel
needed = { $least_frames } sind nötig
needed-place = { $fewest_corners } sind nötig, um es zu orten
needs-least =
    { $shape ->
        [plane] eine Ebene braucht mindestens { $least }
        [sphere] eine Kugel braucht mindestens { $least }
        [cylinder] ein Zylinder braucht mindestens { $least }
       *[other] mindestens { $least } sind nötig
    }
needs-least-three-conjugated-pairs = sie braucht mindestens drei zugeordnete Paare
neither-colours-nor-arms-poses-tell = weder seine Farben noch die Posen des Messarms bestimmen, welche Ecke die erste ist
nested-too-deeply = es ist zu tief verschachtelt
network = Netz
never-checked = Noch nie geprüft.
never-held-up-more-than = Nie länger als { $limit } aufgehalten.
new-password = neues Passwort
newest-record-days-later-than-clock = Der neueste Eintrag liegt { $days } Tage nach der Uhrzeit.
next = Weiter: { $title }.
next-backup-would-include-this = die nächste Sicherung würde diese enthalten
next-pose-follow-dashed-outline = Für die nächste Pose: { $words }. Dem gestrichelten Umriss folgen.
no-account-name = { $name } ist kein Name für ein Konto
no-answer-from = Von { $url } kommt keine Antwort
no-answer-within = keine Antwort innerhalb { $limit }
no-arm-model-joints-chosen = kein Armmodell mit { $joint_count } Gelenken ist gewählt
no-arm-near-given-one-explains = kein Messarm nahe dem angegebenen erklärt die Punkte; die von { $label } liegen { $rms } (rms) auseinander
no-backup-made = Es wurde keine Sicherung angelegt: { $error }
no-ball-bar-measured-arms-size = kein Kugelstab wurde gemessen: Die Größe des Messarms ist die seines Datenblatts; ein um { $error } falsches längstes Glied macht { $size } über die Reichweite
no-bright-line-runs =
    { $axis ->
        [u] keine helle Linie läuft quer durch das Bild
       *[v] keine helle Linie läuft von oben nach unten durch das Bild
    }
no-calibration-use-yet = noch ist keine Kalibrierung in Gebrauch
no-certificate-stated = kein Kalibrierschein angegeben
no-chessboard-x-inner-corners-found = kein Schachbrett mit { $columns } × { $rows } inneren Ecken wurde gefunden
no-cloud-being-scanned = Es wird keine Wolke gescannt.
no-cloud-shows-gauge-yet-scan = Noch zeigt keine Wolke das Prüfnormal. Eine scannen.
no-cloud-taken-yet = Noch keine Wolke wurde aufgenommen.
no-column = { $path }: keine Spalte { $names }
no-connection = keine Verbindung
no-crenellated-object-found-picture = im Bild wurde kein Zinnenkörper gefunden
no-data = Keine Daten vom Gerät „{ $title }“ seit { $silent }
no-data-yet = Noch keine Daten.
no-database-there = es gibt dort kein { $database }
no-delay-found-yet = Noch wurde kein Verzug bestimmt
no-file = es ist keine Datei
no-fitted =
    { $shape ->
        [plane] Es wurde keine Ebene angepasst: { $error }
        [sphere] Es wurde keine Kugel angepasst: { $error }
       *[cylinder] Es wurde kein Zylinder angepasst: { $error }
    }
no-fitted-program-failed =
    { $shape ->
        [plane] Es wurde keine Ebene angepasst: Das Programm ist daran gescheitert.
        [sphere] Es wurde keine Kugel angepasst: Das Programm ist daran gescheitert.
       *[cylinder] Es wurde kein Zylinder angepasst: Das Programm ist daran gescheitert.
    }
no-flange-further-than = { $path }: Kein Flansch ist weiter als { $furthest } von der Basis des Messarms entfernt
no-folder-named = den Ordner { $folder } gibt es nicht
no-frames = { $named }: keine Bilder
no-free-name-scan = kein freier Name für einen Scan in { $folder }
no-hand-no-knock-moves-joint = keine Hand und kein Stoß bewegt ein Gelenk in so kurzer Zeit so weit
no-image-or-cut-off = es ist kein Bild oder wurde abgeschnitten
no-joint-angle-exceeds = { $path }: Kein Gelenkwinkel übersteigt { $largest }
no-joint-angles = { $named }: keine Gelenkwinkel
no-joint-goes-there-back-between = kein Gelenk geht zwischen zwei Messwerten hin und zurück
no-joint-turned-more-than = { $label }: Kein Gelenk drehte sich um mehr als { $swing } ({ $joint })
no-joints-around-any-frames-stamp = { $named }: um keinen Bildzeitstempel Gelenkwerte
no-json = es ist kein JSON: { $error }
no-laser-stripe-found-object = auf dem Objekt wurde keine Laserlinie gefunden
no-laser-stripe-front-sensor-any = { $named }: in keinem der { $numbered } Bilder eine Laserlinie vor dem Sensor
no-laser-stripe-picture = Im Bild ist keine Laserlinie.
no-limit = keine Grenze
no-limit-set = keine Grenze gesetzt
no-limit-set-3 = Keine Grenze war gesetzt
no-limit-set-identification-check-arm = Für eine Identifikation ist keine Grenze gesetzt: Eine Prüfung des Messarms beurteilt sie.
no-limit-set-so-check-neither = Keine Grenze ist gesetzt, daher ist diese Prüfung weder bestanden noch nicht bestanden.
no-line-seen = keine Linie zu sehen
no-line-seen-2 = Keine Linie zu sehen
no-mcap-recording = es ist keine MCAP-Aufzeichnung
no-page-file-has-such-address = Keine Seite und keine Datei hat eine solche Adresse.
no-picture-came-sensor = kein Bild kam vom Sensor
no-picture-came-within = innerhalb { $limit } kam kein Bild
no-picture-in-folder = Im Ordner { $folder } ist kein Bild
no-picture-laser-came-within =
    { $state ->
        [on] innerhalb { $limit } kam kein Bild mit eingeschaltetem Laser
       *[off] innerhalb { $limit } kam kein Bild mit ausgeschaltetem Laser
    }
no-picture-shows-object-yet-take = Noch zeigt kein Bild das Objekt. Eines neu aufnehmen.
no-placing-edges-explains-those-picture = keine Lage des Objekts erklärt die Kanten im Bild
no-png-image = es ist kein PNG-Bild
no-point-taken-back-since-last = Seit dem letzten Antastpunkt wurde keiner zurückgenommen.
no-point-taken-yet = Noch kein Punkt wurde aufgenommen.
no-points-can-made = { $interrupted } Daraus lassen sich keine Punkte berechnen: { CLAUSE($why) }.
no-pose-given = keine Pose wurde angegeben
no-position-block-brings-them-onto = keine Lage dieses Zinnenkörpers bringt sie darauf
no-readable-figures = { $name } hat keine lesbaren Kennzahlen
no-reason-given = Es ist kein Grund angegeben
no-seat-taken-yet = Noch keine Pfanne wurde aufgenommen.
no-seated-tip-does-points-another = das tut keine Tastkugel in einer Pfanne: Punkte eines anderen Ortes sind darunter, oder die Datei gehört zu einem anderen Messarm
no-serial-port-named = Einen seriellen Anschluss { $url } gibt es nicht
no-serial-port-plugged = Kein serieller Anschluss ist eingesteckt.
no-single-contact-fault = an einem einzelnen Antastpunkt liegt es nicht
no-size-squares-makes-them-agree = keine Größe seiner Felder bringt sie in Einklang
no-station-data-folder = { $folder } ist kein Datenordner einer Station
no-such-file = eine solche Datei gibt es nicht
no-such-file-or-folder = eine solche Datei oder einen solchen Ordner gibt es nicht
no-such-folder-named = Den Ordner { $folder } gibt es nicht
no-touch-taken-back-since-last = Seit der letzten Antastung wurde keine zurückgenommen.
no-touch-taken-yet = Noch keine Antastung wurde aufgenommen.
no-two-opposite-sides-were-touched = Keine zwei gegenüberliegenden Seiten wurden angetastet: Tastkugeldurchmesser und Größe des Zinnenkörpers sind ungeprüft die ihrer Kalibrierscheine.
no-video-file-named = Die Videodatei { $path } gibt es nicht
nobody-asks-control = Niemand bittet um die Bedienung
nobody-may-use = { $path } darf niemand benutzen.
nobody-signed-here = Hier ist niemand angemeldet.
nominal-is-of =
    { $shape ->
        [sphere] die Sollwerte gehören zu einer Kugel
       *[plane] die Sollwerte gehören zu einer Ebene
    }
none-calibrations-belongs-these-recordings = Keine der Kalibrierungen gehört zu diesen Aufzeichnungen
none-edges-floors-base-shows-picture = keine der Kanten seiner Nutgründe und seiner Grundfläche zeigt sich im Bild
none-significant = keine war signifikant
normal-component = Normale { $axis }
normal-must-be-of-unit-length = normal muss die Länge eins haben, nicht { $length }
normal-must-have-unit-length = normal muss die Länge eins haben
not-saved = Dies wurde nicht gespeichert
not-usable-next-to-database = { $path } ist neben der Datenbank der Station nicht zu gebrauchen
note = Hinweis
nothing-came-for = Seit { $time } kam nichts von { $url }
nothing-can-be-sent-to-arm = An den Messarm an { $url } lässt sich nichts senden ({ $reason })
nothing-changed-since-solved = Seit der Berechnung hat sich nichts geändert.
nothing-changed-stations-log-has-details = nichts wurde geändert; Näheres steht im Protokoll der Station
nothing-else-bears-out-shadow-highlight = { $text }, und nichts anderes bestätigt das: Ein Schatten, ein Glanzlicht oder etwas davor kann so aussehen
nothing-listens = An { $url } hört nichts
nothing-made-them = Aus ihnen wurde nichts übernommen. { CAPITAL(CLAUSE($remedy)) }.
nothing-runs = Nichts läuft
nothing-seen-no-contrast = Nichts zu sehen: kein Kontrast
nothing-taken-reading-cannot-true-no = Aus einem unmöglichen Messwert wird nichts übernommen: kein Antastpunkt, keine Pose, keine Punkte.
nothing-taken-such-reading = aus einem solchen Messwert wird nichts übernommen
now = Jetzt
number-expected-here = hier wird eine Zahl erwartet
number-too-large = so groß ist nichts, was hier gemessen wird
numbers-need-decimal-point-comma-names = Zahlen brauchen einen Dezimalpunkt, kein Komma; Namen gar kein Komma
numerics = Numerik
object = Objekt
object-certificate = Kalibrierschein des Objekts
object-fills = Objekt füllt
object-found = das Objekt wurde nicht gefunden
object-looked-grey-images-8-16 = das Objekt wird in Graubildern von 8 bis 16 Bit und mindestens 64 Pixeln je Richtung gesucht
object-off-m = Objekt daneben, µm
object-picture = Das Objekt ist im Bild
object-picture-does-match-certificate = das Objekt im Bild passt nicht zum Kalibrierschein von „{ $name }“ ({ $serial_number })
object-picture-hold-arm-there-clamp = Das Objekt ist im Bild. Den Messarm dort halten oder festklemmen.
object-point-pixel-number = ein Objektpunkt oder ein Pixel ist keine Zahl
object-points-shape-pixels-shape = Objektpunkte der Form { $points } und Pixel der Form { $pixels }
object-too-far =
    { $side ->
        [left] Das Objekt liegt zu weit links
        [right] Das Objekt liegt zu weit rechts
        [up] Das Objekt liegt zu weit oben
       *[down] Das Objekt liegt zu weit unten
    }
objects-place-k-1 = Ort des Objekts (k = 1)
objects-points-do-fit-their-pixels = die Punkte des Objekts passen nicht auf ihre Pixel
of = { $page } von { $pages }
off = Aus: { $title }
offset-m = Versatz, µm
old-after-days-due = Sie ist { $ago } alt; die Frist beträgt { $limit }.
old-due-after-days = { $text }, { $ago } alt; die Frist beträgt { $limit }.
old-password-wrong = Das alte Passwort ist falsch.
on-board = auf der Tafel
on-face =
    { $face ->
        [crest] oben auf den Zinnen
        [floor] auf den Nutgründen
        [front] auf der Vorderseite
        [back] auf der Rückseite
        [left] auf der linken Stirnseite
        [right] auf der rechten Stirnseite
       *[other] auf der Fläche „{ $face }“
    }
one-browser-acts-time = ein Browser handelt zur Zeit
one-diameter-spheres-sphere-clean = ein Durchmesser gehört nicht zu seiner Kugel, oder die Kugel war nicht sauber
one-line-alone-does-fix-lasers = eine Linie allein legt die Laserebene nicht fest
one-numbers-has-too-many-digits = eine ihrer Zahlen hat zu viele Ziffern
one-of = es ist eines von { $names }
one-picture-flat-board-tells-neither = ein Bild einer ebenen Tafel bestimmt weder die Brennweite noch die Laserebene
one-plane-does-fix-focal-length = eine Ebene legt Brennweite, Abstand und Laserebene nicht zugleich fest
one-pose-alone-used-errors-arms = Nur eine Pose wurde benutzt: Fehler der Armglieder zeigen sich allein in den Antastpunkten; Gelenkwinkel, die nicht die des Bildes sind, und ein Objekt, das seit dem Antasten bewegt wurde, zeigen sich nicht.
one-pose-enough = eine Pose genügt bei „{ $name }“ nicht
one-pose-faugeras-contact-alignment = eine Pose (Faugeras, Antastausrichtung)
one-recording-one-calibration-give-one = eine Aufzeichnung und eine Kalibrierung ergeben eine Ebene
one-used-each-lighting = von jeder Beleuchtung wird eines benutzt
one-value-expected-for = für { $label } wird ein Wert von 0 bis { $largest } erwartet
one-who-loses-control-reads-why = wer die Bedienung verliert, erfährt den Grund
only-administrator = { $name } ist der einzige Administrator
only-corners-can-measured = nur { $found } seiner Ecken lassen sich messen
only-edge-points-lie-edges = nur { $agreeing } der Kantenpunkte liegen auf seinen Kanten
only-free-disk = nur { $free } sind auf dem Datenträger von { $folder } frei
only-joint-samples-came = nur { $count } Gelenkwerte kamen in { $duration }
only-machines-browsers-reach-station = Nur Browser auf diesem Rechner erreichen die Station.
only-one-row-corners-each-level = mit nur einer Eckenreihe je Ebene ist die Kamera nicht festgelegt
only-pose-take-another-first = Es ist die einzige Pose. Zuerst eine weitere aufnehmen.
only-stations-own-pages-may-do = Das dürfen nur die eigenen Seiten der Station.
only-visible-edges-show-picture = nur { $shown } seiner sichtbaren Kanten zeigen sich im Bild
open-again = Neu öffnen.
opened-kiosk = als Kiosk-Anzeige geöffnet
operation-not-permitted = der Vorgang ist nicht erlaubt
operator-2 = Bediener
origin-mm = Ursprung, mm
other-files = die anderen Dateien gehören zu { $device } { $known }
other-machines-reach-encrypted = Andere Rechner erreichen sie, verschlüsselt.
other-machines-reach-nothing-encrypted = Andere Rechner erreichen sie, und nichts ist verschlüsselt.
other-machines-reach-proxy = Andere Rechner erreichen sie über einen Proxy.
other-stations-see-one-one-them = Darüber sehen andere Stationen diese und diese die anderen. Sonst braucht ihn nichts.
others-covered-lost-lasers-light = die anderen sind verdeckt oder gehen im Laserlicht unter
out-focus-edges-wide-wanted = Unscharf: Kanten { $width } breit, gewünscht { $wanted }
out-picture-covered-blurred-another-object = es liegt außerhalb des Bilds, ist verdeckt oder unscharf, oder ein anderes Objekt liegt dort
over-clouds = Über die Wolken
over-reach-before-difference-arm-identified = Über die Reichweite: vorher die Abweichung vom identifizierten Messarm, nachher die Standardunsicherheit, k = 1.
over-reach-tip-off-rms-now = Über seine Reichweite lag die Tastkugel um { $before } rms daneben und ist nun auf { $after } bekannt (k = 1).
overexposed-share-at-full-scale = es ist überbelichtet: { $share } seiner Pixel sind am Anschlag
package-named = das Paket { $name } { $version }
parameter = Parameter
parameters = Parameter
parameters-moved-do-same-together = die geänderten Parameter leisten zusammen dasselbe
part-of-path-is-no-folder = ein Teil des Pfads ist kein Ordner
pass = Bestanden
pass-does-tell-delay = diese Überfahrt zeigt den Verzug nicht
pass-half-minute-enough = eine Überfahrt von einer halben Minute genügt
pass-has-pictures-lasers-line-plane = die Überfahrt hat { $count } Bilder mit der Laserlinie auf der Ebene
pass-over-flat-plate-fills-lasers = Über eine ebene Platte fahren, die die Laserlinie ausfüllt
pass-over-more-gauge = Mehr vom Prüfnormal überfahren
pass-over-plane-find = Über eine Ebene fahren und ihn bestimmen
pass-over-plate = Überfahrt über die Platte
pass-over-several-sides = Von mehreren Seiten überfahren
pass-stopped = Die Überfahrt wurde angehalten
pass-stripe-slowly-each-pass-cloud =
    { $shape ->
        [plane] Die Laserlinie langsam über das ganze Prüfnormal führen. Jede Überfahrt ist eine eigene Wolke.
       *[sphere] Die Laserlinie langsam von drei Seiten über die Kugel führen. Jede Überfahrt ist eine eigene Wolke.
    }
pass-stripe-slowly-over-gauge = Die Laserlinie langsam über das Prüfnormal führen
pass-stripe-slowly-over-whole-gauge = Die Laserlinie langsam über das ganze Prüfnormal führen, dann die Wolke beenden.
passed-ago-due-after-days = Bestanden, { $ago } her; die Frist beträgt { $limit }.
password-has-characters = Das Passwort hat { $count } Zeichen
password-is-name = Das Passwort ist der Name
password-length-wanted = { $least } bis { $most } sind gewünscht
permission-denied = Zugriff verweigert
pick-more-way-round-fit-plane = Mehr vom Umfang wählen oder eine Ebene anpassen
picture-being-taken-already = es wird schon ein Bild aufgenommen
picture-blurred-edges-wide = das Bild ist unscharf: Seine Kanten sind { $width } breit
picture-blurred-edges-wide-most-can = das Bild ist unscharf: Seine Kanten sind { $blur } breit, messbar sind höchstens { $limit }
picture-blurred-noisy-lasers-line-lies = das Bild ist unscharf oder verrauscht, oder die Laserlinie liegt darüber
picture-bytes-do-not-fit = { $name }: { $bytes } Bytes für { $width } × { $height } Pixel, { $row } je Zeile
picture-can-read-more-than-one = das Bild von „{ $name }“ lässt sich auf mehr als eine Art lesen
picture-cannot-be-encoded = das Bild konnte nicht als PNG kodiert werden
picture-cannot-be-used-take-it-again =
    { $others ->
        [yes] Dieses Bild ist nicht brauchbar. Neu aufnehmen oder ohne es weitermachen.
       *[no] Dieses Bild ist nicht brauchbar. Neu aufnehmen.
    }
picture-cannot-read = Das Bild { $path } lässt sich nicht lesen
picture-dim-bright-parts-reach-full = das Bild ist dunkel: Seine hellen Teile erreichen { $high } des Aussteuerbereichs
picture-has-size =
    { $picture ->
        [laser] das Laserbild hat { $width } × { $height } Pixel
       *[ambient] das Kalibrierbild hat { $width } × { $height } Pixel
    }
picture-incomplete = das Bild ist nicht vollständig
picture-mirrored-camera-looks-objects-back = das Bild ist gespiegelt, oder die Kamera sieht die Rückseite des Objekts
picture-objects-certificate-contradict-each-other = Bild und Kalibrierschein des Objekts widersprechen sich
picture-of-numbers = Das Bild { $path } besteht aus { $kind }-Zahlen
picture-overexposed = { $saturated } des Bilds sind überbelichtet
picture-shows-no-contrast-full-scale = das Bild zeigt keinen Kontrast: { $contrast } des Aussteuerbereichs
picture-shows-no-laser-line-object = ihr Bild zeigt keine Laserlinie auf dem Objekt
picture-shows-objects-mirror-image = das Bild zeigt das Spiegelbild des Objekts
picture-size-changed = { $title } hat sein Bild von { $width } × { $height } auf { $new_width } × { $new_height } Pixel geändert
picture-soft-edges-wide = das Bild ist etwas unscharf: Seine Kanten sind { $width } breit
pictures-came-without-arms-position = { $count } von { $total } Bildern kamen ohne die Lage des Messarms
pictures-contacts-certificate-contradict-each-other = Bilder, Antastpunkte und Kalibrierschein widersprechen sich
pictures-different-sizes = die Bilder sind verschieden groß: { $sizes }
pictures-flat-board-one-direction-do = Bilder einer ebenen Tafel aus einer Richtung bestimmen die Brennweite nicht
pictures-have-object-turned-how-touched = In den Bildern ist das Objekt um { $turned } gedreht gegenüber der Lage, in der es angetastet wurde. Gescannte Punkte können um ebenso viel falsch liegen.
pictures-have-object-where-touched-turned = In den Bildern liegt das Objekt { $off } (± { $known }) neben der Stelle, an der es angetastet wurde, um { $turned } gedreht. Gescannte Punkte können um ebenso viel falsch liegen.
pictures-left-out = Bilder werden ausgelassen: { $what }
pictures-of-one-pose-need-still-arm = die Bilder einer Pose werden bei ruhendem Messarm aufgenommen
pictures-recording-were-left-out = { $kept } Bilder sind in der Aufzeichnung, { $left_out } wurden ausgelassen
pictures-show =
    { $seen ->
        [one] { $seen } Bild zeigt „{ $name }“
       *[other] { $seen } Bilder zeigen „{ $name }“
    }
pictures-were-lost = { $count } von { $total } Bildern gingen verloren
pictures-were-taken-too-fast-up = { $count } von { $total } Bildern wurden zu schnell aufgenommen: bis { $worst } Unschärfe
place-sensor-so-both-crests-floors = den Sensor so halten, dass Zinnen und Nutgründe im Bild sind
place-sensor-so-stripe-crosses-crests = den Sensor so halten, dass die Laserlinie Zinnen und Nutgründe kreuzt
place-touch = Das ist die Stelle von Antastung { $number }
placed = Lage
places = { $done } von { $seats_wanted } Orten
places-2 = { $done } Orte
places-held-out-arms-errors-go = an zurückgehaltenen Orten gehen die Fehler des Messarms von { $before } auf { $after } ihres Rauschens
places-held-out-still-deviate = zurückgehaltene Orte weichen noch { $times }-mal so weit ab, wie ihr Rauschen erklärt: mehr Orte aufnehmen, gleichmäßiger über die Reichweite
places-were-held-out-fit-over = An Orten, die nicht in die Anpassung eingingen, und über den ganzen Arbeitsraum des Messarms.
plane-equation = ({ $x }; { $y }; { $z }) · x = { $offset }
plane-nearly-boards-does-meet-sharp = eine Ebene, die fast die der Tafel ist, trifft sie nicht in einer scharfen Linie
plane-needs-both-directions = eine Ebene braucht { $width } in beiden Richtungen
plane-swept-straight-across-angle = Gerade überfahrene Ebene: Winkel
plane-through-cameras-centre-gives-no = eine Ebene durch den Mittelpunkt der Kamera ergibt keine Tiefe
plug-right-arm-correct-arm-joint = Den richtigen Messarm anschließen oder [arm] joint_count berichtigen.
plus-minus = ± { $uncertainty }
point = Punkt { $number }, { $place }.
point-2 = { $face }, Punkt { $index }
point-again = Das ist noch einmal Punkt { $point }
point-back = Punkt { $index } ist wieder da.
point-cannot-true = Punkt { $index } ist unmöglich: { $what }; { $why }.
point-expanded-uncertainty = Gescannter Punkt, rms über das Messvolumen: erweiterte Unsicherheit
point-known-good = Ein gescannter Punkt ist im Flanschsystem auf { $total } (k = 1) bekannt; bis { $good } ist es gut.
point-known-k-1 = { $name }, ein Punkt bekannt auf { $total } (k = 1)
point-known-mostly-by = Ein gescannter Punkt ist im Flanschsystem auf { $total } (k = 1) bekannt, größter Anteil: { $source } ({ $value }); die Grenze ist { $limit }.
point-left-out-off = { $place }, Punkt { $number }: { $distance } daneben
point-lies-on-other-face = Punkt { $index } verfehlt die Fläche „{ $face }“ um { $off } und liegt { $where }.
point-misses-face = Punkt { $index } verfehlt die Fläche „{ $face }“ um { $off }.
point-off-face = Punkt { $index } liegt { $off } neben der Fläche „{ $face }“; die anderen stimmen auf { $rms } überein.
point-off-face-remove-then-go = Punkt { $point } liegt nicht auf seiner Fläche. Ihn entfernen, dann weitermachen.
point-off-plane-others = Punkt { $index } liegt { $off } neben der Ebene der anderen.
point-removed = Punkt { $index } ist entfernt.
point-standard-uncertainty = Gescannter Punkt, rms über das Messvolumen: Standardunsicherheit
point-taken-at = Punkt { $index } { $where }.
point-taken-off = Punkt { $index } { $where }: { $off }.
point-there-any-more = Diesen Punkt gibt es nicht mehr.
points-1-lie-apart-while-single = { $label }: Die Punkte 1 bis { $split } und { $next } bis { $points } liegen { $gap } auseinander, während einzelne Punkte um { $sd } streuen
points-3 = { $taken } Punkte
points-5 = Punkte
points-blocks-edges-fit-camera-rms = { $points } Punkte auf den Kanten des Zinnenkörpers passen auf { $rms } rms zur Kamera, am schlechtesten in Pose { $number } ({ $edges_rms }); die Grenze ist { $edge_rms_px }.
points-check-among-those-fit = { $shared } der { $count } Punkte zum Prüfen gehören auch zu denen der Ausgleichung
points-disagree-rest = { $label }: { $out } von { $points } Punkten widersprechen dem Rest
points-do-lie-one = ihre Punkte liegen nicht auf einer
points-edges-fit-camera-rms-limit = { $points } Punkte auf { $edges } Kanten passen auf { $rms } rms zur Kamera; die Grenze ist { $edge_rms_px }.
points-fix-no-cylinder = die Punkte legen keinen Zylinder fest
points-here-welcome-beside-those-other = { $place } Punkte hier sind willkommen, zusätzlich zu denen auf den anderen Flächen.
points-laser-stripe-lie-object-levels = { $points } Punkte der Laserlinie liegen auf dem Objekt (von { $found } auf seinen Ebenen; { $least } sind auf Zinnen und auf Nutgründen nötig)
points-lasers-line-lie-board-but-poses =
    { $count ->
        [one] { $points } Punkte der Laserlinie liegen auf der Tafel, { $rms } rms neben der Ebene. Pose { $poses } zeigt keine.
       *[other] { $points } Punkte der Laserlinie liegen auf der Tafel, { $rms } rms neben der Ebene. Die Posen { $poses } zeigen keine.
    }
points-lasers-line-lie-board-rms = { $points } Punkte der Laserlinie liegen auf der Tafel, { $rms } rms neben der Ebene.
points-lie-about-nearest-plane = die Punkte liegen { $spread } (k = 1) um die nächste Ebene, bei jedem Verzug
points-lie-one-line = die Punkte liegen auf einer Geraden
points-lie-one-plane = die Punkte liegen in einer Ebene
points-lie-too-small-piece = die Punkte liegen auf einem zu kleinen Stück davon
points-lie-too-small-piece-sphere = die Punkte liegen auf einem zu kleinen Stück der Kugel
points-lie-within-one-plane = { $share } der Punkte liegen innerhalb { $distance } um eine Ebene, bei jedem Verzug
points-made = { $name }: { $points } Punkte berechnet.
points-made-when-there-room-no = { $interrupted } Die Punkte werden berechnet, sobald Platz ist und kein Scan läuft.
points-of = { $taken } von { $wanted } Punkten
points-places = { $points } Punkte an { $places } Orten
points-saved =
    { $count ->
        [one] { $name }: { $count } Punkt gespeichert
       *[other] { $name }: { $count } Punkte gespeichert
    }
points-taken-themselves-while-arm-swings = Punkte werden von selbst aufgenommen, während der Arm schwenkt.
points-used = Benutzte Punkte
points-were-taken-another-arm-file = die Punkte wurden mit einem anderen Messarm aufgenommen, oder die Datei ist falsch
ports-are = Vorhandene Anschlüsse: { $names }.
pose-2 = Pose { $number }: { CLAUSE($reason) }.
pose-4 = Pose { $number }: { $name }
pose-5 = Pose { $number } ({ $u }, { $v })
pose-6 = Pose
pose-count-one-other-s-taken =
    { $count ->
        [one] { $count } Pose ist aufgenommen.
       *[other] { $count } Posen sind aufgenommen.
    }
pose-differs-from-line = { $place }: { $moved } gegen Zeile { $line } derselben Pose { $pose }
pose-found-minus-computed-times-larger =
    Pose { $number }: gemessen minus berechnet, { $factor }-fach vergrößert; Ecken gelb, höchstens { $largest }; Laserlinie rot. { $fitted ->
        [corners] Ecken { $rms }
       *[edges] Kanten { $rms }
    }, Laserlinie { $stripe_rms } rms.
pose-found-minus-computed-times-larger-2 =
    Pose { $number }: gemessen minus berechnet, { $factor }-fach vergrößert; Ecken gelb, höchstens { $largest }; keine Laserlinie. { $fitted ->
        [corners] Ecken { $rms }
       *[edges] Kanten { $rms }
    } rms.
pose-has-no-picture = { $place }: Pose { $pose } hat kein { $missing }-Bild
pose-is-set-aside = Beiseitegelegt
pose-left-out = Pose { $number } wurde ausgelassen: { CLAUSE($reason) }.
pose-looks-same-turned-round = Pose { $number }: „{ $name }“ sieht umgedreht gleich aus
pose-needs-both-lightings = eine Pose braucht ein 'ambient'- und ein 'laser'-Bild oder eines mit beidem Licht ('both')
pose-set-aside = Diese Pose ist nicht beiseitegelegt.
pose-set-aside-2 = Pose { $n } ist beiseitegelegt
pose-shows-corners = Pose { $number } zeigt { $found } Ecken von „{ $name }“
pose-shows-no-laser-line-object = Pose { $number } zeigt keine Laserlinie auf dem Objekt: ohne sie benutzt.
pose-taken = Pose { $number } ist aufgenommen.
pose-taken-back = Pose { $n } ist zurückgeholt
pose-there-any-more = Diese Pose gibt es nicht mehr.
pose-used-other-one-pose =
    { $unused ->
        [one] Pose { $number } wurde benutzt; die andere nicht, wegen one-pose
       *[other] Pose { $number } wurde benutzt; die anderen { $unused } nicht, wegen one-pose
    }
pose-would-help-most-scanned-point = Die Pose, die am meisten hilft: { $words }. Ein gescannter Punkt: { $now } → { $then } (k = 1).
poses = die Posen
poses-2 = Posen
poses-agree-boards-place-pose-furthest = { $used } Posen stimmen im Ort der Tafel auf { $median } überein; Pose { $number } liegt am weitesten daneben, um { $off }.
poses-agree-objects-place-pose-furthest = { $used } Posen stimmen im Ort des Objekts auf { $median } überein; Pose { $number } liegt am weitesten daneben, um { $off }.
poses-all-alike-do-tell-where = lauter gleiche Posen bestimmen in keiner Richtung, wo der Sensor am Flansch sitzt
poses-contacts-scatter-times-more-than = Posen und Antastpunkte streuen { $noise }-mal mehr, als die Messgeber des Arms erklären (Grenze { $noisy }).
poses-enough = { $done } Posen genügen
poses-put-up-apart =
    { $thing ->
        [board] nach den Posen { $poses } liegt die Tafel an Orten bis zu { $apart } auseinander
       *[object] nach den Posen { $poses } liegt das Objekt an Orten bis zu { $apart } auseinander
    }
poses-touches = Posen und Antastungen
poses-were-changed-solve-again-undo = Die Posen wurden geändert. Neu berechnen oder die Änderung zurücknehmen.
poses-without-contact-points = { $count } Posen ohne Antastpunkte
positions =
    { $bars } in { $positions ->
        [one] { $positions } Lage
       *[other] { $positions } Lagen
    }
pressed-stop = Stopp gedrückt
principal-point = Hauptpunkt
principal-point-at = { $u }; { $v }
probe-matrix-sensors-frame-arms-last = Tastermatrix: das Koordinatensystem des Sensors in dem des letzten Armgelenks.
probe-object = Das Objekt antasten
program-failed = das Programm versagte dabei
program-reads-version = dieses Programm liest Version { $version } von { $format }
projection-matrix-contradicts = projection_matrix ist nicht matrix · [rotation | translation_mm]
protobuf-expected = { $schemas } in Protobuf wird erwartet
put-arm-back = Den Messarm von vorher wieder benutzen
put-back-end-swing = Zurücksetzen oder den Schwenk beenden.
put-back-what-there-before = den Stand von vorher zurückgeholt
put-certificate-into-folder-gauges = Ihren Kalibrierschein in den Ordner gauges legen.
put-file-back-last-backup-leave = Die Datei aus der letzten Sicherung zurücklegen, oder sie lassen und weitermachen.
put-file-back-last-backup-restart = Die Datei aus der letzten Sicherung zurücklegen und die Station neu starten, oder neu kalibrieren
put-file-place = Eine Datei an seine Stelle legen
put-last-one-back = das Letzte zurückgelegt
put-point-back = Punkt { $i } zurückholen
put-tip-into-bars-other-end = Die Tastkugel in das andere Stabende setzen
put-tip-into-end-ball-bar = Die Tastkugel in ein Ende des Kugelstabs setzen
put-tip-into-seat = Die Tastkugel in die Pfanne setzen
put-tip-into-seat-2 = Die Tastkugel in Pfanne { $done } setzen
put-touch-back = Antastung { $i } zurückholen
puts-object-fits-other-pose =
    { $readings ->
        [pose] danach läge das Objekt { $off } neben dem Ort, den die anderen ergeben; sie passt zur Roboterpose von Pose { $other }
       *[angles] danach läge das Objekt { $off } neben dem Ort, den die anderen ergeben; sie passt zu den Gelenkwinkeln von Pose { $other }
    }
puts-object-where-others-put = danach läge das Objekt { $off } neben dem Ort, den die anderen ergeben
quaternion-length = { $place }: (qx, qy, qz, qw) hat die Länge { $length }
radius-m = Radius, µm
radius-mm-missing-sphere-judged-size = radius_mm fehlt: Eine Kugel wird nach ihrer Größe beurteilt
read-yet = Noch nicht gelesen.
reading-arm-number = ein Wert des Messarms { $name } ist keine Zahl
readings-arm = Messwerte des Messarms
readings-arm-could-true-last =
    { $count ->
        [one] { $count } Messwert des Messarms war unmöglich: { $what }
       *[other] { $count } Messwerte des Messarms waren unmöglich; der letzte: { $what }
    }
readings-row-more-equal-last-digit = mindestens { $equal_frozen } Messwerte nacheinander sind bis auf die letzte Stelle gleich, wie es bei einem heilen Messgeber nie vorkommt
readings-shape-arm = Werte der Form { $shape } für den Messarm { $name }
reason-and-more = { $reason } (und { $more } weitere)
reasons = Gründe
rebuild-recording-crenel-reconstruct = aus der Aufzeichnung mit crenel reconstruct neu berechnen
rebuilding-clouds-every-calibration = Wolken werden mit jeder Kalibrierung neu berechnet
rebuilt-verification-every-calibration = eine Verifizierung mit jeder Kalibrierung neu berechnet
record-data-folder-any-more = Der Eintrag ist nicht mehr im Datenordner.
record-one-pass-over-plane = Eine Überfahrt über eine Ebene aufzeichnen
record-radians = In Radiant aufzeichnen
recording-cannot-read = die Aufzeichnung lässt sich nicht lesen: { $reason }
recording-cut-off = die Aufzeichnung ist abgeschnitten
recording-cut-off-after = { $path } ist nach { $bytes } von { $size } Bytes ({ $share }) abgeschnitten oder beschädigt; gelesen bis { $end } nach dem Beginn
recording-cut-off-before-first-message = { $path } ist nach { $bytes } von { $size } Bytes ({ $share }) abgeschnitten oder beschädigt, vor der ersten Nachricht
recording-cut-off-bytes-left = die Aufzeichnung ist abgeschnitten: { $size } von { $written } Byte sind übrig
recording-damaged = die Aufzeichnung ist beschädigt
recording-empty = die Aufzeichnung ist leer
recording-has-joints =
    { $path } enthält { $count ->
        [one] { $count } Gelenk
       *[other] { $count } Gelenke
    }
recording-has-no-joints = { $path }: keine Gelenkwinkel
recording-kept = { $name }: Die Aufzeichnung ist erhalten.
recording-message-at = { $path } { $topic } bei { $stamp_ns } ns
recording-missing = die Aufzeichnung fehlt
recording-names-joints = { $path } nennt seine Gelenke { $names }
recording-no-file = die Aufzeichnung ist keine Datei
recording-stopped = die Aufzeichnung hielt an
recordings = Aufzeichnungen
recordings-calibrations-journal-kept-there = Aufzeichnungen, Kalibrierungen und das Journal werden dort aufbewahrt.
recordings-damaged =
    { $more ->
        [0] { CLAUSE($first) }.
       *[other] { CLAUSE($first) }, und { $more } weitere.
    }
recordings-turned-to-one-another = die Aufzeichnungen sind gegeneinander um bis zu { $angle } gedreht: Sie sind nicht von einer Ebene, und ihre Spannweiten bedeuten nichts
records = Archiv
refining-camera-lens-laser-plane = Kamera, Objektiv und Laserebene werden verfeinert
reinstall-update-package = Jenes Paket neu installieren oder aktualisieren.
rejected-and-few-edges-show = { $text }, und nur { $shown } seiner sichtbaren Kanten zeigen sich im Bild
remove = Entfernen Sie ihn
remove-point = Punkt { $index } entfernen
remove-point-first-face = Zuerst Punkt { $index } entfernen: Er liegt nicht { $where }.
remove-then-touch-face-marked-drawing = Entfernen, dann die Fläche antasten, die in der Zeichnung markiert ist.
remove-touch-there-again = Ihn entfernen und dort noch einmal antasten.
remove-touch-there-again-rest = Ihn entfernen und dort noch einmal antasten, in Ruhe.
remove-touch-there-again-rest-clear = Entfernen und dort neu antasten, in Ruhe und nicht an der Kante.
removed-account = ein Konto entfernt
removed-point = einen Punkt entfernt
removed-kiosk-link = einen Kiosk-Link widerrufen
rename = Umbenennen
renamed-scan = einen Scan umbenannt
repeat-first-point = Vom ersten Punkt an wiederholen
repeat-start = Von vorn wiederholen
replay-points-shown =
    { $count ->
        [one] { $name }: { $count } Punkt gezeigt
       *[other] { $name }: { $count } Punkte gezeigt
    }
report-cannot-written = ein Bericht lässt sich nicht als '{ $suffix }' schreiben
report-made-crenel-files-session-alone = Bericht erstellt von Crenel { $version }, allein aus den Dateien der Sitzung.
request-failed = die Anfrage ist gescheitert
request-understood = Die Anfrage ist nicht zu verstehen: { $text }.
request-understood-2 = Die Anfrage ist nicht zu verstehen
residuals-contacts-object = Restabweichungen der Antastpunkte am Objekt
residuals-gauge = Restabweichungen am Prüfnormal: { $name }
residuals-gauge-2 = Restabweichungen am Prüfnormal
residuals-image = Restabweichungen in den Bildern
residuals-image-worst-poses = Restabweichungen in den Bildern (die { $count } von { $used } Posen, die am schlechtesten passen)
residuals-object = Restabweichungen am Objekt
residuals-pose-picture = Restabweichungen der Pose { $number } in ihrem Bild
restore-backup-or-start-over = Die letzte Sicherung an ihre Stelle setzen oder sie wegräumen, um neu zu beginnen
restore-database-from = Die Datei { $database } aus { $folder } an ihre Stelle legen, oder mit --data in einem anderen Ordner beginnen
restore-database-from-last-backup = Die Datei { $database } aus der letzten Sicherung an ihre Stelle legen, oder mit --data in einem anderen Ordner beginnen
restore-file-source = Die Datei aus ihrer Quelle wiederherstellen
restore-picture-delete-row = Das Bild wiederherstellen oder die Zeile löschen
restore-sessions-folder-backup = Den Ordner der Sitzung aus einer Sicherung wiederherstellen
restore-take-picture-again = Wiederherstellen oder das Bild neu aufnehmen
result = Ergebnis
result-2 = das Ergebnis
result-cannot-traced-them = Das Ergebnis lässt sich nicht auf sie zurückführen.
result-rms = Ergebnis, rms
result-would-replace-file-made = das Ergebnis würde eine Datei ersetzen, aus der es entsteht
results = Ergebnisse
review = Beurteilen
review-calibration = Kalibrierung beurteilen
rewritten-by-another-program = sie wurde von einem anderen Programm neu geschrieben
right = rechts
right-end = Rechte Stirnseite
rigid-fit-given-points = einer starren Anpassung wurden { $a } und { $b } Punkte gegeben
rigid-fit-given-points-one-line = einer starren Anpassung wurden Punkte auf einer Geraden gegeben
rms-before-after-each-pair-scale = Effektivwerte vorher und nachher, jedes Paar in eigenem Maßstab.
robot-pictures-agree-boards-place-but = Roboter und Bilder stimmen im Ort der Tafel überein, in ihrer Neigung aber nur auf { $tilt } (Drehungen des Roboters selbst: { $turn }).
robots-poses = Posen des Roboters
role-and-name = { $role }: { $name }
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
rows-were-copied-arm-held-still = Zeilen wurden kopiert, oder der Messarm stand still: Derselbe Punkt zweimal bringt nichts Neues
runs-steadily = Sie läuft gleichmäßig.
s-driver-failed = Treiber gescheitert ({ $title }): { $error }
s-stripe-spans-blocks =
    { $level ->
        [crest] Auf den Zinnen überdeckt die Laserlinie { $span } der { $width } des Zinnenkörpers.
       *[floor] Auf den Nutgründen überdeckt die Laserlinie { $span } der { $width } des Zinnenkörpers.
    }
same-offset = Dieselbe: Versatz
saturated = Übersteuert
save-8-16-bits = Mit 8 oder 16 Bit speichern.
save-commas-between-columns-point-numbers = Mit Kommas zwischen den Spalten und Punkt in den Zahlen speichern
save-utf-8 = Als UTF-8 speichern
saved-result = das Ergebnis gespeichert
say-few-words-why-you-take = In wenigen Worten sagen, warum übernommen wird
says-hello = { $name } grüßt.
says-nothing-identification = { $folder } enthält keine Identifikation
scan = Scannen
scan-2 = Scan { $started }
scan-again = Erneut scannen
scan-again-arm-camera-one-clock = Erneut scannen, mit Messarm und Kamera auf einer Uhr
scan-can-made-again-recording-verification = Aus der Aufzeichnung lässt sich ein Scan neu berechnen und eine Verifizierung belegen.
scan-cannot-start-now = Jetzt kann kein Scan beginnen
scan-cloud = Wolke { $clouds } scannen
scan-cut-short = Dieser Scan endete vorzeitig: { CLAUSE($reason) }.
scan-does-start-less-than-0 = Ein Scan beginnt nicht mit weniger als 0.5 GB und hält bei 0.1 GB an.
scan-flat-plate-nearer-away-again = Eine ebene Platte scannen, mehrmals näher und wieder weiter weg, dann den Verzug bestimmen
scan-gauge = Prüfnormal scannen
scan-gauge-again = Das Prüfnormal erneut scannen
scan-gauge-chosen = Das gewählte Prüfnormal scannen
scan-gauge-chosen-nothing-beside = Das gewählte Prüfnormal scannen und nichts daneben
scan-gauge-nothing-beside = Das Prüfnormal scannen und nichts daneben.
scan-goes-when-back = Der Scan geht weiter, wenn es wieder da ist.
scan-has = ein Scan hat { $joints_topic } und { $image_topic } oder { $stripe_topic }
scan-more-clouds = Weitere Wolken scannen
scan-more-sphere = Mehr von der Kugel scannen
scan-needs = ein Scan braucht { $needed }
scan-needs-name = Ein Scan braucht einen Namen
scan-probe-share-arm-what-both = Scan und Taster teilen den Messarm: Was beide gleich falsch haben, zeigt sich hier nicht.
scan-running-already = ein Scan läuft schon
scan-running-has-laser-stop-first = Ein Scan läuft und hat den Laser. Zuerst anhalten.
scan-stopped = Der Scan hielt an: { $error }
scan-stopped-2 = der Scan hielt an
scanned-sphere-has-diameter = Die gescannte Kugel hat einen Durchmesser von { $diameter }
scanning = Scan läuft
scanning-cloud = Wolke { $number } wird gescannt
scatter-points-rms = Streuung der Punkte (rms)
scatter-single-points-beyond-encoders = Streuung einzelner Punkte über die Winkelgeber hinaus
screw-home-check-again-change-if = Fest einschrauben und erneut prüfen; tauschen, wenn es so bleibt.
screw-tip-home-clamp-sphere-check = Die Tastkugel festschrauben, die Kugel festspannen und erneut prüfen.
search-object-failed = Die Suche nach dem Objekt ist gescheitert
seat-3 = die Pfanne
seat-moved-between = die Pfanne bewegte sich dazwischen
seat-named = Pfanne { $name }
seat-points-1-lie-apart = Pfanne { $name }: Ihre Punkte 1 bis { $split } und { $next } bis { $points } liegen { $gap } auseinander
seat-tip = Tastkugel einsetzen
seats = Pfannen
seats-held-out = Pfannen, zurückgehalten
seats-were-taken-another-arm = Die Pfannen wurden mit einem anderen Messarm aufgenommen.
second = { $text }, { $rate } je Sekunde
second-newest-old = { CLAUSE($text) }: { $rate } je Sekunde, das Neueste { $age } alt.
second-picture-pose = { $place }: ein zweites { $lighting }-Bild der Pose { $pose }
see-result = Ergebnis ansehen
seems-lie-where-certificate-puts = { $edge } liegt anscheinend { $off } neben dem Ort des Kalibrierscheins
seen-sharply-enough-sure = „{ $name }“ ist nicht scharf genug zu sehen, um sicher zu sein
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
seen-well-enough-sure = „{ $name }“ ist nicht gut genug zu sehen, um sicher zu sein
send-support-bundle = Das Paket für den Support schicken
sends-nothing =
    { $device ->
        [arm] der Messarm sendet nichts
       *[sensor] der Sensor sendet nichts
    }
sensor = Der Sensor: { $text }
sensor-2 = Sensor
sensor-connected = der Sensor ist nicht verbunden
sensor-did-answer-laser-off = Der Sensor hat auf „Laser aus“ nicht geantwortet
sensor-has-pixels = der Sensor hat { $width } × { $height }
sensor-lost-exposure-longer-than = der Sensor ist weg, oder seine Belichtung ist länger
sensor-measures-away-arms-last-joint = Der Sensor misst { $away } vom letzten Gelenk des Messarms entfernt (Grenze { $farthest_mm }).
sensor-now-sends-pictures-pixels = der Sensor sendet jetzt Bilder von { $size } Pixeln
sensor-only-went-one-way-delay = der Sensor fuhr nur in einer Richtung; ein Verzug sieht dann aus wie eine andere Lage der Ebene
sensor-reports-laser-other-state = der Sensor meldet den Laser im anderen Zustand
sensor-turned-most-between-poses-wanted = Der Sensor drehte sich zwischen den Posen um höchstens { $turn } (gewünscht: { $alike_deg } und mehr), sodass sie kaum mehr bestimmen als eine.
sensor-went = der Sensor fuhr mit { $speed }; { $known }
sensor-went-along-plane-across-along = der Sensor fuhr mit { $along } entlang der Ebene und mit { $across } quer dazu; entlang der Ebene ändert ein Verzug nichts
sensors-image-has-pixels = das Bild des Sensors hat { $width } × { $height } Pixel
sensors-laser-cannot-switched-here = der Laser dieses Sensors lässt sich von hier nicht schalten
sent-nothing-opening-again = { $title }: { $silence } lang kam nichts; wird neu geöffnet
sentence = { CAPITAL(CLAUSE($text)) }.
serial-number = Seriennummer { $serial_number }
serial-number-chessboard-inner-corners-squares = Seriennummer { $serial_number }, Schachbrett, { $columns } × { $rows } innere Ecken, Felder von { $square }
serial-number-joints-tip = Seriennummer { $serial_number }, { $joint_count } Gelenke, Tastkugel Ø { $diameter }
serial-number-merlons = Seriennummer { $serial_number }, { $merlon_count } Zinnen, { $size } × { $size2 } × { $size3 }
serial-number-pixels = Seriennummer { $serial_number }, { $width_px } × { $height_px } Pixel
serial-port-use-another-program = Der serielle Anschluss { $url } wird von einem anderen Programm benutzt
server-failed-what-taken-before-kept = Der Server ist daran gescheitert; was vorher aufgenommen wurde, ist erhalten.
session-cannot-read-set-aside = Die Sitzung { $session_id } ist nicht zu lesen und wird beiseitegelegt: { $error }.
session-closed-start-new-one = Diese Sitzung ist geschlossen. Eine neue beginnen.
session-could-read = damit wäre die Sitzung nicht mehr zu lesen
session-has-no-picture = Diese Sitzung hat kein Bild { $name }.
session-went-meanwhile-nothing-done = Die Sitzung ging inzwischen weiter; es wurde nichts getan
sessions-arm-cannot-read = Der Messarm der Sitzung lässt sich nicht lesen
sessions-gauge-arm-cannot-read-any = Prüfnormal oder Messarm der Sitzung lassen sich nicht mehr lesen
sessions-pictures-lie-inside-folder = die Bilder einer Sitzung liegen in ihrem Ordner
set = Satz { $name }
set-arm-counts-per-revolution-station = { "[" }arm] counts_per_revolution in station.toml setzen.
set-arms-specification-limit-where-next = Die Spezifikation des Messarms als Grenze setzen, wo die nächste Prüfung beginnt.
set-aside = Beiseitelegen
set-calibration-aside-start-again-beginning = Diese Kalibrierung beiseitelegen und von vorn beginnen?
set-cloud-aside = eine Wolke beiseitegelegt
set-exposure-picture = die Belichtung nach dem Bild gesetzt
set-exposure-so-stripe-bright-but = So belichten, dass die Laserlinie hell, aber nicht übersteuert ist.
set-limit = die Grenze gesetzt
set-machines-clock-let-kept-time = Die Uhr des Rechners stellen und von einem Zeitserver führen lassen.
set-pose-aside = eine Pose beiseitegelegt
set-sensor-back-calibrate-again = den Sensor zurückstellen oder neu kalibrieren
set-sensor-back-scan-again = den Sensor zurückstellen und erneut scannen
set-sensor-rate-hz = { "[" }sensor] rate_hz setzen.
set-up = Einrichten
settings-are-lost = Die Einstellungen sind verloren: { $error }
shorten-exposure-or-darken-room = Kürzer belichten oder die Umgebung abdunkeln
should-used-findings-say-why = Sie sollte nicht benutzt werden: die Befunde sagen, warum.
show-more-block-crests-floors-front = Mehr vom Zinnenkörper zeigen, Zinnen und Nutgründe, vorn und hinten.
show-whether-certificate-right-there-checked =
    { $detections ->
        [one] Das Bild zeigt nicht: { $hidden }. Ob der Kalibrierschein dort stimmt, ist nicht geprüft.
       *[other] Die Bilder zeigen nicht: { $hidden }. Ob der Kalibrierschein dort stimmt, ist nicht geprüft.
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
sign-browser-your-own = An einem eigenen Browser anmelden
sign-go = Anmelden und weitermachen
signatures = Unterschriften
signed = angemeldet
signed-out = abgemeldet
simulated-camera-is-lost = Die simulierte Kamera ist nicht zu erreichen
simulated-sensor-is-not-open = Der simulierte Sensor ist nicht offen
since-calibration = { $celsius }, { $change } seit der Kalibrierung.
six-seven-joints-expected = sechs oder sieben Gelenke werden erwartet, nicht { $joints }
size-expected = { $width } × { $height } werden erwartet
so-centre-known-k-1 = so ist der Mittelpunkt auf { $centre_sd } bekannt, k = 1
so-plane-known-k-1 = so ist die Ebene auf { $at } und { $arcsec } bekannt, k = 1
software = Software
software-part =
    { $part ->
        [system] System { $version }
        [machine] Maschine { $version }
        [processors] { $version } Prozessoren
        [arm] Messarm { $version }
        [sensor] Sensor { $version }
       *[other] { $part } { $version }
    }
solve-again = Neu berechnen.
solve-again-2 = Neu berechnen
solving-camera = Kamera wird berechnet
some-points-off-their-face-remove = Einige Punkte liegen nicht auf ihrer Fläche. Sie entfernen, dann weitermachen.
somebody-must-able-give-people-access = jemand muss Zugang geben können
somebody-publishes-what-no-station-does = Jemand veröffentlicht, was keine Station veröffentlicht, und kann verbergen oder verfälschen, was gezeigt wird.
something-changed-since-solved-solve-again = Seit der Berechnung hat sich etwas geändert. Neu berechnen.
sphere = Kugel
sphere-2 = Kugel, { $diameter }
sphere-4 = { $path }: gehört zu einer Kugel
sphere-clamped = Die Kugel ist festgespannt
sphere-known-diameter-clamped-firmly-within = Eine Kugel bekannten Durchmessers, gut erreichbar festgespannt.
sphere-known-to = Ø { $diameter }, bekannt auf { $known } (k = 1)
sphere-named = Kugel { $name }
sphere-of-unknown-uncertainty = Ø { $diameter }, Unsicherheit nicht angegeben
spheres = Kugeln
spheres-held-out = Kugeln, zurückgehalten
spheres-seen-against-their-diameters-tips = die Kugeln erscheinen { $excess } (± { $uncertainty }) gegen ihre Durchmesser, mit { $diameter } der Tastkugel
spheres-seen-than-stated-tips-diameter =
    { $sign ->
        [larger] die Kugeln erscheinen { $excess } größer als angegeben: Der Durchmesser der Tastkugel könnte { $diameter } sein
       *[smaller] die Kugeln erscheinen { $excess } kleiner als angegeben: Der Durchmesser der Tastkugel könnte { $diameter } sein
    }
spheres-size-by-certificate-or-datasheet =
    { $sign ->
        [larger] laut Datenblatt des Messarms haben die Kugeln ihre angegebene Größe, nach der Länge dieses Stabs wären sie { $excess } größer
       *[smaller] laut Datenblatt des Messarms haben die Kugeln ihre angegebene Größe, nach der Länge dieses Stabs wären sie { $excess } kleiner
    }
spread-needs-least-two-clouds = eine Streuung braucht mindestens zwei Wolken
spread-points-hold-still-press-arms = { $place } { $wanted } Punkte verteilen, still halten und die Taste am Messarm drücken.
spread-them-wide-clear-edges = Weit verteilen, nicht an den Kanten.
square-mm-too-small = square_mm muss mindestens { $least } sein; ist es in Metern angegeben?
squares-100-mm = Felder von 100 mm
standard-one-seat-continuous-swing-positions = Nicht normgerecht: eine Pfanne und ein stetiger Schwenk, nicht die Orte und Punkte von ASME B89.4.22 oder ISO 10360-12. Ein Ergebnis nach diesen wird nicht behauptet.
standard-positions-articulations-counts-iso-10360 = Nicht normgerecht: Die Orte, Gelenkstellungen und Anzahlen der ISO 10360-8 und der ISO 10360-12 werden nicht buchstäblich gefahren, daher wird keines ihrer Formelzeichen gedruckt.
standard-touches-those-sphere-tests-iso = Nicht normgerecht: Die Antastungen sind nicht die der Kugelprüfungen der ISO 10360-12, daher wird keines ihrer Formelzeichen gedruckt.
standard-uncertainty-0-mm = Eine Standardunsicherheit beträgt 0 bis { $largest }.
standard-uncertainty-k-1-scanned-point = Standardunsicherheit (k = 1) eines gescannten Punkts über die Laserebene, von { $low } ({ $low_mm }) bis { $high } ({ $high_mm }). Durchgestrichen: extrapoliert, näher oder weiter als die kalibrierten { $near } bis { $far } von der Kamera.
standard-uncertainty-mm-too-large = standard_uncertainty_mm darf höchstens { $most } sein; ist es in Mikrometern angegeben?
standing-still-same-points-taken-again = Stillstand: Dieselben Punkte werden immer wieder aufgenommen
start-again = Neu beginnen
start-again-2 = neu beginnen
start-new-calibration = Neue Kalibrierung beginnen
started-scan = einen Scan begonnen
state-laser-colour = laser_wavelength_nm im Datenblatt des Sensors angeben, oder --colour auf der Kommandozeile; oder Graubilder verwenden
stated = nicht angegeben
station-does-answer-name-names-added = Diese Station hört nicht auf den Namen '{ $name }'. Namen kommen mit hosts in station.toml hinzu.
station-ended-during-scan = Die Station endete während dieses Scans.
station-has-administrator-already = Die Station hat schon einen Administrator
station-starting = Die Station startet.
station-toml-driver-has-no-option = station.toml, [{ $table }]: Der Treiber hat keine Option { $key }
station-toml-exposure-range-alone = station.toml, [sensor]: exposure_range_us braucht exposure_us als Anfang
station-toml-gives-counts-per-revolution = station.toml gibt { $counts } counts_per_revolution an, der Messarm hat { $joints } Gelenke
station-toml-key-not-for-video = station.toml, [sensor]: { $key } lässt sich bei einer Videodatei nicht setzen
station-toml-no-such-driver = station.toml, [{ $table }]: Einen Treiber { $name } gibt es nicht
station-toml-option-missing = station.toml, [{ $table }]: Die Option { $key } fehlt
station-toml-value-unusable = station.toml, [{ $table }]: { $key } = { $value } ist nicht brauchbar: { $reason }
station-uses = Die Station benutzt { $process }.
station-uses-and-free = Die Station benutzt { $process }; { $free } sind frei.
stations-disk-full = die Platte der Station ist voll
step-before-one = Das ist kein Schritt vor diesem.
still = Still
still-running = { $title }: läuft noch
still-turn = Noch zu drehen
stop-before-next = vor dem nächsten anhalten
stop-first = Zuerst anhalten
stop-simulation = Simulierten Bediener anhalten
stop-scan-first = zuerst den Scan anhalten
stop-server-give-one-data-folder = Jenen Server anhalten oder diesem mit --data einen eigenen Datenordner geben
stop-station-keep-copy-data-folder = Die Station anhalten, eine Kopie des Datenordners aufheben und mit der letzten Sicherung starten.
stopped-laser-off = Angehalten: Der Laser ist aus.
stopped-scan = einen Scan angehalten
stopped-simulation = den simulierten Bediener angehalten
stored-under-records-scan-or-calibrate-again = Sie liegt im Archiv. Damit scannen oder neu kalibrieren.
straight-above-chessboard-follow-dashed-outline = Von senkrecht über dem Schachbrett aus: { $words }. Dem gestrichelten Umriss folgen.
straight-edges-do-make-block = seine { $segment_count } geraden Kanten ergeben keinen Körper
stripe-about-laser-plane-rms-points =
    Laserlinie um die Laserebene, rms von { $points ->
        [one] { $points } Punkt
       *[other] { $points } Punkten
    }
stripe-axis = Richtung der Laserlinie "{ $axis }"
stripe-choice-is = die Wahl der Laserlinie ist „{ $choice }“
stripe-extracted-grey-images-8-16 = eine Laserlinie wird aus Graubildern von 8 bis 16 Bit gewonnen, Höhe mal Breite
stripe-maximum-width-is = die Höchstbreite der Laserlinie ist { $width }
stripe-minimum-width-is = die Mindestbreite der Laserlinie ist { $width }
stripe-one-level-alone-does-fix = eine Laserlinie auf nur einer Ebene legt die Laserebene nicht fest
stripe-pieces-of =
    { $points ->
        [one] Stücke der Laserlinie haben { $points } Punkt
       *[other] Stücke der Laserlinie haben { $points } Punkte
    }
stripe-points-crests-floors-fit-one = { $points } Punkte der Laserlinie auf Zinnen und Nutgründen passen auf { $rms } rms zu einer Ebene, { $share } der dortigen (Grenze { $agreeing }).
stripe-points-fit-one-laser-plane = { $points } Punkte der Laserlinie passen auf { $rms } rms zu einer Laserebene (Grenze { $stripe_rms_px }), { $share } derer auf dem Objekt (Grenze { $agreeing }).
stripe-px = Laserlinie, px
stripe-threshold-is = die Schwelle der Laserlinie ist { $threshold }
study-compares-several = eine Studie vergleicht mehrere
study-left-out = { $name }: { CLAUSE($reason) }.
study-plane = die Studie gilt einer Ebene
support-bundle-being-made-already = Ein Paket für den Support wird schon erstellt
surface-does-bend = die Fläche ist nicht gekrümmt
swing = Schwenk
swing-about-middle-limit = Jeder Punkt des Schwenks um die Mitte aller, im Koordinatensystem des Messarms. Gestrichelt: die Grenze von { $limit }.
swing-arm = Arm schwenken
swing-arm-about = Arm schwenken um: { $place }
swing-elbow-one-side-other-while = Den Ellbogen von einer Seite zur anderen schwenken, während die Tastkugel in der Pfanne bleibt
swing-further-least = Weiter schwenken: { $swing } von mindestens { $least_swing_deg }.
switch-arm-check-cable-port = Den Messarm einschalten; Kabel prüfen, und ob dies sein Anschluss ist.
switch-arm-off = Den Messarm aus- und einschalten.
switch-arm-sensor-connect-them = Messarm und Sensor einschalten und anschließen.
switch-laser-look-where-lies = Den Laser einschalten, um zu sehen, wo sie liegt.
switch-off-aim-picture-switched-itself = Zum Ausrichten ausschalten. Für das Bild wird er von selbst geschaltet.
switch-over-part = einschalten, über einem Teil
switch-stop-scan = Einschalten oder den Scan anhalten.
switched-laser = den Laser eingeschaltet
switched-laser-off = den Laser ausgeschaltet
table-first-line-names = { $path }: Die erste Zeile nennt { $names }
table-is-empty = sie ist leer; eine Zeile mit Spaltennamen wird erwartet
table-lacks-column = ihrer Tabelle { $table } fehlt { $column }
take-again = Neu aufnehmen
take-again-2 = neu aufnehmen
take-another = { $taken } Eine weitere aufnehmen: { $words }.
take-another-password = Ein anderes nehmen
take-another-pose = Weitere Pose aufnehmen
take-back = Zurückholen
take-bars-other-end-first-drop = Zuerst das andere Stabende aufnehmen oder das letzte verwerfen.
take-longer-one-three-unrelated-words = Ein längeres nehmen; drei unverwandte Wörter sind gut
take-longer-pass-five-seconds-more = Eine längere Überfahrt aufnehmen, fünf Sekunden oder mehr
take-more-pictures-8-more-them = mehr Bilder aufnehmen, 8 oder mehr, um 20° und mehr geneigt
take-more-pictures-all-sides-have = Mehr Bilder aufnehmen, von allen Seiten; das Armmodell neu identifizieren lassen.
take-more-pictures-all-sides-hold = Mehr Bilder aufnehmen, von allen Seiten; den Messarm dabei gedrungen halten.
take-more-pictures-board-all-corners = Mehr Bilder aufnehmen, mit der Tafel in allen Ecken des Bilds.
take-more-pictures-each-turned-against = mehr Bilder aufnehmen, jedes gegen die anderen gedreht, oder das Objekt antasten
take-more-pictures-lasers-line-flat = Mehr Bilder aufnehmen, mit der Laserlinie auf der Fläche der Tafel.
take-more-pictures-like-these = Mehr Bilder aufnehmen, nach allen Seiten geneigt: etwa { $asked } wie diese würden insgesamt genügen. Wenn der Roboter nicht mehr kann, die Grenzen nach dem Bedarf der Scans setzen (--good-um, --usable-um).
take-more-pictures-robot-at-fault = Mehr Bilder aufnehmen, nach allen Seiten geneigt; bei so großen Abweichungen liegt es an der Genauigkeit des Roboters, oder seine Posen sind nicht die des Flansches im Koordinatensystem des Arms. Wenn der Roboter nicht mehr kann, die Grenzen nach dem Bedarf der Scans setzen (--good-um, --usable-um).
take-more-pictures-tilted-all-sides-2 = Mehr Bilder aufnehmen, nach allen Seiten geneigt.
take-more-places-all-over-arms = Mehr Orte aufnehmen, über die ganze Reichweite des Messarms
take-more-places-all-over-reach = Mehr Orte aufnehmen, über die ganze Reichweite, und den Arm an jedem von Seite zu Seite schwenken
take-more-points-more-places = Mehr Punkte aufnehmen, an mehr Orten
take-more-poses-tilted-turned = Weitere Posen aufnehmen, geneigt und gedreht.
take-more-poses-tilted-turned-have = Weitere Posen aufnehmen, geneigt und gedreht; das Armmodell neu identifizieren lassen.
take-more-there-delete-rows = Dort mehr aufnehmen oder die Zeilen löschen
take-more-while-arm-swings = Mehr aufnehmen, während der Arm schwenkt
take-one = Eine davon nehmen: { $languages }
take-one-console-shows-since-stations = Den Code nehmen, den die Konsole seit dem letzten Start der Station zeigt
take-one-place-two-if-there = An ein oder zwei Orten einen benutzen, falls vorhanden.
take-out = { $key } herausnehmen.
take-out-label-face-touched = Herausnehmen oder mit der Fläche bezeichnen, die angetastet wurde
take-pass-again = Die Überfahrt neu aufnehmen
take-picture = Bild aufnehmen
take-picture-2 =
    { $thing ->
        [board] die Tafel aufnehmen
       *[object] das Objekt aufnehmen
    }
take-picture-again = Dieses Bild neu aufnehmen
take-picture-object = Ein Bild des Objekts aufnehmen
take-pictures-different-distances-tilted-different = Bilder aus verschiedenen Abständen aufnehmen oder nach verschiedenen Seiten geneigt
take-pictures-tilted-20-more-two = Bilder aufnehmen, die um 20° und mehr geneigt sind, nach zwei Seiten
take-pictures-turned-20-more-about = Bilder aufnehmen, die um 20° und mehr gedreht sind, um zwei verschiedene Achsen
take-place-again-delete-rows = Diesen Ort neu aufnehmen oder seine Zeilen löschen
take-point = Punkt aufnehmen
take-points-or-delete-file = Welche aufnehmen oder die Datei löschen
take-poses-tilted-left-right-front = Posen aufnehmen, die nach links, rechts, vorn und hinten geneigt und um die Blickrichtung gedreht sind.
take-these-points-again = Diese Punkte neu aufnehmen.
take-touch = Antastung aufnehmen
take-with-laser-or-other-axis = Mit eingeschaltetem Laser und passender Belichtung aufnehmen oder die andere --axis wählen
taken = { $path } wurde mit { $device } { $recorded } aufgenommen
takes-notifications = { $host } nimmt Benachrichtigungen an.
taking-picture = Das Bild wird aufgenommen
tells-whoever-away-what-done-fault = Er sagt denen, die nicht da sind, was fertig, gestört oder fällig ist.
temperature = Temperatur
text-has-half-character = in einem ihrer Texte steht ein halbes Zeichen
than-when-made-beyond-c-due =
    { $how ->
        [warmer] Es ist { $difference } wärmer als bei der Kalibrierung; über { $limit } ist sie fällig.
       *[colder] Es ist { $difference } kälter als bei der Kalibrierung; über { $limit } ist sie fällig.
    }
the-is-for =
    { $device ->
        [sensor] die Kalibrierung gilt für { $known }
       *[arm] die arm.json gilt für { $known }
    }
there-dirt-tip-sphere = Die Tastkugel hat anscheinend { $diameter }, nach dem Datenblatt des Messarms { $expected }: Auf der Tastkugel oder der Kugel ist Schmutz.
there-no-account = Es gibt kein Konto { $name }.
there-no-address-yet = Es gibt noch keine Adresse
there-no-calibration = Es gibt keine Kalibrierung { $calibration_id }.
there-no-calibration-use-calibrate-first = Keine Kalibrierung ist in Gebrauch. Zuerst kalibrieren.
there-no-calibration-use-yet = Noch ist keine Kalibrierung in Gebrauch.
there-no-check-arm = Es gibt keine Armprüfung { $record_id }.
there-no-check-tip = Es gibt keine Tastkugelprüfung { $record_id }.
there-no-command = Es gibt keinen Befehl '{ $name }'.
there-no-earlier-step = Es gibt keinen früheren Schritt '{ $to }'.
there-no-face = Die Fläche „{ $face }“ gibt es nicht.
there-no-fitted-shape-yet = Es gibt noch keine angepasste Form
there-no-gauge-data-folder-yet = Im Datenordner ist noch kein Prüfnormal.
there-no-here =
    { $field ->
        [arm] Einen Messarm „{ $chosen }“ gibt es hier nicht.
        [object] Ein Objekt „{ $chosen }“ gibt es hier nicht.
       *[sensor] Einen Sensor „{ $chosen }“ gibt es hier nicht.
    }
there-no-identification-arm = Eine Identifikation des Messarms { $record_id } gibt es nicht.
there-no-language = eine Sprache '{ $language }' gibt es nicht
there-no-limit = { $title }: { $value }; eine Grenze gibt es nicht.
there-no-map-cloud = Zu Wolke { $number } gibt es keine Karte.
there-no-picture-object-sensor-take = Es gibt kein Bild dieses Objekts mit diesem Sensor. Eines aufnehmen.
there-no-picture-yet-take-one = Es gibt noch kein Bild. Eines aufnehmen.
there-no-points-rectangle = Im Rechteck sind keine Punkte
there-no-scan = Es gibt keinen Scan { $scan_id }.
there-no-scan-find-delay = Es gibt keinen Scan, aus dem sich der Verzug bestimmen lässt
there-no-simulation-real-devices = Echte Geräte haben keinen simulierten Bediener.
there-no-simulation-real-devices-2 = Echte Geräte haben keinen simulierten Bediener
there-no-sphere-diameter-cloud = In dieser Wolke ist keine Kugel von { $diameter } Durchmesser
there-no-such-arm = Einen solchen Messarm gibt es nicht.
there-no-such-artefact-here = Einen solchen Prüfkörper gibt es hier nicht.
there-no-such-cloud = Eine solche Wolke gibt es nicht.
there-no-such-folder = einen solchen Ordner gibt es nicht
there-no-such-gauge = Ein solches Prüfnormal gibt es nicht.
there-no-such-page-3d-view = Diese Seite der 3D-Ansicht gibt es nicht.
there-no-such-touch = Eine solche Antastung gibt es nicht.
there-no-token = Es gibt keinen Schlüssel { $token_id }.
there-no-valid-calibration = es gibt keine gültige Kalibrierung
there-no-verification = Es gibt keine Verifizierung { $record_id }.
there-no-kiosk-link = Es gibt keinen Kiosk-Link { $link_id }.
there-none-yet = Es gibt noch keine.
there-nothing = Unter { $path } gibt es nichts.
there-nothing-verify = Es gibt nichts zu verifizieren
thermometer-cannot-read = Das Thermometer { $path } lässt sich nicht lesen: { $error }
thermometer-reads = Das Thermometer { $path } zeigt { $celsius }
these-files-what-result-made-accepted =
    { $changed ->
        [one] { $changed } dieser Dateien ist nicht die, aus der das Ergebnis entstand und mit der es angenommen wurde.
       *[other] { $changed } dieser Dateien sind nicht die, aus denen das Ergebnis entstand und mit denen es angenommen wurde.
    }
these-joint-angles-but-arm-json = dies sind Gelenkwinkel, aber laut arm.json meldet der Arm Posen
these-metres-where-millimetres-expected = dies sind Meter, erwartet werden Millimeter
these-points-do-tell-better-than = diese Punkte bestimmen ihn nicht besser als die Fertigung
these-radians-where-degrees-expected = das sind Radiant, wo Grad erwartet werden
these-use = Diese sind in Gebrauch
they-cannot-show-whether-arm-better = sie können nicht zeigen, ob der Messarm anderswo besser ist
they-come-more-than-one-camera = sie stammen von mehr als einer Kamera oder wurden skaliert
they-do-come-arm-kind-tip = sie stammen nicht von einem Messarm dieser Art, oder die Tastkugel saß nicht
they-do-determine-camera = sie bestimmen die Kamera nicht
they-do-fix-centre = sie legen ihren Mittelpunkt nicht fest
they-do-lie-one-plane = sie liegen nicht in einer Ebene
they-fix-no-plane = sie legen keine Ebene fest
they-fix-no-sphere = sie legen keine Kugel fest
they-leave-nothing-over-check-parameters = damit bleibt nichts, um { $columns } Parameter zu prüfen
they-lie-almost-one-plane-almost = sie liegen fast auf einer Ebene oder fast in einer Reihe je Ebene
they-recording-but-gave-no-points = Sie sind in der Aufzeichnung, gaben aber keine Punkte; das Kabel des Messarms prüfen.
this-program = dieses Programm
tilt-back-by = { $angle } nach hinten neigen
tilt-front-by = { $angle } nach vorn neigen
tilt-left-by = { $angle } nach links neigen
tilt-level = Neigung gegen die Waagerechte
tilt-right-by = { $angle } nach rechts neigen
tip = Tastkugel
tip-3 = Tastkugel: { $text }
tip-bars-end = Die Tastkugel sitzt im Stabende
tip-check = Tastkugelprüfung
tip-held-seat-moved-max-min = Die Tastkugel bewegte sich in einer Pfanne um { $worst }, (max − min)/2 auf der schlechtesten Achse.
tip-in-seat-moved-limit = Die Tastkugel bewegte sich in einer Pfanne um { $worst }, (max − min)/2 auf der schlechtesten Achse; die Grenze ist { $limit }.
tip-known = Tastkugel bekannt auf
tip-known-apart-from-size = Über seine Reichweite lag die Tastkugel um { $before } rms daneben und ist nun auf { $after } bekannt (k = 1), abgesehen von der Größe des Messarms.
tip-lies-within-mm = die Tastkugel liegt weniger als { $distance } davon entfernt
tip-missing-place-flange-diameter = tip fehlt: der Ort der Tastkugel am Flansch und ihr Durchmesser
tip-never-checked = Die Tastkugel wurde noch nie geprüft.
tip-off-place-arm = Tastkugel neben ihrem Ort am Messarm
tip-over-whole-reach = Tastkugel in der ganzen Reichweite
tip-rather-has = die Tastkugel hat eher { $diameter }, oder die Durchmesser gehören nicht zu den Kugeln
tip-rather-has-or-bar-wrong = die Tastkugel hat eher { $diameter }, oder die Durchmesser gehören nicht zu den Kugeln, oder eine Stablänge ist falsch
tip-seat = Die Tastkugel sitzt in der Pfanne
tip-seat-no-points-taken-there = Die Tastkugel ist { $left } von der Pfanne entfernt; dort werden keine Punkte aufgenommen.
tip-seated-seat-loose-points-another = die Tastkugel saß nicht, oder die Pfanne war locker, oder Punkte eines anderen Orts sind darunter
tip-sits-off-its-place = Die Tastkugel sitzt { $off } neben ihrem Ort im Datenblatt: Der Schaft ist verbogen oder nicht fest eingeschraubt.
tip-sound-diameter-off-touches-agree = Die Tastkugel ist in Ordnung: Ihr Durchmesser weicht um { $off } ab, ihre Antastungen stimmen auf { $scatter } überein.
tip-sphere-diameter-arm = der Tastkugel von einer Kugel dieses Durchmessers, mit dem Messarm, wie er ist
tip-uncertainty-before =
    { $size_known ->
        [yes] war { $before }; k = 1, rms über die Reichweite
       *[no] war { $before }; k = 1, rms über die Reichweite; abgesehen von der Größe des Messarms
    }
tips-coordinates-moved-instead = stattdessen werden die Koordinaten der Tastkugel geändert
tips-diameter = Tastkugeldurchmesser
tips-diameter-how-well-touches-agree = Der Durchmesser der Tastkugel und wie gut ihre Antastungen übereinstimmen.
tips-diameter-off-known-only-k = Der Durchmesser der Tastkugel weicht um { $off } ab, bekannt nur auf { $known } (k = 2).
tips-places = Orte der Tastkugel
tips-places-about-their-middle = Die Orte der Tastkugel um ihre Mitte
titled-text = { $title }: { $text }
to-2 = Bis
together = Zusammen
too-bright-saturated = Zu hell: { $share } übersteuert
too-dark-brightest-parts = Zu dunkel: hellste Stellen bei { $level }
too-fast-blur-limit = Zu schnell: { $blur } Unschärfe; die Grenze ist { $limit }
too-few-edges-could-measured = zu wenige seiner Kanten ließen sich messen
too-few-places-were-touched = zu wenige Orte wurden angetastet: { $count }
too-little-arm-data-yet = Noch zu wenig Daten vom Messarm
too-many-wrong-tries = Zu viele falsche Versuche.
took-cloud-back = eine Wolke wieder aufgenommen
took-control-over = die Bedienung übernommen
took-last-one-back = das Letzte zurückgenommen
took-over-control = { $name } hat die Bedienung von { $holder } übernommen: { $reason }
took-picture = ein Bild aufgenommen
took-picture-again = ein Bild neu aufgenommen
took-point = einen Punkt genommen
took-pose-back = eine Pose wieder aufgenommen
took-support-bundle = das Diagnosepaket geholt
top-all-around-side-wrist-turned = Oben und ringsum an der Seite, das Handgelenk jedes Mal anders gedreht. An jeder Stelle still halten und die Taste am Messarm drücken.
topic-holds = { $path }: { $topic } enthält { $schema } ({ $encoding })
total-k-1 = { $total } (k = 1)
touch = Antasten
touch-2 = { $place } antasten
touch-3 = Antasten
touch-all-over-upper-half-every = Die ganze obere Hälfte antasten, von allen Seiten, mit dem Messarm in vielen Haltungen. An jedem Punkt still halten und die Taste am Messarm drücken.
touch-back-face = Die Rückseite antasten.
touch-elsewhere = An anderer Stelle antasten
touch-face-also-beside-line =
    { $face ->
        [crest] Die Zinnen oben auch neben dieser Geraden antasten
        [floor] Die Nutgründe auch neben dieser Geraden antasten
        [front] Die Vorderseite auch neben dieser Geraden antasten
        [back] Die Rückseite auch neben dieser Geraden antasten
        [left] Die linke Stirnseite auch neben dieser Geraden antasten
        [right] Die rechte Stirnseite auch neben dieser Geraden antasten
       *[other] Die Fläche „{ $face }“ auch neben dieser Geraden antasten
    }
touch-floors-grooves = Die Nutgründe antasten.
touch-front-back-left-right-face = Vorder- und Rückseite oder linke und rechte Stirnseite antasten.
touch-front-face = Die Vorderseite antasten.
touch-gauge = Prüfnormal antasten
touch-gauge-2 = Antastung { $counted } am Prüfnormal.
touch-gauge-more-places-scan-more = Das Prüfnormal an mehr Stellen antasten und langsamer scannen.
touch-left-end = Die linke Stirnseite antasten.
touch-more-contacts = Antasten: { $contacts }
touch-more-least-places = Öfter antasten: { $taken } von mindestens { $touches_needed } Stellen.
touch-more-least-points = Öfter antasten: { $taken } von mindestens { $least } Punkten.
touch-more-places = An mehr Stellen antasten
touch-more-points-spread-wide-over = Mehr Punkte antasten, weit über die Tafel verteilt.
touch-more-points-spread-wide-over-2 = Mehr Punkte antasten, weit über alle sechs Flächen verteilt.
touch-more-sphere = Mehr von der Kugel antasten
touch-near-corners-too = Auch nahe den Ecken antasten
touch-object = Das Objekt antasten
touch-printed-side-more-times-spread = Die bedruckte Seite noch { $left }-mal antasten, weit verteilt. Oder weitermachen.
touch-printed-side-once-more-far = Die bedruckte Seite noch einmal antasten, weit weg von den anderen Punkten. Oder weitermachen.
touch-probe-press-arms-button-each =
    { $shape ->
        [plane] Mit dem Taster nahe den Ecken und in der Mitte antasten und an jeder Stelle die Taste am Messarm drücken.
       *[sphere] Mit dem Taster oben und ringsum an der Seite antasten und an jeder Stelle die Taste am Messarm drücken.
    }
touch-right-end = Die rechte Stirnseite antasten.
touch-scan-gauge-takes-two-minutes = { $text } Ein Prüfnormal antasten und scannen: Es dauert zwei Minuten.
touch-sphere = Die Kugel antasten
touch-sphere-more-spread-over-all = Die Kugel öfter antasten, über die ganze obere Hälfte verteilt.
touch-top-all-around-side = Oben und ringsum an der Seite antasten
touch-tops-merlons = Die Zinnen oben antasten.
touched-sphere-seems-to-have-diameter = Die angetastete Kugel hat anscheinend einen Durchmesser von { $radius }; nach ihrem Kalibrierschein hat sie { $radius2 }.
touches = { $done } von { $of } Antastungen
touches-2 = Antastungen
touches-3 = Die Antastungen
touches-about-sphere-limit = Abstand jeder Antastung von der Kugel durch alle. Gestrichelt: die Grenze von { $limit }.
touches-agree = Antastungen stimmen überein auf
touches-disagree-up-tip-sphere-loose = Die Antastungen weichen bis zu { $scatter } voneinander ab: Tastkugel oder Kugel sind locker, oder der Messarm ist gerutscht.
touches-lie-too-near-together-one = Die Antastungen liegen zu nah beieinander oder auf einem Ring um die Kugel
touches-lie-within-one-line = Die Antastungen liegen innerhalb { $width } um eine Gerade
touches-on-face = { $count } { $where }
touches-over-all-faces = { $total } weitere über alle Flächen, davon { $most } { $where },
touches-rms-known-k-1 = durch { $touches } Antastungen, { $rms } rms, bekannt auf { $known } (k = 1)
touches-would-bring =
    { $total ->
        [one] Objekt bekannt auf { $now } (k = 1); { $words } ergibt { $then }.
       *[other] Objekt bekannt auf { $now } (k = 1); { $words } ergeben { $then }.
    }
touches-would-not-reach =
    { $total ->
        [one] Objekt bekannt auf { $now } (k = 1); { $words } ergibt { $then }, gewünscht sind { $target }.
       *[other] Objekt bekannt auf { $now } (k = 1); { $words } ergeben { $then }, gewünscht sind { $target }.
    }
tried-notifications = die Benachrichtigungen ausprobiert
try-again = Erneut versuchen
try-again-ask-administrator-new-password = Erneut versuchen oder einen Administrator um ein neues Passwort bitten
try-again-if-happens-again-stations = Erneut versuchen. Wenn es wieder geschieht, steht Näheres im Protokoll der Station.
try-again-moment = Gleich noch einmal versuchen
turn-anticlockwise-by = { $angle } gegen den Uhrzeigersinn drehen
turn-clockwise-by = { $angle } im Uhrzeigersinn drehen
turn-down-exposure-until-objects-faces = kürzer belichten, bis die Flächen des Objekts ihr Grau behalten
turn-fault-switch-camera-lost-off = Ihr Fehlerschalter camera_faults.lost ist an; schalten Sie ihn aus.
turn-lamp-until-all-edges-block = Die Lampe drehen, bis sich alle Kanten des Zinnenkörpers zeigen, und ein weiteres Bild aufnehmen.
turn-off-cameras-mirroring-turn-object = die Spiegelung der Kamera ausschalten oder das Objekt so drehen, dass die Vorderseite zur Kamera zeigt
turn-sensor-so-laser-falls-onto = den Sensor so drehen, dass der Laser von oben auf die Tafel fällt
turn-up-light-exposure = mehr Licht oder länger belichten
turn-up-light-exposure-look-object = mehr Licht oder länger belichten, und auf das Objekt richten
two-pictures-named = zwei Bilder heißen { $name } und wären eine Datei in { $folder }
two-seats-or-seat-carried = sie gehören zu zwei Pfannen, oder die Pfanne wurde zwischendurch versetzt
two-seats-or-seat-carried-or-arm = sie gehören zu zwei Pfannen, oder die Pfanne wurde zwischendurch versetzt, oder arm.json ist nicht die dieses Messarms: Auch in anderen Pfannen wandert die Tastkugel { $far }
u-v = es ist "u" oder "v"
uncertainty-missing = { $file }: uncertainty fehlt
uncertainty-over-measuring-volume = Unsicherheit über das Messvolumen
uncertainty-scanned-point-k-1 = Unsicherheit eines Scanpunkts (k = 1)
uncertainty-scanned-point-so-far-k = Unsicherheit eines Scanpunkts bisher (k = 1)
undecided = Nicht entschieden
undo = Zurücknehmen
undo-last-point = Letzten Punkt zurücknehmen
uninstall-one-them = Eines davon deinstallieren.
unit = Einheit
up-poses = { $done } von bis zu { $of } Posen
up-to-taken-one = bis { $rms } gelten noch als eine
update-program-arms-firmware = Dieses Programm oder die Firmware des Messarms aktualisieren.
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
usable = Nicht brauchbar: { $fault }
usable-2 = Nicht brauchbar
usable-attention = Brauchbar, mit Vorbehalt
usable-edge-stripe-points = { $found } brauchbare Kanten- und Laserpunkte
usable-edge-stripe-points-poses = { $found } brauchbare Kanten- und Laserpunkte in { $views } Posen
usable-most = { $total }; brauchbar sind höchstens { $usable }.
use = In Gebrauch
use-2 = { $name } ist in Gebrauch.
use-arm-before-what-identified-kept = Den Messarm benutzen, wie er vorher war? Was identifiziert wurde, bleibt in dieser Sitzung erhalten.
use-arm-now = Diesen Messarm ab jetzt benutzen
use-block-better-certificate = Einen Zinnenkörper mit besserem Kalibrierschein benutzen.
use-board-even-odd-count-inner = eine Tafel mit gerader und ungerader Zahl innerer Ecken benutzen
use-full-pictures-one-sensor = ganze Bilder eines einzigen Sensors benutzen
use-full-pictures-one-sensor-neither = ganze Bilder eines einzigen Sensors benutzen, weder beschnitten noch skaliert
use-method-joint-pictures-board-several = --method joint benutzen, mit Bildern der Tafel von mehreren Seiten
use-object-higher-step-show-crests = ein Objekt mit höherer Stufe benutzen und Zinnen und Nutgründe, vorn und hinten, zeigen
use-object-whose-merlons-differ-width = ein Objekt benutzen, dessen Zinnen verschieden breit sind
use-shorter-cable-port-own-close = Ein kürzeres Kabel und einen eigenen Anschluss benutzen; schließen, was den Rechner sonst beansprucht.
use-switch-sensor = den Schalter am Sensor benutzen
used = Nicht zu benutzen
used-but = Verwendet, aber { $reason }
used-but-2 = verwendet, aber { $reason }
user-may-open-serial-port-another = Dieser Benutzer darf den seriellen Anschluss { $url } nicht öffnen, oder ein anderes Programm hat ihn offen
value = Wert
value-missing = der Wert fehlt
value-must-be = der Wert muss { $expected } sein
value-must-be-at-least = der Wert muss mindestens { $limit } sein
value-must-be-at-most = der Wert darf höchstens { $limit } sein
value-must-be-finite = der Wert muss eine endliche Zahl sein
value-must-be-greater = der Wert muss größer als { $limit } sein
value-must-be-less = der Wert muss kleiner als { $limit } sein
value-must-be-list = der Wert muss eine Liste sein
value-must-be-number = der Wert muss eine Zahl sein
value-must-be-object = der Wert muss ein Objekt mit Feldern sein
value-must-be-one-of = der Wert muss einer von { $expected } sein
value-must-be-text = der Wert muss ein Text sein
value-must-be-true-or-false = der Wert muss true oder false sein
value-must-be-whole-number = der Wert muss eine ganze Zahl sein
value-must-match-pattern = der Text muss dem Muster { $pattern } entsprechen
value-not-known = er ist nicht bekannt
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
values-shares-their-limits-bar-expanded = Werte als Anteile ihrer Grenzen: Der Balken ist die erweiterte Unsicherheit (k = 2), Kreise sind die einzelnen Wolken.
verification = Verifizierung
verification-cannot-read = Die Verifizierung { $one } ist nicht zu lesen.
verification-closed-start-new-one = Diese Verifizierung ist geschlossen. Eine neue beginnen.
verification-cloud = Verifizierung, Wolke { $number }
verification-failed-ago = Nicht bestanden, { $ago } her. { $text }
verification-gauge =
    { $shape ->
        [sphere] Verifizierung an einer Prüfkugel
       *[plane] Verifizierung an einer Prüfebene
    }
verification-undecided-ago = Nicht entschieden, { $ago } her. { $text }
verification-under-way-go-where-stands = Eine Verifizierung läuft. Dort weitermachen, wo sie steht.
verified = Verifiziert: { $text }
verify = Verifizieren
verify-again = Erneut verifizieren
verify-against-gauge-calibrate-again = An einem Prüfnormal verifizieren oder neu kalibrieren.
video-file = Die Videodatei { $source }
video-has-no-picture = { $title } enthält kein Bild
video-stream = Der Videostrom { $source }
video-without-rate = { $title } nennt keine Bildrate
wait = Darauf warten
wait-2 = Warten: { CLAUSE($text) }.
wait-check-what-taken-kept = Warten oder ihn prüfen. Was aufgenommen wurde, ist erhalten.
wait-moment-load-page-again = kurz warten oder die Seite neu laden
wait-s-then-try-again = { $wait } warten und erneut versuchen
wait-stop = Warten oder anhalten
wait-until = warten, bis er es ist
wait-until-arm-connected-again-nothing = warten, bis der Messarm wieder verbunden ist; nichts ging verloren
wait-until-back = warten, bis er wieder da ist
wait-until-connected = warten, bis er verbunden ist
wait-until-does = warten, bis es kommt
wait-until-done = warten, bis es fertig ist
wait-until-has-ended = warten, bis es beendet ist
wait-until-sensor-connected-capture-again = warten, bis der Sensor verbunden ist, und neu aufnehmen
waiting-s-first-data = Warten auf erste Daten: { $title }
kiosk-can-only-view = Eine Kiosk-Anzeige zeigt nur an.
wanted-points-fit = gewünscht: { $target }; Punkte passen auf { $rms }
webhook = Webhook
went-another-pose = zu einer weiteren Pose weitergegangen
went-back-points = zu den Punkten zurückgegangen
went-more-clouds = zu weiteren Wolken weitergegangen
went-result = zum Ergebnis weitergegangen
went-step-back = einen Schritt zurückgegangen
went-without-probe = ohne den Taster weitergegangen
what-and-why = { CAPITAL(CLAUSE($what)) }: { CLAUSE($why) }.
what-calibrated = Was kalibriert wurde
what-cannot-read-set-aside-everything = Was nicht zu lesen ist, wird unverändert beiseitegelegt; alles andere steht zur Verfügung.
what-checked = Was geprüft wurde
what-clouds-show-against-certificate = Was die Wolken gegen den Kalibrierschein des Prüfnormals und gegen den Taster zeigen.
what-identified = Was identifiziert wurde
what-looks-may-good-bad = Was sie betrachtet, kann gut oder schlecht sein.
what-passed-over-plane = überfahren wurde keine Ebene
what-recorded-kept = { $interrupted } Was aufgezeichnet wurde, ist erhalten.
what-recorded-kept-2 = Was aufgezeichnet wurde, ist erhalten.
what-sent-did-arrive-within = Das Gesendete kam nicht innerhalb von { $limit } an.
what-shows-could-more-than-one = was es zeigt, könnte mehr als ein Teil des Objekts sein
what-shows-reads-rather-like-objects = was es zeigt, liest sich eher wie das Spiegelbild des Objekts
what-standard-uncertainty-k-1-scanned = Quellen der Standardunsicherheit (k = 1) eines gescannten Punkts.
what-taken-kept-folder = Was aufgenommen wurde, bleibt in seinem Ordner.
what-tip-moved-while-held-one = Wie weit sich die Tastkugel bewegte, während sie an einem Ort gehalten wurde.
what-verified = Was verifiziert wurde
where-sensor-sits-along-axis-cannot = wo der Sensor entlang dieser Achse sitzt, lässt sich nicht bestimmen
who-reads-along-has-passwords-can = Wer mitliest, kennt Passwörter und kann unter fremdem Namen handeln.
whoever-helps-you-asks-first = Wer hilft, fragt zuerst danach.
whole = Sie ist in Ordnung, { $size_mb }.
whole-number-zero-more-expected = eine ganze Zahl, null oder mehr, wird erwartet
whole-program-stood-still-longest =
    { $count ->
        [one] das ganze Programm stand einmal, { $longest } lang
       *[other] das ganze Programm stand { $count }-mal, am längsten { $longest }
    }
why = Warum
wide = { $wide } breit
widths-positive-ascend-choice-one = Breiten sind positiv und steigen an; die Wahl ist eine von { $choices }
with-radius = Radius { $radius }
with-tip = Tastkugel { $diameter }
within-limit = Innerhalb der Grenze
within-limit-m = { $half_range }, innerhalb der Grenze von { $limit }.
without-ball-bar-arm-keeps-size = Ohne Kugelstab behält der Messarm die Größe aus seinem Datenblatt.
without-ball-bar-arms-size-observable = ohne Kugelstab ist die Größe des Messarms nicht bestimmbar
without-free-memory-whole-machine-slows = Ohne freien Arbeitsspeicher wird der ganze Rechner langsam, und Bilder gehen verloren.
without-nothing-measured-what-taken-kept = Ohne das wird nichts gemessen; was aufgenommen wurde, ist erhalten.
without-one-pixels-cannot-become-points = ohne eine können Pixel nicht zu Punkten werden
without-schema = ohne Schema
word-above = oben
word-ambient = Umgebungslicht
word-arm = Messarm
word-back = Rückseite
word-ball = Kugel
word-bar = Stab
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
word-crest = Zinnen oben
word-crests = Zinnen oben
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
working-out-uncertainty = Die Unsicherheit wird berechnet
working-out-which-pose-would-help = Es wird berechnet, welche Pose am meisten hilft
worn-has-flat = Die Tastkugel hat anscheinend { $diameter }, nach dem Datenblatt des Messarms { $expected }: Sie ist abgenutzt oder hat eine Abflachung.
write-one = einen eingeben
writing-cloud = Wolke wird geschrieben
writing-scan = Scan wird geschrieben
wrong-code = falscher Code
wrong-password = falsches Passwort
you-do-have-control = Die Bedienung liegt nicht hier
zone-has-no-area = Zone { $number } hat keine Fläche
zone-outside-picture = Zone { $number } liegt außerhalb des Bildes
zone-reaches-far-beyond-picture = Zone { $number } reicht weit über das Bild hinaus
zones-cannot-set-now = Zonen lassen sich jetzt nicht setzen
zones-picture-pixels-left-out-sensors = Die Zonen gelten für ein Bild von { $width_px } × { $height_px } Pixeln und bleiben außer Betracht; das des Sensors hat { $width_px2 } × { $height_px2 }

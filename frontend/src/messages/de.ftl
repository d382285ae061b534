# Die eigenen Texte des Clients; die der Station stehen in app/crenel/messages. In der Syntax von Project Fluent.

ui-3d-view = 3D-Ansicht
ui-95-percent-within = 95 % innerhalb
ui-a-kiosk-display = eine Kiosk-Anzeige
ui-a-kiosk-display-can-only-view = Eine Kiosk-Anzeige zeigt nur an.
ui-a-record-not-live = Eine Aufnahme aus dem Archiv, nicht live
ui-a-scan-is-running = Ein Scan läuft.
ui-a-usual-arm = Ein üblicher tragbarer Messarm
ui-accepted = Angenommen
ui-accepted-calibrations-appear-newest-first-accept = Hier erscheinen angenommene Kalibrierungen, die neueste zuerst. Auf der Seite „Kalibrieren“ eine annehmen.
ui-accepted-verifications-appear-newest-first-make = Hier erscheinen angenommene Verifizierungen, die neueste zuerst. Auf der Seite „Verifizieren“ eine durchführen.
ui-accounts = Konten
ui-accuracy-of-a-scanned-point = Standardunsicherheit eines gescannten Punkts, k = 1
ui-actions-by-user = Aktionen nach Benutzer
ui-active = aktiv
ui-activity-of-since = { $title }, { $who }, seit { $since }
ui-activity-since = { $title }, seit { $since }
ui-add = Hinzufügen
ui-add-a-certificate-dcc = Kalibrierschein (DCC) hinzufügen
ui-add-a-file = Datei hinzufügen
ui-add-a-joint = Gelenk hinzufügen
ui-add-a-length = Länge hinzufügen
ui-add-a-table = Tabelle hinzufügen (CSV)
ui-address = Adresse
ui-adjust-to-the-line = An die Linie anpassen
ui-administrator = Administrator
ui-after = Nachher
ui-after-lowercase = nachher
ui-against-a-gauge = an einem Prüfnormal
ui-against-previous-calibration-dashed-uncertainties-both = gegenüber der vorigen Kalibrierung; gestrichelt: was die Unsicherheiten beider für einen unbewegten Sensor zulassen (k = 2)
ui-against-the-last-calibration = Gegenüber der letzten Kalibrierung
ui-against-the-mean-of-all = gegenüber dem Mittelwert aller
ui-against-the-touched-gauge = gegenüber dem angetasteten Prüfnormal
ui-age = Alter
ui-age-relative-to-the-newest-point = Alter gegenüber dem neuesten Punkt
ui-alarm-and-more = { $alarm } (und { $n } weitere)
ui-alarms = Alarme
ui-all = Alle
ui-all-n = Alle { $n }
ui-all-records = Gesamtes Archiv
ui-all-stations = Alle Stationen
ui-also-rebuild-with-the-newer-ones = Auch mit den neueren neu berechnen
ui-also-record-pictures = Auch Bilder aufzeichnen
ui-ambient = Umgebung
ui-ambient-temperature = Raumtemperatur
ui-angle = Winkel
ui-angle-between-laser-and-camera = Winkel zwischen Laser und Kamera
ui-angle-between-the-normals = Winkel zwischen den Normalen
ui-angle-lowercase = Winkel
ui-another-arm = Anderer Messarm
ui-another-camera = Andere Kamera
ui-answer = Antwort
ui-applies-browser-files-reports-csv-stay = Gilt für diesen Browser. Dateien, Berichte und CSV bleiben in mm und µm.
ui-apply-limits = Grenzen übernehmen
ui-arm = Messarm
ui-arm-and-sensor = Arm und Sensor
ui-arm-and-tip = Messarm und Tastkugel
ui-arm-check = Armprüfung
ui-arm-checks-max-min-2-worst = Armprüfungen: (max − min)/2 auf der schlechtesten Achse
ui-arm-checks-tip-checks-identifications-appear = Hier erscheinen Armprüfungen, Tastkugelprüfungen und Identifikationen, die neuesten zuerst. Auf der Seite „Messarm und Tastkugel“ starten.
ui-arm-identification = Identifikation des Messarms
ui-arm-identifications = Identifikationen des Messarms
ui-arm-in-use-by = Messarm in Gebrauch: { $activity }
ui-arm-is-in-use-end-it = Der Messarm ist in Gebrauch: { $activity }. Das beenden und hier weitermachen? Ein Scan wird gestoppt und gespeichert; eine geführte Sitzung bleibt offen und kann fortgesetzt werden.
ui-arm-lowercase = Messarm
ui-arm-needs-its-model = Eine Kalibrierung braucht das kinematische Modell dieses Messarms mit { $joints } Gelenken: Geben Sie es unter Datenblätter ein, oder fügen Sie dort seine arm.json hinzu.
ui-arm-of-poses-needs-no-more = Eine Kalibrierung braucht eines. Dieser Messarm meldet Posen, darum genügt sein Name.
ui-arm-sensor-detected-automatically-missing-device = Messarm und Sensor werden automatisch erkannt. Fehlt ein Gerät, wird der Grund angezeigt; es verbindet sich automatisch wieder.
ui-arm-serial = Messarm { $serial }
ui-arm-swings-side-side-while-tip = Ein Messarm schwenkt hin und her, während seine Tastkugel in einer Pfanne bleibt
ui-arm-tip = Messarm und Tastkugel
ui-arm-with-joints = Messarm mit Gelenken
ui-arms = Messarme
ui-arms-main-button-continues-long-press = Mit der Haupttaste am Messarm geht es weiter; langes Drücken der Rücknahmetaste führt einen Schritt zurück.
ui-arms-main-button-starts-ends-cloud = Die Haupttaste am Messarm beginnt eine Punktwolke und schließt sie ab. Die Rücknahmetaste schließt die letzte aus; langes Drücken führt einen Schritt zurück.
ui-arms-main-button-takes-contact-point = Die Haupttaste am Messarm nimmt einen Antastpunkt auf. Die Rücknahmetaste entfernt ihn; langes Drücken führt einen Schritt zurück.
ui-arms-main-button-takes-long-press = Die Haupttaste am Messarm nimmt das Bild auf; langes Drücken der Rücknahmetaste führt einen Schritt zurück.
ui-arms-main-button-takes-point-undo = Die Haupttaste am Messarm nimmt einen Punkt auf. Die Rücknahmetaste entfernt ihn; langes Drücken führt einen Schritt zurück.
ui-arms-main-button-triggers-large-button = Die Haupttaste am Messarm löst die große Schaltfläche hier aus.
ui-arranged-as-before-opencv-4-6 = Marker angeordnet wie vor OpenCV 4.6
ui-arrows-detected-minus-computed-corners-magnified = Pfeile: erkannt minus berechnet, Ecken { $times }-fach, Laserlinie { $stripe }-fach vergrößert.
ui-arrows-detected-minus-computed-magnified-times = Pfeile: erkannt minus berechnet, { $times }-fach vergrößert.
ui-artefact = Prüfkörper
ui-articulations = Stellungen
ui-as-a-check = { $label }, zur Kontrolle
ui-as-drawn = Laut Zeichnung
ui-as-fast-as-possible = mit maximaler Geschwindigkeit
ui-as-its-certificate-says = Werte so eintragen, wie Kalibrierschein oder Hersteller sie angeben.
ui-as-measured = Gemessen
ui-as-of = Stand { $when }
ui-as-of-ago = Stand vor { $age }
ui-as-people-call-it-optional = So, wie man es hier nennt; darf leer bleiben.
ui-as-proposed = Wie vorgeschlagen
ui-ask-administrator-new-link = Einen Administrator um einen neuen Link bitten
ui-at-least-10-characters = Mindestens 10 Zeichen
ui-at-least-10-characters-sentence = Mindestens 10 Zeichen.
ui-at-the-original-speed = in Originalgeschwindigkeit
ui-at-times-the-original-speed = mit { $n }-facher Geschwindigkeit
ui-attention = Achtung
ui-audit-log = Aktionsprotokoll
ui-automatic = Automatisch
ui-automatic-lowercase = automatisch
ui-back-to-live = Zurück zu live
ui-back-to-the-calibration = Zurück zur Kalibrierung
ui-back-to-the-list = Zurück zur Liste
ui-back-to-the-table = Zurück zur Tabelle
ui-back-up-now = Jetzt sichern
ui-back-y = Rückfläche Y
ui-backup = Sicherung
ui-backup-copies-calibrations-scans-accounts-settings = Eine Sicherung kopiert Kalibrierungen, Scans, Konten und Einstellungen im laufenden Betrieb. Zum Wiederherstellen die Station beenden und mit diesem Ordner neu starten:
ui-ball-bar = Kugelstab
ui-band-is-permissible-error = das Band ist die zulässige Abweichung
ui-bars-test-value-uncertainty-dashed-limit-as-of-test = Balken: Unsicherheit des Prüfwerts, k = 2. Gestrichelt: der Grenzwert der jeweiligen Prüfung.
ui-base-z = Unterseite Z
ui-before = Vorher
ui-before-and-after = Vorher und nachher
ui-before-difference-identified-arm-after-standard = Vorher: Abweichung vom identifizierten Messarm. Nachher: Standardunsicherheit, k = 1. Beides rms.
ui-before-lowercase = vorher
ui-before-measuring-touch-sphere-known-diameter = Vor dem Messen eine Kugel mit bekanntem Durchmesser neunmal antasten. So zeigt sich sofort, ob die Tastkugel abgenutzt, verbogen oder die falsche ist. Das dauert eine Minute.
ui-begun = Begonnen
ui-being-checked = Wird geprüft…
ui-being-measured = wird ausgewertet
ui-being-scanned = wird gescannt
ui-beyond = über dem Grenzwert von { $limit }
ui-beyond-the-chart = außerhalb des Diagramms
ui-block-column = Zinnenkörper
ui-block-depth = Tiefe, vorn bis hinten
ui-block-follows-the-numbers = Hier erscheint der Zinnenkörper mit der Laserlinie, sobald er entworfen ist.
ui-block-height = Höhe
ui-block-is-designed = Der Zinnenkörper wird entworfen
ui-block-under-the-laser = Der vorgeschlagene Zinnenkörper mit der Laserlinie
ui-block-with-dimension = Der Block mit dem Maß, das eingegeben wird
ui-blur = Unschärfe
ui-blur-above-which-pass-too-fast = Unschärfe, ab der eine Überfahrt zu schnell ist
ui-board-to-print = Die Tafel zum Drucken
ui-brighter = Heller
ui-bring-back = Zurückholen
ui-browser-displays-notifications-only-over-https = Dieser Browser zeigt Benachrichtigungen nur über HTTPS oder direkt an der Station an. In station.toml tls_certificate und tls_key angeben.
ui-buttons-that-change-something-are-disabled = Knöpfe, die etwas ändern, sind so lange gesperrt.
ui-by-scan = Durch Scannen
ui-by-scan-takes-three-scans = Durch Scannen kommen in jeder Lage nach den Antastungen drei Scans des ganzen Stabs hinzu. Das steht mit der ersten Antastung fest.
ui-by-touch = Durch Antasten
ui-by-touch-and-by-scan = Durch Antasten und Scannen
ui-by-webhook = Per Webhook
ui-calibrate = Kalibrieren
ui-calibrate-the-sensor = Sensor kalibrieren
ui-calibrated-lengths = Kalibrierte Längen
ui-calibrated-to = kalibriert { $low } bis { $high }
ui-calibration = Kalibrierung
ui-calibration-certificate-dcc = Digitaler Kalibrierschein
ui-calibration-good-check-gauge = Ist die Kalibrierung in Ordnung? Mit einem Prüfnormal prüfen
ui-calibration-objects = Kalibrierobjekte
ui-calibration-old = Kalibrierung: { $age } alt
ui-calibrations = Kalibrierungen
ui-calibrations-older-versions-no-map = Kalibrierungen aus älteren Versionen enthalten keine Karte.
ui-calliper = Messschieber
ui-camera = Kamera
ui-camera-lowercase = Kamera
ui-camera-offline-picture-old = Die Kamera ist nicht erreichbar. Dieses Bild ist { $age } alt.
ui-cameras = Kameras
ui-cancel = Abbrechen
ui-cancel-the-test = Prüfung abbrechen
ui-cancelled = Abgebrochen
ui-cannot-displayed-files-missing-data-folder = Anzeige nicht möglich: Die Dateien fehlen im Datenordner, oder die Station ist nicht erreichbar.
ui-captured-picture-corners-outline-stripe = Das aufgenommene Bild mit Ecken, Umriss und Laserlinie
ui-cell-mean-points = jede Zelle von { $size } ist der Mittelwert ihrer Punkte
ui-cells-can-be-pasted = Aus einer Tabellenkalkulation kopierte Zellen lassen sich einfügen: Sie füllen die Tabelle ab der gewählten Zelle.
ui-centre-error = Mittelpunktabweichung
ui-centre-error-lowercase = Mittelpunktabweichung
ui-certificate = Kalibrierschein
ui-certificate-is-not-signed = Der Kalibrierschein (DCC) ist deutsch und englisch. Er ist nicht signiert und nicht gegen das Schema geprüft.
ui-certificate-is-not-utf-8 = { $name } ist kein UTF-8-Text: Den Kalibrierschein als XML wählen.
ui-certificate-issued-on = Kalibrierschein ausgestellt am
ui-certificate-of = Kalibrierschein { $certificate }
ui-certificate-valid-until = Kalibrierschein gültig bis
ui-certified-by = Bescheinigt durch
ui-certified-by-help = Wie es in Berichten steht, mit der Nummer des Kalibrierscheins, falls es eine gibt.
ui-certify = Vermessen
ui-certify-a-block = Block vermessen
ui-certify-this-block = Diesen Block vermessen
ui-change = Änderung
ui-change-password = Passwort ändern
ui-change-the-password = Passwort ändern
ui-changed-parameters-arm-uncertainty-k-1 = Geänderte Parameter des Messarms, Unsicherheit k = 1
ui-changes-between-calibrations-appear-second-one = Ab der zweiten Kalibrierung erscheinen hier die Änderungen.
ui-charuco-board = ChArUco-Tafel
ui-check-network-page-reconnects-automatically-then = Netzwerk prüfen. Diese Seite verbindet sich automatisch wieder; danach erneut versuchen.
ui-check-the-arm = Messarm prüfen
ui-check-the-tip = Tastkugel prüfen
ui-check-where-largest-residuals-pose-excluded = Prüfen, wo die größten Residuen liegen. Eine Pose lässt sich ausschließen und wieder einbeziehen.
ui-checking-the-station = Station wird geprüft …
ui-checks = Prüfungen
ui-checks-could-not-loaded-they-reload = Die Prüfungen konnten nicht geladen werden. Sie werden neu geladen, sobald die Station wieder da ist.
ui-checks-over-time = Prüfungen im zeitlichen Verlauf
ui-chessboard = Schachbrett
ui-chessboard-laser-stripe-across = Ein Schachbrett, darüber die Laserlinie
ui-choose-a-device-and-try-it = Wählen Sie ein Gerät und probieren Sie es aus. Bis Sie es verwenden, ändert sich nichts.
ui-choose-a-file = Datei wählen
ui-choose-a-picture = Bild wählen …
ui-choose-another-scan = Einen weiteren Scan wählen, um sie zusammenzuführen oder zu vergleichen.
ui-choose-how-it-is-connected = Wählen Sie, wie es angeschlossen ist, und geben Sie die Adresse ein.
ui-choose-none = Keinen wählen
ui-choose-record = { $name } wählen
ui-choose-the-arm = Messarm wählen
ui-clamp-gauge-within-arms-reach = Prüfnormal in Reichweite des Messarms aufspannen.
ui-clamp-must-not-move-between-first = Prüfnormal aufspannen. Zwischen dem ersten Antastpunkt und der letzten Punktwolke darf es sich nicht bewegen.
ui-clamp-object-cannot-move-until-last = Objekt so aufspannen, dass es sich bis zum letzten Bild nicht bewegen kann.
ui-clamp-object-clean-tip-takes-few = Objekt aufspannen, Tastkugel reinigen. Das dauert wenige Minuten.
ui-clear = Alle Zonen löschen
ui-close = Schließen
ui-cloud = Punktwolke
ui-cloud-n = Punktwolke { $n }
ui-clouds = Punktwolken
ui-clouds-and-calibrations = Punktwolken und Kalibrierungen
ui-code = Code
ui-code-on-the-console = Code auf der Konsole
ui-coefficient = Koeffizient
ui-coefficient-of-expansion = Wärmeausdehnungskoeffizient
ui-colour-by = Einfärben nach
ui-colour-by-deviation = Nach Abweichung einfärben
ui-columns-of-inner-corners = Spalten innerer Ecken
ui-compare = Vergleichen
ui-compare-with = Vergleichen mit
ui-compared-points = Verglichen
ui-compared-with-the-probe = mit dem Taster verglichen
ui-comparison = Vergleich
ui-comparison-is-scatter-and-change = Jeder Punkt von der Ebene durch seine Nachbarn auf dem anderen Scan: die Streuung beider Scans und was sich zwischen ihnen geändert oder bewegt hat. Das ist keine Messunsicherheit.
ui-comparison-of-two-calibrations = Die Scans haben verschiedene Kalibrierungen, deren Abweichungen darin stecken.
ui-complete-cloud-stays-end = Am Ende bleibt die vollständige Punktwolke hier stehen.
ui-complete-cloud-stays-replay-run-crenel = Die vollständige Punktwolke bleibt hier stehen. Zum Wiederholen crenel replay erneut starten.
ui-completed-jobs-faults-due-calibrations-also = Fertige Aufträge, Störungen und fällige Kalibrierungen werden auch gemeldet, wenn ein anderes Fenster im Vordergrund ist.
ui-connect-your-own-devices = Eigene Geräte anschließen
ui-connected = verbunden
ui-connected-and-waiting-for-data = Es ist verbunden und hat noch nichts gesendet.
ui-connected-badge = Angeschlossen
ui-connecting = wird verbunden …
ui-connecting-to-the-station = Verbindung zur Station wird aufgebaut
ui-connection = Verbindung
ui-connection-lost-reconnecting = Verbindung unterbrochen, wird wiederhergestellt
ui-console-runs-crenel-displays-link-open = Die Konsole, in der Crenel läuft, zeigt einen Link an. Diesen öffnen oder den Teil nach code= eingeben.
ui-console-runs-crenel-states-reason-remedy = Die Konsole, in der Crenel läuft, nennt Grund und Abhilfe. Diese Seite läuft weiter, sobald die Station neu gestartet ist.
ui-contact = Antastpunkt
ui-contact-about = Die Antastprüfungen nach ASME B89.4.22: wirksamer Durchmesser an einer Meisterkugel, drei Pfannen und ein Kugelstab in zwanzig Lagen. 217 Antastungen, von Hand etwa 40 Minuten.
ui-contact-needs = Eine kalibrierte Meisterkugel, eine Kegelpfanne, die sich an drei Stellen festklemmen lässt, und ein Kugelstab mit Kalibrierschein. Kugel oder Stab können entfallen.
ui-contact-points-few-pictures-calibrated-sensor = Mit Antastpunkten und wenigen Bildern zum kalibrierten Sensor
ui-contact-points-from-above = Antastpunkte von oben
ui-contact-points-rms = Antastpunkte, rms
ui-contact-test = Antastprüfungen
ui-contact-test-title = Antastprüfungen
ui-continue-the-test = Prüfung fortsetzen
ui-continue-this-scan = Diesen Scan fortsetzen
ui-continue-to-home = Weiter
ui-continue-verification = Verifizierung fortsetzen
ui-control = Bedienung
ui-control-and-sign-in = Bedienung und Anmeldung
ui-control-requested = Bedienung angefragt
ui-control-was-not-released = die Bedienung wurde nicht abgegeben
ui-control-was-not-requested = die Bedienung wurde nicht angefragt
ui-control-was-not-taken = die Bedienung wurde nicht übernommen
ui-control-who = Bedienung: { $who }
ui-convention = Konvention
ui-coordinates-of-a-tracker = Koordinaten eines Lasertrackers (coordinates.csv)
ui-coordinates-points-taken = Koordinaten eines Lasertrackers: { $points } Punkte übernommen
ui-copied-in-mm-and-m = Kopiert, in mm und µm
ui-copy = Kopieren
ui-copy-as-csv = Als CSV kopieren
ui-copy-of = { $name } (Kopie)
ui-copying = Wird kopiert …
ui-corner = Ecke
ui-corner-residual = { $corner }: Residuum { $value }
ui-corner-zone-arrow-keys-move-delete = Ecke { $corner } von Zone { $zone }; Pfeiltasten verschieben sie, Entf entfernt sie
ui-corners = Ecken
ui-corners-and-the-laser-stripe = { $corners } Ecken und die Laserlinie
ui-corners-no-laser-stripe = { $corners } Ecken, keine Laserlinie
ui-corners-rms = Ecken, rms
ui-correct-what-is-marked = Zuerst berichtigen, was markiert ist
ui-correct-what-is-said = Berichtigen, was neben der Zeichnung steht
ui-correlated-well-determined-together-less-well = Korreliert: gemeinsam gut bestimmt, einzeln weniger gut
ui-corrupt-records = Beschädigt
ui-country-of-the-laboratory = Land, zwei Buchstaben
ui-create-account = Konto anlegen
ui-create-link = Link anlegen
ui-create-the-administrators-account = Konto des Administrators anlegen
ui-create-token = Token anlegen
ui-created-by = angelegt von { $name }, { $when }
ui-crenellated-block = Zinnenkörper
ui-crenellated-object-laser-stripe-across = Ein Zinnenkörper, darüber die Laserlinie
ui-crest-z = Zinnenoberseiten Z
ui-cross-validated-places-left-out-fit = { $n ->
        [one] Kreuzvalidiert an { $n } Position, die nicht in die Ausgleichung eingeht: rms, einschließlich des Rauschens der Winkelgeber.
       *[other] Kreuzvalidiert an { $n } Positionen, die reihum nicht in die Ausgleichung eingehen: rms, einschließlich des Rauschens der Winkelgeber.
    }
ui-current-activity = Aktueller Vorgang
ui-current-step = Aktueller Schritt
ui-customer = Kunde
ui-cut = Schneiden
ui-cut-points-away = Punkte wegschneiden
ui-cut-what-is-inside = Innen wegschneiden
ui-cuts-leave-the-recording-whole = Gespeicherte Wolken und Messungen lassen das Weggeschnittene aus. Die Aufzeichnung behält es.
ui-cylinder = Zylinder
ui-dark-display = Dunkles Design
ui-darker = Dunkler
ui-dashed = gestrichelt
ui-dashed-is-permissible-error = gestrichelt die zulässige Abweichung
ui-dashed-the-limit = Gestrichelt: der Grenzwert, ±{ $value }.
ui-data-types = Datentypen
ui-datasheet-is-not-utf-8 = { $name } ist kein UTF-8-Text: ein Datenblatt als JSON oder einen Kalibrierschein als XML wählen.
ui-datasheets = Datenblätter
ui-days = { $n ->
        [one] { $n } Tag
       *[other] { $n } Tage
    }
ui-days-ago = { $n ->
        [one] vor { $n } Tag
       *[other] vor { $n } Tagen
    }
ui-decision = Entscheidung
ui-decision-rule-changed-values-comparable = Die Entscheidungsregel hat sich zwischen diesen Prüfungen geändert; Werte, Unsicherheiten und Grenzwerte bleiben vergleichbar.
ui-degrees = Grad
ui-delay-between-arm-and-camera = Zeitversatz zwischen Messarm und Kamera
ui-delete = Löschen
ui-delete-recording-points-removed-disk-permanently = { $name } löschen? Die Aufzeichnung und die { $points } Punkte werden endgültig vom Datenträger entfernt.
ui-demonstration = Vorführung
ui-denavit-hartenberg-modified = Denavit-Hartenberg, modifiziert
ui-denavit-hartenberg-standard = Denavit-Hartenberg, Standard
ui-denavit-hartenberg-table = Denavit-Hartenberg-Tabelle
ui-depth-of-field = Schärfentiefe
ui-depth-of-grooves = Tiefe der Nuten
ui-depth-range = Tiefenbereich
ui-design-a-block = Zinnenkörper entwerfen
ui-detected-line-drawn-red-picture-changes = Die erkannte Linie ist im Bild rot eingezeichnet. Änderungen gelten sofort und werden gespeichert.
ui-determine-from-the-last-scan = Aus dem letzten Scan bestimmen
ui-determined-not-in-use-yet = Bestimmt, noch nicht verwendet.
ui-determining-the-delay = Zeitversatz wird bestimmt …
ui-deviation = Abweichung
ui-deviation-from = Abweichungen von { $name }, außen positiv.
ui-deviation-from-scan = Abweichung von { $name }
ui-deviation-from-the-shape = Abweichung von der Form
ui-deviations-from-the-fitted-shape = Abweichungen von der eingepassten Form
ui-device-connection-lost = { $device }: Verbindung unterbrochen
ui-devices = Geräte
ui-devices-cannot-be-saved-here = Hier können keine Geräte gespeichert werden
ui-diameter = Durchmesser
ui-diameter-error = Durchmesserabweichung
ui-diameter-from-the-certificate = Durchmesser laut Kalibrierschein
ui-diameter-of-the-spheres = Durchmesser der Kugeln
ui-dictionary = Wörterbuch der Marker
ui-disk = Datenträger
ui-disk-space = Datenträger { $space }
ui-dismiss = Schließen
ui-displacement-scanned-point-since-rms-most = Verschiebung eines gescannten Punkts seit { $name }: { $rms } rms, höchstens { $most }.
ui-display = Anzeige
ui-display-more = { $n } weitere anzeigen
ui-displayed-scans = Angezeigte Scans
ui-distance = Abstand
ui-distance-between-the-centres = Abstand der Mittelpunkte
ui-distance-from-its-face-outward = Abstand von der Fläche, + nach außen.
ui-distance-known-once-board-touched-more = Der Abstand ist bekannt, sobald die Tafel an weiteren Stellen angetastet ist.
ui-distance-known-once-three-adjacent-faces = Der Abstand ist bekannt, sobald drei aneinandergrenzende Flächen angetastet sind.
ui-distance-tips-centre-place = Abstand des Tastkugelmittelpunkts von seiner Soll-Lage
ui-distances-rms = Abstände, rms
ui-do-not-continue = Nicht fortsetzen
ui-done = erledigt
ui-done-of-all = { $done } von { $all }
ui-done-scan-saved-calibration-accepted = Erledigt: Scan gespeichert, Kalibrierung angenommen
ui-drag-corner-move-small-dot-add = Zum Verschieben eine Ecke ziehen, für eine neue Ecke einen kleinen Punkt ziehen; Entf entfernt eine Ecke.
ui-draw-a-rectangle-around-what-goes = Ziehen Sie ein Rechteck um das, was weg soll.
ui-draw-a-rectangle-around-what-stays = Ziehen Sie ein Rechteck um das, was bleiben soll.
ui-draw-a-rectangle-over-the-cylinder = Ein Rechteck über den Zylinder ziehen
ui-draw-a-rectangle-over-the-plane = Ein Rechteck über die Ebene ziehen
ui-draw-a-rectangle-over-the-sphere = Ein Rechteck über die Kugel ziehen
ui-draw-a-zone = Zone zeichnen
ui-draw-press-picture-drag = Zum Zeichnen auf das Bild drücken und ziehen.
ui-drawing-follows-the-numbers = Die Zeichnung folgt den Zahlen.
ui-drawing-of-the-datasheet = Zeichnung des Datenblatts
ui-drawn-as-the-arm-stands = Gezeichnet, wie { $name } jetzt steht: Ein Gelenk bewegen, und die Zeichnung dreht sich mit. Ziehen zeigt eine andere Seite.
ui-drawn-with-joints-at-zero = Gezeichnet mit allen Gelenken bei 0° oder an der nächsten Grenze. Ziehen zeigt eine andere Seite.
ui-due = fällig
ui-due-a-calibration-is-too-old = Fällig: Eine Kalibrierung ist zu alt
ui-due-old = fällig, { $age } alt
ui-duration = Dauer
ui-edges = Kanten
ui-edges-along-x = Kanten entlang X
ui-edges-are-entered-as = Die Kanten werden eingetragen als
ui-edges-rms = Kanten, rms
ui-edit = Bearbeiten
ui-eight-poses = Acht Posen
ui-else-as-identified = Quadratisches Mittel über den Arbeitsraum; sonst wie identifiziert
ui-else-unknown = Seines Durchmessers, k = 1; sonst gilt der Durchmesser als unbekannt
ui-empty-sizes-are-proposed = Maße des Zinnenkörpers: was angegeben ist, bleibt; ein leeres Feld wird vorgeschlagen.
ui-end-comparison = Vergleich beenden
ui-end-it-and-go-on = Beenden und weitermachen
ui-enter-it = Wert eingeben
ui-enter-program-appears-only-once = Im Programm eintragen. Der Token wird nur einmal angezeigt:
ui-enter-readings-or-points = Messwerte eingeben oder eine Tabelle hinzufügen
ui-enter-the-model = Modell eingeben
ui-error-budget = Unsicherheitsbudget
ui-error-budget-k-1 = Unsicherheitsbudget, k = 1
ui-error-of-the-arm = Abweichung des Arms
ui-errors = Fehler
ui-errors-of-length = Längenabweichungen
ui-errors-of-length-by-scan = Längenabweichungen durch Scannen
ui-every-arm-check-appears-over-time = Hier erscheint jede Armprüfung im zeitlichen Verlauf: (max − min)/2 der Tastkugel auf der schlechtesten Achse im Vergleich zu Ihrem Grenzwert.
ui-every-cloud-verification-rebuilt-accepted-calibrations = Jede Punktwolke dieser Verifizierung wird mit jeder der { $n } angenommenen Kalibrierungen neu berechnet. Unterschiede zwischen den Kalibrierungen stammen von den Kalibrierungen, Unterschiede zwischen den Punktwolken vom Messarm und vom Scannen. Die Berechnung läuft im Hintergrund.
ui-everything-is-in-order = Alles in Ordnung
ui-exclude = Ausschließen
ui-excluded = ausgeschlossen
ui-expanded-uncertainty-k-2 = U, k = 2
ui-expired-on = abgelaufen am { $day }
ui-exposure = Belichtung
ui-face = Fläche
ui-faces = Flächen
ui-faces-as-measured = Flächen entlang ihrer Achsen
ui-fail = Nicht bestanden
ui-failed = Nicht bestanden
ui-failed-lowercase = nicht bestanden
ui-far-line-exceeds-surroundings-automatic-four = Wie viel heller die Linie als ihre Umgebung sein muss. Automatisch: das Vierfache des Rauschens.
ui-fault = Störung
ui-fault-device-lost-recording-failed = Störung: Geräteverbindung unterbrochen, Aufzeichnung fehlgeschlagen
ui-fetch = Holen
ui-fetch-it-from-the-archive-first = Zuerst aus dem Archiv holen.
ui-few-points = Wenige Punkte
ui-fewer-points-this-browser-renders-slowly = Weniger Punkte: Dieser Browser zeichnet langsam
ui-field-at-the-stand-off = { $width } × { $height } bei { $standoff }
ui-field-of-view = Bildfeld längs der Linie
ui-figure = Kenngröße
ui-figure-over-clouds = 
    { $title }: { $of ->
        [mean] Mittelwert
        [range] Spannweite
       *[standard_deviation] Standardabweichung
    } der Punktwolken
ui-figures = Kenngrößen
ui-file = Datei
ui-file-format = Dateiformat
ui-file-is-larger-than-datasheets = { $name } ist zu groß für ein Datenblatt: Es wurde nichts gesendet.
ui-file-missing-data-folder-changed = Die Datei fehlt im Datenordner oder wurde geändert.
ui-files = { $n ->
        [one] { $n } Datei
       *[other] { $n } Dateien
    }
ui-files-can-be-dragged-in = JSON wie dokumentiert oder der Kalibrierschein (DCC) einer Kugel. Dateien lassen sich auch hineinziehen.
ui-files-of-record = Dateien
ui-fill-in-the-fields = Zuerst die Felder ausfüllen
ui-fill-in-what-is-needed = Geben Sie zuerst die Adresse ein
ui-filters-used = Filter: Punkte, die weiter als { $sigmas } Standardabweichungen vom Ausgleich entfernt sind, und Bilder innerhalb von { $place } eines früheren werden nicht verwendet; für die Form aller Punkte werden sie verwendet.
ui-findings = Befunde
ui-finished-scans-appear-press-start-scan = Hier erscheinen fertige Scans. Für den ersten „Scan starten“ drücken.
ui-first-calibration-next-one-compared = Dies ist die erste Kalibrierung. Die nächste wird hier mit ihr verglichen.
ui-fit-a-shape = Form einpassen
ui-fit-a-shape-first = Zuerst eine Form einpassen
ui-fitted-plane-outward-positive = von der eingepassten Ebene: Blau innen, Orange außen (positiv)
ui-fitted-sphere-outward-positive = von der eingepassten Kugel: Blau innen, Orange außen (positiv)
ui-flat-chessboard-laser-line-crosses-also = Auch ein ebenes Schachbrett, über das die Laserlinie verläuft, ist geeignet; es muss nicht angetastet werden.
ui-flatness-of-the-board = Durchbiegung der Tafel
ui-fleet = Flotte
ui-fleet-affected = { $n ->
    [one] Eine Aufnahme ist betroffen.
   *[other] { $n } Aufnahmen sind betroffen.
}
ui-fleet-against = Über
ui-fleet-ageing = Alterung
ui-fleet-all-calibrations = Alle Kalibrierungen jedes Sensors; die neueste ist blau und groß. Der Balken ist der Median ± eine Standardabweichung.
ui-fleet-archived = Archiviert
ui-fleet-back = Zurück zur Liste
ui-fleet-broker-away = Der Broker ist nicht erreichbar: Was die Stationen jetzt tun, ist unbekannt.
ui-fleet-calibration-choice = { $mark ->
    [used] { $name }, { $at }: damals benutzt
    [newest] { $name }, { $at }: die neueste
    [both] { $name }, { $at }: damals benutzt, die neueste
   *[none] { $name }, { $at }
}
ui-fleet-calibration-doubt = { $doubt ->
    [wrong] Falsch nach der Drift der Prüfungen: { $quantity } weicht mit dieser Kalibrierung um { $size } ab.
   *[perhaps] Vielleicht falsch nach der Drift der Prüfungen: { $quantity } weicht mit dieser Kalibrierung um { $size } ab, weit von den anderen, aber nicht sicher weiter, als diese streuen.
}
ui-fleet-calibration-doubted = { $doubt ->
    [wrong] { $choice } – falsch
   *[perhaps] { $choice } – vielleicht falsch
}
ui-fleet-calibration-of-its-day = Vom Tag des Scans
ui-fleet-calibration-of-sensor = Kalibrierung, Sensor { $sensor }
ui-fleet-calibrations = Kalibrierungen
ui-fleet-changed = Änderung um { $size } ± { $uncertainty } { $unit } (k = 2) zwischen { $earliest } und { $latest } (95 %).
ui-fleet-changes-by = { $since ->
        [calibration] Ändert sich um { $slope } ± { $uncertainty } { $unit } (95 %), nach { $n } Werten mit { $groups } Kalibrierungen.
       *[first] Ändert sich um { $slope } ± { $uncertainty } { $unit } (95 %), nach { $n } Werten von { $groups } Geräten.
    }
ui-fleet-cloud = Auf einem anderen Rechner mit Zugang zu diesen Datensätzen berechnet dieser Befehl die Punktwolke:
ui-fleet-cloud-failed = Die Punktwolke mit { $calibration } ist nicht berechnet. { $why }
ui-fleet-cloud-format = Format
ui-fleet-cloud-is-being-made = Die Punktwolke mit { $calibration } wird berechnet
ui-fleet-cloud-is-made = Sie ist schon berechnet
ui-fleet-cloud-waits = Die Punktwolke mit { $calibration } wartet auf die vor ihr
ui-fleet-clouds = Punktwolken
ui-fleet-collected = Gesammelt
ui-fleet-count = Anzahl
ui-fleet-days-reversed = „Von“ liegt nach „Bis“, sodass kein Datensatz zu finden ist: Wählen Sie ein früheres „Von“ oder ein späteres „Bis“.
ui-fleet-differed = Weicht vom ersten Wert an, { $since }, um { $size } ± { $uncertainty } { $unit } (k = 2) ab.
ui-fleet-doubtful = Vielleicht falsch: { $calibration }, um { $size }, geprüft von { $since } bis { $until }. Sie liegt weit von den anderen Kalibrierungen, aber nicht sicher weiter, als diese streuen.
ui-fleet-download = Herunterladen
ui-fleet-drift = Drift
ui-fleet-ended = Spätestens am { $when } wieder auf dem richtigen Niveau.
ui-fleet-expanded = U (k = 2)
ui-fleet-explained = Nur die Prüfungen dieses Zeitraums verwendeten: { $calibrations }. Die Aufnahmen damit sind betroffen.
ui-fleet-file = Datei
ui-fleet-from = Gesammelt aus
ui-fleet-hours = Stunden
ui-fleet-hours-since-calibration = Stunden seit der verwendeten Kalibrierung
ui-fleet-hours-since-first = Stunden seit dem ersten Wert des Geräts
ui-fleet-kind = Art
ui-fleet-kind-performance = Leistungsprüfung
ui-fleet-kind-scan = Scan
ui-fleet-label = Name
ui-fleet-lasts = Sie dauert an.
ui-fleet-least-values = Ein Zeitraum, in dem eine Größe abweicht, wird ab { $n } Prüfungen gefunden.
ui-fleet-left-out = Ausgelassen, weil ihre Kalibrierung nicht im Katalog ist: { $n }
ui-fleet-level = { $n ->
    [one] { $value } ab { $since } (ein Wert)
   *[other] { $value } ab { $since } ({ $n } Werte)
}
ui-fleet-make-cloud = Punktwolke berechnen
ui-fleet-median = Median
ui-fleet-newest = Neuester Datensatz
ui-fleet-newest-calibrations = Neueste Kalibrierungen
ui-fleet-newest-value = Neueste
ui-fleet-no-answer = Der Server der Flotte antwortet nicht, oder seine Datenbank ist jetzt nicht benutzbar. Die Stationen arbeiten weiter, und nichts geht verloren.
ui-fleet-no-change-shown = { $since ->
        [calibration] Keine Änderung erkennbar: { $slope } ± { $uncertainty } { $unit } (95 %), nach { $n } Werten mit { $groups } Kalibrierungen.
       *[first] Keine Änderung erkennbar: { $slope } ± { $uncertainty } { $unit } (95 %), nach { $n } Werten von { $groups } Geräten.
    }
ui-fleet-no-slope = Zu wenige Werte für einen Trend.
ui-fleet-not-collected = Am Broker, aber nicht in fleet.toml: es wird nichts gesammelt.
ui-fleet-not-on-broker = Am Broker nicht gehört
ui-fleet-nothing-found = Kein Datensatz gefunden.
ui-fleet-object = Prüfkörper
ui-fleet-only-on-station = Nur auf der Station
ui-fleet-own-errors = Die eigenen Fehler von { $n } Kalibrierungen haben eine Standardabweichung von { $deviation }; Änderungen, die sie erklären, zählen nicht.
ui-fleet-own-errors-unknown = { $n ->
    [one] Eine Kalibrierung zeigt nicht, wie weit Kalibrierungen voneinander abweichen: Eine Änderung kann ein gewöhnlicher Fehler einer Kalibrierung sein.
   *[other] { $n } Kalibrierungen mit so wenigen Prüfungen zeigen nicht, wie weit Kalibrierungen voneinander abweichen: Eine Änderung kann ein gewöhnlicher Fehler einer Kalibrierung sein.
}
ui-fleet-place = Katalog: { $place }
ui-fleet-possible = { $n ->
    [one] Eine weitere ist vielleicht betroffen.
   *[other] { $n } weitere sind vielleicht betroffen.
}
ui-fleet-quantity = Größe
ui-fleet-records = Datensätze
ui-fleet-right = { $because ->
    [most] Gilt als richtig: { $value }, seit { $since }, weil { $n } von { $total } Werten so sind. Die Werte allein zeigen nicht, welches Niveau richtig ist.
    [chosen] Gilt als richtig, wie gewählt: { $value }, seit { $since }; { $n } von { $total } Werten sind so.
   *[first] Gilt als richtig: { $value }, seit { $since }, weil es das erste Niveau ist; { $n } von { $total } Werten sind so. Die Werte allein zeigen nicht, welches Niveau richtig ist.
}
ui-fleet-right-level = Richtiges Niveau
ui-fleet-right-proposed = Wie vorgeschlagen
ui-fleet-session = Andere Sitzung
ui-fleet-since = Von
ui-fleet-size = Umfang
ui-fleet-software = Software
ui-fleet-spread = Streuung aller Kalibrierungen
ui-fleet-standard-deviation = Standardabweichung
ui-fleet-standing-out = { $n ->
    [one] Ein Wert sticht heraus. Weniger als { $least } zusammen sind für einen Zeitraum zu wenige.
   *[other] { $n } Werte stechen heraus. Weniger als { $least } zusammen sind für einen Zeitraum zu wenige.
}
ui-fleet-symbol = Symbol
ui-fleet-temperature-since-calibration = Über der Temperatur der verwendeten Kalibrierung
ui-fleet-temperature-since-first = Temperatur
ui-fleet-then = Dann { $value } ab { $since }.
ui-fleet-times = Zeiten: { $zone }
ui-fleet-until = Bis
ui-fleet-verdict = Ergebnis
ui-fleet-with-the-password = Mit dem Passwort dieser Seite
ui-fleet-words = Teil, Bediener, Kennung, Seriennummer
ui-fleet-would-be-affected = { $n ->
    [0] Mit ihr wurde nichts aufgenommen.
    [one] Falls sie falsch ist, ist eine Aufnahme betroffen.
   *[other] Falls sie falsch ist, sind { $n } Aufnahmen betroffen.
}
ui-floor-z = Lücken Z
ui-focal-length = Brennweite
ui-for = seit { $age }
ui-for-information-without-a-limit = zur Information, ohne Grenzwert
ui-for-robot-cells-no-stop = Für eine Roboterzelle, deren Scans laufen sollen, ohne dass jemand am Browser ist: Dann wird nichts von selbst gestoppt.
ui-form = Form
ui-form-deviation = Formabweichung
ui-form-deviation-of-the-spheres = Formabweichung der Kugeln
ui-form-filtered = Form, gefiltert
ui-form-highest-to-lowest = Form, höchster bis tiefster Punkt
ui-form-of-all = Form aller
ui-found = gefunden
ui-fps = { $n } Bilder/s
ui-frames-lost = { $n ->
        [one] { $n } Bild verloren
       *[other] { $n } Bilder verloren
    }
ui-free = frei
ui-from = Von
ui-from-above = Oben
ui-from-above-arm-below = Von oben, der Arm unten
ui-from-face-to-face = { $from } bis { $to }
ui-from-left-to-right = Von links nach rechts
ui-from-the-front = Vorn
ui-from-the-recording = aus der Aufzeichnung
ui-from-the-side = Seite
ui-from-the-side-arm-left = Von der Seite, der Arm links
ui-from-to = { $from } bis { $to }
ui-from-top-to-bottom = Von oben nach unten
ui-front-y = Vorderfläche Y
ui-furthest = fern: { $value }
ui-gate-of-plane = Auswahl aller Punkte: die gescannte Fläche, bis { $gate } von der Ebene.
ui-gate-of-sphere = Auswahl aller Punkte: bis { $gate } von der kalibrierten Kugel und bis { $angle } von der Mitte des Scans.
ui-gauge = Prüfnormal
ui-gauges = Prüfnormale
ui-give-control = Abgeben
ui-good-up-to-usable-up-to = Gut bis { $good }, brauchbar bis { $usable }.
ui-grey-far-beyond-them-no-statement = Grau: weit außerhalb; dort ist keine Aussage möglich.
ui-grey-levels = Graustufen
ui-groove-n = Nut { $n }
ui-has-control = { $name } hat die Bedienung.
ui-hatched-beyond-depths-stripe-covered-labelled = Schraffiert: außerhalb der von der Laserlinie abgedeckten Tiefen. Beschriftet: der größte Wert innerhalb.
ui-health = Zustand
ui-height = Höhe
ui-height-in-pixels = Bildhöhe, px
ui-height-of-floors = Höhe der Böden
ui-height-of-the-picture = Höhe des Bildes
ui-help = Hilfe
ui-hide-the-retired-ones = Abgelegte ausblenden
ui-hold-sensor-object-fills-picture-laser = Sensor so halten, dass das Objekt das Bild füllt und die Laserlinie darüber verläuft.
ui-hold-sensor-over-chessboard = Den Sensor über ein ebenes Schachbrett halten, über das die Laserlinie verläuft, und in wenigen Posen je ein Bild aufnehmen; die Station schlägt sie vor. Die Unsicherheit des Ergebnisses wird in { $unit } angegeben, bevor etwas ersetzt wird.
ui-hold-still-place-arms-main-button = An jeder Stelle ruhig halten; die Haupttaste am Messarm nimmt den Punkt auf.
ui-hold-tip-cone-ball-seat-swing = Die Tastkugel in einer Kegel- oder Kugelpfanne halten und den Messarm darum schwenken. Die scheinbare Bewegung der Tastkugel ist die Eigenabweichung des Messarms. Das dauert fünf Minuten.
ui-home = Start
ui-hours = { $n ->
        [one] { $n } Stunde
       *[other] { $n } Stunden
    }
ui-hours-ago = { $n ->
        [one] vor { $n } Stunde
       *[other] vor { $n } Stunden
    }
ui-how-does-the-laser-line-run = Wie verläuft die Laserlinie im Bild?
ui-how-lengths-are-measured = Wie die Längen gemessen werden
ui-http-interface = HTTP-Schnittstelle
ui-http-interface-explained = Programme lesen und bedienen diese Station über HTTP, mit den Rechten der Person oder des Tokens, mit denen sie sich anmelden.
ui-http-interface-version = HTTP-Schnittstelle, Version { $version }
ui-hz = { $n } Hz
ui-id-of-the-first-marker = Nummer des ersten Markers
ui-identification-appears-arms-deviation-datasheet-uncertainty = Hier erscheint jede Identifikation mit der Abweichung des Messarms von seinem Datenblatt, der erreichten Unsicherheit und dem Bericht.
ui-identifications = Identifikationen
ui-identify-the-arm = Messarm identifizieren
ui-idle = Bereit
ui-implied-probe-matrix-error = Was die Stellungen über die Kalibrierung sagen
ui-in-gate = Ausgewählt
ui-in-range = Im Bereich
ui-in-space = Räumlich
ui-in-space-largest-2s = Räumlich: größter, 2s
ui-in-this-browser = In diesem Browser
ui-in-use = In Verwendung.
ui-in-use-badge = In Verwendung
ui-in-use-by = In Gebrauch: { $names }
ui-in-use-name = In Verwendung: { $name }
ui-inches = Zoll
ui-include = Einbeziehen
ui-initial-password = Anfangspasswort
ui-inner-corners-squares-of = { $columns } × { $rows } innere Ecken, Felder von { $square }
ui-is-the-arm-in-order = Ist der Messarm in Ordnung?
ui-is-this-the-right-device = Ist es das richtige Gerät, und läuft es gut?
ui-issue-date-unknown = Alter des Kalibrierscheins unbekannt
ui-issued-on = ausgestellt am { $day }
ui-issued-on-with-age = ausgestellt am { $day } ({ $age })
ui-it-is-under-records = Er liegt im Archiv. Der nächste Scan ist ein neuer.
ui-items-need-attention = { $n ->
        [one] Ein Punkt ist zu beachten
       *[other] { $n } Punkte sind zu beachten
    }
ui-its-figures-are-left-out = Die zugehörigen Kenngrößen entfallen.
ui-its-standard-uncertainty = Dessen Standardunsicherheit (k = 1)
ui-job = Auftrag
ui-joint-a = a
ui-joint-alpha = α
ui-joint-column = Gelenk
ui-joint-d = d
ui-joint-encoder = Geber, k = 1
ui-joint-highest = Größter
ui-joint-lowest = Kleinster
ui-joint-n = Gelenk { $n }
ui-joint-sign = Vor{ "\u00AD" }zeichen
ui-joint-theta = θ
ui-judged-by = Beurteilt nach
ui-k-1-about-two-three-points = k = 1: Etwa zwei von drei Punkten liegen darin. k = 2: etwa neunzehn von zwanzig.
ui-keep-control = Behalten
ui-keep-elbow-and-wrist-as-they-are = Ellbogen und Handgelenk des Arms von den Punkten bis zu den Bildern so lassen: Fehler seiner Glieder heben sich dann auf
ui-keep-only-what-is-inside = Nur das Innere behalten
ui-keep-stripe-gauge-move-slowly-points = Die Laserlinie auf dem Prüfnormal halten und langsam führen; die Punkte erscheinen beim Überfahren.
ui-key-above = 3D-Ansicht von oben
ui-key-control = Strg
ui-key-enter = Eingabe
ui-key-front = 3D-Ansicht von vorn
ui-key-help = Diese Tasten
ui-key-main = Die große Schaltfläche: aufnehmen, starten, anhalten oder weiter
ui-key-side = 3D-Ansicht von der Seite
ui-key-stop = STOPP, gleich was geöffnet ist
ui-key-undo = Letzten Punkt zurücknehmen
ui-key-whole = 3D-Ansicht des Ganzen
ui-keyboard-and-tour = Tastatur und Rundgang
ui-keys-note = Während der Eingabe in ein Feld und bei einer Frage wirkt keine Taste außer STOPP.
ui-kind = Art
ui-kind-of-board = Art der Tafel
ui-kind-of-test = Art der Prüfung
ui-kiosk-link-screen-revoked = Der Kiosk-Link dieses Bildschirms wurde widerrufen.
ui-kiosk-links = Kiosk-Links
ui-label-with-unit = { $label } ({ $unit })
ui-laboratory = Laboratorium
ui-language = Sprache
ui-language-and-units = Sprache und Einheiten
ui-largest-distance = Größter Abstand
ui-largest-distance-from-mean = größter Abstand vom Mittelwert
ui-largest-distance-of-a-contact-point = Größter Abstand eines Antastpunkts
ui-largest-residuals = Größte Residuen
ui-laser = Laser
ui-laser-as-switched-here = wie zuletzt hier geschaltet; der Sensor hat geantwortet
ui-laser-camera-is-lost = Kamera verloren
ui-laser-has-no-switch-here = kein Schalter
ui-laser-is-off = Laser ist aus
ui-laser-is-off-lowercase = Laser ist aus
ui-laser-is-on = Laser ist an
ui-laser-is-on-lowercase = Laser ist an
ui-laser-is-unknown-lowercase = Laser unbekannt
ui-laser-line = Laserlinie
ui-laser-no-camera-yet = keine Kamera
ui-laser-off = LASER AUS
ui-laser-plane-rms = Laserebene, rms
ui-laser-rotation = Verdrehung des Lasers
ui-laser-sensor-did-not-answer = keine Antwort
ui-laser-shift = Verschiebung des Lasers
ui-laser-unknown = Laser unbekannt
ui-last-backup = Letzte Sicherung { $when }: { $files }, { $size } in { $folder }
ui-last-points-order-capture-about-mean = Die letzten { $n } Punkte in der Reihenfolge der Aufnahme, relativ zu ihrem Mittelwert.
ui-last-used = Zuletzt verwendet { $at }: { $result }
ui-latest = { $figure }, zuletzt: { $value }
ui-latest-decided = Zuletzt: { $value } ({ $decision }).
ui-lay-chessboard-down = Zuerst das Schachbrett fest auflegen. Die Kalibrierung dauert wenige Minuten.
ui-least-10-characters-three-unrelated-words = Mindestens 10 Zeichen; gut sind drei Wörter ohne Zusammenhang.
ui-leave-it-out = Weglassen
ui-leave-tip-seat-turn-every-joint = Die Tastkugel in der Pfanne lassen und jedes Gelenk langsam über seinen ganzen Bereich drehen. Punkte werden automatisch aufgenommen.
ui-left-out = ausgeschlossen
ui-left-out-reason = ausgeschlossen: { $reason }
ui-left-out-sentence = Ausgeschlossen:
ui-left-to-right-two-for-each = Von links nach rechts, zwei je Zinne.
ui-length = Länge
ui-length-error-by-scan-of = Lage { $place }, Scan { $repeat }: { $error }
ui-length-error-of = Lage { $place }, Wiederholung { $repeat }: { $error }
ui-length-from-the-certificate = Länge laut Kalibrierschein
ui-length-standard = Längennormal
ui-length-test = Längenprüfung
ui-lengths = Längen
ui-lengths-and-scans-done-of = { $done } von { $of } Längen angetastet, { $scanned } von { $scans } Scans
ui-lengths-done-of = { $done } von { $of } Längen
ui-lengths-first-text = Die Längenprüfung nach ISO 10360 misst kalibrierte Längen in sieben Lagen im Arbeitsraum des Arms: 105 Längen, wenn das Normal fünf hat. Mit einem Stufenendmaß sind das 210 Antastungen, von Hand etwa eine halbe Stunde.
ui-lengths-largest-error =
    { $count ->
        [one] eine Länge
       *[other] { $count } Längen
    }, größte Abweichung { $value }
ui-lengths-need = Ein Kugelstab, Maßstab oder Stufenendmaß mit Kalibrierschein und ein fester Halt dafür in sieben Lagen. Sieben Lagen, fünf Längen, drei Wiederholungen durch Antasten, bei einem Kugelstab auch durch Scannen.
ui-lens-distortion = Verzeichnung
ui-less = Weniger
ui-let-the-simulated-operator-do-everything = Simulierten Bediener alles ausführen lassen
ui-let-the-simulated-operator-do-it = Simulierten Bediener starten
ui-let-the-simulated-operator-scan = Simulierten Bediener scannen lassen
ui-light-display = Helles Design
ui-likely-because = Wahrscheinlich { $option }: { $why }. Bitte prüfen.
ui-limit = Grenzwert
ui-limit-diameter-error-scatter = Grenzwert für Durchmesserabweichung und Streuung
ui-limit-grows-with-length = A + L/K, höchstens B; K und B dürfen leer bleiben
ui-limit-max-min-2-axis = Grenzwert für (max − min)/2 je Achse
ui-limit-none = keiner
ui-limit-value = Grenzwert { $value }
ui-limits = Grenzen
ui-limits-by-the-datasheet = Grenzwerte nach Datenblatt (MPE)
ui-limits-fixed-at-first-touch = Eine Kenngröße ohne Grenzwert wird angegeben, aber nicht beurteilt. Die Grenzwerte stehen ab der ersten Antastung oder dem ersten Scan fest und bleiben für die nächste Prüfung erhalten.
ui-limits-judged-by-uncertainty-on-bar = Der Grenzwert wird nach der Unsicherheit beurteilt, die auf dem Balken gezeichnet und zuerst genannt ist. U der Prüfung: Prüfwertunsicherheit allein aus dem Normal und seinem Aufbau (ISO 14253-5), für die Leistung des Scanners. U der Messung: aus Normal, Taster und Streuung der Punkte, für den Ort des Normals; U der Prüfung ist ein Teil davon.
ui-line = Linie
ui-line-found-in-all-poses = Mit diesen Einstellungen zeigt jedes Bild die Linie.
ui-line-missing-in-poses = Keine Laserlinie gefunden in Pose: { $poses }. Bild ansehen und angeben, wie die Linie aussieht:
ui-line-settings-stay-with-session = Sie gelten für alle Bilder dieser Sitzung, und mit ihnen die Zonen der Einstellungsseite.
ui-line-spacing = Linienabstand
ui-lines-point-outward-or-inward = Striche zeigen nach außen oder innen
ui-link-screen-shop-floor-gives-full = Ein Link für einen Bildschirm in der Fertigung. Er zeigt alles an und erlaubt keine Bedienung.
ui-list-could-not-loaded-reloads-when = Die Liste konnte nicht geladen werden. Sie wird neu geladen, sobald die Station wieder da ist.
ui-live = live
ui-live-cloud = Live-Punktwolke
ui-live-cloud-of-points = Live-Punktwolke
ui-live-picture-of-the-camera = Live-Bild der Kamera
ui-live-picture-of-the-tried-camera = Livebild der Kamera
ui-load-again = Neu laden
ui-loading = Wird geladen …
ui-loading-share = Wird geladen … { $share }
ui-loading-the-calibration = Kalibrierung wird geladen …
ui-loading-the-list = Liste wird geladen …
ui-loading-the-map = Karte wird geladen …
ui-loading-the-record = Aufnahme wird geladen …
ui-location-of-the-screen = Standort des Bildschirms
ui-log = Protokoll
ui-log-level = Stufe
ui-log-lines = Protokollzeilen
ui-logo-at-the-head-of-reports = Es steht am Kopf aller Berichte, höchstens { $width } mm breit. PNG oder JPEG bis { $largest }; { $pixels } Pixel Breite genügen.
ui-logo-of-reports = Logo der Berichte
ui-logo-too-large = { $name } ist für ein Logo zu groß
ui-lost = nicht verbunden
ui-lost-and-corrupt = { $lost } verloren, { $corrupt } beschädigt
ui-lost-for = seit { $age } nicht verbunden
ui-lost-lately = { $n } von { $all } in 10 min verloren
ui-lost-pictures = Verlorene Bilder
ui-lost-records = Verloren
ui-lower-limit = Untere Grenze, { $unit }
ui-lower-limit-must-below-upper = Die untere Grenze muss unter der oberen liegen.
ui-made-on-the-devices-page = Das Datenblatt der Kamera entsteht auf der Seite Geräte.
ui-manual = manuell
ui-map = Karte
ui-map-appears-after-first-cloud = Die Karte erscheint hier nach der ersten Punktwolke.
ui-map-outliers = 
    { $points ->
        [0] Kein Punkt liegt weiter ab, als Rauschen erklärt.
        [one] { $points } Punkt liegt weiter ab, als Rauschen erklärt (Ring; drücken Sie ihn).
       *[other] { $points } Punkte liegen weiter ab, als Rauschen erklärt (Ringe; drücken Sie einen).
    } Die Spannweite aller Punkte, { $range }, liegt zwischen den dicken Ringen, { $low } und { $high }.
ui-mark-weak-places = Schwache Stellen markieren
ui-mask-shines-picture-not-part-object = Ausblenden, was im Bild glänzt und nicht zum Objekt gehört: eine Spannpratze, die Kante des Sensors selbst.
ui-master-sphere = Meisterkugel
ui-maximum-width = Höchstbreite der Linie
ui-mean = Mittelwert { $value }
ui-mean-deviation = Mittel
ui-measure = Messen
ui-measure-the-print = Nach dem Druck: das ganze Muster messen, dann hat das Datenblatt die wahre Größe der Felder.
ui-measured-height = Gemessene Höhe
ui-measured-width = Gemessene Breite
ui-measured-with = Gemessen mit
ui-measurements = Messungen
ui-merge-into-one-cloud = Zu einer Punktwolke zusammenführen
ui-merged-of = Zusammengeführt aus
ui-merlon-gap-merlon = Breite der ersten Zinne, der Lücke, der nächsten Zinne und so weiter.
ui-merlon-n = Zinne { $n }
ui-merlons = { $n ->
        [one] { $n } Zinne
       *[other] { $n } Zinnen
    }
ui-merlons-n-to-m = Zinnen { $n } bis { $m }
ui-messages-delivered = { $n ->
        [one] { $n } Nachricht zugestellt
       *[other] { $n } Nachrichten zugestellt
    }
ui-metrics = Metriken
ui-micrometer = Bügelmessschraube
ui-minimum-width = Mindestbreite der Linie
ui-misplaced-edges = falsch liegende Kanten
ui-more-options = Weitere Optionen
ui-motion-part-under-line-during-one = Bewegung des Teils unter der Linie während einer Belichtung; darüber meldet die Station „zu schnell“. Automatisch: das Vierfache des Punktabstands entlang der Linie.
ui-move-slowly-evenly-green-range-distance = Langsam und gleichmäßig im grünen Bereich der Abstandsanzeige führen.
ui-move-stripe-slowly-over-part = Laserlinie langsam über das Teil führen.
ui-move-the-arm-every-value-must-follow = Bewegen Sie den Arm: Jeder Wert muss folgen.
ui-moving = in Bewegung
ui-my-arm-is-not-listed = Mein Messarm ist nicht dabei
ui-my-camera-is-not-listed = Meine Kamera ist nicht dabei
ui-n-alarms = { $n ->
        [one] { $n } Alarm
       *[other] { $n } Alarme
    }
ui-n-clouds = { $n ->
        [one] { $n } Punktwolke
       *[other] { $n } Punktwolken
    }
ui-n-of-all-scans = { $n } von { $all }
ui-n-of-all-too-fast = { $n } von { $all } Bildern zu schnell
ui-n-pictures = { $n ->
        [one] { $n } Bild
       *[other] { $n } Bilder
    }
ui-n-pictures-lost =
    { $n ->
        [one] { $n } Bild verloren
       *[other] { $n } Bilder verloren
    }
ui-n-pictures-without-points =
    { $n ->
        [one] { $n } Bild ohne Punkte
       *[other] { $n } Bilder ohne Punkte
    }
ui-n-points = { $n ->
        [one] { $n } Punkt
       *[other] { $n } Punkte
    }
ui-n-scans =
    { $n ->
        [one] { $n } Scan
       *[other] { $n } Scans
    }
ui-n-scans-chosen = { $n } Scans gewählt
ui-n-scans-merged = { $n } Scans zusammengeführt
ui-n-stations = { $n ->
        [one] { $n } Station
       *[other] { $n } Stationen
    }
ui-n-waiting = { $n ->
        [one] { $n } wartet
       *[other] { $n } warten
    }
ui-name = Name
ui-name-of-the-block = Name des Zinnenkörpers
ui-name-of-the-board = Name der Tafel
ui-name-of-the-device = Name
ui-name-of-the-program = Name des Programms
ui-name-part = Teil benennen
ui-named-field = „{ $label }“
ui-narrower-lines-glints-automatic-about-half = Schmalere Linien gelten als Glanzlichter. Automatisch: etwa die Hälfte der üblichen Linienbreite.
ui-narrower-side = Schmalere Seite
ui-nearest = nah: { $value }
ui-new-account = Neues Konto
ui-new-address-requires-secret-again = Für eine neue Adresse muss das Geheimnis erneut eingegeben werden.
ui-new-camera-gets-its-datasheet = Eine Kalibrierung muss das wissen. Aus der Antwort entsteht das Datenblatt der Kamera.
ui-new-link = Neuer Link
ui-new-name-of = Neuer Name von { $name }
ui-new-of-kind = Neu: { $title }
ui-new-password = Neues Passwort
ui-new-password-of = Neues Passwort von { $name }
ui-new-token = Neuer Token
ui-next = Weiter: { $what }
ui-next-scan-is-added-to = Der nächste Scan kommt zu einer Aufnahme hinzu
ui-no-alarms = Keine Alarme
ui-no-answer-from-the-station = Keine Antwort der Station: { $what }
ui-no-arm-was-found = Kein Messarm gefunden. Schließen Sie ihn an, schalten Sie ihn ein und suchen Sie noch einmal.
ui-no-backup-was-started = es wurde keine Sicherung gestartet
ui-no-backup-yet = Noch keine Sicherung. Sicherungen werden in { $folder } geschrieben
ui-no-block-yet = Sobald der Zinnenkörper entworfen ist
ui-no-board-to-take = Sobald es eine Tafel gibt
ui-no-calibration-use-yet-calibrate-first = Noch keine Kalibrierung in Verwendung. Zuerst kalibrieren.
ui-no-calibration-yet = noch keine Kalibrierung
ui-no-camera-was-found = Keine Kamera gefunden. Schließen Sie sie an, schalten Sie sie ein und suchen Sie noch einmal.
ui-no-check-yet = Noch keine Prüfung
ui-no-cloud-picture-yet-scan-display = Noch keine Punktwolke in der Ansicht. Scannen oder einen Scan anzeigen.
ui-no-contact-for = seit { $age } keine Verbindung
ui-no-continue = Nein, fortfahren
ui-no-data = keine Daten
ui-no-data-yet = Noch keine Daten.
ui-no-data-yet-lowercase = noch keine Daten
ui-no-datasheet-of-a-gauge = Noch kein Datenblatt eines Prüfnormals. Verifizierungen und Prüfungen brauchen eines.
ui-no-datasheet-of-a-sensor = Noch kein Datenblatt eines Sensors. Es entsteht auf der Seite Geräte, wenn die Kamera in Betrieb genommen wird, oder hier.
ui-no-datasheet-of-an-arm = Noch kein Datenblatt eines Messarms. Eine Kalibrierung braucht eines: von einem Messarm, der Gelenkwinkel meldet, sein kinematisches Modell.
ui-no-datasheet-of-an-object = Noch kein Datenblatt eines Blocks oder einer Tafel. Eine Kalibrierung braucht eines.
ui-no-entry-matches = Kein Eintrag passt dazu.
ui-no-gauge-yet = Noch kein Prüfnormal
ui-no-keep-it = Nein, behalten
ui-no-length-standard-yet = Noch kein Längennormal
ui-no-length-yet = noch keine Länge
ui-no-limit = Kein Grenzwert
ui-no-limit-set = kein Grenzwert festgelegt
ui-no-log-line-matches = Keine Protokollzeile passt dazu.
ui-no-longer-in-use = Nicht mehr in Verwendung.
ui-no-new-picture-for = Seit { $age } kein neues Bild.
ui-no-picture = kein Bild
ui-no-picture-yet-appears-when-camera = Noch kein Bild. Es erscheint, sobald die Kamera eines sendet.
ui-no-residual-yet = noch kein Residuum
ui-no-scan-is-like-that = Kein Scan passt dazu.
ui-no-tip-check-yet = Noch keine Tastkugelprüfung
ui-nobody = niemand
ui-nobody-control-first-act-takes = Niemand hat die Bedienung. Wer zuerst handelt, übernimmt sie.
ui-nobody-has-control = Niemand hat die Bedienung.
ui-nobody-in-control = Niemand hat die Bedienung
ui-none = keine
ui-none-chosen = nicht gewählt
ui-none-used-determine-scan-flat-plate = Es wird kein Zeitversatz verwendet. Zum Bestimmen einen Scan starten und mindestens dreimal zügig über eine ebene Platte fahren, näher heran und weiter weg. Den Scan stoppen, dann hier den Zeitversatz bestimmen.
ui-none-yet = noch keine
ui-not-chosen = Nicht gewählt
ui-not-delivered = Nicht zugestellt: { $reason }
ui-not-done = nicht ausgeführt: { $reason }
ui-not-measured = nicht gemessen
ui-not-needed = nicht nötig
ui-not-on-the-other = Neben dem anderen Scan
ui-not-signed-in = nicht angemeldet
ui-not-solved-yet = noch nicht berechnet
ui-not-stated = nicht angegeben
ui-not-yet = noch nicht
ui-not-yet-identified-here = Hier noch nicht identifiziert
ui-nothing-sent-yet = Noch nichts gesendet
ui-nothing-takes-effect-before-you-accept = Nichts wird wirksam, bevor Sie es annehmen.
ui-nothing-to-choose = Es gibt noch kein Datenblatt.
ui-nothing-was-changed = Es wurde nichts geändert.
ui-nothing-was-cut = Es wurde nichts weggeschnitten
ui-nothing-was-exported = die Datei wurde nicht erstellt
ui-nothing-was-fitted = es wurde nichts eingepasst
ui-nothing-was-sent = es wurde nichts gesendet
ui-notification-sent-json-post-signed-hmac = Jede Benachrichtigung wird als JSON per POST gesendet und im Header Crenel-Signature mit HMAC-SHA256 signiert. Fehlgeschlagene Zustellungen werden wiederholt.
ui-notifications = Benachrichtigungen
ui-notifications-blocked-browser-allow-them-icon = Benachrichtigungen sind in diesem Browser blockiert. Über das Symbol neben der Adresse erlauben.
ui-now = jetzt
ui-number-column = Nr.
ui-number-n = Nr. { $n }
ui-number-of-merlons = Anzahl der Zinnen
ui-numbers = Zahlen
ui-numbers-out-date-station-stores-everything = Die Zahlen hier sind nicht aktuell. Die Station speichert alles, was sie aufgezeichnet hat.
ui-object = Objekt
ui-object-serial = Objekt { $serial }
ui-of = mit { $calibration }
ui-of-need-attention = { $n } von { $all } mit Hinweisen
ui-of-points = { $n } von { $all } Punkten
ui-of-row = { $label } von { $row }
ui-of-with-faults = { $n } von { $all } mit Störungen
ui-off = aus
ui-off-best-fitting-gauge-outward-positive = { $end } Abweichung vom am besten passenden Prüfnormal: Blau innen, Orange außen (positiv)
ui-old = alt
ui-old-age = { $age } alt
ui-old-password = Altes Passwort
ui-on = an
ui-one-file-support-checks-versions-settings = Eine Datei für den Support: Prüfungen, Versionen, Einstellungen, Protokoll und die letzten Schritte. Sie enthält keine Passwörter, Token, Schlüssel oder Namen. Es wird nichts gesendet.
ui-one-pose = Eine Pose
ui-one-position = Eine
ui-one-sphere = Eine Kugel
ui-only-an-administrator-can-connect-devices = Nur ein Administrator kann Geräte verbinden.
ui-only-an-administrator-can-make-backups = Nur ein Administrator kann Sicherungen anlegen.
ui-only-an-administrator-can-manage-accounts = Nur ein Administrator kann Konten verwalten.
ui-open = Öffnen
ui-open-address-screen-appears-only-once = Diese Adresse auf dem Bildschirm öffnen. Sie wird nur einmal angezeigt:
ui-open-in-the-3d-view = In der 3D-Ansicht öffnen
ui-open-the-reference = Referenz der HTTP-Schnittstelle öffnen
ui-open-the-station-by-its-link = Die Station mit dem Link öffnen
ui-open-to-turn-it = In der 3D-Ansicht öffnen, um ihn zu drehen, abzuspielen oder zu vergleichen.
ui-opening-the-device = Das Gerät wird geöffnet …
ui-operator = Bediener
ui-operator-lowercase = Bediener
ui-option-at-most = höchstens { $largest }
ui-optional-field = { $label }, falls bekannt
ui-or-with-an-account-of-this-station = oder mit einem Konto dieser Station
ui-order = Auftrag
ui-order-of = Auftrag { $order }
ui-order-of-the-columns = Reihenfolge der Spalten
ui-orientations = Ausrichtungen
ui-out-of-the-frame = außerhalb des Bildes
ui-outlier = Ausreißer
ui-outlier-at = 
    { $deviation }{ $end ->
        [highest] { "" }, der höchste Punkt von allen
        [lowest] { "" }, der tiefste Punkt von allen
       *[none] { "" }
    }; { $points ->
        [0] kein Ausreißer
        [one] ein Ausreißer hier
       *[other] { $points } Ausreißer hier
    }; bei X, Y, Z = { $at } { $unit } des Arms; Bild { $frame }
ui-outlier-does-not-fit-face-not = Ausreißer: Der Punkt passt nicht zu seiner Fläche und wird nicht verwendet.
ui-over-time = { $figure } im zeitlichen Verlauf
ui-overall-length = Gesamtlänge
ui-overexposed = überbelichtet
ui-page-continues-automatically-once-everything-ready = Diese Seite läuft automatisch weiter, sobald alles bereit ist.
ui-page-to-print-on = Papierformat
ui-pages = Seiten
ui-pages-here = Seiten, jetzt { $page }
ui-parameter = Parameter
ui-parameters = Parameter
ui-part = Teil
ui-part-of-next-scans = Teil der nächsten Scans
ui-part-of-this-scan = Teil dieses Scans
ui-pass = Bestanden
ui-pass-becomes-map-clouds-deviations-gauge = Jede Überfahrt ergibt eine Karte der Abweichungen der Punktwolke vom Prüfnormal.
ui-pass-over-place-again-fill-gaps = Lücken durch erneutes Überfahren füllen. Gescannte Daten werden sofort aufgezeichnet und gehen nicht verloren.
ui-pass-value-within-by-guard-band = Bestanden: Der Wert liegt um mehr als den Schutzabstand innerhalb des Grenzwerts. Nicht bestanden: Er überschreitet ihn um mehr als den Schutzabstand. Dazwischen gilt, was die Entscheidungsregel unter den Kennwerten sagt.
ui-passed = Bestanden
ui-passed-lowercase = bestanden
ui-password = Passwort
ui-password-changed-other-browsers-signed-out = Das Passwort ist geändert; andere Browser sind abgemeldet.
ui-patch-covered = abgedeckt
ui-patch-holds = { $points } Punkte aus { $frames } Bildern
ui-patch-open = noch nicht abgedeckt
ui-patch-partly = begonnen
ui-patches-missing = Es fehlen noch { $count } von 25 ({ $patches })
ui-patches-missing-many = Es fehlen noch { $count } von 25
ui-pattern-and-page = Das Muster ist { $width } breit und { $height } hoch. Auf { $page } mit 100 % drucken; der Balken von 100 mm darunter prüft den Drucker.
ui-pause = Anhalten
ui-people = Benutzer
ui-performance = Leistung
ui-performance-first-text = Die Ein-Kugel-Prüfung nach ISO 10360 dauert von Hand etwa 25 Minuten: 55 Antastungen und fünf Scans einer kalibrierten Kugel.
ui-performance-first-title = Hält das Gerät sein Datenblatt ein?
ui-performance-help-end = Haben sich Kugel oder Arm mehr bewegt, als die Unsicherheit zulässt, wird keine Kenngröße angegeben.
ui-performance-help-length = Die erste Antastung der nächsten Länge bestätigt die vorige. Danach steht sie fest.
ui-performance-help-limits = Die größten zulässigen Abweichungen (MPE) eintragen, die der Hersteller von Arm oder Scanner angibt.
ui-performance-help-location = Innerhalb einer Stellung behält der Taster seine Richtung; dazwischen Handgelenk und Ellbogen so weit wie möglich drehen.
ui-performance-help-patches = Ein Feld ist mit 20 Punkten aus zwei Bildern abgedeckt. In einem Scan sind mehrere Überfahrten möglich.
ui-performance-help-places = Eine Antastung zählt für die nächste freie Stelle innerhalb von 12°; jede andere wird abgelehnt.
ui-performance-help-review = Alle Punkte innerhalb der festgelegten Grenzen zählen; keiner wird wegen seiner Abweichung entfernt.
ui-performance-help-scan = Die Haupttaste des Arms beginnt und beendet einen Scan.
ui-performance-help-sphere = Die Datei der Kugel im Ordner gauges nennt Durchmesser, Form und ihre Unsicherheiten nach dem Kalibrierschein.
ui-performance-help-temperatures = Eine Änderung während der Prüfung vergrößert die Unsicherheit von Größen und Längen. Ist sie zu groß, wird kein Wert entschieden.
ui-performance-help-touch = Die Haupttaste des Arms nimmt eine Antastung auf, die Rücknahmetaste nimmt die letzte zurück.
ui-performance-needs = Eine kalibrierte Kugel von mindestens 10 mm auf festem Fuß, nicht die zum Kalibrieren verwendete.
ui-performance-tests = Leistungsprüfungen
ui-performance-tests-appear-here = Leistungsprüfungen erscheinen hier, die neueste zuerst, auch die abgebrochenen.
ui-picture = Bild
ui-picture-details = Details zum Bild
ui-picture-not-saved-3d-view-not = Das Bild wurde nicht gespeichert: Die 3D-Ansicht ist noch nicht offen.
ui-picture-size = Bild
ui-picture-taken-only-while-arm-still = Das Bild wird nur aufgenommen, während der Messarm in Ruhe ist. Nehmen Sie sich Zeit.
ui-pictures = Bilder
ui-pictures-calibrated-sensor = Mit wenigen Bildern zum kalibrierten Sensor
ui-pictures-take-about-30-mb-per = Bilder belegen etwa 30 MB je Sekunde und lassen sich später neu auswerten. Die Linien werden immer und vorrangig aufgezeichnet.
ui-pixels-by-pixels = { $width } × { $height } px
ui-place-and-problem = { $place }: { $words }
ui-place-done = angetastet
ui-place-next = als Nächstes
ui-place-tip = Tastkugel
ui-placements = Lagen
ui-places = Lagen
ui-places-far-apparent-motion-tip-max = Bisherige Positionen: scheinbare Bewegung der Tastkugel, (max − min)/2
ui-plane = Ebene
ui-plane-about = Die Form einer gescannten Platte, eine Ergänzung zu den Normen: Die Platte wird zweimal gescannt, die Laserlinie dazwischen um 90° gedreht. Von Hand etwa fünf Minuten.
ui-plane-needs = Eine ebene Platte, mindestens 50 mm breit, mit Kalibrierschein ihrer Ebenheit, matt und fest aufgelegt.
ui-plane-test = Ebene
ui-plane-test-title = Ebenenprüfung
ui-planes-angle-k-1 = Winkel der Ebene, k = 1
ui-planes-flat-to = { $radius } weit, Abstand davon { $flatness }
ui-planes-of-comparison = Ebenen
ui-planes-offset-k-1 = Versatz der Ebene, k = 1
ui-plate = Platte
ui-plate-from-above = Die Platte von oben, mit den Streifen des Scans
ui-play = Abspielen
ui-played = { $time } wiedergegeben
ui-please-choose = Bitte wählen
ui-plotted-quantity = Dargestellte Größe
ui-point = Punkt { $n }
ui-point-on = Punkt { $n }, { $face }
ui-points = Punkte
ui-points-about-plane-rms-without = Streuung um die Ebene: ohne Zeitversatz { $without } rms, mit Zeitversatz { $with } rms
ui-points-alone = Nur Punkte
ui-points-appear-arm-swings = Punkte erscheinen hier, während der Messarm schwenkt.
ui-points-appear-drawing-once-pictures-evaluated = Punkte erscheinen in der Zeichnung, sobald die Bilder ausgewertet sind.
ui-points-appear-drawing-once-three-adjacent = Punkte erscheinen in der Zeichnung, sobald drei aneinandergrenzende Flächen angetastet sind.
ui-points-appear-fifth-contact-point = Ab dem fünften Antastpunkt erscheinen hier Punkte.
ui-points-are-cut-away = { $n ->
    [one] Ein Punkt der Ansicht ist
   *[other] { $n } Punkte der Ansicht sind
} weggeschnitten
ui-points-measuring-volume-moved-rms-most = Punkte im Messvolumen haben sich seit { $name } um { $rms } rms verschoben, höchstens um { $most }.
ui-points-of-file = Punkte: { $name }
ui-points-on-this-face = Punkte auf dieser Fläche
ui-points-s = Punkte/s
ui-points-s-n = { $n } Punkte/s
ui-pose = Pose
ui-pose-n = Pose { $n }
ui-poses = Posen
ui-poses-another-tilt-rotation-improve-result = Posen mit anderer Neigung oder Drehung verbessern das Ergebnis. Die wirksamste wird vorgeschlagen.
ui-positions = Positionen
ui-positions-of-the-sphere = Positionen der Kugel
ui-preparation = Vorbereitung
ui-print-a-board = Tafel drucken
ui-probe = Taster
ui-probe-matrix-t-flange-sensor = Tastermatrix T_flange_sensor
ui-problems = { $n ->
        [one] Ein Problem
       *[other] { $n } Probleme
    }
ui-prometheus-reads = Prometheus liest { $address } mit einem eigenen Token, gesendet als Bearer.
ui-propose-every-size = Alle Maße vorschlagen
ui-proposed-block = Vorgeschlagener Zinnenkörper
ui-provider-sets-role-and-password = Konto des Anbieters, der Rolle und Passwort festlegt
ui-provider-trouble = { $trouble }. Melden Sie sich auf anderem Weg an, oder versuchen Sie es später noch einmal.
ui-proxy-changes-host = Ein Proxy ändert den Host der Anfragen: Diese Seite ist unter { $here }, die Station wird nach { $there } gefragt. So nimmt sie keine Änderungen an.
ui-proxy-drops-upgrade = Die Station antwortet, aber es öffnet sich keine Live-Verbindung: Ein Proxy oder Filter reicht WebSockets nicht weiter.
ui-proxy-hides-scheme = Die Station weiß nicht, dass diese Seite verschlüsselt ist: Ihren Cookies fehlt das Kennzeichen dafür.
ui-proxy-hides-sub-path = Die Station weiß nicht, dass sie unter { $here } angeboten wird: 3D-Ansicht und Anmeldung arbeiten nicht zuverlässig.
ui-proxy-pass-host = Der Proxy soll den Host des Browsers weiterreichen. In nginx: proxy_set_header Host $http_host;
ui-proxy-pass-scheme = Der Proxy soll X-Forwarded-Proto senden, und seine Adresse gehört in den Einstellungen unter proxies.
ui-proxy-pass-sub-path = In den Einstellungen root_path = "{ $path }" setzen oder mit --root-path { $path } starten.
ui-proxy-pass-upgrade = Der Proxy soll das Upgrade weiterreichen. In nginx: proxy_http_version 1.1; proxy_set_header Upgrade $http_upgrade; proxy_set_header Connection $http_connection;
ui-put-datasheet-plate-sphere-into-folder = Eine Platte oder Kugel unter Datenblätter eingeben, oder dort ihre Datei oder den digitalen Kalibrierschein (DCC) einer Kugel hinzufügen. Das Datenblatt enthält Nennmaß, Kalibrierschein und Grenzwerte. Das Prüfnormal erscheint sofort hier.
ui-put-length-standard-into-folder = Die Datei eines Kugelstabs, Maßstabs oder Stufenendmaßes unter Datenblätter hinzufügen; crenel certificate read macht sie aus einem Kalibrierschein. Sie erscheint hier sofort.
ui-radians = Bogenmaß
ui-radius-error = Radiusabweichung
ui-radius-error-lowercase = Radiusabweichung
ui-range = { $low } bis { $high }
ui-range-at-least = mindestens { $low }
ui-range-more-than = mehr als { $low }
ui-range-of-all = Spannweite aller
ui-range-over-the-calibrations = { $figure }: Spannweite über die Kalibrierungen
ui-range-over-the-clouds = { $figure }: Spannweite über die Punktwolken
ui-rate = Rate
ui-readings-of-file = Messwerte: { $name }
ui-ready-to-scan = Bereit zum Scannen
ui-reason-device = Gerät ausgefallen
ui-reason-moved = Normal oder Messarm bewegt
ui-reason-next-button = Der Grund steht neben der Schaltfläche.
ui-reason-operating = Bedienfehler
ui-reason-other = Anderer Grund
ui-rebuild-with-calibrations = { $n ->
        [one] Mit der Kalibrierung neu berechnen
       *[other] Mit { $n } Kalibrierungen neu berechnen
    }
ui-rebuilding-the-clouds = Punktwolken werden neu berechnet …
ui-recommended = Empfohlen
ui-record-of = Eintrag vom { $when }
ui-recorded-data-safe-check-power-cable = Aufgezeichnete Daten sind sicher. Stromversorgung und Kabel prüfen; die Verbindung wird automatisch wiederhergestellt.
ui-recording = Aufzeichnung
ui-records = Archiv
ui-release-control = Bedienung abgeben
ui-reload = Neu laden
ui-remove = Entfernen
ui-remove-name = { $name } entfernen
ui-remove-the-last-joint = Letztes Gelenk entfernen
ui-remove-the-last-length = Letzte Länge entfernen
ui-remove-the-logo = Logo entfernen
ui-remove-this-point = Diesen Punkt entfernen
ui-rename = Umbenennen
ui-replace-it = Ersetzen
ui-replay = Wiedergabe
ui-replaying-a-recording = Aufzeichnung wird wiedergegeben
ui-report = Bericht
ui-request-body = Anfragedaten
ui-request-control = Bedienung anfragen
ui-request-it-under-control = Die Steuerung lässt sich oben anfordern.
ui-requests-control = { $name } bittet um die Bedienung
ui-residual = Residuum
ui-residual-lowercase = Residuum: Blau innen, Orange außen
ui-residuals-on-the-object = Residuen am Objekt
ui-resolution = Auflösung
ui-result-test-message-unknown = das Ergebnis der Testnachricht ist nicht bekannt
ui-retire = Ablegen
ui-retire-it = Datenblatt von { $name } ablegen? Es kann nicht mehr gewählt werden, bleibt aber erhalten und lässt sich zurückholen. Ergebnisse ändern sich nicht.
ui-returned-light = Intensität
ui-revoke-this-link = Diesen Link widerrufen
ui-revoke-this-token = Diesen Token widerrufen
ui-rms = rms
ui-rms-off-the-others = { $part } { $px } rms, { $off } Abweichung von den übrigen
ui-robot = Roboter
ui-robot-that-reports-poses = Roboter, der Posen meldet
ui-role-of = Rolle von { $name }
ui-role-of-the-new-account = Rolle des neuen Kontos
ui-rotation-of-the-laser-plane = Verdrehung der Laserebene
ui-rotation-of-the-measuring-volume = Verdrehung des Messvolumens
ui-row = Zeile
ui-rows-of-inner-corners = Zeilen innerer Ecken
ui-rule-guard =
    Schutzabstand: das { $factor }-Fache der Standardunsicherheit; { $bearer ->
        [supplier] der Lieferant trägt die Unsicherheit, daher ist ein Wert, der näher am Grenzwert liegt, nicht bestanden.
        [user] der Anwender trägt die Unsicherheit, daher ist ein Wert, der näher am Grenzwert liegt, bestanden.
       *[prover] wer etwas nachweisen muss, trägt die Unsicherheit, daher ist ein Wert, der näher am Grenzwert liegt, nicht entschieden.
    }
ui-rule-named =
    Entscheidungsregel: { $name ->
        [guarded-95] Annahme mit Schutzabstand für 95 %
        [expanded-k2] Annahme mit der erweiterten Unsicherheit (k = 2) als Schutzabstand
        [simple] einfache Annahme
       *[other] { $name }
    }, { $standard }:{ $edition }.
ui-rule-without-guard = Kein Schutzabstand: Die Werte werden unmittelbar mit ihren Grenzwerten verglichen, die Unsicherheit wird nur angegeben, und beide Seiten tragen ihr Risiko.
ui-running-jobs-continue-whoever-has-control = Laufende Aufträge werden fortgesetzt, gleich wer die Bedienung hat.
ui-runs-unattended = Läuft unbeaufsichtigt
ui-safety = Sicherheit
ui-save = Speichern
ui-save-changes = Änderungen speichern
ui-save-it-smaller = Mit weniger Pixeln speichern: { $pixels } in der Breite genügen.
ui-save-picture = Bild speichern
ui-save-picture-for-support = Für Support speichern
ui-save-the-certificate = Kalibrierschein speichern
ui-save-the-cloud = Wolke speichern
ui-save-the-datasheet = Datenblatt speichern
ui-save-the-support-bundle = Diagnosepaket speichern
ui-saved-as = { $name } kann ab jetzt gewählt werden.
ui-saved-clouds-appear-newest-first-start = Hier erscheinen gespeicherte Punktwolken, die neueste zuerst. Auf der Seite „Scannen“ einen Scan starten.
ui-saved-in-file-used-from-now-on = Die Station verwendet es ab jetzt. Gespeichert in { $file }.
ui-saving-the-cloud = Punktwolke wird gespeichert …
ui-saving-the-last-scan = Der letzte Scan wird gespeichert …
ui-scale-from-the-datasheet = Maßstab laut Datenblatt
ui-scan = Scannen
ui-scan-accepted = angenommen
ui-scan-again = Nochmals scannen
ui-scan-and-laser-stop-after = Scan und Laser stoppen nach
ui-scan-gauge-plate-sphere = Eine Prüfplatte oder Prüfkugel einige Male scannen. Die Punktwolken werden mit dem Kalibrierschein des Prüfnormals verglichen, anhand Ihrer Grenzwerte und mit ihrer Unsicherheit. Das dauert zwei Minuten.
ui-scan-part-again = Das Teil in den Bereich des Sensors bringen und erneut scannen.
ui-scan-settings = Scan-Einstellungen
ui-scan-the-part = Teil scannen
ui-scan-with-it = Damit scannen
ui-scanned-too-fast = Zu schnell
ui-scanning = Scan läuft
ui-scanning-is-not-possible = Scannen nicht möglich
ui-scanning-is-not-possible-now = Scannen ist jetzt nicht möglich
ui-scans = Scans
ui-scans-of-the-bar-in-place = Scans des Stabs in Lage { $place }
ui-scans-short-bright-metal-long-dark = Für Scans. Kurz auf blankem Metall, lang auf dunklen Teilen; eine lange Belichtung führt zu Unschärfe.
ui-scatter-of = Streuung { $scatter }
ui-scatter-of-the-scan-is-no-uncertainty = Die Streuung ist die des Scans allein, k = 1. Sie ist keine Unsicherheit: Fehler der Kalibrierung und des Messarms sind in allen Punkten gleich, sind darin nicht enthalten und sind meist größer.
ui-search-again = Noch einmal suchen
ui-search-records = Suche: Teil, Nummer, Auftrag, Kunde, Datum
ui-search-text = Suchtext
ui-searching = Suche läuft …
ui-seat = Pfanne
ui-seat-cone-three-balls-which-tip = Eine Pfanne ist ein Kegel oder besteht aus drei Kugeln; die Tastkugel sitzt darin und dreht sich ohne Spiel.
ui-seat-end-ball-bar-tip-stays = In einer Pfanne oder am Ende eines Kugelstabs bleibt die Tastkugel an ihrer Stelle, während der Messarm schwenkt; eine Kugel wird von allen Seiten angetastet. Die Positionen über die ganze Reichweite verteilen: nah und fern, links und rechts, hoch und tief. Dann mit dem Ellbogen auf der anderen Seite wiederholen. Ein Kugelstab bestimmt auch den Maßstab des Messarms.
ui-seats = Pfannen
ui-secret = Geheimnis
ui-seen-from-above-arm-below = Von oben gesehen, unten steht der Arm
ui-seen-too-steeply = Zu steil
ui-select-datasheets-clamped-mounted-result-only = Die Datenblätter der aufgespannten und montierten Teile wählen. Das Ergebnis ist nur so genau wie sie.
ui-selected-object = Gewähltes Objekt
ui-sensor = Sensor
ui-sensor-rotation = Verdrehung des Sensors
ui-sensor-selected = Sensor
ui-sensor-serial = Sensor { $serial }
ui-sensor-shift = Verschiebung des Sensors
ui-sensors = Sensoren
ui-serial-number = Seriennummer
ui-serial-number-of = Nr. { $number }
ui-serial-of = S/N { $serial }
ui-set = Übernehmen
ui-set-at-the-camera = an der Kamera eingestellt
ui-set-it-is-not-displayed-again = gesetzt; wird nicht erneut angezeigt
ui-settings = Einstellungen
ui-shift-centre-measuring-volume-frame-arms = Verschiebung der Mitte des Messvolumens im Koordinatensystem des letzten Gelenks des Messarms
ui-shift-laser-plane-along-normal = Verschiebung der Laserebene entlang ihrer Normalen
ui-show = Zeigen
ui-show-it = Zeigen
ui-show-more-of =
    { $n ->
        [one] { $n } weiteren zeigen
       *[other] Mehr von { $n } zeigen
    }
ui-show-pose = Pose { $n } anzeigen
ui-show-retired-ones = { $n ->
    [one] Das abgelegte anzeigen
   *[other] { $n } abgelegte anzeigen
}
ui-show-the-tour = Rundgang zeigen
ui-shown-in-the-3d-view = In der 3D-Ansicht gezeigt.
ui-side-of-a-marker = Seite eines Markers
ui-side-of-a-square = Seite eines Feldes
ui-sign-in = Anmelden
ui-sign-in-to-continue = Zum Fortfahren anmelden
ui-sign-in-with-a-name = Mit Namen anmelden
ui-sign-in-with-provider = Mit { $name } anmelden
ui-sign-in-with-the-consoles-code = Mit dem Code der Konsole anmelden
ui-sign-out = Abmelden
ui-signed-out-everywhere-no-longer-sign = { $name } wird überall abgemeldet und kann sich nicht mehr anmelden. Die Einträge im Aktionsprotokoll bleiben erhalten.
ui-simulated = simuliert
ui-simulated-operator-may-still-moving = der simulierte Bediener bewegt sich vielleicht noch
ui-simulated-operator-passes-over-plate = Der simulierte Bediener fährt über die Platte.
ui-since = seit { $when }
ui-since-moved-by = Seit { $date }: { $change }.
ui-six-places-determine-the-arms-geometry = Sechs Positionen bestimmen die Geometrie des Messarms
ui-six-seats-spheres-ball-bar-places = Sechs Pfannen, Kugeln oder Kugelstabpositionen über die ganze Reichweite bestimmen die Geometrie des Messarms. Erforderlich, wenn eine Prüfung nicht bestanden ist, oder vor der ersten Kalibrierung.
ui-skip-to-the-page = Zum Inhalt springen
ui-smallest-page = Das kleinste von A4 bis A0
ui-smoothing-along-the-line = Glättung entlang der Linie
ui-smoothing-quieter-points-less-detail = Ruhigere Punkte, aber weniger Details: Standardabweichung in Pixeln entlang der Linie. Strukturen der Periode λ behalten exp(−2(π·Wert/λ)²) ihrer Höhe; die Hälfte bei λ = 5,3-mal dem Wert. Leer: keine.
ui-some-faces-are-not-reached = Einige Flächen sind noch nicht erreicht
ui-sounds-off = Töne aus
ui-sounds-on = Töne an
ui-source = Quelle
ui-source-in-the-program = Stelle im Programm
ui-speed = Geschwindigkeit
ui-sphere = Kugel
ui-sphere-from-above = Die Kugel von oben
ui-spread-points-over-face-away-edges = Die Punkte über jede Fläche verteilen, mit Abstand zu den Kanten. Einen Punkt in der Zeichnung antippen, um ihn anzusehen oder zu entfernen.
ui-squares-across = Felder nebeneinander
ui-squares-down = Felder untereinander
ui-stamps-arrival = Ankunft
ui-stamps-arrival-note = schwanken um Millisekunden
ui-stamps-by = Zeitstempel: { $stamps }
ui-stamps-device = Uhr des Geräts
ui-stamps-pulse = Impulse
ui-stand-off = Arbeitsabstand
ui-standard-uncertainty = Standardunsicherheit (k = 1)
ui-standard-uncertainty-dashed-good = Standardunsicherheit eines gescannten Punkts, k = 1; gestrichelt: Grenzwert für „gut“
ui-standard-uncertainty-of-a-scanned-point = Standardunsicherheit eines gescannten Punkts, k = 1
ui-standard-uncertainty-of-a-scanned-point-lowercase = Standardunsicherheit eines gescannten Punkts, k = 1
ui-standard-uncertainty-of-the-length = Standardunsicherheit der Länge
ui-standard-uncertainty-of-the-radius = Standardunsicherheit des Radius (k = 1)
ui-standard-uncertainty-over-picture = Standardunsicherheit eines gescannten Punkts, k = 1, über dem Bild.
ui-start-calibration = Kalibrierung starten
ui-start-scan = Scan starten
ui-start-the-test = Prüfung beginnen
ui-start-then-move-stripe-slowly-over = Starten, dann die Laserlinie langsam über das Teil führen.
ui-start-verification = Verifizierung starten
ui-starting-the-station = Station wird gestartet
ui-station = Station
ui-station-new-no-accounts-yet-console = Diese Station ist neu und hat noch keine Konten. Den Code für diesen Schritt zeigt ihre Konsole an.
ui-station-offline-picture-old = Die Station ist nicht erreichbar. Dieses Bild ist { $age } alt.
ui-station-responds-again-check-whether-last = Die Station antwortet wieder. Prüfen, ob die letzte Aktion wirksam wurde.
ui-station-stores-everything-already-recorded = Die Station speichert alles, was sie bereits aufgezeichnet hat.
ui-station-uses-it-already = Die Station verwendet dieses Gerät bereits.
ui-stations = Stationen
ui-stay-green-range-distance-indicator-if = Im grünen Bereich der Abstandsanzeige bleiben. Meldet sie „zu schnell“, langsamer führen: Die Linie ist unscharf.
ui-step-already-advanced-nothing-recorded-twice = Der Schritt ist bereits weiter; es wurde nichts doppelt aufgezeichnet.
ui-step-gauge = Stufenendmaß
ui-step-of = Schritt { $n } von { $all }
ui-steps = Schritte
ui-still = in Ruhe
ui-stop = STOPP
ui-stop-and-laser-off-always-respond = „Stopp“ und „Laser aus“ wirken immer.
ui-stop-drawing = Zeichnen beenden
ui-stop-not-confirmed-use-switch-device = „Stopp“ wurde nicht bestätigt. Den Schalter am Gerät verwenden
ui-stop-the-demonstration = Vorführung anhalten
ui-stop-the-scan = Scan stoppen
ui-stop-the-simulated-operator = Simulierten Bediener stoppen
ui-stopped-laser-off-nothing-running = Gestoppt: Der Laser ist aus, und nichts läuft mehr.
ui-stopping = Wird gestoppt …
ui-store-the-certificate = Kalibrierschein speichern
ui-straight-edges = gerade Kanten
ui-stripe = Laserlinie
ui-stripe-lowercase = Laserlinie
ui-supervise = Überwachen
ui-support-bundle = Diagnosepaket
ui-switch-at-the-sensor = Schalter am Sensor
ui-switch-laser-display-detected-line-changes = Laser einschalten, um die erkannte Linie anzuzeigen. Änderungen gelten sofort und werden gespeichert.
ui-switch-on = Einschalten
ui-switched-off = ausgeschaltet
ui-symbols-over-time-appear-after-second-test = Ab der zweiten Prüfung mit demselben Arm und derselben Art von Prüfkörper erscheint hier jedes Symbol im zeitlichen Verlauf.
ui-table-is-not-utf-8 = { $name } ist kein UTF-8-Text: Tabelle als CSV speichern.
ui-table-is-too-large = { $name } ist größer als 200 kB: Punkte gleichmäßig über alle Flächen weglassen.
ui-take-first-last-glass-film-where = Bei Glas und Folie, wo zwei Oberflächen reflektieren, die erste oder die letzte verwenden.
ui-take-over = Übernehmen
ui-take-over-control-give-reason = Oder die Bedienung übernehmen und { $name } einen Grund nennen
ui-take-the-design-over = Als Datenblatt übernehmen
ui-take-the-model-from-a-text = Modell aus Text, Datei oder Liste übernehmen
ui-taken-after-few-more-they-drawn = { $n } aufgenommen. Nach einigen weiteren werden sie hier dargestellt.
ui-temperature = Temperatur
ui-temperature-at-acceptance = Temperatur bei der Annahme
ui-temperature-of-the-arm = Temperatur des Arms
ui-temperature-of-the-artefact = Temperatur des Prüfkörpers
ui-temperature-uncertainty = Unsicherheit der Temperatur (k = 2)
ui-temperatures = Temperaturen
ui-temperatures-at-the-end = Temperaturen am Ende
ui-temperatures-at-the-end-why = Eingetragen sind die Werte vom Anfang. Hat sich einer geändert, ihn eintragen und übernehmen.
ui-temperatures-why = Größen und Längen werden mit der Temperatur des Prüfkörpers auf 20 °C bezogen; ohne sie gelten sie als bei 20 °C gemessen. Nach beiden wird am Ende noch einmal gefragt.
ui-temperatures-why-of-a-plane = Die Form einer Ebene hängt nicht von ihnen ab. Sie zeigen, ob die Bedingungen beständig waren: Nach beiden wird am Ende noch einmal gefragt.
ui-term = Koeffizient
ui-test = Testen
ui-test-lowercase = Test
ui-test-sphere = Prüfkugel
ui-test-the-performance = Ein-Kugel-Prüfung
ui-text-of-the-model = D-H-Tabelle, URDF oder Werkskalibrierung (UR), eingefügt oder als Datei
ui-the-3d-view-is-loading = Die 3D-Ansicht wird geladen.
ui-the-account-was-not-changed = das Konto wurde nicht geändert
ui-the-account-was-not-created = das Konto wurde nicht angelegt
ui-the-account-was-not-removed = das Konto wurde nicht entfernt
ui-the-action-was-not-confirmed = die Aktion wurde nicht bestätigt
ui-the-answer-was-not-sent = die Antwort wurde nicht gesendet
ui-the-arm-begins-at = Der Arm beginnt beim Glied
ui-the-arm-ends-at = Der Arm endet beim Glied
ui-the-arm-has-no-datasheet = Der Messarm hat noch kein Datenblatt
ui-the-arm-is-connected = Der Messarm ist gewählt
ui-the-arms-main-button-begins = Mit der Haupttaste am Messarm beginnen.
ui-the-arms-main-button-ends-it = Mit der Haupttaste am Messarm abschließen.
ui-the-board-was-not-touched = Die Tafel wurde nicht angetastet.
ui-the-brightest = Die hellste
ui-the-calibration-was-not-started = die Kalibrierung wurde nicht gestartet
ui-the-camera-is-connected = Die Kamera ist gewählt
ui-the-certificate-was-not-added = der Kalibrierschein wurde nicht hinzugefügt
ui-the-closest-detection-of-the-object = die am besten passende Erkennung des Objekts
ui-the-cloud-so-far-stays-here = Die bisherige Punktwolke bleibt hier stehen.
ui-the-clouds-were-not-rebuilt = die Punktwolken wurden nicht neu berechnet
ui-the-colours-were-not-changed = die Farben wurden nicht geändert
ui-the-current-scan-is-always-displayed = Der laufende Scan wird immer angezeigt.
ui-the-cut-was-not-undone = Der Schnitt wurde nicht rückgängig gemacht
ui-the-datasheet-is-saved = Das Datenblatt ist gespeichert
ui-the-datasheet-was-not-changed = Das Datenblatt wurde nicht geändert.
ui-the-datasheet-was-not-kept = Das Datenblatt wurde nicht gespeichert.
ui-the-datasheet-was-not-read = das Datenblatt wurde nicht gelesen
ui-the-datasheet-was-not-written = das Datenblatt wurde nicht geschrieben
ui-the-delay-was-not-changed = der Zeitversatz wurde nicht geändert
ui-the-delay-was-not-determined = der Zeitversatz wurde nicht bestimmt
ui-the-demonstration-may-still-run = Die Vorführung läuft vielleicht noch
ui-the-demonstration-was-not-started = Die Vorführung wurde nicht begonnen
ui-the-device-could-not-be-opened = Es ließ sich nicht öffnen. Die Station versucht es weiter.
ui-the-device-was-not-changed = das Gerät wurde nicht geändert
ui-the-device-was-not-opened = das Gerät wurde nicht geöffnet
ui-the-device-was-not-saved = das Gerät wurde nicht gespeichert
ui-the-exposure-was-not-changed = die Belichtung wurde nicht geändert
ui-the-first-from-the-pictures-top = Die erste, vom oberen Bildrand
ui-the-former-version-is-kept = Wird als neue Fassung gespeichert. Die bisherige bleibt unter den abgelegten erhalten.
ui-the-laser-may-still-be-on = der Laser ist vielleicht noch an
ui-the-laser-was-not-switched-on = der Laser wurde nicht eingeschaltet
ui-the-last-from-the-pictures-top = Die letzte, vom oberen Bildrand
ui-the-link-could-not-be-opened = der Link ließ sich nicht öffnen
ui-the-link-may-still-be-valid = der Link gilt vielleicht noch
ui-the-link-was-not-created = der Link wurde nicht angelegt
ui-the-list-could-not-be-loaded = die Liste konnte nicht geladen werden
ui-the-list-could-not-be-loaded-sentence = Die Liste konnte nicht geladen werden.
ui-the-live-picture-resumes-automatically = Das Live-Bild läuft automatisch weiter.
ui-the-logo-was-not-changed = Das Logo wurde nicht geändert
ui-the-longest-line-automatic = Die längste Linie (automatisch)
ui-the-map-could-not-be-loaded = Die Karte konnte nicht geladen werden.
ui-the-model-as-it-was-read = Das Modell, wie es gelesen wurde
ui-the-model-as-its-maker-states-it = Das Modell, wie der Hersteller es angibt
ui-the-name-was-not-changed = der Name wurde nicht geändert
ui-the-notifications-were-not-changed = die Benachrichtigungen wurden nicht geändert
ui-the-object = Das Objekt
ui-the-page-did-not-load = Diese Seite wurde nicht geladen
ui-the-page-did-not-load-why = Die Station antwortet nicht, oder sie hat inzwischen eine andere Version.
ui-the-part-is-not-named = Das Teil ist nicht benannt.
ui-the-part-was-not-named = Das Teil wurde nicht benannt
ui-the-pass-was-not-started = die Überfahrt wurde nicht gestartet
ui-the-password-was-not-changed = das Passwort wurde nicht geändert
ui-the-picture-was-not-changed = das Bild wurde nicht geändert
ui-the-replay-has-ended = Die Wiedergabe ist beendet
ui-the-replay-stopped = Die Wiedergabe wurde abgebrochen
ui-the-same-clouds-with-every-calibration = Dieselben Punktwolken mit jeder Kalibrierung
ui-the-scan-has-no-points = Der Scan hat keine Punkte
ui-the-scan-is-incomplete = Der Scan ist unvollständig: Teile der Oberfläche fehlen.
ui-the-scan-is-not-continued = Der Scan wird nicht fortgesetzt
ui-the-scan-is-saved = Der Scan ist gespeichert
ui-the-scan-may-still-exist = der Scan ist vielleicht noch vorhanden
ui-the-scan-may-still-run = der Scan läuft vielleicht noch
ui-the-scan-was-not-fetched = Der Scan wurde nicht zurückgeholt.
ui-the-scan-was-not-started = der Scan wurde nicht gestartet
ui-the-scans-were-not-compared = Die Scans wurden nicht verglichen
ui-the-scans-were-not-merged = Die Scans wurden nicht zusammengeführt
ui-the-search-was-not-started = die Suche wurde nicht begonnen
ui-the-sensor-was-not-selected = Der Sensor wurde nicht ausgewählt
ui-the-session-was-not-started = die Sitzung wurde nicht gestartet
ui-the-settings-were-not-changed = die Einstellungen wurden nicht geändert
ui-the-shape-was-not-removed = die Form wurde nicht entfernt
ui-the-simulated-operator-was-not-started = der simulierte Bediener wurde nicht gestartet
ui-the-sphere-can-be-chosen = Diese Kugel kann für die Prüfung gewählt werden.
ui-the-station-did-not-start = Die Station ist nicht gestartet
ui-the-station-refused-the-request-status = Die Station hat die Anfrage abgelehnt (Status { $status })
ui-the-temperature-was-not-saved = die Temperatur wurde nicht gespeichert
ui-the-test-was-not-started = Die Prüfung wurde nicht begonnen
ui-the-text-says-so = So steht es im Text.
ui-the-tip-along-points = Die Tastkugel entlang { $axis }, { $n } Punkte
ui-the-token-may-still-be-valid = der Token gilt vielleicht noch
ui-the-token-was-not-created = der Token wurde nicht angelegt
ui-the-trial-has-ended = Das Gerät wurde wieder geschlossen.
ui-the-verification-was-not-started = die Verifizierung wurde nicht gestartet
ui-the-viewpoint-was-not-changed = Der Blickpunkt wurde nicht geändert
ui-there-is-no-logo = Es gibt kein Logo.
ui-there-is-no-such-record = Diese Aufnahme gibt es nicht, oder sie ließ sich nicht laden.
ui-thinned-cloud-picture = aus der ausgedünnten Punktwolke der Ansicht
ui-this-browser-does-not-allow-copying = Dieser Browser erlaubt das Kopieren nicht
ui-this-is-the-arm-take-it-over = Das ist der Arm: übernehmen
ui-this-record-cannot-be-loaded = Dieser Eintrag lässt sich nicht laden
ui-this-station = Diese Station
ui-this-station-uses = Diese Station verwendet
ui-threshold = Schwelle
ui-time = Zeit
ui-time-ago = vor { $time }
ui-time-of-the-scan = Zeit des Scans
ui-time-stamps = Zeitstempel
ui-times-speed = { $n }×
ui-tip = Tastkugel
ui-tip-check = Tastkugelprüfung
ui-tip-checks = Tastkugelprüfungen
ui-tip-diameter = Durchmesser der Tastkugel
ui-tip-error-over-the-reach-rms = Abweichung der Tastkugel über die Reichweite, rms
ui-tip-error-over-the-whole-reach = Abweichung der Tastkugel über die ganze Reichweite
ui-tip-error-over-whole-reach-without = Abweichung der Tastkugel über die ganze Reichweite, ohne den Maßstab des Messarms
ui-tip-x = Tastkugelmitte X
ui-tip-y = Tastkugelmitte Y
ui-tip-z = Tastkugelmitte Z
ui-to-aim-expose-and-focus = Zum Ausrichten, Belichten und Scharfstellen
ui-to-do = zu erledigen
ui-to-do-again = erneut zu erledigen
ui-together = Gesamt
ui-tolerance-of-making = Herstellungstoleranz (±)
ui-too-far = Zu weit
ui-too-few-pictures-for-their-scatter = Zu wenige Bilder, um ihre Streuung anzugeben.
ui-too-near = Zu nah
ui-tool-was-found = { $tool }: Nullpunktfehler oder Durchmesser { $value } ± { $known }, k = 2.
ui-touch-dots-any-order = An den Punkten antasten, in beliebiger Reihenfolge.
ui-touch-faces-crenellated-object-arms-tip = Die Flächen des Zinnenkörpers mit der Tastkugel antasten. Dann den Sensor darüberhalten und in wenigen Posen je ein Bild aufnehmen; die Station schlägt sie vor. Die Unsicherheit des Ergebnisses wird in { $unit } angegeben, bevor etwas ersetzt wird.
ui-touch-gauge-plate-sphere-probe-then = Eine Prüfplatte oder Prüfkugel mit dem Taster antasten, dann einige Male scannen. Die Punktwolken werden mit dem Kalibrierschein des Prüfnormals und mit dem Taster verglichen, anhand Ihrer Grenzwerte und mit ihrer Unsicherheit. Das dauert zwei Minuten.
ui-touch-rings-continue-chessboard-need-not = An den Ringen antasten oder fortfahren: Ein Schachbrett muss nicht angetastet werden.
ui-touch-rings-point-appears-residual = An den Ringen antasten. Jeder Punkt erscheint hier mit seinem Residuum.
ui-touch-sphere-known-diameter-nine-places = Eine Kugel mit bekanntem Durchmesser an neun Stellen mit gedrehtem Handgelenk antasten. So zeigt sich eine abgenutzte, verbogene oder falsche Tastkugel, bevor sie die Messungen eines Tages verdirbt.
ui-tour-card = was zu tun ist
ui-tour-card-text = Der umrandete Bereich sagt, was jetzt zu tun ist. Seine große Schaltfläche ist immer der nächste Schritt.
ui-tour-control = wer bedient
ui-tour-control-text = Mehrere Browser können zusehen, einer bedient. Hier steht, wer es ist, und hier wird die Bedienung angefragt.
ui-tour-end = Rundgang beenden
ui-tour-go-on = Mehr zeigen
ui-tour-help = Tasten und dieser Rundgang
ui-tour-help-text = Das Fragezeichen nennt die Tasten, die den Griff zur Maus sparen, und zeigt diesen Rundgang wieder.
ui-tour-pages = die Seiten
ui-tour-pages-text = Zuerst kalibrieren, das Ergebnis verifizieren, dann scannen. Alles bleibt im Archiv erhalten.
ui-tour-part = Rundgang, { $n } von { $all }:
ui-tour-picture = wo
ui-tour-picture-text = Die große Fläche zeigt wo: die Kamera, das Objekt, die Punktwolke oder das Ergebnis. Meldungen erscheinen darunter.
ui-tour-stop = Laser und STOPP
ui-tour-stop-text = Sie sind auf jeder Seite am selben Platz, wirken sofort und gehorchen jedem, der angemeldet ist.
ui-try = Ausprobieren
ui-try-again = Noch einmal versuchen
ui-try-again-if-error-persists-check = Erneut versuchen. Bleibt der Fehler bestehen, im Protokoll der Station nachsehen.
ui-try-this-device = Dieses Gerät ausprobieren
ui-turn-off-notifications-here = Benachrichtigungen hier ausschalten
ui-turn-on-notifications-here = Benachrichtigungen hier einschalten
ui-two-positions = Zwei, wie die Norm verlangt
ui-type = Typ
ui-u-from-parts = { $whole }: Wurzel der Quadrate von { $parts }
ui-u-k-2 = U (k = 2)
ui-u-measurement = U
ui-u-part = 
    { $source ->
        [gauge] Prüfnormal { $value }
        [probe] Taster { $value }
        [points] Punkte { $value }
       *[clouds] Punktwolken { $value }
    }
ui-u-test = U der Prüfung
ui-u-test-k-2 = U der Prüfung (k = 2)
ui-u-value =
    U{ $by ->
        [test] { " " }der Prüfung
        [measurement] { " " }der Messung
       *[other] { "" }
    } = { $value }, k = 2
ui-uncertain = Nicht entschieden
ui-uncertainty = Unsicherheit
ui-uncertainty-budgets = Unsicherheitsbudgets (k = 2): U ist die Wurzel der Quadratsumme seiner Anteile
ui-uncertainty-counts-twice = Der Kalibrierschein des Messmittels sagt nicht, welchen Teil seiner Unsicherheit alle Messwerte gemeinsam haben: Sie zählt für jeden Messwert allein und für das Gemeinsame.
ui-uncertainty-of-a-point-in-view = Standardunsicherheit eines gesehenen Punkts, k = 1
ui-uncertainty-of-a-point-k-1 = Unsicherheit eines Punkts, k = 1
ui-uncertainty-of-instrument = Seine Unsicherheit, k = 2
ui-uncertainty-of-the-tip = Unsicherheit des Tasters
ui-uncertainty-scanned-point-k-1 = Unsicherheit eines gescannten Punkts (k = 1)
ui-unchanged = unverändert
ui-unchanged-parameters = Unveränderte Parameter
ui-undecided = nicht entschieden
ui-undo = Zurücknehmen
ui-undo-the-last-cut = Letzten Schnitt rückgängig
ui-unit = Einheit
ui-unit-of-the-angles = Einheit der Winkel
ui-unit-of-the-lengths = Einheit der Längen
ui-unknown = unbekannt
ui-unknown-the-broker-is-offline = unbekannt, der Broker ist nicht erreichbar
ui-unusable = unbrauchbar
ui-upper-limit = Obere Grenze, { $unit }
ui-use-gauge-certificate-size-form-uncertainty = Ein Prüfnormal mit Kalibrierschein verwenden: Maß, Form und Unsicherheit gehen in die Entscheidung ein.
ui-use-is-unknown = keine Verwendung aufgezeichnet
ui-use-it = Zeitversatz verwenden
ui-use-next-scan = In Verwendung ab dem nächsten Scan.
ui-use-none = Keinen Zeitversatz verwenden
ui-use-the-simulated-one-again = Wieder das simulierte verwenden
ui-use-this-arm = Diesen Messarm verwenden
ui-use-this-camera = Diese Kamera verwenden
ui-used = Verwendet
ui-valid = gültig
ui-valid-old = gültig, { $age } alt
ui-valid-until = gültig bis { $day }
ui-valid-until-left = gültig bis { $day } (in { $left })
ui-validity = Gültigkeit
ui-value = Wert
ui-value-at-pixel = { $value } bei { $u }, { $v }
ui-value-n = Wert { $n }
ui-verification = Verifizierung
ui-verifications = Verifizierungen
ui-verified = Verifiziert
ui-verify = Verifizieren
ui-verify-again = Erneut verifizieren
ui-verify-the-calibration = Kalibrierung verifizieren
ui-view = Ansicht
ui-view-contains-only-some-them = die Ansicht enthält nur einen Teil davon
ui-viewer = Betrachter
ui-viewers-account-watch-everything-operators-account = Betrachter können alles ansehen, Bediener können auch handeln.
ui-viewpoint = Blickpunkt
ui-waiting = wird erwartet
ui-waiting-for-the-station = Warten auf die Station …
ui-waits-for-a-trigger-or-a-change = wartet auf einen Trigger oder eine Änderung
ui-warnings = Warnungen
ui-wavelength-of-the-laser = Wellenlänge des Lasers
ui-way-to-the-first-calibration = Der Weg zur ersten Kalibrierung
ui-weak-places = Schwache Stellen
ui-what = Was
ui-what-a-printed-board-is = Eine Tafel im Maßstab auf Papier, auf eine ebene Platte geklebt. Ihr Datenblatt wird hier übernommen.
ui-what-certifying-is = Geben Sie ein, was an { $name } gemessen wurde. Die Flächen folgen nach kleinsten Quadraten; Messwerte, die sich widersprechen, werden genannt.
ui-what-datasheets-are = Was die Station von Messarmen, Sensoren, Blöcken und Tafeln und von Prüfnormalen weiß. Eine Kalibrierung wählt daraus und behält eigene Kopien.
ui-what-is-missing = Was fehlt
ui-what-tables-are = Punkte einer Koordinatenmessmaschine, Antastungen mit dem Taster des Arms (auch probing.csv einer Sitzung) oder Messwerte. Sie können hereingezogen werden.
ui-what-the-design-of-a-block-is = Die Station schlägt den Zinnenkörper vor, mit dem Kalibrierungen dieses Sensors am genauesten werden, und nennt die Genauigkeit.
ui-what-to-do-next = Nächster Schritt
ui-when = Wann
ui-when-browser-in-control-is-gone = Wenn der Browser mit der Bedienung fort ist (geschlossen, eingefroren oder ohne Netz) und der Messarm so lange still steht, 10 bis 3600 s. Solange sich der Messarm bewegt oder der simulierte Bediener arbeitet, stoppt nichts. Automatisch: 30 s.
ui-where = Wo
ui-where-several-lines-cross-a-column = Wenn mehrere Linien eine Spalte kreuzen
ui-who = Wer
ui-whole-cloud = Ganz
ui-why = Warum
ui-why-certify = Mit Messschieber, Bügelmessschraube, Koordinatenmessmaschine oder dem Taster des Arms vermessen, sind seine Flächen besser bekannt als durch die Zeichnung.
ui-why-is-the-test-cancelled = Warum wird die Prüfung abgebrochen?
ui-wider-lines-surfaces-automatic-about-twice = Breitere Linien gelten als beleuchtete Flächen. Automatisch: etwa das Doppelte der üblichen Linienbreite.
ui-width-in-pixels = Bildbreite, px
ui-width-of-the-block = Breite des Zinnenkörpers
ui-width-of-the-picture = Breite des Bildes
ui-widths = Breiten
ui-within = innerhalb des Grenzwerts von { $limit }
ui-without-a-ball-bar = Ohne Kugelstab
ui-without-a-datasheet = Nach Zahlen, ohne Datenblatt
ui-without-a-sphere = Ohne Kugel
ui-without-arm-position = Ohne Armstellung
ui-without-contact-points-only-form-size = Ohne Antastpunkte werden nur Form, Maß und Streuung beurteilt, nicht die Lage.
ui-write-the-datasheet-of-the-arm = Datenblatt anlegen
ui-wrong-tip-object-appears-residuals-later = Eine falsche Tastkugel oder ein falsches Objekt zeigt sich später in den Residuen und wird dann gemeldet.
ui-you = Sie
ui-you-are-signed-in-as = Angemeldet als
ui-you-control-others-only-watch = Sie haben die Bedienung. Andere können nur zusehen.
ui-you-have-been-signed-out = Sie wurden abgemeldet.
ui-you-have-control-in-another-browser = Sie haben die Bedienung in einem anderen Browser.
ui-you-may-still-be-signed-in = Sie sind vielleicht noch angemeldet
ui-you-reload-page-switch-another-tablet = Sie können die Seite jederzeit neu laden oder zu einem anderen Tablet wechseln; es geht nichts verloren.
ui-you-were-not-signed-in = Sie wurden nicht angemeldet
ui-your-account-can-only-view = Mit Ihrem Konto können Sie nur zusehen.
ui-your-account-only-view-acting-requires = Mit Ihrem Konto können Sie nur zusehen. Zum Bedienen als Bediener anmelden.
ui-your-name = Ihr Name
ui-z-error = Z-Abweichung
ui-z-error-in-the-clouds-middle = Z-Abweichung in der Mitte der Punktwolke
ui-zones = { $n ->
        [one] { $n } Zone
       *[other] { $n } Zonen
    }
ui-zones-without-measurement = Zonen ohne Messung

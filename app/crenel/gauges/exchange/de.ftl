acceptance-limit-lower = Untere Annahmegrenze
acceptance-limit-upper = Obere Annahmegrenze
at-beginning = Am Anfang
at-end = Am Ende
certificate-days-reversed = nach der Uhr der Station begann die Prüfung am { $begun } und endete am { $ended }; der Kalibrierschein braucht beide Tage in ihrer Reihenfolge
certificate-has-lengths = der Kalibrierschein nennt: { $names }
certificate-has-no-length = der Kalibrierschein nennt keine Länge
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
certificate-without-values = Kein Wert konnte angegeben werden.
certified-size-impossible = { $name } ist { $size }, bekannt auf { $known } (k = 1): Das ist kein Maß eines Normals
certified-size-without-uncertainty = { $name } hat keine Unsicherheit mit Erweiterungsfaktor
dcc-version-needed = Gelesen werden Kalibrierscheine der Version 3
dcc-version-unknown = der Kalibrierschein hat die Version { $version }
enter-artefact-by-hand = Das Normal von Hand eingeben, mit den Angaben seines Kalibrierscheins
enter-country = Es angeben, etwa DE; auf der Befehlszeile mit --country DE
enter-laboratory = Ihn angeben; auf der Befehlszeile mit --laboratory NAME
expansion-not-read = der Ausdehnungskoeffizient des Kalibrierscheins wird nicht gelesen: expansion_per_c in der Datei eintragen
maximum-permissible-error = Größte zulässige Abweichung
name-quantity = Die Größe mit { $option } benennen
no-dcc = die Datei ist kein digitaler Kalibrierschein (DCC)
schema-is-of-xml = ein Schema prüft nur QIF und Kalibrierscheine
schema-leave-out = --format qif oder --format dcc verwenden oder --schema weglassen
sphere-diameter-not-read = der Kalibrierschein nennt keinen Durchmesser der Kugeln oder mehrere: sphere_diameter_mm in der Datei eintragen
test-value-uncertainty = Prüfwertunsicherheit
test-value-uncertainty-text = Erweiterte Unsicherheit von Normal und Aufbau, k = 2. Die Streuung von Arm und Sensor gehört nicht dazu: Die Prüfung misst sie.

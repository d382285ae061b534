add-column-or-leave-both = Spalte ergänzen oder beide weglassen
add-micrometer-reading-of-width = Die Breite eines Zahns mit der Messschraube messen und ergänzen, oder den Tasterdurchmesser abziehen und seine Unsicherheit als tool_uncertainty_mm unter einem anderen Gerät angeben
add-readings-from-face-known = Messwerte dieser Flächen gegen andere ergänzen
certificate-must-be-known-to = ein Zertifikat ist auf { $most } bekannt
check-names-of-faces-and-axes = Die Namen der Flächen und die Richtungen der Maschinenachsen prüfen
coordinates-about-mean-of-faces = Die Unsicherheiten gelten gegen den Mittelwert der Flächen jeder Achse, so dass der Abstand zweier Flächen die Wurzel aus der Summe ihrer Quadrate hat.
correct-reading-or-leave-out = Messwert berichtigen oder weglassen
diameter-up-to-or-unknown = erwartet wird ein Durchmesser in mm bis { $most }, 0 für Punkte, die die Maschine korrigiert hat, oder unknown
direction-points-into-block = { $place }: die Richtung i, j, k zeigt bei { $face } in den Block
directions-point-out-of-surface = Richtungen zeigen aus der Oberfläche heraus; die Antastung gehört zu einer anderen Fläche, oder die Vorzeichen sind vertauscht
error-of-arm-over-reach-unknown = { $path } nennt den Fehler des Arms über seine Reichweite nicht
errors-of-links-counted = Fehler der Armglieder zählen, mit allem, was den Antastungen davon gemeinsam ist: { $error } (Effektivwert) des Tasters über die Reichweite des Arms.
exchange-faces-or-touch-again = Die Namen tauschen, oder beide noch einmal antasten
exchange-readings-or-read-again = Tauschen, oder beide noch einmal messen
face-has-touches =
    { $count ->
        [one] { $face } wurde einmal angetastet
       *[other] { $face } wurde { $count }-mal angetastet
    }
face-known-only-to = die Messwerte lassen eine Fläche um { $known } unsicher
faces-are-not-parallel = das sind nicht zwei parallele Flächen
faces-beyond-tolerance = Um mehr als die Toleranz von ± { $tolerance } neben der Zeichnung: { $faces }. Diese Messwerte prüfen, auch ob zwei vertauscht sind.
faces-of-readings-are = die Flächen sind edge_1 bis edge_{ $edges }, { $names }
file-has-touches = { $path } hat { $count } Antastungen
give-arm-of-touches = Die Datei des Arms mit --arm angeben
give-readings-points-or-both = readings.csv, --points oder beides angeben
identify-arm-or-state-arm-um = Den Arm identifizieren, oder den Effektivwert des Fehlers seines Tasters über die Reichweite mit --arm-um angeben
leave-out-touches-evenly = Antastungen gleichmäßig auf allen Flächen weglassen
links-errors-do-not-average-out = Fehler der Glieder sind bei jeder Antastung gleich und mitteln sich nicht heraus
most-touches-are = höchstens { $most } sind verwendbar
multiply-coordinates-by = Die Koordinaten mit { $factor } multiplizieren
multiply-readings-by-inch = Mit 25,4 multiplizieren
neither-readings-nor-points = weder Messwerte noch Punkte wurden angegeben
one-of-readings-is-wrong = die Messwerte zeigen nicht, welcher davon falsch ist
opposite-faces-exchanged-or-left-handed = gegenüberliegende Flächen wie front und back sind vertauscht, oder die Maschinenachsen sind linkshändig
posture-and-its-uncertainty = posture und posture_uncertainty_mm werden zusammen angegeben
read-these-again = Diese noch einmal messen
reading-between-faces = { $place }: ein Messwert von { $first } bis { $second }
reading-far-beside-drawing = { $place }: { $reading } gemessen, wo die Zeichnung { $drawn } hat
reading-of-other-faces = die Zeile gehört zu anderen Flächen, einem anderen Block oder einer anderen Einheit
reading-off-by = { $reading } um { $off }
readings-agree-if-exchanged = alle Messwerte passen zusammen, wenn { $one } und { $other } getauscht werden
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
readings-scatter-more = Die Messwerte streuen { $times }-mal so stark wie angegeben; die Unsicherheiten sind um diesen Faktor größer.
state-tip-uncertainty-or-unknown = tip_uncertainty_mm angeben, oder als Durchmesser unknown schreiben und eine Breite mit einem anderen Gerät ergänzen
tip-alone-never-shows-diameter = ein kleinerer Taster und ein größerer Block ergeben dieselben Messwerte
tip-diameter-not-shown = kein Messwert zeigt den Durchmesser des Tasters „{ $tool }“
tip-error-is-in-every-width = der Fehler des Durchmessers steckt in jeder Breite
tips-diameter-has-no-uncertainty = { $place }: der Tasterdurchmesser hat keine Unsicherheit
touch-in-row = Antastung in Zeile { $line } ({ $face })
touch-lies-beside-face = { $place }: die Antastung liegt { $off } neben { $face }
touch-lies-on-face = sie liegt auf { $face }
touch-lies-on-no-face = sie liegt auf keiner anderen Fläche oder auf mehreren
touch-two-faces-of-two-axes = nötig sind Antastungen auf je zwei Flächen von zwei Achsen, etwa alle Kanten, front und back
touches-agree-if-exchanged = alle Antastungen passen zusammen, wenn die Namen von { $one } und { $other } getauscht werden
touches-agree-in-unit = { $place } und die folgenden: die Antastungen passen zur Zeichnung, wenn sie in { $unit } sind
touches-are-joint-angles = { $path } hat die Gelenkwinkel eines Arms
touches-are-mirror-image = die Antastungen gehören zum Spiegelbild des Blocks
touches-do-not-show-place = die Antastungen zeigen nicht, wo der Block steht
touches-scatter-more = Die Antastungen streuen { $times }-mal so stark wie angegeben; die Unsicherheiten jeder für sich sind um diesen Faktor größer.
uncertainty-above-zero-up-to = erwartet wird eine Unsicherheit in mm über 0 und bis { $most }

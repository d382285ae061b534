bring-whole-object-into-view-front = das ganze Objekt ins Bild bringen, von vorn oben, und gleichmäßig beleuchten
camera-needs-two-levels-four-sides = für eine Kamera sind zwei Höhenstufen und vier Seiten der Zinnen nötig
can-read-more-than-one-way = es ist nicht eindeutig
choose-object-before-camera-if-one = das Objekt wählen, das vor der Kamera liegt; ist es dieses, prüfen, ob seine Kanten sauber und unbeschädigt sind
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
edges-lie-off-average-where-certificate = seine Kanten liegen im Mittel { $usual } und { $edge } { $distance } neben der Lage laut Kalibrierschein
edges-would-fit-only-if-cameras = seine Kanten würden nur passen, wenn die Pixel der Kamera um { $off_square } von der quadratischen Form abwichen
edges-would-fit-only-lens-distorted = seine Kanten würden nur zu einem Objektiv mit der Verzeichnung k1 = { $k1 }, k2 = { $k2 } passen
focus-camera-bring-object-and-hold-still = Kamera auf das Objekt scharf stellen, es in den Arbeitsabstand bringen und ruhig halten
focus-camera-object-bring-into-working = Kamera auf das Objekt scharf stellen, es in den Arbeitsabstand bringen, ruhig halten
frame-shows-only-s-visible-edges = das Bild zeigt nur { $share } der sichtbaren Kanten von „{ $name }“
goes-beyond-end =
    { $side ->
        [right] { $edge } reicht über ihr rechtes Ende hinaus
       *[left] { $edge } reicht über ihr linkes Ende hinaus
    }
height-of-level =
    { $level ->
        [base] die Höhe seiner Grundfläche
        [floors] die Höhe seiner Nutgründe
       *[crests] die Höhe seiner Zinnenoberseiten
    }
hold-still-for-both-pictures = Sensor und Objekt ruhig halten, bis beide Bilder aufgenommen sind, oder den Raum abdunkeln
less-than-pictures-edges-wide = { $text }, weniger als die Kantenbreite von { $width } im Bild
lies-where-certificate-puts = { $edge } liegt { $distance } neben der Lage laut Kalibrierschein
light-front-above-so-crests-floors = von vorn oben beleuchten, sodass sich Zinnenoberseiten, Nutgründe und Vorderseite unterscheiden, näher herangehen und entfernen, was davor liegt
merlons-read-alike-either-side = seine Zinnen sehen von beiden Seiten gleich aus
merlons-read-mirrored-order = die Zinnen von „{ $name }“ erscheinen in gespiegelter Reihenfolge
move-sensor-until-whole-object-picture = den Sensor bewegen, bis das ganze Objekt im Bild ist
no-crenellated-object-found-picture = im Bild wurde kein Zinnenkörper gefunden
no-placing-edges-explains-those-picture = keine Lage des Objekts erklärt die Kanten im Bild
none-edges-floors-base-shows-picture = im Bild ist keine Kante seiner Nutgründe und seiner Grundfläche zu sehen
not-sharp-enough = „{ $name }“ ist für eine sichere Erkennung nicht scharf genug zu sehen
not-visible-enough = „{ $name }“ ist für eine sichere Erkennung nicht gut genug zu sehen
nothing-else-bears-out-shadow-highlight = { $text }, und nichts anderes bestätigt dies: Ein Schatten, ein Glanzlicht oder etwas davor kann so aussehen
object-does-not-match-certificate = das Objekt im Bild passt nicht zum Kalibrierschein von „{ $name }“ ({ $serial_number })
object-looked-grey-images-8-16 = das Objekt wird in Graubildern mit 8 bis 16 Bit und mindestens 64 Pixeln je Richtung gesucht
object-not-found = das Objekt wurde nicht gefunden
only-corners-can-measured = nur { $found } seiner Ecken sind messbar
only-edge-points-lie-edges = nur { $agreeing } der Kantenpunkte liegen auf seinen Kanten
only-visible-edges-show-picture = nur { $shown } seiner sichtbaren Kanten sind im Bild zu sehen
picture-blurred-edges-wide = das Bild ist unscharf: Seine Kanten sind { $width } breit
picture-blurred-edges-wide-most-can = das Bild ist unscharf: Seine Kanten sind { $blur } breit, messbar sind höchstens { $limit }
picture-can-read-more-than-one = das Bild von „{ $name }“ ist nicht eindeutig
picture-dim-bright-parts-reach-full = das Bild ist dunkel: Die hellen Bereiche erreichen { $high } des Aussteuerbereichs
picture-mirrored-camera-looks-objects-back = das Bild ist gespiegelt, oder die Kamera sieht die Rückseite des Objekts
picture-overexposed = { $saturated } des Bildes sind überbelichtet
picture-shows-no-contrast-full-scale = das Bild zeigt keinen Kontrast: { $contrast } des Aussteuerbereichs
picture-soft-edges-wide = das Bild ist etwas unscharf: Seine Kanten sind { $width } breit
pictures-with-and-without-laser-differ-by-motion = zwischen dem Bild mit Laser und dem ohne hat sich etwas bewegt ({ $shifted } des Bildes), sodass das Raumlicht nicht abgezogen werden konnte
rejected-and-few-edges-show = { $text }, und nur { $shown } seiner sichtbaren Kanten sind im Bild zu sehen
seems-lie-where-certificate-puts = { $edge } liegt anscheinend { $off } neben der Lage laut Kalibrierschein
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
straight-edges-do-not-form-block = seine { $segment_count } geraden Kanten ergeben keinen Zinnenkörper
too-few-edges-could-measured = zu wenige seiner Kanten ließen sich messen
turn-down-exposure-until-objects-faces = kürzer belichten, bis die Flächen des Objekts nicht mehr überbelichtet sind
turn-off-cameras-mirroring-turn-object = Spiegelung der Kamera ausschalten oder das Objekt so drehen, dass seine Vorderseite zur Kamera zeigt
turn-up-light-exposure = mehr beleuchten oder länger belichten
turn-up-light-exposure-look-object = mehr beleuchten oder länger belichten und den Sensor auf das Objekt richten
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
use-object-whose-merlons-differ-width = ein Objekt verwenden, dessen Zinnen verschieden breit sind
what-shows-could-more-than-one = das Sichtbare könnte zu mehr als einem Teil des Objekts gehören
what-shows-reads-rather-like-objects = das Sichtbare entspricht eher dem Spiegelbild des Objekts

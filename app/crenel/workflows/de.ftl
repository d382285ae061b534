a-calibration-belongs-to-one-sensor = eine Kalibrierung gehört zu einem von ihnen
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
arm-model-arm = das Armmodell gehört zum Messarm { $serial_number }
calibration-arm = die Kalibrierung gilt für den Messarm { $known }
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
clouds-do-not-overlap = Nur { $count } von { $total } verglichenen Punkten liegen auf dem anderen Scan
compare-scans-of-one-place = Scans desselben Teils an derselben Stelle vergleichen
comparison-needs-points = Der Scan zum Vergleich hat { $count } Punkte; nötig sind { $needed }
coordinate-left-out-off = coordinates.csv Zeile { $number } ({ $place }): { $distance } Abweichung
delay-drifts = Der Zeitversatz driftet um { $drift } (k = 1: { $u }), { $change } während der Überfahrt: Die Uhren von Messarm und Kamera gehen verschieden schnell.
delay-jumped = Der Zeitversatz änderte sich { $at } nach dem ersten Bild (k = 1: { $at_u }) um { $change } (k = 1: { $u }): Eine Uhr wurde gestellt.
delay-varies = Der Zeitversatz schwankt während der Überfahrt, wie bei Paketen des Messarms, die verschieden spät ankommen: { $u } (k = 1) seiner Unsicherheit kommen daher.
frame-has-pixels = { $path }: Bild { $number } hat { $width_px } × { $height_px } Pixel
frames-joint-samples-which-neighbours-up = Bilder von { $frames_from } bis { $frames_to }, Messwerte des Messarms von { $joints_from } bis { $joints_to }; verwendet werden Nachbarn mit höchstens { $gap } Abstand
frames-left-out-clock-set = { $count } von { $frames } Bildern ausgelassen: Um ihre Zeitstempel wurde eine Uhr zurückgestellt
frames-left-out-no-joints-around = { $count } von { $frames } Bildern ausgelassen: keine Messwerte des Messarms um ihre Zeitstempel, das erste { $first } nach Beginn; { $beyond } vor dem ersten oder nach dem letzten Messwert, { $gaps } in Lücken
give-a-calibration-for-each-sensor = die Kalibrierung jedes Sensors mit seinem Namen angeben, z. B. { $name }=calibration.json
give-arm-and-camera-one-clock = Beide an einer Uhr betreiben (PTP oder Pulse des Messarms), oder den Zeitversatz vor jedem Scan bestimmen.
give-calibration-sensor-took-recording = Kalibrierung des Sensors angeben, mit dem diese Aufzeichnung entstand
give-calibration-without-name = seine Kalibrierung ohne Namen angeben
give-files-belong-together = Zusammengehörige Dateien angeben
holds-more-than-frames = { $path } enthält mehr als { $most } Bilder
holds-no-topics = { $path } enthält keine Topics
holds-topics = { $path } enthält { $topics }
is-of = { $path } gehört zu { $device } { $of }
its-sensor-has-no-name = ihr Sensor hat keinen Namen
its-sensors-are = ihre Sensoren sind { $names }
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
joints-of-others-left-out = Gelenke, die arm.json nicht hat, sind weggelassen: { $names }
laser-off-too-weak-part-out = der Laser war aus oder zu schwach, oder das Teil lag außerhalb des Messbereichs
no-frames = { $named }: keine Bilder
no-joint-angles = { $named }: keine Gelenkwinkel
no-joints-around-any-frames-stamp = { $named }: keine Messwerte des Messarms um die Zeitstempel der Bilder
no-laser-stripe-front-sensor-any = { $named }: in keinem der { $numbered } Bilder ist eine Laserlinie vor dem Sensor
one-picture-flat-board-tells-neither = ein Bild einer ebenen Tafel bestimmt weder die Brennweite noch die Laserebene
one-pose-not-enough = eine Pose reicht bei „{ $name }“ nicht aus
one-pose-takes-no-raw = eine einzelne Pose lässt sich nicht aus Bayer-Rohbildern kalibrieren
other-files = die anderen Dateien gehören zu { $device } { $known }
pass-half-minute-enough = eine Überfahrt von einer halben Minute reicht
pass-over-one-flat-plate = Eine einzige ebene Platte überfahren und ihren Rand auslassen.
pictures-do-not-fit-delay = { $off } von { $pictures } Bildern passen bei diesem Zeitversatz nicht zu einer Ebene.
point-left-out-off = { $place }, Punkt { $number }: { $distance } Abweichung
pose-used-other-one-pose =
    { $unused ->
        [one] Pose { $number } wurde verwendet; beim Verfahren one-pose bleibt die andere unberücksichtigt
       *[other] Pose { $number } wurde verwendet; beim Verfahren one-pose bleiben die anderen { $unused } unberücksichtigt
    }
record-one-pass-over-plane = Eine Überfahrt über eine Ebene aufzeichnen
recording-has-no-sensor-named = { $path } enthält keinen Sensor namens { $name }
recording-has-one-sensor = { $path } ist eine Aufzeichnung eines einzigen Sensors
recording-has-sensors = { $path } ist eine Aufzeichnung mehrerer Sensoren ({ $names })
same-picture-as-pose = { $name } ist noch einmal das Bild der Pose { $number }
same-picture-counts-once = dasselbe Bild zählt einmal
scan-again = Erneut scannen
scan-again-arm-camera-one-clock = Mit gemeinsamer Zeitbasis von Messarm und Kamera erneut scannen
scan-has = ein Scan enthält { $joints_topic } und { $image_topic } oder { $stripe_topic }
scan-incomplete-remedy = Ursache beheben und erneut scannen; crenel reconstruct --allow-incomplete berechnet die möglichen Punkte, mit Lücken
scan-incomplete-unread = der Rest der Aufzeichnung ist nicht lesbar und kann mehr enthalten als alle bisherigen Punkte
scan-is-missing-parts = { $path } ist unvollständig: { $missing }
sensor-left-out =
    { $count ->
        [one] ein Bild
       *[other] { $count } Bilder
    } des Sensors { $name } ausgelassen: für ihn wurde keine Kalibrierung angegeben
set = Satz { $name }
stripes-were-smoothed = Punkte bei der Aufnahme entlang der Laserlinie um { $smoothing } geglättet: Strukturen kürzer als { $half } behalten weniger als die halbe Höhe, benachbarte Punkte teilen ihr Rauschen
taken = { $path } wurde mit { $device } { $recorded } aufgenommen
the-is-for =
    { $device ->
        [sensor] die Kalibrierung gilt für { $known }
       *[arm] die arm.json gilt für { $known }
    }
use-a-chessboard-or-leave-out-the-option = Schachbrett verwenden oder die Option weglassen
use-method-joint = --method joint verwenden
use-method-joint-pictures-board-several = --method joint verwenden, mit Bildern der Tafel von mehreren Seiten

arm-encoders = Winkelgeber des Messarms
arm-geometry = Geometrie des Messarms
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
bring-block-closer-so-fills-picture = Zinnenkörper näher heranbringen, sodass er das Bild füllt.
bring-block-middle-stripe = Zinnenkörper in die Mitte der Laserlinie bringen.
calibration-pose = die Kalibrierpose
camera-and-mounting = Kamera und Anbau
camera-parameters-do-not-converge = die Kameraparameter konvergieren mit den Kanten im Bild nicht
cameras-pixels-come-out-out-square = Die Pixel der Kamera weichen um { $difference } von der quadratischen Form ab; bei heutigen Sensoren sind sie quadratisch (Grenzwert { $limit }).
check-laser-exposure-sensors-stripe-axis = Laser, Belichtung und stripe_axis des Sensors prüfen und die Laserlinie über die Mitte des Objekts führen
check-object-picture-take-picture-again = prüfen, ob dies das Objekt im Bild ist, und das Bild neu aufnehmen
check-pictures-joint-angles-own = Prüfen, ob die Gelenkwinkel zu diesem Bild gehören.
check-tip-one-arms-file-block = Prüfen, ob die Tastkugel die der Armdatei ist und ob Zinnenkörper und Messarm fest standen; dann das Armmodell.
check-tip-play-faces-dirt-have = Tastkugel auf Spiel und Flächen auf Schmutz prüfen; das Armmodell prüfen lassen.
check-tips-diameter-block-then-arms = Tastkugeldurchmesser prüfen; ebenso, ob dies der Zinnenkörper ist; dann das Armmodell.
compare-blocks-depth-heights-certificate = Tiefe und Höhen des Zinnenkörpers mit dem Kalibrierschein vergleichen.
contact-off-by = { $number } ({ $face }, { $off })
contact-points = Antastpunkte
contacts-agree-blocks-size-tips-diameter = Die Antastpunkte stimmen mit der Größe des Zinnenkörpers und dem Tastkugeldurchmesser überein: { $checked }.
contacts-disagree-others-were-left-out =
    { $left_out ->
        [one] { $left_out } von { $count } Antastpunkten widerspricht den anderen und wurde ausgeschlossen: { $named }.
       *[other] { $left_out } von { $count } Antastpunkten widersprechen den anderen und wurden ausgeschlossen: { $named }.
    }
contacts-fit-block-rms = { $count } Antastpunkte passen zum Zinnenkörper mit { $rms } rms.
contacts-fit-block-rms-up-good = { $count } Antastpunkte passen zum Zinnenkörper mit { $rms } rms; gut ist bis { $good }.
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
contacts-scatter-times-what-arms-encoders = Die Antastpunkte streuen um { $sigma }, das { $arm_excess }-Fache dessen, was die Winkelgeber des Messarms erklären (Grenzwert { $excess }).
corner = Ecke { $column },{ $row }
corners-fix-camera-weakly-condition-number = Die Ecken bestimmen die Kamera nur schwach: Konditionszahl { $condition } (gut unter { $good }, abgelehnt über { $limit }).
edges-corners = Kanten und Ecken
error-in-column = Spalte { $place }
error-in-row = Zeile { $place }
extracting-laser-stripe = Laserlinie wird ausgewertet
face-and-number = { $face } { $number }
faces-agree-to = { $first } und { $second } auf { $opening }
faces-contacts = { $faces } Flächen für { $contacts } Antastpunkte
finding-objects-edges = Kanten des Objekts werden gesucht
have-arms-calibration-checked-hold-compact = Kalibrierung des Messarms prüfen lassen; den Messarm in kompakter Haltung führen.
keep-reflections-out-grooves-matt-spray = Reflexionen in den Nuten vermeiden: Mattierungsspray, kürzere Belichtung.
laser-off-covered-beside-object-too = der Laser ist aus, verdeckt, neben dem Objekt oder zu schwach für diese Belichtung
laser-off-too-weak-does-cross = der Laser ist aus, zu schwach oder kreuzt das Objekt nicht
laser-stripe-shows-points-s =
    { $missing ->
        [crest] die Laserlinie zeigt { $count } Punkte auf den Zinnenoberseiten
       *[floor] die Laserlinie zeigt { $count } Punkte auf den Nutgründen
    }
light-block-evenly-sharp-large-picture = Zinnenkörper gleichmäßig beleuchten und scharf und groß ins Bild bringen.
no-laser-stripe-found-object = auf dem Objekt wurde keine Laserlinie gefunden
no-two-opposite-sides-were-touched = Es wurden keine zwei gegenüberliegenden Seiten angetastet: Tastkugeldurchmesser und Größe des Zinnenkörpers entsprechen ihren Kalibrierscheinen und sind nicht geprüft.
object-certificate = Kalibrierschein des Objekts
one-pose-does-not-show-arm-errors = Fehler des Armmodells selbst, nicht zum Bild gehörende Gelenkwinkel und ein nach dem Antasten bewegtes Objekt lassen sich aus einem Bild in einer Pose nicht erkennen und sind in diesem Wert nicht enthalten.
picture-does-not-show-certificate-not-checked =
    { $detections ->
        [one] Im Bild nicht zu sehen: { $hidden }. Dort ist nicht geprüft, ob der Kalibrierschein stimmt.
       *[other] In den Bildern nicht zu sehen: { $hidden }. Dort ist nicht geprüft, ob der Kalibrierschein stimmt.
    }
picture-has-size =
    { $picture ->
        [laser] das Laserbild hat { $width } × { $height } Pixel
       *[ambient] das Kalibrierbild hat { $width } × { $height } Pixel
    }
picture-objects-certificate-contradict-each-other = Bild und Kalibrierschein des Objekts widersprechen sich
place-sensor-so-stripe-crosses-crests = Sensor so halten, dass die Laserlinie Zinnenoberseiten und Nutgründe kreuzt
point-known-good =
    { $point ->
        [seen] Standardunsicherheit eines im Abstand der Tafel gesehenen Punkts im Flanschsystem: { $total } (k = 1); gut ist bis { $good }.
       *[scanned] Standardunsicherheit eines gescannten Punkts im Flanschsystem: { $total } (k = 1); gut ist bis { $good }.
    }
point-known-mostly-by =
    { $point ->
        [seen] Standardunsicherheit eines im Abstand der Tafel gesehenen Punkts im Flanschsystem: { $total } (k = 1), größter Beitrag: { $source } ({ $value }); der Grenzwert ist { $limit }.
       *[scanned] Standardunsicherheit eines gescannten Punkts im Flanschsystem: { $total } (k = 1), größter Beitrag: { $source } ({ $value }); der Grenzwert ist { $limit }.
    }
points-edges-fit-camera-rms-limit = { $points } Punkte auf { $edges } Kanten passen zur Kamera mit { $rms } rms; der Grenzwert ist { $edge_rms_px }.
points-laser-stripe-lie-object-levels = { $points } Punkte der Laserlinie liegen auf dem Objekt (von { $found } auf seinen Höhenstufen; { $least } sind auf Zinnenoberseiten und auf Nutgründen nötig)
refining-camera-lens-laser-plane = Kamera, Objektiv und Laserebene werden verfeinert
robots-poses = Posen des Roboters
s-stripe-spans-blocks =
    { $level ->
        [crest] Auf den Zinnenoberseiten überdeckt die Laserlinie { $span } von { $width } Breite des Zinnenkörpers.
       *[floor] Auf den Nutgründen überdeckt die Laserlinie { $span } von { $width } Breite des Zinnenkörpers.
    }
sensor-measures-away-arms-last-joint = Der Sensor misst { $away } vom letzten Gelenk des Messarms entfernt (Grenzwert { $farthest_mm }).
set-exposure-stripe-bright-not-clipped = So belichten, dass die Laserlinie hell, aber nicht übersteuert ist.
show-more-block-crests-floors-front = Mehr vom Zinnenkörper ins Bild bringen: Zinnenoberseiten und Nutgründe, vorn und hinten.
size-expected = erwartet werden { $width } × { $height } Pixel
solving-camera = Kamera wird berechnet
stripe-one-level-alone-does-fix = eine Laserlinie auf nur einer Höhenstufe legt die Laserebene nicht fest
stripe-points-fit-one-laser-plane = { $points } Punkte der Laserlinie passen mit { $rms } rms zu einer Laserebene (Grenzwert { $stripe_rms_px }), { $share } der Punkte auf dem Objekt (Grenzwert { $agreeing }).
take-more-poses-tilted-turned-have = Weitere Posen aufnehmen, geneigt und gedreht; das Armmodell neu identifizieren lassen.
take-these-points-again = Diese Punkte neu aufnehmen.
touch-front-back-left-right-face = Vorder- und Rückseite oder linke und rechte Stirnseite antasten.
touch-more-points-on-all-faces = Weitere Punkte antasten, weit über alle sechs Flächen verteilt.
turn-lamp-until-all-edges-block = Lampe drehen, bis alle Kanten des Zinnenkörpers zu sehen sind, und ein weiteres Bild aufnehmen.
usable-edge-stripe-points = { $found } brauchbare Kanten- und Laserpunkte
use-block-better-certificate = Einen Zinnenkörper mit besserem Kalibrierschein verwenden.
use-full-pictures-one-sensor-neither = vollständige Bilder eines einzigen Sensors verwenden, weder beschnitten noch skaliert
word-distortion = Verzeichnung
word-stripe = Laserlinie
working-out-error-budget = Unsicherheitsbudget wird berechnet

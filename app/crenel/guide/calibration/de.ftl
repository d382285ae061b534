abandon-calibration-calibration-use-stays = Diese Kalibrierung abbrechen? Eine Kalibrierung in Gebrauch bleibt unverändert.
accept-calibration = Diese Kalibrierung annehmen
after-advised-pose = { $then } nach der empfohlenen Pose
after-three-points-three-faces = nach drei Punkten auf drei Flächen
all-points-there-go-add =
    { $more ->
        [yes] Alle Punkte sind aufgenommen. Fortfahren oder weitere antasten, wie unten angegeben.
       *[no] Alle Punkte sind aufgenommen. Fortfahren oder weitere antasten.
    }
all-points-there-go-pictures = Alle Punkte sind aufgenommen. Weiter zu den Bildern.
all-there-calibrate = Alles, was sie braucht, ist da.
arm-chosen-cannot-read-any-more = Die Datei des gewählten Messarms ist nicht mehr lesbar
arm-object-chosen-cannot-read-any = Die Datei des gewählten Messarms oder Objekts ist nicht mehr lesbar.
arm-tip = Messarm und Tastkugel
back-face = Rückseite
back-points = Zurück zu den Punkten
before-poses-were-changed-since = Nicht mehr aktuell: Die Posen wurden geändert.
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
block-known-by-drawing = Der Block ist nur durch seine Zeichnung bekannt. Vermessen ist er besser bekannt.
board-printed-side = Tafel (bedruckte Seite)
both-devices-answer-go = Beide Geräte antworten. Fortfahren.
but-what-marked-below-needs-attention = Das unten Markierte ist aber zu beachten.
calibrate-camera-mounting-and-laser = Kamera, Anbau und Laser kalibrieren
calibrate-without-the-laser = Ohne Laser kalibrieren
calibrating = Kalibrierung läuft
calibration-cannot-shown = die Kalibrierung { $session_id } lässt sich nicht anzeigen
calibration-closed-start-new-one = Diese Kalibrierung ist abgeschlossen. Eine neue starten.
calibration-computed = Die Kalibrierung ist berechnet.
calibration-not-kept-any-more = die Kalibrierung in Gebrauch ist für diese Geräte keine mehr, die nur Kamera und Anbau hat
calibration-not-to-be-used-findings-say-what = Diese Kalibrierung sollte nicht verwendet werden. Die Befunde nennen die Abhilfe.
calibration-use = Die Kalibrierung wird verwendet
calibration-utc = Kalibrierung { $now } UTC
camera-and-mounting-are-stored = Kamera und Anbau sind in Gebrauch und liegen im Archiv. Zum Scannen den Laser hinzufügen: Bilder aufnehmen, in denen seine Linie über die Tafel verläuft.
cancel-calibration = Kalibrierung abbrechen
capture = Aufnehmen
certify-the-block = Block vermessen
charuco-squares-mm-markers = ChArUco-Tafel, { $columns } × { $rows } Felder zu { $square }, { $dictionary }
check-arm-tip-object-sensor-those = Prüfen, ob Messarm, Tastkugel, Objekt und Sensor die verwendeten sind.
check-devices = Geräte prüfen
check-laser-exposure-then-take-new = Laser und Belichtung prüfen, dann ein neues Bild aufnehmen.
chessboard-inner-corners-squares-mm = Schachbrett, { $columns } × { $rows } innere Ecken, Felder von { $square }
chessboard-seen-several-sides-take-more = Ein Schachbrett muss von mehreren Seiten zu sehen sein: noch { $more } Bilder aufnehmen.
chessboard-seen-several-sides-take-one = Ein Schachbrett muss von mehreren Seiten zu sehen sein: noch ein Bild aufnehmen.
choice-needs-field-id = Eine Auswahl braucht ein Feld und eine Kennung.
choose-chessboard-for-poses = { $name } meldet Posen: Wählen Sie ein Schachbrett als Objekt.
choose-datasheet-connect-other = Datenblatt dieses Geräts ({ $name }) wählen oder das andere Gerät anschließen.
choose-first = Zuerst wählen: { $things }.
choose-of-several = { $count } zur Wahl
choose-what-use = Ausrüstung wählen
comes-last = Sie kommt, wenn der Rest da ist.
compute-again = Neu berechnen
compute-calibration-take-another-pose = { $taken } Kalibrierung berechnen oder eine weitere Pose aufnehmen.
connect-the-arm = Arm verbinden
connect-the-sensor = Sensor verbinden
connected-arm-reports-joints-choose = Der angeschlossene Arm meldet Gelenkwinkel, { $name } aber Posen. Wählen Sie den angeschlossenen Arm.
connected-arm-reports-poses-choose = Der angeschlossene Arm meldet Posen, { $name } aber hat Gelenke. Wählen Sie den angeschlossenen Arm.
connected-has-serial-number-chosen-datasheet = Das angeschlossene Gerät ({ $name }) hat die Seriennummer { $serial_number }, das gewählte Datenblatt gilt für { $serial_number2 }.
connected-sensor = Angeschlossener Sensor
connected-sensors-picture-has-pixels-choose = Das Bild des angeschlossenen Sensors hat { $width_px } × { $height_px } Pixel, das von { $name } { $size } × { $size2 }. Den angeschlossenen Sensor wählen.
contact-limit = zwei Punkte des Objekts liegen höchstens { $limit } auseinander
contact-too-far = Dieser Punkt liegt { $apart } von Punkt { $number } entfernt, weiter als das Objekt reicht; er wurde nicht übernommen
continue = Weiter
corners-object-found = { $corners_detected } Ecken des Objekts gefunden.
crests-top = Zinnen oben
end-pictures-by-themselves = Die Bilder beenden
enter-the-arm = Arm eingeben
enter-the-sensor = Sensor eingeben
enter-the-target = Zinnenkörper oder Tafel eingeben
face-has-points-go = Diese Fläche hat genügend Punkte. Weiter mit: { $face }.
fault = Ursache: { CAPITAL($fault) }. { $text }
figures-before = { $text }: Die Werte sind nicht mehr aktuell.
files-no-longer-in-data-folder = ihre Dateien sind nicht mehr im Datenordner
floors-grooves = Nutgründe
front-face = Vorderseite
go-back-take-picture-points-again = Zurückgehen und das Bild oder die Punkte neu aufnehmen.
go-pictures-touches-spread-over-printed = Weiter zu den Bildern. Mit { $wanted } über die bedruckte Seite verteilten Antastpunkten ließe sich die Größe der Felder prüfen.
go-pose-count-one-other-s =
    { $count ->
        [one] Weiter mit { $count } Pose
       *[other] Weiter mit { $count } Posen
    }
hands-point-face-declined-times = Punkt { $index } des simulierten Bedieners { $where } wurde { $attempts }-mal abgelehnt
hold = Halten
hold-arm-still = Messarm ruhig halten. { $text }.
hold-sensor-over-object = Sensor über das Objekt halten
hold-sensor-over-object-another-way = Sensor anders als bisher über das Objekt halten.
hold-sensor-over-object-so-lies = Sensor so über das Objekt halten, dass es etwa mit dem gestrichelten Umriss übereinstimmt.
hold-sensor-straight-above-chessboard-longer = Sensor senkrecht über das Schachbrett halten, dessen längere Seite parallel zur Längsseite des Bildes.
hold-still-take-picture-laser-switches = Ruhig halten und das Bild aufnehmen. Der Laser schaltet automatisch.
hold-there = So halten
in-use-named = { $name } wird jetzt verwendet.
laser-beside-object-may-too-dark = Der Laser ist an; neben der Linie ist das Objekt für die Erkennung vielleicht zu dunkel.
laser-did-not-switch-on = Der Laser hat sich nicht eingeschaltet: Dieses Bild bestimmt nur Kamera und Lage des Sensors.
lasers-line-must-cross-chessboard = Die Laserlinie muss in mindestens { $fewest } Bildern über das Schachbrett verlaufen, besser in jedem.
left-end = Linke Stirnseite
left-out = Ausgeschlossen: { $reason }
line-widths-do-not-ascend = die Höchstbreite muss die Mindestbreite übersteigen
look-for-line-again = Linie erneut suchen
look-numbers-then-accept-calibration-repeat = Werte ansehen, dann die Kalibrierung annehmen oder wiederholen.
looking-object-picture = Objekt wird im Bild gesucht
looks-for-line-again = Linie wird erneut gesucht
more-poses-would-bring-little = Weitere Posen bringen kaum Verbesserung.
move-tip-another-place = Tastkugel an eine andere Stelle führen
movement-tip = Bewegung der Tastkugel
need-arm-model = Modell des Arms
need-certificate = Kalibrierschein des Blocks
need-first-calibration = Erste Kalibrierung
need-sensor-datasheet = Datenblatt des Sensors
need-target = Zinnenkörper oder Tafel
next = Weiter: { $title }.
next-pose-follow-dashed-outline = Für die nächste Pose: { $words }. Dem gestrichelten Umriss folgen.
no-arm-model-yet = Wie der Arm gebaut ist, ist noch nicht bekannt. Seine Gelenke eingeben (D-H-Tabelle), oder dass er ein Roboter ist, der Posen meldet.
no-board-yet = Ein Roboter, der Posen meldet, wird mit einer Tafel kalibriert. Noch ist keine bekannt.
no-datasheet-fits-sensor = Keiner der eingegebenen Sensoren ist der verbundene. Auch ihn eingeben.
no-laser-stripe-picture = Im Bild ist keine Laserlinie.
no-laser-stripe-picture-serves-camera = Im Bild ist keine Laserlinie: Es bestimmt nur Kamera und Lage des Sensors.
no-model-fits-connected-arm = Keiner der eingegebenen Arme ist der verbundene. Auch ihn eingeben.
no-picture-shows-object-yet-take = Noch kein Bild zeigt das Objekt. Ein weiteres aufnehmen.
no-pictures-by-themselves = es werden keine Bilder von selbst aufgenommen
no-point-taken-back-since-last = Seit dem letzten Punkt wurde keiner zurückgenommen.
no-point-taken-yet = Noch kein Punkt aufgenommen.
no-sensor-datasheet-yet = Die Pixel des Sensors und die Richtung seiner Linie sind noch nicht bekannt. Danach wird gefragt, sobald er angeschlossen ist.
no-target-yet = Noch ist kein Zinnenkörper und keine Tafel bekannt.
not-computed-data-kept = Die Berechnung war nicht möglich. Alles Aufgenommene bleibt erhalten.
not-to-be-used-findings-say-why = Sie sollte nicht verwendet werden: Die Befunde nennen den Grund.
not-usable = Nicht brauchbar
not-usable-because = Nicht brauchbar: { $fault }
nothing-changed-since-solved = Seit der Berechnung hat sich nichts geändert.
object-picture = Das Objekt ist im Bild
object-picture-hold-arm-there-clamp = Das Objekt ist im Bild. Messarm dort halten oder festklemmen.
objects-place-k-1 = Lage des Objekts (k = 1)
on-board = auf der Tafel
only-pose-take-another-first = Dies ist die einzige Pose. Zuerst eine weitere aufnehmen.
picture-cannot-be-used-take-it-again =
    { $others ->
        [yes] Dieses Bild ist nicht brauchbar. Neu aufnehmen oder ohne dieses Bild fortfahren.
       *[no] Dieses Bild ist nicht brauchbar. Neu aufnehmen.
    }
picture-of-pixels = { $width_px } × { $height_px } Pixel
picture-whenever-robot-rests = Bei jedem Halt des Roboters ein Bild
pictures-by-themselves = Bilder von selbst
pictures-by-themselves-only-for-robot-and-board = von selbst werden Bilder nur von einer Tafel aufgenommen, und mit einem Roboter ohne Tastkugel
pictures-were-taken-with-other-sensor = Es wurden Bilder mit einem anderen Sensor aufgenommen. Für diesen eine neue Kalibrierung beginnen.
plane-needs-lines-in-some = Für diese Pose genügt das. In mindestens { $fewest } anderen Bildern muss die Laserlinie über die Tafel verlaufen.
point-again = Das ist erneut Punkt { $point }
point-back = Punkt { $index } ist wiederhergestellt.
point-beside-face = Punkt { $index } liegt neben der Fläche „{ $face }“: Dort hat er nichts berührt.
point-cannot-true = Punkt { $index } ist unplausibel: { $what }; { $why }.
point-lies-on-other-face = Punkt { $index } verfehlt die Fläche „{ $face }“ um { $off } und liegt { $where }.
point-misses-face = Punkt { $index } verfehlt die Fläche „{ $face }“ um { $off }.
point-no-longer-there = Diesen Punkt gibt es nicht mehr.
point-of-face = { $face }, Punkt { $index }
point-off-face = Punkt { $index } liegt { $off } neben der Fläche „{ $face }“; die übrigen stimmen auf { $rms } überein.
point-off-face-remove-then-go = Punkt { $point } liegt nicht auf seiner Fläche. Punkt entfernen, dann fortfahren.
point-off-others = Punkt { $index } liegt { $off } neben der Ebene der anderen Punkte { $where }.
point-off-plane-others = Punkt { $index } liegt { $off } neben der Ebene der übrigen.
point-removed = Punkt { $index } ist entfernt.
point-taken-for = Punkt { $index }, gemeint { $where }; noch nicht beurteilt.
point-taken-off = Punkt { $index } { $where }: { $off }.
points-here-welcome-beside-those-other = { $place } Punkte hier sind hilfreich, zusätzlich zu denen auf den anderen Flächen.
pose-count-one-other-s-taken =
    { $count ->
        [one] { $count } Pose ist aufgenommen.
       *[other] { $count } Posen sind aufgenommen.
    }
pose-excluded = Pose { $n } ist ausgeschlossen
pose-is-set-aside = Ausgeschlossen
pose-no-longer-there = Diese Pose gibt es nicht mehr.
pose-not-set-aside = Diese Pose ist nicht ausgeschlossen.
pose-taken = Pose { $number } ist aufgenommen.
pose-taken-back = Pose { $n } ist wieder einbezogen
pose-would-help-most-scanned-point = Die wirksamste Pose: { $words }. Unsicherheit eines gescannten Punkts: { $now } → { $then } (k = 1).
poses-enough = { $done } Posen reichen aus
poses-were-changed-solve-again-undo = Die Posen wurden geändert. Neu berechnen oder die Änderung zurücknehmen.
put-point-back = Punkt { $i } wiederherstellen
remove-point-first-not-there = Zuerst Punkt { $index } entfernen: Er liegt nicht { $where }.
remove-then-touch-face-marked-drawing = Entfernen, dann die in der Zeichnung markierte Fläche antasten.
remove-touch-there-again = Entfernen und dort neu antasten.
remove-touch-there-again-rest-clear = Entfernen und dort neu antasten, in Ruhe und mit Abstand zur Kante.
repeat-first-point = Ab dem ersten Punkt wiederholen
repeat-start = Von vorn wiederholen
reports-poses-no-tip = meldet Posen, keine Tastkugel
restore-sessions-folder-backup = Ordner der Sitzung aus einer Sicherung wiederherstellen
review = Beurteilen
review-calibration = Kalibrierung beurteilen
right-end = Rechte Stirnseite
scan-running-has-laser-stop-first = Ein Scan läuft und verwendet den Laser. Zuerst den Scan stoppen.
second = { $text }, { $rate } je Sekunde
sensor = Der Sensor: { $text }
serial-number-charuco-squares-markers = { $serial_number }: ChArUco-Tafel, { $columns } × { $rows } Felder zu { $square }, { $dictionary }
serial-number-chessboard-inner-corners-squares = Seriennummer { $serial_number }, Schachbrett, { $columns } × { $rows } innere Ecken, Felder von { $square }
serial-number-joints-tip = Seriennummer { $serial_number }, { $joint_count } Gelenke, Tastkugel Ø { $diameter }
serial-number-merlons = Seriennummer { $serial_number }, { $merlon_count } Zinnen, { $size } × { $size2 } × { $size3 }
serial-number-pixels = Seriennummer { $serial_number }, { $width_px } × { $height_px } Pixel
serial-number-poses-no-tip = Seriennummer { $serial_number }, meldet Posen, keine Tastkugel
serial-number-poses-tip = Seriennummer { $serial_number }, meldet Posen, Tastkugel Ø { $diameter }
set-aside = Ausschließen
set-calibration-aside-start-again-beginning = Diese Kalibrierung beiseitelegen und von vorn beginnen?
set-up = Einrichten
simulation-goes-next-pose = Der simulierte Bediener führt den Sensor zur nächsten Pose: { $words }
simulation-holds-sensor-over-object = Der simulierte Bediener hält den Sensor über das Objekt
simulation-holds-still = Der simulierte Bediener hält den Messarm ruhig
simulation-touches = Der simulierte Bediener tastet an: { $face }
solve-again = Neu berechnen.
some-points-off-their-face-remove = Einige Punkte liegen nicht auf ihrer Fläche. Diese entfernen, dann fortfahren.
something-changed-since-solved-solve-again = Seit der Berechnung hat sich etwas geändert. Neu berechnen.
spread-points-hold-still-press-arms = { $place } { $wanted } Punkte verteilt aufnehmen: an jedem ruhig halten und die Taste am Messarm drücken.
spread-them-wide-clear-edges = Weit verteilen, mit Abstand zu den Kanten.
start-new-calibration = Neue Kalibrierung starten
still-turn = Noch zu drehen
stored-under-records-scan-or-calibrate-again = Sie ist in Gebrauch und liegt im Archiv. Die erste Schaltfläche ist der nächste Schritt; auch scannen lässt sich mit ihr sofort.
straight-above-chessboard-follow-dashed-outline = Senkrecht über dem Schachbrett beginnen: { $words }. Dem gestrichelten Umriss folgen.
switch-arm-sensor-connect-them = Messarm und Sensor einschalten und anschließen.
switch-laser-look-where-lies = Laser einschalten, um zu sehen, wo die Linie liegt.
switch-off-aim-picture-switched-itself = Zum Ausrichten ausschalten. Für das Bild schaltet er automatisch.
take-another = { $taken } Eine weitere aufnehmen: { $words }.
take-another-pose = Weitere Pose aufnehmen
take-back = Einbeziehen
take-picture = Bild aufnehmen
take-picture-again = Dieses Bild neu aufnehmen
taking-picture = Bild wird aufgenommen
there-no-earlier-step = Einen früheren Schritt „{ $to }“ gibt es nicht.
there-no-face = Die Fläche „{ $face }“ gibt es nicht.
there-no-here =
    { $field ->
        [arm] Den Messarm „{ $chosen }“ gibt es hier nicht.
        [object] Das Objekt „{ $chosen }“ gibt es hier nicht.
       *[sensor] Den Sensor „{ $chosen }“ gibt es hier nicht.
    }
there-no-picture-object-sensor-take = Es gibt noch kein Bild dieses Objekts mit diesem Sensor. Eines aufnehmen.
there-no-picture-yet-take-one = Es gibt noch kein Bild. Eines aufnehmen.
these-use = Diese verwenden
these-use-and-pictures = Diese verwenden, dann bei jedem Halt ein Bild
tip-is-checked-in-a-seat = Um seine Spitze in einem Sitz gedreht, zeigt der Arm, ob die Spitze da ist, wo sein Modell sie hat.
tip-lies-within-mm = die Tastkugel liegt weniger als { $distance } davon entfernt
to-calibration = Behält Kamera und Anbau von { $name }. Die Tafel darf anders liegen.
touch-back-face = Rückseite antasten.
touch-floors-grooves = Nutgründe antasten.
touch-front-face = Vorderseite antasten.
touch-heading = Antasten
touch-left-end = Linke Stirnseite antasten.
touch-object = Objekt antasten
touch-object-or-remove-wrong = Das Objekt antasten, oder Punkt { $number } entfernen, wenn der falsch ist
touch-printed-side-more-times-spread = Die bedruckte Seite noch { $left }-mal antasten, weit verteilt. Oder fortfahren.
touch-printed-side-once-more-far = Die bedruckte Seite noch einmal antasten, weit weg von den anderen Punkten. Oder fortfahren.
touch-right-end = Rechte Stirnseite antasten.
touch-tops-merlons = Zinnenoberseiten antasten.
touches-over-all-faces = { $total } weitere auf allen Flächen, davon { $most } { $where },
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
uncertainty-scanned-point-k-1 = Unsicherheit eines gescannten Punkts (k = 1)
uncertainty-scanned-point-so-far-k = Bisherige Unsicherheit eines gescannten Punkts (k = 1)
uncertainty-seen-point-k-1 = Unsicherheit eines gesehenen Punkts (k = 1)
undo-last-point = Letzten Punkt zurücknehmen
up-poses = { $done } von bis zu { $of } Posen
usable-most = { $total }; der Grenzwert für „brauchbar“ ist { $usable }.
used-but = Verwendet, aber { $reason }
waits-for-new-rest = Wartet, bis der Roboter in einer neuen Pose ruht und die Tafel im Bild ist
wanted-points-fit = Soll: { $target }; Punkte passen auf { $rms }
what-is-calibrated = Was kalibriert wird
working-out-which-pose-would-help = Wirksamste Pose wird berechnet

channel-beyond-others = { $colour } über die anderen Kanäle hinaus
channel-less-laser-off = { $channel }, abzüglich des Bildes ohne Laser
channel-mean-of-all = Mittel aller Kanäle
dark-brightest-pixel = es ist dunkel: Das hellste Pixel hat { $brightest } von { $full } Graustufen
draw-pictures-of-each-folder-apart = Die Bilder jedes Ordners für sich zeichnen
give-axis = --axis { $axis } angeben
give-each-pose-its-own-picture = Jeder Zeile von images.csv ein eigenes Bild geben
give-times-in-seconds-readings-closer = Alle Zeiten in Sekunden angeben, und Messwerte des Messarms im Abstand von höchstens { $longest }
import-with-stripe-axis = stripe_axis in sensor.json auf { $axis } setzen und erneut einlesen
laser-on-or-expose-longer = Laser einschalten oder länger belichten
line-along-other-axis =
    { $axis ->
        [u] eine Linie mit { $points } Punkten verläuft von oben nach unten
       *[v] eine Linie mit { $points } Punkten verläuft quer
    }
line-as-bright-as-clutter = keine Linie: anderes in ihren Spalten ist ebenso hell
line-as-bright-as-picture = keine Linie: das Bild ist ebenso hell
line-bright-in-the-dark = Linie: sie ist hell im Dunkeln
line-crosses-most-of-picture = Linie: sie durchquert das Bild fast ganz
line-hardly-rivalled = Linie: sonst ist kaum etwas im Bild
line-in-nearly-all-columns = Linie: sie ist in fast allen Spalten
line-outshines-picture = Linie: sie überstrahlt das Bild
line-stands-alone = Linie: sie steht nahezu allein
line-without-points = keine Linie: keine Spitzen setzen sich von Spalte zu Spalte fort
no-bright-line-runs =
    { $axis ->
        [u] keine helle Linie verläuft quer durch das Bild
       *[v] keine helle Linie verläuft von oben nach unten durch das Bild
    }
no-picture-between-readings = kein Bild von { $path } liegt zwischen zwei Messwerten von { $readings }, die dicht beieinander liegen
no-picture-of-folder-can-be-used = keines der { $count } Bilder ist verwendbar; das erste: { $first }
no-picture-of-folder-has-a-line = keines der { $count } Bilder zeigt eine Linie; das erste: { $first }
overexposed-share-at-full-scale = es ist überbelichtet: { $share } seiner Pixel sind in der Sättigung
piece-left-beneath-line = verworfen: geht unter der Linie weiter
piece-left-dim-as-clutter = verworfen: so dunkel wie das Übrige
piece-left-without-line = verworfen: keine Linie im Bild
piece-taken-brighter-than-clutter = genommen: heller als das Übrige
piece-taken-line-goes-on = genommen: die Linie geht darin weiter
piece-taken-most-light = genommen: das meiste Licht
readings-are-apart-nothing-between = die Messwerte liegen im Mittel { $period } auseinander; über mehr als { $longest } wird nicht interpoliert
same-picture-as-before = { $name } ist noch einmal das Bild davor
shorten-exposure-or-darken-room = Kürzer belichten oder die Umgebung abdunkeln
shows-no-stripe = { $path } zeigt keine Laserlinie
shows-no-stripe-outside-mask = { $path } zeigt außerhalb der Maske keine Laserlinie
take-with-laser-or-describe-line = Mit eingeschaltetem Laser und passender Belichtung aufnehmen oder angeben, wie die Linie aussieht (--threshold, --min-width, --max-width): Anderes im Bild hebt sich ebenso ab
two-lines-in-pictures = in { $two } von { $of } Bildern sind zwei Laserlinien, und die Punkte können zwischen ihnen springen. Einen Laser abschalten, ihn maskieren (--mask) oder in jeder Spalte einen von beiden nehmen (--choice first oder last)
two-pictures-named = zwei Bilder heißen { $name } und wären eine Datei in { $folder }

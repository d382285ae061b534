arms-zero = Abstand vom Nullpunkt des Messarms
axis-component = Achse { $axis }
axis-level = Achse gegen die Waagerechte
cannot-be-displayed = { $name } lässt sich nicht anzeigen.
cannot-shown = { $name } lässt sich nicht anzeigen: { $error }
centre = Mittelpunkt { $axis }
change-one-them = eine von beiden ändern
deviations-distances-one = Abweichungen sind Abstände von einer Form
diameter = Durchmesser
draw-over-part-cloud = das Rechteck über einen Teil der Punktwolke ziehen
fit-plane-sphere-cylinder-first = zuerst eine Ebene, eine Kugel oder einen Zylinder einpassen
fitting =
    { $shape ->
        [plane] Ebene wird eingepasst
        [sphere] Kugel wird eingepasst
       *[cylinder] Zylinder wird eingepasst
    }
grey-levels = Graustufen
lower-limit-not-below-upper = Die untere Grenze liegt nicht unter der oberen
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
normal-component = Normale { $axis }
there-no-fitted-shape-yet = Es ist noch keine Form eingepasst
there-no-points-rectangle = Im Rechteck sind keine Punkte
tilt-level = Neigung gegen die Waagerechte
view-3d-not-connected = Die 3D-Ansicht dieser Seite ist nicht verbunden
wait-moment-load-page-again = kurz warten oder die Seite neu laden
wait-until-done = warten, bis der Vorgang fertig ist

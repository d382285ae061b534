axis-component = Achse { $axis }
cannot-be-displayed = { $name } lässt sich nicht anzeigen.
cannot-shown = { $name } lässt sich nicht anzeigen: { $error }
centre = Mittelpunkt { $axis }
change-one-them = eine von beiden ändern
deviations-distances-one = Abweichungen sind Abstände von einer Form
draw-over-part-cloud = das Rechteck über einen Teil der Punktwolke ziehen
element-figure =
    { $figure ->
        [origin] Abstand vom Nullpunkt des Messarms
        [tilt] Neigung gegen die Waagerechte
        [level] Achse gegen die Waagerechte
        [cone-angle] Kegelwinkel
        [planes-distance] Abstand der Ebenen
        [planes-angle] Winkel der Ebenen
        [axes-distance] Abstand der Achsen
        [axes-angle] Winkel der Achsen
        [axes-nearest] Kleinster Abstand der Achsen
        [axis-plane-angle] Winkel der Achse zur Ebene
        [axis-plane-distance] Abstand der Achse von der Ebene
        [centres-distance] Abstand der Mittelpunkte
        [centre-plane-distance] Abstand des Mittelpunkts von der Ebene
        [centre-axis-distance] Abstand des Mittelpunkts von der Achse
       *[diameter] Durchmesser
    }
fit-shape-first = zuerst eine Form einpassen
fitting =
    { $shape ->
        [any] Form wird gesucht
        [plane] Ebene wird eingepasst
        [sphere] Kugel wird eingepasst
        [cone] Kegel wird eingepasst
        [relation] Zwischen zwei Formen wird gemessen
       *[cylinder] Zylinder wird eingepasst
    }
grey-levels = Graustufen
lower-limit-not-below-upper = Die untere Grenze liegt nicht unter der oberen
no-fitted =
    { $shape ->
        [any] Keine Form eingepasst: { $error }
        [plane] Keine Ebene eingepasst: { $error }
        [sphere] Keine Kugel eingepasst: { $error }
        [cone] Kein Kegel eingepasst: { $error }
        [relation] Zwischen den Formen wurde nichts gemessen: { $error }
       *[cylinder] Kein Zylinder eingepasst: { $error }
    }
no-fitted-program-failed =
    { $shape ->
        [any] Keine Form eingepasst: Ein Programmfehler ist aufgetreten.
        [plane] Keine Ebene eingepasst: Ein Programmfehler ist aufgetreten.
        [sphere] Keine Kugel eingepasst: Ein Programmfehler ist aufgetreten.
        [cone] Kein Kegel eingepasst: Ein Programmfehler ist aufgetreten.
        [relation] Zwischen den Formen wurde nichts gemessen: Ein Programmfehler ist aufgetreten.
       *[cylinder] Kein Zylinder eingepasst: Ein Programmfehler ist aufgetreten.
    }
normal-component = Normale { $axis }
there-no-fitted-shape-yet = Es ist noch keine Form eingepasst
there-no-points-rectangle = Im Rechteck sind keine Punkte
uncertainty-source =
    { $source ->
        [calibration] Kalibrierung des Sensors
        [arm] Glieder des Messarms
        [encoders] Stellungen des Messarms
        [stripe] Laserlinie
       *[form] Form und Erschütterung
    }
view-3d-not-connected = Die 3D-Ansicht dieser Seite ist nicht verbunden
view-choose-two-elements = zwei Formen auswählen
view-cloud-is-merged = Die Wolke ist aus mehreren Scans zusammengeführt, von denen jeder seine eigenen Stellungen hat: im Scan selbst messen.
view-element-gone = eine davon wurde entfernt
view-scan-not-complete = Der Scan ist nicht vollständig: Bisher wird nur an den Punkten des Bildes gemessen.
wait-moment-load-page-again = kurz warten oder die Seite neu laden
wait-until-done = warten, bis der Vorgang fertig ist

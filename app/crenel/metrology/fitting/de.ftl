centre-radius-cannot-be-separated = Mittelpunkt und Radius lassen sich nicht trennen
cloud-holds-usable-points =
    { $points ->
        [one] die Punktwolke enthält { $points } brauchbaren Punkt
       *[other] die Punktwolke enthält { $points } brauchbare Punkte
    }
needs-least =
    { $shape ->
        [plane] eine Ebene braucht mindestens { $least }
        [sphere] eine Kugel braucht mindestens { $least }
        [cylinder] ein Zylinder braucht mindestens { $least }
       *[other] mindestens { $least } sind nötig
    }
others-cannot-tell-which = die übrigen zeigen nicht, welcher
pick-more-way-round-fit-plane = Mehr vom Umfang auswählen oder eine Ebene einpassen
points-fix-no-cylinder = die Punkte legen keinen Zylinder fest
points-lie-one-plane = die Punkte liegen in einer Ebene
points-lie-too-small-piece = die Punkte liegen auf einem zu kleinen Ausschnitt
points-lie-too-small-piece-sphere = die Punkte liegen auf einem zu kleinen Ausschnitt einer Kugel oder gehören zu einer anderen Form
scan-more-sphere = Mehr von der Kugel scannen
surface-not-curved = die Fläche ist nicht gekrümmt
they-fix-no-sphere = sie legen keine Kugel fest

bar-not-placed = der Kugelstab wurde in { $count } von { $needed } Lagen gemessen
master-sphere-not-measured = die Meisterkugel wird { $count }-mal mit je { $points } Punkten gemessen
other-bar-measured = Lage { $placement } ergab eine Länge von { $measured }, die nächste Länge des Kalibrierscheins ist { $certified }: Es ist ein anderer Kugelstab, oder eine Länge oder ein Durchmesser ist falsch eingetragen
other-sphere-measured = die angetastete Kugel hat einen Durchmesser, der um { $off } vom Kalibrierschein abweicht: Es ist eine andere Kugel, oder ein Durchmesser ist falsch eingetragen
performance-arm-not-turned-enough = Der Arm steht wie bei einer früheren Antastung in dieser Pfanne: Er drehte sich um { $turned }, nötig sind { $least }. Diese Antastung wurde nicht übernommen
performance-articulate-arm = Den Ellbogen bewegen oder das Handgelenk drehen und noch einmal antasten
performance-clamp-seat =
    { $number ->
        [1] Die Pfanne nahe der Schulter festklemmen, bei höchstens einem Fünftel der Reichweite.
        [2] Die Pfanne etwa bei halber Reichweite festklemmen.
       *[other] Die Pfanne bei vier Fünfteln der Reichweite oder weiter festklemmen.
    }
performance-contact-title =
    { $step ->
        [diameter] Kugel, Messung { $number }
        [seats] { $number ->
            [1] Nahe Pfanne
            [2] Mittlere Pfanne
           *[other] Ferne Pfanne
        }
       *[bar] Lage { $number }
    }
performance-diameter-error = Abweichung des Durchmessers { $error }
performance-left-out =
    { $which ->
        [sphere] Ohne Meisterkugel: Der wirksame Durchmesser wurde ausgelassen.
       *[bar] Ohne Kugelstab: Die räumlichen Längen wurden ausgelassen.
    }
performance-move-seat = Die Pfanne zuerst an ihrer nächsten Stelle festklemmen
performance-place-bar = Den Stab wie in Lage { $number } gezeichnet aufstellen ({ $words }) und festklemmen.
performance-placement =
    { $lies ->
        [away] waagerecht, vom Arm weg
        [across] waagerecht, quer
        [up] senkrecht
        [rising-away] vom Arm weg ansteigend
        [rising-left] nach links ansteigend
        [rising-away-left] vom Arm weg nach links ansteigend
       *[rising-away-right] vom Arm weg nach rechts ansteigend
    }, { $at ->
        [near] nah
        [far] fern
       *[middle] in mittlerer Entfernung
    }, { $side ->
        [left] { $bearing }° links
        [right] { $bearing }° rechts
       *[ahead] geradeaus
    }
performance-seat-has-no-certificate = Die Pfannen haben kein kalibriertes Maß, daher ist die Prüfwertunsicherheit der Einzelpunkt-Schwenkprüfung 0: Spiel und Bewegung einer Pfanne zählen wie Abweichungen des Arms.
performance-seat-largest = größter Abstand { $largest }
performance-seat-not-another = Die Tastkugel ist nur { $away } von einer früheren Pfanne entfernt; diese Antastung wurde nicht übernommen
performance-seat-not-far = Die ferne Pfanne steht bei { $share } % der Reichweite; die Norm verlangt mindestens { $least } %.
performance-seat-not-near = Die nahe Pfanne steht bei { $share } % der Reichweite; die Norm verlangt höchstens { $most } %.
performance-seat-share = bei { $share } % der Reichweite
performance-simulation-contacts = Der simulierte Bediener tastet an: { $done } von { $of }
performance-step-bar = Kugelstab
performance-step-diameter = Meisterkugel
performance-step-seats = Drei Pfannen
performance-touch-bar = Die { $end ->
        [1] erste
       *[other] zweite
    } Kugel des Stabs an { $touches } Stellen rundum antasten.
performance-touch-master = Die Kugel ganz oben und an acht Stellen rundum antasten: Messung { $number } von { $of }.
performance-touch-off-seat = Die Tastkugel ist { $off } von den Antastungen davor entfernt: Sie sitzt nicht in der Pfanne. Diese Antastung wurde nicht übernommen
performance-touch-same-seat = Die Tastkugel in die Pfanne setzen oder den Punkt davor entfernen, falls er der falsche ist
performance-touch-seat = Die Tastkugel in die Pfanne setzen und { $count } Antastpunkte aufnehmen. Dazwischen den Ellbogen bewegen und das Handgelenk drehen, zu beiden Seiten.
seats-not-measured = { $count } Pfannen mit je { $points } Punkten sind nötig

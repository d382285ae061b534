length-standard-rocks =
    { $of ->
        [places] das Normal wackelt in Lage { $place }: Wiederholungen einer Länge streuen um { $scatter }, in ruhigen Lagen um höchstens { $expected }
       *[touches] das Normal wackelt in Lage { $place }: Wiederholungen einer Länge streuen um { $scatter }, Antastungen um { $expected }
    }
lengths-are-missing = nur { $count } von { $wanted } Längen wurden gemessen: jede an { $places } Orten, { $repeats }-mal
no-lengths-measured = keine Länge wurde gemessen
performance-bar-run = Lage { $place }, Scan { $repeat } des Stabs
performance-bar-scan = Scan { $repeat }
performance-bar-scan-done = Scan { $repeat } des Stabs in Lage { $place } ist übernommen.
performance-bar-scan-name = Leistungsprüfung, Lage { $place }, Scan { $repeat }
performance-bar-scan-of-length = Scan { $repeat }, die Kugeln von { $length }
performance-bar-was-moved = Der Stab wurde seither in einer anderen Lage angetastet: Die Scans der Lage davor gelten.
performance-fewer-lengths =
    { $count ->
        [one] das Normal hat nur eine Länge, und das Verfahren verlangt fünf
       *[other] das Normal hat nur { $count } Längen, und das Verfahren verlangt fünf
    }
performance-length-gate = Zählbereich der Scans: { $shell } um die kalibrierten Kugeln, Einfallswinkel bis { $incidence }, mehr als { $cone } von der Richtung des Stabs; alle Punkte darin zählen.
performance-lengths-and-scans = { $done } von { $of } Längen angetastet, { $scanned } von { $scans } Scans
performance-lengths-done = Alle Längen sind gemessen. Weiter zum Ergebnis.
performance-lengths-measured = { $done } von { $of } Längen
performance-measuring-bar-scan = Der Scan des Stabs wird ausgewertet: { $scan }
performance-nothing-decided-standard-rocks = Mit Längen eines wackelnden Normals lässt sich nichts entscheiden. Das Normal befestigen und die Prüfung wiederholen.
performance-off-direction = Das Normal liegt { $angle } neben der gezeichneten Richtung.
performance-pass-over-spheres = Die Laserlinie langsam über jede Kugel des Stabs führen, von Seiten quer zum Stab, dann den Scan beenden.
performance-place =
    { $number ->
        [1] waagerecht, vom Arm weg
        [2] waagerecht, quer, nah links
        [3] waagerecht, quer, fern rechts
        [4] senkrecht
        [5] 45° geneigt, quer, links
        [6] 45° geneigt, vom Arm weg, rechts
       *[other] Raumdiagonale
    }
performance-place-title = Lage { $number } von 7
performance-scan-bar = Das Normal so liegen lassen und den ganzen Stab scannen, { $repeat } von { $of }: alle seine Kugeln, von Seiten quer zum Stab.
performance-scan-bar-again = Den Stab noch einmal scannen, langsam über jede Kugel
performance-scan-length-alone = Zwei Paare von Kugeln haben den Abstand { $length }. Das Normal so liegen lassen und nur die beiden Kugeln dieser Länge scannen.
performance-set-standard-up = Das Normal wie gezeichnet aufstellen: { $place }. Befestigen. { $text }
performance-simulation-scans-bar = Der simulierte Bediener scannt den Stab in Lage { $place }, Scan { $repeat }
performance-step-lengths = Längen
performance-touch-bar-first = Zuerst alle Längen dieser Lage antasten.
performance-touch-length =
    Länge { $length }, Wiederholung { $repeat } von { $of }: { $kind ->
        [face] { $end ->
            [1] die erste Fläche
           *[other] die zweite Fläche
        } antasten. Beide in gleicher Richtung und auf gleicher Höhe und Seite antasten.
       *[sphere] { $end ->
            [1] die erste Kugel
           *[other] die zweite Kugel
        } an { $touches } Stellen ringsum antasten.
    }
performance-turn-standard = Die sieben Lagen decken den Raum des Arms nur ab, wenn das Normal etwa wie gezeichnet liegt.
scan-has-length-twice = mehr als ein Paar von Kugeln im Scan hat den Abstand { $length }; die beiden Kugeln dieser Länge einzeln scannen
scan-shows-little-of-sphere = der Scan zeigt zu wenig von einer Kugel am Ende von { $length }: nötig sind mindestens { $points } Punkte aus { $frames } Bildern, auf einer Kappe von 25° oder mehr in jeder Richtung
scan-without-length =
    { $count ->
        [one] der Scan zeigt eine Kugel statt zweier im Abstand von { $length }
       *[other] von den { $count } Kugeln im Scan haben keine zwei den Abstand { $length }
    }

part-at-least = mindestens { $lower }
part-at-most = höchstens { $upper }
part-between = { $lower } bis { $upper }
part-budget = Woher die Unsicherheit kommt
part-budget-squares-add-up = Standardunsicherheiten (k = 1); die Summe ihrer Quadrate ist das Quadrat der Unsicherheit des Maßes.
part-decision = Entscheidung
part-deviation = Abweichung
part-dimension = Maß
part-dimensions = Maße
part-drawing = Zeichnung
part-feature = Merkmal
part-features = Merkmale
part-frame = Koordinatensystem des Werkstücks
part-frame-from = Es folgt aus { $datums }.
part-frame-known = Es ist an den Bezügen auf { $datums } bekannt, an der fernen Ecke des Werkstücks auf { $corner } (k = 2).
part-frames = Bilder
part-inspection = Prüfung eines Werkstücks
part-kind =
    { $kind ->
        [plane] Ebene
        [circle] Kreis
        [cylinder] Zylinder
        [cone] Kegel
        [sphere] Kugel
        [torus] Torus
        [slot] Langloch
        [line] Gerade
       *[other] { $kind }
    }
part-kind-of-feature = Art
part-left-out-by-rule = { $count } { $rule }
part-left-out-of-feature =
    { $feature } mit { $means ->
        [touch] Taster
       *[scan] Linie
    }: ausgelassen { $parts }.
part-limit-mark = Grenze
part-limits = Grenzen
part-means =
    { $means ->
        [touch] Taster
       *[scan] Linie
    }
part-measured = Was gemessen wurde
part-measured-by = Mit
part-measured-value = Gemessen
part-name = Werkstück
part-nominal = Nennwert
part-nothing-left-out = Kein Punkt wurde ausgelassen.
part-points = Punkte
part-program = Programm
part-range-of-cells = Spanne der Zellen
part-rule-edge = an Kanten
part-rule-incidence = zu flach gesehen
part-rule-other-feature = auf einem anderen Merkmal
part-rule-outlier = Ausreißer
part-rule-wrong-side = auf der falschen Seite
part-scatter-is-no-uncertainty = Nur die Streuung der Punkte ist bekannt. Sie ist keine Unsicherheit, und nichts wurde nach ihr entschieden.
part-scatter-k-2 = Streuung, k = 2
part-serial-number = Seriennummer
part-source-arm = Arm
part-source-calibration = Kalibrierung
part-source-encoders = Winkelgeber
part-source-form = Form
part-source-stripe = Linie
part-source-temperature = Temperatur
part-source-tip = Taster
part-source-touches = Antastungen
part-uncertainty-is-of-all-errors = U ist die erweiterte Unsicherheit (k = 2) durch alle Fehler von Sensor, Arm, Taster, Ablesungen, Punkten und Form zusammen, mit dem, was sie gemeinsam haben. Grenzen sind Abweichungen vom Nennwert.
part-used = Genutzt
part-values-in-their-bands = Jedes Maß von der Mitte seiner Grenzen aus, oder von seinem Nennwert, wo es nur eine hat; der Balken ist U (k = 2).
part-verdict =
    { $count ->
        [one] Ein Maß wurde gemessen
       *[other] { $count } Maße wurden gemessen
    }: { $passed } bestanden, { $failed } nicht bestanden, { $undecided } unentschieden.
part-warnings = Warnungen

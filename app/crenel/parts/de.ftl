inspection-result-missing = Diese Prüfung hat kein Ergebnis mehr: Ihr Ordner ist nicht im Datenordner
part-add-datum-or-lock = einen Bezug hinzufügen, oder { $name } sperren
part-alignment-leaves-free =
    die Ausrichtung lässt dem Werkstück eine { $kind ->
        [turn] Drehung um
       *[shift] Verschiebung entlang
    } { $axis } frei
part-arm-errors-unknown = Weder calibration.json noch arm.json sagt, wie gut die Glieder des Arms bekannt sind: Es wird nur die Streuung angegeben und nichts entschieden.
part-best-fit-without-features = eine Besteinpassung braucht Merkmale
part-box-corners-must-ascend = die zweite Ecke eines Quaders muss entlang jeder Achse jenseits der ersten liegen
part-calibration-without-covariance = calibration.json enthält keine Kovarianz: Es wird nur die Streuung angegeben und nichts entschieden.
part-choose-language = eine von { $languages } wählen
part-coordinate-without-axis = eine Koordinate braucht eine Achse: x, y oder z
part-correlation-unknown = calibration.json enthält keine Fehler der Glieder: Die des Arms gelten als unabhängig von denen des Sensors; ihre Korrelation ist unbekannt.
part-datum-is-skipped = der Bezug { $feature } darf nicht übersprungen werden
part-datum-without-direction = { $place }: der Bezug { $datum } hat keine Richtung
part-datums-do-not-fix-it = die Bezüge legen sie nicht fest
part-datums-without-primary = Bezüge brauchen einen primären
part-dimension-features =
    das Maß { $kind } gehört zu { $count ->
        [one] einem Merkmal
       *[other] { $count } Merkmalen
    }
part-dimension-of-one-feature-twice = die beiden Merkmale müssen verschieden sein
part-direction-without-length = eine Richtung darf nicht null sein
part-encoder-noise-unknown = Das Rauschen der Winkelgeber ist unbekannt: arm.json nennt 0, und keine Kalibrierung hat es geschätzt. Es wird nur die Streuung angegeben und nichts entschieden.
part-end-name-with = den Namen mit einem von { $endings } enden lassen
part-expansion-not-stated = das Programm sagt nicht, wie sich das Werkstück ausdehnt
part-feature-has-points =
    Merkmal { $feature }: { $count ->
        [0] kein Punkt
        [one] ein Punkt
       *[other] { $count } Punkte
    } des Scans darauf
part-feature-not-determined =
    Merkmal { $feature }: { $count ->
        [one] ein Punkt legt
       *[other] { $count } Punkte legen
    } es nicht fest
part-feature-seen-flat = Merkmal { $feature } wurde fast überall mehr als 70° von seiner Normalen aus gesehen; seine Punkte werden trotzdem genommen.
part-feature-skipped = Das Merkmal { $feature } wurde übersprungen: { $reason }
part-feature-unknown = { $place }: Es gibt kein Merkmal { $feature }; die Merkmale sind { $names }
part-features-by-scan = Merkmale sollen mit dem Scan gemessen werden
part-features-by-touch = Merkmale sollen mit dem Taster gemessen werden
part-folder-has = einen Ordner mit { $program }, calibration.json, arm.json, scans und touches.csv angeben
part-form-limit-below-noise = { $dimension }: Ein Grenzwert von { $limit } ist mit diesem Sensor nicht entscheidbar, dessen Rauschen allein { $noise } zeigt.
part-give-temperature = seine Temperatur in °C angeben
part-id-twice = { $place }: Die Kennung { $id } kommt zweimal vor
part-language-unknown = die Sprache { $language } gibt es nicht
part-length-is-range = length_mm von { $kind } ist ein Bereich: [von, bis] entlang der Richtung
part-lower-above-upper = lower ({ $lower }) darf nicht über upper ({ $upper }) liegen
part-means-disagree = Merkmal { $feature }: Laserlinie und Taster unterscheiden sich um { $off } in Durchmesser oder Breite, bei einer Standardunsicherheit von { $u }.
part-measure-more-of-feature = mehr davon messen
part-moved-while-measured =
    Das Werkstück hat sich { $between ->
        [scans] zwischen zwei Aufzeichnungen
        [touches] zwischen Antasten und Scan
       *[passes] während des Scans
    } bewegt: Merkmal { $feature } wurde { $off } versetzt gefunden, bei einer Standardunsicherheit von { $u }. Es wird nichts entschieden.
part-no-folder = { $folder }: Diesen Ordner gibt es nicht
part-no-scans = { $program }: Es gibt keinen Scan
part-no-such-size = { $place }: { $kind } gibt es bei { $feature } nicht
part-no-touches = { $program }: Es gibt keine Antastungen
part-nominal-lacks = dem Nennmaß von { $kind } fehlt { $names }
part-not-found = das Werkstück wurde nicht gefunden: Das Gemessene liegt { $off } neben seinen Nennmerkmalen
part-not-found-remedy = Programm, Antastungen und Scan prüfen, oder drei Bezüge antasten
part-not-found-why = es ist ein anderes Werkstück, oder zu wenig davon wurde gemessen
part-orientation-needs-datum = { $kind } braucht einen Bezug in datums
part-place = { $x }, { $y }, { $z }
part-plane-without-region = { $place }: die Ebene { $feature } braucht eine region, über die die Zone genommen wird
part-points-on-too-small-piece = sie liegen auf einem zu kleinen Stück davon
part-position-needs-upper = eine Position braucht einen oberen Grenzwert
part-put-scans = Aufnahmen in { $folder } legen, oder --scan angeben
part-put-touches = sie in { $file } ablegen, oder --touches angeben
part-range-must-ascend = ein Bereich muss ansteigen
part-reference-is-no-plane = { $place }: reference muss eine Ebene sein
part-result-form-unknown = { $path }: In dieser Form werden keine Ergebnisse geschrieben
part-robot-noise-unknown = Wie gut ein Roboter seine Posen kennt, ist nicht angegeben: Es wird nur die Streuung angegeben und nichts entschieden.
part-scan-does-not-show-it = der Scan zeigt es nicht dort, wo das Programm es hat
part-scan-feature-or-check-alignment = es scannen, oder Nennmaß und Ausrichtung prüfen
part-slot-direction-along-normal = direction und normal eines Langlochs müssen verschieden sein
part-slot-length-is-one-number = length_mm eines Langlochs ist eine Zahl: seine Gesamtlänge
part-slot-shorter-than-wide = ein Langloch muss länger als breit sein
part-spread-touches = die Antastungen über das Merkmal verteilen
part-state-expansion = part.expansion_per_c angeben, oder --temperature weglassen
part-temperature-compensated = Längen sind die bei 20 °C: Das Werkstück hatte { $temperature } und war dadurch { $factor } länger.
part-temperature-impossible = das Werkstück kann nicht { $temperature } haben
part-temperature-not-compensated = Die Temperatur ist nicht berücksichtigt: Längen gelten bei der Temperatur des Werkstücks.
part-tertiary-without-secondary = ein tertiärer Bezug braucht einen sekundären
part-too-few-touches =
    { $file }: Merkmal { $feature } hat { $count ->
        [0] keine Antastung
        [one] eine Antastung
       *[other] { $count } Antastungen
    }, nötig sind { $least }
part-touch-far-off = { $place }: Die Antastung liegt { $away } neben Merkmal { $feature }; sie wird ausgelassen.
part-touch-it-more = es an mindestens { $least } Stellen antasten
part-touch-on-other = { $place }: Die Antastung liegt { $away } neben Merkmal { $feature } und auf { $other }; sie wird ausgelassen.
part-touch-on-wrong-side = { $place }: Die Antastung liegt auf der falschen Seite von Merkmal { $feature }; sie wird ausgelassen.
part-touches-at-one-place = Merkmal { $feature }: Seine { $count } Antastungen liegen an einer Stelle
part-touches-extent = sie liegen innerhalb von { $extent }
part-unit-of-other-kind = { $unit } ist keine Einheit von { $kind }

ui-fleet = Flotte
ui-fleet-affected = { $n ->
    [one] Eine Aufnahme ist betroffen.
   *[other] { $n } Aufnahmen sind betroffen.
}
ui-fleet-against = Über
ui-fleet-ageing = Alterung
ui-fleet-all-calibrations = Alle Kalibrierungen jedes Sensors; die neueste ist blau und groß. Der Balken ist der Median ± eine Standardabweichung.
ui-fleet-archived = Archiviert
ui-fleet-back = Zurück zur Liste
ui-fleet-broker-away = Der Broker ist nicht erreichbar: Was die Stationen jetzt tun, ist unbekannt.
ui-fleet-calibration-choice = { $mark ->
    [used] { $name }, { $at }: damals benutzt
    [newest] { $name }, { $at }: die neueste
    [both] { $name }, { $at }: damals benutzt, die neueste
   *[none] { $name }, { $at }
}
ui-fleet-calibration-doubt = { $doubt ->
    [wrong] Falsch nach der Drift der Prüfungen: { $quantity } weicht mit dieser Kalibrierung um { $size } ab.
   *[perhaps] Vielleicht falsch nach der Drift der Prüfungen: { $quantity } weicht mit dieser Kalibrierung um { $size } ab, weit von den anderen, aber nicht sicher weiter, als diese streuen.
}
ui-fleet-calibration-doubted = { $doubt ->
    [wrong] { $choice } – falsch
   *[perhaps] { $choice } – vielleicht falsch
}
ui-fleet-calibration-of-its-day = Vom Tag des Scans
ui-fleet-calibration-of-sensor = Kalibrierung, Sensor { $sensor }
ui-fleet-calibrations = Kalibrierungen
ui-fleet-changed = Änderung um { $size } ± { $uncertainty } { $unit } (k = 2) zwischen { $earliest } und { $latest } (95 %).
ui-fleet-changes-by = { $since ->
        [calibration] Ändert sich um { $slope } ± { $uncertainty } { $unit } (95 %), nach { $n } Werten mit { $groups } Kalibrierungen.
       *[first] Ändert sich um { $slope } ± { $uncertainty } { $unit } (95 %), nach { $n } Werten von { $groups } Geräten.
    }
ui-fleet-cloud = Auf einem anderen Rechner mit Zugang zu diesen Datensätzen berechnet dieser Befehl die Punktwolke:
ui-fleet-cloud-failed = Die Punktwolke mit { $calibration } ist nicht berechnet. { $why }
ui-fleet-cloud-format = Format
ui-fleet-cloud-is-being-made = Die Punktwolke mit { $calibration } wird berechnet
ui-fleet-cloud-is-made = Sie ist schon berechnet
ui-fleet-cloud-waits = Die Punktwolke mit { $calibration } wartet auf die vor ihr
ui-fleet-clouds = Punktwolken
ui-fleet-collected = Gesammelt
ui-fleet-count = Anzahl
ui-fleet-days-reversed = „Von“ liegt nach „Bis“, sodass kein Datensatz zu finden ist: Wählen Sie ein früheres „Von“ oder ein späteres „Bis“.
ui-fleet-differed = Weicht vom ersten Wert an, { $since }, um { $size } ± { $uncertainty } { $unit } (k = 2) ab.
ui-fleet-doubtful = Vielleicht falsch: { $calibration }, um { $size }, geprüft von { $since } bis { $until }. Sie liegt weit von den anderen Kalibrierungen, aber nicht sicher weiter, als diese streuen.
ui-fleet-download = Herunterladen
ui-fleet-drift = Drift
ui-fleet-ended = Spätestens am { $when } wieder auf dem richtigen Niveau.
ui-fleet-expanded = U (k = 2)
ui-fleet-explained = Nur die Prüfungen dieses Zeitraums verwendeten: { $calibrations }. Die Aufnahmen damit sind betroffen.
ui-fleet-file = Datei
ui-fleet-from = Gesammelt aus
ui-fleet-hours = Stunden
ui-fleet-hours-since-calibration = Stunden seit der verwendeten Kalibrierung
ui-fleet-hours-since-first = Stunden seit dem ersten Wert des Geräts
ui-fleet-kind = Art
ui-fleet-kind-performance = Leistungsprüfung
ui-fleet-kind-scan = Scan
ui-fleet-label = Name
ui-fleet-lasts = Sie dauert an.
ui-fleet-least-values = Ein Zeitraum, in dem eine Größe abweicht, wird ab { $n } Prüfungen gefunden.
ui-fleet-left-out = Ausgelassen, weil ihre Kalibrierung nicht im Katalog ist: { $n }
ui-fleet-level = { $n ->
    [one] { $value } ab { $since } (ein Wert)
   *[other] { $value } ab { $since } ({ $n } Werte)
}
ui-fleet-make-cloud = Punktwolke berechnen
ui-fleet-median = Median
ui-fleet-newest = Neuester Datensatz
ui-fleet-newest-calibrations = Neueste Kalibrierungen
ui-fleet-newest-value = Neueste
ui-fleet-no-answer = Der Server der Flotte antwortet nicht, oder seine Datenbank ist jetzt nicht benutzbar. Die Stationen arbeiten weiter, und nichts geht verloren.
ui-fleet-no-change-shown = { $since ->
        [calibration] Keine Änderung erkennbar: { $slope } ± { $uncertainty } { $unit } (95 %), nach { $n } Werten mit { $groups } Kalibrierungen.
       *[first] Keine Änderung erkennbar: { $slope } ± { $uncertainty } { $unit } (95 %), nach { $n } Werten von { $groups } Geräten.
    }
ui-fleet-no-slope = Zu wenige Werte für einen Trend.
ui-fleet-not-collected = Am Broker, aber nicht in fleet.toml: es wird nichts gesammelt.
ui-fleet-not-on-broker = Am Broker nicht gehört
ui-fleet-nothing-found = Kein Datensatz gefunden.
ui-fleet-object = Prüfkörper
ui-fleet-only-on-station = Nur auf der Station
ui-fleet-own-errors = Die eigenen Fehler von { $n } Kalibrierungen haben eine Standardabweichung von { $deviation }; Änderungen, die sie erklären, zählen nicht.
ui-fleet-own-errors-unknown = { $n ->
    [one] Eine Kalibrierung zeigt nicht, wie weit Kalibrierungen voneinander abweichen: Eine Änderung kann ein gewöhnlicher Fehler einer Kalibrierung sein.
   *[other] { $n } Kalibrierungen mit so wenigen Prüfungen zeigen nicht, wie weit Kalibrierungen voneinander abweichen: Eine Änderung kann ein gewöhnlicher Fehler einer Kalibrierung sein.
}
ui-fleet-place = Katalog: { $place }
ui-fleet-possible = { $n ->
    [one] Eine weitere ist vielleicht betroffen.
   *[other] { $n } weitere sind vielleicht betroffen.
}
ui-fleet-quantity = Größe
ui-fleet-records = Datensätze
ui-fleet-right = { $because ->
    [most] Gilt als richtig: { $value }, seit { $since }, weil { $n } von { $total } Werten so sind. Die Werte allein zeigen nicht, welches Niveau richtig ist.
    [chosen] Gilt als richtig, wie gewählt: { $value }, seit { $since }; { $n } von { $total } Werten sind so.
   *[first] Gilt als richtig: { $value }, seit { $since }, weil es das erste Niveau ist; { $n } von { $total } Werten sind so. Die Werte allein zeigen nicht, welches Niveau richtig ist.
}
ui-fleet-right-level = Richtiges Niveau
ui-fleet-right-proposed = Wie vorgeschlagen
ui-fleet-session = Andere Sitzung
ui-fleet-since = Von
ui-fleet-size = Umfang
ui-fleet-software = Software
ui-fleet-spread = Streuung aller Kalibrierungen
ui-fleet-standard-deviation = Standardabweichung
ui-fleet-standing-out = { $n ->
    [one] Ein Wert sticht heraus. Weniger als { $least } zusammen sind für einen Zeitraum zu wenige.
   *[other] { $n } Werte stechen heraus. Weniger als { $least } zusammen sind für einen Zeitraum zu wenige.
}
ui-fleet-symbol = Symbol
ui-fleet-temperature-since-calibration = Über der Temperatur der verwendeten Kalibrierung
ui-fleet-temperature-since-first = Temperatur
ui-fleet-then = Dann { $value } ab { $since }.
ui-fleet-times = Zeiten: { $zone }
ui-fleet-until = Bis
ui-fleet-verdict = Ergebnis
ui-fleet-with-the-password = Mit dem Passwort dieser Seite
ui-fleet-words = Teil, Bediener, Kennung, Seriennummer
ui-fleet-would-be-affected = { $n ->
    [0] Mit ihr wurde nichts aufgenommen.
    [one] Falls sie falsch ist, ist eine Aufnahme betroffen.
   *[other] Falls sie falsch ist, sind { $n } Aufnahmen betroffen.
}

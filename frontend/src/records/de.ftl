ui-95-percent-within = 95 % innerhalb
ui-a-record-not-live = Eine Aufnahme aus dem Archiv, nicht live
ui-a-scan-is-running = Ein Scan läuft.
ui-accepted = Angenommen
ui-active = aktiv
ui-against-previous-calibration-dashed-uncertainties-both = gegenüber der vorigen Kalibrierung; gestrichelt: was die Unsicherheiten beider für einen unbewegten Sensor zulassen (k = 2)
ui-all-records = Gesamtes Archiv
ui-back-to-live = Zurück zu live
ui-begun = Begonnen
ui-beyond = über dem Grenzwert von { $limit }
ui-cannot-displayed-files-missing-data-folder = Anzeige nicht möglich: Die Dateien fehlen im Datenordner, oder die Station ist nicht erreichbar.
ui-changes-between-calibrations-appear-second-one = Ab der zweiten Kalibrierung erscheinen hier die Änderungen.
ui-choose-another-scan = Einen weiteren Scan wählen, um sie zusammenzuführen oder zu vergleichen.
ui-choose-none = Keinen wählen
ui-choose-record = { $name } wählen
ui-compare-with = Vergleichen mit
ui-compared-points = Verglichen
ui-comparison = Vergleich
ui-comparison-is-scatter-and-change = Jeder Punkt von der Ebene durch seine Nachbarn auf dem anderen Scan: die Streuung beider Scans und was sich zwischen ihnen geändert oder bewegt hat. Das ist keine Messunsicherheit.
ui-comparison-of-two-calibrations = Die Scans haben verschiedene Kalibrierungen, deren Abweichungen darin stecken.
ui-continue-this-scan = Diesen Scan fortsetzen
ui-customer = Kunde
ui-delete = Löschen
ui-delete-recording-points-removed-disk-permanently = { $name } löschen? Die Aufzeichnung und die { $points } Punkte werden endgültig vom Datenträger entfernt.
ui-deviation-from = Abweichungen von { $name }, außen positiv.
ui-do-not-continue = Nicht fortsetzen
ui-duration = Dauer
ui-end-comparison = Vergleich beenden
ui-fetch = Holen
ui-fetch-it-from-the-archive-first = Zuerst aus dem Archiv holen.
ui-files-of-record = Dateien
ui-in-use = In Verwendung.
ui-laser-rotation = Verdrehung des Lasers
ui-laser-shift = Verschiebung des Lasers
ui-latest = { $figure }, zuletzt: { $value }
ui-loading-the-calibration = Kalibrierung wird geladen …
ui-loading-the-record = Aufnahme wird geladen …
ui-mean-deviation = Mittel
ui-merge-into-one-cloud = Zu einer Punktwolke zusammenführen
ui-merged-of = Zusammengeführt aus
ui-n-of-all-scans = { $n } von { $all }
ui-n-of-all-too-fast = { $n } von { $all } Bildern zu schnell
ui-n-pictures = { $n ->
        [one] { $n } Bild
       *[other] { $n } Bilder
    }
ui-n-pictures-lost =
    { $n ->
        [one] { $n } Bild verloren
       *[other] { $n } Bilder verloren
    }
ui-n-pictures-without-points =
    { $n ->
        [one] { $n } Bild ohne Punkte
       *[other] { $n } Bilder ohne Punkte
    }
ui-n-scans =
    { $n ->
        [one] { $n } Scan
       *[other] { $n } Scans
    }
ui-n-scans-chosen = { $n } Scans gewählt
ui-n-scans-merged = { $n } Scans zusammengeführt
ui-name-part = Teil benennen
ui-new-name-of = Neuer Name von { $name }
ui-next-scan-is-added-to = Der nächste Scan kommt zu einer Aufnahme hinzu
ui-no-longer-in-use = Nicht mehr in Verwendung.
ui-no-picture = kein Bild
ui-no-scan-is-like-that = Kein Scan passt dazu.
ui-not-measured = nicht gemessen
ui-not-on-the-other = Neben dem anderen Scan
ui-not-stated = nicht angegeben
ui-open-in-the-3d-view = In der 3D-Ansicht öffnen
ui-open-to-turn-it = In der 3D-Ansicht öffnen, um ihn zu drehen, abzuspielen oder zu vergleichen.
ui-order = Auftrag
ui-order-of = Auftrag { $order }
ui-part = Teil
ui-part-of-next-scans = Teil der nächsten Scans
ui-part-of-this-scan = Teil dieses Scans
ui-pause = Anhalten
ui-planes-flat-to = { $radius } weit, Abstand davon { $flatness }
ui-planes-of-comparison = Ebenen
ui-play = Abspielen
ui-rename = Umbenennen
ui-replay = Wiedergabe
ui-rotation-of-the-laser-plane = Verdrehung der Laserebene
ui-rotation-of-the-measuring-volume = Verdrehung des Messvolumens
ui-save = Speichern
ui-saved-clouds-appear-newest-first-start = Hier erscheinen gespeicherte Punktwolken, die neueste zuerst. Auf der Seite „Scannen“ einen Scan starten.
ui-sensor-rotation = Verdrehung des Sensors
ui-sensor-shift = Verschiebung des Sensors
ui-serial-number-of = Nr. { $number }
ui-shift-centre-measuring-volume-frame-arms = Verschiebung der Mitte des Messvolumens im Koordinatensystem des letzten Gelenks des Messarms
ui-shift-laser-plane-along-normal = Verschiebung der Laserebene entlang ihrer Normalen
ui-show-more-of =
    { $n ->
        [one] { $n } weiteren zeigen
       *[other] Mehr von { $n } zeigen
    }
ui-shown-in-the-3d-view = In der 3D-Ansicht gezeigt.
ui-standard-uncertainty-dashed-good = Standardunsicherheit eines gescannten Punkts, k = 1; gestrichelt: Grenzwert für „gut“
ui-temperature-at-acceptance = Temperatur bei der Annahme
ui-the-part-is-not-named = Das Teil ist nicht benannt.
ui-there-is-no-such-record = Diese Aufnahme gibt es nicht, oder sie ließ sich nicht laden.
ui-time-of-the-scan = Zeit des Scans
ui-times-speed = { $n }×
ui-uncertainty-scanned-point-k-1 = Unsicherheit eines gescannten Punkts (k = 1)
ui-within = innerhalb des Grenzwerts von { $limit }

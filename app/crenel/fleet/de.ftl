fleet-give-own-place = Geben Sie jeder Station ein eigenes Archiv und einen eigenen Datenordner
fleet-give-place = Geben Sie archive = {"{"} url = "…" {"}"} oder data = "…" an
fleet-name-page-password = Nennen Sie eine Datei, die nur das Passwort der Seite enthält
fleet-name-password-file = Nennen Sie eine Datei, die nur das Passwort der Datenbank enthält
fleet-no-marker = crenel-archive.txt fehlt darin; die Station schreibt es mit ihrem ersten Datensatz
fleet-password-empty = { $file } ist leer
fleet-station-has-no-place = { $file }, [stations.{ $station }]: es gibt weder ein Archiv noch einen Datenordner
fleet-stations-share-place = { $file }: die Stationen { $other } und { $station } haben denselben Ort, { $place }
fleet-write-settings = Schreiben Sie eine, wie docs/fleet.md zeigt, oder nennen Sie eine andere mit --config

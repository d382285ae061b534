archive-fetched = { $name } ist aus dem Archiv zurück.
archive-fetching = { $name } wird aus dem Archiv geholt
calibration-has-no-picture = Diese Kalibrierung hat kein Bild { $name }.
cannot-deleted-now = Löschen ist jetzt nicht möglich
cannot-hidden-now = Ausblenden ist jetzt nicht möglich
choose-another-picture = Ein anderes Bild wählen oder es kleiner speichern
chosen-picture = Das gewählte Bild
deleted = { $name } wurde gelöscht
give-one-first = Zuerst eine Adresse angeben
load-page-again = Seite neu laden.
merging-scans = { $count } Scans werden zusammengeführt
no-longer-in-data-folder = { $name } ist nicht mehr im Datenordner.
pass-over-plate = Überfahrt über die Platte
pass-stopped = Die Überfahrt wurde abgebrochen
says-hello = Testnachricht von { $name }.
scan-cannot-start-now = Ein Scan kann jetzt nicht starten
scan-flat-plate-nearer-away-again = Eine ebene Platte scannen, mehrmals näher heran und wieder weg, dann den Zeitversatz bestimmen
scan-needs-name = Ein Scan braucht einen Namen
scans-are-merged = { $name }: zusammengeführt, { $points } Punkte
session-has-no-picture = Diese Sitzung hat kein Bild { $name }.
session-has-no-pose = in dieser Sitzung gibt es keine Pose { $number }
shape-label = { $shape ->
    [plane] Ebene
    [sphere] Kugel
   *[cylinder] Zylinder
} { $n }
start-again = Erneut starten
stopped-by = { $name } hat in einem anderen Browser „Stopp“ gedrückt: Der Laser ist aus.
stopped-by-what-kept =
    { $scan ->
        [yes] Der laufende Scan ist beendet. Seine Punkte liegen im Archiv.
       *[no] Es lief kein Scan.
    }
stopped-laser-off = Gestoppt: Der Laser ist aus.
support-bundle-being-made-already = Ein Diagnosepaket wird bereits erstellt
there-no-address-yet = Es ist noch keine Adresse angegeben
there-no-check-arm = Die Armprüfung { $record_id } gibt es nicht.
there-no-check-tip = Die Tastkugelprüfung { $record_id } gibt es nicht.
there-no-identification-arm = Die Identifikation des Messarms { $record_id } gibt es nicht.
there-no-scan-find-delay = Es gibt keinen Scan, aus dem sich der Zeitversatz bestimmen lässt
there-no-such-page-3d-view = Diese Seite der 3D-Ansicht gibt es nicht.
there-no-verification = Die Verifizierung { $record_id } gibt es nicht.
view-3d-does-not-answer = Die 3D-Ansicht antwortet nicht.
wait-stop = Warten oder stoppen
write-one = einen Namen eingeben

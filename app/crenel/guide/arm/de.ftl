another-tip-mounted-another-sphere-touched = Der Durchmesser der Tastkugel beträgt anscheinend { $diameter }, laut Datenblatt des Messarms { $expected }: Es ist ein anderer Taster montiert, oder es wurde eine andere Kugel angetastet.
arm-before = Der vorherige Messarm wird wieder verwendet.
arm-before-arms-put-back-hand = die vorige Armdatei liegt in arms/{ $replaced }/{ $name }; von Hand zurücklegen
arm-checked = Der Messarm ist geprüft: { $worst }.
arm-identified = Der Messarm ist identifiziert.
arm-place-name =
    { $kind ->
        [bar] Kugelstab { $number }, Ende { $end }
        [sphere] Kugel { $number }
       *[seat] Pfanne { $number }
    }
arm-place-title =
    { $kind ->
        [bar] Kugelstab { $number }, Ende { $end }
        [sphere] Kugel { $number }
       *[seat] Pfanne { $number }
    }
arm-reports-poses-not-checked-here = Der angeschlossene Arm meldet Posen: Seine eigene Software prüft seine Gelenke und seine Tastkugel.
arm-unchanged = Der Messarm ist unverändert.
arm-use-already = Dieser Messarm wird bereits verwendet.
back-places = Zurück zu den Positionen
ball-bars-lengths = Längen der Kugelstäbe
bars-end = Stabende { $value }
belongs-another-step-session-stands =
    { $step ->
        [seat] Das gehört zu einem anderen Schritt; die Sitzung ist beim Schritt „Tastkugel einsetzen“.
        [swing] Das gehört zu einem anderen Schritt; die Sitzung ist beim Schritt „Messarm schwenken“.
       *[result] Das gehört zu einem anderen Schritt; die Sitzung ist beim Schritt „Ergebnis“.
    }
calibrate-sensors-again-their-place-belongs = Die Sensoren neu kalibrieren: Ihre Lage wurde mit dem bisherigen Messarm bestimmt.
cancel-session = Sitzung abbrechen
changed-after-session-had-written = { $name } wurde geändert, nachdem diese Sitzung die Datei geschrieben hatte
check-again = Erneut prüfen
check-one-seat = Diese Prüfung gilt für eine einzige Pfanne.
check-recorded-limit-set-before-next = Diese Prüfung ist mit ihrem Grenzwert aufgezeichnet. Den Grenzwert vor der nächsten festlegen.
check-tip-again-holding-still = Erneut prüfen, an jedem Punkt in Ruhe.
choose-arm-first = Zuerst den Messarm wählen.
clamp-bar-firmly-reach-put-tip = Kugelstab in Reichweite fest einspannen, { $where }, und die Tastkugel in ein Ende setzen.
clamp-cone-ball-seat-about-two = Kegel- oder Kugelpfanne bei etwa zwei Dritteln der Reichweite festspannen und die Tastkugel hineinsetzen.
clamp-firmly-reach = In Reichweite fest aufspannen, { $where }.
clamp-seat-firmly-reach-put-tip = Pfanne in Reichweite fest aufspannen, { $where }, und die Tastkugel hineinsetzen.
clamp-sphere = Kugel festspannen
clean-both-check-again = Beide reinigen und erneut prüfen.
clean-tip-clamp-sphere = Tastkugel reinigen und die Kugel festspannen
clean-tip-seat-check-clamps-repeat = Tastkugel und Pfanne reinigen, Aufspannung prüfen und wiederholen. Bleibt es dabei, den Messarm identifizieren.
coordinates-identify-only = Koordinaten dienen nur der Identifikation des Messarms
drop-coordinates = Koordinaten verwerfen
drop-last-place = Letzte Position verwerfen
enough-places = Genügend Positionen
exceed-limit-m = { $half_range } überschreiten den Grenzwert von { $limit }.
expected-by-datasheet-and-expanded-uncertainty = laut Datenblatt { $expected }; U = { $expanded_uncertainty }, k = 2
far-out = weit außen
finish-sphere = Kugel abschließen
finish-swing = Schwenk abschließen
give-certificate-first =
    { $kind ->
        [bar] Zuerst die Länge des Kugelstabs laut Kalibrierschein angeben.
       *[sphere] Zuerst den Durchmesser der Kugel laut Kalibrierschein angeben.
    }
go-swinging-least-points = Weiter schwenken: { $taken } von mindestens { $least } Punkten.
has-mm =
    { $kind ->
        [bar] Für einen Kugelstab sind { $low } bis { $high } zulässig.
       *[sphere] Für eine Kugel sind { $low } bis { $high } zulässig.
    }
high-up = weit oben
identified-arm-use = Der identifizierte Messarm wird verwendet.
identify-arm = Messarm identifizieren
identify-arm-first = Zuerst den Messarm identifizieren.
identify-arm-take-more-know-better = Messarm identifizieren oder weitere Positionen aufnehmen, um ihn genauer zu bestimmen.
identifying-arm = Messarm wird identifiziert
in-space-largest-and-two-s = Räumlich: größter Abstand vom Mittelwert { $largest }, 2 s { $two_s } (Kennwerte nach ASME B89.4.22, hier für eine Pfanne).
keep-tip-seat-swing-elbow-one = Tastkugel in der Pfanne lassen. Den Ellbogen von einer Seite zur anderen und zurück schwenken und das Handgelenk in alle Richtungen neigen.
largest-distance = Größter Abstand
largest-half-range = Größtes (max − min)/2
largest-swing = { $points }, größter Schwenk { $swing }
least-places-taken = { $places_taken } von mindestens { $seats_least } Positionen sind aufgenommen.
leave-bar-where = Den Kugelstab liegen lassen.
leave-session-unused-points-kept = Diese Sitzung abbrechen? Noch nicht verwendete Punkte bleiben gespeichert.
left = links
length = Länge { $longer }
limit-is = Der Grenzwert ist { $limit }.
limit-number-micrometres-1-100-000 = Ein Grenzwert ist eine Zahl von 1 bis 100 000 Mikrometern.
limit-of-figure = Grenzwert { $limit }
look-change = Ansehen und tauschen.
low-down = weit unten
mount-tip-of-datasheet-or-give-diameter = Taster laut Datenblatt montieren oder den Durchmesser der Kugel selbst angeben.
n-2-worst-axis = 2σ beträgt auf der schlechtesten Achse { $two_sigma }; das Rauschen der Winkelgeber allein ergibt { $encoders }.
near-base = nahe am Armfuß
no-coordinates-taken-yet = noch keine Koordinaten übernommen
no-limit-set = kein Grenzwert festgelegt
no-limit-set-so-check-neither = Es ist kein Grenzwert festgelegt, daher ist diese Prüfung nicht entschieden.
no-seat-taken-yet = Noch keine Position aufgenommen.
places = { $done } von { $seats_wanted } Positionen
places-done = { $done } Positionen
places-were-held-out-fit-over = An Positionen, die nicht in die Ausgleichung eingingen, und über die gesamte Reichweite des Messarms.
point = Punkt { $number }, { $place }.
points-taken = { $taken } Punkte
points-taken-themselves-while-arm-swings = Punkte werden automatisch aufgenommen, während der Messarm schwenkt.
put-arm-back = Vorherigen Messarm wiederherstellen
put-back-end-swing = Wieder einsetzen oder den Schwenk abschließen.
put-tip-into-bars-other-end = Tastkugel in das andere Stabende setzen
put-tip-into-end-ball-bar = Tastkugel in ein Ende des Kugelstabs setzen
put-tip-into-seat = Tastkugel in die Pfanne setzen
put-tip-into-seat-of-number = Tastkugel in Pfanne { $done } setzen
right = rechts
screw-home-check-again-change-if = Fest einschrauben und erneut prüfen; bleibt es dabei, tauschen.
screw-tip-home-clamp-sphere-check = Taster fest einschrauben, Kugel festspannen und erneut prüfen.
seat-tip = Tastkugel einsetzen
seats-were-taken-another-arm = Die Pfannen wurden mit einem anderen Messarm aufgenommen.
session-closed-start-new-one = Diese Sitzung ist abgeschlossen. Eine neue starten.
set-arms-specification-limit-where-next = Bei Beginn der nächsten Prüfung die Spezifikation des Messarms als Grenzwert festlegen.
simulation-goes = Der simulierte Bediener führt den Messarm zu: { $name }
simulation-swings-arm-about = Der simulierte Bediener schwenkt den Messarm um: { $name }
simulation-touches-sphere = Der simulierte Bediener tastet die Kugel an
sphere-clamped = Die Kugel ist festgespannt
sphere-known-diameter-clamped-firmly-within = Eine Kugel mit bekanntem Durchmesser, gut erreichbar festgespannt.
standard-uncertainty-0-mm = Eine Standardunsicherheit beträgt 0 bis { $largest }.
swing-arm = Messarm schwenken
swing-arm-about = Messarm schwenken um: { $place }
swing-further-least = Weiter schwenken: { $swing } von mindestens { $least_swing_deg }.
take-again = Neu aufnehmen
take-bars-other-end-first-drop = Zuerst das andere Stabende aufnehmen oder das letzte verwerfen.
take-one-place-two-if-there = An ein oder zwei Positionen einen Kugelstab messen, falls vorhanden.
there-dirt-tip-sphere = Der Durchmesser der Tastkugel beträgt anscheinend { $diameter }, laut Datenblatt des Messarms { $expected }: Auf der Tastkugel oder der Kugel ist Schmutz.
there-no-such-arm = Diesen Messarm gibt es nicht.
there-no-such-artefact-here = Diesen Prüfkörper gibt es hier nicht.
tip-bars-end = Die Tastkugel sitzt im Stabende
tip-known = Unsicherheit der Tastkugel
tip-points-off-sphere-of-others =
    { $count ->
        [one] Punkt { $points } liegt { $scatter } neben der Kugel der übrigen.
       *[other] Die Punkte { $points } liegen bis zu { $scatter } neben der Kugel der übrigen.
    }
tip-seat = Die Tastkugel sitzt in der Pfanne
tip-seat-no-points-taken-there = Die Tastkugel ist { $left } von der Pfanne entfernt; dort werden keine Punkte aufgenommen.
tip-sits-off-its-place = Die Tastkugel sitzt { $off } neben ihrer Lage laut Datenblatt: Der Schaft ist verbogen oder nicht fest eingeschraubt.
tip-sound-diameter-off-touches-agree = Die Tastkugel ist in Ordnung: Ihr Durchmesser weicht um { $off } ab, ihre Antastpunkte stimmen auf { $scatter } überein.
tip-sphere-diameter-arm = der Tastkugel von einer Kugel dieses Durchmessers, mit dem bisherigen Armmodell
tip-uncertainty-before =
    { $size_known ->
        [yes] war { $before }; k = 1, rms über die Reichweite
       *[no] war { $before }; k = 1, rms über die Reichweite; ohne den Maßstab des Messarms
    }
tips-diameter = Tastkugeldurchmesser
tips-diameter-how-well-touches-agree = Durchmesser der Tastkugel und Übereinstimmung ihrer Antastpunkte.
tips-diameter-off-known-only-k = Der Durchmesser der Tastkugel weicht um { $off } ab; die erweiterte Unsicherheit von { $known } (k = 2) ist zu groß, um die Einhaltung des Grenzwerts nachzuweisen.
top-all-around-side-wrist-turned = Oben und ringsum an der Seite, mit jedes Mal anders gedrehtem Handgelenk. An jeder Stelle ruhig halten und die Taste am Messarm drücken.
touch = Antasten
touch-all-over-upper-half-every = Die ganze obere Hälfte von allen Seiten antasten, mit dem Messarm in vielen Haltungen. An jedem Punkt ruhig halten und die Taste am Messarm drücken.
touch-more-least-points = Weiter antasten: { $taken } von mindestens { $least } Punkten.
touch-place = { $place } antasten
touch-sphere = Kugel antasten
touch-sphere-more-spread-over-all = Kugel weiter antasten, über die ganze obere Hälfte verteilt.
touches-disagree-up-tip-sphere-loose = Die Antastpunkte weichen um bis zu { $scatter } voneinander ab: Tastkugel oder Kugel ist locker, oder der Messarm ist gerutscht.
use = In Verwendung
use-arm-before-what-identified-kept = Den vorherigen Messarm verwenden? Das Ergebnis der Identifikation bleibt in dieser Sitzung erhalten.
use-arm-now = Diesen Messarm ab jetzt verwenden
what-tip-moved-while-held-one = Scheinbare Bewegung der Tastkugel, während sie an einer Position gehalten wurde.
within-limit-m = { $half_range }, innerhalb des Grenzwerts von { $limit }.
without-ball-bar-arm-keeps-size = Ohne Kugelstab behält der Messarm den Maßstab seines Datenblatts.
worn-has-flat = Der Durchmesser der Tastkugel beträgt anscheinend { $diameter }, laut Datenblatt des Messarms { $expected }: Sie ist abgenutzt oder hat eine Abflachung.

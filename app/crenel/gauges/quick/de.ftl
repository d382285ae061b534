accept-verification = Diese Verifizierung annehmen
after-few-more-touches = nach einigen weiteren Antastpunkten
angle = Winkel, ″
angle-between-clouds = Winkel zwischen den Punktwolken
angle-touched-plane = Winkel zur angetasteten Ebene
another-calibration-came-into-use-meanwhile = Inzwischen wird eine andere Kalibrierung verwendet. Mit dieser neu beginnen.
away = nur { $min } entfernt
belongs-another-step-verification-stands =
    { $step ->
        [gauge] Das gehört zu einem anderen Schritt; die Verifizierung ist beim Schritt „Prüfnormal wählen“.
        [touch] Das gehört zu einem anderen Schritt; die Verifizierung ist beim Schritt „Prüfnormal antasten“.
        [scan] Das gehört zu einem anderen Schritt; die Verifizierung ist beim Schritt „Prüfnormal scannen“.
       *[review] Das gehört zu einem anderen Schritt; die Verifizierung ist beim Schritt „Ergebnis“.
    }
cancel-verification = Verifizierung abbrechen
centre-m = Mittelpunkt, µm
certificate-named = Kalibrierschein { $certificate }
check-chosen-gauge-tip-arms-own = Prüfen, ob dies das gewählte Prüfnormal ist und die Tastkugel zum Messarm gehört.
choose-gauge = Prüfnormal wählen
choose-gauge-first = Zuerst das Prüfnormal wählen.
choose-gauge-scanned = Das gescannte Prüfnormal wählen
chosen-gauge-has = das gewählte Prüfnormal hat { $diameter }
clamp-firmly-within-arms-reach-sphere = In Reichweite des Messarms fest aufspannen. Eine Kugel ist am aussagekräftigsten, eine Ebene geht schneller.
clean-gauge-tip-check-clamps-verify = Prüfnormal und Tastkugel reinigen, Aufspannung prüfen und erneut verifizieren; dann neu kalibrieren.
cloud-being-scanned-already = Es wird bereits eine Punktwolke gescannt.
cloud-check-shape-and-unit = Nur die Punktwolke des Normals angeben, seine Form und die Einheit (--unit)
cloud-cloud = { $title }, je Punktwolke.
cloud-covers-little = { $file }: die Punkte zeigen { $share } der Kugel; ihr Radius ist daher auf ± { $uncertainty } bekannt (k = 2). Mehr von der Kugel scannen
cloud-exact = { $used } von { $points } Punkten liegen genau auf einer { $shape ->
        [plane] Ebene
       *[sphere] Kugel
    }, wie es gemessene Punkte nie tun, und die anderen daneben
cloud-exact-remedy = Nicht gemessene Punkte weglassen und die Spalten prüfen (--columns)
cloud-has-points = Die Punktwolke hat { $points } Punkte
cloud-in-other-coordinates = { $file } liegt { $distance } vom Nennort entfernt: die Koordinaten sind andere, und Abweichungen des Ortes werden nicht angegeben
cloud-is-a-line = { $file }: die meisten Punkte liegen in einem Streifen von { $length } × { $width }: sie bestimmen kaum eine Ebene. Mehr von der Platte scannen
cloud-left-out-deleted = { $file }: { $points } Punkte sind als gelöscht markiert und zählen nicht
cloud-left-out-missing = { $file }: { $points } Punkte wurden nicht gemessen und zählen nicht: sie liegen bei 0, 0, 0 oder an einem anderen Ort, der für keinen steht
cloud-left-out-repeated = { $file }: { $points } Punkte wiederholen andere genau und zählen nicht
cloud-no-points-lie-rms-off =
    { $shape ->
        [sphere] Die Punktwolke ist keine Kugel: Ihre Punkte weichen um { $rms } rms ab
       *[plane] Die Punktwolke ist keine Ebene: Ihre Punkte weichen um { $rms } rms ab
    }
cloud-no-use = Punktwolke { $number } ist nicht brauchbar.
cloud-of-another-shape = { $file }: Die Punkte liegen { $rms } (rms) um die { $shape ->
        [plane] Ebene
       *[sphere] Kugel
    }: Sie gehören kaum zu einer. Nur die Punktwolke des Normals angeben
cloud-of-another-unit = { $file } hat den Nennradius, wenn die Einheit { $unit } ist. --unit { $unit } angeben
cloud-of-odd-size = { $file } ist { $size } groß, wenn die Einheit { $unit } ist. Die Einheit mit --unit m, mm oder inch angeben
cloud-points-not-of-plane = { $left_out } der Punkte von Punktwolke { $number } gehören nicht zur Ebene.
cloud-rms-about-gauge = Punktwolke { $number }: { $rms } rms Abweichung vom Prüfnormal.
cloud-shows-cap-sphere = Die Punktwolke zeigt eine Kugelkappe von { $angle }
cloud-strip-wide = Die Punktwolke ist ein { $width } breiter Streifen
cloud-too-large-for-a-gauge = die { $shape ->
        [plane] Ebene
       *[sphere] Kugel
    } durch die Punkte ist { $size } groß
clouds = { $done } von { $clouds_wanted } Punktwolken
clouds-heading = Punktwolken
clouds-rebuilt-every-calibration = Die Punktwolken sind mit jeder Kalibrierung neu berechnet.
clouds-taken-enough = { $done } Punktwolken reichen aus
contact-point-on-gauge = Antastpunkt { $counted } am Prüfnormal.
distance-between-clouds = Abstand zwischen den Punktwolken
distance-between-clouds-centres = Abstand der Mittelpunkte der Punktwolken
distance-fitted-shape-blue-inside-orange-outside = { $name }: Abstand von der eingepassten Form, Blau innen, Orange außen.
distance-touched-centre = Abstand vom angetasteten Mittelpunkt
distance-touched-plane = Abstand von der angetasteten Ebene
drop-cloud = Diese Punktwolke verwerfen
dropping-cloud = Punktwolke wird verworfen
end-cloud = Punktwolke abschließen
error-radius = Radiusabweichung
every-figure-keeps-limit = Alle Kenngrößen halten ihren Grenzwert ein.
expanded-uncertainty-note = U = { $expanded_uncertainty }, k = 2
figure-between-close-limits =
    { $title }: { $value }; die Grenzwerte von ±{ $limit } liegen im Vergleich zum Schutzabstand von { $guard } nahe beieinander: { $decision ->
        [pass] nach der Regel bestanden.
        [fail] nach der Regel nicht bestanden.
       *[uncertain] nicht entschieden.
    }
figure-beyond-guard = { $title }: { $value }, über dem Grenzwert von { $limit }, um mehr als den Schutzabstand von { $guard }.
figure-beyond-limit = { $title }: { $value }, über dem Grenzwert von { $limit }, um mehr als die Unsicherheit von { $uncertainty } (k = 2).
figure-near-guard =
    { $title }: { $value }, näher am Grenzwert von { $limit } als der Schutzabstand von { $guard }: { $decision ->
        [pass] bestanden, da der Anwender die Unsicherheit trägt.
        [fail] nicht bestanden, da der Lieferant die Unsicherheit trägt.
       *[uncertain] nicht entschieden.
    }
figure-near-limit = { $title }: { $value }, näher am Grenzwert von { $limit } als die Unsicherheit von { $uncertainty } (k = 2), daher nicht entschieden.
figure-over-clouds = 
    { $title }: { $of ->
        [mean] Mittelwert
        [range] Spannweite
       *[standard_deviation] Standardabweichung
    }
figure-within-guard = { $title }: { $value }, innerhalb des Grenzwerts von { $limit }, um mehr als den Schutzabstand von { $guard }.
figure-within-limit = { $title }: { $value }, innerhalb des Grenzwerts von { $limit }, um mehr als die Unsicherheit von { $uncertainty } (k = 2).
figure-without-guard =
    { $title }: { $value }, { $how ->
        [beyond] über dem Grenzwert
       *[within] innerhalb des Grenzwerts
    } von { $limit }.
figures-break-limits-not-compared = Nicht alle Kenngrößen halten ihren Grenzwert ein; Scan und Taster wurden nicht verglichen.
figures-keep-limits-not-compared = Alle Kenngrößen halten ihren Grenzwert ein; Scan und Taster wurden nicht verglichen.
figures-undecided-not-compared = Nicht alle Kenngrößen sind für eine Entscheidung genau genug bestimmt; Scan und Taster wurden nicht verglichen.
file-describes-sphere = { $path }: beschreibt eine Kugel
filters-of-figures = Filter: Punkte, die weiter als { $sigmas } Standardabweichungen vom Ausgleich entfernt sind, und Bilder innerhalb von { $place } eines früheren werden nicht verwendet. Für die Form über alle Punkte werden sie verwendet.
finish-cloud-drop = Diese Punktwolke abschließen oder verwerfen.
finish-cloud-first = Zuerst diese Punktwolke abschließen.
form-95-m = Form 95 %, gefiltert, µm
form-all-m = Form 95 % aller, µm
form-all-points-in-gate = Form aller Punkte (95 %)
form-cloud-95-points = Form, gefiltert (95 % der Punkte)
further-cloud-aside-one-other-s =
    { $aside ->
        [one] { $aside } weitere Punktwolke wurde ausgeschlossen.
       *[other] { $aside } weitere Punktwolken wurden ausgeschlossen.
    }
gate-of-plane = Auswahl aller Punkte: die gescannte Fläche, bis { $gate } von der Ebene.
gate-of-sphere = Auswahl aller Punkte: bis { $gate } von der kalibrierten Kugel und bis { $angle } von der Mitte des Scans.
gauge = Prüfnormal
gauge-clamped = Dieses Prüfnormal ist aufgespannt
gauge-shape = { $path }: shape ist { $shape }
gauge-touched-only-shape-size-judged = Das Prüfnormal wurde nicht angetastet: Beurteilt werden nur Form und Größe.
gauge-touched-shape-size-only = das Prüfnormal wurde nicht angetastet: nur Form und Größe
gauges-are-plane-or-sphere = Prüfnormale sind eine Ebene oder eine Kugel
give-gauges-own-nominal = Sollwerte dieses Prüfnormals angeben
give-more-recordings-plane-more-calibrations = Weitere Aufzeichnungen der Ebene oder weitere Kalibrierungen angeben
give-planes-own-nominal = Sollwerte dieser Ebene angeben
go-without-probe = Ohne Taster fortfahren
height-above-touched-plane-along-z = Höhe über der angetasteten Ebene, entlang Z
is-to-be-verified =
    { $shape ->
        [sphere] eine Kugel soll verifiziert werden
       *[plane] eine Ebene soll verifiziert werden
    }
known-m-k-1-form-m = { $certificate }; Standardunsicherheit { $known } (k = 1), Form { $form }
last-cloud-not-evaluated-yet = Die letzte Punktwolke muss noch ausgewertet werden.
least-middle-needed = mindestens { $angle } von ihrer Mitte aus sind nötig
leave-verification-clouds-kept-folder = Diese Verifizierung abbrechen? Ihre Punktwolken bleiben in ihrem Ordner.
limit-mark = Grenzwert
limit-with-expanded-uncertainty = Grenzwert { $limit }; U = { $expanded_uncertainty }, k = 2
limits-judged-by-marked-uncertainty = U: Messunsicherheit des Werts aus Normal, Taster und Punkten. U der Prüfung: Prüfwertunsicherheit allein aus dem Normal und seinem Aufbau (ISO 14253-5), ein Anteil von U. Jeder Grenzwert wird nach der mit{ $mark } gekennzeichneten beurteilt.
map-outliers-or-none = 
    { $points ->
        [0] Kein Punkt liegt weiter ab, als Rauschen erklärt.
        [one] Ringe: { $points } Punkt liegt weiter ab, als Rauschen erklärt.
       *[other] Ringe: { $points } Punkte liegen weiter ab, als Rauschen erklärt.
    } Dicke Ringe: der tiefste und der höchste Punkt, { $low } und { $high }; die Spannweite aller Punkte liegt zwischen ihnen.
measurement-u = U, k = 2
measuring-cloud = Punktwolke wird ausgewertet
measuring-cloud-of-number = Punktwolke { $number } wird ausgewertet
no-cloud-being-scanned = Es wird keine Punktwolke gescannt.
no-cloud-shows-gauge-yet-scan = Noch keine Punktwolke zeigt das Prüfnormal. Eine scannen.
no-cloud-taken-yet = Noch keine Punktwolke aufgenommen.
nominal-is-of =
    { $shape ->
        [sphere] die Sollwerte gehören zu einer Kugel
       *[plane] die Sollwerte gehören zu einer Ebene
    }
none-calibrations-belongs-these-recordings = Keine der Kalibrierungen gehört zu diesen Aufzeichnungen
normal-must-be-of-unit-length = normal muss die Länge 1 haben, nicht { $length }
not-by-standard-other-positions = Nicht normgerecht: Positionen, Gelenkstellungen und Anzahlen nach ISO 10360-8 und ISO 10360-12 werden nicht genau eingehalten; daher wird keines ihrer Formelzeichen verwendet.
not-every-figure-keeps-limit = Nicht alle Kenngrößen halten ihren Grenzwert ein.
not-every-figure-known-well-enough = Nicht alle Kenngrößen sind für eine Entscheidung genau genug bestimmt.
offset-m = Versatz, µm
one-recording-one-calibration-give-one = eine Aufzeichnung und eine Kalibrierung ergeben eine Ebene
over-clouds = Über alle Punktwolken
pass-over-more-gauge = Mehr vom Prüfnormal überfahren
pass-over-several-sides = Aus mehreren Richtungen überfahren
pass-stripe-slowly-each-pass-cloud =
    { $shape ->
        [plane] Laserlinie langsam über das ganze Prüfnormal führen. Jede Überfahrt ist eine eigene Punktwolke.
       *[sphere] Laserlinie langsam von drei Seiten über die Kugel führen. Jede Überfahrt ist eine eigene Punktwolke.
    }
pass-stripe-slowly-over-gauge = Laserlinie langsam über das Prüfnormal führen
pass-stripe-slowly-over-whole-gauge = Laserlinie langsam über das ganze Prüfnormal führen, dann die Punktwolke abschließen.
place-touch = Das ist die Stelle von Antastpunkt { $number }
placed = Lage
plane-needs-both-directions = für eine Ebene sind { $width } in beiden Richtungen nötig
point-known-k-1 = { $name }, Standardunsicherheit eines Punkts { $total } (k = 1)
point-off-surface-left-out = Punkt { $index } liegt { $off } neben der Fläche der übrigen. Er ist ausgeschlossen.
points-not-on-sphere = ihre Punkte liegen nicht auf einer solchen Kugel
points-used = Verwendete Punkte
probe = Taster
put-touch-back = Antastpunkt { $i } wiederherstellen
radius-m = Radius, µm
range-all-m = Spannweite aller, µm
range-all-points-in-gate = Spannweite aller Punkte
rebuilding-clouds-every-calibration = Punktwolken werden mit jeder Kalibrierung neu berechnet
recordings-not-of-one-plane = die Aufzeichnungen sind gegeneinander um bis zu { $angle } gedreht: Sie stammen nicht von einer Ebene, und ihre Spannweiten sind nicht aussagekräftig
residuals-gauge = Residuen am Prüfnormal: { $name }
residuals-on-gauge = Residuen am Prüfnormal
scan-and-probe-errors-in-common-not-shown = Scan und Taster verwenden denselben Messarm: Gemeinsame Abweichungen sind hier nicht zu erkennen.
scan-cloud = Punktwolke { $clouds } scannen
scan-gauge = Prüfnormal scannen
scan-gauge-chosen = Gewähltes Prüfnormal scannen
scan-gauge-chosen-nothing-beside = Nur das gewählte Prüfnormal scannen, nichts daneben
scan-gauge-nothing-beside = Nur das Prüfnormal scannen, nichts daneben.
scan-more-clouds = Weitere Punktwolken scannen
scanned-sphere-has-diameter = Die gescannte Kugel hat einen Durchmesser von { $diameter }
scanning-cloud = Punktwolke { $number } wird gescannt
scatter-of-clouds = Punktwolken
scatter-of-points = Punkte
scatter-points-rms = Streuung der Punkte (rms)
see-result = Ergebnis ansehen
simulation-scans-cloud = Der simulierte Bediener scannt: { $name }, Punktwolke { $done }
simulation-touches-gauge = Der simulierte Bediener tastet an: { $name }
so-centre-known-k-1 = Standardunsicherheit des Mittelpunkts { $centre_sd }, k = 1
so-plane-known-k-1 = Standardunsicherheit der Ebene { $at } und { $arcsec }, k = 1
spread-needs-least-two-clouds = für eine Spannweite sind mindestens zwei Punktwolken nötig
step-before-one = Das ist kein früherer Schritt.
study-compares-several = eine Studie vergleicht mehrere
study-left-out = { $name }: { CLAUSE($reason) }.
study-plane = die Studie bezieht sich auf eine Ebene
test-u = U der Prüfung, k = 2
there-no-gauge-data-folder-yet = Es gibt noch kein Datenblatt eines Prüfnormals.
there-no-map-cloud = Zu Punktwolke { $number } gibt es keine Karte.
there-no-sphere-diameter-cloud = In dieser Punktwolke gibt es keine Kugel mit { $diameter } Durchmesser
there-no-such-cloud = Diese Punktwolke gibt es nicht.
there-no-such-touch = Diesen Antastpunkt gibt es nicht.
there-nothing-verify = Es gibt nichts zu verifizieren
they-do-not-determine-centre = sie legen ihren Mittelpunkt nicht fest
touch-elsewhere = An anderer Stelle antasten
touch-gauge = Prüfnormal antasten
touch-gauge-more-places-scan-more = Prüfnormal an mehr Stellen antasten und langsamer scannen.
touch-more-least-places = Weiter antasten: { $taken } von mindestens { $touches_needed } Stellen.
touch-near-corners-too = Auch nahe den Ecken antasten
touch-probe-press-arms-button-each =
    { $shape ->
        [plane] Mit dem Taster nahe den Ecken und in der Mitte antasten und an jeder Stelle die Taste am Messarm drücken.
       *[sphere] Mit dem Taster oben und ringsum an der Seite antasten und an jeder Stelle die Taste am Messarm drücken.
    }
touch-top-all-around-side = Oben und ringsum an der Seite antasten
touched-sphere-seems-to-have-diameter = Die angetastete Kugel hat anscheinend einen Durchmesser von { $radius }, laut Kalibrierschein { $radius2 }.
touches-agree = Übereinstimmung der Antastpunkte
touches-enough = { $done } Antastpunkte reichen aus
touches-lie-too-near-together-one = Die Antastpunkte liegen zu nah beieinander oder auf einem Ring um die Kugel
touches-lie-within-one-line = Die Antastpunkte liegen innerhalb von { $width } um eine Gerade
touches-rms-known-k-1 = { $touches } Antastpunkte, { $rms } rms, Standardunsicherheit { $known } (k = 1)
uncertainty-budgets = Unsicherheitsbudgets
uncertainty-is-not-the-root-of-its-budget = expanded_uncertainty ist nicht das Doppelte der Wurzel der Quadratsumme seines Budgets
uncertainty-is-root-of-parts = U ist die Wurzel der Quadratsumme seiner Anteile, alle mit k = 2. Prüfnormal: U der Prüfung. Taster: aus den Antastpunkten. Punkte: aus der Streuung der Punkte einer Punktwolke. Punktwolken: aus deren Streuung. Mittelwert, Standardabweichung und Spannweite sind die der Punktwolken.
up-to-taken-one = bis { $rms } sind zulässig
values-shares-their-limits-bar-expanded = Werte im Verhältnis zu ihren Grenzwerten: Der Balken ist die erweiterte Unsicherheit (k = 2), nach der der Grenzwert beurteilt wird, die Kreise sind die einzelnen Punktwolken.
verification-closed-start-new-one = Diese Verifizierung ist abgeschlossen. Eine neue starten.
verification-cloud = Verifizierung, Punktwolke { $number }
verification-gauge =
    { $shape ->
        [sphere] Verifizierung an einer Prüfkugel
       *[plane] Verifizierung an einer Prüfebene
    }
verified = Verifiziert: { $text }
what-clouds-show-against-certificate = Vergleich der Punktwolken mit dem Kalibrierschein des Prüfnormals und mit dem Taster.
what-taken-kept-folder = Alles Aufgenommene bleibt im Ordner der Sitzung.
what-verified = Gegenstand der Verifizierung
wide = { $wide } breit
with-radius = Radius { $radius }
word-plane = Ebene
writing-cloud = Punktwolke wird geschrieben

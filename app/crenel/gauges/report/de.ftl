certificate-valid-until = { $name }, gültig bis { $date }
certified-values = Laut Kalibrierschein
computed-from = Berechnet aus den Antastungen und Scans
deviations-of-places = Abweichungen der 25 Stellen
dispersion-free-centre = 95 %, freier Mittelpunkt
error-arm-joints = Spiel und Geber der Gelenke
error-arm-links = Längen und Winkel der Glieder des Arms
error-clock = Verzögerung zwischen Arm und Sensor
error-hides-in = Zeigt sich kaum in
error-laser-plane = Laserebene, gebogen oder gekippt
error-of = Fehler
error-probe-matrix = Messkopfmatrix, Verschiebung um d falsch
error-sensor-scale = Maßstab des Sensors
error-shows-in = Zeigt sich in
error-stripe-noise = Rauschen des Streifens
error-tip-diameter = Durchmesser der Tastkugel
errors-of-lengths = Längenabweichungen
errors-of-lengths-caption =
    { $count ->
        [one] { $count } Längenabweichung
       *[other] { $count } Längenabweichungen
    } { $by ->
        [scan] durch Scannen
       *[touch] durch Antasten
    } über der Länge; die Aufstellungen nebeneinander. Gestrichelt: die größte zulässige Abweichung. Rot: darüber, mit der Nummer der Aufstellung.
fail = Nicht bestanden
fewest-in-patch = Wenigste je Stelle
first-to-last-group =
    { $first } bis { $last }: { $count ->
        [one] { $count } Gruppe
       *[other] { $count } Gruppen
    }
gate-and-filters = Welche Punkte zählen
hides-arm-joints = Längenabweichungen zwischen Kugeln, die über viele Antastungen mitteln
hides-arm-links = Form einer kleinen Kugel
hides-clock = alle Werte durch Antasten, und langsame Scans
hides-laser-plane = alle Werte durch Antasten
hides-probe-matrix = alle Werte durch Antasten; Form und Streuung einer Kugel, die in einer Orientierung gescannt wurde
hides-sensor-scale = Lage der gescannten Kugel
hides-stripe-noise = Lage und Größe: Sie mitteln über viele Punkte
hides-tip-diameter = Lage, und Längen von Mittelpunkt zu Mittelpunkt
length-standard = Längennormal
location-fixed-diameter = Lage, fester Durchmesser
location-over-articulations = Lage über die Stellungen
no-limit = kein Grenzwert
origin-of-figures = Herkunft der Werte
pass = Bestanden
performance-bars-caption =
    { CAPITAL($title) }, in µm, { $of ->
        [measurement] nach Messung
        [orientation] nach Ausrichtung des Sensors
        [seat] nach Pfanne: 1 nahe der Schulter, 2 in der Mitte, 3 fern
       *[placement] nach Lage des Kugelstabs
    }.{ $limited ->
        [yes] { " " }Gestrichelt: die größte zulässige Abweichung.
       *[no] { "" }
    }
performance-editions = Normen
performance-ended = Beendet
performance-gate-points = Punkte eines Scans nehmen teil, wenn sie höchstens { $shell } von der Oberfläche der kalibrierten Kugel und höchstens { $cone } von ihrem Pol ({ $pole }) entfernt liegen und der Sensor diese Oberfläche unter höchstens { $incidence } zu ihrer Normalen sieht. Alle diese Punkte zählen; keiner wird wegen seines Residuums entfernt.
performance-judged-by-test-uncertainty = U ist die Prüfwertunsicherheit: die von Normal und Aufbau, nicht die Streuung von Arm und Sensor. Diese misst die Prüfung.
performance-patches =
    { $count ->
        [one] { $count } Stelle eines Scans ist der mittlere Abstand
       *[other] { $count } Stellen eines Scans sind die mittleren Abstände
    } aller Punkte innerhalb von { $half } um die Richtungen des Musters.
performance-single-values =
    { $test ->
        [plane] Die Ausrichtungen
       *[contact] Meisterkugel, Pfannen und Lagen
    }
performance-symbol = Symbol
performance-values-against-limits = Werte als Anteile ihrer größten zulässigen Abweichungen, mit der Prüfwertunsicherheit (k = 2) als Balken. Der gefüllte Punkt ist der Wert, der zählt; offene Punkte sind die einzelnen Werte, aus denen er folgt.
plate = Ebenes Normal
points-in-gate = Punkte
points-outside-gate = Punkte außerhalb
shows-arm-joints = Form der angetasteten Kugel; Einzelpunkt-Schwenkprüfung
shows-arm-links = Längenabweichungen; Lage über die Stellungen, durch Antasten wie durch Scannen; Größe, wo sich der Taststift nach außen neigt
shows-clock = Form und Streuung der gescannten Kugel; sie wachsen mit der Scangeschwindigkeit
shows-laser-plane = Form der gescannten Kugel und Ebene; Größe der gescannten Kugel
shows-probe-matrix = Lage der gescannten Kugel: bis 2 d längs einer Achse, die die Stellungen neigen, weniger längs einer, die ihre Richtung behält; ihre Größe, und ihr Abstand von der angetasteten Kugel
shows-sensor-scale = Größe der gescannten Kugel, zu einem Teil
shows-stripe-noise = Streuung von 95 % aller Punkte
shows-tip-diameter = Größe der angetasteten Kugel; wirksamer Durchmesser
so-many-values =
    { $count ->
        [one] { $count } Wert
       *[other] { $count } Werte
    }
sphere-by-certificate = Durchmesser { $diameter }, bekannt auf { $known } (k = 1), Form { $form }
sphere-moved = Bewegt um
sphere-position = Position
undecided = Nicht entschieden
values-in-micrometres = Werte, µm
what-figures-mean = Was die Werte bedeuten
what-figures-mean-text = Jeder Fehler von Arm und Sensor zeigt sich in manchen Werten und bleibt in anderen verborgen. Überschreiten mehrere Werte ihre Grenzen, sagt diese Tabelle, wo zuerst zu suchen ist.
what-tested = Was geprüft wurde
word-fail = nicht bestanden
word-pass = bestanden
word-undecided = nicht entschieden

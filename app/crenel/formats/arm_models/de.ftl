add-dh-row = Geben Sie je Gelenk eine Zeile an, der Reihe nach
angle-beyond-a-turn = darunter steht { $value }, mehr als eine volle Umdrehung im Bogenmaß: Das sind Grad
angles-are-multiples = alle sind Vielfache von π/2, etwa { $value }: Das ist Bogenmaß
angles-called =
    { $unit ->
        [rad] Die Winkel heißen Bogenmaß
       *[deg] Die Winkel heißen Grad
    }
choose-another-end = Wählen Sie ein anderes Ende, oder geben Sie das URDF eines einzelnen Arms an
columns-not-read = Nicht gelesene Spalten: { $names }
decimal-commas-read = Kommas wurden als Dezimalzeichen gelesen.
decimal-signs-mixed = Einige Zahlen haben ein Dezimalkomma ({ $one }), andere einen Dezimalpunkt ({ $other })
dh-cell = Zeile { $line }: { $column } { $value }
dh-column-missing = Keine Spalte für { $names }
dh-column-twice = Zwei Spalten für { $names }
dh-commas-between-cells = Hier stehen Kommas zwischen den Zellen: Schreiben Sie Zahlen mit Dezimalpunkt
dh-needs-four-numbers = jede Zeile braucht a, alpha, d und theta und darf mit dem Namen des Gelenks beginnen
dh-number-expected = erwartet wird eine Zahl, ein Vielfaches von π oder ein Gelenkwinkel wie q1 + 90
dh-row-has-cells =
    { $count ->
        [one] Zeile { $line } hat eine Zelle
       *[other] Zeile { $line } hat { $count } Zellen
    }
dh-rows-missing = Die Zeile von Gelenk { $names } fehlt
dh-rows-out-of-order = Die Zeilen gehören zu den Gelenken { $names }, in dieser Reihenfolge
dh-rows-there = vorhanden sind die Zeilen { $names }
dh-table-has-columns = die Tabelle hat { $count } Spalten
dh-variable-not-an-angle = das Gelenk schiebt: Seine Variable ist eine Länge
expand-xacro = Wandeln Sie es mit xacro DATEI > robot.urdf um, und geben Sie das Ergebnis an
first-row-empty = Länge und Verdrehung der ersten Zeile sind null, die der letzten nicht
flange-row-turns-no-joint = Die Zeile { $name } dreht um kein Gelenk: Sie gilt als feste Transformation hinter dem letzten Gelenk.
give-lengths-of-links = a und d jedes Gelenks eintragen
give-ros-kinematics = Geben Sie die YAML-Datei mit kinematics an, wie der Treiber des Roboters für ROS sie schreibt
give-row-of-each-joint = Geben Sie je Gelenk eine Zeile an; eine Zeile des Flanschs kommt zuletzt und heißt flange
give-unit-of-angles = Wählen Sie die Einheit der Winkel
give-unit-of-lengths = Wählen Sie die Einheit der Längen
give-ur-files = Geben Sie calibration.conf des Arms an, allein oder gefolgt von urcontrol.conf
give-urdf = Geben Sie das URDF des Roboters an, wie ROS es liest
index-before = Längen oder Verdrehungen haben den Index i − 1
last-row-empty = Länge und Verdrehung der letzten Zeile sind null, die der ersten nicht
lengths-add-up = seine Längen ergeben zusammen { $total }, in { $unit } also einen Arm von { $length }
lengths-all-zero = alle Längen sind 0: die Glieder eines Arms haben Längen
lengths-in-unit = In { $unit } gelesen misst der Arm { $length }
limits-not-stated = Der Text nennt keine Grenzen der Gelenke: ±180° wurden eingesetzt.
model-answer-unknown = { $key } kann nicht { $answer } sein
model-leaves-open = { $path } lässt offen, was es bedeutet
model-open = { $key } ({ $options })
model-open-likely = { $key } ({ $options }; wahrscheinlich { $likely }: { $why })
name-dh-columns = Nennen Sie die Spalten in einer ersten Zeile, etwa: joint, a [mm], alpha [deg], d [mm], theta [deg]
no-arm-has-such-lengths = so klein oder groß ist kein Arm
no-dh-table = Der Text enthält keine Denavit-Hartenberg-Tabelle
nominal-is-not-this-arm = Ein Nennmodell passt zu jedem Arm seiner Bauart, und zu keinem genau: Identifizieren Sie Ihren Arm, oder geben Sie seine Werkskalibrierung an.
only-order-with-right-angles = nur in dieser Reihenfolge sind alle Verdrehungen Vielfache von 90°
paste-dh-table = Fügen Sie je Gelenk eine Zeile mit a, alpha, d und theta ein
ros-has-metres = Geben Sie die Längen in Metern an, wie ROS sie hat
ros-link-cannot-be-used = Das Glied { $link } der Kinematik lässt sich nicht verwenden
ros-link-count =
    { $count ->
        [0] es fehlt
       *[other] es steht { $count }-mal da
    }
ros-number =
    { $there ->
        [yes] { $name } ist { $text }; das ist keine Zahl
       *[no] { $name } fehlt
    }
rotary-joints-only = Verwendbar sind Arme mit Drehgelenken
say-what-is-open = Geben Sie für jedes --say KEY=VALUE an
source-dh-table =
    { $rows ->
        [one] Denavit-Hartenberg-Tabelle mit einer Zeile
       *[other] Denavit-Hartenberg-Tabelle mit { $rows } Zeilen
    }
source-nominal-arm = { $name }, nach { $source }
source-robot-of-the-list = Ohne Text: ein Roboter der Liste
source-ros-kinematics = Kinematik eines Arms von Universal Robots, wie ROS dessen Werkskalibrierung aufbewahrt
source-ur-calibration =
    { $calibrated ->
        [yes] Werkskalibrierung eines Arms von Universal Robots
       *[no] Nennmodell eines Arms von Universal Robots (urcontrol.conf)
    }
source-urdf = URDF von { $name }
two-units-of-length = Die Tabelle nennt zwei Einheiten der Länge: { $units }
ur-nominal-only = Der Text hat keine Werkskalibrierung: Die Zeilen delta_theta, delta_a, delta_d und delta_alpha stehen in calibration.conf.
ur-not-calibrated = Nach eigener Angabe der Datei wurde der Arm nicht kalibriert (calibration_status = 0)
ur-row-malformed =
    { $there ->
        [yes] Die Zeile { $name } ist beschädigt
       *[no] Die Zeile { $name } fehlt
    }
ur-six-numbers = erwartet werden sechs Zahlen in Klammern je Zeile
urdf-axis-is-zero = Gelenk { $name }: Seine Achse hat keine Richtung
urdf-branches = Bei Glied { $link } verzweigt sich der Roboter: { $links }
urdf-chain-too-long = Zu Glied { $end } führen { $joints } Drehgelenke: Ein Arm hat fünf bis sieben
urdf-chain-too-short =
    { $joints ->
        [0] Kein Glied des Roboters folgt auf ein Drehgelenk
       *[other] Kein Glied des Roboters folgt auf fünf Drehgelenke: Es sind höchstens { $joints }
    }
urdf-circle = Die Glieder vor { $link } folgen im Kreis aufeinander
urdf-continuous = Endlos drehende Gelenke (continuous) haben die Grenzen ±360°.
urdf-first-link = es ist das erste Glied vor den Gelenken des Arms
urdf-flange = dem Namen nach sitzt dort ein Werkzeug
urdf-has-metres = Geben Sie die Längen eines URDF in Metern an
urdf-is-xacro = Der Text ist ein xacro, aus dem ein URDF entsteht
urdf-joint-cannot-be-used = Gelenk { $joint } zwischen { $base } und { $end } lässt sich nicht verwenden
urdf-joint-follows-not-reported = es folgt Gelenk { $other } (mimic), der Arm meldet seinen Winkel also nicht
urdf-joint-kind =
    { $kind ->
        [prismatic] es schiebt (prismatic)
       *[other] seine Art ist { $kind }
    }
urdf-kinds = der Roboter hat diese Gelenke: { $kinds }
urdf-meshes =
    { $count ->
        [one] Die Datei nennt ein Netz (mesh): Es wird nicht gebraucht und nicht gelesen.
       *[other] Die Datei nennt { $count } Netze (mesh): Sie werden nicht gebraucht und nicht gelesen.
    }
urdf-numbers = Gelenk { $joint }: { $name } ist { $text }
urdf-numbers-expected =
    { $count ->
        [one] erwartet wird eine Zahl
       *[other] erwartet werden { $count } Zahlen, durch Leerzeichen getrennt
    }
urdf-only-end = dort endet der Roboter
urdf-without-joints = Das URDF hat kein Gelenk
write-all-numbers-with-point = Schreiben Sie alle Zahlen mit Dezimalpunkt
xml-is-no-urdf = Der Text ist XML mit dem äußeren Element { $name }; das eines URDF ist robot

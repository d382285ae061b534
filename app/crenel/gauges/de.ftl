against-limits = Vergleich mit den Grenzwerten
arm-temperature = Temperatur des Arms
artefact-missing = der Plan nennt keinen Prüfkörper
artefact-temperature = Temperatur des Prüfkörpers
bar-without-sphere-diameter = die Datei des Kugelstabs nennt keinen Durchmesser seiner Kugeln: sphere_diameter_mm eintragen
begin-again = Neu beginnen
cancel-test = Prüfung abbrechen
clouds-enough = { $clouds_most } Punktwolken genügen.
decision = Entscheidung
figure = Kenngröße
has-touches =
    { $shape ->
        [sphere] Die Kugel hat { $count } Antastpunkte
       *[plane] Die Ebene hat { $count } Antastpunkte
    }
implied-offset = Fehler der Messkopfmatrix, auf den die Mittelpunkte schließen lassen
no-certificate-stated = kein Kalibrierschein angegeben
no-touch-taken-yet = Noch kein Antastpunkt aufgenommen.
only-ball-bars-are-scanned = durch Scannen werden nur die Kugeln eines Kugelstabs gemessen, und dieses Normal hat keine
performance-accept = Prüfung abschließen
performance-all-touched = Alle Stellen dieses Schritts sind angetastet. Weiter.
performance-another-step =
    { $step ->
        [artefact] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Prüfkörper und Grenzwerte“.
        [pattern] Das gehört zu einem anderen Schritt; die Prüfung steht bei „25 Antastungen“.
        [location] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Lage durch Antasten“.
        [scan] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Fünf Scans“.
        [end] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Nochmals antasten“.
        [lengths] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Längen“.
        [plate] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Zwei Scans“.
        [diameter] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Meisterkugel“.
        [seats] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Drei Pfannen“.
        [bar] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Kugelstab“.
        [temperatures] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Temperaturen“.
       *[review] Das gehört zu einem anderen Schritt; die Prüfung steht bei „Ergebnis“.
    }
performance-artefact-is-ready =
    { $test ->
        [lengths] Das Normal ist bereit
        [plane] Die Platte liegt fest
        [contact] Die Prüfkörper sind bereit
       *[other] Die Kugel ist fest
    }
performance-aside-note = { $title }: { $reason }
performance-bar-of-contact-test = Nur die Antastprüfung hat neben der Kugel einen Kugelstab.
performance-begin-scan = Scan beginnen
performance-by-touch-alone = Die Längen dieser Prüfung werden nur durch Antasten gemessen.
performance-cancelled-device = Abgebrochen: Ein Gerät ist ausgefallen.
performance-cancelled-moved = Abgebrochen: Prüfkörper oder Arm hat sich bewegt.
performance-cancelled-operating = Abgebrochen: Bedienfehler, wiederholt.
performance-cancelled-other = Vom Bediener abgebrochen.
performance-cancelled-plan = Abgebrochen: Plan, Kalibrierung oder Einstellungen wurden geändert.
performance-cap-not-below-a = Die Obergrenze B darf nicht kleiner als A sein.
performance-change-temperatures = Temperaturen ändern
performance-choose-artefact =
    { $test ->
        [lengths] Zuerst ein Längennormal wählen.
        [plane] Zuerst eine Platte wählen.
        [contact] Zuerst eine Kugel oder einen Kugelstab wählen.
       *[other] Zuerst eine Kugel wählen.
    }
performance-confirm-temperatures = Temperaturen bestätigen
performance-correct-gauge = Die Datei im Ordner gauges berichtigen oder eine andere wählen.
performance-do-artefact-and-limits =
    { $test ->
        [lengths] Das Längennormal wählen. Sollen die Längen beurteilt werden, A, K und B aus dem Datenblatt eintragen.
        [plane] Die Platte wählen und in den Arbeitsraum des Arms legen. Soll ihre Form beurteilt werden, den Grenzwert eintragen.
        [contact] Meisterkugel und Kugelstab wählen und die Kugel in der Mitte der Reichweite befestigen. Was nicht vorhanden ist, entfällt. Sollen Grenzwerte beurteilt werden, sie aus dem Datenblatt eintragen.
       *[other] Die Prüfkugel wählen und im Arbeitsraum des Arms befestigen. Sollen Grenzwerte beurteilt werden, sie aus dem Datenblatt eintragen.
    }
performance-do-review =
    { $test ->
        [lengths] Die Abweichungen aller Längen gegenüber der zulässigen.
        [plane] Die Form der gescannten Platte: die schmalste Schicht, die 95 % aller Punkte enthält, in der schlechteren Ausrichtung.
        [contact] Wirksamer Durchmesser, Einzelpunkt-Schwenkprüfung und räumliche Länge.
       *[other] Maß, Form und Lage der Kugel durch Antasten, durch Scannen und aus beidem zusammen.
    }
performance-do-temperatures = Die Temperaturen von Prüfkörper und Arm noch einmal messen. Die vom Anfang sind eingetragen: Ändern, was sich geändert hat, dann bestätigen.
performance-drop-scan = Scan verwerfen
performance-dropping-scan = Der Scan wird verworfen
performance-end-scan = Scan beenden
performance-evaluating = Die Kenngrößen werden berechnet
performance-finish-scan-first = Zuerst den laufenden Scan beenden oder verwerfen.
performance-go-on = Weiter
performance-is-closed = Diese Prüfung ist abgeschlossen. Eine neue beginnen.
performance-is-evaluated = Die Kenngrößen werden noch berechnet.
performance-last-error = Abweichung der letzten Länge, { $length }
performance-leave-question = Diese Prüfung abbrechen? Sie bleibt erhalten und wird mit dem Grund aufgeführt.
performance-length-is-confirmed = Die letzte Länge ist mit der ersten Antastung der nächsten oder mit dem ersten Scan bestätigt; ihre Antastungen stehen fest.
performance-let-temperatures-settle =
    { $when ->
        [end] So wird kein Wert entschieden. Die Prüfung wiederholen, sobald die Temperaturen beständig sind.
       *[begin] So wird kein Wert entschieden. Warten, bis sich Prüfkörper und Arm angeglichen haben, dann noch einmal messen.
    }
performance-no-artefact =
    { $test ->
        [lengths] Im Ordner gauges ist noch kein Längennormal.
        [plane] Im Ordner gauges ist noch keine Platte.
        [contact] Im Ordner gauges ist noch weder eine Kugel noch ein Kugelstab.
       *[other] Im Ordner gauges ist noch keine Kugel.
    }
performance-no-scan-runs = Es läuft kein Scan.
performance-no-way-back = Das Gemessene gilt: Nach der ersten Antastung oder dem ersten Scan geht die Prüfung nicht zurück.
performance-only-lengths-have-choice = Nur bei der Längenprüfung kann gewählt werden, ob auch gescannt wird.
performance-other-calibration = Seit Beginn der Prüfung wurde die verwendete Kalibrierung gewechselt.
performance-plan-changed = Der Plan dieser Prüfung wurde geändert, nachdem die Messung begonnen hatte.
performance-plan-is-frozen = Prüfkörper und Grenzwerte stehen seit Beginn der Messung fest.
performance-put-back = Antastung zurückholen
performance-repeat = Prüfung wiederholen
performance-repeat-question = Die Prüfung wiederholen? Dieser Durchgang bleibt erhalten und wird als wiederholt aufgeführt.
performance-run-dropped = Während des Scannens verworfen.
performance-run-repeated = Vom Bediener wiederholt.
performance-scan-bar-first = Zuerst den Stab in dieser Lage scannen.
performance-scanned-length = { $length } (Abweichung { $error })
performance-set-is-invalid = Das Gemessene gehört zum alten Stand und ist als Prüfung ungültig. Neu beginnen; die Daten bleiben erhalten.
performance-settings-changed = Die Einstellungen für Scans wurden geändert, nachdem die Messung begonnen hatte.
performance-simulation-touches =
    { $test ->
        [lengths] Der simulierte Bediener tastet das Längennormal an: { $done } von { $of }
       *[other] Der simulierte Bediener tastet die Kugel an: { $done } von { $of }
    }
performance-standard-lengths =
    { $kind ->
        [step-gauge] Stufenendmaß
       *[other] Stab
    }, { $count ->
        [one] eine Länge, { $longest }
       *[other] { $count } Längen, { $shortest } bis { $longest }
    }
performance-status-no-conformity-claimed = Verfahren nach ISO 10360-12:2016, ISO 10360-8:2013 und ASME B89.4.22-2004, wie im Handbuch von Crenel beschrieben; eine Übereinstimmung mit diesen Normen wird nicht behauptet.
performance-step-artefact = Prüfkörper und Grenzwerte
performance-step-temperatures = Temperaturen
performance-test =
    { $kind ->
        [lengths] Leistungsprüfung: Längen
        [plane] Leistungsprüfung: Ebene
        [contact] Leistungsprüfung: Antastprüfungen
       *[sphere] Leistungsprüfung: eine Kugel
    }
performance-touch-taken =
    { $test ->
        [lengths] Antastung { $count } der Längen
        [contact] Antastung { $count } dieses Schritts
       *[other] Antastung { $count } an der Kugel
    }
performance-touches-taken-back =
    { $count ->
        [one] Eine Antastung wurde vom Bediener zurückgenommen.
       *[other] { $count } Antastungen wurden vom Bediener zurückgenommen.
    }
performance-valid-until = Kalibrierschein gültig bis { $until }
plan-without-artefact =
    { $which ->
        [master] der Plan nennt keine Meisterkugel
        [sphere] der Plan nennt keine Kugel
        [lengths] der Plan nennt kein Längennormal
        [plane] der Plan nennt keine Platte
       *[bar] der Plan nennt keinen Kugelstab
    }
plate-by-certificate = eben auf { $flatness }
put-certificate-into-folder-gauges = Datenblatt eines Prüfnormals oder digitalen Kalibrierschein (DCC) einer Kugel unter Datenblätter hinzufügen.
reasons = Gründe
record-no-longer-in-data-folder = Der Eintrag ist nicht mehr im Datenordner.
sessions-gauge-arm-cannot-read-any = Prüfnormal- oder Armdatei der Sitzung ist nicht mehr lesbar
sphere-of-diameter = Kugel, { $diameter }
take-touch = Antastpunkt aufnehmen
there-no-calibration-use-calibrate-first = Es wird keine Kalibrierung verwendet. Zuerst kalibrieren.
there-no-limit = { $title }: { $value }; kein Grenzwert.
there-no-such-gauge = Dieses Prüfnormal gibt es nicht.
titled-text = { $title }: { $text }
touches = { $done } von { $of } Antastpunkten
undo = Zurücknehmen

arm-is-where-scan-ended = Der Messarm ist, wo der Scan endete
arm-not-held-still = der Messarm war nicht in Ruhe
arm-sends-no-joint-angles = der Messarm sendet keine Gelenkwinkel
arms-data-has-gap-there = die Daten des Messarms haben dort eine Lücke
choose-arm-first-within-sentence = zuerst den Messarm wählen
connecting = { $title } wird verbunden
device-connected = { $title } verbunden
hold-still-again = noch einmal ruhig halten
lost-reconnecting = Verbindung zum Gerät ({ $title }) unterbrochen; sie wird wiederhergestellt
move-tip-to-object = Den Taster an das Objekt setzen, dann den Punkt aufnehmen
moved-turned = In { $duration } um { $moved } bewegt und um { $turned } gedreht
no-arm-model-joints-chosen = es ist kein Armmodell mit { $joint_count } Gelenken gewählt
no-arm-model-poses-chosen = kein Arm ist gewählt, der Posen meldet
no-data = Seit { $silent } keine Daten vom { $title }
no-picture-came-sensor = vom Sensor kam kein Bild
no-picture-came-within = innerhalb von { $limit } kam kein Bild
no-picture-laser-came-within =
    { $state ->
        [on] innerhalb von { $limit } kam kein Bild mit eingeschaltetem Laser
       *[off] innerhalb von { $limit } kam kein Bild mit ausgeschaltetem Laser
    }
nothing-touched-there = er hat sich seither nicht bewegt, der Taster berührt also nichts
off = { $title } ist aus
only-joint-samples-came = nur { $count } Messwerte des Messarms in { $duration } empfangen
picture-being-taken-already = es wird bereits ein Bild aufgenommen
repeat-it = neu aufnehmen
s-driver-failed = Treiber fehlgeschlagen ({ $title }): { $error }
sensor-did-answer-laser-off = Der Sensor hat auf „Laser aus“ nicht geantwortet
sensor-lost-exposure-longer-than = der Sensor ist nicht mehr verbunden, oder seine Belichtung dauert länger
sensor-reports-laser-other-state = der Sensor meldet den entgegengesetzten Zustand des Lasers
sensor-sends-lines-no-pictures = der Sensor sendet Laserlinien und keine Bilder
sensors-laser-cannot-switched-here = der Laser dieses Sensors lässt sich von hier nicht schalten
sent-nothing-opening-again = { $title }: Seit { $silence } keine Daten; das Gerät wird neu geöffnet
set-sensor-send-pictures = den Sensor auf Bilder umstellen oder einen anderen Sensor verwenden
silent-but-there = { $title }: verbunden, wartet auf einen Trigger oder eine Änderung
still = In Ruhe
this-needs-pictures = hierfür wird ein Bild der Kamera benötigt
too-little-arm-data-yet = Noch zu wenig Daten vom Messarm
use-switch-sensor = den Schalter am Sensor verwenden
wait-until-arm-connected-again-nothing = warten, bis der Messarm wieder verbunden ist; es geht nichts verloren
wait-until-back = warten, bis der Sensor wieder verbunden ist
wait-until-connected = warten, bis er verbunden ist
wait-until-sensor-connected-capture-again = warten, bis der Sensor verbunden ist, und neu aufnehmen
waiting-s-first-data = Warten auf die ersten Daten: { $title }

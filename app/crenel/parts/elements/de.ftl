element-calibration-not-there = Die Kalibrierung dieses Scans ist nicht auf dieser Station.
element-cloud-of-other-calibration = Die Wolke wurde nicht mit der Kalibrierung ihres Scans berechnet.
element-frames-without-readings = Neben der Wolke fehlen Stellungen des Messarms.
element-has-few-points = zu wenige Punkte liegen darauf
element-no-shape-stands-out = unter den Punkten fällt keine solche Form auf
element-pick-more-of-it = das Rechteck enger darum ziehen oder mehr davon scannen
element-points-of-several-calibrations = Die Punkte sind von mehreren Kalibrierungen: Was ihre Fehler gemeinsam haben, ist nicht bekannt.
element-scan-without-readings = Neben der Wolke dieses Scans fehlen die Stellungen des Messarms. Dafür cloud.ply mit crenel reconstruct neu berechnen.

add-the-laser = Laser hinzufügen
calibrate = Kalibrieren
connected-arm-has-joints-has-choose = Der angeschlossene Messarm hat { $connected_joints } Gelenke, { $name } hat { $joint_count }. Den angeschlossenen Messarm wählen.
points-of = { $taken } von { $wanted } Punkten
take-point = Punkt aufnehmen

ui-against-the-last-calibration = Gegenüber der letzten Kalibrierung
ui-calibrations-older-versions-no-map = Kalibrierungen aus älteren Versionen enthalten keine Karte.
ui-contact = Antastpunkt
ui-contact-points-rms = Antastpunkte, rms
ui-corner = Ecke
ui-corners-rms = Ecken, rms
ui-depth-range = Tiefenbereich
ui-displacement-scanned-point-since-rms-most = Verschiebung eines gescannten Punkts seit { $name }: { $rms } rms, höchstens { $most }.
ui-edges-rms = Kanten, rms
ui-error-budget = Unsicherheitsbudget
ui-error-budget-k-1 = Unsicherheitsbudget, k = 1
ui-first-calibration-next-one-compared = Dies ist die erste Kalibrierung. Die nächste wird hier mit ihr verglichen.
ui-form = Form
ui-good-up-to-usable-up-to = Gut bis { $good }, brauchbar bis { $usable }.
ui-grey-far-beyond-them-no-statement = Grau: weit außerhalb; dort ist keine Aussage möglich.
ui-hatched-beyond-depths-stripe-covered-labelled = Schraffiert: außerhalb der von der Laserlinie abgedeckten Tiefen. Beschriftet: der größte Wert innerhalb.
ui-largest-residuals = Größte Residuen
ui-laser-plane-rms = Laserebene, rms
ui-left-out-reason = ausgeschlossen: { $reason }
ui-lens-distortion = Verzeichnung
ui-none-yet = noch keine
ui-not-solved-yet = noch nicht berechnet
ui-planes-angle-k-1 = Winkel der Ebene, k = 1
ui-planes-offset-k-1 = Versatz der Ebene, k = 1
ui-points-measuring-volume-moved-rms-most = Punkte im Messvolumen haben sich seit { $name } um { $rms } rms verschoben, höchstens um { $most }.
ui-pose = Pose
ui-probe-matrix-t-flange-sensor = Tastermatrix T_flange_sensor
ui-residual = Residuum
ui-residuals-on-the-object = Residuen am Objekt
ui-row = Zeile
ui-source = Quelle
ui-standard-uncertainty-of-a-scanned-point = Standardunsicherheit eines gescannten Punkts, k = 1
ui-standard-uncertainty-over-picture = Standardunsicherheit eines gescannten Punkts, k = 1, über dem Bild.
ui-stripe = Laserlinie
ui-stripe-lowercase = Laserlinie
ui-term = Koeffizient
ui-the-board-was-not-touched = Die Tafel wurde nicht angetastet.
ui-together = Gesamt
ui-type = Typ
ui-value-at-pixel = { $value } bei { $u }, { $v }
ui-where = Wo

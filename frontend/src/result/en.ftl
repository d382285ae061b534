ui-against-the-last-calibration = Compared with the last calibration
ui-calibrations-older-versions-no-map = Calibrations from older versions have no map.
ui-contact = contact
ui-contact-points-rms = Contact points, rms
ui-corner = corner
ui-corners-rms = Corners, rms
ui-depth-range = Depth range
ui-displacement-scanned-point-since-rms-most = Displacement of a scanned point since { $name }: { $rms } rms, { $most } maximum.
ui-edges-rms = Edges, rms
ui-error-budget = Error budget
ui-error-budget-k-1 = Error budget, k = 1
ui-first-calibration-next-one-compared = This is the first calibration. The next one is compared with it here.
ui-form = Form
ui-good-up-to-usable-up-to = Good up to { $good }, usable up to { $usable }.
ui-grey-far-beyond-them-no-statement = Grey: far outside these depths; no value is stated.
ui-hatched-beyond-depths-stripe-covered-labelled = Hatched: outside the depths that the stripe covered. The label gives the largest value within them.
ui-largest-residuals = Largest residuals
ui-laser-plane-rms = Laser plane, rms
ui-left-out-reason = excluded: { $reason }
ui-lens-distortion = Lens distortion
ui-none-yet = none yet
ui-not-solved-yet = not solved yet
ui-planes-angle-k-1 = Plane's angle, k = 1
ui-planes-offset-k-1 = Plane's offset, k = 1
ui-points-measuring-volume-moved-rms-most = Since { $name }, points in the measuring volume have moved by { $rms } rms, { $most } maximum.
ui-pose = Pose
ui-probe-matrix-t-flange-sensor = Probe matrix T_flange_sensor
ui-residual = Residual
ui-residuals-on-the-object = Residuals on the object
ui-row = Row
ui-source = Source
ui-standard-uncertainty-of-a-scanned-point = Standard uncertainty of a scanned point, k = 1
ui-standard-uncertainty-over-picture = Standard uncertainty of a scanned point, k = 1, over the picture.
ui-stripe = Stripe
ui-stripe-lowercase = stripe
ui-term = Term
ui-the-board-was-not-touched = The board was not touched.
ui-together = Total
ui-type = Type
ui-value-at-pixel = { $value } at { $u }, { $v }
ui-where = Where

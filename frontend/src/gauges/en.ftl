ui-add-a-certificate-dcc = Add a certificate (DCC)
ui-against-the-mean-of-all = relative to the mean of all
ui-against-the-touched-gauge = relative to the touched gauge
ui-also-rebuild-with-the-newer-ones = Also rebuild with the newer ones
ui-angle = Angle
ui-angle-between-the-normals = Angle between the normals
ui-angle-lowercase = angle
ui-articulations = Articulations
ui-band-is-permissible-error = the band is the permissible error
ui-bars-test-value-uncertainty-dashed-limit-as-of-test = Bars: test value uncertainty, k = 2. Dashed: the limit as of each test.
ui-being-measured = being measured
ui-being-scanned = being scanned
ui-beyond-the-chart = beyond the chart
ui-by-scan = By scan
ui-by-scan-takes-three-scans = By scan, each place also takes three scans of the whole bar, after its touches. This is fixed at the first touch.
ui-by-touch = By touch
ui-by-touch-and-by-scan = By touch and by scan
ui-calibration-certificate-dcc = Digital calibration certificate
ui-calibration-good-check-gauge = Check the calibration with a gauge
ui-cancel-the-test = Cancel the test
ui-cancelled = Cancelled
ui-cell-mean-points = each { $size } cell shows the mean of its points
ui-centre-error = Centre error
ui-centre-error-lowercase = centre error
ui-certificate-is-not-signed = The certificate (DCC) is in English and German. It is not signed, and not checked against the schema.
ui-certificate-is-not-utf-8 = { $name } is not a UTF-8 text: choose the certificate as XML.
ui-clamp-gauge-within-arms-reach = Clamp a gauge within the arm's reach.
ui-cloud = Cloud
ui-cloud-n = Cloud { $n }
ui-clouds = Clouds
ui-clouds-and-calibrations = Clouds and calibrations
ui-compared-with-the-probe = compared with the contact points
ui-contact-about = The contact tests of ASME B89.4.22: effective diameter of a master sphere, three seats, and a ball bar in twenty placements. 217 touches, about 40 minutes by hand.
ui-contact-needs = A calibrated master sphere, a conical seat that can be clamped in three places, and a ball bar with a certificate. Sphere or bar can be left out.
ui-contact-points-from-above = Contact points from above
ui-contact-test = Contact tests
ui-contact-test-title = Contact tests
ui-continue-the-test = Continue the test
ui-continue-verification = Continue verification
ui-country-of-the-laboratory = Country, as two letters
ui-dashed = dashed
ui-dashed-is-permissible-error = dashed is the permissible error
ui-decision = Decision
ui-decision-rule-changed-values-comparable = The decision rule changed between these tests; values, uncertainties and limits remain comparable.
ui-deviations-from-the-fitted-shape = Deviations from the fitted shape
ui-distance = Distance
ui-distance-between-the-centres = Distance between the centres
ui-errors-of-length = Errors of length
ui-errors-of-length-by-scan = Errors of length by scan
ui-every-cloud-verification-rebuilt-accepted-calibrations = The station rebuilds every cloud of this verification with each of the { $n } accepted calibrations, in the background. Differences from one calibration to the next come from the calibrations; differences from cloud to cloud come from the arm and the scanning.
ui-fail = Fail
ui-figure = Quantity
ui-figure-over-clouds = 
    { $title }: { $of ->
        [mean] mean
        [range] range
       *[standard_deviation] standard deviation
    } over the clouds
ui-figures = Results
ui-filters-used = Filters: points further than { $sigmas } standard deviations from the fit, and frames within { $place } of an earlier one, are not used; for the form of all points they are.
ui-fitted-plane-outward-positive = from the fitted plane: blue inside, orange outside (positive)
ui-fitted-sphere-outward-positive = from the fitted sphere: blue inside, orange outside (positive)
ui-for-information-without-a-limit = for information, without a limit
ui-form-filtered = Form, filtered
ui-form-of-all = Form of all
ui-from-above-arm-below = From above, the arm below
ui-from-the-side-arm-left = From the side, the arm on the left
ui-gate-of-plane = Gate of all points: the scanned area, within { $gate } of the plane.
ui-gate-of-sphere = Gate of all points: within { $gate } of the calibrated sphere, and { $angle } from the middle of the scan.
ui-gauge = Gauge
ui-how-lengths-are-measured = How the lengths are measured
ui-implied-probe-matrix-error = What the articulations say of the calibration
ui-in-gate = In the gate
ui-include = Include
ui-its-figures-are-left-out = Its figures are left out.
ui-judged-by = Judged by
ui-keep-stripe-gauge-move-slowly-points = Keep the stripe on the gauge and move slowly. Points appear as you pass.
ui-kind-of-test = Kind of test
ui-laboratory = Laboratory
ui-latest-decided = Latest: { $value } ({ $decision }).
ui-left-out-sentence = Excluded:
ui-length-error-by-scan-of = Place { $place }, scan { $repeat }: { $error }
ui-length-error-of = Place { $place }, repeat { $repeat }: { $error }
ui-length-standard = Length standard
ui-length-test = Length test
ui-lengths-and-scans-done-of = { $done } of { $of } lengths touched, { $scanned } of { $scans } scans
ui-lengths-done-of = { $done } of { $of } lengths
ui-lengths-first-text = The length test after ISO 10360 measures calibrated lengths in seven places of the arm's reach: 105 lengths if the standard has five. With a step gauge these are 210 touches, about half an hour by hand.
ui-lengths-largest-error =
    { $count ->
        [one] one length
       *[other] { $count } lengths
    }, largest error { $value }
ui-lengths-need = A ball bar, scale bar or step gauge with a certificate, and a firm support for it in seven places. Seven places, five lengths, three repeats by touch; of a ball bar also by scan.
ui-limit-grows-with-length = A + L/K, at most B; K and B may be left empty
ui-limits-by-the-datasheet = Limits by the datasheet (MPE)
ui-limits-fixed-at-first-touch = A figure without a limit is reported, but not judged. The limits are fixed at the first touch or scan, and kept for the next test.
ui-limits-judged-by-uncertainty-on-bar = The uncertainty drawn on a bar, and named first, is the one that the limit is judged by. U of test: test value uncertainty by the gauge and its set-up alone (ISO 14253-5), for the performance of the scanner. U of measurement: by gauge, probe and the points' scatter, for where the gauge was found; U of test is a part of it.
ui-loading-the-map = Loading the map…
ui-map-appears-after-first-cloud = The map appears here after the first cloud.
ui-map-outliers = 
    { $points ->
        [0] No point is further off than noise explains.
        [one] { $points } point is further off than noise explains (ring; press it).
       *[other] { $points } points are further off than noise explains (rings; press one).
    } The range of all points, { $range }, lies between the bold rings, { $low } and { $high }.
ui-master-sphere = Master sphere
ui-mean = mean { $value }
ui-measurements = Measurements
ui-no-calibration-use-yet-calibrate-first = No calibration is in use yet. Calibrate first.
ui-no-gauge-yet = No gauge yet
ui-no-length-standard-yet = No length standard yet
ui-no-length-yet = no length yet
ui-no-limit = No limit
ui-off-best-fitting-gauge-outward-positive = { $end } from the best-fitting gauge: blue inside, orange outside (positive)
ui-one-position = One
ui-one-sphere = One sphere
ui-orientations = Orientations
ui-outlier-at = 
    { $deviation }{ $end ->
        [highest] { "" }, the highest point of all
        [lowest] { "" }, the lowest point of all
       *[none] { "" }
    }; { $points ->
        [0] no outlier
        [one] one outlier here
       *[other] { $points } outliers here
    }; at X, Y, Z = { $at } { $unit } of the arm; frame { $frame }
ui-pass = Pass
ui-pass-becomes-map-clouds-deviations-gauge = Each pass becomes a map of the cloud's deviations from the gauge.
ui-patch-covered = covered
ui-patch-holds = { $points } points of { $frames } pictures
ui-patch-open = not covered yet
ui-patch-partly = begun
ui-patches-missing = Still missing: { $count } of 25 ({ $patches })
ui-patches-missing-many = Still missing: { $count } of 25
ui-performance-first-text = The one-sphere test after ISO 10360 takes about 25 minutes by hand: 55 touches and five scans of one calibrated sphere.
ui-performance-first-title = Does the instrument keep its datasheet?
ui-performance-needs = A calibrated sphere of at least 10 mm on a firm foot, not the one used for calibration.
ui-place-done = touched
ui-place-next = next
ui-place-tip = tip
ui-placements = Placements
ui-places = Places
ui-plane-about = The form of a scanned plate, an addition to the standards: the plate is scanned twice, with the stripe turned by 90° in between. About five minutes by hand.
ui-plane-needs = A flat plate, 50 mm wide or more, with a certificate of its flatness, matt and firmly supported.
ui-plane-test = Plane
ui-plane-test-title = Plane test
ui-plate-from-above = The plate from above, with the strips of the scan
ui-positions-of-the-sphere = Positions of the sphere
ui-probe = Probe
ui-put-datasheet-plate-sphere-into-folder = Enter a plate or sphere under Datasheets, or add its file or the digital certificate (DCC) of a sphere there. The file holds the nominal size, the certificate and the limits. The gauge appears here at once.
ui-put-length-standard-into-folder = Add the file of a ball bar, scale bar or step gauge under Datasheets; crenel certificate read makes one of a certificate. It appears here at once.
ui-radius-error = Radius error
ui-radius-error-lowercase = radius error
ui-range-of-all = Range of all
ui-range-over-the-calibrations = { $figure }: range over the calibrations
ui-range-over-the-clouds = { $figure }: range over the clouds
ui-reason-device = Device failed
ui-reason-moved = Artefact or arm moved
ui-reason-operating = Operating error
ui-reason-other = Another reason
ui-rebuild-with-calibrations = { $n ->
        [one] Rebuild with the calibration
       *[other] Rebuild with { $n } calibrations
    }
ui-rebuilding-the-clouds = Rebuilding the clouds…
ui-record-of = Record of { $when }
ui-rule-guard =
    Guard band: { $factor } times the standard uncertainty; { $bearer ->
        [supplier] the supplier bears the uncertainty, so that a value closer to its limit fails.
        [user] the user bears the uncertainty, so that a value closer to its limit passes.
       *[prover] whoever has to prove something bears the uncertainty, so that a value closer to its limit is undecided.
    }
ui-rule-named =
    Decision rule: { $name ->
        [guarded-95] acceptance with a guard band for 95 %
        [expanded-k2] acceptance with the expanded uncertainty (k = 2) as guard band
        [simple] simple acceptance
       *[other] { $name }
    }, { $standard }:{ $edition }.
ui-rule-without-guard = No guard band: values are compared directly with their limits, the uncertainty is stated only, and both parties bear its risk.
ui-save-the-certificate = Save the certificate
ui-scan-accepted = accepted
ui-scan-again = Scan again
ui-scan-gauge-plate-sphere = Scan a gauge plate or sphere a few times. The station compares the clouds with the gauge's certificate, and judges them by your limits, including their uncertainty. This takes two minutes.
ui-scan-the-part = Scan the part
ui-scans-of-the-bar-in-place = Scans of the bar in place { $place }
ui-seats = Seats
ui-seen-from-above-arm-below = Seen from above, the arm's base is at the bottom
ui-since-moved-by = Since { $date }: { $change }.
ui-sphere-from-above = The sphere from above
ui-start-the-test = Start the test
ui-start-verification = Start verification
ui-symbols-over-time-appear-after-second-test = Each symbol over time appears here after the second test with the same arm and kind of artefact.
ui-taken-after-few-more-they-drawn = { $n } taken. The drawing appears after a few more.
ui-temperature-of-the-arm = Temperature of the arm
ui-temperature-of-the-artefact = Temperature of the artefact
ui-temperature-uncertainty = Uncertainty of the temperature (k = 2)
ui-temperatures = Temperatures
ui-temperatures-at-the-end = Temperatures at the end
ui-temperatures-at-the-end-why = Filled in as at the beginning. If a value has changed, enter and set it.
ui-temperatures-why = Sizes and lengths are brought to 20 °C by the artefact's temperature; without it, they are taken as at 20 °C. Both are asked for again at the end.
ui-temperatures-why-of-a-plane = The form of a plane does not depend on them. They show whether the conditions were steady: both are asked for again at the end.
ui-test-sphere = Test sphere
ui-test-the-performance = One-sphere test
ui-the-certificate-was-not-added = the certificate was not added
ui-the-map-could-not-be-loaded = The map could not be loaded.
ui-the-same-clouds-with-every-calibration = The same clouds with every calibration
ui-the-sphere-can-be-chosen = This sphere can be chosen for the test.
ui-touch-dots-any-order = Touch the dots in any order.
ui-touch-gauge-plate-sphere-probe-then = Touch a gauge plate or sphere with the arm's tip, then scan it a few times. The station compares the clouds with the gauge's certificate and with the contact points, and judges them by your limits, including their uncertainty. This takes two minutes.
ui-two-positions = Two, as the standard asks
ui-u-from-parts = { $whole }: root of the squares of { $parts }
ui-u-k-2 = U (k = 2)
ui-u-measurement = U
ui-u-part = 
    { $source ->
        [gauge] gauge { $value }
        [probe] probe { $value }
        [points] points { $value }
       *[clouds] clouds { $value }
    }
ui-u-test = U of test
ui-u-test-k-2 = U of test (k = 2)
ui-u-value =
    U{ $by ->
        [test] { " " }of test
        [measurement] { " " }of measurement
       *[other] { "" }
    } = { $value }, k = 2
ui-uncertain = Undecided
ui-uncertainty-budgets = Uncertainty budgets (k = 2): U is the root of the sum of squares of its parts
ui-unusable = unusable
ui-used = Used
ui-verify-again = Verify again
ui-verify-the-calibration = Verify the calibration
ui-why-is-the-test-cancelled = Why is the test cancelled?
ui-without-a-ball-bar = Without a ball bar
ui-without-a-sphere = Without a sphere
ui-z-error = Z error
ui-z-error-in-the-clouds-middle = Z error in the cloud's middle

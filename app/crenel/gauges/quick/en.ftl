accept-verification = Accept this verification
after-few-more-touches = after a few more contact points
angle = Angle, ″
angle-between-clouds = Angle between clouds
angle-touched-plane = Angle to the touched plane
another-calibration-came-into-use-meanwhile = The calibration in use has changed in the meantime. Start again with the new one.
away = it is only { $min } away
belongs-another-step-verification-stands =
    { $step ->
        [gauge] This belongs to another step; the verification is at 'Choose the gauge'.
        [touch] This belongs to another step; the verification is at 'Touch the gauge'.
        [scan] This belongs to another step; the verification is at 'Scan the gauge'.
       *[review] This belongs to another step; the verification is at 'Result'.
    }
cancel-verification = Cancel the verification
centre-m = Centre, µm
certificate-named = certificate { $certificate }
check-chosen-gauge-tip-arms-own = Check that this is the selected gauge, and that the mounted tip is the arm's own.
choose-gauge = Choose the gauge
choose-gauge-first = Choose the gauge first.
choose-gauge-scanned = Choose the gauge that was scanned
chosen-gauge-has = the selected gauge has { $diameter }
clamp-firmly-within-arms-reach-sphere = Clamp it firmly within the arm's reach. A sphere reveals more; a plane is quicker.
clean-gauge-tip-check-clamps-verify = Clean gauge and tip, check the clamps, and verify again; then calibrate again.
cloud-being-scanned-already = A cloud is already being scanned.
cloud-check-shape-and-unit = Give the cloud of the gauge alone, its shape, and its unit (--unit)
cloud-cloud = { $title }, cloud by cloud.
cloud-covers-little = { $file }: the points cover { $share } of the sphere, so that its radius is known to ± { $uncertainty } (k = 2). Scan more of the sphere
cloud-exact = { $used } of { $points } points lie on one { $shape ->
        [plane] plane
       *[sphere] sphere
    } exactly, as no measured points do, and the others off it
cloud-exact-remedy = Leave out points that were not measured, and check the columns (--columns)
cloud-has-points = The cloud has { $points } points
cloud-in-other-coordinates = { $file } lies { $distance } from the nominal: it is in other coordinates, and errors of its place are not stated
cloud-is-a-line = { $file }: most of its points lie in a strip of { $length } × { $width }: they hardly determine a plane. Scan more of the plate
cloud-left-out-deleted = { $file }: { $points } points are marked as deleted and are left out
cloud-left-out-missing = { $file }: { $points } points were not measured and are left out: they are at 0, 0, 0 or at another place that stands for none
cloud-left-out-repeated = { $file }: { $points } points repeat others exactly and are left out
cloud-no-points-lie-rms-off =
    { $shape ->
        [sphere] The cloud is not a sphere (its points deviate by { $rms } rms)
       *[plane] The cloud is not a plane (its points deviate by { $rms } rms)
    }
cloud-no-use = Cloud { $number } cannot be used.
cloud-of-another-shape = { $file }: the points lie { $rms } (rms) about the { $shape ->
        [plane] plane
       *[sphere] sphere
    }: they are hardly of one. Give the cloud of the gauge alone
cloud-of-another-unit = { $file } has the nominal radius if its unit is { $unit }. Give --unit { $unit }
cloud-of-odd-size = { $file } is { $size } large if its unit is { $unit }. State the unit with --unit m, mm or inch
cloud-points-not-of-plane = { $left_out } of the points of cloud { $number } do not belong to the plane.
cloud-rms-about-gauge = Cloud { $number }: { $rms } rms about the gauge.
cloud-shows-cap-sphere = The cloud covers a cap of { $angle } of the sphere
cloud-strip-wide = The cloud is a strip only { $width } wide
cloud-too-large-for-a-gauge = the { $shape ->
        [plane] plane
       *[sphere] sphere
    } through the points is { $size } large
clouds = { $done } of { $clouds_wanted } clouds
clouds-heading = Clouds
clouds-rebuilt-every-calibration = The clouds have been rebuilt with every calibration.
clouds-taken-enough = { $done } clouds are sufficient
contact-point-on-gauge = Contact point { $counted } on the gauge.
distance-between-clouds = Distance between clouds
distance-between-clouds-centres = Distance between the centres of the clouds
distance-fitted-shape-blue-inside-orange-outside = { $name }: distance from its fitted shape, blue inside, orange outside.
distance-touched-centre = Distance from the touched centre
distance-touched-plane = Distance from the touched plane
drop-cloud = Discard this cloud
dropping-cloud = Discarding the cloud
end-cloud = End the cloud
error-radius = Radius error
every-figure-keeps-limit = Every figure is within its limit.
expanded-uncertainty-note = U = { $expanded_uncertainty }, k = 2
figure-between-close-limits =
    { $title }: { $value }; the limits of ±{ $limit } lie close together compared with the guard band of { $guard }: { $decision ->
        [pass] passes by the rule.
        [fail] fails by the rule.
       *[uncertain] undecided.
    }
figure-beyond-guard = { $title }: { $value }, beyond the limit of { $limit } by more than the guard band of { $guard }.
figure-beyond-limit = { $title }: { $value }, beyond the limit of { $limit } by more than its uncertainty of { $uncertainty } (k = 2).
figure-near-guard =
    { $title }: { $value }, closer to the limit of { $limit } than the guard band of { $guard }: { $decision ->
        [pass] passes, as the user bears the uncertainty.
        [fail] fails, as the supplier bears the uncertainty.
       *[uncertain] undecided.
    }
figure-near-limit = { $title }: { $value }, closer to the limit of { $limit } than its uncertainty of { $uncertainty } (k = 2): undecided.
figure-over-clouds = 
    { $title }: { $of ->
        [mean] mean
        [range] range
       *[standard_deviation] standard deviation
    }
figure-within-guard = { $title }: { $value }, within the limit of { $limit } by more than the guard band of { $guard }.
figure-within-limit = { $title }: { $value }, within the limit of { $limit } by more than its uncertainty of { $uncertainty } (k = 2).
figure-without-guard =
    { $title }: { $value }, { $how ->
        [beyond] beyond
       *[within] within
    } the limit of { $limit }.
figures-break-limits-not-compared = Not every figure is within its limit; scan and probe were not compared.
figures-keep-limits-not-compared = Every figure is within its limit; scan and probe were not compared.
figures-undecided-not-compared = Not every figure is determined well enough for a decision; scan and probe were not compared.
file-describes-sphere = { $path }: it describes a sphere
filters-of-figures = Filters: points further than { $sigmas } standard deviations from the fit, and frames within { $place } of an earlier one, are not used. For the form over all points they are.
finish-cloud-drop = Finish this cloud, or discard it.
finish-cloud-first = Finish this cloud first.
form-95-m = Form 95 %, filtered, µm
form-all-m = Form 95 % of all, µm
form-all-points-in-gate = Form of all points (95 %)
form-cloud-95-points = Form, filtered (95 % of the points)
further-cloud-aside-one-other-s =
    { $aside ->
        [one] { $aside } further cloud was excluded.
       *[other] { $aside } further clouds were excluded.
    }
gate-of-plane = Gate of all points: the scanned area, within { $gate } of the plane.
gate-of-sphere = Gate of all points: within { $gate } of the calibrated sphere, and { $angle } from the middle of the scan.
gauge = Gauge
gauge-clamped = This gauge is clamped
gauge-shape = { $path }: shape is { $shape }
gauge-touched-only-shape-size-judged = The gauge was not touched: only its shape and size are assessed.
gauge-touched-shape-size-only = the gauge was not touched: shape and size only
gauges-are-plane-or-sphere = a gauge is a plane or a sphere
give-gauges-own-nominal = Give the nominal of this gauge
give-more-recordings-plane-more-calibrations = Give more recordings of the plane, or more calibrations
give-planes-own-nominal = Give the nominal of the plane
go-without-probe = Continue without contact points
height-above-touched-plane-along-z = Height above the touched plane, along Z
is-to-be-verified =
    { $shape ->
        [sphere] the gauge to be verified is a sphere
       *[plane] the gauge to be verified is a plane
    }
known-m-k-1-form-m = { $certificate }; uncertainty { $known } (k = 1), form { $form }
last-cloud-not-evaluated-yet = The last cloud is not evaluated yet.
least-middle-needed = at least { $angle } from its centre are required
leave-verification-clouds-kept-folder = Cancel this verification? Its clouds are kept in its folder.
limit-mark = limit
limit-with-expanded-uncertainty = limit { $limit }; U = { $expanded_uncertainty }, k = 2
limits-judged-by-marked-uncertainty = U: measurement uncertainty of the value by gauge, probe and points. U of test: test value uncertainty by the gauge and its set-up alone (ISO 14253-5), which is a part of U. Each limit is judged by the one marked with{ $mark }.
map-outliers-or-none = 
    { $points ->
        [0] No point is further off than noise explains.
        [one] Rings: { $points } point is further off than noise explains.
       *[other] Rings: { $points } points are further off than noise explains.
    } Bold rings: the lowest and the highest point, { $low } and { $high }; the range of all points lies between these.
measurement-u = U, k = 2
measuring-cloud = Measuring the cloud
measuring-cloud-of-number = Measuring cloud { $number }
no-cloud-being-scanned = No cloud is being scanned.
no-cloud-shows-gauge-yet-scan = No cloud covers the gauge yet. Scan one.
no-cloud-taken-yet = No cloud has been scanned yet.
nominal-is-of =
    { $shape ->
        [sphere] the nominal is that of a sphere
       *[plane] the nominal is that of a plane
    }
none-calibrations-belongs-these-recordings = None of the calibrations belongs to these recordings
normal-must-be-of-unit-length = normal must be of unit length, not { $length }
not-by-standard-other-positions = Not according to a standard: positions, articulations and counts differ from those of ISO 10360-8 and ISO 10360-12, so none of their symbols is used.
not-every-figure-keeps-limit = Not every figure is within its limit.
not-every-figure-known-well-enough = Not every figure is determined well enough for a decision.
offset-m = Offset, µm
one-recording-one-calibration-give-one = one recording and one calibration give one plane
over-clouds = Over the clouds
pass-over-more-gauge = Pass over more of the gauge
pass-over-several-sides = Pass over the gauge from several sides
pass-stripe-slowly-each-pass-cloud =
    { $shape ->
        [plane] Pass the stripe slowly over the whole gauge. Each pass is a cloud of its own.
       *[sphere] Pass the stripe slowly over the sphere from three sides. Each pass is a cloud of its own.
    }
pass-stripe-slowly-over-gauge = Pass the stripe slowly over the gauge
pass-stripe-slowly-over-whole-gauge = Pass the stripe slowly over the whole gauge, then end the cloud.
place-touch = This is the position of contact point { $number }
placed = Position
plane-needs-both-directions = a plane requires { $width } in both directions
point-known-k-1 = { $name }, uncertainty of a point { $total } (k = 1)
point-off-surface-left-out = Point { $index } is { $off } off the surface of the others. It is excluded.
points-not-on-sphere = its points do not lie on such a sphere
points-used = Points used
probe = Probe
put-touch-back = Restore contact point { $i }
radius-m = Radius, µm
range-all-m = Range of all, µm
range-all-points-in-gate = Range of all points
rebuilding-clouds-every-calibration = Rebuilding the clouds with every calibration
recordings-not-of-one-plane = the planes of the recordings differ by up to { $angle }: they are not the same plane, and their ranges mean nothing
residuals-gauge = Residuals of { $name } on the gauge
residuals-on-gauge = Residuals on the gauge
scan-and-probe-errors-in-common-not-shown = Scan and probe share the arm: errors common to both do not appear here.
scan-cloud = Scan cloud { $clouds }
scan-gauge = Scan the gauge
scan-gauge-chosen = Scan the selected gauge
scan-gauge-chosen-nothing-beside = Scan the selected gauge, and nothing beside it
scan-gauge-nothing-beside = Scan the gauge, and nothing beside it.
scan-more-clouds = Scan more clouds
scanned-sphere-has-diameter = The scanned sphere has a diameter of { $diameter }
scanning-cloud = Scanning cloud { $number }
scatter-of-clouds = Clouds
scatter-of-points = Points
scatter-points-rms = Scatter of the points (rms)
see-result = See the result
simulation-scans-cloud = The simulated operator scans the { $name }, cloud { $done }
simulation-touches-gauge = The simulated operator touches the { $name }
so-centre-known-k-1 = uncertainty of the centre { $centre_sd }, k = 1
so-plane-known-k-1 = uncertainty of the plane { $at } and { $arcsec }, k = 1
spread-needs-least-two-clouds = a range requires at least two clouds
step-before-one = That is not an earlier step.
study-compares-several = a study compares several
study-left-out = { $name }: { CLAUSE($reason) }.
study-plane = the study is that of a plane
test-u = U of test, k = 2
there-no-gauge-data-folder-yet = There is no datasheet of a gauge yet.
there-no-map-cloud = There is no map of cloud { $number }.
there-no-sphere-diameter-cloud = There is no sphere of { $diameter } diameter in this cloud
there-no-such-cloud = There is no such cloud.
there-no-such-touch = There is no such contact point.
there-nothing-verify = There is nothing to verify
they-do-not-determine-centre = they do not determine its centre
touch-elsewhere = Touch it elsewhere
touch-gauge = Touch the gauge
touch-gauge-more-places-scan-more = Touch the gauge at more positions, and scan it more slowly.
touch-more-least-places = Touch more points: { $taken } of at least { $touches_needed }.
touch-near-corners-too = Touch it near its corners as well
touch-probe-press-arms-button-each =
    { $shape ->
        [plane] Touch it with the probe near its corners and in its middle, and press the arm's button at each point.
       *[sphere] Touch it with the probe on its top and all around its side, and press the arm's button at each point.
    }
touch-top-all-around-side = Touch its top and all around its side
touched-sphere-seems-to-have-diameter = The touched sphere measures { $radius } in diameter, but its certificate states { $radius2 }.
touches-agree = Agreement of contact points
touches-enough = { $done } contact points are sufficient
touches-lie-too-near-together-one = The contact points are too close together, or on one ring around the sphere
touches-lie-within-one-line = The contact points lie within { $width } of one line
touches-rms-known-k-1 = { $touches } contact points, { $rms } rms, uncertainty { $known } (k = 1)
uncertainty-budgets = Uncertainty budgets
uncertainty-is-not-the-root-of-its-budget = expanded_uncertainty is not twice the root of the sum of squares of its budget
uncertainty-is-root-of-parts = U is the root of the sum of squares of its parts, all with k = 2. Gauge: U of test. Probe: of the contact points. Points: by the scatter of the points of a cloud. Clouds: by their scatter. Mean, standard deviation and range are over the clouds.
up-to-taken-one = the limit is { $rms }
values-shares-their-limits-bar-expanded = Values relative to their limits: the bar is the expanded uncertainty (k = 2) that the limit is judged by, circles are the single clouds.
verification-closed-start-new-one = This verification is closed. Start a new one.
verification-cloud = Verification, cloud { $number }
verification-gauge =
    { $shape ->
        [sphere] Verification on a gauge sphere
       *[plane] Verification on a gauge plane
    }
verified = Verified: { $text }
what-clouds-show-against-certificate = The clouds compared with the gauge's certificate and with the probe.
what-taken-kept-folder = All recorded data is kept in its folder.
what-verified = What was verified
wide = { $wide } wide
with-radius = radius { $radius }
word-plane = plane
writing-cloud = Writing the cloud

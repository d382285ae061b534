across-mm = across, mm
after = After
after-mark = after
against-use-before-points-measuring-volume = Compared with { $name }, in use before: points of the measuring volume moved by { $rms } ({ $rms_mm }) rms, { $largest } ({ $largest_mm }) at most.
arm-by-its-datasheet = the arm is that of its datasheet
arm-check = Arm check
arm-check-uncertainty-is-zero = Applied to (max − min)/2 of each axis with an uncertainty of zero, as the contribution of the form of seat and tip is not stated: the value is compared directly with its limit. The figures in space are stated without a limit.
arms-parameters = The arm's parameters
axes = Axes
ball-bars = Ball bars
before = Before
before-after-identification = Before and after the identification
before-mark = before
behind = from behind
beyond-limit = Beyond the limit
block-certificate = Certificate of the block
block-certified-by-readings =
    { $count ->
        [one] Coordinates by one reading; the largest standard uncertainty is { $largest } (k = 1).
       *[other] Coordinates by least squares from { $count } readings; the largest standard uncertainty is { $largest } (k = 1).
    }
block-certified-by-touches = Coordinates by least squares from { $touches } touches and { $readings } readings; the largest standard uncertainty is { $largest } (k = 1).
calibrated = Calibrated
calibrated-distance-camera = Calibrated distance from the camera
calibration-acceptance-test-no-characteristic-iso = This is a calibration, not an acceptance test: no characteristic of ISO 10360-8 or ISO 10360-12 is claimed. A verification on gauges tests the scanner.
calibration-not-accepted-at-station = This calibration was not accepted at a station.
calibration-report = Calibration report
change = Change
coefficient = Coefficient
contact-points-heading = Contact points
contact-points-label = Contact points
contacts-rms =
    Contact points, rms of { $count ->
        [one] { $count } point
       *[other] { $count } points
    }
contacts-rms-outliers = Contact points, rms of { $count } points, { $outliers } excluded
coordinate = Coordinate
coordinates = Coordinates
coordinates-held-out = Measured coordinates, cross-validated
corners-px = Corners, px
corners-rms = Corners, rms
correlated-known-together = Correlated: well determined together, less well each alone
decision-rule-limits-set-standard-uncertainty = Decision rule: the limits apply to the standard uncertainty itself, which is compared with them directly, without a guard band.
depth-mm = depth, mm
diameter-of-tip-by-datasheet = Tip diameter from the datasheet
diameter-tip-found = Measured tip diameter
distance-each-touch-face-times-larger = Distance of each contact point from its face, magnified { $factor } times: blue inside, orange outside, crosses excluded. The longest line is { $largest } ({ $largest_mm }).
distance-each-touch-sphere-through-all = Distance of each contact point from the sphere fitted to those that agree.
distortion = Distortion
do-not-use = Do not use
each-point-swing-about-middle-all = Each point of the swing relative to the mean of all points, in the arm frame.
each-touchs-distance-sphere = Distance of each contact point from the sphere
edges-corners-rms = Edges and corners, rms
edges-px = Edges, px
end-name = End the name with .html or .pdf
error = Diameter error
error-budget = Error budget
error-budget-with-limits = Sources of the standard uncertainty (k = 1) of a scanned point. Limits: good up to { $good }, usable up to { $usable }.
excluded-because-within-sentence = excluded: { $reason }
face = Face
face-of-block = Face
faces-as-touched = Faces as touched
file-carries-no-verdict = The file contains no verdict.
findings = Findings
flange-frame-of-this-arm-former-calibrations-not-valid = The flange frame is now that of this arm: calibrations made with the previous arm do not apply to it.
flatness-of-touches = Flatness
focal-length = Focal length
focal-lengths = { $u } × { $v }
folder-their-own = from a folder of their own
form-max-min-m = Form (max − min), µm
form-of-faces-is = Flatness is the range of the touches about their own least-squares plane; out of parallel is what this plane rises over the touched area against the axis of the block. Three touches show no form.
from = From
front = from the front
good-m-usable-m = good ≤ { $good }, usable ≤ { $usable }
good-up-m = good up to { $limit }
held-out-places-fit-did-see = Cross-validation on { $places } places that the fit did not use, { $how }; the encoders' noise is included. In standard deviations of the points: { $before } before and { $after } after, where 1 is noise alone.
held-out-turn = each left out in turn
holds-no-record-one = it contains no record
how-arm-swung = Swing of the arm
identification-arm = Identification of the arm
identified = Identified
identify-arm-folders-again = Run the identification again with the folder's { $arm }
inner-corners-mm-apart = { $columns } × { $rows } inner corners, { $square } apart, { $known }
joint = Joint
joint-adjustment-all-poses = joint adjustment of all poses
known-k-1 = uncertainty { $known } (k = 1)
largest-distance-from-mean = Largest distance from the mean, in space
largest-distance-touch-sphere = Largest distance of a contact point from the sphere
laser-plane = Laser plane
laser-stripe-sensor-measuring-arm = Laser stripe sensor on a measuring arm
laser-wavelength = laser { $wavelength }
lengths-ball-bars-held-out = Lengths of ball bars, cross-validated
limit-k-1 = Limit, k = 1
max-min-2-along = (max − min)/2 along { $axis }
measured-channel = measured: { $channel }
measuring-arm = Measuring arm
merged-in-frame-of-arm-not-moved = All points are in the frame of the arm. If arm or part was moved between the scans, they do not fit: a comparison of two scans shows by how much.
merged-of = Made of
merged-with-own-calibrations = The scans were taken with different calibrations; the points of each are by its own.
method = Method
n-2-along = 2σ along { $axis }
n-2-encoders-alone = 2σ by the encoders alone, { $axis }
name-folder-calibration-check-verification-has = Name the folder of a calibration, a check, a verification or a performance test: it contains one of { $files }
named-value = { $name } { $value }
no-limit-set-identification-check-arm = No limit applies to an identification: an arm check assesses it.
none-significant = none was significant
none-yet = none yet
not-by-standard-one-seat = Not according to a standard: one seat and a continuous swing instead of the positions and points of ASME B89.4.22 or ISO 10360-12. No result of these standards is claimed.
not-by-standard-other-touches = Not according to a standard: the contact points are not those of the sphere tests of ISO 10360-12, so none of its symbols is used.
not-judged = Not assessed
object-off-m = Object deviation, µm
one-pose-faugeras-contact-alignment = one pose (Faugeras, contact alignment)
origin-mm = Origin, mm
out-of-parallel = Out of parallel
over-reach-before-difference-arm-identified = Over the reach. Before: the difference from the identified arm. After: the standard uncertainty, k = 1.
over-reach-tip-off-rms-now = Over the reach the tip error was { $before } rms; the standard uncertainty is now { $after } (k = 1).
parameter = Parameter
parameters = Parameters
picture-of-cloud = Picture of the cloud
picture-of-cloud-seen-from = { $name }, from above and in front, coloured by height.
plane-equation = ({ $x }, { $y }, { $z }) · x = { $offset }
plane-swept-straight-across-angle = Plane scanned in one straight pass: angle
point-expanded-uncertainty = Scanned point, rms over the measuring volume: expanded uncertainty
point-judged-with-guard =
    For a feature given by a single scanned point, the guard band is { $guard } ({ $guard_mm }): { $bearer ->
        [supplier] the feature conforms only if the point lies inside its tolerance by more.
        [user] the feature fails only if the point lies outside its tolerance by more.
       *[prover] conformance is proven if the point lies inside its tolerance by more, nonconformance if it lies outside by more.
    }
point-judged-without-guard = A feature given by a single scanned point conforms if the point lies inside its tolerance.
point-standard-uncertainty = Scanned point, rms over the measuring volume: standard uncertainty
pose = Pose
pose-found-minus-computed-times-larger =
    Pose { $number }: measured minus computed, magnified { $factor } times; corners yellow, at most { $largest }; stripe red. { $fitted ->
        [corners] Corners { $rms }
       *[edges] Edges { $rms }
    }, stripe { $stripe_rms } rms.
pose-residuals-corners-without-stripe =
    Pose { $number }: measured minus computed, magnified { $factor } times; corners yellow, at most { $largest }; no stripe. { $fitted ->
        [corners] Corners { $rms }
       *[edges] Edges { $rms }
    } rms.
poses-heading = Poses
poses-measured =
    { $points ->
        [one] { $points } point
       *[other] { $points } points
    } in { $frames ->
        [one] { $frames } frame
       *[other] { $frames } frames
    }
poses-touches = Poses and contact points
positions =
    { $bars } in { $positions ->
        [one] { $positions } position
       *[other] { $positions } positions
    }
principal-point = Principal point
principal-point-at = { $u }, { $v }
probe-matrix-sensors-frame-arms-last = Probe matrix: the sensor frame in the frame of the arm's last joint.
reading-minus-fit = Reading − fit
reading-of-certificate = Reading
readings-agree = Readings agree
readings-of-certificate = Readings
report-cannot-written = a report cannot be written as '{ $suffix }'
report-customer = Customer
report-duration = Duration
report-name = Name
report-number = Number
report-order = Order
report-part = Part
report-pictures = Pictures
report-point-uncertainty = Scanned point
report-scan = Scan
report-serial-number = Serial number
residuals-contacts-object = Residuals of the contact points on the object
residuals-image = Residuals in the pictures
residuals-image-worst-poses = Residuals in the pictures (the { $count } of { $used } poses that fit worst)
residuals-object = Residuals on the object
residuals-pose-picture = Residuals of pose { $number } in its picture
result-rms = Result, rms
rms-before-after-each-pair-scale = Rms before and after; each pair has its own scale.
same-offset = Plane scanned in one straight pass: offset
says-nothing-identification = { $folder } contains no identification
scan-complete = Complete
scan-ended-early = Ended early
scan-frames-lost =
    { $count ->
        [one] { $count } picture was lost.
       *[other] { $count } pictures were lost.
    }
scan-frames-too-fast =
    { $count ->
        [one] { $count } picture was taken too fast: its points are blurred along the pass.
       *[other] { $count } pictures were taken too fast: their points are blurred along the pass.
    }
scan-frames-without-points =
    { $count ->
        [one] { $count } picture with a line gave no points.
       *[other] { $count } pictures with a line gave no points.
    }
scan-has-points =
    { $count ->
        [one] { $count } point.
       *[other] { $count } points.
    }
scan-incomplete = Incomplete
scan-report = Scan report
scatter-coordinates-beyond-uncertainty = Scatter of coordinates beyond the stated uncertainty
scatter-single-points-beyond-encoders = Scatter of single points beyond the encoders
seats-held-out = Seats, cross-validated
sphere-known-to = Ø { $diameter }, uncertainty { $known } (k = 1)
sphere-of-unknown-uncertainty = Ø { $diameter }, uncertainty not stated
spheres-held-out = Spheres, cross-validated
standard-uncertainty-k-1 = u, k = 1
standard-uncertainty-k-1-scanned-point = Standard uncertainty (k = 1) of a scanned point over the laser plane, from { $low } ({ $low_mm }) to { $high } ({ $high_mm }). Struck through: extrapolated, nearer to or further from the camera than the calibrated { $near } to { $far }.
stripe-about-laser-plane-rms-points =
    Stripe about the laser plane, rms of { $points ->
        [one] { $points } point
       *[other] { $points } points
    }
stripe-px = Stripe, px
swing = Swing
swing-about-middle-limit = Each point of the swing relative to the mean of all points, in the arm frame. Dashed: the limit of { $limit }.
tip-check = Tip check
tip-held-seat-moved-max-min = The tip in a seat moved by { $worst }, (max − min)/2 on the worst axis.
tip-in-seat-moved-limit = The tip in a seat moved by { $worst }, (max − min)/2 on the worst axis; the limit is { $limit }.
tip-known-without-size = Over the reach the tip error was { $before } rms; the standard uncertainty is now { $after } (k = 1), without the arm's scale.
tip-off-place-arm = Tip offset from its position on the arm
tip-over-whole-reach = Tip over the whole reach
tip-rule-applies-to-error-alone = The rule applies to the diameter error. The scatter is compared directly with its limit.
tips-places = Tip positions
tips-places-about-their-middle = Tip positions relative to their mean
to = To
together = Together
tool-found = { $value }, uncertainty { $known } (k = 1)
tool-of-reading = Tool
touches-about-sphere-limit = Distance of each contact point from the sphere fitted to all of them. Dashed: the limit of { $limit }.
touches-of-face = Touches
two-s-of-distances = 2 s of these distances
uncertainty-over-measuring-volume = Uncertainty over the measuring volume
unchanged = Unchanged
unit = Unit
usable-attention = Usable, with attention
used-but-within-sentence = used, but { $reason }
what-calibrated = What was calibrated
what-checked = What was checked
what-identified = What was identified
what-standard-uncertainty-k-1-scanned = Sources of the standard uncertainty (k = 1) of a scanned point.
why = Why
with-tip = tip { $diameter }
within-limit = Within the limit
word-no = no
word-used = used

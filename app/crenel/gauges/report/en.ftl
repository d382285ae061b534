certificate-valid-until = { $name }, valid until { $date }
certified-values = By certificate
computed-from = Computed from the touches and scans
deviations-of-places = Deviations of the 25 places
dispersion-free-centre = 95 %, free centre
error-arm-joints = play and encoders of the joints
error-arm-links = lengths and angles of the arm's links
error-clock = delay between arm and sensor
error-hides-in = Hardly shows in
error-laser-plane = laser plane, bent or tilted
error-of = Error
error-probe-matrix = probe matrix, translation off by d
error-sensor-scale = scale of the sensor
error-shows-in = Shows in
error-stripe-noise = noise of the stripe
error-tip-diameter = diameter of the tip
errors-of-lengths = Errors of length
errors-of-lengths-caption =
    { $count ->
        [one] { $count } error of length
       *[other] { $count } errors of length
    } { $by ->
        [scan] by scan
       *[touch] by touch
    } over the length; places side by side. Dashed: the maximum permissible error. Red: beyond it, with the number of the place.
fail = Fail
fewest-in-patch = Fewest at a place
first-to-last-group =
    { $first } to { $last }: { $count ->
        [one] { $count } group
       *[other] { $count } groups
    }
gate-and-filters = Points that take part
hides-arm-joints = errors of length between spheres, which average over many touches
hides-arm-links = form of a small sphere
hides-clock = all figures by touch, and slow scans
hides-laser-plane = all figures by touch
hides-probe-matrix = all figures by touch; form and dispersion of a sphere scanned with one orientation
hides-sensor-scale = location of the scanned sphere
hides-stripe-noise = location and size: they average over many points
hides-tip-diameter = location, and lengths from centre to centre
length-standard = Length standard
location-fixed-diameter = Location, fixed diameter
location-over-articulations = Location over the articulations
no-limit = no limit
origin-of-figures = Origin of the figures
pass = Pass
performance-bars-caption =
    { CAPITAL($title) }, in µm, { $of ->
        [measurement] by measurement
        [orientation] by orientation of the sensor
        [seat] by seat: 1 near the shoulder, 2 in the middle, 3 far
       *[placement] by placement of the bar
    }.{ $limited ->
        [yes] { " " }Dashed: the maximum permissible error.
       *[no] { "" }
    }
performance-editions = Standards
performance-ended = Ended
performance-gate-points = Points of a scan take part if they lie within { $shell } of the surface of the calibrated sphere and within { $cone } of its pole ({ $pole }), and if the sensor sees that surface at no more than { $incidence } from its normal. All these points count; none is removed by its residual.
performance-judged-by-test-uncertainty = U is the test value uncertainty: that of artefact and set-up, not the scatter of arm and sensor, which is what the test measures.
performance-patches =
    { $count ->
        [one] { $count } place of a scan is
       *[other] { $count } places of a scan are
    } the mean distances of all points within { $half } of the directions of the pattern.
performance-single-values =
    { $test ->
        [plane] The orientations
       *[contact] Master sphere, seats and placements
    }
performance-symbol = Symbol
performance-values-against-limits = Values as shares of their maximum permissible errors, with the test uncertainty (k = 2) as a bar. The filled dot is the value that counts; open dots are the single values that it follows from.
plate = Flat artefact
points-in-gate = Points
points-outside-gate = Points outside
shows-arm-joints = form of the touched sphere; single-point articulation
shows-arm-links = errors of length; location over articulations, by touch as well as by scan; size where the stylus tilts outward
shows-clock = form and dispersion of the scanned sphere; they grow with the speed of scanning
shows-laser-plane = form of the scanned sphere and plane; size of the scanned sphere
shows-probe-matrix = location of the scanned sphere: up to 2 d along an axis that the articulations tilt, less along one that keeps its direction; its size, and its distance from the touched sphere
shows-sensor-scale = size of the scanned sphere, by a part of it
shows-stripe-noise = dispersion of 95 % of all points
shows-tip-diameter = size of the touched sphere; effective diameter
so-many-values =
    { $count ->
        [one] { $count } value
       *[other] { $count } values
    }
sphere-by-certificate = { $diameter } in diameter, known to { $known } (k = 1), form { $form }
sphere-moved = Moved by
sphere-position = Position
undecided = Undecided
values-in-micrometres = Values, µm
what-figures-mean = What the figures mean
what-figures-mean-text = Each error of arm and sensor shows in some figures and hides in others. If figures exceed their limits together, this table tells where to look first.
what-tested = What was tested
word-fail = fail
word-pass = pass
word-undecided = undecided

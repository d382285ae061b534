articulation-scanned-otherwise = Position { $position }, articulation { $number }: the camera looked from a direction { $off } away from the wanted one (at most { $most }).
articulation-touched-otherwise = Position { $position }, articulation { $number }: the stylus was held { $off } away from the wanted direction (at most { $most }).
articulations-nearly-same = the articulations { $first } and { $second } are nearly the same, { $apart } apart; at least { $least } are needed
articulations-not-scanned = only { $count } of the { $needed } articulations were scanned
articulations-too-alike = the sensor looked at the sphere from too similar sides
articulations-without-touches = touches are missing in the articulations { $names }
at-position = position { $position }: { $text }
centres-of-articulations-or-none =
    { $title }: { $count ->
        [one] the centre of { $count } articulation
       *[other] the centres of { $count } articulations
    } from above (x, y) and from the side (x, z), { $factor } times larger. The circle is the smallest sphere about them, { $diameter } in diameter: the location error. { $others ->
        [yes] Open dots: centres with the calibrated diameter.
       *[no] { "" }
    }
implied-offset-caption =
    In the sensor's frame, the sensor is really { $size } from where the probe matrix has it; thin bars are twice the standard uncertainty. { $significant ->
        [yes] This is more than chance: calibrate the sensor again.
       *[no] This is no more than chance.
    } Without it, a location error of { $left } would remain.
offset-not-separable = an error of the probe matrix cannot be separated from the position of the sphere
offset-not-significant = The location error does not imply an error of the probe matrix: { $size } does not differ from chance, { $left } would remain.
offset-worth-calibrating = The location error implies that the probe matrix is off by { $size }, or the scale of the sensor, which looks the same here; corrected for it, { $left } would remain. Calibrating again would help.
patches-not-covered = the scans do not cover the patches { $patches } of the sphere
performance-all-scanned = All five articulations are scanned.
performance-articulation =
    { $number ->
        [1] From above
        [2] Tilted away from the arm
        [3] Tilted to the right
        [4] Tilted towards the arm
       *[other] Tilted to the left
    }
performance-articulations-missing =
    { $missing ->
        [one] One articulation is not scanned yet.
       *[other] { $missing } articulations are not scanned yet.
    }
performance-camera-off-articulation = The camera looks from a direction { $off } away from the wanted one (at most { $most }).
performance-cause-arm = The centres by touch lie { $apart } apart, and the scatter of the touches explains { $usual }: links or encoders of the arm err with its posture.
performance-cause-outliers = { $share } of the points of the scans lie far off the sphere: reflections, or outliers of the sensor.
performance-cause-tip =
    { $way ->
        [large] The touched sphere is { $size } too large: the tip is larger than stated.
       *[small] The touched sphere is { $size } too small: the tip is worn or smaller than stated, or the sphere gives way while it is touched.
    }
performance-do-end = Touch the sphere five more times: they show whether it has moved.
performance-gate = Gate: { $shell } about the calibrated sphere, incidence up to { $incidence }, up to { $cone } from the pole; fixed before the test.
performance-hold-sensor =
    { $number ->
        [1] Hold the sensor above the sphere, looking straight down. Begin the scan and move the stripe over the sphere.
        [2] Hold the sensor on the side away from the arm, tilted by about 45°. Begin the scan and move the stripe over the sphere.
        [3] Hold the sensor on the right as seen from the arm, tilted by about 45°. Begin the scan and move the stripe over the sphere.
        [4] Hold the sensor on the side of the arm, tilted by about 45°. Begin the scan and move the stripe over the sphere.
       *[other] Hold the sensor on the left as seen from the arm, tilted by about 45°. Begin the scan and move the stripe over the sphere.
    }
performance-measuring-scan = Evaluating the scan of articulation { $articulation }
performance-move-sphere = Move the sphere to its second position, in another part of the arm's reach, and fix it. Then touch its top.
performance-no-filter = All points within the gate take part; no filter is applied.
performance-no-free-place = This touch is not near a place that is still free; it was not taken
performance-one-position = The sphere was measured in one position; the standard takes two.
performance-pass-slowly = Move the stripe slowly over the whole sphere, then end the scan.
performance-repeat-scan = Scan { $number } again
performance-run = Position { $position }, scan of articulation { $articulation }
performance-scan-again = Scan this articulation again, slowly over the whole sphere
performance-scan-done = Articulation { $articulation } is scanned.
performance-scan-missing = Scan the articulation on whose side they lie again.
performance-scan-name = Performance test, articulation { $articulation }
performance-scan-shows = { $patches } of 25 patches, { $points } points
performance-scan-too-small = The scan covers only { $count } of the sphere's 25 patches
performance-scans-done = { $done } of { $of } articulations
performance-simulation-scans = The simulated operator scans articulation { $articulation }
performance-step-end = Touch again
performance-step-location = Location by touch
performance-step-pattern = 25 touches
performance-step-scan = Five scans
performance-stylus-off-articulation = The stylus is { $off } away from the wanted direction (at most { $most }).
performance-touch-location =
    { $number ->
        [1] Hold the wrist above the sphere, with the stylus pointing straight down. Touch the top and four places around it without turning the stylus.
        [2] Tilt the stylus by about 45°, wrist on the side away from the arm. Touch the five marked places without turning the stylus.
        [3] Tilt the stylus by about 45°, wrist on the right as seen from the arm. Touch the five marked places without turning the stylus.
        [4] Tilt the stylus by about 45°, wrist on the side of the arm. Touch the five marked places without turning the stylus.
       *[other] Tilt the stylus by about 45°, wrist on the left as seen from the arm. Touch the five marked places without turning the stylus.
    }
performance-touch-pattern = Touch the marked places in any order, with the wrist turned freely. The nearest free one is highlighted.
performance-touch-place = Touch place { $number } of the drawing
performance-touch-top-first = Touch the top of the sphere first; the other places follow from it. From here on, sphere and limits are fixed.
performance-turn-towards-articulation = Turn the wrist until this message disappears; points taken otherwise are noted in the result
places-of-hemisphere =
    { $title }, seen from the pole: { $count ->
        [one] { $count } place
       *[other] { $count } places
    } with the distance from the least-squares sphere in µm, blue inside, orange outside, at most { $largest }. The circles lie at 22.5°, 45°, 67.5° and 90° from the pole.
scan-covers-patches = the scan { $name } covers only { $count } patches of the sphere
scan-sphere-from-other-sides = scan it from sides that differ by 45° or more
scanned-centres-of-position = By scan, position { $position }
scanned-places-of-position = Scanned sphere, position { $position }
sphere-not-touched-again = the sphere was not touched again at the end, so that it is not known whether it or the arm moved
sphere-or-arm-moved = sphere or arm moved by { $moved } during the test; the limit is { $limit }
sphere-was-not-scanned = the sphere was not scanned
touched-centres-of-position = By touch, position { $position }
touched-places-of-position = Touched sphere, position { $position }
touches-miss-places = no touch lies near the places { $places } of the sphere
touches-missing-of-pattern = only { $count } of the { $needed } touches were taken
value-with-spread = { $value } { $spread }

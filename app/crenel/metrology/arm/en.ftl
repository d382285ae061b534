another-unit-arm-or-marker = they are in another unit, of another arm, or the joint angles belong to other poses
arm-and-frame-have-unknowns = the arm, its markers and frames have { $unknown } unknowns
arm-has-no-tip = the arm { $name } has no tip
arm-json-tip-goes-far-while = according to this arm.json the tip moves too far while it is in a seat: { $far } from the centre of seat { $name }
arm-json-tip-goes-fro = { $label }: according to arm.json the tip moves over { $distance }
arm-sees-bar-given = the arm measures bar { $bar } as { $measured }, but its stated length is { $given }
arm-stays-shows-nothing-errors = an arm that does not move reveals none of its errors
arms-parameters-already-explain-points-well = the arm's parameters already explain the points to within their measurement noise
bar-end-of-position = bar { $name } { $position } end { $end }
bar-position-arm-json-ends-lie = bar { $name }, position { $position }: according to arm.json its ends are { $measured } apart, but its stated length is { $length }
bars-length-hardly-known = bar { $bar }: its length is stated to ± { $uncertainty } (k = 1), which hardly determines the arm's scale: check that standard_uncertainty_mm is in mm
bars-lengths-coordinates-scatter-without-them = with the bars' lengths the coordinates scatter by { $scatter }, without them by { $without }
bars-lengths-points-scatter-without-them = with the bars' lengths the points scatter by { $scatter }, without them by { $without }
bring-joint-reference-switch-arm-off = move the joint to its reference position and switch the arm off and on; if the error persists, choose the datasheet of this arm
change-theta-of-joint = Change theta_deg of joint { $joint } in arm.json by { $turn } (with sign −1, by as much the other way)
check-arm-json-against-arm-signs = Check arm.json against the arm (signs, units, lengths, order of the joints) and the points of that place
check-arm-software-and-network = check the arm’s software and the connection to it
check-arms-cable-then-switch-arm = check the arm's cable, then switch the arm off and on
check-diameter = { $finding }: check its diameter
check-diameter-mm-spheres-take-sphere = Check diameter_mm of the spheres; measure this sphere again or delete its rows
check-encoder-swing-arm-so-every = Check the encoder; swing the arm so that every joint rotates
check-encoders-arm-json-how-points = Check the encoders, arm.json, and how the points were taken
check-frame-and-tool-of-arm = check whether the base frame or the tool was changed in the arm’s software; if it was, set it back
check-joints-encoder-cable-then-bring = check the joint's encoder and cable, then move the arm to its reference position
check-length-mm-bar-ends = Check length_mm of bar { $bar }, and its ends
check-length-of-bar-and-coordinates = Check the length of bar { $bar }, its ends, and the scale of the coordinates
check-length-unless-datasheet-is-as-far-off = { $finding }: check its length, unless the arm's datasheet is wrong by as much
check-order-and-signs-of-coordinates = Check the order and the signs of x_mm, y_mm and z_mm: the frame must be right-handed
check-signs-lengths-joints-order = Check signs, lengths and the order of the joints in arm.json
check-unit-arm-and-rows = Check the unit, the frame and the joint angles of the rows, and whether it is this arm
checking-places-held-out = Cross-validating the places
clamp-seat-take-place-again-delete = Clamp the seat and measure this place again, or delete its rows
coordinates-fit-otherwise = { $reason }, they would typically lie { $off } from where arm.json has them
coordinates-give-figures = coordinates.csv: { $poses } poses give { $figures } values
coordinates-spread = coordinates.csv: the points of frame { $name } typically lie { $measured } from their middle, but { $expected } according to arm.json
correct-tips-diameter-arm-json-what = Correct the tip's diameter in arm.json, or the values in the tables
datasheet-lets-turn = its datasheet allows { $low } to { $high }
delete-what-stands-there-twice = Delete the duplicates
denavit-hartenberg-parameters-do-same = the Denavit-Hartenberg parameters have the same effect
encoder-stands-still-switch-arm-off = its encoder does not move: switch the arm off and on, and check the joint's cable
even-best-arm-points-still-scatter = even with the best-fitting arm the points scatter by { $scatter }
few-poses = { $poses } poses give { $figures } values for { $unknown } unknowns and hardly check them: measure { $wanted } poses, all over the reach
fit-does-not-converge = the fit does not converge
fit-follows-these-points-arm = the fit follows these points instead of the arm
fitting-arm = Fitting the arm
frame-has-points = coordinates.csv: frame { $name } has { $count } points
frame-named = frame { $name }
give-each-row-angles-of-its-pose = Give every row the joint angles of its own pose
give-each-seat-name-own = Give each seat its own name
give-length-mm-bar-millimetres-check = Give length_mm of bar { $name } in millimetres, and check its rows
give-pose-of-marker-in-frame = Give the pose of the marker in the frame of the instrument
give-rotation-of-marker-in-frame = Give the rotation of the marker in the instrument's frame: qx, qy, qz, qw with the scalar last, or rx_deg, ry_deg, rz_deg
give-seat-own-name-check-arm-json = Give each seat its own name; check arm.json
has-points = { $label } has { $count } points
if-angles-of-next-row =
    { $row ->
        [before] if every row had the joint angles of the row before
       *[after] if every row had the joint angles of the next row
    }
if-coordinates-in-unit =
    { $unit ->
        [inches] if they were in inches
       *[centimetres] if they were in centimetres
    }
if-coordinates-mirrored = if the coordinates were mirrored
if-frame-is-not-base = if their frame were the instrument's own and not the base
if-instrument-moved = if the instrument or the arm's base had moved before line { $line }
if-joint-turned-other-way = if joint { $joint } turned the other way
if-joint-zero-elsewhere = if joint { $joint } read { $turn } more
if-poses-inverted = if these were the poses of the instrument in the frame of the marker
instrument-moved-or-angles-of-other-pose = the instrument moved, lost its marker, or the joint angles belong to other poses
instrument-or-base-moved = the instrument or the arm's base moved, or the points come from two set-ups
joint-angle-not-a-number = { $name }: a joint angle is not a number
joint-angles = { $name }: { $count } joint angles
joint-jumped-stayed-there = joint { $joint } jumped by { $step } and stayed there
joint-reads = joint { $joint } reads { $reading }
joint-reads-again-again = joint { $joint } reads { $reading } repeatedly
joint-reads-no-number = the reading of joint { $joint } is not a number
joint-reads-off-readings-before-after = joint { $joint } reads { $reading }, { $step } off its readings before and after
joint-reads-same-all-points = joint { $joint } reads the same in all points
joint-reads-where-can = joint { $joint } reads { $reading }, { $step } away from where it can be
keep-arm-json-use = Keep the arm.json that is in use
least-needed-tell-arms-errors-own = at least { $least } are required to separate the arm's errors from the centre of the place
least-needed-to-know-frame = at least { $least } are needed to know where the instrument stood
least-seats-spheres-bar-positions-needed = at least { $least_places } seats, spheres and bar positions are required, so that some are left for cross-validation
length-another-bar-another-unit-ends = the length is that of another bar or in another unit, or the ends do not belong to this bar
lengths-of-bars-contradict = the lengths of the bars { $bars } contradict each other by { $off }; it is not certain which of them is wrong
many-points-have-very-same-angles = many points have identical joint angles
markers-lie-far = coordinates.csv: in frame { $name } the points typically lie { $off } from where arm.json has them
markers-place-is-estimated-instead = the marker's place on the flange is estimated instead
measure-again-or-delete-rows = Measure again, or delete the rows
measure-more-poses = Measure at least { $least } poses, better { $wanted }, all over the reach
measure-more-there-or-delete-rows = Measure more points there, or delete its rows
measured-points-not-tip = coordinates.csv: the measured points lie { $far } from the tip
move-joint-to-reference-within-sentence = move the joint to its reference position and switch the arm off and on
moves-check-arm-json =
    { $beside ->
        [bars] { $name } changes by { $change }: check arm.json and the bars' lengths
        [marker] { $name } changes by { $change }: check arm.json, and the marker: its name in the column marker, if it is not the tip, and its place, if it is given
       *[arm] { $name } changes by { $change }: check arm.json
    }
moving-only-moves-whole-arm-space = changing it only moves the whole arm in space
name-folder-other-places-none-some = Name a folder of other places, or none: some places are then left out in turn
name-frame-of-each-set-up = Give each set-up a name of its own in the column frame
name-frame-otherwise-than-base = Give the frame another name than base
name-marker-in-column = Name the marker in the column marker, or correct the tip in arm.json
no-arm-moves-that-fast = no arm moves that fast
no-arm-near-given-one-explains = no arm close to the given one explains the points; those of { $label } lie { $rms } (rms) apart
no-ball-bar-measured-arms-size = no ball bar was measured: the arm's scale is that of its datasheet; an error of { $error } in the longest link adds { $size } over the reach
no-hand-no-knock-moves-joint = neither a hand nor a knock moves a joint that far in so short a time
no-joint-goes-there-back-between = no joint moves there and back between two readings
no-joint-turned-more-than = { $label }: no joint rotated by more than { $swing } ({ $joint })
no-seated-tip-does-points-another = a seated tip does not; points of another place are among them, or the file belongs to another arm
not-moved-or-encoder-not-read = it did not move, or its encoder is not read
not-of-such-an-arm-or-tip-not-seated = they do not come from an arm of this kind, or the tip was not seated
nothing-taken-such-reading = such a reading is not used
one-diameter-wrong-or-sphere-not-clean = one of the stated diameters is wrong, or the sphere was not clean
one-of-touches-off = at least one of these points is off, and the others cannot tell which: { $points }. Touch two more points there
parameters-moved-do-same-together = the changed parameters have the same effect together
places-held-out-agree-too-well = in cross-validation the places deviate by only { $times } times the stated noise: standard_uncertainty_mm is too large, or in another unit
places-held-out-arms-errors-go = in cross-validation the arm's errors change from { $before } to { $after } times their noise
places-held-out-still-deviate = in cross-validation the places still deviate by { $times } times their noise: add places, spread more evenly over the reach
point-at-place = { $place }, point { $number }
points-1-lie-apart-while-single = { $label }: its points 1 to { $split } and { $next } to { $points } lie { $gap } apart, while single points scatter by { $sd }
points-check-among-those-fit = { $shared } of the { $count } check points were also used in the fit
points-disagree-rest = { $label }: { $out } of its { $points } points disagree with the rest
points-do-not-tell-better-than-tolerance = these points do not determine it better than its manufacturing tolerance
points-lie-in-another-frame = coordinates.csv: { $far } of { $points } points of frame { $name }, from line { $first } to line { $last }, agree among themselves but lie { $off } off the others
points-moved-from-line-on = coordinates.csv: in frame { $name } the points from line { $line } on lie { $off } off those before, as the best arm has them
points-of-frame-disagree = coordinates.csv: { $out } of { $points } points of frame { $name } disagree with the others
points-places = { $points } points at { $places } places
points-scatter-less-than-stated = the points scatter by a small part of what is stated: standard_uncertainty_mm is too large, or in another unit
points-were-taken-another-arm-file = the points were taken with another arm, or the file is wrong
pose-jumped = the arm reports a pose { $step } and { $turn } from the one before
pose-jumped-and-stayed = the arm’s pose jumped by { $step } and { $turn } and stayed there
pose-no-number = the arm reports a pose that is not a number
pose-no-rotation = the arm reports a pose whose quaternion is not of unit length
pose-repeats = the arm reports the same pose again and again
poses-equal-to-last-digit = its poses always showed noise, and now they are equal to the last digit: it sends an old pose
readings-equal-as-never-of-encoder = at least { $equal_frozen } consecutive readings are equal to the last digit; those of a working encoder never are
reverse-sign-of-joint = Reverse the sign of joint { $joint } in arm.json
rotations-differ = coordinates.csv: the measured rotations differ from the arm's by typically { $angle }
rotations-other-order-or-direction = they have another order or direction, or belong to other poses
rows-copied-or-arm-not-moved = rows were copied, or the arm did not move: a repeated point adds no information
seat-moved-between = the seat moved in between
seat-points-1-lie-apart = seat { $name }: its points 1 to { $split } and { $next } to { $points } lie { $gap } apart
seen-than-against-diameters-given =
    { $sign ->
        [larger]
            { $label } measures { $off } (± { $uncertainty }) larger than { $others ->
                [1] the other one
               *[other] the others
            }, relative to the stated diameters
       *[smaller]
            { $label } measures { $off } (± { $uncertainty }) smaller than { $others ->
                [1] the other one
               *[other] the others
            }, relative to the stated diameters
    }
spheres-seen-against-their-diameters-tips = with a tip of { $diameter }, the spheres differ from their stated diameters by { $excess } (± { $uncertainty })
spheres-seen-than-stated-tips-diameter =
    { $sign ->
        [larger] the spheres measure { $excess } larger than stated: the tip's diameter may be { $diameter }
       *[smaller] the spheres measure { $excess } smaller than stated: the tip's diameter may be { $diameter }
    }
spheres-size-by-certificate-or-datasheet =
    { $sign ->
        [larger] with the arm's datasheet the spheres have their stated sizes; with this bar's length they would be { $excess } larger
       *[smaller] with the arm's datasheet the spheres have their stated sizes; with this bar's length they would be { $excess } smaller
    }
state-uncertainty-in-mm = Give standard_uncertainty_mm in mm, k = 1
swing-elbow-one-side-other-while = Swing the elbow from one side to the other while the tip stays in the seat
take-more-places-all-over-arms = Measure more places, all over the arm's reach
take-more-places-all-over-reach = Measure more places, all over the reach, and swing the arm from side to side in each
take-more-points-more-places = Take more points, in more places
take-more-there-delete-rows = Take more points there, or delete its rows
take-more-while-arm-swings = Take more points while the arm swings
take-place-again-delete-rows = Measure this place again, or delete its rows
the-seat = the seat
they-cannot-show-whether-arm-better = they cannot show whether the arm is better elsewhere
they-leave-nothing-over-check-parameters = they leave no redundancy to check { $columns } parameters
tip-itself-was-not-measured = the tip itself was not measured
tip-not-seated-or-seat-loose = the tip was not seated, the seat was loose, or points of another place are among them
tip-rather-has = the tip's diameter is probably { $diameter }, or the stated diameters of the spheres are wrong
tip-rather-has-or-bar-wrong = the tip's diameter is probably { $diameter }, or the stated diameters of the spheres are wrong, or the length of a bar is wrong
tips-coordinates-moved-instead = the tip's coordinates are changed instead
too-few-places-were-touched = too few places were measured: { $count }
touch-more-sphere = Touch more of the sphere
two-reasons = { $first } and { $second }
two-seats-or-seat-carried = they belong to two seats, or the seat was moved in between
two-seats-or-seat-carried-or-arm = they belong to two seats, or the seat was moved in between, or arm.json belongs to another arm (in other seats, too, its tip moves by { $far })
without-ball-bar-arms-size-observable = without a ball bar the arm's scale is not observable
without-marker-coordinates-are-tips = without the column marker, coordinates are those of the tip

add-column-or-leave-both = Add the column, or leave out both
add-micrometer-reading-of-width = Add a reading of a merlon's width by micrometer, or subtract the tip's diameter and state its uncertainty as tool_uncertainty_mm under another tool
add-readings-from-face-known = Add readings of these faces from others
certificate-must-be-known-to = a certificate is known to { $most }
check-names-of-faces-and-axes = Check the names of the faces and the directions of the machine's axes
coordinates-about-mean-of-faces = The uncertainties are about the mean of the faces of each axis, so that the distance of two faces has the root of the sum of their squares.
correct-reading-or-leave-out = Correct the reading, or leave it out
diameter-up-to-or-unknown = a diameter in mm up to { $most } is expected, 0 for points that the machine has compensated, or unknown
direction-points-into-block = { $place }: the direction i, j, k points into the block at { $face }
directions-point-out-of-surface = directions point out of the surface; the touch belongs to another face or the signs are exchanged
error-of-arm-over-reach-unknown = { $path } does not state the arm's error over its reach
errors-of-links-counted = Errors of the arm's links count, with all that the touches share of them: { $error } rms of the tip over the arm's reach.
exchange-faces-or-touch-again = Exchange the names, or touch both again
exchange-readings-or-read-again = Exchange them, or read both again
face-has-touches =
    { $count ->
        [one] { $face } was touched once
       *[other] { $face } was touched { $count } times
    }
face-known-only-to = the readings leave a face uncertain by { $known }
faces-are-not-parallel = these are not two parallel faces
faces-beyond-tolerance = Beside the drawing by more than its tolerance of ± { $tolerance }: { $faces }. Check these readings, or whether two were exchanged.
faces-of-readings-are = faces are edge_1 to edge_{ $edges }, { $names }
file-has-touches = { $path } has { $count } touches
give-arm-of-touches = Give the arm's file with --arm
give-readings-points-or-both = Give readings.csv, --points, or both
identify-arm-or-state-arm-um = Identify the arm, or state the rms error of its tip over the reach with --arm-um
leave-out-touches-evenly = Leave out touches evenly over all faces
links-errors-do-not-average-out = errors of the links are the same in every touch and do not average out
most-touches-are = at most { $most } can be used
multiply-coordinates-by = Multiply the coordinates by { $factor }
multiply-readings-by-inch = Multiply them by 25.4
neither-readings-nor-points = neither readings nor points were given
one-of-readings-is-wrong = the readings do not tell which of them is wrong
opposite-faces-exchanged-or-left-handed = opposite faces, such as front and back, are exchanged, or the machine's axes are left-handed
posture-and-its-uncertainty = posture and posture_uncertainty_mm are given together
read-these-again = Read these again
reading-between-faces = { $place }: a reading from { $first } to { $second }
reading-far-beside-drawing = { $place }: { $reading } was read where the drawing has { $drawn }
reading-of-other-faces = the row belongs to other faces, another block or another unit
reading-off-by = { $reading } by { $off }
readings-agree-if-exchanged = all readings agree if those of { $one } and { $other } are exchanged
readings-are-inches =
    { $count ->
        [one] { $place }: the reading agrees with the drawing if it is in inches
       *[other] { $place } and the following: { $count } readings agree with the drawing if they are in inches
    }
readings-contradict-others =
    { $count ->
        [one] one reading contradicts the others: { $first }
       *[other] { $count } readings contradict the others, foremost { $first }
    }
readings-expected-in-mm = millimetres are expected
readings-miss-faces =
    { $count ->
        [one] no chain of readings reaches { $faces }
       *[other] no chain of readings reaches the faces { $faces }
    }
readings-must-connect-faces = readings must connect all edges along X, front with back, and crest, floor and base
readings-scatter-more = The readings scatter { $times } times as much as they state; the uncertainties are larger by this factor.
state-tip-uncertainty-or-unknown = State tip_uncertainty_mm, or write unknown for the diameter and add a width by another tool
tip-alone-never-shows-diameter = a smaller tip and a larger block give the same readings
tip-diameter-not-shown = no reading shows the diameter of the { $tool }
tip-error-is-in-every-width = the error of the diameter is in every width
tips-diameter-has-no-uncertainty = { $place }: the tip's diameter has no uncertainty
touch-in-row = the touch in line { $line } ({ $face })
touch-lies-beside-face = { $place }: the touch lies { $off } beside { $face }
touch-lies-on-face = it lies on { $face }
touch-lies-on-no-face = it lies on no other face, or on several
touch-two-faces-of-two-axes = touches on two faces each of two axes are needed, such as all edges, front and back
touches-agree-if-exchanged = all touches agree if the names of { $one } and { $other } are exchanged
touches-agree-in-unit = { $place } and the following: the touches agree with the drawing if they are in { $unit }
touches-are-joint-angles = { $path } has the joint angles of an arm
touches-are-mirror-image = the touches are those of the block's mirror image
touches-do-not-show-place = the touches do not show where the block stands
touches-scatter-more = The touches scatter { $times } times as much as they state; the uncertainties of each by itself are larger by this factor.
uncertainty-above-zero-up-to = an uncertainty in mm above 0 and up to { $most } is expected

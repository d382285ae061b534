a-laser-plane-is-of-one-laser = a laser plane is that of one laser
add-pictures-turned-about-another-axis = add pictures rotated about another axis
adjusting-all-poses-together = Adjusting all poses together
all-poses-turn-flange-about-one = all { $count } poses rotate the flange about one axis, ({ $x } { $y } { $z }) in the flange frame
arms-motion-moves-other-way-than = according to the arm, { $name } moves in the opposite direction to the pictures
arms-motion-object-than-certificate-says =
    { $sign ->
        [larger] According to the arm's motion, the object is { $share } (± { $uncertainty }) larger than its certificate states: all lengths would be wrong by the same percentage.
       *[smaller] According to the arm's motion, the object is { $share } (± { $uncertainty }) smaller than its certificate states: all lengths would be wrong by the same percentage.
    }
arms-motion-squares-wide = according to the arm's motion, the squares of { $name } are { $width } wide
arms-motion-squares-wide-certificate = According to the arm's motion, the squares are { $width } wide (± { $uncertainty }); the certificate states { $nominal }. All lengths would be wrong by the same ratio.
autofocus-or-zoom-changed-it = autofocus or zoom changed it, and a calibration holds for one focal length
block-dimension =
    { $name ->
        [base] height of the floors above the base
        [depth] depth from front to back
        [height] height of the crests above the floors
       *[width] width from left to right
    }
block-dimensions-undetermined = Neither pictures nor contact points tell the block's { $names }: the tolerance counts there.
block-edges-estimated = Only the drawing of the block is known: its edges were estimated with the calibration. They lie up to { $beside } beside the drawing, with a standard uncertainty of { $known }, which is the same in all poses.
board-bends-over-pattern-allowed = The board is bent by { $bend } over the pattern; the calibration allows for it.
board-bends-over-pattern-flat-expected = The board is bent by { $bend } over the pattern; its certificate states a flatness of { $flatness }.
board-tilted-most-between-pictures = the tilt of the board varies by at most { $tilt } between the { $seen } pictures
calibrate-camera-and-laser-together = Calibrate camera, mounting and laser together from these pictures
calibrations-unknowns-did-settle-what-seen = the calibration did not converge on the pictures and contact points
check-arm-play-tip-sensor-loose = Check the arm for play, and tip and sensor for a loose mount; hold still.
check-board-how-exact-certificate-takes = Check that this is the board, and the uncertainty that its certificate states.
check-each-laser-picture-own-pose-laser-not-moved = Check that each laser picture belongs to its pose and was taken without moving the sensor, and that the laser is mounted firmly; then check its focus.
check-each-laser-picture-own-pose-no-reflection = check that each laser picture belongs to its pose, that the laser did not move relative to the camera, and that the line in the picture is that of the laser and not a reflection
check-laser-board-camera-not-moved = Check that laser, board and camera did not move, and that picture and pose were recorded at the same moment.
check-laser-line-crossed-object-exposure = Check that the laser was on and its line crossed the object, and check the exposure; capture the pose again.
check-laser-not-moved-and-no-reflection = check that the laser did not move relative to the camera, and that the line in the picture is that of the laser and not a reflection
check-laser-picture-pose-sensor-held = Check that its laser picture belongs to this pose, that the sensor was held still between its two pictures, and that the laser is mounted firmly; capture the pose again.
check-mounted-tip-and-nothing-moved = Check the mounted tip against the arm's file, and that nothing moved; then identify the arm again.
check-mounted-tip-and-object-not-moved = Check which tip is mounted, its diameter and its length, and that the object did not move after it was touched.
check-not-moved-every-picture-has-readings =
    { $thing ->
        [board] check that the board did not move, and that every picture has the arm's readings of its own pose
       *[object] check that the object did not move, and that every picture has the arm's readings of its own pose
    }
check-object-certificate-lengths-mm = Check that this object belongs to the certificate, and that its lengths are in mm.
check-object-pictures-every-picture-belongs = check that this is the object in the pictures, and that every picture belongs to its arm pose
check-picture-joint-angles-one-moment = Check that picture and joint angles were recorded at the same moment, or capture the pose again.
check-pictures-joint-angles-those-their = Check that the joint angles of the pictures belong to their poses.
check-pictures-not-mirrored-poses-of-flange = check that the pictures are not mirrored, and that the poses are those of the flange in the arm frame, in mm, with qw last and not inverted
check-square-tip-and-board-not-moved = check square_mm and the tip in arm.json, and that the board did not move
check-tip-one-arms-file-board = Check that the tip matches the arm's file and that board and arm were fixed firmly.
check-which-tip-mounted-diameter-object = Check which tip is mounted, its diameter, and that this is the object.
check-which-tip-mounted-stylus-straight = Check which tip is mounted, and that its stylus is straight and tight; determine its position again, and touch the object again.
contacts-arm-has-no-tip = there are { $readings } contact points, but the arm { $name } has no tip
contacts-lie-board-rms = { $count } contact points fit the board to { $rms } rms.
contacts-lie-board-rms-up-good = { $count } contact points fit the board to { $rms } rms; up to { $good } is good.
contacts-lie-off-board-pictures-show = the { $touches } contact points lie { $usual } off the board seen in the pictures
contacts-pictures-agree-better-tip-than = Contact points and pictures agree better with a tip diameter of { $fitted } (± { $known }) than with { $given }.
contacts-pictures-agree-better-tips-centre = Contact points and pictures agree better with the tip's centre { $off } from its position in the arm's file: by { $x }, { $y }, { $z } (± { $known }) in the flange frame. Scanned points may be wrong by as much.
convert-poses-read-otherwise =
    { $fault ->
        [inverted] give the poses of the flange in the frame of the arm; with a fixed sensor, give the inverse of each pose, in calibrations and scans alike: the result then has the sensor in the frame of the arm's base, and scans are in the frame of the flange
        [mirrored] switch off mirroring (horizontal or vertical flip) in the settings of the camera, or in the program that stored the pictures, and flip these pictures back
        [scalar-first] write qx, qy, qz, qw in this order
        [scalar-first-inverted] give the poses of the flange in the frame of the arm, and write qx, qy, qz, qw in this order
        [turns-inverted] give the rotations of the flange in the frame of the arm: change the sign of qw
        [rotations] write the controller's own columns, and state it as rotation in arm.json: { $controllers }
        [unit] convert the positions to mm, or name their columns by their unit
        [late] give every picture from pose { $first } on the pose in which it was taken
        [early] give every picture from pose { $first } on the pose in which it was taken
        [tool-changed] give all poses in one tool frame, or calibrate the poses before { $first } and those from there on separately
        [object-moved] calibrate the poses before { $first } and those from there on separately
       *[other] give every picture the pose in which it was taken
    }
corners-lie-off-regular-pattern-certificate = The corners deviate from a regular pattern by { $off }, while the certificate states { $standard_uncertainty }; the calibration allows for it.
data-speak-errors-arms-links-each = The data indicate errors of { $links } and { $turns } in each of the arm's links; what remains of them contributes { $share } to the uncertainty of a point.
expected = { $wanted } is expected
finding-start = Finding the initial values
fix-board-flat-plate = Fix the board to a flat plate.
fix-board-so-cannot-rock-warp = Fix the board so that it cannot rock or warp, and lock the camera's lens.
fix-focus-and-zoom-and-take-all-pictures-again = Switch autofocus off, fix focus and zoom, and take all pictures again
fix-object-arm-so-neither-can = Fix object and arm so that neither can move, touch the object, and take the pictures again.
flange-turned-most-between-poses = the flange rotated by at most { $turn } between the { $count } poses
flat-board-one-direction-does-not-tell-focal-length = pictures of a flat board from one direction do not determine the focal length
flat-board-tells-cameras-focal-length = a flat board determines the camera's focal length only with at least { $fewest_poses } pictures, tilted relative to each other
focal-length-differs-between-pictures = the focal length differs between the pictures, by { $span }: it is longer in poses { $poses } than in the others
focus-zoom-or-lens-changed-since = focus, zoom or lens changed since it was calibrated
give-square-in-mm = Give square_mm in millimetres
half-them-more-contradicting-others-none = half of them or more contradict the others, so none can be trusted
higher-by = { $distance } higher
how-sensor-sits-flange-shows-only = the mounting of the sensor on the flange shows only when the flange rotates: at least three poses about two different axes are required
identical-pictures-count-once = The pictures of poses { $poses } are those of other poses again. They count once.
keep-this-pose = keep this pose
kept-camera-does-not-fit = the corners lie { $rms } rms off where the kept camera puts them, { $own } with a camera of these pictures
kept-camera-does-not-fit-the-arm = with the kept camera, pictures and arm disagree { $times } times as much as with a camera of their own
laser-line-left-out-off-plane = its laser line was excluded, { $off } off the plane of the others
laser-line-lies-off-plane-others = its laser line lies { $off } off the plane of the others
laser-lines-off-their-plane = the laser lines of poses { $poses } lie { $usual } off their best-fitting plane
laser-moved-by-lines-off-plane = The laser lines of poses { $poses } lie { $off } off the plane of the others: the laser moved relative to the camera, and all lines are used.
laser-plane-does-not-cross-board-sharply = a laser plane nearly parallel to the board does not intersect it sharply
lasers-line-lies-board-pictures = the laser line lies on the board in { $enough } of { $views } pictures
lasers-line-lies-one-place-plane = the laser line is at the same position in its plane in all pictures
lasers-line-pose-lies-off-plane = The laser line of pose { $number } lies { $off } off the plane of the others and was excluded.
lasers-lines-poses-lie-off-plane = The laser lines of poses { $poses } lie { $off } off the plane of the others: the laser moved relative to the camera, and these lines were excluded.
lasers-lines-poses-lie-up-off = the laser lines of poses { $poses } lie up to { $most } off one plane
lasers-plane-stands-board-limit = the angle between laser plane and board is { $angle } (limit { $least_laser_angle_deg })
let-laser-come-rest-take-pictures = Let the laser settle, and take the pictures again.
let-laser-warm-up-check-mount = Let the laser warm up, check its mount, and take the pictures again.
let-line-cross-board-in-more-pictures =
    { $more ->
        [one] take one more picture in which the line crosses the board
       *[other] take { $more } more pictures in which the line crosses the board
    }
light-board-evenly-sharp-large-picture = Light the board evenly; show it sharp and large in the picture.
limit-is-value = the limit is { $limit }
lines-run-along-other-axis =
    { $axis ->
        [u] The laser lines run down the pictures, but one point for each column is measured, so that most of them is lost.
       *[v] The laser lines run across the pictures, but one point for each row is measured, so that most of them is lost.
    }
lower-by = { $distance } lower
measure-pattern-over-all-squares-correct = Measure the pattern over all its squares, and correct the certificate.
measure-patterns-width-height-fix-flat = Measure the pattern's width and height, and fix it to a flat plate.
measure-squares-correct-certificate-check-every = measure the squares, and correct the certificate; or check that every picture has its own pose, in mm
more-touches-on-face = { $count } more { $where }
needed-place = at least { $fewest_corners } are required to determine its pose
neither-colours-nor-arms-poses-tell = neither its colours nor the arm's poses determine which corner is the first
no-laser-plane-yet = Camera and mounting are calibrated. There is no laser plane yet: nothing can be scanned.
no-picture-was-taken-with-the-laser = the laser was off in all pictures, so there is no plane to add
no-pose-given = no pose was given
no-size-squares-makes-them-agree = no size of its squares makes the two agree
object-points-do-not-fit-pixels = the object's points do not fit their pixels
one-line-alone-does-fix-lasers = a single line does not determine the laser plane
one-pose-alone-used-errors-arms = Only one pose was used: errors of the arm's links appear only in the contact points. Joint angles that do not belong to the picture, and an object that moved after it was touched, do not appear.
picture-shows-no-laser-line-object = its picture shows no laser line on the object
pictures-contacts-certificate-contradict-each-other = the pictures, the contact points and the certificate contradict each other
pictures-different-sizes = the pictures are of different sizes: { $sizes }
pictures-have-object-turned-how-touched = In the pictures the object is rotated by { $turned } relative to its contact points. Scanned points may be wrong by as much.
pictures-have-object-where-touched-turned = In the pictures the object is { $off } (± { $known }) away from where it was touched, and rotated by { $turned }. Scanned points may be wrong by as much.
pictures-show =
    { $seen ->
        [one] { $seen } picture shows { $name }
       *[other] { $seen } pictures show { $name }
    }
plane-needs-lines = the laser plane requires lines in at least { $fewest } pictures; the other pictures determine camera and mounting
points-blocks-edges-fit-camera-rms = { $points } points on the block's edges fit the camera to { $rms } rms (limit { $edge_rms_px }), worst in pose { $number }: { $edges_rms } (limit { $worst_limit }).
points-lasers-line-lie-board-but-poses =
    { $count ->
        [one] { $points } points of the laser line lie on the board, { $rms } rms off the plane. Pose { $poses } has none and determines only camera and mounting.
       *[other] { $points } points of the laser line lie on the board, { $rms } rms off the plane. Poses { $poses } have none and determine only camera and mounting.
    }
points-lasers-line-lie-board-rms = { $points } points of the laser line lie on the board, { $rms } rms off the plane.
pose-at-pixel = pose { $number } ({ $u }, { $v })
pose-for-reason = Pose { $number }: { CLAUSE($reason) }.
pose-left-out = Pose { $number } was excluded: { CLAUSE($reason) }.
pose-looks-same-turned-round = pose { $number }: { $name } looks the same when rotated
pose-named = pose { $number }: { $name }
pose-shows-corners = pose { $number } shows { $found } corners of { $name }
pose-shows-no-laser-line-object = Pose { $number } shows no laser line on the object and is used without it.
poses = the poses
poses-agree-boards-place-pose-furthest = { $used } poses agree on the board's position to { $median }; pose { $number } deviates most, by { $off }.
poses-agree-objects-place-pose-furthest = { $used } poses agree on the object's position to { $median }; pose { $number } deviates most, by { $off }.
poses-agree-read-otherwise =
    { $fault ->
        [inverted] inverted, { $agree } of { $count } poses agree with the pictures of { $name } to { $apart }; as they are given, they contradict them
        [mirrored] with mirrored pictures, { $agree } of { $count } poses agree with { $name } to { $apart }; with the pictures as they are, they contradict each other
        [scalar-first] with the scalar of the quaternion first, { $agree } of { $count } poses agree with the pictures of { $name } to { $apart }; as they are given, they contradict them
        [scalar-first-inverted] inverted and with the scalar of the quaternion first, { $agree } of { $count } poses agree with the pictures of { $name } to { $apart }; as they are given, they contradict them
        [turns-inverted] with inverted rotations, { $agree } of { $count } poses agree with the pictures of { $name } to { $apart }; as they are given, they contradict them
        [rotations] { $right ->
            [vector] with rotation vectors
           *[other] with the angles as { $right }
        }, { $agree } of { $count } poses agree with the pictures of { $name } to { $apart }; as they are given, they contradict them
        [unit] with the positions in { $unit }, { $agree } of { $count } poses agree with the pictures of { $name } to { $apart }; as they are given, they contradict them
        [late] from pose { $first } on, poses are { $rows ->
            [one] one row
           *[other] { $rows } rows
        } late: with the pose that stands so much further down, { $agree } of { $count } poses agree with the pictures of { $name } to { $apart }
        [early] from pose { $first } on, poses are { $rows ->
            [one] one row
           *[other] { $rows } rows
        } early: with the pose that stands so much further up, { $agree } of { $count } poses agree with the pictures of { $name } to { $apart }
        [reversed] in reversed order, { $agree } of { $count } poses agree with the pictures of { $name } to { $apart }; in the order given, they contradict them
        [sorted] if one column is sorted by name (1, 10, 11, 2) and the other by number, { $agree } of { $count } poses agree with the pictures of { $name } to { $apart }; in the order given, they contradict them
        [swapped] with the poses { $first } and { $other } swapped, { $agree } of { $count } poses agree with the pictures of { $name } to { $apart }
        [mixed] in another order, { $agree } of { $count } poses agree with the pictures of { $name } to { $apart }; in the order given, they contradict them
        [tool-changed] with another tool frame from pose { $first } on, { $agree } of { $count } poses agree with the pictures of { $name } to { $apart }; with one tool frame, they contradict them
        [object-moved] with { $name } in another place from pose { $first } on, { $agree } of { $count } poses agree with the pictures to { $apart }; with one place, they contradict them
        [before] { $agree } of { $count } poses agree with the pictures of { $name } to { $apart } if each belongs to the next picture; with their own, they contradict
       *[after] { $agree } of { $count } poses agree with the pictures of { $name } to { $apart } if each belongs to the picture before; with their own, they contradict
    }
poses-all-alike-do-not-tell-mounting = poses that are all alike do not determine the sensor's position on the flange in any direction
poses-contacts-scatter-times-more-than = The poses and contact points scatter { $noise } times more than the arm's encoders explain (limit { $noisy }).
poses-move-too-little = images.csv: by the pictures, the arm moves { $ratio } times as far as its poses say
poses-put-up-apart =
    { $thing ->
        [board] poses { $poses } place the board up to { $apart } apart
       *[object] poses { $poses } place the object up to { $apart } apart
    }
poses-without-contact-points = { $count } poses without contact points
puts-object-fits-other-pose =
    { $readings ->
        [pose] it places the object { $off } away from where the others place it; it fits the robot's pose of pose { $other }
       *[angles] it places the object { $off } away from where the others place it; it fits the joint angles of pose { $other }
    }
puts-object-where-others-put = it places the object { $off } away from where the others place it
reading-of-arm-not-a-number = a reading of the arm { $name } is not a number
readings-shape-arm = readings of shape { $shape } for the arm { $name }
robot-pictures-agree-boards-place-but = Robot and pictures agree on the board's position, but on its tilt only to { $tilt } (rotations of the robot alone: { $turn }).
sensor-turned-most-between-poses-wanted = The sensor rotated by at most { $turn } between the poses (required: { $alike_deg } or more), so they determine little more than a single pose.
set-stripe-axis = Set stripe_axis to { $axis } in the sensor's datasheet, and calibrate again.
so-poses-are-not-what-is-expected =
    { $fault ->
        [inverted] these are poses of the arm's base in the flange frame, or the sensor is fixed and the robot carries the board
        [mirrored] the pictures are mirrored
        [scalar-first] the columns hold qw, qx, qy, qz
        [scalar-first-inverted] these are poses of the arm's base in the flange frame, and the columns hold qw, qx, qy, qz
        [turns-inverted] the rotations are those of the arm's base in the flange frame
        [rotations] { $given ->
            [vector] their numbers were taken for rotation vectors
           *[other] their numbers were taken for angles as { $given }
        }
        [unit] the positions are not in mm
        [late] pictures are missing, or a pose was written twice
        [early] a pose is missing, or a picture was taken twice
        [reversed] pictures and poses are listed in opposite order
        [sorted] pictures and poses are listed in different order
        [swapped] each has the pose of the other
        [mixed] these pictures have the poses of others (picture: its pose): { $pairs }
        [tool-changed] the tool frame of the robot was changed, or the sensor was mounted again
        [object-moved] the board was moved, or the robot's base or user frame was changed
       *[other] poses and pictures are shifted by one
    }
take-more-pictures-8-more-them = take more pictures, at least 8, tilted by 20° or more
take-more-pictures-all-sides-have = Take more pictures from all sides; have the arm identified again.
take-more-pictures-all-sides-hold = Take more pictures from all sides; hold the arm in a compact posture.
take-more-pictures-board-all-corners = Take more pictures with the board in all corners of the picture.
take-more-pictures-each-turned-against = take more pictures, each rotated relative to the others, or touch the object
take-more-pictures-for-camera-and-mounting = Calibrate camera and mounting from more pictures.
take-more-pictures-lasers-line-flat = Take more pictures with the laser line on the flat part of the board.
take-more-pictures-like-these = Take more pictures, tilted to all sides: about { $asked } like these are sufficient in total. If the robot cannot do better, set the limits to what the scans require (--good-um, --usable-um).
take-more-pictures-robot-at-fault = Take more pictures, tilted to all sides. With a deviation this large, the robot's own accuracy is the cause, or its poses are not those of the flange in the arm frame. If the robot cannot do better, set the limits to what the scans require (--good-um, --usable-um).
take-more-pictures-tilted = Take more pictures, tilted to all sides.
take-more-poses-tilted-turned = Capture more poses, tilted and rotated.
take-picture-of-target =
    { $thing ->
        [board] take a picture of the board
       *[object] take a picture of the object
    }
take-pictures-different-distances-tilted-different = take pictures from different distances, or tilted to different sides
take-pictures-tilted-20-more-two = take pictures tilted by 20° or more to two sides
take-pictures-turned-20-more-about = take pictures rotated by 20° or more about two different axes
take-poses-tilted-left-right-front = Capture poses tilted to the left, right, front and back, and rotated about the viewing direction.
they-come-more-than-one-camera = they come from more than one camera, or were scaled
they-do-not-lie-in-one-plane = they do not lie in one plane
tilt-back-by = tilt to the back { $angle }
tilt-front-by = tilt to the front { $angle }
tilt-left-by = tilt left { $angle }
tilt-right-by = tilt right { $angle }
touch-more-points-spread-wide-over = Touch more points, spread widely over the board.
touch-opposite-faces-tilt-more = Touch opposite faces (left and right, front and back, crests and floors), and tilt the sensor more between poses
touches-on-face = { $count } { $where }
turn-anticlockwise-by = rotate anticlockwise { $angle }
turn-clockwise-by = rotate clockwise { $angle }
turn-sensor-so-laser-falls-onto = turn the sensor so that the laser falls onto the board from above
two-lines-in-the-pictures-of-poses = two laser lines are in the pictures of poses { $poses }
usable-edge-stripe-points-poses = { $found } usable edge and stripe points in { $views } poses
use-board-even-odd-count-inner = use a board with an even number of inner corners in one direction and an odd number in the other
use-full-pictures-one-sensor = use full pictures of one sensor
where-sensor-sits-along-axis-cannot = the sensor's position along that axis cannot be determined
working-out-uncertainty = Computing the uncertainty

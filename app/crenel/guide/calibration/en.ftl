abandon-calibration-calibration-use-stays = Cancel this calibration? A calibration in use stays as it is.
accept-calibration = Accept this calibration
after-advised-pose = { $then } after the suggested pose
after-three-points-three-faces = after three points on three faces
all-points-there-go-add =
    { $more ->
        [yes] All points are taken. Continue, or add more as suggested below.
       *[no] All points are taken. Continue, or add more.
    }
all-points-there-go-pictures = All points are taken. Continue to the pictures.
all-there-calibrate = All that it needs is there.
arm-chosen-cannot-read-any-more = The selected arm can no longer be read
arm-object-chosen-cannot-read-any = The selected arm or object can no longer be read.
arm-tip = Arm and tip
back-face = Back face
back-points = Back to the points
before-poses-were-changed-since = Out of date: the poses have changed.
belongs-another-step-calibration-stands =
    { $step ->
        [devices] This belongs to another step; the calibration is at 'Devices'.
        [setup] This belongs to another step; the calibration is at 'Set-up'.
        [touch] This belongs to another step; the calibration is at 'Touch'.
        [place] This belongs to another step; the calibration is at 'Hold'.
        [capture] This belongs to another step; the calibration is at 'Capture'.
        [solve] This belongs to another step; the calibration is at 'Calibrate'.
       *[review] This belongs to another step; the calibration is at 'Review'.
    }
block-known-by-drawing = The block is known by its drawing only. Measured, it is known better.
board-printed-side = Board (printed side)
both-devices-answer-go = Both devices respond. Continue.
but-what-marked-below-needs-attention = However, the items marked below need attention.
calibrate-camera-mounting-and-laser = Calibrate camera, mounting and laser
calibrate-without-the-laser = Calibrate without the laser
calibrating = Calibrating
calibration-cannot-shown = the calibration { $session_id } cannot be displayed
calibration-closed-start-new-one = This calibration is closed. Start a new one.
calibration-computed = The calibration is computed.
calibration-not-kept-any-more = the calibration in use is no longer one of camera and mounting alone for these devices
calibration-not-to-be-used-findings-say-what = Do not use this calibration. The findings state what to do.
calibration-use = The calibration is in use
calibration-utc = Calibration { $now } UTC
camera-and-mounting-are-stored = Camera and mounting are in use, and stored under Records. To scan, add the laser: take pictures in which its line crosses the board.
cancel-calibration = Cancel the calibration
capture = Capture
certify-the-block = Certify the block
charuco-squares-mm-markers = ChArUco board, { $columns } × { $rows } squares of { $square }, { $dictionary }
check-arm-tip-object-sensor-those = Check that the arm with its tip, the object and the sensor selected here are those in use.
check-devices = Check the devices
check-laser-exposure-then-take-new = Check the laser and the exposure, then take a new picture.
chessboard-inner-corners-squares-mm = chessboard, { $columns } × { $rows } inner corners, squares of { $square }
chessboard-seen-several-sides-take-more = A chessboard must be seen from several sides: take { $more } more pictures.
chessboard-seen-several-sides-take-one = A chessboard must be seen from several sides: take one more picture.
choice-needs-field-id = A choice needs a field and an id.
choose-chessboard-for-poses = { $name } reports poses: choose a chessboard as the object.
choose-datasheet-connect-other = Choose the datasheet of this { $name }, or connect the other { $name }.
choose-first = Choose first: { $things }.
choose-of-several = { $count } to choose from
choose-what-use = Choose the equipment
comes-last = It comes when the rest is there.
compute-again = Compute again
compute-calibration-take-another-pose = { $taken } Compute the calibration, or capture another pose.
connect-the-arm = Connect the arm
connect-the-sensor = Connect the sensor
connected-arm-reports-joints-choose = The connected arm reports joint angles, but { $name } reports poses. Choose the arm that is connected.
connected-arm-reports-poses-choose = The connected arm reports poses, but { $name } has joints. Choose the arm that is connected.
connected-has-serial-number-chosen-datasheet = The connected { $name } has the serial number { $serial_number }, but the selected datasheet is for { $serial_number2 }.
connected-sensor = Connected sensor
connected-sensors-picture-has-pixels-choose = The connected sensor's picture has { $width_px } × { $height_px } pixels, but { $name } has { $size } × { $size2 }. Choose the sensor that is connected.
contact-limit = two points of the object are at most { $limit } apart
contact-too-far = This point lies { $apart } from point { $number }, which is farther than the object reaches; it was not taken
continue = Continue
corners-object-found = { $corners_detected } corners of the object are detected.
crests-top = Crests
end-pictures-by-themselves = End the pictures
enter-the-arm = Enter the arm
enter-the-sensor = Enter the sensor
enter-the-target = Enter a block or board
face-has-points-go = This face has its points. Continue with: { $face }.
fault = { CAPITAL($fault) } is at fault. { $text }
figures-before = { $text }: the figures are out of date.
files-no-longer-in-data-folder = its files are no longer in the data folder
floors-grooves = Floors
front-face = Front face
go-back-take-picture-points-again = Go back, and take the picture or the points again.
go-pictures-touches-spread-over-printed = Continue to the pictures. { $wanted } contact points spread over the printed side would check the size of its squares.
go-pose-count-one-other-s =
    { $count ->
        [one] Continue with { $count } pose
       *[other] Continue with { $count } poses
    }
hands-point-face-declined-times = Point { $index } { $where } of the simulated operator was rejected { $attempts } times
hold = Hold
hold-arm-still = Hold the arm still. { $text }.
hold-sensor-over-object = Hold the sensor over the object
hold-sensor-over-object-another-way = Hold the sensor over the object in a new pose.
hold-sensor-over-object-so-lies = Hold the sensor over the object so that it matches the dashed outline.
hold-sensor-straight-above-chessboard-longer = Hold the sensor straight above the chessboard, with the longer side of the board along the picture.
hold-still-take-picture-laser-switches = Hold still and take the picture. The laser switches automatically.
hold-there = Hold it there
in-use-named = { $name } is in use.
laser-beside-object-may-too-dark = The laser is on. Away from its line the object may be too dark to be detected.
laser-did-not-switch-on = The laser did not switch on: this picture determines only camera and mounting.
lasers-line-must-cross-chessboard = The laser line must cross the chessboard in at least { $fewest } pictures, better in every one.
left-end = Left end
left-out = Excluded: { $reason }
line-widths-do-not-ascend = the maximum width must exceed the minimum width
look-for-line-again = Look for the line again
look-numbers-then-accept-calibration-repeat = Check the figures, then accept the calibration or repeat it.
looking-object-picture = Detecting the object in the picture
looks-for-line-again = Looking for the line again
more-poses-would-bring-little = More poses would improve the result only a little.
move-tip-another-place = Move the tip to another position
movement-tip = Movement of the tip
need-arm-model = Model of the arm
need-certificate = Certificate of the block
need-first-calibration = First calibration
need-sensor-datasheet = Datasheet of the sensor
need-target = Block or board
next = Next: { $title }.
next-pose-follow-dashed-outline = Next pose: { $words }. Follow the dashed outline.
no-arm-model-yet = Nothing says how the arm is built. Enter its joints (D-H table), or that it is a robot that reports poses.
no-board-yet = A robot that reports poses is calibrated with a board. None is known yet.
no-datasheet-fits-sensor = None of the sensors entered is the connected one. Enter it, too.
no-laser-stripe-picture = The picture shows no laser stripe.
no-laser-stripe-picture-serves-camera = The picture shows no laser line: it determines only camera and mounting.
no-model-fits-connected-arm = None of the arms entered is the connected one. Enter it, too.
no-picture-shows-object-yet-take = No picture shows the object yet. Take another.
no-pictures-by-themselves = no pictures are taken by themselves
no-point-taken-back-since-last = No point has been removed since the last one was taken.
no-point-taken-yet = No point has been taken yet.
no-sensor-datasheet-yet = Pixels of the sensor and the direction of its line are not known yet. They are asked once it is connected.
no-target-yet = No crenellated block and no board is known yet.
not-computed-data-kept = The calibration could not be computed. All captured data is kept.
not-to-be-used-findings-say-why = Do not use it: the findings state why.
not-usable = Not usable
not-usable-because = Not usable: { $fault }
nothing-changed-since-solved = Nothing has changed since the last computation.
object-picture = The object is in the picture
object-picture-hold-arm-there-clamp = The object is in the picture. Hold the arm there, or clamp it.
objects-place-k-1 = Object's position (k = 1)
on-board = on the board
only-pose-take-another-first = It is the only pose. Capture another first.
picture-cannot-be-used-take-it-again =
    { $others ->
        [yes] This picture cannot be used. Take it again or continue without it.
       *[no] This picture cannot be used. Take it again.
    }
picture-of-pixels = { $width_px } × { $height_px } pixels
picture-whenever-robot-rests = A picture at each rest of the robot
pictures-by-themselves = Pictures by themselves
pictures-by-themselves-only-for-robot-and-board = pictures are taken by themselves only of a board, with a robot without a tip
pictures-were-taken-with-other-sensor = Pictures were taken with another sensor. Begin a new calibration for this one.
plane-needs-lines-in-some = That is sufficient for this pose. The laser line must cross the board in at least { $fewest } other pictures.
point-again = This is point { $point } again
point-back = Point { $index } is restored.
point-beside-face = Point { $index } lies beside the { $face } face: it touched nothing there.
point-cannot-true = Point { $index } is implausible: { $what }; { $why }.
point-lies-on-other-face = Point { $index } misses the { $face } face by { $off } and lies { $where }.
point-misses-face = Point { $index } misses the { $face } face by { $off }.
point-no-longer-there = That point no longer exists.
point-of-face = { $face }, point { $index }
point-off-face = Point { $index } is { $off } off the { $face } face; the others agree to { $rms }.
point-off-face-remove-then-go = Point { $point } is off its face. Remove it, then continue.
point-off-others = Point { $index } lies { $off } off the plane of the other points { $where }.
point-off-plane-others = Point { $index } is { $off } off the plane of the others.
point-removed = Point { $index } is removed.
point-taken-for = Point { $index }, meant { $where }; not judged yet.
point-taken-off = Point { $index } { $where }: { $off }.
points-here-welcome-beside-those-other = { $place } Points here are useful in addition to those on the other faces.
pose-count-one-other-s-taken =
    { $count ->
        [one] { $count } pose is captured.
       *[other] { $count } poses are captured.
    }
pose-excluded = Pose { $n } is excluded
pose-is-set-aside = Excluded
pose-no-longer-there = That pose no longer exists.
pose-not-set-aside = That pose is not excluded.
pose-taken = Pose { $number } is captured.
pose-taken-back = Pose { $n } is included again
pose-would-help-most-scanned-point = The most useful pose: { $words }. Uncertainty of a scanned point: { $now } → { $then } (k = 1).
poses-enough = { $done } poses are sufficient
poses-were-changed-solve-again-undo = The poses have changed. Compute again, or undo the change.
put-point-back = Restore point { $i }
remove-point-first-not-there = Remove point { $index } first: it is not { $where }.
remove-then-touch-face-marked-drawing = Remove it, then touch the face that is marked in the drawing.
remove-touch-there-again = Remove it and touch there again.
remove-touch-there-again-rest-clear = Remove it and touch there again, holding still and away from the edge.
repeat-first-point = Repeat from the first point
repeat-start = Repeat from the start
reports-poses-no-tip = reports poses, no tip
restore-sessions-folder-backup = Restore the session's folder from a backup
review = Review
review-calibration = Review the calibration
right-end = Right end
scan-running-has-laser-stop-first = A scan is running and uses the laser. Stop it first.
second = { $text }, { $rate } per second
sensor = The sensor: { $text }
serial-number-charuco-squares-markers = { $serial_number }: ChArUco board, { $columns } × { $rows } squares of { $square }, { $dictionary }
serial-number-chessboard-inner-corners-squares = serial number { $serial_number }, chessboard, { $columns } × { $rows } inner corners, squares of { $square }
serial-number-joints-tip = serial number { $serial_number }, { $joint_count } joints, tip Ø { $diameter }
serial-number-merlons = serial number { $serial_number }, { $merlon_count } merlons, { $size } × { $size2 } × { $size3 }
serial-number-pixels = serial number { $serial_number }, { $width_px } × { $height_px } pixels
serial-number-poses-no-tip = serial number { $serial_number }, reports poses, no tip
serial-number-poses-tip = serial number { $serial_number }, reports poses, tip Ø { $diameter }
set-aside = Exclude
set-calibration-aside-start-again-beginning = Set this calibration aside and start again from the beginning?
set-up = Set-up
simulation-goes-next-pose = The simulated operator moves to the next pose: { $words }
simulation-holds-sensor-over-object = The simulated operator holds the sensor over the object
simulation-holds-still = The simulated operator holds still
simulation-touches = The simulated operator touches: { $face }
solve-again = Compute again.
some-points-off-their-face-remove = Some points are off their face. Remove them, then continue.
something-changed-since-solved-solve-again = Something has changed since the last computation. Compute again.
spread-points-hold-still-press-arms = { $place } Spread { $wanted } points; hold still and press the arm's button at each.
spread-them-wide-clear-edges = Spread them widely, away from the edges.
start-new-calibration = Start a new calibration
still-turn = Remaining rotation
stored-under-records-scan-or-calibrate-again = It is in use, and listed under Records. The first button is the next step; you can also scan with it at once.
straight-above-chessboard-follow-dashed-outline = Starting straight above the chessboard: { $words }. Follow the dashed outline.
switch-arm-sensor-connect-them = Switch on arm and sensor, and connect them.
switch-laser-look-where-lies = Switch on the laser to see where the line lies.
switch-off-aim-picture-switched-itself = Switch it off to aim. It switches automatically for the picture.
take-another = { $taken } Capture another: { $words }.
take-another-pose = Capture another pose
take-back = Include
take-picture = Take the picture
take-picture-again = Take this picture again
taking-picture = Taking the picture
there-no-earlier-step = There is no earlier step '{ $to }'.
there-no-face = There is no face '{ $face }'.
there-no-here =
    { $field ->
        [arm] There is no arm '{ $chosen }' here.
        [object] There is no object '{ $chosen }' here.
       *[sensor] There is no sensor '{ $chosen }' here.
    }
there-no-picture-object-sensor-take = There is no picture of this object and sensor. Take one.
there-no-picture-yet-take-one = There is no picture yet. Take one.
these-use = Use these
these-use-and-pictures = Use these, then a picture at each rest
tip-is-checked-in-a-seat = Turned about its tip in a seat, the arm shows whether the tip is where its model has it.
tip-lies-within-mm = the tip lies within { $distance } of it
to-calibration = Keeps camera and mounting of { $name }. The board may lie elsewhere.
touch-back-face = Touch the back face.
touch-floors-grooves = Touch the floors of the grooves.
touch-front-face = Touch the front face.
touch-heading = Touch
touch-left-end = Touch the left end.
touch-object = Touch the object
touch-object-or-remove-wrong = Touch the object, or remove point { $number } if that one is wrong
touch-printed-side-more-times-spread = Touch the printed side { $left } more times, spread widely. Or continue.
touch-printed-side-once-more-far = Touch the printed side once more, far from the other points. Or continue.
touch-right-end = Touch the right end.
touch-tops-merlons = Touch the crests.
touches-over-all-faces = { $total } more over all faces, { $most } of them { $where },
touches-would-bring =
    { $total ->
        [one] Uncertainty of the object's position: { $now } (k = 1); { $words } reduces it to { $then }.
       *[other] Uncertainty of the object's position: { $now } (k = 1); { $words } reduce it to { $then }.
    }
touches-would-not-reach =
    { $total ->
        [one] Uncertainty of the object's position: { $now } (k = 1); { $words } reduces it to { $then }; the target is { $target }.
       *[other] Uncertainty of the object's position: { $now } (k = 1); { $words } reduce it to { $then }; the target is { $target }.
    }
uncertainty-scanned-point-k-1 = Uncertainty of a scanned point (k = 1)
uncertainty-scanned-point-so-far-k = Uncertainty of a scanned point so far (k = 1)
uncertainty-seen-point-k-1 = Uncertainty of a point in view (k = 1)
undo-last-point = Undo the last point
up-poses = { $done } of up to { $of } poses
usable-most = { $total }; the limit for usable is { $usable }.
used-but = Used, but { $reason }
waits-for-new-rest = Waits until the robot rests at a new pose with the board in the picture
wanted-points-fit = target: { $target }; points fit to { $rms }
what-is-calibrated = What is calibrated
working-out-which-pose-would-help = Computing the most useful pose

abandon = Abandon
abandon-calibration-calibration-use-stays = Abandon this calibration? The calibration in use stays as it is.
abandoned = abandoned it
about-missing-places-longest-start =
    { $stream ->
        [joints]
            about { $missing } joint samples are missing in { $holes ->
                [one] { $holes } place
               *[other] { $holes } places
            }, the longest { $longest }, { $at } from the start
       *[frames]
            about { $missing } frames are missing in { $holes ->
                [one] { $holes } place
               *[other] { $holes } places
            }, the longest { $longest }, { $at } from the start
    }
accept-calibration = Accept this calibration
accept-verification = Accept this verification
accepted = Accepted
accepted-result = accepted the result
account-has-no-name = The account has no name
account-name-length = 1 to { $most } letters, digits and signs
account-taken = There is an account { $name } already
across-mm = across, mm
act-failed = failed
act-with-detail = { $act }: { $detail }
add-exposure-us-line = Add a line exposure_us = …
add-line = Add a line { $key } = …
add-picture-delete-pose = Add the picture, or delete the pose
add-pictures-turned-about-another-axis = add pictures turned about another axis
added-account = added an account
address-none-message-can-sent = The address is none that a message can be sent to
adjusting-all-poses-together = Adjusting all poses together
after = After
after-advised-pose = { $then } after the advised pose
after-few-more-touches = after a few more touches
after-mark = after
after-three-points-three-faces = after three points on three faces
against-limits = Against the limits
against-use-before-points-measuring-volume = Against { $name }, in use before: points of the measuring volume moved by { $rms } ({ $rms_mm }) rms, { $largest } ({ $largest_mm }) at most.
ages-calibrations-order-records-go-measuring = Ages of calibrations and the order of records go by it; measuring does not.
all-corners-lie-one-level-z = all { $points } corners lie on one level, z = { $z }
all-corners-lie-one-plane-normal = all { $points } corners lie in one plane with normal ({ $normal })
all-corners-were-given-same-pixel = all corners were given the same pixel
all-kept-can-read = All that was kept can be read.
all-pictures-one-sensor-must-have = All pictures of one sensor must have one size.
all-points-there-go-add =
    { $more ->
        [yes] All points are there. Go on, or add more as stated below.
       *[no] All points are there. Go on, or add some.
    }
all-points-there-go-pictures = All points are there. Go on to the pictures.
all-poses-turn-flange-about-one = all { $count } poses turn the flange about one axis, ({ $x } { $y } { $z }) in its own frame
all-there-they-were-recorded = All are there, as they were recorded.
and-more-records = And { $count } more.
angle = Angle, ″
angle-between-clouds = Angle between clouds
angle-touched-plane = Angle to the touched plane
another-arm-answers = Another arm answers at { $url }: { $name } { $serial_number } ({ $joints } joints) in place of { $expected_name } { $expected_serial_number }
another-calibration-came-into-use-meanwhile = Another calibration came into use meanwhile. Begin again with that one.
another-programs-database = { $path } is another program's database
another-station-publishes-under-ones-name = Another station publishes under this one's name.
another-tip-mounted-another-sphere-touched = The tip seems to be { $diameter }, { $expected } by the arm's datasheet: another tip is mounted, or another sphere was touched.
answered-who-asked-control = answered who asked for control
answers-browsers = Answers to browsers
applied-dropped-arms-delay = applied or dropped the arm's delay
approved = Approved
arm-2 = The arm: { $text }
arm-3 = The arm is as it was.
arm-4 = Arm
arm-before = The arm is as it was before.
arm-before-arms-put-back-hand = the arm of before is in arms/{ $replaced }/{ $name }; put it back by hand
arm-by-its-datasheet = it is an arm by its datasheet
arm-check = Arm check
arm-check-2 = arm check
arm-check-no-limit = { $half_range }, no limit was set.
arm-check-with-limit = { $half_range }, limit { $limit }.
arm-checked = The arm is checked: { $worst }.
arm-chosen-cannot-read-any-more = The arm that was chosen cannot be read any more
arm-closed-while-opening = The arm at { $url } was closed while opening
arm-encoders = arm encoders
arm-geometry = arm geometry
arm-has-joint-number = the arm { $arm } has { $count }
arm-has-joints = the arm { $arm } has { $count } joints
arm-has-joints-station-toml-asks = The arm at { $url } ({ $name } { $serial_number }) has { $joints } joints, and station.toml asks for joint_count = { $joint_count }
arm-identified = The arm is identified.
arm-json-names-joints = arm.json names them { $names }
arm-json-tip-goes-far-while = by this arm.json the tip goes far while it is in a seat: { $far } from the middle of seat { $name }
arm-json-tip-goes-fro = { $label }: by arm.json the tip goes { $distance } to and fro
arm-measures-within = an arm measures within { $farthest }
arm-model-arm = the arm model is of arm { $serial_number }
arm-not-open = The arm at { $url } is not open
arm-object-chosen-cannot-read-any = The arm or the object that was chosen cannot be read any more.
arm-place-name =
    { $kind ->
        [bar] bar { $number }, end { $end }
        [sphere] sphere { $number }
       *[seat] seat { $number }
    }
arm-place-title =
    { $kind ->
        [bar] Bar { $number }, end { $end }
        [sphere] Sphere { $number }
       *[seat] Seat { $number }
    }
arm-reports-joints =
    The arm at { $url } reports { $joints ->
        [one] { $joints } joint
       *[other] { $joints } joints
    }
arm-reports-no-counts-per-revolution = The arm at { $url } reports 0 counts per revolution for joint { $joint }
arm-sees-bar-given = the arm sees bar { $bar } as { $measured }, { $given } are given
arm-sends-hello-but-no-samples = The arm at { $url } sends its hello ({ $name }) but no samples
arm-sends-no-joint-angles = the arm sends no joint angles
arm-sends-other-joint-count = The arm at { $url } announced { $expected } joints, but sends { $count }
arm-sends-samples-but-no-hello = The arm at { $url } sends samples but no hello
arm-sent-too-little-arm-camera = the arm sent too little, or arm and camera are not on one clock
arm-speaks-version-protocol-driver-speaks = The arm at { $url } speaks version { $other_version } of the protocol; this driver speaks version 1
arm-stays-shows-nothing-errors = an arm that stays as it is shows nothing of its errors
arm-still = the arm was not still
arm-tip = Arm and tip
arm-url-cannot-be-opened = The arm's url { $url } cannot be opened ({ $reason })
arm-use-already = This arm is in use already.
arm-with-joints-needed = here an arm is needed that reports its joint angles
arms-6-7-joints-served = Arms of 6 or 7 joints are served.
arms-adapter-running = Is the arm's adapter running?
arms-data-has-gap-there = the arm's data has a gap there
arms-motion-moves-other-way-than = by the arm's motion { $name } moves the other way than in the pictures
arms-motion-object-than-certificate-says =
    { $sign ->
        [larger] By the arm's motion the object is { $share } (± { $uncertainty }) larger than its certificate says: all lengths would be off by as much.
       *[smaller] By the arm's motion the object is { $share } (± { $uncertainty }) smaller than its certificate says: all lengths would be off by as much.
    }
arms-motion-squares-wide = by the arm's motion the squares of { $name } are { $width } wide
arms-motion-squares-wide-certificate = By the arm's motion the squares are { $width } wide (± { $uncertainty }), by the certificate { $nominal }: all lengths would be off by as much.
arms-parameters = The arm's parameters
arms-parameters-already-explain-points-well = the arm's parameters already explain the points as well as they are measured
arms-position-known-around-most-pictures = the arm's position is not known around most of the pictures
arms-zero = From the arm's zero
ask-administrator-new-one = Ask an administrator for a new one
ask-control-take-over = Ask for control, or take it over
ask-somebody-with-role =
    { $role ->
        [admin] Ask an administrator
       *[operator] Ask an operator
    }
asked-control = asked for control
asks-control = { $name } asks { $holder } for control.
at-least-limit = ≥ { $limit }
at-most-limit = ≤ { $limit }
attention = Attention
away = { $min } away
axes = Axes
axis-component = Axis { $axis }
axis-level = Axis from level
back = Back
back-face = Back face
back-places = Back to the places
back-points = Back to the points
backup = Backup
backup-2 = The backup is in { $folder }.
backup-being-made-already = A backup is being made already
backup-needs = The backup needs { $total }
backup-replaces-nothing = a backup replaces nothing
bad = Bad
ball-bars = Ball bars
ball-bars-lengths = Ball bars' lengths
ball-diameter = Ø { $diameter }
bar-end-2 = bar { $name } { $position } end { $end }
bar-has-two-ends = a bar has two ends
bar-named = bar { $name }
bar-position-arm-json-ends-lie = bar { $name }, position { $position }: by arm.json its ends lie { $measured } apart, { $length } are given
bar-position-has-ends = { $path }: bar { $bar }, position { $position } has ends { $ends }
bars-end = the bar's end { $value }
bars-lengths-points-scatter-without-them = with the bars' lengths the points scatter by { $scatter }, without them by { $without }
before = Before
before-after = Before and after
before-after-identification = Before and after the identification
before-mark = before
before-poses-were-changed-since = Of before: the poses were changed since.
began-again = began again
began-backup = began a backup
began-cloud = began a cloud
began-resumed-arm-check = began or resumed an arm check
began-resumed-calibration = began or resumed a calibration
began-resumed-verification = began or resumed a verification
began-seat = began a seat
begin-again = Begin again
begin-new-one = Begin a new one
begun = Begun
behind = from behind
being-recorded = it is being recorded
belongs-another-step-calibration-stands =
    { $step ->
        [devices] This belongs to another step; the calibration stands at 'Devices'.
        [setup] This belongs to another step; the calibration stands at 'Set-up'.
        [touch] This belongs to another step; the calibration stands at 'Touch'.
        [place] This belongs to another step; the calibration stands at 'Hold'.
        [capture] This belongs to another step; the calibration stands at 'Capture'.
        [solve] This belongs to another step; the calibration stands at 'Calibrate'.
       *[review] This belongs to another step; the calibration stands at 'Review'.
    }
belongs-another-step-session-stands =
    { $step ->
        [seat] This belongs to another step; the session stands at 'Seat the tip'.
        [swing] This belongs to another step; the session stands at 'Swing the arm'.
       *[result] This belongs to another step; the session stands at 'Result'.
    }
belongs-another-step-verification-stands =
    { $step ->
        [gauge] This belongs to another step; the verification stands at 'Choose the gauge'.
        [touch] This belongs to another step; the verification stands at 'Touch the gauge'.
        [scan] This belongs to another step; the verification stands at 'Scan the gauge'.
       *[review] This belongs to another step; the verification stands at 'Result'.
    }
beyond-limit = Beyond the limit
bits-expected = 8 or 16 bits are expected
bits-per-pixel = { $bits } bits a pixel
block-corner =
    { $level ->
        [crest] crest { $number }
        [floor] floor { $number }
       *[base] base
    }, { $place ->
        [L-front] front left
        [R-front] front right
        [L-back] back left
       *[R-back] back right
    }
board-bends-over-pattern-allowed = The board bends by { $bend } over the pattern: allowed for.
board-bends-over-pattern-flat-expected = The board bends by { $bend } over the pattern; flat to { $flatness } was expected.
board-has-corners = { $name } has { $columns } × { $rows }
board-has-corners-outermost-missing = { $name } has { $columns } × { $rows }; without its outermost corners the others cannot be numbered
board-printed-side = Board (printed side)
board-tilted-most-between-pictures = the board is tilted by { $tilt } at most between the { $seen } pictures
both-devices-answer-go = Both devices answer. Go on.
brightness = Brightness
bring-back-last-backup-delete-under = Bring it back from the last backup, or delete it under Records.
bring-block-closer-so-fills-picture = Bring the block closer, so that it fills the picture.
bring-block-middle-stripe = Bring the block to the middle of the stripe.
bring-front-back-edge-level-into = bring the front and the back edge of a level into the picture
bring-joint-reference-switch-arm-off = bring the joint to its reference and switch the arm off and on; if it goes on, choose the datasheet of this arm
bring-joint-reference-switch-arm-off-2 = bring the joint to its reference and switch the arm off and on
bring-more-object-into-picture = bring more of the object into the picture
bring-more-object-into-picture-sharp = bring more of the object into the picture, sharp and well lit
bring-part-into-sensors-range = bring a part into the sensor's range
bring-part-into-sensors-range-if = Bring the part into the sensor's range; if it is there, look at the exposure.
bring-whole-board-into-picture-outermost = bring the whole board into the picture, and its outermost corners off the laser; if the board has no more, give its own certificate
bring-whole-board-into-picture-sharp = bring the whole board into the picture, sharp and evenly lit
bring-whole-object-into-view-front = bring the whole object into view, from its front and above, and light it evenly
broker = Broker
but-what-marked-below-needs-attention = But what is marked below needs attention.
byte-is-not-utf-8 = byte { $byte } is not UTF-8 text
bytes-but-no-packet =
    { $count ->
        [one] { $count } byte came from { $url }, but no packet of an encoder arm
       *[other] { $count } bytes came from { $url }, but no packet of an encoder arm
    }
calibrate = Calibrate
calibrate-again = Calibrate again
calibrate-first = Calibrate first
calibrate-first-2 = calibrate first
calibrate-sensor-arm-touch-object-then = Calibrate the sensor on the arm: touch the object, then take a few pictures.
calibrate-sensors-again-their-place-belongs = Calibrate the sensors again: their place belongs to the arm as it was.
calibrated = Calibrated
calibrated-distance-camera = Calibrated distance from the camera
calibrating = Calibrating
calibration = Calibration
calibration-acceptance-test-no-characteristic-iso = This is a calibration, not an acceptance test: no characteristic of ISO 10360-8 or ISO 10360-12 is claimed. A verification on gauges tests the scanner.
calibration-accepted-station = This calibration was not accepted at a station.
calibration-age-and-temperature = { $text }, { $ago } old; due after { $limit }, or beyond { $change } (now { $now }).
calibration-arm = the calibration is for arm { $known }
calibration-cannot-read = The calibration { $name } cannot be read.
calibration-cannot-shown = the calibration { $session_id } cannot be shown
calibration-closed-start-new-one = This calibration is closed. Start a new one.
calibration-computed = The calibration is computed.
calibration-due = The calibration is due. { $text }
calibration-has-no-picture = This calibration has no picture { $name }.
calibration-here-any-more = The calibration of { $name } is not here any more
calibration-in-use-unreadable = The calibration in use cannot be read: { $error }
calibration-is-for-joints = the calibration is for one with { $joints }
calibration-is-for-pixels = the calibration is for { $width } × { $height }
calibration-is-for-serial-number = the calibration is for { $serial_number }
calibration-known-here = its calibration is not known here
calibration-pose = the calibration pose
calibration-report = Calibration report
calibration-should-used-findings-say-what = This calibration should not be used. The findings say what to do.
calibration-under-way-go-where-stands = A calibration is under way. Go on where it stands.
calibration-use = The calibration is in use
calibration-use-cannot-read = The calibration in use cannot be read
calibration-utc = Calibration { $now } UTC
calibration-valid-verified-scan-part = The calibration is valid and verified. Scan the part.
calibration-verified-yet = This calibration was not verified yet.
calibrations-unknowns-did-settle-what-seen = the calibration's unknowns did not converge on the pictures and contacts
camera = The camera { $source }
camera-cannot-do = { $title } cannot do { $key } = { $value }; it offers { $given }
camera-looks-along-laser-plane-deg = the camera looks along the laser plane, { $angle } off it (limit { $limit })
camera-must-look-stripe-side-check = the camera must look at the stripe from the side: check how the sensor is built
camera-needs-two-levels-four-sides = a camera needs two levels and four sides of its merlons
cameras-are = Cameras there are: { $names }.
cameras-matrix-needs-least-six-crests = the camera's matrix needs at least six, on crests and floors
cameras-parameters-did-settle-pictures-edges = the camera's parameters did not converge on the picture's edges
cameras-pixels-come-out-out-square = The camera's pixels come out { $difference } out of square; those of today's sensors are square (limit { $limit }).
can-read-more-than-one-way = it can be read in more than one way
can-written = It can be written.
cannot-be-copied = { $path } cannot be copied
cannot-be-opened-for-writing = { $path } cannot be opened for writing
cannot-deleted-now = It cannot be deleted now
cannot-hidden-now = It cannot be hidden now
cannot-read = It cannot be read: { $text }
cannot-read-2 = { $password_file } cannot be read
cannot-shown = { $name } cannot be shown: { $error }
cannot-shown-2 = { $name } cannot be shown.
cannot-start = { $title } cannot start
cannot-written = It cannot be written: { CLAUSE($trouble) }.
capital = { CAPITAL($text) }
capture = Capture
centre = Centre { $axis }
centre-m = Centre, µm
centre-radius-cannot-be-separated = centre and radius cannot be separated
certificate = Its certificate
certificate-2 = certificate { $certificate }
certificate-says = its certificate says { $square }
certificate-trusted-here = its certificate is not trusted here
change = Change
change-one-them = change one of them
change-permissions-place = Change its permissions or the place
change-place = Change the place
changed-account = changed an account
changed-after-session-had-written = { $name } was changed after this session had written it
changed-notifications = changed the notifications
changed-own-password = changed the own password
changed-settings = changed the settings
check-address-below-try = Check its address below, and try it.
check-address-network = Check its address and its network.
check-address-network-and-power = Check its address, its network, and that it is switched on.
check-again = Check again
check-ago-failed = The check { $ago } ago failed: { $text }
check-arm = Check the arm
check-arm-again = Check the arm again
check-arm-json-against-arm-signs = Check arm.json against the arm: signs, units, lengths, the order of the joints; and the points of that place
check-arm-play-tip-sensor-loose = Check the arm for play, the tip and the sensor for a loose mount; hold still.
check-arm-tip-object-sensor-those = Check that the arm with its tip, the object and the sensor are those in use.
check-arm-url = Check the arm's url.
check-arms-cable-then-switch-arm = check the arm's cable, then switch the arm off and on
check-arms-file-lengths-angles-signs = Check the arm's file: its lengths and angles, the signs and the order of its joints, and the tip; then which face each contact was taken on, and the object's certificate
check-baud-rate-arm-port-another = Check the baud rate, and that the arm is on this port and not another device.
check-board-how-exact-certificate-takes = Check that this is the board, and how exact its certificate takes it to be.
check-broker-runs-user-password-right = Check that the broker runs and that user and password are right. It is tried again.
check-cable-no-other-program-uses = Check its cable, and that no other program uses it.
check-cable-power = Check its cable and its power.
check-cable-power-looked-again-itself = Check its cable and its power. It is looked for again by itself.
check-cannot-made = The check { $name } cannot be made: { CLAUSE($reason) }.
check-chosen-gauge-tip-arms-own = Check that this is the chosen gauge, and that the tip is the arm's own.
check-connection = Check its connection.
check-devices = Check the devices
check-diameter = { $finding }: check its diameter
check-diameter-mm-spheres-take-sphere = Check diameter_mm of the spheres; take this sphere again or delete its rows
check-each-laser-picture-own-pose = Check that each laser picture is of its own pose, taken without moving the sensor, and that the laser sits firmly; then its focus.
check-each-laser-picture-own-pose-2 = check that each laser picture is of its own pose, that the laser was not moved against the camera, and that the line in the picture is its own and not a reflection
check-encoder-swing-arm-so-every = Check the encoder; swing the arm so that every joint turns
check-encoders-arm-json-how-points = Check the encoders, arm.json, and how the points were taken
check-failed = A check that failed
check-first-page-arm-tip-takes = Check it first, on the page of arm and tip; it takes a minute.
check-folders-owner-whether-disk-mounted = Check the folder's owner and whether its disk is mounted.
check-joints-encoder-cable-then-bring = check the joint's encoder and cable, then bring the arm to its reference
check-laser-board-camera-kept-still = Check that laser, board and camera kept still, and that picture and pose are of one moment.
check-laser-exposure-sensors-stripe-axis = check the laser, the exposure and the sensor's stripe_axis, and let the stripe cross the object's middle
check-laser-exposure-then-take-new = Check the laser and the exposure, then take a new picture.
check-laser-line-crossed-object-exposure = Check that the laser was on, that its line crossed the object, and the exposure; take the pose again.
check-laser-moved-against-camera-line = check that the laser was not moved against the camera, and that the line in the picture is its own and not a reflection
check-laser-picture-pose-sensor-held = Check that its laser picture is of this pose, that the sensor was held still between its two pictures, and that the laser sits firmly; take the pose again.
check-lasers-interlock-key-switch-capture = check the laser's interlock and key switch, and capture again
check-length-mm-bar-ends = Check length_mm of bar { $bar }, and its ends
check-length-unless-datasheet-is-as-far-off = { $finding }: check its length, unless the arm's datasheet is as far off
check-moved-every-picture-has-arms =
    { $thing ->
        [board] check that the board was not moved, and that every picture has the arm's readings of its own pose
       *[object] check that the object was not moved, and that every picture has the arm's readings of its own pose
    }
check-object-certificate-lengths-mm = Check that this is the object of the certificate, and its lengths in mm.
check-object-picture-take-picture-again = check that this is the object in the picture, and take the picture again
check-object-pictures-every-picture-belongs = check that this is the object in the pictures, and that every picture belongs to its arm pose
check-objects-certificate-cameras-flip-setting = check the object's certificate and the camera's flip setting
check-objects-certificate-which-sides-front = Check the object's certificate, and which of its sides is the front
check-one-seat = This is a check of one seat.
check-owner-and-permissions = Look at its owner and permissions, and at whether its disk is mounted read-only
check-path = Check the path
check-picture-joint-angles-one-moment = Check that picture and joint angles are of one moment, or take the pose again.
check-pictures-joint-angles-own = Check that the picture's joint angles are its own.
check-pictures-joint-angles-those-their = Check that the pictures' joint angles are those of their poses.
check-pictures-mirrored-poses-those-flange = check that the pictures are not mirrored, and that the poses are those of the flange in the arm's frame, in mm, with qw last, and not their inverse
check-recorded-limit-set-before-next = This check is recorded with its limit. Set it before the next one.
check-sensor = Check the sensor.
check-sensor-path = Check [sensor] path.
check-sensor-source = Check [sensor] source.
check-sensors-cable-close-other-programs = Check the sensor's cable, or close other programs.
check-session-taken-arm = check that the session was taken with this arm
check-signs-lengths-joints-order = Check signs, lengths and the order of the joints in arm.json
check-square-mm-tip-arm-json = check square_mm, the tip in arm.json, and that the board was not moved
check-station-disk = Look at the station's disk
check-system-log-and-disk = Look at the system's log and at the disk; keep the data folder as it is
check-tip = Check the tip
check-tip-again = Check the tip again
check-tip-mounted-against-arms-file = Check the tip that is mounted against the arm's file, and that nothing moved; have the arm's model identified again.
check-tip-one-arms-file-block = Check that the tip is the one of the arm's file, that block and arm stood firm, and the arm's model.
check-tip-one-arms-file-board = Check that the tip is the one of the arm's file, and that board and arm stood firm.
check-tip-play-faces-dirt-have = Check the tip for play and the faces for dirt; have the arm's model checked.
check-tips-diameter-block-then-arms = Check the tip's diameter and that this is the block; then the arm's model.
check-which-arm-plugged = Check which arm is plugged in.
check-which-face-each-contact-taken = Check which face each contact was taken on, the tip, and the object's certificate
check-which-tip-mounted-diameter-length = Check which tip is mounted, its diameter and its length, and that the object was not moved after it was touched.
check-which-tip-mounted-diameter-object = Check which tip is mounted, its diameter, and that this is the object.
check-which-tip-mounted-stylus-straight = Check which tip is mounted and that its stylus is straight and tight; have its place determined again, and touch the object again.
checked = Checked
checked-ago = Checked { $ago } ago: { $text }
checked-ago-after-check-due = Checked { $ago } ago; after { $limit } a check is due.
checking-places-held-out = Checking on places held out
checksum-wrong-at-byte = { $name }: the checksum at byte { $byte } is wrong
chessboard-inner-corners-squares-mm = chessboard, { $columns } × { $rows } inner corners, squares of { $square }
chessboard-seen-several-sides-take-more = A chessboard is seen from several sides: take { $more } more pictures.
chessboard-seen-several-sides-take-one = A chessboard is seen from several sides: take one more picture.
chessboard-x-inner-corners-found = a chessboard of { $columns } × { $rows } inner corners was found
choice-needs-field-id = A choice needs a field and an id.
choose-another = Choose another
choose-another-name = Choose another name
choose-another-place = Choose another place
choose-arm-first = Choose the arm first.
choose-arm-first-2 = choose the arm first
choose-datasheet-connect-other = Choose the datasheet of this { $name }, or connect the other { $name }.
choose-first = Choose first: { $things }.
choose-folder-elsewhere-best-another-disk = Choose a folder elsewhere, best on another disk
choose-gauge = Choose the gauge
choose-gauge-first = Choose the gauge first.
choose-gauge-scanned = Choose the gauge that is scanned
choose-object-before-camera-if-one = choose the object that is before the camera; if it is this one, look whether its edges are clean and undamaged
choose-shorter-one = Choose a shorter one
choose-what-use = Choose what is in use
chose-arm = chose the arm
chose-artefact = chose the artefact
chose-face = chose a face
chose-gauge = chose the gauge
chose-what-use = chose what is in use
chosen-gauge-has = the chosen gauge has { $diameter }
clamp-bar-firmly-reach-put-tip = Clamp the bar firmly in the reach, { $where }, and put the tip into one end.
clamp-cone-ball-seat-about-two = Clamp the cone or ball seat at about two thirds of the reach and put the tip into it.
clamp-firmly-reach = Clamp it firmly in the reach, { $where }.
clamp-firmly-within-arms-reach-sphere = Clamp it firmly within the arm's reach. A sphere shows the most; a plane is quicker.
clamp-seat-firmly-reach-put-tip = Clamp the seat firmly in the reach, { $where }, and put the tip into it.
clamp-seat-take-place-again-delete = Clamp the seat, and take this place again or delete its rows
clamp-sphere = Clamp the sphere
clean-blocks-edges-check-focus-lighting = Clean the block's edges; check focus, lighting and certificate.
clean-both-check-again = Clean both, and check again.
clean-gauge-tip-check-clamps-verify = Clean gauge and tip, check the clamps, and verify again; then calibrate again.
clean-tip-clamp-sphere = Clean the tip, and clamp the sphere
clean-tip-seat-check-clamps-repeat = Clean tip and seat, check the clamps, and repeat. If it stays, identify the arm.
clear-them-draw-them-again = Clear them, and draw them again.
clock = Clock
clock-jumps-times-first-start-points =
    { $stream ->
        [joints]
            the clock of the joint samples jumps { $jumps ->
                [one] once, { $first } from the start
               *[other] { $jumps } times, first { $first } from the start
            }; points near a jump may be out of place
       *[frames]
            the clock of the frames jumps { $jumps ->
                [one] once, { $first } from the start
               *[other] { $jumps } times, first { $first } from the start
            }; points near a jump may be out of place
    }
clock-set-since-start-last =
    { $count ->
        [one] The clock was set once since the start, by { $last_jump }.
       *[other] The clock was set { $count } times since the start, last by { $last_jump }.
    }
close-other-programs-restart-station-between = Close other programs, or restart the station between two scans.
close-program-second-station-same-port = Close that program, or a second station on the same port.
close-what-else-uses-machine = Close what else uses the machine.
cloud-of-another-shape = { $file }: the points lie { $rms } (rms) about the { $shape ->
        [plane] plane
       *[sphere] sphere
    }: they are hardly of one. Give the cloud of the gauge alone
cloud-of-odd-size = { $file } is { $size } large if its unit is { $unit }. State the unit with --unit m, mm or inch
cloud = Cloud
cloud-being-scanned-already = A cloud is being scanned already.
cloud-cloud = { $title }, cloud by cloud.
cloud-data-folder = The cloud of { $name } is not in the data folder
cloud-formats = clouds are written as { $suffixes }
cloud-has-no-points = it holds no points
cloud-has-points = The cloud has { $points } points
cloud-has-points-of = { $path } holds { $count } of { $announced } points
cloud-holds-usable-points =
    { $points ->
        [one] the cloud holds { $points } usable point
       *[other] the cloud holds { $points } usable points
    }
cloud-name-proposal = Name it { $name }
cloud-no-points-lie-rms-off =
    { $shape ->
        [sphere] The cloud is no sphere: its points lie { $rms } rms off one
       *[plane] The cloud is no plane: its points lie { $rms } rms off one
    }
cloud-no-use = Cloud { $number } is of no use.
cloud-not-as-scan-wrote-it = { $path } is not as a scan leaves it
cloud-plane = { $left_out } of cloud { $number } are not of the plane.
cloud-rms-about-gauge = Cloud { $number }: { $rms } rms about the gauge.
cloud-shows-cap-sphere = The cloud shows a cap of { $angle } of the sphere
cloud-strip-wide = The cloud is a strip { $width } wide
clouds = { $done } of { $clouds_wanted } clouds
clouds-2 = Clouds
clouds-enough = { $clouds_most } clouds are enough.
clouds-rebuilt-every-calibration = The clouds are rebuilt with every calibration.
code-wrong = The code is wrong.
coefficient = Coefficient
column-cell-is = { $place }: column { $column } is { $value }
column-empty = { $place }: column { $column } is empty
column-is = { $place }: { $column } is { $value }
column-stands-there-twice = { $path }: column { $names } appears twice
columns-not-separated-by-commas = its columns are not separated by commas
come-nearer-object-fills-wanted = Come nearer: the object fills { $fills }, { $least } wanted
comes-after-calibration = It comes after the calibration.
compare-blocks-depth-heights-certificate = Compare the block's depth and heights with its certificate.
complete-delete-row = Complete or delete the row
complete-or-delete-rows-of-position = Complete or delete the rows of this position
compute-calibration-take-another-pose = { $taken } Compute the calibration, or take another pose.
computer-behind-queue-full = The computer is behind: its queue is { $share } full
confirmed-devices = confirmed the devices
confirmed-gauge = confirmed the gauge
confirmed-object-picture = confirmed that the object is in the picture
confirmed-touches = confirmed the touches
confirmed-what-use = confirmed what is in use
connect-arm-calibrate-one = connect that arm, or calibrate with this one
connect-calibrate-one =
    { $device ->
        [arm] connect that arm, or calibrate with this one
       *[sensor] connect that sensor, or calibrate with this one
    }
connected = Connected to { $host }.
connected-2 = Not connected to { $host } for { $duration }: { CLAUSE($reason) }.
connected-3 = The { $title } is connected
connected-arm-has-joints = the connected arm has { $joints } joints
connected-arm-has-joints-has-choose = The connected arm has { $connected_joints } joints, { $name } has { $joint_count }. Choose the arm that is connected.
connected-has-serial-number =
    { $device ->
        [arm] the connected arm has the serial number { $serial_number }
       *[sensor] the connected sensor has the serial number { $serial_number }
    }
connected-has-serial-number-chosen-datasheet = The connected { $name } has the serial number { $serial_number }, the chosen datasheet is for { $serial_number2 }.
connected-sensors-picture-has-pixels-choose = The connected sensor's picture is { $width_px } × { $height_px }, { $name } has { $size } × { $size2 } pixels. Choose the sensor that is connected.
connected-yet = not connected yet
connecting = Connecting to the { $title }
contact-labelled-but-misses-face = contact { $number } is labelled { $face }, but misses that face by { $distance }
contact-off-by = { $number } ({ $face }, { $off })
contact-points = contact points
contact-unknown-face = contact { $number } is on an unknown face '{ $face }'
contacts = the contacts
contacts-agree-blocks-size-tips-diameter = The contacts agree with the block's size and the tip's diameter: { $checked }.
contacts-arm-has-no-tip = { $readings } contacts, and the arm { $name } has no tip
contacts-disagree-others-were-left-out =
    { $left_out ->
        [one] { $left_out } of { $count } contacts disagrees with the others and was left out: { $named }.
       *[other] { $left_out } of { $count } contacts disagree with the others and were left out: { $named }.
    }
contacts-do-fix-objects-position = { $count } contacts do not fix the object's position
contacts-face-lie-one-line = the { $count } contacts { $where } lie on one line
contacts-fit-block-rms = { $count } contacts fit the block to { $rms } rms.
contacts-fit-block-rms-only-all = the contacts fit the block to { $rms } rms only, and { $beside } of { $count } not at all
contacts-fit-block-rms-up-good = { $count } contacts fit the block to { $rms } rms; up to { $good } is good.
contacts-lie-beside-crests-floors-were = { $off_face } of { $contacts } contacts lie beside the crests or floors that were touched
contacts-lie-beside-face-they-labelled = { $beside } of { $count } contacts lie beside the face they are labelled with ({ $faces })
contacts-lie-board-rms = { $count } contacts lie on the board to { $rms } rms.
contacts-lie-board-rms-up-good = { $count } contacts lie on the board to { $rms } rms; up to { $good } is good.
contacts-lie-off-board-pictures-show = the { $touches } contacts lie { $usual } off the board that the pictures show
contacts-lie-than-blocks-size-tips =
    { $sign ->
        [apart]
            The contacts on { $pair ->
                [left] left and right
               *[front] front and back
            } lie { $opening } further apart than the block's size and the tip's diameter give (limit { $limit }).
       *[together]
            The contacts on { $pair ->
                [left] left and right
               *[front] front and back
            } lie { $opening } closer together than the block's size and the tip's diameter give (limit { $limit }).
    }
contacts-pictures-agree-better-tip-than = Contacts and pictures agree better with a tip of { $fitted } (± { $known }) than with { $given }.
contacts-pictures-agree-better-tips-centre = Contacts and pictures agree better with the tip's centre { $off } from where the arm's file has it: by { $x }, { $y }, { $z } (± { $known }) in the flange frame. Scanned points may be off by as much.
contacts-rms =
    Contact points, rms of { $count ->
        [one] { $count } touch
       *[other] { $count } touches
    }
contacts-rms-outliers = Contact points, rms of { $count } touches, { $outliers } left out
contacts-scatter-times-what-arms-encoders = The contacts scatter by { $sigma }, { $arm_excess } times what the arm's encoders explain (limit { $excess }).
contacts-stripe-several-levels-need-crenellated = contacts and stripe on several levels need a crenellated object
contacts-tips-sphere = contacts are of a tip's sphere
contacts-were-given-positions = { $count } contacts were given with positions { $shape }
continue = Continue
convention-is-pose = { $path }: convention is 'pose'
convert-columns-degrees = Convert the columns to degrees
convert-columns-x-mm-y-mm = Convert the columns x_mm, y_mm and z_mm to millimetres
convert-lengths-mm-name-columns = Convert lengths to mm, and name the columns { $names }
convert-them-name-columns = Convert them and name the columns { $first } to { $last }
coordinates = Its coordinates
copy-differs-from-source = The copy is not what was read from { $path }
copy-whole-service-receives = Copy it whole from the service that receives
corner = corner { $column },{ $row }
corners-can-measured = { $found } of { $corners } corners of { $name } can be measured
corners-fix-camera-badly-condition-number = the { $points } corners fix the camera badly (condition number { $condition }, limit { $limit })
corners-fix-camera-weakly-condition-number = The corners fix the camera weakly: condition number { $condition } (good below { $good }, refused above { $limit }).
corners-lie-off-regular-pattern-certificate = The corners lie { $off } off a regular pattern, by the certificate { $standard_uncertainty }: allowed for.
corners-object-found = { $corners_detected } corners of the object are found.
corners-px = Corners, px
corners-rms = Corners, rms
corners-were-found = { $found } of { $corners } corners of { $name } were found
corners-were-found-picture = { $points } corners were found in the picture
corners-were-taken-others-do-belong = the corners were taken for others, or do not belong to this object
corners-would-lie-behind-camera = { $behind } of { $points } corners would lie behind the camera
correct-cell-delete-row = Correct the cell or delete the row
correct-it = Correct it
correct-name = Correct the name
correct-option = Correct { $key }.
correct-remove-file = Correct or remove the file.
correct-sensor-exposure-us-take-out = Correct [sensor] exposure_us, or take it out.
correct-sensor-take-out = Correct [sensor] { $key }, or take it out.
correct-tips-diameter-arm-json-what = Correct the tip's diameter in arm.json, or what the tables give
correct-value-or-give-arm-json = Correct the value, or give the right arm.json
correct-value-or-name-artefact-differently = Correct the value, or name another artefact differently
correlated-known-together = Correlated: known together, each alone less well
could-solved-what-taken-kept = This could not be solved. What was taken is kept.
could-true-last-ago = { $count } could not be true, the last { $ago } ago: { CLAUSE($what) }.
create-choose-another-place = Create it, or choose another place
crenel = Crenel { $version }
crest-z-mm-must-above-floor = crest_z_mm must be above floor_z_mm, and that above base_z_mm
crests-top = Crests (top)
damaged = It is damaged: { $trouble }.
dark-brightest-pixel = it is dark: its brightest pixel is at { $brightest } of { $full } grey levels
data-folder = Data folder
data-folder-any-more = { $name } is not in the data folder any more.
data-folder-cannot-be-used = The data folder { $folder } cannot be used
data-folder-in-use = The data folder { $folder } is in use by another Crenel server (process { $process })
data-speak-errors-arms-links-each = The data point to errors of the arm's links of { $links } and { $turns } each; what is left of them makes { $share } of a point's uncertainty.
database = Database
database-cannot-be-written = the database cannot be written: { $error }
database-is-empty = { $database } is empty
database-is-not-there = { $database } is not there
database-not-damaged = the station's database cannot be opened there; it is not damaged
database-of-later-version = { $path } was written by a later version of Crenel (schema { $version }, this one knows { $known })
datasheet-lets-turn = its datasheet lets it turn from { $low } to { $high }
date = Date
decision = Decision
decision-rule-iso-14253-1-error = Decision rule by ISO 14253-1: the error of the diameter passes where it is proven within its limit, by more than its expanded uncertainty (k = 2); it fails where it is proven beyond. The scatter is compared with its limit directly.
decision-rule-iso-14253-1-pass = Decision rule by ISO 14253-1: pass where the value is proven within its limit, by more than its expanded uncertainty (k = 2); fail where it is proven beyond; else undecided.
decision-rule-limits-set-standard-uncertainty = Decision rule: the limits are set on the standard uncertainty itself and compared with it directly, without a guard band.
decision-rule-max-min-2-each = Decision rule: (max − min)/2 of each axis is compared with its limit directly; there is no guard band: what the form of seat and tip adds is not stated.
delay-would-known-all = the delay would not be known at all
delay-would-known-k-1 = the delay would be known to { $u } (k = 1)
delete-one-rows = Delete one of the rows
delete-scans-under-records-use-larger = Delete scans under Records, or use a larger disk.
delete-what-stands-there-twice = Delete the duplicates
deleted = { $name } was deleted
deleted-scan = deleted a scan
denavit-hartenberg-parameters-do-same = the Denavit-Hartenberg parameters do the same
depth-mm = depth, mm
deviations-distances-one = deviations are distances from one
device-cannot-be-opened = { $title } cannot be opened
device-cannot-be-played = { $title } cannot be played
device-closed = { $title } is closed
device-closed-while-opening = { $title } was closed while opening
device-failed = { $title } failed: { $error }
device-lost = { $title } was lost
device-not-open = { $title } is not open
devices = Devices
diameter = Diameter
diameter-of-tip-by-datasheet = Diameter of the tip by its datasheet
diameter-tip-found = Measured diameter of the tip
did-you-mean = Did you mean { $name }?
disk = Disk
disk-fails = The disk of { $folder } does not read or write as it should
disk-fails-takes-every-calibration-scan = A disk that fails takes every calibration and scan with it.
disk-full = the disk is full
disk-full-during-scan = The disk was full during this scan.
disk-of-backup-loses-data = the disk of the backup does not store what is written to it
disk-of-data-folder-full = The disk of the data folder { $folder } is full
disk-of-folder-full = The disk of { $folder } is full
disk-quota-used-up = the disk quota is used up
disk-read-only = the disk is read-only
disks-largest-file-size-reached = the disk's largest file size is reached
distance = Distance
distance-between-clouds = Distance between clouds
distance-between-clouds-centres = Distance between the clouds' centres
distance-each-touch-face-times-larger = Distance of each touch from its face, { $factor } times larger: blue outside, orange inside, crosses left out. The longest stick is { $largest } ({ $largest_mm }).
distance-each-touch-sphere-through-all = Distance of each touch from the sphere through all of them.
distance-fitted-shape-blue-outside-orange = { $name }: distance from its fitted shape, blue outside, orange inside.
distance-out-of-range =
    { $side ->
        [near] Too near: { $distance }, { $low } to { $high } wanted
       *[far] Too far: { $distance }, { $low } to { $high } wanted
    }
distance-touched-centre = Distance from the touched centre
distance-touched-plane = Distance from the touched plane
distortion = Distortion
distortion-not-invertible = distortion cannot be undone all over the picture
document-format = { $path }: format is { $format }
document-version = { $path }: version is { $version }
does-not-take-exposure = { $title } does not take an exposure of { $exposure }
does-take = { $path } does not take { $method }.
does-take-notifications-given-up = { $host } does not take notifications: { $trouble } ({ $failed } given up).
done = Done
draw-over-part-cloud = draw it over a part of the cloud
draw-pictures-of-each-folder-apart = Draw the pictures of each folder apart
driver-cannot-be-loaded = The { $table } driver { $name } of { $package } cannot be loaded: { $kind }: { $error }
driver-not-callable = The { $table } driver { $name } of { $package } is not callable: { $value }
driver-offered = The { $table } driver { $name } is offered by several: { $packages }
driver-takes = It takes { $names }.
drivers-are = Drivers there are: { $names }.
drop-cloud = Drop this cloud
drop-last-place = Drop the last place
dropped-cloud = dropped a cloud
dropped-seat = dropped a seat
dropped-swing = dropped a swing
dropping-cloud = Dropping the cloud
duration-days =
    { $count ->
        [one] { $count } day
       *[other] { $count } days
    }
duration-hours =
    { $count ->
        [one] { $count } hour
       *[other] { $count } hours
    }
duration-minutes =
    { $count ->
        [one] { $count } minute
       *[other] { $count } minutes
    }
each-point-needs-three-coordinates-one = each point needs three coordinates and one pixel (u, v)
each-point-swing-about-middle-all = Each point of the swing about the middle of all, in the arm's frame.
each-touchs-distance-sphere = Each touch's distance from the sphere
edge-of-base =
    { $side ->
        [left] the base's left edge
        [right] the base's right edge
        [front] the base's front edge
       *[back] the base's back edge
    }
edge-of-crest =
    { $side ->
        [left] the left edge of merlon { $number }'s crest
        [right] the right edge of merlon { $number }'s crest
        [front] the front edge of merlon { $number }'s crest
       *[back] the back edge of merlon { $number }'s crest
    }
edge-of-floor =
    { $side ->
        [left] the left edge of groove { $number }'s floor
        [right] the right edge of groove { $number }'s floor
        [front] the front edge of groove { $number }'s floor
       *[back] the back edge of groove { $number }'s floor
    }
edge-width = Edge width
edges-corners = edges and corners
edges-corners-rms = Edges and corners, rms
edges-lie-off-average-where-certificate = its edges lie { $usual } off on average, and { $edge } { $distance }, from where the certificate puts them
edges-px = Edges, px
edges-would-fit-only-if-cameras = its edges would fit only if the camera's pixels were { $off_square } out of square
edges-would-fit-only-lens-distorted = its edges would fit only a lens distorted by k1 = { $k1 }, k2 = { $k2 }
edges-x-mm-must-ascend-follows = edges_x_mm must ascend: { $right } follows { $left }
edges-x-mm-odd-count =
    edges_x_mm holds { $count ->
        [one] { $count } edge
       *[other] { $count } edges
    }; every merlon has two, a left and a right one
empty = it is empty
encoder-stands-still-switch-arm-off = its encoder does not move: switch the arm off and on, and check the joint's cable
end-cloud = End the cloud
end-name = End the name with .html or .pdf
ended = ended it
ended-token-metrics = ended a token for metrics
enough-places = Enough places
entered-consoles-code = entered by the console's code
entered-the-temperature = entered the temperature
entry-point-must-name-function-takes = Its entry point must name a function that takes the options.
error = Its error
error-budget = Error budget
error-budget-with-limits = Sources of the standard uncertainty (k = 1) of a scanned point. Limits: good up to { $good }, usable up to { $usable }.
error-in-column = column { $place }
error-in-row = row { $place }
error-radius = Error of the radius
error-there-something-program-did-foresee = An error there is something that the program did not foresee.
error-what = { CLAUSE($what) }.
error-what-and-why = { CLAUSE($what) }: { CLAUSE($why) }.
errors-arms-own-model-joint-angles = Errors of the arm's own model, joint angles that are not the picture's, and an object moved since it was touched cannot be seen from one picture in one pose, and are not in this figure.
errors-last-hour =
    { $count ->
        [0] No error in the last hour.
        [one] One error in the last hour.
       *[other] { $count } errors in the last hour.
    }
even-best-arm-points-still-scatter = even by the best arm the points still scatter by { $scatter }
every-figure-keeps-limit = Every figure is within its limit.
every-figure-keeps-limit-2 = Not every figure is within its limit.
every-figure-known-well-enough-judged = Not every figure is known well enough to be judged.
every-file-has-content-result-made = Every file has the content that the result was made from.
every-reading-joints-could-true = Every reading of the joints could be true.
every-stripe-pictures-wait-them = Every stripe is in it; pictures wait for them.
everything-grows-metre-aluminium = Everything grows with it, a metre of aluminium by { $growth } per degree.
exceed-limit-m = { $half_range } exceed the limit of { $limit }.
expanded-uncertainty-note = U = { $expanded_uncertainty }, k = 2
expected = { $wanted } is expected
expected-by-datasheet-and-expanded-uncertainty = { $expected } by its datasheet; U = { $expanded_uncertainty }, k = 2
exposure-set-lasers-line = The exposure is set by the laser's line
extracting-laser-stripe = Extracting the laser stripe
extraction-detection = Extraction and detection
face-3 = Face
face-and-number = { $face } { $number }
face-can-turn-about-line = the face can turn about that line
face-has-points-go = This face has its points. Go on with: { $face }.
faces-agree-to = { $first } and { $second } to { $opening }
faces-are = the faces are { $names }
faces-contacts = { $faces } faces for { $contacts } contacts
fail = Fail
failed-2 = { $title } failed
far-out = far out
fault = { CAPITAL($fault) } is at fault. { $text }
feature-given-single-scanned-point-iso = For a feature given by a single scanned point, ISO 14253-1 with its default of 95 % proves conformance where the point stays { $guard } ({ $guard_mm }, { $factor } standard uncertainties) inside its tolerance; nonconformance, that far outside.
field-is = { $path }: { $place } is { $value }
field-missing =
    { $more ->
        [0] { $path }: { $place } is missing
       *[other] { $path }: { $place } is missing (and { $more } more)
    }
field-must-be-less-than-half-square = { $field } must be less than half a square; is it in micrometres?
figure = Figure
figure-beyond-limit = { $title }: { $value }, beyond the limit of { $limit }, by more than its uncertainty of { $uncertainty } (k = 2).
figure-near-limit = { $title }: { $value }, nearer to the limit of { $limit } than its uncertainty of { $uncertainty } (k = 2), so it is not decided.
figure-within-limit = { $title }: { $value }, within the limit of { $limit }, by more than its uncertainty of { $uncertainty } (k = 2).
figures-against-their-limits = The figures against their limits
figures-before = { $text }: the figures are of before.
figures-break-limits-not-compared = Not every figure is within its limit; scan and probe were not compared.
figures-keep-limits-not-compared = Every figure is within its limit; scan and probe were not compared.
figures-undecided-not-compared = Not every figure is known well enough to be judged; scan and probe were not compared.
file = a file
file-4 = File
file-carries-no-verdict = The file carries no verdict.
file-cut-off = the file was cut off
file-damaged = the file was damaged
file-has-name-folder-needed = a file has the name of a folder that is needed
file-has-no-contact-points = { $path } holds no contact points
file-has-no-pictures = { $path } holds no pictures
file-has-no-points = { $path } holds no points
file-larger-than-any-read = nothing that is read here is as large
file-name-is-not-utf-8 = The name of { $name } is not UTF-8 text
files-data-folder-any-more = its files are not in the data folder any more
files-searched = It is searched for { $suffixes }.
finding-objects-edges = Finding the object's edges
finding-start = Finding a start
finding-what-and-why = { CAPITAL(CLAUSE($what)) }: { CLAUSE($why) }
findings = Findings
finish-cloud-drop = Finish this cloud, or drop it.
finish-cloud-first = Finish this cloud first.
finish-sphere = Finish the sphere
finish-swing = Finish the swing
finished-cloud = finished a cloud
finished-seat = finished a seat
finite-number-decimal-point-expected = a finite number with a decimal point is expected
firmware-must-answer-hello = Its firmware must answer the hello request (hardware/arm/protocol.py).
firmware-must-send-counts-of-hello = Its firmware must send as many counts as its hello announces.
first-line-names = the first line names { $names }
first-line-names-column-count =
    the first line names { $count ->
        [one] { $count } column
       *[other] { $count } columns
    }
fit-does-settle = the fit does not converge
fit-follows-these-points-arm = the fit follows these points and not the arm
fit-plane-sphere-cylinder-first = fit a plane, a sphere or a cylinder first
fitting =
    { $shape ->
        [plane] Fitting a plane
        [sphere] Fitting a sphere
       *[cylinder] Fitting a cylinder
    }
fitting-arm = Fitting the arm
fitting-contact-points = Fitting the contact points
fix-board-flat-plate = Fix the board to a flat plate.
fix-board-so-cannot-rock-warp = Fix the board so that it cannot rock or warp, and lock the camera's lens.
fix-object-arm-so-neither-can = Fix object and arm so that neither can move, touch the object, and take the pictures again.
flange-differs = the flange differs by { $moved }
flange-turned-most-between-poses = the flange turned by { $turn } at most between the { $count } poses
flanges-frame-now-arms-calibrations-made = The flange's frame is now this arm's: calibrations made with the arm before do not belong to it.
flat-board-tells-cameras-focal-length = a flat board determines the camera's focal length from { $fewest_poses } pictures on, tilted against each other
floors-grooves = Floors (grooves)
focal-length = Focal length
focal-lengths = { $u } × { $v }
focus-camera-object-bring-into-working = focus the camera on the object, bring it into the working distance, hold it still
focus-camera-object-bring-into-working-2 = focus the camera on the object, bring it into the working distance, and hold it still
focus-light-board-evenly = focus, and light the board evenly
folder-cannot-be-written = the folder { $folder } cannot be written to
folder-has-none-of = it contains none of { $names }
folder-inside-data-folder = { $folder } is inside the data folder
folder-named = The folder { $folder }
folder-their-own = in a folder of their own
folder-there-already = { $folder } is there already
folders-next-to-it-not-empty = there is data next to it, in { $folders }
form-95-m = Form 95 %, µm
form-cloud-95-points = Form of the cloud (95 % of the points)
form-max-min-m = Form (max − min), µm
format-expected = { $format } is expected here
frame-has-pixels = { $path }: frame { $number } has { $width_px } × { $height_px } pixels
frame-shows-only-s-visible-edges = the frame shows only { $share } of { $name }'s visible edges
frame-without-joints-around-gives-no = A frame without joints around it gives no points.
frames-joint-samples-which-neighbours-up = frames from { $frames_from } to { $frames_to }, joint samples from { $joints_from } to { $joints_to }, of which neighbours up to { $gap } apart are used
frames-left-out-no-joints-around = { $count } of { $frames } frames left out: no joints around their stamps, the first { $first } from the start; { $beyond } before the first or after the last sample, { $gaps } in gaps
frames-lost-when-full-scan-more = Frames are lost when it is full; scan more slowly or close other programs.
free = { $free } are free.
free-enough-for-hours = { $free } are free, enough for { $hours } hours of this scan.
free-on-disk = { $free } are free on the disk of { $folder }
free-some-space = free some space
free-some-space-choose-another-disk = Free some space, or choose another disk
free-some-space-start-again = Free some space, and start again
free-some-space-then-do-again = Free some space, then do it again
free-some-space-try-again = Free some space and try again
from = From
from-to = { $low } to { $high }
front = from the front
front-face = Front face
front-y-mm-must-less-than = front_y_mm must be less than back_y_mm
further-cloud-aside-one-other-s =
    { $aside ->
        [one] { $aside } further cloud was not used.
       *[other] { $aside } further clouds were not used.
    }
gauge = Gauge
gauge-clamped = This gauge is clamped
gauge-shape = { $path }: shape is { $shape }
gauge-touched-only-shape-size-judged = The gauge was not touched: only its shape and size are judged.
gauge-touched-shape-size-only = the gauge was not touched: shape and size only
gauges-are-plane-or-sphere = gauges are a plane or a sphere
gave-no-picture-within = { $title } gave no picture within { $time }
give-arm-json-arm-took = Give the arm.json of the arm that took this
give-arm-json-arm-took-recording = Give the arm.json of the arm that took this recording
give-arms-own-model-columns = Give the arm's own model, or columns { $names }
give-calibration-sensor-took-recording = Give the calibration of the sensor that took this recording
give-cameras-own-picture = Give the camera's own picture
give-certificate-board-picture = give the certificate of the board in the picture
give-certificate-crenellated-object-calibrate-command = Give the certificate of a crenellated object, or calibrate on the command line
give-certificate-first =
    { $kind ->
        [bar] Give the bar's length by its certificate first.
       *[sphere] Give the sphere's diameter by its certificate first.
    }
give-cloud-millimetres = Give a cloud in millimetres
give-denavit-hartenberg-model = Give the arm's Denavit-Hartenberg model (convention 'dh-standard')
give-each-own-name-station-mqtt = Give each its own name with station in [mqtt] of station.toml.
give-each-seat-name-own = Give each seat a name of its own
give-files-belong-together = Give the files that belong together
give-folder-station-started = Give the folder that the station was started with
give-folder-user-may-write-data = Give a folder that this user may write with --data
give-gauges-own-nominal = Give the gauge's own nominal
give-length-mm-bar-millimetres-check = Give length_mm of bar { $name } in millimetres, and check its rows
give-mask-sensor-took-picture = Give the mask of the sensor that took this picture
give-more-recordings-plane-more-calibrations = Give more recordings of the plane, or more calibrations
give-one-first = Give one first
give-one-number-all-joints-one = Give one number for all joints, or one for each.
give-picture-as-taken-and-sensor-json = Give the picture as the camera took it, and the right sensor.json
give-planes-own-nominal = Give the plane's own nominal
give-qx-qy-qz-qw-order = Give qx, qy, qz, qw in this order, the scalar last
give-recording-as-documented = Give a recording as docs/formats.md describes it
give-right-arm-json-columns = Give the right arm.json, or columns { $first } to { $last }
give-right-file = Give the right file
give-rows-different-pose-numbers-take = Give the rows different pose numbers, or take the pictures again
give-seat-own-name-check-arm-json = Give each seat a name of its own; check arm.json
give-standard-uncertainty-of-certificate = Give the standard uncertainty (k = 1) of its certificate in millimetres
give-station-data-folder-own = Give the station a data folder of its own
give-tip-or-leave-out-probing = give the tip in arm.json, or leave out probing.csv
go-back-take-picture-points-again = Go back, and take the picture or the points again.
go-calibrating = Go on calibrating
go-faster = Go faster, { $speed } or more
go-faster-farther-over-plate-nearer = Go faster and farther over the plate, nearer and away again several times
go-further-away-object-does-fit = Go further away: the object does not fit
go-over-these-places-again-slower = Go over these places again, slower.
go-pictures-touches-spread-over-printed = Go on to the pictures. { $wanted } touches, spread over the printed side, would check the size of its squares.
go-pose-count-one-other-s =
    { $count ->
        [one] Go on with { $count } pose
       *[other] Go on with { $count } poses
    }
go-scanning = Go on to scanning
go-slower-shorten-exposure = Go slower, or shorten the exposure.
go-swinging-least-points = Go on swinging: { $taken } of at least { $least } points.
go-verifying = Go on verifying
go-without-probe = Go on without the probe
goes-beyond-end =
    { $side ->
        [right] { $edge } goes on beyond its right end
       *[left] { $edge } goes on beyond its left end
    }
good = Good
good-m-usable-m = good ≤ { $good }, usable ≤ { $usable }
good-up-m = good up to { $limit }
grey-encodings-expected = grey is expected: { $encodings }
grey-levels = grey levels
guided-steps = Guided steps
had-calculated = had it calculated
had-simulation-pass-over-plate = started the simulated pass over the plate
half-them-more-contradicting-others-none = with half of them or more contradicting the others, none can be trusted
simulation-goes = The simulated operator goes to { $name }
simulation-goes-next-pose = The simulated operator goes to the next pose: { $words }
simulation-holds-sensor-over-object = The simulated operator holds the sensor over the object
simulation-holds-still = The simulated operator holds still
simulation-moving = The simulated operator is not moving.
simulation-scanning = The simulated operator is scanning
simulation-scans = The simulated operator scans the { $part }
simulation-scans-cloud = The simulated operator scans the { $name }, cloud { $done }
simulation-swings-arm-about = The simulated operator swings the arm about { $name }
simulation-touches = The simulated operator touches: { $face }
simulation-touches-2 = The simulated operator touches the { $name }
simulation-touches-sphere = The simulated operator touches the sphere
simulation-work = The simulated operator is running
hands-point-face-declined-times = Point { $index } { $where } of the simulated operator was declined { $attempts } times
hands-touch-declined-times = Contact point { $index } of the simulated operator was declined { $attempts } times
has-control = { $name } has control
has-control-in-another-browser = { $name } has control in another browser
has-control-now = { $name } has control now.
has-coordinate = { $path } has a coordinate of { $coordinate }
has-joint-columns =
    { $count ->
        [0] { $path } has no joint columns
        [one] { $path } has { $count } joint column ({ $names })
       *[other] { $path } has { $count } joint columns ({ $names })
    }
has-mm =
    { $kind ->
        [bar] A bar has { $low } to { $high }.
       *[sphere] A sphere has { $low } to { $high }.
    }
has-points = { $label } has { $count } points
has-touches =
    { $shape ->
        [sphere] The sphere has { $count } touches
       *[plane] The plane has { $count } touches
    }
have-arms-calibration-checked-hold-compact = Have the arm's calibration checked; hold it in a compact posture.
height-above-touched-plane-along-z = Height above the touched plane, along Z
height-of-level =
    { $level ->
        [base] the height of its base
        [floors] the height of its floors
       *[crests] the height of its crests
    }
held-out-places-fit-did-see = Held out: on { $places } places that the fit did not use, { $how }; the encoders' noise is included. In standard deviations of the points { $before } before and { $after } after, where 1 is noise alone.
held-out-turn = held out in turn
held-up-live-numbers-stand-press = Held up, live numbers stand, and a press is answered late; devices are read on.
held-up-more-than-longest =
    { $count ->
        [one] held up once for more than { $limit }, for { $longest }
       *[other] held up { $count } times for more than { $limit }, { $longest } the longest
    }
high-up = high up
higher-by = { $distance } higher
hold = Hold
hold-2 = hold as it is
hold-arm-still = Hold the arm still. { $text }.
hold-arm-still-2 = Hold the arm still.
hold-sensor-over-object = Hold the sensor over the object
hold-sensor-over-object-another-way = Hold the sensor over the object, in another way than before.
hold-sensor-over-object-so-lies = Hold the sensor over the object so that it lies about as the dashed outline.
hold-sensor-straight-above-chessboard-longer = Hold the sensor straight above the chessboard, its longer side along the picture.
hold-still = Hold still
hold-still-again = hold it still, again
hold-still-take-picture-laser-switches = Hold still and take the picture. The laser switches itself.
hold-there = Hold it there
holds-journal-every-step-accounts-what = It holds the journal of every step, accounts, and what calibration is in use.
holds-more-than-frames = { $path } holds more than { $most } frames
holds-no-record-one = it has no record of one
holds-no-topics = { $path } holds no topics
holds-topics = { $path } holds { $topics }
host-not-known = The host in { $url } is not known
how-arm-swung = How the arm swung
how-sensor-sits-flange-shows-only = how the sensor sits on the flange shows only when the flange turns: three poses at least, turned about two different axes
http-status = status { $status }
identification-arm = Identification of the arm
identified = Identified
identified-arm-use = The identified arm is in use.
identify-arm = Identify the arm
identify-arm-first = Identify the arm first.
identify-arm-folders-again = Identify the arm of the folder's { $arm } again
identify-arm-take-more-know-better = Identify the arm, or take more to know it better.
identifying-arm = Identifying the arm
image-encoding = { $name }: encoding { $encoding }
image-ends-after-bytes =
    { $name } ends after { $bytes ->
        [one] { $bytes } byte
       *[other] { $bytes } bytes
    }
image-has-depth = { $name } holds { $depth }
image-has-pixels = { $name } has { $width } × { $height } pixels
image-in-colour = { $name } is in colour
image-processing = Image processing
image-shape-type = an image of shape { $shape } and type { $dtype }
inner-corners-mm-apart = { $columns } × { $rows } inner corners, { $square } apart, { $known }
inputs = Inputs
install-version-later-one = Install that version or a later one
is-file-complete = Is the file complete?
is-it-a-complete-video = Is it a video, and complete?
is-it-there-and-complete = Is it there, and complete?
is-no-station-database = { $path } cannot be read as a station's database
is-of = { $path } is of { $device } { $of }
is-to-be-verified =
    { $shape ->
        [sphere] a sphere is to be verified
       *[plane] a plane is to be verified
    }
it-is-a-file = it is a file
it-is-a-folder = it is a folder
it-is-no-ordinary-file = it is a pipe, a socket or a device
joint = Joint
joint-adjustment-all-poses = joint adjustment of all poses
joint-angle-number = { $name }: a joint angle is not a number
joint-angles = { $name }: { $count } joint angles
joint-angles-given-degrees = joint angles are given in degrees
joint-at-stamp = { $path } at { $stamp_ns } ns: joint { $joint } is at { $reading }
joint-column-differs = q{ $joint }_deg differs by { $moved }
joint-jumped-stayed-there = joint { $joint } jumped by { $step } and stayed there
joint-name-twice = two joints are named { $name }; recordings identify joints by name
joint-range = it turns from { $low } to { $high }
joint-range-in-radians = it turns from { $low } to { $high }; these are degrees where radians are expected
joint-reads = joint { $joint } reads { $reading }
joint-reads-again-again = joint { $joint } reads { $reading } again and again
joint-reads-no-number = joint { $joint } reads no number
joint-reads-off-readings-before-after = joint { $joint } reads { $reading }, { $step } off its readings before and after
joint-reads-same-all-points = joint { $joint } reads the same in all points
joint-reads-where-can = joint { $joint } reads { $reading }, { $step } from where it can be
joint-samples-left-out-cannot-true =
    { $count ->
        [one] { $count } joint sample left out that cannot be true, { $first } from the start: { CLAUSE($error) }
       *[other] { $count } joint samples left out that cannot be true, the first { $first } from the start: { CLAUSE($error) }
    }
joint-samples-left-out-numbers =
    { $unusable ->
        [one] { $unusable } joint sample left out: not a number
       *[other] { $unusable } joint samples left out: not numbers
    }
journal-has-rows-cannot-read-first =
    { $count ->
        [one] The journal has { $count } row that cannot be read, row { $first }.
       *[other] The journal has { $count } rows that cannot be read, first row { $first }.
    }
json-cut-off = it is not JSON, or was cut off: { $reason }
json-cut-off-line = it is not JSON, or was cut off: { $reason } in line { $line }
json-object-expected = a JSON object { "{" } … { "}" } is expected
judged = Not judged
keep-arm-json-use = Keep the arm.json in use
keep-data-folder-start-earlier-backup = Keep the data folder as it is, and start from an earlier backup
keep-reflections-out-grooves-matt-spray = Keep reflections out of the grooves: matt spray, lower exposure.
keep-tip-seat-swing-elbow-one = Keep the tip in the seat. Swing the elbow from one side to the other and back, and lean the wrist every way.
keeps-control = { $name } keeps control.
kept-2 = Kept
kept-picture = kept the picture
kind-chessboard-not-supported = { $path }: kind 'chessboard' is not supported here
kind-is-crenellated-or-chessboard = it is 'crenellated' or 'chessboard'
kind-unknown = { $path }: kind { $kind } is unknown
known-k-1 = known to { $known } (k = 1)
known-limit-is = { $known }; { $limit } is the limit
known-m-k-1-form-m = { $certificate }; known to { $known } (k = 1), form { $form }
largest-distance = Largest distance
largest-distance-touch-sphere = Largest distance of a touch from the sphere
largest-max-min-2 = Largest (max − min)/2
largest-swing = { $points }, largest swing { $swing }
laser-beside-object-may-too-dark = The laser is on, and beside it the object may be too dark to be found.
laser-colour-not-known = the laser's colour, whose channel would be measured, is not stated
laser-line-left-out-off-plane = its laser line was left out, { $off } off the plane of the others
laser-line-lies-off-plane-others = its laser line lies { $off } off the plane of the others
laser-off = the laser is off
laser-off-2 = The laser is off
laser-off-covered-beside-object-too = the laser is off, covered, beside the object, or too weak for this exposure
laser-off-too-weak-does-cross = the laser is off, too weak, or does not cross the object
laser-off-too-weak-part-out = the laser was off, too weak, or the part out of range
laser-on-or-expose-longer = Switch the laser on, or expose longer
laser-plane = Laser plane
laser-stripe-sensor-measuring-arm = Laser stripe sensor on a measuring arm
laser-stripe-shows-points-s =
    { $missing ->
        [crest] the laser stripe shows { $count } points on the crests
       *[floor] the laser stripe shows { $count } points on the floors
    }
laser-wavelength = laser { $wavelength }
lasers-line-lies-board-pictures = the laser's line lies on the board in { $enough } of { $views } pictures
lasers-line-lies-one-place-plane = the laser's line lies at one place of its plane in all pictures
lasers-line-must-cross-chessboard-every = The laser's line must cross the chessboard in every picture.
lasers-line-pose-lies-off-plane = The laser's line of pose { $number } lies { $off } off the plane of the others, and was left out.
lasers-lines-poses-lie-off-plane = The laser's lines of poses { $poses } lie { $off } off the plane of the others: the laser moved against the camera, and these lines were left out.
lasers-lines-poses-lie-off-plane-2 = The laser's lines of poses { $poses } lie { $off } off the plane of the others: the laser moved against the camera, and all lines count.
lasers-lines-poses-lie-off-plane-3 = the laser's lines of poses { $poses } lie { $usual } off the plane that suits them best
lasers-lines-poses-lie-up-off = the laser's lines of poses { $poses } lie up to { $most } off one plane
lasers-plane-stands-board-limit = the angle between laser plane and board is { $angle } (limit { $least_laser_angle_deg })
last-cloud-still-measured = The last cloud is still to be measured.
last-days-old = The last is { $days } days old, in { $place }.
last-days-old-same-disk = The last is { $days } days old, in { $place }. It is on the same disk as the data.
last-row-must-0-0-0 = the last row of { $name } must be 0 0 0 1
last-verification-older-than-calibration = The last verification is older than this calibration.
least-middle-needed = at least { $angle } from its middle are needed
least-needed = at least { $least } are needed
least-needed-each-three-non-parallel = at least { $least } are needed on each of three non-parallel faces
least-needed-tell-arms-errors-own = at least { $least } are needed to separate the arm's errors from the place's own centre
least-places-taken = { $places_taken } of at least { $seats_least } places are taken.
least-seats-spheres-bar-positions-needed = at least { $least_places } seats, spheres and bar positions are needed, so that some can be held out
leave = Leave
leave-bar-where = Leave the bar where it is.
leave-session-points-yet-used-kept = Leave this session? Points not yet used are kept aside.
leave-verification-clouds-kept-folder = Leave this verification? Its clouds are kept in its folder.
left = to the left
left-end = Left end
left-out = Left out: { $reason }
left-out-2 = left out: { $reason }
left-out-3 = Left out: { CLAUSE($text) }.
left-right-corners-were-exchanged-image = left and right corners were exchanged, or the image is flipped
length = length { $longer }
length-another-bar-another-unit-ends = the length is of another bar or in another unit, or the ends are not this bar's
lengths-ball-bars-held-out = Lengths of ball bars, held out
less-than-minute = less than a minute
less-than-pictures-edges-wide = { $text }, less than the { $width } that the picture's edges are wide
let-each-station-write-under-own = Let each station write under its own topic alone, and remove from the broker what it keeps of others.
let-go-control = let go of control
let-simulation-do = Let the simulated operator do it
let-simulation-do-everything = Let the simulated operator do everything
let-kept-time-server-which-moves = Let it be kept by a time server, which moves it gently.
let-laser-come-rest-take-pictures = Let the laser come to rest, and take the pictures again.
let-laser-warm-up-check-mount = Let the laser warm up, check its mount, and take the pictures again.
let-line-cross-board-every-picture = let the line cross the board in every picture
started-simulation = let the simulated operator do it
lies-face = it lies { $where }
lies-no-face-all = it lies on no face at all
lies-where-certificate-puts = { $edge } lies { $distance } from where the certificate puts it
light-block-evenly-sharp-large-picture = Light the block evenly, sharp and large in the picture.
light-board-evenly-sharp-large-picture = Light the board evenly, sharp and large in the picture.
light-front-above-so-crests-floors = light it from the front and above so that crests, floors and front differ, come nearer, and remove what is in front of it
limit-2 = limit { $limit }
limit-3 = Limit
limit-is = The limit is { $limit }.
limit-is-value = the limit is { $limit }
limit-k-1 = Limit, k = 1
limit-m-2 = limit { $limit }; U = { $expanded_uncertainty }, k = 2
limit-mark = limit
limit-number-micrometres-1-100-000 = A limit is a number of micrometres from 1 to 100 000.
limits-deg-must-ascend = limits_deg of { $name } must ascend
line-brightness = Line brightness
line-gives-other-length = line { $line } gives { $length } for the same { $label }
line-saturated = Line saturated
line-to-arm-closed = The line to the arm at { $url } is closed
line-to-arm-lost = The line to the arm at { $url } was lost ({ $reason })
line-too-bright-saturated = Line too bright: { $clipped } saturated
line-too-dark = Line too dark: { $level }
link-good-any-more = This link is not good any more.
link-leads-itself = it is a link that leads to itself
linux-add-user-group-owns-port = On Linux, add the user to the group that owns the port (often dialout).
lists-stripe-differ-length = the lists of a stripe differ in length
load-page-again = Load the page again.
log = Log
log-broker-connected = connected to the broker at { $host }:{ $port }
log-broker-lost = the connection to the broker was lost: { $reason }
log-cannot-written-health-page-says = The log cannot be written; the Health page says more.
log-event-loop-goes-on = the event loop goes on after { $duration }
log-event-loop-held-up = the event loop is held up for more than { $limit }
log-file-not-used = { $file } is not used: { $reason }
log-has-what-held-up-send = The log has what held it up; send the support bundle if it happens again.
log-not-saved = { $method } { $path } was not saved: { $reason }
log-notification-given-up = a notification was given up: { $reason }
log-program-stood-still = the whole program stood still for { $duration }
log-repeated = ({ $count } of these since { $since })
logs-cannot-written = The logs in { $folder } cannot be written
look-change = Look at it, and change it.
look-last-message-let-simulation-try = Check the last message, and let the simulated operator try again
look-log-below-send-support-bundle = Look at the log below, and send the support bundle to whoever helps.
look-numbers-then-accept-calibration-repeat = Look at the numbers, then accept the calibration or repeat it.
look-present-step-act-2 = Look at the present step, and act on that
look-them-below-send-support-bundle = Look at them below, and send the support bundle.
looked-arms-delay = looked for the arm's delay
looked-pose = Looked at pose { $number }
looking-delay = Looking for the delay
looking-object-picture = Looking for the object in the picture
losses =
    { $device ->
        [arm] Losses of the arm
       *[sensor] Losses of the sensor
    }
lost-garbled-last-ten-minutes = { $missing } of { $total } lost or garbled in the last ten minutes ({ $share }).
lost-reconnecting = The { $title } was lost; reconnecting
low-down = low down
lower-by = { $distance } lower
lower-limit-below-upper = The lower limit is not below the upper
made-first-administrator = made the first administrator
made-simulated-hardware-demonstration = Made on simulated hardware: a demonstration.
made-token-metrics = made a token for metrics
made-kiosk-link = created a kiosk link
make-backup-another-disk = Make the backup on another disk
make-one-below-crenel-backup = Make one below, or with crenel backup.
make-somebody-else-administrator-first = Make somebody else an administrator first
many-points-have-very-same-angles = many points have the very same angles
mask-has-pixels = the mask is for { $width } × { $height }
mask-pixels-image-another-size = a mask of { $shape } pixels for an image of another size
mask-says-every-pixel-whether-stripe = a mask states for every pixel whether the stripe may lie there
matrix-is-no-rotation = { $name } holds no rotation: R·Rᵀ differs from 1 by { $difference }
max-min-2-along = (max − min)/2 along { $axis }
may-not-do-this =
    { $role ->
        [admin] { $name } may not do this: it takes an administrator.
       *[operator] { $name } may not do this: it takes an operator.
    }
measure-pattern-over-all-squares-correct = Measure the pattern over all its squares, and correct the certificate.
measure-patterns-width-height-fix-flat = Measure the pattern's width and height, and fix it to a flat plate.
measure-squares-correct-certificate-check-every = measure the squares, and correct the certificate; or check that every picture has its own pose, in mm
measured = not measured
measuring-arm = Measuring arm
measuring-cloud = Measuring the cloud
measuring-cloud-2 = Measuring cloud { $number }
memory = Memory
merlons-are-symmetric = the merlons' widths and gaps read the same from both ends, so that the block cannot be distinguished from its mirror image
merlons-read-alike-either-side = its merlons read alike from either side
merlons-read-mirrored-order = the merlons of { $name } read in the mirrored order
merlons-stand-mirrored-order = the merlons are in the mirrored order
message-too-large = { $size } bytes are more than it can have
messages-broker-were-read =
    { $count ->
        [one] { $count } message on the broker was not read: { $reasons }.
       *[other] { $count } messages on the broker were not read: { $reasons }.
    }
messages-of-no-station = { $count } of no station's kind
messages-of-too-many-stations = { $count } of more stations than are shown
messages-stations = Messages of stations
messages-too-long = { $count } too long
messages-too-often = { $count } faster than they are read
method = Method
mm = In mm
more-on-either-face =
    { $pair ->
        [crest] { $count } more on the crest or the floor face
        [front] { $count } more on the front or the back face
       *[left] { $count } more on the left or the right face
    }
more-poses-would-bring-little = More poses would bring little.
more-than-kb-were-sent = More than { $limit } were sent.
more-touches-on-face = { $count } more { $where }
most-pixels-read = at most { $millions } million are read
mount-tip-of-datasheet-or-give-diameter = Mount the tip of the datasheet, or give the sphere's own diameter.
move-away = Move it away
move-away-start-again = Move it away, and start again
move-recording-keeps-them-all = Move on; the recording keeps them all.
move-sensor-nearer-away-again-several = Move the sensor nearer and away again, several times, as you go over the plate
move-sensor-over-part-yourself = Move the sensor over the part yourself
move-sensor-until-whole-object-picture = move the sensor until the whole object is in the picture
move-tip-another-place = Move the tip to another place
moved-encoder-read = it was not moved, or its encoder is not read
moved-simulation-stopped = started or stopped the simulated operator
moved-turned = Moved { $moved } and turned { $turned } in { $duration }
movement-tip = Movement of the tip
moves-check-arm-json-bars-lengths = { $name } moves by { $change }: check arm.json and the bars' lengths
moving-only-moves-whole-arm-space = moving it only moves the whole arm in space
must-begin-http-https-name-machine = it must begin with http:// or https:// and name a machine
must-name = It must name { $names }
n-2-along = 2σ along { $axis }
n-2-encoders-alone = 2σ by the encoders alone, { $axis }
n-2-worst-axis = 2σ is { $two_sigma } on the worst axis; the encoders' noise alone gives { $encoders }.
n-3d-view = 3D view
n-3d-view-does-answer = The 3D view does not answer.
n-3d-view-page-connected = The 3D view of this page is not connected
name-a-file = Name a file
name-a-folder = Name a folder
name-and-serial-number = { $name }, serial number { $serial_number }
name-another-file = Name another file
name-file-holds-brokers-password-alone = Name a file that holds the broker's password alone, readable by the station
name-folder-another-disk-backups-station = Name a folder on another disk with backups in station.toml.
name-folder-calibration-check-verification-has = Name the folder of a calibration, a check or a verification: it has one of { $files }
name-folder-of-seats-spheres-bars = Name a folder of seats, spheres or ball bars touched with the arm
name-folder-other-places-none-some = Name a folder of other places, or none: some are then held out in turn
name-folder-that-is-not-there = Name a folder that is not there yet
name-password-do-belong-together = Name and password do not belong together.
name-recording = Name a recording
name-scan-mcap = Name a scan.mcap
name-sessions-folder = Name a session's folder
name-tls-certificate-tls-key-station = Name tls_certificate and tls_key in station.toml, or put a proxy before it.
name-too-long = the name is too long
named-joint-range = joint { $joint } turns from { $low } to { $high }
named-value = { $name } { $value }
near-base = near the base
needed = { $least_frames } are needed
needed-place = { $fewest_corners } are needed to place it
needs-least =
    { $shape ->
        [plane] a plane needs at least { $least }
        [sphere] a sphere needs at least { $least }
        [cylinder] a cylinder needs at least { $least }
       *[other] at least { $least } are needed
    }
needs-least-three-conjugated-pairs = it needs at least three conjugated pairs
neither-colours-nor-arms-poses-tell = neither its colours nor the arm's poses determine which corner is the first
nested-too-deeply = it is nested too deeply
network = Network
never-checked = It was never checked.
never-held-up-more-than = Never held up for more than { $limit }.
new-password = new password
newest-record-days-later-than-clock = The newest record is { $days } days later than the clock.
next = Next: { $title }.
next-backup-would-include-this = the next backup would include this one
next-pose-follow-dashed-outline = For the next pose { $words }. Follow the dashed outline.
no-account-name = { $name } is no name of an account
no-answer-from = There is no answer from { $url }
no-answer-within = no answer within { $limit }
no-arm-model-joints-chosen = no arm model with { $joint_count } joints is chosen
no-arm-near-given-one-explains = no arm near the given one explains the points; those of { $label } lie { $rms } (rms) apart
no-backup-made = No backup was made: { $error }
no-ball-bar-measured-arms-size = no ball bar was measured: the arm's size is that of its datasheet; a longest link wrong by { $error } adds { $size } over the reach
no-bright-line-runs =
    { $axis ->
        [u] no bright line runs across the picture
       *[v] no bright line runs down the picture
    }
no-calibration-use-yet = no calibration is in use yet
no-certificate-stated = no certificate stated
no-chessboard-x-inner-corners-found = no chessboard of { $columns } × { $rows } inner corners was found
no-cloud-being-scanned = No cloud is being scanned.
no-cloud-shows-gauge-yet-scan = No cloud shows the gauge yet. Scan one.
no-cloud-taken-yet = No cloud was taken yet.
no-column = { $path }: no column { $names }
no-connection = no connection
no-crenellated-object-found-picture = no crenellated object was found in the picture
no-data = No data from the { $title } for { $silent }
no-data-yet = No data yet.
no-database-there = there is no { $database }
no-delay-found-yet = No delay was found yet
no-file = it is no file
no-fitted =
    { $shape ->
        [plane] No plane was fitted: { $error }
        [sphere] No sphere was fitted: { $error }
       *[cylinder] No cylinder was fitted: { $error }
    }
no-fitted-program-failed =
    { $shape ->
        [plane] No plane was fitted: the program failed at it.
        [sphere] No sphere was fitted: the program failed at it.
       *[cylinder] No cylinder was fitted: the program failed at it.
    }
no-flange-further-than = { $path }: no flange is further than { $furthest } from the arm's base
no-folder-named = there is no folder { $folder }
no-frames = { $named }: no frames
no-free-name-scan = no free name for a scan in { $folder }
no-hand-no-knock-moves-joint = no hand and no knock moves a joint so far in so short a time
no-image-or-cut-off = it is no image, or was cut off
no-joint-angle-exceeds = { $path }: no joint angle exceeds { $largest }
no-joint-angles = { $named }: no joint angles
no-joint-goes-there-back-between = no joint goes there and back between two readings
no-joint-turned-more-than = { $label }: no joint turned more than { $swing } ({ $joint })
no-joints-around-any-frames-stamp = { $named }: no joints around any frame's stamp
no-json = it is no JSON: { $error }
no-laser-stripe-found-object = no laser stripe was found on the object
no-laser-stripe-front-sensor-any = { $named }: no laser stripe in front of the sensor in any frame of { $numbered }
no-laser-stripe-picture = No laser stripe is in the picture.
no-limit = no limit
no-limit-set = no limit is set
no-limit-set-3 = No limit was set
no-limit-set-identification-check-arm = No limit is set for an identification: a check of the arm judges it.
no-limit-set-so-check-neither = No limit is set, so this check neither passes nor fails.
no-line-seen = no line is seen
no-line-seen-2 = No line is seen
no-mcap-recording = it is no MCAP recording
no-page-file-has-such-address = No page or file has such an address.
no-picture-came-sensor = no picture came from the sensor
no-picture-came-within = no picture came within { $limit }
no-picture-in-folder = There is no picture in the folder { $folder }
no-picture-laser-came-within =
    { $state ->
        [on] no picture with the laser on came within { $limit }
       *[off] no picture with the laser off came within { $limit }
    }
no-picture-shows-object-yet-take = No picture shows the object yet. Take another.
no-placing-edges-explains-those-picture = no pose of the object explains the edges in the picture
no-png-image = it is no PNG image
no-point-taken-back-since-last = No point was taken back since the last one was taken.
no-point-taken-yet = No point was taken yet.
no-points-can-made = { $interrupted } No points can be made of it: { CLAUSE($why) }.
no-pose-given = no pose was given
no-position-block-brings-them-onto = no position of this block brings them onto it
no-readable-figures = { $name } has no readable figures
no-reason-given = No reason is given
no-seat-taken-yet = No seat was taken yet.
no-seated-tip-does-points-another = no seated tip does: points of another place are among them, or the file is another arm's
no-serial-port-named = There is no serial port { $url }
no-serial-port-plugged = No serial port is plugged in.
no-single-contact-fault = no single contact is at fault
no-size-squares-makes-them-agree = no size of its squares makes them agree
no-station-data-folder = { $folder } is no station's data folder
no-such-file = there is no such file
no-such-file-or-folder = there is no such file or folder
no-such-folder-named = There is no folder { $folder }
no-touch-taken-back-since-last = No touch was taken back since the last one was taken.
no-touch-taken-yet = No touch was taken yet.
no-two-opposite-sides-were-touched = No two opposite sides were touched: the tip's diameter and the block's size are those of their certificates, unchecked.
no-video-file-named = There is no video file { $path }
nobody-asks-control = Nobody asks for control
nobody-may-use = Nobody may use { $path }.
nobody-signed-here = Nobody is signed in here.
nominal-is-of =
    { $shape ->
        [sphere] the nominal is of a sphere
       *[plane] the nominal is of a plane
    }
none-calibrations-belongs-these-recordings = None of the calibrations belongs to these recordings
none-edges-floors-base-shows-picture = none of the edges of its floors and its base shows in the picture
none-significant = none was significant
normal-component = Normal { $axis }
normal-must-be-of-unit-length = normal must be of unit length, not { $length }
normal-must-have-unit-length = normal must be of unit length
not-saved = This was not saved
not-usable-next-to-database = { $path } cannot be used next to the station's database
note = Note
nothing-came-for = Nothing came from { $url } for { $time }
nothing-can-be-sent-to-arm = Nothing can be sent to the arm at { $url } ({ $reason })
nothing-changed-since-solved = Nothing changed since this was solved.
nothing-changed-stations-log-has-details = nothing was changed; the station's log has the details
nothing-else-bears-out-shadow-highlight = { $text }, and nothing else confirms that: a shadow, a highlight or something before it may look like that
nothing-listens = Nothing listens at { $url }
nothing-made-them = Nothing was made of them. { CAPITAL(CLAUSE($remedy)) }.
nothing-runs = Nothing runs
nothing-seen-no-contrast = Nothing is seen: no contrast
nothing-taken-reading-cannot-true-no = Nothing is taken from a reading that cannot be true: no contact, no pose, no points.
nothing-taken-such-reading = nothing is taken from such a reading
now = Now
number-expected-here = a number is expected here
number-too-large = nothing measured here is as large
numbers-need-decimal-point-comma-names = Numbers need a decimal point, not a comma; names no comma at all
numerics = Numerics
object = Object
object-certificate = object certificate
object-fills = Object fills
object-found = the object was not found
object-looked-grey-images-8-16 = the object is looked for in grey images of 8 to 16 bits, at least 64 pixels each way
object-off-m = Object off, µm
object-picture = The object is in the picture
object-picture-does-match-certificate = the object in the picture does not match the certificate of { $name } ({ $serial_number })
object-picture-hold-arm-there-clamp = The object is in the picture. Hold the arm there, or clamp it.
object-point-pixel-number = an object point or a pixel is not a number
object-points-shape-pixels-shape = object points of shape { $points } and pixels of shape { $pixels }
object-too-far =
    { $side ->
        [left] The object is too far left
        [right] The object is too far right
        [up] The object is too far up
       *[down] The object is too far down
    }
objects-place-k-1 = Object's place (k = 1)
objects-points-do-fit-their-pixels = the object's points do not fit on their pixels
of = { $page } of { $pages }
off = The { $title } is off
offset-m = Offset, µm
old-after-days-due = It is { $ago } old; after { $limit } it is due.
old-due-after-days = { $text }, { $ago } old; due after { $limit }.
old-password-wrong = The old password is wrong.
on-board = on the board
on-face = on the { $face } face
one-browser-acts-time = one browser acts at a time
one-diameter-spheres-sphere-clean = one diameter is not this sphere's, or the sphere was not clean
one-line-alone-does-fix-lasers = one line alone does not fix the laser's plane
one-numbers-has-too-many-digits = one of its numbers has too many digits
one-of = it is one of { $names }
one-picture-flat-board-tells-neither = one picture of a flat board determines neither the focal length nor the laser's plane
one-plane-does-fix-focal-length = one plane does not fix focal length, stand-off and the laser plane together
one-pose-alone-used-errors-arms = One pose alone was used: errors of the arm's links show in the contacts only; joint angles that are not the picture's, and an object moved since it was touched, do not show.
one-pose-enough = one pose is not enough on { $name }
one-pose-faugeras-contact-alignment = one pose (Faugeras, contact alignment)
one-recording-one-calibration-give-one = one recording and one calibration give one plane
one-used-each-lighting = one is used of each lighting
one-value-expected-for = one value from 0 to { $largest } is expected for { $label }
one-who-loses-control-reads-why = the one who loses control reads why
only-administrator = { $name } is the only administrator
only-corners-can-measured = only { $found } of its corners can be measured
only-edge-points-lie-edges = only { $agreeing } of the edge points lie on its edges
only-free-disk = only { $free } are free on the disk of { $folder }
only-joint-samples-came = only { $count } joint samples came in { $duration }
only-machines-browsers-reach-station = Only this machine's browsers reach the station.
only-one-row-corners-each-level = with only one row of corners on each level, the camera is not fixed
only-pose-take-another-first = It is the only pose. Take another first.
only-stations-own-pages-may-do = Only the station's own pages may do this.
only-visible-edges-show-picture = only { $shown } of its visible edges show in the picture
open-again = Open it again.
opened-kiosk = opened as a kiosk display
operation-not-permitted = the operation is not permitted
operator-2 = Operator
origin-mm = Origin, mm
other-files = the other files are of { $device } { $known }
other-machines-reach-encrypted = Other machines reach it, encrypted.
other-machines-reach-nothing-encrypted = Other machines reach it, and nothing is encrypted.
other-machines-reach-proxy = Other machines reach it by a proxy.
other-stations-see-one-one-them = By it other stations see this one, and this one them. Nothing else needs it.
others-covered-lost-lasers-light = the others are covered, or lost in the laser's light
out-focus-edges-wide-wanted = Out of focus: edges { $width } wide, { $wanted } wanted
out-picture-covered-blurred-another-object = it is out of the picture, covered or blurred, or another object lies there
over-clouds = Over the clouds
over-reach-before-difference-arm-identified = Over the reach: before, the difference from the arm as identified; after, the standard uncertainty, k = 1.
over-reach-tip-off-rms-now = Over its reach the tip was off by { $before } rms and is now known to { $after } (k = 1).
overexposed-share-at-full-scale = it is overexposed: { $share } of its pixels are at full scale
package-named = the package { $name } { $version }
parameter = Parameter
parameters = Parameters
parameters-moved-do-same-together = the parameters moved do the same together
part-of-path-is-no-folder = a part of the path is not a folder
pass = Pass
pass-does-tell-delay = this pass does not show the delay
pass-half-minute-enough = a pass of half a minute is enough
pass-has-pictures-lasers-line-plane = the pass has { $count } pictures with the laser's line on the plane
pass-over-flat-plate-fills-lasers = Pass over a flat plate that fills the laser's line
pass-over-more-gauge = Pass over more of the gauge
pass-over-plane-find = Pass over a plane and find it
pass-over-plate = Pass over the plate
pass-over-several-sides = Pass over it from several sides
pass-stopped = The pass was stopped
pass-stripe-slowly-each-pass-cloud =
    { $shape ->
        [plane] Pass the stripe slowly over the whole gauge. Each pass is a cloud of its own.
       *[sphere] Pass the stripe slowly over the sphere from three sides. Each pass is a cloud of its own.
    }
pass-stripe-slowly-over-gauge = Pass the stripe slowly over the gauge
pass-stripe-slowly-over-whole-gauge = Pass the stripe slowly over the whole gauge, then end the cloud.
passed-ago-due-after-days = Passed { $ago } ago; due after { $limit }.
password-has-characters =
    The password has { $count ->
        [one] { $count } character
       *[other] { $count } characters
    }
password-is-name = The password is the name
password-length-wanted = { $least } to { $most } are wanted
permission-denied = permission denied
pick-more-way-round-fit-plane = Pick more of its way round, or fit a plane
picture-being-taken-already = a picture is being taken already
picture-blurred-edges-wide = the picture is blurred: its edges are { $width } wide
picture-blurred-edges-wide-most-can = the picture is blurred: its edges are { $blur } wide, at most { $limit } can be measured
picture-blurred-noisy-lasers-line-lies = the picture is blurred or noisy, or the laser's line lies over them
picture-bytes-do-not-fit = { $name }: { $bytes } bytes for { $width } × { $height } pixels, { $row } a row
picture-can-read-more-than-one = the picture of { $name } can be read in more than one way
picture-cannot-be-encoded = the picture could not be encoded as PNG
picture-cannot-be-used-take-it-again =
    { $others ->
        [yes] This picture cannot be used. Take it again or go on without it.
       *[no] This picture cannot be used. Take it again.
    }
picture-cannot-read = The picture { $path } cannot be read
picture-dim-bright-parts-reach-full = the picture is dim: its bright parts reach { $high } of full scale
picture-has-size =
    { $picture ->
        [laser] the laser picture has { $width } × { $height } pixels
       *[ambient] the calibration picture has { $width } × { $height } pixels
    }
picture-incomplete = the picture is not complete
picture-mirrored-camera-looks-objects-back = the picture is mirrored, or the camera looks at the object's back
picture-objects-certificate-contradict-each-other = the picture and the object's certificate contradict each other
picture-of-numbers = The picture { $path } is of { $kind } numbers
picture-overexposed = { $saturated } of the picture is overexposed
picture-shows-no-contrast-full-scale = the picture shows no contrast: { $contrast } of full scale
picture-shows-no-laser-line-object = its picture shows no laser line on the object
picture-shows-objects-mirror-image = the picture shows the object's mirror image
picture-size-changed = { $title } changed its picture from { $width } × { $height } to { $new_width } × { $new_height } pixels
picture-soft-edges-wide = the picture is a little soft: its edges are { $width } wide
pictures-came-without-arms-position = { $count } of { $total } pictures came without the arm's position
pictures-contacts-certificate-contradict-each-other = the pictures, the contacts and the certificate contradict each other
pictures-different-sizes = the pictures are of different sizes: { $sizes }
pictures-flat-board-one-direction-do = pictures of a flat board from one direction do not determine the focal length
pictures-have-object-turned-how-touched = The pictures have the object turned by { $turned } from how it was touched. Scanned points may be off by as much.
pictures-have-object-where-touched-turned = The pictures have the object { $off } (± { $known }) from where it was touched, turned by { $turned }. Scanned points may be off by as much.
pictures-left-out = Pictures are left out: { $what }
pictures-of-one-pose-need-still-arm = the pictures of one pose are taken while the arm is still
pictures-recording-were-left-out = { $kept } pictures are in the recording, { $left_out } were left out
pictures-show =
    { $seen ->
        [one] { $seen } picture shows { $name }
       *[other] { $seen } pictures show { $name }
    }
pictures-were-lost = { $count } of { $total } pictures were lost
pictures-were-taken-too-fast-up = { $count } of { $total } pictures were taken too fast: up to { $worst } of blur
place-sensor-so-both-crests-floors = place the sensor so that both crests and floors are in the picture
place-sensor-so-stripe-crosses-crests = place the sensor so that the stripe crosses crests and floors
place-touch = That is the place of touch { $number }
placed = Placed
places = { $done } of { $seats_wanted } places
places-2 = { $done } places
places-held-out-arms-errors-go = on places held out the arm's errors go from { $before } to { $after } of their noise
places-held-out-still-deviate = places held out still deviate { $times } times as far as their noise explains: take more places, more evenly over the reach
places-were-held-out-fit-over = On places that were held out of the fit, and over the arm's whole reach.
plane-equation = ({ $x }, { $y }, { $z }) · x = { $offset }
plane-nearly-boards-does-meet-sharp = a plane that is nearly the board's does not meet it in a sharp line
plane-needs-both-directions = a plane needs { $width } in both directions
plane-swept-straight-across-angle = Plane swept straight across: angle
plane-through-cameras-centre-gives-no = a plane through the camera's centre gives no depth
plug-right-arm-correct-arm-joint = Plug in the right arm, or correct [arm] joint_count.
plus-minus = ± { $uncertainty }
point = Point { $number }, { $place }.
point-2 = { $face }, point { $index }
point-again = This is point { $point } again
point-back = Point { $index } is back.
point-cannot-true = Point { $index } cannot be true: { $what }; { $why }.
point-expanded-uncertainty = Scanned point, rms over the measuring volume: expanded uncertainty
point-known-good = A scanned point is known to { $total } (k = 1) in the flange frame; up to { $good } is good.
point-known-k-1 = { $name }, a point known to { $total } (k = 1)
point-known-mostly-by = A scanned point is known to { $total } (k = 1) in the flange frame, mostly by the { $source } ({ $value }); the limit is { $limit }.
point-left-out-off = { $place }, point { $number }: { $distance } off
point-lies-on-other-face = Point { $index } misses the { $face } face by { $off } and lies { $where }.
point-misses-face = Point { $index } misses the { $face } face by { $off }.
point-off-face = Point { $index } is { $off } off the { $face } face; the others agree to { $rms }.
point-off-face-remove-then-go = Point { $point } is off its face. Remove it, then go on.
point-off-plane-others = Point { $index } is { $off } off the plane of the others.
point-removed = Point { $index } is removed.
point-standard-uncertainty = Scanned point, rms over the measuring volume: standard uncertainty
point-taken-at = Point { $index } { $where }.
point-taken-off = Point { $index } { $where }: { $off }.
point-there-any-more = That point is not there any more.
points-1-lie-apart-while-single = { $label }: its points 1 to { $split } and { $next } to { $points } lie { $gap } apart, while single points scatter by { $sd }
points-3 = { $taken } points
points-5 = Points
points-blocks-edges-fit-camera-rms = { $points } points on the block's edges fit the camera to { $rms } rms, worst in pose { $number } ({ $edges_rms }); the limit is { $edge_rms_px }.
points-check-among-those-fit = { $shared } of the { $count } points to check by are among those of the fit
points-disagree-rest = { $label }: { $out } of its { $points } points disagree with the rest
points-do-lie-one = its points do not lie on one
points-edges-fit-camera-rms-limit = { $points } points on { $edges } edges fit the camera to { $rms } rms; the limit is { $edge_rms_px }.
points-fix-no-cylinder = the points fix no cylinder
points-here-welcome-beside-those-other = { $place } Points here are welcome beside those on the other faces.
points-laser-stripe-lie-object-levels = { $points } points of the laser stripe lie on the object (of { $found } on its levels; { $least } are needed on crests and on floors)
points-lasers-line-lie-board-but-poses =
    { $count ->
        [one] { $points } points of the laser's line lie on the board, { $rms } rms off the plane. Pose { $poses } shows none.
       *[other] { $points } points of the laser's line lie on the board, { $rms } rms off the plane. Poses { $poses } show none.
    }
points-lasers-line-lie-board-rms = { $points } points of the laser's line lie on the board, { $rms } rms off the plane.
points-lie-about-nearest-plane = the points lie { $spread } (k = 1) about the nearest plane, whatever the delay
points-lie-one-line = the points lie on one line
points-lie-one-plane = the points lie in one plane
points-lie-too-small-piece = the points lie on too small a piece of it
points-lie-too-small-piece-sphere = the points lie on too small a piece of the sphere
points-lie-within-one-plane = { $share } of the points lie within { $distance } of one plane, whatever the delay
points-made = { $name }: { $points } points made.
points-made-when-there-room-no = { $interrupted } Its points are made when there is room and no scan runs.
points-of = { $taken } of { $wanted } points
points-places = { $points } points at { $places } places
points-saved =
    { $count ->
        [one] { $name }: { $count } point saved
       *[other] { $name }: { $count } points saved
    }
points-taken-themselves-while-arm-swings = Points are taken by themselves while the arm swings.
points-used = Points used
points-were-taken-another-arm-file = the points were taken with another arm, or the file is wrong
ports-are = Ports there are: { $names }.
pose-2 = Pose { $number }: { CLAUSE($reason) }.
pose-4 = pose { $number }: { $name }
pose-5 = pose { $number } ({ $u }, { $v })
pose-6 = Pose
pose-count-one-other-s-taken =
    { $count ->
        [one] { $count } pose is taken.
       *[other] { $count } poses are taken.
    }
pose-differs-from-line = { $place }: { $moved } from line { $line } of the same pose { $pose }
pose-found-minus-computed-times-larger =
    Pose { $number }: measured minus computed, { $factor } times larger; corners yellow, at most { $largest }; stripe red. { $fitted ->
        [corners] Corners { $rms }
       *[edges] Edges { $rms }
    }, stripe { $stripe_rms } rms.
pose-found-minus-computed-times-larger-2 =
    Pose { $number }: measured minus computed, { $factor } times larger; corners yellow, at most { $largest }; no stripe. { $fitted ->
        [corners] Corners { $rms }
       *[edges] Edges { $rms }
    } rms.
pose-has-no-picture = { $place }: pose { $pose } has no { $missing } picture
pose-is-set-aside = Set aside
pose-left-out = Pose { $number } was left out: { CLAUSE($reason) }.
pose-looks-same-turned-round = pose { $number }: { $name } looks the same turned round
pose-needs-both-lightings = a pose needs one 'ambient' and one 'laser' picture, or one with 'both' lights
pose-set-aside = That pose is not set aside.
pose-set-aside-2 = Pose { $n } is set aside
pose-shows-corners = pose { $number } shows { $found } corners of { $name }
pose-shows-no-laser-line-object = Pose { $number } shows no laser line on the object: used without it.
pose-taken = Pose { $number } is taken.
pose-taken-back = Pose { $n } is taken back
pose-there-any-more = That pose is not there any more.
pose-used-other-one-pose =
    { $unused ->
        [one] pose { $number } was used; the other one is not, by one-pose
       *[other] pose { $number } was used; the other { $unused } are not, by one-pose
    }
pose-would-help-most-scanned-point = The pose that would help most: { $words }. A scanned point: { $now } → { $then } (k = 1).
poses = the poses
poses-2 = Poses
poses-agree-boards-place-pose-furthest = { $used } poses agree on the board's place to { $median }; pose { $number } is furthest off, by { $off }.
poses-agree-objects-place-pose-furthest = { $used } poses agree on the object's place to { $median }; pose { $number } is furthest off, by { $off }.
poses-all-alike-do-tell-where = poses that are all alike do not determine where the sensor sits on the flange, in any direction
poses-contacts-scatter-times-more-than = The poses and contacts scatter { $noise } times more than the arm's encoders explain (limit { $noisy }).
poses-enough = { $done } poses are enough
poses-put-up-apart =
    { $thing ->
        [board] poses { $poses } put the board up to { $apart } apart
       *[object] poses { $poses } put the object up to { $apart } apart
    }
poses-touches = Poses and touches
poses-were-changed-solve-again-undo = The poses were changed. Solve again, or undo the change.
poses-without-contact-points = { $count } poses without contact points
positions =
    { $bars } in { $positions ->
        [one] { $positions } position
       *[other] { $positions } positions
    }
pressed-stop = pressed Stop
principal-point = Principal point
principal-point-at = { $u }, { $v }
probe-matrix-sensors-frame-arms-last = Probe matrix: the sensor's frame in that of the arm's last joint.
probe-object = Probe the object
program-failed = the program failed at it
program-reads-version = this program reads version { $version } of { $format }
projection-matrix-contradicts = projection_matrix is not matrix · [rotation | translation_mm]
protobuf-expected = { $schemas } in protobuf is expected
put-arm-back = Put the arm back as it was
put-back-end-swing = Put it back, or end the swing.
put-back-what-there-before = put back what was there before
put-certificate-into-folder-gauges = Put its certificate into the folder gauges.
put-file-back-last-backup-leave = Put the file back from the last backup, or leave it and go on.
put-file-back-last-backup-restart = Put its file back from the last backup and restart the station, or calibrate again
put-file-place = Put a file in its place
put-last-one-back = put the last one back
put-point-back = Put point { $i } back
put-tip-into-bars-other-end = Put the tip into the bar's other end
put-tip-into-end-ball-bar = Put the tip into an end of the ball bar
put-tip-into-seat = Put the tip into the seat
put-tip-into-seat-2 = Put the tip into seat { $done }
put-touch-back = Put touch { $i } back
puts-object-fits-other-pose =
    { $readings ->
        [pose] it puts the object { $off } from where the others put it; it fits the robot's pose of pose { $other }
       *[angles] it puts the object { $off } from where the others put it; it fits the joint angles of pose { $other }
    }
puts-object-where-others-put = it puts the object { $off } from where the others put it
quaternion-length = { $place }: (qx, qy, qz, qw) is { $length } long
radius-m = Radius, µm
radius-mm-missing-sphere-judged-size = radius_mm is missing: a sphere is judged by its size
read-yet = Not read yet.
reading-arm-number = a reading of the arm { $name } is not a number
readings-arm = Readings of the arm
readings-arm-could-true-last =
    { $count ->
        [one] { $count } reading of the arm could not be true: { $what }
       *[other] { $count } readings of the arm could not be true; the last: { $what }
    }
readings-row-more-equal-last-digit = { $equal_frozen } readings in a row or more are equal to the last digit, as those of a working encoder never are
readings-shape-arm = readings of shape { $shape } for the arm { $name }
reason-and-more = { $reason } (and { $more } more)
reasons = Reasons
rebuild-recording-crenel-reconstruct = rebuild it from its recording with crenel reconstruct
rebuilding-clouds-every-calibration = Rebuilding the clouds with every calibration
rebuilt-verification-every-calibration = rebuilt a verification with every calibration
record-data-folder-any-more = The record is not in the data folder any more.
record-one-pass-over-plane = Record one pass over a plane
record-radians = Record radians
recording-cannot-read = the recording cannot be read: { $reason }
recording-cut-off = the recording is cut off
recording-cut-off-after = { $path } is cut off or damaged after { $bytes } of { $size } bytes ({ $share }); read up to { $end } from its start
recording-cut-off-before-first-message = { $path } is cut off or damaged after { $bytes } of { $size } bytes ({ $share }), before its first message
recording-cut-off-bytes-left = the recording is cut off: { $size } of { $written } bytes are left
recording-damaged = the recording is damaged
recording-empty = the recording is empty
recording-has-joints =
    { $path } holds { $count ->
        [one] { $count } joint
       *[other] { $count } joints
    }
recording-has-no-joints = { $path }: no joint angles
recording-kept = { $name }: the recording was kept.
recording-message-at = { $path } { $topic } at { $stamp_ns } ns
recording-missing = the recording is missing
recording-names-joints = { $path } names its joints { $names }
recording-no-file = the recording is no file
recording-stopped = the recording stopped
recordings = Recordings
recordings-calibrations-journal-kept-there = Recordings, calibrations and the journal are kept there.
recordings-damaged =
    { $more ->
        [0] { CLAUSE($first) }.
       *[other] { CLAUSE($first) }, and { $more } more.
    }
recordings-turned-to-one-another = the recordings are turned by up to { $angle } to one another: they are not of one plane, and their ranges mean nothing
records = Records
refining-camera-lens-laser-plane = Refining camera, lens and laser plane
reinstall-update-package = Reinstall or update that package.
rejected-and-few-edges-show = { $text }, and only { $shown } of its visible edges show in the picture
remove = Remove it
remove-point = Remove point { $index }
remove-point-first-face = Remove point { $index } first: it is not { $where }.
remove-then-touch-face-marked-drawing = Remove it, then touch the face that is marked in the drawing.
remove-touch-there-again = Remove it, and touch there again.
remove-touch-there-again-rest = Remove it and touch there again, at rest.
remove-touch-there-again-rest-clear = Remove it and touch there again, at rest and clear of the edge.
removed-account = removed an account
removed-point = removed a point
removed-kiosk-link = revoked a kiosk link
rename = Rename it
renamed-scan = renamed a scan
repeat-first-point = Repeat from the first point
repeat-start = Repeat from the start
replay-points-shown =
    { $count ->
        [one] { $name }: { $count } point shown
       *[other] { $name }: { $count } points shown
    }
report-cannot-written = a report cannot be written as '{ $suffix }'
report-made-crenel-files-session-alone = Report made by Crenel { $version } from the files of the session alone.
request-failed = the request failed
request-understood = The request is not understood: { $text }.
request-understood-2 = The request is not understood
residuals-contacts-object = Residuals of the contacts on the object
residuals-gauge = Residuals of { $name } on the gauge
residuals-gauge-2 = Residuals on the gauge
residuals-image = Residuals in the images
residuals-image-worst-poses = Residuals in the images (the { $count } of { $used } poses that fit worst)
residuals-object = Residuals on the object
residuals-pose-picture = Residuals of pose { $number } in its image
restore-backup-or-start-over = Put the last backup in its place, or move it away to start over
restore-database-from = Put { $database } from { $folder } in its place, or start on another folder with --data
restore-database-from-last-backup = Put { $database } from the last backup in its place, or start on another folder with --data
restore-file-source = Restore the file from its source
restore-picture-delete-row = Restore the picture or delete the row
restore-sessions-folder-backup = Restore the session's folder from a backup
restore-take-picture-again = Restore it, or take the picture again
result = Result
result-2 = the result
result-cannot-traced-them = The result cannot be traced to them.
result-rms = Result, rms
result-would-replace-file-made = the result would replace a file that it is made from
results = Results
review = Review
review-calibration = Review the calibration
rewritten-by-another-program = it was rewritten by another program
right = to the right
right-end = Right end
rigid-fit-given-points = a rigid fit was given { $a } and { $b } points
rigid-fit-given-points-one-line = a rigid fit was given points on one line
rms-before-after-each-pair-scale = Rms before and after, each pair on a scale of its own.
robot-pictures-agree-boards-place-but = Robot and pictures agree on the board's place, but on its tilt only to { $tilt } (the robot's own turns: { $turn }).
robots-poses = robot's poses
role-and-name = { $role }: { $name }
rotations-quaternion-has-length-1 = a rotation's quaternion has length 1
row-feature = { $place }: feature { $feature }
row-file = { $place }: file { $file }
row-has-cells =
    { $path } line { $line }: { $count ->
        [one] { $count } cell
       *[other] { $count } cells
    }
row-lighting = { $place }: lighting { $lighting }
row-place = { $path } line { $line }
rows-were-copied-arm-held-still = rows were copied, or the arm did not move: the same point twice adds nothing
runs-steadily = It runs on steadily.
s-driver-failed = The driver of the { $title } failed: { $error }
s-stripe-spans-blocks =
    { $level ->
        [crest] On the crests the stripe spans { $span } of the block's { $width }.
       *[floor] On the floors the stripe spans { $span } of the block's { $width }.
    }
same-offset = The same: offset
saturated = Saturated
save-8-16-bits = Save it with 8 or 16 bits.
save-commas-between-columns-point-numbers = Save it with commas between the columns and a point in the numbers
save-utf-8 = Save it as UTF-8
saved-result = saved the result
say-few-words-why-you-take = Say in a few words why you take over
says-hello = { $name } says hello.
says-nothing-identification = { $folder } has no identification
scan = Scan
scan-2 = Scan { $started }
scan-again = Scan again
scan-again-arm-camera-one-clock = Scan again, with arm and camera on one clock
scan-can-made-again-recording-verification = A scan can be made again of its recording, and a verification be shown to be right.
scan-cannot-start-now = A scan cannot start now
scan-cloud = Scan cloud { $clouds }
scan-cut-short = This scan was cut short: { CLAUSE($reason) }.
scan-does-start-less-than-0 = A scan does not start with less than 0.5 GB, and stops at 0.1 GB.
scan-flat-plate-nearer-away-again = Scan a flat plate, nearer and away again several times, then find it
scan-gauge = Scan the gauge
scan-gauge-again = Scan the gauge again
scan-gauge-chosen = Scan the gauge that was chosen
scan-gauge-chosen-nothing-beside = Scan the gauge that was chosen, and nothing beside it
scan-gauge-nothing-beside = Scan the gauge, and nothing beside it.
scan-goes-when-back = The scan goes on when it is back.
scan-has = a scan has { $joints_topic } and { $image_topic } or { $stripe_topic }
scan-more-clouds = Scan more clouds
scan-more-sphere = Scan more of the sphere
scan-needs = a scan needs { $needed }
scan-needs-name = A scan needs a name
scan-probe-share-arm-what-both = Scan and probe share the arm: what both have wrong alike does not show here.
scan-running-already = a scan is running already
scan-running-has-laser-stop-first = A scan is running and has the laser. Stop it first.
scan-stopped = The scan stopped: { $error }
scan-stopped-2 = the scan stopped
scanned-sphere-has-diameter = The scanned sphere has a diameter of { $diameter }
scanning = Scanning
scanning-cloud = Scanning cloud { $number }
scatter-points-rms = Scatter of the points (rms)
scatter-single-points-beyond-encoders = Scatter of single points beyond the encoders
screw-home-check-again-change-if = Screw it home and check again; change it if it stays.
screw-tip-home-clamp-sphere-check = Screw the tip home, clamp the sphere, and check again.
search-object-failed = The search for the object failed
seat-3 = the seat
seat-moved-between = the seat moved in between
seat-named = seat { $name }
seat-points-1-lie-apart = seat { $name }: its points 1 to { $split } and { $next } to { $points } lie { $gap } apart
seat-tip = Seat the tip
seats = Seats
seats-held-out = Seats, held out
seats-were-taken-another-arm = The seats were taken with another arm.
second = { $text }, { $rate } a second
second-newest-old = { CLAUSE($text) }: { $rate } a second, the newest { $age } old.
second-picture-pose = { $place }: a second { $lighting } picture of pose { $pose }
see-result = See the result
seems-lie-where-certificate-puts = { $edge } seems to lie { $off } from where the certificate puts it
seen-sharply-enough-sure = { $name } is not seen sharply enough to be sure of it
seen-than-against-diameters-given =
    { $sign ->
        [larger]
            { $label } is seen { $off } (± { $uncertainty }) larger than { $others ->
                [1] the other one
               *[other] the others
            }, against the diameters given
       *[smaller]
            { $label } is seen { $off } (± { $uncertainty }) smaller than { $others ->
                [1] the other one
               *[other] the others
            }, against the diameters given
    }
seen-well-enough-sure = { $name } is not seen well enough to be sure of it
send-support-bundle = Send the support bundle
sends-nothing =
    { $device ->
        [arm] the arm sends nothing
       *[sensor] the sensor sends nothing
    }
sensor = The sensor: { $text }
sensor-2 = Sensor
sensor-connected = the sensor is not connected
sensor-did-answer-laser-off = The sensor did not answer to Laser off
sensor-has-pixels = the sensor has { $width } × { $height }
sensor-lost-exposure-longer-than = the sensor is lost or its exposure is longer than that
sensor-measures-away-arms-last-joint = The sensor measures { $away } away from the arm's last joint (limit { $farthest_mm }).
sensor-now-sends-pictures-pixels = the sensor now sends pictures of { $size } pixels
sensor-only-went-one-way-delay = the sensor only went one way; a delay then looks like another place of the plane
sensor-reports-laser-other-state = the sensor reports the laser in its other state
sensor-turned-most-between-poses-wanted = The sensor turned by { $turn } at most between the poses (wanted: { $alike_deg } and more), so that they determine little more than one.
sensor-went = the sensor went at { $speed }; { $known }
sensor-went-along-plane-across-along = the sensor went at { $along } along the plane and at { $across } across it; along it a delay changes nothing
sensors-image-has-pixels = the sensor's image has { $width } × { $height } pixels
sensors-laser-cannot-switched-here = this sensor's laser cannot be switched from here
sent-nothing-opening-again = The { $title } sent nothing for { $silence }; opening it again
sentence = { CAPITAL(CLAUSE($text)) }.
serial-number = serial number { $serial_number }
serial-number-chessboard-inner-corners-squares = serial number { $serial_number }, chessboard, { $columns } × { $rows } inner corners, squares of { $square }
serial-number-joints-tip = serial number { $serial_number }, { $joint_count } joints, tip Ø { $diameter }
serial-number-merlons = serial number { $serial_number }, { $merlon_count } merlons, { $size } × { $size2 } × { $size3 }
serial-number-pixels = serial number { $serial_number }, { $width_px } × { $height_px } pixels
serial-port-use-another-program = The serial port { $url } is in use by another program
server-failed-what-taken-before-kept = The server failed at this; what was taken before is kept.
session-cannot-read-set-aside = The session { $session_id } cannot be read, and is set aside: { $error }.
session-closed-start-new-one = This session is closed. Start a new one.
session-could-read = the session could not be read with it
session-has-no-picture = This session has no picture { $name }.
session-went-meanwhile-nothing-done = The session went on meanwhile; nothing was done
sessions-arm-cannot-read = The session's arm cannot be read
sessions-gauge-arm-cannot-read-any = The session's gauge or arm cannot be read any more
sessions-pictures-lie-inside-folder = a session's pictures lie inside its folder
set = set { $name }
set-arm-counts-per-revolution-station = Set [arm] counts_per_revolution in station.toml.
set-arms-specification-limit-where-next = Set the arm's specification as the limit where the next check begins.
set-aside = Set aside
set-calibration-aside-start-again-beginning = Set this calibration aside and start again from the beginning?
set-cloud-aside = set a cloud aside
set-exposure-picture = set the exposure by the picture
set-exposure-so-stripe-bright-but = Set the exposure so that the stripe is bright but not clipped.
set-limit = set the limit
set-machines-clock-let-kept-time = Set the machine's clock, and let it be kept by a time server.
set-pose-aside = set a pose aside
set-sensor-back-calibrate-again = set the sensor back, or calibrate again
set-sensor-back-scan-again = set the sensor back, and scan again
set-sensor-rate-hz = Set [sensor] rate_hz.
set-up = Set-up
settings-are-lost = The settings are lost: { $error }
shorten-exposure-or-darken-room = Shorten the exposure, or darken the surroundings
should-used-findings-say-why = It should not be used: the findings say why.
show-more-block-crests-floors-front = Show more of the block, crests and floors, front and back.
show-whether-certificate-right-there-checked =
    { $detections ->
        [one] The picture does not show { $hidden }: whether the certificate is right there is not checked.
       *[other] The pictures do not show { $hidden }: whether the certificate is right there is not checked.
    }
shows-no-stripe = { $path } shows no laser stripe
shows-no-stripe-outside-mask = { $path } shows no laser stripe outside the mask
side-merlon =
    { $side ->
        [right] the right side of merlon { $number }
       *[left] the left side of merlon { $number }
    }
side-of-block =
    { $side ->
        [back] the block's back
       *[front] the block's front
    }
sign-ask-administrator-account = Sign in, or ask the administrator for an account
sign-browser-your-own = Sign in at a browser of your own
sign-go = Sign in, and go on
signatures = Signatures
signed = signed in
signed-out = signed out
simulated-camera-is-lost = The simulated camera is lost
simulated-sensor-is-not-open = The simulated sensor is not open
since-calibration = { $celsius }, { $change } since the calibration.
six-seven-joints-expected = six or seven joints are expected, not { $joints }
size-expected = { $width } × { $height } are expected
so-centre-known-k-1 = so its centre is known to { $centre_sd }, k = 1
so-plane-known-k-1 = so the plane is known to { $at } and { $arcsec }, k = 1
software = Software
software-part =
    { $part ->
        [processors] { $version } processors
       *[other] { $part } { $version }
    }
solve-again = Solve again.
solve-again-2 = Solve again
solving-camera = Solving for the camera
some-points-off-their-face-remove = Some points are off their face. Remove them, then go on.
somebody-must-able-give-people-access = somebody must be able to give people access
somebody-publishes-what-no-station-does = Somebody publishes what no station does, and may hide or falsify what is shown.
something-changed-since-solved-solve-again = Something changed since this was solved. Solve again.
sphere = Sphere
sphere-2 = sphere, { $diameter }
sphere-4 = { $path }: it is of a sphere
sphere-clamped = The sphere is clamped
sphere-known-diameter-clamped-firmly-within = A sphere of known diameter, clamped firmly within easy reach.
sphere-known-to = Ø { $diameter }, known to { $known } (k = 1)
sphere-named = sphere { $name }
sphere-of-unknown-uncertainty = Ø { $diameter }, its uncertainty is not stated
spheres = Spheres
spheres-held-out = Spheres, held out
spheres-seen-against-their-diameters-tips = the spheres are seen { $excess } (± { $uncertainty }) against their diameters with the tip's { $diameter }
spheres-seen-than-stated-tips-diameter =
    { $sign ->
        [larger] the spheres are seen { $excess } larger than stated: the tip's diameter may be { $diameter }
       *[smaller] the spheres are seen { $excess } smaller than stated: the tip's diameter may be { $diameter }
    }
spheres-size-by-certificate-or-datasheet =
    { $sign ->
        [larger] by the arm's datasheet the spheres have the sizes given for them; by this bar's length they would be { $excess } larger
       *[smaller] by the arm's datasheet the spheres have the sizes given for them; by this bar's length they would be { $excess } smaller
    }
spread-needs-least-two-clouds = a spread needs at least two clouds
spread-points-hold-still-press-arms = { $place } Spread { $wanted } points, hold still, and press the arm's button.
spread-them-wide-clear-edges = Spread them wide, clear of the edges.
square-mm-too-small = square_mm must be at least { $least }; is it in metres?
squares-100-mm = squares of 100 mm
standard-one-seat-continuous-swing-positions = Not to standard: one seat and a continuous swing, not the positions and points of ASME B89.4.22 or ISO 10360-12. No result of theirs is claimed.
standard-positions-articulations-counts-iso-10360 = Not to standard: the positions, articulations and counts of ISO 10360-8 and of ISO 10360-12 are not run to the letter, so that no symbol of theirs is printed.
standard-touches-those-sphere-tests-iso = Not to standard: the touches are not those of the sphere tests of ISO 10360-12, so that no symbol of theirs is printed.
standard-uncertainty-0-mm = A standard uncertainty is 0 to { $largest }.
standard-uncertainty-k-1-scanned-point = Standard uncertainty (k = 1) of a scanned point over the laser plane, from { $low } ({ $low_mm }) to { $high } ({ $high_mm }). Struck through: extrapolated, nearer or further than the calibrated { $near } to { $far } from the camera.
standard-uncertainty-mm-too-large = standard_uncertainty_mm must be at most { $most }; is it in micrometres?
standing-still-same-points-taken-again = Standing still: the same points are taken again and again
start-again = Start it again
start-again-2 = start it again
start-new-calibration = Start a new calibration
started-scan = started a scan
state-laser-colour = State laser_wavelength_nm in the sensor's datasheet, or --colour on the command line; or give grey pictures
stated = not stated
station-does-answer-name-names-added = This station does not answer to the name '{ $name }'. Names are added with hosts in station.toml.
station-ended-during-scan = The station ended during this scan.
station-has-administrator-already = The station has an administrator already
station-starting = The station is starting.
station-toml-driver-has-no-option = station.toml, [{ $table }]: the driver has no option { $key }
station-toml-exposure-range-alone = station.toml, [sensor]: exposure_range_us needs exposure_us, to begin with
station-toml-gives-counts-per-revolution = station.toml gives { $counts } counts_per_revolution, the arm has { $joints } joints
station-toml-key-not-for-video = station.toml, [sensor]: { $key } cannot be set of a video file
station-toml-no-such-driver = station.toml, [{ $table }]: there is no driver { $name }
station-toml-option-missing = station.toml, [{ $table }]: the option { $key } is missing
station-toml-value-unusable = station.toml, [{ $table }]: { $key } = { $value } cannot be used: { $reason }
station-uses = The station uses { $process }.
station-uses-and-free = The station uses { $process }; { $free } are free.
stations-disk-full = the station's disk is full
step-before-one = That is not a step before this one.
still = Still
still-running = { $title } is still running
still-turn = Still to turn
stop-before-next = stop it before the next
stop-first = Stop it first
stop-simulation = Stop the simulated operator
stop-scan-first = stop the scan first
stop-server-give-one-data-folder = Stop that server, or give this one a data folder of its own with --data
stop-station-keep-copy-data-folder = Stop the station, keep a copy of the data folder, and start from the last backup.
stopped-laser-off = Stopped: the laser is off.
stopped-scan = stopped a scan
stopped-simulation = stopped the simulated operator
stored-under-records-scan-or-calibrate-again = It is stored under Records. Scan with it, or calibrate again.
straight-above-chessboard-follow-dashed-outline = From straight above the chessboard: { $words }. Follow the dashed outline.
straight-edges-do-make-block = its { $segment_count } straight edges do not make a block
stripe-about-laser-plane-rms-points =
    Stripe about the laser plane, rms of { $points ->
        [one] { $points } point
       *[other] { $points } points
    }
stripe-axis = stripe axis "{ $axis }"
stripe-choice-is = the choice of the stripe is “{ $choice }”
stripe-extracted-grey-images-8-16 = a stripe is extracted from grey images of 8 to 16 bits, height by width
stripe-maximum-width-is = the maximum width of the stripe is { $width }
stripe-minimum-width-is = the minimum width of the stripe is { $width }
stripe-one-level-alone-does-fix = a stripe on one level alone does not fix the laser plane
stripe-pieces-of =
    { $points ->
        [one] pieces of the stripe have { $points } point
       *[other] pieces of the stripe have { $points } points
    }
stripe-points-crests-floors-fit-one = { $points } stripe points on crests and floors fit one plane to { $rms } rms, { $share } of those there (limit { $agreeing }).
stripe-points-fit-one-laser-plane = { $points } stripe points fit one laser plane to { $rms } rms (limit { $stripe_rms_px }), { $share } of those on the object (limit { $agreeing }).
stripe-px = Stripe, px
stripe-threshold-is = the threshold of the stripe is { $threshold }
study-compares-several = a study compares several
study-left-out = { $name }: { CLAUSE($reason) }.
study-plane = the study is of a plane
support-bundle-being-made-already = A support bundle is being made already
surface-does-bend = the surface does not bend
swing = Swing
swing-about-middle-limit = Each point of the swing about the middle of all, in the arm's frame. Dashed: the limit of { $limit }.
swing-arm = Swing the arm
swing-arm-about = Swing the arm about { $place }
swing-elbow-one-side-other-while = Swing the elbow from one side to the other while the tip stays in the seat
swing-further-least = Swing further: { $swing } of at least { $least_swing_deg }.
switch-arm-check-cable-port = Switch the arm on, and check its cable and that this is its port.
switch-arm-off = Switch the arm off and on.
switch-arm-sensor-connect-them = Switch the arm and the sensor on and connect them.
switch-laser-look-where-lies = Switch the laser on to look where it lies.
switch-off-aim-picture-switched-itself = Switch it off to aim. For the picture it is switched by itself.
switch-over-part = switch it on, over a part
switch-stop-scan = Switch it on, or stop the scan.
switched-laser = switched the laser on
switched-laser-off = switched the laser off
table-first-line-names = { $path }: its first line names { $names }
table-is-empty = it is empty; a line of column names is expected
table-lacks-column = its table { $table } has no { $column }
take-again = Take it again
take-again-2 = take it again
take-another = { $taken } Take another: { $words }.
take-another-password = Take another
take-another-pose = Take another pose
take-back = Take it back
take-bars-other-end-first-drop = Take the bar's other end first, or drop the last.
take-longer-one-three-unrelated-words = Take a longer one; three unrelated words are good
take-longer-pass-five-seconds-more = Take a longer pass, five seconds or more
take-more-pictures-8-more-them = take more pictures, 8 or more of them, tilted by 20° and more
take-more-pictures-all-sides-have = Take more pictures, from all sides; have the arm's model identified again.
take-more-pictures-all-sides-hold = Take more pictures, from all sides; hold the arm in a compact posture.
take-more-pictures-board-all-corners = Take more pictures, with the board in all corners of the picture.
take-more-pictures-each-turned-against = take more pictures, each turned against the others, or touch the object
take-more-pictures-lasers-line-flat = Take more pictures, with the laser's line on the flat of the board.
take-more-pictures-like-these = Take more pictures, tilted to all sides: about { $asked } like these, in all, would do. If that is all the robot can do, set the limits to what the scans need (--good-um, --usable-um).
take-more-pictures-robot-at-fault = Take more pictures, tilted to all sides; so far off, the robot's own accuracy is at fault, or its poses are not the flange's in the arm's frame. If that is all the robot can do, set the limits to what the scans need (--good-um, --usable-um).
take-more-pictures-tilted-all-sides-2 = Take more pictures, tilted to all sides.
take-more-places-all-over-arms = Take more places, all over the arm's reach
take-more-places-all-over-reach = Take more places, all over the reach, with the arm swung from side to side in each
take-more-points-more-places = Take more points, in more places
take-more-poses-tilted-turned = Take more poses, tilted and turned.
take-more-poses-tilted-turned-have = Take more poses, tilted and turned; have the arm's model identified again.
take-more-there-delete-rows = Take more there, or delete its rows
take-more-while-arm-swings = Take more while the arm swings
take-one = Take one of { $languages }
take-one-console-shows-since-stations = Take the one that the console shows since the station's last start
take-one-place-two-if-there = Take one in a place or two, if there is one.
take-out = Take { $key } out.
take-out-label-face-touched = Take it out, or label it with the face that was touched
take-pass-again = Take the pass again
take-picture = Take the picture
take-picture-2 =
    { $thing ->
        [board] take a picture of the board
       *[object] take a picture of the object
    }
take-picture-again = Take this picture again
take-picture-object = Take a picture of the object
take-pictures-different-distances-tilted-different = take pictures from different distances, or tilted to different sides
take-pictures-tilted-20-more-two = take pictures tilted by 20° and more, to two sides
take-pictures-turned-20-more-about = take pictures turned by 20° and more, about two different axes
take-place-again-delete-rows = Take this place again, or delete its rows
take-point = Take the point
take-points-or-delete-file = Take some, or delete the file
take-poses-tilted-left-right-front = Take poses tilted to the left, right, front and back, and turned about the view.
take-these-points-again = Take these points again.
take-touch = Take the touch
take-with-laser-or-other-axis = Take it with the laser on and the exposure set, or choose the other --axis
taken = { $path } was taken with { $device } { $recorded }
takes-notifications = { $host } takes notifications.
taking-picture = Taking the picture
tells-whoever-away-what-done-fault = It tells whoever is away of what is done, at fault or due.
temperature = Temperature
text-has-half-character = one of its texts has half a character
than-when-made-beyond-c-due =
    { $how ->
        [warmer] It is { $difference } warmer than when it was made; beyond { $limit } it is due.
       *[colder] It is { $difference } colder than when it was made; beyond { $limit } it is due.
    }
the-is-for =
    { $device ->
        [sensor] the calibration is for { $known }
       *[arm] the arm.json is for { $known }
    }
there-dirt-tip-sphere = The tip seems to be { $diameter }, { $expected } by the arm's datasheet: there is dirt on the tip or on the sphere.
there-no-account = There is no account { $name }.
there-no-address-yet = There is no address yet
there-no-calibration = There is no calibration { $calibration_id }.
there-no-calibration-use-calibrate-first = There is no calibration in use. Calibrate first.
there-no-calibration-use-yet = There is no calibration in use yet.
there-no-check-arm = There is no check of the arm { $record_id }.
there-no-check-tip = There is no check of the tip { $record_id }.
there-no-command = There is no command '{ $name }'.
there-no-earlier-step = There is no earlier step '{ $to }'.
there-no-face = There is no face '{ $face }'.
there-no-fitted-shape-yet = There is no fitted shape yet
there-no-gauge-data-folder-yet = There is no gauge in the data folder yet.
there-no-here =
    { $field ->
        [arm] There is no arm '{ $chosen }' here.
        [object] There is no object '{ $chosen }' here.
       *[sensor] There is no sensor '{ $chosen }' here.
    }
there-no-identification-arm = There is no identification of the arm { $record_id }.
there-no-language = there is no language '{ $language }'
there-no-limit = { $title }: { $value }; there is no limit.
there-no-map-cloud = There is no map of cloud { $number }.
there-no-picture-object-sensor-take = There is no picture of this object and sensor. Take one.
there-no-picture-yet-take-one = There is no picture yet. Take one.
there-no-points-rectangle = There are no points in the rectangle
there-no-scan = There is no scan { $scan_id }.
there-no-scan-find-delay = There is no scan to find the delay from
there-no-simulation-real-devices = Real devices have no simulated operator.
there-no-simulation-real-devices-2 = Real devices have no simulated operator
there-no-sphere-diameter-cloud = There is no sphere of { $diameter } diameter in this cloud
there-no-such-arm = There is no such arm.
there-no-such-artefact-here = There is no such artefact here.
there-no-such-cloud = There is no such cloud.
there-no-such-folder = there is no such folder
there-no-such-gauge = There is no such gauge.
there-no-such-page-3d-view = There is no such page of the 3D view.
there-no-such-touch = There is no such touch.
there-no-token = There is no token { $token_id }.
there-no-valid-calibration = there is no valid calibration
there-no-verification = There is no verification { $record_id }.
there-no-kiosk-link = There is no kiosk link { $link_id }.
there-none-yet = There is none yet.
there-nothing = There is nothing at { $path }.
there-nothing-verify = There is nothing to verify
thermometer-cannot-read = The thermometer { $path } cannot be read: { $error }
thermometer-reads = The thermometer { $path } reads { $celsius }
these-files-what-result-made-accepted =
    { $changed ->
        [one] { $changed } of these files is not what the result was made from and accepted as.
       *[other] { $changed } of these files are not what the result was made from and accepted as.
    }
these-joint-angles-but-arm-json = these are joint angles, but arm.json says that the arm reports poses
these-metres-where-millimetres-expected = these are metres where millimetres are expected
these-points-do-tell-better-than = these points do not determine it better than its manufacture does
these-radians-where-degrees-expected = these are radians where degrees are expected
these-use = These are in use
they-cannot-show-whether-arm-better = they cannot show whether the arm is better elsewhere
they-come-more-than-one-camera = they come from more than one camera, or were scaled
they-do-come-arm-kind-tip = they do not come from an arm of this kind, or the tip was not seated
they-do-determine-camera = they do not determine the camera
they-do-fix-centre = they do not fix its centre
they-do-lie-one-plane = they do not lie in one plane
they-fix-no-plane = they fix no plane
they-fix-no-sphere = they fix no sphere
they-leave-nothing-over-check-parameters = they leave nothing over to check { $columns } parameters
they-lie-almost-one-plane-almost = they lie almost on one plane, or almost in one row on each level
they-recording-but-gave-no-points = They are in the recording, but gave no points; check the arm's cable.
this-program = this program
tilt-back-by = tilt to the back { $angle }
tilt-front-by = tilt to the front { $angle }
tilt-left-by = tilt left { $angle }
tilt-level = Tilt from level
tilt-right-by = tilt right { $angle }
tip = Tip
tip-3 = Tip: { $text }
tip-bars-end = The tip is in the bar's end
tip-check = Tip check
tip-held-seat-moved-max-min = The tip in a seat moved by { $worst }, (max − min)/2 on the worst axis.
tip-in-seat-moved-limit = The tip in a seat moved by { $worst }, (max − min)/2 on the worst axis; the limit is { $limit }.
tip-known = Tip known to
tip-known-apart-from-size = Over its reach the tip was off by { $before } rms and is now known to { $after } (k = 1), apart from the arm's size.
tip-lies-within-mm = the tip lies within { $distance } of it
tip-missing-place-flange-diameter = tip is missing: its place on the flange and its diameter
tip-never-checked = The tip was never checked.
tip-off-place-arm = Tip off its place on the arm
tip-over-whole-reach = Tip over the whole reach
tip-rather-has = the tip rather has { $diameter }, or the spheres' diameters are not theirs
tip-rather-has-or-bar-wrong = the tip rather has { $diameter }, or the spheres' diameters are not theirs, or a bar's length is wrong
tip-seat = The tip is in the seat
tip-seat-no-points-taken-there = The tip is { $left } from the seat; no points are taken there.
tip-seated-seat-loose-points-another = the tip was not seated, or the seat was loose, or points of another place are among them
tip-sits-off-its-place = The tip sits { $off } from its place in the datasheet: the stylus is bent or not screwed home.
tip-sound-diameter-off-touches-agree = The tip is sound: its diameter is off by { $off }, its touches agree to { $scatter }.
tip-sphere-diameter-arm = of the tip from a sphere of that diameter, by the arm as it is
tip-uncertainty-before =
    { $size_known ->
        [yes] was { $before }; k = 1, rms over the reach
       *[no] was { $before }; k = 1, rms over the reach; apart from the arm's size
    }
tips-coordinates-moved-instead = the tip's coordinates are moved instead
tips-diameter = The tip's diameter
tips-diameter-how-well-touches-agree = The tip's diameter, and how well its touches agree.
tips-diameter-off-known-only-k = The tip's diameter is off by { $off }, known to { $known } only (k = 2).
tips-places = The tip's places
tips-places-about-their-middle = The tip's places about their middle
titled-text = { $title }: { $text }
to-2 = To
together = Together
too-bright-saturated = Too bright: { $share } saturated
too-dark-brightest-parts = Too dark: brightest parts at { $level }
too-fast-blur-limit = Too fast: { $blur } of blur; the limit is { $limit }
too-few-edges-could-measured = too few of its edges could be measured
too-few-places-were-touched = too few places were touched: { $count }
too-little-arm-data-yet = Too little arm data yet
too-many-wrong-tries = Too many wrong tries.
took-cloud-back = took a cloud back in
took-control-over = took control over
took-last-one-back = took the last one back
took-over-control = { $name } took over control from { $holder }: { $reason }
took-picture = took a picture
took-picture-again = took a picture again
took-point = took a point
took-pose-back = took a pose back in
took-support-bundle = took the support bundle
top-all-around-side-wrist-turned = Its top and all around its side, the wrist turned another way each time. Hold still and press the arm's button at each place.
topic-holds = { $path }: { $topic } holds { $schema } ({ $encoding })
total-k-1 = { $total } (k = 1)
touch = Touch it
touch-2 = Touch { $place }
touch-3 = Touch
touch-all-over-upper-half-every = Touch it all over its upper half, from every side, with the arm in many postures. Hold still and press the arm's button at each point.
touch-back-face = Touch the back face.
touch-elsewhere = Touch it elsewhere
touch-face-also-beside-line = Touch the { $face } face also beside that line
touch-floors-grooves = Touch the floors of the grooves.
touch-front-back-left-right-face = Touch the front and the back, or the left and the right face.
touch-front-face = Touch the front face.
touch-gauge = Touch the gauge
touch-gauge-2 = Touch { $counted } of the gauge.
touch-gauge-more-places-scan-more = Touch the gauge in more places, and scan it more slowly.
touch-left-end = Touch the left end.
touch-more-contacts = Touch { $contacts }
touch-more-least-places = Touch it more: { $taken } of at least { $touches_needed } places.
touch-more-least-points = Touch it more: { $taken } of at least { $least } points.
touch-more-places = Touch it in more places
touch-more-points-spread-wide-over = Touch more points, spread wide over the board.
touch-more-points-spread-wide-over-2 = Touch more points, spread wide over all six faces.
touch-more-sphere = Touch more of the sphere
touch-near-corners-too = Touch it near its corners, too
touch-object = Touch the object
touch-printed-side-more-times-spread = Touch the printed side { $left } more times, spread wide. Or go on.
touch-printed-side-once-more-far = Touch the printed side once more, far from the others. Or go on.
touch-probe-press-arms-button-each =
    { $shape ->
        [plane] Touch it with the probe near its corners and in its middle, and press the arm's button at each place.
       *[sphere] Touch it with the probe on its top and all around its side, and press the arm's button at each place.
    }
touch-right-end = Touch the right end.
touch-scan-gauge-takes-two-minutes = { $text } Touch and scan a gauge: it takes two minutes.
touch-sphere = Touch the sphere
touch-sphere-more-spread-over-all = Touch the sphere more, spread over all its upper half.
touch-top-all-around-side = Touch its top and all around its side
touch-tops-merlons = Touch the tops of the merlons.
touched-sphere-seems-to-have-diameter = The touched sphere seems to have a diameter of { $radius }; by its certificate it has { $radius2 }.
touches = { $done } of { $of } touches
touches-2 = Touches
touches-3 = The touches
touches-about-sphere-limit = Distance of each touch from the sphere through all of them. Dashed: the limit of { $limit }.
touches-agree = Touches agree to
touches-disagree-up-tip-sphere-loose = The touches disagree by up to { $scatter }: the tip or the sphere is loose, or the arm slipped.
touches-lie-too-near-together-one = The touches lie too near together, or on one ring about the sphere
touches-lie-within-one-line = The touches lie within { $width } of one line
touches-on-face = { $count } { $where }
touches-over-all-faces = { $total } more over all faces, { $most } of them { $where },
touches-rms-known-k-1 = by { $touches } touches, { $rms } rms, known to { $known } (k = 1)
touches-would-bring =
    { $total ->
        [one] Object known to { $now } (k = 1); { $words } brings { $then }.
       *[other] Object known to { $now } (k = 1); { $words } bring { $then }.
    }
touches-would-not-reach =
    { $total ->
        [one] Object known to { $now } (k = 1); { $words } brings { $then }, { $target } are wanted.
       *[other] Object known to { $now } (k = 1); { $words } bring { $then }, { $target } are wanted.
    }
tried-notifications = tried the notifications
try-again = Try again
try-again-ask-administrator-new-password = Try again, or ask an administrator for a new password
try-again-if-happens-again-stations = Try again. If it happens again, the station's log has the details.
try-again-moment = Try again in a moment
turn-anticlockwise-by = turn anticlockwise { $angle }
turn-clockwise-by = turn clockwise { $angle }
turn-down-exposure-until-objects-faces = turn down the exposure until the object's faces keep their grey
turn-fault-switch-camera-lost-off = Its fault switch camera_faults.lost is on; turn it off.
turn-lamp-until-all-edges-block = Turn the lamp until all edges of the block show, and take another picture.
turn-off-cameras-mirroring-turn-object = turn off the camera's mirroring, or turn the object so that its front faces the camera
turn-sensor-so-laser-falls-onto = turn the sensor so that the laser falls onto the board from above
turn-up-light-exposure = turn up the light or the exposure
turn-up-light-exposure-look-object = turn up the light or the exposure, and look at the object
two-pictures-named = two pictures are named { $name }, and would be one file in { $folder }
two-seats-or-seat-carried = they are of two seats, or the seat was carried elsewhere in between
two-seats-or-seat-carried-or-arm = they are of two seats, or the seat was carried elsewhere in between, or arm.json is not this arm's: in other seats, too, its tip goes { $far }
u-v = it is "u" or "v"
uncertainty-missing = { $file }: uncertainty is missing
uncertainty-over-measuring-volume = Uncertainty over the measuring volume
uncertainty-scanned-point-k-1 = Uncertainty of a scanned point (k = 1)
uncertainty-scanned-point-so-far-k = Uncertainty of a scanned point so far (k = 1)
undecided = Undecided
undo = Undo
undo-last-point = Undo the last point
uninstall-one-them = Uninstall one of them.
unit = Unit
up-poses = { $done } of up to { $of } poses
up-to-taken-one = up to { $rms } are taken for one
update-program-arms-firmware = Update this program or the arm's firmware.
upright-edge-of-merlon =
    { $end ->
        [back]
            the upright back edge on merlon { $number }'s { $side ->
                [right] right
               *[left] left
            }
       *[front]
            the upright front edge on merlon { $number }'s { $side ->
                [right] right
               *[left] left
            }
    }
usable = Not usable: { $fault }
usable-2 = Not usable
usable-attention = Usable, with attention
usable-edge-stripe-points = { $found } usable edge and stripe points
usable-edge-stripe-points-poses = { $found } usable edge and stripe points in { $views } poses
usable-most = { $total }; usable is at most { $usable }.
use = In use
use-2 = { $name } is in use.
use-arm-before-what-identified-kept = Use the arm as it was before? What was identified is kept in this session.
use-arm-now = Use this arm from now on
use-block-better-certificate = Use a block with a better certificate.
use-board-even-odd-count-inner = use a board with an even and an odd count of inner corners
use-full-pictures-one-sensor = use full pictures of one sensor
use-full-pictures-one-sensor-neither = use full pictures of one sensor, neither cropped nor scaled
use-method-joint-pictures-board-several = use --method joint, with pictures of the board from several sides
use-object-higher-step-show-crests = use an object with a higher step, and show it crests and floors, front and back
use-object-whose-merlons-differ-width = use an object whose merlons differ in width
use-shorter-cable-port-own-close = Use a shorter cable and a port of its own; close what else uses the machine.
use-switch-sensor = use the switch on the sensor
used = Not to be used
used-but = Used, but { $reason }
used-but-2 = used, but { $reason }
user-may-open-serial-port-another = This user may not open the serial port { $url }, or another program has it open
value = Value
value-missing = it is missing
value-must-be = it must be { $expected }
value-must-be-at-least = it must be at least { $limit }
value-must-be-at-most = it must be at most { $limit }
value-must-be-finite = it must be a finite number
value-must-be-greater = it must be greater than { $limit }
value-must-be-less = it must be less than { $limit }
value-must-be-list = it must be a list
value-must-be-number = it must be a number
value-must-be-object = it must be an object with fields
value-must-be-one-of = it must be one of { $expected }
value-must-be-text = it must be text
value-must-be-true-or-false = it must be true or false
value-must-be-whole-number = it must be a whole number
value-must-match-pattern = it must match the pattern { $pattern }
value-not-known = it is not known
value-too-long-list =
    { $count ->
        [one] the list must have at most { $count } entry
       *[other] the list must have at most { $count } entries
    }
value-too-long-text =
    { $count ->
        [one] it must have at most { $count } character
       *[other] it must have at most { $count } characters
    }
value-too-short-list =
    { $count ->
        [one] the list must have at least { $count } entry
       *[other] the list must have at least { $count } entries
    }
value-too-short-text =
    { $count ->
        [one] it must have at least { $count } character
       *[other] it must have at least { $count } characters
    }
values-shares-their-limits-bar-expanded = Values in shares of their limits: the bar is the expanded uncertainty (k = 2), circles are the single clouds.
verification = Verification
verification-cannot-read = The verification { $one } cannot be read.
verification-closed-start-new-one = This verification is closed. Start a new one.
verification-cloud = Verification, cloud { $number }
verification-failed-ago = It failed { $ago } ago. { $text }
verification-gauge =
    { $shape ->
        [sphere] Verification on a gauge sphere
       *[plane] Verification on a gauge plane
    }
verification-undecided-ago = It was not decided { $ago } ago. { $text }
verification-under-way-go-where-stands = A verification is under way. Go on where it stands.
verified = Verified: { $text }
verify = Verify
verify-again = Verify again
verify-against-gauge-calibrate-again = Verify against a gauge, or calibrate again.
video-file = The video file { $source }
video-has-no-picture = { $title } holds no picture
video-stream = The video stream { $source }
video-without-rate = { $title } does not give its rate
wait = Wait for it
wait-2 = Wait: { CLAUSE($text) }.
wait-check-what-taken-kept = Wait, or check it. What was taken is kept.
wait-moment-load-page-again = wait a moment, or load the page again
wait-s-then-try-again = Wait { $wait }, then try again
wait-stop = Wait, or stop it
wait-until = wait until it is
wait-until-arm-connected-again-nothing = wait until the arm is connected again; nothing was lost
wait-until-back = wait until it is back
wait-until-connected = wait until it is connected
wait-until-does = wait until it does
wait-until-done = wait until it is done
wait-until-has-ended = wait until it has ended
wait-until-sensor-connected-capture-again = wait until the sensor is connected, and capture again
waiting-s-first-data = Waiting for the first data of the { $title }
kiosk-can-only-view = A kiosk display can only view.
wanted-points-fit = wanted: { $target }; points fit to { $rms }
webhook = Webhook
went-another-pose = went on to another pose
went-back-points = went back to the points
went-more-clouds = went on to more clouds
went-result = went on to the result
went-step-back = went a step back
went-without-probe = went on without the probe
what-and-why = { CAPITAL(CLAUSE($what)) }: { CLAUSE($why) }.
what-calibrated = What was calibrated
what-cannot-read-set-aside-everything = What cannot be read is set aside as it is; everything else is served.
what-checked = What was checked
what-clouds-show-against-certificate = What the clouds show against the gauge's certificate and the probe.
what-identified = What was identified
what-looks-may-good-bad = What it looks at may be good or bad.
what-passed-over-plane = what was passed over is not a plane
what-recorded-kept = { $interrupted } What was recorded is kept.
what-recorded-kept-2 = What was recorded is kept.
what-sent-did-arrive-within = What was sent did not arrive within { $limit }.
what-shows-could-more-than-one = what it shows could be more than one part of the object
what-shows-reads-rather-like-objects = what it shows reads rather like the object's mirror image
what-standard-uncertainty-k-1-scanned = Sources of the standard uncertainty (k = 1) of a scanned point.
what-taken-kept-folder = What was taken is kept in its folder.
what-tip-moved-while-held-one = What the tip moved by while it was held in one place.
what-verified = What was verified
where-sensor-sits-along-axis-cannot = where the sensor sits along that axis cannot be determined
who-reads-along-has-passwords-can = Who reads along has passwords, and can act in other people's names.
whoever-helps-you-asks-first = Whoever helps you asks for this first.
whole = It is whole, { $size_mb }.
whole-number-zero-more-expected = a whole number, zero or more, is expected
whole-program-stood-still-longest =
    { $count ->
        [one] the whole program stood still once, for { $longest }
       *[other] the whole program stood still { $count } times, { $longest } the longest
    }
why = Why
wide = { $wide } wide
widths-positive-ascend-choice-one = widths are positive and ascend; the choice is one of { $choices }
with-radius = radius { $radius }
with-tip = tip { $diameter }
within-limit = Within the limit
within-limit-m = { $half_range }, within the limit of { $limit }.
without-ball-bar-arm-keeps-size = Without a ball bar the arm keeps the size of its datasheet.
without-ball-bar-arms-size-observable = without a ball bar the arm's size is not observable
without-free-memory-whole-machine-slows = Without free memory the whole machine slows down, and frames are lost.
without-nothing-measured-what-taken-kept = Without it nothing is measured; what was taken is kept.
without-one-pixels-cannot-become-points = without one pixels cannot become points
without-schema = without a schema
word-above = above
word-ambient = ambient
word-arm = arm
word-back = back
word-ball = ball
word-bar = bar
word-below = below
word-block = block
word-board = board
word-boolean = boolean
word-both = both
word-calibration = calibration
word-camera = camera
word-changed = changed
word-colder = colder
word-contact = contact
word-corner = corner
word-crest = crest
word-crests = crests
word-cylinder = cylinder
word-depth = depth
word-distortion = distortion
word-edges = edges
word-exposure = exposure
word-fail = fail
word-floor = floor
word-floors = floors
word-focus = focus
word-frames = frames
word-framing = framing
word-front = front
word-gauge = gauge
word-groove = groove
word-integer = integer
word-laser = laser
word-left = left
word-left-of = left of
word-lighting = lighting
word-merlon = merlon
word-missing = missing
word-no = no
word-none = none
word-number = number
word-object = object
word-off = off
word-on = on
word-once = once
word-part = part
word-pass = pass
word-pictures = pictures
word-plane = plane
word-plate = plate
word-points = points
word-right = right
word-right-of = right of
word-scan = scan
word-seat = seat
word-sensor = sensor
word-shell = shell
word-sphere = sphere
word-step = step
word-string = string
word-stripe = stripe
word-tip = tip
word-unchanged = unchanged
word-undecided = undecided
word-unknown = unknown
word-used = used
word-verification = verification
word-warmer = warmer
working-out-error-budget = Working out the error budget
working-out-uncertainty = Working out the uncertainty
working-out-which-pose-would-help = Working out which pose would help most
worn-has-flat = The tip seems to be { $diameter }, { $expected } by the arm's datasheet: it is worn, or has a flat.
write-one = write one
writing-cloud = Writing the cloud
writing-scan = Writing the scan
wrong-code = wrong code
wrong-password = wrong password
you-do-have-control = You do not have control
zone-has-no-area = zone { $number } has no area
zone-outside-picture = zone { $number } lies outside the picture
zone-reaches-far-beyond-picture = zone { $number } reaches far beyond the picture
zones-cannot-set-now = zones cannot be set now
zones-picture-pixels-left-out-sensors = The zones are for a picture of { $width_px } × { $height_px } pixels and are left out; the sensor's has { $width_px2 } × { $height_px2 }

a-calibration-belongs-to-one-sensor = a calibration belongs to one of them
a-laser-plane-is-of-one-laser = a laser plane is that of one laser
abandon-calibration-calibration-use-stays = Cancel this calibration? A calibration in use stays as it is.
abandoned = cancelled the session
about-missing-places-longest-start =
    { $stream ->
        [joints]
            about { $missing ->
                [one] one arm reading is
               *[other] { $missing } arm readings are
            } missing in { $holes ->
                [one] { $holes } gap
               *[other] { $holes } gaps
            }, the longest { $longest }, { $at } from the start
       *[frames]
            about { $missing ->
                [one] one frame is
               *[other] { $missing } frames are
            } missing in { $holes ->
                [one] { $holes } gap
               *[other] { $holes } gaps
            }, the longest { $longest }, { $at } from the start
    }
accept-calibration = Accept this calibration
accept-verification = Accept this verification
acceptance-limit-lower = Lower acceptance limit
acceptance-limit-upper = Upper acceptance limit
accepted = Accepted
accepted-result = accepted the result
account-belongs-to-another = There is another account { $name } at this station already
account-change-at-provider = Change it at the provider; it counts from the next sign-in on
account-has-no-name = The account has no name
account-is-of-provider = The provider decides on the password and the role of { $name }
account-name-length = a name has 1 to { $most } letters, digits and symbols
account-not-there = There is no account { $name }
account-remove-or-use-password = Sign in with its password, or ask an administrator to remove it
account-taken = An account { $name } already exists
accounts-are = accounts: { $names }
accounts-none = accounts: none yet
across-mm = across, mm
act-failed = failed
act-with-detail = { $act }: { $detail }
activity-arm = Arm check
activity-calibration = Calibration
activity-delay = Determination of the arm's delay
activity-ended = { $who } ended: { $title }.
activity-performance = Performance test
activity-scan = Scan
activity-verification = Verification
add-column-or-leave-both = Add the column, or leave out both
add-dh-row = Give one row for each joint, in order
add-exposure-us-line = Add a line exposure_us = …
add-line = Add a line { $key } = …
add-micrometer-reading-of-width = Add a reading of a merlon's width by micrometer, or subtract the tip's diameter and state its uncertainty as tool_uncertainty_mm under another tool
add-picture-delete-pose = Add the picture, or delete the pose
add-pictures-turned-about-another-axis = add pictures rotated about another axis
add-readings-from-face-known = Add readings of these faces from others
add-the-laser = Add the laser
add-the-laser-to-camera-and-mounting = Take pictures in which the laser line crosses the board, and calibrate them with this calibration kept: by “Add the laser” on the Calibrate page, or on the command line with --camera-from
added-a-datasheet = added a datasheet
added-account = added an account
added-gauge-certificate = added the certificate of a gauge
address-none-message-can-sent = Messages cannot be sent to this address
adjusting-all-poses-together = Adjusting all poses together
after = After
after-advised-pose = { $then } after the suggested pose
after-few-more-touches = after a few more contact points
after-mark = after
after-three-points-three-faces = after three points on three faces
against-limits = Comparison with the limits
against-use-before-points-measuring-volume = Compared with { $name }, in use before: points of the measuring volume moved by { $rms } ({ $rms_mm }) rms, { $largest } ({ $largest_mm }) at most.
ages-calibrations-order-records-go-measuring = The ages of calibrations and the order of records depend on the clock; measurements do not.
all-corners-lie-one-level-z = all { $points } corners lie on one level, z = { $z }
all-corners-lie-one-plane-normal = all { $points } corners lie in one plane with normal ({ $normal })
all-corners-were-given-same-pixel = all corners have the same pixel
all-datasheets-can-read = All datasheets and certificates are readable.
all-kept-can-read = All stored records are readable.
all-pictures-one-sensor-must-have = All pictures of a sensor must have the same size.
all-points-there-go-add =
    { $more ->
        [yes] All points are taken. Continue, or add more as suggested below.
       *[no] All points are taken. Continue, or add more.
    }
all-points-there-go-pictures = All points are taken. Continue to the pictures.
all-poses-turn-flange-about-one = all { $count } poses rotate the flange about one axis, ({ $x } { $y } { $z }) in the flange frame
all-there-calibrate = All that it needs is there.
all-there-they-were-recorded = All recordings are present and unchanged.
and-more-records = And { $count } more.
angle = Angle, ″
angle-between-clouds = Angle between clouds
angle-beyond-a-turn = { $value } stands among them, more than a full turn in radians: these are degrees
angle-touched-plane = Angle to the touched plane
angles-are-in-other-unit =
    { $unit ->
        [deg] these are radians where degrees are expected
       *[rad] these are degrees where radians are expected
    }
angles-are-multiples = all are multiples of π/2, as { $value }: these are radians
angles-called =
    { $unit ->
        [rad] The angles are called radians
       *[deg] The angles are called degrees
    }
another-arm-answers = Another arm responds at { $url }: { $name } { $serial_number } ({ $joints } joints) instead of { $expected_name } { $expected_serial_number }
another-calibration-came-into-use-meanwhile = The calibration in use has changed in the meantime. Start again with the new one.
another-device-is-tried = Another device is being tried
another-programs-database = { $path } is the database of another program
another-station-publishes-under-ones-name = Another station publishes under the name of this station.
another-tip-mounted-another-sphere-touched = The tip measures { $diameter }, but the arm's datasheet states { $expected }: another tip is mounted, or another sphere was touched.
another-unit-arm-or-marker = they are in another unit, of another arm, or the joint angles belong to other poses
answered-who-asked-control = answered a request for control
answers-browsers = Response to browsers
applied-dropped-arms-delay = applied or removed the arm's delay
approved = Approved
aravis-missing = The library Aravis is missing, through which industrial cameras are read
archive = Archive
archive-away = The archive { $place } cannot be reached
archive-cannot-hold-name = The archive cannot hold a file with the name { $path }
archive-check-disk = Check the disk of the archive; the record is copied again
archive-check-id = See the records in the archive with crenel archive status
archive-check-keys = Check access_key, secret_file and the permissions of the archive; the station tries again by itself
archive-check-network = Check the network, the endpoint and whether the archive's server runs; the station tries again by itself
archive-check-url = Mount its disk, create the folder or the bucket, or correct url in [archive] of station.toml
archive-complete = Everything that is finished is in { $place }, read there and compared. Also on this disk: { $archived }. Only there: { $away }.
archive-copies-itself = records would be copied into themselves, and their only copies could be moved on one disk
archive-copy-differs = { $name } differs in the archive from what was written to it
archive-copying =
    { $waiting ->
        [one] { $waiting } record ({ $size }) is being copied to { $place }.
       *[other] { $waiting } records ({ $size }) are being copied to { $place }.
    }
archive-disk = Disk of the archive
archive-disk-why = A disk that fails takes everything that is on it.
archive-fetch-record = In the archive only. Bring it back with: crenel archive fetch { $kind } { $id }
archive-fetched = { $name } is back from the archive.
archive-fetching = Bringing { $name } back from the archive
archive-forbidden = The archive { $place } refuses access
archive-full = The archive { $place } is full
archive-give-both-keys = Give both access_key and secret_file, or neither
archive-goes-on-later = The copy to the archive continues after the next start
archive-has-no-record = The archive { $place } has no whole record { $id }
archive-install-library = Install it, for example with: pip install '{ $library }'
archive-is-here = { $id } is on this disk already
archive-key-alone = { $file }, [archive]: access_key or secret_file is given without the other
archive-keys-belong-together = a key and its secret belong together
archive-lacks-file = the file is missing there
archive-library-missing = The library for the archive { $place } is missing
archive-look-at-log = Look at the log below, or send a support bundle.
archive-loses-data = the archive does not hold what is written to it
archive-make-room = Make room there, or name another archive; the station tries again by itself
archive-manifest-damaged = { $name } in the archive is damaged
archive-missing = The archive { $place } is not there
archive-name-other-disk = Name a folder on another disk, or a store of another machine, as url in [archive] of station.toml.
archive-name-place-apart = Name a folder outside of it, best on another disk, as url in [archive] of station.toml; if there are archived records already, copy that folder there first, with crenel-archive.txt
archive-name-secret-file = Name a file that contains only the secret key
archive-needs-space = The record needs { $size }
archive-no-marker = it lacks crenel-archive.txt, which this station wrote there
archive-not-set = station.toml names no archive
archive-of-another = The archive { $place } is that of another station: it has none of this station's records
archive-of-station = The archive { $place } is that of the station { $station }
archive-on-own-disk = The archive { $place } is not on the disk of the data folder.
archive-on-same-disk = The archive { $place } is on the same disk as the data folder: it protects from deleted files only.
archive-overlaps-data = The archive { $place } and the data folder { $folder } overlap
archive-own-place = Name a place of its own for this station as url in [archive] of station.toml; if this station continues that archive with a new data folder, remove crenel-archive.txt there
archive-path-leads-out = { $path } leads out of the record's folder
archive-record-changes = { $path } changes while it is copied
archive-tried-again = It is copied when it no longer changes
archive-trouble =
    { $waiting ->
        [0] { $trouble } Nothing is waiting; the next attempt is in { $minutes }.
        [one] { $trouble } { $waiting } record is waiting; the next attempt is in { $minutes }.
       *[other] { $trouble } { $waiting } records are waiting; the next attempt is in { $minutes }.
    }
archive-used-by-another = Another process is using the archive
archive-wait-for-other = Wait until it is done; a running station copies by itself
archive-why = What is not in the archive exists on this station's disk only.
archive-write-table = Add [archive] to station.toml as docs/formats.md shows
arm-says = The arm: { $text }
arm-unchanged = The arm is unchanged.
arm = Arm
arm-and-frame-have-unknowns = the arm, its markers and frames have { $unknown } unknowns
arm-angles-converted-twice = { $field } reaches { $largest }: these are degrees that were converted once more, as if they were radians
arm-angles-in-radians = no { $field } exceeds { $largest }: these are radians, but degrees are expected
arm-announced-joints-sends-poses = The arm at { $url } announced joints, but sends poses
arm-at-stop = A joint of the arm is at its stop.
arm-before = The previous arm is in use again.
arm-before-arms-put-back-hand = the previous arm is in arms/{ $replaced }/{ $name }; restore it by hand
arm-by-its-datasheet = the arm is that of its datasheet
arm-check = Arm check
arm-check-within-sentence = arm check
arm-check-no-limit = { $half_range }, no limit is set.
arm-check-uncertainty-is-zero = Applied to (max − min)/2 of each axis with an uncertainty of zero, as the contribution of the form of seat and tip is not stated: the value is compared directly with its limit. The figures in space are stated without a limit.
arm-check-with-limit = { $half_range }, limit { $limit }.
arm-checked = Arm checked: { $worst }.
arm-chosen-cannot-read-any-more = The selected arm can no longer be read
arm-closed-while-opening = The arm at { $url } was closed while it was being opened
arm-counts-pulses-from-start-again = The arm at { $url } restarted while the camera counted its trigger pulses
arm-does-not-answer-pulse-request = The arm at { $url } has trigger pulses, but does not answer a request to start or stop them
arm-encoders = arm encoders
arm-geometry = arm geometry
arm-has-joint-number = the arm { $arm } has { $count }
arm-has-joints = the arm { $arm } has { $count } joints
arm-has-joints-station-toml-asks = The arm at { $url } ({ $name } { $serial_number }) has { $joints } joints, but station.toml states joint_count = { $joint_count }
arm-has-no-tip = the arm { $name } has no tip
arm-has-no-trigger-pulses = The arm at { $url } has no output for trigger pulses
arm-has-other-joints = The connected arm has { $joints } joints, this model has { $rows }: a calibration with it is refused. Give it a row for each joint, or enter the serial number of the arm that it describes.
arm-identified = The arm is identified.
arm-is-in-use = The arm is in use: { $title }
arm-is-where-scan-ended = The arm is where the scan ended
arm-joints-not-among-them = of the joints of arm.json, { $names } are not among them
arm-json-has-joints = the arm.json of { $arm } describes joints
arm-json-is-of-poses = the arm.json of { $arm } is of an arm that reports poses
arm-json-states-rotation = rotation in arm.json is { $name }
arm-json-tip-goes-far-while = according to this arm.json the tip moves too far while it is in a seat: { $far } from the centre of seat { $name }
arm-json-tip-goes-fro = { $label }: according to arm.json the tip moves over { $distance }
arm-measures-within = the reach of an arm is at most { $farthest }
arm-model-arm = the arm model belongs to arm { $serial_number }
arm-near-base = The arm is folded close to its base.
arm-not-open = The arm at { $url } is not open
arm-object-chosen-cannot-read-any = The selected arm or object can no longer be read.
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
arm-poses-other-setting = The poses of the arm at { $url } are in the setting { $setting } of tool and coordinate system instead of { $expected }
arm-reaches-no-place-for-block = { $arm } reaches no place on a table from which the block can be touched and the sensor held over it
arm-refuses-pulse-rate = The arm at { $url } cannot trigger at { $rate }
arm-reports-joints =
    The arm at { $url } reports { $joints ->
        [one] { $joints } joint
       *[other] { $joints } joints
    }
arm-reports-no-counts-per-revolution = The arm at { $url } reports 0 counts per revolution for joint { $joint }
arm-reports-poses-not-checked-here = The connected arm reports poses: its own software checks its joints and its tip.
arm-sees-bar-given = the arm measures bar { $bar } as { $measured }, but its stated length is { $given }
arm-sends-hello-but-no-samples = The arm at { $url } sends its hello ({ $name }) but no samples
arm-sends-no-joint-angles = the arm sends no joint angles
arm-sends-no-valid-poses = The last { $count } poses of the arm at { $url } contain a number that is not finite, or a quaternion that is not of length 1
arm-sends-other-joint-count = The arm at { $url } announced { $expected } joints, but sends { $count }
arm-sends-samples-but-no-hello = The arm at { $url } sends samples but no hello
arm-sent-too-little-arm-camera = the arm sent too few samples, or many at once with gaps between, or the clocks of arm and camera differ
arm-session-under-way-go-where-stands = A check or identification of the arm is in progress. Continue where it stopped.
arm-speaks-version-protocol-driver-speaks = The arm at { $url } uses version { $other_version } of the protocol; this driver supports versions 1 and 2
arm-stays-shows-nothing-errors = an arm that does not move reveals none of its errors
arm-not-held-still = the arm was not held still
arm-stretched-out = The arm is stretched out.
arm-temperature = Temperature of the arm
arm-tip = Arm and tip
arm-url-cannot-be-opened = The arm's url { $url } cannot be opened ({ $reason })
arm-use-already = This arm is already in use.
arm-used-since = since { $since } UTC
arm-used-since-by = since { $since } UTC, by { $who }
arm-with-joints-needed = an arm that reports its joint angles is required here
arm-without-tip-touches-nothing = { $name } has no tip and touches nothing. Go on without points.
arms-5-6-7-joints-served = Arms with 5, 6 or 7 joints are supported.
arms-adapter-running = Check that the arm's adapter is running.
arms-data-has-gap-there = the arm's data has a gap there
arms-motion-moves-other-way-than = according to the arm, { $name } moves in the opposite direction to the pictures
arms-motion-object-than-certificate-says =
    { $sign ->
        [larger] According to the arm's motion, the object is { $share } (± { $uncertainty }) larger than its certificate states: all lengths would be wrong by the same percentage.
       *[smaller] According to the arm's motion, the object is { $share } (± { $uncertainty }) smaller than its certificate states: all lengths would be wrong by the same percentage.
    }
arms-motion-squares-wide = according to the arm's motion, the squares of { $name } are { $width } wide
arms-motion-squares-wide-certificate = According to the arm's motion, the squares are { $width } wide (± { $uncertainty }); the certificate states { $nominal }. All lengths would be wrong by the same ratio.
arms-parameters = The arm's parameters
arms-parameters-already-explain-points-well = the arm's parameters already explain the points to within their measurement noise
arms-position-known-around-most-pictures = the arm's position is unknown for most of the pictures
arms-zero = Distance from the arm's origin
artefact-is-calibration-object = the artefact { $serial_number } is the object that the sensor was calibrated with
artefact-gives-way =
    { $test ->
        [sphere] the sphere rocks in measurement { $place }: its touches scatter by { $scatter }, steady ones by up to { $expected }
        [contact] the bar rocks in placement { $place }, or the diameter of its spheres is mistyped: touches of its spheres scatter by { $scatter }, steady ones by up to { $expected }
       *[lengths] the standard rocks in place { $place }: touches of its spheres scatter by { $scatter }, steady ones by up to { $expected }
    }
artefact-missing = the plan names no artefact
artefact-temperature = Temperature of the artefact
articulation-scanned-otherwise = Position { $position }, articulation { $number }: the camera looked from a direction { $off } away from the wanted one (at most { $most }).
articulation-touched-otherwise = Position { $position }, articulation { $number }: the stylus was held { $off } away from the wanted direction (at most { $most }).
articulations-nearly-same = the articulations { $first } and { $second } are nearly the same, { $apart } apart; at least { $least } are needed
articulations-not-scanned = only { $count } of the { $needed } articulations were scanned
articulations-too-alike = the sensor looked at the sphere from too similar sides
articulations-without-touches = touches are missing in the articulations { $names }
ask-administrator-for-access = Ask the system's administrator for access to { $device }, or pass the device on to the container.
ask-administrator-new-one = Ask an administrator for a new one
ask-control-take-over = Request control, or take it over
ask-somebody-with-role =
    { $role ->
        [admin] Ask an administrator
       *[operator] Ask an operator
    }
asked-control = requested control
asks-control = { $name } requests control from { $holder }.
at-beginning = At the beginning
at-end = At the end
at-least-limit = ≥ { $limit }
at-most-limit = ≤ { $limit }
at-position = position { $position }: { $text }
attention = Attention
authority-give-for-broker = Give the certificates of the broker's authority in PEM format
authority-give-for-provider = Give the certificates of the provider's authority in PEM format
authority-holds-none = it holds no certificates
autofocus-or-zoom-changed-it = autofocus or zoom changed it, and a calibration holds for one focal length
channel-less-laser-off = { $channel }, less the picture with the laser off
line-as-bright-as-clutter = no line: other things in its columns are as bright
line-as-bright-as-picture = no line: the picture is as bright
line-bright-in-the-dark = a line: it is bright in the dark
line-crosses-most-of-picture = a line: it crosses most of the picture
line-hardly-rivalled = a line: hardly anything else is in the picture
line-in-nearly-all-columns = a line: it is in nearly all columns
line-outshines-picture = a line: it outshines the picture
line-stands-alone = a line: it stands nearly alone
line-widths-do-not-ascend = the maximum width must exceed the minimum width
line-without-points = no line: no peaks go on from column to column
look-for-line-again = Look for the line again
looks-for-line-again = Looking for the line again
piece-left-beneath-line = left: goes on beneath the line
piece-left-dim-as-clutter = left: as dim as the clutter
piece-left-without-line = left: there is no line
piece-taken-brighter-than-clutter = taken: brighter than the clutter
piece-taken-line-goes-on = taken: the line goes on in it
piece-taken-most-light = taken: most of the light
set-what-line-is-like = set what the laser line is like
part-add-datum-or-lock = add a datum, or lock { $name }
part-alignment-leaves-free =
    the alignment leaves the part free to { $kind ->
        [turn] turn about
       *[shift] move along
    } { $axis }
part-alignment-without-covariance = The alignment states no covariance: nothing is decided.
part-arm-errors-unknown = Neither calibration.json nor arm.json states how well the arm's links are known: only scatter is stated, and nothing is decided.
part-best-fit-without-features = a best fit needs features
part-bodies-there = { $count ->
        [one] it has one body
       *[other] it has { $count } bodies
    }
part-box-corners-must-ascend = the second corner of a box must be beyond the first one along each axis
part-calibration-without-covariance = calibration.json has no covariance: only scatter is stated, and nothing is decided.
part-cells-with-coarse-facets = { $count ->
        [one] One cell is
       *[other] { $count } cells are
    } on facets up to { $worst } from the curved surface for which they stand; { $most } is permitted, a fifth of the tolerance. Nothing is decided there: export the part finer, or as STEP.
part-cloud-has-scatter-only = A cloud does not state what calibration and arm add to its uncertainty: only its scatter is known, and nothing is decided. Give the recording instead.
part-coordinate-without-axis = a coordinate needs an axis: x, y or z
part-correlation-unknown = calibration.json has no errors of links: those of the arm are taken as independent of the sensor's; their correlation is unknown.
part-datums-do-not-fix-it = the datums do not fix it
part-datums-without-primary = datums need a primary one
part-dimension-features =
    the dimension { $kind } is of { $count ->
        [one] one feature
       *[other] { $count } features
    }
part-dimension-of-one-feature-twice = the two features must differ
part-direction = ({ $x }, { $y }, { $z })
part-direction-without-length = a direction must not be zero
part-encoder-noise-unknown = The noise of encoders is unknown: arm.json states 0, and no calibration estimated it. Only scatter is stated, and nothing is decided.
part-export-without-mirroring = Export the part without mirroring it, or give that of the other hand
part-facets-are-coarse = The part's facets are up to { $worst } from the curved surface for which they stand
part-facets-finer = Export the part with finer facets, or as STEP
part-facets-permitted = a fifth of the tolerance, { $most }, is permitted
part-feature-has-points =
    feature { $feature }: { $count ->
        [0] no point
        [one] one point
       *[other] { $count } points
    } of the scan on it
part-feature-not-determined =
    feature { $feature }: { $count ->
        [one] one point does
       *[other] { $count } points do
    } not determine it
part-feature-seen-flat = Feature { $feature } was seen at more than 70° from its normal nearly everywhere; its points are taken all the same.
part-feature-unknown = { $place }: there is no feature { $feature }; the features are { $names }
part-features-by-scan = features are to be measured by scan
part-features-by-touch = features are to be measured by touch
part-fit-is-not-fixed = the scanned surface does not fix it
part-fit-leaves-free = The best fit leaves free: { $motions }
part-fits-mirror-image = The scan fits the mirror image of the part ({ $mirrored } on average), not the part ({ $residual })
part-fits-not = The scan does not fit the part: half of its points are farther than { $residual }, and { $share } are near it
part-fits-not-remedy = Check the part's unit, and that it is not mirrored; or give an alignment
part-fits-not-share = The scan does not fit the part: { $share } of its points are near it
part-fits-not-why = another part, a mirrored one, or another unit
part-folder-has = name a folder with { $program }, calibration.json, arm.json, scans and touches.csv
part-form-limit-below-noise = { $dimension }: a limit of { $limit } cannot be decided by this sensor, whose noise alone shows { $noise }.
part-free-shift = a shift along { $axis }
part-free-turn = a turn about { $axis } through { $place }
part-give-unit-of-it = State the unit of the part (--unit { $unit }), or give the scan of this part alone
part-has-bodies = The file has { $count } bodies, which are taken together; choose one with --body.
part-has-no-such-body = { $path } has no body { $body }
part-id-twice = { $place }: the id { $id } occurs twice
part-is-of-size = The part is { $size }, the scan { $scan } across
part-length-is-range = length_mm of a { $kind } is a range: [from, to] along its direction
part-lock-or-scan-more = Lock it ({ $names }) with --lock, or scan further faces
part-lower-above-upper = lower ({ $lower }) must not be above upper ({ $upper })
part-means-disagree = Feature { $feature }: stripe and tip differ by { $off } in diameter or width, with a standard uncertainty of { $u }.
part-measure-more-of-feature = measure more of it
part-no-folder = { $folder }: there is no such folder
part-no-scans = { $program }: there is no scan
part-no-such-size = { $place }: a { $feature } has no { $kind }
part-no-touches = { $program }: there are no touches
part-nominal-lacks = the nominal of a { $kind } lacks { $names }
part-not-found = the part was not found: what was measured lies { $off } off its nominal features
part-not-found-remedy = check program, touches and scan, or touch three datums
part-not-found-why = it is another part, or too little of it was measured
part-points-on-too-small-piece = they lie on too small a piece of it
part-position-needs-upper = a position needs an upper limit
part-put-scans = put recordings into { $folder }, or give --scan
part-put-touches = put them into { $file }, or give --touches
part-range-must-ascend = a range must ascend
part-reference-is-no-plane = { $place }: the reference must be a plane
part-robot-noise-unknown = How well a robot knows its poses is not stated: only scatter is stated, and nothing is decided.
part-scan-does-not-show-it = the scan does not show it where the program has it
part-scan-feature-or-check-alignment = scan it, or check its nominal and the alignment
part-second-pose-fits = A second pose fits about as well ({ $second } beside { $first }): the part is nearly symmetric. Give an alignment if the pose matters.
part-slot-direction-along-normal = direction and normal of a slot must differ
part-slot-length-is-one-number = length_mm of a slot is one number: its overall length
part-slot-shorter-than-wide = a slot must be longer than wide
part-spread-touches = spread the touches over the feature
part-temperature-not-compensated = Temperature is not compensated: lengths are those at the temperature of the part.
part-tertiary-without-secondary = a tertiary datum needs a secondary one
part-too-few-touches =
    { $file }: feature { $feature } has { $count ->
        [0] no touch
        [one] one touch
       *[other] { $count } touches
    } where { $least } are needed
part-touch-far-off = { $place }: the touch is { $away } off feature { $feature }; it is left out.
part-touch-it-more = touch it at { $least } places at least
part-touch-on-other = { $place }: the touch is { $away } off feature { $feature } and lies on { $other }; it is left out.
part-touch-on-wrong-side = { $place }: the touch is on the wrong side of feature { $feature }; it is left out.
part-touches-at-one-place = feature { $feature }: its { $count } touches are at one place
part-touches-extent = they lie within { $extent }
part-unit-of-other-kind = { $unit } is no unit of { $kind }
tilt-board-against-reflection-or-shorten-exposure = tilt the board so that it does not reflect the light into the camera, or shorten the exposure
away = it is only { $min } away
axes = Axes
axis-component = Axis { $axis }
axis-level = Axis tilt from horizontal
back = Back
back-face = Back face
back-places = Back to the places
back-points = Back to the points
background-work = Background work
background-work-remedy = Look at the log below, and send the support bundle. Restart the station if a part goes on failing.
background-work-runs =
    { $count ->
        [one] One part runs.
       *[other] All { $count } parts run.
    }
background-work-why = It keeps what browsers show current, and watches devices, scans and the disk.
backup = Backup
backup-is-in = The backup is in { $folder }.
backup-being-made-already = A backup is already being made
backup-needs = The backup needs { $total }
backup-replaces-nothing = a backup does not overwrite anything
bad = Bad
ball-bars = Ball bars
ball-bars-lengths = Lengths of the ball bars
ball-diameter = Ø { $diameter }
bar-end-of-position = bar { $name } { $position } end { $end }
bar-has-two-ends = a bar has two ends
bar-named = bar { $name }
bar-not-placed = the bar was measured in { $count } of { $needed } placements
bar-position-arm-json-ends-lie = bar { $name }, position { $position }: according to arm.json its ends are { $measured } apart, but its stated length is { $length }
bar-position-has-ends = { $path }: bar { $bar }, position { $position } has the ends { $ends }
bar-without-sphere-diameter = the file of the ball bar states no diameter of its spheres: enter sphere_diameter_mm
bars-end = end { $value } of the bar
bars-length-hardly-known = bar { $bar }: its length is stated to ± { $uncertainty } (k = 1), which hardly determines the arm's scale: check that standard_uncertainty_mm is in mm
bars-lengths-coordinates-scatter-without-them = with the bars' lengths the coordinates scatter by { $scatter }, without them by { $without }
bars-lengths-points-scatter-without-them = with the bars' lengths the points scatter by { $scatter }, without them by { $without }
batch-calibration-unusable = The calibration { $id } cannot be used
batch-choose-of-same-arm = Choose calibrations of all sensors that were made with the same arm.json
batch-choose-quantity = Choose one of { $names }
batch-different-arms = The calibrations of the sensors have different arm.json files
batch-first-arm-for-all = The calibrations of the sensors have different arm.json files; that of { $sensor } is used for all
batch-give-address = Give it as tcp://host:8786
batch-give-period = Give a day, a month or a year, or two with .. between, as 2026-05-13, 2026-05 or 2026-05-01..2026-06-15
batch-install-dask = Install it with: pip install 'crenel[fleet]'
batch-name-a-place = Name the archive or the data folder of a station, or what several archives are in
batch-name-another-output = Name a folder of its own with -o
batch-name-calibration = Name the place that has it, too, or give another one with --calibration
batch-no-address = { $address } is no address of a scheduler
batch-no-calibration = The calibration { $id } is in none of the places
batch-no-certificates = TLS needs certificates in the settings of Dask
batch-no-dask = Work over many recordings needs Dask
batch-no-marker = it lacks { $name }
batch-no-period = { $period } is no period
batch-no-place = { $place } is no archive and no data folder, and has no archive in it
batch-no-quantity = { $quantity } is no figure of a verification that can be measured again
batch-no-recording = The recording of the scan { $id } is neither in the archive nor in the data folder of its station
batch-no-scheduler = The scheduler { $address } does not answer
batch-none-named = No archive and no data folder is named, and there is no station.toml here
batch-other-device = The calibration { $id } is of another arm or sensor than the scan { $scan }
batch-other-version = The workers have Crenel { $there }, and this is Crenel { $here }
batch-output-in-source = { $place } is within the records that are read
batch-run-again-nothing-done-twice = Start the scheduler and the same command again: what is done is not done again
batch-same-sensor = { $id } and { $other } are calibrations of the same sensor
batch-scheduler-away = The scheduler { $address } is lost; the work goes on when it is there again.
batch-scheduler-back = The scheduler is there again.
batch-start-scheduler = Start it with: dask scheduler
batch-store-away = { $why }; meanwhile the work waits
batch-store-back = The store is there again.
batch-waited = it was waited for during { $time }
batch-worker-failed = A worker failed with { $error }
bayer-needs-wavelength = { $bayer } requires { $wavelength }, whose colour's pixels are measured
before = Before
before-after = Before and after
before-after-identification = Before and after the identification
before-mark = before
before-poses-were-changed-since = Out of date: the poses have changed.
began-again = started again
began-backup = started a backup
began-cloud = started a cloud
began-demonstration = Began the demonstration
began-resumed-arm-check = started or resumed an arm check
began-resumed-calibration = started or resumed a calibration
began-resumed-performance-test = started or resumed a performance test
began-resumed-verification = started or resumed a verification
began-seat = started a place
begin-again = Start again
begin-new-one = Start a new one
begun = Started
behind = from behind
being-recorded = it is being recorded
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
belongs-another-step-session-stands =
    { $step ->
        [seat] This belongs to another step; the session is at 'Seat the tip'.
        [swing] This belongs to another step; the session is at 'Swing the arm'.
       *[result] This belongs to another step; the session is at 'Result'.
    }
belongs-another-step-verification-stands =
    { $step ->
        [gauge] This belongs to another step; the verification is at 'Choose the gauge'.
        [touch] This belongs to another step; the verification is at 'Touch the gauge'.
        [scan] This belongs to another step; the verification is at 'Scan the gauge'.
       *[review] This belongs to another step; the verification is at 'Result'.
    }
beyond-limit = Beyond the limit
bits-expected = 8 or 16 bits are expected
bits-per-pixel = { $bits } bits per pixel
block-as-drawn = as drawn, made to ± { $value }
block-certificate = Certificate of the block
block-certified-by-readings =
    { $count ->
        [one] Coordinates by one reading; the largest standard uncertainty is { $largest } (k = 1).
       *[other] Coordinates by least squares from { $count } readings; the largest standard uncertainty is { $largest } (k = 1).
    }
block-certified-by-touches = Coordinates by least squares from { $touches } touches and { $readings } readings; the largest standard uncertainty is { $largest } (k = 1).
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
block-dimension =
    { $name ->
        [base] height of the floors above the base
        [depth] depth from front to back
        [height] height of the crests above the floors
       *[width] width from left to right
    }
block-dimensions-undetermined = Neither pictures nor contact points tell the block's { $names }: the tolerance counts there.
block-edges-estimated = Only the drawing of the block is known: its edges were estimated with the calibration. They lie up to { $beside } beside the drawing, with a standard uncertainty of { $known }, which is the same in all poses.
block-known-by-drawing = The block is known by its drawing only. Measured, it is known better.
block-measured-to = measured to { $value } (k = 1)
block-needs-depth = Crests and floors of a block must both be sharp.
block-wider-than-view = a block of { $width } is wider than { $most }, which the picture shows as a whole with room for the hand
board-bar = This bar is { $length } long; if it is not, the printer has scaled the page: print at 100 %.
board-bends-over-pattern-allowed = The board is bent by { $bend } over the pattern; the calibration allows for it.
board-bends-over-pattern-flat-expected = The board is bent by { $bend } over the pattern; its certificate states a flatness of { $flatness }.
board-fewer-or-smaller-squares = Choose fewer or smaller squares.
board-fewer-squares-or-lower-first-id = Take fewer squares, or a lower id of the first marker.
board-has-4-to-60-squares = a board has 4 to 60 squares in each direction, and at most 1000 markers
board-has-corners = { $name } has { $columns } × { $rows }
board-has-corners-why = { $name } has { $columns } × { $rows }, and { $why }
board-larger-page-or-fewer-squares = Choose a larger page, or fewer or smaller squares.
board-has-ids = { $name } has the ids { $first } to { $last }
board-has-squares = { $name } has { $columns } × { $rows } squares
board-is-otherwise = { $name } is arranged the other way by legacy_pattern
board-does-not-fit-a0 = a pattern of { $width } × { $height } does not fit on A0
board-does-not-fit-page = a pattern of { $width } × { $height } with its bar and margins does not fit on { $page }
board-measure-whole-pattern = Measure the whole pattern, from the first to the last square, and print at 100 %.
board-measures-otherwise = { $measured } was measured where { $expected } was to be printed
board-needs-ids-beyond = its markers need the ids { $first } to { $last }, and { $dictionary } ends at { $most }
board-nominal-size = The pattern is { $width } wide and { $height } high. Measure both on the print: the two lengths scale the board.
board-partly-out-of-picture = the board is partly out of the picture
board-print-and-glue = Print on { $page } at 100 %, on matt paper, and glue it on a flat plate.
board-printed-side = Board (printed side)
board-seen-at-a-slant = the board is seen at a slant of about { $slant }: its squares appear { $times } times as wide as high
board-states-dictionary = { $name } states { $dictionary }
board-tilted-most-between-pictures = the tilt of the board varies by at most { $tilt } between the { $seen } pictures
both-devices-answer-go = Both devices respond. Continue.
bridge-must-send-finite-unit-quaternions = Its bridge must send unit quaternions, and nothing while the pose is unknown.
brightness = Brightness
bring-back-last-backup-delete-under = Restore it from the last backup, or delete it under Records.
bring-block-closer-so-fills-picture = Bring the block closer so that it fills the picture.
bring-block-middle-stripe = Bring the block to the middle of the stripe.
bring-board-with-markers-into-picture = bring the board with its markers into the picture, larger, sharp and evenly lit
bring-camera-nearer-to-board = bring the camera nearer to the board, or use a board with larger squares
bring-front-back-edge-level-into = bring the front and back edges of a level into the picture
bring-joint-reference-switch-arm-off = move the joint to its reference position and switch the arm off and on; if the error persists, choose the datasheet of this arm
move-joint-to-reference-within-sentence = move the joint to its reference position and switch the arm off and on
bring-more-object-into-picture = bring more of the object into the picture
bring-more-object-into-picture-sharp = bring more of the object into the picture, sharp and well lit
bring-more-of-board-into-picture = bring more of the board into the picture, sharp and evenly lit
bring-part-into-sensors-range = bring a part into the sensor's range
bring-part-into-sensors-range-if = Bring the part into the sensor's range; if it is there, check the exposure.
bring-whole-board-into-picture = bring the whole board into the picture
bring-whole-board-into-picture-sharp = bring the whole board into the picture, sharp, evenly lit and tilted by at most 60°
bring-whole-object-into-view-front = bring the whole object into view, from its front and above, and light it evenly
broker = Broker
brought-a-datasheet-back = brought a datasheet back
but-what-marked-below-needs-attention = However, the items marked below need attention.
pictures-by-themselves-only-for-robot-and-board = pictures are taken by themselves only of a board, with a robot without a tip
byte-is-not-utf-8 = byte { $byte } is not UTF-8 text
bytes-but-no-packet =
    { $count ->
        [one] { $count } byte arrived from { $url }, but no packet of an encoder arm
       *[other] { $count } bytes arrived from { $url }, but no packet of an encoder arm
    }
calibrate = Calibrate
calibrate-again = Calibrate again
calibrate-camera-and-laser-together = Calibrate camera, mounting and laser together from these pictures
calibrate-camera-mounting-and-laser = Calibrate camera, mounting and laser
calibrate-first = Calibrate first
calibrate-first-within-sentence = calibrate first
calibrate-sensor-arm-pictures-of-board = Calibrate the sensor on the arm: take pictures of a chessboard from different sides.
calibrate-sensor-arm-touch-object-then = Calibrate the sensor on the arm: touch the object, then take a few pictures.
calibrate-sensors-again-their-place-belongs = Calibrate the sensors again: their mounting was determined with the previous arm.
calibrate-this-sensor = Calibrate this sensor
calibrate-without-the-laser = Calibrate without the laser
calibrated = Calibrated
calibrated-distance-camera = Calibrated distance from the camera
calibrating = Calibrating
calibration = Calibration
calibration-acceptance-test-no-characteristic-iso = This is a calibration, not an acceptance test: no characteristic of ISO 10360-8 or ISO 10360-12 is claimed. A verification on gauges tests the scanner.
calibration-not-accepted-at-station = This calibration was not accepted at a station.
calibration-age-and-temperature = { $text }, { $ago } old; due after { $limit }, or after a temperature change of { $change } (now { $now }).
calibration-arm = the calibration belongs to arm { $known }
calibration-cannot-read = The calibration { $name } is unreadable.
calibration-cannot-shown = the calibration { $session_id } cannot be displayed
calibration-closed-start-new-one = This calibration is closed. Start a new one.
calibration-computed = The calibration is computed.
calibration-due = The calibration is due. { $text }
calibration-has-no-covariance = { $file } does not state how well camera and mounting are known
calibration-has-no-laser-plane = this calibration has camera and mounting, but no laser plane yet
calibration-has-no-picture = This calibration has no picture { $name }.
calibration-has-other-version = The calibration in use, { $name }, was made with another version of this datasheet, which it keeps: calibrate again to use this one.
calibration-no-longer-here = The calibration of { $name } no longer exists here
calibration-in-use-unreadable = The calibration in use cannot be read: { $error }
calibration-is-for-joints = the calibration is for an arm with { $joints } joints
calibration-is-for-pixels = the calibration is for { $width } × { $height } pixels
calibration-is-for-poses = the calibration is for an arm that reports poses
calibration-is-for-serial-number = the calibration is for { $serial_number }
calibration-known-here = its calibration is unknown on this station
calibration-not-kept-any-more = the calibration in use is no longer one of camera and mounting alone for these devices
calibration-pose = the calibration pose
calibration-report = Calibration report
calibration-not-to-be-used-findings-say-what = Do not use this calibration. The findings state what to do.
calibration-under-way-go-where-stands = A calibration is in progress. Continue where it stopped.
calibration-use = The calibration is in use
calibration-use-cannot-read = The calibration in use cannot be read
calibration-utc = Calibration { $now } UTC
calibration-valid-verified-scan-part = The calibration is valid and verified. Scan the part.
calibration-not-verified-yet = This calibration is not verified yet.
calibration-with-total = { $name }, { $total } (k = 1)
calibrations-unknowns-did-settle-what-seen = the calibration did not converge on the pictures and contact points
camera = The camera { $source }
camera-address-not-known = There is no device with the address or name { $address }
camera-and-laser-apart-on-a-board-only = camera and laser are calibrated apart on a chessboard only
camera-and-mounting = camera and mounting
camera-and-mounting-are-kept = Camera and mounting are kept from the calibration before; only the laser plane is new.
camera-and-mounting-are-stored = Camera and mounting are in use, and stored under Records. To scan, add the laser: take pictures in which its line crosses the board.
camera-answers-but-does-not-open = { $title } answers, but cannot be opened ({ $reason })
camera-cannot-do = { $title } does not support { $key } = { $value }; it offers { $given }
camera-clock-jumped = { $title } states another time than a moment ago: it was restarted, or its clock was set
camera-control-lost = { $title } no longer obeys this program
camera-looks-along-laser-plane-deg = the camera looks along the laser plane, at an angle of { $angle } (limit { $limit })
camera-must-look-stripe-side-check = the camera must view the stripe from the side: check the geometry of the sensor
camera-needs-two-levels-four-sides = the camera requires two levels and four sides of the merlons
camera-refused-settings = { $title } refused a setting ({ $reason })
camera-sends-colour-not-raw = the picture is in colour, but station.toml says that it is raw (bayer)
camera-sends-several-profiles = { $title } puts { $count } profiles into one buffer, and each needs a time of its own
camera-used-by-other-program = { $title } is in use by another program
cameras-are = Available cameras: { $names }.
cameras-matrix-needs-least-six-crests = the camera matrix requires at least six, on crests and floors
camera-parameters-do-not-converge = the camera's parameters did not converge on the edges in the picture
cameras-pixels-come-out-out-square = The camera's pixels deviate from square by { $difference }; present-day sensors have square pixels (limit { $limit }).
can-read-more-than-one-way = it can be interpreted in more than one way
can-written = The data folder is writable.
cancel-calibration = Cancel the calibration
cancel-session = Cancel the session
cancel-test = Cancel the test
cancel-verification = Cancel the verification
cannot-be-copied = { $path } cannot be copied
cannot-be-opened-for-writing = { $path } cannot be opened for writing
cannot-deleted-now = It cannot be deleted now
cannot-hidden-now = It cannot be hidden now
cannot-read = The calibration cannot be read: { $text }
password-file-cannot-be-read = { $password_file } cannot be read
cannot-shown = { $name } cannot be displayed: { $error }
cannot-be-displayed = { $name } cannot be displayed.
cannot-start = { $title } cannot start
cannot-written = The data folder is not writable: { CLAUSE($trouble) }.
capital = { CAPITAL($text) }
capture = Capture
catalogue-away = The catalogue { $place } cannot be used now
catalogue-check-folder = Check that its folder is there and can be written; nothing is lost, and collecting continues by itself
catalogue-check-user = Check the user, password_file and the name of the database in [catalogue], and whether the database was created; nothing is lost, and collecting continues by itself
catalogue-give-address = Give sqlite:///catalogue.db or postgresql://user:password@host/name
catalogue-in-memory = it names no file, and what is kept in memory is lost
catalogue-let-user-own = Let the user own the database or its schema; nothing is lost, and collecting continues by itself
catalogue-newer = The catalogue { $place } was made by a later version of Crenel
catalogue-no-address = { $url } is no address of a catalogue
catalogue-tried-again = Check its server and its disk; nothing is lost, and collecting continues by itself
centre = Centre { $axis }
centre-m = Centre, µm
centre-radius-cannot-be-separated = centre and radius cannot be separated
centres-of-articulations-or-none =
    { $title }: { $count ->
        [one] the centre of { $count } articulation
       *[other] the centres of { $count } articulations
    } from above (x, y) and from the side (x, z), { $factor } times larger. The circle is the smallest sphere about them, { $diameter } in diameter: the location error. { $others ->
        [yes] Open dots: centres with the calibrated diameter.
       *[no] { "" }
    }
certificate = Certificate
certificate-named = certificate { $certificate }
certificate-date-unreadable = { $until } is no date; the certificate’s validity is stated as 2027-03-31
certificate-days-reversed = by the clock of the station, the test began on { $begun } and ended on { $ended }; the certificate needs both days in order
certificate-has-lengths = the certificate states: { $names }
certificate-has-no-length = the certificate states no length
certificate-issued-later = The certificate is said to be issued on { $day }, which is still to come: correct the date.
certificate-must-be-known-to = a certificate is known to { $most }
certificate-needs-country = the certificate needs the laboratory's country as two capital letters, not { $country }
certificate-needs-date = the certificate needs the day of the test, and { $text } is none
certificate-needs-laboratory = the certificate needs the name of the laboratory
certificate-needs-one =
    { $path }: { $what ->
        [form] one form
        [length] a length
       *[diameter] one diameter
    } is needed, { $count ->
        [0] none was found
       *[other] { $count } were found
    }
certificate-not-signed = this certificate is not signed
certificate-not-validated = this certificate is not signed. It is written after the schema of DCC 3.3.0, but was not validated against it: check it before you issue it
certificate-out-of-date = the certificate of the artefact was valid until { $until }
certificate-says = its certificate states { $square }
certificate-set-aside = { $file }: { CLAUSE($why) }.
certificate-not-trusted-here = its certificate is not trusted
certificate-valid-until = { $name }, valid until { $date }
certificate-without-uncertainty = the certificate of the artefact states no uncertainty
certificate-without-values = No figure could be stated.
certified-size-impossible = { $name } is { $size }, known to { $known } (k = 1): this is no size of an artefact
certified-size-without-uncertainty = { $name } has no uncertainty with its coverage factor
certified-values = By certificate
certify-the-block = Certify the block
change = Change
change-one-them = change one of the limits
change-permissions-place = Change its permissions, or choose another location
change-place = Choose another location
change-them-in-file = change their tables [sensor.NAME] in { $file }, and start the station again
change-theta-of-joint = Change theta_deg of joint { $joint } in arm.json by { $turn } (with sign −1, by as much the other way)
changed-account = changed an account
changed-after-session-had-written = { $name } was changed after this session wrote it
changed-logo = changed the logo of reports
changed-notifications = changed the notifications
changed-own-password = changed their own password
changed-settings = changed the settings
channel-beyond-others = { $colour } beyond the other channels
channel-grey = grey
channel-mean-of-all = mean of all channels
channel-of-colour =
    { $colour ->
        [red] red
        [green] green
       *[blue] blue
    }
channel-raw = { $colour } pixels of { $pattern }
channel-share = { $share } { $colour }
charuco-squares-mm-markers = ChArUco board, { $columns } × { $rows } squares of { $square }, { $dictionary }
check-address-and-port = Check the address and the port in station.toml.
check-address-below-try = Check its address below and test it.
check-address-network = Check its address and its network.
check-address-network-and-power = Check its address, its network, and that it is switched on.
check-again = Check again
check-ago-failed = The check { $ago } ago failed: { $text }
check-arm = Check the arm
check-arm-again = Check the arm again
check-arm-json-against-arm-signs = Check arm.json against the arm (signs, units, lengths, order of the joints) and the points of that place
check-arm-play-tip-sensor-loose = Check the arm for play, and tip and sensor for a loose mount; hold still.
check-arm-power-and-no-second-program = Check the arm's power supply, and that no other program starts its pulses.
check-arm-software-and-network = check the arm’s software and the connection to it
check-arm-tip-object-sensor-those = Check that the arm with its tip, the object and the sensor selected here are those in use.
check-arm-url = Check the arm's url.
check-arms-cable-then-switch-arm = check the arm's cable, then switch the arm off and on
check-arms-file-lengths-angles-signs = Check the arm's file: its lengths and angles, the signs and order of its joints, and the tip; then check which face each contact point was taken on, and the object's certificate
check-baud-rate-arm-port-another = Check the baud rate, and that the device on this port is the arm.
check-board-how-exact-certificate-takes = Check that this is the board, and the uncertainty that its certificate states.
broker-gives-no-answer = something answers there, but not as a broker without encryption does ({ $reason })
broker-speaks-no-tls = what answers there does not encrypt ({ $reason })
check-broker-certificate = Set ca_file of [mqtt] to the certificate of the broker's authority, and host to the name in the broker's certificate. The station retries automatically.
check-broker-runs = Check that the broker runs, and host and port of [mqtt]. The station retries automatically.
check-broker-tls-off = Set port of [mqtt] to the encrypted port of the broker (often 8883), or remove tls and ca_file. The station retries automatically.
check-broker-tls-on = Set tls = true in [mqtt], if the broker encrypts at this port, and check the port. The station retries automatically.
check-broker-user-and-password = Check user and password_file of [mqtt]. The station retries automatically.
check-cable-no-other-program-uses = Check its cable, and that no other program uses it.
check-cable-power = Check its cable and its power.
check-cable-power-looked-again-itself = Check its cable and its power. It reconnects automatically.
check-camera-power-cable-network = Check the power and the cable of the camera, and that its address is in the network of this computer
check-cannot-made = The check { $name } could not run: { CLAUSE($reason) }.
check-chosen-gauge-tip-arms-own = Check that this is the selected gauge, and that the mounted tip is the arm's own.
check-connection = Check its connection.
check-devices = Check the devices
check-diameter = { $finding }: check its diameter
check-diameter-mm-spheres-take-sphere = Check diameter_mm of the spheres; measure this sphere again or delete its rows
check-each-laser-picture-own-pose-laser-not-moved = Check that each laser picture belongs to its pose and was taken without moving the sensor, and that the laser is mounted firmly; then check its focus.
check-each-laser-picture-own-pose-no-reflection = check that each laser picture belongs to its pose, that the laser did not move relative to the camera, and that the line in the picture is that of the laser and not a reflection
check-encoder-swing-arm-so-every = Check the encoder; swing the arm so that every joint rotates
check-encoders-arm-json-how-points = Check the encoders, arm.json, and how the points were taken
check-failed = Failed check
check-firewall-for-pictures = Let the camera's UDP packets through the firewall of this computer; check packet_size and the cable
check-first-page-arm-tip-takes = Check it first on the page Arm & tip; it takes a minute.
check-folders-owner-whether-disk-mounted = Check the folder's owner and whether its disk is mounted.
check-frame-and-tool-of-arm = check whether the base frame or the tool was changed in the arm’s software; if it was, set it back
check-joints-encoder-cable-then-bring = check the joint's encoder and cable, then move the arm to its reference position
check-laser-board-camera-not-moved = Check that laser, board and camera did not move, and that picture and pose were recorded at the same moment.
check-laser-exposure-sensors-stripe-axis = check the laser, the exposure and the sensor's stripe_axis, and let the stripe cross the middle of the object
check-laser-exposure-then-take-new = Check the laser and the exposure, then take a new picture.
check-laser-line-crossed-object-exposure = Check that the laser was on and its line crossed the object, and check the exposure; capture the pose again.
check-laser-not-moved-and-no-reflection = check that the laser did not move relative to the camera, and that the line in the picture is that of the laser and not a reflection
check-laser-picture-pose-sensor-held = Check that its laser picture belongs to this pose, that the sensor was held still between its two pictures, and that the laser is mounted firmly; capture the pose again.
check-lasers-interlock-key-switch-capture = check the laser's interlock and key switch, and capture again
check-length-mm-bar-ends = Check length_mm of bar { $bar }, and its ends
check-length-of-bar-and-coordinates = Check the length of bar { $bar }, its ends, and the scale of the coordinates
check-length-unless-datasheet-is-as-far-off = { $finding }: check its length, unless the arm's datasheet is wrong by as much
check-not-moved-every-picture-has-readings =
    { $thing ->
        [board] check that the board did not move, and that every picture has the arm's readings of its own pose
       *[object] check that the object did not move, and that every picture has the arm's readings of its own pose
    }
check-names-of-faces-and-axes = Check the names of the faces and the directions of the machine's axes
check-network-load-or-power = The network was interrupted, or the camera restarted: check its cable and its power
check-object-certificate-lengths-mm = Check that this object belongs to the certificate, and that its lengths are in mm.
check-object-picture-take-picture-again = check that this is the object in the picture, and take the picture again
check-object-pictures-every-picture-belongs = check that this is the object in the pictures, and that every picture belongs to its arm pose
check-objects-certificate-cameras-flip-setting = check the object's certificate and the camera's flip setting
check-objects-certificate-which-sides-front = Check the object's certificate, and which of its sides is the front
check-one-seat = This is a check in one seat.
check-options-or-restart-camera = Check the options in station.toml, or switch the camera off and on
check-order-and-signs-of-coordinates = Check the order and the signs of x_mm, y_mm and z_mm: the frame must be right-handed
check-owner-and-permissions = Check its owner and permissions, and whether its disk is mounted read-only
check-packet-size-and-network = Set packet_size to a value that the network passes, such as 1400; lower rate_hz; connect the camera directly
check-path = Check the path
check-picture-joint-angles-one-moment = Check that picture and joint angles were recorded at the same moment, or capture the pose again.
check-pictures-joint-angles-own = Check that the joint angles belong to the picture.
check-pictures-joint-angles-those-their = Check that the joint angles of the pictures belong to their poses.
check-pictures-not-mirrored-poses-of-flange = check that the pictures are not mirrored, and that the poses are those of the flange in the arm frame, in mm, with qw last and not inverted
check-recorded-limit-set-before-next = This check is recorded with its limit. Set the limit before the next check.
check-robot-interface = Check the address, and that the interface is enabled on the robot's controller.
check-robot-network = Check that the robot's controller is on, its address, the network cable and firewalls.
check-robot-on-and-not-too-many-clients = Check that the controller is on, and that not too many other programs are connected to it.
check-sensor = Check the sensor.
check-sensor-address = Correct address or serial_number in the table [sensor] of station.toml
check-sensor-numbers = Check the field of view, the stand-off and the depth of field of the sensor.
check-sensor-path = Check [sensor] path.
check-sensor-source = Check [sensor] source.
check-sensors-cable-close-other-programs = Check the sensor's cable, or close other programs.
check-session-taken-arm = check that the session was recorded with this arm
check-signs-lengths-joints-order = Check signs, lengths and the order of the joints in arm.json
check-square-tip-and-board-not-moved = check square_mm and the tip in arm.json, and that the board did not move
check-station-disk = Check the station's disk
check-system-log-and-disk = Check the system log and the disk; leave the data folder as it is
check-tip = Check the tip
check-tip-again = Check the tip again
check-mounted-tip-and-nothing-moved = Check the mounted tip against the arm's file, and that nothing moved; then identify the arm again.
check-tip-one-arms-file-block = Check that the tip matches the arm's file and that block and arm were fixed firmly; then check the arm's model.
check-tip-one-arms-file-board = Check that the tip matches the arm's file and that board and arm were fixed firmly.
check-tip-play-faces-dirt-have = Check the tip for play and the faces for dirt; then check the arm's model.
check-tips-diameter-block-then-arms = Check the tip's diameter and that this is the block; then check the arm's model.
check-unit-arm-and-rows = Check the unit, the frame and the joint angles of the rows, and whether it is this arm
check-what-robot-sends = Check what the controller of the arm is set to send.
check-which-arm-plugged = Check which arm is connected.
check-which-face-each-contact-taken = Check which face each contact point was taken on, the tip, and the object's certificate
check-mounted-tip-and-object-not-moved = Check which tip is mounted, its diameter and its length, and that the object did not move after it was touched.
check-which-tip-mounted-diameter-object = Check which tip is mounted, its diameter, and that this is the object.
check-which-tip-mounted-stylus-straight = Check which tip is mounted, and that its stylus is straight and tight; determine its position again, and touch the object again.
checked = Checked
checked-ago = Checked { $ago } ago: { $text }
checked-ago-after-check-due = Checked { $ago } ago; due after { $limit }.
checking-places-held-out = Cross-validating the places
checksum-wrong-at-byte = { $name }: the checksum at byte { $byte } is wrong
chessboard-inner-corners-squares-mm = chessboard, { $columns } × { $rows } inner corners, squares of { $square }
chessboard-seen-several-sides-take-more = A chessboard must be seen from several sides: take { $more } more pictures.
chessboard-seen-several-sides-take-one = A chessboard must be seen from several sides: take one more picture.
chessboard-x-inner-corners-found = a chessboard of { $columns } × { $rows } inner corners was found
choice-needs-field-id = A choice needs a field and an id.
choose-datasheet-or-certificate = Choose a datasheet as it is downloaded here, or the certificate of a sphere; or fill in a form
choose-another = Choose another
choose-another-end = Choose another end, or give the URDF of one arm
choose-another-name = Choose another name
choose-another-picture = Choose another picture, or save it smaller
choose-another-place = Choose another location
choose-another-port = Choose another port here and on the robot's controller.
choose-arm-first = Choose the arm first.
choose-arm-first-within-sentence = choose the arm first
choose-bayer-or-grey-pictures = Choose the Bayer pattern and the colour of the laser among the options, or let the camera send grey pictures
choose-chessboard-for-poses = { $name } reports poses: choose a chessboard as the object.
choose-datasheet-connect-other = Choose the datasheet of this { $name }, or connect the other { $name }.
choose-first = Choose first: { $things }.
choose-folder-elsewhere-best-another-disk = Choose a folder outside it, preferably on another disk
choose-gauge = Choose the gauge
choose-gauge-first = Choose the gauge first.
choose-gauge-scanned = Choose the gauge that was scanned
choose-object-before-camera-if-one = choose the object that is in front of the camera; if it is this one, check that its edges are clean and undamaged
choose-of-several = { $count } to choose from
choose-pulse-rate = Choose a rate from { $low } to { $high }.
choose-one-under-devices = Choose one on the Devices page
choose-other-scans = Choose other scans
choose-shorter-one = Choose a shorter one
choose-what-use = Choose the equipment
chose-a-device = chose a device
chose-arm = selected the arm
chose-artefact = selected the artefact
chose-face = selected a face
chose-gauge = selected the gauge
chose-what-use = selected the equipment
chosen-gauge-has = the selected gauge has { $diameter }
chosen-picture = The chosen picture
clamp-bar-firmly-reach-put-tip = Clamp the bar firmly within reach ({ $where }), and put the tip into one end.
clamp-cone-ball-seat-about-two = Clamp the cone or ball seat firmly at about two thirds of the reach, and put the tip into it.
clamp-firmly-reach = Clamp it firmly within reach ({ $where }).
clamp-firmly-within-arms-reach-sphere = Clamp it firmly within the arm's reach. A sphere reveals more; a plane is quicker.
clamp-seat-firmly-reach-put-tip = Clamp the seat firmly within reach ({ $where }), and put the tip into it.
clamp-seat-take-place-again-delete = Clamp the seat and measure this place again, or delete its rows
clamp-sphere = Clamp the sphere
clean-blocks-edges-check-focus-lighting = Clean the block's edges; check focus, lighting and certificate.
clean-both-check-again = Clean both, and check again.
clean-gauge-tip-check-clamps-verify = Clean gauge and tip, check the clamps, and verify again; then calibrate again.
clean-tip-clamp-sphere = Clean the tip, and clamp the sphere
clean-tip-seat-check-clamps-repeat = Clean tip and seat, check the clamps, and repeat. If the error persists, identify the arm.
clear-them-draw-them-again = Clear them and draw them again.
clock = Clock
clock-jumps-times-first-start-points =
    { $stream ->
        [joints]
            the clock of the arm readings jumps { $jumps ->
                [one] once, { $first } from the start
               *[other] { $jumps } times, first { $first } from the start
            }; points near a jump may be displaced
       *[frames]
            the clock of the frames jumps { $jumps ->
                [one] once, { $first } from the start
               *[other] { $jumps } times, first { $first } from the start
            }; points near a jump may be displaced
    }
clock-set-since-start-last =
    { $count ->
        [one] The clock was set once since the start, by { $last_jump }.
       *[other] The clock was set { $count } times since the start, last by { $last_jump }.
    }
close-other-program-or-wait = Close the other program; after a crash, the camera is free again within a few seconds
close-other-programs-restart-station-between = Close other programs, or restart the station between two scans.
close-program-second-station-same-port = Close that program, or the other station that uses this port.
close-program-with-port = Close the other program, or the second station with the same port.
close-what-else-uses-machine = Close other programs on this machine.
cloud-arrays-there = its arrays are { $names }
cloud-bytes-do-not-match-points = { $bytes } bytes are announced for { $points } points
cloud-cannot-be-expanded = its compressed data cannot be expanded
cloud-check-shape-and-unit = Give the cloud of the gauge alone, its shape, and its unit (--unit)
cloud-choose-another-location = Free some space, or choose another location
cloud-columns-are-fixed-give-none = the format fixes which columns are x, y and z: do not give --columns
cloud-rows-without-column-names = a row is { $cells }, and no line names the columns
cloud-columns-of-several-units = its columns { $names } have different units
cloud-columns-there = its columns are { $names }
cloud-contains-points-of = { $path } contains { $found } of { $announced } points
cloud-convert-to-one-unit = Export all three in one unit
cloud-correct-line = Correct this line, or export the cloud as PLY
cloud-covers-little = { $file }: the points cover { $share } of the sphere, so that its radius is known to ± { $uncertainty } (k = 2). Scan more of the sphere
cloud-data-of-unknown-kind = its data is { $kind }, which is not one of ascii, binary, binary_compressed
cloud-decimal-commas = its numbers have decimal commas
cloud-disk-accepts-no-more = the disk accepts no more data ({ $reason })
cloud-disk-took-points = the disk took { $found } of { $count } points
cloud-element-repeats-property = element { $name } has two properties with the same name
cloud-exact = { $used } of { $points } points lie on one { $shape ->
        [plane] plane
       *[sphere] sphere
    } exactly, as no measured points do, and the others off it
cloud-exact-remedy = Leave out points that were not measured, and check the columns (--columns)
cloud-export-again = Export the cloud again
cloud-export-binary-pcd = Export it as binary PCD or as PLY
cloud-export-cartesian = Export Cartesian coordinates
cloud-export-decimal-points = Export it with decimal points, or replace each comma by a point
cloud-fetch-from-lfs = Fetch the file itself with: git lfs pull
cloud-file-empty = it is empty
cloud-first-column-counts-without-names = its first column numbers the points, and no line names the columns
cloud-format-package-missing = { $format } files require the package { $package }, which is not installed
cloud-format-unknown = it is not a cloud of a known format
cloud-give-columns = Name the columns of the coordinates x, y and z, or give their names or numbers, as in --columns 2,3,4
cloud-give-known-format = Give a .ply, .pcd, .e57, .las, .laz, .xyz, .ptx, .obj, .stl, .off or .npy cloud
cloud-header-announces-more = its header announces more than the file contains
cloud-header-contains = its header contains { $line }
cloud-header-does-not-end = its header does not end
cloud-header-is-invalid = its header is invalid ({ $reason })
cloud-in-other-coordinates = { $file } lies { $distance } from the nominal: it is in other coordinates, and errors of its place are not stated
cloud-install-package = Install it with: { $command }; or use PLY, PCD or XYZ
cloud-is-a-line = { $file }: most of its points lie in a strip of { $length } × { $width }: they hardly determine a plane. Scan more of the plate
cloud-is-lfs-pointer = it only stands for a file that Git LFS keeps elsewhere
cloud-is-packed = it is packed ({ $format })
cloud-is-recording-not-cloud = it is a recording (MCAP), not a cloud
cloud-las-counts-up-to = LAS counts in steps of 0.1 µm, up to { $limit }
cloud-left-out-deleted = { $file }: { $points } points are marked as deleted and are left out
cloud-left-out-missing = { $file }: { $points } points were not measured and are left out: they are at 0, 0, 0 or at another place that stands for none
cloud-left-out-repeated = { $file }: { $points } points repeat others exactly and are left out
cloud-line-of-numbers-expected = a line of x y z numbers is expected, but { $reason }
cloud-list-below-zero = a list in row { $row } has a length below zero
cloud-no-element-vertex = its header names no element vertex
cloud-no-ply-format = its header names no valid PLY format
cloud-no-such-column = { $path } has no column { $name }
cloud-not-cartesian = its points are not Cartesian
cloud-not-complete-format = it is not a complete { $format } file ({ $reason })
cloud-of-another-shape = { $file }: the points lie { $rms } (rms) about the { $shape ->
        [plane] plane
       *[sphere] sphere
    }: they are hardly of one. Give the cloud of the gauge alone
cloud-of-another-unit = { $file } has the nominal radius if its unit is { $unit }. Give --unit { $unit }
cloud-of-format = it is a file of another kind ({ $format })
cloud-of-odd-size = { $file } is { $size } large if its unit is { $unit }. State the unit with --unit m, mm or inch
cloud-ptx-head = the ten lines before the points of a PTX are expected, but one is { $line }
cloud-reconstruct-first = Make its cloud with crenel reconstruct
cloud-row-is-not-complete = a row is not complete ({ $line })
cloud-save-one-array = Save the coordinates as one array of shape (N, 3), or as arrays x, y and z
cloud-too-large-for-a-gauge = the { $shape ->
        [plane] plane
       *[sphere] sphere
    } through the points is { $size } large
cloud-points-none-measured = none of its { $points } points was measured: they are marked as deleted, or have the coordinates 0, 0, 0 or others that stand for none
cloud = Cloud
cloud-being-scanned-already = A cloud is already being scanned.
cloud-cloud = { $title }, cloud by cloud.
cloud-not-in-data-folder = The cloud of { $name } is not in the data folder
cloud-formats = clouds are written as { $suffixes }
cloud-has-no-points = it contains no points
cloud-has-points = The cloud has { $points } points
cloud-has-points-of = { $path } contains { $count } of { $announced } points
cloud-holds-usable-points =
    { $points ->
        [one] the cloud contains { $points } usable point
       *[other] the cloud contains { $points } usable points
    }
cloud-name-proposal = Name it { $name }
cloud-no-points-lie-rms-off =
    { $shape ->
        [sphere] The cloud is not a sphere (its points deviate by { $rms } rms)
       *[plane] The cloud is not a plane (its points deviate by { $rms } rms)
    }
cloud-no-use = Cloud { $number } cannot be used.
cloud-not-as-scan-wrote-it = { $path } is not in the form that a scan writes
cloud-pcd-rounds-beyond = PCD's floats round to more than 1 µm beyond { $limit }
cloud-points-not-of-plane = { $left_out } of the points of cloud { $number } do not belong to the plane.
cloud-point-lies-at = { $path }: a point lies at { $axis } = ±{ $distance }
cloud-point-lies-away = { $path }: a point lies at { $distance }
cloud-points-have-no = its points have no { $axes }
cloud-rms-about-gauge = Cloud { $number }: { $rms } rms about the gauge.
cloud-scan-number = { $path }: scan { $number }
cloud-shows-cap-sphere = The cloud covers a cap of { $angle } of the sphere
cloud-strip-wide = The cloud is a strip only { $width } wide
cloud-unpack-first = Unpack it first
cloud-write-ply = Write PLY
cloud-write-ply-or-e57 = Write PLY or E57
cloud-xyz-written-up-to = XYZ is written up to { $limit }
clouds = { $done } of { $clouds_wanted } clouds
clouds-heading = Clouds
clouds-do-not-overlap = Only { $count } of { $total } compared points lie on the other scan
clouds-enough = { $clouds_most } clouds are sufficient.
clouds-rebuilt-every-calibration = The clouds have been rebuilt with every calibration.
clouds-taken-enough = { $done } clouds are sufficient
code-wrong = The code is wrong.
coefficient = Coefficient
column-cell-is = { $place }: column { $column } is { $value }
column-empty = { $place }: column { $column } is empty
column-is = { $place }: { $column } is { $value }
column-stands-there-twice = { $path }: column { $names } appears twice
columns-not-read = Columns that are not read: { $names }
columns-not-separated-by-commas = its columns are not separated by commas
come-nearer-object-fills-wanted = Move closer: the object fills { $fills }, at least { $least } required
comes-after-calibration = Calibrate before verifying.
comes-last = It comes when the rest is there.
compare-blocks-depth-heights-certificate = Compare the block's depth and heights with its certificate.
compare-no-arms = Merge scans of one arm
compare-scans-of-one-place = Compare scans of the same part at the same place
comparing-scans = Comparing { $name } with { $reference }
comparison-needs-points = The scan to compare with has { $count } points; { $needed } are needed
complete-delete-row = Complete or delete the row
complete-or-delete-rows-of-position = Complete or delete the rows of this position
compute-calibration-take-another-pose = { $taken } Compute the calibration, or capture another pose.
computed-from = Computed from the touches and scans
computer-cannot-keep-up = The computer cannot keep up: its queue is { $share } full
confirmed-devices = confirmed the devices
confirmed-gauge = confirmed the gauge
confirmed-object-picture = confirmed that the object is in the picture
confirmed-touches = confirmed the contact points
confirmed-what-use = confirmed the equipment
connect-arm-calibrate-one = connect that arm, or calibrate with this one
connect-calibrate-one =
    { $device ->
        [arm] connect that arm, or calibrate with this one
       *[sensor] connect that sensor, or calibrate with this one
    }
connect-the-arm = Connect the arm
connect-the-sensor = Connect the sensor
connected = Connected to { $host }.
no-connection-for = No connection to { $host } for { $duration }: { CLAUSE($reason) }.
device-connected = The { $title } is connected
connected-arm-has-joints = the connected arm has { $joints } joints
connected-arm-has-joints-has-choose = The connected arm has { $connected_joints } joints, but { $name } has { $joint_count }. Choose the arm that is connected.
connected-arm-reports-joints-choose = The connected arm reports joint angles, but { $name } reports poses. Choose the arm that is connected.
connected-arm-reports-poses = the connected arm reports poses
connected-arm-reports-poses-choose = The connected arm reports poses, but { $name } has joints. Choose the arm that is connected.
connected-has-serial-number =
    { $device ->
        [arm] the connected arm has the serial number { $serial_number }
       *[sensor] the connected sensor has the serial number { $serial_number }
    }
connected-has-serial-number-chosen-datasheet = The connected { $name } has the serial number { $serial_number }, but the selected datasheet is for { $serial_number2 }.
connected-sensor = Connected sensor
connected-sensors-picture-has-pixels-choose = The connected sensor's picture has { $width_px } × { $height_px } pixels, but { $name } has { $size } × { $size2 }. Choose the sensor that is connected.
not-connected-yet = not connected yet
connecting = Connecting to the { $title }
contact-labelled-but-misses-face = contact point { $number } is labelled { $face }, but misses that face by { $distance }
contact-limit = two points of the object are at most { $limit } apart
contact-off-by = { $number } ({ $face }, { $off })
contact-points = contact points
contact-too-far = This point lies { $apart } from point { $number }, which is farther than the object reaches; it was not taken
contact-unknown-face = contact point { $number } is on an unknown face '{ $face }'
contacts = the contact points
contacts-agree-blocks-size-tips-diameter = The contact points agree with the block's size and the tip's diameter: { $checked }.
contacts-arm-has-no-tip = there are { $readings } contact points, but the arm { $name } has no tip
contacts-disagree-others-were-left-out =
    { $left_out ->
        [one] { $left_out } of { $count } contact points contradicts the others and was excluded: { $named }.
       *[other] { $left_out } of { $count } contact points contradict the others and were excluded: { $named }.
    }
contacts-do-not-determine-object = { $count } contact points do not determine the object's position
contacts-face-lie-one-line = the { $count } contact points { $where } lie on one line
contacts-fit-block-rms = { $count } contact points fit the block to { $rms } rms.
contacts-fit-block-rms-only-all = the contact points fit the block only to { $rms } rms, and { $beside } of { $count } do not fit at all
contacts-fit-block-rms-up-good = { $count } contact points fit the block to { $rms } rms; up to { $good } is good.
contacts-lie-beside-crests-floors-were = { $off_face } of { $contacts } contact points miss the crests or floors that were touched
contacts-lie-beside-face-they-labelled = { $beside } of { $count } contact points miss the face they are labelled with ({ $faces })
contacts-lie-board-rms = { $count } contact points fit the board to { $rms } rms.
contacts-lie-board-rms-up-good = { $count } contact points fit the board to { $rms } rms; up to { $good } is good.
contacts-lie-off-board-pictures-show = the { $touches } contact points lie { $usual } off the board seen in the pictures
contacts-lie-than-blocks-size-tips =
    { $sign ->
        [apart]
            The contact points on { $pair ->
                [left] left and right
               *[front] front and back
            } lie { $opening } further apart than the block's size and the tip's diameter give (limit { $limit }).
       *[together]
            The contact points on { $pair ->
                [left] left and right
               *[front] front and back
            } lie { $opening } closer together than the block's size and the tip's diameter give (limit { $limit }).
    }
contacts-pictures-agree-better-tip-than = Contact points and pictures agree better with a tip diameter of { $fitted } (± { $known }) than with { $given }.
contacts-pictures-agree-better-tips-centre = Contact points and pictures agree better with the tip's centre { $off } from its position in the arm's file: by { $x }, { $y }, { $z } (± { $known }) in the flange frame. Scanned points may be wrong by as much.
contacts-rms =
    Contact points, rms of { $count ->
        [one] { $count } point
       *[other] { $count } points
    }
contacts-rms-outliers = Contact points, rms of { $count } points, { $outliers } excluded
contacts-scatter-times-what-arms-encoders = The contact points scatter by { $sigma }, { $arm_excess } times what the arm's encoders explain (limit { $excess }).
contacts-stripe-several-levels-need-crenellated = contact points and stripes on several levels require a crenellated object
contacts-tips-sphere = contact points are taken with the sphere of a tip
contacts-were-given-positions = { $count } contact points were given with positions of shape { $shape }
continue = Continue
continued-has-other-calibration = it was taken with the calibration { $own }, and { $used } is in use
continued-scan = continued a scan, or ended that
continued-scan-no-longer-there = The scan that was continued is no longer there
convention-is-pose = { $path }: convention is 'pose'
convert-columns-degrees = Convert the columns to degrees
convert-columns-x-mm-y-mm = Convert the columns x_mm, y_mm and z_mm to millimetres
convert-lengths-mm-name-columns = Convert lengths to mm, and name the columns { $names }
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
convert-them-name-columns = Convert them, and name the columns { $first } to { $last }
coordinate = Coordinate
coordinate-left-out-off = coordinates.csv line { $number } ({ $place }): { $distance } off
coordinates = Coordinates
coordinates-about-mean-of-faces = The uncertainties are about the mean of the faces of each axis, so that the distance of two faces has the root of the sum of their squares.
coordinates-fit-otherwise = { $reason }, they would typically lie { $off } from where arm.json has them
coordinates-give-figures = coordinates.csv: { $poses } poses give { $figures } values
coordinates-held-out = Measured coordinates, cross-validated
coordinates-identify-only = coordinates are only used to identify the arm
coordinates-measured = Measured coordinates
coordinates-spread = coordinates.csv: the points of frame { $name } typically lie { $measured } from their middle, but { $expected } according to arm.json
copy-differs-from-source = The copy differs from what was read from { $path }
copy-whole-service-receives = Copy the complete address from the receiving service
corner = corner { $column },{ $row }
corners-can-measured = { $found } of { $corners } corners of { $name } can be measured
corners-fix-camera-badly-condition-number = the { $points } corners determine the camera poorly (condition number { $condition }, limit { $limit })
corners-fix-camera-weakly-condition-number = The corners determine the camera weakly: condition number { $condition } (good below { $good }, refused above { $limit }).
corners-lie-off-regular-pattern-certificate = The corners deviate from a regular pattern by { $off }, while the certificate states { $standard_uncertainty }; the calibration allows for it.
corners-object-found = { $corners_detected } corners of the object are detected.
corners-px = Corners, px
corners-rms = Corners, rms
corners-were-found = { $found } of { $corners } corners of { $name } were found
corners-were-found-picture = { $points } corners were found in the picture
corners-mistaken-or-not-of-object = the corners were mistaken for others, or do not belong to this object
corners-would-lie-behind-camera = { $behind } of { $points } corners would lie behind the camera
correct-cell-delete-row = Correct the cell or delete the row
correct-it = Correct it
correct-marker-size = measure a marker and a square, and correct marker_mm or square_mm in the certificate
correct-name = Correct the name
correct-option = Correct { $key }.
correct-place-or-name-marker-differently = Correct the place, or give the marker another name
correct-reading-or-leave-out = Correct the reading, or leave it out
correct-remove-file = Correct or remove the file.
correct-remove-files-named = Correct or remove the files that are named.
correct-sensor-exposure-us-take-out = Correct [sensor] exposure_us, or remove it.
correct-sensor-take-out = Correct [sensor] { $key }, or remove it.
correct-the-file-first = Correct the file first, then choose the device again
correct-tips-diameter-arm-json-what = Correct the tip's diameter in arm.json, or the values in the tables
correct-value-or-give-arm-json = Correct the value, or give the right arm.json
correct-value-or-name-artefact-differently = Correct the value, or give the other artefact another name
correlated-known-together = Correlated: well determined together, less well each alone
not-computed-data-kept = The calibration could not be computed. All captured data is kept.
could-true-last-ago = Implausible readings: { $count }, the last { $ago } ago: { CLAUSE($what) }.
count-inner-corners = If { $columns } × { $rows } is the number of squares, give that of the corners between them, one less each way; otherwise give the certificate of the board in the picture, or uncover the rest of this one
cover-one-board = cover one of them, or take it out of the picture
create-choose-another-place = Create it, or choose another location
crenel = Crenel { $version }
crest-z-mm-must-above-floor = { $crest } must be above { $floor }, and { $floor } above { $base }
crests-top = Crests
cut-points-away = cut points away in the view
damaged = The database is damaged: { $trouble }.
dark-brightest-pixel = it is dark: its brightest pixel is at { $brightest } of { $full } grey levels
data-folder = Data folder
no-longer-in-data-folder = { $name } is no longer in the data folder.
data-folder-cannot-be-used = The data folder { $folder } cannot be used
data-folder-in-use = The data folder { $folder } is in use by another Crenel server (process { $process })
data-lost-now = Much of the data from the { $title } is being lost or comes late.
data-speak-errors-arms-links-each = The data indicate errors of { $links } and { $turns } in each of the arm's links; what remains of them contributes { $share } to the uncertainty of a point.
database = Database
database-cannot-be-written = the database cannot be written: { $error }
database-is-empty = { $database } is empty
database-is-not-there = { $database } does not exist
database-not-damaged = the station's database cannot be opened there; it is not damaged
database-of-later-version = { $path } was written by a later version of Crenel (schema { $version }; this version supports up to { $known })
datasheet-changed-meanwhile = { $file } has been changed or retired meanwhile; nothing was saved
datasheet-lets-turn = its datasheet allows { $low } to { $high }
datasheet-not-there = There is no datasheet { $file } any more
datasheet-of-name-exists = { $name } already has a datasheet: { $files }
datasheet-of-number-exists = { $name } with the serial number { $serial_number } already has a datasheet: { $files }
datasheet-says-raw = { $path } says that the sensor's pictures are raw (bayer)
datasheet-twice = { $files } describes the same thing: retire one of them, or correct its serial number or name.
datasheets = Datasheets
datasheets-set-aside-everything = Files in arms, objects, sensors and gauges that cannot be read are set aside unchanged; everything else is available.
date = Date
dcc-version-needed = Certificates of version 3 are read
dcc-version-unknown = the certificate has version { $version }
decimal-commas-read = Commas were read as decimal signs.
decimal-signs-mixed = Some numbers have a decimal comma ({ $one }), others a decimal point ({ $other })
decision = Decision
decision-rule-guard =
    Guard band: { $factor } times the standard uncertainty. { $bearer ->
        [supplier] The supplier bears the uncertainty: a value closer to its limit than the guard band fails.
        [user] The user bears the uncertainty: a value closer to its limit than the guard band passes.
       *[prover] Whoever has to prove something bears the uncertainty: a value closer to its limit than the guard band is undecided.
    }
decision-rule-limits-set-standard-uncertainty = Decision rule: the limits apply to the standard uncertainty itself, which is compared with them directly, without a guard band.
decision-rule-named =
    Decision rule: { $name ->
        [guarded-95] acceptance with a guard band for 95 %
        [expanded-k2] acceptance with the expanded uncertainty (k = 2) as guard band
        [simple] simple acceptance
       *[other] { $name }
    }, { $standard }:{ $edition }.
decision-rule-without-guard = There is no guard band: values are compared directly with their limits, the uncertainty is stated only, and both parties bear its risk.
degrees-converted-twice = No joint turns so far: if degrees were taken for radians and converted, give them as they were; else correct the value
delay-drifts = The delay drifts by { $drift } (k = 1: { $u }), { $change } within the pass: the clocks of arm and camera run at different rates.
delay-drifts-its-pass-is-away = the delay drifts by { $drift }, and the pass that determined it is { $away } away
delay-jumped = The delay changed by { $change } (k = 1: { $u }) at { $at } after the first picture (k = 1: { $at_u }): a clock was set.
delay-varies = The delay varies within the pass, as where the arm's packets arrive late by different times: { $u } (k = 1) of its uncertainty comes from this.
delay-varies-known = the delay varies by { $varies } (k = 1) within the pass, as where the arm's packets arrive late by different times, or several at once: { $known }; the limit is { $limit }
delay-pictures-in-gaps = { $gaps } of { $pictures } pictures lie in gaps between the arm's samples: its packets arrive late by different times, several at once, or not at all
delay-would-not-be-determined = the delay would not be determined at all
delay-would-known-k-1 = the standard uncertainty of the delay would be { $u } (k = 1)
delete-columns-of-one = Delete the columns of one of them
delete-one-rows = Delete one of the rows
delete-scans-under-records-use-larger = Delete scans under Records, or use a larger disk.
delete-what-stands-there-twice = Delete the duplicates
deleted = { $name } was deleted
deleted-scan = deleted a scan
demonstration = The demonstration
demonstration-accepts = The simulated operator accepts this calibration. A person would look at the numbers first.
demonstration-calibrates = The simulated operator calibrates the sensor: contact points, then pictures.
demonstration-not-calibrated = The demonstration has ended without a calibration.
demonstration-scans = The simulated operator scans the parts on the table.
demonstration-scans-soon = The simulated operator starts a scan. The laser switches on.
demonstration-stopped = The demonstration was stopped. Everything so far is kept: go on by hand.
denavit-hartenberg-parameters-do-same = the Denavit-Hartenberg parameters have the same effect
depth-mm = depth, mm
depth-of-field-too-small = the depth of field is { $depth }, and must be { $least } at least for this field of view
described-a-camera = described a camera
described-an-arm = described an arm
design-compares-blocks = Comparing blocks
design-edge-break = edges broken by at most
design-give-pixels-and-standoff = Give them as options, or a sensor.json that has them.
design-groove-depth = depth of the grooves
design-grooves = grooves, from the left
design-height = height
design-length = length of the grooves
design-merlons = merlons, from the left
design-mirror = off its mirror image by
design-needs-pixels-and-standoff = the picture's size (64 × 64 pixels or more) and the stand-off of the sensor are needed
design-not-kept = The design is not kept any more
design-plans-poses = Planning poses and contact points
design-predicts-accuracy = Predicting the accuracy
design-tolerance = tolerance, if used as drawn
design-width = width
determine-delay-again-pass-close = Determine the delay again, from a pass shortly before or after the scan
deviations-distances-one = deviations are distances from a shape
deviations-of-places = Deviations of the 25 places
device-cannot-be-opened = { $title } cannot be opened
device-cannot-be-played = { $title } cannot be played
device-closed = { $title } is closed
device-closed-while-opening = { $title } was closed while it was being opened
device-failed = { $title } failed: { $error }
device-lost = { $title } was disconnected
device-not-open = { $title } is not open
device-without-pictures = { $title } is a device that sends no pictures
device-not-permitted = { $name } is connected, but this user may not open { $device }
device-was-chosen = The station uses another { $title }
devices = Devices
devices-cannot-be-changed-now = Devices cannot be changed now
devices-of-replay-are-fixed = A replay has the devices of its recording
dh-cell = Line { $line }: { $column } { $value }
dh-column-missing = No column for { $names }
dh-column-twice = Two columns for { $names }
dh-commas-between-cells = Commas stand between the cells here: write numbers with a decimal point
dh-needs-four-numbers = each row needs a, alpha, d and theta, and may begin with the name of the joint
dh-number-expected = a number, a multiple of π or a joint angle such as q1 + 90 is expected
dh-row-has-cells =
    { $count ->
        [one] Line { $line } has one cell
       *[other] Line { $line } has { $count } cells
    }
dh-rows-missing = The row of joint { $names } is missing
dh-rows-out-of-order = The rows are of joints { $names }, in this order
dh-rows-there = there are rows of { $names }
dh-table-has-columns = the table has { $count } columns
dh-variable-not-an-angle = the joint slides: its variable is a length
diameter = Diameter
diameter-of-tip-by-datasheet = Tip diameter from the datasheet
diameter-tip-found = Measured tip diameter
diameter-up-to-or-unknown = a diameter in mm up to { $most } is expected, 0 for points that the machine has compensated, or unknown
dictionary-unknown = { $field } is one of { $names }
did-you-mean = Did you mean { $name }?
direction-points-into-block = { $place }: the direction i, j, k points into the block at { $face }
directions-point-out-of-surface = directions point out of the surface; the touch belongs to another face or the signs are exchanged
disk = Disk
disk-fails = The disk of { $folder } does not read or write reliably
disk-fails-takes-every-calibration-scan = If the disk fails, every calibration and scan on it is lost.
disk-full = the disk is full
disk-full-during-scan = The disk became full during this scan.
disk-of-backup-loses-data = the disk of the backup does not store what is written to it
disk-of-data-folder-full = The disk of the data folder { $folder } is full
disk-of-folder-full = The disk of { $folder } is full
disk-quota-used-up = the disk quota is used up
disk-read-only = the disk is read-only
disks-largest-file-size-reached = the largest file size of the disk is reached
dispersion-free-centre = 95 %, free centre
distance = Distance
distance-between-clouds = Distance between clouds
distance-between-clouds-centres = Distance between the centres of the clouds
distance-each-touch-face-times-larger = Distance of each contact point from its face, magnified { $factor } times: blue inside, orange outside, crosses excluded. The longest line is { $largest } ({ $largest_mm }).
distance-each-touch-sphere-through-all = Distance of each contact point from the sphere fitted to those that agree.
distance-fitted-shape-blue-inside-orange-outside = { $name }: distance from its fitted shape, blue inside, orange outside.
distance-out-of-range =
    { $side ->
        [near] Too near: { $distance }, { $low } to { $high } required
       *[far] Too far: { $distance }, { $low } to { $high } required
    }
distance-touched-centre = Distance from the touched centre
distance-touched-plane = Distance from the touched plane
distortion = Distortion
distortion-not-invertible = the distortion is not invertible over the whole picture
document-format = { $path }: format is { $format }
document-states-no-format = { $path }: it states no format
document-version = { $path }: version is { $version }
does-not-take-exposure = { $title } does not accept an exposure of { $exposure }
method-not-accepted = { $path } does not accept { $method }.
notifications-not-accepted = { $host } does not accept notifications: { $trouble } ({ $failed } not delivered).
done = Done
draw-over-part-cloud = draw it over a part of the cloud
draw-pictures-of-each-folder-apart = Draw the pictures of each folder apart
drawing-edges = Edges sharp: free of burrs, broken by { $largest } at most.
drawing-flat = Faces flat, and parallel or square to each other, within { $within }.
drawing-front-view = Front
drawing-material = Aluminium or steel, stress-relieved; all sizes at 20 °C, in mm.
drawing-scale = Scale { $scale } (A4)
drawing-side-view = Side
drawing-surface-without-gloss = All faces bright, even and matt (for example bead-blasted), without glossy tool marks.
drawing-tolerance = Sizes ± { $tolerance } if the block is used as drawn; ± { $loose } is enough if a laboratory then measures every size.
drifting-delay-ended-with-restart = The delay between arm and camera drifts, and ended with the restart. Determine it again under Settings.
driver-cannot-be-loaded = The { $table } driver { $name } of { $package } cannot be loaded: { $kind }: { $error }
driver-not-callable = The { $table } driver { $name } of { $package } is not callable: { $value }
driver-offered = Several packages provide the { $table } driver { $name }: { $packages }
driver-selects-raw-pixels = on a station, the driver selects the pixels of the laser's colour
driver-takes = Available options: { $names }.
driver-abb-egm = Robot of ABB (EGM)
driver-bridge = Encoder arm or bridge, on a serial port or the network
driver-fanuc = Robot of FANUC
driver-folder = Folder of pictures
driver-genicam = Industrial camera (GigE Vision, USB3 Vision)
driver-gentl = Camera with its maker's GenTL producer
driver-kuka-rsi = Robot of KUKA (RSI)
driver-microscribe = MicroScribe arm
driver-opencv = USB camera, network stream or video
driver-pylon = Basler camera (pylon)
driver-ros2 = ROS 2 topic
driver-ur-rtde = Robot of Universal Robots (RTDE)
option-address = Address
option-base = Base frame
option-baudrate = Baud rate
option-bayer = Bayer pattern of raw pictures
option-child-frame = Frame of the flange
option-choice-arrival = arrival of the message
option-choice-blue = blue
option-choice-exposure-end = end of the exposure
option-choice-exposure-start = start of the exposure
option-choice-falling = falling
option-choice-flange = pose of the flange
option-choice-frame-end = end of the transfer
option-choice-green = green
option-choice-header = head of the message
option-choice-joints = angles of the joints
option-choice-mid-exposure = middle of the exposure
option-choice-other-axis = a track or a turntable (it must stand still)
option-choice-pose = pose
option-choice-red = red
option-choice-region = first row of the region
option-choice-rising = rising
option-choice-sensor = first row of the sensor
option-choice-tf = transforms (tf)
option-choice-third-axis = the third joint of seven
option-chunks = Chunk data
option-counts-per-revolution = Counts per revolution
option-domain-id = Domain id
option-exposure = Exposure
option-exposure-range = Range of the exposure
option-external-axis = External axis
option-gain = Gain (dB)
option-height = Height
option-help-base = In the arm's frame: position in mm, then orientation as the controller shows it
option-help-chunks = Sent with each picture: ExposureTime, Timestamp
option-help-exposure-range = Shortest and longest that the operator may set
option-help-external-axis = Only for joints: what the axis is that the robot sends beside its six
option-help-joint-names = As in the messages, from the base, with commas
option-help-laser-line = Pictures then come in pairs, with and without the laser
option-help-latency = Least delay, which is taken off each time stamp
option-help-line-offset = 0.5 for a camera that counts from the edge of the first row
option-help-line-rate = Empty: as the camera is set
option-help-line-rows = Of a camera that finds the laser line itself; its manual says it
option-help-line-sigma = Of one row, by the camera's manual; empty: measured
option-help-packet-size = In bytes; 8192 with jumbo frames
option-help-region = x, y, width, height in pixels
option-help-setting = Number of tool and coordinate system that the bridge sends; poses with another number are refused
option-help-stamp-at = The camera's manual says it
option-help-tool = In the flange frame: position in mm, then orientation as the controller shows it
option-help-trigger = Input at whose edge a picture is taken; empty: runs by itself
option-help-url = /dev/ttyUSB0, or socket://192.168.1.20:7431 in the network
option-joint-count = Number of joints
option-joint-names = Names of the joints
option-kind = Kind of messages
option-laser-colour = Colour of the laser
option-laser-line = Output that switches the laser
option-latency = Latency
option-line-offset = Lines: added to rows
option-line-rate = Lines: rate
option-line-rows = Lines: rows count from
option-line-sigma = Lines: standard deviation
option-loop = Start again at the end
option-packet-size = Packet size
option-parent-frame = Frame of the base
option-path = Folder
option-pixel-format = Pixel format
option-port = Port
option-producer = GenTL producer (.cti file)
option-rate = Rate
option-region = Region of the picture
option-report = What is read
option-serial = Serial number
option-setting = Setting of the poses
option-source = Camera number, device, address or file
option-stamp-at = Event that is stamped
option-stamps = Time stamps
option-timeout = Time limit
option-tool = Tool frame
option-topic = Topic
option-trigger = Trigger
option-trigger-edge = Edge of the trigger
option-url = Port or address
option-width = Width
drivers-are = Available drivers: { $names }.
drop-cloud = Discard this cloud
drop-coordinates = Drop coordinates
drop-last-place = Discard the last place
dropped-cloud = discarded a cloud
dropped-coordinates = dropped coordinates of a tracker
dropped-seat = discarded a place
dropped-swing = discarded the points of a place
dropping-cloud = Discarding the cloud
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
dxf-requires-package = DXF needs the package ezdxf
each-point-needs-three-coordinates-one = each point requires three coordinates and one pixel (u, v)
each-point-swing-about-middle-all = Each point of the swing relative to the mean of all points, in the arm frame.
each-touchs-distance-sphere = Distance of each contact point from the sphere
edge-of-base =
    { $side ->
        [left] the left edge of the base
        [right] the right edge of the base
        [front] the front edge of the base
       *[back] the back edge of the base
    }
edge-of-crest =
    { $side ->
        [left] the left edge of the crest of merlon { $number }
        [right] the right edge of the crest of merlon { $number }
        [front] the front edge of the crest of merlon { $number }
       *[back] the back edge of the crest of merlon { $number }
    }
edge-of-floor =
    { $side ->
        [left] the left edge of the floor of groove { $number }
        [right] the right edge of the floor of groove { $number }
        [front] the front edge of the floor of groove { $number }
       *[back] the back edge of the floor of groove { $number }
    }
edge-width = Edge width
edges-corners = edges and corners
edges-corners-rms = Edges and corners, rms
edges-lie-off-average-where-certificate = its edges deviate from the certificate by { $usual } on average, and { $edge } by { $distance }
edges-px = Edges, px
edges-would-fit-only-if-cameras = its edges would fit only if the camera's pixels were { $off_square } out of square
edges-would-fit-only-lens-distorted = its edges would fit only with a lens distortion of k1 = { $k1 }, k2 = { $k2 }
edges-x-mm-must-ascend-follows = { $edges } must ascend: { $right } follows { $left }
edges-x-mm-odd-count =
    { $edges } contains { $count ->
        [one] { $count } edge
       *[other] { $count } edges
    }; every merlon has two, a left and a right one
edition-has-no-symbol = the edition { $edition } has no symbol for { $quantity }
editions-are = editions are { $names }
egm-external-axis = The robot at { $address } sends an external axis beside its joints
error-of-arm-over-reach-unknown = { $path } does not state the arm's error over its reach
errors-of-links-counted = Errors of the arm's links count, with all that the touches share of them: { $error } rms of the tip over the arm's reach.
exchange-faces-or-touch-again = Exchange the names, or touch both again
face-has-touches =
    { $count ->
        [one] { $face } was touched once
       *[other] { $face } was touched { $count } times
    }
faces-as-touched = Faces as touched
faces-beyond-tolerance = Beside the drawing by more than its tolerance of ± { $tolerance }: { $faces }. Check these readings, or whether two were exchanged.
file-has-touches = { $path } has { $count } touches
first-id-too-large = { $field }: at most { $most } for these markers of { $dictionary }
fix-focus-and-zoom-and-take-all-pictures-again = Switch autofocus off, fix focus and zoom, and take all pictures again
flatness-of-touches = Flatness
focal-length-differs-between-pictures = the focal length differs between the pictures, by { $span }: it is longer in poses { $poses } than in the others
focus-zoom-or-lens-changed-since = focus, zoom or lens changed since it was calibrated
form-of-faces-is = Flatness is the range of the touches about their own least-squares plane; out of parallel is what this plane rises over the touched area against the axis of the block. Three touches show no form.
give-a-calibration-of-several-poses = Give a calibration that Crenel made from several poses
give-arm-of-touches = Give the arm's file with --arm
give-other-sizes-or-leave-them = Change this size, or leave it to the design.
give-kind-chessboard = if it is a plain chessboard, describe it in object.json with kind chessboard; otherwise bring the board with the markers into the picture, and check the dictionary in its certificate
give-readings-points-or-both = Give readings.csv, --points, or both
groove-deeper-than-sharp = grooves of { $groove } are deeper than the depth of field of { $depth }
groove-too-deep-to-cut = grooves of { $groove } are too deep to be cut; with these merlons, { $most } at most
give-each-pose-its-own-picture = Give each row of images.csv its own picture
had-begun-adding-the-laser = started to add the laser
identical-pictures-count-once = The pictures of poses { $poses } are those of other poses again. They count once.
identify-arm-or-state-arm-um = Identify the arm, or state the rms error of its tip over the reach with --arm-um
joints-of-others-left-out = joints that arm.json does not have are left out: { $names }
kept-camera-does-not-fit = the corners lie { $rms } rms off where the kept camera puts them, { $own } with a camera of these pictures
kept-camera-does-not-fit-the-arm = with the kept camera, pictures and arm disagree { $times } times as much as with a camera of their own
last-result-has-other-version = The last result with it was made with another version of this datasheet, which it keeps.
leave-out-touches-evenly = Leave out touches evenly over all faces
links-errors-do-not-average-out = errors of the links are the same in every touch and do not average out
measure-width-and-height-of-print = Measure width and height of the whole pattern, or neither.
merlons-too-narrow = with { $merlons } merlons, the narrowest is { $narrowest } wide, and must be { $least } at least to be measured in the picture
merlons-would-be-mirror = { $merlons } merlons on { $width } would be so equally wide that the block could be taken for its mirror image
marker-cells-too-small = the cells of its markers are { $width } wide in the picture; at least { $least } are required
markers-arranged-so = the markers are arranged as on a board with { $columns } squares across and at least { $rows } down
markers-covered-too-small-or-blurred = the board is out of the picture, covered, too small, blurred or seen at too steep a slant, or is another object
markers-have-ids = markers of { $dictionary } with the ids { $first } to { $last } were found
markers-of-board-read = { $found } of { $count } markers of { $name } were read
markers-read-if-mirrored = in its mirror image, { $count } markers of { $dictionary } are arranged as on a board
most-touches-are = at most { $most } can be used
multiply-coordinates-by = Multiply the coordinates by { $factor }
need-certificate = Certificate of the block
neither-readings-nor-points = neither readings nor points were given
no-page-of-this-name = { $name } is no page
no-width-for-given-merlons = no block with { $merlons } merlons can be made and is seen as a whole by this sensor
no-width-for-given-sizes = no block with { $merlons } merlons and grooves of { $groove } can be made and is seen as a whole by this sensor
one-length-of-print-alone = of the print, one length was measured without the other
no-laser-plane-yet = Camera and mounting are calibrated. There is no laser plane yet: nothing can be scanned.
no-picture-was-taken-with-the-laser = the laser was off in all pictures, so there is no plane to add
none-yet = none yet
opposite-faces-exchanged-or-left-handed = opposite faces, such as front and back, are exchanged, or the machine's axes are left-handed
out-of-parallel = Out of parallel
picture-mirrored = the picture is mirrored
posture-and-its-uncertainty = posture and posture_uncertainty_mm are given together
scan-under-way-go-where-stands = A scan is in progress. Continue where it stands.
shape-label = { $shape ->
    [plane] Plane
    [sphere] Sphere
   *[cylinder] Cylinder
} { $n }
sizes-not-shown-as-a-whole = a block of { $width } with these sizes is not seen as a whole, down to the floors of its grooves
so-few-markers-tell-nothing = fewer than { $fewest } do not tell where the board is: the others are covered, out of the picture, too small or blurred
squares-without-markers = squares of a chessboard were found, but no markers in them
state-dictionary = if this is the board, state dictionary: { $dictionary } in its object.json
same-picture-as-before = { $name } is the picture before it again
same-picture-as-pose = { $name } is the picture of pose { $number } again
same-picture-counts-once = the same picture counts once
state-external-axis = Set external_axis to "third" if the robot has seven axes, or to "other" for a track or a turntable, which must stand still
egm-lacks = The packets of the robot at { $address } have no { $name }
egm-no-egm = What the robot at { $address } sends is no EGM
egm-start-stream = Run the RAPID program that starts the stream (EGMStreamStart). Its UDPUC device must have the address and port of this computer.
empty = it is empty
encoder-stands-still-switch-arm-off = its encoder does not move: switch the arm off and on, and check the joint's cable
end-cloud = End the cloud
end-it-first = End it first
end-name = End the name with .html or .pdf
end-pictures-by-themselves = End the pictures
ended = ended the session
ended-activity = ended what had the arm
ended-pictures-by-themselves = ended the pictures by themselves
ended-token-metrics = revoked a metrics token
enough-places = Sufficient places
enter-device-address = Enter a device path as /dev/ttyUSB0, a port as COM5, socket://HOST:PORT or rfc2217://HOST:PORT.
enter-network-address-as = For an address in the network, enter { $url }.
enter-artefact-by-hand = Enter the artefact by hand, with what its certificate states
enter-country = State it, such as DE; on the command line, with --country DE
enter-laboratory = State it; on the command line, with --laboratory NAME
enter-stream-address = The address of a stream begins with one of { $kinds }.
enter-the-arm = Enter the arm
enter-the-sensor = Enter the sensor
enter-the-target = Enter a block or board
entered-consoles-code = signed in with the console's code
entered-the-temperature = entered the temperature
entry-point-must-name-function-takes = Its entry point must name a function that accepts the options.
error = Diameter error
error-arm-joints = play and encoders of the joints
error-arm-links = lengths and angles of the arm's links
error-budget = Error budget
error-budget-with-limits = Sources of the standard uncertainty (k = 1) of a scanned point. Limits: good up to { $good }, usable up to { $usable }.
error-clock = delay between arm and sensor
error-hides-in = Hardly shows in
error-in-column = column { $place }
error-in-row = row { $place }
error-laser-plane = laser plane, bent or tilted
error-of = Error
error-probe-matrix = probe matrix, translation off by d
error-radius = Radius error
error-sensor-scale = scale of the sensor
error-shows-in = Shows in
error-stripe-noise = noise of the stripe
error-not-foreseen = An error here is a case that the program did not foresee.
error-tip-diameter = diameter of the tip
error-what = { CLAUSE($what) }.
error-what-and-why = { CLAUSE($what) }: { CLAUSE($why) }.
one-pose-does-not-show-arm-errors = One picture in one pose does not reveal errors of the arm's own model, joint angles that do not belong to the picture, or an object that moved after it was touched. This figure does not include them.
errors-or-none-last-hour =
    { $count ->
        [0] No errors in the last hour.
        [one] One error in the last hour.
       *[other] { $count } errors in the last hour.
    }
errors-of-lengths = Errors of length
errors-of-lengths-caption =
    { $count ->
        [one] { $count } error of length
       *[other] { $count } errors of length
    } { $by ->
        [scan] by scan
       *[touch] by touch
    } over the length; places side by side. Dashed: the maximum permissible error. Red: beyond it, with the number of the place.
even-best-arm-points-still-scatter = even with the best-fitting arm the points scatter by { $scatter }
every-figure-keeps-limit = Every figure is within its limit.
not-every-figure-keeps-limit = Not every figure is within its limit.
not-every-figure-known-well-enough = Not every figure is determined well enough for a decision.
every-file-has-content-result-made = Every file has the content that the result was computed from.
every-reading-joints-could-true = All joint readings are plausible.
every-stripe-pictures-wait-them = All stripes are recorded; they take precedence over pictures.
everything-grows-metre-aluminium = Everything expands with it: one metre of aluminium by { $growth } per degree.
exceed-limit-m = { $half_range } exceeds the limit of { $limit }.
exchange-readings-or-read-again = Exchange them, or read both again
expand-xacro = Expand it with xacro FILE > robot.urdf, and give that
expanded-uncertainty-note = U = { $expanded_uncertainty }, k = 2
expansion-not-read = the certificate's coefficient of expansion is not read: enter expansion_per_c in the file
face-known-only-to = the readings leave a face uncertain by { $known }
face-of-block = Face
faces-are-not-parallel = these are not two parallel faces
faces-of-readings-are = faces are edge_1 to edge_{ $edges }, { $names }
figure-over-clouds = 
    { $title }: { $of ->
        [mean] mean
        [range] range
       *[standard_deviation] standard deviation
    }
file-cannot-be-evaluated = it cannot be evaluated ({ $error })
file-has-no-pictures-with-laser = { $path } contains no pictures with the laser on
file-has-no-readings = { $path } contains no readings
first-row-empty = length and twist of the first row are zero, and those of the last are not
flange-lies-far = { $path }: the flange lies { $furthest } from its base
flange-row-turns-no-joint = The row { $name } turns about no joint: it was taken as a constant transform behind the last joint.
frames-left-out-clock-set = { $count } of { $frames } frames excluded: a clock was set back around their time stamps
frames-moved-near-the-arm = link frames of nearly parallel axes lay up to { $far } away in arm.json: they were moved near the arm, and describe the same arm
give-arm-and-camera-one-clock = Keep both on one clock (PTP, or pulses of the arm), or determine the delay before each scan.
give-each-row-angles-of-its-pose = Give every row the joint angles of its own pose
give-kind-charuco = Describe the board in object.json with kind charuco, and its dictionary and marker_mm
give-one-of = Give one of { $names }
give-pose-of-marker-in-frame = Give the pose of the marker in the frame of the instrument
give-quaternions-with-more-digits = Give qx, qy, qz, qw with at least four digits after the decimal point, the scalar last
give-row-of-each-joint = Give one row for each joint; a row of the flange comes last and is called flange
give-square-in-mm = Give square_mm in millimetres
give-times-in-seconds = Give the times in seconds, from any beginning
give-times-in-seconds-readings-closer = Give all times in seconds, and readings of the arm at most { $longest } apart
give-times-of-one-clock = Give pictures and readings the times of one clock
give-unit-of-angles = Choose the unit of the angles
give-lengths-of-links = Enter a and d of each joint
give-unit-of-lengths = Choose the unit of the lengths
give-ur-files = Give calibration.conf of the arm, alone or followed by urcontrol.conf
give-urdf = Give the URDF of the robot, as ROS reads it
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
import-with-stripe-axis = Set stripe_axis to { $axis } in sensor.json, and import again
index-before = lengths or twists have the index i − 1
it-is-known-to-limit = it is known to { $u } (k = 1) then; the limit is { $limit }
it-is-no-device = it is not the address of a device
largest-angle-of-poses = { $path }: the largest of { $names } is { $largest }
last-row-empty = length and twist of the last row are zero, and those of the first are not
lengths-add-up = its lengths add up to { $total }, which in { $unit } is an arm of { $length }
lengths-all-zero = all lengths are 0: the links of an arm have lengths
lengths-are-in-metres = no a_mm or d_mm exceeds { $longest }: these are metres, but millimetres are expected
lengths-in-unit = Read in { $unit }, the arm measures { $length }
limits-judged-by-marked-uncertainty = U: measurement uncertainty of the value by gauge, probe and points. U of test: test value uncertainty by the gauge and its set-up alone (ISO 14253-5), which is a part of U. Each limit is judged by the one marked with{ $mark }.
limits-not-stated = The text states no limits of the joints: ±180° were put in.
line-moved-arm-did-not = the laser line moved by { $line }, but the arm's readings did not change
line-stands-still = The line stands still: beyond its first { $most } frames it gives no points; frames without them so far: { $count }
listen-choose-higher-port = Choose a port from 1024 on with --port
listen-failed = Cannot listen on { $host } port { $port }
listen-free-port = Stop what is using it, or choose another with --port
listen-give-own-address = Give an address of this machine with --host
map-outliers-or-none = 
    { $points ->
        [0] No point is further off than noise explains.
        [one] Rings: { $points } point is further off than noise explains.
       *[other] Rings: { $points } points are further off than noise explains.
    } Bold rings: the lowest and the highest point, { $low } and { $high }; the range of all points lies between these.
load-the-list-again = load the list again
load-the-page-again = load the page again
markers-in-white-squares = there are markers in its white squares: it is a ChArUco board
markers-place-is-estimated-instead = the marker's place on the flange is estimated instead
model-answer-unknown = { $key } cannot be { $answer }
model-leaves-open = { $path } leaves open what it means
model-open = { $key } ({ $options })
model-open-likely = { $key } ({ $options }; likely { $likely }: { $why })
move-tip-to-object = Put the tip to the object, then take the point
move-sensor-or-stop-scan = Move the sensor over the part, or stop the scan.
moves-check-arm-json =
    { $beside ->
        [bars] { $name } changes by { $change }: check arm.json and the bars' lengths
        [marker] { $name } changes by { $change }: check arm.json, and the marker: its name in the column marker, if it is not the tip, and its place, if it is given
       *[arm] { $name } changes by { $change }: check arm.json
    }
multiply-readings-by-inch = Multiply them by 25.4
name-columns-by-unit =
    { $unit ->
        [deg] Name the columns with _rad, or convert the angles
       *[rad] Name the columns with _deg, or convert the angles
    }
name-columns-of-degrees = They hold degrees: name the columns { $first } … { $last }
name-dh-columns = Name the columns in a first line, such as: joint, a [mm], alpha [deg], d [mm], theta [deg]
name-frame-otherwise-than-base = Give the frame another name than base
no-arm-has-such-lengths = no arm is so small or so large
no-block-fits-sensor = no block that can be made and touched fits into this field of view and depth of field
no-dh-table = There is no Denavit-Hartenberg table in the text
no-picture-between-readings = no picture of { $path } lies between two readings of { $readings } that are close together
no-picture-of-folder-can-be-used = none of the { $count } pictures can be used; the first: { $first }
no-pictures-by-themselves = no pictures are taken by themselves
nominal-is-not-this-arm = A nominal model is right for every arm of its kind, and exact for none: identify yours, or give its factory calibration.
one-of-readings-is-wrong = the readings do not tell which of them is wrong
only-order-with-right-angles = only in this order are all twists multiples of 90°
pass-over-one-flat-plate = Pass over one flat plate, and leave out its edge.
paste-dh-table = Paste a line for each joint with a, alpha, d and theta
picture-whenever-robot-rests = A picture at each rest of the robot
pictures-by-themselves = Pictures by themselves
pictures-do-not-fit-delay = { $off } of { $pictures } pictures do not fit one plane at this delay.
nothing-touched-there = it has not moved since, so that the tip touches nothing
picture-of-pixels = { $width_px } × { $height_px } pixels
one-of-points-off = At least one of the points { $points } is off the surface
one-of-touches-off = at least one of these points is off, and the others cannot tell which: { $points }. Touch two more points there
others-cannot-tell-which = the others cannot tell which
places-held-out-agree-too-well = in cross-validation the places deviate by only { $times } times the stated noise: standard_uncertainty_mm is too large, or in another unit
plus-minus = ± { $uncertainty }
point-off-surface-left-out = Point { $index } is { $off } off the surface of the others. It is excluded.
point-off-others = Point { $index } lies { $off } off the plane of the other points { $where }.
point-taken-for = Point { $index }, meant { $where }; not judged yet.
point-beside-face = Point { $index } lies beside the { $face } face: it touched nothing there.
points-moved-from-line-on = coordinates.csv: in frame { $name } the points from line { $line } on lie { $off } off those before, as the best arm has them
points-scatter-less-than-stated = the points scatter by a small part of what is stated: standard_uncertainty_mm is too large, or in another unit
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
probe = Probe
range-too-large-for-standoff = a field of view of { $field } and a depth of field of { $depth } do not belong to a stand-off of { $standoff }
proxy-changes-host = The page is at { $page }, but its request came here for { $host }.
proxy-does-not-pass-upgrade = A live connection arrived without its upgrade: a proxy does not pass on WebSockets.
proxy-list-it = If it is your proxy, add its address to proxies in the settings.
proxy-not-listed = X-Forwarded-Prefix from { $address } is not used: no listed proxy has this address.
proxy-pass-host = If a proxy is in front of the server, let it pass on the browser's Host; in nginx: proxy_set_header Host $http_host;
proxy-pass-upgrade = Let the proxy pass on the upgrade; in nginx: proxy_http_version 1.1; proxy_set_header Upgrade $http_upgrade; proxy_set_header Connection $http_connection;
proxy-sub-path-unusable = X-Forwarded-Prefix of the proxy is not used: it is no sub-path.
read-these-again = Read these again
reading-between-faces = { $place }: a reading from { $first } to { $second }
reading-far-beside-drawing = { $place }: { $reading } was read where the drawing has { $drawn }
reading-in-row = reading { $number } ({ $first } to { $second })
reading-minus-fit = Reading − fit
reading-of-certificate = Reading
reading-of-other-faces = the row belongs to other faces, another block or another unit
reading-off-by = { $reading } by { $off }
readings-agree = Readings agree
readings-agree-if-exchanged = all readings agree if those of { $one } and { $other } are exchanged
readings-are-apart-nothing-between = the readings are { $period } apart on average; nothing is interpolated over more than { $longest }
no-picture-of-folder-has-a-line = none of the { $count } pictures shows a line; the first: { $first }
no-picture-within-readings = no picture of { $path } was taken during the readings of { $readings }, from { $begin } to { $end }
one-picture-at-a-time = a sensor takes one picture at a time
picture-at-time-of-line = { $place } has the same time_s as line { $line }
pictures-are-at = the pictures begin at { $begin }
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
readings-of-certificate = Readings
readings-scatter-more = The readings scatter { $times } times as much as they state; the uncertainties are larger by this factor.
recording-has-joints-named = { $path } has { $count } joints ({ $names })
recording-keeps-still-lines = The recording keeps them all.
replace-the-datasheet = Replace it; the present one is kept among the retired ones
retired-a-datasheet = retired a datasheet
reverse-sign-of-joint = Reverse the sign of joint { $joint } in arm.json
rotary-joints-only = Arms of rotary joints can be used
rotation-means-several = by the controller they can mean different things: { $names }
rotation-not-stated = { $path }: nothing says how { $columns } make a rotation
rotation-of-poses = rotation { $name } is not known, or the arm reports joints: a robot's is one of { $names }
save-table-as-csv = Save it as CSV (UTF-8), with commas between the columns
say-what-is-open = Say it with --say KEY=VALUE for each
scatter-of-clouds = Clouds
scatter-of-points = Points
see-that-arm-sends-its-positions = Check that the arm sends its positions while it moves
sensor-did-not-move = the sensor did not move
scan-incomplete-again = The rest of the part is missing from the cloud: mend the cause, and scan again.
scan-incomplete-remedy = Scan again after the cause is mended; crenel reconstruct --allow-incomplete makes the points that are possible, with gaps
scan-incomplete-unread = the rest of the recording cannot be read, and may hold more than all its points so far
scan-is-incomplete = { $count } of { $total } pictures with a line ({ $share }; limit { $limit }) gave no points, because the position of the arm was unknown or impossible
scan-is-missing-parts = { $path } is incomplete: { $missing }
scan-saved-incomplete = { $name } is saved with { $count } points, but is incomplete: { $missing }.
settings-add-as-shown = Add it as { $document } shows
settings-certificate-and-key = certificate and key belong together
settings-correct-name = Correct its name
settings-give-both-tls = Give both tls_certificate and tls_key, or neither
settings-give-pem = Give the file in PEM format
settings-give-proxy = Give the address from which the proxy connects, as "10.0.0.5" or "10.0.0.0/24"
settings-give-root-path = Give it as "/crenel": letters, digits and . _ ~ - between slashes, and not /api, /assets, /metrics or /viewer
settings-is-missing = { $named } is missing
settings-is-unknown = { $named } is unknown
settings-key = { $file }, [{ $table }]: { $key }
settings-key-alone = { $file }: { $key } is given without the other
settings-limits-order = what is good must be usable
settings-limits-reversed = { $file }, [limits]: usable_um = { $usable } is below good_um = { $good }
settings-limits-swap = Give usable_um the larger value
settings-missing = { $path }: there is no such file
settings-must-be-list = it must be a list, as ["one", "two"]
settings-must-be-quoted = it must be text in quotes
settings-must-be-station-name = it must be lower-case letters, digits and hyphens, 40 at most
settings-must-be-table = it must be a table
settings-must-be-topic-prefix = it must be words with / between them, without spaces, # and +
settings-must-be-web-address = it must begin with http:// or https:// and name a host
settings-name-as-tables = Name the sensors as their tables do; delay_us is for all others
settings-name-otherwise = Give it another name
settings-name-sensor-tables = Name each sensor, as in [sensor.left]
settings-no-such-sensor = there is no sensor of that name
settings-not-as-shown = it is not as { $document } shows
settings-not-toml = it is not TOML: { $reason }
settings-proxy-is = { $file }: proxies has { $proxy }
settings-proxy-no-address = it is no address
settings-root-path-is = { $place }: the root path is { $path }
settings-root-path-unusable = it is no sub-path that a proxy could offer
settings-sensor-name = the name of a sensor is of letters, digits and underscores, and begins with a letter
settings-states-devices = it states which arm and which sensor are connected
settings-table = { $file }: the table [{ $table }]
settings-table-name = { $file }: the name of the table [{ $table }]
settings-trigger-names = { $file }, [trigger]: delays_us names { $names }
settings-value-is = { $named } = { $value }
settings-value-of = { $file }: { $key } = { $value }
settings-write-one = Write one as docs/operating.md shows, name another with --config, or try crenel demo
sign-in-add-openid = Add "openid"
sign-in-give-issuer = Give the issuer as the provider's configuration states it
sign-in-install-library = Install it with: pip install 'crenel[oidc]'
sign-in-issuer-is = { $file }, [sign_in]: issuer = { $issuer }
sign-in-issuer-must-be = it must be an https address without ? and #; http only for a provider on this machine
sign-in-library-missing = the library joserfc is not installed
sign-in-needs-openid = without it, the provider does not say who signs in
sign-in-scopes-lack-openid = { $file }, [sign_in]: scopes has no 'openid'
sign-in-unusable = { $file }: [sign_in] cannot be used
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
source-dh-table =
    { $rows ->
        [one] Denavit-Hartenberg table of one row
       *[other] Denavit-Hartenberg table of { $rows } rows
    }
source-nominal-arm = { $name }, by { $source }
source-robot-of-the-list = Without a text: a robot of the list
source-ur-calibration =
    { $calibrated ->
        [yes] Factory calibration of a Universal Robots arm
       *[no] Nominal model of a Universal Robots arm (urcontrol.conf)
    }
give-ros-kinematics = Give the YAML file with kinematics as the driver of the robot for ROS writes it
ros-has-metres = Give the lengths in metres, as ROS has them
ros-link-count =
    { $count ->
        [0] it is missing
       *[other] it is there { $count } times
    }
ros-link-cannot-be-used = The link { $link } of the kinematics cannot be used
ros-number =
    { $there ->
        [yes] { $name } is { $text }, which is no number
       *[no] { $name } is missing
    }
source-ros-kinematics = Kinematics of a Universal Robots arm, as ROS keeps its factory calibration
source-urdf = URDF of { $name }
sphere-diameter-not-read = the certificate states no diameter of the spheres, or several: enter sphere_diameter_mm in the file
expected = { $wanted } is expected
expected-by-datasheet-and-expanded-uncertainty = datasheet: { $expected }; U = { $expanded_uncertainty }, k = 2
exposure-cannot-be-set-by-line = The exposure cannot be adjusted to the laser line
extracting-laser-stripe = Extracting the laser stripe
extraction-detection = Extraction and detection
face = Face
face-and-number = { $face } { $number }
face-can-turn-about-line = the face can rotate about that line
face-has-points-go = This face has its points. Continue with: { $face }.
faces-agree-to = { $first } and { $second } to { $opening }
faces-are = the faces are { $names }
faces-contacts = { $faces } faces for { $contacts } contact points
fail = Fail
activity-failed = { $title } failed
fanuc-check-option = Check the address, and that the controller has the option Stream Motion.
fanuc-check-other-client = Check that no other program uses Stream Motion of this controller, then restart the controller.
fanuc-no-answer = The robot at { $address } does not answer as Stream Motion does
fanuc-old-version = The robot at { $address } offers version { $version } of Stream Motion, but version 3 is needed
fanuc-report-faceplate = Set Stream Motion to report the faceplate on the controller, or use report = "joints".
fanuc-reports-tool = Stream Motion of the robot at { $address } is set to report the pose of the tool instead of the faceplate
fanuc-sends-no-status = The robot at { $address } answers but sends no status
fanuc-update = Update the controller's software.
far-out = far out
fault = { CAPITAL($fault) } is at fault. { $text }
fetch-it-first = Fetch it first
fetched-scan = fetched a scan from the archive
few-poses = { $poses } poses give { $figures } values for { $unknown } unknowns and hardly check them: measure { $wanted } poses, all over the reach
fewest-in-patch = Fewest at a place
field-is = { $path }: { $place } is { $value }
field-missing =
    { $more ->
        [0] { $path }: { $place } is missing
       *[other] { $path }: { $place } is missing (and { $more } more)
    }
field-must-be-less-than-half-square = { $field } must be less than half a square; is it in micrometres?
field-name = { $name }
figure = Figure
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
figure-within-guard = { $title }: { $value }, within the limit of { $limit } by more than the guard band of { $guard }.
figure-within-limit = { $title }: { $value }, within the limit of { $limit } by more than its uncertainty of { $uncertainty } (k = 2).
figure-without-guard =
    { $title }: { $value }, { $how ->
        [beyond] beyond
       *[within] within
    } the limit of { $limit }.
figures-against-their-limits = Figures and their limits
figures-before = { $text }: the figures are out of date.
figures-break-limits-not-compared = Not every figure is within its limit; scan and probe were not compared.
figures-keep-limits-not-compared = Every figure is within its limit; scan and probe were not compared.
figures-undecided-not-compared = Not every figure is determined well enough for a decision; scan and probe were not compared.
file = a file
file-column = File
file-carries-no-verdict = The file contains no verdict.
file-cut-off = the file is incomplete
file-damaged = the file is damaged
file-has-name-folder-needed = a file has the name of a required folder
file-has-no-contact-points = { $path } contains no contact points
file-has-no-pictures = { $path } contains no pictures
file-has-no-points = { $path } contains no points
file-larger-than-any-read = the file is too large to be read
file-name-is-not-utf-8 = The name of { $name } is not UTF-8 text
files-no-longer-in-data-folder = its files are no longer in the data folder
files-searched = Supported file types: { $suffixes }.
filters-of-figures = Filters: points further than { $sigmas } standard deviations from the fit, and frames within { $place } of an earlier one, are not used. For the form over all points they are.
finder-failed = The search { $name } of { $package } failed: { $kind }: { $error }
finder-takes-too-long = The search { $name } did not end in time
finding-objects-edges = Finding the object's edges
finding-start = Finding the initial values
finding-what-and-why = { CAPITAL(CLAUSE($what)) }: { CLAUSE($why) }
findings = Findings
finish-cloud-drop = Finish this cloud, or discard it.
finish-cloud-first = Finish this cloud first.
finish-sphere = Finish the sphere
finish-swing = Finish the swing
finished-cloud = finished a cloud
finished-seat = finished a seat
finite-number-decimal-point-expected = a finite number with a decimal point is expected
firmware-must-answer-hello = Its firmware must answer the hello request (crenel_hardware.arm.protocol).
firmware-must-answer-pulse-request = Its firmware must answer pulse requests (crenel_hardware.arm.protocol).
firmware-must-send-counts-of-hello = Its firmware must send as many counts as its hello announces.
firmware-must-send-what-hello-announces = Its firmware must send what its hello announces.
first-basler-camera = The camera of Basler
first-genicam-camera = The GenICam camera
first-gentl-camera = The GenTL camera
first-line-names = the first line names { $names }
first-line-names-column-count =
    the first line names { $count ->
        [one] { $count } column
       *[other] { $count } columns
    }
first-to-last-group =
    { $first } to { $last }: { $count ->
        [one] { $count } group
       *[other] { $count } groups
    }
fit-does-not-converge = the fit does not converge
fit-follows-these-points-arm = the fit follows these points instead of the arm
fit-plane-sphere-cylinder-first = fit a plane, a sphere or a cylinder first
fitting =
    { $shape ->
        [plane] Fitting a plane
        [sphere] Fitting a sphere
       *[cylinder] Fitting a cylinder
    }
fitting-arm = Fitting the arm
fitting-contact-points = Fitting the contact points
not-five-to-seven-joints = { $field }: five to seven joints are expected, not { $joints }
fix-board-flat-plate = Fix the board to a flat plate.
fix-board-so-cannot-rock-warp = Fix the board so that it cannot rock or warp, and lock the camera's lens.
fix-object-arm-so-neither-can = Fix object and arm so that neither can move, touch the object, and take the pictures again.
flange-differs = the flange differs by { $moved }
flange-turned-most-between-poses = the flange rotated by at most { $turn } between the { $count } poses
flange-frame-of-this-arm-former-calibrations-not-valid = The flange frame is now that of this arm: calibrations made with the previous arm do not apply to it.
flat-board-tells-cameras-focal-length = a flat board determines the camera's focal length only with at least { $fewest_poses } pictures, tilted relative to each other
fleet-arm-half-range = Arm check: half the range along the worst axis
fleet-arm-largest = Arm check: largest distance from the mean, in space
fleet-arm-two-sigma = Arm check: 2 sigma along the worst axis
fleet-cloud-process-ended = The process that made the cloud ended with status { $status }
fleet-clouds-make-room = Make room there, or lower limit_gb in [clouds] of fleet.toml
fleet-clouds-no-place = fleet.toml names no place with the records of { $station }: give archive or data in [stations.{ $station }], and clouds can be made here
fleet-clouds-queue-full = Too many clouds wait already; try this one later
fleet-contacts-rms = Contact points from their faces, rms
fleet-focal-length-u = Focal length along the rows
fleet-focal-length-v = Focal length along the columns
fleet-give-own-place = Give each station its own archive and data folder
fleet-give-place = Give archive = {"{"} url = "…" {"}"} or data = "…"
fleet-laser-plane-offset = Offset of the laser plane
fleet-laser-plane-rms = Stripe points from the laser plane, rms
fleet-library-missing = The libraries of the fleet are missing: { $libraries }
fleet-name-cloud-folder = Name a folder of its own in [clouds] of fleet.toml
fleet-name-page-password = Name a file that contains only the password of the page
fleet-name-password-file = Name a file that contains only the password of the database
fleet-no-cloud = There is no such cloud any more: { $name }
fleet-no-marker = it lacks crenel-archive.txt, which the station writes there with its first record
fleet-no-record = The catalogue has no such record: { $id }
fleet-of-gauge = Gauge: { $title }
fleet-open-to-all = Anyone who reaches { $host } could read the catalogue
fleet-password-empty = { $file } is empty
fleet-point-uncertainty = Standard uncertainty of a point (k = 1)
fleet-probe-translation = Probe matrix, translation along { $axis }
fleet-reprojection-rms = Reprojection error, rms
fleet-set-password = Set password_file in [server], or [sign_in], of fleet.toml; or leave --host at 127.0.0.1
fleet-station-has-no-place = { $file }, [stations.{ $station }]: there is neither an archive nor a data folder
fleet-stations-share-place = { $file }: the stations { $other } and { $station } have the same place, { $place }
fleet-tip-diameter-error = Tip check: error of the diameter
fleet-tip-scatter = Tip check: scatter of the contact points
fleet-write-settings = Write one as docs/fleet.md shows, or name another with --config
floors-grooves = Floors
focal-length = Focal length
focal-lengths = { $u } × { $v }
focus-camera-object-bring-into-working = focus the camera on the object, bring the object into the working distance, and hold still
focus-camera-bring-object-and-hold-still = focus the camera on the object, bring the object into the working distance, and hold still
focus-light-board-evenly = focus the camera, and light the board evenly
folder-cannot-be-written = the folder { $folder } is not writable
folder-has-none-of = it contains none of { $names }
folder-inside-data-folder = { $folder } is inside the data folder
folder-named = The folder { $folder }
folder-their-own = from a folder of their own
folder-there-already = { $folder } already exists
folders-next-to-it-not-empty = there is data beside it, in { $folders }
form-95-m = Form 95 %, filtered, µm
form-all-m = Form 95 % of all, µm
form-all-points-in-gate = Form of all points (95 %)
form-cloud-95-points = Form, filtered (95 % of the points)
form-max-min-m = Form (max − min), µm
format-expected = { $format } is expected here
frame-has-pixels = { $path }: frame { $number } has { $width_px } × { $height_px } pixels
frame-has-points = coordinates.csv: frame { $name } has { $count } points
frame-named = frame { $name }
frame-shows-only-s-visible-edges = the picture shows only { $share } of the visible edges of { $name }
frame-without-joints-around-gives-no = A frame without arm readings around it gives no points.
frames-joint-samples-which-neighbours-up = frames from { $frames_from } to { $frames_to }, arm readings from { $joints_from } to { $joints_to }; neighbouring samples are used up to { $gap } apart
frames-left-out-no-joints-around = { $count } of { $frames } frames excluded: no arm readings around their time stamps, the first { $first } from the start; { $beyond } before the first or after the last sample, { $gaps } in gaps
frames-lost-when-full-scan-more = Frames are lost when it is full; scan more slowly or close other programs.
free = { $free } is free.
free-enough-for-hours = { $free } is free, enough for { $hours } hours of this scan.
free-on-disk = { $free } is free on the disk of { $folder }
free-some-space = free some space
free-some-space-choose-another-disk = Free some space, or choose another disk
free-some-space-start-again = Free some space, and start again
free-some-space-then-do-again = Free some space, then try again
free-some-space-try-again = Free some space and try again
from = From
from-to = { $low } to { $high }
front = from the front
front-face = Front face
front-y-mm-must-less-than = { $front } must be less than { $back }
further-cloud-aside-one-other-s =
    { $aside ->
        [one] { $aside } further cloud was excluded.
       *[other] { $aside } further clouds were excluded.
    }
gate-and-filters = Points that take part
gate-of-plane = Gate of all points: the scanned area, within { $gate } of the plane.
gate-of-sphere = Gate of all points: within { $gate } of the calibrated sphere, and { $angle } from the middle of the scan.
gauge = Gauge
gauge-clamped = This gauge is clamped
gauge-shape = { $path }: shape is { $shape }
gauge-touched-only-shape-size-judged = The gauge was not touched: only its shape and size are assessed.
gauge-touched-shape-size-only = the gauge was not touched: shape and size only
gauges-are-plane-or-sphere = a gauge is a plane or a sphere
gave-no-picture-within = { $title } sent no picture within { $time }
gentl-producer-missing = There is no GenTL producer ({ $producer })
gentl-producer-unusable = The file { $producer } is no GenTL producer for this computer ({ $reason })
give-a-calibration-for-each-sensor = give the calibration of each sensor with its name, as in { $name }=calibration.json
give-arm-its-own-times-or-no-other-traffic = Let the arm state the time of each measurement itself, or send each one at once, over a cable and without other traffic
give-arm-json-arm-took = Give the arm.json of the arm that recorded this
give-arm-json-arm-took-recording = Give the arm.json of the arm that made this recording
give-arms-own-model-columns = Give the arm's own model, or columns { $names }
give-axis = Give --axis { $axis }
give-calibration-sensor-took-picture = Give the calibration of the sensor that took this picture
give-calibration-sensor-took-recording = Give the calibration of the sensor that made this recording
give-calibration-without-name = give its calibration without a name
give-cameras-own-picture = Give the original picture of the camera
give-certificate-board-picture = give the certificate of the board in the picture
give-certificate-crenellated-object-calibrate-command = Give the certificate of a crenellated object, or calibrate on the command line
give-certificate-first =
    { $kind ->
        [bar] Enter the length from the bar's certificate first.
       *[sphere] Enter the diameter from the sphere's certificate first.
    }
give-certificate-of-charuco-board = give the certificate of the board in the picture; check squares_x, squares_y and legacy_pattern
give-certificate-or-uncover-board = give the certificate of the board in the picture, or uncover the rest of this one
give-cloud-millimetres = Give a cloud in millimetres
give-denavit-hartenberg-model = Give the arm's Denavit-Hartenberg model (convention 'dh-standard')
give-each-own-name-station-mqtt = Give each station its own name with station in [mqtt] of station.toml.
give-each-seat-name-own = Give each seat its own name
give-files-belong-together = Give the files that belong together
give-folder-station-started = Give the folder that the station was started with
give-folder-user-may-write-data = Give a folder that this user may write with --data
give-gauges-own-nominal = Give the nominal of this gauge
give-laser-on-off-pair = Give a picture with the laser on and one of the same scene with it off
give-length-mm-bar-millimetres-check = Give length_mm of bar { $name } in millimetres, and check its rows
give-mask-sensor-took-picture = Give the mask of the sensor that took this picture
give-more-recordings-plane-more-calibrations = Give more recordings of the plane, or more calibrations
give-one-first = Enter an address first
give-one-number-all-joints-one = Give one number for all joints, or one for each joint.
give-picture-as-taken-and-sensor-json = Give the picture as the camera took it, and the right sensor.json
give-planes-own-nominal = Give the nominal of the plane
give-qx-qy-qz-qw-order = Give qx, qy, qz, qw in this order, the scalar last
give-raw-or-without-bayer = Give the camera's raw pictures, or leave out bayer
give-recording-as-documented = Give a recording as docs/formats.md describes it
give-right-arm-json-columns = Give the right arm.json, or columns { $first } to { $last }
give-right-file = Give the right file
give-rotation-of-marker-in-frame = Give the rotation of the marker in the instrument's frame: qx, qy, qz, qw with the scalar last, or rx_deg, ry_deg, rz_deg
give-rows-different-pose-numbers-take = Give the rows different pose numbers, or take the pictures again
give-seat-own-name-check-arm-json = Give each seat its own name; check arm.json
give-standard-uncertainty-of-certificate = Give the standard uncertainty (k = 1) of its certificate in millimetres
give-standard-uncertainty-of-instrument = Give the standard uncertainty (k = 1) of one coordinate, or of one angle
give-station-data-folder-own = Give the station its own data folder
give-tip-or-leave-out-probing = give the tip in arm.json, or leave out probing.csv
go-back-take-picture-points-again = Go back, and take the picture or the points again.
go-calibrating = Continue calibration
go-checking-arm = Continue with the arm
go-faster = Move faster, at { $speed } or more
go-faster-farther-over-plate-nearer = Move faster and farther over the plate, nearer and away again several times
go-further-away-object-does-fit = Move further away: the object does not fit into the picture
go-over-these-places-again-slower = Scan these places again, more slowly.
go-pictures-touches-spread-over-printed = Continue to the pictures. { $wanted } contact points spread over the printed side would check the size of its squares.
go-pose-count-one-other-s =
    { $count ->
        [one] Continue with { $count } pose
       *[other] Continue with { $count } poses
    }
go-scanning = Continue to scanning
go-slower-shorten-exposure = Move more slowly, or shorten the exposure.
go-swinging-least-points = Keep swinging: { $taken } of at least { $least } points.
go-testing = Continue performance test
go-verifying = Continue verification
go-without-probe = Continue without contact points
goes-beyond-end =
    { $side ->
        [right] { $edge } continues beyond its right end
       *[left] { $edge } continues beyond its left end
    }
good = Good
good-m-usable-m = good ≤ { $good }, usable ≤ { $usable }
good-up-m = good up to { $limit }
grey-encodings-expected = grey is expected: { $encodings }
grey-levels = grey levels
guided-session-is-open =
    a guided session is open on the page { $kind ->
        [calibration] “Calibrate”
        [verification] “Verify”
        [performance] “Performance”
       *[arm] “Arm & tip”
    }
guided-steps = Guided steps
had-calculated = started the computation
had-calculated-without-laser = started the computation without the laser
had-simulation-pass-over-plate = started the simulated pass over the plate
half-them-more-contradicting-others-none = half of them or more contradict the others, so none can be trusted
hides-arm-joints = errors of length between spheres, which average over many touches
hides-arm-links = form of a small sphere
hides-clock = all figures by touch, and slow scans
hides-laser-plane = all figures by touch
hides-probe-matrix = all figures by touch; form and dispersion of a sphere scanned with one orientation
hides-sensor-scale = location of the scanned sphere
hides-stripe-noise = location and size: they average over many points
hides-tip-diameter = location, and lengths from centre to centre
implied-offset = Error of the probe matrix that the centres imply
implied-offset-caption =
    In the sensor's frame, the sensor is really { $size } from where the probe matrix has it; thin bars are twice the standard uncertainty. { $significant ->
        [yes] This is more than chance: calibrate the sensor again.
       *[no] This is no more than chance.
    } Without it, a location error of { $left } would remain.
in-space-largest-and-two-s = In space: largest distance from the mean { $largest }, 2 s { $two_s } (figures of ASME B89.4.22, here for one seat).
install-extra-xlsx = Install it with: pip install 'crenel[xlsx]'; or use CSV
its-sensor-has-no-name = its sensor has no name
its-sensors-are = its sensors are { $names }
join-group-of-device = Run "{ $command }", then sign in to the system again and restart Crenel.
kuka-add-element = Add an element with TAG="DEF_{ $name }" to SEND in the controller's Ethernet configuration.
kuka-lacks-element = The packets of the robot at { $address } have no { $name }
kuka-no-rsi = What the robot at { $address } sends is no RSI
kuka-start-rsi = Start RSI on the controller (RSI_ON). Its Ethernet configuration must have ONLYSEND set to TRUE, and the address and port of this computer.
largest-distance-from-mean = Largest distance from the mean, in space
laser-off-or-covered = the laser is off, covered or too weak
laser-on-not-brighter = the picture with the laser on is not brighter than the one with it off
laser-on-off-differ = the pictures with the laser on and off differ: { $on } and { $off } pixels
length-standard = Length standard
line-along-other-axis =
    { $axis ->
        [u] a line of { $points } points runs down it
       *[v] a line of { $points } points runs across it
    }
location-fixed-diameter = Location, fixed diameter
location-over-articulations = Location over the articulations
maximum-permissible-error = Maximum permissible error
measured-channel = measured: { $channel }
measurement-u = U, k = 2
microscribe-needs-five-joints = This driver serves MicroScribe arms with five joints only.
microscribe-no-answer = No MicroScribe answers at { $url }
microscribe-other-device = The device at { $url } does not answer as a MicroScribe does
microscribe-stopped-answering = The MicroScribe at { $url } has stopped answering
move-bayer-to-station-toml = Set bayer and laser_colour in [sensor] of station.toml; take bayer out of the datasheet, and halve its width_px and height_px
name-joints-as-recording = Name the joints in arm.json as the recording names them, or give the arm.json of the arm that took the recording
name-quantity = Name the quantity with { $option }
need-arm-model = Model of the arm
need-first-calibration = First calibration
need-sensor-datasheet = Datasheet of the sensor
need-target = Block or board
never-tested = It has never been tested.
no-arm-model-yet = Nothing says how the arm is built. Enter its joints (D-H table), or that it is a robot that reports poses.
no-arm-without-datasheet = No arm that reports poses is connected without a datasheet
no-board-yet = A robot that reports poses is calibrated with a board. None is known yet.
no-camera-without-datasheet = No camera without a datasheet is connected
no-datasheet-fits-sensor = None of the sensors entered is the connected one. Enter it, too.
no-dcc = the file is no Digital Calibration Certificate (DCC)
no-device-chosen = No { $title } is chosen
no-model-fits-connected-arm = None of the arms entered is the connected one. Enter it, too.
no-sensor-datasheet-yet = Pixels of the sensor and the direction of its line are not known yet. They are asked once it is connected.
no-sensor-named = this station has no sensor named { $name }
no-target-yet = No crenellated block and no board is known yet.
one-pose-takes-no-raw = one pose cannot be calibrated from raw Bayer pictures
opens-again = The connection opens again by itself; then repeat the last action.
origin-of-figures = Origin of the figures
output-away = The output { $place } cannot be reached
output-check-access = Check the keys and the permissions there, or name another output with -o
output-create = Create the folder or the bucket, or name another output with -o
output-forbidden = The output { $place } refuses access
output-full = The output { $place } is full
output-make-room = Make room there, or name another output with -o
output-missing = The output { $place } is not there
performance-accept = Finish the test
performance-all-scanned = All five articulations are scanned.
performance-all-touched = All places of this step are touched. Continue.
performance-another-length-not-taken = This touch makes the length { $found } instead of { $wanted }; it was not taken
performance-another-step =
    { $step ->
        [artefact] This belongs to another step; the test is at 'Artefact and limits'.
        [pattern] This belongs to another step; the test is at '25 touches'.
        [location] This belongs to another step; the test is at 'Location by touch'.
        [scan] This belongs to another step; the test is at 'Five scans'.
        [end] This belongs to another step; the test is at 'Touch again'.
        [lengths] This belongs to another step; the test is at 'Lengths'.
        [plate] This belongs to another step; the test is at 'Two scans'.
        [diameter] This belongs to another step; the test is at 'Master sphere'.
        [seats] This belongs to another step; the test is at 'Three seats'.
        [bar] This belongs to another step; the test is at 'Ball bar'.
        [temperatures] This belongs to another step; the test is at 'Temperatures'.
       *[review] This belongs to another step; the test is at 'Result'.
    }
performance-arm-not-turned-enough = The arm is held as for an earlier touch in this seat: it turned by { $turned }, and { $least } are needed. This touch was not taken
performance-artefact-is-ready =
    { $test ->
        [lengths] The standard is ready
        [plane] The plate lies still
        [contact] The artefacts are ready
       *[other] The sphere is fixed
    }
performance-articulate-arm = Move the elbow or turn the wrist, and touch again
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
performance-aside-note = { $title }: { $reason }
performance-bar-of-contact-test = Only the contact test has a ball bar beside its sphere.
performance-bar-run = Place { $place }, scan { $repeat } of the bar
performance-bar-scan = Scan { $repeat }
performance-bar-scan-done = Scan { $repeat } of the bar in place { $place } is accepted.
performance-bar-scan-name = Performance test, place { $place }, scan { $repeat }
performance-bar-scan-of-length = Scan { $repeat }, the spheres of { $length }
performance-bar-was-moved = The bar was touched in another place since: the scans of the place before stand.
performance-began-scan = began a scan of the artefact
performance-begin-scan = Begin the scan
performance-brought-to-20 = Sizes and lengths are brought to 20 °C; the artefact was at { $celsius }.
performance-not-brought-to-20 = The artefact was at { $celsius }. Its coefficient of expansion is not stated: sizes and lengths are not brought to 20 °C.
performance-by-touch-alone = The lengths of this test are measured by touch alone.
performance-camera-off-articulation = The camera looks from a direction { $off } away from the wanted one (at most { $most }).
performance-cancelled-device = Cancelled: a device failed.
performance-cancelled-moved = Cancelled: the artefact or the arm moved.
performance-cancelled-operating = Cancelled: operating error, repeated.
performance-cancelled-other = Cancelled by the operator.
performance-cancelled-plan = Cancelled: plan, calibration or settings were changed.
performance-cannot-read = The entry of performance test { $one } cannot be read.
performance-cap-not-below-a = The cap B of the limit must not be smaller than A.
performance-change-temperatures = Change the temperatures
performance-choose-artefact =
    { $test ->
        [lengths] Choose a length standard first.
        [plane] Choose a plate first.
        [contact] Choose a sphere or a ball bar first.
       *[other] Choose a sphere first.
    }
performance-chose-bar = chose the ball bar
performance-clamp-seat =
    { $number ->
        [1] Clamp the seat near the shoulder, at no more than a fifth of the reach.
        [2] Clamp the seat at about half the reach.
       *[other] Clamp the seat at four fifths of the reach or farther.
    }
performance-confirm-temperatures = Confirm the temperatures
performance-confirmed-artefact = confirmed the artefact
performance-confirmed-step = confirmed a step
performance-contact-title =
    { $step ->
        [diameter] Sphere, measurement { $number }
        [seats] { $number ->
            [1] Near seat
            [2] Middle seat
           *[other] Far seat
        }
       *[bar] Placement { $number }
    }
performance-correct-gauge = Correct the file in the folder gauges, or choose another one.
performance-diameter-error = error of the diameter { $error }
performance-do-artefact-and-limits =
    { $test ->
        [lengths] Choose the length standard. Enter A, K and B from the datasheet if the lengths are to be judged.
        [plane] Choose the plate and lay it within the arm's reach. Enter the limit if its form is to be judged.
        [contact] Choose the master sphere and the ball bar, and fix the sphere in the middle of the arm's reach. What is not at hand is left out. Enter the limits from the datasheet if they are to be judged.
       *[other] Choose the test sphere and fix it within the arm's reach. Enter the limits from the datasheet if they are to be judged.
    }
performance-do-end = Touch the sphere five more times: they show whether it has moved.
performance-do-review =
    { $test ->
        [lengths] The errors of all lengths against the permissible error.
        [plane] The form of the plate by scan: the narrowest slab that holds 95 % of all points, in the worse orientation.
        [contact] Effective diameter, single-point articulation and volumetric length.
       *[other] Size, form and location of the sphere by touch, by scan, and both together.
    }
performance-do-temperatures = Measure the temperatures of artefact and arm once more. Those of the beginning are filled in; change what has changed, then confirm.
performance-drop-scan = Discard the scan
performance-dropped-scan = discarded a scan of the artefact
performance-dropping-scan = Discarding the scan
performance-editions = Standards
performance-end-scan = End the scan
performance-ended = Ended
performance-evaluating = Calculating the figures
performance-finish-scan-first = End or discard the running scan first.
performance-finished-scan = ended a scan of the artefact
performance-nothing-decided-standard-rocks = Nothing can be decided by lengths of a standard that rocks. Fix it and repeat the test.
performance-gate-points = Points of a scan take part if they lie within { $shell } of the surface of the calibrated sphere and within { $cone } of its pole ({ $pole }), and if the sensor sees that surface at no more than { $incidence } from its normal. All these points count; none is removed by its residual.
performance-go-on = Continue
performance-hold-sensor =
    { $number ->
        [1] Hold the sensor above the sphere, looking straight down. Begin the scan and move the stripe over the sphere.
        [2] Hold the sensor on the side away from the arm, tilted by about 45°. Begin the scan and move the stripe over the sphere.
        [3] Hold the sensor on the right as seen from the arm, tilted by about 45°. Begin the scan and move the stripe over the sphere.
        [4] Hold the sensor on the side of the arm, tilted by about 45°. Begin the scan and move the stripe over the sphere.
       *[other] Hold the sensor on the left as seen from the arm, tilted by about 45°. Begin the scan and move the stripe over the sphere.
    }
performance-is-closed = This test is closed. Begin a new one.
performance-is-evaluated = The figures are still being calculated.
performance-last-error = Error of the last length, { $length }
performance-leave-question = Cancel this test? It is kept and listed with the reason.
performance-judged-by-test-uncertainty = U is the test value uncertainty: that of artefact and set-up, not the scatter of arm and sensor, which is what the test measures.
performance-length-is-confirmed = The last length is confirmed by the first touch of the next one or by the first scan; its touches stand.
performance-lengths-and-scans = { $done } of { $of } lengths touched, { $scanned } of { $scans } scans
performance-lengths-done = All lengths are measured. Continue to the result.
performance-lengths-measured = { $done } of { $of } lengths
performance-let-temperatures-settle =
    { $when ->
        [end] No figure will be decided. Repeat the test once the temperatures are steady.
       *[begin] No figure will be decided. Let artefact and arm settle, and measure again.
    }
performance-measuring-bar-scan = Evaluating the scan of the bar: { $scan }
performance-measuring-plate-scan = Evaluating the scan of the plate in orientation { $number }
performance-measuring-scan = Evaluating the scan of articulation { $articulation }
performance-move-seat = Clamp the seat in its next place first
performance-move-sphere = Move the sphere to its second position, in another part of the arm's reach, and fix it. Then touch its top.
performance-no-artefact =
    { $test ->
        [lengths] There is no length standard in the folder gauges yet.
        [plane] There is no plate in the folder gauges yet.
        [contact] There is neither a sphere nor a ball bar in the folder gauges yet.
       *[other] There is no sphere in the folder gauges yet.
    }
performance-no-free-place = This touch is not near a place that is still free; it was not taken
performance-no-limit-entered = No limit is entered: the values are reported, not judged.
performance-no-scan-runs = No scan is running.
performance-no-way-back = What was measured stands: the test does not go back after its first touch or scan.
performance-nothing-to-test = There is nothing to test
performance-off-direction = The standard lies { $angle } off the drawn direction.
performance-only-lengths-have-choice = Only the test of lengths can be done by touch alone or by scan, too.
performance-orientation =
    { $number ->
        [1] Stripe at 45°
       *[other] Stripe turned by 90°
    }
performance-orientation-missing = The plate is not scanned in both orientations yet.
performance-other-calibration = The calibration in use has changed since the test began.
performance-pass-over-plate = Move the stripe slowly over the plate in strips side by side that overlap, then end the scan.
performance-pass-over-spheres = Move the stripe slowly over every sphere of the bar, from sides across the bar, then end the scan.
performance-pass-slowly = Move the stripe slowly over the whole sphere, then end the scan.
performance-patches =
    { $count ->
        [one] { $count } place of a scan is
       *[other] { $count } places of a scan are
    } the mean distances of all points within { $half } of the directions of the pattern.
performance-place =
    { $number ->
        [1] horizontal, away from the arm
        [2] horizontal, across, near on the left
        [3] horizontal, across, far on the right
        [4] vertical
        [5] inclined by 45°, across, on the left
        [6] inclined by 45°, away from the arm, on the right
       *[other] diagonal through the volume
    }
performance-place-bar = Set the bar up as placement { $number } is drawn ({ $words }), and clamp it.
performance-place-title = Place { $number } of 7
performance-placement =
    { $lies ->
        [away] horizontal, away from the arm
        [across] horizontal, across
        [up] vertical
        [rising-away] rising away from the arm
        [rising-left] rising to the left
        [rising-away-left] rising away from the arm to the left
       *[rising-away-right] rising away from the arm to the right
    }, { $at ->
        [near] near
        [far] far
       *[middle] in the middle
    }, { $side ->
        [left] { $bearing }° to the left
        [right] { $bearing }° to the right
       *[ahead] straight ahead
    }
performance-plan-changed = The plan of this test was changed after its first touch or scan.
performance-plan-is-frozen = Artefact and limits are fixed since the first touch or scan.
performance-plate-form = form { $form }
performance-plate-run = Plate, orientation { $number }
performance-plate-scan-done = The plate is scanned in orientation { $number }.
performance-plate-scan-name = Performance test, plate, orientation { $number }
performance-plate-scanned = The plate is scanned in both orientations.
performance-plate-scans-done = { $done } of { $of } orientations
performance-plate-width = { $width } wide
performance-put-back = Put the touch back
performance-repeat = Repeat the test
performance-repeat-question = Repeat the test? This run is kept and listed as repeated.
performance-repeat-scan = Scan { $number } again
performance-run = Position { $position }, scan of articulation { $articulation }
performance-run-dropped = Discarded by the operator while it was scanned.
performance-run-repeated = Repeated by the operator.
performance-seat-not-another = The tip is only { $away } away from an earlier seat; this touch was not taken
performance-scan-again = Scan this articulation again, slowly over the whole sphere
performance-scan-bar = Leave the standard as it is and scan the whole bar, { $repeat } of { $of }: all its spheres, from sides across the bar.
performance-scan-bar-again = Scan the bar again, slowly over every sphere
performance-scan-bar-first = Scan the bar in this place first.
performance-scan-done = Articulation { $articulation } is scanned.
performance-scan-is-measured = The last scan is still being evaluated.
performance-scan-length-alone = Two pairs of spheres are { $length } apart. Leave the standard as it is and scan only the two spheres of this length.
performance-scan-missing = Scan the articulation on whose side they lie again.
performance-scan-name = Performance test, articulation { $articulation }
performance-scan-plate =
    { $number ->
        [1] Turn the sensor so that the stripe lies at about 45° to the edges of the plate or to the axes of the arm. Begin the scan. From here on, plate and limit are fixed.
       *[other] Turn the sensor about its line of sight, so that the stripe lies across its direction in the first scan. Begin the scan.
    }
performance-scan-plate-again = Scan this orientation again
performance-scan-shows = { $patches } of 25 patches, { $points } points
performance-scan-too-small = The scan covers only { $count } of the sphere's 25 patches
performance-scanned-length = { $length } (error { $error })
performance-scans-done = { $done } of { $of } articulations
performance-put-arm-json = Put the arm’s arm.json, with its serial number and tip, into the folder arms
performance-seat-has-no-certificate = The seats have no certified size, so the test value uncertainty of the single-point articulation is 0: play and movement of a seat count as errors of the arm.
performance-seat-largest = largest distance { $largest }
performance-seat-not-far = The far seat stands at { $share } % of the reach; the standard asks for at least { $least } %.
performance-seat-not-near = The near seat stands at { $share } % of the reach; the standard asks for at most { $most } %.
performance-seat-share = at { $share } % of the reach
performance-set-by-scan = chose touch or scan
performance-set-is-invalid = What was measured belongs to the old state and is invalid as a test. Begin again; the data are kept.
performance-set-positions = chose how many positions
performance-set-standard-up = Set the standard up as drawn: { $place }. Fix it. { $text }
performance-settings-changed = The settings for scans were changed after the first touch or scan of this test.
performance-single-values =
    { $test ->
        [plane] The orientations
       *[contact] Master sphere, seats and placements
    }
performance-simulation-contacts = The simulated operator touches { $done } of { $of }
performance-simulation-scans = The simulated operator scans articulation { $articulation }
performance-simulation-scans-bar = The simulated operator scans the bar in place { $place }, scan { $repeat }
performance-simulation-scans-plate = The simulated operator scans the plate in orientation { $number }
performance-simulation-touches =
    { $test ->
        [lengths] The simulated operator touches the length standard: { $done } of { $of }
       *[other] The simulated operator touches the sphere: { $done } of { $of }
    }
performance-sphere-touch-not-taken = The sphere was touched near there already; this touch was not taken
performance-standard-lengths =
    { $kind ->
        [step-gauge] Step gauge
       *[other] Bar
    }, { $count ->
        [one] one length, { $longest }
       *[other] { $count } lengths, { $shortest } to { $longest }
    }
performance-step-artefact = Artefact and limits
performance-step-bar = Ball bar
performance-step-diameter = Master sphere
performance-step-end = Touch again
performance-step-lengths = Lengths
performance-step-location = Location by touch
performance-step-pattern = 25 touches
performance-step-plate = Two scans
performance-step-scan = Five scans
performance-step-seats = Three seats
performance-step-temperatures = Temperatures
performance-stylus-off-articulation = The stylus is { $off } away from the wanted direction (at most { $most }).
performance-symbol = Symbol
performance-temperature-not-stated = The artefact's temperature was not stated: sizes and lengths are taken as at 20 °C, and their uncertainty does not contain the temperature.
performance-test =
    { $kind ->
        [lengths] Performance test: lengths
        [plane] Performance test: plane
        [contact] Performance test: contact tests
       *[sphere] Performance test: one sphere
    }
performance-test-under-way-go-where-stands = A performance test is in progress. Continue where it stopped.
performance-touch-bar = Touch the { $end ->
        [1] first
       *[other] second
    } sphere of the bar at { $touches } places all around.
performance-touch-bar-first = Touch all lengths of this place first.
performance-touch-ends-of-length = Touch the other end of the length that is named
performance-touch-length =
    Length { $length }, repeat { $repeat } of { $of }: { $kind ->
        [face] touch { $end ->
            [1] the first face
           *[other] the second face
        }. Touch both in the same direction and at the same height and side.
       *[sphere] touch { $end ->
            [1] the first sphere
           *[other] the second sphere
        } in { $touches } places all around.
    }
performance-touch-location =
    { $number ->
        [1] Hold the wrist above the sphere, with the stylus pointing straight down. Touch the top and four places around it without turning the stylus.
        [2] Tilt the stylus by about 45°, wrist on the side away from the arm. Touch the five marked places without turning the stylus.
        [3] Tilt the stylus by about 45°, wrist on the right as seen from the arm. Touch the five marked places without turning the stylus.
        [4] Tilt the stylus by about 45°, wrist on the side of the arm. Touch the five marked places without turning the stylus.
       *[other] Tilt the stylus by about 45°, wrist on the left as seen from the arm. Touch the five marked places without turning the stylus.
    }
performance-touch-master = Touch the sphere at its top and at eight places around it: measurement { $number } of { $of }.
performance-touch-off-seat = The tip is { $off } away from the touches before: it is not in the seat. This touch was not taken
performance-touch-off-sphere = This touch lies { $off } off the sphere that was touched before; it was not taken
performance-touch-pattern = Touch the marked places in any order, with the wrist turned freely. The nearest free one is highlighted.
performance-touch-place = Touch place { $number } of the drawing
performance-touch-same-seat = Put the tip into the seat, or remove the contact point before if that one is wrong
performance-touch-same-sphere = Touch the same sphere, or take its touches back and begin again
performance-touch-seat = Put the tip into the seat and take { $count } touches. Between the touches move the elbow and turn the wrist, over both sides.
performance-touch-sphere-elsewhere = Spread the touches over the sphere
performance-touch-taken =
    { $test ->
        [lengths] Touch { $count } of the lengths
        [contact] Touch { $count } of this step
       *[other] Touch { $count } on the sphere
    }
performance-touch-top-first = Touch the top of the sphere first; the other places follow from it. From here on, sphere and limits are fixed.
performance-touches-missing =
    { $missing ->
        [one] One touch is missing.
       *[other] { $missing } touches are missing.
    }
performance-turn-sensor = Turn the sensor about its line of sight and scan this orientation again
performance-turn-standard = The seven places only cover the arm's volume if the standard lies about as drawn.
performance-turn-towards-articulation = Turn the wrist until this message disappears; points taken otherwise are noted in the result
performance-valid-until = certificate valid until { $until }
performance-values-against-limits = Values as shares of their maximum permissible errors, with the test uncertainty (k = 2) as a bar. The filled dot is the value that counts; open dots are the single values that it follows from.
pictures-were-taken-with-other-sensor = Pictures were taken with another sensor. Begin a new calibration for this one.
places-of-hemisphere =
    { $title }, seen from the pole: { $count ->
        [one] { $count } place
       *[other] { $count } places
    } with the distance from the least-squares sphere in µm, blue inside, orange outside, at most { $largest }. The circles lie at 22.5°, 45°, 67.5° and 90° from the pole.
plate = Flat artefact
plate-by-certificate = flat to { $flatness }
plate-orientations-alike = the sensor was turned by only { $turn } between the two orientations; { $least } are needed
plate-scan-too-few-points = the scan has only { $count } points; { $least } are needed
plate-too-narrow = the plate is { $width } wide; { $least } are needed
point-judged-with-guard =
    For a feature given by a single scanned point, the guard band is { $guard } ({ $guard_mm }): { $bearer ->
        [supplier] the feature conforms only if the point lies inside its tolerance by more.
        [user] the feature fails only if the point lies outside its tolerance by more.
       *[prover] conformance is proven if the point lies inside its tolerance by more, nonconformance if it lies outside by more.
    }
point-judged-without-guard = A feature given by a single scanned point conforms if the point lies inside its tolerance.
points-in-gate = Points
points-outside-gate = Points outside
pose-repeats = the arm reports the same pose again and again
poses-equal-to-last-digit = its poses always showed noise, and now they are equal to the last digit: it sends an old pose
qif-not-validated = this file is written after the schema of QIF 3.0, but was not validated against it
quaternion-must-be-unit = its last four numbers must be a unit quaternion, w first
range-all-m = Range of all, µm
range-all-points-in-gate = Range of all points
raw-bayer-has-one-channel = a raw Bayer picture (bayer) has one channel
recording-has-no-sensor-named = { $path } has no sensor named { $name }
recording-has-one-sensor = { $path } is a recording of one sensor
recording-has-sensors = { $path } is a recording of several sensors ({ $names })
restart-robot-controller = Restart the controller of the arm.
restore-tool-and-coordinate-system = Select the former tool and coordinate system at the arm, or calibrate with the new ones.
robot-cannot-be-reached = The robot at { $where } cannot be reached: { $reason }
robot-clock-jumped = The clock of the arm at { $address } has jumped: its controller was restarted or its time was set
robot-closed-connection = The robot at { $address } closed the connection
robot-does-not-answer = There is no response from { $where }
robot-frames-changed = The pose of the robot at { $address } has leapt by { $step } and { $turn } while no joint moved: another tool or base frame is active
robot-host-not-known = There is no host with the name { $address }
robot-link-closed = The connection to the robot at { $address } is closed
robot-link-lost = The connection to the robot at { $address } was lost: { $reason }
robot-quaternion-not-unit = The arm at { $address } sends an orientation that is no rotation: its quaternion has the length { $length }
reports-poses-no-tip = reports poses, no tip
robot-no-program-listens = No program listens at { $where }
robot-said = { $text }. The robot reports: { $said }
robot-select-former-frames = Select the former tool and base frame on the controller. The connection opens again by itself.
robot-sends-no-numbers = The arm at { $address } sends values that are no numbers, or impossibly large
robot-sends-nothing = The arm at { $address } has sent nothing new for { $time }
robot-sends-only-useless = For { $time }, the arm at { $address } has sent only packets that cannot be read or repeat the last one ({ $count })
robot-sends-not-from-address = What arrives at UDP port { $port } comes from { $sender }, not from the robot at { $address }
robot-sends-nothing-to-port = The robot at { $address } sends nothing to UDP port { $port } of this computer
ros2-nothing-of-chain-moves = Nothing between { $base } and { $tool } moves: { $topic } has no transform of this chain
ros2-check-publisher = Check that the node that publishes it runs, and that both have the same ROS_DOMAIN_ID and middleware (RMW_IMPLEMENTATION).
ros2-check-transform-node = Check the node that publishes this transform.
ros2-failed = ROS 2 refuses the subscription to { $topic }: { $reason }
ros2-frame-changed = The poses of { $topic } are now in the frame { $frame } instead of { $expected }
ros2-frames-are = Correct parent_frame and child_frame; the frames are { $names }.
ros2-joints-are = Correct joint_names; the joints are { $names }.
ros2-lacks-joint = The messages of { $topic } have no joint { $name }
ros2-needs-joint-names = Name five to seven joints, base joint first.
ros2-no-chain = No transforms of { $topic } lead from { $base } to { $tool }
ros2-no-stamp = The messages of { $topic } have no time stamps
ros2-not-found = ROS 2 is not installed here, or its environment is not set up: { $reason }
ros2-nothing-published = Nothing is published on { $topic } as { $kind }
ros2-parent-changed = The frame { $frame } of { $topic } is now in { $parent } instead of { $expected }
ros2-same-frames = parent_frame and child_frame are both { $frame }
ros2-source-setup = Source the setup file of ROS 2 (source /opt/ros/…/setup.bash) in the shell that starts the program, with the Python of ROS 2.
ros2-topics-are = Correct topic; topics of this kind are { $names }.
ros2-transform-stale = The transform from { $parent } to { $child } of { $topic } is { $behind } behind the others
ros2-use-arrival = Let the publisher set header.stamp, or add stamps = "arrival", which is less accurate in motion.
same-camera-both = both come from one camera, in one mode
scanned-centres-of-position = By scan, position { $position }
scanned-places-of-position = Scanned sphere, position { $position }
search-again-for-devices = Search again; if that does not help, check network and cables.
selected-sensor = selected a sensor
sensor-calibrated = { $name }: { $calibration }, { $total } (k = 1)
sensor-cannot-be-selected-now = another sensor cannot be selected now
sensor-left-out =
    { $count ->
        [one] one frame
       *[other] { $count } frames
    } of the sensor { $name } left out: no calibration was given for it
sensor-sends-lines-no-pictures = the sensor sends laser lines and no pictures
sensor-without-calibration = { $name }: not calibrated yet
sensors-line-lists-differ = the points of the sensor's line are incomplete
set-sensor-send-pictures = set the sensor to send pictures, or use another sensor
set-stripe-axis = Set stripe_axis to { $axis } in the sensor's datasheet, and calibrate again.
shows-arm-joints = form of the touched sphere; single-point articulation
shows-arm-links = errors of length; location over articulations, by touch as well as by scan; size where the stylus tilts outward
shows-clock = form and dispersion of the scanned sphere; they grow with the speed of scanning
shows-laser-plane = form of the scanned sphere and plane; size of the scanned sphere
shows-probe-matrix = location of the scanned sphere: up to 2 d along an axis that the articulations tilt, less along one that keeps its direction; its size, and its distance from the touched sphere
shows-sensor-scale = size of the scanned sphere, by a part of it
shows-stripe-noise = dispersion of 95 % of all points
shows-tip-diameter = size of the touched sphere; effective diameter
sign-in-ask-for-group = Ask an administrator of the provider for a group with access
sign-in-begin-again = Begin the sign-in again
sign-in-cancelled = The sign-in with { $name } was cancelled or denied
sign-in-certificate-not-trusted = The certificate of { $name } is not valid, or not trusted here
sign-in-check-clocks = Ask an administrator to set the clocks of this server and of the provider
sign-in-check-issuer = Ask an administrator to check issuer in [sign_in] of the settings
sign-in-code-refused = { $name } no longer accepts this sign-in
sign-in-correct-secret = Ask an administrator to correct the client secret; until then, sign in without the provider
sign-in-give-ca-file = Sign in without the provider, and ask an administrator to give the provider's authority as ca_file in [sign_in]
sign-in-health = Sign-in with accounts of the plant
sign-in-health-remedy = Accounts of this station can sign in. Check the network, the provider and [sign_in] of station.toml
sign-in-health-why = Without the provider, only accounts of this station can sign in; who is signed in stays so.
sign-in-map-claim = Ask an administrator to correct name_claim in [sign_in], or to let the provider send it
sign-in-name-secret-file = Name a file that holds the client secret alone as client_secret_file in [sign_in]
sign-in-no-group = { $person } is in no group of { $name } that may sign in here
sign-in-no-name = { $name } does not say who signed in: the claim { $claim } is missing
sign-in-no-provider = There is no provider of accounts here
sign-in-not-pending = This sign-in was not begun in this browser, is too old, or was used already
sign-in-not-registered = { $name } does not accept the client ID or the redirect URI of this server
sign-in-other-issuer = { $name } states another issuer than the settings here
sign-in-provider-answers = { $name } answers.
sign-in-provider-away = { $name } cannot be reached
sign-in-provider-unusable = { $name } does not answer like a provider of OpenID Connect
sign-in-refused = { $name } refused the sign-in ({ $error })
sign-in-register = Ask an administrator to register { $address } as a redirect URI of the client { $client }
sign-in-not-signed-by-provider = The answer to the sign-in is not signed by { $name }
sign-in-tell-administrator = Tell an administrator, and sign in without the provider
sign-in-token-expired = The answer of { $name } is expired, or dated in the future
sign-in-token-foreign = The answer of { $name } was made for another sign-in or another client
sign-in-too-many = Too many people are signing in with { $name } at this moment
sign-in-use-local-account = Sign in without the provider, or try again later
sign-in-wrong-secret = { $name } does not accept the client secret of this server
signed-in-with = signed in with { $name }
silent-but-there = The { $title } is connected and waits for a trigger or a change
simulated-sensor-cannot-deliver = The simulated sensor cannot deliver that
simulation-goes = The simulated operator moves to { $name }
simulation-goes-next-pose = The simulated operator moves to the next pose: { $words }
simulation-holds-sensor-over-object = The simulated operator holds the sensor over the object
simulation-holds-still = The simulated operator holds still
simulation-not-moving = The simulated operator is not moving.
simulation-scanning = The simulated operator is scanning
simulation-scans = The simulated operator scans the { $part }
simulation-scans-cloud = The simulated operator scans the { $name }, cloud { $done }
simulation-swings-arm-about = The simulated operator swings the arm about { $name }
simulation-touches = The simulated operator touches: { $face }
simulation-touches-gauge = The simulated operator touches the { $name }
simulation-touches-sphere = The simulated operator touches the sphere
simulation-work = The simulated operator is running
hands-point-face-declined-times = Point { $index } { $where } of the simulated operator was rejected { $attempts } times
hands-touch-declined-times = Contact point { $index } of the simulated operator was rejected { $attempts } times
has-control = { $name } has control
has-control-in-another-browser = { $name } has control in another browser
has-control-now = { $name } has control now.
has-coordinate = { $path } has a coordinate of { $coordinate }
joint-columns-or-none =
    { $count ->
        [0] { $path } has no joint columns
        [one] { $path } has { $count } joint column ({ $names })
       *[other] { $path } has { $count } joint columns ({ $names })
    }
has-mm =
    { $kind ->
        [bar] The length of a bar is { $low } to { $high }.
       *[sphere] The diameter of a sphere is { $low } to { $high }.
    }
has-points = { $label } has { $count } points
has-touches =
    { $shape ->
        [sphere] The sphere has { $count } contact points
       *[plane] The plane has { $count } contact points
    }
have-arms-calibration-checked-hold-compact = Have the arm's calibration checked; hold the arm in a compact posture.
height-above-touched-plane-along-z = Height above the touched plane, along Z
height-of-level =
    { $level ->
        [base] the height of its base
        [floors] the height of its floors
       *[crests] the height of its crests
    }
held-out-places-fit-did-see = Cross-validation on { $places } places that the fit did not use, { $how }; the encoders' noise is included. In standard deviations of the points: { $before } before and { $after } after, where 1 is noise alone.
held-out-turn = each left out in turn
held-up-live-numbers-stand-press = During a delay, live numbers freeze and buttons respond late; the devices are still read.
held-up-more-than-longest =
    { $count ->
        [one] delayed once by more than { $limit }, for { $longest }
       *[other] delayed { $count } times by more than { $limit }, for up to { $longest }
    }
high-up = high
higher-by = { $distance } higher
hold = Hold
keep-this-pose = keep this pose
hold-arm-still = Hold the arm still. { $text }.
hold-the-arm-still = Hold the arm still.
hold-sensor-over-object = Hold the sensor over the object
hold-sensor-over-object-another-way = Hold the sensor over the object in a new pose.
hold-sensor-over-object-so-lies = Hold the sensor over the object so that it matches the dashed outline.
hold-sensor-straight-above-chessboard-longer = Hold the sensor straight above the chessboard, with the longer side of the board along the picture.
hold-still = Hold still
hold-still-again = repeat it and hold the arm still
hold-still-take-picture-laser-switches = Hold still and take the picture. The laser switches automatically.
hold-there = Hold it there
holds-journal-every-step-accounts-what = It contains the journal of every step, the accounts, and the selection of the calibration in use.
holds-more-than-frames = { $path } contains more than { $most } frames
holds-no-record-one = it contains no record
holds-no-topics = { $path } contains no topics
holds-topics = { $path } contains { $topics }
host-not-known = The host in { $url } is not known
how-arm-swung = Swing of the arm
how-sensor-sits-flange-shows-only = the mounting of the sensor on the flange shows only when the flange rotates: at least three poses about two different axes are required
http-status = status { $status }
identification-arm = Identification of the arm
identified = Identified
identified-arm-use = The identified arm is in use.
identify-arm = Identify the arm
identify-arm-first = Identify the arm first.
identify-arm-folders-again = Run the identification again with the folder's { $arm }
identify-arm-take-more-know-better = Identify the arm, or add places to determine it better.
identifying-arm = Identifying the arm
image-encoding = { $name }: encoding { $encoding }
image-ends-after-bytes =
    { $name } ends after { $bytes ->
        [one] { $bytes } byte
       *[other] { $bytes } bytes
    }
image-has-depth = { $name } has { $depth }
image-has-pages = { $name } has more than one page
image-has-pixels = { $name } has { $width } × { $height } pixels
image-in-colour = { $name } is in colour
image-processing = Image processing
image-shape-type = a picture of shape { $shape } and type { $dtype }
inner-corners-mm-apart = { $columns } × { $rows } inner corners, { $square } apart, { $known }
inputs = Inputs
install-extra = Install it with pip install "crenel[{ $extra }]"
install-gentl-producer = Install the software of the camera's vendor, and set producer to its file with the ending .cti
install-system-package = Install the system's package { $package } (apt install { $package })
install-version-later-one = Install that version or a later one
instrument-moved-or-angles-of-other-pose = the instrument moved, lost its marker, or the joint angles belong to other poses
instrument-or-base-moved = the instrument or the arm's base moved, or the points come from two set-ups
is-file-complete = Check that the file is complete.
is-it-a-complete-video = Check that it is a complete video.
is-it-there-and-complete = Check that it exists and is complete.
is-no-station-database = { $path } cannot be read as a station database
is-of = { $path } belongs to { $device } { $of }
is-to-be-verified =
    { $shape ->
        [sphere] the gauge to be verified is a sphere
       *[plane] the gauge to be verified is a plane
    }
it-is-a-file = it is a file
it-is-a-folder = it is a folder
it-is-no-ordinary-file = it is a pipe, a socket or a device
joint = Joint
joint-adjustment-all-poses = joint adjustment of all poses
joint-angle-not-a-number = { $name }: a joint angle is not a number
joint-angles = { $name }: { $count } joint angles
joint-angles-given-degrees = joint angles are given in degrees
joint-at-stamp = { $path } at { $stamp_ns } ns: joint { $joint } is at { $reading }
joint-column-differs = q{ $joint }_deg differs by { $moved }
joint-jumped-stayed-there = joint { $joint } jumped by { $step } and stayed there
joint-name-twice = two joints are named { $name }; recordings identify joints by name
joint-range = its range is { $low } to { $high }
joint-range-in-radians = its range is { $low } to { $high }; these are degrees, but radians are expected
joint-reads = joint { $joint } reads { $reading }
joint-reads-again-again = joint { $joint } reads { $reading } repeatedly
joint-reads-no-number = the reading of joint { $joint } is not a number
joint-reads-off-readings-before-after = joint { $joint } reads { $reading }, { $step } off its readings before and after
joint-reads-same-all-points = joint { $joint } reads the same in all points
joint-reads-where-can = joint { $joint } reads { $reading }, { $step } away from where it can be
joint-samples-left-out-cannot-true =
    { $count ->
        [one] { $count } implausible arm reading excluded, { $first } from the start: { CLAUSE($error) }
       *[other] { $count } implausible arm readings excluded, the first { $first } from the start: { CLAUSE($error) }
    }
joint-samples-left-out-numbers =
    { $unusable ->
        [one] { $unusable } arm reading excluded: not a number
       *[other] { $unusable } arm readings excluded: not numbers
    }
journal-has-rows-cannot-read-first =
    { $count ->
        [one] The journal has { $count } unreadable row, row { $first }.
       *[other] The journal has { $count } unreadable rows, the first is row { $first }.
    }
json-cut-off = it is not JSON, or is incomplete: { $reason }
json-cut-off-line = it is not JSON, or is incomplete: { $reason } in line { $line }
json-object-expected = a JSON object { "{" } … { "}" } is expected
not-judged = Not assessed
keep-arm-json-use = Keep the arm.json that is in use
keep-data-folder-start-earlier-backup = Leave the data folder as it is, and start from an earlier backup
keep-line-off-outermost-corners = move the laser line off the board's outermost corners
keep-reflections-out-grooves-matt-spray = Avoid reflections in the grooves: use matt spray, or lower the exposure.
keep-tip-seat-swing-elbow-one = Keep the tip in the seat. Swing the elbow from one side to the other and back, and tilt the wrist in every direction.
keeps-control = { $name } keeps control.
unchanged = Unchanged
kept-picture = kept the picture
kind-chessboard-not-supported = { $path }: kind 'chessboard' is not supported here
kind-is-block-or-board = it is 'crenellated', 'chessboard' or 'charuco'
kind-unknown = { $path }: kind { $kind } is unknown
known-k-1 = uncertainty { $known } (k = 1)
known-limit-is = { $known }; the limit is { $limit }
known-m-k-1-form-m = { $certificate }; uncertainty { $known } (k = 1), form { $form }
largest-distance = Largest distance
largest-distance-touch-sphere = Largest distance of a contact point from the sphere
largest-half-range = Largest (max − min)/2
largest-swing = { $points }, largest swing { $swing }
laser-beside-object-may-too-dark = The laser is on. Away from its line the object may be too dark to be detected.
laser-colour-not-known = the laser's colour, whose channel would be measured, is not stated
laser-did-not-switch-on = The laser did not switch on: this picture determines only camera and mounting.
laser-line-covers-others = the laser line covers the others
laser-line-left-out-off-plane = its laser line was excluded, { $off } off the plane of the others
laser-line-lies-off-plane-others = its laser line lies { $off } off the plane of the others
laser-off = the laser is off
the-laser-is-off = The laser is off
laser-off-covered-beside-object-too = the laser is off, covered, not on the object, or too weak for this exposure
laser-off-too-weak-does-cross = the laser is off, too weak, or does not cross the object
laser-off-too-weak-part-out = the laser was off or too weak, or the part was out of range
laser-on-or-expose-longer = Switch on the laser, or expose longer
laser-plane = Laser plane
laser-stripe-sensor-measuring-arm = Laser stripe sensor on a measuring arm
laser-stripe-shows-points-s =
    { $missing ->
        [crest] the laser stripe has { $count } points on the crests
       *[floor] the laser stripe has { $count } points on the floors
    }
laser-wavelength = laser { $wavelength }
lasers-line-lies-board-pictures = the laser line lies on the board in { $enough } of { $views } pictures
lasers-line-lies-one-place-plane = the laser line is at the same position in its plane in all pictures
lasers-line-must-cross-chessboard = The laser line must cross the chessboard in at least { $fewest } pictures, better in every one.
lasers-line-pose-lies-off-plane = The laser line of pose { $number } lies { $off } off the plane of the others and was excluded.
lasers-lines-poses-lie-off-plane = The laser lines of poses { $poses } lie { $off } off the plane of the others: the laser moved relative to the camera, and these lines were excluded.
laser-moved-by-lines-off-plane = The laser lines of poses { $poses } lie { $off } off the plane of the others: the laser moved relative to the camera, and all lines are used.
laser-lines-off-their-plane = the laser lines of poses { $poses } lie { $usual } off their best-fitting plane
lasers-lines-poses-lie-up-off = the laser lines of poses { $poses } lie up to { $most } off one plane
lasers-plane-stands-board-limit = the angle between laser plane and board is { $angle } (limit { $least_laser_angle_deg })
last-cloud-not-evaluated-yet = The last cloud is not evaluated yet.
last-days-old = The last backup is { $days } days old, in { $place }.
last-days-old-same-disk = The last backup is { $days } days old, in { $place }. It is on the same disk as the data.
last-row-must-0-0-0 = the last row of { $name } must be 0 0 0 1
last-verification-older-than-calibration = The last verification is older than this calibration.
least-middle-needed = at least { $angle } from its centre are required
least-needed = at least { $least } are required
least-needed-each-three-non-parallel = at least { $least } are required on each of three non-parallel faces
least-needed-tell-arms-errors-own = at least { $least } are required to separate the arm's errors from the centre of the place
least-needed-to-know-frame = at least { $least } are needed to know where the instrument stood
least-places-taken = { $places_taken } of at least { $seats_least } places are taken.
least-seats-spheres-bar-positions-needed = at least { $least_places } seats, spheres and bar positions are required, so that some are left for cross-validation
leave-bar-where = Leave the bar in its position.
leave-session-unused-points-kept = Cancel this session? Points that were not used yet are kept.
leave-verification-clouds-kept-folder = Cancel this verification? Its clouds are kept in its folder.
left = to the left
left-end = Left end
left-out = Excluded: { $reason }
excluded-because-within-sentence = excluded: { $reason }
excluded-for-reason = Excluded: { CLAUSE($text) }.
left-right-corners-were-exchanged-image = left and right corners are swapped, or the picture is flipped
length = length { $longer }
length-another-bar-another-unit-ends = the length is that of another bar or in another unit, or the ends do not belong to this bar
lengths-ball-bars-held-out = Lengths of ball bars, cross-validated
lengths-of-bars-contradict = the lengths of the bars { $bars } contradict each other by { $off }; it is not certain which of them is wrong
less-than-minute = less than a minute
less-than-pictures-edges-wide = { $text }, less than the edge width of { $width } in the picture
let-each-station-write-under-own = Let each station publish only under its own topic, and remove the retained messages of others from the broker.
let-go-control = released control
let-simulation-do = Let the simulated operator do it
let-simulation-do-everything = Let the simulated operator do everything
let-kept-time-server-which-moves = Synchronise it with a time server, which adjusts it gradually.
let-laser-come-rest-take-pictures = Let the laser settle, and take the pictures again.
let-laser-warm-up-check-mount = Let the laser warm up, check its mount, and take the pictures again.
let-line-cross-board-in-more-pictures =
    { $more ->
        [one] take one more picture in which the line crosses the board
       *[other] take { $more } more pictures in which the line crosses the board
    }
so-many-values =
    { $count ->
        [one] { $count } value
       *[other] { $count } values
    }
sphere-by-certificate = { $diameter } in diameter, known to { $known } (k = 1), form { $form }
sphere-gives-way =
    at position { $position }, the sphere or the tip gives way while it is touched { $part ->
        [pattern] in the 25 places
        [location] in the articulations
       *[end] at the end
    }: the touches scatter by { $scatter }, the points of the scans by { $expected }
sphere-moved = Moved by
sphere-position = Position
standard-uncertainty-k-1 = u, k = 1
started-pictures-by-themselves = had pictures taken by themselves
started-simulation = started the simulated operator
lies-face = it lies { $where }
lies-no-face-all = it lies on no face
lies-where-certificate-puts = { $edge } lies { $distance } from its position in the certificate
light-block-evenly-sharp-large-picture = Light the block evenly; show it sharp and large in the picture.
light-board-evenly-sharp-large-picture = Light the board evenly; show it sharp and large in the picture.
light-front-above-so-crests-floors = light it from the front and above so that crests, floors and front differ, move closer, and remove what is in front of it
limit-of-figure = limit { $limit }
limit = Limit
limit-is = The limit is { $limit }.
limit-is-value = the limit is { $limit }
limit-k-1 = Limit, k = 1
limit-with-expanded-uncertainty = limit { $limit }; U = { $expanded_uncertainty }, k = 2
limit-mark = limit
limit-number-micrometres-1-100-000 = The limit must be 1 to 100 000 micrometres.
limits-deg-must-ascend = { $limits } of { $name } must ascend
line-brightness = Line brightness
line-gives-other-length = line { $line } states { $length } for the same { $label }
line-gives-other-place = line { $line } states another one
line-saturated = Line saturated
line-to-arm-closed = The connection to the arm at { $url } is closed
line-to-arm-gone = The connection to the arm at { $url } was lost
line-to-arm-lost = The connection to the arm at { $url } was lost ({ $reason })
line-too-bright-saturated = Line too bright: { $clipped } saturated
line-too-dark = Line too dark: { $level }
lines-along-other-axis =
    { $pictures ->
        [one] in one picture, --axis { $better } finds { $other } points and --axis { $axis } { $found }
       *[other] in { $pictures } pictures, --axis { $better } finds { $other } points and --axis { $axis } { $found }
    }: the line runs along the other axis. Give --axis { $better }
lines-run-along-other-axis =
    { $axis ->
        [u] The laser lines run down the pictures, but one point for each column is measured, so that most of them is lost.
       *[v] The laser lines run across the pictures, but one point for each row is measured, so that most of them is lost.
    }
link-no-longer-valid = This link is no longer valid.
link-leads-itself = it is a link that points to itself
linux-add-user-group-owns-port = On Linux, add the user to the group that owns the port (often dialout).
lists-stripe-differ-length = the lists of a stripe differ in length
load-page-again = Reload the page.
log = Log
log-broker-connected = connected to the broker at { $host }:{ $port }
log-broker-lost = the connection to the broker was lost: { $reason }
log-cannot-written-health-page-says = The log cannot be written; see the Health page.
log-event-loop-goes-on = the event loop continues after { $duration }
log-event-loop-held-up = the event loop is blocked for more than { $limit }
log-file-not-used = { $file } is not used: { $reason }
log-has-what-held-up-send = The log states the cause; send the support bundle if it happens again.
log-lines-lost =
    { $count ->
        [one] one line of the log was lost because the disk was too slow
       *[other] { $count } lines of the log were lost because the disk was too slow
    }
log-loop-failed = the loop { $name } failed; it is restarted, and this error is not logged again until it works
log-loop-goes-on = the loop { $name } goes on after { $stood }
log-loop-refused = the loop { $name } failed and is restarted: { CLAUSE($reason) }
log-loop-stands = the loop { $name } has stood still for { $stood } in { $where }
log-loop-works-again = the loop { $name } works again
log-not-saved = { $method } { $path } was not saved: { $reason }
log-notification-not-delivered = a notification was not delivered: { $reason }
log-program-stood-still = the whole program was suspended for { $duration }
log-repeated = ({ $count } of these since { $since })
log-thread-died = { $name } was ended by an error
logo-cannot-be-used = it is no PNG or JPEG of at most { $largest }
logs-cannot-written = The logs in { $folder } cannot be written
look-change = Inspect the tip, and replace it.
look-last-message-let-simulation-try = Check the last message, and let the simulated operator try again
look-log-below-send-support-bundle = Check the log below, and send the support bundle to your support.
look-numbers-then-accept-calibration-repeat = Check the figures, then accept the calibration or repeat it.
check-current-step = Check the current step and act on it
look-them-below-send-support-bundle = Check the errors below, and send the support bundle.
looked-arms-delay = determined the arm's delay
looked-pose = Pose { $number } evaluated
looking-delay = Determining the delay
looking-object-picture = Detecting the object in the picture
loop-fails-now =
    { $count ->
        [one] Fails now and is tried again: { $part } ({ CLAUSE($error) }).
       *[other] Fails now and is tried again, { $count } times so far: { $part } ({ CLAUSE($error) }).
    }
loop-goes-on = Stood still for { $stood } until { $ago } ago, and goes on: { $part } (in { $where }).
loop-name =
    { $name ->
        [rig-state] state of the devices
        [scan-state] state of the scan
        [scene] drawing of the 3D view
        [view] state of the 3D view
        [pulse-trigger] trigger pulses
        [arm-reader] reading of the arm
        [sensor-reader] reading of the sensor
        [awake] clock of the program
        [preview] live picture
        [object-watch] detection of the object
        [device-trial] trial of a device
        [loop-watchdog] watch over the event loop
        [hang-watch] watch for loops that stand still
        [log-writer] writing of the log
        [archive] archiving
        [scan-sync] syncing of the recording
        [live-state] guided sessions and Home
        [report] report of the station
        [unattended] watch over unattended scans
        [stations] other stations
        [events] passing on of events
        [health] health checks
        [temperature] reading of the temperature
        [notifications] notifications
        [broker] connection to the broker
       *[other] { $name }
    }
loop-stands-now = Has stood still for { $stood }: { $part } (in { $where }).
loop-works-again =
    { $count ->
        [one] Failed { $ago } ago, was restarted and works: { $part } ({ CLAUSE($error) }).
       *[other] Failed { $count } times, last { $ago } ago, was restarted and works: { $part } ({ CLAUSE($error) }).
    }
losses =
    { $device ->
        [arm] Lost data of the arm
       *[sensor] Lost data of the sensor
    }
lost-garbled-last-ten-minutes = { $missing } of { $total } lost or corrupted in the last ten minutes ({ $share }).
lost-reconnecting = The connection to the { $title } was lost; reconnecting
low-down = low
lower-by = { $distance } lower
lower-limit-not-below-upper = The lower limit is not below the upper
made-first-administrator = created the first administrator
made-simulated-hardware-demonstration = Made on simulated hardware: a demonstration.
made-token-metrics = created a metrics token
length-below-spheres = the length of { $length } is less than the diameter of the spheres, { $diameter }: one of them is mistyped
length-beyond-reach = the length standard is { $length } long, and the arm reaches { $reach } only
lengths-are-missing = only { $count } of { $wanted } lengths were measured: each in { $places } places, { $repeats } times
lengths-of-no-arm = a_mm and d_mm of all joints together are { $length }: these are inches or centimetres, but millimetres are expected
lengths-of-smaller-unit =
    { $unit ->
        [m] these are millimetres where metres are expected
       *[mm] these are micrometres, or other than millimetres
    }
lengths-of-unit-expected-mm =
    { $unit ->
        [m] these are metres, but millimetres are expected
        [cm] these are centimetres, but millimetres are expected
       *[inch] these are inches, but millimetres are expected
    }
length-standard-rocks =
    { $of ->
        [places] the standard rocks in place { $place }: repeats of a length scatter by { $scatter }, in steady places by up to { $expected }
       *[touches] the standard rocks in place { $place }: repeats of a length scatter by { $scatter }, touches by { $expected }
    }
made-kiosk-link = created a kiosk link
make-backup-another-disk = Make the backup on another disk
make-one-below-crenel-backup = Make a backup below, or with crenel backup.
make-somebody-else-administrator-first = Make somebody else an administrator first
many-points-have-very-same-angles = many points have identical joint angles
marker-mm-less-than-square-mm = { $marker } must be less than { $square }
marker-place-differs = { $place }: marker { $marker } has another place on the flange
markers-are-wide = the markers of { $name } are { $width } wide in proportion to its squares
markers-lie-far = coordinates.csv: in frame { $name } the points typically lie { $off } from where arm.json has them
markers-not-arranged-so = they are not arranged as on { $name }
markers-were-found = { $count } markers of { $dictionary } were found
mask-has-pixels = the mask is for { $width } × { $height } pixels
mask-pixels-image-another-size = a mask of { $shape } pixels for a picture of another size
mask-says-every-pixel-whether-stripe = a mask states for every pixel whether the stripe may lie there
master-sphere-not-measured = the master sphere is measured { $count } times with { $points } points each
matrix-is-no-rotation = { $name } is not a rotation: R·Rᵀ differs from 1 by { $difference }
max-min-2-along = (max − min)/2 along { $axis }
may-not-do-this =
    { $role ->
        [admin] { $name } may not do this: it requires an administrator.
       *[operator] { $name } may not do this: it requires an operator.
    }
measure-again-or-delete-rows = Measure again, or delete the rows
measure-more-poses = Measure at least { $least } poses, better { $wanted }, all over the reach
measure-more-there-or-delete-rows = Measure more points there, or delete its rows
measure-pattern-over-all-squares-correct = Measure the pattern over all its squares, and correct the certificate.
measure-patterns-width-height-fix-flat = Measure the pattern's width and height, and fix it to a flat plate.
measure-squares-correct-certificate-check-every = measure the squares, and correct the certificate; or check that every picture has its own pose, in mm
not-measured = not measured
measured-points-not-tip = coordinates.csv: the measured points lie { $far } from the tip
measuring-arm = Measuring arm
measuring-cloud = Measuring the cloud
measuring-cloud-of-number = Measuring cloud { $number }
memory = Memory
merge-takes-some = from { $fewest } to { $most } scans can be merged
merged-in-frame-of-arm-not-moved = All points are in the frame of the arm. If arm or part was moved between the scans, they do not fit: a comparison of two scans shows by how much.
merged-of = Made of
merged-scan = { $name }, merged
merged-scans = merged scans
merged-with-own-calibrations = The scans were taken with different calibrations; the points of each are by its own.
merging-scans = Merging { $count } scans
merlons-not-distinct-from-mirror-image = { $edges }: the merlons' widths and gaps read the same from both ends, so that the block cannot be distinguished from its mirror image
merlons-read-alike-either-side = its merlons look the same from both sides
merlons-read-mirrored-order = the merlons of { $name } appear in mirrored order
merlons-stand-mirrored-order = the merlons are in mirrored order
mesh-contains-triangles-of = { $path } contains { $found } of { $announced } triangles
mesh-export-again = Export the part again, as binary STL
mesh-format-unknown = it is not a part in a known format
mesh-give-known-format = Give a .stl, .step or .stp file
mesh-header-is-not-complete = its header is not complete
mesh-line-decimal-commas = the numbers in line { $line } have decimal commas ({ $text })
mesh-line-not-three-numbers = line { $line } does not have three numbers ({ $text })
mesh-of-too-many-triangles = it has more than { $most } triangles
mesh-state-unit = State the unit of its numbers (--unit mm, cm, m or inch), or export it in millimetres
mesh-text-ends-early = it ends within a facet, or without endsolid, in line { $line }
mesh-without-triangles = it has no triangle with an area
message-too-large = { $size } bytes exceed its maximum size
broker-messages-not-read =
    { $count ->
        [one] { $count } message on the broker was not read: { $reasons }.
       *[other] { $count } messages on the broker were not read: { $reasons }.
    }
messages-of-no-station = { $count } not in the form of a station
messages-of-too-many-stations = { $count } from more stations than are displayed
messages-stations = Messages of the stations
messages-too-long = { $count } too long
messages-too-often = { $count } more often than they are read
method = Method
mm = In mm
more-on-either-face =
    { $pair ->
        [crest] { $count } more on the crests or the floors
        [front] { $count } more on the front or the back face
       *[left] { $count } more on the left or the right face
    }
more-poses-would-bring-little = More poses would improve the result only a little.
more-than-kb-were-sent = The request is larger than { $limit }.
more-touches-on-face = { $count } more { $where }
most-pixels-read = at most { $millions } million are read
mount-tip-of-datasheet-or-give-diameter = Mount the tip of the datasheet, or enter the diameter of this sphere.
move-away = Move it away
move-away-start-again = Move it away, and start again
move-sensor-nearer-away-again-several = Move the sensor nearer and away again several times as you pass over the plate
move-sensor-over-part-yourself = Move the sensor over the part yourself
move-sensor-until-whole-object-picture = move the sensor until the whole object is in the picture
move-tip-another-place = Move the tip to another position
not-moved-or-encoder-not-read = it did not move, or its encoder is not read
moved-simulation-stopped = started or stopped the simulated operator
moved-turned = Moved { $moved } and rotated { $turned } in { $duration }
movement-tip = Movement of the tip
moving-only-moves-whole-arm-space = changing it only moves the whole arm in space
must-begin-http-https-name-machine = the address must begin with http:// or https:// and name a host
must-name = It must name { $names }
n-2-along = 2σ along { $axis }
n-2-encoders-alone = 2σ by the encoders alone, { $axis }
n-2-worst-axis = 2σ is { $two_sigma } on the worst axis; the encoders' noise alone gives { $encoders }.
n-3d-view = 3D view
view-3d-does-not-answer = The 3D view does not respond.
view-3d-not-connected = The 3D view of this page is not connected
name-a-file = Name a file
name-a-folder = Name a folder
name-and-serial-number = { $name }, serial number { $serial_number }
name-another-file = Name another file
name-file-holds-brokers-password-alone = Name a file that contains only the broker's password and that the station can read
name-folder-another-disk-backups-station = Set backups in station.toml to a folder on another disk.
name-folder-calibration-check-verification-has = Name the folder of a calibration, a check, a verification or a performance test: it contains one of { $files }
name-folder-of-seats-spheres-bars = Name a folder of seats, spheres or ball bars touched with the arm, or of coordinates measured by a tracker
name-folder-other-places-none-some = Name a folder of other places, or none: some places are then left out in turn
name-folder-that-is-not-there = Name a folder that does not exist yet
name-frame-of-each-set-up = Give each set-up a name of its own in the column frame
name-marker-in-column = Name the marker in the column marker, or correct the tip in arm.json
name-password-do-belong-together = The name or the password is wrong.
name-recording = Name a recording
name-scan-mcap = Name a scan.mcap
name-sessions-folder = Name a session's folder
name-tls-certificate-tls-key-station = Set tls_certificate and tls_key in station.toml, or put a proxy in front of the station.
name-too-long = the name is too long
named-joint-range = the range of joint { $joint } is { $low } to { $high }
named-next-part = named the part of the next scan
named-part = named the part of a scan
named-value = { $name } { $value }
near-base = near the base
needed = at least { $least_frames } are required
needed-place = at least { $fewest_corners } are required to determine its pose
needs-least =
    { $shape ->
        [plane] a plane requires at least { $least }
        [sphere] a sphere requires at least { $least }
        [cylinder] a cylinder requires at least { $least }
       *[other] at least { $least } are required
    }
needs-least-three-conjugated-pairs = it requires at least three conjugated pairs
neither-colours-nor-arms-poses-tell = neither its colours nor the arm's poses determine which corner is the first
nested-too-deeply = it is nested too deeply
network = Network
never-checked = It has never been checked.
never-held-up-more-than = Never delayed by more than { $limit }.
new-password = new password
newest-record-days-later-than-clock = The newest record is { $days } days ahead of the clock.
next = Next: { $title }.
next-backup-would-include-this = the next backup would include this one
next-pose-follow-dashed-outline = Next pose: { $words }. Follow the dashed outline.
no-account-name = { $name } is not a valid account name
no-answer-from = { $url } does not respond
no-answer-within = no answer within { $limit }
no-arm-model-joints-chosen = no arm model with { $joint_count } joints is selected
no-arm-model-poses-chosen = no arm that reports poses is chosen
no-arm-moves-that-fast = no arm moves that fast
no-arm-near-given-one-explains = no arm close to the given one explains the points; those of { $label } lie { $rms } (rms) apart
no-backup-made = No backup was made: { $error }
no-ball-bar-measured-arms-size = no ball bar was measured: the arm's scale is that of its datasheet; an error of { $error } in the longest link adds { $size } over the reach
no-bright-line-runs =
    { $axis ->
        [u] no bright line runs across the picture
       *[v] no bright line runs down the picture
    }
no-calibration-use-yet = no calibration is in use yet
no-camera-answers = { $title } does not answer
no-camera-found = { $title } was not found
no-certificate-stated = no certificate stated
no-chessboard-x-inner-corners-found = no chessboard of { $columns } × { $rows } inner corners was found
no-cloud-being-scanned = No cloud is being scanned.
no-cloud-shows-gauge-yet-scan = No cloud covers the gauge yet. Scan one.
no-cloud-taken-yet = No cloud has been scanned yet.
no-column = { $path }: no column { $names }
no-connection = no connection
no-coordinates-taken-yet = no coordinates were taken yet
no-crenellated-object-found-picture = no crenellated object was found in the picture
no-data = No data from the { $title } for { $silent }
no-data-yet = No data yet.
no-database-there = there is no { $database }
no-delay-found-yet = No delay has been determined yet
no-file = it is not a file
no-fitted =
    { $shape ->
        [plane] No plane was fitted: { $error }
        [sphere] No sphere was fitted: { $error }
       *[cylinder] No cylinder was fitted: { $error }
    }
no-fitted-program-failed =
    { $shape ->
        [plane] No plane was fitted: an internal error occurred.
        [sphere] No sphere was fitted: an internal error occurred.
       *[cylinder] No cylinder was fitted: an internal error occurred.
    }
no-flange-further-than = { $path }: no flange is further than { $furthest } from the arm's base
no-folder-named = there is no folder { $folder }
no-frames = { $named }: no frames
no-free-name-scan = no free name for a scan in { $folder }
no-hand-no-knock-moves-joint = neither a hand nor a knock moves a joint that far in so short a time
no-image-or-cut-off = it is not a picture, or is incomplete
no-joint-angle-exceeds = { $path }: no joint angle exceeds { $largest }
no-joint-angles = { $named }: no joint angles
no-joint-goes-there-back-between = no joint moves there and back between two readings
no-joint-turned-more-than = { $label }: no joint rotated by more than { $swing } ({ $joint })
no-joints-around-any-frames-stamp = { $named }: no arm readings around the time stamp of any frame
no-json = it is not JSON: { $error }
no-laser-stripe-found-object = no laser stripe was found on the object
no-laser-stripe-front-sensor-any = { $named }: no laser stripe in front of the sensor in any frame of { $numbered }
no-laser-stripe-picture = The picture shows no laser stripe.
no-laser-stripe-picture-serves-camera = The picture shows no laser line: it determines only camera and mounting.
no-lengths-measured = no length was measured
no-limit = no limit
no-limit-set = no limit is set
no-limit-set-heading = No limit set
no-limit-set-identification-check-arm = No limit applies to an identification: an arm check assesses it.
no-limit-set-so-check-neither = No limit is set, so this check is undecided.
no-line-seen = no laser line is visible
no-laser-line-visible = No laser line is visible
no-markers-found = no marker of { $dictionary } was found: { $name } was not detected
no-mcap-recording = it is not an MCAP recording
no-page-file-has-such-address = No page or file has this address.
no-picture-came-sensor = the sensor sent no picture
no-picture-came-within = no picture arrived within { $limit }
no-picture-in-folder = There is no picture in the folder { $folder }
no-picture-laser-came-within =
    { $state ->
        [on] no picture with the laser on arrived within { $limit }
       *[off] no picture with the laser off arrived within { $limit }
    }
no-picture-shows-object-yet-take = No picture shows the object yet. Take another.
no-placing-edges-explains-those-picture = no pose of the object explains the edges in the picture
no-point-taken-back-since-last = No point has been removed since the last one was taken.
no-point-taken-yet = No point has been taken yet.
no-points-can-made = { $interrupted } Its points cannot be computed: { CLAUSE($why) }.
no-pose-given = no pose was given
no-position-block-brings-them-onto = no position of this block puts them on it
no-readable-figures = { $name } has no readable figures
no-reason-given = No reason is stated
no-record-is-open = No record is open in the view
no-rotation-exceeds = { $path }: no value of rx_deg, ry_deg and rz_deg exceeds { $largest }
no-seat-taken-yet = No place has been measured yet.
no-seated-tip-does-points-another = a seated tip does not; points of another place are among them, or the file belongs to another arm
no-serial-port-named = There is no serial port { $url }
no-serial-port-plugged = No serial port is connected.
no-single-contact-fault = no single contact point is the cause
no-size-squares-makes-them-agree = no size of its squares makes the two agree
no-station-data-folder = { $folder } is not the data folder of a station
no-such-file = there is no such file
no-such-file-or-folder = there is no such file or folder
no-such-folder-named = There is no folder { $folder }
no-touch-taken-back-since-last = No contact point has been removed since the last one was taken.
no-touch-taken-yet = No contact point has been taken yet.
no-two-opposite-sides-were-touched = No two opposite sides were touched: the tip's diameter and the block's size are taken from their certificates, unchecked.
no-video-file-named = There is no video file { $path }
nobody-asks-control = Nobody requests control
nobody-may-use = Nobody may use { $path }.
nobody-signed-here = You are not signed in.
nominal-is-of =
    { $shape ->
        [sphere] the nominal is that of a sphere
       *[plane] the nominal is that of a plane
    }
none-calibrations-belongs-these-recordings = None of the calibrations belongs to these recordings
none-edges-floors-base-shows-picture = none of the edges of its floors and its base is visible in the picture
none-significant = none was significant
normal-component = Normal { $axis }
normal-must-be-of-unit-length = normal must be of unit length, not { $length }
covariance-must-be-symmetric-over-parameters =
    { $count ->
        [one] the covariance must be one variance of at least 0, for { $count } parameter
       *[other] the covariance must be symmetric, with a row and a column for each of { $count } parameters, and variances of at least 0
    }
links-one-for-each-parameter =
    { $count ->
        [one] links must have one value, for the one parameter of a link
       *[other] links must have { $count } values, one for each parameter of a link
    }
normal-must-have-unit-length = normal must be of unit length
not-saved = The change was not saved
not-usable-next-to-database = { $path } cannot be used next to the station's database
note = Note
nothing-came-for = No data arrived from { $url } for { $time }
nothing-can-be-sent-to-arm = No data can be sent to the arm at { $url } ({ $reason })
nothing-changed-since-solved = Nothing has changed since the last computation.
nothing-changed-stations-log-has-details = nothing was changed; the station's log has the details
nothing-else-bears-out-shadow-highlight = { $text }, but nothing else confirms it: a shadow, a highlight or something in front of it may look the same
nothing-listens = No program listens at { $url }
nothing-made-them = They were not used. { CAPITAL(CLAUSE($remedy)) }.
nothing-runs = Nothing is running
nothing-seen-no-contrast = Nothing visible: no contrast
nothing-taken-reading-cannot-true-no = Implausible readings are not used for contact points, poses or scanned points.
nothing-taken-such-reading = such a reading is not used
now = Now
number-expected-here = a number is expected here
number-too-large = the number is too large
numbers-without-decimal-comma = Write numbers with a decimal point, not a comma, and names without a comma
numerics = Numerics
object = Object
object-certificate = object certificate
object-fills = Object fills
object-not-found = the object was not found
object-looked-grey-images-8-16 = the object is detected in grey pictures of 8 to 16 bits with at least 64 pixels in each direction
object-off-m = Object deviation, µm
object-picture = The object is in the picture
object-does-not-match-certificate = the object in the picture does not match the certificate of { $name } ({ $serial_number })
object-picture-hold-arm-there-clamp = The object is in the picture. Hold the arm there, or clamp it.
object-point-or-pixel-not-a-number = an object point or a pixel is not a number
object-points-shape-pixels-shape = object points of shape { $points } and pixels of shape { $pixels }
object-too-far =
    { $side ->
        [left] The object is too far to the left
        [right] The object is too far to the right
        [up] The object is too high in the picture
       *[down] The object is too low in the picture
    }
objects-place-k-1 = Object's position (k = 1)
object-points-do-not-fit-pixels = the object's points do not fit their pixels
of = { $page } of { $pages }
off = The { $title } is off
offset-m = Offset, µm
offset-not-separable = an error of the probe matrix cannot be separated from the position of the sphere
offset-not-significant = The location error does not imply an error of the probe matrix: { $size } does not differ from chance, { $left } would remain.
offset-worth-calibrating = The location error implies that the probe matrix is off by { $size }, or the scale of the sensor, which looks the same here; corrected for it, { $left } would remain. Calibrating again would help.
old-after-days-due = It is { $ago } old; due after { $limit }.
old-due-after-days = { $text }, { $ago } old; due after { $limit }.
old-password-wrong = The old password is wrong.
on-board = on the board
on-face = on the { $face } face
one-browser-acts-time = only one browser can act at a time
one-diameter-wrong-or-sphere-not-clean = one of the stated diameters is wrong, or the sphere was not clean
one-line-alone-does-fix-lasers = a single line does not determine the laser plane
one-numbers-has-too-many-digits = one of its numbers has too many digits
one-of = it is one of { $names }
one-picture-flat-board-tells-neither = one picture of a flat board determines neither the focal length nor the laser plane
one-picture-per-file = a file is read as one picture
one-plane-does-not-determine-camera = a single plane does not determine focal length, stand-off and the laser plane together
one-pose-alone-used-errors-arms = Only one pose was used: errors of the arm's links appear only in the contact points. Joint angles that do not belong to the picture, and an object that moved after it was touched, do not appear.
one-pose-not-enough = one pose is not sufficient on { $name }
one-pose-faugeras-contact-alignment = one pose (Faugeras, contact alignment)
one-recording-one-calibration-give-one = one recording and one calibration give one plane
one-rotation-expected = a rotation is given in one way
one-used-each-lighting = one picture of each lighting is used
one-value-expected-for = one value from 0 to { $largest } is expected for { $label }
one-who-loses-control-reads-why = whoever loses control can read the reason
only-administrator = { $name } is the only administrator
only-ball-bars-are-scanned = only the spheres of a ball bar are measured by scan, and this standard has none
only-corners-can-measured = only { $found } of its corners can be measured
only-edge-points-lie-edges = only { $agreeing } of the edge points lie on its edges
only-free-disk = only { $free } is free on the disk of { $folder }
only-joint-samples-came = only { $count } arm readings arrived in { $duration }
only-machines-browsers-reach-station = Only browsers on this machine reach the station.
only-one-row-corners-each-level = only one row of corners on each level does not determine the camera
only-pose-take-another-first = It is the only pose. Capture another first.
only-stations-own-pages-may-do = Only the server's own pages may do this.
only-visible-edges-show-picture = only { $shown } of its visible edges appear in the picture
open-again = Open it again.
open-one-first = Open one first
opened-kiosk = opened as a kiosk display
operation-not-permitted = the operation is not permitted
operator = Operator
origin-mm = Origin, mm
other-files = the other files belong to { $device } { $known }
other-sphere-measured = the diameter of the touched sphere is { $off } off the certificate: this is another sphere, or a diameter is mistyped
other-bar-measured = placement { $placement } measured a length of { $measured }, and the nearest length of the certificate is { $certified }: this is another ball bar, or a length or diameter is mistyped
other-machines-reach-encrypted = Other machines reach the station over an encrypted connection.
other-machines-reach-nothing-encrypted = Other machines reach the station without encryption.
other-machines-reach-proxy = Other machines reach the station through a proxy.
other-serial-number = { $title } has the serial number { $found }, not { $wanted }
other-stations-see-one-one-them = Stations see each other through the broker. Nothing else depends on it.
others-are-covered = the others are covered, in shadow or too faint
others-are-overexposed = the others are overexposed
out-focus-edges-wide-wanted = Out of focus: the edges are { $width } wide, at most { $wanted } allowed
out-picture-covered-too-small-or-another-object = it is out of the picture, covered, too small or seen at too steep a slant, or another object is there
over-clouds = Over the clouds
over-reach-before-difference-arm-identified = Over the reach. Before: the difference from the identified arm. After: the standard uncertainty, k = 1.
over-reach-tip-off-rms-now = Over the reach the tip error was { $before } rms; the standard uncertainty is now { $after } (k = 1).
overexposed-share-at-full-scale = it is overexposed: { $share } of its pixels are at full scale
package-named = the package { $name } { $version }
parameter = Parameter
parameters = Parameters
parameters-moved-do-same-together = the changed parameters have the same effect together
part-edges-of-many-triangles = { $count ->
        [one] One edge belongs to more than two triangles.
       *[other] { $count } edges belong to more than two triangles.
    }
part-normals-inward-turned = All triangles faced inwards, by the volume that they enclose, and are turned.
part-of-other-unit = they would agree if the part's unit were { $unit }
part-of-path-is-no-folder = a part of the path is not a folder
part-of-second-board-in-picture = beside a board of { $columns } × { $rows } inner corners, a part of a second one is in the picture
part-place = { $x }, { $y }, { $z }
part-size = { $x } × { $y } × { $z }
part-surface-one-sided = Its surface has one side only, like a Möbius strip: signs of deviations mean nothing there.
part-surface-open = Its surface is open: { $count ->
        [one] one edge belongs
       *[other] { $count } edges belong
    } to one triangle only, the longest at { $places }.
part-triangles-not-numbers = { $count ->
        [one] One triangle has a corner that is no number, and is left out.
       *[other] { $count } triangles have corners that are no numbers, and are left out.
    }
part-triangles-turned = { $count ->
        [one] One triangle faced the other way than those around it, and is turned.
       *[other] { $count } triangles faced the other way than those around them, and are turned.
    }
part-triangles-without-area = { $count ->
        [one] One triangle has no area, and is left out.
       *[other] { $count } triangles have no area, and are left out.
    }
part-without-unit = The file does not state its unit. In { $unit }, the part is { $size }; state another with --unit.
pass = Pass
pass-does-not-tell-delay = this pass does not determine the delay
pass-half-minute-enough = a pass of half a minute is sufficient
pass-has-pictures-lasers-line-plane = the pass has { $count } pictures with the laser line on the plane
pass-over-flat-plate-fills-lasers = Pass over a flat plate that fills the laser line
pass-over-more-gauge = Pass over more of the gauge
pass-over-plane-find = Pass over a plane and determine the delay
pass-over-plate = Pass over the plate
pass-over-several-sides = Pass over the gauge from several sides
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
password-is-name = The password is the same as the name
password-length-wanted = { $least } to { $most } are required
patches-not-covered = the scans do not cover the patches { $patches } of the sphere
performance-articulation-largest = single-point articulation, largest distance
performance-articulation-two-s = single-point articulation, twice the standard deviation
performance-beyond-limit = { $title }: { $value }, beyond the limit of { $limit }; test value uncertainty { $uncertainty } (k = 2).
performance-cause-arm = The centres by touch lie { $apart } apart, and the scatter of the touches explains { $usual }: links or encoders of the arm err with its posture.
performance-cause-outliers = { $share } of the points of the scans lie far off the sphere: reflections, or outliers of the sensor.
performance-cause-tip =
    { $way ->
        [large] The touched sphere is { $size } too large: the tip is larger than stated.
       *[small] The touched sphere is { $size } too small: the tip is worn or smaller than stated, or the sphere gives way while it is touched.
    }
performance-conditions-not-met = { $title }: { $value }; not decided, because { $problem }.
performance-dispersion-scan = dispersion of the scanned sphere, 95 % of all points
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
performance-effective-diameter = effective diameter of the master sphere
performance-expansion-unknown = the artefact { $name } was at { $celsius }, more than { $most } from 20 °C, and its certificate has no coefficient of expansion: enter expansion_per_c and its standard uncertainty expansion_sd_per_c in the file of the artefact (if it does not expand: 0, and an uncertainty above 0)
performance-form-unknown = the certificate of { $name } states no form: forms and dispersion are not decided; enter form_um and its standard uncertainty form_sd_um in the file of the sphere
performance-fewer-lengths =
    { $count ->
        [one] the standard has only one length, and the procedure takes five
       *[other] the standard has only { $count } lengths, and the procedure takes five
    }
performance-form-both = form, touched and scanned together
performance-form-scan = form of the scanned sphere, 25 places
performance-form-touch = form of the touched sphere
performance-gate = Gate: { $shell } about the calibrated sphere, incidence up to { $incidence }, up to { $cone } from the pole; fixed before the test.
performance-length-gate = Gate of the scans: { $shell } about the calibrated spheres, incidence up to { $incidence }, beyond { $cone } from the direction of the bar; all points within it count.
performance-length-scan = error of length by scan
performance-length-touch = error of length by touch
performance-left-out =
    { $which ->
        [sphere] Without a master sphere: the effective diameter was left out.
       *[bar] Without a ball bar: the volumetric lengths were left out.
    }
performance-limit-twice = The quantity { $quantity } has more than one limit.
performance-limit-unused = The plan has a limit for “{ $title }”, which this test does not measure: it is not used.
performance-limits-broken = A figure breaks its limit.
performance-limits-kept = Every figure that has a limit keeps it.
performance-location-both = distance of the scanned from the touched sphere
performance-location-scan = location of the scanned sphere over articulations
performance-location-touch = location of the touched sphere over articulations
performance-near-limit = { $title }: { $value }, too close to the limit of { $limit } for a decision; test value uncertainty { $uncertainty } (k = 2).
performance-no-arm = no datasheet in the folder arms belongs to the connected arm, or it states no tip
performance-extracted-by = All points within the gate take part. The line was looked for in the pictures of the scans with these settings: { $names }.
performance-scans-set-otherwise = the scan { $scan } was taken with other settings than { $other }: the scans of a test need the same
performance-smoothed =
    All points within the gate take part. They were smoothed along the laser line by { $smoothing } when they were recorded, which makes forms and dispersion smaller.{ $others ->
        [none] { "" }
       *[other] { " " }Further settings: { $others }.
    }
performance-no-filter = All points within the gate take part; no filter is applied.
performance-no-value = { $title }: no value, because { $problem }.
performance-not-decided = Not every figure is decided.
performance-one-position = The sphere was measured in one position; the standard takes two.
performance-plane-is-addition = The form of a plane is an addition: the standard’s test is for area sensors.
performance-plane-scan = form of the scanned plane, 95 % of all points
performance-size-all-scan = error of size of the scanned sphere, all points
performance-size-both = error of size, touched and scanned together
performance-size-scan = error of size of the scanned sphere, 25 places
performance-size-touch = error of size of the touched sphere
performance-status-no-conformity-claimed = Procedure after ISO 10360-12:2016, ISO 10360-8:2013 and ASME B89.4.22-2004 as described in Crenel’s manual; no conformity with these standards is claimed.
performance-steadiness-unknown = Whether the temperatures were steady is not known: artefact and arm were not both measured at the beginning and at the end.
performance-temperature-changed =
    { $which ->
        [arm] the temperature of the arm changed by { $change } during the test, more than { $most }
       *[other] the temperature of the artefact changed by { $change } during the test, more than { $most }
    }
plan-without-artefact =
    { $which ->
        [master] the plan names no master sphere
        [sphere] the plan names no sphere
        [lengths] the plan names no length standard
        [plane] the plan names no plate
       *[bar] the plan names no ball bar
    }
performance-temperature-far =
    { $which ->
        [arm] the arm was at { $celsius }, more than { $most } from 20 °C
       *[other] the artefact was at { $celsius }, more than { $most } from 20 °C
    }
performance-temperatures-steady = The temperatures of artefact and arm changed by { $change } at most (limit { $most }) and stayed within { $off } of 20 °C.
performance-volumetric-largest = volumetric length, largest deviation
performance-volumetric-two-rms = volumetric length, twice the rms
performance-plane-gate =
    { $count ->
        [one] Points take part that lie over the plate, at least { $rim } within its outline and within { $shell } of its plane; one point of the scans does not. None is removed by its residual.
       *[other] Points take part that lie over the plate, at least { $rim } within its outline and within { $shell } of its plane; { $count } points of the scans do not. None is removed by its residual.
    }
performance-touches-taken-back =
    { $count ->
        [one] One touch was taken back by the operator.
       *[other] { $count } touches were taken back by the operator.
    }
performance-within-limit = { $title }: { $value }, within the limit of { $limit }; test value uncertainty { $uncertainty } (k = 2).
permission-denied = permission denied
pick-more-way-round-fit-plane = Select more of its circumference, or fit a plane
picture-being-taken-already = a picture is already being taken
picture-blurred-edges-wide = the picture is blurred: its edges are { $width } wide
picture-blurred-edges-wide-most-can = the picture is blurred: its edges are { $blur } wide, but can be measured only up to { $limit }
picture-blurred-noisy = the picture is blurred or noisy
picture-bytes-do-not-fit = { $name }: { $bytes } bytes for { $width } × { $height } pixels, { $row } per row
picture-can-read-more-than-one = the picture of { $name } can be interpreted in more than one way
picture-cannot-be-encoded = the picture could not be encoded as PNG
picture-cannot-be-used-take-it-again =
    { $others ->
        [yes] This picture cannot be used. Take it again or continue without it.
       *[no] This picture cannot be used. Take it again.
    }
picture-cannot-read = The picture { $path } cannot be read
picture-dim-bright-parts-reach-full = the picture is dim: its bright parts reach { $high } of full scale
picture-has-size =
    { $picture ->
        [laser] the laser picture has { $width } × { $height } pixels
       *[ambient] the calibration picture has { $width } × { $height } pixels
    }
picture-incomplete = the picture is incomplete
picture-mirrored-camera-looks-objects-back = the picture is mirrored, or the camera looks at the object's back
picture-objects-certificate-contradict-each-other = the picture and the object's certificate contradict each other
picture-of-cloud = Picture of the cloud
picture-of-cloud-seen-from = { $name }, from above and in front, coloured by height.
picture-of-kind-that-is-not-read = it is a { $kind } file, which is not read
picture-of-numbers = The picture { $path } contains { $kind } numbers
hold-still-for-both-pictures = hold sensor and object still until both pictures are taken, or darken the room
pictures-with-and-without-laser-differ-by-motion = something moved between the picture with the laser and the one without it ({ $shifted } of the picture), so that the room's light could not be taken off
picture-overexposed = { $saturated } of the picture is overexposed
picture-shows-no-contrast-full-scale = the picture shows no contrast: { $contrast } of full scale
picture-shows-no-laser-line-object = its picture shows no laser line on the object
picture-shows-objects-mirror-image = the picture shows the object's mirror image
picture-size-changed = { $title } changed its picture from { $width } × { $height } to { $new_width } × { $new_height } pixels
picture-soft-edges-wide = the picture is slightly blurred: its edges are { $width } wide
pictures-arrive-incomplete = { $title } sends pictures that arrive incomplete
pictures-came-without-arms-position = { $count } of { $total } pictures have no arm position
pictures-contacts-certificate-contradict-each-other = the pictures, the contact points and the certificate contradict each other
pictures-different-sizes = the pictures are of different sizes: { $sizes }
flat-board-one-direction-does-not-tell-focal-length = pictures of a flat board from one direction do not determine the focal length
pictures-have-object-turned-how-touched = In the pictures the object is rotated by { $turned } relative to its contact points. Scanned points may be wrong by as much.
pictures-have-object-where-touched-turned = In the pictures the object is { $off } (± { $known }) away from where it was touched, and rotated by { $turned }. Scanned points may be wrong by as much.
pictures-left-out = Pictures are skipped: { $what }
pictures-of-one-pose-need-still-arm = the pictures of a pose are taken while the arm is still
pictures-recording-were-left-out = { $kept } pictures were recorded, { $left_out } were skipped
pictures-show =
    { $seen ->
        [one] { $seen } picture shows { $name }
       *[other] { $seen } pictures show { $name }
    }
pictures-were-lost = { $count } of { $total } pictures were lost
pictures-were-taken-too-fast-up = { $count } of { $total } pictures were taken too fast: blur up to { $worst }
pixel-format-unknown = { $title } sends pictures in the pixel format { $name }, which is not supported
pixel-formats-are = Set pixel_format to one of { $names }
pixels-alternate-as-raw = the pixels alternate as in a raw picture of a colour camera, but are measured as grey
place-sensor-so-both-crests-floors = place the sensor so that both crests and floors are in the picture
place-sensor-so-stripe-crosses-crests = place the sensor so that the stripe crosses crests and floors
place-touch = This is the position of contact point { $number }
placed = Position
places = { $done } of { $seats_wanted } places
places-done = { $done } places
places-held-out-arms-errors-go = in cross-validation the arm's errors change from { $before } to { $after } times their noise
places-held-out-still-deviate = in cross-validation the places still deviate by { $times } times their noise: add places, spread more evenly over the reach
places-were-held-out-fit-over = At places that were left out of the fit, and over the arm's whole reach.
plane-equation = ({ $x }, { $y }, { $z }) · x = { $offset }
laser-plane-does-not-cross-board-sharply = a laser plane nearly parallel to the board does not intersect it sharply
plane-needs-both-directions = a plane requires { $width } in both directions
plane-needs-lines = the laser plane requires lines in at least { $fewest } pictures; the other pictures determine camera and mounting
plane-needs-lines-in-some = That is sufficient for this pose. The laser line must cross the board in at least { $fewest } other pictures.
plane-swept-straight-across-angle = Plane scanned in one straight pass: angle
plane-through-cameras-centre-gives-no = a plane through the camera's centre gives no depth
plate-not-in-enough-orientations = the plate was not scanned in { $count } orientations
plate-scan-too-narrow = the scan shows a strip of the plate only { $width } wide; { $least } are needed
plate-was-not-scanned = the plate was not scanned
plug-right-arm-correct-arm-joint = Connect the right arm, or correct [arm] joint_count.
point = Point { $number }, { $place }.
point-of-face = { $face }, point { $index }
point-again = This is point { $point } again
point-back = Point { $index } is restored.
point-cannot-true = Point { $index } is implausible: { $what }; { $why }.
point-expanded-uncertainty = Scanned point, rms over the measuring volume: expanded uncertainty
point-known-good =
    { $point ->
        [seen] Standard uncertainty of a point seen at the board's distance, in the flange frame: { $total } (k = 1); up to { $good } is good.
       *[scanned] Standard uncertainty of a scanned point in the flange frame: { $total } (k = 1); up to { $good } is good.
    }
point-known-k-1 = { $name }, uncertainty of a point { $total } (k = 1)
point-known-mostly-by =
    { $point ->
        [seen] Standard uncertainty of a point seen at the board's distance, in the flange frame: { $total } (k = 1), mainly from the { $source } ({ $value }); the limit is { $limit }.
       *[scanned] Standard uncertainty of a scanned point in the flange frame: { $total } (k = 1), mainly from the { $source } ({ $value }); the limit is { $limit }.
    }
point-at-place = { $place }, point { $number }
point-left-out-off = { $place }, point { $number }: { $distance } off
point-lies-on-other-face = Point { $index } misses the { $face } face by { $off } and lies { $where }.
point-misses-face = Point { $index } misses the { $face } face by { $off }.
point-off-face = Point { $index } is { $off } off the { $face } face; the others agree to { $rms }.
point-off-face-remove-then-go = Point { $point } is off its face. Remove it, then continue.
point-off-plane-others = Point { $index } is { $off } off the plane of the others.
point-removed = Point { $index } is removed.
point-standard-uncertainty = Scanned point, rms over the measuring volume: standard uncertainty
point-taken-off = Point { $index } { $where }: { $off }.
point-no-longer-there = That point no longer exists.
points-1-lie-apart-while-single = { $label }: its points 1 to { $split } and { $next } to { $points } lie { $gap } apart, while single points scatter by { $sd }
points-taken = { $taken } points
points = Points
points-blocks-edges-fit-camera-rms = { $points } points on the block's edges fit the camera to { $rms } rms (limit { $edge_rms_px }), worst in pose { $number }: { $edges_rms } (limit { $worst_limit }).
points-check-among-those-fit = { $shared } of the { $count } check points were also used in the fit
points-disagree-rest = { $label }: { $out } of its { $points } points disagree with the rest
points-not-on-sphere = its points do not lie on such a sphere
points-edges-fit-camera-rms-limit = { $points } points on { $edges } edges fit the camera to { $rms } rms; the limit is { $edge_rms_px }.
points-fix-no-cylinder = the points do not determine a cylinder
points-here-welcome-beside-those-other = { $place } Points here are useful in addition to those on the other faces.
points-laser-stripe-lie-object-levels = { $points } points of the laser stripe lie on the object (of { $found } on its levels; { $least } are required on crests and on floors)
points-lasers-line-lie-board-but-poses =
    { $count ->
        [one] { $points } points of the laser line lie on the board, { $rms } rms off the plane. Pose { $poses } has none and determines only camera and mounting.
       *[other] { $points } points of the laser line lie on the board, { $rms } rms off the plane. Poses { $poses } have none and determine only camera and mounting.
    }
points-lasers-line-lie-board-rms = { $points } points of the laser line lie on the board, { $rms } rms off the plane.
points-lie-about-nearest-plane = whatever the delay, the points scatter by { $spread } (k = 1) about the best-fitting plane
points-lie-in-another-frame = coordinates.csv: { $far } of { $points } points of frame { $name }, from line { $first } to line { $last }, agree among themselves but lie { $off } off the others
points-lie-one-line = the points lie on one line
points-lie-one-plane = the points lie in one plane
points-lie-too-small-piece = the points cover too small a part of it
points-lie-too-small-piece-sphere = the points cover too small a part of a sphere, or belong to another shape
points-not-within-one-plane = no delay within ± { $range } brings more than { $share } of the points within { $distance } of one plane: it is none, or the clocks differ by more
points-made = { $name }: { $points } points computed.
points-made-again-while-no-scan = Its points are computed from its recording while no scan is running.
points-made-when-there-room-no = { $interrupted } Its points are computed once there is space on the disk and no scan is running.
points-not-made-again = Its points cannot be computed: { CLAUSE($why) }.
points-of = { $taken } of { $wanted } points
points-of-frame-disagree = coordinates.csv: { $out } of { $points } points of frame { $name } disagree with the others
points-places = { $points } points at { $places } places
points-saved =
    { $count ->
        [one] { $name }: { $count } point saved
       *[other] { $name }: { $count } points saved
    }
points-taken-themselves-while-arm-swings = Points are taken automatically while the arm swings.
points-used = Points used
points-were-taken-another-arm-file = the points were taken with another arm, or the file is wrong
ports-are = Available ports: { $names }.
pose-for-reason = Pose { $number }: { CLAUSE($reason) }.
pose-named = pose { $number }: { $name }
pose-at-pixel = pose { $number } ({ $u }, { $v })
pose = Pose
pose-count-one-other-s-taken =
    { $count ->
        [one] { $count } pose is captured.
       *[other] { $count } poses are captured.
    }
pose-differs-from-line = { $place }: { $moved } from line { $line } of the same pose { $pose }
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
pose-has-no-picture = { $place }: pose { $pose } has no { $missing } picture
pose-is-set-aside = Excluded
pose-jumped = the arm reports a pose { $step } and { $turn } from the one before
pose-jumped-and-stayed = the arm’s pose jumped by { $step } and { $turn } and stayed there
pose-left-out = Pose { $number } was excluded: { CLAUSE($reason) }.
pose-looks-same-turned-round = pose { $number }: { $name } looks the same when rotated
pose-needs-a-lit-picture = a pose requires one 'ambient' picture, or one with 'both' lights; on a chessboard, its 'laser' picture may be missing
pose-needs-both-lightings = a pose requires one 'ambient' and one 'laser' picture, or one with 'both' lights
pose-no-number = the arm reports a pose that is not a number
pose-no-rotation = the arm reports a pose whose quaternion is not of unit length
pose-not-set-aside = That pose is not excluded.
pose-excluded = Pose { $n } is excluded
pose-shows-corners = pose { $number } shows { $found } corners of { $name }
pose-shows-no-laser-line-object = Pose { $number } shows no laser line on the object and is used without it.
pose-taken = Pose { $number } is captured.
pose-taken-back = Pose { $n } is included again
pose-no-longer-there = That pose no longer exists.
pose-used-other-one-pose =
    { $unused ->
        [one] pose { $number } was used; the method one-pose does not use the other one
       *[other] pose { $number } was used; the method one-pose does not use the other { $unused }
    }
pose-would-help-most-scanned-point = The most useful pose: { $words }. Uncertainty of a scanned point: { $now } → { $then } (k = 1).
poses = the poses
poses-heading = Poses
poses-agree-boards-place-pose-furthest = { $used } poses agree on the board's position to { $median }; pose { $number } deviates most, by { $off }.
poses-agree-objects-place-pose-furthest = { $used } poses agree on the object's position to { $median }; pose { $number } deviates most, by { $off }.
poses-all-alike-do-not-tell-mounting = poses that are all alike do not determine the sensor's position on the flange in any direction
poses-contacts-scatter-times-more-than = The poses and contact points scatter { $noise } times more than the arm's encoders explain (limit { $noisy }).
poses-enough = { $done } poses are sufficient
poses-measured =
    { $points ->
        [one] { $points } point
       *[other] { $points } points
    } in { $frames ->
        [one] { $frames } frame
       *[other] { $frames } frames
    }
poses-move-too-little = images.csv: by the pictures, the arm moves { $ratio } times as far as its poses say
poses-put-up-apart =
    { $thing ->
        [board] poses { $poses } place the board up to { $apart } apart
       *[object] poses { $poses } place the object up to { $apart } apart
    }
poses-touches = Poses and contact points
poses-were-changed-solve-again-undo = The poses have changed. Compute again, or undo the change.
poses-without-contact-points = { $count } poses without contact points
positions =
    { $bars } in { $positions ->
        [one] { $positions } position
       *[other] { $positions } positions
    }
pressed-stop = pressed Stop
principal-point = Principal point
principal-point-at = { $u }, { $v }
probe-matrix-sensors-frame-arms-last = Probe matrix: the sensor frame in the frame of the arm's last joint.
probe-object = Probe the object
program-failed = an internal error occurred
program-reads-version = this program reads version { $version } of { $format }
projection-matrix-is-not-product = projection_matrix is not matrix · [rotation | translation_mm]
protobuf-expected = { $schemas } in protobuf is expected
put-another-logo = Put another picture there, or remove it
put-arm-back = Restore the previous arm
put-back-end-swing = Put it back into the seat, or finish the swing.
put-back-what-there-before = restored the previous arm
put-certificate-into-folder-gauges = Add the datasheet of a gauge, or the digital certificate (DCC) of a sphere, under Datasheets.
put-file-back-last-backup-leave = Restore the file from the last backup, or leave it and continue.
put-file-back-last-backup-restart = Restore its file from the last backup and restart the station, or calibrate again
put-file-place = Put a regular file in its place
put-last-one-back = restored the last entry
put-point-back = Restore point { $i }
put-tip-into-bars-other-end = Put the tip into the bar's other end
put-tip-into-end-ball-bar = Put the tip into an end of the ball bar
put-tip-into-seat = Put the tip into the seat
put-tip-into-seat-of-number = Put the tip into seat { $done }
put-touch-back = Restore contact point { $i }
puts-object-fits-other-pose =
    { $readings ->
        [pose] it places the object { $off } away from where the others place it; it fits the robot's pose of pose { $other }
       *[angles] it places the object { $off } away from where the others place it; it fits the joint angles of pose { $other }
    }
puts-object-where-others-put = it places the object { $off } away from where the others place it
python-package-missing = The Python package { $package } is missing
quaternion-length = { $place }: (qx, qy, qz, qw) is { $length } long
radius-m = Radius, µm
radius-mm-missing-sphere-judged-size = { $radius } is missing: a sphere is assessed by its size
raise-receive-buffer = The receive buffer of this computer ({ $limit }) is smaller than one picture ({ $picture }). Run: { $command }
not-read-yet = Not read yet.
reading-of-arm-not-a-number = a reading of the arm { $name } is not a number
readings-arm = Readings of the arm
readings-arm-could-true-last =
    { $count ->
        [one] { $count } reading of the arm was implausible: { $what }
       *[other] { $count } readings of the arm were implausible; the last: { $what }
    }
readings-equal-as-never-of-encoder = at least { $equal_frozen } consecutive readings are equal to the last digit; those of a working encoder never are
readings-shape-arm = readings of shape { $shape } for the arm { $name }
reason-and-more = { $reason } (and { $more } more)
reasons = Reasons
rebuild-recording-crenel-reconstruct = rebuild it from its recording with crenel reconstruct
rebuilding-clouds-every-calibration = Rebuilding the clouds with every calibration
rebuilt-verification-every-calibration = rebuilt a verification with every calibration
record-cannot-be-opened = The record cannot be opened now
record-no-longer-in-data-folder = The record is no longer in the data folder.
record-one-pass-over-plane = Record one pass over a plane
record-pictures-instead = Record pictures in scans, or set the camera to one profile per buffer (Height = 1).
record-radians = Record radians
recording-cannot-read = the recording cannot be read: { $reason }
recording-cut-off = the recording is incomplete
recording-cut-off-after = { $path } is incomplete or damaged after { $bytes } of { $size } bytes ({ $share }); read up to { $end } from its start
recording-cut-off-before-first-message = { $path } is incomplete or damaged after { $bytes } of { $size } bytes ({ $share }), before its first message
recording-cut-off-bytes-left = the recording is incomplete: { $size } of { $written } bytes remain
recording-damaged = the recording is damaged
recording-empty = the recording is empty
recording-has-joints =
    { $path } contains { $count ->
        [one] { $count } joint
       *[other] { $count } joints
    }
recording-has-no-joints = { $path }: no arm readings
recording-has-poses = { $path } holds poses of an arm
recording-kept = { $name }: the recording is kept.
recording-message-at = { $path } { $topic } at { $stamp_ns } ns
recording-missing = the recording is missing
recording-names-joints = { $path } names its joints { $names }
recording-no-file = the recording is not a file
recording-stopped = the recording stopped
recordings = Recordings
recordings-calibrations-journal-kept-there = It contains the recordings, the calibrations and the journal.
recordings-damaged =
    { $more ->
        [0] { CLAUSE($first) }.
       *[other] { CLAUSE($first) }, and { $more } more.
    }
recordings-not-of-one-plane = the planes of the recordings differ by up to { $angle }: they are not the same plane, and their ranges mean nothing
records = Records
refining-camera-lens-laser-plane = Refining camera, lens and laser plane
reinstall-update-package = Reinstall or update that package.
rejected-and-few-edges-show = { $text }, and only { $shown } of its visible edges appear in the picture
remove = Remove it
remove-point = Remove point { $index }
remove-point-first-not-there = Remove point { $index } first: it is not { $where }.
remove-then-touch-face-marked-drawing = Remove it, then touch the face that is marked in the drawing.
remove-touch-there-again = Remove it and touch there again.
remove-touch-there-again-rest = Remove it and touch there again, holding still.
remove-touch-there-again-rest-clear = Remove it and touch there again, holding still and away from the edge.
removed-account = removed an account
removed-point = removed a point
removed-kiosk-link = revoked a kiosk link
removed-logo = removed the logo of reports
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
report-customer = Customer
report-duration = Duration
report-made-crenel-files-session-alone = Report generated by Crenel { $version } from the files of the session alone.
report-name = Name
report-number = Number
report-order = Order
report-part = Part
report-pictures = Pictures
report-point-uncertainty = Scanned point
report-scan = Scan
report-serial-number = Serial number
request-failed = the request failed
request-understood = The request is invalid: { $text }.
request-invalid = The request is invalid
residuals-contacts-object = Residuals of the contact points on the object
residuals-gauge = Residuals of { $name } on the gauge
residuals-on-gauge = Residuals on the gauge
residuals-image = Residuals in the pictures
residuals-image-worst-poses = Residuals in the pictures (the { $count } of { $used } poses that fit worst)
residuals-object = Residuals on the object
residuals-pose-picture = Residuals of pose { $number } in its picture
restore-backup-or-start-over = Replace it with the last backup, or move it away to start over
restore-database-from = Restore { $database } from { $folder }, or start with another folder by --data
restore-database-from-last-backup = Restore { $database } from the last backup, or start with another folder by --data
restore-file-source = Restore the file from its source
restore-picture-delete-row = Restore the picture or delete the row
restore-sessions-folder-backup = Restore the session's folder from a backup
restore-take-picture-again = Restore it, or take the picture again
result = Result
the-result = the result
result-cannot-traced-them = The result cannot be traced to them.
result-rms = Result, rms
result-would-replace-file-made = the result would overwrite a file that it is computed from
results = Results
review = Review
review-calibration = Review the calibration
rewritten-by-another-program = it was rewritten by another program
right = to the right
right-end = Right end
rigid-fit-given-points = a rigid fit was given { $a } and { $b } points
rigid-fit-given-points-one-line = a rigid fit was given points on one line
rms-before-after-each-pair-scale = Rms before and after; each pair has its own scale.
robot-pictures-agree-boards-place-but = Robot and pictures agree on the board's position, but on its tilt only to { $tilt } (rotations of the robot alone: { $turn }).
robots-poses = robot's poses
role-and-name = { $role }: { $name }
rotations-differ = coordinates.csv: the measured rotations differ from the arm's by typically { $angle }
rotations-other-order-or-direction = they have another order or direction, or belong to other poses
rotations-quaternion-has-length-1 = the quaternion of a rotation has length 1
row-feature = { $place }: feature { $feature }
row-file = { $place }: file { $file }
row-has-cells =
    { $path } line { $line }: { $count ->
        [one] { $count } cell
       *[other] { $count } cells
    }
row-lighting = { $place }: lighting { $lighting }
row-place = { $path } line { $line }
rows-copied-or-arm-not-moved = rows were copied, or the arm did not move: a repeated point adds no information
runs-steadily = It runs steadily.
s-driver-failed = The driver of the { $title } failed: { $error }
s-stripe-spans-blocks =
    { $level ->
        [crest] On the crests the stripe spans { $span } of the block's { $width }.
       *[floor] On the floors the stripe spans { $span } of the block's { $width }.
    }
same-offset = Plane scanned in one straight pass: offset
saturated = Saturated
save-8-16-bits = Save it with 8 or 16 bits.
save-as-png-tiff-or-jpeg = Save it as PNG, TIFF, BMP, PGM or JPEG
save-pages-apart = Save each page as a file of its own
save-commas-between-columns-point-numbers = Save it with commas between the columns and decimal points in the numbers
save-utf-8 = Save it as UTF-8
saved-result = saved the result
say-few-words-why-you-take = State briefly why you take over
says-hello = Test message from { $name }.
says-nothing-identification = { $folder } contains no identification
scan = Scan
scan-started-at = Scan { $started }
scan-added-to-record = { $name } has { $count } scans now, { $points } points
scan-again = Scan again
scan-again-arm-camera-one-clock = Scan again, with the same clock for arm and camera
scan-alone-then-merge = Scan without continuing it, and merge the two under Records: each keeps its own calibration
scan-can-made-again-recording-verification = Recordings allow a scan to be computed again and a verification to be proven.
scan-cannot-be-continued = { $name } cannot be continued
scan-cannot-start-now = A scan cannot start now
scan-cloud = Scan cloud { $clouds }
scan-complete = Complete
scan-covers-patches = the scan { $name } covers only { $count } patches of the sphere
scan-cut-short = This scan ended early: { CLAUSE($reason) }.
scan-does-start-less-than-0 = A scan requires at least 0.5 GB to start, and stops at 0.1 GB.
scan-ended-early = Ended early
scan-flat-plate-nearer-away-again = Scan a flat plate, nearer and away again several times, then determine the delay
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
scan-gap-again = Scan again what was passed over meanwhile, and keep the computer from sleeping.
scan-gauge = Scan the gauge
scan-gauge-again = Scan the gauge again
scan-gauge-chosen = Scan the selected gauge
scan-gauge-chosen-nothing-beside = Scan the selected gauge, and nothing beside it
scan-gauge-nothing-beside = Scan the gauge, and nothing beside it.
scan-goes-when-back = The scan continues when it is back.
scan-has = a scan has { $joints_topic } and { $image_topic } or { $stripe_topic }
scan-has-length-twice = more than one pair of spheres in the scan is { $length } apart; scan the two spheres of this length by themselves
scan-has-points =
    { $count ->
        [one] { $count } point.
       *[other] { $count } points.
    }
scan-incomplete = Incomplete
scan-more-clouds = Scan more clouds
scan-more-sphere = Scan more of the sphere
scan-needs = a scan requires { $needed }
scan-needs-name = A scan needs a name
scan-plate-in-strips = Scan the plate again, in strips side by side
scan-and-probe-errors-in-common-not-shown = Scan and probe share the arm: errors common to both do not appear here.
scan-report = Scan report
scan-running-already = a scan is already running
scan-running-has-laser-stop-first = A scan is running and uses the laser. Stop it first.
scan-shows-little-of-sphere = the scan shows too little of a sphere at an end of { $length }: at least { $points } points of { $frames } pictures are needed, on a cap of 25° or more in every direction
scan-sphere-from-other-sides = scan it from sides that differ by 45° or more
scan-stopped = The scan stopped: { $error }
scan-stopped-within-sentence = the scan stopped
scan-was-suspended-nothing-recorded = The program was suspended for { $duration } during this scan and recorded nothing meanwhile.
scan-without-length =
    { $count ->
        [one] the scan shows one sphere instead of two that are { $length } apart
       *[other] of the { $count } spheres in the scan, no two are { $length } apart
    }
scan-would-be-twice = one of the scans would be in it twice
scanned-sphere-has-diameter = The scanned sphere has a diameter of { $diameter }
scanning = Scanning
scanning-cloud = Scanning cloud { $number }
scans-are-merged = { $name }: merged, { $points } points
scans-cannot-be-merged = The scans cannot be merged
scans-need-a-calibration = calibration.json is missing: scans cannot be rebuilt
scans-of-several-arms = they are of different arms, each with its own frame: { $arms }
scatter-coordinates-beyond-uncertainty = Scatter of coordinates beyond the stated uncertainty
scatter-grows-with-speed = the faster the sensor moves towards the plane or away from it, the further off its points lie, at any delay: the delay varies, as where the arm's packets arrive late by different times, or several at once
scatter-points-rms = Scatter of the points (rms)
scatter-single-points-beyond-encoders = Scatter of single points beyond the encoders
schema-error = line { $line }: { $error }
schema-errors-more =
    { $count ->
        [one] and one more error
       *[other] and { $count } more errors
    }
schema-fetch = put { $name } into { $folder }
schema-imports-missing = it includes or imports { $location }, which is not there, and nothing is fetched
schema-is-none = it is not an XML schema (XSD)
schema-is-of-xml = a schema checks QIF and certificates only
schema-leave-out = use --format qif or --format dcc, or leave out --schema
schema-nothing-written = nothing was written
schema-package-missing = validation requires the package lxml, which is not installed
schema-unusable = the schema cannot be used: { $error }
schema-not-complied-with = the file would not comply with { $schema }: { $errors }
screw-home-check-again-change-if = Tighten it and check again; replace it if the error persists.
check-tip-again-holding-still = Check again, holding still at each point.
screw-tip-home-clamp-sphere-check = Tighten the tip, clamp the sphere, and check again.
search-object-failed = The detection of the object failed
the-seat = the seat
seat-moved-between = the seat moved in between
seat-named = seat { $name }
seat-needs-two-points = a seat needs two points or more
seat-points-1-lie-apart = seat { $name }: its points 1 to { $split } and { $next } to { $points } lie { $gap } apart
seat-tip = Seat the tip
seat-gives-way = seat { $seat } is loose: the tip in it scatters by { $scatter }, in the others by up to { $expected }
seats = Seats
seats-held-out = Seats, cross-validated
seats-not-measured = { $count } seats with { $points } points each are needed
seats-were-taken-another-arm = The seats were measured with another arm.
second = { $text }, { $rate } per second
second-newest-old = { CLAUSE($text) }: { $rate } per second, the newest { $age } old.
second-picture-pose = { $place }: a second { $lighting } picture of pose { $pose }
see-result = See the result
seems-lie-where-certificate-puts = { $edge } seems to lie { $off } from its position in the certificate
not-sharp-enough = { $name } is not sharp enough for a reliable detection
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
not-visible-enough = { $name } is not visible enough for a reliable detection
send-support-bundle = Send the support bundle
sends-nothing =
    { $device ->
        [arm] the arm sends no data
       *[sensor] the sensor sends no data
    }
sensor = The sensor: { $text }
sensor-heading = Sensor
sensor-not-connected = the sensor is not connected
sensor-did-answer-laser-off = The sensor did not respond to Laser off
sensor-does-not-switch = { $title } does not change between pictures and lines
sensor-has-pixels = the sensor has { $width } × { $height } pixels
sensor-lost-exposure-longer-than = the sensor is disconnected, or its exposure is longer than that
sensor-measures-away-arms-last-joint = The measuring range of the sensor is { $away } away from the arm's last joint (limit { $farthest_mm }).
sensor-now-sends-pictures-pixels = the sensor now sends pictures of { $size } pixels
sensor-only-went-one-way-delay = the sensor moved in one direction only; a delay then looks like another position of the plane
sensor-reports-laser-other-state = the sensor reports the laser in the opposite state
sensor-sends-pictures-alone = { $title } sends pictures alone
sensor-turned-most-between-poses-wanted = The sensor rotated by at most { $turn } between the poses (required: { $alike_deg } or more), so they determine little more than a single pose.
sensor-went = the sensor moved at { $speed }; { $known }
sensor-moved-along-plane-without-effect = the sensor moved at { $along } along the plane and at { $across } across it; a delay has no effect along it
sensors-image-has-pixels = the sensor's picture has { $width } × { $height } pixels
sensors-laser-cannot-switched-here = this sensor's laser cannot be switched from here
sent-nothing-opening-again = The { $title } sent no data for { $silence }; reconnecting
sentence = { CAPITAL(CLAUSE($text)) }.
serial-number = serial number { $serial_number }
serial-number-charuco-squares-markers = { $serial_number }: ChArUco board, { $columns } × { $rows } squares of { $square }, { $dictionary }
serial-number-chessboard-inner-corners-squares = serial number { $serial_number }, chessboard, { $columns } × { $rows } inner corners, squares of { $square }
serial-number-joints-tip = serial number { $serial_number }, { $joint_count } joints, tip Ø { $diameter }
serial-number-merlons = serial number { $serial_number }, { $merlon_count } merlons, { $size } × { $size2 } × { $size3 }
serial-number-pixels = serial number { $serial_number }, { $width_px } × { $height_px } pixels
serial-number-poses-no-tip = serial number { $serial_number }, reports poses, no tip
serial-number-poses-tip = serial number { $serial_number }, reports poses, tip Ø { $diameter }
serial-port-use-another-program = The serial port { $url } is in use by another program
server-failed-what-taken-before-kept = An internal error occurred; all data recorded before is kept.
session-cannot-read-set-aside = The session { $session_id } cannot be read and is set aside: { $error }.
session-closed-start-new-one = This session is closed. Start a new one.
session-not-readable-with-change = the session could not be read with this change
session-has-no-picture = This session has no picture { $name }.
session-has-no-pose = there is no pose { $number } in this session
session-went-meanwhile-nothing-done = The session has advanced in the meantime; nothing was changed
sessions-arm-cannot-read = The session's arm cannot be read
sessions-gauge-arm-cannot-read-any = The session's gauge or arm can no longer be read
sessions-pictures-lie-inside-folder = a session's pictures must be inside its folder
set = set { $name }
set-arm-counts-per-revolution-station = Set [arm] counts_per_revolution in station.toml.
set-arms-specification-limit-where-next = Set the arm's specification as the limit at the start of the next check.
set-aside = Exclude
set-calibration-aside-start-again-beginning = Set this calibration aside and start again from the beginning?
set-cloud-aside = excluded a cloud
set-exposure-picture = set the exposure by the picture
set-exposure-stripe-bright-not-clipped = Set the exposure so that the stripe is bright but not clipped.
set-limit = set the limit
set-temperature = set the temperatures of artefact and arm
set-machines-clock-let-kept-time = Set the machine's clock, and synchronise it with a time server.
set-pose-aside = excluded a pose
set-sensor-back-calibrate-again = restore the sensor's settings, or calibrate again
set-sensor-back-scan-again = restore the sensor's settings, and scan again
set-sensor-rate-hz = Set [sensor] rate_hz.
set-up = Set-up
settings-are-lost = The settings were lost: { $error }
shorten-exposure-or-darken-room = Shorten the exposure, or darken the surroundings
not-to-be-used-findings-say-why = Do not use it: the findings state why.
show-more-block-crests-floors-front = Show more of the block: crests and floors, front and back.
picture-does-not-show-certificate-not-checked =
    { $detections ->
        [one] The picture does not show { $hidden }: the certificate is not checked there.
       *[other] The pictures do not show { $hidden }: the certificate is not checked there.
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
sign-browser-your-own = Sign in with your own browser
sign-go = Sign in and continue
signatures = Signatures
signed = signed in
signed-out = signed out
simulated-camera-is-lost = The simulated camera is disconnected
simulated-sensor-is-not-open = The simulated sensor is not open
since-calibration = { $celsius }, { $change } since the calibration.
size-expected = { $width } × { $height } pixels are expected
so-centre-known-k-1 = uncertainty of the centre { $centre_sd }, k = 1
so-plane-known-k-1 = uncertainty of the plane { $at } and { $arcsec }, k = 1
software = Software
software-part =
    { $part ->
        [processors] { $version } processors
       *[other] { $part } { $version }
    }
solve-again = Compute again.
compute-again = Compute again
solving-camera = Computing the camera
some-points-off-their-face-remove = Some points are off their face. Remove them, then continue.
somebody-must-able-give-people-access = somebody must be able to grant access
somebody-publishes-what-no-station-does = These messages do not come from a working station, and may hide or falsify what is displayed.
something-changed-since-solved-solve-again = Something has changed since the last computation. Compute again.
sphere = Sphere
sphere-of-diameter = sphere, { $diameter }
file-describes-sphere = { $path }: it describes a sphere
sphere-clamped = The sphere is clamped
sphere-known-diameter-clamped-firmly-within = A sphere of known diameter, clamped firmly within easy reach.
sphere-known-to = Ø { $diameter }, uncertainty { $known } (k = 1)
sphere-named = sphere { $name }
sphere-of-unknown-uncertainty = Ø { $diameter }, uncertainty not stated
sphere-not-touched-again = the sphere was not touched again at the end, so that it is not known whether it or the arm moved
sphere-or-arm-moved = sphere or arm moved by { $moved } during the test; the limit is { $limit }
sphere-too-small = the sphere has a diameter of { $diameter }; { $least } or more is needed
sphere-was-not-scanned = the sphere was not scanned
spheres = Spheres
spheres-held-out = Spheres, cross-validated
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
spread-needs-least-two-clouds = a range requires at least two clouds
spread-points-hold-still-press-arms = { $place } Spread { $wanted } points; hold still and press the arm's button at each.
spread-them-wide-clear-edges = Spread them widely, away from the edges.
square-mm-too-small = { $field } must be at least { $least }; is it in metres?
squares-too-small-in-picture = its squares are only { $width } wide in the picture; at least { $least } are required
not-by-standard-one-seat = Not according to a standard: one seat and a continuous swing instead of the positions and points of ASME B89.4.22 or ISO 10360-12. No result of these standards is claimed.
not-by-standard-other-positions = Not according to a standard: positions, articulations and counts differ from those of ISO 10360-8 and ISO 10360-12, so none of their symbols is used.
not-by-standard-other-touches = Not according to a standard: the contact points are not those of the sphere tests of ISO 10360-12, so none of its symbols is used.
standard-uncertainty-0-mm = The standard uncertainty must be 0 to { $largest }.
standard-uncertainty-k-1-scanned-point = Standard uncertainty (k = 1) of a scanned point over the laser plane, from { $low } ({ $low_mm }) to { $high } ({ $high_mm }). Struck through: extrapolated, nearer to or further from the camera than the calibrated { $near } to { $far }.
standard-uncertainty-mm-too-large = { $field } must be at most { $most }; is it in micrometres? For a block that nobody measured, state { $tolerance } instead
start-again = Start it again
start-again-within-sentence = start it again
start-new-calibration = Start a new calibration
started-scan = started a scan
state-bayer = State --bayer and --colour (of a folder: bayer and laser_wavelength_nm in sensor.json; of a station's camera: bayer and laser_colour)
state-first-id = if this is the board, state first_id: { $first } in its object.json; otherwise bring the board with its own ids into the picture
state-laser-colour = State laser_wavelength_nm in the sensor's datasheet (crenel extract, crenel detect: --colour), or give grey pictures
state-legacy-pattern = if this is the board, state legacy_pattern: { $legacy } in its object.json
state-rotation-in-arm-json = State the controller as rotation in arm.json, such as "rotation": "kuka"
state-squares = if this is the board, state squares_x: { $columns } and squares_y: { $rows } in its object.json, as counted on the board
state-squares-and-first-id = if this is the board, state squares_x: { $columns }, squares_y: { $rows } and first_id: { $first } in its object.json, as counted on the board
state-tip-uncertainty-or-unknown = State tip_uncertainty_mm, or write unknown for the diameter and add a width by another tool
state-uncertainty-in-mm = Give standard_uncertainty_mm in mm, k = 1
not-stated = not stated
station-does-not-answer-to-name = This server does not respond to the name '{ $name }'. Add names with hosts in { $file }.
station-ended-during-scan = The station ended during this scan.
station-has-administrator-already = The station already has an administrator
station-has-several-sensors-not-changed-here = this station has several sensors, which are not changed here
station-starting = The station is starting.
station-toml-bayer-alone = station.toml, [sensor]: bayer requires laser_colour, whose pixels are measured
station-toml-driver-has-no-option = station.toml, [{ $table }]: the driver has no option { $key }
station-toml-error-in-key = its key { $key } has an error
station-toml-error-in-line = it has an error in line { $line }
station-toml-exposure-range-alone = station.toml, [sensor]: exposure_range_us requires exposure_us as its initial value
station-toml-gives-counts-per-revolution = station.toml gives { $counts } counts_per_revolution, but the arm has { $joints } joints
station-toml-is-not-toml = it is not valid TOML
station-toml-key-not-for-video = station.toml, [sensor]: { $key } cannot be set for a video file
station-toml-no-such-driver = station.toml, [{ $table }]: there is no driver { $name }
station-toml-not-changed = { $file } was not changed
station-toml-option-missing = station.toml, [{ $table }]: the option { $key } is missing
station-toml-value-unusable = station.toml, [{ $table }]: { $key } = { $value } cannot be used: { $reason }
station-uses = The station uses { $process }.
station-uses-and-free = The station uses { $process }; { $free } is free.
stations-disk-full = the station's disk is full
step-before-one = That is not an earlier step.
step-cannot-be-read = it cannot be read as STEP, or not within 2 GB of memory
step-export-again = Export the part again as STEP (AP214 or AP242), or as STL
step-install-package = Install it with: { $command }; or export the part as STL
step-package-missing = STEP files require the package cadquery-ocp-novtk, which is not installed
step-takes-too-long = it takes longer than { $most } to become triangles
step-without-surface = it has no surface
still = Still
still-lines-left-out = { $count } of { $frames } frames show a line that stood still: of such a line, { $most } frames give points
still-running = { $title } is still running
still-turn = Remaining rotation
stop-before-next = stop it before the next one
stop-first = Stop it first
stop-simulation = Stop the simulated operator
stop-scan-first = stop the scan first
stop-server-give-one-data-folder = Stop that server, or give this one its own data folder with --data
stop-station-keep-copy-data-folder = Stop the station, keep a copy of the data folder, and start from the last backup.
stopped-by = { $name } pressed Stop in another browser: the laser is off.
stopped-by-what-kept =
    { $scan ->
        [yes] The running scan has ended. Its points are saved under Records.
       *[no] No scan was running.
    }
stopped-demonstration = Stopped the demonstration
stopped-laser-off = Stopped: the laser is off.
stopped-scan = stopped a scan
stopped-simulation = stopped the simulated operator
store-check-access = Check the keys and the permissions of the store
store-check-address = Mount its disk, or correct its address
store-check-network = Check the network, the endpoint and whether the store's server runs
store-make-room = Make room there
stored-under-records-scan-or-calibrate-again = It is in use, and listed under Records. The first button is the next step; you can also scan with it at once.
straight-above-chessboard-follow-dashed-outline = Starting straight above the chessboard: { $words }. Follow the dashed outline.
straight-edges-do-not-form-block = its { $segment_count } straight edges do not form a block
stripe-about-laser-plane-rms-points =
    Stripe about the laser plane, rms of { $points ->
        [one] { $points } point
       *[other] { $points } points
    }
stripe-axis = stripe axis "{ $axis }"
stripe-choice-is = the choice of the stripe is "{ $choice }"
stripe-extracted-grey-images-8-16 = a stripe is extracted from grey pictures of 8 to 16 bits, height by width
stripe-maximum-width-is = the maximum width of the stripe is { $width }
stripe-minimum-width-is = the minimum width of the stripe is { $width }
stripe-one-level-alone-does-fix = a stripe on only one level does not determine the laser plane
stripe-pieces-of =
    { $points ->
        [one] the minimum length of a stripe piece is { $points } point
       *[other] the minimum length of a stripe piece is { $points } points
    }
stripe-points-fit-one-laser-plane = { $points } stripe points fit one laser plane to { $rms } rms (limit { $stripe_rms_px }), { $share } of those on the object (limit { $agreeing }).
stripe-px = Stripe, px
stripe-smoothing-is = the smoothing of the stripe is { $smoothing }
stripe-threshold-is = the threshold of the stripe is { $threshold }
stripes-were-smoothed = Points smoothed along the laser line by { $smoothing } when they were recorded: structures shorter than { $half } keep less than half of their height, and neighbouring points share their noise
study-compares-several = a study compares several
study-left-out = { $name }: { CLAUSE($reason) }.
study-plane = the study is that of a plane
support-bundle-being-made-already = A support bundle is already being made
surface-not-curved = the surface is not curved
swing = Swing
swing-about-middle-limit = Each point of the swing relative to the mean of all points, in the arm frame. Dashed: the limit of { $limit }.
swing-arm = Swing the arm
swing-arm-about = Swing the arm about { $place }
swing-elbow-one-side-other-while = Swing the elbow from one side to the other while the tip stays in the seat
swing-further-least = Swing further: { $swing } of at least { $least_swing_deg }.
switch-arm-check-cable-port = Switch on the arm, and check its cable and the port.
switch-arm-off = Switch the arm off and on.
switch-arm-sensor-connect-them = Switch on arm and sensor, and connect them.
switch-laser-look-where-lies = Switch on the laser to see where the line lies.
switch-off-aim-picture-switched-itself = Switch it off to aim. It switches automatically for the picture.
switch-off-mirroring = switch off mirroring (horizontal or vertical flip) in the settings of the camera, or in the program that stored the picture
switch-one-laser-off-or-cover-it = Switch one laser off, or cover it, and take the pictures again
switch-one-laser-off-or-mask-its-place = Switch one laser off, or mask where its line lies
switch-over-part = switch it on over a part
switch-stop-scan = Switch it on, or stop the scan.
switch-to-raw-or-take-out-bayer = Switch the camera to raw pictures, or take out bayer
switched-laser = switched the laser on
switched-laser-off = switched the laser off
table-first-line-names = { $path }: its first line names { $names }
table-has-both = { $path } has the columns { $first } and { $second }
table-is-empty = it is empty; a line of column names is expected
table-is-workbook-or-no-text = this is the file of a spreadsheet program, or no text
table-lacks-column = its table { $table } has no { $column }
take-model-over-in-form-of-arm = It is the model of an arm: choose “New: Arm with joints”, then “Take the model from a text, a file or the list”
take-a-picture-in-each-pose = Take a new picture in each pose, and list it once
take-again = Repeat
repeat-it = repeat it
take-another = { $taken } Capture another: { $words }.
take-another-password = Choose another one
take-another-pose = Capture another pose
take-back = Include
take-bars-other-end-first-drop = Measure the other end of the bar first, or discard the last place.
take-longer-one-three-unrelated-words = Choose a longer one; three unrelated words are good
take-longer-pass-five-seconds-more = Make a longer pass, of five seconds or more
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
take-more-places-all-over-arms = Measure more places, all over the arm's reach
take-more-places-all-over-reach = Measure more places, all over the reach, and swing the arm from side to side in each
take-more-points-more-places = Take more points, in more places
take-more-poses-tilted-turned = Capture more poses, tilted and rotated.
take-more-poses-tilted-turned-have = Capture more poses, tilted and rotated; have the arm identified again.
take-more-there-delete-rows = Take more points there, or delete its rows
take-more-while-arm-swings = Take more points while the arm swings
take-one = Choose one of { $languages }
take-one-console-shows-since-stations = Use the code that the console has displayed since the last start of the station
take-one-place-two-if-there = Measure a ball bar in one or two places, if you have one.
take-out = Remove { $key }.
take-out-label-face-touched = Remove it, or label it with the face that was touched
take-pass-again = Repeat the pass
take-picture = Take the picture
take-picture-of-target =
    { $thing ->
        [board] take a picture of the board
       *[object] take a picture of the object
    }
take-picture-again = Take this picture again
take-picture-object = Take a picture of the object
take-pictures-different-distances-tilted-different = take pictures from different distances, or tilted to different sides
take-pictures-tilted-20-more-two = take pictures tilted by 20° or more to two sides
take-pictures-turned-20-more-about = take pictures rotated by 20° or more about two different axes
take-place-again-delete-rows = Measure this place again, or delete its rows
take-point = Take the point
take-points-or-delete-file = Take some points, or delete the file
take-poses-tilted-left-right-front = Capture poses tilted to the left, right, front and back, and rotated about the viewing direction.
take-these-points-again = Take these points again.
take-touch = Take the point
take-with-laser-or-describe-line = Take the picture with the laser on and the exposure set, or say what the line is like (--threshold, --min-width, --max-width): other things in the picture stand out as much
taken = { $path } was taken with { $device } { $recorded }
takes-notifications = { $host } accepts notifications.
taking-picture = Taking the picture
tells-whoever-away-what-done-fault = It informs people who are away about completed jobs, faults and due checks.
temperature = Temperature
test-performance = Test the performance
test-performance-again = Test again
test-u = U of test, k = 2
test-value-uncertainty = Test value uncertainty
test-value-uncertainty-text = Expanded uncertainty of artefact and set-up, k = 2. The scatter of arm and sensor is no part of it: the test measures it.
text-is-no-datasheet = it is no datasheet as JSON, and no certificate as XML
text-has-half-character = one of its texts contains an incomplete character
than-when-made-beyond-c-due =
    { $how ->
        [warmer] The temperature is { $difference } higher than at the calibration; due beyond { $limit }.
       *[colder] The temperature is { $difference } lower than at the calibration; due beyond { $limit }.
    }
the-is-for =
    { $device ->
        [sensor] the calibration is for { $known }
       *[arm] the arm.json is for { $known }
    }
there-dirt-tip-sphere = The tip measures { $diameter }, but the arm's datasheet states { $expected }: there is dirt on the tip or on the sphere.
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
there-no-gauge-data-folder-yet = There is no datasheet of a gauge yet.
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
there-no-performance = There is no performance test { $record_id }
there-no-picture-object-sensor-take = There is no picture of this object and sensor. Take one.
there-no-picture-yet-take-one = There is no picture yet. Take one.
there-no-points-rectangle = There are no points in the rectangle
there-no-scan = There is no scan { $scan_id }.
there-no-scan-find-delay = There is no scan to determine the delay from
there-no-simulation-real-devices = Real devices have no simulated operator.
no-simulation-of-real-devices = Real devices have no simulated operator
there-no-sphere-diameter-cloud = There is no sphere of { $diameter } diameter in this cloud
there-no-such-arm = There is no such arm.
there-no-such-artefact-here = There is no such artefact here.
there-no-such-cloud = There is no such cloud.
there-no-such-folder = there is no such folder
there-no-such-gauge = There is no such gauge.
there-no-such-page-3d-view = There is no such page of the 3D view.
there-no-such-touch = There is no such contact point.
there-no-token = There is no token { $token_id }.
there-no-valid-calibration = there is no valid calibration
there-no-verification = There is no verification { $record_id }.
there-no-kiosk-link = There is no kiosk link { $link_id }.
there-none-yet = There is no backup yet.
there-nothing = There is nothing at { $path }.
there-nothing-verify = There is nothing to verify
thermometer-cannot-read = The thermometer { $path } cannot be read: { $error }
thermometer-reads = The thermometer { $path } reads { $celsius }
these-files-what-result-made-accepted =
    { $changed ->
        [one] { $changed } of these files differs from what the result was computed from and accepted as.
       *[other] { $changed } of these files differ from what the result was computed from and accepted as.
    }
these-joint-angles-but-arm-json = these are joint angles, but arm.json states that the arm reports poses
these-metres-where-millimetres-expected = these are metres, but millimetres are expected
points-do-not-tell-better-than-tolerance = these points do not determine it better than its manufacturing tolerance
these-radians-where-degrees-expected = these are radians, but degrees are expected
these-use = Use these
these-use-and-pictures = Use these, then a picture at each rest
they-cannot-show-whether-arm-better = they cannot show whether the arm is better elsewhere
they-come-more-than-one-camera = they come from more than one camera, or were scaled
not-of-such-an-arm-or-tip-not-seated = they do not come from an arm of this kind, or the tip was not seated
they-do-not-determine-camera = they do not determine the camera
they-do-not-determine-centre = they do not determine its centre
they-do-not-lie-in-one-plane = they do not lie in one plane
they-fix-no-plane = they do not determine a plane
they-fix-no-sphere = they do not determine a sphere
they-leave-nothing-over-check-parameters = they leave no redundancy to check { $columns } parameters
they-lie-almost-one-plane-almost = they lie almost in one plane, or almost in one row on each level
they-recording-but-gave-no-points = They are in the recording but gave no points; check the arm's cable.
this-needs-pictures = this needs a picture of what the camera sees
this-program = this program
thread-has-died = Ended by an error { $ago } ago: { $name } ({ CLAUSE($error) }).
tilt-back-by = tilt to the back { $angle }
tilt-board-less = tilt the board less relative to the camera
tilt-front-by = tilt to the front { $angle }
tilt-left-by = tilt left { $angle }
tilt-level = Tilt from horizontal
tilt-right-by = tilt right { $angle }
time-from-zero-to = a time is from 0 to { $latest }
time-stamps-come-from =
    { $stamps ->
        [arrival] From the arrival of the data at this computer.
        [pulse] From trigger pulses that arm and camera count both.
       *[device] From the device's own clock.
    }
time-stamps-explained = Arrival varies by milliseconds, which costs accuracy while the arm moves. The device's own clock is better; trigger pulses are best.
time-stamps-of =
    { $device ->
        [arm] Time stamps, arm
       *[sensor] Time stamps, camera
    }
tip = Tip
tip-says = Tip: { $text }
tip-alone-never-shows-diameter = a smaller tip and a larger block give the same readings
tip-bars-end = The tip is in the bar's end
tip-check = Tip check
tip-diameter-not-shown = no reading shows the diameter of the { $tool }
tip-error-is-in-every-width = the error of the diameter is in every width
tip-held-seat-moved-max-min = The tip in a seat moved by { $worst }, (max − min)/2 on the worst axis.
tip-in-seat-moved-limit = The tip in a seat moved by { $worst }, (max − min)/2 on the worst axis; the limit is { $limit }.
tip-is-checked-in-a-seat = Turned about its tip in a seat, the arm shows whether the tip is where its model has it.
tip-itself-was-not-measured = the tip itself was not measured
tip-known = Tip uncertainty
tip-known-without-size = Over the reach the tip error was { $before } rms; the standard uncertainty is now { $after } (k = 1), without the arm's scale.
tip-lies-within-mm = the tip lies within { $distance } of it
tip-missing-place-flange-diameter = { $tip } is missing: its position on the flange and its diameter
tip-never-checked = The tip has never been checked.
tip-off-place-arm = Tip offset from its position on the arm
tip-over-whole-reach = Tip over the whole reach
tip-rather-has = the tip's diameter is probably { $diameter }, or the stated diameters of the spheres are wrong
tip-rather-has-or-bar-wrong = the tip's diameter is probably { $diameter }, or the stated diameters of the spheres are wrong, or the length of a bar is wrong
tip-rule-applies-to-error-alone = The rule applies to the diameter error. The scatter is compared directly with its limit.
tip-seat = The tip is in the seat
tip-seat-no-points-taken-there = The tip is { $left } away from the seat; no points are taken there.
tip-not-seated-or-seat-loose = the tip was not seated, the seat was loose, or points of another place are among them
tip-sits-off-its-place = The tip is { $off } away from its position in the datasheet: the stylus is bent or not tight.
tip-sound-diameter-off-touches-agree = The tip is in order: its diameter deviates by { $off }, and its contact points agree to { $scatter }.
tip-sphere-diameter-arm = of the tip from a sphere of that diameter, with the present arm model
tip-uncertainty-before =
    { $size_known ->
        [yes] was { $before }; k = 1, rms over the reach
       *[no] was { $before }; k = 1, rms over the reach; without the arm's scale
    }
tips-coordinates-moved-instead = the tip's coordinates are changed instead
tips-diameter = The tip's diameter
tips-diameter-has-no-uncertainty = { $place }: the tip's diameter has no uncertainty
tips-diameter-how-well-touches-agree = The tip's diameter, and the agreement of its contact points.
tips-diameter-off-known-only-k = The tip's diameter deviates by { $off }; its expanded uncertainty of { $known } (k = 2) is too large to prove that the limit is kept.
tips-places = Tip positions
tips-places-about-their-middle = Tip positions relative to their mean
title-performance-test = Performance test
titled-text = { $title }: { $text }
tls-give-own-key = Give the certificate with its chain, and its own key
tls-give-plain-key = Give the key without a password, readable only by the station
tls-key-encrypted-nobody-to-ask = it is encrypted, and there is nobody to enter its password
tls-key-unusable = { $file } cannot be used
tls-no-pair = they are not a certificate and its key in PEM format
tls-no-pair-reason = they are not a certificate and its key in PEM format ({ $reason })
tls-pair-unusable = { $certificate } and { $key } cannot be used
to = To
to-calibration = Keeps camera and mounting of { $name }. The board may lie elsewhere.
together = Together
tolerance-mm-out-of-range = { $field } must be above 0 and at most { $most }; measure a block that is made worse, and make its certificate of the readings
too-bright-saturated = Too bright: { $share } saturated
too-dark-brightest-parts = Too dark: brightest parts at { $level }
too-fast-blur-limit = Too fast: { $blur } of blur; the limit is { $limit }
too-few-edges-could-measured = too few of its edges could be measured
too-few-markers = { $field }: the board has { $count } markers, but { $dictionary } has only { $known }
too-few-places-were-touched = too few places were measured: { $count }
too-little-arm-data-yet = Too little arm data yet
too-many-wrong-tries = Too many failed attempts.
took-a-device-out = took a device out
took-cloud-back = included a cloud again
took-control-over = took over control
took-coordinates = took coordinates of a tracker
took-last-one-back = removed the last entry
took-over-control = { $name } took over control from { $holder }: { $reason }
took-picture = took a picture
took-picture-again = took a picture again
took-picture-bundle = saved a picture for support
took-point = took a point
took-pose-back = included a pose again
took-support-bundle = saved the support bundle
tool-found = { $value }, uncertainty { $known } (k = 1)
tool-of-reading = Tool
tool-zero-or-diameter = Zero error or tip diameter, { $tool }
top-all-around-side-wrist-turned = Touch its top and all around its side, with the wrist turned differently each time. Hold still and press the arm's button at each point.
topic-holds = { $path }: { $topic } contains { $schema } ({ $encoding })
total-k-1 = { $total } (k = 1)
touch = Touch it
touch-place = Touch { $place }
touch-heading = Touch
touch-again-beside-these = Touch two more places on each of their surfaces.
touch-all-over-upper-half-every = Touch it all over its upper half, from every side, with the arm in many postures. Hold still and press the arm's button at each point.
touch-back-face = Touch the back face.
touch-elsewhere = Touch it elsewhere
touch-face-also-beside-line = Touch the { $face } face beside that line as well
touch-floors-grooves = Touch the floors of the grooves.
touch-front-back-left-right-face = Touch the front and back faces, or the left and right faces.
touch-front-face = Touch the front face.
touch-gauge = Touch the gauge
contact-point-on-gauge = Contact point { $counted } on the gauge.
touch-gauge-more-places-scan-more = Touch the gauge at more positions, and scan it more slowly.
touch-in-another-posture = Points taken so are worse: take them in another posture, or move the object
touch-in-row = the touch in line { $line } ({ $face })
touch-left-end = Touch the left end.
touch-lies-beside-face = { $place }: the touch lies { $off } beside { $face }
touch-lies-on-face = it lies on { $face }
touch-lies-on-no-face = it lies on no other face, or on several
touch-more-contacts = Touch { $contacts }
touch-more-least-places = Touch more points: { $taken } of at least { $touches_needed }.
touch-more-least-points = Touch more points: { $taken } of at least { $least }.
touch-more-places = Touch more points
touch-more-points-spread-wide-over = Touch more points, spread widely over the board.
touch-more-points-on-all-faces = Touch more points, spread widely over all six faces.
touch-more-sphere = Touch more of the sphere
touch-near-corners-too = Touch it near its corners as well
touch-object = Touch the object
touch-object-or-remove-wrong = Touch the object, or remove point { $number } if that one is wrong
touch-off-plane = This touch lies { $off } off the plane that was touched before; it was not taken
touch-opposite-faces-tilt-more = Touch opposite faces (left and right, front and back, crests and floors), and tilt the sensor more between poses
touch-printed-side-more-times-spread = Touch the printed side { $left } more times, spread widely. Or continue.
touch-printed-side-once-more-far = Touch the printed side once more, far from the other points. Or continue.
touch-probe-press-arms-button-each =
    { $shape ->
        [plane] Touch it with the probe near its corners and in its middle, and press the arm's button at each point.
       *[sphere] Touch it with the probe on its top and all around its side, and press the arm's button at each point.
    }
touch-right-end = Touch the right end.
touch-same-plane = Touch the same face, or take its touches back and begin again
touch-scan-gauge-takes-two-minutes = { $text } Touch and scan a gauge: it takes two minutes.
touch-sphere = Touch the sphere
touch-sphere-more-spread-over-all = Touch more points on the sphere, spread over its whole upper half.
touch-top-all-around-side = Touch its top and all around its side
touch-tops-merlons = Touch the crests.
touch-two-faces-of-two-axes = touches on two faces each of two axes are needed, such as all edges, front and back
touched-centres-of-position = By touch, position { $position }
touched-places-of-position = Touched sphere, position { $position }
touched-sphere-seems-to-have-diameter = The touched sphere measures { $radius } in diameter, but its certificate states { $radius2 }.
touches = { $done } of { $of } contact points
contact-points-label = Contact points
contact-points-heading = Contact points
touches-about-sphere-limit = Distance of each contact point from the sphere fitted to all of them. Dashed: the limit of { $limit }.
touches-agree = Agreement of contact points
tip-points-off-sphere-of-others =
    { $count ->
        [one] Point { $points } is { $scatter } off the sphere of the others.
       *[other] Points { $points } are up to { $scatter } off the sphere of the others.
    }
touches-agree-if-exchanged = all touches agree if the names of { $one } and { $other } are exchanged
touches-agree-in-unit = { $place } and the following: the touches agree with the drawing if they are in { $unit }
touches-are-joint-angles = { $path } has the joint angles of an arm
touches-are-mirror-image = the touches are those of the block's mirror image
touches-disagree-up-tip-sphere-loose = The contact points disagree by up to { $scatter }: the tip or the sphere is loose, or the arm slipped.
touches-do-not-show-place = the touches do not show where the block stands
touches-enough = { $done } contact points are sufficient
touches-lie-too-near-together-one = The contact points are too close together, or on one ring around the sphere
touches-lie-within-one-line = The contact points lie within { $width } of one line
touches-miss-places = no touch lies near the places { $places } of the sphere
touches-missing-of-pattern = only { $count } of the { $needed } touches were taken
touches-of-face = Touches
touches-on-face = { $count } { $where }
touches-over-all-faces = { $total } more over all faces, { $most } of them { $where },
touches-rms-known-k-1 = { $touches } contact points, { $rms } rms, uncertainty { $known } (k = 1)
touches-scatter-more = The touches scatter { $times } times as much as they state; the uncertainties of each by itself are larger by this factor.
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
trial-nobody-looked = Closed, because nobody was looking any more
trial-takes-too-long = Closed after { $limit }
trial-was-ended = The device was closed
tried-a-device = tried a device
tried-notifications = tested the notifications
trigger-camera-otherwise = Connect an arm with a trigger output, or let the camera run freely.
try-again = Try again
try-again-ask-administrator-new-password = Try again, or ask an administrator for a new password
try-again-if-happens-again-stations = Try again. If it happens again, the station's log has the details.
try-again-moment = Try again in a moment
turn-anticlockwise-by = rotate anticlockwise { $angle }
turn-clockwise-by = rotate clockwise { $angle }
turn-down-exposure-until-objects-faces = lower the exposure until the object's faces are no longer overexposed
turn-fault-switch-camera-lost-off = Its fault switch camera_faults.lost is on; turn it off.
turn-lamp-until-all-edges-block = Move the lamp until all edges of the block are visible, and take another picture.
turn-off-cameras-mirroring-turn-object = turn off the camera's mirroring, or turn the object so that its front faces the camera
turn-sensor-so-laser-falls-onto = turn the sensor so that the laser falls onto the board from above
turn-up-light-exposure = increase the light or the exposure
turn-up-light-exposure-look-object = increase the light or the exposure, and check the object
two-lines-in-pictures = two laser lines are in { $two } of { $of } pictures, and the points may jump between them. Switch one laser off, mask it (--mask), or take one of them in every column (--choice first or last)
two-lines-in-the-pictures-of-poses = two laser lines are in the pictures of poses { $poses }
two-lines-in-this-picture = Two laser lines are in this picture.
two-reasons = { $first } and { $second }
two-boards-in-picture = two boards of { $columns } × { $rows } inner corners are in the picture
two-pictures-named = two pictures are named { $name }, and would be one file in { $folder }
two-s-of-distances = 2 s of these distances
two-seats-or-seat-carried = they belong to two seats, or the seat was moved in between
two-seats-or-seat-carried-or-arm = they belong to two seats, or the seat was moved in between, or arm.json belongs to another arm (in other seats, too, its tip moves by { $far })
two-units-of-length = The table states two units of length: { $units }
u-v = it is "u" or "v"
udp-port-cannot-be-opened = UDP port { $port } of this computer cannot be opened: { $reason }
udp-port-in-use = Another program on this computer receives at UDP port { $port }
uncertainties-above-largest = { $field } needs { $one } beside it, which is the largest of them
uncertainties-of-edges-count = { $field } has { $found } edges, but the block has { $wanted }
uncertainty-above-zero-up-to = an uncertainty in mm above 0 and up to { $most } is expected
uncertainty-budgets = Uncertainty budgets
uncertainty-is-not-the-root-of-its-budget = expanded_uncertainty is not twice the root of the sum of squares of its budget
uncertainty-is-root-of-parts = U is the root of the sum of squares of its parts, all with k = 2. Gauge: U of test. Probe: of the contact points. Points: by the scatter of the points of a cloud. Clouds: by their scatter. Mean, standard deviation and range are over the clouds.
unattended-stop = Scan and laser were stopped: for { $limit }, nobody was in control and the arm stood still.
unattended-stop-remedy = What was recorded is kept. To go on, start again; the time is in the settings.
uncertainty-missing = { $file }: uncertainty is missing
uncertainty-or-tolerance = exactly one of { $one } and { $tolerance } is needed: the first if the block was measured, the second if only its drawing is known
uncertainty-over-measuring-volume = Uncertainty over the measuring volume
uncertainty-scanned-point-k-1 = Uncertainty of a scanned point (k = 1)
uncertainty-scanned-point-so-far-k = Uncertainty of a scanned point so far (k = 1)
uncertainty-seen-point-k-1 = Uncertainty of a point in view (k = 1)
uncover-board-light-evenly = uncover the whole board, focus the camera, and light the board evenly
uncover-board-or-give-its-certificate = uncover the whole board and light it evenly; if the board has no more corners, give its own certificate
uncover-or-bring-more-of-board = uncover the board, bring more of it into the picture, sharp and evenly lit
undecided = Undecided
undid-a-cut = brought points back that had been cut away
undo = Undo
undo-last-point = Undo the last point
uninstall-one-them = Uninstall one of them.
unit = Unit
up-poses = { $done } of up to { $of } poses
up-to-taken-one = the limit is { $rms }
update-program-arms-firmware = Update this program or the arm's firmware.
upper-left-square-black = the upper left square of the board in the picture is black
upper-left-square-white = the upper left square of the board in the picture is white
upright-edge-of-merlon =
    { $end ->
        [back]
            the upright back edge on the { $side ->
                [right] right
               *[left] left
            } of merlon { $number }
       *[front]
            the upright front edge on the { $side ->
                [right] right
               *[left] left
            } of merlon { $number }
    }
ur-arm-off = The joints of the robot at { $address } are without power; their angles are not measured
ur-has-not = The robot at { $address } does not offer { $names }
ur-keep-tool = Keep one active tool during a session. The connection opens again by itself; then repeat the last action.
ur-no-answer = The robot at { $address } accepts the connection but does not answer as RTDE does
ur-no-rtde = What arrives from { $address } is no RTDE ({ $reason })
ur-nominal-only = The text has no factory calibration: the rows delta_theta, delta_a, delta_d and delta_alpha are in calibration.conf.
ur-not-calibrated = The file says of itself that the arm was not calibrated (calibration_status = 0)
ur-rate-too-high = The robot at { $address } sends at most { $fastest }, but station.toml states { $rate }
ur-does-not-speak-rtde-2 = The robot at { $address } does not speak version 2 of RTDE
ur-refuses-start = The robot at { $address } refuses to send data
ur-row-malformed =
    { $there ->
        [yes] The row { $name } is damaged
       *[no] The row { $name } is missing
    }
ur-six-numbers = six numbers in brackets are expected in each row
ur-switch-on = Switch the robot arm on at its teach pendant.
ur-tool-changed = The active tool (TCP) of the robot at { $address } was changed
ur-update-polyscope = Update PolyScope, the robot's software, to 3.12 (CB3) or 5.5.1 (e-Series) or later; on older software, use report = "joints".
urdf-axis-is-zero = Joint { $name }: its axis has no direction
urdf-branches = At link { $link }, the robot branches: { $links }
urdf-chain-too-long = { $joints } rotary joints lead to link { $end }: an arm has five to seven
urdf-chain-too-short =
    { $joints ->
        [0] No link of the robot follows a rotary joint
       *[other] No link of the robot follows five rotary joints: the most is { $joints }
    }
urdf-circle = The links before { $link } follow each other in a circle
urdf-continuous = Joints that turn without end (continuous) have limits of ±360°.
urdf-first-link = it is the first link before the joints of the arm
urdf-flange = a tool is mounted there by its name
urdf-has-metres = Give the lengths of a URDF in metres
urdf-is-xacro = The text is a xacro, from which a URDF is made
urdf-joint-cannot-be-used = Joint { $joint } between { $base } and { $end } cannot be used
urdf-joint-follows-not-reported = it follows joint { $other } (mimic), so the arm does not report its angle
urdf-joint-kind =
    { $kind ->
        [prismatic] it slides (prismatic)
       *[other] its type is { $kind }
    }
urdf-kinds = the robot has these joints: { $kinds }
urdf-meshes =
    { $count ->
        [one] One mesh is named in the file: it is not needed, and not read.
       *[other] { $count } meshes are named in the file: they are not needed, and not read.
    }
urdf-numbers = Joint { $joint }: { $name } is { $text }
urdf-numbers-expected =
    { $count ->
        [one] a number is expected
       *[other] { $count } numbers are expected, separated by spaces
    }
urdf-only-end = the robot ends there
urdf-without-joints = The URDF has no joint
not-usable-because = Not usable: { $fault }
not-usable = Not usable
usable-attention = Usable, with attention
usable-edge-stripe-points = { $found } usable edge and stripe points
usable-edge-stripe-points-poses = { $found } usable edge and stripe points in { $views } poses
usable-most = { $total }; the limit for usable is { $usable }.
use = In use
in-use-named = { $name } is in use.
use-a-chessboard-or-leave-out-the-option = Use a chessboard, or leave out the option
use-arm-before-what-identified-kept = Use the previous arm again? The identification is kept in this session.
use-arm-now = Use this arm from now on
use-block-better-certificate = Use a block with a better certificate.
use-board-even-odd-count-inner = use a board with an even number of inner corners in one direction and an odd number in the other
use-full-pictures-one-sensor = use full pictures of one sensor
use-full-pictures-one-sensor-neither = use full pictures of one sensor, neither cropped nor scaled
use-method-joint = Use --method joint
use-method-joint-pictures-board-several = use --method joint, with pictures of the board from several sides
use-object-higher-step-show-crests = use an object with a higher step, and show it crests and floors, front and back
use-object-whose-merlons-differ-width = use an object whose merlons differ in width
use-shorter-cable-port-own-close = Use a shorter cable and a separate port; close other programs on this machine.
use-switch-sensor = use the switch on the sensor
do-not-use = Do not use
used-but = Used, but { $reason }
used-but-within-sentence = used, but { $reason }
user-may-not-open-serial-port = This user may not open the serial port { $url }, or another program uses it
value = Value
value-empty = it is empty
value-expected-between = a value from 0 to { $largest } is expected
value-missing = it is missing
value-must-be = it must be { $expected }
value-must-be-at-least = it must be at least { $limit }
value-must-be-at-most = it must be at most { $limit }
value-must-be-date = it must be a date of the years 1 to 9999
value-must-be-finite = it must be a finite number
value-must-be-greater = it must be greater than { $limit }
value-must-be-iso-date = it must be a date such as 2026-03-31
value-must-be-less = it must be less than { $limit }
value-must-be-list = it must be a list
value-must-be-number = it must be a number
value-must-be-object = it must be an object with fields
value-must-be-one-of = it must be one of { $expected }
value-must-be-text = it must be text
value-must-be-true-or-false = it must be true or false
value-must-be-whole-number = it must be a whole number
value-must-match-pattern = it must match the pattern { $pattern }
value-not-known = it is unknown
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
value-with-spread = { $value } { $spread }
values-in-micrometres = Values, µm
values-shares-their-limits-bar-expanded = Values relative to their limits: the bar is the expanded uncertainty (k = 2) that the limit is judged by, circles are the single clouds.
verification = Verification
verification-cannot-read = The verification { $one } is unreadable.
verification-closed-start-new-one = This verification is closed. Start a new one.
verification-cloud = Verification, cloud { $number }
verification-failed-ago = It failed { $ago } ago. { $text }
verification-gauge =
    { $shape ->
        [sphere] Verification on a gauge sphere
       *[plane] Verification on a gauge plane
    }
verification-undecided-ago = It was undecided { $ago } ago. { $text }
verification-under-way-go-where-stands = A verification is in progress. Continue where it stopped.
verified = Verified: { $text }
verify = Verify
verify-again = Verify again
verify-against-gauge-calibrate-again = Verify against a gauge, or calibrate again.
video-file = The video file { $source }
video-has-no-picture = { $title } contains no picture
video-stream = The video stream { $source }
video-without-rate = { $title } does not state its frame rate
wait = Wait for it
wait-because = Wait: { CLAUSE($text) }.
wait-check-what-taken-kept = Wait, or check it. All recorded data is kept.
wait-moment-load-page-again = wait a moment, or reload the page
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
waits-for-new-rest = Waits until the robot rests at a new pose with the board in the picture
wanted-points-fit = target: { $target }; points fit to { $rms }
webhook = Webhook
went-another-pose = continued with another pose
went-back-points = returned to the points
went-more-clouds = continued with more clouds
went-result = continued to the result
went-step-back = went back one step
went-without-probe = continued without contact points
what-and-why = { CAPITAL(CLAUSE($what)) }: { CLAUSE($why) }.
what-calibrated = What was calibrated
what-cannot-read-set-aside-everything = Unreadable records are set aside unchanged; everything else is available.
what-checked = What was checked
what-clouds-show-against-certificate = The clouds compared with the gauge's certificate and with the probe.
what-figures-mean = What the figures mean
what-figures-mean-text = Each error of arm and sensor shows in some figures and hides in others. If figures exceed their limits together, this table tells where to look first.
what-identified = What was identified
what-is-calibrated = What is calibrated
what-looks-may-good-bad = The state of what it checks is unknown.
surface-is-not-a-plane = the scanned surface is not a plane
what-recorded-kept = { $interrupted } All recorded data is kept.
recorded-data-kept = All recorded data is kept.
request-did-not-arrive = The request did not arrive within { $limit }.
what-shows-could-more-than-one = the visible part could be more than one part of the object
what-shows-reads-rather-like-objects = the visible part looks more like the object's mirror image
what-standard-uncertainty-k-1-scanned = Sources of the standard uncertainty (k = 1) of a scanned point.
what-taken-kept-folder = All recorded data is kept in its folder.
what-tested = What was tested
what-tip-moved-while-held-one = How far the tip moved while it was held in one place.
what-verified = What was verified
where-sensor-sits-along-axis-cannot = the sensor's position along that axis cannot be determined
which-board-not-certain = which of them is { $name } is not certain
who-reads-along-has-passwords-can = Anyone who reads unencrypted traffic has the passwords and can act as other people.
whoever-helps-you-asks-first = Support asks for this first.
whole = It is intact, { $size_mb }.
whole-number-zero-more-expected = a whole number, zero or more, is expected
whole-program-stood-still-longest =
    { $count ->
        [one] the whole program was suspended once, for { $longest }
       *[other] the whole program was suspended { $count } times, for up to { $longest }
    }
why = Why
wide = { $wide } wide
widths-positive-ascend-choice-one = widths are positive and ascending; the choice is one of { $choices }; the smoothing is at least 0 and at most { $smoothing }
with-radius = radius { $radius }
with-tip = tip { $diameter }
within-limit = Within the limit
within-limit-m = { $half_range }, within the limit of { $limit }.
without-ball-bar-arm-keeps-size = Without a ball bar the arm keeps the scale of its datasheet.
without-ball-bar-arms-size-observable = without a ball bar the arm's scale is not observable
without-free-memory-whole-machine-slows = Without free memory the whole machine slows down, and frames are lost.
without-marker-coordinates-are-tips = without the column marker, coordinates are those of the tip
without-nothing-measured-what-taken-kept = Nothing is measured without it; all recorded data is kept.
without-one-pixels-cannot-become-points = without one, pixels cannot be converted to points
without-schema = without a schema
write-all-numbers-with-point = Write all numbers with a decimal point
write-readings-of-arm = Write the readings of the arm, with their times
xlsx-extra-missing = Needs XlsxWriter on the station: pip install 'crenel[xlsx]'
xlsx-package-missing = XLSX files require the package XlsxWriter, which is not installed
xml-document-type-refused = the file has a document type (DOCTYPE or ENTITY), and is therefore not read
xml-is-no-urdf = The text is XML with the element { $name } outside, but that of a URDF is robot
xml-not-well-formed = the file is not well-formed XML: { $error }
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
word-performance-test = performance test
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
working-out-error-budget = Computing the error budget
working-out-uncertainty = Computing the uncertainty
working-out-which-pose-would-help = Computing the most useful pose
worn-has-flat = The tip measures { $diameter }, but the arm's datasheet states { $expected }: it is worn, or has a flat.
write-one = enter one
writing-cloud = Writing the cloud
writing-scan = Writing the scan
wrong-code = wrong code
wrong-password = wrong password
you-do-not-have-control = You do not have control
zone-has-no-area = zone { $number } has no area
zone-outside-picture = zone { $number } lies outside the picture
zone-reaches-far-beyond-picture = zone { $number } reaches far beyond the picture
zones-cannot-set-now = zones cannot be set now
zones-picture-pixels-left-out-sensors = The zones are for a picture of { $width_px } × { $height_px } pixels and are not used; the sensor's picture has { $width_px2 } × { $height_px2 }

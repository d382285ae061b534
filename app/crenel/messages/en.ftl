accepted = Accepted
add-the-laser-to-camera-and-mounting = Take pictures in which the laser line crosses the board, and calibrate them with this calibration kept: by “Add the laser” on the Calibrate page, or on the command line with --camera-from
archive-fetch-record = In the archive only. Bring it back with: crenel archive fetch { $kind } { $id }
archive-install-library = Install it, for example with: pip install '{ $library }'
archive-missing = The archive { $place } is not there
archive-not-set = station.toml names no archive
archive-on-same-disk = The archive { $place } is on the same disk as the data folder: it protects from deleted files only.
archive-write-table = Add [archive] to station.toml as docs/formats.md shows
arm = Arm
arm-has-joints = the arm { $arm } has { $count } joints
arm-measures-within = the reach of an arm is at most { $farthest }
arm-says = The arm: { $text }
arm-without-tip-touches-nothing = { $name } has no tip and touches nothing. Go on without points.
ask-somebody-with-role =
    { $role ->
        [admin] Ask an administrator
       *[operator] Ask an operator
    }
at-most-limit = ≤ { $limit }
back = Back
batch-name-a-place = Name the archive or the data folder of a station, or what several archives are in
before-after = Before and after
begun = Started
calibration = Calibration
calibration-is-for-pixels = the calibration is for { $width } × { $height } pixels
calibration-no-longer-here = The calibration of { $name } no longer exists here
camera-and-laser-apart-on-a-board-only = camera and laser are calibrated apart on a chessboard only
camera-and-mounting-are-kept = Camera and mounting are kept from the calibration before; only the laser plane is new.
cannot-start = { $title } cannot start
capital = { CAPITAL($text) }
certificate = Certificate
channel-grey = grey
check-connection = Check its connection.
check-current-step = Check the current step and act on it
check-lasers-interlock-key-switch-capture = check the laser's interlock and key switch, and capture again
checked = Checked
cloud = Cloud
cloud-not-in-data-folder = The cloud of { $name } is not in the data folder
convert-columns-x-mm-y-mm = Convert the columns x_mm, y_mm and z_mm to millimetres
coordinates-measured = Measured coordinates
correct-it = Correct it
correct-remove-file = Correct or remove the file.
data-folder = Data folder
data-folder-cannot-be-used = The data folder { $folder } cannot be used
data-lost-now = Much of the data from the { $title } is being lost or comes late.
devices = Devices
done = Done
drawing-scale = Scale { $scale } (A4)
end-it-first = End it first
excluded-for-reason = Excluded: { CLAUSE($text) }.
faces-are = the faces are { $names }
file-cut-off = the file is incomplete
format-expected = { $format } is expected here
frames-moved-near-the-arm = link frames of nearly parallel axes lay up to { $far } away in arm.json: they were moved near the arm, and describe the same arm
free-on-disk = { $free } is free on the disk of { $folder }
free-some-space = free some space
from-to = { $low } to { $high }
give-arm-its-own-times-or-no-other-traffic = Let the arm state the time of each measurement itself, or send each one at once, over a cable and without other traffic
give-folder-user-may-write-data = Give a folder that this user may write with --data
give-one-of = Give one of { $names }
give-right-file = Give the right file
go-scanning = Continue to scanning
hands-touch-declined-times = Contact point { $index } of the simulated operator was rejected { $attempts } times
has-coordinate = { $path } has a coordinate of { $coordinate }
install-extra = Install it with pip install "crenel[{ $extra }]"
install-version-later-one = Install that version or a later one
json-cut-off = it is not JSON, or is incomplete: { $reason }
least-needed = at least { $least } are required
limit = Limit
log-loop-failed = the loop { $name } failed; it is restarted, and this error is not logged again until it works
log-loop-goes-on = the loop { $name } goes on after { $stood }
log-loop-refused = the loop { $name } failed and is restarted: { CLAUSE($reason) }
log-loop-stands = the loop { $name } has stood still for { $stood } in { $where }
log-loop-works-again = the loop { $name } works again
log-thread-died = { $name } was ended by an error
look-last-message-let-simulation-try = Check the last message, and let the simulated operator try again
looked-pose = Pose { $number } evaluated
may-not-do-this =
    { $role ->
        [admin] { $name } may not do this: it requires an administrator.
       *[operator] { $name } may not do this: it requires an operator.
    }
mm = In mm
name-and-serial-number = { $name }, serial number { $serial_number }
no-limit-set-heading = No limit set
no-sensor-named = this station has no sensor named { $name }
no-such-file = there is no such file
nobody-signed-here = You are not signed in.
not-measured = not measured
not-saved = The change was not saved
object = Object
one-of-points-off = At least one of the points { $points } is off the surface
operator = Operator
pixels-alternate-as-raw = the pixels alternate as in a raw picture of a colour camera, but are measured as grey
plus-minus = ± { $uncertainty }
points = Points
points-lie-one-line = the points lie on one line
program-failed = an internal error occurred
qif-not-validated = this file is written after the schema of QIF 3.0, but was not validated against it
reading-in-row = reading { $number } ({ $first } to { $second })
rebuild-recording-crenel-reconstruct = rebuild it from its recording with crenel reconstruct
remove-point = Remove point { $index }
remove-touch-there-again-rest = Remove it and touch there again, holding still.
rename = Rename it
result = Result
results = Results
row-place = { $path } line { $line }
save-utf-8 = Save it as UTF-8
scan-running-already = a scan is already running
scan-saved-incomplete = { $name } is saved with { $count } points, but is incomplete: { $missing }.
scanning = Scanning
seat-named = seat { $name }
seats = Seats
sensor-heading = Sensor
sentence = { CAPITAL(CLAUSE($text)) }.
serial-number = serial number { $serial_number }
session-went-meanwhile-nothing-done = The session has advanced in the meantime; nothing was changed
settings-give-root-path = Give it as "/crenel": letters, digits and . _ ~ - between slashes, and not /api, /assets, /metrics or /viewer
sign-go = Sign in and continue
sign-in-no-provider = There is no provider of accounts here
software = Software
sphere = Sphere
sphere-named = sphere { $name }
spheres = Spheres
state-bayer = State --bayer and --colour (of a folder: bayer and laser_wavelength_nm in sensor.json; of a station's camera: bayer and laser_colour)
still-lines-left-out = { $count } of { $frames } frames show a line that stood still: of such a line, { $most } frames give points
still-running = { $title } is still running
stop-scan-first = stop the scan first
switch-one-laser-off-or-cover-it = Switch one laser off, or cover it, and take the pictures again
take-a-picture-in-each-pose = Take a new picture in each pose, and list it once
temperature = Temperature
text-has-half-character = one of its texts contains an incomplete character
there-no-account = There is no account { $name }.
there-no-calibration-use-yet = There is no calibration in use yet.
there-no-such-folder = there is no such folder
there-nothing = There is nothing at { $path }.
they-fix-no-plane = they do not determine a plane
tip = Tip
tool-zero-or-diameter = Zero error or tip diameter, { $tool }
total-k-1 = { $total } (k = 1)
touch-again-beside-these = Touch two more places on each of their surfaces.
touch-more-places = Touch more points
try-again = Try again
two-lines-in-this-picture = Two laser lines are in this picture.
use-shorter-cable-port-own-close = Use a shorter cable and a separate port; close other programs on this machine.
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
wait = Wait for it
wait-until-has-ended = wait until it has ended
what-and-why = { CAPITAL(CLAUSE($what)) }: { CLAUSE($why) }.
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
word-camera = camera
word-colder = colder
word-contact = contact
word-corner = corner
word-crest = crest
word-crests = crests
word-cylinder = cylinder
word-depth = depth
word-edges = edges
word-exposure = exposure
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
word-number = number
word-object = object
word-off = off
word-on = on
word-once = once
word-part = part
word-pictures = pictures
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
word-tip = tip
word-unknown = unknown
word-warmer = warmer

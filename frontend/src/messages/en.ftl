# The client's own texts; those of the station are in app/crenel/messages. In the syntax of Project Fluent.

ui-3d-view = 3D view
ui-95-percent-within = 95 % within
ui-a-kiosk-display = a kiosk screen
ui-a-kiosk-display-can-only-view = Kiosk screens are view-only.
ui-a-record-not-live = A record, not what is scanned now
ui-a-scan-is-running = A scan is running.
ui-a-usual-arm = A usual portable arm
ui-accepted = Accepted
ui-accepted-calibrations-appear-newest-first-accept = Accepted calibrations appear here, newest first. Accept one on the Calibrate page.
ui-accepted-verifications-appear-newest-first-make = Accepted verifications appear here, newest first. Start one on the Verify page.
ui-accounts = Accounts
ui-accuracy-of-a-scanned-point = Standard uncertainty of a scanned point, k = 1
ui-actions-by-user = Actions by user
ui-active = active
ui-activity-of-since = { $title }, { $who }, since { $since }
ui-activity-since = { $title }, since { $since }
ui-add = Add
ui-add-a-certificate-dcc = Add a certificate (DCC)
ui-add-a-file = Add a file
ui-add-a-joint = Add a joint
ui-add-a-length = Add a length
ui-add-a-table = Add a table (CSV)
ui-address = Address
ui-adjust-to-the-line = Set from the line
ui-administrator = administrator
ui-after = After
ui-after-lowercase = after
ui-against-a-gauge = against a gauge
ui-against-previous-calibration-dashed-uncertainties-both = compared with the previous calibration; dashed: the change that the uncertainties of both explain if the sensor did not move (k = 2)
ui-against-the-last-calibration = Compared with the last calibration
ui-against-the-mean-of-all = relative to the mean of all
ui-against-the-touched-gauge = relative to the touched gauge
ui-age = Age
ui-age-relative-to-the-newest-point = Age relative to the newest point
ui-alarm-and-more = { $alarm } (and { $n } more)
ui-alarms = Alarms
ui-all = All
ui-all-n = All { $n }
ui-all-records = All records
ui-all-stations = All stations
ui-also-rebuild-with-the-newer-ones = Also rebuild with the newer ones
ui-also-record-pictures = Also record pictures
ui-ambient = ambient
ui-ambient-temperature = Ambient temperature
ui-angle = Angle
ui-angle-between-laser-and-camera = Angle between laser and camera
ui-angle-between-the-normals = Angle between the normals
ui-angle-lowercase = angle
ui-another-arm = Another arm
ui-another-camera = Another camera
ui-answer = answer
ui-applies-browser-files-reports-csv-stay = Applies to this browser only. Files, reports and CSV always use mm and µm.
ui-apply-limits = Apply limits
ui-arm = Arm
ui-arm-and-sensor = Arm and sensor
ui-arm-and-tip = Arm and tip
ui-arm-check = Arm check
ui-arm-checks-max-min-2-worst = Arm checks: (max − min)/2 on the worst axis
ui-arm-checks-tip-checks-identifications-appear = Arm checks, tip checks and identifications appear here, newest first. Start one on the Arm & tip page.
ui-arm-identification = Arm identification
ui-arm-identifications = Arm identifications
ui-arm-in-use-by = arm in use: { $activity }
ui-arm-is-in-use-end-it = The arm is in use: { $activity }. End that and go on here? A scan is stopped and saved; a guided session stays open and can be resumed.
ui-arm-lowercase = arm
ui-arm-needs-its-model = A calibration needs the kinematic model of this arm with { $joints } joints: enter it, or add its arm.json, under Datasheets.
ui-arm-of-poses-needs-no-more = A calibration needs one. This arm reports poses, so that its name is enough.
ui-arm-sensor-detected-automatically-missing-device = Arm and sensor are detected automatically. If one is missing, the reason is shown. It reconnects automatically.
ui-arm-serial = arm { $serial }
ui-arm-swings-side-side-while-tip = An arm swings from side to side while its tip stays in a seat
ui-arm-tip = Arm & tip
ui-arm-with-joints = Arm with joints
ui-arms = Arms
ui-arms-main-button-continues-long-press = The arm's main button continues; a long press on undo goes back one step.
ui-arms-main-button-starts-ends-cloud = The arm's main button starts and ends a cloud. Undo excludes the last one; a long press on undo goes back one step.
ui-arms-main-button-takes-contact-point = The arm's main button takes a contact point. Undo removes it; a long press on undo goes back one step.
ui-arms-main-button-takes-long-press = The arm's main button takes the picture; a long press on undo goes back one step.
ui-arms-main-button-takes-point-undo = The arm's main button takes a point. Undo removes it; a long press on undo goes back one step.
ui-arms-main-button-triggers-large-button = The arm's main button does the same as the large button here.
ui-arranged-as-before-opencv-4-6 = Markers arranged as before OpenCV 4.6
ui-arrows-detected-minus-computed-corners-magnified = Arrows: detected minus computed, corners magnified { $times } times, the stripe { $stripe } times.
ui-arrows-detected-minus-computed-magnified-times = Arrows: detected minus computed, magnified { $times } times.
ui-artefact = Artefact
ui-articulations = Articulations
ui-as-a-check = { $label }, as a check
ui-as-drawn = As drawn
ui-as-fast-as-possible = as fast as possible
ui-as-its-certificate-says = Enter the values as its certificate or its maker states them.
ui-as-measured = As measured
ui-as-of = As of { $when }
ui-as-of-ago = as of { $age } ago
ui-as-people-call-it-optional = As people here call it; may stay empty.
ui-as-proposed = As proposed
ui-ask-administrator-new-link = Ask an administrator for a new link
ui-at-least-10-characters = At least 10 characters
ui-at-least-10-characters-sentence = At least 10 characters.
ui-at-the-original-speed = at the original speed
ui-at-times-the-original-speed = at { $n } times the original speed
ui-attention = Attention
ui-audit-log = Audit log
ui-automatic = Automatic
ui-automatic-lowercase = automatic
ui-back-to-live = Back to live
ui-back-to-the-calibration = Back to the calibration
ui-back-to-the-list = Back to the list
ui-back-to-the-table = Back to the table
ui-back-up-now = Back up now
ui-back-y = Back face Y
ui-backup = Backup
ui-backup-copies-calibrations-scans-accounts-settings = A backup copies calibrations, scans, accounts and settings while the station runs. To restore a backup, stop the station and start it with the backup folder:
ui-ball-bar = Ball bar
ui-band-is-permissible-error = the band is the permissible error
ui-bars-test-value-uncertainty-dashed-limit-as-of-test = Bars: test value uncertainty, k = 2. Dashed: the limit as of each test.
ui-base-z = Base Z
ui-before = Before
ui-before-and-after = Before and after
ui-before-difference-identified-arm-after-standard = Before: difference from the identified arm. After: standard uncertainty, k = 1. Both rms.
ui-before-lowercase = before
ui-before-measuring-touch-sphere-known-diameter = Before you measure, touch a sphere of known diameter nine times. This shows a worn, bent or wrong tip at once. It takes one minute.
ui-begun = Started
ui-being-checked = Being checked…
ui-being-measured = being measured
ui-being-scanned = being scanned
ui-beyond = above the limit of { $limit }
ui-beyond-the-chart = beyond the chart
ui-block-column = Block
ui-block-depth = Depth, front to back
ui-block-follows-the-numbers = The block appears here, with the laser line on it, as soon as it is designed.
ui-block-height = Height
ui-block-is-designed = The block is being designed
ui-block-under-the-laser = The proposed block with the laser line
ui-block-with-dimension = The block with the dimension that is typed
ui-blur = Blur
ui-blur-above-which-pass-too-fast = Maximum blur
ui-board-to-print = The board to print
ui-brighter = Brighter
ui-bring-back = Bring back
ui-browser-displays-notifications-only-over-https = This browser shows notifications only over HTTPS, or on the station itself. For HTTPS, set tls_certificate and tls_key in station.toml.
ui-buttons-that-change-something-are-disabled = Buttons that change something are disabled meanwhile.
ui-by-scan = By scan
ui-by-scan-takes-three-scans = By scan, each place also takes three scans of the whole bar, after its touches. This is fixed at the first touch.
ui-by-touch = By touch
ui-by-touch-and-by-scan = By touch and by scan
ui-by-webhook = By webhook
ui-calibrate = Calibrate
ui-calibrate-the-sensor = Calibrate the sensor
ui-calibrated-lengths = Calibrated lengths
ui-calibrated-to = calibrated { $low } to { $high }
ui-calibration = Calibration
ui-calibration-certificate-dcc = Digital calibration certificate
ui-calibration-good-check-gauge = Check the calibration with a gauge
ui-calibration-objects = Calibration objects
ui-calibration-old = calibration: { $age } old
ui-calibrations = Calibrations
ui-calibrations-older-versions-no-map = Calibrations from older versions have no map.
ui-calliper = Calliper
ui-camera = Camera
ui-camera-lowercase = camera
ui-camera-offline-picture-old = The camera is offline. This picture is { $age } old.
ui-cameras = Cameras
ui-cancel = Cancel
ui-cancel-the-test = Cancel the test
ui-cancelled = Cancelled
ui-cannot-displayed-files-missing-data-folder = This record cannot be shown: its files are missing from the data folder, or the station is offline.
ui-captured-picture-corners-outline-stripe = The captured picture with corners, outline and stripe
ui-cell-mean-points = each { $size } cell shows the mean of its points
ui-cells-can-be-pasted = Cells copied from a spreadsheet can be pasted: they fill the table from the chosen cell on.
ui-centre-error = Centre error
ui-centre-error-lowercase = centre error
ui-certificate = Certificate
ui-certificate-is-not-signed = The certificate (DCC) is in English and German. It is not signed, and not checked against the schema.
ui-certificate-is-not-utf-8 = { $name } is not a UTF-8 text: choose the certificate as XML.
ui-certificate-issued-on = Certificate issued on
ui-certificate-of = certificate { $certificate }
ui-certificate-valid-until = Certificate valid until
ui-certified-by = Certified by
ui-certified-by-help = As reports name it, with the number of the certificate if there is one.
ui-certify = Certify
ui-certify-a-block = Certify a block
ui-certify-this-block = Certify this block
ui-change = Change
ui-change-password = Change password
ui-change-the-password = Change the password
ui-changed-parameters-arm-uncertainty-k-1 = Changed arm parameters, with uncertainty (k = 1)
ui-changes-between-calibrations-appear-second-one = Changes appear here after the second calibration.
ui-charuco-board = ChArUco board
ui-check-network-page-reconnects-automatically-then = Check the network. When this page has reconnected, try again.
ui-check-the-arm = Check the arm
ui-check-the-tip = Check the tip
ui-check-where-largest-residuals-pose-excluded = Check where the residuals are largest. You can exclude a pose and include it again.
ui-checking-the-station = Checking the station…
ui-checks = Checks
ui-checks-could-not-loaded-they-reload = The checks could not be loaded. They reload when the station is back.
ui-checks-over-time = Checks over time
ui-chessboard = Chessboard
ui-chessboard-laser-stripe-across = A chessboard with the laser stripe across it
ui-choose-a-device-and-try-it = Choose a device and try it. Nothing changes until you use it.
ui-choose-a-file = Choose a file
ui-choose-a-picture = Choose a picture…
ui-choose-another-scan = Choose another scan to merge or compare them.
ui-choose-how-it-is-connected = Choose how it is connected, and enter its address.
ui-choose-none = Choose none
ui-choose-record = Choose { $name }
ui-choose-the-arm = Choose the arm
ui-clamp-gauge-within-arms-reach = Clamp a gauge within the arm's reach.
ui-clamp-must-not-move-between-first = Clamp the gauge. It must not move between the first contact point and the last cloud.
ui-clamp-object-cannot-move-until-last = Clamp the object so that it cannot move until the last picture is taken.
ui-clamp-object-clean-tip-takes-few = First clamp the object and clean the tip. The calibration takes a few minutes.
ui-clear = Delete all zones
ui-close = Close
ui-cloud = Cloud
ui-cloud-n = Cloud { $n }
ui-clouds = Clouds
ui-clouds-and-calibrations = Clouds and calibrations
ui-code = Code
ui-code-on-the-console = Code on the console
ui-coefficient = Coefficient
ui-coefficient-of-expansion = Coefficient of thermal expansion
ui-colour-by = Colour by
ui-colour-by-deviation = Colour by deviation
ui-columns-of-inner-corners = Columns of inner corners
ui-compare = Compare
ui-compare-with = Compare with
ui-compared-points = Compared
ui-compared-with-the-probe = compared with the contact points
ui-comparison = Comparison
ui-comparison-is-scatter-and-change = Each point from the plane through its neighbours on the other scan: the scatter of both scans, and what changed or moved between them. It is no measurement uncertainty.
ui-comparison-of-two-calibrations = The scans have different calibrations, whose errors are in it.
ui-complete-cloud-stays-end = At the end, the complete cloud stays here.
ui-complete-cloud-stays-replay-run-crenel = The complete cloud stays here. To replay it, run crenel replay again.
ui-completed-jobs-faults-due-calibrations-also = Notifies you when a job is done, a fault occurs or a calibration is due, even when another window is in front.
ui-connect-your-own-devices = Connect your own devices
ui-connected = connected
ui-connected-and-waiting-for-data = It is connected, and has sent nothing yet.
ui-connected-badge = Connected
ui-connecting = connecting…
ui-connecting-to-the-station = Connecting to the station…
ui-connection = Connection
ui-connection-lost-reconnecting = Connection lost, reconnecting…
ui-console-runs-crenel-displays-link-open = The console that runs Crenel shows a link. Open the link, or enter the part after code=.
ui-console-runs-crenel-states-reason-remedy = The console that runs Crenel shows the reason and the remedy. This page continues when the station has restarted.
ui-contact = contact
ui-contact-about = The contact tests of ASME B89.4.22: effective diameter of a master sphere, three seats, and a ball bar in twenty placements. 217 touches, about 40 minutes by hand.
ui-contact-needs = A calibrated master sphere, a conical seat that can be clamped in three places, and a ball bar with a certificate. Sphere or bar can be left out.
ui-contact-points-few-pictures-calibrated-sensor = From contact points and a few pictures to a calibrated sensor
ui-contact-points-from-above = Contact points from above
ui-contact-points-rms = Contact points, rms
ui-contact-test = Contact tests
ui-contact-test-title = Contact tests
ui-continue-the-test = Continue the test
ui-continue-this-scan = Continue this scan
ui-continue-to-home = Continue
ui-continue-verification = Continue verification
ui-control = Control
ui-control-and-sign-in = Control and sign-in
ui-control-requested = Control requested
ui-control-was-not-released = control was not released
ui-control-was-not-requested = control was not requested
ui-control-was-not-taken = control was not taken
ui-control-who = Control: { $who }
ui-convention = Convention
ui-coordinates-of-a-tracker = Coordinates of a tracker (coordinates.csv)
ui-coordinates-points-taken = Coordinates of a tracker: { $points } points taken
ui-copied-in-mm-and-m = Copied in mm and µm
ui-copy = Copy
ui-copy-as-csv = Copy as CSV
ui-copy-of = { $name } (copy)
ui-copying = Copying…
ui-corner = corner
ui-corner-residual = { $corner }: residual { $value }
ui-corner-zone-arrow-keys-move-delete = Corner { $corner } of zone { $zone }; arrow keys move it, Delete removes it
ui-corners = Corners
ui-corners-and-the-laser-stripe = { $corners } corners and the laser stripe
ui-corners-no-laser-stripe = { $corners } corners, no laser stripe
ui-corners-rms = Corners, rms
ui-correct-what-is-marked = Correct what is marked first
ui-correct-what-is-said = Correct what is said beside the drawing
ui-correlated-well-determined-together-less-well = Correlated: well determined in combination, less well individually
ui-corrupt-records = Corrupt
ui-country-of-the-laboratory = Country, as two letters
ui-create-account = Create account
ui-create-link = Create link
ui-create-the-administrators-account = Create the administrator's account
ui-create-token = Create token
ui-created-by = created by { $name }, { $when }
ui-crenellated-block = Crenellated block
ui-crenellated-object-laser-stripe-across = A crenellated object with the laser stripe across it
ui-crest-z = Crests Z
ui-cross-validated-places-left-out-fit = { $n ->
        [one] Cross-validated at { $n } place that was left out of the fit: rms, including encoder noise.
       *[other] Cross-validated at { $n } places, each left out of the fit in turn: rms, including encoder noise.
    }
ui-current-activity = Current activity
ui-current-step = Current step
ui-customer = Customer
ui-cut = Cut
ui-cut-points-away = Cut points away
ui-cut-what-is-inside = Cut what is inside
ui-cuts-leave-the-recording-whole = Saved clouds and measurements leave out what is cut away. The recording keeps it.
ui-cylinder = Cylinder
ui-dark-display = Dark theme
ui-darker = Darker
ui-dashed = dashed
ui-dashed-is-permissible-error = dashed is the permissible error
ui-dashed-the-limit = Dashed: the limit, ±{ $value }.
ui-data-types = Data types
ui-datasheet-is-not-utf-8 = { $name } is not a UTF-8 text: choose a datasheet as JSON, or a certificate as XML.
ui-datasheets = Datasheets
ui-days = { $n ->
        [one] { $n } day
       *[other] { $n } days
    }
ui-days-ago = { $n ->
        [one] { $n } day ago
       *[other] { $n } days ago
    }
ui-decision = Decision
ui-decision-rule-changed-values-comparable = The decision rule changed between these tests; values, uncertainties and limits remain comparable.
ui-degrees = degrees
ui-delay-between-arm-and-camera = Delay between arm and camera
ui-delete = Delete
ui-delete-recording-points-removed-disk-permanently = Delete { $name }? Its recording and its { $points } points are removed from the disk permanently.
ui-demonstration = Demonstration
ui-denavit-hartenberg-modified = Denavit-Hartenberg, modified
ui-denavit-hartenberg-standard = Denavit-Hartenberg, standard
ui-denavit-hartenberg-table = Denavit-Hartenberg table
ui-depth-of-field = Depth of field
ui-depth-of-grooves = Depth of the grooves
ui-depth-range = Depth range
ui-design-a-block = Design a block
ui-detected-line-drawn-red-picture-changes = The detected line is drawn in red on the picture. Changes apply at once and are saved.
ui-determine-from-the-last-scan = Determine from the last scan
ui-determined-not-in-use-yet = Determined, but not in use yet.
ui-determining-the-delay = Determining the delay…
ui-deviation = Deviation
ui-deviation-from = Deviations from { $name }, positive outside.
ui-deviation-from-scan = Deviation from { $name }
ui-deviation-from-the-shape = Deviation from the shape
ui-deviations-from-the-fitted-shape = Deviations from the fitted shape
ui-device-connection-lost = { $device }: connection lost
ui-devices = Devices
ui-devices-cannot-be-saved-here = Devices cannot be saved here
ui-diameter = Diameter
ui-diameter-error = Diameter error
ui-diameter-from-the-certificate = Diameter from the certificate
ui-diameter-of-the-spheres = Diameter of the spheres
ui-dictionary = Dictionary of the markers
ui-disk = Disk
ui-disk-space = disk { $space }
ui-dismiss = Dismiss
ui-displacement-scanned-point-since-rms-most = Displacement of a scanned point since { $name }: { $rms } rms, { $most } maximum.
ui-display = Display
ui-display-more = Show { $n } more
ui-displayed-scans = Scans in the view
ui-distance = Distance
ui-distance-between-the-centres = Distance between the centres
ui-distance-from-its-face-outward = Distance from its face; positive is outward.
ui-distance-known-once-board-touched-more = Touch the board in more places to see the distance.
ui-distance-known-once-three-adjacent-faces = Touch three adjacent faces to see the distance.
ui-distance-tips-centre-place = Distance of the tip's centre from its nominal position
ui-distances-rms = Distances, rms
ui-do-not-continue = Do not continue
ui-done = done
ui-done-of-all = { $done } of { $all }
ui-done-scan-saved-calibration-accepted = Done: a scan is saved, a calibration is accepted
ui-drag-corner-move-small-dot-add = Drag a corner to move it, or a small dot to add a corner. Delete removes a corner.
ui-draw-a-rectangle-around-what-goes = Draw a rectangle around what is to go.
ui-draw-a-rectangle-around-what-stays = Draw a rectangle around what is to stay.
ui-draw-a-rectangle-over-the-cylinder = Draw a rectangle over the cylinder
ui-draw-a-rectangle-over-the-plane = Draw a rectangle over the plane
ui-draw-a-rectangle-over-the-sphere = Draw a rectangle over the sphere
ui-draw-a-zone = Draw a zone
ui-draw-press-picture-drag = Press on the picture and drag to draw the zone.
ui-drawing-follows-the-numbers = The drawing follows the numbers.
ui-drawing-of-the-datasheet = Drawing of the datasheet
ui-drawn-as-the-arm-stands = Drawn as { $name } stands now: move a joint, and the drawing turns with it. Drag to look from another side.
ui-drawn-with-joints-at-zero = Drawn with all joints at 0°, or at the limit next to it. Drag to look from another side.
ui-due = due
ui-due-a-calibration-is-too-old = Due: a calibration is too old
ui-due-old = due, { $age } old
ui-duration = Duration
ui-edges = Edges
ui-edges-along-x = Edges along X
ui-edges-are-entered-as = The edges are entered as
ui-edges-rms = Edges, rms
ui-edit = Edit
ui-eight-poses = Eight poses
ui-else-as-identified = Rms over its reach; else as identified
ui-else-unknown = Of its diameter, k = 1; else the diameter counts as unknown
ui-empty-sizes-are-proposed = Sizes of the block: what is given is kept, an empty field is proposed.
ui-end-comparison = End the comparison
ui-end-it-and-go-on = End it and go on
ui-enter-it = Enter value
ui-enter-program-appears-only-once = Enter this token in the program. It appears only once:
ui-enter-readings-or-points = Enter readings, or add a table
ui-enter-the-model = Enter the model
ui-error-budget = Error budget
ui-error-budget-k-1 = Error budget, k = 1
ui-error-of-the-arm = Error of the arm
ui-errors = Errors
ui-errors-of-length = Errors of length
ui-errors-of-length-by-scan = Errors of length by scan
ui-every-arm-check-appears-over-time = The results of all arm checks appear here over time: (max − min)/2 of the tip on the worst axis, compared with your limit.
ui-every-cloud-verification-rebuilt-accepted-calibrations = The station rebuilds every cloud of this verification with each of the { $n } accepted calibrations, in the background. Differences from one calibration to the next come from the calibrations; differences from cloud to cloud come from the arm and the scanning.
ui-everything-is-in-order = Everything is OK
ui-exclude = Exclude
ui-excluded = excluded
ui-expanded-uncertainty-k-2 = U, k = 2
ui-expired-on = expired on { $day }
ui-exposure = Exposure
ui-face = Face
ui-faces = Faces
ui-faces-as-measured = Faces along their axes
ui-fail = Fail
ui-failed = Failed
ui-failed-lowercase = failed
ui-far-line-exceeds-surroundings-automatic-four = How much brighter than its surroundings the line must be. Automatic: four times the noise.
ui-fault = fault
ui-fault-device-lost-recording-failed = Fault: a device is lost, a recording has failed
ui-fetch = Fetch
ui-fetch-it-from-the-archive-first = Fetch it from the archive first.
ui-few-points = Few points
ui-fewer-points-this-browser-renders-slowly = Fewer points: this browser renders slowly
ui-field-at-the-stand-off = { $width } × { $height } at { $standoff }
ui-field-of-view = Field of view along the stripe
ui-figure = Quantity
ui-figure-over-clouds = 
    { $title }: { $of ->
        [mean] mean
        [range] range
       *[standard_deviation] standard deviation
    } over the clouds
ui-figures = Results
ui-file = File
ui-file-format = File format
ui-file-is-larger-than-datasheets = { $name } is too large for a datasheet: nothing was sent.
ui-file-missing-data-folder-changed = Its file is missing from the data folder, or was changed.
ui-files = { $n ->
        [one] { $n } file
       *[other] { $n } files
    }
ui-files-can-be-dragged-in = JSON as documented, or the certificate (DCC) of a sphere. Files can also be dragged in.
ui-files-of-record = Files
ui-fill-in-the-fields = Fill in the fields first
ui-fill-in-what-is-needed = Fill in the address first
ui-filters-used = Filters: points further than { $sigmas } standard deviations from the fit, and frames within { $place } of an earlier one, are not used; for the form of all points they are.
ui-findings = Findings
ui-finished-scans-appear-press-start-scan = Finished scans appear here. Press Start scan to make the first one.
ui-first-calibration-next-one-compared = This is the first calibration. The next one is compared with it here.
ui-fit-a-shape = Fit a shape
ui-fit-a-shape-first = Fit a shape first
ui-fitted-plane-outward-positive = from the fitted plane: blue inside, orange outside (positive)
ui-fitted-sphere-outward-positive = from the fitted sphere: blue inside, orange outside (positive)
ui-flat-chessboard-laser-line-crosses-also = You can also use a flat chessboard that the laser line crosses. Touching it is optional.
ui-flatness-of-the-board = Bend of the board
ui-fleet = Fleet
ui-fleet-affected = { $n ->
    [one] One recording is affected.
   *[other] { $n } recordings are affected.
}
ui-fleet-against = Against
ui-fleet-ageing = Ageing
ui-fleet-all-calibrations = All calibrations of each sensor; the newest is blue and large. The bar is the median ± one standard deviation.
ui-fleet-archived = Archived
ui-fleet-back = Back to the list
ui-fleet-broker-away = The broker cannot be reached: what the stations do now is unknown.
ui-fleet-calibration-choice = { $mark ->
    [used] { $name }, { $at }: in use then
    [newest] { $name }, { $at }: the newest
    [both] { $name }, { $at }: in use then, and the newest
   *[none] { $name }, { $at }
}
ui-fleet-calibration-doubt = { $doubt ->
    [wrong] Wrong by the drift of the tests: { $quantity } differs by { $size } with this calibration.
   *[perhaps] Perhaps wrong by the drift of the tests: { $quantity } differs by { $size } with this calibration, far from the others, but not surely further than they spread.
}
ui-fleet-calibration-doubted = { $doubt ->
    [wrong] { $choice } – wrong
   *[perhaps] { $choice } – perhaps wrong
}
ui-fleet-calibration-of-its-day = Of the day of the scan
ui-fleet-calibration-of-sensor = Calibration, sensor { $sensor }
ui-fleet-calibrations = Calibrations
ui-fleet-changed = Changed by { $size } ± { $uncertainty } { $unit } (k = 2) between { $earliest } and { $latest } (95 %).
ui-fleet-changes-by = { $since ->
        [calibration] Changes by { $slope } ± { $uncertainty } { $unit } (95 %), by { $n } values with { $groups } calibrations.
       *[first] Changes by { $slope } ± { $uncertainty } { $unit } (95 %), by { $n } values of { $groups } devices.
    }
ui-fleet-cloud = Elsewhere, on a computer that reaches these records, this command makes its cloud:
ui-fleet-cloud-failed = The cloud with { $calibration } is not made. { $why }
ui-fleet-cloud-format = Format
ui-fleet-cloud-is-being-made = The cloud with { $calibration } is being made
ui-fleet-cloud-is-made = It is made already
ui-fleet-cloud-waits = The cloud with { $calibration } waits for those before it
ui-fleet-clouds = Clouds
ui-fleet-collected = Collected
ui-fleet-count = Number
ui-fleet-days-reversed = From is after Until, so that no record can be found: choose an earlier From or a later Until.
ui-fleet-differed = Differs by { $size } ± { $uncertainty } { $unit } (k = 2) from the first value on, { $since }.
ui-fleet-doubtful = Perhaps wrong: { $calibration }, by { $size }, tested from { $since } to { $until }. It is far from the other calibrations, but not surely further than they spread.
ui-fleet-download = Download
ui-fleet-drift = Drift
ui-fleet-ended = Back to the right level by { $when }.
ui-fleet-expanded = U (k = 2)
ui-fleet-explained = Only the tests of this period used: { $calibrations }. The recordings with these are affected.
ui-fleet-file = File
ui-fleet-from = Collected from
ui-fleet-hours = Hours
ui-fleet-hours-since-calibration = Hours since the calibration in use
ui-fleet-hours-since-first = Hours since the first value of the device
ui-fleet-kind = Kind
ui-fleet-kind-performance = Performance test
ui-fleet-kind-scan = Scan
ui-fleet-label = Name
ui-fleet-lasts = It lasts.
ui-fleet-least-values = A period in which a figure differs is found if it has { $n } tests or more.
ui-fleet-left-out = Left out, because their calibration is not in the catalogue: { $n }
ui-fleet-level = { $n ->
    [one] { $value } from { $since } (one value)
   *[other] { $value } from { $since } ({ $n } values)
}
ui-fleet-make-cloud = Make cloud
ui-fleet-median = Median
ui-fleet-newest = Newest record
ui-fleet-newest-calibrations = Newest calibrations
ui-fleet-newest-value = Newest
ui-fleet-no-answer = The fleet's server does not answer, or its database cannot be used now. The stations go on, and nothing is lost.
ui-fleet-no-change-shown = { $since ->
        [calibration] No change is shown: { $slope } ± { $uncertainty } { $unit } (95 %), by { $n } values with { $groups } calibrations.
       *[first] No change is shown: { $slope } ± { $uncertainty } { $unit } (95 %), by { $n } values of { $groups } devices.
    }
ui-fleet-no-slope = Too few values for a trend.
ui-fleet-not-collected = On the broker, but not in fleet.toml: nothing is collected.
ui-fleet-not-on-broker = Not heard on the broker
ui-fleet-nothing-found = No record is found.
ui-fleet-object = Artefact
ui-fleet-only-on-station = Only on the station
ui-fleet-own-errors = The own errors of { $n } calibrations have a standard deviation of { $deviation }; changes that these explain do not count.
ui-fleet-own-errors-unknown = { $n ->
    [one] One calibration does not tell how far calibrations differ: a change may be an ordinary error of a calibration.
   *[other] { $n } calibrations with so few tests do not tell how far calibrations differ: a change may be an ordinary error of a calibration.
}
ui-fleet-place = Catalogue: { $place }
ui-fleet-possible = { $n ->
    [one] One more is perhaps affected.
   *[other] { $n } more are perhaps affected.
}
ui-fleet-quantity = Quantity
ui-fleet-records = Records
ui-fleet-right = { $because ->
    [most] Taken as right: { $value }, since { $since }, because { $n } of { $total } values have it. The values alone do not tell which level is right.
    [chosen] Taken as right, as chosen: { $value }, since { $since }; { $n } of { $total } values have it.
   *[first] Taken as right: { $value }, since { $since }, because it is the first level; { $n } of { $total } values have it. The values alone do not tell which level is right.
}
ui-fleet-right-level = Level taken as right
ui-fleet-right-proposed = As proposed
ui-fleet-session = Other session
ui-fleet-since = From
ui-fleet-size = Size
ui-fleet-software = Software
ui-fleet-spread = Spread of all calibrations
ui-fleet-standard-deviation = Standard deviation
ui-fleet-standing-out = { $n ->
    [one] One value stands out. Fewer than { $least } together are too few for a period.
   *[other] { $n } values stand out. Fewer than { $least } together are too few for a period.
}
ui-fleet-symbol = Symbol
ui-fleet-temperature-since-calibration = Above the temperature of the calibration in use
ui-fleet-temperature-since-first = Temperature
ui-fleet-then = Then { $value } from { $since }.
ui-fleet-times = Times: { $zone }
ui-fleet-until = Until
ui-fleet-verdict = Result
ui-fleet-with-the-password = With the password of this page
ui-fleet-words = Part, operator, id, serial number
ui-fleet-would-be-affected = { $n ->
    [0] No recording was made with it.
    [one] If it is wrong, one recording is affected.
   *[other] If it is wrong, { $n } recordings are affected.
}
ui-floor-z = Floors Z
ui-focal-length = Focal length
ui-for = for { $age }
ui-for-information-without-a-limit = for information, without a limit
ui-for-robot-cells-no-stop = For a robot cell whose scans are to run with nobody at a browser: nothing is then stopped by itself.
ui-form = Form
ui-form-deviation = Form deviation
ui-form-deviation-of-the-spheres = Form deviation of the spheres
ui-form-filtered = Form, filtered
ui-form-highest-to-lowest = Form, peak to valley
ui-form-of-all = Form of all
ui-found = found
ui-fps = { $n } fps
ui-frames-lost = { $n ->
        [one] { $n } frame lost
       *[other] { $n } frames lost
    }
ui-free = free
ui-from = From
ui-from-above = Above
ui-from-above-arm-below = From above, the arm below
ui-from-face-to-face = { $from } to { $to }
ui-from-left-to-right = Left to right
ui-from-the-front = Front
ui-from-the-recording = from the recording
ui-from-the-side = Side
ui-from-the-side-arm-left = From the side, the arm on the left
ui-from-to = { $from } to { $to }
ui-from-top-to-bottom = Top to bottom
ui-front-y = Front face Y
ui-furthest = furthest { $value }
ui-gate-of-plane = Gate of all points: the scanned area, within { $gate } of the plane.
ui-gate-of-sphere = Gate of all points: within { $gate } of the calibrated sphere, and { $angle } from the middle of the scan.
ui-gauge = Gauge
ui-gauges = Gauges
ui-give-control = Give control
ui-good-up-to-usable-up-to = Good up to { $good }, usable up to { $usable }.
ui-grey-far-beyond-them-no-statement = Grey: far outside these depths; no value is stated.
ui-grey-levels = grey levels
ui-groove-n = Groove { $n }
ui-has-control = { $name } has control.
ui-hatched-beyond-depths-stripe-covered-labelled = Hatched: outside the depths that the stripe covered. The label gives the largest value within them.
ui-health = Health
ui-height = Height
ui-height-in-pixels = Picture height, px
ui-height-of-floors = Height of the floors
ui-height-of-the-picture = Height of the picture
ui-help = Help
ui-hide-the-retired-ones = Hide the retired ones
ui-hold-sensor-object-fills-picture-laser = Hold the sensor so that the object fills the picture and the laser line crosses it.
ui-hold-sensor-over-chessboard = Hold the sensor over a flat chessboard that the laser line crosses, and take pictures from a few poses that the station suggests. You see the uncertainty of the result in { $unit } before it replaces anything.
ui-hold-still-place-arms-main-button = Hold still at each place. The arm's main button takes the point.
ui-hold-tip-cone-ball-seat-swing = Hold the tip in a cone or ball seat and swing the arm around it. The apparent motion of the tip is the arm's own error. This takes five minutes.
ui-home = Home
ui-hours = { $n ->
        [one] { $n } hour
       *[other] { $n } hours
    }
ui-hours-ago = { $n ->
        [one] { $n } hour ago
       *[other] { $n } hours ago
    }
ui-how-does-the-laser-line-run = How does the laser line run in the picture?
ui-how-lengths-are-measured = How the lengths are measured
ui-http-interface = HTTP interface
ui-http-interface-explained = Programs read and operate this station over HTTP, with the rights of the person or token that they sign in with.
ui-http-interface-version = HTTP interface, version { $version }
ui-hz = { $n } Hz
ui-id-of-the-first-marker = Id of the first marker
ui-identification-appears-arms-deviation-datasheet-uncertainty = Each identification appears here with its report, the arm's deviation from its datasheet and the uncertainty achieved.
ui-identifications = Identifications
ui-identify-the-arm = Identify the arm
ui-idle = Idle
ui-implied-probe-matrix-error = What the articulations say of the calibration
ui-in-gate = In the gate
ui-in-range = In range
ui-in-space = In space
ui-in-space-largest-2s = In space: largest, 2s
ui-in-this-browser = In this browser
ui-in-use = In use.
ui-in-use-badge = In use
ui-in-use-by = In use: { $names }
ui-in-use-name = In use: { $name }
ui-inches = inches
ui-include = Include
ui-initial-password = Initial password
ui-inner-corners-squares-of = { $columns } × { $rows } inner corners, squares of { $square }
ui-is-the-arm-in-order = Check the arm's accuracy
ui-is-this-the-right-device = Is it the right device, and does it run well?
ui-issue-date-unknown = age of the certificate unknown
ui-issued-on = issued on { $day }
ui-issued-on-with-age = issued on { $day } ({ $age })
ui-it-is-under-records = It is listed under Records. The next scan is a new one.
ui-items-need-attention = { $n ->
        [one] One item needs attention
       *[other] { $n } items need attention
    }
ui-its-figures-are-left-out = Its figures are left out.
ui-its-standard-uncertainty = Its standard uncertainty (k = 1)
ui-job = Job
ui-joint-a = a
ui-joint-alpha = α
ui-joint-column = Joint
ui-joint-d = d
ui-joint-encoder = Encoder, k = 1
ui-joint-highest = Highest
ui-joint-lowest = Lowest
ui-joint-n = Joint { $n }
ui-joint-sign = Sign
ui-joint-theta = θ
ui-judged-by = Judged by
ui-k-1-about-two-three-points = k = 1: about two of three points lie within this uncertainty. k = 2: about nineteen of twenty.
ui-keep-control = Keep control
ui-keep-elbow-and-wrist-as-they-are = Keep elbow and wrist of the arm as they are from the points to the pictures: errors of its links then cancel
ui-keep-only-what-is-inside = Keep only what is inside
ui-keep-stripe-gauge-move-slowly-points = Keep the stripe on the gauge and move slowly. Points appear as you pass.
ui-key-above = 3D view from above
ui-key-control = Ctrl
ui-key-enter = Enter
ui-key-front = 3D view from the front
ui-key-help = These keys
ui-key-main = The large button: take, start, stop or continue
ui-key-side = 3D view from the side
ui-key-stop = STOP, whatever is open
ui-key-undo = Undo the last point
ui-key-whole = 3D view of the whole
ui-keyboard-and-tour = Keyboard and tour
ui-keys-note = No key acts while you type in a field or answer a question, except STOP.
ui-kind = Kind
ui-kind-of-board = Kind of board
ui-kind-of-test = Kind of test
ui-kiosk-link-screen-revoked = The kiosk link of this screen has been revoked.
ui-kiosk-links = Kiosk links
ui-label-with-unit = { $label } ({ $unit })
ui-laboratory = Laboratory
ui-language = Language
ui-language-and-units = Language and units
ui-largest-distance = Largest distance
ui-largest-distance-from-mean = largest distance from the mean
ui-largest-distance-of-a-contact-point = Largest distance of a contact point
ui-largest-residuals = Largest residuals
ui-laser = Laser
ui-laser-as-switched-here = as last switched here; the sensor answered
ui-laser-camera-is-lost = camera lost
ui-laser-has-no-switch-here = no switch
ui-laser-is-off = Laser is off
ui-laser-is-off-lowercase = laser is off
ui-laser-is-on = Laser is on
ui-laser-is-on-lowercase = laser is on
ui-laser-is-unknown-lowercase = laser unknown
ui-laser-line = Laser line
ui-laser-no-camera-yet = no camera
ui-laser-off = LASER OFF
ui-laser-plane-rms = Laser plane, rms
ui-laser-rotation = Laser rotation
ui-laser-sensor-did-not-answer = no answer
ui-laser-shift = Laser shift
ui-laser-unknown = Laser unknown
ui-last-backup = Last backup { $when }: { $files }, { $size } in { $folder }
ui-last-points-order-capture-about-mean = The last { $n } points in order of capture, relative to their mean.
ui-last-used = Last used { $at }: { $result }
ui-latest = { $figure }, latest: { $value }
ui-latest-decided = Latest: { $value } ({ $decision }).
ui-lay-chessboard-down = First lay the chessboard down firmly. The calibration takes a few minutes.
ui-least-10-characters-three-unrelated-words = At least 10 characters; three unrelated words work well.
ui-leave-it-out = Leave it out
ui-leave-tip-seat-turn-every-joint = Leave the tip in the seat and turn every joint slowly through its full range. Points are taken automatically.
ui-left-out = excluded
ui-left-out-reason = excluded: { $reason }
ui-left-out-sentence = Excluded:
ui-left-to-right-two-for-each = From left to right, two for each merlon.
ui-length = Length
ui-length-error-by-scan-of = Place { $place }, scan { $repeat }: { $error }
ui-length-error-of = Place { $place }, repeat { $repeat }: { $error }
ui-length-from-the-certificate = Length from the certificate
ui-length-standard = Length standard
ui-length-test = Length test
ui-lengths = Lengths
ui-lengths-and-scans-done-of = { $done } of { $of } lengths touched, { $scanned } of { $scans } scans
ui-lengths-done-of = { $done } of { $of } lengths
ui-lengths-first-text = The length test after ISO 10360 measures calibrated lengths in seven places of the arm's reach: 105 lengths if the standard has five. With a step gauge these are 210 touches, about half an hour by hand.
ui-lengths-largest-error =
    { $count ->
        [one] one length
       *[other] { $count } lengths
    }, largest error { $value }
ui-lengths-need = A ball bar, scale bar or step gauge with a certificate, and a firm support for it in seven places. Seven places, five lengths, three repeats by touch; of a ball bar also by scan.
ui-lens-distortion = Lens distortion
ui-less = Less
ui-let-the-simulated-operator-do-everything = Let the simulated operator do everything
ui-let-the-simulated-operator-do-it = Let the simulated operator do it
ui-let-the-simulated-operator-scan = Let the simulated operator scan
ui-light-display = Light theme
ui-likely-because = Likely { $option }: { $why }. Please check.
ui-limit = Limit
ui-limit-diameter-error-scatter = Limit for the diameter error and the scatter
ui-limit-grows-with-length = A + L/K, at most B; K and B may be left empty
ui-limit-max-min-2-axis = Limit for (max − min)/2 on each axis
ui-limit-none = none
ui-limit-value = limit { $value }
ui-limits = Limits
ui-limits-by-the-datasheet = Limits by the datasheet (MPE)
ui-limits-fixed-at-first-touch = A figure without a limit is reported, but not judged. The limits are fixed at the first touch or scan, and kept for the next test.
ui-limits-judged-by-uncertainty-on-bar = The uncertainty drawn on a bar, and named first, is the one that the limit is judged by. U of test: test value uncertainty by the gauge and its set-up alone (ISO 14253-5), for the performance of the scanner. U of measurement: by gauge, probe and the points' scatter, for where the gauge was found; U of test is a part of it.
ui-line = Line
ui-line-found-in-all-poses = The line is found in every picture with these settings.
ui-line-missing-in-poses = No laser line found in pose: { $poses }. Look at the picture, and say what the line is like:
ui-line-settings-stay-with-session = They count for all pictures of this session, and the zones of the settings page with them.
ui-line-spacing = Line spacing
ui-lines-point-outward-or-inward = lines point outward or inward
ui-link-screen-shop-floor-gives-full = A link for a screen on the shop floor. The screen shows everything and allows no action.
ui-list-could-not-loaded-reloads-when = The list could not be loaded. It reloads when the station is back.
ui-live = live
ui-live-cloud = Live cloud
ui-live-cloud-of-points = Live cloud of points
ui-live-picture-of-the-camera = Live picture of the camera
ui-live-picture-of-the-tried-camera = Live picture of the camera
ui-load-again = Load again
ui-loading = Loading…
ui-loading-share = Loading… { $share }
ui-loading-the-calibration = Loading the calibration…
ui-loading-the-list = Loading the list…
ui-loading-the-map = Loading the map…
ui-loading-the-record = Loading the record…
ui-location-of-the-screen = Location of the screen
ui-log = Log
ui-log-level = Level
ui-log-lines = Log lines
ui-logo-at-the-head-of-reports = It stands at the head of all reports, { $width } mm wide at most. PNG or JPEG up to { $largest }; { $pixels } pixels in width are enough.
ui-logo-of-reports = Logo of reports
ui-logo-too-large = { $name } is too large for a logo
ui-lost = lost
ui-lost-and-corrupt = { $lost } lost, { $corrupt } corrupt
ui-lost-for = lost for { $age }
ui-lost-lately = { $n } of { $all } lost in 10 min
ui-lost-pictures = Lost pictures
ui-lost-records = Lost
ui-lower-limit = Lower limit, { $unit }
ui-lower-limit-must-below-upper = The lower limit must be below the upper limit.
ui-made-on-the-devices-page = The camera’s datasheet is made on the Devices page.
ui-manual = manual
ui-map = Map
ui-map-appears-after-first-cloud = The map appears here after the first cloud.
ui-map-outliers = 
    { $points ->
        [0] No point is further off than noise explains.
        [one] { $points } point is further off than noise explains (ring; press it).
       *[other] { $points } points are further off than noise explains (rings; press one).
    } The range of all points, { $range }, lies between the bold rings, { $low } and { $high }.
ui-mark-weak-places = Mark weak places
ui-mask-shines-picture-not-part-object = Mask bright areas that are not part of the object, such as a clamp or the sensor's own edge.
ui-master-sphere = Master sphere
ui-maximum-width = Maximum line width
ui-mean = mean { $value }
ui-mean-deviation = Mean
ui-measure = Measure
ui-measure-the-print = Once it is printed: measure the whole pattern, and its datasheet has the true size of the squares.
ui-measured-height = Measured height
ui-measured-width = Measured width
ui-measured-with = Measured with
ui-measurements = Measurements
ui-merge-into-one-cloud = Merge into one cloud
ui-merged-of = Made of
ui-merlon-gap-merlon = Width of the first merlon, of the gap, of the next merlon, and so on.
ui-merlon-n = Merlon { $n }
ui-merlons = { $n ->
        [one] { $n } merlon
       *[other] { $n } merlons
    }
ui-merlons-n-to-m = Merlons { $n } to { $m }
ui-messages-delivered = { $n ->
        [one] { $n } message delivered
       *[other] { $n } messages delivered
    }
ui-metrics = Metrics
ui-micrometer = Micrometer
ui-minimum-width = Minimum line width
ui-misplaced-edges = misplaced edges
ui-more-options = More options
ui-motion-part-under-line-during-one = Motion of the part under the line during one exposure. Above this, the station reports Too fast. Automatic: four times the point spacing along the line.
ui-move-slowly-evenly-green-range-distance = Move slowly and evenly. Stay in the green range of the distance indicator.
ui-move-stripe-slowly-over-part = Move the stripe slowly over the part.
ui-move-the-arm-every-value-must-follow = Move the arm: every value must follow.
ui-moving = moving
ui-my-arm-is-not-listed = My arm is not listed
ui-my-camera-is-not-listed = My camera is not listed
ui-n-alarms = { $n ->
        [one] { $n } alarm
       *[other] { $n } alarms
    }
ui-n-clouds = { $n ->
        [one] { $n } cloud
       *[other] { $n } clouds
    }
ui-n-of-all-scans = { $n } of { $all }
ui-n-of-all-too-fast = { $n } of { $all } pictures too fast
ui-n-pictures = { $n ->
        [one] { $n } picture
       *[other] { $n } pictures
    }
ui-n-pictures-lost =
    { $n ->
        [one] { $n } picture lost
       *[other] { $n } pictures lost
    }
ui-n-pictures-without-points =
    { $n ->
        [one] { $n } picture without points
       *[other] { $n } pictures without points
    }
ui-n-points = { $n ->
        [one] { $n } point
       *[other] { $n } points
    }
ui-n-scans =
    { $n ->
        [one] { $n } scan
       *[other] { $n } scans
    }
ui-n-scans-chosen = { $n } scans chosen
ui-n-scans-merged = { $n } scans merged
ui-n-stations = { $n ->
        [one] { $n } station
       *[other] { $n } stations
    }
ui-n-waiting = { $n ->
        [one] { $n } waiting
       *[other] { $n } waiting
    }
ui-name = Name
ui-name-of-the-block = Name of the block
ui-name-of-the-board = Name of the board
ui-name-of-the-device = Name
ui-name-of-the-program = Name of the program
ui-name-part = Name the part
ui-named-field = “{ $label }”
ui-narrower-lines-glints-automatic-about-half = Narrower lines are treated as glints. Automatic: about half of the usual line width.
ui-narrower-side = Narrower side
ui-nearest = nearest { $value }
ui-new-account = New account
ui-new-address-requires-secret-again = If you change the address, enter the secret again.
ui-new-camera-gets-its-datasheet = A calibration needs to know. The camera gets its datasheet from the answer.
ui-new-link = New link
ui-new-name-of = New name of { $name }
ui-new-of-kind = New: { $title }
ui-new-password = New password
ui-new-password-of = New password of { $name }
ui-new-token = New token
ui-next = Next: { $what }
ui-next-scan-is-added-to = The next scan is added to a record
ui-no-alarms = No alarms
ui-no-answer-from-the-station = No answer from the station: { $what }
ui-no-arm-was-found = No arm was found. Connect it, switch it on, and search again.
ui-no-backup-was-started = no backup was started
ui-no-backup-yet = No backup yet. Backups go to { $folder }
ui-no-block-yet = As soon as the block is designed
ui-no-board-to-take = As soon as there is a board
ui-no-calibration-use-yet-calibrate-first = No calibration is in use yet. Calibrate first.
ui-no-calibration-yet = no calibration yet
ui-no-camera-was-found = No camera was found. Connect it, switch it on, and search again.
ui-no-check-yet = No check yet
ui-no-cloud-picture-yet-scan-display = No cloud is shown yet. Start a scan, or show a saved one.
ui-no-contact-for = no contact for { $age }
ui-no-continue = No, continue
ui-no-data = no data
ui-no-data-yet = No data yet.
ui-no-data-yet-lowercase = no data yet
ui-no-datasheet-of-a-gauge = No datasheet of a gauge yet. Verifications and performance tests need one.
ui-no-datasheet-of-a-sensor = No datasheet of a sensor yet. It is made on the Devices page, when the camera is taken into use, or here.
ui-no-datasheet-of-an-arm = No datasheet of an arm yet. A calibration needs one: of an arm that reports joints, its kinematic model.
ui-no-datasheet-of-an-object = No datasheet of a block or board yet. A calibration needs one.
ui-no-entry-matches = No entry matches.
ui-no-gauge-yet = No gauge yet
ui-no-keep-it = No, keep it
ui-no-length-standard-yet = No length standard yet
ui-no-length-yet = no length yet
ui-no-limit = No limit
ui-no-limit-set = no limit set
ui-no-log-line-matches = No log line matches.
ui-no-longer-in-use = No longer in use.
ui-no-new-picture-for = No new picture for { $age }.
ui-no-picture = no picture
ui-no-picture-yet-appears-when-camera = No picture yet. It appears when the camera sends one.
ui-no-residual-yet = no residual yet
ui-no-scan-is-like-that = No scan is like that.
ui-no-tip-check-yet = No tip check yet
ui-nobody = nobody
ui-nobody-control-first-act-takes = Nobody has control. The first person to act takes it.
ui-nobody-has-control = Nobody has control.
ui-nobody-in-control = Nobody in control
ui-none = none
ui-none-chosen = not chosen
ui-none-used-determine-scan-flat-plate = No delay is in use. To determine it, start a scan and pass over a flat plate briskly at least three times, closer and further away. Stop the scan. Then determine the delay here.
ui-none-yet = none yet
ui-not-chosen = Not chosen
ui-not-delivered = Not delivered: { $reason }
ui-not-done = not done: { $reason }
ui-not-measured = not measured
ui-not-needed = not needed
ui-not-on-the-other = Beside the other scan
ui-not-signed-in = not signed in
ui-not-solved-yet = not solved yet
ui-not-stated = not stated
ui-not-yet = not yet
ui-not-yet-identified-here = Not yet identified here
ui-nothing-sent-yet = Nothing sent yet
ui-nothing-takes-effect-before-you-accept = Nothing takes effect until you accept it.
ui-nothing-to-choose = There is no datasheet yet.
ui-nothing-was-changed = Nothing was changed.
ui-nothing-was-cut = Nothing was cut away
ui-nothing-was-exported = the file was not made
ui-nothing-was-fitted = nothing was fitted
ui-nothing-was-sent = nothing was sent
ui-notification-sent-json-post-signed-hmac = The station sends each notification as JSON by POST, signed with HMAC-SHA256 in the header Crenel-Signature, and retries failed deliveries.
ui-notifications = Notifications
ui-notifications-blocked-browser-allow-them-icon = Notifications are blocked in this browser. Allow them with the icon next to the address.
ui-now = now
ui-number-column = No.
ui-number-n = no. { $n }
ui-number-of-merlons = Number of merlons
ui-numbers = Numbers
ui-numbers-out-date-station-stores-everything = The values here are out of date. The station keeps everything that it has recorded.
ui-object = Object
ui-object-serial = object { $serial }
ui-of = with { $calibration }
ui-of-need-attention = { $n } of { $all } need attention
ui-of-points = { $n } of { $all } points
ui-of-row = { $label } of { $row }
ui-of-with-faults = { $n } of { $all } with faults
ui-off = off
ui-off-best-fitting-gauge-outward-positive = { $end } from the best-fitting gauge: blue inside, orange outside (positive)
ui-old = old
ui-old-age = { $age } old
ui-old-password = Old password
ui-on = on
ui-one-file-support-checks-versions-settings = One file for support: checks, versions, settings, log and recent steps. It contains no passwords, tokens, keys or names. Nothing is sent.
ui-one-pose = One pose
ui-one-position = One
ui-one-sphere = One sphere
ui-only-an-administrator-can-connect-devices = Only an administrator can connect devices.
ui-only-an-administrator-can-make-backups = Only an administrator can make backups.
ui-only-an-administrator-can-manage-accounts = Only an administrator can manage accounts.
ui-open = Open
ui-open-address-screen-appears-only-once = Open this address on the screen. It appears only once:
ui-open-in-the-3d-view = Open in the 3D view
ui-open-the-reference = Open the reference of the HTTP interface
ui-open-the-station-by-its-link = Open the station with its link
ui-open-to-turn-it = Open it in the 3D view to turn it, play it again or compare it.
ui-opening-the-device = The device is being opened…
ui-operator = Operator
ui-operator-lowercase = operator
ui-option-at-most = at most { $largest }
ui-optional-field = { $label }, if known
ui-or-with-an-account-of-this-station = or with an account of this station
ui-order = Order
ui-order-of = order { $order }
ui-order-of-the-columns = Order of the columns
ui-orientations = Orientations
ui-out-of-the-frame = out of the frame
ui-outlier = outlier
ui-outlier-at = 
    { $deviation }{ $end ->
        [highest] { "" }, the highest point of all
        [lowest] { "" }, the lowest point of all
       *[none] { "" }
    }; { $points ->
        [0] no outlier
        [one] one outlier here
       *[other] { $points } outliers here
    }; at X, Y, Z = { $at } { $unit } of the arm; frame { $frame }
ui-outlier-does-not-fit-face-not = Outlier: this point does not fit its face and is not used.
ui-over-time = { $figure } over time
ui-overall-length = Overall length
ui-overexposed = overexposed
ui-page-continues-automatically-once-everything-ready = This page continues automatically when everything is ready.
ui-page-to-print-on = Page to print on
ui-pages = Pages
ui-pages-here = Pages, now { $page }
ui-parameter = Parameter
ui-parameters = Parameters
ui-part = Part
ui-part-of-next-scans = Part of the next scans
ui-part-of-this-scan = Part of this scan
ui-pass = Pass
ui-pass-becomes-map-clouds-deviations-gauge = Each pass becomes a map of the cloud's deviations from the gauge.
ui-pass-over-place-again-fill-gaps = Pass over a place again to fill gaps. Scanned data is recorded at once and is never lost.
ui-pass-value-within-by-guard-band = Pass: the value is within its limit by more than the guard band. Fail: the value exceeds the limit by more than the guard band. In between, the decision rule below the figures says what holds.
ui-passed = Passed
ui-passed-lowercase = passed
ui-password = Password
ui-password-changed-other-browsers-signed-out = Your password is changed. Other browsers are signed out.
ui-patch-covered = covered
ui-patch-holds = { $points } points of { $frames } pictures
ui-patch-open = not covered yet
ui-patch-partly = begun
ui-patches-missing = Still missing: { $count } of 25 ({ $patches })
ui-patches-missing-many = Still missing: { $count } of 25
ui-pattern-and-page = The pattern is { $width } wide and { $height } high. Print it on { $page } at 100 %; the bar of 100 mm below it checks the printer.
ui-pause = Pause
ui-people = People
ui-performance = Performance
ui-performance-first-text = The one-sphere test after ISO 10360 takes about 25 minutes by hand: 55 touches and five scans of one calibrated sphere.
ui-performance-first-title = Does the instrument keep its datasheet?
ui-performance-help-end = If sphere or arm have moved by more than the uncertainty allows, no figure is stated.
ui-performance-help-length = The first touch of the next length confirms the one before. Afterwards it stands.
ui-performance-help-limits = Enter the maximum permissible errors (MPE) that the maker of arm or scanner states.
ui-performance-help-location = Within an articulation the stylus keeps its direction; between them, turn wrist and elbow as far as they go.
ui-performance-help-patches = A patch is covered by 20 points from two pictures. Several passes may be made in one scan.
ui-performance-help-places = A touch counts for the nearest free place within 12°; any other is refused.
ui-performance-help-review = All points within the fixed gate count; none is removed for its deviation.
ui-performance-help-scan = The arm's main button begins and ends a scan.
ui-performance-help-sphere = The sphere's file in the folder gauges states diameter, form and their uncertainties by its certificate.
ui-performance-help-temperatures = A change during the test adds to the uncertainty of sizes and lengths. If it is too large, no figure is decided.
ui-performance-help-touch = The arm's main button takes a touch, the undo button takes the last one back.
ui-performance-needs = A calibrated sphere of at least 10 mm on a firm foot, not the one used for calibration.
ui-performance-tests = Performance tests
ui-performance-tests-appear-here = Performance tests appear here, newest first, the cancelled ones, too.
ui-picture = Picture
ui-picture-details = Picture details
ui-picture-not-saved-3d-view-not = The picture was not saved: the 3D view is not open yet.
ui-picture-size = Picture
ui-picture-taken-only-while-arm-still = The picture is taken only while the arm is still. Take your time.
ui-pictures = Pictures
ui-pictures-calibrated-sensor = From a few pictures to a calibrated sensor
ui-pictures-take-about-30-mb-per = Pictures take about 30 MB per second; the line can be extracted from them again later. The extracted lines are always recorded, and have priority.
ui-pixels-by-pixels = { $width } × { $height } px
ui-place-and-problem = { $place }: { $words }
ui-place-done = touched
ui-place-next = next
ui-place-tip = tip
ui-placements = Placements
ui-places = Places
ui-places-far-apparent-motion-tip-max = Places so far: apparent motion of the tip, (max − min)/2
ui-plane = Plane
ui-plane-about = The form of a scanned plate, an addition to the standards: the plate is scanned twice, with the stripe turned by 90° in between. About five minutes by hand.
ui-plane-needs = A flat plate, 50 mm wide or more, with a certificate of its flatness, matt and firmly supported.
ui-plane-test = Plane
ui-plane-test-title = Plane test
ui-planes-angle-k-1 = Plane's angle, k = 1
ui-planes-flat-to = { $radius } wide, left by { $flatness }
ui-planes-of-comparison = Planes
ui-planes-offset-k-1 = Plane's offset, k = 1
ui-plate = Plate
ui-plate-from-above = The plate from above, with the strips of the scan
ui-play = Play
ui-played = { $time } played
ui-please-choose = Please choose
ui-plotted-quantity = Plotted quantity
ui-point = Point { $n }
ui-point-on = Point { $n } on { $face }
ui-points = Points
ui-points-about-plane-rms-without = Scatter about the plane: { $without } rms without the delay, { $with } rms with it
ui-points-alone = Points alone
ui-points-appear-arm-swings = Points appear here as the arm swings.
ui-points-appear-drawing-once-pictures-evaluated = Points appear in the drawing when the pictures have been evaluated.
ui-points-appear-drawing-once-three-adjacent = Points appear in the drawing when you have touched three adjacent faces.
ui-points-appear-fifth-contact-point = Points appear here from the fifth contact point on.
ui-points-are-cut-away = { $n ->
    [one] One point of the view is
   *[other] { $n } points of the view are
} cut away
ui-points-measuring-volume-moved-rms-most = Since { $name }, points in the measuring volume have moved by { $rms } rms, { $most } maximum.
ui-points-of-file = Points: { $name }
ui-points-on-this-face = Points on this face
ui-points-s = points/s
ui-points-s-n = { $n } points/s
ui-pose = Pose
ui-pose-n = Pose { $n }
ui-poses = Poses
ui-poses-another-tilt-rotation-improve-result = Poses with a different tilt or rotation improve the result. The station suggests the most useful one.
ui-positions = Positions
ui-positions-of-the-sphere = Positions of the sphere
ui-preparation = Preparation
ui-print-a-board = Print a board
ui-probe = Probe
ui-probe-matrix-t-flange-sensor = Probe matrix T_flange_sensor
ui-problems = { $n ->
        [one] One problem
       *[other] { $n } problems
    }
ui-prometheus-reads = Prometheus reads { $address } with its own token, sent as a Bearer token.
ui-propose-every-size = Propose every size
ui-proposed-block = Proposed block
ui-provider-sets-role-and-password = Account of the provider, which sets role and password
ui-provider-trouble = { $trouble }. Sign in in another way, or try again later.
ui-proxy-changes-host = A proxy changes the Host of requests: this page is at { $here }, and the station is asked for { $there }. It accepts no changes this way.
ui-proxy-drops-upgrade = The station answers, but no live connection opens: a proxy or filter does not pass on WebSockets.
ui-proxy-hides-scheme = The station does not know that this page is encrypted: its cookies lack the mark for that.
ui-proxy-hides-sub-path = The station does not know that it is offered under { $here }: the 3D view and the sign-in do not work reliably.
ui-proxy-pass-host = Let the proxy pass on the browser's Host. In nginx: proxy_set_header Host $http_host;
ui-proxy-pass-scheme = Let the proxy send X-Forwarded-Proto, and add its address to proxies in the settings.
ui-proxy-pass-sub-path = Set root_path = "{ $path }" in the settings, or start with --root-path { $path }.
ui-proxy-pass-upgrade = Let the proxy pass on the upgrade. In nginx: proxy_http_version 1.1; proxy_set_header Upgrade $http_upgrade; proxy_set_header Connection $http_connection;
ui-put-datasheet-plate-sphere-into-folder = Enter a plate or sphere under Datasheets, or add its file or the digital certificate (DCC) of a sphere there. The file holds the nominal size, the certificate and the limits. The gauge appears here at once.
ui-put-length-standard-into-folder = Add the file of a ball bar, scale bar or step gauge under Datasheets; crenel certificate read makes one of a certificate. It appears here at once.
ui-radians = radians
ui-radius-error = Radius error
ui-radius-error-lowercase = radius error
ui-range = { $low } to { $high }
ui-range-at-least = at least { $low }
ui-range-more-than = more than { $low }
ui-range-of-all = Range of all
ui-range-over-the-calibrations = { $figure }: range over the calibrations
ui-range-over-the-clouds = { $figure }: range over the clouds
ui-rate = Rate
ui-readings-of-file = Readings: { $name }
ui-ready-to-scan = Ready to scan
ui-reason-device = Device failed
ui-reason-moved = Artefact or arm moved
ui-reason-next-button = The reason is next to the button.
ui-reason-operating = Operating error
ui-reason-other = Another reason
ui-rebuild-with-calibrations = { $n ->
        [one] Rebuild with the calibration
       *[other] Rebuild with { $n } calibrations
    }
ui-rebuilding-the-clouds = Rebuilding the clouds…
ui-recommended = Recommended
ui-record-of = Record of { $when }
ui-recorded-data-safe-check-power-cable = Recorded data is safe. Check power and cable. The device reconnects automatically.
ui-recording = Recording
ui-records = Records
ui-release-control = Release control
ui-reload = Reload
ui-remove = Remove
ui-remove-name = Remove { $name }
ui-remove-the-last-joint = Remove the last joint
ui-remove-the-last-length = Remove the last length
ui-remove-the-logo = Remove the logo
ui-remove-this-point = Remove this point
ui-rename = Rename
ui-replace-it = Replace it
ui-replay = Replay
ui-replaying-a-recording = Replaying a recording
ui-report = Report
ui-request-body = request body
ui-request-control = Request control
ui-request-it-under-control = Request it under Control, at the top.
ui-requests-control = { $name } requests control
ui-residual = Residual
ui-residual-lowercase = residual: blue inside, orange outside
ui-residuals-on-the-object = Residuals on the object
ui-resolution = Resolution
ui-result-test-message-unknown = the result of the test message is unknown
ui-retire = Retire
ui-retire-it = Retire the datasheet of { $name }? It can no longer be chosen, but it is kept, and can be brought back. Results are not affected.
ui-returned-light = Intensity
ui-revoke-this-link = Revoke this link
ui-revoke-this-token = Revoke this token
ui-rms = rms
ui-rms-off-the-others = { $part } { $px } rms, { $off } from the others
ui-robot = Robot
ui-robot-that-reports-poses = Robot that reports poses
ui-role-of = Role of { $name }
ui-role-of-the-new-account = Role of the new account
ui-rotation-of-the-laser-plane = Rotation of the laser plane
ui-rotation-of-the-measuring-volume = Rotation of the measuring volume
ui-row = Row
ui-rows-of-inner-corners = Rows of inner corners
ui-rule-guard =
    Guard band: { $factor } times the standard uncertainty; { $bearer ->
        [supplier] the supplier bears the uncertainty, so that a value closer to its limit fails.
        [user] the user bears the uncertainty, so that a value closer to its limit passes.
       *[prover] whoever has to prove something bears the uncertainty, so that a value closer to its limit is undecided.
    }
ui-rule-named =
    Decision rule: { $name ->
        [guarded-95] acceptance with a guard band for 95 %
        [expanded-k2] acceptance with the expanded uncertainty (k = 2) as guard band
        [simple] simple acceptance
       *[other] { $name }
    }, { $standard }:{ $edition }.
ui-rule-without-guard = No guard band: values are compared directly with their limits, the uncertainty is stated only, and both parties bear its risk.
ui-running-jobs-continue-whoever-has-control = Running jobs continue when control changes.
ui-runs-unattended = Runs unattended
ui-safety = Safety
ui-save = Save
ui-save-changes = Save changes
ui-save-it-smaller = Save it with fewer pixels: { $pixels } in width are enough.
ui-save-picture = Save picture
ui-save-picture-for-support = Save for support
ui-save-the-certificate = Save the certificate
ui-save-the-cloud = Save the cloud
ui-save-the-datasheet = Save the datasheet
ui-save-the-support-bundle = Save the support bundle
ui-saved-as = { $name } can be chosen from now on.
ui-saved-clouds-appear-newest-first-start = Saved clouds appear here, newest first. Start a scan on the Scan page.
ui-saved-in-file-used-from-now-on = The station uses it from now on. Saved in { $file }.
ui-saving-the-cloud = Saving the cloud…
ui-saving-the-last-scan = Saving the last scan…
ui-scale-from-the-datasheet = scale from the datasheet
ui-scan = Scan
ui-scan-accepted = accepted
ui-scan-again = Scan again
ui-scan-and-laser-stop-after = Scan and laser stop after
ui-scan-gauge-plate-sphere = Scan a gauge plate or sphere a few times. The station compares the clouds with the gauge's certificate, and judges them by your limits, including their uncertainty. This takes two minutes.
ui-scan-part-again = Bring the part into the range of the sensor, and scan again.
ui-scan-settings = Scan settings
ui-scan-the-part = Scan the part
ui-scan-with-it = Scan with it
ui-scanned-too-fast = Too fast
ui-scanning = Scanning
ui-scanning-is-not-possible = scanning is not possible
ui-scanning-is-not-possible-now = Scanning is not possible now
ui-scans = Scans
ui-scans-of-the-bar-in-place = Scans of the bar in place { $place }
ui-scans-short-bright-metal-long-dark = For scans. Use a short exposure on bright metal, a long one on dark parts. A long exposure blurs the line.
ui-scatter-of = scatter { $scatter }
ui-scatter-of-the-scan-is-no-uncertainty = Scatter is that of the scan alone, k = 1. It is no uncertainty: errors of the calibration and of the arm are the same in all points and not in it, and are usually larger.
ui-search-again = Search again
ui-search-records = Search: part, number, order, customer, date
ui-search-text = Search text
ui-searching = Searching…
ui-seat = Seat
ui-seat-cone-three-balls-which-tip = A seat is a cone or three balls in which the tip sits and turns without play.
ui-seat-end-ball-bar-tip-stays = In a seat, or at an end of a ball bar, the tip stays in one place while the arm swings. A sphere is touched from every side. Spread the places over the whole reach: near and far, left and right, high and low. Then repeat them with the elbow on the other side. A ball bar also determines the arm's scale.
ui-seats = Seats
ui-secret = Secret
ui-seen-from-above-arm-below = Seen from above, the arm's base is at the bottom
ui-seen-too-steeply = Too steep
ui-select-datasheets-clamped-mounted-result-only = Select the datasheets of the arm, tip, object and sensor that are in place. The result is only as accurate as these datasheets.
ui-selected-object = Selected object
ui-sensor = Sensor
ui-sensor-rotation = Sensor rotation
ui-sensor-selected = Sensor
ui-sensor-serial = sensor { $serial }
ui-sensor-shift = Sensor shift
ui-sensors = Sensors
ui-serial-number = Serial number
ui-serial-number-of = no. { $number }
ui-serial-of = S/N { $serial }
ui-set = Set
ui-set-at-the-camera = set at the camera
ui-set-it-is-not-displayed-again = set; not shown again
ui-settings = Settings
ui-shift-centre-measuring-volume-frame-arms = Shift of the centre of the measuring volume in the frame of the arm's last joint
ui-shift-laser-plane-along-normal = Shift of the laser plane along its normal
ui-show = Show
ui-show-it = Show it
ui-show-more-of =
    { $n ->
        [one] Show { $n } more
       *[other] Show more of { $n }
    }
ui-show-pose = Show pose { $n }
ui-show-retired-ones = { $n ->
    [one] Show the retired one
   *[other] Show { $n } retired ones
}
ui-show-the-tour = Show the tour
ui-shown-in-the-3d-view = Shown in the 3D view.
ui-side-of-a-marker = Side of a marker
ui-side-of-a-square = Side of a square
ui-sign-in = Sign in
ui-sign-in-to-continue = Sign in to continue
ui-sign-in-with-a-name = Sign in with a name
ui-sign-in-with-provider = Sign in with { $name }
ui-sign-in-with-the-consoles-code = Sign in with the console's code
ui-sign-out = Sign out
ui-signed-out-everywhere-no-longer-sign = { $name } is signed out everywhere and can no longer sign in. Their entries stay in the audit log.
ui-simulated = simulated
ui-simulated-operator-may-still-moving = the simulated operator may still be moving
ui-simulated-operator-passes-over-plate = The simulated operator is scanning the plate.
ui-since = since { $when }
ui-since-moved-by = Since { $date }: { $change }.
ui-six-places-determine-the-arms-geometry = Six places determine the arm's geometry
ui-six-seats-spheres-ball-bar-places = Six seats, spheres or ball bar places over the whole reach determine the arm's geometry. Do this when a check fails, or before the first calibration.
ui-skip-to-the-page = Skip to the page
ui-smallest-page = The smallest of A4 to A0
ui-smoothing-along-the-line = Smoothing along the line
ui-smoothing-quieter-points-less-detail = Quieter points, but less detail: standard deviation in pixels along the line. Structures of period λ keep exp(−2(π·value/λ)²) of their height; half at λ = 5.3 times the value. Empty: none.
ui-some-faces-are-not-reached = Some faces are not reached yet
ui-sounds-off = Sounds off
ui-sounds-on = Sounds on
ui-source = Source
ui-source-in-the-program = Source in the program
ui-speed = Speed
ui-sphere = Sphere
ui-sphere-from-above = The sphere from above
ui-spread-points-over-face-away-edges = Spread the points over each face, away from its edges. Tap a point in the drawing to see or remove it.
ui-squares-across = Squares across
ui-squares-down = Squares down
ui-stamps-arrival = arrival
ui-stamps-arrival-note = vary by milliseconds
ui-stamps-by = stamps: { $stamps }
ui-stamps-device = device clock
ui-stamps-pulse = pulses
ui-stand-off = Stand-off
ui-standard-uncertainty = Standard uncertainty (k = 1)
ui-standard-uncertainty-dashed-good = Standard uncertainty of a scanned point, k = 1; dashed: limit for good
ui-standard-uncertainty-of-a-scanned-point = Standard uncertainty of a scanned point, k = 1
ui-standard-uncertainty-of-a-scanned-point-lowercase = standard uncertainty of a scanned point, k = 1
ui-standard-uncertainty-of-the-length = Standard uncertainty of the length
ui-standard-uncertainty-of-the-radius = Standard uncertainty of the radius (k = 1)
ui-standard-uncertainty-over-picture = Standard uncertainty of a scanned point, k = 1, over the picture.
ui-start-calibration = Start calibration
ui-start-scan = Start scan
ui-start-the-test = Start the test
ui-start-then-move-stripe-slowly-over = Start, then move the stripe slowly over the part.
ui-start-verification = Start verification
ui-starting-the-station = Starting the station
ui-station = Station
ui-station-new-no-accounts-yet-console = This station is new and has no accounts yet. Its console shows a code for this step.
ui-station-offline-picture-old = The station is offline. This picture is { $age } old.
ui-station-responds-again-check-whether-last = The station responds again. Check whether the last action took effect.
ui-station-stores-everything-already-recorded = The station keeps everything that it has already recorded.
ui-station-uses-it-already = The station uses this device already.
ui-stations = Stations
ui-stay-green-range-distance-indicator-if = Stay in the green range of the distance indicator. If Too fast appears, slow down: the line is blurred.
ui-step-already-advanced-nothing-recorded-twice = The step has already advanced; nothing was recorded twice.
ui-step-gauge = Step gauge
ui-step-of = Step { $n } of { $all }
ui-steps = Steps
ui-still = still
ui-stop = STOP
ui-stop-and-laser-off-always-respond = Stop and Laser off always work.
ui-stop-drawing = Stop drawing
ui-stop-not-confirmed-use-switch-device = Stop was not confirmed. Use the switch on the device
ui-stop-the-demonstration = Stop the demonstration
ui-stop-the-scan = Stop the scan
ui-stop-the-simulated-operator = Stop the simulated operator
ui-stopped-laser-off-nothing-running = Stopped: the laser is off and nothing is running.
ui-stopping = Stopping…
ui-store-the-certificate = Store the certificate
ui-straight-edges = straight edges
ui-stripe = Stripe
ui-stripe-lowercase = stripe
ui-supervise = Supervise
ui-support-bundle = Support bundle
ui-switch-at-the-sensor = Switch at the sensor
ui-switch-laser-display-detected-line-changes = Switch on the laser to see the detected line. Changes apply at once and are saved.
ui-switch-on = Switch on
ui-switched-off = switched off
ui-symbols-over-time-appear-after-second-test = Each symbol over time appears here after the second test with the same arm and kind of artefact.
ui-table-is-not-utf-8 = { $name } is not a UTF-8 text: save the table as CSV.
ui-table-is-too-large = { $name } is larger than 200 kB: leave out points evenly over all faces.
ui-take-first-last-glass-film-where = On glass and film, two surfaces reflect: use the first or the last line there.
ui-take-over = Take over
ui-take-over-control-give-reason = Or take over control and give { $name } a reason
ui-take-the-design-over = Take it over as a datasheet
ui-take-the-model-from-a-text = Take the model from a text, a file or the list
ui-taken-after-few-more-they-drawn = { $n } taken. The drawing appears after a few more.
ui-temperature = Temperature
ui-temperature-at-acceptance = Temperature at acceptance
ui-temperature-of-the-arm = Temperature of the arm
ui-temperature-of-the-artefact = Temperature of the artefact
ui-temperature-uncertainty = Uncertainty of the temperature (k = 2)
ui-temperatures = Temperatures
ui-temperatures-at-the-end = Temperatures at the end
ui-temperatures-at-the-end-why = Filled in as at the beginning. If a value has changed, enter and set it.
ui-temperatures-why = Sizes and lengths are brought to 20 °C by the artefact's temperature; without it, they are taken as at 20 °C. Both are asked for again at the end.
ui-temperatures-why-of-a-plane = The form of a plane does not depend on them. They show whether the conditions were steady: both are asked for again at the end.
ui-term = Term
ui-test = Test
ui-test-lowercase = test
ui-test-sphere = Test sphere
ui-test-the-performance = One-sphere test
ui-text-of-the-model = D-H table, URDF or factory calibration (UR), pasted or as a file
ui-the-3d-view-is-loading = The 3D view is loading.
ui-the-account-was-not-changed = the account was not changed
ui-the-account-was-not-created = the account was not created
ui-the-account-was-not-removed = the account was not removed
ui-the-action-was-not-confirmed = the action was not confirmed
ui-the-answer-was-not-sent = the answer was not sent
ui-the-arm-begins-at = The arm begins at the link
ui-the-arm-ends-at = The arm ends at the link
ui-the-arm-has-no-datasheet = The arm has no datasheet yet
ui-the-arm-is-connected = The arm is chosen
ui-the-arms-main-button-begins = The arm's main button begins.
ui-the-arms-main-button-ends-it = The arm's main button ends it.
ui-the-board-was-not-touched = The board was not touched.
ui-the-brightest = The brightest
ui-the-calibration-was-not-started = the calibration was not started
ui-the-camera-is-connected = The camera is chosen
ui-the-certificate-was-not-added = the certificate was not added
ui-the-closest-detection-of-the-object = the closest detection of the object
ui-the-cloud-so-far-stays-here = The cloud so far stays here.
ui-the-clouds-were-not-rebuilt = the clouds were not rebuilt
ui-the-colours-were-not-changed = the colours were not changed
ui-the-current-scan-is-always-displayed = The current scan is always shown.
ui-the-cut-was-not-undone = The cut was not undone
ui-the-datasheet-is-saved = The datasheet is saved
ui-the-datasheet-was-not-changed = The datasheet was not changed.
ui-the-datasheet-was-not-kept = The datasheet was not saved.
ui-the-datasheet-was-not-read = the datasheet was not read
ui-the-datasheet-was-not-written = the datasheet was not written
ui-the-delay-was-not-changed = the delay was not changed
ui-the-delay-was-not-determined = the delay was not determined
ui-the-demonstration-may-still-run = The demonstration may still be running
ui-the-demonstration-was-not-started = The demonstration was not started
ui-the-device-could-not-be-opened = It could not be opened. The station tries again.
ui-the-device-was-not-changed = the device was not changed
ui-the-device-was-not-opened = the device was not opened
ui-the-device-was-not-saved = the device was not saved
ui-the-exposure-was-not-changed = the exposure was not changed
ui-the-first-from-the-pictures-top = The first from the top of the picture
ui-the-former-version-is-kept = Saved as a new version. The former one is kept among the retired ones.
ui-the-laser-may-still-be-on = the laser may still be on
ui-the-laser-was-not-switched-on = the laser was not switched on
ui-the-last-from-the-pictures-top = The last from the top of the picture
ui-the-link-could-not-be-opened = the link could not be opened
ui-the-link-may-still-be-valid = the link may still be valid
ui-the-link-was-not-created = the link was not created
ui-the-list-could-not-be-loaded = the list could not be loaded
ui-the-list-could-not-be-loaded-sentence = The list could not be loaded.
ui-the-live-picture-resumes-automatically = The live picture resumes automatically.
ui-the-logo-was-not-changed = The logo was not changed
ui-the-longest-line-automatic = The longest line (automatic)
ui-the-map-could-not-be-loaded = The map could not be loaded.
ui-the-model-as-it-was-read = The model as it was read
ui-the-model-as-its-maker-states-it = The model as its maker states it
ui-the-name-was-not-changed = the name was not changed
ui-the-notifications-were-not-changed = the notifications were not changed
ui-the-object = The object
ui-the-page-did-not-load = This page did not load
ui-the-page-did-not-load-why = The station does not answer, or has another version by now.
ui-the-part-is-not-named = The part is not named.
ui-the-part-was-not-named = The part was not named
ui-the-pass-was-not-started = the pass was not started
ui-the-password-was-not-changed = the password was not changed
ui-the-picture-was-not-changed = the picture was not changed
ui-the-replay-has-ended = The replay has ended
ui-the-replay-stopped = The replay stopped
ui-the-same-clouds-with-every-calibration = The same clouds with every calibration
ui-the-scan-has-no-points = The scan has no points
ui-the-scan-is-incomplete = The scan is incomplete: parts of the surface are missing.
ui-the-scan-is-not-continued = The scan is not continued
ui-the-scan-is-saved = The scan is saved
ui-the-scan-may-still-exist = the scan may still exist
ui-the-scan-may-still-run = the scan may still run
ui-the-scan-was-not-fetched = The scan was not brought back.
ui-the-scan-was-not-started = the scan was not started
ui-the-scans-were-not-compared = The scans were not compared
ui-the-scans-were-not-merged = The scans were not merged
ui-the-search-was-not-started = the search was not started
ui-the-sensor-was-not-selected = The sensor was not selected
ui-the-session-was-not-started = the session was not started
ui-the-settings-were-not-changed = the settings were not changed
ui-the-shape-was-not-removed = the shape was not removed
ui-the-simulated-operator-was-not-started = the simulated operator was not started
ui-the-sphere-can-be-chosen = This sphere can be chosen for the test.
ui-the-station-did-not-start = The station did not start
ui-the-station-refused-the-request-status = The station refused the request (status { $status })
ui-the-temperature-was-not-saved = the temperature was not saved
ui-the-test-was-not-started = The test was not started
ui-the-text-says-so = The text says so.
ui-the-tip-along-points = The tip along { $axis }, { $n } points
ui-the-token-may-still-be-valid = the token may still be valid
ui-the-token-was-not-created = the token was not created
ui-the-trial-has-ended = The device was closed again.
ui-the-verification-was-not-started = the verification was not started
ui-the-viewpoint-was-not-changed = The viewpoint was not changed
ui-there-is-no-logo = There is no logo.
ui-there-is-no-such-record = This record is not there, or could not be loaded.
ui-thinned-cloud-picture = from the thinned cloud in the view
ui-this-browser-does-not-allow-copying = This browser does not allow copying
ui-this-is-the-arm-take-it-over = This is the arm: take it over
ui-this-record-cannot-be-loaded = This record cannot be loaded
ui-this-station = This station
ui-this-station-uses = This station uses
ui-threshold = Threshold
ui-time = Time
ui-time-ago = { $time } ago
ui-time-of-the-scan = Time of the scan
ui-time-stamps = Time stamps
ui-times-speed = { $n } ×
ui-tip = Tip
ui-tip-check = Tip check
ui-tip-checks = Tip checks
ui-tip-diameter = Tip diameter
ui-tip-error-over-the-reach-rms = Tip error over the reach, rms
ui-tip-error-over-the-whole-reach = Tip error over the whole reach
ui-tip-error-over-whole-reach-without = Tip error over the whole reach, without the arm's scale
ui-tip-x = Tip centre X
ui-tip-y = Tip centre Y
ui-tip-z = Tip centre Z
ui-to-aim-expose-and-focus = To aim, expose and focus
ui-to-do = to do
ui-to-do-again = to do again
ui-together = Total
ui-tolerance-of-making = Tolerance of making (±)
ui-too-far = Too far
ui-too-few-pictures-for-their-scatter = There are too few pictures to state their scatter.
ui-too-near = Too near
ui-tool-was-found = { $tool }: zero error or diameter { $value } ± { $known }, k = 2.
ui-touch-dots-any-order = Touch the dots in any order.
ui-touch-faces-crenellated-object-arms-tip = Touch the faces of the crenellated object with the arm's tip. Then hold the sensor over it and take pictures from a few poses that the station suggests. You see the uncertainty of the result in { $unit } before it replaces anything.
ui-touch-gauge-plate-sphere-probe-then = Touch a gauge plate or sphere with the arm's tip, then scan it a few times. The station compares the clouds with the gauge's certificate and with the contact points, and judges them by your limits, including their uncertainty. This takes two minutes.
ui-touch-rings-continue-chessboard-need-not = Touch the board at the rings, or continue: touching a chessboard is optional.
ui-touch-rings-point-appears-residual = Touch the object at the rings. Each point appears here with its residual.
ui-touch-sphere-known-diameter-nine-places = Touch a sphere of known diameter at nine places with the wrist turned. This shows a worn, bent or wrong tip before it spoils a day's measurements.
ui-tour-card = what to do
ui-tour-card-text = The framed area says what to do now. Its large button is always the next thing to press.
ui-tour-control = one in control
ui-tour-control-text = Several browsers can watch, one acts. See who it is, and request control.
ui-tour-end = End the tour
ui-tour-go-on = Show more
ui-tour-help = keys and this tour
ui-tour-help-text = The question mark lists the keys that save a hand the mouse, and shows this tour again.
ui-tour-pages = the pages
ui-tour-pages-text = Calibrate first, verify the result, then scan. Everything is kept in Records.
ui-tour-part = Tour, { $n } of { $all }:
ui-tour-picture = where
ui-tour-picture-text = The large area shows where: the camera, the object, the cloud or the result. Messages appear below it.
ui-tour-stop = Laser and STOP
ui-tour-stop-text = They are in the same place on every page, act at once, and respond to everybody who is signed in.
ui-try = Try
ui-try-again = Try again
ui-try-again-if-error-persists-check = Try again. If the error persists, check the station's log.
ui-try-this-device = Try this device
ui-turn-off-notifications-here = Turn off notifications here
ui-turn-on-notifications-here = Turn on notifications here
ui-two-positions = Two, as the standard asks
ui-type = Type
ui-u-from-parts = { $whole }: root of the squares of { $parts }
ui-u-k-2 = U (k = 2)
ui-u-measurement = U
ui-u-part = 
    { $source ->
        [gauge] gauge { $value }
        [probe] probe { $value }
        [points] points { $value }
       *[clouds] clouds { $value }
    }
ui-u-test = U of test
ui-u-test-k-2 = U of test (k = 2)
ui-u-value =
    U{ $by ->
        [test] { " " }of test
        [measurement] { " " }of measurement
       *[other] { "" }
    } = { $value }, k = 2
ui-uncertain = Undecided
ui-uncertainty = Uncertainty
ui-uncertainty-budgets = Uncertainty budgets (k = 2): U is the root of the sum of squares of its parts
ui-uncertainty-counts-twice = The instrument's certificate does not say which part of its uncertainty all readings share: it counts for each reading by itself, and for what they share.
ui-uncertainty-of-a-point-in-view = standard uncertainty of a point in view, k = 1
ui-uncertainty-of-a-point-k-1 = Uncertainty of a point, k = 1
ui-uncertainty-of-instrument = Its uncertainty, k = 2
ui-uncertainty-of-the-tip = Uncertainty of the tip
ui-uncertainty-scanned-point-k-1 = Uncertainty of a scanned point (k = 1)
ui-unchanged = unchanged
ui-unchanged-parameters = Unchanged parameters
ui-undecided = undecided
ui-undo = Undo
ui-undo-the-last-cut = Undo the last cut
ui-unit = Unit
ui-unit-of-the-angles = Unit of the angles
ui-unit-of-the-lengths = Unit of the lengths
ui-unknown = unknown
ui-unknown-the-broker-is-offline = unknown, the broker is offline
ui-unusable = unusable
ui-upper-limit = Upper limit, { $unit }
ui-use-gauge-certificate-size-form-uncertainty = Use a gauge with a certificate: its size, form and uncertainty enter the decision.
ui-use-is-unknown = no use recorded
ui-use-it = Use this delay
ui-use-next-scan = In use from the next scan on.
ui-use-none = Use no delay
ui-use-the-simulated-one-again = Use the simulated one again
ui-use-this-arm = Use this arm
ui-use-this-camera = Use this camera
ui-used = Used
ui-valid = valid
ui-valid-old = valid, { $age } old
ui-valid-until = valid until { $day }
ui-valid-until-left = valid until { $day } (in { $left })
ui-validity = Validity
ui-value = Value
ui-value-at-pixel = { $value } at { $u }, { $v }
ui-value-n = Value { $n }
ui-verification = Verification
ui-verifications = Verifications
ui-verified = Verified
ui-verify = Verify
ui-verify-again = Verify again
ui-verify-the-calibration = Verify the calibration
ui-view = View
ui-view-contains-only-some-them = the view shows only some of them
ui-viewer = viewer
ui-viewers-account-watch-everything-operators-account = Viewers can see everything. Operators can also act.
ui-viewpoint = Viewpoint
ui-waiting = waiting
ui-waiting-for-the-station = Waiting for the station…
ui-waits-for-a-trigger-or-a-change = waits for a trigger or a change
ui-warnings = Warnings
ui-wavelength-of-the-laser = Wavelength of the laser
ui-way-to-the-first-calibration = The way to the first calibration
ui-weak-places = Weak places
ui-what = What
ui-what-a-printed-board-is = A board to scale on paper, glued on a flat plate. Its datasheet is taken over here.
ui-what-certifying-is = Enter what you measured of { $name }. The faces follow by least squares; readings that contradict each other are named.
ui-what-datasheets-are = What the station knows of arms, sensors, blocks and boards, and gauges. A calibration chooses from them, and keeps its own copies.
ui-what-is-missing = What is missing
ui-what-tables-are = Points of a coordinate measuring machine, touches by the arm's own tip (also probing.csv of a session), or readings. They can be dragged in.
ui-what-the-design-of-a-block-is = The station proposes the block with which calibrations of this sensor are most accurate, and states how accurate.
ui-what-to-do-next = What to do next
ui-when = When
ui-when-browser-in-control-is-gone = When the browser in control is gone (closed, frozen, or without network) and the arm has stood still for this long, 10 to 3600 s. While the arm moves, or the simulated operator works, nothing stops. Automatic: 30 s.
ui-where = Where
ui-where-several-lines-cross-a-column = If several lines cross a column
ui-who = Who
ui-whole-cloud = Whole
ui-why = Why
ui-why-certify = Measured by calliper, micrometer, measuring machine or the arm's tip, its faces are better known than by the drawing.
ui-why-is-the-test-cancelled = Why is the test cancelled?
ui-wider-lines-surfaces-automatic-about-twice = Wider lines are treated as lit surfaces. Automatic: about twice the usual line width.
ui-width-in-pixels = Picture width, px
ui-width-of-the-block = Width of the block
ui-width-of-the-picture = Width of the picture
ui-widths = Widths
ui-within = within the limit of { $limit }
ui-without-a-ball-bar = Without a ball bar
ui-without-a-datasheet = By numbers, without a datasheet
ui-without-a-sphere = Without a sphere
ui-without-arm-position = Without arm position
ui-without-contact-points-only-form-size = Without contact points, only form, size and scatter are assessed, not the position.
ui-write-the-datasheet-of-the-arm = Write its datasheet
ui-wrong-tip-object-appears-residuals-later = If the tip or the object is wrong, the residuals show it later and the station reports it.
ui-you = you
ui-you-are-signed-in-as = You are signed in as
ui-you-control-others-only-watch = You have control. Others can only watch.
ui-you-have-been-signed-out = You have been signed out.
ui-you-have-control-in-another-browser = You have control in another browser.
ui-you-may-still-be-signed-in = you may still be signed in
ui-you-reload-page-switch-another-tablet = You can reload the page or switch to another tablet at any time; nothing is lost.
ui-you-were-not-signed-in = you were not signed in
ui-your-account-can-only-view = Your account is view-only.
ui-your-account-only-view-acting-requires = Your account is view-only. To act, sign in as an operator.
ui-your-name = Your name
ui-z-error = Z error
ui-z-error-in-the-clouds-middle = Z error in the cloud's middle
ui-zones = { $n ->
        [one] { $n } zone
       *[other] { $n } zones
    }
ui-zones-without-measurement = Zones without measurement

ages-calibrations-order-records-go-measuring = The ages of calibrations and the order of records depend on the clock; measurements do not.
all-datasheets-can-read = All datasheets and certificates are readable.
all-kept-can-read = All stored records are readable.
all-there-they-were-recorded = All recordings are present and unchanged.
and-more-records = And { $count } more.
another-station-publishes-under-ones-name = Another station publishes under the name of this station.
answers-browsers = Response to browsers
archive = Archive
archive-complete = Everything that is finished is in { $place }, read there and compared. Also on this disk: { $archived }. Only there: { $away }.
archive-copying =
    { $waiting ->
        [one] { $waiting } record ({ $size }) is being copied to { $place }.
       *[other] { $waiting } records ({ $size }) are being copied to { $place }.
    }
archive-disk = Disk of the archive
archive-disk-why = A disk that fails takes everything that is on it.
archive-look-at-log = Look at the log below, or send a support bundle.
archive-name-other-disk = Name a folder on another disk, or a store of another machine, as url in [archive] of station.toml.
archive-on-own-disk = The archive { $place } is not on the disk of the data folder.
archive-trouble =
    { $waiting ->
        [0] { $trouble } Nothing is waiting; the next attempt is in { $minutes }.
        [one] { $trouble } { $waiting } record is waiting; the next attempt is in { $minutes }.
       *[other] { $trouble } { $waiting } records are waiting; the next attempt is in { $minutes }.
    }
archive-why = What is not in the archive exists on this station's disk only.
background-work = Background work
background-work-remedy = Look at the log below, and send the support bundle. Restart the station if a part goes on failing.
background-work-runs =
    { $count ->
        [one] One part runs.
       *[other] All { $count } parts run.
    }
background-work-why = It keeps what browsers show current, and watches devices, scans and the disk.
backup = Backup
bring-back-last-backup-delete-under = Restore it from the last backup, or delete it under Records.
broker = Broker
broker-messages-not-read =
    { $count ->
        [one] { $count } message on the broker was not read: { $reasons }.
       *[other] { $count } messages on the broker were not read: { $reasons }.
    }
can-written = The data folder is writable.
cannot-written = The data folder is not writable: { CLAUSE($trouble) }.
check-address-below-try = Check its address below and test it.
check-cable-power-looked-again-itself = Check its cable and its power. It reconnects automatically.
check-cannot-made = The check { $name } could not run: { CLAUSE($reason) }.
check-failed = Failed check
check-folders-owner-whether-disk-mounted = Check the folder's owner and whether its disk is mounted.
check-sensor = Check the sensor.
clock = Clock
clock-set-since-start-last =
    { $count ->
        [one] The clock was set once since the start, by { $last_jump }.
       *[other] The clock was set { $count } times since the start, last by { $last_jump }.
    }
close-other-programs-restart-station-between = Close other programs, or restart the station between two scans.
close-what-else-uses-machine = Close other programs on this machine.
connected = Connected to { $host }.
correct-remove-files-named = Correct or remove the files that are named.
could-true-last-ago = Implausible readings: { $count }, the last { $ago } ago: { CLAUSE($what) }.
damaged = The database is damaged: { $trouble }.
database = Database
datasheets = Datasheets
datasheets-set-aside-everything = Files in arms, objects, sensors and gauges that cannot be read are set aside unchanged; everything else is available.
delete-scans-under-records-use-larger = Delete scans under Records, or use a larger disk.
disk = Disk
disk-fails-takes-every-calibration-scan = If the disk fails, every calibration and scan on it is lost.
error-not-foreseen = An error here is a case that the program did not foresee.
errors-or-none-last-hour =
    { $count ->
        [0] No errors in the last hour.
        [one] One error in the last hour.
       *[other] { $count } errors in the last hour.
    }
every-reading-joints-could-true = All joint readings are plausible.
everything-grows-metre-aluminium = Everything expands with it: one metre of aluminium by { $growth } per degree.
frame-without-joints-around-gives-no = A frame without arm readings around it gives no points.
free = { $free } is free.
free-enough-for-hours = { $free } is free, enough for { $hours } hours of this scan.
give-each-own-name-station-mqtt = Give each station its own name with station in [mqtt] of station.toml.
held-up-live-numbers-stand-press = During a delay, live numbers freeze and buttons respond late; the devices are still read.
held-up-more-than-longest =
    { $count ->
        [one] delayed once by more than { $limit }, for { $longest }
       *[other] delayed { $count } times by more than { $limit }, for up to { $longest }
    }
holds-journal-every-step-accounts-what = It contains the journal of every step, the accounts, and the selection of the calibration in use.
last-days-old = The last backup is { $days } days old, in { $place }.
last-days-old-same-disk = The last backup is { $days } days old, in { $place }. It is on the same disk as the data.
let-each-station-write-under-own = Let each station publish only under its own topic, and remove the retained messages of others from the broker.
let-kept-time-server-which-moves = Synchronise it with a time server, which adjusts it gradually.
log = Log
log-cannot-written-health-page-says = The log cannot be written; see the Health page.
log-event-loop-goes-on = the event loop continues after { $duration }
log-event-loop-held-up = the event loop is blocked for more than { $limit }
log-has-what-held-up-send = The log states the cause; send the support bundle if it happens again.
log-lines-lost =
    { $count ->
        [one] one line of the log was lost because the disk was too slow
       *[other] { $count } lines of the log were lost because the disk was too slow
    }
log-program-stood-still = the whole program was suspended for { $duration }
log-repeated = ({ $count } of these since { $since })
logs-cannot-written = The logs in { $folder } cannot be written
look-log-below-send-support-bundle = Check the log below, and send the support bundle to your support.
look-them-below-send-support-bundle = Check the errors below, and send the support bundle.
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
make-one-below-crenel-backup = Make a backup below, or with crenel backup.
memory = Memory
messages-of-no-station = { $count } not in the form of a station
messages-of-too-many-stations = { $count } from more stations than are displayed
messages-stations = Messages of the stations
messages-too-long = { $count } too long
messages-too-often = { $count } more often than they are read
name-folder-another-disk-backups-station = Set backups in station.toml to a folder on another disk.
name-tls-certificate-tls-key-station = Set tls_certificate and tls_key in station.toml, or put a proxy in front of the station.
network = Network
never-held-up-more-than = Never delayed by more than { $limit }.
newest-record-days-later-than-clock = The newest record is { $days } days ahead of the clock.
no-connection-for = No connection to { $host } for { $duration }: { CLAUSE($reason) }.
no-data-yet = No data yet.
not-read-yet = Not read yet.
nothing-taken-reading-cannot-true-no = Implausible readings are not used for contact points, poses or scanned points.
notifications-not-accepted = { $host } does not accept notifications: { $trouble } ({ $failed } not delivered).
only-machines-browsers-reach-station = Only browsers on this machine reach the station.
other-machines-reach-encrypted = Other machines reach the station over an encrypted connection.
other-machines-reach-nothing-encrypted = Other machines reach the station without encryption.
other-machines-reach-proxy = Other machines reach the station through a proxy.
other-stations-see-one-one-them = Stations see each other through the broker. Nothing else depends on it.
put-file-back-last-backup-leave = Restore the file from the last backup, or leave it and continue.
readings-arm = Readings of the arm
recordings = Recordings
recordings-calibrations-journal-kept-there = It contains the recordings, the calibrations and the journal.
recordings-damaged =
    { $more ->
        [0] { CLAUSE($first) }.
       *[other] { CLAUSE($first) }, and { $more } more.
    }
records = Records
runs-steadily = It runs steadily.
scan-can-made-again-recording-verification = Recordings allow a scan to be computed again and a verification to be proven.
scan-does-start-less-than-0 = A scan requires at least 0.5 GB to start, and stops at 0.1 GB.
second-newest-old = { CLAUSE($text) }: { $rate } per second, the newest { $age } old.
set-machines-clock-let-kept-time = Set the machine's clock, and synchronise it with a time server.
sign-in-health = Sign-in with accounts of the plant
sign-in-health-remedy = Accounts of this station can sign in. Check the network, the provider and [sign_in] of station.toml
sign-in-health-why = Without the provider, only accounts of this station can sign in; who is signed in stays so.
sign-in-provider-answers = { $name } answers.
since-calibration = { $celsius }, { $change } since the calibration.
software-part =
    { $part ->
        [processors] { $version } processors
       *[other] { $part } { $version }
    }
somebody-publishes-what-no-station-does = These messages do not come from a working station, and may hide or falsify what is displayed.
station-uses = The station uses { $process }.
station-uses-and-free = The station uses { $process }; { $free } is free.
stop-station-keep-copy-data-folder = Stop the station, keep a copy of the data folder, and start from the last backup.
takes-notifications = { $host } accepts notifications.
tells-whoever-away-what-done-fault = It informs people who are away about completed jobs, faults and due checks.
there-none-yet = There is no backup yet.
thread-has-died = Ended by an error { $ago } ago: { $name } ({ CLAUSE($error) }).
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
verify-against-gauge-calibrate-again = Verify against a gauge, or calibrate again.
webhook = Webhook
what-cannot-read-set-aside-everything = Unreadable records are set aside unchanged; everything else is available.
what-looks-may-good-bad = The state of what it checks is unknown.
who-reads-along-has-passwords-can = Anyone who reads unencrypted traffic has the passwords and can act as other people.
whoever-helps-you-asks-first = Support asks for this first.
whole = It is intact, { $size_mb }.
whole-program-stood-still-longest =
    { $count ->
        [one] the whole program was suspended once, for { $longest }
       *[other] the whole program was suspended { $count } times, for up to { $longest }
    }
without-free-memory-whole-machine-slows = Without free memory the whole machine slows down, and frames are lost.
without-nothing-measured-what-taken-kept = Nothing is measured without it; all recorded data is kept.

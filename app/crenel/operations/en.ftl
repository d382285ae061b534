arm-check-no-limit = { $half_range }, no limit is set.
arm-check-with-limit = { $half_range }, limit { $limit }.
backup-being-made-already = A backup is already being made
backup-is-in = The backup is in { $folder }.
calibrate-this-sensor = Calibrate this sensor
calibration-cannot-read = The calibration { $name } is unreadable.
calibration-in-use-unreadable = The calibration in use cannot be read: { $error }
calibration-known-here = its calibration is unknown on this station
calibration-use-cannot-read = The calibration in use cannot be read
change-them-in-file = change their tables [sensor.NAME] in { $file }, and start the station again
demonstration = The demonstration
demonstration-accepts = The simulated operator accepts this calibration. A person would look at the numbers first.
demonstration-calibrates = The simulated operator calibrates the sensor: contact points, then pictures.
demonstration-not-calibrated = The demonstration has ended without a calibration.
demonstration-scans = The simulated operator scans the parts on the table.
demonstration-scans-soon = The simulated operator starts a scan. The laser switches on.
demonstration-stopped = The demonstration was stopped. Everything so far is kept: go on by hand.
device-was-chosen = The station uses another { $title }
devices-of-replay-are-fixed = A replay has the devices of its recording
journal-has-rows-cannot-read-first =
    { $count ->
        [one] The journal has { $count } unreadable row, row { $first }.
       *[other] The journal has { $count } unreadable rows, the first is row { $first }.
    }
no-backup-made = No backup was made: { $error }
no-points-can-made = { $interrupted } Its points cannot be computed: { CLAUSE($why) }.
no-readable-figures = { $name } has no readable figures
nothing-runs = Nothing is running
performance-cannot-read = The entry of performance test { $one } cannot be read.
points-made = { $name }: { $points } points computed.
points-made-again-while-no-scan = Its points are computed from its recording while no scan is running.
points-made-when-there-room-no = { $interrupted } Its points are computed once there is space on the disk and no scan is running.
points-not-made-again = Its points cannot be computed: { CLAUSE($why) }.
put-file-back-last-backup-restart = Restore its file from the last backup and restart the station, or calibrate again
recording-kept = { $name }: the recording is kept.
sensor-calibrated = { $name }: { $calibration }, { $total } (k = 1)
sensor-cannot-be-selected-now = another sensor cannot be selected now
sensor-without-calibration = { $name }: not calibrated yet
station-ended-during-scan = The station ended during this scan.
station-has-several-sensors-not-changed-here = this station has several sensors, which are not changed here
uncertainty-missing = { $file }: uncertainty is missing
verification-cannot-read = The verification { $one } is unreadable.
what-recorded-kept = { $interrupted } All recorded data is kept.
writing-scan = Writing the scan

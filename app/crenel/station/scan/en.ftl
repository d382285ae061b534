bring-part-into-sensors-range-if = Bring the part into the sensor's range; if it is there, check the exposure.
calibrate-first-within-sentence = calibrate first
calibration-is-for-joints = the calibration is for an arm with { $joints } joints
calibration-is-for-poses = the calibration is for an arm that reports poses
calibration-is-for-serial-number = the calibration is for { $serial_number }
check-sensors-cable-close-other-programs = Check the sensor's cable, or close other programs.
computer-cannot-keep-up = The computer cannot keep up: its queue is { $share } full
connect-arm-calibrate-one = connect that arm, or calibrate with this one
connect-calibrate-one =
    { $device ->
        [arm] connect that arm, or calibrate with this one
       *[sensor] connect that sensor, or calibrate with this one
    }
connected-arm-has-joints = the connected arm has { $joints } joints
connected-arm-reports-poses = the connected arm reports poses
connected-has-serial-number =
    { $device ->
        [arm] the connected arm has the serial number { $serial_number }
       *[sensor] the connected sensor has the serial number { $serial_number }
    }
disk-full-during-scan = The disk became full during this scan.
every-stripe-pictures-wait-them = All stripes are recorded; they take precedence over pictures.
frames-lost-when-full-scan-more = Frames are lost when it is full; scan more slowly or close other programs.
go-over-these-places-again-slower = Scan these places again, more slowly.
go-slower-shorten-exposure = Move more slowly, or shorten the exposure.
line-stands-still = The line stands still: beyond its first { $most } frames it gives no points; frames without them so far: { $count }
move-sensor-or-stop-scan = Move the sensor over the part, or stop the scan.
no-free-name-scan = no free name for a scan in { $folder }
no-laser-line-visible = No laser line is visible
nothing-made-them = They were not used. { CAPITAL(CLAUSE($remedy)) }.
only-free-disk = only { $free } is free on the disk of { $folder }
pictures-came-without-arms-position = { $count } of { $total } pictures have no arm position
pictures-left-out = Pictures are skipped: { $what }
pictures-recording-were-left-out = { $kept } pictures were recorded, { $left_out } were skipped
pictures-were-lost = { $count } of { $total } pictures were lost
pictures-were-taken-too-fast-up = { $count } of { $total } pictures were taken too fast: blur up to { $worst }
points-saved =
    { $count ->
        [one] { $name }: { $count } point saved
       *[other] { $name }: { $count } points saved
    }
readings-arm-could-true-last =
    { $count ->
        [one] { $count } reading of the arm was implausible: { $what }
       *[other] { $count } readings of the arm were implausible; the last: { $what }
    }
recorded-data-kept = All recorded data is kept.
recording-keeps-still-lines = The recording keeps them all.
recording-stopped = the recording stopped
scan-cut-short = This scan ended early: { CLAUSE($reason) }.
scan-gap-again = Scan again what was passed over meanwhile, and keep the computer from sleeping.
scan-goes-when-back = The scan continues when it is back.
scan-incomplete-again = The rest of the part is missing from the cloud: mend the cause, and scan again.
scan-needs = a scan requires { $needed }
scan-started-at = Scan { $started }
scan-stopped = The scan stopped: { $error }
scan-stopped-within-sentence = the scan stopped
scan-was-suspended-nothing-recorded = The program was suspended for { $duration } during this scan and recorded nothing meanwhile.
sends-nothing =
    { $device ->
        [arm] the arm sends no data
       *[sensor] the sensor sends no data
    }
sensor-now-sends-pictures-pixels = the sensor now sends pictures of { $size } pixels
sensors-image-has-pixels = the sensor's picture has { $width } × { $height } pixels
sensors-line-lists-differ = the points of the sensor's line are incomplete
set-sensor-back-calibrate-again = restore the sensor's settings, or calibrate again
set-sensor-back-scan-again = restore the sensor's settings, and scan again
start-again-within-sentence = start it again
stop-before-next = stop it before the next one
switch-stop-scan = Switch it on, or stop the scan.
the-laser-is-off = The laser is off
there-no-valid-calibration = there is no valid calibration
they-recording-but-gave-no-points = They are in the recording but gave no points; check the arm's cable.
too-fast-blur-limit = Too fast: { $blur } of blur; the limit is { $limit }
wait-until-does = wait until it does
without-one-pixels-cannot-become-points = without one, pixels cannot be converted to points

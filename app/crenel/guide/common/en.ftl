abandoned = cancelled the session
accepted-result = accepted the result
arm-at-stop = A joint of the arm is at its stop.
arm-near-base = The arm is folded close to its base.
arm-session-under-way-go-where-stands = A check or identification of the arm is in progress. Continue where it stopped.
arm-stretched-out = The arm is stretched out.
began-again = started again
began-cloud = started a cloud
began-seat = started a place
calibrate-again = Calibrate again
calibrate-sensor-arm-pictures-of-board = Calibrate the sensor on the arm: take pictures of a chessboard from different sides.
calibrate-sensor-arm-touch-object-then = Calibrate the sensor on the arm: touch the object, then take a few pictures.
calibration-age-and-temperature = { $text }, { $ago } old; due after { $limit }, or after a temperature change of { $change } (now { $now }).
calibration-due = The calibration is due. { $text }
calibration-not-verified-yet = This calibration is not verified yet.
calibration-under-way-go-where-stands = A calibration is in progress. Continue where it stopped.
calibration-valid-verified-scan-part = The calibration is valid and verified. Scan the part.
cannot-read = The calibration cannot be read: { $text }
certificate-set-aside = { $file }: { CLAUSE($why) }.
check-ago-failed = The check { $ago } ago failed: { $text }
check-arm = Check the arm
check-arm-again = Check the arm again
check-first-page-arm-tip-takes = Check it first on the page Arm & tip; it takes a minute.
check-tip = Check the tip
check-tip-again = Check the tip again
checked-ago = Checked { $ago } ago: { $text }
checked-ago-after-check-due = Checked { $ago } ago; due after { $limit }.
chose-arm = selected the arm
chose-artefact = selected the artefact
chose-face = selected a face
chose-feature = chose a feature
chose-gauge = selected the gauge
chose-program = chose a program
chose-what-use = selected the equipment
comes-after-calibration = Calibrate before verifying.
confirmed-devices = confirmed the devices
confirmed-gauge = confirmed the gauge
confirmed-object-picture = confirmed that the object is in the picture
confirmed-touches = confirmed the contact points
confirmed-what-use = confirmed the equipment
datasheet-says-raw = { $path } says that the sensor's pictures are raw (bayer)
driver-selects-raw-pixels = on a station, the driver selects the pixels of the laser's colour
dropped-cloud = discarded a cloud
dropped-coordinates = dropped coordinates of a tracker
dropped-seat = discarded a place
dropped-swing = discarded the points of a place
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
ended = ended the session
ended-pictures-by-themselves = ended the pictures by themselves
finished-cloud = finished a cloud
finished-seat = finished a seat
go-calibrating = Continue calibration
go-checking-arm = Continue with the arm
go-inspecting = Continue inspection
go-testing = Continue performance test
go-verifying = Continue verification
had-begun-adding-the-laser = started to add the laser
had-calculated = started the computation
had-calculated-without-laser = started the computation without the laser
inspection-under-way-go-where-stands = An inspection is in progress. Continue where it stopped.
kept-picture = kept the picture
last-verification-older-than-calibration = The last verification is older than this calibration.
less-than-minute = less than a minute
let-simulation-do = Let the simulated operator do it
let-simulation-do-everything = Let the simulated operator do everything
move-bayer-to-station-toml = Set bayer and laser_colour in [sensor] of station.toml; take bayer out of the datasheet, and halve its width_px and height_px
move-sensor-over-part-yourself = Move the sensor over the part yourself
named-inspected-part = named the part to inspect
never-checked = It has never been checked.
never-tested = It has never been tested.
no-simulation-of-real-devices = Real devices have no simulated operator
old-after-days-due = It is { $ago } old; due after { $limit }.
old-due-after-days = { $text }, { $ago } old; due after { $limit }.
passed-ago-due-after-days = Passed { $ago } ago; due after { $limit }.
performance-began-scan = began a scan of the artefact
performance-chose-bar = chose the ball bar
performance-confirmed-artefact = confirmed the artefact
performance-confirmed-step = confirmed a step
performance-dropped-scan = discarded a scan of the artefact
performance-finished-scan = ended a scan of the artefact
performance-set-by-scan = chose touch or scan
performance-set-positions = chose how many positions
performance-test-under-way-go-where-stands = A performance test is in progress. Continue where it stopped.
put-back-what-there-before = restored the previous arm
put-last-one-back = restored the last entry
removed-point = removed a point
request-invalid = The request is invalid
saved-result = saved the result
scan = Scan
scan-under-way-go-where-stands = A scan is in progress. Continue where it stands.
send-support-bundle = Send the support bundle
session-cannot-read-set-aside = The session { $session_id } cannot be read and is set aside: { $error }.
session-not-readable-with-change = the session could not be read with this change
set-cloud-aside = excluded a cloud
set-limit = set the limit
set-pose-aside = excluded a pose
set-temperature = set the temperatures of artefact and arm
set-what-line-is-like = set what the laser line is like
simulation-not-moving = The simulated operator is not moving.
simulation-scanning = The simulated operator is scanning
simulation-scans = The simulated operator scans the { $part }
simulation-work = The simulated operator is running
skipped-feature = skipped a feature
started-pictures-by-themselves = had pictures taken by themselves
started-simulation = started the simulated operator
stop-first = Stop it first
stop-simulation = Stop the simulated operator
stopped-simulation = stopped the simulated operator
test-performance = Test the performance
test-performance-again = Test again
than-when-made-beyond-c-due =
    { $how ->
        [warmer] The temperature is { $difference } higher than at the calibration; due beyond { $limit }.
       *[colder] The temperature is { $difference } lower than at the calibration; due beyond { $limit }.
    }
there-no-command = There is no command '{ $name }'.
there-no-simulation-real-devices = Real devices have no simulated operator.
tip-never-checked = The tip has never been checked.
tip-says = Tip: { $text }
title-performance-test = Performance test
took-cloud-back = included a cloud again
took-coordinates = took coordinates of a tracker
took-feature-again = touched a feature again
took-last-one-back = removed the last entry
took-picture = took a picture
took-picture-again = took a picture again
took-point = took a point
took-pose-back = included a pose again
touch-in-another-posture = Points taken so are worse: take them in another posture, or move the object
touch-scan-gauge-takes-two-minutes = { $text } Touch and scan a gauge: it takes two minutes.
verification = Verification
verification-failed-ago = It failed { $ago } ago. { $text }
verification-undecided-ago = It was undecided { $ago } ago. { $text }
verification-under-way-go-where-stands = A verification is in progress. Continue where it stopped.
verify = Verify
verify-again = Verify again
wait-because = Wait: { CLAUSE($text) }.
wait-check-what-taken-kept = Wait, or check it. All recorded data is kept.
went-another-pose = continued with another pose
went-back-points = returned to the points
went-more-clouds = continued with more clouds
went-next-feature = went to the next feature
went-result = continued to the result
went-step-back = went back one step
went-without-probe = continued without contact points

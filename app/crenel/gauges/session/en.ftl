begin-new-one = Start a new one
calibrate-first = Calibrate first
hold-the-arm-still = Hold the arm still.
no-calibration-use-yet = no calibration is in use yet
no-touch-taken-back-since-last = No contact point has been removed since the last one was taken.
performance-another-length-not-taken = This touch makes the length { $found } instead of { $wanted }; it was not taken
performance-no-arm = no datasheet in the folder arms belongs to the connected arm, or it states no tip
performance-nothing-to-test = There is nothing to test
performance-put-arm-json = Put the arm’s arm.json, with its serial number and tip, into the folder arms
performance-scan-is-measured = The last scan is still being evaluated.
performance-sphere-touch-not-taken = The sphere was touched near there already; this touch was not taken
performance-touch-ends-of-length = Touch the other end of the length that is named
performance-touch-off-sphere = This touch lies { $off } off the sphere that was touched before; it was not taken
performance-touch-same-sphere = Touch the same sphere, or take its touches back and begin again
performance-touch-sphere-elsewhere = Spread the touches over the sphere
performance-touches-missing =
    { $missing ->
        [one] One touch is missing.
       *[other] { $missing } touches are missing.
    }
sessions-arm-cannot-read = The session's arm cannot be read
touch-off-plane = This touch lies { $off } off the plane that was touched before; it was not taken
touch-same-plane = Touch the same face, or take its touches back and begin again

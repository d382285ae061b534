a-calibration-belongs-to-one-sensor = a calibration belongs to one of them
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
arm-model-arm = the arm model belongs to arm { $serial_number }
calibration-arm = the calibration belongs to arm { $known }
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
clouds-do-not-overlap = Only { $count } of { $total } compared points lie on the other scan
compare-scans-of-one-place = Compare scans of the same part at the same place
comparison-needs-points = The scan to compare with has { $count } points; { $needed } are needed
coordinate-left-out-off = coordinates.csv line { $number } ({ $place }): { $distance } off
delay-drifts = The delay drifts by { $drift } (k = 1: { $u }), { $change } within the pass: the clocks of arm and camera run at different rates.
delay-jumped = The delay changed by { $change } (k = 1: { $u }) at { $at } after the first picture (k = 1: { $at_u }): a clock was set.
delay-varies = The delay varies within the pass, as where the arm's packets arrive late by different times: { $u } (k = 1) of its uncertainty comes from this.
frame-has-pixels = { $path }: frame { $number } has { $width_px } × { $height_px } pixels
frames-joint-samples-which-neighbours-up = frames from { $frames_from } to { $frames_to }, arm readings from { $joints_from } to { $joints_to }; neighbouring samples are used up to { $gap } apart
frames-left-out-clock-set = { $count } of { $frames } frames excluded: a clock was set back around their time stamps
frames-left-out-no-joints-around = { $count } of { $frames } frames excluded: no arm readings around their time stamps, the first { $first } from the start; { $beyond } before the first or after the last sample, { $gaps } in gaps
give-a-calibration-for-each-sensor = give the calibration of each sensor with its name, as in { $name }=calibration.json
give-arm-and-camera-one-clock = Keep both on one clock (PTP, or pulses of the arm), or determine the delay before each scan.
give-calibration-sensor-took-recording = Give the calibration of the sensor that made this recording
give-calibration-without-name = give its calibration without a name
give-files-belong-together = Give the files that belong together
holds-more-than-frames = { $path } contains more than { $most } frames
holds-no-topics = { $path } contains no topics
holds-topics = { $path } contains { $topics }
is-of = { $path } belongs to { $device } { $of }
its-sensor-has-no-name = its sensor has no name
its-sensors-are = its sensors are { $names }
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
joints-of-others-left-out = joints that arm.json does not have are left out: { $names }
laser-off-too-weak-part-out = the laser was off or too weak, or the part was out of range
no-frames = { $named }: no frames
no-joint-angles = { $named }: no joint angles
no-joints-around-any-frames-stamp = { $named }: no arm readings around the time stamp of any frame
no-laser-stripe-front-sensor-any = { $named }: no laser stripe in front of the sensor in any frame of { $numbered }
one-picture-flat-board-tells-neither = one picture of a flat board determines neither the focal length nor the laser plane
one-pose-not-enough = one pose is not sufficient on { $name }
one-pose-takes-no-raw = one pose cannot be calibrated from raw Bayer pictures
other-files = the other files belong to { $device } { $known }
pass-half-minute-enough = a pass of half a minute is sufficient
pass-over-one-flat-plate = Pass over one flat plate, and leave out its edge.
pictures-do-not-fit-delay = { $off } of { $pictures } pictures do not fit one plane at this delay.
point-left-out-off = { $place }, point { $number }: { $distance } off
pose-used-other-one-pose =
    { $unused ->
        [one] pose { $number } was used; the method one-pose does not use the other one
       *[other] pose { $number } was used; the method one-pose does not use the other { $unused }
    }
record-one-pass-over-plane = Record one pass over a plane
recording-has-no-sensor-named = { $path } has no sensor named { $name }
recording-has-one-sensor = { $path } is a recording of one sensor
recording-has-sensors = { $path } is a recording of several sensors ({ $names })
same-picture-as-pose = { $name } is the picture of pose { $number } again
same-picture-counts-once = the same picture counts once
scan-again = Scan again
scan-again-arm-camera-one-clock = Scan again, with the same clock for arm and camera
scan-has = a scan has { $joints_topic } and { $image_topic } or { $stripe_topic }
scan-incomplete-remedy = Scan again after the cause is mended; crenel reconstruct --allow-incomplete makes the points that are possible, with gaps
scan-incomplete-unread = the rest of the recording cannot be read, and may hold more than all its points so far
scan-is-missing-parts = { $path } is incomplete: { $missing }
sensor-left-out =
    { $count ->
        [one] one frame
       *[other] { $count } frames
    } of the sensor { $name } left out: no calibration was given for it
set = set { $name }
stripes-were-smoothed = Points smoothed along the laser line by { $smoothing } when they were recorded: structures shorter than { $half } keep less than half of their height, and neighbouring points share their noise
taken = { $path } was taken with { $device } { $recorded }
the-is-for =
    { $device ->
        [sensor] the calibration is for { $known }
       *[arm] the arm.json is for { $known }
    }
use-a-chessboard-or-leave-out-the-option = Use a chessboard, or leave out the option
use-method-joint = Use --method joint
use-method-joint-pictures-board-several = use --method joint, with pictures of the board from several sides

arm-is-where-scan-ended = The arm is where the scan ended
arm-not-held-still = the arm was not held still
arm-sends-no-joint-angles = the arm sends no joint angles
arms-data-has-gap-there = the arm's data has a gap there
choose-arm-first-within-sentence = choose the arm first
connecting = Connecting to the { $title }
device-connected = The { $title } is connected
hold-still-again = repeat it and hold the arm still
lost-reconnecting = The connection to the { $title } was lost; reconnecting
move-tip-to-object = Put the tip to the object, then take the point
moved-turned = Moved { $moved } and rotated { $turned } in { $duration }
no-arm-model-joints-chosen = no arm model with { $joint_count } joints is selected
no-arm-model-poses-chosen = no arm that reports poses is chosen
no-data = No data from the { $title } for { $silent }
no-picture-came-sensor = the sensor sent no picture
no-picture-came-within = no picture arrived within { $limit }
no-picture-laser-came-within =
    { $state ->
        [on] no picture with the laser on arrived within { $limit }
       *[off] no picture with the laser off arrived within { $limit }
    }
nothing-touched-there = it has not moved since, so that the tip touches nothing
off = The { $title } is off
only-joint-samples-came = only { $count } arm readings arrived in { $duration }
picture-being-taken-already = a picture is already being taken
repeat-it = repeat it
s-driver-failed = The driver of the { $title } failed: { $error }
sensor-did-answer-laser-off = The sensor did not respond to Laser off
sensor-lost-exposure-longer-than = the sensor is disconnected, or its exposure is longer than that
sensor-reports-laser-other-state = the sensor reports the laser in the opposite state
sensor-sends-lines-no-pictures = the sensor sends laser lines and no pictures
sensors-laser-cannot-switched-here = this sensor's laser cannot be switched from here
sent-nothing-opening-again = The { $title } sent no data for { $silence }; reconnecting
set-sensor-send-pictures = set the sensor to send pictures, or use another sensor
silent-but-there = The { $title } is connected and waits for a trigger or a change
still = Still
this-needs-pictures = this needs a picture of what the camera sees
too-little-arm-data-yet = Too little arm data yet
use-switch-sensor = use the switch on the sensor
wait-until-arm-connected-again-nothing = wait until the arm is connected again; nothing was lost
wait-until-back = wait until it is back
wait-until-connected = wait until it is connected
wait-until-sensor-connected-capture-again = wait until the sensor is connected, and capture again
waiting-s-first-data = Waiting for the first data of the { $title }

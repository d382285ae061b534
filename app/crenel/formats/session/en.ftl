add-picture-delete-pose = Add the picture, or delete the pose
angles-are-in-other-unit =
    { $unit ->
        [deg] these are radians where degrees are expected
       *[rad] these are degrees where radians are expected
    }
arm-json-states-rotation = rotation in arm.json is { $name }
bar-has-two-ends = a bar has two ends
bar-named = bar { $name }
bar-position-has-ends = { $path }: bar { $bar }, position { $position } has the ends { $ends }
column-is = { $place }: { $column } is { $value }
complete-or-delete-rows-of-position = Complete or delete the rows of this position
convert-columns-degrees = Convert the columns to degrees
convert-lengths-mm-name-columns = Convert lengths to mm, and name the columns { $names }
convert-them-name-columns = Convert them, and name the columns { $first } to { $last }
correct-name = Correct the name
correct-place-or-name-marker-differently = Correct the place, or give the marker another name
correct-value-or-give-arm-json = Correct the value, or give the right arm.json
correct-value-or-name-artefact-differently = Correct the value, or give the other artefact another name
degrees-converted-twice = No joint turns so far: if degrees were taken for radians and converted, give them as they were; else correct the value
delete-columns-of-one = Delete the columns of one of them
delete-one-rows = Delete one of the rows
file-has-no-pictures = { $path } contains no pictures
file-has-no-pictures-with-laser = { $path } contains no pictures with the laser on
file-has-no-points = { $path } contains no points
file-has-no-readings = { $path } contains no readings
flange-differs = the flange differs by { $moved }
flange-lies-far = { $path }: the flange lies { $furthest } from its base
folder-has-none-of = it contains none of { $names }
give-arms-own-model-columns = Give the arm's own model, or columns { $names }
give-picture-as-taken-and-sensor-json = Give the picture as the camera took it, and the right sensor.json
give-quaternions-with-more-digits = Give qx, qy, qz, qw with at least four digits after the decimal point, the scalar last
give-qx-qy-qz-qw-order = Give qx, qy, qz, qw in this order, the scalar last
give-right-arm-json-columns = Give the right arm.json, or columns { $first } to { $last }
give-rows-different-pose-numbers-take = Give the rows different pose numbers, or take the pictures again
give-standard-uncertainty-of-certificate = Give the standard uncertainty (k = 1) of its certificate in millimetres
give-standard-uncertainty-of-instrument = Give the standard uncertainty (k = 1) of one coordinate, or of one angle
give-times-in-seconds = Give the times in seconds, from any beginning
give-times-of-one-clock = Give pictures and readings the times of one clock
it-is-a-file = it is a file
joint-angles-given-degrees = joint angles are given in degrees
joint-column-differs = q{ $joint }_deg differs by { $moved }
joint-columns-or-none =
    { $count ->
        [0] { $path } has no joint columns
        [one] { $path } has { $count } joint column ({ $names })
       *[other] { $path } has { $count } joint columns ({ $names })
    }
largest-angle-of-poses = { $path }: the largest of { $names } is { $largest }
lengths-of-smaller-unit =
    { $unit ->
        [m] these are millimetres where metres are expected
       *[mm] these are micrometres, or other than millimetres
    }
line-gives-other-length = line { $line } states { $length } for the same { $label }
line-gives-other-place = line { $line } states another one
marker-place-differs = { $place }: marker { $marker } has another place on the flange
name-a-folder = Name a folder
name-columns-by-unit =
    { $unit ->
        [deg] Name the columns with _rad, or convert the angles
       *[rad] Name the columns with _deg, or convert the angles
    }
name-columns-of-degrees = They hold degrees: name the columns { $first } … { $last }
name-folder-of-seats-spheres-bars = Name a folder of seats, spheres or ball bars touched with the arm, or of coordinates measured by a tracker
name-sessions-folder = Name a session's folder
named-joint-range = the range of joint { $joint } is { $low } to { $high }
no-flange-further-than = { $path }: no flange is further than { $furthest } from the arm's base
no-joint-angle-exceeds = { $path }: no joint angle exceeds { $largest }
no-picture-within-readings = no picture of { $path } was taken during the readings of { $readings }, from { $begin } to { $end }
no-rotation-exceeds = { $path }: no value of rx_deg, ry_deg and rz_deg exceeds { $largest }
one-of = it is one of { $names }
one-picture-at-a-time = a sensor takes one picture at a time
one-rotation-expected = a rotation is given in one way
one-used-each-lighting = one picture of each lighting is used
one-value-expected-for = one value from 0 to { $largest } is expected for { $label }
picture-at-time-of-line = { $place } has the same time_s as line { $line }
pictures-are-at = the pictures begin at { $begin }
pictures-of-one-pose-need-still-arm = the pictures of a pose are taken while the arm is still
pose-differs-from-line = { $place }: { $moved } from line { $line } of the same pose { $pose }
pose-has-no-picture = { $place }: pose { $pose } has no { $missing } picture
pose-needs-a-lit-picture = a pose requires one 'ambient' picture, or one with 'both' lights; on a chessboard, its 'laser' picture may be missing
pose-needs-both-lightings = a pose requires one 'ambient' and one 'laser' picture, or one with 'both' lights
quaternion-length = { $place }: (qx, qy, qz, qw) is { $length } long
restore-picture-delete-row = Restore the picture or delete the row
rotation-means-several = by the controller they can mean different things: { $names }
rotation-not-stated = { $path }: nothing says how { $columns } make a rotation
rotations-quaternion-has-length-1 = the quaternion of a rotation has length 1
row-feature = { $place }: feature { $feature }
row-file = { $place }: file { $file }
row-lighting = { $place }: lighting { $lighting }
second-picture-pose = { $place }: a second { $lighting } picture of pose { $pose }
sensor-has-pixels = the sensor has { $width } × { $height } pixels
sessions-pictures-lie-inside-folder = a session's pictures must be inside its folder
state-rotation-in-arm-json = State the controller as rotation in arm.json, such as "rotation": "kuka"
table-first-line-names = { $path }: its first line names { $names }
table-has-both = { $path } has the columns { $first } and { $second }
take-picture-object = Take a picture of the object
take-points-or-delete-file = Take some points, or delete the file
these-joint-angles-but-arm-json = these are joint angles, but arm.json states that the arm reports poses
these-metres-where-millimetres-expected = these are metres, but millimetres are expected
these-radians-where-degrees-expected = these are radians, but degrees are expected
time-from-zero-to = a time is from 0 to { $latest }
value-expected-between = a value from 0 to { $largest } is expected
write-readings-of-arm = Write the readings of the arm, with their times

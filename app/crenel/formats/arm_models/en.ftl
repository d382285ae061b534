add-dh-row = Give one row for each joint, in order
angle-beyond-a-turn = { $value } stands among them, more than a full turn in radians: these are degrees
angles-are-multiples = all are multiples of π/2, as { $value }: these are radians
angles-called =
    { $unit ->
        [rad] The angles are called radians
       *[deg] The angles are called degrees
    }
choose-another-end = Choose another end, or give the URDF of one arm
columns-not-read = Columns that are not read: { $names }
decimal-commas-read = Commas were read as decimal signs.
decimal-signs-mixed = Some numbers have a decimal comma ({ $one }), others a decimal point ({ $other })
dh-cell = Line { $line }: { $column } { $value }
dh-column-missing = No column for { $names }
dh-column-twice = Two columns for { $names }
dh-commas-between-cells = Commas stand between the cells here: write numbers with a decimal point
dh-needs-four-numbers = each row needs a, alpha, d and theta, and may begin with the name of the joint
dh-number-expected = a number, a multiple of π or a joint angle such as q1 + 90 is expected
dh-row-has-cells =
    { $count ->
        [one] Line { $line } has one cell
       *[other] Line { $line } has { $count } cells
    }
dh-rows-missing = The row of joint { $names } is missing
dh-rows-out-of-order = The rows are of joints { $names }, in this order
dh-rows-there = there are rows of { $names }
dh-table-has-columns = the table has { $count } columns
dh-variable-not-an-angle = the joint slides: its variable is a length
expand-xacro = Expand it with xacro FILE > robot.urdf, and give that
first-row-empty = length and twist of the first row are zero, and those of the last are not
flange-row-turns-no-joint = The row { $name } turns about no joint: it was taken as a constant transform behind the last joint.
give-lengths-of-links = Enter a and d of each joint
give-ros-kinematics = Give the YAML file with kinematics as the driver of the robot for ROS writes it
give-row-of-each-joint = Give one row for each joint; a row of the flange comes last and is called flange
give-unit-of-angles = Choose the unit of the angles
give-unit-of-lengths = Choose the unit of the lengths
give-ur-files = Give calibration.conf of the arm, alone or followed by urcontrol.conf
give-urdf = Give the URDF of the robot, as ROS reads it
index-before = lengths or twists have the index i − 1
last-row-empty = length and twist of the last row are zero, and those of the first are not
lengths-add-up = its lengths add up to { $total }, which in { $unit } is an arm of { $length }
lengths-all-zero = all lengths are 0: the links of an arm have lengths
lengths-in-unit = Read in { $unit }, the arm measures { $length }
limits-not-stated = The text states no limits of the joints: ±180° were put in.
model-answer-unknown = { $key } cannot be { $answer }
model-leaves-open = { $path } leaves open what it means
model-open = { $key } ({ $options })
model-open-likely = { $key } ({ $options }; likely { $likely }: { $why })
name-dh-columns = Name the columns in a first line, such as: joint, a [mm], alpha [deg], d [mm], theta [deg]
no-arm-has-such-lengths = no arm is so small or so large
no-dh-table = There is no Denavit-Hartenberg table in the text
nominal-is-not-this-arm = A nominal model is right for every arm of its kind, and exact for none: identify yours, or give its factory calibration.
only-order-with-right-angles = only in this order are all twists multiples of 90°
paste-dh-table = Paste a line for each joint with a, alpha, d and theta
ros-has-metres = Give the lengths in metres, as ROS has them
ros-link-cannot-be-used = The link { $link } of the kinematics cannot be used
ros-link-count =
    { $count ->
        [0] it is missing
       *[other] it is there { $count } times
    }
ros-number =
    { $there ->
        [yes] { $name } is { $text }, which is no number
       *[no] { $name } is missing
    }
rotary-joints-only = Arms of rotary joints can be used
say-what-is-open = Say it with --say KEY=VALUE for each
source-dh-table =
    { $rows ->
        [one] Denavit-Hartenberg table of one row
       *[other] Denavit-Hartenberg table of { $rows } rows
    }
source-nominal-arm = { $name }, by { $source }
source-robot-of-the-list = Without a text: a robot of the list
source-ros-kinematics = Kinematics of a Universal Robots arm, as ROS keeps its factory calibration
source-ur-calibration =
    { $calibrated ->
        [yes] Factory calibration of a Universal Robots arm
       *[no] Nominal model of a Universal Robots arm (urcontrol.conf)
    }
source-urdf = URDF of { $name }
two-units-of-length = The table states two units of length: { $units }
ur-nominal-only = The text has no factory calibration: the rows delta_theta, delta_a, delta_d and delta_alpha are in calibration.conf.
ur-not-calibrated = The file says of itself that the arm was not calibrated (calibration_status = 0)
ur-row-malformed =
    { $there ->
        [yes] The row { $name } is damaged
       *[no] The row { $name } is missing
    }
ur-six-numbers = six numbers in brackets are expected in each row
urdf-axis-is-zero = Joint { $name }: its axis has no direction
urdf-branches = At link { $link }, the robot branches: { $links }
urdf-chain-too-long = { $joints } rotary joints lead to link { $end }: an arm has five to seven
urdf-chain-too-short =
    { $joints ->
        [0] No link of the robot follows a rotary joint
       *[other] No link of the robot follows five rotary joints: the most is { $joints }
    }
urdf-circle = The links before { $link } follow each other in a circle
urdf-continuous = Joints that turn without end (continuous) have limits of ±360°.
urdf-first-link = it is the first link before the joints of the arm
urdf-flange = a tool is mounted there by its name
urdf-has-metres = Give the lengths of a URDF in metres
urdf-is-xacro = The text is a xacro, from which a URDF is made
urdf-joint-cannot-be-used = Joint { $joint } between { $base } and { $end } cannot be used
urdf-joint-follows-not-reported = it follows joint { $other } (mimic), so the arm does not report its angle
urdf-joint-kind =
    { $kind ->
        [prismatic] it slides (prismatic)
       *[other] its type is { $kind }
    }
urdf-kinds = the robot has these joints: { $kinds }
urdf-meshes =
    { $count ->
        [one] One mesh is named in the file: it is not needed, and not read.
       *[other] { $count } meshes are named in the file: they are not needed, and not read.
    }
urdf-numbers = Joint { $joint }: { $name } is { $text }
urdf-numbers-expected =
    { $count ->
        [one] a number is expected
       *[other] { $count } numbers are expected, separated by spaces
    }
urdf-only-end = the robot ends there
urdf-without-joints = The URDF has no joint
write-all-numbers-with-point = Write all numbers with a decimal point
xml-is-no-urdf = The text is XML with the element { $name } outside, but that of a URDF is robot

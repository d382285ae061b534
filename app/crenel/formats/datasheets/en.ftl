arm-angles-converted-twice = { $field } reaches { $largest }: these are degrees that were converted once more, as if they were radians
arm-angles-in-radians = no { $field } exceeds { $largest }: these are radians, but degrees are expected
arm-with-joints-needed = an arm that reports its joint angles is required here
bayer-needs-wavelength = { $bayer } requires { $wavelength }, whose colour's pixels are measured
contacts-stripe-several-levels-need-crenellated = contact points and stripes on several levels require a crenellated object
convention-is-pose = { $path }: convention is 'pose'
crest-z-mm-must-above-floor = { $crest } must be above { $floor }, and { $floor } above { $base }
dictionary-unknown = { $field } is one of { $names }
edges-x-mm-must-ascend-follows = { $edges } must ascend: { $right } follows { $left }
edges-x-mm-odd-count =
    { $edges } contains { $count ->
        [one] { $count } edge
       *[other] { $count } edges
    }; every merlon has two, a left and a right one
field-must-be-less-than-half-square = { $field } must be less than half a square; is it in micrometres?
first-id-too-large = { $field }: at most { $most } for these markers of { $dictionary }
front-y-mm-must-less-than = { $front } must be less than { $back }
give-certificate-crenellated-object-calibrate-command = Give the certificate of a crenellated object, or calibrate on the command line
give-denavit-hartenberg-model = Give the arm's Denavit-Hartenberg model (convention 'dh-standard')
joint-name-twice = two joints are named { $name }; recordings identify joints by name
kind-chessboard-not-supported = { $path }: kind 'chessboard' is not supported here
kind-is-block-or-board = it is 'crenellated', 'chessboard' or 'charuco'
kind-unknown = { $path }: kind { $kind } is unknown
lengths-are-in-metres = no a_mm or d_mm exceeds { $longest }: these are metres, but millimetres are expected
lengths-of-no-arm = a_mm and d_mm of all joints together are { $length }: these are inches or centimetres, but millimetres are expected
limits-deg-must-ascend = { $limits } of { $name } must ascend
marker-mm-less-than-square-mm = { $marker } must be less than { $square }
merlons-not-distinct-from-mirror-image = { $edges }: the merlons' widths and gaps read the same from both ends, so that the block cannot be distinguished from its mirror image
rotation-of-poses = rotation { $name } is not known, or the arm reports joints: a robot's is one of { $names }
square-mm-too-small = { $field } must be at least { $least }; is it in metres?
standard-uncertainty-mm-too-large = { $field } must be at most { $most }; is it in micrometres? For a block that nobody measured, state { $tolerance } instead
tip-missing-place-flange-diameter = { $tip } is missing: its position on the flange and its diameter
tolerance-mm-out-of-range = { $field } must be above 0 and at most { $most }; measure a block that is made worse, and make its certificate of the readings
too-few-markers = { $field }: the board has { $count } markers, but { $dictionary } has only { $known }
uncertainties-above-largest = { $field } needs { $one } beside it, which is the largest of them
uncertainties-of-edges-count = { $field } has { $found } edges, but the block has { $wanted }
uncertainty-or-tolerance = exactly one of { $one } and { $tolerance } is needed: the first if the block was measured, the second if only its drawing is known

arm-has-joint-number = the arm { $arm } has { $count }
arm-joints-not-among-them = of the joints of arm.json, { $names } are not among them
arm-json-has-joints = the arm.json of { $arm } describes joints
arm-json-is-of-poses = the arm.json of { $arm } is of an arm that reports poses
give-arm-json-arm-took = Give the arm.json of the arm that recorded this
give-arm-json-arm-took-recording = Give the arm.json of the arm that made this recording
give-recording-as-documented = Give a recording as docs/formats.md describes it
grey-encodings-expected = grey is expected: { $encodings }
image-encoding = { $name }: encoding { $encoding }
joint-at-stamp = { $path } at { $stamp_ns } ns: joint { $joint } is at { $reading }
joint-range = its range is { $low } to { $high }
joint-range-in-radians = its range is { $low } to { $high }; these are degrees, but radians are expected
lists-stripe-differ-length = the lists of a stripe differ in length
message-too-large = { $size } bytes exceed its maximum size
name-joints-as-recording = Name the joints in arm.json as the recording names them, or give the arm.json of the arm that took the recording
name-recording = Name a recording
name-scan-mcap = Name a scan.mcap
no-file = it is not a file
no-mcap-recording = it is not an MCAP recording
picture-bytes-do-not-fit = { $name }: { $bytes } bytes for { $width } × { $height } pixels, { $row } per row
picture-incomplete = the picture is incomplete
protobuf-expected = { $schemas } in protobuf is expected
record-radians = Record radians
recording-cannot-read = the recording cannot be read: { $reason }
recording-cut-off = the recording is incomplete
recording-cut-off-after = { $path } is incomplete or damaged after { $bytes } of { $size } bytes ({ $share }); read up to { $end } from its start
recording-cut-off-before-first-message = { $path } is incomplete or damaged after { $bytes } of { $size } bytes ({ $share }), before its first message
recording-cut-off-bytes-left = the recording is incomplete: { $size } of { $written } bytes remain
recording-damaged = the recording is damaged
recording-empty = the recording is empty
recording-has-joints =
    { $path } contains { $count ->
        [one] { $count } joint
       *[other] { $count } joints
    }
recording-has-joints-named = { $path } has { $count } joints ({ $names })
recording-has-poses = { $path } holds poses of an arm
recording-message-at = { $path } { $topic } at { $stamp_ns } ns
recording-missing = the recording is missing
recording-names-joints = { $path } names its joints { $names }
recording-no-file = the recording is not a file
scan-is-incomplete = { $count } of { $total } pictures with a line ({ $share }; limit { $limit }) gave no points, because the position of the arm was unknown or impossible
topic-holds = { $path }: { $topic } contains { $schema } ({ $encoding })
without-schema = without a schema

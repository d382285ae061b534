bring-more-object-into-picture = bring more of the object into the picture
bring-more-object-into-picture-sharp = bring more of the object into the picture, sharp and well lit
certificate-says = its certificate states { $square }
channel-of-colour =
    { $colour ->
        [red] red
        [green] green
       *[blue] blue
    }
channel-raw = { $colour } pixels of { $pattern }
channel-share = { $share } { $colour }
check-arms-file-lengths-angles-signs = Check the arm's file: its lengths and angles, the signs and order of its joints, and the tip; then check which face each contact point was taken on, and the object's certificate
check-session-taken-arm = check that the session was recorded with this arm
clean-blocks-edges-check-focus-lighting = Clean the block's edges; check focus, lighting and certificate.
contacts = the contact points
contacts-tips-sphere = contact points are taken with the sphere of a tip
fitting-contact-points = Fitting the contact points
give-laser-on-off-pair = Give a picture with the laser on and one of the same scene with it off
give-tip-or-leave-out-probing = give the tip in arm.json, or leave out probing.csv
image-shape-type = a picture of shape { $shape } and type { $dtype }
laser-off-or-covered = the laser is off, covered or too weak
laser-on-not-brighter = the picture with the laser on is not brighter than the one with it off
laser-on-off-differ = the pictures with the laser on and off differ: { $on } and { $off } pixels
lengths-of-unit-expected-mm =
    { $unit ->
        [m] these are metres, but millimetres are expected
        [cm] these are centimetres, but millimetres are expected
       *[inch] these are inches, but millimetres are expected
    }
needs-least-three-conjugated-pairs = it requires at least three conjugated pairs
on-face = on the { $face } face
rigid-fit-given-points = a rigid fit was given { $a } and { $b } points
rigid-fit-given-points-one-line = a rigid fit was given points on one line
same-camera-both = both come from one camera, in one mode
they-do-not-determine-camera = they do not determine the camera

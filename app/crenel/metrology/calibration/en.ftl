arm-encoders = arm encoders
arm-geometry = arm geometry
block-corner =
    { $level ->
        [crest] crest { $number }
        [floor] floor { $number }
       *[base] base
    }, { $place ->
        [L-front] front left
        [R-front] front right
        [L-back] back left
       *[R-back] back right
    }
bring-block-closer-so-fills-picture = Bring the block closer so that it fills the picture.
bring-block-middle-stripe = Bring the block to the middle of the stripe.
calibration-pose = the calibration pose
camera-and-mounting = camera and mounting
camera-parameters-do-not-converge = the camera's parameters did not converge on the edges in the picture
cameras-pixels-come-out-out-square = The camera's pixels deviate from square by { $difference }; present-day sensors have square pixels (limit { $limit }).
check-laser-exposure-sensors-stripe-axis = check the laser, the exposure and the sensor's stripe_axis, and let the stripe cross the middle of the object
check-object-picture-take-picture-again = check that this is the object in the picture, and take the picture again
check-pictures-joint-angles-own = Check that the joint angles belong to the picture.
check-tip-one-arms-file-block = Check that the tip matches the arm's file and that block and arm were fixed firmly; then check the arm's model.
check-tip-play-faces-dirt-have = Check the tip for play and the faces for dirt; then check the arm's model.
check-tips-diameter-block-then-arms = Check the tip's diameter and that this is the block; then check the arm's model.
compare-blocks-depth-heights-certificate = Compare the block's depth and heights with its certificate.
contact-off-by = { $number } ({ $face }, { $off })
contact-points = contact points
contacts-agree-blocks-size-tips-diameter = The contact points agree with the block's size and the tip's diameter: { $checked }.
contacts-disagree-others-were-left-out =
    { $left_out ->
        [one] { $left_out } of { $count } contact points contradicts the others and was excluded: { $named }.
       *[other] { $left_out } of { $count } contact points contradict the others and were excluded: { $named }.
    }
contacts-fit-block-rms = { $count } contact points fit the block to { $rms } rms.
contacts-fit-block-rms-up-good = { $count } contact points fit the block to { $rms } rms; up to { $good } is good.
contacts-lie-than-blocks-size-tips =
    { $sign ->
        [apart]
            The contact points on { $pair ->
                [left] left and right
               *[front] front and back
            } lie { $opening } further apart than the block's size and the tip's diameter give (limit { $limit }).
       *[together]
            The contact points on { $pair ->
                [left] left and right
               *[front] front and back
            } lie { $opening } closer together than the block's size and the tip's diameter give (limit { $limit }).
    }
contacts-scatter-times-what-arms-encoders = The contact points scatter by { $sigma }, { $arm_excess } times what the arm's encoders explain (limit { $excess }).
corner = corner { $column },{ $row }
corners-fix-camera-weakly-condition-number = The corners determine the camera weakly: condition number { $condition } (good below { $good }, refused above { $limit }).
edges-corners = edges and corners
error-in-column = column { $place }
error-in-row = row { $place }
extracting-laser-stripe = Extracting the laser stripe
face-and-number = { $face } { $number }
faces-agree-to = { $first } and { $second } to { $opening }
faces-contacts = { $faces } faces for { $contacts } contact points
finding-objects-edges = Finding the object's edges
have-arms-calibration-checked-hold-compact = Have the arm's calibration checked; hold the arm in a compact posture.
keep-reflections-out-grooves-matt-spray = Avoid reflections in the grooves: use matt spray, or lower the exposure.
laser-off-covered-beside-object-too = the laser is off, covered, not on the object, or too weak for this exposure
laser-off-too-weak-does-cross = the laser is off, too weak, or does not cross the object
laser-stripe-shows-points-s =
    { $missing ->
        [crest] the laser stripe has { $count } points on the crests
       *[floor] the laser stripe has { $count } points on the floors
    }
light-block-evenly-sharp-large-picture = Light the block evenly; show it sharp and large in the picture.
no-laser-stripe-found-object = no laser stripe was found on the object
no-two-opposite-sides-were-touched = No two opposite sides were touched: the tip's diameter and the block's size are taken from their certificates, unchecked.
object-certificate = object certificate
one-pose-does-not-show-arm-errors = One picture in one pose does not reveal errors of the arm's own model, joint angles that do not belong to the picture, or an object that moved after it was touched. This figure does not include them.
picture-does-not-show-certificate-not-checked =
    { $detections ->
        [one] The picture does not show { $hidden }: the certificate is not checked there.
       *[other] The pictures do not show { $hidden }: the certificate is not checked there.
    }
picture-has-size =
    { $picture ->
        [laser] the laser picture has { $width } × { $height } pixels
       *[ambient] the calibration picture has { $width } × { $height } pixels
    }
picture-objects-certificate-contradict-each-other = the picture and the object's certificate contradict each other
place-sensor-so-stripe-crosses-crests = place the sensor so that the stripe crosses crests and floors
point-known-good =
    { $point ->
        [seen] Standard uncertainty of a point seen at the board's distance, in the flange frame: { $total } (k = 1); up to { $good } is good.
       *[scanned] Standard uncertainty of a scanned point in the flange frame: { $total } (k = 1); up to { $good } is good.
    }
point-known-mostly-by =
    { $point ->
        [seen] Standard uncertainty of a point seen at the board's distance, in the flange frame: { $total } (k = 1), mainly from the { $source } ({ $value }); the limit is { $limit }.
       *[scanned] Standard uncertainty of a scanned point in the flange frame: { $total } (k = 1), mainly from the { $source } ({ $value }); the limit is { $limit }.
    }
points-edges-fit-camera-rms-limit = { $points } points on { $edges } edges fit the camera to { $rms } rms; the limit is { $edge_rms_px }.
points-laser-stripe-lie-object-levels = { $points } points of the laser stripe lie on the object (of { $found } on its levels; { $least } are required on crests and on floors)
refining-camera-lens-laser-plane = Refining camera, lens and laser plane
robots-poses = robot's poses
s-stripe-spans-blocks =
    { $level ->
        [crest] On the crests the stripe spans { $span } of the block's { $width }.
       *[floor] On the floors the stripe spans { $span } of the block's { $width }.
    }
sensor-measures-away-arms-last-joint = The measuring range of the sensor is { $away } away from the arm's last joint (limit { $farthest_mm }).
set-exposure-stripe-bright-not-clipped = Set the exposure so that the stripe is bright but not clipped.
show-more-block-crests-floors-front = Show more of the block: crests and floors, front and back.
size-expected = { $width } × { $height } pixels are expected
solving-camera = Computing the camera
stripe-one-level-alone-does-fix = a stripe on only one level does not determine the laser plane
stripe-points-fit-one-laser-plane = { $points } stripe points fit one laser plane to { $rms } rms (limit { $stripe_rms_px }), { $share } of those on the object (limit { $agreeing }).
take-more-poses-tilted-turned-have = Capture more poses, tilted and rotated; have the arm identified again.
take-these-points-again = Take these points again.
touch-front-back-left-right-face = Touch the front and back faces, or the left and right faces.
touch-more-points-on-all-faces = Touch more points, spread widely over all six faces.
turn-lamp-until-all-edges-block = Move the lamp until all edges of the block are visible, and take another picture.
usable-edge-stripe-points = { $found } usable edge and stripe points
use-block-better-certificate = Use a block with a better certificate.
use-full-pictures-one-sensor-neither = use full pictures of one sensor, neither cropped nor scaled
word-distortion = distortion
word-stripe = stripe
working-out-error-budget = Computing the error budget

bring-whole-object-into-view-front = bring the whole object into view, from its front and above, and light it evenly
camera-needs-two-levels-four-sides = the camera requires two levels and four sides of the merlons
can-read-more-than-one-way = it can be interpreted in more than one way
choose-object-before-camera-if-one = choose the object that is in front of the camera; if it is this one, check that its edges are clean and undamaged
edge-of-base =
    { $side ->
        [left] the left edge of the base
        [right] the right edge of the base
        [front] the front edge of the base
       *[back] the back edge of the base
    }
edge-of-crest =
    { $side ->
        [left] the left edge of the crest of merlon { $number }
        [right] the right edge of the crest of merlon { $number }
        [front] the front edge of the crest of merlon { $number }
       *[back] the back edge of the crest of merlon { $number }
    }
edge-of-floor =
    { $side ->
        [left] the left edge of the floor of groove { $number }
        [right] the right edge of the floor of groove { $number }
        [front] the front edge of the floor of groove { $number }
       *[back] the back edge of the floor of groove { $number }
    }
edges-lie-off-average-where-certificate = its edges deviate from the certificate by { $usual } on average, and { $edge } by { $distance }
edges-would-fit-only-if-cameras = its edges would fit only if the camera's pixels were { $off_square } out of square
edges-would-fit-only-lens-distorted = its edges would fit only with a lens distortion of k1 = { $k1 }, k2 = { $k2 }
focus-camera-bring-object-and-hold-still = focus the camera on the object, bring the object into the working distance, and hold still
focus-camera-object-bring-into-working = focus the camera on the object, bring the object into the working distance, and hold still
frame-shows-only-s-visible-edges = the picture shows only { $share } of the visible edges of { $name }
goes-beyond-end =
    { $side ->
        [right] { $edge } continues beyond its right end
       *[left] { $edge } continues beyond its left end
    }
height-of-level =
    { $level ->
        [base] the height of its base
        [floors] the height of its floors
       *[crests] the height of its crests
    }
hold-still-for-both-pictures = hold sensor and object still until both pictures are taken, or darken the room
less-than-pictures-edges-wide = { $text }, less than the edge width of { $width } in the picture
lies-where-certificate-puts = { $edge } lies { $distance } from its position in the certificate
light-front-above-so-crests-floors = light it from the front and above so that crests, floors and front differ, move closer, and remove what is in front of it
merlons-read-alike-either-side = its merlons look the same from both sides
merlons-read-mirrored-order = the merlons of { $name } appear in mirrored order
move-sensor-until-whole-object-picture = move the sensor until the whole object is in the picture
no-crenellated-object-found-picture = no crenellated object was found in the picture
no-placing-edges-explains-those-picture = no pose of the object explains the edges in the picture
none-edges-floors-base-shows-picture = none of the edges of its floors and its base is visible in the picture
not-sharp-enough = { $name } is not sharp enough for a reliable detection
not-visible-enough = { $name } is not visible enough for a reliable detection
nothing-else-bears-out-shadow-highlight = { $text }, but nothing else confirms it: a shadow, a highlight or something in front of it may look the same
object-does-not-match-certificate = the object in the picture does not match the certificate of { $name } ({ $serial_number })
object-looked-grey-images-8-16 = the object is detected in grey pictures of 8 to 16 bits with at least 64 pixels in each direction
object-not-found = the object was not found
only-corners-can-measured = only { $found } of its corners can be measured
only-edge-points-lie-edges = only { $agreeing } of the edge points lie on its edges
only-visible-edges-show-picture = only { $shown } of its visible edges appear in the picture
picture-blurred-edges-wide = the picture is blurred: its edges are { $width } wide
picture-blurred-edges-wide-most-can = the picture is blurred: its edges are { $blur } wide, but can be measured only up to { $limit }
picture-can-read-more-than-one = the picture of { $name } can be interpreted in more than one way
picture-dim-bright-parts-reach-full = the picture is dim: its bright parts reach { $high } of full scale
picture-mirrored-camera-looks-objects-back = the picture is mirrored, or the camera looks at the object's back
picture-overexposed = { $saturated } of the picture is overexposed
picture-shows-no-contrast-full-scale = the picture shows no contrast: { $contrast } of full scale
picture-soft-edges-wide = the picture is slightly blurred: its edges are { $width } wide
pictures-with-and-without-laser-differ-by-motion = something moved between the picture with the laser and the one without it ({ $shifted } of the picture), so that the room's light could not be taken off
rejected-and-few-edges-show = { $text }, and only { $shown } of its visible edges appear in the picture
seems-lie-where-certificate-puts = { $edge } seems to lie { $off } from its position in the certificate
side-merlon =
    { $side ->
        [right] the right side of merlon { $number }
       *[left] the left side of merlon { $number }
    }
side-of-block =
    { $side ->
        [back] the block's back
       *[front] the block's front
    }
straight-edges-do-not-form-block = its { $segment_count } straight edges do not form a block
too-few-edges-could-measured = too few of its edges could be measured
turn-down-exposure-until-objects-faces = lower the exposure until the object's faces are no longer overexposed
turn-off-cameras-mirroring-turn-object = turn off the camera's mirroring, or turn the object so that its front faces the camera
turn-up-light-exposure = increase the light or the exposure
turn-up-light-exposure-look-object = increase the light or the exposure, and check the object
upright-edge-of-merlon =
    { $end ->
        [back]
            the upright back edge on the { $side ->
                [right] right
               *[left] left
            } of merlon { $number }
       *[front]
            the upright front edge on the { $side ->
                [right] right
               *[left] left
            } of merlon { $number }
    }
use-object-whose-merlons-differ-width = use an object whose merlons differ in width
what-shows-could-more-than-one = the visible part could be more than one part of the object
what-shows-reads-rather-like-objects = the visible part looks more like the object's mirror image

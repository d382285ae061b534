bar-not-placed = the bar was measured in { $count } of { $needed } placements
master-sphere-not-measured = the master sphere is measured { $count } times with { $points } points each
other-bar-measured = placement { $placement } measured a length of { $measured }, and the nearest length of the certificate is { $certified }: this is another ball bar, or a length or diameter is mistyped
other-sphere-measured = the diameter of the touched sphere is { $off } off the certificate: this is another sphere, or a diameter is mistyped
performance-arm-not-turned-enough = The arm is held as for an earlier touch in this seat: it turned by { $turned }, and { $least } are needed. This touch was not taken
performance-articulate-arm = Move the elbow or turn the wrist, and touch again
performance-clamp-seat =
    { $number ->
        [1] Clamp the seat near the shoulder, at no more than a fifth of the reach.
        [2] Clamp the seat at about half the reach.
       *[other] Clamp the seat at four fifths of the reach or farther.
    }
performance-contact-title =
    { $step ->
        [diameter] Sphere, measurement { $number }
        [seats] { $number ->
            [1] Near seat
            [2] Middle seat
           *[other] Far seat
        }
       *[bar] Placement { $number }
    }
performance-diameter-error = error of the diameter { $error }
performance-left-out =
    { $which ->
        [sphere] Without a master sphere: the effective diameter was left out.
       *[bar] Without a ball bar: the volumetric lengths were left out.
    }
performance-move-seat = Clamp the seat in its next place first
performance-place-bar = Set the bar up as placement { $number } is drawn ({ $words }), and clamp it.
performance-placement =
    { $lies ->
        [away] horizontal, away from the arm
        [across] horizontal, across
        [up] vertical
        [rising-away] rising away from the arm
        [rising-left] rising to the left
        [rising-away-left] rising away from the arm to the left
       *[rising-away-right] rising away from the arm to the right
    }, { $at ->
        [near] near
        [far] far
       *[middle] in the middle
    }, { $side ->
        [left] { $bearing }° to the left
        [right] { $bearing }° to the right
       *[ahead] straight ahead
    }
performance-seat-has-no-certificate = The seats have no certified size, so the test value uncertainty of the single-point articulation is 0: play and movement of a seat count as errors of the arm.
performance-seat-largest = largest distance { $largest }
performance-seat-not-another = The tip is only { $away } away from an earlier seat; this touch was not taken
performance-seat-not-far = The far seat stands at { $share } % of the reach; the standard asks for at least { $least } %.
performance-seat-not-near = The near seat stands at { $share } % of the reach; the standard asks for at most { $most } %.
performance-seat-share = at { $share } % of the reach
performance-simulation-contacts = The simulated operator touches { $done } of { $of }
performance-step-bar = Ball bar
performance-step-diameter = Master sphere
performance-step-seats = Three seats
performance-touch-bar = Touch the { $end ->
        [1] first
       *[other] second
    } sphere of the bar at { $touches } places all around.
performance-touch-master = Touch the sphere at its top and at eight places around it: measurement { $number } of { $of }.
performance-touch-off-seat = The tip is { $off } away from the touches before: it is not in the seat. This touch was not taken
performance-touch-same-seat = Put the tip into the seat, or remove the contact point before if that one is wrong
performance-touch-seat = Put the tip into the seat and take { $count } touches. Between the touches move the elbow and turn the wrist, over both sides.
seats-not-measured = { $count } seats with { $points } points each are needed

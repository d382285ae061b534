another-tip-mounted-another-sphere-touched = The tip measures { $diameter }, but the arm's datasheet states { $expected }: another tip is mounted, or another sphere was touched.
arm-before = The previous arm is in use again.
arm-before-arms-put-back-hand = the previous arm is in arms/{ $replaced }/{ $name }; restore it by hand
arm-checked = Arm checked: { $worst }.
arm-identified = The arm is identified.
arm-place-name =
    { $kind ->
        [bar] bar { $number }, end { $end }
        [sphere] sphere { $number }
       *[seat] seat { $number }
    }
arm-place-title =
    { $kind ->
        [bar] Bar { $number }, end { $end }
        [sphere] Sphere { $number }
       *[seat] Seat { $number }
    }
arm-reports-poses-not-checked-here = The connected arm reports poses: its own software checks its joints and its tip.
arm-unchanged = The arm is unchanged.
arm-use-already = This arm is already in use.
back-places = Back to the places
ball-bars-lengths = Lengths of the ball bars
bars-end = end { $value } of the bar
belongs-another-step-session-stands =
    { $step ->
        [seat] This belongs to another step; the session is at 'Seat the tip'.
        [swing] This belongs to another step; the session is at 'Swing the arm'.
       *[result] This belongs to another step; the session is at 'Result'.
    }
calibrate-sensors-again-their-place-belongs = Calibrate the sensors again: their mounting was determined with the previous arm.
cancel-session = Cancel the session
changed-after-session-had-written = { $name } was changed after this session wrote it
check-again = Check again
check-one-seat = This is a check in one seat.
check-recorded-limit-set-before-next = This check is recorded with its limit. Set the limit before the next check.
check-tip-again-holding-still = Check again, holding still at each point.
choose-arm-first = Choose the arm first.
clamp-bar-firmly-reach-put-tip = Clamp the bar firmly within reach ({ $where }), and put the tip into one end.
clamp-cone-ball-seat-about-two = Clamp the cone or ball seat firmly at about two thirds of the reach, and put the tip into it.
clamp-firmly-reach = Clamp it firmly within reach ({ $where }).
clamp-seat-firmly-reach-put-tip = Clamp the seat firmly within reach ({ $where }), and put the tip into it.
clamp-sphere = Clamp the sphere
clean-both-check-again = Clean both, and check again.
clean-tip-clamp-sphere = Clean the tip, and clamp the sphere
clean-tip-seat-check-clamps-repeat = Clean tip and seat, check the clamps, and repeat. If the error persists, identify the arm.
coordinates-identify-only = coordinates are only used to identify the arm
drop-coordinates = Drop coordinates
drop-last-place = Discard the last place
enough-places = Sufficient places
exceed-limit-m = { $half_range } exceeds the limit of { $limit }.
expected-by-datasheet-and-expanded-uncertainty = datasheet: { $expected }; U = { $expanded_uncertainty }, k = 2
far-out = far out
finish-sphere = Finish the sphere
finish-swing = Finish the swing
give-certificate-first =
    { $kind ->
        [bar] Enter the length from the bar's certificate first.
       *[sphere] Enter the diameter from the sphere's certificate first.
    }
go-swinging-least-points = Keep swinging: { $taken } of at least { $least } points.
has-mm =
    { $kind ->
        [bar] The length of a bar is { $low } to { $high }.
       *[sphere] The diameter of a sphere is { $low } to { $high }.
    }
high-up = high
identified-arm-use = The identified arm is in use.
identify-arm = Identify the arm
identify-arm-first = Identify the arm first.
identify-arm-take-more-know-better = Identify the arm, or add places to determine it better.
identifying-arm = Identifying the arm
in-space-largest-and-two-s = In space: largest distance from the mean { $largest }, 2 s { $two_s } (figures of ASME B89.4.22, here for one seat).
keep-tip-seat-swing-elbow-one = Keep the tip in the seat. Swing the elbow from one side to the other and back, and tilt the wrist in every direction.
largest-distance = Largest distance
largest-half-range = Largest (max − min)/2
largest-swing = { $points }, largest swing { $swing }
least-places-taken = { $places_taken } of at least { $seats_least } places are taken.
leave-bar-where = Leave the bar in its position.
leave-session-unused-points-kept = Cancel this session? Points that were not used yet are kept.
left = to the left
length = length { $longer }
limit-is = The limit is { $limit }.
limit-number-micrometres-1-100-000 = The limit must be 1 to 100 000 micrometres.
limit-of-figure = limit { $limit }
look-change = Inspect the tip, and replace it.
low-down = low
mount-tip-of-datasheet-or-give-diameter = Mount the tip of the datasheet, or enter the diameter of this sphere.
n-2-worst-axis = 2σ is { $two_sigma } on the worst axis; the encoders' noise alone gives { $encoders }.
near-base = near the base
no-coordinates-taken-yet = no coordinates were taken yet
no-limit-set = no limit is set
no-limit-set-so-check-neither = No limit is set, so this check is undecided.
no-seat-taken-yet = No place has been measured yet.
places = { $done } of { $seats_wanted } places
places-done = { $done } places
places-were-held-out-fit-over = At places that were left out of the fit, and over the arm's whole reach.
point = Point { $number }, { $place }.
points-taken = { $taken } points
points-taken-themselves-while-arm-swings = Points are taken automatically while the arm swings.
put-arm-back = Restore the previous arm
put-back-end-swing = Put it back into the seat, or finish the swing.
put-tip-into-bars-other-end = Put the tip into the bar's other end
put-tip-into-end-ball-bar = Put the tip into an end of the ball bar
put-tip-into-seat = Put the tip into the seat
put-tip-into-seat-of-number = Put the tip into seat { $done }
right = to the right
screw-home-check-again-change-if = Tighten it and check again; replace it if the error persists.
screw-tip-home-clamp-sphere-check = Tighten the tip, clamp the sphere, and check again.
seat-tip = Seat the tip
seats-were-taken-another-arm = The seats were measured with another arm.
session-closed-start-new-one = This session is closed. Start a new one.
set-arms-specification-limit-where-next = Set the arm's specification as the limit at the start of the next check.
simulation-goes = The simulated operator moves to { $name }
simulation-swings-arm-about = The simulated operator swings the arm about { $name }
simulation-touches-sphere = The simulated operator touches the sphere
sphere-clamped = The sphere is clamped
sphere-known-diameter-clamped-firmly-within = A sphere of known diameter, clamped firmly within easy reach.
standard-uncertainty-0-mm = The standard uncertainty must be 0 to { $largest }.
swing-arm = Swing the arm
swing-arm-about = Swing the arm about { $place }
swing-further-least = Swing further: { $swing } of at least { $least_swing_deg }.
take-again = Repeat
take-bars-other-end-first-drop = Measure the other end of the bar first, or discard the last place.
take-one-place-two-if-there = Measure a ball bar in one or two places, if you have one.
there-dirt-tip-sphere = The tip measures { $diameter }, but the arm's datasheet states { $expected }: there is dirt on the tip or on the sphere.
there-no-such-arm = There is no such arm.
there-no-such-artefact-here = There is no such artefact here.
tip-bars-end = The tip is in the bar's end
tip-known = Tip uncertainty
tip-points-off-sphere-of-others =
    { $count ->
        [one] Point { $points } is { $scatter } off the sphere of the others.
       *[other] Points { $points } are up to { $scatter } off the sphere of the others.
    }
tip-seat = The tip is in the seat
tip-seat-no-points-taken-there = The tip is { $left } away from the seat; no points are taken there.
tip-sits-off-its-place = The tip is { $off } away from its position in the datasheet: the stylus is bent or not tight.
tip-sound-diameter-off-touches-agree = The tip is in order: its diameter deviates by { $off }, and its contact points agree to { $scatter }.
tip-sphere-diameter-arm = of the tip from a sphere of that diameter, with the present arm model
tip-uncertainty-before =
    { $size_known ->
        [yes] was { $before }; k = 1, rms over the reach
       *[no] was { $before }; k = 1, rms over the reach; without the arm's scale
    }
tips-diameter = The tip's diameter
tips-diameter-how-well-touches-agree = The tip's diameter, and the agreement of its contact points.
tips-diameter-off-known-only-k = The tip's diameter deviates by { $off }; its expanded uncertainty of { $known } (k = 2) is too large to prove that the limit is kept.
top-all-around-side-wrist-turned = Touch its top and all around its side, with the wrist turned differently each time. Hold still and press the arm's button at each point.
touch = Touch it
touch-all-over-upper-half-every = Touch it all over its upper half, from every side, with the arm in many postures. Hold still and press the arm's button at each point.
touch-more-least-points = Touch more points: { $taken } of at least { $least }.
touch-place = Touch { $place }
touch-sphere = Touch the sphere
touch-sphere-more-spread-over-all = Touch more points on the sphere, spread over its whole upper half.
touches-disagree-up-tip-sphere-loose = The contact points disagree by up to { $scatter }: the tip or the sphere is loose, or the arm slipped.
use = In use
use-arm-before-what-identified-kept = Use the previous arm again? The identification is kept in this session.
use-arm-now = Use this arm from now on
what-tip-moved-while-held-one = How far the tip moved while it was held in one place.
within-limit-m = { $half_range }, within the limit of { $limit }.
without-ball-bar-arm-keeps-size = Without a ball bar the arm keeps the scale of its datasheet.
worn-has-flat = The tip measures { $diameter }, but the arm's datasheet states { $expected }: it is worn, or has a flat.

length-standard-rocks =
    { $of ->
        [places] the standard rocks in place { $place }: repeats of a length scatter by { $scatter }, in steady places by up to { $expected }
       *[touches] the standard rocks in place { $place }: repeats of a length scatter by { $scatter }, touches by { $expected }
    }
lengths-are-missing = only { $count } of { $wanted } lengths were measured: each in { $places } places, { $repeats } times
no-lengths-measured = no length was measured
performance-bar-run = Place { $place }, scan { $repeat } of the bar
performance-bar-scan = Scan { $repeat }
performance-bar-scan-done = Scan { $repeat } of the bar in place { $place } is accepted.
performance-bar-scan-name = Performance test, place { $place }, scan { $repeat }
performance-bar-scan-of-length = Scan { $repeat }, the spheres of { $length }
performance-bar-was-moved = The bar was touched in another place since: the scans of the place before stand.
performance-fewer-lengths =
    { $count ->
        [one] the standard has only one length, and the procedure takes five
       *[other] the standard has only { $count } lengths, and the procedure takes five
    }
performance-length-gate = Gate of the scans: { $shell } about the calibrated spheres, incidence up to { $incidence }, beyond { $cone } from the direction of the bar; all points within it count.
performance-lengths-and-scans = { $done } of { $of } lengths touched, { $scanned } of { $scans } scans
performance-lengths-done = All lengths are measured. Continue to the result.
performance-lengths-measured = { $done } of { $of } lengths
performance-measuring-bar-scan = Evaluating the scan of the bar: { $scan }
performance-nothing-decided-standard-rocks = Nothing can be decided by lengths of a standard that rocks. Fix it and repeat the test.
performance-off-direction = The standard lies { $angle } off the drawn direction.
performance-pass-over-spheres = Move the stripe slowly over every sphere of the bar, from sides across the bar, then end the scan.
performance-place =
    { $number ->
        [1] horizontal, away from the arm
        [2] horizontal, across, near on the left
        [3] horizontal, across, far on the right
        [4] vertical
        [5] inclined by 45°, across, on the left
        [6] inclined by 45°, away from the arm, on the right
       *[other] diagonal through the volume
    }
performance-place-title = Place { $number } of 7
performance-scan-bar = Leave the standard as it is and scan the whole bar, { $repeat } of { $of }: all its spheres, from sides across the bar.
performance-scan-bar-again = Scan the bar again, slowly over every sphere
performance-scan-length-alone = Two pairs of spheres are { $length } apart. Leave the standard as it is and scan only the two spheres of this length.
performance-set-standard-up = Set the standard up as drawn: { $place }. Fix it. { $text }
performance-simulation-scans-bar = The simulated operator scans the bar in place { $place }, scan { $repeat }
performance-step-lengths = Lengths
performance-touch-bar-first = Touch all lengths of this place first.
performance-touch-length =
    Length { $length }, repeat { $repeat } of { $of }: { $kind ->
        [face] touch { $end ->
            [1] the first face
           *[other] the second face
        }. Touch both in the same direction and at the same height and side.
       *[sphere] touch { $end ->
            [1] the first sphere
           *[other] the second sphere
        } in { $touches } places all around.
    }
performance-turn-standard = The seven places only cover the arm's volume if the standard lies about as drawn.
scan-has-length-twice = more than one pair of spheres in the scan is { $length } apart; scan the two spheres of this length by themselves
scan-shows-little-of-sphere = the scan shows too little of a sphere at an end of { $length }: at least { $points } points of { $frames } pictures are needed, on a cap of 25° or more in every direction
scan-without-length =
    { $count ->
        [one] the scan shows one sphere instead of two that are { $length } apart
       *[other] of the { $count } spheres in the scan, no two are { $length } apart
    }

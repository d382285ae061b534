at-least-limit = ≥ { $limit }
brightness = Brightness
come-nearer-object-fills-wanted = Move closer: the object fills { $fills }, at least { $least } required
distance = Distance
distance-out-of-range =
    { $side ->
        [near] Too near: { $distance }, { $low } to { $high } required
       *[far] Too far: { $distance }, { $low } to { $high } required
    }
edge-width = Edge width
finding-what-and-why = { CAPITAL(CLAUSE($what)) }: { CLAUSE($why) }
go-further-away-object-does-fit = Move further away: the object does not fit into the picture
hold-still = Hold still
line-brightness = Line brightness
line-saturated = Line saturated
line-too-bright-saturated = Line too bright: { $clipped } saturated
line-too-dark = Line too dark: { $level }
nothing-seen-no-contrast = Nothing visible: no contrast
object-fills = Object fills
object-too-far =
    { $side ->
        [left] The object is too far to the left
        [right] The object is too far to the right
        [up] The object is too high in the picture
       *[down] The object is too low in the picture
    }
out-focus-edges-wide-wanted = Out of focus: the edges are { $width } wide, at most { $wanted } allowed
saturated = Saturated
search-object-failed = The detection of the object failed
switch-one-laser-off-or-mask-its-place = Switch one laser off, or mask where its line lies
too-bright-saturated = Too bright: { $share } saturated
too-dark-brightest-parts = Too dark: brightest parts at { $level }

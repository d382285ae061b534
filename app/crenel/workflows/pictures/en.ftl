channel-beyond-others = { $colour } beyond the other channels
channel-less-laser-off = { $channel }, less the picture with the laser off
channel-mean-of-all = mean of all channels
dark-brightest-pixel = it is dark: its brightest pixel is at { $brightest } of { $full } grey levels
draw-pictures-of-each-folder-apart = Draw the pictures of each folder apart
give-axis = Give --axis { $axis }
give-each-pose-its-own-picture = Give each row of images.csv its own picture
give-times-in-seconds-readings-closer = Give all times in seconds, and readings of the arm at most { $longest } apart
import-with-stripe-axis = Set stripe_axis to { $axis } in sensor.json, and import again
laser-on-or-expose-longer = Switch on the laser, or expose longer
line-along-other-axis =
    { $axis ->
        [u] a line of { $points } points runs down it
       *[v] a line of { $points } points runs across it
    }
line-as-bright-as-clutter = no line: other things in its columns are as bright
line-as-bright-as-picture = no line: the picture is as bright
line-bright-in-the-dark = a line: it is bright in the dark
line-crosses-most-of-picture = a line: it crosses most of the picture
line-hardly-rivalled = a line: hardly anything else is in the picture
line-in-nearly-all-columns = a line: it is in nearly all columns
line-outshines-picture = a line: it outshines the picture
line-stands-alone = a line: it stands nearly alone
line-without-points = no line: no peaks go on from column to column
no-bright-line-runs =
    { $axis ->
        [u] no bright line runs across the picture
       *[v] no bright line runs down the picture
    }
no-picture-between-readings = no picture of { $path } lies between two readings of { $readings } that are close together
no-picture-of-folder-can-be-used = none of the { $count } pictures can be used; the first: { $first }
no-picture-of-folder-has-a-line = none of the { $count } pictures shows a line; the first: { $first }
overexposed-share-at-full-scale = it is overexposed: { $share } of its pixels are at full scale
piece-left-beneath-line = left: goes on beneath the line
piece-left-dim-as-clutter = left: as dim as the clutter
piece-left-without-line = left: there is no line
piece-taken-brighter-than-clutter = taken: brighter than the clutter
piece-taken-line-goes-on = taken: the line goes on in it
piece-taken-most-light = taken: most of the light
readings-are-apart-nothing-between = the readings are { $period } apart on average; nothing is interpolated over more than { $longest }
same-picture-as-before = { $name } is the picture before it again
shorten-exposure-or-darken-room = Shorten the exposure, or darken the surroundings
shows-no-stripe = { $path } shows no laser stripe
shows-no-stripe-outside-mask = { $path } shows no laser stripe outside the mask
take-with-laser-or-describe-line = Take the picture with the laser on and the exposure set, or say what the line is like (--threshold, --min-width, --max-width): other things in the picture stand out as much
two-lines-in-pictures = two laser lines are in { $two } of { $of } pictures, and the points may jump between them. Switch one laser off, mask it (--mask), or take one of them in every column (--choice first or last)
two-pictures-named = two pictures are named { $name }, and would be one file in { $folder }

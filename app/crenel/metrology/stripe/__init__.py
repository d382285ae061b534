"""The laser stripe in an image: its sub-pixel centre, and the uncertainty of each point.

``extract_stripe`` finds it in one image, ``StripeTracker`` follows it from frame to frame. The
computation is in C (``app/crenel/native/c/stripe``), one call per frame, in this order:

1. ``search.c``: scores of all places, in one pass over the image; the best of each strip.
2. ``read_noise.c``: the variance of a dark pixel.
3. ``peaks.c``: all peaks that exceed that noise.
4. ``choice.c``: one peak per column, by the tracks on which peaks lie.
5. ``profiles.c``: the pixels around each peak, 64 columns in parallel.
6. ``start.c``: the start of each fit, and its pixels.
7. ``normal.c``: the normal equations of a Gaussian on a background, weighted by the noise.
8. ``fit.c``: the fit, by Gauss-Newton.
9. ``noise.c``: growth of the noise with the signal, from some of the peaks, before all are fitted.
10. ``sift.c``: peaks with the width and height of a stripe.
11. ``runs.c``: sufficiently long pieces.
12. ``speckle.c``: scatter of their points beyond the noise of the pixels.
13. ``line.c``: pieces that are the line, not clutter or a reflection.
14. ``evidence.c``: whether that is a line at all.

All this happens at one scale. ``find_stripe`` tries others where the image itself does not show one
long narrow line: several rows made one (``reduce.c``, ``scales.py``) for wide and speckled lines,
rows between the rows for lines of a pixel. ``bands.py`` looks beside bright bands with sharp edges.

``pipeline.c`` reads top to bottom. If the core of the line is clipped (``clipped.h``), or
flat below full scale (``plateau.c``), only its flanks show its position:

1. ``clipped_runs.c``: the runs of clipped pixels in every column.
2. ``cores.c``: those that are the line's core.
3. ``flanks.c``: the pixels next to the core, 16 columns in parallel.
4. ``flank_step.c``: one step of the fit of both flanks, with a shape that all columns share.
5. ``flank_noise.c``: the noise of the pixels, from the residuals of the fit.
6. ``flank_fit.c``: the iterations of the fit. ``halo.c``: what an uneven halo adds to it.
7. ``smooth.c``: the line smoothed along itself over its core's width.
8. ``join.c``: inserts its points among those of the other columns, with their deviations.

``laser_alone.py`` takes the light of a lit room off, where there is a picture without the laser,
too.

``smoothing`` smooths the points along the line if the operator chooses so.
"""

from crenel.metrology.stripe.extraction import extract_stripe, find_stripe
from crenel.metrology.stripe.found_line import FoundLine
from crenel.metrology.stripe.laser_alone import (
    LaserAlone,
    picture_with_line,
    take_off_room_light,
)
from crenel.metrology.stripe.line_bounds import LineBounds
from crenel.metrology.stripe.line_evidence import LineEvidence, LineReason, PieceReason
from crenel.metrology.stripe.line_search import ANYWHERE, LineSearch
from crenel.metrology.stripe.points import (
    Stripe,
    concatenate_stripes,
    empty_stripe,
    usual_steepness,
)
from crenel.metrology.stripe.second_line import ONE_OF_TWO, has_second_line, shows_two_lasers
from crenel.metrology.stripe.settings import (
    AUTOMATIC,
    MOST_SMOOTHING_PX,
    PeakChoice,
    StripeSettings,
    check_settings,
)
from crenel.metrology.stripe.smoothing import HALF_HEIGHT_PERIOD, number_sharing_noise
from crenel.metrology.stripe.tracking import StripeTracker

__all__ = [
    "ANYWHERE",
    "AUTOMATIC",
    "HALF_HEIGHT_PERIOD",
    "MOST_SMOOTHING_PX",
    "ONE_OF_TWO",
    "FoundLine",
    "LaserAlone",
    "LineBounds",
    "LineEvidence",
    "LineReason",
    "LineSearch",
    "PeakChoice",
    "PieceReason",
    "Stripe",
    "StripeSettings",
    "StripeTracker",
    "check_settings",
    "concatenate_stripes",
    "empty_stripe",
    "extract_stripe",
    "find_stripe",
    "has_second_line",
    "number_sharing_noise",
    "picture_with_line",
    "shows_two_lasers",
    "take_off_room_light",
    "usual_steepness",
]

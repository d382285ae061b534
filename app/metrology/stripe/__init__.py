"""The laser stripe in an image: its centre below a pixel, and how far to trust it.

``extract_stripe`` finds it in one image, ``StripeTracker`` follows it from frame to frame. The
work is done in C (``app/native/c/stripe``), one call a frame, in this order:

1. ``search.c``: scores of all places, in one reading of the image; the best of each strip.
2. ``read_noise.c``: the variance of a dark pixel.
3. ``peaks.c``: all peaks that stand out of that noise.
4. ``choice.c``: one peak a column, by the tracks that peaks lie on.
5. ``profiles.c``: the pixels about each peak, 64 columns side by side.
6. ``start.c``: where each fit starts, and the pixels that it takes.
7. ``normal.c``: the normal equations of a Gaussian on a background, weighted by the noise.
8. ``fit.c``: the fit, by Gauss-Newton.
9. ``noise.c``: how the noise grows with the signal, from some of the peaks, before all are fitted.
10. ``sift.c``: peaks as wide and high as a stripe.
11. ``runs.c``: pieces that are long enough.
12. ``speckle.c``: what their points scatter by beyond the noise of the pixels.

``pipeline.c`` reads top to bottom. Where the line's core is clipped (``clipped.h``), only its
flanks show where it lies:

1. ``clipped_runs.c``: the runs of clipped pixels in every column.
2. ``cores.c``: those that are the line's core.
3. ``flanks.c``: the pixels beside the core, 16 columns side by side.
4. ``flank_step.c``: one step of the fit of both flanks, by a shape that all columns share.
5. ``flank_noise.c``: the noise of the pixels, by what the fit leaves of them.
6. ``flank_fit.c``: the rounds of the fit.
7. ``smooth.c``: the line smoothed along itself over its core's width.
8. ``join.c``: its points among those of the other columns, with their deviations.
"""

from app.metrology.stripe.extraction import extract_stripe
from app.metrology.stripe.points import Stripe, concatenate_stripes, empty_stripe
from app.metrology.stripe.settings import AUTOMATIC, PeakChoice, StripeSettings
from app.metrology.stripe.tracking import StripeTracker

__all__ = [
    "AUTOMATIC",
    "PeakChoice",
    "Stripe",
    "StripeSettings",
    "StripeTracker",
    "concatenate_stripes",
    "empty_stripe",
    "extract_stripe",
]

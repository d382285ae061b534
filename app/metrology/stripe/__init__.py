"""The laser stripe in an image: its centre below a pixel, and how far to trust it.

``extract_stripe`` finds it in one image, ``StripeTracker`` follows it from frame to frame. The
work is done in C (``app/native/c/stripe``), one call a frame, in this order:

1. ``search.c``: scores of all places, in one reading of the image; the best of each strip.
2. ``read_noise.c``: the variance of a dark pixel.
3. ``peaks.c``: all peaks that stand out of that noise.
4. ``choice.c``: one peak a column, by the tracks that peaks lie on.
5. ``profiles.c``, ``start.c``: the pixels about each peak, 64 columns side by side.
6. ``noise.c``: how the noise grows with the signal, by some of the peaks.
7. ``normal.c``, ``fit.c``: a Gaussian on a background, weighted by the noise.
8. ``sift.c``: peaks as wide and high as a stripe.
9. ``runs.c``, ``speckle.c``: pieces that are long enough, and what they scatter by.

``pipeline.c`` reads top to bottom. Where the line's core is clipped (``clipped.h``), only its
flanks tell where it lies:

1. ``clipped_runs.c``, ``cores.c``: the clipped pixels that are the line's core.
2. ``flanks.c``: the pixels beside the core, 16 columns side by side.
3. ``flank_step.c``, ``flank_noise.c``, ``flank_fit.c``: the middle of both flanks of every column,
   by a shape and a noise that all columns share.
4. ``smooth.c``: the line smoothed along itself over its core's width.
5. ``join.c``: its points among those of the other columns, with their deviations.
"""

from app.metrology.stripe.extraction import extract_stripe
from app.metrology.stripe.points import Stripe, empty_stripe, joined_stripes
from app.metrology.stripe.settings import AUTOMATIC, Choice, StripeSettings
from app.metrology.stripe.tracking import StripeTracker

__all__ = [
    "AUTOMATIC",
    "Choice",
    "Stripe",
    "StripeSettings",
    "StripeTracker",
    "empty_stripe",
    "extract_stripe",
    "joined_stripes",
]

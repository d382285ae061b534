"""Following the stripe from frame to frame, reading only where it can be."""

import numpy as np
from numpy.typing import NDArray

from app.metrology.image import Image
from app.metrology.stripe.extraction import extract_parts, orient_image, orient_mask
from app.metrology.stripe.points import Stripe
from app.metrology.stripe.settings import AUTOMATIC, StripeSettings
from app.native.arguments import BOOL, F64, I64, Array, Function, Integer
from app.native.library import CRENEL

BLOCK_PX = 256
"""Columns that are read over the same rows, as in ``tracking.c``."""
MARGIN_PX = 24
"""Rows that the stripe may move by from one frame to the next."""
LOST_POINTS = 16
"""A block has lost the stripe where it shows so many points fewer than in the frame before."""
NOISE_FRAMES = 8
"""Frames after which the noise and the usual width are estimated again."""

_plan_parts = Function(
    CRENEL,
    "plan_parts",
    Array(F64, "n"),
    Array(F64, "n"),
    Array(BOOL, "blocks"),
    Integer(),
    Integer(),
    Integer(),
    Integer(),
    Array(I64, "most", 4, written=True),
    returns=int,
)
_count_in_blocks = Function(
    CRENEL, "count_in_blocks", Array(F64, "n"), Array(I64, "blocks", written=True)
)


class StripeTracker:
    """Extracts the stripe of frames that follow one another; one thread at a time.

    Every block of columns is read about the rows where the stripe was in the frame before.
    A block that loses the stripe is read over its whole height at once, in the same frame.
    One slice of the image after the other is read, too, so that what comes into view
    elsewhere is found after as many frames as there are slices. The noise, by which
    points are weighed and their deviations stated, is estimated again every few frames.
    """

    def __init__(
        self,
        axis: str = "u",
        where: NDArray[np.bool_] | None = None,
        settings: StripeSettings = AUTOMATIC,
        margin_px: int = MARGIN_PX,
    ) -> None:
        """Begins without knowing where the stripe is.

        Args:
            axis, where, settings: see ``extract_stripe``.
            margin_px: how far the stripe may move from one frame to the next.
        """
        self._axis = axis
        self._where = where
        self._settings = settings
        self._margin_px = margin_px
        self._allowed: NDArray[np.bool_] | None = None
        self._shape = (0, 0)
        self._counts = np.zeros(0, dtype=np.int64)
        self._along = self._across = np.zeros(0)
        self._turn = 0
        self._known = np.zeros(4, dtype=np.float32)

    def extract(self, image: Image) -> Stripe:
        """The stripe of the next frame; see ``extract_stripe`` for what is returned and raised."""
        grey = orient_image(image, self._axis)
        if grey.shape != self._shape:
            self._allowed = orient_mask(self._where, grey, self._axis)
            self._shape = (grey.shape[0], grey.shape[1])
            self._counts = np.zeros(-(-grey.shape[1] // BLOCK_PX), dtype=np.int64)
            self._along = self._across = np.zeros(0)
        whole = np.zeros(len(self._counts), dtype=np.bool_)
        if self._turn % NOISE_FRAMES == 0:
            self._known[:] = 0
        self._turn += 1
        before = self._counts
        parts = self._parts(whole)
        stripe = self._extract(parts, grey)
        lost = self._counts < before - LOST_POINTS
        if len(parts) > 1 and (lost.any() or not len(self._along)):
            whole |= lost if len(self._along) else True
            self._known[:] = 0
            parts = self._parts(whole)
            stripe = self._extract(parts, grey)
        return stripe

    def _parts(self, whole: NDArray[np.bool_]) -> NDArray[np.int64]:
        """The parts (n, 4) of the image to read; all of it where that is no slower."""
        parts = np.empty((len(whole) + 1, 4), dtype=np.int64)
        count = _plan_parts(
            self._along, self._across, whole, *self._shape, self._margin_px, self._turn, parts
        )
        return parts[:count]

    def _extract(self, parts: NDArray[np.int64], grey: Image) -> Stripe:
        """The stripe in these parts; remembers where it is."""
        stripe = extract_parts(grey, self._axis, parts, self._allowed, self._settings, self._known)
        self._along, self._across = stripe.along_across
        self._counts = np.empty_like(self._counts)
        _count_in_blocks(self._along, self._counts)
        return stripe

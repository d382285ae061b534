"""Tracks the stripe from frame to frame, reading only where it can be."""

import math

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.image import Image
from crenel.metrology.stripe.bands import is_wide
from crenel.metrology.stripe.extraction import (
    extract_whole,
    orient_image,
    orient_mask,
    smooth_as_set,
    without_bands,
)
from crenel.metrology.stripe.found_line import FoundLine
from crenel.metrology.stripe.line_bounds import LineBounds
from crenel.metrology.stripe.one_scale import extract_parts
from crenel.metrology.stripe.points import Stripe
from crenel.metrology.stripe.scales import FULL, follow_scale, height_at, reduce_mask, rows_at
from crenel.metrology.stripe.settings import AUTOMATIC, StripeSettings
from crenel.native.arguments import BOOL, F64, I64, Array, Function, Integer
from crenel.native.library import CRENEL

BLOCK_PX = 256
"""Number of columns that are read over the same rows, as in ``tracking.c``."""
MARGIN_PX = 24
"""Number of rows by which the stripe may move from one frame to the next."""
LOST_POINTS = 16
"""A block has lost the stripe if it shows this many fewer points than in the previous frame."""
NOISE_FRAMES = 8
"""Number of frames after which the noise, the usual width and the scale are estimated again."""
BAND_FRAMES = 64
"""Number of frames after which a wide line is compared with what else is in the image again."""

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
    """Extracts the stripe of consecutive frames; for one thread at a time.

    Every block of columns is read around the rows of the stripe in the previous frame. A block that
    loses the stripe is read over its full height at once, in the same frame. In every sixth frame
    the complete image is read, so that a stripe that appears elsewhere is found. The noise, which
    determines the weights and standard deviations of points, is estimated again every few frames;
    so is the scale if no long line is found.
    """

    def __init__(
        self,
        axis: str = "u",
        where: NDArray[np.bool_] | None = None,
        settings: StripeSettings = AUTOMATIC,
        margin_px: int = MARGIN_PX,
        bounds: LineBounds | None = None,
    ) -> None:
        """Starts without knowledge of the stripe's position.

        Args:
            axis, where, settings, bounds: as in ``extract_stripe``.
            margin_px: maximum motion of the stripe from one frame to the next.
        """
        self._axis = axis
        self._where = where
        self._settings = settings
        self._margin_px = margin_px
        self._stated, self._bounds = bounds, bounds
        self._allowed: NDArray[np.bool_] | None = None
        self._reduced: NDArray[np.bool_] | None = None
        self._shape = (0, 0)
        self._counts = np.zeros(0, dtype=np.int64)
        self._along = self._across = np.zeros(0)
        self._turn = 0
        self._known = np.zeros(4, dtype=np.float32)
        self._scale = FULL

    def extract(self, image: Image) -> Stripe:
        """The stripe of the next frame; results and errors are those of ``extract_stripe``."""
        grey = orient_image(image, self._axis)
        if grey.shape != self._shape:
            self._allowed = orient_mask(self._where, grey, self._axis)
            self._shape = (grey.shape[0], grey.shape[1])
            fits = self._stated is not None and self._stated.fits(grey.shape, self._axis)
            self._bounds = self._stated if fits else None
            self._counts = np.zeros(-(-grey.shape[1] // BLOCK_PX), dtype=np.int64)
            self._forget()
        whole = np.zeros(len(self._counts), dtype=np.bool_)
        is_first, is_turn = self._turn == 0, self._turn % NOISE_FRAMES == 0
        may_be_band = self._turn % BAND_FRAMES == 0
        if is_turn:
            self._known[:] = 0
        self._turn += 1
        before, across = self._counts, self._across
        parts = self._parts(whole)
        found = self._extract(parts, grey)
        lost = self._counts < before - LOST_POINTS
        if not self._is_whole(parts) and (lost.any() or not len(self._along)):
            whole |= lost if len(self._along) else True
            self._known[:] = 0
            found = self._extract(self._parts(whole), grey)
        if is_turn and not (found.is_certain if is_first else found.is_long):
            found = self._try_scales(grey, found)
        elif is_wide(found) and (may_be_band or self._lies_elsewhere(across)):
            beside = without_bands(grey, found, self._allowed, self._settings, self._bounds)
            found = self._take(beside, found)
        return smooth_as_set(found, self._settings)

    def _try_scales(self, grey: Image, found: FoundLine) -> FoundLine:
        """What the image shows at the best scale, which is kept for the frames to come."""
        whole = found if found.factor == 1 else None
        best = extract_whole(grey, self._axis, self._allowed, self._settings, whole, self._bounds)
        is_same = best.factor == found.factor != 1
        return found if is_same else self._take(best, found)

    def _lies_elsewhere(self, before: NDArray[np.float64]) -> bool:
        """Whether the stripe lies elsewhere than at its places across in the image before."""
        if not len(before) or not len(self._across):
            return False
        return abs(float(self._across.mean() - before.mean())) > self._margin_px

    def _take(self, best: FoundLine, found: FoundLine) -> FoundLine:
        """The better line, which is followed from now on; what was found if that has no points."""
        if best is found or not len(best.stripe.u):
            return found
        self._scale = best.scale
        self._reduced = reduce_mask(self._allowed, best.factor)
        self._known[:] = 0
        self._remember(best)
        return best

    def _parts(self, whole: NDArray[np.bool_]) -> NDArray[np.int64]:
        """The parts (n, 4) of the image to read; all that may show the line if that is not
        slower."""
        factor, (rows, columns) = self._scale.factor, self._shape
        parts = np.empty((len(whole) + 1, 4), dtype=np.int64)
        count = _plan_parts(
            self._along,
            rows_at(self._across, factor),
            whole,
            height_at(rows, factor),
            columns,
            math.ceil(self._margin_px / factor),
            self._turn,
            parts,
        )
        if self._bounds is None:
            return parts[:count]
        return self._bounds.clip(parts[:count], factor)

    def _is_whole(self, parts: NDArray[np.int64]) -> bool:
        """Whether the parts (n, 4) are all that may show the line."""
        if self._bounds is not None:
            return np.array_equal(parts, self._bounds.parts(self._scale.factor))
        first, last = parts[0, :2]
        return len(parts) == 1 and last - first == height_at(self._shape[0], self._scale.factor)

    def _extract(self, parts: NDArray[np.int64], grey: Image) -> FoundLine:
        """The stripe in these parts; stores its position."""
        scale = follow_scale(self._scale, grey, parts)
        if scale != self._scale:
            self._known[:] = 0  # the noise was in other levels
            self._scale = scale
        found = extract_parts(
            grey, self._axis, parts, self._reduced, self._settings, self._known, scale
        )
        self._remember(found)
        return found

    def _remember(self, found: FoundLine) -> None:
        """Stores where the stripe lies."""
        self._along, self._across = found.stripe.along_across
        self._counts = np.empty_like(self._counts)
        _count_in_blocks(self._along, self._counts)

    def _forget(self) -> None:
        """Forgets the stripe, for images of another size."""
        self._along = self._across = np.zeros(0)
        self._scale, self._reduced = FULL, self._allowed
        self._turn = 0

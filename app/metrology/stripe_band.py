"""Following the stripe from frame to frame, reading only where it can be."""

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import kernel
from app.metrology.frames import Floats
from app.metrology.stripe import (
    AUTOMATIC,
    Stripe,
    StripeSettings,
    as_grey,
    as_seen,
    extract_from,
)
from app.metrology.stripe_flanks import Image
from app.metrology.stripe_search import LEAST_ROWS

# Columns that are read over the same rows, and their neighbours whose points count, too.
BLOCK, BESIDE = 256, 24
# Rows that the stripe may move by from one frame to the next.
MARGIN = 24
# A block has lost the stripe where it shows so many points less than in the frame before.
LOST = 16
# Beginning a row costs as much as reading so many of its pixels.
ROW_PX = 2000
# Slices of the image, one of which is read in every frame beside the bands.
SLICES = 6
# Frames after which the noise and the usual width are told anew.
NOISE_TOLD = 8
# The surroundings that a peak's score needs.
SURROUNDINGS = LEAST_ROWS // 2 + 4


class StripeBand:
    """Extracts the stripe of frames that follow one another; one thread at a time.

    Every block of columns is read about the rows where the stripe was in the frame before.
    A block that loses the stripe is read over its whole height at once, in the same frame.
    One slice of the image after the other is read, too, so that what comes into view
    elsewhere is found after as many frames as there are slices. The noise, by which
    points are weighed and their deviations stated, is told anew every few frames.
    """

    def __init__(
        self,
        axis: str = "u",
        where: NDArray[np.bool_] | None = None,
        settings: StripeSettings = AUTOMATIC,
        margin_px: int = MARGIN,
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
        self._shape = (0, 0)
        self._counts = np.zeros(0, dtype=np.int64)
        self._along = self._across = np.zeros(0)
        self._turn = 0
        self._told = np.zeros(4, dtype=np.float32)

    def extract(self, image: Image) -> Stripe:
        """The stripe of the next frame; see ``extract_stripe`` for what is returned and raised."""
        grey = as_grey(image, self._axis)
        where = as_seen(self._where, grey, self._axis)
        if grey.shape != self._shape:
            self._shape = (grey.shape[0], grey.shape[1])
            self._counts = np.zeros(-(-grey.shape[1] // BLOCK), dtype=np.int64)
            self._along = self._across = np.zeros(0)
        whole = np.zeros(len(self._counts), dtype=np.bool_)
        if self._turn % NOISE_TOLD == 0:
            self._told[:] = 0
        self._turn += 1
        before = self._counts
        parts = self._parts(whole)
        stripe = self._in(parts, grey, where)
        lost = self._counts < before - LOST
        if len(parts) > 1 and (lost.any() or not len(self._along)):
            whole |= lost if len(self._along) else True
            self._told[:] = 0
            parts = self._parts(whole)
            stripe = self._in(parts, grey, where)
        return stripe

    def _parts(self, whole: NDArray[np.bool_]) -> NDArray[np.int64]:
        """The parts of the image to read; all of it where that is no slower."""
        height, width = self._shape
        parts = bands(self._along, self._across, height, width, self._margin_px, whole)
        first = self._turn % SLICES * height // SLICES - SURROUNDINGS
        last = first + height // SLICES + 2 * SURROUNDINGS + 1
        parts = np.vstack([parts, [max(first, 0), min(last, height), 0, width]])
        spent = sum(cost(last - first, right - left) for first, last, left, right in parts.tolist())
        if not len(self._along) or spent >= cost(height, width):
            return np.array([[0, height, 0, width]])
        return parts

    def _in(self, parts: NDArray[np.int64], grey: Image, where: NDArray[np.bool_]) -> Stripe:
        """The stripe in these parts; remembers where it is."""
        stripe = extract_from(grey, self._axis, parts, where, self._settings, self._told)
        self._along, self._across = stripe.along_across
        self._counts = points_of_blocks(self._along, len(self._counts))
        return stripe


@kernel
def points_of_blocks(along: Floats, blocks: int) -> NDArray[np.int64]:
    """(blocks,) how many points lie in each block."""
    counts = np.zeros(blocks, np.int64)
    for column in along:
        counts[int(column) // BLOCK] += 1
    return counts


@kernel
def bands(
    along: Floats,
    across: Floats,
    height: int,
    width: int,
    margin: int,
    whole: NDArray[np.bool_],
) -> NDArray[np.int64]:
    """(n, 4) first row and the one behind the last, columns alike, of the parts to read.

    Neighbouring blocks are one part where that is faster.

    Args:
        along, across: (N,) where the stripe was.
        whole: (blocks,) which are read over their whole height.
    """
    blocks = len(whole)
    lowest, highest = np.full(blocks, np.inf), np.full(blocks, -np.inf)
    for p in range(len(along)):
        column = int(along[p])
        first, last = max(column - BESIDE, 0) // BLOCK, min(column + BESIDE, width - 1) // BLOCK
        for b in range(first, last + 1):
            lowest[b], highest[b] = min(lowest[b], across[p]), max(highest[b], across[p])
    parts = np.empty((blocks, 4), np.int64)
    found = 0
    for b in range(blocks):
        if not whole[b] and lowest[b] > highest[b]:
            continue
        first, last = 0, height
        if not whole[b]:
            reach = margin + SURROUNDINGS
            first = max(int(lowest[b]) - reach, 0)
            last = min(int(highest[b]) + reach + 1, height)
        left, right = b * BLOCK, min((b + 1) * BLOCK, width)
        if found and parts[found - 1, 3] == left:
            before = parts[found - 1]
            upper, lower = min(before[0], first), max(before[1], last)
            apart = cost(before[1] - before[0], left - before[2]) + cost(last - first, right - left)
            if cost(lower - upper, right - before[2]) <= apart:
                before[0], before[1], before[3] = upper, lower, right
                continue
        parts[found, 0], parts[found, 1] = first, last
        parts[found, 2], parts[found, 3] = left, right
        found += 1
    return parts[:found]


@kernel
def cost(rows: int, columns: int) -> int:
    """What reading a part of the image costs, in pixels."""
    return rows * (ROW_PX + columns)

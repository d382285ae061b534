"""The peaks of an image's columns, from the scores that the search left."""

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import vector_kernel
from app.metrology.grey_lanes import (
    GREYS,
    Grey,
    Greys,
    all_greys,
    bits,
    first_bit,
    load_greys,
    over,
    plus,
)
from app.metrology.stripe_search import STEP, STRIP

# Peaks in neighbouring strips are two peaks where so many cores lie between them.
APART = 6


@vector_kernel
def peaks_of(
    scores: Grey, places: NDArray[np.uint8], here: np.uintp, strip: np.uintp, least: Greys
) -> np.uint64:
    """Which of the sixty-four columns from ``here`` on hold a peak, as bits.

    A peak is over ``least``, and no flank of a higher one in a neighbouring strip.

    Args:
        scores, places: one strip after the other, each as long as ``strip``.
    """
    own = load_greys(scores, here)
    high = bits(over(own, least))
    if high == 0:
        return high
    # where a cell is empty its place says nothing, and its score is below any other
    at, span = load_greys(places, here), all_greys(np.uint8(STRIP - APART))
    near_above = bits(over(load_greys(places, here - strip), plus(at, span)))
    near_below = bits(over(at, plus(load_greys(places, here + strip), span)))
    over_above = bits(over(own, load_greys(scores, here - strip)))
    under_below = bits(over(load_greys(scores, here + strip), own))
    return high & (over_above | ~near_above) & ~(under_below & near_below)


@vector_kernel
def list_peaks(
    score: Grey,
    at: NDArray[np.uint8],
    threshold: int,
    columns: NDArray[np.int32],
    rows: NDArray[np.int32],
    heights: NDArray[np.int32],
) -> int:
    """All peaks above a score, strip after strip; returns how many.

    Args:
        score, at: see ``search_part``; the first and the last strip are empty.
        columns, rows, heights: filled; a peak lies within a row or two of ``rows``.
    """
    scores, places = score.reshape(-1), at.reshape(-1)
    strip = np.uintp(score.shape[1])
    least = all_greys(score.dtype.type(threshold))
    found = 0
    for s in range(1, len(score) - 1):
        for i in range(np.uintp(0), strip, np.uintp(GREYS)):
            here = np.uintp(s) * strip + i
            left = peaks_of(scores, places, here, strip, least)
            while left != 0 and found < len(columns):
                n = np.uintp(first_bit(left))
                columns[found] = i + n
                rows[found] = ((s - 1) * STRIP + places[here + n]) * STEP + 1
                heights[found] = scores[here + n]
                found += 1
                left &= left - np.uint64(1)
    return found

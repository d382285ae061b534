"""Whether an image shows a second laser line beside the one that was found."""

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.image import Image
from crenel.metrology.robust import median
from crenel.metrology.stripe.extraction import extract_whole, orient_image, orient_mask
from crenel.metrology.stripe.found_line import FoundLine
from crenel.metrology.stripe.settings import AUTOMATIC, PeakChoice

BESIDE_WIDTHS, BESIDE_PX = 3.0, 8.0
"""The first line covers so many of its widths, and at least so many pixels, to either side."""
LEAST_COLUMNS, LEAST_PIECE, LEAST_HEIGHT, WIDTHS_ALIKE = 0.3, 0.25, 0.5, 2.5
"""A second line runs beside the first in this share of the image's columns, shows one piece of this
length, and is at least as high and as slim in these shares: a reflection is fainter, or broader, or
in pieces. A laser that is fainter is never taken for the first one."""
PICTURES_SHARE = 0.5
"""There are two lasers if this share of the pictures with a line shows two."""
ONE_OF_TWO: tuple[PeakChoice, ...] = ("first", "last")
"""Choices by which one of two lines is taken, the same in every column."""


def has_second_line(image: Image, first: FoundLine, where: NDArray[np.bool_] | None = None) -> bool:
    """Whether a second line, such as that of another laser, runs beside the first.

    A line with a gap or a step is one line: its pieces share no columns.

    Args:
        image: (H, W) in which ``first`` was found.
        where: (H, W) pixels in which a line may lie, as for ``find_stripe``.
    """
    axis, (along, across) = first.stripe.axis, first.stripe.along_across
    grey = orient_image(image, axis)
    height, width = grey.shape
    if len(along) < LEAST_COLUMNS * width:
        return False
    allowed = orient_mask(where, grey, axis)
    elsewhere = np.ones(grey.shape, np.bool_) if allowed is None else allowed.copy()
    beside = int(np.ceil(max(BESIDE_WIDTHS * first.broadest_px, BESIDE_PX)))
    columns, rows = np.rint(along).astype(int), np.rint(across).astype(int)
    for off in range(-beside, beside + 1):
        elsewhere[np.clip(rows + off, 0, height - 1), columns] = False
    second = extract_whole(grey, axis, elsewhere, AUTOMATIC)
    _, ours, theirs = np.intersect1d(
        columns, np.rint(second.stripe.along_across[0]).astype(int), return_indices=True
    )
    if len(ours) < LEAST_COLUMNS * width or second.length < LEAST_PIECE:
        return False
    heights = first.stripe.intensity[ours], second.stripe.intensity[theirs]
    broad = first.broadest_px, second.broadest_px
    return median(heights[1]) >= LEAST_HEIGHT * median(heights[0]) and (
        max(broad) <= WIDTHS_ALIKE * min(broad) or min(broad) == 0
    )


def shows_two_lasers(pictures: Iterable[bool]) -> bool:
    """Whether pictures, each with one line or (True) with two, are of two lasers."""
    two = list(pictures)
    return sum(two) > 0 and sum(two) >= max(PICTURES_SHARE * len(two), min(2, len(two)))

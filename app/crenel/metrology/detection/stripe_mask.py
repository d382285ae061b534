"""The pixels that the laser stripe covers in a picture with ambient light and laser light."""

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.image import Image
from crenel.metrology.stripe import ANYWHERE, LineSearch, Stripe, concatenate_stripes
from crenel.metrology.transforms import Floats

_WIDEST_PX = 16
_PROBED = 400


def stripe_in_the_way(image: Image, axis: str, search: LineSearch = ANYWHERE) -> Stripe:
    """The stripe in an image (H, W) with both lights, with both points of a column that crosses it
    on a crest and on a floor.

    Lit faces may outshine it: that it is a line is known only because the laser was on.

    Raises:
        OperationError: as ``extract_stripe``.
    """
    first = search.extract(image, axis, np.ones(image.shape, np.bool_))
    beside = ~stripe_mask(image.astype(np.float64), first)
    return concatenate_stripes([first, search.extract(image, axis, beside)])


def stripe_mask(grey: Floats, stripe: Stripe) -> NDArray[np.bool_]:
    """Pixels (H, W) lit by the stripe: all within its measured half width of its points."""
    height, width = grey.shape
    mask = np.zeros((height, width), np.uint8)
    column = np.rint(stripe.u).astype(np.int64)
    row = np.rint(stripe.v).astype(np.int64)
    inside = (column >= 0) & (column < width) & (row >= 0) & (row < height)
    column, row = column[inside], row[inside]
    if len(column) == 0:
        return mask > 0
    mask[row, column] = 1
    reach = _half_width(grey, column, row, by_column=_counts_columns(stripe.u, stripe.v)) + 1
    disc = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * reach + 1, 2 * reach + 1))
    # Along the stripe, points may be missing if it is faint or crosses an edge.
    bridged = cv2.morphologyEx(mask, cv2.MORPH_CLOSE, np.ones((3, 3), np.uint8))
    return np.asarray(cv2.dilate(bridged, disc) > 0)


def _counts_columns(u: Floats, v: Floats) -> bool:
    """Whether there is one point per column (integer u) rather than per row."""
    return bool(np.abs(u - np.rint(u)).sum() <= np.abs(v - np.rint(v)).sum())


def _half_width(
    grey: Floats, column: NDArray[np.int64], row: NDArray[np.int64], by_column: bool
) -> int:
    """Three standard deviations, in px, of the stripe's median profile."""
    pick = np.linspace(0, len(column) - 1, min(len(column), _PROBED)).astype(np.int64)
    offsets = np.arange(-_WIDEST_PX, _WIDEST_PX + 1)
    du, dv = (0, 1) if by_column else (1, 0)
    at_row = np.clip(row[pick, None] + dv * offsets, 0, grey.shape[0] - 1)
    at_column = np.clip(column[pick, None] + du * offsets, 0, grey.shape[1] - 1)
    values = grey[at_row, at_column]
    profile = np.median(values - values.min(axis=1, keepdims=True), axis=0)
    fall = -np.diff((profile + profile[::-1])[_WIDEST_PX:])
    steepest = int(np.argmax(fall))
    if fall[steepest] <= 0:
        return 2
    # The slope of a Gaussian stripe is largest at one standard deviation, and a quarter of that at
    # 2.4, whatever the brightness of the background.
    level = fall[steepest:] < 0.25 * fall[steepest]
    flat = steepest + int(np.argmax(level)) if level.any() else _WIDEST_PX
    return max(2, int(np.ceil(1.3 * flat)))

"""Stripe extraction from an image: checks, and the scale that shows the line best."""

from typing import cast

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.image import Image
from crenel.metrology.stripe.bands import is_beam_beside, is_wide, measure_pieces, paint_over
from crenel.metrology.stripe.found_line import CERTAIN_SIGMA_ROWS, THIN_SIGMA_ROWS_BROKEN, FoundLine
from crenel.metrology.stripe.line_bounds import LineBounds
from crenel.metrology.stripe.one_scale import EXTRACT, extract_at
from crenel.metrology.stripe.points import Stripe, empty_stripe
from crenel.metrology.stripe.scales import THIN_FACTOR, wide_factors
from crenel.metrology.stripe.settings import AUTOMATIC, StripeSettings
from crenel.metrology.stripe.smoothing import smooth_stripe

WIDEST_LINE, WIDEST_CORE = 1 / 8, 1 / 5
"""A line at half height, and its clipped core, are at most so wide, in shares of the image's
height."""
LEAST_SLIMNESS = 4.0
"""What a coarser scale shows in place of a line is so many times as long as wide: a lit face is
not."""
CLEARLY_BETTER, BETTER = 1.05, 1.02
"""A coarser scale is chosen if it shows this much more of the line; the latter of a wide line. The
finer one measures a line that is no bell more exactly."""
MOSTLY = 0.5
"""The share of its points that lie on bands that are no beam, from which on it is no line."""
THIN_AS_GOOD = 0.85
"""Rows between the rows are if they show this much: a thin line is less high there."""


def extract_stripe(
    image: Image,
    axis: str = "u",
    where: NDArray[np.bool_] | None = None,
    settings: StripeSettings = AUTOMATIC,
    bounds: LineBounds | None = None,
) -> Stripe:
    """The laser stripe in an image: one point in each column or row that it crosses.

    A Gaussian on a constant background is fitted to each peak, weighted by the noise of the pixels,
    which is estimated from the image itself; clipped pixels are excluded. If a broad core is
    clipped, the position of the line follows from its two flanks and is smoothed along the line
    over the width of the core. Lines from a pixel to an eighth of the image wide are found. What
    stands out of the image no more than other things there is no line, unless ``where`` or
    ``settings`` say what the line is like.

    Args:
        image: (H, W) of uint8 or uint16 (9 to 16 significant bits).
        axis: ``u`` for one point in each column, v measured; ``v`` for one point in each row.
        where: (H, W) pixels in which the stripe may lie; None: anywhere.
        settings: threshold, widths, the choice between several peaks, and smoothing along the line.
        bounds: where a line can be, by the sensor's calibration; nothing else of the image counts.
            Unlike ``where``, they do not say that there is one. Those of an image of another size
            do not count.

    Returns:
        The points in ascending order, each with its standard deviation; none if the image
        shows no stripe.

    Raises:
        OperationError: ``image-not-grey``, ``mask-size``, ``axis-unknown``, or
            ``stripe-settings`` that contradict each other.

    Example:
        >>> rows = np.arange(48.0)[:, None]
        >>> grey = 10 + 200 * np.exp(-((rows - 20.3) ** 2) / (2 * 1.5**2)) + np.zeros((48, 64))
        >>> noise = np.random.default_rng(0).normal(0.0, 1.0, grey.shape)
        >>> stripe = extract_stripe((grey + noise).round().astype(np.uint8))
        >>> len(stripe.u), round(float(np.mean(stripe.v)), 1)
        (64, 20.3)
    """
    return find_stripe(image, axis, where, settings, bounds).stripe


def find_stripe(
    image: Image,
    axis: str = "u",
    where: NDArray[np.bool_] | None = None,
    settings: StripeSettings = AUTOMATIC,
    bounds: LineBounds | None = None,
) -> FoundLine:
    """The laser stripe in an image, with its width and the scale at which it was found.

    Arguments and errors are those of ``extract_stripe``.
    """
    grey = orient_image(image, axis)
    bounds = bounds if bounds is not None and bounds.fits(grey.shape, axis) else None
    found = extract_whole(grey, axis, orient_mask(where, grey, axis), settings, bounds=bounds)
    found.stripe = smooth_as_set(found, settings)
    return found


def smooth_as_set(found: FoundLine, settings: StripeSettings) -> Stripe:
    """The stripe that was found, smoothed along itself if the settings say so."""
    if settings.smoothing_px == 0:
        return found.stripe
    return smooth_stripe(found.stripe, settings.smoothing_px, found.saturated)


def extract_whole(
    grey: Image,
    axis: str,
    where: NDArray[np.bool_] | None,
    settings: StripeSettings,
    first: FoundLine | None = None,
    bounds: LineBounds | None = None,
) -> FoundLine:
    """The stripe in an image that is already oriented, at the scale that shows most of a line.

    Args:
        grey, where: (H, W) from ``orient_image``, ``orient_mask``.
        first: what the image shows at full scale, if that is known already.
        bounds: of this image.
    """
    best = _best_scale(grey, axis, where, settings, first, bounds)
    return without_bands(grey, best, where, settings, bounds)


def without_bands(
    grey: Image,
    found: FoundLine,
    where: NDArray[np.bool_] | None,
    settings: StripeSettings,
    bounds: LineBounds | None = None,
) -> FoundLine:
    """The line that was found, or the one beside it, if that is a beam and the former a band.

    What the operator says of the line, or of its place, overrides that.
    """
    if not is_wide(found) or _is_specified(where, settings):
        return found
    pieces = measure_pieces(grey, found)
    bands = [piece for piece in pieces if piece.is_band]
    if not bands:
        return found
    painted = paint_over(grey, bands)
    other = _best_scale(painted, found.stripe.axis, None, settings, bounds=bounds)
    if is_beam_beside(grey, other, bands):
        return other
    none = sum(len(piece.columns) for piece in bands if piece.is_no_beam)
    if none >= MOSTLY * len(found.stripe.u):
        return FoundLine(empty_stripe(found.stripe.axis))
    return found


def _is_specified(where: NDArray[np.bool_] | None, settings: StripeSettings) -> bool:
    """Whether the operator says what the line is like, or where it is."""
    return where is not None or not settings.is_automatic


def _best_scale(
    grey: Image,
    axis: str,
    where: NDArray[np.bool_] | None,
    settings: StripeSettings,
    first: FoundLine | None = None,
    bounds: LineBounds | None = None,
) -> FoundLine:
    """The stripe at the scale that shows most of a line."""
    best = first or extract_at(grey, axis, where, settings, 1.0, bounds)
    if best.is_certain:
        return best
    looks_thin = best.is_thin
    if looks_thin:
        best = _between_rows(grey, axis, where, settings, best, THIN_AS_GOOD, bounds)
        if best.evidence:
            return best  # else it was the noise on the flat top of a wide line
    for factor in wide_factors(grey.shape[0]):
        found = extract_at(grey, axis, where, settings, factor, bounds)
        is_line = max(found.width_px / WIDEST_LINE, found.core_px / WIDEST_CORE) < grey.shape[0]
        is_slim = found.length * grey.shape[1] > LEAST_SLIMNESS * found.broadest_px
        is_line &= is_slim or not best.evidence
        enough = CLEARLY_BETTER if best.sigma_rows < CERTAIN_SIGMA_ROWS else BETTER
        if is_line and found.evidence > enough * best.evidence:
            best = found
        if found.is_certain:
            break
    if not looks_thin and not best.is_long:
        best = _between_rows(grey, axis, where, settings, best, CLEARLY_BETTER, bounds)
    return best


def _between_rows(
    grey: Image,
    axis: str,
    where: NDArray[np.bool_] | None,
    settings: StripeSettings,
    best: FoundLine,
    enough: float,
    bounds: LineBounds | None,
) -> FoundLine:
    """The line of hardly a pixel between the rows, if that shows so many times as much as ``best``
    does; otherwise ``best``."""
    found = extract_at(grey, axis, where, settings, THIN_FACTOR, bounds)
    is_thin = 0 < found.sigma_rows * THIN_FACTOR < THIN_SIGMA_ROWS_BROKEN
    return found if is_thin and found.evidence > enough * best.evidence else best


def orient_image(image: Image, axis: str) -> Image:
    """The image with the stripe across its columns, with rows contiguous in memory.

    Raises:
        OperationError: not a grey image of integers, or an unknown axis.
    """
    array = np.asarray(image)
    if array.ndim != 2 or array.dtype not in EXTRACT:
        raise OperationError(
            "image-not-grey",
            message("image-shape-type", shape=str(array.shape), dtype=str(array.dtype)),
            message("stripe-extracted-grey-images-8-16"),
        )
    if axis not in ("u", "v"):
        raise OperationError("axis-unknown", message("stripe-axis", axis=axis), message("u-v"))
    if axis == "u":
        return np.ascontiguousarray(array)
    return cast(Image, cv2.transpose(cast(Image, array)))


def orient_mask(
    where: NDArray[np.bool_] | None, grey: Image, axis: str
) -> NDArray[np.bool_] | None:
    """The mask, oriented like the image.

    Raises:
        OperationError: its size differs from that of the image.
    """
    if where is None:
        return None
    turned = np.ascontiguousarray(where if axis == "u" else where.T, dtype=np.bool_)
    if turned.shape != grey.shape:
        raise OperationError(
            "mask-size",
            message("mask-pixels-image-another-size", shape=str(where.shape)),
            message("mask-says-every-pixel-whether-stripe"),
        )
    return turned

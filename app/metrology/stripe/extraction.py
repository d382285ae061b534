"""Stripe extraction from an image: checks, the call into C, and its result."""

import math
from dataclasses import dataclass
from typing import cast

import cv2
import numpy as np
from numpy.typing import NDArray

from app.errors import OperationError
from app.messages.message import message
from app.metrology.image import Image
from app.metrology.stripe.points import Stripe, empty_stripe, stripe_from_points
from app.metrology.stripe.scales import (
    FULL,
    THIN_FACTOR,
    Scale,
    height_at,
    reduce_mask,
    reduce_rows,
    rows_to_fill,
    scale_of,
    wide_factors,
)
from app.metrology.stripe.settings import AUTOMATIC, StripeSettings, check_settings
from app.metrology.stripe.smoothing import smooth_stripe
from app.metrology.stripe.workspace import (
    LEAST_ROWS,
    PER_FULL_WIDTH,
    Fields,
    acquire_workspace,
    release_workspace,
)
from app.native.arguments import U8, U16, Function, Record
from app.native.library import CRENEL

EXTRACT = {
    U8: Function(CRENEL, "extract_8", Record(Fields), returns=int),
    U16: Function(CRENEL, "extract_16", Record(Fields), returns=int),
}

CERTAIN_LENGTH, CERTAIN_LENGTH_CLIPPED = 0.35, 0.6
"""A line so long, in shares of the image's width, is looked for at no other scale."""
THIN_SIGMA_ROWS, THIN_SIGMA_ROWS_BROKEN, CERTAIN_SIGMA_ROWS = 0.8, 1.2, 5.0
"""A thinner line, or a thinner one that is not long, is looked for between the rows, too; one at
least so wide at coarser scales."""
WIDEST_LINE = 1 / 8
"""A line is at most so wide at half height, in shares of the image's height."""
CLEARLY_BETTER, BETTER = 1.05, 1.02
"""A coarser scale is chosen if it shows this much more of the line; the latter of a wide line. The
finer one measures a line that is no bell more exactly."""
THIN_AS_GOOD = 0.85
"""Rows between the rows are if they show this much: a thin line is less high there."""
UNRESOLVED_PX, UNRESOLVED_SIGMA_ROWS = 12**-0.5, 1.2
"""The standard deviation of a point of a line that is thinner than a pixel, as it may lie anywhere
in the pixel; the width that such a line has between the rows."""


def extract_stripe(
    image: Image,
    axis: str = "u",
    where: NDArray[np.bool_] | None = None,
    settings: StripeSettings = AUTOMATIC,
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
    return find_stripe(image, axis, where, settings).stripe


def find_stripe(
    image: Image,
    axis: str = "u",
    where: NDArray[np.bool_] | None = None,
    settings: StripeSettings = AUTOMATIC,
) -> "FoundLine":
    """The laser stripe in an image, with its width and the scale at which it was found.

    Arguments and errors are those of ``extract_stripe``.
    """
    grey = orient_image(image, axis)
    found = extract_whole(grey, axis, orient_mask(where, grey, axis), settings)
    found.stripe = smooth_as_set(found, settings)
    return found


def smooth_as_set(found: "FoundLine", settings: StripeSettings) -> Stripe:
    """The stripe that was found, smoothed along itself if the settings say so."""
    if settings.smoothing_px == 0:
        return found.stripe
    return smooth_stripe(found.stripe, settings.smoothing_px, found.saturated)


@dataclass(slots=True)
class FoundLine:
    """A stripe, and how much of a line it is.

    ``evidence``: length of the line, in shares of the image's width, times its height in grey
    levels; 0 if it does not stand out of the image. ``length``: that of one piece which shows as
    much. ``scale``: how many rows of the image were made one. ``sigma_rows``: the usual width
    there, as a standard deviation; 0 if the line is clipped. ``saturated``: the grey level from
    which on the line counts as clipped.
    """

    stripe: Stripe
    evidence: float = 0.0
    length: float = 0.0
    scale: Scale = FULL
    sigma_rows: float = 0.0
    saturated: float = math.inf

    @property
    def factor(self) -> float:
        """Rows of the image that were made one."""
        return self.scale.factor

    @property
    def width_px(self) -> float:
        """Its usual width at half height in pixels of the image; 0 if it is clipped."""
        return self.sigma_rows * self.factor / PER_FULL_WIDTH

    @property
    def is_long(self) -> bool:
        """Whether it is one long line."""
        long = CERTAIN_LENGTH if self.sigma_rows else CERTAIN_LENGTH_CLIPPED
        return self.evidence > 0 and self.length >= long

    @property
    def is_certain(self) -> bool:
        """Whether it is one long line, of a width that no other scale would show better."""
        return self.is_long and not self.is_thin and self.sigma_rows < CERTAIN_SIGMA_ROWS

    @property
    def is_thin(self) -> bool:
        """Whether rows between the rows would show more of it."""
        thin = THIN_SIGMA_ROWS if self.is_long else THIN_SIGMA_ROWS_BROKEN
        return self.factor == 1 and 0 < self.sigma_rows < thin


def extract_whole(
    grey: Image,
    axis: str,
    where: NDArray[np.bool_] | None,
    settings: StripeSettings,
    first: FoundLine | None = None,
) -> FoundLine:
    """The stripe in an image that is already oriented, at the scale that shows most of a line.

    Args:
        grey, where: (H, W) from ``orient_image``, ``orient_mask``.
        first: what the image shows at full scale, if that is known already.
    """
    best = first or _extract_at(grey, axis, where, settings, 1.0)
    if best.is_certain:
        return best
    for factor in () if best.is_thin else wide_factors(grey.shape[0]):
        found = _extract_at(grey, axis, where, settings, factor)
        is_line = found.width_px < WIDEST_LINE * grey.shape[0]
        enough = CLEARLY_BETTER if best.sigma_rows < CERTAIN_SIGMA_ROWS else BETTER
        if is_line and found.evidence > enough * best.evidence:
            best = found
        if found.is_certain:
            break
    if best.is_thin or not best.is_long:
        found = _extract_at(grey, axis, where, settings, THIN_FACTOR)
        enough = THIN_AS_GOOD if best.is_thin else CLEARLY_BETTER
        is_thin = 0 < found.sigma_rows * THIN_FACTOR < THIN_SIGMA_ROWS_BROKEN
        if is_thin and found.evidence > enough * best.evidence:
            best = found
    return best


def _extract_at(
    grey: Image,
    axis: str,
    where: NDArray[np.bool_] | None,
    settings: StripeSettings,
    factor: float,
) -> FoundLine:
    """The stripe in a complete image at one scale."""
    parts, allowed = whole_image(grey, factor), reduce_mask(where, factor)
    return extract_parts(grey, axis, parts, allowed, settings, scale=scale_of(grey, factor))


def extract_parts(
    grey: Image,
    axis: str,
    parts: NDArray[np.int64],
    where: NDArray[np.bool_] | None,
    settings: StripeSettings,
    known: NDArray[np.float32] | None = None,
    scale: Scale = FULL,
) -> FoundLine:
    """The stripe in parts of an image that is already oriented, at one scale.

    Args:
        grey: (H, W) with the stripe across its columns, from ``orient_image``.
        parts: (n, 4) first row and the one after the last, first column and the one after the
            last, of each part of the reduced image.
        where: (H / factor, W) pixels of the reduced image in which the stripe may lie; None:
            anywhere.
        known: (4,) the three terms of the noise and the usual width (a standard deviation, px)
            from earlier frames at this scale; zeros are filled in.
        scale: how many rows of the image are made one.
    """
    check_settings(settings)
    if grey.shape[0] <= LEAST_ROWS or grey.shape[1] < settings.min_run:
        return FoundLine(empty_stripe(axis))
    image, kind, factor = grey, grey.dtype, scale.factor
    if factor != 1:
        kind, settings = U16, scale.settings(settings)
    known = np.zeros(4, dtype=np.float32) if known is None else known
    rows = height_at(grey.shape[0], factor)
    workspace = acquire_workspace(rows, grey.shape[1], kind)
    try:
        if factor != 1:
            filled = rows_to_fill(parts, rows, float(known[3]), clipped=False)
            image = reduce_rows(grey, scale, filled, workspace.reduced)
        workspace.set_frame(image, parts, where, known)
        workspace.set_settings(settings, scale.climb_rows)
        count = EXTRACT[image.dtype](workspace.fields)
        if factor > 1 and workspace.fields.is_clipped:
            more = rows_to_fill(parts, rows, 0, clipped=True)
            if (more[:, :2] != filled[:, :2]).any():
                reduce_rows(grey, scale, more, workspace.reduced)
                count = EXTRACT[image.dtype](workspace.fields)
        points = workspace.points[:, :count].copy()
        evidence, length = workspace.fields.evidence, workspace.fields.length
        saturated = workspace.fields.saturated / scale.gain
    finally:
        release_workspace(workspace)
    if factor != 1:
        points[1] = scale.across_px(points[1])
        points[2] /= scale.gain
        unresolved = factor < 1 and known[3] < UNRESOLVED_SIGMA_ROWS
        points[3] = np.hypot(points[3] * factor, UNRESOLVED_PX if unresolved else 0)
    stripe = stripe_from_points(points, axis)
    return FoundLine(stripe, evidence / scale.gain, length, scale, float(known[3]), saturated)


def whole_image(grey: Image, factor: float = 1.0) -> NDArray[np.int64]:
    """(1, 4) the part that is the complete image with ``factor`` rows made one."""
    return np.array([[0, height_at(grey.shape[0], factor), 0, grey.shape[1]]])


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

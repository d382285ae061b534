"""The stripe in an image at one scale: the call into C, and its result."""

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.image import Image
from crenel.metrology.stripe.found_line import FoundLine
from crenel.metrology.stripe.line_bounds import LineBounds
from crenel.metrology.stripe.line_evidence import read_evidence
from crenel.metrology.stripe.points import empty_stripe, stripe_from_points
from crenel.metrology.stripe.scales import (
    FULL,
    Scale,
    height_at,
    reduce_mask,
    reduce_rows,
    rows_to_fill,
    scale_of,
)
from crenel.metrology.stripe.settings import StripeSettings, check_settings
from crenel.metrology.stripe.workspace import (
    LEAST_ROWS,
    Fields,
    acquire_workspace,
    release_workspace,
)
from crenel.native.arguments import U8, U16, Function, Record
from crenel.native.library import CRENEL

EXTRACT = {
    U8: Function(CRENEL, "extract_8", Record(Fields), returns=int),
    U16: Function(CRENEL, "extract_16", Record(Fields), returns=int),
}
UNRESOLVED_PX, UNRESOLVED_SIGMA_ROWS = 12**-0.5, 1.2
"""The standard deviation of a point of a line that is thinner than a pixel, as it may lie anywhere
in the pixel; the width that such a line has between the rows."""


def extract_at(
    grey: Image,
    axis: str,
    where: NDArray[np.bool_] | None,
    settings: StripeSettings,
    factor: float,
    bounds: LineBounds | None = None,
) -> FoundLine:
    """The stripe in an image that is already oriented, within its bounds, at one scale."""
    parts = whole_image(grey, factor) if bounds is None else bounds.parts(factor)
    allowed = reduce_mask(where, factor)
    return extract_parts(grey, axis, parts, allowed, settings, scale=scale_of(grey, factor))


def extract_parts(
    grey: Image,
    axis: str,
    parts: NDArray[np.int64],
    where: NDArray[np.bool_] | None,
    settings: StripeSettings,
    known: NDArray[np.float32] | None = None,
    scale: Scale = FULL,
    *,
    explains: bool = False,
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
        explains: says what decided about the line, too, which takes time.
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
        why = read_evidence(workspace, count, scale) if explains else None
        core_rows, fall_rows = workspace.fields.core_rows, workspace.fields.half_fall
    finally:
        release_workspace(workspace)
    if factor != 1:
        points[1] = scale.across_px(points[1])
        points[2] /= scale.gain
        unresolved = factor < 1 and known[3] < UNRESOLVED_SIGMA_ROWS
        points[3] = np.hypot(points[3] * factor, UNRESOLVED_PX if unresolved else 0)
    stripe = stripe_from_points(points, axis)
    return FoundLine(
        stripe,
        evidence / scale.gain,
        length,
        scale,
        float(known[3]),
        core_rows,
        fall_rows,
        saturated,
        why,
    )


def whole_image(grey: Image, factor: float = 1.0) -> NDArray[np.int64]:
    """(1, 4) the part that is the complete image with ``factor`` rows made one."""
    return np.array([[0, height_at(grey.shape[0], factor), 0, grey.shape[1]]])

"""Stripe extraction from an image: checks, the call into C, and its result."""

from typing import cast

import cv2
import numpy as np
from numpy.typing import NDArray

from app.errors import OperationError
from app.messages.message import message
from app.metrology.image import Image
from app.metrology.stripe.points import Stripe, empty_stripe, stripe_from_points
from app.metrology.stripe.settings import AUTOMATIC, StripeSettings, check_settings
from app.metrology.stripe.workspace import (
    LEAST_ROWS,
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
    over the width of the core.

    Args:
        image: (H, W) of uint8 or uint16 (9 to 16 significant bits).
        axis: ``u`` for one point in each column, v measured; ``v`` for one point in each row.
        where: (H, W) pixels in which the stripe may lie; None: anywhere.
        settings: threshold, widths and the choice between several peaks.

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
    grey = orient_image(image, axis)
    whole = np.array([[0, grey.shape[0], 0, grey.shape[1]]])
    return extract_parts(grey, axis, whole, orient_mask(where, grey, axis), settings)


def extract_parts(
    grey: Image,
    axis: str,
    parts: NDArray[np.int64],
    where: NDArray[np.bool_] | None,
    settings: StripeSettings,
    known: NDArray[np.float32] | None = None,
) -> Stripe:
    """The stripe in parts of an image that is already oriented; see ``extract_stripe``.

    Args:
        grey: (H, W) with the stripe across its columns, from ``orient_image``.
        parts: (n, 4) first row and the one after the last, first column and the one after the
            last, of each part.
        where: (H, W) pixels in which the stripe may lie; None: anywhere.
        known: (4,) the three terms of the noise and the usual width (a standard deviation, px)
            from earlier frames; zeros are filled in.
    """
    check_settings(settings)
    if grey.shape[0] <= LEAST_ROWS or grey.shape[1] < settings.min_run:
        return empty_stripe(axis)
    known = np.zeros(4, dtype=np.float32) if known is None else known
    workspace = acquire_workspace(grey)
    try:
        workspace.set_frame(grey, parts, where, known)
        workspace.set_settings(settings)
        count = EXTRACT[grey.dtype](workspace.fields)
        return stripe_from_points(workspace.points[:, :count].copy(), axis)
    finally:
        release_workspace(workspace)


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

"""What the laser's line spoils of a picture with a board."""

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.image import Image, saturation_level
from crenel.metrology.robust import median
from crenel.metrology.stripe import Stripe, empty_stripe

# Pixels this close to clipped ones or to the middle of the stripe show laser light.
CLIPPED_MARGIN_PX, STRIPE_MARGIN_PX = 8, 12
# Clipped pixels this near to the stripe's middle are its own, and not a white square's.
CLIPPED_REACH_PX = 30
# Weaker points than this share of the stripe's usual brightness are none of it.
STRIPE_SHARE = 0.5
# Ratio of the laser line's brightness to the board's, and share of the picture that the white of
# the board covers.
OUTSHINES, DARKER_SHARE = 1.15, 0.95


def drop_faint_stripe(image: Image, stripe: Stripe) -> Stripe:
    """The stripe, or an empty one if it is not brighter than the white squares.

    Bright squares between black ones look like a stripe if the laser line is outside the image.

    Args:
        image: (H, W) grey, 8 to 16 bits, with ambient light and laser.
        stripe: as extracted from this image.
    """
    if not len(stripe.u):
        return stripe
    u, v = (np.round(x).astype(np.int64) for x in (stripe.u, stripe.v))
    at = image[np.clip(v, 0, image.shape[0] - 1), np.clip(u, 0, image.shape[1] - 1)]
    white = float(np.quantile(image, DARKER_SHARE))
    if median(at) >= min(OUTSHINES * white, saturation_level(image)):
        return stripe
    return empty_stripe(stripe.axis)


def laser_mask(image: Image, stripe: Stripe | None) -> NDArray[np.bool_]:
    """(H, W) pixels that the laser's line has spoilt: its own, and the clipped ones about it."""
    if stripe is None or not len(stripe.u):
        return np.zeros(image.shape, dtype=np.bool_)
    own = stripe.intensity > STRIPE_SHARE * median(stripe.intensity)
    middle = np.zeros(image.shape, np.uint8)
    u, v = (np.round(x[own]).astype(np.int64) for x in (stripe.u, stripe.v))
    middle[np.clip(v, 0, image.shape[0] - 1), np.clip(u, 0, image.shape[1] - 1)] = 1
    near = _dilate(middle, CLIPPED_REACH_PX)
    clipped = (image >= saturation_level(image)).astype(np.uint8) & near
    return (_dilate(middle, STRIPE_MARGIN_PX) | _dilate(clipped, CLIPPED_MARGIN_PX)) > 0


def _dilate(mask: NDArray[np.uint8], margin_px: int) -> NDArray[np.uint8]:
    size = 2 * margin_px + 1
    return np.asarray(cv2.dilate(mask, np.ones((size, size), np.uint8)), np.uint8)

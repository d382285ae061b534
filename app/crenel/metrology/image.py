"""Grey images: their type, and the level at which their pixels are clipped."""

import numpy as np
from numpy.typing import NDArray

Image = NDArray[np.uint8] | NDArray[np.uint16]
"""(H, W) grey levels of 8, or of 9 to 16 significant bits."""


def saturation_level(image: Image) -> float:
    """The grey level at which the pixels of an image are clipped.

    Args:
        image: (H, W) of uint8 or uint16.

    Returns:
        255 for 8 bits. For 16 bits, the full scale of the sensor (1023, 4095, …, also shifted to
        the upper bits) if the brightest pixel shows it, otherwise 65535.

    Example:
        >>> saturation_level(np.array([[0, 4095]], dtype=np.uint16))
        4095.0
    """
    if image.dtype == np.uint8:
        return 255.0
    return float(full_scale_shown(int(image.max())))


def negative_of(image: Image) -> Image:
    """The image (H, W) with dark for bright, up to the level at which its pixels are clipped."""
    level = saturation_level(image)
    if image.dtype == np.uint8:
        return np.asarray(level - image, np.uint8)
    return np.asarray(level - image, np.uint16)


def full_scale_shown(brightest: int) -> int:
    """The full scale of a sensor of 9 to 16 bits that its brightest pixel shows, otherwise 65535.

    Example:
        >>> full_scale_shown(4095), full_scale_shown(4095 << 4), full_scale_shown(4000)
        (4095, 65520, 65535)
    """
    if brightest:
        significant = brightest >> ((brightest & -brightest).bit_length() - 1)
        if significant & (significant + 1) == 0 and 9 <= significant.bit_length() <= 16:
            return brightest
    return 65535

"""Grey images: their type, and the level at which their pixels are clipped."""

import numpy as np
from numpy.typing import NDArray

Image = NDArray[np.uint8] | NDArray[np.uint16]
"""(H, W) grey levels of 8, or of 9 to 16 significant bits."""


def saturation_level(image: Image) -> float:
    """The grey level at which this image's pixels are clipped.

    255 for 8 bits; for 16-bit images the sensor's own depth where the brightest
    pixel shows it (1023, 4095, ..., also shifted to the upper bits), else 65535.
    """
    if image.dtype == np.uint8:
        return 255.0
    top = int(image.max())
    if top:
        significant = top >> ((top & -top).bit_length() - 1)
        if significant & (significant + 1) == 0 and 9 <= significant.bit_length() <= 16:
            return float(top)
    return 65535.0

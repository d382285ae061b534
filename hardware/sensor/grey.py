"""Whatever a camera delivers, as one grey channel."""

import cv2
import numpy as np
from cv2.typing import MatLike

from hardware.sensor.grabbing import GreyImage


def to_grey(raw: MatLike, height_px: int) -> GreyImage | None:
    """The grey (height, width) picture, without loss where a luma channel is there.

    Args:
        raw: colour (h, w, 3) BGR or (h, w, 4) BGRA; packed YUV 4:2:2 (h, w, 2) with Y
            first; grey or planar YUV with Y first (≥ h, w) of 8 or 16 bits; or a JPEG
            (1, n), as the camera sent it.
        height_px: the picture's height h.

    Returns None for a damaged JPEG.
    """
    if raw.ndim == 2 and raw.shape[0] == 1 and height_px > 1:
        decoded = cv2.imdecode(raw.astype(np.uint8, copy=False), cv2.IMREAD_GRAYSCALE)
        return None if decoded is None else decoded.astype(np.uint8, copy=False)
    if raw.ndim == 3 and raw.shape[2] >= 3:
        code = cv2.COLOR_BGR2GRAY if raw.shape[2] == 3 else cv2.COLOR_BGRA2GRAY
        raw = cv2.cvtColor(raw, code)
    elif raw.ndim == 3:
        raw = raw[:, :, 0]
    if raw.dtype == np.uint16:
        return np.ascontiguousarray(raw[:height_px], dtype=np.uint16)
    return np.ascontiguousarray(raw[:height_px], dtype=np.uint8)

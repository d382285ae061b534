"""Whatever a camera delivers, as one grey channel."""

from typing import Literal

import cv2
import numpy as np
from cv2.typing import MatLike

from hardware.sensor.image_source import GreyImage

LaserColour = Literal["red", "green", "blue"]
PLANES: dict[LaserColour, int] = {"blue": 0, "green": 1, "red": 2}
"""In OpenCV's order."""


def to_grey(
    raw: MatLike, height_px: int, laser_colour: LaserColour | None = None
) -> GreyImage | None:
    """The grey (height, width) picture, without loss where a luma channel is there.

    Args:
        raw: colour (h, w, 3) BGR or (h, w, 4) BGRA; packed YUV 4:2:2 (h, w, 2) with Y
            first; grey or planar YUV with Y first (≥ h, w) of 8 or 16 bits; or a JPEG
            (1, n), as the camera sent it.
        height_px: the picture's height h.
        laser_colour: the channel to take of a colour picture; else its luma, in which a laser
            of one colour is weaker and the room's light is not.

    Returns None for a damaged JPEG.
    """
    if raw.ndim == 2 and raw.shape[0] == 1 and height_px > 1:
        flag = cv2.IMREAD_GRAYSCALE if laser_colour is None else cv2.IMREAD_COLOR
        decoded = cv2.imdecode(raw.astype(np.uint8, copy=False), flag)
        return None if decoded is None else to_grey(decoded, decoded.shape[0], laser_colour)
    if raw.ndim == 3 and raw.shape[2] >= 3 and laser_colour is not None:
        raw = raw[:, :, PLANES[laser_colour]]
    elif raw.ndim == 3 and raw.shape[2] >= 3:
        code = cv2.COLOR_BGR2GRAY if raw.shape[2] == 3 else cv2.COLOR_BGRA2GRAY
        raw = cv2.cvtColor(raw, code)
    elif raw.ndim == 3:
        raw = raw[:, :, 0]
    if raw.dtype == np.uint16:
        return np.ascontiguousarray(raw[:height_px], dtype=np.uint16)
    return np.ascontiguousarray(raw[:height_px], dtype=np.uint8)

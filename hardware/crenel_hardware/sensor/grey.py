"""Whatever a camera delivers, as one grey channel."""

from typing import Literal, cast

import cv2
import numpy as np
from cv2.typing import MatLike

from crenel.messages.message import message
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import SelectedColour
from crenel_hardware.sensor.image_source import GreyImage

BayerPattern = Literal["RGGB", "BGGR", "GRBG", "GBRG"]
"""The colours of a raw picture's first two pixels, and of the two below them."""
LaserColour = Literal["red", "green", "blue"]
PLANES: dict[LaserColour, int] = {"blue": 0, "green": 1, "red": 2}
"""In OpenCV's order."""


def select_bayer(raw: GreyImage, pattern: BayerPattern, colour: LaserColour) -> GreyImage:
    """The pixels of one colour in a raw picture (h, w), as a picture (h // 2, w // 2).

    Of green, the mean of the two in each cell of 2 × 2 pixels. Where one of them is as bright
    as any, and so perhaps clipped, the mean is as bright.
    """
    height, width = (size // 2 * 2 for size in raw.shape)
    letter = colour[0].upper()
    parts = [
        raw[at // 2 : height : 2, at % 2 : width : 2]
        for at in range(len(pattern))
        if pattern[at] == letter
    ]
    if len(parts) == 1:
        return cast(GreyImage, np.ascontiguousarray(parts[0]))
    mean = (parts[0].astype(np.uint32) + parts[1] + 1) // 2
    brighter = np.maximum(*parts)
    whole = np.where(brighter == brighter.max(), brighter, mean)
    return cast(GreyImage, whole.astype(raw.dtype))


def to_grey(
    raw: MatLike,
    height_px: int,
    laser_colour: LaserColour | None = None,
    bayer: BayerPattern | None = None,
) -> GreyImage | None:
    """The grey (height, width) picture, without loss where a luma channel is there.

    Args:
        raw: colour (h, w, 3) BGR or (h, w, 4) BGRA; packed YUV 4:2:2 (h, w, 2) with Y
            first; grey or planar YUV with Y first (≥ h, w) of 8 or 16 bits; or a JPEG
            (1, n), as the camera sent it.
        height_px: the picture's height h.
        laser_colour: the channel to take of a colour picture; else its luma, in which a laser
            of one colour is weaker and the room's light is not.
        bayer: the picture is a raw one, of which the pixels of the laser's colour are taken.

    Returns None for a damaged JPEG.

    Raises:
        DeviceError: a colour picture where a raw one is expected.
    """
    if raw.ndim == 2 and raw.shape[0] == 1 and height_px > 1:
        flag = cv2.IMREAD_GRAYSCALE if laser_colour is None else cv2.IMREAD_COLOR
        decoded = cv2.imdecode(raw.astype(np.uint8, copy=False), flag)
        return None if decoded is None else to_grey(decoded, decoded.shape[0], laser_colour, bayer)
    if bayer is not None and laser_colour is not None:
        return select_bayer(_one_channel(raw)[:height_px], bayer, laser_colour)
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


def colour_taken(
    raw: MatLike, laser_colour: LaserColour | None, bayer: BayerPattern | None = None
) -> SelectedColour | None:
    """What ``to_grey`` takes of a picture; None of a grey one, or where its luma is taken.

    A JPEG is taken for one in colour.
    """
    if laser_colour is None:
        return None
    if bayer is None and raw.ndim == 3:
        in_colour = raw.shape[2] >= 3 and bool((raw[..., :1] != raw[..., :3]).any())
    else:
        in_colour = bayer is not None or raw.shape[0] == 1
    return SelectedColour(laser_colour, bayer) if in_colour else None


def require_colour(bayer: BayerPattern | None, laser_colour: LaserColour | None) -> None:
    """Raises ``DeviceError`` for raw pictures of a laser whose colour is not stated."""
    if bayer is not None and laser_colour is None:
        raise DeviceError(
            message("station-toml-bayer-alone"), message("add-line", key="laser_colour")
        )


def _one_channel(raw: MatLike) -> GreyImage:
    if raw.ndim == 3 and (raw[..., :1] != raw[..., :3]).any():
        raise DeviceError(
            message("camera-sends-colour-not-raw"), message("switch-to-raw-or-take-out-bayer")
        )
    return cast(GreyImage, raw if raw.ndim == 2 else raw[..., 0])

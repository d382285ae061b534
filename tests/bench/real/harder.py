"""Harder pictures made of real ones: another scale, blurred, clipped, tinted, compressed, cut."""

from collections.abc import Callable

import cv2
import numpy as np

from crenel.formats.images import GreyImage, to_8_bits
from crenel.metrology.channel import select_channel
from crenel.metrology.colour import PLANES, LaserColour
from crenel.metrology.image import saturation_level

BLUR_PX = 1.5
BRIGHTENED = 3.0
KEPT_SHARE = 0.8
"""Of each side, of a picture that is cut."""
TINT = 0.35
"""Of the room's light, in the channels beside the laser's."""
TINT_BLUR_PX = 8.0
TINTED: LaserColour = "red"


def _scale(factor: float) -> Callable[[GreyImage], GreyImage]:
    how = cv2.INTER_AREA if factor < 1 else cv2.INTER_CUBIC

    def scaled(picture: GreyImage) -> GreyImage:
        return _like(picture, cv2.resize(picture, None, fx=factor, fy=factor, interpolation=how))

    return scaled


def _blur(picture: GreyImage) -> GreyImage:
    return _like(picture, cv2.GaussianBlur(picture, (0, 0), BLUR_PX))


def _brighten(picture: GreyImage) -> GreyImage:
    top = saturation_level(picture)
    return _like(picture, np.minimum(BRIGHTENED * picture.astype(np.float64), top))


def _compress(quality: int) -> Callable[[GreyImage], GreyImage]:
    def compressed(picture: GreyImage) -> GreyImage:
        coded = cv2.imencode(".jpg", to_8_bits(picture), [cv2.IMWRITE_JPEG_QUALITY, quality])[1]
        return np.asarray(cv2.imdecode(coded, cv2.IMREAD_GRAYSCALE), np.uint8)

    return compressed


def _tint(picture: GreyImage) -> GreyImage:
    """As a colour camera's JPEG, whose colours have half the resolution, by the laser's colour."""
    grey = to_8_bits(picture)
    room = cv2.GaussianBlur(grey, (0, 0), TINT_BLUR_PX) * TINT
    colours = np.repeat(np.rint(room).astype(np.uint8)[..., None], 3, axis=2)
    colours[..., PLANES[TINTED]] = grey
    coded = cv2.imencode(".jpg", colours, [cv2.IMWRITE_JPEG_QUALITY, 90])[1]
    decoded = np.asarray(cv2.imdecode(coded, cv2.IMREAD_COLOR), np.uint8)
    channel = select_channel(decoded, TINTED)
    assert channel is not None
    return channel


def _cut(picture: GreyImage) -> GreyImage:
    height, width = (round(KEPT_SHARE * size) for size in picture.shape)
    top, left = (picture.shape[0] - height) // 2, (picture.shape[1] - width) // 2
    return _like(picture, picture[top : top + height, left : left + width])


def _like(picture: GreyImage, values: object) -> GreyImage:
    rounded = np.rint(np.asarray(values, np.float64))
    kind = picture.dtype
    clipped = np.clip(rounded, 0, np.iinfo(kind).max)
    return np.ascontiguousarray(clipped.astype(kind))


HARDER: dict[str, Callable[[GreyImage], GreyImage]] = {
    "half size": _scale(0.5),
    "double size": _scale(2.0),
    f"blurred by {BLUR_PX} px": _blur,
    f"{BRIGHTENED:.0f} times as bright": _brighten,
    "tinted": _tint,
    "JPEG 60": _compress(60),
    "JPEG 30": _compress(30),
    "cut": _cut,
}
"""What is done to the grey pictures of a set, by name."""
WIDTH_FACTORS = {"half size": 0.5, "double size": 2.0}
"""Of a line whose width is stated."""

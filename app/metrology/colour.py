"""Colour pictures as one grey channel: that of the laser.

A sum over colours would add the noise and the room's light of channels that the laser does not
reach; the laser's own channel has the line at full contrast.
"""

from typing import Literal, cast

import numpy as np
from numpy.typing import NDArray

from app.metrology.image import Image

LaserColour = Literal["red", "green", "blue"]
PLANES: dict[LaserColour, int] = {"blue": 0, "green": 1, "red": 2}
"""Of a picture in OpenCV's order: blue, green, red, and, where it has one, transparency."""

# Where the colour filters of cameras pass a laser's light best, in nm.
LONGEST_BLUE_NM, LONGEST_GREEN_NM = 495.0, 585.0


def laser_colour(wavelength_nm: float) -> LaserColour:
    """The channel of a colour camera that sees a laser best.

    Example:
        >>> laser_colour(405), laser_colour(532), laser_colour(660)
        ('blue', 'green', 'red')
    """
    if wavelength_nm <= LONGEST_BLUE_NM:
        return "blue"
    return "green" if wavelength_nm <= LONGEST_GREEN_NM else "red"


def is_grey(picture: NDArray[np.uint8] | NDArray[np.uint16]) -> bool:
    """Whether all colours of a picture (H, W, 3 or more) are equal in every pixel."""
    blue, green, red = (picture[..., plane] for plane in range(3))
    return bool(np.array_equal(blue, green) and np.array_equal(green, red))


def select_channel(
    picture: NDArray[np.uint8] | NDArray[np.uint16], colour: LaserColour | None
) -> Image | None:
    """The grey picture (H, W) that a laser is measured in.

    Args:
        picture: (H, W) grey; or (H, W, 3) or (H, W, 4) in OpenCV's order.
        colour: of the laser; None where it is not known.

    Returns:
        The picture itself, the channel that all are equal to, or the one of the laser's colour;
        None for a colour picture where the laser's colour is not known.
    """
    if picture.ndim == 2:
        return picture
    if is_grey(picture):
        return cast(Image, np.ascontiguousarray(picture[..., 0]))
    return (
        None if colour is None else cast(Image, np.ascontiguousarray(picture[..., PLANES[colour]]))
    )

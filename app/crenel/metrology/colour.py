"""The colours of lasers, and the channels of colour cameras that see them."""

from dataclasses import dataclass
from typing import Literal, cast

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.image import Image, saturation_level
from crenel.metrology.robust import sigma_from_median
from crenel.metrology.transforms import Floats

LaserColour = Literal["red", "green", "blue"]
PLANES: dict[LaserColour, int] = {"blue": 0, "green": 1, "red": 2}
"""The planes of a picture in OpenCV's order: blue, green, red, and, where it has one,
transparency."""

# Where the colour filters of cameras pass a laser's light best, in nm.
LONGEST_BLUE_NM, LONGEST_GREEN_NM = 495.0, 585.0
Colours = NDArray[np.uint8] | NDArray[np.uint16]
"""(H, W, 3 or more), blue first."""

LEAST_NOISES = 8.0
"""By which the laser's light must exceed the noise of a channel, in standard deviations."""
LEAST_PIXELS = 50
DARKER = 0.008
"""A share of full scale: where a picture is darker by more, the room's light is off, and it is not
the noise."""
UNLIT_NOISES = 5.0
"""Differences beyond this are no noise."""
ROUNDING_VARIANCE = 1 / 12
LEAST_WEIGHT = 0.01
"""Channels that would count less are left out."""


def laser_colour(wavelength_nm: float) -> LaserColour:
    """The channel of a colour camera that sees a laser best.

    Example:
        >>> laser_colour(405), laser_colour(532), laser_colour(660)
        ('blue', 'green', 'red')
    """
    if wavelength_nm <= LONGEST_BLUE_NM:
        return "blue"
    return "green" if wavelength_nm <= LONGEST_GREEN_NM else "red"


@dataclass(frozen=True)
class ColourWeights:
    """The share of each channel in the sum that is measured; all three together are one."""

    blue: float
    green: float
    red: float

    def sum_channels(self, picture: Colours) -> Image:
        """The weighted sum (H, W), of the picture's type.

        A pixel is clipped where a channel that counts is, and nowhere else.
        """
        weights = np.array([self.blue, self.green, self.red])
        full = max(saturation_level(picture[..., plane]) for plane in range(3))
        total = np.rint(picture[..., :3] @ weights)
        clipped = (picture[..., :3][..., weights > 0] >= full).any(axis=-1)
        total = np.where(clipped, full, np.minimum(total, full - 1))
        return cast(Image, np.ascontiguousarray(total.astype(picture.dtype)))


def find_weights(lit: Colours, unlit: Colours) -> ColourWeights:
    """The weights by which the laser's light exceeds the noise most.

    They are its height over the noise's variance in each channel (a matched filter for channels
    of independent noise). They are never negative, so that the object stays visible.

    Args:
        lit: a picture of the laser's line.
        unlit: the same with the laser off. Where the room is darker in the picture with the
            laser, as in calibration sessions, that picture alone counts.

    Raises:
        OperationError: the pictures differ in size, or the laser is not brighter than the noise.
    """
    if lit.shape != unlit.shape or lit.dtype != unlit.dtype:
        raise OperationError(
            "weights-sizes",
            message("laser-on-off-differ", on=str(lit.shape[:2]), off=str(unlit.shape[:2])),
            message("same-camera-both"),
        )
    levels, before = (one[..., :3].astype(np.float64) for one in (lit, unlit))
    darker = float(np.median(levels - before)) < -DARKER * np.iinfo(lit.dtype).max
    risen = levels - (np.median(levels, axis=(0, 1)) if darker else before)
    variance = np.array([_noise_variance(risen[..., plane]) for plane in range(3)])
    shown = (risen / np.sqrt(variance)).max(axis=-1) >= LEAST_NOISES
    if shown.sum() < LEAST_PIXELS:
        raise OperationError(
            "no-laser-light",
            message("laser-on-not-brighter"),
            message("laser-off-or-covered"),
            message("give-laser-on-off-pair"),
        )
    full = np.array([saturation_level(lit[..., plane]) for plane in range(3)])
    whole = shown & (lit[..., :3] < full).all(axis=-1)
    of_laser = risen[whole if whole.sum() >= LEAST_PIXELS else shown]
    weights = np.maximum(of_laser.mean(axis=0), 0.0) / variance
    weights[weights < LEAST_WEIGHT * weights.sum()] = 0.0
    blue, green, red = (weights / weights.sum()).tolist()
    return ColourWeights(blue, green, red)


def _noise_variance(risen: Floats) -> float:
    """The noise of a pixel, or of its difference between two pictures, where the laser does not
    shine.

    From the values above the median alone: below, a dark picture's noise is cut off at zero.
    """
    above = risen - float(np.median(risen))
    above = above[above > 0]
    if not len(above):
        return ROUNDING_VARIANCE
    spread = sigma_from_median(above)
    noise = above[above <= UNLIT_NOISES * spread]
    return float(np.mean(noise**2)) + ROUNDING_VARIANCE

"""What of a picture is measured: grey as it is, or what a colour camera sees of the laser.

A sum over all colours would add the noise and the room's light of channels that the laser does
not reach; the laser's own channel has the line at full contrast.
"""

from typing import cast

import numpy as np
from numpy.typing import NDArray

from crenel.messages.message import Text, join, message, quantity
from crenel.metrology.bayer import BayerPlane
from crenel.metrology.colour import PLANES, ColourWeights, LaserColour
from crenel.metrology.image import Image

Channel = LaserColour | ColourWeights | BayerPlane
"""A channel of colour pictures, a weighted sum of them, or the pixels of a colour in raw ones."""


def is_grey(picture: NDArray[np.uint8] | NDArray[np.uint16]) -> bool:
    """Whether a picture has one channel, or all its colours are equal in every pixel."""
    if picture.ndim == 2:
        return True
    blue, green, red = (picture[..., plane] for plane in range(3))
    return bool(np.array_equal(blue, green) and np.array_equal(green, red))


def select_channel(
    picture: NDArray[np.uint8] | NDArray[np.uint16], channel: Channel | None
) -> Image | None:
    """The grey picture (H, W) that a laser is measured in; half the size for raw pixels.

    Args:
        picture: (H, W) grey or raw; or (H, W, 3) or (H, W, 4) in OpenCV's order.
        channel: None where the laser's colour is not known.

    Returns:
        A grey picture itself, or the channel that all are equal to; otherwise what ``channel``
        says. None for a colour picture where the laser's colour is not known, or that should be
        raw.
    """
    if is_grey(picture):
        grey = cast(Image, np.ascontiguousarray(picture if picture.ndim == 2 else picture[..., 0]))
        return channel.select(grey) if isinstance(channel, BayerPlane) else grey
    if channel is None or isinstance(channel, BayerPlane):
        return None
    if isinstance(channel, ColourWeights):
        return channel.sum_channels(picture)
    return cast(Image, np.ascontiguousarray(picture[..., PLANES[channel]]))


def describe_channel(channel: Channel) -> Text:
    """In words, for results.

    Example:
        >>> str(describe_channel("red")), str(describe_channel(BayerPlane("RGGB", "green")))
        ('red', 'green pixels of RGGB')
        >>> str(describe_channel(ColourWeights(0.0, 0.25, 0.75)))
        '0.25 green + 0.75 red'
    """
    if isinstance(channel, BayerPlane):
        colour = describe_channel(channel.colour)
        return message("channel-raw", colour=colour, pattern=channel.pattern)
    if isinstance(channel, ColourWeights):
        shares: tuple[tuple[LaserColour, float], ...] = (
            ("blue", channel.blue),
            ("green", channel.green),
            ("red", channel.red),
        )
        parts = [
            message("channel-share", share=quantity(share, "", 2), colour=describe_channel(name))
            for name, share in shares
            if share > 0
        ]
        return join(parts, " + ")
    return message("channel-of-colour", colour=channel)

"""Simulated pictures of a colour camera: a laser's line in a lit room, and raw mosaics of them."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.bayer import BayerPattern
from crenel.metrology.colour import PLANES, LaserColour
from crenel.metrology.transforms import Floats

WIDTH, HEIGHT = 800, 320
LINE, SHOT = 170.0, 0.1
"""The line's height in grey levels, and the noise's variance for each level."""
ROOM: dict[LaserColour, float] = {"blue": 17.0, "green": 25.0, "red": 20.0}
QUIET: dict[LaserColour, float] = {"blue": 2.0, "green": 2.0, "red": 2.0}
LEAK = 0.1
"""Of a laser's light into the channels beside its own."""


def line_rows(u: Floats) -> Floats:
    """The true row of the line in columns."""
    return np.asarray(150 + 40 * np.sin(u / 170) + 0.05 * u)


def render_colours(laser: LaserColour | Mapping[LaserColour, float], width_px: float) -> Floats:
    """(H, W, 3) light, blue first, of a line of a width at half height. ``laser``: its colour, or
    how much each channel sees of it; nothing while it is off."""
    shares: Mapping[LaserColour, float]
    if isinstance(laser, str):
        shares = {name: 1.0 if name == laser else LEAK for name in PLANES}
    else:
        shares = laser
    off = np.arange(HEIGHT)[:, None] - line_rows(np.arange(WIDTH, dtype=np.float64))
    line = LINE * np.exp(-0.5 * (2.3548 * off / width_px) ** 2)
    light = np.zeros((HEIGHT, WIDTH, 3))
    for name, plane in PLANES.items():
        light[..., plane] = ROOM[name] + shares.get(name, 0.0) * line
    return light


def expose(
    light: Floats, seed: int, noise: Mapping[LaserColour, float] = QUIET
) -> NDArray[np.uint8]:
    """A picture of 8 bits with read noise, by channel, and shot noise."""
    rng = np.random.default_rng(seed)
    dark = np.array([noise["blue"], noise["green"], noise["red"]])
    noisy = light + rng.standard_normal(light.shape) * np.sqrt(dark**2 + SHOT * light)
    return np.clip(np.rint(noisy), 0, 255).astype(np.uint8)


def mosaic(colours: NDArray[np.uint8], pattern: BayerPattern) -> NDArray[np.uint8]:
    """The raw picture (H, W): of each pixel, the channel of its filter."""
    raw = np.zeros(colours.shape[:2], np.uint8)
    planes = {"B": PLANES["blue"], "G": PLANES["green"], "R": PLANES["red"]}
    for at, letter in enumerate(pattern):
        place = np.s_[at // 2 :: 2, at % 2 :: 2]
        raw[place] = colours[..., planes[letter]][place]
    return raw

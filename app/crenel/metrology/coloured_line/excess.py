"""How much of a laser's colour each pixel shows beyond its neighbourhood, and the ridges of it.

The room's light has the same ratio between the channels all over a surface, however bright that
is: what exceeds it is another light.
"""

from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.colour import PLANES, LaserColour
from crenel.metrology.robust import sigma_from_median

Levels = NDArray[np.float32]
"""(H, W), of full scale 255."""
SMOOTH_PX, SIDES = (1.0, 2.5, 6.0, 14.0), 4.0
"""Standard deviations by which the picture is smoothed across lines of four widths, and the
distance of the surroundings from a line's middle, in those."""
ALONG_PX = 2.0
RATIO_WINDOW, MOST_RATIO, BLACK = 1 / 8, 4.0, 4.0
"""Neighbourhood of the ratio between channels, in shares of the picture's height; the largest
ratio; grey levels that keep it finite where it is dark."""
CLIPPED, LARGELY, CORE = 250.0, 0.3, 1 / 12
"""Level and share of the pixels from which on a place counts as clipped, and the widest clipped
core, in shares of the picture's height."""
LEAST_NOISE, NOISES, CONTRAST = 0.35, 1.0, 0.3
"""The least noise of a ridge in grey levels; how many deviations do not count; and the weight of a
ridge without colour, against one of the laser's."""
BRIGHTER, OTHERS_DARKER = 0.25, 0.2
"""Light adds: its own channel rises by so much of the excess at least, and the others fall by so
much at most. A thing of that colour takes the others' light away."""
TALLEST_SHARE = 24
"""A picture has so many times the smoothing's rows, at least."""


@dataclass(frozen=True)
class Ridges:
    """What each pixel rises above both of its sides, at the scale that shows most.

    ``score``: (H, W) by the noise, on a logarithmic scale. ``coloured``: the same of colour alone.
    ``smooth_px``: the smoothing.
    """

    score: Levels
    coloured: Levels
    smooth_px: Levels


@dataclass(frozen=True)
class Planes:
    """A picture as the laser's channel, the mean of the others, and the excess; (H, W) each."""

    own: Levels
    others: Levels
    excess: Levels


def split_planes(picture: Levels, colour: LaserColour) -> Planes:
    """The planes of a picture (3, H, W), for a laser of this colour.

    In a clipped core, channels are alike: the excess there is at least that of both its flanks.
    """
    plane = PLANES[colour]
    first, second = (other for other in range(3) if other != plane)
    own, others = picture[plane], (picture[first] + picture[second]) / 2
    size = max(9, round(own.shape[0] * RATIO_WINDOW)) | 1
    ratio = (cv2.blur(own, (size, size)) + BLACK) / (cv2.blur(others, (size, size)) + BLACK)
    excess = own - np.minimum(ratio, MOST_RATIO) * others
    core = max(5, round(own.shape[0] * CORE)) | 1
    filled = cv2.morphologyEx(excess, cv2.MORPH_CLOSE, np.ones((core, 1), np.uint8))
    excess = np.where(own >= CLIPPED, np.maximum(excess, filled), excess)
    return Planes(own, others, excess)


def find_ridges(planes: Planes, smooth_px: tuple[float, ...] = SMOOTH_PX) -> Ridges:
    """The ridges of light of the laser's colour."""
    own = planes.own
    best, coloured, scale = (np.zeros_like(own) for _ in range(3))
    clipped = np.asarray(own >= CLIPPED, np.float32)
    for smooth in smooth_px:
        if TALLEST_SHARE * smooth > own.shape[0]:
            continue
        of_excess, of_own, of_others = (
            _Ridge(levels, smooth) for levels in (planes.excess, own, planes.others)
        )
        is_clipped = cv2.GaussianBlur(clipped, (0, 0), smooth) > LARGELY
        shines = (of_own.rise > BRIGHTER * of_excess.rise) | is_clipped
        shines &= of_others.most > -OTHERS_DARKER * of_excess.rise
        by_colour = np.where(shines, _score(of_excess.rise, of_excess.noise), 0)
        bright = _levels((of_own.rise + 2 * of_others.rise) / 3)
        noise = (of_own.noise + 2 * of_others.noise) / 3
        score = by_colour + CONTRAST * _score(bright, noise)
        better = score > best
        best[better], coloured[better], scale[better] = score[better], by_colour[better], smooth
    return Ridges(best, coloured, scale)


class _Ridge:
    """How far a smoothed picture exceeds its sides."""

    def __init__(self, levels: Levels, smooth: float) -> None:
        middle = _levels(cv2.GaussianBlur(levels, (0, 0), sigmaX=ALONG_PX, sigmaY=smooth))
        off = round(SIDES * smooth)
        padded = _levels(cv2.copyMakeBorder(middle, off, off, 0, 0, cv2.BORDER_REPLICATE))
        up, down = padded[: -2 * off], padded[2 * off :]
        self.rise = middle - np.maximum(up, down)
        """(H, W) above the higher side."""
        self.most = middle - np.minimum(up, down)
        """(H, W) above the lower side."""
        beyond = (middle - (up + down) / 2)[::2, ::2]
        self.noise = max(LEAST_NOISE, sigma_from_median(np.abs(beyond)))


def _score(rise: Levels, noise: float) -> Levels:
    return _levels(np.log1p(np.maximum(rise / noise - NOISES, 0) / 2))


def _levels(array: NDArray[Any]) -> Levels:
    return np.asarray(array, np.float32)

"""Colours of the cells of a map, by what is asked of it."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.colormaps import BALANCE, NO_VALUE, SCALE, Bytes, scale_stops
from crenel.metrology.transforms import Floats

Colour = tuple[int, int, int]
INSIDE: Colour = (0, 140, 104)
OUTSIDE: Colour = (206, 60, 30)
GREYS: tuple[Colour, Colour] = (200, 204, 210), (150, 156, 164)
"""Of undecided cells, each of which has a half of either: so they differ by more than colour."""
UNSCANNED: Colour = (244, 245, 247)
LIGHT = np.array([0.351, -0.451, 0.821])
"""Towards the light, in the arm frame, as of the cloud."""
DARKEST = 0.78
SHADES = 256
ENDS = 2.0
"""The scale of deviations goes to this multiple of the tolerance, so that what is out differs."""
LEAST_U_UM = 1.0
MOSTLY = 0.99
IN, OUT = 0, 1


@dataclass(frozen=True)
class MapColours:
    """A colour of each cell, and what the colours mean."""

    colours: tuple[Colour, ...]
    index: NDArray[np.int64]
    """(C,) into ``colours``."""
    other: NDArray[np.int64]
    """(C,) of the second half of each cell."""
    low_um: float
    high_um: float
    stops: tuple[str, ...]
    """The colours from low to high in CSS notation; none where each has its own meaning."""


def colour_map(
    mode: Literal["deviation", "significance", "uncertainty"],
    deviation_um: Floats,
    standard_uncertainty_um: Floats,
    decisions: NDArray[np.uint8],
    limits_um: tuple[float, float],
) -> MapColours:
    """The colours of cells (C,); in deviation, the scale is the same to either side of zero.

    Uncertainties are expanded ones, k = 2.
    """
    if mode == "significance":
        colours = (INSIDE, OUTSIDE, *GREYS)
        index = np.select([decisions == IN, decisions == OUT], [0, 1], 2)
        other = np.where(index == 2, 3, index)
        return MapColours(colours, index, other, *limits_um, ())
    if mode == "deviation":
        end = ENDS * max(map(abs, limits_um))
        return _by_scale(deviation_um, -end, end, BALANCE)
    expanded = 2 * standard_uncertainty_um
    known = expanded[np.isfinite(expanded)]
    most = float(np.quantile(known, MOSTLY)) if len(known) else 0.0
    return _by_scale(expanded, 0.0, max(most, LEAST_U_UM), SCALE)


def light_up(triangles_mm: Floats, colours: Bytes, R_arm_part: Floats) -> Bytes:
    """Colours (N, 3) of triangles (N, 3, 3) as light from above shows them: the more they are
    turned away, the darker, but so little that a colour is known by its legend."""
    a, b, c = (triangles_mm[:, k] for k in range(3))
    normals = np.cross(b - a, c - a) @ R_arm_part.T
    length = np.linalg.norm(normals, axis=1)
    share = np.abs(normals @ LIGHT) / np.maximum(length, 1e-12)
    brightness = DARKEST + (1 - DARKEST) * share
    return np.asarray(np.rint(brightness[:, None] * colours), np.uint8)


def _by_scale(values: Floats, low: float, high: float, scale: Bytes) -> MapColours:
    at = np.rint(np.linspace(0, len(scale) - 1, SHADES)).astype(np.int64)
    shades = [(int(r), int(g), int(b)) for r, g, b in scale[at]]
    share = np.clip((values - low) / (high - low), 0.0, 1.0)
    is_known = np.isfinite(share)
    index = np.where(is_known, np.rint(np.where(is_known, share, 0.0) * (SHADES - 1)), SHADES)
    index = index.astype(np.int64)
    return MapColours((*shades, NO_VALUE), index, index, low, high, scale_stops(scale))

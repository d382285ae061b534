"""Colour scales of the cloud: perceptually even, and visible on light and dark backgrounds.

Both scales are suitable for red-green blindness: one becomes steadily lighter, the other runs from
blue over light grey to orange.
"""

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats

Bytes = NDArray[np.uint8]

STEPS = 256
NO_VALUE = (150, 156, 164)
"""For points without such a value."""
APART = (92, 100, 112)
"""For points that do not belong to the fitted shape."""
# Björn Ottosson's Oklab, in which equal distances look alike: from linear sRGB to the
# responses of the eye's cones, and from their cube roots to lightness and two hues.
_CONES = np.array(
    [
        [0.4122214708, 0.5363325363, 0.0514459929],
        [0.2119034982, 0.6806995451, 0.1073969566],
        [0.0883024619, 0.2817188376, 0.6299787005],
    ]
)
_OKLAB = np.array(
    [
        [0.2104542553, 0.7936177850, -0.0040720468],
        [1.9779984951, -2.4285922050, 0.4505937099],
        [0.0259040371, 0.7827717662, -0.8086757660],
    ]
)


def oklab(rgb: Floats) -> Floats:
    """Lightness and hues (N, 3) of sRGB colours (N, 3) of 0 to 255."""
    s = np.asarray(rgb, dtype=float) / 255
    linear = np.where(s <= 0.04045, s / 12.92, ((s + 0.055) / 1.055) ** 2.4)
    return np.asarray(np.cbrt(linear @ _CONES.T) @ _OKLAB.T, dtype=float)


def srgb(lab: Floats) -> Floats:
    """The inverse of ``oklab``."""
    linear = (lab @ np.linalg.inv(_OKLAB).T) ** 3 @ np.linalg.inv(_CONES).T
    linear = np.clip(linear, 0, 1)
    s = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return np.asarray(255 * s)


def even_scale(stops: list[tuple[int, int, int]], count: int = STEPS) -> Bytes:
    """Colours (count, 3) through the stops, at equal distances from each other."""
    fine = np.linspace(0, len(stops) - 1, 4001)
    lab = oklab(np.array(stops, dtype=float))
    path = np.column_stack([np.interp(fine, np.arange(len(stops)), column) for column in lab.T])
    way = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))])
    even = np.linspace(0, way[-1], count)
    return np.asarray(
        np.rint(srgb(np.column_stack([np.interp(even, way, column) for column in path.T]))),
        dtype=np.uint8,
    )


SCALE = even_scale([(56, 72, 168), (34, 128, 186), (44, 168, 152), (138, 194, 96), (236, 196, 76)])
"""From little to much."""
_MIDDLE = (196, 198, 194)
BALANCE = np.concatenate(
    [
        even_scale([(24, 70, 190), (74, 142, 220), _MIDDLE], STEPS // 2),
        even_scale([_MIDDLE, (236, 146, 60), (190, 72, 12)], STEPS // 2),
    ]
)
"""From below to above, neutral in the middle."""


def map_colours(values: NDArray[np.floating], low: float, high: float, scale: Bytes) -> Bytes:
    """Colours (N, 3) of values (N,) between two limits; the outermost colours beyond them."""
    known = np.append(scale, [NO_VALUE], axis=0).astype(np.uint8)
    by = (len(scale) - 1) / max(high - low, 1e-9)
    at = (values.astype(np.float64) - low) * by
    np.clip(at, 0, len(scale) - 1, out=at)
    at[~np.isfinite(values)] = len(scale)
    return known.take(at.astype(np.intp), axis=0)


def scale_stops(scale: Bytes, count: int = 17) -> tuple[str, ...]:
    """Some colours of a scale, evenly spaced, in CSS notation."""
    at = np.rint(np.linspace(0, STEPS - 1, count)).astype(int)
    return tuple(f"#{r:02x}{g:02x}{b:02x}" for r, g, b in scale[at].tolist())

"""Where exactly a coloured line is: its centre in every column, on the quietest combination of
channels."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import uniform_filter1d
from scipy.signal import savgol_filter

from crenel.metrology.coloured_line.excess import Levels
from crenel.metrology.robust import sigma_from_median
from crenel.metrology.transforms import Floats

WINDOW_WIDTHS, WINDOW_PX = 1.6, 3
"""The window on both sides of the middle, in widths of the line, and more pixels."""
WEIGHT_WIDTHS, STEPS, GAIN = 0.6, 8, 1.5
"""Standard deviation of the weights, in widths; steps of the centroid, and what they are taken by:
a centroid under weights that are about as wide as the line moves half as far as it should."""
LEAST_HEIGHT = 4.0
FIT_COLUMNS, FIT_ORDER, FIT_SHARE = 21, 2, 0.93
"""Columns through which a quadratic shows the noise of the middle one, and the share of the noise
that it leaves."""
LEAST_SIGMA_PX = 0.02
LONG_COLUMNS, AROUND_COLUMNS, FEWEST_COLUMNS, MOST_PX = 101, 61, 7, 3.0
"""Columns over which a line is a quadratic; those over which the distances from it are averaged;
the fewest of a piece that shows them; and the largest distance that counts."""
UNKNOWN_PX = 1.0
"""The standard deviation of points whose neighbours do not show it."""


@dataclass(frozen=True)
class CentrePoints:
    """Columns (N,) with the line's centre, its height over its surroundings, and its noise."""

    columns: NDArray[np.int64]
    rows: Floats
    height: Floats
    sigma_px: Floats

    scatter_px: float


def measure_line(levels: Levels, place: NDArray[np.int64], width_px: float) -> CentrePoints:
    """The centres of a line in a picture (H, W), near its rows (W,), -1 where there is none."""
    columns = np.flatnonzero(place >= 0)
    reach = int(np.ceil(WINDOW_WIDTHS * width_px)) + WINDOW_PX
    offsets = np.arange(-reach, reach + 1.0)[:, None]
    at = np.clip(place[columns] + offsets.astype(np.int64), 0, levels.shape[0] - 1)
    profile = levels[at, columns].astype(np.float64)
    side = max(2, reach // 3)
    above, below = np.median(profile[:side], axis=0), np.median(profile[-side:], axis=0)
    share = (offsets + reach) / (2 * reach)
    light = np.maximum(profile - above * (1 - share) - below * share, 0)
    centre = np.zeros(len(columns))
    weights = np.ones_like(light)
    for _ in range(STEPS):
        weights = np.exp(-0.5 * ((offsets - centre) / (WEIGHT_WIDTHS * width_px)) ** 2)
        total = (weights * light).sum(axis=0) + 1e-9
        mean = (weights * light * offsets).sum(axis=0) / total
        centre = np.clip(centre + GAIN * (mean - centre), -reach / 2, reach / 2)
    height = (weights * light).sum(axis=0) / weights.sum(axis=0)
    good = (height >= LEAST_HEIGHT / 2) & (np.abs(centre) < reach / 2)
    columns, height = columns[good], height[good]
    rows = place[columns] + centre[good]
    return CentrePoints(columns, rows, height, *_sigma(columns, rows, height))


def _sigma(columns: NDArray[np.int64], rows: Floats, height: Floats) -> tuple[Floats, float]:
    """The standard deviations of points, and their scatter in pixels.

    The noise follows from how neighbouring points scatter, in inverse proportion to their height.
    Edges and texture of the surface pull points aside over longer pieces, all alike: what the line
    is off a longer quadratic counts, too, and what it truly is off it then makes the deviation
    larger, not smaller.
    """
    scatter, total = [], []
    around = np.full(len(rows), UNKNOWN_PX)
    breaks = np.flatnonzero((np.diff(columns) > 1) | (np.abs(np.diff(rows)) > 3)) + 1
    for part in np.split(np.arange(len(columns)), breaks):
        if len(part) >= FEWEST_COLUMNS:
            around[part] = _scatter_around(rows[part])
        if len(part) >= FIT_COLUMNS:
            left = rows[part] - savgol_filter(rows[part], FIT_COLUMNS, FIT_ORDER)
            scatter.append(np.abs(left) * height[part] / FIT_SHARE)
            total.append(np.minimum(np.abs(left), MOST_PX))
    if not scatter:
        return np.full(len(rows), UNKNOWN_PX), np.inf
    noise = np.maximum(sigma_from_median(np.concatenate(scatter)) / height, LEAST_SIGMA_PX)
    return np.maximum(noise, around), float(np.concatenate(total).mean())


def _scatter_around(rows: Floats) -> Floats:
    """Rms distance (N,) of the rows (N,) of a piece, about each of them, from its quadratics."""
    window = min(LONG_COLUMNS, 2 * ((len(rows) - 1) // 2) + 1)
    off = np.minimum(np.abs(rows - savgol_filter(rows, window, FIT_ORDER)), MOST_PX)
    return np.asarray(np.sqrt(uniform_filter1d(off**2, AROUND_COLUMNS, mode="nearest")))

"""The effect of tool marks on an edge: lines that run along it and may be mistaken for it."""

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.detection.edges.stations import EdgeStations, sample_profiles
from crenel.metrology.robust import median
from crenel.metrology.transforms import Floats

# The texture is taken from this many windows of the step's fit on either side.
_WINDOWS = 4
# With fewer places than this along the normals, nothing is known.
_FEWEST = 6
# Gaussian: a step of height a blurred by s has the slope a / (s sqrt(2 pi)).
_ROOT_TWO_PI = 2.5066


def texture(
    image: Floats, at: EdgeStations, step: Floats, blur_px: float
) -> tuple[Floats, NDArray[np.float64]]:
    """Texture along whole parts of edges, relative to the edges' steps, and how far it moves them.

    Marks that run along an edge remain when the picture is averaged along it; noise and marks
    across it do not. What remains beside the edge, narrower than the width of the fit, disturbs the
    step.

    Args:
        image: (H, W) grey levels, NaN at pixels that must not count.
        at: stations; step: (N,) the heights there, NaN or 0 if none was found.
        blur_px: standard deviation of the picture's blur.

    Returns:
        (N,) that ratio for the part of each station, and (N,) the displacement of the part in px,
        one standard deviation; 0 if unknown.
    """
    window = int(np.ceil(2.5 * blur_px + 1.0))
    reach = (_WINDOWS + 1) * window
    along = sample_profiles(image, at.uv_px, at.normal, reach + window)
    offset = np.arange(-reach, reach + 1)
    beside = np.abs(offset) > 2 * window
    clear = window + 2 * blur_px
    free = (
        beside
        & (offset < at.clearance_px[:, :1] - clear)
        & (offset > clear - at.clearance_px[:, 1:])
    )
    ratio, moved = np.zeros(len(at.part)), np.zeros(len(at.part))
    sums = np.cumsum(np.pad(along, ((0, 0), (1, 0))), axis=1)
    trend = (sums[:, 2 * window + 1 :] - sums[:, : -2 * window - 1]) / (2 * window + 1)
    rough = np.where(free, along[:, window:-window] - trend, np.nan)
    for part in np.unique(at.part):
        rows = np.flatnonzero((at.part == part) & np.isfinite(step) & (step != 0.0))
        if len(rows) < 3:
            continue
        there = np.isfinite(rough[rows])
        counts = there.sum(axis=0)
        enough = counts >= max(3, len(rows) // 2)
        if enough.sum() < _FEWEST:
            continue
        values = np.where(there, rough[rows], 0.0)[:, enough]
        mean = values.sum(axis=0) / counts[enough]
        scatter = (values**2).sum(axis=0) / counts[enough] - mean**2
        left = float(np.mean(mean**2 - scatter / (counts[enough] - 1)))
        height = abs(median(step[rows]))
        ratio[rows] = np.sqrt(max(left, 0.0)) / max(height, 1e-9)
        moved[rows] = ratio[rows[0]] * _ROOT_TWO_PI * blur_px
    return ratio, moved

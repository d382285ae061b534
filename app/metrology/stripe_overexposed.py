"""Which clipped pieces belong to the laser's line, and how they join the rest of it."""

import numpy as np
from numpy.typing import NDArray

from app.metrology.frames import Floats
from app.metrology.stripe_choice import in_long_runs
from app.metrology.stripe_flanks import FEWEST_COLUMNS, Cores, FlankFits, averaged
from app.metrology.stripe_kernels import (
    ACROSS,
    ALONG,
    HEIGHT,
    LARGEST_GAP,
    NARROW,
    SPECKLE_LAG,
    STEEPEST,
    UNSURE,
    WIDE,
)
from app.metrology.stripe_scatter import speckle_variance

# Where most of the line is clipped, points dimmer than this share of it are none of it.
DIM = 0.25
# Share of its columns in which a piece of the line must be clipped, and its least length
# in widths of its core.
DENSE, LONG = 0.7, 4
# Columns within which a clipped piece goes on where the rest of the line ends.
JOINING = 8


def of_the_line(cores: Cores, peaks: Floats, shortest: int) -> NDArray[np.bool_]:
    """Which clipped cores (n,) belong to the line, and not to a highlight beside it.

    A track does that is longer than all that is not clipped, or begins or ends where the
    unclipped line ends or begins; and that is several times as long as wide.

    Args:
        peaks: (5, n) what is not clipped, see ``stripe_kernels.measure``.
        shortest: points that make a piece of line.
    """
    ours = np.zeros(len(cores.columns), dtype=np.bool_)
    if len(cores.columns) == 0:
        return ours
    widths = cores.last - cores.first + 1
    wide = (widths > NARROW * cores.width) & (widths < WIDE * cores.width)
    runs = _in_runs(peaks[ALONG], peaks[ACROSS], shortest)
    along, across = peaks[ALONG][runs], peaks[ACROSS][runs]
    middle = (cores.first + cores.last) / 2
    for track in np.unique(cores.track):
        own = np.flatnonzero(cores.track == track)
        span = cores.columns[own[-1]] - cores.columns[own[0]] + 1
        if len(own) < max(DENSE * span, LONG * cores.width):
            continue  # hardly overexposed: the peak is told by what is beside the clipped pixels
        joins = len(own) >= len(along)
        for end in (own[0], own[-1]):
            gap = np.abs(along - cores.columns[end])
            near = (gap <= JOINING) & (np.abs(across - middle[end]) <= STEEPEST * gap)
            joins = joins or bool(near.any())
        ours[own] = joins
    ours &= wide
    return ours if ours.sum() >= FEWEST_COLUMNS else np.zeros_like(ours)


def joined(
    peaks: Floats, flanks: FlankFits, cores: Cores, saturated: float, shortest: int
) -> Floats:
    """The points (4, N) of fitted peaks (5, n) and flanks, in runs only, with deviations."""
    if len(flanks.columns) > peaks.shape[1]:
        peaks = peaks[:, peaks[HEIGHT] > DIM * saturated]
    unclipped = peaks.shape[1]
    along = np.concatenate([peaks[ALONG], flanks.columns.astype(np.float64)])
    across = np.concatenate([peaks[ACROSS], flanks.centre])
    order = np.argsort(along, kind="stable")
    kept = order[_in_runs(along[order], across[order], shortest)]
    clipped = kept >= unclipped
    points = np.empty((4, len(kept)))
    points[ALONG], points[ACROSS], points[HEIGHT] = along[kept], across[kept], saturated
    rest = kept[~clipped]
    points[HEIGHT, ~clipped] = np.minimum(peaks[HEIGHT, rest], saturated)
    known = peaks[UNSURE, rest]
    scatter = speckle_variance(peaks[ALONG, rest], peaks[ACROSS, rest], known, SPECKLE_LAG, 0)
    if clipped.any():
        line = averaged(flanks.chosen(kept[clipped] - unclipped), cores.width)
        unsure = line.variance + line.uneven
        # points that share no column are as far apart as the core is wide
        lag = int(cores.width) + 1
        rough = speckle_variance(points[ALONG, clipped], line.centre, unsure, lag, lag)
        points[ACROSS, clipped], points[UNSURE, clipped] = line.centre, unsure + rough
        # a few points between clipped ones lie on the same rough surface
        scatter = max(scatter, rough)
    points[UNSURE, ~clipped] = known + scatter
    points[UNSURE] = np.sqrt(points[UNSURE])
    return points


def _in_runs(along: Floats, across: Floats, shortest: int) -> NDArray[np.bool_]:
    """Which points (N,) lie in a run of neighbours that is long enough."""
    kept = np.empty(len(along), dtype=np.bool_)
    in_long_runs(along, across, np.zeros(len(along)), LARGEST_GAP, STEEPEST, shortest, kept)
    return kept

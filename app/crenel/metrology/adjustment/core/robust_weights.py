"""The weight of each observation: outliers, scatter beyond the stated uncertainty, shared
errors."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.calibration.observation_model import Rows
from crenel.metrology.robust import sigma_from_median
from crenel.metrology.sensor.residual_correlation import neighbours_alike, variances_of_lines
from crenel.metrology.transforms import Floats

OUTLIER_SIGMAS = 4.5
FEWEST_TO_JUDGE = 12
# Adjacent points are merged into one point, unless they are further apart than this.
BIN_SIZE, APART_PX = 8, 12.0


@dataclass(frozen=True)
class RobustWeights:
    """Mask (N,) of the rows of a kind that agree, and factors (N,) on their standard deviations."""

    inliers: NDArray[np.bool_]
    inflation: Floats


def robust_weights(rows: Rows) -> RobustWeights:
    """Rows against their own scatter; the standard deviations of a line are raised if it scatters
    more than stated, or if adjacent points are correlated (speckle)."""
    off = rows.residuals / rows.sigma
    spread = max(sigma_from_median(np.abs(off)), 1.0) if len(off) else 1.0
    kept = np.abs(off) < OUTLIER_SIGMAS * spread
    if rows.shared is not None:
        return RobustWeights(kept, _line_inflation(rows, rows.shared, off, kept))
    # an error that all points of a line share is not scatter
    about_mean = rows.shared_px > 0.0
    variances = variances_of_lines(off, rows.line, kept, rows.places, about_mean, FEWEST_TO_JUDGE)
    return RobustWeights(kept, np.sqrt(variances))


def _line_inflation(rows: Rows, shared: Floats, off: Floats, kept: NDArray[np.bool_]) -> Floats:
    """Inflation (N,) of rows in whose lines the points share errors."""
    inflation = np.ones(len(off))
    for number in np.unique(rows.line):
        own = (rows.line == number) & kept
        if own.sum() < FEWEST_TO_JUDGE:
            continue
        ways = shared[own] / rows.sigma[own][:, None]
        scatter = off[own] - ways @ (np.linalg.pinv(ways) @ off[own])
        variance = max(float(np.mean(scatter**2)), 1.0)
        variance *= neighbours_alike(rows.places[own], off[own])
        inflation[rows.line == number] = np.sqrt(variance)
    return inflation


@dataclass(frozen=True)
class BinnedPoints:
    """Adjacent points merged into few: pixels (M, 2), standard deviations (M,), and the number of
    each.

    ``first`` (M,) is the start of each group among the points, ``kept`` comes before.
    """

    uv_px: Floats
    sigma_px: Floats
    first: NDArray[np.int64]


def bin_neighbours(
    uv_px: Floats, sigma_px: Floats, line: NDArray[np.int64], judgement: RobustWeights
) -> BinnedPoints:
    """Merges up to ``BIN_SIZE`` adjacent points (N, 2) that count, of one line, into one.

    Over so few points, the image of a line bends by far less than the standard deviation of a
    point, so that their weighted mean is as informative as the points.
    """
    kept = np.flatnonzero(judgement.inliers)
    uv, own = uv_px[kept], line[kept]
    weight = (sigma_px * judgement.inflation)[kept] ** -2.0
    new_line = np.diff(own, prepend=own[:1] - 1) != 0
    apart = np.linalg.norm(np.diff(uv, axis=0, prepend=uv[:1]), axis=1) > APART_PX
    run = np.cumsum(new_line | apart)
    begins = np.flatnonzero(np.diff(run, prepend=0))
    within = np.arange(len(uv)) - begins[run - 1] if len(uv) else np.zeros(0, np.int64)
    first = np.flatnonzero(within % BIN_SIZE == 0)
    if not len(first):
        return BinnedPoints(np.zeros((0, 2)), np.zeros(0), kept)
    total = np.add.reduceat(weight, first)
    mean = np.add.reduceat(uv * weight[:, None], first, axis=0) / total[:, None]
    return BinnedPoints(mean, total**-0.5, kept[first])


def unit_weights(count: int) -> RobustWeights:
    """Merges points that were judged and weighted before."""
    return RobustWeights(np.ones(count, np.bool_), np.ones(count))


def normal_equations(rows: Rows, judgement: RobustWeights) -> tuple[Floats, Floats]:
    """``J' W J`` (K, K) and ``J' W r`` (K,) of rows whose lines share an error.

    The covariance of each line is that of its points plus ``shared_px`` squared for every pair of
    them, or plus that of its ``shared`` errors; its inverse subtracts one row for each of these
    from the sum (Sherman-Morrison, Woodbury).
    """
    kept = judgement.inliers
    J, r = rows.jacobian[kept], rows.residuals[kept]
    weight = (rows.sigma * judgement.inflation)[kept] ** -2.0
    WJ = J * weight[:, None]
    N, g = WJ.T @ J, WJ.T @ r
    if rows.shared is not None:
        line, ways = rows.line[kept], rows.shared[kept]
        for number in np.unique(line):
            own = line == number
            WU = weight[own, None] * ways[own]
            inner = np.linalg.inv(np.eye(ways.shape[1]) + WU.T @ ways[own])
            along = WU.T @ J[own]
            N, g = N - along.T @ inner @ along, g - along.T @ inner @ (WU.T @ r[own])
        return N, g
    if rows.shared_px == 0.0 or not len(r):
        return N, g
    line = rows.line[kept]
    starts = np.flatnonzero(np.diff(line, prepend=line[0] - 1))
    sums = np.add.reduceat(WJ, starts, axis=0)
    pulls = np.add.reduceat(weight * r, starts)
    total = np.add.reduceat(weight, starts)
    share = 1 / (rows.shared_px**-2.0 + total)
    return N - (sums * share[:, None]).T @ sums, g - sums.T @ (share * pulls)

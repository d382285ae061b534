"""Smoothing of a stripe along itself, if the operator chooses it.

About each point, a straight line is fitted to its piece of the stripe, weighted by the points'
variances and by a Gaussian of the distance along the line. Where the points are equally uncertain,
structures of period λ keep exp(-2 (π s / λ)²) of their height, s being the Gaussian's standard
deviation: half of it at λ = 5.3 s. A line bent with radius R moves by s² / 2R towards its centre.

Neighbours share their noise afterwards, as many as ``number_sharing_noise`` says.
"""

import math
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.stripe.points import Stripe
from crenel.metrology.stripe.scales import STEEPEST_PX
from crenel.metrology.transforms import Floats

HALF_HEIGHT_PERIOD = math.pi * math.sqrt(2 / math.log(2))
"""Structures of this period keep half of their height, in standard deviations of the Gaussian."""
LARGEST_GAP = 3
"""Columns that a piece may skip, as in ``runs.c``."""
REACH = 4.0
"""Standard deviations of the Gaussian beyond which nothing counts."""
LEAST_NEIGHBOURS = 1e-12
"""A point whose neighbours count less than this beside it stays as it is."""
SPECKLE_PX = 6.0
"""Columns over which speckle usually moves points alike, as in ``speckle.c``."""
UNLIKE_PX = 12.0
"""Columns after which points share no noise, also under coarse speckle."""
TELLING_PX = 4.0
"""Noise that neighbours share shows after so much smoothing; more would show less of it beside the
line's own shape."""
FEWEST_DIFFERENCES = 60
FOURTH_DIFFERENCE = np.array([1.0, -4.0, 6.0, -4.0, 1.0])
MEDIAN_OF_SQUARE = 0.4549
"""The median of the square of a standard normal deviate."""


def smooth_stripe(stripe: Stripe, smoothing_px: float, saturated: float = math.inf) -> Stripe:
    """The stripe with every point moved onto a line through its neighbours.

    Args:
        stripe: points in ascending order, as extracted.
        smoothing_px: standard deviation of the Gaussian along the line; 0: the stripe as it is.
        saturated: grey level at which pixels are clipped.

    Returns:
        The points of the same columns. Their standard deviations follow from those of the
        neighbours, and from how much more the points scatter than if their noise were independent,
        as under speckle. Points of a clipped core keep theirs: they are smoothed over its width
        already.
    """
    if smoothing_px == 0 or len(stripe.u) == 0:
        return stripe
    along, across = stripe.along_across
    points = _lay_out(along, across, stripe.sigma_px)
    fitted = _fit_lines(points, smoothing_px)
    variance = fitted.variance * _excess_variance(points, fitted, smoothing_px)
    claims_less = (stripe.intensity < saturated) & (variance < stripe.sigma_px**2)
    sigma_px = np.where(claims_less, np.sqrt(variance), stripe.sigma_px)
    if stripe.axis == "u":
        return replace(stripe, v=fitted.across, sigma_px=sigma_px)
    return replace(stripe, u=fitted.across, sigma_px=sigma_px)


def number_sharing_noise(smoothing_px: float) -> float:
    """How many neighbouring points share their noise after smoothing: N of them tell as much of a
    line as N / number independent ones. 1 without smoothing.

    Example:
        >>> number_sharing_noise(0.0), round(number_sharing_noise(2.0), 1)
        (1.0, 7.1)
    """
    return max(1.0, 2 * math.sqrt(math.pi) * smoothing_px)


@dataclass(frozen=True)
class _PiecedPoints:
    """Points of a stripe (N,) and the piece of the line that each belongs to."""

    columns: NDArray[np.int64]
    across: Floats
    sigma_px: Floats
    piece: NDArray[np.int64]


@dataclass(frozen=True)
class _FittedPoints:
    """Where lines about the points pass the points' columns (N,), and the variances that these
    values have if the points' noise is independent."""

    across: Floats
    variance: Floats


def _lay_out(along: Floats, across: Floats, sigma_px: Floats) -> _PiecedPoints:
    columns = np.rint(along).astype(np.int64)
    gap, climb = np.diff(columns), np.abs(np.diff(across))
    is_end = (gap > LARGEST_GAP) | (climb > STEEPEST_PX * gap)
    return _PiecedPoints(columns, across, sigma_px, np.cumsum(np.append(0, is_end)))


@lru_cache(maxsize=64)
def _kernels(smoothing_px: float, reach: int) -> tuple[Floats, Floats]:
    """The Gaussian, and its square, each times the distance to the powers 0, 1 and 2: (3, K)."""
    distance = np.arange(-reach, reach + 1.0)
    gaussian = np.exp(-0.5 * (distance / smoothing_px) ** 2)
    powers = distance ** np.arange(3)[:, None]
    return gaussian * powers, gaussian**2 * powers


def _fit_lines(points: _PiecedPoints, smoothing_px: float) -> _FittedPoints:
    longest = LARGEST_GAP * int(np.bincount(points.piece).max())
    reach = min(math.ceil(REACH * smoothing_px), longest)
    kernels, squared_kernels = _kernels(smoothing_px, reach)
    # in cells of a column each, the pieces so far apart that none reaches into another
    cells = points.columns - points.columns[0] + reach * points.piece
    middle = float(np.mean(points.across))  # small numbers lose no digits
    weight, weighted = np.zeros((2, cells[-1] + 1 + 2 * reach))
    weight[cells + reach] = points.sigma_px**-2.0
    weighted[cells + reach] = weight[cells + reach] * (points.across - middle)
    s0, s1, s2 = (np.correlate(weight, kernel)[cells] for kernel in kernels)
    f0, f1 = (np.correlate(weighted, kernel)[cells] for kernel in kernels[:2])
    q0, q1, q2 = (np.correlate(weight, kernel)[cells] for kernel in squared_kernels)
    determinant = s0 * s2 - s1 * s1
    known = determinant > LEAST_NEIGHBOURS * s0 * s0
    per = 1 / np.where(known, determinant, 1.0)
    across = middle + (s2 * f0 - s1 * f1) * per
    variance = (s2 * s2 * q0 - 2 * s1 * s2 * q1 + s1 * s1 * q2) * per**2
    return _FittedPoints(
        np.where(known, across, points.across), np.where(known, variance, points.sigma_px**2)
    )


def _excess_variance(points: _PiecedPoints, fitted: _FittedPoints, smoothing_px: float) -> float:
    """By how much smoothed points vary more than if the points' noise were independent, at least 1.

    It follows from fourth differences, as in ``speckle.c``, but over lags so large that the
    smoothed points share no noise. A line that is too short for them is taken to be speckled.
    """
    if smoothing_px > TELLING_PX:
        smoothing_px = TELLING_PX
        fitted = _fit_lines(points, smoothing_px)
    sharing = number_sharing_noise(smoothing_px)
    lag = math.ceil(math.hypot(sharing, UNLIKE_PX))
    five = _list_equidistant(points, lag)
    if five.shape[1] < FEWEST_DIFFERENCES:
        return min(sharing, SPECKLE_PX)
    difference = FOURTH_DIFFERENCE @ fitted.across[five]
    expected = FOURTH_DIFFERENCE**2 @ fitted.variance[five]
    return max(1.0, float(np.median(difference**2 / expected)) / MEDIAN_OF_SQUARE)


def _list_equidistant(points: _PiecedPoints, lag: int) -> NDArray[np.int64]:
    """(5, M) indices of points of one piece, one after the other ``lag`` columns apart."""
    columns = points.columns - points.columns[0]
    point_at = np.full(columns[-1] + 1, -1)
    point_at[columns] = np.arange(len(columns))
    starts = np.arange(max(len(point_at) - 4 * lag, 0))
    five = point_at[starts + lag * np.arange(5)[:, None]]
    five = five[:, (five >= 0).all(axis=0)]
    return np.asarray(five[:, points.piece[five[0]] == points.piece[five[4]]])

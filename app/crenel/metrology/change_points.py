"""Change points of a series of measured values: when its mean moved, by how much, how surely."""

import math
from dataclasses import dataclass

import numpy as np
from scipy.special import stdtrit

from crenel.metrology.robust import sigma_from_median
from crenel.metrology.transforms import Floats

LEAST_VALUES = 3
"""The fewest values of a segment: fewer may be outliers."""
STEADY_VALUES = 80
"""Fewer do not tell their own scatter well enough: the penalty is that of so many."""
MOST_VALUES = 4000
CONFIDENCE = 0.95
PENALTY = 4.0
"""Per change, times the variance and the logarithm of the number of values: a change has a place
and a new mean, and is one of many possible ones (modified Bayes information criterion)."""
OUTLIER_SD = 4.0
CORRELATED = 1.645
"""Standard deviations of a correlation without cause: with more, values are taken as correlated."""
MOST_CORRELATION = 0.95
STANDING_OUT_SHARE = 0.05
"""The share of series with normal scatter that have a value that stands out by chance."""


@dataclass(frozen=True)
class ChangePoint:
    """A change of the mean."""

    index: int
    """The index of the first value behind it, the most probable one."""
    first_index: int
    last_index: int
    """The first value behind it is one of these with a probability of 95 %."""
    before: float
    after: float
    """Means of the segments on both sides."""
    standard_uncertainty: float
    """The standard uncertainty of ``after - before``, k = 1."""

    @property
    def size(self) -> float:
        """By how much the mean moved."""
        return self.after - self.before


def find_changes(values: Floats, least_sd: float = 0.0) -> list[ChangePoint]:
    """When the mean of a series changed: none, one or several times.

    Args:
        values: (n,) in the order of time, at most ``MOST_VALUES``. Scatter that is visibly
            correlated from each value to the next counts with the variance that its means have.
        least_sd: standard deviation that a value has by its own uncertainty, at the least.

    Returns:
        The changes in order; empty if one mean explains all values.

    Raises:
        ValueError: there are too many values.

    Source:
        Optimal partitioning: Jackson et al. 2005, IEEE Signal Processing Letters 12(2). Penalty:
        after Zhang and Siegmund 2007, Biometrics 63. The scatter is the median absolute first
        difference, which steps do not widen.

    Example:
        >>> steady = [10.0, 10.1, 9.9, 10.0, 10.1, 9.9]
        >>> moved = [15.0, 15.1, 14.9, 15.0, 15.1, 14.9]
        >>> [found.index for found in find_changes(np.array(steady + moved))]
        [6]
        >>> find_changes(np.array(steady * 2))
        []
    """
    n = len(values)
    if n > MOST_VALUES:
        raise ValueError(f"{n} values, more than {MOST_VALUES}")
    if n < 2 * LEAST_VALUES:
        return []
    sd = working_sd(values, least_sd)
    series = _Series(replace_outliers(values, sd) / sd)
    penalty = PENALTY * np.log(max(n, STEADY_VALUES))
    places = _partition(series, penalty)
    widening = 1.0
    while places and (wider := variance_widening(series.values, places)) > widening:
        widening = wider
        places = _partition(series, penalty * widening)
    series, sd = _Series(series.values / math.sqrt(widening)), sd * math.sqrt(widening)
    bounds = [0, *places, n]
    return [
        _describe(series, sd, begin, index, end)
        for begin, index, end in zip(bounds, bounds[1:], bounds[2:], strict=False)
    ]


def scatter_sd(values: Floats, least_sd: float = 0.0) -> float:
    """Standard deviation of single values about a mean that may move in steps.

    Example:
        >>> round(scatter_sd(np.array([0.0, 1.0, 0.0, 1.0, 100.0, 101.0, 100.0])), 2)
        1.05
    """
    if len(values) < 2:
        return least_sd
    differences = np.abs(np.diff(values))
    return max(sigma_from_median(differences) / math.sqrt(2.0), least_sd)


def working_sd(values: Floats, least_sd: float = 0.0) -> float:
    """As ``scatter_sd``, but never 0: for most values alike, a small part of their range."""
    return scatter_sd(values, least_sd) or max(float(np.ptp(values)), 1.0) * 1e-9


def variance_widening(values: Floats, places: list[int]) -> float:
    """By how much the variance of a mean is larger than that of independent values, because each
    value is similar to the one before; 1 if no such similarity shows.

    Args:
        values: (n,) without outliers.
        places: the first indices behind each change.

    Source:
        First-order autoregression: for example Priestley, Spectral Analysis and Time Series; the
        bias of the correlation after removing means is of the order of 1 / n for each.

    Example:
        >>> variance_widening(np.array([1.0, -1.0] * 10), [])
        1.0
        >>> round(variance_widening(np.sin(np.arange(40) / 3.0), []), 1)
        39.0
    """
    count, segments = len(values), len(places) + 1
    residuals = np.concatenate([one - one.mean() for one in np.split(values, places)])
    variance = float(residuals @ residuals)
    if variance == 0.0:
        return 1.0
    correlation = float(residuals[1:] @ residuals[:-1]) / variance + segments / count
    if correlation * math.sqrt(count) < CORRELATED:
        return 1.0
    correlation = min(correlation, MOST_CORRELATION)
    return (1.0 + correlation) / (1.0 - correlation)


def find_standing_out(values: Floats, means: Floats, sd: float) -> list[int]:
    """The indices of single values that lie far from the mean of their segment.

    Args:
        values, means: (n,)
        sd: their scatter.

    Example:
        >>> find_standing_out(np.array([1.0, 1.2, 9.0, 0.9]), np.ones(4), 0.2)
        [2]
    """
    freedom = max(len(values) / 2.0, 2.0)  # a scatter from a median is as sure as that of a half
    most = -float(stdtrit(freedom, STANDING_OUT_SHARE / 2 / len(values)))
    return [int(one) for one in np.flatnonzero(np.abs(values - means) > most * sd)]


def replace_outliers(values: Floats, sd: float) -> Floats:
    """The values, one or two outliers together replaced by the median of five neighbours.

    Args:
        values: (n,) in the order of time, at least three.
        sd: their scatter.

    Example:
        >>> replace_outliers(np.array([1.0, 1.1, 9.0, 0.9, 1.0]), 0.1).tolist()
        [1.0, 1.1, 1.0, 0.9, 1.0]
    """
    padded = np.pad(values, 2, mode="reflect")
    medians = np.median(np.lib.stride_tricks.sliding_window_view(padded, 5), axis=1)
    return np.where(np.abs(values - medians) > OUTLIER_SD * sd, medians, values)


class _Series:
    """Sums, by which the cost of any segment is known at once; values in units of their scatter."""

    def __init__(self, values: Floats) -> None:
        centred = values - np.median(values)
        self.values = values
        self._sums = np.concatenate([[0.0], np.cumsum(centred)])
        self._squares = np.concatenate([[0.0], np.cumsum(centred**2)])

    def costs(self, begins: "np.ndarray[tuple[int], np.dtype[np.intp]]", end: int) -> Floats:
        """(m,) sums of squared deviations from the mean of each segment up to ``end``."""
        sums = self._sums[end] - self._sums[begins]
        found: Floats = self._squares[end] - self._squares[begins] - sums**2 / (end - begins)
        return found

    def cost(self, begin: int, end: int) -> float:
        return float(self.costs(np.array([begin]), end)[0])


def _partition(series: _Series, penalty: float) -> list[int]:
    """The first indices of all segments but the first, of the partition that costs least."""
    n = len(series.values)
    least = np.full(n + 1, np.inf)
    least[0] = -penalty
    origin = np.zeros(n + 1, int)
    for end in range(LEAST_VALUES, n + 1):
        begins = np.arange(0, end - LEAST_VALUES + 1)
        totals = least[begins] + series.costs(begins, end) + penalty
        origin[end] = int(np.argmin(totals))
        least[end] = totals[origin[end]]
    found: list[int] = []
    begin = int(origin[n])
    while begin > 0:
        found.append(begin)
        begin = int(origin[begin])
    return found[::-1]


def _describe(series: _Series, sd: float, begin: int, index: int, end: int) -> ChangePoint:
    """A change between the two segments that meet at ``index``.

    The means are integrated out, so that each place has the probability of all means there.
    """
    places = np.arange(begin + 1, end)
    costs = np.array([series.cost(begin, int(p)) + series.cost(int(p), end) for p in places])
    log_weights = -0.5 * costs - 0.5 * np.log((places - begin) * (end - places))
    weights = np.exp(log_weights - log_weights.max())
    weights /= weights.sum()
    order = np.argsort(weights)[::-1]
    enough = int(np.searchsorted(np.cumsum(weights[order]), CONFIDENCE)) + 1
    likely = places[order[:enough]]
    before, after = series.values[begin:index], series.values[index:end]
    return ChangePoint(
        index=index,
        first_index=min(int(likely.min()), index),
        last_index=max(int(likely.max()), index),
        before=float(before.mean()) * sd,
        after=float(after.mean()) * sd,
        standard_uncertainty=sd * float(np.sqrt(1 / len(before) + 1 / len(after))),
    )

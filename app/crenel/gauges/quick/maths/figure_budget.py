"""What the uncertainty of a gauge's figure consists of, and what several clouds make of it."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from math import isclose
from typing import Literal

import numpy as np

from crenel.gauges.quick.maths.errors import compute_repeatability

K = 2.0
"""Coverage factor of every expanded uncertainty."""
Source = Literal["gauge", "probe", "points", "clouds"]
"""The gauge and its set-up (the test value uncertainty), the contact points that placed it, the
scatter of the cloud's points, and the scatter of several clouds."""
Budget = Mapping[Source, float]
"""Standard uncertainties (k = 1) in the figure's unit."""
Statistic = Literal["mean", "standard_deviation", "range"]
TWO_SIGMA = 0.97725


@dataclass(frozen=True)
class SpreadStatistic:
    """A statistic of a figure over several clouds."""

    value: float
    budget: Budget


def combine_budget(budget: Budget) -> float:
    """The expanded uncertainty (k = 2): the root of the sum of squares of all sources.

    Example:
        >>> combine_budget({"gauge": 3.0, "points": 4.0})
        10.0
    """
    return K * float(np.linalg.norm([*budget.values()]))


def is_root(expanded_uncertainty: float, budget: Budget) -> bool:
    """Whether an expanded uncertainty is that of its budget."""
    return isclose(expanded_uncertainty, combine_budget(budget), rel_tol=1e-6, abs_tol=1e-9)


def largest_budget(budgets: Sequence[Budget]) -> Budget:
    """That of the largest expanded uncertainty."""
    return max(budgets, key=combine_budget)


def spread_statistics(
    values: Sequence[float], budgets: Sequence[Budget], gauge_range: float = 0.0
) -> dict[Statistic, SpreadStatistic]:
    """Mean, standard deviation and range of a figure over two or more clouds.

    Gauge and probe are common to all clouds: the mean has their uncertainty in full, standard
    deviation and range none of it.

    Args:
        values: of each cloud.
        budgets: of each value.
        gauge_range: what the gauge contributes to the difference of two clouds, k = 1.

    Source:
        GUM, 4.2.3 with G.3.2 for the mean of few; the chi-square distribution for the standard
        deviation.
    """
    from scipy.special import stdtrit  # slow to import, and seldom needed

    over = compute_repeatability(list(values))
    count = len(values)
    points = np.array([budget.get("points", 0.0) for budget in budgets])
    student = float(stdtrit(count - 1, TWO_SIGMA)) / K
    by_points = float(np.linalg.norm(points)) / count
    by_clouds = student * over.standard_deviation / float(np.sqrt(count))
    common: dict[Source, float] = {
        source: max(budget[source] for budget in budgets)
        for source in ("gauge", "probe")
        if source in budgets[0]
    }
    scatter = max(over.standard_deviation, float(np.sqrt(np.mean(points**2))))
    ends = [points[int(np.argmax(values))], points[int(np.argmin(values))]]
    of_range: dict[Source, float] = {"points": float(np.linalg.norm(ends))}
    if gauge_range:
        of_range["gauge"] = gauge_range
    return {
        "mean": SpreadStatistic(over.mean, {**common, "clouds": max(by_points, by_clouds)}),
        "standard_deviation": SpreadStatistic(
            over.standard_deviation, {"clouds": scatter * _reach_of_sd(count)}
        ),
        "range": SpreadStatistic(over.range, of_range),
    }


@cache
def _reach_of_sd(count: int) -> float:
    """Half of how far the true standard deviation may lie from that of so many normal values, as a
    share of the latter, with 95.45 % confidence.

    Few values say little: the distribution is far from normal, and the reach is larger than by the
    GUM's table E.1, with which two to five values cover 69 to 85 %.

    Source:
        The chi-square distribution of a variance, GUM E.4.3.

    Example:
        >>> [round(_reach_of_sd(count), 2) for count in (2, 3, 10)]
        [8.26, 1.82, 0.33]
    """
    from scipy.optimize import brentq
    from scipy.special import chdtr

    free = count - 1

    def covered(reach: float) -> float:
        most = (1 - K * reach) ** -2 if K * reach < 1 else np.inf
        least = (1 + K * reach) ** -2
        return float(chdtr(free, free * most) - chdtr(free, free * least))

    return float(brentq(lambda reach: covered(reach) - (2 * TWO_SIGMA - 1), 1e-6, 1e3))

"""A slope that several groups of values have in common, each with a level of its own."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import stdtrit

from crenel.metrology.transforms import Floats

Ints = NDArray[np.int64]
CONFIDENCE = 0.95


@dataclass(frozen=True, slots=True)
class CommonSlope:
    """How much a value changes for each unit of its argument."""

    value: float
    expanded_uncertainty: float
    """The slope lies within this with a probability of 95 %, if the scatter is independent."""
    values: int
    groups: int
    """Those with two values or more: a group of one tells nothing about the slope."""

    @property
    def is_significant(self) -> bool:
        """Whether chance alone explains it in fewer than 5 % of all cases."""
        return abs(self.value) > self.expanded_uncertainty


def fit_common_slope(arguments: Floats, values: Floats, groups: Ints) -> CommonSlope | None:
    """The slope of straight lines through groups of values, by least squares.

    Args:
        arguments: (n,) such as hours.
        values: (n,) with equal, independent scatter.
        groups: (n,) the number of the group of each value, from 0.

    Returns:
        None if the values do not determine it: there are too few, or the arguments of each group
        are all equal.

    Source:
        Analysis of covariance with one slope, for example Draper and Smith, Applied Regression
        Analysis; the uncertainty by Student's distribution.

    Example:
        >>> import numpy as np
        >>> hours, groups = np.array([0.0, 10.0, 0.0, 10.0, 20.0]), np.array([0, 0, 1, 1, 1])
        >>> found = fit_common_slope(hours, np.array([5.0, 6.0, 8.0, 9.0, 10.0]), groups)
        >>> round(found.value, 3), found.values, found.groups
        (0.1, 5, 2)
    """
    counts = np.bincount(groups)
    sizes = counts[counts > 1]
    if not len(sizes):
        return None
    x = _deviations(arguments, groups, counts)
    y = _deviations(values, groups, counts)
    count = int(sizes.sum())
    freedom = count - len(sizes) - 1
    spread = float(x @ x)
    if freedom < 1 or spread <= 1e-18 * float(np.max(np.abs(arguments)) ** 2) * count:
        return None
    slope = float(x @ y) / spread
    left = y - slope * x
    standard = float(np.sqrt(left @ left / freedom / spread))
    factor = float(stdtrit(freedom, (1 + CONFIDENCE) / 2))
    return CommonSlope(slope, factor * standard, count, len(sizes))


def _deviations(values: Floats, groups: Ints, counts: Ints) -> Floats:
    """From the mean of each value's group: 0 of one that is alone."""
    means = np.bincount(groups, values) / np.maximum(counts, 1)
    return np.asarray(values - means[groups], dtype=np.float64)

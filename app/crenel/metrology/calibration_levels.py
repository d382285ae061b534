"""Levels of a figure by calibration: the error that each calibration has of its own, how far these
errors spread, and which calibrations lie outside."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.special import stdtrit

from crenel.metrology.change_points import (
    LEAST_VALUES,
    find_changes,
    replace_outliers,
    scatter_sd,
)
from crenel.metrology.robust import sigma_from_median
from crenel.metrology.transforms import Floats

Ints = NDArray[np.int64]
LEAST_CALIBRATIONS = 5
"""Fewer do not tell how far calibrations spread."""
LEAST_TESTS = 2.0
"""The fewest tests of a calibration, on average: fewer do not tell its error from the scatter."""
OUTSIDE_SHARE = 0.005
"""How often normal errors of all calibrations put one outside; it is tested many times."""
DOUBTFUL_SHARE = 0.05
"""The same of a calibration that is only worth a look."""
DOUBTFUL_PART = 4
"""At most one of so many is worth a look: a spread that looks uneven would name many."""
STEP_FACTOR = 10.0
"""A step common to all later calibrations shortens the sum of all distances from the median by
1 + this / calibrations at the least: normal errors do so in less than 2 % of all cases."""


@dataclass(frozen=True)
class CalibrationLevels:
    """The errors of the calibrations of one series of values."""

    own_errors: Floats
    """(n,) of the calibration of each value; 0 where it is outside, or unknown."""
    scatter_sd: float
    """The scatter of the values with one calibration."""
    spread_sd: float
    """The spread of the errors of those calibrations that are not outside, k = 1."""
    calibrations: int
    outside: tuple[str, ...]
    """Calibrations further from the others than their errors explain."""
    doubtful: dict[str, float]
    """Calibrations that are far from the others, but not surely outside; and how far."""


def find_calibration_levels(
    values: Floats, calibrations: Sequence[str], outside_share: float = OUTSIDE_SHARE
) -> CalibrationLevels | None:
    """The own error of each calibration, from the values that were measured with it.

    Calibrations outside keep their level, and so does a step that all calibrations from one on have
    in common, or a change while one is in use: none of these is an ordinary error.

    Args:
        values: (n,) in the order of time.
        calibrations: of each value; empty if unknown.
        outside_share: as ``share`` of ``find_outside``.

    Returns:
        None if the values do not tell: there are too few calibrations, or too few values of each.

    Source:
        Generalised extreme studentised deviate test: Rosner 1983, Technometrics 25(2).

    Example:
        >>> levels = np.repeat([3.0, -2.0, 1.0, 40.0, 0.0, -3.0, 2.0, -1.0, 0.5, -0.5], 4)
        >>> values = levels + np.tile([0.1, -0.1, 0.2, -0.2], 10)
        >>> found = find_calibration_levels(values, [f"c{n // 4}" for n in range(40)])
        >>> found.outside, round(found.spread_sd, 1)
        (('c3',), 1.9)
    """
    names = list(dict.fromkeys(one for one in calibrations if one))
    known = np.array([bool(one) for one in calibrations], dtype=bool)
    count = int(known.sum())
    if len(names) < LEAST_CALIBRATIONS or count < LEAST_TESTS * len(names):
        return None
    numbers = {name: number for number, name in enumerate(names)}
    of_value = np.array([numbers.get(one, 0) for one in calibrations], dtype=np.int64)
    plain = replace_outliers(values, max(scatter_sd(values), 1e-12))
    counts = np.bincount(of_value[known], minlength=len(names))
    levels = np.bincount(of_value[known], plain[known], len(names)) / counts
    within = _scatter_within(plain[known], of_value[known], levels, counts)
    _choose_parts(plain[known], of_value[known], levels, counts, within)
    sides = _find_sides(levels)
    residuals = levels - _by_side(levels, sides, np.median)
    freedom = len(levels) - int(sides[-1]) - 1
    outside = find_outside(residuals, freedom, outside_share, (freedom - 1) // 2)
    far = find_outside(residuals, freedom, DOUBTFUL_SHARE, max(freedom // DOUBTFUL_PART, 1))
    doubtful = np.setdiff1d(far, outside)
    ordinary = np.setdiff1d(np.arange(len(names)), outside)
    errors = np.zeros(len(names))
    errors[ordinary] = levels[ordinary] - _by_side(levels[ordinary], sides[ordinary], np.mean)
    variance = float(errors[ordinary] @ errors[ordinary]) / max(freedom - len(outside), 1)
    spread = variance - within**2 * float(np.mean(1.0 / counts[ordinary]))
    return CalibrationLevels(
        np.where(known, errors[of_value], 0.0),
        within,
        float(np.sqrt(max(spread, 0.0))),
        len(names),
        tuple(names[one] for one in outside),
        {names[one]: float(errors[one]) for one in doubtful},
    )


def find_outside(deviates: Floats, freedom: int, share: float, most: int) -> list[int]:
    """The indices of those that the scatter of all others does not explain.

    Args:
        deviates: (m,) with normal scatter about one mean.
        freedom: m less the number of means that were removed.
        share: how often one is found, nominally, if the scatter is that of all. With ten values,
            it is twice as often.
        most: so many can be found, fewer than half of all.

    Example:
        >>> find_outside(np.array([0.3, -0.5, 0.1, 0.4, 12.0, -0.2, 0.6, -0.4]), 7, 0.01, 3)
        [4]
    """
    left = list(range(len(deviates)))
    removed: list[int] = []
    outside = 0
    for number in range(1, most + 1):
        values = deviates[left]
        distances = np.abs(values - values.mean())
        farthest = int(distances.argmax())
        free = freedom - number + 1
        scatter = float(np.sqrt(np.sum((values - values.mean()) ** 2) / free))
        if scatter == 0.0:
            break
        quantile = -float(stdtrit(free - 1, share / (2 * len(left))))
        bound = free * quantile / np.sqrt((free - 1 + quantile**2) * (free + 1))
        removed.append(left.pop(farthest))
        if distances[farthest] > bound * scatter:
            outside = number
    return sorted(removed[:outside])


def _scatter_within(values: Floats, of_value: Ints, levels: Floats, counts: Ints) -> float:
    """Standard deviation of the values with one calibration, from their distances to its level."""
    several = counts[of_value] > 1
    if not several.any():
        return 0.0
    shrunk = np.sqrt(1.0 - 1.0 / counts[of_value][several])
    return sigma_from_median(np.abs(values - levels[of_value])[several] / shrunk)


def _choose_parts(
    values: Floats, of_value: Ints, levels: Floats, counts: Ints, within: float
) -> None:
    """Chooses the level of a calibration while whose use the figure changed: the part nearest to
    the other calibrations."""
    middle = float(np.median(levels))
    indices: dict[int, list[int]] = {}
    for change in find_changes(values - levels[of_value], within):
        span = of_value[change.first_index - 1 : change.last_index + 1]
        if (span == span[0]).all():
            indices.setdefault(int(span[0]), []).append(change.index)
    for calibration, places in indices.items():
        own = np.flatnonzero(of_value == calibration)
        parts = [values[part] for part in np.split(own, np.searchsorted(own, places))]
        nearest = min(parts, key=lambda part: abs(float(part.mean()) - middle))
        levels[calibration], counts[calibration] = nearest.mean(), len(nearest)


def _find_sides(levels: Floats) -> Ints:
    """0 for each level before a step that all behind it have in common, 1 behind; all 0 if there
    is no such step."""
    count = len(levels)
    splits = range(LEAST_VALUES, count - LEAST_VALUES + 1)
    stepped = [(np.arange(count) >= split).astype(np.int64) for split in splits]
    none = np.zeros(count, np.int64)
    best = min(stepped, key=lambda sides: _distances(levels, sides), default=none)
    least = (1.0 + STEP_FACTOR / count) * _distances(levels, best)
    return best if _distances(levels, none) > least else none


def _distances(levels: Floats, sides: Ints) -> float:
    """The sum of all distances from the median of each side."""
    return float(np.abs(levels - _by_side(levels, sides, np.median)).sum())


def _by_side(levels: Floats, sides: Ints, middle: Callable[[Floats], np.floating[Any]]) -> Floats:
    """For each level, the median or mean of its side."""
    found = np.zeros(len(levels))
    for side in np.unique(sides):
        found[sides == side] = middle(levels[sides == side])
    return found

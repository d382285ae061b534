"""How the points of straight lines scatter: beyond what they say, and alike as neighbours."""

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import kernel
from app.metrology.frames import Floats

# Likeness of neighbours is looked for in no fewer points, up to so far along the line, in no
# fewer pairs, until so little of it is left.
_FEWEST, _FURTHEST, _PAIRS, _LEFT = 50, 20, 30, 0.05


@kernel
def neighbours_alike(uv_px: Floats, normalised_residuals: Floats) -> float:
    """How many neighbouring points (N,) carry the information of one: 1 for white noise.

    The sum of the residuals' autocorrelation up to where it has died away. ``uv_px`` (N, 2).
    """
    count = len(normalised_residuals)
    if count < _FEWEST:
        return 1.0
    residuals = normalised_residuals - normalised_residuals.mean()
    power = (residuals**2).mean()
    lag_sum = 1.0
    for lag in range(1, _FURTHEST):
        pairs, products = 0, 0.0
        for i in range(lag, count):
            du, dv = uv_px[i, 0] - uv_px[i - lag, 0], uv_px[i, 1] - uv_px[i - lag, 1]
            if du * du + dv * dv < (2.0 * lag + 1.0) ** 2:
                pairs += 1
                products += residuals[i] * residuals[i - lag]
        if pairs < _PAIRS or products < _LEFT * power * pairs or power == 0.0:
            break
        lag_sum += 2 * products / (pairs * power)
    return lag_sum


@kernel
def variances_of_lines(
    off: Floats,
    line: NDArray[np.int64],
    kept: NDArray[np.bool_],
    places: Floats,
    about_mean: bool,
    fewest: int,
) -> Floats:
    """Variance (N,) of each line's points beside what they say: at least 1, 1 where too few.

    Args:
        off: (N,) residuals over their deviations; line: (N,) the number of each one's line.
        kept: (N,) which of them count; places: (N, 2) pixels they were observed at.
        about_mean: whether what all points of a line share is no scatter.
        fewest: points that tell a line's scatter.
    """
    variances = np.ones(len(off))
    own, at = np.empty(len(off)), np.empty((len(off), 2))
    for number in np.unique(line):
        count = 0
        for i in range(len(off)):
            if kept[i] and line[i] == number:
                own[count], at[count] = off[i], places[i]
                count += 1
        if count < fewest:
            continue
        values = own[:count]
        mean = values.mean() if about_mean else 0.0
        variance = max(((values - mean) ** 2).mean(), 1.0)
        variances[line == number] = variance * neighbours_alike(at[:count], values)
    return variances

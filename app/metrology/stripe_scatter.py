"""What the points of a stripe scatter by beyond the noise of the pixels."""

import numpy as np

from app.metrology.compiled import vector_kernel
from app.metrology.frames import Floats

# The fourth difference of points, and the sum of its squared factors.
TOTAL = 70.0
# The median of a squared standard normal deviate, and the standard deviation of such a
# median of n, times the root of n, in shares of itself.
MEDIAN, CHANCE = 0.4549, 2.33
FEWEST = 30
HALVINGS = 9


@vector_kernel
def number_below(squares: Floats, known: Floats, excused: float, speckle: float) -> int:
    """How many squares lie below the median that they would have with so much speckle."""
    below = 0
    for i in range(len(squares)):
        below += int(squares[i] < MEDIAN * (excused * known[i] + TOTAL * speckle))
    return below


@vector_kernel
def speckle_variance(
    along: Floats, across: Floats, variance: Floats, lag: int, alike: int
) -> float:
    """What the points (N,) scatter by beyond the pixels' noise, in px squared.

    Speckle shifts the light itself and is alike in neighbouring columns, so it shows
    only between points ``lag`` columns apart: the fourth difference over such lags
    of a smooth surface is noise alone. The median is robust to steps and
    texture. Where ``alike`` neighbours share their noise, few points are independent: what
    their median may exceed the known variance by in chance is none.
    """
    n = len(along) - 4 * lag
    if n < FEWEST:
        return 0.0
    squares, known = np.empty(n), np.empty(n)
    found = 0
    for i in range(n):
        j, k, m, o = i + lag, i + 2 * lag, i + 3 * lag, i + 4 * lag
        whole = along[o] - along[i] == 4 * lag
        fourth = across[i] + across[o] - 4 * (across[j] + across[m]) + 6 * across[k]
        own = variance[i] + variance[o] + 16 * (variance[j] + variance[m]) + 36 * variance[k]
        # over a gap there is no difference; it is never below anything
        squares[i] = fourth * fourth if whole else np.inf
        known[i] = own if whole else 0.0
        found += int(whole)
    if found < FEWEST:
        return 0.0
    # a scatter that chance may give is none
    excused = 1 + CHANCE * np.sqrt(alike / found)
    if 2 * number_below(squares, known, excused, 0.0) >= found:
        return 0.0
    low, high = 0.0, float(np.sum(known)) / found / TOTAL
    while 2 * number_below(squares, known, 1.0, high) < found:
        low, high = high, 4 * high
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        if 2 * number_below(squares, known, 1.0, middle) >= found:
            high = middle
        else:
            low = middle
    return 0.5 * (low + high)

"""Contact points that contradict the others: those without which the rest agrees best.

Equations are whitened: residuals and their Jacobian are divided by the standard deviations.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.metrology.transforms import Floats

OUTLIER_SIGMAS = 4.0
LEAST_REDUNDANCY = 1e-7
"""A contact point that the others determine less than this is not judged."""


@dataclass(frozen=True)
class OutlierRows:
    """Rows that contradict the others, or of which one does and the data cannot tell which."""

    rows: tuple[int, ...] = ()
    doubtful: tuple[int, ...] = ()


def find_outliers(J: Floats, residuals: Floats) -> OutlierRows:
    """The one or two rows whose removal explains most of the residuals (N,), if any.

    The sum of squares without one row or two is exact for linear equations, so every choice is
    compared: neither two outliers that hide each other nor a good row with much leverage mislead.
    Rows are named only if each is needed and no other choice explains nearly as much.
    """
    count, unknowns = J.shape
    Q = np.linalg.svd(J, full_matrices=False)[0]
    redundancy = np.eye(count) - Q @ Q.T
    off = redundancy @ residuals
    own = np.diag(redundancy)
    alone = np.where(own > LEAST_REDUNDANCY, off**2 / np.maximum(own, LEAST_REDUNDANCY), 0.0)
    total = float(off @ off)
    both = _gains_of_pairs(redundancy, off)
    one = _judge_one(alone, total, count - unknowns - 1)
    i, j = np.unravel_index(int(np.argmax(both)), both.shape)
    if _is_pair(alone, both, (int(i), int(j)), total, count - unknowns - 2):
        return OutlierRows(rows=(int(i), int(j)))
    return one


def limit_of(freedom: int) -> float:
    """The square of a studentised residual beyond which a row contradicts ``freedom`` others.

    Student's t has heavier tails than the normal distribution if few contact points remain.
    """
    return (OUTLIER_SIGMAS * (1 + 4.0 / freedom)) ** 2


def _judge_one(alone: Floats, total: float, freedom: int) -> OutlierRows:
    if freedom < 1:
        return OutlierRows()
    best = int(np.argmax(alone))
    # whitened residuals are never smaller than the noise that the contact points have
    variance = max((total - alone[best]) / freedom, 1.0)
    limit = limit_of(freedom) * variance
    if alone[best] <= limit:
        return OutlierRows()
    rivals = np.flatnonzero(alone > alone[best] - limit)
    return (
        OutlierRows((best,)) if len(rivals) == 1 else OutlierRows(doubtful=tuple(map(int, rivals)))
    )


def _is_pair(
    alone: Floats, both: Floats, pair: tuple[int, int], total: float, freedom: int
) -> bool:
    """Two rows contradict all others: each is needed beside the other, and no other two do."""
    if freedom < 2:
        return False
    gain = both[pair]
    limit = limit_of(freedom) * max((total - gain) / freedom, 1.0)
    others = both.copy()
    others[pair] = others[pair[::-1]] = 0.0
    needed = gain - max(alone[pair[0]], alone[pair[1]]) > limit
    return bool(needed and gain - others.max() > limit)


def _gains_of_pairs(redundancy: NDArray[np.float64], off: Floats) -> Floats:
    """(N, N) by how much the sum of squares falls without both rows."""
    own = np.diag(redundancy)
    determinant = np.outer(own, own) - redundancy**2
    known = determinant > LEAST_REDUNDANCY * np.maximum(np.outer(own, own), LEAST_REDUNDANCY)
    products = np.outer(off**2, own)
    gain = products + products.T - 2 * np.outer(off, off) * redundancy
    return np.where(known, gain / np.where(known, determinant, 1.0), 0.0)

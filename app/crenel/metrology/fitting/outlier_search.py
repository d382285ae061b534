"""Points that contradict the others: the one or two without which the rest agrees best.

One search for all that is touched: the faces of a block, planes, spheres, boards, seats and bars.
Residuals and derivatives are whitened: divided by the least standard deviation that a point has.
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats

FALSE_ALARMS = 1e-3
"""Share of the sets without an outlier in which one is found."""
LEAST_REDUNDANCY = 1e-7
"""A point that the others determine less than this is not judged."""
RANK = 1e-9
"""Share of the largest singular value below which one counts as zero."""
LEAST_FREEDOM, ENOUGH = 1.9, 6.0
"""Degrees of freedom that must be left where a point is named: two agree by chance seldom enough.
So many show by themselves how much the points scatter."""
USUAL_SHARE, PRIOR_FREEDOM = 1 / 9, 2.0
"""The usual share of the largest variance, and its freedom: fewer points that scatter by more may
hide another outlier. It counts like so many degrees of freedom."""
MOST_IN_PAIRS = 60
"""Pairs are sought among so many points, those that explain most alone."""

Mask = NDArray[np.bool_]


@dataclass(frozen=True)
class Outliers:
    """Points that contradict the others, and those of which one does while nothing tells which."""

    points: tuple[int, ...] = ()
    doubtful: tuple[int, ...] = ()


@dataclass(frozen=True, eq=False)
class Disagreement:
    """How N points of ``size`` rows each disagree at the best fit to all of them."""

    information: Floats
    """(N size, N size) inverse covariance of the rows before the fit: a projection where nothing
    but the points determines the unknowns."""
    off: Floats
    """(N size,) the information times these rows: the residuals after the fit."""
    size: int = 1
    most: float = np.inf
    """Largest variance that a row may have."""
    elsewhere: float = 0.0
    """Degrees of freedom by which other data show that the variance is 1."""
    alarms: float = FALSE_ALARMS
    """Share of the sets without an outlier in which one is found."""

    @property
    def count(self) -> int:
        return len(self.off) // self.size


def disagreement(
    J: Floats, residuals: Floats, size: int = 1, most: float = np.inf, given: int = 0
) -> Disagreement:
    """What linear equations leave.

    Args:
        J: (M, U) whitened derivatives, point by point.
        residuals: (M,) whitened, at any state.
        size: rows of a point.
        most: largest variance that a row may have.
        given: the last rows so many are no points: they are never outliers.
    """
    U, s, _ = np.linalg.svd(J, full_matrices=False)
    Q = U[:, s > RANK * s.max(initial=0.0)]
    own = slice(0, len(J) - given)
    information = np.eye(len(J)) - Q @ Q.T
    return Disagreement(information[own, own], (information @ residuals)[own], size, most)


def find_outlier_points(found: Disagreement) -> Outliers:
    """The one or two points whose removal explains most of the residuals, if any.

    The sum of squares without one point or two is exact for linear equations, so every choice is
    compared: neither two outliers that hide each other nor a good point with much leverage mislead.
    Points are named only if each is needed and no other choice explains nearly as much; of the
    other choices, one is the right one, and nothing tells which.
    """
    freedom = float(np.trace(found.information))
    total = float(found.off @ np.linalg.pinv(found.information, RANK, hermitian=True) @ found.off)
    alone = _gains(found, np.arange(found.count)[:, None])
    limit, explained = _judge(found, total - alone.max(initial=0.0), freedom - found.size)
    foremost = np.sort(np.argsort(-alone, kind="stable")[:MOST_IN_PAIRS])
    pairs = np.array(list(combinations(foremost, 2)), dtype=np.int64).reshape(-1, 2)
    both = _gains(found, pairs)
    if len(both):
        of_pairs, agrees = _judge(found, total - both.max(), freedom - 2 * found.size)
        if both.max() - alone.max() > of_pairs:
            chosen = pairs[both > both.max() - of_pairs]
            return _choose(chosen, agrees, found.count)
    if not alone.max(initial=0.0) > limit:
        return Outliers()
    return _choose(np.flatnonzero(alone > alone.max() - limit)[:, None], explained, found.count)


def _choose(choices: NDArray[np.int64], explained: bool, count: int) -> Outliers:
    """What all choices (C, 1 or 2) have in common is certain, the rest is in doubt."""
    if not explained:  # more is wrong than these
        return Outliers(doubtful=tuple(range(count)))
    every = [set(map(int, choice)) for choice in choices]
    common, any_of = set.intersection(*every), set.union(*every)
    return Outliers(tuple(sorted(common)), tuple(sorted(any_of - common)))


def _gains(found: Disagreement, choices: NDArray[np.int64]) -> Floats:
    """(C,) by how much the sum of squares falls without the points of each choice (C, k)."""
    rows = (choices[:, :, None] * found.size + np.arange(found.size)).reshape(len(choices), -1)
    own = found.information[rows[:, :, None], rows[:, None, :]]
    off = found.off[rows]
    if not own.size:
        return np.zeros(len(choices))
    values, vectors = np.linalg.eigh(own)
    along = np.einsum("cij,ci->cj", vectors, off)
    known = values > LEAST_REDUNDANCY
    return np.asarray(np.sum(np.where(known, along**2 / np.where(known, values, 1.0), 0.0), axis=1))


def _judge(found: Disagreement, rest: float, freedom: float) -> tuple[float, bool]:
    """The gain beyond which a point contradicts the others, whose sum of squares is ``rest``; and
    whether they agree by themselves."""
    squares, known, share = rest + found.elsewhere, freedom + found.elsewhere, found.alarms
    limit = contradiction_limit(found.count, found.size, squares, known, found.most, share)
    if freedom >= ENOUGH or np.isinf(found.most):
        return limit, True
    if freedom < LEAST_FREEDOM:
        return limit, False
    from scipy.special import chdtri  # slow to import, and seldom needed

    return limit, rest <= float(chdtri(freedom, FALSE_ALARMS)) * found.most * USUAL_SHARE


def contradiction_limit(
    count: int,
    size: int,
    rest: float,
    freedom: float,
    most: float = np.inf,
    alarms: float = FALSE_ALARMS,
) -> float:
    """The square of a studentised deviation that one of ``count`` points exceeds by chance in a
    share ``alarms`` of all sets.

    The variance of a row is at least 1 and at most ``most``; in between the others say it, by their
    sum of squares ``rest`` with its degrees of freedom, and of few what is usual.
    """
    from scipy.special import chdtri, fdtri  # slow to import, and seldom needed

    share = alarms / max(count, 1)
    normal = float(chdtri(size, share))
    if freedom < 1:
        return normal * most

    def student(known: float, squares: float) -> float:
        return size * float(fdtri(size, known, 1 - share)) * squares / known

    rest = max(rest, 0.0)
    limit = min(student(freedom, rest), normal * most)
    if np.isfinite(most):
        usual = PRIOR_FREEDOM * max(USUAL_SHARE * most, 1.0)
        limit = min(limit, student(freedom + PRIOR_FREEDOM, rest + usual))
    return max(normal, limit)


@dataclass(frozen=True, eq=False)
class Agreement:
    """(N,) points that agree, and (N,) those of which one does not while nothing tells which."""

    kept: Mask
    doubtful: Mask


def find_agreement(
    equations: Callable[[Mask], tuple[Floats, Floats]],
    start: Mask,
    allowed: Mask,
    most: float = np.inf,
    given: int = 0,
) -> Agreement:
    """The points that agree, of those (N,) that are allowed.

    At the best fit to the points that are kept, at first to those of the ``start``, all are judged.
    If more than two disagree with it, those that are kept are judged first, and others return one
    by one that agree after all.

    Args:
        equations: whitened derivatives (N + given, U) and residuals (N + given,) of all points at
            the best fit to some of them (N,), the given rows last.
        most: largest variance that a residual may have.
    """
    kept, rows = start.copy(), np.arange(len(start), len(start) + given)
    found = Outliers()
    for _ in range(2 * len(start)):
        J, residuals = equations(kept)
        few_out = (allowed & ~kept).sum() <= 2
        judged = np.flatnonzero(allowed if few_out else kept)
        own = np.concatenate([judged, rows])
        found = find_outlier_points(disagreement(J[own], residuals[own], 1, most, given))
        agreeing = None if few_out else _agreeing_again(J, residuals, kept, allowed, most)
        again = allowed & (few_out | kept)
        again[judged[list(found.points)]] = False
        if agreeing is not None and not (found.points or found.doubtful):
            again[agreeing] = True
        if np.array_equal(again, kept):
            break
        kept = again
    doubtful = np.isin(np.arange(len(start)), judged[list(found.doubtful)])
    return Agreement(kept, doubtful)


def _agreeing_again(
    J: Floats, residuals: Floats, kept: Mask, allowed: Mask, most: float
) -> int | None:
    """The removed point that the others predict best, if it lies within their scatter."""
    count = len(kept)
    rows = np.concatenate([kept, np.ones(len(J) - count, np.bool_)])
    freedom = int(rows.sum()) - J.shape[1]
    if freedom < 1 or kept[allowed].all():
        return None
    rest = float(residuals[rows] @ residuals[rows])
    covariance = np.linalg.pinv(J[rows].T @ J[rows])
    spread = 1 + np.einsum("ij,jk,ik->i", J[:count], covariance, J[:count])
    off = np.where(kept | ~allowed, np.inf, residuals[:count] ** 2 / spread)
    best = int(np.argmin(off))
    limit = contradiction_limit(count, 1, rest, freedom, most)
    return best if off[best] < limit / 2 else None

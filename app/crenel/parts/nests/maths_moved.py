"""What has moved between two rounds of touches of the same nests, by hypotheses and chi-square."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from scipy.special import gammaincc

from crenel.metrology.transforms import Floats, nearest_rotation, se3_exp, skew

Culprit = Literal["nothing", "nest", "part", "all"]
REFUTED, TENABLE = 1e-3, 1e-2
"""Chances: what is less likely than the first is refuted, what is likelier than the other can hold.

A right hypothesis is then missed in one check of a hundred; one of a thousand is a false alarm.
"""
LEAST_NESTS = 3
ROUNDS = 20


@dataclass(frozen=True)
class Hypothesis:
    """What may have moved, and how well it explains the shifts of all nests.

    ``nests`` are those that moved; ``chance`` is that of a chi-square as large or larger.
    """

    culprit: Culprit
    nests: tuple[int, ...]
    parameters: int
    chi_square: float
    freedom: int

    @property
    def chance(self) -> float:
        return float(gammaincc(self.freedom / 2, self.chi_square / 2))


def compare_hypotheses(
    before_mm: Floats, after_mm: Floats, covariance: Floats, part: Sequence[int] = ()
) -> list[Hypothesis]:
    """All hypotheses that the nests can tell apart, the simplest first.

    Args:
        before_mm, after_mm: (K, 3) places of the nests.
        covariance: (3K, 3K) of the shifts, place by place.
        part: numbers of the nests on the part; the others are on the base.
    """
    count = len(before_mm)
    everything = tuple(range(count))
    found = [_explain(before_mm, after_mm, covariance, "nothing", ())]
    if count > LEAST_NESTS - 1:
        found += [_explain(before_mm, after_mm, covariance, "nest", (k,)) for k in everything]
    if 2 <= len(part) < count:
        found.append(_explain(before_mm, after_mm, covariance, "part", tuple(part)))
    if count >= LEAST_NESTS:
        found.append(_explain(before_mm, after_mm, covariance, "all", everything))
    return sorted((one for one in found if one.freedom > 0), key=lambda one: one.parameters)


def choose_hypothesis(hypotheses: Sequence[Hypothesis]) -> Hypothesis | None:
    """The one that holds: likely enough, with all others that are as simple or simpler refuted.

    None: something has moved, and nothing says what.
    """
    nothing = hypotheses[0]
    if nothing.chance >= REFUTED:
        return nothing
    for one in hypotheses:
        simpler = [
            other for other in hypotheses if other is not one and other.parameters <= one.parameters
        ]
        if one.chance > TENABLE and all(other.chance < REFUTED for other in simpler):
            return one
    return None


def rigid_motion(before_mm: Floats, after_mm: Floats, weight: Floats) -> tuple[Floats, int]:
    """The motion (4, 4) of points (K, 3) by weighted least squares, and how much of it they fix.

    Args:
        weight: (3K, 3K) inverse covariance of the shifts.
    """
    a, b = before_mm - before_mm.mean(axis=0), after_mm - after_mm.mean(axis=0)
    T = np.eye(4)
    T[:3, :3] = nearest_rotation(b.T @ a)
    T[:3, 3] = after_mm.mean(axis=0) - T[:3, :3] @ before_mm.mean(axis=0)
    rank = 6
    for _ in range(ROUNDS):
        moved = before_mm @ T[:3, :3].T + T[:3, 3]
        middle = moved.mean(axis=0)
        J = np.concatenate([np.hstack([-skew(one - middle), np.eye(3)]) for one in moved])
        N = J.T @ weight @ J
        scale = 1 / np.sqrt(np.maximum(np.diag(N), 1e-30))
        values, axes = np.linalg.eigh(N * np.outer(scale, scale))
        good = values > 1e-9 * values.max()
        rank = int(good.sum())
        pull = axes.T @ (scale * (J.T @ weight @ (after_mm - moved).ravel()))
        step = scale * (axes[:, good] @ (pull[good] / values[good]))
        about = np.eye(4)
        about[:3, 3] = middle
        back = np.eye(4)
        back[:3, 3] = -middle
        T = about @ se3_exp(step) @ back @ T
        if np.abs(step).max() < 1e-10:
            break
    return T, rank


def _explain(
    before_mm: Floats,
    after_mm: Floats,
    covariance: Floats,
    culprit: Culprit,
    moved: tuple[int, ...],
) -> Hypothesis:
    """One hypothesis: the nests that moved are free, or move as one body; the others stay."""
    count = len(before_mm)
    off = (after_mm - before_mm).ravel()
    if culprit == "nest":
        rest = np.setdiff1d(np.arange(3 * count), 3 * moved[0] + np.arange(3))
        off, covariance = off[rest], covariance[np.ix_(rest, rest)]
        return Hypothesis(culprit, moved, 3, _chi_square(off, covariance), len(off))
    parameters = 0
    if moved:
        some = list(moved)
        rows = (3 * np.array(some)[:, None] + np.arange(3)).ravel()
        rest = np.setdiff1d(np.arange(3 * count), rows)
        # those that stayed tell what the others share with them
        given = covariance[np.ix_(rows, rest)] @ np.linalg.pinv(covariance[np.ix_(rest, rest)])
        own = covariance[np.ix_(rows, rows)] - given @ covariance[np.ix_(rest, rows)]
        target = after_mm[some] - (given @ off[rest]).reshape(-1, 3)
        weight = np.asarray(np.linalg.inv((own + own.T) / 2))
        T, parameters = rigid_motion(before_mm[some], target, weight)
        expected = before_mm[some] @ T[:3, :3].T + T[:3, 3]
        off = off.copy()
        off[rows] = (after_mm[some] - expected).ravel()
    freedom = 3 * count - parameters
    return Hypothesis(culprit, moved, parameters, _chi_square(off, covariance), freedom)


def _chi_square(off: Floats, covariance: Floats) -> float:
    return float(off @ np.linalg.solve(covariance, off))

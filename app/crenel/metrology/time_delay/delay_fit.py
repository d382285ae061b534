"""Maximum-likelihood fit of the delay's course and the plane to the lines of a pass."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.arm.reading_interpolation import Stamps
from crenel.metrology.robust import huber_weights, sigma_from_median
from crenel.metrology.time_delay.course import CourseShape
from crenel.metrology.time_delay.plane_pass import StripeLines
from crenel.metrology.transforms import Floats

CHORD_NS = 10_000_000
"""Velocities are estimated over this time before and after. The encoder noise at the time of the
frame then does not contribute to them, so that it cannot bias the delay."""
STEPS, STEP_NS, FARTHEST_STEP_NS = 40, 500.0, 20e6
HUBER = 2.0
SINGULAR = 1e-9

PosesAt = Callable[[Stamps], Floats]


@dataclass(frozen=True)
class DelayHypothesis:
    """Course of the delay, and plane, ``normal . x = offset_mm``."""

    shape: CourseShape
    values: Floats
    """(m,) of the shape's terms."""
    normal: Floats
    offset_mm: float

    def delays_ns(self, stamps_ns: Stamps) -> Stamps:
        """(F,) of frames with these time stamps."""
        return np.rint(self.shape.basis(stamps_ns) @ self.values).astype(np.int64)


@dataclass(frozen=True)
class DelayEstimate(DelayHypothesis):
    """Further results of the fit."""

    covariance: Floats
    """(m, m) of the values; infinite if the pass does not determine them at all."""
    rows: "PlaneConditions"
    weight: Floats
    """(2F,) of the conditions."""
    speed_mm_s: float
    """Rms speed, in any direction."""

    @property
    def uncertainties(self) -> Floats:
        """(m,) standard uncertainties (k = 1)."""
        return np.sqrt(np.diag(self.covariance))

    @property
    def across_mm_s(self) -> Floats:
        """(F,) velocity of the line perpendicular to the plane."""
        return self.rows.slope_mm_s[: len(self.rows.velocity)]


@dataclass(frozen=True)
class PlaneConditions:
    """The plane's condition on the centre and the end of each line, linearised."""

    known: NDArray[np.bool_]
    """Lines with a known pose: F of them are True."""
    off_mm: Floats
    """(2F,) distances from the plane: first all centres, then all ends."""
    slope_mm_s: Floats
    """(2F,) their derivatives by the delay of the frame."""
    J: Floats
    """(2F, P) by the values of the course, and then by the plane and the terms of the height."""
    tangents: Floats
    """(2, 3) directions in which the normal tilts."""
    velocity: Floats
    """(F, 3) velocities of the centres, mm/s."""


def fit_delay(lines: StripeLines, poses_at: PosesAt, start: DelayHypothesis) -> DelayEstimate:
    """The delay by Gauss-Newton from start values; outlying frames have less weight (Huber).

    The spread of centres and of ends about the plane is estimated from themselves, but is at least
    that due to the uncertainty of the points. The standard uncertainty includes errors that
    adjacent frames share (a covariance of the score, with Bartlett's weights over half the time
    between two reversals).
    """
    fit, m = start, len(start.values)
    basis = start.shape.basis(lines.stamps_ns)
    for _ in range(STEPS):
        rows = _plane_conditions(lines, poses_at, fit)
        weight = _weights(rows.off_mm, lines.variance[rows.known])
        root = np.sqrt(weight)
        size = _column_sizes(rows.J)
        A = root[:, None] * rows.J / size
        step = np.linalg.lstsq(A, -root * rows.off_mm, rcond=SINGULAR)[0] / size
        normal = fit.normal + step[m : m + 2] @ rows.tangents
        length = float(np.linalg.norm(normal))
        farthest_ns = float(np.abs(basis @ step[:m]).max())
        # far from the solution, a step may exceed the range of the chords
        change = step[:m] * min(1.0, FARTHEST_STEP_NS / max(farthest_ns, 1.0))
        fit = DelayHypothesis(
            fit.shape,
            fit.values + change,
            normal / length,
            (fit.offset_mm + step[m + 2]) / length,
        )
        if farthest_ns < STEP_NS:
            break
    return DelayEstimate(
        fit.shape,
        fit.values,
        fit.normal,
        fit.offset_mm,
        _covariance(rows, weight, m),
        rows,
        weight,
        float(np.sqrt(np.mean(np.sum(rows.velocity**2, axis=1)))),
    )


def _plane_conditions(
    lines: StripeLines, poses_at: PosesAt, fit: DelayHypothesis
) -> PlaneConditions:
    """The linearised condition for frames with a known pose."""
    at_ns = lines.stamps_ns + fit.delays_ns(lines.stamps_ns)
    T, before, after = (poses_at(at_ns + off) for off in (0, -CHORD_NS, CHORD_NS))
    known = np.asarray(np.isfinite(T + before + after).all(axis=(1, 2)))
    T, change = T[known], (after - before)[known] / (2e-9 * CHORD_NS)
    centre, half, height = lines.centre_mm[known], lines.half_mm[known], lines.height[known]
    at = np.einsum("nij,nj->ni", T[:, :3, :3], centre) + T[:, :3, 3]
    end = np.einsum("nij,nj->ni", T[:, :3, :3], half)
    velocity = np.einsum("nij,nj->ni", change[:, :3, :3], centre) + change[:, :3, 3]
    turning = np.einsum("nij,nj->ni", change[:, :3, :3], half)
    n, ones = fit.normal, np.ones(len(at))
    tangents = np.linalg.svd(n[None])[2][1:]
    slope_mm_s = np.concatenate([velocity @ n, turning @ n])
    basis, m = fit.shape.basis(lines.stamps_ns[known]), len(fit.values)
    J = np.zeros((2 * len(at), m + 5))
    J[:, :m] = 1e-9 * slope_mm_s[:, None] * np.concatenate([basis, basis])
    J[:, m : m + 2] = np.concatenate([at, end]) @ tangents.T
    J[: len(at), m + 2 :] = np.column_stack([-ones, height, height**2])
    off = np.concatenate([at @ n - fit.offset_mm, end @ n])
    return PlaneConditions(known, off, slope_mm_s, J, tangents, velocity)


def _weights(off_mm: Floats, variance: Floats) -> Floats:
    """(2F,) weights of centres and ends, by the spread of each, reduced for outliers."""
    found = []
    for off in np.split(off_mm, 2):
        # the terms of the plane and of the height leave the spread's centre at zero
        spread = sigma_from_median(np.abs(off)) ** 2
        scale = np.sqrt(np.maximum(spread, variance))
        far = np.abs(off) / scale
        found.append(huber_weights(far, HUBER) / scale**2)
    return np.concatenate(found)


def _column_sizes(J: Floats) -> Floats:
    """(P,) lengths of the columns; 1 for one of zeros."""
    size = np.linalg.norm(J, axis=0)
    return np.where(size > 0, size, 1.0)


def _covariance(rows: PlaneConditions, weight: Floats, m: int) -> Floats:
    """(m, m) covariance of the values of the course."""
    size, frames = _column_sizes(rows.J), len(rows.velocity)
    J = rows.J / size
    N = J.T @ (weight[:, None] * J)
    values, vectors = np.linalg.eigh(N)
    if values[0] < SINGULAR * values[-1]:
        return np.full((m, m), np.inf)
    inverse = (vectors / values) @ vectors.T
    both = J * (weight * rows.off_mm)[:, None]
    spread = scores_spread(both, rows.slope_mm_s[:frames])
    free = frames / max(frames - J.shape[1] / 2, 1.0)
    found = (inverse @ spread @ inverse)[:m, :m] * free
    least = np.diag(inverse)[:m]
    found[np.diag_indices(m)] = np.maximum(np.diag(found), least)
    return np.asarray(found / np.outer(size[:m], size[:m]))


def scores_spread(both: Floats, across_mm_s: Floats) -> Floats:
    """(P, P) covariance of the sum of scores (2F, P) of centres and ends, which adjacent frames
    share (Bartlett's weights over half the time between two reversals)."""
    frames = len(across_mm_s)
    score = both[:frames] + both[frames:]
    spread = score.T @ score
    turns = max(count_reversals(across_mm_s), 1)
    for lag in range(1, max(frames // (2 * turns), 1)):
        share = 1 - lag / (frames / (2 * turns))
        near = score[lag:].T @ score[:-lag]
        spread += share * (near + near.T)
    return np.asarray(spread)


def count_reversals(across_mm_s: Floats) -> int:
    """Number of lasting changes of sign of the velocity (F,) perpendicular to the plane."""
    limit = 0.3 * float(np.sqrt(np.mean(across_mm_s**2)))
    signs = np.sign(across_mm_s[np.abs(across_mm_s) > limit])
    return int(np.count_nonzero(np.diff(signs)))

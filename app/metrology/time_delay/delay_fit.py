"""Maximum-likelihood fit of delay and plane to the lines of a pass."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.metrology.arm.reading_interpolation import Stamps
from app.metrology.robust import huber_weights, sigma_from_median
from app.metrology.time_delay.plane_pass import StripeLines
from app.metrology.transforms import Floats

CHORD_NS = 10_000_000
"""Velocities are estimated over this time before and after. The encoder noise at the time of the
frame then does not contribute to them, so that it cannot bias the delay."""
STEPS, STEP_NS = 40, 500.0
HUBER = 2.0
SINGULAR = 1e-9


@dataclass(frozen=True)
class DelayHypothesis:
    """Delay and plane, ``normal . x = offset_mm``."""

    delay_ns: float
    normal: Floats
    offset_mm: float


@dataclass(frozen=True)
class DelayEstimate(DelayHypothesis):
    """Further results of the fit."""

    uncertainty_ns: float
    """k = 1; infinite if the pass does not determine the delay at all."""
    across_mm_s: Floats
    """(F,) velocity of the line perpendicular to the plane."""
    speed_mm_s: float
    """Rms speed, in any direction."""


@dataclass(frozen=True)
class _PlaneConditions:
    """The plane's condition on the centre and the end of each line, linearised."""

    off_mm: Floats
    """(2F,) distances from the plane: first all centres, then all ends."""
    J: Floats
    """(2F, P); the delay's column first, in mm/s."""
    tangents: Floats
    """(2, 3) directions in which the normal tilts."""
    velocity: Floats
    """(F, 3) velocities of the centres, mm/s."""


def fit_delay(
    lines: StripeLines, poses_at: Callable[[Stamps], Floats], start: DelayHypothesis
) -> DelayEstimate:
    """The delay by Gauss-Newton from start values; outlying frames have less weight (Huber).

    The spread of centres and of ends about the plane is estimated from themselves, but is at least
    that due to the uncertainty of the points. The standard uncertainty includes errors that
    adjacent frames share (a covariance of the score, with Bartlett's weights over half the time
    between two reversals).
    """
    fit, weight = start, np.zeros(0)
    for _ in range(STEPS):
        rows, known = _plane_conditions(lines, poses_at, fit)
        weight = _weights(rows.off_mm, lines.variance[known])
        root = np.sqrt(weight)
        step = np.linalg.lstsq(root[:, None] * rows.J, -root * rows.off_mm, rcond=SINGULAR)[0]
        normal = fit.normal + step[1:3] @ rows.tangents
        length = float(np.linalg.norm(normal))
        # far from the solution, a step may exceed the range of the chords
        change_ns = float(np.clip(step[0] * 1e9, -20e6, 20e6))
        fit = DelayHypothesis(
            fit.delay_ns + change_ns, normal / length, (fit.offset_mm + step[3]) / length
        )
        if abs(change_ns) < STEP_NS:
            break
    across = rows.velocity @ fit.normal
    return DelayEstimate(
        fit.delay_ns,
        fit.normal,
        fit.offset_mm,
        _uncertainty_ns(rows, weight, across),
        across,
        float(np.sqrt(np.mean(np.sum(rows.velocity**2, axis=1)))),
    )


def _plane_conditions(
    lines: StripeLines, poses_at: Callable[[Stamps], Floats], fit: DelayHypothesis
) -> tuple[_PlaneConditions, NDArray[np.bool_]]:
    """The linearised condition for frames with a known pose, and their mask."""
    at_ns = lines.stamps_ns + round(fit.delay_ns)
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
    J = np.zeros((2 * len(at), 6))
    J[:, 0] = np.concatenate([velocity @ n, turning @ n])
    J[:, 1:3] = np.concatenate([at, end]) @ tangents.T
    J[: len(at), 3:] = np.column_stack([-ones, height, height**2])
    off = np.concatenate([at @ n - fit.offset_mm, end @ n])
    return _PlaneConditions(off, J, tangents, velocity), known


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


def _uncertainty_ns(rows: _PlaneConditions, weight: Floats, across: Floats) -> float:
    """Standard uncertainty of the delay, k = 1."""
    J, frames = rows.J, len(across)
    size = np.linalg.norm(J, axis=0)
    N = (J / size).T @ (weight[:, None] * (J / size))
    values, vectors = np.linalg.eigh(N)
    if values[0] < SINGULAR * values[-1]:
        return float("inf")
    inverse = (vectors / values) @ vectors.T
    both = (J / size) * (weight * rows.off_mm)[:, None]
    score = both[:frames] + both[frames:]
    spread = score.T @ score
    turns = max(count_reversals(across), 1)
    for lag in range(1, max(frames // (2 * turns), 1)):
        share = 1 - lag / (frames / (2 * turns))
        near = score[lag:].T @ score[:-lag]
        spread += share * (near + near.T)
    free = frames / max(frames - J.shape[1] / 2, 1.0)
    by_scores = float((inverse @ spread @ inverse)[0, 0]) * free
    return float(np.sqrt(max(by_scores, inverse[0, 0])) / size[0] * 1e9)


def count_reversals(across_mm_s: Floats) -> int:
    """Number of lasting changes of sign of the velocity (F,) perpendicular to the plane."""
    limit = 0.3 * float(np.sqrt(np.mean(across_mm_s**2)))
    signs = np.sign(across_mm_s[np.abs(across_mm_s) > limit])
    return int(np.count_nonzero(np.diff(signs)))

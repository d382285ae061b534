"""Which jumps and which drift the delay of a pass has."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.arm.reading_interpolation import Stamps
from crenel.metrology.robust import sigma_from_median
from crenel.metrology.time_delay.course import CourseShape
from crenel.metrology.time_delay.delay_fit import (
    DelayEstimate,
    DelayHypothesis,
    PosesAt,
    fit_delay,
)
from crenel.metrology.time_delay.plane_pass import StripeLines
from crenel.metrology.time_delay.steadiness import Unsteadiness, estimate_unsteadiness
from crenel.metrology.transforms import Floats

SIGNIFICANT = 5.0
"""A jump or drift counts from this multiple of its standard uncertainty."""
LEAST_JUMP_NS, LEAST_DRIFT_PPM = 2e5, 2.0
"""Smaller ones could be errors of the arm."""
LEAST_FRAMES = 10
"""Before, between and behind jumps."""
MOST_JUMPS, MOST_ROUNDS = 20, 4
SHARED = 2
"""Number of adjacent frames that share their errors, as far as the time of a jump is concerned."""
FAR = 9.0
"""Largest squared deviation, in scatters, of an outlier among the frames around a jump."""


@dataclass(frozen=True)
class CourseEstimate:
    """The fit with the jumps and the drift that were found."""

    fit: DelayEstimate
    unsteadiness: Unsteadiness
    uncertainties: Floats
    """(m,) of the values, k = 1, with the unsteadiness."""
    drift_uncertainty_ppm: float
    """k = 1, also where no drift was found."""
    times: tuple["JumpTime", ...]
    """The times of the jumps."""


@dataclass(frozen=True)
class JumpTime:
    """When a clock jumped."""

    stamp_ns: int
    uncertainty_ns: float
    """k = 1"""


def estimate_course(
    lines: StripeLines, poses_at: PosesAt, start: DelayHypothesis
) -> CourseEstimate:
    """Finds jumps and drift by significance: adds the jump that explains most, until none does.

    Drift is part of the course while jumps are sought, so that it does not pass for one; it is left
    out in the end if it is not significant.
    """
    fit = _locate(lines, poses_at, fit_delay(lines, poses_at, _with_drift(start, True)))
    while len(fit.shape.jumps_ns) < MOST_JUMPS:
        added = _add_jump(lines, fit)
        if added is None:
            break
        tried = _locate(lines, poses_at, fit_delay(lines, poses_at, added))
        if len(_weak_jumps(tried, tried.uncertainties)):
            break
        fit = tried
    fit, _, uncertainties = _drop_weak_jumps(lines, poses_at, fit)
    drift_uncertainty_ppm = float(uncertainties[1])
    drift_ppm = abs(float(fit.values[1]))
    if not drift_ppm > max(SIGNIFICANT * drift_uncertainty_ppm, LEAST_DRIFT_PPM):
        fit = fit_delay(lines, poses_at, _with_drift(fit, False))
    fit, unsteadiness, uncertainties = _drop_weak_jumps(lines, poses_at, fit)
    times = tuple(
        _jump_time(lines, poses_at, fit, jump)[1] for jump in range(len(fit.shape.jumps_ns))
    )
    return CourseEstimate(fit, unsteadiness, uncertainties, drift_uncertainty_ppm, times)


def drop_short_pieces(course: DelayHypothesis, stamps_ns: Stamps) -> DelayHypothesis:
    """The hypothesis without pieces between jumps that hold too few frames (F,) to tell a delay."""
    while course.shape.jumps_ns:
        counts = np.bincount(
            course.shape.piece(stamps_ns), minlength=len(course.shape.jumps_ns) + 1
        )
        if counts.min() >= LEAST_FRAMES:
            break
        course = without_piece(course, int(np.argmin(counts)))
    return course


def without_piece(course: DelayHypothesis, piece: int) -> DelayHypothesis:
    """The hypothesis without one of the pieces between jumps; of a piece in the middle, both jumps
    become one."""
    jumps_ns, changes_ns = _jumps(course)
    if piece == 0:
        return _with_jumps(course, jumps_ns[1:], changes_ns[1:])
    if piece == len(jumps_ns):
        values = course.values.copy()
        values[0] -= changes_ns[-1]
        shorter = replace(course, values=values)
        return _with_jumps(shorter, jumps_ns[:-1], changes_ns[:-1])
    at_ns = (jumps_ns[piece - 1] + jumps_ns[piece]) // 2
    change_ns = changes_ns[piece - 1] + changes_ns[piece]
    return _with_jumps(
        course,
        [*jumps_ns[: piece - 1], at_ns, *jumps_ns[piece + 1 :]],
        [*changes_ns[: piece - 1], change_ns, *changes_ns[piece + 1 :]],
    )


def _with_drift(course: DelayHypothesis, drifts: bool) -> DelayHypothesis:
    """The hypothesis with or without a drift."""
    shape, values = course.shape, course.values
    if shape.drifts == drifts:
        return course
    rest = values[shape.first_jump :]
    changed = np.concatenate([values[:1], [0.0] if drifts else [], rest])
    return DelayHypothesis(replace(shape, drifts=drifts), changed, course.normal, course.offset_mm)


def _with_jumps(
    course: DelayHypothesis, jumps_ns: list[int], changes_ns: list[float]
) -> DelayHypothesis:
    """The hypothesis with other jumps, in order of time."""
    order = np.argsort(jumps_ns, kind="stable")
    shape = replace(course.shape, jumps_ns=tuple(jumps_ns[i] for i in order))
    head = course.values[: course.shape.first_jump]
    values = np.concatenate([head, [changes_ns[i] for i in order]])
    return DelayHypothesis(shape, values, course.normal, course.offset_mm)


def _jumps(course: DelayHypothesis) -> tuple[list[int], list[float]]:
    return list(course.shape.jumps_ns), course.values[course.shape.first_jump :].tolist()


def _add_jump(lines: StripeLines, fit: DelayEstimate) -> DelayHypothesis | None:
    """The hypothesis with the jump that explains most of what is left; None if none does.

    For each frame as the first one behind a jump, the gain is the square of what the jump's column
    explains of the residuals beside all other columns, as cumulative sums.
    """
    stamps_ns, frames = lines.stamps_ns[fit.rows.known], len(fit.across_mm_s)
    root = np.sqrt(fit.weight)
    Q = np.linalg.qr(root[:, None] * fit.rows.J)[0]
    slope, off = root * fit.rows.slope_mm_s * 1e-9, root * fit.rows.off_mm
    off = off - Q @ (Q.T @ off)

    def before(values: Floats) -> Floats:
        """Sums over the frames before each one."""
        both = values[:frames] + values[frames:]
        return np.asarray(np.cumsum(both, axis=0) - both)

    shared = before(slope[:, None] * Q)
    alone = before(slope**2) - np.sum(shared**2, axis=1)
    total = float(np.sum(slope**2))
    explains = before(slope * off)
    places = _free_places(fit.shape, stamps_ns)
    places &= alone > 1e-3 * total / max(frames, 1)
    gain = np.where(places, explains**2 / np.where(places, alone, 1.0), 0.0)
    best = int(np.argmax(gain))
    if gain[best] < SIGNIFICANT**2:
        return None
    jumps_ns, changes_ns = _jumps(fit)
    at_ns = int(stamps_ns[best - 1] + stamps_ns[best]) // 2
    # off = slope * error of the delay, and frames before the jump have less delay by its change
    return _with_jumps(fit, [*jumps_ns, at_ns], [*changes_ns, float(explains[best] / alone[best])])


def _free_places(shape: CourseShape, stamps_ns: NDArray[np.int64]) -> NDArray[np.bool_]:
    """(F,) frames that are far enough from the ends and from other jumps to follow a jump."""
    piece = shape.piece(stamps_ns)
    first = np.searchsorted(piece, piece, side="left")
    last = np.searchsorted(piece, piece, side="right")
    number = np.arange(len(stamps_ns))
    return np.asarray((number - first >= LEAST_FRAMES) & (last - number >= LEAST_FRAMES))


def _locate(lines: StripeLines, poses_at: PosesAt, fit: DelayEstimate) -> DelayEstimate:
    """Moves the jumps to where they fit best, and fits again, until they stay."""
    for _ in range(MOST_ROUNDS):
        jumps_ns, changes_ns = _jumps(fit)
        moved = [_jump_time(lines, poses_at, fit, jump)[0] for jump in range(len(jumps_ns))]
        if moved == jumps_ns:
            break
        fit = fit_delay(lines, poses_at, _with_jumps(fit, moved, changes_ns))
    return fit


def _jump_time(
    lines: StripeLines, poses_at: PosesAt, fit: DelayEstimate, jump: int
) -> tuple[int, JumpTime]:
    """The likeliest time of a jump between its neighbours, and the uncertainty.

    Each frame is compared with the delay before and behind; the jump lies where the sum of squared
    deviations is least. Frames that hardly move tell nothing, so that it may lie anywhere among
    them.
    """
    jumps_ns, changes_ns = _jumps(fit)
    stamps_ns = lines.stamps_ns
    around = np.flatnonzero(np.abs(fit.shape.piece(stamps_ns) - jump - 0.5) < 1)
    if len(around) < 2:
        return jumps_ns[jump], JumpTime(jumps_ns[jump], 0.0)
    here = lines.select(around)
    delays_ns = fit.delays_ns(here.stamps_ns)
    behind = here.stamps_ns >= jumps_ns[jump]
    change_ns = round(changes_ns[jump])
    costs = [
        _frame_costs(here, poses_at, fit, delays_ns + shift_ns)
        for shift_ns in (-change_ns * behind, change_ns * ~behind)
    ]
    # before the first of these frames, before the second, ...; not before the first or last ones
    total = np.concatenate([[0.0], np.cumsum(costs[0] - costs[1])])
    edge = min(LEAST_FRAMES, (len(around) - 1) // 2)
    first = edge if jump == 0 else 1
    last = len(around) - (edge if jump == len(jumps_ns) - 1 else 1)
    total = total[first : last + 1] - total[first : last + 1].min()
    times_ns = (here.stamps_ns[first - 1 : last] + here.stamps_ns[first : last + 1]) / 2.0
    gaps_ns = np.diff(here.stamps_ns)[first - 1 : last].astype(np.float64)
    likely = gaps_ns * np.exp(-total / (2 * SHARED))
    likely /= likely.sum()
    best = int(np.argmin(total))
    spread = likely @ ((times_ns - times_ns[best]) ** 2 + gaps_ns**2 / 12)
    at_ns = int(times_ns[best])
    return at_ns, JumpTime(at_ns, float(np.sqrt(spread)))


def _frame_costs(
    lines: StripeLines, poses_at: PosesAt, fit: DelayEstimate, delays_ns: NDArray[np.int64]
) -> Floats:
    """(F,) squared deviations of the lines' centres at given delays, in scatters."""
    T = poses_at(lines.stamps_ns + delays_ns)
    at = np.einsum("nij,nj->ni", T[:, :3, :3], lines.centre_mm) + T[:, :3, 3]
    spread_mm = sigma_from_median(np.abs(fit.rows.off_mm[: len(fit.across_mm_s)]))
    scale = np.sqrt(np.maximum(spread_mm**2, lines.variance))
    off = (at @ fit.normal - fit.offset_mm) / scale
    return np.minimum(np.where(np.isfinite(off), off**2, FAR), FAR)


def _weak_jumps(fit: DelayEstimate, uncertainties: Floats) -> list[int]:
    """The jumps that are not significant, the weakest first."""
    first = fit.shape.first_jump
    change = np.abs(fit.values[first:])
    needed = np.maximum(SIGNIFICANT * uncertainties[first:], LEAST_JUMP_NS)
    strength = change / needed
    return [int(place) for place in np.argsort(strength) if not strength[place] > 1]


def _drop_weak_jumps(
    lines: StripeLines, poses_at: PosesAt, fit: DelayEstimate
) -> tuple[DelayEstimate, Unsteadiness, Floats]:
    """The fit without jumps that the variation of the delay explains; variation, uncertainties."""
    while True:
        unsteadiness = estimate_unsteadiness(fit)
        uncertainties = unsteadiness.uncertainties(fit, float(np.ptp(lines.stamps_ns)) / 1e9)
        weak = _weak_jumps(fit, uncertainties)
        if not weak:
            return fit, unsteadiness, uncertainties
        jumps_ns, changes_ns = _jumps(fit)
        del jumps_ns[weak[0]], changes_ns[weak[0]]
        fit = _locate(
            lines, poses_at, fit_delay(lines, poses_at, _with_jumps(fit, jumps_ns, changes_ns))
        )

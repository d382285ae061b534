"""The delay between arm and camera, from a back-and-forth pass over a plane.

The pose of a frame is that of the arm at the frame's time stamp plus the delay. A wrong delay moves
the points of a frame by the distance that the sensor travels in the meantime: off the plane to one
side while it approaches, to the other while it moves away. The correct delay makes both agree.
Where a clock was set within the pass, or runs at another rate, the delay jumps or drifts.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.arm.reading_interpolation import Stamps
from crenel.metrology.robust import sigma_from_median
from crenel.metrology.time_delay.clock_changes import (
    CourseEstimate,
    drop_short_pieces,
    estimate_course,
    without_piece,
)
from crenel.metrology.time_delay.course import DelayCourse, DelayJump
from crenel.metrology.time_delay.delay_fit import DelayHypothesis, count_reversals
from crenel.metrology.time_delay.delay_search import SEARCH_NS, search_delay
from crenel.metrology.time_delay.movement import check_movement
from crenel.metrology.time_delay.pass_checks import (
    LEAST_SHARE,
    check_delay,
    check_frames,
    check_gaps,
    check_plane,
    check_steadiness,
    no_poses_error,
)
from crenel.metrology.time_delay.plane_pass import LEAST_POINTS, PlanePass, fit_stripe_lines
from crenel.metrology.transforms import Floats

GATE_MM = 1.0
"""Points further from the plane than this initially count as another surface."""
GATE_SCALES, LEAST_GATE_MM = 4.0, 0.02
ROUNDS, MOST_ROUNDS = 3, 6
"""The rounds of the fit: the last ones only if pieces of the course turned out to be false."""
SEVERAL = 3
"""Frames off the plane around a jump from which on they are no accident."""
MANY = 0.25
"""Share of the frames from a jump on that do not fit: of a camera's that was set back, half."""
EDGE_NS = 30_000_000
"""Reach of the velocities and of the readings around a frame."""


@dataclass(frozen=True)
class FoundJump:
    """A jump of the delay within the pass, and its standard uncertainties (k = 1)."""

    jump: DelayJump
    change_uncertainty_ms: float
    time_uncertainty_s: float


@dataclass(frozen=True)
class ClockDelay:
    """The delay of the arm's time stamps relative to the camera's, and its uncertainty."""

    course: DelayCourse
    """To be added to the time stamp of a frame before looking up the pose of the arm; stated at the
    last frame of the pass."""
    standard_uncertainty_ms: float
    """k = 1, at the last frame."""
    unsteadiness_ms: float
    """Part of the uncertainty, since the delay varies about its course; 0 if it is not seen to."""
    drift_uncertainty_ppm: float
    """k = 1, also where no drift was found."""
    jumps: tuple[FoundJump, ...]
    first_frame_ns: int
    frames: int
    frames_off: int
    """Number of frames with a pose that do not fit the plane at this delay."""
    frames_unplaced: int
    """Number of frames without a pose of the arm at this delay."""
    reversals: int
    seconds: float
    speed_mm_s: float
    """Rms speed of the sensor perpendicular to the plane, which determines the delay."""
    rms_without_um: float | None
    """Rms of the points about their plane, without the delay; None where the arm's poses are
    unknown then."""
    rms_um: float
    """The same with the delay."""

    @property
    def delay_ms(self) -> float:
        """At the last frame."""
        return self.course.delay_ns / 1e6


def estimate_delay(passed: PlanePass) -> ClockDelay:
    """The delay between arm and camera from a pass over a plane, by maximum likelihood.

    The unknowns are the delay, with its jumps and its drift if there are any, and the plane. Errors
    of calibration and arm depend on the position of the sensor, not on its direction of motion:
    terms in its height above the plane absorb them. The spread of the frames about the plane, which
    includes the noise of the encoders, is estimated from the frames themselves.

    Args:
        passed: points of the frames in the sensor frame, and the poses of the arm.

    Returns:
        The delay with its standard uncertainty (k = 1): to be added to the time stamp of a frame
        before looking up the pose of the arm.

    Raises:
        OperationError: ``pass-too-short``, ``sensor-at-rest``, ``arm-at-rest``,
            ``no-joints-around-frames``, ``not-a-plane``, ``pass-too-slow``,
            ``pass-along-the-plane``, ``pass-without-reversal``, ``pass-not-informative``, or
            ``arm-times-vary`` where the arm's stamps are late by times that vary.
    """
    usable = np.flatnonzero(np.diff(passed.first) >= LEAST_POINTS)
    check_frames(len(usable))
    passed = passed.select(usable)
    check_movement(passed, SEARCH_NS)
    start = search_delay(passed)
    if start is None:
        raise no_poses_error()
    off_mm, gate_mm = _distances(passed, start), GATE_MM
    for round_number in range(1, MOST_ROUNDS + 1):
        clear = _clear_frames(passed, start, off_mm, gate_mm)
        lines = fit_stripe_lines(passed, (off_mm < gate_mm) & clear[passed.frame])
        check_plane(passed, start, off_mm, gate_mm)
        check_frames(len(lines.stamps_ns))
        start = drop_short_pieces(start, lines.stamps_ns)
        found = estimate_course(lines, passed.poses_at, start)
        start, off_mm = found.fit, _distances(passed, found.fit)
        near = off_mm[off_mm < gate_mm]
        gate_mm = max(GATE_SCALES * sigma_from_median(near), LEAST_GATE_MM)
        start, off_mm = _drop_false_pieces(passed, start, off_mm, gate_mm)
        if round_number >= ROUNDS and start is found.fit:
            break
    check_delay(found.fit)
    check_steadiness(found)
    check_gaps(passed.frames_on_plane(off_mm, gate_mm)[0])
    return _clock_delay(passed, found, gate_mm)


def _drop_false_pieces(
    passed: PlanePass, fit: DelayHypothesis, off_mm: Floats, gate_mm: float
) -> tuple[DelayHypothesis, Floats]:
    """The hypothesis without pieces between jumps that most of their frames contradict, as where a
    clock was set back and gave its stamps twice; and the distances by it."""
    while fit.shape.jumps_ns:
        known, fits = passed.frames_on_plane(off_mm, gate_mm)
        piece, count = fit.shape.piece(passed.stamps_ns), len(fit.shape.jumps_ns) + 1
        share = np.bincount(piece, fits, count) / np.maximum(np.bincount(piece, known, count), 1)
        if share.min() >= LEAST_SHARE:
            break
        fit = without_piece(fit, int(np.argmin(share)))
        off_mm = _distances(passed, fit)
    return fit, off_mm


def _clock_delay(passed: PlanePass, found: CourseEstimate, gate_mm: float) -> ClockDelay:
    """The result; frames on the plane are counted by the last gate."""
    fit = found.fit
    off_mm = _distances(passed, fit)
    known, fits = passed.frames_on_plane(off_mm, gate_mm)
    drift_ppm = float(fit.values[1]) if fit.shape.drifts else 0.0
    changes = slice(fit.shape.first_jump, None)
    jumps = tuple(
        FoundJump(
            DelayJump(
                time.stamp_ns,
                change_ns,
                _unclear_ns(passed.stamps_ns[known], ~fits[known], time.stamp_ns, change_ns),
            ),
            u_ns / 1e6,
            time.uncertainty_ns / 1e9,
        )
        for time, change_ns, u_ns in zip(
            found.times,
            fit.values[changes].tolist(),
            found.uncertainties[changes].tolist(),
            strict=True,
        )
    )
    course = DelayCourse(
        float(fit.values[0]), fit.shape.stamp_ns, drift_ppm, tuple(one.jump for one in jumps)
    )
    on_plane = off_mm < gate_mm
    rms_um = _rms_um(passed, on_plane, course.at(passed.stamps_ns))
    assert rms_um is not None  # the plane was fitted to these points
    return ClockDelay(
        course,
        standard_uncertainty_ms=float(found.uncertainties[0]) / 1e6,
        unsteadiness_ms=found.unsteadiness.uncertainty_ns / 1e6,
        drift_uncertainty_ppm=found.drift_uncertainty_ppm,
        jumps=jumps,
        first_frame_ns=int(passed.stamps_ns[0]),
        frames=int(fits.sum()),
        frames_off=int((known & ~fits).sum()),
        frames_unplaced=int((~known).sum()),
        reversals=count_reversals(fit.across_mm_s),
        seconds=float(np.ptp(passed.stamps_ns[fits])) / 1e9,
        speed_mm_s=float(np.sqrt(np.mean(fit.across_mm_s**2))),
        rms_without_um=_rms_um(passed, on_plane, 0),
        rms_um=rms_um,
    )


def _clear_frames(
    passed: PlanePass, fit: DelayHypothesis, off_mm: Floats, gate_mm: float
) -> NDArray[np.bool_]:
    """(F,) False for frames around a jump among which many do not fit: the others fit by chance, or
    have velocities across the edge."""
    known, fits = passed.frames_on_plane(off_mm, gate_mm)
    clear = np.ones(len(known), dtype=np.bool_)
    changes_ns = fit.values[fit.shape.first_jump :]
    for jump_ns, change_ns in zip(fit.shape.jumps_ns, changes_ns, strict=True):
        unclear_ns = _unclear_ns(passed.stamps_ns[known], ~fits[known], jump_ns, float(change_ns))
        if unclear_ns is not None:
            clear &= (passed.stamps_ns < unclear_ns[0] - EDGE_NS) | (
                passed.stamps_ns > unclear_ns[1] + EDGE_NS
            )
    return clear


def _unclear_ns(
    stamps_ns: Stamps, off: NDArray[np.bool_], jump_ns: int, change_ns: float
) -> tuple[int, int] | None:
    """The first and last of the frames around a jump of which many do not fit: a clock that was set
    back by as much gave their time stamps twice."""
    near = np.abs(stamps_ns - jump_ns) <= abs(change_ns)
    stamps_ns, off = stamps_ns[near], off[near]
    behind = stamps_ns >= jump_ns
    found: list[int] = []
    for side_ns, side_off in (
        (stamps_ns[~behind][::-1], off[~behind][::-1]),
        (stamps_ns[behind], off[behind]),
    ):
        share = np.cumsum(side_off) / np.arange(1, len(side_off) + 1)
        found += side_ns[side_off & (share >= MANY)].tolist()
    return (min(found), max(found)) if len(found) >= SEVERAL else None


def _distances(passed: PlanePass, fit: DelayHypothesis) -> Floats:
    """(N,) distance of the points from the plane, mm; infinite if the pose of the arm is
    unknown."""
    points = passed.points_in_arm(fit.delays_ns(passed.stamps_ns))
    off = np.abs(points @ fit.normal - fit.offset_mm)
    return np.where(np.isfinite(off), off, np.inf)


def _rms_um(
    passed: PlanePass, on_plane: NDArray[np.bool_], delays_ns: Stamps | int
) -> float | None:
    """Rms of the points about the plane that fits them best; None without points."""
    points = passed.points_in_arm(delays_ns)[on_plane]
    points = points[np.isfinite(points).all(axis=1)]
    if not len(points):
        return None
    centred = points - points.mean(axis=0)
    least = float(np.linalg.eigvalsh(centred.T @ centred)[0])
    return 1e3 * float(np.sqrt(max(least, 0.0) / len(points)))

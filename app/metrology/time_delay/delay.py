"""The constant delay between arm and camera, from a back-and-forth pass over a plane.

The pose of a frame is that of the arm at the frame's time stamp plus the delay. A wrong delay moves
the points of a frame by the distance that the sensor travels in the meantime: off the plane to one
side while it approaches, to the other while it moves away. The correct delay makes both agree.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.errors import OperationError
from app.messages.message import message, quantity, rounded
from app.metrology.fitting.plane_sphere import fit_plane
from app.metrology.robust import median, sigma_from_median
from app.metrology.time_delay.delay_fit import (
    DelayEstimate,
    DelayHypothesis,
    count_reversals,
    fit_delay,
)
from app.metrology.time_delay.plane_pass import LEAST_POINTS, PlanePass, fit_stripe_lines
from app.metrology.transforms import Floats

SEARCH_NS, SEARCH_STEP_NS = 250_000_000, 5_000_000
"""Delays tried before the fit."""
SEARCH_FRAMES, SEARCH_POINTS = 200, 10
GATE_MM = 1.0
"""Points further from the plane than this initially count as another surface: half a step of the
search at 300 mm/s."""
GATE_SCALES, LEAST_GATE_MM = 4.0, 0.02
LEAST_FRAMES = 30
LEAST_SHARE = 0.5
"""Minimum share of the points that lie on a plane."""
MOST_SPREAD_MM = 0.3
"""Maximum scatter of the points about a plane at any delay; an arm is better than this over one
plate."""
MOST_UNCERTAINTY_MS = 1.0
"""A delay with a larger uncertainty does more harm than good."""
SLOW_MM_S = 10.0
ONE_WAY = 0.2
"""Minimum share of the way back relative to the way forth, perpendicular to the plane."""


@dataclass(frozen=True)
class ClockDelay:
    """The delay of the arm's time stamps relative to the camera's, and its uncertainty."""

    delay_ms: float
    """To be added to the time stamp of a frame before looking up the pose of the arm."""
    standard_uncertainty_ms: float
    """k = 1"""
    frames: int
    reversals: int
    seconds: float
    speed_mm_s: float
    """Rms speed of the sensor perpendicular to the plane, which determines the delay."""
    rms_without_um: float
    """Rms of the points about their plane, without the delay."""
    rms_um: float
    """The same with the delay."""


def estimate_delay(passed: PlanePass) -> ClockDelay:
    """The delay between arm and camera from a pass over a plane, by maximum likelihood.

    The unknowns are the delay and the plane. Errors of calibration and arm depend on the position
    of the sensor, not on its direction of motion: terms in its height above the plane absorb them.
    The spread of the frames about the plane, which includes the noise of the encoders, is estimated
    from the frames themselves.

    Args:
        passed: points of the frames in the sensor frame, and the poses of the arm.

    Returns:
        The delay in ms with its standard uncertainty (k = 1): to be added to the time stamp of a
        frame before looking up the pose of the arm.

    Raises:
        OperationError: ``pass-too-short``, ``no-joints-around-frames``, ``not-a-plane``,
            ``pass-too-slow``, ``pass-along-the-plane``, ``pass-without-reversal`` or
            ``pass-not-informative``.
    """
    usable = np.flatnonzero(np.diff(passed.first) >= LEAST_POINTS)
    _check_frames(len(usable))
    even = np.linspace(0, len(usable) - 1, min(SEARCH_FRAMES, len(usable))).astype(np.int64)
    fit, gate_mm = _search_delay(passed.subsample(usable[even], SEARCH_POINTS)), GATE_MM
    off_mm = _distances(passed, fit)
    for _ in range(3):
        lines = fit_stripe_lines(passed, off_mm < gate_mm)
        _check_plane(off_mm, gate_mm, len(lines.stamps_ns))
        found = fit_delay(lines, passed.poses_at, fit)
        fit, off_mm = found, _distances(passed, found)
        near = off_mm[off_mm < gate_mm]
        gate_mm = max(GATE_SCALES * sigma_from_median(near), LEAST_GATE_MM)
    _check_delay(found)
    on_plane = off_mm < gate_mm
    return ClockDelay(
        delay_ms=found.delay_ns / 1e6,
        standard_uncertainty_ms=found.uncertainty_ns / 1e6,
        frames=len(lines.stamps_ns),
        reversals=count_reversals(found.across_mm_s),
        seconds=float(np.ptp(lines.stamps_ns)) / 1e9,
        speed_mm_s=float(np.sqrt(np.mean(found.across_mm_s**2))),
        rms_without_um=_rms_um(passed, on_plane, 0.0),
        rms_um=_rms_um(passed, on_plane, found.delay_ns),
    )


def _distances(passed: PlanePass, fit: DelayHypothesis) -> Floats:
    """(N,) distance of the points from the plane, mm; infinite if the pose of the arm is
    unknown."""
    off = np.abs(passed.points_in_arm(fit.delay_ns) @ fit.normal - fit.offset_mm)
    return np.where(np.isfinite(off), off, np.inf)


def _rms_um(passed: PlanePass, on_plane: NDArray[np.bool_], delay_ns: float) -> float:
    """Rms of the points about the plane that fits them best."""
    points = passed.points_in_arm(delay_ns)[on_plane]
    points = points[np.isfinite(points).all(axis=1)]
    centred = points - points.mean(axis=0)
    least = float(np.linalg.eigvalsh(centred.T @ centred)[0])
    return 1e3 * float(np.sqrt(max(least, 0.0) / len(points)))


def _search_delay(sample: PlanePass) -> DelayHypothesis:
    """The delay of a grid that brings the points closest to one plane; the smallest of equal
    ones."""
    best: tuple[float, DelayHypothesis] | None = None
    for delay_ns in sorted(range(-SEARCH_NS, SEARCH_NS + 1, SEARCH_STEP_NS), key=abs):
        points = sample.points_in_arm(delay_ns)
        known = np.isfinite(points).all(axis=1)
        if known.mean() < 0.7:
            continue
        plane = fit_plane(points[known])
        off_mm = median(np.abs(points[known] @ plane.normal - plane.offset_mm))
        if best is None or off_mm < 0.95 * best[0]:
            best = off_mm, DelayHypothesis(float(delay_ns), plane.normal, plane.offset_mm)
    if best is None:
        raise OperationError(
            "no-joints-around-frames",
            message("arms-position-known-around-most-pictures"),
            message("arm-sent-too-little-arm-camera"),
            message("take-pass-again"),
        )
    return best[1]


def _check_frames(count: int) -> None:
    if count < LEAST_FRAMES:
        raise OperationError(
            "pass-too-short",
            message("pass-has-pictures-lasers-line-plane", count=count),
            message("needed", least_frames=LEAST_FRAMES),
            message("take-longer-pass-five-seconds-more"),
        )


def _check_plane(off_mm: Floats, gate_mm: float, frames: int) -> None:
    near = off_mm[off_mm < gate_mm]
    share = len(near) / len(off_mm)
    spread_mm = sigma_from_median(near) if len(near) else np.inf
    if share < LEAST_SHARE or spread_mm > MOST_SPREAD_MM:
        why = message(
            "points-lie-within-one-plane",
            share=quantity(100 * share, "%"),
            distance=rounded(gate_mm, "mm", 2),
        )
        if share >= LEAST_SHARE:
            why = message("points-lie-about-nearest-plane", spread=quantity(spread_mm, "mm", 2))
        raise OperationError(
            "not-a-plane",
            message("what-passed-over-plane"),
            why,
            message("pass-over-flat-plate-fills-lasers"),
        )
    _check_frames(frames)


def _check_delay(found: DelayEstimate) -> None:
    """Refuses a pass that cannot determine the delay, with a remedy."""
    across, u_ms = found.across_mm_s, found.uncertainty_ns / 1e6
    speed = float(np.sqrt(np.mean(across**2)))
    known = message("delay-would-known-k-1", u=quantity(u_ms, "ms", 1))
    if not np.isfinite(u_ms):
        known = message("delay-would-known-all")
    again = message("move-sensor-nearer-away-again-several")
    to, fro = float(across.clip(min=0).sum()), float((-across).clip(min=0).sum())
    if found.speed_mm_s < SLOW_MM_S and u_ms > MOST_UNCERTAINTY_MS:
        code, why = (
            "pass-too-slow",
            message("sensor-went", speed=quantity(found.speed_mm_s, "mm/s"), known=known),
        )
        again = message("go-faster", speed=quantity(50, "mm/s"))
    elif speed < found.speed_mm_s / 10 and u_ms > MOST_UNCERTAINTY_MS / 10:
        code = "pass-along-the-plane"
        why = message(
            "sensor-went-along-plane-across-along",
            along=quantity(found.speed_mm_s, "mm/s"),
            across=quantity(speed, "mm/s", 1),
        )
    elif min(to, fro) < ONE_WAY * max(to, fro):
        code = "pass-without-reversal"
        why = message("sensor-only-went-one-way-delay")
    elif u_ms > MOST_UNCERTAINTY_MS:
        code = "pass-not-informative"
        why = message("known-limit-is", known=known, limit=rounded(MOST_UNCERTAINTY_MS, "ms"))
        again = message("go-faster-farther-over-plate-nearer")
    else:
        return
    raise OperationError(code, message("pass-does-tell-delay"), why, again)

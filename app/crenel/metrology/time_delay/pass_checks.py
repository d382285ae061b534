"""What a pass over a plane must have for the delay to be determined, and its refusals."""

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.message import Text, message, quantity, rounded
from crenel.metrology.robust import sigma_from_median
from crenel.metrology.time_delay.clock_changes import CourseEstimate
from crenel.metrology.time_delay.course import MOST_UNCERTAINTY_MS
from crenel.metrology.time_delay.delay_fit import DelayEstimate, DelayHypothesis
from crenel.metrology.time_delay.delay_search import SEARCH_NS
from crenel.metrology.time_delay.plane_pass import PlanePass
from crenel.metrology.transforms import Floats

LEAST_FRAMES = 30
LEAST_SHARE = 0.5
"""Minimum share of the points, and of the frames, that lie on a plane."""
MOST_SPREAD_MM = 0.3
"""Maximum scatter of the points about a plane at any delay; an arm is better than this over one
plate."""
SLOW_MM_S = 10.0
FASTER = 2.0
"""Frames of the fastest third lie this many times as far off as those of the slowest, where the
times of their poses are wrong."""
MOST_GAPS = 0.2
"""Share of frames without a pose between the first and the last one that has one."""
ONE_WAY = 0.2
"""Minimum share of the way back relative to the way forth, perpendicular to the plane."""


def no_poses_error() -> OperationError:
    return OperationError(
        "no-joints-around-frames",
        message("arms-position-known-around-most-pictures"),
        message("arm-sent-too-little-arm-camera"),
        message("take-pass-again"),
    )


def check_frames(count: int) -> None:
    if count < LEAST_FRAMES:
        raise OperationError(
            "pass-too-short",
            message("pass-has-pictures-lasers-line-plane", count=count),
            message("needed", least_frames=LEAST_FRAMES),
            message("take-longer-pass-five-seconds-more"),
        )


def check_plane(passed: PlanePass, fit: DelayHypothesis, off_mm: Floats, gate_mm: float) -> None:
    """Refuses points (N,) at these distances from the plane of the fit as those of no plane."""
    known, fits = passed.frames_on_plane(off_mm, gate_mm)
    near = off_mm[off_mm < gate_mm]
    points = len(near) / max(int(np.isfinite(off_mm).sum()), 1)
    share = min(points, int(fits.sum()) / max(int(known.sum()), 1))
    spread_mm = sigma_from_median(near) if len(near) else np.inf
    if share >= LEAST_SHARE and spread_mm <= MOST_SPREAD_MM:
        return
    if _grows_with_speed(passed, fit, off_mm):
        raise _unsteady_error(message("scatter-grows-with-speed"))
    why = message(
        "points-not-within-one-plane",
        range=rounded(SEARCH_NS / 1e9, "s"),
        share=quantity(100 * share, "%"),
        distance=rounded(gate_mm, "mm", 2),
    )
    if share >= LEAST_SHARE:
        why = message("points-lie-about-nearest-plane", spread=quantity(spread_mm, "mm", 2))
    raise OperationError(
        "not-a-plane",
        message("surface-is-not-a-plane"),
        why,
        message("pass-over-flat-plate-fills-lasers"),
    )


def _unsteady_error(why: Text) -> OperationError:
    return OperationError(
        "arm-times-vary",
        message("pass-does-not-tell-delay"),
        why,
        message("give-arm-its-own-times-or-no-other-traffic"),
    )


def _grows_with_speed(passed: PlanePass, fit: DelayHypothesis, off_mm: Floats) -> bool:
    """Whether frames lie the further off the faster the sensor approaches or leaves the plane, as
    where their poses are those of other times."""
    T = passed.poses_at(passed.stamps_ns + fit.delays_ns(passed.stamps_ns))
    height_mm = (T[:, :3, :3] @ passed.points_mm.mean(axis=0) + T[:, :3, 3]) @ fit.normal
    known = np.flatnonzero(np.isfinite(height_mm))
    if len(known) < LEAST_FRAMES:
        return False
    speed = np.abs(np.convolve(np.gradient(height_mm[known]), np.ones(3) / 3, "same"))
    frame_off_mm = np.array(
        [np.median(off_mm[passed.first[at] : passed.first[at + 1]]) for at in known.tolist()]
    )
    slow, fast = np.quantile(speed, [1 / 3, 2 / 3])
    slow_mm = float(np.median(frame_off_mm[speed <= slow]))
    return float(np.median(frame_off_mm[speed >= fast])) > FASTER * slow_mm


def check_steadiness(found: CourseEstimate) -> None:
    """Refuses a delay that varies more than the delay of a scan may be uncertain."""
    u_ms = found.unsteadiness.uncertainty_ns / 1e6
    if u_ms <= MOST_UNCERTAINTY_MS:
        return
    varies_ms = max(found.unsteadiness.stretch_ns, found.unsteadiness.frame_ns) / 1e6
    known = message("delay-would-known-k-1", u=quantity(u_ms, "ms", 1))
    limit = rounded(MOST_UNCERTAINTY_MS, "ms")
    raise _unsteady_error(
        message("delay-varies-known", varies=quantity(varies_ms, "ms", 1), known=known, limit=limit)
    )


def check_gaps(known: NDArray[np.bool_]) -> None:
    """Refuses a pass (F,) with many frames without a pose among the others: those that a late
    packet leaves without are not like the rest."""
    placed = np.flatnonzero(known)
    pictures = int(placed[-1] - placed[0]) + 1
    gaps = pictures - len(placed)
    if gaps > MOST_GAPS * pictures:
        raise _unsteady_error(message("delay-pictures-in-gaps", gaps=gaps, pictures=pictures))


def check_delay(found: DelayEstimate) -> None:
    """Refuses a pass that cannot determine the delay, with a remedy."""
    across, u_ms = found.across_mm_s, float(found.uncertainties[0]) / 1e6
    speed = float(np.sqrt(np.mean(across**2)))
    known = message("delay-would-known-k-1", u=quantity(u_ms, "ms", 1))
    if not np.isfinite(u_ms):
        known = message("delay-would-not-be-determined")
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
            "sensor-moved-along-plane-without-effect",
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
    raise OperationError(code, message("pass-does-not-tell-delay"), why, again)

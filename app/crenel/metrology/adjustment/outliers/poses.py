"""Poses that are off by less than a blunder and by more than the arm's noise; found after
adjusting."""

from dataclasses import replace

import numpy as np

from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult, solve_adjustment
from crenel.metrology.adjustment.core.hand_eye import Mounting, pose_offsets_mm
from crenel.metrology.transforms import Floats

# An outlier is off by this multiple of the usual deviation of the others.
OUTLIER_TIMES = 5.0
# It is also off by this multiple of the encoder noise in the datasheet.
OUTLIER_AT_LEAST = 4.0
FEWEST_POSES = 4
# With few poses, one outlier pulls the others along, so that none stands out: it then shows by a
# reduction of the noise of all others by this factor without it.
LESS_NOISE_TIMES = 5.0
# Chance alone causes such a deviation less often than this.
OUTLIER_CHANCE = 1e-5
# Share of a pose's readings that its own picture must determine before the pose is judged.
LEAST_DETERMINED = 0.05


def remove_outlier_poses(
    found: AdjustmentResult, mounting: Mounting, reach_mm: float
) -> tuple[AdjustmentResult, Mounting]:
    """Adjusts without the outlier poses, worst first; they are marked in ``mounting``.

    Fewer than half of all poses are excluded.
    """
    total = len(mounting.contradicts)
    while 2 * (mounting.contradicts.sum() + 1) < total:
        left = _remove_outlier(found)
        if left is None:
            break
        outlier, found = left
        contradicts = mounting.contradicts.copy()
        contradicts[np.flatnonzero(~mounting.contradicts)[outlier]] = True
        X, T_arm_obj = found.state.T_flange_cam, found.state.T_arm_obj
        off_mm = pose_offsets_mm(mounting.T_arm_flange, mounting.T_cam_obj, X, T_arm_obj, reach_mm)
        mounting = replace(
            mounting, T_flange_cam=X, T_arm_obj=T_arm_obj, off_mm=off_mm, contradicts=contradicts
        )
    return found, mounting


def _remove_outlier(found: AdjustmentResult) -> tuple[int, AdjustmentResult] | None:
    """The index of the outlier pose, and the adjustment without it; None if there is none."""
    outlier = find_outlier_pose(found)
    if outlier is not None:
        return outlier, _refit_without(found, outlier)
    noise = pose_noise(found)
    usual = found.problem.motion.usual_factor
    if len(noise) < FEWEST_POSES or found.scales.noise < OUTLIER_AT_LEAST * usual:
        return None
    candidate = int(np.argmax(noise))
    rest = _refit_without(found, candidate)
    calmer = rest.scales.noise * LESS_NOISE_TIMES < found.scales.noise
    return (candidate, rest) if calmer else None


def _refit_without(found: AdjustmentResult, pose: int) -> AdjustmentResult:
    out = np.arange(len(found.problem.views)) == pose
    start = replace(found.state, noise=found.state.noise[~out])
    return solve_adjustment(found.problem.without_poses(out), start)


def find_outlier_pose(found: AdjustmentResult) -> int | None:
    """The pose whose readings are furthest off, if no noise explains that, or None.

    The noise of a pose is the rms of its readings' errors relative to their standard deviation,
    normalised by the number of readings that the data determined; that of the others is their
    median, which one outlier does not affect.
    """
    from scipy.special import fdtri

    noise, determined = pose_noise(found), count_determined(found)
    if len(noise) < FEWEST_POSES:
        return None
    worst = find_worst_outlier(noise, OUTLIER_AT_LEAST * found.problem.motion.usual_factor)
    if worst is None:
        return None
    # the fewer of its readings the others predict, the more often chance alone exceeds a limit
    own, others = determined[worst], np.delete(determined, worst).sum()
    chance = float(np.sqrt(fdtri(own, others, 1 - OUTLIER_CHANCE)))
    usual = float(np.median(np.delete(noise, worst)))
    return worst if noise[worst] > chance * usual else None


def find_worst_outlier(off: Floats, at_least: float) -> int | None:
    """The index of the largest of values (N,), not all NaN, if it exceeds what the others' median
    and ``at_least`` explain; otherwise None."""
    worst = int(np.nanargmax(off))
    usual = float(np.nanmedian(np.delete(off, worst)))
    return worst if off[worst] > max(OUTLIER_TIMES * usual, at_least) else None


def pose_noise(found: AdjustmentResult) -> Floats:
    """(P,) noise of each pose's readings, in standard deviations of one reading."""
    sd = found.problem.motion.noise_sd
    values = found.state.noise / sd
    return np.asarray(np.sqrt((values**2).sum(axis=1) / count_determined(found)))


def count_determined(found: AdjustmentResult) -> Floats:
    """(P,) how many of each pose's readings the data determine, of all together."""
    poses, count = found.state.noise.shape
    sd = found.problem.motion.noise_sd
    variance = np.diag(found.covariance)[found.layout.noise].reshape(poses, count) / sd**2
    determined = count - (variance / found.scales.noise**2).sum(axis=1)
    return np.asarray(np.maximum(determined, LEAST_DETERMINED * count))

"""The accuracy of the arm's parameters: the error of the tip over the arm's reach."""

import numpy as np

from crenel.metrology.arm.identification.parameter_selection import LENGTH_MM
from crenel.metrology.arm.identification.parameters import Indices, tip_jacobian
from crenel.metrology.arm.kinematics import Arm, tip_centres
from crenel.metrology.transforms import Floats, apply, rigid_fit, skews

POSES = 400
SHARE = 0.8
"""Share of each joint's range that the poses span."""


def reach_poses(arm: Arm) -> Floats:
    """(POSES, n) encoder angles over the arm's reach; the same for the same limits."""
    low, high = np.array([joint.limits_rad for joint in arm.joints]).T
    middle, half = (low + high) / 2, (high - low) / 2 * SHARE
    return np.random.default_rng(0).uniform(middle - half, middle + half, (POSES, len(low)))


def volumetric_difference_mm(before: Arm, after: Arm) -> float:
    """Rms distance of the two arms' tips over the reach, after the best rigid fit.

    A rigid motion of the whole arm is not an error: everything is measured from its own base.
    """
    q = reach_poses(before)
    a, b = tip_centres(before, q), tip_centres(after, q)
    left = apply(rigid_fit(b, a), a) - b
    return float(np.sqrt(np.mean(np.sum(left**2, axis=1))))


def size_uncertainty_mm(arm: Arm) -> float:
    """Rms error of the tip over the reach if the arm's scale is as wrong as its longest link.

    That link is assumed to be made to ``LENGTH_MM``; a rigid fit does not remove a scale error.
    """
    longest = max(max(abs(joint.a_mm), abs(joint.d_mm)) for joint in arm.joints)
    tips = tip_centres(arm, reach_poses(arm))
    spread = tips - tips.mean(axis=0)
    return float(np.sqrt(np.mean(np.sum(spread**2, axis=1)))) * LENGTH_MM / longest


def volumetric_uncertainty_mm(arm: Arm, moved: Indices, covariance: Floats) -> float:
    """Rms standard uncertainty (k = 1) of the tip over the reach, due to the moved parameters.

    Held parameters do not contribute: without a bar, ``size_uncertainty_mm`` is added.

    Args:
        moved: (p,) parameters.
        covariance: (p, p) in mm and rad.
    """
    if not len(moved):
        return 0.0
    tips, J = tip_jacobian(arm, reach_poses(arm))
    return rms_beside_rigid_mm(tips, J[:, :, moved], covariance)


def rms_beside_rigid_mm(tips_mm: Floats, by_errors: Floats, covariance: Floats) -> float:
    """Rms of what errors move tips by, beside the best rigid motion of them all.

    Args:
        tips_mm: (N, 3) over the reach.
        by_errors: (N, 3, P) derivatives by the errors.
        covariance: (P, P) of the errors.
    """
    count = len(tips_mm)
    turns = -skews((tips_mm - tips_mm.mean(axis=0)) / 100.0)
    rigid = np.concatenate([np.tile(np.eye(3), (count, 1, 1)), turns], axis=2).reshape(-1, 6)
    by_parameters = by_errors.reshape(-1, by_errors.shape[2])
    basis, _ = np.linalg.qr(rigid)
    left = by_parameters - basis @ (basis.T @ by_parameters)
    squares = np.einsum("ri,ij,rj->r", left, covariance, left)
    return float(np.sqrt(np.sum(squares) / count))

"""The true pose of the flange relative to the pose by the arm's model.

Two errors move it: errors of the links, the same in every pose (Eq. 3), and the noise of the
encoders, independent in each pose. A robot that reports its flange pose has only the second, as an
error of the pose itself.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from crenel.metrology.arm.identification.volumetric_error import reach_poses, rms_beside_rigid_mm
from crenel.metrology.arm.kinematics import Arm, link_transforms, tip_centres
from crenel.metrology.arm.link_error import error_transform
from crenel.metrology.transforms import Floats, adjoint

# Lever that converts errors in rotation, of a robot or a link, into errors in position.
LEVER_MM = 400.0
# Minimum noise of encoders, whatever their datasheet says.
LEAST_ENCODER_RAD = 1e-6
# Noise of a robot's controller from pose to pose: usual value if nothing is known, and minimum.
USUAL_ROBOT_MM, LEAST_ROBOT_MM = 0.1, 0.001


@dataclass(frozen=True)
class FlangeMotion:
    """The flange in P readings of an arm, and its derivatives by small errors.

    ``by_links`` (P, 6, 6n) and ``by_noise`` (P, 6, n) are left twists of ``T_arm_flange`` (P, 4, 4)
    for one unit of each link's error, a twist (rad, mm) behind it, and for one unit of each
    reading's noise. The standard deviations of the noise are ``noise_sd`` (n,) times a factor:
    usually ``usual_factor``, never less than ``least_factor``.
    """

    T_arm_flange: Floats
    by_links: Floats
    by_noise: Floats
    noise_sd: Floats
    usual_factor: float = 1.0
    least_factor: float = 1.0


def arm_motion(arm: Arm, q_rad: Floats) -> FlangeMotion:
    """The motion of a jointed arm at encoder angles (P, n)."""
    q = np.asarray(q_rad, dtype=np.float64)
    T, by_links, by_encoders = _error_jacobians(arm, q)
    return FlangeMotion(
        T,
        by_links,
        by_encoders,
        np.maximum(arm.encoder_sd_rad, LEAST_ENCODER_RAD),
    )


def robot_motion(T_arm_flange: Floats) -> FlangeMotion:
    """The motion of a robot that reports poses (P, 4, 4), each with its own error.

    Noise is expressed in mm; rotations are about the origin of the flange and converted by the
    lever.
    """
    own = np.diag(np.repeat([1 / LEVER_MM, 1.0], 3))
    by_noise = np.array([adjoint(T) @ own for T in T_arm_flange]).reshape(-1, 6, 6)
    unseen = np.zeros((len(T_arm_flange), 6, 0))
    return FlangeMotion(T_arm_flange, unseen, by_noise, np.ones(6), USUAL_ROBOT_MM, LEAST_ROBOT_MM)


def _error_jacobians(arm: Arm, q: Floats) -> tuple[Floats, Floats, Floats]:
    """Flange poses (P, 4, 4), and left twists by 6n link errors and by n encoders."""
    links = link_transforms(arm, q)
    n, count = arm.joint_count, len(q)
    by_links, by_encoders = np.zeros((count, 6, 6 * n)), np.zeros((count, 6, n))
    T = np.broadcast_to(error_transform(arm.base), (count, 4, 4))
    for i, joint in enumerate(arm.joints):
        axis = np.array([0.0, 0.0, joint.sign, 0.0, 0.0, 0.0])
        by_encoders[:, :, i] = adjoint(T) @ axis
        T = links[0] if i == 0 else T @ links[i]  # the first link contains the base
        by_links[:, :, 6 * i : 6 * i + 6] = adjoint(T)
    return np.asarray(T), by_links, by_encoders


def tip_shift(T_arm_flange: Floats, tip_mm: Floats) -> Floats:
    """(3, 6) translation of the tip (3,) on the flange, arm frame, by a left twist of the
    flange."""
    at = T_arm_flange[:3, :3] @ tip_mm + T_arm_flange[:3, 3]
    x, y, z = at
    turn = np.array([[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]])
    return np.column_stack([turn, np.eye(3)])


def tip_errors_by_links(arm: Arm, q_rad: Floats, volume_mm: float) -> Floats:
    """What errors of the links, the same in every posture, move the tip by.

    Args:
        q_rad: (N, n) encoder angles.
        volume_mm: rms error of the tip over the arm's reach, beside a motion of the whole arm. All
            links share it in their usual proportion of rotations and translations.

    Returns:
        (N, 3, 6n) mm, arm frame, for one standard deviation of each of the links' errors.
    """
    moved = tip_by_links(arm_motion(arm, q_rad), arm.tip.centre_mm)
    return np.asarray(moved * _usual_proportion(arm) * link_errors_mm(arm, volume_mm))


@lru_cache(maxsize=8)
def link_errors_mm(arm: Arm, volume_mm: float) -> float:
    """Translation of each link's error if the tip is off by so much; the rotation, in rad, is this
    over ``LEVER_MM``.

    Args:
        volume_mm: as of ``tip_errors_by_links``.
    """
    reach, usual = reach_poses(arm), _usual_proportion(arm)
    by_links = tip_by_links(arm_motion(arm, reach), arm.tip.centre_mm) * usual
    return volume_mm / rms_beside_rigid_mm(tip_centres(arm, reach), by_links, np.eye(len(usual)))


def _usual_proportion(arm: Arm) -> Floats:
    """(6n,) errors of all links, each translation 1 mm."""
    return np.tile(np.repeat([1 / LEVER_MM, 1.0], 3), arm.joint_count)


def tip_by_links(moves: FlangeMotion, tip_mm: Floats) -> Floats:
    """(P, 3, 6n) translation of the tip (3,) on the flange, arm frame, by the links' errors."""
    pairs = zip(moves.T_arm_flange, moves.by_links, strict=True)
    return np.array([tip_shift(T, tip_mm) @ by_links for T, by_links in pairs])

"""The arm's geometry as one vector of named parameters, and the derivatives of the tip by each."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.arm.kinematics import Arm, Joint, Tip
from crenel.metrology.arm.link_error import LinkError, error_transform
from crenel.metrology.transforms import Floats

LINK_TERMS = ("a_mm", "alpha_rad", "d_mm", "theta_rad")
ERROR_TERMS = ("x_mm", "y_mm", "z_mm", "rx_rad", "ry_rad", "rz_rad")
Indices = NDArray[np.intp]

TERMS = len(LINK_TERMS) + len(ERROR_TERMS)
A, ALPHA, D, THETA, ERROR = 0, 1, 2, 3, 4
ERROR_RY = ERROR + ERROR_TERMS.index("ry_rad")


def parameter_names(arm: Arm) -> tuple[str, ...]:
    """Names of the vector's elements: ``J1.a_mm`` … ``J6.error.rz_rad``, ``tip.x_mm`` …"""
    links = [
        f"{joint.name}.{term}"
        for joint in arm.joints
        for term in (*LINK_TERMS, *(f"error.{name}" for name in ERROR_TERMS))
    ]
    return (*links, "tip.x_mm", "tip.y_mm", "tip.z_mm")


def parameter_index(joint: int, term: int) -> int:
    """Index of a term of a joint (0-based) in the vector."""
    return joint * TERMS + term


def tip_index(arm: Arm) -> int:
    """Index of the first of the tip's three coordinates in the vector."""
    return arm.joint_count * TERMS


def parameter_values(arm: Arm) -> Floats:
    """The geometry of an arm as one vector: D-H and error terms of each link, then the tip.

    Returns:
        (10 n + 3,) in mm and rad, in the order of ``parameter_names``.

    Source:
        Eq. 2 and 3 of the article.
    """
    values: list[float] = []
    for joint in arm.joints:
        e = joint.error
        values += [joint.a_mm, joint.alpha_rad, joint.d_mm, joint.theta_rad]
        values += [e.x_mm, e.y_mm, e.z_mm, e.rx_rad, e.ry_rad, e.rz_rad]
    return np.array([*values, *arm.tip.centre_mm])


def with_parameters(arm: Arm, values: Floats) -> Arm:
    """The arm with its geometry replaced; inverse of ``parameter_values``.

    Args:
        values: (10 n + 3,) in mm and rad, in the order of ``parameter_names``.
    """
    joints: list[Joint] = []
    for i, joint in enumerate(arm.joints):
        a, alpha, d, theta, *error = (float(v) for v in values[i * TERMS : (i + 1) * TERMS])
        joints.append(
            replace(
                joint,
                a_mm=a,
                alpha_rad=alpha,
                d_mm=d,
                theta_rad=theta,
                error=LinkError(*error),
            )
        )
    x, y, z = (float(v) for v in values[-3:])
    return replace(arm, joints=tuple(joints), tip=Tip(x, y, z, arm.tip.diameter_mm))


def tip_jacobian(arm: Arm, q_rad: Floats) -> tuple[Floats, Floats]:
    """Tip centres, and their exact derivatives by every parameter of the arm: ``pose_jacobian``
    without the rotations.

    Returns:
        (N, 3) in mm, arm frame, and (N, 3, 10 n + 3) in mm per mm and mm per rad, in the order of
        ``parameter_names``.
    """
    poses = pose_jacobian(arm, q_rad)
    return poses.tips_mm, poses.by_parameters


@dataclass(frozen=True)
class PoseJacobian:
    """Tips and flange rotations, and their derivatives by every parameter of the arm."""

    tips_mm: Floats
    """(N, 3) arm frame."""
    rotations: Floats
    """(N, 3, 3) of ``T_arm_flange``."""
    by_parameters: Floats
    """(N, 3, 10 n + 3) of the tips, in mm per mm and mm per rad."""
    turns: Floats
    """(N, 3, 10 n + 3) rotation of the flange about the arm's axes, in rad per mm and per rad."""


def pose_jacobian(arm: Arm, q_rad: Floats) -> PoseJacobian:
    """Tips and flange rotations, and their exact derivatives by every parameter of the arm.

    Each parameter moves the tip along an axis, or turns it about one, of the frame that the
    parameter belongs to.

    Args:
        q_rad: (N, n) encoder angles, before sign and offset.

    Returns:
        Parameters are in the order of ``parameter_names``.

    Source:
        Eq. 2 and 3 of the article.
    """
    q = np.asarray(q_rad, dtype=np.float64)
    count = len(q)
    # rotation and origin of the frame before each term, walked from the base to the tip
    base = error_transform(arm.base)
    R = np.broadcast_to(base[:3, :3], (count, 3, 3))
    o = np.tile(base[:3, 3], (count, 1))
    moves: list[tuple[int, Floats]] = []  # (index, axis to move along)
    turns: list[tuple[int, Floats, Floats]] = []  # (index, axis to rotate about, a point on it)
    for i, joint in enumerate(arm.joints):
        at = i * TERMS
        angle = joint.sign * q[:, i] + joint.theta_rad
        turns.append((at + THETA, R[:, :, 2], o))
        moves.append((at + D, R[:, :, 2]))
        o = o + joint.d_mm * R[:, :, 2]
        R = R @ _about_z(angle)
        moves.append((at + A, R[:, :, 0]))
        o = o + joint.a_mm * R[:, :, 0]
        turns.append((at + ALPHA, R[:, :, 0], o))
        R = R @ _about_x(joint.alpha_rad)
        E = joint.error
        moves += [(at + ERROR + k, R[:, :, k]) for k in range(3)]
        o = o + R @ np.array([E.x_mm, E.y_mm, E.z_mm])
        turns.append((at + ERROR + 5, R[:, :, 2], o))
        about_z = R @ error_transform(LinkError(rz_rad=E.rz_rad))[:3, :3]
        turns.append((at + ERROR + 4, about_z[:, :, 1], o))
        R = R @ error_transform(replace(E, x_mm=0.0, y_mm=0.0, z_mm=0.0))[:3, :3]
        turns.append((at + ERROR + 3, R[:, :, 0], o))
    tips = o + R @ arm.tip.centre_mm
    J = np.empty((count, 3, arm.joint_count * TERMS + 3))
    for index, axis in moves:
        J[:, :, index] = axis
    axes = np.stack([axis for _, axis, _ in turns], axis=2)
    levers = tips[:, :, None] - np.stack([point for _, _, point in turns], axis=2)
    turning = [index for index, _, _ in turns]
    J[:, :, turning] = np.cross(axes, levers, axis=1)
    J[:, :, -3:] = R
    W = np.zeros(J.shape)
    W[:, :, turning] = axes
    return PoseJacobian(tips, R, J, W)


def _about_z(angle_rad: Floats) -> Floats:
    c, s = np.cos(angle_rad), np.sin(angle_rad)
    R = np.zeros((len(angle_rad), 3, 3))
    R[:, 0, 0], R[:, 0, 1], R[:, 1, 0], R[:, 1, 1] = c, -s, s, c
    R[:, 2, 2] = 1.0
    return R


def _about_x(angle_rad: float) -> Floats:
    c, s = np.cos(angle_rad), np.sin(angle_rad)
    return np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])

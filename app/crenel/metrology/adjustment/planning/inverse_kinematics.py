"""Joint angles that bring the flange to a pose: whether the arm can reach a pose."""

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.arm.kinematics import Arm, flange_poses, geometric_jacobians
from crenel.metrology.transforms import Floats, vector_from_rotation

# Weight of one radian of orientation, as a length.
LEVER_MM = 200.0
REACHED_MM = 0.05
MOST_STEPS = 60
DAMPING = 1e-3
LARGEST_STEP_RAD = 0.2


def solve_inverse_kinematics(arm: Arm, T_arm_flange: Floats, q_rad: Floats) -> Floats | None:
    """Encoder angles near given ones that bring the flange to a pose.

    Damped least squares, held within the limits of the joints.

    Args:
        T_arm_flange: (4, 4) pose to reach.
        q_rad: (n,) encoder angles to start from.

    Returns:
        (n,) rad; None if the pose is out of reach.
    """
    q, reached = solve_each(arm, T_arm_flange[None], np.asarray(q_rad)[None])
    return q[0] if reached[0] else None


def solve_each(arm: Arm, T_arm_flange: Floats, q_rad: Floats) -> tuple[Floats, NDArray[np.bool_]]:
    """``solve_inverse_kinematics`` for poses (N, 4, 4) at once, each from its own angles (N, n).

    Returns:
        (N, n) rad, and (N,) which poses are reached with them.
    """
    q, missed_mm = _descend(arm, T_arm_flange, q_rad)
    return q, missed_mm < REACHED_MM


def nearest_joints(arm: Arm, T_arm_flange: Floats, q_rad: Floats) -> Floats:
    """Encoder angles near given ones that bring the flange as near to a pose as the arm can.

    An arm of five joints reaches almost no pose exactly. Arguments are those of
    ``solve_inverse_kinematics``.
    """
    return np.asarray(_descend(arm, T_arm_flange[None], np.asarray(q_rad)[None])[0][0])


def _descend(arm: Arm, T_arm_flange: Floats, q_rad: Floats) -> tuple[Floats, Floats]:
    """Encoder angles (N, n), and what is missed with them (N,) in mm; a radian weighs as
    ``LEVER_MM``."""
    low, high = np.array([joint.limits_rad for joint in arm.joints]).T
    q = np.clip(np.asarray(q_rad, dtype=np.float64), low, high)
    weigh = np.repeat([1.0, LEVER_MM], 3)
    missed_mm = np.full(len(q), np.inf)
    left = np.arange(len(q))  # those that are still on their way
    for _ in range(MOST_STEPS):
        T, wanted = flange_poses(arm, q[left]), T_arm_flange[left]
        turn = vector_from_rotation(wanted[:, :3, :3] @ T[:, :3, :3].transpose(0, 2, 1))
        off = weigh * np.concatenate([wanted[:, :3, 3] - T[:, :3, 3], turn], axis=1)
        missed_mm[left] = np.linalg.norm(off, axis=1)
        going = missed_mm[left] >= REACHED_MM
        left, off = left[going], off[going]
        if not len(left):
            break
        J = weigh[:, None] * geometric_jacobians(arm, q[left], np.zeros(3))
        N = J.transpose(0, 2, 1) @ J
        damping = DAMPING * np.trace(N, axis1=1, axis2=2) / q.shape[1]
        N += damping[:, None, None] * np.eye(q.shape[1])
        step = np.linalg.solve(N, J.transpose(0, 2, 1) @ off[..., None])[..., 0]
        longest = np.maximum(np.abs(step).max(axis=1), 1e-12)
        step *= np.minimum(1.0, LARGEST_STEP_RAD / longest)[:, None]
        q[left] = np.clip(q[left] + step, low, high)
    return q, missed_mm

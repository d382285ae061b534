"""Joint angles that bring the flange to a pose: whether the arm can reach a pose."""

import numpy as np

from app.metrology.arm.kinematics import Arm, flange_pose, geometric_jacobian
from app.metrology.transforms import Floats, vector_from_rotation

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
    q, off_mm = _descend(arm, T_arm_flange, q_rad)
    return q if off_mm < REACHED_MM else None


def nearest_joints(arm: Arm, T_arm_flange: Floats, q_rad: Floats) -> Floats:
    """Encoder angles near given ones that bring the flange as near to a pose as the arm can.

    An arm of five joints reaches almost no pose exactly. Arguments are those of
    ``solve_inverse_kinematics``.
    """
    return _descend(arm, T_arm_flange, q_rad)[0]


def _descend(arm: Arm, T_arm_flange: Floats, q_rad: Floats) -> tuple[Floats, float]:
    """Encoder angles (n,), and what is missed with them in mm; a radian weighs as ``LEVER_MM``."""
    low, high = np.array([joint.limits_rad for joint in arm.joints]).T
    q = np.clip(np.asarray(q_rad, dtype=np.float64), low, high)
    weigh = np.repeat([1.0, LEVER_MM], 3)
    missed_mm = np.inf
    for _ in range(MOST_STEPS):
        T = flange_pose(arm, q)
        turn = vector_from_rotation(T_arm_flange[:3, :3] @ T[:3, :3].T)
        off = weigh * np.concatenate([T_arm_flange[:3, 3] - T[:3, 3], turn])
        missed_mm = float(np.linalg.norm(off))
        if missed_mm < REACHED_MM:
            break
        J = weigh[:, None] * geometric_jacobian(arm, q, np.zeros(3))
        damped = J.T @ J + DAMPING * float(np.trace(J.T @ J)) / len(q) * np.eye(len(q))
        step = np.linalg.solve(damped, J.T @ off)
        step *= min(1.0, LARGEST_STEP_RAD / max(float(np.abs(step).max()), 1e-12))
        q = np.clip(q + step, low, high)
    return q, missed_mm

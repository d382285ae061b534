"""The flange pose by the readings of an arm: joint angles, or poses from a robot.

``readings`` are (N, n) encoder angles in rad of an ``Arm``, or (N, 4, 4) ``T_arm_flange``
of a ``RobotArm``.
"""

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.adjustment.core.arm_errors import (
    FlangeMotion,
    arm_motion,
    robot_motion,
    tip_shift,
)
from crenel.metrology.adjustment.core.observations import ContactObservations
from crenel.metrology.adjustment.core.robot_noise import RobotNoise, with_flange_noise
from crenel.metrology.arm.kinematics import Arm, RobotArm, tip_covariances
from crenel.metrology.transforms import Floats


def flange_motion(arm: Arm | RobotArm, readings: Floats) -> FlangeMotion:
    """The poses of the flange, and their derivatives by small errors.

    Raises:
        OperationError: readings of another arm, or values that are not numbers.
    """
    wanted = (arm.joint_count,) if isinstance(arm, Arm) else (4, 4)
    if readings.shape[1:] != wanted:
        raise OperationError(
            "joint-count",
            message("readings-shape-arm", shape=str(readings.shape[1:]), name=arm.name),
            message("expected", wanted=str(wanted)),
            message("check-session-taken-arm"),
        )
    if not np.isfinite(readings).all():
        raise OperationError(
            "angles-not-finite", message("reading-of-arm-not-a-number", name=arm.name)
        )
    return arm_motion(arm, readings) if isinstance(arm, Arm) else robot_motion(readings)


def plane_contacts(
    arm: Arm | RobotArm,
    feature: str,
    readings: Floats,
    coordinates: int,
    noise: RobotNoise | None = None,
) -> ContactObservations:
    """Contact points (N) on the plane z = 0 of an object with this number of coordinates.

    Args:
        noise: the noise of a robot: rotation and translation of its flange.

    Raises:
        OperationError: the arm has no tip.
    """
    if arm.tip is None:
        raise OperationError(
            "tip-missing",
            message("contacts-arm-has-no-tip", readings=len(readings), name=arm.name),
            message("contacts-tips-sphere"),
            message("give-tip-or-leave-out-probing"),
        )
    moves = flange_motion(arm, readings)
    if noise is not None:
        moves = with_flange_noise(moves, noise)
    T, count = moves.T_arm_flange, len(readings)
    shifts = np.array([tip_shift(one, arm.tip.centre_mm) for one in T]).reshape(count, 3, 6)
    by_noise = shifts @ moves.by_noise * moves.noise_sd
    noise_mm2 = (
        tip_covariances(arm, readings)
        if isinstance(arm, Arm)
        else by_noise @ by_noise.transpose(0, 2, 1)
    )
    return ContactObservations(
        (feature,) * count,
        np.tile([0.0, 0.0, 1.0], (count, 1)),
        np.zeros((count, coordinates)),
        arm.tip.radius_mm,
        T[:, :3, :3] @ arm.tip.centre_mm + T[:, :3, 3],
        T[:, :3, :3],
        shifts @ moves.by_links,
        noise_mm2,
        np.ones(count, dtype=np.bool_),
    )

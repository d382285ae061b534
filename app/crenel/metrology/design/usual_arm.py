"""A portable arm as many are built, and where it works: for accuracies before an arm is chosen."""

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.adjustment.planning.inverse_kinematics import solve_each
from crenel.metrology.arm.kinematics import Arm, Joint, Tip
from crenel.metrology.transforms import Floats, rigid, rotation_from_vector

ENCODER_SD_RAD = 1e-5
STARTS = 60
"""Joint angles from which a pose is tried that is not reached from the posture before."""
PLACES = 8
BEARINGS_RAD, DISTANCES_MM, HEIGHTS_MM = (-0.5, 0.5), (480.0, 640.0), (80.0, 135.0)
TURNS_RAD = (-0.7, 0.7)
"""Where on a table before the arm the block may stand, and how it is turned there."""


def usual_arm() -> Arm:
    """Six axes, 1.2 m from the base to the flange, encoders of 10 µrad."""
    right, wide = np.pi / 2, np.radians(170.0)
    table = (
        (0.0, -right, 310.0, 0.0, 1),
        (550.0, 0.0, 0.0, -right, 1),
        (30.0, -right, 0.0, 0.0, 1),
        (0.0, right, 530.0, 0.0, 1),
        (0.0, -right, 0.0, 0.0, 1),
        (0.0, 0.0, 80.0, 0.0, 1),
    )
    joints = tuple(
        Joint(f"J{n + 1}", a, alpha, d, theta, sign, (-wide, wide), ENCODER_SD_RAD)
        for n, (a, alpha, d, theta, sign) in enumerate(table)
    )
    return Arm("Usual portable arm", "", joints, Tip(0.0, -10.0, 165.0, 3.0))


def table_places() -> list[Floats]:
    """Poses (4, 4) of a block on the table before the arm, ``T_arm_obj``: spread over where an
    operator may put it, and the same each time."""
    rng = np.random.default_rng(5)
    places = []
    for _ in range(PLACES):
        bearing, distance_mm, height_mm, turn = (
            rng.uniform(*span) for span in (BEARINGS_RAD, DISTANCES_MM, HEIGHTS_MM, TURNS_RAD)
        )
        at = [distance_mm * np.cos(bearing), distance_mm * np.sin(bearing), height_mm]
        places.append(
            rigid(rotation_from_vector(np.array([0.0, 0.0, bearing + turn])), np.array(at))
        )
    return places


def take_postures(arm: Arm, T_arm_flange: Floats) -> Floats:
    """Joint angles for poses of the flange, as an arm takes them that comes from its middle.

    The first pose (4, 4) decides the posture, in which the arm remains where its joints allow.

    Args:
        T_arm_flange: (N, 4, 4) poses, in any order after the first.

    Returns:
        (N, n) encoder angles in rad.

    Raises:
        OperationError: ``arm-cannot-reach``.
    """
    low, high = np.array([joint.limits_rad for joint in arm.joints]).T
    middle = np.clip(np.zeros(len(low)), low, high)
    first = _take_near(arm, T_arm_flange[:1], middle)
    return np.concatenate([first, _take_near(arm, T_arm_flange[1:], first[0])])


def arm_cannot_reach(arm: Arm) -> OperationError:
    """The error if an arm cannot touch a block and look at it anywhere on the table."""
    return OperationError(
        "arm-cannot-reach",
        message("arm-reaches-no-place-for-block", arm=arm.name),
        "",
        message("check-arms-file-lengths-angles-signs"),
    )


def _take_near(arm: Arm, T_arm_flange: Floats, posture_rad: Floats) -> Floats:
    """Joint angles (N, n) for poses (N, 4, 4), reached from a posture (n,) or the nearest to it."""
    q, reached = solve_each(arm, T_arm_flange, np.tile(posture_rad, (len(T_arm_flange), 1)))
    low, high = np.array([joint.limits_rad for joint in arm.joints]).T
    starts = np.random.default_rng(1).uniform(low, high, (STARTS, len(low)))
    for missed in np.flatnonzero(~reached):
        others, there = solve_each(arm, np.tile(T_arm_flange[missed], (STARTS, 1, 1)), starts)
        if not there.any():
            raise arm_cannot_reach(arm)
        others = others[there]
        q[missed] = others[np.argmin(np.linalg.norm(others - posture_rad, axis=1))]
    return q

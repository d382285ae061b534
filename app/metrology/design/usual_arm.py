"""A portable arm as many are built, and where it works: for accuracies before an arm is chosen."""

import numpy as np

from app.errors import OperationError
from app.messages.message import message
from app.metrology.adjustment.planning.inverse_kinematics import solve_inverse_kinematics
from app.metrology.arm.kinematics import Arm, Joint, Tip
from app.metrology.transforms import Floats, rigid, rotation_from_vector

ENCODER_SD_RAD = 1e-5
STARTS = 60
"""Joint angles from which a first pose is tried."""
POSTURES = 6
"""Solutions among which another posture is looked for."""
BEARINGS_RAD = (0.0, 0.4, -0.4)
DISTANCES_MM = (560.0, 480.0, 640.0)
TABLE_MM = 100.0
"""Places on the table at which the block is tried, and their height in the arm frame."""


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
    """Poses (4, 4) of a block on the table before the arm, ``T_arm_obj``, the likeliest first."""
    places = []
    for distance_mm in DISTANCES_MM:
        for bearing in BEARINGS_RAD:
            at = distance_mm * np.array([np.cos(bearing), np.sin(bearing), 0.0])
            turn = rotation_from_vector(np.array([0.0, 0.0, bearing + 0.3]))
            places.append(rigid(turn, at + [0.0, 0.0, TABLE_MM]))
    return places


class PostureFinder:
    """Joint angles for poses of the flange, each tried from the one found before."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm
        self._before: Floats | None = None
        low, high = np.array([joint.limits_rad for joint in arm.joints]).T
        self._starts = [np.clip(np.zeros(len(low)), low, high)]
        self._starts += list(np.random.default_rng(1).uniform(low, high, (STARTS, len(low))))

    def joints_rad(self, T_arm_flange: Floats) -> Floats:
        """Encoder angles (n,) that bring the flange to a pose (4, 4).

        Raises:
            OperationError: ``arm-cannot-reach``.
        """
        first = [] if self._before is None else [self._before]
        for start in (*first, *self._starts):
            found = solve_inverse_kinematics(self._arm, T_arm_flange, start)
            if found is not None:
                self._before = found
                return found
        raise OperationError(
            "arm-cannot-reach",
            message("arm-reaches-no-place-for-block", arm=self._arm.name),
            "",
            message("check-arms-file-lengths-angles-signs"),
        )

    def stand_otherwise(self, T_arm_flange: Floats, q_rad: Floats) -> None:
        """Begins in the posture for a pose (4, 4) that is least like given angles (n,), if any."""
        postures: list[Floats] = []
        for start in self._starts:
            found = solve_inverse_kinematics(self._arm, T_arm_flange, start)
            if found is not None:
                postures.append(found)
            if len(postures) == POSTURES:
                break
        if postures:
            self._before = max(postures, key=lambda q: float(np.linalg.norm(q - q_rad)))

"""Where an arm stood, by the columns of a table: joint angles, or a robot's flange poses."""

from collections.abc import Sequence

import numpy as np

from app.files.flange_poses import FlangePoses
from app.files.joint_angles import JointAngles
from app.files.tables import Row, Table
from app.metrology.arm import Arm, RobotArm
from app.metrology.frames import Floats


class ArmReadings:
    """The columns of one table, for one arm."""

    def __init__(self, table: Table, arm: Arm | RobotArm) -> None:
        self._angles = JointAngles(table, arm) if isinstance(arm, Arm) else None
        self._poses = None if isinstance(arm, Arm) else FlangePoses(table)

    def of(self, row: Row) -> tuple[Floats, Floats | None]:
        """Angles (n,) and no pose, or no angles (0,) and ``T_arm_flange`` (4, 4)."""
        if self._angles is not None:
            return self._angles.of(row), None
        assert self._poses is not None
        return np.zeros(0), self._poses.of(row)

    def of_all(self, rows: Sequence[Row]) -> tuple[Floats, Floats | None]:
        """The same of all rows; ``Refusal`` where they are evidently in other units."""
        each = [self.of(row) for row in rows]
        angles = np.array([q for q, _ in each])
        if self._angles is not None:
            self._angles.refuse_radians(list(angles))
            return angles, None
        assert self._poses is not None
        poses = [T for _, T in each if T is not None]
        self._poses.refuse_metres(poses)
        return angles, np.array(poses)

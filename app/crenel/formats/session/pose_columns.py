"""Pose columns of a table: joint angles, or the flange poses of a robot."""

import re
from collections.abc import Sequence

import numpy as np

from crenel.errors import OperationError
from crenel.formats.csv_table import CsvTable, TableRow
from crenel.formats.file_names import display_path
from crenel.formats.session.flange_columns import FlangePoses
from crenel.messages.message import message, rounded
from crenel.metrology.arm.kinematics import AnyArm, Arm
from crenel.metrology.transforms import Floats


class ArmReadings:
    """The columns of one table, for one arm."""

    def __init__(self, table: CsvTable, arm: AnyArm) -> None:
        self._angles = JointAngles(table, arm) if isinstance(arm, Arm) else None
        self._poses = None if isinstance(arm, Arm) else FlangePoses(table, arm.rotation)

    def read_row(self, row: TableRow) -> tuple[Floats, Floats | None]:
        """Angles (n,) without a pose, or no angles (0,) with ``T_arm_flange`` (4, 4)."""
        if self._angles is not None:
            return self._angles.read_row(row), None
        assert self._poses is not None
        return np.zeros(0), self._poses.read_row(row)

    def read_rows(self, rows: Sequence[TableRow]) -> tuple[Floats, Floats | None]:
        """The same for all rows; ``OperationError`` if they are clearly in other units."""
        each = [self.read_row(row) for row in rows]
        angles = np.array([q for q, _ in each])
        if self._angles is not None:
            self._angles.refuse_radians(list(angles))
            return angles, None
        assert self._poses is not None
        poses = [T for _, T in each if T is not None]
        self._poses.refuse_other_units(rows, poses)
        return angles, np.array(poses)


STOP_TOLERANCE_DEG = 0.5
"""An arm that rests at its stop may read slightly beyond its limit."""


MOST_TURNS_DEG = 1500.0
"""No joint with a limit turns so far; 26 degrees that are taken for radians are more."""


def joint_columns(count: int) -> tuple[str, ...]:
    """``q1_deg`` … ``qN_deg``"""
    return tuple(f"q{i + 1}_deg" for i in range(count))


class JointAngles:
    """The ``q…_deg`` columns of a table, for one arm."""

    def __init__(self, table: CsvTable, arm: Arm) -> None:
        """Raises ``OperationError`` unless the table has one column per joint of the arm."""
        self._path = table.path
        self._arm = arm
        self._columns = joint_columns(arm.joint_count)
        first, last = self._columns[0], self._columns[-1]
        found = [name for name in table.columns if re.fullmatch(r"q\d+_deg", name)]
        if any(re.fullmatch(r"q\d+(_rad)?", name) for name in table.columns):
            raise OperationError(
                "columns-without-degrees",
                message(
                    "table-first-line-names",
                    path=display_path(table.path),
                    names=", ".join(table.columns),
                ),
                message("joint-angles-given-degrees"),
                message("name-columns-of-degrees", first=first, last=last)
                if _holds_degrees(table)
                else message("convert-them-name-columns", first=first, last=last),
            )
        if sorted(found) != sorted(self._columns):
            raise OperationError(
                "joint-count",
                message(
                    "joint-columns-or-none",
                    path=display_path(table.path),
                    count=len(found),
                    names=", ".join(found),
                ),
                message(
                    "arm-has-joints",
                    arm=arm.serial_number or arm.name,
                    count=arm.joint_count,
                ),
                message("give-right-arm-json-columns", first=first, last=last),
            )

    def read_row(self, row: TableRow) -> Floats:
        """The angles (n,) of a row in radians; ``OperationError`` outside the arm's limits."""
        q_deg = np.array([row.number(column) for column in self._columns])
        for joint, column, angle in zip(self._arm.joints, self._columns, q_deg, strict=True):
            low, high = np.rad2deg(joint.limits_rad)
            if not low - STOP_TOLERANCE_DEG <= angle <= high + STOP_TOLERANCE_DEG:
                raise OperationError(
                    "joint-outside-limits",
                    message("column-is", place=row.place, column=column, value=rounded(angle, "°")),
                    message(
                        "named-joint-range",
                        joint=joint.name,
                        low=rounded(low, "°"),
                        high=rounded(high, "°"),
                    ),
                    message("degrees-converted-twice")
                    if abs(angle) > MOST_TURNS_DEG
                    else message("correct-value-or-give-arm-json"),
                )
        return np.asarray(np.deg2rad(q_deg))

    def refuse_radians(self, q_rad: Sequence[Floats]) -> None:
        """Refuses a table that clearly contains radians.

        If an arm over an object had all its joint angles within 6.3 degrees of zero, it would be
        stretched out straight.
        """
        largest_deg = float(np.max(np.abs(np.rad2deg(q_rad))))
        if 0 < largest_deg <= 2 * np.pi:
            raise OperationError(
                "joints-in-radians",
                message(
                    "no-joint-angle-exceeds",
                    path=display_path(self._path),
                    largest=f"{largest_deg:.4g}",
                ),
                message("these-radians-where-degrees-expected"),
                message("convert-columns-degrees"),
            )


def _holds_degrees(table: CsvTable) -> bool:
    """Whether columns of joints that are not called degrees hold some all the same."""
    names = [name for name in table.columns if re.fullmatch(r"q\d+(_rad)?", name)]
    largest = max((abs(row.number(name)) for row in table.rows for name in names), default=0.0)
    return largest > 4 * np.pi

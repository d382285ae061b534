"""Pose columns of a table: joint angles, or the flange poses of a robot."""

import re
from collections.abc import Sequence

import numpy as np

from app.errors import OperationError
from app.formats.csv_table import CsvTable, TableRow
from app.formats.file_names import display_path
from app.messages.message import message, quantity, rounded
from app.metrology.arm.kinematics import AnyArm, Arm
from app.metrology.transforms import Floats, rigid


class ArmReadings:
    """The columns of one table, for one arm."""

    def __init__(self, table: CsvTable, arm: AnyArm) -> None:
        self._angles = JointAngles(table, arm) if isinstance(arm, Arm) else None
        self._poses = None if isinstance(arm, Arm) else FlangePoses(table)

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
        self._poses.refuse_metres(poses)
        return angles, np.array(poses)


COLUMNS = ("x_mm", "y_mm", "z_mm", "qx", "qy", "qz", "qw")
UNIT_TOLERANCE = 1e-3
"""Deviation from unit length of quaternions written with four digits."""
FEW_DIGITS = 0.02
"""Deviation from unit length of those written with two or three."""
REACH_MM = 5.0
"""If the flange of a robot never gets further than this from its base, the unit is probably
metres."""


class FlangePoses:
    """The pose columns of a table; ``T_arm_flange`` of its rows."""

    def __init__(self, table: CsvTable) -> None:
        """Raises ``OperationError`` unless the table has the columns, in these units."""
        self._path = table.path
        missing = [name for name in COLUMNS if name not in table.columns]
        if not missing:
            return
        have, needed = ", ".join(table.columns), ", ".join(COLUMNS)
        why = message("first-line-names", names=have)
        remedy = message("must-name", names=needed)
        if any(re.fullmatch(r"q\d+_deg", name) for name in table.columns):
            why = message("these-joint-angles-but-arm-json")
            remedy = message("give-arms-own-model-columns", names=needed)
        elif {"x", "y", "z"} <= set(table.columns) or "x_m" in table.columns:
            remedy = message("convert-lengths-mm-name-columns", names=needed)
        raise OperationError(
            "columns-missing",
            message("no-column", path=display_path(table.path), names=", ".join(missing)),
            why,
            remedy,
        )

    def read_row(self, row: TableRow) -> Floats:
        """``T_arm_flange`` (4, 4) of a row; ``OperationError`` if the quaternion is invalid."""
        from scipy.spatial.transform import Rotation  # slow to import; most arms have angles

        position = np.array([row.number(column) for column in COLUMNS[:3]])
        return rigid(Rotation.from_quat(unit_quaternion(row)).as_matrix(), position)

    def refuse_metres(self, poses: Sequence[Floats]) -> None:
        """Refuses a table whose lengths are clearly in metres."""
        furthest = max(float(np.linalg.norm(T[:3, 3])) for T in poses)
        if 0 < furthest < REACH_MM:
            raise OperationError(
                "poses-in-metres",
                message(
                    "no-flange-further-than",
                    path=display_path(self._path),
                    furthest=rounded(furthest, "mm", 4),
                ),
                message("these-metres-where-millimetres-expected"),
                message("convert-columns-x-mm-y-mm"),
            )


def unit_quaternion(row: TableRow) -> Floats:
    """(4,) qx, qy, qz, qw of a row; ``OperationError`` unless it has the length 1."""
    values = np.array([row.number(column) for column in COLUMNS[3:]])
    length = float(np.linalg.norm(values))
    if abs(length - 1) > UNIT_TOLERANCE:
        raise OperationError(
            "quaternion-not-unit",
            message("quaternion-length", place=row.place, length=quantity(length, "", 4)),
            message("rotations-quaternion-has-length-1"),
            message("give-quaternions-with-more-digits")
            if abs(length - 1) < FEW_DIGITS
            else message("give-qx-qy-qz-qw-order"),
        )
    return values


def pose_cells(T_arm_flange: Floats) -> tuple[float, ...]:
    """The cells of ``COLUMNS``."""
    from scipy.spatial.transform import Rotation

    quaternion = Rotation.from_matrix(T_arm_flange[:3, :3]).as_quat()
    return (*T_arm_flange[:3, 3].tolist(), *quaternion.tolist())


STOP_TOLERANCE_DEG = 0.5
"""An arm that rests at its stop may read slightly beyond its limit."""


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
                message(
                    "convert-them-name-columns",
                    first=self._columns[0],
                    last=self._columns[-1],
                ),
            )
        if sorted(found) != sorted(self._columns):
            raise OperationError(
                "joint-count",
                message(
                    "has-joint-columns",
                    path=display_path(table.path),
                    count=len(found),
                    names=", ".join(found),
                ),
                message(
                    "arm-has-joints",
                    arm=arm.serial_number or arm.name,
                    count=arm.joint_count,
                ),
                message(
                    "give-right-arm-json-columns",
                    first=self._columns[0],
                    last=self._columns[-1],
                ),
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
                    message("correct-value-or-give-arm-json"),
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

"""Joint angles in tables: degrees in the file, radians in memory, checked against the arm."""

import re
from collections.abc import Sequence

import numpy as np

from app.files.names import shown_path
from app.files.tables import Row, Table
from app.metrology.arm import Arm
from app.metrology.frames import Floats
from app.metrology.refusal import Refusal

STOP_TOLERANCE_DEG = 0.5
"""An arm that rests at its stop may read a little past its limit."""


def joint_columns(count: int) -> tuple[str, ...]:
    """``q1_deg`` … ``qN_deg``"""
    return tuple(f"q{i + 1}_deg" for i in range(count))


class JointAngles:
    """The ``q…_deg`` columns of a table, for one arm."""

    def __init__(self, table: Table, arm: Arm) -> None:
        """Raises ``Refusal`` unless the table has one column a joint of the arm."""
        self._path = table.path
        self._arm = arm
        self._columns = joint_columns(arm.joint_count)
        found = [name for name in table.columns if re.fullmatch(r"q\d+_deg", name)]
        if any(re.fullmatch(r"q\d+(_rad)?", name) for name in table.columns):
            raise Refusal(
                "columns-without-degrees",
                f"{shown_path(table.path)}: its first line names {', '.join(table.columns)}",
                "joint angles are given in degrees",
                f"Convert them and name the columns {self._columns[0]} to {self._columns[-1]}",
            )
        if sorted(found) != sorted(self._columns):
            raise Refusal(
                "joint-count",
                f"{shown_path(table.path)} has "
                f"{len(found)} joint columns ({', '.join(found) or 'none'})",
                f"the arm {arm.serial_number or arm.name} has {arm.joint_count} joints",
                f"Give the right arm.json, or columns {self._columns[0]} to {self._columns[-1]}",
            )

    def of(self, row: Row) -> Floats:
        """The angles (n,) of a row in radians; ``Refusal`` outside the arm's limits."""
        q_deg = np.array([row.number(column) for column in self._columns])
        for joint, column, angle in zip(self._arm.joints, self._columns, q_deg, strict=True):
            low, high = np.rad2deg(joint.limits_rad)
            if not low - STOP_TOLERANCE_DEG <= angle <= high + STOP_TOLERANCE_DEG:
                raise Refusal(
                    "joint-outside-limits",
                    f"{row.place}: {column} is {angle:g}°",
                    f"joint {joint.name} turns from {low:g}° to {high:g}°",
                    "Correct the value, or give the right arm.json",
                )
        return np.asarray(np.deg2rad(q_deg))

    def refuse_radians(self, q_rad: Sequence[Floats]) -> None:
        """Refuses a table that evidently holds radians.

        An arm over an object never has all its joints within one turn's worth of
        radians (6.3 degrees) of zero: it would be stretched out straight.
        """
        largest_deg = float(np.max(np.abs(np.rad2deg(q_rad))))
        if 0 < largest_deg <= 2 * np.pi:
            raise Refusal(
                "joints-in-radians",
                f"{shown_path(self._path)}: no joint angle exceeds {largest_deg:.4g}",
                "these are radians where degrees are expected",
                "Convert the columns to degrees",
            )

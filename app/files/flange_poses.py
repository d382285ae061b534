"""Flange poses in tables: millimetres and a unit quaternion, as a robot's controller has them."""

import re
from collections.abc import Sequence

import numpy as np

from app.files.names import shown_path
from app.files.tables import Row, Table
from app.metrology.frames import Floats, rigid
from app.metrology.refusal import Refusal

COLUMNS = ("x_mm", "y_mm", "z_mm", "qx", "qy", "qz", "qw")
UNIT_TOLERANCE = 1e-3
"""Quaternions written with four digits are this far from unit length at most."""
REACH_MM = 5.0
"""Robots whose flange never gets further than this from their base are rather in metres."""


class FlangePoses:
    """The pose columns of a table; ``T_arm_flange`` of its rows."""

    def __init__(self, table: Table) -> None:
        """Raises ``Refusal`` unless the table has the columns, in these units."""
        self._path = table.path
        missing = [name for name in COLUMNS if name not in table.columns]
        if not missing:
            return
        have = ", ".join(table.columns)
        why, remedy = f"the first line names {have}", f"It must name {', '.join(COLUMNS)}"
        if any(re.fullmatch(r"q\d+_deg", name) for name in table.columns):
            why = "these are joint angles, but arm.json says that the arm reports poses"
            remedy = f"Give the arm's own model, or columns {', '.join(COLUMNS)}"
        elif {"x", "y", "z"} <= set(table.columns) or "x_m" in table.columns:
            remedy = f"Convert lengths to mm, and name the columns {', '.join(COLUMNS)}"
        raise Refusal(
            "columns-missing",
            f"{shown_path(table.path)}: no column {', '.join(missing)}",
            why,
            remedy,
        )

    def of(self, row: Row) -> Floats:
        """``T_arm_flange`` (4, 4) of a row; ``Refusal`` where the quaternion is none."""
        from scipy.spatial.transform import Rotation  # slow to load; most arms give angles

        values = np.array([row.number(column) for column in COLUMNS])
        length = float(np.linalg.norm(values[3:]))
        if abs(length - 1) > UNIT_TOLERANCE:
            raise Refusal(
                "quaternion-not-unit",
                f"{row.place}: (qx, qy, qz, qw) is {length:.4f} long",
                "a rotation's quaternion has length 1",
                "Give qx, qy, qz, qw in this order, the scalar last",
            )
        return rigid(Rotation.from_quat(values[3:]).as_matrix(), values[:3])

    def refuse_metres(self, poses: Sequence[Floats]) -> None:
        """Refuses a table whose lengths are evidently metres."""
        furthest = max(float(np.linalg.norm(T[:3, 3])) for T in poses)
        if 0 < furthest < REACH_MM:
            raise Refusal(
                "poses-in-metres",
                f"{shown_path(self._path)}: "
                f"no flange is further than {furthest:.4g} mm from the arm's base",
                "these are metres where millimetres are expected",
                "Convert the columns x_mm, y_mm and z_mm to millimetres",
            )


def pose_cells(T_arm_flange: Floats) -> tuple[float, ...]:
    """The cells of ``COLUMNS``."""
    from scipy.spatial.transform import Rotation

    quaternion = Rotation.from_matrix(T_arm_flange[:3, :3]).as_quat()
    return (*T_arm_flange[:3, 3].tolist(), *quaternion.tolist())

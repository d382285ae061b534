"""``coordinates.csv``: what a laser tracker or a measuring machine measured of the arm.

``[frame,][marker,]x_mm,y_mm,z_mm,[qx,qy,qz,qw | rx_deg,ry_deg,rz_deg,]``
``[standard_uncertainty_mm,][rotation_standard_uncertainty_deg,]``
``[marker_x_mm,marker_y_mm,marker_z_mm,]q1_deg,…,qN_deg``

One row per posture and marker; columns in brackets may be missing.
"""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.csv_table import CsvTable, TableRow, parse_table
from crenel.formats.file_names import display_path
from crenel.formats.json_document import read_text
from crenel.formats.session.flange_columns import unit_quaternion
from crenel.formats.session.pose_columns import JointAngles
from crenel.messages.message import Text, message
from crenel.metrology.arm.identification.observations import TIP, Coordinates
from crenel.metrology.arm.kinematics import Arm
from crenel.metrology.arm.link_error import LinkError, error_transform
from crenel.metrology.transforms import Floats

COORDINATES = "coordinates.csv"
ONE_FRAME = "instrument"
"""The frame of a table without the column."""

POINT = ("x_mm", "y_mm", "z_mm")
QUATERNION = ("qx", "qy", "qz", "qw")
ANGLES = ("rx_deg", "ry_deg", "rz_deg")
OFFSET = ("marker_x_mm", "marker_y_mm", "marker_z_mm")
POINT_SD, ROTATION_SD = "standard_uncertainty_mm", "rotation_standard_uncertainty_deg"
LARGEST_SD_MM, LARGEST_SD_DEG = 10.0, 5.0


def read_coordinates(path: Path, arm: Arm) -> tuple[Coordinates, ...]:
    """Reads ``coordinates.csv``; raises ``OperationError`` as ``parse_coordinates``, or if the file
    is unreadable."""
    return parse_coordinates(read_text(path), path, arm)


def parse_coordinates(text: str, path: Path, arm: Arm) -> tuple[Coordinates, ...]:
    """Reads the text of a ``coordinates.csv``, with one element for each marker in each frame.

    Args:
        path: named in errors.

    Raises:
        OperationError: naming file, line, value and remedy.
    """
    table = parse_table(text, path, ())
    columns = _CoordinateColumns(table)
    angles = JointAngles(table, arm)
    by_label: dict[tuple[str, str], list[TableRow]] = {}
    for row in table.rows:
        by_label.setdefault(columns.label(row), []).append(row)
    if not by_label:
        raise OperationError(
            "no-points",
            message("file-has-no-points", path=display_path(path)),
            "",
            message("take-points-or-delete-file"),
        )
    found: list[Coordinates] = []
    for (frame, marker), rows in by_label.items():
        turned = columns.rotation is not None
        found.append(
            Coordinates(
                frame,
                marker,
                np.array([angles.read_row(row) for row in rows]),
                np.array([[row.number(name) for name in POINT] for row in rows]),
                np.array([columns.uncertainty(row, POINT_SD, LARGEST_SD_MM) for row in rows]),
                np.array([columns.read_rotation(row) for row in rows]) if turned else None,
                np.deg2rad([columns.uncertainty(row, ROTATION_SD, LARGEST_SD_DEG) for row in rows])
                if turned
                else None,
                columns.read_offset(rows, marker),
                tuple(row.line for row in rows),
            )
        )
    angles.refuse_radians([q for one in found for q in one.q_rad])
    columns.refuse_radians()
    return tuple(found)


class _CoordinateColumns:
    """The columns of one table."""

    def __init__(self, table: CsvTable) -> None:
        """Raises ``OperationError`` unless they are complete."""
        self._table = table
        self._names = set(table.columns)
        self._require(POINT)
        self.rotation = self._one_of(QUATERNION, ANGLES)
        self._has_offset = self._complete(OFFSET)

    def label(self, row: TableRow) -> tuple[str, str]:
        """Frame and marker of a row."""
        frame = row.text("frame") if "frame" in self._names else ONE_FRAME
        return frame, row.text("marker") if "marker" in self._names else TIP

    def uncertainty(self, row: TableRow, column: str, largest: float) -> float:
        """A standard uncertainty; 0 if the table states none."""
        if column not in self._names:
            return 0.0
        value = row.number(column)
        if not 0 <= value <= largest:
            raise OperationError(
                "uncertainty-senseless",
                message("column-cell-is", place=row.place, column=column, value=f"{value:g}"),
                message("value-expected-between", largest=f"{largest:g}"),
                message("give-standard-uncertainty-of-instrument"),
            )
        return value

    def read_rotation(self, row: TableRow) -> Floats:
        """(3, 3) of the marker in the frame of the instrument."""
        if self.rotation == QUATERNION:
            from scipy.spatial.transform import Rotation  # slow to import, and seldom needed

            return np.asarray(Rotation.from_quat(unit_quaternion(row)).as_matrix())
        rx, ry, rz = np.deg2rad([row.number(name) for name in ANGLES])
        turned = error_transform(LinkError(rx_rad=rx, ry_rad=ry, rz_rad=rz))
        return np.asarray(turned[:3, :3])

    def read_offset(self, rows: Sequence[TableRow], marker: str) -> Floats | None:
        """(3,) of the marker in the flange frame, if it is given: the same in all its rows."""
        if not self._has_offset:
            return None
        given = [tuple(row.number(name) for name in OFFSET) for row in rows]
        for row, offset in zip(rows, given, strict=True):
            if offset != given[0]:
                raise OperationError(
                    "marker-moved",
                    message("marker-place-differs", place=row.place, marker=marker),
                    message("line-gives-other-place", line=rows[0].line),
                    message("correct-place-or-name-marker-differently"),
                )
        return np.array(given[0])

    def refuse_radians(self) -> None:
        """Refuses rotations that are clearly in radians."""
        if self.rotation != ANGLES:
            return
        values = [abs(row.number(name)) for row in self._table.rows for name in ANGLES]
        if 0 < max(values) <= 2 * np.pi:
            raise OperationError(
                "rotations-in-radians",
                message(
                    "no-rotation-exceeds",
                    path=display_path(self._table.path),
                    largest=f"{max(values):.4g}",
                ),
                message("these-radians-where-degrees-expected"),
                message("convert-columns-degrees"),
            )

    def _one_of(self, *kinds: tuple[str, ...]) -> tuple[str, ...] | None:
        present = [names for names in kinds if self._complete(names)]
        if len(present) > 1:
            raise OperationError(
                "two-rotations",
                message(
                    "table-has-both",
                    path=display_path(self._table.path),
                    first=", ".join(present[0]),
                    second=", ".join(present[1]),
                ),
                message("one-rotation-expected"),
                message("delete-columns-of-one"),
            )
        return present[0] if present else None

    def _complete(self, names: tuple[str, ...]) -> bool:
        """Whether the table has these columns; all of them, or none."""
        if not self._names & set(names):
            return False
        self._require(names)
        return True

    def _require(self, names: tuple[str, ...]) -> None:
        missing = [name for name in names if name not in self._names]
        if not missing:
            return
        remedy: Text = message("must-name", names=", ".join(names))
        if names == POINT and self._names & {"x", "y", "z", "x_m", "y_m", "z_m"}:
            remedy = message("convert-lengths-mm-name-columns", names=", ".join(names))
        raise OperationError(
            "columns-missing",
            message("no-column", path=display_path(self._table.path), names=", ".join(missing)),
            message("first-line-names", names=", ".join(self._table.columns)),
            remedy,
        )

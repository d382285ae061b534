"""Columns of a robot's flange poses, in the words of its controller."""

import re
from collections.abc import Mapping, Sequence

import numpy as np

from crenel.errors import OperationError
from crenel.formats.csv_table import CsvTable, TableRow
from crenel.formats.file_names import display_path
from crenel.messages.message import Text, message, quantity, rounded
from crenel.metrology.arm.reported_poses import transforms_from_poses
from crenel.metrology.transforms import Floats
from crenel.rotations import CONVENTIONS, QUATERNION, quaternion_of
from crenel.units import MM_PER

COLUMNS = ("x_mm", "y_mm", "z_mm", "qx", "qy", "qz", "qw")
"""Those that the program writes."""
UNITS = {unit: MM_PER[unit] for unit in ("mm", "m")}
ANGLES = {"deg": np.pi / 180, "rad": 1.0}
UNIT_TOLERANCE = 1e-3
"""Deviation from unit length of quaternions written with four digits."""
FEW_DIGITS = 0.02
"""Deviation from unit length of those written with two or three."""
REACH_MM = 5.0
"""If the flange of a robot never gets further than this from its base, the unit is probably
metres."""
FARTHEST_MM = 50_000.0
"""No robot reaches so far, on whatever track."""
FULL_TURN = 2 * np.pi
"""In radians; angles in degrees of which none is larger, though one is larger than 1, are none."""


class FlangePoses:
    """The pose columns of a table, in the words of a controller; ``T_arm_flange`` of its rows."""

    def __init__(self, table: CsvTable, rotation: str = "") -> None:
        """Finds the columns of position and rotation.

        Args:
            rotation: a name of ``CONVENTIONS``; of a table with qx, qy, qz and qw it does not
                matter.

        Raises:
            OperationError: the table has no such columns, or does not say what they mean.
        """
        self._path = table.path
        position = _find_unit(table.columns, ("x", "y", "z"), UNITS)
        if position is None:
            _refuse_missing(table, COLUMNS[:3])
        self._position = position or "mm"
        self._convention, self._angle = QUATERNION, ""
        if all(name in table.columns for name in QUATERNION.columns):
            return
        if rotation not in CONVENTIONS:
            _refuse_unstated(table)
            _refuse_missing(table, COLUMNS[3:])
        else:
            self._convention = CONVENTIONS[rotation]
            units = {"": 1.0} if self._convention.is_quaternion else ANGLES
            unit = _find_unit(table.columns, self._convention.columns, units)
            if unit is None:
                wanted = _with_unit(self._convention.columns, next(iter(units)))
                _refuse_missing(table, wanted, message("arm-json-states-rotation", name=rotation))
            self._angle = unit or ""

    def read_row(self, row: TableRow) -> Floats:
        """``T_arm_flange`` (4, 4) of a row; ``OperationError`` if the quaternion is invalid."""
        axes = _with_unit(("x", "y", "z"), self._position)
        position = UNITS[self._position] * np.array([row.number(column) for column in axes])
        if self._convention.is_quaternion:
            values = unit_quaternion(row, self._convention.columns)
        else:
            values = ANGLES[self._angle] * np.array(self._numbers(row))
        pose = [*position, *quaternion_of(self._convention, values.tolist())]
        return np.asarray(transforms_from_poses(np.array([pose]))[0])

    def _numbers(self, row: TableRow) -> list[float]:
        return [row.number(name) for name in _with_unit(self._convention.columns, self._angle)]

    def refuse_other_units(self, rows: Sequence[TableRow], poses: Sequence[Floats]) -> None:
        """Refuses a table whose lengths are clearly in metres, whose angles in radians are called
        degrees, or whose angles in degrees radians."""
        self._refuse_metres(poses)
        if not self._angle:
            return
        largest = max(abs(value) for row in rows for value in self._numbers(row))
        in_radians = self._angle == "deg" and 1 < largest <= FULL_TURN
        if in_radians or (self._angle == "rad" and largest > 2 * FULL_TURN):
            raise OperationError(
                "angles-in-other-unit",
                message(
                    "largest-angle-of-poses",
                    path=display_path(self._path),
                    names=", ".join(_with_unit(self._convention.columns, self._angle)),
                    largest=f"{largest:.4g}",
                ),
                message("angles-are-in-other-unit", unit=self._angle),
                message("name-columns-by-unit", unit=self._angle),
            )

    def _refuse_metres(self, poses: Sequence[Floats]) -> None:
        furthest = max(float(np.linalg.norm(T[:3, 3])) for T in poses)
        if furthest > FARTHEST_MM:
            raise OperationError(
                "poses-in-other-unit",
                message(
                    "flange-lies-far",
                    path=display_path(self._path),
                    furthest=rounded(furthest / 1000, "m"),
                ),
                message("lengths-of-smaller-unit", unit=self._position),
                message("convert-columns-x-mm-y-mm"),
            )
        if self._position == "mm" and 0 < furthest < REACH_MM:
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


def _with_unit(names: Sequence[str], unit: str) -> tuple[str, ...]:
    return tuple(f"{name}_{unit}" if unit else name for name in names)


def _find_unit(
    columns: Sequence[str], names: Sequence[str], units: Mapping[str, float]
) -> str | None:
    """The unit with which a table has all of these columns; None if it has them with none."""
    found = (unit for unit in units if all(one in columns for one in _with_unit(names, unit)))
    return next(found, None)


def _refuse_unstated(table: CsvTable) -> None:
    """Refuses the columns of a controller where nothing says whose they are."""
    names = [
        name
        for name, one in CONVENTIONS.items()
        if all(
            {column, f"{column}_deg", f"{column}_rad"} & {*table.columns} for column in one.columns
        )
    ]
    if names:
        columns = ", ".join(CONVENTIONS[names[0]].columns)
        raise OperationError(
            "rotation-not-stated",
            message("rotation-not-stated", path=display_path(table.path), columns=columns),
            message("rotation-means-several", names=", ".join(names)),
            message("state-rotation-in-arm-json"),
        )


def _refuse_missing(table: CsvTable, wanted: Sequence[str], why: Text = "") -> None:
    missing = [name for name in wanted if name not in table.columns]
    if not missing:
        return
    have, needed = ", ".join(table.columns), ", ".join(COLUMNS)
    remedy = message("must-name", names=needed if not why else ", ".join(wanted))
    if any(re.fullmatch(r"q\d+_deg", name) for name in table.columns) and not why:
        why = message("these-joint-angles-but-arm-json")
        remedy = message("give-arms-own-model-columns", names=needed)
    elif {"x", "y", "z"} <= set(table.columns):
        remedy = message("convert-lengths-mm-name-columns", names=needed)
    raise OperationError(
        "columns-missing",
        message("no-column", path=display_path(table.path), names=", ".join(missing)),
        why or message("first-line-names", names=have),
        remedy,
    )


def unit_quaternion(row: TableRow, columns: Sequence[str] = COLUMNS[3:]) -> Floats:
    """(4,) numbers of a quaternion in a row; ``OperationError`` unless it has the length 1."""
    values = np.array([row.number(column) for column in columns])
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

"""A scan as a folder: pictures of the laser line, and where the arm was in each.

``arm.json``, ``sensor.json``   as in a calibration session
``images.csv``     file[,time_s][,lighting],q1_deg,… or x_mm,…   one row per picture
``readings.csv``   time_s,q1_deg,… or x_mm,…                     optional: the arm over time
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.csv_table import TableRow, read_table
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.datasheets.sensor import SensorDatasheet, read_sensor
from crenel.formats.file_names import display_path
from crenel.formats.session.calibration_session import ARM, IMAGES, SENSOR, check_folder
from crenel.formats.session.pose_columns import ArmReadings
from crenel.formats.session.pose_pictures import image_file, read_lighting
from crenel.messages.message import message, quantity
from crenel.metrology.arm.kinematics import AnyArm
from crenel.metrology.arm.reported_poses import pose_from_transform
from crenel.metrology.transforms import Floats

READINGS = "readings.csv"
TIME, LIGHTING = "time_s", "lighting"
UNTIMED_S = 1.0
"""Between pictures without times: so far apart that nothing is interpolated between them."""

LATEST_S = 4e9
"""Since 1970, or any other beginning; times in milliseconds are later."""


@dataclass(frozen=True)
class ScanPicture:
    """A picture with the laser on."""

    file: Path
    stamp_ns: int
    """The time stamp of its mid-exposure."""


@dataclass(frozen=True)
class ScanFolder:
    """The content of a folder; the pictures stay on disk."""

    arm: AnyArm
    sensor: SensorDatasheet
    pictures: tuple[ScanPicture, ...]
    """In the order of their times."""
    stamps_ns: NDArray[np.int64]
    """(J,) of the arm's readings, increasing."""
    readings: Floats
    """(J, k) as the arm reports them: encoder angles in rad, or poses (J, 7)."""
    tables: tuple[Path, ...]
    """The files that were read."""
    timed: bool
    """Whether the times of the pictures are known."""


def read_scan_folder(folder: Path) -> ScanFolder:
    """Reads and checks a scan's folder.

    A picture that is missing or damaged is noticed by who reads it. Rows of pictures with the
    laser off are left out, so that a calibration session is a scan's folder, too.

    Raises:
        OperationError: names file, line, value and remedy.
    """
    check_folder(folder)
    arm, sensor = read_any_arm(folder / ARM), read_sensor(folder / SENSOR)
    path, own = folder / IMAGES, folder / READINGS
    apart = own.exists()
    table = read_table(path, ("file", TIME) if apart else ("file",))
    if not apart:
        columns = ArmReadings(table, arm)
    lit = [row for row in table.rows if _is_lit(row)]
    if not lit:
        raise OperationError(
            "no-images",
            message("file-has-no-pictures-with-laser", path=display_path(path)),
            "",
            message("take-picture-object"),
        )
    timed = TIME in table.columns
    if timed:
        lit.sort(key=_read_time_s)
        _refuse_simultaneous(lit)
        stamps_ns = _stamps_ns(lit)
    else:
        stamps_ns = np.arange(len(lit), dtype=np.int64) * round(1e9 * UNTIMED_S)
    pictures = tuple(map(ScanPicture, map(image_file, lit), stamps_ns.tolist()))
    tables = (folder / ARM, folder / SENSOR, path)
    if not apart:
        readings = _arm_readings(columns, lit)
        return ScanFolder(arm, sensor, pictures, stamps_ns, readings, tables, timed)
    read_ns, readings = _read_readings(own, arm)
    _check_overlap(path, stamps_ns, own, read_ns)
    return ScanFolder(arm, sensor, pictures, read_ns, readings, (*tables, own), timed)


def _is_lit(row: TableRow) -> bool:
    return LIGHTING not in row.cells or read_lighting(row) != "ambient"


def _read_readings(path: Path, arm: AnyArm) -> tuple[NDArray[np.int64], Floats]:
    """Increasing times (J,) and readings (J, k) of the arm's own table; of rows with one time, the
    first counts."""
    table = read_table(path, (TIME,))
    if not table.rows:
        raise OperationError(
            "no-readings",
            message("file-has-no-readings", path=display_path(path)),
            "",
            message("write-readings-of-arm"),
        )
    readings = _arm_readings(ArmReadings(table, arm), table.rows)
    stamps_ns, first = np.unique(_stamps_ns(table.rows), return_index=True)
    return stamps_ns, readings[first]


def _arm_readings(columns: ArmReadings, rows: Sequence[TableRow]) -> Floats:
    """(J, k) as the arm reports them."""
    q_rad, T_arm_flange = columns.read_rows(rows)
    return q_rad if T_arm_flange is None else np.array([*map(pose_from_transform, T_arm_flange)])


def _stamps_ns(rows: Sequence[TableRow]) -> NDArray[np.int64]:
    return np.rint(1e9 * np.array([*map(_read_time_s, rows)])).astype(np.int64)


def _read_time_s(row: TableRow) -> float:
    """The time of a row; raises ``OperationError`` unless it can be one in seconds."""
    time_s = row.number(TIME)
    if 0 <= time_s <= LATEST_S:
        return time_s
    raise OperationError(
        "time-not-in-seconds",
        message("column-cell-is", place=row.place, column=TIME, value=row.text(TIME)),
        message("time-from-zero-to", latest=quantity(LATEST_S, "s")),
        message("give-times-in-seconds"),
    )


def _refuse_simultaneous(rows: Sequence[TableRow]) -> None:
    """Refuses two pictures of one time; the rows are in its order."""
    for one, other in pairwise(rows):
        if _read_time_s(one) == _read_time_s(other):
            raise OperationError(
                "pictures-simultaneous",
                message("picture-at-time-of-line", place=other.place, line=one.line),
                message("one-picture-at-a-time"),
                message("delete-one-rows"),
            )


def _check_overlap(
    path: Path, pictures_ns: NDArray[np.int64], own: Path, readings_ns: NDArray[np.int64]
) -> None:
    """Refuses pictures that were all taken before or after the arm's readings."""
    first, last = readings_ns[0], readings_ns[-1]
    if ((pictures_ns >= first) & (pictures_ns <= last)).any():
        return
    raise OperationError(
        "readings-at-other-times",
        message(
            "no-picture-within-readings",
            path=display_path(path),
            readings=display_path(own),
            begin=quantity(first / 1e9, "s", 3),
            end=quantity(last / 1e9, "s", 3),
        ),
        message("pictures-are-at", begin=quantity(pictures_ns[0] / 1e9, "s", 3)),
        message("give-times-of-one-clock"),
    )

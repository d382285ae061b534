"""A folder of measurements for the geometry of an arm: read and checked.

``arm.json``           the arm as its datasheet has it
``articulation.csv``   set,q1_deg,…,qN_deg                  the tip in one seat a set, the arm swung
``spheres.csv``        sphere,diameter_mm,q1_deg,…          touches of calibrated spheres
``ballbars.csv``       bar,position,length_mm,standard_uncertainty_mm,end,q1_deg,…
``coordinates.csv``    x_mm,y_mm,z_mm,q1_deg,…              markers that a tracker measured

One row per point. Some of the tables may be missing, but not all. ``sphere`` names a sphere at one
place, ``bar`` an artefact: its positions share the error of its calibrated length.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.atomic_write import write_atomically
from crenel.formats.csv_table import CsvTable, TableRow, read_table, table_text
from crenel.formats.datasheets.arm import read_arm
from crenel.formats.file_names import display_path
from crenel.formats.session.coordinates_table import COORDINATES, read_coordinates
from crenel.formats.session.pose_columns import JointAngles, joint_columns
from crenel.messages.message import Text, message
from crenel.metrology.arm.identification.observations import ArmObservations, Bar, Seat, Sphere
from crenel.metrology.arm.kinematics import Arm
from crenel.metrology.transforms import Floats

ARM = "arm.json"
IDENTIFIED = "identified.json"
"""The identified arm, if it is stored with the data of its identification."""
ARTICULATION, SPHERES, BALLBARS = "articulation.csv", "spheres.csv", "ballbars.csv"
TABLES = (ARTICULATION, SPHERES, BALLBARS, COORDINATES)

LARGEST_UNCERTAINTY_MM = 1.0


@dataclass(frozen=True)
class IdentificationSession:
    """The content of a folder, and the files from which it was read."""

    arm: Arm
    observations: ArmObservations
    files: tuple[Path, ...]


def read_identification_session(folder: Path) -> IdentificationSession:
    """Reads and checks a folder; raises ``OperationError`` naming file, line, value and remedy."""
    _check_folder(folder)
    arm = read_arm(folder / ARM)
    observations = read_observations(folder, arm)
    tables = tuple(folder / name for name in TABLES if (folder / name).exists())
    return IdentificationSession(arm, observations, (folder / ARM, *tables))


def read_observations(folder: Path, arm: Arm) -> ArmObservations:
    """The tables of a folder, for an arm; raises ``OperationError``."""
    _check_folder(folder)
    if not any((folder / name).exists() for name in TABLES):
        raise OperationError(
            "no-observations",
            display_path(folder),
            message("folder-has-none-of", names=", ".join(TABLES)),
            message("name-folder-of-seats-spheres-bars"),
        )
    seats = read_seats(folder / ARTICULATION, arm) if (folder / ARTICULATION).exists() else ()
    spheres = read_spheres(folder / SPHERES, arm) if (folder / SPHERES).exists() else ()
    bars = read_bars(folder / BALLBARS, arm) if (folder / BALLBARS).exists() else ()
    measured = folder / COORDINATES
    coordinates = read_coordinates(measured, arm) if measured.exists() else ()
    return ArmObservations(seats, spheres, bars, coordinates)


def read_seats(path: Path, arm: Arm) -> tuple[Seat, ...]:
    """Reads ``articulation.csv``, with one seat per set; raises ``OperationError``."""
    table = read_table(path, ("set",))
    rows = _rows_by_label(table, arm, "set")
    return tuple(Seat(name, q_rad) for name, (_, q_rad) in rows.items())


def write_observations(folder: Path, found: ArmObservations) -> None:
    """Updates the tables of touches, each atomically; a table without points is removed."""
    _write(folder / ARTICULATION, ("set",), [((s.name,), s.q_rad) for s in found.seats])
    _write(
        folder / SPHERES,
        ("sphere", "diameter_mm"),
        [((s.name, s.diameter_mm), s.q_rad) for s in found.spheres],
    )
    _write(
        folder / BALLBARS,
        ("bar", "position", "length_mm", "standard_uncertainty_mm", "end"),
        [
            ((bar.name, bar.position, bar.length_mm, bar.standard_uncertainty_mm, end), q_rad)
            for bar in found.bars
            for end, q_rad in zip(bar.ends, bar.q_rad, strict=True)
        ],
    )


def _write(
    path: Path, columns: Sequence[str], places: Sequence[tuple[Sequence[str | float], Floats]]
) -> None:
    if not places:
        path.unlink(missing_ok=True)
        return
    joints = joint_columns(places[0][1].shape[1])
    rows = [(*label, *np.rad2deg(one).tolist()) for label, q_rad in places for one in q_rad]
    write_atomically(path, table_text((*columns, *joints), rows).encode())


def read_spheres(path: Path, arm: Arm) -> tuple[Sphere, ...]:
    """Reads ``spheres.csv``; raises ``OperationError``."""
    table = read_table(path, ("sphere", "diameter_mm"))
    found: list[Sphere] = []
    for name, (rows, q_rad) in _rows_by_label(table, arm, "sphere").items():
        found.append(
            Sphere(
                name, _common_length(rows, "diameter_mm", message("sphere-named", name=name)), q_rad
            )
        )
    return tuple(found)


def read_bars(path: Path, arm: Arm) -> tuple[Bar, ...]:
    """Reads ``ballbars.csv``; raises ``OperationError``."""
    required = ("bar", "position", "length_mm", "standard_uncertainty_mm", "end")
    table = read_table(path, required)
    by_bar: dict[str, list[TableRow]] = {}
    for row in table.rows:
        by_bar.setdefault(row.text("bar"), []).append(row)
    lengths: dict[str, tuple[float, float]] = {}
    for name, rows in by_bar.items():
        label = message("bar-named", name=name)
        length = _common_length(rows, "length_mm", label)
        lengths[name] = length, _length_uncertainty(rows, label)
    ends: dict[tuple[str, str], dict[str, Floats]] = {}
    for (bar, position, end), (_, q_rad) in _rows_by_labels(
        table, arm, ("bar", "position", "end")
    ).items():
        ends.setdefault((bar, position), {})[end] = q_rad
    found: list[Bar] = []
    for (bar, position), both in ends.items():
        if len(both) != 2:
            raise OperationError(
                "bar-ends",
                message(
                    "bar-position-has-ends",
                    path=display_path(path),
                    bar=bar,
                    position=position,
                    ends=", ".join(both),
                ),
                message("bar-has-two-ends"),
                message("complete-or-delete-rows-of-position"),
            )
        (name_a, q_a), (name_b, q_b) = both.items()
        found.append(Bar(bar, position, *lengths[bar], (name_a, name_b), (q_a, q_b)))
    return tuple(found)


def _rows_by_label(
    table: CsvTable, arm: Arm, column: str
) -> dict[str, tuple[list[TableRow], Floats]]:
    """The rows of each label and their angles (m, n), in the order of the file."""
    return {label: found for (label,), found in _rows_by_labels(table, arm, (column,)).items()}


def _rows_by_labels(
    table: CsvTable, arm: Arm, columns: Sequence[str]
) -> dict[tuple[str, ...], tuple[list[TableRow], Floats]]:
    angles = JointAngles(table, arm)
    rows: dict[tuple[str, ...], list[TableRow]] = {}
    q_rad: dict[tuple[str, ...], list[Floats]] = {}
    for row in table.rows:
        label = tuple(row.text(column) for column in columns)
        rows.setdefault(label, []).append(row)
        q_rad.setdefault(label, []).append(angles.read_row(row))
    if not rows:
        raise OperationError(
            "no-points",
            message("file-has-no-points", path=display_path(table.path)),
            "",
            message("take-points-or-delete-file"),
        )
    angles.refuse_radians([q for own in q_rad.values() for q in own])
    return {label: (rows[label], np.array(q_rad[label])) for label in rows}


def _common_length(rows: Sequence[TableRow], column: str, label: Text) -> float:
    """A length that is the same in all rows of an artefact."""
    value = rows[0].number(column)
    if value <= 0:
        raise OperationError("length-not-positive", _column_is(rows[0], column, value))
    for row in rows[1:]:
        if row.number(column) != value:
            raise OperationError(
                "length-differs",
                _column_is(row, column, row.number(column)),
                message(
                    "line-gives-other-length", line=rows[0].line, length=f"{value:g}", label=label
                ),
                message("correct-value-or-name-artefact-differently"),
            )
    return value


def _length_uncertainty(rows: Sequence[TableRow], label: Text) -> float:
    value = rows[0].number("standard_uncertainty_mm")
    for row in rows:
        own = row.number("standard_uncertainty_mm")
        if own < 0 or own > LARGEST_UNCERTAINTY_MM or own != value:
            raise OperationError(
                "uncertainty-senseless",
                _column_is(row, "standard_uncertainty_mm", own),
                message(
                    "one-value-expected-for", largest=f"{LARGEST_UNCERTAINTY_MM:g}", label=label
                ),
                message("give-standard-uncertainty-of-certificate"),
            )
    return value


def _column_is(row: TableRow, column: str, value: float) -> Text:
    return message("column-cell-is", place=row.place, column=column, value=f"{value:g}")


def _check_folder(folder: Path) -> None:
    if not folder.is_dir():
        why = message("it-is-a-file") if folder.exists() else message("there-no-such-folder")
        raise OperationError("folder-missing", display_path(folder), why, message("name-a-folder"))

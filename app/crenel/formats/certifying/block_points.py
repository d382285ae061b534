"""``points.csv``: touches of a block's faces by a measuring machine or by an arm.

``face,x_mm,y_mm,z_mm,standard_uncertainty_mm`` with optional columns for the tip, for directions
and for postures; or ``face,q1_deg,…`` of an arm with joints, or the contact points of a session.
"""

from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.certifying.block_readings import (
    LARGEST_TIP_MM,
    face_name,
    read_face,
    read_uncertainty_mm,
)
from crenel.formats.csv_table import CsvTable, TableRow, parse_table
from crenel.formats.datasheets.arm import ArmFile, read_arm
from crenel.formats.file_names import display_path
from crenel.formats.json_document import read_text
from crenel.formats.session.calibration_session import ARM, PROBING
from crenel.formats.session.pose_columns import JointAngles
from crenel.messages.message import message, quantity
from crenel.metrology.adjustment.core.arm_errors import tip_errors_by_links
from crenel.metrology.arm.identification.volumetric_error import size_uncertainty_mm
from crenel.metrology.arm.kinematics import Arm, tip_centres, tip_covariances
from crenel.metrology.targets.block_readings import outward
from crenel.metrology.targets.block_touches import BlockTouches, TouchTip
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats

POSITION = ("x_mm", "y_mm", "z_mm")
DIRECTION = ("i", "j", "k")
UNCERTAINTY = "standard_uncertainty_mm"
DIAMETER, DIAMETER_SD = "tip_diameter_mm", "tip_uncertainty_mm"
POSTURE, POSTURE_SD = "posture", "posture_uncertainty_mm"
UNKNOWN_CELL = "unknown"
TABLE = "table"
"""What the block stands on, touched from above: the plane of its base."""
LEAST_ON_FACE, MOST = 3, 1000
TOUCH_SD_MM = 0.001
"""The least of a touch by hand, beside the encoders' noise, where none is stated."""


@dataclass(frozen=True)
class TouchingArm:
    """An arm with joints, and how well it and its tip are known.

    ``error_mm`` is the rms error of the tip over the reach by the arm's model, k = 1;
    ``tip_sd_mm`` that of the diameter in its file, infinite where nobody certified it.
    """

    arm: Arm
    error_mm: float
    tip_sd_mm: float = np.inf


def read_touching_arm(
    path: Path, error_um: float | None = None, tip_sd_um: float | None = None
) -> TouchingArm:
    """An arm by its ``arm.json``.

    Args:
        error_um: rms error of its tip over the reach; by default, what its identification states.
        tip_sd_um: standard uncertainty of the tip's diameter; None if it is unknown.

    Raises:
        OperationError: as ``read_arm``; ``arm-error-unknown``.
    """
    arm = read_arm(path)
    found = ArmFile.parse_text(read_text(path), path).identification
    if error_um is not None:
        error_mm = error_um / 1e3
    elif found is not None:
        size_mm = 0.0 if found.size_known else size_uncertainty_mm(arm)
        error_mm = float(np.hypot(found.volume_after_um / 1e3, size_mm))
    else:
        raise OperationError(
            "arm-error-unknown",
            message("error-of-arm-over-reach-unknown", path=display_path(path)),
            message("links-errors-do-not-average-out"),
            message("identify-arm-or-state-arm-um"),
        )
    return TouchingArm(arm, error_mm, np.inf if tip_sd_um is None else tip_sd_um / 1e3)


@dataclass(frozen=True, eq=False)
class TouchTable:
    """Touches with the rows that they stand in."""

    rows: tuple[TableRow, ...]
    touches: BlockTouches
    arm_error_mm: float | None = None
    """That of the arm whose errors the touches share; None of touches by their positions."""


def session_files(folder: Path) -> tuple[Path, Path]:
    """The arm's file and the contact points of a session's folder."""
    return folder / ARM, folder / PROBING


def read_touches(path: Path, drawing: Crenellated, by: TouchingArm | None = None) -> TouchTable:
    """The touches of a block.

    Args:
        path: the table.
        drawing: the block as drawn, whose faces it names.
        by: the arm, whose joint angles the table has.

    Raises:
        OperationError: as ``read_table``; a face that the block does not have, or that fewer than
            ``LEAST_ON_FACE`` touches reach; more touches than ``MOST``; a cell that cannot be.
    """
    return parse_touches(read_text(path), path, drawing, by)


def parse_touches(
    text: str, path: Path, drawing: Crenellated, by: TouchingArm | None = None
) -> TouchTable:
    """The same of the text of a file of this name."""
    header = parse_table(text, path, ())
    column = "feature" if "feature" in header.columns and "face" not in header.columns else "face"
    in_joints = not set(POSITION) & set(header.columns)
    if in_joints and by is None and any(name.startswith("q1") for name in header.columns):
        raise OperationError(
            "joint-angles-without-arm",
            message("touches-are-joint-angles", path=display_path(path)),
            "",
            message("give-arm-of-touches"),
        )
    angles = in_joints and by is not None
    table = parse_table(text, path, (column,) if angles else (column, *POSITION, UNCERTAINTY))
    edges = len(drawing.edges_x_mm)
    named = [_face(row, column, edges) for row in table.rows]
    _refuse_counts(path, named, edges)
    faces, away = (np.array(one) for one in zip(*named, strict=True))
    sds = np.array([_sd_mm(row, table) for row in table.rows])
    tips, tip = _tips(table, by if angles else None)
    covariances = (sds**2)[:, None, None] * np.eye(3)
    shared = _by_postures(table)
    if angles and by is not None:
        columns = JointAngles(table, by.arm)
        q_rad = np.array([columns.read_row(row) for row in table.rows])
        columns.refuse_radians(list(q_rad))
        points = tip_centres(by.arm, q_rad)
        covariances = covariances + tip_covariances(by.arm, q_rad)
        shared = np.concatenate([shared, tip_errors_by_links(by.arm, q_rad, by.error_mm)], axis=2)
    else:
        points = _numbers(table, POSITION)
    directions = np.full((len(table.rows), 3), np.nan)
    if set(DIRECTION) <= set(table.columns):
        directions = _numbers(table, DIRECTION)
    touches = BlockTouches(
        faces, away.astype(np.float64), points, covariances, tips, tip, shared, directions
    )
    return TouchTable(table.rows, touches, by.error_mm if angles and by is not None else None)


def name_of_touched(touches: BlockTouches, index: int, edge_count: int) -> str:
    """The name of the face of one touch, as in the table."""
    return face_label(int(touches.faces[index]), int(touches.away[index]), edge_count)


def face_label(face: int, away: int, edge_count: int) -> str:
    """The name of a face that was touched from one side."""
    return face_name(face, edge_count) if away == outward(face, edge_count) else TABLE


def _face(row: TableRow, column: str, edge_count: int) -> tuple[int, int]:
    """The number of a face, and to which side of it the tip lies."""
    name = row.text(column)
    if name == TABLE:
        base = edge_count + 4
        return base, -outward(base, edge_count)
    ends = {"left": 0, "right": edge_count - 1}
    face = ends[name] if name in ends else read_face(row, column, edge_count)
    return face, outward(face, edge_count)


def _refuse_counts(path: Path, named: list[tuple[int, int]], edges: int) -> None:
    if len(named) > MOST:
        raise OperationError(
            "too-many-touches",
            message("file-has-touches", path=display_path(path), count=len(named)),
            message("most-touches-are", most=MOST),
            message("leave-out-touches-evenly"),
        )
    for (face, away), count in Counter(named).items():
        if count < LEAST_ON_FACE:
            raise OperationError(
                "face-touched-too-seldom",
                message("face-has-touches", face=face_label(face, away, edges), count=count),
                message("least-needed", least=LEAST_ON_FACE),
                message("touch-more-places"),
            )
    if not named:
        raise OperationError(
            "no-contacts",
            message("file-has-no-contact-points", path=display_path(path)),
            "",
            message("probe-object"),
        )


def _sd_mm(row: TableRow, table: CsvTable) -> float:
    if UNCERTAINTY not in table.columns:
        return TOUCH_SD_MM
    return read_uncertainty_mm(row, UNCERTAINTY, 1e-6)


def _numbers(table: CsvTable, columns: tuple[str, ...]) -> Floats:
    return np.array([[row.number(column) for column in columns] for row in table.rows])


def _tips(
    table: CsvTable, by: TouchingArm | None
) -> tuple[tuple[TouchTip, ...], NDArray[np.int64]]:
    """The tips of a table, and which of them each row has."""
    if DIAMETER not in table.columns:
        tip = TouchTip() if by is None else TouchTip(by.arm.tip.diameter_mm, by.tip_sd_mm)
        return (tip,), np.zeros(len(table.rows), dtype=np.int64)
    each = [_tip(row, DIAMETER_SD in table.columns) for row in table.rows]
    tips = tuple(dict.fromkeys(each))
    return tips, np.array([tips.index(one) for one in each], dtype=np.int64)


def _tip(row: TableRow, has_sd: bool) -> TouchTip:
    if row.text(DIAMETER) == UNKNOWN_CELL:
        return TouchTip(0.0, np.inf)
    diameter_mm = row.number(DIAMETER)
    if not 0 <= diameter_mm <= LARGEST_TIP_MM:
        raise OperationError(
            "tip-diameter",
            message("column-cell-is", place=row.place, column=DIAMETER, value=f"{diameter_mm:g}"),
            message("diameter-up-to-or-unknown", most=quantity(LARGEST_TIP_MM, "mm", 0)),
            message("correct-cell-delete-row"),
        )
    if not has_sd and diameter_mm:
        raise OperationError(
            "tip-uncertainty-missing",
            message("tips-diameter-has-no-uncertainty", place=row.place),
            message("tip-error-is-in-every-width"),
            message("state-tip-uncertainty-or-unknown"),
        )
    return TouchTip(diameter_mm, read_uncertainty_mm(row, DIAMETER_SD) if has_sd else 0.0)


def _by_postures(table: CsvTable) -> Floats:
    """(N, 3, 3P) what an error that all touches of a posture share moves each by."""
    given = {POSTURE, POSTURE_SD} & set(table.columns)
    if not given:
        return np.zeros((len(table.rows), 3, 0))
    for column in (POSTURE, POSTURE_SD):
        if column not in table.columns:
            raise OperationError(
                "columns-missing",
                message("no-column", path=display_path(table.path), names=column),
                message("posture-and-its-uncertainty"),
                message("add-column-or-leave-both"),
            )
    names = [row.text(POSTURE) for row in table.rows]
    postures = list(dict.fromkeys(names))
    shared = np.zeros((len(names), 3, 3 * len(postures)))
    for i, (name, row) in enumerate(zip(names, table.rows, strict=True)):
        own = 3 * postures.index(name)
        shared[i, :, own : own + 3] = read_uncertainty_mm(row, POSTURE_SD) * np.eye(3)
    return shared

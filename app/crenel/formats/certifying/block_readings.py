"""``readings.csv``: distances of a block's faces by calliper, micrometer or the arm's own tip.

``from,to,distance_mm,standard_uncertainty_mm[,tool][,tool_uncertainty_mm]``: one row for each
reading, from the face that lies lower along its axis to the other one.
"""

import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.csv_table import TableRow, parse_table
from crenel.formats.datasheets.target import COARSEST_MM, WIDEST_MM
from crenel.formats.json_document import read_text
from crenel.messages.message import Text, message, quantity
from crenel.metrology.calibration.observation_model import coordinates
from crenel.metrology.targets.block_readings import (
    FACE_NAMES,
    TIP,
    BlockReading,
    face_axis,
    tool_sense,
)
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.units import MM_PER

REQUIRED = ("from", "to", "distance_mm", "standard_uncertainty_mm")
EDGE = re.compile(r"edge_(\d+)")
FURTHEST_MM = 2.0
"""A reading that is further than this beside the drawing is another one's, or in another unit."""
NOISE_SDS = 3.0
LARGEST_TIP_MM = 20.0
INCHES_AGREE = 0.9
"""Readings are in inches where this share of them agrees with the drawing if they were."""


def read_readings(path: Path, drawing: Crenellated) -> tuple[BlockReading, ...]:
    """The readings of a block.

    Args:
        path: the table.
        drawing: the block as drawn; a reading that does not lie near it is refused.

    Raises:
        OperationError: as ``read_table``; a face that the block does not have, a reading between
            faces that are not parallel, in inches, or far beside the drawing.
    """
    return parse_readings(read_text(path), path, drawing)


def parse_readings(text: str, path: Path, drawing: Crenellated) -> tuple[BlockReading, ...]:
    """The same of the text of a file of this name."""
    table = parse_table(text, path, REQUIRED)
    readings = tuple(_reading(row, drawing, table.columns) for row in table.rows)
    _refuse_unlike(readings, drawing)
    return readings


def face_name(face: int, edge_count: int) -> str:
    """The name of a face in a table."""
    return f"edge_{face + 1}" if face < edge_count else FACE_NAMES[face - edge_count]


def name_of_reading(index: int, readings: Sequence[BlockReading], edge_count: int) -> Text:
    """A reading by its number and its faces."""
    one = readings[index]
    return message(
        "reading-in-row",
        number=index + 1,
        first=face_name(one.first, edge_count),
        second=face_name(one.second, edge_count),
    )


def _reading(row: TableRow, drawing: Crenellated, columns: tuple[str, ...]) -> BlockReading:
    edges = len(drawing.edges_x_mm)
    first, second = (read_face(row, column, edges) for column in ("from", "to"))
    values = coordinates(drawing)
    if face_axis(first, edges) != face_axis(second, edges) or first == second:
        names = {"first": row.text("from"), "second": row.text("to")}
        raise OperationError(
            "reading-not-parallel",
            message("reading-between-faces", place=row.place, **names),
            message("faces-are-not-parallel"),
            message("correct-cell-delete-row"),
        )
    if values[first] > values[second]:
        first, second = second, first
    sd_mm = read_uncertainty_mm(row, "standard_uncertainty_mm", 1e-6)
    common_mm = 0.0
    if "tool_uncertainty_mm" in columns:
        common_mm = read_uncertainty_mm(row, "tool_uncertainty_mm")
    tool = row.cells["tool"].strip() if "tool" in columns else ""
    return BlockReading(first, second, row.number("distance_mm"), sd_mm, tool, common_mm)


def read_uncertainty_mm(row: TableRow, column: str, least_mm: float = 0.0) -> float:
    """A standard uncertainty; ``reading-uncertainty`` refuses one that no tool has."""
    value = row.number(column)
    if not least_mm <= value <= COARSEST_MM:
        raise OperationError(
            "reading-uncertainty",
            message("column-cell-is", place=row.place, column=column, value=f"{value:g}"),
            message("uncertainty-above-zero-up-to", most=quantity(COARSEST_MM, "mm", 1)),
            message("correct-cell-delete-row"),
        )
    return value


def read_face(row: TableRow, column: str, edge_count: int) -> int:
    """The number of the face that a cell names; ``reading-of-unknown-face`` refuses others."""
    name = row.text(column)
    found = EDGE.fullmatch(name)
    if found and 1 <= int(found[1]) <= edge_count:
        return int(found[1]) - 1
    if name in FACE_NAMES:
        return edge_count + FACE_NAMES.index(name)
    raise OperationError(
        "reading-of-unknown-face",
        message("column-cell-is", place=row.place, column=column, value=repr(name)),
        message("faces-of-readings-are", edges=edge_count, names=", ".join(FACE_NAMES)),
        message("correct-cell-delete-row"),
    )


def _refuse_unlike(readings: tuple[BlockReading, ...], drawing: Crenellated) -> None:
    """Refuses readings that are not of this block, by the first of them."""

    def name(index: int) -> Text:
        return name_of_reading(index, readings, len(drawing.edges_x_mm))

    inches = [_fits(one, drawing, MM_PER["inch"]) and not _fits(one, drawing) for one in readings]
    if sum(inches) > INCHES_AGREE * len(inches):
        raise OperationError(
            "readings-in-inches",
            message("readings-are-inches", place=name(inches.index(True)), count=sum(inches)),
            message("readings-expected-in-mm"),
            message("multiply-readings-by-inch"),
        )
    exchanged = _find_exchange(readings, drawing)
    if exchanged is not None:
        one, other = map(name, exchanged)
        raise OperationError(
            "readings-exchanged",
            message("readings-agree-if-exchanged", one=one, other=other),
            "",
            message("exchange-readings-or-read-again"),
        )
    unlike = [i for i, one in enumerate(readings) if not _fits(one, drawing)]
    values = coordinates(drawing)
    for i in unlike[:1]:
        drawn_mm = float(values[readings[i].second] - values[readings[i].first])
        raise OperationError(
            "reading-beside-drawing",
            message(
                "reading-far-beside-drawing",
                place=name(i),
                reading=quantity(readings[i].distance_mm, "mm", 3),
                drawn=quantity(drawn_mm, "mm", 3),
            ),
            message("reading-of-other-faces"),
            message("correct-reading-or-leave-out"),
        )


def _find_exchange(
    readings: tuple[BlockReading, ...], drawing: Crenellated
) -> tuple[int, int] | None:
    """The only two readings that lie beside the drawing, if they lie on it once exchanged.

    Readings that no other one checks contradict nothing: the drawing alone tells.
    """
    made_mm = drawing.made_within_mm if drawing.is_nominal else WIDEST_MM
    for furthest_mm in (2 * made_mm, FURTHEST_MM):

        def fits(one: BlockReading, most_mm: float = furthest_mm) -> bool:
            return _fits(one, drawing, 1.0, most_mm + NOISE_SDS * (one.sd_mm + one.common_sd_mm))

        unlike = [i for i, one in enumerate(readings) if not fits(one)]
        if len(unlike) != 2:
            continue
        i, j = unlike
        swapped = (
            replace(readings[i], distance_mm=readings[j].distance_mm),
            replace(readings[j], distance_mm=readings[i].distance_mm),
        )
        if all(map(fits, swapped)):
            return i, j
    return None


def _fits(
    one: BlockReading, drawing: Crenellated, times: float = 1.0, furthest_mm: float = FURTHEST_MM
) -> bool:
    values = coordinates(drawing)
    sense = tool_sense(one.first, one.second, len(drawing.edges_x_mm)) if one.tool == TIP else 0
    beside_mm = times * one.distance_mm - float(values[one.second] - values[one.first])
    low, high = sorted((0.0, sense * LARGEST_TIP_MM))
    return low - furthest_mm <= beside_mm <= high + furthest_mm

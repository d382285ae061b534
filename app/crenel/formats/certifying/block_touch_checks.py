"""Touches that cannot be of a block as drawn: refused by their rows."""

from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.formats.certifying.block_points import TouchTable, name_of_touched
from crenel.formats.certifying.block_readings import face_name
from crenel.messages.message import Text, message, quantity
from crenel.metrology.targets.block_placement import (
    BlockPlacement,
    find_mislabelled,
    fixes_block,
    place_touches,
)
from crenel.metrology.transforms import Floats
from crenel.units import MM_PER

SCALE_SLACK = 0.05


@dataclass(frozen=True, eq=False)
class PlacedTable:
    """Where a touched block stands, and a touch that lies elsewhere: ``touch-on-other-face``, where
    the fit does not show that it was exchanged with one that nearly lies on both faces."""

    block: BlockPlacement
    refusal: OperationError | None


def place_table(table: TouchTable, drawn_mm: Floats) -> PlacedTable:
    """Where the touched block stands.

    Args:
        drawn_mm: (B,) coordinates of the drawing.

    Raises:
        OperationError: ``touches-fix-no-place``; ``touches-in-other-unit``; ``touches-exchanged``
            with both rows or both faces; ``touches-mirrored``; ``direction-into-block``.
    """
    touches, edges = table.touches, len(drawn_mm) - 5
    if not fixes_block(touches, edges):
        raise OperationError(
            "touches-fix-no-place",
            message("touches-do-not-show-place"),
            message("touch-two-faces-of-two-axes"),
            message("touch-more-places"),
        )
    placed = place_touches(touches, drawn_mm)
    for unit in ("inch", "cm", "m", "µm"):
        size_mm = MM_PER[unit]
        if abs(placed.scale / size_mm - 1) < SCALE_SLACK:
            raise OperationError(
                "touches-in-other-unit",
                message("touches-agree-in-unit", place=table.rows[0].place, unit=unit),
                message("readings-expected-in-mm"),
                message("multiply-coordinates-by", factor=f"{size_mm:g}"),
            )
    found = _judge_labels(table, placed, drawn_mm)
    if found is None:
        _refuse_directions(table, placed, edges)
    return PlacedTable(placed, found)


def _judge_labels(
    table: TouchTable, placed: BlockPlacement, drawn_mm: Floats
) -> OperationError | None:
    touches, edges = table.touches, len(drawn_mm) - 5
    found = find_mislabelled(placed, touches, drawn_mm)
    if found is None:
        return None
    if found.faces is not None:
        one, other = (face_name(face, edges) for face in found.faces)
        raise _exchange_error(one, other)
    if placed.mirrored and not found.exchanged:
        raise OperationError(
            "touches-mirrored",
            message("touches-are-mirror-image"),
            message("opposite-faces-exchanged-or-left-handed"),
            message("check-names-of-faces-and-axes"),
        )
    places = [touch_in_row(table, index, edges) for index in found.touches]
    if found.exchanged:
        raise _exchange_error(*places)
    (index,) = found.touches
    return OperationError(
        "touch-on-other-face",
        message(
            "touch-lies-beside-face",
            place=table.rows[index].place,
            off=quantity(abs(float(placed.beside_mm[index])), "mm", 2),
            face=name_of_touched(touches, index, edges),
        ),
        message("touch-lies-on-no-face")
        if found.face is None
        else message("touch-lies-on-face", face=face_name(found.face, edges)),
        message("correct-cell-delete-row"),
    )


def exchange_refusal(table: TouchTable, pair: tuple[int, int], edges: int) -> OperationError:
    """The refusal of two touches that agree with the others if their faces are exchanged."""
    return _exchange_error(*(touch_in_row(table, index, edges) for index in pair))


def touch_in_row(table: TouchTable, index: int, edges: int) -> Text:
    """A touch by its line and its face."""
    face = name_of_touched(table.touches, index, edges)
    return message("touch-in-row", line=table.rows[index].line, face=face)


def _exchange_error(one: Text, other: Text) -> OperationError:
    return OperationError(
        "touches-exchanged",
        message("touches-agree-if-exchanged", one=one, other=other),
        "",
        message("exchange-faces-or-touch-again"),
    )


def _refuse_directions(table: TouchTable, placed: BlockPlacement, edges: int) -> None:
    touches = table.touches
    axes = touches.axes(edges)
    out = placed.T_obj_machine[:3, :3][axes] * touches.away[:, None]
    along = np.einsum("ni,ni->n", out, touches.outward)
    for index in np.flatnonzero(along < 0)[:1]:
        raise OperationError(
            "direction-into-block",
            message(
                "direction-points-into-block",
                place=table.rows[index].place,
                face=name_of_touched(touches, int(index), edges),
            ),
            message("directions-point-out-of-surface"),
            message("correct-cell-delete-row"),
        )

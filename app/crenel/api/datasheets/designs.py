"""Objects that are designed before they are made: a block for a sensor, a board to print.

They are those of ``crenel design``; nothing of them is stored.
"""

import asyncio
import tempfile
from dataclasses import dataclass
from pathlib import Path as Folder
from typing import Annotated, Literal

from fastapi import Depends, Path, Query
from pydantic import Field
from starlette.responses import Response

from crenel.api.access.authorization import StationRouter
from crenel.formats.datasheets.target import WIDEST_MM
from crenel.formats.drawings.dxf import dxf_obstacle
from crenel.formats.open_file import read_bounded
from crenel.messages.message import Text
from crenel.operations.context import TheContext
from crenel.operations.datasheets.block_designs import DesignProgress, order_id
from crenel.report.printed.board_pdf import PageName, board_page, board_pdf
from crenel.report.printed.drawing_pdf import drawing_pdf
from crenel.wire.schema import RequestBody
from crenel.workflows.design.block_drawing import draw_block
from crenel.workflows.design.board_files import (
    PrintedBoard,
    board_file,
    both_lengths,
    plan_board,
    scale_print,
)
from crenel.workflows.design.design_files import (
    design_figures,
    object_file,
    tolerance_rows,
    write_dxf_of,
    write_solid,
)
from crenel.workflows.design.ordered_block import BlockOrder, OrderedBlock

router = StationRouter(prefix="/api/designs")

BlockFileName = Literal["block.pdf", "block.dxf", "block.stl", "block.step"]
MEDIA: dict[BlockFileName, str] = {
    "block.pdf": "application/pdf",
    "block.dxf": "application/dxf",
    "block.stl": "model/stl",
    "block.step": "model/step",
}
Language = Annotated[str, Query(pattern="^[a-z]{2}$")]
Name = Annotated[str, Query(min_length=1, max_length=120)]
DesignId = Annotated[str, Path(max_length=64, pattern=r"^[0-9a-f]+$")]
Finite = Field(allow_inf_nan=False, le=1e6)


class BlockRequest(RequestBody):
    """The numbers of a sensor, and the datasheet of an arm or none."""

    page: Annotated[str, Field(min_length=1, max_length=64)]
    """Tells this page from others: what it asks for next takes the place of this."""
    field_of_view_mm: Annotated[float, Finite, Field(ge=1)]
    depth_of_field_mm: Annotated[float, Finite, Field(ge=0.5)]
    standoff_mm: Annotated[float, Finite, Field(ge=1)]
    angle_deg: Annotated[float, Field(ge=5, le=70)]
    width_px: Annotated[int, Field(ge=1, le=65536)]
    height_px: Annotated[int, Field(ge=1, le=65536)]
    stripe_axis: Literal["u", "v"]
    arm: Annotated[str, Field(max_length=255)] = ""
    arm_version: Annotated[str, Field(max_length=64)] = ""
    width_mm: Annotated[float | None, Finite, Field(ge=1)] = None
    merlons: Annotated[int | None, Field(ge=2, le=9)] = None
    groove_mm: Annotated[float | None, Finite, Field(ge=0.1)] = None
    tolerance_mm: Annotated[float | None, Field(ge=0.001, le=WIDEST_MM)] = None
    """Sizes of the block that are kept; None: proposed."""


@dataclass(frozen=True)
class DesignFigure:
    """One number of a designed block."""

    name: Text
    value: Text


@dataclass(frozen=True)
class BlockAccuracy:
    """Standard uncertainty of a scanned point, k = 1, with a block that is made in some way."""

    made: Text
    one_pose: Text
    eight_poses: Text


@dataclass(frozen=True)
class BlockDesignView:
    """A designed block."""

    id: str
    document: str
    """``object.json`` with nominal sizes and the tolerance, without a name."""
    standoff_mm: float
    """From which the laser shines."""
    figures: tuple[DesignFigure, ...]
    accuracies: tuple[BlockAccuracy, ...]
    dxf_why_not: Text
    """What to install before the drawing can be had as DXF; empty if nothing is missing."""


@dataclass(frozen=True)
class BlockDesignState:
    """A designed block, or how far it is."""

    share: float
    step: Text
    design: BlockDesignView | None


@dataclass(frozen=True)
class BoardDesignView:
    """A board to print."""

    document: str
    """``object.json``."""
    width_mm: float
    height_mm: float
    """The height of the pattern, as it is to be printed."""
    page: str
    """That is asked for, or the smallest of A4 to A0 that has room."""


@router.post("/block")
def design_block(asked: BlockRequest, context: TheContext) -> BlockDesignState:
    """Designs a block for a sensor, or says how far that is: ask again until it is there."""
    arm = None
    if asked.arm:
        arm = context.datasheets.path("arm", asked.arm, False, asked.arm_version)
    order = BlockOrder(
        field_of_view_mm=asked.field_of_view_mm,
        depth_of_field_mm=asked.depth_of_field_mm,
        angle_deg=asked.angle_deg,
        standoff_mm=asked.standoff_mm,
        size_px=(asked.width_px, asked.height_px),
        stripe_axis=asked.stripe_axis,
        arm=arm,
        arm_version=asked.arm_version,
        width_mm=asked.width_mm,
        merlons=asked.merlons,
        groove_mm=asked.groove_mm,
        tolerance_mm=asked.tolerance_mm,
    )
    found = context.block_designs.ask(asked.page, order)
    if isinstance(found, DesignProgress):
        return BlockDesignState(found.share, found.step, None)
    return BlockDesignState(1.0, "", _view_block(order, found))


def _view_block(order: BlockOrder, found: OrderedBlock) -> BlockDesignView:
    design = found.design
    return BlockDesignView(
        id=order_id(order),
        document=object_file(design).text(),
        standoff_mm=design.sensor.standoff_mm,
        figures=tuple(DesignFigure(name, value) for name, value in design_figures(design)),
        accuracies=tuple(BlockAccuracy(*row) for row in tolerance_rows(design)),
        dxf_why_not=dxf_obstacle(),
    )


@router.get("/block/{design_id}/{file}")
async def block_file(
    design_id: DesignId, file: BlockFileName, context: TheContext, name: Name, lang: Language = "en"
) -> Response:
    """The drawing or the solid of a block that was designed."""
    found = context.block_designs.find(design_id).with_name(name)
    async with context.printer:
        content = await asyncio.to_thread(_block_bytes, found, file, lang)
    return attachment(content, MEDIA[file], file)


def _block_bytes(found: OrderedBlock, file: BlockFileName, language: str) -> bytes:
    """The file; raises ``OperationError`` where the extra for DXF is missing."""
    if file == "block.pdf":
        return drawing_pdf(draw_block(found.design), language)
    with tempfile.TemporaryDirectory() as place:
        folder = Folder(place)
        if file == "block.dxf":
            write_dxf_of(found.design, folder, language)
        else:
            write_solid(found.design, folder)
        return read_bounded(folder / file)


def _board(
    kind: Literal["charuco", "chessboard"],
    columns: Annotated[int, Query(ge=1, le=1000)],
    rows: Annotated[int, Query(ge=1, le=1000)],
    square_mm: Annotated[float, Query(ge=0.2, le=1e6)],
    name: Name,
    first_id: Annotated[int, Query(ge=0, le=1000)] = 0,
    measured_x_mm: Annotated[float | None, Query(ge=1, le=1e6)] = None,
    measured_y_mm: Annotated[float | None, Query(ge=1, le=1e6)] = None,
    measured_sd_mm: Annotated[float, Query(ge=0, le=1e3)] = 0.1,
) -> PrintedBoard:
    """The board; scaled, where width and height of its print were measured."""
    planned = plan_board(name, (columns, rows), square_mm, kind == "charuco", first_id)
    return scale_print(planned, both_lengths(measured_x_mm, measured_y_mm), measured_sd_mm)


TheBoard = Annotated[PrintedBoard, Depends(_board)]
Page = Annotated[PageName | None, Query()]


@router.get("/board")
def design_board(board: TheBoard, page: Page = None) -> BoardDesignView:
    """A board to print; or of a printed one, its file by two measured lengths."""
    width_mm, height_mm = board.size_mm
    return BoardDesignView(
        document=board_file(board.printed).text(),
        width_mm=width_mm,
        height_mm=height_mm,
        page=board_page(board.planned, page),
    )


@router.get("/board/board.pdf")
async def board_page_file(
    board: TheBoard, context: TheContext, page: Page = None, lang: Language = "en"
) -> Response:
    """The page to print, to scale."""
    async with context.printer:
        content = await asyncio.to_thread(board_pdf, board.planned, lang, page)
    return attachment(content, "application/pdf", "board.pdf")


def attachment(content: bytes, media_type: str, name: str) -> Response:
    named = {"Content-Disposition": f'attachment; filename="{name}"'}
    return Response(content, media_type=media_type, headers=named)

"""Parts that are kept, and the comparison of finished scans with them."""

import asyncio
from typing import Annotated

from fastapi import Path, Query, Request
from starlette.responses import Response
from starlette.status import HTTP_202_ACCEPTED, HTTP_204_NO_CONTENT

from crenel.api.access.authorization import StationRouter
from crenel.api.answers.lookups import check_not_recorded, find_scan
from crenel.api.answers.problems import NotFoundError
from crenel.messages.message import message
from crenel.operations.context import Context, TheContext
from crenel.parts.compare.document_comparison import (
    COMPARISON,
    JSON,
    ComparisonFile,
    read_member,
)
from crenel.parts.compare.guide_comparison import ComparisonWish, read_result
from crenel.parts.compare.guide_view import CompareState, PlaceOnMap
from crenel.parts.deviation.document_map import MAP
from crenel.wire.parts import (
    ArrivedBytes,
    MapWish,
    NewComparison,
    NewPartFile,
    PictureSpot,
    ScanSize,
)

router = StationRouter(prefix="/api")
ScanId = Annotated[str, Path(max_length=128)]
PartId = Annotated[str, Path(max_length=32)]
BINARY, TEXT = "application/octet-stream", "application/json"


@router.get("/cad")
def parts(context: TheContext) -> CompareState:
    """The parts that are kept, what is read or computed, and the map in the view."""
    return context.comparisons.state()


@router.post("/cad")
def begin_part(asked: NewPartFile, context: TheContext) -> ArrivedBytes:
    """Begins to take the file of a part, STL or STEP, whose pieces follow."""
    file = context.comparisons.parts.begin(asked.name, asked.size)
    return ArrivedBytes(file.id, 0)


@router.put("/cad/{part_id}/file")
async def take_piece(
    part_id: PartId, request: Request, context: TheContext, at: Annotated[int, Query(ge=0)] = 0
) -> ArrivedBytes:
    """Takes a piece of the file, of 200 kB at most, from this byte on. After the last one it is
    read in the background, and kept in place of a part of the same name, or refused."""
    piece = await request.body()
    received = await asyncio.to_thread(context.comparisons.parts.take, part_id, at, piece)
    return ArrivedBytes(part_id, received)


@router.delete("/cad/{part_id}", status_code=HTTP_204_NO_CONTENT)
def remove_part(part_id: PartId, context: TheContext) -> None:
    """Removes a part; what was compared with it stays with the scans."""
    context.comparisons.parts.remove(part_id)


@router.get("/scans/{scan_id}/size")
def size(scan_id: ScanId, context: TheContext) -> ScanSize:
    """The extents of a displayed scan along its own main axes, by which the unit of a part is
    recognised."""
    found = context.comparisons.scan_size_mm(find_scan(context, scan_id))
    return ScanSize(None if found is None else tuple(found))


@router.post("/scans/{scan_id}/deviation", status_code=HTTP_202_ACCEPTED)
def compare(scan_id: ScanId, asked: NewComparison, context: TheContext) -> CompareState:
    """Starts to compare a finished scan with a part, in the background."""
    check_not_recorded(context, scan_id, message("compare-not-now"))
    scan = find_scan(context, scan_id)
    wish = ComparisonWish(
        part=asked.part,
        unit=asked.unit,
        body=asked.body,
        lower_mm=asked.lower_mm,
        upper_mm=asked.upper_mm,
        locked=tuple(dict.fromkeys(asked.locked)),
    )
    context.comparisons.start(scan, wish)
    return context.comparisons.state()


@router.post("/comparison/cancel")
def cancel(context: TheContext) -> CompareState:
    """Ends the comparison that is computed; what was kept before stays."""
    context.comparisons.cancel()
    return context.comparisons.state()


@router.get("/scans/{scan_id}/deviation")
def result(scan_id: ScanId, context: TheContext) -> ComparisonFile | None:
    """What was found of a scan; null: it was not compared."""
    return read_result(find_scan(context, scan_id))


@router.get("/scans/{scan_id}/deviation.json")
def result_file(scan_id: ScanId, context: TheContext) -> Response:
    """The same as a file."""
    return _member(context, scan_id, JSON, TEXT)


@router.get("/scans/{scan_id}/map.ply")
def map_file(scan_id: ScanId, context: TheContext) -> Response:
    """The cells of the map."""
    return _member(context, scan_id, MAP, BINARY)


@router.delete("/scans/{scan_id}/deviation", status_code=HTTP_204_NO_CONTENT)
def remove(scan_id: ScanId, context: TheContext) -> None:
    """Removes the map of a scan; scan and part stay."""
    context.comparisons.remove(find_scan(context, scan_id))


@router.post("/scans/{scan_id}/deviation/shown")
def show(scan_id: ScanId, asked: MapWish, context: TheContext) -> CompareState:
    """Shows the map of a scan in place of the clouds, or the clouds again."""
    if asked.on:
        scan = find_scan(context, scan_id)
        if read_result(scan) is None:
            raise NotFoundError(message("compare-no-map-yet"))
        context.comparisons.show(scan, asked.mode)
    else:
        context.comparisons.hide()
    return context.comparisons.state()


@router.post("/scans/{scan_id}/deviation/place")
def place(scan_id: ScanId, asked: PictureSpot, context: TheContext) -> PlaceOnMap:
    """What the map has at a place of the picture of a page."""
    camera = context.view_controller.pages.camera_of(asked.view)
    return context.comparisons.find(find_scan(context, scan_id), camera, asked.x, asked.y)


def _member(context: Context, scan_id: str, name: str, media_type: str) -> Response:
    scan = find_scan(context, scan_id)
    path = scan.folder / COMPARISON
    if not path.is_file():
        raise NotFoundError(message("compare-no-map-yet"))
    headers = {"Content-Disposition": f'attachment; filename="{scan.id}-{name}"'}
    return Response(read_member(path, name), media_type=media_type, headers=headers)

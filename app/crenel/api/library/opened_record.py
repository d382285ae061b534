"""The record that the 3D view shows instead of the live scan: opened, played, compared."""

from typing import Annotated

from fastapi import Path
from starlette.status import HTTP_204_NO_CONTENT

from crenel.api.access.authorization import StationRouter
from crenel.api.answers.lookups import find_scan
from crenel.operations.context import TheContext
from crenel.wire.library import LibraryState, RecordReference, RecordReplay
from crenel.wire.schema import OnOff

router = StationRouter(prefix="/api")
ScanId = Annotated[str, Path(max_length=128)]


@router.get("/library")
def library(context: TheContext) -> LibraryState:
    """What is opened, what is continued, and the part of the next scan."""
    return context.library.state()


@router.post("/scans/{scan_id}/opened", status_code=HTTP_204_NO_CONTENT)
def open_record(scan_id: ScanId, asked: OnOff, context: TheContext) -> None:
    """Shows a record alone in the view, or goes back to the last scan."""
    if asked.on:
        context.library.record_view.open(find_scan(context, scan_id))
    else:
        context.library.record_view.close(context.library.last_scan())


@router.post("/scans/{scan_id}/continued", status_code=HTTP_204_NO_CONTENT)
def continue_record(scan_id: ScanId, asked: OnOff, context: TheContext) -> None:
    """Adds the next scans to this record, or to none."""
    context.library.continue_record(find_scan(context, scan_id) if asked.on else None)


@router.post("/scans/{scan_id}/comparison", status_code=HTTP_204_NO_CONTENT)
def compare(scan_id: ScanId, asked: RecordReference, context: TheContext) -> None:
    """Opens a record and compares it with another one, in the background."""
    scan, reference = find_scan(context, scan_id), find_scan(context, asked.reference)
    view = context.library.record_view
    if view.opened is None or view.opened.id != scan.id:
        view.open(scan)
    view.compare(reference, scan.calibration_id == reference.calibration_id)


@router.delete("/view/comparison", status_code=HTTP_204_NO_CONTENT)
def end_comparison(context: TheContext) -> None:
    """Colours the opened record by height again."""
    context.library.record_view.end_comparison()


@router.post("/view/replay", status_code=HTTP_204_NO_CONTENT)
def replay(asked: RecordReplay, context: TheContext) -> None:
    """Plays the opened record again, from a time and at a speed, or holds it."""
    context.library.record_view.play(asked.at_s, asked.playing, asked.speed)

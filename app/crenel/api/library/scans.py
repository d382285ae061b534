"""The library of scans: the list, their parts, files, pictures, and clouds merged of several."""

import asyncio
import contextlib
import shutil
import tempfile
from pathlib import Path as Folder
from typing import Annotated

from fastapi import Path
from starlette.background import BackgroundTask
from starlette.responses import FileResponse, Response
from starlette.status import HTTP_202_ACCEPTED, HTTP_204_NO_CONTENT

from crenel.api.access.authorization import StationRouter
from crenel.api.answers.lookups import check_not_recorded, find_scan, send_file
from crenel.api.answers.problems import NotFoundError
from crenel.archive.records import is_in_archive_only, is_without_its_cloud
from crenel.errors import OperationError
from crenel.formats.clouds.cuts import copy_cloud, read_cuts
from crenel.formats.clouds.files import FORMS, WritableFormat, cloud_formats
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.results.scan_record import CLOUD, PartNames
from crenel.messages.message import Text, message
from crenel.operations.context import Context, TheContext
from crenel.operations.library.scan_records import cloud_changed_ns
from crenel.operations.recovery import DELETED
from crenel.station.jobs import Job, Progress
from crenel.store.scans import ScanRecord
from crenel.wire.json_response import json_response
from crenel.wire.library import NewPart, ScansToMerge, ScanSummary
from crenel.wire.schema import Rename

router = StationRouter(prefix="/api")
ScanId = Annotated[str, Path(max_length=128)]
Form = Annotated[str, Path(pattern=f"^({'|'.join(form.replace('.', '[.]') for form in FORMS)})$")]


@router.get("/scans", response_model=list[ScanSummary])
def scans(context: TheContext) -> Response:
    """Lists all scans, newest first."""
    listed = context.store.scans.all()
    names = {scan.id: scan.name for scan in listed}
    calibrations = {one.id: one.name for one in context.store.calibrations.all()}
    return json_response([_summary(scan, context, names, calibrations) for scan in listed])


@router.get("/scans/{scan_id}", response_model=ScanSummary)
def scan(scan_id: ScanId, context: TheContext) -> Response:
    """One scan as in the list."""
    found = find_scan(context, scan_id)
    sources = (context.store.scans.get(one) for one in found.sources)
    names = {one.id: one.name for one in sources if one is not None}
    used = context.store.calibrations.get(found.calibration_id)
    calibrations = {} if used is None else {used.id: used.name}
    return json_response(_summary(found, context, names, calibrations))


@router.get("/cloud-formats")
def formats() -> list[WritableFormat]:
    """The formats in which clouds can be downloaded."""
    return cloud_formats()


@router.get("/scans/{scan_id}/cloud.{form}")
async def cloud(scan_id: ScanId, form: Form, context: TheContext) -> Response:
    """The points of a scan in the arm frame, in a format by the end of the name, without those
    that were cut away in the view."""
    scan = find_scan(context, scan_id)
    path = _cloud_of(scan, context)
    name = f"{scan.id}.{form}"
    if form == "ply" and not read_cuts(path.parent):
        missing = message("no-longer-in-data-folder", name=path.name)
        return send_file(path, missing, "application/octet-stream", name)
    folder = Folder(await asyncio.to_thread(tempfile.mkdtemp, prefix="crenel-cloud-"))
    remove = BackgroundTask(shutil.rmtree, folder, ignore_errors=True)
    try:
        async with context.printer:
            await asyncio.to_thread(copy_cloud, path, folder / name)
    except BaseException:
        await remove()
        raise
    return FileResponse(
        folder / name, media_type="application/octet-stream", filename=name, background=remove
    )


@router.get("/scans/{scan_id}/picture.png")
async def picture(scan_id: ScanId, context: TheContext, large: bool = False) -> Response:
    """A picture of the cloud for lists, or a large one, transparent around it."""
    scan = find_scan(context, scan_id)
    missing = message("cloud-not-in-data-folder", name=scan.name)
    try:
        async with context.painter:
            path = await asyncio.to_thread(context.library.records.picture, scan, large)
    except OperationError as error:
        raise NotFoundError(missing) from error
    return send_file(path, missing, "image/png", cached=True)


@router.get("/part")
def next_part(context: TheContext) -> PartNames:
    """The part of the scan that runs, or of the next one."""
    return context.library.records.next_part


@router.post("/part")
def name_next_part(asked: NewPart, context: TheContext) -> PartNames:
    """Names the part of the scan that runs, and of the next ones."""
    context.library.records.set_next_part(PartNames(**asked.model_dump()))
    return context.library.records.next_part


@router.post("/scans/{scan_id}/part", status_code=HTTP_204_NO_CONTENT)
def name_part(scan_id: ScanId, asked: NewPart, context: TheContext) -> None:
    """Names the part of a finished scan."""
    scan = find_scan(context, scan_id)
    context.library.records.name_part(scan, PartNames(**asked.model_dump()))
    context.view_controller.note_records()


@router.post("/scans/{scan_id}/name", status_code=HTTP_204_NO_CONTENT)
def rename(scan_id: ScanId, asked: Rename, context: TheContext) -> None:
    """Renames a finished scan."""
    scan = find_scan(context, scan_id)
    name = " ".join(asked.name.split())
    if not name:
        raise OperationError("no-name", message("scan-needs-name"), remedy=message("write-one"))
    context.library.records.rename(scan, name)
    context.view_controller.note_records()


@router.post("/merged-scans", status_code=HTTP_202_ACCEPTED)
def merge(asked: ScansToMerge, context: TheContext) -> None:
    """Makes one cloud of several scans, in the background; they stay as they are."""
    chosen = [find_scan(context, scan_id) for scan_id in dict.fromkeys(asked.ids)]
    merger = context.library.merger
    merger.check(chosen)
    title = message("merging-scans", count=len(chosen))

    def work(progress: Progress) -> ScanRecord:
        name = " ".join(asked.name.split())
        return merger.merge(chosen, name, None, lambda share, step: progress(step, share))

    def ended(job: Job[ScanRecord]) -> None:
        if job.result is None:
            text = job.refusal.text if job.refusal is not None else title
            context.bus.event("refused", text, "bad")
        else:
            made = job.result
            text = message("scans-are-merged", name=made.name, points=made.points)
            context.bus.event("scans-merged", text, "good")

    context.jobs.start(title, work, ended)


@router.post("/scans/{scan_id}/fetch", status_code=HTTP_202_ACCEPTED)
def fetch(scan_id: ScanId, context: TheContext) -> None:
    """Brings a scan back from the archive, in the background."""
    scan = find_scan(context, scan_id)
    archive = context.monitoring.archive
    if archive is None:
        raise OperationError(
            "no-archive", message("archive-not-set"), remedy=message("archive-write-table")
        )

    def work(progress: Progress) -> None:
        archive.fetch("scans", scan.folder.name)

    def ended(job: Job[None]) -> None:
        if job.refusal is not None:
            context.bus.event("refused", job.refusal.text, "bad")
        else:
            context.bus.event("archive", message("archive-fetched", name=scan.name), "good")
        context.view_controller.note_records()

    context.jobs.start(message("archive-fetching", name=scan.name), work, ended)


@router.delete("/scans/{scan_id}", status_code=HTTP_204_NO_CONTENT)
def delete(scan_id: ScanId, context: TheContext) -> None:
    """Deletes a finished scan: recording, cloud, and its entry in the list."""
    check_not_recorded(context, scan_id, message("cannot-deleted-now"))
    scan = find_scan(context, scan_id)
    context.view_controller.hide(scan.id)
    context.scanner.forget(scan.id)
    # renamed first: if the process is killed in between, a partial folder is not mistaken for a
    # scan
    doomed = scan.folder.with_name(f"{DELETED}{scan.folder.name}")
    with convert_io_errors(scan.folder):
        if scan.folder.exists():
            scan.folder.rename(doomed)
        context.store.scans.delete(scan.id)
        context.library.forget(scan)
        context.view_controller.note_records()
        # with the remains of earlier ones after a power failure
        for left in scan.folder.parent.glob(f"{DELETED}*"):
            with contextlib.suppress(FileNotFoundError):  # another request is deleting it
                shutil.rmtree(left)
    context.bus.event("scan-deleted", message("deleted", name=scan.name))


def _summary(
    scan: ScanRecord, context: Context, names: dict[str, Text], calibrations: dict[str, str]
) -> ScanSummary:
    return ScanSummary(
        id=scan.id,
        name=scan.name,
        started_at=scan.started_at,
        points=scan.points,
        changed_ns=str(cloud_changed_ns(scan)),
        frames=scan.frames,
        seconds=scan.seconds,
        calibration_id=scan.calibration_id,
        note=context.recovery.scan_note(scan),
        incomplete=scan.left_out.is_too_much,
        away=is_in_archive_only(context.store.folder, "scans", scan.folder.name),
        part=scan.part,
        calibration=calibrations.get(scan.calibration_id, ""),
        frames_too_fast=scan.frames_too_fast,
        frames_lost=scan.frames_lost,
        frames_without_points=scan.left_out.frames,
        sources=tuple(names.get(one, one) for one in scan.sources),
    )


def _cloud_of(scan: ScanRecord, context: Context) -> Folder:
    """The cloud of a scan; raises ``NotFoundError`` where the archive alone has it."""
    if is_in_archive_only(context.store.folder, "scans", scan.folder.name):
        raise NotFoundError(message("archive-fetch-record", kind="scans", id=scan.folder.name))
    if is_without_its_cloud(context.store.folder, scan.folder.name):
        raise NotFoundError(context.recovery.scan_note(scan))
    return scan.folder / CLOUD

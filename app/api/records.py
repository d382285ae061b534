"""Records of the station: calibrations and scans, and the home page that shows them."""

import shutil
import tempfile
from pathlib import Path
from typing import Literal

from starlette.background import BackgroundTask
from starlette.responses import FileResponse, Response
from starlette.status import HTTP_202_ACCEPTED

from app.api.access.authorization import StationRouter
from app.api.lookups import find_calibration, find_scan, send_file
from app.api.problems import NotFoundError
from app.archive.records import is_in_archive_only, is_without_its_cloud
from app.errors import OperationError
from app.formats.clouds.cuts import copy_cloud, read_cuts
from app.formats.clouds.files import COPC, SUFFIXES
from app.formats.clouds.optional_library import format_obstacle
from app.messages.message import message
from app.operations.context import TheContext
from app.operations.home import build_home, calibration_summary
from app.station.jobs import Job, Progress
from app.wire.schema import CalibrationSummary, CloudFileFormat, Home, ScanSummary

router = StationRouter(prefix="/api")
CloudForm = Literal["ply", "pcd", "e57", "xyz", "las", "laz", "copc.laz"]
BYTES = "application/octet-stream"


@router.get("/home")
def home(context: TheContext) -> Home:
    """What is valid, what is due, and what to do next."""
    return build_home(context)


@router.get("/calibrations")
def calibrations(context: TheContext) -> list[CalibrationSummary]:
    """Lists all accepted calibrations, newest first."""
    return [calibration_summary(record) for record in context.store.calibrations.all()]


@router.get("/calibrations/{calibration_id}/calibration.json")
def calibration_file(calibration_id: str, context: TheContext) -> Response:
    """An accepted calibration, as described in docs/formats.md."""
    record = find_calibration(context, calibration_id)
    return _download(record.file, "application/json", f"calibration-{record.id}.json")


@router.get("/scans")
def scans(context: TheContext) -> list[ScanSummary]:
    """Lists all scans, newest first."""
    return [
        ScanSummary(
            id=scan.id,
            name=scan.name,
            started_at=scan.started_at,
            points=scan.points,
            frames=scan.frames,
            seconds=scan.seconds,
            calibration_id=scan.calibration_id,
            note=context.recovery.scan_note(scan),
            incomplete=scan.left_out.is_too_much,
            away=is_in_archive_only(context.store.folder, "scans", scan.folder.name),
        )
        for scan in context.store.scans.all()
    ]


@router.get("/cloud-formats")
def cloud_formats() -> list[CloudFileFormat]:
    """Which formats of clouds this station can write."""
    return [CloudFileFormat(suffix, format_obstacle(suffix)) for suffix in (*SUFFIXES, COPC)]


@router.get("/scans/{scan_id}/cloud.{form}")
def cloud(scan_id: str, form: CloudForm, context: TheContext) -> Response:
    """The points of a scan in the arm frame, without those that were cut away in the view."""
    scan = find_scan(context, scan_id)
    if is_in_archive_only(context.store.folder, "scans", scan.folder.name):
        raise NotFoundError(message("archive-fetch-record", kind="scans", id=scan.folder.name))
    if is_without_its_cloud(context.store.folder, scan.folder.name):
        raise NotFoundError(context.recovery.scan_note(scan))
    source, name = scan.folder / "cloud.ply", f"{scan.id}.{form}"
    cuts = read_cuts(scan.folder)
    if form == "ply" and not cuts:
        return _download(source, BYTES, name)
    copies = Path(tempfile.mkdtemp(prefix="crenel-cloud-"))
    sent = BackgroundTask(shutil.rmtree, copies, ignore_errors=True)
    try:
        copy_cloud(source, copies / name, cuts)
    except BaseException:
        shutil.rmtree(copies, ignore_errors=True)
        raise
    return FileResponse(copies / name, media_type=BYTES, filename=name, background=sent)


@router.post("/scans/{scan_id}/fetch", status_code=HTTP_202_ACCEPTED)
def fetch(scan_id: str, context: TheContext) -> None:
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


def _download(path: Path, media_type: str, name: str) -> Response:
    return send_file(path, message("data-folder-any-more", name=path.name), media_type, name)

"""The accepted calibrations, their pages and their history, and the home page that shows what is
valid."""

from dataclasses import asdict
from pathlib import Path as Folder
from typing import Annotated

from fastapi import Path
from starlette.responses import Response

from crenel.api.access.authorization import StationRouter
from crenel.api.answers.lookups import find_calibration, send_file
from crenel.errors import OperationError
from crenel.formats.results.acceptance import read_acceptance
from crenel.guide.calibration.accepted import restore_result
from crenel.guide.calibration.session_folder import SessionFolder
from crenel.messages.message import message
from crenel.operations.context import TheContext
from crenel.operations.home import build_home, calibration_summary
from crenel.store.calibrations import CalibrationRecord
from crenel.wire.json_response import json_response
from crenel.wire.schema import CalibrationPoint, CalibrationSummary, Home, RecordedCalibration
from crenel.workflows.calibration_history import HistoryEntry, read_history

router = StationRouter(prefix="/api")
CalibrationId = Annotated[str, Path(max_length=128)]


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
    missing = message("no-longer-in-data-folder", name=record.file.name)
    return send_file(record.file, missing, "application/json", f"calibration-{record.id}.json")


@router.get("/calibration-history")
def list_history(context: TheContext) -> list[CalibrationPoint]:
    """Every readable calibration, oldest first, with the changes since the previous one."""
    records = {record.id: record for record in reversed(context.store.calibrations.all())}
    entries = read_history([(record.id, record.file) for record in records.values()])
    return [_point(records[entry.id], entry) for entry in entries]


@router.get("/calibrations/{calibration_id}", response_model=RecordedCalibration)
def calibration(calibration_id: CalibrationId, context: TheContext) -> Response:
    """The result as it was shown before it was accepted."""
    record = find_calibration(context, calibration_id)
    folder = SessionFolder(record.file.parent)
    images = f"/api/calibrations/{record.id}/image/"
    picture, findings = restore_result(context.store.journal, folder, record.session_id, images)
    try:
        accepted = read_acceptance(folder.path)
    except OperationError:
        accepted = None
    shown = RecordedCalibration(
        summary=calibration_summary(record),
        operator=accepted.operator if accepted else "",
        station=accepted.station if accepted else "",
        temperature_c=accepted.temperature_c if accepted else None,
        picture=picture,
        findings=findings,
    )
    return json_response(shown)


@router.get("/calibrations/{calibration_id}/image/{name}")
def image(calibration_id: CalibrationId, name: str, context: TheContext) -> Response:
    """A picture of an accepted calibration."""
    record = find_calibration(context, calibration_id)
    found: Folder | None = SessionFolder(record.file.parent).image(name)
    return send_file(
        found, message("calibration-has-no-picture", name=name), "image/png", cached=True
    )


def _point(record: CalibrationRecord, entry: HistoryEntry) -> CalibrationPoint:
    since = entry.since
    moved = asdict(since.drift) if since else dict.fromkeys(DRIFT_FIELDS)
    return CalibrationPoint(
        id=record.id,
        name=record.name,
        accepted_at=record.accepted_at,
        total_um=record.figures.total_um,
        verdict=record.figures.verdict,
        good_um=entry.good_um,
        temperature_c=entry.temperature_c,
        arm_serial=record.figures.arm_serial,
        sensor_serial=record.figures.sensor_serial,
        expected_um=since.expected_um if since else None,
        expected_arcsec=since.expected_arcsec if since else None,
        **moved,
    )


DRIFT_FIELDS = ("sensor_um", "sensor_arcsec", "plane_um", "plane_arcsec", "points_um")

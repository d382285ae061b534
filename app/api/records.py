"""The calibrations of the station, and the home page that shows what is valid."""

from starlette.responses import Response

from app.api.access.authorization import StationRouter
from app.api.lookups import find_calibration, send_file
from app.messages.message import message
from app.operations.context import TheContext
from app.operations.home import build_home, calibration_summary
from app.wire.schema import CalibrationSummary, Home

router = StationRouter(prefix="/api")


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
    missing = message("data-folder-any-more", name=record.file.name)
    return send_file(record.file, missing, "application/json", f"calibration-{record.id}.json")

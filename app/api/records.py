"""What the station keeps: calibrations and scans, and the home page that tells of them."""

from datetime import UTC, datetime
from pathlib import Path

from fastapi import APIRouter
from starlette.responses import FileResponse, Response

from app.api.context import Context, TheContext
from app.api.problems import NotFound
from app.api.schema import CalibrationSummary, Home, NextStep, ScanSummary
from app.station.findings import Finding
from app.store.calibrations import CalibrationRecord

router = APIRouter(prefix="/api")
DUE_DAYS = 30.0
SECONDS_A_DAY = 86400.0


@router.get("/home")
def home(context: TheContext) -> Home:
    """What is valid, what is due, what to do next."""
    return home_of(context)


@router.get("/calibrations")
def calibrations(context: TheContext) -> list[CalibrationSummary]:
    """Every accepted calibration, newest first."""
    return [summary_of(record) for record in context.store.calibrations.all()]


@router.get("/calibrations/{calibration_id}/calibration.json")
def calibration_file(calibration_id: str, context: TheContext) -> Response:
    """An accepted calibration as FORMATS.md has it."""
    record = context.store.calibrations.get(calibration_id)
    if record is None:
        raise NotFound(f"There is no calibration {calibration_id}.")
    return _download(record.file, "application/json", f"calibration-{record.id}.json")


@router.get("/scans")
def scans(context: TheContext) -> list[ScanSummary]:
    """Every scan, newest first."""
    return [
        ScanSummary(
            id=scan.id,
            name=scan.name,
            started_at=scan.started_at,
            points=scan.points,
            frames=scan.frames,
            seconds=scan.seconds,
            calibration_id=scan.calibration_id,
        )
        for scan in context.store.scans.all()
    ]


@router.get("/scans/{scan_id}/cloud.ply")
def cloud(scan_id: str, context: TheContext) -> Response:
    """A scan's points in the arm frame."""
    scan = context.store.scans.get(scan_id)
    if scan is None:
        raise NotFound(f"There is no scan {scan_id}.")
    return _download(scan.folder / "cloud.ply", "application/octet-stream", f"{scan.id}.ply")


def _download(path: Path, media_type: str, name: str) -> Response:
    if not path.is_file():
        raise NotFound(f"{path.name} is not in the data folder any more.")
    return FileResponse(path, media_type=media_type, filename=name)


def summary_of(record: CalibrationRecord) -> CalibrationSummary:
    """A calibration as it is listed."""
    accepted = datetime.fromisoformat(record.accepted_at)
    age_days = (datetime.now(UTC) - accepted).total_seconds() / SECONDS_A_DAY
    return CalibrationSummary(
        id=record.id,
        name=record.name,
        accepted_at=record.accepted_at,
        age_days=max(round(age_days, 2), 0.0),
        total_um=record.figures.total_um,
        verdict=record.figures.verdict,
        active=record.active,
        arm_serial=record.figures.arm_serial,
        sensor_serial=record.figures.sensor_serial,
        object_serial=record.figures.object_serial,
    )


def home_of(context: Context) -> Home:
    """The home page as of now."""
    record = context.store.calibrations.active()
    summary = summary_of(record) if record else None
    findings: list[Finding] = []
    for link in (context.rig.arm.link(), context.rig.sensor.link()):
        if link.state in ("lost", "off"):
            findings.append(Finding("bad", f"{link.title}: {link.text}", "Check its connection."))
    if summary is None:
        findings.append(Finding("attention", "There is no calibration in use yet."))
    elif summary.age_days > DUE_DAYS:
        text = f"The calibration is {summary.age_days:.0f} days old; {DUE_DAYS:.0f} are the limit."
        findings.append(Finding("attention", text, "Calibrate again."))
    return Home(context.station, summary, tuple(findings), _next(context, summary))


def _next(context: Context, summary: CalibrationSummary | None) -> NextStep:
    if context.guide.running:
        text = "A calibration is under way. Go on where it stands."
        return NextStep("Go on calibrating", "calibrate", text)
    if summary is None:
        text = "Calibrate the sensor on the arm: touch the object, then take a few pictures."
        return NextStep("Calibrate", "calibrate", text)
    if summary.age_days > DUE_DAYS:
        return NextStep("Calibrate again", "calibrate", "The calibration is due.")
    refusal = context.scanner.why_not()
    if refusal is not None and refusal.code not in ("busy", "arm-lost", "sensor-lost"):
        return NextStep("Calibrate", "calibrate", refusal.line)
    return NextStep("Scan", "scan", "The calibration is valid. Scan the part.")

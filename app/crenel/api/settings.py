"""Settings for scans: the laser line, zones, limits, and the delay of the arm; logo of reports."""

import base64
from pathlib import Path

from crenel.api.access.authorization import StationRouter
from crenel.errors import OperationError
from crenel.formats.recording.reader import SCAN_CALIBRATION, open_recording
from crenel.formats.recording.topics import sensor_values
from crenel.formats.session.calibration_session import ARM
from crenel.messages.message import Text, message
from crenel.operations.context import Context, TheContext
from crenel.report.logo import (
    check_logo,
    logo_type,
    read_folder_logo,
    remove_logo,
    write_logo,
)
from crenel.station.operator_settings import PassRecord, SettingsChange, StationSettings
from crenel.wire.schema import OnOff, ReportLogo, UploadedLogo

router = StationRouter(prefix="/api/settings")
LARGEST_LOGO = 190_000
"""Bytes, within the largest body of a request."""


@router.get("")
def settings(context: TheContext) -> StationSettings:
    """The settings in use."""
    return context.settings.view()


@router.post("")
def change(asked: SettingsChange, context: TheContext) -> StationSettings:
    """Sets those that are given; applied at once, also to a running scan."""
    context.settings.change(asked)
    return context.settings.view()


@router.post("/exposure")
def expose(context: TheContext) -> StationSettings:
    """Sets the exposure from the laser line as it is detected now."""
    context.settings.expose_by_the_line()
    return context.settings.view()


@router.post("/delay/find")
def find_delay(context: TheContext) -> StationSettings:
    """Determines the delay between arm and camera from the last scan."""
    scan = context.store.scans.newest()
    if scan is None:
        raise OperationError(
            "no-scan",
            message("there-no-scan-find-delay"),
            remedy=message("scan-flat-plate-nearer-away-again"),
        )
    source = _source(context, scan.name, scan.folder, scan.calibration_id)
    context.settings.find_delay(context.jobs, lambda: source)
    return context.settings.view()


@router.post("/delay/pass")
def pass_for_delay(context: TheContext) -> StationSettings:
    """Lets the simulated operator pass over the plate, and determines the delay from that scan."""
    with context.activities.using("delay"):
        refusal = context.scanner.why_not()
        if refusal is not None:
            raise refusal
        context.settings.find_delay(context.jobs, lambda: _take_pass(context))
    return context.settings.view()


@router.post("/delay")
def use_delay(asked: OnOff, context: TheContext) -> StationSettings:
    """Applies the delay that was determined, or none."""
    context.settings.use_delay(asked.on)
    return context.settings.view()


@router.get("/logo")
def logo(context: TheContext) -> ReportLogo:
    """The logo of reports."""
    return _logo(context)


@router.post("/logo")
def change_logo(asked: UploadedLogo, context: TheContext) -> ReportLogo:
    """Makes a picture the logo of all reports."""
    try:
        picture = base64.b64decode(asked.data_url.partition(",")[2], validate=True)
    except ValueError:
        picture = b""
    check_logo(picture, message("chosen-picture"), LARGEST_LOGO, message("choose-another-picture"))
    write_logo(context.store.folder, picture)
    return _logo(context)


@router.delete("/logo")
def drop_logo(context: TheContext) -> ReportLogo:
    """Removes the logo from reports."""
    remove_logo(context.store.folder)
    return _logo(context)


def _logo(context: Context) -> ReportLogo:
    try:
        picture = read_folder_logo(context.store.folder)
    except OperationError as error:
        return ReportLogo("", error.text, LARGEST_LOGO)
    if picture is None:
        return ReportLogo("", "", LARGEST_LOGO)
    data = base64.b64encode(picture).decode()
    return ReportLogo(f"data:{logo_type(picture)};base64,{data}", "", LARGEST_LOGO)


def _take_pass(context: Context) -> PassRecord:
    """A scan that the simulated operator has just made."""
    context.scanner.start(message("pass-over-plate"))
    try:
        whole = context.simulated_scan.pass_over_plate()
    finally:
        result = context.scanner.stop()
    if not whole or result is None:
        raise OperationError("pass-stopped", message("pass-stopped"), remedy=message("start-again"))
    return _source(context, result.name, result.folder, result.calibration_id)


def _source(context: Context, name: Text, folder: Path, calibration_id: str) -> PassRecord:
    """A scan with the calibration with which it was made."""
    recording = folder / "scan.mcap"
    stated = sensor_values(open_recording(recording).station_metadata(), SCAN_CALIBRATION)
    sensor = context.rig.selected if context.rig.selected in stated else ""
    calibration = context.store.calibrations.get(stated[sensor] if sensor else calibration_id)
    if calibration is None:
        raise OperationError("no-calibration", message("calibration-no-longer-here", name=name))
    file = calibration.file
    return PassRecord(name, recording, file, file.parent / ARM, sensor)

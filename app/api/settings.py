"""What an operator sets of scans: the laser line, zones, limits, and the delay of the arm."""

from fastapi import APIRouter

from app.api.context import Context, TheContext
from app.api.schema import SettingsChange, Switch
from app.files.session import ARM
from app.metrology.refusal import Refusal
from app.station.operator_settings import PassRecord, StationSettings

router = APIRouter(prefix="/api/settings")


@router.get("")
def settings(context: TheContext) -> StationSettings:
    """As they are in use."""
    return context.settings.view()


@router.post("")
def change(asked: SettingsChange, context: TheContext) -> StationSettings:
    """Sets all of them but the delay; applied at once, also to a running scan."""
    fields = asked.model_dump(exclude={"zones"})
    context.settings.change(fields, asked.zones)
    return context.settings.view()


@router.post("/exposure")
def expose(context: TheContext) -> StationSettings:
    """Sets the exposure by the picture of now."""
    context.settings.expose_by_the_picture()
    return context.settings.view()


@router.post("/delay/find")
def find_delay(context: TheContext) -> StationSettings:
    """Looks for the delay between arm and camera in the last scan."""
    context.settings.find_delay(context.jobs, _last_pass(context))
    return context.settings.view()


@router.post("/delay")
def use_delay(asked: Switch, context: TheContext) -> StationSettings:
    """Applies the delay that was found, or none."""
    context.settings.use_delay(asked.on)
    return context.settings.view()


def _last_pass(context: Context) -> PassRecord:
    """The last scan, with the calibration that it was taken with."""
    scan = next(iter(context.store.scans.all()), None)
    if scan is None:
        raise Refusal(
            "no-scan",
            "There is no scan to find the delay from",
            remedy="Scan a flat plate, nearer and away again several times, then find it",
        )
    calibration = context.store.calibrations.get(scan.calibration_id)
    if calibration is None:
        raise Refusal("no-calibration", f"The calibration of {scan.name} is not here any more")
    folder = calibration.file.parent
    return PassRecord(scan.name, scan.folder / "scan.mcap", calibration.file, folder / ARM)

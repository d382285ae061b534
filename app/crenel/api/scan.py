"""Scanning, laser, exposure, and Stop."""

from typing import Literal

from starlette.status import HTTP_204_NO_CONTENT

from crenel.api.access.authorization import StationRouter, ThePerson
from crenel.errors import OperationError
from crenel.findings import Finding
from crenel.messages.message import Text, message
from crenel.operations.context import Context, TheContext
from crenel.station.activity import ArmUse
from crenel.station.devices.rig import Devices, SensorChoice
from crenel.wire.schema import ActivityEnd, Exposure, OnOff, ScanStart, ScanStatus, SensorName

router = StationRouter(prefix="/api")
JOB_END_S = 3.0
"""The simulated operator's work has ended by then."""


@router.get("/scan")
def scan(context: TheContext) -> ScanStatus:
    """The running scan, or the last one."""
    return context.scan_state()


@router.post("/scan/start")
def start_scan(context: TheContext, asked: ScanStart | None = None) -> ScanStatus:
    """Starts a scan and switches the laser on.

    With the arm still, it ends 30 s after the last action or heartbeat of whoever is in control,
    unless the settings say *Runs unattended*: requests that only read keep nothing going.
    """
    with context.activities.using("scan"):
        return _start_scan(context, asked.name if asked else "")


def _start_scan(context: Context, name: str) -> ScanStatus:
    job = context.jobs.current
    if job is not None:
        raise OperationError(
            "busy", message("scan-cannot-start-now"), job.text or job.title, message("wait-stop")
        )
    context.scanner.start(name)
    return context.scan_state()


@router.post("/scan/stop")
def stop_scan(context: TheContext) -> ScanStatus:
    """Stops the scan and saves it; does nothing if no scan is running."""
    context.simulated_scan.stop()
    context.scanner.stop()
    return context.scan_state()


@router.post("/scan/simulation")
def simulate_scan(asked: OnOff, context: TheContext) -> ScanStatus:
    """Starts or stops the simulated operator, which scans the parts."""
    if asked.on:
        with context.activities.using("scan"):
            context.simulated_scan.start()
    else:
        context.simulated_scan.stop()
    return context.scan_state()


@router.post("/demonstration", status_code=HTTP_204_NO_CONTENT)
def demonstrate(context: TheContext) -> None:
    """Lets the simulated operator do everything: calibrate, accept, and scan."""
    context.demonstration.start()


@router.post("/demonstration/stop", status_code=HTTP_204_NO_CONTENT)
def stop_demonstration(context: TheContext) -> None:
    """Ends the demonstration where it is; everyone may do this, whoever has control."""
    context.demonstration.stop()


@router.get("/activity")
def activity(context: TheContext) -> ArmUse:
    """What has the arm, by whom and since when."""
    return context.activities.use


@router.post("/activity/end")
def end_activity(asked: ActivityEnd, context: TheContext) -> ArmUse:
    """Takes the arm from an activity: a scan is stopped and saved, a guided session stays open.

    Refused if another activity has the arm by now.
    """
    context.activities.end(asked.id, lambda: _end_work(context))
    return context.activities.use


def _end_work(context: Context) -> None:
    stop_everything(context)
    context.jobs.wait(JOB_END_S)


@router.post("/laser/on")
def laser_on(context: TheContext) -> Devices:
    """Switches the laser on."""
    context.rig.sensor.set_laser(True)
    return context.rig.devices()


@router.post("/laser/off")
def laser_off(context: TheContext) -> Devices:
    """Switches the laser off; everyone may do this, whoever has control."""
    context.rig.lasers_off()
    return context.rig.devices()


@router.post("/exposure")
def exposure(asked: Exposure, context: TheContext) -> Devices:
    """Sets the exposure, clipped to the sensor's range."""
    context.rig.sensor.set_exposure_us(asked.exposure_us)
    return context.rig.devices()


@router.post("/sensor")
def select_sensor(asked: SensorName, context: TheContext) -> SensorChoice:
    """Selects the sensor that is seen, switched, exposed and calibrated, of several."""
    choice = context.sensor_selection.select(asked.name)
    context.bus.publish("sensors", choice)
    return choice


@router.post("/stop", status_code=HTTP_204_NO_CONTENT)
def stop(context: TheContext, person: ThePerson) -> None:
    """Switches the laser off, then stops the simulated operator and the scan."""
    holder = context.lease.control.holder
    if holder is None or holder.id == person.id:
        stop_everything(context)
        context.bus.event("stopped", message("stopped-laser-off"), "attention")
        return
    # whoever is in control finds what has ended, and by whom, also after a while
    because = message("stopped-by", name=person.name)
    scan: Literal["yes", "no"] = "no" if context.scanner.recording() is None else "yes"
    stop_everything(context, because)
    context.activities.note(
        Finding("attention", because, message("stopped-by-what-kept", scan=scan))
    )
    context.bus.event("stopped", because)


def stop_everything(context: Context, because: Text = "") -> None:
    """In the order of danger; scanned data is saved.

    Args:
        because: who stopped a scan that another one began; empty for its operator.
    """
    context.rig.lasers_off()
    context.demonstration.stop()
    context.simulated_scan.stop()
    for guide in context.guides:
        guide.stop_work()
    context.scanner.stop(because)
    context.rig.lasers_off()

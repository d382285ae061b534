"""Connects the parts of the station, and closes them in order."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from app.api.scan import stop_everything
from app.errors import OperationError
from app.formats.datasheets.gauge import DEFAULT_LIMITS, VerificationLimits
from app.formats.json_document import SOFTWARE
from app.guide.arm.commands import COMMANDS as ARM_COMMANDS
from app.guide.arm.guide import ArmGuide
from app.guide.calibration.commands import COMMANDS as CALIBRATION_COMMANDS
from app.guide.calibration.guide import CalibrationGuide, CalibrationServices
from app.guide.common.buttons import Buttons, Press
from app.guide.common.datasheet_library import read_library
from app.guide.common.guided_session import GuidedSession, Provenance, StationServices
from app.guide.common.simulated_operator import SimulatedOperator
from app.guide.common.simulated_scan import SimulatedScan
from app.guide.common.validity import DUE, DueLimits
from app.guide.gauge.session import GaugeServices
from app.guide.performance.commands import COMMANDS as PERFORMANCE_COMMANDS
from app.guide.performance.guide import PerformanceGuide, PerformanceServices
from app.guide.verify.commands import COMMANDS as VERIFICATION_COMMANDS
from app.guide.verify.guide import VerifyGuide
from app.messages.message import Text, message
from app.metrology.decision import GUARDED_95, DecisionRule
from app.metrology.limits import LIMITS, Limits
from app.metrology.performance.temperature import TEMPERATURE_LIMITS, TemperatureLimits
from app.operations.calibration_in_use import (
    calibration_error,
    scan_calibration,
    unreadable_calibration_error,
)
from app.operations.context import Context
from app.operations.device_setup import KINDS, DeviceSetup, StationDevices, choice_of
from app.operations.home import last_tip_finding
from app.operations.recovery import Recovery
from app.operations.sensor_selection import SensorSelection
from app.operations.services import MonitoringServices, MonitoringSettings
from app.security.authentication import Authenticator
from app.security.console_code import new_code
from app.settings.settings import DeviceKind
from app.single_sign_on.settings import SignInSettings
from app.station.bus import Bus
from app.station.control_lease import Lease
from app.station.devices.rig import Rig
from app.station.jobs import Jobs
from app.station.operator_settings import OperatorSettings
from app.station.preview.preview import Preview
from app.station.pulses.pulse_trigger import TriggerSettings
from app.station.scan.scanner import Scanner
from app.station.scan.state import ScanResult
from app.station.setup.drivers import choose_arm, choose_sensor, sensor_factory
from app.station.view3d.scene import Scene
from app.station.view3d.view_controller import ViewController
from app.station.working_distance import WorkingRange
from app.store.scans import ScanRecord
from app.store.store import Store
from app.wire.schema import StationInfo
from hardware.interfaces import ArmDriver, SensorDriver

if TYPE_CHECKING:
    from app.single_sign_on.provider import Provider

JOB_END_S = 3.0


@dataclass(frozen=True)
class StationParts:
    """The properties in which stations differ."""

    name: str
    data: Path
    arm: Callable[[], ArmDriver] | None = None
    """None: by ``devices``, as the sensor."""
    sensor: Callable[[], SensorDriver] | Mapping[str, Callable[[], SensorDriver]] | None = None
    """Of several sensors, one for each by its name."""
    hosts: tuple[str, ...] = ()
    simulated_operator: SimulatedOperator | None = None
    """Of the simulated station."""
    limits: Limits = LIMITS
    """Limits for the verdict on a calibration."""
    verification: VerificationLimits = DEFAULT_LIMITS
    """Limits for a verification if its gauge has none."""
    rule: DecisionRule = GUARDED_95
    """By which everything is judged."""
    temperature_limits: TemperatureLimits = TEMPERATURE_LIMITS
    """How steady artefact and arm have to be in a performance test."""
    due: DueLimits = DUE
    """When checks are due again."""
    guest: str | None = None
    """The account that a link on the console signs in, for a demonstration or a replay."""
    code: str = field(default_factory=new_code)
    """The output on the console."""
    trigger: TriggerSettings | None = None
    """How the arm triggers the camera, if it does."""
    devices: StationDevices = field(default_factory=StationDevices)
    """The choice of the devices, which the Devices page can change."""
    monitoring: MonitoringSettings = field(default_factory=MonitoringSettings)
    """Recipients of notifications, and further services."""
    sign_in: SignInSettings | None = None
    """The provider of the plant's accounts."""


def open_context(parts: StationParts) -> Context:
    """Opens the data folder and connects the parts; devices are not accessed yet.

    Raises:
        OperationError: the data folder cannot be used, or is in use by another server.
    """
    store = Store(parts.data)
    try:
        return _build_context(parts, store)
    except BaseException:
        store.close()
        raise


def _build_context(parts: StationParts, store: Store) -> Context:
    bus = Bus()
    tables, simulation = parts.devices.tables, parts.devices.simulation
    real: frozenset[DeviceKind] = frozenset(tables)
    real |= {"sensor"} if parts.devices.sensors else frozenset()
    real = real if simulation is not None else frozenset()
    rig = Rig(
        bus,
        parts.arm or choose_arm(choice_of(tables.get("arm")), simulation),
        parts.sensor or _sensor_makers(parts.devices),
        store.folder,
        parts.trigger,
        real,
    )
    scene = Scene()
    scanner = Scanner(bus, rig, scene, store.folder / "scans")
    viewing = ViewController(bus, scene, store.folder / "scans", scanner.distance)
    preview = Preview(bus, rig.arm, rig.sensor)
    jobs = Jobs(bus)
    watch = MonitoringServices(parts.monitoring, parts.name, bus, store, jobs)
    settings = OperatorSettings(
        bus, rig, scanner, preview, store.settings.read(), store.settings.save
    )
    if store.settings.trouble is not None:
        lost = message("settings-are-lost", error=store.settings.trouble.text)
        bus.event("refused", lost, "attention")

    lease = Lease(bus)
    simulated = parts.simulated_operator is not None

    def celsius_now() -> float | None:
        reading = store.temperatures.newest()
        return reading.celsius if reading else None

    signing = Provenance(
        parts.name,
        lambda: simulated and len(rig.real) < len(KINDS),
        lambda: lease.last_name,
        celsius_now,
        store.temperatures.celsius_near,
    )

    def use_active() -> None:
        for name in rig.sensors:
            _use_calibration(name, store, rig, preview, scanner, bus)

    def use_selected() -> None:
        use_active()
        settings.publish()  # the exposure shown is that of the selected sensor

    use_active()  # an open session then applies its own choice
    guide = CalibrationGuide(
        CalibrationServices(bus, rig, jobs, parts.simulated_operator, preview, scene),
        store.journal,
        store.calibrations,
        store.folder,
        use_active,
        parts.limits,
        signing,
        parts.rule,
    )
    watch.open_archive(store, lambda: scanner.recording() is not None)
    recovery = Recovery(store, scanner, jobs, bus, viewing.note_records)
    recovery.list_unlisted()
    simulated_scan = SimulatedScan(
        lambda: guide.station.simulated_operator,
        jobs,
        bus,
        lambda: bus.publish("scan", scanner.state()),
    )
    scanner.on_finished = lambda result: _record_scan(result, store, watch)
    arm_station = StationServices(bus, rig, jobs, parts.simulated_operator)
    arm_guide = ArmGuide(arm_station, store.journal, store.folder, signing, parts.rule)
    guide.tip = lambda: last_tip_finding(arm_guide, parts.due)
    verify_guide = VerifyGuide(
        GaugeServices(bus, rig, jobs, parts.simulated_operator, scanner, scene),
        store.journal,
        store.calibrations,
        store.verifications,
        store.folder,
        parts.verification,
        signing,
        parts.rule,
    )
    performance_guide = PerformanceGuide(
        PerformanceServices(
            bus,
            rig,
            jobs,
            parts.simulated_operator,
            scanner,
            scene,
            lambda: settings.settings.model_dump(mode="json"),
        ),
        store.journal,
        store.calibrations,
        store.performances,
        store.folder,
        signing,
        parts.rule,
        parts.temperature_limits,
    )
    guides = (guide, arm_guide, verify_guide, performance_guide)
    rig.arm.on_button = Buttons(
        _button_handler(*guides),
        there=lambda: rig.arm.link().state == "connected",
    ).edge
    device_setup = DeviceSetup(
        bus,
        rig,
        parts.devices,
        lambda: _work_error(scanner, jobs, guides),
        watch.note_devices,
        watch.note_options,
        lambda: read_library(store.folder),
        store.folder,
    )
    station = StationInfo(
        parts.name, SOFTWARE.version, has_simulation=simulated, simulated=simulated
    )
    return Context(
        station,
        bus,
        rig,
        preview,
        scene,
        scanner,
        viewing,
        jobs,
        store,
        guide,
        simulated_scan,
        arm_guide,
        verify_guide,
        performance_guide,
        settings,
        lease,
        Authenticator(
            store.accounts, store.login_sessions, store.api_tokens, parts.guest, parts.code
        ),
        watch,
        recovery,
        device_setup,
        SensorSelection(
            rig,
            preview,
            use_selected,
            lambda: any(one.running for one in guides),
            lambda: scanner.recording() is not None,
        ),
        parts.due,
        _open_provider(parts.sign_in, store),
    )


def _open_provider(settings: SignInSettings | None, store: Store) -> "Provider | None":
    """The provider of accounts; who signed in with another one must sign in again."""
    store.login_sessions.end_other_providers(settings.issuer if settings else "")
    if settings is None:
        return None
    # most stations have no provider, and need not import the library
    from app.single_sign_on.provider import Provider

    return Provider(settings)


def close_context(context: Context) -> None:
    """Switches the laser off, stops motion and scan, saves the scan and closes devices. The store
    stays open."""
    stop_everything(context)
    if context.monitoring.archive is not None:
        context.monitoring.archive.close()
    context.device_setup.close()
    context.jobs.wait(JOB_END_S)
    context.recovery.close()
    context.scanner.close()
    context.preview.stop()
    context.rig.stop()
    context.view_controller.close()
    context.scene.close()


def _work_error(
    scanner: Scanner, jobs: Jobs, guides: Sequence[GuidedSession[Any, Any, Any]]
) -> OperationError | None:
    """Why devices cannot be changed now: a scan, a job or a guided session is open."""
    what: Text = ""
    if scanner.state().state in ("running", "stopping"):
        what = message("scanning")
    elif (job := jobs.current) is not None:
        what = job.title
    elif any(guide.running for guide in guides):
        what = message("guided-session-is-open")
    if not what:
        return None
    return OperationError(
        "busy", message("devices-cannot-be-changed-now"), what, message("end-it-first")
    )


def _button_handler(
    guide: CalibrationGuide,
    arm_guide: ArmGuide,
    verify_guide: VerifyGuide,
    performance_guide: PerformanceGuide,
) -> Callable[[Press], None]:
    """A press belongs to the open session that waits for it and was used last."""

    def pressed(event: Press) -> None:
        sessions: list[tuple[int, Callable[[], bool]]] = [
            (guide.state.rev, lambda: CALIBRATION_COMMANDS.press(guide, event)),
            (verify_guide.state.rev, lambda: VERIFICATION_COMMANDS.press(verify_guide, event)),
            (
                performance_guide.state.rev,
                lambda: PERFORMANCE_COMMANDS.press(performance_guide, event),
            ),
            (arm_guide.state.rev, lambda: ARM_COMMANDS.press(arm_guide, event)),
        ]
        for _, takes in sorted(sessions, key=lambda one: one[0], reverse=True):
            if takes():
                return

    return pressed


def _record_scan(result: ScanResult, store: Store, watch: MonitoringServices) -> None:
    """A separate scan is listed; a cloud of a verification belongs to that verification."""
    if result.folder.parent == store.folder / "scans":
        store.scans.add(_record(result))
        watch.note_scan(result)


def _record(result: ScanResult) -> ScanRecord:
    return ScanRecord(
        id=result.id,
        name=result.name,
        folder=result.folder,
        started_at=result.started_at,
        points=result.points,
        frames=result.frames,
        seconds=result.seconds,
        calibration_id=result.calibration_id,
        interrupted=result.interrupted,
        recording_bytes=result.recording_bytes,
    )


def _sensor_makers(
    devices: StationDevices,
) -> Callable[[], SensorDriver] | Mapping[str, Callable[[], SensorDriver]]:
    """The factory of the sensor, or of each of several."""
    if not devices.sensors:
        return choose_sensor(choice_of(devices.tables.get("sensor")), devices.simulation)
    return {
        name: sensor_factory(table.driver, table.options) for name, table in devices.sensors.items()
    }


def _use_calibration(
    name: str,
    store: Store,
    rig: Rig,
    preview: Preview,
    scanner: Scanner,
    bus: Bus,
) -> None:
    """Makes the active calibration of a sensor the one for scans."""
    record, is_shown = store.calibrations.active(name), name == rig.selected
    if is_shown:
        preview.set_calibration(None)
    if record is None:
        scanner.set_calibration(None, _unreadable(store, name), sensor=name)
        return
    try:
        calibration = scan_calibration(record)
    except OperationError as error:
        text = message("calibration-in-use-unreadable", error=error.text)
        bus.event("refused", text, "bad")
        scanner.set_calibration(None, unreadable_calibration_error(error.text), sensor=name)
        return
    rig.arm.set_model(calibration.arm)
    scanner.set_calibration(calibration, look=lambda: calibration_error(record), sensor=name)
    if not is_shown:
        return
    preview.set_stripe_axis(calibration.stripe_axis)
    preview.set_calibration(
        WorkingRange(
            calibration.camera,
            calibration.plane,
            calibration.depth_range_mm,
            calibration.stripe_axis,
        )
    )


def _unreadable(store: Store, sensor: str) -> OperationError | None:
    """Why there is none although one was accepted."""
    active = next(
        (one for one in store.calibrations.unreadable() if one.active and one.sensor == sensor),
        None,
    )
    return (
        None
        if active is None
        else unreadable_calibration_error(message("no-readable-figures", name=active.name))
    )

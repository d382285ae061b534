"""Connects the parts of the station, and closes them in order."""

from collections.abc import Callable
from contextlib import ExitStack
from typing import TYPE_CHECKING

from crenel.api.scan import stop_everything
from crenel.errors import OperationError
from crenel.formats.json_document import SOFTWARE
from crenel.guide.common.buttons import Buttons
from crenel.guide.common.datasheet_library import read_library
from crenel.guide.common.guided_session import Provenance
from crenel.guide.common.simulated_scan import SimulatedScan
from crenel.messages.message import Text, message
from crenel.operations.context import Context
from crenel.operations.datasheets.station_datasheets import Datasheets
from crenel.operations.demonstration import Demonstration
from crenel.operations.device_setup import KINDS, DeviceSetup
from crenel.operations.library.record_view import as_stored_scan
from crenel.operations.library.scan_library import ScanLibrary
from crenel.operations.recovery import Recovery
from crenel.operations.sensor_selection import SensorSelection
from crenel.operations.services import MonitoringServices
from crenel.parts.compare.guide_comparison import Comparisons
from crenel.security.authentication import Authenticator
from crenel.server.guides import StationGuides, open_guides
from crenel.server.live_station import LiveStation, open_live_station
from crenel.server.station_parts import StationParts
from crenel.single_sign_on.settings import SignInSettings
from crenel.station.activity import Activities
from crenel.station.control_lease import Lease
from crenel.station.devices.rig import Rig
from crenel.station.jobs import Jobs
from crenel.station.scan.scanner import Scanner
from crenel.station.scan.state import ScanResult
from crenel.station.unattended import Unattended, UnattendedWatch
from crenel.store.store import Store
from crenel.wire.schema import StationInfo

if TYPE_CHECKING:
    from crenel.single_sign_on.provider import Provider

JOB_END_S = 3.0


def open_context(parts: StationParts) -> Context:
    """Opens the data folder and connects the parts; devices are not accessed yet.

    Raises:
        OperationError: the data folder cannot be used, or is in use by another server.
    """
    with ExitStack() as opened:
        store = Store(parts.data)
        opened.callback(store.close)
        context = _build_context(parts, store, opened)
        opened.pop_all()
        return context


def _build_context(parts: StationParts, store: Store, opened: ExitStack) -> Context:
    live = open_live_station(parts, store)
    opened.callback(live.scene.close)
    opened.callback(live.view_controller.close)
    opened.callback(live.scanner.close)
    bus, rig, jobs, scanner = live.bus, live.rig, live.jobs, live.scanner
    watch = MonitoringServices(parts.monitoring, parts.name, bus, store, jobs)
    opened.callback(watch.close)
    lease = Lease(bus)

    def use_calibrations() -> None:
        live.use_calibrations(store)

    def show_selected_sensor() -> None:
        use_calibrations()
        live.settings.publish()  # the exposure shown is that of the selected sensor

    activities = Activities(bus, lambda: lease.last_name)
    use_calibrations()  # an open session then applies its own choice
    provenance = _provenance(parts, store, rig, lease)
    guides = open_guides(parts, store, live, provenance, use_calibrations)
    guides.share_arm(activities)
    watch.open_archive(store, live.is_recording)
    recovery = Recovery(store, scanner, jobs, bus, live.view_controller.note_records)
    recovery.list_unlisted()
    library = ScanLibrary(bus, store, scanner, live.scene, live.view_controller, jobs, provenance)
    opened.callback(library.close)
    comparisons = Comparisons(
        bus,
        store,
        live.scene,
        jobs,
        lambda scan: live.view_controller.show(as_stored_scan(scan)),
    )
    opened.callback(comparisons.close)
    comparisons.publish()
    scanner.on_finished = lambda result: _record_scan(result, store, library, watch)
    scanner.on_begun = library.note_begin
    buttons = Buttons(guides.press, there=lambda: rig.arm.link().state == "connected")
    rig.arm.on_button = buttons.edge
    simulated = parts.simulated_operator is not None
    simulated_scan = SimulatedScan(
        lambda: guides.calibration.station.simulated_operator,
        jobs,
        bus,
        scanner,
        lambda: bus.publish("scan", scanner.state()),
    )
    activities.add("scan", lambda: live.is_recording() or simulated_scan.running)
    activities.add("delay", lambda: live.settings.finding_delay)
    return Context(
        opened_as=StationInfo(
            parts.name, SOFTWARE.version, has_simulation=simulated, simulated=simulated
        ),
        bus=bus,
        rig=rig,
        buttons=buttons,
        preview=live.preview,
        scene=live.scene,
        scanner=scanner,
        view_controller=live.view_controller,
        jobs=jobs,
        store=store,
        guide=guides.calibration,
        simulated_scan=simulated_scan,
        demonstration=Demonstration(
            bus, jobs, guides.calibration, simulated_scan, scanner, activities
        ),
        arm_guide=guides.arm,
        verify_guide=guides.verify,
        performance_guide=guides.performance,
        part_guide=guides.part,
        settings=live.settings,
        lease=lease,
        activities=activities,
        unattended=_watch_unattended(live, guides, simulated_scan, lease, activities),
        authenticator=Authenticator(
            store.accounts, store.login_sessions, store.api_tokens, parts.guest, parts.code
        ),
        monitoring=watch,
        recovery=recovery,
        library=library,
        comparisons=comparisons,
        device_setup=DeviceSetup(
            bus,
            rig,
            parts.devices,
            lambda: _work_error(scanner, jobs, guides),
            watch.note_devices,
            watch.note_options,
            lambda: read_library(store.folder),
            store.folder,
        ),
        datasheets=Datasheets(store, rig, guides.note_datasheets),
        sensor_selection=SensorSelection(
            rig, live.preview, show_selected_sensor, guides.name_open, live.is_recording
        ),
        due=parts.due,
        provider=_open_provider(parts.sign_in, store),
    )


def _watch_unattended(
    live: LiveStation,
    guides: StationGuides,
    simulated_scan: SimulatedScan,
    lease: Lease,
    activities: Activities,
) -> UnattendedWatch:
    """Scan and lasers stop when nobody is in control; the simulated operator is somebody."""
    rig = live.rig

    def stop(because: Text) -> None:
        rig.lasers_off()
        guides.calibration.stop_work()  # a picture would light the laser again
        live.scanner.stop(because)
        rig.lasers_off()
        live.bus.event("unattended-stop", because, "bad")

    station = Unattended(
        silence_s=lambda: lease.silence_s,
        place_mm=rig.arm.place_mm,
        is_lit=lambda: (
            live.is_recording() or rig.laser.state == "on" or guides.calibration.taking_poses
        ),
        is_driven=lambda: simulated_scan.running or guides.any_simulated(),
        limit_s=lambda: live.settings.settings.unattended_limit_s,
    )
    return UnattendedWatch(station, stop, activities.note)


def _provenance(parts: StationParts, store: Store, rig: Rig, lease: Lease) -> Provenance:
    """What records say of this station, its operator and its temperature."""
    simulated = parts.simulated_operator is not None

    def celsius_now() -> float | None:
        reading = store.temperatures.newest()
        return reading.celsius if reading else None

    return Provenance(
        parts.name,
        lambda: simulated and len(rig.real) < len(KINDS),
        lambda: lease.last_name,
        celsius_now,
        store.temperatures.celsius_near,
    )


def _open_provider(settings: SignInSettings | None, store: Store) -> "Provider | None":
    """The provider of accounts; who signed in with another one must sign in again."""
    store.login_sessions.end_other_providers(settings.issuer if settings else "")
    if settings is None:
        return None
    # most stations have no provider, and need not import the library
    from crenel.single_sign_on.provider import Provider

    return Provider(settings)


def close_context(context: Context) -> None:
    """Switches the laser off, stops motion and scan, saves the scan and closes devices. The store
    stays open.

    All of it is done, whatever fails; the error is raised at the end.
    """
    archive = context.monitoring.archive
    steps: list[Callable[[], object]] = [
        lambda: stop_everything(context),
        lambda: context.demonstration.close(JOB_END_S),
        archive.close if archive is not None else lambda: None,
        context.device_setup.close,
        context.block_designs.close,
        context.comparisons.close,
        lambda: context.jobs.wait(JOB_END_S),
        context.recovery.close,
        context.scanner.close,
        context.preview.stop,
        context.rig.stop,
        context.buttons.close,
        context.library.close,
        context.view_controller.close,
        context.scene.close,
    ]
    with ExitStack() as closing:
        for step in reversed(steps):
            closing.callback(step)


def _work_error(scanner: Scanner, jobs: Jobs, guides: StationGuides) -> OperationError | None:
    """Why devices cannot be changed now: a scan, a job or a guided session is open."""
    what: Text = ""
    if scanner.state().state in ("running", "stopping"):
        what = message("scanning")
    elif (job := jobs.current) is not None:
        what = job.title
    else:
        what = guides.name_open()
    if not what:
        return None
    return OperationError(
        "busy", message("devices-cannot-be-changed-now"), what, message("end-it-first")
    )


def _record_scan(
    result: ScanResult, store: Store, library: ScanLibrary, watch: MonitoringServices
) -> None:
    """A separate scan is listed; a cloud of a verification belongs to that verification."""
    if result.folder.parent == store.folder / "scans":
        library.note_end(result)
        watch.note_scan(result)

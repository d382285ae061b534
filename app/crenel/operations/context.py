"""The parts of the station that the routes use."""

import asyncio
from dataclasses import dataclass, field, fields, replace
from typing import TYPE_CHECKING, Annotated, cast

from fastapi import Depends
from starlette.requests import HTTPConnection

from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.quick.guide.guide import VerifyGuide
from crenel.guide.arm.guide import ArmGuide
from crenel.guide.calibration.guide import CalibrationGuide
from crenel.guide.common.buttons import Buttons
from crenel.guide.common.simulated_scan import SimulatedScan
from crenel.guide.common.validity import DUE, DueLimits
from crenel.operations.datasheets.block_designs import BlockDesigns
from crenel.operations.datasheets.station_datasheets import Datasheets
from crenel.operations.demonstration import Demonstration
from crenel.operations.device_setup import KINDS, DeviceSetup
from crenel.operations.library.scan_library import ScanLibrary
from crenel.operations.recovery import Recovery
from crenel.operations.sensor_selection import SensorSelection
from crenel.operations.services import MonitoringServices
from crenel.parts.compare.guide_comparison import Comparisons
from crenel.parts.session.guide import PartGuide
from crenel.security.authentication import Authenticator
from crenel.station.activity import Activities
from crenel.station.bus import Bus
from crenel.station.control_lease import Lease
from crenel.station.devices.rig import Rig
from crenel.station.jobs import Jobs
from crenel.station.operator_settings import OperatorSettings
from crenel.station.preview.preview import Preview
from crenel.station.scan.scanner import Scanner
from crenel.station.scan.state import ScanState as ScannerState
from crenel.station.unattended import UnattendedWatch
from crenel.station.view3d.scene import Scene
from crenel.station.view3d.view_controller import ViewController
from crenel.store.store import Store
from crenel.wire.schema import ScanStatus, StationInfo
from crenel.wire.topic_texts import TopicTexts

if TYPE_CHECKING:
    from crenel.single_sign_on.provider import Provider


@dataclass(frozen=True)
class Context:
    """The connected parts of the station."""

    opened_as: StationInfo
    """What it is with simulated devices, if it has those."""
    bus: Bus
    rig: Rig
    buttons: Buttons
    preview: Preview
    scene: Scene
    scanner: Scanner
    view_controller: ViewController
    jobs: Jobs
    store: Store
    guide: CalibrationGuide
    simulated_scan: SimulatedScan
    demonstration: Demonstration
    arm_guide: ArmGuide
    verify_guide: VerifyGuide
    performance_guide: PerformanceGuide
    part_guide: PartGuide
    settings: OperatorSettings
    lease: Lease
    activities: Activities
    unattended: UnattendedWatch
    authenticator: Authenticator
    monitoring: MonitoringServices
    recovery: Recovery
    library: ScanLibrary
    comparisons: Comparisons
    device_setup: DeviceSetup
    datasheets: Datasheets
    sensor_selection: SensorSelection
    due: DueLimits = DUE
    provider: "Provider | None" = None
    """The provider of the plant's accounts."""
    topic_texts: TopicTexts = field(default_factory=TopicTexts)
    block_designs: BlockDesigns = field(default_factory=BlockDesigns)
    printer: asyncio.Lock = field(default_factory=asyncio.Lock)
    """Reports are made one at a time: many at once would delay Stop."""
    painter: asyncio.Lock = field(default_factory=asyncio.Lock)
    """So are pictures of clouds: a list asks for many, and who waits for one holds no thread."""

    @property
    def station(self) -> StationInfo:
        """The station as browsers show it, with the devices that it uses now."""
        base, real = self.opened_as, self.rig.real
        return replace(
            base,
            has_simulation=base.has_simulation and not real,
            simulated=base.simulated and len(real) < len(KINDS),
        )

    @property
    def guides(self) -> tuple[CalibrationGuide, ArmGuide, VerifyGuide, PerformanceGuide, PartGuide]:
        """All guided sessions."""
        return (
            self.guide,
            self.arm_guide,
            self.verify_guide,
            self.performance_guide,
            self.part_guide,
        )

    def scan_state(self, state: ScannerState | None = None) -> ScanStatus:
        """The scan as the browser shows it."""
        known = state or self.scanner.state()
        values = {one.name: getattr(known, one.name) for one in fields(known)}
        return ScanStatus(**values, simulation_running=self.simulated_scan.running)


def context_of(connection: HTTPConnection) -> Context:
    """The context with which the application was built."""
    return cast(Context, connection.app.state.context)


TheContext = Annotated[Context, Depends(context_of)]

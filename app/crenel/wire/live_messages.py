"""Messages of the live connection to a browser tab, except the pictures of the preview: messages of
the server, and requests of a tab."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic import Field

from crenel.findings import Quality
from crenel.gauges.guide_view import PerformanceView
from crenel.gauges.quick.guide.view import VerifyView
from crenel.guide.arm.view import ArmView
from crenel.guide.common.view import FlowView
from crenel.messages.message import Text
from crenel.parts.compare.guide_view import CompareState
from crenel.parts.session.view import PartView
from crenel.station.activity import ArmUse
from crenel.station.control_lease import Control
from crenel.station.devices.rig import Devices, SensorChoice
from crenel.station.operator_settings import StationSettings
from crenel.station.view3d.view_controller import ViewState
from crenel.supervision.messages import StationReport
from crenel.supervision.notifications import Notice
from crenel.supervision.remote_stations import RemoteStation
from crenel.wire.library import LibraryState
from crenel.wire.schema import (
    DemonstrationState,
    Home,
    ReplayState,
    RequestBody,
    ScanStatus,
    StationInfo,
)
from crenel.wire.sign_in import CurrentUser


@dataclass(frozen=True)
class Topics:
    """The value of each topic by its name; a tab receives only the newest one of each."""

    control: Control
    activity: ArmUse
    demonstration: DemonstrationState
    devices: Devices
    sensors: SensorChoice
    flow: FlowView
    scan: ScanStatus
    settings: StationSettings
    replay: ReplayState
    home: Home
    arm: ArmView
    verify: VerifyView
    performance: PerformanceView
    parts: PartView
    view: ViewState
    library: LibraryState
    compare: CompareState
    stations: Sequence[RemoteStation]
    report: StationReport
    notice: Notice


@dataclass(frozen=True)
class HelloMessage:
    """The first message of a connection."""

    station: StationInfo
    you: CurrentUser | None
    type: Literal["hello"] = "hello"


@dataclass(frozen=True)
class EventMessage:
    """An event, shown as a notification on the screen or played as a sound."""

    id: int
    kind: str
    quality: Quality
    text: Text
    type: Literal["event"] = "event"


@dataclass(frozen=True)
class BeatMessage:
    """Nothing new; the connection is alive. The first follows the whole state of the station."""

    type: Literal["beat"] = "beat"


class PreviewRequest(RequestBody):
    type: Literal["preview"]
    on: bool


class StationsRequest(RequestBody):
    """Whether this tab shows other stations."""

    type: Literal["stations"]
    on: bool


class PreviewAck(RequestBody):
    type: Literal["preview_ack"]
    seq: int


class Heartbeat(RequestBody):
    """Sent every few seconds to keep control."""

    type: Literal["beat"]


LiveRequest = Annotated[
    PreviewRequest | PreviewAck | StationsRequest | Heartbeat, Field(discriminator="type")
]

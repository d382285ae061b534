"""Models of what the server sends and receives; the browser's types are generated from them."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

from crenel.findings import Finding, Quality
from crenel.gauges.plan.document import Kind
from crenel.gauges.plan.document_gauge import Shape
from crenel.gauges.quick.document import Result
from crenel.gauges.quick.evaluate_deviation_maps import MapFile
from crenel.gauges.quick.evaluate_study import StudyFile
from crenel.guide.calibration.preparation import PreparationStep
from crenel.guide.common import validity as due
from crenel.guide.common.view import FlowView, ResultPicture
from crenel.messages.message import Text
from crenel.station.scan import state as scan_state
from crenel.station.view3d.cloud_colouring import Measure
from crenel.station.view3d.elements.element_views import AskedElement
from crenel.station.view3d.viewpoints import Viewpoint


class RequestBody(BaseModel):
    """What a client sends: no field missing, no unknown field."""

    model_config = ConfigDict(extra="forbid", strict=True)


class FlowCommand(RequestBody):
    name: Annotated[str, Field(max_length=64)]
    args: dict[str, object]
    rev: int
    key: Annotated[str, Field(min_length=1, max_length=128)]


class ArmStart(RequestBody):
    purpose: Literal["check", "tip", "identify"]


class PerformanceStart(RequestBody):
    test: Kind = "sphere"


class ScanStart(RequestBody):
    name: Annotated[str, Field(max_length=120)] = ""


class ActivityEnd(RequestBody):
    id: Annotated[str, Field(max_length=32)]


class OnOff(RequestBody):
    on: bool


class Exposure(RequestBody):
    exposure_us: Annotated[float, Field(gt=0, allow_inf_nan=False, strict=False)]


class UploadedCertificate(RequestBody):
    """A digital certificate; ``name`` is that of its file."""

    name: Annotated[str, Field(max_length=200)]
    text: str


class UploadedProgram(RequestBody):
    """An inspection program; ``name`` is that of its file."""

    name: Annotated[str, Field(min_length=1, max_length=120)]
    text: Annotated[str, Field(max_length=2_000_000)]


class UploadedLogo(RequestBody):
    """A picture for reports, as a browser reads it: ``data:image/png;base64,...``"""

    data_url: Annotated[str, Field(max_length=256_000)]


@dataclass(frozen=True)
class ReportLogo:
    """The picture at the head of all reports."""

    data_url: str
    """Empty if there is none."""
    trouble: Text
    """Why the one in the data folder cannot be used."""
    largest_bytes: int
    """The size of the largest picture that is sent."""


class SensorName(RequestBody):
    name: Annotated[str, Field(max_length=40)]


class NewTemperature(RequestBody):
    celsius: Annotated[float, Field(ge=-20, le=60, allow_inf_nan=False, strict=False)]


class Rename(RequestBody):
    name: Annotated[str, Field(min_length=1, max_length=120)]


Limit = Annotated[float, Field(allow_inf_nan=False, strict=False)]
Share = Annotated[float, Field(ge=0, le=1, strict=False)]


class Colouring(RequestBody):
    measure: Measure
    low: Limit | None = None
    high: Limit | None = None


class ViewRectangle(RequestBody):
    """A rectangle in a page's 3D view, as shares of its size from the left and the top."""

    view: Annotated[str, Field(max_length=64)]
    left: Share
    top: Share
    right: Share
    bottom: Share


class Region(ViewRectangle):
    """The element that is fitted to what a rectangle shows."""

    shape: AskedElement


class ElementChange(RequestBody):
    """Another shape for an element."""

    shape: AskedElement


class ElementPair(RequestBody):
    """Two elements, by their numbers, between which is measured."""

    first: int
    second: int


class CutRegion(ViewRectangle):
    """What a rectangle shows is cut away, or what lies ``outside``."""

    outside: bool


class PageView(RequestBody):
    """The viewpoint of a page's 3D view."""

    view: Annotated[str, Field(max_length=64)]
    viewpoint: Viewpoint


@dataclass(frozen=True)
class ProblemMessages:
    """The texts of a problem as data, for translation."""

    detail: Text
    remedy: Text


@dataclass(frozen=True)
class Problem:
    """RFC 9457, with ``detail`` and ``remedy`` in English; ``view`` accompanies the 409 of a stale
    flow command."""

    type: str
    title: str
    status: int
    detail: str
    code: str
    remedy: str
    messages: ProblemMessages
    view: FlowView | None = None


@dataclass(frozen=True)
class ScanStatus(scan_state.ScanState):
    """The scan state of the station, and whether the simulated operator is moving."""

    simulation_running: bool


ReplayPhase = Literal["playing", "ended", "failed"]


@dataclass(frozen=True)
class ReplayState:
    """Progress of a replay, as the browser shows it."""

    recording: str
    speed: float
    """1: original speed; 0: as fast as the recording can be read."""
    played_s: float
    """In the recording's own time."""
    length_s: float | None
    """None for a recording that was cut off."""
    points: int
    points_shown: int
    state: ReplayPhase
    text: Text
    """The result, after it has ended."""


@dataclass(frozen=True)
class CalibrationSummary:
    id: str
    name: str
    accepted_at: str
    age_days: float
    total_um: float
    verdict: Quality
    active: bool
    arm_serial: str
    sensor_serial: str
    object_serial: str


@dataclass(frozen=True)
class ExportFormats:
    """Which formats for other programs the station can write."""

    xlsx_why_not: Text
    """What to install for it; empty: it can."""


@dataclass(frozen=True)
class StationInfo:
    name: str
    version: str
    has_simulation: bool
    simulated: bool


@dataclass(frozen=True)
class Home:
    station: StationInfo
    calibration: CalibrationSummary | None
    lacks_laser: bool
    """The calibration in use is one of camera and mounting alone."""
    checks: tuple[due.Validity, ...]
    preparation: tuple[PreparationStep, ...]
    """What the first calibration needs; empty once there has been one."""
    temperature_c: float | None
    """Room temperature, if it was entered or measured recently."""
    findings: tuple[Finding, ...]
    next: due.NextAction


@dataclass(frozen=True)
class DemonstrationState:
    """Where the simulated operator is, who does everything once."""

    running: bool = False
    page: due.Page = "home"
    """Where there is something to see."""
    text: Text = ""
    decides_in_s: int | None = None
    """Until it decides what a person would decide; None while nothing is decided."""


@dataclass(frozen=True)
class RecordedCalibration:
    """An accepted calibration; ``operator`` and ``station`` are empty if they were not recorded."""

    summary: CalibrationSummary
    operator: str
    station: str
    temperature_c: float | None
    picture: ResultPicture
    findings: Sequence[Finding]


@dataclass(frozen=True)
class CalibrationPoint:
    """One calibration of the history, and the changes since the previous one of the same arm and
    sensor (null for the first); ``expected_…`` is what their uncertainties explain if the sensor
    did not move, k = 2."""

    id: str
    name: str
    accepted_at: str
    total_um: float
    verdict: Quality
    good_um: float | None
    temperature_c: float | None
    arm_serial: str
    sensor_serial: str
    sensor_um: float | None
    sensor_arcsec: float | None
    plane_um: float | None
    plane_arcsec: float | None
    points_um: float | None
    expected_um: float | None
    expected_arcsec: float | None


@dataclass(frozen=True)
class VerificationSummary:
    id: str
    accepted_at: str
    calibration_id: str
    calibration: str
    """Name of the calibration."""
    result: Result
    text: Text
    shape: Shape
    gauge: str
    clouds: int
    touched: bool
    operator: str


@dataclass(frozen=True)
class InspectionSummary:
    """A finished inspection of a part as it appears in the list."""

    id: str
    ended_at: str
    result: Literal["pass", "fail", "undecided", "none"]
    text: Text
    program: str
    part: str
    serial_number: str
    passed: int
    failed: int
    undecided: int
    operator: str


@dataclass(frozen=True)
class PerformanceSummary:
    """A performance test as it appears in the list."""

    id: str
    ended_at: str
    kind: Kind
    result: Literal["pass", "fail", "uncertain", "cancelled"]
    text: Text
    artefact: str
    operator: str


@dataclass(frozen=True)
class CloudMap:
    """The map of one cloud of a verification, and the scale of all."""

    map: MapFile
    end_um: float
    """Where the scale of the colours ends on both sides."""


@dataclass(frozen=True)
class StudyState:
    """State of rebuilding the clouds with every calibration: running, done, or neither."""

    running: bool
    text: Text
    fraction: float | None
    accepted: int
    """Present number of calibrations."""
    study: StudyFile | None

"""What the server sends and takes; field for field the shapes of frontend/src/api/types.ts."""

from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

from app.guide.view import FlowView
from app.metrology.measured_shape import ShapeName
from app.metrology.stripe import Choice
from app.station import scanner
from app.station.findings import Finding, Quality
from app.station.painter import Measure

Page = Literal["calibrate", "scan", "records"]


class Request(BaseModel):
    """What a client sends: nothing missing, nothing beyond."""

    model_config = ConfigDict(extra="forbid", strict=True)


class FlowCommand(Request):
    name: Annotated[str, Field(max_length=64)]
    args: dict[str, object]
    rev: int
    key: Annotated[str, Field(min_length=1, max_length=128)]


class ArmStart(Request):
    purpose: Literal["check", "identify"]


class ScanStart(Request):
    name: Annotated[str, Field(max_length=120)] = ""


class Switch(Request):
    on: bool


class Exposure(Request):
    exposure_us: Annotated[float, Field(gt=0, allow_inf_nan=False, strict=False)]


class Rename(Request):
    name: Annotated[str, Field(min_length=1, max_length=120)]


Limit = Annotated[float, Field(allow_inf_nan=False, strict=False)]
Share = Annotated[float, Field(ge=0, le=1, strict=False)]


class Colouring(Request):
    measure: Measure
    low: Limit | None = None
    high: Limit | None = None


class Region(Request):
    """A rectangle of a page's 3D view, in shares of it from its left and its top."""

    view: Annotated[str, Field(max_length=64)]
    shape: ShapeName
    left: Share
    top: Share
    right: Share
    bottom: Share


class SettingsChange(Request):
    """The whole of the settings; null is automatic. Their ranges are the station's."""

    threshold: float | None
    min_width_px: float | None
    choice: Choice
    exposure_us: float | None
    zones: list[list[list[float]]]
    blur_limit_mm: float | None
    record_pictures: bool


class PreviewRequest(Request):
    type: Literal["preview"]
    on: bool


class PreviewAck(Request):
    type: Literal["preview_ack"]
    seq: int


LiveRequest = Annotated[PreviewRequest | PreviewAck, Field(discriminator="type")]


@dataclass(frozen=True)
class Problem:
    """RFC 9457; ``view`` comes with the 409 of a stale flow command."""

    type: str
    title: str
    status: int
    detail: str
    code: str
    remedy: str
    view: FlowView | None = None


@dataclass(frozen=True)
class ScanState(scanner.ScanState):
    """The station's scan state, and whether the twin's hand is at it."""

    hand_running: bool


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
class ScanSummary:
    id: str
    name: str
    started_at: str
    points: int
    frames: int
    seconds: float
    calibration_id: str


@dataclass(frozen=True)
class Station:
    name: str
    version: str
    has_hand: bool
    simulated: bool


@dataclass(frozen=True)
class NextStep:
    label: str
    page: Page
    text: str


@dataclass(frozen=True)
class Home:
    station: Station
    calibration: CalibrationSummary | None
    findings: tuple[Finding, ...]
    next: NextStep

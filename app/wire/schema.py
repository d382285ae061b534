"""What the server sends and takes; the browser's types are generated from it."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field

from app.findings import Finding, Quality
from app.formats.datasheets.gauge import Shape
from app.formats.results.verification import Result
from app.guide.common import validity as due
from app.guide.common.view import FlowView, ResultPicture
from app.messages.message import Text
from app.metrology.fitting.shape import ShapeName
from app.station.scan import state as scan_state
from app.station.view3d.cloud_colouring import Measure
from app.workflows.verification_study import StudyFile


class RequestBody(BaseModel):
    """What a client sends: nothing missing, nothing beyond."""

    model_config = ConfigDict(extra="forbid", strict=True)


FORMER_COMMANDS = {"let_hand": "run_simulation", "stop_hand": "stop_simulation"}
"""Commands by the names that they had; scripts may still send these."""


def _present_name(name: object) -> object:
    return FORMER_COMMANDS.get(name, name) if isinstance(name, str) else name


class FlowCommand(RequestBody):
    name: Annotated[str, Field(max_length=64), BeforeValidator(_present_name)]
    args: dict[str, object]
    rev: int
    key: Annotated[str, Field(min_length=1, max_length=128)]


class ArmStart(RequestBody):
    purpose: Literal["check", "tip", "identify"]


class ScanStart(RequestBody):
    name: Annotated[str, Field(max_length=120)] = ""


class OnOff(RequestBody):
    on: bool


class Exposure(RequestBody):
    exposure_us: Annotated[float, Field(gt=0, allow_inf_nan=False, strict=False)]


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


class Region(RequestBody):
    """A rectangle of a page's 3D view, in shares of it from its left and its top."""

    view: Annotated[str, Field(max_length=64)]
    shape: ShapeName
    left: Share
    top: Share
    right: Share
    bottom: Share


@dataclass(frozen=True)
class ProblemMessages:
    """The texts of a problem as data, for whoever puts them into another language."""

    detail: Text
    remedy: Text


@dataclass(frozen=True)
class Problem:
    """RFC 9457, ``detail`` and ``remedy`` in English; ``view`` comes with the 409 of a stale
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
    """The station's scan state, and whether the simulated operator moves."""

    simulation_running: bool


ReplayPhase = Literal["playing", "ended", "failed"]


@dataclass(frozen=True)
class ReplayState:
    """How far a replay is, as the browser shows it."""

    recording: str
    speed: float
    """1 as it was taken; 0 as fast as it can be read."""
    played_s: float
    """Of the recording's own time."""
    length_s: float | None
    """None for a recording that was cut off."""
    points: int
    points_shown: int
    state: ReplayPhase
    text: Text
    """What became of it, once it has ended."""


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
    name: Text
    started_at: str
    points: int
    frames: int
    seconds: float
    calibration_id: str
    note: Text
    """What is wrong with its recording, or why it ended early; mostly empty."""


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
    checks: tuple[due.Validity, ...]
    temperature_c: float | None
    """Of the room, where it was entered or measured lately."""
    findings: tuple[Finding, ...]
    next: due.NextAction


Secret = Annotated[str, Field(max_length=256)]
Name = Annotated[str, Field(max_length=80)]
RoleName = Literal["viewer", "operator", "admin"]


class SignIn(RequestBody):
    name: Name
    password: Secret


class SignInCode(RequestBody):
    code: Secret


class FirstAdmin(RequestBody):
    code: Secret
    name: Name
    password: Secret


class NewPassword(RequestBody):
    old: Secret
    new: Secret


class NewAccount(RequestBody):
    name: Name
    role: RoleName
    password: Secret


class AccountChange(RequestBody):
    """What is not given stays."""

    role: RoleName | None = None
    password: Secret | None = None


class NewAccessToken(RequestBody):
    name: Annotated[str, Field(min_length=1, max_length=60)]


class ControlReply(RequestBody):
    give: bool


class TakeoverReason(RequestBody):
    reason: Annotated[str, Field(max_length=200)] = ""


@dataclass(frozen=True)
class CurrentUser:
    """Who is signed in at this browser; ``id`` is the sign-in's, as in ``Control``."""

    id: str
    name: str
    role: RoleName
    kiosk: bool


@dataclass(frozen=True)
class SignInState:
    """``first_start``: the console's code makes the administrator; ``by_code``: it lets in."""

    station: str
    you: CurrentUser | None
    first_start: bool
    by_code: bool


@dataclass(frozen=True)
class AccountSummary:
    name: str
    role: RoleName
    made_at: str


@dataclass(frozen=True)
class AccessTokenSummary:
    """A kiosk link, or a token for the metrics; ``token`` only where it was made just now."""

    id: str
    name: str
    made_by: str
    made_at: str
    token: str | None = None


@dataclass(frozen=True)
class RecordedCalibration:
    """An accepted calibration; ``operator`` and ``station`` are empty where not written down."""

    summary: CalibrationSummary
    operator: str
    station: str
    temperature_c: float | None
    picture: ResultPicture
    findings: Sequence[Finding]


@dataclass(frozen=True)
class CalibrationPoint:
    """One calibration of the history, and what moved since the one before of the same arm and
    sensor (null for the first); ``expected_…`` is what their uncertainties let expect of a
    sensor that did not move, k = 2."""

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
    """Its name."""
    result: Result
    text: Text
    shape: Shape
    gauge: str
    clouds: int
    touched: bool
    operator: str


@dataclass(frozen=True)
class StudyState:
    """Of the clouds rebuilt with every calibration: under way, or done, or neither."""

    running: bool
    text: Text
    fraction: float | None
    accepted: int
    """How many calibrations there are by now."""
    study: StudyFile | None

"""What the browser is shown of an arm session."""

from collections.abc import Sequence
from dataclasses import dataclass, field

from crenel.findings import Quality
from crenel.gauges.quick.guide.view import TouchLine
from crenel.guide.arm.state import Artefact, Purpose
from crenel.guide.common.view import ChoiceOption, SessionView, Vec3
from crenel.messages.message import Text
from crenel.metrology.decision import Decision


@dataclass(frozen=True)
class JointSwing:
    """Range of one joint in this seat, and its limits."""

    name: str
    lowest_deg: float | None
    highest_deg: float | None
    now_deg: float | None
    limit_low_deg: float
    limit_high_deg: float


@dataclass(frozen=True)
class SeatLine:
    """One seat of the session."""

    name: Text
    points: int
    half_range_um: float
    """The largest of the three axes; of a sphere the largest distance from it."""
    note: Text = ""
    """What the length of a bar seems to be."""


@dataclass(frozen=True)
class BeforeAfter:
    """One figure before and after."""

    title: Text
    before_um: float
    after_um: float


@dataclass(frozen=True)
class ParameterLine:
    """One of the arm's parameters that the identification changed."""

    name: Text
    unit: str
    before: float
    after: float
    standard_uncertainty: float


@dataclass(frozen=True)
class FixedParameterLine:
    """Parameters that kept their values, and why."""

    names: Text
    why: Text


@dataclass(frozen=True)
class CorrelatedLine:
    """Two parameters that the places hardly distinguish."""

    first: Text
    second: Text
    coefficient: float


@dataclass(frozen=True)
class ArmResult:
    """The result of an identification."""

    volume_before_um: float
    volume_after_um: float
    size_known: bool
    """Whether a calibrated length fixed the arm's size."""
    places: int
    lines: Sequence[BeforeAfter]
    parameters: Sequence[ParameterLine]
    kept: Sequence[FixedParameterLine] = ()
    correlated: Sequence[CorrelatedLine] = ()


@dataclass(frozen=True)
class TipResult:
    """The result of a tip check."""

    diameter_mm: float
    expected_mm: float
    error_um: float
    expanded_uncertainty_um: float
    scatter_um: float
    bend_um: float | None
    limit_um: float | None
    decision: Decision
    error_decision: Decision | None = field(default=None, kw_only=True)
    """The decision on the diameter's error alone; None for older checks."""


@dataclass(frozen=True)
class ArmPicture:
    """The points of the current seat relative to their mean, and the motion of the arm."""

    tips_um: Sequence[Vec3]
    half_range_um: Vec3 | None
    two_sigma_um: Vec3 | None
    encoders_two_sigma_um: Vec3 | None
    limit_um: float | None
    joints: Sequence[JointSwing]
    seats: Sequence[SeatLine]
    result: ArmResult | None
    touches: Sequence[TouchLine] = ()
    """The touches of the sphere, as seen from above."""
    sphere_mm: float | None = None
    """Its radius."""
    tip: TipResult | None = None
    largest_um: float | None = None
    """Largest distance of a point from the mean of all, in space; of a seat alone."""
    two_s_um: float | None = None


@dataclass(frozen=True)
class ArmView(SessionView):
    """The whole state of the arm session."""

    purpose: Purpose
    arms: Sequence[ChoiceOption]
    arm: str
    artefact: Artefact
    """What the tip is put to next, in an identification."""
    coordinates: int
    """Number of points of a tracker or measuring machine that were uploaded."""
    picture: ArmPicture


@dataclass(frozen=True)
class ArmRecord:
    """One session of the history."""

    id: str
    at: str
    arm_name: str
    arm_serial: str


@dataclass(frozen=True)
class ArmCheckSummary(ArmRecord):
    """One check of the history."""

    points: int
    half_range_um: Vec3
    two_sigma_um: Vec3
    limit_um: float | None
    verdict: Quality
    largest_um: float | None = None
    """In space; None of older checks."""
    two_s_um: float | None = None


@dataclass(frozen=True)
class TipCheckSummary(ArmRecord, TipResult):
    """One check of the tip."""

    touches: int
    text: Text
    """What was found, in one sentence."""
    verdict: Quality


@dataclass(frozen=True)
class IdentificationSummary(ArmRecord):
    """One identification of the arm."""

    volume_before_um: float
    volume_after_um: float
    size_known: bool

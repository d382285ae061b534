"""What the browser is shown of a performance test."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from crenel.gauges.plan.document import Kind
from crenel.guide.common.view import ChoiceOption, SessionView
from crenel.messages.message import Text
from crenel.metrology.decision import Decision

PlaceState = Literal["free", "next", "done"]
PlaceProgress = Literal["todo", "now", "done"]
ArticulationState = Literal["todo", "now", "scanning", "measuring", "done", "refused"]


@dataclass(frozen=True)
class ArtefactOption(ChoiceOption):
    """A sphere, plate or length standard, or a certificate that describes none."""

    why_not: Text
    """Why it cannot be chosen; empty if it can."""


@dataclass(frozen=True)
class PerformanceLimitLine:
    """A limit that can be entered from a datasheet."""

    quantity: str
    symbol: str
    title: Text
    a_um: float | None
    k: float | None
    b_um: float | None
    grows: bool
    """Whether the limit may grow with the length: A + L/K, up to B."""


@dataclass(frozen=True)
class PlaceMark:
    """A place to touch, as seen along the pole in degrees from it: right, and away from the arm."""

    number: int
    right_deg: float
    away_deg: float
    state: PlaceState


@dataclass(frozen=True)
class PatchMark:
    """One of the 25 patches of the scans, where a ``PlaceMark`` would be. The scan that runs
    counts, too."""

    number: int
    right_deg: float
    away_deg: float
    points: int
    frames: int
    share: float
    """The share of the points and frames that it needs, up to 1."""
    covered: bool


@dataclass(frozen=True)
class ArticulationLine:
    """One of the five articulations."""

    number: int
    title: Text
    state: ArticulationState
    text: Text
    """What is known of it, or why it is of no use."""


@dataclass(frozen=True)
class StandardMark:
    """A place of a length standard or a seat, as it is proposed."""

    number: int
    state: PlaceProgress
    ends_mm: Sequence[tuple[float, float, float]]
    """The ends of the standard in the arm frame; for a seat both are its centre."""


@dataclass(frozen=True)
class LengthPlaceMark(StandardMark):
    """One of the seven places of a length standard."""

    title: Text
    done: int
    of: int
    """Lengths that are touched there."""
    scanned: int
    scans: int
    """The number of scans of the whole standard there."""


@dataclass(frozen=True)
class LengthErrorMark:
    """An error of length."""

    place: int
    repeat: int
    length_mm: float
    error_um: float
    limit_um: float | None


@dataclass(frozen=True)
class LengthLimitMark:
    """A length of the standard with the maximum permissible error of it."""

    length_mm: float
    limit_um: float | None


@dataclass(frozen=True)
class LengthErrorsPicture:
    """The errors of length by touch, or those by scan."""

    limits: Sequence[LengthLimitMark]
    errors: Sequence[LengthErrorMark]


@dataclass(frozen=True)
class BarScanLine(ArticulationLine):
    """A scan of a ball bar in its present place; its number is that of the repeat."""

    place: int
    length: int
    """The one whose spheres are scanned by themselves; 0: the whole bar."""
    repeatable: bool


@dataclass(frozen=True)
class LengthsPicture:
    """What is drawn of a length test."""

    reach_mm: float
    shoulder_mm: float
    """Height of the arm's shoulder over its base."""
    places: Sequence[LengthPlaceMark]
    touched: LengthErrorsPicture
    scanned: LengthErrorsPicture | None
    """None: the lengths are measured by touch alone."""
    scans: Sequence[BarScanLine]
    """The scans of the present place, once it is scanned."""


@dataclass(frozen=True)
class ContactPicture:
    """What is drawn of a contact test in its present step."""

    reach_mm: float
    shoulder_mm: float
    """Height of the arm's shoulder over its base."""
    places: Sequence[StandardMark]
    """The places of seats or bar; none for the sphere."""
    lines: Sequence[ArticulationLine]
    """The measurements of the sphere, the seats or the placements."""


@dataclass(frozen=True)
class PerformanceFigureLine:
    """One symbol with its value and its limit."""

    quantity: str
    symbol: str
    title: Text
    value: float | None
    values: Sequence[float | None]
    test_uncertainty: float | None
    limit: float | None
    decision: Decision
    reason: Text
    problem: Text


@dataclass(frozen=True)
class PerformanceResultView:
    """What the test found."""

    result: Literal["pass", "fail", "uncertain"]
    text: Text
    status: Text
    figures: Sequence[PerformanceFigureLine]
    offset: Text
    """The error of the probe matrix that the articulations imply; empty if none can be stated."""
    problems: Sequence[Text]
    notes: Sequence[Text]


@dataclass(frozen=True)
class PerformancePicture:
    """Everything that is drawn for a performance test."""

    limits: Sequence[PerformanceLimitLine]
    artefact_c: float | None
    """Temperature of the artefact at the beginning, at the end of the test that at its end; None:
    not measured."""
    arm_c: float | None
    """The same of the arm."""
    expanded_c: float
    """Uncertainty of the artefact's temperature, k = 2."""
    places: Sequence[PlaceMark]
    tip_deg: tuple[float, float] | None
    patches: Sequence[PatchMark]
    articulations: Sequence[ArticulationLine]
    lengths: LengthsPicture | None
    contact: ContactPicture | None
    result: PerformanceResultView | None


@dataclass(frozen=True)
class PerformanceView(SessionView):
    """The whole state of the performance test."""

    test: Kind
    calibration_id: str
    calibration: str
    """Name of the calibration with which it is scanned."""
    gauges: Sequence[ArtefactOption]
    gauge: str
    """The chosen one; of a contact test empty if it is done without a sphere."""
    bars: Sequence[ArtefactOption]
    """The bars of a contact test."""
    bar: str
    """The chosen one; empty if the test is done without."""
    positions: int
    by_scan: bool
    """Whether lengths are measured by scan, too."""
    why_no_scans: Text
    """Why the chosen standard cannot be scanned; empty if it can."""
    position: int
    frozen: bool
    """Whether the plan stands: limits and sphere can no longer be changed."""
    picture: PerformancePicture

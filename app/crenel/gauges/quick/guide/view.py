"""What the browser is shown of a verification."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from crenel.formats.results.decision_rule import RulePart
from crenel.gauges.plan.document_gauge import Shape
from crenel.gauges.quick.document import (
    FiltersPart,
    JudgedBy,
    Result,
    StatisticPart,
)
from crenel.gauges.quick.maths.figure_budget import Source, Statistic
from crenel.guide.common.view import SessionView
from crenel.messages.message import Text
from crenel.metrology.decision import Decision

CloudState = Literal["scanning", "measuring", "good", "refused", "aside"]


@dataclass(frozen=True)
class GaugeOption:
    """One of the gauges in the data folder."""

    id: str
    shape: Shape
    label: str
    detail: Text


@dataclass(frozen=True)
class TouchLine:
    """One contact point, as seen from above the gauge; without a position until the pose of the
    gauge is determined."""

    index: int
    x_mm: float | None
    y_mm: float | None
    residual_um: float | None
    is_outlier: bool = False
    """It contradicts the others, and is left out."""


@dataclass(frozen=True)
class CloudLine:
    """One cloud; the errors are relative to the probe, that of the radius relative to the
    nominal."""

    number: int
    state: CloudState
    text: Text
    """Why it is of no use, or what should be known of it."""
    points: int
    used: int
    rms_um: float | None = None
    form_um: float | None = None
    in_gate: int | None = None
    """Points within the geometric gate; None, like the next two, of older clouds."""
    form_all_um: float | None = None
    range_all_um: float | None = None
    angle_arcsec: float | None = None
    z_error_um: float | None = None
    offset_error_um: float | None = None
    radius_error_um: float | None = None
    centre_error_um: float | None = None
    map_url: str = ""


@dataclass(frozen=True)
class FigureLine:
    """One figure and its limit."""

    name: str
    title: Text
    unit: str
    value: float
    expanded_uncertainty: float
    """Measurement uncertainty, k = 2: twice the root of the sum of squares of the budget."""
    budget: Mapping[Source, float]
    """Standard uncertainties, k = 1; empty of older records."""
    test_uncertainty: float | None
    """Test value uncertainty, k = 1; None of older records."""
    judged_by: JudgedBy
    limit: float | None
    decision: Decision
    reason: Text
    clouds: Sequence[float]
    spread: Mapping[Statistic, StatisticPart]
    """Over several clouds."""


@dataclass(frozen=True)
class VerdictLine:
    result: Result
    text: Text


@dataclass(frozen=True)
class VerifyPicture:
    """Everything that is drawn for a verification."""

    shape: Shape | None
    radius_mm: float | None
    """The radius of the chosen sphere."""
    touches: Sequence[TouchLine]
    touch_rms_um: float | None
    scanning: bool
    clouds: Sequence[CloudLine]
    figures: Sequence[FigureLine]
    verdict: VerdictLine | None
    rule: RulePart
    filters: FiltersPart | None


@dataclass(frozen=True)
class VerifyView(SessionView):
    """The whole state of the verification."""

    calibration_id: str
    calibration: str
    """Name of the calibration that is verified."""
    gauges: Sequence[GaugeOption]
    gauge: str
    picture: VerifyPicture

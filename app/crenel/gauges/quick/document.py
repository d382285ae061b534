"""``verification.json``: what a verification of a calibration found, from what, and its verdict.

Its folder, ``verifications/<id>``, holds all that it was made from: ``calibration.json``,
``arm.json``, ``gauge.json``, ``touches.csv`` (as ``probing.csv``, feature ``gauge``; where the
gauge was touched), and ``cloud-<n>/scan.mcap`` for every cloud.
"""

from pathlib import Path
from typing import Annotated, ClassVar, Literal, Self

from pydantic import Field, model_validator

from crenel.formats.json_document import (
    Document,
    DocumentPart,
    NotNegative,
    Number,
    Positive,
    Software,
    Vector3,
)
from crenel.formats.results.calibration import Input, SerialNumbers
from crenel.formats.results.decision_rule import FORMER_CHECK_RULE, RulePart
from crenel.gauges.plan.document_gauge import Shape
from crenel.gauges.quick.maths.figure_budget import K, Source, Statistic, is_root
from crenel.messages.message import Text, message
from crenel.metrology.decision import Decision

JudgedBy = Literal["test", "measurement"]
"""Which uncertainty a figure's limit is judged by."""
Result = Literal["pass", "fail", "uncertain"]
FigureName = Literal[
    "rms",
    "form",
    "form_all",
    "range_all",
    "angle",
    "offset",
    "z_error",
    "radius_error",
    "centre_error",
    "angle_range",
    "offset_range",
    "centre_range",
]
FIGURE_TITLES: dict[FigureName, Text] = {
    "rms": message("scatter-points-rms"),
    "form": message("form-cloud-95-points"),
    "form_all": message("form-all-points-in-gate"),
    "range_all": message("range-all-points-in-gate"),
    "angle": message("angle-touched-plane"),
    "offset": message("distance-touched-plane"),
    "z_error": message("height-above-touched-plane-along-z"),
    "radius_error": message("error-radius"),
    "centre_error": message("distance-touched-centre"),
    "angle_range": message("angle-between-clouds"),
    "offset_range": message("distance-between-clouds"),
    "centre_range": message("distance-between-clouds-centres"),
}
"""In plain words."""

VERIFICATION, GAUGE, CONTACTS, STUDY = (
    "verification.json",
    "gauge.json",
    "touches.csv",
    "study.json",
)


class GaugePart(DocumentPart):
    """The gauge, from its nominal."""

    shape: Shape
    name: str
    serial_number: str = ""
    certificate: str = ""
    radius_mm: Positive | None = None
    standard_uncertainty_um: NotNegative = 0.0
    form_um: NotNegative = 0.0


class UsedCalibration(DocumentPart):
    """The calibration that was verified."""

    id: str
    name: str
    accepted_at: str
    total_um: NotNegative
    """Standard uncertainty of a scanned point by the calibration itself, k = 1."""


class PlacingPart(DocumentPart):
    """Pose of the gauge in the arm frame, from the contact points (``touches.csv``)."""

    touches: int
    rms_um: NotNegative
    """The rms of the touches about the gauge's shape."""
    point_mm: Vector3
    """On the plane in the touches' middle, or the sphere's centre."""
    normal: Vector3 | None = None
    """The normal of a plane, outward."""
    radius_mm: Positive | None = None
    """The radius of a sphere, as the touches alone have it."""
    standard_uncertainty_um: NotNegative
    """The standard uncertainty of the plane's height, or of the centre in its worst direction; k =
    1."""
    standard_uncertainty_arcsec: NotNegative | None = None
    """The standard uncertainty of a plane's normal in its worst direction, k = 1."""


class CloudPart(DocumentPart):
    """One cloud, rebuilt with the verified calibration, and the shape fitted to it."""

    name: str
    recording: str
    """Within the folder."""
    taken_at: str
    seconds: NotNegative
    frames: int
    points: int
    used: int
    """After the points that are none of the gauge, and the filter on the standard deviation
    (article, section 4)."""
    rms_um: NotNegative
    form_um: NotNegative
    """Width of the zone about the shape that holds 95 % of the points used."""
    in_gate: int | None = None
    """Points within the geometric gate, whatever their residual; None in older files."""
    form_all_um: NotNegative | None = None
    """Width of the zone that holds 95 % of these points."""
    range_all_um: NotNegative | None = None
    """Their largest minus smallest distance."""
    centre_mm: Vector3
    """The centre of the points used of a plane, or of the sphere."""
    normal: Vector3 | None = None
    offset_mm: Number | None = None
    radius_mm: Positive | None = None
    angle_arcsec: NotNegative | None = None
    """To the touched plane (Eq. 10)."""
    z_error_um: Number | None = None
    """Eq. 11-12."""
    offset_error_um: Number | None = None
    """The distance of the cloud's middle from the touched plane, along its normal."""
    radius_error_um: Number | None = None
    """Certificate minus measured, as in the article."""
    centre_error_um: NotNegative | None = None
    """From the touched sphere's centre."""


class BudgetedPart(DocumentPart):
    """A value with its uncertainty, and what this consists of."""

    value: Number
    expanded_uncertainty: NotNegative
    """k = 2: twice the root of the sum of squares of the budget."""
    budget: Annotated[dict[Source, NotNegative], Field(default_factory=dict)]
    """Standard uncertainties (k = 1) by their source; empty in older files."""

    @model_validator(mode="after")
    def _check_root(self) -> Self:
        if self.budget and not is_root(self.expanded_uncertainty, self.budget):
            raise ValueError(message("uncertainty-is-not-the-root-of-its-budget"))
        return self


class StatisticPart(BudgetedPart):
    """A statistic of a figure over several clouds."""


class FigurePart(BudgetedPart):
    """One figure and its limit."""

    name: FigureName
    title: Text
    unit: Literal["µm", "″"]
    value: Number
    """The worst of the clouds, with its sign; of ``…_range`` between the clouds."""
    expanded_uncertainty: NotNegative
    """Measurement uncertainty of the value by gauge, probe and points, k = 2."""
    test_uncertainty: NotNegative | None = None
    """Test value uncertainty by gauge and set-up, k = 1 (ISO 14253-5), which is the budget's part
    of the gauge; None in older files."""
    judged_by: JudgedBy = "measurement"
    limit: Positive | None = None
    """The limit of the absolute value."""
    decision: Decision
    reason: Text
    """One sentence."""
    clouds: tuple[Number, ...] = ()
    """The value of each cloud in turn; empty for ``…_range``."""
    spread: Annotated[dict[Statistic, StatisticPart], Field(default_factory=dict)]
    """Over two or more clouds; empty for ``…_range``, and in older files."""

    @property
    def judging_uncertainty(self) -> float:
        """The expanded uncertainty (k = 2) that the limit is judged by."""
        if self.judged_by == "test" and self.test_uncertainty is not None:
            return K * self.test_uncertainty
        return self.expanded_uncertainty


class FiltersPart(DocumentPart):
    """What chose the points of the figures."""

    sigmas: Positive
    """Points that are further off the fit, in standard deviations, are not used."""
    same_place_mm: Positive
    """How near together frames are of which only the first is used."""
    gate_mm: Positive
    """The gate of all points: distance from the calibrated sphere, or from the plane over the
    scanned area."""
    gate_deg: Positive | None = None
    """The gate of a sphere, from the direction that the scan faces."""


class VerificationVerdict(DocumentPart):
    """``fail`` if any figure fails, otherwise ``uncertain`` if any is uncertain, otherwise
    ``pass``."""

    result: Result
    text: Text
    """One sentence."""
    reasons: tuple[Text, ...]
    """The figures' own sentences, the worst first."""


class TemperaturePart(DocumentPart):
    """Temperatures, if known."""

    start_c: Number | None = None
    end_c: Number | None = None


class VerificationFile(Document):
    """The record of an accepted verification."""

    FORMAT: ClassVar[str] = "crenel/verification"

    id: str
    station: str
    simulated: bool = False
    """Made on simulated hardware."""
    operator: str
    """Who accepted it."""
    started_at: str
    accepted_at: str
    gauge: GaugePart
    serial_numbers: SerialNumbers
    """The serial numbers of arm and sensor, and of the object that they were calibrated with."""
    calibration: UsedCalibration
    placing: PlacingPart | None = None
    """None where the gauge was not touched: then only its shape and size are judged."""
    clouds: Annotated[tuple[CloudPart, ...], Field(min_length=1)]
    k: Literal[2] = 2
    """The coverage factor of every ``expanded_uncertainty``."""
    rule: RulePart = FORMER_CHECK_RULE
    filters: FiltersPart | None = None
    """None in older files."""
    figures: tuple[FigurePart, ...]
    verdict: VerificationVerdict
    notes: tuple[Text, ...] = ()
    """What else should be known, one sentence each."""
    temperature: TemperaturePart = TemperaturePart()
    inputs: tuple[Input, ...]
    """Files of the folder that all this follows from."""
    software: Software


def write_verification(folder: Path, document: VerificationFile) -> Path:
    """Writes the record into the verification's folder; raises ``OperationError``."""
    path = folder / VERIFICATION
    document.write(path)
    return path


def read_verification(folder: Path) -> VerificationFile:
    """The record in a verification's folder; raises ``OperationError`` where it cannot be read."""
    return VerificationFile.read(folder / VERIFICATION)

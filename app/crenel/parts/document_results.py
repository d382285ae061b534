"""``results.json``: what an inspection found, how sure it is, and what it decided."""

from typing import ClassVar, Literal

from crenel.formats.json_document import (
    Document,
    DocumentPart,
    Matrix4,
    NotNegative,
    Number,
    Software,
    Vector3,
)
from crenel.formats.results.calibration import Input
from crenel.formats.results.decision_rule import RulePart
from crenel.messages.message import Text

RESULTS, ALIGNMENT = "results.json", "alignment.json"
Outcome = Literal["pass", "fail", "undecided", "none"]
ExclusionRule = Literal["outlier", "edge", "incidence", "wrong-side", "other-feature"]


class ExclusionPart(DocumentPart):
    """How many points were left out by a rule."""

    rule: ExclusionRule
    count: int


class FeatureResult(DocumentPart):
    """One feature by one means, in the part frame."""

    id: str
    kind: str
    source: Literal["scan", "touch"]
    parameters: dict[str, Number | Vector3]
    free: tuple[str, ...]
    """What the covariance belongs to: motions in the feature's own frame, and sizes."""
    covariance: tuple[tuple[Number, ...], ...] | None = None
    """None where only the scatter is known."""
    points: int
    used: int
    frames: int
    cells: int
    rms_um: NotNegative
    form_um: NotNegative
    """The range of the means of the cells."""
    excluded: tuple[ExclusionPart, ...] = ()


class DimensionResult(DocumentPart):
    """One dimension; limits are deviations from the nominal, as in the program."""

    id: str
    kind: str
    value: Number
    nominal: Number
    lower: Number | None = None
    upper: Number | None = None
    unit: str
    standard_uncertainty: NotNegative | None = None
    """k = 1, in the unit; None where only the scatter is known."""
    scatter: NotNegative | None = None
    """What the points alone scatter by: no uncertainty."""
    decision: Outcome
    probability: Number | None = None
    """That it conforms."""
    vector: tuple[Number, ...] | None = None
    """Whose length the value is, or half of it; mm."""
    by_chance: NotNegative | None = None
    """What value chance alone would show where the true one is zero."""
    contributions: dict[str, NotNegative]
    """Standard uncertainties by source, in the unit; their squares add up."""


class PlaceResult(DocumentPart):
    """How well the part frame is known at a feature."""

    feature: str
    point_mm: Vector3
    u_um: NotNegative


class AlignmentResult(DocumentPart):
    """The part frame."""

    T_arm_part: Matrix4
    covariance: tuple[tuple[Number, ...], ...] | None = None
    """(6, 6) of a left perturbation (rad, mm) about ``pivot_mm``, in the part frame."""
    pivot_mm: Vector3
    known_at: tuple[PlaceResult, ...] = ()


class AlignmentFile(Document):
    """``alignment.json``: the part frame alone."""

    FORMAT: ClassVar[str] = "crenel/alignment"

    program: str = ""
    inputs: tuple[Input, ...] = ()
    alignment: AlignmentResult
    warnings: tuple[Text, ...] = ()
    software: Software | None = None


class InspectionFile(Document):
    """The file."""

    FORMAT: ClassVar[str] = "crenel/inspection"

    program: str = ""
    part: str = ""
    inputs: tuple[Input, ...] = ()
    uncertainty: Literal["full", "scatter"]
    """``scatter``: no covariance was given, and nothing is decided."""
    correlation_unknown: bool = False
    """Errors of sensor and arm were taken as independent."""
    alignment: AlignmentResult | None = None
    features: tuple[FeatureResult, ...]
    dimensions: tuple[DimensionResult, ...]
    correlation: tuple[tuple[Number, ...], ...] | None = None
    """Of all dimensions, in their order."""
    rule: RulePart
    warnings: tuple[Text, ...] = ()
    software: Software | None = None

    @property
    def verdict(self) -> Outcome:
        """The word for all dimensions together."""
        words = [one.decision for one in self.dimensions]
        for word in ("fail", "undecided"):
            if word in words:
                return word
        return "pass" if "pass" in words else "none"

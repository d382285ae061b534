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


Parameters = dict[str, Number | Vector3]
"""A feature in the words of a program's nominals."""


class ExclusionPart(DocumentPart):
    """How many points were left out by a rule."""

    rule: ExclusionRule
    count: int


class FeatureResult(DocumentPart):
    """One feature by one means, in the part frame."""

    id: str
    kind: str
    source: Literal["scan", "touch"]
    parameters: Parameters
    nominal: Parameters | None = None
    """The same as the drawing has it."""
    internal: bool = False
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
    features: tuple[str, ...] = ()
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
    datums: tuple[str, ...] = ()
    """The features that the frame follows from."""
    far_corner: PlaceResult | None = None
    """The corner of the part where the frame is known least; its ``feature`` is empty."""

    @property
    def at_datums_um(self) -> float | None:
        """What the frame is known to at the worst of its datums, k = 1; None if it is unknown."""
        return max((one.u_um for one in self.known_at if one.feature in self.datums), default=None)


class AlignmentFile(Document):
    """``alignment.json``: the part frame alone."""

    FORMAT: ClassVar[str] = "crenel/alignment"

    program: str = ""
    inputs: tuple[Input, ...] = ()
    alignment: AlignmentResult
    warnings: tuple[Text, ...] = ()
    software: Software | None = None


class MapDecisionPart(DocumentPart):
    """What the cells of the map of deviations were decided as."""

    cells: int
    inside: int
    outside: int
    undecided: int
    lower_mm: Number
    upper_mm: Number
    probability: Number | None = None
    """That the whole surface is within the limits."""
    decision: Outcome


class InspectionFile(Document):
    """The file."""

    FORMAT: ClassVar[str] = "crenel/inspection"

    program: str = ""
    part: str = ""
    drawing: str = ""
    serial_number: str = ""
    measured_at: str = ""
    """When the first recording began, ISO 8601; empty where none says it."""
    temperature_c: Number | None = None
    """Of the part; None: lengths are those at the temperature that it had, else at 20 °C."""
    inputs: tuple[Input, ...] = ()
    uncertainty: Literal["full", "scatter"]
    """``scatter``: no covariance was given, and nothing is decided."""
    correlation_unknown: bool = False
    """Errors of sensor and arm were taken as independent."""
    alignment: AlignmentResult | None = None
    features: tuple[FeatureResult, ...]
    dimensions: tuple[DimensionResult, ...]
    not_measured: tuple[str, ...] = ()
    """Dimensions of features that were skipped."""
    correlation: tuple[tuple[Number, ...], ...] | None = None
    """Of all dimensions, in their order."""
    map: MapDecisionPart | None = None
    rule: RulePart
    warnings: tuple[Text, ...] = ()
    software: Software | None = None

    def count(self, decision: Outcome) -> int:
        """How many dimensions were decided so."""
        return sum(one.decision == decision for one in self.dimensions)

    @property
    def verdict(self) -> Outcome:
        """The word for all dimensions and the map together."""
        words = [one.decision for one in self.dimensions]
        words += [] if self.map is None else [self.map.decision]
        for word in ("fail", "undecided"):
            if word in words:
                return word
        if self.not_measured:
            return "undecided"
        return "pass" if "pass" in words else "none"

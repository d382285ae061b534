"""``performance.json``: what a performance test found, each figure with its limit and its data."""

from pathlib import Path
from typing import Annotated, ClassVar, Literal

from pydantic import Field

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
from crenel.formats.results.decision_rule import RulePart
from crenel.gauges.plan.document import (
    RESULT,
    GatePart,
    Kind,
    PlatePart,
    SpherePart,
    TemperatureLimitsPart,
)
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.gauges.plan.document_symbols import Quantity
from crenel.messages.message import Text
from crenel.metrology.decision import Decision


class PerformanceFigure(DocumentPart):
    """One symbol's value."""

    quantity: Quantity
    symbol: str
    title: Text
    unit: Literal["µm"] = "µm"
    value: Number | None = None
    """The worse of the positions; None if it cannot be stated, see ``problem``."""
    values: tuple[Number | None, ...] = ()
    """The values at each position, seat or placement."""
    test_uncertainty: NotNegative | None = None
    """The uncertainty of artefact and set-up, expanded, k = 2."""
    limit: Positive | None = None
    """The maximum permissible error of the value."""
    limits: tuple[Positive, ...] = ()
    """The limit of each of ``values``, where it depends on the length."""
    decision: Decision
    reason: Text
    """One sentence."""
    problem: Text = ""
    """Why no value is stated."""
    data: tuple[str, ...] = ()
    """Groups of touches and scans of the folder that it was computed from."""


class PatchPart(DocumentPart):
    """Coverage of one of the 25 patches by a scan."""

    points: int
    frames: int
    deviation_um: Number | None = None
    """The deviation of its representative point from the least-squares sphere of all 25,
    outward."""


class SphereMeasurement(DocumentPart):
    """What was found at one position of the sphere."""

    position: int
    touched_centre_mm: Vector3 | None = None
    end_centre_mm: Vector3 | None = None
    """By the touches at the end."""
    moved_um: NotNegative | None = None
    """Between both."""
    touch_deviations_um: tuple[Number | None, ...] = ()
    """The deviations of the 25 touches, by place of the pattern, from their least-squares sphere,
    outward; None for a place without a touch."""
    tactile_centres_mm: tuple[Vector3, ...] = ()
    """The centres of the articulations by touch, with a free diameter."""
    stylus_directions: tuple[Vector3, ...] = ()
    """Unit, from the tip to the wrist, arm frame: mean of each articulation by touch."""
    view_directions: tuple[Vector3, ...] = ()
    """Unit, from the sphere to the camera, arm frame: mean of each articulation by scan."""
    scan_centres_mm: tuple[Vector3, ...] = ()
    """The centres of the articulations by scan, with a free diameter."""
    fixed_centres_mm: tuple[Vector3, ...] = ()
    """The centres of the articulations by scan, with the calibrated diameter."""
    location_fixed_um: NotNegative | None = None
    """L_Dia of these."""
    scanned_centre_mm: Vector3 | None = None
    """The centre of the least-squares sphere of all points."""
    points: int = 0
    """All points within the gate."""
    points_outside: int = 0
    """Points of the scans that the gate excludes."""
    patches: tuple[PatchPart, ...] = ()
    free_dispersion_um: NotNegative | None = None
    """D95 with a free centre."""


class ImpliedOffsetPart(DocumentPart):
    """The error of the probe matrix that the location error implies."""

    offset_mm: Vector3
    """In the sensor's frame: there the sensor really is."""
    standard_uncertainty_mm: Vector3
    significant: bool
    left_um: NotNegative
    """L_Dia that would remain."""
    text: Text


class LengthPoint(DocumentPart):
    """One of the measured lengths."""

    by: Literal["touch", "scan"] = "touch"
    place: int
    repeat: int
    length_mm: Positive
    measured_mm: Positive
    error_um: Number
    test_uncertainty_um: NotNegative
    """Expanded, k = 2."""
    limit_um: Positive | None = None


class TemperaturesPart(DocumentPart):
    """Temperatures at the beginning and at the end; None where none was measured."""

    artefact_c: tuple[Number | None, Number | None]
    artefact_sd_c: NotNegative
    """Standard uncertainty of a reading."""
    arm_c: tuple[Number | None, Number | None]
    limits: TemperatureLimitsPart
    steady: bool | None = None
    """Whether both kept the limits; None: not known."""


class PerformanceVerdict(DocumentPart):
    """As bad as the worst figure."""

    result: Literal["pass", "fail", "uncertain"]
    text: Text


class PerformanceFile(Document):
    """The result."""

    FORMAT: ClassVar[str] = "crenel/performance"

    id: str
    kind: Kind
    station: str = ""
    operator: str = ""
    simulated: bool = False
    started_at: str
    ended_at: str
    edition: str
    standards: tuple[str, ...]
    status: Text = ""
    """That no conformity with the standards is claimed; empty if the laboratory holds them."""
    sphere: SpherePart | None = None
    length: LengthStandardFile | None = None
    plate: PlatePart | None = None
    serial_numbers: SerialNumbers
    gate: GatePart
    rule: RulePart
    k: Literal[2] = 2
    figures: tuple[PerformanceFigure, ...]
    spheres: tuple[SphereMeasurement, ...] = ()
    offset: ImpliedOffsetPart | None = None
    lengths: tuple[LengthPoint, ...] = ()
    verdict: PerformanceVerdict
    problems: tuple[Text, ...] = ()
    """Why figures are missing or not decided, one sentence each."""
    notes: tuple[Text, ...] = ()
    """Filters and what else should be known, one sentence each."""
    temperature_c: tuple[Number | None, Number | None] = (None, None)
    """The temperature of the room, at the beginning and at the end."""
    temperatures: TemperaturesPart | None = None
    """The temperatures of artefact and arm; None if none was measured."""
    inputs: Annotated[tuple[Input, ...], Field(min_length=1)]
    software: Software


def read_performance(folder: Path) -> PerformanceFile:
    """The result in the folder of a test; raises ``OperationError``."""
    return PerformanceFile.read(folder / RESULT)

"""``plan.json``: what a performance test measures, by which limits; frozen at its first point.

The folder of a test, ``performance/<id>``, holds ``plan.json``, the ``arm.json`` and
``calibration.json`` in use, ``touches.csv`` (as ``probing.csv``; the feature names the touch's
part of the test, see ``sphere_feature``), ``<scan>/scan.mcap`` for every scan, and optionally
``end_temperatures.json``.
"""

from collections import Counter
from pathlib import Path
from typing import Annotated, ClassVar, Literal

from pydantic import Field, field_validator

from crenel.errors import OperationError
from crenel.formats.json_document import (
    CertifiedUm,
    Document,
    DocumentPart,
    NotNegative,
    Number,
    Positive,
    Vector3,
)
from crenel.formats.results.decision_rule import RulePart
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.gauges.plan.document_symbols import DEFAULT_EDITION, Quantity
from crenel.gauges.plan.maths_gate import CONE_DEG, INCIDENCE_DEG, SHELL_MM, SphereGate
from crenel.gauges.plan.maths_lengths import PermissibleError
from crenel.gauges.plan.maths_temperature import TemperatureLimits
from crenel.messages.message import message

PLAN, RESULT, TOUCHES = "plan.json", "performance.json", "touches.csv"
ARTICULATIONS, LOCATION_TOUCHES, PATTERN_TOUCHES = 5, 5, 25
ORIENTATIONS = 2
"""In which a plate is scanned."""
Kind = Literal["sphere", "lengths", "plane", "contact"]


class LimitPart(DocumentPart):
    """A maximum permissible error: ``A``, or ``A + L/K`` up to ``B``."""

    quantity: Quantity
    a_um: Positive
    k: Positive | None = None
    b_um: Positive | None = None

    @property
    def error(self) -> PermissibleError:
        return PermissibleError(self.a_um, self.k, self.b_um)


class GatePart(DocumentPart):
    """Which points of a scan take part, fixed before the test."""

    shell_mm: Positive = SHELL_MM
    incidence_deg: Annotated[Positive, Field(le=90)] = INCIDENCE_DEG
    cone_deg: Annotated[Positive, Field(le=180)] = CONE_DEG
    pole: Vector3 = (0.0, 0.0, 1.0)
    """Away from the artefact's holder, arm frame."""

    @property
    def gate(self) -> SphereGate:
        return SphereGate(self.shell_mm, self.incidence_deg, self.cone_deg)


class TemperatureLimitsPart(DocumentPart):
    """How steady artefact and arm have to be for a decision."""

    change_c: Positive = TemperatureLimits.change_c
    from_20_c: Positive = TemperatureLimits.from_20_c

    @property
    def limits(self) -> TemperatureLimits:
        return TemperatureLimits(self.change_c, self.from_20_c)


class SpherePart(DocumentPart):
    """The test sphere by its certificate; standard uncertainties, k = 1."""

    name: str
    serial_number: str = ""
    certificate: str = ""
    valid_until: str = ""
    """ISO 8601 date; empty: not stated."""
    diameter_mm: Positive
    diameter_sd_um: CertifiedUm
    form_um: CertifiedUm
    form_sd_um: CertifiedUm = 0.0
    expansion_per_c: NotNegative = 0.0
    expansion_sd_per_c: NotNegative = 0.0


class PlatePart(DocumentPart):
    """The flat artefact by its certificate."""

    name: str
    serial_number: str = ""
    certificate: str = ""
    valid_until: str = ""
    width_mm: Positive | None = None
    """Its narrower side; None: not stated."""
    flatness_um: CertifiedUm
    flatness_sd_um: CertifiedUm = 0.0


class PerformancePlan(Document):
    """The plan."""

    FORMAT: ClassVar[str] = "crenel/performance-plan"

    id: str
    kind: Kind
    station: str = ""
    operator: str = ""
    simulated: bool = False
    started_at: str
    edition: str = DEFAULT_EDITION
    standards_at_hand: bool = False
    """The laboratory holds the standards' documents: the status line is not printed."""
    sphere: SpherePart | None = None
    length: LengthStandardFile | None = None
    plate: PlatePart | None = None
    by_scan: bool = False
    """A test of lengths has scans of the ball bar in every place, too."""
    positions: Annotated[int, Field(ge=1, le=2)] = 1
    """Positions of the sphere within the reach; the standard takes two."""
    seats: Annotated[int, Field(ge=0, le=3)] = 0
    """The seats of the contact test."""
    gate: GatePart = GatePart()
    limits: tuple[LimitPart, ...] = ()
    rule: RulePart = RulePart()
    artefact_c: Number | None = None
    """Temperature of the artefact at the beginning; None: not measured. That at the end is in
    ``end_temperatures.json``; without either, 20 °C."""
    temperature_sd_c: NotNegative = 0.0
    """Standard uncertainty of the artefact's temperature."""
    arm_c: Number | None = None
    """Temperature of the arm at the beginning; None: not measured."""
    temperature_limits: TemperatureLimitsPart = TemperatureLimitsPart()

    @field_validator("limits")
    @classmethod
    def _limits_differ(cls, limits: tuple[LimitPart, ...]) -> tuple[LimitPart, ...]:
        counts = Counter(limit.quantity for limit in limits)
        for twice in (one for one, count in counts.items() if count > 1):
            raise ValueError(message("performance-limit-twice", quantity=twice))
        return limits

    def limit(self, quantity: Quantity) -> PermissibleError | None:
        """The limit of a quantity; None without one."""
        found = next((one for one in self.limits if one.quantity == quantity), None)
        return None if found is None else found.error


def sphere_feature(
    position: int, part: Literal["pattern", "location", "end"], number: int = 0
) -> str:
    """The name of a group of touches.

    Example:
        >>> sphere_feature(1, "pattern"), sphere_feature(1, "location", 3), sphere_feature(2, "end")
        ('p1-pattern', 'p1-location-3', 'p2-end')
    """
    return f"p{position}-{part}" + (f"-{number}" if part == "location" else "")


def location_features(position: int) -> list[str]:
    """The groups of touches of the location test, one for each articulation."""
    return [sphere_feature(position, "location", number + 1) for number in range(ARTICULATIONS)]


def sphere_features(positions: int) -> list[str]:
    """All groups of touches of the one-sphere test, in their order."""
    found = []
    for position in range(1, positions + 1):
        found.append(sphere_feature(position, "pattern"))
        found += location_features(position)
        found.append(sphere_feature(position, "end"))
    return found


def sphere_scan(position: int, articulation: int) -> str:
    """The folder of a scan of the one-sphere test.

    Example:
        >>> sphere_scan(1, 5)
        'p1-a5'
    """
    return f"p{position}-a{articulation}"


def length_feature(place: int, repeat: int, length: int, end: int) -> str:
    """The name of the touches on one end of a length.

    Example:
        >>> length_feature(2, 1, 3, 0)
        'l2-1-3-0'
    """
    return f"l{place}-{repeat}-{length}-{end}"


def length_scan(place: int, repeat: int, length: int = 0) -> str:
    """The folder of a scan of a ball bar: of the whole bar, or of the spheres of one length.

    Example:
        >>> length_scan(2, 1), length_scan(2, 1, 3)
        ('l2-1', 'l2-1-3')
    """
    return f"l{place}-{repeat}" + (f"-{length}" if length else "")


def plane_scan(orientation: int) -> str:
    """The folder of a scan of the plate.

    Example:
        >>> plane_scan(1)
        'plane-1'
    """
    return f"plane-{orientation}"


def read_plan(folder: Path) -> PerformancePlan:
    """The plan in the folder of a test; raises ``OperationError``."""
    return PerformancePlan.read(folder / PLAN)


STATION_LIMITS = "performance_limits.json"


class StationLimits(Document):
    """Limits as they were entered last."""

    FORMAT: ClassVar[str] = "crenel/performance-limits"

    limits: tuple[LimitPart, ...] = ()


def read_station_limits(data_folder: Path) -> tuple[LimitPart, ...]:
    """The limits of the last test; none before the first, or if they cannot be read."""
    try:
        return StationLimits.read(data_folder / STATION_LIMITS).limits
    except OperationError:
        return ()


def write_station_limits(data_folder: Path, limits: tuple[LimitPart, ...]) -> None:
    """Raises ``OperationError`` if they cannot be written."""
    StationLimits(limits=limits).write(data_folder / STATION_LIMITS)

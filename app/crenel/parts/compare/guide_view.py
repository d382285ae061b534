"""What browsers show of parts and of the comparison with them."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from crenel.messages.message import Text
from crenel.parts.compare.document_comparison import ComparisonFile
from crenel.parts.compare.document_part import KeptPart

MapMode = Literal["deviation", "significance", "uncertainty"]
Help = Literal[
    "more-passes", "other-postures", "calibrate", "identify-arm", "scan-more", "finer-facets"
]


@dataclass(frozen=True)
class KeptPartView:
    """A part that is kept."""

    id: str
    name: str
    form: str
    has_unit: bool
    """Whether its file states its unit; else the unit is asked for."""
    unit: str
    """As stated for it before; empty: not yet."""
    size: tuple[float, float, float]
    """Along its axes; in mm if it has its unit, else in its unit."""
    triangles: int
    is_closed: bool
    bodies: int
    body: int | None
    locked: tuple[str, ...]
    lower_mm: float | None
    upper_mm: float | None
    """The tolerance of the last comparison."""
    notes: tuple[Text, ...]


@dataclass(frozen=True)
class ReadingPart:
    """A file that arrives or is read."""

    name: str
    share: float
    """0 to 1, of what is under way."""
    is_sent: bool
    """Whether all of it has arrived."""


@dataclass(frozen=True)
class Refused:
    """The last file or comparison that was refused."""

    name: Text
    text: Text


@dataclass(frozen=True)
class RunningComparison:
    """The comparison that is computed."""

    scan: str
    part: str
    text: Text
    share: float
    is_cancelled: bool


@dataclass(frozen=True)
class MapLegend:
    """What the colours of the map mean; in significance, they have names instead of a scale."""

    mode: MapMode
    low_um: float
    high_um: float
    colours: tuple[str, ...]
    """Evenly spaced from low to high; none in significance."""
    square_mm: float
    """Edge of what is drawn as one square: larger than a cell where there are very many."""


@dataclass(frozen=True)
class ShownMap:
    """The map in the 3D view."""

    result: ComparisonFile
    legend: MapLegend


@dataclass(frozen=True)
class CompareState:
    """Parts, what is read or computed, and the map in the view."""

    parts: tuple[KeptPartView, ...] = ()
    """The newest first."""
    reading: ReadingPart | None = None
    refused: Refused | None = None
    running: RunningComparison | None = None
    shown: ShownMap | None = None
    made: int = 0
    """Increases when a comparison was made or removed."""


@dataclass(frozen=True)
class PlaceOnMap:
    """What is known of a place of the map; ``state`` says whether there is a cell."""

    state: Literal["cell", "not-scanned", "nothing"]
    x_mm: float = 0.0
    y_mm: float = 0.0
    z_mm: float = 0.0
    """Part frame."""
    deviation_um: float = 0.0
    standard_uncertainty_um: float | None = None
    scatter_um: float = 0.0
    decision: Literal["in", "out", "undecided"] = "undecided"
    points: int = 0
    frames: int = 0
    chord_um: float = 0.0
    budget_um: Mapping[str, float] = field(default_factory=dict)
    """Standard uncertainty by source; negative where the errors of a source make others smaller."""
    help: Help | None = None
    """What would help most: against the largest share."""


def view_of(part_id: str, part: KeptPart) -> KeptPartView:
    """A part as the browser shows it."""
    return KeptPartView(
        id=part_id,
        name=part.name,
        form=part.form,
        has_unit=part.has_unit,
        unit=part.unit,
        size=part.size,
        triangles=part.triangles,
        is_closed=part.is_closed,
        bodies=part.bodies,
        body=part.body,
        locked=part.locked,
        lower_mm=part.lower_mm,
        upper_mm=part.upper_mm,
        notes=part.notes,
    )

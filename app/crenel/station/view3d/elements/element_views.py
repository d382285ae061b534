"""Elements fitted in the 3D view, and dimensions between them, as the operator reads them."""

from dataclasses import dataclass
from typing import Literal

from crenel.messages.message import Text

ElementName = Literal["plane", "cylinder", "sphere", "cone"]
AskedElement = Literal["any", "plane", "cylinder", "sphere", "cone"]
"""What is looked for; ``any``: the likeliest."""
COVERAGE = 2.0
"""U is so many standard uncertainties."""


@dataclass(frozen=True)
class UncertaintyShare:
    """What one source has of an uncertainty; the squares of all add up to that of the whole."""

    source: Text
    expanded: float


@dataclass(frozen=True)
class ShapeParameter:
    """A value in ``unit``, with what is known of it in the same unit."""

    label: Text
    value: float
    unit: str
    decimals: int
    expanded: float | None = None
    """U with k = 2; None if only the scatter is known, or nothing."""
    scatter: float | None = None
    """The scatter of the scan alone, k = 1. It is no uncertainty: errors of the calibration and of
    the arm are the same in all points."""
    shares: tuple[UncertaintyShare, ...] = ()
    """Of ``expanded``, the largest first."""
    by_chance: float | None = None
    """What chance alone would show of a value near zero."""


@dataclass(frozen=True)
class FittedShape:
    """An element."""

    id: int
    shape: ElementName
    second: ElementName | None
    """What else it may be, where the shape was not given."""
    points: int
    """Number of points that the fit used."""
    picked: int
    """Number of points under the rectangle, from which the fitted ones were evenly selected."""
    other_surfaces: int
    """Points that lie on other surfaces; like the next two, not used."""
    at_edges: int
    outliers: int
    every: bool
    """From all points of the scans, and not only from those that are shown."""
    rms_um: float
    largest_um: float
    form_um: float
    figures: tuple[ShapeParameter, ...]
    why_scatter: Text
    """Why there is no uncertainty; empty if there is one."""


@dataclass(frozen=True)
class ElementRelation:
    """The dimensions between two elements, the most important first."""

    id: int
    first: int
    second: int
    figures: tuple[ShapeParameter, ...]
    why_scatter: Text


@dataclass(frozen=True)
class ElementsView:
    """All of them, the oldest first."""

    fits: tuple[FittedShape, ...] = ()
    relations: tuple[ElementRelation, ...] = ()
    can_undo: bool = False
    """Whether there is a change that can be taken back."""

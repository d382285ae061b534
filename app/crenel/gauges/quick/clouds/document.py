"""What a check of gauges found, as a file."""

from typing import Annotated, ClassVar, Literal, Self

from pydantic import Field, model_validator

from crenel.formats.json_document import (
    Document,
    DocumentPart,
    NotNegative,
    Number,
    Positive,
    Vector3,
)
from crenel.gauges.quick.maths.figure_budget import Source, is_root
from crenel.messages.message import message


class _Budgeted(DocumentPart):
    """Figures with their uncertainties, and what these consist of."""

    expanded_uncertainty: Annotated[dict[str, NotNegative], Field(default_factory=dict)]
    """k = 2, by name, in the unit of each; empty in older files, and where the points are no more
    than the shape's parameters."""
    budget: Annotated[dict[str, dict[Source, NotNegative]], Field(default_factory=dict)]
    """By name, the standard uncertainties (k = 1) of which the expanded uncertainty is twice the
    root of the sum of squares."""

    @model_validator(mode="after")
    def _check_roots(self) -> Self:
        for name, budget in self.budget.items():
            if not is_root(self.expanded_uncertainty.get(name, -1.0), budget):
                raise ValueError(message("uncertainty-is-not-the-root-of-its-budget"))
        return self


class CloudReport(_Budgeted):
    """One cloud of a gauge; errors are there where a nominal was given (Eq. 10-12)."""

    file: str
    points: int
    deleted: int = 0
    """Further points that the file marks as deleted."""
    missing: int = 0
    """Further points that were not measured, such as those at (0, 0, 0)."""
    repeated: int = 0
    """Further points that repeat one of these."""
    used: int
    """After the filter on the standard deviation of distances."""
    rms_um: NotNegative
    form_um: NotNegative
    """Largest minus smallest distance of the points used."""
    in_gate: int | None = None
    """Points within the geometric gate, whatever their distance; None in older files."""
    range_all_um: NotNegative | None = None
    """The same as ``form_um`` of these points."""
    width_mm: NotNegative | None = None
    """The width of a plane's cloud in its narrower direction; None in older files."""
    normal: Vector3 | None = None
    offset_mm: Number | None = None
    centre_mm: Vector3
    radius_mm: Positive | None = None
    angle_arcsec: NotNegative | None = None
    z_error_um: Number | None = None
    offset_error_um: Number | None = None
    radius_error_um: Number | None = None
    centre_error_um: NotNegative | None = None


class SpreadReport(_Budgeted):
    """How far a figure scatters over the clouds; the uncertainties by the names of these three."""

    mean: Number
    standard_deviation: NotNegative
    range: NotNegative


class GaugeReport(Document):
    """``report.json``"""

    FORMAT: ClassVar[str] = "crenel/report"

    shape: Literal["plane", "sphere"]
    nominal: str | None = None
    clouds: tuple[CloudReport, ...]
    spread: Annotated[dict[str, SpreadReport], Field(default_factory=dict)]
    """By the name of the figure; empty for one cloud."""

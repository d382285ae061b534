"""``gauges/*.json``: a ball bar, step gauge or scale bar with its calibrated lengths."""

from pathlib import Path
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from crenel.formats.json_document import (
    CertifiedUm,
    Document,
    DocumentPart,
    IssueDate,
    Name,
    NotNegative,
    SerialNumber,
    SizeMm,
)
from crenel.gauges.plan.maths_lengths import CalibratedLength


class LengthPart(DocumentPart):
    """One length at 20 °C, with its standard uncertainty (k = 1)."""

    length_mm: SizeMm
    standard_uncertainty_um: CertifiedUm


class LengthStandardFile(Document):
    """The file."""

    FORMAT: ClassVar[str] = "crenel/length-standard"

    name: Name
    serial_number: SerialNumber = ""
    certificate: Annotated[str, Field(max_length=200)] = ""
    issued_on: IssueDate = ""
    valid_until: Annotated[str, Field(max_length=20)] = ""
    """ISO 8601 date; empty: not stated."""
    kind: Literal["ball-bar", "step-gauge"] = "ball-bar"
    sphere_diameter_mm: SizeMm | None = None
    """The diameter of a ball bar's spheres."""
    sphere_form_um: CertifiedUm = 0.0
    """Form deviation of each sphere."""
    expansion_per_c: NotNegative = 0.0
    expansion_sd_per_c: NotNegative = 0.0
    lengths: Annotated[tuple[LengthPart, ...], Field(min_length=1)]

    def nominal(self, number: int) -> CalibratedLength:
        """A length by its number, from 1, with what is known of the standard."""
        part = self.lengths[number - 1]
        return CalibratedLength(
            part.length_mm,
            part.standard_uncertainty_um,
            self.expansion_per_c,
            self.expansion_sd_per_c,
            self.sphere_form_um,
        )


def read_length_standard(path: Path) -> LengthStandardFile:
    """Reads the file; raises ``OperationError`` naming file and field."""
    return LengthStandardFile.read(path)

"""A gauge's nominal: its shape and size by certificate, and the limits it is judged by.

``gauges/*.nominal.json`` of the data folder: a nominal (docs/formats.md) with further fields::

    {"format": "crenel/nominal", "version": 1, "shape": "sphere", "radius_mm": 12.7,
     "name": "Ceramic sphere 25.4", "serial_number": "K-17", "certificate": "DKD 4711, 2026-03",
     "standard_uncertainty_um": 0.3, "form_um": 1.2, "limits": {"radius_error": 40}}

Where the gauge stands (``point_mm`` and ``normal``, ``centre_mm``) may be missing: on a table
it stands elsewhere each time, and a verification finds its place by the probe.
"""

from pathlib import Path
from typing import Annotated, ClassVar, Literal, Self

from pydantic import Field, model_validator

from crenel.formats.json_document import (
    CertifiedUm,
    Document,
    DocumentPart,
    IssueDate,
    Name,
    NotNegative,
    Positive,
    SerialNumber,
    SizeMm,
    field_name,
)
from crenel.messages.message import message

Shape = Literal["plane", "sphere"]
LARGEST_RADIUS_MM = 300.0


class VerificationLimits(DocumentPart):
    """Largest values that are accepted; in µm, and arcsec for angles. None: not judged by it."""

    rms: Positive | None = None
    form: Positive | None = None
    form_all: Positive | None = None
    range_all: Positive | None = None
    angle: Positive | None = None
    offset: Positive | None = None
    radius_error: Positive | None = None
    centre_error: Positive | None = None
    angle_range: Positive | None = None
    offset_range: Positive | None = None
    centre_range: Positive | None = None

    def with_defaults(self, other: "VerificationLimits") -> "VerificationLimits":
        """These, and the other's where these say nothing."""
        return VerificationLimits(
            **{**other.model_dump(exclude_none=True), **self.model_dump(exclude_none=True)}
        )


DEFAULT_LIMITS = VerificationLimits(
    rms=80,
    form=300,
    angle=300,
    offset=200,
    radius_error=150,
    centre_error=250,
    angle_range=500,
    offset_range=200,
    centre_range=250,
)
"""For an arm of the article's class, 0.25 mm over its reach; its tests found 230 to 500 arcsec,
100 to 110 µm of a plane, and 50 and 90 µm of a sphere's radius and centre."""


class GaugeFile(Document):
    """What a verification needs to know of its gauge."""

    FORMAT: ClassVar[str] = "crenel/nominal"

    shape: Shape
    radius_mm: Annotated[SizeMm, Field(le=LARGEST_RADIUS_MM)] | None = None
    """The radius of a sphere."""
    name: Name = ""
    serial_number: SerialNumber = ""
    certificate: Annotated[str, Field(max_length=200)] = ""
    issued_on: IssueDate = ""
    standard_uncertainty_um: CertifiedUm = 0.0
    """The standard uncertainty of a radius, or of a plane's flatness, k = 1."""
    form_um: CertifiedUm = 0.0
    """The gauge's own deviation from its shape."""
    form_sd_um: CertifiedUm = 0.0
    """Standard uncertainty of ``form_um``, k = 1."""
    valid_until: Annotated[str, Field(max_length=40)] = ""
    """The certificate's, an ISO 8601 date; empty: not stated."""
    width_mm: SizeMm | None = None
    """The narrower side of a plate; None: not stated."""
    expansion_per_c: NotNegative = 0.0
    """Coefficient of thermal expansion; 0: not stated."""
    expansion_sd_per_c: NotNegative = 0.0
    """Its standard uncertainty, k = 1."""
    limits: VerificationLimits = VerificationLimits()

    @model_validator(mode="after")
    def _check_radius(self) -> Self:
        if self.shape == "sphere" and self.radius_mm is None:
            radius = field_name("radius_mm")
            raise ValueError(message("radius-mm-missing-sphere-judged-size", radius=radius))
        return self


def read_gauge(path: Path) -> GaugeFile:
    """Reads a gauge's nominal; raises ``OperationError`` naming the file and the field."""
    return GaugeFile.read(path)

"""What an identified ``arm.json`` carries beside the arm: where its parameters come from."""

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from crenel.formats.json_document import (
    DocumentPart,
    NotNegative,
    Number,
    Software,
    require_covariance,
)
from crenel.messages.message import Text


class IdentificationInput(DocumentPart):
    file: str
    sha256: str


class ParameterPart(DocumentPart):
    """One parameter that was moved, named and measured as in the file: ``J2.alpha_deg``."""

    name: str
    before: Number
    after: Number
    standard_uncertainty: NotNegative


class FixedParameterPart(DocumentPart):
    """One parameter that kept its value."""

    name: str
    reason: Text


class CorrelationPart(DocumentPart):
    """Two moved parameters that the places hardly distinguish."""

    first: str
    second: str
    coefficient: Number


class FramePart(DocumentPart):
    """The arm's base in the frame of an instrument: a point there is ``R q + (x, y, z)``."""

    name: str
    x_mm: Number
    y_mm: Number
    z_mm: Number
    qx: Number
    qy: Number
    qz: Number
    qw: Number
    standard_uncertainty_mm: NotNegative | None = None
    """The standard uncertainty of each coordinate of the base's origin; None if the frame was
    given."""


class MarkerPart(DocumentPart):
    """A marker on the last link, in the flange frame."""

    name: str
    x_mm: Number
    y_mm: Number
    z_mm: Number
    standard_uncertainty_mm: tuple[NotNegative, NotNegative, NotNegative] | None = None
    """None if the place was given, or is that of the tip, which is among the parameters."""
    quaternion: tuple[Number, Number, Number, Number] | None = None
    """x, y, z, w of its rotation, if poses were measured."""


class DeviationsPart(DocumentPart):
    """How far places that the fit did not see disagree; None where none was measured so."""

    seats_um: NotNegative | None = None
    spheres_um: NotNegative | None = None
    lengths_um: NotNegative | None = None
    coordinates_um: NotNegative | None = None
    """Rms distance of markers from where an instrument measured them."""
    rotations_deg: NotNegative | None = None
    normalised: NotNegative
    """Rms in standard deviations of the points: 1 where noise explains everything."""


class ValidationPart(DocumentPart):
    method: Literal["separate", "cross-validation"]
    places: int
    before: DeviationsPart
    after: DeviationsPart


class IdentificationPart(DocumentPart):
    """Readers of an arm may ignore it."""

    created_at: str
    operator: str = ""
    station: str = ""
    simulated: bool = False
    temperature_c: Number | None = None
    parameters: tuple[ParameterPart, ...]
    covariance: tuple[tuple[Number, ...], ...]
    """The covariance of ``parameters``, in their units, k = 1."""
    held: tuple[FixedParameterPart, ...]
    correlated: Annotated[tuple[CorrelationPart, ...], Field(default=())]
    """Pairs of ``parameters`` whose correlation is beyond ±0.95, the strongest first."""
    volume_before_um: NotNegative
    """Rms of the tip over the reach: by how much the arm differed from what it is now."""
    volume_after_um: NotNegative
    """Rms standard uncertainty of the tip over the reach, by the parameters moved."""
    size_known: bool
    """False where neither ball bar nor coordinates determined the arm's size: it comes on top of
    ``volume_after_um``."""
    scatter_um: NotNegative | None = None
    """Per coordinate, of single touches beyond the encoders' noise; None without touches."""
    coordinates_scatter_um: NotNegative | None = None
    """Per coordinate, of an instrument's points beyond encoders and stated uncertainty."""
    rotations_scatter_deg: NotNegative | None = None
    """The same of rotations, about each axis."""
    frames: Annotated[tuple[FramePart, ...], Field(default=())]
    markers: Annotated[tuple[MarkerPart, ...], Field(default=())]
    validation: ValidationPart
    outliers: Annotated[tuple[Text, ...], Field(default=())]
    warnings: Annotated[tuple[Text, ...], Field(default=())]
    inputs: tuple[IdentificationInput, ...]
    software: Software

    @model_validator(mode="after")
    def _covariance_fits_its_parameters(self) -> Self:
        require_covariance(self.covariance, len(self.parameters))
        return self

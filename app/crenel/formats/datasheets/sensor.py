"""``sensor.json``: what the laser stripe sensor is."""

from pathlib import Path
from typing import Annotated, ClassVar, Literal, Self

from pydantic import Field, model_validator

from crenel.formats.json_document import (
    Document,
    DocumentPart,
    Name,
    Number,
    Positive,
    SerialNumber,
    field_name,
)
from crenel.messages.message import message
from crenel.metrology.bayer import BayerPattern, BayerPlane
from crenel.metrology.channel import Channel
from crenel.metrology.colour import LaserColour, laser_colour


class SelectedPart(DocumentPart):
    """What a station's driver made grey pictures of: the channel of a colour, or raw pixels."""

    colour: LaserColour
    bayer: BayerPattern | None = None


class SensorDatasheet(Document):
    """The sensor's datasheet; ``focal_px`` and ``standoff_mm`` are hints only."""

    FORMAT: ClassVar[str] = "crenel/sensor"

    name: Name
    serial_number: SerialNumber = ""
    width_px: Annotated[int, Field(ge=1, le=65536, strict=True)]
    height_px: Annotated[int, Field(ge=1, le=65536, strict=True)]
    stripe_axis: Literal["u", "v"]
    laser_wavelength_nm: Annotated[Number, Field(ge=200, le=3000)] | None = None
    """Of light: 0.66 is one in µm, and would select the blue channel."""
    bayer: BayerPattern | None = None
    """The colours of a cell of 2 × 2 pixels in raw pictures of a colour camera."""
    selected: SelectedPart | None = None
    """In the session of a station with a colour camera; the pictures are grey then."""
    focal_px: Positive | None = None
    standoff_mm: Positive | None = None

    @model_validator(mode="after")
    def _colour_of_raw_pictures_is_known(self) -> Self:
        if self.bayer is not None and self.laser_wavelength_nm is None:
            bayer, wavelength = field_name("bayer"), field_name("laser_wavelength_nm")
            raise ValueError(message("bayer-needs-wavelength", bayer=bayer, wavelength=wavelength))
        return self

    @property
    def channel(self) -> Channel | None:
        """What of a picture shows the laser, where the wavelength is known."""
        if self.laser_wavelength_nm is None:
            return None
        return _channel_of(laser_colour(self.laser_wavelength_nm), self.bayer)

    @property
    def pictures_of(self) -> Channel | None:
        """What of a colour camera the pictures are, where a station's driver selected that."""
        if self.selected is None:
            return None
        return _channel_of(self.selected.colour, self.selected.bayer)


def _channel_of(colour: LaserColour, bayer: BayerPattern | None) -> Channel:
    """A colour of pictures in colour, or of raw ones."""
    return colour if bayer is None else BayerPlane(bayer, colour)


def read_sensor(path: Path) -> SensorDatasheet:
    """Reads ``sensor.json``; raises ``OperationError`` naming the file and the field."""
    return SensorDatasheet.read(path)

"""``sensor.json``: what the laser stripe sensor is."""

from pathlib import Path
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from app.formats.json_document import Document, Positive
from app.metrology.colour import LaserColour, laser_colour


class SensorDatasheet(Document):
    """The sensor's datasheet; ``focal_px`` and ``standoff_mm`` are hints only."""

    FORMAT: ClassVar[str] = "crenel/sensor"

    name: str
    serial_number: str
    width_px: Annotated[int, Field(gt=0, le=65536, strict=True)]
    height_px: Annotated[int, Field(gt=0, le=65536, strict=True)]
    stripe_axis: Literal["u", "v"]
    laser_wavelength_nm: Positive | None = None
    focal_px: Positive | None = None
    standoff_mm: Positive | None = None

    @property
    def laser_colour(self) -> LaserColour | None:
        """The channel in which a colour camera sees the laser, where the wavelength is known."""
        return None if self.laser_wavelength_nm is None else laser_colour(self.laser_wavelength_nm)


def read_sensor(path: Path) -> SensorDatasheet:
    """Reads ``sensor.json``; raises ``OperationError`` naming the file and the field."""
    return SensorDatasheet.read(path)

"""``mask.json``: zones of the sensor's picture without measurement."""

from pathlib import Path
from typing import Annotated, ClassVar, Self

import cv2
import numpy as np
from numpy.typing import NDArray
from pydantic import Field, model_validator

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.json_document import Document, Number
from crenel.messages.message import message

MOST_ZONES = 32
LEAST_AREA_PX = 4.0

Corner = tuple[Number, Number]
Zone = Annotated[tuple[Corner, ...], Field(min_length=3, max_length=64)]
"""The corners (u, v) of a polygon, in pixels."""


class Mask(Document):
    """Zones in the picture of one sensor."""

    FORMAT: ClassVar[str] = "crenel/mask"

    width_px: int = Field(gt=0, le=65536)
    height_px: int = Field(gt=0, le=65536)
    sensor_serial: str = ""
    zones: tuple[Zone, ...] = Field(max_length=MOST_ZONES)

    @model_validator(mode="after")
    def _zones_lie_in_the_picture(self) -> Self:
        for number, zone in enumerate(self.zones, 1):
            u, v = np.array(zone).T
            if u.max() < 0 or v.max() < 0 or u.min() >= self.width_px or v.min() >= self.height_px:
                raise ValueError(message("zone-outside-picture", number=number))
            if np.abs(np.array(zone)).max() > 4 * 65536:
                raise ValueError(message("zone-reaches-far-beyond-picture", number=number))
            area = 0.5 * abs(float(u @ np.roll(v, -1) - v @ np.roll(u, -1)))
            if area < LEAST_AREA_PX:
                raise ValueError(message("zone-has-no-area", number=number))
        return self

    def where(self) -> NDArray[np.bool_]:
        """Mask (height, width) of the pixels in which the stripe may lie: all outside the zones."""
        hidden = np.zeros((self.height_px, self.width_px), np.uint8)
        for zone in self.zones:
            cv2.fillPoly(hidden, [np.rint(np.array(zone)).astype(np.int32)], (1,))
        return np.asarray(hidden == 0)

    def check_size(self, path: Path, width_px: int, height_px: int) -> None:
        """Raises ``OperationError`` for a picture for which the zones were not drawn."""
        if (width_px, height_px) != (self.width_px, self.height_px):
            raise OperationError(
                "mask-size",
                message(
                    "image-has-pixels", name=display_path(path), width=width_px, height=height_px
                ),
                message("mask-has-pixels", width=self.width_px, height=self.height_px),
                message("give-mask-sensor-took-picture"),
            )

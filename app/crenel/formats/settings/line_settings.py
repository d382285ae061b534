"""How the laser's line is looked for in pictures: by what is set, outside the zones of a mask.

``line.json`` has that of a calibration session.
"""

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, ClassVar

from pydantic import BaseModel, ConfigDict, Field

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.json_document import Document, Number
from crenel.formats.settings.mask import Mask
from crenel.messages.message import message
from crenel.metrology.bayer import CELL_PX, BayerPlane
from crenel.metrology.channel import Channel
from crenel.metrology.colour import LaserColour
from crenel.metrology.image import Image
from crenel.metrology.stripe import (
    AUTOMATIC,
    MOST_SMOOTHING_PX,
    LineBounds,
    LineSearch,
    PeakChoice,
    StripeSettings,
)

LINE = "line.json"
EXTRACTION_FIELDS = ("threshold", "min_width_px", "max_width_px", "choice", "smoothing_px")
"""The fields of ``StripeSettings`` that a user sets."""

Threshold = Annotated[Number, Field(gt=0, le=60_000)]
"""Grey levels over the surroundings."""
Width = Annotated[Number, Field(ge=0.5, le=200)]
"""Pixels at half height."""
Smoothing = Annotated[Number, Field(ge=0, le=MOST_SMOOTHING_PX)]
"""Standard deviation in pixels along the line."""


@dataclass(frozen=True)
class LineSettings:
    """What is set of the line; nothing of it is automatic.

    ``channel``: what of colour or raw pictures is measured; None: by the sensor's datasheet.
    ``bounds``: where the line can be, by a calibration. ``unlit``: (H, W) what a picture shows with
    the laser off, in the channel that is measured.
    """

    stripe: StripeSettings = AUTOMATIC
    mask: Mask | None = None
    channel: Channel | None = None
    bounds: LineBounds | None = None
    unlit: Image | None = field(default=None, compare=False)

    @property
    def is_automatic(self) -> bool:
        """Whether nothing is set."""
        return self == AUTOMATIC_LINE

    @property
    def text(self) -> str:
        """As JSON, for recordings and results; empty where all is automatic."""
        return extraction_text(self.stripe, self.mask)

    def check_size(self, path: Path, width_px: int, height_px: int) -> None:
        """Raises ``OperationError`` for a picture of another size than mask or calibration."""
        if self.mask is not None:
            self.mask.check_size(path, width_px, height_px)
        if self.bounds is not None and self.bounds.size_px != (width_px, height_px):
            raise OperationError(
                "image-size",
                message(
                    "image-has-pixels", name=display_path(path), width=width_px, height=height_px
                ),
                message(
                    "calibration-is-for-pixels",
                    width=self.bounds.size_px[0],
                    height=self.bounds.size_px[1],
                ),
                message("give-calibration-sensor-took-picture"),
            )

    def search(self, channel: Channel | None = None) -> LineSearch:
        """The search in what a channel shows of pictures of the mask's size."""
        where = None if self.mask is None else self.mask.where()
        if not isinstance(channel, BayerPlane):
            return LineSearch(self.stripe, where, self.bounds)
        return LineSearch(
            channel.select_settings(self.stripe),
            None if where is None else channel.select_mask(where),
            None if self.bounds is None else self.bounds.of_cells(CELL_PX),
        )


def cell_px(channel: Channel | None) -> int:
    """Pixels of a picture's side that one measured pixel stands for."""
    return CELL_PX if isinstance(channel, BayerPlane) else 1


AUTOMATIC_LINE = LineSettings()


class LineFields(BaseModel):
    """What an operator sets of the line; None means automatic."""

    model_config = ConfigDict(frozen=True, allow_inf_nan=False)

    threshold: Threshold | None = None
    min_width_px: Width | None = None
    max_width_px: Width | None = None
    choice: PeakChoice = "continuity"

    @property
    def stripe(self) -> StripeSettings:
        """What the extraction goes by."""
        return StripeSettings(
            self.threshold, self.min_width_px, self.max_width_px, choice=self.choice
        )


class SessionLine(LineFields, Document):
    """``line.json``: how the line is looked for in all pictures of a calibration session."""

    FORMAT: ClassVar[str] = "crenel/line"

    mask: Mask | None = None
    colour: LaserColour | None = None
    """Of the laser: its channel is measured in colour pictures."""

    @property
    def settings(self) -> LineSettings:
        """The same, as the extraction takes it."""
        return LineSettings(self.stripe, self.mask, self.colour)


def read_session_line(folder: Path) -> LineSettings:
    """What is set of the line in a session's folder; automatic without the file.

    Raises:
        OperationError: names file and field.
    """
    path = folder / LINE
    return SessionLine.read(path).settings if path.exists() else AUTOMATIC_LINE


def extraction_text(settings: StripeSettings, mask: Mask | None) -> str:
    """How stripes are extracted, as JSON for a recording; empty where all is automatic."""
    chosen: dict[str, object] = {
        name: value
        for name in EXTRACTION_FIELDS
        if (value := getattr(settings, name)) != getattr(StripeSettings, name)
    }
    if mask is not None:
        chosen["mask"] = mask.fields()
    return json.dumps(chosen) if chosen else ""

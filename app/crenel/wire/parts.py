"""What browsers send and receive of parts and of comparisons with them."""

from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic import Field

from crenel.wire.schema import RequestBody, Share

Motion = Literal["x", "y", "z", "rx", "ry", "rz"]
Millimetres = Annotated[float, Field(ge=-100, le=100, allow_inf_nan=False, strict=False)]


class NewPartFile(RequestBody):
    """The file of a part that is going to be sent, and its size in bytes."""

    name: Annotated[str, Field(min_length=1, max_length=255)]
    size: Annotated[int, Field(ge=0)]


class NewComparison(RequestBody):
    """With what a scan is compared; an empty unit: as the file states it."""

    part: Annotated[str, Field(max_length=32)]
    unit: Literal["", "mm", "cm", "m", "inch"] = ""
    body: Annotated[int, Field(ge=1)] | None = None
    lower_mm: Millimetres
    upper_mm: Millimetres
    locked: Annotated[list[Motion], Field(default_factory=list, max_length=6)]


class MapWish(RequestBody):
    """Whether a map is shown, and by which colours."""

    on: bool
    mode: Literal["deviation", "significance", "uncertainty"] = "significance"


class PictureSpot(RequestBody):
    """A place of the picture of a page, as shares of its width and height from its upper left."""

    view: Annotated[str, Field(max_length=64)]
    x: Share
    y: Share


@dataclass(frozen=True)
class ArrivedBytes:
    """The id of a file that arrives, and how much of it has."""

    id: str
    received: int


@dataclass(frozen=True)
class ScanSize:
    """Extents along a scan's own main axes, mm, the largest first; null: it is not displayed."""

    mm: tuple[float, ...] | None

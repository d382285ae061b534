"""``object.json``: the crenellated object's certificate."""

from itertools import pairwise
from pathlib import Path
from typing import Annotated, ClassVar, Self

from pydantic import Field, model_validator

from app.files.documents import Document, NotNegative, Number
from app.metrology.crenellated import Crenellated
from app.metrology.refusal import Refusal

COARSEST_MM = 0.1
"""A certificate that is no better than this is rather one in other units."""
MIRROR_TOLERANCE_MM = 0.1
"""A block whose edges come closer than this to their mirror image reads both ways."""


class ObjectFile(Document):
    """The file as FORMATS.md has it, for ``kind`` crenellated."""

    FORMAT: ClassVar[str] = "crenel/object"

    name: str
    serial_number: str
    edges_x_mm: Annotated[tuple[Number, ...], Field(min_length=4)]
    front_y_mm: Number
    back_y_mm: Number
    crest_z_mm: Number
    floor_z_mm: Number
    base_z_mm: Number
    standard_uncertainty_mm: NotNegative

    @model_validator(mode="after")
    def _is_a_block(self) -> Self:
        x = self.edges_x_mm
        if len(x) % 2:
            raise ValueError(
                f"edges_x_mm holds {len(x)} edges; every merlon has two, a left and a right one"
            )
        for left, right in pairwise(x):
            if left >= right:
                raise ValueError(f"edges_x_mm must ascend: {right:g} follows {left:g}")
        if self.front_y_mm >= self.back_y_mm:
            raise ValueError("front_y_mm must be less than back_y_mm")
        if not self.crest_z_mm > self.floor_z_mm > self.base_z_mm:
            raise ValueError("crest_z_mm must be above floor_z_mm, and that above base_z_mm")
        if self.standard_uncertainty_mm > COARSEST_MM:
            raise ValueError(
                f"standard_uncertainty_mm must be at most {COARSEST_MM:g}; is it in micrometres?"
            )
        mirrored = [x[0] + x[-1] - edge for edge in reversed(x)]
        if max(abs(a - b) for a, b in zip(x, mirrored, strict=True)) < MIRROR_TOLERANCE_MM:
            raise ValueError(
                "the merlons' widths and gaps read the same from both ends, "
                "so that the block cannot be told from its mirror image"
            )
        return self


class _AnyObject(Document):
    FORMAT: ClassVar[str] = "crenel/object"

    kind: str = "crenellated"


def read_object(path: Path) -> Crenellated:
    """Reads ``object.json``; raises ``Refusal`` naming the file and the field."""
    kind = _AnyObject.read(path).kind
    if kind != "crenellated":
        known = "is not supported" if kind == "chessboard" else "is unknown"
        raise Refusal(
            "object-kind-unsupported",
            f"{path}: kind {kind!r} {known}",
            "the calibration in one step needs a crenellated object",
            "Give the certificate of a crenellated object",
        )
    sheet = ObjectFile.read(path)
    return Crenellated(**sheet.model_dump())


def write_object(path: Path, block: Crenellated) -> None:
    """Writes ``object.json`` atomically."""
    ObjectFile.model_validate(block, from_attributes=True).write(path)

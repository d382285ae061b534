"""``object.json``: the certificate of the crenellated object, or of a flat chessboard."""

from dataclasses import asdict
from itertools import pairwise
from pathlib import Path
from typing import Annotated, ClassVar, Literal, Self

from pydantic import Field, model_validator

from app.errors import OperationError
from app.formats.file_names import display_path
from app.formats.json_document import Document, NotNegative, Number, Positive
from app.metrology.targets.chessboard import Chessboard
from app.metrology.targets.crenellated_block import Crenellated

COARSEST_MM = 0.1
"""A certificate that is no better than this is rather one in other units."""
PRINTED_MM = 0.05
"""Standard uncertainty of a printed pattern's width and height, where its certificate is silent."""
SMALLEST_SQUARE_MM = 0.2
"""Squares smaller than this are rather given in metres."""
MIRROR_TOLERANCE_MM = 0.1
"""A block whose edges come closer than this to their mirror image reads both ways."""


InnerCorners = Annotated[int, Field(ge=3, le=200, strict=True)]


Certificate = Annotated[str, Field(max_length=200)]
"""Who issued it and when, as reports name it."""


class ObjectFile(Document):
    """The file for ``kind`` crenellated, as described in docs/formats.md."""

    FORMAT: ClassVar[str] = "crenel/object"

    name: str
    serial_number: str
    certificate: Certificate = ""
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


class ChessboardFile(Document):
    """The file for ``kind`` chessboard."""

    FORMAT: ClassVar[str] = "crenel/object"

    kind: Literal["chessboard"]
    name: str
    serial_number: str
    certificate: Certificate = ""
    inner_corners: tuple[InnerCorners, InnerCorners]
    """Columns, rows."""
    square_mm: Positive
    standard_uncertainty_mm: NotNegative = PRINTED_MM
    flatness_mm: NotNegative | None = None
    """By how much the sheet typically bends over the pattern; paper's where missing."""

    @model_validator(mode="after")
    def _is_a_board(self) -> Self:
        if self.square_mm < SMALLEST_SQUARE_MM:
            raise ValueError(f"square_mm must be at least {SMALLEST_SQUARE_MM:g}; is it in metres?")
        for name in ("standard_uncertainty_mm", "flatness_mm"):
            if (getattr(self, name) or 0.0) > self.square_mm / 2:
                raise ValueError(f"{name} must be less than half a square; is it in micrometres?")
        return self


class _AnyObject(Document):
    FORMAT: ClassVar[str] = "crenel/object"

    kind: str = "crenellated"
    certificate: Certificate = ""


def read_object(path: Path) -> Crenellated | Chessboard:
    """Reads ``object.json``; raises ``OperationError`` naming the file and the field."""
    kind = _AnyObject.read(path).kind
    if kind == "crenellated":
        return Crenellated(**ObjectFile.read(path).model_dump(exclude={"certificate"}))
    if kind == "chessboard":
        fields = ChessboardFile.read(path).model_dump(
            exclude={"kind", "certificate"}, exclude_none=True
        )
        return Chessboard(**fields)
    raise OperationError(
        "object-kind-unsupported",
        f"{display_path(path)}: kind {kind!r} is unknown",
        "it is 'crenellated' or 'chessboard'",
        "Correct it",
    )


def read_certificate(path: Path) -> str:
    """Which certificate ``object.json`` names, empty where none; raises ``OperationError``."""
    return _AnyObject.read(path).certificate


def read_block(path: Path) -> Crenellated:
    """Reads the ``object.json`` of a crenellated object; refuses that of a chessboard."""
    found = read_object(path)
    if isinstance(found, Crenellated):
        return found
    raise OperationError(
        "object-kind-unsupported",
        f"{display_path(path)}: kind 'chessboard' is not supported here",
        "contacts and stripe on several levels need a crenellated object",
        "Give the certificate of a crenellated object, or calibrate on the command line",
    )


def write_object(path: Path, item: Crenellated | Chessboard) -> None:
    """Writes ``object.json`` atomically."""
    if isinstance(item, Crenellated):
        ObjectFile.model_validate(item, from_attributes=True).write(path)
    else:
        ChessboardFile.model_validate({"kind": "chessboard", **asdict(item)}).write(path)

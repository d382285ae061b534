"""``object.json``: the certificate of the crenellated object, or of a board with squares."""

import math
from itertools import pairwise
from pathlib import Path
from typing import Annotated, ClassVar, Literal, Self

from pydantic import Field, model_validator

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.json_document import (
    Document,
    DocumentPart,
    IssueDate,
    Name,
    NotNegative,
    Number,
    SerialNumber,
    SizeMm,
    field_name,
    read_text,
)
from crenel.messages.message import message, rounded
from crenel.metrology.targets.chessboard import DICTIONARIES, Chessboard, Markers
from crenel.metrology.targets.crenellated_block import Crenellated, mirror_difference_mm

COARSEST_MM = 0.1
"""A certificate that is no better than this is rather one in other units."""
WIDEST_MM = 0.3
"""A block made within more than this cannot be calibrated with: pictures no longer tell its edges
from each other's places."""
PRINTED_MM = 0.05
"""Standard uncertainty of a printed pattern's width and height, where its certificate is silent."""
SMALLEST_SQUARE_MM = 0.2
"""Squares smaller than this are rather given in metres."""
ROUNDING_MM = 1e-9
MIRROR_TOLERANCE_MM = 0.1
"""A block whose edges come closer than this to their mirror image reads both ways."""


InnerCorners = Annotated[int, Field(ge=3, le=200, strict=True)]
Squares = Annotated[int, Field(ge=4, le=201, strict=True)]


Certificate = Annotated[str, Field(max_length=200)]
"""Who issued it and when, as reports name it."""


class CoordinateUncertainties(DocumentPart):
    """The standard uncertainty of each coordinate of a block, in the order of its fields."""

    edges_x_mm: tuple[NotNegative, ...]
    front_y_mm: NotNegative
    back_y_mm: NotNegative
    crest_z_mm: NotNegative
    floor_z_mm: NotNegative
    base_z_mm: NotNegative

    def values_mm(self) -> tuple[float, ...]:
        """One for each coordinate: edges, front, back, crest, floor, base."""
        z = (self.crest_z_mm, self.floor_z_mm, self.base_z_mm)
        return (*self.edges_x_mm, self.front_y_mm, self.back_y_mm, *z)


class ObjectFile(Document):
    """The file for ``kind`` crenellated, as described in docs/formats.md."""

    FORMAT: ClassVar[str] = "crenel/object"

    name: Name
    serial_number: SerialNumber
    certificate: Certificate = ""
    issued_on: IssueDate = ""
    edges_x_mm: Annotated[tuple[Number, ...], Field(min_length=4)]
    front_y_mm: Number
    back_y_mm: Number
    crest_z_mm: Number
    floor_z_mm: Number
    base_z_mm: Number
    # the range is stated here, and checked below, in words that name the likely mistake
    standard_uncertainty_mm: (
        Annotated[NotNegative, Field(json_schema_extra={"le": COARSEST_MM})] | None
    ) = None
    """The standard uncertainty of every coordinate, or the largest of them."""
    standard_uncertainties_mm: CoordinateUncertainties | None = None
    tolerance_mm: Annotated[NotNegative, Field(json_schema_extra={"le": WIDEST_MM})] | None = None
    """Instead, of a block that nobody measured: each coordinate is made within ± this."""

    @model_validator(mode="after")
    def _is_a_block(self) -> Self:
        x, edges = self.edges_x_mm, field_name("edges_x_mm")
        if len(x) % 2:
            raise ValueError(message("edges-x-mm-odd-count", edges=edges, count=len(x)))
        for left, right in pairwise(x):
            if left >= right:
                pair = {"right": rounded(right, "mm", 9), "left": rounded(left, "mm", 9)}
                raise ValueError(message("edges-x-mm-must-ascend-follows", edges=edges, **pair))
        if self.front_y_mm >= self.back_y_mm:
            front, back = field_name("front_y_mm"), field_name("back_y_mm")
            raise ValueError(message("front-y-mm-must-less-than", front=front, back=back))
        if not self.crest_z_mm > self.floor_z_mm > self.base_z_mm:
            crest, floor, base = map(field_name, ("crest_z_mm", "floor_z_mm", "base_z_mm"))
            raise ValueError(
                message("crest-z-mm-must-above-floor", crest=crest, floor=floor, base=base)
            )
        self._check_uncertainty()
        if mirror_difference_mm(x) < MIRROR_TOLERANCE_MM:
            raise ValueError(message("merlons-not-distinct-from-mirror-image", edges=edges))
        return self

    def _check_uncertainty(self) -> None:
        one, tolerance = field_name("standard_uncertainty_mm"), field_name("tolerance_mm")
        if (self.standard_uncertainty_mm is None) == (self.tolerance_mm is None):
            raise ValueError(message("uncertainty-or-tolerance", one=one, tolerance=tolerance))
        if (self.standard_uncertainty_mm or 0.0) > COARSEST_MM:
            most = rounded(COARSEST_MM, "mm")
            raise ValueError(
                message(
                    "standard-uncertainty-mm-too-large", field=one, most=most, tolerance=tolerance
                )
            )
        if self.tolerance_mm is not None and not 0.0 < self.tolerance_mm <= WIDEST_MM:
            most = rounded(WIDEST_MM, "mm")
            raise ValueError(message("tolerance-mm-out-of-range", field=tolerance, most=most))
        each = self.standard_uncertainties_mm
        if each is None:
            return
        field = field_name("standard_uncertainties_mm")
        if len(each.edges_x_mm) != len(self.edges_x_mm):
            counts = {"found": len(each.edges_x_mm), "wanted": len(self.edges_x_mm)}
            raise ValueError(message("uncertainties-of-edges-count", field=field, **counts))
        if self.standard_uncertainty_mm is None or max(each.values_mm()) > (
            self.standard_uncertainty_mm + ROUNDING_MM
        ):
            raise ValueError(message("uncertainties-above-largest", field=field, one=one))

    def block(self) -> Crenellated:
        """The block that the file describes.

        Source:
            GUM 4.3.7: within a tolerance, anything is equally likely, so that its standard
            uncertainty is the tolerance over the root of three.
        """
        each = self.standard_uncertainties_mm
        made_mm = (self.tolerance_mm or 0.0) / math.sqrt(3)
        return Crenellated(
            self.name,
            self.serial_number,
            self.edges_x_mm,
            self.front_y_mm,
            self.back_y_mm,
            self.crest_z_mm,
            self.floor_z_mm,
            self.base_z_mm,
            made_mm or self.standard_uncertainty_mm or 0.0,
            () if each is None else each.values_mm(),
            self.tolerance_mm is not None,
        )


class _BoardFile(Document):
    """What the files of both kinds of boards have."""

    FORMAT: ClassVar[str] = "crenel/object"

    name: Name
    serial_number: SerialNumber = ""
    certificate: Certificate = ""
    issued_on: IssueDate = ""
    square_mm: Annotated[SizeMm, Field(json_schema_extra={"ge": SMALLEST_SQUARE_MM})]
    standard_uncertainty_mm: NotNegative = PRINTED_MM
    flatness_mm: NotNegative | None = None
    """By how much the board typically bends over the pattern; where missing, as printed paper."""

    @model_validator(mode="after")
    def _is_a_board(self) -> Self:
        if self.square_mm < SMALLEST_SQUARE_MM:
            field, least = field_name("square_mm"), rounded(SMALLEST_SQUARE_MM, "mm")
            raise ValueError(message("square-mm-too-small", field=field, least=least))
        for name in ("standard_uncertainty_mm", "flatness_mm"):
            if (getattr(self, name) or 0.0) > self.square_mm / 2:
                raise ValueError(
                    message("field-must-be-less-than-half-square", field=field_name(name))
                )
        return self


class ChessboardFile(_BoardFile):
    """The file for ``kind`` chessboard."""

    kind: Literal["chessboard"]
    inner_corners: tuple[InnerCorners, InnerCorners]
    """Columns, rows."""

    def board(self) -> Chessboard:
        """The chessboard that the file describes."""
        fields = self.model_dump(exclude={"kind", "certificate", "issued_on"}, exclude_none=True)
        return Chessboard(**fields)


class CharucoFile(_BoardFile):
    """The file for ``kind`` charuco, with OpenCV's names."""

    kind: Literal["charuco"]
    squares_x: Squares
    squares_y: Squares
    marker_mm: SizeMm
    dictionary: str
    legacy_pattern: bool = False
    """As OpenCV before 4.6 arranged the markers."""
    first_id: Annotated[int, Field(ge=0, strict=True)] = 0
    """The id of the first marker; the others count up from it."""

    @model_validator(mode="after")
    def _has_markers(self) -> Self:
        field = field_name("dictionary")
        if self.dictionary not in DICTIONARIES:
            names = ", ".join(DICTIONARIES)
            raise ValueError(message("dictionary-unknown", field=field, names=names))
        count, known = self.squares_x * self.squares_y // 2, DICTIONARIES[self.dictionary]
        if count <= known < self.first_id + count:
            first, most = field_name("first_id"), known - count
            name = self.dictionary
            raise ValueError(message("first-id-too-large", field=first, most=most, dictionary=name))
        if count > known:
            raise ValueError(
                message(
                    "too-few-markers",
                    field=field,
                    count=count,
                    dictionary=self.dictionary,
                    known=known,
                )
            )
        if self.marker_mm >= self.square_mm:
            marker, square = field_name("marker_mm"), field_name("square_mm")
            raise ValueError(message("marker-mm-less-than-square-mm", marker=marker, square=square))
        return self

    def board(self) -> Chessboard:
        """The board that the file describes."""
        own = {"name", "serial_number", "square_mm", "standard_uncertainty_mm", "flatness_mm"}
        return Chessboard(
            **self.model_dump(include=own, exclude_none=True),
            inner_corners=(self.squares_x - 1, self.squares_y - 1),
            markers=Markers(self.dictionary, self.marker_mm, self.legacy_pattern, self.first_id),
        )


class _AnyObject(Document):
    FORMAT: ClassVar[str] = "crenel/object"

    kind: str = "crenellated"
    certificate: Certificate = ""


def read_object(path: Path) -> Crenellated | Chessboard:
    """Reads ``object.json``; raises ``OperationError`` naming the file and the field."""
    return parse_object(read_text(path), path)


def parse_object(text: str, path: Path) -> Crenellated | Chessboard:
    """Reads the text of a file of this name; as ``read_object``."""
    kind = _AnyObject.parse_text(text, path).kind
    if kind == "crenellated":
        return ObjectFile.parse_text(text, path).block()
    if kind == "chessboard":
        return ChessboardFile.parse_text(text, path).board()
    if kind == "charuco":
        return CharucoFile.parse_text(text, path).board()
    raise OperationError(
        "object-kind-unsupported",
        message("kind-unknown", path=display_path(path), kind=repr(kind)),
        message("kind-is-block-or-board"),
        message("correct-it"),
    )


def read_certificate(path: Path) -> str:
    """Which certificate ``object.json`` names, empty where none; raises ``OperationError``."""
    return parse_certificate(read_text(path), path)


def parse_certificate(text: str, path: Path) -> str:
    """The same of the text of a file of this name."""
    return _AnyObject.parse_text(text, path).certificate


def read_block(path: Path) -> Crenellated:
    """Reads the ``object.json`` of a crenellated object; refuses that of a chessboard."""
    found = read_object(path)
    if isinstance(found, Crenellated):
        return found
    raise OperationError(
        "object-kind-unsupported",
        message("kind-chessboard-not-supported", path=display_path(path)),
        message("contacts-stripe-several-levels-need-crenellated"),
        message("give-certificate-crenellated-object-calibrate-command"),
    )

"""The folder of real pictures: its sets, what is known of each, and their pictures.

::

    FOLDER/boards/SET/    pictures of a board, the laser off, and the board as object.json
    FOLDER/lines/SET/     pictures of a laser line, and what is known of them as set.json

A folder that holds pictures itself is one set: of a board if it has an object.json, otherwise of
lines.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import ClassVar, Literal

from crenel.errors import OperationError
from crenel.formats.datasheets.target import read_object
from crenel.formats.images import GreyImage, read_grey
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.json_document import Document, Positive
from crenel.metrology.colour import LaserColour
from crenel.metrology.targets.chessboard import Chessboard

SUFFIXES = (".png", ".tif", ".tiff", ".bmp", ".pgm", ".jpg", ".jpeg")
Kind = Literal["boards", "lines"]
KINDS: tuple[Kind, ...] = ("boards", "lines")
OBJECT, ABOUT = "object.json", "set.json"
BOARD_COLOUR: LaserColour = "green"
"""Half of a colour camera's pixels are green."""


class PictureSetNotes(Document):
    """``set.json``: what is known of the pictures of a set. All fields are optional.

    ``colour``: of the laser, of colour pictures. ``stripe_axis``: ``u`` for one point a column;
    otherwise the bench looks. ``width_px``: of the line at half its height; otherwise measured.
    ``no_line``: the laser is off in all pictures (of a board set: unless this is false).
    ``several``: more than one line is in the pictures, and each may be taken. ``repeated``: the
    pictures are frames of one scene that does not move.
    """

    FORMAT: ClassVar[str] = "crenel/picture-set"

    colour: LaserColour | None = None
    stripe_axis: Literal["u", "v"] | None = None
    width_px: Positive | None = None
    no_line: bool | None = None
    several: bool = False
    repeated: bool = False


@dataclass(frozen=True)
class LazyPicture:
    """A picture that is read when it is needed, and its name."""

    name: str
    load: Callable[[], GreyImage]


@dataclass(frozen=True)
class PictureSet:
    """A folder of pictures of one camera."""

    name: str
    files: tuple[Path, ...]
    kind: Kind
    about: PictureSetNotes
    board: Chessboard | None = None
    """Looked for in the pictures."""

    @property
    def without_line(self) -> bool:
        """Whether the laser is off: a board is taken so, a line is not, unless stated."""
        return self.kind == "boards" if self.about.no_line is None else self.about.no_line

    def pictures(self) -> list[LazyPicture]:
        """The pictures, in the channel of the laser's colour.

        Loading raises ``OperationError`` for one that cannot be read, or is in colour while the
        laser's is not stated.
        """
        return [
            LazyPicture(path.stem, partial(read_grey, path, self.about.colour))
            for path in self.files
        ]


def find_sets(folder: Path) -> list[PictureSet]:
    """The sets of a folder, those of boards first; a folder of pictures is one set.

    Raises:
        OperationError: it has none, or a set has no pictures or a file that cannot be read.
    """
    with convert_io_errors(folder):
        places: list[tuple[Kind, Path]] = [
            (kind, place)
            for kind in KINDS
            for place in sorted((folder / kind).glob("*/"))
            if place.is_dir()
        ]
        if not places and _pictures_in(folder):
            places = [("boards" if (folder / OBJECT).exists() else "lines", folder)]
    if not places:
        raise OperationError(
            "folder-without-sets",
            str(folder),
            "it has no pictures, and no folder boards/SET or lines/SET",
            "Put the pictures of each camera into one",
        )
    return [_read_set(kind, place) for kind, place in places]


def drop_unreadable(one: PictureSet) -> tuple[PictureSet, list[OperationError]]:
    """The set without the pictures that cannot be read, and why these cannot.

    Raises:
        OperationError: none can be read, or pictures are in colour and the laser's is not stated.
    """
    kept: list[Path] = []
    refusals: list[OperationError] = []
    for file, picture in zip(one.files, one.pictures(), strict=True):
        try:
            picture.load()
            kept.append(file)
        except OperationError as refusal:
            if refusal.code == "image-in-colour":
                remedy = f"State colour (of the laser) in {file.parent / ABOUT}"
                raise OperationError(refusal.code, refusal.what, refusal.why, remedy) from refusal
            refusals.append(refusal)
    if not kept:
        raise refusals[0]
    return replace(one, files=tuple(kept)), refusals


def _pictures_in(folder: Path) -> tuple[Path, ...]:
    return tuple(sorted(path for path in folder.iterdir() if path.suffix.lower() in SUFFIXES))


def _read_set(kind: Kind, place: Path) -> PictureSet:
    files = _pictures_in(place)
    if not files:
        raise OperationError(
            "folder-without-pictures", str(place), "it contains no pictures", "Add some"
        )
    about = PictureSetNotes()
    if (place / ABOUT).exists():
        about = PictureSetNotes.read(place / ABOUT)
    name = f"{kind}/{place.name}"
    if kind == "lines":
        return PictureSet(name, files, kind, about)
    about = about.model_copy(update={"colour": about.colour or BOARD_COLOUR})
    return PictureSet(name, files, kind, about, _read_board(place))


def _read_board(place: Path) -> Chessboard | None:
    if not (place / OBJECT).exists():
        return None
    board = read_object(place / OBJECT)
    if not isinstance(board, Chessboard):
        raise OperationError("not-a-board", str(place / OBJECT), "it is not a chessboard")
    return board

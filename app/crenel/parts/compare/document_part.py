"""A part that a station keeps: its file as it was given, and ``part.json`` beside it."""

from pathlib import Path
from typing import Annotated, ClassVar

from pydantic import Field

from crenel.formats.json_document import Document, Number
from crenel.messages.message import Text

PART = "part.json"
PARTS = "parts"
"""Folder of the data folder, with a folder for each part."""
MOST_PARTS = 200
MOST_BYTES = 256_000_000
"""Of a file: five million triangles in binary STL."""
SUFFIXES = (".stl", ".step", ".stp")
LONGEST_NAME = 120


class KeptPart(Document):
    """What is known of a part, and how it was last compared."""

    FORMAT: ClassVar[str] = "crenel/part"

    name: Annotated[str, Field(max_length=LONGEST_NAME)]
    """Of its file."""
    file: Annotated[str, Field(pattern=r"^part\.(stl|step|stp)$")]
    added_at: str
    form: str
    """STL or STEP."""
    has_unit: bool
    """Whether the file states its unit; else it is to be asked for."""
    size: tuple[Number, Number, Number]
    """Along its axes: in mm if it states its unit, else in that unit, whatever it is."""
    triangles: int
    is_closed: bool
    bodies: int
    notes: tuple[Text, ...] = ()
    """What was found of its surface, and done about it."""
    unit: str = ""
    """The unit that was stated for it; empty before."""
    body: int | None = None
    locked: tuple[str, ...] = ()
    lower_mm: Number | None = None
    upper_mm: Number | None = None
    """The tolerance with which it was last compared."""

    @classmethod
    def of_folder(cls, folder: Path) -> "KeptPart":
        """The part in a folder; raises ``OperationError`` where it cannot be read."""
        return cls.read(folder / PART)

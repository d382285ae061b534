"""The logo of whoever makes reports: a picture in the data folder, or beside a record."""

from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import open_file
from crenel.messages.message import message, quantity

NAMES = ("logo.png", "logo.jpg", "logo.jpeg")
MARKS = {b"\x89PNG\r\n\x1a\n": "image/png", b"\xff\xd8\xff": "image/jpeg"}
LARGEST_BYTES = 1_000_000


def read_logo(folder: Path) -> bytes | None:
    """The logo for the report of a record: of the data folder that the record lies in, otherwise
    of its own folder; None where there is none.

    Raises:
        OperationError: it is no PNG or JPEG, or too large.
    """
    whole = folder.resolve()
    for place in (whole.parent.parent, whole):
        for name in NAMES:
            path = place / name
            if path.is_file():
                return _read(path)
    return None


def logo_type(logo: bytes) -> str:
    """Its media type; empty if it is no picture that a report can have."""
    return next((kind for mark, kind in MARKS.items() if logo.startswith(mark)), "")


def _read(path: Path) -> bytes:
    with convert_io_errors(path), open_file(path) as file:
        logo = file.read(LARGEST_BYTES + 1)
    if len(logo) > LARGEST_BYTES or not logo_type(logo):
        raise OperationError(
            "logo-unusable",
            display_path(path),
            message("logo-cannot-be-used", largest=quantity(LARGEST_BYTES / 1e6, "MB")),
            message("put-another-logo"),
        )
    return logo

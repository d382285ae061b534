"""The logo of whoever makes reports: a picture in the data folder, or beside a record."""

from collections.abc import Sequence
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.atomic_write import write_atomically
from crenel.formats.file_names import display_path
from crenel.formats.images import decode_image
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import open_file
from crenel.messages.message import Text, message, quantity

NAMES = ("logo.png", "logo.jpg", "logo.jpeg")
MARKS = {b"\x89PNG\r\n\x1a\n": "image/png", b"\xff\xd8\xff": "image/jpeg"}
LARGEST_BYTES = 1_000_000


def read_logo(folder: Path) -> bytes | None:
    """The logo for the report of a record: of the data folder that the record lies in, otherwise
    of its own folder; None where there is none.

    Raises:
        OperationError: it is no PNG or JPEG, damaged, or too large.
    """
    whole = folder.resolve()
    for place in (whole.parent.parent, whole):
        if (logo := read_folder_logo(place)) is not None:
            return logo
    return None


def read_folder_logo(folder: Path) -> bytes | None:
    """The logo in a folder; None where there is none.

    Raises:
        OperationError: as ``read_logo``.
    """
    path = next((folder / name for name in NAMES if (folder / name).is_file()), None)
    if path is None:
        return None
    with convert_io_errors(path), open_file(path) as file:
        logo = file.read(LARGEST_BYTES + 1)
    check_logo(logo, display_path(path), LARGEST_BYTES, message("put-another-logo"))
    return logo


def write_logo(folder: Path, logo: bytes) -> None:
    """Makes a checked picture the logo in a folder, in place of another."""
    name = NAMES[0] if logo_type(logo) == "image/png" else NAMES[1]
    write_atomically(folder / name, logo)
    _remove(folder, [one for one in NAMES if one != name])


def remove_logo(folder: Path) -> None:
    """Removes the logo from a folder; does nothing if there is none."""
    _remove(folder, NAMES)


def logo_type(logo: bytes) -> str:
    """Its media type; empty if it is no picture that a report can have."""
    return next((kind for mark, kind in MARKS.items() if logo.startswith(mark)), "")


def check_logo(logo: bytes, named: Text, largest_bytes: int, remedy: Text) -> None:
    """Refuses what reports cannot show.

    Args:
        named: what an error calls it.

    Raises:
        OperationError: it is no PNG or JPEG, damaged, or too large.
    """
    if len(logo) > largest_bytes or not logo_type(logo):
        largest = quantity(largest_bytes / 1e3, "kB")
        why = message("logo-cannot-be-used", largest=largest)
        raise OperationError("logo-unusable", named, why, remedy)
    try:
        decode_image(logo, named)
    except OperationError as error:
        raise OperationError("logo-unusable", error.what, error.why, remedy) from error


def _remove(folder: Path, names: Sequence[str]) -> None:
    for name in names:
        with convert_io_errors(folder / name):
            (folder / name).unlink(missing_ok=True)

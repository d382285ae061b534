"""Names of files in messages, and file names that are not valid text."""

from contextlib import suppress
from pathlib import Path

from crenel.errors import OperationError
from crenel.messages.message import message

LONGEST_DISPLAYED = 200
_data_folders: list[Path] = []


def register_data_folder(folder: Path) -> None:
    """From here on, messages name files in this data folder relative to it."""
    _data_folders.append(folder.absolute())


def unregister_data_folder(folder: Path) -> None:
    """Undoes ``register_data_folder``; idempotent."""
    with suppress(ValueError):
        _data_folders.remove(folder.absolute())


def display_path(path: Path | str) -> str:
    """The name of a file in messages: relative to the data folder, if a station has it open.

    Browsers need not know the location on the station's disk. Invalid characters are escaped, and
    very long names are reduced to their end.
    """
    text = str(path)
    for folder in _data_folders:
        if text.startswith(f"{folder}/") or text == f"{folder}":
            text = text[len(f"{folder}/") :] or folder.name
            break
    text = escape_unprintable(text)
    return text if len(text) <= LONGEST_DISPLAYED else f"…{text[-LONGEST_DISPLAYED:]}"


def check_name(path: Path) -> None:
    """Raises ``OperationError`` if the name of a file is not valid Unicode, as in Latin-1."""
    try:
        path.name.encode()
    except UnicodeEncodeError as error:
        raise OperationError(
            "name-not-text",
            message("file-name-is-not-utf-8", name=escape_unprintable(path.name)),
            remedy=message("rename"),
        ) from error


def escape_unprintable(text: str, kept: str = "") -> str:
    """The text with all characters except letters, symbols and spaces replaced by their number,
    apart from those in ``kept``."""
    if text.isprintable():
        return text
    return "".join(
        sign if sign.isprintable() or sign in kept else _escape_character(ord(sign))
        for sign in text
    )


def _escape_character(code: int) -> str:
    if code < 0x100:
        return f"\\x{code:02x}"
    return f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"

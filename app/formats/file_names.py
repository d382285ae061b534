"""How messages name files, and names of files that are no valid text."""

from contextlib import suppress
from pathlib import Path

from app.errors import OperationError
from app.messages.message import message

LONGEST_DISPLAYED = 200
_data_folders: list[Path] = []


def register_data_folder(folder: Path) -> None:
    """From here on messages name what is in this data folder as from it."""
    _data_folders.append(folder.absolute())


def unregister_data_folder(folder: Path) -> None:
    """Ends a ``register_data_folder``; idempotent."""
    with suppress(ValueError):
        _data_folders.remove(folder.absolute())


def display_path(path: Path | str) -> str:
    """How a message names a file: as from the data folder, where a station has it open.

    Nobody else's browser needs to know where on the station's disk that is. What is no
    character stands as an escape, and of a very long name its end.
    """
    text = str(path)
    for folder in _data_folders:
        if text.startswith(f"{folder}/") or text == f"{folder}":
            text = text[len(f"{folder}/") :] or folder.name
            break
    text = escape_unprintable(text)
    return text if len(text) <= LONGEST_DISPLAYED else f"…{text[-LONGEST_DISPLAYED:]}"


def check_name(path: Path) -> None:
    """Raises ``OperationError`` where a file's name is no valid Unicode, as in Latin-1."""
    try:
        path.name.encode()
    except UnicodeEncodeError as error:
        raise OperationError(
            "name-not-text",
            message("file-name-is-not-utf-8", name=escape_unprintable(path.name)),
            remedy=message("rename"),
        ) from error


def escape_unprintable(text: str, kept: str = "") -> str:
    """The text with all that is no letter, sign or space as its number, save what is kept."""
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

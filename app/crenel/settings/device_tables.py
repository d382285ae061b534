"""Writes the device tables of ``station.toml``; everything else in the file stays as it is."""

import tomllib
from pathlib import Path
from typing import Any

import tomlkit
from pydantic import ValidationError
from tomlkit.exceptions import ParseError, TOMLKitError
from tomlkit.items import AbstractTable

from crenel.errors import OperationError
from crenel.formats.atomic_write import write_atomically
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import read_bounded
from crenel.messages.message import message
from crenel.settings.settings import DeviceKind, DeviceTable, Settings

BACKUP = ".backup"
"""Ending of the copy of the file as it was before the last change."""


def write_device(path: Path, kind: DeviceKind, table: DeviceTable | None) -> None:
    """Writes one device table, or takes it out; the file is created if there is none.

    Comments, order and the other tables stay. The file before is kept beside it, with the ending
    ``.backup``.

    Raises:
        OperationError: the file is no longer valid, cannot be read or cannot be written; it is
            then as before.
    """
    before = _read(path)
    after = _text_with(path, before, kind, table)
    try:
        Settings.model_validate(tomllib.loads(after), context=path)
    except (tomllib.TOMLDecodeError, ValidationError) as error:
        raise _not_valid_error(path, error) from error
    if before:
        write_atomically(path.with_name(path.name + BACKUP), before.encode())
    with convert_io_errors(path):
        path.parent.mkdir(parents=True, exist_ok=True)
    write_atomically(path, after.encode())


def _read(path: Path) -> str:
    if not path.exists():
        return ""
    try:
        with convert_io_errors(path):
            return read_bounded(path).decode()
    except UnicodeDecodeError as error:
        raise _not_valid_error(path, error) from error


def _text_with(path: Path, before: str, kind: DeviceKind, table: DeviceTable | None) -> str:
    """The text of the file after the change."""
    try:
        document = tomlkit.parse(before)
    except TOMLKitError as error:
        raise _not_valid_error(path, error) from error
    if table is None:
        document.pop(kind, None)
        return tomlkit.dumps(document)
    values: dict[str, Any] = {"driver": table.driver}
    values |= {"label": table.label} if table.label else {}
    values |= table.options
    present = document.get(kind)
    if isinstance(present, AbstractTable):
        _update(present, values)
    else:
        document.pop(kind, None)
        _append(document, kind, values)
    return tomlkit.dumps(document)


def _update(present: AbstractTable, values: dict[str, Any]) -> None:
    """Changes only what differs: comments beside the other keys stay."""
    for key in [one for one in present if one not in values]:
        present.remove(key)
    body = present.value.body
    # what stands between the last key and the next table stays there
    keyed = [place for place, (key, _) in enumerate(body) if key is not None]
    first = keyed[-1] + 1 if keyed else 0
    after, body[first:] = body[first:], []
    for key, value in values.items():
        if key not in present or present[key] != value:
            present[key] = value
    body.extend(after)


def _append(document: tomlkit.TOMLDocument, kind: DeviceKind, values: dict[str, Any]) -> None:
    table = tomlkit.table()
    table.update(values)
    if document.body and not tomlkit.dumps(document).endswith("\n\n"):
        document.add(tomlkit.nl())
    document[kind] = table


def _not_valid_error(path: Path, error: Exception) -> OperationError:
    why = message("station-toml-is-not-toml")
    if isinstance(error, ParseError):
        why = message("station-toml-error-in-line", line=error.line)
    elif isinstance(error, ValidationError):
        place = ".".join(str(part) for part in error.errors()[0]["loc"])
        why = message("station-toml-error-in-key", key=place)
    return OperationError(
        "settings-not-valid",
        message("station-toml-not-changed", file=path.name),
        why,
        message("correct-the-file-first"),
    )

"""Finds and reads ``station.toml``, and with the same functions ``fleet.toml``; docs/formats.md and
docs/fleet.md show every table and key."""

import tomllib
from pathlib import Path
from typing import TypeVar

from pydantic import BaseModel, ValidationError

from crenel.errors import OperationError
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import read_bounded
from crenel.messages.message import Text, message
from crenel.messages.validation import validation_text
from crenel.settings.settings import Settings

Tables = TypeVar("Tables", bound=BaseModel)
DEFAULT_FILE = "station.toml"
DOCUMENT = "docs/formats.md"
TABLE_NAME = "[key]"
"""Pydantic's word for the name of a table that anyone may choose."""
BY_TYPE = {
    "string_type": message("settings-must-be-quoted"),
    "is_instance_of": message("settings-must-be-quoted"),
    "string_too_short": message("value-empty"),
    "tuple_type": message("settings-must-be-list"),
    "model_type": message("settings-must-be-table"),
}
"""What a value must be, where TOML's own words say it better than ``validation_text``."""
BY_PATTERN = {
    "address": message("settings-must-be-web-address"),
    "prefix": message("settings-must-be-topic-prefix"),
    "station": message("settings-must-be-station-name"),
}


def read_settings(path: Path | None) -> Settings:
    """Reads ``station.toml``, by default the one in the working folder.

    Raises:
        OperationError: there is no such file, it is not TOML, a key is missing, unknown or of
            the wrong kind, values do not go together, or a file that is named is not there.
    """
    what_it_is, remedy = message("settings-states-devices"), message("settings-write-one")
    return read_tables(find_file(path, DEFAULT_FILE, remedy, what_it_is), Settings)


def find_file(path: Path | None, default: str, remedy: Text, why: Text = "") -> Path:
    """The file of settings that was named, by default the one in the working folder.

    Args:
        remedy: for a file that is not there.
        why: such a file is needed.

    Raises:
        OperationError: there is no such file.
    """
    path = path or Path(default)
    if not path.exists():
        what = message("settings-missing", path=path)
        raise OperationError("settings-missing", what, why, remedy)
    return path


def read_tables(path: Path, model: type[Tables], document: str = DOCUMENT) -> Tables:
    """Reads a file of settings, whose path is the context of the validation.

    Args:
        document: shows its tables and keys.

    Raises:
        OperationError: it is not TOML, a key is missing, unknown or of the wrong kind, values do
            not go together, or a file that is named is not there.
    """
    with convert_io_errors(path):
        raw = read_bounded(path)
    try:
        return model.model_validate(tomllib.loads(raw.decode()), context=path)
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        why = message("settings-not-toml", reason=error)
        raise OperationError("settings-not-toml", str(path), why) from error
    except ValidationError as error:
        raise _invalid(path, error, document) from error


def _invalid(path: Path, error: ValidationError, document: str) -> OperationError:
    first = error.errors(include_url=False)[0]
    kind, file, place = first["type"], str(path), [str(part) for part in first["loc"]]
    by_pattern = BY_PATTERN.get(place[-1], BY_PATTERN["station"])
    if place[-1] == TABLE_NAME:
        what = message("settings-table-name", file=file, table=".".join(place[:-1]))
        why = message("settings-not-as-shown", document=document)
        if kind == "string_pattern_mismatch":
            why = by_pattern
        return OperationError("settings-key-invalid", what, why, message("rename"))
    named = message("settings-table", file=file, table=place[0])
    if key := ".".join(place[1:]):
        named = message("settings-key", file=file, table=place[0], key=key)
    if kind == "missing":
        remedy = message("settings-add-as-shown", document=document)
        what = message("settings-is-missing", named=named)
        return OperationError("settings-key-missing", what, remedy=remedy)
    if kind == "extra_forbidden":
        what, remedy = message("settings-is-unknown", named=named), message("settings-correct-name")
        return OperationError("settings-key-unknown", what, remedy=remedy)
    must_be = BY_TYPE.get(kind) or validation_text(first)
    if kind == "string_pattern_mismatch":
        must_be = by_pattern
    what = message("settings-value-is", named=named, value=repr(first["input"]))
    return OperationError("settings-key-invalid", what, must_be, message("correct-it"))

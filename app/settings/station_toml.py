"""Reads ``station.toml``; docs/formats.md shows every table and key."""

import tomllib
from pathlib import Path
from typing import TypeVar

from pydantic import BaseModel, ValidationError

from app.errors import OperationError
from app.formats.io_errors import convert_io_errors
from app.formats.open_file import read_bounded
from app.messages.validation import validation_text
from app.settings.settings import Settings

Tables = TypeVar("Tables", bound=BaseModel)
DEFAULT_FILE = "station.toml"
DOCUMENT = "docs/formats.md"
TABLE_NAME = "[key]"
"""Pydantic's word for the name of a table that anyone may choose."""
WORDS = {
    "string_type": "it must be text in quotes",
    "is_instance_of": "it must be text in quotes",
    "string_too_short": "it is empty",
    "tuple_type": 'it must be a list, as ["one", "two"]',
    "int_type": "it must be a whole number",
    "float_type": "it must be a number",
    "bool_type": "it must be true or false",
    "model_type": "it must be a table",
}
"""Of what does not fit; the rest says it well enough."""
PATTERN_WORDS = {
    "address": "it must begin with http:// or https:// and name a host",
    "prefix": "it must be words with / between them, without spaces, # and +",
    "station": "it must be lower-case letters, digits and hyphens, 40 at most",
}


def read_settings(path: Path | None) -> Settings:
    """Reads ``station.toml``, by default the one in the working folder.

    Raises:
        OperationError: there is no such file, it is not TOML, a key is missing, unknown or of
            the wrong kind, values do not go together, or a file that is named is not there.
    """
    path = path or Path(DEFAULT_FILE)
    if not path.exists():
        raise OperationError(
            "settings-missing",
            f"{path}: there is no such file",
            "it states which arm and which sensor are connected",
            "Write one as docs/operating.md shows, name another with --config, or try crenel demo",
        )
    return read_tables(path, Settings)


def read_tables(path: Path, model: type[Tables], document: str = DOCUMENT) -> Tables:
    """Reads a file of settings, whose path is the context of the validation.

    Args:
        document: shows its tables and keys.

    Raises:
        OperationError: as ``read_settings``, for a file that is there.
    """
    with convert_io_errors(path):
        raw = read_bounded(path)
    try:
        return model.model_validate(tomllib.loads(raw.decode()), context=path)
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise OperationError("settings-not-toml", str(path), f"it is not TOML: {error}") from error
    except ValidationError as error:
        raise _invalid(path, error, document) from error


def _invalid(path: Path, error: ValidationError, document: str) -> OperationError:
    first = error.errors(include_url=False)[0]
    place = [str(part) for part in first["loc"]]
    if place[-1] == TABLE_NAME:
        what = f"{path}: the name of the table [{'.'.join(place[:-1])}]"
        why = f"it is not as {document} shows"
        if first["type"] == "string_pattern_mismatch":
            why = PATTERN_WORDS["station"]
        return OperationError("settings-key-invalid", what, why, "Rename it")
    table = f"[{place[0]}]"
    key = ".".join(place[1:])
    named = f"{path}, {table}: {key}" if key else f"{path}: the table {table}"
    if first["type"] == "missing":
        remedy = f"Add it as {document} shows"
        return OperationError("settings-key-missing", f"{named} is missing", remedy=remedy)
    if first["type"] == "extra_forbidden":
        return OperationError(
            "settings-key-unknown", f"{named} is unknown", remedy="Correct its name"
        )
    words = WORDS.get(first["type"])
    if first["type"] == "string_pattern_mismatch":
        words = PATTERN_WORDS.get(place[-1], PATTERN_WORDS["station"])
    return OperationError(
        "settings-key-invalid",
        f"{named} = {first['input']!r}",
        validation_text(first) if words is None else words,
        "Correct it",
    )

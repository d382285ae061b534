"""What the tables of ``station.toml`` are made of."""

import ssl
from pathlib import Path
from typing import Annotated

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationInfo
from pydantic_core import PydanticKnownError

from crenel.errors import OperationError
from crenel.formats.open_file import check_ordinary, read_bounded
from crenel.messages.message import Text, message


class TomlTable(BaseModel):
    """Its values are of their own kind, and keys that it does not know are refused."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)


def _resolve(value: object, info: ValidationInfo) -> object:
    if not isinstance(value, str):
        return value
    if not value:
        raise PydanticKnownError("string_too_short", {"min_length": 1})
    assert isinstance(info.context, Path)
    return info.context.absolute().parent / Path(value).expanduser()


SettingsPath = Annotated[Path, BeforeValidator(_resolve)]
"""Relative ones are beside the file, whose own path is the context of the validation."""
NonEmpty = Annotated[str, Field(min_length=1)]
Limit = Annotated[float, Field(gt=0, le=10_000, allow_inf_nan=False)]


def read_secret(path: Path, code: str, remedy: Text) -> str:
    """The content of a file that contains only a password or a key, without the line ending.

    Raises:
        OperationError: ``code``, it cannot be read.
    """
    try:
        return read_bounded(path).decode().rstrip("\r\n")
    except (OSError, UnicodeDecodeError) as error:
        reason = str(getattr(error, "strerror", None) or error)
        what = message("password-file-cannot-be-read", password_file=path)
        raise OperationError(code, what, reason, remedy) from error


def check_authority(file: Path, code: str, table: str, remedy: Text) -> None:
    """Checks the certificates of an authority.

    Args:
        code: of the error.
        table: the table with the key ``ca_file``, with the path of its file.
        remedy: which certificates to give.

    Raises:
        OperationError: the file is not there, or holds no certificates.
    """
    try:
        check_ordinary(file)
        ssl.create_default_context(cafile=file)
    except OSError as error:  # those of TLS are of this kind
        unreadable = isinstance(error, ssl.SSLError)
        raise OperationError(
            code,
            f"{table}: ca_file = {str(file)!r}",
            message("authority-holds-none") if unreadable else message("no-such-file"),
            remedy,
        ) from error

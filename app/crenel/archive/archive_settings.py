"""``[archive]`` of station.toml: where finished records go, and how long the station keeps its own
copies."""

from pathlib import Path
from typing import Annotated, Self
from urllib.parse import urlsplit

from pydantic import AfterValidator, Field, ValidationInfo, model_validator

from crenel.errors import OperationError
from crenel.formats.settings.toml_table import NonEmpty, SettingsPath, TomlTable, read_secret
from crenel.messages.message import message

REMOTE = "://"
"""In the address of a store that is no folder."""


def _resolve_folder(place: str, info: ValidationInfo) -> str:
    if REMOTE in place:
        return place
    assert isinstance(info.context, Path)
    return str(info.context.absolute().parent / Path(place).expanduser())


class ArchiveSettings(TomlTable):
    """``[archive]`` of station.toml."""

    url: Annotated[NonEmpty, AfterValidator(_resolve_folder)]
    """A folder, or an address of fsspec such as ``s3://bucket/station``."""
    endpoint: NonEmpty | None = None
    """The address of an S3-compatible store; None: that of AWS."""
    access_key: NonEmpty | None = None
    secret_file: SettingsPath | None = None
    """Contains only the secret key."""
    scan_rate_mb_s: Annotated[float, Field(ge=0.1, le=1000, allow_inf_nan=False)] = 2.0
    """At most this while a scan runs."""
    keep_days: Annotated[float, Field(ge=1, le=36_500, allow_inf_nan=False)] | None = None
    """The station keeps its copies for this long; without it, for ever."""
    free_gb: Annotated[float, Field(gt=0, le=1_000_000, allow_inf_nan=False)] | None = None
    """With less free on its disk, the station removes its oldest archived copies earlier."""

    @model_validator(mode="after")
    def _check_keys(self, info: ValidationInfo) -> Self:
        if (self.access_key is None) != (self.secret_file is None):
            raise OperationError(
                "settings-archive",
                message("archive-key-alone", file=str(info.context)),
                message("archive-keys-belong-together"),
                message("archive-give-both-keys"),
            )
        return self

    @property
    def is_folder(self) -> bool:
        """Whether the archive is a folder or a mount of this machine."""
        return REMOTE not in self.url

    @property
    def place(self) -> str:
        """The archive in messages: without a user and a password in its address."""
        if self.is_folder:
            return self.url
        parts = urlsplit(self.url)
        return f"{parts.scheme}://{parts.netloc.rpartition('@')[2]}{parts.path}"

    def secret(self) -> str | None:
        """The content of the secret file, without the line ending.

        Raises:
            OperationError: it cannot be read.
        """
        if self.secret_file is None:
            return None
        return read_secret(self.secret_file, "archive-secret", message("archive-name-secret-file"))

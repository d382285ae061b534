"""The broker of a station, and its user."""

from typing import Annotated

from pydantic import Field

from crenel.formats.settings.toml_table import NonEmpty, SettingsPath, TomlTable, read_secret
from crenel.messages.message import message


class BrokerSettings(TomlTable):
    """``[mqtt]`` of station.toml."""

    host: NonEmpty
    port: Annotated[int, Field(ge=1, le=65535)] = 1883
    user: NonEmpty | None = None
    password_file: SettingsPath | None = None
    tls: bool = False
    ca_file: SettingsPath | None = None
    prefix: Annotated[str, Field(pattern=r"^[^#+/\s]+(/[^#+/\s]+)*$", max_length=80)] = "crenel"
    station: Annotated[str, Field(pattern="^[a-z0-9-]{1,40}$")] | None = None
    """As a part of topics; else by the station's name."""

    @property
    def is_encrypted(self) -> bool:
        return self.tls or self.ca_file is not None

    def password(self) -> str | None:
        """The content of the password file, without the line ending.

        Raises:
            OperationError: it cannot be read.
        """
        if self.password_file is None:
            return None
        remedy = message("name-file-holds-brokers-password-alone")
        return read_secret(self.password_file, "mqtt-password", remedy)

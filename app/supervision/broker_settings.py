"""Which broker a station talks to, and as whom."""

from dataclasses import dataclass
from pathlib import Path

from app.errors import OperationError
from app.formats.open_file import read_bounded
from app.messages.message import message


@dataclass(frozen=True)
class BrokerSettings:
    """``[mqtt]`` of station.toml."""

    host: str
    port: int = 1883
    user: str | None = None
    password_file: Path | None = None
    tls: bool = False
    ca_file: Path | None = None
    prefix: str = "crenel"
    station: str | None = None
    """As a part of topics; else by the station's name."""

    def password(self) -> str | None:
        """What the password file holds, without the line's end.

        Raises:
            OperationError: it cannot be read.
        """
        if self.password_file is None:
            return None
        try:
            return read_bounded(self.password_file).decode().rstrip("\r\n")
        except (OSError, UnicodeDecodeError) as error:
            raise OperationError(
                "mqtt-password",
                message("cannot-read-2", password_file=self.password_file),
                str(getattr(error, "strerror", None) or error),
                message("name-file-holds-brokers-password-alone"),
            ) from error

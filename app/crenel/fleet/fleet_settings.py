"""``fleet.toml``: the catalogue's database, the stations, their archives or data folders, and the
broker."""

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Self
from urllib.parse import quote

from pydantic import AfterValidator, Field, ValidationInfo, model_validator

from crenel.archive.archive_settings import ArchiveSettings
from crenel.archive.place import local_folder
from crenel.errors import OperationError
from crenel.fleet.collection.collector import CollectedStation
from crenel.fleet.collection.places import ArchivePlace, FolderPlace, RecordPlace
from crenel.formats.settings.toml_table import NonEmpty, SettingsPath, TomlTable, read_secret
from crenel.messages.message import message
from crenel.settings.settings import Serving
from crenel.settings.station_toml import find_file, read_tables
from crenel.single_sign_on.settings import SignInSettings
from crenel.supervision.broker_settings import BrokerSettings

DEFAULT_FILE = "fleet.toml"
DOCUMENT = "docs/fleet.md"
ACCOUNTS_FILE = "fleet-accounts.db"
CLOUDS_FOLDER = "fleet-clouds"
SQLITE = "sqlite:///"
StationId = Annotated[str, Field(pattern="^[a-z0-9-]{1,40}$")]


def _resolve_database(url: str, info: ValidationInfo) -> str:
    """A path of SQLite is relative to the file of the settings."""
    if not url.startswith(SQLITE):
        return url
    assert isinstance(info.context, Path)
    path = info.context.absolute().parent / Path(url.removeprefix(SQLITE)).expanduser()
    return f"{SQLITE}{path}"


class CatalogueSettings(TomlTable):
    """``[catalogue]`` of fleet.toml."""

    database: Annotated[NonEmpty, AfterValidator(_resolve_database)]
    password_file: SettingsPath | None = None
    """Contains only the password of the user in ``database``."""
    look_s: Annotated[float, Field(ge=1, le=86_400, allow_inf_nan=False)] = 60.0
    """Between two looks for new records."""

    def url(self) -> str:
        """The address with the password.

        Raises:
            OperationError: its file cannot be read.
        """
        if self.password_file is None:
            return self.database
        scheme, _, rest = self.database.partition("://")
        user, _, place = rest.rpartition("@")
        remedy = message("fleet-name-password-file")
        password = read_secret(self.password_file, "catalogue-password", remedy)
        return f"{scheme}://{user}:{quote(password, safe='')}@{place}"


class StationPlaces(TomlTable):
    """``[stations.ID]`` of fleet.toml; the id is that of the station's topics."""

    name: str = ""
    archive: ArchiveSettings | None = None
    data: SettingsPath | None = None
    """Its data folder, of a station on this machine."""

    def own_places(self) -> Iterator[tuple[str, str]]:
        """Its places for messages, each after what tells it from all others."""
        if self.data is not None:
            yield os.path.realpath(self.data), str(self.data)
        if self.archive is not None:
            folder = local_folder(self.archive)
            same = os.path.realpath(folder) if folder else self.archive.url.rstrip("/")
            yield f"{self.archive.endpoint or ''} {same}".strip(), self.archive.place

    def places(self) -> list[RecordPlace]:
        """Where its records are collected: its own disk first, which knows the names of today."""
        found: list[RecordPlace] = []
        if self.data is not None:
            found.append(FolderPlace(self.data))
        if self.archive is not None:
            found.append(ArchivePlace(self.archive))
        return found


class FleetServerSettings(Serving):
    """``[server]`` of fleet.toml."""

    password_file: SettingsPath | None = None
    """Contains only the password of the page."""
    accounts: SettingsPath | None = None
    """The file with the people who signed in; by default ``fleet-accounts.db`` beside
    ``fleet.toml``."""

    def password(self) -> str:
        """The password of the page, empty if there is none.

        Raises:
            OperationError: its file cannot be read, or is empty.
        """
        if self.password_file is None:
            return ""
        remedy = message("fleet-name-page-password")
        password = read_secret(self.password_file, "fleet-password", remedy)
        if not password:
            what = message("fleet-password-empty", file=self.password_file)
            raise OperationError("fleet-password", what, remedy=remedy)
        return password


class CloudSettings(TomlTable):
    """``[clouds]`` of fleet.toml: the clouds that are made on demand."""

    folder: SettingsPath | None = None
    """In which they are kept; by default ``fleet-clouds`` beside ``fleet.toml``."""
    limit_gb: Annotated[float, Field(ge=0.1, le=1_000_000, allow_inf_nan=False)] = 20.0
    """The size of all clouds that are kept; those that were not used for longest are removed."""
    scheduler: NonEmpty | None = None
    """The address of Dask's scheduler, whose workers make the clouds; without it, a process of the
    server does. Whoever reaches it runs programs on the workers, and on this server."""


class FleetSettings(TomlTable):
    """The whole file."""

    catalogue: CatalogueSettings
    server: FleetServerSettings = FleetServerSettings()
    stations: dict[StationId, StationPlaces] = Field(default_factory=dict)
    mqtt: BrokerSettings | None = None
    sign_in: SignInSettings | None = None
    clouds: CloudSettings = CloudSettings()

    @model_validator(mode="after")
    def _check_stations(self, info: ValidationInfo) -> Self:
        """Each station needs a place, and one of its own: else each record would be listed for
        several stations."""
        file, owners = str(info.context), dict[str, str]()
        for station, places in self.stations.items():
            if not any(places.own_places()):
                raise OperationError(
                    "fleet-station-place",
                    message("fleet-station-has-no-place", file=file, station=station),
                    remedy=message("fleet-give-place"),
                )
            for same, place in places.own_places():
                if (other := owners.setdefault(same, station)) != station:
                    raise OperationError(
                        "fleet-shared-place",
                        message(
                            "fleet-stations-share-place",
                            file=file,
                            station=station,
                            other=other,
                            place=place,
                        ),
                        remedy=message("fleet-give-own-place"),
                    )
        return self

    def list_stations(self) -> list[CollectedStation]:
        """The stations with their places, as the file lists them."""
        return [
            CollectedStation(station, places.name, places.places())
            for station, places in self.stations.items()
        ]


def read_fleet_settings(path: Path | None) -> FleetSettings:
    """Reads ``fleet.toml``, by default the one in the working folder.

    Raises:
        OperationError: there is no such file, or it is not as docs/fleet.md describes.
    """
    file = find_file(path, DEFAULT_FILE, message("fleet-write-settings"))
    return read_tables(file, FleetSettings, DOCUMENT)

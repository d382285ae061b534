"""What a station works with: its name, its data folder, its devices and its limits."""

import ipaddress
import os
import ssl
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from app.errors import OperationError
from app.formats.datasheets.gauge import DEFAULT_LIMITS, VerificationLimits
from app.formats.open_file import check_ordinary
from app.guide.common.validity import DUE, DueLimits
from app.metrology.limits import Limits
from app.settings.station_toml import LimitsTable, MqttTable, StationTable, read_file
from app.supervision.broker_settings import BrokerSettings

DEFAULT_FILE = "station.toml"


@dataclass(frozen=True)
class DeviceSettings:
    """A driver's name and its own options."""

    driver: str
    options: Mapping[str, object]


@dataclass(frozen=True)
class Serving:
    """How browsers reach the station."""

    tls_certificate: Path | None = None
    tls_key: Path | None = None
    proxies: tuple[str, ...] = ()


@dataclass(frozen=True)
class Settings:
    """One station."""

    name: str
    data: Path
    hosts: tuple[str, ...]
    arm: DeviceSettings
    sensor: DeviceSettings
    limits: Limits
    serving: Serving
    address: str = ""
    backups: Path | None = None
    mqtt: BrokerSettings | None = None
    temperature: Path | None = None
    verification: VerificationLimits = DEFAULT_LIMITS
    due: DueLimits = DUE


def read_settings(path: Path | None) -> Settings:
    """Reads ``station.toml``, by default the one in the working folder.

    Raises:
        OperationError: as ``read_file``; or values do not go together, or a file that is named is
            not there.
    """
    path = path or Path(DEFAULT_FILE)
    document = read_file(path)
    station = document.station
    data = Path(station.data).expanduser() if station.data else user_data_folder() / "station"
    return Settings(
        name=station.name,
        data=path.absolute().parent / data,
        hosts=tuple(station.hosts),
        arm=DeviceSettings(document.arm.driver, document.arm.model_extra or {}),
        sensor=DeviceSettings(document.sensor.driver, document.sensor.model_extra or {}),
        limits=_limits(path, document.limits),
        serving=_serving(path, station),
        address=station.address or "",
        backups=_resolve_path(path, station.backups),
        mqtt=_mqtt(path, document.mqtt),
        temperature=_resolve_path(
            path, document.temperature.file if document.temperature else None
        ),
        verification=document.verification.with_defaults(DEFAULT_LIMITS),
        due=DueLimits(**document.due.model_dump()),
    )


def _resolve_path(path: Path, file: str | None) -> Path | None:
    """A path as the settings' file has it: relative ones are beside it."""
    return None if file is None else path.absolute().parent / Path(file).expanduser()


def _mqtt(path: Path, table: MqttTable | None) -> BrokerSettings | None:
    """Raises ``OperationError`` where a file is not there or cannot be read."""
    if table is None:
        return None
    settings = BrokerSettings(
        host=table.host,
        port=table.port,
        user=table.user,
        password_file=_resolve_path(path, table.password_file),
        tls=table.tls,
        ca_file=_resolve_path(path, table.ca_file),
        prefix=table.prefix,
        station=table.station,
    )
    settings.password()
    if settings.ca_file is not None:
        try:
            check_ordinary(settings.ca_file)
            ssl.create_default_context(cafile=settings.ca_file)
        except OSError as error:  # those of TLS are of this kind
            unreadable = isinstance(error, ssl.SSLError)
            raise OperationError(
                "settings-mqtt",
                f"{path}, [mqtt]: ca_file = {str(settings.ca_file)!r}",
                "it holds no certificates" if unreadable else "there is no such file",
                "Give the certificates of the broker's authority in PEM format",
            ) from error
    return settings


def _serving(path: Path, station: StationTable) -> Serving:
    given = {"tls_certificate": station.tls_certificate, "tls_key": station.tls_key}
    files = {
        name: path.absolute().parent / Path(file).expanduser()
        for name, file in given.items()
        if file is not None
    }
    if len(files) == 1:
        raise OperationError(
            "settings-tls",
            f"{path}, [station]: {next(iter(files))} is given alone",
            "certificate and key belong together",
            "Give both tls_certificate and tls_key, or neither",
        )
    for name, file in files.items():
        if not file.is_file():
            raise OperationError(
                "settings-tls",
                f"{path}, [station]: {name} = {str(file)!r}",
                "there is no such file",
                "Give the file in PEM format",
            )
    for proxy in station.proxies:
        try:
            ipaddress.ip_network(proxy, strict=False)
        except ValueError as error:
            raise OperationError(
                "settings-proxies",
                f"{path}, [station]: proxies has {proxy!r}",
                "it is no address",
                'Give the address from which the proxy connects, as "10.0.0.5" or "10.0.0.0/24"',
            ) from error
    return Serving(files.get("tls_certificate"), files.get("tls_key"), tuple(station.proxies))


def _limits(path: Path, table: LimitsTable) -> Limits:
    if table.usable_um < table.good_um:
        raise OperationError(
            "settings-limits",
            f"{path}, [limits]: usable_um = {table.usable_um:g} is below good_um = "
            f"{table.good_um:g}",
            "what is good must be usable",
            "Give usable_um the larger value",
        )
    return Limits(table.good_um, table.usable_um)


def user_data_folder() -> Path:
    """Where a program keeps what is this user's: by the XDG convention, or Windows' own."""
    if os.name == "nt" and "LOCALAPPDATA" in os.environ:
        return Path(os.environ["LOCALAPPDATA"]) / "Crenel"
    home = os.environ.get("XDG_DATA_HOME") or Path.home() / ".local" / "share"
    return Path(home) / "crenel"

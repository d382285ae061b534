"""``station.toml``: the station's name, its data folder and its devices.

[station]
name = "Measuring room 2"
data = "data"                 # beside this file; --data goes before it
hosts = ["station.local"]     # further names browsers may use; localhost always may
tls_certificate = "cert.pem"  # with the key: the station is served over HTTPS
tls_key = "key.pem"
proxies = ["10.0.0.5"]        # theirs alone is the word on where a browser is, and on HTTPS
address = "http://10.0.0.7:8000/"  # of its pages, for the stations that link to them
backups = "/mnt/backup/crenel"     # where the Health page's button puts them

[arm]
driver = "serial-encoder"     # every other key is the driver's own
url = "/dev/ttyUSB0"

[sensor]
driver = "opencv"
source = 0

[limits]                      # of a scanned point's standard uncertainty, k = 1
good_um = 50                  # up to here a calibration is good
usable_um = 150               # beyond, it is not to be used

[verification]                # largest values accepted on a gauge whose paper sets none; µm, arcsec
form = 300
rms = 80                      # and angle, offset, radius_error, centre_error, angle_range,
offset_range = 200            # offset_range, centre_range

[due]                         # when what is to be done again
calibration_days = 30
verification_days = 7
arm_days = 30
tip_hours = 24
temperature_c = 3             # of change since the calibration

[mqtt]                        # optional: tells other stations of this one, and shows them here
host = "broker.local"
port = 1883
user = "station"
password_file = "mqtt-password"
tls = false                   # by the authorities of this machine, or by
ca_file = "ca.pem"
prefix = "crenel"             # of all topics, the same at all stations
station = "room-2"            # in the topics of this one; else by its name

[temperature]                 # optional: of the room
file = "/sys/bus/w1/devices/28-0316a4d5e6ff/temperature"  # thousandths of a degree Celsius
"""

import ipaddress
import os
import ssl
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from app.files.failures import files_refused
from app.files.gauge import DEFAULT_LIMITS, VerificationLimits
from app.guide.due import DUE, DueLimits
from app.metrology.findings import LIMITS, Limits
from app.metrology.refusal import Refusal
from app.supervise.broker import BrokerSettings

DEFAULT_FILE = "station.toml"
WORDS = {
    "string_type": "it must be text in quotes",
    "string_too_short": "it is empty",
    "list_type": 'it must be a list, as ["one", "two"]',
    "int_type": "it must be a whole number",
    "float_type": "it must be a number",
    "bool_type": "it must be true or false",
    "model_type": "it must be a table",
}
"""Of what does not fit; the rest says it well enough."""
PATTERN_WORDS = {
    "address": "it must begin with http:// or https:// and name a machine",
    "prefix": "it must be words with / between them, without spaces, # and +",
    "station": "it must be small letters, digits and hyphens, 40 at most",
}
LimitUm = Annotated[float, Field(gt=0, le=10_000, allow_inf_nan=False)]


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


class _StationTable(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)

    name: Annotated[str, Field(min_length=1, max_length=60)] = "Crenel"
    data: Annotated[str, Field(min_length=1)] | None = None
    hosts: list[Annotated[str, Field(min_length=1)]] = []
    tls_certificate: Annotated[str, Field(min_length=1)] | None = None
    tls_key: Annotated[str, Field(min_length=1)] | None = None
    proxies: list[Annotated[str, Field(min_length=1)]] = list(Serving.proxies)
    address: Annotated[str, Field(max_length=200, pattern="^https?://[^/]")] | None = None
    backups: Annotated[str, Field(min_length=1)] | None = None


class _DeviceTable(BaseModel):
    model_config = ConfigDict(extra="allow", strict=True)

    driver: Annotated[str, Field(min_length=1)]


class _LimitsTable(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)

    good_um: LimitUm = LIMITS.good_um
    usable_um: LimitUm = LIMITS.usable_um


class _MqttTable(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)

    host: Annotated[str, Field(min_length=1)]
    port: Annotated[int, Field(ge=1, le=65535)] = BrokerSettings.port
    user: Annotated[str, Field(min_length=1)] | None = None
    password_file: Annotated[str, Field(min_length=1)] | None = None
    tls: bool = BrokerSettings.tls
    ca_file: Annotated[str, Field(min_length=1)] | None = None
    prefix: Annotated[str, Field(pattern=r"^[^#+/\s]+(/[^#+/\s]+)*$", max_length=80)] = (
        BrokerSettings.prefix
    )
    station: Annotated[str, Field(pattern="^[a-z0-9-]{1,40}$")] | None = None


class _TemperatureTable(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)

    file: Annotated[str, Field(min_length=1)]


class _VerificationTable(VerificationLimits):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


Span = Annotated[float, Field(gt=0, le=10_000, allow_inf_nan=False)]


class _DueTable(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)

    calibration_days: Span = DUE.calibration_days
    verification_days: Span = DUE.verification_days
    arm_days: Span = DUE.arm_days
    tip_hours: Span = DUE.tip_hours
    temperature_c: Span = DUE.temperature_c


class _File(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)

    station: _StationTable = _StationTable()
    arm: _DeviceTable
    sensor: _DeviceTable
    limits: _LimitsTable = _LimitsTable()
    verification: _VerificationTable = _VerificationTable()
    due: _DueTable = _DueTable()
    mqtt: _MqttTable | None = None
    temperature: _TemperatureTable | None = None


def read_settings(path: Path | None) -> Settings:
    """Reads ``station.toml``, by default the one in the working folder.

    Raises:
        Refusal: there is no such file, it is not TOML, or a key is missing, unknown
            or of the wrong kind; the key is named.
    """
    path = path or Path(DEFAULT_FILE)
    if not path.exists():
        raise Refusal(
            "settings-missing",
            f"{path}: there is no such file",
            "it says which arm and which sensor are connected",
            "Write one as the README shows, name another with --config, or try crenel demo",
        )
    with files_refused(path):
        raw = path.read_bytes()
    try:
        sheet = _File.model_validate(tomllib.loads(raw.decode()))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise Refusal("settings-not-toml", str(path), f"it is not TOML: {error}") from error
    except ValidationError as error:
        raise _invalid(path, error) from error
    station = sheet.station
    data = Path(station.data).expanduser() if station.data else user_data_folder() / "station"
    return Settings(
        name=station.name,
        data=path.absolute().parent / data,
        hosts=tuple(station.hosts),
        arm=DeviceSettings(sheet.arm.driver, sheet.arm.model_extra or {}),
        sensor=DeviceSettings(sheet.sensor.driver, sheet.sensor.model_extra or {}),
        limits=_limits(path, sheet.limits),
        serving=_serving(path, station),
        address=station.address or "",
        backups=_beside(path, station.backups),
        mqtt=_mqtt(path, sheet.mqtt),
        temperature=_beside(path, sheet.temperature.file if sheet.temperature else None),
        verification=sheet.verification.over(DEFAULT_LIMITS),
        due=DueLimits(**sheet.due.model_dump()),
    )


def _beside(path: Path, file: str | None) -> Path | None:
    """A path as the settings' file has it: relative ones are beside it."""
    return None if file is None else path.absolute().parent / Path(file).expanduser()


def _mqtt(path: Path, table: _MqttTable | None) -> BrokerSettings | None:
    """Raises ``Refusal`` where a file is not there or cannot be read."""
    if table is None:
        return None
    settings = BrokerSettings(
        host=table.host,
        port=table.port,
        user=table.user,
        password_file=_beside(path, table.password_file),
        tls=table.tls,
        ca_file=_beside(path, table.ca_file),
        prefix=table.prefix,
        station=table.station,
    )
    settings.password()
    if settings.ca_file is not None:
        try:
            ssl.create_default_context(cafile=settings.ca_file)
        except OSError as error:  # those of TLS are of this kind
            unreadable = isinstance(error, ssl.SSLError)
            raise Refusal(
                "settings-mqtt",
                f"{path}, [mqtt]: ca_file = {str(settings.ca_file)!r}",
                "it holds no certificates" if unreadable else "there is no such file",
                "Give the certificates of the broker's authority in PEM format",
            ) from error
    return settings


def _serving(path: Path, station: _StationTable) -> Serving:
    given = {"tls_certificate": station.tls_certificate, "tls_key": station.tls_key}
    files = {
        name: path.absolute().parent / Path(file).expanduser()
        for name, file in given.items()
        if file is not None
    }
    if len(files) == 1:
        raise Refusal(
            "settings-tls",
            f"{path}, [station]: {next(iter(files))} is given alone",
            "certificate and key belong together",
            "Give both tls_certificate and tls_key, or neither",
        )
    for name, file in files.items():
        if not file.is_file():
            raise Refusal(
                "settings-tls",
                f"{path}, [station]: {name} = {str(file)!r}",
                "there is no such file",
                "Give the file in PEM format",
            )
    for proxy in station.proxies:
        try:
            ipaddress.ip_network(proxy, strict=False)
        except ValueError as error:
            raise Refusal(
                "settings-proxies",
                f"{path}, [station]: proxies has {proxy!r}",
                "it is no address",
                'Give the address from which the proxy connects, as "10.0.0.5" or "10.0.0.0/24"',
            ) from error
    return Serving(files.get("tls_certificate"), files.get("tls_key"), tuple(station.proxies))


def _limits(path: Path, table: _LimitsTable) -> Limits:
    if table.usable_um < table.good_um:
        raise Refusal(
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


def _invalid(path: Path, error: ValidationError) -> Refusal:
    first = error.errors(include_url=False)[0]
    place = [str(part) for part in first["loc"]]
    table = f"[{place[0]}]"
    key = ".".join(place[1:])
    named = f"{path}, {table}: {key}" if key else f"{path}: the table {table}"
    if first["type"] == "missing":
        remedy = "Add it as the README shows"
        return Refusal("settings-key-missing", f"{named} is missing", remedy=remedy)
    if first["type"] == "extra_forbidden":
        return Refusal("settings-key-unknown", f"{named} is not known", remedy="Correct its name")
    message = str(first["msg"]).replace("Input should", "it must")
    if first["type"] == "string_pattern_mismatch":
        message = PATTERN_WORDS[place[-1]]
    return Refusal(
        "settings-key-invalid",
        f"{named} = {first['input']!r}",
        WORDS.get(first["type"], message),
        "Correct it",
    )

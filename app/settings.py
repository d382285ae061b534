"""``station.toml``: the station's name, its data folder and its devices.

[station]
name = "Measuring room 2"
data = "data"                 # beside this file; --data goes before it
hosts = ["station.local"]     # further names browsers may use; localhost always may
tls_certificate = "cert.pem"  # with the key: the station is served over HTTPS
tls_key = "key.pem"
proxies = ["10.0.0.5"]        # whose word is taken for where a browser is, and for HTTPS

[arm]
driver = "serial-encoder"     # every other key is the driver's own
url = "/dev/ttyUSB0"

[sensor]
driver = "opencv"
source = 0

[limits]                      # of a scanned point's standard uncertainty, k = 1
good_um = 50                  # up to here a calibration is good
usable_um = 150               # beyond, it is not to be used
"""

import os
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from app.files.failures import files_refused
from app.metrology.findings import LIMITS, Limits
from app.metrology.refusal import Refusal

DEFAULT_FILE = "station.toml"
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
    proxies: tuple[str, ...] = ("127.0.0.1", "::1")


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


class _StationTable(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)

    name: Annotated[str, Field(min_length=1, max_length=60)] = "Crenel"
    data: Annotated[str, Field(min_length=1)] | None = None
    hosts: list[Annotated[str, Field(min_length=1)]] = []
    tls_certificate: Annotated[str, Field(min_length=1)] | None = None
    tls_key: Annotated[str, Field(min_length=1)] | None = None
    proxies: list[Annotated[str, Field(min_length=1)]] = list(Serving.proxies)


class _DeviceTable(BaseModel):
    model_config = ConfigDict(extra="allow", strict=True)

    driver: Annotated[str, Field(min_length=1)]


class _LimitsTable(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)

    good_um: LimitUm = LIMITS.good_um
    usable_um: LimitUm = LIMITS.usable_um


class _File(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)

    station: _StationTable = _StationTable()
    arm: _DeviceTable
    sensor: _DeviceTable
    limits: _LimitsTable = _LimitsTable()


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
    )


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
        return Refusal("settings-key-missing", f"{named} is missing")
    if first["type"] == "extra_forbidden":
        return Refusal("settings-key-unknown", f"{named} is not known", remedy="Correct its name")
    message = str(first["msg"])
    return Refusal(
        "settings-key-invalid",
        f"{named} = {first['input']!r}",
        f"{message[:1].lower()}{message[1:]}",
    )

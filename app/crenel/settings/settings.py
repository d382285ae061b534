"""What a station works with: its name, its data folder, its devices and its limits.

The context of a validation is the path of the file.
"""

import ipaddress
import os
import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Literal, Self, TypeAlias

from pydantic import (
    AfterValidator,
    ConfigDict,
    Field,
    ValidationInfo,
    field_validator,
    model_validator,
)

from crenel.archive.archive_settings import ArchiveSettings
from crenel.errors import OperationError
from crenel.formats.recording.topics import SENSOR_NAME
from crenel.formats.settings.toml_table import (
    Limit,
    NonEmpty,
    SettingsPath,
    TomlTable,
    check_authority,
)
from crenel.gauges.plan.document_gauge import DEFAULT_LIMITS, VerificationLimits
from crenel.gauges.plan.maths_temperature import TemperatureLimits
from crenel.guide.common.validity import DUE, DueLimits
from crenel.messages.message import message
from crenel.metrology.decision import GUARDED_95, RULES, Bearer, DecisionRule
from crenel.metrology.limits import LIMITS
from crenel.single_sign_on.settings import SignInSettings
from crenel.supervision.broker_settings import BrokerSettings


def user_data_folder() -> Path:
    """Where a program keeps what is this user's: by the XDG convention, or Windows' own."""
    if os.name == "nt" and "LOCALAPPDATA" in os.environ:
        return Path(os.environ["LOCALAPPDATA"]) / "Crenel"
    home = os.environ.get("XDG_DATA_HOME") or Path.home() / ".local" / "share"
    return Path(home) / "crenel"


def _check_network(proxy: str, info: ValidationInfo) -> str:
    try:
        ipaddress.ip_network(proxy, strict=False)
    except ValueError as error:
        raise OperationError(
            "settings-proxies",
            message("settings-proxy-is", file=str(info.context), proxy=repr(proxy)),
            message("settings-proxy-no-address"),
            message("settings-give-proxy"),
        ) from error
    return proxy


Names = Annotated[tuple[NonEmpty, ...], Field(strict=False)]
Proxies = Annotated[
    tuple[Annotated[NonEmpty, AfterValidator(_check_network)], ...], Field(strict=False)
]


ROOT_PATH = r"(?!/(?:api|assets|metrics|viewer)(?:/|$))(?:/[A-Za-z0-9_~-][A-Za-z0-9._~-]*){1,8}"
"""A sub-path; it begins with nothing that is the server's own."""


def check_root_path(root_path: str, place: str) -> str:
    """The sub-path under which a proxy offers the server, without a slash at its end.

    Args:
        place: where it was given, such as ``station.toml``.

    Raises:
        OperationError: it is none.
    """
    plain = root_path.rstrip("/")
    if plain and (len(plain) > 200 or not re.fullmatch(ROOT_PATH, plain)):
        raise OperationError(
            "settings-root-path",
            message("settings-root-path-is", place=place, path=repr(root_path)),
            message("settings-root-path-unusable"),
            message("settings-give-root-path"),
        )
    return plain


def _check_root_path(root_path: str, info: ValidationInfo) -> str:
    return check_root_path(root_path, str(info.context))


class Serving(TomlTable):
    """How browsers reach the server."""

    tls_certificate: SettingsPath | None = None
    tls_key: SettingsPath | None = None
    proxies: Proxies = ()
    hosts: Names = ()
    root_path: Annotated[str, AfterValidator(_check_root_path)] = ""
    """The sub-path under which a proxy offers the server; empty if there is none."""

    @model_validator(mode="after")
    def _check_certificate(self, info: ValidationInfo) -> Self:
        both = {"tls_certificate": self.tls_certificate, "tls_key": self.tls_key}
        files = {name: file for name, file in both.items() if file is not None}
        if len(files) == 1:
            raise OperationError(
                "settings-tls",
                message("settings-key-alone", file=str(info.context), key=next(iter(files))),
                message("settings-certificate-and-key"),
                message("settings-give-both-tls"),
            )
        for name, file in files.items():
            if not file.is_file():
                where, value = str(info.context), repr(str(file))
                raise OperationError(
                    "settings-tls",
                    message("settings-value-of", file=where, key=name, value=value),
                    message("no-such-file"),
                    message("settings-give-pem"),
                )
        return self


class StationTable(Serving):
    """The station itself."""

    name: Annotated[NonEmpty, Field(max_length=60)] = "Crenel"
    data: SettingsPath = Field(default_factory=lambda: user_data_folder() / "station")
    address: Annotated[str, Field(max_length=200, pattern="^https?://[^/]")] = ""
    backups: SettingsPath | None = None


DeviceKind: TypeAlias = Literal["arm", "sensor"]
"""The name of a device's table."""


class DeviceTable(TomlTable):
    """A driver's name and its own options."""

    model_config = ConfigDict(extra="allow")

    driver: NonEmpty
    label: Annotated[str, Field(max_length=60)] = ""
    """What people call the device; empty: as it calls itself."""

    @property
    def options(self) -> Mapping[str, object]:
        return self.model_extra or {}


class LimitsTable(TomlTable):
    """What the verdict on a calibration goes by."""

    good_um: Limit = LIMITS.good_um
    usable_um: Limit = LIMITS.usable_um

    @model_validator(mode="after")
    def _check_order(self, info: ValidationInfo) -> Self:
        if self.usable_um < self.good_um:
            raise OperationError(
                "settings-limits",
                message(
                    "settings-limits-reversed",
                    file=str(info.context),
                    usable=f"{self.usable_um:g}",
                    good=f"{self.good_um:g}",
                ),
                message("settings-limits-order"),
                message("settings-limits-swap"),
            )
        return self


class VerificationTable(VerificationLimits):
    """What a verification is judged by, where its gauge's certificate has no limits."""

    model_config = ConfigDict(extra="forbid")

    @model_validator(mode="before")
    @classmethod
    def _add_defaults(cls, given: object) -> object:
        return DEFAULT_LIMITS.model_dump() | given if isinstance(given, dict) else given


class DecisionTable(TomlTable):
    """How values, their uncertainties and their limits become decisions."""

    rule: Literal["guarded-95", "expanded-k2", "simple"] = "guarded-95"
    bearer: Bearer = GUARDED_95.bearer

    @property
    def decision_rule(self) -> DecisionRule:
        return replace(RULES[self.rule], bearer=self.bearer)


class PerformanceTable(TomlTable):
    """How steady artefact and arm have to be in a performance test."""

    temperature_change_c: Limit = TemperatureLimits.change_c
    temperature_from_20_c: Limit = TemperatureLimits.from_20_c

    @property
    def temperature_limits(self) -> TemperatureLimits:
        return TemperatureLimits(self.temperature_change_c, self.temperature_from_20_c)


class TemperatureTable(TomlTable):
    """The room's thermometer."""

    file: SettingsPath


class TriggerTable(TomlTable):
    """How the arm triggers the cameras."""

    rate_hz: Annotated[float, Field(ge=10.0, le=10_000.0)]
    delay_us: Annotated[float, Field(ge=0.0, le=100_000.0)] = 0.0
    """From a pulse to the start of its exposure, by the camera's datasheet."""
    delays_us: dict[str, Annotated[float, Field(ge=0.0, le=100_000.0)]] = Field(
        default_factory=dict
    )
    """The delays of those of several sensors that have another delay, by their names."""


class Settings(TomlTable):
    """One station."""

    station: StationTable = Field(default_factory=StationTable)
    arm: DeviceTable | None = None
    sensor: DeviceTable | None = None
    sensors: dict[str, DeviceTable] = Field(default_factory=dict)
    """The tables ``[sensor.NAME]`` of a station with several sensors, by their names."""
    limits: LimitsTable = LimitsTable()
    verification: VerificationTable = VerificationTable()
    decision: DecisionTable = DecisionTable()
    performance: PerformanceTable = PerformanceTable()
    due: DueLimits = DUE
    mqtt: BrokerSettings | None = None
    archive: ArchiveSettings | None = None
    sign_in: SignInSettings | None = None
    temperature: TemperatureTable | None = None
    trigger: TriggerTable | None = None

    @model_validator(mode="before")
    @classmethod
    def _split_sensors(cls, given: object, info: ValidationInfo) -> object:
        """Takes ``[sensor.left]`` and ``[sensor.right]`` for two sensors."""
        if not isinstance(given, dict):
            return given
        if "sensors" in given:
            raise OperationError(
                "settings-key-unknown",
                message(
                    "settings-is-unknown",
                    named=message("settings-table", file=str(info.context), table="sensors"),
                ),
                remedy=message("settings-name-sensor-tables"),
            )
        tables = given.get("sensor")
        if not isinstance(tables, dict) or not tables or "driver" in tables:
            return given
        if not all(isinstance(table, dict) for table in tables.values()):
            return given
        for name in tables:
            if not SENSOR_NAME.fullmatch(name):
                raise OperationError(
                    "settings-sensor-name",
                    f"{info.context}: [sensor.{name}]",
                    message("settings-sensor-name"),
                    message("settings-name-otherwise"),
                )
        others = {key: value for key, value in given.items() if key != "sensor"}
        return {**others, "sensors": tables}

    @model_validator(mode="after")
    def _check_trigger(self, info: ValidationInfo) -> Self:
        unknown = sorted(set(self.trigger.delays_us) - set(self.sensors)) if self.trigger else []
        if unknown:
            raise OperationError(
                "settings-trigger",
                message("settings-trigger-names", file=str(info.context), names=", ".join(unknown)),
                message("settings-no-such-sensor"),
                message("settings-name-as-tables"),
            )
        return self

    @property
    def devices(self) -> dict[DeviceKind, DeviceTable]:
        """The devices that are chosen."""
        tables: dict[DeviceKind, DeviceTable | None] = {"arm": self.arm, "sensor": self.sensor}
        return {kind: table for kind, table in tables.items() if table is not None}

    @field_validator("mqtt")
    @classmethod
    def _check_broker_files(
        cls, mqtt: BrokerSettings | None, info: ValidationInfo
    ) -> BrokerSettings | None:
        if mqtt is None:
            return None
        mqtt.password()
        if mqtt.ca_file is not None:
            where, remedy = f"{info.context}, [mqtt]", message("authority-give-for-broker")
            check_authority(mqtt.ca_file, "settings-mqtt", where, remedy)
        return mqtt

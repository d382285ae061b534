"""What the fleet's server answers; made of the catalogue's own records by their attributes."""

from datetime import datetime
from typing import Annotated, Literal, TypeAlias

from pydantic import BaseModel, ConfigDict, Field

from crenel.messages.message import Text
from crenel.supervision.remote_stations import RemoteStation
from crenel.wire.schema import RequestBody

CloudFormat: TypeAlias = Literal["copc", "ply"]


class FleetAnswer(BaseModel):
    """A part of an answer; ``model_validate`` takes it from an object with these attributes."""

    model_config = ConfigDict(from_attributes=True, frozen=True)


class FleetStation(FleetAnswer):
    """What the catalogue has of a station."""

    id: str
    name: str
    collected_at: datetime | None
    problem: str
    records: int
    archived: int
    size_bytes: int
    newest_at: datetime | None


class NamedQuantity(FleetAnswer):
    """A quantity of which the catalogue has values, in words."""

    id: str
    title: Text
    unit: str
    of_calibrations: bool


class FleetOverview(FleetAnswer):
    """The catalogue as a whole; ``problem``: why it cannot be used now."""

    place: str
    stations: list[FleetStation]
    kinds: list[str]
    quantities: list[NamedQuantity]
    problem: Text
    looks_every_s: float


class StationsOnBroker(FleetAnswer):
    """What the stations report over MQTT; ``broker``: it is connected, null without one."""

    broker: bool | None
    stations: list[RemoteStation]


class RecordFigure(FleetAnswer):
    """One result of a record; the uncertainty has k = 2."""

    symbol: str
    quantity: str
    title: Text
    value: float
    unit: str
    expanded_uncertainty: float | None
    limit: float | None
    decision: str


class RecordedFile(FleetAnswer):
    """A file of a record."""

    path: str
    bytes: int
    sha256: str


class FleetRecord(FleetAnswer):
    """A record of a station."""

    station: str
    kind: str
    id: str
    at: datetime
    label: str
    operator: str
    arm_serial: str
    sensor_serial: str
    object_serial: str
    calibration_id: str
    software: str
    verdict: str
    temperature_c: float | None
    points: int | None
    archived_at: datetime | None
    place: str
    size_bytes: int
    files: list[RecordedFile]
    figures: list[RecordFigure]


class FoundFleetRecord(FleetRecord):
    """A record in a list, without files and figures; ``key`` continues the list behind it."""

    key: int


class RecordsPage(FleetAnswer):
    """What a search found, newest first."""

    records: list[FoundFleetRecord]
    more: bool


class CalibrationChoice(FleetAnswer):
    """A calibration with which the cloud of a scan can be made."""

    id: str
    label: str
    sensor_serial: str
    at: datetime | None
    """None: the catalogue has no record of it."""


class FleetCalibrationDoubt(FleetAnswer):
    """A figure by which a calibration is wrong, or perhaps wrong."""

    calibration_id: str
    title: Text
    """The title of the figure."""
    unit: str
    size: float
    """By how much it differs."""
    is_wrong: bool


class FleetCalibrationDoubts(FleetAnswer):
    """The doubts about all calibrations of a station; those by which one is wrong first."""

    doubts: list[FleetCalibrationDoubt]


class MadeCloud(FleetAnswer):
    """A cloud of a scan that is there."""

    name: str
    """The name of its file."""
    calibration_ids: list[str]
    """One for each sensor."""
    software: str
    points: int
    size_bytes: int
    warnings: list[Text]


class CloudOrderState(FleetAnswer):
    """A cloud that is wanted; ``note``: why its work waits; ``problem``: why it failed."""

    id: int
    calibration_ids: list[str]
    """Empty: those that the scan was taken with."""
    format: CloudFormat
    state: Literal["waiting", "working", "failed"]
    share: float
    note: Text
    problem: Text


class ScanClouds(FleetAnswer):
    """The clouds of a scan; ``problem``: why none can be made here."""

    problem: Text
    software: str
    """With which a new one is made."""
    used_calibration_id: str
    calibrations: list[CalibrationChoice]
    """The newest first, with the one in use then."""
    made: list[MadeCloud]
    orders: list[CloudOrderState]


class CloudWish(RequestBody):
    """Which cloud of a scan is wanted; no calibration: the one that it was taken with."""

    calibration_id: Annotated[str, Field(max_length=200)] = ""
    calibration_ids: list[Annotated[str, Field(max_length=200)]] = Field(default_factory=list)
    """Each for its sensor, of a scan of several."""
    format: CloudFormat = "copc"


class CalibrationsInUse(FleetAnswer):
    """The newest calibration of every station and sensor."""

    calibrations: list[FleetRecord]


class FleetCalibrationValue(FleetAnswer):
    """A figure of one calibration."""

    id: str
    at: datetime
    value: float


class FleetCalibrationSpread(FleetAnswer):
    """A figure of all calibrations of one sensor at one station, the oldest first."""

    station: str
    sensor_serial: str
    unit: str
    limit: float | None
    values: list[FleetCalibrationValue]
    median: float
    standard_deviation: float | None


class FleetSpread(FleetAnswer):
    """A figure of all calibrations of all stations."""

    quantity: str
    spreads: list[FleetCalibrationSpread]


class AgeingSlope(FleetAnswer):
    """A change with hours or temperature, with its uncertainty at 95 %."""

    value: float
    expanded_uncertainty: float
    values: int
    groups: int
    is_significant: bool


class FleetAgeingPoint(FleetAnswer):
    """A value by hours since the calibration in use, and K above its temperature; or by hours since
    the first value, and °C."""

    at: datetime
    value: float
    hours: float
    temperature: float | None
    group: str


class FleetStationAgeing(FleetAnswer):
    """How a figure of one station changes; ``since``: what its hours count from."""

    station: str
    unit: str
    since: Literal["calibration", "first"]
    points: list[FleetAgeingPoint]
    left_out: int
    per_1000_h: AgeingSlope | None
    per_kelvin: AgeingSlope | None


class FleetAgeing(FleetAnswer):
    """How a figure of all stations changes."""

    quantity: str
    stations: list[FleetStationAgeing]


FLEET_ANSWERS = (
    FleetOverview,
    StationsOnBroker,
    RecordsPage,
    FleetRecord,
    ScanClouds,
    CloudWish,
    FleetCalibrationDoubts,
    CalibrationsInUse,
    FleetSpread,
    FleetAgeing,
)

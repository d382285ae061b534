"""What the fleet's server answers; made of the catalogue's own records by their attributes."""

from datetime import datetime
from typing import Literal

from pydantic import BaseModel, ConfigDict

from app.messages.message import Text
from app.supervision.remote_stations import RemoteStation


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
    """What the stations report over MQTT; ``broker``: it is connected."""

    broker: bool
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


class DriftPoint(FleetAnswer):
    """One value of a figure."""

    at: datetime
    value: float
    unit: str
    limit: float | None
    decision: str
    record_key: int


class DriftStep(FleetAnswer):
    """A change of a figure: between which values, within which times (95 %), and by how much."""

    after: datetime
    by: datetime
    earliest: datetime
    latest: datetime
    before_value: float
    after_value: float
    standard_uncertainty: float


class DriftLevelRange(FleetAnswer):
    """The mean of a figure between two changes, with the moments of its first and last value."""

    since: datetime
    until: datetime
    value: float
    values: int


class DriftRightLevel(FleetAnswer):
    """The level that is taken as right; ``values``: that agree with it."""

    since: datetime
    value: float
    values: int
    because: Literal["first", "most", "chosen"]


class DriftStandingOut(FleetAnswer):
    """A single value far from its level."""

    at: datetime
    value: float
    calibration_id: str


class DriftCalibrationSpread(FleetAnswer):
    """How far calibrations lie from each other, k = 1; None: too few values tell."""

    calibrations: int
    standard_deviation: float | None
    doubtful: list[str]


class DriftHistory(FleetAnswer):
    """What the values of a figure of one station tell."""

    changes: list[DriftStep]
    levels: list[DriftLevelRange]
    right: DriftRightLevel | None
    standing_out: list[DriftStandingOut]
    spread: DriftCalibrationSpread


class DriftingStation(FleetAnswer):
    """A figure of one station over time."""

    station: str
    points: list[DriftPoint]
    history: DriftHistory


class DriftPeriod(FleetAnswer):
    """A stretch of time in which a figure differed from the level that is taken as right, and what
    was scanned in it, surely and possibly affected; ``change`` None: from the first value on."""

    station: str
    change: DriftStep | None
    ended: DriftStep | None
    levels: list[DriftLevelRange]
    right_value: float
    size: float
    standard_uncertainty: float
    calibration_ids: list[str]
    recordings: list[FleetRecord]
    possible: list[FleetRecord]


class FleetDrift(FleetAnswer):
    """A figure of all stations over time, and what its changes affect."""

    quantity: str
    least_values: int
    """That a period needs."""
    stations: list[DriftingStation]
    periods: list[DriftPeriod]


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
    FleetDrift,
    CalibrationsInUse,
    FleetSpread,
    FleetAgeing,
)

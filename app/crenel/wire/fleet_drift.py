"""What the fleet's server answers about drift; made of the objects that the question gives."""

from datetime import datetime
from typing import Literal

from crenel.wire.fleet import FleetAnswer, FleetRecord


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


class DriftDoubtfulCalibration(FleetAnswer):
    """A calibration that is perhaps wrong, and when it was tested."""

    calibration_id: str
    size: float
    since: datetime
    until: datetime


class DriftCalibrationSpread(FleetAnswer):
    """How far calibrations lie from each other, k = 1; None: too few values tell."""

    calibrations: int
    standard_deviation: float | None
    doubtful: list[DriftDoubtfulCalibration]


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


class DriftDoubtedRecordings(FleetAnswer):
    """What was scanned with a calibration that is perhaps wrong."""

    station: str
    calibration_id: str
    recordings: list[FleetRecord]


class FleetDrift(FleetAnswer):
    """A figure of all stations over time, and what its changes affect."""

    quantity: str
    least_values: int
    """That a period needs."""
    stations: list[DriftingStation]
    periods: list[DriftPeriod]
    doubted: list[DriftDoubtedRecordings]

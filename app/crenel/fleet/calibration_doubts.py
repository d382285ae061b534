"""Which calibrations of a station are wrong, or perhaps wrong, by the drift of its tests."""

from collections.abc import Iterator
from dataclasses import dataclass

from sqlalchemy import Connection

from crenel.fleet.catalogue.quantities import CALIBRATION_TITLES, title_of
from crenel.fleet.catalogue.reading import quantities
from crenel.fleet.questions import StationDrift, drift_of
from crenel.messages.message import Text


@dataclass(frozen=True, slots=True)
class CalibrationDoubt:
    """A figure by which a calibration is doubted."""

    calibration_id: str
    quantity: str
    unit: str
    size: float
    """By how much the figure differs with it."""
    is_wrong: bool
    """It explains a period in which the figure differed; otherwise, it is only perhaps wrong."""

    @property
    def title(self) -> Text:
        """The quantity in words."""
        return title_of(self.quantity)


def find_calibration_doubts(connection: Connection, station: str) -> list[CalibrationDoubt]:
    """The doubts about the calibrations of a station, by every figure of its tests; those by which
    one is wrong first. What the calibrations state themselves does not count: it may change."""
    found: list[CalibrationDoubt] = []
    for quantity, unit in quantities(connection).items():
        if quantity not in CALIBRATION_TITLES:
            for drift in drift_of(connection, quantity, [station]):
                found += _doubts_by(drift, quantity, unit)
    return sorted(found, key=lambda one: not one.is_wrong)


def _doubts_by(drift: StationDrift, quantity: str, unit: str) -> Iterator[CalibrationDoubt]:
    for period in drift.history.periods:
        tests = zip((one.at for one in drift.points), drift.calibration_ids, strict=True)
        for used in period.explaining_calibrations(tests):
            yield CalibrationDoubt(used, quantity, unit, period.size, True)
    for one in drift.history.spread.doubtful:
        yield CalibrationDoubt(one.calibration_id, quantity, unit, one.size, False)

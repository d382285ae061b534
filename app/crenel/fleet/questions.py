"""What the catalogue answers: since when a figure drifts, and which recordings are affected."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import datetime

from sqlalchemy import Connection, select

from crenel.fleet.catalogue.entry import CatalogueEntry
from crenel.fleet.catalogue.reading import (
    FigurePoint,
    SearchQuery,
    calibrations_of,
    figure_points,
    newest_calibration,
    read_record,
    read_scans,
    search,
)
from crenel.fleet.catalogue.tables import RecordRow
from crenel.metrology.dated_changes import ChangedPeriod, DriftChange, DriftLevel
from crenel.metrology.figure_history import FigureHistory, find_history


@dataclass(frozen=True, slots=True)
class StationDrift:
    """A figure of one station over time."""

    station: str
    points: tuple[FigurePoint, ...]
    calibration_ids: tuple[str, ...]
    """The calibration in use at each point; empty if unknown."""
    history: FigureHistory

    @property
    def changes(self) -> tuple[DriftChange, ...]:
        """The changes of the figure."""
        return self.history.changes


@dataclass(frozen=True, slots=True)
class AffectedPeriod:
    """A stretch of time in which a figure differed from the level that is taken as right, and what
    was scanned in it."""

    station: str
    change: DriftChange | None
    """None: it differed from the first value on."""
    ended: DriftChange | None
    """None: it lasts."""
    levels: tuple[DriftLevel, ...]
    """In it, one after the other."""
    right_value: float
    size: float
    """By how much the level differed most."""
    standard_uncertainty: float
    calibration_ids: tuple[str, ...]
    """Calibrations that the tests in it used, and no test outside; empty if none explains it."""
    recordings: tuple[CatalogueEntry, ...]
    """Surely affected: with one of these calibrations, or else by their time."""
    possible: tuple[CatalogueEntry, ...]
    """Within the uncertainty of the beginning or the end; empty if a calibration explains it."""


@dataclass(frozen=True, slots=True)
class DoubtedRecordings:
    """What was scanned with a calibration that is perhaps wrong."""

    station: str
    calibration_id: str
    recordings: tuple[CatalogueEntry, ...]


@dataclass(frozen=True, slots=True)
class CalibrationOfScan:
    """A recording and the calibration that it was made with."""

    recording: CatalogueEntry
    calibration: CatalogueEntry | None
    """None: the catalogue has no record of it."""
    newest: CatalogueEntry | None
    """The calibration that the station accepted last for this sensor."""


def drift_of(
    connection: Connection,
    quantity: str,
    stations: Sequence[str] = (),
    since: datetime | None = None,
    until: datetime | None = None,
    right_since: datetime | None = None,
) -> list[StationDrift]:
    """A figure of each station with its change points, by station.

    Of a station with very many values, the newest ones count.

    Args:
        right_since: as of ``find_history``.
    """
    points: dict[str, list[FigurePoint]] = {}
    for point in figure_points(connection, quantity, stations, since, until):
        points.setdefault(point.station, []).append(point)
    return [
        _describe_station(connection, station, its, right_since)
        for station, its in sorted(points.items())
    ]


def find_affected(connection: Connection, drift: StationDrift) -> list[AffectedPeriod]:
    """What was scanned while the figure differed from the level that is taken as right.

    If the tests of a period used calibrations that no test outside used, the recordings with these
    are the affected ones, exactly; otherwise they are named by time.
    """
    return [_describe_period(connection, drift, one) for one in drift.history.periods]


def find_doubted(connection: Connection, drift: StationDrift) -> list[DoubtedRecordings]:
    """What would be affected if the calibrations that are perhaps wrong are wrong."""
    return [
        DoubtedRecordings(
            drift.station,
            one.calibration_id,
            tuple(read_scans(connection, drift.station, calibration_ids=[one.calibration_id])),
        )
        for one in drift.history.spread.doubtful
    ]


def find_calibrations(
    connection: Connection, text: str, station: str = "", limit: int = 50
) -> list[CalibrationOfScan]:
    """The calibration in use when a part was scanned, of each scan that is found by ``text``.

    Scans that have these words count alone; if there are none, those with words that begin so.
    """
    query = SearchQuery(text=text, station=station, kind="scan", limit=limit, whole_words=True)
    scans = search(connection, query) or search(connection, replace(query, whole_words=False))
    found = []
    for scan in scans:
        entry = scan.entry
        used = read_record(connection, entry.station, "calibration", entry.calibration_id)
        # recordings of earlier versions do not state their sensor
        sensor = entry.sensor_serial or ("" if used is None else used.sensor_serial)
        newest = newest_calibration(connection, entry.station, sensor)
        found.append(CalibrationOfScan(entry, used, newest))
    return found


def _describe_station(
    connection: Connection,
    station: str,
    points: Sequence[FigurePoint],
    right_since: datetime | None,
) -> StationDrift:
    known = _calibrations_of(connection, station, points)
    used = tuple(known.get(one.record_key, "") for one in points)
    times, values = [one.at for one in points], [one.value for one in points]
    history = find_history(times, values, used, right_since)
    return StationDrift(station, tuple(points), used, history)


def _describe_period(
    connection: Connection, drift: StationDrift, period: ChangedPeriod
) -> AffectedPeriod:
    station = drift.station
    tests = zip((point.at for point in drift.points), drift.calibration_ids, strict=True)
    calibration_ids = period.explaining_calibrations(tests)
    if calibration_ids:
        sure = read_scans(connection, station, calibration_ids=calibration_ids)
        rest = []
    else:
        scans = read_scans(connection, station, period.since, period.until)
        sure = [one for one in scans if period.surely_contains(one.at)]
        rest = [one for one in scans if not period.surely_contains(one.at)]
    return AffectedPeriod(
        station,
        period.change,
        period.ended,
        period.levels,
        period.right_value,
        period.size,
        period.standard_uncertainty,
        calibration_ids,
        tuple(sure),
        tuple(rest),
    )


def _calibrations_of(
    connection: Connection, station: str, points: Sequence[FigurePoint]
) -> dict[int, str]:
    """The calibration of each test by its record's key; by the file's hash where a test does not
    name it."""
    tests = connection.execute(
        select(RecordRow.key, RecordRow.calibration_id, RecordRow.calibration_sha256).where(
            RecordRow.station == station,
            RecordRow.at >= points[0].at,
            RecordRow.at <= points[-1].at,
            RecordRow.kind != "scan",
        )
    ).all()
    known = calibrations_of(connection, station)
    named = {sha256: found.id for sha256, found in known.items()}
    return {key: own or named.get(sha256, "") for key, own, sha256 in tests}

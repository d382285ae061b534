"""What the catalogue answers: since when a figure drifts, and which recordings are affected."""

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime

import numpy as np
from sqlalchemy import Connection, select

from app.fleet.catalogue.entry import CatalogueEntry
from app.fleet.catalogue.reading import (
    FigurePoint,
    SearchQuery,
    calibrations_of,
    figure_points,
    newest_calibration,
    read_record,
    read_scans,
    search,
)
from app.fleet.catalogue.tables import RecordRow
from app.metrology.change_points import MOST_VALUES, ChangePoint, find_changes


@dataclass(frozen=True, slots=True)
class DriftChange:
    """A change of a figure of one station."""

    after: datetime
    """It happened behind this value, most probably, and not behind ``by``."""
    by: datetime
    earliest: datetime
    """The same with a probability of 95 %."""
    latest: datetime
    before_value: float
    after_value: float
    standard_uncertainty: float
    """Of the difference of both, k = 1."""

    @property
    def size(self) -> float:
        """By how much the figure changed."""
        return self.after_value - self.before_value


@dataclass(frozen=True, slots=True)
class StationDrift:
    """A figure of one station over time."""

    station: str
    points: tuple[FigurePoint, ...]
    changes: tuple[DriftChange, ...]


@dataclass(frozen=True, slots=True)
class AffectedPeriod:
    """A stretch of time in which a figure differed from that before, and what was scanned in it."""

    station: str
    change: DriftChange
    ended: DriftChange | None
    """None: it lasts."""
    calibration_ids: tuple[str, ...]
    """Calibrations that the tests in it used, and no test outside; empty if none explains it."""
    recordings: tuple[CatalogueEntry, ...]
    """Surely affected: with one of these calibrations, or else by their time."""
    possible: tuple[CatalogueEntry, ...]
    """Within the uncertainty of the beginning or the end; empty if a calibration explains it."""


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
) -> list[StationDrift]:
    """A figure of each station with its change points, by station.

    Of a station with more than ``MOST_VALUES`` values, the newest ones count.
    """
    points: dict[str, list[FigurePoint]] = {}
    for point in figure_points(connection, quantity, stations, since, until):
        points.setdefault(point.station, []).append(point)
    return [
        StationDrift(station, tuple(its), _find_changes(its[-MOST_VALUES:]))
        for station, its in sorted(points.items())
    ]


def _find_changes(points: Sequence[FigurePoint]) -> tuple[DriftChange, ...]:
    values = np.array([point.value for point in points])
    return tuple(_describe_change(points, one) for one in find_changes(values))


def find_affected(connection: Connection, drift: StationDrift) -> list[AffectedPeriod]:
    """What was scanned while the figure differed from that before the first change.

    A change back to the level before ends a period. If the tests of the period used calibrations
    that no test outside used, the recordings with these are the affected ones, exactly; otherwise
    they are named by time.
    """
    found = []
    changes = list(drift.changes)
    while changes:
        change = changes.pop(0)
        ended = None
        if changes and _leads_back(change, changes[0]):
            ended = changes.pop(0)
        found.append(_describe_period(connection, drift, change, ended))
    return found


def find_calibrations(
    connection: Connection, text: str, station: str = "", limit: int = 50
) -> list[CalibrationOfScan]:
    """The calibration in use when a part was scanned, of each scan that is found by ``text``."""
    query = SearchQuery(text=text, station=station, kind="scan", limit=limit)
    found = []
    for scan in search(connection, query):
        entry = scan.entry
        used = read_record(connection, entry.station, "calibration", entry.calibration_id)
        newest = newest_calibration(connection, entry.station, entry.sensor_serial)
        found.append(CalibrationOfScan(entry, used, newest))
    return found


def _describe_change(points: Sequence[FigurePoint], found: ChangePoint) -> DriftChange:
    return DriftChange(
        after=points[found.index - 1].at,
        by=points[found.index].at,
        earliest=points[found.first_index - 1].at,
        latest=points[found.last_index].at,
        before_value=found.before,
        after_value=found.after,
        standard_uncertainty=found.standard_uncertainty,
    )


def _leads_back(change: DriftChange, following: DriftChange) -> bool:
    """Whether a change undoes most of the one before."""
    return abs(following.after_value - change.before_value) < abs(change.size) / 2


def _describe_period(
    connection: Connection, drift: StationDrift, change: DriftChange, ended: DriftChange | None
) -> AffectedPeriod:
    station = drift.station
    calibration_ids = _explaining_calibrations(connection, drift, change, ended)
    if calibration_ids:
        exact = tuple(read_scans(connection, station, calibration_ids=calibration_ids))
        return AffectedPeriod(station, change, ended, calibration_ids, exact, ())
    until = None if ended is None else ended.latest
    scans = read_scans(connection, station, change.earliest, until)
    sure = tuple(one for one in scans if _is_surely_within(one.at, change, ended))
    rest = tuple(one for one in scans if not _is_surely_within(one.at, change, ended))
    return AffectedPeriod(station, change, ended, (), sure, rest)


def _is_surely_within(at: datetime, change: DriftChange, ended: DriftChange | None) -> bool:
    return at >= change.latest and (ended is None or at <= ended.earliest)


def _explaining_calibrations(
    connection: Connection, drift: StationDrift, change: DriftChange, ended: DriftChange | None
) -> tuple[str, ...]:
    """The calibrations of the tests that are surely within a period, if no test that is surely
    outside used one of them."""
    used = _calibrations_of(connection, drift)
    inside, outside = set(), set()
    for point in drift.points:
        calibration_id = used.get(point.record_key, "")
        if _is_surely_within(point.at, change, ended):
            inside.add(calibration_id)
        elif point.at <= change.earliest or (ended is not None and point.at >= ended.latest):
            outside.add(calibration_id)
    if "" in inside or inside & outside:
        return ()
    return tuple(sorted(inside))


def _calibrations_of(connection: Connection, drift: StationDrift) -> dict[int, str]:
    """The calibration of each test by its record's key; by the file's hash where a test does not
    name it."""
    tests = connection.execute(
        select(RecordRow.key, RecordRow.calibration_id, RecordRow.calibration_sha256).where(
            RecordRow.station == drift.station,
            RecordRow.at >= drift.points[0].at,
            RecordRow.at <= drift.points[-1].at,
            RecordRow.kind != "scan",
        )
    ).all()
    known = calibrations_of(connection, drift.station)
    named = {sha256: found.id for sha256, found in known.items()}
    return {key: own or named.get(sha256, "") for key, own, sha256 in tests}

"""What the catalogue answers about calibrations: how much those of a sensor differ, and how figures
change with the hours since the calibration and with the temperature."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from datetime import datetime
from itertools import groupby
from operator import attrgetter
from statistics import median, stdev
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from sqlalchemy import Connection, bindparam, select, true

from crenel.fleet.catalogue.reading import CalibrationMoment, calibrations_by_station
from crenel.fleet.catalogue.tables import FigureRow, RecordRow, StationRow
from crenel.metrology.common_slope import CommonSlope, fit_common_slope

if TYPE_CHECKING:
    from sqlalchemy import ColumnElement, Select
    from sqlalchemy.engine import Row
    from sqlalchemy.orm import InstrumentedAttribute

MOST_OF_STATION, MOST_VALUES, LEAST_OF_STATION = 2000, 20_000, 20
"""The newest values count, of each station and in all."""
HOUR_S = 3600.0
OWN_HISTORY = ("calibration", "arm_check", "tip_check")
"""Kinds of records that do not depend on a calibration: their figures age since the first one."""
Reference = Literal["calibration", "first"]


@dataclass(frozen=True, slots=True)
class CalibrationValue:
    """A figure of one calibration."""

    id: str
    at: datetime
    value: float


@dataclass(frozen=True, slots=True)
class CalibrationSpread:
    """A figure of all calibrations of one sensor at one station."""

    station: str
    sensor_serial: str
    unit: str
    limit: float | None
    """The limit of the newest value."""
    values: tuple[CalibrationValue, ...]
    """The oldest first; never empty."""

    @property
    def median(self) -> float:
        """The median of all values."""
        return median(one.value for one in self.values)

    @property
    def standard_deviation(self) -> float | None:
        """The standard deviation of all values, with n - 1; None for one value."""
        return stdev(one.value for one in self.values) if len(self.values) > 1 else None


@dataclass(frozen=True, slots=True)
class AgeingPoint:
    """A value, and how old its calibration was and how warm it was then."""

    at: datetime
    value: float
    hours: float
    """Since the calibration in use, or since the first value."""
    temperature: float | None
    """In K above that of the calibration, or in °C; None if it is not known."""
    group: str
    """The calibration or device: values of one group have a level of their own."""


@dataclass(frozen=True, slots=True)
class StationAgeing:
    """How a figure of one station changes."""

    station: str
    unit: str
    since: Reference
    points: tuple[AgeingPoint, ...]
    """The oldest first."""
    left_out: int
    """Values whose calibration is not in the catalogue."""
    per_1000_h: CommonSlope | None
    per_kelvin: CommonSlope | None


def spread_of(
    connection: Connection, quantity: str, stations: Sequence[str] = ()
) -> list[CalibrationSpread]:
    """A figure of all calibrations, by station and sensor."""
    found: dict[tuple[str, str], list[Row[Any]]] = {}
    chosen = stations or _all_stations(connection)
    most = values_of_each(len(chosen))
    for station, rows in _read_rows(connection, quantity, chosen, None, None, most):
        for row in rows:
            if row.kind == "calibration":
                found.setdefault((station, row.sensor_serial), []).append(row)
    return [
        CalibrationSpread(
            station,
            sensor_serial,
            own[-1].unit,
            own[-1].limit_value,
            tuple(CalibrationValue(row.id, row.at, row.value) for row in own),
        )
        for (station, sensor_serial), own in sorted(found.items())
    ]


def ageing_of(
    connection: Connection,
    quantity: str,
    stations: Sequence[str] = (),
    since: datetime | None = None,
    until: datetime | None = None,
) -> list[StationAgeing]:
    """A figure against the hours since the calibration in use, and against the temperature.

    Each calibration has a level of its own, since it has an error of its own; the slope is common
    to all calibrations of a station. Figures of calibrations and of the checks of arm and tip count
    from the first one of the device.
    """
    found = []
    chosen = stations or _all_stations(connection)
    most = values_of_each(len(chosen))
    known = calibrations_by_station(connection, chosen)
    for station, rows in _read_rows(connection, quantity, chosen, since, until, most):
        found.append(_age(station, rows, known.get(station, {})))
    return found


def values_of_each(stations: int) -> int:
    """How many values of each of so many stations count, so that an answer stays small.

    Example:
        >>> [values_of_each(stations) for stations in (1, 100, 1000)]
        [2000, 200, 20]
    """
    share = MOST_VALUES // max(stations, 1)
    return max(min(MOST_OF_STATION, share), LEAST_OF_STATION)


def _all_stations(connection: Connection) -> Sequence[str]:
    return connection.scalars(select(StationRow.id).order_by(StationRow.id)).all()


def _read_rows(
    connection: Connection,
    quantity: str,
    stations: Sequence[str],
    since: datetime | None,
    until: datetime | None,
    most: int,
) -> "Iterator[tuple[str, Sequence[Row[Any]]]]":
    """The values of each station that has any, with their records, the oldest first.

    PostgreSQL answers for all stations at once. SQLite has no LATERAL, and is asked for each: there
    is no server between, so that it costs little. Each station is one range of the index.
    """
    period = (quantity, since, until, most)
    if connection.dialect.name == "postgresql":
        newest = _newest_of(StationRow.id, *period).lateral()
        wanted = (
            select(StationRow.id.label("of_station"), newest)
            .join(newest, true())
            .where(StationRow.id.in_(stations))
            .order_by(StationRow.id, newest.c.at)
        )
        for station, rows in groupby(connection.execute(wanted), attrgetter("of_station")):
            yield station, [*rows]
        return
    of_one = _newest_of(bindparam("of"), *period)
    for station in sorted(stations):
        found: list[Row[Any]] = [*connection.execute(of_one, {"of": station})]
        if found:
            yield station, found[::-1]


def _newest_of(
    station: "ColumnElement[str] | InstrumentedAttribute[str]",
    quantity: str,
    since: datetime | None,
    until: datetime | None,
    most: int,
) -> "Select[*tuple[Any, ...]]":
    """The newest values of a station, with their records."""
    wanted = (
        select(
            FigureRow.at,
            FigureRow.value,
            FigureRow.unit,
            FigureRow.limit_value,
            RecordRow.id,
            RecordRow.kind,
            RecordRow.arm_serial,
            RecordRow.sensor_serial,
            RecordRow.calibration_id,
            RecordRow.calibration_sha256,
            RecordRow.temperature_c,
        )
        .join(RecordRow, RecordRow.key == FigureRow.record_key)
        .where(FigureRow.quantity == quantity, FigureRow.station == station)
    )
    if since is not None:
        wanted = wanted.where(FigureRow.at >= since)
    if until is not None:
        wanted = wanted.where(FigureRow.at < until)
    return wanted.order_by(FigureRow.at.desc()).limit(most)


def _age(
    station: str, rows: "Sequence[Row[Any]]", calibrations: dict[str, CalibrationMoment]
) -> StationAgeing:
    own = rows[0].kind in OWN_HISTORY
    points = _own_history(rows) if own else _since_calibration(rows, calibrations)
    warm = [one for one in points if one.temperature is not None]
    return StationAgeing(
        station,
        rows[0].unit,
        "first" if own else "calibration",
        tuple(points),
        len(rows) - len(points),
        _slope(points, lambda one: one.hours / 1000),
        _slope(warm, lambda one: one.temperature or 0.0),
    )


def _own_history(rows: "Sequence[Row[Any]]") -> list[AgeingPoint]:
    first: dict[str, datetime] = {}
    found = []
    for row in rows:
        device = row.sensor_serial if row.kind == "calibration" else row.arm_serial
        hours = _hours(first.setdefault(device, row.at), row.at)
        found.append(AgeingPoint(row.at, row.value, hours, row.temperature_c, device))
    return found


def _since_calibration(
    rows: "Sequence[Row[Any]]", calibrations: dict[str, CalibrationMoment]
) -> list[AgeingPoint]:
    found = []
    for row in rows:
        used = calibrations.get(row.calibration_id) or calibrations.get(row.calibration_sha256)
        if used is None or used.at > row.at:
            continue
        known = row.temperature_c is not None and used.temperature_c is not None
        warmer = row.temperature_c - used.temperature_c if known else None
        found.append(AgeingPoint(row.at, row.value, _hours(used.at, row.at), warmer, used.id))
    return found


def _hours(since: datetime, at: datetime) -> float:
    return (at - since).total_seconds() / HOUR_S


def _slope(
    points: Sequence[AgeingPoint], argument: Callable[[AgeingPoint], float]
) -> CommonSlope | None:
    groups = {name: number for number, name in enumerate({one.group for one in points})}
    return fit_common_slope(
        np.array([argument(one) for one in points], dtype=np.float64),
        np.array([one.value for one in points], dtype=np.float64),
        np.array([groups[one.group] for one in points], dtype=np.int64),
    )

"""Reads the catalogue: search, one record, a figure over time."""

from collections.abc import Sequence
from dataclasses import dataclass, fields
from datetime import datetime
from itertools import islice
from typing import TYPE_CHECKING, Any

from sqlalchemy import Connection, Select, and_, bindparam, func, or_, select

from crenel.fleet.catalogue.entry import (
    CatalogueEntry,
    EntryFigure,
    EntryFile,
    split_words,
)
from crenel.fleet.catalogue.tables import FigureRow, FileRow, RecordRow, StationRow, WordRow

if TYPE_CHECKING:
    from sqlalchemy.engine import Row

RARE = 1000
"""With at most so many records of a word, these are looked at first."""
NAMED_STATIONS = 20
"""A query for at most so many stations names each."""
BEHIND = "\U0010ffff"
"""Stands behind every other character."""
OWN_FIELDS = tuple(
    one.name for one in fields(CatalogueEntry) if one.name not in ("files", "figures")
)


@dataclass(frozen=True, slots=True)
class SearchQuery:
    """What is looked for; empty fields find everything."""

    text: str = ""
    """Beginnings of words of label, id, operator or serial numbers, all of them."""
    whole_words: bool = False
    """The words of ``text`` are whole ones, and no beginnings."""
    station: str = ""
    kind: str = ""
    verdict: str = ""
    calibration_id: str = ""
    since: datetime | None = None
    until: datetime | None = None
    """The first moment that is too late."""
    limit: int = 50
    before: tuple[datetime, int] | None = None
    """Continues behind the last record of the page before."""


@dataclass(frozen=True, slots=True)
class FoundRecord:
    """A record of a search, without files and figures."""

    key: int
    entry: CatalogueEntry
    size_bytes: int


@dataclass(frozen=True, slots=True)
class FigurePoint:
    """One value of a figure, and the record that it stands in."""

    station: str
    at: datetime
    value: float
    unit: str
    expanded_uncertainty: float | None
    limit: float | None
    decision: str
    symbol: str
    record_key: int


@dataclass(frozen=True, slots=True)
class CalibrationMoment:
    """When a station accepted a calibration, and how warm it was."""

    id: str
    at: datetime
    temperature_c: float | None


@dataclass(frozen=True, slots=True)
class KnownContent:
    """What the catalogue has of a record's folder."""

    content: str
    label: str
    size_bytes: int
    current_at: datetime
    archived: bool


@dataclass(frozen=True, slots=True)
class StationSummary:
    """What the catalogue has of a station."""

    id: str
    name: str
    collected_at: datetime | None
    problem: str
    records: int
    archived: int
    size_bytes: int
    newest_at: datetime | None


def search(connection: Connection, query: SearchQuery) -> list[FoundRecord]:
    """The records that a query finds, newest first, at most ``query.limit``."""
    wanted = _add_filters(select(RecordRow.__table__), query)
    if query.before is not None:
        at, key = query.before
        wanted = wanted.where(or_(RecordRow.at < at, and_(RecordRow.at == at, RecordRow.key < key)))
    wanted = wanted.order_by(RecordRow.at.desc(), RecordRow.key.desc())
    terms = sorted(split_words(query.text))
    matches = {term: _matches(term, query.whole_words) for term in terms}
    counts = {term: _count_to(connection, matches[term]) for term in terms}
    rarest = min(terms, key=lambda term: counts[term], default="")
    if not terms or counts[rarest] > RARE:
        for term in terms:
            with_term = select(WordRow.record_key).where(matches[term])
            wanted = wanted.where(RecordRow.key.in_(with_term))
        return [_read_row(row) for row in connection.execute(wanted.limit(query.limit))]
    keys = connection.scalars(select(WordRow.record_key).where(matches[rarest])).all()
    rows = connection.execute(wanted.where(RecordRow.key.in_(keys)))
    # the other words of so few records are compared here
    found = (one for one in map(_read_row, rows) if _has_words(one.entry, terms, query.whole_words))
    return list(islice(found, query.limit))


def _has_words(entry: CatalogueEntry, terms: Sequence[str], whole: bool) -> bool:
    if whole:
        return entry.words.issuperset(terms)
    return all(any(word.startswith(term) for word in entry.words) for term in terms)


def read_record(
    connection: Connection, station: str, kind: str, record_id: str
) -> CatalogueEntry | None:
    """A record with its files and figures; None if the catalogue has none."""
    row = connection.execute(
        select(RecordRow.__table__).where(
            RecordRow.station == station, RecordRow.kind == kind, RecordRow.id == record_id
        )
    ).one_or_none()
    if row is None:
        return None
    files = connection.execute(
        select(FileRow.path, FileRow.bytes, FileRow.sha256)
        .where(FileRow.record_key == row.key)
        .order_by(FileRow.path)
    )
    figures = connection.execute(
        select(
            FigureRow.symbol,
            FigureRow.quantity,
            FigureRow.value,
            FigureRow.unit,
            FigureRow.expanded_uncertainty,
            FigureRow.limit_value,
            FigureRow.decision,
        )
        .where(FigureRow.record_key == row.key)
        .order_by(FigureRow.number)
    )
    return CatalogueEntry(
        **{name: getattr(row, name) for name in OWN_FIELDS},
        files=tuple(EntryFile(*file) for file in files),
        figures=tuple(EntryFigure(*figure) for figure in figures),
    )


def read_scans(
    connection: Connection,
    station: str,
    since: datetime | None = None,
    until: datetime | None = None,
    calibration_ids: Sequence[str] = (),
) -> list[CatalogueEntry]:
    """The scans of a station, oldest first, without files.

    Args:
        since: the first moment, as ``until`` the last one, inclusive.
        calibration_ids: only with these, if there are any.
    """
    wanted = select(RecordRow.__table__).where(
        RecordRow.station == station, RecordRow.kind == "scan"
    )
    if since is not None:
        wanted = wanted.where(RecordRow.at >= since)
    if until is not None:
        wanted = wanted.where(RecordRow.at <= until)
    if calibration_ids:
        wanted = wanted.where(RecordRow.calibration_id.in_(calibration_ids))
    return [_read_row(row).entry for row in connection.execute(wanted.order_by(RecordRow.at))]


def list_newest_calibrations(connection: Connection) -> list[CatalogueEntry]:
    """The calibration that each station accepted last for each of its sensors, with its figures."""
    newest = (
        select(RecordRow.station, RecordRow.sensor_serial, func.max(RecordRow.at).label("at"))
        .where(RecordRow.kind == "calibration")
        .group_by(RecordRow.station, RecordRow.sensor_serial)
        .subquery()
    )
    rows = connection.execute(
        select(RecordRow.station, RecordRow.id)
        .join(
            newest,
            and_(
                RecordRow.station == newest.c.station,
                RecordRow.sensor_serial == newest.c.sensor_serial,
                RecordRow.at == newest.c.at,
            ),
        )
        .where(RecordRow.kind == "calibration")
        .order_by(RecordRow.station, RecordRow.sensor_serial)
    ).all()
    found = [read_record(connection, row[0], "calibration", row[1]) for row in rows]
    return [entry for entry in found if entry is not None]


def newest_calibration(
    connection: Connection, station: str, sensor_serial: str
) -> CatalogueEntry | None:
    """The calibration that a station accepted last for a sensor, without files and figures."""
    row = connection.execute(
        select(RecordRow.__table__)
        .where(
            RecordRow.station == station,
            RecordRow.kind == "calibration",
            RecordRow.sensor_serial == sensor_serial,
        )
        .order_by(RecordRow.at.desc())
        .limit(1)
    ).one_or_none()
    return None if row is None else _read_row(row).entry


Calibrations = dict[str, CalibrationMoment]
"""The calibrations of one station, each by its id and by the hash of its file."""


def calibrations_of(connection: Connection, station: str) -> Calibrations:
    """The calibrations of a station."""
    return calibrations_by_station(connection, [station]).get(station, {})


def calibrations_by_station(
    connection: Connection, stations: Sequence[str]
) -> dict[str, Calibrations]:
    """The calibrations of stations; of many, all of the catalogue are read at once."""
    wanted = select(
        RecordRow.station,
        RecordRow.calibration_sha256,
        RecordRow.id,
        RecordRow.at,
        RecordRow.temperature_c,
    ).where(RecordRow.kind == "calibration")
    if len(stations) <= NAMED_STATIONS:
        wanted = wanted.where(RecordRow.station.in_(stations))
    found: dict[str, Calibrations] = {}
    for station, sha256, calibration_id, at, temperature_c in connection.execute(wanted):
        moment = CalibrationMoment(calibration_id, at, temperature_c)
        own = found.setdefault(station, {})
        own[moment.id] = moment
        if sha256:
            own[sha256] = moment
    return found


def list_contents(connection: Connection, station: str) -> dict[str, KnownContent]:
    """The contents of a station's records that are there, by the name of the folder."""
    found = connection.execute(
        select(
            RecordRow.id,
            RecordRow.content,
            RecordRow.label,
            RecordRow.size_bytes,
            RecordRow.current_at,
            RecordRow.archived_at.is_not(None),
        ).where(RecordRow.station == station)
    )
    return {row[0]: KnownContent(*row[1:]) for row in found}


def figure_points(
    connection: Connection,
    quantity: str,
    stations: Sequence[str] = (),
    since: datetime | None = None,
    until: datetime | None = None,
    limit: int = 20_000,
) -> list[FigurePoint]:
    """The values of a quantity, oldest first; the newest ``limit`` of them.

    Args:
        stations: all of the catalogue if empty.
    """
    if not stations:
        stations = connection.scalars(select(StationRow.id)).all()
    wanted = select(
        FigureRow.station,
        FigureRow.at,
        FigureRow.value,
        FigureRow.unit,
        FigureRow.expanded_uncertainty,
        FigureRow.limit_value,
        FigureRow.decision,
        FigureRow.symbol,
        FigureRow.record_key,
    ).where(FigureRow.quantity == quantity)
    if since is not None:
        wanted = wanted.where(FigureRow.at >= since)
    if until is not None:
        wanted = wanted.where(FigureRow.at < until)
    newest = wanted.where(FigureRow.station == bindparam("of")).order_by(FigureRow.at.desc())
    newest = newest.limit(limit)
    found: list[FigurePoint] = []
    for station in stations:  # each is one range of the index
        found += [FigurePoint(*row) for row in connection.execute(newest, {"of": station})]
    return sorted(found, key=lambda point: (point.at, point.station))[-limit:]


def quantities(connection: Connection) -> dict[str, str]:
    """The quantities of which the catalogue has values, in order, each with its unit."""
    found: dict[str, str] = {}
    following = select(FigureRow.quantity, FigureRow.unit).order_by(FigureRow.quantity).limit(1)
    last = ""
    while True:  # from one to the next in the index: all rows would take seconds
        row = connection.execute(following.where(FigureRow.quantity > last)).one_or_none()
        if row is None:
            return found
        last = row.quantity
        found[last] = row.unit


def summarise_stations(connection: Connection) -> list[StationSummary]:
    """Every station, by its id."""
    rows = connection.execute(select(StationRow.__table__).order_by(StationRow.id))
    return [
        StationSummary(
            id=row.id,
            name=row.name or row.id,
            collected_at=row.collected_at,
            problem=row.problem,
            records=row.records,
            archived=row.archived,
            size_bytes=row.size_bytes,
            newest_at=row.newest_at,
        )
        for row in rows
    ]


def _add_filters(wanted: Select[Any], query: SearchQuery) -> Select[Any]:
    for column, value in (
        (RecordRow.station, query.station),
        (RecordRow.kind, query.kind),
        (RecordRow.verdict, query.verdict),
        (RecordRow.calibration_id, query.calibration_id),
    ):
        if value:
            wanted = wanted.where(column == value)
    if query.since is not None:
        wanted = wanted.where(RecordRow.at >= query.since)
    if query.until is not None:
        wanted = wanted.where(RecordRow.at < query.until)
    return wanted


def _matches(term: str, whole: bool) -> Any:
    if whole:
        return WordRow.word == term
    return and_(WordRow.word >= term, WordRow.word < term + BEHIND)


def _count_to(connection: Connection, matches: Any) -> int:
    """How many records have such a word, up to one more than ``RARE``."""
    some = select(WordRow.record_key).where(matches).limit(RARE + 1).subquery()
    return connection.scalar(select(func.count()).select_from(some)) or 0


def _read_row(row: "Row[Any]") -> FoundRecord:
    entry = CatalogueEntry(**{name: getattr(row, name) for name in OWN_FIELDS})
    return FoundRecord(row.key, entry, row.size_bytes)

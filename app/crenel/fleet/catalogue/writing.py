"""Writes entries to the catalogue: each record once, its newest content."""

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import asdict, dataclass, fields
from datetime import UTC, datetime
from typing import TYPE_CHECKING, Any, cast

from sqlalchemy import Connection, case, delete, insert, select, tuple_, update
from sqlalchemy.dialects import postgresql, sqlite

from crenel.fleet.catalogue.entry import CatalogueEntry, EntryFigure
from crenel.fleet.catalogue.tables import (
    CatalogueTable,
    FigureRow,
    FileRow,
    RecordRow,
    StationRow,
    WordRow,
)

if TYPE_CHECKING:
    from sqlalchemy.engine import Row

Values = dict[str, object]
Identity = tuple[str, str, str]
"""Station, kind and id."""
ENTRY_FIELDS = tuple(
    one.name for one in fields(CatalogueEntry) if one.name not in ("files", "figures", "current_at")
)
AT_ONCE = 200
"""Entries per statement: SQLite limits the number of values of one."""


def store_station(connection: Connection, station: str, name: str = "") -> None:
    """Lists a station; a name replaces an earlier one."""
    adding = _insert(connection, StationRow).values(id=station, name=name, problem="")
    if name:
        connection.execute(adding.on_conflict_do_update(index_elements=["id"], set_={"name": name}))
    else:
        connection.execute(adding.on_conflict_do_nothing(index_elements=["id"]))


def store_collection(
    connection: Connection, station: str, name: str, at: datetime | None, problem: str
) -> None:
    """What became of an attempt to collect from a station; ``at``: everything is there."""
    store_station(connection, station, name)
    found: dict[str, object] = {"problem": problem}
    if at is not None:
        found["collected_at"] = at
    connection.execute(update(StationRow).where(StationRow.id == station).values(**found))


def store_entries(connection: Connection, entries: Sequence[CatalogueEntry]) -> int:
    """Stores entries within a transaction; of a record, the content that was current last.

    Returns:
        The number of records that are new or have another content.
    """
    for station in {entry.station for entry in entries}:
        store_station(connection, station)
    newest: dict[Identity, CatalogueEntry] = {}
    for entry in sorted(entries, key=_current_at):
        newest[_identity(entry)] = entry
    every = list(newest.values())
    return sum(
        _store_some(connection, every[start : start + AT_ONCE])
        for start in range(0, len(every), AT_ONCE)
    )


def _store_some(connection: Connection, entries: Sequence[CatalogueEntry]) -> int:
    present = _present(connection, [_identity(entry) for entry in entries])
    changed = []
    counts: dict[str, StationCounts] = defaultdict(StationCounts)
    for entry in entries:
        known = present.get(_identity(entry))
        if known is None:
            counts[entry.station].add(entry.archived_at, entry.size_bytes, entry.at)
            changed.append(entry)
        elif known.content == entry.content:
            newly_archived = _note_again(connection, known, entry)
            counts[entry.station].archived += newly_archived
        elif known.current_at <= _current_at(entry):
            counts[entry.station].remove(known.archived_at, known.size_bytes)
            counts[entry.station].add(entry.archived_at, entry.size_bytes, entry.at)
            _forget_parts(connection, known)
            changed.append(entry)
    if changed:
        _insert_records(connection, changed)
    for station, its in counts.items():
        _add_counts(connection, station, its)
    return len(changed)


@dataclass
class StationCounts:
    """By how much the counts of a station change."""

    records: int = 0
    archived: int = 0
    size_bytes: int = 0
    newest_at: datetime | None = None

    def add(self, archived_at: datetime | None, size_bytes: int, at: datetime) -> None:
        self.records += 1
        self.archived += archived_at is not None
        self.size_bytes += size_bytes
        self.newest_at = at if self.newest_at is None else max(self.newest_at, at)

    def remove(self, archived_at: datetime | None, size_bytes: int) -> None:
        self.records -= 1
        self.archived -= archived_at is not None
        self.size_bytes -= size_bytes


def _add_counts(connection: Connection, station: str, by: StationCounts) -> None:
    values: dict[str, object] = {
        "records": StationRow.records + by.records,
        "archived": StationRow.archived + by.archived,
        "size_bytes": StationRow.size_bytes + by.size_bytes,
    }
    if by.newest_at is not None:
        newest = case(
            (StationRow.newest_at > by.newest_at, StationRow.newest_at), else_=by.newest_at
        )
        values["newest_at"] = newest
    connection.execute(update(StationRow).where(StationRow.id == station).values(**values))


def _present(connection: Connection, identities: Sequence[Identity]) -> dict[Identity, "Row[Any]"]:
    found = connection.execute(
        select(RecordRow.__table__).where(
            tuple_(RecordRow.station, RecordRow.kind, RecordRow.id).in_(identities)
        )
    )
    return {(row.station, row.kind, row.id): row for row in found}


def _note_again(connection: Connection, known: "Row[Any]", entry: CatalogueEntry) -> bool:
    """The content is known: it is current, perhaps under another name, or archived by now.

    Returns:
        Whether it is archived now and was not.
    """
    found: dict[str, object] = {}
    if _current_at(entry) > known.current_at:
        found["current_at"] = _current_at(entry)
        if entry.label != known.label:
            _forget_words(connection, known)
            _insert_words(connection, [(known.key, entry)])
            found["label"] = entry.label
    if entry.calibration_id and not known.calibration_id:  # an earlier look did not find it
        found["calibration_id"] = entry.calibration_id
    if entry.archived_at is not None and known.archived_at is None:
        found |= {"archived_at": entry.archived_at, "place": entry.place}
    if found:
        connection.execute(update(RecordRow).where(RecordRow.key == known.key).values(**found))
    return "archived_at" in found


def _forget_parts(connection: Connection, known: "Row[Any]") -> None:
    """Removes what belongs to the earlier content of a record."""
    for table in (FileRow, FigureRow):
        connection.execute(delete(table).where(table.record_key == known.key))
    _forget_words(connection, known)


def _forget_words(connection: Connection, known: "Row[Any]") -> None:
    words = CatalogueEntry(**{name: getattr(known, name) for name in ENTRY_FIELDS}).words
    connection.execute(
        delete(WordRow).where(
            WordRow.word.in_(sorted(words)), WordRow.at == known.at, WordRow.record_key == known.key
        )
    )


def _insert_records(connection: Connection, entries: Sequence[CatalogueEntry]) -> None:
    adding = _insert(connection, RecordRow)
    names = (*ENTRY_FIELDS, "current_at", "size_bytes")
    storing = adding.on_conflict_do_update(
        index_elements=["station", "kind", "id"],
        set_={name: adding.excluded[name] for name in names},
    ).returning(RecordRow.key, sort_by_parameter_order=True)
    rows = [_record_values(entry) for entry in entries]
    keys: Sequence[int] = connection.scalars(storing, rows).all()
    files: list[Values] = []
    figures: list[Values] = []
    found = list(zip(keys, entries, strict=True))
    for key, entry in found:
        files += [{"record_key": key, **asdict(file)} for file in entry.files]
        figures += [
            _figure_values(key, number, entry, figure)
            for number, figure in enumerate(entry.figures)
        ]
    for table, values in ((FileRow, files), (FigureRow, figures)):
        if values:
            connection.execute(insert(table), values)
    _insert_words(connection, found)


def _insert_words(connection: Connection, found: Sequence[tuple[int, CatalogueEntry]]) -> None:
    words = [
        {"record_key": key, "at": entry.at, "word": word}
        for key, entry in found
        for word in entry.words
    ]
    connection.execute(insert(WordRow), words)


def _record_values(entry: CatalogueEntry) -> Values:
    fixed = {name: getattr(entry, name) for name in ENTRY_FIELDS}
    return {**fixed, "current_at": _current_at(entry), "size_bytes": entry.size_bytes}


def _figure_values(key: int, number: int, entry: CatalogueEntry, figure: EntryFigure) -> Values:
    values = asdict(figure)
    limit = values.pop("limit")
    place = {"record_key": key, "number": number, "station": entry.station, "at": entry.at}
    return {**place, **values, "limit_value": limit}


def _insert(connection: Connection, table: type[CatalogueTable]) -> "sqlite.Insert":
    """The insertion of the database's own dialect; those of SQLite and PostgreSQL are alike."""
    if connection.dialect.name == "postgresql":
        return cast("sqlite.Insert", postgresql.insert(table))
    return sqlite.insert(table)


def _identity(entry: CatalogueEntry) -> Identity:
    return entry.station, entry.kind, entry.id


def _current_at(entry: CatalogueEntry) -> datetime:
    return entry.current_at or entry.archived_at or datetime.fromtimestamp(0, UTC)

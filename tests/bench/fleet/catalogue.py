"""Fills a catalogue with invented records, and measures how long its questions take."""

import statistics
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from datetime import timedelta
from itertools import islice
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from crenel.fleet.ageing import ageing_of, spread_of
from crenel.fleet.catalogue.catalogue import FleetCatalogue
from crenel.fleet.catalogue.entry import CatalogueEntry
from crenel.fleet.catalogue.reading import (
    SearchQuery,
    figure_points,
    quantities,
    read_record,
    search,
    summarise_stations,
)
from crenel.messages.message import Text
from crenel.progress import Progress
from tests.bench.fleet.invented import START, invent_entries

if TYPE_CHECKING:
    from sqlalchemy import Connection

AT_ONCE = 2000
ROUNDS = 5
COLUMNS: Sequence[Text] = ("question", "answers", "median, ms", "longest, ms")


@dataclass(frozen=True)
class QuestionTime:
    """How long one question took."""

    question: str
    answers: int
    median_ms: float
    longest_ms: float


@dataclass
class CatalogueFigures:
    """What was stored, how fast, and how fast it is found."""

    records: int = 0
    rows: int = 0
    """Of all tables."""
    store_s: float = 0.0
    bytes: int = 0
    """Of the database's file; 0 of a server."""
    questions: list[QuestionTime] = field(default_factory=list)

    @property
    def us_per_row(self) -> float:
        """To store it."""
        return 1e6 * self.store_s / max(self.rows, 1)


def run(rows: int, stations: int, url: str, progress: Progress) -> CatalogueFigures:
    """Stores at least so many rows of so many stations, then asks.

    Args:
        url: of an empty catalogue; empty: a new file of SQLite, removed at the end.
    """
    with TemporaryDirectory(prefix="crenel-bench-") as folder:
        file = Path(folder) / "catalogue.db"
        with FleetCatalogue(url or f"sqlite:///{file}") as catalogue:
            found = _fill(catalogue, rows, stations, progress)
            if not url:
                found.bytes = sum(one.stat().st_size for one in Path(folder).iterdir())
            with catalogue.reading() as connection:
                for name, ask in _questions(found.records, stations).items():
                    found.questions.append(_time(name, ask, connection))
    return found


def table(found: CatalogueFigures) -> list[Sequence[Text]]:
    """A row per question, and what was stored."""
    rows: list[Sequence[Text]] = [
        (one.question, f"{one.answers}", f"{one.median_ms:.1f}", f"{one.longest_ms:.1f}")
        for one in found.questions
    ]
    stored = f"{found.records} records, {found.rows} rows"
    if found.bytes:
        stored += f", {found.bytes / 1e6:.0f} MB"
    rows.append((stored, "", "", ""))
    rows.append((f"stored in {found.store_s:.0f} s, {found.us_per_row:.0f} µs per row", "", "", ""))
    return rows


def _fill(
    catalogue: FleetCatalogue, rows: int, stations: int, progress: Progress
) -> CatalogueFigures:
    found = CatalogueFigures()
    entries = invent_entries(stations, rows)
    while found.rows < rows:
        some = list(islice(entries, AT_ONCE))
        began_s = time.perf_counter()
        catalogue.add(some)
        found.store_s += time.perf_counter() - began_s
        found.records += len(some)
        found.rows += sum(map(_count_rows, some))
        progress(min(found.rows / rows, 1.0), f"{found.rows} rows")
    return found


def _count_rows(entry: CatalogueEntry) -> int:
    return 1 + len(entry.files) + len(entry.figures) + len(entry.words)


def _questions(records: int, stations: int) -> "dict[str, Callable[[Connection], int]]":
    """Each with the number of its answers."""
    own = records // stations
    middle = START + timedelta(minutes=26) * (own // 2)
    number = min(7 + 20 * stations, records - 1)
    sample = next(islice(invent_entries(stations, records), number, None))

    def finder(**query: object) -> "Callable[[Connection], int]":
        wanted = SearchQuery(**query)  # type: ignore[arg-type]
        return lambda connection: len(search(connection, wanted))

    return {
        "a part by its number": finder(text="housing 4711"),
        "a word that an eighth of all records have": finder(text="impeller"),
        "two words that many records have": finder(text="blade ada"),
        "one day of one station": finder(
            station="room-7", since=middle, until=middle + timedelta(days=1)
        ),
        "scans with one calibration": finder(calibration_id=sample.calibration_id, limit=1000),
        "failed tests of all stations": finder(kind="performance", verdict="fail"),
        "one record with results and files": lambda connection: (
            read_record(connection, sample.station, sample.kind, sample.id) is not None
        ),
        "a symbol of one station, all years": lambda connection: len(
            figure_points(connection, "location-scan", ["room-7"])
        ),
        "a symbol of all stations, a year": lambda connection: len(
            figure_points(connection, "location-scan", since=middle)
        ),
        "calibrations of every sensor": lambda connection: sum(
            len(sensor.values) for sensor in spread_of(connection, "point-uncertainty")
        ),
        "ageing of a gauge's offset at one station": lambda connection: sum(
            len(station.points) for station in ageing_of(connection, "gauge-offset", ["room-7"])
        ),
        "ageing of a gauge's offset at all stations": lambda connection: sum(
            len(station.points) for station in ageing_of(connection, "gauge-offset")
        ),
        "which quantities there are": lambda connection: len(quantities(connection)),
        "all stations with their counts": lambda connection: len(summarise_stations(connection)),
    }


def _time(name: str, ask: "Callable[[Connection], int]", connection: "Connection") -> QuestionTime:
    times_ms, answers = [], 0
    for _ in range(ROUNDS):
        began_s = time.perf_counter()
        answers = ask(connection)
        times_ms.append(1e3 * (time.perf_counter() - began_s))
    return QuestionTime(name, int(answers), statistics.median(times_ms), max(times_ms))

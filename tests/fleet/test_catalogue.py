"""The catalogue stores each record once, finds it again, and opens those of earlier versions."""

import sqlite3
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing, contextmanager
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from alembic.autogenerate import compare_metadata
from alembic.runtime.migration import MigrationContext
from sqlalchemy import Connection, Engine, text

from crenel.errors import OperationError
from crenel.fleet.catalogue import database, reading
from crenel.fleet.catalogue.catalogue import FleetCatalogue
from crenel.fleet.catalogue.database import CatalogueError
from crenel.fleet.catalogue.entry import CatalogueEntry, EntryFile
from crenel.fleet.catalogue.tables import CatalogueTable
from tests.fleet.entries import START, entry_of, figure_of
from tests.fleet.postgres import PostgresServer

pytestmark = pytest.mark.device

FIRST = Path(__file__).parent / "revision_1.sql"
"""Of a catalogue that the first version made."""


ROWS = ("station", "record", "file", "figure")
"""The tables, each behind those that it refers to."""


def found_ids(catalogue: FleetCatalogue, **query: object) -> list[str]:
    with catalogue.reading() as connection:
        found = reading.search(connection, reading.SearchQuery(**query))  # type: ignore[arg-type]
    return [f"{one.entry.station}/{one.entry.id}" for one in found]


def read(catalogue: FleetCatalogue, entry: CatalogueEntry) -> CatalogueEntry | None:
    with catalogue.reading() as connection:
        return reading.read_record(connection, entry.station, entry.kind, entry.id)


def test_an_entry_comes_back_as_it_was(catalogue: FleetCatalogue) -> None:
    entry = entry_of(
        1,
        kind="performance",
        verdict="fail",
        temperature_c=20.4,
        figures=(figure_of(12.5), figure_of(-3.0, "size-scan", limit=None, decision="none")),
        files=(EntryFile("performance.json", 7, "d" * 64), EntryFile("plan.json", 5, "e" * 64)),
    )
    assert catalogue.add([entry]) == 1
    assert read(catalogue, entry) == entry


def test_the_same_record_is_stored_once(catalogue: FleetCatalogue) -> None:
    entries = [entry_of(number, figures=(figure_of(1.0),)) for number in range(5)]
    assert catalogue.add(entries) == 5
    assert catalogue.add(entries[:3] + entries) == 0
    assert len(found_ids(catalogue)) == 5
    with catalogue.reading() as connection:
        assert len(reading.figure_points(connection, "location-scan")) == 5


def test_ids_are_the_stations_own(catalogue: FleetCatalogue) -> None:
    catalogue.add([entry_of(1), entry_of(1, station="room-2")])
    assert sorted(found_ids(catalogue)) == ["room-1/scan-1", "room-2/scan-1"]


def test_the_content_that_was_current_last_counts(catalogue: FleetCatalogue) -> None:
    first = entry_of(1, figures=(figure_of(1.0),))
    files = (EntryFile("scan.mcap", 5, "f" * 64),)
    later = replace(first, content="f" * 16, label="Cover 9", files=files, figures=())
    later = replace(later, current_at=START + timedelta(days=2))
    catalogue.add([first])
    assert catalogue.add([later]) == 1
    assert catalogue.add([first]) == 0
    assert read(catalogue, first) == later
    assert found_ids(catalogue, text="housing") == []
    assert found_ids(catalogue, text="cover") == ["room-1/scan-1"]


def test_a_record_is_archived_and_renamed_without_new_content(catalogue: FleetCatalogue) -> None:
    entry = entry_of(1)
    catalogue.add([entry])
    archived = START + timedelta(days=1)
    assert catalogue.add([replace(entry, archived_at=archived, place="s3://plant/1")]) == 0
    renamed = replace(entry, label="Bracket 12", current_at=START + timedelta(days=3))
    assert catalogue.add([renamed]) == 0
    assert read(catalogue, entry) == replace(renamed, archived_at=archived, place="s3://plant/1")
    assert found_ids(catalogue, text="bracket 12") == ["room-1/scan-1"]
    assert found_ids(catalogue, text="4711") == []


def test_search_takes_beginnings_of_words_and_all_of_them(catalogue: FleetCatalogue) -> None:
    other_room = entry_of(3, label="Gehäuse 4711", station="room-2")
    by_emile = entry_of(2, label="Housing 4712", operator="Émile")
    catalogue.add([entry_of(1, label="Housing 4711-B"), by_emile, other_room])
    assert found_ids(catalogue, text="4711") == ["room-2/scan-3", "room-1/scan-1"]
    assert found_ids(catalogue, text="hous 47") == ["room-1/scan-2", "room-1/scan-1"]
    assert found_ids(catalogue, text="GEHÄUSE") == ["room-2/scan-3"]
    assert found_ids(catalogue, text="éMI a-17") == ["room-1/scan-2"]
    assert found_ids(catalogue, text="711") == []
    assert found_ids(catalogue, text="4711", station="room-1") == ["room-1/scan-1"]


def test_a_word_that_most_records_have_is_found_with_any_other(catalogue: FleetCatalogue) -> None:
    catalogue.add([entry_of(number, label=f"Housing {number}") for number in range(1500)])
    assert found_ids(catalogue, text="housing", limit=2) == ["room-1/scan-1499", "room-1/scan-1498"]
    assert found_ids(catalogue, text="housing 1203") == ["room-1/scan-1203"]
    assert found_ids(catalogue, text="ada hous", limit=1) == ["room-1/scan-1499"]


def test_search_by_period_kind_verdict_and_calibration(catalogue: FleetCatalogue) -> None:
    failed = entry_of(2, kind="verification", verdict="fail")
    catalogue.add([entry_of(1, calibration_id="cal-2"), failed, entry_of(3)])
    hour = timedelta(hours=1)
    found = found_ids(catalogue, since=START + 2 * hour)
    assert found == ["room-1/scan-3", "room-1/verification-2"]
    assert found_ids(catalogue, until=START + 2 * hour) == ["room-1/scan-1"]
    assert found_ids(catalogue, kind="scan") == ["room-1/scan-3", "room-1/scan-1"]
    assert found_ids(catalogue, verdict="fail") == ["room-1/verification-2"]
    assert found_ids(catalogue, calibration_id="cal-2") == ["room-1/scan-1"]


def test_pages_go_on_where_the_last_one_ended(catalogue: FleetCatalogue) -> None:
    catalogue.add([entry_of(number, at=START) for number in range(7)])
    seen: list[str] = []
    before = None
    while True:
        with catalogue.reading() as connection:
            page = reading.search(connection, reading.SearchQuery(limit=3, before=before))
        if not page:
            break
        seen += [one.entry.id for one in page]
        before = page[-1].entry.at, page[-1].key
    assert sorted(seen) == sorted(f"scan-{number}" for number in range(7))


def test_a_figure_over_time_and_stations(catalogue: FleetCatalogue) -> None:
    two = (figure_of(2.0), figure_of(9.0, "size-scan"))
    first = entry_of(1, kind="performance", figures=(figure_of(1.0),))
    other = entry_of(3, "room-2", kind="performance", figures=(figure_of(3.0),))
    catalogue.add([entry_of(2, kind="performance", figures=two), first, other])
    with catalogue.reading() as connection:
        points = reading.figure_points(connection, "location-scan")
        found = [(one.station, one.value) for one in points]
        assert found == [("room-1", 1.0), ("room-1", 2.0), ("room-2", 3.0)]
        assert points[0].limit == 40.0
        assert points[0].at == START + timedelta(hours=1)
        only = reading.figure_points(connection, "location-scan", ["room-2"])
        assert [one.value for one in only] == [3.0]
        since = reading.figure_points(connection, "location-scan", since=START + timedelta(hours=2))
        assert [one.value for one in since] == [2.0, 3.0]
        assert reading.quantities(connection) == {"location-scan": "µm", "size-scan": "µm"}


def test_stations_with_their_counts(catalogue: FleetCatalogue) -> None:
    catalogue.add([entry_of(2, archived_at=START), entry_of(3), entry_of(1)])
    smaller = (EntryFile("scan.mcap", 7, "f" * 64),)
    later = START + timedelta(days=1)
    catalogue.add([entry_of(1, archived_at=later), entry_of(2, archived_at=START)])
    catalogue.add([entry_of(3, content="9" * 16, files=smaller, current_at=later)])
    catalogue.note_collection("room-1", "Measuring room 1", START)
    catalogue.note_collection("room-2", "", None, "the archive is away")
    with catalogue.reading() as connection:
        first, second = reading.summarise_stations(connection)
        known = reading.list_contents(connection, "room-1")
    assert (first.name, first.records, first.archived) == ("Measuring room 1", 3, 2)
    assert first.size_bytes == 1001 + 1002 + 18 + 7
    assert (first.collected_at, first.newest_at) == (START, START + timedelta(hours=3))
    assert (second.name, second.records, second.problem) == ("room-2", 0, "the archive is away")
    assert known["scan-2"].archived
    assert not known["scan-3"].archived


def test_two_writers_at_once_store_every_record_once(url: str) -> None:
    entries = [entry_of(number, figures=(figure_of(1.0),)) for number in range(60)]

    def write() -> None:
        with FleetCatalogue(url) as own:
            for start in range(0, 60, 10):
                own.add(entries[start : start + 10])

    with ThreadPoolExecutor(3) as threads:
        for done in [threads.submit(write) for _ in range(3)]:
            done.result()
    with FleetCatalogue(url) as catalogue:
        assert len(found_ids(catalogue, limit=1000)) == 60


def test_a_database_that_is_away_is_one_clear_line() -> None:
    with pytest.raises(CatalogueError) as caught:
        FleetCatalogue("postgresql://crenel:secret@127.0.0.1:1/plant")
    assert "postgresql://127.0.0.1:1/plant cannot be used now" in caught.value.line
    assert "secret" not in caught.value.line


def test_what_a_user_lacks_is_named(postgres: PostgresServer) -> None:
    postgres.add_reader()

    def refusal(user: str, name: str) -> str:
        with pytest.raises(CatalogueError) as refused:
            FleetCatalogue(f"postgresql://{user}@127.0.0.1:{postgres.port}/{name}")
        assert "LINE" not in refused.value.line
        assert "\n" not in refused.value.line
        return str(refused.value.remedy)

    for user, name in (("reader:wrong", "postgres"), ("reader:secret", "none")):
        assert refusal(user, name).startswith("Check the user, password_file and the name")
    assert refusal("reader:secret", "postgres").startswith("Let the user own the database")


def test_a_folder_that_is_not_there_is_named(tmp_path: Path) -> None:
    with pytest.raises(CatalogueError) as refused:
        FleetCatalogue(f"sqlite:///{tmp_path}/none/catalogue.db")
    assert str(refused.value.remedy).startswith("Check that its folder is there")


@contextmanager
def connected(engine: Engine) -> Iterator[Connection]:
    try:
        with engine.begin() as connection:
            yield connection
    finally:
        engine.dispose()


def check_content(url: str) -> None:
    with FleetCatalogue(url) as catalogue, catalogue.reading() as connection:
        record = reading.read_record(connection, "room-1", "performance", "20260504-101500-ab12")
        assert record is not None
        assert (record.figures[0].value, record.files[0].path) == (12.5, "performance.json")
        assert [one.value for one in reading.figure_points(connection, "location-scan")] == [12.5]
        found = reading.search(connection, reading.SearchQuery(text="housing 4711"))
        assert [one.entry.id for one in found] == ["20260504-111500"]
        (station,) = reading.summarise_stations(connection)
        assert (station.records, station.archived, station.size_bytes) == (2, 0, 24)
        assert station.newest_at == datetime(2026, 5, 4, 10, 12, tzinfo=UTC)


def test_a_database_of_the_first_version_opens(tmp_path: Path) -> None:
    path = tmp_path / "catalogue.db"
    with closing(sqlite3.connect(path)) as made:
        made.executescript(FIRST.read_text())
    check_content(f"sqlite:///{path}")
    check_content(f"sqlite:///{path}")


@pytest.mark.parametrize("revision", [database.FIRST_REVISION, "0002", database.LAST_REVISION])
def test_what_the_first_version_stored_is_there_by_way_of_each(url: str, revision: str) -> None:
    engine = database.create_engine(url)
    database.upgrade(engine, database.FIRST_REVISION)
    lines = FIRST.read_text().splitlines()
    with connected(engine) as connection:
        for table in ROWS:
            for one in lines:
                if one.startswith(f"INSERT INTO {table} "):
                    connection.execute(text(one))
    database.upgrade(engine, revision)
    engine.dispose()
    check_content(url)


def test_the_migrations_lead_to_the_tables_of_today(url: str) -> None:
    with connected(database.open_engine(url)) as connection:
        found = MigrationContext.configure(connection)
        assert found.get_current_revision() == database.LAST_REVISION
        assert compare_metadata(found, CatalogueTable.metadata) == []


def test_a_later_version_is_refused(url: str) -> None:
    with connected(database.open_engine(url)) as connection:
        connection.execute(text("UPDATE alembic_version SET version_num = '9999'"))
    with pytest.raises(OperationError, match="made by a later version"):
        FleetCatalogue(url)

"""Catalogues of every earlier version open, with all that is in them."""

import sqlite3
from collections.abc import Iterator
from contextlib import closing, contextmanager
from datetime import UTC, datetime
from pathlib import Path

import pytest
from alembic.autogenerate import compare_metadata
from alembic.runtime.migration import MigrationContext
from sqlalchemy import Connection, Engine, text

from app.errors import OperationError
from app.fleet.catalogue import database, reading
from app.fleet.catalogue.catalogue import FleetCatalogue
from app.fleet.catalogue.tables import CatalogueTable

pytestmark = pytest.mark.device

FIRST = Path(__file__).parent / "revision_1.sql"
"""Of a catalogue that the first version made."""


ROWS = ("station", "record", "file", "figure")
"""The tables, each behind those that it refers to."""


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

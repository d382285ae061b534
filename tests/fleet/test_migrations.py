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
from app.fleet.catalogue.catalogue import FleetCatalogue
from app.fleet.catalogue.database import (
    FIRST_REVISION,
    LAST_REVISION,
    create_engine,
    open_engine,
    upgrade,
)
from app.fleet.catalogue.reading import (
    SearchQuery,
    figure_points,
    read_record,
    search,
    summarise_stations,
)
from app.fleet.catalogue.tables import CatalogueTable

pytestmark = pytest.mark.device

FIRST = Path(__file__).parent / "revision_1.sql"
"""Of a catalogue that the first version made."""


ROWS = ("station", "record", "file", "figure")
"""The tables, each behind those that it refers to."""


def insertions() -> list[str]:
    """The statements that fill the first version's tables."""
    lines = FIRST.read_text().splitlines()
    return [one for table in ROWS for one in lines if one.startswith(f"INSERT INTO {table} ")]


@contextmanager
def connected(engine: Engine) -> Iterator[Connection]:
    try:
        with engine.begin() as connection:
            yield connection
    finally:
        engine.dispose()


def check_content(url: str) -> None:
    """What the first version stored is there, and is found as records of today are."""
    with FleetCatalogue(url) as catalogue, catalogue.reading() as connection:
        record = read_record(connection, "room-1", "performance", "20260504-101500-ab12")
        assert record is not None
        assert record.figures[0].value == 12.5
        assert record.files[0].path == "performance.json"
        assert [one.value for one in figure_points(connection, "location-scan")] == [12.5]
        found = search(connection, SearchQuery(text="housing 4711"))
        assert [one.entry.id for one in found] == ["20260504-111500"]
        (station,) = summarise_stations(connection)
        assert (station.records, station.archived, station.size_bytes) == (2, 0, 24)
        assert station.newest_at == datetime(2026, 5, 4, 10, 12, tzinfo=UTC)


def test_a_database_of_the_first_version_opens(tmp_path: Path) -> None:
    path = tmp_path / "catalogue.db"
    with closing(sqlite3.connect(path)) as made:
        made.executescript(FIRST.read_text())
    check_content(f"sqlite:///{path}")
    check_content(f"sqlite:///{path}")


def test_the_first_version_is_brought_up_to_date_in_both_databases(url: str) -> None:
    engine = create_engine(url)
    upgrade(engine, FIRST_REVISION)
    with connected(engine) as connection:
        for one in insertions():
            connection.execute(text(one))
    check_content(url)


@pytest.mark.parametrize("revision", ["0002", LAST_REVISION])
def test_what_the_first_version_stored_is_there_by_way_of_each_later_one(
    url: str, revision: str
) -> None:
    engine = create_engine(url)
    upgrade(engine, FIRST_REVISION)
    with connected(engine) as connection:
        for one in insertions():
            connection.execute(text(one))
    upgrade(engine, revision)
    engine.dispose()
    check_content(url)


def test_the_migrations_lead_to_the_tables_of_today(url: str) -> None:
    with connected(open_engine(url)) as connection:
        found = MigrationContext.configure(connection)
        assert found.get_current_revision() == LAST_REVISION
        assert compare_metadata(found, CatalogueTable.metadata) == []


def test_a_later_version_is_refused(url: str) -> None:
    with connected(open_engine(url)) as connection:
        connection.execute(text("UPDATE alembic_version SET version_num = '9999'"))
    with pytest.raises(OperationError, match="made by a later version"):
        FleetCatalogue(url)

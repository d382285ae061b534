"""Catalogues in both databases."""

from collections.abc import Iterator
from pathlib import Path

import pytest

pytest.importorskip("sqlalchemy")
pytest.importorskip("alembic")
pytest.importorskip("psycopg")

from crenel.fleet.catalogue.catalogue import FleetCatalogue
from crenel.store.store import Store
from tests.fleet.postgres import PostgresServer, has_postgres, running_postgres


@pytest.fixture(scope="session")
def postgres() -> Iterator[PostgresServer]:
    if not has_postgres():
        pytest.skip("postgresql is not installed")
    with running_postgres() as server:
        yield server


@pytest.fixture(params=["sqlite", "postgresql"])
def url(request: pytest.FixtureRequest, tmp_path: Path) -> str:
    """An address of no catalogue yet."""
    if request.param == "sqlite":
        return f"sqlite:///{tmp_path}/catalogue.db"
    server: PostgresServer = request.getfixturevalue("postgres")
    return server.new_database()


@pytest.fixture
def store(tmp_path: Path) -> Iterator[Store]:
    opened = Store(tmp_path / "data")
    yield opened
    opened.close()


@pytest.fixture
def own(tmp_path: Path) -> Iterator[FleetCatalogue]:
    """An empty catalogue in a file, which settings call ``sqlite:///catalogue.db``."""
    with FleetCatalogue(f"sqlite:///{tmp_path}/catalogue.db") as opened:
        yield opened


@pytest.fixture
def catalogue(url: str) -> Iterator[FleetCatalogue]:
    with FleetCatalogue(url) as opened:
        yield opened

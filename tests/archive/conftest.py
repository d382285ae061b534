"""A station's data folder, and a folder for its archive."""

from pathlib import Path

import pytest

from app.store.store import Store
from tests.archive.filled import add_scan, archive_of
from tests.store.conftest import store

__all__ = ["store"]  # a fixture


@pytest.fixture
def place(tmp_path: Path) -> Path:
    folder = tmp_path / "archive"
    folder.mkdir()
    return folder


@pytest.fixture
def archived(store: Store, place: Path) -> Path:
    """The folder of the scan ``one``, which is in the archive."""
    folder = add_scan(store, "one", 1000)
    archive_of(store, str(place)).run()
    return folder

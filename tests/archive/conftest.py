"""A station's data folder with its archive in another folder."""

from pathlib import Path

import pytest

from crenel.store.store import Store
from tests.archive.filled import Room
from tests.store.conftest import store

__all__ = ["store"]  # a fixture


@pytest.fixture
def place(tmp_path: Path) -> Path:
    folder = tmp_path / "archive"
    folder.mkdir()
    return folder


@pytest.fixture
def room(store: Store, place: Path) -> Room:
    return Room(store, place)


@pytest.fixture
def archived(room: Room) -> Path:
    """The folder of the scan ``one``, which is in the archive."""
    folder = room.add_scan("one", 1000)
    room.archive().run()
    return folder

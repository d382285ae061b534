"""The store of a data folder, closed after the test."""

import sqlite3
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any

import pytest

from crenel.store.store import Store

FIGURES: dict[str, Any] = {
    "total_um": 20.5,
    "verdict": "good",
    "arm_serial": "A1",
    "object_serial": "B1",
    "sensor_serial": "S1",
}


@pytest.fixture
def store(tmp_path: Path) -> Iterator[Store]:
    with closing(Store(tmp_path / "data")) as opened:
        yield opened


@pytest.fixture
def calibrated(store: Store) -> Store:
    """The store, with the calibration ``c1``."""
    accept_calibration(store, "c1")
    return store


def accept_calibration(store: Store, session: str, sensor: str = "") -> None:
    store.journal.begin_session(session, "calibration")
    file = store.folder / "sessions" / session / "calibration.json"
    name = f"Calibration {session}"
    store.calibrations.accept(session, name, file, FIGURES, None, sensor=sensor)


@contextmanager
def reopened(store: Store) -> Iterator[Store]:
    """Another store of the same data folder."""
    store.close()
    with closing(Store(store.folder)) as again:
        yield again


def open_database(store: Store) -> closing[sqlite3.Connection]:
    """The file of the store, without what guards it."""
    return closing(sqlite3.connect(store.folder / "station.db"))

"""Verifications and temperatures in the station's database."""

import json
import sqlite3

import pytest

from app.messages.message import message
from app.store import temperatures
from app.store.store import Store
from tests.store.conftest import open_database, reopened

FOUND = {
    "result": "pass",
    "text": "Every figure keeps its limit.",
    "shape": "plane",
    "gauge": "Plate",
    "clouds": 3,
    "touched": True,
    "operator": "Anna",
}


def test_the_newest_verification_of_a_calibration_is_found_again(calibrated: Store) -> None:
    store = calibrated
    assert store.verifications.newest_for("c1") is None
    for name in ("v1", "v2"):
        store.journal.begin_session(name, "verify")
        folder = store.folder / "verifications" / name
        store.verifications.accept(name, "c1", folder, FOUND, f"key-{name}")
    with reopened(store) as again:
        newest = again.verifications.newest_for("c1")
        assert newest is not None
        assert (newest.id, newest.folder) == ("v2", again.folder / "verifications/v2")
        assert [record.id for record in again.verifications.all()] == ["v2", "v1"]
        assert again.verifications.newest() == newest
        session = again.journal.latest_session("verify")
        assert session is not None
        assert session.ended_at is not None


def test_a_verdict_is_english_with_its_message_next_to_it(calibrated: Store) -> None:
    store = calibrated
    store.journal.begin_session("v1", "verify")
    text = message("file-cut-off")
    folder = store.folder / "verifications/v1"
    store.verifications.accept("v1", "c1", folder, FOUND | {"text": text}, None)
    (record,) = store.verifications.all()
    assert record.figures.text == text
    with open_database(store) as database:
        ((figures,),) = database.execute("SELECT figures FROM verification").fetchall()
    assert json.loads(figures)["text"] == "the file is incomplete"


def test_a_key_that_was_used_keeps_nothing_twice(calibrated: Store) -> None:
    store = calibrated
    store.journal.begin_session("v1", "verify")
    store.journal.append("v1", "cloud_begun", {}, "k")
    with pytest.raises(sqlite3.IntegrityError):
        store.verifications.accept("v1", "c1", store.folder / "verifications/v1", FOUND, "k")
    assert store.verifications.all() == []


def test_a_temperature_counts_only_near_its_time(
    store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert store.temperatures.newest() is None
    for at, celsius in (("2026-11-21T08:00:00.000Z", 20.0), ("2026-11-21T10:00:00.000Z", 21.5)):
        monkeypatch.setattr(temperatures, "utc_now", lambda at=at: at)
        store.temperatures.add(celsius, "Anna")
    near = store.temperatures.near("2026-11-21T08:40:00Z")
    assert near is not None
    assert near.celsius == 20.0
    newest = store.temperatures.newest()
    assert newest is not None
    assert newest.celsius == 21.5
    assert store.temperatures.near("2026-11-21T14:00:00Z") is None
    assert store.temperatures.change_since("2026-11-21T08:00:00Z") == 1.5
    assert store.temperatures.change_since("2026-11-21T09:30:00Z") is None, "one reading alone"

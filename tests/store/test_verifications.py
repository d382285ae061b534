"""Verifications and temperatures in the station's database."""

import json
import sqlite3
from pathlib import Path

import pytest

from app.messages.message import message
from app.store import temperatures
from app.store.schemas import ACCESS, FIRST, SUPERVISION
from app.store.store import Store

CALIBRATED = {
    "total_um": 20.5,
    "verdict": "good",
    "arm_serial": "A1",
    "object_serial": "B1",
    "sensor_serial": "S1",
}
FOUND = {
    "result": "pass",
    "text": "Every figure keeps its limit.",
    "shape": "plane",
    "gauge": "Plate",
    "clouds": 3,
    "touched": True,
    "operator": "Anna",
}


def calibrated(folder: Path) -> Store:
    store = Store(folder)
    store.journal.begin_session("c1", "calibration")
    store.calibrations.accept("c1", "First", store.folder / "c.json", CALIBRATED, None)
    return store


def test_the_newest_verification_of_a_calibration_is_found_again(tmp_path: Path) -> None:
    store = calibrated(tmp_path)
    assert store.verifications.newest_for("c1") is None
    for name in ("v1", "v2"):
        store.journal.begin_session(name, "verify")
        folder = store.folder / "verifications" / name
        store.verifications.accept(name, "c1", folder, FOUND, f"key-{name}")
    store.close()
    again = Store(tmp_path)
    newest = again.verifications.newest_for("c1")
    assert newest is not None
    assert (newest.id, newest.folder) == ("v2", again.folder / "verifications/v2")
    assert [record.id for record in again.verifications.all()] == ["v2", "v1"]
    assert again.verifications.newest() == newest
    session = again.journal.latest_session("verify")
    assert session is not None
    assert session.ended_at is not None
    again.close()


def test_a_verdict_is_english_with_its_message_next_to_it(tmp_path: Path) -> None:
    store = calibrated(tmp_path)
    store.journal.begin_session("v1", "verify")
    text = message("file-cut-off")
    folder = store.folder / "verifications/v1"
    store.verifications.accept("v1", "c1", folder, FOUND | {"text": text}, None)
    (record,) = store.verifications.all()
    assert record.figures.text == text
    store.close()
    database = sqlite3.connect(tmp_path / "station.db")
    ((figures,),) = database.execute("SELECT figures FROM verification").fetchall()
    database.close()
    assert json.loads(figures)["text"] == "the file is incomplete"


def test_a_key_that_was_used_keeps_nothing_twice(tmp_path: Path) -> None:
    store = calibrated(tmp_path)
    store.journal.begin_session("v1", "verify")
    store.journal.append("v1", "cloud_begun", {}, "k")
    with pytest.raises(sqlite3.IntegrityError):
        store.verifications.accept("v1", "c1", store.folder / "verifications/v1", FOUND, "k")
    assert store.verifications.all() == []
    store.close()


def test_a_temperature_counts_only_near_its_time(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    store = Store(tmp_path)
    assert store.temperatures.newest() is None
    for at, celsius in (
        ("2026-11-21T08:00:00.000Z", 20.0),
        ("2026-11-21T10:00:00.000Z", 21.5),
    ):
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
    store.close()


def test_a_database_of_the_version_before_is_brought_up_to_date(tmp_path: Path) -> None:
    old = sqlite3.connect(tmp_path / "station.db")
    old.executescript(f"{FIRST} {ACCESS} {SUPERVISION} PRAGMA user_version = 3;")
    old.execute("INSERT INTO session (id, kind, started_at) VALUES ('s', 'calibration', 't')")
    old.commit()
    old.close()
    store = Store(tmp_path)
    assert store.journal.latest_session("calibration") is not None
    assert store.verifications.all() == []
    store.close()

"""Verifications, performance tests and temperatures in the station's database."""

import json
import sqlite3

import pytest

from crenel.messages.message import message
from crenel.store import temperatures
from crenel.store.store import Store
from tests.present import present
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
TESTED = {
    "kind": "sphere",
    "result": "pass",
    "text": message("performance-limits-kept"),
    "artefact": "Sphere 25",
    "operator": "Anna",
}


def test_the_newest_verification_of_a_calibration_is_found_again(calibrated: Store) -> None:
    assert calibrated.verifications.newest_for("c1") is None
    for name in ("v1", "v2"):
        calibrated.journal.begin_session(name, "verify")
        folder = calibrated.folder / "verifications" / name
        calibrated.verifications.accept(name, "c1", folder, FOUND, f"key-{name}")
    with reopened(calibrated) as again:
        newest = present(again.verifications.newest_for("c1"))
        assert (newest.id, newest.folder) == ("v2", again.folder / "verifications/v2")
        assert [record.id for record in again.verifications.all()] == ["v2", "v1"]
        assert again.verifications.newest() == newest
        session = present(again.journal.latest_session("verify"))
        assert session.ended_at is not None


def test_a_verdict_is_english_with_its_message_next_to_it(calibrated: Store) -> None:
    calibrated.journal.begin_session("v1", "verify")
    text = message("file-cut-off")
    folder = calibrated.folder / "verifications/v1"
    calibrated.verifications.accept("v1", "c1", folder, FOUND | {"text": text}, None)
    (record,) = calibrated.verifications.all()
    assert record.figures.text == text
    with open_database(calibrated) as database:
        ((figures,),) = database.execute("SELECT figures FROM verification").fetchall()
    assert json.loads(figures)["text"] == "the file is incomplete"


def test_a_key_that_was_used_keeps_nothing_twice(calibrated: Store) -> None:
    calibrated.journal.begin_session("v1", "verify")
    calibrated.journal.append("v1", "cloud_begun", {}, "k")
    with pytest.raises(sqlite3.IntegrityError):
        calibrated.verifications.accept(
            "v1", "c1", calibrated.folder / "verifications/v1", FOUND, "k"
        )
    assert calibrated.verifications.all() == []


def test_temperatures_count_near_their_time(store: Store, monkeypatch: pytest.MonkeyPatch) -> None:
    assert store.temperatures.newest() is None
    for at, celsius in (("2026-11-21T08:00:00.000Z", 20.0), ("2026-11-21T10:00:00.000Z", 21.5)):
        monkeypatch.setattr(temperatures, "utc_now", lambda at=at: at)
        store.temperatures.add(celsius, "Anna")
    near = present(store.temperatures.near("2026-11-21T08:40:00Z"))
    assert near.celsius == 20.0
    newest = present(store.temperatures.newest())
    assert newest.celsius == 21.5
    assert store.temperatures.near("2026-11-21T14:00:00Z") is None
    assert store.temperatures.change_since("2026-11-21T08:00:00Z") == 1.5
    assert store.temperatures.change_since("2026-11-21T09:30:00Z") is None, "one reading alone"


def close(store: Store, name: str, kind: str = "accepted", **changes: object) -> None:
    store.journal.begin_session(name, "performance")
    folder = store.folder / "performance" / name
    store.performances.close(name, kind, {}, "c1", folder, {**TESTED, **changes}, None)


def test_tests_are_listed_newest_first_the_cancelled_ones_too(calibrated: Store) -> None:
    close(calibrated, "p1")
    reason = message("performance-cancelled-moved")
    close(calibrated, "p2", "abandoned", result="cancelled", text=reason)
    found = calibrated.performances.all()
    assert [one.id for one in found] == ["p2", "p1"]
    assert [one.figures.result for one in found] == ["cancelled", "pass"]
    assert found[0].figures.text == reason
    assert found[1].folder == calibrated.folder / "performance" / "p1"
    latest = present(calibrated.journal.latest_session("performance"))
    assert latest.ended_at is not None


def test_what_is_no_result_is_not_kept(calibrated: Store) -> None:
    with pytest.raises(TypeError):
        close(calibrated, "p1", surprise=1)
    assert calibrated.performances.get("p1") is None
    assert not calibrated.journal.rows("p1")


@pytest.mark.parametrize("figures", [json.dumps({"result": "?"}), "none"])
def test_a_row_that_cannot_be_read_hides_no_other(calibrated: Store, figures: str) -> None:
    close(calibrated, "p1")
    close(calibrated, "p2")
    with open_database(calibrated) as database, database:
        database.execute("UPDATE performance SET figures = ? WHERE id = 'p2'", (figures,))
    with reopened(calibrated) as store:
        assert [one.id for one in store.performances.all()] == ["p1"]
        assert store.performances.unreadable() == ["p2"]
        judged = store.performances.newest_judged()
    assert present(judged).id == "p1"

"""Performance tests in the station's database."""

import json
import sqlite3
from pathlib import Path

import pytest

from app.messages.message import message
from app.store.store import Store
from tests.store.test_verifications import calibrated

FOUND = {
    "kind": "sphere",
    "result": "pass",
    "text": message("performance-limits-kept"),
    "artefact": "Sphere 25",
    "operator": "Anna",
}


def close(store: Store, name: str, kind: str = "accepted", **changes: object) -> None:
    store.journal.begin_session(name, "performance")
    folder = store.folder / "performance" / name
    store.performances.close(name, kind, {}, "c1", folder, {**FOUND, **changes}, None)


def test_tests_are_listed_newest_first_the_cancelled_ones_too(tmp_path: Path) -> None:
    store = calibrated(tmp_path)
    close(store, "p1")
    reason = message("performance-cancelled-moved")
    close(store, "p2", "abandoned", result="cancelled", text=reason)
    found = store.performances.all()
    assert [one.id for one in found] == ["p2", "p1"]
    assert [one.figures.result for one in found] == ["cancelled", "pass"]
    assert found[0].figures.text == reason
    assert found[1].folder == store.folder / "performance" / "p1"
    latest = store.journal.latest_session("performance")
    assert latest is not None
    assert latest.ended_at is not None
    store.close()


def test_what_is_no_result_is_not_kept(tmp_path: Path) -> None:
    store = calibrated(tmp_path)
    with pytest.raises(TypeError):
        close(store, "p1", surprise=1)
    assert store.performances.get("p1") is None
    assert not store.journal.rows("p1")
    store.close()


@pytest.mark.parametrize("figures", [json.dumps({"result": "?"}), "none"])
def test_a_row_that_cannot_be_read_hides_no_other(tmp_path: Path, figures: str) -> None:
    store = calibrated(tmp_path)
    close(store, "p1")
    close(store, "p2")
    store.close()
    with sqlite3.connect(tmp_path / "station.db") as database:
        database.execute("UPDATE performance SET figures = ? WHERE id = 'p2'", (figures,))
    database.close()
    store = Store(tmp_path)
    assert [one.id for one in store.performances.all()] == ["p1"]
    assert store.performances.unreadable() == ["p2"]
    judged = store.performances.newest_judged()
    assert judged is not None
    assert judged.id == "p1"
    store.close()

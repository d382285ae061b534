"""Performance tests in the station's database."""

import json

import pytest

from app.messages.message import message
from app.store.store import Store
from tests.store.conftest import open_database, reopened

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


def test_tests_are_listed_newest_first_the_cancelled_ones_too(calibrated: Store) -> None:
    store = calibrated
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
    assert judged is not None
    assert judged.id == "p1"

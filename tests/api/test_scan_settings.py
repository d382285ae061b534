"""The settings' routes on the running server, whatever other tests have set there before."""

import pytest

from tests.api.conftest import Server, wait_for

pytestmark = pytest.mark.device

NUMBERS = ("threshold", "min_width_px", "smoothing_px", "exposure_us", "blur_limit_mm")
PLAIN: dict[str, object] = {
    **dict.fromkeys(NUMBERS),
    "choice": "continuity",
    "zones": [],
    "record_pictures": False,
}


@pytest.fixture
def no_delay(server: Server) -> None:
    """What the pass of another test has found is applied, and dropped."""
    wait_for(lambda: server.http.get("/api/settings").json(), lambda now: not now["finding_delay"])
    for on in (True, False):
        server.http.post("/api/settings/delay", json={"on": on})
    assert server.http.get("/api/settings").json()["delay"] is None


@pytest.mark.usefixtures("no_delay")
def test_settings_are_set_read_and_kept(server: Server) -> None:
    zone = [[0, 0], [200.5, 0], [200.5, 300]]
    set_to = {**PLAIN, "threshold": 20, "choice": "strength", "zones": [zone]}
    answer = server.http.post("/api/settings", json=set_to)
    assert answer.status_code == 200, answer.text
    now = server.http.get("/api/settings").json()
    assert (now["threshold"], now["choice"], now["zones"]) == (20, "strength", [zone])
    assert now["delay"] is None
    assert '"threshold": 20.0' in (server.data / "scan_settings.json").read_text()
    answer = server.http.post("/api/settings", json={"record_pictures": True})
    assert answer.json() == {**now, "record_pictures": True}
    assert server.http.post("/api/settings", json=PLAIN).json()["zones"] == []


@pytest.mark.parametrize(
    "change",
    [
        *({"threshold": -3}, {"min_width_px": "wide"}, {"choice": "best"}, {"smoothing_px": -1}),
        *({"zones": [[first, [2, 2], [3, 3]]]} for first in ([1, 1], [1])),
        {"more": 1},
    ],
)
def test_what_cannot_be_meant_changes_nothing(server: Server, change: dict[str, object]) -> None:
    before = server.http.get("/api/settings").json()
    answer = server.http.post("/api/settings", json={**PLAIN, **change})
    assert answer.status_code == 422, answer.text
    assert answer.json()["title"]
    assert server.http.get("/api/settings").json() == before


def test_no_delay_is_found_without_a_scan(server: Server, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(server.context.store.scans, "newest", lambda: None)
    assert server.http.post("/api/settings/delay/find").json()["code"] == "no-scan"


@pytest.mark.usefixtures("no_delay")
def test_a_delay_that_was_not_found_is_not_applied(server: Server) -> None:
    assert server.http.post("/api/settings/delay", json={"on": True}).json()["code"] == "no-delay"

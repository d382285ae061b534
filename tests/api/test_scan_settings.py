"""The settings' routes on the running server, whatever other tests have set there before."""

import base64

import cv2
import numpy as np
import pytest

from crenel.report.logo import read_logo
from tests.api.conftest import Server, wait_for
from tests.sent_texts import english

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


def data_url(kind: str, picture: bytes) -> str:
    return f"data:image/{kind};base64,{base64.b64encode(picture).decode()}"


def encoded(ending: str, width_px: int = 60) -> bytes:
    picture = np.random.default_rng(3).integers(0, 255, (20, width_px, 3), np.uint8)
    return cv2.imencode(ending, picture)[1].tobytes()


def test_a_picture_becomes_the_logo_until_it_is_removed(server: Server) -> None:
    path, record = "/api/settings/logo", server.data / "scans" / "any"
    assert server.http.get(path).json()["data_url"] == ""
    for kind, ending, name in (("png", ".png", "logo.png"), ("jpeg", ".jpg", "logo.jpg")):
        sent = data_url(kind, encoded(ending))
        answer = server.http.post(path, json={"data_url": sent})
        assert answer.json()["data_url"] == server.http.get(path).json()["data_url"] == sent
        assert [one.name for one in server.data.glob("logo.*")] == [name]
        assert read_logo(record) == encoded(ending)
    assert server.http.delete(path).json()["data_url"] == ""
    assert read_logo(record) is None


@pytest.mark.parametrize(
    ("sent", "says"),
    [
        ("", "no PNG or JPEG of at most 190 kB"),
        ("data:image/png;base64,%%%", "no PNG or JPEG"),
        (data_url("gif", b"GIF89a" + bytes(40)), "no PNG or JPEG"),
        (data_url("svg+xml", b"<svg/>"), "no PNG or JPEG"),
        (data_url("png", encoded(".png")[:-900]), "incomplete"),
        (data_url("jpeg", encoded(".jpg")[:40]), "The chosen picture"),
        (data_url("png", encoded(".png", 3180)), "no PNG or JPEG of at most 190 kB"),
        (data_url("png", encoded(".png", 9000)), ""),
    ],
    ids=["nothing", "no base64", "gif", "svg", "cut png", "cut jpeg", "too large", "far too large"],
)
def test_what_cannot_be_a_logo_is_refused_and_changes_nothing(
    server: Server, sent: str, says: str
) -> None:
    path, before = "/api/settings/logo", data_url("png", encoded(".png"))
    assert server.http.post(path, json={"data_url": before}).status_code == 200
    answer = server.http.post(path, json={"data_url": sent})
    assert answer.status_code in (413, 422)
    assert says in answer.text
    assert server.http.get(path).json()["data_url"] == before
    (server.data / "logo.png").write_bytes(encoded(".png")[:-900])
    found = server.http.get(path).json()
    assert (found["data_url"], "incomplete" in english(found["trouble"])) == ("", True)
    assert server.http.delete(path).json()["trouble"] == ""

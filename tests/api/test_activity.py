"""The arm belongs to one activity, and what nobody controls is stopped, on a running server."""

import time
from collections.abc import Iterator
from typing import Any

import httpx
import pytest

from crenel_hardware.interfaces import Button
from tests.api.conftest import Server, code_of, until, wait_for
from tests.entering import enter
from tests.sent_texts import english

pytestmark = pytest.mark.device

SESSIONS = {
    "calibration": ("flow", {}),
    "verification": ("verify", {}),
    "performance": ("performance", {"test": "sphere"}),
    "arm": ("arm", {"purpose": "check"}),
    "inspection": ("parts", {}),
}


@pytest.fixture
def station(server: Server, calibration: str) -> Iterator[Server]:
    until(lambda: server.http.get("/api/scan").json()["state"] == "idle")
    yield server
    server.http.post("/api/stop").raise_for_status()
    for guide in server.context.guides:
        if guide.running:
            guide.append("abandoned" if guide is not server.context.arm_guide else "ended", {})
    until(lambda: activity(server) is None)


def activity(server: Server) -> Any:
    return server.http.get("/api/activity").json()["activity"]


def end_present(server: Server) -> None:
    """As the browser does once the user has agreed."""
    ended = server.http.post("/api/activity/end", json={"id": activity(server)["id"]})
    assert ended.json()["activity"] is None


@pytest.mark.parametrize("kind", SESSIONS)
def test_scan_and_session_ask_each_other(station: Server, kind: str) -> None:
    http, (name, body) = station.http, SESSIONS[kind]
    assert http.post(f"/api/{name}/start", json=body).status_code == 200
    present = activity(station)
    assert (present["kind"], present["who"]) == (kind, station.context.lease.last_name)
    assert code_of(http.post("/api/scan/start", json={})) == (422, "arm-in-use")
    moved = http.post("/api/scan/simulation", json={"on": True})
    assert code_of(moved) == (422, "arm-in-use")
    assert code_of(http.post("/api/settings/delay/pass")) == (422, "arm-in-use")
    for other, (path, asked) in SESSIONS.items():
        if other != kind:
            begun = http.post(f"/api/{path}/start", json=asked)
            assert code_of(begun) == (422, "arm-in-use")
    of_before = http.post("/api/activity/end", json={"id": "of-before"})
    assert code_of(of_before) == (422, "arm-in-use")
    assert activity(station) == present

    end_present(station)
    assert http.post("/api/scan/start", json={}).status_code == 200
    assert activity(station)["kind"] == "scan"
    again = http.post(f"/api/{name}/start", json=body)
    assert code_of(again) == (422, "arm-in-use")
    http.post("/api/scan/stop").raise_for_status()
    until(lambda: activity(station) is None)
    assert http.post(f"/api/{name}/start", json=body).status_code == 200


def test_no_point_is_taken_in_a_scan_or_where_it_ended(station: Server, touching: Server) -> None:
    end_present(station)
    station.http.post("/api/scan/start", json={}).raise_for_status()
    declined = station.context.guide.declined
    station.press(Button.PRIMARY)
    until(lambda: station.context.guide.declined > declined)
    assert station.context.guide.state.contacts == ()
    assert activity(station)["kind"] == "scan"
    station.http.post("/api/scan/stop").raise_for_status()
    until(lambda: activity(station) is None)
    wait_for(lambda: code_of(touching.command("take_point")), (422, "where-scan-ended").__eq__)
    assert station.simulation.operator.touch("crest", 0)  # it presses the button there
    until(lambda: len(station.context.guide.state.contacts) == 1)


def test_an_open_session_has_the_arm_after_a_restart_too(station: Server) -> None:
    context = station.context
    station.http.post("/api/verify/start").raise_for_status()
    began = activity(station)
    context.activities.end(began["id"], lambda: None)
    context.activities.resume("verification", context.verify_guide.started_at)
    found = activity(station)
    assert (found["kind"], found["who"]) == ("verification", "")
    assert found["since"][:16] == began["since"][:16]


def test_who_scans_learns_who_stopped_it(station: Server) -> None:
    """Home says that a scan runs; another browser's Stop is named, and so is what was saved."""
    context = station.context
    station.http.post("/api/scan/start", json={"name": "Stopped"}).raise_for_status()
    wait_for(lambda: station.http.get("/api/home").json()["next"]["page"], "scan".__eq__)
    with httpx.Client(base_url=station.address) as other:
        enter(other, context.authenticator.code)
        other.post("/api/stop").raise_for_status()
    note = wait_for(lambda: station.http.get("/api/activity").json()["note"], bool)
    assert "Demo pressed Stop" in english(note["text"])
    assert "saved under Records" in english(note["remedy"])
    kept = wait_for(context.store.scans.newest, bool)
    assert kept is not None
    assert (kept.name, "pressed Stop" in str(kept.interrupted)) == ("Stopped", True)
    findings = station.http.get("/api/scan").json()["findings"]
    assert any("pressed Stop" in english(one["text"]) for one in findings)
    wait_for(lambda: station.http.get("/api/home").json()["next"]["page"], "scan".__ne__)
    station.http.post("/api/scan/start", json={}).raise_for_status()
    station.http.post("/api/stop").raise_for_status()
    assert station.http.get("/api/activity").json()["note"] is None


def test_scan_and_laser_stop_unwatched(station: Server, monkeypatch: pytest.MonkeyPatch) -> None:
    context = station.context
    station.http.post("/api/scan/start", json={"name": "Alone"}).raise_for_status()
    wait_for(lambda: context.rig.laser.state, lambda state: state == "on")
    for clock in (context.lease, context.unattended):
        monkeypatch.setattr(clock, "_clock", lambda: time.monotonic() + 31.0)
    until(lambda: context.scanner.recording() is None)
    assert context.rig.laser.state == "off"
    assert context.lease.control.holder is None
    note = wait_for(lambda: station.http.get("/api/activity").json()["note"], bool)
    assert "nobody was in control" in english(note["text"])
    kept = wait_for(context.store.scans.newest, bool)
    assert kept is not None
    assert (kept.name, "nobody was in control" in str(kept.interrupted)) == ("Alone", True)
    findings = station.http.get("/api/scan").json()["findings"]
    assert any(one["quality"] == "bad" for one in findings)

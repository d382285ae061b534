"""Performance tests by touch at a station whose sensor was never calibrated."""

import json
from dataclasses import replace

import pytest

from crenel.gauges.kinds import evaluate_performance
from crenel.gauges.plan.document import read_plan
from tests.api.conftest import Server, refusal
from tests.bench.faults.served import SMALL
from tests.gauges.sphere.test_flow import SphereDesk
from tests.sent_texts import english

pytestmark = pytest.mark.device


STATION = replace(SMALL, pace=12.0)


@pytest.fixture
def desk(server: Server) -> SphereDesk:
    return SphereDesk(server)


def start(server: Server, test: str) -> str:
    """What is said if a test cannot begin."""
    answer = server.http.post("/api/performance/start", json={"test": test})
    return "" if answer.status_code == 200 else str(answer.json()["detail"])


def test_the_contact_test_needs_no_calibration(desk: SphereDesk) -> None:
    server = desk.server
    assert "calibration" in start(server, "sphere")
    assert "calibration" in start(server, "plane")
    assert not start(server, "contact")
    desk.do("choose_bar", id="")
    desk.do("confirm_artefact")
    session = desk.view()["session_id"]
    folder = server.data / "performance" / session
    arm = (server.data / "arms" / "simulated.json").read_bytes()
    assert (folder / "arm.json").read_bytes() == arm
    assert not (folder / "calibration.json").exists()
    desk.do("run_simulation", all=True)
    desk.wait(lambda view: view["step"] == "seats" and view["progress"]["done"] > 0)
    server.http.post("/api/stop").raise_for_status()
    desk.wait_until_idle()
    found = evaluate_performance(folder)
    assert found.serial_numbers.arm == "TWIN-A1"
    problems = {one.quantity: str(one.problem) for one in found.figures}
    assert problems.keys() == {"effective-diameter", "articulation-largest", "articulation-two-s"}
    # it was stopped; that nothing is calibrated keeps no figure from being stated
    assert set(problems.values()) == {"3 seats with 10 points each are needed"}
    desk.do("abandon", reason="other")
    (listed,) = desk.list()
    assert (listed["id"], listed["result"]) == (session, "cancelled")


def test_lengths_are_touched_without_a_calibration_and_not_scanned(desk: SphereDesk) -> None:
    server = desk.server
    assert not start(server, "lengths")
    desk.do("choose_gauge", id="ball-bar")
    view = desk.view()
    assert "calibration" in english(view["why_no_scans"])
    assert "calibration" in refusal(desk.command("set_by_scan", by_scan=True))
    desk.do("confirm_artefact")
    folder = server.data / "performance" / view["session_id"]
    desk.do("run_simulation")
    desk.wait(lambda view: view["progress"]["done"] > 0)
    assert not read_plan(folder).by_scan
    server.http.post("/api/stop").raise_for_status()
    desk.wait_until_idle()
    desk.do("abandon", reason="other")


def test_without_a_calibration_bad_artefacts_are_refused_before_the_test(desk: SphereDesk) -> None:
    gauges = desk.server.data / "gauges"
    good = json.loads((gauges / "step-gauge.json").read_text())
    (long,) = good["lengths"][-1:]
    bad: dict[str, tuple[dict[str, object], str]] = {
        "expired": ({"valid_until": "2025-01-01"}, "was valid until 2025-01-01"),
        "bare": ({"lengths": [{**long, "standard_uncertainty_um": 0}]}, "no uncertainty"),
        "long": ({"lengths": [{**long, "length_mm": 4000.0}]}, "reach"),
    }
    for name, (changes, _) in bad.items():
        (gauges / f"{name}.json").write_text(json.dumps({**good, **changes}))
    assert not start(desk.server, "lengths")
    view = desk.wait(lambda view: bad.keys() <= {one["id"] for one in view["gauges"]})
    assert view["gauge"] not in bad
    why_not = {one["id"]: english(one["why_not"]) for one in view["gauges"]}
    for name, (_, words) in bad.items():
        assert words in why_not[name]
        assert words in refusal(desk.command("choose_gauge", id=name))
        (gauges / f"{name}.json").unlink()
    assert not why_not["step-gauge"]
    desk.do("abandon", reason="other")


def test_an_arm_that_is_not_known_is_named(desk: SphereDesk) -> None:
    arms = desk.server.data / "arms"
    (arms / "simulated.json").rename(arms / "kept")
    try:
        desk.wait_until_idle()
        assert "arms" in start(desk.server, "contact")
    finally:
        (arms / "kept").rename(arms / "simulated.json")

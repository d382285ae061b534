"""The guided length test over HTTP, simulated: what counts, what is refused, kept and listed."""

import json
import shutil
import uuid
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from crenel.gauges.guide import PerformanceGuide, PerformanceServices
from crenel.gauges.kinds import KINDS, evaluate_performance
from crenel.gauges.length.guide_so_far import lengths_so_far
from crenel.gauges.length.guide_state import LengthState
from crenel.gauges.plan.document import read_plan
from crenel.station.jobs import Jobs
from tests.api.conftest import Server, View, refusal, wait_for
from tests.api.desks import left_in_order, next_station
from tests.gauges.sphere.test_flow import SphereDesk
from tests.sent_texts import english

pytestmark = pytest.mark.device


class LengthDesk(SphereDesk):
    def start(self, **body: str) -> View:
        return super().start(test="lengths", **body)

    def add(self, name: str, **changes: object) -> dict[str, Any]:
        """Puts a step gauge into the folder; what it is offered as."""
        gauges = self.server.data / "gauges"
        content = json.loads((gauges / "step-gauge.json").read_text())
        (gauges / f"{name}.json").write_text(json.dumps({**content, **changes}))
        view = self.wait(lambda view: any(gauge["id"] == name for gauge in view["gauges"]))
        return next(dict(gauge) for gauge in view["gauges"] if gauge["id"] == name)

    def touch_end(self, length_mm: float, end: int) -> View:
        """Touches an end of a length in the first place, until it is taken or declined."""
        so_far = lengths_so_far(self.server.context.performance_guide)
        assert so_far is not None
        first, last = so_far.places_mm[0]
        operator = self.server.simulation.operator
        middle, along = ((first + last) / 2).tolist(), (last - first).tolist()
        for _ in range(5):
            taken = self.is_taken(lambda: operator.touch_length(middle, along, length_mm, end))
            texts = [english(finding["text"]) for finding in self.view()["findings"]]
            if taken or any("not taken" in text for text in texts):
                return self.view()
        raise AssertionError(self.view()["findings"])


@pytest.fixture
def desk(server: Server, calibration: str) -> Iterator[LengthDesk]:
    with left_in_order(LengthDesk(server)) as desk:
        yield desk
    for path in (server.data / "gauges").glob("made-*.json"):
        path.unlink()


@contextmanager
def reopened(server: Server, left: Path) -> Iterator[PerformanceGuide]:
    setup = server.context.settings.settings.model_dump(mode="json")
    with next_station(server, left) as (store, bus, rig, scanner, scene):
        station = PerformanceServices(bus, rig, Jobs(bus), None, scanner, scene, lambda: setup)
        yield PerformanceGuide(
            KINDS, station, store.journal, store.calibrations, store.performances, left
        )


def test_lengths_count_in_order_and_survive_a_kill(desk: LengthDesk, tmp_path: Path) -> None:
    server, view = desk.server, desk.start()
    ids = [gauge["id"] for gauge in view["gauges"]]
    assert (view["test"], ids) == ("lengths", ["ball-bar", "step-gauge"])
    desk.do("choose_gauge", id="step-gauge")
    assert "spheres of a ball bar" in refusal(desk.command("set_by_scan", by_scan=True))
    stated: dict[str, Any] = {"quantity": "length-touch", "a_um": 90.0, "k": 10.0}
    assert "cap B" in refusal(desk.command("set_limit", **stated, b_um=80.0))
    desk.do("set_limit", **stated, b_um=120.0)
    desk.do("set_temperature", celsius=20.0, expanded_c=0.4)
    view = desk.do("confirm_artefact")
    picture = view["picture"]["lengths"]
    assert [place["state"] for place in picture["places"]] == ["now", *["todo"] * 6]
    limits_um = [limit["limit_um"] for limit in picture["touched"]["limits"]]
    assert limits_um == [100, 112.5, 120, 120, 120]
    view = desk.touch_end(100.0, 0)
    assert view["frozen"]
    plan = read_plan(server.data / "performance" / view["session_id"])
    assert (plan.artefact_c, plan.temperature_sd_c) == (20.0, 0.2)
    assert "fixed" in refusal(desk.command("set_temperature", celsius=21.0))
    assert "fixed" in refusal(desk.command("set_limit", quantity="length-touch", a_um=1.0))
    view = desk.touch_end(225.0, 1)  # another face than that of the length
    assert any("225 mm instead of 100 mm" in english(f["text"]) for f in view["findings"])
    view = desk.touch_end(100.0, 1)
    (error,) = view["picture"]["lengths"]["touched"]["errors"]
    assert (error["place"], error["length_mm"], error["limit_um"]) == (1, 100.0, 100.0)
    assert abs(error["error_um"]) < 1000
    assert not desk.do("undo")["picture"]["lengths"]["touched"]["errors"]
    assert desk.do("redo")["picture"]["lengths"]["touched"]["errors"] == [error]
    desk.touch_end(225.0, 0)  # confirms the length before
    desk.do("undo")
    assert "confirmed" in refusal(desk.command("undo"))
    assert "208 touches" in refusal(desk.command("confirm"))

    shutil.copytree(server.data, left := tmp_path / "left")
    shutil.rmtree(left / "gauges")  # the test has its own copy of the standard's file
    with reopened(server, left) as guide:
        assert guide.view().picture.lengths is not None
        assert guide.state == server.context.performance_guide.state
        assert [one.error_um for one in lengths_so_far(guide).values] == [error["error_um"]]  # type: ignore[union-attr]

    session = desk.view()["session_id"]
    desk.do("abandon", reason="moved")
    newest, *_ = desk.list()
    assert (newest["id"], newest["kind"], newest["result"]) == (session, "lengths", "cancelled")
    plan = read_plan(server.data / "performance" / session)
    (limit,) = plan.limits
    assert (plan.kind, limit.a_um, limit.k, limit.b_um) == ("lengths", 90.0, 10.0, 120.0)
    assert plan.length is not None
    assert np.allclose([one.length_mm for one in plan.length.lengths], [100, 225, 350, 475, 600])


def scanning(desk: LengthDesk) -> PerformanceGuide:
    """The guide of a test of a ball bar by touch and by scan, begun."""
    desk.start()
    desk.do("choose_gauge", id="ball-bar")
    view = desk.do("set_by_scan", by_scan=True)
    assert (view["by_scan"], view["why_no_scans"]) == (True, "")
    assert [one["quantity"] for one in view["picture"]["limits"]] == ["length-touch", "length-scan"]
    desk.do("set_limit", quantity="length-scan", a_um=500.0, k=10.0)
    desk.do("confirm_artefact")
    assert "Touch all lengths" in refusal(desk.command("begin_scan"))
    return desk.server.context.performance_guide


def touch_first_place(guide: PerformanceGuide) -> None:
    """As if all of it was touched near the arm's tip; the touches of an operator take long."""
    rng, (_, mean) = np.random.default_rng(1), guide.average_touch(None)
    with guide.lock:
        guide.freeze()
        while (end := guide.state_of(LengthState).end) is not None:
            reading = mean.reading + rng.normal(0, 0.02, len(mean.reading))
            reading[0] += 0.3 * end.end
            place = len(guide.state.of(end.feature))
            payload = {"feature": end.feature, "place": place, "reading": reading.tolist()}
            guide.append("touched", payload)


def test_a_scan_of_a_bar_that_is_cut_short_is_repeated(desk: LengthDesk, tmp_path: Path) -> None:
    server, guide = desk.server, scanning(desk)
    touch_first_place(guide)
    desk.do("run_simulation")
    desk.wait(lambda view: scan_states(view).count("done") == 1)
    desk.wait(lambda view: guide.state.open_scan is not None)
    shutil.copytree(server.data, left := tmp_path / "left")  # as if it was killed now
    with reopened(server, left) as other:
        other.end_lost_scan()
        assert len([scan for scan in other.state_of(LengthState).bar_scans if scan.good]) == 1
        assert other.state.touches == guide.state.touches
    server.http.post("/api/stop").raise_for_status()
    # what was recorded of the second one is dropped or measured, by what came first
    again = (["done", "now", "todo"], ["done", "refused", "todo"])
    view = desk.wait(lambda view: view["busy"] is None and scan_states(view) in again)
    assert view["frozen"]
    assert "confirmed" in refusal(desk.command("undo"))
    assert "Scan the bar" in refusal(desk.command("touch"))
    assert "Scan the bar" in refusal(desk.command("confirm"))
    assert read_plan(server.data / "performance" / view["session_id"]).by_scan

    # a scan that shows no sphere is refused, and says why
    desk.do("begin_scan")
    wait_for(lambda: server.context.scanner.state().frames, bool)
    desk.do("finish_scan")
    refused = ["done", "refused", "todo"]
    view = desk.wait(lambda view: view["busy"] is None and scan_states(view) == refused)
    said = [english(finding["text"]) for finding in view["findings"]]
    assert any("laser stripe" in text or "sphere" in text for text in said), said


@pytest.mark.soak
def test_a_bar_is_touched_and_scanned_in_its_place(desk: LengthDesk, tmp_path: Path) -> None:
    server, guide = desk.server, scanning(desk)
    desk.do("run_simulation")
    view = desk.wait(lambda view: view["picture"]["lengths"]["places"][0]["state"] == "done")
    server.http.post("/api/stop").raise_for_status()
    view = desk.wait_until_idle()
    lengths = view["picture"]["lengths"]
    assert (lengths["places"][0]["scanned"], lengths["places"][1]["state"]) == (3, "now")
    errors = lengths["scanned"]["errors"]
    assert [(one["place"], one["repeat"]) for one in errors] == [(1, 1), (1, 2), (1, 3)]
    assert all(abs(one["error_um"]) < 500 and one["limit_um"] == 530 for one in errors)
    shutil.copytree(server.data, left := tmp_path / "again")
    with reopened(server, left) as other:
        assert other.state == guide.state
    # the figures of the folder are those that were shown
    found = evaluate_performance(server.data / "performance" / view["session_id"])
    scanned = [one for one in found.lengths if one.by == "scan"]
    assert [one.error_um for one in scanned] == pytest.approx([one["error_um"] for one in errors])


def scan_states(view: View) -> list[str]:
    lengths = view["picture"]["lengths"] or {"scans": []}
    return [one["state"] for one in lengths["scans"]]


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"valid_until": "2020-01-31"}, "2020-01-31"),
        ({"lengths": [{"length_mm": 400.0, "standard_uncertainty_um": 0}]}, "no uncertainty"),
        ({"lengths": [{"length_mm": 4000.0, "standard_uncertainty_um": 1}]}, "reaches 1379 mm"),
    ],
)
def test_a_standard_says_why_not(desk: LengthDesk, changes: dict[str, Any], said: str) -> None:
    desk.start()
    offered = desk.add(f"made-{uuid.uuid4().hex[:6]}", **changes)
    assert said in english(offered["why_not"])
    assert said in refusal(desk.command("choose_gauge", id=offered["id"]))


def test_a_standard_without_coefficient_is_named_away_from_20_degrees(desk: LengthDesk) -> None:
    desk.start()
    unknown = desk.add(f"made-{uuid.uuid4().hex[:6]}", expansion_sd_per_c=0.0)

    def is_named(name: str, celsius: float) -> bool:
        desk.do("choose_gauge", id=name)
        desk.do("set_temperature", celsius=celsius, expanded_c=0.4)
        said = [english(finding["text"]) for finding in desk.view()["findings"]]
        return any("no coefficient of expansion" in text for text in said)

    assert is_named(unknown["id"], 20.3)
    assert not is_named(unknown["id"], 20.1)
    assert not is_named("step-gauge", 22.0)  # its zero has an uncertainty


def test_a_one_sphere_test_does_not_offer_standards(desk: LengthDesk) -> None:
    assert {gauge["id"] for gauge in SphereDesk.start(desk)["gauges"]} == {"sphere"}
    assert desk.view()["test"] == "sphere"

"""The guided one-sphere test over HTTP, simulated: what is refused, kept and listed. The whole test
is in ``tests/e2e``."""

import json
import time
from collections.abc import Callable, Iterator
from itertools import pairwise

import httpx
import pytest

from crenel.gauges.plan.document_gauge import read_gauge
from crenel.gauges.sphere.guide_places import POLE
from crenel.gauges.sphere.maths_pattern import RIM_DEG, pattern_directions
from tests.api.conftest import LOOK_S, Server, View, comes, refusal, wait_for
from tests.api.desks import GuideDesk, left_in_order
from tests.gauges.exchange.certificates import DIAMETER, FORM, certificate, quantity, real
from tests.sent_texts import english

pytestmark = pytest.mark.device

DIRECTIONS = pattern_directions(POLE, RIM_DEG)


class SphereDesk(GuideDesk):
    path = "/api/performance"

    def start(self, **body: str) -> View:
        self.close()
        self.http.post("/api/performance/start", json=body or None).raise_for_status()
        return self.view()

    def is_taken(self, touch: Callable[[], bool]) -> bool:
        guide = self.server.context.performance_guide
        with guide.lock:
            before, declined = len(guide.state.touches), guide.declined
        assert touch()
        comes(lambda: len(guide.state.touches) > before or guide.declined > declined)
        return len(guide.state.touches) > before

    def touch(self, place: int) -> View:
        """Touches a place of the pattern until it is taken; a busy machine's arm may come late."""
        outward, operator = DIRECTIONS[place], self.server.simulation.operator
        for _ in range(5):
            if self.is_taken(
                lambda: operator.touch_sphere(outward.tolist(), (outward + POLE).tolist())
            ):
                return self.view()
        raise AssertionError(self.view()["findings"])

    def touch_first(self) -> View:
        """A new test, with the first place of its pattern touched."""
        self.start()
        self.do("confirm_artefact")
        return self.touch(0)

    def list(self) -> list[View]:
        return list(self.http.get("/api/performances").json())


@pytest.fixture
def desk(server: Server, calibration: str) -> Iterator[SphereDesk]:
    with left_in_order(SphereDesk(server)) as desk:
        yield desk


def test_touches_count_for_free_places_and_the_plan_stands_from_the_first(desk: SphereDesk) -> None:
    desk.start()
    assert "Choose" not in english(desk.do("confirm_artefact")["instruction"])
    view = desk.touch(0)
    assert view["frozen"]
    assert view["picture"]["places"][0]["state"] == "done"
    assert "fixed" in refusal(desk.command("set_limit", quantity="form-touch", a_um=1.0))
    assert "does not go back" in refusal(desk.command("back"))
    view = desk.touch(7)
    assert view["picture"]["places"][7]["state"] == "done"
    # the same place again, and one between places
    wait_for(  # the arm may still move away
        lambda: desk.command("touch").json(), lambda answer: answer.get("code") == "no-free-place"
    )
    assert desk.view()["progress"]["done"] == 2
    assert desk.do("undo")["progress"]["done"] == 1
    assert desk.do("redo")["progress"]["done"] == 2
    assert "23 touches" in refusal(desk.command("confirm"))


def test_stop_ends_the_simulated_operator(desk: SphereDesk) -> None:
    desk.start()
    desk.do("run_simulation", all=True)
    desk.wait(lambda view: view["progress"]["done"] > 1 and view["step"] == "pattern")
    desk.server.http.post("/api/stop").raise_for_status()
    assert desk.wait_until_idle()["progress"]["done"] < len(DIRECTIONS)


def counts_of(view: View) -> list[tuple[int, int]]:
    return [(patch["points"], patch["frames"]) for patch in view["picture"]["patches"]]


def is_in(state: str, articulation: int) -> Callable[[View], bool]:
    return lambda view: view["picture"]["articulations"][articulation - 1]["state"] == state


def watch_scan(desk: SphereDesk, articulation: int) -> list[View]:
    """The different views of a scan while it runs, of the simulated operator."""
    views = [desk.wait(is_in("scanning", articulation))]
    while is_in("scanning", articulation)(view := desk.view()):
        if counts_of(view) != counts_of(views[-1]):
            views.append(view)
        time.sleep(LOOK_S)
    return views


def test_the_coverage_grows_while_a_scan_runs(desk: SphereDesk) -> None:
    desk.start()
    desk.do("confirm_artefact")
    for place in range(5):
        desk.touch(place)
    guide = desk.server.context.performance_guide
    for _ in ("pattern", "location"):  # five touches find the sphere; the others take minutes
        guide.append("step_confirmed", {})
    assert counts_of(desk.view()) == [(0, 0)] * 25
    desk.do("run_simulation")
    views = watch_scan(desk, 1)
    growing = [counts_of(view) for view in views]
    assert len(growing) > 3
    for before, after in pairwise(growing):
        for (points, frames), (more_points, more_frames) in zip(before, after, strict=True):
            assert more_points >= points
            assert more_frames >= frames
    covered = [[patch["covered"] for patch in view["picture"]["patches"]] for view in views]
    assert sum(covered[0]) < sum(covered[-1])
    assert "25 patches" in english(views[-1]["picture"]["articulations"][0]["text"])
    # the evaluation finds about the same, and the next scan adds to what it found
    found = counts_of(desk.wait(is_in("done", 1)))
    drawn, measured = (sum(points for points, _ in each) for each in (growing[-1], found))
    assert 0.5 * measured < drawn < 1.1 * measured  # the last look may have been too early for all
    view = desk.wait(is_in("scanning", 2))
    assert all(new >= old for old, new in zip(found, counts_of(view), strict=True))


def test_a_cancelled_test_is_listed_with_its_reason(desk: SphereDesk) -> None:
    session = desk.touch_first()["session_id"]
    desk.do("abandon", reason="moved")
    newest, *_ = desk.list()
    assert (newest["id"], newest["result"]) == (session, "cancelled")
    assert "moved" in english(newest["text"])
    assert (desk.server.data / "performance" / session / "touches.csv").is_file()
    listed = len(desk.list())
    desk.start()
    desk.do("abandon")
    assert len(desk.list()) == listed  # nothing was touched
    judged = desk.server.context.store.performances.newest_judged()
    assert judged is None or judged.figures.result != "cancelled"


def test_a_recording_of_a_test_that_is_gone_is_named(desk: SphereDesk) -> None:
    session = desk.touch_first()["session_id"]
    desk.do("abandon", reason="other")
    recovery = desk.server.context.recovery
    assert not recovery.find_damage()
    result = desk.server.data / "performance" / session / "performance.json"
    result.write_text(json.dumps({"inputs": [{"file": "p1-a5/scan.mcap", "sha256": "0" * 64}]}))
    try:
        (damage,) = recovery.find_damage()
        assert str(damage).startswith(f"{session}, p1-a5/scan.mcap")
    finally:
        result.unlink()


def test_a_changed_plan_or_setting_makes_the_set_invalid(desk: SphereDesk) -> None:
    server = desk.server
    plan = server.data / "performance" / desk.touch_first()["session_id"] / "plan.json"
    kept = plan.read_bytes()
    plan.write_bytes(kept.replace(b'"positions": 1', b'"positions": 2'))
    view = desk.view()
    assert any("plan of this test was changed" in english(f["text"]) for f in view["findings"])
    assert [action["name"] for action in view["actions"]] == ["again", "abandon"]
    assert "plan of this test" in refusal(desk.command("confirm"))
    plan.write_bytes(kept)
    assert "again" not in {action["name"] for action in desk.view()["actions"]}
    server.http.post("/api/settings", json={"threshold": 40}).raise_for_status()
    try:
        view = desk.view()
        assert any("settings for scans" in english(f["text"]) for f in view["findings"])
    finally:
        server.http.post("/api/settings", json={"threshold": None}).raise_for_status()
    assert not any("settings for scans" in english(f["text"]) for f in desk.view()["findings"])


def test_a_sphere_with_an_expired_certificate_cannot_be_chosen(desk: SphereDesk) -> None:
    gauges = desk.server.data / "gauges"
    path, chosen = gauges / "old.nominal.json", gauges / "sphere.nominal.json"
    whole = chosen.read_text()
    path.write_text(json.dumps({**json.loads(whole), "valid_until": "2020-01-31"}))
    try:
        desk.start()
        desk.do("choose_gauge", id="sphere")
        view = desk.wait(lambda view: {gauge["id"] for gauge in view["gauges"]} >= {"old"})
        why_not = {gauge["id"]: english(gauge["why_not"]) for gauge in view["gauges"]}
        assert "2020-01-31" in why_not["old"]
        assert not why_not["sphere"]
        assert "2020-01-31" in refusal(desk.command("choose_gauge", id="old"))
        # one that expires after it was chosen
        chosen.write_text(path.read_text())
        desk.wait(lambda view: any("2020-01" in english(f["text"]) for f in view["findings"]))
        assert "2020-01-31" in refusal(desk.command("confirm_artefact"))
    finally:
        chosen.write_text(whole)
        path.unlink()


def test_a_certificate_that_was_uploaded_is_a_sphere_of_the_test(desk: SphereDesk) -> None:
    def upload(name: str, text: str) -> httpx.Response:
        body = {"name": name, "text": text}
        return desk.server.http.post("/api/performance/certificate", json=body)

    assert "no Digital Calibration Certificate" in refusal(upload("k.xml", "<a/>"))
    diameter = quantity("Diameter", real("25", "\\milli\\metre"))
    assert "uncertainty" in refusal(upload("bare.xml", certificate(diameter)))
    added = upload("K-17.xml", certificate(DIAMETER, FORM)).json()
    try:
        assert (added["id"], added["label"], added["why_not"]) == ("K-17", "Ceramic sphere", "")
        desk.start()
        assert "bare" not in {gauge["id"] for gauge in desk.view()["gauges"]}
        assert "There is no such gauge" in refusal(desk.command("choose_gauge", id="bare"))
        desk.do("choose_gauge", id="K-17")
        view = desk.do("confirm_artefact")
        copy = desk.server.data / "performance" / view["session_id"] / "gauge.json"
        assert read_gauge(copy).serial_number == "K-17"
    finally:
        (desk.server.data / "gauges" / "K-17.xml").unlink()

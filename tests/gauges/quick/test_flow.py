"""The guided verification over HTTP, simulated: each cloud once, none lost, judged and kept."""

import hashlib
import json
import shutil
import uuid
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

from crenel.gauges.quick.document import read_verification
from crenel.gauges.quick.evaluate_gauge import filters_of
from crenel.gauges.quick.guide.commands import measure_waiting
from crenel.gauges.quick.guide.guide import VerifyGuide
from crenel.gauges.session.gauge_session import GaugeServices
from crenel.metrology.decision import GUARDED_95
from crenel.station.jobs import Jobs
from crenel_hardware.interfaces import Button
from tests.api.calibrated import use_truth
from tests.api.conftest import PATIENCE_S, Server, View, comes, is_enabled, refusal, wait_for
from tests.api.desks import GuideDesk, left_in_order, next_station
from tests.sent_texts import english

pytestmark = pytest.mark.device


class VerifyDesk(GuideDesk):
    path = "/api/verify"

    def start(self, gauge: str) -> View:
        self.close()
        self.http.post("/api/verify/start").raise_for_status()
        self.do("choose_gauge", id=gauge)
        return self.do("confirm_gauge")

    def start_without_touches(self, gauge: str) -> View:
        self.start(gauge)
        return self.do("skip_touch")

    def cloud(self, part: str) -> View:
        """Scans one cloud over a part of the table, and waits for what it shows."""
        number = len(self.do("begin_cloud")["picture"]["clouds"])
        assert self.server.simulation.operator.scan_part(part)
        self.do("finish_cloud")
        return self.wait_for_cloud(number, "good", "refused")

    def wait_for_cloud(self, number: int, *states: str) -> View:
        return self.wait(
            lambda view: (
                view["busy"] is None and view["picture"]["clouds"][number - 1]["state"] in states
            )
        )


@pytest.fixture
def desk(server: Server, calibration: str) -> Iterator[VerifyDesk]:
    with left_in_order(VerifyDesk(server)) as desk:
        yield desk


def test_a_plate_is_verified_by_the_operator_and_kept(desk: VerifyDesk, calibration: str) -> None:
    server = desk.server
    desk.start("plate")
    desk.do("back")
    server.http.post("/api/temperature", json={"celsius": 20.5}).raise_for_status()
    view = desk.simulate_up_to_review()
    # how well a busy machine's pass is known differs; what is found does not
    result = view["picture"]["verdict"]["result"]
    decisions = {figure["decision"] for figure in view["picture"]["figures"]} - {"none"}
    assert "fail" not in decisions, [figure["reason"] for figure in view["picture"]["figures"]]
    assert result == ("uncertain" if "uncertain" in decisions else "pass")
    of_each = {"form", "form_all", "range_all", "rms", "angle", "offset", "z_error"}
    names = {figure["name"] for figure in view["picture"]["figures"]}
    assert names == of_each | {"angle_range", "offset_range"}
    assert view["picture"]["rule"]["name"] == "guarded-95"
    urls = [cloud["map_url"] + "?of=1&of=2&of=3" for cloud in view["picture"]["clouds"]]
    maps = [server.http.get(url).json() for url in urls]
    assert len({one["end_um"] for one in maps}) == 1
    for cloud, one in zip(view["picture"]["clouds"], maps, strict=True):
        deviations = one["map"]
        assert len(deviations["x_mm"]) == len(deviations["deviation_um"]) > 100
        ends = [end["deviation_um"] for end in deviations["outliers"] if end["is_end"]]
        assert max(ends) - min(ends) == pytest.approx(cloud["range_all_um"], abs=0.03)
    assert server.http.get(urls[0].replace("cloud/1/", "cloud/9/")).status_code == 404
    assert not desk.do("accept")["running"]

    newest, *_ = server.http.get("/api/verifications").json()
    assert (newest["calibration_id"], newest["result"]) == (calibration, result)
    folder = server.data / "verifications" / newest["id"]
    record = read_verification(folder)
    assert record.operator == newest["operator"] != ""
    assert record.calibration.id == calibration
    assert record.simulated
    assert (record.gauge.serial_number, record.rule.rule) == ("TWIN-P1", GUARDED_95)
    assert record.filters == filters_of("plane")
    for cloud in record.clouds:
        assert (cloud.in_gate or 0) >= cloud.used
        assert (cloud.range_all_um or 0.0) >= (cloud.form_all_um or 0.0)
        # the plane of fewer points is another one: by it, the rest may reach a little further
        assert (cloud.form_all_um or 0.0) >= 0.9 * cloud.form_um > 0
    assert (record.temperature.end_c, len(record.clouds)) == (20.5, 3)
    assert record.placing is not None
    assert record.placing.touches == 6
    assert {entry.file for entry in record.inputs} >= {"touches.csv", "cloud-3/scan.mcap"}
    for entry in record.inputs:
        assert hashlib.sha256((folder / entry.file).read_bytes()).hexdigest() == entry.sha256
    served = server.http.get(f"/api/verifications/{newest['id']}").json()
    assert served == json.loads((folder / "verification.json").read_text())
    # a cloud of a verification is no scan of its own
    assert all("cloud" not in scan["id"] for scan in server.http.get("/api/scans").json())

    other = use_truth(server, f"{calibration}-again")
    made = server.http.post(f"/api/verifications/{newest['id']}/study")
    assert made.status_code == 200, made.text
    study = wait_for(
        lambda: study_of(server, newest["id"]),
        lambda state: not state["running"] and state["study"] is not None,
    )["study"]
    assert {calibration, other} <= set(study["calibration_ids"])
    assert len(study["rows"]) == 3 * len(study["calibrations"])
    rows = {(row["cloud"], row["calibration"]): row for row in study["rows"]}
    at = study["calibration_ids"].index(calibration)
    for number, cloud in enumerate(record.clouds):
        assert rows[number, at]["angle_arcsec"] == pytest.approx(cloud.angle_arcsec, abs=1e-3)
        assert rows[number, at]["z_error_um"] == pytest.approx(cloud.z_error_um, abs=1e-3)


def study_of(server: Server, verification: str) -> Any:
    return server.http.get(f"/api/verifications/{verification}/study").json()


def test_two_tabs_and_a_repeated_key_take_a_cloud_once(desk: VerifyDesk) -> None:
    rev = desk.start_without_touches("plate")["rev"]
    desk.wait(lambda view: is_enabled(view, "begin_cloud"))
    with ThreadPoolExecutor(5) as tabs:
        answers = list(tabs.map(lambda _: desk.command("begin_cloud", rev=rev), range(5)))
    assert sorted(answer.status_code for answer in answers) == [200, 409, 409, 409, 409]
    assert {a.json()["code"] for a in answers if a.status_code == 409} == {"stale-view"}
    assert len(desk.view()["picture"]["clouds"]) == 1
    key, rev = uuid.uuid4().hex, desk.view()["rev"]
    assert desk.command("drop_cloud", rev=rev, key=key).status_code == 200
    again = desk.command("drop_cloud", rev=rev, key=key)
    assert again.status_code == 200
    assert [cloud["state"] for cloud in again.json()["picture"]["clouds"]] == ["aside"]


def test_a_cloud_that_stop_ends_is_measured_and_another_thing_is_named(desk: VerifyDesk) -> None:
    desk.start("sphere")
    assert "5" in refusal(desk.command("confirm_touch"))
    desk.do("skip_touch")
    desk.do("begin_cloud")
    assert desk.server.simulation.operator.scan_part("plate")
    desk.server.http.post("/api/stop").raise_for_status()
    view = desk.wait_for_cloud(1, "refused")
    assert "no sphere of 25.40 mm" in english(view["picture"]["clouds"][0]["text"])
    assert "No cloud covers the gauge" in refusal(desk.command("confirm_clouds"))
    view = desk.cloud("sphere")
    assert view["picture"]["clouds"][1]["state"] == "good"
    assert abs(view["picture"]["clouds"][1]["radius_error_um"]) < 100
    assert view["picture"]["clouds"][1]["centre_error_um"] is None
    view = desk.do("confirm_clouds")
    assert "were not compared" in english(view["picture"]["verdict"]["text"])


def test_touches_come_from_the_button_and_are_taken_back(desk: VerifyDesk) -> None:
    desk.start("plate")
    server = desk.server
    guide, operator = server.context.verify_guide, server.simulation.operator
    for attempt in range(12):  # a busy machine's arm may come late for a press
        with guide.lock:
            taken, declined = len(guide.state.touches), guide.declined
        if taken == 5:
            break
        assert operator.touch_gauge("plate", taken + 10 * (attempt - taken))
        comes(lambda: len(guide.state.touches) > taken or guide.declined > declined)  # noqa: B023
    view = desk.view()
    assert view["number"]["value"] < 30
    assert view["picture"]["touches"][3]["x_mm"] is not None
    # the arm rests in the air
    wait_for(lambda: desk.command("touch").json()["code"], "off-the-plane".__eq__)
    server.press(Button.UNDO)
    view = desk.wait(lambda view: len(view["picture"]["touches"]) == 4)
    assert len(desk.do("undo")["picture"]["touches"]) == 3
    assert "3 of at least 4" in refusal(desk.command("confirm_touch"))
    assert [len(desk.do("redo")["picture"]["touches"]) for _ in range(2)] == [4, 5]
    assert desk.command("redo").status_code == 422
    for _ in range(3):
        desk.do("undo")
    # as soon as the arm rests, and there only once
    desk.do("touch")
    assert desk.command("touch").json()["code"] == "same-place"
    server.press(Button.BACK)
    view = desk.wait(lambda view: view["step"] == "gauge")
    assert [step["state"] for step in view["steps"]] == ["current", "stale", "todo", "todo"]


def test_another_calibration_meanwhile_is_reported_in_one_sentence(desk: VerifyDesk) -> None:
    desk.start_without_touches("plate")
    use_truth(desk.server, f"meanwhile-{uuid.uuid4().hex[:6]}")
    view = desk.view()
    assert any("The calibration in use has changed" in english(f["text"]) for f in view["findings"])
    assert [action["name"] for action in view["actions"]] == ["again", "abandon"]
    assert "calibration in use has changed" in refusal(desk.command("begin_cloud"))
    view = desk.do("again")
    assert view["step"] == "gauge"
    assert is_enabled(view, "confirm_gauge")


def test_a_broken_nominal_is_named_beside_the_others(desk: VerifyDesk) -> None:
    broken = desk.server.data / "gauges" / "broken.nominal.json"
    broken.write_text('{"format": "crenel/nominal", "version": 1, "shape": "sphere"}')
    try:
        desk.start("plate")
        desk.do("back")
        view = desk.wait(lambda view: any("broken" in english(f["text"]) for f in view["findings"]))
        finding = next(f for f in view["findings"] if "broken" in english(f["text"]))
        assert english(finding["text"]).startswith("gauges/broken.nominal.json")
        assert "radius_mm" in english(finding["text"])
        assert [gauge["id"] for gauge in view["gauges"]] == ["plate", "sphere", "surface-plate"]
    finally:
        broken.unlink()


def test_a_server_killed_while_it_scans_loses_no_cloud(desk: VerifyDesk, tmp_path: Path) -> None:
    """What is on the disk at that moment is all that a next server has."""
    server, simulated_operator = desk.server, desk.server.simulation.operator
    desk.start_without_touches("plate")
    session = desk.do("begin_cloud")["session_id"]
    with ThreadPoolExecutor(1) as elsewhere:
        moving = elsewhere.submit(simulated_operator.scan_part, "plate")
        wait_for(lambda: server.context.scanner.state().points, lambda points: points > 3000)
        moving.result(PATIENCE_S)
    shutil.copytree(server.data, left := tmp_path / "left")
    desk.do("finish_cloud")
    with next_station(server, left) as (store, bus, rig, scanner, scene):
        jobs = Jobs(bus)
        station = GaugeServices(bus, rig, jobs, None, scanner, scene)
        guide = VerifyGuide(station, store.journal, store.calibrations, store.verifications, left)
        assert guide.state.session_id == session
        assert guide.state.open_cloud is not None
        assert guide.view().step == "scan"
        measure_waiting(guide)
        jobs.wait(PATIENCE_S)
        (cloud,) = guide.view().picture.clouds
        assert cloud.state == "good", cloud.text
        assert cloud.points > 1000

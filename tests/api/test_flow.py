"""The guided calibration over HTTP, simulated: done once, done in order, lost never."""

import json
import math
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path
from threading import Event
from typing import Any

import httpx
import numpy as np
import pytest

from crenel.formats.results.acceptance import read_acceptance
from crenel.report.contents.reports import render_report
from crenel.workflows.calibrate import calibrate_session
from crenel_hardware.clock import now_ns
from crenel_hardware.interfaces import Button
from tests.api.conftest import PATIENCE_S, Server, code_of, is_enabled, wait_for
from tests.bench.faults.served import HALF

pytestmark = pytest.mark.device

STATION = replace(HALF, width_px=800, height_px=640)


def points(view: dict[str, Any]) -> list[int]:
    return [point["index"] for point in view["picture"]["points"]]


def has_points(count: int, view: dict[str, Any]) -> bool:
    return len(points(view)) == count


def test_the_same_command_twice_acts_once(touching: Server) -> None:
    rev = touching.flow()["rev"]
    first = touching.command("take_point", rev=rev, key="one-click")
    again = touching.command("take_point", rev=rev, key="one-click")
    assert first.status_code == again.status_code == 200
    assert points(again.json()) == [0]


def test_of_two_tabs_at_once_only_one_takes_the_point(touching: Server) -> None:
    rev = touching.flow()["rev"]
    with ThreadPoolExecutor(6) as tabs:
        answers = list(tabs.map(lambda _: touching.command("take_point", rev=rev), range(6)))
    assert sorted(answer.status_code for answer in answers) == [200] + 5 * [409]
    stale = next(answer for answer in answers if answer.status_code == 409)
    assert stale.headers["content-type"] == "application/problem+json"
    assert stale.json()["code"] == "stale-view"
    assert points(stale.json()["view"]) == points(touching.flow()) == [0]


def test_the_same_place_is_no_second_point(touching: Server) -> None:
    touching.do("take_point")
    answer = touching.command("take_point")
    assert code_of(answer) == (422, "same-place")
    assert "point 1" in answer.json()["detail"]
    assert answer.json()["remedy"]
    assert points(touching.flow()) == [0]


def test_the_arms_buttons_take_points_and_take_them_back(touching: Server) -> None:
    simulated_operator = touching.simulation.operator
    for index in (0, 1):
        assert simulated_operator.touch("crest", index)
        touching.wait(partial(has_points, index + 1))
    touching.press(Button.UNDO)
    touching.wait(lambda view: points(view) == [0])
    touching.simulation.device.press(Button.UNDO, True, now_ns())
    # held, it counts before it is let go
    touching.wait(lambda view: view["step"] == "setup")
    touching.simulation.device.press(Button.UNDO, False)
    assert touching.do("confirm_setup")["step"] == "touch"
    assert points(touching.flow()) == [0], "what was taken is kept"
    assert touching.command("redo").status_code == 200
    assert points(touching.flow()) == [0, 1], "what was taken back last is there again"
    assert touching.command("redo").status_code == 422
    assert [touching.command("undo").status_code for _ in range(3)] == [200, 200, 422]


def test_a_point_in_motion_is_declined(touching: Server, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(touching.simulation.operator.planner, "pace", 0.2)
    seen = Event()

    def move_on() -> None:
        while not seen.is_set():  # a busy machine may see nothing of the first motion
            touching.simulation.operator.hold_over("block")
            touching.simulation.operator.hold_over("board")

    with ThreadPoolExecutor(1) as elsewhere:
        moving = elsewhere.submit(move_on)
        try:
            touching.wait(lambda view: not is_enabled(view, "take_point"))
            answer = touching.command("take_point")
        finally:
            seen.set()
        moving.result(PATIENCE_S)
    assert answer.status_code == 422
    assert "still" in answer.json()["detail"]
    assert points(touching.flow()) == []


def test_back_and_forth_keeps_the_points(touching: Server) -> None:
    touching.do("take_point")
    view = touching.do("back")
    assert view["step"] == "setup"
    assert [s["state"] for s in view["steps"]][:3] == ["done", "current", "stale"]
    view = touching.do("confirm_setup")
    assert points(view) == [0]


def test_commands_that_belong_elsewhere_are_declined(touching: Server) -> None:
    for name in ("solve", "accept", "confirm_place", "no_such_command"):
        answer = touching.command(name)
        assert code_of(answer) == (422, "not-now")
        assert answer.json()["detail"]


def test_starting_twice_resumes_the_open_session(touching: Server) -> None:
    before = touching.flow()
    again = touching.http.post("/api/flow/start").json()
    assert again["session_id"] == before["session_id"]
    assert again["rev"] == before["rev"]


def test_the_simulated_operator_stops_on_command(touching: Server) -> None:
    touching.do("run_simulation")
    touching.wait(lambda view: len(points(view)) >= 2)
    # stopping needs no fresh view
    assert touching.command("stop_simulation", rev=0).status_code == 200
    touching.wait(lambda view: view["busy"] is None)
    taken = points(touching.flow())
    time.sleep(0.5)
    view = touching.flow()
    assert (points(view), view["step"]) == (taken, "touch")


def test_a_whole_calibration_by_the_simulated_operator(at_setup: Server, tmp_path: Path) -> None:
    server, http = at_setup, at_setup.http
    with first_picture_in_the_dark(server):
        server.do("run_simulation", all=True)
    view = server.simulate_up_to_review()
    # the picture in which nothing is seen was taken again
    assert min(pose["number"] for pose in view["picture"]["poses"]) > 1

    result = view["picture"]["result"]
    reported = "\n".join(f"{each['quality']}: {each['text']}" for each in view["findings"])
    assert result["verdict"] == "good", reported
    assert 0 < result["total_um"] < 50
    assert len(view["picture"]["points"]) == 27
    poses = view["picture"]["poses"]
    assert all(len(pose["corners"]) >= 8 for pose in poses)
    image = http.get(poses[0]["image_url"])
    assert image.headers["content-type"] == "image/png"
    assert image.content.startswith(b"\x89PNG")

    view = step_by_step_to_the_review(server)
    result = view["picture"]["result"]

    # the folder alone gives the same calibration
    folder = server.data / "sessions" / view["session_id"]
    calibrate_session(folder, tmp_path / "again.json")
    again = json.loads((tmp_path / "again.json").read_text())
    kept = json.loads((folder / "calibration.json").read_text())
    assert {k for k in kept if kept[k] != again[k]} <= {"created_at", "operator"}
    assert again["probe_matrix"] == result["probe_matrix"]

    before = {one["id"] for one in http.get("/api/calibrations").json()}
    assert view["session_id"] not in before
    assert (http.get("/api/home").json()["calibration"] is None) == (not before)
    rev = view["rev"]
    assert server.command("accept", rev=rev, key="accepted-once").json()["running"] is False
    assert server.command("accept", rev=rev, key="accepted-once").status_code == 200
    after = http.get("/api/calibrations").json()
    assert {one["id"] for one in after} - before == {view["session_id"]}
    assert len(after) == len(before) + 1
    (summary,) = (one for one in after if one["active"])
    assert summary["id"] == view["session_id"]
    assert summary["arm_serial"] == "TWIN-A1"
    home = http.get("/api/home").json()
    assert home["calibration"]["id"] == summary["id"]
    assert home["next"]["page"] == "verify"
    assert http.get(f"/api/calibrations/{summary['id']}/calibration.json").json() == kept
    assert_reported(http, f"/api/calibrations/{summary['id']}", folder)
    assert_looked_at_again(http, summary["id"], view["picture"])
    scan_with_it(http, server)


@contextmanager
def first_picture_in_the_dark(server: Server) -> Iterator[None]:
    """What is begun within takes its first picture without light."""
    images = server.data / "sessions" / server.flow()["session_id"] / "images"
    server.simulation.lighting.room = 0.0
    try:
        yield
        wait_for(lambda: list(images.glob("*.png")), bool)
    finally:
        server.simulation.lighting.room = 1.0


def assert_looked_at_again(http: httpx.Client, name: str, reviewed: dict[str, Any]) -> None:
    """The record shows what the review did, with pictures of its own."""
    record = http.get(f"/api/calibrations/{name}").json()
    assert record["operator"] == "Demo"
    assert record["picture"]["result"] == reviewed["result"]
    assert record["picture"]["points"] == reviewed["points"]
    pose, *_ = record["picture"]["poses"]
    assert pose["action"] is None
    assert len(pose["stripe_off"]) > 10
    corner = pose["corners"][0]
    assert math.hypot(*corner["off_px"]) == pytest.approx(corner["residual_px"])
    assert http.get(pose["image_url"]).content.startswith(b"\x89PNG")
    assert http.get(f"/api/calibrations/{name}/image/none.png").status_code == 404
    assert http.get("/api/calibrations/none").status_code == 404
    history = http.get("/api/calibration-history").json()
    (kept,) = (each for each in history if each["id"] == name)
    assert kept["good_um"] == 50.0
    # the first has no calibration before it to have changed from
    assert (kept["sensor_um"] is None) == (len(history) == 1)


def assert_reported(http: httpx.Client, record: str, folder: Path) -> None:
    """The report is served as the folder alone gives it, and can run no script."""
    for form, kind in (("html", "text/html"), ("pdf", "application/pdf")):
        served = http.get(f"{record}/report.{form}")
        assert served.headers["content-type"].startswith(kind)
        assert served.content == render_report(folder, f".{form}")
    policy = http.get(f"{record}/report.html").headers["content-security-policy"]
    assert "default-src 'none'" in policy
    assert "sandbox" in policy
    assert http.get(f"{record}/report.doc").status_code == 422
    accepted = read_acceptance(folder)
    assert accepted is not None
    assert accepted.operator == "Demo"


def step_by_step_to_the_review(server: Server) -> dict[str, Any]:
    """A new picture by the arm's button, then back to the points, the picture kept."""
    assert server.do("retake")["step"] == "capture"
    server.wait(lambda view: is_enabled(view, "capture"))
    server.press(Button.PRIMARY)
    server.wait(lambda view: view["step"] == "solve" and view["busy"] is None)
    server.do("solve")
    server.wait(lambda view: view["step"] == "review")
    server.do("back", to="touch")
    server.do("confirm_touch")
    server.wait(lambda view: is_enabled(view, "confirm_place"))
    server.press(Button.PRIMARY)
    server.wait(lambda view: view["step"] == "capture")
    view = server.do("keep_picture")
    assert view["step"] == "solve"
    assert view["picture"]["line"] is None
    say_what_the_line_is_like(server)
    server.do("solve")
    server.wait(lambda view: view["step"] == "review")
    return server.flow()


def say_what_the_line_is_like(server: Server) -> None:
    """No line is so bright; automatically, it is found in the same pictures again."""
    for threshold, found in ((60_000.0, False), (None, True)):
        server.do("set_line", threshold=threshold)
        view = server.wait(lambda view: view["step"] == "solve" and view["busy"] is None)
        poses = [pose for pose in view["picture"]["poses"] if pose["state"] != "aside"]
        assert [len(pose["stripe"]) > 0 for pose in poses] == [found] * len(poses)
        line = view["picture"]["line"]
        assert (line is None) == found
        if line is not None:
            assert line["refused"] == [pose["number"] for pose in poses]
            assert line["threshold"] == threshold


def scan_with_it(http: httpx.Client, server: Server) -> None:
    """A short scan with the calibration just made, saved when stopped."""
    assert http.post("/api/scan/start", json={"name": "Shell"}).json()["state"] == "running"
    assert http.post("/api/scan/start", json={}).json()["code"] == "busy"
    assert http.post("/api/scan/simulation", json={"on": True}).json()["simulation_running"] is True
    wait_for(lambda: http.get("/api/scan").json()["points"], lambda points: points >= 1000)
    assert http.post("/api/stop").status_code == 204
    assert http.post("/api/laser/off").json()["laser"]["state"] == "off"
    scans = wait_for(lambda: http.get("/api/scans").json(), bool)
    assert scans[0]["name"] == "Shell"
    assert scans[0]["points"] >= 1000
    cloud = http.get(f"/api/scans/{scans[0]['id']}/cloud.ply").content
    assert f"element vertex {scans[0]['points']}".encode() in cloud[:500]


@pytest.mark.soak
def test_a_calibration_on_the_chessboard_by_the_operator(at_setup: Server, tmp_path: Path) -> None:
    """Touched first, then the planned views, then those that help most."""
    server, http = at_setup, at_setup.http
    view = server.do("choose", field="object", id="chessboard")
    assert view["picture"]["object"]["kind"] == "board"
    server.do("confirm_setup")
    view = server.simulate_up_to_review()

    picture, result = view["picture"], view["picture"]["result"]
    reported = "\n".join(f"{each['quality']}: {each['text']}" for each in view["findings"])
    assert result["verdict"] == "good", reported
    drawn = {"kind": "board", "inner_corners": [7, 6], "square_mm": 4.5, "first_is_black": True}
    assert picture["object"] == drawn
    touched = [point["at_mm"] for point in picture["points"]]
    assert len(touched) == 6
    assert all(-4.5 < x < 31.5 and -4.5 < y < 27 and z == 0 for x, y, z in touched)
    assert len(picture["poses"]) >= 5
    assert all(len(pose["corners"]) == 42 for pose in picture["poses"])
    assert all(len(pose["outline"]) == 4 for pose in picture["poses"])

    folder = server.data / "sessions" / view["session_id"]
    calibrate_session(folder, tmp_path / "again.json")
    again = json.loads((tmp_path / "again.json").read_text())
    np.testing.assert_allclose(again["probe_matrix"], result["probe_matrix"], atol=1e-9)

    server.do("accept")
    newest = next(one for one in http.get("/api/calibrations").json() if one["active"])
    assert newest["object_serial"] == "TWIN-C1"
    record = http.get(f"/api/calibrations/{newest['id']}").json()
    assert record["picture"]["points"] == picture["points"]
    assert record["picture"]["object"] == picture["object"]
    report = http.get(f"/api/calibrations/{newest['id']}/report.html")
    assert report.content == render_report(folder, ".html")
    assert "chessboard" in report.text

"""The arm's own flows on the simulated station: the daily check, and the identification."""

import uuid
from collections.abc import Callable
from functools import partial
from typing import Any

import httpx
import numpy as np
import pytest

from app.formats.csv_table import table_text
from app.formats.datasheets.arm import ArmFile, read_arm
from app.formats.session.arm_session import read_observations
from app.formats.session.pose_columns import joint_columns
from app.metrology.arm.identification.articulation import ArticulationLimits
from app.metrology.arm.kinematics import Arm, tip_centres
from app.metrology.transforms import apply, rigid_fit
from app.workflows.check_articulation import check_table
from tests.api.conftest import Server, run_command, wait_for
from tests.metrology.arm_sessions import volumetric_error_um
from tests.sent_texts import english
from tests.simulated_robots import Tracker, built, measure, postures

pytestmark = pytest.mark.device

View = dict[str, Any]


def view_of(server: Server) -> View:
    return dict(server.http.get("/api/arm").json())


def command(server: Server, name: str, **args: object) -> httpx.Response:
    body = {"name": name, "args": args, "rev": view_of(server)["rev"], "key": uuid.uuid4().hex}
    return server.http.post("/api/arm/command", json=body)


def do(server: Server, name: str, **args: object) -> View:
    return run_command(lambda: command(server, name, **args))


def wait(server: Server, ready: Callable[[View], bool]) -> View:
    return wait_for(lambda: view_of(server), ready)


@pytest.fixture
def session(server: Server) -> Callable[[str], View]:
    """Starts a new session of a purpose, once nothing else is at work."""

    def begin(purpose: str) -> View:
        wait(server, lambda view: view["busy"] is None)
        if view_of(server)["running"]:
            do(server, "end")
        answer = server.http.post("/api/arm/start", json={"purpose": purpose})
        assert answer.status_code == 200, answer.text
        wait(
            server, lambda view: all(a["enabled"] for a in view["actions"] if a["name"] == "begin")
        )
        return dict(answer.json())

    return begin


def test_a_check_by_the_simulated_operator_is_judged_and_recorded(
    server: Server, session: Callable[[str], View]
) -> None:
    before = len(server.http.get("/api/arm/checks").json())
    view = session("check")
    assert view["step"] == "seat"
    do(server, "set_limit", limit_um=2000)
    do(server, "run_simulation")
    swinging = wait(server, lambda view: len(view["picture"]["tips_um"]) > 5)
    assert swinging["step"] == "swing"
    assert swinging["number"]["value"] > 0
    view = wait(server, lambda view: view["step"] == "result" and view["busy"] is None)
    assert view["number"]["quality"] == "good"
    newest, *others = server.http.get("/api/arm/checks").json()
    report = server.http.get(f"/api/arm/checks/{newest['id']}/report.html").text
    assert "Within the limit" in report
    assert "Operator: Demo" in report
    german = server.http.get(f"/api/arm/checks/{newest['id']}/report.html?lang=de").text
    assert '<html lang="de">' in german
    assert "Bediener: Demo" in german
    refused = server.http.get(f"/api/arm/checks/{newest['id']}/report.html?lang=xx")
    assert refused.status_code == 422
    assert len(others) == before
    assert newest["verdict"] == "good"
    assert newest["points"] >= 30
    assert newest["half_range_um"] == pytest.approx(view["picture"]["half_range_um"])
    for name in ("largest_um", "two_s_um"):
        assert newest[name] == pytest.approx(view["picture"][name])
    # the record can be judged again without us
    folder = server.data / "sessions" / view["session_id"]
    (seat,) = check_table(folder, None, ArticulationLimits(half_range_um=2000))
    assert seat.check.half_range_um.tolist() == pytest.approx(newest["half_range_um"], rel=1e-6)
    refused = command(server, "set_limit", limit_um=10)
    assert refused.status_code == 422
    # the next check begins with the same limit
    assert do(server, "again")["picture"]["limit_um"] == 2000


def test_a_swing_that_is_too_small_is_not_finished(
    server: Server, session: Callable[[str], View]
) -> None:
    session("check")
    do(server, "begin")
    refused = command(server, "finish")
    assert refused.status_code == 422
    assert "of at least 30 points" in refused.json()["detail"]
    assert do(server, "drop_swing")["step"] == "seat"


def test_an_old_view_and_a_repeated_key_do_nothing(
    server: Server, session: Callable[[str], View]
) -> None:
    view = session("check")
    key = uuid.uuid4().hex
    body = {"name": "begin", "args": {}, "rev": view["rev"], "key": key}
    assert server.http.post("/api/arm/command", json=body).status_code == 200
    again = server.http.post("/api/arm/command", json=body)
    assert again.status_code == 200
    assert len(again.json()["picture"]["seats"]) <= 1
    stale = server.http.post("/api/arm/command", json={**body, "key": uuid.uuid4().hex})
    assert stale.status_code == 409
    assert stale.json()["code"] == "stale-view"


def test_stop_ends_the_simulated_operator(server: Server, session: Callable[[str], View]) -> None:
    session("check")
    do(server, "run_simulation")
    wait(server, lambda view: view["step"] == "swing")
    assert server.http.post("/api/stop").status_code == 204
    view = wait(server, lambda view: view["busy"] is None)
    assert view["step"] == "swing"


def test_the_simulated_operator_takes_a_ball_bar_and_a_sphere(
    server: Server, session: Callable[[str], View], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(server.simulation.operator.planner, "pace", 12.0)
    view = session("identify")
    chosen = do(server, "choose_artefact", kind="sphere")
    assert chosen["artefact"] == {
        "kind": "sphere",
        "size_mm": server.simulation.operator.ball_mm,
        "standard_uncertainty_mm": 0.0,
    }
    do(server, "run_simulation")
    view = wait(server, lambda view: view["busy"] is None)
    assert len(view["picture"]["seats"]) == 1, view["findings"]
    (sphere,) = view["picture"]["seats"]
    assert (english(sphere["name"]), sphere["points"]) == ("Sphere 1", 15)
    do(server, "choose_artefact", kind="bar")
    do(server, "run_simulation")
    view = wait(server, lambda view: view["step"] == "swing" and len(view["picture"]["seats"]) == 4)
    do(server, "stop_simulation")
    view = wait(server, lambda view: view["busy"] is None)
    names = [english(seat["name"]) for seat in view["picture"]["seats"]]
    assert names == ["Sphere 1", "Bar 1, end A", "Bar 1, end B", "Bar 2, end A"]
    # an arm that its datasheet does not know to 45 µm reads the bar's length wrong, but not by much
    note = english(view["picture"]["seats"][2]["note"])
    assert abs(float(note.split()[1].replace("−", "-"))) < 500
    do(server, "drop_swing")
    folder = server.data / "sessions" / view["session_id"]
    arm = read_arm(folder / "arm.json")
    found = read_observations(folder, arm)
    assert (len(found.seats), len(found.spheres), len(found.bars)) == (0, 1, 1)
    assert found.bars[0].length_mm == server.simulation.operator.bar_mm
    do(server, "end")


@pytest.mark.soak
def test_several_seats_identify_the_arm_and_the_old_one_is_kept(
    server: Server, session: Callable[[str], View], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(server.simulation.operator.planner, "pace", 12.0)
    session("identify")
    assert command(server, "fit").status_code == 422
    # where a busy machine takes too few points, the fit is refused, and asks for more places
    for _ in range(4):
        view = fit_by_operator(server)
        if view["step"] == "result":
            break
    assert view["step"] == "result", view["findings"]
    result = view["picture"]["result"]
    (seats,) = result["lines"]
    assert seats["after_um"] < seats["before_um"]
    assert result["volume_after_um"] < result["volume_before_um"] / 2
    assert any("ball bar" in english(finding["text"]) for finding in view["findings"])
    identified = server.http.get("/api/arm/identifications").json()[0]
    assert identified["volume_after_um"] == result["volume_after_um"]
    report = server.http.get(f"/api/arm/identifications/{identified['id']}/report.html").text
    assert "Operator: Demo" in report
    assert "Every file has the content that the result was computed from." in report
    check_saved_and_restored(server, partial(volumetric_error_um, server.simulation._rig.arm))
    do(server, "end")


def check_saved_and_restored(server: Server, error_um: Callable[[Arm], float]) -> None:
    """What was identified is used from then on, until the datasheet of before is again."""
    arms = server.data / "arms"
    was = error_um(read_arm(arms / "simulated.json"))
    before = (arms / "simulated.json").read_bytes()
    do(server, "save")
    assert ArmFile.read(arms / "simulated.json").identification is not None
    assert error_um(read_arm(arms / "simulated.json")) < 0.8 * was
    assert before in [path.read_bytes() for path in (arms / "replaced").iterdir()]
    assert command(server, "save").status_code == 422
    identified = (arms / "simulated.json").read_bytes()
    (arms / "simulated.json").write_bytes(identified + b"\n")
    assert command(server, "restore").json()["code"] == "arm-changed"
    (arms / "simulated.json").write_bytes(identified)
    do(server, "restore")
    assert (arms / "simulated.json").read_bytes() == before
    view = view_of(server)
    assert english(view["title"]) == "Before and after"
    assert view["actions"][0]["name"] == "save"


def test_coordinates_of_a_tracker_identify_the_arm(
    server: Server, session: Callable[[str], View]
) -> None:
    view = session("identify")
    refused = command(server, "take_coordinates", text="x_mm,y_mm\n1,2\n")
    assert refused.status_code == 422
    assert "z_mm" in refused.json()["detail"]
    assert refused.json()["detail"].startswith("coordinates.csv: ")
    with_semicolons = "x_mm;y_mm;z_mm;q1_deg\n1;2;3;4\n"
    refused = command(server, "take_coordinates", text=with_semicolons, file_name="tracker 1.csv")
    assert refused.json()["detail"].startswith("tracker 1.csv: its columns are not separated")
    assert view_of(server)["coordinates"] == 0
    assert command(server, "drop_coordinates").status_code == 422
    rng = np.random.default_rng(1)
    arm = read_arm(server.data / "arms" / "simulated.json")
    tracker = Tracker.somewhere(rng)
    true = built(arm, rng)
    found = measure(true, postures(arm, 60, rng), tracker, rng)
    found.points_mm[16, 0] += 12.0
    rows = np.hstack([found.points_mm, np.degrees(found.q_rad)]).tolist()
    mirrored = [(x, -y, *others) for x, y, *others in rows]
    text = table_text(("x_mm", "y_mm", "z_mm", *joint_columns(arm.joint_count)), mirrored)
    do(server, "take_coordinates", text=text)
    do(server, "fit")
    view = wait(server, lambda view: view["busy"] is None)
    said = [english(finding["text"]) for finding in view["findings"]]
    assert said[-1].startswith("coordinates.csv: in frame instrument"), said
    text = table_text(("x_mm", "y_mm", "z_mm", *joint_columns(arm.joint_count)), rows)
    view = do(server, "take_coordinates", text=text)
    assert view["coordinates"] == 60
    names = {action["name"]: action for action in view["actions"]}
    assert names["fit"]["primary"]
    assert command(server, "take_coordinates", text=text.replace("x_mm", "x")).status_code == 422
    assert view_of(server)["coordinates"] == 60
    do(server, "fit")
    view = wait(server, lambda view: view["busy"] is None)
    assert view["step"] == "result", view["findings"]
    (line,) = view["picture"]["result"]["lines"]
    assert english(line["title"]) == "Measured coordinates"
    assert line["after_um"] < line["before_um"] / 4
    (left_out,) = [one for one in view["findings"] if "Excluded" in english(one["text"])]
    assert "coordinates.csv line 18" in english(left_out["text"])
    identified = server.http.get("/api/arm/identifications").json()[0]
    report = server.http.get(f"/api/arm/identifications/{identified['id']}/report.html").text
    assert "Measured coordinates" in report
    assert "60 points in 1 frame" in report
    at = postures(arm, 60, rng)
    there = tip_centres(true, at)

    def error_um(arm: Arm) -> float:
        here = tip_centres(arm, at)
        return 1e3 * float(np.std(apply(rigid_fit(there, here), here) - there))

    check_saved_and_restored(server, error_um)
    do(server, "reopen")
    assert do(server, "drop_coordinates")["coordinates"] == 0
    assert not (server.data / "sessions" / view["session_id"] / "coordinates.csv").exists()
    do(server, "end")


def fit_by_operator(server: Server) -> View:
    """The simulated operator takes six places first and then one more; the arm is fitted."""
    do(server, "run_simulation")
    wait(server, lambda view: view["busy"] is None)
    do(server, "fit")
    return wait(server, lambda view: view["busy"] is None)


def test_a_tip_is_checked_on_a_sphere_and_home_knows_of_it(
    server: Server, session: Callable[[str], View], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(server.simulation.operator.planner, "pace", 12.0)
    before = len(server.http.get("/api/arm/tips").json())
    view = session("tip")
    assert view["artefact"]["size_mm"] == server.simulation.operator.ball_mm
    assert command(server, "choose_artefact", kind="seat").status_code == 422
    do(server, "set_limit", limit_um=200)
    # a wrong sphere reads as a wrong tip, and the next step says so
    do(server, "choose_artefact", kind="sphere", size_mm=24.0)
    view = check_by_operator(server)
    assert "another tip is mounted" in english(view["findings"][-1]["text"])
    home = server.http.get("/api/home").json()
    assert (home["next"]["page"], english(home["next"]["label"])) == ("arm", "Check the tip again")
    do(server, "again")
    view = check_by_operator(server)
    tip = view["picture"]["tip"]
    assert (tip["decision"], tip["limit_um"]) == ("pass", 200)
    assert tip["diameter_mm"] == pytest.approx(3.0, abs=0.15)
    assert len(view["picture"]["touches"]) == 9
    newest, *others = server.http.get("/api/arm/tips").json()
    report = server.http.get(f"/api/arm/tips/{newest['id']}/report.html").text
    assert "Operator: Demo" in report
    assert "Every file has the content that the result was computed from." in report
    assert len(others) == before + 1
    assert newest["text"] == view["findings"][-1]["text"]
    home = server.http.get("/api/home").json()
    line = next(check for check in home["checks"] if check["id"] == "tip")
    assert (line["state"], line["page"]) == ("valid", "arm")
    do(server, "end")


def check_by_operator(server: Server) -> View:
    do(server, "run_simulation")
    return wait(server, lambda view: view["step"] == "result" and view["busy"] is None)

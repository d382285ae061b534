"""The arm's own flows on the simulated station: the daily check, and the identification."""

import uuid
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import pytest

from crenel.formats.csv_table import table_text
from crenel.formats.datasheets.arm import ArmFile, read_arm
from crenel.formats.session.arm_session import read_observations
from crenel.formats.session.pose_columns import joint_columns
from crenel.metrology.arm.identification.articulation import ArticulationLimits
from crenel.metrology.arm.kinematics import Arm, tip_centres
from crenel.metrology.transforms import apply, rigid_fit
from crenel.workflows.check_articulation import check_table
from tests.api.conftest import Server, View, code_of, refusal
from tests.api.desks import GuideDesk
from tests.metrology.arm_sessions import volumetric_error_um
from tests.sent_texts import english
from tests.simulated_robots import Tracker, built, measure, postures

pytestmark = pytest.mark.device


class ArmDesk(GuideDesk):
    path = "/api/arm"
    closing = "end"

    def start(self, purpose: str) -> View:
        """A new session of a purpose, once nothing else is at work."""
        self.close()
        answer = self.http.post("/api/arm/start", json={"purpose": purpose})
        assert answer.status_code == 200, answer.text
        self.wait(lambda view: all(a["enabled"] for a in view["actions"] if a["name"] == "begin"))
        return dict(answer.json())

    def fit_by_operator(self) -> View:
        """The simulated operator takes six places first and then one more; the arm is fitted."""
        self.do("run_simulation")
        self.wait_until_idle()
        self.do("fit")
        return self.wait_until_idle()

    def check_by_operator(self) -> View:
        self.do("run_simulation")
        return self.wait(lambda view: view["step"] == "result" and view["busy"] is None)

    def newest(self, kind: str) -> tuple[Any, str]:
        record = self.http.get(f"/api/arm/{kind}").json()[0]
        return record, self.http.get(f"/api/arm/{kind}/{record['id']}/report.html").text


@pytest.fixture
def desk(server: Server) -> ArmDesk:
    return ArmDesk(server)


@pytest.fixture
def fast(server: Server, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(server.simulation.operator.planner, "pace", 12.0)


def test_a_check_by_the_simulated_operator_is_judged_and_recorded(desk: ArmDesk) -> None:
    before = len(desk.http.get("/api/arm/checks").json())
    view = desk.start("check")
    assert view["step"] == "seat"
    desk.do("set_limit", limit_um=2000)
    desk.do("run_simulation")
    swinging = desk.wait(lambda view: len(view["picture"]["tips_um"]) > 5)
    assert swinging["step"] == "swing"
    assert swinging["number"]["value"] > 0
    view = desk.wait(lambda view: view["step"] == "result" and view["busy"] is None)
    assert view["number"]["quality"] == "good"
    newest, report = desk.newest("checks")
    assert "Within the limit" in report
    assert "Operator: Demo" in report
    german = desk.http.get(f"/api/arm/checks/{newest['id']}/report.html?lang=de").text
    assert '<html lang="de">' in german
    assert "Bediener: Demo" in german
    assert desk.http.get(f"/api/arm/checks/{newest['id']}/report.html?lang=xx").status_code == 422
    assert len(desk.http.get("/api/arm/checks").json()) == before + 1
    assert newest["verdict"] == "good"
    assert newest["points"] >= 30
    assert newest["half_range_um"] == pytest.approx(view["picture"]["half_range_um"])
    for name in ("largest_um", "two_s_um"):
        assert newest[name] == pytest.approx(view["picture"][name])
    # the record can be judged again without us
    folder = desk.server.data / "sessions" / view["session_id"]
    (seat,) = check_table(folder, None, ArticulationLimits(half_range_um=2000))
    assert seat.check.half_range_um.tolist() == pytest.approx(newest["half_range_um"], rel=1e-6)
    assert desk.command("set_limit", limit_um=10).status_code == 422
    # the next check begins with the same limit
    assert desk.do("again")["picture"]["limit_um"] == 2000


def test_a_swing_that_is_too_small_is_not_finished(desk: ArmDesk) -> None:
    desk.start("check")
    desk.do("begin")
    assert "of at least 30 points" in refusal(desk.command("finish"))
    assert desk.do("drop_swing")["step"] == "seat"


def test_an_old_view_and_a_repeated_key_do_nothing(desk: ArmDesk) -> None:
    rev, key = desk.start("check")["rev"], uuid.uuid4().hex
    assert desk.command("begin", rev, key).status_code == 200
    again = desk.command("begin", rev, key)
    assert again.status_code == 200
    assert len(again.json()["picture"]["seats"]) <= 1
    assert code_of(desk.command("begin", rev)) == (409, "stale-view")


def test_stop_ends_the_simulated_operator(desk: ArmDesk) -> None:
    desk.start("check")
    desk.do("run_simulation")
    desk.wait(lambda view: view["step"] == "swing")
    assert desk.http.post("/api/stop").status_code == 204
    assert desk.wait_until_idle()["step"] == "swing"


def test_the_simulated_operator_takes_a_ball_bar_and_a_sphere(desk: ArmDesk, fast: None) -> None:
    view = desk.start("identify")
    operator = desk.server.simulation.operator
    chosen = desk.do("choose_artefact", kind="sphere")["artefact"]
    assert chosen.pop("standard_uncertainty_mm") == 0.0
    assert chosen == {"kind": "sphere", "size_mm": operator.ball_mm}
    desk.do("run_simulation")
    view = desk.wait_until_idle()
    assert len(view["picture"]["seats"]) == 1, view["findings"]
    (sphere,) = view["picture"]["seats"]
    assert (english(sphere["name"]), sphere["points"]) == ("Sphere 1", 15)
    desk.do("choose_artefact", kind="bar")
    desk.do("run_simulation")
    view = desk.wait(lambda view: view["step"] == "swing" and len(view["picture"]["seats"]) == 4)
    desk.do("stop_simulation")
    view = desk.wait_until_idle()
    names = [english(seat["name"]) for seat in view["picture"]["seats"]]
    assert names == ["Sphere 1", "Bar 1, end A", "Bar 1, end B", "Bar 2, end A"]
    # an arm that its datasheet does not know to 45 µm reads the bar's length wrong, but not by much
    note = english(view["picture"]["seats"][2]["note"])
    assert abs(float(note.split()[1].replace("−", "-"))) < 500
    desk.do("drop_swing")
    folder = desk.server.data / "sessions" / view["session_id"]
    arm = read_arm(folder / "arm.json")
    found = read_observations(folder, arm)
    assert (len(found.seats), len(found.spheres), len(found.bars)) == (0, 1, 1)
    assert found.bars[0].length_mm == operator.bar_mm
    desk.do("end")


@pytest.mark.soak
def test_several_seats_identify_the_arm_and_the_old_one_is_kept(desk: ArmDesk, fast: None) -> None:
    desk.start("identify")
    assert desk.command("fit").status_code == 422
    # where a busy machine takes too few points, the fit is refused, and asks for more places
    for _ in range(4):
        view = desk.fit_by_operator()
        if view["step"] == "result":
            break
    assert view["step"] == "result", view["findings"]
    result = view["picture"]["result"]
    (seats,) = result["lines"]
    assert seats["after_um"] < seats["before_um"]
    assert result["volume_after_um"] < result["volume_before_um"] / 2
    assert any("ball bar" in english(finding["text"]) for finding in view["findings"])
    identified, report = desk.newest("identifications")
    assert identified["volume_after_um"] == result["volume_after_um"]
    assert "Operator: Demo" in report
    assert "Every file has the content that the result was computed from." in report
    check_saved_and_restored(desk, partial(volumetric_error_um, desk.server.simulation._rig.arm))
    desk.do("end")


def check_saved_and_restored(desk: ArmDesk, error_um: Callable[[Arm], float]) -> None:
    """What was identified is used from then on, until the datasheet of before is again."""
    arms = desk.server.data / "arms"
    was = error_um(read_arm(arms / "simulated.json"))
    before = (arms / "simulated.json").read_bytes()
    desk.do("save")
    assert ArmFile.read(arms / "simulated.json").identification is not None
    assert error_um(read_arm(arms / "simulated.json")) < 0.8 * was
    assert before in [path.read_bytes() for path in (arms / "replaced").iterdir()]
    assert desk.command("save").status_code == 422
    identified = (arms / "simulated.json").read_bytes()
    (arms / "simulated.json").write_bytes(identified + b"\n")
    assert desk.command("restore").json()["code"] == "arm-changed"
    (arms / "simulated.json").write_bytes(identified)
    desk.do("restore")
    assert (arms / "simulated.json").read_bytes() == before
    view = desk.view()
    assert (english(view["title"]), view["actions"][0]["name"]) == ("Before and after", "save")


def test_coordinates_of_a_tracker_identify_the_arm(desk: ArmDesk) -> None:
    view = desk.start("identify")
    said = refusal(desk.command("take_coordinates", text="x_mm,y_mm\n1,2\n"))
    assert "z_mm" in said
    assert said.startswith("coordinates.csv: ")
    with_semicolons = "x_mm;y_mm;z_mm;q1_deg\n1;2;3;4\n"
    refused = desk.command("take_coordinates", text=with_semicolons, file_name="tracker 1.csv")
    assert refused.json()["detail"].startswith("tracker 1.csv: its columns are not separated")
    assert desk.view()["coordinates"] == 0
    assert desk.command("drop_coordinates").status_code == 422
    rng = np.random.default_rng(1)
    arm = read_arm(desk.server.data / "arms" / "simulated.json")
    tracker = Tracker.somewhere(rng)
    true = built(arm, rng)
    found = measure(true, postures(arm, 60, rng), tracker, rng)
    found.points_mm[16, 0] += 12.0
    rows = np.hstack([found.points_mm, np.degrees(found.q_rad)]).tolist()
    mirrored = [(x, -y, *others) for x, y, *others in rows]
    columns = ("x_mm", "y_mm", "z_mm", *joint_columns(arm.joint_count))
    desk.do("take_coordinates", text=table_text(columns, mirrored))
    desk.do("fit")
    view = desk.wait_until_idle()
    said = english(view["findings"][-1]["text"])
    assert said.startswith("coordinates.csv: in frame instrument"), said
    text = table_text(columns, rows)
    view = desk.do("take_coordinates", text=text)
    assert view["coordinates"] == 60
    assert {action["name"]: action for action in view["actions"]}["fit"]["primary"]
    assert desk.command("take_coordinates", text=text.replace("x_mm", "x")).status_code == 422
    assert desk.view()["coordinates"] == 60
    desk.do("fit")
    view = desk.wait_until_idle()
    assert view["step"] == "result", view["findings"]
    (line,) = view["picture"]["result"]["lines"]
    assert english(line["title"]) == "Measured coordinates"
    assert line["after_um"] < line["before_um"] / 4
    (left_out,) = [one for one in view["findings"] if "Excluded" in english(one["text"])]
    assert "coordinates.csv line 18" in english(left_out["text"])
    _, report = desk.newest("identifications")
    assert "Measured coordinates" in report
    assert "60 points in 1 frame" in report
    at = postures(arm, 60, rng)
    there = tip_centres(true, at)

    def error_um(arm: Arm) -> float:
        here = tip_centres(arm, at)
        return 1e3 * float(np.std(apply(rigid_fit(there, here), here) - there))

    check_saved_and_restored(desk, error_um)
    desk.do("reopen")
    assert desk.do("drop_coordinates")["coordinates"] == 0
    assert not (desk.server.data / "sessions" / view["session_id"] / "coordinates.csv").exists()
    desk.do("end")


def test_a_tip_is_checked_on_a_sphere_and_home_knows_of_it(desk: ArmDesk, fast: None) -> None:
    before = len(desk.http.get("/api/arm/tips").json())
    view = desk.start("tip")
    assert view["artefact"]["size_mm"] == desk.server.simulation.operator.ball_mm
    assert desk.command("choose_artefact", kind="seat").status_code == 422
    desk.do("set_limit", limit_um=200)
    # a wrong sphere reads as a wrong tip, and the next step says so
    desk.do("choose_artefact", kind="sphere", size_mm=24.0)
    view = desk.check_by_operator()
    assert "another tip is mounted" in english(view["findings"][-1]["text"])
    home = desk.http.get("/api/home").json()
    assert (home["next"]["page"], english(home["next"]["label"])) == ("arm", "Check the tip again")
    desk.do("again")
    view = desk.check_by_operator()
    tip = view["picture"]["tip"]
    assert (tip["decision"], tip["limit_um"]) == ("pass", 200)
    assert tip["diameter_mm"] == pytest.approx(3.0, abs=0.15)
    assert len(view["picture"]["touches"]) == 9
    newest, report = desk.newest("tips")
    assert "Operator: Demo" in report
    assert "Every file has the content that the result was computed from." in report
    assert len(desk.http.get("/api/arm/tips").json()) == before + 2
    assert newest["text"] == view["findings"][-1]["text"]
    home = desk.http.get("/api/home").json()
    line = next(check for check in home["checks"] if check["id"] == "tip")
    assert (line["state"], line["page"]) == ("valid", "arm")
    desk.do("end")

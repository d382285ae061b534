"""The view: every step says what to do, and every disabled action why."""

import json
import re
from dataclasses import replace

import numpy as np
import pytest
from pydantic_core import to_jsonable_python

from crenel.findings import Finding, Quality
from crenel.formats.results.calibration import PlanePart
from crenel.guide.calibration.flow import build_view
from crenel.guide.calibration.live import CameraCalibration
from crenel.guide.calibration.outcome import CalibrationOutcome, from_payload, to_payload
from crenel.guide.calibration.rules import RULES
from crenel.guide.calibration.state import STEPS, CalibrationState
from crenel.guide.calibration.touch.block import suggest_places
from crenel.guide.calibration.touch.report import touch_report
from crenel.guide.common.result_view import BudgetLine, CalibrationResult, MapPoint, PoseRow
from crenel.guide.common.view import Busy, FlowView, ObjectPicture, ResultPicture, StillPicture
from crenel.station.devices.stillness import Stillness
from tests.guide.builders import (
    ARM,
    BLOCK,
    CONNECTED,
    Row,
    action,
    capture_row,
    contact_joints,
    make_live,
    point_row,
    start_row,
    state_after,
    view_of,
)
from tests.present import present

Rows = list[Row]
FACES = ("crest", "front", "right")


@pytest.fixture(scope="module")
def contacts() -> Rows:
    return [
        point_row(face, contact_joints(ARM, BLOCK, face, place))
        for face in FACES
        for place in suggest_places(BLOCK, face)
    ]


FIRST_POSE = PoseRow(1, True, "", 0.1, 0.1, 3.0)


def outcome(verdict: Quality = "good", *poses: PoseRow) -> CalibrationOutcome:
    result = CalibrationResult(
        verdict=verdict,
        verdict_text=f"It is {verdict}.",
        reprojection_rms_px=0.1,
        laser_plane_rms_um=5.0,
        alignment_rms_um=5.0,
        depth_range_mm=(100.0, 120.0),
        probe_matrix=np.eye(4).tolist(),
        faces=[],
        budget=[BudgetLine("contact points", 12.0)],
        total_um=12.0,
        worst=[],
        comparison=None,
        distortion=[0.0] * 5,
        plane=PlanePart(angle_arcsec=20.0, offset_um=8.0),
        map=[MapPoint(10.0, 20.0, 12.5, True)],
        poses=list(poses or [FIRST_POSE]),
        shown_pose=1,
    )
    return CalibrationOutcome([], [], [], [Finding("good", "It fits.")], result)


def solved_state(contacts: Rows) -> CalibrationState:
    rows = [start_row("touch"), *contacts, capture_row()]
    inputs = state_after(*rows).inputs
    return state_after(*rows, ("solved", {"inputs": inputs, "outcome": to_payload(outcome())}))


def states(contacts: Rows) -> dict[str, CalibrationState]:
    found = {step: state_after(start_row(step), *contacts) for step in STEPS[:-2]}
    found["solve"] = state_after(start_row("touch"), *contacts, capture_row())
    found["review"] = solved_state(contacts)
    return found


@pytest.mark.parametrize("still", [True, False])
@pytest.mark.parametrize("connected", [True, False])
@pytest.mark.parametrize("step", STEPS)
def test_steps_say_what_and_why(step: str, connected: bool, still: bool, contacts: Rows) -> None:
    state = states(contacts)[step]
    live = make_live(state, latest_outcome=outcome() if step == "review" else None)
    if not connected:
        live = replace(live, arm_link=replace(CONNECTED, state="lost", text="The arm was lost."))
    if not still:
        live = replace(live, stillness=Stillness(False, 800.0, 90.0, "Moved 0.8 mm"))
    view = build_view(state, live)
    assert view.step == step
    assert view.running
    assert str(view.instruction).endswith(".")
    assert [s.id for s in view.steps] == list(STEPS)
    assert [s.state for s in view.steps].count("current") == 1
    assert (view.progress is None) == (step in ("devices", "setup", "review"))
    assert sum(a.primary and a.enabled for a in view.actions) <= 1
    for each in view.actions:
        assert each.label
        reason = RULES.rejection_reason(state, live, each.name, each.args)
        assert each.enabled == (each.why_not == "") == (reason == "")
    json.dumps(to_jsonable_python(view, inf_nan_mode="constants"), allow_nan=False)


def test_a_lost_arm_is_said_and_no_point_can_be_taken(contacts: Rows) -> None:
    state = state_after(start_row("touch"), *contacts)
    lost = replace(CONNECTED, state="lost", text="No data from the arm for 3 s")
    view = view_of(state, arm_link=lost)
    assert "No data from the arm" in str(action(view, "take_point").why_not)
    assert view.findings[0].quality == "bad"
    assert "kept" in str(view.findings[0].remedy)
    assert isinstance(view.picture, ObjectPicture)
    assert len(view.picture.points) == 27


def test_the_touch_step_goes_on_only_once_the_object_is_fixed(contacts: Rows) -> None:
    few = state_after(start_row("touch"), *contacts[:18])
    view = view_of(few)
    assert "left" in str(action(view, "confirm_touch").why_not)
    assert action(view, "take_point").primary
    enough = state_after(start_row("touch"), *contacts)
    view = view_of(enough)
    assert action(view, "confirm_touch").enabled
    assert action(view, "confirm_touch").primary
    assert view.progress is not None
    assert (view.progress.done, view.progress.of) == (27, 27)
    assert view.number is not None
    assert 0 < present(view.number.value) < 15
    assert view.number.quality == "good"
    assert not view.findings


def test_a_point_on_a_wrong_face_is_offered_for_removal_and_blocks(contacts: Rows) -> None:
    wrong = point_row("crest", contact_joints(ARM, BLOCK, "front", (1.0, -12.0, 7.5)))
    state = state_after(start_row("touch"), *contacts, wrong)
    view = view_of(state)
    assert "Remove point 28" in str(action(view, "confirm_touch").why_not)
    assert action(view, "void_point").args == {"index": 27}
    assert action(view, "void_point").enabled


def test_another_arm_or_sensor_than_chosen_is_reported_before_it_matters() -> None:
    state = state_after(start_row("setup"))
    live = make_live(state)
    assert live.arm is not None
    assert live.sensor is not None
    seven = replace(live, arm=replace(live.arm, joint_count=7))
    assert "7 joints" in str(action(build_view(state, seven), "confirm_setup").why_not)
    small = replace(live, sensor=replace(live.sensor, width_px=640))
    assert "640" in str(action(build_view(state, small), "confirm_setup").why_not)
    other = replace(live, sensor=replace(live.sensor, serial_number="S-9"))
    view = build_view(state, other)
    assert "S-9" in str(action(view, "confirm_setup").why_not)
    assert any("S-9" in str(finding.text) for finding in view.findings)
    silent = replace(live, sensor=replace(live.sensor, serial_number=""))
    assert action(build_view(state, silent), "confirm_setup").enabled
    nothing = make_live(state, None, arm=None)
    why_not = action(build_view(state, nothing), "confirm_setup").why_not
    assert str(why_not) == "Choose first: arm, object, sensor."


def test_the_live_picture_is_described_once_and_in_sentences() -> None:
    state = state_after(start_row("place"))
    dark = (Finding("attention", "the picture is dark", "open the iris"),) * 2
    live = make_live(state, corners_detected=0, picture_findings=dark)
    view = build_view(state, live)
    (finding,) = view.findings
    assert (str(finding.text), str(finding.remedy)) == ("The picture is dark.", "Open the iris.")
    for_it = Finding("attention", "no board was found: the picture is dark", "open the iris")
    (said,) = build_view(state, replace(live, picture_findings=(*dark, for_it))).findings
    assert str(said.text) == "No board was found: the picture is dark."
    (hint,) = build_view(state, replace(live, laser_on=True)).findings
    assert "laser is on" in str(hint.text)
    (found,) = view_of(state, corners_detected=20).findings
    assert str(found.text) == "20 corners of the object are detected."
    assert build_view(state, replace(live, corners_detected=20)).findings == view.findings


def test_a_running_scan_keeps_the_laser() -> None:
    state = state_after(start_row("capture"))
    live = make_live(state, scanning=True)
    assert "scan" in str(action(build_view(state, live), "capture").why_not)


def test_a_refused_solve_says_why_and_offers_the_ways_back(contacts: Rows) -> None:
    rows = [start_row("touch"), *contacts, capture_row()]
    refused = {
        "inputs": state_after(*rows).inputs,
        "code": "image-dark",
        "what": "the picture is dark",
        "why": "2 % of full scale",
        "remedy": "Raise the exposure",
    }
    state = state_after(*rows, ("solve_refused", refused))
    view = view_of(state)
    assert view.step == "solve"
    assert isinstance(view.picture, StillPicture)
    said = "The picture is dark: 2 % of full scale."
    (finding,) = view.findings
    assert (finding.quality, str(finding.text)) == ("bad", said)
    assert str(finding.remedy) == "Raise the exposure."
    assert action(view, "retake").primary
    of_picture = Finding("bad", f"Exposure is at fault. {said}", "Raise the exposure.")
    declined = CalibrationOutcome([], [], [], [of_picture], None, fault="exposure")
    reported = view_of(state, latest_outcome=declined)
    assert reported.findings == [of_picture]
    dim, none = Finding("attention", "It is dim."), Finding("bad", "There is no stripe.")
    declined = CalibrationOutcome([], [], [], [dim, none], None)
    reported = view_of(state_after(*rows), latest_outcome=declined)
    assert reported.findings == [none, dim]
    state = state_after(*rows, ("solve_refused", refused), ("point_voided", {"index": 3}))
    assert view_of(state).findings == []


def test_a_bad_calibration_cannot_be_accepted(contacts: Rows) -> None:
    state = solved_state(contacts)
    view = view_of(state, latest_outcome=outcome("bad"))
    assert isinstance(view.picture, ResultPicture)
    assert str(action(view, "accept").why_not) == "Do not use it: the findings state why."
    assert action(view, "repeat").primary
    live = make_live(state, latest_outcome=outcome("attention"))
    assert action(build_view(state, live), "accept").enabled
    exchanged = replace(live, arm=replace(present(live.arm), serial_number="A-9"))
    assert "A-9" in str(action(build_view(state, exchanged), "accept").why_not)


def test_a_pose_set_aside_in_the_review_makes_the_result_of_before(contacts: Rows) -> None:
    rows = [start_row("touch"), *contacts, capture_row(), ("another_pose", {}), capture_row()]
    there = outcome("good", FIRST_POSE, replace(FIRST_POSE, number=2))
    inputs = state_after(*rows).inputs
    rows.append(("solved", {"inputs": inputs, "outcome": to_payload(there)}))

    def shown(*more: Row) -> tuple[FlowView, ResultPicture]:
        state = state_after(*rows, *more)
        view = view_of(state, latest_outcome=there)
        assert isinstance(view.picture, ResultPicture)
        return view, view.picture

    view, picture = shown()
    assert not picture.stale
    assert [pose.state for pose in picture.poses] == ["used", "used"]
    offered = present(picture.poses[0].action)
    assert (offered.name, offered.args, offered.enabled) == ("void_pose", {"number": 1}, True)

    view, picture = shown(("pose_voided", {"number": 1}))
    assert picture.stale
    assert [pose.state for pose in picture.poses] == ["aside", "used"]
    assert [str(pose.note) for pose in picture.poses] == ["Excluded", ""]
    assert [pose.edges_rms_px for pose in picture.poses] == [None, 0.1]
    assert str(view.findings[0].text).startswith("Pose 1 is excluded")
    assert action(view, "solve").primary
    assert action(view, "solve").enabled
    assert not [a for a in view.actions if a.name == "accept"]
    back, only = (pose.action for pose in picture.poses)
    assert back is not None
    assert (back.name, back.enabled) == ("restore_pose", True)
    assert "only pose" in str(present(only).why_not)

    _, picture = shown(("pose_voided", {"number": 1}), ("pose_restored", {"number": 1}))
    assert not picture.stale


def test_every_pose_is_listed_and_a_refused_one_says_why(contacts: Rows) -> None:
    finding = Finding("bad", "It is blurred.")
    blurred = CalibrationOutcome([], [], [], [finding], None, fault="focus")
    bad = to_payload(blurred)
    state = state_after(start_row("touch"), *contacts, capture_row(), capture_row(outcome=bad))
    view = view_of(state)
    assert isinstance(view.picture, StillPicture)
    assert view.picture.shown == 2
    assert [str(pose.note) for pose in view.picture.poses] == ["", "Not usable: focus"]
    assert [pose.state for pose in view.picture.poses] == ["taken", "taken"]
    reported = view_of(state, latest_outcome=blurred)
    assert "cannot be used" in str(reported.instruction)
    assert action(reported, "retake").primary
    assert reported.progress is not None
    assert (reported.progress.done, str(reported.progress.text)) == (2, "2 of up to 6 poses")
    assert action(reported, "solve").enabled
    alone = state_after(start_row("touch"), *contacts, capture_row(outcome=bad))
    reported = view_of(alone, latest_outcome=blurred)
    why_not = str(action(reported, "solve").why_not)
    assert why_not == "No picture shows the object yet. Take another."
    assert action(reported, "retake").enabled


def test_with_few_points_it_is_shown_how_many_more_help(contacts: Rows) -> None:
    some = [*contacts[:5], *contacts[9:14], *contacts[18:23]]
    state = state_after(start_row("touch"), *some)
    live = make_live(state)
    known = present(present(live.touch).advice).now_um
    live = replace(live, touch=touch_report(state.counted, ARM, BLOCK, 0.6 * known))
    view = build_view(state, live)
    assert present(view.number).value == pytest.approx(known)
    reported = view.findings[-1]
    expected = r"Unc.*: \d+ µm \(k = 1\); \d+ more on the \w+ face.* reduces? it to \d+ µm\."
    assert re.fullmatch(expected, str(reported.text))


def test_an_ended_session_is_shown_and_takes_no_more_commands(contacts: Rows) -> None:
    state = replace(solved_state(contacts), ended="accepted")
    live = make_live(state, latest_outcome=outcome())
    view = build_view(state, live)
    assert not view.running
    assert [a.name for a in view.actions] == ["repeat"]
    assert {s.state for s in view.steps} == {"done"}
    assert RULES.rejection_reason(state, live, "accept", {})
    # one of camera and mounting alone offers the laser first
    of_camera = replace(present(outcome().result), laser_plane_rms_um=None)
    kept = CameraCalibration("s0", "calibration 0", "A-1", "S-1")
    for known in (kept, None):
        without = replace(outcome(), result=of_camera)
        view = view_of(state, latest_outcome=without, without_laser=known)
        offered = [(a.name, a.enabled, a.primary) for a in view.actions]
        assert offered == [("add_laser", known is not None, True), ("repeat", True, False)]


@pytest.mark.parametrize(
    ("name", "args"),
    [
        ("conjure", {}),
        ("choose", {}),
        ("choose", {"field": "arm", "id": "../../etc"}),
        ("select_face", {"face": "inside"}),
        ("void_point", {"index": 99}),
        ("void_point", {"index": "0"}),
        ("back", {"to": "review"}),
        ("back", {"to": 3}),
        ("run_simulation", {}),
        ("stop_simulation", {}),
        ("accept", {}),
        ("capture", {}),
    ],
)
@pytest.mark.parametrize("step", ["setup", "touch"])
def test_nonsense_is_declined_with_a_reason(name: str, args: dict[str, object], step: str) -> None:
    state = state_after(start_row(step))
    assert RULES.rejection_reason(state, make_live(state), name, args)


def test_while_something_is_at_work_only_stopping_is_possible() -> None:
    state = state_after(start_row("touch"), point_row("crest", np.zeros(6)))
    busy = Busy("The simulated operator at work", 0.3)
    view = view_of(state, busy=busy, simulation_running=True, has_simulation=True)
    assert action(view, "stop_simulation").enabled
    assert not action(view, "undo").enabled
    assert "The simulated operator at work" in str(action(view, "undo").why_not)


def test_an_outcome_comes_back_from_the_journal_as_it_was() -> None:
    assert from_payload(json.loads(json.dumps(to_payload(outcome())))) == outcome()


def test_a_pose_used_without_its_laser_line_says_so(contacts: Rows) -> None:
    row = PoseRow(1, True, "its laser line was excluded, 2.1 mm off", 0.1, None, 3.0)
    picture = view_of(solved_state(contacts), latest_outcome=outcome("good", row)).picture
    assert isinstance(picture, ResultPicture)
    (pose,) = picture.poses
    assert (pose.state, str(pose.note)) == ("used", f"Used, but {row.reason}")
    assert (pose.edges_rms_px, pose.stripe_rms_px) == (0.1, None)


def test_no_outline_is_spoken_of_where_none_is_drawn(contacts: Rows) -> None:
    first = state_after(start_row("place"), *contacts)
    live = make_live(first, corners_detected=0)
    assert "dashed outline" in str(build_view(first, live).instruction)
    # after a picture of which no advice came
    later = state_after(start_row("touch"), *contacts, capture_row(), ("another_pose", {}))
    view = view_of(later, corners_detected=0)
    assert view.step == "place"
    assert "outline" not in str(view.instruction)

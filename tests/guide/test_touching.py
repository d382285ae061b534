"""The touch step: places that lie on the object, and points judged as they come."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.guide.calibration.flow import build_view
from app.guide.calibration.state import CalibrationState
from app.guide.calibration.touch.block import WANTED, points_wanted, suggest_places
from app.guide.calibration.touch.report import face_progress, next_face, same_place, touch_report
from app.metrology.arm.kinematics import Arm
from app.metrology.arm.strained_pose import Strain
from app.metrology.targets.crenellated_block import FACES, Crenellated, probing_face
from tests.guide.builders import contact_joints, make_live, point_row, start_row, state_after

widths = st.floats(1.5, 12.0)


@st.composite
def blocks(draw: st.DrawFn) -> Crenellated:
    merlons = draw(st.integers(2, 6))
    edges = np.cumsum([0.0, *(draw(widths) for _ in range(2 * merlons - 1))]).tolist()
    depth, step, foot = draw(widths) + 2, draw(widths) + 2, draw(widths) + 2
    return Crenellated("b", "1", tuple(edges), -depth, depth, step, 0.0, -foot, 0.002)


@given(blocks(), st.sampled_from(FACES))
def test_every_suggested_place_lies_on_its_face_clear_of_the_edges(
    block: Crenellated, face: str
) -> None:
    places = np.array(suggest_places(block, face))
    assert WANTED - 1 <= len(places) <= WANTED
    normal, offset_mm = probing_face(block, face)
    assert places @ normal == pytest.approx(offset_mm)
    x, edges = places[:, 0], np.array(block.edges_x_mm)
    clear = 0.2
    if face in ("crest", "floor"):
        own = [slice(i, i + 2) for i in range(0 if face == "crest" else 1, len(edges) - 1, 2)]
        on_one = [(x > edges[s][0] + clear) & (x < edges[s][1] - clear) for s in own]
        assert np.any(on_one, axis=0).all()
    if face in ("front", "back"):
        high = places[:, 2] > block.floor_z_mm
        merlon = [(x > a) & (x < b) for a, b in zip(edges[::2], edges[1::2], strict=True)]
        assert np.any(merlon, axis=0)[high].all()
        assert (places[:, 2] > block.base_z_mm).all()
        assert (places[:, 2] < block.crest_z_mm).all()
    if face not in ("front", "back"):
        assert (places[:, 1] > block.front_y_mm).all()
        assert (places[:, 1] < block.back_y_mm).all()


@given(blocks(), st.sampled_from(FACES))
def test_suggested_places_do_not_lie_on_one_line(block: Crenellated, face: str) -> None:
    places = np.array(suggest_places(block, face))
    spread = np.linalg.svd(places - places.mean(axis=0), compute_uv=False)
    assert spread[1] > 0.2


def session(arm: Arm, block: Crenellated, faces: tuple[str, ...], count: int) -> CalibrationState:
    rows = [start_row("touch")]
    for face in faces:
        for place in suggest_places(block, face)[:count]:
            rows.append(point_row(face, contact_joints(arm, block, face, place)))
    return state_after(*rows)


def test_what_is_missing_is_said_until_an_alignment_is_possible(
    arm: Arm, block: Crenellated
) -> None:
    report = touch_report(session(arm, block, ("crest", "front"), 9).counted, arm, block, 15.0)
    assert report.alignment is None
    assert "left" in str(report.missing)
    assert all(p.at_mm is None and p.residual_um is None for p in report.points)


def test_points_that_agree_have_small_residuals_and_their_place(
    arm: Arm, block: Crenellated
) -> None:
    report = touch_report(
        session(arm, block, ("crest", "front", "right"), 9).counted, arm, block, 15.0
    )
    assert report.missing == ""
    assert report.alignment is not None
    assert report.alignment.rms_mm == pytest.approx(0.0, abs=1e-5)
    assert report.questionable == ()
    places = [p.at_mm for p in report.points]
    expected = [q for f in ("crest", "front", "right") for q in suggest_places(block, f)]
    assert np.array(places) == pytest.approx(np.array(expected), abs=1e-4)


def test_a_point_on_another_face_is_named_with_the_face_it_misses(
    arm: Arm, block: Crenellated
) -> None:
    rows = [start_row("touch")]
    for face in ("crest", "front", "right"):
        for place in suggest_places(block, face):
            rows.append(point_row(face, contact_joints(arm, block, face, place)))
    rows.append(point_row("crest", contact_joints(arm, block, "front", (1.0, -12.0, 7.5))))
    report = touch_report(state_after(*rows).counted, arm, block, 15.0)
    assert report.questionable == (27,)
    (finding,) = report.findings
    assert finding.quality == "bad"
    assert "Point 28 misses the crest face" in str(finding.text)
    assert finding.remedy


def test_a_point_off_its_face_is_named_an_outlier(arm: Arm, block: Crenellated) -> None:
    rows = [start_row("touch")]
    rng = np.random.default_rng(5)
    for face in ("crest", "front", "right"):
        normal, _ = probing_face(block, face)
        for i, place in enumerate(suggest_places(block, face)):
            off_mm = 0.2 if (face, i) == ("front", 4) else rng.normal(0.0, 0.005)
            rows.append(point_row(face, contact_joints(arm, block, face, place + off_mm * normal)))
    report = touch_report(state_after(*rows).counted, arm, block, 15.0)
    assert report.questionable == (13,)
    assert report.findings[0].quality == "attention"
    assert "µm" in str(report.findings[0].text)
    assert report.points[13].residual_um == pytest.approx(200.0, abs=15.0)


def test_a_point_with_an_impossible_joint_can_be_removed(arm: Arm, block: Crenellated) -> None:
    """Its place may be right: the joint is turns on."""
    contacts = session(arm, block, ("crest", "front", "left"), 5).counted
    reading = (contacts[3].reading[0] + 6 * np.pi, *contacts[3].reading[1:])
    wrong = replace(contacts[3], reading=reading)
    report = touch_report([*contacts[:3], wrong, *contacts[4:]], arm, block, 15.0)
    assert report.questionable[0] == 3
    assert "Point 4 is implausible: " in str(report.findings[0].text)
    assert report.alignment is not None


def test_the_same_place_twice_is_noticed(arm: Arm, block: Crenellated) -> None:
    state = session(arm, block, ("crest",), 3)
    place = np.array(suggest_places(block, "crest")[1])
    near = contact_joints(arm, block, "crest", place + [0.1, 0.1, 0.0])
    far = contact_joints(arm, block, "crest", place + [1.0, 0.0, 0.0])
    assert same_place(near, state.counted, arm) == 1
    assert same_place(far, state.counted, arm) is None
    assert same_place(near, (), arm) is None


def test_either_end_and_either_long_side_will_do() -> None:
    none = dict.fromkeys(FACES, 0)
    wanted = points_wanted(none)
    assert wanted["crest"] == wanted["front"] == wanted["right"] == WANTED
    wanted = points_wanted({**none, "left": 2, "right": 1, "back": 1})
    assert wanted["left"] == wanted["back"] == WANTED
    assert wanted["right"] == wanted["front"] == wanted["floor"] == 0


def test_a_complete_face_gives_way_to_the_next(arm: Arm, block: Crenellated) -> None:
    report = touch_report(session(arm, block, ("crest",), 9).counted, arm, block, 15.0)
    assert next_face(face_progress(report, "crest", block), "crest") == "front"
    report = touch_report(session(arm, block, ("crest",), 8).counted, arm, block, 15.0)
    assert next_face(face_progress(report, "crest", block), "crest") == "crest"


@pytest.mark.parametrize(
    ("strain", "words"),
    [("stop", "at its stop"), ("straight", "stretched out"), ("base", "close to its base")],
)
def test_a_pose_that_strains_the_arm_is_named(
    arm: Arm, block: Crenellated, strain: Strain, words: str
) -> None:
    state = session(arm, block, ("crest",), 1)
    live = make_live(state, arm, block)
    assert not any(words in str(one.text) for one in build_view(state, live).findings)
    live = replace(live, stillness=replace(live.stillness, strain=strain))
    assert any(words in str(one.text) for one in build_view(state, live).findings)

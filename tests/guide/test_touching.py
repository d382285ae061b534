"""The touch step: places that lie on the object, and points judged as they come."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import ArrayLike

from crenel.guide.calibration.flow import build_view
from crenel.guide.calibration.live import TouchReport
from crenel.guide.calibration.state import Contact
from crenel.guide.calibration.touch.block import WANTED, points_wanted, suggest_places
from crenel.guide.calibration.touch.report import (
    face_progress,
    next_face,
    refuse_far,
    same_place,
    touch_report,
)
from crenel.metrology.arm.strained_pose import Strain
from crenel.metrology.probing.reachable import farthest_apart_mm, too_far
from crenel.metrology.targets.crenellated_block import FACES, Crenellated, probing_face
from tests.guide.builders import (
    ARM,
    BLOCK,
    Row,
    contact_joints,
    make_live,
    point_row,
    start_row,
    state_after,
)
from tests.present import present
from tests.refusals import refused

widths = st.floats(1.5, 12.0)


@st.composite
def blocks(draw: st.DrawFn) -> Crenellated:
    merlons = draw(st.integers(2, 6))
    edges = np.cumsum([0.0, *(draw(widths) for _ in range(2 * merlons - 1))]).tolist()
    depth, step, foot = draw(widths) + 2, draw(widths) + 2, draw(widths) + 2
    return Crenellated("b", "1", tuple(edges), -depth, depth, step, 0.0, -foot, 0.002)


@given(blocks(), st.sampled_from(FACES))
def test_every_suggested_place_lies_on_its_face_clear_of_the_edges_and_of_one_line(
    block: Crenellated, face: str
) -> None:
    places = np.array(suggest_places(block, face))
    spread = np.linalg.svd(places - places.mean(axis=0), compute_uv=False)
    assert spread[1] > 0.2
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


def touch(face: str, place_mm: ArrayLike) -> Row:
    return point_row(face, contact_joints(ARM, BLOCK, face, np.asarray(place_mm)))


def touches(*faces: str, count: int = 9) -> list[Row]:
    return [touch(face, place) for face in faces for place in suggest_places(BLOCK, face)[:count]]


def counted(*rows: Row) -> tuple[Contact, ...]:
    return state_after(start_row("touch"), *rows).counted


def judged(*rows: Row) -> TouchReport:
    return touch_report(counted(*rows), ARM, BLOCK, 15.0)


def test_what_is_missing_is_said_until_an_alignment_is_possible() -> None:
    report = judged(*touches("crest", "front"))
    assert report.alignment is None
    assert "left" in str(report.missing)
    assert all(p.at_mm is None and p.residual_um is None for p in report.points)


def test_points_that_agree_have_small_residuals_and_their_place() -> None:
    report = judged(*touches("crest", "front", "right"))
    assert report.missing == ""
    assert present(report.alignment).rms_mm == pytest.approx(0.0, abs=1e-5)
    assert report.questionable == ()
    places = [p.at_mm for p in report.points]
    expected = [q for f in ("crest", "front", "right") for q in suggest_places(BLOCK, f)]
    assert np.array(places) == pytest.approx(np.array(expected), abs=1e-4)


def test_a_point_on_another_face_is_named_with_the_face_it_misses() -> None:
    wrong = point_row("crest", contact_joints(ARM, BLOCK, "front", (1.0, -12.0, 7.5)))
    report = judged(*touches("crest", "front", "right"), wrong)
    assert report.questionable == (27,)
    (finding,) = report.findings
    assert finding.quality == "bad"
    assert "Point 28 misses the crest face" in str(finding.text)
    assert finding.remedy


def test_a_point_off_its_face_is_named_an_outlier() -> None:
    rows = []
    rng = np.random.default_rng(5)
    for face in ("crest", "front", "right"):
        normal, _ = probing_face(BLOCK, face)
        for i, place in enumerate(suggest_places(BLOCK, face)):
            off_mm = 0.2 if (face, i) == ("front", 4) else rng.normal(0.0, 0.005)
            rows.append(touch(face, place + off_mm * normal))
    report = judged(*rows)
    assert report.questionable == (13,)
    assert report.findings[0].quality == "attention"
    assert "µm" in str(report.findings[0].text)
    assert report.points[13].residual_um == pytest.approx(200.0, abs=15.0)


def test_a_point_with_an_impossible_joint_can_be_removed() -> None:
    """Its place may be right: the joint is turns on."""
    contacts = counted(*touches("crest", "front", "left", count=5))
    reading = (contacts[3].reading[0] + 6 * np.pi, *contacts[3].reading[1:])
    wrong = replace(contacts[3], reading=reading)
    report = touch_report([*contacts[:3], wrong, *contacts[4:]], ARM, BLOCK, 15.0)
    assert report.questionable[0] == 3
    assert "Point 4 is implausible: " in str(report.findings[0].text)
    assert report.alignment is not None


def test_the_same_place_twice_is_noticed() -> None:
    contacts = counted(*touches("crest", count=3))
    place = np.array(suggest_places(BLOCK, "crest")[1])
    near = contact_joints(ARM, BLOCK, "crest", place + [0.1, 0.1, 0.0])
    far = contact_joints(ARM, BLOCK, "crest", place + [1.0, 0.0, 0.0])
    assert same_place(near, contacts, ARM) == 1
    assert same_place(far, contacts, ARM) is None
    assert same_place(near, (), ARM) is None


@given(blocks(), faces := st.sampled_from(FACES), faces, st.integers(0, 80), st.floats(8, 3000))
def test_a_point_farther_off_than_the_block_reaches_is_refused_and_no_other(
    block: Crenellated, face: str, other: str, pair: int, away_mm: float
) -> None:
    tip = ARM.tip
    (first, second) = (
        np.array(suggest_places(block, one)[k]) + tip.radius_mm * probing_face(block, one)[0]
        for one, k in ((face, pair % 8), (other, pair // 8 % 8))
    )
    limit_mm = np.array([farthest_apart_mm(block, face, other, 2 * tip.radius_mm)])
    assert too_far(first[None], second, limit_mm) is None
    beyond = first + (limit_mm[0] + away_mm) * np.eye(3)[pair % 3]
    far = present(too_far(first[None], beyond, limit_mm))
    assert far.apart_mm == pytest.approx(limit_mm[0] + away_mm)


def test_one_of_four_points_in_the_air_accuses_none_of_them() -> None:
    places = np.array(suggest_places(BLOCK, "crest"))
    report = judged(*(touch("crest", places[i] + [0, 0, 12.0 * (i == 0)]) for i in (0, 2, 6, 8)))
    (finding,) = report.findings
    assert "At least one of the points 1, 2, 3, 4 is off the surface." in str(finding.text)
    assert report.questionable == ()
    assert list(report.doubts) == [0, 1, 2, 3]


def test_a_point_beside_its_face_touched_nothing() -> None:
    beside = np.array(suggest_places(BLOCK, "crest")[4]) + [60.0, 0.0, 0.0]
    report = judged(*touches("crest", "front", "right"), touch("crest", beside))
    (finding,) = report.findings
    assert "Point 28 lies beside the crest face: it touched nothing there." in str(finding.text)
    assert report.questionable == (27,)


def test_a_point_that_nothing_judges_yet_is_not_said_to_lie_on_its_face() -> None:
    rows = touches("crest", count=5)
    assert judged(*rows).findings == ()
    place = np.array(suggest_places(BLOCK, "crest")[5]) + [0.0, 0.0, 12.0]
    report = judged(*rows, touch("crest", place))
    (finding,) = report.findings
    assert "Point 6 lies 12.0 mm off the plane" in str(finding.text)
    assert "Remove it" in str(finding.remedy)
    assert [point.outlier for point in report.points] == [False] * 5 + [True]
    assert report.questionable == (5,)
    with refused("not-on-object"):
        refuse_far(
            contact_joints(ARM, BLOCK, "crest", place + [0.0, 0.0, 80.0]),
            "crest",
            counted(*rows),
            ARM,
            BLOCK,
        )


def test_either_end_and_either_long_side_will_do() -> None:
    none = dict.fromkeys(FACES, 0)
    wanted = points_wanted(none)
    assert wanted["crest"] == wanted["front"] == wanted["right"] == WANTED
    wanted = points_wanted({**none, "left": 2, "right": 1, "back": 1})
    assert wanted["left"] == wanted["back"] == WANTED
    assert wanted["right"] == wanted["front"] == wanted["floor"] == 0


def test_a_complete_face_gives_way_to_the_next() -> None:
    for count, face in ((9, "front"), (8, "crest")):
        report = judged(*touches("crest", count=count))
        assert next_face(face_progress(report, "crest", BLOCK), "crest") == face


@pytest.mark.parametrize(
    ("strain", "words"),
    [("stop", "at its stop"), ("straight", "stretched out"), ("base", "close to its base")],
)
def test_a_pose_that_strains_the_arm_is_named(strain: Strain, words: str) -> None:
    state = state_after(start_row("touch"), *touches("crest", count=1))
    live = make_live(state)
    assert not any(words in str(one.text) for one in build_view(state, live).findings)
    live = replace(live, stillness=replace(live.stillness, strain=strain))
    assert any(words in str(one.text) for one in build_view(state, live).findings)

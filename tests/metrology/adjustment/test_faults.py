"""Faults in all contacts together, found by the adjustment beside errors of the arm's links."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from app.bench.metrology.simulated import USUAL, SetUp, SimulatedSetup, draw_session, draw_setup
from app.messages.message import Message, Quantity, Text
from app.metrology.adjustment.core.gauss_newton import solve_adjustment
from app.metrology.adjustment.core.observations import ContactObservations
from app.metrology.adjustment.core.variance_components import Scales
from app.metrology.adjustment.outliers.fault_hypotheses import block_fault_findings
from app.metrology.calibration.findings import CalibrationFinding
from app.metrology.limits import LIMITS
from app.metrology.transforms import Floats
from tests.running.usual import usual

pytestmark = pytest.mark.slow

DRAWS = 6
THREE = ("crest", "front", "left")
ALL_AROUND = ("crest", "front", "back", "left", "right")
# The links of an arm whose tip is off by some 100 and 250 um.
MIDDLING = replace(USUAL, links_mm=0.012, links_rad=3e-5)
POOR = replace(USUAL, links_mm=0.03, links_rad=7.5e-5)


def number(text: Text, name: str) -> float:
    """One of a message's quantities."""
    assert isinstance(text, Message)
    value = text.values[name]
    assert isinstance(value, Quantity)
    return value.value


def station(poses: int, faces: tuple[str, ...], scales: Scales = USUAL) -> SimulatedSetup:
    setup = SetUp("faults", poses, faces=faces, contacts_per_face=10, scales=scales, seed=4)
    return draw_setup(setup)


def said(on: SimulatedSetup, seed: int, tips_mm: Floats | None = None) -> list[CalibrationFinding]:
    """Of a session in which the contacts are off by (N, 3), arm frame."""
    session = draw_session(on, np.random.default_rng(seed))
    touches = touches_of(session.problem.contacts)
    off_mm = np.zeros(3) if tips_mm is None else tips_mm
    moved = replace(touches, tips_mm=touches.tips_mm + off_mm)
    result = solve_adjustment(replace(session.problem, contacts=moved), session.start)
    return block_fault_findings(result, LIMITS)


def touches_of(touches: ContactObservations | None) -> ContactObservations:
    assert touches is not None
    return touches


def touches_on(on: SimulatedSetup) -> ContactObservations:
    return touches_of(draw_session(on, np.random.default_rng(0)).problem.contacts)


def inward(on: SimulatedSetup, mm: dict[str, float]) -> Floats:
    """(N, 3) contacts nearer to the block by so much on these faces."""
    touches = touches_on(on)
    by = np.array([mm.get(face, 0.0) for face in touches.features])
    return np.asarray(-by[:, None] * (touches.normals @ on.T_arm_obj[:3, :3].T))


@pytest.mark.parametrize("scales", [USUAL, MIDDLING, POOR])
@pytest.mark.parametrize("poses", usual([1, 6], 1, pytest.mark.soak))
@pytest.mark.parametrize("faces", [THREE, ALL_AROUND])
def test_errors_of_links_are_no_fault(poses: int, faces: tuple[str, ...], scales: Scales) -> None:
    on = station(poses, faces, scales)
    doubted = [one.code for seed in range(DRAWS) for one in said(on, seed) if one.remedy]
    unchecked = [code for code in doubted if code == "size-unchecked"]
    assert len(unchecked) == (DRAWS if faces == THREE else 0)
    # of the poorest arms one in some forty is doubted
    assert len(doubted) - len(unchecked) <= (1 if scales is POOR else 0)


@pytest.mark.parametrize("pair", [("front", "back"), ("left", "right")])
@pytest.mark.parametrize("by_mm", [-0.08, 0.08])
def test_a_wrong_size_of_the_block_is_named_by_faces(pair: tuple[str, str], by_mm: float) -> None:
    on = station(3, ALL_AROUND)
    (reported,) = said(on, 3, inward(on, dict.fromkeys(pair, by_mm / 2)))
    assert (reported.code, reported.quality) == ("size", "attention")
    assert f"on {pair[0]} and {pair[1]} lie" in str(reported.text)
    assert ("closer together" if by_mm > 0 else "further apart") in str(reported.text)
    off_um = number(reported.text, "opening")
    assert off_um == pytest.approx(1e3 * abs(by_mm), abs=15)


@pytest.mark.parametrize(("by_mm", "quality"), [(0.04, "attention"), (0.4, "bad")])
def test_what_is_wrong_all_around_is_the_tips_diameter(by_mm: float, quality: str) -> None:
    on = station(3, ALL_AROUND)
    (reported,) = said(on, 3, inward(on, dict.fromkeys(ALL_AROUND, by_mm)))
    assert (reported.code, reported.quality) == ("tip-diameter", quality)


@pytest.mark.parametrize("poses", [1, 6])
@pytest.mark.parametrize("off_mm", [(0.0, 0.12, 0.0), (-0.3, 0.2, 0.1)])
def test_a_tip_off_its_place_is_located(poses: int, off_mm: tuple[float, float, float]) -> None:
    on = station(poses, ALL_AROUND)
    (reported,) = said(on, 3, touches_on(on).R_arm_flange @ np.array(off_mm))
    assert reported.code == "tip-place"
    assert reported.quality == ("bad" if np.linalg.norm(off_mm) > 0.15 else "attention")
    named = [number(reported.text, axis) for axis in "xyz"]
    # the tip is back from where the file has it
    assert np.allclose(named, -np.array(off_mm), atol=0.05)


def test_a_poor_arm_does_not_hide_a_tip_far_off() -> None:
    on = station(3, ALL_AROUND, POOR)
    off_mm = touches_on(on).R_arm_flange @ np.array([0.4, 0.3, 0.2])
    for seed in range(6):
        assert [one.code for one in said(on, seed, off_mm)] == ["tip-place"]


@pytest.mark.parametrize(("shift_mm", "turn_deg"), [(0.15, 0.0), (0.0, 0.2), (2.0, 0.5)])
def test_an_object_that_was_moved_is_no_fault_of_the_tip(shift_mm: float, turn_deg: float) -> None:
    on = station(6, THREE)
    tips_mm = touches_on(on).tips_mm
    turn = Rotation.from_rotvec(np.radians(turn_deg) * np.array([0.0, 0.6, 0.8])).as_matrix()
    middle = tips_mm.mean(axis=0)
    moved = (tips_mm - middle) @ turn.T + middle + shift_mm * np.array([0.6, 0.0, 0.8])
    reported = said(on, 3, moved - tips_mm)[0]
    assert reported.code == "object-moved"
    words = f"is {shift_mm:.1f}" if shift_mm else "is rotated by"
    assert f"object {words}" in str(reported.text)


def test_with_one_pose_a_moved_object_cannot_be_identified() -> None:
    on = station(1, THREE)
    assert [one.code for one in said(on, 3, np.array([0.5, 0.0, 0.0]))] == ["size-unchecked"]

"""Faults in all contacts or poses together, found by the adjustment, and what they are."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel.errors import OperationError
from crenel.messages.message import Message, Quantity, Text
from crenel.metrology.adjustment.board.calibrate import calibrate_board
from crenel.metrology.adjustment.board.faults.explain import explain_poses, refuse_misread_poses
from crenel.metrology.adjustment.board.faults.readings import PoseFault
from crenel.metrology.adjustment.board.initial_guess import BoardObservation
from crenel.metrology.adjustment.board.problem import BoardInputs
from crenel.metrology.adjustment.core.gauss_newton import solve_adjustment
from crenel.metrology.adjustment.core.hand_eye import mounting_by_motion, refuse_contradictions
from crenel.metrology.adjustment.core.observations import (
    ContactObservations,
    FailedPose,
    require_observations,
)
from crenel.metrology.adjustment.core.variance_components import Scales
from crenel.metrology.adjustment.outliers.fault_hypotheses import block_fault_findings
from crenel.metrology.calibration.findings import CalibrationFinding
from crenel.metrology.chessboard.board_detection import BoardDetection
from crenel.metrology.limits import LIMITS
from crenel.metrology.stripe import empty_stripe
from crenel.metrology.targets.chessboard import corner_points
from crenel.metrology.transforms import Floats, inverse, rigid, se3_exp
from tests.bench.metrology.simulated import USUAL, SetUp, SimulatedSetup, draw_session, draw_setup
from tests.metrology.boards import BOARD, K1, POSES, ROBOT, SIZE, K, find_flange_pose
from tests.metrology.refusals import refusal_of
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


def project(T_cam_obj: Floats) -> Floats:
    """The corners (N, 2) in px, with a tenth of a pixel of noise."""
    seen = corner_points(BOARD) @ T_cam_obj[:3, :3].T + T_cam_obj[:3, 3]
    xy = seen[:, :2] / seen[:, 2:]
    bent = xy * (1 + K1 * np.sum(xy**2, axis=1, keepdims=True))
    rng = np.random.default_rng(int(T_cam_obj[0, 3] * 1e6) % 2**32)
    return np.asarray(bent @ K[:2, :2].T + K[:2, 2] + rng.normal(0, 0.1, xy.shape))


def given(readings: Floats) -> BoardInputs:
    """All poses without lines, with these poses (P, 4, 4) of the flange."""
    count = BOARD.inner_corners[0] * BOARD.inner_corners[1]
    covariance = np.tile(0.01 * np.eye(2), (count, 1, 1))
    seen = []
    for number, T in enumerate(POSES):
        detection = BoardDetection(project(T), covariance, np.arange(count))
        seen.append(BoardObservation(number, detection, empty_stripe("v")))
    return BoardInputs(ROBOT, BOARD, tuple(seen), readings, SIZE)


def misread(flange: Floats, fault: PoseFault) -> Floats:
    """The poses (P, 4, 4) as a program writes them that does it otherwise."""
    if fault == "before":
        return np.roll(flange, -1, axis=0)
    if fault == "after":
        return np.roll(flange, 1, axis=0)
    if fault == "turns-inverted":
        return np.array([rigid(T[:3, :3].T, T[:3, 3]) for T in flange])
    poses = np.array([inverse(T) for T in flange]) if fault.endswith("inverted") else flange
    if fault.startswith("scalar"):
        quaternions = [Rotation.from_matrix(T[:3, :3]).as_quat() for T in poses]
        turned = [Rotation.from_quat(np.roll(q, 1)).as_matrix() for q in quaternions]
        poses = np.array([rigid(R, T[:3, 3]) for R, T in zip(turned, poses, strict=True)])
    return poses


FLANGE = np.array([find_flange_pose(T) for T in POSES])
TWO_LATE, LEFT = [0, 3, 4, 5, 6, 7], [0, 1, 2, 3, 4, 5]
ONE_EARLY, FIRST = [0, 1, 2, 4, 5, 6, 7], [0, 1, 2, 3, 4, 5, 6]
MIXED = [2, 0, 3, 1, 6, 7, 5, 4]
FAULTS: tuple[tuple[PoseFault, str], ...] = (
    ("scalar-first", "the columns hold qw, qx, qy, qz. Write qx"),
    ("scalar-first-inverted", "base in the flange frame, and the columns hold qw"),
    ("turns-inverted", "the rotations are those of the arm's base"),
    ("inverted", "or the sensor is fixed and the robot carries the board"),
    ("before", "if each belongs to the next picture"),
    ("after", "if each belongs to the picture before"),
)


@pytest.mark.parametrize(("fault", "says"), FAULTS, ids=[fault for fault, _ in FAULTS])
def test_the_fault_of_all_poses_is_named(fault: PoseFault, says: str) -> None:
    with pytest.raises(OperationError, match=says) as refused:
        calibrate_board(given(misread(FLANGE, fault)))
    assert refused.value.code == "poses-read-otherwise"


def test_mirrored_pictures_are_named() -> None:
    """BOARD has six rows: in its mirror image, the colours are right if they run backwards."""
    right = given(FLANGE)
    back = np.arange(len(corner_points(BOARD))).reshape(6, -1)[::-1].ravel()
    mirrored = []
    for one in right.observations:
        uv_px = one.detection.uv_px * [-1, 1] + [SIZE[0] - 1, 0]
        detection = replace(one.detection, uv_px=uv_px, number=back)
        mirrored.append(replace(one, detection=detection))
    with pytest.raises(OperationError, match="the pictures are mirrored") as refused:
        calibrate_board(replace(right, observations=tuple(mirrored)))
    assert refused.value.code == "poses-read-otherwise"


@pytest.mark.parametrize(
    ("seen", "poses", "says"),
    [
        (TWO_LATE, LEFT, "from pose 1 on, poses are 2 rows late"),
        (FIRST, ONE_EARLY, "from pose 3 on, poses are one row early"),
        (range(2, 7), range(5), "from pose 0 on, poses are 2 rows late: .* 3 of 5 poses agree"),
        (range(8), range(7, -1, -1), "in reversed order, 8 of 8"),
        (range(8), MIXED, "have the poses of others .picture: its pose.: 0: 1, 1: 3"),
    ],
)
def test_pictures_and_poses_that_slipped_are_named(
    seen: Sequence[int], poses: Sequence[int], says: str
) -> None:
    right = given(FLANGE)
    pictures = tuple(replace(right.observations[p], number=k) for k, p in enumerate(seen))
    readings = FLANGE[list(poses)]
    with pytest.raises(OperationError, match=says) as refused:
        calibrate_board(replace(right, observations=pictures, readings=readings))
    assert refused.value.code == "poses-read-otherwise"


@pytest.mark.parametrize(
    ("fault", "agree"),
    usual(product(["tool-changed", "object-moved"], [7, 8]), {0, 3}, pytest.mark.soak),
)
def test_a_change_is_named_though_most_poses_agree_without_the_others(
    fault: PoseFault, agree: int
) -> None:
    readings, by = FLANGE.copy(), se3_exp(np.array([0.1, -0.2, 0.05, 30.0, -45.0, 20.0]))
    late = readings[5:]
    readings[5:] = late @ by if fault == "tool-changed" else by @ late
    readings[2:3, :3, 3] += 12.0 * (8 - agree)
    with pytest.raises(OperationError) as refused:
        calibrate_board(given(readings))
    assert isinstance(refused.value.what, Message)
    named = {"fault": fault, "first": 5, "agree": agree}
    assert named.items() <= refused.value.what.values.items()


def test_inverted_poses_that_nearly_agree_are_named() -> None:
    """Most pictures are only tilted about the middle of the board: five of eight agree."""
    inverted = given(misread(FLANGE, "inverted"))
    boards = np.array(POSES)
    mounting = mounting_by_motion(inverted.readings, boards, BOARD.size_mm)
    refuse_contradictions(mounting, range(len(POSES)), "board")
    with pytest.raises(OperationError, match="poses of the arm's base in the flange frame"):
        refuse_misread_poses(inverted, mounting)
    right = given(FLANGE)
    refuse_misread_poses(right, mounting_by_motion(FLANGE, boards, BOARD.size_mm))


def test_poses_that_no_fault_explains_keep_their_reason() -> None:
    reason = OperationError("poses-contradict", "these contradict")
    rng = np.random.default_rng(3)
    anywhere = np.array(
        [rigid(Rotation.random(random_state=rng).as_matrix(), T[:3, 3]) for T in FLANGE]
    )
    assert explain_poses(given(anywhere), reason) is reason


def test_squares_are_doubted_only_if_the_poses_agree_on_another_size() -> None:
    doubt = OperationError("square-size", "these squares are wide")
    larger = FLANGE.copy()
    larger[:, :3, 3] *= 1.2
    assert explain_poses(given(larger), doubt) is doubt
    anywhere = FLANGE.copy()
    anywhere[:, :3, 3] += np.random.default_rng(3).uniform(-80, 80, (len(FLANGE), 3))
    assert explain_poses(given(anywhere), doubt).code == "poses-contradict"


def test_the_commonest_reason_is_named_where_no_picture_serves() -> None:
    codes = ("board-partly-seen", "another-board", "another-board")
    failed = [FailedPose(n, OperationError(code, code)) for n, code in enumerate(codes)]
    assert refusal_of(require_observations, [], failed, "board") is failed[1].error

"""What a calibration on a chessboard says of itself, and bad input, each in words."""

from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel.messages.message import Message
from crenel.metrology.adjustment.board.bundle import adjust_bundle
from crenel.metrology.adjustment.board.calibrate import (
    BoardCalibration,
    calibrate_board,
    observe_board,
)
from crenel.metrology.adjustment.board.findings import BoardEvidence, board_findings
from crenel.metrology.adjustment.board.initial_guess import board_camera
from crenel.metrology.adjustment.board.observations import BoardView
from crenel.metrology.adjustment.board.problem import BoardInputs
from crenel.metrology.adjustment.core.hand_eye import mounting_by_motion
from crenel.metrology.adjustment.core.robot_noise import PosePairs, estimate_robot_noise
from crenel.metrology.calibration.findings import CalibrationFinding
from crenel.metrology.limits import Limits
from crenel.metrology.targets.chessboard import pattern_centre
from crenel.metrology.transforms import Floats, rigid
from tests.metrology.boards import POSES, T_ARM_OBJ, T_FLANGE_CAM, TIP, K, camera_pose
from tests.metrology.numerics import unit
from tests.metrology.refusals import refusal_of
from tests.metrology.seen_boards import PAPER_BOARD, BoardErrors, error_um
from tests.metrology.seen_boards import session as session_of_every_row
from tests.metrology.test_board_calibration import touching
from tests.running.usual import usual
from tests.uncertainty_ratio import ratio_of_deviations

pytestmark = pytest.mark.slow

# A line of 128 points says nearly what one of 512 does, in two thirds of the time.
session = partial(session_of_every_row, rows_apart=4)


@pytest.fixture(scope="module")
def given() -> BoardInputs:
    return session(0)


def finding(inputs: BoardInputs, code: str) -> CalibrationFinding:
    (found,) = (one for one in calibrate_board(inputs).findings if one.code == code)
    return found


@pytest.mark.parametrize(
    "errors", usual([BoardErrors(), BoardErrors(tilt_rad=1.5e-3)], 1, pytest.mark.soak)
)
def test_claims_are_kept(errors: BoardErrors) -> None:
    found = [calibrate_board(session(seed, errors)) for seed in range(5)]
    claimed = np.array([one.uncertainty.total_um for one in found])
    observed = np.array([error_um(one) for one in found])
    ratio_of_deviations(claimed, observed).assert_within(highest=1.09)


def test_a_robots_noise_is_distinguished_from_a_rocking_board() -> None:
    poses = POSES * 3
    inputs = session(1, BoardErrors(tilt_rad=2e-3), poses=poses)
    camera, T = board_camera(inputs.observations, PAPER_BOARD, inputs.size_px)
    views = [
        BoardView(PAPER_BOARD, one.detection, one.stripe, np.zeros(len(one.stripe.u), np.bool_))
        for one in inputs.observations
    ]
    cameras = [replace(camera, rotation=t[:3, :3], translation_mm=t[:3, 3]) for t in T]
    found = adjust_bundle(views, cameras)
    T_cam_obj = np.array([rigid(one.rotation, one.translation_mm) for one in found.cameras])
    mounting = mounting_by_motion(inputs.readings, T_cam_obj, PAPER_BOARD.size_mm)
    seen = PosePairs(inputs.readings, T_cam_obj, found.covariance, pattern_centre(PAPER_BOARD))
    noise = estimate_robot_noise(seen, mounting.T_flange_cam, mounting.T_arm_obj).noise
    assert noise.turn_rad == pytest.approx(3e-4, rel=0.35)
    assert noise.shift_mm == pytest.approx(0.05, rel=0.5)
    assert noise.tilt_rad == pytest.approx(2e-3, rel=0.35)


def test_a_rocking_board_is_named() -> None:
    rocks = finding(session(2, BoardErrors(tilt_rad=3e-3)), "board-rocks")
    assert rocks.quality == "attention"
    assert "Fix the board" in str(rocks.remedy)


def test_what_helps_against_a_poor_robot_is_said() -> None:
    poor = session(3, BoardErrors(turn_rad=2e-4, shift_mm=0.2))
    found = calibrate_board(replace(poor, limits=Limits(20.0, 100.0)))
    reported = found.findings[0]
    assert reported.quality == "bad"
    assert "robot's poses" in str(reported.text)
    assert "more pictures" in str(reported.remedy)
    assert "--usable-um" in str(reported.remedy)
    nearer = verdict_by(Limits(20.0, 150.0), poor, found)
    assert "like these are sufficient in total" in str(nearer.remedy)
    assert isinstance(nearer.remedy, Message)
    assert verdict_by(Limits(1000.0, 2000.0), poor, found).quality == "good"


def verdict_by(limits: Limits, inputs: BoardInputs, found: BoardCalibration) -> CalibrationFinding:
    """The gravest finding if the user had given other limits, which only the findings go by."""
    fit, known = found.adjustment, found.uncertainty
    evidence = BoardEvidence(
        inputs.board, inputs.observations, fit, known, found.poses, limits, {}, {}, None, ()
    )
    return board_findings(evidence)[0]


def with_focal_lengths(inputs: BoardInputs, shares: Floats) -> BoardInputs:
    """The pictures as with another focal length in each, by its share of the common one."""
    middle = np.array([K[0, 2], K[1, 2]])
    seen = [
        replace(one, detection=replace(one.detection, uv_px=middle + (1 + g) * (uv - middle)))
        for one, g in zip(inputs.observations, shares, strict=True)
        for uv in [one.detection.uv_px]
    ]
    return replace(inputs, observations=tuple(seen))


@pytest.mark.parametrize(
    ("shares", "poses"),
    [
        (0.02 * (np.arange(8) > 4), "6, 7, 8"),
        (0.005 * (np.arange(8) % 2), "2, 4, 6, 8"),
        (np.zeros(8), ""),
        (np.full(8, 0.02), ""),
    ],
)
def test_a_focal_length_that_differs_is_named(shares: Floats, poses: str) -> None:
    calm = BoardErrors(turn_rad=1e-4, shift_mm=0.02, line_mm=0.01)
    inputs = with_focal_lengths(session(3, calm), shares)
    if not poses:
        assert calibrate_board(inputs).plane is not None
        return
    refusal = refusal_of(calibrate_board, inputs)
    assert refusal.code == "focal-length-differs"
    assert f"in poses {poses} than" in refusal.line


@pytest.mark.parametrize("seed", usual(range(4), 2, pytest.mark.soak))
def test_a_noisy_robot_has_no_autofocus(seed: int) -> None:
    noisy = BoardErrors(turn_rad=2e-3, shift_mm=1.0)
    assert calibrate_board(session(seed, noisy)).plane is not None


@pytest.mark.parametrize("contacts", usual([True, False], 1, pytest.mark.soak))
def test_a_size_that_is_slightly_wrong_is_flagged(given: BoardInputs, contacts: bool) -> None:
    touched = touching(12, TIP.radius_mm) if contacts else None
    wrong = replace(PAPER_BOARD, square_mm=10.2)
    size = finding(replace(given, board=wrong, contact_readings=touched), "board-size")
    assert size.quality == "bad"
    assert str(size.text).startswith("According to the arm's motion, the squares are")
    assert "the certificate states 10.2 mm" in str(size.text)


def test_a_certificate_that_promises_too_much_is_seen(given: BoardInputs) -> None:
    proud = replace(PAPER_BOARD, standard_uncertainty_mm=0.001, flatness_mm=0.01)
    found = calibrate_board(replace(given, board=proud))
    said = {one.code: str(one.text) for one in found.findings}
    assert "the certificate states 1 µm" in said["board-print"]
    assert "a flatness of 0.01 mm" in said["board-bent"]
    assert error_um(found) < 3 * found.uncertainty.total_um


def test_another_tip_is_seen_by_the_contacts(given: BoardInputs) -> None:
    tip = finding(replace(given, contact_readings=touching(12, 4.0)), "tip-diameter")
    assert "than with 6.000 mm" in str(tip.text)
    assert "its length" in str(tip.remedy)


def test_a_board_that_was_tilted_after_it_was_touched_is_seen(given: BoardInputs) -> None:
    readings = slipped((), 0.0)
    turn = Rotation.from_rotvec(np.radians(1.0) * T_ARM_OBJ[:3, 0]).as_matrix()
    tips = readings[:, :3, :3] @ TIP.centre_mm + readings[:, :3, 3]
    readings[:, :3, 3] += (tips - T_ARM_OBJ[:3, 3]) @ turn.T + T_ARM_OBJ[:3, 3] - tips
    moved = finding(replace(given, contact_readings=readings), "object-moved")
    assert "rotated by 0.9" in str(moved.text) or "rotated by 1.0" in str(moved.text)


def slipped(rows: tuple[int, ...], by_mm: float) -> Floats:
    """``T_arm_flange`` (12, 4, 4) of contacts, those of ``rows`` so far above the board."""
    readings = touching(12, TIP.radius_mm)
    readings[:, :3, 3] += np.random.default_rng(2).normal(0, 0.02, (12, 3))
    readings[list(rows), :3, 3] += by_mm * T_ARM_OBJ[:3, 2]
    return readings


@pytest.mark.parametrize(
    ("seed", "rows"), usual([(1, (1, 7)), (4, (4,)), (3, (1, 7))], 1, pytest.mark.soak)
)
def test_contacts_that_slipped_are_left_out_and_named(seed: int, rows: tuple[int, ...]) -> None:
    found = calibrate_board(replace(session(seed), contact_readings=slipped(rows, 0.6)))
    reported = {one.code: str(one.text) for one in found.findings}
    assert f"{12 - len(rows)} contact points fit the board" in reported["contacts"]
    for row in rows:
        assert f" {row + 1} (board, +" in reported["contact-outliers"]
    assert found.contacts is not None
    assert tuple(np.flatnonzero(found.contacts.excluded)) == rows


def test_contacts_that_only_scatter_are_all_kept(given: BoardInputs) -> None:
    touched = replace(given, contact_readings=slipped((), 0.0))
    codes = [one.code for one in calibrate_board(touched).findings]
    assert "contacts" in codes
    assert "contact-outliers" not in codes


def test_contacts_of_which_a_quarter_slipped_are_named_and_refused(given: BoardInputs) -> None:
    inputs = replace(given, contact_readings=slipped((0, 5, 10), 0.6))
    said = refusal_of(calibrate_board, inputs)
    assert said.code == "contact-off-unknown-which"
    assert "1, 6, 11" in str(said.what)


def test_swapped_poses_are_named_with_one_another(given: BoardInputs) -> None:
    swapped = given.readings[[0, 1, 5, 3, 4, 2, 6, 7]]
    poses = calibrate_board(replace(given, readings=swapped)).poses
    left_out = {pose.number: str(pose.reason) for pose in poses if not pose.used}
    assert set(left_out) == {3, 6}
    assert left_out[3].endswith("it fits the robot's pose of pose 6")
    assert left_out[6].endswith("it fits the robot's pose of pose 3")


def test_a_slightly_wrong_pose_is_left_out(given: BoardInputs) -> None:
    readings = given.readings.copy()
    readings[4, :3, 3] += [0.8, -0.8, 0.8]
    poses = calibrate_board(replace(given, readings=readings)).poses
    assert [pose.number for pose in poses if not pose.used] == [5]


def test_the_lines_before_a_laser_moved_are_named_and_left_out() -> None:
    found = calibrate_board(session(4, BoardErrors(drift_mm=(3.0, 2.5))))
    (moved,) = (one for one in found.findings if one.code == "laser-moved")
    assert moved.quality == "attention"
    assert "poses 1, 2 lie" in str(moved.text)
    assert "excluded" in str(moved.text)
    assert "warm up" in str(moved.remedy)
    assert [pose.number for pose in found.poses if "excluded" in str(pose.reason)] == [1, 2]
    assert error_um(found) < 3 * found.uncertainty.total_um < 900


def test_swapped_poses_are_named_though_their_lines_are_left_out_too() -> None:
    given = session(4, BoardErrors(drift_mm=(3.0, 2.5)))
    readings = given.readings.copy()
    readings[[0, 1]] = readings[[1, 0]]
    found = calibrate_board(replace(given, readings=readings))
    out = {pose.number for pose in found.poses if not pose.used}
    assert out == {given.observations[0].number, given.observations[1].number}
    reported = [str(one.text) for one in found.findings if one.code == "pose-left-out"]
    assert {int(text.split()[1].rstrip(":")) for text in reported} == out
    assert "laser-moved" in {one.code for one in found.findings}


def test_a_laser_that_moved_at_the_end_is_nowhere_for_sure() -> None:
    moved = finding(session(4, BoardErrors(drift_mm=(*(0.0,) * 6, 2.5, 3.0))), "laser-moved")
    assert moved.quality == "bad"
    assert "poses 7, 8 lie" in str(moved.text)
    assert "all lines are used" in str(moved.text)


def test_one_line_that_contradicts_is_left_out() -> None:
    found = calibrate_board(session(4, BoardErrors(drift_mm=(3.0,))))
    (left_out,) = (pose for pose in found.poses if pose.reason)
    assert left_out.number == 1
    assert "laser line was excluded" in str(left_out.reason)
    assert left_out.stripe_points == 0
    assert error_um(found) < 3 * found.uncertainty.total_um


def test_a_laser_along_the_board_is_refused() -> None:
    upright = POSES[0][:3, 2]
    offset_mm = float(upright @ POSES[0][:3, 3])
    poses = tuple(camera_pose(5, about, 10 * about, 230) for about in range(0, 360, 45))
    along = unit([0.06, 0.0, upright[2]])
    given = session(5, poses=poses, normal=along, offset_mm=offset_mm)
    assert refusal_of(calibrate_board, given).code in ("laser-along-board", "stripe-not-found")


def test_boards_all_parallel_are_refused() -> None:
    turned = [rigid(POSES[0][:3, :3], POSES[0][:3, 3] + [0, 0, 5.0 * k]) for k in range(6)]
    inputs = session(6)
    seen = tuple(replace(inputs.observations[0], number=k + 1) for k in range(len(turned)))
    alike = replace(inputs, observations=seen, readings=inputs.readings[: len(seen)])
    assert refusal_of(calibrate_board, alike).code == "boards-parallel"


@pytest.mark.parametrize("level", [0, 90, 255])
def test_a_picture_of_nothing_is_refused(level: int) -> None:
    nothing = np.full((120, 160), level, np.uint8)
    assert refusal_of(observe_board, 1, PAPER_BOARD, nothing, None, "v").code == "board-not-found"


def test_the_truth_is_where_it_was_put() -> None:
    """The sessions made here have no error but those asked for."""
    none = BoardErrors(1e-9, 1e-6, 0.0, 1e-6, 1e-9, 1e-3, 1e-3)
    state = calibrate_board(session(7, none)).adjustment.state
    assert np.linalg.norm((state.T_flange_cam - T_FLANGE_CAM)[:3, 3]) < 0.02
    assert np.linalg.norm((state.T_arm_obj - T_ARM_OBJ)[:3, 3]) < 0.05


def test_a_laser_plane_through_the_camera_is_refused() -> None:
    through = session(0, normal=unit([1.0, 0.1, 0.0]), offset_mm=0.5)
    assert refusal_of(calibrate_board, through).code == "laser-through-camera"

"""Which pose of a chessboard to take next, on an arm with joints."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel.metrology.adjustment.board.calibrate import BoardCalibration, calibrate_board
from crenel.metrology.adjustment.board.problem import BoardInputs
from crenel.metrology.adjustment.core.parameters import SENSOR
from crenel.metrology.adjustment.core.uncertainty import measuring_volume, sensor_jacobian
from crenel.metrology.adjustment.planning.inverse_kinematics import (
    REACHED_MM,
    nearest_joints,
    solve_inverse_kinematics,
)
from crenel.metrology.adjustment.planning.next_pose import PoseAdvice, next_poses, pose_delta
from crenel.metrology.arm.kinematics import Arm, flange_pose
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.targets.chessboard import pattern_centre
from crenel.metrology.transforms import Floats, inverse, rigid
from tests.metrology.boards import NORMAL, POSES, SIZE, T_FLANGE_CAM, camera_pose
from tests.metrology.builders import six_axis_arm
from tests.metrology.seen_boards import PAPER_BOARD, BoardErrors, simulate_detection

pytestmark = pytest.mark.slow

REST_RAD = np.radians([0.0, -70.0, 40.0, 0.0, 70.0, 0.0])
ENCODER_SD_RAD = 1e-5
PLANE = LaserPlane(NORMAL, 137.0)  # across the board's middle where it is looked at from above


@pytest.fixture(scope="module")
def arm() -> Arm:
    return six_axis_arm(ENCODER_SD_RAD)


def taken(arm: Arm, poses: tuple[Floats, ...], seed: int = 1) -> BoardInputs:
    """Pictures ``T_cam_obj`` taken with an arm, the first with its joints at rest."""
    rng = np.random.default_rng(seed)
    T_arm_obj = flange_pose(arm, REST_RAD) @ T_FLANGE_CAM @ poses[0]
    seen, angles = [], []
    for k, T_cam_obj in enumerate(poses):
        T_arm_flange = T_arm_obj @ inverse(T_cam_obj) @ inverse(T_FLANGE_CAM)
        q = solve_inverse_kinematics(arm, T_arm_flange, REST_RAD)
        assert q is not None
        seen.append(simulate_detection(rng, k + 1, PAPER_BOARD, T_cam_obj, PLANE, BoardErrors()))
        angles.append(q + rng.normal(0, ENCODER_SD_RAD, len(q)))
    return BoardInputs(arm, PAPER_BOARD, tuple(seen), np.array(angles), SIZE)


@pytest.fixture(scope="module")
def five(arm: Arm) -> BoardInputs:
    return taken(arm, POSES[:5])


@pytest.fixture(scope="module")
def found(five: BoardInputs) -> BoardCalibration:
    return calibrate_board(five)


@pytest.fixture(scope="module")
def advice(arm: Arm, five: BoardInputs, found: BoardCalibration) -> list[PoseAdvice]:
    return next_poses(found.adjustment, arm, PAPER_BOARD, five.readings)


def check_reached(arm: Arm, found: BoardCalibration, advice: PoseAdvice) -> None:
    """The advised joint angles bring the camera to the advised pose."""
    state = found.adjustment.state
    wished = state.T_arm_obj @ advice.T_obj_cam @ inverse(state.T_flange_cam)
    np.testing.assert_allclose(flange_pose(arm, advice.reading), wished, atol=REACHED_MM)


def test_the_advised_pose_brings_what_was_foretold(
    arm: Arm, five: BoardInputs, found: BoardCalibration, advice: list[PoseAdvice]
) -> None:
    best, worst = advice[0], advice[-1]
    assert best.total_um < worst.total_um <= 1.02 * found.uncertainty.total_um
    check_reached(arm, found, best)
    uv = measuring_volume(found.adjustment).uv_px
    after = {}
    for one in (best, worst):
        more = calibrate_board(taken(arm, (*POSES[:5], inverse(one.T_obj_cam))))
        after[one.total_um] = rms_um(more, uv)
    assert after[best.total_um] < after[worst.total_um]
    assert after[best.total_um] == pytest.approx(best.total_um, rel=0.2)


def test_an_arm_of_five_joints_is_advised_what_it_can_reach(arm: Arm) -> None:
    short = replace(arm, joints=arm.joints[:5])
    rest = REST_RAD[:5]
    T_arm_obj = flange_pose(short, rest) @ T_FLANGE_CAM @ POSES[0]
    rng = np.random.default_rng(2)
    seen, angles = [], []
    for k, T_cam_obj in enumerate(POSES[:6]):
        wished = T_arm_obj @ inverse(T_cam_obj) @ inverse(T_FLANGE_CAM)
        q = nearest_joints(short, wished, rest)
        held = inverse(flange_pose(short, q) @ T_FLANGE_CAM) @ T_arm_obj
        seen.append(simulate_detection(rng, k + 1, PAPER_BOARD, held, PLANE, BoardErrors()))
        angles.append(q + rng.normal(0, ENCODER_SD_RAD, 5))
    inputs = BoardInputs(short, PAPER_BOARD, tuple(seen), np.array(angles), SIZE)
    found = calibrate_board(inputs)
    advice = next_poses(found.adjustment, short, PAPER_BOARD, inputs.readings)
    assert len(advice) >= 5
    assert advice[0].total_um < found.uncertainty.total_um
    for one in advice:
        check_reached(short, found, one)


def rms_um(found: BoardCalibration, uv_px: Floats) -> float:
    """Standard uncertainty of the points that pixels (N, 2) show, over all of them."""
    by = sensor_jacobian(found.adjustment.state, uv_px)
    covariance = found.adjustment.covariance[SENSOR, SENSOR]
    return float(1e3 * np.sqrt(np.mean(np.einsum("gik,kl,gil->g", by, covariance, by))))


def test_the_outline_lies_in_the_picture(advice: list[PoseAdvice]) -> None:
    for one in advice:
        ends = np.array(one.outline_px).reshape(-1, 2)
        assert ends.min() > 0
        assert (ends < SIZE).all()


def test_right_is_what_is_right_in_the_picture_however_the_board_lies() -> None:
    straight, middle = inverse(camera_pose(0, 0, 0, 230)), pattern_centre(PAPER_BOARD)
    right, back = straight[:3, 0], -straight[:3, 1]

    def swung(axis: Floats, T_obj_cam: Floats) -> Floats:
        turn = Rotation.from_rotvec(np.radians(20) * axis).as_matrix()
        return rigid(turn, middle - turn @ middle) @ T_obj_cam

    # swung to the right, the camera has moved to where its picture's right was
    T = swung(back, straight)
    assert (T[:3, 3] - straight[:3, 3]) @ right > 50
    assert str(pose_delta(T, straight, PAPER_BOARD).words) == "tilt right 20°"
    half_turn = rigid(np.diag([-1.0, -1.0, 1.0]), 2 * middle)
    turned = half_turn @ straight
    assert str(pose_delta(half_turn @ T, turned, PAPER_BOARD).words) == "tilt right 20°"

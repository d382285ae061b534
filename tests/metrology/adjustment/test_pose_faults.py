"""Poses of another program that are not what is expected: what they are is said."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from app.errors import OperationError
from app.metrology.adjustment.board.calibrate import calibrate_board
from app.metrology.adjustment.board.initial_guess import BoardObservation
from app.metrology.adjustment.board.pose_faults import (
    PoseFault,
    explain_poses,
    refuse_misread_poses,
)
from app.metrology.adjustment.board.problem import BoardInputs
from app.metrology.adjustment.core.hand_eye import mounting_by_motion, refuse_contradictions
from app.metrology.adjustment.core.observations import FailedPose, require_observations
from app.metrology.chessboard.board_detection import BoardDetection
from app.metrology.stripe import empty_stripe
from app.metrology.targets.chessboard import corner_points
from app.metrology.transforms import Floats, inverse, rigid
from tests.metrology.boards import BOARD, K1, POSES, ROBOT, SIZE, K, find_flange_pose
from tests.metrology.refusals import refusal_of

pytestmark = pytest.mark.slow


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
FAULTS: tuple[tuple[PoseFault, str], ...] = (
    ("scalar-first", "the columns hold qw, qx, qy, qz. Write qx"),
    ("scalar-first-inverted", "base in the flange frame, and the columns hold qw"),
    ("turns-inverted", "the rotations are those of the arm's base"),
    ("before", "if each belongs to the next picture"),
    ("after", "if each belongs to the picture before"),
)


@pytest.mark.parametrize(("fault", "says"), FAULTS, ids=[fault for fault, _ in FAULTS])
def test_the_fault_of_all_poses_is_named(fault: PoseFault, says: str) -> None:
    with pytest.raises(OperationError, match=says) as refused:
        calibrate_board(given(misread(FLANGE, fault)))
    assert refused.value.code == "poses-read-otherwise"


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
    mixed = FLANGE[np.random.default_rng(3).permutation(len(FLANGE))]
    assert explain_poses(given(mixed), reason) is reason


def test_the_commonest_reason_is_named_where_no_picture_serves() -> None:
    codes = ("board-partly-seen", "another-board", "another-board")
    failed = [FailedPose(n, OperationError(code, code)) for n, code in enumerate(codes)]
    assert refusal_of(require_observations, [], failed, "board") is failed[1].error

"""The chessboard's corners in rendered pictures: where, which, how sure; and refusals."""

from dataclasses import replace

import numpy as np
import pytest

from app.errors import OperationError
from app.metrology.chessboard.detect_board import detect_board
from app.metrology.chessboard.laser_light import drop_faint_stripe
from app.metrology.detection.failure_evidence import DetectionError
from app.metrology.stripe import extract_stripe
from app.metrology.targets.chessboard import Chessboard, corner_points
from app.metrology.transforms import Floats, apply
from tests.metrology.boards import BOARD, K1, POSES, K, Look, camera_pose, picture

pytestmark = pytest.mark.slow

CROSSED = POSES[6]


def pixels(board: Chessboard, T_cam_obj: Floats) -> Floats:
    """(N, 2) where every corner truly is seen."""
    x, y, z = apply(T_cam_obj, corner_points(board)).T
    x, y = x / z, y / z
    radial = 1 + K1 * (x**2 + y**2)
    return np.column_stack([K[0, 0] * x * radial + K[0, 2], K[1, 1] * y * radial + K[1, 2]])


def test_corners_are_right_to_hundredths_of_a_pixel_under_the_laser() -> None:
    image = picture(CROSSED, Look())
    found = detect_board(image, BOARD, drop_faint_stripe(image, extract_stripe(image, "v")))
    off = found.uv_px - pixels(BOARD, CROSSED)[found.number]
    assert 36 <= len(found) < 42  # those under the line are left out
    assert np.sqrt(np.mean(off**2)) < 0.03
    assert np.abs(off).max() < 0.1
    assert not found.other_numbers


@pytest.mark.parametrize("turn_deg", [95, 185, 275])
def test_a_board_seen_upside_down_is_numbered_alike(turn_deg: float) -> None:
    T = camera_pose(10, 40, turn_deg, 260)
    found = detect_board(picture(T, Look(laser=False)), BOARD)
    assert len(found) == 42
    assert np.abs(found.uv_px - pixels(BOARD, T)[found.number]).max() < 0.1


def test_noise_is_in_the_covariance() -> None:
    looks = (Look(laser=False, noise=3.0), Look(laser=False, noise=9.0))
    sd, off = [], []
    for look in looks:
        found = detect_board(picture(POSES[1], look), BOARD)
        sd.append(np.sqrt(np.mean(found.covariance_px2[:, [0, 1], [0, 1]])))
        residuals = found.uv_px - pixels(BOARD, POSES[1])[found.number]
        off.append(np.sqrt(np.mean(residuals**2)))
    assert sd[1] == pytest.approx(3 * sd[0], rel=0.2)
    assert off[1] == pytest.approx(sd[1], rel=0.5)


def test_dim_and_blurred_boards_are_found() -> None:
    look = Look(laser=False, dark=4.0, bright=14.0, blur_px=2.5)
    found = detect_board(picture(POSES[3], look), BOARD)
    assert len(found) >= 40
    assert np.abs(found.uv_px - pixels(BOARD, POSES[3])[found.number]).max() < 0.5


def test_a_board_that_reads_alike_both_ways_says_so() -> None:
    square = Chessboard("square", "", (5, 5), 10.0, 0.01)
    T = camera_pose(10, 30, 5, 240)
    found = detect_board(picture(T, Look(laser=False, board=square)), square)
    ways = (found.number, *found.other_numbers)
    assert len(ways) == 2
    assert any(np.abs(found.uv_px - pixels(square, T)[way]).max() < 0.1 for way in ways)


@pytest.mark.parametrize(
    ("board", "code", "fault"),
    [
        (replace(BOARD, inner_corners=(6, 5)), "another-board", "object"),
        (replace(BOARD, inner_corners=(9, 6)), "another-board", "object"),
    ],
)
def test_another_board_is_refused_and_marked(board: Chessboard, code: str, fault: str) -> None:
    with pytest.raises(DetectionError, match=r"7 × 6|6 × 7") as refused:
        detect_board(picture(POSES[1], Look(laser=False)), board)
    assert (refused.value.code, refused.value.fault) == (code, fault)
    true = pixels(BOARD, POSES[1])
    ends = np.array([((m.u0, m.v0), (m.u1, m.v1)) for m in refused.value.marks]).reshape(-1, 2)
    assert len(refused.value.marks) == 6 * 6 + 7 * 5  # the lines between all neighbours
    assert np.linalg.norm(ends[:, None] - true, axis=2).min(axis=1).max() < 1.0


def test_a_board_partly_out_of_the_picture_is_refused() -> None:
    T = POSES[1].copy()
    T[0, 3] += 45.0
    with pytest.raises(OperationError) as refused:
        detect_board(picture(T, Look(laser=False)), BOARD)
    assert refused.value.code == "board-partly-seen"


def test_no_board_is_refused() -> None:
    grey = np.random.default_rng(0).normal(90, 3, (512, 640)).astype(np.uint8)
    with pytest.raises(DetectionError) as refused:
        detect_board(grey, BOARD)
    assert refused.value.code == "board-not-found"
    assert refused.value.marks == ()


def test_a_picture_too_dark_or_too_soft_is_at_fault_before_the_framing() -> None:
    dark = picture(POSES[1], Look(laser=False, bright=8.0, dark=5.0, noise=2.0))
    with pytest.raises(DetectionError, match="the picture is dim") as refused:
        detect_board(dark, BOARD)
    assert refused.value.fault == "exposure"
    soft = picture(POSES[1], Look(laser=False, blur_px=20.0))
    with pytest.raises(DetectionError) as refused:
        detect_board(soft, BOARD)
    assert refused.value.fault == "focus"


def test_white_squares_are_no_stripe() -> None:
    image = picture(POSES[2], Look())  # the line is out of this picture
    assert len(drop_faint_stripe(image, extract_stripe(image, "v")).u) == 0
    crossed = picture(CROSSED, Look())
    assert len(drop_faint_stripe(crossed, extract_stripe(crossed, "v")).u) > 300

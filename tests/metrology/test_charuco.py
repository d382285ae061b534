"""ChArUco boards in pictures as OpenCV prints them: where the corners are, which, and refusals."""

from dataclasses import replace

import cv2
import numpy as np
import pytest

from crenel.metrology.adjustment.board.calibrate import calibrate_board
from crenel.metrology.chessboard.board_detection import BoardDetection
from crenel.metrology.chessboard.charuco_board.charuco_grid import charuco_board
from crenel.metrology.chessboard.detect_board import detect_board
from crenel.metrology.chessboard.laser_light import drop_faint_stripe
from crenel.metrology.sensor.camera import project
from crenel.metrology.stripe import extract_stripe
from crenel.metrology.targets.chessboard import DICTIONARIES, Chessboard, Markers, corner_points
from crenel.metrology.transforms import Floats
from tests.metrology.boards import (
    BOARD,
    OFFSET_MM,
    POSES,
    SIZE,
    T_FLANGE_CAM,
    Look,
    camera_pose,
    inputs,
    picture,
)
from tests.metrology.refusals import detection_refusal_of, refusal_of
from tests.metrology.seen_boards import camera_at
from tests.pictures import compressed
from tests.running.usual import usual

pytestmark = pytest.mark.slow

CHARUCO = replace(BOARD, name="marked board", markers=Markers("DICT_4X4_50", 7.5))
EVEN = replace(CHARUCO, inner_corners=(7, 5))
SMALL = replace(CHARUCO, inner_corners=(5, 4))
UNLIT = Look(laser=False, board=CHARUCO)


def off_px(found: BoardDetection, board: Chessboard, T: Floats) -> Floats:
    """(N, 2) from where the truth puts each corner by its number."""
    true = project(camera_at(T), corner_points(board))[found.number]
    return np.asarray(found.uv_px - true)


@pytest.mark.parametrize("pose", usual([4, 1, 6], 1, pytest.mark.soak))
@pytest.mark.parametrize(
    "board",
    [
        CHARUCO,
        EVEN,
        replace(EVEN, markers=Markers("DICT_4X4_50", 7.5, legacy=True)),
        replace(BOARD, inner_corners=(5, 4), markers=Markers("DICT_6X6_250", 9.0), square_mm=12.0),
        replace(BOARD, markers=Markers("DICT_APRILTAG_36h11", 8.0)),
    ],
)
def test_every_corner_is_where_it_is_and_numbered(board: Chessboard, pose: int) -> None:
    found = detect_board(picture(POSES[pose], replace(UNLIT, board=board), pose), board)
    assert len(found) == len(corner_points(board))
    assert not found.other_numbers
    off = off_px(found, board, POSES[pose])
    assert np.abs(off).max() < 0.1
    said = np.sqrt(np.mean(np.trace(found.covariance_px2, axis1=1, axis2=2)) / 2)
    assert np.sqrt(np.mean(off**2)) < 2.5 * said


def test_the_corners_are_better_than_opencvs() -> None:
    image = picture(POSES[1], replace(UNLIT, noise=4.0), 1)
    ours = np.sqrt(np.mean(off_px(detect_board(image, CHARUCO), CHARUCO, POSES[1]) ** 2))
    assert CHARUCO.markers is not None
    detector = cv2.aruco.CharucoDetector(charuco_board(CHARUCO, CHARUCO.markers))
    corners, ids, _, _ = detector.detectBoard(image)
    columns, rows = CHARUCO.inner_corners
    number = (rows - 1 - ids.ravel() // columns) * columns + ids.ravel() % columns
    true = project(camera_at(POSES[1]), corner_points(CHARUCO))[number]
    theirs = np.sqrt(np.mean((corners.reshape(-1, 2) - true) ** 2))
    assert ours < 0.3 * theirs


@pytest.mark.parametrize(("right_mm", "least"), [(35.0, 33), (55.0, 21), (65.0, 15)])
def test_a_board_partly_out_of_the_picture_is_taken(right_mm: float, least: int) -> None:
    T = POSES[1].copy()
    T[0, 3] += right_mm
    found = detect_board(picture(T, UNLIT, 1), CHARUCO)
    assert least <= len(found) < 42
    assert np.abs(off_px(found, CHARUCO, T)).max() < 0.1


def test_a_covered_board_is_taken() -> None:
    image = picture(POSES[1], UNLIT, 1)
    cv2.rectangle(image, (250, 150), (420, 330), 70, -1)
    found = detect_board(image, CHARUCO)
    assert 20 < len(found) < 30
    assert np.abs(off_px(found, CHARUCO, POSES[1])).max() < 0.1


def test_what_shows_one_row_and_one_column_is_taken() -> None:
    """All but two sides of the board is covered."""
    image = picture(POSES[1], UNLIT, 1)
    far = np.array([[14.0, 14.0], [74.0, 14.0], [74.0, 64.0], [14.0, 64.0]])
    cover = project(camera_at(POSES[1]), np.column_stack([far, np.zeros(4)]))
    cv2.fillConvexPoly(image, np.round(cover).astype(np.int32), 70)
    found = detect_board(image, CHARUCO)
    assert len(found) >= 12
    assert np.abs(off_px(found, CHARUCO, POSES[1])).max() < 0.1


def test_a_print_with_white_for_black_is_taken() -> None:
    found = detect_board(255 - picture(POSES[1], UNLIT, 1), CHARUCO)
    assert len(found) == 42
    assert np.abs(off_px(found, CHARUCO, POSES[1])).max() < 0.1


def test_of_two_boards_of_a_set_each_is_found_by_its_ids() -> None:
    second = replace(SMALL, markers=Markers("DICT_4X4_50", 7.5, first_id=15))
    looks = (replace(UNLIT, board=SMALL), replace(UNLIT, board=second))
    image = np.hstack([picture(POSES[k], look, k) for k, look in enumerate(looks)])
    for k, board in enumerate((SMALL, second)):
        found = detect_board(image, board)
        assert len(found) == 20
        found_px = found.uv_px - [k * SIZE[0], 0]
        true_px = project(camera_at(POSES[k]), corner_points(board))[found.number]
        assert np.abs(found_px - true_px).max() < 0.1


@pytest.mark.parametrize(
    ("shown", "words"),
    [
        ([(2, 1)], "1 of 28 markers of marked board were read: fewer than 3"),
        ([(2, 1), (4, 1)], "2 of 28 markers of marked board were read: fewer than 3"),
        ([(0, 1), (2, 1), (4, 1)], "3 of 28 markers of marked board were read: the others are"),
    ],
)
def test_few_markers_say_nothing_of_the_certificate(
    shown: list[tuple[int, int]], words: str
) -> None:
    """All but some squares, by their lower left corner, is covered."""
    image = picture(POSES[0], UNLIT, 1)
    around = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]) * 1.2 - 0.1
    seen = np.zeros_like(image)
    for place in shown:
        at = np.column_stack([10.0 * (around + place), np.zeros(4)])
        quad = np.round(project(camera_at(POSES[0]), at)).astype(np.int32)
        cv2.fillConvexPoly(seen, quad, (1,))
    cover = np.linspace(30, 200, image.shape[1]).astype(np.uint8)
    covered = np.where(seen > 0, image, cover)
    refusal = detection_refusal_of(detect_board, covered, CHARUCO)
    assert refusal.code == "board-partly-seen"
    assert words in refusal.line
    assert "certificate" not in refusal.line


def test_a_plain_boards_certificate_for_a_board_with_markers_is_named() -> None:
    refusal = refusal_of(detect_board, picture(POSES[1], UNLIT, 1), BOARD)
    assert refusal.code == "another-board"
    assert "it is a ChArUco board" in refusal.line


def test_the_lasers_line_takes_its_own_corners_alone() -> None:
    lit = picture(POSES[1], Look(board=CHARUCO), 1)
    stripe = drop_faint_stripe(lit, extract_stripe(lit, "v"))
    assert len(stripe.u) > 300
    found = detect_board(lit, CHARUCO, stripe)
    assert len(found) >= 30
    assert np.abs(off_px(found, CHARUCO, POSES[1])).max() < 0.1


def test_soft_noisy_compressed_and_clipped_pictures_are_taken() -> None:
    plain = picture(POSES[1], UNLIT, 1)
    pictures = (
        picture(POSES[1], replace(UNLIT, blur_px=2.0), 1),
        picture(POSES[1], replace(UNLIT, noise=12.0), 1),
        compressed(plain, 20),
        np.clip(plain.astype(np.float64) * 3, 0, 255).astype(np.uint8),
        plain.astype(np.uint16) * 256,
    )
    for image in pictures:
        found = detect_board(image, CHARUCO)
        assert len(found) >= 38
        assert np.abs(off_px(found, CHARUCO, POSES[1])).max() < 0.3


@pytest.mark.parametrize("strength", usual([0.6, 0.15, 0.3], 1, pytest.mark.soak))
def test_a_wide_angle_lens_is_no_hindrance(strength: float) -> None:
    """A picture bent as by a barrel; the corners lie where the bend puts the true ones."""
    T = camera_pose(15, 40, 5, 170)
    plain = cv2.resize(picture(T, UNLIT, 1), None, fx=2, fy=2, interpolation=cv2.INTER_CUBIC)
    v, u = np.indices(plain.shape, dtype=np.float32)
    middle = (np.array(plain.shape[::-1]) / 2).astype(np.float32)
    x, y = (u - middle[0]) / middle[0], (v - middle[1]) / middle[0]
    bend = 1 + strength * (x * x + y * y)
    across, down = x * bend * middle[0] + middle[0], y * bend * middle[0] + middle[1]
    bent = np.asarray(cv2.remap(plain, across, down, cv2.INTER_CUBIC), np.uint8)
    found = detect_board(bent, CHARUCO)
    assert len(found) >= 36
    at = found.uv_px.astype(np.float32).T
    sources = [cv2.remap(one, at[0], at[1], cv2.INTER_LINEAR).ravel() for one in (across, down)]
    true = 2 * (project(camera_at(T), corner_points(CHARUCO))[found.number] + 0.5) - 0.5
    assert np.abs(np.column_stack(sources) - true).max() < 0.25


@pytest.mark.parametrize(
    ("board", "code", "words"),
    [
        (replace(CHARUCO, inner_corners=(9, 6)), "another-board", "squares_x: 8"),
        (replace(CHARUCO, inner_corners=(5, 6)), "another-board", "squares_x: 8"),
        (replace(CHARUCO, inner_corners=(6, 7)), "another-board", "squares_x: 8 and squares_y: 7"),
        (replace(CHARUCO, inner_corners=(7, 4)), "another-board", "squares_y: 7"),
        (replace(CHARUCO, markers=Markers("DICT_4X4_50", 5.0)), "another-board", "states 5 mm"),
        (
            replace(CHARUCO, markers=Markers("DICT_5X5_50", 7.5)),
            "another-board",
            "state dictionary: DICT_4X4_50",
        ),
        (
            replace(CHARUCO, markers=Markers("DICT_4X4_50", 7.5, first_id=20)),
            "another-board",
            "with the ids 0 to 27 were found: marked board has the ids 20 to 47. If this is the "
            "board, state first_id: 0",
        ),
    ],
)
def test_another_board_is_refused(board: Chessboard, code: str, words: str) -> None:
    refusal = refusal_of(detect_board, picture(POSES[1], UNLIT, 1), board)
    assert refusal.code == code
    assert words in refusal.line


def test_the_other_pattern_is_refused() -> None:
    image = picture(POSES[1], replace(UNLIT, board=EVEN), 1)
    legacy = replace(EVEN, markers=Markers("DICT_4X4_50", 7.5, legacy=True))
    refusal = detection_refusal_of(detect_board, image, legacy)
    assert refusal.code == "another-board"
    assert "state legacy_pattern: false" in refusal.line
    assert len(refusal.marks) > 60  # the outlines of the markers


def test_a_mirrored_picture_and_a_plain_board_are_refused() -> None:
    mirrored = np.ascontiguousarray(picture(POSES[1], UNLIT, 1)[:, ::-1])
    refusal = detection_refusal_of(detect_board, mirrored, CHARUCO)
    assert (refusal.code, refusal.fault) == ("board-mirrored", "camera")
    assert len(refusal.marks) == 4 * 28
    plain = picture(POSES[1], Look(laser=False), 1)
    refusal = detection_refusal_of(detect_board, plain, CHARUCO)
    assert "kind chessboard" in refusal.line
    blurred = picture(POSES[1], replace(UNLIT, blur_px=8.0), 1)
    refusal = detection_refusal_of(detect_board, blurred, CHARUCO)
    assert refusal.fault == "focus"
    assert "blurred" in refusal.line


@pytest.mark.soak
def test_the_calibration_is_that_of_a_chessboard() -> None:
    found = calibrate_board(inputs(Look(board=CHARUCO)))
    assert [pose.number for pose in found.poses if pose.used] == list(range(1, 9))
    assert np.linalg.norm((found.adjustment.state.T_flange_cam - T_FLANGE_CAM)[:3, 3]) < 0.15
    assert abs(found.adjustment.state.plane.offset_mm) == pytest.approx(OFFSET_MM, abs=0.1)


def test_the_dictionaries_are_opencvs() -> None:
    for name, count in DICTIONARIES.items():
        made = cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, name))
        assert len(made.bytesList) == count

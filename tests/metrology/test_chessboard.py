"""The chessboard's corners in rendered pictures: where, which, how sure; one of two; refusals."""

import re
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from crenel.metrology.adjustment.board.observations import intersect_surface
from crenel.metrology.adjustment.board.surface import board_prior
from crenel.metrology.chessboard.detect_board import detect_board
from crenel.metrology.chessboard.laser_light import drop_faint_stripe
from crenel.metrology.chessboard.lit_line import detect_lit_board
from crenel.metrology.sensor.camera import project
from crenel.metrology.stripe import extract_stripe
from crenel.metrology.targets.chessboard import Chessboard, Markers, corner_points
from crenel.metrology.transforms import Floats, apply
from tests.metrology.boards import BOARD, OFFSET_MM, POSES, SIZE, Look, camera_pose, picture
from tests.metrology.refusals import detection_refusal_of, refusal_of
from tests.metrology.seen_boards import camera_at
from tests.pictures import halve
from tests.running.usual import usual

pytestmark = pytest.mark.slow

CROSSED = POSES[6]
CHARUCO = replace(BOARD, markers=Markers("DICT_4X4_50", 7.5))
FAR = camera_pose(10, 30, 5, 600)
WIDTH = SIZE[0]
OUT = POSES[1].copy()
"""Of a board that ends beyond the right edge of the picture."""
OUT[0, 3] += 45.0


def pixels(board: Chessboard, T_cam_obj: Floats) -> Floats:
    """(N, 2) where every corner truly is seen."""
    return project(camera_at(T_cam_obj), corner_points(board))


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


@pytest.mark.parametrize("about_deg", usual([80, 0, 45, 100], 1, pytest.mark.soak))
def test_a_strongly_slanted_board_is_found(about_deg: float) -> None:
    """Where it is nearer from corner to corner across squares than along their sides."""
    T = camera_pose(75, about_deg, 5, 240)
    found = detect_board(picture(T, Look(laser=False)), BOARD)
    assert len(found) > 36
    assert np.abs(found.uv_px - pixels(BOARD, T)[found.number]).max() < 0.3


@pytest.mark.parametrize(
    ("tilt_deg", "about_deg"),
    usual([(82, 80), (82, 0), (80, 45), (82, 142), (84, 92)], 1, pytest.mark.soak),
)
def test_a_board_that_is_too_slanted_is_to_be_tilted_less(
    tilt_deg: float, about_deg: float
) -> None:
    steep = picture(camera_pose(tilt_deg, about_deg, 5, 240), Look(laser=False))
    refusal = detection_refusal_of(detect_board, steep, BOARD)
    assert refusal.code == "board-slanted"
    said = re.search(r"a slant of about (\d+)°", refusal.line)
    assert said
    assert float(said[1]) == pytest.approx(tilt_deg, abs=3)


def test_noise_is_in_the_covariance() -> None:
    sd, off = [], []
    for noise in (3.0, 9.0):
        found = detect_board(picture(POSES[1], Look(laser=False, noise=noise)), BOARD)
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


@pytest.mark.parametrize("inner_corners", [(6, 5), (9, 6)])
def test_another_board_is_refused_and_marked(inner_corners: tuple[int, int]) -> None:
    board = replace(BOARD, inner_corners=inner_corners)
    refusal = detection_refusal_of(detect_board, halve(picture(POSES[1], Look(laser=False))), board)
    assert (refusal.code, refusal.fault) == ("another-board", "object")
    columns, rows = inner_corners
    found = f"7 × 6 inner corners was found: rendered board has {columns} × {rows}"
    assert found in refusal.line
    assert "Give the certificate of the board in the picture" in refusal.line
    true = (pixels(BOARD, POSES[1]) + 0.5) / 2 - 0.5
    ends = np.array([((m.u0, m.v0), (m.u1, m.v1)) for m in refusal.marks]).reshape(-1, 2)
    assert len(refusal.marks) == 6 * 6 + 7 * 5  # the lines between all neighbours
    assert np.linalg.norm(ends[:, None] - true, axis=2).min(axis=1).max() < 1.0


def test_no_board_is_refused() -> None:
    grey = np.random.default_rng(0).normal(90, 3, (128, 160)).astype(np.uint8)
    refusal = detection_refusal_of(detect_board, grey, BOARD)
    assert (refusal.code, refusal.marks) == ("board-not-found", ())


def test_white_squares_are_no_stripe() -> None:
    image = picture(POSES[2], Look())  # the line is out of this picture
    assert len(drop_faint_stripe(image, extract_stripe(image, "v")).u) == 0
    crossed = picture(CROSSED, Look())
    assert len(drop_faint_stripe(crossed, extract_stripe(crossed, "v")).u) > 300


@pytest.mark.parametrize(("board", "k", "bright"), [(BOARD, 2, 170.0), (CHARUCO, 4, 140.0)])
def test_a_line_that_is_dimmer_than_the_board_is_found_on_its_squares(
    board: Chessboard, k: int, bright: float
) -> None:
    look = Look(line_level=75.0, bright=bright, offset_mm=OFFSET_MM - 43.0, board=board)
    lit, unlit = picture(POSES[k], look), picture(POSES[k], replace(look, laser=False))
    assert not len(drop_faint_stripe(lit, extract_stripe(lit, "v")).u)
    found, line, _ = detect_lit_board(lit, board, "v")
    off = found.uv_px - pixels(board, POSES[k])[found.number]
    assert 20 <= len(found) < 42
    assert np.abs(off).max() < 0.15
    on = intersect_surface(
        board, camera_at(POSES[k]), board_prior(board).coordinates, line.stripe.uv_px
    )
    away_mm = apply(POSES[k], on) @ look.normal - look.offset_mm
    assert len(on) > 100
    assert np.median(np.abs(away_mm)) < 0.05
    found, line, _ = detect_lit_board(unlit, board, "v")
    assert (len(found), len(line.stripe.u)) == (42, 0)


def beside(board: Chessboard, *poses: NDArray[np.float64]) -> NDArray[np.uint8]:
    """A board at each of the poses, side by side."""
    look = Look(laser=False, board=board)
    return np.hstack([picture(T, look, seed) for seed, T in enumerate(poses)])


def check_refused(image: NDArray[np.uint8], board: Chessboard, words: str) -> None:
    """Whether all or little is tried; boards on either side are drawn."""
    for thorough in (True, False):
        refusal = detection_refusal_of(detect_board, image, board, thorough=thorough)
        assert (refusal.code, refusal.fault) == ("two-boards", "object")
        assert words in refusal.line
        assert "Cover one of them" in refusal.line
        assert {mark.u0 > WIDTH for mark in refusal.marks} == {False, True}


@pytest.mark.parametrize("board", usual([BOARD, CHARUCO], 1, pytest.mark.soak))
def test_two_equal_boards_are_refused_and_drawn(board: Chessboard) -> None:
    check_refused(beside(board, POSES[1], POSES[6]), board, "two boards of 7 × 6")


@pytest.mark.parametrize("board", usual([CHARUCO, BOARD], 1, pytest.mark.soak))
def test_a_board_cut_off_beside_a_whole_one_is_counted(board: Chessboard) -> None:
    cut = beside(board, POSES[1], POSES[2])[:, : WIDTH + WIDTH // 2]
    assert refusal_of(detect_board, cut, board).code == "two-boards"


def test_a_part_of_a_second_board_is_named_and_drawn() -> None:
    check_refused(beside(BOARD, POSES[1], OUT), BOARD, "a part of a second one")


def test_a_part_of_a_board_far_off_or_of_a_larger_one_does_not_count() -> None:
    far = beside(BOARD, POSES[1], FAR)[:, : WIDTH + WIDTH // 2]
    larger = replace(BOARD, inner_corners=(11, 9))
    look = Look(laser=False)
    tiles = np.hstack([picture(POSES[1], look), picture(OUT, replace(look, board=larger))])
    smaller = replace(BOARD, inner_corners=(5, 4))
    whole = np.hstack([picture(POSES[1], look), picture(POSES[2], replace(look, board=smaller))])
    for image in (far, tiles, whole):
        found = detect_board(image, BOARD)
        assert len(found) == 42
        assert (found.uv_px[:, 0] < WIDTH).all()


@pytest.mark.parametrize("nearer", [0, 1])
def test_of_a_near_and_a_far_board_the_near_one_is_taken(nearer: int) -> None:
    poses = (POSES[1], FAR) if nearer == 0 else (FAR, POSES[1])
    found = detect_board(beside(BOARD, *poses), BOARD)
    assert len(found) == 42
    assert ((found.uv_px[:, 0] > WIDTH) == (nearer == 1)).all()

"""Two boards of the certificate's size in one picture: refused, unless one is far off."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from app.metrology.chessboard.detect_board import detect_board
from app.metrology.targets.chessboard import Chessboard, Markers
from tests.metrology.boards import BOARD, POSES, SIZE, Look, camera_pose, picture
from tests.metrology.refusals import detection_refusal_of, refusal_of
from tests.running.usual import usual

pytestmark = pytest.mark.slow

CHARUCO = replace(BOARD, markers=Markers("DICT_4X4_50", 7.5))
FAR = camera_pose(10, 30, 5, 600)
WIDTH = SIZE[0]
OUT = POSES[1].copy()
"""Of a board that ends beyond the right edge of the picture."""
OUT[0, 3] += 45.0


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

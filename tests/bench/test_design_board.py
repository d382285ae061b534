"""Boards to print: to scale on paper, as OpenCV prints them, and found in pictures of it."""

import cv2
import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.metrology.design.board_pattern import board_pattern, scale_board
from crenel.workflows.design.board_files import plan_board
from tests.bench.design_board import (
    is_found,
    length_errors_mm,
    random_board,
    rasterise,
    take_picture,
)

LIMIT_MM = 0.05


@pytest.mark.parametrize("squares", [(8, 7), (7, 6)])
def test_a_charuco_board_is_that_of_opencv(squares: tuple[int, int]) -> None:
    board = plan_board("B", squares, 12.0, True)
    assert board.markers is not None
    dictionary = cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, board.markers.dictionary))
    theirs = cv2.aruco.CharucoBoard(squares, 12.0, 9.0, dictionary)
    px = 4  # a cell of a marker, 1.5 mm, has six pixels
    size = (12 * px * squares[0], 12 * px * squares[1])
    expected = theirs.generateImage(size, marginSize=0)
    pattern = board_pattern(board)
    own = np.full(size[::-1], 255, np.uint8)
    for rectangles, level in ((pattern.black, 0), *((cells, 255) for cells in pattern.white)):
        for left, bottom, right, top in np.round(rectangles * px).astype(int):
            own[size[1] - top : size[1] - bottom, left:right] = level
    assert np.mean(own != expected) < 0.002


@pytest.mark.slow
@pytest.mark.parametrize("seed", [20, 21, 22, 23])
def test_a_board_is_printed_to_scale_and_found(seed: int) -> None:
    rng = np.random.default_rng(seed)
    board = random_board(rng)
    page = rasterise(board)
    errors = length_errors_mm(board, page)
    assert max(abs(error) for error in errors.values()) < LIMIT_MM, errors
    assert is_found(board, *take_picture(board, page, rng))


def test_two_measured_lengths_scale_the_board() -> None:
    board = plan_board("B", (11, 8), 20.0, True)
    printed = scale_board(board, (219.56, 159.84), 0.1)
    assert printed.square_mm == pytest.approx(20.0 * (0.998 + 0.999) / 2)
    assert printed.markers is not None
    assert printed.markers.side_mm / printed.square_mm == pytest.approx(0.75)
    # half of what the scales differ by, over 180 mm between the outermost corners
    assert printed.standard_uncertainty_mm == pytest.approx(np.hypot(0.1, 0.0005 * 180.0))
    with pytest.raises(OperationError) as refusal:
        scale_board(board, (180.0, 160.0), 0.1)
    assert refusal.value.code == "board-scale"

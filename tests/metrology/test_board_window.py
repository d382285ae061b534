"""Which corners of a grid belong to a board of known size."""

import numpy as np
import pytest
from numpy.typing import NDArray

from app.metrology.chessboard.window import find_window


def grid(columns: int, rows: int) -> NDArray[np.int64]:
    return np.array([(i, j) for j in range(rows) for i in range(columns)])


def test_a_whole_board_is_found_whichever_way_it_lies() -> None:
    for places in (grid(9, 6), grid(6, 9)):
        within = find_window(places + np.array([-3, 7]), (9, 6))
        assert within is not None
        assert within.all()


def test_corners_of_an_outline_are_left_out() -> None:
    beside = np.array([[9, 1], [-1, 4], [3, -1]])
    within = find_window(np.concatenate([grid(9, 6), beside]), (9, 6))
    assert within is not None
    assert within.tolist() == [True] * 54 + [False] * 3


@pytest.mark.parametrize("size", [(8, 6), (9, 5), (7, 6), (10, 6), (9, 7)])
def test_a_board_of_another_size_has_no_window(size: tuple[int, int]) -> None:
    assert find_window(grid(9, 6), size) is None


def test_a_side_that_is_hardly_seen_decides_nothing_where_corners_lie_beyond_the_other() -> None:
    places = grid(10, 6)
    column = places[:, 0]
    first_hidden = places[(column > 0) | (places[:, 1] < 2)]
    assert find_window(first_hidden, (9, 6)) is None


def test_covered_corners_are_no_hindrance() -> None:
    places = grid(9, 6)
    seen = places[(places[:, 0] < 3) | (places[:, 0] > 5)]
    within = find_window(seen, (9, 6))
    assert within is not None
    assert within.all()


def test_nothing_is_no_board() -> None:
    assert find_window(np.zeros((0, 2), dtype=np.int64), (9, 6)) is None

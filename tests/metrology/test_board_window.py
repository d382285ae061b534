"""What belongs to a board: corners of a grid by its size, and the straight piece of a line."""

import numpy as np
import pytest
from numpy.typing import NDArray

from crenel.metrology.adjustment.board.straight_line import mask_straight_piece
from crenel.metrology.chessboard.window import find_window
from crenel.metrology.transforms import Floats
from tests.present import present


def grid(columns: int, rows: int) -> NDArray[np.int64]:
    return np.array([(i, j) for j in range(rows) for i in range(columns)])


def test_a_whole_board_is_found_whichever_way_it_lies() -> None:
    for places in (grid(9, 6), grid(6, 9)):
        within = present(find_window(places + np.array([-3, 7]), (9, 6)))
        assert within.all()


def test_corners_of_an_outline_are_left_out() -> None:
    beside = np.array([[9, 1], [-1, 4], [3, -1]])
    within = present(find_window(np.concatenate([grid(9, 6), beside]), (9, 6)))
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
    within = present(find_window(seen, (9, 6)))
    assert within.all()


def test_nothing_is_no_board() -> None:
    assert find_window(np.zeros((0, 2), dtype=np.int64), (9, 6)) is None


def points_on_line(start: Floats, end: Floats, count: int, seed: int = 0) -> Floats:
    share = np.linspace(0, 1, count)[:, None]
    noise = np.random.default_rng(seed).normal(0, 0.005, (count, 3))
    return np.asarray(start + share * (end - start) + noise)


@pytest.mark.parametrize("share", [0.1, 0.3, 0.45])
def test_pieces_beside_the_line_are_no_part_of_it(share: float) -> None:
    count = 1000
    on_board = points_on_line(np.array([0.0, 10, 0]), np.array([30.0, 12, 0]), count)
    beside = round(count * share / (1 - share))
    on_table = points_on_line(np.array([-6.0, 3, 0]), np.array([-1.0, 3.3, 0]), beside)
    found = mask_straight_piece(np.concatenate([on_table, on_board]), 0.5)
    assert not found[:beside].any()
    assert found[beside:].all()


def test_points_nearer_than_the_least_distance_always_belong_to_it() -> None:
    line = points_on_line(np.zeros(3), np.array([30.0, 0, 0]), 200)
    bent = line + np.array([0, 0, 0.4]) * (np.linspace(-1, 1, 200)[:, None] ** 2)
    assert mask_straight_piece(bent, 0.5).all()


@pytest.mark.parametrize("count", [0, 1, 2])
def test_hardly_any_points_are_a_line(count: int) -> None:
    assert mask_straight_piece(np.zeros((count, 3)), 0.5).sum() in (0, count)

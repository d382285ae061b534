"""The straight piece of a laser line beside pieces of it that a table shows."""

import numpy as np
import pytest

from app.metrology.adjustment.board.straight_line import mask_straight_piece
from app.metrology.transforms import Floats


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

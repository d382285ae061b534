"""What the speed of a pass does to the points."""

import numpy as np
import pytest

from app.metrology.sensor.motion_blur import PassSpeed, pass_speed
from app.metrology.transforms import Floats, rigid, rotation_from_vector

LINE = np.column_stack([np.linspace(-10, 10, 101), np.zeros(101), np.full(101, 150.0)])


def speed_to(after: Floats) -> PassSpeed:
    found = pass_speed(LINE, np.eye(4), after, 0.01, 0.004, 0.04)
    assert found is not None
    return found


def test_a_pass_across_the_line_blurs_and_spaces() -> None:
    found = speed_to(rigid(np.eye(3), np.array([0.0, 1.0, 0.0])))
    assert found.blur_mm == pytest.approx(100 * 0.004)
    assert found.step_mm == pytest.approx(100 * 0.04)
    assert found.spacing_mm == pytest.approx(0.2)
    assert found.limit_mm(0.01) == pytest.approx(0.8)
    assert found.limit_mm(0.2) == pytest.approx(2.0)


def test_along_the_line_it_blurs_but_does_not_move_on() -> None:
    found = speed_to(rigid(np.eye(3), np.array([1.0, 0.0, 0.0])))
    assert found.blur_mm == pytest.approx(0.4)
    assert found.step_mm == pytest.approx(0.0, abs=1e-9)


def test_a_turn_moves_what_is_far() -> None:
    found = speed_to(rigid(rotation_from_vector(np.array([0.01, 0.0, 0.0])), np.zeros(3)))
    assert found.blur_mm == pytest.approx(150 * 0.004, rel=0.01)


def test_without_a_line_no_speed_is_estimated() -> None:
    for few in (LINE[:1], np.full((9, 3), np.nan), np.zeros((5, 3))):
        assert pass_speed(few, np.eye(4), np.eye(4), 0.01, 0.004, 0.04) is None

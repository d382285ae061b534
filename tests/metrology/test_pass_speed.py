"""What the speed of a pass does to the points, and what becomes of a line that stands still."""

from typing import Literal

import numpy as np
import pytest

from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.line_thinning import LINES_AT_A_PLACE, LineThinning
from crenel.metrology.sensor.motion_blur import PassSpeed, pass_speed
from crenel.metrology.transforms import Floats, rigid, rotation_from_vector

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


def moved_by(steps_mm: Floats, axis: int, noise_mm: float = 0.0) -> Floats:
    """Poses (F, 4, 4) that far along an axis."""
    poses = np.tile(np.eye(4), (len(steps_mm), 1, 1))
    poses[:, axis, 3] = steps_mm
    poses[:, :3, 3] += np.random.default_rng(3).normal(0, noise_mm, (len(poses), 3))
    return poses


SPACING_MM = 0.1
"""Of neighbouring points on the line at 100 mm, by a focal length of 1,000 px."""
STILL, TWO = np.zeros(400), np.repeat([0.0, 40.0], 200)
STEPS = np.arange(400.0)


@pytest.mark.parametrize(
    ("poses", "most"),
    [
        (moved_by(STILL, 0), 10),
        (moved_by(STILL, 0, 0.01), 10),
        (moved_by(TWO, 1, 0.01), 20),
        (moved_by(STEPS * SPACING_MM / 100, 1), 10 * 4),
        (moved_by(STEPS * SPACING_MM / 9, 1), 400),
        (moved_by(STEPS * SPACING_MM * 3, 0), 400),
        (moved_by(np.sin(STEPS), 2), 400),
        (np.full((400, 4, 4), np.nan), 400),
    ],
)
@pytest.mark.parametrize("axis", ["u", "v"])
def test_only_a_line_at_rest_is_thinned(poses: Floats, most: int, axis: Literal["u", "v"]) -> None:
    """However its frames come in blocks; frames without a line do not count."""
    matrix = np.array([[1000.0, 0, 320], [0, 1000, 256], [0, 0, 1]])
    camera = Camera(matrix, np.eye(3), np.array([0.0, 0.0, 100.0]), 640, 512)
    plane = LaserPlane(np.array([0.0, 0.0, 1.0]), 0.0)
    whole = LineThinning(camera, plane, axis).keep(poses, np.ones(400, dtype=np.bool_))
    assert whole.sum() == most
    assert whole[:LINES_AT_A_PLACE].all()
    blocks, has_line = LineThinning(camera, plane, axis), np.arange(400) % 4 > 0
    kept = [blocks.keep(poses[i : i + 7], has_line[i : i + 7]) for i in range(0, 400, 7)]
    assert np.concatenate(kept)[~has_line].all()
    assert np.concatenate(kept)[has_line].sum() <= most
    assert blocks.is_still == (not whole[-1])

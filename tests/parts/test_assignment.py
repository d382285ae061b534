"""Which points of a scan are a feature's, where others meet it."""

import numpy as np
import pytest

from crenel.metrology.transforms import Floats, rigid
from crenel.parts.maths.assignment import EDGE_MM, Face, assign_points
from crenel.parts.maths.shapes import Shape

ABOVE = np.array([0.0, 0.0, 1.0])
RADIUS_MM, HEIGHT_MM = 8.0, 10.0
"""Of a boss that stands on a plate, and of a bore from its top; and their height and depth."""
REACH_MM = 20.0


def plane(z_mm: float) -> Face:
    T = rigid(np.eye(3), np.array([0.0, 0.0, z_mm]))
    return Face(Shape("plane", T, np.empty(0)), False)


def cylinder(is_internal: bool, low_mm: float, high_mm: float) -> Face:
    shape = Shape("cylinder", np.eye(4), np.array([RADIUS_MM]))
    return Face(shape, is_internal, (low_mm, high_mm))


def kept(face: Face, other: Face, points: Floats) -> Floats:
    """Distances from the z axis of the points that belong to a face, seen from above."""
    sights = np.tile(ABOVE, (len(points), 1))
    taken = assign_points(face, (other,), points, sights)
    assert len(taken.kept) + taken.edge == len(points)
    return np.asarray(np.hypot(*points[taken.kept, :2].T))


def disc(z_mm: float) -> Floats:
    """Points all over a square at a height."""
    x, y = np.meshgrid(*2 * [np.linspace(-REACH_MM, REACH_MM, 81)])
    return np.column_stack([x.ravel(), y.ravel(), np.full(x.size, z_mm)])


BOSS, BORE = cylinder(False, 1, HEIGHT_MM - 1), cylinder(True, 1 - HEIGHT_MM, -1)


@pytest.mark.parametrize(
    ("z_mm", "other"), [(HEIGHT_MM, BOSS), (-HEIGHT_MM, BORE)], ids=["top", "floor"]
)
def test_the_top_of_a_boss_and_the_floor_of_a_bore_keep_what_is_within(
    z_mm: float, other: Face
) -> None:
    radial = kept(plane(z_mm), other, disc(z_mm))
    assert radial.min() < 0.5
    assert RADIUS_MM - EDGE_MM - 0.5 < radial.max() < RADIUS_MM - EDGE_MM


@pytest.mark.parametrize("other", [BOSS, BORE], ids=["boss", "bore"])
def test_the_plate_keeps_what_is_around(other: Face) -> None:
    radial = kept(plane(0.0), other, disc(0.0))
    assert RADIUS_MM + EDGE_MM < radial.min() < RADIUS_MM + EDGE_MM + 0.5
    assert radial.max() > REACH_MM


def test_a_ball_and_the_plate_under_it_keep_off_each_other() -> None:
    ball = Face(Shape("sphere", np.eye(4), np.array([RADIUS_MM])), False)
    foot = kept(plane(0.0), ball, disc(0.0))
    assert not np.any(np.abs(foot - RADIUS_MM) <= EDGE_MM)
    points = disc(0.0)
    on_ball = points[np.hypot(*points[:, :2].T) < RADIUS_MM]
    on_ball[:, 2] = np.sqrt(RADIUS_MM**2 - np.sum(on_ball[:, :2] ** 2, axis=1))
    sights = np.tile(ABOVE, (len(on_ball), 1))
    taken = assign_points(ball, (plane(0.0),), on_ball, sights)
    assert on_ball[taken.kept, 2].min() > EDGE_MM

"""Where about a part lies in a scan that shows little of what tells its places apart."""

import numpy as np
import pytest

from crenel.metrology.transforms import Floats, inverse, rigid, rotation_from_vector
from crenel.parts.maths.assignment import Face
from crenel.parts.maths.rough_alignment import align_to_scan
from crenel.parts.maths.shapes import Shape, frame_along

SIZE_MM = np.array([100.0, 70.0, 20.0])
BORE_MM, BORE_RADIUS_MM, BORE_DEPTH_MM = (22.0, 18.0), 3.0, 8.0


def plane(point_mm: tuple[float, ...], normal: tuple[float, ...], *box: tuple[float, ...]) -> Face:
    T = frame_along(np.array(normal, dtype=float), np.array(point_mm, dtype=float))
    return Face(Shape("plane", T, np.empty(0)), False, None, (np.array(box, dtype=float),))


def plate() -> list[Face]:
    """Top and two sides of a plate, and a small bore that alone says how it lies."""
    bore = frame_along(np.array([0.0, 0.0, 1.0]), np.array([*BORE_MM, SIZE_MM[2]]))
    return [
        plane((50, 35, 20), (0, 0, 1), (1, 1, 19), (99, 69, 21)),
        plane((50, 0, 10), (0, -1, 0), (2, -1, 2), (98, 1, 18)),
        plane((0, 35, 10), (-1, 0, 0), (-1, 2, 2), (1, 68, 18)),
        Face(Shape("cylinder", bore, np.array([BORE_RADIUS_MM])), True, (-BORE_DEPTH_MM, -0.5)),
    ]


def scan_of_plate(rng: np.random.Generator) -> Floats:
    """Points all over the top, all four sides and the wall of the bore, part frame."""
    x = rng.uniform(0, SIZE_MM, (40_000, 3))
    face = rng.integers(0, 5, len(x))
    x[face == 0, 2] = SIZE_MM[2]
    for number, (axis, at) in enumerate(((0, 0.0), (0, 100.0), (1, 0.0), (1, 70.0)), 1):
        x[face == number, axis] = at
    around, down = rng.uniform(0, 2 * np.pi, 400), rng.uniform(0, BORE_DEPTH_MM, 400)
    wall = BORE_RADIUS_MM * np.column_stack([np.cos(around), np.sin(around)]) + BORE_MM
    is_open = np.hypot(*(x[:, :2] - BORE_MM).T) < BORE_RADIUS_MM
    points = np.vstack([x[~is_open], np.column_stack([wall, SIZE_MM[2] - down])])
    return np.asarray(points + rng.normal(0, 0.01, points.shape))


@pytest.mark.parametrize("seed", range(4))
def test_a_small_bore_tells_two_places_of_a_plate_apart(seed: int) -> None:
    rng = np.random.default_rng(seed)
    R = rotation_from_vector(rng.uniform(-3, 3, 3))
    T_arm_part = rigid(R, rng.uniform(-500, 500, 3))
    points = scan_of_plate(rng) @ R.T + T_arm_part[:3, 3]
    T, off_mm = align_to_scan(plate(), points)
    corners = np.array([[0, 0, 20], [100, 70, 20], [100, 0, 0]], dtype=float)
    change = inverse(T_arm_part) @ T
    moved = corners @ change[:3, :3].T + change[:3, 3] - corners
    assert np.abs(moved).max() < 1.0
    assert off_mm < 1.0

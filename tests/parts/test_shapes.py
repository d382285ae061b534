"""Ideal features: derivatives, and fits to exact points from partial arcs and far origins."""

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.metrology.adjustment.core.arm_errors import FlangeMotion
from crenel.metrology.transforms import Floats, rigid, rotation_from_vector
from crenel.parts.maths.feature_fit import FeaturePoints, adjust_shape, fit_feature
from crenel.parts.maths.point_errors import TouchErrors
from crenel.parts.maths.shapes import KINDS, Kind, Shape, cells_of, surface_coordinates

SIZES: dict[Kind, tuple[float, ...]] = {
    "plane": (),
    "circle": (7.0,),
    "cylinder": (7.0,),
    "cone": (6.0, 0.6),
    "sphere": (9.0,),
    "torus": (20.0, 4.0),
    "slot": (5.0, 12.0),
}
PLACES = [0.0, 2_000.0]


def place(rng: np.random.Generator, far_mm: float) -> Floats:
    return rigid(rotation_from_vector(rng.normal(0, 0.8, 3)), rng.normal(0, 1, 3) * far_mm)


def surface(kind: Kind, count: int, rng: np.random.Generator, arc_rad: float) -> Floats:
    """Points (N, 3) on a feature in its own frame, over an arc."""
    a = rng.uniform(0, arc_rad, count)
    z = rng.uniform(-6, 6, count)
    if kind == "plane":
        return np.column_stack([rng.uniform(-20, 20, (count, 2)), np.zeros(count)])
    if kind in ("circle", "cylinder"):
        r = np.full(count, SIZES[kind][0])
        return np.column_stack([r * np.cos(a), r * np.sin(a), z * (kind == "cylinder")])
    if kind == "cone":
        r = SIZES[kind][0] + z * np.tan(SIZES[kind][1])
        return np.column_stack([r * np.cos(a), r * np.sin(a), z])
    if kind == "sphere":
        b = rng.uniform(-1, 1, count)
        radius = SIZES[kind][0]
        return np.asarray(
            radius * np.column_stack([np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b)])
        )
    if kind == "torus":
        b = rng.uniform(0, 2 * np.pi, count)
        r = SIZES[kind][0] + SIZES[kind][1] * np.cos(b)
        return np.column_stack([r * np.cos(a), r * np.sin(a), SIZES[kind][1] * np.sin(b)])
    width, half = SIZES["slot"]
    straight = rng.random(count) < 0.5
    x = rng.uniform(-half, half, count)
    y = np.where(rng.random(count) < 0.5, width, -width)
    a = rng.uniform(-np.pi / 2, np.pi / 2, count)
    side = np.where(rng.random(count) < 0.5, 1.0, -1.0)
    ends = np.column_stack([side * (half + width * np.cos(a)), width * np.sin(a)])
    flat = np.where(straight[:, None], np.column_stack([x, y]), ends)
    return np.column_stack([flat, z])


def as_touches(points: Floats) -> FeaturePoints:
    count = len(points)
    still = FlangeMotion(
        np.tile(np.eye(4), (count, 1, 1)),
        np.zeros((count, 6, 6)),
        np.zeros((count, 6, 1)),
        np.ones(1),
    )
    errors = TouchErrors(points, np.ones(count), still, np.zeros(1), 0.001)
    return FeaturePoints(errors, np.zeros(count))


@pytest.mark.parametrize("kind", KINDS)
def test_derivatives_are_those_of_distances(kind: Kind) -> None:
    rng = np.random.default_rng(1)
    shape = Shape(kind, place(rng, 30.0), np.array(SIZES[kind]))
    local = surface(kind, 200, rng, 5.0) + rng.normal(0, 0.3, (200, 3))
    points = local @ shape.T[:3, :3].T + shape.origin_mm
    off, normals, J = shape.linearise(points)
    assert np.allclose(off, shape.distances(points))
    assert J.shape == (200, shape.freedom.count)
    assert len(shape.freedom.names) == len(shape.freedom.are_angles) == shape.freedom.count
    for k in range(shape.freedom.count):
        step = np.zeros(shape.freedom.count)
        step[k] = 1e-6
        moved = shape.apply_step(step).distances(points) - shape.apply_step(-step).distances(points)
        assert np.allclose(J[:, k], moved / 2e-6, atol=2e-6)
    for axis in range(3):
        step = 1e-5 * np.eye(3)[axis]
        moved = shape.distances(points + step) - shape.distances(points - step)
        assert np.allclose(normals[:, axis], moved / 2e-5, atol=1e-5)


@pytest.mark.parametrize("far_mm", PLACES)
@pytest.mark.parametrize("arc_deg", [20.0, 90.0, 360.0])
@pytest.mark.parametrize("kind", KINDS)
def test_a_fit_finds_the_feature_of_exact_points(kind: Kind, arc_deg: float, far_mm: float) -> None:
    rng = np.random.default_rng(2)
    true = Shape(kind, place(rng, far_mm), np.array(SIZES[kind]))
    points = surface(kind, 300, rng, np.radians(arc_deg))
    points = points @ true.T[:3, :3].T + true.origin_mm
    start = true.apply_step(
        rng.normal(0, 1, true.freedom.count) * np.where(true.freedom.are_angles, 0.004, 0.1)
    )
    found = adjust_shape("F", start, as_touches(points), np.ones(len(points)))
    found = found.centre_on(points)
    assert np.abs(found.distances(points)).max() < 1e-9
    again = true.centre_on(points)
    # in 20 degrees of an arc, rounding of coordinates 2 m away moves a radius by more
    within = 1e-9 if far_mm == 0 or arc_deg > 45 else 2e-8
    assert np.allclose(found.sizes, again.sizes, rtol=0, atol=within)
    assert np.allclose(found.direction, again.direction, rtol=0, atol=within)


def test_points_on_too_small_a_piece_are_refused() -> None:
    rng = np.random.default_rng(3)
    shape = Shape("cylinder", np.eye(4), np.array([7.0]))
    line = np.column_stack([np.full(9, 7.0), np.zeros(9), np.linspace(0, 5, 9)])
    with pytest.raises(OperationError) as refused:
        fit_feature("H1", shape, as_touches(line), 0.8)
    assert "H1" in refused.value.line
    two = surface("plane", 2, rng, 1.0)
    with pytest.raises(OperationError):
        fit_feature("A", Shape("plane", np.eye(4), np.zeros(0)), as_touches(two), 0.8)


@pytest.mark.parametrize("kind", ["plane", "cylinder", "slot"])
def test_cells_are_of_equal_area(kind: Kind) -> None:
    rng = np.random.default_rng(4)
    shape = Shape(kind, np.eye(4), np.array(SIZES[kind]))
    points = surface(kind, 60_000, rng, 2 * np.pi)
    cell, count = cells_of(surface_coordinates(shape, points), 1.0)
    assert cell.max() == count - 1
    assert np.bincount(cell).min() > 0
    area = {"plane": 1600.0, "cylinder": 2 * np.pi * 7 * 12, "slot": (2 * np.pi * 5 + 48) * 12}
    assert count == pytest.approx(area[kind], rel=0.1)


def test_a_resting_hand_does_not_pull() -> None:
    """Half of all points in one place weigh no more than that place."""
    rng = np.random.default_rng(5)
    points = surface("plane", 4000, rng, 1.0)
    points[:, 2] = 0.01 * (points[:, 0] > 15)
    resting = np.column_stack([rng.uniform(18, 19, (4000, 2)), np.full(4000, 0.01)])
    shape = Shape("plane", np.eye(4), np.zeros(0))
    cell, _ = cells_of(surface_coordinates(shape, np.concatenate([points, resting])), 0.8)
    weights = 1 / np.bincount(cell)[cell]
    both = adjust_shape("A", shape, as_touches(np.concatenate([points, resting])), weights)
    alone = adjust_shape("A", shape, as_touches(points), np.ones(4000))
    plain = adjust_shape("A", shape, as_touches(np.concatenate([points, resting])), np.ones(8000))
    at = np.zeros((1, 3))
    pulled = abs(plain.distances(at) - alone.distances(at))
    assert abs(both.distances(at) - alone.distances(at)) < 0.2 * pulled
    assert pulled > 5e-4

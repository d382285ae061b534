"""Cylinders, and whether what a fit claims of its parameters holds."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from crenel.errors import OperationError
from crenel.metrology.fitting.cylinder import (
    cylinder_distances,
    cylinder_jacobian,
    fit_cylinder,
    perpendicular_axes,
)
from crenel.metrology.fitting.plane_sphere import PlaneFit
from crenel.metrology.fitting.shape import ShapeName, measure_shape, parameter_covariance
from tests.metrology.numerics import unit
from tests.running.usual import usual
from tests.uncertainty_ratio import ratio_of_pulls

pytestmark = pytest.mark.slow

seeds = st.integers(0, 10**6)
FRAMES = 60


def cylinder_points(
    rng: np.random.Generator, off_mm: np.ndarray, frame: np.ndarray, arc_rad: float = 2.0
) -> tuple[np.ndarray, np.ndarray, np.ndarray, float]:
    """Points on a cylinder that a stripe passed over, frame by frame along the axis."""
    direction = unit(rng.normal(size=3))
    a, b = perpendicular_axes(direction)
    point, radius = rng.uniform(-200, 200, 3), float(rng.uniform(5, 30))
    along = 40 * (frame / FRAMES - 0.5)
    turn = rng.uniform(-arc_rad / 2, arc_rad / 2, len(frame))
    outward = np.outer(np.cos(turn), a) + np.outer(np.sin(turn), b)
    points = point + np.outer(along, direction) + (radius + off_mm)[:, None] * outward
    return points, point, direction, radius


def frames_of(rng: np.random.Generator, count: int) -> np.ndarray:
    return np.sort(rng.integers(0, FRAMES, count))


@settings(max_examples=20, deadline=None)
@given(seeds)
def test_exact_points_give_the_exact_cylinder(seed: int) -> None:
    rng = np.random.default_rng(seed)
    frame = frames_of(rng, 600)
    points, point, direction, radius = cylinder_points(rng, np.zeros(600), frame)
    fit = fit_cylinder(points)
    assert fit.radius_mm == pytest.approx(radius, abs=1e-6)
    assert abs(float(fit.direction @ direction)) == pytest.approx(1, abs=1e-10)
    off_axis = np.cross(fit.point_mm - point, direction)
    assert np.linalg.norm(off_axis) < 1e-6
    assert fit.used.all()


def test_a_third_of_outliers_does_not_move_the_cylinder() -> None:
    rng = np.random.default_rng(2)
    frame = frames_of(rng, 4000)
    points, _, direction, radius = cylinder_points(rng, rng.normal(0, 0.01, 4000), frame)
    outliers = points.mean(axis=0) + rng.uniform(-40, 40, (2000, 3))
    fit = fit_cylinder(np.concatenate([points, outliers, [[np.nan] * 3]]))
    assert fit.radius_mm == pytest.approx(radius, abs=0.005)
    assert abs(float(fit.direction @ direction)) > 1 - 1e-7
    assert not fit.used[-1]
    assert fit.rms_mm == pytest.approx(0.01, rel=0.15)


def test_the_jacobian_is_the_change_of_the_distances() -> None:
    rng = np.random.default_rng(4)
    off, frame = rng.normal(0, 1, 50), frames_of(rng, 50)
    points, point, direction, radius = cylinder_points(rng, off, frame)
    a, b = perpendicular_axes(direction)
    J = cylinder_jacobian(points, np.concatenate([point, direction]))
    step = 1e-6
    moved = [
        (point + step * a, direction, radius),
        (point + step * b, direction, radius),
        (point, direction + step * a, radius),
        (point, direction + step * b, radius),
        (point, direction, radius + step),
    ]
    before = cylinder_distances(points, (np.concatenate([point, direction]), radius))
    for column, (p, d, r) in zip(J.T, moved, strict=True):
        axis = np.concatenate([p, d / np.linalg.norm(d)])
        after = cylinder_distances(points, (axis, r))
        np.testing.assert_allclose((after - before) / step, column, atol=1e-4)


def test_what_is_no_cylinder_is_refused() -> None:
    rng = np.random.default_rng(3)
    flat = np.column_stack([rng.uniform(-20, 20, (500, 2)), np.zeros(500)])
    with pytest.raises(OperationError, match="do not determine a cylinder"):
        fit_cylinder(flat)
    with pytest.raises(OperationError, match="at least 5"):
        fit_cylinder(flat[:4])


@pytest.mark.parametrize(
    ("shape", "parameter"),
    usual([("plane", 0), ("sphere", 3), ("cylinder", 4)], 2, pytest.mark.soak),
)
def test_claims_hold_where_points_of_a_frame_err_alike(shape: ShapeName, parameter: int) -> None:
    """The error over the claim is about one; taken for independent the points claim a tenth."""
    scores = []
    for seed in range(60):
        rng = np.random.default_rng(seed)
        frame = frames_of(rng, 3000)
        off = rng.normal(0, 0.01, 3000) + rng.normal(0, 0.02, FRAMES)[frame]
        if shape == "plane":
            points = np.column_stack([rng.uniform(-20, 20, 3000), frame * 0.7, off])
            true = 0.0
        elif shape == "sphere":
            turns = np.column_stack([rng.uniform(-0.9, 0.9, 3000), 1.8 * (frame / FRAMES - 0.5)])
            outward = unit(np.column_stack([np.sin(turns), np.ones(3000)]))
            points, true = outward * (12 + off)[:, None], 12.0
        else:
            points, _, _, true = cylinder_points(rng, off, frame)
        measured = measure_shape(shape, points, frame)
        assert measured.covariance is not None
        fit = measured.fit
        found = float(fit.centre_mm[2]) if isinstance(fit, PlaneFit) else fit.radius_mm
        scores.append((found - true) / np.sqrt(measured.covariance[parameter, parameter]))
    ratio_of_pulls(np.array(scores)).assert_within(k=2)


def test_few_frames_give_no_uncertainty() -> None:
    rng = np.random.default_rng(1)
    J, off = rng.normal(size=(500, 3)), rng.normal(size=500)
    assert parameter_covariance(J, off, rng.integers(0, 5, 500)) is None
    assert parameter_covariance(J, off, np.arange(500) // 10) is not None


def test_a_plane_reads_the_same_however_its_points_lie() -> None:
    rng = np.random.default_rng(5)
    points = np.column_stack([rng.uniform(-20, 20, (400, 2)), np.full(400, -3.0)])
    for turned in (points, points[::-1] * [1, -1, 1]):
        measured = measure_shape("plane", turned, np.arange(400))
        assert isinstance(measured.fit, PlaneFit)
        assert measured.fit.normal[2] == pytest.approx(1)
        np.testing.assert_allclose(measured.distances(np.array([[0, 0, -2.0]])), [1.0])

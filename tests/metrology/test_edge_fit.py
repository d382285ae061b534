"""The camera fitted to edges: what moves it is what the formulas say."""

import numpy as np
from numpy.testing import assert_allclose

from app.metrology.detection.edges.camera_from_edges import (
    WITH_K2,
    apply_camera_step,
    fit_edges,
    residuals,
    residuals_with_jacobian,
)
from app.metrology.sensor.camera import Camera, project
from app.metrology.transforms import Floats, rotation_from_vector
from tests.metrology.numerics import differences


def _camera() -> Camera:
    K = np.array([[1900.0, 0.3, 650.0], [0.0, 1904.0, 500.0], [0.0, 0.0, 1.0]])
    distortion = np.array([-0.08, 0.05, 1e-3, -2e-3, 0.01])
    R = rotation_from_vector(np.array([0.5, -0.2, 0.1]))
    return Camera(K, R, np.array([3.0, -8.0, 210.0]), 1280, 1024, distortion)


def _points(rng: np.random.Generator) -> tuple[Floats, Floats]:
    angle = rng.uniform(0, 2 * np.pi, 200)
    points = rng.uniform(-1, 1, (200, 3)) * [45.0, 25.0, 12.0]
    return points, np.column_stack([np.cos(angle), np.sin(angle)])


def test_derivatives_are_those_of_small_steps() -> None:
    camera = _camera()
    points, normal = _points(np.random.default_rng(5))
    uv = project(camera, points) + 0.7
    off, J = residuals_with_jacobian(camera, points, uv, normal)
    assert_allclose(off, residuals(camera, points, uv, normal), atol=1e-10)
    slopes = differences(
        lambda step: residuals(apply_camera_step(camera, step), points, uv, normal), [1e-6] * 12
    )
    for by, slope in zip(J.T, slopes.T, strict=True):
        assert_allclose(by, slope, atol=2e-6 * np.abs(by).max())


def test_fit_returns_to_the_camera_that_drew_the_edges() -> None:
    camera = _camera()
    points, normal = _points(np.random.default_rng(6))
    uv = project(camera, points)
    step = np.array([0.01, 0, 2e-3, -1e-3, 0.01, -0.01, 0.005, 0.01, 0, -0.01, 0, 0])
    start = apply_camera_step(camera, step)
    found, covariance = fit_edges(start, points, uv, normal, np.full(200, 0.01), WITH_K2, rounds=15)
    assert (np.diag(covariance) > 0).all()
    assert_allclose(project(found, points), uv, atol=2e-3)

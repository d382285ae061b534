"""Sub-pixel edges against steps whose place is known, and the camera that is fitted to edges."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from numpy.typing import NDArray
from scipy.special import erf

from crenel.metrology.detection.edges.camera_from_edges import (
    WITH_K2,
    apply_camera_step,
    fit_edges,
    residuals,
    residuals_with_jacobian,
)
from crenel.metrology.detection.edges.scatter import estimate_scatter
from crenel.metrology.detection.edges.stations import EdgeStations
from crenel.metrology.detection.edges.step_fit import measure_steps
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.transforms import Floats, rotation_from_vector
from tests.metrology.numerics import differences
from tests.uncertainty_ratio import EXACT, ratio_of_pulls

SIDE = 160
# The pixels' own width blurs a lens blur of 0.8 px to this.
BLUR = float(np.hypot(0.8, np.sqrt(1 / 12)))


def picture(
    angle: float,
    offset: float,
    blur: float,
    slopes: tuple[float, float] = (0.0, 0.0),
    noise: float = 0.0,
    seed: int = 0,
) -> Floats:
    """A step from 40 to 120 across a line through the middle, each pixel the mean over itself."""
    fine = (np.arange(SIDE * 5) + 0.5) / 5 - 0.5
    u, v = np.meshgrid(fine - SIDE / 2, fine - SIDE / 2)
    x = u * np.cos(angle) + v * np.sin(angle) - offset
    share = 0.5 * (1 + erf(x / (np.sqrt(2) * blur)))
    bend = x * share + blur / np.sqrt(2 * np.pi) * np.exp(-0.5 * (x / blur) ** 2)
    light = 40 + 80 * share + slopes[0] * x + (slopes[1] - slopes[0]) * bend
    grey = light.reshape(SIDE, 5, SIDE, 5).mean(axis=(1, 3))
    return np.asarray(grey + np.random.default_rng(seed).normal(0, noise, grey.shape))


def stations(angle: float, count: int = 20) -> EdgeStations:
    normal = np.array([np.cos(angle), np.sin(angle)])
    along = np.array([-normal[1], normal[0]])
    s = np.linspace(-45, 45, count)[:, None]
    zeros: NDArray[np.int64] = np.zeros(count, dtype=np.int64)
    uv, normals = SIDE / 2 + s * along, np.tile(normal, (count, 1))
    clearance, length = np.full((count, 2), np.inf), np.full(count, 5.0)
    three, whole = np.zeros((count, 3)), np.zeros((1, 2), dtype=np.int64)
    return EdgeStations(zeros, zeros, three, uv, normals, clearance, length, whole, 2.5)


@pytest.mark.parametrize("angle", [0.0, 0.013, 0.4, np.pi / 4, 1.56, 3.0])
@pytest.mark.parametrize("offset", [-0.47, 0.0, 0.31, 0.9])
def test_no_bias_however_the_edge_lies(angle: float, offset: float) -> None:
    seen = measure_steps(picture(angle, offset, 0.8), stations(angle), BLUR)
    assert np.abs(seen.offset_px.mean() - offset) < 0.004
    assert np.abs(seen.offset_px - offset).max() < 0.02


def test_no_bias_from_shading_on_one_side() -> None:
    seen = measure_steps(picture(0.3, 0.2, 0.8, slopes=(0.0, 4.0)), stations(0.3), BLUR)
    assert np.abs(seen.offset_px.mean() - 0.2) < 0.01


def test_the_blur_is_found() -> None:
    seen = measure_steps(picture(0.3, 0.1, 1.7), stations(0.3), 1.3, free_blur=True)
    assert np.median(seen.blur_px) == pytest.approx(np.hypot(1.7, np.sqrt(1 / 12)), rel=0.02)


def test_deviations_are_those_of_the_scatter() -> None:
    z = []
    for seed in range(12):
        seen = measure_steps(picture(0.3, 0.2, 0.8, noise=4.0, seed=seed), stations(0.3), BLUR)
        z.append((seen.offset_px - 0.2) / seen.sigma_px)
    ratio_of_pulls(np.concatenate(z)).assert_within(*EXACT, k=2)


def test_the_step_has_the_sign_of_the_normal() -> None:
    up, down = stations(0.0), stations(np.pi)
    image = picture(0.0, 0.0, 0.8)
    assert np.median(measure_steps(image, up, BLUR).step) == pytest.approx(80, abs=1)
    assert np.median(measure_steps(image, down, BLUR).step) == pytest.approx(-80, abs=1)


def test_hidden_pixels_give_no_edge() -> None:
    image = picture(0.0, 0.0, 0.8)
    image[60:100] = np.nan
    seen = measure_steps(image, stations(0.0), BLUR)
    hidden = np.abs(stations(0.0).uv_px[:, 1] - 80) < 15
    assert np.isnan(seen.offset_px[hidden]).all()
    assert np.isfinite(seen.offset_px[~hidden]).any()


PARTS, POINTS, SIGMA_PX = 40, 30, 0.02


@pytest.mark.parametrize(
    ("moved_px", "certificate_px", "least", "most"),
    [(0.0, 0.0, 1.0, 1.3), (0.08, 0.08, 1.0, 12.0), (0.08, 0.0, 15.0, 30.0)],
)
def test_what_the_certificate_moves_is_not_counted_twice(
    moved_px: float, certificate_px: float, least: float, most: float
) -> None:
    rng = np.random.default_rng(4)
    part, none = np.repeat(np.arange(PARTS), POINTS), np.zeros(PARTS * POINTS)
    two, sigma = np.zeros((len(part), 2)), none + SIGMA_PX
    three, whole = np.zeros((len(part), 3)), two.astype(np.int64)
    at = EdgeStations(part, part, three, two, two, two, none, whole, 1.0)
    off = sigma * rng.normal(size=len(sigma)) + np.repeat(moved_px * rng.normal(size=PARTS), POINTS)
    every = np.ones(len(off), np.bool_)
    used, along, together = estimate_scatter(off, at, every, sigma, none, none + certificate_px)
    assert used.mean() > 0.99
    assert along == pytest.approx(1.0, abs=0.15)
    assert least <= np.median(together) <= most


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

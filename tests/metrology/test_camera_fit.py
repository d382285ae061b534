"""The joint refinement against known cameras, and its covariance against scatter."""

from collections.abc import Callable, Sequence
from dataclasses import replace

import cv2
import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.metrology.calibration.camera_refinement import CameraFit, ImageObservations, fit_camera
from crenel.metrology.calibration.laser_plane_fit import fit_laser_plane
from crenel.metrology.calibration.observation_model import (
    Rows,
    SceneModel,
    corner_rows,
    edge_rows,
    stripe_rows,
)
from crenel.metrology.detection.detect_block import Corner, EdgePoints
from crenel.metrology.detection.visibility import visible_corners
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.sensor.faugeras import solve_faugeras
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.projection import COUNT, project_with_jacobian, step_camera
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.stripe import Stripe, empty_stripe
from crenel.metrology.targets.crenellated_block import corners
from crenel.metrology.transforms import Floats, apply, rigid_fit
from tests.metrology.builders import BLOCK
from tests.metrology.numerics import differences, rms_length
from tests.metrology.seen_block import (
    camera_over,
    draw_true_block,
    laser_plane,
    simulate_edges,
    simulate_stripe,
    volume_points,
)
from tests.uncertainty_ratio import ratio_of_pulls

pytestmark = pytest.mark.slow

PLANE = laser_plane()


def linear_start(camera: Camera) -> Camera:
    """Faugeras' camera, which knows no distortion."""
    at = corners(BLOCK)
    points = np.array([at[name] for name in sorted(visible_corners(BLOCK, camera.centre_mm))])
    return solve_faugeras(points, project(camera, points), 1280, 1024).camera


def steps_of(count: int, of_matrix: float = 1e-4) -> Floats:
    """A step of each parameter, of which the first four are those of the camera's matrix."""
    return np.where(np.arange(count) < 4, of_matrix, 1e-6)


def fit_to(
    camera: Camera, stripe: Stripe, edges: Sequence[EdgePoints] = (), seen: Sequence[Corner] = ()
) -> CameraFit:
    """A fit to what ``camera`` shows, which begins without distortion."""
    start = linear_start(camera)
    levels = fit_laser_plane(start, BLOCK, stripe)
    return fit_camera(start, BLOCK, ImageObservations(edges, seen, stripe, levels))


def fitted(camera: Camera, seed: int) -> CameraFit:
    """A fit to what ``camera`` shows of a block as far off its certificate as that allows."""
    rng = np.random.default_rng(seed)
    made = draw_true_block(BLOCK, rng)
    stripe = simulate_stripe(camera, made, PLANE, rng, 0.14)
    return fit_to(camera, stripe, simulate_edges(camera, made, rng, 0.1))


def error_um(camera: Camera, found: Camera, plane: LaserPlane) -> float:
    """Rms error of reconstructed points over the volume, after a rigid fit."""
    uv, points = volume_points(camera, PLANE, BLOCK)
    rebuilt = sensor_points(found, plane, uv)
    return 1e3 * rms_length(apply(rigid_fit(points, rebuilt), rebuilt) - points)


@pytest.mark.parametrize("k1", [-0.15, -0.04, 0.0, 0.08])
@pytest.mark.parametrize("roll", [0.0, 0.4])
def test_points_come_out_to_micrometres_whatever_the_lens(k1: float, roll: float) -> None:
    camera = camera_over(BLOCK, k1=k1, roll=roll)
    fits = [fitted(camera, seed) for seed in range(3)]
    errors = [error_um(camera, fit.camera, fit.plane) for fit in fits]
    assert np.sqrt(np.mean(np.square(errors))) < 2.5
    assert max(errors) < 4


def test_distortion_is_kept_only_where_the_picture_shows_it() -> None:
    plain, bent = camera_over(BLOCK, k1=0.0), camera_over(BLOCK, k1=-0.06)
    assert sum(bool(np.any(fitted(plain, seed).camera.distortion)) for seed in range(4)) <= 1
    for seed in range(3):
        fit = fitted(bent, seed)
        sd = np.sqrt(fit.covariance[10, 10])
        assert abs(fit.camera.distortion[0] + 0.06) < 4 * sd
        assert 0 < sd < 0.01
        assert not np.any(fit.camera.distortion[2:])


def test_neglected_distortion_would_cost_much_more() -> None:
    camera = camera_over(BLOCK, k1=-0.1)
    start, fit = linear_start(camera), fitted(camera, 1)
    stripe = simulate_stripe(camera, BLOCK, PLANE, np.random.default_rng(0), 0.1)
    neglected = error_um(camera, start, fit_laser_plane(start, BLOCK, stripe).plane)
    assert error_um(camera, fit.camera, fit.plane) < 0.3 * neglected


def test_the_covariance_foretells_the_scatter_of_points() -> None:
    """Points in the frame of the certificate, over fits with new noise and a new block each."""
    camera = camera_over(BLOCK)
    uv, points = volume_points(camera, PLANE, BLOCK)
    pulls = []
    for seed in range(12):
        fit = fitted(camera, seed)
        off = (sensor_points(fit.camera, fit.plane, uv) - points) @ PLANE.normal
        expected = np.sqrt(np.einsum("gi,ij,gj->g", *_heights(fit, uv)))
        pulls.append(off / expected)
    ratio_of_pulls(np.array(pulls)).assert_within(k=2)
    for part in ("edges", "stripe", "certificate", "distortion"):
        assert np.linalg.eigvalsh(fit.sources[part]).min() > -1e-9 * fit.sources[part].max()
    np.testing.assert_allclose(sum(fit.sources.values()), fit.covariance, rtol=1e-6, atol=1e-12)


def _heights(fit: CameraFit, uv: Floats) -> tuple[Floats, Floats, Floats]:
    """How the points' heights over the plane move with the parameters, and the covariance."""

    def heights(step: Floats) -> Floats:
        moved = fit.scene.apply_step(step)
        return np.asarray(sensor_points(moved.camera, moved.plane, uv) @ PLANE.normal)

    J = differences(heights, steps_of(len(fit.scene.names), 1e-3))
    J[:, COUNT + 3 :] = 0.0
    return J, fit.covariance, J


def test_a_wrong_edge_and_wild_points_are_left_out() -> None:
    camera = camera_over(BLOCK)
    rng = np.random.default_rng(4)
    edges = simulate_edges(camera, BLOCK, rng, 0.1)
    for edge in edges[::4]:
        edge.uv_px[::7] += edge.normal[::7] * rng.choice([-4.0, 4.0], (len(edge.uv_px[::7]), 1))
    fit = fit_to(camera, simulate_stripe(camera, BLOCK, PLANE, rng, 0.1), edges)
    wild = np.concatenate(
        [(np.arange(len(e.uv_px)) % 7 == 0) & (i % 4 == 0) for i, e in enumerate(edges)]
    )
    assert not fit.edges.inliers[wild].any()
    assert fit.edges.inliers[~wild].mean() > 0.99
    assert error_um(camera, fit.camera, fit.plane) < 3


def test_corners_alone_serve_where_there_are_no_edges() -> None:
    camera = camera_over(BLOCK, k1=0.0)
    rng = np.random.default_rng(2)
    at = corners(BLOCK)
    seen = []
    for name in sorted(visible_corners(BLOCK, camera.centre_mm)):
        u, v = project(camera, at[name][None])[0] + rng.normal(0, 0.03, 2)
        seen.append(Corner(name, float(u), float(v), np.eye(2) * 0.03**2))
    fit = fit_to(camera, simulate_stripe(camera, BLOCK, PLANE, rng, 0.1), seen=seen)
    assert error_um(camera, fit.camera, fit.plane) < 4


def test_a_picture_without_edges_is_refused() -> None:
    camera = camera_over(BLOCK)
    stripe = simulate_stripe(camera, BLOCK, PLANE, np.random.default_rng(0), 0.1)
    levels = fit_laser_plane(camera, BLOCK, stripe)
    empty = replace(
        levels,
        used=levels.used[:0],
        level=levels.level[:0],
        points_mm=levels.points_mm[:0],
        residuals_mm=np.zeros(0),
    )
    with pytest.raises(OperationError, match="do not determine"):
        fit_camera(camera, BLOCK, ImageObservations((), (), empty_stripe("u"), empty))


def test_projection_and_its_jacobian_agree_with_opencv_and_differences() -> None:
    camera = camera_over(BLOCK, roll=0.3)
    camera = replace(camera, distortion=np.array([-0.1, 0.2, 0.003, -0.002, 0.05]))
    points = np.random.default_rng(0).uniform([-25, -11, -11], [21, 13, 16], (40, 3))
    uv, J, by_point = project_with_jacobian(camera, points)
    rvec, _ = cv2.Rodrigues(camera.rotation)
    reference, _ = cv2.projectPoints(
        points, rvec, camera.translation_mm, camera.matrix, camera.distortion
    )
    np.testing.assert_allclose(uv, reference[:, 0], atol=1e-9)
    slopes = differences(lambda step: project(step_camera(camera, step), points), steps_of(COUNT))
    np.testing.assert_allclose(J, slopes, rtol=1e-5, atol=1e-4)
    slopes = differences(lambda shift: project(camera, points + shift), [1e-5] * 3)
    np.testing.assert_allclose(by_point, slopes, rtol=1e-6, atol=1e-6)


@pytest.mark.parametrize("kind", ["edges", "stripe", "corners"])
def test_observation_rows_have_the_derivatives_that_differences_show(kind: str) -> None:
    camera, rng = camera_over(BLOCK, roll=0.2), np.random.default_rng(1)
    stripe = simulate_stripe(camera, BLOCK, PLANE, rng, 0.1)
    levels = fit_laser_plane(camera, BLOCK, stripe)
    edges = simulate_edges(camera, BLOCK, rng, 0.1)
    at = corners(BLOCK)
    uv = project(camera, np.array([*at.values()])) + 0.1
    covariance = np.array([[0.02, 0.01], [0.01, 0.03]])
    seen = [Corner(name, u, v, covariance) for name, (u, v) in zip(at, uv.tolist(), strict=True)]
    of_kind: dict[str, Callable[[SceneModel], Rows]] = {
        "edges": lambda scene: edge_rows(scene, edges),
        "stripe": lambda scene: stripe_rows(scene, stripe, np.where(levels.used, levels.level, "")),
        "corners": lambda scene: corner_rows(scene, seen),
    }
    rows = of_kind[kind]
    scene = SceneModel(camera, levels.plane, BLOCK)
    found = rows(scene).jacobian
    steps = steps_of(len(scene.names))
    slopes = differences(lambda step: rows(scene.apply_step(step)).residuals, steps)
    for name, by, slope in zip(scene.names, found.T, slopes.T, strict=True):
        largest = max(float(np.abs(slope).max()), 1e-3)
        np.testing.assert_allclose(by, slope, atol=2e-4 * largest, err_msg=name)

"""Faugeras' matrix against OpenCV's projection, and its refusals."""

import cv2
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from crenel.metrology.sensor.faugeras import LARGEST_CONDITION, solve_faugeras
from crenel.metrology.targets.crenellated_block import Crenellated, corners
from crenel.metrology.transforms import Floats, inverse, rigid, rotation_from_vector
from tests.metrology.numerics import unit
from tests.metrology.refusals import refusal_of

BLOCK = Crenellated("b", "1", (-22, -14, -7, -2, 5, 10, 17, 22), -12, 12, 15, 0, -12, 0.002)
RAISED = [at for name, at in corners(BLOCK).items() if not name.startswith("base")]
LEVELS = np.array(RAISED, dtype=np.float64)
OBLONG = np.array([[2800.0, 0, 640], [0, 2810, 500], [0, 0, 1]])


def look_at(azimuth: float, elevation: float, roll: float, distance: float) -> Floats:
    """``T_cam_obj`` of a camera that looks at the block's middle."""
    target = np.array([0.0, 0.0, 7.0])
    flat = np.cos(elevation)
    away = np.array([np.sin(azimuth) * flat, -np.cos(azimuth) * flat, np.sin(elevation)])
    z, x = -away, unit(np.cross(-away, [0, 0, 1.0]))
    R = rotation_from_vector(np.array([0, 0, roll])) @ np.array([x, np.cross(z, x), z])
    return rigid(R, -R @ (target + distance * away))


def opencv_pixels(points: Floats, K: Floats, T_cam_obj: Floats) -> Floats:
    rvec, _ = cv2.Rodrigues(T_cam_obj[:3, :3])
    uv, _ = cv2.projectPoints(points, rvec, T_cam_obj[:3, 3], K, np.zeros(5))
    return np.asarray(uv[:, 0], dtype=np.float64)


cameras = st.tuples(
    st.floats(-0.5, 0.5),
    st.floats(0.3, 1.3),
    st.floats(-3.1, 3.1),
    st.floats(80, 400),
    st.floats(1000, 6000),
    st.floats(0.9, 1.1),
    st.floats(-100, 1400),
    st.floats(-100, 1100),
)


@given(cameras)
@settings(max_examples=60, deadline=None)
def test_every_camera_that_opencv_projects_with_is_found_again(camera: tuple[float, ...]) -> None:
    azimuth, elevation, roll, distance, f, aspect, u0, v0 = camera
    K = np.array([[f, 0, u0], [0, f * aspect, v0], [0, 0, 1]])
    T = look_at(azimuth, elevation, roll, distance)
    found = solve_faugeras(LEVELS, opencv_pixels(LEVELS, K, T), 1280, 1024)
    assert np.linalg.norm(found.projection_matrix[2, :3]) == pytest.approx(1, abs=1e-12)
    np.testing.assert_allclose(found.projection_matrix, K @ T[:3], rtol=1e-6, atol=1e-5 * f)
    np.testing.assert_allclose(found.camera.matrix, K, rtol=1e-5, atol=1e-4 * f)
    np.testing.assert_allclose(found.camera.rotation, T[:3, :3], atol=1e-6)
    np.testing.assert_allclose(found.camera.translation_mm, T[:3, 3], atol=1e-3)
    assert found.orthogonality_defect < 1e-6
    assert found.condition_number < LARGEST_CONDITION


@given(st.integers(0, 10_000))
@settings(max_examples=30, deadline=None)
def test_the_solution_moves_with_the_object_frame(seed: int) -> None:
    """|m3| = 1 is invariant to rotation and translation, noise or not."""
    rng = np.random.default_rng(seed)
    uv = opencv_pixels(LEVELS, OBLONG, look_at(0.2, 0.8, 0.1, 140))
    uv += rng.normal(0, 0.3, uv.shape)
    T = rigid(rotation_from_vector(rng.normal(0, 1, 3)), rng.normal(0, 200, 3))
    moved = LEVELS @ T[:3, :3].T + T[:3, 3]
    here = solve_faugeras(LEVELS, uv, 1280, 1024)
    there = solve_faugeras(moved, uv, 1280, 1024)
    expected = here.projection_matrix @ inverse(T)
    np.testing.assert_allclose(there.projection_matrix, expected, rtol=1e-7, atol=1e-4)
    assert here.orthogonality_defect > 0


def test_an_origin_in_the_cameras_own_plane_does_no_harm() -> None:
    T = look_at(0.2, 0.8, 0.1, 140)
    uv = opencv_pixels(LEVELS, OBLONG, T)
    shift = -T[:3, :3].T @ np.array([0, 0, T[2, 3]])
    found = solve_faugeras(LEVELS - shift, uv, 1280, 1024)
    assert abs(found.projection_matrix[2, 3]) < 1e-6
    np.testing.assert_allclose(found.camera.matrix, OBLONG, rtol=1e-6, atol=1e-3)


def refused(points: Floats, uv: Floats) -> str:
    return refusal_of(solve_faugeras, points, uv, 1280, 1024).code


K = np.array([[2800.0, 0, 640], [0, 2800, 512], [0, 0, 1]])
UV = opencv_pixels(LEVELS, K, look_at(0.1, 0.9, 0, 135))


def test_degenerate_points_are_refused_with_the_reason() -> None:
    crest = LEVELS[:, 2] == 15
    front = LEVELS[:, 1] == -12
    assert refused(LEVELS[crest], UV[crest]) == "degenerate-one-level"
    assert refused(LEVELS[front], UV[front]) == "degenerate-one-row"
    rows = crest & front | ~crest & ~front
    assert refused(LEVELS[rows], UV[rows]) == "degenerate-one-row"
    assert refused(LEVELS[:5], UV[:5]) == "degenerate-too-few-points"
    flat = LEVELS * [1, 1, 0.03]
    assert refused(flat, opencv_pixels(flat, K, look_at(0.1, 0.9, 0, 135))) == "degenerate-flat"
    assert refused(LEVELS, np.full_like(UV, 3.0)) == "degenerate-one-pixel"


def test_a_mirror_image_and_wrong_data_are_refused() -> None:
    assert refused(LEVELS, np.array([1279, 0]) + [-1, 1] * UV) == "object-mirrored"
    spoiled = UV.copy()
    spoiled[3, 1] = np.nan
    assert refused(LEVELS, spoiled) == "points-not-finite"
    assert refused(LEVELS, UV[:-1]) == "points-malformed"

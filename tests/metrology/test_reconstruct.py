"""Stripe pixels become the points they came from (Eq. 9)."""

import cv2
import numpy as np
import pytest

from crenel.metrology.arm.kinematics import flange_poses
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.triangulation import frame_points, sensor_points
from crenel.metrology.transforms import apply, inverse, rotation_from_vector
from tests.metrology.builders import random_arm, random_pose
from tests.metrology.numerics import unit

pytestmark = pytest.mark.usefixtures("variant")

CAMERA = Camera(
    matrix=np.array([[2800.0, 0.0, 640.0], [0.0, 2805.0, 512.0], [0.0, 0.0, 1.0]]),
    rotation=rotation_from_vector(np.array([np.radians(-120), 0.02, 0.03])),
    translation_mm=np.array([0.5, 8.0, 150.0]),
    width_px=1280,
    height_px=1024,
    distortion=np.array([-0.08, 0.02, 1e-3, -5e-4, 0.0]),
)
PLANE = LaserPlane(unit([0.01, 0.99, 0.14]), offset_mm=0.7)


def points_on_the_laser_plane(rng: np.random.Generator, n: int) -> np.ndarray:
    points = np.column_stack([rng.uniform(-20, 20, n), np.zeros(n), rng.uniform(0, 15, n)])
    points[:, 1] = (PLANE.offset_mm - points @ PLANE.normal) / PLANE.normal[1]
    return points


def test_the_projection_agrees_with_opencv() -> None:
    points = points_on_the_laser_plane(np.random.default_rng(1), 200)
    rvec, _ = cv2.Rodrigues(CAMERA.rotation)
    t, K, distortion = CAMERA.translation_mm, CAMERA.matrix, CAMERA.distortion
    expected, _ = cv2.projectPoints(points, rvec, t, K, distortion)
    np.testing.assert_allclose(project(CAMERA, points), expected[:, 0], atol=1e-9)


def test_pixels_return_to_the_points_they_came_from() -> None:
    points = points_on_the_laser_plane(np.random.default_rng(2), 500)
    found = sensor_points(CAMERA, PLANE, project(CAMERA, points))
    np.testing.assert_allclose(found, points, atol=1e-6)


def test_a_scan_is_every_frame_in_its_own_pose() -> None:
    rng = np.random.default_rng(3)
    arm = random_arm(rng)
    T_arm_flange = flange_poses(arm, rng.uniform(-2, 2, (4, 6)))
    T_flange_sensor = random_pose(rng)
    in_sensor = points_on_the_laser_plane(rng, 90)
    uv = project(CAMERA, in_sensor)
    count = np.array([40, 0, 1, 49])
    frame = np.repeat(np.arange(4), count)
    found = frame_points(CAMERA, PLANE, uv[:, 0], uv[:, 1], count, T_arm_flange @ T_flange_sensor)
    back = apply(inverse(T_arm_flange[frame] @ T_flange_sensor), found)
    np.testing.assert_allclose(back, in_sensor, atol=1e-6)
    for k in range(4):
        own = sensor_points(CAMERA, PLANE, uv[frame == k])
        one = apply(T_arm_flange[k] @ T_flange_sensor, own)
        np.testing.assert_allclose(one, found[frame == k], atol=1e-9)


@pytest.mark.parametrize("count", [[40, 49], [40, 51], [91, -1]])
def test_the_frames_have_as_many_pixels_as_there_are(count: list[int]) -> None:
    u, v = np.zeros((2, 90))
    with pytest.raises(ValueError, match="not 90 pixels"):
        frame_points(CAMERA, PLANE, u, v, np.array(count), np.tile(np.eye(4), (2, 1, 1)))


def test_rays_that_miss_the_plane_give_no_point() -> None:
    along = LaserPlane(CAMERA.rotation[0], float(CAMERA.rotation[0] @ CAMERA.centre_mm) - 5)
    both_sides = sensor_points(CAMERA, along, np.array([[0.0, 512.0], [1279.0, 512.0]]))
    assert np.isnan(both_sides[:, 0]).sum() == 1

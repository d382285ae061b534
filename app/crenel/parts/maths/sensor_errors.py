"""How a scanned point, in the sensor frame, follows the parameters of camera and laser plane."""

import numpy as np

from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane, tangents
from crenel.metrology.sensor.projection import COUNT, project_with_jacobian
from crenel.metrology.transforms import Floats

SENSOR_COUNT = COUNT + 3
"""Of the camera's parameters, and two tilts and the offset of the laser plane."""


def pixel_and_plane_equations(
    camera: Camera, plane: LaserPlane, points_mm: Floats
) -> tuple[Floats, Floats]:
    """The equations that make a point of a pixel: it projects there, and lies in the laser plane.

    Args:
        points_mm: (N, 3) of the laser plane, sensor frame.

    Returns:
        (N, 3, 3) derivatives of pixel and plane distance by the point; (N, 3, 17) by the
        parameters of camera and plane.
    """
    _, by_camera, by_point = project_with_jacobian(camera, points_mm)
    shear = camera.matrix[0, 1] / camera.matrix[1, 1]
    if shear:  # which the camera's own derivatives leave out: its axes are taken as square
        fy, v0 = 1, 3
        by_distorted = by_camera[:, 1].copy()
        by_distorted[:, [fy, v0]] = 0.0
        by_camera[:, 0] += shear * by_distorted
        by_point[:, 0] += shear * by_point[:, 1]
    left = np.empty((len(points_mm), 3, 3))
    left[:, :2], left[:, 2] = by_point, plane.normal
    right = np.zeros((len(points_mm), 3, SENSOR_COUNT))
    right[:, :2, :COUNT] = by_camera
    right[:, 2, COUNT : COUNT + 2] = points_mm @ tangents(plane.normal).T
    right[:, 2, COUNT + 2] = -1.0
    return left, right


def points_by_sensor(camera: Camera, plane: LaserPlane, points_mm: Floats) -> Floats:
    """Derivatives (N, 3, 17) of scanned points (N, 3), sensor frame, by camera and plane.

    The pixels are held. The parameters are those of ``calibration.json``: ``PARAMETERS`` of the
    camera, tilts of the plane along ``tangents(normal)``, and its offset.
    """
    left, right = pixel_and_plane_equations(camera, plane, points_mm)
    return np.asarray(-np.linalg.solve(left, right))


def points_by_pixel(camera: Camera, plane: LaserPlane, points_mm: Floats, axis: str) -> Floats:
    """Derivatives (N, 3) of scanned points (N, 3), sensor frame, by the pixel across the stripe.

    Args:
        axis: ``u`` for one point in each column, so that ``v`` was measured; or ``v``.
    """
    left, _ = pixel_and_plane_equations(camera, plane, points_mm)
    moved = np.zeros((len(points_mm), 3, 1))
    moved[:, 1 if axis == "u" else 0] = 1.0
    return np.asarray(np.linalg.solve(left, moved)[:, :, 0])

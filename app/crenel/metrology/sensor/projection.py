"""Derivatives of pixels by the camera's parameters and by the points."""

from dataclasses import replace

import numpy as np

from crenel.metrology.sensor.camera import Camera
from crenel.metrology.transforms import Floats, nearest_rotation, rotation_from_vector

# fx, fy, u0, v0 (px), rotation (rad) and translation (mm) of the object in the camera frame, lens
PARAMETERS = ("fx", "fy", "u0", "v0", "rx", "ry", "rz", "tx", "ty", "tz", "k1", "k2", "p1", "p2")
COUNT = len(PARAMETERS)
LENS = slice(10, 14)


def step_camera(camera: Camera, step: Floats) -> Camera:
    """The camera after adding a step (14,) to its ``PARAMETERS``."""
    matrix = camera.matrix.copy()
    matrix[0, 0] += step[0]
    matrix[1, 1] += step[1]
    matrix[:2, 2] += step[2:4]
    turn = rotation_from_vector(step[4:7])
    distortion = camera.distortion.copy()
    distortion[:4] += step[LENS]
    return replace(
        camera,
        matrix=matrix,
        rotation=nearest_rotation(turn @ camera.rotation),
        translation_mm=turn @ camera.translation_mm + step[7:10],
        distortion=distortion,
    )


def project_with_jacobian(camera: Camera, points_mm: Floats) -> tuple[Floats, Floats, Floats]:
    """Pixels of points (N, 3), and their derivatives.

    Returns:
        (N, 2) pixels; (N, 2, 14) derivatives by ``PARAMETERS``; (N, 2, 3) by the points.
    """
    P = points_mm @ camera.rotation.T + camera.translation_mm
    x, y = P[:, 0] / P[:, 2], P[:, 1] / P[:, 2]
    k1, k2, p1, p2, k3 = camera.distortion
    r2 = x * x + y * y
    radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
    xd = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)
    yd = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y
    fx, fy = camera.matrix[0, 0], camera.matrix[1, 1]
    uv = np.column_stack([fx * xd + camera.matrix[0, 2], fy * yd + camera.matrix[1, 2]])

    slope = 2 * (k1 + r2 * (2 * k2 + 3 * r2 * k3))  # d radial / d x = slope x
    by_xy = np.empty((len(P), 2, 2))
    by_xy[:, 0, 0] = fx * (radial + slope * x * x + 2 * p1 * y + 6 * p2 * x)
    by_xy[:, 0, 1] = fx * (slope * x * y + 2 * p1 * x + 2 * p2 * y)
    by_xy[:, 1, 0] = fy * (slope * x * y + 2 * p1 * x + 2 * p2 * y)
    by_xy[:, 1, 1] = fy * (radial + slope * y * y + 6 * p1 * y + 2 * p2 * x)
    xy_by_P = np.zeros((len(P), 2, 3))
    xy_by_P[:, 0, 0] = xy_by_P[:, 1, 1] = 1 / P[:, 2]
    xy_by_P[:, 0, 2], xy_by_P[:, 1, 2] = -x / P[:, 2], -y / P[:, 2]
    by_P = by_xy @ xy_by_P

    J = np.zeros((len(P), 2, COUNT))
    J[:, 0, 0], J[:, 1, 1] = xd, yd
    J[:, 0, 2] = J[:, 1, 3] = 1.0
    J[:, :, 4:7] = np.cross(P[:, None, :], by_P)  # a rotation w moves P by w x P
    J[:, :, 7:10] = by_P
    J[:, 0, 10], J[:, 1, 10] = fx * x * r2, fy * y * r2
    J[:, 0, 11], J[:, 1, 11] = fx * x * r2**2, fy * y * r2**2
    J[:, 0, 12], J[:, 1, 12] = fx * 2 * x * y, fy * (r2 + 2 * y * y)
    J[:, 0, 13], J[:, 1, 13] = fx * (r2 + 2 * x * x), fy * 2 * x * y
    return uv, J, np.asarray(by_P @ camera.rotation)

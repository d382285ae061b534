"""The pinhole camera with Brown's distortion, in OpenCV's conventions."""

from dataclasses import dataclass, field

import cv2
import numpy as np

from crenel.metrology.transforms import Floats


@dataclass(frozen=True)
class Camera:
    """A camera and its pose in the sensor frame.

    ``x_cam = rotation @ x_sensor + translation_mm``; ``distortion`` is
    ``k1, k2, p1, p2, k3``.
    """

    matrix: Floats  # (3, 3)
    rotation: Floats  # (3, 3)
    translation_mm: Floats  # (3,)
    width_px: int
    height_px: int
    distortion: Floats = field(default_factory=lambda: np.zeros(5))  # (5,)

    @property
    def projection_matrix(self) -> Floats:
        """(3, 4): sensor frame in mm to undistorted pixels, ``matrix [rotation | translation]``."""
        return np.asarray(self.matrix @ np.column_stack([self.rotation, self.translation_mm]))

    @property
    def centre_mm(self) -> Floats:
        """(3,) optical centre in the sensor frame."""
        return np.asarray(-self.rotation.T @ self.translation_mm)


def project(camera: Camera, points_mm: Floats) -> Floats:
    """Pixels of points, lens distortion included.

    Args:
        points_mm: (N, 3) in the sensor frame, in front of the camera; points behind it are also
            projected, through the optical centre.

    Returns:
        (N, 2) distorted pixels (u, v), also outside the image.

    Source:
        Pinhole camera with the distortion of Brown (1971), terms in OpenCV's order.

    Example:
        >>> K = np.array([[1000.0, 0.0, 320.0], [0.0, 1000.0, 256.0], [0.0, 0.0, 1.0]])
        >>> camera = Camera(K, np.eye(3), np.array([0.0, 0.0, 100.0]), 640, 512)
        >>> project(camera, np.array([[1.0, -2.0, 0.0]])).tolist()
        [[330.0, 236.0]]
    """
    in_cam = np.asarray(points_mm, dtype=np.float64) @ camera.rotation.T + camera.translation_mm
    x, y = in_cam[:, 0] / in_cam[:, 2], in_cam[:, 1] / in_cam[:, 2]
    k1, k2, p1, p2, k3 = camera.distortion
    r2 = x * x + y * y
    radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
    xd = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)
    yd = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y
    K = camera.matrix
    return np.column_stack([K[0, 0] * xd + K[0, 1] * yd + K[0, 2], K[1, 1] * yd + K[1, 2]])


def undistort_pixels(camera: Camera, uv_px: Floats) -> Floats:
    """Undistorted directions of pixels, computed iteratively.

    Args:
        uv_px: (N, 2) distorted pixels.

    Returns:
        (N, 2) x/z and y/z in the camera frame.
    """
    uv = np.ascontiguousarray(uv_px, dtype=np.float64).reshape(-1, 1, 2)
    if not len(uv):  # OpenCV does not accept an empty array
        return np.empty((0, 2))
    criteria = (cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 50, 1e-12)
    found = cv2.undistortPointsIter(
        uv, camera.matrix, camera.distortion, np.eye(3), np.eye(3), criteria
    )
    return np.asarray(found, dtype=np.float64).reshape(-1, 2)


def rays(camera: Camera, uv_px: Floats) -> tuple[Floats, Floats]:
    """Rays of pixels, with lens distortion removed.

    Args:
        uv_px: (N, 2) distorted pixels.

    Returns:
        Origin (3,) in mm, which is the optical centre, and directions (N, 3), not of unit
        length, both in the sensor frame.

    Example:
        >>> K = np.array([[1000.0, 0.0, 320.0], [0.0, 1000.0, 256.0], [0.0, 0.0, 1.0]])
        >>> camera = Camera(K, np.eye(3), np.array([0.0, 0.0, 100.0]), 640, 512)
        >>> origin, along = rays(camera, np.array([[330.0, 236.0]]))
        >>> (origin + 100.0 * along).round(9).tolist()
        [[1.0, -2.0, 0.0]]
    """
    xy = undistort_pixels(camera, uv_px)
    return camera.centre_mm, np.column_stack([xy, np.ones(len(xy))]) @ camera.rotation

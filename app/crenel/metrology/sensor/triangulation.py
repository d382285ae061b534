"""From stripe pixels to points: intersection of the camera's rays with the laser plane (Eq. 9).

It also gives the uncertainty of each point due to the fit of its stripe.
"""

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.transforms import Floats
from crenel.native.arguments import F64, I64, Array, Function
from crenel.native.library import CRENEL

PixelCounts = NDArray[np.int64]

_frame_points = Function(
    CRENEL,
    "frame_points",
    Array(F64, "n"),
    Array(F64, "n"),
    Array(F64, "n", optional=True),
    Array(I64, "frames"),
    Array(F64, "frames", 4, 4),
    Array(F64, 32),
    Array(F64, "n", 3, written=True),
    Array(F64, "n", written=True, optional=True),
    returns=int,
)


def sensor_points(camera: Camera, plane: LaserPlane, uv_px: Floats) -> Floats:
    """Points of the stripe in the sensor frame: the ``X_LSS`` of Eq. 9.

    The ray of each pixel is intersected with the laser plane.

    Args:
        uv_px: (N, 2) distorted pixels, as extracted from the image.

    Returns:
        (N, 3) mm; NaN if the ray does not meet the laser plane in front of the camera.

    Example:
        >>> K = np.array([[1000.0, 0.0, 320.0], [0.0, 1000.0, 256.0], [0.0, 0.0, 1.0]])
        >>> camera = Camera(K, np.eye(3), np.array([0.0, 0.0, 100.0]), 640, 512)
        >>> plane = LaserPlane(np.array([0.0, 0.0, 1.0]), 20.0)
        >>> sensor_points(camera, plane, np.array([[330.0, 256.0]])).round(9).tolist()
        [[1.2, 0.0, 20.0]]
    """
    uv = np.asarray(uv_px, dtype=np.float64).reshape(-1, 2)
    return frame_points(camera, plane, uv[:, 0], uv[:, 1], np.array([len(uv)]), np.eye(4)[None])


def frame_points(
    camera: Camera,
    plane: LaserPlane,
    u_px: Floats,
    v_px: Floats,
    count: PixelCounts,
    T_arm_sensor: Floats,
    points_mm: Floats | None = None,
) -> Floats:
    """Points of consecutive frames in the arm frame, each frame in its own pose.

    Args:
        u_px, v_px: (N,) distorted pixels of all frames, frame by frame.
        count: (F,) number of pixels of each frame; N in total.
        T_arm_sensor: (F, 4, 4) ``T_arm_flange @ T_flange_sensor`` at mid-exposure.
        points_mm: (N, 3) array to fill; None: a new one.

    Returns:
        (N, 3) mm; NaN as in ``sensor_points``.

    Raises:
        ValueError: the counts of the frames do not add up to N.

    Source:
        Eq. 9 of the article.
    """
    filled = np.empty((len(u_px), 3)) if points_mm is None else points_mm
    _fill(camera, plane, u_px, v_px, count, T_arm_sensor, filled)
    return filled


def scan_points(
    camera: Camera,
    plane: LaserPlane,
    u_px: Floats,
    v_px: Floats,
    sigma_px: Floats,
    axis: str,
    count: PixelCounts,
    T_arm_sensor: Floats,
) -> tuple[Floats, Floats]:
    """Points of consecutive frames in the arm frame, with their standard uncertainty.

    The uncertainty is that of the stripe's fit, in the laser plane: the part that differs from
    point to point. Calibration and arm shift all points of a frame together; their part is stated
    with the calibration. It follows from the derivative of Eq. 9 by the pixel, with the lens
    distortion treated as equal for adjacent pixels.

    Args:
        u_px, v_px, count, T_arm_sensor: as in ``frame_points``.
        sigma_px: (N,) standard deviation of the stripe's points across the stripe.
        axis: ``u`` for one point in each column, so that ``v`` was measured; or ``v``.

    Returns:
        (N, 3) mm, NaN as in ``sensor_points``; (N,) µm, k = 1.

    Raises:
        ValueError: the counts of the frames do not add up to N.

    Source:
        Eq. 9 of the article.
    """
    points_mm, spread_um = np.empty((len(u_px), 3)), np.empty(len(u_px))
    fit = (_contiguous(sigma_px), axis, spread_um)
    _fill(camera, plane, u_px, v_px, count, T_arm_sensor, points_mm, *fit)
    return points_mm, spread_um


def _fill(
    camera: Camera,
    plane: LaserPlane,
    u_px: Floats,
    v_px: Floats,
    count: PixelCounts,
    T_arm_sensor: Floats,
    points_mm: Floats,
    sigma_px: Floats | None = None,
    axis: str = "u",
    spread_um: Floats | None = None,
) -> None:
    """Fills in the points, and their uncertainty if requested."""
    found = _frame_points(
        _contiguous(u_px),
        _contiguous(v_px),
        sigma_px,
        np.ascontiguousarray(count, dtype=np.int64),
        _contiguous(T_arm_sensor),
        _constants(camera, plane, axis),
        points_mm,
        spread_um,
    )
    if found != len(u_px):
        raise ValueError(f"the frames have not {len(u_px)} pixels together")


def _constants(camera: Camera, plane: LaserPlane, axis: str) -> Floats:
    """Parameters of camera and plane for the loop (32,), in the order of its structure ``Sensor``.

    The ray with direction p in the camera frame meets the plane, with normal h there, at ``distance
    / (h p)`` times p.
    """
    K, centre_mm = camera.matrix, camera.centre_mm
    # rotation of the ray (x, y, 1) by a pixel across the stripe
    across = [1 / K[0, 0], 0.0]
    if axis == "u":
        across = [-K[0, 1] / (K[0, 0] * K[1, 1]), 1 / K[1, 1]]
    distance_mm = plane.offset_mm - plane.normal @ centre_mm
    parts = (
        K.ravel(),
        camera.distortion,
        camera.rotation.ravel(),
        centre_mm,
        camera.rotation @ plane.normal,
        [distance_mm, *across],
    )
    return np.concatenate(parts, dtype=np.float64)


def _contiguous(array: Floats) -> Floats:
    return np.ascontiguousarray(array, dtype=np.float64)

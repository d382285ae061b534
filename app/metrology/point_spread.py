"""Points of a scan, and how well each is known by the fit of its stripe alone."""

import numpy as np
from numpy.typing import NDArray

from app.metrology.camera import Camera
from app.metrology.frames import Floats
from app.metrology.laser_plane import LaserPlane
from app.metrology.reconstruct import placed_points, sensor_points
from app.native.arguments import F64, Array, Function, Real
from app.native.product import CRENEL

_spread = Function(
    CRENEL,
    "spread",
    Array(F64, "n", 3),
    Array(F64, "n"),
    Array(F64, 3),
    Array(F64, 3),
    Real(),
    Array(F64, 3),
    Real(),
    Array(F64, "n", written=True),
)


def scan_points(
    camera: Camera,
    plane: LaserPlane,
    uv_px: Floats,
    sigma_px: Floats,
    axis: str,
    frame_of_point: NDArray[np.int64],
    T_arm_sensor: Floats,
) -> tuple[Floats, Floats]:
    """Points of some frames in the arm frame (Eq. 9), and their standard uncertainty.

    Args:
        uv_px: (N, 2) distorted pixels of all frames.
        sigma_px, axis: as of ``spread_um``.
        frame_of_point: (N,) which of the F frames each pixel belongs to.
        T_arm_sensor: (F, 4, 4) at each frame's mid-exposure.

    Returns:
        (N, 3) mm, NaN as in ``reconstruct.sensor_points``; (N,) µm as of ``spread_um``.
    """
    in_sensor = sensor_points(camera, plane, uv_px)
    points_mm = placed_points(in_sensor, frame_of_point, T_arm_sensor)
    return points_mm, spread_um(camera, plane, in_sensor, sigma_px, axis)


def spread_um(
    camera: Camera, plane: LaserPlane, points_mm: Floats, sigma_px: Floats, axis: str = "u"
) -> Floats:
    """Standard uncertainty (k = 1) of points along the stripe's breadth, in the laser plane.

    It is what differs from point to point. Calibration and arm move whole frames
    together; their part stands in the calibration.

    The intersection of Eq. 9 differentiated by the pixel, the lens' distortion being
    the same for neighbouring pixels.

    Args:
        points_mm: (N, 3) in the sensor frame, as of ``reconstruct.sensor_points``.
        sigma_px: (N,) of the stripe's fit, across the stripe.
        axis: ``u`` where there is one point a column, so that ``v`` was fitted.

    Returns:
        (N,) µm.
    """
    K, centre = camera.matrix, camera.centre_mm
    in_cam = np.array([1 / K[0, 0], 0.0, 0.0])
    if axis == "u":
        in_cam = np.array([-K[0, 1] / (K[0, 0] * K[1, 1]), 1 / K[1, 1], 0.0])
    turn = camera.rotation.T @ in_cam  # of the ray, a pixel, at depth 1
    reach_mm = plane.offset_mm - float(plane.normal @ centre)
    along = float(plane.normal @ turn) / reach_mm
    found_um = np.empty(len(points_mm))
    _spread(
        np.ascontiguousarray(points_mm, dtype=np.float64),
        np.ascontiguousarray(sigma_px, dtype=np.float64),
        np.ascontiguousarray(turn),
        np.ascontiguousarray(centre),
        along,
        np.ascontiguousarray(camera.rotation[2]),
        float(camera.translation_mm[2]),
        found_um,
    )
    return found_um

"""How well a scanned point is known by the fit of its stripe alone."""

import numpy as np

from app.metrology.camera import Camera
from app.metrology.frames import Floats
from app.metrology.laser_plane import LaserPlane


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
    depth = points_mm @ camera.rotation[2] + camera.translation_mm[2]
    moved = turn - (points_mm - centre) * along
    return np.asarray(1e3 * np.abs(depth) * np.linalg.norm(moved, axis=1) * sigma_px)

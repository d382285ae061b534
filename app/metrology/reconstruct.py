"""From stripe pixels to points: the camera's ray meets the laser plane (Eq. 9)."""

import numpy as np

from app.metrology.camera import Camera, rays
from app.metrology.frames import Floats, apply
from app.metrology.laser_plane import LaserPlane


def sensor_points(camera: Camera, plane: LaserPlane, uv_px: Floats) -> Floats:
    """Points of the stripe in the sensor frame: the ``X_LSS`` of Eq. 9.

    Args:
        uv_px: (N, 2) distorted pixels, as extracted from the image.

    Returns:
        (N, 3) mm; NaN where the pixel's ray does not meet the laser plane in
        front of the camera.
    """
    origin, directions = rays(camera, uv_px)
    across = directions @ plane.normal
    with np.errstate(divide="ignore", invalid="ignore"):
        depth = (plane.offset_mm - float(plane.normal @ origin)) / across
    depth[~(depth > 0) | ~np.isfinite(depth)] = np.nan
    return np.asarray(origin + depth[:, None] * directions)


def arm_points(
    camera: Camera,
    plane: LaserPlane,
    T_flange_sensor: Floats,
    uv_px: Floats,
    T_arm_flange: Floats,
) -> Floats:
    """Points of the stripe in the arm frame (Eq. 9).

    Args:
        T_flange_sensor: (4, 4), the paper's probe matrix (Eq. 8).
        uv_px: (N, 2) distorted pixels.
        T_arm_flange: (4, 4) the arm's pose at mid-exposure, or (N, 4, 4) one a pixel.

    Returns:
        (N, 3) mm; NaN as in ``sensor_points``.
    """
    in_flange = apply(T_flange_sensor, sensor_points(camera, plane, uv_px))
    return apply(T_arm_flange, in_flange)


def scan_points(
    camera: Camera,
    plane: LaserPlane,
    T_flange_sensor: Floats,
    uv_px: Floats,
    frame_of_point: np.ndarray[tuple[int, ...], np.dtype[np.int64]],
    T_arm_flange: Floats,
) -> Floats:
    """Points of a whole scan in the arm frame (Eq. 9).

    Args:
        uv_px: (N, 2) distorted pixels of all frames.
        frame_of_point: (N,) which of the F frames each pixel belongs to.
        T_arm_flange: (F, 4, 4) the arm's pose at each frame's mid-exposure.

    Returns:
        (N, 3) mm; NaN as in ``sensor_points``.
    """
    in_sensor = sensor_points(camera, plane, uv_px)
    return placed_points(in_sensor, frame_of_point, T_arm_flange @ T_flange_sensor)


def placed_points(
    in_sensor: Floats,
    frame_of_point: np.ndarray[tuple[int, ...], np.dtype[np.int64]],
    T_arm_sensor: Floats,
) -> Floats:
    """Points of a whole scan brought from the sensor frame (N, 3) to the arm frame (N, 3).

    Args:
        frame_of_point: (N,) which of the F frames each point belongs to.
        T_arm_sensor: (F, 4, 4) at each frame's mid-exposure.
    """
    turned = np.einsum("nij,nj->ni", T_arm_sensor[frame_of_point, :3, :3], in_sensor)
    return np.asarray(turned + T_arm_sensor[frame_of_point, :3, 3])

"""From stripe pixels to points: the camera's ray meets the laser plane (Eq. 9)."""

import numpy as np
from numpy.typing import NDArray

from app.metrology import reconstruct_kernels as kernels
from app.metrology.camera import Camera
from app.metrology.frames import Floats, apply
from app.metrology.laser_plane import LaserPlane

Numbers = NDArray[np.float64] | NDArray[np.float32]


def sensor_points(camera: Camera, plane: LaserPlane, uv_px: Floats) -> Floats:
    """Points of the stripe in the sensor frame: the ``X_LSS`` of Eq. 9.

    Args:
        uv_px: (N, 2) distorted pixels, as extracted from the image.

    Returns:
        (N, 3) mm; NaN where the pixel's ray does not meet the laser plane in
        front of the camera.
    """
    uv = np.asarray(uv_px, dtype=np.float64).reshape(-1, 2)
    return _in_one_pose(camera, plane, uv, np.eye(4))


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
    if np.ndim(T_arm_flange) == 2:
        uv = np.asarray(uv_px, dtype=np.float64).reshape(-1, 2)
        return _in_one_pose(camera, plane, uv, np.asarray(T_arm_flange @ T_flange_sensor))
    in_flange = apply(T_flange_sensor, sensor_points(camera, plane, uv_px))
    return apply(T_arm_flange, in_flange)


def frame_points(
    camera: Camera,
    plane: LaserPlane,
    u_px: Numbers,
    v_px: Numbers,
    first: NDArray[np.int64],
    T_arm_sensor: Floats,
    points_mm: Numbers | None = None,
) -> Numbers:
    """Points of frames that follow one another in the arm frame (Eq. 9), each in its pose.

    Args:
        u_px, v_px: (N,) distorted pixels of all frames, frame after frame.
        first: (F + 1,) where each frame's pixels begin, and at last N.
        T_arm_sensor: (F, 4, 4) ``T_arm_flange @ T_flange_sensor`` at mid-exposure.
        points_mm: (N, 3) to be filled, of single or double precision; None makes a new one.

    Returns:
        (N, 3) mm; NaN as in ``sensor_points``. It is worked out in double precision.
    """
    filled = np.empty((len(u_px), 3)) if points_mm is None else points_mm
    kernels.frame_points(
        u_px,
        v_px,
        np.ascontiguousarray(first, dtype=np.int64),
        np.ascontiguousarray(T_arm_sensor, dtype=np.float64),
        *_constants(camera, plane),
        filled.reshape(-1),
    )
    return filled


def placed_points(
    in_sensor: Floats,
    frame_of_point: NDArray[np.int64],
    T_arm_sensor: Floats,
) -> Floats:
    """Points of a whole scan brought from the sensor frame (N, 3) to the arm frame (N, 3).

    Args:
        frame_of_point: (N,) which of the F frames each point belongs to.
        T_arm_sensor: (F, 4, 4) at each frame's mid-exposure.
    """
    placed = np.empty((len(in_sensor), 3))
    kernels.placed_points(
        np.ascontiguousarray(in_sensor, dtype=np.float64).reshape(-1),
        np.ascontiguousarray(frame_of_point, dtype=np.int64),
        np.ascontiguousarray(T_arm_sensor, dtype=np.float64),
        placed.reshape(-1),
    )
    return placed


def _in_one_pose(camera: Camera, plane: LaserPlane, uv: Floats, T: Floats) -> Floats:
    u, v = np.ascontiguousarray(uv[:, 0]), np.ascontiguousarray(uv[:, 1])
    first = np.array([0, len(uv)])
    return np.asarray(frame_points(camera, plane, u, v, first, T[None]))


def _constants(camera: Camera, plane: LaserPlane) -> tuple[Floats, Floats, Floats, Floats, float]:
    """What the kernel needs: matrix, distortion, rotation, the camera's centre, the plane.

    The latter as a row h and a distance d: the ray of direction p in the camera's frame
    meets the plane at ``d / (h p)`` times p.
    """
    origin = camera.centre_mm
    distance = plane.offset_mm - float(plane.normal @ origin)
    across = np.concatenate([camera.rotation @ plane.normal, origin])
    return (
        np.ascontiguousarray(camera.matrix, dtype=np.float64),
        np.ascontiguousarray(camera.distortion, dtype=np.float64),
        np.ascontiguousarray(camera.rotation, dtype=np.float64),
        across,
        distance,
    )

"""The inner loops that bring stripe pixels to points."""

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import vector_kernel
from app.metrology.frames import Floats

Numbers = NDArray[np.float64] | NDArray[np.float32]
ONE, THREE = np.uintp(1), np.uintp(3)


@vector_kernel
def newton(
    x: float,
    y: float,
    xd: float,
    yd: float,
    k1: float,
    k2: float,
    p1: float,
    p2: float,
    k3: float,
) -> tuple[float, float]:
    """One Newton step towards the direction that Brown's model distorts to (xd, yd)."""
    r2 = x * x + y * y
    radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3))
    slope = 2.0 * (k1 + r2 * (2.0 * k2 + 3.0 * r2 * k3))
    left_x = xd - (x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x))
    left_y = yd - (y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y)
    xx = radial + slope * x * x + 2.0 * p1 * y + 6.0 * p2 * x
    xy = slope * x * y + 2.0 * p1 * x + 2.0 * p2 * y
    yy = radial + slope * y * y + 6.0 * p1 * y + 2.0 * p2 * x
    per_det = 1.0 / (xx * yy - xy * xy)
    return (
        x + (yy * left_x - xy * left_y) * per_det,
        y + (xx * left_y - xy * left_x) * per_det,
    )


@vector_kernel
def frame_points(
    u: Numbers,
    v: Numbers,
    first: NDArray[np.int64],
    T_arm_sensor: Floats,
    matrix: Floats,
    distortion: Floats,
    rotation: Floats,
    across: Floats,
    distance: float,
    points: Numbers,
) -> None:
    """Eq. 9 for frames that follow one another.

    Args:
        u, v: (N,) distorted pixels.
        first: (F + 1,) where each frame's pixels begin.
        T_arm_sensor: (F, 4, 4).
        matrix, distortion, rotation: of the camera, (3, 3), (5,) and (3, 3).
        across: (6,) the laser plane's normal in the camera frame, then the camera's
            centre in the sensor frame.
        distance: of the plane from the camera's centre, along its normal.
        points: (3 N,) filled.
    """
    per_fx, per_fy, skew = 1.0 / matrix[0, 0], 1.0 / matrix[1, 1], matrix[0, 1]
    cu, cv = matrix[0, 2], matrix[1, 2]
    k1, k2, p1, p2, k3 = distortion[0], distortion[1], distortion[2], distortion[3], distortion[4]
    a0, a1, a2 = across[0], across[1], across[2]
    for f in range(len(first) - 1):
        T = T_arm_sensor[f]
        # directions of the camera's frame in the arm's, and the camera's centre there
        M = np.dot(np.ascontiguousarray(T[:3, :3]), np.ascontiguousarray(rotation.T))
        m00, m01, m02 = M[0, 0], M[0, 1], M[0, 2]
        m10, m11, m12 = M[1, 0], M[1, 1], M[1, 2]
        m20, m21, m22 = M[2, 0], M[2, 1], M[2, 2]
        o0 = T[0, 0] * across[3] + T[0, 1] * across[4] + T[0, 2] * across[5] + T[0, 3]
        o1 = T[1, 0] * across[3] + T[1, 1] * across[4] + T[1, 2] * across[5] + T[1, 3]
        o2 = T[2, 0] * across[3] + T[2, 1] * across[4] + T[2, 2] * across[5] + T[2, 3]
        for i in range(np.uintp(first[f]), np.uintp(first[f + 1])):
            yd = (v[i] - cv) * per_fy
            xd = (u[i] - cu - skew * yd) * per_fx
            x, y = newton(xd, yd, xd, yd, k1, k2, p1, p2, k3)
            x, y = newton(x, y, xd, yd, k1, k2, p1, p2, k3)
            x, y = newton(x, y, xd, yd, k1, k2, p1, p2, k3)
            x, y = newton(x, y, xd, yd, k1, k2, p1, p2, k3)
            depth = distance / (a0 * x + a1 * y + a2)
            depth = depth if (depth > 0.0) & (depth < np.inf) else np.nan
            to = THREE * i
            points[to] = o0 + depth * (m00 * x + m01 * y + m02)
            points[to + ONE] = o1 + depth * (m10 * x + m11 * y + m12)
            points[to + ONE + ONE] = o2 + depth * (m20 * x + m21 * y + m22)


@vector_kernel
def placed_points(
    in_sensor: Floats, frame_of_point: NDArray[np.int64], T_arm_sensor: Floats, points: Floats
) -> None:
    """Brings points (3 N,) of the sensor frame to the arm frame, each in its frame's pose."""
    for i in range(len(frame_of_point)):
        T = T_arm_sensor[frame_of_point[i]]
        x, y, z = in_sensor[3 * i], in_sensor[3 * i + 1], in_sensor[3 * i + 2]
        points[3 * i] = T[0, 0] * x + T[0, 1] * y + T[0, 2] * z + T[0, 3]
        points[3 * i + 1] = T[1, 0] * x + T[1, 1] * y + T[1, 2] * z + T[1, 3]
        points[3 * i + 2] = T[2, 0] * x + T[2, 1] * y + T[2, 2] * z + T[2, 3]

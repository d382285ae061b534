"""The camera that fits edge points of the block: all of its parameters at once."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from app.metrology.camera import Camera, project
from app.metrology.compiled import kernel
from app.metrology.frames import Floats, nearest_rotation, rotation_from_vector

# fx, fy, cx, cy, three turns, three shifts, k1, k2
_COUNT = 12
FOCAL_AND_POSE = (0, 4, 5, 6, 7, 8, 9)
NO_DISTORTION = (0, 1, 2, 3, 4, 5, 6, 7, 8, 9)
WITH_K1 = (*NO_DISTORTION, 10)
WITH_K2 = (*WITH_K1, 11)


def moved(camera: Camera, step: Floats) -> Camera:
    """The camera after a step (12,): focal lengths (relative), principal point (of the width),
    turn (rad) and shift (of the distance) in the camera frame, k1, k2."""
    matrix = camera.matrix.copy()
    matrix[0, 0] *= np.exp(step[0])
    # The second focal length follows the first; step 1 is their ratio.
    matrix[1, 1] *= np.exp(step[0] + step[1])
    matrix[:2, 2] += step[2:4] * camera.width_px
    turn = rotation_from_vector(step[4:7])
    distance = float(np.linalg.norm(camera.translation_mm))
    distortion = camera.distortion.copy()
    distortion[:2] += step[10:12]
    return replace(
        camera,
        matrix=matrix,
        rotation=turn @ camera.rotation,
        translation_mm=turn @ camera.translation_mm + step[7:10] * distance,
        distortion=distortion,
    )


def _held(camera: Camera) -> tuple[Floats, Floats]:
    """What lenses are like before any measurement: values (5,) and their standard deviations.

    Square pixels to a thousandth, the axis within a twentieth of the width of the
    middle, mild distortion. They only count where the picture says nothing.
    """
    K = camera.matrix
    values = np.array(
        [
            np.log(K[1, 1] / K[0, 0]),
            (K[0, 2] - (camera.width_px - 1) / 2) / camera.width_px,
            (K[1, 2] - (camera.height_px - 1) / 2) / camera.width_px,
            camera.distortion[0],
            camera.distortion[1],
        ]
    )
    return values, np.array([0.001, 0.05, 0.05, 0.5, 1.0])


_HELD_STEPS = (1, 2, 3, 10, 11)


def held_rows(camera: Camera, free: tuple[int, ...]) -> Floats:
    """What is held of the chosen parameters, as rows (H, P) over their standard deviations."""
    _, deviations = _held(camera)
    rows = np.zeros((len(_HELD_STEPS), len(free)))
    for row, step in enumerate(_HELD_STEPS):
        if step in free:
            rows[row, free.index(step)] = 1 / deviations[row]
    return rows


def residuals(camera: Camera, points_mm: Floats, uv_px: Floats, normal: Floats) -> Floats:
    """Distances (N,) in px, along the normals, of measured from predicted edges."""
    return np.asarray(((uv_px - project(camera, points_mm)) * normal).sum(axis=1))


@kernel
def _rows(
    points: Floats, uv: Floats, normal: Floats, pose: Floats, lens: Floats, width: float
) -> tuple[Floats, Floats]:
    """Residuals (N,) in px and their derivatives (N, 12) by a step of ``moved``.

    ``pose``: (3, 4) rotation and translation; ``lens``: fx, fy, skew, cx, cy, k1, k2, p1, p2, k3.
    """
    fx, fy, skew, cx, cy, k1, k2, p1, p2, k3 = lens
    distance = np.sqrt((pose[:, 3] ** 2).sum())
    off, J = np.empty(len(points)), np.empty((len(points), _COUNT))
    for i in range(len(points)):
        point, row = points[i], J[i]
        X = pose[0, 0] * point[0] + pose[0, 1] * point[1] + pose[0, 2] * point[2] + pose[0, 3]
        Y = pose[1, 0] * point[0] + pose[1, 1] * point[1] + pose[1, 2] * point[2] + pose[1, 3]
        Z = pose[2, 0] * point[0] + pose[2, 1] * point[1] + pose[2, 2] * point[2] + pose[2, 3]
        x, y = X / Z, Y / Z
        r2 = x * x + y * y
        radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
        xd = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)
        yd = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y
        # A distorted direction moves the residual by these; so do the undistorted, and the point.
        by_xd, by_yd = -normal[i, 0] * fx, -normal[i, 0] * skew - normal[i, 1] * fy
        off[i] = normal[i, 0] * (uv[i, 0] - fx * xd - skew * yd - cx)
        off[i] += normal[i, 1] * (uv[i, 1] - fy * yd - cy)
        slope = 2 * (k1 + r2 * (2 * k2 + 3 * r2 * k3))
        cross = slope * x * y + 2 * p1 * x + 2 * p2 * y
        by_x = by_xd * (radial + slope * x * x + 2 * p1 * y + 6 * p2 * x) + by_yd * cross
        by_y = by_xd * cross + by_yd * (radial + slope * y * y + 6 * p1 * y + 2 * p2 * x)
        by_X, by_Y, by_Z = by_x / Z, by_y / Z, -(by_x * x + by_y * y) / Z
        row[1] = -normal[i, 1] * fy * yd
        row[0] = -normal[i, 0] * fx * xd + row[1]
        row[2], row[3] = -normal[i, 0] * width, -normal[i, 1] * width
        row[4], row[5], row[6] = Y * by_Z - Z * by_Y, Z * by_X - X * by_Z, X * by_Y - Y * by_X
        row[7], row[8], row[9] = distance * by_X, distance * by_Y, distance * by_Z
        row[10] = (by_xd * x + by_yd * y) * r2
        row[11] = row[10] * r2
    return off, J


def residuals_with_jacobian(
    camera: Camera, points_mm: Floats, uv_px: Floats, normal: Floats
) -> tuple[Floats, Floats]:
    """``residuals`` (N,) and their derivatives (N, 12) by a step of ``moved``."""
    K = camera.matrix
    pose = np.column_stack([camera.rotation, camera.translation_mm])
    lens = np.array([K[0, 0], K[1, 1], K[0, 1], K[0, 2], K[1, 2], *camera.distortion])
    return _rows(points_mm, uv_px, normal, pose, lens, float(camera.width_px))


@kernel
def _equations(
    off: Floats, J: Floats, sigma: Floats, chosen: NDArray[np.int64]
) -> tuple[Floats, Floats, float]:
    """``J' W J`` and ``J' W off`` of the chosen columns by Huber's weights, and the scatter."""
    spread = max(1.0, np.median(np.abs(off / sigma)) / 0.6745)
    count = len(chosen)
    N, g = np.zeros((count, count)), np.zeros(count)
    for i in range(len(off)):
        z = abs(off[i]) / sigma[i]
        weight = min(1.0, 2.0 * spread / max(z, 1e-12)) / sigma[i] ** 2
        for p in range(count):
            weighed = weight * J[i, chosen[p]]
            g[p] += weighed * off[i]
            for q in range(p + 1):
                N[p, q] += weighed * J[i, chosen[q]]
    for p in range(count):
        N[:p, p] = N[p, :p]
    return N, g, spread


def fit_edges(
    camera: Camera,
    points_mm: Floats,
    uv_px: Floats,
    normal: Floats,
    sigma_px: Floats,
    free: tuple[int, ...],
    rounds: int = 6,
) -> tuple[Camera, Floats]:
    """Gauss-Newton with Huber's weights of the chosen parameters on edge points.

    Args:
        camera: the start.
        points_mm: (N, 3) points of the edges; uv_px: (N, 2) where the edge was met
            along normal: (N, 2); sigma_px: (N,) standard deviations.
        free: parameters that move, as numbered in this module.

    Returns:
        the camera, and the covariance of its 12 parameters: zero for those held, with
        the a-priori variance factor.
    """
    chosen = np.array(free)
    covariance = np.zeros((_COUNT, _COUNT))
    held = np.array([k for k in range(len(_HELD_STEPS)) if _HELD_STEPS[k] in free], dtype=np.int64)
    for _ in range(rounds):
        off, J = residuals_with_jacobian(camera, points_mm, uv_px, normal)
        normal_matrix, gradient, spread = _equations(off, J, sigma_px, chosen)
        values, sd = _held(camera)
        for k in held:
            at = int(np.flatnonzero(chosen == _HELD_STEPS[k])[0])
            normal_matrix[at, at] += (spread / sd[k]) ** 2
            gradient[at] += values[k] * (spread / sd[k]) ** 2
        scale = 1 / np.sqrt(np.diag(normal_matrix))
        inverse = np.linalg.inv(normal_matrix * np.outer(scale, scale) + 1e-13 * np.eye(len(scale)))
        inverse = inverse * np.outer(scale, scale)
        step = np.zeros(_COUNT)
        step[chosen] = -inverse @ gradient
        step[:10] *= min(1.0, 0.2 / max(float(np.abs(step[:10]).max()), 1e-12))
        camera = moved(camera, step)
        camera = replace(camera, rotation=nearest_rotation(camera.rotation))
        covariance[np.ix_(chosen, chosen)] = inverse
        if float(np.abs(step).max()) < 1e-8:
            break
    return camera, covariance

"""The camera that fits the edge points of the block, with all parameters estimated together."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.robust import sigma_from_median
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.transforms import Floats, nearest_rotation, rotation_from_vector
from crenel.native.arguments import F64, Array, Function, Real
from crenel.native.library import CRENEL

# fx, fy, cx, cy, three rotations, three translations, k1, k2
_COUNT = 12
FOCAL_AND_POSE = (0, 4, 5, 6, 7, 8, 9)
NO_DISTORTION = (0, 1, 2, 3, 4, 5, 6, 7, 8, 9)
WITH_K1 = (*NO_DISTORTION, 10)
WITH_K2 = (*WITH_K1, 11)

_rows = Function(
    CRENEL,
    "edge_rows",
    Array(F64, "n", 3),
    Array(F64, "n", 2),
    Array(F64, "n", 2),
    Array(F64, 3, 4),
    Array(F64, 10),
    Real(),
    Array(F64, "n", written=True),
    Array(F64, "n", _COUNT, written=True),
)


def apply_camera_step(camera: Camera, step: Floats) -> Camera:
    """The camera after a step (12,): focal lengths (relative), principal point (of the width),
    rotation (rad) and translation (of the distance) in the camera frame, k1, k2."""
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


def _camera_prior(camera: Camera) -> tuple[Floats, Floats]:
    """Prior of a lens before any measurement: values (5,) and their standard deviations.

    Square pixels to a thousandth, the axis within a twentieth of the width of the middle, little
    distortion. The prior matters only if the picture contains no information.
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


_PRIOR_STEPS = (1, 2, 3, 10, 11)


def prior_rows(camera: Camera, free: tuple[int, ...]) -> Floats:
    """Prior rows (H, P) of the chosen parameters, over their standard deviations."""
    _, deviations = _camera_prior(camera)
    rows = np.zeros((len(_PRIOR_STEPS), len(free)))
    for row, step in enumerate(_PRIOR_STEPS):
        if step in free:
            rows[row, free.index(step)] = 1 / deviations[row]
    return rows


def residuals(camera: Camera, points_mm: Floats, uv_px: Floats, normal: Floats) -> Floats:
    """Distances (N,) in px, along the normals, between measured and predicted edges."""
    return np.asarray(((uv_px - project(camera, points_mm)) * normal).sum(axis=1))


def residuals_with_jacobian(
    camera: Camera, points_mm: Floats, uv_px: Floats, normal: Floats
) -> tuple[Floats, Floats]:
    """``residuals`` (N,) and their derivatives (N, 12) by a step of ``apply_camera_step``."""
    K = camera.matrix
    pose = np.column_stack([camera.rotation, camera.translation_mm])
    lens = np.array([K[0, 0], K[1, 1], K[0, 1], K[0, 2], K[1, 2], *camera.distortion])
    off, J = np.empty(len(points_mm)), np.empty((len(points_mm), _COUNT))
    _rows(points_mm, uv_px, normal, pose, lens, camera.width_px, off, J)
    return off, J


def _equations(
    off: Floats, J: Floats, sigma: Floats, chosen: NDArray[np.int64]
) -> tuple[Floats, Floats, float]:
    """``J' W J`` and ``J' W off`` of the chosen columns with Huber's weights, and the scatter."""
    z = np.abs(off) / sigma
    spread = max(1.0, sigma_from_median(z))
    weight = np.minimum(1.0, 2.0 * spread / np.maximum(z, 1e-12)) / sigma**2
    A = J[:, chosen]
    weighed = A.T * weight
    return weighed @ A, weighed @ off, spread


def fit_edges(
    camera: Camera,
    points_mm: Floats,
    uv_px: Floats,
    normal: Floats,
    sigma_px: Floats,
    free: tuple[int, ...],
    rounds: int = 6,
) -> tuple[Camera, Floats]:
    """Gauss-Newton with Huber's weights for the chosen parameters on edge points.

    Args:
        camera: start values.
        points_mm: (N, 3) points of the edges; uv_px: (N, 2) measured positions of the edge along
            normal: (N, 2); sigma_px: (N,) standard deviations.
        free: parameters to estimate, as numbered in this module.

    Returns:
        The camera, and the covariance of its 12 parameters: zero for those held, with
        the a-priori variance factor.
    """
    chosen = np.array(free)
    covariance = np.zeros((_COUNT, _COUNT))
    held = np.array(
        [k for k in range(len(_PRIOR_STEPS)) if _PRIOR_STEPS[k] in free], dtype=np.int64
    )
    for _ in range(rounds):
        off, J = residuals_with_jacobian(camera, points_mm, uv_px, normal)
        normal_matrix, gradient, spread = _equations(off, J, sigma_px, chosen)
        values, sd = _camera_prior(camera)
        for k in held:
            at = int(np.flatnonzero(chosen == _PRIOR_STEPS[k])[0])
            normal_matrix[at, at] += (spread / sd[k]) ** 2
            gradient[at] += values[k] * (spread / sd[k]) ** 2
        scale = 1 / np.sqrt(np.diag(normal_matrix))
        inverse = np.linalg.inv(normal_matrix * np.outer(scale, scale) + 1e-13 * np.eye(len(scale)))
        inverse = inverse * np.outer(scale, scale)
        step = np.zeros(_COUNT)
        step[chosen] = -inverse @ gradient
        step[:10] *= min(1.0, 0.2 / max(float(np.abs(step[:10]).max()), 1e-12))
        camera = apply_camera_step(camera, step)
        camera = replace(camera, rotation=nearest_rotation(camera.rotation))
        covariance[np.ix_(chosen, chosen)] = inverse
        if float(np.abs(step).max()) < 1e-8:
            break
    return camera, covariance

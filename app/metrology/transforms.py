"""Rigid transforms between frames, and the best one between two sets of points."""

import numpy as np
from numpy.typing import NDArray

from app.errors import OperationError

# Arrays of float64, of any shape; the shape stands in each docstring.
Floats = NDArray[np.float64]


def rigid(rotation: Floats, translation_mm: Floats) -> Floats:
    """The 4x4 transform of a (3, 3) rotation and a (3,) translation."""
    T = np.eye(4)
    T[:3, :3] = rotation
    T[:3, 3] = translation_mm
    return T


def inverse(T_ab: Floats) -> Floats:
    """``T_ba``, for one (4, 4) or a stack (..., 4, 4) of rigid transforms."""
    rotation_t = np.swapaxes(T_ab[..., :3, :3], -1, -2)
    T_ba = np.zeros_like(T_ab)
    T_ba[..., :3, :3] = rotation_t
    T_ba[..., :3, 3] = -np.einsum("...ij,...j->...i", rotation_t, T_ab[..., :3, 3])
    T_ba[..., 3, 3] = 1.0
    return T_ba


def apply(T_ab: Floats, points_b_mm: Floats) -> Floats:
    """Points (N, 3) of frame b in frame a, by one (4, 4) or N (N, 4, 4) transforms."""
    points: Floats = np.asarray(points_b_mm, dtype=np.float64)
    if T_ab.ndim == 2:
        moved: Floats = points @ T_ab[:3, :3].T + T_ab[:3, 3]
        return moved
    return np.asarray(np.einsum("nij,nj->ni", T_ab[:, :3, :3], points) + T_ab[:, :3, 3])


def skew(vector: Floats) -> Floats:
    """The (3, 3) matrix of the cross product: ``skew(a) @ b == cross(a, b)``."""
    x, y, z = vector
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def rotation_from_vector(vector_rad: Floats) -> Floats:
    """Rodrigues' formula: the (3, 3) rotation by ``|vector|`` rad about the (3,) vector."""
    angle = float(np.linalg.norm(vector_rad))
    K = skew(np.asarray(vector_rad, dtype=np.float64))
    if angle < 1e-9:
        # sin(a)/a and (1-cos a)/a^2 to second order; exact to 1e-18 here
        return np.asarray(np.eye(3) + K + 0.5 * K @ K)
    return np.asarray(
        np.eye(3) + np.sin(angle) / angle * K + (1 - np.cos(angle)) / angle**2 * K @ K
    )


def vector_from_rotation(rotation: Floats) -> Floats:
    """The (..., 3) rotation vectors, angle in [0, pi] rad, of (..., 3, 3) rotations."""
    from scipy.spatial.transform import Rotation  # slow to load, and seldom needed

    return np.asarray(Rotation.from_matrix(rotation).as_rotvec(), dtype=np.float64)


def nearest_rotation(matrix: Floats) -> Floats:
    """The rotation closest to a (3, 3) matrix in the Frobenius norm (SVD)."""
    U, _, Vt = np.linalg.svd(matrix)
    return np.asarray(U @ np.diag([1.0, 1.0, np.linalg.det(U @ Vt)]) @ Vt)


def rigid_fit(points_a_mm: Floats, points_b_mm: Floats, weights: Floats | None = None) -> Floats:
    """``T_ab`` that brings points b closest to points a (Eq. 5 of the paper).

    Args:
        points_a_mm, points_b_mm: (N, 3) conjugated pairs, N >= 3, not on one line.
        weights: (N,) non-negative, or None for equal weights.

    Returns:
        (4, 4) least-squares rigid transform (Kabsch / Umeyama without scale).

    Raises:
        Refusal: fewer than three pairs, or all pairs on one line.
    """
    a: Floats = np.asarray(points_a_mm, dtype=np.float64)
    b: Floats = np.asarray(points_b_mm, dtype=np.float64)
    w: Floats = np.ones(len(a)) if weights is None else np.asarray(weights, dtype=np.float64)
    if len(a) < 3 or len(a) != len(b):
        raise OperationError(
            "too-few-pairs",
            f"a rigid fit was given {len(a)} and {len(b)} points",
            "it needs at least three conjugated pairs",
        )
    centre_a = (w @ a) / w.sum()
    centre_b = (w @ b) / w.sum()
    spread = np.linalg.svd(b - centre_b, compute_uv=False)
    if spread[1] <= 1e-9 * max(spread[0], 1e-300):
        raise OperationError("points-on-a-line", "a rigid fit was given points on one line")
    U, _, Vt = np.linalg.svd((a - centre_a).T @ ((b - centre_b) * w[:, None]))
    rotation = U @ np.diag([1.0, 1.0, np.linalg.det(U @ Vt)]) @ Vt
    return rigid(rotation, centre_a - rotation @ centre_b)

"""Rigid transforms between frames, the best one between two sets of points, and small motions.

A small motion is a twist ``(rx, ry, rz, tx, ty, tz)`` in rad and mm. A left twist of ``T_ab``
changes it to ``se3_exp(twist) @ T_ab``: a rotation about the origin of frame a, then a translation.
"""

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.message import message

# Arrays of float64, of any shape; docstrings state the shape.
Floats = NDArray[np.float64]


def rigid(rotation: Floats, translation_mm: Floats) -> Floats:
    """The homogeneous transform of a rotation and a translation.

    Args:
        rotation: (3, 3) of ``T_ab``, from frame b to frame a.
        translation_mm: (3,) origin of frame b in frame a.

    Returns:
        (4, 4) ``T_ab``.

    Example:
        >>> rigid(np.eye(3), np.array([1.0, 2.0, 3.0]))[:3, 3].tolist()
        [1.0, 2.0, 3.0]
    """
    T = np.eye(4)
    T[:3, :3] = rotation
    T[:3, 3] = translation_mm
    return T


def inverse(T_ab: Floats) -> Floats:
    """``T_ba`` of ``T_ab``, by the transpose of the rotation.

    Args:
        T_ab: (4, 4), or a stack (..., 4, 4), of rigid transforms; not checked for rigidity.

    Returns:
        ``T_ba``, of the shape of ``T_ab``.

    Example:
        >>> T_ab = rigid(rotation_from_vector(np.array([0.0, 0.0, np.pi / 2])), np.ones(3))
        >>> np.allclose(inverse(T_ab) @ T_ab, np.eye(4))
        True
    """
    rotation_t = np.swapaxes(T_ab[..., :3, :3], -1, -2)
    T_ba = np.zeros_like(T_ab)
    T_ba[..., :3, :3] = rotation_t
    T_ba[..., :3, 3] = -np.einsum("...ij,...j->...i", rotation_t, T_ab[..., :3, 3])
    T_ba[..., 3, 3] = 1.0
    return T_ba


def apply(T_ab: Floats, points_b_mm: Floats) -> Floats:
    """Points of frame b, expressed in frame a.

    Args:
        T_ab: (4, 4) for all points, or (N, 4, 4), one transform for each point.
        points_b_mm: (N, 3).

    Returns:
        (N, 3) mm in frame a.

    Example:
        >>> T_ab = rigid(np.eye(3), np.array([0.0, 0.0, 5.0]))
        >>> apply(T_ab, np.array([[1.0, 2.0, 3.0]])).tolist()
        [[1.0, 2.0, 8.0]]
    """
    points: Floats = np.asarray(points_b_mm, dtype=np.float64)
    if T_ab.ndim == 2:
        moved: Floats = points @ T_ab[:3, :3].T + T_ab[:3, 3]
        return moved
    return np.asarray(np.einsum("nij,nj->ni", T_ab[:, :3, :3], points) + T_ab[:, :3, 3])


def skew(vector: Floats) -> Floats:
    """The matrix of the cross product: ``skew(a) @ b == cross(a, b)``.

    Args:
        vector: (3,).

    Returns:
        (3, 3), antisymmetric.
    """
    x, y, z = vector
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def skews(vectors: Floats) -> Floats:
    """``skew`` of many vectors (N, 3) at once, (N, 3, 3)."""
    x, y, z = vectors.T
    zero = np.zeros(len(vectors))
    rows = [[zero, -z, y], [z, zero, -x], [-y, x, zero]]
    return np.asarray(np.moveaxis(np.array(rows), 2, 0))


def rotation_from_vector(vector_rad: Floats) -> Floats:
    """The rotation by ``|vector_rad|`` about the direction of a vector.

    Args:
        vector_rad: (3,) rotation vector; a zero vector gives the identity.

    Returns:
        (3, 3) rotation.

    Source:
        Rodrigues' formula.

    Example:
        >>> R = rotation_from_vector(np.array([0.0, 0.0, np.pi / 2]))
        >>> (R @ [1.0, 0.0, 0.0]).round(12).tolist()
        [0.0, 1.0, 0.0]
    """
    angle = float(np.linalg.norm(vector_rad))
    K = skew(np.asarray(vector_rad, dtype=np.float64))
    if angle < 1e-9:
        # sin(a)/a and (1-cos a)/a^2 to second order; exact to 1e-18 here
        return np.asarray(np.eye(3) + K + 0.5 * K @ K)
    return np.asarray(
        np.eye(3) + np.sin(angle) / angle * K + (1 - np.cos(angle)) / angle**2 * K @ K
    )


def rotations_from_vectors(vectors_rad: Floats) -> Floats:
    """``rotation_from_vector`` of many vectors (..., 3) at once, (..., 3, 3)."""
    from scipy.spatial.transform import Rotation  # slow to import

    turns = Rotation.from_rotvec(vectors_rad.reshape(-1, 3)).as_matrix()
    return np.asarray(turns, dtype=np.float64).reshape(*vectors_rad.shape, 3)


def vector_from_rotation(rotation: Floats) -> Floats:
    """The rotation vector of a rotation; inverse of ``rotation_from_vector``.

    Args:
        rotation: (..., 3, 3).

    Returns:
        (..., 3) rad, each of length 0 to pi.

    Example:
        >>> vector = np.array([0.1, -0.2, 0.3])
        >>> np.allclose(vector_from_rotation(rotation_from_vector(vector)), vector)
        True
    """
    from scipy.spatial.transform import Rotation  # slow to import, and seldom needed

    # older releases of SciPy know one stack only
    vectors = Rotation.from_matrix(rotation.reshape(-1, 3, 3)).as_rotvec()
    return np.asarray(vectors, dtype=np.float64).reshape(rotation.shape[:-1])


def nearest_rotation(matrix: Floats) -> Floats:
    """The rotation closest to a matrix in the Frobenius norm.

    Args:
        matrix: (..., 3, 3), for example a mean of rotations.

    Returns:
        (..., 3, 3) rotation, determinant +1.

    Source:
        The orthogonal Procrustes problem, by singular values.
    """
    U, _, Vt = np.linalg.svd(matrix)
    U[..., 2] *= np.linalg.det(U @ Vt)[..., None]
    return np.asarray(U @ Vt)


def rigid_fit(points_a_mm: Floats, points_b_mm: Floats, weights: Floats | None = None) -> Floats:
    """``T_ab`` that brings points b closest to points a (Eq. 5).

    Args:
        points_a_mm, points_b_mm: (N, 3) conjugated pairs, N >= 3, not on one line.
        weights: (N,) non-negative, or None for equal weights.

    Returns:
        (4, 4) weighted least-squares rigid transform.

    Raises:
        OperationError: ``too-few-pairs``, or arrays of different length;
            ``points-on-a-line``.

    Source:
        Kabsch (1976), Umeyama (1991) without scale.

    Example:
        >>> b = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
        >>> rigid_fit(b + [0.0, 0.0, 2.0], b)[:3, 3].round(12).tolist()
        [0.0, 0.0, 2.0]
    """
    a: Floats = np.asarray(points_a_mm, dtype=np.float64)
    b: Floats = np.asarray(points_b_mm, dtype=np.float64)
    if len(a) < 3 or len(a) != len(b):
        raise OperationError(
            "too-few-pairs",
            message("rigid-fit-given-points", a=len(a), b=len(b)),
            message("needs-least-three-conjugated-pairs"),
        )
    w = None if weights is None else np.asarray(weights, dtype=np.float64)[None]
    T = rigid_fits(a[None], b[None], w)[0]
    if np.isnan(T).any():
        raise OperationError("points-on-a-line", message("rigid-fit-given-points-one-line"))
    return np.asarray(T)


def rigid_fits(points_a_mm: Floats, points_b_mm: Floats, weights: Floats | None = None) -> Floats:
    """``T_ab`` of many sets of conjugated pairs at once, as ``rigid_fit`` finds each.

    Args:
        points_a_mm, points_b_mm: (S, N, 3) sets of N >= 3 pairs.
        weights: (S, N) non-negative, or None for equal weights.

    Returns:
        (S, 4, 4) transforms, NaN where the points b of a set lie on one line.
    """
    w = np.ones(points_a_mm.shape[:2]) if weights is None else weights
    w = w[:, :, None]
    centres_a, centres_b = (
        np.sum(w * points, axis=1) / w.sum(axis=1) for points in (points_a_mm, points_b_mm)
    )
    a, b = points_a_mm - centres_a[:, None], points_b_mm - centres_b[:, None]
    spread = np.linalg.svd(b, compute_uv=False)
    rotations = nearest_rotation(a.mT @ (b * w))
    rotations[spread[:, 1] <= 1e-9 * np.maximum(spread[:, 0], 1e-300)] = np.nan
    T = np.tile(np.eye(4), (len(a), 1, 1))
    T[:, :3, :3] = rotations
    T[:, :3, 3] = centres_a - np.einsum("sij,sj->si", rotations, centres_b)
    return T


def se3_exp(twist: Floats) -> Floats:
    """The (4, 4) transform of a twist (6,)."""
    return rigid(rotation_from_vector(twist[:3]), twist[3:])


def adjoint(T_ab: Floats) -> Floats:
    """(..., 6, 6): converts a small twist in frame b to frame a (the adjoint of ``T_ab``), of one
    transform or of a stack."""
    R = T_ab[..., :3, :3]
    matrix = np.zeros((*T_ab.shape[:-2], 6, 6))
    matrix[..., :3, :3] = matrix[..., 3:, 3:] = R
    lever = skew(T_ab[:3, 3]) if T_ab.ndim == 2 else skews(T_ab[..., :3, 3].reshape(-1, 3))
    matrix[..., 3:, :3] = lever.reshape(R.shape) @ R
    return matrix


def adjoint_inverse(T_ab: Floats) -> Floats:
    """(6, 6): converts a small twist in frame a to frame b."""
    return adjoint(inverse(T_ab))


def pivot_adjoint(pivot_mm: Floats) -> Floats:
    """(6, 6): converts a twist about a pivot (3,) to one about the origin."""
    matrix = np.eye(6)
    matrix[3:, :3] = skew(pivot_mm)
    return matrix

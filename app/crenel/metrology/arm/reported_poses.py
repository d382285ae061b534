"""Poses that an arm reports as seven numbers: position in mm, and a quaternion (x, y, z, w).

Such a row stands for ``T_arm_flange``. A quaternion and its negative are the same rotation.
"""

from typing import Literal

import numpy as np

from crenel.metrology.transforms import Floats

POSE_SIZE = 7
ReadingKind = Literal["joints", "pose"]
"""What an arm reports: encoder angles (n,) in rad, or a pose (7,)."""


def transforms_from_poses(poses: Floats) -> Floats:
    """``T_arm_flange`` of reported poses.

    Args:
        poses: (N, 7) position in mm and quaternion x, y, z, w, which is normalised.

    Returns:
        (N, 4, 4).

    Example:
        >>> turned = [10.0, 0.0, 0.0, 0.0, 0.0, np.sqrt(0.5), np.sqrt(0.5)]
        >>> transforms_from_poses(np.array([turned]))[0, :, 3].tolist()
        [10.0, 0.0, 0.0, 1.0]
    """
    rows = np.asarray(poses, dtype=np.float64)
    x, y, z, w = (rows[:, 3:] / np.linalg.norm(rows[:, 3:], axis=1, keepdims=True)).T
    T = np.zeros((len(rows), 4, 4))
    T[:, 0, 0], T[:, 0, 1], T[:, 0, 2] = (
        1 - 2 * (y * y + z * z),
        2 * (x * y - z * w),
        2 * (x * z + y * w),
    )
    T[:, 1, 0], T[:, 1, 1], T[:, 1, 2] = (
        2 * (x * y + z * w),
        1 - 2 * (x * x + z * z),
        2 * (y * z - x * w),
    )
    T[:, 2, 0], T[:, 2, 1], T[:, 2, 2] = (
        2 * (x * z - y * w),
        2 * (y * z + x * w),
        1 - 2 * (x * x + y * y),
    )
    T[:, :3, 3] = rows[:, :3]
    T[:, 3, 3] = 1.0
    return T


def pose_from_transform(T_arm_flange: Floats) -> Floats:
    """The pose (7,) of a transform (4, 4); its quaternion has w >= 0."""
    from scipy.spatial.transform import Rotation  # slow to import; most arms have angles

    quaternion = Rotation.from_matrix(T_arm_flange[:3, :3]).as_quat(canonical=True)
    return np.concatenate([T_arm_flange[:3, 3], quaternion])


def blend_poses(before: Floats, after: Floats, share: Floats) -> Floats:
    """Poses between pairs of poses: straight in position, spherical in rotation.

    Args:
        before, after: (N, 7).
        share: (N,) from 0 (before) to 1 (after).

    Returns:
        (N, 7) with unit quaternions.

    Source:
        Shoemake, "Animating rotation with quaternion curves", SIGGRAPH 1985 (slerp).

    Example:
        >>> straight = np.array([[0.0, 0, 0, 0, 0, 0, 1]])
        >>> turned = np.array([[8.0, 0, 0, 0, 0, 1, 0]])
        >>> blend_poses(straight, turned, np.array([0.5])).round(3).tolist()
        [[4.0, 0.0, 0.0, 0.0, 0.0, 0.707, 0.707]]
    """
    a, b, t = before[:, 3:], _nearer_sign(after[:, 3:], before[:, 3:]), share[:, None]
    half_turn_rad = 2 * np.arctan2(
        np.linalg.norm(b - a, axis=1, keepdims=True), np.linalg.norm(b + a, axis=1, keepdims=True)
    )
    # sin(t x) / sin(x) by sinc, which is exact for equal rotations too
    scale = np.sinc(half_turn_rad / np.pi)
    quaternion = (
        (1 - t) * np.sinc((1 - t) * half_turn_rad / np.pi) * a
        + t * np.sinc(t * half_turn_rad / np.pi) * b
    ) / scale
    quaternion /= np.linalg.norm(quaternion, axis=1, keepdims=True)
    position = (1 - t) * before[:, :3] + t * after[:, :3]
    return np.hstack([position, quaternion])


def pose_differences(poses: Floats, reference: Floats) -> Floats:
    """(N, 7) differences of poses (N, 7) from one (7,), each quaternion with the nearer sign."""
    quaternions = _nearer_sign(poses[:, 3:], reference[None, 3:])
    return np.hstack([poses[:, :3], quaternions]) - reference


def mean_pose(poses: Floats) -> Floats:
    """The mean (7,) of poses (N, 7) that differ little.

    The mean quaternion is the normalised sum, which for rotations within a degree equals the
    rotation of least squares to 1e-9 rad.
    """
    mean = poses[0] + pose_differences(poses, poses[0]).mean(axis=0)
    mean[3:] /= np.linalg.norm(mean[3:])
    return np.asarray(mean)


def _nearer_sign(quaternions: Floats, to: Floats) -> Floats:
    return np.where((quaternions * to).sum(axis=1, keepdims=True) < 0, -quaternions, quaternions)

"""The arm's readings between its samples, and their mean."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.arm.reported_poses import (
    ReadingKind,
    blend_poses,
    mean_pose,
    pose_differences,
)
from crenel.metrology.transforms import Floats

Stamps = NDArray[np.int64]


def interpolate_readings(
    kind: ReadingKind, stamps_ns: Stamps, readings: Floats, wanted_ns: Stamps, gap_limit_ns: int
) -> Floats:
    """Readings at given times, interpolated between the adjacent samples.

    A joint that passes half a turn is followed along the shorter way; the rotation of a pose is
    interpolated spherically.

    Args:
        stamps_ns: (N,) increasing time stamps of the samples.
        readings: (N, k) of this kind.
        wanted_ns: (F,) times, in any order.
        gap_limit_ns: no interpolation between samples further apart than this.

    Returns:
        (F, k); NaN outside the samples, and in gaps.

    Example:
        >>> stamps, q = np.array([0, 10]), np.array([[3.1], [-3.1]])
        >>> interpolate_readings("joints", stamps, q, np.array([0, 5, 20]), 10).round(3).tolist()
        [[3.1], [3.142], [nan]]
    """
    blend: Callable[[Floats, Floats, Floats], Floats]
    blend = blend_poses if kind == "pose" else _blend_angles
    found = np.full((len(wanted_ns), readings.shape[1]), np.nan)
    if not len(stamps_ns):
        return found
    after = np.minimum(np.searchsorted(stamps_ns, wanted_ns), len(stamps_ns) - 1)
    before = np.maximum(after - 1, 0)
    exact = stamps_ns[after] == wanted_ns
    gap_ns = stamps_ns[after] - stamps_ns[before]
    inside = (stamps_ns[before] < wanted_ns) & (wanted_ns < stamps_ns[after])
    inside &= gap_ns <= gap_limit_ns
    found[exact] = readings[after[exact]]
    a, b = before[inside], after[inside]
    share = (wanted_ns[inside] - stamps_ns[a]) / gap_ns[inside]
    found[inside] = blend(readings[a], readings[b], share)
    return found


def mean_reading(kind: ReadingKind, readings: Floats) -> Floats:
    """The mean (k,) of readings (N, k) that differ little."""
    if kind == "pose":
        return mean_pose(readings)
    return np.asarray(readings[0] + reading_differences(kind, readings).mean(axis=0))


def reading_differences(kind: ReadingKind, readings: Floats) -> Floats:
    """(N, k) differences of readings (N, k) from the first: shortest turns of joints, or
    differences of poses with the nearer sign of the quaternion."""
    if kind == "pose":
        return pose_differences(readings, readings[0])
    return shortest_turn(readings - readings[0])


def shortest_turn(difference_rad: Floats) -> Floats:
    """The shortest rotation for a difference of angles, because encoders roll over.

    Args:
        difference_rad: of any shape.

    Returns:
        Of the same shape, in [-pi, pi).

    Example:
        >>> round(float(shortest_turn(np.array(6.2))), 4)
        -0.0832
    """
    return np.asarray((difference_rad + np.pi) % (2 * np.pi) - np.pi)


def _blend_angles(before: Floats, after: Floats, share: Floats) -> Floats:
    return np.asarray(before + share[:, None] * shortest_turn(after - before))

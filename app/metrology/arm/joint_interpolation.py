"""The arm's joint angles between its samples."""

import numpy as np
from numpy.typing import NDArray

from app.metrology.transforms import Floats

Stamps = NDArray[np.int64]


def interpolate_angles(
    stamps_ns: Stamps, q_rad: Floats, wanted_ns: Stamps, gap_limit_ns: int
) -> Floats:
    """Joint angles at given times, linearly interpolated between the adjacent samples.

    A joint that passes half a turn is followed along the shorter way.

    Args:
        stamps_ns: (N,) increasing time stamps of the samples.
        q_rad: (N, n) their encoder angles.
        wanted_ns: (F,) times, in any order.
        gap_limit_ns: no interpolation between samples further apart than this.

    Returns:
        (F, n) rad; NaN outside the samples, and in gaps.

    Example:
        >>> stamps, q = np.array([0, 10]), np.array([[3.1], [-3.1]])
        >>> interpolate_angles(stamps, q, np.array([0, 5, 20]), 10).round(3).tolist()
        [[3.1], [3.142], [nan]]
    """
    found = np.full((len(wanted_ns), q_rad.shape[1]), np.nan)
    if not len(stamps_ns):
        return found
    after = np.minimum(np.searchsorted(stamps_ns, wanted_ns), len(stamps_ns) - 1)
    before = np.maximum(after - 1, 0)
    exact = stamps_ns[after] == wanted_ns
    gap_ns = stamps_ns[after] - stamps_ns[before]
    inside = (stamps_ns[before] < wanted_ns) & (wanted_ns < stamps_ns[after])
    inside &= gap_ns <= gap_limit_ns
    found[exact] = q_rad[after[exact]]
    a, b = before[inside], after[inside]
    share = (wanted_ns[inside] - stamps_ns[a]) / gap_ns[inside]
    found[inside] = q_rad[a] + share[:, None] * shortest_turn(q_rad[b] - q_rad[a])
    return found


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

"""Which corners of a grid are those of a board of known size.

An outline, a shadow or a pattern beside the board adds corners to its grid; light and fingers
take some away. The board is where a window of its size holds nearly all of them, if no other
window does.
"""

import numpy as np
from numpy.typing import NDArray

# What another window may hold that the chosen one lacks, of what it lacks itself.
RIVAL_SHARE = 0.25
# Corners seen on each side of the pattern: at least, and of a side where others lie beyond.
LEAST_ON_A_SIDE, SHARE_ON_A_SIDE = 2, 0.6


def find_window(
    places: NDArray[np.int64], inner_corners: tuple[int, int]
) -> NDArray[np.bool_] | None:
    """The corners within the one window of the board's size.

    Args:
        places: (N, 2) column and row of the corners found, counted from anywhere.
        inner_corners: columns and rows of the board, whichever way it lies.

    Returns:
        (N,) which belong to the board; None where no window is certain.
    """
    if not len(places):
        return None
    windows: list[NDArray[np.bool_]] = []
    low, high = places.min(axis=0), places.max(axis=0)
    for size in sorted({inner_corners, inner_corners[::-1]}):
        for i in range(low[0], high[0] - size[0] + 2):
            for j in range(low[1], high[1] - size[1] + 2):
                origin = np.array([i, j])
                within = (places >= origin) & (places < origin + np.array(size))
                windows.append(within.all(axis=1))
    if not windows:
        return None
    best = max(windows, key=lambda one: int(one.sum()))
    for other in windows:
        lost, gained = int((best & ~other).sum()), int((other & ~best).sum())
        if other is not best and gained >= max(1.0, RIVAL_SHARE * lost):
            return None
    return best if _has_all_sides(places, best, inner_corners) else None


def _has_all_sides(
    places: NDArray[np.int64], within: NDArray[np.bool_], inner_corners: tuple[int, int]
) -> bool:
    """Whether corners on each side show that the window ends there."""
    inside, outside = places[within], places[~within]
    low, high = inside.min(axis=0), inside.max(axis=0)
    if sorted(high - low + 1) != sorted(inner_corners):
        return False
    for axis in (0, 1):
        length = int(high[1 - axis] - low[1 - axis] + 1)
        beyond = bool(((outside[:, axis] < low[axis]) | (outside[:, axis] > high[axis])).any())
        least = max(LEAST_ON_A_SIDE, SHARE_ON_A_SIDE * length) if beyond else LEAST_ON_A_SIDE
        for end in (low[axis], high[axis]):
            if int((inside[:, axis] == end).sum()) < least:
                return False
    return True

"""The straight piece of a laser line: what the laser shows beside the board is no part of it."""

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.robust import median
from crenel.metrology.transforms import Floats

DRAWS = 60
AGREEING_TIMES = 4.0
"""Points of the line are at most this multiple of the median distance away from it."""


def mask_straight_piece(points_mm: Floats, least_mm: float) -> NDArray[np.bool_]:
    """Which points lie on the straight line that most of them agree on.

    The line is that of the least median distance, among lines through two points. A table behind
    the board shows pieces of the laser's line, too; on the plane of the board, they are beside it.

    Args:
        points_mm: (N, 3) on the board, of one picture.
        least_mm: points that are nearer to the line always belong to it.

    Returns:
        (N,) mask.
    """
    if len(points_mm) < 2:
        return np.ones(len(points_mm), dtype=bool)
    rng = np.random.default_rng(0)
    nearest, least = np.zeros(len(points_mm)), np.inf
    for _ in range(DRAWS):
        a, b = points_mm[rng.choice(len(points_mm), 2, replace=False)]
        length = float(np.linalg.norm(b - a))
        if length < 1e-6:
            continue
        away = np.linalg.norm(np.cross(points_mm - a, (b - a) / length), axis=1)
        if (score := median(away)) < least:
            nearest, least = away, score
    return np.asarray(nearest <= max(AGREEING_TIMES * least, least_mm))

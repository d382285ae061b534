"""The cheapest path of a delay through the frames of a pass."""

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats

JUMP_CELLS = 3
"""A path that changes by as much from one frame to the next has jumped."""
UNKNOWN_COST = 3.0
"""The cost of a frame without a pose of the arm at a delay: less than that of one far from the
plane."""
SLIP_COST, JUMP_COST = 9.0, 72.0
"""The costs of a path to the adjacent cell, and to any other: as much as eight frames far from the
plane."""
DISTANCE_COST = 0.02
"""The cost of the longest delay: of delays that fit as well, for a movement that repeats itself,
the smaller one is the likelier."""


def cheapest_path(costs: Floats) -> tuple[NDArray[np.int64], float]:
    """The path with the least sum of costs (dynamic programming).

    Args:
        costs: (F, C) of each frame in each cell of the delay; the middle one is no delay.

    Returns:
        (F,) cell of each frame, and the cost for each frame.

    Source:
        Viterbi, "Error bounds for convolutional codes" (1967).

    Example:
        >>> costs = np.full((20, 7), 9.0)
        >>> costs[:10, 0] = costs[10:, 6] = 0.0
        >>> cheapest_path(costs)[0].tolist() == 10 * [0] + 10 * [6]
        True
    """
    frames, cells = costs.shape
    costs = costs + DISTANCE_COST * np.abs(np.linspace(-1, 1, cells))
    came = np.empty((frames, cells), dtype=np.int32)
    places = np.arange(cells, dtype=np.int32)
    total = costs[0].copy()
    for frame in range(1, frames):
        source, least = places.copy(), total.copy()
        for step in (-1, 1):
            slipped = np.full(cells, np.inf)
            slipped[max(step, 0) : cells + min(step, 0)] = total[
                max(-step, 0) : cells - max(step, 0)
            ]
            slipped += SLIP_COST
            better = slipped < least
            least[better], source[better] = slipped[better], places[better] - step
        best = int(np.argmin(total))
        jumped = least > total[best] + JUMP_COST
        least[jumped], source[jumped] = total[best] + JUMP_COST, best
        came[frame], total = source, least + costs[frame]
    path = np.empty(frames, dtype=np.int64)
    path[-1] = np.argmin(total)
    for frame in range(frames - 1, 0, -1):
        path[frame - 1] = came[frame, path[frame]]
    return path, float(total.min()) / frames

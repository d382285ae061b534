"""The best path across the columns of a picture, by dynamic programming."""

import numpy as np
from numpy.typing import NDArray

STEEPEST_PX = 4
STEP_COST, JUMP_COST = 0.3, 15.0


def best_path(score: NDArray[np.float32]) -> NDArray[np.int64]:
    """The row of every column (W,) on the path of the highest sum.

    Args:
        score: (H, W).
    """
    height, width = score.shape
    columns = np.ascontiguousarray(score.T, dtype=np.float32)
    came = np.empty((width, height), np.int32)
    total = columns[0].copy()
    rows = np.arange(height, dtype=np.int32)
    padded = np.full(height + 2 * STEEPEST_PX, -np.inf, np.float32)
    for column in range(width):
        if column == 0:
            continue
        padded[STEEPEST_PX:-STEEPEST_PX] = total
        highest = int(total.argmax())
        best = np.full(height, total[highest] - JUMP_COST, np.float32)
        source = np.full(height, highest, np.int32)
        for step in range(-STEEPEST_PX, STEEPEST_PX + 1):
            moved = padded[STEEPEST_PX + step : STEEPEST_PX + step + height] - STEP_COST * abs(step)
            better = moved > best
            best = np.where(better, moved, best)
            source = np.where(better, rows + step, source)
        came[column] = source
        total = best + columns[column]
    path = np.empty(width, np.int64)
    path[-1] = int(total.argmax())
    for column in range(width - 1, 0, -1):
        path[column - 1] = came[column, path[column]]
    return path

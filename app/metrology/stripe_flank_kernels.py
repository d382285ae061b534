"""The inner loops that find the clipped core of an overexposed laser line."""

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import kernel

# Clipped runs kept in a column, their widths in px, and unclipped pixels that break none.
RUNS = 6
NARROWEST, WIDEST = 5, 64
BREAK = 2
# Columns that a track may skip, and rows by which it may climb from one column to the next.
SKIP, STEEPEST = 3, 4.0


@kernel
def clipped_runs(
    image: NDArray[np.integer],
    saturated: float,
    first: NDArray[np.int64],
    last: NDArray[np.int64],
) -> None:
    """First and last row of the clipped runs of every column, into (W, RUNS); -1 for none."""
    height, width = image.shape
    begun = np.full(width, -1, dtype=np.int64)
    ended = np.full(width, -1, dtype=np.int64)
    kept = np.zeros(width, dtype=np.int64)
    for r in range(height + BREAK + 2):
        for i in range(width):
            lit = r < height and image[r, i] >= saturated
            if lit:
                if begun[i] < 0:
                    begun[i] = r
                ended[i] = r
            elif begun[i] >= 0 and r - ended[i] > BREAK:
                if NARROWEST <= ended[i] - begun[i] + 1 <= WIDEST and kept[i] < RUNS:
                    first[i, kept[i]] = begun[i]
                    last[i, kept[i]] = ended[i]
                    kept[i] += 1
                begun[i] = -1


@kernel
def link(first: NDArray[np.int64], last: NDArray[np.int64], track: NDArray[np.int64]) -> None:
    """Numbers the runs (W, RUNS) so that those that follow one another share a track."""
    width, runs = first.shape
    tracks = 0
    for i in range(width):
        for k in range(runs):
            if first[i, k] < 0:
                continue
            middle = 0.5 * (first[i, k] + last[i, k])
            nearest = np.inf
            for back in range(1, min(SKIP, i) + 1):
                for j in range(runs):
                    if first[i - back, j] < 0:
                        continue
                    climb = abs(middle - 0.5 * (first[i - back, j] + last[i - back, j]))
                    if climb <= STEEPEST * back and climb < nearest:
                        nearest = climb
                        track[i, k] = track[i - back, j]
                if nearest < np.inf:
                    break
            if track[i, k] < 0:
                track[i, k] = tracks
                tracks += 1

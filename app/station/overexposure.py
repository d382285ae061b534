"""Where a picture is saturated, to be drawn on it."""

import numpy as np

from app.metrology.detection.picture import Image
from app.metrology.image import saturation_level

CELL_PX = 16
# So many clipped pixels make a cell: a hot pixel or two do not.
LEAST = 6
MOST_BOXES = 300
Box = tuple[int, int, int, int]
"""Left, top, width, height in pixels."""


def saturation(image: Image) -> tuple[float, tuple[Box, ...]]:
    """The share of saturated pixels in percent, and the places as boxes, joined along rows."""
    clipped = image >= saturation_level(image)
    count = int(np.count_nonzero(clipped))
    percent = 100.0 * count / image.size
    if count < LEAST:
        return percent, ()
    rows, columns = (size // CELL_PX for size in image.shape)
    whole = clipped[: rows * CELL_PX, : columns * CELL_PX]
    cells = whole.reshape(rows, CELL_PX, columns, CELL_PX).sum(axis=(1, 3)) >= LEAST
    edges = np.diff(cells.astype(np.int8), axis=1, prepend=0, append=0)
    starts, ends = np.argwhere(edges == 1), np.argwhere(edges == -1)
    boxes = [
        (int(left) * CELL_PX, int(row) * CELL_PX, int(right - left) * CELL_PX, CELL_PX)
        for (row, left), (_, right) in zip(starts, ends, strict=True)
    ]
    return percent, tuple(boxes[:MOST_BOXES])

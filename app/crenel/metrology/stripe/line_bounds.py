"""Where in the picture of a calibrated sensor the laser's line can be."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.stripe.scales import height_at

SURROUNDINGS_ROWS = 14
"""Rows beyond the line that the search of a peak needs, as in ``tracking.c``; where several rows
are made one, they would be too many, and bounds reach far enough beyond the line."""
LEAST_ROWS = 40


@dataclass(frozen=True, eq=False)
class LineBounds:
    """Rows in which the line can be, for blocks of columns of a picture that is turned so that the
    line crosses its columns.

    ``first``, ``behind``: (B,) the first row of each block and the one after the last; alike where
    the line crosses none of its columns. ``height``, ``width``: of the turned picture. ``axis``: as
    in ``extract_stripe``.
    """

    first: NDArray[np.int64]
    behind: NDArray[np.int64]
    block_px: int
    height: int
    width: int
    axis: str

    @property
    def size_px(self) -> tuple[int, int]:
        """Width and height of the picture as it was taken."""
        return (self.width, self.height) if self.axis == "u" else (self.height, self.width)

    def fits(self, shape: tuple[int, ...], axis: str) -> bool:
        """Whether they are of a turned picture (H, W) of this shape, and of lines along it."""
        return shape == (self.height, self.width) and axis == self.axis

    def parts(self, factor: float = 1.0) -> NDArray[np.int64]:
        """(n, 4) first row and the one after the last, first column and the one after the last, of
        the parts of the picture with ``factor`` rows made one that may show the line."""
        rows = height_at(self.height, factor)
        everything = np.array([[0, rows, 0, self.width]], np.int64)
        return self.clip(everything, factor)

    def clip(self, parts: NDArray[np.int64], factor: float = 1.0) -> NDArray[np.int64]:
        """What lies within the bounds of parts (n, 4) of the picture at a scale; the parts
        themselves where hardly anything does."""
        rows = height_at(self.height, factor)
        more = SURROUNDINGS_ROWS if factor == 1 else 0
        found: list[tuple[int, int, int, int]] = []
        for top, bottom, left, right in parts.tolist():
            blocks = range(left // self.block_px, -(-right // self.block_px))
            for block in blocks:
                first, behind = int(self.first[block]), int(self.behind[block])
                if behind <= first:
                    continue
                low = max(top, math.floor(first / factor) - more)
                high = min(bottom, math.ceil(behind / factor) + more, rows)
                begin = max(left, block * self.block_px)
                end = min(right, (block + 1) * self.block_px)
                if high - low < LEAST_ROWS:
                    continue
                if found and found[-1][:2] == (low, high) and found[-1][3] == begin:
                    begin = found.pop()[2]
                found.append((low, high, begin, end))
        return np.array(found, np.int64) if found else parts

    def where(self) -> NDArray[np.bool_]:
        """(H, W) pixels of the picture as it was taken in which the line can be."""
        allowed = np.zeros((self.height, self.width), np.bool_)
        for block, (first, behind) in enumerate(zip(self.first, self.behind, strict=True)):
            allowed[first:behind, block * self.block_px : (block + 1) * self.block_px] = True
        return allowed if self.axis == "u" else allowed.T

    def of_cells(self, cell_px: int) -> "LineBounds":
        """Those of the picture in which so many pixels of a side are one."""
        return LineBounds(
            self.first // cell_px,
            -(-self.behind // cell_px),
            self.block_px // cell_px,
            self.height // cell_px,
            self.width // cell_px,
            self.axis,
        )

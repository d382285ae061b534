"""Thins points for the display, finer or coarser without processing any of them again.

Space is divided into cubes, eight of which form one of the next larger size, and so on. A point is
shown if it is the first of its smallest cube, and belongs to the largest cube of which it is the
first. All points of one size can therefore be removed together, and the first point of each larger
cube remains, as if there had never been smaller ones. Every other cube is removed first, which
leaves a chequered pattern: the steps between two sizes are halves.
"""

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats
from crenel.native.arguments import F64, I8, I64, Array, Function, Integer, Real
from crenel.native.library import CRENEL

Tiers = NDArray[np.int8]
"""(N,) tier of each point: 2 n, or 2 n + 1 for the cubes that stay one step longer, for cubes of
2^n times the first size; -1 if it is not shown."""

SIZES = 16
_FIRST_SLOTS = 1 << 14
# A table that has grown is filled in portions of this size.
_COPIED_SLOTS = 1 << 16

# Cubes are stored as bits of bricks of 4 x 4 x 4; a slot of a table has the key of a brick, or 0,
# and its bits. Cubes have 21 bits per axis: with 0.1 mm, that is 200 m.
_take_points = Function(
    CRENEL,
    "take_points",
    Array(F64, "n", 3),
    Real(),
    Integer(),
    Array(I64, "slots", 2, written=True),
    Array(I64, "old_slots", 2),
    Array(I64, SIZES, written=True),
    Integer(),
    Array(I8, "n", written=True),
    returns=int,
)
_copy_bricks = Function(
    CRENEL,
    "copy_bricks",
    Array(I64, "old_slots", 2),
    Integer(),
    Array(I64, "slots", 2, written=True),
)

_NO_SLOTS = np.zeros((1, 2), dtype=np.int64)


class Voxels:
    """Stores which cubes of space already show a point."""

    def __init__(self, first_mm: float) -> None:
        self.finest = 0
        """The lowest tier that is shown."""
        self._first_mm = first_mm
        self._counts = np.zeros(2 * SIZES, dtype=np.int64)
        self._bricks = np.zeros(SIZES, dtype=np.int64)
        self._slots = np.zeros((_FIRST_SLOTS, 2), dtype=np.int64)
        self._old, self._copied = _NO_SLOTS, 0

    @property
    def size_mm(self) -> float:
        """Approximate distance between the shown points of a surface."""
        return self._first_mm * float(2.0 ** (self.finest / 2))

    @property
    def count(self) -> int:
        """Number of points shown."""
        return int(self._counts[self.finest :].sum())

    def take(self, points_mm: Floats) -> Tiers:
        """Tiers of the points (N, 3); points that are shown are no longer new."""
        points = np.ascontiguousarray(points_mm, dtype=np.float64)
        tiers = np.empty(len(points), dtype=np.int8)
        done = 0
        while done < len(points):
            done += _take_points(
                points[done:],
                1.0 / self._first_mm,
                self.finest,
                self._slots,
                self._old,
                self._bricks,
                len(self._slots) // 2 - int(self._bricks.sum()),
                tiers[done:],
            )
            if done < len(points):
                self._enlarge_table()
        self._copy_on(_COPIED_SLOTS)
        self._counts += np.bincount(tiers[tiers >= 0], minlength=2 * SIZES)
        return tiers

    def coarsen(self) -> bool:
        """Points of the lowest tier are no longer shown; False if there is only one left."""
        self.finest += 1
        if self.finest < 2 * SIZES:
            return True
        self.finest -= 1
        return False

    def _enlarge_table(self) -> None:
        """A larger table, without the bricks of sizes that are no longer shown."""
        self._copy_on(len(self._old))
        self._bricks[: self.finest // 2] = 0
        needed = 3 * int(self._bricks.sum()) + _FIRST_SLOTS
        self._old, self._copied = self._slots, 0
        self._slots = np.zeros((1 << needed.bit_length(), 2), dtype=np.int64)

    def _copy_on(self, slots: int) -> None:
        """Enters a further portion of the content of the previous table."""
        part = self._old[self._copied : self._copied + slots]
        _copy_bricks(part, self.finest // 2, self._slots)
        self._copied += len(part)
        if self._copied == len(self._old):
            self._old, self._copied = _NO_SLOTS, 0

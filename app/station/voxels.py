"""Thinning points for the display, finer or coarser without looking at any of them again.

Space is cut into cubes, eight of which make one of the next larger size, and so on. A point
is shown where it is the first of its smallest cube, and belongs to the largest cube that it
is the first of. So all points of one size can be taken away at once, and what is left is the
first point of each larger cube, as if there had never been smaller ones. Every other cube
goes first, which leaves a chequered pattern: the steps between two sizes are halves.
"""

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import kernel
from app.metrology.frames import Floats

Tiers = NDArray[np.int8]
"""(N,) where each point belongs: 2 n, or 2 n + 1 for the cubes that stay a step longer, for
cubes of 2^n times the first size; -1 where it is not shown."""

SIZES = 16
# 21 bits an axis: with cubes of 0.1 mm that is 200 m.
_BITS = 21
_HALF = 1 << (_BITS - 1)
# Cubes are remembered as bits, 4 x 4 x 4 of one size to a brick.
_BRICK_BITS = _BITS - 2
_FIRST_SLOTS = 1 << 14
# A table that has grown is filled so much at a time.
_COPIED_SLOTS = 1 << 16


@kernel
def _slot_of(key: np.int64, slots: NDArray[np.int64]) -> np.int64:  # pragma: no cover - compiled
    """Where a brick is in the table, or where it would be entered."""
    mask = len(slots) - 1
    mixed = key ^ (key >> 31)
    mixed = mixed * np.int64(0x2545F4914F6CDD1D)
    slot = (mixed ^ (mixed >> 29)) & mask
    while slots[slot, 0] != 0 and slots[slot, 0] != key:
        slot = (slot + 1) & mask
    return slot


@kernel
def _take(
    points: Floats,
    per_mm: float,
    finest: int,
    slots: NDArray[np.int64],
    old: NDArray[np.int64],
    bricks: NDArray[np.int64],
    room: int,
    tiers: Tiers,
) -> int:  # pragma: no cover - compiled
    """Enters points (N, 3) until there is room for no more bricks; how many it did.

    Args:
        slots: (M, 2) of each brick its key and its 64 bits; the key is 0 where there is none.
        old: the table of before, whose bricks count although they are not in ``slots`` yet.
        bricks: (SIZES,) how many there are of each size; counted up.
        tiers: (N,) is filled.
    """
    for i in range(len(points)):
        if room < SIZES:
            return i
        tiers[i] = -1
        point = points[i]
        fx, fy, fz = point[0] * per_mm, point[1] * per_mm, point[2] * per_mm
        if not (abs(fx) < _HALF and abs(fy) < _HALF and abs(fz) < _HALF):
            continue
        size = finest >> 1
        x = (np.int64(np.floor(fx)) + _HALF) >> size
        y = (np.int64(np.floor(fy)) + _HALF) >> size
        z = (np.int64(np.floor(fz)) + _HALF) >> size
        tier = np.int64(-1)
        while size < SIZES:
            key = (
                (np.int64(size + 1) << (3 * _BRICK_BITS))
                | ((x >> 2) << (2 * _BRICK_BITS))
                | ((y >> 2) << _BRICK_BITS)
                | (z >> 2)
            )
            bit = np.int64(1) << ((x & 3) | ((y & 3) << 2) | ((z & 3) << 4))
            slot = _slot_of(key, slots)
            if slots[slot, 0] == 0:
                slots[slot, 0] = key
                before = _slot_of(key, old)
                slots[slot, 1] = old[before, 1]
                if old[before, 0] == 0:
                    bricks[size] += 1
                    room -= 1
            if slots[slot, 1] & bit:
                # then so are all larger cubes around it
                break
            slots[slot, 1] |= bit
            tier = 2 * size + 1 - ((x + y + z) & 1)
            size += 1
            x, y, z = x >> 1, y >> 1, z >> 1
        if tier >= finest:
            tiers[i] = tier
    return len(points)


@kernel
def _copy(
    old: NDArray[np.int64], smallest: int, slots: NDArray[np.int64]
) -> None:  # pragma: no cover - compiled
    """Enters bricks of this size and larger ones into a table, unless they are there."""
    for i in range(len(old)):
        if old[i, 0] >> (3 * _BRICK_BITS) > smallest:
            slot = _slot_of(old[i, 0], slots)
            if slots[slot, 0] == 0:
                slots[slot, 0] = old[i, 0]
                slots[slot, 1] = old[i, 1]


_NO_SLOTS = np.zeros((1, 2), dtype=np.int64)


class Voxels:
    """Remembers which cubes of space already show a point."""

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
        """How far apart the shown points of a surface are, about."""
        return self._first_mm * float(2.0 ** (self.finest / 2))

    @property
    def count(self) -> int:
        """How many points are shown."""
        return int(self._counts[self.finest :].sum())

    def take(self, points_mm: Floats) -> Tiers:
        """Where the points (N, 3) belong; those that are shown are no more new."""
        points = np.ascontiguousarray(points_mm, dtype=np.float64)
        tiers = np.empty(len(points), dtype=np.int8)
        done = 0
        while done < len(points):
            done += _take(
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
                self._make_room()
        self._copy_on(_COPIED_SLOTS)
        self._counts += np.bincount(tiers[tiers >= 0], minlength=2 * SIZES)
        return tiers

    def coarsen(self) -> bool:
        """Points of the lowest tier are shown no more; False where there is only one left."""
        self.finest += 1
        if self.finest < 2 * SIZES:
            return True
        self.finest -= 1
        return False

    def _make_room(self) -> None:
        """A larger table, without the bricks of sizes that are not shown any more."""
        self._copy_on(len(self._old))
        self._bricks[: self.finest // 2] = 0
        needed = 3 * int(self._bricks.sum()) + _FIRST_SLOTS
        self._old, self._copied = self._slots, 0
        self._slots = np.zeros((1 << needed.bit_length(), 2), dtype=np.int64)

    def _copy_on(self, slots: int) -> None:
        """Enters some more of what the table of before held."""
        part = self._old[self._copied : self._copied + slots]
        _copy(part, self.finest // 2, self._slots)
        self._copied += len(part)
        if self._copied == len(self._old):
            self._old, self._copied = _NO_SLOTS, 0

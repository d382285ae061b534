"""Thinning points for the display: the first point of each cube of space is shown."""

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import kernel
from app.metrology.frames import Floats

# 21 bits an axis: with cubes of 0.1 mm that is 200 m.
_BITS = 21
_HALF = 1 << (_BITS - 1)
_EMPTY = np.int64(-1)
_FIRST_SLOTS = 1 << 16


@kernel
def _take_new(
    points: Floats, per_mm: float, slots: NDArray[np.int64], new: NDArray[np.bool_]
) -> int:  # pragma: no cover - compiled
    """Marks the points (N, 3) whose cube is not in the table yet, and enters them."""
    mask = len(slots) - 1
    count = 0
    for i in range(len(points)):
        point = points[i]
        x, y, z = point[0] * per_mm, point[1] * per_mm, point[2] * per_mm
        if not (abs(x) < _HALF and abs(y) < _HALF and abs(z) < _HALF):
            continue
        key = (
            ((np.int64(np.floor(x)) + _HALF) << (2 * _BITS))
            | ((np.int64(np.floor(y)) + _HALF) << _BITS)
            | (np.int64(np.floor(z)) + _HALF)
        )
        mixed = key ^ (key >> 31)
        mixed = mixed * np.int64(0x2545F4914F6CDD1D)
        slot = (mixed ^ (mixed >> 29)) & mask
        while slots[slot] != _EMPTY and slots[slot] != key:
            slot = (slot + 1) & mask
        if slots[slot] == _EMPTY:
            slots[slot] = key
            new[i] = True
            count += 1
    return count


@kernel
def _rehash(old: NDArray[np.int64], slots: NDArray[np.int64]) -> None:  # pragma: no cover
    mask = len(slots) - 1
    for i in range(len(old)):
        key = old[i]
        if key == _EMPTY:
            continue
        mixed = key ^ (key >> 31)
        mixed = mixed * np.int64(0x2545F4914F6CDD1D)
        slot = (mixed ^ (mixed >> 29)) & mask
        while slots[slot] != _EMPTY:
            slot = (slot + 1) & mask
        slots[slot] = key


class VoxelFilter:
    """Remembers which cubes of space already show a point."""

    def __init__(self, size_mm: float) -> None:
        self.size_mm = size_mm
        self.count = 0
        self._slots = np.full(_FIRST_SLOTS, _EMPTY, dtype=np.int64)

    def take_new(self, points_mm: Floats) -> NDArray[np.bool_]:
        """Which of the points (N, 3) are the first of their cube; NaN is none."""
        self._make_room(len(points_mm))
        new = np.zeros(len(points_mm), dtype=np.bool_)
        points = np.ascontiguousarray(points_mm, dtype=np.float64)
        self.count += _take_new(points, 1.0 / self.size_mm, self._slots, new)
        return new

    def _make_room(self, more: int) -> None:
        """Keeps the table at most half full."""
        needed = 2 * (self.count + more)
        if needed <= len(self._slots):
            return
        slots = np.full(1 << int(needed).bit_length(), _EMPTY, dtype=np.int64)
        _rehash(self._slots, slots)
        self._slots = slots

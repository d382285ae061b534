"""Poses of which those from one on belong to another tool frame, or to an object that was moved."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.adjustment.board.faults.agreement import (
    FEWEST_PAIRS,
    NEARLY_ALL,
    SeenBoard,
    mounting_of,
)
from crenel.metrology.adjustment.core.hand_eye import CONTRADICTS_MM, pose_offsets_mm
from crenel.metrology.robust import median
from crenel.metrology.transforms import Floats, inverse

ChangeFault = Literal["tool-changed", "object-moved"]
FEWEST_AFTER = 3
"""Poses of the smaller part: two agree with something."""
LEAST_CHANGE = 5.0
"""The parts differ by this multiple of the scatter within them."""
Frames = tuple[Floats, Floats]
"""``T_flange_cam`` and ``T_arm_obj`` (4, 4)."""


@dataclass(frozen=True)
class Change:
    """Nearly all poses agree (``agree`` of P, ``off_mm`` (P,) from their part's place) if
    something changed before the one at ``first``."""

    fault: ChangeFault
    first: int
    agree: int
    off_mm: Floats


def list_changes(seen: SeenBoard, T_arm_flange: Floats) -> Iterator[Change]:
    """What may have changed, and before which of P poses (P, 4, 4), so that nearly all of both
    parts agree, and more than without a change."""
    count, ways = len(T_arm_flange), seen.ways()
    for first in range(FEWEST_AFTER, count - FEWEST_AFTER + 1):
        before, after = list(range(first)), list(range(first, count))
        larger, smaller = sorted((before, after), key=len, reverse=True)
        if len(larger) < FEWEST_PAIRS:
            continue
        mounting = mounting_of(seen.select(larger), T_arm_flange[larger])
        if mounting is None:
            continue
        parts = _PosesOfBoard(T_arm_flange, ways, seen.board.size_mm)
        frames = mounting.T_flange_cam, mounting.T_arm_obj
        off_mm = parts.off_mm(frames)
        most_mm = max(CONTRADICTS_MM, LEAST_CHANGE * median(off_mm[larger]))
        agrees = off_mm < most_mm
        if median(off_mm[larger]) > CONTRADICTS_MM or not _nearly_all(agrees[larger]):
            continue
        faults: tuple[ChangeFault, ...] = ("tool-changed", "object-moved")
        for fault in faults:
            changed = off_mm.copy()
            changed[smaller] = parts.closest_mm(fault, frames, smaller, most_mm)
            agree = int(np.sum(changed < most_mm))
            if _nearly_all(changed[smaller] < most_mm) and agree >= agrees.sum() + FEWEST_AFTER:
                yield Change(fault, first, agree, changed)


def _nearly_all(agrees: NDArray[np.bool_]) -> bool:
    return bool(agrees.sum() >= max(FEWEST_AFTER, NEARLY_ALL * len(agrees)))


@dataclass(frozen=True)
class _PosesOfBoard:
    """P poses (P, 4, 4), and ``T_cam_obj`` (W, 4, 4) of each for every way to number it."""

    T_arm_flange: Floats
    ways: list[Floats]
    reach_mm: float

    def off_mm(self, frames: Frames) -> Floats:
        """(P,) how far each places the object from these frames, numbered as suits it best."""
        return np.array(
            [
                pose_offsets_mm(np.array([T] * len(own)), own, *frames, self.reach_mm).min()
                for T, own in zip(self.T_arm_flange, self.ways, strict=True)
            ]
        )

    def closest_mm(
        self, fault: ChangeFault, frames: Frames, changed: list[int], most_mm: float
    ) -> Floats:
        """(C,) of the poses that changed, in the frames of the one with which most agree."""
        part = _PosesOfBoard(
            self.T_arm_flange[changed], [self.ways[p] for p in changed], self.reach_mm
        )
        X, Z = frames
        found = [
            part.off_mm(
                (inverse(T) @ Z @ inverse(start), Z)
                if fault == "tool-changed"
                else (X, T @ X @ start)
            )
            for T, own in zip(part.T_arm_flange, part.ways, strict=True)
            for start in own
        ]
        return min(found, key=lambda off: (-int(np.sum(off < most_mm)), median(off)))

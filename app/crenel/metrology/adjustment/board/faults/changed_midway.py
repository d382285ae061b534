"""Poses of which those from one on belong to another tool frame, or to an object that was moved."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np

from crenel.metrology.adjustment.board.faults.agreement import FEWEST_PAIRS, SeenBoard, mounting_of
from crenel.metrology.adjustment.core.hand_eye import (
    CONTRADICTS_MM,
    find_contradictions,
    pose_offsets_mm,
)
from crenel.metrology.robust import median
from crenel.metrology.transforms import Floats, inverse

ChangeFault = Literal["tool-changed", "object-moved"]
FEWEST_AFTER = 3
"""Poses of the smaller part: two agree with something."""
LEAST_CHANGE = 5.0
"""The parts differ by this multiple of the scatter within them."""


@dataclass(frozen=True)
class Change:
    """All poses agree (``off_mm``, (P,)) if something changed before the one at ``first``."""

    fault: ChangeFault
    first: int
    off_mm: Floats


def list_changes(seen: SeenBoard, T_arm_flange: Floats) -> Iterator[Change]:
    """What may have changed, and before which of P poses (P, 4, 4), so that all others agree."""
    count, ways = len(T_arm_flange), seen.ways()
    for first in range(FEWEST_AFTER, count - FEWEST_AFTER + 1):
        before, after = list(range(first)), list(range(first, count))
        larger, smaller = sorted((before, after), key=len, reverse=True)
        if len(larger) < FEWEST_PAIRS:
            continue
        mounting = mounting_of(seen.select(larger), T_arm_flange[larger])
        if (
            mounting is None
            or len(mounting.off_mm) < len(larger)
            or median(mounting.off_mm) > CONTRADICTS_MM
            or mounting.contradicts.any()
        ):
            continue
        X, Z, reach_mm = mounting.T_flange_cam, mounting.T_arm_obj, seen.board.size_mm
        others = T_arm_flange[smaller]
        faults: tuple[ChangeFault, ...] = ("tool-changed", "object-moved")
        for fault in faults:
            best: Floats | None = None
            for start in ways[smaller[0]]:
                if fault == "tool-changed":
                    frames = inverse(others[0]) @ Z @ inverse(start), Z
                else:
                    frames = X, others[0] @ X @ start
                off_mm = np.array(
                    [
                        pose_offsets_mm(np.array([T] * len(own)), own, *frames, reach_mm).min()
                        for T, own in zip(others, (ways[p] for p in smaller), strict=True)
                    ]
                )
                if best is None or off_mm.max() < best.max():
                    best = off_mm
            assert best is not None
            if best.max() < max(CONTRADICTS_MM, LEAST_CHANGE * median(mounting.off_mm)):
                every = np.zeros(count)
                every[larger], every[smaller] = mounting.off_mm, best
                if not find_contradictions(every).any():
                    yield Change(fault, first, every)

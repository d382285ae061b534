"""How far the stripe is from the camera, against the distances that were calibrated."""

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True)
class Distance:
    """Of the newest stripe's middle."""

    mm: float
    near_mm: float
    far_mm: float
    state: Literal["in", "near", "far"]


def distance_of(mm: float, range_mm: tuple[float, float]) -> Distance:
    """A distance within the calibrated range, or to which side of it."""
    near_mm, far_mm = range_mm
    state: Literal["in", "near", "far"] = "in"
    if mm < near_mm:
        state = "near"
    elif mm > far_mm:
        state = "far"
    return Distance(round(mm, 1), near_mm, far_mm, state)

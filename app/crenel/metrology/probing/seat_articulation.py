"""How far a tip in a seat seems to move while the arm is articulated about it."""

from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.transforms import Floats


@dataclass(frozen=True)
class SeatArticulation:
    """The tip in one seat, with the arm articulated about it."""

    centre_mm: Floats  # (3,)
    largest_um: float
    """Largest distance of a point from the mean."""
    two_s_um: float
    """Twice the standard deviation of the distances: ``2 sqrt(sum(d²) / (n - 1))``."""


def seat_articulation(tips_mm: Floats) -> SeatArticulation:
    """Single-point articulation in one seat, in three dimensions.

    Args:
        tips_mm: (N, 3) tip centres, N >= 2.

    Source:
        ASME B89.4.22-2004, single-point articulation performance test.
    """
    if len(tips_mm) < 2:
        raise OperationError("too-few-points", message("seat-needs-two-points"))
    centre = tips_mm.mean(axis=0)
    away = np.linalg.norm(tips_mm - centre, axis=1)
    two_s = 2 * float(np.sqrt(np.sum(away**2) / (len(tips_mm) - 1)))
    return SeatArticulation(centre, 1e3 * float(away.max()), 1e3 * two_s)

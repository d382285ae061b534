"""The scatter of what was measured, and how far something deviates by chance."""

from dataclasses import dataclass

import numpy as np
from scipy.special import fdtri, stdtrit

from crenel.metrology.transforms import Floats

LEAST_SCATTER_MM = 5e-4
LEAST_TURN_SCATTER_RAD = 1e-6


@dataclass(frozen=True)
class Scatter:
    """Standard deviations beyond what encoders and instruments state, for each kind of rows."""

    touch_mm: float = LEAST_SCATTER_MM
    """The scatter of touches along each axis."""
    point_mm: float = LEAST_SCATTER_MM
    """The scatter of coordinates along each axis."""
    turn_rad: float = LEAST_TURN_SCATTER_RAD
    """The scatter of a marker's rotation about each axis."""

    @property
    def floors(self) -> Floats:
        """(3,) the least values."""
        return np.array([LEAST_SCATTER_MM, LEAST_SCATTER_MM, LEAST_TURN_SCATTER_RAD])

    @property
    def values(self) -> Floats:
        """(3,) in the order of the fields."""
        return np.array([self.touch_mm, self.point_mm, self.turn_rad])

    def is_close(self, other: "Scatter", share: float) -> bool:
        """Whether all differ by less than a share."""
        return bool(np.all(np.abs(self.values - other.values) < share * self.values))


GOOD_POINTS = 1e-6
"""Share of good points that are taken for outliers."""
FALSE_ALARMS = 1e-4
"""Share of sound sessions in which an artefact or a place is accused."""


def distance_limit(dimensions: int, freedom: float) -> float:
    """Mahalanobis distance that one in a million good points exceeds (F distribution).

    Args:
        dimensions: of the point.
        freedom: degrees of freedom of the standard deviation.
    """
    return _distance(dimensions, freedom, GOOD_POINTS)


def deviation_limit(comparisons: int, freedom: float, dimensions: int = 1) -> float:
    """Deviation, in standard deviations, that the largest of several exceeds by chance in one
    session of ten thousand (Bonferroni).

    Args:
        comparisons: number of deviations of which the largest is looked at.
        freedom: degrees of freedom of the standard deviation.
        dimensions: of the deviation.
    """
    share = FALSE_ALARMS / max(comparisons, 1)
    if dimensions == 1:
        return float(-stdtrit(max(freedom, 1.0), share / 2))
    return _distance(dimensions, freedom, share)


def _distance(dimensions: int, freedom: float, share: float) -> float:
    return float(np.sqrt(dimensions * fdtri(dimensions, max(freedom, 1.0), 1.0 - share)))

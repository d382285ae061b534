"""Standard uncertainties (k = 1) of the figures of a gauge's cloud, from the scatter of its points.

Points of one frame share errors, and so do neighbours in a file without frame numbers. The fit's
parameters therefore have the larger of two uncertainties: that of independent points, and that of
runs of points in their order.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.fitting.plane_sphere import PlaneFit, SphereFit
from crenel.metrology.fitting.shape import distances_from, parameter_covariance, shape_jacobian
from crenel.metrology.transforms import Floats

PARTS = 10
"""The parts of a cloud, interleaved, whose figures show how far those of the whole scatter."""
FEWEST_PER_PART = 4


@dataclass(frozen=True)
class FitUncertainty:
    """Covariances of a shape's parameters, of which the worst counts."""

    covariances: tuple[Floats, ...]
    """As of ``MeasuredShape``, k = 1, mm and rad."""

    def sd(self, first: int, last: int) -> float:
        """In the worst direction of the parameters ``first`` to ``last``."""
        some = [one[first : last + 1, first : last + 1] for one in self.covariances]
        largest = max(float(np.linalg.eigvalsh(part)[-1]) for part in some)
        return float(np.sqrt(max(largest, 0.0)))


def fit_uncertainty(
    fit: PlaneFit | SphereFit, points_mm: Floats, frame: NDArray[np.int64] | None
) -> FitUncertainty | None:
    """How well the points of a fit determine it.

    Args:
        points_mm: (N, 3) points of the fit.
        frame: (N,) their frames; None: the file has none.

    Returns:
        None if there are no more points than parameters.
    """
    off = distances_from(fit, points_mm)
    jacobian = shape_jacobian(fit, points_mm)
    free = len(off) - jacobian.shape[1]
    if free <= 0:
        return None
    independent = float(off @ off) / free * np.linalg.inv(jacobian.T @ jacobian)
    order = np.arange(len(off)) if frame is None else frame
    runs = parameter_covariance(jacobian, off, order)
    return FitUncertainty((independent,) if runs is None else (independent, runs))


def rms_sd(off_mm: Floats, parameters: int) -> float:
    """Standard uncertainty of an rms of distances (N,), in their unit."""
    free = max(len(off_mm) - parameters, 1)
    rms = float(np.sqrt(np.mean(off_mm**2)))
    parts = [float(np.sqrt(np.mean(part**2))) for part in _parts(off_mm)]
    by_parts = float(np.std(parts, ddof=1) / np.sqrt(len(parts))) if len(parts) > 1 else 0.0
    return max(rms / float(np.sqrt(2 * free)), by_parts)


def zone_sd(off_mm: Floats, zone: Callable[[Floats], float]) -> float:
    """Standard uncertainty of the width of a zone about distances (N,), in their unit: that of
    the mean of its parts."""
    parts = [zone(part) for part in _parts(off_mm)]
    if len(parts) < 2:
        return zone(off_mm) / 2
    return float(np.std(parts, ddof=1) / np.sqrt(len(parts)))


def range_sd(off_mm: Floats) -> float:
    """Standard uncertainty of the range of distances (N,): the scatter of that of its parts.

    Extremes of many points scatter nearly as those of a tenth of them.
    """
    parts = [float(np.ptp(part)) for part in _parts(off_mm)]
    return float(np.std(parts, ddof=1)) if len(parts) > 1 else float(np.ptp(off_mm)) / 2


def _parts(off_mm: Floats) -> list[Floats]:
    """Interleaved, so that each covers the whole gauge."""
    count = min(PARTS, len(off_mm) // FEWEST_PER_PART)
    return [off_mm[first::count] for first in range(count)]

"""The scatter of measured edge points: along each edge, and of whole edges."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.detection.edges.stations import EdgeStations
from crenel.metrology.robust import median, sigma_from_median
from crenel.metrology.transforms import Floats

# Points further from the median of their part, relative to standard deviation and scatter, are
# outliers.
_WITHIN = 4.0
# Minimum number of points for the scatter of a part; for its mean; of means for the scatter of
# parts.
_IN_PART, _IN_MEAN, _FEWEST_MEANS = 8, 3, 6
# If the errors of adjacent points are correlated by more than this, this correlation is assumed.
_MOST_ALIKE = 0.8
# The median of the square of a standard normal variable.
_MEDIAN_SQUARE = 0.455


@dataclass(frozen=True)
class _Mean:
    """A part: its number, the mean distance of its points, and the variance of that mean due to the
    points, to marks along it and to the certificate, px squared."""

    part: int
    off_px: float
    variance: float
    marks: float
    certificate: float


def estimate_scatter(
    off_px: Floats,
    at: EdgeStations,
    shows: NDArray[np.bool_],
    sigma_px: Floats,
    marks_px: Floats,
    certificate_px: Floats,
) -> tuple[NDArray[np.bool_], float, Floats]:
    """Which points agree with the others of their part, and factors on their sigmas.

    Args:
        off_px: (N,) distances of the points from their predicted edges.
        at: their stations; shows: (N,) visible ones.
        sigma_px: (N,) their standard deviations due to pixel noise; marks_px: (N,) how far
            marks along a part may move all of it; certificate_px: (N,) how far the error of
            the certificate may.

    Returns:
        (N,) points that agree; the factor that scales the sigmas to the scatter along the parts,
        or to that of the parts' means if the errors of adjacent points are correlated (texture);
        and additional factors (N,), so that the parts' means scatter no more than the sigmas
        and the certificate state. The sigmas do not include the certificate: an adjustment of
        the block must include it separately.
    """
    used = np.zeros(len(off_px), dtype=bool)
    spreads, products, squares = [], 0.0, 0.0
    means: list[_Mean] = []
    for part in np.unique(at.part[shows]):
        rows = np.flatnonzero(shows & (at.part == part))
        z = (off_px[rows] - median(off_px[rows])) / sigma_px[rows]
        spread = max(sigma_from_median(np.abs(z)), 1.0)
        fine = np.abs(z) < _WITHIN * spread
        used[rows[fine]] = True
        if fine.sum() >= _IN_MEAN:
            weight = 1 / sigma_px[rows[fine]] ** 2
            mean = float(weight @ off_px[rows[fine]] / weight.sum())
            marks = float(marks_px[rows[0]]) ** 2
            certificate = float(np.mean(certificate_px[rows[fine]])) ** 2
            means.append(_Mean(int(part), mean, 1 / float(weight.sum()), marks, certificate))
        if fine.sum() >= _IN_PART:
            z = z[fine] - z[fine].mean()
            spreads.append(np.full(len(z), float(np.mean(z**2)) * len(z) / (len(z) - 1)))
            products += float((z[1:] * z[:-1]).sum())
            squares += float((z[1:] ** 2 + z[:-1] ** 2).sum()) / 2
    along = 1.0
    if spreads:
        alike = float(np.clip(products / max(squares, 1e-12), 0.0, _MOST_ALIKE))
        along = float(np.sqrt(median(np.concatenate(spreads)) * (1 + alike) / (1 - alike)))
    return used, along, _part_factors(at, means, along**2)


def _part_factors(at: EdgeStations, means: list[_Mean], scale: float) -> Floats:
    """Factors (N,) on the points' sigmas for effects that move each edge as a whole.

    Such effects are marks along an edge, a shadow at its foot, or rounding. ``scale``: the factor
    already applied to the variances.
    """
    factor = np.ones(len(at.part))
    off = np.array([one.off_px for one in means])
    own = scale * np.array([one.variance for one in means])
    others = np.array([one.marks + one.certificate for one in means])
    moved = 0.0
    if len(means) >= _FEWEST_MEANS:
        # Scales the median of the squares to its value for unit variance.
        lack = median(off**2 - _MEDIAN_SQUARE * (own + others)) / _MEDIAN_SQUARE
        moved = max(float(lack), 0.0)
    for one, variance in zip(means, own, strict=True):
        factor[at.part == one.part] = np.sqrt(1 + (moved + one.marks) / variance)
    return factor

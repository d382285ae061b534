"""How measured edge points scatter: along each edge, and the edges as wholes."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.metrology.detection.edges.stations import EdgeStations
from app.metrology.transforms import Floats

# Points further from their part's median, over their deviation and scatter, are none of it.
_WITHIN = 4.0
# Points that show how a part scatters; that make its mean; means that show how parts scatter.
_IN_PART, _IN_MEAN, _FEWEST_MEANS = 8, 3, 6
# Neighbouring points that err alike by more than this are held to err alike by this.
_MOST_ALIKE = 0.8
# The median of the square of a normal deviate.
_MEDIAN_SQUARE = 0.455


@dataclass(frozen=True)
class _Mean:
    """Of a part: its number, its points' mean distance, and that mean's variance, by the
    points, by marks along it and by the block's certificate, px squared."""

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
    """Which points agree with the others of their part, and what their sigmas lack.

    Args:
        off_px: (N,) distances of the points from where the camera draws their edges.
        at: their stations; shows: (N,) which were seen.
        sigma_px: (N,) their deviations by the pixels' noise; marks_px: (N,) how far marks
            along a part may move the whole of it; certificate_px: (N,) how far the
            block's certificate may.

    Returns:
        (N,) which agree; the factor that brings the sigmas to the scatter along the parts,
        further to that of parts' means where neighbouring points err alike (texture); and
        factors (N,) beyond it, so that the parts' means scatter no more than they and the
        certificate say. The certificate itself is not in the sigmas: who adjusts the block
        with them counts it by itself.
    """
    used = np.zeros(len(off_px), dtype=bool)
    spreads, products, squares = [], 0.0, 0.0
    means: list[_Mean] = []
    for part in np.unique(at.part[shows]):
        rows = np.flatnonzero(shows & (at.part == part))
        z = (off_px[rows] - np.median(off_px[rows])) / sigma_px[rows]
        spread = max(float(np.median(np.abs(z))) / 0.6745, 1.0)
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
        along = float(np.sqrt(np.median(np.concatenate(spreads)) * (1 + alike) / (1 - alike)))
    return used, along, _part_factors(at, means, along**2)


def _part_factors(at: EdgeStations, means: list[_Mean], scale: float) -> Floats:
    """Factors (N,) on the points' sigmas for what moves each edge as a whole.

    Marks along an edge, a shadow at its foot, rounding. ``scale``: what the variances lack
    already.
    """
    factor = np.ones(len(at.part))
    off = np.array([one.off_px for one in means])
    own = scale * np.array([one.variance for one in means])
    others = np.array([one.marks + one.certificate for one in means])
    moved = 0.0
    if len(means) >= _FEWEST_MEANS:
        # About as much as makes the median of the squares what it is of unit variance.
        lack = np.median(off**2 - _MEDIAN_SQUARE * (own + others)) / _MEDIAN_SQUARE
        moved = max(float(lack), 0.0)
    for one, variance in zip(means, own, strict=True):
        factor[at.part == one.part] = np.sqrt(1 + (moved + one.marks) / variance)
    return factor

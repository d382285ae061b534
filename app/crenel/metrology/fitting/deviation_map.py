"""Deviations of a gauge's cloud from its shape, averaged over the cells of a flat map."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.fitting.plane_sphere import PlaneFit, SphereFit
from crenel.metrology.fitting.shape import distances_from
from crenel.metrology.transforms import Floats

CELLS_ACROSS = 48
LEAST_POINTS = 2
MOST_OUTLIERS = 40
BEYOND_NOISE = 1.0
"""An outlier is further off than the largest of so many normal values by this many standard
deviations."""


@dataclass(frozen=True)
class DeviationMap:
    """Cells of a square grid, seen from outside; X of the arm frame points right as far as
    possible."""

    cell_mm: float
    x_mm: Floats
    """(K,) centres of the cells, relative to the middle of the plane or the cap; on a sphere, along
    it."""
    y_mm: Floats
    deviation_um: Floats
    """(K,) mean of the points in the cell; outward is positive."""


@dataclass(frozen=True)
class DeviationOutliers:
    """Places with single points far off the shape, on the map; the furthest first."""

    x_mm: Floats
    """(K,) of the furthest point of the place, as in ``DeviationMap``."""
    y_mm: Floats
    deviation_um: Floats
    """(K,) of that point."""
    index: NDArray[np.int64]
    """(K,) of that point among the points given."""
    points: NDArray[np.int64]
    """(K,) outliers at the place; 0 where its point is the highest or lowest, and yet none."""
    is_end: NDArray[np.bool_]
    """(K,) whether the point is the highest or the lowest of all: the range lies between these."""
    all_points: int
    """Outliers in all, also at places that are not listed."""


def deviation_map(fit: PlaneFit | SphereFit, points_mm: Floats) -> DeviationMap:
    """Deviations of a cloud from its shape, averaged over the cells of a square grid.

    Args:
        fit: a plane or sphere.
        points_mm: (N, 3), the points of the fit.

    Returns:
        The cells with at least ``LEAST_POINTS`` of the points that the fit used. A sphere is
        unrolled from the middle of its cap, so that distances from there are preserved.
    """
    points = points_mm[fit.used]
    off_um = 1e3 * distances_from(fit, points)
    flat = _flatten(fit, points, points)
    low = flat.min(axis=0)
    cell = float(np.max(flat.max(axis=0) - low)) / CELLS_ACROSS or 1.0
    at = np.floor((flat - low) / cell).astype(np.int64).clip(0, CELLS_ACROSS - 1)
    number = at[:, 0] * CELLS_ACROSS + at[:, 1]
    count = np.bincount(number, minlength=CELLS_ACROSS**2)
    total = np.bincount(number, off_um, CELLS_ACROSS**2)
    filled = np.flatnonzero(count >= LEAST_POINTS)
    column, row = np.divmod(filled, CELLS_ACROSS)
    return DeviationMap(
        cell,
        low[0] + (column + 0.5) * cell,
        low[1] + (row + 0.5) * cell,
        total[filled] / count[filled],
    )


def find_outliers(
    fit: PlaneFit | SphereFit,
    points_mm: Floats,
    all_mm: Floats,
    off_mm: Floats,
    cell_mm: float,
) -> DeviationOutliers:
    """Where points lie that are too far off a shape to belong to its noise.

    Args:
        fit: a plane or sphere.
        points_mm: (N, 3), the points of the fit.
        all_mm: (M, 3) among which outliers are looked for, M >= 1.
        off_mm: (M,) their distances, outward positive, from the shape by which their range is
            stated.
        cell_mm: of the map; outliers of one cell are one place.

    Returns:
        At most ``MOST_OUTLIERS`` places, among them those of the highest and the lowest point.
    """
    reach = (np.sqrt(2 * np.log(max(len(off_mm), 2))) + BEYOND_NOISE) * fit.rms_mm
    # a shape through all points is drawn towards its outliers; by it, others would seem to be some
    outlying = np.abs(distances_from(fit, all_mm)) > reach
    ends = np.unique([np.argmax(off_mm), np.argmin(off_mm)])
    chosen = np.union1d(np.flatnonzero(outlying), ends)
    chosen = chosen[np.argsort(-np.abs(off_mm[chosen]), kind="stable")]
    flat = _flatten(fit, points_mm[fit.used], all_mm[chosen])
    cells = np.floor(flat / cell_mm).astype(np.int64)
    _, first, place = np.unique(cells, axis=0, return_index=True, return_inverse=True)
    count = np.bincount(place.ravel(), outlying[chosen], len(first)).astype(np.int64)
    # of a place with both ends, each is listed
    is_end = np.isin(chosen, ends)
    listed = np.union1d(first, np.flatnonzero(is_end))
    far = listed[~is_end[listed]][: MOST_OUTLIERS - len(ends)]
    listed = np.union1d(far, np.flatnonzero(is_end))
    return DeviationOutliers(
        flat[listed, 0],
        flat[listed, 1],
        1e3 * off_mm[chosen[listed]],
        chosen[listed],
        count[place.ravel()[listed]],
        is_end[listed],
        int(outlying.sum()),
    )


def _flatten(fit: PlaneFit | SphereFit, used_mm: Floats, points_mm: Floats) -> Floats:
    """(N, 2) places of points (N, 3) on the map of the points used (M, 3)."""
    if isinstance(fit, PlaneFit):
        return flat_places(points_mm - fit.centre_mm, fit.normal)
    return _unroll_sphere(fit, used_mm, points_mm)


def flat_places(away_mm: Floats, normal: Floats) -> Floats:
    """Positions projected along a normal, as seen from outside.

    Args:
        away_mm: (N, 3) positions relative to the point that becomes (0, 0).
        normal: (3,) unit length, towards the viewer.

    Returns:
        (N, 2) mm, to the right and up; the X axis of the frame points right as far as possible.
    """
    right, up = _axes(normal)
    return np.column_stack([away_mm @ right, away_mm @ up])


def _unroll_sphere(fit: SphereFit, used: Floats, points: Floats) -> Floats:
    """(N, 2) along the sphere from the middle of the cap of the points used, with the distances
    from there preserved."""
    middle = _directions(fit, used).mean(axis=0)
    middle = middle / np.linalg.norm(middle)
    outward = _directions(fit, points)
    right, up = _axes(middle)
    flat = np.column_stack([outward @ right, outward @ up])
    sine = np.linalg.norm(flat, axis=1)
    angle = np.arctan2(sine, outward @ middle)
    return np.asarray(flat * (fit.radius_mm * angle / np.maximum(sine, 1e-12))[:, None])


def _directions(fit: SphereFit, points: Floats) -> Floats:
    """(N, 3) from the centre."""
    outward = points - fit.centre_mm
    return np.asarray(outward / np.linalg.norm(outward, axis=1)[:, None])


def _axes(normal: Floats) -> tuple[Floats, Floats]:
    """Right and up (3,) as seen from the side of the normal."""
    guide = np.array([1.0, 0.0, 0.0]) if abs(normal[0]) < 0.9 else np.array([0.0, 1.0, 0.0])
    right = guide - (guide @ normal) * normal
    right = right / np.linalg.norm(right)
    return right, np.cross(normal, right)

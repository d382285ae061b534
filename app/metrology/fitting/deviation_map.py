"""Deviations of a gauge's cloud from its shape, averaged over the cells of a flat map."""

from dataclasses import dataclass

import numpy as np

from app.metrology.fitting.plane_sphere import PlaneFit, SphereFit
from app.metrology.fitting.shape import distances_from
from app.metrology.transforms import Floats

CELLS_ACROSS = 48
LEAST_POINTS = 2


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
    if isinstance(fit, PlaneFit):
        flat = flat_places(points - fit.centre_mm, fit.normal)
    else:
        flat = _unroll_sphere(fit, points)
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


def _unroll_sphere(fit: SphereFit, points: Floats) -> Floats:
    """(N, 2) along the sphere from the middle of its cap, with the distances from there
    preserved."""
    outward = points - fit.centre_mm
    outward = outward / np.linalg.norm(outward, axis=1)[:, None]
    middle = outward.mean(axis=0)
    middle = middle / np.linalg.norm(middle)
    right, up = _axes(middle)
    flat = np.column_stack([outward @ right, outward @ up])
    sine = np.linalg.norm(flat, axis=1)
    angle = np.arctan2(sine, outward @ middle)
    return np.asarray(flat * (fit.radius_mm * angle / np.maximum(sine, 1e-12))[:, None])


def _axes(normal: Floats) -> tuple[Floats, Floats]:
    """Right and up (3,) as seen from the side of the normal."""
    guide = np.array([1.0, 0.0, 0.0]) if abs(normal[0]) < 0.9 else np.array([0.0, 1.0, 0.0])
    right = guide - (guide @ normal) * normal
    right = right / np.linalg.norm(right)
    return right, np.cross(normal, right)

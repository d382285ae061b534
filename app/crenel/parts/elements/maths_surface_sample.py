"""A thinned surface with its normals: what is looked at to find shapes in picked points."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from crenel.metrology.robust import median
from crenel.metrology.transforms import Floats

SAMPLE = 1600
"""Points of a sample."""
NEAR, WIDE = 16, 60
"""Neighbours whose plane is the surface; the many where the few lie in one line."""
FLATTEST = 0.03
"""Neighbours lie in one line below this ratio of their spreads."""
LEAST_TOLERANCE_MM = 0.02
TOLERANCE_SDS = 4.0


@dataclass(frozen=True)
class SurfaceSample:
    """Points (S, 3) with normals (S, 3) towards a viewer, and how far off a shape may be, mm."""

    points_mm: Floats
    normals: Floats
    tolerance_mm: float

    @property
    def extent_mm(self) -> float:
        return float(np.ptp(self.points_mm, axis=0).max())


def sample_surface(points_mm: Floats, viewer_mm: Floats, rng: np.random.Generator) -> SurfaceSample:
    """A sample of points (N, 3), evenly over their surface.

    Args:
        viewer_mm: (3,) a place on the side of the surface to which normals point.
    """
    thinned = _thin(points_mm, rng)
    tree = cKDTree(thinned)
    normals, spreads, flat = _normals(thinned, tree, NEAR)
    if not flat.all() and len(thinned) > NEAR:
        again, more, wide = _normals(thinned, tree, WIDE, ~flat)
        normals[~flat], spreads[~flat] = again, more
        flat[~flat] = wide
    points, normals, spreads = thinned[flat], normals[flat], spreads[flat]
    away = np.sum(normals * (viewer_mm - points), axis=1) < 0
    normals[away] *= -1
    tolerance = TOLERANCE_SDS * median(spreads) if len(spreads) else 0.0
    return SurfaceSample(points, normals, max(tolerance, LEAST_TOLERANCE_MM))


def _thin(points_mm: Floats, rng: np.random.Generator) -> Floats:
    """One point of each cube, with cubes that make about ``SAMPLE`` of them."""
    if len(points_mm) <= SAMPLE:
        return points_mm
    some = points_mm[rng.permutation(len(points_mm))[: 20 * SAMPLE]]
    low = some.min(axis=0)
    edge = float(np.ptp(some, axis=0).max()) / np.sqrt(SAMPLE)
    for _ in range(8):
        cells = np.floor((some - low) / edge).astype(np.int64)
        sizes = cells.max(axis=0) + 1
        number = (cells[:, 0] * sizes[1] + cells[:, 1]) * sizes[2] + cells[:, 2]
        first = np.unique(number, return_index=True)[1]
        if 0.6 * SAMPLE < len(first) <= 1.5 * SAMPLE:
            break
        edge *= float(np.clip(np.sqrt(len(first) / SAMPLE), 0.4, 2.5))
    return np.asarray(some[rng.permutation(first)])


def _normals(
    points: Floats, tree: cKDTree, count: int, of: np.ndarray | slice = slice(None)
) -> tuple[Floats, Floats, np.ndarray]:
    """Normals (K, 3) and spreads (K,) along them, and whether the neighbours span a plane."""
    near = tree.query(points[of], min(count, len(points)))[1].reshape(len(points[of]), -1)
    off = points[near] - points[near].mean(axis=1, keepdims=True)
    values, vectors = np.linalg.eigh(np.einsum("kij,kil->kjl", off, off) / near.shape[1])
    spans = values[:, 1] > FLATTEST * values[:, 2]
    return vectors[:, :, 0], np.sqrt(np.maximum(values[:, 0], 0.0)), spans

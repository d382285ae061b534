"""The smallest sphere that holds a few points."""

from dataclasses import dataclass
from itertools import combinations

import numpy as np

from crenel.metrology.transforms import Floats

MOST = 12
TOLERANCE = 1e-9
"""In mm: points closer together are one."""


@dataclass(frozen=True)
class EnclosingSphere:
    """The smallest sphere about some points."""

    centre_mm: Floats  # (3,)
    diameter_mm: float


def smallest_enclosing_sphere(points_mm: Floats) -> EnclosingSphere:
    """The smallest sphere that holds all points.

    All pairs, triples and quadruples are tried: at most four points lie on its surface.

    Args:
        points_mm: (N, 3), 1 <= N <= ``MOST``.

    Source:
        Location error L_Dia of ISO 10360-12: the diameter of the zone that holds the centres.

    Example:
        >>> smallest_enclosing_sphere(np.array([[0.0, 0, 0], [2, 0, 0], [1, 0.5, 0]])).diameter_mm
        2.0
    """
    points = np.asarray(points_mm, dtype=np.float64)
    assert 1 <= len(points) <= MOST, len(points)
    best: EnclosingSphere | None = None
    points = _distinct(points)
    if len(points) == 1:
        return EnclosingSphere(points[0], 0.0)
    for size in (2, 3, 4):
        for chosen in combinations(points, size):
            centre = _circumcentre(np.array(chosen))
            if centre is None:
                continue
            radius = float(np.linalg.norm(chosen[0] - centre))
            if best is not None and 2 * radius >= best.diameter_mm:
                continue
            if (np.linalg.norm(points - centre, axis=1) <= radius + TOLERANCE).all():
                best = EnclosingSphere(centre, 2 * radius)
    assert best is not None, "a sphere through two, three or four points holds all"
    return best


def _distinct(points: Floats) -> Floats:
    """The points (K, 3) without those that coincide with an earlier one."""
    kept: list[Floats] = []
    for point in points:
        if all(np.linalg.norm(point - other) > TOLERANCE for other in kept):
            kept.append(point)
    return np.array(kept)


def _circumcentre(points: Floats) -> Floats | None:
    """The point of their affine hull that is equally far from all (K, 3); None if they are
    dependent."""
    edges = points[1:] - points[0]
    gram = edges @ edges.T
    if np.linalg.matrix_rank(gram, tol=1e-12 * max(float(gram.max()), 1e-12)) < len(edges):
        return None
    shares = np.linalg.solve(2 * gram, np.diag(gram))
    return np.asarray(points[0] + shares @ edges)

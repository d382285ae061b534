"""Brightness and size of the points in the 3D view, by the surface on which they lie.

A point is lit as its surface would be, and about as large as the distance to its neighbours: a
dense scan looks like a surface, and a thin one like lines.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.native.arguments import F32, I32, Array, Function, Integer, Real
from crenel.native.library import CRENEL

_find_surface = Function(
    CRENEL,
    "find_surface",
    Array(F32, "n", 3),
    Real(),
    Integer(),
    Array(I32, "slots", written=True),
    Array(I32, "n", written=True),
    Array(F32, "n", 3, written=True),
    Array(F32, "n", written=True),
)

LIGHT = np.array([0.35, -0.45, 0.82], dtype=np.float32)
"""Towards the light, in the arm frame: from above, at an angle to the arm's axes."""
DARKEST, UNKNOWN = 0.4, 0.8
"""Brightness of a surface along the light, and without a known surface; across it, it is 1."""
SPACINGS, WIDER, RADII = 3.0, 3.0, 4
"""The first radius is so many distances between points; so many of them, each wider by a factor."""
FEW_MM = 4.0
"""Where no surface shows within this radius, a scan has few points: its lines are further apart."""
FEWER = 2
"""How many times fewer points are looked at in a wider radius: those of one line do not fill it."""


@dataclass(frozen=True)
class SurfaceLook:
    """The look of the surface at points (N,)."""

    brightness: NDArray[np.uint8]
    """(N,) factor of their colours, of 255."""
    spacing_mm: NDArray[np.float16]
    """(N,) distance to their neighbours."""
    normals: NDArray[np.float32]
    """(N, 3) of the surface; zero where it is not known, as between lines that are far apart."""
    has_few: NDArray[np.bool_]
    """(N,) where neighbours are so far away that they show no surface nearby."""


def look_at_surface(points_mm: NDArray[np.float32], least_mm: float) -> SurfaceLook:
    """How points (N, 3) of the arm frame, relative to any origin, look among each other.

    Args:
        least_mm: the distance between points of a surface, where they are closest.

    Source:
        Normals by the covariance of neighbours: Hoppe and others, Surface reconstruction from
        unorganized points, 1992.
    """
    normals, spacing_mm, reach_mm = surface_normals(points_mm, least_mm)
    lit = np.abs(normals @ (LIGHT / np.linalg.norm(LIGHT)))
    brightness = np.where(normals.any(axis=1), DARKEST + (1 - DARKEST) * lit, UNKNOWN)
    return SurfaceLook(
        np.rint(255 * brightness).astype(np.uint8),
        spacing_mm.astype(np.float16),
        normals,
        reach_mm > max(FEW_MM, 1.01 * SPACINGS * least_mm),
    )


def surface_normals(
    points_mm: NDArray[np.float32], least_mm: float
) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.float32]]:
    """Normals (N, 3), zero where neighbours do not lie on a surface; spacing in mm (N,); and the
    radius in mm (N,) in which a surface was found, infinite without one."""
    points = np.ascontiguousarray(points_mm, dtype=np.float32)
    normals, spacing_mm = np.zeros_like(points), np.zeros(len(points), np.float32)
    reach_mm = np.full(len(points), np.inf, np.float32)
    heads = np.empty(1 << max(2 * len(points), 2).bit_length(), np.int32)
    following = np.empty(len(points), np.int32)
    radius_mm, stride = SPACINGS * least_mm, 1
    for _ in range(RADII):
        _find_surface(points, radius_mm, stride, heads, following, normals, spacing_mm)
        reach_mm[np.isinf(reach_mm) & normals.any(axis=1)] = radius_mm
        radius_mm, stride = WIDER * radius_mm, FEWER * stride
    return normals, spacing_mm, reach_mm


STEEP_DEG = 65.0
"""Lines seen at a larger angle from the surface's normal are broad and dim."""
_STEEP_COS = np.float32(127 * np.cos(np.radians(STEEP_DEG)))


def is_steep(normals: NDArray[np.float32], views: NDArray[np.int8]) -> NDArray[np.bool_]:
    """Mask (N,) of the surfaces that were seen too steeply.

    Args:
        normals: (N, 3) of unit length, or zero.
        views: (N, 3) directions to the camera in parts of 127, or zero.
    """
    known = normals.any(axis=1) & views.any(axis=1)
    return np.asarray(known & (np.abs(np.einsum("ij,ij->i", normals, views)) < _STEEP_COS))

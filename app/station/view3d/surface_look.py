"""Brightness and size of the points in the 3D view, by the surface on which they lie.

A point is lit as its surface would be, and about as large as the distance to its neighbours: a
dense scan looks like a surface, and a thin one like lines.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.native.arguments import F32, I32, Array, Function, Integer, Real
from app.native.library import CRENEL

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
FEWER = 2
"""Of a wider radius, so many times fewer points are looked at: those of one line do not fill it."""


@dataclass(frozen=True)
class SurfaceLook:
    """Of points (N,)."""

    brightness: NDArray[np.uint8]
    """(N,) factor of their colours, of 255."""
    spacing_mm: NDArray[np.float16]
    """(N,) distance to their neighbours."""


def look_at_surface(points_mm: NDArray[np.float32], least_mm: float) -> SurfaceLook:
    """How points (N, 3) of the arm frame, relative to any origin, look among each other.

    Args:
        least_mm: the distance between points of a surface, where they are closest.

    Source:
        Normals by the covariance of neighbours: Hoppe and others, Surface reconstruction from
        unorganized points, 1992.
    """
    normals = surface_normals(points_mm, least_mm)
    lit = np.abs(normals[0] @ (LIGHT / np.linalg.norm(LIGHT)))
    known = normals[0].any(axis=1)
    brightness = np.where(known, DARKEST + (1 - DARKEST) * lit, UNKNOWN)
    return SurfaceLook(np.rint(255 * brightness).astype(np.uint8), normals[1].astype(np.float16))


def surface_normals(
    points_mm: NDArray[np.float32], least_mm: float
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Normals (N, 3), zero where neighbours do not lie on a surface, and spacing in mm (N,)."""
    points = np.ascontiguousarray(points_mm, dtype=np.float32)
    normals, spacing_mm = np.zeros_like(points), np.zeros(len(points), np.float32)
    heads = np.empty(1 << max(2 * len(points), 2).bit_length(), np.int32)
    following = np.empty(len(points), np.int32)
    radius_mm, stride = SPACINGS * least_mm, 1
    for _ in range(RADII):
        _find_surface(points, radius_mm, stride, heads, following, normals, spacing_mm)
        radius_mm, stride = WIDER * radius_mm, FEWER * stride
    return normals, spacing_mm

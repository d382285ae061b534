"""Points of a scan that lie on the faces of a nominal surface, with their distances from it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats
from crenel.parts.cad.maths_closest import MeshTree
from crenel.parts.cad.maths_smooth import SmoothSurface

ALONG = 0.94
"""Least cosine between the surface's normal and the way to a point of it."""
NONE_MM = 1e-7
EDGE_MM = 0.25
"""Edges are broken or rounded: what is nearer to one is of no face."""


@dataclass(frozen=True)
class FacePoints:
    """Those of N points (K,) that are on a face: within the band, and not at a sharp edge."""

    index: NDArray[np.int64]
    """(K,)"""
    faces: NDArray[np.int32]
    """(K,) triangles."""
    at_mm: Floats
    """(K, 3) closest points of the surface."""
    normals: Floats
    """(K, 3) unit, outwards, turning steadily over curved surfaces."""
    distance_mm: Floats
    """(K,) positive outside."""
    beyond: int
    """Points beyond the band."""
    at_edges: int
    """Points within the band that are at a sharp edge or past it."""


def face_points(
    tree: MeshTree, surface: SmoothSurface, points_mm: Floats, band_mm: float
) -> FacePoints:
    """The points (N, 3) of the part frame that lie on faces of the surface."""
    closest = tree.closest(points_mm, band_mm)
    found = np.flatnonzero(closest.found)
    faces, at, off = closest.faces[found], closest.at_mm[found], closest.distance_mm[found]
    normals = surface.normals_at(faces, at)
    along = np.einsum("ni,ni->n", points_mm[found] - at, normals)
    is_on_face = (along * np.sign(off) >= ALONG * np.abs(off)) | (np.abs(off) < NONE_MM)
    is_on_face &= ~surface.is_near_edge(faces, at, EDGE_MM)
    return FacePoints(
        found[is_on_face],
        faces[is_on_face],
        at[is_on_face],
        normals[is_on_face],
        off[is_on_face],
        len(points_mm) - len(found),
        int(np.sum(~is_on_face)),
    )

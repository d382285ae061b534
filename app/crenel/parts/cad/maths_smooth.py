"""The smooth surface for which the facets of a mesh stand."""

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats
from crenel.parts.cad.maths_mesh import SMOOTH_RAD, Indices, PartMesh, edge_angles, join_faces


class SmoothSurface:
    """Patches of a mesh without sharp edges, and normals that turn steadily over each.

    By the normals of its facets alone, a cylinder of facets could not turn about its axis.
    """

    def __init__(self, mesh: PartMesh) -> None:
        self._mesh = mesh

    @cached_property
    def patches(self) -> Indices:
        """(T,) the patch of each triangle."""
        return join_faces(self._mesh, edge_angles(self._mesh) < SMOOTH_RAD)

    @cached_property
    def corner_normals(self) -> Floats:
        """(T, 3, 3) unit normals at the corners of each triangle, by those of its patch there."""
        mesh = self._mesh
        keys = np.repeat(self.patches.astype(np.int64), 3) * len(mesh.vertices_mm)
        keys += mesh.triangles.ravel()
        _, place = np.unique(keys, return_inverse=True)
        weighted = (mesh.corner_angles_rad[:, :, None] * mesh.normals[:, None]).reshape(-1, 3)
        sums = np.column_stack([np.bincount(place, weighted[:, k]) for k in range(3)])
        unit = sums / np.linalg.norm(sums, axis=1)[:, None]
        return np.asarray(unit[place].reshape(-1, 3, 3))

    @cached_property
    def is_sharp(self) -> NDArray[np.bool_]:
        """(T, 3) which edges of each triangle, from each corner to the next, bound its patch."""
        return np.asarray((edge_angles(self._mesh) >= SMOOTH_RAD)[self._mesh.edges.of_triangles])

    def is_near_edge(
        self, faces: NDArray[np.int32], at_mm: Floats, reach_mm: float
    ) -> NDArray[np.bool_]:
        """(N,) whether points (N, 3) of triangles (N,) are so near to a sharp edge of them."""
        near = np.zeros(len(faces), np.bool_)
        corners = self._mesh.corners_mm
        for k in range(3):
            some = np.flatnonzero(self.is_sharp[faces, k])
            start = corners[faces[some], k]
            along = corners[faces[some], (k + 1) % 3] - start
            along = along / np.linalg.norm(along, axis=1)[:, None]
            away = np.linalg.norm(np.cross(at_mm[some] - start, along), axis=1)
            near[some] |= away < reach_mm
        return near

    def normals_at(self, faces: NDArray[np.int32], at_mm: Floats) -> Floats:
        """(N, 3) unit, at points (N, 3) of triangles (N,)."""
        corners = self._mesh.corners_mm[faces]
        ab, ac = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        ap = at_mm - corners[:, 0]
        bb, bc, cc = (np.einsum("ni,ni->n", x, y) for x, y in ((ab, ab), (ab, ac), (ac, ac)))
        pb, pc = np.einsum("ni,ni->n", ap, ab), np.einsum("ni,ni->n", ap, ac)
        area = bb * cc - bc * bc
        v, w = (cc * pb - bc * pc) / area, (bb * pc - bc * pb) / area
        shares = np.clip(np.column_stack([1 - v - w, v, w]), 0.0, 1.0)
        found = np.einsum("nc,nci->ni", shares, self.corner_normals[faces])
        return np.asarray(found / np.linalg.norm(found, axis=1)[:, None])

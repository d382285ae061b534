"""The closest point of a mesh to each of many points, exactly, with sign."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats
from crenel.native.arguments import F32, F64, I32, Array, Function, Real
from crenel.native.library import CRENEL
from crenel.parts.cad.maths_mesh import PartMesh

CHILDREN = 8
SPARE_NODES = 16

_build_boxes = Function(
    CRENEL,
    "build_boxes",
    Array(F64, "t", 3, 3),
    Array(I32, "t", 4, written=True),
    Array(I32, "t", written=True),
    Array(F32, "n", 6, CHILDREN, written=True),
    Array(I32, "n", CHILDREN, written=True),
    returns=int,
)
_find_closest = Function(
    CRENEL,
    "find_closest",
    Array(F64, "n", 3),
    Array(F32, "nodes", 6, CHILDREN),
    Array(I32, "nodes", CHILDREN),
    Array(F64, "t", 3, 3),
    Array(I32, "t"),
    Array(I32, "t", 3),
    Array(I32, "t", 3),
    Array(F64, "t", 3),
    Array(F64, "e", 3),
    Array(F64, "c", 3),
    Real(),
    Array(F64, "n", 3, written=True),
    Array(F64, "n", written=True),
    Array(F64, "n", 3, written=True),
    Array(I32, "n", written=True),
)


@dataclass(frozen=True)
class ClosestPoints:
    """The closest points of a mesh to points (N,)."""

    at_mm: Floats
    """(N, 3) on the mesh; NaN beyond the band."""
    distance_mm: Floats
    """(N,) positive outside; NaN beyond the band."""
    normals: Floats
    """(N, 3) unit, outwards: of the face, or at edges and corners between the faces there."""
    faces: NDArray[np.int32]
    """(N,) triangle; -1 beyond the band."""

    @property
    def found(self) -> NDArray[np.bool_]:
        """(N,) whether the mesh is within the band."""
        return self.faces >= 0


class MeshTree:
    """Boxes about boxes about the triangles of a mesh, by which the closest one is found."""

    def __init__(self, mesh: PartMesh) -> None:
        """Builds the tree of a mesh of one triangle or more."""
        self.mesh = mesh
        self._middle = mesh.middle_mm
        corners = mesh.corners_mm - self._middle
        count = len(corners)
        self._order = np.empty(count, np.int32)
        boxes = np.empty((count // (CHILDREN - 1) + SPARE_NODES, 6, CHILDREN), np.float32)
        children = np.empty((len(boxes), CHILDREN), np.int32)
        workspace = np.empty((count, 4), np.int32)
        nodes = _build_boxes(corners, workspace, self._order, boxes, children)
        self._boxes, self._children = boxes[:nodes], children[:nodes]
        corners = corners[self._order]
        corners[:, 1:] -= corners[:, :1]
        self._triangles = corners

    def closest(self, points_mm: Floats, band_mm: float = np.inf) -> ClosestPoints:
        """The closest points of the mesh to points (N, 3), of its frame.

        Points in the order of a scan are found faster: each search begins at the triangle of the
        one before.

        Args:
            band_mm: what is farther is not looked for.
        """
        points = np.ascontiguousarray(points_mm - self._middle)
        count = len(points)
        at, distance, normals = np.empty((count, 3)), np.empty(count), np.empty((count, 3))
        faces = np.empty(count, np.int32)
        _find_closest(
            points,
            self._boxes,
            self._children,
            self._triangles,
            self._order,
            self.mesh.edges.of_triangles,
            self.mesh.triangles,
            self.mesh.normals,
            self.mesh.edge_normals,
            self.mesh.vertex_normals,
            float(band_mm),
            at,
            distance,
            normals,
            faces,
        )
        with np.errstate(invalid="ignore"):  # between faces back to back there is no direction
            normals /= np.linalg.norm(normals, axis=1)[:, None]
        return ClosestPoints(at + self._middle, distance, normals, faces)

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
MANY, SCATTERED = 1000, 0.05
"""Of so many points or more, whose steps are this share of their extent, neighbours come first."""
LEVELS = 10
"""So often is the extent of points halved along each axis to put neighbours together."""

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

    def select(self, places: NDArray[np.int64]) -> "ClosestPoints":
        """Those at some places, in their order."""
        return ClosestPoints(
            self.at_mm[places], self.distance_mm[places], self.normals[places], self.faces[places]
        )

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

        Points in the order of a scan are found faster, since each search begins at the triangle of
        the one before; scattered ones are put in order before.

        Args:
            band_mm: what is farther is not looked for.
        """
        if (order := self._order_near_first(points_mm)) is not None:
            found = self._search(points_mm[order], band_mm)
            back = np.empty(len(order), np.int64)
            back[order] = np.arange(len(order))
            return found.select(back)
        return self._search(points_mm, band_mm)

    def _search(self, points_mm: Floats, band_mm: float) -> ClosestPoints:
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
        at += self._middle
        return ClosestPoints(at, distance, normals, faces)

    def _order_near_first(self, points_mm: Floats) -> NDArray[np.int64] | None:
        """The order (N,) along a curve through all of space; None where neighbours are together."""
        if len(points_mm) < MANY:
            return None
        some = np.linspace(0, len(points_mm) - 2, MANY).astype(np.int64)
        extent = np.ptp(points_mm[some], axis=0).max()
        steps = np.abs(points_mm[some + 1] - points_mm[some]).max(axis=1)
        if not np.median(steps) > SCATTERED * extent:
            return None
        low, high = np.nanmin(points_mm, axis=0), np.nanmax(points_mm, axis=0)
        if not np.isfinite([low, high]).all():
            return None
        cells = (points_mm - low) * ((2**LEVELS - 1) / float((high - low).max()))
        x, y, z = np.nan_to_num(cells).astype(np.int64).T
        bits = [(np.arange(2**LEVELS) >> bit & 1) << 3 * bit for bit in range(LEVELS)]
        spread = np.sum(bits, axis=0)
        return np.argsort(spread[x] | spread[y] << 1 | spread[z] << 2, kind="stable")

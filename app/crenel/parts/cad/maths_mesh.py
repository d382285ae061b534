"""A mesh: triangles that share corners and edges, with what is known of its surface from them."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats

Indices = NDArray[np.int32]
MIXING = (0x9E3779B97F4A7C15, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9)
"""Odd numbers by which the coordinates of a corner become one number."""
SMOOTH_RAD = np.radians(31.0)
"""Facets that meet at less than this stand for a curved surface: of a circle, at least 12."""
FLAT_RAD = 1e-3
"""Facets that meet at less than this are of one plane."""


@dataclass(frozen=True)
class PartMesh:
    """Triangles without those of no area, outwards anticlockwise."""

    vertices_mm: Floats
    """(V, 3), each once."""
    triangles: Indices
    """(T, 3) indices of vertices."""

    @cached_property
    def corners_mm(self) -> Floats:
        """(T, 3, 3) corners of each triangle."""
        return np.ascontiguousarray(self.vertices_mm[self.triangles])

    @cached_property
    def _cross(self) -> Floats:
        """(T, 3) normals, twice as long as the triangle's area."""
        a, b, c = (self.corners_mm[:, k] for k in range(3))
        return np.cross(b - a, c - a)

    @cached_property
    def areas_mm2(self) -> Floats:
        """(T,) of the triangles."""
        return np.asarray(np.linalg.norm(self._cross, axis=1) / 2)

    @cached_property
    def normals(self) -> Floats:
        """(T, 3) unit, outwards."""
        return np.ascontiguousarray(self._cross / (2 * self.areas_mm2[:, None]))

    @cached_property
    def edges(self) -> "Edges":
        """Its edges, each once."""
        return find_edges(self.triangles, len(self.vertices_mm))

    @cached_property
    def volume_mm3(self) -> float:
        """Enclosed volume; negative if the triangles are clockwise from outside."""
        corners = self.corners_mm - self.middle_mm
        return float(np.einsum("ti,ti->", corners[:, 0], self._cross) / 6)

    @cached_property
    def low_mm(self) -> Floats:
        """(3,) the least coordinates."""
        return np.asarray(self.vertices_mm.min(axis=0))

    @cached_property
    def high_mm(self) -> Floats:
        """(3,) the largest coordinates."""
        return np.asarray(self.vertices_mm.max(axis=0))

    @property
    def size_mm(self) -> Floats:
        """(3,) along each axis."""
        return self.high_mm - self.low_mm

    @property
    def middle_mm(self) -> Floats:
        """(3,) of the box around it."""
        return (self.low_mm + self.high_mm) / 2

    def mirror(self) -> "PartMesh":
        """Its mirror image by the y-z plane."""
        return PartMesh(self.vertices_mm * [-1.0, 1.0, 1.0], self.triangles[:, ::-1].copy())

    @property
    def diagonal_mm(self) -> float:
        """Of the box around it."""
        return float(np.linalg.norm(self.size_mm))

    @cached_property
    def edge_normals(self) -> Floats:
        """(E, 3) sums of the unit normals of the faces at each edge.

        Source:
            J. A. Baerentzen, H. Aanaes, Signed distance computation using the angle weighted
            pseudonormal, IEEE Trans. Vis. Comput. Graph. 11 (2005) 243-253.
        """
        edges = self.edges.of_triangles.ravel()
        return _sums(edges, np.repeat(self.normals, 3, axis=0), len(self.edges.counts))

    @cached_property
    def corner_angles_rad(self) -> Floats:
        """(T, 3) of the triangles."""
        corners = self.corners_mm
        angles = np.empty((len(corners), 3))
        for k in range(3):
            one = corners[:, (k + 1) % 3] - corners[:, k]
            other = corners[:, (k + 2) % 3] - corners[:, k]
            sine = np.linalg.norm(np.cross(one, other), axis=1)
            angles[:, k] = np.arctan2(sine, np.einsum("ti,ti->t", one, other))
        return angles

    @cached_property
    def vertex_normals(self) -> Floats:
        """(V, 3) sums of the unit normals of the faces at each vertex, by their angles there.

        Source:
            As of ``edge_normals``.
        """
        weighted = self.corner_angles_rad[:, :, None] * self.normals[:, None]
        return _sums(self.triangles.ravel(), weighted.reshape(-1, 3), len(self.vertices_mm))

    @cached_property
    def chord_errors_mm(self) -> Floats:
        """(T,) how far the curved surface may be from each facet that stands for it; 0 of a plane.

        The sum over its edges of width · angle / 8, where the facets meet at a small angle and
        one of them does so at two edges or more: a plane that ends at another is not curved.
        """
        edges, triangles, angle = self.edges, self.edges.of_triangles, edge_angles(self)
        is_smooth = (angle < SMOOTH_RAD) & (angle > FLAT_RAD)
        region = join_faces(self, angle <= FLAT_RAD)
        first, second = edges.faces[is_smooth].T
        smooth_edges = np.bincount(
            np.concatenate([region[first], region[second]]), minlength=region.max() + 1
        )
        several = smooth_edges >= 2
        is_curved = np.flatnonzero(is_smooth)[several[region[first]] | several[region[second]]]
        lengths = np.linalg.norm(
            self.corners_mm - np.roll(self.corners_mm, -1, axis=1), axis=2
        ).ravel()
        widths = 2 * np.repeat(self.areas_mm2, 3) / lengths
        least = np.full(len(edges.counts), np.inf)
        np.minimum.at(least, triangles.ravel(), widths)
        chord = np.zeros(len(edges.counts))
        chord[is_curved] = least[is_curved] * angle[is_curved] / 8
        return np.asarray(chord[triangles].sum(axis=1))


@dataclass(frozen=True)
class Edges:
    """The edges of a mesh."""

    of_triangles: Indices
    """(T, 3) from each corner to the next."""
    counts: NDArray[np.int64]
    """(E,) how many triangles meet there."""
    ends: NDArray[np.int64]
    """(E, 2) vertices."""
    faces: Indices
    """(E, 2) the first two triangles; of an edge of one, -1."""
    turned: NDArray[np.bool_]
    """(E,) whether its two triangles go along it in the same direction: one is the wrong way."""

    @property
    def is_shared(self) -> NDArray[np.bool_]:
        """(E,) whether two triangles meet there, as in a closed surface."""
        return np.asarray(self.counts == 2)

    @property
    def is_open(self) -> NDArray[np.bool_]:
        """(E,) whether the surface ends there."""
        return np.asarray(self.counts == 1)


def mesh_from_corners(corners: Floats) -> tuple[PartMesh, int]:
    """The mesh of triangles (T, 3, 3), and how many have no area and are left out."""
    vertices, inverse = _distinct_vertices(corners.reshape(-1, 3))
    return clean_mesh(vertices, inverse.reshape(-1, 3).astype(np.int32))


def clean_mesh(vertices: Floats, triangles: Indices) -> tuple[PartMesh, int]:
    """The mesh without triangles of no area, and how many these are."""
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    cross = np.cross(b - a, c - a)
    sides = np.maximum.reduce([np.sum((p - q) ** 2, axis=1) for p, q in ((a, b), (b, c), (c, a))])
    # what rounding leaves of no area
    has_area = np.linalg.norm(cross, axis=1) > 1e-12 * sides
    kept = triangles[has_area]
    return PartMesh(vertices, np.ascontiguousarray(kept)), int(np.sum(~has_area))


def find_edges(triangles: Indices, vertices: int) -> Edges:
    """The edges of triangles (T, 3) among so many vertices."""
    start = triangles.astype(np.int64)
    end = np.roll(start, -1, axis=1)
    keys = (np.minimum(start, end) * vertices + np.maximum(start, end)).ravel()
    order = np.argsort(keys, kind="stable")
    ordered = keys[order]
    begins = np.flatnonzero(np.r_[True, ordered[1:] != ordered[:-1]])
    counts = np.diff(np.r_[begins, len(keys)])
    of_triangles = np.empty(len(keys), np.int32)
    of_triangles[order] = np.repeat(np.arange(len(begins), dtype=np.int32), counts)
    second = np.where(counts > 1, order[np.minimum(begins + 1, len(keys) - 1)], -3)
    faces = np.column_stack([order[begins], second]) // 3
    forward = (start < end).ravel()
    turned = (counts == 2) & (forward[order[begins]] == forward[second])
    ends = np.column_stack(np.divmod(ordered[begins], vertices))
    return Edges(of_triangles.reshape(-1, 3), counts, ends, faces.astype(np.int32), turned)


def _distinct_vertices(points: Floats) -> tuple[Floats, NDArray[np.int64]]:
    """Each of the points (N, 3) once, and which of them each is."""
    bits = np.ascontiguousarray(points + 0.0).view(np.uint64)  # makes -0 equal to 0
    mixed = np.zeros(len(points), np.uint64)
    for k, odd in enumerate(MIXING):
        mixed ^= bits[:, k] * np.uint64(odd)
        mixed ^= mixed >> np.uint64(29)
    _, first, inverse = np.unique(mixed, return_index=True, return_inverse=True)
    if (points[first][inverse] == points).all():
        return points[first], inverse
    found, inverse = np.unique(points, axis=0, return_inverse=True)  # two gave one number
    return found, inverse.ravel()


def _sums(places: Indices, rows: Floats, count: int) -> Floats:
    """(count, 3) sums of the rows (N, 3) of each place (N,)."""
    sums = [np.bincount(places, rows[:, k], count) for k in range(3)]
    return np.ascontiguousarray(np.column_stack(sums))


def edge_angles(mesh: PartMesh) -> Floats:
    """(E,) between the two triangles at each edge, rad; a half turn where there are not two."""
    shared = mesh.edges.is_shared
    first, second = mesh.edges.faces[shared].T
    sine = np.linalg.norm(np.cross(mesh.normals[first], mesh.normals[second]), axis=1)
    cosine = np.einsum("ti,ti->t", mesh.normals[first], mesh.normals[second])
    angle = np.full(len(shared), np.pi)
    angle[shared] = np.arctan2(sine, cosine)
    return angle


def join_faces(mesh: PartMesh, joins: NDArray[np.bool_]) -> Indices:
    """(T,) numbers of the parts of a mesh that hang together by some of its shared edges (E,)."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    count = len(mesh.triangles)
    first, second = mesh.edges.faces[joins & mesh.edges.is_shared].T
    graph = coo_array((np.ones(len(first), np.bool_), (first, second)), (count, count))
    return np.asarray(connected_components(graph, directed=False)[1], dtype=np.int32)

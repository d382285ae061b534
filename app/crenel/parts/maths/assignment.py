"""Which points of a scan belong to a nominal feature, and which of them a rule leaves out."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats
from crenel.parts.maths.shapes import Shape

BAND_MM = 1.0
"""Points so near to a nominal surface may belong to it."""
EDGE_MM = 1.0
EDGE_SHARE = 0.1
"""Of a short feature's length, that is left out at each end."""
CIRCLE_DEPTH_MM = 1.0
STEEPEST_COSINE = float(np.cos(np.deg2rad(70.0)))
PARALLEL_COSINE = 0.87

Mask = NDArray[np.bool_]


@dataclass(frozen=True)
class Face:
    """A nominal feature in the part frame, and the piece of it that exists.

    ``along_mm`` is the range along its z axis, ``boxes_mm`` are corners (2, 3) of where points are
    taken.
    """

    shape: Shape
    is_internal: bool
    along_mm: tuple[float, float] | None = None
    boxes_mm: tuple[Floats, ...] = ()

    @property
    def side(self) -> float:
        """On which side of its surface a tip or a sensor is: +1 is that of the gradient."""
        return -1.0 if self.is_internal else 1.0

    def is_within_boxes(self, points_mm: Floats) -> Mask:
        """(N,) whether points lie in any of the boxes; all do without boxes."""
        if not self.boxes_mm:
            return np.ones(len(points_mm), dtype=np.bool_)
        inside = np.zeros(len(points_mm), dtype=np.bool_)
        for low, high in self.boxes_mm:
            z = points_mm[:, 2]
            near = np.flatnonzero((z >= low[2]) & (z <= high[2]))
            for axis in (0, 1):
                along = points_mm[near, axis]
                near = near[(along >= low[axis]) & (along <= high[axis])]
            inside[near] = True
        return inside

    def is_along(self, x: Floats, margin_mm: float) -> Mask:
        """(N,) whether points (N, 3) in its own frame are within its length, but for a margin."""
        if self.shape.kind == "circle":
            return np.asarray(np.abs(x[:, 2]) <= CIRCLE_DEPTH_MM)
        if self.along_mm is None:
            return np.ones(len(x), dtype=np.bool_)
        low, high = self.along_mm
        return np.asarray((x[:, 2] >= low + margin_mm) & (x[:, 2] <= high - margin_mm))

    @property
    def reach_mm(self) -> float | None:
        """No point of the feature is further from its origin, along any axis; None of planes."""
        if self.shape.kind == "plane":
            return None
        length = max(map(abs, self.along_mm or (CIRCLE_DEPTH_MM,)))
        sizes = self.shape.sizes
        if self.shape.kind == "cone":
            return float(length / np.cos(sizes[1])) + BAND_MM
        return float(np.hypot(length, sizes.sum())) + BAND_MM

    @property
    def end_margin_mm(self) -> float:
        if self.along_mm is None:
            return 0.0
        return min(EDGE_MM, EDGE_SHARE * (self.along_mm[1] - self.along_mm[0]))


@dataclass(frozen=True)
class Assignment:
    """Indices of the points of a feature, and how many others a rule left out."""

    kept: NDArray[np.int64]
    edge: int
    incidence: int
    steep: bool = False
    """Most points were seen at too flat an angle, and taken all the same."""


def assign_points(
    face: Face, others: Sequence[Face], points_mm: Floats, sights: Floats
) -> Assignment:
    """The points of a scan that belong to a feature.

    Args:
        others: the other features, of whose edges points keep off.
        points_mm: (N, 3), part frame.
        sights: (N, 3) unit vectors from each point to the camera, part frame.
    """
    near = np.flatnonzero(face.is_within_boxes(points_mm))
    if not face.boxes_mm and face.reach_mm is not None:
        for axis in range(3):
            off = np.abs(points_mm[near, axis] - face.shape.origin_mm[axis])
            near = near[off <= face.reach_mm]
    x = face.shape.local(points_mm[near])
    close = face.is_along(x, 0.0)
    near, x = near[close], x[close]
    off = face.shape.distances(points_mm[near])
    close = np.abs(off) <= BAND_MM
    near, x = near[close], x[close]
    inner = face.is_along(x, face.end_margin_mm)
    for other in others:
        inner &= ~_is_at_edge(face, other, points_mm[near])
    edge = int((~inner).sum())
    near = near[inner]
    towards = face.side * face.shape.normals(points_mm[near])
    seen = np.sum(towards * sights[near], axis=1) >= STEEPEST_COSINE
    steep = 2 * int(seen.sum()) < len(near)
    if steep:  # a deep bore is seen at a flat angle everywhere
        return Assignment(near, edge, 0, len(near) > 0)
    return Assignment(near[seen], edge, int((~seen).sum()))


def _is_at_edge(face: Face, other: Face, points_mm: Floats) -> Mask:
    """(N,) whether points of a feature lie where another one meets it."""
    if face.shape.kind != "plane":
        if other.shape.kind != "plane" or face.along_mm is not None:
            return np.zeros(len(points_mm), dtype=np.bool_)
        return _is_on(other, points_mm)
    if other.shape.kind == "plane":
        return np.zeros(len(points_mm), dtype=np.bool_)
    if other.shape.kind in ("sphere", "torus") or (
        abs(float(face.shape.direction @ other.shape.direction)) < PARALLEL_COSINE
    ):
        return _is_on(other, points_mm)
    x = other.shape.local(points_mm)
    low, high = other.along_mm or (-CIRCLE_DEPTH_MM, CIRCLE_DEPTH_MM)
    # an opening takes the plane away, whatever depth of it is measured
    there = (x[:, 2] >= low - 5 * EDGE_MM) & (x[:, 2] <= high + 5 * EDGE_MM)
    off = other.shape.distances(points_mm)
    return np.asarray(there & (off >= -EDGE_MM if _ends_in(face, other) else off <= EDGE_MM))


def _is_on(other: Face, points_mm: Floats) -> Mask:
    """(N,) whether points lie on another feature as well, as at the foot of a ball on a plate."""
    there = other.is_within_boxes(points_mm) & other.is_along(other.shape.local(points_mm), 0.0)
    return np.asarray(there & (np.abs(other.shape.distances(points_mm)) <= EDGE_MM))


def _ends_in(plane: Face, other: Face) -> bool:
    """Whether a plane is the top of a boss or the floor of a bore, and not what they stand in."""
    if other.along_mm is None:
        return False
    middle = other.shape.origin_mm + sum(other.along_mm) / 2 * other.shape.direction
    is_above = float((middle - plane.shape.origin_mm) @ plane.shape.direction) > 0
    return is_above == other.is_internal

"""Visible parts of the crenellated block: edge parts, adjacent regions, corners.

Exact up to rounding. The block is the union of boxes along the axes; the visibility of an edge can
change only where, as seen from the camera, another edge crosses it. Every edge is therefore cut at
all such crossings, and one ray per piece decides.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.targets.crenellated_block import Crenellated, corners, edges
from crenel.metrology.transforms import Floats
from crenel.native.arguments import BOOL, F64, I64, Array, Function
from crenel.native.library import CRENEL

_pieces = Function(
    CRENEL,
    "visible_pieces",
    Array(F64, "e", 3),
    Array(F64, "e", 3),
    Array(F64, "boxes", 6),
    Array(F64, "grooves"),
    Array(F64, 3),
    Array(I64, "e", "e", written=True),
    Array(F64, "e", "e", 2, written=True),
    Array(I64, "e", "e", 2, written=True),
    Array(F64, "e", 13, written=True),
    returns=int,
)
_points = Function(
    CRENEL,
    "visible_points",
    Array(F64, "n", 3),
    Array(F64, "boxes", 6),
    Array(F64, "grooves"),
    Array(F64, 3),
    Array(BOOL, "n", written=True),
)


@dataclass(frozen=True)
class VisiblePart:
    """A part of an edge that the camera sees, between two points (3,) in the object frame.

    ``regions`` names the regions on either side: ``crest:I``, ``floor:J``, ``wall:I:L|R``,
    ``front``, ``back``, ``bottom`` or ``background``. The first lies on the side of ``(start -
    centre) x (end - centre)``.
    """

    edge: str
    start_mm: Floats
    end_mm: Floats
    regions: tuple[str, str]


@dataclass(frozen=True)
class Wireframe:
    """A block as arrays, for many visibility queries.

    ``starts_mm``, ``ends_mm``: (E, 3) edges in the order of ``names``;
    ``boxes_mm``: (B, 6) as xmin, xmax, ymin, ymax, zmin, zmax, the body first;
    ``regions``: names by the region numbers that ``find_visible_edges`` gives.
    """

    block: Crenellated
    names: tuple[str, ...]
    starts_mm: Floats
    ends_mm: Floats
    boxes_mm: Floats
    grooves_mm: Floats
    regions: tuple[str, ...]


@dataclass(frozen=True)
class VisibleEdges:
    """Visible parts as arrays of one length N.

    ``edge``: row in the wireframe; ``start``, ``end``: fractions of the edge;
    ``regions``: (N, 2) numbers of the adjacent regions.
    """

    edge: NDArray[np.int64]
    start: Floats
    end: Floats
    regions: NDArray[np.int64]


@lru_cache(maxsize=32)
def wireframe(block: Crenellated) -> Wireframe:
    """The arrays of a block."""
    drawn = edges(block)
    count = block.merlon_count
    x = block.edges_x_mm
    depth = (block.front_y_mm, block.back_y_mm)
    # The merlons extend down through the body, so that no ray passes between them.
    boxes = [(x[0], x[-1], *depth, block.base_z_mm, block.floor_z_mm)]
    boxes += [
        (x[2 * i], x[2 * i + 1], *depth, block.base_z_mm, block.crest_z_mm) for i in range(count)
    ]
    regions = ["background", "front", "back", "bottom"]
    regions += [f"crest:{i}" for i in range(count)] + [f"wall:{i}:L" for i in range(count)]
    regions += [f"wall:{i}:R" for i in range(count)] + [f"floor:{j}" for j in range(count - 1)]
    return Wireframe(
        block,
        tuple(edge.name for edge in drawn),
        np.array([edge.start_mm for edge in drawn], dtype=np.float64),
        np.array([edge.end_mm for edge in drawn], dtype=np.float64),
        np.array(boxes, dtype=np.float64),
        np.array(x[2::2], dtype=np.float64),
        tuple(regions),
    )


def find_visible_edges(frame: Wireframe, centre_mm: Floats) -> VisibleEdges:
    """Visible parts of all edges from an optical centre, as arrays.

    Args:
        frame: from ``wireframe``.
        centre_mm: (3,) optical centre in the object frame, outside the block.
    """
    edges = len(frame.starts_mm)
    edge, span = np.empty((edges, edges), np.int64), np.empty((edges, edges, 2))
    sides = np.empty((edges, edges, 2), np.int64)
    count = _pieces(
        frame.starts_mm,
        frame.ends_mm,
        frame.boxes_mm,
        frame.grooves_mm,
        np.ascontiguousarray(centre_mm, dtype=np.float64),
        edge,
        span,
        sides,
        np.empty((edges, 13)),
    )
    start, end = span.reshape(-1, 2)[:count].T.copy()
    return VisibleEdges(
        edge.ravel()[:count].copy(), start, end, sides.reshape(-1, 2)[:count].copy()
    )


def visible_parts(block: Crenellated, centre_mm: Floats) -> list[VisiblePart]:
    """Every part of every edge of the block that is visible from an optical centre.

    A part ends where it becomes hidden, and where an adjacent region changes. Edges at which a face
    ends in front of another face are included: they show only if the two differ in brightness.

    Args:
        centre_mm: (3,) optical centre in the object frame, outside the block.

    Returns:
        Parts with their ends (3,) in mm, object frame.
    """
    frame = wireframe(block)
    parts = find_visible_edges(frame, centre_mm)
    found = []
    for e, start, end, (one, other) in zip(
        parts.edge, parts.start, parts.end, parts.regions, strict=True
    ):
        origin, along = frame.starts_mm[e], frame.ends_mm[e] - frame.starts_mm[e]
        names = (frame.regions[one], frame.regions[other])
        found.append(
            VisiblePart(frame.names[e], origin + start * along, origin + end * along, names)
        )
    return found


def visible_corners(block: Crenellated, centre_mm: Floats) -> frozenset[str]:
    """Names of the corners of the block that are visible from an optical centre.

    Args:
        centre_mm: (3,) optical centre in the object frame, outside the block.
    """
    frame, points = wireframe(block), corners(block)
    visible = np.empty(len(points), np.bool_)
    _points(
        np.array(list(points.values()), dtype=np.float64),
        frame.boxes_mm,
        frame.grooves_mm,
        np.ascontiguousarray(centre_mm, dtype=np.float64),
        visible,
    )
    return frozenset(name for name, shown in zip(points, visible, strict=True) if shown)

"""What of the crenellated block a camera sees: edge parts, what adjoins them, corners.

Exact up to rounding. The block is the union of boxes along the axes; what is seen
of an edge can change only where, as seen from the camera, another edge crosses
it. So every edge is cut at all such crossings, and one ray to each piece decides.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import kernel
from app.metrology.crenellated import Crenellated, corners, edges
from app.metrology.frames import Floats

# A ray this far off an edge (radians) tells what adjoins it there.
_BESIDE_RAD = 1e-6
# Points nearer than this part of their distance lie on the surface, not behind it.
_ON_SURFACE = 1e-7
# Pieces shorter than this part of their edge are rounding.
_SHORTEST = 1e-9


@dataclass(frozen=True)
class VisiblePart:
    """A part of an edge that the camera sees, between two points (3,) in the object frame.

    ``regions`` names what adjoins it on either side: ``crest:I``, ``floor:J``,
    ``wall:I:L|R``, ``front``, ``back``, ``bottom`` or ``background``. The first lies
    on the side of ``(start - centre) x (end - centre)``.
    """

    edge: str
    start_mm: Floats
    end_mm: Floats
    regions: tuple[str, str]


@dataclass(frozen=True)
class Wireframe:
    """The block as arrays, for many questions about its visibility.

    ``starts_mm``, ``ends_mm``: (E, 3) edges in the order of ``names``;
    ``boxes_mm``: (B, 6) as xmin, xmax, ymin, ymax, zmin, zmax, the body first;
    ``regions``: names by the region numbers that ``seen`` gives.
    """

    names: tuple[str, ...]
    starts_mm: Floats
    ends_mm: Floats
    boxes_mm: Floats
    grooves_mm: Floats
    regions: tuple[str, ...]


@dataclass(frozen=True)
class Seen:
    """Visible parts as arrays of one length N.

    ``edge``: row in the wireframe; ``start``, ``end``: fractions of the edge;
    ``regions``: (N, 2) numbers of what adjoins on either side.
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
    # The merlons reach down through the body, so that no ray slips between them.
    boxes = [(x[0], x[-1], *depth, block.base_z_mm, block.floor_z_mm)]
    boxes += [
        (x[2 * i], x[2 * i + 1], *depth, block.base_z_mm, block.crest_z_mm) for i in range(count)
    ]
    regions = ["background", "front", "back", "bottom"]
    regions += [f"crest:{i}" for i in range(count)] + [f"wall:{i}:L" for i in range(count)]
    regions += [f"wall:{i}:R" for i in range(count)] + [f"floor:{j}" for j in range(count - 1)]
    return Wireframe(
        tuple(edge.name for edge in drawn),
        np.array([edge.start_mm for edge in drawn], dtype=np.float64),
        np.array([edge.end_mm for edge in drawn], dtype=np.float64),
        np.array(boxes, dtype=np.float64),
        np.array(x[2::2], dtype=np.float64),
        tuple(regions),
    )


@kernel
def _enter(
    boxes: Floats, b: int, origin: Floats, per: tuple[float, float, float]
) -> tuple[float, int]:
    """Distance in units of a ray at which it enters box ``b``, and through which side.

    Sides are numbered as the box's limits are; inf where the ray misses it. ``per``: one
    over the ray's components, 0 where it has none.
    """
    enter, leave, side = -np.inf, np.inf, 0
    for k in range(3):
        low, high = boxes[b, 2 * k] - origin[k], boxes[b, 2 * k + 1] - origin[k]
        if per[k] == 0.0:
            if low > 0.0 or high < 0.0:
                return np.inf, 0
            continue
        near, far = low * per[k], high * per[k]
        from_high = near > far
        if from_high:
            near, far = far, near
        if near > enter:
            enter, side = near, 2 * k + (1 if from_high else 0)
        leave = min(leave, far)
    if enter > leave or enter <= 0.0:
        return np.inf, 0
    return enter, side


@kernel
def _region(box: int, side: int, merlons: int, grooves: Floats, at_x: float) -> int:
    """The number of the region that a side of a box is, in the order of ``Wireframe.regions``."""
    if side == 2:
        return 1
    if side == 3:
        return 2
    if side == 4:
        return 3
    if side < 2:
        merlon = box - 1 if box > 0 else (merlons - 1 if side == 1 else 0)
        return 4 + merlons + merlon + (merlons if side == 1 else 0)
    if box > 0:
        return 4 + box - 1
    groove = 0
    while groove < merlons - 2 and at_x > grooves[groove]:
        groove += 1
    return 4 + 3 * merlons + groove


@kernel
def first_hit(boxes: Floats, grooves: Floats, origin: Floats, along: Floats) -> tuple[float, int]:
    """Distance in units of ``along`` and region number of the first surface; inf and 0 if none.

    ``boxes`` and ``grooves`` as in ``Wireframe``; ``origin``, ``along``: (3,), object frame.
    """
    nearest, region = np.inf, 0
    x, y, z = along
    per = (1 / x if x != 0.0 else 0.0, 1 / y if y != 0.0 else 0.0, 1 / z if z != 0.0 else 0.0)
    for b in range(len(boxes)):
        distance, side = _enter(boxes, b, origin, per)
        if distance < nearest:
            nearest = distance
            at_x = origin[0] + distance * along[0]
            region = _region(b, side, len(boxes) - 1, grooves, at_x)
    return nearest, region


@kernel
def _planes(starts: Floats, ends: Floats) -> Floats:
    """Normals (E, 3) of the planes through the centre and each edge, both ends from there."""
    normals = np.empty((len(starts), 3))
    for e in range(len(starts)):
        a, b, normal = starts[e], ends[e], normals[e]
        normal[0] = a[1] * b[2] - a[2] * b[1]
        normal[1] = a[2] * b[0] - a[0] * b[2]
        normal[2] = a[0] * b[1] - a[1] * b[0]
    return normals


@kernel
def _dot(a: Floats, b: Floats) -> float:
    return float(a[0] * b[0] + a[1] * b[1] + a[2] * b[2])


@kernel
def _cuts(starts: Floats, ends: Floats, normals: Floats, a: int, cuts: Floats) -> int:
    """Fractions of edge ``a`` at which others cross it as seen from the centre; their number.

    Ends from the centre; ``normals`` as ``_planes`` gives them.
    """
    cuts[0], cuts[1] = 0.0, 1.0
    n = 2
    for b in range(len(starts)):
        d0, d1 = _dot(normals[a], starts[b]), _dot(normals[a], ends[b])
        if a == b or d0 * d1 > 0.0 or d0 == d1:
            continue
        c0, c1 = _dot(normals[b], starts[a]), _dot(normals[b], ends[a])
        if c0 * c1 > 0.0 or c0 == c1:
            continue
        at, along = c0 / (c0 - c1), d0 / (d0 - d1)
        agreement = 0.0
        for k in range(3):
            ray_a = starts[a, k] + at * (ends[a, k] - starts[a, k])
            agreement += ray_a * (starts[b, k] + along * (ends[b, k] - starts[b, k]))
        if agreement > 0.0:
            cuts[n] = at
            n += 1
    return n


@kernel
def _beside(
    boxes: Floats, grooves: Floats, centre: Floats, ray: Floats, normal: Floats
) -> tuple[int, int]:
    """Regions on either side of a point of an edge; twice the same where it is not seen.

    ``ray`` (3,) to the point is moved.
    """
    hit, _ = first_hit(boxes, grooves, centre, ray)
    length = np.sqrt(_dot(normal, normal))
    if hit < 1.0 - _ON_SURFACE or length == 0.0:
        return 0, 0
    aside = _BESIDE_RAD * np.sqrt(_dot(ray, ray)) / length
    for k in range(3):
        ray[k] += aside * normal[k]
    _, one = first_hit(boxes, grooves, centre, ray)
    for k in range(3):
        ray[k] -= 2 * aside * normal[k]
    _, other = first_hit(boxes, grooves, centre, ray)
    return one, other


@kernel
def _seen(
    starts: Floats, ends: Floats, boxes: Floats, grooves: Floats, centre: Floats
) -> tuple[NDArray[np.int64], Floats, NDArray[np.int64]]:
    """Edge numbers (N,), fractions (N, 2) and regions (N, 2) of all visible pieces."""
    count = len(starts)
    edge = np.empty(count * count, np.int64)
    span = np.empty((count * count, 2))
    sides = np.empty((count * count, 2), np.int64)
    found = 0
    cuts = np.empty(count + 2)
    begin, finish = starts - centre, ends - centre
    normals = _planes(begin, finish)
    ray = np.empty(3)
    for a in range(count):
        order = np.sort(cuts[: _cuts(begin, finish, normals, a, cuts)])
        joined = False
        for k in range(len(order) - 1):
            if order[k + 1] - order[k] < _SHORTEST:
                continue
            middle = 0.5 * (order[k] + order[k + 1])
            for m in range(3):
                ray[m] = begin[a, m] + middle * (finish[a, m] - begin[a, m])
            one, other = _beside(boxes, grooves, centre, ray, normals[a])
            if one == other:
                joined = False
                continue
            if joined and sides[found - 1, 0] == one and sides[found - 1, 1] == other:
                span[found - 1, 1] = order[k + 1]
                continue
            edge[found] = a
            span[found, 0], span[found, 1] = order[k], order[k + 1]
            sides[found, 0], sides[found, 1] = one, other
            found += 1
            joined = True
    return edge[:found].copy(), span[:found].copy(), sides[:found].copy()


def seen(frame: Wireframe, centre_mm: Floats) -> Seen:
    """Visible parts of all edges from a camera's centre (3,) in the object frame."""
    edge, span, sides = _seen(
        frame.starts_mm,
        frame.ends_mm,
        frame.boxes_mm,
        frame.grooves_mm,
        np.ascontiguousarray(centre_mm, dtype=np.float64),
    )
    return Seen(edge, span[:, 0], span[:, 1], sides)


def visible_parts(block: Crenellated, centre_mm: Floats) -> list[VisiblePart]:
    """Every part of every edge that is seen from ``centre_mm`` (3,), object frame.

    A part ends where it is hidden and where what adjoins it changes. Edges at which
    a face ends in front of another face are listed too: they show only where the
    two differ in brightness.
    """
    frame = wireframe(block)
    parts = seen(frame, centre_mm)
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
    """Names of the corners that are seen from ``centre_mm`` (3,), object frame."""
    frame = wireframe(block)
    centre = np.ascontiguousarray(centre_mm, dtype=np.float64)
    names = []
    for name, point in corners(block).items():
        hit, _ = first_hit(frame.boxes_mm, frame.grooves_mm, centre, point - centre)
        if hit >= 1.0 - _ON_SURFACE:
            names.append(name)
    return frozenset(names)

"""Where the camera may stand, voted for by bearings: the inner loops of identification."""

import numpy as np

from app.metrology.compiled import kernel
from app.metrology.frames import Floats

# Places in the plane across X that are followed up, and along X for each of them.
_KEPT = 48
_ALONG = 4


@kernel
def agreeing(
    normals: Floats, weight: Floats, points: Floats, c0: float, c1: float, near_rad: float
) -> float:
    """Weight of the bearings that pass a point, seen from (c0, c1).

    ``normals``: (B, 2) perpendicular to the bearings; ``points``: (P, 2); a bearing counts
    in full when it passes through a point, and not at all ``near_rad`` beside it.
    """
    total = 0.0
    for s in range(len(normals)):
        best = near_rad
        for p in range(len(points)):
            d0, d1 = points[p, 0] - c0, points[p, 1] - c1
            off = abs(normals[s, 0] * d0 + normals[s, 1] * d1)
            best = min(best, off / np.sqrt(d0 * d0 + d1 * d1 + 1e-12))
        total += weight[s] * (1.0 - (best / near_rad) ** 2)
    return total


@kernel
def _keep(places: Floats, scores: Floats, c0: float, c1: float, score: float) -> None:
    """Enters a place into the list of the best, replacing the same one or the worst."""
    slot = 0
    for k in range(len(places)):
        apart = abs(places[k, 0] - c0) + abs(places[k, 1] - c1)
        if scores[k] > 0 and apart < 0.02 * (abs(c0) + abs(c1)):
            slot = k
            break
        if scores[k] < scores[slot]:
            slot = k
    if score > scores[slot]:
        scores[slot] = score
        places[slot, 0], places[slot, 1] = c0, c1


@kernel
def _in_view(c0: float, c1: float, near: Floats, view: Floats) -> bool:
    """Whether a camera at (c0, c1) in y and z stands before ``near`` (2,) and sees the block.

    ``view``: the block's middle and the camera's axis in y and z, the tangent of half its
    field of view, and the least distance along the axis.
    """
    if c0 >= near[0] or c1 <= near[1]:
        return False
    d0, d1 = view[0] - c0, view[1] - c1
    along = d0 * view[2] + d1 * view[3]
    aside = abs(d0 * view[3] - d1 * view[2])
    size = np.sqrt(view[2] ** 2 + view[3] ** 2)
    return bool(along > view[5] * size * size and aside < view[4] * along / size)


@kernel
def across_x(
    bearings: Floats, weight: Floats, ends: Floats, near_rad: float, near: Floats, view: Floats
) -> tuple[Floats, Floats]:
    """Places (K, 2) in y and z from which bearings (B, 2) pass the block's edges, and their votes.

    Every two bearings to every two ``ends`` (P, 2) cross in a place; all others vote.
    Places that do not see the block (``_in_view``) are passed over.
    """
    places, scores = np.zeros((_KEPT, 2)), np.zeros(_KEPT)
    for a in range(len(bearings)):
        for b in range(a + 1, len(bearings)):
            na, nb = bearings[a], bearings[b]
            det = na[0] * nb[1] - na[1] * nb[0]
            if abs(det) < near_rad:
                continue
            for p in range(len(ends)):
                ha = na[0] * ends[p, 0] + na[1] * ends[p, 1]
                for q in range(len(ends)):
                    if p == q:
                        continue
                    hb = nb[0] * ends[q, 0] + nb[1] * ends[q, 1]
                    cy, cz = (ha * nb[1] - hb * na[1]) / det, (na[0] * hb - nb[0] * ha) / det
                    if not _in_view(cy, cz, near, view):
                        continue
                    score = agreeing(bearings, weight, ends, cy, cz, near_rad)
                    _keep(places, scores, cy, cz, score)
    return places, scores


@kernel
def _crossings(normals: Floats, points: Floats, at: float, spots: Floats, filled: int) -> int:
    """Adds to ``spots`` where each bearing to each point crosses the line second = ``at``."""
    for s in range(len(normals)):
        if abs(normals[s, 0]) > 1e-3:
            for p in range(len(points)):
                ratio = normals[s, 1] / normals[s, 0]
                spots[filled] = points[p, 0] + ratio * (points[p, 1] - at)
                filled += 1
    return filled


@kernel
def _densest(order: Floats, width: float, taken: Floats) -> tuple[int, float]:
    """How many of the sorted values lie within ``width``, at most, and their middle one.

    Places within two widths of those ``taken`` are passed over.
    """
    most, place, last = 0, 0.0, 0
    for first in range(len(order)):
        while last < len(order) and order[last] - order[first] < width:
            last += 1
        at = order[(first + last - 1) // 2]
        if last - first > most and (len(taken) == 0 or np.abs(taken - at).min() >= 2 * width):
            most, place = last - first, at
    return most, place


@kernel
def along_x(
    places: Floats,
    votes: Floats,
    sides: Floats,
    side_weight: Floats,
    across: Floats,
    walls: Floats,
    wall_weight: Floats,
    upright: Floats,
    near_rad: float,
) -> tuple[Floats, Floats]:
    """Centres (K, 3) and their votes (K,): each place in y and z with its best places in x.

    Args:
        places, votes: from ``across_x``.
        sides: (S, 2) bearings, in x and z, of edges along Y; across: (P, 2) those edges.
        walls: (W, 2) bearings, in x and y, of edges along Z; upright: (Q, 2) those edges.
    """
    centres, scores = np.zeros((_ALONG * len(places), 3)), np.zeros(_ALONG * len(places))
    spots = np.empty(len(sides) * len(across) + len(walls) * len(upright))
    for k in range(len(places)):
        if votes[k] <= 0:
            continue
        cy, cz = places[k, 0], places[k, 1]
        filled = _crossings(sides, across, cz, spots, 0)
        filled = _crossings(walls, upright, cy, spots, filled)
        order = np.sort(spots[:filled])
        width = 2 * near_rad * np.sqrt(cy * cy + cz * cz)
        for m in range(_ALONG):
            row = _ALONG * k + m
            count, cx = _densest(order, width, centres[_ALONG * k : row, 0])
            if count == 0:
                break
            centres[row, 0], centres[row, 1], centres[row, 2] = cx, cy, cz
            scores[row] = votes[k] + agreeing(sides, side_weight, across, cx, cz, near_rad)
            scores[row] += agreeing(walls, wall_weight, upright, cx, cy, near_rad)
    return centres, scores

"""Where the camera may stand, voted for by bearings: the inner loops of identification."""

import numpy as np

from app.metrology.compiled import kernel
from app.metrology.frames import Floats

# Places in the plane across a direction that are followed up, and along it for each of them.
_KEPT = 24
_ALONG = 4
# So many bearings, the weightiest, say where the camera may stand; all vote.
_DRAWN = 6
# Placings with less than this share of the best one's votes are of no interest.
WORTH = 0.7


@kernel
def agreeing(
    normals: Floats,
    weight: Floats,
    points: Floats,
    c0: float,
    c1: float,
    near_rad: float,
    needed: float = 0.0,
) -> float:
    """Weight of the bearings that pass a point, seen from (c0, c1); 0 where it falls short.

    ``normals``: (B, 2) perpendicular to the bearings; ``points``: (P, 2); a bearing counts
    in full when it passes through a point, and not at all ``near_rad`` beside it.
    ``needed``: what it must come to, to be of interest.
    """
    total, left = 0.0, weight.sum()
    for s in range(len(normals)):
        if total + left < needed:
            return 0.0
        best = near_rad
        n0, n1 = normals[s, 0], normals[s, 1]
        at = n0 * c0 + n1 * c1
        for p in range(len(points)):
            off = abs(n0 * points[p, 0] + n1 * points[p, 1] - at)
            d0, d1 = points[p, 0] - c0, points[p, 1] - c1
            if off * off < best * best * (d0 * d0 + d1 * d1):
                best = off / np.sqrt(d0 * d0 + d1 * d1)
        total += weight[s] * (1.0 - (best / near_rad) ** 2)
        left -= weight[s]
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
def _in_view(c0: float, c1: float, view: Floats) -> bool:
    """Whether a camera at (c0, c1) in two coordinates sees the block from its front and above.

    ``view``, in those coordinates: the block's middle, the camera's axis, the least and the
    greatest values that a camera before and above it has; then the tangent of half the
    field of view, the least and the greatest distance along the axis.
    """
    if c0 <= view[4] or c1 <= view[5] or c0 >= view[6] or c1 >= view[7]:
        return False
    d0, d1 = view[0] - c0, view[1] - c1
    along = d0 * view[2] + d1 * view[3]
    aside = abs(d0 * view[3] - d1 * view[2])
    squared = view[2] ** 2 + view[3] ** 2
    if along <= view[9] * squared or along >= view[10] * squared:
        return False
    return bool(aside < view[8] * along / np.sqrt(squared))


@kernel
def crossings(
    bearings: Floats,
    weight: Floats,
    points: Floats,
    near_rad: float,
    view: Floats,
    needed: float,
) -> tuple[Floats, Floats]:
    """Places (K, 2) in a plane from which bearings (B, 2) pass edges, seen end on, and their votes.

    Every two of the weightiest bearings to every two ``points`` (P, 2) cross in a place; all
    others vote. Places that do not see the block (``_in_view``) are passed over, and those
    with fewer votes than ``needed``.
    """
    places, scores = np.zeros((_KEPT, 2)), np.zeros(_KEPT)
    first = min(len(bearings), _DRAWN)
    for a in range(first):
        for b in range(a + 1, first):
            na, nb = bearings[a], bearings[b]
            det = na[0] * nb[1] - na[1] * nb[0]
            if abs(det) < near_rad:
                continue
            for p in range(len(points)):
                ha = na[0] * points[p, 0] + na[1] * points[p, 1]
                for q in range(len(points)):
                    if p == q:
                        continue
                    hb = nb[0] * points[q, 0] + nb[1] * points[q, 1]
                    c0, c1 = (ha * nb[1] - hb * na[1]) / det, (na[0] * hb - nb[0] * ha) / det
                    if not _in_view(c0, c1, view):
                        continue
                    score = agreeing(bearings, weight, points, c0, c1, near_rad, needed)
                    if score == 0.0:
                        continue
                    _keep(places, scores, c0, c1, score)
                    needed = max(needed, scores.min())
    return places, scores


@kernel
def _spots(normals: Floats, points: Floats, at: float, spots: Floats, filled: int) -> int:
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
def completed(
    places: Floats,
    votes: Floats,
    one: Floats,
    one_weight: Floats,
    one_points: Floats,
    other: Floats,
    other_weight: Floats,
    other_points: Floats,
    near_rad: float,
    best: float,
) -> tuple[Floats, Floats]:
    """Centres (K, 3) and their votes (K,): each place with its best third coordinates.

    A centre is third, first, second coordinate.

    Args:
        places, votes: from ``crossings``.
        one: (S, 2) bearings, in the third and the second coordinate, of edges along the
            first; one_points: (P, 2) those edges.
        other: (W, 2) bearings, in the third and the first coordinate, of edges along the
            second; other_points: (Q, 2) those edges.
        best: the votes of the best placing so far.
    """
    centres, scores = np.zeros((_ALONG * len(places), 3)), np.zeros(_ALONG * len(places))
    spots = np.empty(len(one) * len(one_points) + len(other) * len(other_points))
    most = one_weight.sum() + other_weight.sum()
    for k in np.argsort(-votes):
        if votes[k] <= 0 or votes[k] + most < WORTH * best:
            break
        c0, c1 = places[k, 0], places[k, 1]
        filled = _spots(one, one_points, c1, spots, 0)
        filled = _spots(other, other_points, c0, spots, filled)
        order = np.sort(spots[:filled])
        width = 2 * near_rad * np.sqrt(c0 * c0 + c1 * c1)
        for m in range(_ALONG):
            row = _ALONG * k + m
            count, c = _densest(order, width, centres[_ALONG * k : row, 0])
            if count == 0:
                break
            centres[row, 0], centres[row, 1], centres[row, 2] = c, c0, c1
            score = votes[k] + agreeing(one, one_weight, one_points, c, c1, near_rad)
            score += agreeing(other, other_weight, other_points, c, c0, near_rad)
            scores[row] = score
            best = max(best, score)
    return centres, scores

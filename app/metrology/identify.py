"""Which edge of the block each segment of the picture is: poses voted for, then drawn and judged.

With the three directions and the focal length known, a segment along the grooves
is a bearing in the plane across them: the camera lies on the line through the
block's corner in that bearing. Two bearings to two corners place the camera, all
others vote. The block's mirror image is tried as well, so that it can be told
from the block.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import permutations

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import kernel
from app.metrology.crenellated import Crenellated
from app.metrology.directions import Directions, lengths, plane_normals
from app.metrology.frames import Floats

# How far a segment may lie from the edge it votes for, over the picture's longer side.
_NEAR = 0.008
# Segments longer than this, over the picture's longer side, count as this long.
_LONG = 0.15


@dataclass(frozen=True)
class Placing:
    """A guess of how the block stands before the camera.

    ``x_cam = rotation @ (x_obj - centre_mm)``; ``focal`` over the picture's longer side.
    """

    rotation: Floats
    centre_mm: Floats
    focal: float
    mirrored: bool
    votes: float


def mirrored(block: Crenellated) -> Crenellated:
    """The block's mirror image, which is also how the block reads from its back."""
    return replace(block, edges_x_mm=tuple(-x for x in reversed(block.edges_x_mm)))


def placings(
    directions: Directions, lines: Floats, block: Crenellated, most: int = 24
) -> list[Placing]:
    """Placings of the block and of its mirror image, most votes first.

    Args:
        directions: three perpendicular directions in the picture.
        lines: (S, 4) the segments they were found from.
        block: the block by its certificate.
        most: how many to return.
    """
    normals = plane_normals(lines, directions.focal)
    # A long edge of a table has no more to say than one of the block's.
    weight = np.minimum(lengths(lines), _LONG)
    middle = (lines[:, :2] + lines[:, 2:]) / 2
    followed = directions.family >= 0
    view = np.append(np.average(middle[followed], axis=0, weights=weight[followed]), 1.0)
    view[2] = directions.focal
    found: list[Placing] = []
    for rotation, order in _labellings(directions.rotation, view / np.linalg.norm(view)):
        families = [directions.family == axis for axis in order]
        for reverse in (False, True):
            form = mirrored(block) if reverse else block
            seen_mm = normals @ rotation
            votes = _vote(seen_mm, weight, families, form, directions.focal)
            forward = view / np.linalg.norm(view) @ rotation
            for centre, score in votes:
                middle_mm = _middle(form)
                if (middle_mm - centre) @ forward > 0:
                    found.append(Placing(rotation, centre, directions.focal, reverse, score))
    found.sort(key=lambda one: -one.votes)
    return found[:most]


def _middle(block: Crenellated) -> Floats:
    x = block.edges_x_mm
    return np.array(
        [
            (x[0] + x[-1]) / 2,
            (block.front_y_mm + block.back_y_mm) / 2,
            (block.base_z_mm + block.crest_z_mm) / 2,
        ]
    )


def _labellings(axes: Floats, view: Floats) -> Iterator[tuple[Floats, tuple[int, int, int]]]:
    """Rotations (3, 3) from object to camera that show the block from its front and above."""
    for order in permutations((0, 1, 2)):
        _, y, z = (axes[:, k] for k in order)
        for y_sense in (1.0, -1.0):
            for z_sense in (1.0, -1.0):
                # Y runs away from the camera, Z towards it, or nearly across the view.
                if y_sense * (y @ view) < -0.05 or z_sense * (z @ view) > 0.05:
                    continue
                columns = [np.cross(y_sense * y, z_sense * z), y_sense * y, z_sense * z]
                yield np.column_stack(columns), (order[0], order[1], order[2])


def _vote(
    seen_mm: Floats,
    weight: Floats,
    families: list[NDArray[np.bool_]],
    block: Crenellated,
    focal: float,
) -> list[tuple[Floats, float]]:
    """Camera centres (3,) in the object frame and the length of the segments that agree."""
    along_x, along_y, along_z = families
    depths = (block.front_y_mm, block.back_y_mm)
    levels = (block.crest_z_mm, block.floor_z_mm, block.base_z_mm)
    # The base's back edge is below and behind: never seen.
    ends = np.array([(y, z) for z in levels for y in depths][:5])
    x = np.array(block.edges_x_mm)
    across = np.array(
        [(at, levels[0]) for at in x]
        + [(at, levels[1]) for at in x[1:-1]]
        + [(at, levels[2]) for at in (x[0], x[-1])]
    )
    upright = np.array([(at, y) for at in x for y in depths])
    near_rad = _NEAR / focal
    bearings, bearing_weight = _merged(seen_mm[along_x][:, 1:], weight[along_x], near_rad)
    sides = np.vstack([seen_mm[along_y][:, [0, 2]], np.empty((0, 2))])
    walls = np.vstack([seen_mm[along_z][:, :2], np.empty((0, 2))])
    centres, scores = _place(
        bearings,
        bearing_weight,
        ends,
        sides,
        weight[along_y],
        across,
        walls,
        weight[along_z],
        upright,
        near_rad,
    )
    best = np.argsort(-scores)[:12]
    return [(centres[k], float(scores[k])) for k in best if scores[k] > 0]


def _merged(bearings: Floats, weight: Floats, near_rad: float) -> tuple[Floats, Floats]:
    """Bearings of collinear segments merged; the ten longest."""
    angle = np.arctan2(bearings[:, 1], bearings[:, 0]) % np.pi
    order = np.argsort(-weight)
    kept: list[float] = []
    total: list[float] = []
    for k in order:
        gaps = [abs((angle[k] - one + np.pi / 2) % np.pi - np.pi / 2) for one in kept]
        if gaps and min(gaps) < near_rad:
            total[int(np.argmin(gaps))] += weight[k]
        else:
            kept.append(angle[k])
            total.append(weight[k])
    best = np.argsort(-np.array(total))[:10]
    angles = np.array(kept)[best]
    return np.column_stack([np.cos(angles), np.sin(angles)]), np.array(total)[best]


@kernel
def _agreeing(
    normals: Floats, weight: Floats, points: Floats, c0: float, c1: float, near_rad: float
) -> float:  # pragma: no cover - compiled
    """Length of the bearings that pass a point within ``near_rad``, seen from (c0, c1)."""
    total = 0.0
    for s in range(len(normals)):
        n = normals[s]
        best = near_rad
        for p in range(len(points)):
            d0, d1 = points[p, 0] - c0, points[p, 1] - c1
            off = abs(n[0] * d0 + n[1] * d1) / np.sqrt(d0 * d0 + d1 * d1 + 1e-12)
            best = min(best, off)
        total += weight[s] * (1.0 - (best / near_rad) ** 2)
    return total


@kernel
def _place(
    bearings: Floats,
    bearing_weight: Floats,
    ends: Floats,
    sides: Floats,
    side_weight: Floats,
    across: Floats,
    walls: Floats,
    wall_weight: Floats,
    upright: Floats,
    near_rad: float,
) -> tuple[Floats, Floats]:  # pragma: no cover - compiled
    """Candidate centres (K, 3) and their votes (K,); unused rows have none."""
    keep = 48
    flat = np.zeros((keep, 2))
    flat_score = np.zeros(keep)
    for a in range(len(bearings)):
        for b in range(a + 1, len(bearings)):
            na, nb = bearings[a], bearings[b]
            det = na[0] * nb[1] - na[1] * nb[0]
            if abs(det) < near_rad:
                continue
            for p in range(len(ends)):
                for q in range(len(ends)):
                    if p == q:
                        continue
                    ha = na[0] * ends[p, 0] + na[1] * ends[p, 1]
                    hb = nb[0] * ends[q, 0] + nb[1] * ends[q, 1]
                    cy, cz = (ha * nb[1] - hb * na[1]) / det, (na[0] * hb - nb[0] * ha) / det
                    score = _agreeing(bearings, bearing_weight, ends, cy, cz, near_rad)
                    worst, same = 0, -1
                    for k in range(keep):
                        if flat_score[k] < flat_score[worst]:
                            worst = k
                        apart = abs(flat[k, 0] - cy) + abs(flat[k, 1] - cz)
                        if flat_score[k] > 0 and apart < 0.02 * (abs(cy) + abs(cz)):
                            same = k
                    slot = same if same >= 0 else worst
                    if score > flat_score[slot]:
                        flat_score[slot] = score
                        flat[slot, 0], flat[slot, 1] = cy, cz
    centres = np.zeros((keep * 3, 3))
    scores = np.zeros(keep * 3)
    spots = np.empty(len(sides) * len(across) + len(walls) * len(upright))
    for k in range(keep):
        if flat_score[k] <= 0:
            continue
        cy, cz = flat[k, 0], flat[k, 1]
        n = 0
        for s in range(len(sides)):
            if abs(sides[s, 0]) > 1e-3:
                for p in range(len(across)):
                    spots[n] = across[p, 0] + sides[s, 1] / sides[s, 0] * (across[p, 1] - cz)
                    n += 1
        for s in range(len(walls)):
            if abs(walls[s, 0]) > 1e-3:
                for p in range(len(upright)):
                    spots[n] = upright[p, 0] + walls[s, 1] / walls[s, 0] * (upright[p, 1] - cy)
                    n += 1
        # The densest places of the candidates, then their full count of votes.
        order = np.sort(spots[:n])
        reach = near_rad * np.sqrt(cy * cy + cz * cz)
        for m in range(3):
            best_count, best_at = 0, 0.0
            last = 0
            for first in range(n):
                while last < n and order[last] - order[first] < 2 * reach:
                    last += 1
                at = order[(first + last - 1) // 2]
                taken = False
                for other in range(m):
                    apart = abs(centres[3 * k + other, 0] - at)
                    taken = taken or apart < 4 * reach
                if not taken and last - first > best_count:
                    best_count, best_at = last - first, at
            if best_count == 0:
                break
            centre = centres[3 * k + m]
            centre[0], centre[1], centre[2] = best_at, cy, cz
            scores[3 * k + m] = (
                flat_score[k]
                + _agreeing(sides, side_weight, across, best_at, cz, near_rad)
                + _agreeing(walls, wall_weight, upright, best_at, cy, near_rad)
            )
    return centres, scores

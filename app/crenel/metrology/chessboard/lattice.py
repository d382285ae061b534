"""Which saddles are the corners of one chessboard, and the position of each on it."""

from typing import TYPE_CHECKING

import numpy as np

from crenel.metrology.chessboard.perspective import predict_corner
from crenel.metrology.chessboard.saddle_points import Saddles
from crenel.metrology.transforms import Floats

if TYPE_CHECKING:
    from scipy.spatial import cKDTree

# A corner is looked for around where its neighbours put it, in shares of their distance:
# first by the next two alone, then by a perspective through those around it.
NEAR, NEARER = 0.25, 0.15
# Neighbours lie along the edges through a corner, to this angle, and are of opposite phase.
ALONG_DEG, OPPOSITE_RAD = 30.0, 2.2
NEIGHBOURS = 16
# Number of columns and rows beyond the detected ones in which further corners are searched.
REACH = 2
ROUNDS = 6
# A grid whose rows run along the diagonals of squares has at least so much more room for corners.
SKEWED = 1.4

Lattice = dict[tuple[int, int], int]


def find_lattices(saddles: Saddles, wanted: int) -> list[Lattice]:
    """Regular grids of saddles, the largest first: saddle by place (column, row).

    Args:
        wanted: a grid with this number of corners ends the search.
    """
    if len(saddles.uv_px) < 4:
        return []
    from scipy.spatial import cKDTree  # slow to load, and needed for boards alone

    tree = cKDTree(saddles.uv_px)
    found: list[Lattice] = []
    used: set[int] = set()
    for seed in range(len(saddles.uv_px)):
        if seed in used:
            continue
        square = _first_square(saddles, tree, seed)
        if square is None:
            continue
        lattice = _complete(saddles, tree, _grow_lattice(saddles, tree, square))
        used.update(lattice.values())
        if len(lattice) >= 4:
            found.append(lattice)
        if len(lattice) >= wanted:
            break
    return sorted(found, key=len, reverse=True)


def _opposite(saddles: Saddles, one: int, other: int) -> bool:
    apart = float(saddles.phase[one] - saddles.phase[other])
    return abs((apart + np.pi) % (2 * np.pi) - np.pi) > OPPOSITE_RAD


def _first_square(saddles: Saddles, tree: "cKDTree", seed: int) -> Lattice | None:
    """A seed with a neighbour along each of its two edges, and the opposite corner."""
    uv = saddles.uv_px
    near = np.atleast_1d(tree.query(uv[seed], k=min(NEIGHBOURS, len(uv)))[1])
    bright = -saddles.phase[seed] / 2
    beside: list[int] = []
    for edge in (bright + np.pi / 4, bright - np.pi / 4):
        direction = np.array([np.cos(edge), np.sin(edge)])
        for other in near[1:]:
            away = uv[other] - uv[seed]
            along = abs(float(away @ direction)) / float(np.linalg.norm(away))
            if along > np.cos(np.radians(ALONG_DEG)) and _opposite(saddles, seed, int(other)):
                beside.append(int(other))
                break
    if len(beside) < 2:
        return None
    a, b = uv[beside[0]] - uv[seed], uv[beside[1]] - uv[seed]
    lengths = sorted((float(np.linalg.norm(a)), float(np.linalg.norm(b))))
    if lengths[0] < 0.3 * lengths[1]:
        return None
    across = _saddle_at(saddles, tree, uv[seed] + a + b, NEAR * lengths[0], beside[0])
    if across is None:
        return None
    return {(0, 0): seed, (1, 0): beside[0], (0, 1): beside[1], (1, 1): across}


def _saddle_at(
    saddles: Saddles, tree: "cKDTree", uv: Floats, reach: float, opposite_to: int
) -> int | None:
    """The saddle next to a position, if its phase is opposite to that of another one."""
    distance, found = tree.query(uv, distance_upper_bound=reach)
    if not np.isfinite(distance) or not _opposite(saddles, int(found), opposite_to):
        return None
    return int(found)


def _grow_lattice(saddles: Saddles, tree: "cKDTree", lattice: Lattice) -> Lattice:
    """The grid with all corners that continue two neighbours in a row or column."""
    lattice = dict(lattice)
    open_ends = list(lattice)
    taken = set(lattice.values())
    while open_ends:
        i, j = open_ends.pop()
        here = lattice[i, j]
        for di, dj in ((1, 0), (-1, 0), (0, 1), (0, -1)):
            place = (i + di, j + dj)
            step = _step(saddles, lattice, (i, j), (di, dj))
            if place in lattice or step is None:
                continue
            reach = NEAR * float(np.linalg.norm(step))
            found = _saddle_at(saddles, tree, saddles.uv_px[here] + step, reach, here)
            if found is not None and found not in taken:
                lattice[place] = found
                taken.add(found)
                open_ends.append(place)
    return lattice


def _step(
    saddles: Saddles, lattice: Lattice, at: tuple[int, int], way: tuple[int, int]
) -> Floats | None:
    """The pixels (2,) from one corner to the next, from the previous corner or from the next
    line."""
    uv = saddles.uv_px
    before = lattice.get((at[0] - way[0], at[1] - way[1]))
    if before is not None:
        return np.asarray(uv[lattice[at]] - uv[before])
    for side in (1, -1):
        beside = (at[0] + side * way[1], at[1] + side * way[0])
        ahead = (beside[0] + way[0], beside[1] + way[1])
        if beside in lattice and ahead in lattice:
            return np.asarray(uv[lattice[ahead]] - uv[lattice[beside]])
    return None


def complete_lattice(saddles: Saddles, lattice: Lattice) -> Lattice:
    """With the corners beyond gaps and borders, where those around put them; without misfits."""
    from scipy.spatial import cKDTree  # slow to load, and needed for boards alone

    return _complete(saddles, cKDTree(saddles.uv_px), lattice)


def _complete(saddles: Saddles, tree: "cKDTree", lattice: Lattice) -> Lattice:
    for _ in range(ROUNDS):
        lattice = _straighten(lattice)
        found = _add_missing(saddles, tree, _drop_misfits(saddles, lattice))
        if found == lattice:
            break
        lattice = found
    return _drop_misfits(saddles, lattice)


def _straighten(lattice: Lattice) -> Lattice:
    """The same corners in the rows and columns that give them the smallest rectangle.

    On a board seen at a slant, the corner two columns and a row away may be nearer than the next
    one, so that the grid grew along diagonals.
    """
    places = np.array(list(lattice))
    while True:
        room = int((np.ptp(places, axis=0) + 1).prod())
        across = places[:, ::-1]
        ways = [places + across * by for by in ([2, 0], [-2, 0], [0, 2], [0, -2])]
        rooms = [int((np.ptp(way, axis=0) + 1).prod()) for way in ways]
        if SKEWED * min(rooms) > room:
            break
        places = ways[rooms.index(min(rooms))]
    return {(int(i), int(j)): k for (i, j), k in zip(places, lattice.values(), strict=True)}


def _drop_misfits(saddles: Saddles, lattice: Lattice) -> Lattice:
    """Without those that lie off the perspective of the corners around, the worst first."""
    kept = dict(lattice)
    while len(kept) > 4:
        places = np.array(list(kept))
        uv = saddles.uv_px[list(kept.values())]
        worst, at = 1.0, -1
        for k, place in enumerate(places):
            predicted = predict_corner(places, uv, place)
            if predicted is None:
                continue
            off = float(np.linalg.norm(predicted[0] - uv[k])) / (NEARER * predicted[1])
            if off > worst:
                worst, at = off, k
        if at < 0:
            break
        del kept[int(places[at, 0]), int(places[at, 1])]
    return kept


def _add_missing(saddles: Saddles, tree: "cKDTree", lattice: Lattice) -> Lattice:
    """With the saddles where the corners around put them, of the phase that is due there."""
    if len(lattice) < 6:
        return lattice
    places = np.array(list(lattice))
    uv = saddles.uv_px[list(lattice.values())]
    even = _even_phase(saddles, lattice)
    low, high = places.min(axis=0) - REACH, places.max(axis=0) + REACH
    taken = set(lattice.values())
    found = dict(lattice)
    for place in np.ndindex(*(high - low + 1)):
        wanted = np.array(place) + low
        key = (int(wanted[0]), int(wanted[1]))
        if key in lattice or np.abs(places - wanted).max(axis=1).min() > REACH:
            continue
        predicted = predict_corner(places, uv, wanted)
        if predicted is None:
            continue
        distance, saddle = tree.query(predicted[0], distance_upper_bound=NEARER * predicted[1])
        if not np.isfinite(distance) or int(saddle) in taken:
            continue
        turned = saddles.phase[saddle] + np.pi * (sum(key) % 2)
        if np.cos(turned - even) > -np.cos(OPPOSITE_RAD):
            found[key] = int(saddle)
            taken.add(int(saddle))
    return found


def _even_phase(saddles: Saddles, lattice: Lattice) -> float:
    """The phase of corners with an even sum of column and row."""
    sums = np.array([sum(place) % 2 for place in lattice])
    phase = saddles.phase[list(lattice.values())] + np.pi * sums
    return float(np.angle(np.mean(np.exp(1j * phase))))

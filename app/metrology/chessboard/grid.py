"""Which saddles are the corners of one chessboard, and where each stands in it."""

from typing import TYPE_CHECKING

import cv2
import numpy as np
from numpy.typing import NDArray

from app.metrology.chessboard.saddle_points import Saddles
from app.metrology.transforms import Floats

if TYPE_CHECKING:
    from scipy.spatial import cKDTree

# A corner is looked for around where its neighbours put it, in shares of their distance:
# first by the nearest alone, then by a perspective through all.
NEAR, NEARER = 0.25, 0.12
# Neighbours lie along the edges through a corner, to this angle, and are of opposite phase.
ALONG_DEG, OPPOSITE_RAD = 30.0, 2.2
NEIGHBOURS = 16
# Columns and rows beyond those found, in which further ones are sought.
REACH = 2

Lattice = dict[tuple[int, int], int]


def largest_lattice(saddles: Saddles, wanted: int) -> Lattice:
    """Saddle by its place (column, row), of the largest regular grid, counted from anywhere.

    Args:
        wanted: a grid of so many corners ends the search.
    """
    if len(saddles.uv_px) < 4:
        return {}
    from scipy.spatial import cKDTree  # slow to load, and needed for boards alone

    tree = cKDTree(saddles.uv_px)
    best: Lattice = {}
    used: set[int] = set()
    for seed in range(len(saddles.uv_px)):
        if seed in used:
            continue
        square = _first_square(saddles, tree, seed)
        if square is None:
            continue
        found = _complete_lattice(saddles, tree, _grow_lattice(saddles, tree, square))
        used.update(found.values())
        if len(found) > len(best):
            best = found
        if len(best) >= wanted:
            break
    return best


def _opposite(saddles: Saddles, one: int, other: int) -> bool:
    apart = float(saddles.phase[one] - saddles.phase[other])
    return abs((apart + np.pi) % (2 * np.pi) - np.pi) > OPPOSITE_RAD


def _first_square(saddles: Saddles, tree: "cKDTree", seed: int) -> Lattice | None:
    """A seed with a neighbour along each of its two edges, and the corner across."""
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
    """The saddle next to a place, where it is of opposite phase to another one."""
    distance, found = tree.query(uv, distance_upper_bound=reach)
    if not np.isfinite(distance) or not _opposite(saddles, int(found), opposite_to):
        return None
    return int(found)


def _grow_lattice(saddles: Saddles, tree: "cKDTree", lattice: Lattice) -> Lattice:
    """With all that continue two neighbours in a row or column."""
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
    """The pixels (2,) from one corner to the next, by the one before or by the next line's."""
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


def _complete_lattice(saddles: Saddles, tree: "cKDTree", lattice: Lattice) -> Lattice:
    """With those beyond gaps, where a perspective through all puts them; without misfits."""
    for _ in range(6):
        if len(lattice) < 6:
            return lattice
        places = np.array(list(lattice))
        uv = saddles.uv_px[list(lattice.values())]
        H, _ = cv2.findHomography(places.astype(np.float64), uv, cv2.RANSAC, 3.0)
        if H is None:
            return lattice
        low, high = places.min(axis=0) - REACH, places.max(axis=0) + REACH
        wanted = [
            (int(i), int(j)) for i in range(low[0], high[0] + 1) for j in range(low[1], high[1] + 1)
        ]
        found = _by_perspective(saddles, tree, lattice, np.asarray(H), wanted)
        if found == lattice:
            break
        lattice = found
    return lattice


def _by_perspective(
    saddles: Saddles, tree: "cKDTree", lattice: Lattice, H: Floats, wanted: list[tuple[int, int]]
) -> Lattice:
    """The saddles at the wanted places, of the phase that the lattice so far wants there."""
    even = _even_phase(saddles, lattice)
    here: Lattice = {}
    at = map_places(H, np.array(wanted))
    steps = np.minimum(
        np.linalg.norm(map_places(H, np.array(wanted) + [1, 0]) - at, axis=1),
        np.linalg.norm(map_places(H, np.array(wanted) + [0, 1]) - at, axis=1),
    )
    for place, uv, step in zip(wanted, at, steps, strict=True):
        distance, found = tree.query(uv, distance_upper_bound=NEARER * float(step))
        if not np.isfinite(distance):
            continue
        turned = saddles.phase[found] + np.pi * (sum(place) % 2)
        if np.cos(turned - even) > -np.cos(OPPOSITE_RAD):
            here[place] = int(found)
    return here


def _even_phase(saddles: Saddles, lattice: Lattice) -> float:
    """The phase of corners whose column and row add to an even number."""
    sums = np.array([sum(place) % 2 for place in lattice])
    phase = saddles.phase[list(lattice.values())] + np.pi * sums
    return float(np.angle(np.mean(np.exp(1j * phase))))


def fit_perspective(places: NDArray[np.int64], uv_px: Floats, method: int = 0) -> Floats:
    """The homography from places on a board to pixels.

    Args:
        places: (N, 2) columns and rows, N >= 4.
        uv_px: (N, 2) distorted pixels.
        method: of ``cv2.findHomography``; 0 is least squares.

    Returns:
        (3, 3).
    """
    H, _ = cv2.findHomography(places.astype(np.float64), uv_px, method)
    return np.asarray(H, dtype=np.float64)


def map_places(H: Floats, places: NDArray[np.int64] | Floats) -> Floats:
    """Pixels of places on a board.

    Args:
        H: (3, 3) as of ``fit_perspective``.
        places: (N, 2) columns and rows; fractions are allowed.

    Returns:
        (N, 2) px.
    """
    at = np.column_stack([places, np.ones(len(places))]) @ H.T
    return np.asarray(at[:, :2] / at[:, 2:])

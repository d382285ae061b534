"""The three perpendicular directions that most straight segments of a picture follow.

Coordinates here are centred pixels over the picture's longer side, so that one set
of limits serves every camera; ``focal`` is in the same unit. The principal point is
taken to be the picture's centre, as it only has to do for a first guess.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import kernel
from app.metrology.detection.segments import Segments
from app.metrology.frames import Floats

# Focal lengths tried, over the longer side: 95 to 5 degrees of view, half an octave apart.
_FOCALS = tuple(0.5 * 2.0 ** (k / 2) for k in range(10))
_TRIALS = 900
# So many of the tries are looked at, and so many that differ are refined.
_CANDIDATES, _REFINED = 1000, 40
# Limits of the focal length, and how weakly it is held, per segment.
_LOG_FOCAL = (float(np.log(0.4)), float(np.log(14.0)))
_HELD_FOCAL = 0.02
_ALIKE = float(np.cos(np.deg2rad(3.0)))
# A segment follows a direction when it points at its vanishing point this closely.
_TOLERANCE_RAD = float(np.deg2rad(2.0))


@dataclass(frozen=True)
class Directions:
    """Three perpendicular directions and the focal length under which segments follow them.

    ``rotation``: (3, 3), the directions as columns in the camera frame, in no
    particular order or sense. ``family``: (S,) which of them a segment follows, -1
    for none. ``explained``: share of the segments' weight that follows one, less where
    it does so loosely.
    """

    rotation: Floats
    focal: float
    family: NDArray[np.int64]
    explained: float


def plane_normals(lines: Floats, focal: float) -> Floats:
    """Unit normals (S, 3), camera frame, of the planes through the centre and each segment."""
    ones = np.full(len(lines), focal)
    one = np.column_stack([lines[:, :2], ones])
    other = np.column_stack([lines[:, 2:], ones])
    normal = np.cross(one, other)
    return np.asarray(normal / np.linalg.norm(normal, axis=1, keepdims=True))


@kernel
def _score(axes: Floats, focal: float, lines: Floats, weight: Floats, tangent: float) -> float:
    """Length of the segments that point at one of three vanishing points."""
    total = 0.0
    for s in range(len(lines)):
        line = lines[s]
        du, dv = line[2] - line[0], line[3] - line[1]
        mu, mv = 0.5 * (line[0] + line[2]), 0.5 * (line[1] + line[3])
        for k in range(3):
            tu = focal * axes[0, k] - mu * axes[2, k]
            tv = focal * axes[1, k] - mv * axes[2, k]
            if abs(du * tv - dv * tu) < tangent * abs(du * tu + dv * tv):
                total += weight[s]
                break
    return total


@kernel
def _try_triples(
    lines: Floats, weight: Floats, triples: NDArray[np.int64], focals: Floats, tangent: float
) -> tuple[Floats, Floats]:
    """Scores (F, T) and axes (F, T, 3, 3) of each focal length and triple of segments."""
    count = len(triples)
    scores = np.zeros((len(focals), count))
    frames = np.zeros((len(focals), count, 3, 3))
    for f in range(len(focals)):
        focal = focals[f]
        normals = np.empty((len(lines), 3))
        for s in range(len(lines)):
            line = lines[s]
            normals[s, 0] = focal * (line[1] - line[3])
            normals[s, 1] = focal * (line[2] - line[0])
            normals[s, 2] = line[0] * line[3] - line[1] * line[2]
            normals[s] /= np.sqrt((normals[s] ** 2).sum())
        for t in range(count):
            first = np.cross(normals[triples[t, 0]], normals[triples[t, 1]])
            size = np.sqrt((first**2).sum())
            if size < 1e-4:
                continue
            first /= size
            second = np.cross(normals[triples[t, 2]], first)
            size = np.sqrt((second**2).sum())
            if size < 1e-2:
                continue
            second /= size
            axes = frames[f, t]
            axes[:, 0], axes[:, 1], axes[:, 2] = first, second, np.cross(first, second)
            scores[f, t] = _score(axes, focal, lines, weight, tangent)
    return scores, frames


@kernel
def _off(axes: Floats, focal: float, line: Floats, k: int) -> float:
    """Angle, rad, between a segment and the way to the vanishing point of direction k."""
    du, dv = line[2] - line[0], line[3] - line[1]
    tu = focal * axes[0, k] - 0.5 * (line[0] + line[2]) * axes[2, k]
    tv = focal * axes[1, k] - 0.5 * (line[1] + line[3]) * axes[2, k]
    dot = du * tu + dv * tv
    return float(np.arctan2(du * tv - dv * tu, abs(dot) + 1e-12) * (1.0 if dot >= 0 else -1.0))


@kernel
def _families(axes: Floats, focal: float, lines: Floats) -> tuple[NDArray[np.int64], Floats]:
    """Which direction (S,) each segment follows, -1 for none, and its angle (S,) from it."""
    family = np.full(len(lines), -1)
    off = np.zeros(len(lines))
    for s in range(len(lines)):
        nearest = _TOLERANCE_RAD
        for k in range(3):
            angle = _off(axes, focal, lines[s], k)
            if abs(angle) < nearest:
                family[s], off[s], nearest = k, angle, abs(angle)
    return family, off


@kernel
def _turned(axes: Floats, by: Floats) -> Floats:
    """The directions turned by a small rotation vector (3,), perpendicular again."""
    first = axes[:, 0] + np.cross(by, axes[:, 0])
    first /= np.sqrt((first**2).sum())
    second = axes[:, 1] + np.cross(by, axes[:, 1])
    second -= (second * first).sum() * first
    second /= np.sqrt((second**2).sum())
    sense = 1.0 if (np.cross(axes[:, 0], axes[:, 1]) * axes[:, 2]).sum() > 0 else -1.0
    return np.column_stack((first, second, sense * np.cross(first, second)))


@kernel
def _refined(axes: Floats, focal: float, lines: Floats, weight: Floats) -> tuple[Floats, float]:
    """Gauss-Newton of the rotation and the focal length on the segments that follow."""
    start = np.log(focal)
    log_focal = start
    for _ in range(6):
        family, off = _families(axes, np.exp(log_focal), lines)
        A, g = np.zeros((4, 4)), np.zeros(4)
        used, squares = 0, 0.0
        for s in range(len(lines)):
            if family[s] < 0:
                continue
            used += 1
            squares += weight[s] ** 2
            J = np.empty(4)
            for p in range(4):
                trial = np.zeros(4)
                trial[p] = 1e-5
                moved = _turned(axes, trial[:3])
                ahead = _off(moved, np.exp(log_focal + trial[3]), lines[s], family[s])
                J[p] = (ahead - off[s]) / 1e-5
            for p in range(4):
                g[p] += weight[s] ** 2 * J[p] * off[s]
                for q in range(4):
                    A[p, q] += weight[s] ** 2 * J[p] * J[q]
        if used < 4:
            break
        # The focal length is held weakly to where it came from: often it hardly shows.
        held = _HELD_FOCAL**2 * squares / used
        A[3, 3] += held
        g[3] += held * (log_focal - start)
        for p in range(4):
            A[p, p] += 1e-12
        step = -np.linalg.solve(A, g)
        step = step * min(1.0, 0.3 / max(np.abs(step).max(), 1e-12))
        axes = _turned(axes, step[:3])
        log_focal = min(max(log_focal + step[3], _LOG_FOCAL[0]), _LOG_FOCAL[1])
    return axes, np.exp(log_focal)


def perpendicular_directions(seen: Segments, most: int = 16) -> list[Directions]:
    """The triples of perpendicular directions that most segments follow, best first.

    Three segments make a triple (two of one direction, one of a second); thousands
    are tried under a range of focal lengths and the best are refined. The sampling
    is seeded: one picture always gives one answer.
    """
    lines, weight = seen.lines, seen.weight
    if len(lines) < 6:
        return []
    chance = np.random.default_rng(1)
    share = weight / weight.sum()
    triples = chance.choice(len(lines), size=(_TRIALS, 3), p=share)
    scores, frames = _try_triples(
        lines, weight, triples, np.array(_FOCALS), float(np.tan(_TOLERANCE_RAD))
    )
    order = np.argsort(-scores, axis=None)[:_CANDIDATES]
    focals = np.array(_FOCALS)[order // _TRIALS]
    axes = frames.reshape(-1, 3, 3)[order]
    found = []
    for k in _distinct(axes, focals, _REFINED):
        axes[k], focals[k] = _refined(axes[k], focals[k], lines, weight)
        family, off = _families(axes[k], focals[k], lines)
        close = np.where(family >= 0, 1 - (off / _TOLERANCE_RAD) ** 2, 0.0)
        found.append(Directions(axes[k], float(focals[k]), family, float(close @ share)))
    found.sort(key=lambda one: -one.explained)
    refined = np.array([one.rotation for one in found])
    kept = _distinct(refined, np.array([one.focal for one in found]), most)
    return [found[k] for k in kept]


@kernel
def _distinct(axes: Floats, focals: Floats, most: int) -> NDArray[np.int64]:
    """Rows, in order, of triples (N, 3, 3) that are like none before them; ``most`` at most.

    Alike are those that agree to 3 degrees and a seventh of the focal length.
    """
    kept, count = np.empty(most, dtype=np.int64), 0
    for k in range(len(axes)):
        alike = False
        for m in range(count):
            if abs(np.log(focals[k] / focals[kept[m]])) > 0.15:
                continue
            agreement = 1.0
            for a in range(3):
                best = 0.0
                for b in range(3):
                    best = max(best, abs((axes[k, :, a] * axes[kept[m], :, b]).sum()))
                agreement = min(agreement, best)
            if agreement > _ALIKE:
                alike = True
                break
        if not alike:
            kept[count] = k
            count += 1
            if count == most:
                break
    return kept[:count]

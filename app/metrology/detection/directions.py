"""Line segments of a picture, and the three perpendicular directions most of them follow.

Coordinates here are centred pixels over the picture's longer side, so that one set
of limits serves every camera; ``focal`` is in the same unit. The principal point is
taken to be the picture's centre, as it only has to do for a first guess.
"""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import kernel
from app.metrology.frames import Floats, nearest_rotation, rotation_from_vector

# Focal lengths tried, over the longer side: 95 to 5 degrees of view, half an octave apart.
_FOCALS = tuple(0.5 * 2.0 ** (k / 2) for k in range(10))
_TRIALS = 900
# A segment follows a direction when it points at its vanishing point this closely.
_TOLERANCE_RAD = np.deg2rad(2.0)
_SHORTEST = 0.02


@dataclass(frozen=True)
class Directions:
    """Three perpendicular directions and the focal length under which segments follow them.

    ``rotation``: (3, 3), the directions as columns in the camera frame, in no
    particular order or sense. ``family``: (S,) which of them a segment follows, -1
    for none. ``explained``: share of the segments' length that follows one.
    """

    rotation: Floats
    focal: float
    family: NDArray[np.int64]
    explained: float


def segments(image: NDArray[np.uint8], ignore: NDArray[np.bool_] | None = None) -> Floats:
    """Straight segments (S, 4) as u0, v0, u1, v1, normalised as above, longest first.

    Grompone von Gioi's line segment detector. ``ignore`` (H, W) marks pixels, such
    as the laser stripe, whose segments are left out.
    """
    found = cv2.createLineSegmentDetector(cv2.LSD_REFINE_STD, 1.0).detect(image)[0]
    if found is None:
        return np.empty((0, 4))
    lines = np.asarray(found, dtype=np.float64).reshape(-1, 4)
    if ignore is not None:
        middle = np.rint((lines[:, :2] + lines[:, 2:]) / 2).astype(np.int64)
        inside = np.clip(middle, 0, np.array(image.shape[::-1]) - 1)
        lines = lines[~ignore[inside[:, 1], inside[:, 0]]]
    height, width = image.shape
    lines = (lines - np.tile([(width - 1) / 2, (height - 1) / 2], 2)) / max(width, height)
    length = np.hypot(lines[:, 2] - lines[:, 0], lines[:, 3] - lines[:, 1])
    order = np.argsort(-length)
    return np.asarray(lines[order[length[order] >= _SHORTEST][:120]])


def lengths(lines: Floats) -> Floats:
    """Lengths (S,) of segments (S, 4)."""
    return np.asarray(np.hypot(lines[:, 2] - lines[:, 0], lines[:, 3] - lines[:, 1]))


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


def _misalignment(axes: Floats, focal: float, lines: Floats) -> Floats:
    """Angles (S, 3), rad, between each segment and the way to each vanishing point."""
    along = lines[:, 2:] - lines[:, :2]
    middle = (lines[:, 2:] + lines[:, :2]) / 2
    to_u = focal * axes[0] - middle[:, :1] * axes[2]
    to_v = focal * axes[1] - middle[:, 1:] * axes[2]
    cross = along[:, :1] * to_v - along[:, 1:] * to_u
    dot = along[:, :1] * to_u + along[:, 1:] * to_v
    return np.asarray(np.arctan2(cross, np.abs(dot) + 1e-12) * np.sign(dot + 1e-300))


def _families(axes: Floats, focal: float, lines: Floats) -> NDArray[np.int64]:
    off = np.abs(_misalignment(axes, focal, lines))
    nearest = np.argmin(off, axis=1)
    return np.where(off[np.arange(len(lines)), nearest] < _TOLERANCE_RAD, nearest, -1)


def _refined(axes: Floats, focal: float, lines: Floats) -> tuple[Floats, float]:
    """Gauss-Newton of the rotation and the focal length on the segments that follow."""
    log_focal = float(np.log(focal))
    start = log_focal
    for _ in range(6):
        family = _families(axes, np.exp(log_focal), lines)
        used = family >= 0
        if used.sum() < 4:
            break
        chosen, which = lines[used], family[used]
        rows = np.arange(len(chosen))
        weight = lengths(chosen)

        def residual(
            step: Floats,
            chosen: Floats = chosen,
            which: NDArray[np.int64] = which,
            rows: NDArray[np.int64] = rows,
            weight: Floats = weight,
            axes: Floats = axes,
            log_focal: float = log_focal,
        ) -> Floats:
            turned = rotation_from_vector(step[:3]) @ axes
            off = _misalignment(turned, float(np.exp(log_focal + step[3])), chosen)
            # The focal length is held weakly to where it came from: often it hardly shows.
            held = 0.02 * (log_focal + step[3] - start) * np.sqrt((weight**2).mean())
            return np.append(off[rows, which] * weight, held)

        at = residual(np.zeros(4))
        J = np.column_stack([(residual(1e-5 * e) - at) / 1e-5 for e in np.eye(4)])
        step: Floats = np.asarray(-np.linalg.lstsq(J, at, rcond=None)[0], dtype=np.float64)
        step *= min(1.0, 0.3 / max(float(np.abs(step).max()), 1e-12))
        axes = nearest_rotation(rotation_from_vector(step[:3]) @ axes)
        log_focal = float(np.clip(log_focal + step[3], np.log(0.3), np.log(16.0)))
    return axes, float(np.exp(log_focal))


def perpendicular_directions(lines: Floats, most: int = 6) -> list[Directions]:
    """The triples of perpendicular directions that most segments follow, best first.

    Three segments make a triple (two of one direction, one of a second); thousands
    are tried under a range of focal lengths and the best are refined. The sampling
    is seeded: one picture always gives one answer.
    """
    if len(lines) < 6:
        return []
    weight = lengths(lines)
    chance = np.random.default_rng(1)
    share = weight / weight.sum()
    triples = chance.choice(len(lines), size=(_TRIALS, 3), p=share)
    scores, frames = _try_triples(
        lines, weight, triples, np.array(_FOCALS), float(np.tan(_TOLERANCE_RAD))
    )
    found: list[Directions] = []
    for index in np.argsort(-scores, axis=None)[:60]:
        f, t = np.unravel_index(index, scores.shape)
        if any(_same(frames[f, t], _FOCALS[f], other) for other in found):
            continue
        axes, focal = _refined(frames[f, t], _FOCALS[f], lines)
        if any(_same(axes, focal, other) for other in found):
            continue
        family = _families(axes, focal, lines)
        explained = float(weight[family >= 0].sum() / weight.sum())
        found.append(Directions(axes, focal, family, explained))
        if len(found) == most:
            break
    return sorted(found, key=lambda one: -one.explained)


def _same(axes: Floats, focal: float, other: Directions) -> bool:
    """Whether two triples agree to 3 degrees and a seventh of the focal length."""
    agreement = np.abs(axes.T @ other.rotation).max(axis=1).min()
    return bool(agreement > np.cos(np.deg2rad(3.0))) and abs(np.log(focal / other.focal)) < 0.15

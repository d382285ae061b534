"""The three perpendicular directions that most straight segments of a picture follow.

Coordinates here are centred pixels relative to the picture's longer side, so that one set of limits
applies to every camera; ``focal`` is in the same unit. The principal point is assumed to be the
picture's centre, which is sufficient for start values.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.detection.search.line_segments import Segments
from crenel.metrology.transforms import Floats
from crenel.native.arguments import F64, I64, Array, Function, Real
from crenel.native.library import CRENEL

# Focal lengths tried, relative to the longer side: 95 to 5 degrees field of view, half an octave
# apart.
_FOCALS = tuple(0.5 * 2.0 ** (k / 2) for k in range(10))
_TRIALS = 900
# Number of attempts that are examined, and number of different ones that are refined.
_CANDIDATES, _REFINED = 1000, 40
# Limits of the focal length, and weight of its prior per segment.
_LOG_FOCAL = (float(np.log(0.4)), float(np.log(14.0)))
_FOCAL_PRIOR = 0.02
_ALIKE = float(np.cos(np.deg2rad(3.0)))
# A segment follows a direction if it points at its vanishing point to this accuracy.
_TOLERANCE_RAD = float(np.deg2rad(2.0))


@dataclass(frozen=True)
class Directions:
    """Three perpendicular directions and the focal length for which segments follow them.

    ``rotation``: (3, 3), the directions as columns in the camera frame, in arbitrary order and
    sign. ``family``: (S,) the direction that each segment follows, -1 for none. ``explained``:
    share of the segments' weight that follows one, reduced if it does so loosely.
    """

    rotation: Floats
    focal: float
    family: NDArray[np.int64]
    explained: float


_try_triples = Function(
    CRENEL,
    "try_triples",
    Array(F64, "n", 4),
    Array(F64, "n"),
    Array(I64, "t", 3),
    Array(F64, "f"),
    Real(),
    Array(F64, "f", "t", written=True),
    Array(F64, "f", "t", 3, 3, written=True),
    Array(F64, "n", 3, written=True),
)
_refine = Function(
    CRENEL,
    "refine_directions",
    Array(F64, "k", 3, 3, written=True),
    Array(F64, "k", written=True),
    Array(F64, "n", 4),
    Array(F64, "n"),
    Array(F64, 4),
    Array(I64, "k", "n", written=True),
    Array(F64, "k", "n", written=True),
)


def perpendicular_directions(seen: Segments, most: int = 16) -> list[Directions]:
    """The triples of perpendicular directions that most segments follow, best first.

    Three segments determine a triple (two of one direction, one of a second); thousands are tried
    for a range of focal lengths and the best are refined. The sampling is seeded: one picture
    always gives the same result.
    """
    lines, weight = seen.lines, seen.weight
    if len(lines) < 6:
        return []
    share = weight / weight.sum()
    axes, focals = _candidates(lines, weight, share)
    chosen = _distinct(axes, focals, _REFINED)
    axes, focals = axes[chosen], focals[chosen]
    family = np.empty((len(chosen), len(lines)), np.int64)
    off = np.empty(family.shape)
    limits = np.array([_TOLERANCE_RAD, _FOCAL_PRIOR, *_LOG_FOCAL])
    _refine(axes, focals, lines, weight, limits, family, off)
    close = np.where(family >= 0, 1 - (off / _TOLERANCE_RAD) ** 2, 0.0)
    explained = close @ share
    best = np.argsort(-explained, kind="stable")
    kept = best[_distinct(axes[best], focals[best], most)]
    return [Directions(axes[k], float(focals[k]), family[k], float(explained[k])) for k in kept]


def _candidates(lines: Floats, weight: Floats, share: Floats) -> tuple[Floats, Floats]:
    """The best of the triples that were tried: axes (N, 3, 3) and focal lengths (N,)."""
    triples = np.random.default_rng(1).choice(len(lines), size=(_TRIALS, 3), p=share)
    focals = np.array(_FOCALS)
    scores = np.zeros((len(focals), _TRIALS))
    axes = np.zeros((len(focals), _TRIALS, 3, 3))
    tangent = float(np.tan(_TOLERANCE_RAD))
    _try_triples(lines, weight, triples, focals, tangent, scores, axes, np.empty((len(lines), 3)))
    order = np.argsort(-scores, axis=None, kind="stable")[:_CANDIDATES]
    return axes.reshape(-1, 3, 3)[order], focals[order // _TRIALS]


def _distinct(axes: Floats, focals: Floats, most: int) -> NDArray[np.int64]:
    """Indices, in order, of triples (N, 3, 3) that differ from all previous ones; at most ``most``.

    Triples are equal if they agree to 3 degrees and a seventh of the focal length.
    """
    log_focal, left = np.log(focals), np.arange(len(axes))
    directions = np.swapaxes(axes, 1, 2).reshape(len(axes), 9)
    kept: list[int] = []
    while len(left) and len(kept) < most:
        first = left[0]
        kept.append(int(first))
        # each direction of a triple must have its counterpart in the other
        along = np.abs(directions[left].reshape(-1, 3) @ axes[first]).reshape(-1, 3, 3)
        agreement = along.max(axis=2).min(axis=1)
        alike = (agreement > _ALIKE) & (np.abs(log_focal[left] - log_focal[first]) <= 0.15)
        alike[0] = True
        left = left[~alike]
    return np.array(kept, dtype=np.int64)

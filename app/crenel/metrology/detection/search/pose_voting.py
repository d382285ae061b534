"""Positions of the camera by votes of bearings: the inner loops of the identification."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats
from crenel.native.arguments import F64, I64, Array, Function, Real
from crenel.native.library import CRENEL

# Number of bearings of each direction that vote; number of positions returned per labelling.
_BEARINGS, _READINGS = 12, 12

_merge = Function(
    CRENEL,
    "merge_bearings",
    Array(F64, "n", 3),
    Array(F64, "n"),
    Array(I64, "n"),
    Array(F64, "l", 3, 3),
    Array(I64, "l", 3),
    Real(),
    Array(F64, "l", 3, "b", 2, written=True),
    Array(F64, "l", 3, "b", written=True),
    Array(I64, "l", 3, written=True),
    Array(F64, 2, "n", written=True),
)
_vote = Function(
    CRENEL,
    "vote_for_centres",
    Array(F64, 3, "b", 2),
    Array(F64, 3, "b"),
    Array(I64, 3),
    Array(F64, "p", 2),
    Array(I64, 4),
    Array(F64, 5, 3),
    Real(),
    Real(),
    Array(F64, "most", 3, written=True),
    Array(F64, "most", written=True),
    Array(F64, 4, "b", "p", written=True),
    returns=int,
)


@dataclass(frozen=True)
class Bearings:
    """Bearings in the planes perpendicular to x, y and z of the object, with their weights.

    ``normals`` (3, B, 2): perpendicular to each, of unit length, in cyclic order of coordinates;
    ``weight`` (3, B), in decreasing order; ``counts`` (3,): the number of each.
    """

    normals: Floats
    weight: Floats
    counts: NDArray[np.int64]


@dataclass(frozen=True)
class ViewConstraints:
    """Constraints on a camera that has the block in front of it, object frame, three values each.

    ``middle_mm``: of the block; ``axis``: the optical axis; ``low_mm``, ``high_mm``: range of a
    camera in front of and above the block; ``reach``: tangent of half the field of view, minimum
    and maximum distance (mm) along the axis.
    """

    middle_mm: Floats
    axis: Floats
    low_mm: Floats
    high_mm: Floats
    reach: Floats


@dataclass(frozen=True)
class EndOn:
    """Edges along x, then y, then z as points (P, 2) in the perpendicular planes, in cyclic order
    of coordinates.

    ``first`` (4,): index of the first one of each axis, and their number.
    """

    points_mm: Floats
    first: NDArray[np.int64]


def merge_bearings(
    normals: Floats,
    weight: Floats,
    family: NDArray[np.int64],
    labellings: Sequence[tuple[Floats, tuple[int, int, int]]],
    near_rad: float,
) -> list[Bearings]:
    """The bearings of each labelling with the largest weights; those of collinear segments are
    merged.

    Args:
        normals: (S, 3) of the planes through the camera and each segment, camera frame.
        weight: (S,) of the segments; family: (S,) which direction each follows, -1 for none.
        labellings: rotations (3, 3) from the object to the camera, with the number of the
            direction that is x, y and z.
        near_rad: bearings closer to each other than this are merged.
    """
    count = len(labellings)
    if not count:
        return []
    rotations = np.array([rotation for rotation, _ in labellings])
    order = np.array([axes for _, axes in labellings], dtype=np.int64)
    found = np.zeros((count, 3, _BEARINGS, 2))
    summed, counts = np.zeros((count, 3, _BEARINGS)), np.zeros((count, 3), np.int64)
    rank = np.argsort(-weight, kind="stable")
    rows = normals[rank], weight[rank], family[rank]
    workspace = np.empty((2, len(weight)))
    _merge(*rows, rotations, order, near_rad, found, summed, counts, workspace)
    return [Bearings(*one) for one in zip(found, summed, counts, strict=True)]


def vote_for_centres(
    bearings: Bearings, edges: EndOn, view: ViewConstraints, near_rad: float, best: float
) -> tuple[Floats, Floats]:
    """Camera centres (K, 3), object frame, and the weight (K,) of the bearings that agree.

    Two bearings to two edges locate the camera in the plane perpendicular to a direction, the
    bearings of the other two along it, and all vote; each direction is used as the first one in
    turn.

    Args:
        near_rad: maximum distance of a bearing from an edge; closer bearings have more weight.
        best: the votes of the best hypothesis so far; hypotheses with far fewer are dropped.

    Returns:
        The positions with the most votes first.
    """
    centres, votes = np.empty((_READINGS, 3)), np.empty(_READINGS)
    known = np.array([view.middle_mm, view.axis, view.low_mm, view.high_mm, view.reach])
    workspace = np.empty((4, _BEARINGS, len(edges.points_mm)))
    count = _vote(
        bearings.normals,
        bearings.weight,
        bearings.counts,
        edges.points_mm,
        edges.first,
        known,
        near_rad,
        best,
        centres,
        votes,
        workspace,
    )
    return centres[:count], votes[:count]

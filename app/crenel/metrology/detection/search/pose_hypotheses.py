"""Which edge of the block each segment of the picture is: poses are voted for, drawn and judged.

With the three directions and the focal length known, a segment along one of them is a bearing in
the plane perpendicular to it: in that plane, the camera lies on the line with this bearing through
one of the block's edges. Two bearings to two edges locate the camera in the plane, the segments
along the other two directions locate it on the third axis, and all of them vote. Each direction is
used as the first one in turn, because the picture may show too few of its segments, or too many
tool marks. The block's mirror image is also tried, so that it can be distinguished from the block.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import permutations

import numpy as np

from crenel.metrology.detection.search.line_segments import Segments
from crenel.metrology.detection.search.pose_voting import (
    EndOn,
    ViewConstraints,
    merge_bearings,
    vote_for_centres,
)
from crenel.metrology.detection.search.vanishing_points import Directions
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats

# Maximum distance of a segment from the edge it votes for, relative to the picture's longer side.
_NEAR = 0.008
# Segments longer than this, relative to the picture's longer side, count with this length.
_LONG = 0.15
# Maximum distance of the block's middle from the picture's, and limits of the block's size,
# relative to the picture's longer side; and tolerance of the direction of its X or Y along the
# optical axis.
_OFF_CENTRE, _SMALLEST, _LARGEST, _ACROSS = 0.75, 0.15, 3.0, 0.35
# The limits of its size while only two of the camera's three coordinates are known.
_NEARER, _FURTHER = 0.11, 4.3


@dataclass(frozen=True)
class PoseHypothesis:
    """A hypothesis of the block's pose relative to the camera.

    ``x_cam = rotation @ (x_obj - centre_mm)``; ``focal`` relative to the picture's longer side.
    """

    rotation: Floats
    centre_mm: Floats
    focal: float
    mirrored: bool
    votes: float


def mirror_block(block: Crenellated) -> Crenellated:
    """The block's mirror image, which is also how the block appears from its back."""
    return replace(block, edges_x_mm=tuple(-x for x in reversed(block.edges_x_mm)))


def pose_hypotheses(
    directions: Directions, seen: Segments, block: Crenellated, best: float = 0.0, most: int = 24
) -> list[PoseHypothesis]:
    """Hypotheses of the block and of its mirror image, most votes first.

    Args:
        directions: three perpendicular directions in the picture.
        seen: the segments from which they were found.
        block: the block by its certificate.
        best: the votes of the best hypothesis so far; hypotheses with far fewer are dropped.
        most: maximum number to return.
    """
    focal = directions.focal
    normals = _normals(directions, seen)
    # A long edge of a table must not have more weight than one of the block.
    weight = np.minimum(seen.weight, _LONG)
    found: list[PoseHypothesis] = []
    labellings = list(_labellings(directions.rotation))
    read = merge_bearings(normals, weight, directions.family, labellings, _NEAR / focal)
    for (rotation, _), bearings in zip(labellings, read, strict=True):
        for reverse in (False, True):
            form = mirror_block(block) if reverse else block
            view = _view(form, rotation[2], focal)
            centres, votes = vote_for_centres(bearings, _end_on(form), view, _NEAR / focal, best)
            for centre, voted in zip(centres, votes, strict=True):
                if _is_visible(centre, rotation, form, focal):
                    found.append(PoseHypothesis(rotation, centre, focal, reverse, float(voted)))
                    best = max(best, float(voted))
    found.sort(key=lambda one: -one.votes)
    return found[:most]


def _normals(directions: Directions, seen: Segments) -> Floats:
    """Unit normals (S, 3) of the planes through each segment's middle and along its direction.

    The plane does not follow the segment itself: the orientation of a short segment is uncertain.
    """
    middle = (seen.lines[:, :2] + seen.lines[:, 2:]) / 2
    middle = np.column_stack([middle, np.full(len(middle), directions.focal)])
    normal = np.cross(middle, directions.rotation.T[directions.family])
    return np.asarray(normal / np.linalg.norm(normal, axis=1, keepdims=True))


def _view(block: Crenellated, axis: Floats, focal: float) -> ViewConstraints:
    """Constraints on a camera that sees the block; ``axis``: its optical axis, in the object
    frame."""
    middle, size = _extent(block)
    low = np.array([-np.inf, -np.inf, block.crest_z_mm])
    high = np.array([np.inf, block.front_y_mm, np.inf])
    reach = np.array([_OFF_CENTRE / focal, size * focal / _FURTHER, size * focal / _NEARER])
    return ViewConstraints(middle, axis, low, high, reach)


def _is_visible(centre_mm: Floats, rotation: Floats, block: Crenellated, focal: float) -> bool:
    """Whether a camera there has the block in front of it, in the picture, and large enough."""
    if centre_mm[1] >= block.front_y_mm or centre_mm[2] <= block.crest_z_mm:
        return False
    middle, size = _extent(block)
    at = rotation @ (middle - centre_mm)
    if at[2] <= 0:
        return False
    off_axis = np.hypot(at[0], at[1]) / at[2]
    return bool(off_axis * focal < _OFF_CENTRE and _SMALLEST < size / at[2] * focal < _LARGEST)


@lru_cache(maxsize=32)
def _extent(block: Crenellated) -> tuple[Floats, float]:
    """Middle (3,) of the block and its diagonal."""
    x = block.edges_x_mm
    low = np.array([x[0], block.front_y_mm, block.base_z_mm])
    high = np.array([x[-1], block.back_y_mm, block.crest_z_mm])
    return (low + high) / 2, float(np.linalg.norm(high - low))


def _labellings(axes: Floats) -> Iterator[tuple[Floats, tuple[int, int, int]]]:
    """Rotations (3, 3) from object to camera that show the block from its front and above."""
    for order in permutations((0, 1, 2)):
        _, y, z = (axes[:, k] for k in order)
        for y_sense in (1.0, -1.0):
            for z_sense in (1.0, -1.0):
                # Y points away from the camera, Z towards it, or almost perpendicular to its axis.
                if y_sense * y[2] < -_ACROSS or z_sense * z[2] > _ACROSS:
                    continue
                columns = [np.cross(y_sense * y, z_sense * z), y_sense * y, z_sense * z]
                yield np.column_stack(columns), (order[0], order[1], order[2])


@lru_cache(maxsize=32)
def _end_on(block: Crenellated) -> EndOn:
    """The block's edges."""
    depths = (block.front_y_mm, block.back_y_mm)
    levels = (block.crest_z_mm, block.floor_z_mm, block.base_z_mm)
    x = block.edges_x_mm
    # The base's back edge is below and behind: it is never visible.
    along_x = [(y, z) for z in levels for y in depths][:5]
    along_y = [(levels[0], at) for at in x] + [(levels[1], at) for at in x[1:-1]]
    along_y += [(levels[2], x[0]), (levels[2], x[-1])]
    along_z = [(at, y) for at in x for y in depths]
    first = np.cumsum([0, len(along_x), len(along_y), len(along_z)])
    return EndOn(np.array([*along_x, *along_y, *along_z], dtype=np.float64), first)

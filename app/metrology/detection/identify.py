"""Which edge of the block each segment of the picture is: poses voted for, then drawn and judged.

With the three directions and the focal length known, a segment along the grooves
is a bearing in the plane across them: the camera lies on the line through the
block's corner in that bearing. Two bearings to two corners place the camera, all
others vote. The block's mirror image is tried as well, so that it can be told
from the block.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import permutations

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import kernel
from app.metrology.crenellated import Crenellated
from app.metrology.detection.directions import Directions, plane_normals
from app.metrology.detection.segments import Segments
from app.metrology.detection.voting import across_x, along_x
from app.metrology.frames import Floats

# How far a segment may lie from the edge it votes for, over the picture's longer side.
_NEAR = 0.008
# Segments longer than this, over the picture's longer side, count as this long.
_LONG = 0.15
# How far the block's middle may lie from the picture's, and the block's size, over the
# picture's longer side; and how far along the camera's axis its X or Y may point wrongly.
_ASIDE, _SMALLEST, _LARGEST, _ACROSS = 0.75, 0.15, 3.0, 0.35
# So many bearings of each direction vote.
_BEARINGS = 12


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
    directions: Directions, seen: Segments, block: Crenellated, most: int = 24
) -> list[Placing]:
    """Placings of the block and of its mirror image, most votes first.

    Args:
        directions: three perpendicular directions in the picture.
        seen: the segments they were found from.
        block: the block by its certificate.
        most: how many to return.
    """
    focal = directions.focal
    normals = plane_normals(seen.lines, focal)
    # A long edge of a table has no more to say than one of the block's.
    weight = np.minimum(seen.weight, _LONG)
    found: list[Placing] = []
    for rotation, order in _labellings(directions.rotation):
        families = [directions.family == axis for axis in order]
        for reverse in (False, True):
            form = mirrored(block) if reverse else block
            for centre, score in _vote(
                normals @ rotation, weight, families, form, rotation[2], focal
            ):
                if _shown(centre, rotation, form, focal):
                    found.append(Placing(rotation, centre, focal, reverse, score))
    found.sort(key=lambda one: -one.votes)
    return found[:most]


def _shown(centre_mm: Floats, rotation: Floats, block: Crenellated, focal: float) -> bool:
    """Whether a camera there has the block before it, in the picture, and large enough."""
    if centre_mm[1] >= block.front_y_mm or centre_mm[2] <= block.crest_z_mm:
        return False
    middle, size = _extent(block)
    at = rotation @ (middle - centre_mm)
    if at[2] <= 0:
        return False
    off_axis = np.hypot(at[0], at[1]) / at[2]
    return bool(off_axis * focal < _ASIDE and _SMALLEST < size / at[2] * focal < _LARGEST)


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
                # Y runs away from the camera, Z towards it, or nearly across its axis.
                if y_sense * y[2] < -_ACROSS or z_sense * z[2] > _ACROSS:
                    continue
                columns = [np.cross(y_sense * y, z_sense * z), y_sense * y, z_sense * z]
                yield np.column_stack(columns), (order[0], order[1], order[2])


def _vote(
    seen_mm: Floats,
    weight: Floats,
    families: list[NDArray[np.bool_]],
    block: Crenellated,
    axis: Floats,
    focal: float,
) -> list[tuple[Floats, float]]:
    """Camera centres (3,) in the object frame and the length of the segments that agree."""
    along_x_axis, along_y_axis, along_z_axis = families
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
    bearings, bearing_weight = _merged(seen_mm[along_x_axis][:, 1:], weight[along_x_axis], near_rad)
    middle, size = _extent(block)
    view = np.array([*middle[1:], *axis[1:], _ASIDE / focal, size * focal / _LARGEST])
    near = np.array([block.front_y_mm, block.crest_z_mm])
    places, votes = across_x(bearings, bearing_weight, ends, near_rad, near, view)
    sides = _merged(seen_mm[along_y_axis][:, [0, 2]], weight[along_y_axis], near_rad)
    walls = _merged(seen_mm[along_z_axis][:, :2], weight[along_z_axis], near_rad)
    centres, scores = along_x(places, votes, *sides, across, *walls, upright, near_rad)
    best = np.argsort(-scores)[:12]
    return [(centres[k], float(scores[k])) for k in best if scores[k] > 0]


@kernel
def _merged(bearings: Floats, weight: Floats, near_rad: float) -> tuple[Floats, Floats]:
    """Bearings of collinear segments merged; the weightiest."""
    kept, total, count = np.empty(len(bearings)), np.empty(len(bearings)), 0
    for k in np.argsort(-weight):
        angle = np.arctan2(bearings[k, 1], bearings[k, 0]) % np.pi
        nearest, at = near_rad, -1
        for m in range(count):
            gap = abs((angle - kept[m] + np.pi / 2) % np.pi - np.pi / 2)
            if gap < nearest:
                nearest, at = gap, m
        if at >= 0:
            total[at] += weight[k]
        else:
            kept[count], total[count] = angle, weight[k]
            count += 1
    best = np.argsort(-total[:count])[:_BEARINGS]
    angles = kept[best]
    return np.column_stack((np.cos(angles), np.sin(angles))), total[best]

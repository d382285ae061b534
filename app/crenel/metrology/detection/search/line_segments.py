"""Straight line segments of a picture, each with its weight.

Coordinates are centred pixels over the picture's longer side.
"""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.detection.edges.stations import number_points
from crenel.metrology.transforms import Floats

# Minimum length, relative to the picture's longer side.
_SHORTEST = 0.02
# Maximum number of segments; a step of the height reached by this share of their length has full
# weight.
_MOST = 100
_STRONG = 0.6
# Segments this close to a line belong to it, relative to the longer side; maximum weight of a line.
_SAME_LINE, _ONE_LINE = 0.004, 0.25


@dataclass(frozen=True)
class Segments:
    """Straight segments of a picture, in order of decreasing weight.

    ``lines``: (S, 4) as u0, v0, u1, v1, normalised as above; ``weight``: (S,) their lengths,
    reduced if the step across them is low compared with others in the picture.
    """

    lines: Floats
    weight: Floats


def segments(image: NDArray[np.uint8], ignore: NDArray[np.bool_] | None = None) -> Segments:
    """Straight segments of a picture (H, W) without noise and texture.

    Grompone von Gioi's line segment detector. ``ignore`` (H, W) marks pixels, such as the laser
    stripe, whose segments are excluded.
    """
    found = cv2.createLineSegmentDetector(cv2.LSD_REFINE_STD, 1.0).detect(image)[0]
    if found is None:
        return Segments(np.empty((0, 4)), np.empty(0))
    lines = np.asarray(found, dtype=np.float64).reshape(-1, 4)
    if ignore is not None:
        middle = np.rint((lines[:, :2] + lines[:, 2:]) / 2).astype(np.int64)
        inside = np.clip(middle, 0, np.array(image.shape[::-1]) - 1)
        lines = lines[~ignore[inside[:, 1], inside[:, 0]]]
    height, width = image.shape
    length = np.hypot(lines[:, 2] - lines[:, 0], lines[:, 3] - lines[:, 1]) / max(width, height)
    keep = length >= _SHORTEST
    lines, length = lines[keep], length[keep]
    if len(lines) == 0:
        return Segments(lines, length)
    step = _steps(image, lines)
    order = np.argsort(step, kind="stable")
    share = np.cumsum(length[order]) / length.sum()
    strong = max(float(step[order][np.searchsorted(share, _STRONG)]), 1.0)
    weight = length * np.minimum(1.0, step / strong)
    weight *= _shares(lines / max(width, height), weight)
    lines = (lines - np.tile([(width - 1) / 2, (height - 1) / 2], 2)) / max(width, height)
    best = np.argsort(-weight, kind="stable")[:_MOST]
    return Segments(np.asarray(lines[best]), np.asarray(weight[best]))


def _shares(lines: Floats, weight: Floats) -> Floats:
    """Factors (S,) on the weights of segments, so that no line dominates.

    The segments of one line count together: the edge of a ruler is no more significant than that of
    a block.
    """
    start, along = lines[:, :2], lines[:, 2:] - lines[:, :2]
    # distance of each segment's ends from the line of each, times its length
    away = lines.reshape(-1, 1, 2, 2) - start[:, None]
    off = np.abs(away[..., 0] * along[:, None, 1] - away[..., 1] * along[:, None, 0]).max(axis=2)
    own = off < _SAME_LINE * np.hypot(*along.T)
    return np.asarray(np.minimum(1.0, _ONE_LINE / np.maximum(weight @ own, 1e-9)))


def _steps(image: NDArray[np.uint8], lines: Floats) -> Floats:
    """Heights (S,) in grey levels of the steps across segments (S, 4) in px.

    Differences of means over bands on either side, so that a thin line is not a step.
    """
    along = lines[:, 2:] - lines[:, :2]
    length = np.hypot(*along.T)
    normal = np.column_stack([-along[:, 1], along[:, 0]]) / length[:, None]
    count = np.maximum(4, length / 2).astype(np.int64)
    line, within = number_points(count)
    share = (within + 0.5) / count[line]
    at = (lines[:, :2][line] + share[:, None] * along[line])[:, None] + 0.5
    aside = normal[line][:, None] * np.arange(2, 6)[:, None]
    one, other = (at + aside).astype(np.int64), (at - aside).astype(np.int64)
    size = image.shape[::-1]
    inside = ((np.minimum(one, other) >= 0) & (np.maximum(one, other) < size)).all(axis=2)
    one, other, line = one[inside], other[inside], line[np.nonzero(inside)[0]]
    step = image[one[:, 1], one[:, 0]].astype(np.float64) - image[other[:, 1], other[:, 0]]
    total = np.abs(np.bincount(line, step, len(lines)))
    return np.asarray(total / np.maximum(np.bincount(line, minlength=len(lines)), 1))

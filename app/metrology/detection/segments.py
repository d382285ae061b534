"""Straight line segments of a picture, each with what it weighs.

Coordinates are centred pixels over the picture's longer side.
"""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import kernel
from app.metrology.frames import Floats

# Shorter ones are left out, over the picture's longer side.
_SHORTEST = 0.02
# So many segments count; a step as high as this share of their length reaches counts in full.
_MOST = 100
_STRONG = 0.6
# Segments this near to a line are its own, over the longer side; together they weigh at most.
_SAME_LINE, _ONE_LINE = 0.004, 0.25


@dataclass(frozen=True)
class Segments:
    """Straight segments of a picture, weightiest first.

    ``lines``: (S, 4) as u0, v0, u1, v1, normalised as above; ``weight``: (S,) their
    lengths, less where the step across them is low beside the picture's others.
    """

    lines: Floats
    weight: Floats


def segments(image: NDArray[np.uint8], ignore: NDArray[np.bool_] | None = None) -> Segments:
    """Straight segments of a picture (H, W) that is free of noise and texture.

    Grompone von Gioi's line segment detector. ``ignore`` (H, W) marks pixels, such
    as the laser stripe, whose segments are left out.
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
    order = np.argsort(step)
    share = np.cumsum(length[order]) / length.sum()
    strong = max(float(step[order][np.searchsorted(share, _STRONG)]), 1.0)
    weight = length * np.minimum(1.0, step / strong)
    weight *= _shares(lines / max(width, height), weight)
    lines = (lines - np.tile([(width - 1) / 2, (height - 1) / 2], 2)) / max(width, height)
    best = np.argsort(-weight)[:_MOST]
    return Segments(np.asarray(lines[best]), np.asarray(weight[best]))


@kernel
def _shares(lines: Floats, weight: Floats) -> Floats:
    """What (S,) each segment's weight is to be multiplied by, so that no line has too much.

    Segments of one line count together: a ruler's edge says no more than a block's.
    """
    share = np.ones(len(lines))
    for s in range(len(lines)):
        u, v = lines[s, 0], lines[s, 1]
        du, dv = lines[s, 2] - u, lines[s, 3] - v
        length = np.sqrt(du * du + dv * dv)
        total = 0.0
        for t in range(len(lines)):
            one = (lines[t, 0] - u) * dv - (lines[t, 1] - v) * du
            other = (lines[t, 2] - u) * dv - (lines[t, 3] - v) * du
            if max(abs(one), abs(other)) < _SAME_LINE * length:
                total += weight[t]
        share[s] = min(1.0, _ONE_LINE / max(total, 1e-9))
    return share


@kernel
def _steps(image: NDArray[np.uint8], lines: Floats) -> Floats:
    """Heights (S,) in grey levels of the steps across segments (S, 4) in px.

    Between means over bands on either side, so that a thin line is no step.
    """
    height, width = image.shape
    found = np.zeros(len(lines))
    for s in range(len(lines)):
        u0, v0 = lines[s, 0], lines[s, 1]
        du, dv = lines[s, 2] - u0, lines[s, 3] - v0
        length = np.sqrt(du * du + dv * dv)
        nu, nv = -dv / length, du / length
        count = max(4, int(length / 2))
        total, used = 0.0, 0
        for i in range(count):
            share = (i + 0.5) / count
            for away in range(2, 6):
                a, b = (
                    int(u0 + share * du + away * nu + 0.5),
                    int(v0 + share * dv + away * nv + 0.5),
                )
                c, d = (
                    int(u0 + share * du - away * nu + 0.5),
                    int(v0 + share * dv - away * nv + 0.5),
                )
                if min(a, b, c, d) < 0 or max(a, c) >= width or max(b, d) >= height:
                    continue
                total += float(image[b, a]) - float(image[d, c])
                used += 1
        if used > 0:
            found[s] = abs(total) / used
    return found

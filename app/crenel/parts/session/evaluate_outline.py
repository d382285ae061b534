"""What is drawn of a feature: lines in the part frame, from its nominal values."""

import numpy as np

from crenel.metrology.transforms import Floats, apply
from crenel.parts.document_nominal import FeaturePart

STEPS = 24
PLANE_MM = 8.0
"""Half the width of a plane that has no region."""
Line = tuple[tuple[float, float, float], ...]


def feature_lines(part: FeaturePart) -> tuple[Line, ...]:
    """Open or closed lines of a feature, mm."""
    shape = part.shape()
    if part.kind == "plane":
        return tuple(_line(one) for one in _plane_lines(part))
    sizes, (low, high) = shape.sizes, part.along_mm or (0.0, 0.0)
    if part.kind == "slot":
        ends = np.roll(_circle()[:-1], STEPS // 4, axis=0)  # from a quarter turn before x on
        right, left = (sizes[0] * half for half in (ends[: STEPS // 2 + 1], ends[STEPS // 2 :]))
        run = np.array([sizes[1], 0.0, 0.0])
        flat = np.vstack([right + run, left - run, -right[-1:] - run, right[:1] + run])
        locals_ = [flat + [0, 0, z] for z in (low, high)]
    elif part.kind == "sphere":
        ring = sizes[0] * _circle()
        locals_ = [ring, ring[:, [0, 2, 1]], ring[:, [2, 0, 1]]]
    elif part.kind == "torus":
        ring = _circle()
        locals_ = [(sizes[0] + one) * ring for one in (-sizes[1], sizes[1])]
        locals_.append(sizes[0] * ring + [0, 0, sizes[1]])
    elif part.kind == "circle":
        locals_ = [sizes[0] * _circle()]
    else:
        slope = float(np.tan(sizes[1])) if part.kind == "cone" else 0.0
        radii = [float(sizes[0]) + slope * z for z in (low, high)]
        locals_ = [
            radius * _circle() + [0, 0, z] for radius, z in zip(radii, (low, high), strict=True)
        ]
        locals_ += [
            np.array([[s * radii[0], 0, low], [s * radii[1], 0, high]]) for s in (-1.0, 1.0)
        ]
    return tuple(_line(apply(shape.T, one)) for one in locals_)


def _turns() -> Floats:
    return np.linspace(0.0, 2 * np.pi, STEPS + 1)


def _circle() -> Floats:
    turns = _turns()
    return np.column_stack([np.cos(turns), np.sin(turns), 0 * turns])


def _plane_lines(part: FeaturePart) -> list[Floats]:
    """The outlines of the pieces of a plane that lie in its regions."""
    shape = part.shape()
    if part.region is None:
        square = PLANE_MM * np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0], [-1, -1, 0]])
        return [apply(shape.T, square.astype(np.float64))]
    across = int(np.argmax(np.abs(shape.direction)))
    first, second = (axis for axis in range(3) if axis != across)
    lines = []
    for box in part.region.boxes_mm:
        low, high = np.array(box)
        corners = np.zeros((5, 3))
        for row, (a, b) in enumerate(((0, 0), (1, 0), (1, 1), (0, 1), (0, 0))):
            corners[row, first] = (low, high)[a][first]
            corners[row, second] = (low, high)[b][second]
        # onto the plane, along the axis that it is seen from best
        n, point = shape.direction, shape.origin_mm
        corners[:, across] = 0.0
        corners[:, across] = ((point - corners) @ n) / n[across]
        lines.append(corners)
    return lines


def _line(points: Floats) -> Line:
    return tuple((float(x), float(y), float(z)) for x, y, z in points.round(2))

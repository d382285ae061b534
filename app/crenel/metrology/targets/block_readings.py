"""Readings of a block's widths, steps and heights, and what they are equations of.

Every reading is the distance of two parallel faces. A calliper's zero error and the diameter of an
arm's tip act alike: they lengthen what is measured from outside (a merlon), shorten what is
measured from inside (a groove), and cancel out where both faces look the same way (a step). All
faces that look one way may so be further out while the tip is smaller: no reading of the tip alone
shows its diameter, one outside or inside reading of another tool does.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crenel.metrology.transforms import Floats

FACE_NAMES = ("front", "back", "crest", "floor", "base")
TIP = "tip"
"""The tool whose readings are distances of tip centres: its diameter is unknown."""


@dataclass(frozen=True)
class BlockReading:
    """The distance from one face to another, which lies further along the axis.

    ``first`` and ``second`` are indices among the coordinates of a block: its edges, then
    ``FACE_NAMES``. ``sd_mm`` is of this reading alone, ``common_sd_mm`` of the zero error of its
    ``tool``, which all readings of the tool share.
    """

    first: int
    second: int
    distance_mm: float
    sd_mm: float
    tool: str = ""
    common_sd_mm: float = 0.0


def face_axis(face: int, edge_count: int) -> int:
    """Along which axis a face is measured: 0, 1 or 2."""
    return 0 if face < edge_count else 1 if face < edge_count + 2 else 2


def centre_axes(edge_count: int) -> Floats:
    """(B, B) takes from each coordinate of a block the mean of its axis."""
    axes = np.array([face_axis(face, edge_count) for face in range(edge_count + 5)])
    same = axes[:, None] == axes
    return np.asarray(np.eye(len(axes)) - same / same.sum(axis=1))


def outward(face: int, edge_count: int) -> int:
    """Which way along its axis a face looks: 1 or -1."""
    if face < edge_count:
        return 1 if face % 2 else -1
    return {"front": -1, "back": 1, "crest": 1, "floor": 1, "base": -1}[
        FACE_NAMES[face - edge_count]
    ]


def tool_sense(first: int, second: int, edge_count: int) -> int:
    """By how many times a zero error or a tip's diameter is in a reading: 1, -1 or 0."""
    return (outward(second, edge_count) - outward(first, edge_count)) // 2


def open_faces(
    readings: Sequence[BlockReading], edge_count: int, touched: Sequence[int] = ()
) -> list[int]:
    """Faces that neither a chain of readings nor touches connect with the first of their axis."""
    group = list(range(edge_count + 5))
    links = [(one.first, one.second) for one in readings]
    axes = [[face for face in touched if face_axis(face, edge_count) == axis] for axis in range(3)]
    for one, other in links + [(own[0], face) for own in axes for face in own[1:]]:
        a, b = group[one], group[other]
        group = [a if own == b else own for own in group]
    first = {0: 0, 1: edge_count, 2: edge_count + 2}
    return [
        face for face, own in enumerate(group) if own != group[first[face_axis(face, edge_count)]]
    ]


def reading_rows(readings: Sequence[BlockReading], edge_count: int, tools: Sequence[str]) -> Floats:
    """Derivatives (N, B + T) of the readings by coordinates and the zero errors of tools."""
    rows = np.zeros((len(readings), edge_count + 5 + len(tools)))
    for i, one in enumerate(readings):
        rows[i, one.second], rows[i, one.first] = 1.0, -1.0
        if one.tool:
            sense = tool_sense(one.first, one.second, edge_count)
            rows[i, edge_count + 5 + tools.index(one.tool)] = sense
    return rows

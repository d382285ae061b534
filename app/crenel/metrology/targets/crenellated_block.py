"""The crenellated object: a comb-shaped block with known dimensions from its certificate.

X runs across the merlons (the teeth), Y along the grooves, Z upward. The camera of the sensor looks
at it from the front (-Y) and above.
"""

import math
from dataclasses import dataclass

import numpy as np

from crenel.messages.message import Message, message
from crenel.metrology.transforms import Floats

FACES = ("crest", "floor", "front", "back", "left", "right")


def on_face(face: str) -> Message:
    """Locations on the block: "on the left face"."""
    return message("on-face", face=face)


@dataclass(frozen=True)
class Crenellated:
    """A block from its certificate, in the object frame.

    ``edges_x_mm`` lists the left and right edge of each merlon in ascending order; the first and
    the last are the end faces of the block.
    """

    name: str
    serial_number: str
    edges_x_mm: tuple[float, ...]
    front_y_mm: float
    back_y_mm: float
    crest_z_mm: float
    floor_z_mm: float
    base_z_mm: float
    standard_uncertainty_mm: float
    coordinate_sds_mm: tuple[float, ...] = ()
    """The standard deviation of each coordinate by itself: edges, front, back, crest, floor, base;
    empty: all as above."""
    is_nominal: bool = False
    """The block is as drawn and nobody measured it: its edges are to be estimated."""

    @property
    def sds_mm(self) -> Floats:
        """(B,) standard uncertainty of each coordinate."""
        if self.coordinate_sds_mm:
            return np.array(self.coordinate_sds_mm)
        return np.full(len(self.edges_x_mm) + 5, self.standard_uncertainty_mm)

    @property
    def made_within_mm(self) -> float:
        """Within which each coordinate of a nominal block is made.

        Source:
            GUM 4.3.7: anything within it is equally likely.
        """
        return math.sqrt(3) * self.standard_uncertainty_mm

    @property
    def merlon_count(self) -> int:
        return len(self.edges_x_mm) // 2

    @property
    def size_mm(self) -> float:
        """The diagonal from floor to crest, which turns angles into lengths."""
        across = self.edges_x_mm[-1] - self.edges_x_mm[0]
        along, up = self.back_y_mm - self.front_y_mm, self.crest_z_mm - self.floor_z_mm
        return float(np.linalg.norm([across, along, up]))


def block_size_mm(block: Crenellated) -> Floats:
    """(3,) of the whole block along its axes."""
    x = block.edges_x_mm
    return np.array(
        [x[-1] - x[0], block.back_y_mm - block.front_y_mm, block.crest_z_mm - block.base_z_mm]
    )


def face_size_mm(block: Crenellated, face: str) -> Floats:
    """(2,) of the rectangle around a face, along its own axes."""
    along, across, up = block_size_mm(block)
    if face in ("crest", "floor"):
        return np.array([along, across])
    return np.array([along if face in ("front", "back") else across, up])


@dataclass(frozen=True)
class BlockEdge:
    """A straight edge of the block between two of its corners (3,), in the object frame."""

    name: str
    start_mm: Floats
    end_mm: Floats


def corners(block: Crenellated) -> dict[str, Floats]:
    """Every corner of the block, by name.

    Returns:
        (3,) mm in the object frame for each name: ``crest:I:L|R:front|back`` for merlon I,
        ``floor:J:L|R:front|back`` for the groove J to the right of merlon J,
        ``base:L|R:front|back`` for the bottom.

    Example:
        >>> x = (-20.0, -8.0, 4.0, 20.0)
        >>> block = Crenellated("B", "1", x, -12.0, 12.0, 15.0, 0.0, -12.0, 0.002)
        >>> at = corners(block)
        >>> len(at), at["crest:1:R:front"].tolist()
        (16, [20.0, -12.0, 15.0])
    """
    named: dict[str, Floats] = {}
    x = block.edges_x_mm
    levels = [
        (f"crest:{i}", x[2 * i], x[2 * i + 1], block.crest_z_mm) for i in range(block.merlon_count)
    ]
    levels += [
        (f"floor:{j}", x[2 * j + 1], x[2 * j + 2], block.floor_z_mm)
        for j in range(block.merlon_count - 1)
    ]
    levels += [("base", x[0], x[-1], block.base_z_mm)]
    for level, left, right, z in levels:
        for side, at_x in (("L", left), ("R", right)):
            for end, at_y in (("front", block.front_y_mm), ("back", block.back_y_mm)):
                named[f"{level}:{side}:{end}"] = np.array([at_x, at_y, z])
    return named


def edges(block: Crenellated) -> list[BlockEdge]:
    """Every straight edge of the block, in the object frame.

    Returns:
        Edges named ``crest:I:front|back``, ``floor:J:front|back`` and ``base:front|back`` along
        X; ``crest:I:L|R``, ``floor:J:L|R`` and ``base:L|R`` along Y; ``wall:I:L|R:front|back``
        along Z, from the crest of merlon I down to the floor beside it (to the base at the two
        ends of the block).
    """
    at = corners(block)
    found: list[BlockEdge] = []
    levels = [f"crest:{i}" for i in range(block.merlon_count)]
    levels += [f"floor:{j}" for j in range(block.merlon_count - 1)] + ["base"]
    for level in levels:
        for end in ("front", "back"):
            found.append(
                BlockEdge(f"{level}:{end}", at[f"{level}:L:{end}"], at[f"{level}:R:{end}"])
            )
        for side in ("L", "R"):
            found.append(
                BlockEdge(
                    f"{level}:{side}", at[f"{level}:{side}:front"], at[f"{level}:{side}:back"]
                )
            )
    last = block.merlon_count - 1
    for i in range(block.merlon_count):
        feet = {
            "L": "base:L" if i == 0 else f"floor:{i - 1}:R",
            "R": "base:R" if i == last else f"floor:{i}:L",
        }
        for side, foot in feet.items():
            for end in ("front", "back"):
                found.append(
                    BlockEdge(
                        f"wall:{i}:{side}:{end}", at[f"crest:{i}:{side}:{end}"], at[f"{foot}:{end}"]
                    )
                )
    return found


def probing_face(block: Crenellated, face: str) -> tuple[Floats, float]:
    """The plane of a probed face, in the object frame.

    Args:
        face: one of ``FACES``.

    Returns:
        Outward unit normal (3,) and offset in mm: points of the face satisfy
        ``normal . x = offset``.

    Raises:
        KeyError: no such face.

    Example:
        >>> x = (-20.0, -8.0, 4.0, 20.0)
        >>> block = Crenellated("B", "1", x, -12.0, 12.0, 15.0, 0.0, -12.0, 0.002)
        >>> normal, offset_mm = probing_face(block, "left")
        >>> normal.tolist(), offset_mm
        ([-1.0, 0.0, 0.0], 20.0)
    """
    planes = {
        "crest": ((0.0, 0.0, 1.0), block.crest_z_mm),
        "floor": ((0.0, 0.0, 1.0), block.floor_z_mm),
        "front": ((0.0, -1.0, 0.0), -block.front_y_mm),
        "back": ((0.0, 1.0, 0.0), block.back_y_mm),
        "left": ((-1.0, 0.0, 0.0), -block.edges_x_mm[0]),
        "right": ((1.0, 0.0, 0.0), block.edges_x_mm[-1]),
    }
    normal, offset_mm = planes[face]
    return np.array(normal), offset_mm


def mirror_difference_mm(edges_x_mm: tuple[float, ...]) -> float:
    """Largest distance of an edge from that of the mirror image, mm.

    Example:
        >>> mirror_difference_mm((-21.5, -9.5, 1.0, 9.5, 16.5, 21.5))
        10.5
    """
    x = np.array(edges_x_mm)
    return float(np.max(np.abs(x - (x[0] + x[-1] - x[::-1]))))


def outline_mm(block: Crenellated) -> list[tuple[float, float]]:
    """Corners (x, z) of the block as seen from its front, anticlockwise from below on the left."""
    x, floor, crest = block.edges_x_mm, block.floor_z_mm, block.crest_z_mm
    corners = [(x[0], block.base_z_mm), (x[-1], block.base_z_mm)]
    for i in range(len(x) - 1, -1, -1):
        inner = [(x[i], floor)] if 0 < i < len(x) - 1 else []
        corners += [*inner, (x[i], crest)] if i % 2 else [(x[i], crest), *inner]
    return corners

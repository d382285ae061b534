"""Points of a cloud that are one node of the 3D view, and which of them are weak."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import viser
from numpy.typing import NDArray

from crenel.station.view3d.cloud_colouring import WEAK, PointAttributes, Points32


@dataclass
class PointNode:
    """A node of the scene, with the data needed to colour it again."""

    points_mm: Points32
    traits: PointAttributes
    handle: viser.PointCloudHandle | None = None
    spacing_mm: float = 0.0
    """The spacing of its points, by the median, once it is shown."""
    painted: tuple[int, int] = (-1, 0)
    """Its present colours: version of the painter, and step of the age."""

    weak_counts: tuple[int, ...] = (0,) * len(WEAK)
    """The counts of its points that are not cut away, in the order of ``WEAK``, once it is
    shown."""

    @property
    def newest_s(self) -> float:
        return float(self.traits["taken_s"].max())

    @property
    def kept(self) -> "PointNode":
        """What is not cut away."""
        return self.part(np.flatnonzero(~self.traits["cut"])) if self.traits["cut"].any() else self

    def part(self, which: slice | NDArray[np.int64]) -> "PointNode":
        """Some of its points, not shown yet."""
        return PointNode(self.points_mm[which], self.traits[which])


def join_nodes(nodes: list[PointNode]) -> PointNode:
    """All their points, not shown yet."""
    return PointNode(
        np.concatenate([node.points_mm for node in nodes]),
        np.concatenate([node.traits for node in nodes]),
    )


def count_weak(node: PointNode) -> tuple[int, ...]:
    """In the order of ``WEAK``; a point that is weak for several reasons counts for the gravest."""
    gravest = np.zeros(len(node.traits), np.uint8)
    for bit, _ in WEAK.values():
        gravest[node.traits["weak"] & bit > 0] = bit
    return tuple(int((gravest == bit).sum()) for bit, _ in WEAK.values())


PLACE_MM, PLACES = 1.5, 1 << 22
"""Side of the cubes that are scanned well or weakly, and the number of slots for them."""


def find_places(points_mm: Points32) -> NDArray[np.int64]:
    """Slot of the cube of each point (N, 3); a few cubes share theirs."""
    cubes = np.floor(points_mm / PLACE_MM).astype(np.int64)
    return np.asarray((cubes @ (73856093, 19349663, 83492791)) % PLACES)


def remove_node(node: PointNode) -> None:
    if node.handle is not None:
        node.handle.remove()
        node.handle = None


def mend_places(nodes: Sequence[PointNode]) -> None:
    """Mends places that were also scanned well: none of their points is weak any more."""
    good = np.zeros(PLACES, dtype=bool)
    for node in nodes:
        good[find_places(node.points_mm[node.traits["weak"] == 0])] = True
    for node in nodes:
        weak = np.flatnonzero(node.traits["weak"])
        mended = weak[good[find_places(node.points_mm[weak])]]
        if len(mended):
            node.traits["weak"][mended] = 0
            node.painted = (-1, 0)
        node.weak_counts = count_weak(node.kept)

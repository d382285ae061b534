"""The growing cloud in the 3D view: small nodes that are merged, thinned above a budget."""

from dataclasses import dataclass, field

import numpy as np
import viser

from app.metrology.frames import Floats
from app.station.colours import Bytes, colours, shades
from app.station.views import M_PER_MM
from app.station.voxels import VoxelFilter

FIRST_VOXEL_MM = 0.1
# Above the budget the cubes grow by this, so that a surface shows half as many points.
VOXEL_GROWTH = 2**0.5
NODE_POINTS = 100_000
MOST_SMALL_NODES = 60
SMALLEST_POINT_MM = 0.3
# The range of heights grows ahead of the points, so that recolouring is rare.
RANGE_AHEAD = 0.25
SMALLEST_RANGE_MM = 5.0


@dataclass
class _Node:
    """A node of the scene, with what is needed to colour or thin it again."""

    points_mm: Floats  # (N, 3) from the cloud's origin
    shade: Bytes  # (N,)
    handle: viser.PointCloudHandle | None = None


@dataclass
class CloudView:
    """Not safe for threads: its owner holds a lock."""

    server: viser.ViserServer
    budget: int
    _voxels: VoxelFilter = field(default_factory=lambda: VoxelFilter(FIRST_VOXEL_MM))
    _small: list[_Node] = field(default_factory=list)
    _large: list[_Node] = field(default_factory=list)
    _origin_mm: Floats = field(default_factory=lambda: np.zeros(3))
    _range_mm: tuple[float, float] | None = None
    _low_mm: Floats = field(default_factory=lambda: np.full(3, np.inf))
    _high_mm: Floats = field(default_factory=lambda: np.full(3, -np.inf))
    _made: int = 0

    @property
    def shown(self) -> int:
        return self._voxels.count

    @property
    def bounds_mm(self) -> tuple[Floats, Floats]:
        """Lowest and highest corner (3,) of what was ever added, in the arm frame."""
        return self._low_mm, self._high_mm

    def clear(self) -> None:
        with self.server.atomic():
            for node in (*self._small, *self._large):
                _remove(node)
        self._voxels = VoxelFilter(FIRST_VOXEL_MM)
        self._small, self._large = [], []
        self._range_mm = None
        self._low_mm, self._high_mm = np.full(3, np.inf), np.full(3, -np.inf)

    def add(self, points_mm: Floats, intensity: Floats) -> None:
        """Shows those of the points (N, 3) that are the first in their cube."""
        shade = shades(intensity)
        new = self._voxels.take_new(points_mm)
        if not new.any():
            return
        if self._range_mm is None:
            self._place_origin(points_mm[new])
        self._low_mm = np.minimum(self._low_mm, points_mm[new].min(axis=0))
        self._high_mm = np.maximum(self._high_mm, points_mm[new].max(axis=0))
        with self.server.atomic():
            self._widen_range()
            node = _Node(points_mm[new] - self._origin_mm, shade[new])
            self._show(node)
            self._small.append(node)
            if self._voxels.count > self.budget:
                self._thin()
            elif (
                len(self._small) >= MOST_SMALL_NODES
                or sum(len(n.points_mm) for n in self._small) >= NODE_POINTS
            ):
                self._merge()

    def _place_origin(self, points_mm: Floats) -> None:
        """Float32 is exact to a tenth of a micrometre this near to the points."""
        self._origin_mm = np.round(np.median(points_mm, axis=0))
        self.server.scene.add_frame("/cloud", show_axes=False, position=self._origin_mm * M_PER_MM)

    def _widen_range(self) -> None:
        """Keeps all heights within the colours' range; recolours when it had to grow."""
        lowest, highest = float(self._low_mm[2]), float(self._high_mm[2])
        if self._range_mm and self._range_mm[0] <= lowest and highest <= self._range_mm[1]:
            return
        ahead = max(RANGE_AHEAD * (highest - lowest), SMALLEST_RANGE_MM / 2)
        self._range_mm = (lowest - ahead, highest + ahead)
        for node in (*self._small, *self._large):
            if node.handle is not None:
                node.handle.colors = self._colours(node)

    def _colours(self, node: _Node) -> Bytes:
        assert self._range_mm is not None
        lowest, highest = self._range_mm
        return colours(node.points_mm[:, 2] + self._origin_mm[2], lowest, highest, node.shade)

    def _show(self, node: _Node) -> None:
        self._made += 1
        node.handle = self.server.scene.add_point_cloud(
            f"/cloud/{self._made}",
            (node.points_mm * M_PER_MM).astype(np.float32),
            self._colours(node),
            point_size=M_PER_MM * max(1.4 * self._voxels.size_mm, SMALLEST_POINT_MM),
            point_shape="circle",
            point_shading="flat",
            precision="float32",
        )

    def _merge(self) -> None:
        """Many small nodes become few large ones: a browser slows down with many."""
        small, self._small = self._small, []
        if self._large and len(self._large[-1].points_mm) < NODE_POINTS // 2:
            small.insert(0, self._large.pop())
        self._show_large(small)

    def _thin(self) -> None:
        """Shows every point again through larger cubes, until the budget holds.

        Node by node: work on millions of points at once would hold up the other threads.
        """
        nodes = [*self._large, *self._small]
        left = nodes
        while sum(len(node.points_mm) for node in left) > self.budget:
            self._voxels = VoxelFilter(self._voxels.size_mm * VOXEL_GROWTH)
            left = [self._thinned(node) for node in left]
        self._small, self._large = [], []
        self._show_large(left)
        for node in nodes:
            _remove(node)

    def _thinned(self, node: _Node) -> _Node:
        kept = self._voxels.take_new(node.points_mm + self._origin_mm)
        return _Node(node.points_mm[kept], node.shade[kept])

    def _show_large(self, nodes: list[_Node]) -> None:
        """Shows the nodes' points as nodes of 100 000, then removes what they were shown as."""
        waiting: list[_Node] = []
        for node in nodes:
            waiting.append(node)
            if sum(len(one.points_mm) for one in waiting) >= NODE_POINTS:
                self._show_together(waiting)
                waiting = []
        if waiting:
            self._show_together(waiting)
        for node in nodes:
            _remove(node)

    def _show_together(self, nodes: list[_Node]) -> None:
        points = np.concatenate([node.points_mm for node in nodes])
        shade = np.concatenate([node.shade for node in nodes])
        for start in range(0, len(points), NODE_POINTS):
            part = slice(start, start + NODE_POINTS)
            large = _Node(points[part], shade[part])
            self._show(large)
            self._large.append(large)


def _remove(node: _Node) -> None:
    if node.handle is not None:
        node.handle.remove()
        node.handle = None

"""A growing cloud in the 3D view: small nodes that are merged, thinned above a budget."""

from dataclasses import dataclass

import numpy as np
import viser
from numpy.typing import NDArray

from app.files.cloud_points import Points
from app.metrology.frames import Floats
from app.station.colours import Bytes
from app.station.painter import Painter, Points32, Traits, traits_of
from app.station.views import M_PER_MM
from app.station.voxels import VoxelFilter

FIRST_VOXEL_MM = 0.1
# Above the budget the cubes grow by this, so that a surface shows half as many points.
VOXEL_GROWTH = 2**0.5
NODE_POINTS = 100_000
MOST_SMALL_NODES = 60
SMALLEST_POINT_MM = 0.3


@dataclass
class _Node:
    """A node of the scene, with what is needed to colour or thin it again."""

    points_mm: Points32
    traits: Traits
    handle: viser.PointCloudHandle | None = None
    painted: tuple[int, int] = (-1, 0)
    """The colours it has: version of the painter, and step of the age."""

    @property
    def newest_s(self) -> float:
        return float(self.traits["taken_s"][-1])


class CloudView:
    """The cloud of one scan. Not safe for threads: its owner holds a lock."""

    def __init__(
        self, server: viser.ViserServer, painter: Painter, budget: int, root: str = "/cloud"
    ) -> None:
        self.budget = budget
        self.newest_s = 0.0
        self._server, self._painter, self._root = server, painter, root
        self._made = 0
        self._low_mm, self._high_mm = np.full(3, np.inf), np.full(3, -np.inf)
        self._forget()

    @property
    def shown(self) -> int:
        return self._voxels.count

    @property
    def voxel_mm(self) -> float:
        """Of cubes of this size the first point is shown."""
        return self._voxels.size_mm

    @property
    def bounds_mm(self) -> tuple[Floats, Floats]:
        """Lowest and highest corner (3,) of what was ever added, in the arm frame."""
        return self._low_mm, self._high_mm

    def points_mm(self) -> Floats:
        """What is shown, (N, 3) in the arm frame."""
        parts = [self._in_arm(node.points_mm) for node in self._nodes]
        return np.concatenate(parts) if parts else np.zeros((0, 3))

    def traits(self) -> list[Traits]:
        """Of what is shown, in the order of ``points_mm``."""
        return [node.traits for node in self._nodes]

    def sample(self, count: int) -> NDArray[np.floating]:
        """About so many of the values that are coloured by."""
        step = max(1, self.shown // count)
        parts = [
            self._painter.values(
                self._in_arm(node.points_mm[::step]), node.traits[::step], self.newest_s
            )
            for node in self._nodes
        ]
        return np.concatenate(parts) if parts else np.zeros(0)

    def clear(self) -> None:
        with self._server.atomic():
            for node in self._nodes:
                _remove(node)
        self._forget()

    def remove(self) -> None:
        """Takes the cloud out of the scene for good."""
        self.clear()
        self._server.scene.remove_by_name(self._root)

    def add(self, found: Points, taken_s: Floats) -> None:
        """Shows those of the points (N,), taken at times (N,), that are the first in their cube."""
        places = np.empty((len(found), 3))
        for i, axis in enumerate("xyz"):
            places[:, i] = found[axis]
        new = np.flatnonzero(self._voxels.take_new(places))
        if not len(new):
            return
        points, traits = places[new], traits_of(found[new], taken_s[new])
        if self._painter.legend is None:
            self._painter.settle_range(self._painter.values(points, traits, float(taken_s[-1])))
        if not self._nodes:
            self._place_origin(points)
        self._low_mm = np.minimum(self._low_mm, points.min(axis=0))
        self._high_mm = np.maximum(self._high_mm, points.max(axis=0))
        self.newest_s = max(self.newest_s, float(traits["taken_s"][-1]))
        node = _Node((points - self._origin_mm).astype(np.float32), traits)
        with self._server.atomic():
            self._show(node)
            self._small.append(node)
            if not self.keep_budget() and (
                len(self._small) >= MOST_SMALL_NODES
                or sum(len(n.points_mm) for n in self._small) >= NODE_POINTS
            ):
                self._merge()

    def keep_budget(self) -> bool:
        """Thins what is shown where it is more than the budget; whether it was."""
        if self._voxels.count <= self.budget:
            return False
        with self._server.atomic():
            self._thin()
        return True

    def repaint(self, most_points: int) -> int:
        """Gives nodes the colours that they should have, up to so many points; how many it did."""
        done = 0
        for node in self._nodes:
            if done >= most_points:
                break
            if node.painted != self._colouring and node.handle is not None:
                same = node.painted[0] == self._painter.version
                if not (same and self._painter.beyond_age(self.newest_s, node.newest_s)):
                    node.handle.colors = self._colours(node)
                    done += len(node.points_mm)
                node.painted = self._colouring
        return done

    @property
    def _nodes(self) -> list[_Node]:
        return [*self._large, *self._small]

    @property
    def _colouring(self) -> tuple[int, int]:
        return self._painter.version, self._painter.age_step(self.newest_s)

    def _forget(self) -> None:
        self._voxels = VoxelFilter(FIRST_VOXEL_MM)
        self._small: list[_Node] = []
        self._large: list[_Node] = []
        self._origin_mm = np.zeros(3)
        self._low_mm, self._high_mm = np.full(3, np.inf), np.full(3, -np.inf)
        self.newest_s = 0.0

    def _in_arm(self, points: Points32) -> Floats:
        return points + self._origin_mm

    def _place_origin(self, points_mm: Floats) -> None:
        """Float32 is exact to a tenth of a micrometre this near to the points."""
        self._origin_mm = np.round(np.median(points_mm, axis=0))
        self._server.scene.add_frame(
            self._root, show_axes=False, position=self._origin_mm * M_PER_MM
        )

    def _colours(self, node: _Node) -> Bytes:
        return self._painter.colours(self._in_arm(node.points_mm), node.traits, self.newest_s)

    def _show(self, node: _Node) -> None:
        self._made += 1
        node.painted = self._colouring
        node.handle = self._server.scene.add_point_cloud(
            f"{self._root}/{self._made}",
            node.points_mm * np.float32(M_PER_MM),
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
        nodes = self._nodes
        left = nodes
        while sum(len(node.points_mm) for node in left) > self.budget:
            self._voxels = VoxelFilter(self._voxels.size_mm * VOXEL_GROWTH)
            left = [self._thinned(node) for node in left]
        self._small, self._large = [], []
        self._show_large(left)
        for node in nodes:
            _remove(node)

    def _thinned(self, node: _Node) -> _Node:
        kept = self._voxels.take_new(self._in_arm(node.points_mm))
        return _Node(node.points_mm[kept], node.traits[kept])

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
        traits = np.concatenate([node.traits for node in nodes])
        for start in range(0, len(points), NODE_POINTS):
            part = slice(start, start + NODE_POINTS)
            large = _Node(points[part], traits[part])
            self._show(large)
            self._large.append(large)


def _remove(node: _Node) -> None:
    if node.handle is not None:
        node.handle.remove()
        node.handle = None

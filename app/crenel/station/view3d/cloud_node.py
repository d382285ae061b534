"""A growing cloud in the 3D view: small nodes that are merged, and thinned above a budget.

New points are sent at once, in small nodes. These are merged into large nodes, each with points of
one tier (see ``voxels``), so that thinning removes nodes and sends none again: the work per turn
does not grow with the cloud.
"""

from collections.abc import Sequence
from itertools import chain

import numpy as np
import viser
from numpy.typing import NDArray

from crenel.formats.clouds.cuts import Cut, cut_mask
from crenel.formats.clouds.points import Points
from crenel.metrology.colormaps import Bytes
from crenel.metrology.transforms import Floats
from crenel.station.view3d.cloud.point_node import (
    PointNode,
    count_weak,
    join_nodes,
    mend_places,
    remove_node,
)
from crenel.station.view3d.cloud_colouring import (
    WEAK,
    Circumstances,
    CloudColouring,
    PointAttributes,
    Points32,
    point_attributes,
)
from crenel.station.view3d.nodes import M_PER_MM
from crenel.station.view3d.surface_look import is_steep, look_at_surface
from crenel.station.view3d.voxel_lod import Tiers, Voxels

FIRST_VOXEL_MM = 0.1
NODE_POINTS = 100_000
FEW_POINTS = 4_000
MOST_SMALL_NODES, SMALL_POINTS = 60, 100_000
"""A larger number of small nodes is merged."""
CONTEXT_POINTS = 20_000
"""Among so many of the latest points, new ones look for their neighbours."""
POINT_SPACINGS = 1.4
"""Diameter of a point, so that those of a surface touch each other."""


class CloudNode:
    """The cloud of one scan. Not thread-safe: its owner holds a lock."""

    def __init__(
        self,
        server: viser.ViserServer,
        painter: CloudColouring,
        budget: int,
        cuts: Sequence[Cut] = (),
        root: str = "/cloud",
    ) -> None:
        self.budget = budget
        self.cuts = tuple(cuts)
        """What they hold is hidden."""
        self.newest_s = 0.0
        self._server, self._painter, self._root = server, painter, root
        self._made = 0
        self._shown = True
        self._frame: viser.FrameHandle | None = None
        self._forget()

    @property
    def visible_count(self) -> int:
        return self._voxels.count - self.cut_count

    @property
    def cut_count(self) -> int:
        """Points that would be shown if they were not cut away."""
        if not self.cuts:
            return 0
        return sum(int(node.traits["cut"].sum()) for node in self._nodes)

    @property
    def weak_counts(self) -> tuple[int, ...]:
        """Numbers of weak points, in the order of ``WEAK``."""
        counts = [node.weak_counts for node in self._nodes]
        return tuple(sum(each) for each in zip(*counts, strict=True)) or (0,) * len(WEAK)

    @property
    def voxel_mm(self) -> float:
        """Approximate distance between the shown points of a surface."""
        return self._voxels.size_mm

    @property
    def bounds_mm(self) -> tuple[Floats, Floats]:
        """Lowest and highest corner (3,) of all points but those cut away, in the arm frame."""
        return self._low_mm, self._high_mm

    def points_mm(self) -> Floats:
        """The shown points, (N, 3) in the arm frame."""
        parts = [self._in_arm(node.kept.points_mm) for node in self._nodes]
        return np.concatenate(parts) if parts else np.zeros((0, 3))

    def traits(self) -> list[PointAttributes]:
        """Data of the shown points, in the order of ``points_mm``."""
        return [node.kept.traits for node in self._nodes]

    def sample(self, count: int) -> NDArray[np.floating]:
        """Approximately this many of the values for colouring."""
        step = max(1, self.visible_count // count)
        parts = [
            self._painter.values(
                self._in_arm(node.points_mm[::step]), node.traits[::step], self.newest_s
            )
            for node in (one.kept for one in self._nodes)
        ]
        return np.concatenate(parts) if parts else np.zeros(0)

    def clear(self) -> None:
        for node in self._nodes:
            remove_node(node)
        self._forget()

    def show(self, on: bool) -> None:
        """Shows the cloud, or hides it though it goes on to grow."""
        self._shown = on
        if self._frame is not None:
            self._frame.visible = on

    def remove(self) -> None:
        """Removes the cloud from the scene permanently."""
        self.clear()
        self._server.scene.remove_by_name(self._root)

    def cut(self, cuts: Sequence[Cut]) -> None:
        """Hides what these cuts hold, now and of points to come; shows all else."""
        self.cuts = tuple(cuts)
        tiers = [(tier, nodes) for tier, nodes in self._large.items()]
        for tier, nodes in [*tiers, (None, [node for node, _ in self._small])]:
            for node in nodes:
                hidden = cut_mask(cuts, self._in_arm(node.points_mm))
                if (hidden != node.traits["cut"]).any():
                    node.traits["cut"] = hidden
                    self._show_again(node, tier)
        self._low_mm, self._high_mm = np.full(3, np.inf), np.full(3, -np.inf)
        for node in self._nodes:
            self._widen_bounds(self._in_arm(node.kept.points_mm))

    def finish(self) -> None:
        """Marks what is weak, once all points are there: no place that was also scanned well."""
        self._merge()
        mend_places(self._nodes)

    def add(self, found: Points, taken: Circumstances) -> None:
        """Shows the points (N,), captured like this, that are the first in their cube."""
        places = np.empty((len(found), 3))
        for i, axis in enumerate("xyz"):
            places[:, i] = found[axis]
        tiers = self._voxels.take(places)
        new = np.flatnonzero(tiers >= 0)
        if not len(new):
            return
        points, traits = places[new], point_attributes(found[new], taken[new])
        traits["cut"] = cut_mask(self.cuts, points)
        if self._painter.legend is None:
            self._painter.settle_range(
                self._painter.values(points, traits, float(taken.taken_s[-1]))
            )
        if not self._nodes:
            self._place_origin(points)
        self._widen_bounds(points[~traits["cut"]])
        self.newest_s = max(self.newest_s, float(traits["taken_s"][-1]))
        node = PointNode((points - self._origin_mm).astype(np.float32), traits)
        self._small.append((node, tiers[new]))
        if self.keep_budget():
            return
        if (
            len(self._small) >= MOST_SMALL_NODES
            or sum(len(n.points_mm) for n, _ in self._small) >= SMALL_POINTS
        ):
            self._merge()
        else:
            self._look_at_newest()
            self._show(node)

    def keep_budget(self) -> bool:
        """Thins the shown points if they exceed the budget; returns whether it did."""
        finest = self._voxels.finest
        while self._voxels.count > self.budget and self._voxels.coarsen():
            continue
        if self._voxels.finest == finest:
            return False
        for tier in range(finest, self._voxels.finest):
            for node in self._large.pop(tier, []):
                remove_node(node)
        self._merge()
        for node in self._nodes:
            if node.handle is not None:
                node.handle.point_size = self._point_size(node)
        return True

    def repaint(self, most_points: int) -> int:
        """Updates the colours of nodes, for a limited number of points; returns the number."""
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
    def _nodes(self) -> list[PointNode]:
        return [*chain.from_iterable(self._large.values()), *(node for node, _ in self._small)]

    @property
    def _colouring(self) -> tuple[int, int]:
        return self._painter.version, self._painter.age_step(self.newest_s)

    def _forget(self) -> None:
        self._voxels = Voxels(FIRST_VOXEL_MM)
        self._small: list[tuple[PointNode, Tiers]] = []
        self._large: dict[int, list[PointNode]] = {}
        self._origin_mm = np.zeros(3)
        self._low_mm, self._high_mm = np.full(3, np.inf), np.full(3, -np.inf)
        self.newest_s = 0.0

    def _widen_bounds(self, points_mm: Floats) -> None:
        if len(points_mm):
            self._low_mm = np.minimum(self._low_mm, [axis.min() for axis in points_mm.T])
            self._high_mm = np.maximum(self._high_mm, [axis.max() for axis in points_mm.T])

    def _point_size(self, node: PointNode) -> float:
        return M_PER_MM * POINT_SPACINGS * max(node.spacing_mm, self._voxels.size_mm)

    def _look_at_newest(self) -> None:
        """Lights the newest small node; its neighbours are the latest points."""
        context: list[PointNode] = []
        count = 0
        for node, _ in reversed(self._small):
            if context and count + len(node.points_mm) > CONTEXT_POINTS:
                break
            context.append(node)
            count += len(node.points_mm)
        self._look(join_nodes(context), context[0])

    def _look(self, context: PointNode, node: PointNode, whole: bool = False) -> None:
        """Lights a node with the first points of its context; if that is all of the surroundings,
        it is known where there are few points."""
        look = look_at_surface(context.points_mm, self._voxels.size_mm)
        steep = is_steep(look.normals[: len(node.points_mm)], node.traits["view"])
        few = look.has_few[: len(node.points_mm)] & whole
        node.traits["weak"] &= WEAK["fast"][0]
        node.traits["weak"] |= (steep * WEAK["steep"][0] + few * WEAK["few"][0]).astype(np.uint8)
        node.traits["brightness"] = look.brightness[: len(node.points_mm)]
        node.traits["spacing_mm"] = look.spacing_mm[: len(node.points_mm)]

    def _in_arm(self, points: Points32) -> Floats:
        return np.asarray(points + self._origin_mm)

    def _place_origin(self, points_mm: Floats) -> None:
        """Float32 is exact to a tenth of a micrometre at this distance."""
        self._origin_mm = np.round(np.median(points_mm, axis=0))
        self._frame = self._server.scene.add_frame(
            self._root,
            show_axes=False,
            position=self._origin_mm * M_PER_MM,
            visible=self._shown,
        )

    def _colours(self, node: PointNode) -> Bytes:
        kept = node.kept
        return self._painter.colours(self._in_arm(kept.points_mm), kept.traits, self.newest_s)

    def _show_again(self, node: PointNode, tier: int | None) -> None:
        """Shows other points of a node; the new ones are there before the former are removed."""
        former, node.handle = node.handle, None
        self._show(node, tier)
        if former is not None:
            former.remove()

    def _show(self, node: PointNode, tier: int | None = None) -> None:
        """Its name states the tier of its points, if they have one."""
        self._made += 1
        of_tier = "" if tier is None else f"-{tier}"
        node.painted = self._colouring
        node.spacing_mm = float(np.median(node.traits["spacing_mm"]))
        kept = node.kept
        node.weak_counts = count_weak(kept)
        if not len(kept.points_mm):
            return
        node.handle = self._server.scene.add_point_cloud(
            f"{self._root}/{self._made}{of_tier}",
            kept.points_mm * np.float32(M_PER_MM),
            self._colours(node),
            point_size=self._point_size(node),
            point_shape="circle",
            point_shading="flat",
            precision="float32",
        )

    def _merge(self) -> None:
        """Merges many small nodes into few large ones, because a browser slows down with many.

        Tiers with only few points stay together in one small node. The larger node is there before
        the small ones are removed, so nothing disappears in between.
        """
        small, self._small = self._small, []
        if not small:
            return
        whole = join_nodes([node for node, _ in small])
        tiers = np.concatenate([tiers for _, tiers in small])
        self._look(whole, whole, whole=True)
        order = np.argsort(tiers, kind="stable")
        whole, tiers = whole.part(order), tiers[order]
        few = [np.zeros(0, dtype=np.int64)]
        for tier in range(self._voxels.finest, int(tiers[-1]) + 1):
            start, end = np.searchsorted(tiers, (tier, tier + 1))
            if end - start >= FEW_POINTS:
                self._append(tier, whole.part(slice(start, end)))
            else:
                few.append(np.arange(start, end))
        rest = np.concatenate(few)
        if len(rest):
            self._small.append((whole.part(rest), tiers[rest]))
            self._show(self._small[0][0])
        for node, _ in small:
            remove_node(node)

    def _append(self, tier: int, node: PointNode) -> None:
        """Shows the points of a node in large nodes of their tier; fills the last of those."""
        nodes = self._large.setdefault(tier, [])
        last = nodes.pop() if nodes and len(nodes[-1].points_mm) < NODE_POINTS // 3 else None
        if last is not None:
            node = join_nodes([last, node])
        for start in range(0, len(node.points_mm), NODE_POINTS):
            nodes.append(node.part(slice(start, start + NODE_POINTS)))
            self._show(nodes[-1], tier)
        if last is not None:
            remove_node(last)

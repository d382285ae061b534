"""The clouds of all scans in the view, within one budget of points."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import viser
from numpy.typing import NDArray

from crenel.formats.clouds.cuts import Cut
from crenel.formats.clouds.points import Points
from crenel.metrology.transforms import Floats
from crenel.station.view3d.cloud_colouring import (
    ATTRIBUTES,
    WEAK,
    Circumstances,
    CloudColouring,
    Measure,
    PointAttributes,
    Weakness,
)
from crenel.station.view3d.cloud_node import CloudNode

# Number of points recoloured per turn: recording and new points come first.
REPAINT_POINTS = 400_000
SAMPLE = 20_000
# The automatic range is computed again when this much more is shown.
LOOK_AGAIN = 1.05


@dataclass(frozen=True)
class SceneContent:
    """What the 3D view shows to all viewers, and what not."""

    arm_shown: bool
    weak_shown: bool
    """Whether weak points have colours of their own."""
    weak_points: dict[Weakness, int]
    """How many there are, the gravest last."""
    points_cut: int
    """Points that would be shown if they were not cut away."""
    floor_mm: float
    """Height of the table, or of the lowest point below it, in the arm frame."""


class CloudSet:
    """The running or last scan, and other scans in the view, by name.

    Not thread-safe: its owner holds a lock.
    """

    def __init__(self, server: viser.ViserServer, budget: int) -> None:
        self.painter = CloudColouring()
        self._server = server
        self._budget = budget
        self._views: dict[str, CloudNode] = {}
        self._made = 0
        self._shown = True
        self._range_basis: tuple[int, int] = (-1, 0)

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(self._views)

    @property
    def visible_count(self) -> int:
        return sum(view.visible_count for view in self._views.values())

    @property
    def bounds_mm(self) -> tuple[Floats, Floats]:
        """Lowest and highest corner (3,) of everything shown; infinite if nothing is shown."""
        corners = np.array([view.bounds_mm for view in self._views.values()]).reshape(-1, 2, 3)
        return (
            np.min(corners[:, 0], axis=0, initial=np.inf),
            np.max(corners[:, 1], axis=0, initial=-np.inf),
        )

    def count_visible(self, name: str) -> int:
        view = self._views.get(name)
        return view.visible_count if view else 0

    def visible_points(self, name: str) -> tuple[Floats, float]:
        """The shown points of a scan, (N, 3) mm, and the size of the cubes that thin it."""
        view = self._views[name]
        return view.points_mm(), view.voxel_mm

    def visible_attributes(self, name: str) -> PointAttributes:
        """Data of the points of ``points_of``."""
        parts = self._views[name].traits()
        return np.concatenate(parts) if parts else np.zeros(0, ATTRIBUTES)

    def cut(self, name: str, cuts: Sequence[Cut]) -> None:
        """Hides what these cuts hold of a scan; does nothing if it is not shown."""
        if (view := self._views.get(name)) is not None:
            view.cut(cuts)

    def finish(self, name: str) -> None:
        """All points of a scan are there: its weak places are known."""
        if (view := self._views.get(name)) is not None:
            view.finish()

    @property
    def cut_count(self) -> int:
        """Points that would be shown if they were not cut away."""
        return sum(view.cut_count for view in self._views.values())

    @property
    def weak_counts(self) -> dict[Weakness, int]:
        """Numbers of weak points that are shown, the gravest last."""
        counts = [view.weak_counts for view in self._views.values()]
        return {why: sum(one[i] for one in counts) for i, why in enumerate(WEAK)}

    @property
    def cuts(self) -> dict[str, tuple[Cut, ...]]:
        """The cuts of each scan, by name."""
        return {name: view.cuts for name, view in self._views.items()}

    def open(self, name: str, cuts: Sequence[Cut], live: bool = False) -> None:
        """Adds a scan, which shows nothing that these cuts hold; the others get a smaller share of
        the budget."""
        self._made += 1
        root = "/cloud" if live else f"/kept/{self._made}"
        node = CloudNode(self._server, self.painter, self._budget, cuts, root)
        node.show(self._shown)
        self._views[name] = node
        self._share()

    def empty(self, name: str) -> None:
        """Takes the points of a scan away, but not its cuts; does nothing if it is not shown."""
        if (view := self._views.get(name)) is not None:
            view.clear()

    def close(self, name: str) -> None:
        """Removes a scan from the view."""
        view = self._views.pop(name, None)
        if view is not None:
            view.remove()
            self._share()
            if not self.visible_count:
                self.painter.forget_range()

    def show(self, on: bool) -> None:
        """Shows all scans, or hides them though they stay in the view."""
        self._shown = on
        for view in self._views.values():
            view.show(on)

    def clear(self) -> None:
        for name in self.names:
            self.close(name)

    def add(self, name: str, points: Points, taken: Circumstances) -> bool:
        """Shows points (N,) captured like this; False if their scan is not shown."""
        view = self._views.get(name)
        if view is None:
            return False
        view.add(points, taken)
        return True

    def colour_by(self, measure: Measure, limits: tuple[float, float] | None) -> None:
        """Colours all clouds by this quantity, with limits in its unit, or automatic ones."""
        self.painter.show(measure, limits)
        self._settle_range()

    def settle(self) -> None:
        """One turn of the remaining work: ranges, colours, thinning. It takes little time."""
        for view in self._views.values():
            view.keep_budget()
        version, shown = self._range_basis
        more = max(self.visible_count, shown) > LOOK_AGAIN * max(min(self.visible_count, shown), 1)
        if version != self.painter.version or more:
            self._settle_range()
        left = REPAINT_POINTS
        for view in self._views.values():
            left -= view.repaint(left)

    def _settle_range(self) -> None:
        self.painter.settle_range(self._sample())
        self._range_basis = (self.painter.version, self.visible_count)

    def _sample(self) -> NDArray[np.floating]:
        parts = [view.sample(SAMPLE) for view in self._views.values()]
        return np.concatenate(parts) if parts else np.zeros(0)

    def _share(self) -> None:
        for view in self._views.values():
            view.budget = self._budget // max(len(self._views), 1)

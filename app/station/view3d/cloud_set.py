"""The clouds of the scans that are shown at once, within one budget of points."""

import numpy as np
import viser
from numpy.typing import NDArray

from app.formats.clouds.points import Points
from app.metrology.transforms import Floats
from app.station.view3d.cloud_colouring import ATTRIBUTES, CloudColouring, Measure, PointAttributes
from app.station.view3d.cloud_node import CloudNode

# So many points a turn are given other colours: the record and new points come first.
REPAINT_POINTS = 400_000
SAMPLE = 20_000
# The automatic range is looked at again when so much more is shown.
LOOK_AGAIN = 1.05


class CloudSet:
    """The scan under way, or the last one, and others that were asked for, by their names.

    Not safe for threads: its owner holds a lock.
    """

    def __init__(self, server: viser.ViserServer, budget: int) -> None:
        self.painter = CloudColouring()
        self._server = server
        self._budget = budget
        self._views: dict[str, CloudNode] = {}
        self._made = 0
        self._range_basis: tuple[int, int] = (-1, 0)

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(self._views)

    @property
    def visible_count(self) -> int:
        return sum(view.visible_count for view in self._views.values())

    @property
    def bounds_mm(self) -> tuple[Floats, Floats]:
        """Lowest and highest corner (3,) of all that is shown; infinite where nothing is."""
        lows = [view.bounds_mm[0] for view in self._views.values()]
        highs = [view.bounds_mm[1] for view in self._views.values()]
        return np.min(lows, axis=0, initial=np.inf), np.max(highs, axis=0, initial=-np.inf)

    def count_visible(self, name: str) -> int:
        view = self._views.get(name)
        return view.visible_count if view else 0

    def visible_points(self, name: str) -> tuple[Floats, float]:
        """What is shown of a scan, (N, 3) mm, and the size of the cubes that thin it."""
        view = self._views[name]
        return view.points_mm(), view.voxel_mm

    def visible_attributes(self, name: str) -> PointAttributes:
        """Beside ``points_of``."""
        parts = self._views[name].traits()
        return np.concatenate(parts) if parts else np.zeros(0, ATTRIBUTES)

    def open(self, name: str, live: bool = False) -> None:
        """A place for the points of one more scan; the others get less of the budget."""
        self._made += 1
        root = "/cloud" if live else f"/kept/{self._made}"
        self._views[name] = CloudNode(self._server, self.painter, self._budget, root)
        self._share()

    def close(self, name: str) -> None:
        """Takes a scan out of the picture."""
        view = self._views.pop(name, None)
        if view is not None:
            view.remove()
            self._share()
            if not self.visible_count:
                self.painter.forget_range()

    def clear(self) -> None:
        for name in self.names:
            self.close(name)

    def add(self, name: str, points: Points, taken_s: Floats) -> bool:
        """Shows points (N,) taken at these times (N,); False where their scan is not shown."""
        view = self._views.get(name)
        if view is None:
            return False
        view.add(points, taken_s)
        return True

    def colour_by(self, measure: Measure, limits: tuple[float, float] | None) -> None:
        """Colours all by this, within limits of its unit, or automatic ones."""
        self.painter.show(measure, limits)
        self._settle_range()

    def settle(self) -> None:
        """A turn's share of what is left to do: ranges, colours, thinning. Soon done."""
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

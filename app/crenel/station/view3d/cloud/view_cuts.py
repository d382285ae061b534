"""What is cut away of the scans in the 3D view."""

import time
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.clouds.cuts import Cut, Planes, write_cuts
from crenel.messages.message import message
from crenel.station.view3d.scene import Scene


class ViewCuts:
    """Applies cuts to the scene, and keeps them beside the recordings.

    Not thread-safe: its owner holds a lock.
    """

    def __init__(self, scene: Scene, scans_dir: Path) -> None:
        self._scene, self._scans_dir = scene, scans_dir

    @property
    def count(self) -> int:
        """How many times something was cut away of the scans in the view."""
        return len({cut.made_ns for cuts in self._scene.cuts.values() for cut in cuts})

    def add(self, planes: Planes, outside: bool) -> None:
        """Cuts away what is inside these planes, or outside of them.

        Raises:
            OperationError: there are no points, or no file can be written.
        """
        before = self._scene.content.points_cut
        cut = Cut(planes, outside, time.time_ns())
        self._apply({name: (*cuts, cut) for name, cuts in self._scene.cuts.items()})
        if self._scene.content.points_cut == before:
            self.undo()
            raise OperationError(
                "nothing-picked",
                message("there-no-points-rectangle"),
                remedy=message("draw-over-part-cloud"),
            )

    def undo(self) -> None:
        """Shows again what was cut away last; does nothing if there is nothing.

        Raises:
            OperationError: no file can be written.
        """
        known = self._scene.cuts
        last_ns = max((cut.made_ns for cuts in known.values() for cut in cuts), default=0)
        self._apply(
            {
                name: tuple(cut for cut in cuts if cut.made_ns != last_ns)
                for name, cuts in known.items()
                if any(cut.made_ns == last_ns for cut in cuts)
            }
        )

    def _apply(self, changed: dict[str, tuple[Cut, ...]]) -> None:
        for name, cuts in changed.items():
            folder = self._scans_dir / name
            if name and folder.is_dir():
                write_cuts(folder, cuts)
            self._scene.cut_scan(name, cuts)

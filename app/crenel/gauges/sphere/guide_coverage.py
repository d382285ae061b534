"""What a scan of the sphere covers while it runs, before its recording is evaluated."""

import threading

from crenel.gauges.guide_live import SeenPatches
from crenel.gauges.session.entries import SphereScan
from crenel.gauges.sphere.guide_state import SphereState
from crenel.gauges.sphere.maths_pattern import PatchCoverage
from crenel.station.scan.points import NewPoints, Show

MOST_POINTS = 500_000
"""Some seconds of a quick sensor, 20 MB."""


class WaitingPoints:
    """Whoever makes points never waits; whoever wants them takes all that have come since."""

    def __init__(self, most_points: int = MOST_POINTS) -> None:
        """``most_points``: while as many wait, further ones are left out."""
        self._most_points = most_points
        self._handing_over = threading.Lock()
        self._waiting: list[NewPoints] = []
        self._count = 0

    def put(self, new: NewPoints) -> None:
        """Adds points, unless too many wait."""
        with self._handing_over:
            if self._count < self._most_points:
                self._waiting.append(new)
                self._count += len(new.records)

    def take(self) -> list[NewPoints]:
        """All that wait, in their order."""
        with self._handing_over:
            waiting, self._waiting, self._count = self._waiting, [], 0
        return waiting


class LiveCoverage:
    """The coverage of the sphere by its newest scan. Points are counted when the counts are asked
    for, so that the scan never waits; its evaluation counts again."""

    def __init__(self) -> None:
        self._number = 0
        self._coverage: PatchCoverage | None = None
        self._waiting = WaitingPoints()

    def begin(self, number: int, coverage: PatchCoverage | None) -> Show | None:
        """Begins a new scan by its number, and returns what is to be given its points.

        Args:
            coverage: without any points; None if the sphere's centre is not known.
        """
        self._number, self._coverage, self._waiting = number, coverage, WaitingPoints()
        return None if coverage is None else self._waiting.put

    def counts(self, state: SphereState) -> SeenPatches | None:
        """By the scan that is under way or waits to be measured; None without one, or if the
        sphere's centre is not known."""
        scan = state.scans[-1] if state.scans else None
        if not isinstance(scan, SphereScan) or scan.number != self._number or scan.judged:
            return None
        if self._coverage is None:
            return None
        for new in self._waiting.take():
            self._coverage.add(new.points_mm, new.views, new.records["frame"])
        counts = zip(self._coverage.points.tolist(), self._coverage.frames.tolist(), strict=True)
        return SeenPatches(self._coverage.points_inside, tuple(counts))

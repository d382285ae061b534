"""What a scan of the sphere covers while it runs, before its recording is evaluated."""

from crenel.guide.performance.entries import SphereScan
from crenel.guide.performance.live import SeenPatches
from crenel.guide.performance.state import PerformanceState
from crenel.metrology.performance.pattern import PatchCoverage
from crenel.station.scan.points import Show
from crenel.station.scan.waiting_points import WaitingPoints


class LiveCoverage:
    """Of the sphere's newest scan. Points are counted when the counts are asked for, so that the
    scan never waits; its evaluation counts again."""

    def __init__(self) -> None:
        self._number = 0
        self._coverage: PatchCoverage | None = None
        self._waiting = WaitingPoints()

    def begin(self, number: int, coverage: PatchCoverage | None) -> Show | None:
        """Of a new scan by its number; what is to be given its points.

        Args:
            coverage: without any points; None if the sphere's centre is not known.
        """
        self._number, self._coverage, self._waiting = number, coverage, WaitingPoints()
        return None if coverage is None else self._waiting.put

    def counts(self, state: PerformanceState) -> SeenPatches | None:
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

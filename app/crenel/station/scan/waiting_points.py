"""Points of a running scan that wait for another thread."""

import threading

from crenel.station.scan.points import NewPoints

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

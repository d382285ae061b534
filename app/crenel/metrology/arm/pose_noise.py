"""Whether the poses that an arm reports show noise, and which of them repeat although they cannot.

Measured poses of an arm at rest differ in their last digits. If an arm's poses always did, equal
ones are an old pose that is sent again. The poses of an arm that reports commanded positions are
equal at rest; of such an arm, nothing can be said.
"""

import numpy as np

from crenel.metrology.transforms import Floats

WATCHED, REVERSALS, WINDOWS = 64, 16, 4
"""Noise is visible after so many windows of poses of which none repeats, and in each of which the
position turns back so often; a smooth motion turns back nowhere."""
FROZEN_S, FROZEN_COUNT = 0.15, 8
"""Equal poses for so long, and so many, are no chance."""


class PoseNoise:
    """Takes the poses of one connection in their order."""

    def __init__(self) -> None:
        self.frozen = False
        """Whether the newest pose repeats although it cannot."""
        self._visible = False
        self._last: Floats | None = None
        self._way_mm = np.zeros(3)
        self._seen = self._reversals = self._windows = 0
        self._since_ns = 0
        """Time of the first of the equal poses."""
        self._equal = 0
        """How often the newest pose was repeated."""

    def take(self, stamp_ns: int, pose: Floats) -> bool:
        """Whether a pose (7,) in mm may be one that repeats although it cannot."""
        last, self._last = self._last, pose
        if last is not None and np.array_equal(last, pose):
            return self._take_equal(stamp_ns)
        if self._equal and not self.frozen:
            # it does happen to this arm: what was learnt of its noise does not hold
            self._visible = False
            self._windows = 0
        self.frozen, self._equal, self._since_ns = False, 0, stamp_ns
        if last is not None:
            self._watch(pose[:3] - last[:3])
        return False

    def _take_equal(self, stamp_ns: int) -> bool:
        self._equal += 1
        self._seen = self._reversals = 0
        if not self._visible:
            self._windows = 0
            return False
        if self._equal >= FROZEN_COUNT and stamp_ns - self._since_ns >= FROZEN_S * 1e9:
            self.frozen = True
        return True

    def _watch(self, change_mm: Floats) -> None:
        self._reversals += bool(np.any(change_mm * self._way_mm < 0))
        self._way_mm = change_mm
        self._seen += 1
        if self._seen == WATCHED:
            self._windows += self._reversals >= REVERSALS
            self._visible = self._visible or self._windows >= WINDOWS
            self._seen = self._reversals = 0

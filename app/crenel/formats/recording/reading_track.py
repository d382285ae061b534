"""The arm's readings over time, interpolated between the samples."""

from array import array
from bisect import bisect_left

import numpy as np

from crenel.metrology.arm.reading_interpolation import Stamps, interpolate_readings
from crenel.metrology.arm.reported_poses import ReadingKind
from crenel.metrology.transforms import Floats

SHORTEST_GAP_LIMIT_NS = 25_000_000
"""With an acceleration of 1 m/s², the motion deviates from a straight line by 80 µm within 25
ms."""
GAP_LIMIT_PERIODS = 3.5
"""For slower arms: multiples of their own sample period."""
LONGEST_GAP_LIMIT_NS = 150_000_000


class ReadingTrack:
    """Readings by time stamp; 8 bytes per number, so that an hour fits in memory."""

    def __init__(self, kind: ReadingKind, size: int) -> None:
        self._kind: ReadingKind = kind
        self._size = size
        self._stamps_ns = array("q")
        self._numbers = array("d")

    def __len__(self) -> int:
        return len(self._stamps_ns)

    @property
    def first_ns(self) -> int | None:
        return self._stamps_ns[0] if self._stamps_ns else None

    @property
    def last_ns(self) -> int | None:
        return self._stamps_ns[-1] if self._stamps_ns else None

    @property
    def gap_limit_ns(self) -> int:
        """Between samples further apart than this, the motion is unknown."""
        if len(self._stamps_ns) < 2:
            return SHORTEST_GAP_LIMIT_NS
        period_ns = (self._stamps_ns[-1] - self._stamps_ns[0]) / (len(self._stamps_ns) - 1)
        limit_ns = max(SHORTEST_GAP_LIMIT_NS, int(GAP_LIMIT_PERIODS * period_ns))
        return min(limit_ns, LONGEST_GAP_LIMIT_NS)

    def add(self, stamp_ns: int, reading: Floats | tuple[float, ...]) -> None:
        """Adds a sample (k,); late samples are sorted in, a repeated stamp is ignored."""
        at = len(self._stamps_ns)
        if at and stamp_ns <= self._stamps_ns[-1]:
            at = bisect_left(self._stamps_ns, stamp_ns)
            if self._stamps_ns[at] == stamp_ns:
                return
        self._stamps_ns.insert(at, stamp_ns)
        start = at * self._size
        self._numbers[start:start] = array("d", reading)

    def extend(self, stamps_ns: Stamps, readings: Floats) -> None:
        """Adds samples (J,) and (J, k), like ``add`` for each."""
        if not len(stamps_ns):
            return
        last_ns = self.last_ns
        if (np.diff(stamps_ns) > 0).all() and (last_ns is None or stamps_ns[0] > last_ns):
            self._stamps_ns.frombytes(np.ascontiguousarray(stamps_ns, np.int64).tobytes())
            self._numbers.frombytes(np.ascontiguousarray(readings, np.float64).tobytes())
            return
        for stamp_ns, reading in zip(stamps_ns.tolist(), readings, strict=True):
            self.add(stamp_ns, reading)

    def at_all(self, stamps_ns: Stamps) -> Floats:
        """The readings (F, k) at time stamps (F,), as from ``at``; NaN instead of None."""
        found = np.full((len(stamps_ns), self._size), np.nan)
        if not len(self._stamps_ns) or not len(stamps_ns):
            return found
        first = max(bisect_left(self._stamps_ns, int(stamps_ns.min())) - 1, 0)
        last = bisect_left(self._stamps_ns, int(stamps_ns.max())) + 1
        stamps = np.array(self._stamps_ns[first:last])
        numbers = np.array(self._numbers[first * self._size : last * self._size])
        return interpolate_readings(
            self._kind, stamps, numbers.reshape(-1, self._size), stamps_ns, self.gap_limit_ns
        )

    def at(self, stamp_ns: int) -> Floats | None:
        """The reading (k,) at a time stamp, interpolated between the adjacent samples.

        Returns:
            None outside the samples, or if they are more than ``gap_limit_ns`` apart.
        """
        reading = self.at_all(np.array([stamp_ns], dtype=np.int64))[0]
        return None if np.isnan(reading).any() else reading

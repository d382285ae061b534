"""The arm's angles over time, interpolated between the samples."""

from array import array
from bisect import bisect_left

import numpy as np

from app.metrology.arm.joint_interpolation import Stamps, interpolate_angles
from app.metrology.transforms import Floats

SHORTEST_GAP_LIMIT_NS = 25_000_000
"""With an acceleration of 1 m/s², the motion deviates from a straight line by 80 µm within 25
ms."""
GAP_LIMIT_PERIODS = 3.5
"""For slower arms: multiples of their own sample period."""
LONGEST_GAP_LIMIT_NS = 150_000_000


class JointTrack:
    """Joint samples by time stamp; 8 bytes per number, so that an hour fits in memory."""

    def __init__(self, joint_count: int) -> None:
        self._count = joint_count
        self._stamps_ns = array("q")
        self._angles_rad = array("d")

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

    def add(self, stamp_ns: int, q_rad: Floats | tuple[float, ...]) -> None:
        """Adds a sample (n,); late samples are sorted in, a repeated stamp is ignored."""
        at = len(self._stamps_ns)
        if at and stamp_ns <= self._stamps_ns[-1]:
            at = bisect_left(self._stamps_ns, stamp_ns)
            if self._stamps_ns[at] == stamp_ns:
                return
        self._stamps_ns.insert(at, stamp_ns)
        start = at * self._count
        self._angles_rad[start:start] = array("d", q_rad)

    def extend(self, stamps_ns: Stamps, q_rad: Floats) -> None:
        """Adds samples (J,) and (J, n), like ``add`` for each."""
        if not len(stamps_ns):
            return
        last_ns = self.last_ns
        if (np.diff(stamps_ns) > 0).all() and (last_ns is None or stamps_ns[0] > last_ns):
            self._stamps_ns.frombytes(np.ascontiguousarray(stamps_ns, np.int64).tobytes())
            self._angles_rad.frombytes(np.ascontiguousarray(q_rad, np.float64).tobytes())
            return
        for stamp_ns, angles in zip(stamps_ns.tolist(), q_rad, strict=True):
            self.add(stamp_ns, angles)

    def at_all(self, stamps_ns: Stamps) -> Floats:
        """The angles (F, n) at time stamps (F,), as from ``at``; NaN instead of None."""
        found = np.full((len(stamps_ns), self._count), np.nan)
        if not len(self._stamps_ns) or not len(stamps_ns):
            return found
        first = max(bisect_left(self._stamps_ns, int(stamps_ns.min())) - 1, 0)
        last = bisect_left(self._stamps_ns, int(stamps_ns.max())) + 1
        stamps = np.array(self._stamps_ns[first:last])
        angles = np.array(self._angles_rad[first * self._count : last * self._count])
        return interpolate_angles(
            stamps, angles.reshape(-1, self._count), stamps_ns, self.gap_limit_ns
        )

    def at(self, stamp_ns: int) -> Floats | None:
        """The angles (n,) at a time stamp, linearly interpolated between the adjacent samples.

        A joint that passes half a turn is followed along the shorter way.

        Returns:
            None outside the samples, or if they are more than ``gap_limit_ns`` apart.
        """
        angles = self.at_all(np.array([stamp_ns], dtype=np.int64))[0]
        return None if np.isnan(angles).any() else angles

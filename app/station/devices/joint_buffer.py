"""The arm's joint samples of the last seconds, and the pose at a time stamp."""

import threading
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from app.formats.recording.joint_track import (
    GAP_LIMIT_PERIODS,
    LONGEST_GAP_LIMIT_NS,
    SHORTEST_GAP_LIMIT_NS,
)
from app.metrology.arm.joint_interpolation import Stamps, interpolate_angles, shortest_turn
from app.metrology.transforms import Floats
from hardware.interfaces import JointSample

RING_SAMPLES = 16_384


@dataclass(frozen=True)
class JointWindow:
    """Joint samples of an interval of time, oldest first."""

    stamps_ns: Stamps  # (N,)
    q_rad: Floats  # (N, n)

    def __len__(self) -> int:
        return len(self.stamps_ns)


class JointRing:
    """A ring of joint samples that one thread fills and others read.

    A sample whose time stamp is not later than the last one is discarded: interpolation relies on
    increasing time.
    """

    def __init__(self, joint_count: int, rate_hz: float) -> None:
        self.joint_count = joint_count
        # as in reconstruction: both keep the same frames
        self.gap_limit_ns = int(
            np.clip(
                GAP_LIMIT_PERIODS * 1e9 / max(rate_hz, 1.0),
                SHORTEST_GAP_LIMIT_NS,
                LONGEST_GAP_LIMIT_NS,
            )
        )
        self._stamps: Stamps = np.zeros(RING_SAMPLES, dtype=np.int64)
        self._q: Floats = np.zeros((RING_SAMPLES, joint_count))
        self._count = 0
        self._judged_ns: int | None = None
        self._grown = threading.Condition()

    def extend(self, samples: Sequence[JointSample], judged_ns: int | None = None) -> None:
        """Appends samples, oldest first.

        ``judged_ns``: no more samples will arrive up to here, though some may have been discarded.
        """
        with self._grown:
            for sample in samples:
                if self._count and sample.stamp_ns <= self._last_stamp():
                    continue
                self._stamps[self._count % RING_SAMPLES] = sample.stamp_ns
                self._q[self._count % RING_SAMPLES] = sample.joints_rad
                self._count += 1
            self._judged_ns = judged_ns
            self._grown.notify_all()

    def between(self, first_ns: int, last_ns: int) -> JointWindow:
        """The stored samples with ``first_ns <= stamp <= last_ns``."""
        with self._grown:
            low = self._position(first_ns, "left")
            high = self._position(last_ns, "right")
            at = np.arange(low, high) % RING_SAMPLES
            return JointWindow(self._stamps[at], self._q[at])

    def covers(self, window: JointWindow, first_ns: int, last_ns: int) -> bool:
        """True if a window covers the whole interval: no gap longer than a fifth of it."""
        ends = np.concatenate([[first_ns], window.stamps_ns, [last_ns]])
        longest_ns = int(np.diff(ends).max())
        return longest_ns <= max(self.gap_limit_ns, (last_ns - first_ns) // 5)

    def wait_past(self, stamp_ns: int, timeout_s: float) -> bool:
        """Waits for a sample at or after a time stamp; True also if such samples were discarded."""
        with self._grown:
            return self._grown.wait_for(
                lambda: self._count > 0 and self._reaches_ns() >= stamp_ns, timeout_s
            )

    def at(self, stamp_ns: int, wait_s: float = 0.0) -> Floats | None:
        """Encoder angles (n,) at a time stamp, interpolated linearly between the adjacent samples.

        Waits up to ``wait_s`` for the sample after it. None if there is no sample on one side, or
        if they are further apart than ``gap_limit_ns``.
        """
        angles = self.at_all(np.array([stamp_ns]), wait_s)[0]
        return None if np.isnan(angles).any() else angles

    def at_all(self, stamps_ns: Stamps, wait_s: float = 0.0) -> Floats:
        """The same (F, n) for adjacent time stamps (F,); NaN where ``at`` returns None."""
        first_ns, last_ns = int(stamps_ns.min()), int(stamps_ns.max())
        self.wait_past(last_ns, wait_s)
        around = self.between(first_ns - self.gap_limit_ns, last_ns + self.gap_limit_ns)
        return interpolate_angles(around.stamps_ns, around.q_rad, stamps_ns, self.gap_limit_ns)

    def last_stamp_ns(self) -> int | None:
        with self._grown:
            return self._last_stamp() if self._count else None

    def _oldest(self) -> int:
        return max(0, self._count - RING_SAMPLES)

    def _reaches_ns(self) -> int:
        return max(self._last_stamp(), self._judged_ns or 0)

    def _last_stamp(self) -> int:
        return int(self._stamps[(self._count - 1) % RING_SAMPLES])

    def _position(self, stamp_ns: int, side: str) -> int:
        """The running index of the first stored sample at or after (right: after) a time stamp."""
        low, high = self._oldest(), self._count
        while low < high:
            middle = (low + high) // 2
            found = int(self._stamps[middle % RING_SAMPLES])
            if found < stamp_ns or (side == "right" and found == stamp_ns):
                low = middle + 1
            else:
                high = middle
        return low


@dataclass(frozen=True)
class JointMean:
    """Mean of the joint samples of an interval of time."""

    q_rad: Floats  # (n,)
    scatter_rad: Floats  # (n,) standard deviation of one sample
    samples: int
    first_ns: int
    last_ns: int


def average_joints(window: JointWindow) -> JointMean:
    """The mean of a window of at least one sample, with the scatter of the samples."""
    turns = shortest_turn(window.q_rad - window.q_rad[0])
    scatter = turns.std(axis=0, ddof=1) if len(window) > 1 else np.zeros(turns.shape[1])
    return JointMean(
        np.asarray(window.q_rad[0] + turns.mean(axis=0)),
        np.asarray(scatter),
        len(window),
        int(window.stamps_ns[0]),
        int(window.stamps_ns[-1]),
    )

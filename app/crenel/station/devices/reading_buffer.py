"""The arm's readings of the last seconds, and the one at a time stamp."""

import threading
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crenel.formats.recording.reading_track import (
    GAP_LIMIT_PERIODS,
    LONGEST_GAP_LIMIT_NS,
    SHORTEST_GAP_LIMIT_NS,
)
from crenel.metrology.arm.reading_interpolation import (
    Stamps,
    interpolate_readings,
    mean_reading,
    reading_differences,
)
from crenel.metrology.arm.reported_poses import POSE_SIZE, ReadingKind
from crenel.metrology.transforms import Floats
from crenel_hardware.interfaces import ArmInfo, ArmReading

RING_SAMPLES = 16_384


def reading_size(info: ArmInfo) -> int:
    """Numbers of one reading: joints, or position and quaternion."""
    return POSE_SIZE if info.reports == "pose" else info.joint_count


@dataclass(frozen=True)
class ReadingWindow:
    """Readings of an interval of time, oldest first."""

    kind: ReadingKind
    stamps_ns: Stamps  # (N,)
    readings: Floats  # (N, k)

    def __len__(self) -> int:
        return len(self.stamps_ns)


class ReadingRing:
    """A ring of readings that one thread fills and others read: joint angles, or poses.

    A sample whose time stamp is not later than the last one is discarded: interpolation relies on
    increasing time.
    """

    def __init__(self, info: ArmInfo) -> None:
        self.kind: ReadingKind = info.reports
        self.size = reading_size(info)
        # as in reconstruction: both keep the same frames
        self.gap_limit_ns = int(
            np.clip(
                GAP_LIMIT_PERIODS * 1e9 / max(info.rate_hz, 1.0),
                SHORTEST_GAP_LIMIT_NS,
                LONGEST_GAP_LIMIT_NS,
            )
        )
        self._stamps: Stamps = np.zeros(RING_SAMPLES, dtype=np.int64)
        self._readings: Floats = np.zeros((RING_SAMPLES, self.size))
        self._count = 0
        self._judged_ns: int | None = None
        self._grown = threading.Condition()

    def extend(self, samples: Sequence[ArmReading], judged_ns: int | None = None) -> None:
        """Appends samples, oldest first.

        ``judged_ns``: no more samples will arrive up to here, though some may have been discarded.
        """
        with self._grown:
            for sample in samples:
                if self._count and sample.stamp_ns <= self._last_stamp():
                    continue
                self._stamps[self._count % RING_SAMPLES] = sample.stamp_ns
                self._readings[self._count % RING_SAMPLES] = sample.reading
                self._count += 1
            self._judged_ns = judged_ns
            self._grown.notify_all()

    def between(self, first_ns: int, last_ns: int) -> ReadingWindow:
        """The stored samples with ``first_ns <= stamp <= last_ns``."""
        with self._grown:
            low = self._position(first_ns, "left")
            high = self._position(last_ns, "right")
            at = np.arange(low, high) % RING_SAMPLES
            return ReadingWindow(self.kind, self._stamps[at], self._readings[at])

    def covers(self, window: ReadingWindow, first_ns: int, last_ns: int) -> bool:
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
        """The reading (k,) at a time stamp, interpolated between the adjacent samples.

        Waits up to ``wait_s`` for the sample after it. None if there is no sample on one side, or
        if they are further apart than ``gap_limit_ns``.
        """
        reading = self.at_all(np.array([stamp_ns]), wait_s)[0]
        return None if np.isnan(reading).any() else reading

    def at_all(self, stamps_ns: Stamps, wait_s: float = 0.0) -> Floats:
        """The same (F, k) for adjacent time stamps (F,); NaN where ``at`` returns None."""
        first_ns, last_ns = int(stamps_ns.min()), int(stamps_ns.max())
        self.wait_past(last_ns, wait_s)
        around = self.between(first_ns - self.gap_limit_ns, last_ns + self.gap_limit_ns)
        return interpolate_readings(
            self.kind, around.stamps_ns, around.readings, stamps_ns, self.gap_limit_ns
        )

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
class ReadingMean:
    """Mean of the readings of an interval of time."""

    reading: Floats  # (k,)
    scatter: Floats  # (k,) standard deviation of one sample, in the units of the reading
    samples: int
    first_ns: int
    last_ns: int


def average_readings(window: ReadingWindow) -> ReadingMean:
    """The mean of a window of at least one sample, with the scatter of the samples."""
    differences = reading_differences(window.kind, window.readings)
    scatter = differences.std(axis=0, ddof=1) if len(window) > 1 else np.zeros(differences.shape[1])
    return ReadingMean(
        mean_reading(window.kind, window.readings),
        np.asarray(scatter),
        len(window),
        int(window.stamps_ns[0]),
        int(window.stamps_ns[-1]),
    )

"""A recording in place of the devices: its joints and pictures again, as they came.

Stamps are moved to now, at any speed. What a recording holds is handed in, so that no
file format is known here.
"""

import threading
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel_hardware.clock import now_ns
from crenel_hardware.interfaces import (
    ArmInfo,
    ArmReading,
    ArmRecord,
    Frame,
    JointSample,
    LinkHealth,
    PoseSample,
    SensorInfo,
)

WAIT_S = 0.02
"""For readings that are not due yet."""
REST_GAP_NS = 300_000_000
"""The gap from which on the last picture is repeated in between."""
MOST_AT_ONCE = 1000
"""Readings in one answer."""
LONGEST_NS = 200_000_000
"""An answer takes no longer where all readings are due at once."""

Readings = Iterable[tuple[int, tuple[float, ...]]]
"""Stamps (ns) and readings (encoder angles in rad, or a pose) in their order."""
RecordedImage = NDArray[np.uint8] | NDArray[np.uint16]
RecordedImages = Iterable[tuple[int, RecordedImage]]


@dataclass
class ReplayClock:
    """When what was recorded comes again; one clock for all that replays."""

    first_ns: int
    """The time of the recording's first message."""
    speed: float
    """1 as it was; 0 as fast as it can be read."""

    def __post_init__(self) -> None:
        self.start()

    def start(self) -> None:
        """The first stamp is due now."""
        self._start_ns = now_ns()

    def due_ns(self, stamp_ns: int) -> int:
        """When a stamp is due, on the host's clock; at speed 0 all are due at the start."""
        if not self.speed:
            return self._start_ns
        return self._start_ns + int((stamp_ns - self.first_ns) / self.speed)

    def stamp_again_ns(self, stamp_ns: int, read_ns: int) -> int:
        """The stamp with which it comes again, where it is read at a time."""
        return self.due_ns(stamp_ns) if self.speed else read_ns


class ReplayArm:
    """Meets ``ArmDriver``; silent where the recording ends, and between readings far apart.

    A reading that was repeated instead would be that of an arm whose encoders are frozen. So it
    meets ``AnswersWhileSilent``. At speed 0, only the last reading comes: those between would be
    leaps that no arm makes.
    """

    def __init__(self, info: ArmInfo, clock: ReplayClock, readings: Callable[[], Readings]) -> None:
        self._info, self._clock, self._readings = info, clock, readings
        self._coming: Iterator[tuple[int, tuple[float, ...]]] = iter(())
        self._next: tuple[int, tuple[float, ...]] | None = None
        self._health = LinkHealth()
        self._closed = threading.Event()

    @property
    def health(self) -> LinkHealth:
        return self._health

    def open(self) -> ArmInfo:
        self._closed.clear()
        self._coming = iter(self._readings())
        self._next = next(self._coming, None)
        return self._info

    def read(self, timeout_s: float) -> Sequence[ArmRecord]:
        if self._closed.wait(min(timeout_s, WAIT_S)):
            return []
        if not self._clock.speed:
            return self._read_to_the_end()
        now, found = now_ns(), []
        while self._next is not None and self._clock.due_ns(self._next[0]) <= now:
            stamp_ns, reading = self._next
            found.append(self._sample(self._clock.stamp_again_ns(stamp_ns, now), reading))
            self._next = next(self._coming, None)
            if len(found) == MOST_AT_ONCE:
                break
        return found

    def is_alive(self) -> bool:
        return not self._closed.is_set()

    def _read_to_the_end(self) -> list[ArmRecord]:
        """The last reading of all; empty while there are more, and afterwards."""
        until_ns = now_ns() + LONGEST_NS
        while self._next is not None and now_ns() < until_ns:
            _, reading = self._next
            self._next = next(self._coming, None)
            if self._next is None:
                return [self._sample(now_ns(), reading)]
        return []

    def _sample(self, stamp_ns: int, reading: tuple[float, ...]) -> ArmReading:
        self._health.received += 1
        if self._info.reports == "joints":
            return JointSample(self._health.received, stamp_ns, reading)
        x, y, z, qx, qy, qz, qw = reading
        return PoseSample(self._health.received, stamp_ns, (x, y, z), (qx, qy, qz, qw))

    def close(self) -> None:
        self._closed.set()


class ReplaySensor:
    """Meets ``SensorDriver``.

    Between pictures that lie far apart it shows the last one again; a dark one where none
    were recorded.
    """

    def __init__(
        self, info: SensorInfo, clock: ReplayClock, pictures: Callable[[], RecordedImages]
    ) -> None:
        self._info, self._clock, self._pictures = info, clock, pictures
        self._coming: Iterator[tuple[int, RecordedImage]] = iter(())
        self._next: tuple[int, RecordedImage] | None = None
        self._last: RecordedImage = np.zeros((info.height_px, info.width_px), np.uint8)
        self._rested_ns = 0
        self._health = LinkHealth()
        self._closed = threading.Event()

    @property
    def health(self) -> LinkHealth:
        return self._health

    def open(self) -> SensorInfo:
        self._closed.clear()
        self._coming = iter(self._pictures())
        self._next = next(self._coming, None)
        self._rested_ns = now_ns()
        return self._info

    def read(self, timeout_s: float) -> Frame | None:
        due_ns = self._rested_ns + REST_GAP_NS
        if self._next is not None:
            due_ns = min(self._clock.due_ns(self._next[0]), due_ns)
        left_s = (due_ns - now_ns()) / 1e9
        if self._closed.wait(min(max(left_s, 0.0), timeout_s)) or left_s > timeout_s:
            return None
        self._rested_ns = now_ns()
        if self._next is None or self._clock.due_ns(self._next[0]) > self._rested_ns:
            return self._frame(self._rested_ns, self._last)
        stamp_ns, self._last = self._next
        self._next = next(self._coming, None)
        return self._frame(self._clock.stamp_again_ns(stamp_ns, self._rested_ns), self._last)

    def _frame(self, stamp_ns: int, picture: RecordedImage) -> Frame:
        self._health.received += 1
        exposure_us = self._info.exposure_range_us[0]
        # no light burns now, whatever the picture shows
        return Frame(self._health.received, stamp_ns, picture, exposure_us, False)

    def set_exposure_us(self, exposure_us: float) -> None:
        """What was exposed stays so."""

    def set_laser(self, on: bool) -> None:
        """There is none to switch."""

    def close(self) -> None:
        self._closed.set()

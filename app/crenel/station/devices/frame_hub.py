"""Distributes the sensor's frames and lines."""

import threading
from collections import deque
from collections.abc import Callable

from crenel_hardware.interfaces import Frame, SensorReading


class FrameTap:
    """A bounded queue of frames and lines for one consumer; the oldest is dropped if it is full."""

    def __init__(self, size: int) -> None:
        self._frames: deque[SensorReading] = deque(maxlen=size)
        self._arrived = threading.Condition()
        self._dropped = 0
        self._closed = False

    @property
    def dropped(self) -> int:
        """Number of frames dropped because the consumer was slow."""
        return self._dropped

    @property
    def finished(self) -> bool:
        """True when it is closed and every frame was taken."""
        with self._arrived:
            return self._closed and not self._frames

    def put(self, frame: SensorReading) -> None:
        with self._arrived:
            if self._closed:
                return
            self._dropped += len(self._frames) == self._frames.maxlen
            self._frames.append(frame)
            self._arrived.notify()

    def get(self, most: int, timeout_s: float) -> list[SensorReading]:
        """Up to ``most`` waiting frames, oldest first; none after the timeout, or at once if closed
        and empty."""
        with self._arrived:
            self._arrived.wait_for(lambda: self._frames or self._closed, timeout_s)
            return [self._frames.popleft() for _ in range(min(most, len(self._frames)))]

    def close(self) -> None:
        """No frame follows; waiting frames can still be taken."""
        with self._arrived:
            self._closed = True
            self._arrived.notify_all()


class FrameHub:
    """Distributes frames and lines: the latest on request, every one to the taps."""

    def __init__(self) -> None:
        self._arrived = threading.Condition()
        self._latest: Frame | None = None
        self._newest: SensorReading | None = None
        self._taps: list[FrameTap] = []

    def put(self, frame: SensorReading) -> None:
        """Called by the sensor's thread; never waits."""
        with self._arrived:
            self._newest = frame
            if isinstance(frame, Frame):
                self._latest = frame
            taps = tuple(self._taps)
            self._arrived.notify_all()
        for tap in taps:
            tap.put(frame)

    def clear(self) -> None:
        """Forgets what came: another sensor follows."""
        with self._arrived:
            self._latest = self._newest = None

    @property
    def latest(self) -> Frame | None:
        """The latest picture."""
        with self._arrived:
            return self._latest

    @property
    def newest(self) -> SensorReading | None:
        """The latest picture or line."""
        with self._arrived:
            return self._newest

    def wait(self, wanted: Callable[[Frame], bool], timeout_s: float) -> Frame | None:
        """The latest picture that fulfils the condition, as soon as there is one; None after the
        timeout."""
        with self._arrived:
            self._arrived.wait_for(
                lambda: self._latest is not None and wanted(self._latest), timeout_s
            )
            latest = self._latest
        return latest if latest is not None and wanted(latest) else None

    def wait_newest(
        self, wanted: Callable[[SensorReading], bool], timeout_s: float
    ) -> SensorReading | None:
        """The same of pictures and lines."""
        with self._arrived:
            self._arrived.wait_for(
                lambda: self._newest is not None and wanted(self._newest), timeout_s
            )
            newest = self._newest
        return newest if newest is not None and wanted(newest) else None

    def tap(self, size: int) -> FrameTap:
        """A queue that gets every frame and line from now on."""
        tap = FrameTap(size)
        with self._arrived:
            self._taps.append(tap)
        return tap

    def untap(self, tap: FrameTap) -> None:
        with self._arrived:
            self._taps.remove(tap)
        tap.close()

"""Distributes the sensor's frames."""

import threading
from collections import deque
from collections.abc import Callable

from hardware.interfaces import Frame


class FrameTap:
    """A bounded queue of frames for one consumer; the oldest is dropped if it is full."""

    def __init__(self, size: int) -> None:
        self._frames: deque[Frame] = deque(maxlen=size)
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

    def put(self, frame: Frame) -> None:
        with self._arrived:
            if self._closed:
                return
            self._dropped += len(self._frames) == self._frames.maxlen
            self._frames.append(frame)
            self._arrived.notify()

    def get(self, most: int, timeout_s: float) -> list[Frame]:
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
    """Distributes frames: the latest on request, every one to the taps."""

    def __init__(self) -> None:
        self._arrived = threading.Condition()
        self._latest: Frame | None = None
        self._taps: list[FrameTap] = []

    def put(self, frame: Frame) -> None:
        """Called by the sensor's thread; never waits."""
        with self._arrived:
            self._latest = frame
            taps = tuple(self._taps)
            self._arrived.notify_all()
        for tap in taps:
            tap.put(frame)

    def clear(self) -> None:
        """Forgets the latest frame: another sensor follows."""
        with self._arrived:
            self._latest = None

    @property
    def latest(self) -> Frame | None:
        with self._arrived:
            return self._latest

    def wait(self, wanted: Callable[[Frame], bool], timeout_s: float) -> Frame | None:
        """The latest frame that fulfils the condition, as soon as there is one; None after the
        timeout."""
        with self._arrived:
            self._arrived.wait_for(
                lambda: self._latest is not None and wanted(self._latest), timeout_s
            )
            latest = self._latest
        return latest if latest is not None and wanted(latest) else None

    def tap(self, size: int) -> FrameTap:
        """A queue that gets every frame from now on."""
        tap = FrameTap(size)
        with self._arrived:
            self._taps.append(tap)
        return tap

    def untap(self, tap: FrameTap) -> None:
        with self._arrived:
            self._taps.remove(tap)
        tap.close()

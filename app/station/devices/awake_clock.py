"""A clock that stops while the whole program is blocked.

On a busy machine, every thread of the program may wait for a processor for seconds, and data sent
by a device in the meantime is read afterwards. Silence is measured with this clock, so that such a
pause is not attributed to a device.
"""

import threading
import time

from app.loops import Loop

TICK_S = 0.1
MOST_S = 0.3
"""Maximum duration of a tick: a thread that wakes up later had no processor."""


class AwakeClock:
    """Counts the seconds in which its thread ran when it wanted to."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._awake_s = 0.0
        self._ticked_s = time.monotonic()
        self._loop: Loop | None = None

    def now_s(self) -> float:
        """Seconds from an arbitrary origin; the first call starts the thread."""
        with self._lock:
            if self._loop is None:
                self._ticked_s = time.monotonic()
                self._loop = Loop("awake", self._tick, TICK_S)
                self._loop.start()
            return self._awake_s + min(time.monotonic() - self._ticked_s, MOST_S)

    def _tick(self) -> None:
        with self._lock:
            now_s = time.monotonic()
            self._awake_s += min(now_s - self._ticked_s, MOST_S)
            self._ticked_s = now_s


AWAKE = AwakeClock()
"""The clock of the program."""

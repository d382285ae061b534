"""A clock that stops while the whole program is blocked.

On a busy machine, every thread of the program may wait for a processor for seconds, and data sent
by a device in the meantime is read afterwards. Silence is measured with this clock, so that such a
pause is not attributed to a device.
"""

import sys
import threading
import time

from crenel.loops import Loop

TICK_S = 0.1
MOST_S = 0.3
"""Maximum duration of a tick: a thread that wakes up later had no processor."""
SUSPENDED_S = 5.0
"""A tick that is later than this: the program, or the machine, was suspended."""


class AwakeClock:
    """Counts the seconds in which its thread ran when it wanted to."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._awake_s = self._suspended_s = 0.0
        self._ticked_s, self._booted_s = time.monotonic(), _since_boot_s()
        self._loop: Loop | None = None

    def now_s(self) -> float:
        """Seconds from an arbitrary origin; the first call starts the thread."""
        with self._lock:
            if self._loop is None:
                self._ticked_s, self._booted_s = time.monotonic(), _since_boot_s()
                self._loop = Loop("awake", self._tick, TICK_S)
                self._loop.start()
            return self._awake_s + min(time.monotonic() - self._ticked_s, MOST_S)

    @property
    def suspended_s(self) -> float:
        """Seconds for which the program was suspended since it began, also with the machine."""
        with self._lock:
            late_s = _since_boot_s() - self._booted_s if self._loop is not None else 0.0
            return self._suspended_s + (late_s if late_s > SUSPENDED_S else 0.0)

    def _tick(self) -> None:
        with self._lock:
            now_s, booted_s = time.monotonic(), _since_boot_s()
            self._awake_s += min(now_s - self._ticked_s, MOST_S)
            late_s = booted_s - self._booted_s
            self._suspended_s += late_s if late_s > SUSPENDED_S else 0.0
            self._ticked_s, self._booted_s = now_s, booted_s


def _since_boot_s() -> float:
    """Where the system has such a clock, it goes on while the machine sleeps."""
    if sys.platform == "linux":
        return time.clock_gettime(time.CLOCK_BOOTTIME)
    return time.monotonic()


AWAKE = AwakeClock()
"""The clock of the program."""

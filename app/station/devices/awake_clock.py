"""A clock that stands while the whole program stands.

On a busy machine every thread of the program may wait for a processor for seconds, and what a
device sent meanwhile is read only afterwards. Silence is measured by this clock, so that such a
pause is not taken for a device's.
"""

import threading
import time

TICK_S = 0.1
MOST_S = 0.3
"""What a tick counts for at most: a thread that wakes up later had no processor."""


class AwakeClock:
    """Counts the seconds in which a thread of its own got to run when it wanted to."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._awake_s = 0.0
        self._ticked_s = time.monotonic()
        self._thread: threading.Thread | None = None

    def now_s(self) -> float:
        """Seconds of an arbitrary origin; the first call starts the thread."""
        with self._lock:
            if self._thread is None:
                self._ticked_s = time.monotonic()
                self._thread = threading.Thread(target=self._run, name="awake", daemon=True)
                self._thread.start()
            return self._awake_s + min(time.monotonic() - self._ticked_s, MOST_S)

    def _run(self) -> None:
        while True:
            time.sleep(TICK_S)
            with self._lock:
                now_s = time.monotonic()
                self._awake_s += min(now_s - self._ticked_s, MOST_S)
                self._ticked_s = now_s


AWAKE = AwakeClock()
"""The program's."""

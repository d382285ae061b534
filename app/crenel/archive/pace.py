"""How fast the archive reads and sends: slowly while a scan runs."""

import threading
import time
from collections.abc import Callable

from crenel.errors import OperationError
from crenel.loop_states import note_progress
from crenel.messages.message import message

LONGEST_WAIT_S = 0.5
"""The end of a scan and of the station is noticed within this time."""


class ArchiveEndedError(OperationError):
    """The station ends, and the rest is copied after its next start."""

    def __init__(self) -> None:
        super().__init__("archive-ended", message("archive-goes-on-later"))


class Pace:
    """Delays a copy so that it stays below a rate while ``is_slow`` says so.

    Args:
        rate_bytes_s: at most this.
    """

    def __init__(self, rate_bytes_s: float, is_slow: Callable[[], bool]) -> None:
        self._rate_bytes_s, self._is_slow = rate_bytes_s, is_slow
        self.ending = threading.Event()
        self.waited_s = 0.0
        """All delays together."""

    def take(self, count: int) -> None:
        """Called before so many bytes are read, sent or received.

        Raises:
            ArchiveEndedError: ``ending`` is set.
        """
        note_progress()
        due_s = time.monotonic() + count / self._rate_bytes_s
        while not self.ending.is_set() and self._is_slow():
            left_s = due_s - time.monotonic()
            if left_s <= 0:
                break
            left_s = min(left_s, LONGEST_WAIT_S)
            self.ending.wait(left_s)
            note_progress()
            self.waited_s += left_s
        if self.ending.is_set():
            raise ArchiveEndedError


def full_speed() -> Pace:
    """For a command that somebody waits for."""
    return Pace(1.0, lambda: False)

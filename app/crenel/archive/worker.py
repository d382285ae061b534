"""The thread that keeps the archive up to date while the station runs."""

import logging
import os
import threading
import time
from collections.abc import Callable

from crenel.archive.archive import Archive, ArchiveState
from crenel.archive.manifest import Kind
from crenel.archive.pace import ArchiveEndedError
from crenel.errors import OperationError
from crenel.loops import Loop
from crenel.messages.message import Text, message

log = logging.getLogger(__name__)
LONGEST_S = 120.0
"""Without a byte that is read or sent: a storage far away is tried again for a while."""
LOOK_S = 30.0
"""Between two looks for finished records."""
FIRST_PAUSE_S, LONGEST_PAUSE_S = 30.0, 3600.0
NICENESS = 10
"""How far the thread gives way: it computes hashes only when nothing else needs the processor."""
END_S = 5.0


class ArchiveWorker:
    """Copies finished records one after the other, and retries with growing pauses.

    Args:
        on_trouble: called with the text of an error that was not there before.
        look_s: between two looks.
        first_pause_s: after the first failure; each further one doubles it.
    """

    def __init__(
        self,
        archive: Archive,
        on_trouble: Callable[[Text], object],
        look_s: float = LOOK_S,
        first_pause_s: float = FIRST_PAUSE_S,
    ) -> None:
        self._archive, self._on_trouble = archive, on_trouble
        self._look_s, self._first_pause_s = look_s, first_pause_s
        self.place = archive.settings.place
        self.trouble: OperationError | None = None
        """Why the last attempt failed; None if it did not."""
        self.failures = 0
        """Attempts that failed since the last one that did not."""
        self.is_on_same_disk: bool | None = None
        """Whether the archive is on a disk of the records; None if not known, or on none here."""
        self._next_s = 0.0
        self._loop = Loop("archive", self._step, ending=archive.pace.ending, longest_s=LONGEST_S)

    @property
    def retry_in_s(self) -> float:
        """Until the next attempt."""
        return max(self._next_s - time.monotonic(), 0.0)

    def state(self) -> ArchiveState:
        """What is where; it looks at every record on the disk."""
        return self._archive.state()

    def fetch(self, kind: Kind, record_id: str) -> None:
        """Brings a record back to the station's disk; raises ``OperationError``."""
        self._archive.fetch(kind, record_id)

    def start(self) -> None:
        """Starts the thread."""
        self._loop.start()

    def close(self) -> None:
        """Ends the copy in progress; the next start continues it. Idempotent."""
        self._loop.stop(END_S)

    def _step(self) -> float:
        """One attempt; returns the pause after it."""
        # of this thread only
        os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), NICENESS)
        pause_s = self._attempt()
        self._next_s = time.monotonic() + pause_s
        return pause_s

    def _attempt(self) -> float:
        try:
            self.is_on_same_disk = self._archive.is_on_same_disk()
            self._archive.run()
        except ArchiveEndedError:
            return 0.0
        except OperationError as error:
            return self._note_failure(error)
        except Exception as error:  # the station continues
            log.exception("the archive failed")
            return self._note_failure(
                OperationError("failed", message("program-failed"), type(error).__name__)
            )
        if self.failures:
            log.info("the archive works again")
        self.trouble, self.failures = None, 0
        return self._look_s

    def _note_failure(self, error: OperationError) -> float:
        known = self.trouble
        self.trouble = error
        self.failures += 1
        if known is None or known.code != error.code:
            self._on_trouble(error.text)
        return pause_after(self.failures, self._first_pause_s)


def pause_after(failures: int, first_s: float = FIRST_PAUSE_S) -> float:
    """Seconds until the next attempt: each failure doubles them, up to an hour."""
    doubled = min(failures - 1, 20)  # more would be longer than an hour in any case
    return min(first_s * 2.0**doubled, LONGEST_PAUSE_S)

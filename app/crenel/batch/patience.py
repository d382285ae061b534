"""Waits for stores that cannot be reached, instead of failing."""

import threading
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TypeVar

from crenel.archive.archive_settings import ArchiveSettings
from crenel.archive.remote_store import RemoteStore, Span, open_store
from crenel.archive.store_errors import StoreError, StorePurpose
from crenel.errors import OperationError
from crenel.messages.message import Text, join, message

GIVE_UP_S = 3600.0
"""A scheduler or a store that does not answer for so long is given up."""
FIRST_PAUSE_S, LONGEST_PAUSE_S = 1.0, 30.0
"""After a store that cannot be reached; each further time doubles it."""
AWAY = "archive-away"

T = TypeVar("T")


class Patience:
    """The growing pauses after which stores are tried again, for all that need them; thread-safe.

    Args:
        say: called once when the waiting begins, and once when it ends.
        give_up_s: stores that do not answer for so long are given up.
    """

    def __init__(
        self, say: Callable[[Text], None] = lambda text: None, give_up_s: float = GIVE_UP_S
    ) -> None:
        self._say, self._give_up_s = say, give_up_s
        self._lock = threading.Lock()
        self._ended = threading.Event()
        self._pause_s = 0.0
        self._away_since_s: float | None = None
        self.next_s = 0.0
        """When stores are tried again, on the monotonic clock."""

    def note_away(self, error: OperationError) -> None:
        """Called with each failure; raises it if stores have been away for too long."""
        with self._lock:
            now_s = time.monotonic()
            if self._away_since_s is None:
                self._away_since_s = now_s
                why = join([error.what, str(error.why).rstrip(".")], ": ")
                self._say(message("batch-store-away", why=why))
            elif now_s - self._away_since_s > self._give_up_s:
                raise error
            if now_s >= self.next_s:  # those that were under way fail together
                self._pause_s = min(max(2 * self._pause_s, FIRST_PAUSE_S), LONGEST_PAUSE_S)
                self.next_s = now_s + self._pause_s

    def note_back(self) -> None:
        """Called with each success."""
        with self._lock:
            if self._away_since_s is not None:
                self._say(message("batch-store-back"))
            self._away_since_s, self._pause_s, self.next_s = None, 0.0, 0.0

    def end(self) -> None:
        """Nothing waits any more: what cannot be reached fails at once."""
        self._ended.set()

    def wait_for(self, call: Callable[[], T]) -> T:
        """What a call to a store returns, as soon as that can be reached.

        Raises:
            OperationError: the call failed for another reason, or for too long.
        """
        failed = False
        while True:
            try:
                found = call()
            except StoreError as error:
                passes = error.code == AWAY and not isinstance(error.__cause__, ValueError)
                if self._ended.is_set() or not passes:  # a wrong address does not become right
                    raise
                failed = True
                self.note_away(error)
                self._ended.wait(max(self.next_s - time.monotonic(), 0.0))
            else:
                if failed:  # successes elsewhere do not end the waiting
                    self.note_back()
                return found


class PatientStore:
    """A store whose calls wait until it can be reached, except those that pass a file in pieces."""

    def __init__(self, store: RemoteStore, patience: Patience) -> None:
        self._store, self._patience = store, patience

    def write(self, name: str, pieces: Iterable[bytes], size: int) -> None:
        if isinstance(pieces, Sequence):  # others cannot be taken once more
            self._patience.wait_for(lambda: self._store.write(name, pieces, size))
        else:
            self._store.write(name, pieces, size)

    def read(self, name: str) -> Iterator[bytes]:
        return self._store.read(name)

    def read_start(self, name: str, count: int) -> bytes:
        return self._patience.wait_for(lambda: self._store.read_start(name, count))

    def read_spans(self, name: str, spans: Sequence[Span]) -> list[bytes]:
        return self._patience.wait_for(lambda: self._store.read_spans(name, spans))

    def size(self, name: str) -> int | None:
        return self._patience.wait_for(lambda: self._store.size(name))

    def names(self, folder: str) -> list[str]:
        return self._patience.wait_for(lambda: self._store.names(folder))

    def sizes(self, folder: str) -> dict[str, int]:
        return self._patience.wait_for(lambda: self._store.sizes(folder))

    def remove(self, name: str) -> None:
        self._patience.wait_for(lambda: self._store.remove(name))


def open_patiently(
    settings: ArchiveSettings, purpose: StorePurpose, patience: Patience | None
) -> RemoteStore:
    """The store of the settings, which waits if there is a patience."""
    store = open_store(settings, purpose)
    return store if patience is None else PatientStore(store, patience)

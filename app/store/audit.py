"""Who did what: an append-only log."""

import logging
import threading
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import islice
from sqlite3 import Row

from app.errors import OperationError
from app.store.database import NOT_SAVED, Database
from app.timestamps import utc_now

log = logging.getLogger(__name__)

Translate = Callable[[str], str]
LONGEST = 200
MOST_WAITING = 1000
ALL = -1
"""As SQLite has no limit."""


@dataclass(frozen=True, slots=True)
class AuditEntry:
    """One act, done or refused."""

    number: int
    at: str
    who: str
    """An account's name, or empty where nobody had signed in."""
    address: str
    """Of the browser."""
    act: str
    outcome: str
    """``done``, or why not."""


class AuditLog:
    """Rows stay as they were written. Those that a full disk does not take wait in memory,
    so that it keeps nobody from signing in or from Stop; a start loses them.
    """

    def __init__(self, database: Database) -> None:
        self._database = database
        self._lock = threading.Lock()
        self._waiting: deque[tuple[str, ...]] = deque(maxlen=MOST_WAITING)

    def note(self, who: str, address: str, act: str, outcome: str = "done") -> None:
        """Appends an entry."""
        with self._lock:
            self._waiting.append((utc_now(), who, address, act[:LONGEST], outcome[:LONGEST]))
            try:
                with self._database.transaction() as connection:
                    connection.executemany(
                        "INSERT INTO audit (at, who, address, act, outcome) VALUES (?, ?, ?, ?, ?)",
                        self._waiting,
                    )
            except OperationError as refusal:
                if refusal.code != NOT_SAVED:
                    raise
                log.warning("not in the audit log yet: %s: %s", act[:LONGEST], refusal.why)
            else:
                self._waiting.clear()

    def newest(self, count: int, words: str = "", say: Translate = str) -> list[AuditEntry]:
        """The last entries that have all the words, newest first.

        Args:
            say: what is written into another language; the words may be of that, too.
        """
        wanted = words.lower().split()
        rows = self._database.read(
            "SELECT * FROM audit ORDER BY number DESC LIMIT ?", ALL if wanted else count
        )
        found = (one for one in map(_entry, rows) if not wanted or _has(one, wanted, say))
        return list(islice(found, count))


def _has(entry: AuditEntry, wanted: Sequence[str], say: Translate) -> bool:
    """Whether all the words, in small letters, stand in an entry."""
    told = (entry.at, entry.who, entry.address, entry.act, entry.outcome)
    line = " ".join((*told, say(entry.act), say(entry.outcome))).lower()
    return all(word in line for word in wanted)


def _entry(row: Row) -> AuditEntry:
    return AuditEntry(
        row["number"], row["at"], row["who"], row["address"], row["act"], row["outcome"]
    )

"""The audit log: an append-only record of actions."""

import logging
import threading
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import islice
from sqlite3 import Row

from crenel.errors import OperationError
from crenel.messages.catalogue import Render
from crenel.messages.message import Text
from crenel.messages.stored import decode_text, encode_data
from crenel.store.database import NOT_SAVED, Database
from crenel.timestamps import utc_now

log = logging.getLogger(__name__)

INSERT = (
    "INSERT INTO audit (at, who, address, act, outcome, act_message, outcome_message)"
    " VALUES (?, ?, ?, ?, ?, ?, ?)"
)
LONGEST = 200
MOST_WAITING = 1000
ALL = -1
"""SQLite's value for no limit."""


@dataclass(frozen=True, slots=True)
class AuditEntry:
    """One action, done or refused."""

    number: int
    at: str
    who: str
    """Name of an account, or empty if nobody had signed in."""
    address: str
    """The address of the browser."""
    act: Text
    outcome: Text
    """``done``, or the reason why not."""


class AuditLog:
    """Rows are never changed. Rows that a full disk does not accept wait in memory, so that signing
    in and Stop keep working; a restart loses them."""

    def __init__(self, database: Database) -> None:
        self._database = database
        self._lock = threading.Lock()
        self._waiting: deque[tuple[str | None, ...]] = deque(maxlen=MOST_WAITING)

    def note(self, who: str, address: str, act: Text, outcome: Text = "done") -> None:
        """Appends an entry."""
        english = str(act)[:LONGEST], str(outcome)[:LONGEST]
        data = encode_data(act), encode_data(outcome)
        with self._lock:
            self._waiting.append(tuple(map(_storable, (utc_now(), who, address, *english, *data))))
            try:
                with self._database.transaction() as connection:
                    connection.executemany(INSERT, self._waiting)
            except OperationError as error:
                if error.code != NOT_SAVED:
                    raise
                log.warning("not in the audit log yet: %s: %s", english[0], error.why)
            else:
                self._waiting.clear()

    def newest(self, count: int, words: str = "", render: Render = str) -> list[AuditEntry]:
        """The latest entries that contain all the words, newest first.

        Args:
            render: renders texts in another language, in which the words are also searched.
        """
        wanted = words.lower().split()
        rows = self._database.read(
            "SELECT * FROM audit ORDER BY number DESC LIMIT ?", ALL if wanted else count
        )
        found = (one for one in map(_entry, rows) if not wanted or _has(one, wanted, render))
        return list(islice(found, count))


def _storable(text: str | None) -> str | None:
    """The text with halves of characters escaped: one row must not hold up all others."""
    return None if text is None else text.encode("utf-8", "backslashreplace").decode()


def _has(entry: AuditEntry, wanted: Sequence[str], render: Render) -> bool:
    """Whether an entry contains all the words, in lower case."""
    texts = (entry.act, entry.outcome)
    names = (entry.at, entry.who, entry.address)
    line = " ".join((*names, *map(str, texts), *map(render, texts))).lower()
    return all(word in line for word in wanted)


def _entry(row: Row) -> AuditEntry:
    return AuditEntry(
        row["number"],
        row["at"],
        row["who"],
        row["address"],
        decode_text(row["act"], row["act_message"]),
        decode_text(row["outcome"], row["outcome_message"]),
    )

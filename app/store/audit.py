"""Who did what: an append-only log."""

from collections.abc import Callable
from dataclasses import dataclass
from sqlite3 import Row

from app.files.moments import utc_now
from app.store.database import Database

Say = Callable[[str], str]
LONGEST = 200
HAS_WORD = "instr(line,lower(?))"
ALL = (
    "SELECT *, lower(at || ' ' || who || ' ' || address || ' ' || act || ' ' || outcome) AS line"
    " FROM audit"
)


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
    """Rows stay as they were written."""

    def __init__(self, database: Database) -> None:
        self._database = database

    def note(self, who: str, address: str, act: str, outcome: str = "done") -> None:
        """Appends an entry."""
        with self._database.writing() as connection:
            connection.execute(
                "INSERT INTO audit (at, who, address, act, outcome) VALUES (?, ?, ?, ?, ?)",
                (utc_now(), who, address, act[:LONGEST], outcome[:LONGEST]),
            )

    def newest(self, count: int, words: str = "", say: Say | None = None) -> list[AuditEntry]:
        """The last entries that have all the words, newest first.

        Args:
            say: what is written into another language; the words may be of that, too.
        """
        sought = words.split()
        if say and sought:
            return self._as_said(count, sought, say)
        having = " AND ".join([HAS_WORD] * len(sought)) or "TRUE"
        query = f"SELECT * FROM ({ALL}) WHERE {having} ORDER BY number DESC LIMIT ?"
        return [_entry(row) for row in self._database.read(query, *sought, count)]

    def _as_said(self, count: int, sought: list[str], say: Say) -> list[AuditEntry]:
        wanted, found = [word.lower() for word in sought], list[AuditEntry]()
        for row in self._database.read(f"{ALL} ORDER BY number DESC"):
            line = f"{row['line']} {say(row['act'])} {say(row['outcome'])}".lower()
            if all(word in line for word in wanted):
                found.append(_entry(row))
                if len(found) == count:
                    break
        return found


def _entry(row: Row) -> AuditEntry:
    return AuditEntry(
        row["number"], row["at"], row["who"], row["address"], row["act"], row["outcome"]
    )

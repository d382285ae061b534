"""Who did what: an append-only log."""

from dataclasses import dataclass

from app.files.moments import utc_now
from app.store.database import Database

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

    def newest(self, count: int, words: str = "") -> list[AuditEntry]:
        """The last entries that have all the words, newest first."""
        sought = words.split()
        having = " AND ".join([HAS_WORD] * len(sought)) or "TRUE"
        query = f"SELECT * FROM ({ALL}) WHERE {having} ORDER BY number DESC LIMIT ?"
        rows = self._database.read(query, *sought, count)
        return [
            AuditEntry(
                row["number"], row["at"], row["who"], row["address"], row["act"], row["outcome"]
            )
            for row in rows
        ]

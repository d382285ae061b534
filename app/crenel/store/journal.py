"""Sessions and their append-only journal."""

import json
import sqlite3
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.store.database import Database
from crenel.timestamps import utc_now

NOT_READABLE = "not-readable"
ROWS = "SELECT number, session_id, at, kind, payload FROM journal"


@dataclass(frozen=True, slots=True)
class SessionRecord:
    """One guided session."""

    id: str
    kind: str
    started_at: str
    ended_at: str | None


@dataclass(frozen=True, slots=True)
class JournalRow:
    """One event of a session; never changed, never deleted."""

    number: int
    """Increases over all sessions of the station."""
    session_id: str
    at: str
    kind: str
    payload: Mapping[str, object]


Check = Callable[[JournalRow], None]
"""Receives a row before it is committed; an exception undoes the row."""


def accept_any(row: JournalRow) -> None:
    """Accepts any row."""


class JournalStore:
    """The events of each guided session, in order."""

    def __init__(self, database: Database) -> None:
        self._database = database

    def begin_session(self, session_id: str, kind: str) -> SessionRecord:
        """Opens a session; its rows are added with ``append``."""
        record = SessionRecord(session_id, kind, utc_now(), None)
        with self._database.transaction() as connection:
            connection.execute(
                "INSERT INTO session (id, kind, started_at) VALUES (?, ?, ?)",
                (record.id, record.kind, record.started_at),
            )
        return record

    def end_session(self, session_id: str) -> None:
        """Marks a session as closed; idempotent."""
        with self._database.transaction() as connection:
            close_session(connection, session_id)

    def latest_session(self, kind: str) -> SessionRecord | None:
        """The newest session of a kind, open or closed."""
        rows = self._database.read(
            "SELECT id, kind, started_at, ended_at FROM session WHERE kind = ?"
            " ORDER BY rowid DESC LIMIT 1",
            kind,
        )
        return SessionRecord(*rows[0]) if rows else None

    def sessions(self) -> list[SessionRecord]:
        """All sessions, oldest first."""
        rows = self._database.read(
            "SELECT id, kind, started_at, ended_at FROM session ORDER BY rowid"
        )
        return [SessionRecord(*row) for row in rows]

    def append(
        self,
        session_id: str,
        kind: str,
        payload: Mapping[str, object],
        key: str | None = None,
        check: Check = accept_any,
    ) -> JournalRow:
        """Writes one row; it is on the disk when this returns.

        Raises:
            OperationError: it cannot be written as JSON.
            sqlite3.IntegrityError: the idempotency ``key`` was used before.
        """
        with self._database.transaction() as connection:
            return append_row(connection, session_id, kind, payload, key, check)

    def knows_key(self, key: str) -> bool:
        """Whether a command with this idempotency key has already been executed."""
        return bool(self._database.read("SELECT 1 FROM journal WHERE command_key = ?", key))

    def rows(self, session_id: str) -> Sequence[JournalRow]:
        """All rows of a session, oldest first.

        Raises:
            ValueError: one of them cannot be read.
        """
        return [
            _row(row)
            for row in self._database.read(
                f"{ROWS} WHERE session_id = ? ORDER BY number", session_id
            )
        ]

    def history(self, session_kind: str, kind: str) -> Sequence[JournalRow]:
        """The readable rows of one kind in all sessions of a kind, oldest first."""
        return self._rows_of_kind("ORDER BY number", session_kind, kind)

    def latest(self, session_kind: str, kind: str) -> JournalRow | None:
        """The newest readable row of one kind in all sessions of a kind."""
        # all rows are read only if the newest one is damaged
        for clause in ("ORDER BY number DESC LIMIT 1", "ORDER BY number DESC"):
            found = self._rows_of_kind(clause, session_kind, kind)
            if found:
                return found[0]
        return None

    def _rows_of_kind(self, clause: str, session_kind: str, kind: str) -> list[JournalRow]:
        return _readable(
            self._database.read(
                f"{ROWS} WHERE session_id IN (SELECT id FROM session WHERE kind = ?)"
                f" AND kind = ? {clause}",
                session_kind,
                kind,
            )
        )

    def newest(self, count: int) -> Sequence[JournalRow]:
        """The last readable rows of all sessions, oldest first."""
        rows = self._database.read(f"{ROWS} ORDER BY number DESC LIMIT ?", count)
        return _readable(rows[::-1])

    def last_number(self) -> int:
        """Number of the newest row of all sessions; 0 before the first."""
        return int(self._database.read("SELECT COALESCE(MAX(number), 0) FROM journal")[0][0])


def _row(row: sqlite3.Row) -> JournalRow:
    """Raises ``ValueError`` for a row that is not a JSON object."""
    try:
        payload = json.loads(row["payload"])
    except (ValueError, RecursionError):
        payload = None
    if not isinstance(payload, dict):
        raise ValueError(f"row {row['number']} is no JSON object")
    return JournalRow(row["number"], row["session_id"], row["at"], row["kind"], payload)


def _readable(rows: Sequence[sqlite3.Row]) -> list[JournalRow]:
    found = []
    for row in rows:
        with suppress(ValueError):
            found.append(_row(row))
    return found


def close_session(connection: sqlite3.Connection, session_id: str) -> None:
    """Marks a session as closed, within a transaction that the caller has open; idempotent."""
    connection.execute(
        "UPDATE session SET ended_at = ? WHERE id = ? AND ended_at IS NULL",
        (utc_now(), session_id),
    )


def append_row(
    connection: sqlite3.Connection,
    session_id: str,
    kind: str,
    payload: Mapping[str, object],
    key: str | None,
    check: Check,
) -> JournalRow:
    """Appends within an open transaction of the caller, which ends if ``check`` raises."""
    at = utc_now()
    try:
        text = json.dumps(payload, allow_nan=False)
    except (TypeError, ValueError) as error:
        raise OperationError(
            NOT_READABLE, message("not-saved"), message("no-json", error=error)
        ) from error
    cursor = connection.execute(
        "INSERT INTO journal (session_id, at, kind, payload, command_key) VALUES (?, ?, ?, ?, ?)",
        (session_id, at, kind, text, key),
    )
    assert cursor.lastrowid is not None
    row = JournalRow(cursor.lastrowid, session_id, at, kind, json.loads(text))
    check(row)
    return row

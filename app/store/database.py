"""The station's database: one SQLite file in the data folder.

Every commit is on the disk before the call returns (WAL with full synchronisation),
so that a killed server, or a mains failure, loses nothing that was acknowledged.
"""

import sqlite3
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from app.metrology.refusal import Refusal

FIRST = """
CREATE TABLE session (
    id TEXT PRIMARY KEY,
    kind TEXT NOT NULL,
    started_at TEXT NOT NULL,
    ended_at TEXT
) STRICT;

CREATE TABLE journal (
    number INTEGER PRIMARY KEY AUTOINCREMENT,
    session_id TEXT NOT NULL REFERENCES session (id),
    at TEXT NOT NULL,
    kind TEXT NOT NULL,
    payload TEXT NOT NULL,
    command_key TEXT UNIQUE
) STRICT;
CREATE INDEX journal_of_a_session ON journal (session_id, number);
CREATE TRIGGER journal_rows_stay BEFORE DELETE ON journal
    BEGIN SELECT RAISE(ABORT, 'the journal is append-only'); END;
CREATE TRIGGER journal_rows_keep BEFORE UPDATE ON journal
    BEGIN SELECT RAISE(ABORT, 'the journal is append-only'); END;

CREATE TABLE calibration (
    id TEXT PRIMARY KEY,
    session_id TEXT NOT NULL REFERENCES session (id),
    name TEXT NOT NULL,
    file TEXT NOT NULL,
    accepted_at TEXT NOT NULL,
    figures TEXT NOT NULL,
    active INTEGER NOT NULL CHECK (active IN (0, 1))
) STRICT;
CREATE UNIQUE INDEX one_active_calibration ON calibration (active) WHERE active = 1;

CREATE TABLE scan (
    id TEXT PRIMARY KEY,
    name TEXT NOT NULL,
    folder TEXT NOT NULL,
    started_at TEXT NOT NULL,
    points INTEGER NOT NULL,
    frames INTEGER NOT NULL,
    seconds REAL NOT NULL,
    calibration_id TEXT NOT NULL
) STRICT;
"""
ACCESS = """
CREATE TABLE account (
    name TEXT PRIMARY KEY COLLATE NOCASE,
    role TEXT NOT NULL CHECK (role IN ('viewer', 'operator', 'admin')),
    password TEXT NOT NULL,
    made_at TEXT NOT NULL
) STRICT;

CREATE TABLE sign_in (
    token TEXT PRIMARY KEY,
    account TEXT NOT NULL COLLATE NOCASE REFERENCES account (name) ON DELETE CASCADE,
    device TEXT NOT NULL,
    begun_at TEXT NOT NULL,
    seen_at TEXT NOT NULL
) STRICT;

CREATE TABLE wall_link (
    id TEXT PRIMARY KEY,
    token TEXT NOT NULL UNIQUE,
    name TEXT NOT NULL,
    made_by TEXT NOT NULL,
    made_at TEXT NOT NULL
) STRICT;

CREATE TABLE audit (
    number INTEGER PRIMARY KEY AUTOINCREMENT,
    at TEXT NOT NULL,
    who TEXT NOT NULL,
    address TEXT NOT NULL,
    act TEXT NOT NULL,
    outcome TEXT NOT NULL
) STRICT;
CREATE TRIGGER audit_rows_stay BEFORE DELETE ON audit
    BEGIN SELECT RAISE(ABORT, 'the audit log is append-only'); END;
CREATE TRIGGER audit_rows_keep BEFORE UPDATE ON audit
    BEGIN SELECT RAISE(ABORT, 'the audit log is append-only'); END;
"""
SUPERVISION = """
CREATE TABLE scraper (
    id TEXT PRIMARY KEY,
    token TEXT NOT NULL UNIQUE,
    name TEXT NOT NULL,
    made_by TEXT NOT NULL,
    made_at TEXT NOT NULL
) STRICT;
"""
VERIFICATIONS = """
CREATE TABLE verification (
    id TEXT PRIMARY KEY REFERENCES session (id),
    calibration_id TEXT NOT NULL REFERENCES calibration (id),
    folder TEXT NOT NULL,
    accepted_at TEXT NOT NULL,
    figures TEXT NOT NULL
) STRICT;
CREATE INDEX verification_of_a_calibration ON verification (calibration_id, accepted_at);

CREATE TABLE temperature (
    number INTEGER PRIMARY KEY AUTOINCREMENT,
    at TEXT NOT NULL,
    celsius REAL NOT NULL,
    source TEXT NOT NULL
) STRICT;
CREATE INDEX temperature_in_time ON temperature (at);
"""
KNOWN_BROWSERS = """
CREATE TABLE known_browser (
    token TEXT NOT NULL,
    account TEXT NOT NULL COLLATE NOCASE REFERENCES account (name) ON DELETE CASCADE,
    made_at TEXT NOT NULL,
    PRIMARY KEY (token, account)
) STRICT;
"""
SCHEMAS = (FIRST, ACCESS, SUPERVISION, VERIFICATIONS, KNOWN_BROWSERS)
"""What each version of the database adds to the one before."""
SCHEMA_VERSION = len(SCHEMAS)
NOT_KEPT = "not-kept"


class Database:
    """A connection that threads share, one at a time.

    Raises:
        Refusal: ``database-newer`` for a file that a later version of the program
            wrote, ``database-unreadable`` for one that is not a database.
    """

    def __init__(self, path: Path) -> None:
        self._path = path.absolute()
        self._lock = threading.RLock()
        try:
            self._path.touch(mode=0o600)
            self._path.chmod(0o600)  # passwords' hashes are nobody else's; its journals follow it
            self._connection = sqlite3.connect(path, check_same_thread=False, isolation_level=None)
        except (OSError, sqlite3.OperationalError) as error:
            raise _unreadable(path, error) from error
        try:
            self._connection.row_factory = sqlite3.Row
            self._connection.execute("PRAGMA journal_mode = WAL")
            self._connection.execute("PRAGMA synchronous = FULL")
            self._connection.execute("PRAGMA foreign_keys = ON")
            self._prepare(path)
        except sqlite3.DatabaseError as error:
            self._connection.close()
            raise _unreadable(path, error) from error
        except Refusal:
            self._connection.close()
            raise

    def _prepare(self, path: Path) -> None:
        version = int(self._connection.execute("PRAGMA user_version").fetchone()[0])
        tables = self._connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")
        names = {row["name"] for row in tables}
        if names and (version == 0 or "journal" not in names):
            raise Refusal(
                "database-foreign",
                f"{path} is another program's database",
                remedy="Give the station a data folder of its own with --data",
            )
        if version > SCHEMA_VERSION:
            raise Refusal(
                "database-newer",
                f"{path} was written by a later version of Crenel (schema {version}, "
                f"this one knows {SCHEMA_VERSION})",
                remedy="Install that version or a later one",
            )
        if version < SCHEMA_VERSION:
            added = " ".join(SCHEMAS[version:])
            self._connection.executescript(
                f"BEGIN; {added} PRAGMA user_version = {SCHEMA_VERSION}; COMMIT;"
            )

    @contextmanager
    def writing(self) -> Iterator[sqlite3.Connection]:
        """One transaction: all of it is kept, or on an exception nothing.

        Raises:
            Refusal: ``not-kept``, where the disk does not take it.
        """
        with self._lock:
            try:
                self._connection.execute("BEGIN IMMEDIATE")
                yield self._connection
                self._connection.execute("COMMIT")
            except sqlite3.OperationalError as error:
                self._undo()
                raise _not_kept(error) from error
            except BaseException:
                self._undo()
                raise

    def _undo(self) -> None:
        if self._connection.in_transaction:  # SQLite may have undone it by itself
            self._connection.execute("ROLLBACK")

    def read(self, query: str, *values: str | int | float | None) -> list[sqlite3.Row]:
        """All rows of a query."""
        with self._lock:
            return self._connection.execute(query, values).fetchall()

    def check(self) -> str:
        """What is wrong with the file; empty where nothing is. On a connection of its own."""
        try:
            looking = sqlite3.connect(f"{self._path.as_uri()}?mode=ro", uri=True)
            try:
                found = str(looking.execute("PRAGMA quick_check(1)").fetchone()[0])
            finally:
                looking.close()
        except sqlite3.DatabaseError as error:
            found = str(error)
        return "" if found == "ok" else found

    def close(self) -> None:
        with self._lock:
            self._connection.close()


def _unreadable(path: Path, error: Exception) -> Refusal:
    return Refusal(
        "database-unreadable",
        f"{path} cannot be read as a station's database",
        str(getattr(error, "strerror", None) or error),
        "Put the last backup in its place, or move it away to begin anew",
    )


def _not_kept(error: sqlite3.OperationalError) -> Refusal:
    if error.sqlite_errorcode == sqlite3.SQLITE_FULL:
        why, remedy = "the station's disk is full", "Free some space, then do it again"
    else:
        why, remedy = f"the database cannot be written: {error}", "Look at the station's disk"
    return Refusal(NOT_KEPT, "This was not kept", why, remedy)

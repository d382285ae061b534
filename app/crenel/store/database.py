"""The station's database: one SQLite file in the data folder.

Every commit is on the disk before the call returns (WAL with full synchronisation), so that a
killed server or a power failure loses nothing that was acknowledged.
"""

import errno
import shutil
import sqlite3
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.io_errors import error_from_os
from crenel.formats.open_file import check_ordinary
from crenel.messages.message import message
from crenel.store.schemas import SCHEMA_VERSION, SCHEMAS, current_columns, read_columns

NOT_SAVED = "not-kept"
NO_OBJECT = """
SELECT number FROM journal
WHERE CASE WHEN json_valid(payload) THEN json_type(payload) <> 'object' ELSE 1 END
ORDER BY number
"""
NO_FILE = (errno.EISDIR, errno.ENXIO, errno.ELOOP)
FULL = (errno.ENOSPC, errno.EDQUOT)
BESIDE = ("-wal", "-shm", "-journal")
"""Suffixes of SQLite's own files next to the database."""
LEAST_FREE_BYTES = 1 << 17
"""Space that SQLite needs next to its file while it is open, plus a reserve."""


class Database:
    """A connection that threads share; one uses it at a time.

    Raises:
        OperationError: ``database-newer`` for a file that a later version of the program
            wrote, ``database-unreadable`` for one that is not a database.
    """

    def __init__(self, path: Path) -> None:
        self._path = path.absolute()
        self._lock = threading.RLock()
        for file in (self._path, *(Path(f"{self._path}{end}") for end in BESIDE)):
            _check_file(file, file == self._path)
        try:
            self._path.touch(mode=0o600)
            self._path.chmod(0o600)  # only this user may read password hashes; the journals follow
            self._connection = sqlite3.connect(path, check_same_thread=False, isolation_level=None)
        except (OSError, sqlite3.OperationalError) as error:
            raise _open_error(path, error) from error
        try:
            self._connection.row_factory = sqlite3.Row
            self._connection.text_factory = _text
            self._connection.execute("PRAGMA journal_mode = WAL")
            self._connection.execute("PRAGMA synchronous = FULL")
            self._connection.execute("PRAGMA foreign_keys = ON")
            self._prepare(path)
        except sqlite3.DatabaseError as error:
            self._connection.close()
            raise _open_error(path, error) from error
        except OperationError:
            self._connection.close()
            raise

    def _prepare(self, path: Path) -> None:
        version = int(self._connection.execute("PRAGMA user_version").fetchone()[0])
        tables = self._connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")
        names = {row["name"] for row in tables}
        if names and (version == 0 or "journal" not in names):
            raise OperationError(
                "database-foreign",
                message("another-programs-database", path=path),
                remedy=message("give-station-data-folder-own"),
            )
        if version > SCHEMA_VERSION:
            raise OperationError(
                "database-newer",
                message(
                    "database-of-later-version",
                    path=path,
                    version=version,
                    known=SCHEMA_VERSION,
                ),
                remedy=message("install-version-later-one"),
            )
        if version < SCHEMA_VERSION:
            added = " ".join(SCHEMAS[version:])
            self._connection.executescript(
                f"BEGIN; {added} PRAGMA user_version = {SCHEMA_VERSION}; COMMIT;"
            )
        missing = sorted(current_columns() - read_columns(self._connection))
        if missing:
            table, column = missing[0]
            raise OperationError(
                "database-unreadable",
                message("is-no-station-database", path=display_path(path)),
                message("table-lacks-column", table=table, column=column),
                message("restore-backup-or-start-over"),
            )

    @contextmanager
    def transaction(self) -> Iterator[sqlite3.Connection]:
        """One transaction: everything is stored, or on an exception nothing.

        Raises:
            OperationError: ``not-kept``, if it cannot be written to the disk.
        """
        with self._lock:
            try:
                self._connection.execute("BEGIN IMMEDIATE")
                yield self._connection
                self._connection.execute("COMMIT")
            except sqlite3.OperationalError as error:
                self._undo()
                raise _not_saved_error(error) from error
            except sqlite3.IntegrityError:
                self._undo()
                raise
            except sqlite3.DatabaseError as error:
                self._undo()
                raise _open_error(self._path, error) from error
            except BaseException:
                self._undo()
                raise

    def _undo(self) -> None:
        if self._connection.in_transaction:  # SQLite may have rolled back already
            self._connection.execute("ROLLBACK")

    def read(self, query: str, *values: str | int | float | None) -> list[sqlite3.Row]:
        """All rows of a query.

        Raises:
            OperationError: ``database-unreadable``, if a page of the file is damaged or a table is
                missing; or the error of its disk.
        """
        with self._lock:
            try:
                return self._connection.execute(query, values).fetchall()
            except sqlite3.DatabaseError as error:
                raise _open_error(self._path, error) from error

    def check(self) -> str:
        """Problems of the file; empty if there are none. Uses its own connection."""
        try:
            found = str(self._query("PRAGMA quick_check(1)")[0][0])
        except sqlite3.DatabaseError as error:
            found = str(error)
        return "" if found == "ok" else found

    def unreadable_rows(self) -> list[int]:
        """Numbers of the journal rows that are not JSON objects. Uses its own connection."""
        try:
            return [int(row[0]) for row in self._query(NO_OBJECT)]
        except sqlite3.DatabaseError:  # ``check`` reports that the file is damaged
            return []

    def _query(self, query: str) -> list[tuple[Any, ...]]:
        looking = sqlite3.connect(f"{self._path.as_uri()}?mode=ro", uri=True)
        try:
            return looking.execute(query).fetchall()
        finally:
            looking.close()

    def close(self) -> None:
        with self._lock:
            self._connection.close()


def _text(raw: bytes) -> str:
    """A text for display, even if a damaged page has made it invalid UTF-8."""
    return raw.decode("utf-8", "replace")


def _check_file(path: Path, is_database: bool) -> None:
    """Raises ``OperationError`` if a database file is not a regular file."""
    try:
        if path.is_symlink() and not is_database:
            path.stat()  # SQLite creates no file if a link points to nothing
        check_ordinary(path)
    except OSError as error:
        if error.errno not in NO_FILE and not path.is_symlink():
            raise _open_error(path, error) from error
        if is_database:
            what = message("is-no-station-database", path=display_path(path))
            remedy = message("restore-backup-or-start-over")
        else:
            what = message("not-usable-next-to-database", path=display_path(path))
            remedy = message("move-away-start-again")
        why = error_from_os(error, path).why
        raise OperationError("database-unreadable", what, why, remedy) from error


def _open_error(path: Path, error: Exception) -> OperationError:
    """Why a database cannot be opened: distinguishes its disk from its content."""
    code = (getattr(error, "sqlite_errorcode", None) or 0) & 0xFF
    if _is_full(path.parent, error, code):
        return OperationError(
            "disk-full",
            message("disk-of-folder-full", folder=display_path(path.parent)),
            message("database-not-damaged"),
            message("free-some-space-start-again"),
        )
    if code == sqlite3.SQLITE_IOERR or getattr(error, "errno", None) == errno.EIO:
        return OperationError(
            "disk-failing",
            message("disk-fails", folder=display_path(path.parent)),
            str(error),
            message("check-system-log-and-disk"),
        )
    forbidden = (sqlite3.SQLITE_CANTOPEN, sqlite3.SQLITE_READONLY, sqlite3.SQLITE_PERM)
    if code in forbidden or isinstance(error, OSError):
        return OperationError(
            "database-forbidden",
            message("cannot-be-opened-for-writing", path=display_path(path)),
            str(getattr(error, "strerror", None) or error),
            message("check-owner-and-permissions"),
        )
    return OperationError(
        "database-unreadable",
        message("is-no-station-database", path=display_path(path)),
        str(getattr(error, "strerror", None) or error),
        message("restore-backup-or-start-over"),
    )


def _is_full(folder: Path, error: Exception, code: int) -> bool:
    """For a full disk, SQLite reports sometimes a full disk, sometimes a read or write error."""
    if code == sqlite3.SQLITE_FULL or getattr(error, "errno", None) in FULL:
        return True
    if code not in (sqlite3.SQLITE_IOERR, sqlite3.SQLITE_CANTOPEN):
        return False
    try:
        return shutil.disk_usage(folder).free < LEAST_FREE_BYTES
    except OSError:
        return False


def _not_saved_error(error: sqlite3.OperationalError) -> OperationError:
    if error.sqlite_errorcode == sqlite3.SQLITE_FULL:
        why, remedy = message("stations-disk-full"), message("free-some-space-then-do-again")
    else:
        why, remedy = (
            message("database-cannot-be-written", error=error),
            message("check-station-disk"),
        )
    return OperationError(NOT_SAVED, message("not-saved"), why, remedy)

"""Opens the catalogue's database, SQLite or PostgreSQL, and brings it to the present version."""

import sqlite3
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from crenel.errors import OperationError
from crenel.fleet.catalogue.libraries import check_libraries
from crenel.messages.message import Text, message

if TYPE_CHECKING:
    from alembic.config import Config
    from sqlalchemy import Connection, Engine

MIGRATIONS = Path(__file__).parent / "migrations"
FIRST_REVISION, LAST_REVISION = "0001", "0003"
WRITERS_LOCK = 0x6372656E
"""PostgreSQL's advisory lock of whoever writes."""
FORBIDDEN_STATES = ("42501", "3F000")
"""PostgreSQL's states of a missing right, and of no schema in which to create tables."""
WAIT_S = 10
PAUSE_S = 0.01


class CatalogueError(OperationError):
    """The database of the catalogue cannot be used now; it is tried again later."""


def open_engine(url: str) -> "Engine":
    """Connects to a catalogue and applies the migrations that it lacks.

    Args:
        url: ``sqlite:///path``, or ``postgresql://user:password@host/name``.

    Raises:
        CatalogueError: it cannot be reached.
        OperationError: a library is missing, the address is none, or a later version of the
            program made the catalogue.
    """
    engine = create_engine(url)
    try:
        with convert_database_errors(engine):
            _migrate(engine)
    except BaseException:
        engine.dispose()
        raise
    return engine


def create_engine(url: str) -> "Engine":
    """Prepares connections to a database; none is made yet.

    Raises:
        OperationError: a library is missing, or the address is none.
    """
    check_libraries()
    import sqlalchemy
    from sqlalchemy import event
    from sqlalchemy.exc import ArgumentError, NoSuchModuleError

    if url.startswith(("postgresql://", "postgres://")):
        url = f"postgresql+psycopg://{url.partition('://')[2]}"
    try:
        engine = sqlalchemy.create_engine(url, pool_pre_ping=True, **_options(url))
    except (ArgumentError, NoSuchModuleError, ImportError) as error:
        raise OperationError(
            "catalogue-address",
            message("catalogue-no-address", url=place_of(url)),
            str(error),
            message("catalogue-give-address"),
        ) from error
    if engine.dialect.name == "sqlite":
        if engine.url.database in (None, "", ":memory:"):
            raise OperationError(
                "catalogue-address",
                message("catalogue-no-address", url=url),
                message("catalogue-in-memory"),
                message("catalogue-give-address"),
            )
        event.listen(engine, "connect", _prepare_sqlite)
        event.listen(engine, "begin", _begin)
    return engine


def place_of(url: str) -> str:
    """An address in messages: without user and password."""
    scheme, separator, rest = url.partition("://")
    if not separator:
        return url
    return f"{scheme.partition('+')[0]}://{rest.rpartition('@')[2]}"


@contextmanager
def convert_database_errors(engine: "Engine") -> Iterator[None]:
    """Turns errors of the database into a ``CatalogueError``."""
    from sqlalchemy.exc import DBAPIError
    from sqlalchemy.exc import TimeoutError as PoolTimeoutError

    place = place_of(engine.url.render_as_string())
    try:
        yield
    except (DBAPIError, PoolTimeoutError) as error:
        cause = getattr(error, "orig", None) or error
        reason = str(cause).strip().partition("\n")[0]  # without statement and questions
        raise CatalogueError(
            "catalogue-away",
            message("catalogue-away", place=place),
            " ".join(reason.split())[:300],
            _remedy_for(cause),
        ) from error


def _remedy_for(cause: BaseException) -> Text:
    """What to do about an error of a driver, whatever language it is in."""
    connection = getattr(cause, "pgconn", None)  # of psycopg, where none was made
    if connection is not None and (connection.needs_password or connection.used_password):
        return message("catalogue-check-user")
    if getattr(cause, "sqlstate", None) in FORBIDDEN_STATES:
        return message("catalogue-let-user-own")
    if getattr(cause, "sqlite_errorcode", 0) & 0xFF in (
        sqlite3.SQLITE_CANTOPEN,
        sqlite3.SQLITE_READONLY,
    ):
        return message("catalogue-check-folder")
    return message("catalogue-tried-again")


@contextmanager
def write_transaction(engine: "Engine") -> "Iterator[Connection]":
    """A transaction of the only writer; another one waits."""
    from sqlalchemy import text

    with (
        convert_database_errors(engine),
        engine.connect().execution_options(writes=True) as connection,
        connection.begin(),
    ):
        if engine.dialect.name == "postgresql":
            connection.execute(text(f"SELECT pg_advisory_xact_lock({WRITERS_LOCK})"))
        yield connection


def upgrade(engine: "Engine", revision: str) -> None:
    """Applies the migrations up to a revision."""
    from alembic import command

    with write_transaction(engine) as connection:
        command.upgrade(_config(connection), revision)


def _options(url: str) -> dict[str, Any]:
    if url.startswith("sqlite"):
        return {"connect_args": {"timeout": WAIT_S}}
    return {"connect_args": {"connect_timeout": WAIT_S}}


def _config(connection: "Connection") -> "Config":
    from alembic.config import Config

    config = Config()
    config.set_main_option("script_location", str(MIGRATIONS).replace("%", "%%"))
    config.set_main_option("path_separator", "os")
    config.attributes["connection"] = connection
    return config


def _migrate(engine: "Engine") -> None:
    from alembic.runtime.migration import MigrationContext

    with engine.connect() as connection:
        present = MigrationContext.configure(connection).get_current_revision()
    if present == LAST_REVISION:
        return
    if present is not None and present > LAST_REVISION:
        raise OperationError(
            "catalogue-newer",
            message("catalogue-newer", place=place_of(engine.url.render_as_string())),
            remedy=message("install-version-later-one"),
        )
    upgrade(engine, LAST_REVISION)


def _prepare_sqlite(connection: sqlite3.Connection, record: object) -> None:
    """Transactions are begun by ``_begin``, so that migrations are within one, too."""
    connection.isolation_level = None
    _use_write_ahead_log(connection)
    connection.execute("PRAGMA synchronous = NORMAL")
    connection.execute("PRAGMA foreign_keys = ON")
    connection.execute("PRAGMA cache_size = -65536")


def _use_write_ahead_log(connection: sqlite3.Connection) -> None:
    """Waits while another connection does the same: SQLite's own timeout does not cover this."""
    end_s = time.monotonic() + WAIT_S
    while True:
        try:
            connection.execute("PRAGMA journal_mode = WAL")
        except sqlite3.OperationalError as error:
            if error.sqlite_errorcode != sqlite3.SQLITE_BUSY or time.monotonic() > end_s:
                raise
            time.sleep(PAUSE_S)
        else:
            return


def _begin(connection: "Connection") -> None:
    writes = connection.get_execution_options().get("writes", False)
    connection.exec_driver_sql("BEGIN IMMEDIATE" if writes else "BEGIN")

"""The catalogue of a fleet: opens, writes, and gives a connection to ``reading``."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from datetime import datetime
from typing import TYPE_CHECKING, Self

from crenel.fleet.catalogue.database import (
    convert_database_errors,
    open_engine,
    place_of,
    write_transaction,
)
from crenel.fleet.catalogue.entry import CatalogueEntry

if TYPE_CHECKING:
    from sqlalchemy import Connection


class FleetCatalogue:
    """What all stations recorded, with results, hashes and the state of the archive.

    Safe to use from several threads and processes: writers take turns. All methods raise
    ``CatalogueError`` while the database cannot be reached; nothing is stored by half.

    Args:
        url: ``sqlite:///path``, or ``postgresql://user:password@host/name``.

    Raises:
        CatalogueError: the database cannot be reached.
        OperationError: a library is missing, the address is none, or a later version of the
            program made the catalogue.
    """

    def __init__(self, url: str) -> None:
        self.place = place_of(url)
        """The address without user and password."""
        self._engine = open_engine(url)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def close(self) -> None:
        """Closes its connections; idempotent."""
        self._engine.dispose()

    @contextmanager
    def reading(self) -> "Iterator[Connection]":
        """A connection for the functions of ``reading``, on one state of the catalogue."""
        with convert_database_errors(self._engine), self._engine.connect() as connection:
            yield connection

    def add(self, entries: Sequence[CatalogueEntry]) -> int:
        """Stores entries, all or none; those that are there as they are change nothing.

        Returns:
            The number of records that are new or have another content.
        """
        # libraries that are missing were reported when it was opened
        from crenel.fleet.catalogue.writing import store_entries

        with write_transaction(self._engine) as connection:
            return store_entries(connection, entries)

    def note_collection(
        self, station: str, name: str, at: datetime | None, problem: str = ""
    ) -> None:
        """What became of an attempt to collect from a station; ``at``: everything is there."""
        from crenel.fleet.catalogue.writing import store_collection

        with write_transaction(self._engine) as connection:
            store_collection(connection, station, name, at, problem)

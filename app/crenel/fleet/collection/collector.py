"""Collects the records of all stations into the catalogue, also what was missed."""

import logging
from collections.abc import Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime

from crenel.errors import OperationError
from crenel.fleet.catalogue.catalogue import FleetCatalogue
from crenel.fleet.catalogue.database import CatalogueError
from crenel.fleet.catalogue.entry import CatalogueEntry
from crenel.fleet.catalogue.reading import list_contents
from crenel.fleet.collection.documents import read_entries
from crenel.fleet.collection.places import RecordPlace
from crenel.loop_states import note_progress
from crenel.messages.message import message

log = logging.getLogger(__name__)
AT_ONCE = 50
"""Records per transaction: an interruption costs no more than these."""


DAMAGED = "archive-differs"
"""The code of a copy in an archive that is not what its manifest says."""


class CollectionError(OperationError):
    """A station whose records were not all collected.

    Args:
        new: records that were stored nevertheless.
    """

    def __init__(self, new: int, error: OperationError) -> None:
        super().__init__(error.code, error.what, error.why, error.remedy)
        self.new = new


@dataclass(frozen=True)
class CollectedStation:
    """A station with the places of its records."""

    id: str
    """As in its topics."""
    name: str
    places: Sequence[RecordPlace]


@dataclass
class CollectionResult:
    """What one look at all stations brought."""

    new: int = 0
    problems: dict[str, OperationError] = field(default_factory=dict)
    """By station: why not everything was read."""


def collect(
    catalogue: FleetCatalogue, stations: Sequence[CollectedStation], complete: bool = False
) -> CollectionResult:
    """Looks for what the catalogue does not have yet. A place that is away does not stop the rest.

    Args:
        complete: also look at records that have been in their archive for long.

    Raises:
        CatalogueError: the catalogue cannot be used now. What was stored before stays, the rest
            is collected next time: the places keep their records.
    """
    result = CollectionResult()
    for station in stations:
        problem = ""
        try:
            result.new += _collect_station(catalogue, station, complete)
        except CollectionError as error:
            result.new += error.new
            result.problems[station.id] = error
            problem = error.line
        at = None if problem else datetime.now(UTC)
        catalogue.note_collection(station.id, station.name, at, problem)
    return result


def _collect_station(catalogue: FleetCatalogue, station: CollectedStation, complete: bool) -> int:
    """Returns how many records are new; raises the first problem when the rest is stored."""
    with catalogue.reading() as connection:
        known = list_contents(connection, station.id)
    new = 0
    waiting: list[CatalogueEntry] = []
    first: OperationError | None = None
    for place in station.places:
        try:
            for record in place.list_new(known, complete):
                note_progress()
                try:
                    with place.documents(record) as folder:
                        waiting += read_entries(station.id, record, folder, place.name)
                except OperationError as error:
                    if error.code != DAMAGED:  # the place itself
                        raise
                    first = first or error
                if len(waiting) >= AT_ONCE:
                    new += catalogue.add(waiting)
                    waiting = []
        except CatalogueError:
            raise
        except OperationError as error:
            first = first or error
        except Exception as error:  # of this place only
            log.exception("%s cannot be collected", place.name)
            why = type(error).__name__
            first = first or OperationError("failed", message("program-failed"), why)
    new += catalogue.add(waiting)
    if first is not None:
        raise CollectionError(new, first)
    return new

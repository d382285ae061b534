"""Chooses recordings of scans: by period, station and the calibration that they were taken with."""

from collections.abc import Iterator, Mapping, Sequence, Set
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from functools import partial
from io import BytesIO
from pathlib import Path

from crenel.archive.manifest import Kind
from crenel.archive.remote_store import RemoteStore
from crenel.archive.store_errors import DamagedCopyError
from crenel.batch.listed_scans import ListedScan
from crenel.batch.patience import Patience
from crenel.batch.period import ALWAYS, Period
from crenel.batch.places import Place, PlaceRecord, RecordFile
from crenel.errors import OperationError
from crenel.formats.open_file import open_file
from crenel.formats.recording.raw import MAGIC
from crenel.formats.recording.reader import (
    LARGEST_PREAMBLE,
    SCAN_CALIBRATION,
    SCAN_NAME,
    SCAN_STARTED,
    read_station_metadata,
)
from crenel.formats.recording.topics import sensor_values
from crenel.progress import Progress, no_progress
from crenel.timestamps import is_moment, moment_of_ns, parse_moment

RECORDING = "scan.mcap"
READERS = 16
"""Records that are looked at simultaneously: a store far away answers slowly."""
LONGEST = timedelta(days=2)
"""No scan takes longer."""


@dataclass(frozen=True)
class Selection:
    """Which records are worked on."""

    period: Period = ALWAYS
    stations: frozenset[str] = frozenset()
    """Empty: all."""
    taken_with: frozenset[str] = frozenset()
    """Ids of calibrations; empty: all."""
    records: frozenset[str] = frozenset()
    """Ids of scans; empty: all."""
    labels: frozenset[str] = frozenset()
    """The labels of the scans that are meant; empty: all."""

    def places(self, places: Sequence[Place]) -> list[Place]:
        """Those of the chosen stations."""
        return [one for one in places if not self.stations or one.station in self.stations]


@dataclass(frozen=True)
class ScanRecording:
    """The recording of a scan."""

    id: str
    file: RecordFile
    metadata: Mapping[str, str]
    """What the recording states of its station."""
    listed: ListedScan | None = None
    """What the station listed of it, where that is known."""

    @property
    def station(self) -> str:
        """The station that took it."""
        return self.file.place.station

    @property
    def started_at(self) -> datetime:
        """When it began; else when its file was completed."""
        started = self.metadata.get(SCAN_STARTED) or (self.listed.started_at if self.listed else "")
        return parse_moment(started) if is_moment(started) else completion_time(self.file)

    @property
    def calibration_ids(self) -> dict[str, str]:
        """The ids of the calibrations in use, by the sensor's name; empty for the only sensor."""
        stated = sensor_values(self.metadata, SCAN_CALIBRATION)
        if not any(stated.values()) and self.listed is not None and self.listed.calibration_id:
            return {"": self.listed.calibration_id}  # an earlier version recorded it
        return {name: one for name, one in stated.items() if name} or stated

    @property
    def label(self) -> str:
        """What the operator calls it; empty if that is not known."""
        return self.listed.name if self.listed else self.metadata.get(SCAN_NAME, "")


def completion_time(file: RecordFile) -> datetime:
    """When a file was last written."""
    return moment_of_ns(file.mtime_ns)


def find_records(
    place: Place,
    kind: Kind,
    progress: Progress = no_progress,
    patience: Patience | None = None,
    wanted: Set[str] = frozenset(),
) -> Iterator[tuple[PlaceRecord, RemoteStore]]:
    """All whole records of a kind, with the store that they are read from.

    Args:
        patience: with which it is waited for a store that cannot be reached.
        wanted: only records of these ids; empty: all.

    Raises:
        OperationError: the place cannot be read.
    """
    store = place.store(patience)
    ids = [one for one in place.ids(kind, store) if not wanted or one in wanted]
    with _readers("find-records", patience) as pool:
        for number, record in enumerate(pool.map(lambda one: place.record(kind, one, store), ids)):
            progress(number / len(ids), place.station)
            if record is not None:
                yield record, store


@contextmanager
def _readers(name: str, patience: Patience | None) -> Iterator[ThreadPoolExecutor]:
    """Threads that look at records; they wait for no store when this ends with an error."""
    with ThreadPoolExecutor(READERS, name) as pool:
        try:
            yield pool
        except BaseException:
            if patience is not None:
                patience.end()
            raise


def find_recordings(
    places: Sequence[Place],
    selection: Selection,
    progress: Progress = no_progress,
    patience: Patience | None = None,
) -> Iterator[ScanRecording]:
    """The chosen recordings of scans, station after station, in the order of their names.

    Args:
        patience: with which it is waited for stores that cannot be reached.

    Raises:
        OperationError: a place cannot be read, or a recording is none.
    """
    for place in selection.places(places):
        with _readers("find-recordings", patience) as pool:
            records = find_records(place, "scans", progress, patience, selection.records)
            listed = place.scan_list()
            read = partial(_read_if_chosen, selection=selection, listed=listed)
            for found in pool.map(read, records):
                if found is not None:
                    yield found


def _read_if_chosen(
    one: tuple[PlaceRecord, RemoteStore], selection: Selection, listed: Mapping[str, ListedScan]
) -> ScanRecording | None:
    record, store = one
    file = record.files.get(RECORDING)
    if file is None or not may_be_within(selection.period, file) or _is_written(file):
        return None
    start = BytesIO()
    with suppress(DamagedCopyError):  # who works on it says what is wrong
        start = BytesIO(store.read_start(file.name, LARGEST_PREAMBLE))
    metadata: dict[str, str] = {}
    with suppress(OperationError):
        metadata = read_station_metadata(Path(file.name), start)
    found = ScanRecording(record.id, file, metadata, listed.get(record.id) or record.listed)
    ids = set(found.calibration_ids.values())
    if selection.taken_with and not ids & selection.taken_with:
        return None
    if selection.labels and found.label not in selection.labels:
        return None
    return found if selection.period.contains(found.started_at) else None


def may_be_within(period: Period, file: RecordFile) -> bool:
    """Whether a recording that was completed then can have begun within the period."""
    at = completion_time(file)
    return at >= period.begin and (at < period.end or at - period.end < LONGEST)


def _is_written(file: RecordFile) -> bool:
    """Whether a scan in progress of a station writes it: it has no end yet, and is new."""
    if file.place.is_archive or datetime.now(UTC) - completion_time(file) > timedelta(hours=1):
        return False
    with suppress(OSError), open_file(Path(file.place.settings.url) / file.name) as opened:
        opened.seek(max(file.bytes - len(MAGIC), 0))
        return opened.read() != MAGIC
    return False

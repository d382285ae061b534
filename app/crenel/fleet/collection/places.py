"""Where records are collected from: the archive of a station, or its data folder."""

import logging
from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager, closing, contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Protocol

from crenel.archive.archive_settings import ArchiveSettings
from crenel.archive.manifest import ArchivedFile, Kind, Manifest, content_name
from crenel.archive.ownership import MARKER
from crenel.archive.pace import full_speed
from crenel.archive.planning import StationRecord
from crenel.archive.rebuilt_clouds import leave_cloud_out
from crenel.archive.records import KINDS, list_records, open_record_lists
from crenel.archive.remote_store import RemoteStore, open_store
from crenel.archive.store_errors import SourceError, store_error
from crenel.archive.transfer import download_file, hash_files, newest_manifest
from crenel.fleet.catalogue.reading import KnownContent
from crenel.fleet.collection.documents import DOCUMENTS, HEAD_BYTES, HEADS
from crenel.messages.message import message
from crenel.timestamps import moment_of_ns, parse_moment

log = logging.getLogger(__name__)
RECENT = timedelta(days=7)
"""In an archive, a record that has been there for longer is not looked at again: its name or its
content rarely changes then. A complete look finds those, too."""
LARGEST_BYTES = 16 << 20
"""The size of the largest document; a larger one is none of ours."""


@dataclass(frozen=True, slots=True)
class SourceRecord:
    """A record that the catalogue does not have as it is."""

    kind: Kind
    id: str
    content: str
    label: str | None
    """None where the place does not know its name."""
    changed_at: datetime
    """The newest change of its files."""
    current_at: datetime
    archived_at: datetime | None
    files: tuple[ArchivedFile, ...]
    calibration_id: str = ""
    """The calibration of a scan, where the place knows it: recordings of earlier versions do not
    state it."""
    points: int | None = None
    """The points of a scan, where the place knows them: an archive has no cloud."""


class RecordPlace(Protocol):
    """A place that offers finished records of one station."""

    @property
    def name(self) -> str:
        """The place in messages."""

    def list_new(
        self, known: Mapping[str, KnownContent], complete: bool = False
    ) -> Iterator[SourceRecord]:
        """The records that are not known as they are here.

        Raises:
            OperationError: the place cannot be read now.
        """

    def documents(self, record: SourceRecord) -> AbstractContextManager[Path]:
        """A folder with the documents of a record and the beginnings of its large files."""


class ArchivePlace:
    """The archive of a station."""

    def __init__(self, settings: ArchiveSettings, store: RemoteStore | None = None) -> None:
        self.name = settings.place
        self._store = store or open_store(settings, "records")

    def list_new(
        self, known: Mapping[str, KnownContent], complete: bool = False
    ) -> Iterator[SourceRecord]:
        if self._store.size(MARKER) is None:
            why = str(message("fleet-no-marker"))
            raise store_error("archive-missing", self.name, why, "records")
        now = datetime.now(UTC)
        for kind in KINDS:
            for record_id in self._store.names(kind):
                there = known.get(record_id)
                settled = there is not None and there.archived and now - there.current_at > RECENT
                if settled and not complete:
                    continue
                manifest = newest_manifest(self._store, kind, record_id)
                if manifest is not None and not _is_known(manifest, there):
                    yield _record_of(manifest)

    @contextmanager
    def documents(self, record: SourceRecord) -> Iterator[Path]:
        manifest_folder = f"{record.kind}/{record.id}/{record.content}"
        with TemporaryDirectory(prefix="crenel-fleet-") as folder:
            for file in record.files:
                name, target = f"{manifest_folder}/{file.path}", Path(folder) / file.path
                if file.path in DOCUMENTS and file.bytes <= LARGEST_BYTES:
                    download_file(file, name, target, self._store, full_speed())
                elif file.path in HEADS:
                    self._fetch_head(name, target)
            yield Path(folder)

    def _fetch_head(self, name: str, target: Path) -> None:
        left = HEAD_BYTES
        with target.open("wb") as writing, closing(self._store.read(name)) as pieces:  # type: ignore[type-var]
            for piece in pieces:
                writing.write(piece[:left])
                left -= len(piece)
                if left <= 0:
                    return


class FolderPlace:
    """The data folder of a station on this machine, which may be running."""

    def __init__(self, data: Path) -> None:
        self._data = data.absolute()
        self.name = str(self._data)

    def list_new(
        self, known: Mapping[str, KnownContent], complete: bool = False
    ) -> Iterator[SourceRecord]:
        began_at = datetime.now(UTC)
        with open_record_lists(self._data) as lists:
            records = list_records(self._data, lists, began_at)
        for record in records:
            if not record.finished or not record.stamps:
                continue
            there = known.get(record.id)
            if there is not None and not complete and _is_unchanged(record, there):
                continue
            try:
                yield self._describe(record, began_at)
            except SourceError as error:
                log.warning("%s is collected later: %s", record.id, error.line)

    @contextmanager
    def documents(self, record: SourceRecord) -> Iterator[Path]:
        yield self._data / record.kind / record.id

    def _describe(self, record: StationRecord, now: datetime) -> SourceRecord:
        """A record by the archive's hashes if it is archived as it is, else by its own."""
        note = record.note if record.is_archived else None
        files = note.files if note is not None else self._hash(record)
        return SourceRecord(
            record.kind,
            record.id,
            content_name(files),
            record.label,
            record.at,
            now,
            None if note is None else parse_moment(note.archived_at),
            files,
            record.calibration_id or "",
            record.points,
        )

    def _hash(self, record: StationRecord) -> tuple[ArchivedFile, ...]:
        """As the archive would have it."""
        return hash_files(leave_cloud_out(record, self._data, full_speed()), full_speed())


def _record_of(manifest: Manifest) -> SourceRecord:
    newest_ns = max((file.mtime_ns for file in manifest.files), default=0)
    archived_at = parse_moment(manifest.archived_at)
    return SourceRecord(
        manifest.kind,
        manifest.id,
        manifest.content,
        manifest.label,
        moment_of_ns(newest_ns),
        archived_at,
        archived_at,
        manifest.files,
        manifest.calibration_id or "",
        manifest.points,
    )


def _is_known(manifest: Manifest, there: KnownContent | None) -> bool:
    return (
        there is not None
        and there.archived
        and there.content == manifest.content
        and manifest.label in (None, there.label)
    )


def _is_unchanged(record: StationRecord, there: KnownContent) -> bool:
    """Whether a record on a station's disk is what was collected, without reading its files."""
    return (
        record.at < there.current_at
        and there.size_bytes in (record.size_bytes, record.bytes_without_cloud)
        and record.label in (None, there.label)
        and (there.archived or not record.is_archived)
    )

"""The archive of one station: copies what is finished, and removes what may leave the disk."""

import logging
import os
import secrets
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from crenel.archive.archive_settings import ArchiveSettings
from crenel.archive.manifest import ArchiveNote, Kind, Manifest
from crenel.archive.notes import NOTES, archive_lock, read_note, write_note
from crenel.archive.ownership import (
    KnownRecords,
    Owner,
    check_owner,
    claim_archive,
    owner_of,
    read_owner,
)
from crenel.archive.pace import Pace
from crenel.archive.place import check_apart, is_on_disk_of
from crenel.archive.planning import Retention, StationRecord, plan_copies, plan_removals
from crenel.archive.rebuilt_clouds import has_calibrations, leave_cloud_out
from crenel.archive.records import RecordLists, list_away, list_records, stamps_in
from crenel.archive.remote_store import RemoteStore, open_store
from crenel.archive.store_errors import DamagedCopyError, SourceError, store_error
from crenel.archive.transfer import (
    archive_record,
    download_file,
    find_difference,
    find_incomplete,
    newest_manifest,
)
from crenel.errors import OperationError
from crenel.formats.atomic_write import ensure_folder, sync_file, sync_folder
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.results.scan_record import CLOUD
from crenel.messages.message import message, quantity
from crenel.progress import Progress, no_progress
from crenel.timestamps import utc_now

log = logging.getLogger(__name__)
REMOVED, FETCHED = ".removed", ".fetched"
RESERVE_BYTES = 1_000_000_000
"""Left free on the station's disk by records that are brought back."""


@dataclass(frozen=True)
class ArchiveState:
    """What is where."""

    waiting: int
    """Finished records that the archive does not have as they are."""
    waiting_bytes: int
    archived: int
    """Records that are both here and in the archive."""
    away: int
    """Records that are in the archive only."""


@dataclass(frozen=True)
class ArchiveLook:
    """What the names and sizes of the files in the archive show."""

    incomplete: list[str]
    """A missing file, or one of another size, of each record that is not whole there."""
    read_at: str
    """Since then, every copy has been read there and compared; empty if there is none."""


class Archive:
    """The archive of a data folder.

    Args:
        station: its name, which the archive states.
        lists: the lists of its database.
        pace: of everything that is read and sent.
        store: by default, that of the settings.
    """

    def __init__(
        self,
        settings: ArchiveSettings,
        station: str,
        data: Path,
        lists: RecordLists,
        pace: Pace,
        store: RemoteStore | None = None,
        now: Callable[[], datetime] = lambda: datetime.now(UTC),
    ) -> None:
        self.settings, self.data, self.pace = settings, data.absolute(), pace
        self._station, self._lists, self._now = station, lists, now
        self.store = store or open_store(settings)

    def state(self) -> ArchiveState:
        """Counts without reading the archive."""
        records = list_records(self.data, self._lists, self._now())
        waiting = plan_copies(records)
        return ArchiveState(
            len(waiting),
            sum(one.size_bytes for one in waiting),
            sum(one.is_archived for one in records),
            len(list_away(self.data)),
        )

    def is_on_same_disk(self) -> bool | None:
        """Whether a disk that fails would take records and archive; None where the archive is on
        no disk of this machine, or not there."""
        return is_on_disk_of(self.settings, self.data)

    def look(self) -> ArchiveLook:
        """Looks in the archive for what it should have, by names and sizes: ``verify`` reads all.

        Raises:
            StoreError: the archive cannot be reached, or its disk is not mounted.
            OperationError: it lies in the data folder, or that in it.
        """
        check_apart(self.settings, self.data)
        present, _ = self._list_known()
        self._check_mounted(read_owner(self.store))
        read_at = min((note.verified_at for note in present), default="")
        return ArchiveLook(find_incomplete(present, self.store), read_at)

    def run(self, progress: Progress = no_progress) -> int:
        """Copies everything that is finished, then applies the rules of retention.

        Returns:
            The number of records that were copied.

        Raises:
            OperationError: the archive cannot be used now; what was copied before stays. The first
                record that itself cannot be read, or copied under its name, is reported after all
                others are copied.
        """
        check_apart(self.settings, self.data)
        with archive_lock(self.data):
            self._clean_up()
            self._check_marker()
            waiting = plan_copies(list_records(self.data, self._lists, self._now()))
            total = sum(one.size_bytes for one in waiting)
            done, copied = 0, 0
            first: SourceError | DamagedCopyError | None = None
            for record in waiting:
                progress(done / max(total, 1), record.id)
                try:
                    taken = leave_cloud_out(record, self.data, self.pace)
                    write_note(self.data, archive_record(taken, self.store, self.pace))
                    copied += 1
                except (SourceError, DamagedCopyError) as error:
                    log.warning("%s is not archived yet: %s", record.id, error.line)
                    first = first or error
                done += record.size_bytes
            self._remove_old()
        if first is not None:
            raise first
        return copied

    def verify(self, progress: Progress = no_progress) -> list[str]:
        """Reads everything that the archive has of this station.

        Returns:
            One name for each record that is not whole there. What the station still has of these
            is copied again by the next ``run``.
        """
        damaged = []
        check_apart(self.settings, self.data)
        with archive_lock(self.data):
            self._check_marker()
            present, _ = self._list_known()
            for number, note in enumerate(present):
                progress(number / len(present), note.id)
                difference = find_difference(note, self.store, self.pace)
                if difference is None:
                    write_note(self.data, note.model_copy(update={"verified_at": utc_now()}))
                    continue
                damaged.append(difference)
                if (self.data / note.kind / note.id).exists():
                    (self.data / NOTES / note.kind / f"{note.id}.json").unlink(missing_ok=True)
        return damaged

    def fetch(self, kind: Kind, record_id: str) -> Manifest:
        """Brings a record back to the station's disk, compared by its hashes.

        Raises:
            OperationError: it is here already, the archive does not have it whole, or the disk has
                no space for it. Nothing is left behind in this case.
        """
        target = self.data / kind / record_id
        if target.exists():
            raise OperationError("archive-here", message("archive-is-here", id=record_id))
        self._check_marker()
        manifest = read_note(self.data, kind, record_id) or newest_manifest(
            self.store, kind, record_id
        )
        if manifest is None:
            raise OperationError(
                "archive-unknown",
                message("archive-has-no-record", id=record_id, place=self.settings.place),
                remedy=message("archive-check-id"),
            )
        self._check_space(manifest.size_bytes)
        part = self.data / NOTES / FETCHED / f"{record_id}-{secrets.token_hex(4)}"
        try:
            with convert_io_errors(target):
                self._download(manifest, part)
                fields = {name: getattr(manifest, name) for name in Manifest.model_fields}
                note = ArchiveNote(**fields, verified_at=utc_now(), fetched_at=utc_now())
                write_note(self.data, note)
                ensure_folder(target.parent)
                part.rename(target)
                sync_folder(target.parent)
        except BaseException:
            shutil.rmtree(part, ignore_errors=True)
            raise
        return manifest

    def _download(self, manifest: Manifest, part: Path) -> None:
        ensure_folder(part)
        for file in manifest.files:
            target = part / file.path
            ensure_folder(target.parent)
            download_file(file, f"{manifest.folder}/{file.path}", target, self.store, self.pace)
            os.utime(target, ns=(file.mtime_ns, file.mtime_ns))
            sync_file(target)
            sync_folder(target.parent)

    def _check_space(self, needed: int) -> None:
        free = shutil.disk_usage(self.data).free
        if needed + RESERVE_BYTES > free:
            raise OperationError(
                "disk-full",
                message("archive-needs-space", size=quantity(needed / 1e9, "GB", 2)),
                message("free-on-disk", free=quantity(free / 1e9, "GB", 2), folder=str(self.data)),
                message("free-some-space"),
            )

    def _check_marker(self) -> None:
        """Writes the marker of a new archive; one that had records must have it.

        Raises:
            StoreError: the archive cannot be used, or its disk is not mounted.
            OperationError: it is that of another station, or a new one would lie in the data
                folder, or that in it. What an earlier version has put there is still read.
        """
        place, found = self.settings.place, read_owner(self.store)
        self._check_mounted(found)
        if found is None:
            check_apart(self.settings, self.data)
        owner = owner_of(self.data, self._station)
        if found is None:
            claim_archive(self.store, place, owner)
        else:
            check_owner(self.store, place, found, owner, self._list_known)

    def _check_mounted(self, found: Owner | None) -> None:
        """Raises ``StoreError`` if an archive that had records lacks its marker."""
        if found is None and any((self.data / NOTES).glob("*/*.json")):
            place = self.settings.place
            raise store_error("archive-missing", place, str(message("archive-no-marker")))

    def _list_known(self) -> KnownRecords:
        records = list_records(self.data, self._lists, self._now())
        notes = [one.note for one in records if one.note is not None]
        return notes + list_away(self.data), records

    def _remove_old(self) -> None:
        rules = Retention(self.settings.keep_days, self.settings.free_gb)
        free = shutil.disk_usage(self.data).free
        records = list_records(self.data, self._lists, self._now())
        for record in plan_removals(records, self._now(), rules, free):
            self._remove(record)

    def _remove(self, record: StationRecord) -> None:
        """Removes a record from the station's disk, after reading it in the archive once more."""
        note = record.note
        assert note is not None
        needs_cloud = record.is_cloud_left_out and (record.folder / CLOUD).exists()
        if needs_cloud and not has_calibrations(record, self.data):
            return  # it could not be made again
        if find_difference(note, self.store, self.pace) is not None:
            # without its note, it is copied again
            (self.data / NOTES / record.kind / f"{record.id}.json").unlink()
            return
        if stamps_in(record.folder) != record.stamps:
            return
        write_note(self.data, note.model_copy(update={"verified_at": utc_now()}))
        doomed = self.data / NOTES / REMOVED / f"{record.kind}-{record.id}"
        with convert_io_errors(record.folder):
            ensure_folder(doomed.parent)
            record.folder.rename(doomed)
            sync_folder(record.folder.parent)
            shutil.rmtree(doomed)
        log.info("%s is in the archive only", record.id)

    def _clean_up(self) -> None:
        """Completes removals that were interrupted: each of these records is in the archive."""
        shutil.rmtree(self.data / NOTES / REMOVED, ignore_errors=True)

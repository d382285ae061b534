"""The records on the station's disk: which are finished, needed here, and in the archive."""

import os
from collections.abc import Iterator, Set
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from datetime import datetime, timedelta
from pathlib import Path
from typing import get_args

from crenel.archive.manifest import ArchiveNote, Kind
from crenel.archive.notes import read_note
from crenel.archive.planning import FileStamp, StationRecord
from crenel.formats.results.scan_record import CLOUD
from crenel.store.backup import DATABASE, check_data_folder
from crenel.store.calibrations import CalibrationStore
from crenel.store.database import Database
from crenel.store.journal import JournalStore
from crenel.store.scans import ScanStore
from crenel.store.session_records import VerificationStore
from crenel.timestamps import clamp_ns, moment_of_ns

KINDS: tuple[Kind, ...] = get_args(Kind)
PART = ".part"
CLOUD_WAIT = timedelta(days=1)
"""An interrupted scan without a cloud is archived after this time: the cloud may still come."""


@dataclass(frozen=True)
class RecordLists:
    """The lists of the database that say what a folder is."""

    journal: JournalStore
    scans: ScanStore
    calibrations: CalibrationStore
    verifications: VerificationStore


@contextmanager
def open_record_lists(data: Path) -> Iterator[RecordLists]:
    """The lists of a data folder, whose station may be running.

    Raises:
        OperationError: no station has used the folder, or its database cannot be read.
    """
    check_data_folder(data)
    database = Database(data / DATABASE)
    try:
        yield RecordLists(
            JournalStore(database),
            ScanStore(database, data),
            CalibrationStore(database, data),
            VerificationStore(database, data),
        )
    finally:
        database.close()


def list_records(data: Path, lists: RecordLists, now: datetime) -> list[StationRecord]:
    """All records on the disk of the data folder.

    A scan is finished when it is in the list of scans, and a guided session when it was ended or
    another one of its kind began after it. Guided sessions of calibrations and of the arm stay on
    the station: every scan and every verification needs its calibration. So do verifications of
    the calibrations in use, and the last record of each kind.
    """
    ended, newest = _sessions(lists.journal)
    scans = {scan.folder.name: scan for scan in lists.scans.all()}
    kept = _needed_verifications(lists) | newest
    found = []
    for kind in KINDS:
        for folder in _folders(data / kind):
            stamps = stamps_in(folder)
            note = read_note(data, kind, folder.name)
            at = _newest_change(folder, stamps)
            scan = scans.get(folder.name) if kind == "scans" else None
            if kind == "scans":
                waits = (
                    scan is not None
                    and bool(scan.interrupted)
                    and not (folder / CLOUD).exists()
                    and now - at < CLOUD_WAIT
                )
                finished = scan is not None and not waits
            else:
                finished = folder.name in ended
            needed = kind == "sessions" or folder.name in kept or stamps is None
            found.append(
                StationRecord(
                    kind,
                    folder.name,
                    folder,
                    at,
                    finished and stamps is not None and not _is_written(stamps),
                    needed,
                    stamps or (),
                    note,
                    None if scan is None else str(scan.name),
                    None if scan is None else scan.calibration_id,
                    scan.points if scan is not None and (folder / CLOUD).exists() else None,
                )
            )
    return found


def stamps_in(folder: Path) -> tuple[FileStamp, ...] | None:
    """All files of a record by path, as they are now; None if it has something that is neither a
    file nor a folder, or cannot be read."""
    found = []
    try:
        for place, folders, names in os.walk(folder, onerror=_raise):
            for name in (*folders, *names):
                path = Path(place) / name
                state = path.lstat()
                if path.is_symlink() or not (path.is_dir() or path.is_file()):
                    return None
                if not path.is_dir():
                    relative = path.relative_to(folder).as_posix()
                    found.append(FileStamp(relative, state.st_size, clamp_ns(state.st_mtime_ns)))
    except OSError:
        return None
    return tuple(sorted(found, key=lambda stamp: stamp.path))


def is_in_archive_only(data: Path, kind: Kind, record_id: str) -> bool:
    """Whether a record has left the station's disk, and the archive has it."""
    return not (data / kind / record_id).exists() and read_note(data, kind, record_id) is not None


def is_without_its_cloud(data: Path, scan_id: str) -> bool:
    """Whether a scan came back from the archive, which keeps no clouds, and has none yet."""
    folder = data / "scans" / scan_id
    if (folder / CLOUD).exists() or not folder.exists():
        return False
    note = read_note(data, "scans", scan_id)
    return note is not None and bool(note.fetched_at)


def list_away(data: Path) -> list[ArchiveNote]:
    """The records that only the archive has."""
    return [
        note
        for kind in KINDS
        for path in sorted((data / "archive" / kind).glob("*.json"))
        if (note := read_note(data, kind, path.stem)) is not None
        if not (data / kind / note.id).exists()
    ]


def _sessions(journal: JournalStore) -> tuple[Set[str], Set[str]]:
    """Ids of the finished guided sessions, and of the last one of each kind."""
    sessions = journal.sessions()
    newest = {session.kind: session.id for session in sessions}
    ended = {one.id for one in sessions if one.ended_at is not None or newest[one.kind] != one.id}
    return ended, set(newest.values())


def _needed_verifications(lists: RecordLists) -> Set[str]:
    """Those of the calibrations in use: each sensor has its own."""
    active = {one.id for one in lists.calibrations.all() if one.active}
    active |= {one.id for one in lists.calibrations.unreadable() if one.active}
    return {one.id for one in lists.verifications.all() if one.calibration_id in active}


def _folders(parent: Path) -> Iterator[Path]:
    with suppress(OSError):
        for folder in sorted(parent.iterdir()):
            if folder.is_dir() and not folder.is_symlink() and not folder.name.startswith("."):
                yield folder


def _is_written(stamps: tuple[FileStamp, ...]) -> bool:
    return any(stamp.path.endswith(PART) for stamp in stamps)


def _newest_change(folder: Path, stamps: tuple[FileStamp, ...] | None) -> datetime:
    times_ns = [stamp.mtime_ns for stamp in stamps or ()]
    if not times_ns:
        with suppress(OSError):
            times_ns = [folder.stat().st_mtime_ns]
    return moment_of_ns(max(times_ns, default=0))


def _raise(error: OSError) -> None:
    raise error

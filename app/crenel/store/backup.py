"""A complete backup of the data folder, even of a running station.

SQLite's own backup copies the database in one consistent state, whatever is written in the
meantime; the files follow, so that every file that this state refers to is included. Each file is
compared with what was read by its hash, and is on the disk before the backup gets its name. The
backup is a data folder itself: a station starts from it with ``--data``.
"""

import errno
import hashlib
import json
import os
import shutil
import sqlite3
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from datetime import UTC, datetime
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.atomic_write import sync_file, sync_folder, write_atomically
from crenel.formats.file_names import display_path, escape_unprintable
from crenel.formats.io_errors import convert_io_errors, error_from_os
from crenel.formats.json_document import SOFTWARE, file_sha256
from crenel.formats.open_file import open_file, read_bounded
from crenel.formats.real_folders import is_within
from crenel.messages.message import message, quantity
from crenel.progress import Progress, no_progress
from crenel.timestamps import is_moment, utc_now

DATABASE = "station.db"
NOTE = "backup.json"
"""In a backup: its description. In a data folder: the location of its last backup."""
LAST = "last_backup.json"
EXCLUDED = {"station.lock", LAST, "backups", "logs"}
PARTS = ".*.backup.part"
DATABASE_PARTS = {DATABASE, f"{DATABASE}-wal", f"{DATABASE}-shm"}
PIECE_BYTES = 1 << 20
RESERVE_BYTES = 200_000_000
"""Space left free on the disk of the backup."""


@dataclass(frozen=True)
class BackupRecord:
    """A complete backup."""

    folder: str
    at: str
    files: int
    bytes: int


def backup(data: Path, output: Path, progress: Progress = no_progress) -> BackupRecord:
    """Copies a data folder into a new one.

    Args:
        output: must not exist yet, or be an empty folder.

    Raises:
        OperationError: there is no data folder, the output exists or is inside it, or its disk has
            no space left. Nothing is left behind in this case.
    """
    data, output = data.resolve(), output.absolute()
    _check(data, output)
    part = output.with_name(f".{output.name}.backup.part")
    with convert_io_errors(output):
        output.parent.mkdir(parents=True, exist_ok=True)
        for left in output.parent.glob(PARTS):  # of processes that were killed
            shutil.rmtree(left, ignore_errors=True)
        part.mkdir(mode=0o700)
    try:
        with convert_io_errors(output):
            made = _copy(data, part, output, progress)
            if output.is_dir():
                output.rmdir()
            part.rename(output)
            sync_folder(output.parent)
    except BaseException:
        shutil.rmtree(part, ignore_errors=True)
        raise
    write_atomically(data / LAST, _json(asdict(made)))
    return made


def last_backup(data: Path) -> BackupRecord | None:
    """The last backup of a data folder, if it still exists."""
    try:
        made = BackupRecord(**json.loads(read_bounded(data / LAST)))
        there = is_moment(made.at) and (Path(made.folder) / NOTE).is_file()
    except (OSError, ValueError, TypeError, RecursionError):
        return None
    return made if there else None


def display_backup(folder: Path | str) -> str:
    """The name of a backup, or of the folder of backups, in messages: relative to its parent
    only."""
    return escape_unprintable("/".join(Path(folder).parts[-2:]))


def new_backup_name() -> str:
    """A name for a new backup."""
    return f"crenel-{datetime.now(UTC):%Y%m%d-%H%M%S}"


def check_data_folder(data: Path) -> None:
    """Raises ``OperationError`` for a folder that was never used by a station."""
    if not (data / DATABASE).is_file():
        raise OperationError(
            "no-data-folder",
            message("no-station-data-folder", folder=data),
            message("no-database-there", database=DATABASE),
            message("give-folder-station-started"),
        )


def _check(data: Path, output: Path) -> None:
    check_data_folder(data)
    folders = (data, *_folders_by_link(data))
    if any(is_within(output, one) for one in folders) and not is_within(output, data / "backups"):
        raise OperationError(
            "output-inside",
            message("folder-inside-data-folder", folder=output),
            message("next-backup-would-include-this"),
            message("choose-folder-elsewhere-best-another-disk"),
        )
    if output.exists() and (not output.is_dir() or any(output.iterdir())):
        raise OperationError(
            "output-taken",
            message("folder-there-already", folder=output),
            message("backup-replaces-nothing"),
            message("name-folder-that-is-not-there"),
        )


def _copy(data: Path, part: Path, output: Path, progress: Progress) -> BackupRecord:
    at = utc_now()
    _copy_database(data / DATABASE, part / DATABASE)
    files = list(_files(data))
    total = sum(size for _, size in files)
    free = shutil.disk_usage(part).free
    if total + RESERVE_BYTES > free:
        raise OperationError(
            "disk-full",
            message("backup-needs", total=quantity(total / 1000000000.0, "GB", 2)),
            message(
                "free-on-disk",
                free=quantity(free / 1000000000.0, "GB", 2),
                folder=display_path(output),
            ),
            message("free-some-space-choose-another-disk"),
        )
    done = 0
    for path, size in files:
        target = part / path.relative_to(data)
        target.parent.mkdir(parents=True, exist_ok=True)
        try:
            _copy_file(path, target)
        except FileNotFoundError:
            continue  # deleted since it was listed
        done += size
        progress(done / max(total, 1), path.name)
    total += (part / DATABASE).stat().st_size
    made = BackupRecord(str(output), at, len(files) + 1, total)
    note = {**asdict(made), "of": str(data), "version": SOFTWARE.version}
    write_atomically(part / NOTE, _json(note))
    for folder, _, _ in os.walk(part):
        sync_folder(Path(folder))
    return made


def _copy_file(source: Path, target: Path) -> None:
    """Copies a file in its present state, synced.

    Raises:
        OperationError: the copy differs from what was read.
    """
    read = hashlib.sha256()
    with open_file(source) as reading, open(target, "xb") as writing:
        while piece := reading.read(PIECE_BYTES):
            read.update(piece)
            writing.write(piece)
        writing.flush()
        os.fsync(writing.fileno())
        # otherwise the comparison would read from the cache
        os.posix_fadvise(writing.fileno(), 0, 0, os.POSIX_FADV_DONTNEED)
    shutil.copystat(source, target)
    if file_sha256(target) != read.hexdigest():
        raise OperationError(
            "backup-differs",
            message("copy-differs-from-source", path=display_path(source)),
            message("disk-of-backup-loses-data"),
            message("make-backup-another-disk"),
        )


def _copy_database(source: Path, target: Path) -> None:
    try:
        reading = sqlite3.connect(f"{source.as_uri()}?mode=ro", uri=True, timeout=10.0)
        writing = sqlite3.connect(target)
        try:
            reading.backup(writing)
            found = str(writing.execute("PRAGMA quick_check").fetchone()[0])
        finally:
            writing.close()
            reading.close()
    except sqlite3.DatabaseError as error:
        if error.sqlite_errorcode == sqlite3.SQLITE_FULL:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC)) from error
        found = str(error)
    os.chmod(target, 0o600)
    sync_file(target)
    if found != "ok":
        raise OperationError(
            "database-unreadable",
            message("cannot-be-copied", path=display_path(source)),
            found,
            message("keep-data-folder-start-earlier-backup"),
        )


def _files(data: Path) -> Iterator[tuple[Path, int]]:
    """Every file with its size, except those that belong to the running server only; links are
    followed, each folder once, since scans may lie on a larger disk."""
    known: set[tuple[int, int]] = set()
    for folder, folders, names in os.walk(data, onerror=_raise, followlinks=True):
        here, top = Path(folder).stat(), Path(folder) == data
        if (here.st_dev, here.st_ino) in known:
            folders.clear()
            continue
        known.add((here.st_dev, here.st_ino))
        folders[:] = sorted(name for name in folders if not (top and name in EXCLUDED))
        for name in sorted(names):
            path = Path(folder) / name
            unwanted = top and (name in EXCLUDED or name in DATABASE_PARTS)
            if unwanted or name.endswith(".part") or not path.is_file():
                continue
            try:
                yield path, path.stat().st_size
            except FileNotFoundError:
                continue


def _folders_by_link(data: Path) -> list[Path]:
    """Folders elsewhere that belong to the data folder by a link in it."""
    return [path for path in data.iterdir() if path.is_symlink() and path.is_dir()]


def _raise(error: OSError) -> None:
    raise error_from_os(error) from error


def _json(fields: dict[str, object]) -> bytes:
    return (json.dumps(fields, indent=1) + "\n").encode()

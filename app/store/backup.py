"""A whole copy of the data folder, also of a station that runs.

The database is copied by SQLite's own means, which give one consistent moment whatever is
written meanwhile; the files follow, so that every file which that moment knows of is there.
Each file is compared with what was read by its hash, and is on the disk before the copy takes
its name.
The copy is a data folder itself: a station starts from it with ``--data``.
"""

import errno
import hashlib
import json
import os
import shutil
import sqlite3
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from datetime import UTC, datetime
from pathlib import Path

from app.errors import OperationError
from app.formats.atomic_write import sync_file, sync_folder, write_atomically
from app.formats.file_names import display_path, escape_unprintable
from app.formats.io_errors import convert_io_errors, error_from_os
from app.formats.json_document import file_sha256
from app.formats.open_file import open_file, read_bounded
from app.formats.software import SOFTWARE
from app.timestamps import is_moment, utc_now

DATABASE = "station.db"
NOTE = "backup.json"
"""In a backup: what it is of. In a data folder: where its last backup is."""
LAST = "last_backup.json"
EXCLUDED = {"station.lock", LAST, "backups", "logs"}
PARTS = ".*.backup.part"
DATABASE_PARTS = {DATABASE, f"{DATABASE}-wal", f"{DATABASE}-shm"}
PIECE_BYTES = 1 << 20
RESERVE_BYTES = 200_000_000
"""Left free on the disk of the copy."""


@dataclass(frozen=True)
class BackupRecord:
    """A backup that is whole."""

    folder: str
    at: str
    files: int
    bytes: int


def backup(
    data: Path, output: Path, progress: Callable[[float, str], None] = lambda share, text: None
) -> BackupRecord:
    """Copies a data folder into a new one.

    Args:
        output: must not exist yet, or be an empty folder.

    Raises:
        Refusal: there is no data folder, the output is taken or within it, or its disk has no
            room. Nothing is then left behind.
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
    """The last backup of a data folder that is still where it was put."""
    try:
        made = BackupRecord(**json.loads(read_bounded(data / LAST)))
        there = is_moment(made.at) and (Path(made.folder) / NOTE).is_file()
    except (OSError, ValueError, TypeError, RecursionError):
        return None
    return made if there else None


def display_backup(folder: Path | str) -> str:
    """How messages name a backup, or the folder that has them: by what it lies in alone."""
    return escape_unprintable("/".join(Path(folder).parts[-2:]))


def new_backup_name() -> str:
    """A name for a backup made now."""
    return f"crenel-{datetime.now(UTC):%Y%m%d-%H%M%S}"


def check_data_folder(data: Path) -> None:
    """Raises ``OperationError`` for a folder that no station was started with."""
    if not (data / DATABASE).is_file():
        raise OperationError(
            "no-data-folder",
            f"{data} is no station's data folder",
            f"there is no {DATABASE}",
            "Give the folder that the station was started with",
        )


def _check(data: Path, output: Path) -> None:
    check_data_folder(data)
    inside = output.resolve().is_relative_to(data)
    if inside and not output.resolve().is_relative_to(data / "backups"):
        raise OperationError(
            "output-inside",
            f"{output} is inside the data folder",
            "the next backup would hold this one",
            "Choose a folder elsewhere, best on another disk",
        )
    if output.exists() and (not output.is_dir() or any(output.iterdir())):
        raise OperationError(
            "output-taken",
            f"{output} is there already",
            "a backup replaces nothing",
            "Name a folder that is not there yet",
        )


def _copy(
    data: Path, part: Path, output: Path, progress: Callable[[float, str], None]
) -> BackupRecord:
    at = utc_now()
    _copy_database(data / DATABASE, part / DATABASE)
    files = list(_files(data))
    total = sum(size for _, size in files)
    free = shutil.disk_usage(part).free
    if total + RESERVE_BYTES > free:
        raise OperationError(
            "disk-full",
            f"The backup needs {total / 1e9:.2f} GB",
            f"{free / 1e9:.2f} GB are free on the disk of {display_path(output)}",
            "Free some space, or choose another disk",
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
    """Copies a file as it is now, synced.

    Raises:
        Refusal: the copy holds something else than was read.
    """
    read = hashlib.sha256()
    with open_file(source) as reading, open(target, "xb") as writing:
        while piece := reading.read(PIECE_BYTES):
            read.update(piece)
            writing.write(piece)
        writing.flush()
        os.fsync(writing.fileno())
        # else the comparison would read the memory that was just written
        os.posix_fadvise(writing.fileno(), 0, 0, os.POSIX_FADV_DONTNEED)
    shutil.copystat(source, target)
    if file_sha256(target) != read.hexdigest():
        raise OperationError(
            "backup-differs",
            f"The copy is not what was read from {display_path(source)}",
            "the disk of the backup does not keep what is written to it",
            "Make the backup on another disk",
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
            f"{display_path(source)} cannot be copied",
            found,
            "Keep the data folder as it is, and start from an earlier backup",
        )


def _files(data: Path) -> Iterator[tuple[Path, int]]:
    """Every file with its size, but for what belongs to the running server alone."""
    for folder, folders, names in os.walk(data, onerror=_raise):
        top = Path(folder) == data
        folders[:] = sorted(name for name in folders if not (top and name in EXCLUDED))
        for name in sorted(names):
            path = Path(folder) / name
            unwanted = top and (name in EXCLUDED or name in DATABASE_PARTS)
            if unwanted or name.endswith(".part") or not path.is_file() or path.is_symlink():
                continue
            try:
                yield path, path.stat().st_size
            except FileNotFoundError:
                continue


def _raise(error: OSError) -> None:
    raise error_from_os(error) from error


def _json(fields: dict[str, object]) -> bytes:
    return (json.dumps(fields, indent=1) + "\n").encode()

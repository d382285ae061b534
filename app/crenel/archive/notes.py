"""The station's notes about what the archive has, in ``archive/`` of the data folder."""

import fcntl
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from crenel.archive.manifest import ArchiveNote, Kind
from crenel.errors import OperationError
from crenel.formats.atomic_write import ensure_folder
from crenel.formats.io_errors import convert_io_errors
from crenel.messages.message import message

NOTES = "archive"
"""The folder of the notes; hidden folders in it are for work in progress."""
LOCK = "lock"


def note_path(data: Path, kind: Kind, record_id: str) -> Path:
    """The location of the note about a record."""
    return data / NOTES / kind / f"{record_id}.json"


def read_note(data: Path, kind: Kind, record_id: str) -> ArchiveNote | None:
    """The note about a record; None if there is none, or it cannot be read: the record is then
    compared with the archive again."""
    path = note_path(data, kind, record_id)
    try:
        note = ArchiveNote.read(path)
    except OperationError:
        return None
    return note if (note.kind, note.id) == (kind, record_id) else None


def write_note(data: Path, note: ArchiveNote) -> None:
    """Stores a note durably; raises ``OperationError`` if the disk does not take it."""
    path = note_path(data, note.kind, note.id)
    with convert_io_errors(path):
        ensure_folder(path.parent)
    note.write(path)


@contextmanager
def archive_lock(data: Path) -> Iterator[None]:
    """Held by whoever copies to the archive or removes records: one process at a time.

    The kernel releases it with the process, however that ends.

    Raises:
        OperationError: another process holds it, or the folder cannot be written.
    """
    path = data / NOTES / LOCK
    with convert_io_errors(path):
        ensure_folder(path.parent)
        handle = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
    try:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise OperationError(
                "archive-busy",
                message("archive-used-by-another"),
                remedy=message("archive-wait-for-other"),
            ) from None
        yield
    finally:
        os.close(handle)

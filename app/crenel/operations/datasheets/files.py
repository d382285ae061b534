"""The files of datasheets: their names, and how one takes the place of another.

No file is deleted or overwritten: one that is no longer used goes into the folder ``retired``
beside the others.
"""

import os
import re
import threading
from itertools import count
from pathlib import Path

from crenel.formats.atomic_write import ensure_folder, sync_folder, write_atomically
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import read_bounded
from crenel.guide.common.datasheet_library import CERTIFICATE_ENDING, GAUGE_ENDINGS

RETIRED = "retired"
ENDINGS = (*GAUGE_ENDINGS, CERTIFICATE_ENDING)
LONGEST_NAME = 60
WRITING = threading.Lock()
"""Who looks for a free name, or at what is there already, holds it until the file has its name."""
_NOT_IN_NAMES = re.compile(r"[^\w-]+")


def split_ending(name: str) -> tuple[str, str]:
    """The id of a datasheet and the ending of its file's name; no ending of another file."""
    ending = next((one for one in ENDINGS if name.lower().endswith(one)), "")
    return name[: len(name) - len(ending)], name[len(name) - len(ending) :]


def free_path(folder: Path, words: str, ending: str) -> Path:
    """A file of this folder whose id no other has; the folder is created.

    Args:
        words: of which the name is made; other signs than letters and numbers are replaced.

    Raises:
        OperationError: the folder cannot be created or read.
    """
    with convert_io_errors(folder):
        ensure_folder(folder)
        taken = {split_ending(name)[0].casefold() for name in os.listdir(folder)}
    stem = _NOT_IN_NAMES.sub("-", words).strip("-_")[:LONGEST_NAME].strip("-_") or "datasheet"
    names = (stem if number == 1 else f"{stem}-{number}" for number in count(1))
    return folder / f"{next(name for name in names if name.casefold() not in taken)}{ending}"


def retire_file(path: Path) -> Path:
    """Moves a file into the folder ``retired``; its path there.

    Raises:
        OperationError: it is gone, or cannot be moved.
    """
    stem, ending = split_ending(path.name)
    return move_file(path, free_path(path.parent / RETIRED, stem, ending))


def move_file(path: Path, target: Path) -> Path:
    """Gives a file another, free name; raises ``OperationError``."""
    with convert_io_errors(path):
        os.rename(path, target)
        sync_folder(target.parent)
        sync_folder(path.parent)
    return target


def put_in_place(path: Path, content: bytes) -> None:
    """Writes a new version of a file; the one before is kept in the folder ``retired``.

    Whenever the station is killed, a complete version has the file's name.

    Raises:
        OperationError: a file cannot be written; the version before is then still in use.
    """
    stem, ending = split_ending(path.name)
    kept = free_path(path.parent / RETIRED, stem, ending)
    with convert_io_errors(path):
        state = path.stat()
        write_atomically(kept, read_bounded(path))
        try:
            os.utime(kept, ns=(state.st_atime_ns, state.st_mtime_ns))
            write_atomically(path, content)
        except BaseException:
            kept.unlink(missing_ok=True)
            raise

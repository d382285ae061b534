"""Atomic writing: a file is either complete or absent."""

import os
import secrets
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import open_file
from crenel.messages.message import message


@contextmanager
def atomic_file(path: Path) -> Iterator[BinaryIO]:
    """A binary file for writing and seeking, which gets its name only when it is complete.

    The bytes go to a hidden file in the same folder. Leaving the block without an exception flushes
    them to disk and renames the file; otherwise they are removed, and a file that had the name
    before stays.

    Raises:
        OperationError: the folder is missing or not writable, the disk is full, or the
            name belongs to a folder or a device.
    """
    with atomic_path(path) as part, open(part, "xb") as file:
        yield file


@contextmanager
def atomic_path(path: Path) -> Iterator[Path]:
    """As ``atomic_file``, for a library that opens its file itself: returns the name for it."""
    target = check_output_path(path)
    part = target.with_name(f".{target.name[:80]}.{secrets.token_hex(4)}.part")
    with convert_io_errors(path):
        try:
            yield part
            with open_file(part) as file:
                os.fsync(file.fileno())
            os.replace(part, target)
        except BaseException:
            part.unlink(missing_ok=True)
            raise
        sync_folder(target.parent)


def write_atomically(path: Path, content: bytes) -> None:
    """Writes a complete file at once; see ``atomic_file``."""
    with atomic_file(path) as file:
        file.write(content)


def check_output_path(path: Path, sources: Iterable[Path] = ()) -> Path:
    """The path to which a file with this name would be written, with links followed.

    Args:
        sources: input files, which the result must not replace.

    Raises:
        OperationError: its folder is missing or not writable, or the name is taken by
            something that is not a file, or by one of the sources. A job can thus be refused
            before it starts.
    """
    with convert_io_errors(path):
        target = Path(os.path.realpath(path))  # resolve fails for a loop of links
        if any(target == Path(os.path.realpath(source)) for source in sources):
            raise OperationError(
                "output-is-source",
                display_path(path),
                message("result-would-replace-file-made"),
                message("name-another-file"),
            )
        if target.exists() and not target.is_file():
            why = (
                message("it-is-a-folder") if target.is_dir() else message("it-is-no-ordinary-file")
            )
            raise OperationError(
                "output-not-a-file",
                display_path(path),
                why,
                message("name-a-file"),
            )
        folder = target.parent
        if not folder.is_dir():
            raise OperationError(
                "folder-missing",
                display_path(path),
                message("no-folder-named", folder=display_path(folder)),
                message("create-choose-another-place"),
            )
        if not os.access(folder, os.W_OK | os.X_OK):
            raise OperationError(
                "folder-forbidden",
                display_path(path),
                message("folder-cannot-be-written", folder=display_path(folder)),
                message("choose-another-place"),
            )
    return target


def make_folder(folder: Path) -> None:
    """Creates a folder that does not exist yet, with its parents, durably.

    Raises:
        FileExistsError: it exists.
        OSError: it cannot be created.
    """
    if not folder.parent.is_dir():
        make_folder(folder.parent)
    folder.mkdir()
    sync_folder(folder.parent)


def ensure_folder(folder: Path) -> None:
    """Creates a folder with its parents, durably, if it does not exist.

    Raises:
        OSError: it cannot be created, or something else has its name.
    """
    try:
        make_folder(folder)
    except FileExistsError:
        if not folder.is_dir():
            raise


def sync_file(path: Path) -> None:
    """Syncs to disk what another process or library wrote; raises ``OSError``."""
    with open_file(path) as file:
        os.fsync(file.fileno())


def sync_folder(folder: Path) -> None:
    """Makes the names in a folder durable, if the platform can; raises ``OSError``."""
    if os.name == "nt":
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)

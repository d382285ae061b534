"""The places that an archive can be: a folder or a mount, or anything that fsspec opens."""

import errno
import os
from collections.abc import Iterable, Iterator, Sequence
from contextlib import closing, contextmanager, suppress
from io import BufferedReader
from pathlib import Path
from typing import Any, Protocol

from crenel.archive.archive_settings import ArchiveSettings
from crenel.archive.filesystem import open_filesystem
from crenel.archive.store_errors import (
    DamagedCopyError,
    StorePurpose,
    convert_foreign_kinds,
    convert_store_errors,
)
from crenel.errors import OperationError
from crenel.formats.atomic_write import atomic_file, ensure_folder
from crenel.formats.file_modes import share_as
from crenel.formats.io_errors import error_from_os
from crenel.formats.open_file import LARGEST_DOCUMENT, open_file
from crenel.messages.message import message

PIECE_BYTES = 1 << 18
PART_BYTES = 5 << 20
"""The least part of a large object that S3 takes; bursts stay small."""
Span = tuple[int, int]
OBJECT_STORES = ("s3://", "s3a://", "gs://", "gcs://")
"""They have no folders, and their libraries would create a missing bucket instead."""


class RemoteStore(Protocol):
    """Files by name, with ``/`` between folders. All methods raise ``OperationError`` that says
    what is wrong with the store."""

    def write(self, name: str, pieces: Iterable[bytes], size: int) -> None:
        """Writes a file of ``size`` bytes. If this is interrupted, an earlier file of the name, or
        none, is there."""

    def read(self, name: str) -> Iterator[bytes]:
        """The content of a file in pieces; as with all reading, ``DamagedCopyError`` if it is
        missing while the store has others."""

    def read_start(self, name: str, count: int) -> bytes:
        """The first ``count`` bytes of a file, or all of a shorter one."""

    def read_spans(self, name: str, spans: Sequence[Span]) -> list[bytes]:
        """Parts of a file, each by its beginning and its end; shorter where the file ends."""

    def size(self, name: str) -> int | None:
        """Bytes of a file; None if there is none."""

    def names(self, folder: str) -> list[str]:
        """The names in a folder, sorted; empty if there is none."""

    def sizes(self, folder: str) -> dict[str, int]:
        """Bytes of every file in a folder and in those within it, by its whole name; empty if there
        is none."""

    def remove(self, name: str) -> None:
        """Removes a file, if it is there."""


def read_document(store: RemoteStore, name: str) -> bytes:
    """A small file, however long what is there under its name.

    Raises:
        OperationError: it is longer than any document, or it cannot be read.
    """
    content = store.read_start(name, LARGEST_DOCUMENT + 1)
    if len(content) > LARGEST_DOCUMENT:
        raise error_from_os(OSError(errno.EOVERFLOW, os.strerror(errno.EOVERFLOW)), Path(name))
    return content


class FolderStore:
    """A folder that exists: of another disk, or the mount of a network drive."""

    def __init__(self, root: Path, purpose: StorePurpose = "archive") -> None:
        self._root, self._place, self._purpose = root, str(root), purpose

    def write(self, name: str, pieces: Iterable[bytes], size: int) -> None:
        path = self._root / name
        with convert_store_errors(self._place, self._purpose):
            if not self._root.is_dir():
                raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), self._place)
            with convert_foreign_kinds(name):
                self._ensure_folder(path.parent)
            # an OperationError of the disk says "full" or "forbidden" for this file: it is the
            # archive's, as the pieces raise their own
            with convert_foreign_kinds(name), atomic_file(path) as file:
                for piece in pieces:
                    file.write(piece)
                share_as(Path(file.name), self._root)

    def _ensure_folder(self, folder: Path) -> None:
        """As ``ensure_folder``; those who may read in the archive may read in it, too."""
        if not folder.is_dir() and folder != self._root:
            self._ensure_folder(folder.parent)
            ensure_folder(folder)
            share_as(folder, self._root)

    def read(self, name: str) -> Iterator[bytes]:
        with _converting(self, name), self._open(name) as file:
            with suppress(AttributeError):  # so that the disk is read, not the cache
                os.posix_fadvise(file.fileno(), 0, 0, os.POSIX_FADV_DONTNEED)
            while piece := file.read(PIECE_BYTES):
                yield piece

    def read_start(self, name: str, count: int) -> bytes:
        with _converting(self, name), self._open(name) as file:
            return file.read(count)

    def read_spans(self, name: str, spans: Sequence[Span]) -> list[bytes]:
        with _converting(self, name), self._open(name) as file:
            found = []
            for begin, end in spans:
                file.seek(begin)
                found.append(file.read(end - begin))
            return found

    def _open(self, name: str) -> BufferedReader:
        with convert_foreign_kinds(name):
            return open_file(self._root / name)

    def size(self, name: str) -> int | None:
        with convert_store_errors(self._place, self._purpose):
            if not self._root.is_dir():
                raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), self._place)
            with suppress(FileNotFoundError, NotADirectoryError), convert_foreign_kinds(name):
                return (self._root / name).stat().st_size
        return None

    def names(self, folder: str) -> list[str]:
        missing = FileNotFoundError, NotADirectoryError
        with convert_store_errors(self._place, self._purpose), suppress(*missing):
            return sorted(path.name for path in (self._root / folder).iterdir())
        return []

    def sizes(self, folder: str) -> dict[str, int]:
        found = {}
        with convert_store_errors(self._place, self._purpose):
            for path in (self._root / folder).rglob("*"):
                if path.is_file():
                    found[path.relative_to(self._root).as_posix()] = path.stat().st_size
        return found

    def remove(self, name: str) -> None:
        with convert_store_errors(self._place, self._purpose):
            (self._root / name).unlink(missing_ok=True)


class FsspecStore:
    """A store of another machine, by a library of the fsspec family.

    Source: the interface of ``fsspec.AbstractFileSystem``. A file opened with ``autocommit=False``
    gets its name only by ``commit``; on S3, this completes the multipart upload.
    """

    def __init__(self, settings: ArchiveSettings, purpose: StorePurpose = "archive") -> None:
        self._settings, self._place, self._purpose = settings, settings.place, purpose
        self._opened: tuple[Any, str] | None = None

    def _at(self, name: str) -> tuple[Any, str]:
        """The library's file system, which connects on its first use, and a path in it."""
        if self._opened is None:
            self._opened = open_filesystem(self._settings)
        files, root = self._opened
        return files, f"{root.rstrip('/')}/{name}"

    def write(self, name: str, pieces: Iterable[bytes], size: int) -> None:
        with convert_store_errors(self._place, self._purpose):
            files, path = self._at(name)
            if not self._settings.url.startswith(OBJECT_STORES):
                files.makedirs(path.rpartition("/")[0], exist_ok=True)
            if size <= PART_BYTES:
                files.pipe_file(path, b"".join(pieces))
                return
            file = files.open(path, "wb", block_size=PART_BYTES, autocommit=False)
            try:
                for piece in pieces:
                    file.write(piece)
                file.close()
                file.commit()
            except BaseException:
                with suppress(Exception):  # the first error counts
                    file.closed = True
                    file.discard()
                raise

    def read(self, name: str) -> Iterator[bytes]:
        with _converting(self, name):
            files, path = self._at(name)
            with closing(files.open(path, "rb", block_size=PART_BYTES)) as file:
                while piece := file.read(PIECE_BYTES):
                    yield piece

    def read_start(self, name: str, count: int) -> bytes:
        with _converting(self, name):
            files, path = self._at(name)
            return bytes(files.cat_file(path, start=0, end=count))

    def read_spans(self, name: str, spans: Sequence[Span]) -> list[bytes]:
        with _converting(self, name):
            files, path = self._at(name)
            begins, ends = ([span[side] for span in spans] for side in (0, 1))
            found = files.cat_ranges([path] * len(spans), begins, ends, on_error="raise")
            for part in found:
                if isinstance(part, BaseException):  # earlier versions of the library return it
                    raise part
            return [bytes(part) for part in found]

    def size(self, name: str) -> int | None:
        with convert_store_errors(self._place, self._purpose):
            files, path = self._at(name)
            try:
                return int(files.info(path)["size"])
            except FileNotFoundError:
                return None

    def names(self, folder: str) -> list[str]:
        with convert_store_errors(self._place, self._purpose):
            files, path = self._at(folder)
            try:
                found = files.ls(path, detail=False, refresh=True)
            except FileNotFoundError:
                return []
            return sorted({str(path).rstrip("/").rpartition("/")[2] for path in found} - {""})

    def sizes(self, folder: str) -> dict[str, int]:
        with convert_store_errors(self._place, self._purpose):
            files, path = self._at(folder)
            try:
                found = files.find(path, detail=True)
            except FileNotFoundError:
                return {}
            start = len(path) - len(folder)
            return {name[start:]: int(info["size"]) for name, info in found.items()}

    def remove(self, name: str) -> None:
        with convert_store_errors(self._place, self._purpose), suppress(FileNotFoundError):
            files, path = self._at(name)
            files.rm_file(path)


@contextmanager
def _converting(store: FolderStore | FsspecStore, name: str) -> Iterator[None]:
    """Turns the errors of reading a file.

    One that is missing in a store that has others is a ``DamagedCopyError``: a store that is not
    there has none.
    """
    with convert_store_errors(store._place, store._purpose):
        try:
            yield
        except (FileNotFoundError, OperationError) as error:
            missing = isinstance(error, FileNotFoundError) or error.code == "file-missing"
            if missing and store.names(""):
                raise DamagedCopyError(name, message("archive-lacks-file")) from error
            raise


def open_store(settings: ArchiveSettings, purpose: StorePurpose = "archive") -> RemoteStore:
    """The store of the settings; it is not reached yet.

    Args:
        purpose: for which it is opened; errors say what to do accordingly.
    """
    if settings.is_folder:
        return FolderStore(Path(settings.url), purpose)
    return FsspecStore(settings, purpose)

"""Safe opening of files: only regular files, of limited size.

Whatever has a file's name in the data folder, opening and reading it must end: a pipe, a socket or
a device could otherwise keep its reader waiting, or supply data forever.
"""

import errno
import os
import stat
from contextlib import suppress
from io import BufferedReader
from pathlib import Path

LARGEST_DOCUMENT = 64 << 20
"""Maximum size of a file that is read as a whole: a document, a table, a picture."""
_FLAGS = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)


def open_file(path: Path) -> BufferedReader:
    """Opens a regular file for reading.

    Raises:
        OSError: missing or unreadable; ``EISDIR`` for a folder, ``ENXIO`` for a pipe, a socket
            or a device.
    """
    _check_kind(path, os.stat(path).st_mode)  # opening a device may already have an effect
    handle = os.open(path, _FLAGS)
    try:
        _check_kind(path, os.fstat(handle).st_mode)
        return os.fdopen(handle, "rb")
    except BaseException:
        os.close(handle)
        raise


def read_bounded(path: Path, largest: int = LARGEST_DOCUMENT) -> bytes:
    """The bytes of a regular file.

    Raises:
        OSError: as ``open_file``; ``EOVERFLOW`` for a file of more than ``largest`` bytes.
    """
    with open_file(path) as file:
        content = b""
        if os.fstat(file.fileno()).st_size <= largest:
            content = file.read(largest + 1)
            if len(content) <= largest:
                return content
    raise OSError(errno.EOVERFLOW, os.strerror(errno.EOVERFLOW), str(path))


def read_tail(path: Path, most: int) -> tuple[bytes, bool]:
    """The last bytes of a regular file of any size, and whether they are the complete file.

    Raises:
        OSError: as ``open_file``.
    """
    with open_file(path) as file:
        size = os.fstat(file.fileno()).st_size
        file.seek(max(size - most, 0))
        return file.read(most), size <= most


def check_ordinary(path: Path) -> None:
    """Raises ``OSError`` if something other than a regular file has this name."""
    with suppress(FileNotFoundError):
        _check_kind(path, os.stat(path).st_mode)


def _check_kind(path: Path, mode: int) -> None:
    if not stat.S_ISREG(mode):
        number = errno.EISDIR if stat.S_ISDIR(mode) else errno.ENXIO
        raise OSError(number, os.strerror(number), str(path))

"""One server per data folder: the lock that stops a second one."""

import contextlib
import fcntl
import os
from pathlib import Path
from types import TracebackType
from typing import Self

from crenel.errors import OperationError
from crenel.messages.message import message


class FolderLock:
    """Holds ``station.lock`` in the data folder from construction until ``release``.

    The kernel releases the lock with the process, however it ends, so that a killed server leaves
    nothing to clean up; the file itself stays and names the last holder.

    Raises:
        OperationError: ``data-folder-in-use``, naming the process that holds it.
    """

    def __init__(self, folder: Path) -> None:
        path = folder / "station.lock"
        self._file = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            holder = os.pread(self._file, 32, 0).decode("ascii", "replace").strip() or "unknown"
            os.close(self._file)
            raise OperationError(
                "data-folder-in-use",
                message("data-folder-in-use", folder=folder, process=holder),
                remedy=message("stop-server-give-one-data-folder"),
            ) from None
        with contextlib.suppress(OSError):  # a full disk: only the holder's number is missing
            os.ftruncate(self._file, 0)
            os.pwrite(self._file, f"{os.getpid()}\n".encode(), 0)

    def release(self) -> None:
        """Releases the folder for another server; idempotent."""
        if self._file >= 0:
            os.close(self._file)
            self._file = -1

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.release()

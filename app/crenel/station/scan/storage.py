"""Where scans are put, and whether there is space for them."""

import contextlib
import shutil
from datetime import datetime
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.atomic_write import ensure_folder, make_folder
from crenel.formats.file_names import display_path
from crenel.formats.io_errors import convert_io_errors, error_from_os
from crenel.messages.message import message, quantity

RECORDING = "scan.mcap"
# A scan does not start with less, and stops before the disk is so full that it
# could not complete its files.
START_FREE_BYTES = 500_000_000
STOP_FREE_BYTES = 100_000_000


class ScanFolders:
    """The folders of a station's scans, each named by when it was started."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def start_space_error(self) -> OperationError | None:
        """Why the disk lets no scan begin; None when it does."""
        return self._space_error(START_FREE_BYTES)

    def running_space_error(self) -> OperationError | None:
        """Why the disk ends a running scan; None when it does not."""
        return self._space_error(STOP_FREE_BYTES)

    def new(self, started: datetime) -> Path:
        """A folder of its own for a scan; raises ``OperationError`` where it cannot be made."""
        stem = f"{started:%Y%m%d-%H%M%S}"
        names = (stem if n == 1 else f"{stem}-{n}" for n in range(1, 1000))
        with convert_io_errors(self._folder):
            for name in names:
                with contextlib.suppress(FileExistsError):
                    make_folder(self._folder / name)
                    return self._folder / name
        raise OperationError(
            "folder-taken", message("no-free-name-scan", folder=display_path(self._folder))
        )

    def _space_error(self, needed: int) -> OperationError | None:
        try:
            ensure_folder(self._folder)
            free = shutil.disk_usage(self._folder).free
        except OSError as error:
            return error_from_os(error, self._folder)
        if free >= needed:
            return None
        return OperationError(
            "disk-full",
            message(
                "only-free-disk",
                free=quantity(free / 1e9, "GB", 2),
                folder=display_path(self._folder),
            ),
            message("scan-needs", needed=quantity(needed / 1e9, "GB", 1)),
            message("free-some-space"),
        )


def recording_size(folder: Path) -> int:
    """Bytes of the recording in a scan's folder; 0 where there is none."""
    try:
        return (folder / RECORDING).stat().st_size
    except OSError:
        return 0


def make_scan_folder(folder: Path) -> Path:
    """A new folder where the caller wants it; raises ``OperationError`` where it cannot be made."""
    with convert_io_errors(folder):
        make_folder(folder)
    return folder

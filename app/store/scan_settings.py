"""The operator's settings for scans, kept over restarts."""

from pathlib import Path

from app.errors import OperationError
from app.formats.settings.scan_settings import AUTOMATIC, ScanSettings

FILE = "scan_settings.json"


class SettingsStore:
    """One file in the data folder."""

    def __init__(self, folder: Path) -> None:
        self._path = folder / FILE
        self.trouble: OperationError | None = None
        """Why the stored settings could not be read; everything is then automatic."""

    def read(self) -> ScanSettings:
        """The stored settings; automatic before the first time."""
        if not self._path.exists():
            return AUTOMATIC
        try:
            return ScanSettings.read(self._path)
        except OperationError as error:
            self.trouble = error
            return AUTOMATIC

    def save(self, settings: ScanSettings) -> None:
        """Raises ``OperationError`` if they cannot be written to the disk."""
        settings.write(self._path)

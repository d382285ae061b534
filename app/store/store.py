"""Everything that the station remembers, in one data folder."""

from pathlib import Path

from app.metrology.refusal import Refusal
from app.store.accounts import AccountStore
from app.store.audit import AuditLog
from app.store.calibrations import CalibrationStore
from app.store.database import Database
from app.store.journal import JournalStore
from app.store.lock import FolderLock
from app.store.scan_settings import SettingsStore
from app.store.scans import ScanStore
from app.store.scrapers import ScraperStore
from app.store.sign_ins import SignInStore
from app.store.temperatures import TemperatureStore
from app.store.verifications import VerificationStore

FOLDERS = ("arms", "objects", "sensors", "gauges", "sessions", "scans", "verifications")


class Store:
    """The data folder, held by this process alone until ``close``.

    Raises:
        Refusal: the folder cannot be written, is in use by another server, or holds
            a database that cannot be read.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder.absolute()
        try:
            for name in FOLDERS:
                (self.folder / name).mkdir(parents=True, exist_ok=True)
            self._lock = FolderLock(self.folder)
        except OSError as error:
            raise Refusal(
                "data-folder-unwritable",
                f"The data folder {folder} cannot be used",
                error.strerror or str(error),
                "Give a folder that this user may write with --data",
            ) from error
        try:
            self._database = Database(self.folder / "station.db")
        except BaseException:
            self._lock.release()
            raise
        self.journal = JournalStore(self._database)
        self.calibrations = CalibrationStore(self._database, self.folder)
        self.verifications = VerificationStore(self._database, self.folder)
        self.temperatures = TemperatureStore(self._database)
        self.scans = ScanStore(self._database, self.folder)
        self.settings = SettingsStore(self.folder)
        self.accounts = AccountStore(self._database)
        self.sign_ins = SignInStore(self._database)
        self.audit = AuditLog(self._database)
        self.scrapers = ScraperStore(self._database)

    def check(self) -> str:
        """What is wrong with the database; empty where nothing is. It may take seconds."""
        return self._database.check()

    def close(self) -> None:
        """Closes the database and lets another server have the folder; idempotent."""
        self._database.close()
        self._lock.release()

"""All stored data of the station, in one data folder."""

from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.atomic_write import ensure_folder
from crenel.formats.file_modes import close_to_others
from crenel.formats.file_names import register_data_folder, unregister_data_folder
from crenel.formats.io_errors import error_from_os
from crenel.formats.settings.scan_settings import AUTOMATIC, ScanSettings
from crenel.messages.message import join, message
from crenel.store.access_tokens import AccessTokenStore
from crenel.store.accounts import AccountStore
from crenel.store.audit import AuditLog
from crenel.store.backup import DATABASE, last_backup
from crenel.store.calibrations import CalibrationStore
from crenel.store.database import FULL, Database
from crenel.store.journal import JournalStore
from crenel.store.lock import FolderLock
from crenel.store.login_sessions import LoginSessionStore
from crenel.store.scans import ScanStore
from crenel.store.session_records import InspectionStore, PerformanceStore, VerificationStore
from crenel.store.temperatures import TemperatureStore

RECORD_FOLDERS = ("sessions", "scans", "verifications", "performance")
"""Folders whose content is listed in the database."""
FOLDERS = ("arms", "objects", "sensors", "gauges", "programs", "inspections", *RECORD_FOLDERS)
SETTINGS_FILE = "scan_settings.json"


class SettingsStore:
    """The operator's settings of scans: one file in the data folder, kept over restarts."""

    def __init__(self, folder: Path) -> None:
        self._path = folder / SETTINGS_FILE
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


class Store:
    """The data folder, held exclusively by this process until ``close``.

    Raises:
        OperationError: the folder cannot be written, is in use by another server, or contains
            a database that cannot be read.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder.absolute()
        try:
            for name in FOLDERS:
                ensure_folder(self.folder / name)
                close_to_others(self.folder / name)  # it may be a link to another disk
            close_to_others(self.folder)
            self._lock = FolderLock(self.folder)
        except OSError as error:
            if error.errno in FULL:
                raise OperationError(
                    "disk-full",
                    message("disk-of-data-folder-full", folder=folder),
                    error.strerror or str(error),
                    message("free-some-space-start-again"),
                ) from error
            why = error_from_os(error)
            raise OperationError(
                "data-folder-unwritable",
                message("data-folder-cannot-be-used", folder=folder),
                join([why.what, why.why], ": "),
                message("give-folder-user-may-write-data"),
            ) from error
        try:
            self._check_database_exists()
            self._database = Database(self.folder / DATABASE)
        except BaseException:
            self._lock.release()
            raise
        register_data_folder(self.folder)
        self.journal = JournalStore(self._database)
        self.calibrations = CalibrationStore(self._database, self.folder)
        self.verifications = VerificationStore(self._database, self.folder)
        self.performances = PerformanceStore(self._database, self.folder)
        self.inspections = InspectionStore(self._database, self.folder)
        self.temperatures = TemperatureStore(self._database)
        self.scans = ScanStore(self._database, self.folder)
        self.settings = SettingsStore(self.folder)
        self.accounts = AccountStore(self._database)
        self.login_sessions = LoginSessionStore(self._database)
        self.audit = AuditLog(self._database)
        self.kiosk_links = AccessTokenStore(self._database, "kiosk_link")
        self.api_tokens = AccessTokenStore(self._database, "api_token")

    def _check_database_exists(self) -> None:
        """Raises ``OperationError`` if folders have content and the database is missing or
        empty."""
        database = self.folder / DATABASE
        if database.exists() and (not database.is_file() or database.stat().st_size):
            return
        full = [name for name in RECORD_FOLDERS if any((self.folder / name).iterdir())]
        if full:
            last = last_backup(self.folder)
            remedy = (
                message("restore-database-from-last-backup", database=DATABASE)
                if last is None
                else message("restore-database-from", database=DATABASE, folder=last.folder)
            )
            raise OperationError(
                "database-missing",
                message("database-is-empty", database=database)
                if database.exists()
                else message("database-is-not-there", database=database),
                message("folders-next-to-it-not-empty", folders=", ".join(full)),
                remedy,
            )

    def check(self) -> str:
        """Problems of the database; empty if there are none. It may take seconds."""
        return self._database.check()

    def unreadable_rows(self) -> list[int]:
        """Numbers of the journal rows that cannot be read. It may take seconds."""
        return self._database.unreadable_rows()

    def close(self) -> None:
        """Closes the database and releases the folder for another server; idempotent."""
        self._database.close()
        self._lock.release()
        unregister_data_folder(self.folder)

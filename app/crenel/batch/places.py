"""Where records are: archives and data folders, each of one station."""

import hashlib
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from crenel.archive.archive_settings import REMOTE, ArchiveSettings
from crenel.archive.manifest import ArchivedFile, Kind
from crenel.archive.notes import read_note
from crenel.archive.ownership import MARKER
from crenel.archive.planning import FileStamp
from crenel.archive.records import stamps_in
from crenel.archive.remote_store import RemoteStore, open_store
from crenel.archive.store_errors import DamagedCopyError
from crenel.archive.transfer import newest_manifest
from crenel.batch.listed_scans import ListedScan, read_listed_scans
from crenel.batch.patience import Patience, open_patiently
from crenel.errors import OperationError
from crenel.formats.file_names import check_name
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import open_file
from crenel.messages.message import message

DATABASE = "station.db"
HASH_BYTES = 1 << 20


@dataclass(frozen=True)
class Dependency:
    """A place without which a task cannot be done."""

    settings: ArchiveSettings
    marker: str = ""
    """A file that is always in it."""

    def is_there(self) -> bool:
        """Whether it can be reached now."""
        try:
            return open_store(self.settings).size(self.marker) is not None or not self.marker
        except OperationError:
            return False


@dataclass(frozen=True)
class RecordFile:
    """A file of a record; its content is read with ``Place.store``."""

    place: "Place"
    name: str
    """In the place's store."""
    bytes: int
    mtime_ns: int
    sha256: str = ""
    """Known from the archive; otherwise empty, see ``digest``."""

    @property
    def full_name(self) -> str:
        """In messages."""
        return f"{self.place.name}/{self.name}"

    def digest(self) -> str:
        """The SHA-256 of its content; read for it where no archive knows it.

        Raises:
            OperationError: the file cannot be read.
        """
        if self.sha256:
            return self.sha256
        found = hashlib.sha256()
        path = Path(self.place.settings.url) / self.name
        with convert_io_errors(path), open_file(path) as file:
            while piece := file.read(HASH_BYTES):
                found.update(piece)
        return found.hexdigest()


@dataclass(frozen=True)
class PlaceRecord:
    """A record with its files by their paths in it."""

    place: "Place"
    kind: Kind
    id: str
    files: dict[str, RecordFile]
    listed: ListedScan | None = None
    """What the station listed of a scan, where the archive knows it."""

    @property
    def full_name(self) -> str:
        """Its folder in messages."""
        path, file = next(iter(self.files.items()))
        return file.full_name.removesuffix(f"/{path}")


@dataclass(frozen=True)
class Place:
    """The archive, or the data folder, of one station."""

    settings: ArchiveSettings
    is_archive: bool

    @property
    def name(self) -> str:
        """Its address in messages."""
        return self.settings.place.rstrip("/")

    @property
    def station(self) -> str:
        """The name of its folder."""
        return PurePosixPath(self.name).name

    @property
    def dependency(self) -> Dependency:
        """Itself, for what reads it."""
        return Dependency(self.settings, MARKER if self.is_archive else DATABASE)

    def store(self, patience: Patience | None = None) -> RemoteStore:
        """Opens it; with a patience, it is waited for while it cannot be reached."""
        return open_patiently(self.settings, "records", patience)

    def ids(self, kind: Kind, store: RemoteStore) -> list[str]:
        """The names of the records of a kind; raises ``OperationError``."""
        return [name for name in store.names(kind) if not name.startswith(".")]

    def record(self, kind: Kind, record_id: str, store: RemoteStore) -> PlaceRecord | None:
        """A record with its last content; None if there is no whole one.

        Raises:
            OperationError: the place cannot be read.
        """
        if self.is_archive:
            return self._record_in_archive(kind, record_id, store)
        found = self._files_in_folder(kind, record_id)
        return PlaceRecord(self, kind, record_id, found) if found else None

    def scan_list(self) -> dict[str, ListedScan]:
        """The list of scans of a data folder, by id; an archive states them with each record."""
        return {} if self.is_archive else read_listed_scans(Path(self.settings.url) / DATABASE)

    def _record_in_archive(
        self, kind: Kind, record_id: str, store: RemoteStore
    ) -> PlaceRecord | None:
        manifest = newest_manifest(store, kind, record_id)
        if manifest is None or not manifest.files:
            return None
        files = {
            file.path: RecordFile(
                self, f"{manifest.folder}/{file.path}", file.bytes, file.mtime_ns, file.sha256
            )
            for file in manifest.files
        }
        label, calibration_id = manifest.label, manifest.calibration_id or ""
        listed = None if label is None else ListedScan(label, calibration_id=calibration_id)
        return PlaceRecord(self, kind, record_id, files, listed)

    def _files_in_folder(self, kind: Kind, record_id: str) -> dict[str, RecordFile]:
        data = Path(self.settings.url)
        note = read_note(data, kind, record_id)
        known = {_stamp(file): file.sha256 for file in note.files} if note is not None else {}
        stamps = stamps_in(data / kind / record_id) or ()
        return {
            one.path: RecordFile(
                self,
                f"{kind}/{record_id}/{one.path}",
                one.bytes,
                one.mtime_ns,
                known.get(one, ""),
            )
            for one in stamps
        }


def _stamp(file: ArchivedFile) -> FileStamp:
    return FileStamp(file.path, file.bytes, file.mtime_ns)


def find_places(
    given: Sequence[str], keys: ArchiveSettings | None = None, patience: Patience | None = None
) -> list[Place]:
    """The stations at addresses: an archive, a data folder, or what has several archives in it.

    Args:
        given: folders, or addresses of fsspec such as ``s3://bucket``.
        keys: whose endpoint and keys open all of them.
        patience: with which it is waited for stores that cannot be reached.

    Raises:
        OperationError: one cannot be read, or has no archive and no data folder.
    """
    found = []
    for url in given:
        inside = list(_places_at(url, keys, patience))
        if not inside:
            raise OperationError(
                "no-records",
                message("batch-no-place", place=settings_for(url, keys).place),
                remedy=message("batch-name-a-place"),
            )
        found += inside
    return found


def _places_at(
    url: str, keys: ArchiveSettings | None, patience: Patience | None
) -> Iterator[Place]:
    settings = settings_for(url, keys)
    store = open_patiently(settings, "records", patience)
    if store.size(MARKER) is not None:
        yield Place(settings, True)
        return
    if settings.is_folder and (Path(settings.url) / DATABASE).is_file():
        yield Place(settings, False)
        return
    for name in store.names(""):
        marker = None
        with suppress(DamagedCopyError):  # a file beside the archives
            marker = store.size(f"{name}/{MARKER}")
        if marker is not None:
            yield Place(settings_for(f"{settings.url.rstrip('/')}/{name}", keys), True)


def settings_for(url: str, keys: ArchiveSettings | None = None) -> ArchiveSettings:
    """The settings of an address, relative to the working folder if it is a folder.

    Args:
        keys: of the store; None: what its library finds.

    Raises:
        OperationError: a name in the address is not valid Unicode.
    """
    for name in Path(url).parts:
        check_name(Path(name))
    fields = {"url": url if REMOTE in url else str(Path(url).absolute())}
    context = Path.cwd() / "station.toml"
    made = ArchiveSettings.model_validate(fields, context=context)
    if keys is None or made.is_folder:
        return made
    return keys.model_copy(update={"url": made.url})

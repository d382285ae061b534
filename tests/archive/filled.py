"""A data folder with records, and what an archive of it must hold."""

import hashlib
import random
from datetime import UTC, datetime, timedelta
from functools import partial
from pathlib import Path

from crenel.archive.archive import Archive
from crenel.archive.archive_settings import ArchiveSettings
from crenel.archive.manifest import MANIFEST, Manifest
from crenel.archive.pace import Pace, full_speed
from crenel.archive.records import RecordLists, list_away
from crenel.archive.remote_store import RemoteStore
from crenel.store.scans import ScanRecord
from crenel.store.store import Store

Content = dict[str, bytes]
"""The files of a record by their path."""
Rules = dict[str, float]
"""``keep_days`` and ``free_gb``."""
LATER = timedelta(days=100)


def add_scan(store: Store, scan_id: str, size: int, seed: int = 0) -> Path:
    """A finished scan of random bytes; returns its folder."""
    folder = store.folder / "scans" / scan_id
    folder.mkdir()
    random_bytes = random.Random(f"{scan_id} {seed}")
    (folder / "scan.mcap").write_bytes(random_bytes.randbytes(size))
    (folder / "cloud.ply").write_bytes(random_bytes.randbytes(size // 3))
    record = ScanRecord(scan_id, scan_id, folder, "2026-05-01T10:00:00Z", 5, 5, 1.0, "c")
    store.scans.add(record)
    return folder


def add_session(store: Store, kind: str, session_id: str, ended: bool = True) -> Path:
    """A guided session with a file in a folder of its own."""
    top = {"verification": "verifications", "performance": "performance"}.get(kind, "sessions")
    folder = store.folder / top / session_id
    (folder / "images").mkdir(parents=True)
    (folder / "arm.json").write_text(f"of {session_id}")
    (folder / "images/capture 1.png").write_bytes(session_id.encode() * 50)
    store.journal.begin_session(session_id, kind)
    if ended:
        store.journal.end_session(session_id)
    return folder


def lists_of(store: Store) -> RecordLists:
    return RecordLists(store.journal, store.scans, store.calibrations, store.verifications)


def archive_of(
    store: Store,
    url: str,
    remote: RemoteStore | None = None,
    pace: Pace | None = None,
    later: timedelta = timedelta(),
    rules: Rules | None = None,
    station: str = "Room 2",
) -> Archive:
    """The archive of a data folder, as seen ``later``."""
    settings = ArchiveSettings.model_validate(
        {"url": url, **(rules or {})}, context=Path("station.toml")
    )
    lists, speed = lists_of(store), pace or full_speed()
    return Archive(
        settings, station, store.folder, lists, speed, remote, lambda: datetime.now(UTC) + later
    )


def content_of(folder: Path) -> Content:
    files = (path for path in sorted(folder.rglob("*")) if path.is_file())
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}


def check_whole(archived: Content) -> list[Manifest]:
    """Every manifest of an archive, after a check that its record is whole."""
    found = []
    for name, content in archived.items():
        if name.rpartition("/")[2] != MANIFEST:
            continue
        manifest = Manifest.parse(content, name)
        for file in manifest.files:
            held = archived[f"{manifest.folder}/{file.path}"]
            assert hashlib.sha256(held).hexdigest() == file.sha256, (name, file.path)
        found.append(manifest)
    return found


class Room:
    """A station whose archive is in a folder."""

    def __init__(self, store: Store, place: Path) -> None:
        self.store, self.place = store, place
        self.add_scan = partial(add_scan, store)
        self.archive = partial(archive_of, store, str(place))

    def away(self) -> list[str]:
        """Scans that have left the disk."""
        return [note.id for note in list_away(self.store.folder)]

    def manifests(self) -> list[Manifest]:
        """Those in the archive, each of a whole record."""
        return check_whole(content_of(self.place))

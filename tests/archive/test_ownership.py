"""An archive is that of one station, whatever names, times and files are in it or in a record."""

import json
import os
import shutil
from collections.abc import Callable, Iterable, Iterator
from contextlib import closing
from pathlib import Path

import pytest

from crenel.archive.archive import Archive
from crenel.archive.notes import NOTES
from crenel.archive.ownership import FIRST_LINE, IDENTITY, MARKER
from crenel.archive.remote_store import FolderStore
from crenel.archive.store_errors import store_error
from crenel.archive.transfer import newest_manifest
from crenel.errors import OperationError
from crenel.store.store import Store
from tests.archive.filled import LATER, Room, add_scan, archive_of, content_of
from tests.refusals import refused, refused_as

Calls = dict[str, Callable[[Archive], object]]
CALLS: Calls = {
    "run": Archive.run,
    "verify": Archive.verify,
    "fetch": lambda archive: archive.fetch("scans", "none"),
}


@pytest.fixture
def other(tmp_path: Path) -> Iterator[Store]:
    with closing(Store(tmp_path / "other")) as opened:
        yield opened


@pytest.fixture
def theirs(other: Store, place: Path) -> Path:
    """The archive of another station, with a scan."""
    add_scan(other, "theirs", 1000)
    archive_of(other, str(place), station="Messraum 3").run()
    return place


def forget_owner(place: Path) -> None:
    """The marker as earlier versions wrote it."""
    (place / MARKER).write_text(f"{FIRST_LINE}\n")


def check_refused(archive: Archive, place: Path, owner: str) -> None:
    before = content_of(place)
    for call in CALLS.values():
        with refused_as("archive-foreign", owner, "station.toml"):
            call(archive)
    assert content_of(place) == before


@pytest.mark.parametrize("archived", [True, False], ids=["moved", "new"])
@pytest.mark.parametrize("named", [True, False], ids=["named", "of-earlier-version"])
def test_the_archive_of_another_station_is_refused_and_gets_nothing(
    store: Store, theirs: Path, tmp_path: Path, archived: bool, named: bool
) -> None:
    add_scan(store, "ours", 1000)
    add_scan(store, "theirs", 900, seed=1)  # of the same second
    if archived:
        own = tmp_path / "own"
        own.mkdir()
        assert archive_of(store, str(own)).run() == 2
    if not named:
        forget_owner(theirs)
    owner = "Messraum 3" if named else "another station"
    check_refused(archive_of(store, str(theirs)), theirs, owner)


def test_a_new_archive_without_records_is_that_of_its_station(room: Room, other: Store) -> None:
    archive_of(other, str(room.place), station="Messraum 3").run()
    check_refused(room.archive(), room.place, "Messraum 3")


@pytest.mark.usefixtures("archived")
def test_an_archive_of_an_earlier_version_then_names_its_station(room: Room, other: Store) -> None:
    forget_owner(room.place)
    room.add_scan("two", 1000)
    assert room.archive().run() == 1
    assert "Name: Room 2\n" in (room.place / MARKER).read_text()
    check_refused(archive_of(other, str(room.place)), room.place, "Room 2")


class WriteOnceStore(FolderStore):
    """A folder that takes new files only."""

    def write(self, name: str, pieces: Iterable[bytes], size: int) -> None:
        if self.size(name) is not None:
            raise store_error("archive-forbidden", "archive", "it is there")
        super().write(name, pieces, size)


@pytest.mark.usefixtures("archived")
def test_an_archive_of_an_earlier_version_that_takes_new_files_only_goes_on(room: Room) -> None:
    forget_owner(room.place)
    room.add_scan("two", 1000)
    assert room.archive(WriteOnceStore(room.place)).run() == 1
    assert "Name:" not in (room.place / MARKER).read_text()


@pytest.mark.usefixtures("archived")
def test_a_station_without_its_notes_knows_its_archive_by_the_records(room: Room) -> None:
    shutil.rmtree(room.store.folder / NOTES)
    assert room.archive().run() == 1
    # and with the notes of a backup that is older than the identity
    (room.store.folder / NOTES / IDENTITY).unlink()
    assert room.archive().run() == 0


def test_a_new_data_folder_takes_an_archive_without_its_marker(store: Store, theirs: Path) -> None:
    (theirs / MARKER).unlink()
    add_scan(store, "ours", 1000)
    assert archive_of(store, str(theirs), station="Room 3").run() == 1
    assert "Name: Room 3\n" in (theirs / MARKER).read_text()


@pytest.fixture
def copy(archived: Path, place: Path) -> Path:
    """The archive's folder of the scan ``one``."""
    (manifest,) = place.rglob("manifest.json")
    return manifest.parent


@pytest.mark.parametrize(
    "name", [b"Pr\xfcf.txt", b"\xfc/inner", b"a\\b", b"manifest.json", b"/".join([b"d" * 90] * 5)]
)
def test_a_name_that_no_manifest_holds_stops_no_other_record(room: Room, name: bytes) -> None:
    path = room.add_scan("one", 1000) / os.fsdecode(name)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("the operator's")
    room.add_scan("two", 1000)
    with refused("archive-name") as failed:
        room.archive().run()
    assert failed.value.line.isprintable()
    assert [one.id for one in room.manifests()] == ["two"]


@pytest.mark.parametrize("time_s", [-1e6, 1e13], ids=["before 1970", "year 300000"])
def test_a_file_time_outside_the_calendar_is_the_nearest_in_it(room: Room, time_s: float) -> None:
    os.utime(room.add_scan("one", 1000) / "cloud.ply", (time_s, time_s))
    archive = room.archive()
    assert (archive.run(), archive.run()) == (1, 0)


@pytest.mark.parametrize("foreign", [os.mkfifo, os.mkdir])
@pytest.mark.parametrize("name", ["scan.mcap", "manifest.json"])
def test_what_is_no_file_in_the_archive_keeps_no_other_record_from_it(
    room: Room, copy: Path, name: str, foreign: Callable[[Path], None]
) -> None:
    archive = room.archive(later=LATER, rules={"keep_days": 1})
    (copy / name).unlink()
    foreign(copy / name)
    room.add_scan("two", 1000)
    archive.run()
    with refused("archive-differs"):
        archive.run()
    assert room.away() == ["two"]
    assert (room.store.folder / "scans" / "one").exists()
    with pytest.raises(OperationError):
        archive.fetch("scans", "three")


@pytest.mark.parametrize("name", ["scan.mcap", "manifest.json"])
def test_a_link_to_itself_in_the_archive_is_replaced(room: Room, copy: Path, name: str) -> None:
    (copy / name).unlink()
    (copy / name).symlink_to(name)
    assert room.archive().verify()
    assert room.archive().run() == 1
    assert room.archive().verify() == []


@pytest.mark.parametrize(
    "damage",
    [
        {"archived_at": "yesterday"},
        {"archived_at": "0001-01-01T00:00:00+14:00"},
        {"label": "\ud800"},
        {"id": "another"},
        {"files": [{"path": "a", "bytes": 10**30, "sha256": "0" * 64, "mtime_ns": 1}]},
        {"files": [{"path": "a", "bytes": 1, "sha256": "0" * 64, "mtime_ns": 10**30}]},
    ],
    ids=lambda damage: ascii(damage)[:30],
)
def test_an_unusable_manifest_is_none(place: Path, copy: Path, damage: dict[str, object]) -> None:
    manifest = copy / "manifest.json"
    changed = json.loads(manifest.read_text()) | damage
    manifest.write_text(json.dumps(changed))
    assert newest_manifest(FolderStore(place), "scans", "one") is None
    os.truncate(manifest, 1 << 42)
    assert newest_manifest(FolderStore(place), "scans", "one") is None

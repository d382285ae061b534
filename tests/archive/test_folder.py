"""An archive in a folder: what is copied, what comes back, and what may leave the disk."""

import errno
import os
import shutil
from collections.abc import Iterable
from dataclasses import replace
from datetime import timedelta
from pathlib import Path

import pytest

from crenel.archive.archive import Archive, ArchiveLook
from crenel.archive.notes import archive_lock, note_path
from crenel.archive.ownership import MARKER
from crenel.archive.planning import plan_copies
from crenel.archive.records import list_records
from crenel.archive.remote_store import FolderStore
from crenel.archive.store_errors import StoreError
from crenel.timestamps import is_moment
from tests.archive.filled import LATER, Room, add_session, content_of, lists_of
from tests.refusals import refused
from tests.store.conftest import FIGURES
from tests.store.test_verifications import FOUND


def test_everything_finished_is_copied_once_and_what_is_open_stays(room: Room) -> None:
    room.add_scan("one", 700_000)
    add_session(room.store, "calibration", "c1")
    add_session(room.store, "verification", "v1")
    add_session(room.store, "performance", "p1")
    add_session(room.store, "arm", "a1", ended=False)  # another one began after it
    add_session(room.store, "arm", "a2", ended=False)
    (room.store.folder / "scans/running").mkdir()
    (room.store.folder / "scans/running/scan.mcap").write_bytes(b"not finished")
    archive = room.archive()
    assert archive.state().waiting == 5
    assert archive.run() == 5
    manifests = room.manifests()
    assert {one.id for one in manifests} == {"one", "c1", "v1", "p1", "a1"}
    (scan,) = (one for one in manifests if one.id == "one")
    folder = room.store.folder / "scans/one"
    assert content_of(folder) == {
        file.path: (room.place / scan.folder / file.path).read_bytes() for file in scan.files
    }
    state = archive.state()
    assert (state.waiting, state.archived, state.away) == (0, 5, 0)
    assert archive.run() == 0


def test_a_changed_record_is_copied_beside_its_earlier_content(room: Room, archived: Path) -> None:
    (archived / "cloud.ply").write_bytes(b"computed again")
    assert room.archive().run() == 1
    assert len(room.manifests()) == 2


def test_an_interrupted_scan_waits_for_its_cloud(room: Room) -> None:
    folder = room.add_scan("cut", 1000)
    (folder / "cloud.ply").unlink()
    scan = room.store.scans.get("cut")
    assert scan is not None
    room.store.scans.delete("cut")
    room.store.scans.add(replace(scan, interrupted="the power failed"))
    assert room.archive().run() == 0
    assert room.archive(later=timedelta(days=2)).run() == 1


def test_an_old_record_leaves_the_disk_and_comes_back_as_it_was(room: Room) -> None:
    folder = room.add_scan("one", 600_000)
    before = content_of(folder)
    calibration = add_session(room.store, "calibration", "c1")
    room.archive(rules={"keep_days": 90}).run()
    assert folder.exists()
    later = room.archive(later=LATER, rules={"keep_days": 90})
    later.run()
    assert not folder.exists()
    assert calibration.exists()
    assert room.store.scans.get("one") is not None
    assert room.away() == ["one"]
    later.fetch("scans", "one")
    assert content_of(folder) == before
    assert room.away() == []
    # it is on the disk again, and archived already
    near = room.archive(later=timedelta(days=50), rules={"keep_days": 90})
    assert near.run() == 0
    assert folder.exists()
    with refused("archive-here"):
        near.fetch("scans", "one")


def test_the_oldest_leave_a_full_disk_first_but_none_on_its_first_day(room: Room) -> None:
    for name, days in (("old", 9), ("newer", 5)):
        for path in room.add_scan(name, 1000).iterdir():
            seconds = path.stat().st_mtime - days * 86_400
            os.utime(path, (seconds, seconds))
    room.add_scan("today", 1000)
    room.archive().run()
    room.archive(rules={"free_gb": 1e-6}).run()
    assert room.away() == []
    room.archive(rules={"free_gb": 900_000}).run()
    assert sorted(room.away()) == ["newer", "old"]
    assert (room.store.folder / "scans/today").exists()


@pytest.mark.usefixtures("archived")
def test_without_a_rule_nothing_leaves_the_disk(room: Room) -> None:
    room.archive(later=10 * LATER).run()
    assert room.away() == []


def test_verifications_of_the_calibrations_in_use_and_the_last_one_stay(room: Room) -> None:
    for calibration, sensor in (("c0", ""), ("c1", ""), ("c2", "blue")):
        folder = add_session(room.store, "calibration", calibration, ended=False)
        (folder / "calibration.json").write_text("{}")
        file = folder / "calibration.json"
        room.store.calibrations.accept(calibration, "name", file, FIGURES, None, sensor=sensor)
    verified = {"former": "c0", "used": "c1", "blue": "c2", "other": "", "last": ""}
    for name, of in verified.items():
        folder = add_session(room.store, "verification", name, ended=not of)
        if of:
            room.store.verifications.accept(name, of, folder, FOUND, None)
    room.archive().run()
    room.archive(later=LATER, rules={"keep_days": 90}).run()
    assert sorted(room.away()) == ["former", "other"]


def test_a_damaged_copy_is_made_again_and_the_record_stays(room: Room, archived: Path) -> None:
    (copy,) = room.place.glob("scans/one/*/scan.mcap")
    copy.write_bytes(bytes(1000))
    room.archive(later=LATER, rules={"keep_days": 90}).run()
    assert archived.exists()
    assert room.archive().run() == 1
    room.manifests()


def test_verify_names_what_is_damaged(room: Room) -> None:
    room.add_scan("one", 1000)
    room.add_scan("two", 1000)
    archive = room.archive()
    archive.run()
    assert archive.verify() == []
    (copy,) = room.place.glob("scans/two/*/cloud.ply")
    copy.unlink()
    assert archive.verify() == [copy.relative_to(room.place).as_posix()]
    assert archive.run() == 1
    assert archive.verify() == []


def test_a_look_names_what_is_missing_or_of_another_size(room: Room) -> None:
    for name in ("one", "two", "three"):
        room.add_scan(name, 1000)
    archive = room.archive()
    assert archive.look() == ArchiveLook([], "")
    assert list(room.place.iterdir()) == []
    archive.run()
    whole = archive.look()
    assert whole.incomplete == []
    assert is_moment(whole.read_at)
    (short,) = room.place.glob("scans/one/*/cloud.ply")
    short.write_bytes(b"")
    (record,) = room.place.glob("scans/two/*")
    shutil.rmtree(record)
    (manifest,) = room.place.glob("scans/three/*/manifest.json")
    manifest.unlink()
    names = [short, record / "cloud.ply", manifest]
    wanted = sorted(path.relative_to(room.place).as_posix() for path in names)
    assert sorted(archive.look().incomplete) == wanted
    shutil.rmtree(room.place)
    with pytest.raises(StoreError, match="is not there"):
        archive.look()


@pytest.mark.usefixtures("archived")
def test_a_note_that_is_lost_is_written_again_without_a_copy(room: Room) -> None:
    (copy,) = room.place.glob("scans/one/*/scan.mcap")
    written = copy.stat().st_mtime_ns
    note_path(room.store.folder, "scans", "one").unlink()
    assert room.archive().run() == 1
    assert copy.stat().st_mtime_ns == written


@pytest.mark.usefixtures("archived")
def test_an_archive_whose_disk_is_not_mounted_gets_nothing(room: Room) -> None:
    room.place.rename(room.place.with_name("elsewhere"))
    room.add_scan("two", 1000)
    for there in (False, True):  # no mount point, then an empty one
        if there:
            room.place.mkdir()
        with refused("archive-missing") as failed:
            room.archive().run()
        assert failed.value.remedy
    assert list(room.place.iterdir()) == []


class FullStore(FolderStore):
    """A folder whose disk is full after so many bytes. A real small disk needs an administrator."""

    def __init__(self, root: Path, room: int) -> None:
        super().__init__(root)
        self.room = room

    def write(self, name: str, pieces: Iterable[bytes], size: int) -> None:
        super().write(name, self._limited(pieces), size)

    def _limited(self, pieces: Iterable[bytes]) -> Iterable[bytes]:
        for piece in pieces:
            self.room -= len(piece)
            if self.room < 0:
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
            yield piece


def test_a_full_archive_keeps_what_is_whole_and_goes_on_with_more_room(room: Room) -> None:
    room.add_scan("one", 300_000)
    room.add_scan("two", 300_000)
    full = FullStore(room.place, 600_000)
    archive = room.archive(full)
    with refused("archive-full"):
        archive.run()
    assert [one.id for one in room.manifests()] == ["one"]
    assert not [name for name in content_of(room.place) if name.endswith(".part")]
    full.room = 10_000_000
    assert archive.run() == 1
    assert len(room.manifests()) == 2


def test_one_record_that_cannot_be_read_keeps_no_other_from_the_archive(room: Room) -> None:
    folder = room.add_scan("one", 1000)
    room.add_scan("two", 1000)
    growing = room.archive()
    records = list_records(room.store.folder, lists_of(room.store), growing._now())
    assert [one.id for one in plan_copies(records)] == ["one", "two"]

    class Growing(FolderStore):
        def size(self, name: str) -> int | None:
            if "scans/one" in name:
                with open(folder / "scan.mcap", "ab") as file:
                    file.write(b"more")
            return super().size(name)

    with refused("archive-changed"):
        room.archive(Growing(room.place)).run()
    assert [one.id for one in room.manifests()] == ["two"]


def test_a_link_in_a_record_keeps_it_on_the_disk(room: Room) -> None:
    folder = room.add_scan("one", 1000)
    (folder / "other").symlink_to("/etc/hostname")
    room.archive(later=LATER, rules={"keep_days": 1}).run()
    assert folder.exists()
    assert room.manifests() == []


def test_two_processes_do_not_copy_at_once(room: Room) -> None:
    archive: Archive = room.archive()
    with archive_lock(room.store.folder), refused("archive-busy"):
        archive.run()
    assert not (room.place / MARKER).exists()


def test_without_its_note_a_record_is_fetched_by_its_manifest(room: Room, archived: Path) -> None:
    before = content_of(archived)
    archive = room.archive()
    shutil.rmtree(archived)
    note_path(room.store.folder, "scans", "one").unlink()
    room.add_scan("two", 10)
    archive.run()
    archive.fetch("scans", "one")
    assert content_of(archived) == before
    (copy,) = room.place.glob("scans/one/*/scan.mcap")
    copy.write_bytes(bytes(1000))
    shutil.rmtree(archived)
    with refused("archive-differs"):
        archive.fetch("scans", "one")
    assert not archived.exists()
    with refused("archive-unknown"):
        archive.fetch("scans", "none")

"""The archive leaves out a cloud that can be made again, and keeps any other."""

import os
import shutil
from collections.abc import Callable, Iterator
from contextlib import closing
from datetime import timedelta
from pathlib import Path

import pytest

from crenel.archive.notes import note_path
from crenel.archive.records import is_without_its_cloud, list_records
from crenel.store.store import Store
from tests.archive.filled import LATER, Room, content_of, lists_of
from tests.batch.filled import CALIBRATION, FIRST, fill_station, write_recording

FILES = {"scan.mcap"}
WITH_CLOUD = {"scan.mcap", "cloud.ply"}
OLD = {"keep_days": 90.0}


@pytest.fixture
def store(tmp_path: Path) -> Iterator[Store]:
    with closing(fill_station(tmp_path / "data", ["one"])) as opened:
        yield opened


def folder_of(store: Store) -> Path:
    return store.folder / "scans/one"


def archived_files(room: Room) -> list[set[str]]:
    """Of each content of the scan."""
    manifests = [one for one in room.manifests() if one.kind == "scans"]
    ordered = sorted(manifests, key=lambda one: one.archived_at)
    return [{file.path for file in one.files} for one in ordered]


def archive_as_earlier(room: Room) -> None:
    """With the cloud, as earlier versions did."""
    session, hidden = (room.store.folder / name for name in (f"sessions/{CALIBRATION}", "hidden"))
    session.rename(hidden)
    room.archive().run()
    hidden.rename(session)
    assert archived_files(room) == [WITH_CLOUD]


def test_a_cloud_that_can_be_made_again_stays_on_the_station(room: Room) -> None:
    archive = room.archive()
    archive.run()
    assert archived_files(room) == [FILES]
    assert (archive.state().waiting, archive.state().archived) == (0, 2)
    assert archive.verify() == []
    (folder_of(room.store) / "cloud.ply").write_bytes(b"made again")
    assert archive.run() == 0


def cut_recording(store: Store) -> None:
    path = folder_of(store) / "scan.mcap"
    os.truncate(path, path.stat().st_size - 100)


def damage_recording(store: Store) -> None:
    path = folder_of(store) / "scan.mcap"
    content = bytearray(path.read_bytes())
    content[content.index(b"\x04\x22\x4d\x18") + 200] ^= 0xFF  # in the first packed chunk
    path.write_bytes(content)


def remove_recording(store: Store) -> None:
    (folder_of(store) / "scan.mcap").unlink()


def remove_calibration(store: Store) -> None:
    shutil.rmtree(store.folder / "sessions" / CALIBRATION)


@pytest.mark.parametrize(
    "spoil", [cut_recording, damage_recording, remove_recording, remove_calibration]
)
def test_an_irreplaceable_cloud_is_archived(room: Room, spoil: Callable[[Store], None]) -> None:
    spoil(room.store)
    before = content_of(folder_of(room.store))
    archive = room.archive()
    archive.run()
    (held,) = archived_files(room)
    assert held == set(before)
    assert "cloud.ply" in held
    room.archive(later=LATER, rules=OLD).run()
    assert not folder_of(room.store).exists()
    archive.fetch("scans", "one")
    assert content_of(folder_of(room.store)) == before


def test_a_scan_without_its_cloud_in_the_archive_leaves_and_comes_back(room: Room) -> None:
    recording = content_of(folder_of(room.store))["scan.mcap"]
    room.archive().run()
    room.archive(later=LATER, rules=OLD).run()
    assert room.away() == ["one"]
    room.archive().fetch("scans", "one")
    assert content_of(folder_of(room.store)) == {"scan.mcap": recording}
    assert is_without_its_cloud(room.store.folder, "one")
    (folder_of(room.store) / "cloud.ply").write_bytes(b"made again")
    assert not is_without_its_cloud(room.store.folder, "one")
    assert room.archive().run() == 0


def test_a_scan_whose_calibration_was_lost_later_stays_with_its_cloud(room: Room) -> None:
    room.archive().run()
    remove_calibration(room.store)
    note_path(room.store.folder, "sessions", CALIBRATION).unlink()
    room.archive(later=LATER, rules=OLD).run()
    assert set(content_of(folder_of(room.store))) == WITH_CLOUD


def test_a_cloud_that_an_earlier_version_archived_stays_there_and_comes_back(room: Room) -> None:
    before = content_of(folder_of(room.store))
    archive_as_earlier(room)
    note_path(room.store.folder, "scans", "one").unlink()
    archive = room.archive()
    archive.run()  # its note is written again
    assert archived_files(room) == [WITH_CLOUD]
    assert archive.state().waiting == 0
    room.store.scans.rename("one", "Housing 4711")
    archive.run()
    assert archived_files(room) == [WITH_CLOUD]
    room.archive(later=LATER, rules=OLD).run()
    archive.fetch("scans", "one")
    assert content_of(folder_of(room.store)) == before
    assert not is_without_its_cloud(room.store.folder, "one")


def test_the_archive_states_how_many_points_the_cloud_has(room: Room) -> None:
    room.archive().run()
    (scan,) = (one for one in room.manifests() if one.kind == "scans")
    assert scan.points == 5
    later = FIRST + timedelta(days=1)
    records = list_records(room.store.folder, lists_of(room.store), later)
    (record,) = (one for one in records if one.kind == "scans")
    assert record.is_cloud_left_out


def test_the_cloud_of_a_recording_without_frames_is_archived(room: Room) -> None:
    folder = folder_of(room.store)
    write_recording(folder / "other.mcap", 0).replace(folder / "scan.mcap")
    room.archive().run()
    assert archived_files(room) == [WITH_CLOUD]

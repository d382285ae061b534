"""Foreign names, times and files in a record or in its archive: each concerns that record only."""

import json
import os
from collections.abc import Callable
from pathlib import Path

import pytest

from app.archive.remote_store import FolderStore
from app.archive.transfer import newest_manifest
from app.errors import OperationError
from tests.archive.filled import LATER, Room
from tests.refusals import refused


@pytest.fixture
def copy(archived: Path, place: Path) -> Path:
    """The archive's folder of the scan ``one``."""
    (manifest,) = place.rglob("manifest.json")
    return manifest.parent


@pytest.mark.parametrize(
    "name", [b"Pr\xfcf.txt", b"\xfc/inner", b"a\\b", b"manifest.json", b"/".join([b"d" * 90] * 5)]
)
def test_a_file_name_that_no_manifest_can_hold_keeps_no_other_record_from_the_archive(
    room: Room, name: bytes
) -> None:
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
def test_a_manifest_that_says_nothing_usable_is_none(
    place: Path, copy: Path, damage: dict[str, object]
) -> None:
    manifest = copy / "manifest.json"
    changed = json.loads(manifest.read_text()) | damage
    manifest.write_text(json.dumps(changed))
    assert newest_manifest(FolderStore(place), "scans", "one") is None
    os.truncate(manifest, 1 << 42)
    assert newest_manifest(FolderStore(place), "scans", "one") is None

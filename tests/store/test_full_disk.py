"""A real full disk: it is distinguished from a broken database, and keeps nobody out."""

import contextlib
import os
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.store.accounts import Role
from crenel.store.backup import backup
from crenel.store.scans import ScanRecord
from crenel.store.store import Store
from tests.refusals import refused

pytestmark = pytest.mark.device

STARTED_MODULES = ()  # mount
DISK_FULL = message("stations-disk-full")


@pytest.fixture
def small(tmp_path: Path) -> Iterator[Path]:
    """A file system of 4 MB of its own."""
    place = tmp_path / "small"
    place.mkdir()
    mounting = ["mount", "-t", "tmpfs", "-o", "size=4m", "none", str(place)]
    if os.getuid() or subprocess.run(mounting, capture_output=True, check=False).returncode:
        pytest.skip("only root can mount a small file system")
    yield place
    subprocess.run(["umount", "-l", str(place)], check=True)


def fill(place: Path) -> Path:
    """Fills a disk to its last byte; the file to delete again."""
    filler = place / "filler"
    with filler.open("wb", buffering=0) as file, contextlib.suppress(OSError):
        while True:
            file.write(bytes(1 << 12))
    return filler


def keep_on(store: Store) -> None:
    """Until the disk does not take it."""
    while True:
        store.temperatures.add(20.0, "Anna")


def test_signing_in_the_audit_and_scans_outlive_a_full_disk(small: Path) -> None:
    store = Store(small / "data")
    store.accounts.add("Ada", Role.operator, "three unrelated words")
    filler = fill(small)
    with pytest.raises(OperationError, match="disk is full"):
        keep_on(store)
    token = store.login_sessions.begin("Ada", "tablet")
    visitor = store.login_sessions.principal(token)
    assert visitor is not None
    assert visitor.name == "Ada"
    store.login_sessions.remember_browser("", "Ada")
    store.audit.note("Ada", "::1", "signed in")
    folder = store.folder / "scans/one"
    scan = ScanRecord(
        "one", message("name-a-file"), folder, "2026-11-24T00:00:00", 7, 3, 1.0, "c", DISK_FULL, 9
    )
    store.scans.add(scan)
    assert store.scans.all() == [scan]
    assert store.scans.get("one") == scan
    with pytest.raises(OperationError, match="disk is full"):
        store.scans.add_waiting()
    filler.unlink()
    store.scans.add_waiting()
    store.audit.note("Ada", "::1", message("rename"))
    assert [entry.act for entry in store.audit.newest(9)] == [message("rename"), "signed in"]
    assert store.scans.all() == [scan]
    store.login_sessions.end(token)
    assert store.login_sessions.principal(token) is None
    store.close()


def test_a_full_disk_is_no_broken_database(small: Path) -> None:
    Store(small / "data").close()
    filler = fill(small)
    with refused("disk-full") as failed:
        Store(small / "data").close()
    assert "Free some space" in str(failed.value.remedy)
    assert "backup" not in failed.value.line
    filler.unlink()
    Store(small / "data").close()


def test_a_backup_that_finds_no_space_leaves_nothing(small: Path, tmp_path: Path) -> None:
    store = Store(tmp_path / "data")
    (store.folder / "scans/cloud.ply").write_bytes(os.urandom(5_000_000))
    with refused("disk-full"):
        backup(store.folder, small / "copy")
    assert list(small.iterdir()) == []
    store.close()

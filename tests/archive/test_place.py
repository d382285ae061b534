"""Where an archive lies: apart from the records, whatever the names of both."""

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from crenel.archive.archive_settings import ArchiveSettings
from crenel.archive.place import check_apart
from crenel.batch.results import check_results_apart
from crenel.errors import OperationError
from crenel.formats.file_modes import private_files
from crenel.formats.real_folders import share_disk
from crenel.store.store import Store
from tests.archive.filled import add_scan, archive_of, content_of
from tests.refusals import refused


def linked(link: Path, to: Path) -> str:
    to.mkdir(parents=True, exist_ok=True)
    link.parent.mkdir(exist_ok=True)
    link.symlink_to(to)
    return str(link)


def link_away(data: Path, to: Path) -> Path:
    """The folder of the scans becomes a link, as for a larger disk."""
    to.parent.mkdir(exist_ok=True)
    (data / "scans").rename(to)
    (data / "scans").symlink_to(to)
    return to


PLACES: dict[str, Callable[[Path, Path], str]] = {
    "itself": lambda data, _: str(data),
    "a folder in it": lambda data, _: linked(data / "gauges/copies", data / "gauges/real"),
    "its notes": lambda data, _: str(data / "archive"),
    "its scans": lambda data, _: str(data / "scans"),
    "by ..": lambda data, _: f"{data}/../{data.name}/new",
    "by a link": lambda data, top: linked(top / "link", data / "scans"),
    "by a link that leads nowhere yet": lambda data, top: _dangling(top / "link", data / "later"),
    "around it": lambda data, _: str(data.parent),
    "file://": lambda data, _: f"file://{data}/archive",
    "local://, by a link": lambda data, top: f"local://{linked(top / 'link', data)}/archive",
    "scans that are a link": lambda data, top: str(link_away(data, top / "big/scans") / "new"),
    "around scans that are a link": lambda data, top: str(
        link_away(data, top / "big/scans").parent
    ),
    "a link to the scans in it": lambda data, top: str(
        Path(linked(top / "other/scans", data / "scans")).parent
    ),
}


def _dangling(link: Path, to: Path) -> str:
    link.symlink_to(to)
    return str(link)


@pytest.mark.parametrize("place", PLACES)
def test_an_archive_and_the_records_that_lie_in_one_another_are_refused_and_nothing_is_written(
    store: Store, tmp_path: Path, place: str
) -> None:
    add_scan(store, "one", 1000)
    archive = archive_of(store, PLACES[place](store.folder, tmp_path), rules={"keep_days": 1})
    before = content_of(tmp_path)
    for use in (archive.run, archive.verify, archive.look):
        with refused("archive-inside"):
            use()
    with pytest.raises(OperationError):
        archive.fetch("scans", "two")
    assert content_of(tmp_path) == before


def test_a_folder_under_another_name_by_a_second_mount_is_the_same(
    monkeypatch: pytest.MonkeyPatch, store: Store, place: Path
) -> None:
    settings = ArchiveSettings.model_construct(url=str(place / "new"))
    check_apart(settings, store.folder)
    own, real = os.stat(store.folder / "scans"), Path.stat
    # as with a bind mount, which only the administrator of a machine can make
    monkeypatch.setattr(
        Path, "stat", lambda path, **given: own if path == place else real(path, **given)
    )
    with refused("archive-inside"):
        check_apart(settings, store.folder)


@pytest.mark.parametrize("mode", [0o700, 0o755, 0o2775])
def test_copies_are_readable_as_their_folder_is(store: Store, place: Path, mode: int) -> None:
    add_scan(store, "one", 1000)
    place.chmod(mode)
    with private_files():
        archive_of(store, str(place)).run()
    copied = list(place.rglob("*"))
    assert any(path.name == "scan.mcap" for path in copied)
    for path in copied:
        most = 0o755 if path.is_dir() else 0o644
        assert path.stat().st_mode & 0o777 == mode & most, path


def test_results_are_not_written_into_records_by_other_names(store: Store, tmp_path: Path) -> None:
    data = ArchiveSettings.model_construct(url=str(store.folder))
    check_results_apart(ArchiveSettings.model_construct(url=str(tmp_path)), [data])
    scans = link_away(store.folder, tmp_path / "big/scans")
    for url in (f"file://{store.folder}/new", linked(tmp_path / "a", store.folder), str(scans)):
        with refused("output-is-source"):
            check_results_apart(ArchiveSettings.model_construct(url=url), [data])


def test_parts_of_one_disk_are_one_disk(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    block, devices = tmp_path / "block", tmp_path / "devices"
    block.mkdir()
    for device in ("sda/sda1", "sda/sda2", "sdb/sdb1", "dm-0/slaves"):
        (devices / device).mkdir(parents=True)
    for partition in ("sda/sda1", "sda/sda2", "sdb/sdb1"):
        (devices / partition / "partition").touch()
    (devices / "dm-0/slaves/sda2").symlink_to(devices / "sda/sda2")
    numbers = {"sda/sda1": 1, "sda/sda2": 2, "sdb/sdb1": 17, "dm-0": 253}
    for device, minor in numbers.items():
        (block / f"8:{minor}").symlink_to(devices / device)
        (tmp_path / device.replace("/", "-")).mkdir()
    real = Path.stat

    def stat(path: Path, **given: bool) -> os.stat_result:
        found, device = real(path, **given), path.name.replace("-", "/", 1)
        minor = numbers.get(path.name, numbers.get(device))
        if path.parent != tmp_path or minor is None:
            return found
        return os.stat_result([*found[:2], os.makedev(8, minor), *found[3:10]])

    monkeypatch.setattr("crenel.formats.real_folders.BLOCK_DEVICES", block)
    monkeypatch.setattr(Path, "stat", stat)
    folders = {device: tmp_path / device.replace("/", "-") for device in numbers}
    shared = {
        (one, other)
        for one in numbers
        for other in numbers
        if one < other and share_disk(folders[one], folders[other])
    }
    assert shared == {("sda/sda1", "sda/sda2"), ("dm-0", "sda/sda1"), ("dm-0", "sda/sda2")}

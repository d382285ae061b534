"""Files are whole or not there; whatever lies under a name, reading it ends and says what it is."""

import errno
import os
import signal
import socket
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path

import pytest

from crenel.errors import OperationError
from crenel.formats.atomic_write import atomic_file, check_output_path, write_atomically
from crenel.formats.clouds.files import read_cloud
from crenel.formats.clouds.pieces import read_cloud_pieces
from crenel.formats.csv_table import read_table
from crenel.formats.datasheets.arm import read_arm
from crenel.formats.file_names import display_path, register_data_folder, unregister_data_folder
from crenel.formats.images import image_size, read_grey
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.json_document import file_sha256, read_text
from crenel.formats.open_file import LARGEST_DOCUMENT
from crenel.formats.recording.reader import find_damage, length_ns, open_recording
from crenel.settings.station_toml import read_settings
from crenel.store.backup import last_backup
from crenel.store.store import SettingsStore
from crenel.supervision.webhook import WebhookStore
from tests.refusals import refused_as


def device(path: Path) -> None:
    path.symlink_to("/dev/zero")


def unix_socket(path: Path) -> None:
    here = Path.cwd()
    os.chdir(path.parent)  # a socket's name is short
    try:
        with closing(socket.socket(socket.AF_UNIX)) as listening:
            listening.bind(path.name)
    finally:
        os.chdir(here)


def circle(path: Path) -> None:
    path.symlink_to(path)


def endless(path: Path) -> None:
    path.touch()
    os.truncate(path, LARGEST_DOCUMENT + 1)


Make = Callable[[Path], None]
Read = Callable[[Path], object]
ODD: tuple[Make, ...] = (os.mkfifo, device, unix_socket, Path.mkdir, circle)
READERS: tuple[Read, ...] = (
    read_text,
    file_sha256,
    read_arm,
    read_grey,
    image_size,
    read_cloud,
    lambda path: list(read_cloud_pieces(path)),
    lambda path: list(open_recording(path).records()),
    length_ns,
    lambda path: read_table(path, ()),
    read_settings,
)


@pytest.fixture(autouse=True)
def ends() -> Iterator[None]:
    def late(signum: int, frame: object) -> None:
        raise TimeoutError("reading does not end")

    before = signal.signal(signal.SIGALRM, late)
    signal.alarm(20)
    yield
    signal.alarm(0)
    signal.signal(signal.SIGALRM, before)


@pytest.mark.parametrize("make", ODD)
@pytest.mark.parametrize("read", READERS)
def test_what_is_no_ordinary_file_is_refused(make: Make, read: Read, tmp_path: Path) -> None:
    path = tmp_path / "there"
    make(path)
    with pytest.raises(OperationError) as refused:
        read(path)
    assert "there" in str(refused.value.what)
    assert refused.value.why


@pytest.mark.parametrize("read", [read_text, read_arm, read_grey])
def test_a_file_that_no_memory_should_hold_is_refused(read: Read, tmp_path: Path) -> None:
    endless(tmp_path / "large")
    with refused_as("file-too-large"):
        read(tmp_path / "large")


@pytest.mark.parametrize("make", [*ODD, endless])
def test_what_the_station_keeps_for_itself_is_done_without(make: Make, tmp_path: Path) -> None:
    for name in ("last_backup.json", "scan_settings.json", "notifications.json", "scan.mcap"):
        make(tmp_path / name)
    assert last_backup(tmp_path) is None
    assert WebhookStore(tmp_path).read().url == ""
    settings = SettingsStore(tmp_path)
    settings.read()
    assert make is circle or settings.trouble is not None
    assert find_damage(tmp_path / "scan.mcap")


def test_files_of_an_open_data_folder_are_named_as_from_it(tmp_path: Path) -> None:
    inside, outside = tmp_path / "data" / "arms" / "a.json", tmp_path / "data2" / "a.json"
    register_data_folder(tmp_path / "data")
    try:
        assert display_path(inside) == "arms/a.json"
        assert display_path(tmp_path / "data") == "data"
        assert display_path(outside) == str(outside)
        with pytest.raises(OperationError, match=r"^arms/a\.json: there is no such file"):
            read_arm(inside)
    finally:
        unregister_data_folder(tmp_path / "data")
    assert display_path(inside) == str(inside)


def test_a_name_of_any_bytes_is_shown_in_one_line_of_text() -> None:
    odd = Path(os.fsdecode(b"Pr\xfcf\n\x1b[2Jk\xe2\x80\xa8\xe2\x80\xae.json"))
    assert display_path(odd) == r"Pr\udcfcf\x0a\x1b[2Jk\u2028\u202e.json"
    assert len(display_path("a" * 10_000)) < 300


def names_in(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def test_content_arrives_and_nothing_else_is_left(tmp_path: Path) -> None:
    write_atomically(tmp_path / "a", b"one")
    write_atomically(tmp_path / "a", b"two")
    assert (tmp_path / "a").read_bytes() == b"two"
    assert names_in(tmp_path) == ["a"]


@pytest.mark.parametrize("error", [RuntimeError, KeyboardInterrupt, SystemExit])
def test_a_failure_leaves_what_was_there(tmp_path: Path, error: type[BaseException]) -> None:
    (tmp_path / "a").write_bytes(b"old")

    def fail_halfway() -> None:
        with atomic_file(tmp_path / "a") as file:
            file.write(b"half")
            raise error

    with pytest.raises(error):
        fail_halfway()
    assert (tmp_path / "a").read_bytes() == b"old"
    assert names_in(tmp_path) == ["a"]


def test_the_name_appears_only_at_the_end(tmp_path: Path) -> None:
    with atomic_file(tmp_path / "a") as file:
        file.write(b"half")
        assert not (tmp_path / "a").exists()
    assert (tmp_path / "a").read_bytes() == b"half"


def test_a_full_disk_is_a_refusal(tmp_path: Path) -> None:
    with refused_as("disk-full", "disk is full"), atomic_file(tmp_path / "a"):
        raise OSError(errno.ENOSPC, "No space left on device")
    assert names_in(tmp_path) == []


def test_a_link_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "real").write_bytes(b"old")
    (tmp_path / "link").symlink_to("real")
    write_atomically(tmp_path / "link", b"new")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "real").read_bytes() == b"new"


def test_a_link_to_itself_is_replaced(tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to("link")
    write_atomically(tmp_path / "link", b"new")
    assert (tmp_path / "link").read_bytes() == b"new"


def test_permissions_are_those_of_any_new_file(tmp_path: Path) -> None:
    (tmp_path / "plain").touch()
    write_atomically(tmp_path / "a", b"")
    assert (tmp_path / "a").stat().st_mode == (tmp_path / "plain").stat().st_mode


@pytest.mark.parametrize("name", ["folder", "no/such/a", "pipe", "plain/a"])
def test_places_that_take_no_file_are_refused(tmp_path: Path, name: str) -> None:
    (tmp_path / "folder").mkdir()
    (tmp_path / "plain").touch()
    os.mkfifo(tmp_path / "pipe")
    before = names_in(tmp_path)
    with pytest.raises(OperationError, match=str(tmp_path / name)):
        check_output_path(tmp_path / name)
    with pytest.raises(OperationError):
        write_atomically(tmp_path / name, b"x")
    assert names_in(tmp_path) == before


@pytest.mark.parametrize("number", [errno.ENOENT, errno.EACCES, errno.EROFS, errno.EIO])
def test_errors_of_the_system_are_reported_in_words(number: int) -> None:
    with (
        pytest.raises(OperationError, match=r"some\.file: .") as refused,
        convert_io_errors("some.file"),
    ):
        raise OSError(number, os.strerror(number))
    assert "Errno" not in refused.value.line

"""Finding devices: what the kernel lists, finders of other packages, and finders that fail."""

import os
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from crenel_hardware.device_files import find_serial_ports, permission_error
from crenel_hardware.discovery import FoundDevice, find_devices
from crenel_hardware.errors import DeviceError
from crenel_hardware.sensor.find_cameras import find_cameras
from tests.hardware.test_registry import install

pytestmark = [
    pytest.mark.device,
    pytest.mark.skipif(sys.platform != "linux", reason="device files of Linux"),
]

MODULE = "finders_of_tests"
FIND_ONE = (
    "from crenel_hardware.discovery import FoundDevice\n"
    "def find():\n    return [FoundDevice('sensor', 'folder', 'Bench', {'path': '/pictures'})]\n"
)


@pytest.fixture
def finder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """The file of an installed package whose function ``find`` is a finder."""
    monkeypatch.syspath_prepend(tmp_path)
    install(tmp_path, "bench-finder", "crenel.finders", f"bench = {MODULE}:find")
    sys.modules.pop(MODULE, None)
    yield tmp_path / f"{MODULE}.py"
    sys.modules.pop(MODULE, None)


def errors(deadline_s: float = 20) -> list[DeviceError]:
    return [one for one in find_devices(deadline_s) if isinstance(one, DeviceError)]


def test_the_finder_of_another_package_is_asked(finder: Path) -> None:
    finder.write_text(FIND_ONE)
    expected = FoundDevice("sensor", "folder", "Bench", {"path": "/pictures"})
    assert expected in find_devices(20)


def test_a_device_that_is_found_twice_counts_once(finder: Path) -> None:
    finder.write_text(FIND_ONE.replace("return [", "return 2 * ["))
    titles = [one.title for one in find_devices(20) if isinstance(one, FoundDevice)]
    assert titles.count("Bench") == 1


@pytest.mark.parametrize(
    ("source", "words"),
    [
        ("import a_module_that_is_nowhere", "ModuleNotFoundError"),
        ("def find():\n    raise OSError('no such bus')", "OSError: no such bus"),
        ("def find():\n    return None", "TypeError"),
    ],
)
def test_a_finder_that_fails_is_named(finder: Path, source: str, words: str) -> None:
    finder.write_text(source)
    (failure,) = [one for one in errors() if "bench-finder" in str(one.what)]
    assert words in str(failure.what)
    assert failure.remedy


def test_a_finder_reports_a_missing_library_itself(finder: Path) -> None:
    finder.write_text(
        "from crenel_hardware.errors import DeviceError\n"
        "def find():\n    return [DeviceError('no libbench', 'apt install libbench')]\n"
    )
    assert [one.remedy for one in errors() if one.what == "no libbench"] == ["apt install libbench"]


def test_a_finder_that_hangs_is_late_once_and_is_not_started_twice(finder: Path) -> None:
    finder.write_text(
        "import threading\n"
        "started, go_on = [], threading.Event()\n"
        "def find():\n    started.append(1)\n    go_on.wait()\n    return []\n"
    )
    for _ in range(2):
        assert any("bench" in str(one.what) for one in errors(0.5))
    module = sys.modules[MODULE]
    assert module.started == [1]
    module.go_on.set()
    assert not any("bench" in str(one.what) for one in errors())


def lay_out(root: Path, node: str, name: str, index: int) -> None:
    folder = root / "sys" / node
    folder.mkdir(parents=True)
    (folder / "name").write_text(f"{name}\n")
    (folder / "index").write_text(f"{index}\n")
    (root / "dev").mkdir(exist_ok=True)
    (root / "dev" / node).touch()


def test_cameras_are_the_first_nodes_of_real_cameras(tmp_path: Path) -> None:
    lay_out(tmp_path, "video0", "UVC Camera", 0)
    lay_out(tmp_path, "video1", "UVC Camera", 1)
    lay_out(tmp_path, "video10", "bcm2835-codec-decode", 0)
    lay_out(tmp_path, "video2", "USB3 Vision", 0)
    by_id = tmp_path / "dev" / "v4l" / "by-id"
    by_id.mkdir(parents=True)
    lasting = by_id / "usb-maker-camera-index0"
    lasting.symlink_to("../../video2")
    first, second = find_cameras(tmp_path / "dev", tmp_path / "sys")
    assert isinstance(first, FoundDevice)
    assert isinstance(second, FoundDevice)
    assert (first.driver, first.options) == ("opencv", {"source": str(tmp_path / "dev/video0")})
    assert str(first.title) == f"UVC Camera · {tmp_path / 'dev/video0'}"
    assert second.options == {"source": str(lasting)}


def test_a_machine_without_cameras_has_none(tmp_path: Path) -> None:
    assert find_cameras(tmp_path, tmp_path) == []


def test_every_serial_port_found_is_one_of_this_machine() -> None:
    for found in find_serial_ports():
        if isinstance(found, FoundDevice):
            assert (found.kind, found.driver) == ("arm", "bridge")
            assert Path(str(found.options["url"])).exists()


def test_a_foreign_port_names_the_group(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    port = tmp_path / "ttyUSB0"
    port.touch()
    assert permission_error(port, "Adapter") is None
    monkeypatch.setattr(os, "access", lambda path, mode: False)
    for group, remedy in (("dialout", "sudo usermod -aG dialout "), ("root", "administrator")):
        monkeypatch.setattr(Path, "group", lambda path, group=group: group)
        refused = permission_error(port, "Adapter")
        assert refused is not None
        assert "may not open" in str(refused.what)
        assert remedy in str(refused.remedy)

"""Finding industrial cameras: in a network without others, on USB, and without the library."""

import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from crenel_hardware.errors import DeviceError
from crenel_hardware.sensor.genicam import aravis
from crenel_hardware.sensor.genicam.driver import from_options
from crenel_hardware.sensor.genicam.find_genicam import find_forbidden_cameras, find_genicam

pytestmark = [pytest.mark.device, pytest.mark.xdist_group("gige")]

IN_A_NETWORK = """
from crenel_hardware.discovery import FoundDevice
from crenel_hardware.sensor.genicam.driver import from_options
from crenel_hardware.sensor.genicam.find_genicam import find_genicam
from tests.hardware.reading import next_frame, open_in_time
from tests.hardware.fake_cameras import AravisFake

assert find_genicam() == []
fake = AravisFake("-s", "GV42")
(found,) = find_genicam()
assert isinstance(found, FoundDevice)
print(found.kind, found.driver, found.title, dict(found.options))
for options in (found.options, {"serial_number": "GV42"}, {}):
    driver = from_options({**options, "region": [0, 0, 320, 240]})
    print(open_in_time(driver).serial_number, next_frame(driver).image.shape)
    driver.close()
try:
    from_options({"serial_number": "4711"}).open()
except Exception as error:
    print(error)
fake.stop()
"""


@pytest.fixture
def without_aravis(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setattr(aravis, "_SONAMES", ("libaravis-of-nowhere.so.0",))
    monkeypatch.setattr(aravis, "_LIBRARY_NAMES", ())
    aravis.load_aravis.cache_clear()
    yield
    aravis.load_aravis.cache_clear()


def test_a_missing_library_is_named_with_its_package(without_aravis: None) -> None:
    (found,) = find_genicam()
    assert isinstance(found, DeviceError)
    with pytest.raises(DeviceError) as caught:
        from_options({"address": "127.0.0.1"}).open()
    for error in (found, caught.value):
        assert "Aravis" in str(error.what)
        assert "libaravis-0.8-0" in str(error.remedy)


def test_cameras_are_found_by_a_search_and_opened_by_what_was_found() -> None:
    """In a network of its own, so that no other device hears the search."""
    inside = ["unshare", "--net", "sh", "-c", 'ip link set lo up && exec "$@"', "sh"]
    if any(shutil.which(program) is None for program in ("unshare", "ip")):
        pytest.skip("util-linux or iproute2 is not installed")
    if subprocess.run([*inside, "true"], capture_output=True, check=False).returncode:
        pytest.skip("this user may not make a network")
    if shutil.which("arv-fake-gv-camera-0.8") is None:
        pytest.skip("aravis-tools is not installed")
    done = subprocess.run(
        [*inside, sys.executable, "-c", IN_A_NETWORK],
        cwd=Path(__file__).parents[2],
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert lines[0] == ("sensor genicam Aravis · Fake · GV42 · 127.0.0.1 {'address': '127.0.0.1'}")
    assert lines[1:4] == 3 * ["GV42 (240, 320)"]
    assert "The camera 4711 was not found. Available cameras: Fake GV42" in lines[4]


def lay_out(root: Path, name: str, subclass: str, number: int) -> Path:
    device, interface = root / "sys" / name, root / "sys" / f"{name}:1.0"
    for folder in (device, interface):
        folder.mkdir(parents=True)
    for path, text in (
        (device / "busnum", "2"),
        (device / "devnum", str(number)),
        (device / "product", "Stripe camera"),
        (interface / "bInterfaceClass", "ef"),
        (interface / "bInterfaceSubClass", subclass),
        (interface / "bInterfaceProtocol", "00"),
    ):
        path.write_text(f"{text}\n")
    node = root / "dev" / "002" / f"{number:03}"
    node.parent.mkdir(parents=True, exist_ok=True)
    node.touch()
    return node


def test_anothers_usb_camera_is_reported(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    node = lay_out(tmp_path, "2-1", "05", 7)
    lay_out(tmp_path, "2-2", "02", 8)
    assert list(find_forbidden_cameras(tmp_path / "dev", tmp_path / "sys")) == []
    monkeypatch.setattr(os, "access", lambda path, mode: False)
    (refused,) = find_forbidden_cameras(tmp_path / "dev", tmp_path / "sys")
    assert "Stripe camera" in str(refused.what)
    assert str(node) in str(refused.what)
    assert refused.remedy

"""Writing a device into station.toml: what else people wrote there stays."""

import tomllib
from pathlib import Path
from typing import Any

import pytest

from app.errors import OperationError
from app.settings.device_tables import write_device
from app.settings.settings import DeviceTable
from app.settings.station_toml import read_settings

FILE = """# Measuring room 2
[station]
name = "Room 2"   # by the window

[arm]
driver = "serial-encoder"  # own firmware
# the port of the left adapter
url = "/dev/ttyUSB0"       # left

# stricter than usual
[limits]
good_um = 30 # agreed with the customer
"""


def table(driver: str, label: str = "", **options: Any) -> DeviceTable:
    return DeviceTable(driver=driver, label=label, **options)


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "station.toml"
    path.write_text(FILE)
    return path


def test_a_changed_option_leaves_every_comment(file: Path) -> None:
    write_device(file, "arm", table(driver="serial-encoder", url="/dev/ttyUSB1"))
    assert file.read_text() == FILE.replace("ttyUSB0", "ttyUSB1")


def test_a_new_option_follows_the_others_of_its_table(file: Path) -> None:
    write_device(file, "arm", table("serial-encoder", url="/dev/ttyUSB0", joint_count=6))
    last = 'url = "/dev/ttyUSB0"       # left\n'
    assert file.read_text() == FILE.replace(last, f"{last}joint_count = 6\n")


def test_another_driver_has_only_its_own_options(file: Path) -> None:
    write_device(file, "arm", table(driver="bench", label="Old arm", port=3))
    arm = tomllib.loads(file.read_text())["arm"]
    assert arm == {"driver": "bench", "label": "Old arm", "port": 3}
    assert "# stricter than usual\n[limits]" in file.read_text()


def test_a_new_table_is_read_as_it_was_written(file: Path) -> None:
    options = {"exposure_range_us": [100.0, 2e4], "loop": True}
    camera = table("opencv", 'The "left" one', source="rtsp://10.0.0.9/stream", **options)
    write_device(file, "sensor", camera)
    assert file.read_text().startswith(FILE)
    assert read_settings(file).sensor == camera


def test_a_file_is_created_with_its_folder(tmp_path: Path) -> None:
    path = tmp_path / "data" / "station.toml"
    write_device(path, "sensor", table(driver="opencv", source=0))
    assert path.read_text() == '[sensor]\ndriver = "opencv"\nsource = 0\n'
    assert read_settings(path).arm is None
    assert [one.name for one in path.parent.iterdir()] == ["station.toml"]


def test_the_file_before_is_kept(file: Path) -> None:
    write_device(file, "sensor", table(driver="opencv", source=0))
    assert file.with_name("station.toml.backup").read_text() == FILE


def test_a_device_is_taken_out(file: Path) -> None:
    write_device(file, "arm", None)
    assert read_settings(file).devices == {}
    assert "good_um = 30 # agreed with the customer" in file.read_text()


@pytest.mark.parametrize(
    "text",
    ["[arm\n", 'arm = "serial-encoder"\n[station]\nnam = "x"\n', "[station]\nname = 5\n"],
)
def test_a_file_with_an_error_stays_as_it_is(file: Path, text: str) -> None:
    file.write_text(text)
    with pytest.raises(OperationError) as caught:
        write_device(file, "sensor", table(driver="opencv", source=0))
    assert caught.value.code == "settings-not-valid"
    assert file.read_text() == text
    assert [one.name for one in file.parent.iterdir()] == ["station.toml"]

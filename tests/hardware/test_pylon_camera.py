"""The pylon driver on Basler's own emulation, where its library is installed."""

import os
import sys
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import SensorDriver
from crenel_hardware.sensor.pylon_camera import from_options
from tests.hardware.conformance import SensorBench, SensorConformance
from tests.hardware.reading import next_frame

EMULATION = "PYLON_CAMEMU"
REGION = [0, 0, 320, 240]


def options(**more: object) -> dict[str, object]:
    return {"region": REGION, "rate_hz": 50.0, "exposure_us": 2000.0, **more}


@pytest.fixture
def emulation(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("pypylon", exc_type=ImportError)
    monkeypatch.setenv(EMULATION, "2")


class EmulationBench(SensorBench):
    def __init__(self, table: Mapping[str, object]) -> None:
        self._driver = from_options(table)

    def driver(self) -> SensorDriver:
        return self._driver

    def unplug(self) -> None:
        """Only before it is opened; the emulation of an open camera goes on."""
        del os.environ[EMULATION]

    def plug_in(self) -> None:
        os.environ[EMULATION] = "2"


class TestPylonEmulation(SensorConformance):
    @pytest.fixture
    def bench(self, emulation: None) -> SensorBench:
        return EmulationBench(options(laser_line="Line2"))

    def test_loss_is_an_error_until_opened(self, bench: SensorBench, driver: SensorDriver) -> None:
        pytest.skip("an emulated camera that is open cannot be unplugged")


def show(**more: object) -> tuple[Any, Any]:
    driver = from_options(options(**more))
    info, frame = driver.open(), next_frame(driver)
    driver.close()
    return info, frame


def test_deep_pictures_state_their_full_scale(emulation: None) -> None:
    _, frame = show(pixel_format="Mono12")
    assert frame.image.dtype == np.uint16
    assert frame.full_scale == 4095
    assert frame.image.max() <= 4095


def test_a_region_is_a_part_of_the_sensor(emulation: None) -> None:
    info, frame = show(region=[64, 32, 640, 100])
    assert frame.image.shape == (info.height_px, info.width_px) == (100, 640)
    info, _ = show(region=None, rate_hz=5.0)
    assert (info.width_px, info.height_px) == (4096, 4096)


def test_a_camera_is_chosen_by_its_serial_number(emulation: None) -> None:
    info, _ = show(serial_number="0815-0001")
    assert info.serial_number == "0815-0001"
    with pytest.raises(DeviceError, match="The camera 4711 was not found"):
        from_options(options(serial_number="4711")).open()


def test_a_camera_that_waits_for_its_trigger_is_silent_and_there(emulation: None) -> None:
    driver = from_options(options(trigger="Line1", trigger_edge="falling"))
    info = driver.open()
    assert not info.free_running
    assert (info.width_px, info.height_px) == (320, 240)
    assert driver.read(0.5) is None
    assert driver.is_alive()
    driver.close()
    assert not driver.is_alive()


@pytest.mark.parametrize(
    ("table", "words"),
    [
        ({"pixel_format": "Mono11"}, "pixel_format = Mono11; it offers Mono8, Mono10"),
        ({"exposure_us": 1e9}, r"exposure_us = 1e\+09"),
        ({"trigger": "Line9"}, "trigger = Line9; it offers Software, Line1"),
        ({"laser_line": "Line9"}, "laser_line = Line9; it offers Line1, Line2, Line3"),
        ({"region": [0, 0, 5000, 10]}, "region"),
    ],
)
def test_what_it_cannot_do_is_said(emulation: None, table: dict[str, object], words: str) -> None:
    with pytest.raises(DeviceError, match=words) as caught:
        from_options(options(**table)).open()
    assert caught.value.remedy


def test_a_missing_library_is_named_with_its_extra(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pypylon", None)
    with pytest.raises(DeviceError) as caught:
        from_options({}).open()
    assert "pypylon" in str(caught.value.what)
    assert 'pip install "crenel[pylon]"' in str(caught.value.remedy)

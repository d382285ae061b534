"""The gentl driver on Viky, the simulated camera in EMVA's own package."""

import sys
import threading
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest

from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import SensorDriver
from crenel_hardware.sensor.gentl_camera import (
    PRODUCER_PATH,
    GentlFeatures,
    GentlOptions,
    GentlSource,
    find_producers,
    from_options,
)
from crenel_hardware.sensor.image_source import GrabbedImage
from tests.hardware.conformance import SensorBench, SensorConformance
from tests.hardware.reading import next_frame, open_in_time

pytestmark = pytest.mark.device


@pytest.fixture
def producer() -> Path:
    pytest.importorskip("harvesters.core")
    genicam = pytest.importorskip("genicam")
    return Path(genicam.__file__).parent / "viky.cti"


class VikyBench(SensorBench):
    """Taking the producer away unplugs the camera, as long as it is not open."""

    def __init__(self, producer: Path, folder: Path) -> None:
        self._producer = producer
        self._link = folder / "camera.cti"
        self.plug_in()
        self._driver = from_options({"producer": str(self._link), "rate_hz": 50.0})

    def driver(self) -> SensorDriver:
        return self._driver

    def unplug(self) -> None:
        self._link.unlink()

    def plug_in(self) -> None:
        self._link.symlink_to(self._producer)


class TestViky(SensorConformance):
    @pytest.fixture
    def bench(self, producer: Path, tmp_path: Path) -> SensorBench:
        return VikyBench(producer, tmp_path)

    def test_loss_is_an_error_until_opened(self, bench: SensorBench, driver: SensorDriver) -> None:
        pytest.skip("this simulated camera cannot be unplugged while it is open")


def test_a_camera_is_chosen_by_its_serial_number(producer: Path) -> None:
    with closing(from_options({"producer": str(producer), "serial_number": "2"})) as driver:
        assert open_in_time(driver).serial_number == "2"
        frame = next_frame(driver)
    assert frame.image.dtype == np.uint8
    assert frame.full_scale == 255
    with pytest.raises(DeviceError, match="The camera 4711 was not found"):
        from_options({"producer": str(producer), "serial_number": "4711"}).open()


def test_a_camera_of_calibrated_points_sends_pictures_alone(producer: Path) -> None:
    """Viky's points are in millimetres (CalibratedABC_Grid)."""
    with closing(from_options({"producer": str(producer)})) as driver:
        assert driver.open().delivers == {"picture"}
        with pytest.raises(DeviceError, match="pictures alone"):
            driver.set_delivery("line")
        next_frame(driver)


def test_a_region_is_a_part_of_the_sensor(producer: Path) -> None:
    with closing(from_options({"producer": str(producer), "region": [0, 0, 300, 200]})) as driver:
        info = driver.open()
        assert next_frame(driver).image.shape == (info.height_px, info.width_px) == (200, 300)


def next_image(source: GentlSource) -> GrabbedImage:
    while not isinstance(grabbed := source.grab(), GrabbedImage):
        pass
    return grabbed


def test_a_stopped_camera_starts_again_with_larger_buffers(producer: Path) -> None:
    """As it is when a camera changes between pictures and lines."""
    options = GentlOptions(producer=str(producer), region=[0, 0, 300, 200])
    source = GentlSource("camera", options, threading.Event())
    features = GentlFeatures(source._camera.remote_device.node_map)
    try:
        for width in (400, 200):
            next_image(source)
            source.stop_stream()
            features.set_region(0, 0, width, 200)
            source.start_stream()
            grabbed = next_image(source)
            assert isinstance(grabbed.image, np.ndarray)
            assert grabbed.image.shape == (200, width)
    finally:
        source.release()


def test_a_file_that_is_no_producer_is_named(tmp_path: Path) -> None:
    other = tmp_path / "other.cti"
    other.write_text("no library")
    with pytest.raises(DeviceError, match=r"other\.cti is no GenTL producer"):
        from_options({"producer": str(other)}).open()


def test_what_it_cannot_do_is_said(producer: Path) -> None:
    for more, words in (
        ({"pixel_format": "Mono12"}, "pixel_format = Mono12; it offers RGBa8, Mono8"),
        ({"pixel_format": "RGBa8"}, "pixel format RGBa8, which is not supported"),
        ({"exposure_us": 100.0}, "exposure_us = 100; it offers –"),
        ({"rate_hz": 5000.0}, "rate_hz = 5000"),
        ({"trigger": "Line1"}, "trigger = Line1; it offers –"),
    ):
        with pytest.raises(DeviceError, match=words) as caught:
            from_options({"producer": str(producer), **more}).open()
        assert caught.value.remedy


def test_producers_are_found_in_folders(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(PRODUCER_PATH, raising=False)
    with pytest.raises(DeviceError, match=PRODUCER_PATH):
        find_producers(None)
    with pytest.raises(DeviceError, match=r"nowhere\.cti"):
        find_producers(str(tmp_path / "nowhere.cti"))
    (tmp_path / "one.cti").touch()
    (tmp_path / "readme.txt").touch()
    monkeypatch.setenv(PRODUCER_PATH, f"/nowhere:{tmp_path}")
    assert find_producers(None) == [tmp_path / "one.cti"]


def test_a_missing_library_is_named_with_its_extra(monkeypatch: pytest.MonkeyPatch) -> None:
    for module in ("harvesters", "harvesters.core"):
        monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(DeviceError) as caught:
        from_options({}).open()
    assert "harvesters" in str(caught.value.what)
    assert 'pip install "crenel[gentl]"' in str(caught.value.remedy)

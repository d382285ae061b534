"""The genicam driver on two cameras that others wrote: Aravis's, and that of viva-genicam."""

import ctypes
import threading
import time
from collections.abc import Iterator, Mapping
from contextlib import closing
from ctypes import byref
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from crenel.station.bus import Bus
from crenel.station.devices.device_thread import SILENCE_S, LinkState
from crenel.station.devices.sensor_device import StationSensor
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import Frame, SelectedColour, SensorDriver, SensorInfo
from crenel_hardware.sensor.genicam import aravis, camera_source
from crenel_hardware.sensor.genicam.aravis_source import GenicamSource
from crenel_hardware.sensor.genicam.driver import FIRST_WITHIN_S, camera_title, from_options
from crenel_hardware.sensor.genicam.settings import GenicamOptions
from crenel_hardware.sensor.grabbing import GrabbingSensor
from tests.hardware.conformance import SensorBench, SensorConformance
from tests.hardware.fake_cameras import (
    ADDRESS,
    ARAVIS_ADDRESS,
    FIRST_BLOCK_ID,
    LAST_BLOCK_ID,
    LINE_MODES,
    LINE_SOURCES,
    PACKET_SIZE_REGISTER,
    TICK_FREQUENCY_REGISTERS,
    USER_OUTPUTS,
    AravisFake,
    ControlClient,
    await_freed,
    given_up,
    port_for_this_test,
    write_laser_camera,
)
from tests.hardware.reading import (
    LONG_S,
    loss_of,
    next_frame,
    open_in_time,
    opened,
    read_past,
    wait_until,
)

pytestmark = [pytest.mark.device, pytest.mark.xdist_group("gige")]

WIDTH, HEIGHT = 320, 240
REGION = [0, 0, WIDTH, HEIGHT]
STAMP_NS = 100_000_000
"""Within this, a busy machine knows the camera's clock."""
LOST_BLOCKS = (3, 4, 7)
"""Block ids, which count from 1: one less is the sequence number."""


def require_aravis() -> aravis.Aravis:
    try:
        return aravis.load_aravis()
    except DeviceError:
        pytest.skip("libaravis is not installed")


@pytest.fixture
def port() -> Iterator[None]:
    require_aravis()
    with port_for_this_test():
        yield


def options(**more: object) -> dict[str, object]:
    return {"address": ARAVIS_ADDRESS, "region": REGION, **more}


def make_driver(table: Mapping[str, object]) -> tuple[GrabbingSensor, list[GenicamSource]]:
    """A driver, and the cameras that it opens."""
    read = GenicamOptions.model_validate(table)
    title, sources = camera_title(read), list[GenicamSource]()

    def connect(stop: threading.Event) -> GenicamSource:
        sources.append(GenicamSource(title, read, stop))
        return sources[-1]

    return GrabbingSensor(title, connect, FIRST_WITHIN_S), sources


def make_viva_fake(**more: Any) -> Any:
    """The fake camera of viva-genicam, not started."""
    testing = pytest.importorskip("viva_genicam.testing")
    return testing.FakeGigeCamera(WIDTH, HEIGHT, 30, bind_ip=ADDRESS, **more)


def genicam_xml() -> str:
    """The description of the camera that runs."""
    library = ctypes.CDLL("libaravis-0.8.so.0")
    read = library.arv_device_get_genicam_xml
    read.restype, read.argtypes = ctypes.c_void_p, (ctypes.c_void_p, ctypes.c_void_p)
    called = aravis.load_aravis().call
    camera = called("arv_camera_new", ARAVIS_ADDRESS.encode())
    size = ctypes.c_size_t()
    text = ctypes.string_at(read(called("arv_camera_get_device", camera), byref(size)), size.value)
    called("g_object_unref", camera)
    return text.decode("utf-8")


@pytest.fixture(scope="module")
def laser_camera(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The description of a camera with an output line."""
    require_aravis()
    path = tmp_path_factory.mktemp("camera") / "laser.xml"
    with port_for_this_test(), AravisFake():
        write_laser_camera(genicam_xml(), path)
    return path


class GenicamBench(SensorBench):
    """A camera that a second program can take over."""

    def __init__(self, address: str, driver: SensorDriver) -> None:
        self._address, self._driver = address, driver
        self._other: ControlClient | None = None

    def driver(self) -> SensorDriver:
        return self._driver

    def take_control(self) -> None:
        self._other = ControlClient(self._address)
        self._other.take_control()

    def leave_control(self) -> None:
        assert self._other is not None
        self._other.leave_control()
        self._other.close()

    def end(self) -> None:
        self._driver.close()
        self.unplug()
        if given_up():
            self.plug_in()
            await_freed()
            self.unplug()


class AravisBench(GenicamBench):
    """Aravis's camera, with a laser on an output line."""

    def __init__(self, description: Path) -> None:
        self._fake = AravisFake("-g", str(description))
        driver = from_options(options(rate_hz=60.0, laser_line="Line2"))
        super().__init__(ARAVIS_ADDRESS, driver)

    def unplug(self) -> None:
        self._fake.stop()

    def plug_in(self) -> None:
        self._fake.start()

    def pictures_until_wrap(self) -> int:
        return LAST_BLOCK_ID - FIRST_BLOCK_ID


class TestAravisCamera(SensorConformance):
    @pytest.fixture
    def bench(self, port: None, laser_camera: Path) -> Iterator[SensorBench]:
        bench = AravisBench(laser_camera)
        yield bench
        bench.end()


@pytest.fixture(scope="session")
def viva() -> None:
    """The library of viva-genicam begins with its first camera, and ends with the process."""
    require_aravis()
    first = make_viva_fake()
    first.start()
    first.stop()


class VivaBench(GenicamBench):
    """The camera of viva-genicam, which numbers, loses and resends on demand."""

    def __init__(self, **more: object) -> None:
        self.plug_in()
        driver, self._sources = make_driver(options(address=ADDRESS, **more))
        super().__init__(ADDRESS, driver)

    def unplug(self) -> None:
        self.fake.stop()

    def plug_in(self, **faults: object) -> None:
        self.fake = make_viva_fake(**faults)
        self.fake.start()

    def lossy_driver(self, resent: bool) -> tuple[SensorDriver, set[int]]:
        self.unplug()
        self.plug_in(drop_packets=[(block, 2) for block in LOST_BLOCKS], packet_resend=resent)
        return self._driver, {block - 1 for block in LOST_BLOCKS}

    def triggered_driver(self) -> SensorDriver:
        self._driver, self._sources = make_driver(options(address=ADDRESS, trigger="Software"))
        return self._driver

    def trigger(self) -> None:
        fire = ctypes.CDLL("libaravis-0.8.so.0").arv_camera_software_trigger
        fire.argtypes = (ctypes.c_void_p, ctypes.c_void_p)
        fire(self._sources[-1].camera.handle, None)

    def revoke_control(self) -> None:
        self.fake.revoke_control()


class TestVivaCamera(SensorConformance):
    @pytest.fixture(
        params=[
            pytest.param([], marks=pytest.mark.soak, id="plain"),
            pytest.param(["ExposureTime", "Timestamp"], id="chunks"),
        ]
    )
    def bench(self, viva: None, request: pytest.FixtureRequest) -> Iterator[SensorBench]:
        bench = VivaBench(chunks=request.param)
        yield bench
        bench.end()


@pytest.fixture
def fake(port: None) -> Iterator[AravisFake]:
    with AravisFake() as camera:
        yield camera
        await_freed()


def refusal(table: Mapping[str, object]) -> str:
    driver = from_options(table)
    with pytest.raises(DeviceError) as caught:
        driver.open()
    driver.close()
    assert caught.value.remedy
    return str(caught.value)


def show(**more: object) -> tuple[SensorInfo, Frame]:
    with closing(from_options(options(**more))) as driver:
        return driver.open(), next_frame(driver)


def test_the_exposure_changes_the_picture_and_its_label(fake: AravisFake) -> None:
    with opened(from_options(options(exposure_us=1000.0))) as driver:
        dark = next_frame(driver)
        driver.set_exposure_us(40_000.0)
        while next_frame(driver).exposure_us < 39_000:
            pass
        bright = [next_frame(driver) for _ in range(3)][-1]
    assert dark.exposure_us == pytest.approx(1000, rel=0.01)
    assert bright.exposure_us == pytest.approx(40_000, rel=0.01)
    assert bright.image.mean() > dark.image.mean() + 50


def test_deep_pictures_state_their_full_scale(fake: AravisFake) -> None:
    _, frame = show(pixel_format="Mono16")
    assert frame.image.dtype == np.uint16
    assert frame.full_scale == 65535


def test_a_raw_colour_camera_shows_the_lasers_pixels(fake: AravisFake) -> None:
    assert "laser_colour" in refusal(options(pixel_format="BayerRG8"))
    info, frame = show(pixel_format="BayerRG8", laser_colour="red")
    assert (info.width_px, info.height_px) == (WIDTH // 2, HEIGHT // 2)
    assert info.selected == SelectedColour("red", "RGGB")
    assert frame.image.shape == (HEIGHT // 2, WIDTH // 2)


def test_a_region_is_a_part_of_the_sensor(fake: AravisFake) -> None:
    with closing(from_options(options(region=[64, 32, 640, 100]))) as driver:
        info = driver.open()
    assert (info.width_px, info.height_px) == (640, 100)
    with closing(from_options({"address": ARAVIS_ADDRESS, "rate_hz": 5.0})) as driver:
        info = open_in_time(driver)  # none of these large pictures may arrive whole, if it is busy
    assert (info.width_px, info.height_px) == (2048, 2048)


def test_what_it_cannot_do_is_said(fake: AravisFake) -> None:
    refused: tuple[tuple[dict[str, object], str], ...] = (
        ({"pixel_format": "Mono11"}, "pixel_format = Mono11; it offers BayerBG8"),
        ({"region": [0, 0, 5000, 100]}, "region"),
        ({"exposure_us": 1e9}, "exposure_us = 1e+09; it offers 10"),
        ({"gain_db": 90.0}, "gain_db = 90"),
        ({"rate_hz": 1e6}, "rate_hz"),
        ({"trigger": "Line7"}, "trigger = Line7; it offers Line0, Software"),
        ({"trigger": "Line0", "trigger_edge": "falling"}, "trigger_edge"),
        ({"laser_line": "Line2"}, "laser_line = Line2; it offers –"),
        ({"chunks": ["ExposureTime"]}, "chunks"),
        ({"serial_number": "4711"}, "has the serial number GV01, not 4711"),
    )
    for table, words in refused:
        assert words in refusal(options() | table)


def test_what_the_camera_offers_is_known_after_opening(fake: AravisFake) -> None:
    with closing(from_options(options())) as driver:
        offers = {one.key: one for one in driver.open().offers}
    assert {"Mono8", "Mono16"} <= set(offers["pixel_format"].choices)
    assert offers["trigger"].choices == ("Line0", "Software")
    assert offers["region"].largest == "0, 0, 2048, 2048"
    assert offers["exposure_us"].bounds == (10.0, 500_000.0)
    assert offers["gain_db"].bounds == (0.0, 10.0)
    assert "laser_line" not in offers, "it has no outputs"


def test_nobody_at_the_address_is_said() -> None:
    require_aravis()
    text = refusal(options(address=ADDRESS))
    assert f"The camera {ADDRESS} does not answer. Check the power" in text
    misspelt = refusal({"address": "192.168.1.300"})
    assert "no device with the address or name 192.168.1.300" in misspelt


def test_a_laser_is_switched_on_its_line_and_off_at_the_end(port: None, laser_camera: Path) -> None:
    with (
        AravisFake("-g", str(laser_camera)),
        closing(ControlClient(ARAVIS_ADDRESS)) as client,
        closing(from_options(options(laser_line="Line2", exposure_us=5000.0))) as driver,
    ):
        assert driver.open().has_laser_switch
        assert client.read(LINE_MODES + 4) == 1
        assert client.read(LINE_SOURCES + 4) == 2
        assert client.read(USER_OUTPUTS + 4) == 0
        assert not next_frame(driver).laser_on
        driver.set_laser(True)
        switched_ns = time.monotonic_ns()
        assert client.read(USER_OUTPUTS + 4) == 1
        while not (frame := next_frame(driver)).laser_on:
            assert frame.mid_exposure_ns - 2_500_000 <= switched_ns + STAMP_NS
        driver.close()
        assert client.read(USER_OUTPUTS + 4) == 0


def test_stamps_are_the_cameras_own(fake: AravisFake) -> None:
    middles = {}
    for stamp_at in ("exposure-start", "mid-exposure", "exposure-end"):
        more = {"rate_hz": 50.0, "exposure_us": 10_000.0, "stamp_at": stamp_at}
        with closing(from_options(options(**more))) as driver:
            info = driver.open()
            frames = [next_frame(driver) for _ in range(60)]
        assert (info.stamps, info.stamp_at) == ("device", stamp_at)
        gaps_ms = np.diff([frame.mid_exposure_ns for frame in frames]) / 1e6
        middles[stamp_at] = np.median(gaps_ms)
    # one exposure every 20 ms, or fewer on a busy machine
    assert all(10.0 < middle_ms < 200.0 for middle_ms in middles.values())


def test_lost_packets_without_resend_are_counted(port: None) -> None:
    with AravisFake("-r", "5"), closing(from_options(options(rate_hz=60.0))) as driver:
        open_in_time(driver)
        seen = read_past(driver, 150)
        assert 0 < len(set(range(max(seen))) - seen) <= driver.health.lost


def test_a_network_that_passes_no_whole_picture_is_named(
    port: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(camera_source, "INCOMPLETE_S", 2.0)
    with AravisFake("-r", "500"):
        text = refusal(options(region=[0, 0, 640, 480], rate_hz=50.0))
    assert "arrive incomplete" in text
    assert "packet_size" in text


def test_without_a_clock_in_the_camera_the_arrival_counts(fake: AravisFake) -> None:
    with closing(ControlClient(ARAVIS_ADDRESS)) as client:
        client.take_control()
        for register in TICK_FREQUENCY_REGISTERS:
            client.write(register, 0)
        client.leave_control()
    with closing(from_options(options(exposure_us=4000.0))) as driver:
        before_ns = time.monotonic_ns()
        info = driver.open()
        frames = [next_frame(driver) for _ in range(10)]
    assert (info.stamps, info.stamp_at) == ("arrival", "frame-end")
    assert before_ns - 4_000_000 < frames[0].mid_exposure_ns < time.monotonic_ns() - 2_000_000
    assert np.all(np.diff([frame.mid_exposure_ns for frame in frames]) > 0)


def test_a_camera_that_no_longer_answers_is_lost(fake: AravisFake) -> None:
    with opened(from_options(options())) as driver:
        next_frame(driver)
        fake.freeze()
        loss_of(driver)
        driver.close()
        fake.go_on()
        open_in_time(driver)
        next_frame(driver)


def test_a_packet_size_is_set(fake: AravisFake) -> None:
    with (
        opened(from_options(options(packet_size=1400))) as driver,
        closing(ControlClient(ARAVIS_ADDRESS)) as client,
    ):
        next_frame(driver)
        assert client.read(PACKET_SIZE_REGISTER) & 0xFFFF == 1400


def test_a_station_keeps_a_camera_that_waits_for_its_trigger(viva: None) -> None:
    bench = VivaBench()
    driver = bench.triggered_driver()
    sensor = StationSensor(Bus(), lambda: driver)
    sensor.reader.start()
    try:
        wait_until(lambda: sensor.reader.link().state is LinkState.CONNECTED)
        silent_until = time.monotonic() + SILENCE_S + 1.0
        while time.monotonic() < silent_until:
            assert sensor.info is not None
            assert sensor.frames.latest is None
            time.sleep(0.1)
        bench.trigger()
        frame = sensor.frames.wait(lambda taken: True, LONG_S)
        assert frame is not None
        assert frame.pulse == 1
        bench.unplug()
        wait_until(lambda: sensor.reader.link().state is LinkState.LOST)
    finally:
        sensor.reader.stop()
        bench.end()

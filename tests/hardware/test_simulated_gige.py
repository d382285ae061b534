"""The simulated GigE camera, judged by clients of others: Aravis, and that of viva-genicam."""

import re
import shutil
import signal
import socket
import subprocess
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager, suppress
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import Frame, SensorDriver
from crenel_hardware.sensor.genicam.driver import from_options
from crenel_hardware.sensor.grabbing import GrabbingSensor
from crenel_hardware.simulator.devices.gige_camera.camera import GigeCamera
from crenel_hardware.simulator.devices.gige_camera.gvcp import PORT
from crenel_hardware.simulator.devices.gige_camera.pixels import RawImage
from crenel_hardware.simulator.devices.gige_camera.registers import CameraIdentity
from crenel_hardware.simulator.station import SimulatedStation
from tests.hardware.conformance import SensorBench, SensorConformance
from tests.hardware.fake_cameras import (
    ADDRESS,
    ARAVIS_ADDRESS,
    CONTROL_REGISTER,
    SECOND_ADDRESS,
    ControlClient,
    await_freed,
    port_for_this_test,
)
from tests.hardware.reading import (
    LONG_S,
    loss_of,
    next_frame,
    open_in_time,
    opened,
    read_until_lost,
    wait_until,
)
from tests.hardware.test_genicam import require_aravis, viva
from tests.hardware.test_simulated_station import SMALL, points_on_plate

pytestmark = [pytest.mark.device, pytest.mark.xdist_group("gige")]

__all__ = ["viva"]  # fixture

STARTED_MODULES = ()  # Aravis
WIDTH, HEIGHT = 192, 120
"""Few packets, so that a reader that is held up finds them where the system keeps them."""
LIT = 200
DELAY_MS = 5.0
LOST_BLOCKS = (3, 4, 7)
"""Block ids, which count from 1: one less is the sequence number."""
NEAR_THE_LAST = 65_500
TRIES_OF_ARAVIS = 6
"""Requests until it gives up, half a second apart."""
GIGE = replace(SMALL, camera="gige", camera_address=ADDRESS)


@pytest.fixture(autouse=True)
def reader() -> None:
    require_aravis()


def picture(mid_ns: int, exposure_us: float, laser_share: float) -> RawImage:
    """A ramp from left to right in the first line; the rest shows the laser's share."""
    image = np.full((HEIGHT, WIDTH), round(LIT * laser_share), np.uint8)
    image[0] = np.arange(WIDTH) % 256
    return image


def make_camera(first_block_id: int = 1) -> GigeCamera:
    identity = CameraIdentity(ADDRESS, "SIM-1", WIDTH, HEIGHT, 50.0)
    return GigeCamera(identity, picture, delay_ms=DELAY_MS, first_block_id=first_block_id)


@contextmanager
def serve(camera: GigeCamera) -> Iterator[GigeCamera]:
    """A camera that is plugged in."""
    camera.start()
    try:
        yield camera
    finally:
        camera.faults.clear()
        await_freed()
        camera.stop()


@pytest.fixture
def camera() -> Iterator[GigeCamera]:
    with serve(make_camera()) as made:
        yield made


def make_driver(**more: object) -> GrabbingSensor:
    options = {"address": ADDRESS, "laser_line": "Line2"}
    return from_options(options | more)


@pytest.fixture
def driver(camera: GigeCamera) -> Iterator[GrabbingSensor]:
    with closing(make_driver()) as driver:
        yield driver


class GigeBench(SensorBench):
    def __init__(self) -> None:
        self.camera = self.make_camera(NEAR_THE_LAST)
        self.camera.start()
        self._driver = make_driver()

    def make_camera(self, first_block_id: int = 1) -> GigeCamera:
        return make_camera(first_block_id)

    def driver(self) -> SensorDriver:
        return self._driver

    def unplug(self) -> None:
        self.camera.faults.unplugged = True

    def plug_in(self) -> None:
        self.camera.faults.unplugged = False

    def lossy_driver(self, resent: bool) -> tuple[SensorDriver, set[int]]:
        self.camera.stop()
        self.camera = self.make_camera()
        self.camera.faults.resends = resent
        self.camera.faults.lost_packets = frozenset((block, 2) for block in LOST_BLOCKS)
        self.camera.start()
        return self._driver, {block - 1 for block in LOST_BLOCKS}

    def pictures_until_wrap(self) -> int:
        return 65_535 - NEAR_THE_LAST

    def triggered_driver(self) -> SensorDriver:
        self._driver = make_driver(trigger="Line1")
        return self._driver

    def trigger(self) -> None:
        self.camera.trigger(now_ns())

    def take_control(self) -> None:
        self.camera.faults.taken = True
        wait_until(lambda: not is_free())

    def leave_control(self) -> None:
        self.camera.faults.taken = False
        wait_until(is_free)

    def revoke_control(self) -> None:
        self.camera.revoke_control()

    def end(self) -> None:
        self._driver.close()
        self.camera.faults.clear()
        await_freed()
        self.camera.stop()


def is_free() -> bool:
    """Whether no program has the camera to itself."""
    with closing(ControlClient()) as client, suppress(OSError):  # the camera refuses to answer
        return client.read(CONTROL_REGISTER) == 0
    return False


class TestSimulatedGigeCamera(SensorConformance):
    @pytest.fixture
    def bench(self) -> Iterator[SensorBench]:
        bench = GigeBench()
        yield bench
        bench.end()


def test_aravis_own_program_receives_its_pictures(camera: GigeCamera) -> None:
    program = shutil.which("arv-camera-test-0.8")
    if program is None:
        pytest.skip("aravis-tools is not installed")
    command = [program, "-n", ADDRESS]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as running:
        try:
            wait_until(lambda: camera.blocks >= 60, "no pictures are taken")
            running.send_signal(signal.SIGINT)
            output, _ = running.communicate(timeout=LONG_S)
        finally:
            running.kill()
    figures = dict(re.findall(r"^(.+?) *= (.+)$", output, re.MULTILINE))
    assert figures["model name"] == "Simulated GigE camera"
    assert figures["device serial number"] == "SIM-1"
    assert figures["payload"] == f"{WIDTH * HEIGHT} bytes"
    assert int(figures["n_completed_buffers"]) > 0


def test_another_client_finds_it_and_reads_features_and_pictures(viva: None) -> None:
    """On a busy machine, an answer may come after the client has given up, and so may a packet that
    it asked for again: it asks once more, and says which pictures are not whole."""
    library = pytest.importorskip("viva_genicam")
    starts_ns: list[int] = []

    def note(mid_ns: int, exposure_us: float, laser_share: float) -> RawImage:
        starts_ns.append(mid_ns - round(500 * exposure_us))
        return picture(mid_ns, exposure_us, laser_share)

    address = ARAVIS_ADDRESS  # of the interface in which it searches
    identity = CameraIdentity(address, "SIM-1", WIDTH, HEIGHT, 50.0)
    with port_for_this_test(), serve(GigeCamera(identity, note, delay_ms=DELAY_MS)) as camera:
        deadline = time.monotonic() + LONG_S
        while not (found := [one for one in library.discover(iface="lo") if one.ip == address]):
            assert time.monotonic() < deadline, "it is not found"
        client = library.connect_gige(found[0], iface=address)
        assert client.get("DeviceSerialNumber") == "SIM-1"
        client.set("ExposureTime", "8000")
        assert float(client.get("ExposureTime")) == 8000
        client.set("LineSelector", "Line2")
        client.set("LineSource", "UserOutput2")
        client.set("UserOutputSelector", "UserOutput2")
        client.set("UserOutputValue", "true")
        damaged = range(3, 1000, 2)
        camera.faults.lost_packets = frozenset((block, 2) for block in damaged)
        client.time_calibrate()
        whole: dict[int, Any] = {}
        with client.stream() as frames:
            for frame in frames:
                assert time.monotonic() < deadline + LONG_S, f"{len(whole)} whole pictures"
                if frame.is_complete:
                    whole[frame.block_id] = frame
                if len(whole) >= 20 and not whole.keys().isdisjoint(damaged):
                    break
        client.close()
        stamps = {camera._ticks(start_ns) for start_ns in starts_ns}
        for frame in whole.values():
            np.testing.assert_array_equal(frame.to_numpy(), picture(0, 8000.0, 1.0))
            assert frame.ts_dev in stamps, "no exposure began at its stamp"
            assert abs(time.time() - frame.ts_host) < 3 * LONG_S


def test_a_second_camera_needs_an_address_of_its_own(camera: GigeCamera) -> None:
    with pytest.raises(DeviceError, match="3956"):
        make_camera().start()
    other = GigeCamera(CameraIdentity(SECOND_ADDRESS, "SIM-2", WIDTH, HEIGHT, 50.0), picture)
    with (
        serve(other),
        closing(make_driver()) as first,
        closing(make_driver(address=SECOND_ADDRESS)) as second,
    ):
        assert [first.open().serial_number, second.open().serial_number] == ["SIM-1", "SIM-2"]
        next_frame(first)
        next_frame(second)


@pytest.mark.parametrize("name", ["Mono8", "Mono10", "Mono12", "Mono16"])
def test_every_pixel_format_shows_the_same_picture(camera: GigeCamera, name: str) -> None:
    with opened(make_driver(pixel_format=name, region=[16, 0, 160, 100])) as driver:
        frame = next_frame(driver)
    assert frame.full_scale is not None
    scale = (frame.full_scale + 1) // 256
    np.testing.assert_array_equal(frame.image, scale * picture(0, 0, 0)[:100, 16:176].astype(int))


def test_lost_packets_cost_no_picture_unseen(camera: GigeCamera, driver: GrabbingSensor) -> None:
    """Each picture arrives whole, packets sent again, or counts as lost."""
    camera.faults.packet_drop_rate = 0.01
    driver.open()
    frames = [next_frame(driver) for _ in range(150)]
    driver.close()
    lost = frames[-1].sequence + 1 - len(frames)
    assert lost <= driver.health.lost < 30
    assert camera.packets_lost > 20
    for frame in frames:
        np.testing.assert_array_equal(frame.image[0], picture(0, 0, 0)[0])


def test_datagrams_that_are_no_requests_are_ignored(driver: GrabbingSensor) -> None:
    rng = np.random.default_rng(5)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        sender.connect((ADDRESS, PORT))
        for size in (0, 1, 7, 8, 9, 20, 540, 1400):
            sender.send(rng.bytes(size))
            sender.send(b"\x42\x01" + rng.bytes(size))
            for command in (0x02, 0x40, 0x80, 0x82, 0x84, 0x86, 0x1234):
                head = bytes([0x42, 1, 0, command & 0xFF]) + size.to_bytes(2, "big") + b"\0\1"
                sender.send(head + rng.bytes(size))
    open_in_time(driver)
    next_frame(driver)


def test_only_the_program_in_control_may_write(camera: GigeCamera) -> None:
    first, second = ControlClient(), ControlClient()
    with pytest.raises(OSError, match="refuses"):
        first.write(0x0938, 1000)
    first.take_control()
    first.write(0x0938, 1000)
    with pytest.raises(OSError, match="refuses"):
        second.write(0x0938, 2000)
    assert second.read(0x0938) == 1000
    wait_until(lambda: not second.read(CONTROL_REGISTER))  # the first one has fallen silent
    second.take_control()
    first.close()
    second.close()


def test_a_camera_kept_from_others_is_in_use(camera: GigeCamera, driver: GrabbingSensor) -> None:
    driver.open()
    next_frame(driver)
    camera.faults.taken = True
    assert "in use by another program" in str(loss_of(driver))
    with pytest.raises(DeviceError, match="in use by another program"):
        driver.open()
    camera.faults.taken = False
    open_in_time(driver)
    next_frame(driver)


def test_a_line_on_which_one_picture_takes_seconds_is_noticed_before_it_has_arrived() -> None:
    width_px, height_px = 640, 360
    image = np.full((height_px, width_px), LIT, np.uint8)
    identity = CameraIdentity(SECOND_ADDRESS, "SIM-2", width_px, height_px, 10.0)
    camera = GigeCamera(identity, lambda *_: image, delay_ms=DELAY_MS)
    with serve(camera), closing(make_driver(address=SECOND_ADDRESS)) as driver:
        open_in_time(driver)
        for _ in range(10):
            next_frame(driver)
        assert driver.health.late == 0
        camera.faults.line_bytes_per_s = image.size / 2.0
        before, deadline = driver.health.received, time.monotonic() + LONG_S
        while not driver.health.late:
            assert time.monotonic() < deadline
            driver.read(0.1)
    # the one that was on its way, and at most one of the line as it was before
    assert driver.health.received <= before + 2


def test_a_clock_that_answers_late_gives_true_stamps() -> None:
    """As on a busy computer: every second answer is noted long after the clock was latched."""
    true_ns: list[int] = []

    def note(mid_ns: int, exposure_us: float, laser_share: float) -> RawImage:
        true_ns.append(mid_ns)
        return picture(mid_ns, exposure_us, laser_share)

    # two and a half periods after the exposure: no other exposure is near a stamp that is late
    camera = GigeCamera(CameraIdentity(ADDRESS, "SIM-1", WIDTH, HEIGHT, 10.0), note, delay_ms=250.0)
    camera.faults.latch_delays_s = (0.0, 0.12)
    with serve(camera), closing(make_driver(rate_hz=10.0)) as driver:
        assert open_in_time(driver).stamps == "device"
        stamps_ns = [next_frame(driver).mid_exposure_ns for _ in range(10)]
    off_ns = np.min(np.abs(np.subtract.outer(stamps_ns, true_ns)), axis=1)
    assert np.median(off_ns) < 30e6  # and not half of an answer's delay, 60 ms


@pytest.mark.parametrize("later_s", [-0.5, 3600.0])
def test_a_set_clock_is_named(camera: GigeCamera, driver: GrabbingSensor, later_s: float) -> None:
    driver.open()
    before = next_frame(driver)
    camera._born_ns -= round(1e9 * later_s)
    taken = [before]

    def read() -> None:
        frame = driver.read(0.1)
        if isinstance(frame, Frame):
            taken.append(frame)

    error = read_until_lost(read)
    assert "states another time" in str(error.what)
    ages_ns = now_ns() - np.array([frame.mid_exposure_ns for frame in taken])
    assert ages_ns.min() > 0
    assert ages_ns.max() < LONG_S * 1e9
    open_in_time(driver)
    assert next_frame(driver).mid_exposure_ns > before.mid_exposure_ns


def test_a_camera_that_answers_again_is_opened_at_once(camera: GigeCamera) -> None:
    """Its first answers get lost; or Aravis gives up, and the camera is there."""
    for answered, unanswered in ((0, 3), (1, TRIES_OF_ARAVIS)):
        camera.faults.answered, camera.faults.unanswered = answered, unanswered
        with opened(make_driver()) as driver:
            next_frame(driver)


@pytest.mark.slow
def test_a_frame_shows_its_own_moment() -> None:
    """The laser's line on the plate, from frame and true pose, lies in the plate's plane: a
    millisecond would be 0.03 mm. The camera's clock is fast, and pictures arrive late."""
    with SimulatedStation(GIGE) as simulation, opened(simulation.sensor()) as driver:
        driver.set_laser(True)
        places = points_on_plate(simulation, driver, simulation.operator.pass_over_plate, 15)
    assert np.median(np.abs(places[:, 2])) < 0.02

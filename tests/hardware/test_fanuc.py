"""The FANUC driver against another team's emulator of a CRX controller (``airo-fanuc``)."""

import math
import socket
import struct
import threading
import time
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmDriver, PoseSample
from crenel_hardware.registry import arm_driver
from tests.bench.station.subprocess_station import free_port
from tests.hardware.conformance import ArmBench, ArmConformance
from tests.hardware.reading import (
    PATIENT_S,
    loss_of,
    opened,
    read_readings,
    read_samples,
    read_until,
    select_readings,
    wait_until,
)

testing = pytest.importorskip("airo_fanuc.testing")

pytestmark = pytest.mark.device

JOINTS_DEG = [10.0, -20.0, 30.0, -40.0, 50.0, -60.0]
FACEPLATE = [500.0, -100.0, 350.0, 10.0, 20.0, 30.0]


class FanucBench(ArmBench):
    """``unplug`` ends the emulator; ``plug_in`` starts another one at the same port."""

    def __init__(self, report: str = "flange", **config: Any) -> None:
        self.port, self.report, self._config = free_port(socket.SOCK_DGRAM), report, config
        self.controller: Any = None
        self.plug_in()

    def driver(self) -> ArmDriver:
        options = {"address": "127.0.0.1", "port": self.port, "report": self.report}
        return arm_driver("fanuc", {**options, "timeout_s": PATIENT_S})

    def contacts(self) -> int:
        return int(self.controller.sm.streaming)

    def plug_in(self) -> None:
        self.controller = testing.FakeCRXController(
            testing.FakeCRXConfig(**self._config),
            sm_port=self.port,
            clock=testing.WallClock(),
            initial_q_deg=JOINTS_DEG,
        )
        self.controller.set_cartesian(FACEPLATE)
        self.controller.sm.start_realtime()

    def unplug(self) -> None:
        self.controller.close()

    def silence(self, silent: bool) -> None:
        if silent:
            self.controller.sm.stop_realtime()
        else:
            self.controller.sm.start_realtime()

    def lose_samples(self, count: int) -> None:
        self.controller.sm.inject_seq_gap(count)


@pytest.fixture(params=["flange", pytest.param("joints", marks=pytest.mark.soak)])
def bench(request: pytest.FixtureRequest) -> Iterator[FanucBench]:
    bench = FanucBench(request.param)
    yield bench
    assert bench.controller.sm.violations == []
    bench.unplug()


@pytest.fixture
def driver(bench: FanucBench) -> Iterator[ArmDriver]:
    with opened(bench.driver()) as driver:
        yield driver


class TestFanuc(ArmConformance):
    pass


def await_stop(bench: FanucBench) -> None:
    wait_until(lambda: not bench.controller.sm.streaming)


def test_the_faceplate_and_the_joints_are_as_sent(driver: ArmDriver) -> None:
    assert driver.open().rate_hz == 125.0
    for reading in read_readings(driver, 11):
        if isinstance(reading, PoseSample):
            assert reading.position_mm == pytest.approx(FACEPLATE[:3])
            expected = Rotation.from_euler("xyz", FACEPLATE[3:], degrees=True)
            assert (Rotation.from_quat(reading.quaternion_xyzw) * expected.inv()).magnitude() < 1e-6
        else:
            assert reading.joints_rad == pytest.approx(np.radians(JOINTS_DEG), abs=1e-6)


def test_the_robot_is_never_commanded(bench: FanucBench, driver: ArmDriver) -> None:
    read_readings(driver, 51)
    driver.close()
    assert bench.controller.sm.violations == []
    assert bench.controller.q_meas_deg[:6] == pytest.approx(JOINTS_DEG)


def test_closing_stops_the_stream(bench: FanucBench, driver: ArmDriver) -> None:
    assert bench.controller.sm.streaming
    driver.close()
    await_stop(bench)


def test_closing_stops_a_stream_while_a_thread_waits(bench: FanucBench, driver: ArmDriver) -> None:
    bench.silence(True)
    reader = threading.Thread(target=loss_of, args=(driver, 5.0), daemon=True)
    reader.start()
    while driver.health.received == 0:
        time.sleep(0.01)
    driver.close()
    reader.join()
    bench.silence(False)
    await_stop(bench)


def test_a_repeated_packet_is_dropped(bench: FanucBench, driver: ArmDriver) -> None:
    bench.controller.sm.duplicate_next_status()
    readings = select_readings(read_until(driver, lambda _: driver.health.corrupt))
    assert np.all(np.diff([reading.sequence for reading in readings]) == 1)
    assert driver.health.lost == 0


def test_version_4_sends_longer_packets() -> None:
    bench = FanucBench("joints", available_version=4)
    with opened(bench.driver()) as driver:
        sample = read_samples(driver)[0]
    assert sample.joints_rad == pytest.approx(np.radians(JOINTS_DEG), abs=1e-6)
    bench.unplug()


def test_an_old_controller_is_refused() -> None:
    bench = FanucBench(available_version=2)
    with pytest.raises(DeviceError, match="version 2 of Stream Motion"):
        bench.driver().open()
    bench.unplug()


def test_values_that_are_no_numbers_are_an_error(bench: FanucBench, driver: ArmDriver) -> None:
    read_readings(driver)
    bench.controller.set_cartesian([math.nan] * 6)
    assert "no numbers" in str(loss_of(driver).what)


def test_a_restarted_controller_is_an_error(bench: FanucBench, driver: ArmDriver) -> None:
    """Another client starts the stream again, and the sequence begins at zero."""
    read_readings(driver, 61)
    bench.controller.sm._on_start(struct.pack(">II", 200, 3))
    assert "has jumped" in str(loss_of(driver).what)


def test_a_port_without_stream_motion_is_said() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as mute:
        mute.bind(("127.0.0.1", 0))
        options: dict[str, object] = {"address": "127.0.0.1", "port": mute.getsockname()[1]}
        with pytest.raises(DeviceError, match="does not answer as Stream Motion"):
            arm_driver("fanuc", {**options, "timeout_s": 0.5}).open()
    with pytest.raises(DeviceError, match=f"No program listens at 127.0.0.1:{options['port']}"):
        arm_driver("fanuc", options).open()

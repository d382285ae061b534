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

from app.bench.station.subprocess_station import free_port
from hardware.errors import DeviceError
from hardware.interfaces import ArmDriver, PoseSample
from hardware.registry import arm_driver
from tests.hardware.conformance import (
    LONG_S,
    ArmBench,
    ArmConformance,
    read_until,
    read_until_lost,
    select_readings,
    select_samples,
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
        return arm_driver("fanuc", self.options())

    def options(self) -> dict[str, object]:
        return {"address": "127.0.0.1", "port": self.port, "report": self.report, "timeout_s": 3.0}

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


class TestFanuc(ArmConformance):
    pass


def test_the_faceplate_and_the_joints_are_as_sent(bench: FanucBench) -> None:
    driver = bench.driver()
    info = driver.open()
    assert info.rate_hz == 125.0
    for reading in select_readings(read_until(driver, lambda got: len(got) > 10)):
        if isinstance(reading, PoseSample):
            assert reading.position_mm == pytest.approx(FACEPLATE[:3])
            expected = Rotation.from_euler("xyz", FACEPLATE[3:], degrees=True)
            assert (Rotation.from_quat(reading.quaternion_xyzw) * expected.inv()).magnitude() < 1e-6
        else:
            assert reading.joints_rad == pytest.approx(np.radians(JOINTS_DEG), abs=1e-6)
    driver.close()


def test_the_robot_is_never_commanded(bench: FanucBench) -> None:
    driver = bench.driver()
    driver.open()
    read_until(driver, lambda got: len(got) > 50)
    driver.close()
    assert bench.controller.sm.violations == []
    assert bench.controller.q_meas_deg[:6] == pytest.approx(JOINTS_DEG)


def test_closing_stops_the_stream(bench: FanucBench) -> None:
    driver = bench.driver()
    driver.open()
    assert bench.controller.sm.streaming
    driver.close()
    deadline = time.monotonic() + LONG_S
    while bench.controller.sm.streaming:
        assert time.monotonic() < deadline
        time.sleep(0.01)


def test_closing_stops_the_stream_while_another_thread_waits(bench: FanucBench) -> None:
    driver = bench.driver()
    driver.open()
    bench.silence(True)
    reader = threading.Thread(target=lambda: read_until_lost(lambda: driver.read(5.0)), daemon=True)
    reader.start()
    while driver.health.received == 0:
        time.sleep(0.01)
    driver.close()
    reader.join()
    bench.silence(False)
    deadline = time.monotonic() + LONG_S
    while bench.controller.sm.streaming:
        assert time.monotonic() < deadline
        time.sleep(0.01)


def test_a_repeated_packet_is_dropped(bench: FanucBench) -> None:
    driver = bench.driver()
    driver.open()
    bench.controller.sm.duplicate_next_status()
    readings = select_readings(read_until(driver, lambda _: driver.health.corrupt))
    assert np.all(np.diff([reading.sequence for reading in readings]) == 1)
    assert driver.health.lost == 0
    driver.close()


def test_version_4_sends_longer_packets() -> None:
    bench = FanucBench("joints", available_version=4)
    driver = bench.driver()
    driver.open()
    sample = select_samples(read_until(driver, select_samples))[0]
    assert sample.joints_rad == pytest.approx(np.radians(JOINTS_DEG), abs=1e-6)
    driver.close()
    bench.unplug()


def test_an_old_controller_is_refused() -> None:
    bench = FanucBench(available_version=2)
    with pytest.raises(DeviceError, match="version 2 of Stream Motion"):
        bench.driver().open()
    bench.unplug()


def test_values_that_are_no_numbers_are_an_error(bench: FanucBench) -> None:
    driver = bench.driver()
    driver.open()
    read_until(driver, select_readings)
    bench.controller.set_cartesian([math.nan] * 6)
    assert "no numbers" in str(read_until_lost(lambda: driver.read(0.1)).what)


def test_a_restarted_controller_is_an_error(bench: FanucBench) -> None:
    """Another client starts the stream again, and the sequence begins at zero."""
    driver = bench.driver()
    driver.open()
    read_until(driver, lambda got: len(got) > 60)
    bench.controller.sm._on_start(struct.pack(">II", 200, 3))
    assert "has jumped" in str(read_until_lost(lambda: driver.read(0.1)).what)


def test_a_port_without_stream_motion_is_said() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as mute:
        mute.bind(("127.0.0.1", 0))
        options: dict[str, object] = {"address": "127.0.0.1", "port": mute.getsockname()[1]}
        with pytest.raises(DeviceError, match="does not answer as Stream Motion"):
            arm_driver("fanuc", {**options, "timeout_s": 0.5}).open()
    with pytest.raises(DeviceError, match=f"No program listens at 127.0.0.1:{options['port']}"):
        arm_driver("fanuc", options).open()

"""A small arm and sensor that meet the drivers' interfaces, moved and broken by the tests."""

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest

from crenel.metrology.arm.kinematics import Arm, Joint, Tip
from crenel.station.bus import Bus
from crenel.station.devices.rig import Rig
from crenel.station.devices.sensor_device import StationSensor
from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import (
    ArmInfo,
    ArmRecord,
    Button,
    ButtonEvent,
    Frame,
    JointSample,
    LinkHealth,
    SensorInfo,
    SensorReading,
)
from crenel_hardware.simulator.station import SimulatedStation

Joints = Callable[[float], np.ndarray]
"""Joint angles at a time in seconds."""
RATE_HZ = 500.0
REST_RAD = np.radians([10.0, -40.0, 60.0, 20.0, 35.0, -15.0])
WIDTH, HEIGHT = 320, 240
TAKEN_S = 0.2
"""How long it takes to move the arm from one script's place to the next one's."""


def six_axis_arm() -> Arm:
    shape = [(0, -90, 280), (450, 0, 0), (60, -90, 0), (0, 90, 400), (0, -90, 0), (0, 0, 90)]
    joints = tuple(
        Joint(f"J{i + 1}", a, np.radians(alpha), d, 0.0, encoder_sd_rad=1e-5)
        for i, (a, alpha, d) in enumerate(shape)
    )
    return Arm("scripted arm", "A-1", joints, Tip(0.0, -12.0, 165.0, 6.0))


class Bench:
    """What the test does to the devices, and what they share over reconnections."""

    def __init__(self) -> None:
        self.joints_at: Joints = lambda seconds: REST_RAD
        self.noise_rad = 1e-5
        self.arm_plugged = True
        self.arm_silent = False
        self.silent_reads = 0
        self.arm_skips: set[int] = set()
        self.arm_opened = 0
        self.sensor_plugged = True
        self.sensor_opened = 0
        self.laser_on = False
        self.laser_obeys = True
        self.has_laser_switch = True
        self.longest_gap_s = 0.0
        self.sensor_free_running = True
        self.sensor_silent = False
        self.sensor_answers = True
        self.exposure_us = 4000.0
        self.frame_period_s = 0.01
        self.scene_level = 0.02
        self.presses: list[Button] = []
        self.stripe_row = 120.0
        self.line_level: float | None = None
        """Grey levels a microsecond; None: 140 whatever the exposure."""
        self.picture: np.ndarray | None = None
        self.start_s = time.monotonic()


def smooth_path(left: Joints, there: Joints, since_s: float) -> Joints:
    """From one script's place to another one's, also if the first was not reached yet."""

    def path(seconds: float) -> np.ndarray:
        share = min((seconds - since_s) / TAKEN_S, 1.0)
        if share == 1.0:
            return there(seconds)
        share = share**3 * (10 - 15 * share + 6 * share**2)
        return left(seconds) * (1 - share) + there(seconds) * share

    return path


class ScriptedArm:
    def __init__(self, bench: Bench) -> None:
        self.bench = bench
        self.health = LinkHealth()
        self.random = np.random.default_rng(4)
        self.sequence = 0
        self.next_ns = 0
        self.followed = self.path = bench.joints_at

    def joints(self, seconds: float) -> np.ndarray:
        """Where the bench's script has the arm; a new script is reached in one smooth motion."""
        if self.bench.joints_at is not self.followed:
            self.followed = self.bench.joints_at
            self.path = smooth_path(self.path, self.followed, seconds)
        return self.path(seconds)

    def open(self) -> ArmInfo:
        if not self.bench.arm_plugged:
            raise DeviceError("The arm at bench:1 does not answer", "plug it in")
        self.bench.arm_opened += 1
        self.next_ns = now_ns()
        return ArmInfo("scripted arm", "A-1", 6, RATE_HZ)

    def read(self, timeout_s: float) -> list[ArmRecord]:
        time.sleep(0.004)
        if not self.bench.arm_plugged:
            raise DeviceError("The arm at bench:1 was unplugged")
        if self.bench.arm_silent:
            time.sleep(timeout_s)
            self.bench.silent_reads += 1
            self.next_ns = now_ns()
            return []
        records: list[ArmRecord] = []
        while self.next_ns <= now_ns():
            self.sequence += 1
            seconds = self.next_ns / 1e9 - self.bench.start_s
            q = self.joints(seconds) + self.bench.noise_rad * self.random.normal(size=6)
            if self.sequence in self.bench.arm_skips:
                self.health.lost += 1
            else:
                records.append(JointSample(self.sequence, self.next_ns, tuple(q)))
                self.health.received += 1
            self.next_ns += int(1e9 / RATE_HZ)
        while self.bench.presses:
            button = self.bench.presses.pop(0)
            records.append(ButtonEvent(self.sequence, now_ns(), button, True))
        return records

    def close(self) -> None:
        pass


class ScriptedSensor:
    """A dark room with one bright level and, with the laser on, a straight stripe."""

    def __init__(self, bench: Bench) -> None:
        self.bench = bench
        self.health = LinkHealth()
        self.sequence = 0
        self.random = np.random.default_rng(5)
        self.closed = threading.Event()

    def open(self) -> SensorInfo:
        if not self.bench.sensor_plugged:
            raise DeviceError("The camera at bench:2 does not answer")
        self.bench.sensor_opened += 1
        return SensorInfo(
            "scripted sensor",
            "S-1",
            WIDTH,
            HEIGHT,
            (100.0, 50_000.0),
            self.bench.has_laser_switch,
            self.bench.longest_gap_s,
            free_running=self.bench.sensor_free_running,
        )

    def is_alive(self) -> bool:
        return self.bench.sensor_plugged and self.bench.sensor_answers

    def read(self, timeout_s: float) -> Frame | None:
        time.sleep(self.bench.frame_period_s)
        if not self.bench.sensor_plugged:
            raise DeviceError("The camera at bench:2 was unplugged")
        if self.bench.sensor_silent:
            time.sleep(timeout_s)
            return None
        exposure_us, laser_on = self.bench.exposure_us, self.bench.laser_on
        stamp = now_ns() - int(500 * exposure_us)
        self.sequence += 1
        self.health.received += 1
        image = self.picture(laser_on) if self.bench.picture is None else self.bench.picture
        return Frame(self.sequence, stamp, image, exposure_us, laser_on)

    def picture(self, laser_on: bool) -> np.ndarray:
        level = self.bench.scene_level * self.bench.exposure_us
        image = np.full((HEIGHT, WIDTH), level) + self.random.normal(0, 1.5, (HEIGHT, WIDTH))
        if laser_on:
            rows = np.arange(HEIGHT)[:, None]
            per_us = self.bench.line_level
            height = 140 if per_us is None else per_us * self.bench.exposure_us
            image += height * np.exp(-(((rows - self.bench.stripe_row) / 2) ** 2) / 2)
        return np.clip(np.round(image), 0, 255).astype(np.uint8)

    def set_exposure_us(self, exposure_us: float) -> None:
        self.bench.exposure_us = exposure_us

    def set_laser(self, on: bool) -> None:
        if self.bench.laser_obeys:
            self.bench.laser_on = on

    def close(self) -> None:
        self.bench.laser_on = False


@pytest.fixture(scope="module")
def simulation(request: pytest.FixtureRequest) -> Iterator[SimulatedStation]:
    """A simulated station of the module's ``CONFIG``."""
    with SimulatedStation(request.module.CONFIG) as running:
        yield running


@pytest.fixture
def bench() -> Bench:
    return Bench()


@pytest.fixture
def bus() -> Bus:
    return Bus()


@pytest.fixture
def rig(bench: Bench, bus: Bus, tmp_path: Path) -> Iterator[Rig]:
    rig = Rig(bus, lambda: ScriptedArm(bench), lambda: ScriptedSensor(bench), tmp_path)
    rig.arm.set_model(six_axis_arm())
    with running(rig):
        ready(rig)
        yield rig


@contextmanager
def running(rig: Rig) -> Iterator[Rig]:
    rig.start()
    try:
        yield rig
    finally:
        rig.stop()


def ready(rig: Rig) -> None:
    until(lambda: rig.arm.stillness().still and rig.sensor.fresh)


def collect_readings(rig: Rig, count: int) -> list[SensorReading]:
    """So many pictures or lines of the sensor, as they come."""
    tap = rig.sensor.frames.tap(count)
    readings: list[SensorReading] = []

    def are_enough() -> bool:
        readings.extend(tap.get(count, 0.2))
        return len(readings) >= count

    until(are_enough)
    rig.sensor.frames.untap(tap)
    return readings


def until(condition: Callable[[], object], timeout_s: float = 240.0) -> None:
    """Waits for a condition; fails when it does not come."""
    deadline = time.monotonic() + timeout_s
    while not condition():
        assert time.monotonic() < deadline, "it did not happen in time"
        time.sleep(0.01)


PAIRED_WITHIN_S = 900.0
"""A busy machine holds frames up; pulses are started again after longer and longer pauses."""


def until_paired(*cameras: StationSensor) -> None:
    """Waits until all cameras are paired with the arm's pulses."""
    until(lambda: all(camera.is_paired for camera in cameras), PAIRED_WITHIN_S)

"""A simulated station as fast as wanted: an arm that sweeps, a sensor that never tires.

Pictures are drawn beforehand and handed out in turn, so that what is measured on it is
the program and not the simulation. The arm turns about its first joint alone, and the
laser's plane holds that joint's axis: every point's azimuth shows when it was taken.
"""

import threading
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import (
    ArmInfo,
    ArmRecord,
    Frame,
    JointSample,
    LinkHealth,
    SensorInfo,
)

JOINTS = 6
REACH_MM = 400.0
"""From the first joint's axis to the flange."""
SENSOR_MM = (0.0, -100.0, 200.0)
"""Where the camera sits on the flange; it looks at the flange's own place."""
POOL = 96
STRIPE_SD_PX, READ_NOISE, ELECTRONS_PER_LEVEL = 2.0, 2.0, 40.0
RING_FRAMES, RING_SAMPLES = 128, 4096
"""What the devices keep for a reader that is late; what is older is lost. Of frames 0.2 s, as
many buffers as one gives the driver of so fast a camera."""
PACKET_S = 0.004
"""Readings of the arm that come in one packet."""


@dataclass(frozen=True)
class FastStationConfig:
    """How fast the station is, and how much it sees."""

    profiles_hz: float = 600.0
    width_px: int = 2000
    height_px: int = 256
    arm_hz: float = 1000.0
    turn_rad_s: float = 0.01
    seed: int = 1


class SweepClock:
    """When the sweep began: one for arm and sensor."""

    def __init__(self) -> None:
        self.start_ns = now_ns()

    def azimuth_rad(self, stamp_ns: int, pace: FastStationConfig) -> float:
        """The azimuth of the laser's plane in the arm's frame."""
        return -np.pi + pace.turn_rad_s * (stamp_ns - self.start_ns) / 1e9


class FastArm:
    """Meets ``ArmDriver``."""

    def __init__(self, pace: FastStationConfig, clock: SweepClock) -> None:
        self._pace, self._clock = pace, clock
        self._health = LinkHealth()
        self._pause = threading.Event()
        self._next = 0

    @property
    def health(self) -> LinkHealth:
        return self._health

    def open(self) -> ArmInfo:
        self._next = self._due()
        return ArmInfo("Swift arm", "SWIFT-A", JOINTS, self._pace.arm_hz)

    def read(self, timeout_s: float) -> Sequence[ArmRecord]:
        self._pause.wait(min(PACKET_S, timeout_s))
        due = self._due()
        late = due - RING_SAMPLES - self._next
        if late > 0:
            self._health.lost += late
            self._next += late
        samples = [self._sample(number) for number in range(self._next, due)]
        self._next = due
        self._health.received += len(samples)
        return samples

    def close(self) -> None:
        """Nothing is held."""

    def _due(self) -> int:
        return int((now_ns() - self._clock.start_ns) * self._pace.arm_hz / 1e9)

    def _sample(self, number: int) -> JointSample:
        stamp_ns = self._clock.start_ns + int(number * 1e9 / self._pace.arm_hz)
        turned = self._clock.azimuth_rad(stamp_ns, self._pace)
        return JointSample(number, stamp_ns, (turned, *(0.0,) * (JOINTS - 1)))


class FastSensor:
    """Meets ``SensorDriver``; its laser is always on."""

    def __init__(
        self, pace: FastStationConfig, clock: SweepClock, pool: Sequence[NDArray[np.uint8]]
    ) -> None:
        self._pace, self._clock, self._pool = pace, clock, pool
        self._health = LinkHealth()
        self._pause = threading.Event()
        self._next = 0

    @property
    def health(self) -> LinkHealth:
        return self._health

    def open(self) -> SensorInfo:
        self._next = self._due()
        return SensorInfo(
            "Swift sensor",
            "SWIFT-S",
            self._pace.width_px,
            self._pace.height_px,
            (500.0, 500.0),
            has_laser_switch=False,
        )

    def read(self, timeout_s: float) -> Frame | None:
        deadline_ns = now_ns() + int(timeout_s * 1e9)
        while (wait_ns := self._stamp_ns(self._next) - now_ns()) > 0:
            if now_ns() >= deadline_ns:
                return None
            self._pause.wait(wait_ns / 1e9)
        late = self._due() - RING_FRAMES - self._next
        if late > 0:
            self._health.lost += late
            self._next += late
        number = self._next
        self._next += 1
        self._health.received += 1
        image = self._pool[number % len(self._pool)]
        return Frame(number, self._stamp_ns(number), image, 500.0, laser_on=True)

    def set_exposure_us(self, exposure_us: float) -> None:
        """It has one exposure only."""

    def set_laser(self, on: bool) -> None:
        raise DeviceError("The fast sensor's laser is always on")

    def close(self) -> None:
        """Nothing is held."""

    def _stamp_ns(self, number: int) -> int:
        return self._clock.start_ns + int(number * 1e9 / self._pace.profiles_hz)

    def _due(self) -> int:
        return int((now_ns() - self._clock.start_ns) * self._pace.profiles_hz / 1e9)


def draw_stripe_images(pace: FastStationConfig, count: int = POOL) -> list[NDArray[np.uint8]]:
    """Pictures (height, width) of a wavy stripe with shot and read noise, a point a column."""
    rng = np.random.default_rng(pace.seed)
    columns = np.arange(pace.width_px)
    rows = np.arange(pace.height_px)[:, None]
    pictures = []
    for number in range(count):
        phase = 2 * np.pi * number / count
        wave = 0.25 * np.sin(2 * np.pi * columns / 700 + phase)
        wave += 0.08 * np.sin(2 * np.pi * columns / 160 - 3 * phase)
        middle = pace.height_px * (0.5 + wave)
        height = 145 + 85 * np.sin(2 * np.pi * columns / 430 + 2 * phase)
        light = height * np.exp(-0.5 * ((rows - middle) / STRIPE_SD_PX) ** 2)
        noise_sd = np.sqrt(READ_NOISE**2 + light / ELECTRONS_PER_LEVEL)
        seen = light + 5.0 + noise_sd * rng.normal(size=light.shape)
        pictures.append(np.clip(np.round(seen), 0, 255).astype(np.uint8))
    return pictures

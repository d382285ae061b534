"""Stands in for the library of a device's vendor: an arm and a camera, simulated.

A real vendor's library replaces this module. Nothing here knows Crenel.
"""

import threading
import time
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

WIDTH, HEIGHT = 96, 64
POLL_S = 0.002


class VendorError(Exception):
    """The device does not answer, or the connection is closed."""


@dataclass(frozen=True)
class ArmPacket:
    number: int
    time_us: int
    """On the device's own clock."""
    angles_deg: tuple[float, ...]
    buttons: frozenset[str]


@dataclass(frozen=True)
class Picture:
    number: int
    end_us: int
    """End of the exposure, on the device's own clock."""
    pixels: NDArray[np.uint8]
    """The library's buffer: the next picture overwrites it."""
    exposure_us: float
    laser_on: bool


@dataclass
class Device:
    """A simulated device, and what can happen to it."""

    period_us: int
    plugged: bool = True
    silent: bool = False
    lose: int = 0
    """So many of the next records are lost on the line."""
    connections: int = 0
    buttons: frozenset[str] = frozenset()
    exposure_us: float = 2000.0
    laser_on: bool = False
    number: int = 0
    start_ns: int = field(default_factory=time.monotonic_ns)
    next_us: int = 0

    def now_us(self) -> int:
        return (time.monotonic_ns() - self.start_ns) // 1000

    def due(self) -> list[tuple[int, int]]:
        """Number and time of every record since the last call."""
        records = []
        while self.next_us <= self.now_us():
            if not self.silent:
                if self.lose:
                    self.lose -= 1
                else:
                    records.append((self.number, self.next_us))
                self.number += 1
            self.next_us += self.period_us
        return records


DEVICES = {"arm-1": Device(period_us=2_000), "camera-1": Device(period_us=15_000)}


class Connection:
    def __init__(self, address: str) -> None:
        self.device = DEVICES[address]
        self.device.connections += 1
        self._closed = threading.Event()
        self._check()
        self.device.next_us = self.device.now_us()

    def wait(self, timeout_s: float) -> list[tuple[int, int]]:
        """Number and time of all new records; empty after the timeout."""
        deadline = time.monotonic() + timeout_s
        while True:
            self._check()
            records = self.device.due()
            if records or time.monotonic() >= deadline:
                return records
            self._closed.wait(POLL_S)

    def close(self) -> None:
        self._closed.set()

    def _check(self) -> None:
        if self._closed.is_set() or not self.device.plugged:
            raise VendorError("no connection")


class ArmConnection(Connection):
    joints, rate_hz, serial = 6, 500.0, "VA-17"

    def packets(self, timeout_s: float) -> list[ArmPacket]:
        return [
            ArmPacket(number, at_us, (10.0, 20.0, 30.0, 0.0, 0.0, 1e-3 * number), self.buttons())
            for number, at_us in self.wait(timeout_s)
        ]

    def buttons(self) -> frozenset[str]:
        return self.device.buttons


class CameraConnection(Connection):
    serial, exposure_range_us = "VC-4", (100.0, 10_000.0)

    def __init__(self, address: str) -> None:
        super().__init__(address)
        self._buffer = np.zeros((HEIGHT, WIDTH), np.uint8)

    def picture(self, timeout_s: float) -> Picture | None:
        """The newest picture; None after the timeout."""
        records = self.wait(timeout_s)
        if not records:
            return None
        number, end_us = records[-1]
        self._buffer[:] = 8
        if self.device.laser_on:
            self._buffer[number % HEIGHT] = 200
        device = self.device
        return Picture(number, end_us, self._buffer, device.exposure_us, device.laser_on)

    def set_exposure(self, exposure_us: float) -> None:
        self.device.exposure_us = exposure_us

    def set_laser(self, on: bool) -> None:
        self.device.laser_on = on

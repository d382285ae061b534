"""The two small interfaces that every driver meets, and the records they yield.

Drivers block: one thread opens, reads and closes a device. Nothing is touched
before ``open``; ``close`` may be called at any time, also from another thread,
and twice. A device that goes away raises ``DeviceError`` from ``read``; the
thread's owner closes it and opens it again with back-off.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Protocol

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, slots=True)
class JointSample:
    """One reading of all encoders."""

    sequence: int
    """Counts up by one a sample, as the device counted; a gap is a loss."""
    stamp_ns: int
    """Host-monotonic time at which the encoders were latched."""
    joints_rad: tuple[float, ...]
    """Encoder angles before the arm model's sign and offset."""


class Button(StrEnum):
    """What the operator pressed on the arm."""

    PRIMARY = "primary"
    UNDO = "undo"
    BACK = "back"


@dataclass(frozen=True, slots=True)
class ButtonEvent:
    """A button went down or up; a touch trigger counts as the primary button."""

    sequence: int
    stamp_ns: int
    button: Button
    pressed: bool


ArmRecord = JointSample | ButtonEvent


@dataclass(frozen=True, slots=True)
class Frame:
    """One image of the sensor's camera."""

    sequence: int
    """Counts up by one a frame, as the device counted; a gap is a loss."""
    mid_exposure_ns: int
    """Host-monotonic time of the middle of the exposure."""
    image: NDArray[np.uint8] | NDArray[np.uint16]
    """(height, width) grey."""
    exposure_us: float
    laser_on: bool


@dataclass(frozen=True, slots=True)
class ArmInfo:
    """What an arm says of itself once open."""

    name: str
    serial_number: str
    joint_count: int
    rate_hz: float


@dataclass(frozen=True, slots=True)
class SensorInfo:
    """What a sensor says of itself once open."""

    name: str
    serial_number: str
    width_px: int
    height_px: int
    exposure_range_us: tuple[float, float]
    """Shortest and longest exposure; equal where it cannot be set."""
    has_laser_switch: bool
    longest_gap_s: float = 0.0
    """A sensor whose pictures may come so far apart while it is there says so; else 0."""


@dataclass(slots=True)
class LinkHealth:
    """Counts since ``open``: what arrived, and what did not."""

    received: int = 0
    lost: int = 0
    corrupt: int = 0


class ArmDriver(Protocol):
    """An articulated arm that reports its encoders."""

    @property
    def health(self) -> LinkHealth: ...

    def open(self) -> ArmInfo:
        """Connects; raises ``DeviceError`` when the arm is not there or speaks another tongue."""

    def read(self, timeout_s: float) -> Sequence[ArmRecord]:
        """What has arrived since the last call, oldest first; empty after ``timeout_s``.

        Raises ``DeviceError`` when the arm was lost.
        """

    def close(self) -> None:
        """Releases the device; idempotent."""


class SensorDriver(Protocol):
    """A camera with a laser line."""

    @property
    def health(self) -> LinkHealth: ...

    def open(self) -> SensorInfo:
        """Connects; raises ``DeviceError`` when the camera is not there."""

    def read(self, timeout_s: float) -> Frame | None:
        """The next frame, or None after ``timeout_s``; raises ``DeviceError`` when lost."""

    def set_exposure_us(self, exposure_us: float) -> None:
        """Applies from one of the next frames on; clipped to the sensor's range."""

    def set_laser(self, on: bool) -> None:
        """Idempotent; may be called from any thread."""

    def close(self) -> None:
        """Switches the laser off and releases the device; idempotent."""

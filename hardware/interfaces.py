"""The two small interfaces that every driver implements, and the records that drivers return.

Driver methods may block: one thread opens, reads and closes a device. A driver does not access its
device before ``open``; ``close`` may be called at any time, from any thread, and repeatedly. If a
device is lost, ``read`` raises ``DeviceError``; the thread then closes it and opens it again, with
growing pauses.
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
    """Increases by one per sample, as counted by the device; a gap means lost samples."""
    stamp_ns: int
    """Host-monotonic time at which the encoders were latched."""
    joints_rad: tuple[float, ...]
    """Encoder angles before the arm model's sign and offset."""


class Button(StrEnum):
    """A button on the arm."""

    PRIMARY = "primary"
    UNDO = "undo"
    BACK = "back"


@dataclass(frozen=True, slots=True)
class ButtonEvent:
    """A button was pressed or released; a touch trigger counts as the primary button."""

    sequence: int
    stamp_ns: int
    button: Button
    pressed: bool


ArmRecord = JointSample | ButtonEvent


@dataclass(frozen=True, slots=True)
class Frame:
    """One image of the sensor's camera."""

    sequence: int
    """Increases by one per frame, as counted by the device; a gap means lost frames."""
    mid_exposure_ns: int
    """Host-monotonic time of the middle of the exposure."""
    image: NDArray[np.uint8] | NDArray[np.uint16]
    """(height, width) grey."""
    exposure_us: float
    laser_on: bool


@dataclass(frozen=True, slots=True)
class ArmInfo:
    """Properties of an arm, known after ``open``."""

    name: str
    serial_number: str
    joint_count: int
    rate_hz: float


@dataclass(frozen=True, slots=True)
class SensorInfo:
    """Properties of a sensor, known after ``open``."""

    name: str
    serial_number: str
    width_px: int
    height_px: int
    exposure_range_us: tuple[float, float]
    """Shortest and longest exposure; equal if it cannot be set."""
    has_laser_switch: bool
    longest_gap_s: float = 0.0
    """The longest interval between pictures of a sensor that works; 0 if unspecified."""


@dataclass(slots=True)
class LinkHealth:
    """Counts since ``open``: records received, lost and corrupt."""

    received: int = 0
    lost: int = 0
    corrupt: int = 0


class ArmDriver(Protocol):
    """An articulated arm that reports its encoders."""

    @property
    def health(self) -> LinkHealth: ...

    def open(self) -> ArmInfo:
        """Connects; raises ``DeviceError`` if the arm is missing or uses another protocol."""

    def read(self, timeout_s: float) -> Sequence[ArmRecord]:
        """All records since the last call, oldest first; empty after ``timeout_s``.

        Raises ``DeviceError`` if the arm was lost.
        """

    def close(self) -> None:
        """Releases the device; idempotent."""


class SensorDriver(Protocol):
    """A camera with a laser line."""

    @property
    def health(self) -> LinkHealth: ...

    def open(self) -> SensorInfo:
        """Connects; raises ``DeviceError`` if the camera is missing."""

    def read(self, timeout_s: float) -> Frame | None:
        """The next frame, or None after ``timeout_s``; raises ``DeviceError`` if the camera was
        lost."""

    def set_exposure_us(self, exposure_us: float) -> None:
        """Sets the exposure from one of the next frames on; clipped to the range of the sensor."""

    def set_laser(self, on: bool) -> None:
        """Switches the laser; idempotent, may be called from any thread."""

    def close(self) -> None:
        """Switches the laser off and releases the device; idempotent."""

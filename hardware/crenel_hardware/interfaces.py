"""The two small interfaces that every driver implements, and the records that drivers return.

Driver methods may block: one thread opens, reads and closes a device. A driver does not access its
device before ``open``; ``close`` may be called at any time, from any thread, and repeatedly. If a
device is lost, ``read`` raises ``DeviceError``; the thread then closes it and opens it again, with
growing pauses.

What only some devices can do is in protocols of its own: ``AnswersWhileSilent``, ``DeliversLines``
and ``PulseSource``. A driver offers them by having their methods.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Literal, Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from crenel.messages.message import Text


@dataclass(frozen=True, slots=True)
class JointSample:
    """One reading of all encoders."""

    sequence: int
    """Increases by one per sample, as counted by the device; a gap means lost samples."""
    stamp_ns: int
    """Host-monotonic time at which the encoders were latched."""
    joints_rad: tuple[float, ...]
    """Encoder angles before the arm model's sign and offset."""
    pulse: int | None = None
    """The trigger pulse at which the encoders were latched, counted from 1 since the pulses were
    started; None for a sample between pulses."""

    @property
    def reading(self) -> tuple[float, ...]:
        """(n,) the angles."""
        return self.joints_rad


@dataclass(frozen=True, slots=True)
class PoseSample:
    """One pose of the flange or the tool, as a robot or a measuring arm's own software reports it.

    The transform is ``T_arm_flange``: it maps the reported frame to the frame of the arm's base.
    """

    sequence: int
    """As of ``JointSample``."""
    stamp_ns: int
    """Host-monotonic time to which the pose belongs."""
    position_mm: tuple[float, float, float]
    quaternion_xyzw: tuple[float, float, float, float]
    """A unit quaternion; drivers refuse any other."""
    pulse: int | None = None
    """As of ``JointSample``."""

    @property
    def reading(self) -> tuple[float, ...]:
        """(7,) position and quaternion."""
        return (*self.position_mm, *self.quaternion_xyzw)


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


ArmReading = JointSample | PoseSample
ArmRecord = ArmReading | ButtonEvent

StampKind = Literal["arrival", "device", "pulse"]
"""Where time stamps come from: the arrival of the data at the host, the device's own clock, or
pulses that arm and camera count both. Arrival stamps vary by milliseconds, and cost accuracy in
motion."""


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
    full_scale: int | None = None
    """The largest value of the pixel format, such as 1023 of Mono10; None if unknown."""
    pulse: int | None = None
    """The number of the exposure's trigger pulse, in the camera's own count, which also counts
    frames that were lost; None for a camera without a trigger."""


@dataclass(frozen=True, slots=True)
class Line:
    """The laser line of one exposure, as a camera with a line finder of its own delivers it.

    At most one point per column of the picture, or per row, in the order of the columns or rows;
    none if no line was found.
    """

    sequence: int
    """As of ``Frame``; one count for frames and lines."""
    mid_exposure_ns: int
    """As of ``Frame``."""
    u: NDArray[np.float64]
    """(N,) columns in pixels of the whole picture, distorted as the lens does it; the centre of
    the top left pixel is 0."""
    v: NDArray[np.float64]
    """(N,) rows."""
    intensity: NDArray[np.float64]
    """(N,) height of the line above its background, in grey levels."""
    sigma_px: NDArray[np.float64]
    """(N,) standard deviation of the measured coordinate, above 0."""
    width_px: int
    """The width of the whole picture that u and v refer to."""
    height_px: int
    exposure_us: float
    laser_on: bool
    pulse: int | None = None
    """As of ``Frame``."""


SensorReading = Frame | Line
Delivery = Literal["picture", "line"]
"""What a sensor sends of an exposure."""


@dataclass(frozen=True, slots=True)
class ArmInfo:
    """Properties of an arm, known after ``open``."""

    name: str
    serial_number: str
    joint_count: int
    """0 of an arm that reports poses."""
    rate_hz: float
    reports: Literal["joints", "pose"] = "joints"
    pose_of: Literal["flange", "tool"] = "flange"
    """What the reported poses are of."""
    buttons: frozenset[Button] = frozenset(Button)
    """The buttons it has."""
    stamps: StampKind = "device"
    free_running: bool = True
    """False of an arm that reports only changes: its silence is no loss."""
    pulses_hz: tuple[float, float] | None = None
    """Lowest and highest rate of its trigger pulses; None of an arm that gives none."""


@dataclass(frozen=True, slots=True)
class SelectedColour:
    """What of a colour camera's pictures a driver makes grey ones of."""

    colour: Literal["red", "green", "blue"]
    bayer: Literal["RGGB", "BGGR", "GRBG", "GBRG"] | None
    """The colours of the first two pixels of raw pictures, and of the two below them; None where a
    channel of pictures in colour is taken."""


@dataclass(frozen=True, slots=True)
class OptionOffer:
    """What an open device offers for one option of its driver."""

    key: str
    choices: tuple[str, ...] = ()
    """The values; empty if it is no choice among a few."""
    bounds: tuple[float, float] | None = None
    """The smallest and largest value, in the unit of the option."""
    largest: str = ""
    """The largest value of an option with several numbers, as it would be entered."""


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
    stamps: StampKind = "arrival"
    stamp_at: Literal["exposure-start", "mid-exposure", "exposure-end", "frame-end"] = "frame-end"
    """The event that the device stamps; ``mid_exposure_ns`` has been computed from it."""
    free_running: bool = True
    """False of a camera that waits for a trigger: its silence is no loss."""
    delivers: frozenset[Delivery] = frozenset({"picture"})
    """What it can send. After ``open``, it sends pictures if it can."""
    loss_remedy: Text = ""
    """What to do on this computer if data are lost, where the driver sees that; otherwise empty."""
    offers: tuple[OptionOffer, ...] = ()
    """What the device offers for the driver's options, where it can be asked."""
    selected: SelectedColour | None = None
    """None of a grey camera, and where no colour is stated."""


@dataclass(slots=True)
class LinkHealth:
    """Counts since ``open``: records received, lost and corrupt."""

    received: int = 0
    lost: int = 0
    corrupt: int = 0
    late: int = 0
    """How many of those received or on their way come much too late because the line is too slow
    for all; only for drivers that notice that."""


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

    def read(self, timeout_s: float) -> Frame | Line | None:
        """The next frame or line, or None after ``timeout_s``; raises ``DeviceError`` if the
        camera was lost."""

    def set_exposure_us(self, exposure_us: float) -> None:
        """Sets the exposure from one of the next frames on; clipped to the range of the sensor."""

    def set_laser(self, on: bool) -> None:
        """Switches the laser; idempotent, may be called from any thread."""

    def close(self) -> None:
        """Switches the laser off and releases the device; idempotent."""


@runtime_checkable
class AnswersWhileSilent(Protocol):
    """A device that can be asked whether it is there when it sends nothing."""

    def is_alive(self) -> bool:
        """Whether the device answers; called by the reading thread after a silence."""


@runtime_checkable
class DeliversLines(Protocol):
    """A camera that can be switched between pictures and lines.

    A driver of several cameras may have this method for one that cannot; ``SensorInfo.delivers``
    decides.
    """

    def set_delivery(self, delivery: Delivery) -> None:
        """Sends this from one of the next exposures on; idempotent, from any thread.

        Raises ``DeviceError`` if the camera was lost or cannot deliver it.
        """


@runtime_checkable
class PulseSource(Protocol):
    """An arm that triggers the camera and latches its encoders at each pulse.

    A driver of several arms may have these methods for one without pulses: ``ArmInfo.pulses_hz``
    is then None.
    """

    def start_pulses(self, rate_hz: float) -> None:
        """Pauses the pulses for at least 0.3 s, then starts them, counted from 1.

        Raises ``DeviceError`` if the arm was lost or refuses the rate.
        """

    def stop_pulses(self) -> None:
        """Stops the pulses; idempotent."""

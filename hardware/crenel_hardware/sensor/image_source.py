"""An open camera or recording whose pictures a call waits for; ``grabbing`` makes it a driver."""

import threading
from abc import ABC, abstractmethod
from dataclasses import dataclass
from enum import Enum, auto
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from crenel.messages.message import Text, message
from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import Delivery, OptionOffer, SelectedColour, StampKind

GreyImage = NDArray[np.uint8] | NDArray[np.uint16]
StampAt = Literal["exposure-start", "mid-exposure", "exposure-end", "frame-end"]
"""The event to which a camera's time stamp belongs, as of ``SensorInfo.stamp_at``."""

_CATCH_UP_NS = 1_000_000_000


class EndOfRecordingError(Exception):
    """A recording has been shown to its end, or has to stop."""


@dataclass(frozen=True, slots=True)
class LinePoints:
    """The laser line in a picture that stayed in the camera, as of ``Line``."""

    u: NDArray[np.float64]
    v: NDArray[np.float64]
    intensity: NDArray[np.float64]
    sigma_px: NDArray[np.float64]
    size_px: tuple[int, int]
    """Width and height of the picture."""


@dataclass(frozen=True, slots=True)
class GrabbedImage:
    """A grey (height, width) image or the line in it, the middle of its exposure, and what its
    camera states."""

    image: GreyImage | LinePoints
    mid_exposure_ns: int
    exposure_us: float
    sequence: int | None = None
    """The device's own count, unwrapped, from 0 at its first picture: a gap means pictures that
    were lost. None if the device does not count."""
    full_scale: int | None = None
    """As of ``Frame``."""
    pulse: int | None = None
    """As of ``Frame``."""
    laser_on: bool = True
    late: bool = False
    """Held up by a line that is too slow."""


class NoImage(Enum):
    """Why ``grab`` returns no picture."""

    DAMAGED = auto()
    """A picture arrived that cannot be decoded."""
    SILENCE = auto()
    """Nothing arrived, and the device is there."""
    LATE = auto()
    """As ``SILENCE``, but a picture is on its way, and held up by a line that is too slow."""


class ImageSource(ABC):
    """An open camera or recording.

    One thread uses it; ``set_laser`` and ``is_alive`` may be called from any thread.
    """

    name: str
    serial_number = ""
    waits: bool
    """True of a recording, which waits for its reader; a camera does not, and old pictures are
    lost."""
    queue_length = 4
    """How many pictures wait for a late reader; more than these, and the oldest is lost."""
    exposure_range_us = (0.0, 0.0)
    has_laser_switch = False
    stamps: StampKind = "arrival"
    stamp_at: StampAt = "frame-end"
    free_running = True
    """False of a camera that waits for a trigger: it may be silent."""
    longest_gap_s = 0.0
    no_picture_remedy: Text = message("check-cable-no-other-program-uses")
    """What to do if the device is open and sends nothing."""
    loss_remedy: Text = ""
    """As of ``SensorInfo``."""
    offers: tuple[OptionOffer, ...] = ()
    """As of ``SensorInfo``."""
    selected: SelectedColour | None = None
    """As of ``SensorInfo``; known when the source is open, or with its first picture."""
    delivers: frozenset[Delivery] = frozenset({"picture"})
    """As of ``SensorInfo``; known when the source is open."""
    size_px: tuple[int, int] | None = None
    """Width and height; None if they are unknown until the first picture. Required of a camera
    that waits for a trigger."""

    @abstractmethod
    def grab(self) -> GrabbedImage | NoImage:
        """Waits for the next picture, and returns it; stamps increase.

        Raises:
            DeviceError: the source is lost.
            EndOfRecordingError: a recording is over, or has to stop.
        """

    def set_exposure_us(self, exposure_us: float) -> None:
        """Called only if the exposure range is not a point, with a value within it."""
        raise NotImplementedError(f"{self.name} has a fixed exposure")

    def set_delivery(self, delivery: Delivery) -> DeviceError | None:
        """Sends this from now on; called only with what it delivers, between two ``grab``.

        Returns:
            Why it goes on as before; None if it sends what is wanted.

        Raises:
            DeviceError: the source is lost.
        """
        raise NotImplementedError(f"{self.name} sends {delivery}s alone")

    def set_laser(self, on: bool) -> None:
        """Switches the laser; called only if there is a switch. Raises ``DeviceError``."""
        raise NotImplementedError(f"{self.name} has no laser switch")

    def is_alive(self) -> bool:
        """Whether the device answers; asked of a camera that waits for a trigger."""
        return True

    @abstractmethod
    def release(self) -> None: ...


class PlaybackTimer:
    """Shows a recording at its own rate.

    Stamps are a period apart, whenever the thread came to run; a reader that falls
    behind by more than a second makes them jump forward.
    """

    def __init__(self, rate_hz: float, stop: threading.Event) -> None:
        self._period_ns = 1e9 / rate_hz
        self._stop = stop
        self._due_ns = 0.0

    def wait(self) -> int:
        """Waits until the next picture is due; returns that time.

        Raises ``EndOfRecordingError`` when it has to stop.
        """
        now = now_ns()
        self._due_ns += self._period_ns
        if now - self._due_ns > _CATCH_UP_NS:
            self._due_ns = float(now)
        if self._stop.wait(max(0.0, (self._due_ns - now) / 1e9)):
            raise EndOfRecordingError
        return round(self._due_ns)

"""An open camera or recording, whose pictures a call waits for; ``grabbing`` makes it a driver."""

import threading
from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hardware.clock import now_ns

GreyImage = NDArray[np.uint8] | NDArray[np.uint16]

_CATCH_UP_NS = 1_000_000_000


class EndOfRecordingError(Exception):
    """A recording has been shown to its end."""


@dataclass(frozen=True, slots=True)
class GrabbedImage:
    """A grey (height, width) image and the middle of its exposure."""

    image: GreyImage
    mid_exposure_ns: int
    exposure_us: float


class ImageSource(ABC):
    """An open camera or recording; one thread uses it."""

    name: str
    serial_number = ""
    waits: bool
    """A recording waits for its reader; a camera does not, and old pictures are lost."""
    exposure_range_us = (0.0, 0.0)

    @abstractmethod
    def grab(self) -> GrabbedImage | None:
        """The next picture, waited for; None for a damaged one. Stamps increase.

        Raises ``DeviceError`` when the source is lost, ``EndOfRecordingError`` when a
        recording is over or when it has to stop.
        """

    def set_exposure_us(self, exposure_us: float) -> None:
        """Asked only of a source whose range is open, and within it."""
        raise NotImplementedError(f"{self.name} has a fixed exposure")

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

"""An arm whose controller streams its joints or poses, in front of any controller's protocol.

The driver of a controller is a ``ControllerStream``: it connects, and turns what arrives into
``RobotReading``. What is the same for all of them is here: opening and closing from any thread,
the controller's clock, counting what was lost, and refusing what cannot be true.
"""

import threading
import time
from collections.abc import Callable, Sequence
from typing import Annotated, Protocol

from pydantic import Field

from crenel.messages.message import Text, message, rounded
from crenel_hardware.arm.robots.readings import RobotReading, StreamJudge
from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmInfo, ArmRecord, LinkHealth
from crenel_hardware.options import Options
from crenel_hardware.shared_options import SERIAL, Address, ArmLatency, TimeoutSeconds

_SETTLE_S = 0.25
"""Readings are observed for this long before the first is returned, to learn the clock."""
_SILENCE_S = 2.5
"""A controller that sends nothing for so long is lost."""


class StreamOptions(Options):
    """Options of every arm that streams."""

    latency_us: ArmLatency = 0.0
    timeout_s: TimeoutSeconds = 3.0


class UnnumberedOptions(StreamOptions):
    """Options of an arm that does not state its serial number."""

    serial_number: Annotated[str, Field(max_length=60), SERIAL] = ""
    """As on its type plate: tells it from others of its kind."""


class RobotOptions(UnnumberedOptions):
    """Options of every controller in a network."""

    address: Address


class ControllerStream(Protocol):
    """One connection to a controller."""

    silence_remedy: Text
    """What to do if the controller sends nothing."""

    def start(self, timeout_s: float, health: LinkHealth) -> ArmInfo:
        """Connects and starts the stream; packets that cannot be read count in ``health``."""

    def receive(self, timeout_s: float) -> Sequence[RobotReading]:
        """Readings that have arrived, oldest first; empty after ``timeout_s``."""

    def close(self) -> None:
        """Ends the stream and a waiting call; idempotent, from any thread."""


class StreamingArm:
    """A robot or another device that streams. Implements ``ArmDriver``; commands nothing.

    Args:
        options: times.
        address: of the device, for messages.
        make: returns a stream for one connection, which has not touched the controller yet.
    """

    def __init__(
        self, options: StreamOptions, address: str, make: Callable[[], ControllerStream]
    ) -> None:
        self._options, self._address, self._make = options, address, make
        self._state = threading.Lock()
        self._closings = 0
        self._stream: ControllerStream | None = None
        self._info: ArmInfo | None = None
        self._health = LinkHealth()
        self._heard_s, self._corrupt_before = 0.0, 0

    @property
    def health(self) -> LinkHealth:
        return self._health

    def open(self) -> ArmInfo:
        """Connects, and waits until the controller sends; does nothing if it is open.

        Raises ``DeviceError`` if the controller is missing, refuses or sends nothing.
        """
        with self._state:
            if self._stream is not None and self._info is not None:
                return self._info
            closings = self._closings
            stream = self._stream = self._make()
        self._health = LinkHealth()
        try:
            info = stream.start(self._options.timeout_s, self._health)
            self._judge = StreamJudge(self._address, self._options.latency_us, info, self._health)
            self._settle(stream)
        except DeviceError:
            self._drop(stream)
            raise
        with self._state:
            if self._closings == closings:
                self._info = info
        if self._info is None:
            self._drop(stream)
            raise DeviceError(message("arm-closed-while-opening", url=self._address))
        return info

    def read(self, timeout_s: float) -> Sequence[ArmRecord]:
        """Samples or poses since the last call."""
        stream = self._stream
        if stream is None or self._info is None:
            raise DeviceError(message("arm-not-open", url=self._address))
        deadline = time.monotonic() + timeout_s
        try:
            while True:
                records = self._take(stream, deadline - time.monotonic(), _SILENCE_S)
                if records or time.monotonic() >= deadline:
                    return records
        except DeviceError:
            self._drop(stream)
            raise

    def close(self) -> None:
        """Releases the controller and ends a waiting ``open`` or ``read``; idempotent."""
        with self._state:
            self._closings += 1
            stream, self._stream, self._info = self._stream, None, None
        if stream is not None:
            stream.close()

    def _drop(self, stream: ControllerStream) -> None:
        with self._state:
            if self._stream is stream:
                self._stream, self._info = None, None
        stream.close()

    def _note_heard(self) -> None:
        self._heard_s, self._corrupt_before = time.monotonic(), self._health.corrupt

    def _settle(self, stream: ControllerStream) -> None:
        self._note_heard()
        until = None
        while until is None or time.monotonic() < until:
            if self._take(stream, 0.02, self._options.timeout_s) and until is None:
                until = time.monotonic() + _SETTLE_S

    def _take(
        self, stream: ControllerStream, timeout_s: float, silence_s: float
    ) -> list[ArmRecord]:
        """Records of what arrived, checked; raises ``DeviceError`` after ``silence_s`` without."""
        wait_s = max(0.0, min(timeout_s, self._heard_s + silence_s - time.monotonic()))
        arrived = stream.receive(wait_s)
        records = self._judge.accept(arrived, now_ns())
        if records:
            self._note_heard()
        elif time.monotonic() - self._heard_s >= silence_s:
            raise DeviceError(self._explain_silence(silence_s), stream.silence_remedy)
        return records

    def _explain_silence(self, silence_s: float) -> Text:
        time_s = rounded(silence_s, "s")
        if useless := self._health.corrupt - self._corrupt_before:
            return message(
                "robot-sends-only-useless", address=self._address, time=time_s, count=useless
            )
        return message("robot-sends-nothing", address=self._address, time=time_s)


def await_readings(stream: ControllerStream, count: int, timeout_s: float) -> list[RobotReading]:
    """The first readings of a stream; fewer than ``count`` after ``timeout_s``."""
    deadline = time.monotonic() + timeout_s
    found: list[RobotReading] = []
    while len(found) < count and (remaining_s := deadline - time.monotonic()) > 0:
        found += stream.receive(remaining_s)
    return found

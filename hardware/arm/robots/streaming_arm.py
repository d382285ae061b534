"""An arm whose controller streams its joints or poses, in front of any controller's protocol.

The driver of a controller is a ``ControllerStream``: it connects, and turns what arrives into
``RobotReading``. What is the same for all of them is here: opening and closing from any thread,
the controller's clock, counting what was lost, and refusing what cannot be true.
"""

import threading
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from math import isfinite, sqrt
from typing import Protocol

from pydantic import Field

from app.messages.message import Text, message, rounded
from hardware.clock import now_ns
from hardware.device_clock import DeviceClock
from hardware.errors import DeviceError
from hardware.interfaces import (
    ArmInfo,
    ArmReading,
    ArmRecord,
    Button,
    ButtonEvent,
    JointSample,
    LinkHealth,
    PoseSample,
)
from hardware.options import Options

_SETTLE_S = 0.25
"""Readings are observed for this long before the first is returned, to learn the clock."""
_SILENCE_S = 2.5
"""A controller that sends nothing for so long is lost."""
_REORDERED = 16
"""Datagrams may overtake each other by so many; a count further back is a restart."""
_JUMP_NS = 3_000_000_000
"""A clock or a count that gains more than this from one reading to the next has been set."""
_UNIT_TOLERANCE = 1e-3


class StreamOptions(Options):
    """Options of every arm that streams."""

    latency_us: float = Field(default=0.0, ge=0, le=100_000)
    timeout_s: float = Field(default=3.0, gt=0, le=60)


class RobotOptions(StreamOptions):
    """Options of every controller in a network."""

    address: str = Field(min_length=1)


@dataclass(frozen=True, slots=True)
class RobotReading:
    """One cycle of a controller, before it is checked."""

    device_ns: int
    """On the controller's clock, without wraps."""
    count: int | None = None
    """The controller's own count, without wraps; None if only its clock shows a loss."""
    joints_rad: tuple[float, ...] = ()
    position_mm: tuple[float, float, float] = (0.0, 0.0, 0.0)
    quaternion_xyzw: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)
    pressed: frozenset[Button] = frozenset()
    """The buttons that are down."""


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
        self._heard_s = 0.0

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
            self._judge = _ReadingJudge(self._options, self._address, info, self._health)
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

    def _settle(self, stream: ControllerStream) -> None:
        self._heard_s = time.monotonic()
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
            self._heard_s = time.monotonic()
        elif time.monotonic() - self._heard_s >= silence_s:
            raise DeviceError(
                message(
                    "robot-sends-nothing",
                    address=self._address,
                    time=rounded(silence_s, "s"),
                ),
                stream.silence_remedy,
            )
        return records


class _ReadingJudge:
    """Checks the readings of one connection, and puts them on the host's clock."""

    def __init__(
        self, options: StreamOptions, address: str, info: ArmInfo, health: LinkHealth
    ) -> None:
        self._address = address
        self._latency_ns = round(options.latency_us * 1000)
        self._info, self._health = info, health
        self._clock = DeviceClock()
        self._last: RobotReading | None = None
        self._last_arrival_ns = 0
        self._sequence = 0
        self._pressed: frozenset[Button] | None = None

    def accept(self, readings: Sequence[RobotReading], arrival_ns: int) -> list[ArmRecord]:
        """Samples or poses, each before the edges of its buttons; raises ``DeviceError`` for what
        cannot be true."""
        for reading in readings:
            self._require_numbers(reading)
        fresh: list[tuple[int, RobotReading]] = []
        for reading in readings:
            if self._advance(reading, arrival_ns):
                fresh.append((self._sequence, reading))
        records: list[ArmRecord] = []
        for sequence, reading in fresh:
            sample = self._convert(sequence, reading)
            records.append(sample)
            records += self._edges(sample, reading.pressed)
        return records

    def _edges(self, sample: ArmReading, pressed: frozenset[Button]) -> list[ButtonEvent]:
        before, self._pressed = self._pressed, pressed
        changed = pressed ^ before if before is not None else frozenset()
        return [
            ButtonEvent(sample.sequence, sample.stamp_ns, button, button in pressed)
            for button in sorted(changed)
        ]

    def _advance(self, reading: RobotReading, arrival_ns: int) -> bool:
        """Counts a reading and notes its time; False for a repeated or overtaken one."""
        last = self._last
        if last is not None:
            step, step_ns = self._step_from(last, reading), reading.device_ns - last.device_ns
            if step == 0 or -_REORDERED <= step < 0:
                self._health.corrupt += 1
                return False
            waited_ns = arrival_ns - self._last_arrival_ns
            counted_ns = step * 1e9 / self._info.rate_hz
            if step < 0 or step_ns < 0 or max(step_ns, counted_ns) > waited_ns + _JUMP_NS:
                raise DeviceError(
                    message("robot-clock-jumped", address=self._address), message("opens-again")
                )
            self._sequence += step
            self._health.lost += step - 1
        self._health.received += 1
        self._last, self._last_arrival_ns = reading, arrival_ns
        self._clock.observe(reading.device_ns, arrival_ns)
        return True

    def _step_from(self, last: RobotReading, reading: RobotReading) -> int:
        if last.count is not None and reading.count is not None:
            return reading.count - last.count
        step_ns = reading.device_ns - last.device_ns
        steps = round(step_ns * self._info.rate_hz / 1e9)
        return max(1, steps) if step_ns > 0 else steps

    def _convert(self, sequence: int, reading: RobotReading) -> ArmReading:
        stamp_ns = self._clock.stamp(reading.device_ns) - self._latency_ns
        if self._info.reports == "joints":
            return JointSample(sequence, stamp_ns, reading.joints_rad)
        x, y, z, w = reading.quaternion_xyzw
        length = sqrt(x * x + y * y + z * z + w * w)
        unit = (x / length, y / length, z / length, w / length)
        return PoseSample(sequence, stamp_ns, reading.position_mm, unit)

    def _require_numbers(self, reading: RobotReading) -> None:
        values = (*reading.joints_rad, *reading.position_mm, *reading.quaternion_xyzw)
        require_finite(self._address, values)
        require_unit(self._address, reading.quaternion_xyzw)
        if self._info.reports == "joints" and len(reading.joints_rad) != self._info.joint_count:
            raise DeviceError(
                message(
                    "arm-sends-other-joint-count",
                    url=self._address,
                    expected=self._info.joint_count,
                    count=len(reading.joints_rad),
                ),
                message("check-what-robot-sends"),
            )


def require_finite(address: str, values: Iterable[float]) -> None:
    """Raises ``DeviceError`` if one of a controller's values is no number or infinite."""
    if not all(isfinite(value) for value in values):
        raise DeviceError(
            message("robot-sends-no-numbers", address=address), message("restart-robot-controller")
        )


def require_unit(address: str, quaternion: Sequence[float]) -> None:
    """Raises ``DeviceError`` if a controller's quaternion has another length than one."""
    length = sqrt(sum(value * value for value in quaternion))
    if abs(length - 1) > _UNIT_TOLERANCE:
        raise DeviceError(
            message("robot-quaternion-not-unit", address=address, length=rounded(length, digits=4)),
            message("check-what-robot-sends"),
        )


class WrappingCounter:
    """Continues a counter of a controller beyond its largest value."""

    def __init__(self, modulus: int) -> None:
        self._modulus = modulus
        self._last: int | None = None

    def unwrap(self, value: int) -> int:
        """The value without wraps: the one nearest to the last."""
        if self._last is None:
            self._last = value
        else:
            step = (value - self._last) % self._modulus
            self._last += step - self._modulus if step >= self._modulus // 2 else step
        return self._last


def await_readings(stream: ControllerStream, count: int, timeout_s: float) -> list[RobotReading]:
    """The first readings of a stream; fewer than ``count`` after ``timeout_s``."""
    deadline = time.monotonic() + timeout_s
    found: list[RobotReading] = []
    while len(found) < count and (remaining_s := deadline - time.monotonic()) > 0:
        found += stream.receive(remaining_s)
    return found

"""Readings of a controller that streams: checked, counted, and put on the host's clock."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import isfinite, sqrt

from crenel.messages.message import message, rounded
from crenel_hardware.device_clock import DeviceClock
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import (
    ArmInfo,
    ArmReading,
    ArmRecord,
    Button,
    ButtonEvent,
    JointSample,
    LinkHealth,
    PoseSample,
)

_REORDERED = 16
"""Datagrams may overtake each other by so many; a count further back is a restart."""
_JUMP_NS = 3_000_000_000
"""A clock or a count that gains more than this from one reading to the next has been set."""
_UNIT_TOLERANCE = 1e-3
_LARGEST = 1e15
"""No quantity of an arm is larger, in whatever unit."""


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


class StreamJudge:
    """Checks the readings of one connection, and puts them on the host's clock.

    Args:
        address: of the device, for messages.
        latency_us: least time from measuring to arrival.
        info: what the device says it sends.
        health: counts received, lost and corrupt readings.
    """

    def __init__(self, address: str, latency_us: float, info: ArmInfo, health: LinkHealth) -> None:
        self._address = address
        self._latency_ns = round(latency_us * 1000)
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
    """Raises ``DeviceError`` if one of a controller's values is no number, infinite, or so large
    that its square is."""
    if not all(isfinite(value) and abs(value) <= _LARGEST for value in values):
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
            self._last += step - self._modulus if 2 * step >= self._modulus else step
        return self._last

"""The ``serial-encoder`` driver: an arm that sends the counts of its encoders as packets.

``hardware/arm/protocol.py`` describes the bytes on the line, for developers of an arm's firmware or
of an adapter for an existing arm. In station.toml::

    [arm]
    driver = "serial-encoder"
    url = "/dev/ttyUSB0"        # or "COM5", "socket://192.168.1.20:7431", "rfc2217://…"
    baudrate = 921600           # ignored where the line has none
    joint_count = 6             # optional: refuse any other arm
    counts_per_revolution = 8388608   # optional: instead of what the arm says; or a list
    latency_us = 0              # optional: least time from latching to arrival here
    timeout_s = 3.0             # how long ``open`` waits for the arm to speak
"""

import threading
import time
from collections.abc import Mapping, Sequence
from math import pi

from pydantic import Field, PositiveInt

from app.messages.message import message, rounded
from hardware.arm.protocol import HELLO_REQUEST, Hello, PacketReader, Sample
from hardware.arm.wire import Wire
from hardware.clock import now_ns
from hardware.device_clock import DeviceClock
from hardware.errors import DeviceError
from hardware.interfaces import ArmInfo, ArmRecord, Button, ButtonEvent, JointSample, LinkHealth
from hardware.options import Options, read_options

_BUTTON_BITS = ((1, Button.PRIMARY), (2, Button.UNDO), (4, Button.BACK))
_ASK_EVERY_S = 0.5
_SETTLE_S = 0.25
"""Samples are observed for this long before the first is returned, to learn the clock."""


class SerialEncoderOptions(Options):
    """Options of the driver in station.toml."""

    url: str = Field(min_length=1)
    baudrate: PositiveInt = 921_600
    joint_count: int | None = Field(default=None, ge=6, le=7)
    counts_per_revolution: PositiveInt | list[PositiveInt] | None = None
    latency_us: float = Field(default=0.0, ge=0, le=100_000)
    timeout_s: float = Field(default=3.0, gt=0, le=60)


def from_options(options: Mapping[str, object]) -> "SerialEncoderArm":
    """The driver for an ``[arm]`` table of station.toml; raises ``DeviceError``."""
    return SerialEncoderArm(read_options(SerialEncoderOptions, options, "arm"))


class SerialEncoderArm:
    """An encoder arm on a serial line or a TCP stream. Implements ``ArmDriver``."""

    def __init__(self, options: SerialEncoderOptions) -> None:
        self._options = options
        self._state = threading.Lock()
        self._closings = 0
        self._wire: Wire | None = None
        self._info: ArmInfo | None = None
        self._health = LinkHealth()

    @property
    def health(self) -> LinkHealth:
        return self._health

    def open(self) -> ArmInfo:
        """Connects and waits until the arm has identified itself and sends samples.

        Does nothing if the arm is already open. Raises ``DeviceError`` if the port cannot be
        opened, if nothing or something else responds, or if the arm is not the expected one.
        """
        with self._state:
            if self._wire is not None and self._info is not None:
                return self._info
            closings = self._closings
        wire = Wire(self._options.url, self._options.baudrate)
        with self._state:
            if self._closings == closings:
                self._wire = wire
        if self._wire is not wire:
            wire.close()
            raise DeviceError(message("arm-closed-while-opening", url=self._options.url))
        self._health = LinkHealth()
        self._stream = _Stream(self._options, self._health)
        try:
            hello = self._await_arm(wire)
        except DeviceError:
            self._drop(wire)
            raise
        self._info = ArmInfo(
            name=hello.name or "encoder arm",
            serial_number=hello.serial_number,
            joint_count=len(hello.counts_per_revolution),
            rate_hz=hello.rate_hz,
        )
        return self._info

    def read(self, timeout_s: float) -> Sequence[ArmRecord]:
        """Samples and button edges since the last call; a sample comes before its edges."""
        wire = self._wire
        if wire is None:
            raise DeviceError(message("arm-not-open", url=self._options.url))
        deadline = time.monotonic() + timeout_s
        try:
            while True:
                data = wire.receive(deadline - time.monotonic())
                records = self._stream.records(data, now_ns())
                if records or time.monotonic() >= deadline:
                    return records
        except DeviceError:
            self._drop(wire)
            raise

    def close(self) -> None:
        """Releases the port and ends a waiting ``open`` or ``read``; idempotent."""
        with self._state:
            self._closings += 1
            wire, self._wire, self._info = self._wire, None, None
        if wire is not None:
            wire.close()

    def _drop(self, wire: Wire) -> None:
        with self._state:
            if self._wire is wire:
                self._wire, self._info = None, None
        wire.close()

    def _await_arm(self, wire: Wire) -> Hello:
        stream = self._stream
        start = time.monotonic()
        asked = start - _ASK_EVERY_S
        while stream.hello is None or not stream.settled:
            now = time.monotonic()
            if now - start >= self._options.timeout_s + _SETTLE_S:
                raise stream.silence_error()
            if stream.hello is None and now - asked >= _ASK_EVERY_S:
                wire.send(HELLO_REQUEST)
                asked = now
            stream.records(wire.receive(0.02), now_ns())
        return stream.hello


class _Stream:
    """Converts the bytes of one connection into records."""

    def __init__(self, options: SerialEncoderOptions, health: LinkHealth) -> None:
        self._options = options
        self._health = health
        self._reader = PacketReader()
        self._clock = DeviceClock()
        self._latency_ns = round(options.latency_us * 1000)
        self._repeated = 0
        self._last: Sample | None = None
        self._sequence = 0
        self._first_ns: int | None = None
        self._scale: tuple[float, ...] = ()
        self.hello: Hello | None = None
        self.settled = False

    def records(self, data: bytes, arrival_ns: int) -> list[ArmRecord]:
        """Records of the packets that ``data`` completes; none before the stream has settled."""
        records: list[ArmRecord] = []
        for packet in self._reader.feed(data):
            if isinstance(packet, Hello):
                self._greet(packet)
                continue
            before = self._last
            if not self._advance(packet):
                continue
            self._clock.observe(packet.device_us * 1000, arrival_ns)
            if self.hello is not None and self._is_settled(arrival_ns):
                self._append(records, packet, before)
        self._health.corrupt = self._reader.corrupt + self._repeated
        return records

    def silence_error(self) -> DeviceError:
        """Why ``open`` gave up."""
        url, reader = self._options.url, self._reader
        if self.hello is not None:
            return DeviceError(
                message("arm-sends-hello-but-no-samples", url=url, name=self.hello.name),
                message("switch-arm-off"),
            )
        if self._last is not None:
            return DeviceError(
                message("arm-sends-samples-but-no-hello", url=url),
                message("firmware-must-answer-hello"),
            )
        if reader.other_version is not None:
            return DeviceError(
                message(
                    "arm-speaks-version-protocol-driver-speaks",
                    url=url,
                    other_version=reader.other_version,
                ),
                message("update-program-arms-firmware"),
            )
        if reader.received_bytes:
            return DeviceError(
                message(
                    "bytes-but-no-packet",
                    count=reader.received_bytes,
                    url=url,
                ),
                message("check-baud-rate-arm-port-another"),
            )
        return DeviceError(
            message("nothing-came-for", url=url, time=rounded(self._options.timeout_s, "s")),
            message("switch-arm-check-cable-port"),
        )

    def _greet(self, hello: Hello) -> None:
        options, joints = self._options, len(hello.counts_per_revolution)
        if self.hello is None:
            self._scale = tuple(2 * pi / counts for counts in _counts(options, hello))
            self.hello = hello
        elif hello != self.hello:
            raise DeviceError(
                message(
                    "another-arm-answers",
                    url=options.url,
                    name=hello.name,
                    serial_number=hello.serial_number,
                    joints=joints,
                    expected_name=self.hello.name,
                    expected_serial_number=self.hello.serial_number,
                ),
                message("check-which-arm-plugged"),
            )

    def _advance(self, sample: Sample) -> bool:
        """Checks the sequence number; False for a repeated sample."""
        last, self._last = self._last, sample
        step = 1
        if last is None:
            self._sequence = sample.sequence - 1
        elif sample.device_us < last.device_us or self._step_from(last, sample) >= 1 << 31:
            self._clock.restart()
        elif (step := self._step_from(last, sample)) == 0:
            self._repeated += 1
            return False
        self._sequence += step
        self._health.received += 1
        self._health.lost += step - 1
        return True

    @staticmethod
    def _step_from(last: Sample, sample: Sample) -> int:
        return (sample.sequence - last.sequence) % (1 << 32)

    def _is_settled(self, arrival_ns: int) -> bool:
        if self._first_ns is None:
            self._first_ns = arrival_ns
        self.settled = self.settled or arrival_ns - self._first_ns >= _SETTLE_S * 1e9
        return self.settled

    def _append(self, records: list[ArmRecord], sample: Sample, before: Sample | None) -> None:
        if len(sample.counts) != len(self._scale):
            raise DeviceError(
                message(
                    "arm-sends-other-joint-count",
                    url=self._options.url,
                    expected=len(self._scale),
                    count=len(sample.counts),
                ),
                message("firmware-must-send-counts-of-hello"),
            )
        stamp_ns = self._clock.stamp(sample.device_us * 1000) - self._latency_ns
        joints = tuple(
            count * scale for count, scale in zip(sample.counts, self._scale, strict=True)
        )
        records.append(JointSample(self._sequence, stamp_ns, joints))
        changed = sample.buttons ^ before.buttons if before is not None else 0
        for bit, button in _BUTTON_BITS:
            if changed & bit:
                pressed = bool(sample.buttons & bit)
                records.append(ButtonEvent(self._sequence, stamp_ns, button, pressed))


def _counts(options: SerialEncoderOptions, hello: Hello) -> tuple[int, ...]:
    """Counts per revolution for this arm; raises ``DeviceError`` for a wrong arm."""
    joints = len(hello.counts_per_revolution)
    if joints not in (6, 7):
        raise DeviceError(
            message("arm-reports-joints", url=options.url, joints=joints),
            message("arms-6-7-joints-served"),
        )
    if options.joint_count not in (None, joints):
        raise DeviceError(
            message(
                "arm-has-joints-station-toml-asks",
                url=options.url,
                name=hello.name,
                serial_number=hello.serial_number,
                joints=joints,
                joint_count=options.joint_count,
            ),
            message("plug-right-arm-correct-arm-joint"),
        )
    given = options.counts_per_revolution
    if given is None:
        counts = hello.counts_per_revolution
    else:
        counts = tuple(given) if isinstance(given, list) else (given,) * joints
    if len(counts) != joints:
        raise DeviceError(
            message("station-toml-gives-counts-per-revolution", counts=len(counts), joints=joints),
            message("give-one-number-all-joints-one"),
        )
    if 0 in counts:
        raise DeviceError(
            message(
                "arm-reports-no-counts-per-revolution", url=options.url, joint=counts.index(0) + 1
            ),
            message("set-arm-counts-per-revolution-station"),
        )
    return counts

"""The driver ``bridge``, also named ``serial-encoder``: an arm that sends packets over a line.

The arm is an encoder arm with firmware of its own, which reports the counts of its encoders, or a
bridge: a program or converter for an existing arm or robot, which reports poses.
``crenel_hardware.arm.protocol`` describes the bytes on the line. In station.toml::

    [arm]
    driver = "bridge"           # or "serial-encoder", the same driver
    url = "/dev/ttyUSB0"        # or "COM5", "socket://192.168.1.20:7431", "rfc2217://…"
    baudrate = 921600           # ignored where the line has none
    joint_count = 6             # optional: refuse any other arm
    counts_per_revolution = 8388608   # optional: instead of what the arm says; or a list
    setting = 17                # optional: refuse poses with another number of tool and base
    latency_us = 0              # optional: least time from latching to arrival here
    timeout_s = 3.0             # how long ``open`` waits for the arm to speak
"""

import random
import threading
import time
from collections.abc import Callable, Mapping, Sequence

from crenel.messages.message import message, rounded
from crenel_hardware.arm.expected_arm import SerialEncoderOptions, arm_info
from crenel_hardware.arm.packet_stream import SETTLE_S, PacketStream
from crenel_hardware.arm.protocol import HELLO_REQUEST, Hello, PulseAnswer, pulse_request
from crenel_hardware.arm.wire import Wire
from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmInfo, ArmRecord, LinkHealth
from crenel_hardware.options import read_options

_ASK_EVERY_S = 0.5
_ASK_PULSES_EVERY_S, _PULSE_ANSWER_S = 0.2, 2.0
_ALIVE_S = 1.5
_SLICE_S = 0.02


def from_options(options: Mapping[str, object]) -> "SerialEncoderArm":
    """The driver for an ``[arm]`` table of station.toml; raises ``DeviceError``."""
    return SerialEncoderArm(read_options(SerialEncoderOptions, options, "arm"))


class SerialEncoderArm:
    """An arm on a serial line or a TCP stream.

    Implements ``ArmDriver``, ``AnswersWhileSilent`` and, if the arm has pulses, ``PulseSource``.
    """

    def __init__(self, options: SerialEncoderOptions) -> None:
        self._options = options
        self._state = threading.Lock()
        self._reading = threading.Lock()
        self._requesting = threading.Lock()
        self._closings = 0
        self._wire: Wire | None = None
        self._info: ArmInfo | None = None
        self._health = LinkHealth()
        self._stream = PacketStream(options, self._health)
        self._waiting: list[ArmRecord] = []
        self._request = random.randrange(256)

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
        self._stream = PacketStream(self._options, self._health)
        try:
            info = arm_info(self._await_arm(wire))
            self._waiting = []
            if info.pulses_hz is not None:
                self._set_pulses(wire, 0.0)  # of a host that went away
        except DeviceError:
            self._drop(wire)
            raise
        self._info = info
        return info

    def read(self, timeout_s: float) -> Sequence[ArmRecord]:
        """Samples and button edges since the last call; a sample comes before its edges."""
        wire = self._open_wire()
        deadline = time.monotonic() + timeout_s
        with self._reading:
            records, self._waiting = self._waiting, []
            try:
                while not records:
                    records = self._receive(wire, deadline - time.monotonic())
                    if time.monotonic() >= deadline:
                        break
            except DeviceError:
                self._drop(wire)
                raise
        return records

    def is_alive(self) -> bool:
        """Whether the arm answers a hello request; see ``AnswersWhileSilent``."""
        stream = self._stream
        hellos = stream.hellos
        try:
            wire = self._open_wire()
            wire.send(HELLO_REQUEST)
            self._await(wire, lambda: stream.hellos > hellos, _ALIVE_S)
        except DeviceError:
            return False
        return stream.hellos > hellos

    def start_pulses(self, rate_hz: float) -> None:
        """Starts the arm's trigger pulses, counted from 1; see ``PulseSource``."""
        wire, info, url = self._open_wire(), self._info, self._options.url
        pulses_hz = None if info is None else info.pulses_hz
        if pulses_hz is None:
            raise DeviceError(
                message("arm-has-no-trigger-pulses", url=url), message("trigger-camera-otherwise")
            )
        low, high = pulses_hz
        refusal = DeviceError(
            message("arm-refuses-pulse-rate", url=url, rate=rounded(rate_hz, "Hz")),
            message("choose-pulse-rate", low=rounded(low, "Hz"), high=rounded(high, "Hz")),
        )
        if not (rate_hz >= 0.001 and low <= rate_hz <= high):
            raise refusal
        if not self._set_pulses(wire, rate_hz).done:
            raise refusal

    def stop_pulses(self) -> None:
        """Stops the arm's trigger pulses; idempotent."""
        wire = self._wire
        if wire is not None and self._stream.pulses_run:
            self._set_pulses(wire, 0.0)

    def close(self) -> None:
        """Releases the port and ends a waiting ``open`` or ``read``; idempotent."""
        with self._state:
            self._closings += 1
            wire, self._wire, self._info = self._wire, None, None
        if wire is not None:
            wire.close()

    def _open_wire(self) -> Wire:
        wire = self._wire
        if wire is None:
            raise DeviceError(message("arm-not-open", url=self._options.url))
        return wire

    def _drop(self, wire: Wire) -> None:
        with self._state:
            if self._wire is wire:
                self._wire, self._info = None, None
        wire.close()

    def _receive(self, wire: Wire, timeout_s: float) -> list[ArmRecord]:
        data = wire.receive(timeout_s)
        return self._stream.records(data, now_ns())

    def _await_arm(self, wire: Wire) -> Hello:
        stream = self._stream
        start = time.monotonic()
        asked = start - _ASK_EVERY_S
        while stream.hello is None or not stream.is_ready:
            now = time.monotonic()
            if now - start >= self._options.timeout_s + SETTLE_S:
                raise stream.silence_error()
            if stream.hello is None and now - asked >= _ASK_EVERY_S:
                wire.send(HELLO_REQUEST)
                asked = now
            self._receive(wire, _SLICE_S)
        return stream.hello

    def _set_pulses(self, wire: Wire, rate_hz: float) -> PulseAnswer:
        """Sends a pulse request until it is answered; raises ``DeviceError`` if it never is."""
        stream = self._stream
        with self._requesting:
            self._request = (self._request + 1) % 256
            stream.expect_answer(self._request)
            give_up = time.monotonic() + _PULSE_ANSWER_S
            while stream.answer is None and time.monotonic() < give_up:
                wire.send(pulse_request(self._request, rate_hz))
                self._await(wire, lambda: stream.answer is not None, _ASK_PULSES_EVERY_S)
            if stream.answer is None:
                self._drop(wire)
                raise DeviceError(
                    message("arm-does-not-answer-pulse-request", url=self._options.url),
                    message("firmware-must-answer-pulse-request"),
                )
            return stream.answer

    def _await(self, wire: Wire, done: Callable[[], bool], timeout_s: float) -> None:
        """Receives until ``done``, unless another thread does; records are kept for ``read``."""
        deadline = time.monotonic() + timeout_s
        while not done() and time.monotonic() < deadline:
            if self._wire is not wire:
                raise DeviceError(message("arm-not-open", url=self._options.url))
            if self._reading.acquire(timeout=_SLICE_S):
                try:
                    self._waiting += self._receive(wire, _SLICE_S)
                except DeviceError:
                    self._drop(wire)
                    raise
                finally:
                    self._reading.release()

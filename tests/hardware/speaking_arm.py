"""A device that speaks the encoder protocol, written from its description alone.

It sits at the far end of a pseudo-terminal or of a TCP connection and shares no code
with the driver.
"""

import contextlib
import os
import socket
import struct
import threading
import time
import tty
import zlib
from abc import ABC, abstractmethod
from collections.abc import Sequence
from types import SimpleNamespace
from typing import Protocol, Self

import serial
from serial.rfc2217 import PortManager

from tests.hardware.conformance import ArmBench

REQUEST = bytes.fromhex("A75C0181002F1A1BDC")
COUNTS = 1 << 20
WAITING_BYTES = 1 << 16
"""What a host that is held up may leave unread, beyond what the terminal holds."""


def packet(kind: int, payload: bytes, version: int = 1) -> bytes:
    body = bytes([version, kind, len(payload)]) + payload
    return b"\xa7\x5c" + body + struct.pack("<I", zlib.crc32(body))


def sample_payload(sequence: int, device_us: int, buttons: int, counts: list[int]) -> bytes:
    head = struct.pack("<IQBB", sequence & 0xFFFFFFFF, device_us, buttons, len(counts))
    return head + struct.pack(f"<{len(counts)}i", *counts)


def sample_packet(sequence: int, device_us: int, buttons: int, counts: list[int]) -> bytes:
    return packet(1, sample_payload(sequence, device_us, buttons, counts))


def hello_packet(
    counts: list[int], rate_hz: float = 1000.0, name: str = "Bench arm", serial: str = "B-1"
) -> bytes:
    head = struct.pack("<BI", len(counts), round(rate_hz * 1000))
    texts = struct.pack("<32s16s16s", name.encode(), serial.encode(), b"1.0")
    return packet(2, head + struct.pack(f"<{len(counts)}I", *counts) + texts)


def hello_2_packet(
    counts: list[int],
    rate_hz: float = 1000.0,
    properties: int = 0,
    buttons: int = 7,
    setting: int = 0,
    pulses_hz: tuple[float, float] = (0.0, 0.0),
    name: str = "Bench arm",
    serial: str = "B-1",
) -> bytes:
    low, high = (round(rate * 1000) for rate in pulses_hz)
    head = struct.pack(
        "<BIBBIII", len(counts), round(rate_hz * 1000), properties, buttons, setting, low, high
    )
    texts = struct.pack("<32s16s16s", name.encode(), serial.encode(), b"2.0")
    return packet(2, head + struct.pack(f"<{len(counts)}I", *counts) + texts, 2)


def pose_payload(
    sequence: int,
    device_us: int,
    buttons: int,
    setting: int,
    position_mm: Sequence[float],
    quaternion_xyzw: Sequence[float],
) -> bytes:
    head = struct.pack("<IQBI", sequence & 0xFFFFFFFF, device_us, buttons, setting)
    return head + struct.pack("<7d", *position_mm, *quaternion_xyzw)


def pulse_packet(number: int, kind: int, payload: bytes) -> bytes:
    return packet(4, struct.pack("<IB", number, kind) + payload, 2)


class Line(Protocol):
    """The device's end of a line."""

    url: str

    def write(self, data: bytes) -> None: ...
    def read(self) -> bytes: ...
    def unplug(self) -> None: ...
    def plug_in(self) -> None: ...


class PtyLine:
    """A pseudo-terminal behind a symbolic link, as udev gives an arm a stable name."""

    def __init__(self, folder: os.PathLike[str]) -> None:
        self.url = os.path.join(folder, "ttyARM")
        self._ends: tuple[int, int] | None = None
        self._waiting = b""
        self.plug_in()

    def plug_in(self) -> None:
        if self._ends is None:
            self._ends = os.openpty()
            tty.setraw(self._ends[1])
            os.set_blocking(self._ends[0], False)
            os.symlink(os.ttyname(self._ends[1]), self.url)

    def unplug(self) -> None:
        ends, self._ends = self._ends, None
        self._waiting = b""
        if ends is not None:
            os.unlink(self.url)
            for end in ends:
                os.close(end)

    def write(self, data: bytes) -> None:
        if len(self._waiting) < WAITING_BYTES:  # else nobody reads
            self._waiting += data
        with contextlib.suppress(OSError):  # the terminal is full
            if self._ends is not None:
                self._waiting = self._waiting[os.write(self._ends[0], self._waiting) :]

    def read(self) -> bytes:
        with contextlib.suppress(OSError):
            if self._ends is not None:
                return os.read(self._ends[0], 4096)
        return b""


class TcpLine:
    """A TCP server for one client at a time."""

    def __init__(self) -> None:
        self._server: socket.socket | None = None
        self._client: socket.socket | None = None
        self._port = 0
        self.plug_in()
        self.url = f"socket://127.0.0.1:{self._port}"

    def plug_in(self) -> None:
        if self._server is None:
            self._server = socket.create_server(("127.0.0.1", self._port))
            self._server.setblocking(False)
            self._port = self._server.getsockname()[1]

    def unplug(self) -> None:
        for end in (self._client, self._server):
            if end is not None:
                end.close()
        self._client = self._server = None

    def write(self, data: bytes) -> None:
        with contextlib.suppress(OSError):
            if self._client is not None:
                self._client.sendall(data)

    def read(self) -> bytes:
        with contextlib.suppress(OSError):
            if self._server is not None:
                fresh, _ = self._server.accept()
                if self._client is not None:
                    self._client.close()
                fresh.setblocking(False)
                self._client = fresh
        with contextlib.suppress(OSError):
            if self._client is not None:
                data = self._client.recv(4096)
                if not data:
                    self._client.close()
                    self._client = None
                return data
        return b""


class Rfc2217Line(TcpLine):
    """A serial port that a terminal server offers over telnet (RFC 2217)."""

    def __init__(self) -> None:
        super().__init__()
        self.url = self.url.replace("socket:", "rfc2217:")
        self._served: socket.socket | None = None
        self._port_settings = serial.serial_for_url("loop://")
        self._manager: PortManager | None = None

    def write(self, data: bytes) -> None:
        if self._manager is not None:
            super().write(b"".join(self._manager.escape(data)))

    def read(self) -> bytes:
        data = super().read()
        if self._client is not self._served:
            self._served, self._manager = self._client, None
            if self._client is not None:
                self._manager = PortManager(
                    self._port_settings, SimpleNamespace(write=super().write)
                )
        return b"" if self._manager is None else b"".join(self._manager.filter(data))


class SpeakingDevice(ABC):
    """Works on a thread of its own, until it is stopped.

    Attributes may be changed while it runs: ``silent`` (nothing is sent), ``skip`` (so many samples
    are taken and not sent).
    """

    def __init__(self, line: Line, pause_s: float) -> None:
        self.line = line
        self.silent = False
        self.skip = 0
        self._pause_s = pause_s
        self._running = True
        self._lock = threading.Lock()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()

    def unplug(self) -> None:
        with self._lock:
            self.line.unplug()

    def plug_in(self) -> None:
        with self._lock:
            self.line.plug_in()

    def stop(self) -> None:
        self._running = False
        self._thread.join()
        self.line.unplug()

    @abstractmethod
    def work(self) -> None:
        """What it does each time."""

    def _run(self) -> None:
        while self._running:
            time.sleep(self._pause_s)
            with self._lock:
                self.work()


class FakeArm(SpeakingDevice):
    """An arm whose every joint turns by one count a sample; or whose x is the sequence number.

    Attributes may be changed while it runs: ``buttons``, ``damage`` (so many samples are sent with
    a wrong byte), ``repeat`` (so many are sent twice), ``greets`` (answers the requests),
    ``counts`` (per revolution, as the hello says), ``chatter`` (sent each time in place of a
    sample, even when silent), ``setting``, ``quaternion`` and ``y_mm`` of poses, ``properties`` of
    the hello. Pulses come at every ``pulse_every``th sample.
    """

    def __init__(
        self,
        line: Line,
        joints: int = 6,
        rate_hz: float = 500.0,
        first_sequence: int = 0,
        version: int = 1,
    ) -> None:
        self.joints, self.version = joints, version
        self.rate_hz, self.sequence = rate_hz, first_sequence
        self.buttons = self.damage = self.repeat = 0
        self.greets = True
        self.counts = COUNTS
        self.chatter = b""
        self.properties = 0 if joints else 1
        self.setting = 0 if joints else 17
        self.quaternion = [0.0, 0.6, 0.0, 0.8]
        self.y_mm = -80.25
        self.pulses_hz = (1.0, rate_hz) if version == 2 else (0.0, 0.0)
        self.pulse = self.requests = 0
        self.pulse_requests: list[tuple[int, float]] = []
        self.pulses_start_ns: int | None = None
        self.pulse_every = 1
        self.latched_ns: dict[int, int] = {}
        self._heard = b""
        self._injected: list[bytes] = []
        self._born_ns = time.monotonic_ns() - 5_000_000_000
        super().__init__(line, 1 / rate_hz)

    def inject(self, data: bytes) -> None:
        with self._lock:
            self._injected.append(data)

    def device_us(self, now_ns: int) -> int:
        """Its clock at a host-monotonic time."""
        return (now_ns - self._born_ns) // 1000

    def set_clock(self, later_s: float) -> None:
        """The device's clock jumps."""
        with self._lock:
            self._born_ns -= round(1e9 * later_s)

    def reboot(self) -> None:
        """The sequence and the device's clock start at zero again, without pulses."""
        with self._lock:
            self.sequence = 0
            self._born_ns = time.monotonic_ns()
            self.pulses_start_ns = None

    def work(self) -> None:
        self._heard = (self._heard + self.line.read())[-1000:]
        self._answer()
        self._send_sample()

    def _answer(self) -> None:
        asked = self._heard.count(REQUEST)
        self._heard = self._heard.replace(REQUEST, b"")
        self.requests += asked
        if asked and self.greets:
            self.line.write(self._hello())
        at = self._heard.find(b"\xa7\x5c\x02\x82\x05")
        if at >= 0 and len(self._heard) >= at + 14 and self.greets and self.version == 2:
            number, rate_mhz = struct.unpack_from("<BI", self._heard, at + 5)
            assert self._heard[at : at + 14] == packet(0x82, self._heard[at + 5 : at + 10], 2)
            self._heard = self._heard[at + 14 :]
            self._set_pulses(number, rate_mhz / 1000)

    def _hello(self) -> bytes:
        counts = [self.counts] * self.joints
        if self.version == 1:
            return hello_packet(counts, self.rate_hz)
        return hello_2_packet(
            counts, self.rate_hz, self.properties, 7, self.setting, self.pulses_hz
        )

    def _set_pulses(self, number: int, rate_hz: float) -> None:
        refused = rate_hz > 0 and rate_hz == self.pulses_hz[0]  # as a firmware that divides badly
        if not refused and (number, rate_hz) not in self.pulse_requests[-1:]:
            self.pulse = 0
            self.pulse_every = max(1, round(self.rate_hz / rate_hz)) if rate_hz else 0
            self.pulses_start_ns = time.monotonic_ns() + 300_000_000 if rate_hz else None
        self.pulse_requests.append((number, rate_hz))
        rate_mhz = 0 if self.pulses_start_ns is None else round(rate_hz * 1000)
        self.line.write(packet(5, struct.pack("<BBI", number, int(refused), rate_mhz), 2))

    def _packet(self, now_ns: int) -> bytes:
        device_us = self.device_us(now_ns)
        if self.joints:
            kind, counts = 1, [self.sequence & 0xFFFFF] * self.joints
            payload = sample_payload(self.sequence, device_us, self.buttons, counts)
        else:
            kind, position = 3, (float(self.sequence), self.y_mm, 433.0)
            where = (self.setting, position, self.quaternion)
            payload = pose_payload(self.sequence, device_us, self.buttons, *where)
        start = self.pulses_start_ns
        if start is not None and now_ns >= start and self.sequence % self.pulse_every == 0:
            self.pulse += 1
            return pulse_packet(self.pulse, kind, payload)
        return packet(kind, payload, self.version)

    def _send_sample(self) -> None:
        now_ns = self.latched_ns[self.sequence] = time.monotonic_ns()
        data = self._packet(now_ns)
        self.sequence += 1
        if self.damage:
            self.damage -= 1
            data = data[:20] + bytes([data[20] ^ 0x10]) + data[21:]
        if self.skip:
            self.skip -= 1
        elif not self.silent:
            self.line.write(data)
            if self.repeat:
                self.repeat -= 1
                self.line.write(data)
        self.line.write(self.chatter)
        while self._injected:
            self.line.write(self._injected.pop(0))


class SpeakingBench(ArmBench):
    def __init__(self, device: SpeakingDevice) -> None:
        self._device = device

    def unplug(self) -> None:
        self._device.unplug()

    def plug_in(self) -> None:
        self._device.plug_in()

    def silence(self, silent: bool) -> None:
        self._device.silent = silent

    def lose_samples(self, count: int) -> None:
        self._device.skip = count

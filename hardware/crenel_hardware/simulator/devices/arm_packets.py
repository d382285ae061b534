"""The bytes that the simulated arm says and hears: version 2 of ``crenel_hardware.arm.protocol``.

Written from that description alone.
"""

import struct
import zlib
from collections.abc import Sequence
from typing import NamedTuple

SYNC = b"\xa7\x5c"
HELLO_REQUEST = bytes.fromhex("a75c0181002f1a1bdc")
SAMPLE, HELLO, POSE, PULSE, PULSE_ANSWER, PULSE_REQUEST = 0x01, 0x02, 0x03, 0x04, 0x05, 0x82
REPORTS_POSES = 1
_KEPT_BYTES = 256


def packet(kind: int, payload: bytes) -> bytes:
    """A whole packet around a payload."""
    body = bytes([2, kind, len(payload)]) + payload
    return SYNC + body + struct.pack("<I", zlib.crc32(body) & 0xFFFFFFFF)


def sample_payload(sequence: int, device_us: int, buttons: int, counts: Sequence[int]) -> bytes:
    """One reading of all encoders."""
    head = struct.pack("<IQBB", sequence & 0xFFFFFFFF, device_us, buttons, len(counts))
    return head + struct.pack(f"<{len(counts)}i", *counts)


def pose_payload(
    sequence: int, device_us: int, buttons: int, setting: int, pose: Sequence[float]
) -> bytes:
    """One pose: x, y, z in mm and a quaternion x, y, z, w."""
    head = struct.pack("<IQBI", sequence & 0xFFFFFFFF, device_us, buttons, setting)
    return head + struct.pack("<7d", *pose)


def reading_packet(kind: int, payload: bytes, pulse: int | None) -> bytes:
    """A sample or pose, as a packet of its own or in that of a trigger pulse."""
    if pulse is None:
        return packet(kind, payload)
    return packet(PULSE, struct.pack("<IB", pulse, kind) + payload)


def hello_packet(
    counts_per_revolution: Sequence[int],
    rate_hz: float,
    texts: tuple[str, str, str],
    setting: int = 0,
    pulses_hz: tuple[float, float] = (0.0, 0.0),
) -> bytes:
    """What the arm answers when asked who it is; no counts: it reports poses.

    ``texts`` are name, serial number and firmware version.
    """
    joints = len(counts_per_revolution)
    low, high = (round(rate * 1000) for rate in pulses_hz)
    properties = 0 if joints else REPORTS_POSES
    head = struct.pack("<BIBBIII", joints, round(rate_hz * 1000), properties, 7, setting, low, high)
    name, serial_number, firmware = (text.encode() for text in texts)
    counts = struct.pack(f"<{joints}I", *counts_per_revolution)
    return packet(HELLO, head + counts + struct.pack("<32s16s16s", name, serial_number, firmware))


def pulse_answer_packet(number: int, done: bool, rate_hz: float) -> bytes:
    """What became of a pulse request."""
    return packet(PULSE_ANSWER, struct.pack("<BBI", number, not done, round(rate_hz * 1000)))


class PulseRequest(NamedTuple):
    """The host starts the pulses at a rate, or stops them at 0."""

    number: int
    rate_mhz: int


class RequestReader:
    """Finds the host's requests between whatever else arrives."""

    def __init__(self) -> None:
        self._heard = b""

    def feed(self, said: bytes) -> tuple[int, list[PulseRequest]]:
        """How many hellos were asked for, and the requests for pulses."""
        self._heard += said
        hellos = self._heard.count(HELLO_REQUEST)
        self._heard = self._heard.replace(HELLO_REQUEST, b"")
        requests: list[PulseRequest] = []
        start = SYNC + bytes([2, PULSE_REQUEST, 5])
        while (at := self._heard.find(start)) >= 0 and len(self._heard) >= at + 14:
            whole, self._heard = self._heard[at : at + 14], self._heard[at + 1 :]
            if whole == packet(PULSE_REQUEST, whole[5:10]):
                requests.append(PulseRequest(*struct.unpack("<BI", whole[5:10])))
        self._heard = self._heard[-_KEPT_BYTES:]
        return hellos, requests

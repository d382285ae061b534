r"""The encoder arm's serial protocol, version 1, byte by byte.

This is all you need to write the firmware of an arm, or of an adapter for an existing one,
for the ``serial-encoder`` driver. The bytes may be sent over a UART, USB (CDC), RS-485 or a TCP
stream: 8 data bits, no parity, 1 stop bit, no flow control,
by default 921 600 baud (a 7-joint arm at 1 kHz needs 510 000).

Packet
======
All numbers are little-endian; signed ones are two's complement.

======  ====  ========================================================================
offset  size  field
======  ====  ========================================================================
0       2     sync: A7 5C
2       1     protocol version: 01
3       1     type: 01 sample, 02 hello (arm to host); 81 hello request (host to arm)
4       1     L, length of the payload in bytes
5       L     payload
5 + L   4     CRC-32, unsigned, of the bytes 2 … 4 + L (version to end of payload)
======  ====  ========================================================================

The CRC is that of zlib, PNG and Ethernet: reflected polynomial EDB88320 (04C11DB7
unreflected), initial value FFFFFFFF, final exclusive-or FFFFFFFF; for the ASCII
string ``123456789`` it is CBF43926. This frame stays the same in all versions.

Sample (type 01)
================
The payload is 14 + 4 n bytes long, where n is the number of joints, 6 or 7.

======  ====  ========================================================================
offset  size  field, within the payload
======  ====  ========================================================================
0       4     sequence, unsigned: +1 for each sample taken, sent or not; wraps from
              FFFFFFFF to 0. A gap shows the host how many samples were lost.
4       8     device time, unsigned, in microseconds: when the encoders were latched.
              Any starting point. It runs steadily, never jumps while the arm is
              powered, and is not tied to when the packet is sent.
12      1     buttons, a bit each, 1 = pressed: bit 0 primary (a touch-trigger probe
              too), bit 1 undo, bit 2 back; bits 3 … 7 are 0
13      1     n
14      4 n   counts, signed, base joint first: the encoders' absolute position
======  ====  ========================================================================

The arm sends samples from power-up at a constant rate of 50 Hz to 4 kHz, without a request.
All encoders are latched at the same time. An angle is
``2 pi * counts / counts_per_revolution`` radians; counts pass through zero and
through full turns without a jump. Sign and zero of a joint belong to the arm model
in the host, not to the protocol.

The arm debounces its buttons: a bit changes only when the contact has settled, and then keeps
its value for at least five samples, so that a lost packet cannot hide a press. The time
of an edge is that of the first sample that contains it.

Hello (type 02)
===============
The payload is 69 + 4 n bytes long. The arm sends a hello within 0.5 s of a hello
request; an arm that cannot receive sends one every second. It is sent between two
samples.

========  ====  ======================================================================
offset    size  field, within the payload
========  ====  ======================================================================
0         1     n, number of joints, 6 or 7
1         4     sample rate in mHz, unsigned
5         4 n   counts per revolution of each joint, unsigned, not 0, base joint first
5 + 4 n   32    name: UTF-8, padded with 00
37 + 4 n  16    serial number, the same way
53 + 4 n  16    firmware version, the same way
========  ====  ======================================================================

Hello request (type 81)
=======================
It has no payload, so it is always the same nine bytes. The host sends it on opening, and
every half second until a hello arrives.

What the host does
==================
- It searches for A7 5C and accepts a packet only if the CRC matches; otherwise it continues
  one byte further, so that noise or a truncated packet never hides the intact one after it.
  Skipped bytes count as ``corrupt``, once between two good packets; bytes skipped before the
  first good packet do not count.
- A packet of unknown type with a good CRC is ignored.
- Missing sequence numbers are counted as ``lost``. A sample that repeats the last
  sequence number is dropped and counted as ``corrupt``.
- If a sequence number or a device time goes backward, the arm was restarted: the host
  restarts its time mapping and continues.
- Buttons that are already down in the first sample after opening cause no press; a change
  of bits from one sample to the next causes a press or a release, with the device time of
  the later sample.
- A hello that names another arm, or samples with another number of joints, end the
  connection with an error.

Examples
========
Sample: 6 joints, sequence 258, device time 1 000 000 000 us, primary button down,
counts 0, 1, -1, 4194304, -2097152, 123456::

    A7 5C 01 01 26 02 01 00 00 00 CA 9A 3B 00 00 00
    00 01 06 00 00 00 00 01 00 00 00 FF FF FF FF 00
    00 40 00 00 00 E0 FF 40 E2 01 00 46 94 F7 EB

Hello: 6 joints of 8 388 608 counts, 1 kHz, "Sample arm", "SA-0042", "1.4.0"::

    A7 5C 01 02 5D 06 40 42 0F 00 00 00 80 00 00 00
    80 00 00 00 80 00 00 00 80 00 00 00 80 00 00 00
    80 00 53 61 6D 70 6C 65 20 61 72 6D 00 00 00 00
    00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00
    00 00 53 41 2D 30 30 34 32 00 00 00 00 00 00 00
    00 00 31 2E 34 2E 30 00 00 00 00 00 00 00 00 00
    00 00 37 1B D7 04

Hello request::

    A7 5C 01 81 00 2F 1A 1B DC
"""

import struct
from dataclasses import dataclass
from zlib import crc32

HELLO_REQUEST = bytes.fromhex("A7 5C 01 81 00 2F 1A 1B DC")

_SYNC = b"\xa7\x5c"
_VERSION = 1
_SAMPLE, _HELLO = 0x01, 0x02
_HEAD, _CRC = 5, 4

_SAMPLE_HEAD = struct.Struct("<IQBB")
_HELLO_HEAD = struct.Struct("<BI")
_HELLO_TEXTS = struct.Struct("<32s16s16s")
_U32 = struct.Struct("<I")


@dataclass(frozen=True, slots=True)
class Sample:
    """The encoder counts that the arm latched at one time."""

    sequence: int
    device_us: int
    buttons: int
    counts: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Hello:
    """The properties of the arm."""

    rate_hz: float
    counts_per_revolution: tuple[int, ...]
    name: str
    serial_number: str
    firmware: str


class PacketReader:
    """Finds the packets in a stream of bytes that may start anywhere and be damaged.

    ``corrupt`` counts the skipped parts of the stream, ``received_bytes`` all received bytes, and
    ``other_version`` is the version of the last intact packet of an unsupported version.
    """

    def __init__(self) -> None:
        self.corrupt = 0
        self.received_bytes = 0
        self.other_version: int | None = None
        self._rest = b""
        self._skipping = True  # a start in the middle of a packet is not damage

    def feed(self, data: bytes) -> list[Sample | Hello]:
        """The packets completed by ``data``, in order."""
        self.received_bytes += len(data)
        buffer = self._rest + data
        found: list[Sample | Hello] = []
        taken = 0  # everything before this has been processed
        open_at = -1  # the first packet that may still be completed
        at = buffer.find(_SYNC)
        while at >= 0:
            end = _end(buffer, at)
            if end > len(buffer):
                open_at = at if open_at < 0 else open_at
            elif (packet := self._decode(buffer, at, end)) is not None:
                self._skip(at - taken)
                self._skipping = False
                if not isinstance(packet, _UnknownPacket):
                    found.append(packet)
                taken, open_at = end, -1
                at = buffer.find(_SYNC, end)
                continue
            at = buffer.find(_SYNC, at + 1)
        keep = open_at
        if keep < 0:
            keep = len(buffer) - (taken < len(buffer) and buffer.endswith(_SYNC[:1]))
        self._skip(keep - taken)
        self._rest = buffer[keep:]
        return found

    def _skip(self, count: int) -> None:
        if count and not self._skipping:
            self._skipping = True
            self.corrupt += 1

    def _decode(self, buffer: bytes, at: int, end: int) -> "Sample | Hello | _UnknownPacket | None":
        body = buffer[at + 2 : end - _CRC]
        if crc32(body) != _U32.unpack_from(buffer, end - _CRC)[0]:
            return None
        version, kind, payload = body[0], body[1], body[3:]
        if version != _VERSION:
            self.other_version = version
            return _UnknownPacket()
        if kind == _SAMPLE:
            return _sample(payload)
        if kind == _HELLO:
            return _hello(payload)
        return _UnknownPacket()


class _UnknownPacket:
    """An intact packet of an unknown version."""


def _end(buffer: bytes, at: int) -> int:
    """End of the packet that may start at ``at``; beyond the buffer if still unknown."""
    head_end = at + _HEAD
    return head_end + buffer[head_end - 1] + _CRC if head_end <= len(buffer) else head_end


def _sample(payload: bytes) -> Sample | None:
    if len(payload) < _SAMPLE_HEAD.size:
        return None
    sequence, device_us, buttons, joints = _SAMPLE_HEAD.unpack_from(payload)
    if len(payload) != _SAMPLE_HEAD.size + 4 * joints:
        return None
    counts = struct.unpack_from(f"<{joints}i", payload, _SAMPLE_HEAD.size)
    return Sample(sequence, device_us, buttons, counts)


def _hello(payload: bytes) -> Hello | None:
    if len(payload) < _HELLO_HEAD.size:
        return None
    joints, rate_mhz = _HELLO_HEAD.unpack_from(payload)
    if len(payload) != _HELLO_HEAD.size + 4 * joints + _HELLO_TEXTS.size:
        return None
    counts = struct.unpack_from(f"<{joints}I", payload, _HELLO_HEAD.size)
    texts = _HELLO_TEXTS.unpack_from(payload, _HELLO_HEAD.size + 4 * joints)
    name, serial_number, firmware = (
        text.split(b"\0", 1)[0].decode("utf-8", "replace") for text in texts
    )
    return Hello(rate_mhz / 1000, counts, name, serial_number, firmware)

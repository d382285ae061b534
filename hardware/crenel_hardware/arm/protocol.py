r"""The bridge protocol, version 2, byte by byte.

This is all you need to write the firmware of an arm, or of a bridge for an existing arm or robot,
for the driver ``bridge`` (also named ``serial-encoder``). The bytes may be sent over a UART, USB
(CDC), RS-485 or a TCP stream: 8 data bits, no parity, 1 stop bit, no flow control,
by default 921 600 baud (a 7-joint arm at 1 kHz needs 510 000).

An arm reports the counts of its encoders (types 01 and 02), or poses that another program has
computed (types 02 and 03). Trigger pulses for a camera (types 04, 05 and 82) are optional.

Version 1 had only joints: the types 01, 02 (in its own form) and 81. The host supports arms of both
versions; an arm implements one. All packets that an arm of version 2 sends have version 02.

Packet
======
All numbers are little-endian; signed ones are two's complement; float64 is IEEE 754 binary64.

======  ====  ========================================================================
offset  size  field
======  ====  ========================================================================
0       2     sync: A7 5C
2       1     protocol version: 02, or 01
3       1     type. Arm to host: 01 sample, 02 hello, 03 pose, 04 pulse,
              05 pulse answer. Host to arm: 81 hello request, 82 pulse request
4       1     L, length of the payload in bytes
5       L     payload
5 + L   4     CRC-32, unsigned, of the bytes 2 … 4 + L (version to end of payload)
======  ====  ========================================================================

The CRC is that of zlib, PNG and Ethernet: reflected polynomial EDB88320 (04C11DB7
unreflected), initial value FFFFFFFF, final exclusive-or FFFFFFFF; for the ASCII
string ``123456789`` it is CBF43926. This frame stays the same in all versions.

Sample (type 01)
================
The payload is 14 + 4 n bytes long, where n is the number of joints, 5, 6 or 7.

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
its value for at least five samples, so that a lost packet cannot hide a press; an arm that
sends nothing while nothing changes sends each change at once. The time of an edge is that of the
first sample that contains it.

Pose (type 03, version 2)
=========================
An arm whose hello announces poses sends these instead of samples. The payload is 73 bytes long.

======  ====  ========================================================================
offset  size  field, within the payload
======  ====  ========================================================================
0       13    sequence, device time and buttons as in a sample
13      4     setting, unsigned: a number for the coordinate system in which, and the
              tool of which, the pose is. The same number means the same frames, also
              after power-off; any other number means that they changed.
17      24    x, y, z: three float64, in millimetres
41      32    quaternion x, y, z, w: four float64, scalar last, of length 1 within 0.001
======  ====  ========================================================================

Position and quaternion map the frame of the flange (or of the tool, if the hello says so) to the
frame of the arm's base. If a pose is unknown, the arm sends no packet, and increments the sequence.

Hello (type 02, version 2)
==========================
The payload is 83 + 4 n bytes long. The arm sends a hello within 0.5 s of a hello
request; an arm that cannot receive sends one every second. It is sent between two
samples.

========  ====  ======================================================================
offset    size  field, within the payload
========  ====  ======================================================================
0         1     n, number of joints, 5, 6 or 7; 0 for poses
1         4     sample rate in mHz, unsigned
5         1     properties, a bit each: bit 0 reports poses, not joints; bit 1 the
                poses are of the tool, not of the flange; bit 2 the device time is when
                the data reached the bridge, not when it was measured; bit 3 nothing is
                sent while nothing changes; bits 4 … 7 are 0
6         1     buttons that the arm has, bits as in a sample
7         4     setting, as in a pose; 0 for joints
11        4     lowest rate of trigger pulses in mHz, unsigned; 0 without pulses
15        4     highest rate of trigger pulses in mHz, unsigned; 0 without pulses
19        4 n   counts per revolution of each joint, unsigned, not 0, base joint first
19 + 4 n  32    name: UTF-8, padded with 00
51 + 4 n  16    serial number, the same way
67 + 4 n  16    firmware version, the same way
========  ====  ======================================================================

Hello (type 02, version 1)
==========================
The payload is 69 + 4 n bytes long: n, the sample rate, the counts per revolution, the name, the
serial number and the firmware version, without anything between. Such an arm has three buttons.

Hello request (type 81)
=======================
It has no payload, and has version 01 for all arms, so it is always the same nine bytes. The host
sends it on opening, and every half second until a hello arrives.

Trigger pulses (version 2)
==========================
An arm that can trigger a camera has an output for pulses, and latches its encoders at the leading
edge of each. It counts the pulses from 1 since they were started. It sends what it latched at a
pulse as type 04, and whatever it takes between pulses as type 01 or 03; both share the sequence.

Pulse (type 04):

======  ====  ========================================================================
offset  size  field, within the payload
======  ====  ========================================================================
0       4     number of the pulse, unsigned, at least 1
4       1     type of what follows: 01 sample or 03 pose
5       …     the payload of that type
======  ====  ========================================================================

Pulse request (type 82), from the host:

======  ====  ========================================================================
offset  size  field, within the payload
======  ====  ========================================================================
0       1     number of the request: +1 for each new one, the same if it is repeated
1       4     rate in mHz, unsigned; 0 stops the pulses
======  ====  ========================================================================

Pulse answer (type 05):

======  ====  ========================================================================
offset  size  field, within the payload
======  ====  ========================================================================
0       1     number of the request
1       1     00 done, 01 this rate is not possible (pulses stay as they were)
2       4     rate of the pulses in mHz, unsigned, as exactly as known; 0 if stopped
======  ====  ========================================================================

- The pulses are stopped at power-up and after any restart of the arm.
- To start them, the arm stops them at once, sends the answer after the last packet of type 04 of
  the former pulses, pauses for at least 0.3 s, and then starts them with number 1. The pause shows
  in the camera's time stamps, so that its frames can be counted from the same pulse.
- The arm answers within 0.2 s. If the number and the rate are those of the request before, it sends
  the answer again and does nothing else. The host repeats a request every 0.2 s until it has the
  answer, and stops the pulses on opening.

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
  restarts its time mapping, counts what arrives in the next 0.25 s as ``lost``, and continues. If
  the pulses were running, the connection ends with an error, because the camera counted pulses that
  the arm did not. The same applies if a pulse number does not increase.
- If a device time, or a sequence number by the sample rate, goes forward by 3 s more than has
  passed, the connection ends with an error.
- Buttons that are already down in the first sample after opening cause no press; a change
  of bits from one sample to the next causes a press or a release, with the device time of
  the later sample.
- A pose that has a number that is not finite, or a quaternion of another length, is dropped and
  counted as ``corrupt``; 50 of them without a good one between end the connection with an error.
- A hello that names another arm, samples with another number of joints, poses with another
  setting, or poses of an arm that announced joints, end the connection with an error.

Examples
========
Sample of version 1: 6 joints, sequence 258, device time 1 000 000 000 us, primary button down,
counts 0, 1, -1, 4194304, -2097152, 123456::

    A7 5C 01 01 26 02 01 00 00 00 CA 9A 3B 00 00 00
    00 01 06 00 00 00 00 01 00 00 00 FF FF FF FF 00
    00 40 00 00 00 E0 FF 40 E2 01 00 46 94 F7 EB

Hello of version 1: 6 joints of 8 388 608 counts, 1 kHz, "Sample arm", "SA-0042", "1.4.0"::

    A7 5C 01 02 5D 06 40 42 0F 00 00 00 80 00 00 00
    80 00 00 00 80 00 00 00 80 00 00 00 80 00 00 00
    80 00 53 61 6D 70 6C 65 20 61 72 6D 00 00 00 00
    00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00
    00 00 53 41 2D 30 30 34 32 00 00 00 00 00 00 00
    00 00 31 2E 34 2E 30 00 00 00 00 00 00 00 00 00
    00 00 37 1B D7 04

Hello request::

    A7 5C 01 81 00 2F 1A 1B DC

Hello of version 2: the same arm with only the primary and the back button, and pulses of 1 Hz to
200 Hz::

    A7 5C 02 02 6B 06 40 42 0F 00 00 05 00 00 00 00
    E8 03 00 00 40 0D 03 00 00 00 80 00 00 00 80 00
    00 00 80 00 00 00 80 00 00 00 80 00 00 00 80 00
    53 61 6D 70 6C 65 20 61 72 6D 00 00 00 00 00 00
    00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00
    53 41 2D 30 30 34 32 00 00 00 00 00 00 00 00 00
    32 2E 30 2E 30 00 00 00 00 00 00 00 00 00 00 00
    DD 76 61 9F

Hello of version 2: poses of the tool at 100 Hz, setting 17, primary button, no pulses,
"Sample bridge", "SB-7", "1.0"::

    A7 5C 02 02 53 00 A0 86 01 00 03 01 11 00 00 00
    00 00 00 00 00 00 00 00 53 61 6D 70 6C 65 20 62
    72 69 64 67 65 00 00 00 00 00 00 00 00 00 00 00
    00 00 00 00 00 00 00 00 53 42 2D 37 00 00 00 00
    00 00 00 00 00 00 00 00 31 2E 30 00 00 00 00 00
    00 00 00 00 00 00 00 00 87 D2 ED FD

Pose: sequence 7, device time 2 500 000 us, primary button down, setting 17, position
612.5, -80.25, 433, quaternion 0, 0.6, 0, 0.8::

    A7 5C 02 03 49 07 00 00 00 A0 25 26 00 00 00 00
    00 01 11 00 00 00 00 00 00 00 00 24 83 40 00 00
    00 00 00 10 54 C0 00 00 00 00 00 10 7B 40 00 00
    00 00 00 00 00 00 33 33 33 33 33 33 E3 3F 00 00
    00 00 00 00 00 00 9A 99 99 99 99 99 E9 3F B2 75
    41 DD

Pulse 1 with a sample: sequence 259, device time 1 000 001 000 us, no button, counts as above::

    A7 5C 02 04 2B 01 00 00 00 01 03 01 00 00 E8 CD
    9A 3B 00 00 00 00 00 06 00 00 00 00 01 00 00 00
    FF FF FF FF 00 00 40 00 00 00 E0 FF 40 E2 01 00
    43 34 F8 40

Pulse 70 000 with the pose above::

    A7 5C 02 04 4E 70 11 01 00 03 07 00 00 00 A0 25
    26 00 00 00 00 00 01 11 00 00 00 00 00 00 00 00
    24 83 40 00 00 00 00 00 10 54 C0 00 00 00 00 00
    10 7B 40 00 00 00 00 00 00 00 00 33 33 33 33 33
    33 E3 3F 00 00 00 00 00 00 00 00 9A 99 99 99 99
    99 E9 3F A4 5E DA 11

Pulse request 5: start at 100 Hz::

    A7 5C 02 82 05 05 A0 86 01 00 7A 72 6B 11

Pulse answer to it: done, 100.016 Hz::

    A7 5C 02 05 06 05 00 B0 86 01 00 2C 8E D3 52
"""

import struct
from dataclasses import dataclass
from zlib import crc32

from crenel_hardware.interfaces import Button

SYNC = b"\xa7\x5c"
HELLO_REQUEST = bytes.fromhex("A7 5C 01 81 00 2F 1A 1B DC")
PULSE_REQUEST = 0x82
BUTTON_BITS = ((1, Button.PRIMARY), (2, Button.UNDO), (4, Button.BACK))

_PULSE_REQUEST = struct.Struct("<BI")
_U32 = struct.Struct("<I")


@dataclass(frozen=True, slots=True)
class Sample:
    """The encoder counts that the arm latched at one time."""

    sequence: int
    device_us: int
    buttons: int
    counts: tuple[int, ...]
    pulse: int | None = None


@dataclass(frozen=True, slots=True)
class PosePacket:
    """A pose of the flange or tool, unchecked: it may be no pose at all."""

    sequence: int
    device_us: int
    buttons: int
    setting: int
    position_mm: tuple[float, float, float]
    quaternion_xyzw: tuple[float, float, float, float]
    pulse: int | None = None


@dataclass(frozen=True, slots=True)
class Hello:
    """The properties of the arm; the defaults are those of version 1."""

    rate_hz: float
    counts_per_revolution: tuple[int, ...]
    name: str
    serial_number: str
    firmware: str
    version: int = 1
    reports_poses: bool = False
    poses_of_tool: bool = False
    stamps_arrival: bool = False
    only_changes: bool = False
    buttons: int = 7
    setting: int = 0
    pulses_hz: tuple[float, float] | None = None


@dataclass(frozen=True, slots=True)
class PulseAnswer:
    """What the arm did about a pulse request."""

    number: int
    done: bool
    rate_hz: float


Packet = Sample | PosePacket | Hello | PulseAnswer


def pulse_request(number: int, rate_hz: float) -> bytes:
    """The packet that starts the pulses at a rate, or stops them at 0 Hz."""
    payload = _PULSE_REQUEST.pack(number % 256, round(rate_hz * 1000))
    body = bytes([2, PULSE_REQUEST, len(payload)]) + payload
    return SYNC + body + _U32.pack(crc32(body))

"""Finds and decodes the packets of ``crenel_hardware.arm.protocol`` in a stream of bytes."""

import struct
from collections.abc import Callable
from dataclasses import replace
from zlib import crc32

from crenel_hardware.arm.protocol import SYNC, Hello, Packet, PosePacket, PulseAnswer, Sample

_HEAD, _CRC = 5, 4
_SAMPLE, _HELLO, _POSE, _PULSE, _PULSE_ANSWER = range(1, 6)

_SAMPLE_HEAD = struct.Struct("<IQBB")
_POSE_BODY = struct.Struct("<IQBI3d4d")
_PULSE_HEAD = struct.Struct("<IB")
_ANSWER = struct.Struct("<BBI")
_HELLO_HEAD_1 = struct.Struct("<BI")
_HELLO_HEAD_2 = struct.Struct("<BIBBIII")
_HELLO_TEXTS = struct.Struct("<32s16s16s")
_U32 = struct.Struct("<I")


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

    def feed(self, data: bytes) -> list[Packet]:
        """The packets completed by ``data``, in order."""
        self.received_bytes += len(data)
        buffer = self._rest + data
        found: list[Packet] = []
        taken = 0  # everything before this has been processed
        open_at = -1  # the first packet that may still be completed
        at = buffer.find(SYNC)
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
                at = buffer.find(SYNC, end)
                continue
            at = buffer.find(SYNC, at + 1)
        keep = open_at
        if keep < 0:
            keep = len(buffer) - (taken < len(buffer) and buffer.endswith(SYNC[:1]))
        self._skip(keep - taken)
        self._rest = buffer[keep:]
        return found

    def _skip(self, count: int) -> None:
        if count and not self._skipping:
            self._skipping = True
            self.corrupt += 1

    def _decode(self, buffer: bytes, at: int, end: int) -> "Packet | _UnknownPacket | None":
        body = buffer[at + 2 : end - _CRC]
        if crc32(body) != _U32.unpack_from(buffer, end - _CRC)[0]:
            return None
        version, kind, payload = body[0], body[1], body[3:]
        if version not in _DECODERS:
            self.other_version = version
            return _UnknownPacket()
        decode = _DECODERS[version].get(kind)
        return _UnknownPacket() if decode is None else decode(payload)


class _UnknownPacket:
    """An intact packet of an unknown type or version."""


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


def _pose(payload: bytes) -> PosePacket | None:
    if len(payload) != _POSE_BODY.size:
        return None
    sequence, device_us, buttons, setting, x, y, z, qx, qy, qz, qw = _POSE_BODY.unpack(payload)
    return PosePacket(sequence, device_us, buttons, setting, (x, y, z), (qx, qy, qz, qw))


def _pulse(payload: bytes) -> Sample | PosePacket | None:
    if len(payload) < _PULSE_HEAD.size:
        return None
    pulse, kind = _PULSE_HEAD.unpack_from(payload)
    inside = payload[_PULSE_HEAD.size :]
    reading: Sample | PosePacket | None = None
    if kind == _SAMPLE:
        reading = _sample(inside)
    elif kind == _POSE:
        reading = _pose(inside)
    return None if reading is None or pulse == 0 else replace(reading, pulse=pulse)


def _pulse_answer(payload: bytes) -> PulseAnswer | None:
    if len(payload) != _ANSWER.size:
        return None
    number, result, rate_mhz = _ANSWER.unpack(payload)
    return PulseAnswer(number, result == 0, rate_mhz / 1000)


def _hello_1(payload: bytes) -> Hello | None:
    if len(payload) < _HELLO_HEAD_1.size:
        return None
    joints, rate_mhz = _HELLO_HEAD_1.unpack_from(payload)
    rest = _counts_and_texts(payload[_HELLO_HEAD_1.size :], joints)
    return None if rest is None else Hello(rate_mhz / 1000, *rest)


def _hello_2(payload: bytes) -> Hello | None:
    if len(payload) < _HELLO_HEAD_2.size:
        return None
    joints, rate_mhz, properties, buttons, setting, low, high = _HELLO_HEAD_2.unpack_from(payload)
    rest = _counts_and_texts(payload[_HELLO_HEAD_2.size :], joints)
    if rest is None:
        return None
    return Hello(
        rate_mhz / 1000,
        *rest,
        version=2,
        reports_poses=bool(properties & 1),
        poses_of_tool=bool(properties & 2),
        stamps_arrival=bool(properties & 4),
        only_changes=bool(properties & 8),
        buttons=buttons,
        setting=setting,
        pulses_hz=(low / 1000, high / 1000) if high else None,
    )


def _counts_and_texts(data: bytes, joints: int) -> tuple[tuple[int, ...], str, str, str] | None:
    """The end of a hello: counts per revolution, name, serial number and firmware version."""
    if len(data) != 4 * joints + _HELLO_TEXTS.size:
        return None
    counts = struct.unpack_from(f"<{joints}I", data)
    name, serial_number, firmware = (
        text.split(b"\0", 1)[0].decode("utf-8", "replace")
        for text in _HELLO_TEXTS.unpack_from(data, 4 * joints)
    )
    return counts, name, serial_number, firmware


_DECODERS: dict[int, dict[int, Callable[[bytes], Packet | None]]] = {
    1: {_SAMPLE: _sample, _HELLO: _hello_1},
    2: {
        _SAMPLE: _sample,
        _HELLO: _hello_2,
        _POSE: _pose,
        _PULSE: _pulse,
        _PULSE_ANSWER: _pulse_answer,
    },
}
"""The types of each version."""

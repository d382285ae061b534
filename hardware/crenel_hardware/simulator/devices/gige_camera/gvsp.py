"""Packets of the GigE Vision stream protocol: a picture as leader, payload and trailer.

Source:
    AIA, GigE Vision 2.0, sections 24 (packets) and 25.1 (payload type image).
"""

import struct
from dataclasses import dataclass

OVERHEAD = 36
"""Bytes of the headers of IP, UDP and GVSP, which the packet size includes."""
LAST_BLOCK_ID = 0xFFFF
"""The next one is 1: block id 0 does not occur."""
_LEADER, _TRAILER, _PAYLOAD = 1, 2, 3
_IMAGE = 0x0001
_UNAVAILABLE = 0x800C


@dataclass(frozen=True, slots=True)
class PictureBlock:
    """One picture on its way."""

    block_id: int
    timestamp: int
    """In ticks of the camera."""
    pixel_format: int
    """Its value in PFNC."""
    region: tuple[int, int, int, int]
    """Offsets x and y, width and height, in px."""
    data: bytes
    packet_size: int
    """The size of IP packets, in bytes."""

    @property
    def last_packet(self) -> int:
        """The number of the trailer; the leader is 0."""
        return -(-len(self.data) // self._share) + 1

    def packet(self, number: int) -> bytes:
        """A packet by its number; the last one with payload is as short as the data left."""
        if number == 0:
            return self._head(_LEADER, 0) + self._leader()
        if number == self.last_packet:
            height_px = self.region[3]
            return self._head(_TRAILER, number) + struct.pack(">HHI", 0, _IMAGE, height_px)
        start = (number - 1) * self._share
        return self._head(_PAYLOAD, number) + self.data[start : start + self._share]

    @property
    def _share(self) -> int:
        return self.packet_size - OVERHEAD

    def _head(self, kind: int, number: int) -> bytes:
        return struct.pack(">HHI", 0, self.block_id, kind << 24 | number)

    def _leader(self) -> bytes:
        x, y, width_px, height_px = self.region
        return struct.pack(
            ">HHQIIIIIHH",
            0,
            _IMAGE,
            self.timestamp,
            self.pixel_format,
            width_px,
            height_px,
            x,
            y,
            0,
            0,
        )


def unavailable_packet(block_id: int, number: int) -> bytes:
    """What is sent in place of a packet that is not in the camera's memory."""
    return struct.pack(">HHI", _UNAVAILABLE, block_id, _PAYLOAD << 24 | number)


def probe_packet(packet_size: int) -> bytes:
    """The packet by which a client finds out which sizes its network carries."""
    return struct.pack(">HHI", 0, 0, _PAYLOAD << 24) + bytes(packet_size - OVERHEAD)

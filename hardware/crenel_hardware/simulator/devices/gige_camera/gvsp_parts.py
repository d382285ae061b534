"""Packets of a block with several parts, such as the rows of profiles and their brightness.

Such a block has block ids of 64 bits: in a leader with short ones, there is no room for the number
of its parts.

Source:
    AIA, GigE Vision 2.1: payload type multi-part; its reading in Aravis 0.8 (``arvgvspprivate.h``).
"""

import struct
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

_OVERHEAD = 28 + 20 + 8
"""Bytes of the headers of IP and UDP, of GVSP, and of the part, which the packet size includes."""
_LEADER, _TRAILER, _PART = 1, 2, 7
_MULTIPART = 0x000A
_EXTENDED = 0x80000000
IMAGE_2D, IMAGE_3D = 0x0001, 0x0005
"""Data types of parts."""


@dataclass(frozen=True, slots=True)
class BlockPart:
    """One part of a block."""

    data_type: int
    pixel_format: int
    """Its value in PFNC."""
    data: bytes


@dataclass(frozen=True)
class PartsBlock:
    """One block on its way, whose parts have the same region."""

    block_id: int
    timestamp: int
    """In ticks of the camera."""
    region: tuple[int, int, int, int]
    """Offsets x and y, width and height, in px."""
    parts: tuple[BlockPart, ...]
    packet_size: int
    """The size of IP packets, in bytes."""

    @property
    def last_packet(self) -> int:
        """The number of the trailer; the leader is 0."""
        return len(self._pieces) + 1

    def packet(self, number: int) -> bytes:
        """A packet by its number; each part begins with a packet of its own."""
        if number == 0:
            return self._head(_LEADER, 0, len(self.parts)) + self._leader()
        if number == self.last_packet:
            return self._head(_TRAILER, number) + struct.pack(">HHI", 0, _MULTIPART, 0)
        return self._head(_PART, number) + self._pieces[number - 1]

    @cached_property
    def _pieces(self) -> list[bytes]:
        return list(self._cut())

    def _cut(self) -> Iterator[bytes]:
        share, offset = self.packet_size - _OVERHEAD, 0
        for number, part in enumerate(self.parts):
            for start in range(0, len(part.data), share):
                piece = part.data[start : start + share]
                yield struct.pack(">BBHI", number, 0, 0, offset) + piece
                offset += len(piece)

    def _head(self, kind: int, number: int, parts: int = 0) -> bytes:
        return struct.pack(">HHIQI", 0, 0, _EXTENDED | kind << 24 | parts, self.block_id, number)

    def _leader(self) -> bytes:
        x, y, width_px, height_px = self.region
        described = [
            struct.pack(
                ">HHIIHBBIHHIIIIHHI",
                *(part.data_type, 0, len(part.data), part.pixel_format, 0, 0, 0, 0),
                *(0, 0, width_px, height_px, x, y, 0, 0, 0),
            )
            for part in self.parts
        ]
        return struct.pack(">HHQ", 0, _MULTIPART, self.timestamp) + b"".join(described)

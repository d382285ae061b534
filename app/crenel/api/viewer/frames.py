"""Frames of viser's socket: messages in msgpack under zstd, followed by their arrays."""

import time
from typing import Any

import msgspec
import zstandard

from crenel.station.view3d.viewpoints import Vector

Message = dict[str, Any]
ALIGNED_BYTES = 8


def decompress_messages(frame: bytes) -> bytes:
    """The messages of one frame of viser's socket, in msgpack, without the arrays."""
    packed_bytes = int.from_bytes(frame[8:16], "little")
    return zstandard.ZstdDecompressor().decompress(
        frame[16 : 16 + packed_bytes], int.from_bytes(frame[:8], "little")
    )


def unpack_frame(frame: bytes) -> tuple[Message, list[bytes]]:
    """The content of one frame of viser's socket, and the arrays to which it refers."""
    packed_bytes = int.from_bytes(frame[8:16], "little")
    content: Message = msgspec.msgpack.decode(decompress_messages(frame))
    at, arrays = 16 + packed_bytes, []
    for length in content["binaryBufferLengths"]:
        at += -at % ALIGNED_BYTES
        arrays.append(frame[at : at + length])
        at += length
    return content, arrays


def pack_frame(content: Message, arrays: list[bytes]) -> bytes:
    """The frame of this content: the inverse of ``unpack_frame``."""
    content["binaryBufferLengths"] = [len(array) for array in arrays]
    inner = msgspec.msgpack.encode(content)
    packed = zstandard.ZstdCompressor(level=1).compress(inner)
    parts = [len(inner).to_bytes(8, "little"), len(packed).to_bytes(8, "little"), packed]
    at = 16 + len(packed)
    for array in arrays:
        padding = -at % ALIGNED_BYTES
        parts += [bytes(padding), array]
        at += padding + len(array)
    return b"".join(parts)


def camera_frame(position_m: Vector, at_m: Vector) -> bytes:
    """The frame by which viser moves the camera of one browser, and turns it to a point."""
    moves = [
        {"type": "SetCameraPositionMessage", "position": position_m, "initial": False},
        {"type": "SetCameraLookAtMessage", "look_at": at_m, "initial": False},
    ]
    return pack_frame({"messages": moves, "timestampSec": time.perf_counter()}, [])

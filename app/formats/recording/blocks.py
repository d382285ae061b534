"""A stretch of a recording, opened at once: its joints as arrays, its stripes as arrays."""

import zlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from io import BytesIO

import lz4.frame
import numpy as np
import zstandard
from mcap.data_stream import ReadDataStream
from mcap.exceptions import McapError
from mcap.records import Channel, Chunk, Message, Schema
from mcap.stream_reader import CRCValidationError

from app.formats.recording import wire_format as wire
from app.metrology.transforms import Floats

CHANNEL, SCHEMA = 4, 3


@dataclass(frozen=True)
class Opened:
    """The bytes of a chunk, and where its records stand."""

    data: bytes
    table: wire.Table
    """(R, 5) as of ``recording_wire.find_records``."""

    @property
    def bytes(self) -> wire.Bytes:
        return np.frombuffer(self.data, np.uint8)

    def descriptions(self) -> Iterator[Schema | Channel]:
        """Schemas and channels, in their order."""
        for opcode, _, _, first, length in self.table[self.table[:, 0] < wire.MESSAGE].tolist():
            stream = ReadDataStream(BytesIO(self.data[first : first + length]))
            if opcode == SCHEMA:
                yield Schema.read(stream)
            elif opcode == CHANNEL:
                yield Channel.read(stream)

    @property
    def messages(self) -> wire.Table:
        """(M, 5) rows of the messages."""
        return np.asarray(self.table[self.table[:, 0] == wire.MESSAGE])


def open_chunk(chunk: Chunk) -> Opened:
    """Decompresses and checks a chunk; raises what a damaged one makes the libraries raise."""
    if chunk.compression == "zstd":
        data = zstandard.decompress(chunk.data, chunk.uncompressed_size)
    elif chunk.compression == "lz4":
        data = lz4.frame.decompress(chunk.data)
    elif chunk.compression == "":
        data = chunk.data
    else:
        raise McapError(f"compression {chunk.compression}")
    if chunk.uncompressed_crc:
        found = zlib.crc32(data)
        if found != chunk.uncompressed_crc:
            raise CRCValidationError(chunk.uncompressed_crc, found, chunk)
    return Opened(data, wire.find_records(np.frombuffer(data, np.uint8)))


def of_messages(messages: Sequence[Message]) -> Opened:
    """Messages that stood in no chunk."""
    data = b"".join(message.data for message in messages)
    table = np.zeros((len(messages), 5), dtype=np.int64)
    table[:, 0] = wire.MESSAGE
    table[:, 1] = [message.channel_id for message in messages]
    table[:, 2] = [message.log_time for message in messages]
    table[:, 4] = [len(message.data) for message in messages]
    table[1:, 3] = np.cumsum(table[:-1, 4])
    return Opened(data, table)


@dataclass(frozen=True)
class Profiles:
    """Stripes of some frames, one behind the other."""

    count: wire.Table
    """(F,) points of each frame; N in all."""
    u: Floats  # (N,) distorted pixels
    v: Floats  # (N,)
    intensity: Floats  # (N,)
    sigma_px: Floats  # (N,)
    axis: str


def profiles(opened: Opened, rows: wire.Table) -> Profiles:
    """The stripes that ``rows`` (F, 9) of ``recording_wire.find_stripes`` tell of.

    They must be of one axis.
    """
    u, v, intensity, sigma_px = (
        wire.gather_list(opened.bytes, rows, column).astype(np.float64, copy=False)
        for column in (wire.U, wire.V, wire.INTENSITY, wire.SIGMA)
    )
    return Profiles(
        rows[:, wire.POINTS],
        u,
        v,
        intensity,
        sigma_px,
        "v" if len(rows) and rows[0, wire.AXIS] == ord("v") else "u",
    )

"""A part of a recording, opened at once: its joints and its stripes as arrays."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from mcap.exceptions import McapError
from mcap.records import Channel, Chunk, Message, Schema

from crenel.formats.recording import wire_format as wire
from crenel.formats.recording.raw import decompress, parse_records
from crenel.metrology.transforms import Floats

CHANNEL, SCHEMA = 4, 3
MOST_DESCRIBED = 16 << 20
"""Bytes of schemas and channels."""
ROWS_AT_ONCE = 4096


@dataclass(frozen=True)
class ChunkRecords:
    """The bytes of a chunk, and the positions of its records."""

    data: bytes
    table: wire.Table
    """(R, 5) from ``wire_format.find_records``."""

    described: tuple[Schema | Channel, ...] = ()
    """In order."""

    @property
    def bytes(self) -> wire.Bytes:
        return np.frombuffer(self.data, np.uint8)

    @property
    def messages(self) -> wire.Table:
        """(M, 5) rows of the messages."""
        return np.asarray(self.table[self.table[:, 0] == wire.MESSAGE])

    def records(self) -> Iterator[Schema | Channel | Message]:
        """All records in order, with messages as they come."""
        described = iter(self.described)
        for start in range(0, len(self.table), ROWS_AT_ONCE):
            rows = self.table[start : start + ROWS_AT_ONCE].tolist()
            for opcode, channel, log_ns, first, length in rows:
                if opcode == wire.MESSAGE:
                    yield Message(channel, log_ns, self.data[first : first + length], log_ns, 0)
                elif opcode in (SCHEMA, CHANNEL):
                    yield next(described)


def open_chunk(chunk: Chunk) -> ChunkRecords:
    """Opens and checks a chunk.

    Raises:
        what ``recording_raw.DAMAGE`` names.
    """
    data = decompress(chunk)
    table = wire.find_records(np.frombuffer(data, np.uint8))
    return ChunkRecords(data, table, tuple(_read_descriptions(data, table)))


def _read_descriptions(data: bytes, table: wire.Table) -> Iterator[Schema | Channel]:
    rows = table[(table[:, 0] == SCHEMA) | (table[:, 0] == CHANNEL)]
    if rows[:, 4].sum() > MOST_DESCRIBED:
        raise McapError(f"a chunk with {len(rows)} schemas and channels")
    for row in rows:
        opcode, _, _, first, length = row.tolist()
        record = parse_records(opcode, data[first : first + length])
        assert isinstance(record, Schema | Channel)
        yield record


def chunk_from_messages(messages: Sequence[Message]) -> ChunkRecords:
    """Messages outside chunks."""
    data = b"".join(message.data for message in messages)
    table = np.zeros((len(messages), 5), dtype=np.int64)
    table[:, 0] = wire.MESSAGE
    table[:, 1] = [message.channel_id for message in messages]
    table[:, 2] = [message.log_time for message in messages]
    table[:, 4] = [len(message.data) for message in messages]
    table[1:, 3] = np.cumsum(table[:-1, 4])
    return ChunkRecords(data, table)


@dataclass(frozen=True)
class Profiles:
    """Stripes of several frames, one after the other."""

    count: wire.Table
    """(F,) points of each frame; N in total."""
    u: Floats  # (N,) distorted pixels
    v: Floats  # (N,)
    intensity: Floats  # (N,)
    sigma_px: Floats  # (N,)
    axis: str


def read_profiles(opened: ChunkRecords, rows: wire.Table) -> Profiles:
    """The stripes described by ``rows`` (F, 9) of ``wire_format.find_stripes``.

    They must have the same axis.
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

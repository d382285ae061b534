"""Which pictures of a recording nobody needs who makes points of it, by the index at its end.

Each picture has a chunk of its own. Where the stripe of the same frame was recorded, too, points
are made of that stripe, and the picture need not be read, nor fetched from a store.
"""

import os
import struct
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from io import BytesIO
from typing import BinaryIO

import numpy as np
from mcap.data_stream import ReadDataStream
from mcap.exceptions import EndOfFile, McapError
from mcap.opcode import Opcode
from mcap.records import Channel, ChunkIndex, Footer
from numpy.typing import NDArray

from crenel.formats.recording.raw import (
    DAMAGE,
    FOOTER_BYTES,
    HEAD,
    LARGEST_RECORD,
    MAGIC,
    parse_records,
    read_exactly,
)
from crenel.formats.recording.topics import IMAGE_TOPIC, STRIPE_TOPIC, split_topic

END_BYTES = FOOTER_BYTES + len(MAGIC)
LARGEST_SUMMARY = 256 << 20
"""Bytes of the index; a day of scanning with pictures has less."""
FOOTER_BODY = struct.Struct("<BQQQ")
STAMPS_AT = 6
"""In the index of a chunk's messages: behind its channel and its length."""
Spans = Mapping[int, int]
"""The beginnings of parts of the file, with their lengths in bytes."""


@dataclass(frozen=True)
class RecordingIndex:
    """What the end of a recording says of its chunks."""

    size: int
    """The size of the file."""
    topics: Mapping[int, str]
    """By channel."""
    chunks: tuple[ChunkIndex, ...]

    @property
    def seconds(self) -> float:
        """From its first message to its last; 0 without messages."""
        begun = min((one.message_start_time for one in self.chunks), default=0)
        return (max((one.message_end_time for one in self.chunks), default=0) - begun) / 1e9

    @property
    def pictures(self) -> tuple[ChunkIndex, ...]:
        """The chunks that hold one picture each."""
        return tuple(
            one
            for one in self.chunks
            if one.message_start_time == one.message_end_time
            and len(one.message_index_offsets) == 1
            and self._plain_topics(one) == {IMAGE_TOPIC}
        )

    @property
    def picture_spans(self) -> Spans:
        """Where the pictures are."""
        return {one.chunk_start_offset: _length(one) for one in self.pictures}

    def sensor_of(self, channel: int) -> str:
        """The name of the sensor of a channel."""
        return split_topic(self.topics.get(channel, ""))[1]

    def stripe_channels(self, chunk: ChunkIndex) -> list[int]:
        """The channels of a chunk that have stripes."""
        return [
            channel
            for channel in chunk.message_index_offsets
            if split_topic(self.topics.get(channel, ""))[0] == STRIPE_TOPIC
        ]

    def _plain_topics(self, chunk: ChunkIndex) -> set[str]:
        channels = chunk.message_index_offsets
        return {split_topic(self.topics.get(channel, ""))[0] for channel in channels}


def summary_start(end: bytes) -> int | None:
    """Where the index of a recording begins; None without one.

    Args:
        end: the last ``END_BYTES`` of the file.
    """
    try:
        footer = _footer(end)
    except DAMAGE:
        return None
    return footer.summary_start or None


def read_index(file: BinaryIO) -> RecordingIndex | None:
    """The index of a recording; None if it has none, or a damaged one."""
    try:
        size = file.seek(0, os.SEEK_END)
        file.seek(max(size - END_BYTES, 0))
        footer = _footer(read_exactly(file, END_BYTES))
        start, end = footer.summary_start, size - END_BYTES
        if not 0 < start < end or end - start > LARGEST_SUMMARY or not footer.summary_crc:
            return None
        file.seek(start)
        summary = read_exactly(file, end - start)
        about = (Opcode.FOOTER, FOOTER_BYTES - HEAD.size, start, footer.summary_offset_start)
        if zlib.crc32(FOOTER_BODY.pack(*about), zlib.crc32(summary)) != footer.summary_crc:
            return None
        return _parse(summary, size)
    except DAMAGE:
        return None


def find_needless_pictures(file: BinaryIO, index: RecordingIndex | None) -> Spans:
    """The pictures whose frames have stripes, too; none without an index.

    Args:
        file: of which only the end of each chunk with stripes is read.
    """
    if index is None or not index.pictures:
        return {}
    try:
        stripes = _stripe_stamps(file, index)
    except DAMAGE:
        return {}
    return {
        one.chunk_start_offset: _length(one)
        for one in index.pictures
        if one.message_start_time in stripes.get(_sensor_of_picture(index, one), ())
    }


def is_in_order(file: BinaryIO, index: RecordingIndex | None) -> bool:
    """Whether the messages of each channel stand in the order in which they were logged; False
    where no index says so."""
    if index is None or not index.chunks:
        return False
    last_ns: dict[int, int] = {}
    try:
        for chunk in sorted(index.chunks, key=lambda one: one.chunk_start_offset):
            for channel in chunk.message_index_offsets:
                rows = _message_index(file, chunk, channel)
                stamps_ns = rows[np.argsort(rows[:, 1], kind="stable"), 0].astype(np.int64)
                times_ns = np.r_[last_ns.get(channel, stamps_ns[:1]), stamps_ns]
                if (np.diff(times_ns) < 0).any():
                    return False
                last_ns[channel] = int(times_ns[-1])
    except DAMAGE:
        return False
    return True


def _message_index(file: BinaryIO, chunk: ChunkIndex, channel: int) -> NDArray[np.uint64]:
    """(M, 2) log times in ns of a channel's messages in a chunk, and where they stand in it."""
    file.seek(chunk.message_index_offsets[channel])
    opcode, length = HEAD.unpack(read_exactly(file, HEAD.size))
    if opcode != Opcode.MESSAGE_INDEX or not STAMPS_AT <= length <= LARGEST_RECORD:
        raise McapError("no index of messages")
    return np.frombuffer(read_exactly(file, length)[STAMPS_AT:], "<u8").reshape(-1, 2)


def _sensor_of_picture(index: RecordingIndex, chunk: ChunkIndex) -> str:
    return index.sensor_of(next(iter(chunk.message_index_offsets)))


def _stripe_stamps(file: BinaryIO, index: RecordingIndex) -> dict[str, set[int]]:
    """The times of all stripes in ns, by sensor."""
    found: dict[str, set[int]] = {}
    for chunk in index.chunks:
        for channel in index.stripe_channels(chunk):
            rows = _message_index(file, chunk, channel)
            found.setdefault(index.sensor_of(channel), set()).update(rows[:, 0].tolist())
    return found


def _footer(end: bytes) -> Footer:
    if len(end) < END_BYTES or not end.endswith(MAGIC):
        raise EndOfFile
    opcode, length = HEAD.unpack(end[: HEAD.size])
    if opcode != Opcode.FOOTER or length != FOOTER_BYTES - HEAD.size:
        raise McapError("no footer")
    footer = parse_records(opcode, end[HEAD.size : FOOTER_BYTES])
    assert isinstance(footer, Footer)
    return footer


def _parse(summary: bytes, size: int) -> RecordingIndex:
    topics: dict[int, str] = {}
    chunks: list[ChunkIndex] = []
    at = 0
    while at < len(summary):
        opcode, length = HEAD.unpack(summary[at : at + HEAD.size])
        content = summary[at + HEAD.size : at + HEAD.size + length]
        at += HEAD.size + length
        if opcode == Opcode.CHANNEL:
            channel = parse_records(opcode, content)
            assert isinstance(channel, Channel)
            topics[channel.id] = channel.topic
        elif opcode == Opcode.CHUNK_INDEX:
            chunk = ChunkIndex.read(ReadDataStream(BytesIO(content)))
            if chunk.chunk_start_offset + _length(chunk) > size:
                raise EndOfFile
            chunks.append(chunk)
    return RecordingIndex(size, topics, tuple(chunks))


def _length(chunk: ChunkIndex) -> int:
    """With the index of its messages, which follows."""
    return chunk.chunk_length + chunk.message_index_length

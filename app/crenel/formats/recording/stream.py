"""Reads a recording block by block with the heavy work on all cores, for complete
reconstructions."""

from collections import deque
from collections.abc import Generator, Iterator
from concurrent.futures import Executor, Future
from dataclasses import dataclass
from typing import BinaryIO

import numpy as np
from mcap.records import Channel, Chunk, DataEnd, Message, Metadata, Schema

from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import open_file
from crenel.formats.recording import wire_format as wire
from crenel.formats.recording.blocks import (
    ChunkRecords,
    chunk_from_messages,
    open_chunk,
    read_profiles,
)
from crenel.formats.recording.decoders import (
    SCHEMAS,
    Decoders,
    ImageRecord,
    JointRecord,
    PoseRecord,
    StripeRecord,
)
from crenel.formats.recording.index import Spans, find_needless_pictures, read_index
from crenel.formats.recording.raw import DAMAGE, LARGEST_CHUNK, MAGIC, raw_records
from crenel.formats.recording.reader import STATION_METADATA, Recording, check_magic
from crenel.formats.recording.topics import JOINTS_TOPIC, POSE_TOPIC, STRIPE_TOPIC, split_topic
from crenel.metrology.arm.reported_poses import ReadingKind
from crenel.metrology.transforms import Floats

LOOSE_BYTES = 1 << 20
"""Messages outside chunks are combined to blocks of this size."""
MOST_LOOSE = 100_000
MOST_WAITING_BYTES = 2 * LARGEST_CHUNK
"""Total size of the chunks that are being opened."""


@dataclass(frozen=True)
class ReadingSamples:
    """Consecutive readings of the arm of one kind, with the same joint names."""

    kind: ReadingKind
    names: tuple[str, ...]
    """The names of the joints; none for poses."""
    stamps_ns: wire.Table  # (J,)
    log_ns: wire.Table  # (J,)
    readings: Floats  # (J, k)


@dataclass(frozen=True)
class RecordedFrame:
    """One frame: a row of its block's table of stripes, or a separate record."""

    stamp_ns: int
    log_ns: int
    source: int | ImageRecord | StripeRecord
    sensor: str = ""
    """Its name; empty if the station has one sensor."""


@dataclass(frozen=True)
class Block:
    """The content of a part of the recording, in order."""

    chunk: ChunkRecords
    readings: list[ReadingSamples]
    frames: list[RecordedFrame]
    stripes: wire.Table
    """(S, 9) from ``wire_format.find_stripes``."""


def read_file_blocks(
    recording: Recording, pool: Executor, ahead: int, all_pictures: bool = True
) -> Iterator[Block]:
    """The blocks of a recording in the order of the file; ``ahead`` of them are opened in advance.

    Args:
        all_pictures: False: those of frames whose stripes were recorded are passed over unread,
            where the recording has its index.

    A file that is truncated or damaged ends at that position, which ``recording.cut`` then states.

    Raises:
        OperationError: as ``Recording.records``.
    """
    with convert_io_errors(recording.path), open_file(recording.path) as file:
        check_magic(recording.path, file)
        reader = _Reader(recording)
        waiting: deque[_Opening] = deque()
        skipped = {} if all_pictures else find_needless_pictures(file, read_index(file))
        for opening in _open_chunks(recording, reader, file, pool, skipped):
            waiting.append(opening)
            while _is_enough(waiting, ahead):
                if (yield from _take_block(recording, reader, waiting)):
                    return
        while waiting:
            if (yield from _take_block(recording, reader, waiting)):
                return
        if reader.damaged:
            recording.mark_cut()
        else:
            recording.bytes_read = recording.size


@dataclass(frozen=True)
class _Opening:
    """A block that is being opened."""

    opened: Future[ChunkRecords]
    end: int
    """Its end in the file."""
    size: int
    """Its size after decompression."""


def _is_enough(waiting: deque[_Opening], ahead: int) -> bool:
    size = sum(opening.size for opening in waiting)
    return len(waiting) > ahead or (len(waiting) > 1 and size > MOST_WAITING_BYTES)


def _take_block(
    recording: Recording, reader: "_Reader", waiting: deque[_Opening]
) -> Generator[Block, None, bool]:
    """Yields the oldest block; returns True if it was damaged."""
    opening = waiting.popleft()
    try:
        opened = opening.opened.result()
        reader.learn_from(opened)
    except DAMAGE:
        recording.mark_cut()
        return True
    yield reader.block(opened)
    recording.bytes_read = opening.end
    return False


def _open_chunks(
    recording: Recording, reader: "_Reader", file: BinaryIO, pool: Executor, skipped: Spans
) -> Iterator[_Opening]:
    """Chunks, and messages outside them, in the order of the file."""
    loose: list[Message] = []
    loose_bytes = 0
    file.seek(len(MAGIC))
    try:
        for record in raw_records(file, skipped=skipped):
            if isinstance(record, Message):
                loose.append(record)
                loose_bytes += len(record.data)
            elif isinstance(record, Schema | Channel):
                reader.learn(record)
            elif isinstance(record, Metadata) and record.name == STATION_METADATA:
                recording.station = dict(record.metadata)
            ends = isinstance(record, DataEnd | Chunk)
            if loose and (ends or loose_bytes > LOOSE_BYTES or len(loose) > MOST_LOOSE):
                yield _Opening(pool.submit(chunk_from_messages, loose), file.tell(), loose_bytes)
                loose, loose_bytes = [], 0
            if isinstance(record, Chunk):
                opening = pool.submit(open_chunk, record)
                yield _Opening(opening, file.tell(), record.uncompressed_size)
            elif isinstance(record, DataEnd):
                return
    except DAMAGE:
        reader.damaged = True
    if loose:
        yield _Opening(pool.submit(chunk_from_messages, loose), file.tell(), loose_bytes)


class _Reader:
    """Finds joints and frames in opened blocks, with the schemas in the file."""

    def __init__(self, recording: Recording) -> None:
        self.damaged = False
        self._recording = recording
        self._decoders = Decoders(recording.path)
        self._as_usual: dict[int, bool] = {}
        """By channel: whether its messages mean what their bytes look like."""

    def learn(self, described: Schema | Channel) -> None:
        self._recording.learn(described, self._decoders)

    def learn_from(self, opened: ChunkRecords) -> None:
        for described in opened.described:
            self.learn(described)

    def block(self, opened: ChunkRecords) -> Block:
        messages = opened.messages
        if len(messages):
            self._recording.note_times(int(messages[:, 2].min()), int(messages[:, 2].max()))
        readings: list[ReadingSamples] = []
        frames: list[tuple[int, RecordedFrame]] = []
        stripes: list[wire.Table] = []
        for channel_id in dict.fromkeys(messages[:, 1].tolist()):
            channel = self._decoders.channels.get(channel_id)
            at = np.flatnonzero(messages[:, 1] == channel_id)
            topic, sensor = split_topic("" if channel is None else channel.topic)
            if topic not in SCHEMAS:
                continue
            if topic == JOINTS_TOPIC:
                readings += self._joints(opened, messages[at])
            elif topic == POSE_TOPIC:
                readings += self._poses(opened, messages[at])
            elif topic == STRIPE_TOPIC:
                first = sum(len(table) for table in stripes)
                rows = self._stripe_rows(opened, messages[at])
                stripes.append(rows)
                frames += self._stripes(opened, messages, at, rows, first, sensor)
            else:
                frames += [(i, self._frame(opened, messages[i])) for i in at.tolist()]
        frames.sort(key=lambda found: found[0])
        table = np.concatenate(stripes) if stripes else np.zeros((0, wire.STRIPE_COLUMNS), np.int64)
        return Block(opened, readings, [frame for _, frame in frames], table)

    def _stripe_rows(self, opened: ChunkRecords, messages: wire.Table) -> wire.Table:
        rows = wire.find_stripes(opened.bytes, messages)
        channel = int(messages[0, 1])
        if channel not in self._as_usual and rows[0, wire.POINTS] >= 0:
            decoded, read = self._decode(opened, messages[0]), read_profiles(opened, rows[:1])
            self._as_usual[channel] = isinstance(decoded, StripeRecord) and (
                (decoded.stamp_ns, decoded.width_px, decoded.height_px, decoded.stripe.axis)
                == (*rows[0, : wire.U].tolist(), read.axis)
                and all(
                    np.array_equal(
                        getattr(decoded.stripe, name), getattr(read, name), equal_nan=True
                    )
                    for name in ("u", "v", "intensity", "sigma_px")
                )
            )
        if not self._as_usual.get(channel, False):
            rows[:, wire.POINTS] = -1
        return rows

    def _stripes(
        self,
        opened: ChunkRecords,
        messages: wire.Table,
        at: wire.Table,
        rows: wire.Table,
        first: int,
        sensor: str,
    ) -> list[tuple[int, RecordedFrame]]:
        found = []
        for k, (i, row) in enumerate(zip(at.tolist(), rows.tolist(), strict=True)):
            if row[wire.POINTS] < 0:
                found.append((i, self._frame(opened, messages[i])))
            else:
                log_ns = int(messages[i, 2])
                found.append((i, RecordedFrame(row[wire.STAMP], log_ns, first + k, sensor)))
        return found

    def _joints(self, opened: ChunkRecords, messages: wire.Table) -> list[ReadingSamples]:
        rows, counts, names = wire.find_joints(opened.bytes, messages)
        channel, alike = int(messages[0, 1]), (names == names[0]) & (counts == counts[0])
        if counts[0] > 0 and alike.all() and self._as_usual.get(channel, True):
            q_rad = wire.gather_joints(opened.bytes, rows, int(counts[0]))
            decoded = self._decode(opened, messages[0])
            assert isinstance(decoded, JointRecord)
            usual = decoded.stamp_ns == rows[0, 0] and np.array_equal(
                decoded.q_rad, q_rad[0], equal_nan=True
            )
            self._as_usual[channel] = usual
            if usual:
                return [ReadingSamples("joints", decoded.names, rows[:, 0], messages[:, 2], q_rad)]
        found = [(self._decode(opened, row), row[2:3]) for row in messages]
        return [
            ReadingSamples(
                "joints", one.names, np.array([one.stamp_ns]), log_ns, np.array([one.q_rad])
            )
            for one, log_ns in found
            if isinstance(one, JointRecord)
        ]

    def _poses(self, opened: ChunkRecords, messages: wire.Table) -> list[ReadingSamples]:
        found = [self._decode(opened, row) for row in messages]
        poses = [one for one in found if isinstance(one, PoseRecord)]
        stamps_ns = np.array([one.stamp_ns for one in poses], dtype=np.int64)
        readings = np.array([one.pose for one in poses])
        return [ReadingSamples("pose", (), stamps_ns, messages[:, 2], readings)]

    def _frame(self, opened: ChunkRecords, row: wire.Table) -> RecordedFrame:
        record = self._decode(opened, row)
        assert isinstance(record, ImageRecord | StripeRecord)
        return RecordedFrame(record.stamp_ns, int(row[2]), record, record.sensor)

    def _decode(self, opened: ChunkRecords, row: wire.Table) -> object:
        _, channel, log_ns, first, length = row.tolist()
        data = opened.data[first : first + length]
        return self._decoders.decode(Message(channel, log_ns, data, log_ns, 0))

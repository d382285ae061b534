"""Reading a scan recording (MCAP) as a stream, also one that was cut off."""

import os
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import BinaryIO

from mcap.records import Channel, Chunk, DataEnd, McapRecord, Metadata, Schema
from mcap.records import Message as LoggedMessage

from app.errors import OperationError
from app.formats.file_names import display_path
from app.formats.io_errors import convert_io_errors
from app.formats.open_file import open_file
from app.formats.recording.blocks import open_chunk
from app.formats.recording.decoders import Decoders, Record
from app.formats.recording.raw import DAMAGE, MAGIC, raw_records, summary_statistics
from app.messages.message import Text, message, quantity

STATION_METADATA = "crenel/station"
ARM_DELAY = "arm_delay_ns"
EXTRACTION = "extraction"
"""How stripes were extracted, as JSON; empty where all was automatic."""
SCAN_NAME, SCAN_STARTED, SCAN_CALIBRATION = "scan_name", "scan_started_at", "scan_calibration"
"""By which a scan is listed whose process was killed."""
LARGEST_PREAMBLE = 256 << 10
"""Bytes of a recording's beginning within which it describes itself."""


@dataclass
class Recording:
    """A recording opened for one pass; only one chunk of it is in memory at a time."""

    path: Path
    size: int
    bytes_read: int = 0
    last_ns: int | None = None
    """Newest log time so far."""
    first_ns: int | None = None
    cut: Text = ""
    """Where and why reading ended early; empty for a whole file."""
    station: dict[str, str] = field(default_factory=dict)
    """What the recording says of arm and sensor, e.g. ``sensor_serial``."""
    topics: set[str] = field(default_factory=set)

    @property
    def delay_ns(self) -> int:
        """By how much the arm's stamps were taken to be later than the camera's."""
        with suppress(ValueError):
            return int(self.station.get(ARM_DELAY, "0"))
        return 0

    def records(self) -> Iterator[Record]:
        """Joints, images and stripes in the order of the file.

        A file that was cut off, or is damaged from some place on, ends there with
        ``cut`` saying so.

        Raises:
            OperationError: missing, no MCAP, or a topic of another message type.
        """
        with convert_io_errors(self.path), open_file(self.path) as file:
            check_magic(self.path, file)
            yield from self._decode(file)

    def station_metadata(self) -> dict[str, str]:
        """What it says of the station before its first message; empty where it does not.

        It looks at the beginning alone, and opens no chunk.

        Raises:
            OperationError: missing, or no MCAP.
        """
        with convert_io_errors(self.path), open_file(self.path) as file:
            check_magic(self.path, file)
            with suppress(*DAMAGE):
                for record in raw_records(file, LARGEST_PREAMBLE):
                    if (
                        isinstance(record, Chunk | LoggedMessage | DataEnd)
                        or file.tell() > LARGEST_PREAMBLE
                    ):
                        break
                    if isinstance(record, Metadata) and record.name == STATION_METADATA:
                        return dict(record.metadata)
        return {}

    def _decode(self, file: BinaryIO) -> Iterator[Record]:
        decoders = Decoders(self.path)
        for record in self._raw(file, decoders):
            if isinstance(record, Metadata) and record.name == STATION_METADATA:
                self.station = dict(record.metadata)
            elif isinstance(record, LoggedMessage):
                self.note_times(record.log_time, record.log_time)
                decoded = decoders.decode(record)
                if decoded is not None:
                    yield decoded

    def _raw(self, file: BinaryIO, decoders: "Decoders") -> Iterator[McapRecord]:
        """The file's records, chunks opened and checked, up to the end of its data or the cut.

        Schemas and channels go to the decoders.
        """
        try:
            for record in raw_records(file):
                if isinstance(record, DataEnd):
                    self.bytes_read = self.size
                    return
                opened = open_chunk(record).records() if isinstance(record, Chunk) else (record,)
                for one in opened:
                    if isinstance(one, Schema | Channel):
                        self.learn(one, decoders)
                    else:
                        yield one
                self.bytes_read = file.tell()
        except DAMAGE:
            self.mark_cut()

    def learn(self, described: Schema | Channel, decoders: "Decoders") -> None:
        """Takes note of a schema or channel.

        Raises:
            McapError: there are more of them than any recording has.
        """
        decoders.learn(described)
        if isinstance(described, Channel):
            self.topics.add(described.topic)

    def note_times(self, first_ns: int, last_ns: int) -> None:
        """Takes note of log times that were met."""
        self.first_ns = first_ns if self.first_ns is None else min(self.first_ns, first_ns)
        self.last_ns = last_ns if self.last_ns is None else max(self.last_ns, last_ns)

    def mark_cut(self) -> None:
        """Takes note that nothing can be read behind what was read."""
        path, share = display_path(self.path), 100 * self.bytes_read / max(self.size, 1)
        if self.first_ns is None or self.last_ns is None:
            self.cut = message(
                "recording-cut-off-before-first-message",
                path=path,
                bytes=self.bytes_read,
                size=self.size,
                share=quantity(share, "%"),
            )
            return
        self.cut = message(
            "recording-cut-off-after",
            path=path,
            bytes=self.bytes_read,
            size=self.size,
            share=quantity(share, "%"),
            end=quantity((self.last_ns - self.first_ns) / 1e9, "s", 3),
        )


def open_recording(path: Path) -> Recording:
    """A recording to read once; raises ``OperationError`` where there is no such file."""
    with convert_io_errors(path):
        size = path.stat().st_size
        if not path.is_file():
            raise OperationError(
                "recording-not-a-file",
                display_path(path),
                message("no-file"),
                message("name-recording"),
            )
    return Recording(path, size)


def find_damage(path: Path, bytes_written: int | None = None) -> Text:
    """Why a recording that was completed is not what it was; empty where it seems whole.

    It looks at the size and at both ends alone, so that a thousand are looked at in a moment.

    Args:
        bytes_written: its size when it was completed, where that is known.
    """
    try:
        size = path.stat().st_size
        if not path.is_file():
            return message("recording-no-file")
        if not size:
            return message("recording-empty")
        if bytes_written is not None and size < bytes_written:
            return message("recording-cut-off-bytes-left", size=size, written=bytes_written)
        with open_file(path) as file:
            first = file.read(len(MAGIC))
            file.seek(-min(size, len(MAGIC)), os.SEEK_END)
            last = file.read(len(MAGIC))
    except FileNotFoundError:
        return message("recording-missing")
    except OSError as error:
        return message("recording-cannot-read", reason=error.strerror or error)
    if first != MAGIC:
        return message("recording-damaged")
    whole = last == MAGIC or bytes_written is not None
    return "" if whole else message("recording-cut-off")


def last_stamp_ns(path: Path) -> int | None:
    """The log time of a recording's last message, by its summary; None where it has none."""
    with convert_io_errors(path), open_file(path) as file:
        try:
            statistics = summary_statistics(file)
        except DAMAGE:
            return None
    return (
        statistics.message_end_time if statistics is not None and statistics.message_count else None
    )


def check_magic(path: Path, file: BinaryIO) -> None:
    """Reads a recording's first bytes; raises ``OperationError`` where they are another's."""
    head = file.read(len(MAGIC))
    if head != MAGIC:
        why = message("no-mcap-recording") if head else message("empty")
        raise OperationError(
            "recording-not-mcap", display_path(path), why, message("name-scan-mcap")
        )

"""Reads a scan recording (MCAP) as a stream, even if it was truncated."""

import json
import math
import os
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import BinaryIO

from mcap.records import Channel, Chunk, DataEnd, McapRecord, Metadata, Schema
from mcap.records import Message as LoggedMessage

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import open_file
from crenel.formats.recording.blocks import open_chunk
from crenel.formats.recording.decoders import Decoders, Record
from crenel.formats.recording.raw import DAMAGE, MAGIC, raw_records, summary_statistics
from crenel.formats.recording.topics import IMAGE_TOPIC, STRIPE_TOPIC, sensor_key, split_topic
from crenel.messages.message import Text, message, quantity
from crenel.metrology.time_delay.course import NO_DELAY, DelayCourse

STATION_METADATA = "crenel/station"
ARM_DELAY, ARM_SERIAL, SENSOR_SERIAL = "arm_delay_ns", "arm_serial", "sensor_serial"
ARM_DRIFT, ARM_DELAY_AT = "arm_drift_ppm", "arm_delay_at_ns"
"""Names of the drift of a delay, and of the camera's time stamp at which it has the stated
value."""
DELAY_KEYS = (ARM_DELAY, ARM_DELAY_AT, ARM_DRIFT)
EXTRACTION = "extraction"
"""Settings of stripe extraction, as JSON; empty if all were automatic."""
SMOOTHING = "smoothing_px"
SCAN_NAME, SCAN_STARTED, SCAN_CALIBRATION = "scan_name", "scan_started_at", "scan_calibration"
"""The name under which the scan of a killed process is listed."""
LARGEST_PREAMBLE = 256 << 10
"""A recording describes itself within this many bytes from its beginning."""


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
    """Where and why reading ended early; empty for a complete file."""
    station: dict[str, str] = field(default_factory=dict)
    """Properties of arm and sensor in the recording, e.g. ``sensor_serial``."""
    topics: set[str] = field(default_factory=set)
    written_here: bool = True
    """Whether Crenel wrote it; another program may keep no order."""

    def delay_of(self, sensor: str = "") -> DelayCourse:
        """The delay of the arm's time stamps relative to a sensor's that was applied."""
        stated = {key: self.station.get(sensor_key(key, sensor), "0") for key in DELAY_KEYS}
        with suppress(ValueError):
            drift_ppm = float(stated[ARM_DRIFT])
            if math.isfinite(drift_ppm):
                return DelayCourse(int(stated[ARM_DELAY]), int(stated[ARM_DELAY_AT]), drift_ppm)
        return NO_DELAY

    def serial_of(self, sensor: str) -> str:
        """The serial number of a sensor; empty if it is unknown."""
        return self.station.get(sensor_key(SENSOR_SERIAL, sensor), "")

    @property
    def sensors(self) -> tuple[str, ...]:
        """Names of the sensors whose topics were found so far, sorted; empty of the only one."""
        found = [split_topic(topic) for topic in self.topics]
        names = {name for topic, name in found if topic in (IMAGE_TOPIC, STRIPE_TOPIC)}
        return tuple(sorted(names))

    @property
    def smoothing_px(self) -> float:
        """By how much the stripes were smoothed along the line before they were recorded; 0 if they
        were not."""
        with suppress(ValueError, TypeError, AttributeError):
            smoothing_px = float(json.loads(self.station.get(EXTRACTION, "{}")).get(SMOOTHING, 0))
            return max(smoothing_px, 0.0) if math.isfinite(smoothing_px) else 0.0
        return 0.0

    def records(self) -> Iterator[Record]:
        """Joints, images and stripes in the order of the file.

        A file that is truncated or damaged ends at that position, which ``cut`` then states.

        Raises:
            OperationError: missing, no MCAP, or a topic of another message type.
        """
        with convert_io_errors(self.path), open_file(self.path) as file:
            check_magic(self.path, file)
            yield from self._decode(file)

    def station_metadata(self) -> dict[str, str]:
        """The properties of the station before the first message; empty if there are none.

        Only the beginning is read, and no chunk is opened.

        Raises:
            OperationError: missing, or no MCAP.
        """
        with convert_io_errors(self.path), open_file(self.path) as file:
            return read_station_metadata(self.path, file)

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
        """The records of the file, with chunks opened and checked, up to the end of its data or the
        cut.

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
        """Registers a schema or channel.

        Raises:
            McapError: there are more of them than any recording has.
        """
        decoders.learn(described)
        if isinstance(described, Channel):
            self.topics.add(described.topic)

    def note_times(self, first_ns: int, last_ns: int) -> None:
        """Registers log times."""
        self.first_ns = first_ns if self.first_ns is None else min(self.first_ns, first_ns)
        self.last_ns = last_ns if self.last_ns is None else max(self.last_ns, last_ns)

    def mark_cut(self) -> None:
        """Registers that nothing can be read beyond this position."""
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


def read_station_metadata(path: Path, file: BinaryIO) -> dict[str, str]:
    """The properties of the station from a recording's beginning, ``LARGEST_PREAMBLE`` bytes of it;
    empty if there are none.

    Args:
        path: names the recording in messages.

    Raises:
        OperationError: no MCAP.
    """
    return _find_station_metadata(path, file) or {}


def is_written_here(path: Path, file: BinaryIO) -> bool:
    """Whether Crenel wrote a recording, as its beginning shows; raises as
    ``read_station_metadata``."""
    return _find_station_metadata(path, file) is not None


def _find_station_metadata(path: Path, file: BinaryIO) -> dict[str, str] | None:
    check_magic(path, file)
    with suppress(*DAMAGE):
        for record in raw_records(file, LARGEST_PREAMBLE):
            if (
                isinstance(record, Chunk | LoggedMessage | DataEnd)
                or file.tell() > LARGEST_PREAMBLE
            ):
                break
            if isinstance(record, Metadata) and record.name == STATION_METADATA:
                return dict(record.metadata)
    return None


def open_recording(path: Path) -> Recording:
    """Opens a recording for one pass; raises ``OperationError`` if there is no such file."""
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
    """Why a completed recording has changed; empty if it seems complete.

    Only its size and both ends are checked, so that a thousand recordings take a moment.

    Args:
        bytes_written: its size when it was completed, if known.
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


def length_ns(path: Path) -> int | None:
    """The time from the first message of a recording to its last, from its summary; None if it has
    none."""
    with convert_io_errors(path), open_file(path) as file:
        try:
            statistics = summary_statistics(file)
        except DAMAGE:
            return None
    if statistics is None or not statistics.message_count:
        return None
    return statistics.message_end_time - statistics.message_start_time


def check_magic(path: Path, file: BinaryIO) -> None:
    """Reads the first bytes of a recording; raises ``OperationError`` if it is another kind of
    file."""
    head = file.read(len(MAGIC))
    if head != MAGIC:
        why = message("no-mcap-recording") if head else message("empty")
        raise OperationError(
            "recording-not-mcap", display_path(path), why, message("name-scan-mcap")
        )

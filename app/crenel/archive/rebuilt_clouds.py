"""Which clouds the archive leaves out: those that can be made again from what it holds."""

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from mcap.records import Channel, Chunk, McapRecord

from crenel.archive.notes import read_note
from crenel.archive.pace import Pace
from crenel.archive.planning import StationRecord
from crenel.errors import OperationError
from crenel.formats.open_file import open_file
from crenel.formats.recording.blocks import open_chunk
from crenel.formats.recording.raw import DAMAGE, raw_records
from crenel.formats.recording.reader import SCAN_CALIBRATION, check_magic, open_recording
from crenel.formats.recording.topics import (
    IMAGE_TOPIC,
    JOINTS_TOPIC,
    POSE_TOPIC,
    STRIPE_TOPIC,
    sensor_values,
    split_topic,
)
from crenel.formats.results.scan_record import CLOUD

RECORDING = "scan.mcap"
CALIBRATION_FILES = {"calibration.json", "arm.json"}


def leave_cloud_out(record: StationRecord, data: Path, pace: Pace) -> StationRecord:
    """A record without its cloud where that can be made again; otherwise as it is.

    Raises:
        ArchiveEndedError: the station ends.
    """
    if record.kind != "scans" or CLOUD not in {stamp.path for stamp in record.stamps}:
        return record
    if has_calibrations(record, data) and is_whole(record.folder / RECORDING, pace):
        return replace(record, left_out=frozenset({CLOUD}))
    return record


def has_calibrations(record: StationRecord, data: Path) -> bool:
    """Whether the station, or its archive, has the calibrations that a scan was taken with."""
    try:
        about = open_recording(record.folder / RECORDING).station_metadata()
    except OperationError:
        return False
    stated = sensor_values(about, SCAN_CALIBRATION)
    ids = {one for sensor, one in stated.items() if sensor} or {record.calibration_id or ""}
    return all(bool(one) and _has_calibration(data, one) for one in ids)


def _has_calibration(data: Path, calibration_id: str) -> bool:
    if Path(calibration_id).name != calibration_id:
        return False
    folder = data / "sessions" / calibration_id
    if all((folder / name).is_file() for name in CALIBRATION_FILES):
        return True
    note = read_note(data, "sessions", calibration_id)
    return note is not None and {file.path for file in note.files} >= CALIBRATION_FILES


def is_whole(recording: Path, pace: Pace) -> bool:
    """Whether a recording is complete, undamaged from its beginning to its end, and has frames and
    readings of the arm; by the checksums of its chunks.

    Raises:
        ArchiveEndedError: the station ends.
    """
    topics: dict[int, str] = {}
    used: set[int] = set()
    try:
        with open_file(recording) as file:
            check_magic(recording, file)
            for record in raw_records(file):
                described: Iterable[McapRecord] = (record,)
                if isinstance(record, Chunk):
                    pace.take(len(record.data))
                    opened = open_chunk(record)
                    described = opened.described
                    used |= set(opened.messages[:, 1].tolist())
                topics |= {one.id: one.topic for one in described if isinstance(one, Channel)}
    except (OSError, OperationError, *DAMAGE) as error:
        if isinstance(error, OperationError) and error.code == "archive-ended":
            raise
        return False
    plain = {split_topic(topics.get(channel, ""))[0] for channel in used}
    return bool(plain & {IMAGE_TOPIC, STRIPE_TOPIC}) and bool(plain & {JOINTS_TOPIC, POSE_TOPIC})

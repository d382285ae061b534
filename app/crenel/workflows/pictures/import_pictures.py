"""From pictures and the arm's readings in a folder to a recording, as a scan leaves one."""

import os
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.atomic_write import atomic_path
from crenel.formats.file_names import display_path
from crenel.formats.images import image_size
from crenel.formats.recording.completeness import MissingFrames
from crenel.formats.recording.reader import (
    ARM_DELAY,
    ARM_SERIAL,
    EXTRACTION,
    SCAN_NAME,
    SENSOR_SERIAL,
)
from crenel.formats.recording.reading_track import LONGEST_GAP_LIMIT_NS, ReadingTrack
from crenel.formats.recording.writer import RecordingWriter
from crenel.formats.session.pose_pictures import check_size
from crenel.formats.session.scan_folder import ScanFolder, ScanPicture
from crenel.formats.settings.line_settings import AUTOMATIC_LINE, LineSettings
from crenel.messages.message import message, quantity
from crenel.metrology.adjustment.core.observations import PICTURE_TWICE
from crenel.metrology.arm.kinematics import Arm
from crenel.metrology.stripe import Stripe, check_settings, empty_stripe
from crenel.progress import Progress, no_progress
from crenel.workflows.pictures.extract_stripes import (
    NOT_FOUND,
    OTHER_AXIS,
    extract_file,
    other_axis,
)

LOOKED_AT_FOR_TWO = 24
"""In so many pictures, at least, a second laser's line is looked for."""
AHEAD_NS = 200_000_000
"""Readings are written up to this time after a picture, as a station does."""


@dataclass
class ImportedScan:
    """What became of the pictures."""

    frames: int = 0
    """Number of pictures that are in the recording."""
    points: int = 0
    seconds: float | None = None
    """From the first picture to the last; None of pictures without times."""
    without_pose: int = 0
    """Frames that give no points, since no readings lie closely around their times."""
    along_other_axis: int = 0
    """Pictures whose line runs along the other axis, so that most of it is lost."""
    two_lines: list[bool] = field(default_factory=list)
    """Whether there are two lines in some of the pictures with a line."""
    looking_raw: int = 0
    """Pictures with a line whose pixels alternate as in a raw picture of a colour camera."""
    without_line: list[OperationError] = field(default_factory=list)
    """Why a picture shows no line; it is in the recording, without points."""
    unreadable: list[OperationError] = field(default_factory=list)
    """Why a picture could not be read, is of another sensor, or is that before it again; it is left
    out."""
    last_stripe: Stripe | None = None
    """The stripe in the picture before."""

    @property
    def left_out(self) -> MissingFrames:
        """Pictures that give no points though they may show a line."""
        unreadable = len(self.unreadable)
        return MissingFrames(self.without_pose + unreadable, self.frames + unreadable)


@dataclass(frozen=True)
class _Frame:
    picture: ScanPicture
    stripe: Stripe
    posed: bool
    refusal: OperationError | None = None
    along_other_axis: bool = False
    looks_raw: bool = False
    two_lines: bool | None = None
    """None if it was not looked for."""


def import_pictures(
    scan: ScanFolder,
    recording: Path,
    name: str = "",
    line: LineSettings = AUTOMATIC_LINE,
    progress: Progress = no_progress,
) -> ImportedScan:
    """Extracts the stripe of every picture, on all cores, and writes them with the readings.

    Args:
        recording: the file to write (MCAP), by ``atomic_path``.
        name: of the scan, as it is listed.
        line: what is set of the line.

    Raises:
        OperationError: the settings contradict each other, no picture shows a line or lies between
            two readings, or the file cannot be written; nothing is then written.
    """
    check_settings(line.stripe)
    names = [joint.name for joint in scan.arm.joints] if isinstance(scan.arm, Arm) else None
    about = {
        ARM_SERIAL: scan.arm.serial_number,
        SENSOR_SERIAL: scan.sensor.serial_number,
        ARM_DELAY: "0",
        EXTRACTION: line.text,
        SCAN_NAME: name,
    }
    posed = _check_poses(scan)
    result = ImportedScan()
    with atomic_path(recording) as part, RecordingWriter(part, names, about) as writer:
        written = 0
        for number, frame in enumerate(_extract_all(scan, posed, line)):
            progress(number / len(scan.pictures), frame.picture.file.name)
            written = _write_readings(writer, scan, written, frame.picture.stamp_ns + AHEAD_NS)
            _write_frame(writer, scan, frame, result)
        _write_readings(writer, scan, written, None)
        if not result.points:
            raise _no_line_error(scan, result)
    if scan.timed:
        result.seconds = (scan.pictures[-1].stamp_ns - scan.pictures[0].stamp_ns) / 1e9
    return result


def _check_poses(scan: ScanFolder) -> NDArray[np.bool_]:
    """(F,) whether a cloud has a pose for each picture; raises ``OperationError`` if for none."""
    track = ReadingTrack("joints" if isinstance(scan.arm, Arm) else "pose", scan.readings.shape[1])
    track.extend(scan.stamps_ns, scan.readings)
    at = track.at_all(np.array([picture.stamp_ns for picture in scan.pictures], np.int64))
    posed = np.asarray(np.isfinite(at).all(axis=1), np.bool_)
    if posed.any():
        return posed
    between_ns = (scan.stamps_ns[-1] - scan.stamps_ns[0]) / max(len(scan.stamps_ns) - 1, 1)
    longest = quantity(LONGEST_GAP_LIMIT_NS / 1e9, "s", 2)
    raise OperationError(
        "readings-too-far-apart",
        message(
            "no-picture-between-readings",
            path=display_path(scan.tables[2]),
            readings=display_path(scan.tables[-1]),
        ),
        message(
            "readings-are-apart-nothing-between",
            period=quantity(between_ns / 1e9, "s", 3),
            longest=longest,
        ),
        message("give-times-in-seconds-readings-closer", longest=longest),
    )


def _extract_all(
    scan: ScanFolder, posed: NDArray[np.bool_], line: LineSettings
) -> Iterator[_Frame]:
    """The stripes, in the order of the pictures."""
    sensor = scan.sensor
    if line.channel is None:
        line = replace(line, channel=sensor.channel)

    every = max(1, len(scan.pictures) // LOOKED_AT_FOR_TWO)
    looked_at = {picture.file for picture in scan.pictures[::every]}

    def extract(picture: ScanPicture, has_pose: bool) -> _Frame:
        looks = picture.file in looked_at
        try:
            check_size(picture.file, image_size(picture.file), sensor)
            found = extract_file(picture.file, sensor.stripe_axis, line, looks)
        except OperationError as refusal:
            other = refusal.code == OTHER_AXIS
            why_not = _with_axis_of_sensor(refusal, sensor.stripe_axis) if other else refusal
            return _Frame(picture, empty_stripe(sensor.stripe_axis), has_pose, why_not, other)
        return _Frame(
            picture,
            found.stripe,
            has_pose,
            along_other_axis=found.other_axis_points > 0,
            looks_raw=found.looks_raw,
            two_lines=found.two_lines if looks else None,
        )

    with ThreadPoolExecutor(os.cpu_count() or 1, "extract") as pool:
        try:
            yield from pool.map(extract, scan.pictures, posed.tolist())
        finally:
            pool.shutdown(cancel_futures=True)


def _with_axis_of_sensor(refusal: OperationError, axis: str) -> OperationError:
    """The refusal of a line along the other axis, which the sensor's datasheet states here."""
    remedy = message("import-with-stripe-axis", axis=other_axis(axis))
    return OperationError(refusal.code, refusal.what, refusal.why, remedy)


def _write_readings(
    writer: RecordingWriter, scan: ScanFolder, first: int, up_to_ns: int | None
) -> int:
    """Writes the readings from number ``first`` until a time; the number of the next."""
    while first < len(scan.stamps_ns) and (
        up_to_ns is None or int(scan.stamps_ns[first]) <= up_to_ns
    ):
        writer.reading(int(scan.stamps_ns[first]), scan.readings[first])
        first += 1
    return first


def _write_frame(
    writer: RecordingWriter, scan: ScanFolder, frame: _Frame, result: ImportedScan
) -> None:
    """Adds a frame to the recording and to the counts; one that cannot be read to these alone."""
    if frame.stripe.is_same(result.last_stripe):
        result.unreadable.append(_same_as_before(frame.picture.file))
        return
    result.last_stripe = frame.stripe
    if frame.refusal is not None:
        if frame.refusal.code not in (NOT_FOUND, OTHER_AXIS):
            result.unreadable.append(frame.refusal)
            return
        result.without_line.append(frame.refusal)
    sensor = scan.sensor
    result.along_other_axis += frame.along_other_axis
    result.looking_raw += frame.looks_raw
    if frame.two_lines is not None:
        result.two_lines.append(frame.two_lines)
    writer.stripe(frame.picture.stamp_ns, frame.stripe, sensor.width_px, sensor.height_px)
    result.frames += 1
    result.without_pose += not frame.posed
    result.points += len(frame.stripe.u)


def _same_as_before(path: Path) -> OperationError:
    return OperationError(
        PICTURE_TWICE,
        message("same-picture-as-before", name=display_path(path)),
        message("same-picture-counts-once"),
        message("give-each-pose-its-own-picture"),
    )


def _no_line_error(scan: ScanFolder, result: ImportedScan) -> OperationError:
    """The reason of the first picture, of those that could be read if there are any."""
    first = (result.without_line or result.unreadable)[0]
    if len(scan.pictures) == 1:
        return first
    count = len(scan.pictures)
    what = message("no-picture-of-folder-has-a-line", count=count, first=first.what)
    if not result.without_line:
        what = message("no-picture-of-folder-can-be-used", count=count, first=first.what)
    return OperationError(
        first.code,
        what,
        first.why,
        first.remedy,
    )

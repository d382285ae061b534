"""The delay between arm and camera from a recording, and the file that keeps it."""

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.findings import Finding
from crenel.formats.clouds.points import Points, positions_of
from crenel.formats.file_names import display_path
from crenel.formats.io_errors import prefix_errors
from crenel.formats.recording.ordering.ordered_blocks import read_blocks
from crenel.formats.recording.pose_samples import reading_reader
from crenel.formats.recording.reader import Recording, open_recording
from crenel.formats.recording.reading_track import ReadingTrack
from crenel.formats.recording.stream import Block
from crenel.formats.results.calibration import Calibration
from crenel.formats.settings.sync import Sync, SyncJump
from crenel.messages.message import message, quantity, signed, word
from crenel.metrology.arm.kinematics import AnyArm, flange_poses
from crenel.metrology.arm.reading_interpolation import Stamps
from crenel.metrology.stripe import number_sharing_noise
from crenel.metrology.time_delay.delay import ClockDelay, estimate_delay
from crenel.metrology.time_delay.plane_pass import PlanePass
from crenel.metrology.transforms import Floats
from crenel.progress import Progress, no_progress
from crenel.workflows.compatibility import check_content, check_serials, check_station
from crenel.workflows.reconstruct_frames import FrameReconstruction, reconstruct_frames
from crenel.workflows.sensor_calibrations import RecordedSensors

MOST_POINTS = 150
"""The most points of a frame that are used: the arm's noise, which all share, is the larger
part."""
MOST_FRAMES = 20_000
LEAST_SIGMA_MM = 1e-4
MOST_OFF = 0.02
"""Share of the pictures that may lie off the plane without a word."""


def estimate_recording_delay(
    recording_path: Path,
    calibration: Calibration,
    arm: AnyArm,
    progress: Progress = no_progress,
    named: str = "",
    sensor: str = "",
) -> Sync:
    """Estimates the delay from a recorded back-and-forth pass over a plane.

    ``named`` is the recording's name for the user, where that is not its path, ``sensor`` that of
    the sensor in a recording of several.
    The stamps are taken as they were recorded: a delay that the station applied when the
    pass was taken has no part in it.

    Raises:
        OperationError: calibration, arm and recording do not belong together, or the pass does
            not determine the delay (``estimate_delay``).
    """
    check_serials(calibration, arm)
    passed, recording = read_plane_pass(recording_path, calibration, arm, progress, sensor)
    named = named or str(recording_path)
    with prefix_errors(named):
        found = estimate_delay(passed)
    progress(1.0, "")
    return delay_document(
        found,
        arm.serial_number or recording.station.get("arm_serial", ""),
        calibration.serial_numbers.sensor or recording.serial_of(sensor),
        named,
    )


def read_sync(path: Path, calibration: Calibration, arm: AnyArm) -> Sync:
    """Reads ``sync.json``; raises ``OperationError`` where it is of another sensor or arm."""
    document = Sync.read(path)
    for device, of, known in (
        ("sensor", document.sensor_serial, calibration.serial_numbers.sensor),
        ("arm", document.arm_serial, arm.serial_number),
    ):
        if of and known and of != known:
            raise OperationError(
                f"{device}-of-another-serial",
                message("is-of", path=display_path(path), device=word(device), of=of),
                message("other-files", device=word(device), known=known),
                message("give-files-belong-together"),
            )
    return document


def delay_document(found: ClockDelay, arm_serial: str, sensor_serial: str, recording: str) -> Sync:
    """The file's content."""
    return Sync(
        delay_ms=found.delay_ms,
        standard_uncertainty_ms=found.standard_uncertainty_ms,
        unsteadiness_ms=found.unsteadiness_ms,
        stamp_ns=found.course.stamp_ns,
        drift_ppm=found.course.drift_ppm,
        drift_standard_uncertainty_ppm=found.drift_uncertainty_ppm,
        jumps=tuple(
            SyncJump(
                at_s=(one.jump.stamp_ns - found.first_frame_ns) / 1e9,
                at_standard_uncertainty_s=one.time_uncertainty_s,
                change_ms=one.jump.change_ns / 1e6,
                standard_uncertainty_ms=one.change_uncertainty_ms,
                stamp_ns=one.jump.stamp_ns,
                unclear_ns=one.jump.unclear_ns,
            )
            for one in found.jumps
        ),
        frames=found.frames,
        frames_off=found.frames_off,
        frames_unplaced=found.frames_unplaced,
        reversals=found.reversals,
        seconds=found.seconds,
        speed_mm_s=found.speed_mm_s,
        rms_without_um=found.rms_without_um,
        rms_um=found.rms_um,
        arm_serial=arm_serial,
        sensor_serial=sensor_serial,
        recording=recording,
    )


def delay_findings(sync: Sync) -> tuple[Finding, ...]:
    """What a user should know before using a delay: jumps, drift, variation, pictures that do not
    fit."""
    together = message("give-arm-and-camera-one-clock")
    found = [
        Finding(
            "attention",
            message(
                "delay-jumped",
                change=signed(jump.change_ms, "ms", 3),
                u=quantity(jump.standard_uncertainty_ms, "ms", 3),
                at=quantity(jump.at_s, "s", 2),
                at_u=quantity(jump.at_standard_uncertainty_s, "s", 2),
            ),
            together,
        )
        for jump in sync.jumps
    ]
    if sync.drift_ppm:
        drift = message(
            "delay-drifts",
            drift=signed(sync.drift_ppm, "ppm", 1),
            u=quantity(sync.drift_standard_uncertainty_ppm or 0.0, "ppm", 1),
            change=signed(1e-3 * sync.drift_ppm * sync.seconds, "ms", 2),
        )
        found.append(Finding("attention", drift, together))
    if sync.unsteadiness_ms:
        varies = message("delay-varies", u=quantity(sync.unsteadiness_ms, "ms", 3))
        found.append(
            Finding("attention", varies, message("give-arm-its-own-times-or-no-other-traffic"))
        )
    pictures = sync.frames + sync.frames_off
    if sync.frames_off > MOST_OFF * pictures:
        off = message("pictures-do-not-fit-delay", off=sync.frames_off, pictures=pictures)
        found.append(Finding("attention", off, message("pass-over-one-flat-plate")))
    return tuple(found)


def read_plane_pass(
    recording_path: Path,
    calibration: Calibration,
    arm: AnyArm,
    progress: Progress = no_progress,
    sensor: str = "",
) -> tuple[PlanePass, Recording]:
    """What a recording holds of its pass, in the sensor frame.

    Raises:
        OperationError: it holds no frames or no joints, too many frames, or frames of another size.
    """
    recording = open_recording(recording_path)
    reading = _PassReader(recording, calibration, arm, sensor)
    with ThreadPoolExecutor(os.cpu_count() or 1, "sync") as pool:
        for block in read_blocks(recording, pool, 2):
            reading.take(block)
            progress(0.5 * recording.bytes_read / max(recording.size, 1), "")
    return reading.plane_pass(), recording


class _PassReader:
    """One pass through a recording."""

    def __init__(
        self, recording: Recording, calibration: Calibration, arm: AnyArm, sensor: str
    ) -> None:
        self._sensor = sensor
        self._sensors = RecordedSensors(recording, {sensor: calibration})
        self._recording, self._calibration, self._arm = recording, calibration, arm
        self._readings = reading_reader(recording.path, arm)
        self._track = ReadingTrack(arm.reading_kind, arm.reading_size)
        self._points: list[Points] = []
        self._stamps_ns: list[int] = []
        self._found = 0

    def take(self, block: Block) -> None:
        """The block's joints, and its frames' points."""
        for samples in block.readings:
            self._track.extend(*self._readings.readings(samples))
        known = set(self._stamps_ns[-1000:])
        frames = [
            frame
            for frame in block.frames
            if self._sensors.calibration_of(frame.sensor) and frame.stamp_ns not in known
        ]
        if not frames:
            return
        if not self._stamps_ns:
            check_station(self._recording, self._calibration, self._arm, self._sensor)
        if len(self._stamps_ns) + len(frames) > MOST_FRAMES:
            raise OperationError(
                "recording-too-long",
                message(
                    "holds-more-than-frames",
                    path=display_path(self._recording.path),
                    most=MOST_FRAMES,
                ),
                message("pass-half-minute-enough"),
                message("record-one-pass-over-plane"),
            )
        placing = FrameReconstruction(self._recording.path, self._calibration)
        first = len(self._stamps_ns)
        here = np.tile(np.eye(4), (len(frames), 1, 1))
        found, _ = reconstruct_frames(placing, block, frames, here, first)
        self._found += len(found)
        self._points.append(_thin_points(found))
        self._stamps_ns += [frame.stamp_ns for frame in frames]

    def plane_pass(self) -> PlanePass:
        self._sensors.refuse_unknown()
        check_content(self._recording, len(self._stamps_ns), len(self._track))
        points, stamps_ns = np.concatenate(self._points), np.array(self._stamps_ns)
        order = np.argsort(stamps_ns, kind="stable")
        place = np.argsort(order)[points["frame"]]
        points = points[np.argsort(place, kind="stable")]
        counts = np.bincount(place, minlength=len(stamps_ns))
        sigma_mm = 1e-3 * points["uncertainty_um"].astype(np.float64)
        return PlanePass(
            stamps_ns[order],
            np.concatenate([[0], np.cumsum(counts)]),
            positions_of(points),
            np.maximum(sigma_mm, LEAST_SIGMA_MM),
            _poses(self._track, self._arm, self._calibration.T_flange_sensor),
            self._number_sharing_noise(),
        )

    def _number_sharing_noise(self) -> float:
        """The number of points that share noise among those kept, if the station smoothed the
        stripes along the line."""
        kept = sum(len(points) for points in self._points)
        sharing = number_sharing_noise(self._recording.smoothing_px)
        return max(1.0, sharing * kept / max(self._found, 1))


def _thin_points(points: Points) -> Points:
    """Not more than ``MOST_POINTS`` of each frame, evenly spread."""
    frame = points["frame"]
    if not len(frame):
        return points
    begins = np.flatnonzero(np.diff(frame, prepend=frame[0] - 1))
    counts = np.diff(np.append(begins, len(frame)))
    number = np.arange(len(frame)) - np.repeat(begins, counts)
    every = np.repeat(-(-counts // MOST_POINTS), counts)
    return np.asarray(points[number % every == 0])


def _poses(track: ReadingTrack, arm: AnyArm, T_flange_sensor: Floats) -> Callable[[Stamps], Floats]:
    def at(stamps_ns: Stamps) -> Floats:
        readings = track.at_all(stamps_ns)
        known = np.isfinite(readings).all(axis=1)
        found = np.full((len(stamps_ns), 4, 4), np.nan)
        if known.any():
            found[known] = flange_poses(arm, readings[known]) @ T_flange_sensor
        return found

    return at

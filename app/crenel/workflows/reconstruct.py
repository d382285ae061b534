"""From a recording to a cloud: frames, stripes, joints at their time stamps, Eq. 9."""

import os
from collections import deque
from collections.abc import Callable, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import ExitStack
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.clouds.files import cloud_writer
from crenel.formats.clouds.frame_readings import READINGS, ReadingsWriter, readings_writer
from crenel.formats.clouds.points import Points, positions_of
from crenel.formats.recording.completeness import NONE_MISSING, MissingFrames, is_mostly_unread
from crenel.formats.recording.ordering.clock_check import ClockReport, ClockWatch
from crenel.formats.recording.ordering.ordered_blocks import read_blocks
from crenel.formats.recording.pose_samples import reading_reader
from crenel.formats.recording.reader import Recording, open_recording
from crenel.formats.recording.reading_track import ReadingTrack
from crenel.formats.recording.stream import Block, RecordedFrame
from crenel.formats.results.scan_record import CLOUD
from crenel.messages.message import Text, message
from crenel.metrology.arm.kinematics import AnyArm, flange_poses
from crenel.metrology.arm.reading_interpolation import Stamps
from crenel.metrology.sensor.line_thinning import LineThinning
from crenel.metrology.time_delay.course import DelayCourse
from crenel.metrology.transforms import Floats
from crenel.progress import Progress, no_progress
from crenel.workflows.compatibility import check_content, check_serials, check_station
from crenel.workflows.reconstruct_frames import FrameReconstruction, reconstruct_frames
from crenel.workflows.reconstruct_messages import (
    clock_warnings,
    implausible_joints_warning,
    incomplete_error,
    missing_joints_warning,
    no_joints_error,
    smoothing_warning,
    still_lines_warning,
)
from crenel.workflows.sensor_calibrations import (
    RecordedSensors,
    SensorCalibrations,
    calibrations_by_sensor,
)

PointConsumer = Callable[[Points, int], None]
"""Called with new points, and the time stamp of their last frame."""
FrameConsumer = Callable[[int, str, Floats, Floats], None]
"""Called with the number of the first of F frames, the name of their sensor, ``T_arm_sensor``
(F, 4, 4), NaN where unknown, and the readings (F, k) of the arm at each."""
WRITTEN_TOGETHER_NS = 1_000_000_000
"""Readings of so long may follow the frames of their time in a file."""
RECENT_FRAMES = 4096
"""The picture of a frame is at most this many frames away from its stripe."""


@dataclass(frozen=True)
class Reconstruction:
    """The result of a reconstruction."""

    points: int
    frames: int
    """Number of frames that gave points."""
    frames_without_stripe: int
    frames_still: int
    """Frames of a line that stood still, which gave no points beyond the first ones."""
    frames_without_joints: int
    frames_unclear: int
    """Left out because a clock was set around their time stamps."""
    first_without_joints_s: float | None
    """The first of these, in seconds from the recording's first message."""
    joint_samples: int
    joint_samples_unusable: int
    frame_holes: int
    """Approximate number of missing frames, by the usual period."""
    joint_holes: int
    """The same for joint samples."""
    clock_jumps: int
    """Number of times that a clock was set back or forward."""
    seconds: float
    """From the recording's first message to its last."""
    cut: Text
    """Where and why the recording ended early; empty if it is complete."""
    warnings: tuple[Text, ...]
    """Notes for the user of the cloud, one sentence each."""
    incomplete: bool = False
    """So much is missing that the cloud must not be taken for the scan; a warning says what."""

    left_out: MissingFrames = NONE_MISSING
    """Frames with a line that gave no points though the arm should have been known."""

    @property
    def all_frames(self) -> int:
        placed = self.frames + self.frames_still + self.frames_without_stripe
        return placed + self.frames_without_joints + self.frames_unclear


@dataclass(frozen=True)
class _PendingFrames:
    """Frames of one sensor in a block that wait for the joints around them."""

    block: Block
    frames: list[RecordedFrame]
    placing: FrameReconstruction
    first_number: int
    last_ns: int
    at_ns: Stamps
    """(F,) the frames' time stamps by the arm's clock."""
    clear: NDArray[np.bool_]
    """(F,) False for frames around a clock that was set."""


@dataclass(frozen=True)
class _BlockPoints:
    """The result of the frames of a block."""

    points: Points
    has_line: NDArray[np.bool_]
    """(F,)"""
    unplaced: list[tuple[int, int]]
    """Time stamps by the camera's and the arm's clock."""
    unclear: int
    last_ns: int
    first_number: int
    poses: Floats
    """(F, 4, 4)"""
    readings: Floats
    """(F, k)"""
    sensor: str
    thinning: LineThinning


def reconstruct_cloud(
    recording_path: Path,
    calibration: SensorCalibrations,
    arm: AnyArm,
    cloud_path: Path,
    progress: Progress = no_progress,
    delay: DelayCourse | None = None,
    threads: int | None = None,
    allow_incomplete: bool = False,
) -> Reconstruction:
    """Reconstructs the cloud of a recording in the arm frame and writes it in the format of its
    name.

    The recording is opened, and points are made, on several cores; only a few blocks of it
    are in memory at a time. Beside ``cloud.ply`` in the folder of its recording, ``readings.ply``
    is written too.

    Args:
        calibration: of the only sensor, or one for each sensor by its name; frames of a named
            sensor without one are left out.
        delay: of the arm's time stamps relative to the camera's; None: as applied by the station,
            if the recording states it.
        threads: that compute at the same time; None: one for each core.
        allow_incomplete: whether the points that are possible are wanted however many are
            missing; ``Reconstruction.incomplete`` then says that they are too few.

    Raises:
        OperationError: calibration, arm and recording do not belong together, the recording
            holds no frames or no joints, none of its frames has joints around its stamp, so many
            have none that the scan is incomplete, or the delay drifts and was determined long
            before or after; the cloud is then not written.
    """
    with ExitStack() as files:
        keep: FrameConsumer = _keep_none
        if _is_of_scan(cloud_path, recording_path):
            path = cloud_path.with_name(READINGS)
            written = files.enter_context(readings_writer(path, arm.reading_size))
            keep = _keep_in(written, calibration)
        cloud = files.enter_context(cloud_writer(cloud_path))
        return reconstruct_into(
            recording_path,
            calibration,
            arm,
            lambda points, _: cloud.append(points),
            progress,
            delay,
            threads=threads,
            allow_incomplete=allow_incomplete,
            take_frames=keep,
        )


def _is_of_scan(cloud: Path, recording: Path) -> bool:
    """Whether a cloud is that of the scan in the folder of a recording."""
    return cloud.name == CLOUD and cloud.resolve().parent == recording.resolve().parent


def _keep_none(first: int, sensor: str, poses: Floats, readings: Floats) -> None:
    """Keeps no readings."""


def _keep_in(written: ReadingsWriter, calibration: SensorCalibrations) -> FrameConsumer:
    """Keeps readings in a file."""
    names = sorted(calibrations_by_sensor(calibration))

    def keep(first: int, sensor: str, poses: Floats, readings: Floats) -> None:
        written.append(first, names.index(sensor), poses[:, :3, 3], readings)

    return keep


def reconstruct_points(
    recording_path: Path,
    calibration: SensorCalibrations,
    arm: AnyArm,
    delay: DelayCourse | None = None,
    allow_incomplete: bool = False,
) -> tuple[Floats, Reconstruction]:
    """Like ``reconstruct_cloud``, with the points (N, 3) in memory."""
    kept: list[Floats] = []
    result = reconstruct_into(
        recording_path,
        calibration,
        arm,
        lambda points, _: kept.append(positions_of(points)),
        delay=delay,
        allow_incomplete=allow_incomplete,
    )
    return np.concatenate(kept), result


def reconstruct_into(
    recording_path: Path,
    calibration: SensorCalibrations,
    arm: AnyArm,
    take: PointConsumer,
    progress: Progress = no_progress,
    delay: DelayCourse | None = None,
    threads: int | None = None,
    allow_incomplete: bool = False,
    take_frames: FrameConsumer = _keep_none,
) -> Reconstruction:
    """Like ``reconstruct_cloud``; passes the points to ``take``, and what is known of their frames
    to ``take_frames``, in order, in the caller's thread."""
    for one in calibrations_by_sensor(calibration).values():
        check_serials(one, arm)
    consumers = (take, take_frames)
    job = _Job(open_recording(recording_path), calibration, arm, consumers, delay)
    workers = threads or os.cpu_count() or 1
    with ThreadPoolExecutor(workers, "rebuild") as pool:
        try:
            job.run(pool, 2 * workers, progress)
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    return job.result(allow_incomplete)


class _Job:
    """One pass over a recording."""

    def __init__(
        self,
        recording: Recording,
        calibration: SensorCalibrations,
        arm: AnyArm,
        take: tuple[PointConsumer, FrameConsumer],
        delay: DelayCourse | None,
    ) -> None:
        self._recording = recording
        self._sensors = RecordedSensors(recording, calibration)
        self._arm = arm
        self._take_points, self._take_frame_data = take
        self._given_delay = delay
        self._points = 0
        self._readings = reading_reader(recording.path, arm)
        self._track = ReadingTrack(arm.reading_kind, arm.reading_size)
        self._recent: deque[tuple[str, int]] = deque(maxlen=RECENT_FRAMES)
        self._known: set[tuple[str, int]] = set()
        self._numbered = 0
        self._waiting: deque[_PendingFrames] = deque()
        self._making: deque[Future[_BlockPoints]] = deque()
        self._frames = self._dark = self._still = self._unclear = 0
        self._thinning: dict[str, LineThinning] = {}
        self._unplaced_ns: list[int] = []
        self._unplaced_at_ns: list[int] = []
        """The same by the arm's clock."""
        self._stamps_from_ns: int | None = None
        self._arm_clock = ClockWatch()
        self._frame_clocks: dict[str, ClockWatch] = {}

    def run(self, pool: ThreadPoolExecutor, window: int, progress: Progress) -> None:
        for block in read_blocks(self._recording, pool, window, all_pictures=False):
            self._take_block(block)
            if len(self._track):
                self._submit_ready(pool, self._track.last_ns)
            while len(self._making) > window:
                self._write()
            progress(self._recording.bytes_read / max(self._recording.size, 1), "")
        self._track.extend(*self._readings.last_readings())
        self._readings.refuse_another_arm()
        self._submit_ready(pool, None)
        while self._making:
            self._write()
        progress(1.0, "")

    def result(self, allow_incomplete: bool) -> Reconstruction:
        """The counts; raises ``OperationError`` if there are no points, or too few."""
        self._check_result()
        missing = self._missing()
        if missing and not allow_incomplete:
            raise incomplete_error(self._recording.path, missing, self._causes())
        unplaced, start_ns = self._unplaced_ns, self._start_ns
        as_logged = not self._recording.written_here
        joints = self._arm_clock.report(as_logged)
        frames = [clock.report(as_logged) for clock in self._frame_clocks.values()]
        return Reconstruction(
            points=self._points,
            frames=self._frames,
            frames_without_stripe=self._dark,
            frames_still=self._still,
            frames_without_joints=len(unplaced),
            frames_unclear=self._unclear,
            first_without_joints_s=(unplaced[0] - start_ns) / 1e9 if unplaced else None,
            joint_samples=len(self._track),
            joint_samples_unusable=self._readings.unusable,
            frame_holes=sum(one.holes for one in frames),
            joint_holes=joints.holes,
            clock_jumps=joints.jumps + sum(one.jumps for one in frames),
            seconds=((self._recording.last_ns or 0) - (self._recording.first_ns or 0)) / 1e9,
            cut=self._recording.cut,
            warnings=tuple(self._warnings(joints, frames)),
            incomplete=bool(missing),
            left_out=self._missing_frames(),
        )

    def _missing(self) -> Text:
        """What makes the scan incomplete; empty if little or nothing was left out."""
        left_out = self._missing_frames()
        if left_out.is_too_much:
            return left_out.text
        if is_mostly_unread(self._recording.bytes_read, self._recording.size):
            return message("scan-incomplete-unread")
        return ""

    def _delay(self, sensor: str) -> DelayCourse:
        given = self._given_delay
        return self._recording.delay_of(sensor) if given is None else given

    def _take_block(self, block: Block) -> None:
        """Adds the joints of a block to the track, and its frames to those that wait."""
        for samples in block.readings:
            self._track.extend(*self._readings.readings(samples))
            if self._readings.is_of_arm(samples):
                self._arm_clock.add(samples.stamps_ns, samples.log_ns)
                self._note_start(samples.stamps_ns)
        frames = [frame for frame in block.frames if self._is_new(frame)]
        for sensor, run in groupby(frames, key=lambda frame: frame.sensor):
            self._take_frames(block, sensor, list(run))

    def _take_frames(self, block: Block, sensor: str, frames: list[RecordedFrame]) -> None:
        """Adds consecutive frames of one sensor to those that wait."""
        calibration = self._sensors.calibration_of(sensor)
        if calibration is None:
            self._sensors.leave_out(sensor, len(frames))
            return
        if sensor not in self._thinning:
            check_station(self._recording, calibration, self._arm, sensor)
            used = calibration.camera, calibration.plane, calibration.stripe_axis
            self._thinning[sensor] = LineThinning(*used)
        stamps_ns = np.array([frame.stamp_ns for frame in frames], dtype=np.int64)
        self._note_start(stamps_ns)
        clock = self._frame_clocks.setdefault(sensor, ClockWatch())
        clock.add(stamps_ns, np.array([frame.log_ns for frame in frames]))
        placing = FrameReconstruction(self._recording.path, calibration)
        delay = self._delay(sensor)
        delay.check_age(stamps_ns)
        self._waiting.append(
            _PendingFrames(
                block,
                frames,
                placing,
                self._numbered,
                int(stamps_ns.max()),
                stamps_ns + delay.at(stamps_ns),
                delay.is_clear(stamps_ns),
            )
        )
        self._numbered += len(frames)

    def _note_start(self, stamps_ns: Stamps) -> None:
        if len(stamps_ns):
            earliest_ns = int(stamps_ns.min())
            before_ns = self._stamps_from_ns
            self._stamps_from_ns = earliest_ns if before_ns is None else min(before_ns, earliest_ns)

    @property
    def _start_ns(self) -> int:
        """The earliest stamp of a reading or a frame."""
        return self._stamps_from_ns or 0

    def _is_new(self, frame: RecordedFrame) -> bool:
        """False if the stripe of a frame was recorded next to its picture."""
        one = (frame.sensor, frame.stamp_ns)
        if one in self._known:
            return False
        if len(self._recent) == RECENT_FRAMES:
            self._known.discard(self._recent[0])
        self._recent.append(one)
        self._known.add(one)
        return True

    def _submit_ready(self, pool: ThreadPoolExecutor, up_to_ns: int | None) -> None:
        """Starts computing the points of frames with later joints; None: no more will follow."""
        while self._waiting and (up_to_ns is None or int(self._waiting[0].at_ns.max()) <= up_to_ns):
            waiting = self._waiting.popleft()
            readings = self._track.at_all(waiting.at_ns)
            readings[~waiting.clear] = np.nan
            self._making.append(pool.submit(self._make_points, waiting, readings))
            if up_to_ns is None and len(self._making) > 2 * (os.cpu_count() or 1):
                self._write()

    def _make_points(self, waiting: _PendingFrames, readings: Floats) -> _BlockPoints:
        """In a worker thread: the points of a block's frames (Eq. 9)."""
        known = np.asarray(np.isfinite(readings).all(axis=1))
        poses = np.full((len(known), 4, 4), np.nan)
        if known.any():
            T_arm_flange = flange_poses(self._arm, readings[known])
            poses[known] = T_arm_flange @ waiting.placing.calibration.T_flange_sensor
        points, counts = reconstruct_frames(
            waiting.placing, waiting.block, waiting.frames, poses, waiting.first_number
        )
        unplaced = [
            (waiting.frames[i].stamp_ns, int(waiting.at_ns[i]))
            for i in np.flatnonzero((counts > 0) & ~known & waiting.clear)
        ]
        unclear = int(((counts > 0) & ~waiting.clear).sum())
        return _BlockPoints(
            points,
            counts > 0,
            unplaced,
            unclear,
            waiting.last_ns,
            waiting.first_number,
            poses,
            readings,
            waiting.frames[0].sensor,
            self._thinning[waiting.frames[0].sensor],
        )

    def _write(self) -> None:
        made = self._making.popleft().result()
        points, kept = made.points, made.thinning.keep(made.poses, made.has_line)
        if not kept.all():
            points = points[kept[points["frame"].astype(np.int64) - made.first_number]]
        self._points += len(points)
        self._take_points(points, made.last_ns)
        self._take_frame_data(made.first_number, made.sensor, made.poses, made.readings)
        with_line, still = int(made.has_line.sum()), int((~kept).sum())
        self._frames += with_line - still - len(made.unplaced) - made.unclear
        self._still += still
        self._dark += len(kept) - with_line
        self._unplaced_ns += [stamp_ns for stamp_ns, _ in made.unplaced]
        self._unplaced_at_ns += [at_ns for _, at_ns in made.unplaced]
        self._unclear += made.unclear

    def _missing_frames(self) -> MissingFrames:
        """Without the frames at both ends that only the delay moves beyond the arm's readings, and
        those just before a cut, whose readings the file no longer has."""
        first_ns, last_ns = self._track.first_ns or 0, self._track.last_ns or 0
        cut_ns = last_ns + WRITTEN_TOGETHER_NS if self._recording.cut else last_ns
        at_ends = sum(
            (first_ns <= stamp_ns <= last_ns and not first_ns <= at_ns <= last_ns)
            or last_ns < at_ns <= cut_ns
            for stamp_ns, at_ns in zip(self._unplaced_ns, self._unplaced_at_ns, strict=True)
        )
        missing = len(self._unplaced_ns) + self._unclear
        return MissingFrames(missing - at_ends, self._frames + self._still + missing)

    def _warnings(self, joints: ClockReport, frames: Sequence[ClockReport]) -> list[Text]:
        missing = self._missing()
        warnings = [missing] if missing else []
        warnings += self._sensors.warnings()
        if others := self._readings.other_joints:
            warnings.append(message("joints-of-others-left-out", names=", ".join(others)))
        if self._recording.smoothing_px:
            warnings.append(smoothing_warning(self._recording.smoothing_px))
        if self._still:
            warnings.append(still_lines_warning(self._still, self._numbered))
        warnings += self._causes()
        start_ns = self._start_ns
        warnings += clock_warnings("joints", joints, start_ns)
        for report in frames:
            warnings += clock_warnings("frames", report, start_ns)
        return warnings

    def _causes(self) -> list[Text]:
        """Why frames gave no points: the end of the file, and what is wrong with the joints."""
        causes = [self._recording.cut] if self._recording.cut else []
        start_ns = self._start_ns
        if self._unplaced_ns:
            causes.append(
                missing_joints_warning(
                    self._unplaced_ns, self._unplaced_at_ns, self._numbered, self._track, start_ns
                )
            )
        if self._unclear:
            causes.append(
                message("frames-left-out-clock-set", count=self._unclear, frames=self._numbered)
            )
        if self._readings.unusable:
            causes.append(
                message("joint-samples-left-out-numbers", unusable=self._readings.unusable)
            )
        first = self._readings.first_implausible
        if first is not None:
            causes.append(implausible_joints_warning(self._readings.implausible, first, start_ns))
        return causes

    def _check_result(self) -> None:
        self._sensors.refuse_unknown()
        if self._points:
            return
        named = check_content(self._recording, self._numbered, len(self._track))
        if self._unplaced_ns:
            start_ns = self._start_ns
            raise no_joints_error(named, self._unplaced_ns, self._track, start_ns)
        raise OperationError(
            "recording-without-stripes",
            message("no-laser-stripe-front-sensor-any", named=named, numbered=self._numbered),
            message("laser-off-too-weak-part-out"),
            message("scan-again"),
        )

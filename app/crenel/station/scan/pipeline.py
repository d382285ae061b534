"""A running scan: frames or lines to stripes, to the recording, to points, to the display."""

import logging
import os
import queue
import time
from collections.abc import Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.clouds.files import CloudWriter, cloud_writer
from crenel.formats.clouds.frame_readings import READINGS, ReadingsWriter, readings_writer
from crenel.formats.io_errors import error_from_os
from crenel.formats.recording.completeness import MissingFrames
from crenel.formats.recording.reader import ARM_SERIAL, EXTRACTION, SCAN_CALIBRATION
from crenel.formats.results.scan_record import CLOUD
from crenel.formats.settings.scan_settings import AUTOMATIC, ScanSettings
from crenel.loops import start_worker
from crenel.messages.message import message
from crenel.station.devices.arm_device import LATE_S, StationArm
from crenel.station.scan.points import Show
from crenel.station.scan.recorder import Recorder, StripeFrame
from crenel.station.scan.scan_speed import ScanSpeed
from crenel.station.scan.sources import BATCH_FRAMES, ScanSensor, ScanSource
from crenel.station.scan.storage import RECORDING
from crenel.station.working_distance import Distance, classify_distance
from crenel_hardware.interfaces import Frame

log = logging.getLogger(__name__)

CORES = os.cpu_count() or 1
GATHER_S = 0.01
POINTS_QUEUE = 64
POLL_S = 0.1


@dataclass(slots=True)
class Counts:
    """What a scan has got so far."""

    frames: int = 0
    points: int = 0
    frames_without_joints: int = 0
    """With a line, which gave no points therefore."""
    frames_without_stripe: int = 0

    @property
    def left_out(self) -> MissingFrames:
        """How many of the frames with a line were left out."""
        return MissingFrames(self.frames_without_joints, self.frames - self.frames_without_stripe)


class ScanPipeline:
    """Stages on threads of their own, with bounded queues between them.

    The recording comes first and drops nothing: when the disk is slow the frames
    wait, and those that then find the tap full are counted as lost. Points are
    written to ``cloud.ply``, and the arm at each frame to ``readings.ply``, as they
    come, so that memory does not grow with the scan.
    """

    def __init__(
        self,
        arm: StationArm,
        sensors: Sequence[ScanSensor],
        folder: Path,
        show: Show,
        settings: ScanSettings = AUTOMATIC,
        about: Mapping[str, str] | None = None,
    ) -> None:
        """``about``: what the recording says of the scan beside its devices and calibrations."""
        self._about = dict(about or {})
        self.counts = Counts()
        self.failure: OperationError | None = None
        self._arm = arm
        self._cloud_path = folder / CLOUD
        self._extracting: queue.Queue[Future[list[StripeFrame]] | None] = queue.Queue(2 * CORES)
        self._ended = False
        self._rejected_before = arm.rejected_count
        arm.keep_frame(True)
        self._settings = settings
        self._sources = [ScanSource(arm, one, settings, show) for one in sensors]
        self._by_name = {source.name: source for source in self._sources}
        late_s = max(source.longest_delay_s for source in self._sources)
        # frames of a late arm wait for its readings
        waiting = round(POINTS_QUEUE * (1 + late_s / LATE_S))
        self._stripes: queue.Queue[list[StripeFrame] | None] = queue.Queue(waiting)
        first = self._sources[0].calibration
        self._arm_serial = first.arm_serial
        self._recorder = Recorder(
            folder / RECORDING,
            first.joint_names,
            self._metadata(),
            arm,
            tuple(self._by_name),
            [source.delay for source in self._sources],
        )
        self._taking = len(self._sources)
        self._threads = [
            start_worker("scan-take", self._take_all, source) for source in self._sources
        ]
        self._threads.append(start_worker("scan-record", self._record_all))
        self._threads.append(start_worker("scan-points", self._make_cloud))

    @property
    def bytes_written(self) -> int:
        """The bytes of the recording."""
        return self._recorder.bytes_written

    @property
    def lost_frames(self) -> int:
        """Frames that the sensors lost, and those that found the queues full here."""
        return sum(source.lost_frames for source in self._sources)

    @property
    def speed(self) -> ScanSpeed:
        """The speed of the sensor whose speed is known now and was too high most often."""
        return max(
            (source.speed for source in self._sources),
            key=lambda speed: (speed.now is not None, speed.frames_too_fast),
        )

    @property
    def rate_points_s(self) -> float:
        """Points of the last second, of all sensors."""
        return sum(source.points.rate_per_s for source in self._sources)

    @property
    def distance(self) -> Distance | None:
        """The distance of the newest stripe from its camera, against the calibrated range of that
        sensor; None where none was seen just now."""
        for source in self._sources:
            if (found_mm := source.points.distance_mm) is not None:
                return classify_distance(found_mm, source.calibration.depth_range_mm)
        return None

    @property
    def frames_still(self) -> int:
        """Frames of lines that stood still, which gave no points."""
        return sum(source.points.frames_still for source in self._sources)

    @property
    def is_still(self) -> bool:
        """Whether some sensor sees a line, and none sees one that moves."""
        seen = [one.points for one in self._sources if one.points.distance_mm is not None]
        return bool(seen) and all(points.is_still for points in seen)

    @property
    def implausible(self) -> tuple[int, OperationError | None]:
        """How many of the arm's readings could not be true, and what is said of the newest."""
        count = self._arm.rejected_count - self._rejected_before
        return count, self._arm.newest_rejection if count > 0 else None

    @property
    def backlog(self) -> float:
        """How far the slowest stage is behind, 0 to 1 (frames are lost beyond)."""
        return max(self._recorder.backlog, self._stripes.qsize() / self._stripes.maxsize)

    @property
    def trouble(self) -> OperationError | None:
        """Why the scan cannot go on: the disk, most likely."""
        return self.failure or self._recorder.failure

    @property
    def pictures(self) -> tuple[int, int]:
        """Recorded, and left out because the disk was busy with stripes."""
        return self._recorder.pictures, self._recorder.pictures_dropped

    def apply(self, settings: ScanSettings) -> None:
        """Goes on by other settings; the delay stays what the recording began with."""
        for source in self._sources:
            source.apply(settings)
        self._settings = settings
        self._recorder.add_metadata(self._metadata())

    def describe(self, about: Mapping[str, str]) -> None:
        """What else the recording says of the scan."""
        self._about |= about
        self._recorder.add_metadata(self._metadata())

    def _metadata(self) -> dict[str, str]:
        """What the recording says of the station."""
        about = dict(self._about)
        if "" not in self._by_name:  # a scan of several is listed with the first one's
            about[SCAN_CALIBRATION] = self._sources[0].calibration.id
        about[ARM_SERIAL] = self._arm_serial
        for source in self._sources:
            about |= source.metadata()
        return {**about, EXTRACTION: self._settings.extraction_text}

    def stop(self) -> None:
        """Takes no more frames, finishes those taken, and completes both files."""
        for source in self._sources:
            source.end()
        for thread in self._threads:
            thread.join()
        self._recorder.close()
        self._arm.keep_frame(False)

    def _take_all(self, source: ScanSource) -> None:
        """Sends frames to be extracted on all cores, some at a time; waits when they are behind."""
        try:
            with ThreadPoolExecutor(CORES, "scan-extract") as pool:
                while not source.tap.finished:
                    self._take_some(source, pool)
        except BaseException as error:
            self._fail("the frames of a scan could not be taken", error)
        finally:
            self._extracting.put(None)

    def _take_some(self, source: ScanSource, pool: ThreadPoolExecutor) -> None:
        time.sleep(GATHER_S)
        taken = source.tap.get(BATCH_FRAMES, POLL_S)
        frames = [frame for frame in taken if frame.laser_on]
        if self._settings.record_pictures:
            for frame in frames:
                if isinstance(frame, Frame):
                    self._recorder.offer_picture(frame, source.name)
        if frames:
            self._extracting.put(pool.submit(source.extract, frames))

    def _record_all(self) -> None:
        """Passes stripes on in the order of their frames, to the recording first."""
        while self._taking:
            try:
                self._record_next()
            except BaseException as error:
                self._fail("the stripes of a scan could not be extracted", error)
        self._stripes.put(None)

    def _record_next(self) -> None:
        work = self._extracting.get()
        if work is None:
            self._taking -= 1
            return
        found = work.result()
        self.counts.frames += len(found)
        self.counts.frames_without_stripe += sum(not len(one.stripe.u) for one in found)
        if self._recorder.put(found):
            self._stripes.put(found)

    def _fail(self, what: str, error: BaseException) -> None:
        """The scan ends with a reason, the station lives; the stages before and after go on to
        their end, or those that wait for them would not come to theirs."""
        if self.failure is not None:
            return
        if isinstance(error, OperationError):
            self.failure = error
        elif isinstance(error, OSError):
            self.failure = error_from_os(error, self._cloud_path)
        else:
            log.error("%s", what, exc_info=error)
            self.failure = OperationError(
                "failed",
                message("scan-stopped-within-sentence"),
                str(error),
                message("start-again-within-sentence"),
            )

    def _make_cloud(self) -> None:
        """Writes the cloud; goes on showing points where the disk fails."""
        size = self._sources[0].calibration.arm.reading_size
        try:
            with (
                readings_writer(self._cloud_path.with_name(READINGS), size) as arm,
                cloud_writer(self._cloud_path) as cloud,
            ):
                self._make_points(cloud, arm)
        except BaseException as error:
            self._fail("the points of a scan could not be computed", error)
        # the stage before ends only when its queue takes all
        while self._next_stripes() is not None:
            continue

    def _make_points(self, cloud: CloudWriter, arm: ReadingsWriter) -> None:
        number = 0
        sensors = sorted(self._by_name)
        while (frames := self._next_stripes()) is not None:
            source = self._by_name[frames[0].sensor]
            stamps_ns = np.array([frame.stamp_ns for frame in frames])
            stamps_ns += source.delay.at(stamps_ns)
            late_s = LATE_S + source.longest_delay_s
            readings = self._arm.at_all(stamps_ns, late_s if self._arm.fresh else 0.0)
            known = (
                np.isfinite(readings).all(axis=1) if readings is not None else np.zeros(len(frames))
            )
            placed = [int(i) for i in np.flatnonzero(known)]
            unplaced = set(range(len(frames))).difference(placed)
            self.counts.frames_without_joints += sum(len(frames[i].stripe.u) > 0 for i in unplaced)
            if readings is not None and placed:
                stripes = [frames[i].stripe for i in placed]
                last = placed[-1]
                too_fast = source.judge_speed(frames[last], readings[last], len(frames))
                numbers = number + np.array(placed)
                used = readings[placed]
                places_mm = source.points.add(cloud, stripes, used, numbers, too_fast)
                arm.append(numbers, sensors.index(source.name), places_mm, used)
                self.counts.points = cloud.points
            number += len(frames)

    def _next_stripes(self) -> list[StripeFrame] | None:
        """What comes next; None at the end, however often it is asked for."""
        if not self._ended and (frames := self._stripes.get()) is not None:
            return frames
        self._ended = True
        return None

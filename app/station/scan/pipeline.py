"""A running scan: frames or lines to stripes, to the recording, to points, to the display."""

import logging
import os
import queue
import threading
import time
from collections.abc import Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from app.errors import OperationError
from app.formats.clouds.files import CloudWriter, cloud_writer
from app.formats.io_errors import error_from_os
from app.formats.recording.reader import ARM_DELAY, EXTRACTION, SCAN_CALIBRATION
from app.formats.settings.scan_settings import AUTOMATIC, ScanSettings
from app.messages.message import message
from app.metrology.transforms import Floats
from app.station.devices.arm_device import LATE_S, StationArm
from app.station.devices.sensor_device import StationSensor
from app.station.scan.extraction import extraction_by
from app.station.scan.points import PointMaker, ScanCalibration, Show
from app.station.scan.recorder import Recorder, StripeFrame
from app.station.scan.scan_speed import ScanSpeed
from app.station.scan.storage import CLOUD, RECORDING
from hardware.interfaces import Frame, SensorReading

log = logging.getLogger(__name__)

CORES = os.cpu_count() or 1
# Frames are worked on so many at a time, where they come faster than the wait for more.
BATCH_FRAMES = 16
GATHER_S = 0.01
# Frames wait to be worked on in so much memory, whatever else the machine is busy with.
WAITING_BYTES = 1 << 28
FEWEST_WAITING, MOST_WAITING = 32, 1024
POINTS_QUEUE = 64
POLL_S = 0.1


@dataclass(slots=True)
class Counts:
    """What a scan has got so far."""

    frames: int = 0
    points: int = 0
    frames_without_joints: int = 0
    frames_without_stripe: int = 0


class ScanPipeline:
    """Stages on threads of their own, with bounded queues between them.

    The recording comes first and drops nothing: when the disk is slow the frames
    wait, and those that then find the tap full are counted as lost. Points are
    written to ``cloud.ply`` as they come, so that memory does not grow with the scan.
    """

    def __init__(
        self,
        arm: StationArm,
        sensor: StationSensor,
        calibration: ScanCalibration,
        folder: Path,
        show: Show,
        settings: ScanSettings = AUTOMATIC,
        about: Mapping[str, str] | None = None,
    ) -> None:
        """``about``: what the recording says of the scan beside its devices and calibration."""
        self._about = dict(about or {})
        self.counts = Counts()
        self.speed = ScanSpeed(arm, settings.blur_limit_mm)
        self.failure: OperationError | None = None
        self._arm = arm
        self._sensor = sensor
        self._calibration = calibration
        self._cloud_path = folder / CLOUD
        self._extracting: queue.Queue[Future[list[StripeFrame]] | None] = queue.Queue(2 * CORES)
        self._stripes: queue.Queue[list[StripeFrame] | None] = queue.Queue(POINTS_QUEUE)
        self._ended = False
        self._lost_before = sensor.reader.link().lost
        self._rejected_before = arm.rejected_count
        self._settings = settings
        self._extraction = extraction_by(settings, calibration.stripe_axis)
        self._delay_ns = 0
        if not sensor.is_paired:  # pulses have no delay
            self._delay_ns = settings.delay_ns(calibration.arm_serial, calibration.sensor_serial)
        self.points = PointMaker(calibration, show)
        names = calibration.joint_names
        self._recorder = Recorder(folder / RECORDING, names, self._metadata(), arm)
        self._tap = sensor.frames.tap(_queue_length(sensor))
        self._threads = [
            threading.Thread(target=self._take_all, name="scan-take", daemon=True),
            threading.Thread(target=self._record_all, name="scan-record", daemon=True),
            threading.Thread(target=self._make_cloud, name="scan-points", daemon=True),
        ]
        for thread in self._threads:
            thread.start()

    @property
    def bytes_written(self) -> int:
        """Of the recording."""
        return self._recorder.bytes_written

    @property
    def lost_frames(self) -> int:
        """Frames that the sensor lost, and those that found the queue full here."""
        return self._tap.dropped + self._sensor.reader.link().lost - self._lost_before

    @property
    def implausible(self) -> tuple[int, OperationError | None]:
        """How many of the arm's readings could not be true, and what is said of the newest."""
        count = self._arm.rejected_count - self._rejected_before
        return count, self._arm.newest_rejection if count > 0 else None

    @property
    def backlog(self) -> float:
        """How far the slowest stage is behind, 0 to 1 (frames are lost beyond)."""
        return max(self._recorder.backlog, self._stripes.qsize() / POINTS_QUEUE)

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
        self._extraction = extraction_by(settings, self._calibration.stripe_axis)
        self.speed.limit_mm = settings.blur_limit_mm
        self._settings = settings
        self._recorder.add_metadata(self._metadata())

    def _metadata(self) -> dict[str, str]:
        """What the recording says of the station."""
        return {
            **self._about,
            SCAN_CALIBRATION: self._calibration.id,
            "arm_serial": self._calibration.arm_serial,
            "sensor_serial": self._calibration.sensor_serial,
            ARM_DELAY: str(self._delay_ns),
            EXTRACTION: self._settings.extraction_text,
        }

    def stop(self) -> None:
        """Takes no more frames, finishes those taken, and completes both files."""
        self._sensor.frames.untap(self._tap)
        for thread in self._threads:
            thread.join()
        self._recorder.close()

    def _take_all(self) -> None:
        """Sends frames to be extracted on all cores, some at a time; waits when they are behind."""
        with ThreadPoolExecutor(CORES, "scan-extract") as pool:
            while not self._tap.finished:
                time.sleep(GATHER_S)
                taken = self._tap.get(BATCH_FRAMES, POLL_S)
                frames = [frame for frame in taken if frame.laser_on]
                if self._settings.record_pictures:
                    for frame in frames:
                        if isinstance(frame, Frame):
                            self._recorder.offer_picture(frame)
                if frames:
                    self._extracting.put(pool.submit(self._extract, frames))
        self._extracting.put(None)

    def _extract(self, frames: Sequence[SensorReading]) -> list[StripeFrame]:
        """On a worker's thread: the stripes of frames, and those that the sensor found itself.

        Where frames wait for it, the stripe is followed from the first one on.
        """
        extraction = self._extraction
        for frame in frames:
            self._check_size(frame)
        pictures = [frame for frame in frames if isinstance(frame, Frame)]
        band = extraction.band(pictures[0].image) if len(pictures) == BATCH_FRAMES else None
        found = []
        for frame in frames:
            if not isinstance(frame, Frame):
                stripe = extraction.line_stripe(frame)
            else:
                stripe = band.extract(frame.image) if band else extraction.stripe(frame.image)
            height, width = _shape(frame)
            found.append(
                StripeFrame(frame.mid_exposure_ns, stripe, width, height, frame.exposure_us)
            )
        return found

    def _check_size(self, frame: SensorReading) -> None:
        """Pixels of another picture would become points in wrong places."""
        camera, shape = self._calibration.camera, _shape(frame)
        if shape != (camera.height_px, camera.width_px):
            raise OperationError(
                "image-size",
                message("sensor-now-sends-pictures-pixels", size=" × ".join(map(str, shape[::-1]))),
                message(
                    "calibration-is-for-pixels", width=camera.width_px, height=camera.height_px
                ),
                message("set-sensor-back-scan-again"),
            )

    def _record_all(self) -> None:
        """Passes stripes on in the order of their frames, to the recording first."""
        while (work := self._extracting.get()) is not None:
            try:
                found = work.result()
            except OperationError as refusal:
                self.failure = self.failure or refusal
                continue
            except Exception as error:  # the scan ends with a reason, the station lives
                log.exception("the stripes of a scan could not be extracted")
                self.failure = self.failure or _failure_error(error)
                continue
            self.counts.frames += len(found)
            self.counts.frames_without_stripe += sum(not len(one.stripe.u) for one in found)
            if self._recorder.put(found):
                self._stripes.put(found)
        self._stripes.put(None)

    def _make_cloud(self) -> None:
        """Writes the cloud; goes on showing points where the disk fails."""
        try:
            with cloud_writer(self._cloud_path) as cloud:
                self._make_points(cloud)
        except OperationError as refusal:
            self.failure = self.failure or refusal
        except OSError as error:
            self.failure = self.failure or error_from_os(error, self._cloud_path)
        except Exception as error:  # the scan ends with a reason, the station lives
            log.exception("the points of a scan could not be computed")
            self.failure = _failure_error(error)
        # the stage before ends only when its queue takes all
        while self._next_stripes() is not None:
            continue

    def _make_points(self, cloud: CloudWriter) -> None:
        number = 0
        while (frames := self._next_stripes()) is not None:
            stamps_ns = np.array([frame.stamp_ns for frame in frames])
            stamps_ns += self._delay_ns
            readings = self._arm.at_all(stamps_ns, LATE_S if self._arm.fresh else 0.0)
            known = (
                np.isfinite(readings).all(axis=1) if readings is not None else np.zeros(len(frames))
            )
            placed = [int(i) for i in np.flatnonzero(known)]
            self.counts.frames_without_joints += len(frames) - len(placed)
            if readings is not None and placed:
                stripes = [frames[i].stripe for i in placed]
                self.points.add(cloud, stripes, readings[placed], number + np.array(placed))
                self.counts.points = cloud.points
                self._judge_speed(frames[placed[-1]], readings[placed[-1]], len(frames))
            number += len(frames)

    def _next_stripes(self) -> list[StripeFrame] | None:
        """What comes next; None at the end, however often it is asked for."""
        if not self._ended and (frames := self._stripes.get()) is not None:
            return frames
        self._ended = True
        return None

    def _judge_speed(self, frame: StripeFrame, readings: Floats, frames: int) -> None:
        """Of the last of some frames: how fast the sensor went."""
        stamp_ns = frame.stamp_ns + self._delay_ns
        before_reading = self.speed.reading_before(stamp_ns)
        if before_reading is None or not len(frame.stripe.u):
            return
        before, at = self._calibration.sensor_poses(np.stack([before_reading, readings]))
        stripe_mm, spread = self._calibration.points([frame.stripe], np.eye(4)[None])
        self.speed.judge(stripe_mm, spread, (before, at), stamp_ns, frame.exposure_us, frames)


def _shape(frame: SensorReading) -> tuple[int, ...]:
    """Height and width of the picture; more numbers if it is not grey."""
    if isinstance(frame, Frame):
        return frame.image.shape
    return frame.height_px, frame.width_px


def _failure_error(error: Exception) -> OperationError:
    return OperationError("failed", message("scan-stopped-2"), str(error), message("start-again-2"))


def _queue_length(sensor: StationSensor) -> int:
    """How many of its frames may wait, of up to 16 bits."""
    info = sensor.info
    if info is None:
        return FEWEST_WAITING
    frame_bytes = 2 * info.width_px * info.height_px
    return min(max(WAITING_BYTES // frame_bytes, FEWEST_WAITING), MOST_WAITING)

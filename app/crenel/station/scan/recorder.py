"""The recording of a scan: joints and stripes to disk, before anything else is made of them."""

import logging
import queue
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.recording.writer import RecordingWriter
from crenel.loops import Loop, start_worker
from crenel.messages.message import message
from crenel.metrology.stripe import Stripe
from crenel.metrology.time_delay.course import DelayCourse
from crenel.station.devices.arm_device import LATE_S, StationArm
from crenel_hardware.clock import now_ns
from crenel_hardware.interfaces import Frame

log = logging.getLogger(__name__)

QUEUE_BATCHES = 64
QUEUE_PICTURES = 16
POLL_S = 0.05
# What a killed process may lose.
FLUSH_S = 0.25
# What a power failure may lose beside.
SYNC_S = 0.75
# A busy or slow disk may take this long for what waits.
LONGEST_SYNC_S = 60.0
# Joints are recorded from a little before the scan, so that its first frame has them around it.
LEAD_NS = 200_000_000


@dataclass(frozen=True)
class StripeFrame:
    """The stripe of one frame, by the stamp of its mid-exposure."""

    stamp_ns: int
    stripe: Stripe
    width_px: int
    height_px: int
    exposure_us: float
    sensor: str = ""
    """Its name; empty of the only one."""


class Recorder:
    """Writes on a thread of its own; ``put`` waits when the disk cannot keep up.

    A full disk ends the recording, with what was written kept: ``failure`` says
    so, and nothing more is taken.
    """

    def __init__(
        self,
        path: Path,
        joint_names: tuple[str, ...] | None,
        station: Mapping[str, str],
        arm: StationArm,
        sensors: tuple[str, ...],
        delays: Sequence[DelayCourse],
    ) -> None:
        """``joint_names``, ``station``, ``sensors``: as of ``RecordingWriter``; ``delays``: of the
        arm's time stamps behind those of the sensors."""
        self.failure: OperationError | None = None
        self.pictures = self.pictures_dropped = 0
        self._delays = tuple(delays)
        self._arm = arm
        began_ns = now_ns()
        first_ns, _ = self._arm_times_ns(began_ns)
        self._joints_after_ns = min(began_ns, first_ns) - LEAD_NS
        self._frames: queue.Queue[list[StripeFrame] | None] = queue.Queue(QUEUE_BATCHES)
        self._pictures: queue.Queue[tuple[Frame, str]] = queue.Queue(QUEUE_PICTURES)
        self._metadata: queue.Queue[Mapping[str, str]] = queue.Queue()
        self._writer = RecordingWriter(
            path, joint_names, station, sensors, time.time_ns() - began_ns
        )
        self._thread = start_worker("scan-recorder", self._run)
        # a disk that takes long over it holds up no frames
        self._syncer = Loop("scan-sync", self._writer.sync, SYNC_S, longest_s=LONGEST_SYNC_S)
        self._syncer.start()

    @property
    def backlog(self) -> float:
        """How full the queue to the disk is, 0 to 1."""
        return self._frames.qsize() / QUEUE_BATCHES

    @property
    def bytes_written(self) -> int:
        return self._writer.bytes_written

    def put(self, frames: list[StripeFrame]) -> bool:
        """Passes frames to the disk; waits while the queue is full. False after a failure."""
        while self.failure is None:
            try:
                self._frames.put(frames, timeout=POLL_S)
                return True
            except queue.Full:
                continue
        return False

    def offer_picture(self, frame: Frame, sensor: str) -> None:
        """Has a sensor's picture recorded where there is time for it; else it counts as dropped."""
        try:
            self._pictures.put_nowait((frame, sensor))
        except queue.Full:
            self.pictures_dropped += 1

    def add_metadata(self, station: Mapping[str, str]) -> None:
        """Adds what has changed of the station since the recording began."""
        self._metadata.put(station)

    def close(self) -> None:
        """Writes what waits, with the joints around it, and completes the file."""
        while self._thread.is_alive():
            try:
                self._frames.put(None, timeout=POLL_S)
                break
            except queue.Full:
                continue
        self._thread.join()
        self._syncer.stop(None)

    def _run(self) -> None:
        try:
            with self._writer:
                last_ns = self._write_frames()
                if self._arm.fresh:
                    at_ns = self._arm_times_ns(last_ns)[1]
                    self._arm.at(at_ns, LATE_S + max(at_ns - last_ns, 0) / 1e9)
                self._write_joints()
        except OperationError as refusal:
            self.failure = refusal
        except BaseException as error:  # the scan ends with a reason, the station lives
            log.exception("a scan could not be recorded")
            self.failure = OperationError(
                "failed",
                message("recording-stopped"),
                str(error),
                message("start-again-within-sentence"),
            )

    def _write_frames(self) -> int:
        """Until asked to end; the last frame's stamp."""
        last_ns, flushed_s = 0, time.monotonic()
        while True:
            if time.monotonic() - flushed_s > FLUSH_S:
                self._writer.flush()
                flushed_s = time.monotonic()
            while not self._metadata.empty():
                self._writer.write_metadata(self._metadata.get())
            if self._frames.empty():
                self._write_picture()
            try:
                frames = self._frames.get(timeout=POLL_S if self._pictures.empty() else 0.0)
            except queue.Empty:
                self._write_joints()
                continue
            if frames is None:
                self._write_pictures_left()
                return last_ns
            self._write_joints()
            for frame in frames:
                last_ns = max(last_ns, frame.stamp_ns)
                self._writer.stripe(
                    frame.stamp_ns, frame.stripe, frame.width_px, frame.height_px, frame.sensor
                )

    def _write_picture(self) -> None:
        """One, when no stripe waits."""
        with suppress(queue.Empty):
            frame, sensor = self._pictures.get_nowait()
            self._writer.image(frame.mid_exposure_ns, frame.image, sensor)
            self.pictures += 1

    def _write_pictures_left(self) -> None:
        while not self._pictures.empty():
            self._write_picture()

    def _arm_times_ns(self, stamp_ns: int) -> tuple[int, int]:
        """The earliest and the latest time of a frame by the arm's clock."""
        at_ns = [stamp_ns + delay.at_one(stamp_ns) for delay in self._delays]
        return min(at_ns), max(at_ns)

    def _write_joints(self) -> None:
        now = now_ns()
        window = self._arm.window(self._joints_after_ns + 1, max(now, self._arm_times_ns(now)[1]))
        if window is None or not len(window):
            return
        for stamp_ns, reading in zip(window.stamps_ns.tolist(), window.readings, strict=True):
            self._writer.reading(stamp_ns, reading)
        self._joints_after_ns = int(window.stamps_ns[-1])

"""The recording of a scan: joints and stripes to disk, before anything else is made of them."""

import queue
import threading
import time
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from app.files.recording_writer import RecordingWriter
from app.metrology.refusal import Refusal
from app.metrology.stripe import Stripe
from app.station.arm_side import LATE_S, ArmSide
from hardware.clock import now_ns

QUEUE_BATCHES = 64
POLL_S = 0.05
# What a killed process may lose.
FLUSH_S = 0.5
# Joints are recorded from a little before the scan, so that its first frame has them around it.
LEAD_NS = 200_000_000


@dataclass(frozen=True)
class StripeFrame:
    """The stripe of one frame, by the stamp of its mid-exposure."""

    stamp_ns: int
    stripe: Stripe
    width_px: int
    height_px: int


class Recorder:
    """Writes on a thread of its own; ``put`` waits when the disk cannot keep up.

    A full disk ends the recording, with what was written kept: ``failure`` says
    so, and nothing more is taken.
    """

    def __init__(
        self, path: Path, joint_names: tuple[str, ...], station: Mapping[str, str], arm: ArmSide
    ) -> None:
        self.failure: Refusal | None = None
        self._arm = arm
        self._joints_after_ns = now_ns() - LEAD_NS
        self._frames: queue.Queue[list[StripeFrame] | None] = queue.Queue(QUEUE_BATCHES)
        self._writer = RecordingWriter(path, joint_names, station)
        self._thread = threading.Thread(target=self._run, name="scan-recorder", daemon=True)
        self._thread.start()

    @property
    def backlog(self) -> float:
        """How full the queue to the disk is, 0 to 1."""
        return self._frames.qsize() / QUEUE_BATCHES

    @property
    def bytes_written(self) -> int:
        return self._writer.bytes_written

    def put(self, frames: list[StripeFrame]) -> bool:
        """Hands frames to the disk; waits while the queue is full. False after a failure."""
        while self.failure is None:
            try:
                self._frames.put(frames, timeout=POLL_S)
                return True
            except queue.Full:
                continue
        return False

    def close(self) -> None:
        """Writes what waits, with the joints around it, and completes the file."""
        while self._thread.is_alive():
            try:
                self._frames.put(None, timeout=POLL_S)
                break
            except queue.Full:
                continue
        self._thread.join()

    def _run(self) -> None:
        try:
            with self._writer:
                last_ns = self._write_frames()
                if self._arm.fresh:
                    self._arm.at(last_ns, LATE_S)
                self._write_joints()
        except Refusal as refusal:
            self.failure = refusal

    def _write_frames(self) -> int:
        """Until told to end; the last frame's stamp."""
        last_ns, flushed_s = 0, time.monotonic()
        while True:
            if time.monotonic() - flushed_s > FLUSH_S:
                self._writer.flush()
                flushed_s = time.monotonic()
            try:
                frames = self._frames.get(timeout=POLL_S)
            except queue.Empty:
                self._write_joints()
                continue
            if frames is None:
                return last_ns
            self._write_joints()
            for frame in frames:
                last_ns = frame.stamp_ns
                self._writer.stripe(last_ns, frame.stripe, frame.width_px, frame.height_px)

    def _write_joints(self) -> None:
        window = self._arm.window(self._joints_after_ns + 1, now_ns())
        if window is None or not len(window):
            return
        for stamp_ns, q_rad in zip(window.stamps_ns.tolist(), window.q_rad, strict=True):
            self._writer.joints(stamp_ns, q_rad)
        self._joints_after_ns = int(window.stamps_ns[-1])

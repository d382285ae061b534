"""From a recording to a cloud: frames, stripes, joints at their stamps, Eq. 9."""

import os
from collections import deque
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from app.files.calibration import Calibration
from app.files.clouds import CloudWriter, cloud_writer
from app.files.joint_track import JointTrack
from app.files.progress import Progress, no_progress
from app.files.recorded_joints import JointReader
from app.files.recording import (
    IMAGE_TOPIC,
    JOINTS_TOPIC,
    STRIPE_TOPIC,
    ImageRecord,
    JointRecord,
    Recording,
    StripeRecord,
    open_recording,
)
from app.metrology.arm import Arm, flange_poses
from app.metrology.frames import Floats, apply
from app.metrology.point_spread import spread_um
from app.metrology.reconstruct import sensor_points
from app.metrology.refusal import Refusal
from app.metrology.stripe import Stripe, extract_stripe

SETTLED_AT_ONCE = 32
"""Frames whose poses are computed together."""


@dataclass(frozen=True)
class Rebuilt:
    """What became of a recording."""

    points: int
    frames: int
    """That gave points."""
    frames_without_stripe: int
    frames_without_joints: int
    first_without_joints_s: float | None
    """The first of these, in seconds from the recording's first message."""
    joint_samples: int
    joint_samples_unusable: int
    cut: str
    """Where and why the recording ended early; empty for a whole one."""

    @property
    def all_frames(self) -> int:
        return self.frames + self.frames_without_stripe + self.frames_without_joints

    @property
    def warnings(self) -> list[str]:
        """What whoever asked for the cloud should know, one sentence each."""
        said = [self.cut] if self.cut else []
        if self.first_without_joints_s is not None:
            said.append(
                f"{self.frames_without_joints} of {self.all_frames} frames left out: no joints "
                f"around their stamps, the first {self.first_without_joints_s:.3f} s from the start"
            )
        if self.joint_samples_unusable:
            said.append(f"{self.joint_samples_unusable} joint samples left out: not numbers")
        return said


@dataclass(frozen=True)
class _Seen:
    """One frame's stripe in the sensor frame."""

    number: int
    stamp_ns: int
    points_mm: Floats
    spread_um: Floats
    stripe: Stripe


def rebuild(
    recording_path: Path,
    calibration: Calibration,
    arm: Arm,
    cloud_path: Path,
    progress: Progress = no_progress,
) -> Rebuilt:
    """Reconstructs a recording's cloud in the arm frame and writes it, as its name says.

    Pictures are decoded, extracted and brought to the sensor frame on all cores; only
    a few of them are in memory at a time.

    Raises:
        Refusal: calibration, arm and recording do not belong together, the recording
            holds no frames or no joints, or none of its frames has joints around its
            stamp; the cloud is then not written.
    """
    _check_serials(calibration, arm)
    recording = open_recording(recording_path)
    with cloud_writer(cloud_path) as cloud:
        job = _Job(recording, calibration, arm, cloud)
        workers = os.cpu_count() or 1
        with ThreadPoolExecutor(workers, "stripe") as pool:
            try:
                job.run(pool, 4 * workers, progress)
            except BaseException:
                pool.shutdown(cancel_futures=True)
                raise
        return job.result()


class _Job:
    """One pass over a recording."""

    def __init__(
        self, recording: Recording, calibration: Calibration, arm: Arm, cloud: CloudWriter
    ) -> None:
        self._recording = recording
        self._calibration = calibration
        self._arm = arm
        self._cloud = cloud
        self._joints = JointReader(recording.path, arm)
        self._track = JointTrack(arm.joint_count)
        self._stamps: set[int] = set()
        self._working: deque[Future[_Seen]] = deque()
        self._waiting: deque[_Seen] = deque()
        self._frames = self._dark = 0
        self._unplaced_ns: list[int] = []

    def run(self, pool: ThreadPoolExecutor, window: int, progress: Progress) -> None:
        for record in self._recording.records():
            if isinstance(record, JointRecord):
                q_rad = self._joints.angles(record)
                if q_rad is not None:
                    self._track.add(record.stamp_ns, q_rad)
                continue
            if record.stamp_ns in self._stamps:  # its stripe was recorded beside its picture
                continue
            if not self._stamps:
                self._check_station()
            number = len(self._stamps)
            self._stamps.add(record.stamp_ns)
            self._working.append(pool.submit(self._seen, number, record))
            if len(self._working) >= window:
                self._waiting.append(self._working.popleft().result())
                if len(self._track) and len(self._waiting) >= SETTLED_AT_ONCE:
                    self._settle(self._track.last_ns)
                progress(self._recording.bytes_read / max(self._recording.size, 1), "")
        self._waiting.extend(future.result() for future in self._working)
        self._settle(None)
        progress(1.0, "")

    def result(self) -> Rebuilt:
        """The counts; raises ``Refusal`` where there are no points."""
        self._refuse_nothing()
        unplaced = self._unplaced_ns
        start_ns = self._recording.first_ns or 0
        return Rebuilt(
            points=self._cloud.points,
            frames=self._frames,
            frames_without_stripe=self._dark,
            frames_without_joints=len(unplaced),
            first_without_joints_s=(unplaced[0] - start_ns) / 1e9 if unplaced else None,
            joint_samples=len(self._track),
            joint_samples_unusable=self._joints.unusable,
            cut=self._recording.cut,
        )

    def _seen(self, number: int, record: ImageRecord | StripeRecord) -> _Seen:
        """On a worker's thread: the frame's stripe, in pixels and in the sensor frame."""
        if isinstance(record, StripeRecord):
            self._check_size(number, record.width_px, record.height_px)
            stripe = record.stripe
        else:
            picture = record.picture()
            self._check_size(number, picture.shape[1], picture.shape[0])
            stripe = extract_stripe(picture, self._calibration.stripe_axis)
        uv_px = np.column_stack([stripe.u, stripe.v])
        camera, plane = self._calibration.camera, self._calibration.plane
        points = sensor_points(camera, plane, uv_px)
        spread = spread_um(camera, plane, points, stripe.sigma_px, stripe.axis)
        return _Seen(number, record.stamp_ns, points, spread, stripe)

    def _settle(self, up_to_ns: int | None) -> None:
        """Places waiting frames once the joints reach past them; None: no more will come."""
        placed: list[tuple[_Seen, Floats]] = []
        while self._waiting and (up_to_ns is None or self._waiting[0].stamp_ns <= up_to_ns):
            seen = self._waiting.popleft()
            q_rad = self._track.at(seen.stamp_ns)
            if not len(seen.points_mm):
                self._dark += 1
            elif q_rad is None:
                self._unplaced_ns.append(seen.stamp_ns)
            else:
                placed.append((seen, q_rad))
        if not placed:
            return
        T_arm_flange = flange_poses(self._arm, np.array([q_rad for _, q_rad in placed]))
        for T, (seen, _) in zip(T_arm_flange, placed, strict=True):
            # Eq. 9, its two rigid steps in one
            points_mm = apply(T @ self._calibration.T_flange_sensor, seen.points_mm)
            self._cloud.write(points_mm, seen.stripe.intensity, seen.spread_um, seen.number)
        self._frames += len(placed)

    def _check_size(self, number: int, width_px: int, height_px: int) -> None:
        camera = self._calibration.camera
        if (width_px, height_px) != (camera.width_px, camera.height_px):
            raise Refusal(
                "image-size",
                f"{self._recording.path}: frame {number} has {width_px} × {height_px} pixels",
                f"the calibration is for {camera.width_px} × {camera.height_px}",
                "Give the calibration of the sensor that took this recording",
            )

    def _check_station(self) -> None:
        station, serials = self._recording.station, self._calibration.serial_numbers
        path = self._recording.path
        for device, recorded, known in (
            ("sensor", station.get("sensor_serial", ""), serials.sensor),
            ("arm", station.get("arm_serial", ""), self._arm.serial_number),
        ):
            if recorded and known and recorded != known:
                raise Refusal(
                    f"{device}-of-another-serial",
                    f"{path} was taken with {device} {recorded}",
                    f"the {'calibration' if device == 'sensor' else 'arm.json'} is for {known}",
                    "Give the files that belong together",
                )

    def _refuse_nothing(self) -> None:
        if self._cloud.points:
            return
        topics = self._recording.topics
        named = self._recording.cut or str(self._recording.path)
        if not self._recording.cut and not {JOINTS_TOPIC, IMAGE_TOPIC, STRIPE_TOPIC} & topics:
            raise Refusal(
                "recording-foreign",
                f"{named} holds {', '.join(sorted(topics)) or 'no topics'}",
                f"a scan has {JOINTS_TOPIC} and {IMAGE_TOPIC} or {STRIPE_TOPIC}",
            )
        if not self._stamps:
            raise Refusal("recording-without-frames", f"{named}: no frames")
        if not len(self._track):
            raise Refusal("recording-without-joints", f"{named}: no joint angles")
        if self._unplaced_ns:
            raise self._no_joints_around(named)
        raise Refusal(
            "recording-without-stripes",
            f"{named}: no laser stripe in front of the sensor in any frame of {len(self._stamps)}",
            "the laser was off, too weak, or the part out of range",
            "Scan again",
        )

    def _no_joints_around(self, named: str) -> Refusal:
        start_ns, track = self._recording.first_ns or 0, self._track

        def span(first_ns: int, last_ns: int) -> str:
            return f"from {(first_ns - start_ns) / 1e9:.3f} to {(last_ns - start_ns) / 1e9:.3f} s"

        return Refusal(
            "no-joints-around-frames",
            f"{named}: no joints around any frame's stamp",
            f"frames {span(self._unplaced_ns[0], self._unplaced_ns[-1])}, joint samples "
            f"{span(track.first_ns or 0, track.last_ns or 0)}, of which neighbours up to "
            f"{track.gap_limit_ns / 1e6:.0f} ms apart are used",
            "Scan again, with arm and camera on one clock",
        )


def _check_serials(calibration: Calibration, arm: Arm) -> None:
    known = calibration.serial_numbers.arm
    if known and arm.serial_number and known != arm.serial_number:
        raise Refusal(
            "arm-of-another-serial",
            f"the arm model is of arm {arm.serial_number}",
            f"the calibration is for arm {known}",
            "Give the files that belong together",
        )

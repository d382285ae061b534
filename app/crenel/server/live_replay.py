"""Replay of a recording: feeds the live view from a file, at any speed."""

import math
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from crenel.errors import OperationError, sentence
from crenel.formats.clouds.cuts import read_cuts
from crenel.formats.clouds.points import Points
from crenel.formats.recording.decoders import ImageRecord
from crenel.formats.recording.ordering.ordered_blocks import read_blocks
from crenel.formats.recording.pose_samples import reading_reader
from crenel.formats.recording.reader import length_ns, open_recording
from crenel.formats.results.calibration import Calibration
from crenel.loops import start_worker
from crenel.messages.message import Text, join, message
from crenel.metrology.arm.kinematics import AnyArm, Arm
from crenel.metrology.arm.reading_interpolation import Stamps
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.transforms import Floats, apply, rigid
from crenel.station.bus import Bus
from crenel.station.view3d.scene import Scene
from crenel.wire.schema import ReplayPhase, ReplayState
from crenel.workflows.reconstruct import reconstruct_into
from crenel.workflows.sensor_calibrations import SensorCalibrations, calibrations_by_sensor
from crenel_hardware.clock import now_ns
from crenel_hardware.interfaces import ArmInfo, SensorInfo
from crenel_hardware.replay import Readings, RecordedImages, ReplayArm, ReplayClock, ReplaySensor

PIECE_S = 0.05
"""Points are shown in portions of this duration."""
DEPTH_MM = (-50.0, 50.0)
"""The drawn measuring range, about the middle of the picture."""


TOPIC = "replay"
PUBLISH_PERIOD_S = 0.2


class Replay:
    """Plays one recording: its arm moves, its pictures and points appear."""

    def __init__(
        self, path: Path, calibration: SensorCalibrations, arm: AnyArm, speed: float
    ) -> None:
        """Reads the beginning of the recording; raises ``OperationError`` if it cannot be
        replayed."""
        self._path, self._calibrations, self._arm = path, calibration, arm
        # of several sensors, the first one is drawn
        self._shown, self._calibration = next(iter(calibrations_by_sensor(calibration).items()))
        self._rate_hz, first_ns = self._inspect()
        self._clock = ReplayClock(first_ns, speed)
        self._length_ns = length_ns(path)
        self._cuts = read_cuts(path.parent)
        self._points = 0
        self._last_publish_s = -math.inf
        self._ended = threading.Event()
        self._thread: threading.Thread | None = None

    def arm(self) -> ReplayArm:
        """A driver for the recorded arm."""
        known = self._arm
        joint_count = known.joint_count if isinstance(known, Arm) else 0
        info = ArmInfo(
            known.name,
            known.serial_number,
            joint_count,
            self._rate_hz,
            reports=known.reading_kind,
            buttons=frozenset(),
            free_running=False,
        )
        return ReplayArm(info, self._clock, self._readings)

    def sensor(self) -> ReplaySensor:
        """A driver for the recorded sensor."""
        camera, serial = self._calibration.camera, self._calibration.serial_numbers.sensor or ""
        info = SensorInfo(
            self._path.name, serial, camera.width_px, camera.height_px, (1000.0, 1000.0), False
        )
        return ReplaySensor(info, self._clock, self._pictures)

    def start(self, scene: Scene, bus: Bus) -> None:
        """Starts to show points, in a separate thread."""
        use = self._calibration
        scene.begin(cuts=self._cuts)
        scene.set_arm_model(self._arm)
        depth = float(np.median(_depths(use)))
        low, high = depth + DEPTH_MM[0], depth + DEPTH_MM[1]
        scene.set_sensor(use.T_flange_sensor, use.camera, use.plane, (max(low, 1.0), high))
        self._clock.start()
        self._thread = start_worker("replay", self._show, scene, bus)

    def stop(self) -> None:
        """Stops showing points."""
        self._ended.set()
        if self._thread is not None:
            self._thread.join(5.0)

    def _inspect(self) -> tuple[float, int]:
        """The arm's rate in readings per second, and the first time stamp."""
        stamps = [stamp_ns for stamp_ns, _ in _first(self._readings(), 200)]
        if len(stamps) < 2:
            raise OperationError(
                "recording-without-joints", message("recording-has-no-joints", path=self._path)
            )
        return 1e9 * (len(stamps) - 1) / max(stamps[-1] - stamps[0], 1), stamps[0]

    def _readings(self) -> Readings:
        reader = reading_reader(self._path, self._arm)
        with ThreadPoolExecutor(1, "replay-joints") as pool:
            for block in read_blocks(open_recording(self._path), pool, 1):
                for samples in block.readings:
                    yield from _pair(*reader.readings(samples))
        yield from _pair(*reader.last_readings())

    def _pictures(self) -> RecordedImages:
        with ThreadPoolExecutor(1, "replay-pictures") as pool:
            for block in read_blocks(open_recording(self._path), pool, 1):
                for frame in block.frames:
                    if frame.sensor == self._shown and isinstance(frame.source, ImageRecord):
                        yield frame.stamp_ns, frame.source.picture()

    def _show(self, scene: Scene, bus: Bus) -> None:
        last_ns = self._clock.first_ns

        def take(points: Points, stamp_ns: int) -> None:
            nonlocal last_ns
            for part, at_ns in self._in_time(points, last_ns, stamp_ns):
                scene.add_points(part)
                self._points += len(part)
                self._publish_state(scene, bus, at_ns)
            last_ns = stamp_ns

        self._publish_state(scene, bus, last_ns)
        try:
            rebuilt = reconstruct_into(self._path, self._calibrations, self._arm, take)
        except _ReplayEndedError:
            return
        except OperationError as error:
            self._publish_state(scene, bus, last_ns, "failed", error.text)
            bus.event("replay", error.text, "bad")
            return
        warnings = join([sentence(text) for text in rebuilt.warnings], " ")
        self._publish_state(scene, bus, last_ns, "ended", warnings if rebuilt.warnings else "")
        shown = message("replay-points-shown", name=self._path.name, count=rebuilt.points)
        bus.event("replay", shown, "good")

    def _in_time(self, points: Points, first_ns: int, last_ns: int) -> Iterator[tuple[Points, int]]:
        """Points, distributed over the time of their capture, each part when it is due."""
        over_s = (last_ns - first_ns) / 1e9 / self._clock.speed if self._clock.speed else 0.0
        pieces = max(1, min(math.ceil(over_s / PIECE_S), len(points)))
        for k, piece in enumerate(np.array_split(points, pieces)):
            stamp_ns = first_ns + (last_ns - first_ns) * (k + 1) // pieces
            wait_s = (self._clock.due_ns(stamp_ns) - now_ns()) / 1e9
            if self._ended.wait(max(wait_s, 0.0)):
                raise _ReplayEndedError
            yield piece, stamp_ns

    def _publish_state(
        self, scene: Scene, bus: Bus, at_ns: int, state: ReplayPhase = "playing", text: Text = ""
    ) -> None:
        """Publishes the progress, several times per second."""
        now = time.monotonic()
        if state == "playing" and now - self._last_publish_s < PUBLISH_PERIOD_S:
            return
        self._last_publish_s = now
        length_s = None if self._length_ns is None else self._length_ns / 1e9
        bus.publish(
            TOPIC,
            ReplayState(
                recording=self._path.name,
                speed=self._clock.speed,
                played_s=max(at_ns - self._clock.first_ns, 0) / 1e9,
                length_s=length_s,
                points=self._points,
                points_shown=scene.points_shown,
                state=state,
                text=text,
            ),
        )


class _ReplayEndedError(Exception):
    """Whether to stop."""


def _pair(stamps_ns: Stamps, readings: Floats) -> Readings:
    """Each time stamp with its angles."""
    return zip(stamps_ns.tolist(), map(tuple, readings.tolist()), strict=True)


def _first(readings: Readings, count: int) -> Iterator[tuple[int, tuple[float, ...]]]:
    for reading, _ in zip(readings, range(count), strict=False):
        yield reading


def _depths(use: Calibration) -> list[float]:
    """Distance from the camera to the laser plane along the middle of the picture."""
    camera = use.camera
    v = np.linspace(0.2, 0.8, 7) * camera.height_px
    found = sensor_points(camera, use.plane, np.column_stack([np.full(7, camera.width_px / 2), v]))
    depths = apply(rigid(camera.rotation, camera.translation_mm), found)[:, 2]
    return [float(depth) for depth in depths if math.isfinite(depth)] or [100.0]

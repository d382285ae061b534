"""Starting, watching and stopping a scan."""

import threading
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.recording.reader import SCAN_NAME, SCAN_STARTED
from crenel.formats.results.scan_record import NO_PART, PartNames
from crenel.formats.settings.scan_settings import AUTOMATIC, ScanSettings
from crenel.loops import Loop
from crenel.messages.message import Text, message
from crenel.station.bus import Bus
from crenel.station.devices.awake_clock import AWAKE, SUSPENDED_S
from crenel.station.devices.rig import Rig
from crenel.station.devices.sensor_device import StationSensor
from crenel.station.scan.messages import end_reason, scan_findings, start_error
from crenel.station.scan.pipeline import ScanPipeline
from crenel.station.scan.points import NewPoints, ScanCalibration, Show
from crenel.station.scan.sources import ScanSensor, check_delay_age
from crenel.station.scan.state import NO_SCAN, ScanLoad, ScanResult, ScanState, State
from crenel.station.scan.storage import ScanFolders, make_scan_folder, recording_size
from crenel.station.view3d.scene import Scene
from crenel.station.working_distance import Distance

# The drawn arm moves ten times a second, the numbers change five times.
WATCH_S = 0.1
PUBLISH_TICKS = 2


@dataclass(frozen=True)
class _InUse:
    """The calibration of one sensor, or why it cannot be read."""

    calibration: ScanCalibration | None = None
    trouble: OperationError | None = None
    look: Callable[[], OperationError | None] = lambda: None


@dataclass
class _Running:
    """The present or last scan."""

    id: str
    name: Text
    folder: Path
    started_at: str
    started_s: float
    calibration_id: str
    pipeline: ScanPipeline
    suspended_before_s: float
    stopping: bool = False
    stopped_because: Text = ""
    """Why the station stopped it by itself; empty where it did not."""
    ended_s: float | None = None
    suspended_in_all_s: float | None = None
    """Set at its end."""

    @property
    def seconds(self) -> float:
        return (self.ended_s or time.monotonic()) - self.started_s

    @property
    def suspended_s(self) -> float:
        """For how long the program was suspended during the scan."""
        if self.suspended_in_all_s is not None:
            return self.suspended_in_all_s
        suspended_s = AWAKE.suspended_s - self.suspended_before_s
        return suspended_s if suspended_s > SUSPENDED_S else 0.0


class Scanner:
    """Runs one scan at a time; every method may be called from any thread.

    ``on_finished`` is called, before the event "scan-saved", with every scan that ended, also
    one that a full disk ended.
    """

    def __init__(self, bus: Bus, rig: Rig, scene: Scene, scans_dir: Path) -> None:
        self.on_finished: Callable[[ScanResult], None] | None = None
        self.on_begun: Callable[[str], None] = lambda scan_id: None
        """Called with every scan that has begun among the scans of the station."""
        self._bus = bus
        self._rig = rig
        self._scene = scene
        self._folders = ScanFolders(scans_dir)
        self._lock = threading.RLock()
        self._calibrations: dict[str, _InUse] = {name: _InUse() for name in rig.sensors}
        self._settings = AUTOMATIC
        self._part = NO_PART
        self._scan: _Running | None = None
        self._published: ScanState | None = None
        self._ticks = 0
        self._watcher = Loop("scan-state", self._watch, WATCH_S)
        self._watcher.start()

    def close(self) -> None:
        """Stops a running scan, and the watch over it."""
        self._watcher.stop()
        self.stop()

    def set_calibration(
        self,
        calibration: ScanCalibration | None,
        trouble: OperationError | None = None,
        look: Callable[[], OperationError | None] = lambda: None,
        sensor: str = "",
    ) -> None:
        """The calibration to scan with; a running scan keeps the one it started with.

        Args:
            sensor: of several, the name of the one that it is of.
            trouble: why the one in use cannot be read, where there is one.
            look: gives why its files cannot be read any more; None while they can.
        """
        with self._lock:
            self._calibrations[sensor] = _InUse(calibration, trouble, look)
        self.show_sensor()
        self._publish()

    @property
    def calibration_id(self) -> str:
        """The calibration that scans are listed with; empty without one."""
        with self._lock:
            first = next(iter(self._calibrations.values())).calibration
        return "" if first is None else first.id

    def show_sensor(self) -> None:
        """Draws the selected sensor as its calibration has it."""
        with self._lock:
            calibration = self._calibrations[self._rig.selected].calibration
        if calibration is None:
            self._scene.clear_sensor()
        else:
            self._scene.set_arm_model(calibration.arm)
            self._scene.set_sensor(
                calibration.T_flange_sensor,
                calibration.camera,
                calibration.plane,
                calibration.depth_range_mm,
            )

    @property
    def trouble(self) -> OperationError | None:
        """Why the calibration in use cannot be read, or not any more."""
        with self._lock:
            used = tuple(self._calibrations.values())
        return next((why for one in used if (why := one.trouble or one.look())), None)

    def distance(self) -> Distance | None:
        """The distance of the stripe from the camera, against the calibrated range; None without a
        scan."""
        with self._lock:
            scan = self._scan
        if scan is None or scan.ended_s is not None:
            return None
        return scan.pipeline.distance

    def set_settings(self, settings: ScanSettings) -> None:
        """What the operator has set; a running scan goes on by it, but for the delay."""
        with self._lock:
            self._settings = settings
            if self._scan is not None and self._scan.ended_s is None:
                self._scan.pipeline.apply(settings)
                with suppress(OperationError):  # a lost sensor follows when it is back
                    self._choose_delivery(settings)

    def set_part(self, part: PartNames) -> None:
        """The part that is scanned next, and the one that a running scan is of."""
        with self._lock:
            self._part = part
            if self._scan is not None and self._scan.ended_s is None:
                self._scan.pipeline.describe(part.metadata())

    def load(self) -> ScanLoad | None:
        """What the running scan asks of the machine; None while none runs."""
        with self._lock:
            scan = self._scan
            if scan is None or not self._is_running():
                return None
        return ScanLoad(scan.pipeline.backlog, scan.pipeline.bytes_written, scan.seconds)

    def recording(self) -> Path | None:
        """The folder of the scan that runs, or is being written."""
        with self._lock:
            return self._scan.folder if self._scan is not None and self._is_running() else None

    def why_not(self) -> OperationError | None:
        """Why a scan cannot start now; None when it can."""
        with self._lock:
            if self._is_running():
                return OperationError(
                    "busy", message("scan-running-already"), remedy=message("stop-before-next")
                )
            found = {name: one.calibration for name, one in self._calibrations.items()}
            return self.trouble or start_error(found, self._rig)

    def start(self, name: Text, into: Path | None = None, watch: Show | None = None) -> str:
        """Starts a scan with all sensors and switches their lasers on; its id.

        Args:
            into: a new folder of the caller's to record in, not among the scans; of several
                sensors, the selected one alone is then recorded, as the only one.
            watch: is given all points as they come, on the thread that makes them, which must not
                wait for it.

        Raises:
            OperationError: no valid calibration for these devices, a device lost, another
                scan running, no space on the disk, or a drifting delay that is no longer known.
        """
        with self._lock:
            refusal = self.why_not() or self._folders.start_space_error()
            if refusal is not None:
                raise refusal
            sensors = self._scan_sensors(into is not None)
            for one in sensors:
                check_delay_age(self._settings, one)
            started = datetime.now(UTC)
            folder = self._folders.new(started) if into is None else make_scan_folder(into)
            scan_id = folder.name if into is None else f"{into.parent.name}-{into.name}"
            if isinstance(name, str):
                name = name.strip()
            name = name or message("scan-started-at", started=f"{started:%Y-%m-%d %H:%M}")
            started_at = started.isoformat(timespec="seconds")
            self._scene.begin(scan_id)
            try:
                self._prepare_sensors([one.device for one in sensors])
                pipeline = ScanPipeline(
                    self._rig.arm,
                    sensors,
                    folder,
                    self._show_to(watch),
                    self._settings,
                    {SCAN_NAME: str(name), SCAN_STARTED: started_at, **self._part.metadata()},
                )
            except OperationError:
                self._end_delivery()
                raise
            self._scan = _Running(
                scan_id,
                name,
                folder,
                started_at,
                time.monotonic(),
                sensors[0].calibration.id,
                pipeline,
                AWAKE.suspended_s,
            )
        self._publish()
        if into is None:
            self.on_begun(scan_id)
        return scan_id

    def stop(self, because: Text = "") -> ScanResult | None:
        """Laser off, what was taken finished and saved; None when no scan was running.

        Args:
            because: why the station stops it by itself.
        """
        with self._lock:
            scan = self._scan
            if scan is None or not self._is_running() or scan.stopping:
                return None
            scan.stopping, scan.stopped_because = True, because
            scan.ended_s = time.monotonic()
            scan.suspended_in_all_s = scan.suspended_s
        self._rig.arm.note_scan_end()
        self._end_delivery()
        self._publish()
        try:
            scan.pipeline.stop()
            self._scene.finish_scan(scan.id)
            result = self._result(scan)
            if self.on_finished is not None:
                self.on_finished(result)
        finally:
            with self._lock:
                scan.stopping = False
        self._tell_end(result, scan.pipeline.trouble)
        self._publish()
        return result

    def _tell_end(self, result: ScanResult, trouble: OperationError | None) -> None:
        """Says how a scan ended, by an event."""
        name, count = result.name, result.points
        if trouble is not None:
            self._bus.event("scan-failed", trouble.text, "bad")
        elif result.left_out.is_too_much:
            missing = result.left_out.text
            text = message("scan-saved-incomplete", name=name, count=count, missing=missing)
            self._bus.event("scan-saved", text, "bad")
        else:
            self._bus.event("scan-saved", message("points-saved", name=name, count=count), "good")

    def forget(self, scan_id: str) -> None:
        """The last scan was deleted: its numbers are shown no more."""
        with self._lock:
            if self._scan is not None and self._scan.id == scan_id and not self._is_running():
                self._scan = None
        self._publish()

    def state(self) -> ScanState:
        """The scan as of now."""
        refusal = self.why_not()
        with self._lock:
            scan = self._scan
            running = self._is_running()
        why_not: Text = "" if refusal is None or running else refusal.text
        state: State = "blocked" if why_not else "idle"
        if scan is None:
            return replace(NO_SCAN, state=state, why_not=why_not)
        if running:
            state = "stopping" if scan.stopping else "running"
        counts, pace = scan.pipeline.counts, scan.pipeline.speed
        now = pace.now if running else None
        return ScanState(
            state=state,
            why_not=why_not,
            scan_id=scan.id,
            points=counts.points,
            points_shown=self._scene.points_shown,
            rate_points_s=scan.pipeline.rate_points_s if running else 0.0,
            frames=counts.frames,
            lost_frames=scan.pipeline.lost_frames,
            frames_without_joints=counts.frames_without_joints,
            frames_still=scan.pipeline.frames_still,
            incomplete=counts.left_out.is_too_much,
            seconds=scan.seconds,
            blur_mm=now.blur_mm if now else None,
            step_mm=now.step_mm if now else None,
            blur_limit_mm=now.limit_mm if now else None,
            frames_too_fast=pace.frames_too_fast,
            pictures=scan.pipeline.pictures[0],
            findings=scan_findings(
                scan.pipeline, self._rig, running, scan.suspended_s, scan.stopped_because
            ),
        )

    def _show_to(self, watch: Show | None) -> Show:
        """To the display, and to whoever watches."""

        def show(new: NewPoints) -> None:
            self._scene.add_points(new.records, new.views, new.too_fast)
            if watch is not None:
                watch(new)

        return show

    def _choose_delivery(self, settings: ScanSettings) -> None:
        """A sensor that can deliver lines does, unless its pictures are to be recorded."""
        for sensor in self._rig.sensors.values():
            sensor.want_lines(not settings.record_pictures)

    def _prepare_sensors(self, sensors: Sequence[StationSensor]) -> None:
        """Lasers on, exposures and delivery as set."""
        for sensor in sensors:
            info = sensor.info
            if info is not None and info.has_laser_switch:
                sensor.set_laser(True)
        for name, sensor in self._rig.sensors.items():
            exposure_us = self._settings.exposure_of_us(name)
            if exposure_us is not None and sensor in sensors:
                sensor.set_exposure_us(exposure_us)
        self._choose_delivery(self._settings)

    def _scan_sensors(self, selected_alone: bool) -> list[ScanSensor]:
        """The sensors with their calibrations; each has one when a scan can start."""
        if selected_alone:
            calibration = self._calibrations[self._rig.selected].calibration
            assert calibration is not None
            return [ScanSensor("", self._rig.sensor, calibration)]
        return [
            ScanSensor(name, self._rig.sensors[name], one.calibration)
            for name, one in self._calibrations.items()
            if one.calibration is not None
        ]

    def _end_delivery(self) -> None:
        """Lasers off, and pictures again."""
        self._rig.lasers_off()
        for sensor in self._rig.sensors.values():
            with suppress(OperationError):  # a lost sensor begins with pictures when it is back
                sensor.want_lines(False)

    def _is_running(self) -> bool:
        scan = self._scan
        return scan is not None and (scan.ended_s is None or scan.stopping)

    def _result(self, scan: _Running) -> ScanResult:
        counts = scan.pipeline.counts
        return ScanResult(
            scan.id,
            scan.name,
            scan.folder,
            scan.started_at,
            counts.points,
            counts.frames,
            scan.seconds,
            scan.calibration_id,
            scan.pipeline.lost_frames,
            scan.stopped_because or end_reason(scan.pipeline.trouble),
            recording_size(scan.folder),
            scan.suspended_s,
            counts.left_out,
            self._part,
            scan.pipeline.speed.frames_too_fast,
        )

    def _watch(self) -> None:
        """Moves the drawn arm, publishes the state, and stops a scan that the disk ends."""
        self._ticks += 1
        if self._ticks % PUBLISH_TICKS == 0:
            self._stop_when_full()
            self._publish()
        sample = self._rig.arm.latest()
        if sample is not None:
            self._scene.set_arm(sample.reading)
        distance = self.distance()
        in_range = None if distance is None else distance.state == "in"
        self._scene.set_laser(self._rig.sensor.is_taken_as_lit, in_range)

    def _stop_when_full(self) -> None:
        scan = self._scan
        if scan is not None and scan.ended_s is None:
            scan.pipeline.failure = scan.pipeline.failure or self._folders.running_space_error()
            if scan.pipeline.trouble is not None:
                self.stop()

    def _publish(self) -> None:
        """Publishes how the scan is, if that has changed."""
        state = self.state()
        if state != self._published:
            self._bus.publish("scan", state)
            self._published = state

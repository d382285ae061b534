"""A record in the 3D view: opened alone, played again in time, compared with another."""

import threading
import time
from collections.abc import Callable
from dataclasses import replace

from crenel.errors import OperationError
from crenel.formats.clouds.pieces import StoredCloud
from crenel.formats.results.scan_record import CLOUD
from crenel.loop_states import waiting
from crenel.loops import Loop
from crenel.messages.message import message
from crenel.station.bus import Bus
from crenel.station.jobs import Job, Jobs, Progress
from crenel.station.view3d.cloud_colouring import ReferenceShape
from crenel.station.view3d.scene import Scene
from crenel.station.view3d.view_controller import StoredScan, ViewController
from crenel.store.scans import ScanRecord
from crenel.wire.library import OpenedRecord, RecordComparison, ReplayTime
from crenel.workflows.clouds.compare_clouds import (
    CloudDeviation,
    LocalPlanes,
    read_places,
)

TURN_S = 0.15
MOST_AT_ONCE = 200_000
"""Points given to the view in one turn."""
MOST_REFERENCE, MOST_COMPARED = 1_000_000, 200_000
"""How many points of larger clouds are compared, evenly from all."""


class _Player:
    """Gives the points of a cloud to the view in the order in which they were taken."""

    def __init__(self, scan: ScanRecord, scene: Scene) -> None:
        self._scan, self._scene = scan, scene
        self._cloud = StoredCloud(scan.folder / CLOUD)
        self._s_a_frame = scan.seconds / max(scan.frames, 1)
        self._given = 0
        self.at_s = 0.0

    def give_until(self, at_s: float) -> None:
        """Shows what was taken until then, some of it at a time if that is much."""
        self.at_s = min(at_s, self._scan.seconds)
        wanted = (
            self._cloud.count
            if self.at_s >= self._scan.seconds
            else self._cloud.find_frame(self.at_s / max(self._s_a_frame, 1e-9))
        )
        if wanted < self._given:
            self._scene.empty_scan(self._scan.id)
            self._given = 0
        count = min(wanted - self._given, MOST_AT_ONCE)
        if count > 0:
            points = self._cloud.read((self._given, count))
            self._scene.add_to_scan(self._scan.id, points, self._s_a_frame * points["frame"])
            self._given += count
            if self._given == self._cloud.count:
                self._scene.finish_scan(self._scan.id)


def as_stored_scan(scan: ScanRecord) -> StoredScan:
    """A scan as the view shows it."""
    return StoredScan(scan.id, scan.name, scan.folder, scan.frames, scan.seconds)


class RecordView:
    """Every method may be called from any thread.

    Args:
        is_recording: whether a scan runs, which the view then belongs to.
        changed: called when what is opened has changed.
    """

    def __init__(
        self,
        bus: Bus,
        scene: Scene,
        view: ViewController,
        jobs: Jobs,
        is_recording: Callable[[], bool],
        changed: Callable[[], None],
    ) -> None:
        self._bus, self._scene, self._view, self._jobs = bus, scene, view, jobs
        self._is_recording, self._changed = is_recording, changed
        self._lock = threading.RLock()
        self._scan: ScanRecord | None = None
        self._opened: OpenedRecord | None = None
        self._player: _Player | None = None
        self._begun = scene.begun
        self._turned_s = time.monotonic()
        self._wanted = threading.Event()
        """Set while a record is opened."""
        self._loop = Loop("record-view", self._turn, TURN_S)
        self._loop.start()

    def close_loop(self) -> None:
        """Ends all work."""
        self._loop.stop(wake=self._wanted.set)

    @property
    def opened(self) -> OpenedRecord | None:
        with self._lock:
            return self._opened

    def open(self, scan: ScanRecord) -> None:
        """Shows a record alone.

        Raises:
            OperationError: a scan runs, or the record's cloud is not there.
        """
        if self._is_recording():
            raise OperationError(
                "busy",
                message("record-cannot-be-opened"),
                message("scan-running-already"),
                message("stop-scan-first"),
            )
        stored = as_stored_scan(scan)
        with self._lock:
            self._forget_comparison()
            others = [name for name in self._scene.scans if name != scan.id]
            self._view.show(stored)  # refused before anything else is hidden
            for name in others:
                self._view.hide(name)
            if self._player is not None and self._scan is not None and self._scan.id == scan.id:
                self._view.hide(scan.id)
                self._view.show(stored)
            self._player = None
            self._scan, self._begun = scan, self._scene.begun
            self._opened = OpenedRecord(scan.id, scan.name, scan.seconds, None, None, "")
            self._wanted.set()
        self._changed()

    def close(self, then: ScanRecord | None = None) -> None:
        """Back to live: hides the record and shows the last scan."""
        with self._lock:
            scan = self._scan
            self._forget()
            if scan is not None:
                self._view.hide(scan.id)
            if then is not None and (then.folder / CLOUD).is_file():
                self._view.show(as_stored_scan(then))
        self._changed()

    def play(self, at_s: float | None, playing: bool, speed: float) -> None:
        """Plays the opened record again.

        Args:
            at_s: from this time after its beginning; None: on from where it is, or from the
                beginning where it had come to its end.

        Raises:
            OperationError: none is opened, or its cloud cannot be read.
        """
        with self._lock:
            scan, opened = self._need_open()
            if self._player is None:
                self._player = _Player(scan, self._scene)
                self._view.empty(scan.id)
            player = self._player
            if at_s is None:
                at_s = 0.0 if player.at_s >= scan.seconds else player.at_s
            player.give_until(at_s)
            self._turned_s = time.monotonic()
            self._opened = replace(opened, replay=ReplayTime(player.at_s, playing, speed))
        self._changed()

    def compare(self, reference: ScanRecord, same_calibration: bool) -> None:
        """Starts to compare the opened record with another one, which it is then coloured by.

        Raises:
            OperationError: none is opened, or another job runs.
        """
        with self._lock:
            scan, opened = self._need_open()
            title = message("comparing-scans", name=scan.name, reference=reference.name)

            def work(progress: Progress) -> tuple[LocalPlanes, CloudDeviation]:
                progress(title, 0.0)
                planes = LocalPlanes(read_places(reference.folder / CLOUD, MOST_REFERENCE))
                progress(title, 0.6)
                distances_mm = planes.distances(read_places(scan.folder / CLOUD, MOST_COMPARED))
                return planes, planes.summarise(distances_mm)

            def ended(job: Job[tuple[LocalPlanes, CloudDeviation]]) -> None:
                self._show_comparison(scan, reference, same_calibration, job)

            self._jobs.start(title, work, ended)
            self._opened = replace(opened, busy=title)
        self._changed()

    def end_comparison(self) -> None:
        """Colours the record by height again."""
        with self._lock:
            self._forget_comparison()
        self._changed()

    def _show_comparison(
        self,
        scan: ScanRecord,
        reference: ScanRecord,
        same_calibration: bool,
        job: Job[tuple[LocalPlanes, CloudDeviation]],
    ) -> None:
        with self._lock:
            opened = self._opened
            if opened is None or opened.id != scan.id:
                return
            opened = replace(opened, busy="")
            if job.result is not None:
                planes, found = job.result
                opened = replace(
                    opened,
                    comparison=RecordComparison(
                        reference.id, reference.name, same_calibration, found
                    ),
                )
                rms_mm = found.rms_um / 1e3
                self._view.compare_with(ReferenceShape(planes.distances, rms_mm))
            self._opened = opened
        if job.refusal is not None:
            self._bus.event("refused", job.refusal.text, "attention")
        self._changed()

    def _need_open(self) -> tuple[ScanRecord, OpenedRecord]:
        if self._scan is None or self._opened is None:
            raise OperationError(
                "no-record-open", message("no-record-is-open"), remedy=message("open-one-first")
            )
        return self._scan, self._opened

    def _forget_comparison(self) -> None:
        if self._opened is not None and self._opened.comparison is not None:
            self._view.compare_with(None)
            self._opened = replace(self._opened, comparison=None)

    def _forget(self) -> None:
        self._forget_comparison()
        self._scan = self._opened = self._player = None
        self._wanted.clear()

    def _turn(self) -> None:
        """Plays on; a scan that begins, or whoever hides the record, closes it."""
        with waiting():
            self._wanted.wait()
        with self._lock:
            if self._scan is None or self._opened is None:
                return
            before, now_s = self._opened, time.monotonic()
            passed_s, self._turned_s = now_s - self._turned_s, now_s
            if self._begun != self._scene.begun or self._scan.id not in self._scene.scans:
                self._forget()
            elif self._player is not None and (replay := before.replay) is not None:
                at_s = self._player.at_s + (passed_s * replay.speed if replay.playing else 0.0)
                self._player.give_until(at_s)
                playing = replay.playing and self._player.at_s < self._scan.seconds
                new = ReplayTime(self._player.at_s, playing, replay.speed)
                self._opened = replace(before, replay=new)
            changed = self._opened != before
        if changed:
            self._changed()

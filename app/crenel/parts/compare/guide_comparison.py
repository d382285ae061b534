"""The comparison of finished scans with parts: started, cancelled, shown, kept with the scan."""

import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from crenel.errors import OperationError
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.results.scan_record import CLOUD
from crenel.formats.session.calibration_session import ARM
from crenel.messages.message import Text, message
from crenel.parts.compare.document_comparison import (
    COMPARISON,
    ComparisonFile,
    read_comparison,
    read_document,
)
from crenel.parts.compare.guide_parts import KeptParts
from crenel.parts.compare.guide_view import (
    CompareState,
    MapLegend,
    MapMode,
    PlaceOnMap,
    Refused,
    RunningComparison,
    ShownMap,
    view_of,
)
from crenel.station.bus import Bus
from crenel.station.jobs import Job, Jobs, Progress
from crenel.station.scan.storage import RECORDING
from crenel.station.view3d.scene import Scene
from crenel.station.view3d.selection import ViewCamera
from crenel.store.scans import ScanRecord
from crenel.store.store import Store

if TYPE_CHECKING:
    from crenel.parts.compare.evaluate_comparison import ComparisonOrder
    from crenel.parts.compare.guide_picture import MapPicture

TOPIC = "compare"


@dataclass(frozen=True)
class ComparisonWish:
    """With what a scan is to be compared, and how."""

    part: str
    """Its id."""
    unit: str
    """Of the part; empty: as its file states it."""
    body: int | None
    lower_mm: float
    upper_mm: float
    locked: tuple[str, ...]


class Comparisons:
    """Every method may be called from any thread."""

    def __init__(
        self,
        bus: Bus,
        store: Store,
        scene: Scene,
        jobs: Jobs,
        show: Callable[[ScanRecord], object],
    ) -> None:
        self._bus, self._store, self._scene, self._jobs = bus, store, scene, jobs
        self._show_scan = show
        self.parts = KeptParts(store.folder, self.publish)
        self._lock = threading.RLock()
        self._running: RunningComparison | None = None
        self._cancelled = threading.Event()
        self._picture: MapPicture | None = None
        self._legend: MapLegend | None = None
        self._made = 0

    def close(self) -> None:
        """Ends what is read or computed."""
        self.parts.close()
        self._cancelled.set()

    def publish(self) -> None:
        """Sends browsers the present state."""
        self._bus.publish(TOPIC, self.state())

    def state(self) -> CompareState:
        """Parts, what is under way, and the map in the view."""
        with self._lock:
            picture, legend, shown = self._picture, self._legend, None
            if picture is not None and legend is not None:
                shown = ShownMap(picture.made.document, legend)
            return CompareState(
                tuple(view_of(part_id, part) for part_id, part in self.parts.all().items()),
                self.parts.reading,
                self.parts.refused,
                self._running,
                shown,
                self._made,
            )

    def start(self, scan: ScanRecord, wish: ComparisonWish) -> None:
        """Starts to compare a finished scan with a part.

        Raises:
            OperationError: something is missing for it, or another job runs.
        """
        order = self._order(scan, wish)
        part = self.parts.get(wish.part)
        title = message("compare-title", name=scan.name, part=part.name)
        cancelled = threading.Event()

        def work(progress: Progress) -> None:
            self._compute(order, cancelled, progress)
            self.show(scan, "deviation" if self._has_scatter_only(scan) else "significance")

        def ended(job: Job[None]) -> None:
            self._note_end(part.name, job, cancelled)

        with self._lock:
            self._jobs.start(title, work, ended)
            self._cancelled, self.parts.refused = cancelled, None
            self._running = RunningComparison(scan.id, part.name, title, 0.0, False)
        update = {
            "unit": wish.unit,
            "body": wish.body,
            "locked": wish.locked,
            "lower_mm": wish.lower_mm,
            "upper_mm": wish.upper_mm,
        }
        self.parts.save(wish.part, part.model_copy(update=update))

    def cancel(self) -> None:
        """Ends the comparison that is computed; does nothing if there is none."""
        with self._lock:
            self._cancelled.set()
            if self._running is not None:
                self._running = replace(self._running, is_cancelled=True)
        self.publish()

    def show(self, scan: ScanRecord, mode: MapMode) -> None:
        """Shows the map of a scan in place of the clouds.

        Raises:
            OperationError: there is none, or it cannot be read; uncertainties of scatter alone.
        """
        # imported when the first map is shown: most stations compare nothing
        from crenel.parts.compare.guide_picture import MapPicture

        with self._lock:
            picture = self._picture
            if picture is None or picture.made.document != read_result(scan):
                picture = MapPicture(read_comparison(_file_of(scan)))
            if mode == "uncertainty" and picture.made.document.uncertainty == "scatter":
                raise OperationError("scatter-only", message("compare-uncertainty-unknown"))
            surface, legend = picture.paint(mode)
            self._show_scan(scan)
            if self._scene.show_surface(scan.id, picture.pose, surface):
                self._picture, self._legend = picture, legend
        self.publish()

    def hide(self) -> None:
        """Shows the clouds again."""
        with self._lock:
            self._scene.clear_surface()
            self._picture, self._legend = None, None
        self.publish()

    def remove(self, scan: ScanRecord) -> None:
        """Removes what was compared with a scan; does nothing if nothing was."""
        with self._lock:
            if self._scene.surface_of == scan.id:
                self.hide()
            with convert_io_errors(_file_of(scan)):
                _file_of(scan).unlink(missing_ok=True)
            self._made += 1
        self.publish()

    def find(self, scan: ScanRecord, camera: ViewCamera, x: float, y: float) -> PlaceOnMap:
        """What the map of a scan, which is in the view, has at a place of the picture."""
        with self._lock:
            picture = self._picture
            if picture is None or self._scene.surface_of != scan.id:
                raise OperationError("no-map", message("compare-map-not-shown"))
        return picture.find(camera, x, y)

    def scan_size_mm(self, scan: ScanRecord) -> Sequence[float] | None:
        """Extents of a displayed scan along its own main axes, the largest first; None where there
        are no points of it in the view."""
        import numpy as np

        try:
            points, _, _ = self._scene.visible_points(scan.id)
        except KeyError:
            return None
        if len(points) < 3:
            return None
        axes = np.linalg.svd(np.cov(points.T))[0]
        low, high = np.quantile(points @ axes, [0.005, 0.995], axis=0)
        return sorted((high - low).tolist(), reverse=True)

    def _order(self, scan: ScanRecord, wish: ComparisonWish) -> "ComparisonOrder":
        from crenel.parts.compare.evaluate_comparison import ComparisonOrder
        from crenel.parts.deviation.maths_decisions import DeviationLimits

        part = self.parts.get(wish.part)
        if not part.has_unit and not wish.unit:
            raise OperationError(
                "part-without-unit",
                message("compare-unit-is-missing", name=part.name),
                "",
                message("compare-state-unit"),
            )
        if not wish.lower_mm < wish.upper_mm:
            raise OperationError(
                "no-range",
                message("compare-lower-not-below-upper"),
                remedy=message("compare-change-limit"),
            )
        record = self._store.calibrations.get(scan.calibration_id)
        recording, cloud = scan.folder / RECORDING, scan.folder / CLOUD
        source = recording if recording.is_file() and not scan.sources else cloud
        if not source.is_file():
            raise OperationError(
                "scan-gone",
                message("compare-scan-not-here", name=scan.name),
                "",
                message("compare-fetch-scan"),
            )
        if source == recording and record is None:
            raise OperationError(
                "no-calibration",
                message("calibration-no-longer-here", name=scan.name),
                "",
                message("compare-restore-calibration"),
            )
        return ComparisonOrder(
            data=self._store.folder,
            scan=scan.id,
            scan_name=scan.name,
            source=source,
            calibration=None if record is None else record.file,
            calibration_id=scan.calibration_id,
            arm=None if record is None else record.file.parent / ARM,
            part=self.parts.file_of(wish.part),
            part_name=part.name,
            unit=wish.unit or None,
            body=wish.body,
            limits=DeviationLimits(wish.lower_mm, wish.upper_mm),
            locked=wish.locked,
            output=_file_of(scan),
        )

    def _compute(
        self, order: "ComparisonOrder", cancelled: threading.Event, progress: Progress
    ) -> None:
        """On the job's thread."""
        from crenel.parts.compare.evaluate_comparison import compare_scan
        from crenel.parts.compare.evaluate_process import CancelledError, run_in_process

        def report(share: float, text: Text) -> None:
            progress(text, share)
            with self._lock:
                if self._running is None:
                    return
                shown = replace(self._running, share=round(share, 2), text=text)
                if shown == self._running:
                    return
                self._running = shown
            self.publish()

        try:
            run_in_process(compare_scan, order, report, cancelled.is_set)
        except CancelledError:
            raise OperationError("cancelled", message("compare-was-cancelled")) from None

    def _note_end(self, part: str, job: Job[None], cancelled: threading.Event) -> None:
        """On the event loop."""
        with self._lock:
            self._running = None
            self._made += 1
            if job.refusal is not None and not cancelled.is_set():
                self.parts.refused = Refused(part, job.refusal.text)
        if job.refusal is None:
            self._bus.event("compared", message("compare-done", part=part), "good")
        elif cancelled.is_set():
            self._bus.event("compared", message("compare-was-cancelled"))
        else:
            self._bus.event("refused", job.refusal.text, "bad")
        self.publish()

    def _has_scatter_only(self, scan: ScanRecord) -> bool:
        found = read_result(scan)
        return found is not None and found.uncertainty == "scatter"


def read_result(scan: ScanRecord) -> ComparisonFile | None:
    """What was found of a scan; None: it was not compared.

    Raises:
        OperationError: its file cannot be read.
    """
    path = _file_of(scan)
    return read_document(path) if path.is_file() else None


def _file_of(scan: ScanRecord) -> Path:
    return scan.folder / COMPARISON

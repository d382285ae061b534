"""Control of the 3D view, apart from the running scan: other scans, colours, fits."""

import logging
import math
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.clouds.cuts import read_cuts
from crenel.formats.clouds.pieces import read_cloud_pieces
from crenel.formats.results.scan_record import CLOUD
from crenel.loops import Loop
from crenel.messages.message import Text, message
from crenel.station.bus import Bus
from crenel.station.view3d.cloud.view_cuts import ViewCuts
from crenel.station.view3d.cloud_colouring import Legend, Measure, ReferenceShape
from crenel.station.view3d.cloud_set import SceneContent
from crenel.station.view3d.elements.element_list import ElementList
from crenel.station.view3d.elements.element_views import (
    AskedElement,
    ElementRelation,
    FittedShape,
)
from crenel.station.view3d.elements.picked_scans import (
    ScanOrigin,
    SourceOf,
    visible_scans,
)
from crenel.station.view3d.scene import Scene
from crenel.station.view3d.selection import Rectangle, frustum_planes
from crenel.station.view3d.viewpoints import PageCameras
from crenel.station.working_distance import Distance

log = logging.getLogger(__name__)

PUBLISH_S = 0.2


@dataclass(frozen=True)
class StoredScan:
    """A finished scan, with the data needed to show it."""

    id: str
    name: Text
    folder: Path
    frames: int
    seconds: float


@dataclass(frozen=True)
class VisibleScan:
    """A scan in the view, and how much of it has been read, 0 to 1."""

    id: str
    points_shown: int
    loaded: float


@dataclass(frozen=True)
class ViewState:
    """The 3D view as the browser's panels show it."""

    scans: tuple[VisibleScan, ...]
    measure: Measure
    legend: Legend | None
    fits: tuple[FittedShape, ...]
    relations: tuple[ElementRelation, ...]
    """Dimensions between fitted shapes."""
    can_undo: bool
    """Whether a change of these can be taken back."""
    busy: Text
    """The shape that is being fitted; empty if there is none."""
    distance: Distance | None
    """The distance of the stripe, if there is one."""
    records: int
    """Increases when scans were renamed or deleted."""
    content: SceneContent
    cuts: int
    """How many times something was cut away of the scans in the view."""
    surface_of: str
    """The scan of which a map is shown in place of the clouds; empty if there is none."""


@dataclass(slots=True)
class _Loading:
    """A scan whose cloud is being read."""

    done: float = 0.0
    """0 to 1."""


_WHOLE = _Loading(1.0)


class ViewController:
    """Changes the view, for all viewers; methods may be called from any thread.

    Longer work runs in separate threads: reading clouds, and fitting.
    """

    def __init__(
        self,
        bus: Bus,
        scene: Scene,
        scans_dir: Path,
        distance: Callable[[], Distance | None],
        source_of: SourceOf = lambda scan_id: ScanOrigin(),
    ) -> None:
        """``source_of``: by which calibrations a scan was made."""
        self._bus, self._scene, self._scans_dir = bus, scene, scans_dir
        self._distance = distance
        self.pages = PageCameras(scene.content_sphere_m)
        self._lock = threading.RLock()
        self._loading: dict[str, _Loading] = {}
        self._elements = ElementList(
            bus,
            scene,
            self._lock,
            lambda: visible_scans(scene, scans_dir, source_of),
            self._note_elements,
        )
        self._reference: ReferenceShape | None = None
        self._begun = scene.begun
        self._records = 0
        self._cuts = ViewCuts(scene, scans_dir)
        self._published: ViewState | None = None
        self._closing = threading.Event()
        self._loader = ThreadPoolExecutor(1, "view-load")
        self._publisher = Loop("view", self._publish, PUBLISH_S)
        self._publisher.start()

    def close(self) -> None:
        """Ends all running work."""
        self._closing.set()
        self._publisher.stop()
        self._loader.shutdown(cancel_futures=True)
        self._elements.close()

    def state(self) -> ViewState:
        """The current state of the view."""
        with self._lock:
            self._drop_old_fits()
            scans, elements = self._scene.scans, self._elements.view
            return ViewState(
                scans=tuple(
                    VisibleScan(name, shown, round(self._loading.get(name, _WHOLE).done, 2))
                    for name, shown in scans.items()
                    if name
                ),
                measure=self._scene.measure,
                legend=self._scene.legend,
                fits=elements.fits,
                relations=elements.relations,
                can_undo=elements.can_undo,
                busy=self._elements.busy,
                distance=self._distance(),
                records=self._records,
                content=self._scene.content,
                cuts=self._cuts.count,
                surface_of=self._scene.surface_of,
            )

    def note_records(self) -> None:
        """Scans were renamed or deleted: browsers reload their lists."""
        with self._lock:
            self._records += 1
            self._publish()

    def show(self, scan: StoredScan) -> None:
        """Adds a scan to the view.

        Raises:
            OperationError: its cloud is no longer in the data folder, or its cuts are damaged.
        """
        file = scan.folder / CLOUD
        if not file.is_file():
            raise OperationError(
                "cloud-gone",
                message("cloud-not-in-data-folder", name=scan.name),
                remedy=message("rebuild-recording-crenel-reconstruct"),
            )
        with self._lock:
            self._drop_old_fits()
            if scan.id in self._scene.scans:
                return
            self._scene.open_scan(scan.id, read_cuts(scan.folder))
            loading = self._loading[scan.id] = _Loading()
            self._publish()
        self._loader.submit(self._load, scan, loading)

    def empty(self, scan_id: str) -> None:
        """Takes the points of a scan out of the view, for someone who gives them again; its cuts
        stay."""
        with self._lock:
            self._loading.pop(scan_id, None)
            self._scene.empty_scan(scan_id)
            self._publish()

    def hide(self, scan_id: str) -> None:
        """Removes a scan from the view; its files stay."""
        with self._lock:
            self._loading.pop(scan_id, None)
            self._scene.close_scan(scan_id)
            self._publish()

    def colour_by(self, measure: Measure, limits: tuple[float, float] | None) -> None:
        """Colours everything by this quantity, with limits in the unit of the legend, or automatic
        ones.

        Raises:
            OperationError: the limits are not a range, or there is no shape for deviations.
        """
        if limits is not None and not (
            all(math.isfinite(limit) for limit in limits) and limits[0] < limits[1]
        ):
            raise OperationError(
                "no-range",
                message("lower-limit-not-below-upper"),
                remedy=message("change-one-them"),
            )
        with self._lock:
            self._drop_old_fits()
            aims = self._reference or self._elements.reference
            if measure == "deviation" and aims is None:
                raise OperationError(
                    "no-fit",
                    message("there-no-fitted-shape-yet"),
                    message("deviations-distances-one"),
                    message("fit-shape-first"),
                )
            self._scene.colour_by(measure, limits)
            self._publish()

    def fit(self, key: str, rectangle: Rectangle, asked: AskedElement) -> None:
        """Fits an element to what the browser with this key shows in a rectangle.

        Returns at once; the element appears in ``state``, or an event says why it does not.

        Raises:
            OperationError: the browser is unknown, or another fit is running.
        """
        with self._lock:
            self._drop_old_fits()
            self._elements.fit(self.pages.camera_of(key), rectangle, asked)

    def change_element(self, number: int, asked: AskedElement) -> None:
        """Fits another shape to the pick of an element, like ``fit``."""
        with self._lock:
            self._drop_old_fits()
            self._elements.change_kind(number, asked)

    def relate(self, first: int, second: int) -> None:
        """Measures between two elements, like ``fit``."""
        with self._lock:
            self._drop_old_fits()
            self._elements.relate(first, second)

    def remove_element(self, number: int) -> None:
        """Removes an element with its dimensions, or a dimension; deviations are then from the last
        remaining element."""
        with self._lock:
            self._elements.remove(number)

    def undo_element(self) -> None:
        """Takes back the last change of elements and dimensions."""
        with self._lock:
            self._drop_old_fits()
            self._elements.undo()

    def cut(self, key: str, rectangle: Rectangle, outside: bool) -> None:
        """Cuts away, of the scans in the view, what the browser with this key shows in a rectangle
        at any distance, or all but that. Recordings and ``cloud.ply`` stay whole.

        Raises:
            OperationError: the browser is unknown, there are no points, or no file can be written.
        """
        planes = frustum_planes(self.pages.camera_of(key), rectangle)
        with self._lock:
            self._cuts.add(planes, outside)
            self._publish()

    def undo_cut(self) -> None:
        """Shows again what was cut away last; does nothing if there is nothing.

        Raises:
            OperationError: no file can be written.
        """
        with self._lock:
            self._cuts.undo()
            self._publish()

    def mark_weak(self, on: bool) -> None:
        """Shows weak points in colours of their own, or like the others."""
        self._scene.mark_weak(on)
        self._publish()

    def show_arm(self, on: bool) -> None:
        """Shows the arm with its sensor, or hides it."""
        self._scene.show_arm(on)
        self._publish()

    def compare_with(self, reference: ReferenceShape | None) -> None:
        """Colours everything by its deviations from this; None: by height, as before."""
        with self._lock:
            self._drop_old_fits()
            self._reference = reference
            self._aim()
            self._scene.colour_by("height" if reference is None else "deviation", None)
            self._publish()

    def _load(self, scan: StoredScan, loading: _Loading) -> None:
        """Runs in the loader's thread, until the scan is hidden or emptied."""

        def goes_on() -> bool:
            return self._loading.get(scan.id) is loading and not self._closing.is_set()

        s_a_frame = scan.seconds / max(scan.frames, 1)
        try:
            for points, done in read_cloud_pieces(scan.folder / CLOUD):
                with self._lock:
                    taken_s = s_a_frame * points["frame"]
                    if not (goes_on() and self._scene.add_to_scan(scan.id, points, taken_s)):
                        return
                    loading.done = done
            with self._lock:
                if goes_on():
                    self._scene.finish_scan(scan.id)
        except OperationError as refusal:
            self.hide(scan.id)
            self._bus.event(
                "refused", message("cannot-shown", name=scan.name, error=refusal.text), "bad"
            )
        except Exception:
            log.exception("a cloud could not be displayed")
            self.hide(scan.id)
            self._bus.event("refused", message("cannot-be-displayed", name=scan.name), "bad")
        finally:
            with self._lock:
                if goes_on():
                    del self._loading[scan.id]

    def _note_elements(self) -> None:
        """Elements have changed; their list holds the lock."""
        self._aim()
        self._publish()

    def _aim(self) -> None:
        """Deviations are from what is compared with, else from the last element."""
        self._scene.aim_at(self._reference or self._elements.reference)

    def _drop_old_fits(self) -> None:
        """Scans from before the present one: the scene has already removed them."""
        if self._begun != self._scene.begun:
            self._begun = self._scene.begun
            self._elements.forget()
            self._reference = None
            self._loading = {}

    def _publish(self) -> None:
        """Publishes the view, if it has changed."""
        with self._lock:
            state = self.state()
            if state != self._published:
                self._bus.publish("view", state)
                self._published = state

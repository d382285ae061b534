"""Control of the 3D view, apart from the running scan: other scans, colours, fits."""

import contextlib
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
from crenel.loops import Loop
from crenel.messages.message import Text, message
from crenel.metrology.fitting.shape import MeasuredShape, ShapeName, measure_shape
from crenel.station.bus import Bus
from crenel.station.view3d.cloud.view_cuts import ViewCuts
from crenel.station.view3d.cloud_colouring import Legend, Measure, ReferenceShape
from crenel.station.view3d.cloud_set import SceneContent
from crenel.station.view3d.scene import Scene
from crenel.station.view3d.selection import (
    Rectangle,
    SelectedPoints,
    ViewCamera,
    VisibleCloud,
    frustum_planes,
    select_points,
)
from crenel.station.view3d.shape_fits import UM_PER_MM, FittedShape, shape_mesh, shape_parameters
from crenel.station.view3d.viewpoints import PageCameras
from crenel.station.working_distance import Distance

log = logging.getLogger(__name__)

PUBLISH_S = 0.2
CLOUD = "cloud.ply"


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
    ) -> None:
        self._bus, self._scene, self._scans_dir = bus, scene, scans_dir
        self._distance = distance
        self.pages = PageCameras(scene.content_sphere_m)
        self._lock = threading.RLock()
        self._loading: dict[str, _Loading] = {}
        self._fits: list[tuple[FittedShape, MeasuredShape]] = []
        self._fits_made = 0
        self._reference: ReferenceShape | None = None
        self._begun = scene.begun
        self._busy: Text = ""
        self._records = 0
        self._cuts = ViewCuts(scene, scans_dir)
        self._published: ViewState | None = None
        self._closing = threading.Event()
        self._loader = ThreadPoolExecutor(1, "view-load")
        self._fitter = ThreadPoolExecutor(1, "view-fit")
        self._publisher = Loop("view", self._publish, PUBLISH_S)
        self._publisher.start()

    def close(self) -> None:
        """Ends all running work."""
        self._closing.set()
        self._publisher.stop()
        self._loader.shutdown(cancel_futures=True)
        self._fitter.shutdown(cancel_futures=True)

    def state(self) -> ViewState:
        """The current state of the view."""
        with self._lock:
            self._drop_old_fits()
            scans = self._scene.scans
            return ViewState(
                scans=tuple(
                    VisibleScan(name, shown, round(self._loading.get(name, _WHOLE).done, 2))
                    for name, shown in scans.items()
                    if name
                ),
                measure=self._scene.measure,
                legend=self._scene.legend,
                fits=tuple(fitted for fitted, _ in self._fits),
                busy=self._busy,
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
            if measure == "deviation" and not self._fits and self._reference is None:
                raise OperationError(
                    "no-fit",
                    message("there-no-fitted-shape-yet"),
                    message("deviations-distances-one"),
                    message("fit-plane-sphere-cylinder-first"),
                )
            self._scene.colour_by(measure, limits)
            self._publish()

    def fit(self, key: str, rectangle: Rectangle, shape: ShapeName) -> None:
        """Fits a shape to what the browser with this key shows in a rectangle.

        Returns at once; the shape appears in ``state``, or an event says why it does not.

        Raises:
            OperationError: the browser is unknown, or another fit is running.
        """
        with self._lock:
            camera = self.pages.camera_of(key)
            if self._busy:
                raise OperationError("busy", self._busy, remedy=message("wait-until-done"))
            self._busy = message("fitting", shape=shape)
            self._publish()
        self._fitter.submit(self._fit, camera, rectangle, shape)

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

    def remove_fit(self, fit_id: int) -> None:
        """Removes a fitted shape; deviations are then from the last remaining one."""
        with self._lock:
            self._fits = [(fitted, found) for fitted, found in self._fits if fitted.id != fit_id]
            self._scene.hide_shape(fit_id)
            self._aim()
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

    def _fit(self, camera: ViewCamera, rectangle: Rectangle, shape: ShapeName) -> None:
        """Runs in the fitter's thread."""
        begun = self._scene.begun
        try:
            picked = select_points(camera, rectangle, self._visible_clouds())
            measured = measure_shape(shape, picked.points_mm, picked.frame)
            with self._lock:
                self._drop_old_fits()
                if begun == self._scene.begun:
                    self._keep(shape, picked, measured)
        except OperationError as refusal:
            self._bus.event(
                "refused", message("no-fitted", shape=shape, error=refusal.text), "attention"
            )
        except Exception:
            log.exception("a shape could not be fitted")
            self._bus.event("refused", message("no-fitted-program-failed", shape=shape), "bad")
        finally:
            with self._lock:
                self._busy = ""

    def _keep(self, shape: ShapeName, picked: SelectedPoints, measured: MeasuredShape) -> None:
        self._fits_made += 1
        fit = measured.fit
        fitted = FittedShape(
            id=self._fits_made,
            shape=shape,
            points=int(fit.used.sum()),
            picked=picked.count,
            every=picked.every,
            rms_um=UM_PER_MM * fit.rms_mm,
            largest_um=UM_PER_MM * measured.largest_mm,
            form_um=UM_PER_MM * fit.form_mm,
            figures=shape_parameters(measured),
        )
        self._fits.append((fitted, measured))
        mesh = shape_mesh(measured, picked.points_mm)
        self._scene.show_shape(fitted.id, mesh, f"{shape.capitalize()} {fitted.id}")
        self._aim()

    def _aim(self) -> None:
        """Deviations are from what is compared with, else from the last fit."""
        if self._reference is not None:
            self._scene.aim_at(self._reference)
            return
        if not self._fits:
            self._scene.aim_at(None)
            return
        measured = self._fits[-1][1]
        self._scene.aim_at(ReferenceShape(measured.distances, measured.fit.rms_mm))

    def _visible_clouds(self) -> list[VisibleCloud]:
        """All scans in the view, with the files of those that are complete."""
        found = []
        for name in self._scene.scans:
            with contextlib.suppress(KeyError):  # removed in the meantime
                points_mm, traits, voxel_mm = self._scene.visible_points(name)
                file = self._scans_dir / name / CLOUD
                whole = bool(name) and file.is_file()
                if len(points_mm):
                    cuts = self._scene.cuts.get(name, ())
                    found.append(
                        VisibleCloud(points_mm, traits, voxel_mm, file if whole else None, cuts)
                    )
        return found

    def _drop_old_fits(self) -> None:
        """Scans from before the present one: the scene has already removed them."""
        if self._begun != self._scene.begun:
            self._begun = self._scene.begun
            self._fits = []
            self._reference = None
            self._loading = {}

    def _publish(self) -> None:
        """Publishes the view, if it has changed."""
        with self._lock:
            state = self.state()
            if state != self._published:
                self._bus.publish("view", state)
                self._published = state

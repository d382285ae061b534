"""The 3D view: a viser server on loopback that shows arm, sensor, object and cloud.

It shows everything it receives, so it can be reached only through the station's own server. It is a
preview, never the record.
"""

import threading
import time
from collections.abc import Callable, Sequence
from typing import TypeVar

import numpy as np
import rich

from crenel.formats.clouds.cuts import Cut
from crenel.formats.clouds.points import Points
from crenel.loops import Loop
from crenel.metrology.arm.kinematics import AnyArm, Arm, flange_poses, link_transforms
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.targets.target import CalibrationTarget
from crenel.metrology.transforms import Floats, apply
from crenel.station.view3d.arm_node import ArmNode
from crenel.station.view3d.cloud_colouring import (
    Circumstances,
    Legend,
    Measure,
    PointAttributes,
    ReferenceShape,
    join_circumstances,
)
from crenel.station.view3d.cloud_set import CloudSet, SceneContent
from crenel.station.view3d.meshes import Mesh, reach_mm
from crenel.station.view3d.nodes import (
    M_PER_MM,
    ColouredSurface,
    ShapeNodes,
    SurfaceNode,
    TargetNode,
)
from crenel.station.view3d.scale_bar import ScaleBar
from crenel.station.view3d.scene_server import open_server, prepare_scene
from crenel.station.view3d.viewpoints import InitialCamera

T = TypeVar("T")

POINT_BUDGET = 3_000_000
FLUSH_S = 0.1
REST_S = 0.02
"""Minimum pause between two turns, for the station's other threads."""
# Number of nodes in one message: a new viewer on a slow line gets the first of them before its
# connection times out (viser merges up to 128 by default).
WINDOW_MESSAGES = 4
# Up to this many new points are drawn; of more, every second, third, and so on.
WAITING_POINTS = 250_000
# The view is adjusted again when the cloud has grown by this factor; minimum size.
CLOUD_GROWTH = 1.4
SMALLEST_LOOK_MM = 70.0


class Scene:
    """The drawn scene; methods may be called from any thread and do not wait.

    Points are accepted at once and shown every 100 ms by the scene's own thread.
    """

    def __init__(self, point_budget: int = POINT_BUDGET, label: str = "Crenel") -> None:
        self._server, self.key = _quiet(lambda: open_server(label))
        self._server._websock_server._broadcast_buffer.max_window_size = WINDOW_MESSAGES
        self._lock = threading.RLock()
        self._handing_over = threading.Lock()
        self._waiting: list[tuple[Points, Circumstances]] = []
        self._waiting_points = 0
        self._reading: Sequence[float] | None = None
        self._laser: tuple[bool, bool | None] = (False, None)
        self._clouds = CloudSet(self._server, point_budget)
        self._fits = ShapeNodes(self._server)
        self._surface = SurfaceNode(self._server)
        self._surface_of = ""
        self._scale_bar = ScaleBar(self._server)
        self._live = ""
        self._begun = 0
        self._began_s = time.monotonic()
        self._arm: ArmNode | None = None
        self._arm_shown = True
        self._arm_model: AnyArm | None = None
        self._object = TargetNode(self._server)
        self._aimed_size_mm = 0.0
        self._has_aimed = False
        prepare_scene(self._server)
        self._initial_camera = InitialCamera(self._server)
        self.begin()
        self._loop = Loop("scene", self._draw, FLUSH_S)
        self._loop.start()

    @property
    def port(self) -> int:
        """The loopback port to which the station's server forwards."""
        return int(self._server.get_port())

    @property
    def points_shown(self) -> int:
        """Points of the running scan, or of the last one."""
        return self._clouds.count_visible(self._live)

    @property
    def waiting(self) -> int:
        """Accepted points that are not drawn yet."""
        return self._waiting_points

    @property
    def begun(self) -> int:
        """Number of scans so far: each one clears the view."""
        return self._begun

    @property
    def measure(self) -> Measure:
        """The quantity by which the clouds are coloured."""
        return self._clouds.painter.measure

    @property
    def legend(self) -> Legend | None:
        """The legend of the colours; None before there are any."""
        return self._clouds.painter.legend

    @property
    def scans(self) -> dict[str, int]:
        """The scans in the view, by name, with the number of points shown of each."""
        with self._lock:
            return {name: self._clouds.count_visible(name) for name in self._clouds.names}

    def content_sphere_m(self) -> tuple[Floats, float]:
        """Centre (3,) in the arm frame, and radius, of the clouds; of the arm before there are."""
        with self._lock:
            low, high = self._clouds.bounds_mm
            if not np.isfinite(low).all():
                return self._initial_camera.centre_m, self._initial_camera.radius_m
            radius_mm = max(float(np.linalg.norm(high - low)) / 2, SMALLEST_LOOK_MM / 2)
            return M_PER_MM * (low + high) / 2, M_PER_MM * radius_mm

    def close(self) -> None:
        self._loop.stop()
        _quiet(self._server.stop)

    def begin(self, name: str = "", cuts: Sequence[Cut] = ()) -> None:
        """A new scan, without what the cuts hold: the view is cleared for it; arm, sensor and
        object stay."""
        with self._lock:
            self._take_waiting()
            self.clear_surface()
            self._clouds.clear()
            self._fits.clear()
            self._clouds.painter.aim_at(None)
            self._begun += 1
            self._live = name
            self._began_s = time.monotonic()
            self._clouds.open(name, cuts, live=True)
            self._aimed_size_mm = 0.0
            self._scale_bar.remove()

    def add_points(
        self, points: Points, views: Floats | None = None, too_fast: bool = False
    ) -> None:
        """Adds points (N,) of the arm frame to the scan under way.

        Args:
            views: (N, 3) unit directions to the camera, if they are known.
            too_fast: whether the sensor passed too fast.

        Never waits for drawing. If the display is behind, it receives fewer points, the more so the
        further it is behind: it is a preview.
        """
        with self._handing_over:
            step = 1 + self._waiting_points // WAITING_POINTS
            at_s = np.full(len(points), time.monotonic() - self._began_s)
            taken = Circumstances(at_s, views, np.full(len(points), too_fast))
            self._waiting.append((points[::step], taken[::step]))
            self._waiting_points += len(self._waiting[-1][0])

    def open_scan(self, name: str, cuts: Sequence[Cut]) -> None:
        """Adds an earlier scan to the view, which shows nothing that these cuts hold."""
        with self._lock:
            self._clouds.open(name, cuts)

    def empty_scan(self, name: str) -> None:
        """Takes the points of a scan out of the view; it stays opened, with its cuts."""
        with self._lock:
            self._clouds.empty(name)

    def add_to_scan(self, name: str, points: Points, taken_s: Floats) -> bool:
        """Shows points (N,) of an earlier scan; False if it was removed from the view."""
        with self._lock:
            known = self._clouds.add(name, points, Circumstances(taken_s))
            self._look_at_clouds()
            return known

    def finish_scan(self, name: str) -> None:
        """All points of a scan are there: its weak places are marked."""
        with self._lock:
            if name == self._live:
                self._show_waiting()
            self._clouds.finish(name)

    def cut_scan(self, name: str, cuts: Sequence[Cut]) -> None:
        """Hides what these cuts hold of a scan, and shows all else of it."""
        with self._lock:
            self._clouds.cut(name, cuts)

    @property
    def cuts(self) -> dict[str, tuple[Cut, ...]]:
        """The cuts of each scan in the view, by name."""
        with self._lock:
            return self._clouds.cuts

    def mark_weak(self, on: bool) -> None:
        """Shows weak points in colours of their own, or like the others."""
        with self._lock:
            self._clouds.painter.mark_weak(on)

    def show_arm(self, on: bool) -> None:
        """Shows the arm with its sensor, or hides it."""
        with self._lock:
            self._arm_shown = on
            if self._arm is not None:
                self._arm.show(on)

    @property
    def content(self) -> SceneContent:
        """What is in the view, for its legend."""
        with self._lock:
            lowest_mm = float(self._clouds.bounds_mm[0][2])
            return SceneContent(
                self._arm_shown,
                self._clouds.painter.weak_shown,
                self._clouds.weak_counts,
                self._clouds.cut_count,
                min(0.0, lowest_mm) if np.isfinite(lowest_mm) else 0.0,
            )

    def close_scan(self, name: str) -> None:
        """Removes a scan from the view."""
        with self._lock:
            if name == self._surface_of:
                self.clear_surface()
            self._clouds.close(name)
            if not self._clouds.visible_count:
                self._scale_bar.remove()

    def colour_by(self, measure: Measure, limits: tuple[float, float] | None) -> None:
        """Colours all clouds by this quantity, with limits in its unit, or automatic ones."""
        with self._lock:
            self._clouds.colour_by(measure, limits)

    def aim_at(self, target: ReferenceShape | None) -> None:
        """The shape for deviations."""
        with self._lock:
            self._clouds.painter.aim_at(target)

    def show_shape(self, number: int, mesh: Mesh, label: str) -> None:
        """Draws a fitted shape, translucent, with its name."""
        with self._lock:
            self._fits.show(number, mesh, label)

    def hide_shape(self, number: int) -> None:
        with self._lock:
            self._fits.hide(number)

    @property
    def surface_of(self) -> str:
        """The scan whose surface is shown in place of the clouds; empty if there is none."""
        return self._surface_of

    def show_surface(self, name: str, T_arm_part: Floats, surface: ColouredSurface) -> bool:
        """Shows a surface in place of the clouds until its scan is hidden; False if it is not in
        the view."""
        with self._lock:
            if name not in self._clouds.names:
                return False
            self._surface.show(T_arm_part, surface)
            self._surface_of = name
            self._clouds.show(False)
            return True

    def clear_surface(self) -> None:
        """Shows the clouds again."""
        with self._lock:
            self._surface.clear()
            self._surface_of = ""
            self._clouds.show(True)

    def visible_points(self, name: str) -> tuple[Floats, PointAttributes, float]:
        """The shown points of a scan: (N, 3) mm, their data (N,), and the size of its cubes."""
        with self._lock:
            points_mm, voxel_mm = self._clouds.visible_points(name)
            return points_mm, self._clouds.visible_attributes(name), voxel_mm

    def set_arm_model(self, arm: AnyArm | None) -> None:
        """Draws this arm from now on, with its own kinematics."""
        with self._lock:
            if arm == self._arm_model:
                return
            if self._arm is not None:
                self._arm.remove()
            self._arm_model = arm
            self._arm = None if arm is None else ArmNode(self._server, arm)
            self.show_arm(self._arm_shown)
            self._reading = None
            self._has_aimed = False

    def set_arm(self, reading: Sequence[float]) -> None:
        """The arm's reading (k,); drawn at most ten times per second, while someone watches."""
        self._reading = reading

    def set_sensor(
        self,
        T_flange_sensor: Floats,
        camera: Camera,
        plane: LaserPlane,
        depth_range_mm: tuple[float, float],
    ) -> None:
        """Draws the sensor at the flange, and the field in which its laser measures."""
        with self._lock:
            if self._arm is not None:
                self._arm.set_sensor(T_flange_sensor, camera, plane, depth_range_mm)

    def clear_sensor(self) -> None:
        with self._lock:
            if self._arm is not None:
                self._arm.clear_sensor()

    def set_laser(self, on: bool, in_range: bool | None = None) -> None:
        """Colours the measuring field by the state of the laser, and by whether the stripe is
        within it (None if no stripe is measured)."""
        self._laser = on, in_range

    def set_object(self, T_arm_obj: Floats, item: CalibrationTarget) -> None:
        """Draws the object in its pose by the contact points or the pictures."""
        with self._lock:
            self._object.show(T_arm_obj, item)

    def clear_object(self) -> None:
        with self._lock:
            self._object.clear()

    def _look_at_arm(self, arm: AnyArm, links: Floats) -> None:
        """Before there is a cloud: the arm from its base to its tip."""
        joints, T = [np.zeros(3)], np.eye(4)
        for link in links:
            T = T @ link
            joints.append(T[:3, 3])
        if arm.tip is not None:
            joints.append(apply(T, arm.tip.centre_mm[None])[0])
        low, high = np.min(joints, axis=0), np.max(joints, axis=0)
        radius_mm = 0.5 * float(np.linalg.norm(high - low)) + 0.06 * reach_mm(arm)
        self._initial_camera.look(M_PER_MM * (low + high) / 2, M_PER_MM * radius_mm)

    def _look_at_clouds(self) -> None:
        """The growing clouds: all of them, with part of the sensor above them."""
        low, high = self._clouds.bounds_mm
        if not np.isfinite(low).all():
            return
        size_mm = float(np.linalg.norm(high - low))
        self._scale_bar.lay(low, high)
        if size_mm > CLOUD_GROWTH * self._aimed_size_mm:
            self._aimed_size_mm = size_mm
            centre_mm = (low + high) / 2 + np.array([0.0, 0.0, 0.18 * size_mm])
            self._initial_camera.look(
                M_PER_MM * centre_mm, M_PER_MM * max(0.62 * size_mm, SMALLEST_LOOK_MM)
            )

    def _draw(self) -> float:
        """Draws what is new; returns the pause after it."""
        began_s = time.monotonic()
        with self._lock:
            self._show_waiting()
            self._clouds.settle()
            self._show_arm()
        return max(FLUSH_S - (time.monotonic() - began_s), REST_S)

    def _show_waiting(self) -> None:
        waiting = self._take_waiting()
        if waiting:
            points = np.concatenate([points for points, _ in waiting])
            self._clouds.add(self._live, points, join_circumstances([one for _, one in waiting]))
            self._look_at_clouds()

    def _take_waiting(self) -> list[tuple[Points, Circumstances]]:
        with self._handing_over:
            waiting, self._waiting, self._waiting_points = self._waiting, [], 0
        return waiting

    def _show_arm(self) -> None:
        arm, reading = self._arm, self._reading
        if arm is None or self._arm_model is None:
            return
        arm.set_laser(*self._laser)
        if reading is None or len(reading) != self._arm_model.reading_size:
            return
        if self._has_aimed and not self._server.get_clients():
            return  # the newest reading waits for a viewer
        self._reading = None
        links = _link_chain(self._arm_model, np.array([reading]))
        arm.pose(links)
        if not self._has_aimed:
            self._has_aimed = True
            self._look_at_arm(self._arm_model, links)


def _link_chain(arm: AnyArm, readings: Floats) -> Floats:
    """The links (n, 4, 4) of one reading (1, k), each in the frame before it; of an arm that
    reports poses, its flange alone."""
    if isinstance(arm, Arm):
        return np.asarray(link_transforms(arm, readings)[:, 0])
    return flange_poses(arm, readings)


def _quiet(act: Callable[[], T]) -> T:
    """viser prints its address, which is useless: the view is reached elsewhere."""
    console = rich.get_console()
    before, console.quiet = console.quiet, True
    try:
        return act()
    finally:
        console.quiet = before

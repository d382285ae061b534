"""Scans shown beside one another, and shapes fitted to what a page shows in a rectangle."""

import dataclasses
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel.errors import OperationError
from crenel.formats.clouds.cuts import copy_cloud, cut_mask, read_cuts
from crenel.formats.clouds.files import cloud_writer, read_cloud
from crenel.formats.clouds.points import Points, pack_points
from crenel.metrology.transforms import Floats
from crenel.parts.elements.evaluate_element import measure_element
from crenel.parts.elements.evaluate_errors import PickedPoints, ScanFiles
from crenel.parts.elements.maths_figures import element_figures
from crenel.station.bus import Bus
from crenel.station.view3d.cloud_colouring import WEAK
from crenel.station.view3d.elements.element_views import AskedElement
from crenel.station.view3d.scene import Scene
from crenel.station.view3d.selection import (
    MOST_FITTED,
    FrontSurface,
    Rectangle,
    ViewCamera,
    VisibleCloud,
    select_points,
)
from crenel.station.view3d.view_controller import StoredScan, ViewController
from crenel.station.working_distance import classify_distance
from tests.present import present
from tests.station.conftest import until
from tests.station.viewer import Viewer
from tests.uncertainty_ratio import ratio_of_pulls

pytestmark = pytest.mark.device

KEY = "ab" * 16
MIDDLE = Rectangle(0.25, 0.25, 0.75, 0.75)
FRAMES = 60


def stay(position_m: object, at_m: object) -> None:
    """This page keeps its viewpoint."""


def from_above(height_mm: float = 300.0) -> ViewCamera:
    """Over (500, 0, 0), the picture's right along X, its top along Y."""
    x, y, z, w = Rotation.from_matrix(np.diag([1.0, -1.0, -1.0])).as_quat()
    return ViewCamera((w, x, y, z), (0.5, 0.0, height_mm / 1000), 0.8, 1.5)


def cloud(points: Floats, frame: np.ndarray | int = 0, noise_mm: float = 0.0) -> Points:
    noise = np.random.default_rng(5).normal(0, noise_mm, points.shape) if noise_mm else 0.0
    ones = np.ones(len(points))
    return pack_points(points + noise, 100 * ones, 5 * ones, frame)


def ball(count: int = 20_000, noise_mm: float = 0.01) -> Points:
    """The upper half of a sphere of 20 mm, scanned from left to right, over a table."""
    rng = np.random.default_rng(2)
    outward = rng.normal(size=(count, 3))
    outward /= np.linalg.norm(outward, axis=1)[:, None]
    outward[:, 2] = np.abs(outward[:, 2])
    outward = outward[np.argsort(outward[:, 0])]
    points = outward * (20.0 + rng.normal(0, noise_mm, (count, 1))) + [500, 0, 15]
    return cloud(points, np.arange(count) * FRAMES // count)


def table(count: int = 20_000) -> Points:
    xy = np.random.default_rng(3).uniform(-100, 100, (count, 2))
    return cloud(np.column_stack([500 + xy[:, 0], xy[:, 1], np.zeros(count)]), 999)


@dataclasses.dataclass
class Views:
    """A scene with a folder of scans."""

    scene: Scene
    bus: Bus
    viewing: ViewController
    folder: Path

    def store(self, name: str, points: Points) -> StoredScan:
        (self.folder / name).mkdir()
        with cloud_writer(self.folder / name / "cloud.ply") as writer:
            writer.append(points)
        return StoredScan(name, name.capitalize(), self.folder / name, FRAMES, 6.0)

    def show(self, name: str, points: Points) -> StoredScan:
        """Stores a scan, and shows it as a whole."""
        scan = self.store(name, points)
        self.viewing.show(scan)
        until(lambda: self.whole(name))
        return scan

    def shown(self, scan_id: str) -> int:
        found = {scan.id: scan for scan in self.viewing.state().scans}
        return found[scan_id].points_shown if scan_id in found else 0

    def whole(self, *ids: str) -> bool:
        scans = self.viewing.state().scans
        return {scan.id for scan in scans if scan.loaded == 1.0} >= set(ids)

    def fitted(self, rectangle: Rectangle, shape: AskedElement) -> None:
        """Fits, and waits for the end of it."""
        self.viewing.fit(KEY, rectangle, shape)
        until(lambda: not self.viewing.state().busy)

    def reported(self) -> list[str]:
        return [str(event.text) for event in self.bus._events]


@pytest.fixture
def views(tmp_path: Path) -> Iterator[Views]:
    bus = Bus()
    with (
        closing(Scene(point_budget=40_000)) as scene,
        closing(ViewController(bus, scene, tmp_path, lambda: None)) as viewing,
    ):
        viewing.pages.look(KEY, from_above(), stay)
        yield Views(scene, bus, viewing, tmp_path)


def test_a_point_is_seen_where_the_picture_shows_it() -> None:
    camera = from_above()
    half = 300 * np.tan(0.4)
    corners = np.array([[500, 0, 0], [500 + 1.5 * half, half, 0], [500, 0, 400.0]])
    seen = camera.project(corners)
    np.testing.assert_allclose(seen[:2], [[0.5, 0.5, 300], [1.0, 0.0, 300]], atol=1e-9)
    assert np.isnan(seen[2]).all()


def test_what_lies_behind_the_front_surface_is_not_picked() -> None:
    rng = np.random.default_rng(1)
    xy = rng.uniform(-60, 60, (30_000, 2)) + [500, 0]
    front = np.column_stack([xy, 40 + 0.5 * (xy[:, 0] - 500)])
    behind = np.column_stack([xy + rng.uniform(-5, 5, xy.shape), np.full(len(xy), -60.0)])
    flying = np.column_stack([xy[:300], np.full(300, 120.0)])
    everything = np.concatenate([behind, front, flying])
    surface = FrontSurface(from_above(), Rectangle(0.4, 0.4, 0.6, 0.6), everything, 0.1)
    assert surface.holds(front).mean() > 0.02
    assert not surface.holds(behind).any()
    assert surface.holds(flying).mean() < 0.02
    whole = from_above().project(front)
    within = (np.abs(whole[:, :2] - 0.5) <= 0.1).all(axis=1)
    assert surface.holds(front).sum() > 0.98 * within.sum()


def test_more_points_than_a_fit_takes_are_taken_evenly(tmp_path: Path) -> None:
    count = 3 * MOST_FITTED + 7
    x = np.linspace(480, 520, count)
    points, file = np.column_stack([x, np.zeros((count, 2))]), tmp_path / "cloud.ply"
    with cloud_writer(file) as writer:
        writer.append(cloud(points, np.arange(count) // 900))
    thin = points[::50]
    shown = VisibleCloud(thin, np.zeros(len(thin), [("taken_s", "<f4")]), 0.1, file)
    picked = select_points(from_above(), Rectangle(0, 0, 1, 1), [shown])
    assert picked.count == count
    assert picked.every
    assert MOST_FITTED / 2 < len(picked.points_mm) <= MOST_FITTED
    steps = np.diff(picked.points_mm[:, 0])
    assert steps.max() < 1.01 * steps.min()


def test_a_sphere_is_fitted_to_all_points_of_the_file(views: Views) -> None:
    views.show("ball", np.concatenate([table(), ball()]))
    views.fitted(Rectangle(0.42, 0.4, 0.58, 0.6), "sphere")
    (fitted,) = views.viewing.state().fits
    diameter, *centre = fitted.figures
    assert fitted.every
    assert fitted.points <= fitted.picked <= 40_000
    assert (str(diameter.label), diameter.unit) == ("Diameter", "mm")
    assert diameter.expanded is None
    assert "readings of the arm" in str(fitted.why_scatter)
    assert diameter.value == pytest.approx(40.0, abs=0.003)
    assert 0.00005 < present(diameter.scatter) < 0.003
    assert [figure.value for figure in centre] == pytest.approx([500, 0, 15], abs=0.003)
    assert fitted.rms_um == pytest.approx(10, rel=0.1)
    assert fitted.rms_um < fitted.largest_um < fitted.form_um < 8 * fitted.rms_um
    with closing(Viewer(views.scene)) as viewer:
        vertices = viewer.listen().nodes["/fits/1/shape"]["props"]["vertices"].reshape(-1, 3)
    radius = np.linalg.norm(1e3 * vertices - [500, 0, 15], axis=1)
    np.testing.assert_allclose(radius, 20.0, atol=0.01)


@pytest.mark.parametrize("outside", [False, True])
def test_what_is_cut_away_is_left_out_everywhere_until_it_is_undone(
    views: Views, outside: bool
) -> None:
    scan = views.show("ball", np.concatenate([table(), ball()]))
    shown, whole = views.shown("ball"), (scan.folder / "cloud.ply").read_bytes()
    around = Rectangle(0.3, 0.3, 0.7, 0.7)
    views.viewing.cut(KEY, around, outside)
    state = views.viewing.state()
    assert state.cuts == 1
    assert 0 < state.content.points_cut == shown - views.shown("ball")
    left = views.scene.visible_points("ball")[0]
    seen = from_above().project(left)
    within = (np.abs(seen[:, :2] - 0.5) <= 0.2).all(axis=1)
    assert (within if outside else ~within).all()
    with closing(Viewer(views.scene)) as viewer:
        nodes = viewer.listen().nodes.items()
    sent = [
        node["props"]["points"]
        for name, node in nodes
        if name.startswith("/kept/") and "points" in node["props"]
    ]
    assert sum(points.size for points in sent) == 3 * len(left)
    # what comes later is cut too, as is a saved cloud; the scan's own file stays whole
    views.viewing.hide("ball")
    views.viewing.show(scan)
    until(lambda: views.whole("ball"))
    assert views.shown("ball") == len(left)
    copy_cloud(scan.folder / "cloud.ply", scan.folder / "saved.xyz")
    saved = read_cloud(scan.folder / "saved.xyz").points_mm
    assert 0 < len(saved) < 40_000
    assert not cut_mask(read_cuts(scan.folder), saved).any()
    assert (scan.folder / "cloud.ply").read_bytes() == whole
    views.viewing.undo_cut()
    assert (views.shown("ball"), views.viewing.state().cuts) == (shown, 0)
    with pytest.raises(OperationError, match="no points in the rectangle"):
        views.viewing.cut(KEY, Rectangle(0.0, 0.0, 0.02, 0.02), False)
    assert read_cuts(scan.folder) == ()


def test_places_that_were_scanned_well_once_are_not_weak(views: Views) -> None:
    views.scene.begin("now")
    rng = np.random.default_rng(4)
    xy = rng.uniform(-20, 20, (30_000, 2))
    points = np.column_stack([500 + xy[:, 0], xy[:, 1], np.zeros(len(xy))])
    upright = np.tile([0.0, 0.0, 1.0], (len(xy), 1))
    views.scene.add_points(cloud(points), upright, too_fast=True)
    until(lambda: views.shown("now") > 0)
    again = points[points[:, 0] < 500]
    views.scene.add_points(cloud(again + [0, 0, 0.3]), upright[: len(again)])
    views.scene.finish_scan("now")
    weak = views.viewing.state().content.weak_points
    left = views.scene.visible_points("now")
    fast = left[1]["weak"] & WEAK["fast"][0] > 0
    assert weak["fast"] == fast.sum() > 0.3 * len(fast)
    assert left[0][fast, 0].min() > 498
    assert (weak["steep"], weak["few"]) == (0, 0)


def test_of_the_scan_under_way_what_is_shown_is_fitted_and_that_is_said(views: Views) -> None:
    views.scene.begin("now")
    level = cloud(table()["x"][:, None] * [1, 0, 0] + table()["y"][:, None] * [0, 1, 0], 0, 0.01)
    views.scene.add_points(level)
    until(lambda: views.shown("now") > 0)
    views.fitted(MIDDLE, "plane")
    (fitted,) = views.viewing.state().fits
    assert not fitted.every
    figures = {str(figure.label): figure for figure in fitted.figures}
    distance = figures["Distance from the arm's origin"]
    assert figures["Tilt from horizontal"].value == pytest.approx(0, abs=0.02)
    assert distance.value == pytest.approx(0, abs=0.05)
    assert figures["Normal Z"].value == pytest.approx(1)
    assert distance.scatter is None  # one batch of points is one moment: too little


def test_deviations_are_from_the_last_fit_and_end_with_it(views: Views) -> None:
    with pytest.raises(OperationError, match="There is no fitted shape yet"):
        views.viewing.colour_by("deviation", None)
    views.show("ball", ball())
    views.fitted(Rectangle(0, 0, 1, 1), "sphere")
    views.viewing.colour_by("deviation", None)
    until(lambda: views.viewing.state().legend is not None)
    legend = present(views.viewing.state().legend)
    assert (legend.unit, legend.low) == ("µm", -legend.high)
    assert legend.high == pytest.approx(30, rel=0.15)
    views.viewing.remove_element(1)
    assert views.viewing.state().measure == "height"
    assert not views.viewing.state().fits


def test_a_new_scan_clears_scans_and_fits(views: Views) -> None:
    views.show("ball", ball())
    views.fitted(Rectangle(0, 0, 1, 1), "sphere")
    assert views.viewing.state().fits
    views.scene.begin("next")
    state = views.viewing.state()
    assert [scan.id for scan in state.scans] == ["next"]
    assert not state.fits


def test_a_rectangle_over_nothing_and_a_shape_that_is_not_there_are_said(views: Views) -> None:
    views.show("table", table())
    views.viewing.pages.look(KEY, ViewCamera(from_above().wxyz, (3.0, 3.0, 0.3), 0.8, 1.5), stay)
    views.fitted(MIDDLE, "plane")
    assert "no points in the rectangle" in views.reported()[-1]
    views.viewing.pages.look(KEY, from_above(), stay)
    shapes: tuple[AskedElement, ...] = ("sphere", "cylinder", "cone")
    for shape in shapes:
        views.fitted(MIDDLE, shape)
        assert f"No {shape} was fitted" in views.reported()[-1]
    with pytest.raises(OperationError, match="not connected"):
        views.viewing.fit("cd" * 16, MIDDLE, "plane")


def test_scans_stand_beside_one_another_within_one_budget(views: Views) -> None:
    one, other = views.store("one", ball()), views.store("other", table())
    for scan in (one, other, other):
        views.viewing.show(scan)
    until(lambda: views.whole("one", "other"))
    until(lambda: sum(views.scene.scans.values()) <= 40_000)
    assert views.shown("one") > 5000
    assert views.shown("other") > 5000
    viewer = Viewer(views.scene)
    kept = {name for name in viewer.listen().nodes if name.startswith("/kept/")}
    views.viewing.hide("one")
    assert [scan.id for scan in views.viewing.state().scans] == ["other"]
    left = {name for name in viewer.listen().nodes if name.startswith("/kept/")}
    viewer.close()
    assert left < kept
    assert one.folder.joinpath("cloud.ply").is_file()


def test_a_cloud_that_is_gone_or_spoilt_is_said_and_leaves_nothing(views: Views) -> None:
    scan = views.store("ball", ball())
    file = scan.folder / "cloud.ply"
    file.write_bytes(file.read_bytes()[:-20_000])
    views.viewing.show(scan)
    until(lambda: bool(views.reported()))
    assert "Ball cannot be displayed" in views.reported()[-1]
    assert not views.viewing.state().scans
    file.unlink()
    with pytest.raises(OperationError, match="not in the data folder"):
        views.viewing.show(scan)


def test_manual_limits_must_be_a_range(views: Views) -> None:
    for limits in ((3.0, 3.0), (4.0, 1.0), (0.0, float("inf"))):
        with pytest.raises(OperationError, match="lower limit"):
            views.viewing.colour_by("intensity", limits)
    views.viewing.colour_by("intensity", (0.0, 50.0))
    legend = present(views.viewing.state().legend)
    assert (legend.low, legend.high, legend.automatic) == (0.0, 50.0, False)


def test_a_distance_is_within_the_range_or_to_one_side_of_it() -> None:
    assert classify_distance(150.0, (120.0, 180.0)).state == "in"
    assert classify_distance(119.0, (120.0, 180.0)).state == "near"
    assert classify_distance(181.0, (120.0, 180.0)).state == "far"


def test_a_plane_far_from_the_arm_is_known_the_worse_at_its_zero() -> None:
    """What is claimed of its distance there holds the tilts, over the whole way."""
    scores = []
    for seed in range(60):
        rng = np.random.default_rng(seed)
        frame = np.sort(rng.integers(0, FRAMES, 3000))
        off = rng.normal(0, 0.005, 3000) + rng.normal(0, 0.01, FRAMES)[frame]
        points = np.column_stack([780 + 0.7 * frame, rng.uniform(-20, 20, 3000), 30 + off])
        spread, scan = np.zeros(3000), np.zeros(3000, dtype=np.int64)
        picked = PickedPoints(points, spread, frame, scan, {0: ScanFiles(None)})
        everywhere = np.ones(3000, dtype=bool)
        element = measure_element("plane", picked, everywhere, np.array([0.0, 0.0, 900.0]))
        distance = element_figures(present(element.knowledge))[0]
        scores.append((distance.value - 30.0) / distance.standard_uncertainty)
    ratio_of_pulls(np.array(scores)).assert_within(k=2)

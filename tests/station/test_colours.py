"""What the cloud's colours mean, from the scale to what a browser is sent."""

from collections.abc import Iterator
from contextlib import closing

import numpy as np
import pytest

from crenel.formats.clouds.points import Points, pack_points
from crenel.metrology.colormaps import APART, BALANCE, NO_VALUE, SCALE, map_colours, oklab, srgb
from crenel.station.view3d.cloud_colouring import ATTRIBUTES, CloudColouring, ReferenceShape
from crenel.station.view3d.scene import Scene
from crenel.station.view3d.surface_look import DARKEST, LIGHT
from tests.present import present
from tests.station.conftest import until
from tests.station.viewer import Viewer, viewer

pytestmark = pytest.mark.device
__all__ = ["viewer"]  # a fixture


@pytest.fixture
def scene() -> Iterator[Scene]:
    with closing(Scene(point_budget=30_000)) as scene:
        yield scene


def slope(count: int, seed: int = 1) -> Points:
    """On a slope from 0 to 60 mm, brighter to one side, less certain to the other."""
    x, y = np.random.default_rng(seed).uniform(0, 60, (2, count))
    return pack_points(np.column_stack([500 + x, y, x]), 10 + y, 3 + y / 10, 0)


def colours(viewer: Viewer) -> np.ndarray:
    """(N, 6) place and colour of every point that a browser shows, once it shows any."""
    until(lambda: bool(viewer.listen().clouds()))
    nodes, clouds = viewer.nodes, viewer.clouds()
    rgb = [nodes[name]["props"]["colors"].reshape(-1, 3) for name in clouds]
    return np.column_stack([np.concatenate([*clouds.values()]), np.concatenate(rgb)])


def expected(values: np.ndarray, low: float, high: float) -> np.ndarray:
    """On the slope, whose normal has an angle to the light."""
    step = np.clip((values - low) / (high - low) * 255, 0, 255).astype(int)
    across = (LIGHT[2] - LIGHT[0]) / np.sqrt(2) / np.linalg.norm(LIGHT)
    return np.asarray(SCALE[step] * (DARKEST + (1 - DARKEST) * across), dtype=float)


def off(found: np.ndarray, near: np.ndarray) -> float:
    """Of colours (N, 3), without the few at the edge whose neighbours tell no surface."""
    return float(np.quantile(np.abs(found - near), 0.95))


def seen_by_deuteranopes(rgb: np.ndarray) -> np.ndarray:
    """Without the cones for green (Viénot, Brettel and Mollon, 1999)."""
    linear = (rgb / 255) ** 2.2
    r, g, b = linear.T
    yellow = 0.29275 * r + 0.70725 * g
    both = np.column_stack([yellow, yellow, -0.02234 * r + 0.02234 * g + b])
    return np.asarray(255 * np.clip(both, 0, 1) ** (1 / 2.2))


def test_colours_go_to_oklab_and_back() -> None:
    some = np.random.default_rng(1).uniform(0, 255, (200, 3))
    np.testing.assert_allclose(srgb(oklab(some)), some, atol=1e-4)
    np.testing.assert_allclose(oklab(np.array([[255.0, 255, 255]])), [[1, 0, 0]], atol=1e-3)


@pytest.mark.parametrize("scale", [SCALE, BALANCE[:128], BALANCE[128:]])
def test_equal_steps_look_equal(scale: np.ndarray) -> None:
    steps = np.linalg.norm(np.diff(oklab(scale[: 15 * 8 + 1 : 15]), axis=0), axis=1)
    assert steps.max() < 1.3 * steps.min()


@pytest.mark.parametrize("scale", [SCALE, BALANCE])
def test_those_without_the_cones_for_green_distinguish_them(scale: np.ndarray) -> None:
    dim = oklab(seen_by_deuteranopes(scale[::17].astype(float)))
    apart = np.linalg.norm(dim[:, None] - dim[None], axis=2) + np.eye(len(dim))
    assert apart.min() > 0.02


def test_more_is_lighter_and_both_grounds_show_it() -> None:
    lightness = oklab(SCALE.astype(float))[:, 0]
    assert (np.diff(lightness[::15]) > 0).all()
    assert 0.35 < lightness[0] < lightness[-1] < 0.87


def test_beyond_its_limits_a_value_has_the_outermost_colour() -> None:
    found = map_colours(np.array([-5.0, 0, 10, 99, np.nan]), 0.0, 10.0, SCALE)
    assert found.tolist() == [*(SCALE[i].tolist() for i in (0, 0, 255, 255)), list(NO_VALUE)]


def test_a_browser_gets_other_colours_for_the_points_it_has(scene: Scene, viewer: Viewer) -> None:
    scene.add_points(slope(4000))
    until(lambda: scene.points_shown > 0)
    shown = colours(viewer)
    legend = present(scene.legend)
    assert (legend.measure, legend.unit, legend.automatic) == ("height", "mm", True)
    assert legend.low == pytest.approx(0, abs=0.5)
    assert legend.high == pytest.approx(60, abs=0.5)
    near = expected(shown[:, 2], legend.low, legend.high)
    assert off(shown[:, 3:], near) <= 3
    names = set(viewer.clouds())
    scene.colour_by("intensity", (20.0, 60.0))
    until(lambda: np.abs(colours(viewer)[:, 3:] - shown[:, 3:]).max() > 50)
    again = colours(viewer)
    np.testing.assert_array_equal(again[:, :3], shown[:, :3])
    assert set(viewer.clouds()) == names
    assert off(again[:, 3:], expected(10 + again[:, 1], 20, 60)) <= 3


def test_a_late_viewer_sees_the_present_colours(scene: Scene) -> None:
    scene.add_points(slope(4000))
    until(lambda: scene.points_shown > 0)
    scene.colour_by("uncertainty", (3.0, 9.0))
    until(lambda: all(not view.repaint(1) for view in scene._clouds._views.values()))
    with closing(Viewer(scene)) as viewer:
        found = colours(viewer)
    assert off(found[:, 3:], expected(3 + found[:, 1] / 10, 3, 9)) <= 3


def test_new_points_come_in_the_colours_that_were_chosen(scene: Scene, viewer: Viewer) -> None:
    scene.colour_by("intensity", (0.0, 100.0))
    scene.add_points(slope(4000))
    until(lambda: scene.points_shown > 0)
    found = colours(viewer)
    assert off(found[:, 3:], expected(10 + found[:, 1], 0, 100)) <= 3


def test_an_automatic_range_follows_what_is_shown(scene: Scene) -> None:
    scene.add_points(slope(3000))
    until(lambda: scene.legend is not None)
    tall = slope(3000, 2)
    tall["z"] += 200
    scene.add_points(tall)
    until(lambda: scene.legend is not None and scene.legend.high > 250)
    scene.begin("next")
    assert scene.legend is None
    scene.add_points(slope(3000))
    until(lambda: scene.legend is not None and scene.legend.high < 70)


def traits(taken_s: np.ndarray) -> np.ndarray:
    found = np.zeros(len(taken_s), ATTRIBUTES)
    found["taken_s"], found["brightness"] = taken_s, 255
    return found


def test_the_newest_points_stand_out_by_age() -> None:
    painter, taken_s = CloudColouring(), np.linspace(0, 20, 201)
    painter.show("age", None)
    painter.settle_range(20.0 - taken_s)
    legend = present(painter.legend)
    assert (legend.low, legend.high, legend.unit) == (0.0, 20.0, "s")
    found = painter.colours(np.zeros((201, 3)), traits(taken_s), 20.0)
    lightness = oklab(found.astype(float))[:, 0]
    assert lightness[-1] == lightness.max()
    assert lightness[0] == lightness.min()
    assert painter.age_step(20.0) != painter.age_step(22.0)
    assert painter.beyond_age(60.0, 20.0)
    assert not painter.beyond_age(30.0, 20.0)


def test_deviations_are_in_micrometres_from_the_shape_and_the_rest_stands_apart() -> None:
    painter = CloudColouring()
    painter.aim_at(ReferenceShape(lambda points: points[:, 2], rms_mm=0.01))
    painter.show("deviation", None)
    painter.settle_range(np.zeros(0))
    legend = present(painter.legend)
    assert (legend.low, legend.high) == pytest.approx((-30, 30))
    heights = np.array([-0.03, 0.0, 0.03, 5.0])
    points = np.column_stack([np.zeros((4, 2)), heights])
    found = painter.colours(points, traits(np.zeros(4)), 0.0)
    assert found[0].tolist() == BALANCE[0].tolist()
    assert found[2].tolist() == BALANCE[255].tolist()
    assert np.abs(found[1].astype(int) - BALANCE[127]).max() <= 3
    assert found[3].tolist() == list(APART)
    painter.aim_at(None)
    assert painter.measure == "height"

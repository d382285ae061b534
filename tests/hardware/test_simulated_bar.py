"""The simulated ball bar: where it is touched, from where it is seen, and how it is rendered."""

import numpy as np
import pytest

from crenel_hardware.simulator.operator.gauges.bar import (
    LOWEST,
    ROD_DEG,
    bar_ends,
    touch_directions,
    view_directions,
    with_bar,
)
from crenel_hardware.simulator.scene.world import GaugeSphere, SimulatedScene, make_table

MIDDLE = np.array([500.0, 100.0, 300.0])
DIRECTIONS = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [1.0, -1.0, 1.0]]


@pytest.mark.parametrize("along", DIRECTIONS)
def test_the_touches_fix_the_centre_and_keep_off_the_rod(along: list[float]) -> None:
    rod = np.array(along) / np.linalg.norm(along)
    found = touch_directions(rod)
    np.testing.assert_allclose(np.linalg.norm(found, axis=1), 1.0)
    assert found[:, 2].min() >= LOWEST - 1e-9
    assert np.degrees(np.arccos(found @ rod)).min() >= ROD_DEG
    apart = np.linalg.norm(found[:, None] - found, axis=2)[~np.eye(4, dtype=bool)]
    assert apart.min() > 0.7
    # of a known radius, each direction in space is seen by some touch
    assert np.linalg.eigvalsh(found.T @ found)[0] > 0.3


@pytest.mark.parametrize("along", DIRECTIONS)
def test_the_spheres_are_seen_across_the_bar(along: list[float]) -> None:
    direction = np.array(along) / np.linalg.norm(along)
    views = view_directions(MIDDLE, np.array(along))
    assert len(views) >= 3
    for view in views:
        assert abs(view @ direction) < 1e-9
        assert np.linalg.norm(view) == pytest.approx(1.0)


@pytest.mark.parametrize("along", DIRECTIONS)
def test_the_bar_stands_in_the_scene_where_it_was_set_up(along: list[float]) -> None:
    ends = bar_ends(MIDDLE, np.array(along), 300.0)
    scene = with_bar(SimulatedScene((make_table(),)), ends, 25.0)
    first, second = (scene.find_object(f"bar sphere {n}") for n in (1, 2))
    assert first.shape == second.shape == GaugeSphere(12.5)
    centres = np.array([first.T_arm_obj[:3, 3], second.T_arm_obj[:3, 3]])
    np.testing.assert_allclose(centres.mean(axis=0), MIDDLE)
    assert np.linalg.norm(centres[1] - centres[0]) == pytest.approx(300.0)
    rod = scene.find_object("bar rod")
    far_end = rod.T_arm_obj @ np.array([0.0, 0.0, 300.0, 1.0])
    np.testing.assert_allclose(far_end[:3], centres[1])
    np.testing.assert_allclose(np.linalg.det(rod.T_arm_obj[:3, :3]), 1.0)

"""Visible edges and corners against a march of rays through the block."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from crenel.metrology.detection.visibility import visible_corners, visible_parts
from crenel.metrology.targets.crenellated_block import Crenellated, corners, edges
from crenel.metrology.transforms import Floats
from tests.metrology.builders import BLOCK

CAMERA_MM = np.array([13.0, -70.0, 120.0])
AWAY_MM = (st.floats(-70, 70), st.floats(-140, -20), st.floats(40, 160))
SEEN_FROM = st.tuples(*AWAY_MM).map(np.array)
NUDGES_MM = np.array([[0.0, 0, 0], [1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0]])


def inside(block: Crenellated, points: Floats) -> NDArray[np.bool_]:
    """Which points (N, 3) lie in the block's material."""
    x, y, z = points.T
    edge = np.searchsorted(block.edges_x_mm, x)
    top = np.where(edge % 2 == 1, block.crest_z_mm, block.floor_z_mm)
    within = (edge > 0) & (edge < len(block.edges_x_mm))
    within &= (y > block.front_y_mm) & (y < block.back_y_mm)
    return np.asarray(within & (z > block.base_z_mm) & (z < top))


def clear(block: Crenellated, eye: Floats, point: Floats) -> bool:
    """Whether nothing lies between the eye and just before the point."""
    share = np.linspace(0.2, 1 - 1e-5, 6000)[:, None]
    return not inside(block, eye + share * (point - eye)).any()


def grazes(block: Crenellated, eye: Floats, point: Floats) -> bool:
    """Whether the line of sight passes so close to an edge that the steps of ``clear`` may miss
    what hides it: an eye a millimetre beside sees otherwise."""
    beside = eye + NUDGES_MM
    return len({clear(block, one, point) for one in beside}) > 1


def spans(block: Crenellated, eye: Floats) -> dict[str, list[tuple[float, float]]]:
    """Visible fractions of every edge."""
    named = {edge.name: edge for edge in edges(block)}
    found: dict[str, list[tuple[float, float]]] = {name: [] for name in named}
    for part in visible_parts(block, eye):
        edge = named[part.edge]
        along = edge.end_mm - edge.start_mm
        a, b = ((p - edge.start_mm) @ along / (along @ along) for p in (part.start_mm, part.end_mm))
        found[part.edge].append((float(a), float(b)))
    return found


@settings(max_examples=12, deadline=None)
@given(eye=SEEN_FROM, at=st.lists(st.floats(0.02, 0.98), min_size=3, max_size=3))
def test_a_point_is_visible_just_when_nothing_is_before_it(eye: Floats, at: list[float]) -> None:
    visible = spans(BLOCK, eye)
    for edge in edges(BLOCK):
        for share in at:
            cuts = [end for span in visible[edge.name] for end in span]
            if cuts and min(abs(share - cut) for cut in cuts) < 0.01:
                continue
            point = edge.start_mm + share * (edge.end_mm - edge.start_mm)
            shown = any(a < share < b for a, b in visible[edge.name])
            assert shown == clear(BLOCK, eye, point), (edge.name, share)


@pytest.mark.slow
@settings(max_examples=20, deadline=None)
@given(eye=SEEN_FROM)
def test_corners_agree_with_the_march(eye: Floats) -> None:
    shown = visible_corners(BLOCK, eye)
    for name, point in corners(BLOCK).items():
        if not grazes(BLOCK, eye, point):
            assert (name in shown) == clear(BLOCK, eye, point), name


def test_a_corner_behind_a_sliver_of_material_is_hidden() -> None:
    eye = np.array([-53.75, -20.0, 157.125])
    # the line of sight crosses the top of the merlon before it, 0.8 µm from its edge
    assert "floor:2:R:back" not in visible_corners(BLOCK, eye)
    assert "floor:2:R:back" in visible_corners(BLOCK, eye + [1.0, 0.0, 0.0])


def test_a_merlon_hides_the_foot_of_the_wall_behind_it() -> None:
    far_right = np.array([90.0, -60.0, 60.0])
    names = {part.edge for part in visible_parts(BLOCK, far_right)}
    assert "floor:0:L" in names  # the wall that faces the camera
    assert "floor:0:R" not in names  # behind merlon 1


@pytest.mark.slow
@settings(max_examples=15, deadline=None)
@given(eye=SEEN_FROM)
def test_regions_beside_an_edge_are_what_rays_meet_there(eye: Floats) -> None:
    # Along a face the march's steps are too coarse to meet it.
    assume(np.abs(np.array(BLOCK.edges_x_mm) - eye[0]).min() > 1.0)
    assume(abs(eye[1] - BLOCK.front_y_mm) > 10.0)
    for part in visible_parts(BLOCK, eye):
        middle = (part.start_mm + part.end_mm) / 2
        if np.linalg.norm(part.end_mm - part.start_mm) < 0.5:
            continue
        normal = np.cross(part.start_mm - eye, part.end_mm - eye)
        aside = 0.005 * normal / np.linalg.norm(normal)
        near, far = np.linspace(0.999, 1.001, 9000), np.linspace(0.2, 2.0, 20_000)
        share = np.append(far, near)[:, None]
        for region, sense in zip(part.regions, (1.0, -1.0), strict=True):
            met = inside(BLOCK, eye + share * (middle + sense * aside - eye))
            assert (region != "background") == met.any(), (part.edge, region)


def test_each_part_parts_two_regions() -> None:
    for part in visible_parts(BLOCK, CAMERA_MM):
        assert part.regions[0] != part.regions[1]


def test_the_drawing_moves_with_the_block() -> None:
    moved = replace(BLOCK, edges_x_mm=tuple(x + 5 for x in BLOCK.edges_x_mm))
    here = visible_parts(BLOCK, CAMERA_MM)
    there = visible_parts(moved, CAMERA_MM + [5, 0, 0])
    assert [part.edge for part in here] == [part.edge for part in there]
    expected = np.array([part.end_mm + [5, 0, 0] for part in here])
    assert np.array([part.end_mm for part in there]) == pytest.approx(expected)

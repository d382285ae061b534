"""Blocks for sensors: never their own mirror image, and the accuracy that is stated."""

from dataclasses import replace
from itertools import pairwise, permutations
from typing import Literal

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.metrology.design.block_shapes import FILL, GivenSizes, merlon_edges, possible_blocks
from crenel.metrology.design.expected_contacts import contact_places
from crenel.metrology.design.making_tolerance import ToleranceEffect, widest_tolerance_mm
from crenel.metrology.design.propose_block import assess_block, propose_block
from crenel.metrology.design.stripe_sensor import (
    StripeSensor,
    nominal_camera,
    range_points,
    share_of_picture,
)
from crenel.metrology.design.usual_arm import usual_arm
from crenel.metrology.probing.alignment import align
from crenel.metrology.sensor.camera import project
from crenel.metrology.targets.crenellated_block import mirror_difference_mm, probing_face

SENSOR = StripeSensor(55.0, 115.0, 20.0, 1280, 1024)


def distinction(widths: np.ndarray) -> float:
    """The least rms by which edges miss the mirror image, shifted or not, and the shifted copy."""
    edges = np.concatenate([[0.0], np.cumsum(widths)])
    mirrored = edges[-1] - edges[::-1]
    pairs = [(edges, mirrored), (edges[:-2], mirrored[2:]), (edges[2:], mirrored[:-2])]
    pairs.append((edges[2:], edges[:-2]))
    return float(min(np.std(a - b) for a, b in pairs))


def test_hardly_any_order_of_the_widths_is_farther_from_its_mirror_image() -> None:
    edges = merlon_edges(70.0, 3, 0.5)
    assert edges is not None
    widths = np.diff(edges)
    assert len(set(widths)) == len(widths)
    own = distinction(widths)
    others = [distinction(np.array(order)) for order in permutations(widths)]
    assert own > 0.9 * max(others)


def test_a_coarse_grid_has_no_room_for_different_widths() -> None:
    assert merlon_edges(10.0, 5, 0.5) is None


@pytest.mark.parametrize("axis", ["u", "v"])
def test_the_stripe_runs_along_its_axis(axis: Literal["u", "v"]) -> None:
    sensor = replace(SENSOR, stripe_axis=axis)
    uv = project(nominal_camera(sensor), range_points(sensor))
    ends = project(nominal_camera(sensor), np.array([[-10.0, 0.0, 0.0], [10.0, 0.0, 0.0]]))
    along, across = np.abs(ends[1] - ends[0])[:: 1 if axis == "u" else -1]
    assert along == pytest.approx(20.0 / sensor.pixel_mm, rel=0.01)
    assert across < 1e-6 * along
    assert len(uv) > 50


def test_a_block_fits_its_sensor_and_differs_from_its_mirror_image() -> None:
    design = propose_block(SENSOR, usual_arm(), "B")
    block = design.block
    assert share_of_picture(SENSOR, block) <= FILL
    assert block.crest_z_mm - block.floor_z_mm <= SENSOR.depth_of_field_mm
    merlons = [b - a for a, b in zip(block.edges_x_mm[::2], block.edges_x_mm[1::2], strict=True)]
    assert len(set(merlons)) == len(merlons)
    assert mirror_difference_mm(block.edges_x_mm) > 0.1 * SENSOR.field_of_view_mm
    assert design.eight_poses.total_um < design.one_pose.total_um
    for before, after in pairwise(design.effects[1:]):
        assert before.one_pose_um < after.one_pose_um
    worse = assess_block(SENSOR, replace(block, crest_z_mm=block.floor_z_mm + 2.0), usual_arm())
    assert worse.one_pose.total_um > design.one_pose.total_um


@pytest.mark.parametrize(
    "given",
    [
        GivenSizes(width_mm=40.3),
        GivenSizes(merlons=5),
        GivenSizes(groove_mm=12.3),
        GivenSizes(width_mm=38.0, merlons=4, groove_mm=9.0),
    ],
)
def test_given_sizes_are_kept_by_every_block(given: GivenSizes) -> None:
    for block in possible_blocks(SENSOR, "B", given):
        x = block.edges_x_mm
        assert given.width_mm is None or x[-1] - x[0] == pytest.approx(given.width_mm)
        assert block.merlon_count == (given.merlons or 3)
        assert given.groove_mm is None or block.crest_z_mm == given.groove_mm
        assert share_of_picture(SENSOR, block) <= FILL
        widths = np.diff(x)
        assert np.all(np.diff(widths) < 0)
        assert mirror_difference_mm(x) > 1.0


@pytest.mark.parametrize(
    ("given", "why"),
    [
        (GivenSizes(groove_mm=25.0), "deeper than the depth of field of 20 mm"),
        (GivenSizes(width_mm=60.0), "60 mm is wider than 46.2 mm"),
        (GivenSizes(width_mm=46.0), "is not seen as a whole"),
        (GivenSizes(width_mm=30.0, merlons=9), "taken for its mirror image"),
        (GivenSizes(width_mm=6.0), "the narrowest is 0.7 mm wide"),
        (GivenSizes(width_mm=20.0, groove_mm=18.0), "too deep to be cut"),
        (GivenSizes(merlons=9), "no block with 9 merlons"),
        (GivenSizes(merlons=5, groove_mm=20.0), "5 merlons and grooves of 20 mm"),
    ],
)
def test_sizes_that_contradict_are_refused(given: GivenSizes, why: str) -> None:
    with pytest.raises(OperationError, match=why) as refusal:
        possible_blocks(SENSOR, "B", given)
    assert refusal.value.code == "block-sizes"


@pytest.mark.parametrize(
    "sensor",
    [
        StripeSensor(17.5, 54.9, 8.2, 4760, 2384, "u", 30.4),
        StripeSensor(14.0, 45.3, 4.5, 4192, 2096, "u", 33.3),
        StripeSensor(14.0, 30.0, 8.0, 640, 480, "v", 24.0),
        StripeSensor(230.0, 396.0, 90.0, 3720, 2800, "u", 25.0),
    ],
)
@pytest.mark.parametrize("tip_radius_mm", [1.0, 3.0])
def test_a_block_of_any_size_is_found_by_the_contacts_that_its_design_expects(
    sensor: StripeSensor, tip_radius_mm: float
) -> None:
    for block in possible_blocks(sensor, "B", GivenSizes()):
        features, spots = contact_places(block, tip_radius_mm)
        normals = np.array([probing_face(block, face)[0] for face in features])
        found = align(features, spots + tip_radius_mm * normals, tip_radius_mm, block)
        np.testing.assert_allclose(found.T_arm_obj, np.eye(4), atol=1e-6)


def test_a_given_tolerance_is_judged_and_stated() -> None:
    given = GivenSizes(merlons=3, groove_mm=12.0, tolerance_mm=0.03)
    design = propose_block(SENSOR, usual_arm(), "B", given=given)
    assert design.tolerance_mm == 0.03
    assert [one.tolerance_mm for one in design.effects[1:]] == [0.005, 0.01, 0.02, 0.03, 0.05, 0.1]


def test_the_widest_tolerance_costs_little() -> None:
    effects = [ToleranceEffect(None, 10.0, 5.0), ToleranceEffect(0.005, 10.1, 5.1)]
    effects += [ToleranceEffect(0.01, 11.0, 6.2), ToleranceEffect(0.02, 14.0, 6.3)]
    assert widest_tolerance_mm(effects) == 0.01


@pytest.mark.parametrize(
    "wrong",
    [
        replace(SENSOR, depth_of_field_mm=1.0),
        replace(SENSOR, depth_of_field_mm=250.0),
        replace(SENSOR, field_of_view_mm=400.0),
    ],
)
def test_numbers_of_no_sensor_are_refused(wrong: StripeSensor) -> None:
    with pytest.raises(OperationError) as refusal:
        propose_block(wrong, usual_arm(), "B")
    assert refusal.value.code == "sensor-numbers"


def test_a_sensor_for_which_no_block_can_be_touched_is_refused() -> None:
    tiny = StripeSensor(4.0, 30.0, 1.0, 1280, 1024)
    with pytest.raises(OperationError) as refusal:
        propose_block(tiny, usual_arm(), "B")
    assert refusal.value.code == "no-block-for-sensor"

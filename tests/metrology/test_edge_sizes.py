"""A wrong size is found from all edges together: which, and by how much."""

from dataclasses import replace

import numpy as np
import pytest

from app.metrology.detection.edges.dimension_test import (
    PlaneShift,
    describe_plane,
    estimate_shifts,
    find_unobserved_planes,
    planes,
)
from app.metrology.detection.edges.measure_all import align_camera_to_edges, measure_edges
from app.metrology.detection.edges.stations import place_stations
from app.metrology.detection.image_quality import grey_levels
from app.metrology.detection.rejection import describe_edge
from app.metrology.detection.visibility import wireframe
from app.metrology.sensor.camera import project
from app.metrology.targets.crenellated_block import Crenellated
from tests.metrology.rendered_block import RenderedBlock, render_block


@pytest.fixture(scope="module")
def plain() -> RenderedBlock:
    return render_block(1, merlons=4)


def reported(picture: RenderedBlock, claimed: Crenellated) -> PlaneShift:
    grey, _ = grey_levels(picture.image)
    found = measure_edges(grey, wireframe(claimed), picture.camera, 0.8, 0.002)
    assert found is not None
    return max(estimate_shifts(found, 0.002), key=lambda one: one.ratio)


def test_the_block_itself_is_nowhere_shifted(plain: RenderedBlock) -> None:
    assert reported(plain, plain.block).ratio < 4.0


@pytest.mark.parametrize(("edge", "by_mm"), [(2, 0.08), (3, -0.08), (5, 0.08)])
def test_a_merlons_side_is_named_with_amount(plain: RenderedBlock, edge: int, by_mm: float) -> None:
    x = list(plain.block.edges_x_mm)
    x[edge] += by_mm
    shift = reported(plain, replace(plain.block, edges_x_mm=tuple(x)))
    assert shift.ratio > 6.0
    assert shift.axis == 0
    assert shift.at_mm == pytest.approx(x[edge])
    assert shift.by_mm == pytest.approx(-by_mm, rel=0.3)


def test_a_side_whose_edges_do_not_show_is_named(plain: RenderedBlock) -> None:
    grey, _ = grey_levels(plain.image)
    found = measure_edges(grey, wireframe(plain.block), plain.camera, 0.8, 0.002)
    assert found is not None
    assert find_unobserved_planes(found) == ()
    for plane, name in ((2, "left side of merlon 2"), (5, "right side of merlon 3")):
        _, at_mm, edges = planes(found.frame)[plane]
        assert at_mm == plain.block.edges_x_mm[plane]
        hidden = replace(found, used=found.used & ~np.isin(found.at.edge, edges))
        assert find_unobserved_planes(hidden) == ((0, plane),)
        assert str(describe_plane(0, plane)) == f"the {name}"


@pytest.mark.parametrize(("aside_mm", "measured"), [(-0.05, False), (0.05, False), (25.0, True)])
def test_a_face_edge_on_is_not_measured(
    plain: RenderedBlock, aside_mm: float, measured: bool
) -> None:
    """A camera in the plane of the block's left end: what it sees there may be either edge."""
    frame = wireframe(plain.block)
    eye_mm = np.array([plain.block.edges_x_mm[0] + aside_mm, *plain.camera.centre_mm[1:]])
    camera = replace(plain.camera, translation_mm=-plain.camera.rotation @ eye_mm)
    # The picture follows the block.
    K = camera.matrix.copy()
    middle = np.array([400.0, 320.0])
    K[:2, 2] += middle - project(camera, frame.starts_mm).mean(axis=0)
    at = place_stations(frame, replace(camera, matrix=K), 5.0, 4.0)
    rows = np.array(frame.names)[at.edge] == "crest:0:L"
    assert rows.any()
    assert bool((at.clearance_px[rows].min(axis=1) > 4.0).any()) is measured


@pytest.mark.parametrize("enlarged", [1e4, 1e7])
def test_a_guess_with_an_absurd_camera_takes_no_memory(
    plain: RenderedBlock, enlarged: float
) -> None:
    """Its edges appear millions of pixels long."""
    K = plain.camera.matrix.copy()
    K[:2, :2] *= enlarged
    absurd = replace(plain.camera, matrix=K)
    frame = wireframe(plain.block)
    at = place_stations(frame, absurd, 0.5, 3.0)
    size = plain.camera.width_px + plain.camera.height_px
    assert len(at.edge) <= 8 * size * len(frame.names)
    grey, _ = grey_levels(plain.image)
    assert align_camera_to_edges(grey, frame, absurd, 8.0) is None


def test_a_guess_with_the_block_behind_the_camera_is_given_up(plain: RenderedBlock) -> None:
    behind = replace(plain.camera, translation_mm=plain.camera.translation_mm * [1, 1, -1])
    grey, _ = grey_levels(plain.image)
    assert align_camera_to_edges(grey, wireframe(plain.block), behind, 8.0) is None


@pytest.mark.parametrize(
    ("edge", "words"),
    [
        ("crest:1:L", "the left edge of the crest of merlon 2"),
        ("floor:0:front", "the front edge of the floor of groove 1"),
        ("wall:0:R:back", "the upright back edge on the right of merlon 1"),
        ("base:front", "the front edge of the base"),
    ],
)
def test_edges_are_named_in_words(edge: str, words: str) -> None:
    assert str(describe_edge(edge)) == words

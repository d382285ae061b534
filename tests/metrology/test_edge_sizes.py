"""What edges contradict: a size, found from all together; where the block ends; one alone."""

from dataclasses import replace

import numpy as np
import pytest

from crenel.metrology.detection.acceptance import check_measurements
from crenel.metrology.detection.edges.dimension_test import (
    PlaneShift,
    describe_plane,
    estimate_shifts,
    find_unobserved_planes,
    planes,
)
from crenel.metrology.detection.edges.edge_overrun import find_overrun
from crenel.metrology.detection.edges.measure_all import EdgeMeasurements, align_camera_to_edges
from crenel.metrology.detection.edges.stations import place_stations
from crenel.metrology.detection.image_quality import grey_levels
from crenel.metrology.detection.rejection import RejectionReason, describe_edge
from crenel.metrology.detection.visibility import wireframe
from crenel.metrology.sensor.camera import project
from crenel.metrology.targets.crenellated_block import Crenellated
from tests.metrology.rendered_block import MADE_MM, RenderedBlock, render_block, survey, with_edge
from tests.present import present

SIDE = "crest:1:L"


def reported(picture: RenderedBlock, claimed: Crenellated) -> PlaneShift:
    found = survey(picture, claimed, grey_levels(picture.image)[0], 0.8)
    return max(estimate_shifts(found, MADE_MM), key=lambda one: one.ratio)


def test_the_block_itself_is_nowhere_shifted(plain: RenderedBlock) -> None:
    assert reported(plain, plain.block).ratio < 4.0


@pytest.mark.parametrize(("edge", "by_mm"), [(2, 0.08), (3, -0.08), (5, 0.08)])
def test_a_merlons_side_is_named_with_amount(plain: RenderedBlock, edge: int, by_mm: float) -> None:
    claimed = with_edge(plain.block, edge, by_mm)
    shift = reported(plain, claimed)
    assert shift.ratio > 6.0
    assert shift.axis == 0
    assert shift.at_mm == pytest.approx(claimed.edges_x_mm[edge])
    assert shift.by_mm == pytest.approx(-by_mm, rel=0.3)


def test_a_side_whose_edges_do_not_show_is_named(plain: RenderedBlock) -> None:
    found = survey(plain, grey=grey_levels(plain.image)[0], blur_px=0.8)
    assert find_unobserved_planes(found) == ()
    for plane, name in ((2, "left side of merlon 2"), (5, "right side of merlon 3")):
        _, at_mm, edges = planes(found.frame)[plane]
        assert at_mm == plain.block.edges_x_mm[plane]
        hidden = replace(found, used=found.used & ~np.isin(found.at.edge, edges))
        assert find_unobserved_planes(hidden) == ((0, plane),)
        assert str(describe_plane(0, plane)) == f"the {name}"


@pytest.mark.parametrize(("aside_mm", "measured"), [(-0.05, False), (0.05, False), (25.0, True)])
def test_faces_edge_on_tell_nothing(plain: RenderedBlock, aside_mm: float, measured: bool) -> None:
    """A camera in the plane of the block's left end: what it sees there may be either edge."""
    frame = wireframe(plain.block)
    eye_mm = np.array([plain.block.edges_x_mm[0] + aside_mm, *plain.camera.centre_mm[1:]])
    camera = replace(plain.camera, translation_mm=-plain.camera.rotation @ eye_mm)
    # The picture follows the block.
    K = camera.matrix.copy()
    K[:2, 2] += [400.0, 320.0] - project(camera, frame.starts_mm).mean(axis=0)
    at = place_stations(frame, replace(camera, matrix=K), 5.0, 4.0)
    rows = np.array(frame.names)[at.edge] == "crest:0:L"
    assert rows.any()
    assert bool((at.clearance_px[rows].min(axis=1) > 4.0).any()) is measured


@pytest.mark.parametrize("enlarged", [1e4, 1e7])
def test_a_guess_of_an_absurd_camera_is_given_up(plain: RenderedBlock, enlarged: float) -> None:
    """Its edges appear millions of pixels long."""
    K = plain.camera.matrix.copy()
    K[:2, :2] *= enlarged
    absurd = replace(plain.camera, matrix=K)
    frame = wireframe(plain.block)
    at = place_stations(frame, absurd, 0.5, 3.0)
    size = plain.camera.width_px + plain.camera.height_px
    assert len(at.edge) <= 8 * size * len(frame.names)
    assert align_camera_to_edges(grey_levels(plain.image)[0], frame, absurd, 8.0) is None


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


def runs_on(plain: RenderedBlock, block: Crenellated, noise: float) -> RejectionReason | None:
    """What is objected to ``block`` in the picture, with so many grey levels of noise added."""
    rng = np.random.default_rng(7)
    grey = plain.image + noise * rng.standard_normal(plain.image.shape)
    return find_overrun(grey, survey(plain, block, grey))


@pytest.mark.parametrize("noise", [0.0, 15.0, 22.0])
@pytest.mark.parametrize("kept", [slice(2, None), slice(0, -2)])
def test_a_longer_block_is_reported(plain: RenderedBlock, noise: float, kept: slice) -> None:
    shorter = replace(plain.block, edges_x_mm=plain.block.edges_x_mm[kept])
    against = present(runs_on(plain, shorter, noise))
    assert "continues beyond its" in str(against.text)


@pytest.mark.parametrize("noise", [0.0, 15.0, 22.0])
def test_the_block_of_the_certificate_does_not_run_on(plain: RenderedBlock, noise: float) -> None:
    assert runs_on(plain, plain.block, noise) is None


@pytest.fixture(scope="module")
def turned() -> RenderedBlock:
    return render_block(1, merlons=4, azimuth=0.4)


def with_one_edge_off(turned: RenderedBlock, by_px: float) -> EdgeMeasurements:
    """The block's edges, of one side but one, and that moved across itself."""
    found = survey(turned)
    names = np.array(found.frame.names)[found.at.edge]
    others = np.isin(names, ["floor:0:R", "wall:1:L:front", "wall:1:L:back"])
    moved = np.where(names == SIDE, by_px, 0.0)
    return replace(
        found,
        uv_px=found.uv_px + moved[:, None] * found.at.normal,
        off_px=found.off_px + moved,
        shows=found.shows & ~others,
        used=found.used & ~others,
    )


@pytest.mark.slow
def test_an_edge_a_little_off_is_left_out_and_its_side_named(turned: RenderedBlock) -> None:
    found = with_one_edge_off(turned, 0.6)
    assert SIDE in np.array(found.frame.names)[found.at.edge[found.used]]
    rest, against = check_measurements(turned.image.astype(float), found, MADE_MM)
    assert against is None
    assert SIDE not in np.array(rest.frame.names)[rest.at.edge[rest.used]]
    assert (0, 2) in find_unobserved_planes(rest)


@pytest.mark.slow
def test_an_edge_further_off_is_doubtful(turned: RenderedBlock) -> None:
    found = with_one_edge_off(turned, 1.4)
    _, against = check_measurements(turned.image.astype(float), found, MADE_MM)
    assert present(against).definite

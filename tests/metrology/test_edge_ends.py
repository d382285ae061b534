"""Where edges end shows a wrong size; a thing that lies over one end does not."""

from dataclasses import replace

import numpy as np
import pytest

from app.metrology.detection.edges.dimension_test import count_in_place, planes
from app.metrology.detection.edges.edge_ends import ends_in_place, find_misplaced_ends, measure_ends
from app.metrology.detection.edges.measure_all import EdgeMeasurements, measure_edges
from app.metrology.detection.edges.other_edges import find_wrong_dimension
from app.metrology.detection.rejection import RejectionReason
from app.metrology.detection.visibility import wireframe
from app.metrology.sensor.camera import project
from app.metrology.targets.crenellated_block import Crenellated, corners
from tests.metrology.rendered_block import RenderedBlock, render_block

pytestmark = pytest.mark.slow

BLUR_PX, MADE_MM = 0.7, 0.002


@pytest.fixture(scope="module")
def shown() -> RenderedBlock:
    return render_block(1, merlons=4)


def surveyed(shown: RenderedBlock, grey: np.ndarray, block: Crenellated) -> EdgeMeasurements:
    """The edges of a certificate measured with the camera that took the picture."""
    found = measure_edges(grey, wireframe(block), shown.camera, BLUR_PX, MADE_MM)
    assert found is not None
    return found


def elsewhere_by_ends(grey: np.ndarray, found: EdgeMeasurements) -> RejectionReason | None:
    return find_misplaced_ends(grey, found, measure_ends(grey, found))


def with_wrong_size(block: Crenellated, edge: int, by_mm: float) -> Crenellated:
    edges = list(block.edges_x_mm)
    edges[edge] += by_mm
    return replace(block, edges_x_mm=tuple(edges))


def covered(
    shown: RenderedBlock, grey: np.ndarray, corner: str, level: float = 128.0
) -> np.ndarray:
    """The picture with a grey square over one of the block's corners; NaN: clipped there."""
    u, v = np.rint(project(shown.camera, corners(shown.block)[corner][None])[0]).astype(int)
    grey = grey.copy()
    grey[v - 14 : v + 15, u - 14 : u + 15] = level
    return grey


def test_a_block_that_is_as_its_certificate_says(shown: RenderedBlock) -> None:
    grey = shown.image.astype(float)
    assert elsewhere_by_ends(grey, surveyed(shown, grey, shown.block)) is None


@pytest.mark.parametrize("edge", [0, 1, 4, 7])
@pytest.mark.parametrize("by_mm", [-1.4, -0.9, 0.9, 1.4])
def test_a_wrong_size_is_named_with_amount(shown: RenderedBlock, edge: int, by_mm: float) -> None:
    grey = shown.image.astype(float)
    found = surveyed(shown, grey, with_wrong_size(shown.block, edge, by_mm))
    against = elsewhere_by_ends(grey, found)
    assert against is not None
    assert against.definite
    # Something over both ends of a crest shortens it as well; nothing makes it longer.
    shorter = (by_mm > 0) == (edge % 2 == 1)
    assert against.alone == (shorter and edge in (1, 4))
    wrong = f"crest:{edge // 2}:{'LR'[edge % 2]}"
    assert found.frame.names[against.edges[0]] == wrong
    px_per_mm = against.off_px / abs(by_mm)
    stated_mm = float(str(against.text).split(" mm ")[0].rsplit(" ", 1)[1])
    assert stated_mm == pytest.approx(abs(by_mm), abs=2.0 / px_per_mm)


@pytest.mark.parametrize("other_end_shows", [True, False])
def test_a_thing_over_a_corner_is_no_wrong_size(
    shown: RenderedBlock, other_end_shows: bool
) -> None:
    grey = covered(shown, shown.image.astype(float), "crest:1:R:back")
    if not other_end_shows:
        grey = covered(shown, grey, "crest:1:R:front", np.nan)
    assert elsewhere_by_ends(grey, surveyed(shown, grey, shown.block)) is None


@pytest.mark.parametrize("by_mm", [-1.4, 0.9])
def test_one_end_that_lines_elsewhere_bear_out(shown: RenderedBlock, by_mm: float) -> None:
    grey = covered(shown, shown.image.astype(float), "crest:1:R:front", np.nan)
    found = surveyed(shown, grey, with_wrong_size(shown.block, 3, by_mm))
    against = elsewhere_by_ends(grey, found)
    assert against is not None
    assert found.frame.names[against.edges[0]] == "crest:1:R"


@pytest.mark.parametrize("by_mm", [-1.4, 1.4])
def test_a_wrong_size_in_a_noisy_picture(shown: RenderedBlock, by_mm: float) -> None:
    grey = shown.image + np.random.default_rng(5).normal(0.0, 20.0, shown.image.shape)
    assert elsewhere_by_ends(grey, surveyed(shown, grey, shown.block)) is None
    against = elsewhere_by_ends(grey, surveyed(shown, grey, with_wrong_size(shown.block, 4, by_mm)))
    assert against is not None


def test_broken_edges_that_shorten_all_alike_are_no_wrong_size(shown: RenderedBlock) -> None:
    grey = shown.image.astype(float)
    block = shown.block
    outward = np.where(np.arange(len(block.edges_x_mm)) % 2, 0.6, -0.6)
    longer = replace(block, edges_x_mm=tuple(np.array(block.edges_x_mm) + outward))
    assert elsewhere_by_ends(grey, surveyed(shown, grey, longer)) is None


@pytest.mark.parametrize("side", ["crest:1:R", "crest:3:R"])
@pytest.mark.parametrize("level", [40.0, 128.0, 220.0])
def test_things_over_both_ends_of_an_edge_that_shows_between_them(
    shown: RenderedBlock, side: str, level: float
) -> None:
    grey = covered(shown, shown.image.astype(float), f"{side}:front", level)
    grey = covered(shown, grey, f"{side}:back", level)
    assert elsewhere_by_ends(grey, surveyed(shown, grey, shown.block)) is None


def striped(
    shown: RenderedBlock, side: str, left: int, right: int, level: float, askew: int = 0
) -> np.ndarray:
    """The picture with a strip along an upper edge of the block, from so many px left of it,
    and ``askew`` more of them at its front."""
    begin, end = (
        project(shown.camera, corners(shown.block)[f"{side}:{at}"][None])[0]
        for at in ("front", "back")
    )
    grey = shown.image.astype(float)
    rows = np.arange(int(end[1]) - 14, int(begin[1]) + 15)
    columns = np.interp(rows, [end[1], begin[1]], [end[0], begin[0]])
    further = np.linspace(0, askew, len(rows)).astype(int)
    for row, column, more in zip(rows, columns, further, strict=True):
        grey[row, round(column) - left - more : round(column) + right] = level
    return grey


def test_an_end_of_the_base_in_place_outweighs_crests_that_end_short(shown: RenderedBlock) -> None:
    grey = striped(shown, "crest:3:R", 14, 15, 128.0)
    assert elsewhere_by_ends(grey, surveyed(shown, grey, shown.block)) is None


@pytest.mark.parametrize("askew", [0, 20])
def test_a_strip_along_an_edge_is_no_wrong_size_where_the_floor_shows_it_in_place(
    shown: RenderedBlock, askew: int
) -> None:
    grey = striped(shown, "crest:1:R", 14, 15, 128.0, askew)
    assert elsewhere_by_ends(grey, surveyed(shown, grey, shown.block)) is None


def test_two_ends_moved_by_different_lengths_give_no_reason(shown: RenderedBlock) -> None:
    grey = covered(shown, shown.image.astype(float), "crest:0:R:front")
    found = surveyed(shown, grey, with_wrong_size(shown.block, 1, 0.9))
    assert elsewhere_by_ends(grey, found) is None


def test_ends_within_what_is_clipped_are_not_known(shown: RenderedBlock) -> None:
    grey = striped(shown, "crest:1:R", 6, 36, np.nan)
    assert elsewhere_by_ends(grey, surveyed(shown, grey, shown.block)) is None


@pytest.mark.parametrize("right", [0, 8])
def test_a_line_where_a_floor_is_drawn_by_chance_does_not_outweigh_edges_that_go_on(
    shown: RenderedBlock, right: int
) -> None:
    claimed = with_wrong_size(shown.block, 1, -1.4)
    grey = striped(replace(shown, block=claimed), "floor:0:L", 8 - right, right, 220.0)
    found = surveyed(shown, grey, claimed)
    edges = next(
        e for axis, at, e in planes(found.frame) if (axis, at) == (0, claimed.edges_x_mm[1])
    )
    assert count_in_place(found, edges, 0) == 1
    against = elsewhere_by_ends(grey, found)
    assert against is not None
    assert against.edges == edges


def test_ends_in_place_gainsay_lines_elsewhere(shown: RenderedBlock) -> None:
    grey = shown.image.astype(float)
    ends = measure_ends(grey, surveyed(shown, grey, shown.block))
    at_mm = shown.block.edges_x_mm[4]
    assert ends_in_place(ends, at_mm, 1.4)
    assert ends_in_place(ends, at_mm, -1.4)
    # Within what the blur leaves unclear, an end says nothing.
    assert not ends_in_place(ends, at_mm, 0.1)
    wrong = with_wrong_size(shown.block, 4, 1.4)
    found = surveyed(shown, grey, wrong)
    assert not ends_in_place(measure_ends(grey, found), wrong.edges_x_mm[4], -1.4)
    assert find_wrong_dimension(grey, found, lambda at_mm, by_mm: False) is not None
    assert find_wrong_dimension(grey, found, lambda at_mm, by_mm: True) is None

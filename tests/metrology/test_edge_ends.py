"""Where edges end shows a wrong size; a thing that lies over one end does not."""

from dataclasses import replace

import numpy as np
import pytest

from crenel.metrology.detection.edges.dimension_test import count_in_place, planes
from crenel.metrology.detection.edges.edge_ends import (
    ends_in_place,
    find_misplaced_ends,
    measure_ends,
)
from crenel.metrology.detection.edges.measure_all import EdgeMeasurements
from crenel.metrology.detection.edges.other_edges import find_wrong_dimension
from crenel.metrology.detection.rejection import RejectionReason
from crenel.metrology.sensor.camera import project
from crenel.metrology.targets.crenellated_block import corners
from crenel.metrology.transforms import Floats
from tests.metrology.rendered_block import RenderedBlock, survey, with_edge
from tests.present import present

pytestmark = pytest.mark.slow


def elsewhere_by_ends(grey: Floats, found: EdgeMeasurements) -> RejectionReason | None:
    return find_misplaced_ends(grey, found, measure_ends(grey, found))


def covered(plain: RenderedBlock, *names: str, level: float = 128.0) -> Floats:
    """The picture with grey squares over corners of the block; NaN: clipped there."""
    grey = plain.image.astype(float)
    for name in names:
        u, v = np.rint(project(plain.camera, corners(plain.block)[name][None])[0]).astype(int)
        grey[v - 14 : v + 15, u - 14 : u + 15] = level
    return grey


def striped(
    plain: RenderedBlock,
    side: str,
    px: tuple[int, int] = (14, 15),
    level: float = 128,
    askew: int = 0,
) -> Floats:
    """The picture with a strip along an upper edge of the block, so many px left and right of it,
    and ``askew`` more of them left at its front."""
    at = corners(plain.block)
    begin, end = project(plain.camera, np.array([at[f"{side}:front"], at[f"{side}:back"]]))
    grey = plain.image.astype(float)
    rows = np.arange(int(end[1]) - 14, int(begin[1]) + 15)
    columns = np.interp(rows, [end[1], begin[1]], [end[0], begin[0]])
    further = np.linspace(0, askew, len(rows)).astype(int)
    for row, column, more in zip(rows, columns, further, strict=True):
        grey[row, round(column) - px[0] - more : round(column) + px[1]] = level
    return grey


def check_in_place(plain: RenderedBlock, grey: Floats) -> None:
    assert elsewhere_by_ends(grey, survey(plain, grey=grey)) is None


def test_a_block_that_is_as_its_certificate_says(plain: RenderedBlock) -> None:
    check_in_place(plain, plain.image.astype(float))


@pytest.mark.parametrize("other_end_shows", [True, False])
def test_a_thing_over_a_corner_is_no_fault(plain: RenderedBlock, other_end_shows: bool) -> None:
    grey = covered(plain, "crest:1:R:back")
    if not other_end_shows:
        grey += 0 * covered(plain, "crest:1:R:front", level=np.nan)
    check_in_place(plain, grey)


@pytest.mark.parametrize("side", ["crest:1:R", "crest:3:R"])
@pytest.mark.parametrize("level", [40.0, 128.0, 220.0])
def test_things_over_both_ends_are_none(plain: RenderedBlock, side: str, level: float) -> None:
    check_in_place(plain, covered(plain, f"{side}:front", f"{side}:back", level=level))


def test_an_end_of_the_base_in_place_outweighs_crests_that_end_short(plain: RenderedBlock) -> None:
    check_in_place(plain, striped(plain, "crest:3:R"))


@pytest.mark.parametrize("askew", [0, 20])
def test_a_strip_where_the_floor_is_in_place_is_none(plain: RenderedBlock, askew: int) -> None:
    check_in_place(plain, striped(plain, "crest:1:R", askew=askew))


def test_ends_within_what_is_clipped_are_not_known(plain: RenderedBlock) -> None:
    check_in_place(plain, striped(plain, "crest:1:R", (6, 36), np.nan))


@pytest.mark.parametrize("edge", [0, 1, 4, 7])
@pytest.mark.parametrize("by_mm", [-1.4, -0.9, 0.9, 1.4])
def test_a_wrong_size_is_named_with_amount(plain: RenderedBlock, edge: int, by_mm: float) -> None:
    grey = plain.image.astype(float)
    found = survey(plain, with_edge(plain.block, edge, by_mm), grey)
    against = present(elsewhere_by_ends(grey, found))
    assert against.definite
    # Something over both ends of a crest shortens it as well; nothing makes it longer.
    shorter = (by_mm > 0) == (edge % 2 == 1)
    assert against.alone == (shorter and edge in (1, 4))
    wrong = f"crest:{edge // 2}:{'LR'[edge % 2]}"
    assert found.frame.names[against.edges[0]] == wrong
    px_per_mm = against.off_px / abs(by_mm)
    stated_mm = float(str(against.text).split(" mm ")[0].rsplit(" ", 1)[1])
    assert stated_mm == pytest.approx(abs(by_mm), abs=2.0 / px_per_mm)


@pytest.mark.parametrize("by_mm", [-1.4, 0.9])
def test_one_end_that_lines_elsewhere_bear_out(plain: RenderedBlock, by_mm: float) -> None:
    grey = covered(plain, "crest:1:R:front", level=np.nan)
    found = survey(plain, with_edge(plain.block, 3, by_mm), grey)
    against = present(elsewhere_by_ends(grey, found))
    assert found.frame.names[against.edges[0]] == "crest:1:R"


@pytest.mark.parametrize("by_mm", [-1.4, 1.4])
def test_a_wrong_size_in_a_noisy_picture(plain: RenderedBlock, by_mm: float) -> None:
    grey = plain.image + np.random.default_rng(5).normal(0.0, 20.0, plain.image.shape)
    assert elsewhere_by_ends(grey, survey(plain, grey=grey)) is None
    against = elsewhere_by_ends(grey, survey(plain, with_edge(plain.block, 4, by_mm), grey))
    assert against is not None


def test_broken_edges_that_shorten_all_alike_are_no_wrong_size(plain: RenderedBlock) -> None:
    grey = plain.image.astype(float)
    block = plain.block
    outward = np.where(np.arange(len(block.edges_x_mm)) % 2, 0.6, -0.6)
    longer = replace(block, edges_x_mm=tuple(np.array(block.edges_x_mm) + outward))
    assert elsewhere_by_ends(grey, survey(plain, longer, grey)) is None


def test_two_ends_moved_by_different_lengths_give_no_reason(plain: RenderedBlock) -> None:
    grey = covered(plain, "crest:0:R:front")
    found = survey(plain, with_edge(plain.block, 1, 0.9), grey)
    assert elsewhere_by_ends(grey, found) is None


@pytest.mark.parametrize("right", [0, 8])
def test_a_chance_line_does_not_outweigh_edges_that_go_on(plain: RenderedBlock, right: int) -> None:
    claimed = with_edge(plain.block, 1, -1.4)
    grey = striped(replace(plain, block=claimed), "floor:0:L", (8 - right, right), 220.0)
    found = survey(plain, claimed, grey)
    at_mm = claimed.edges_x_mm[1]
    edges = next(e for axis, at, e in planes(found.frame) if (axis, at) == (0, at_mm))
    assert count_in_place(found, edges, 0) == 1
    against = present(elsewhere_by_ends(grey, found))
    assert against.edges == edges


def test_ends_in_place_gainsay_lines_elsewhere(plain: RenderedBlock) -> None:
    grey = plain.image.astype(float)
    ends = measure_ends(grey, survey(plain, grey=grey))
    at_mm = plain.block.edges_x_mm[4]
    assert ends_in_place(ends, at_mm, 1.4)
    assert ends_in_place(ends, at_mm, -1.4)
    # Within what the blur leaves unclear, an end says nothing.
    assert not ends_in_place(ends, at_mm, 0.1)
    wrong = with_edge(plain.block, 4, 1.4)
    found = survey(plain, wrong, grey)
    assert not ends_in_place(measure_ends(grey, found), wrong.edges_x_mm[4], -1.4)
    assert find_wrong_dimension(grey, found, lambda at_mm, by_mm: False) is not None
    assert find_wrong_dimension(grey, found, lambda at_mm, by_mm: True) is None

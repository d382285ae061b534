"""Where edges end tells of a wrong size; a thing that lies over one end does not."""

from dataclasses import replace

import numpy as np
import pytest

from app.metrology.camera import project
from app.metrology.crenellated import Crenellated, corners
from app.metrology.detection.edge_ends import ends_elsewhere
from app.metrology.detection.edge_survey import Survey, survey
from app.metrology.detection.visibility import wireframe
from tests.metrology.rendered_block import Rendered, rendered

BLUR_PX, MADE_MM = 0.7, 0.002


@pytest.fixture(scope="module")
def shown() -> Rendered:
    return rendered(1, merlons=4)


def surveyed(shown: Rendered, grey: np.ndarray, block: Crenellated) -> Survey:
    """The edges of a certificate measured with the camera that took the picture."""
    found = survey(grey, wireframe(block), shown.camera, BLUR_PX, MADE_MM)
    assert found is not None
    return found


def missized(block: Crenellated, edge: int, by_mm: float) -> Crenellated:
    edges = list(block.edges_x_mm)
    edges[edge] += by_mm
    return replace(block, edges_x_mm=tuple(edges))


def covered(shown: Rendered, grey: np.ndarray, corner: str, level: float = 128.0) -> np.ndarray:
    """The picture with a grey square over one of the block's corners; NaN: clipped there."""
    u, v = np.rint(project(shown.camera, corners(shown.block)[corner][None])[0]).astype(int)
    grey = grey.copy()
    grey[v - 14 : v + 15, u - 14 : u + 15] = level
    return grey


def test_a_block_that_is_as_its_certificate_says(shown):
    grey = shown.image.astype(float)
    assert ends_elsewhere(grey, surveyed(shown, grey, shown.block)) is None


@pytest.mark.parametrize("edge", [0, 1, 4, 7])
@pytest.mark.parametrize("by_mm", [-1.4, -0.9, 0.9, 1.4])
def test_the_size_that_is_wrong_is_told_and_by_how_much(shown, edge, by_mm):
    grey = shown.image.astype(float)
    found = surveyed(shown, grey, missized(shown.block, edge, by_mm))
    against = ends_elsewhere(grey, found)
    assert against is not None
    assert against.definite
    wrong = f"crest:{edge // 2}:{'LR'[edge % 2]}"
    assert found.frame.names[against.edges[0]] == wrong
    px_per_mm = against.off_px / abs(by_mm)
    told_mm = float(against.text.split(" mm ")[0].rsplit(" ", 1)[1])
    assert told_mm == pytest.approx(abs(by_mm), abs=2.0 / px_per_mm)


@pytest.mark.parametrize("other_end_shows", [True, False])
def test_a_thing_over_one_corner_is_no_wrong_size(shown, other_end_shows):
    grey = covered(shown, shown.image.astype(float), "crest:1:R:back")
    if not other_end_shows:
        grey = covered(shown, grey, "crest:1:R:front", np.nan)
    assert ends_elsewhere(grey, surveyed(shown, grey, shown.block)) is None


def test_broken_edges_that_shorten_all_alike_are_no_wrong_size(shown):
    grey = shown.image.astype(float)
    block = shown.block
    outward = np.where(np.arange(len(block.edges_x_mm)) % 2, 0.6, -0.6)
    longer = replace(block, edges_x_mm=tuple(np.array(block.edges_x_mm) + outward))
    assert ends_elsewhere(grey, surveyed(shown, grey, longer)) is None


def test_an_edge_that_vanishes_in_what_lies_behind_it_tells_nothing(shown):
    """The whole picture one grey but for noise: there are no ends to be found."""
    grey = shown.image.astype(float)
    found = surveyed(shown, grey, missized(shown.block, 1, 1.4))
    flat = np.random.default_rng(0).normal(100.0, 1.0, grey.shape)
    assert ends_elsewhere(flat, found) is None

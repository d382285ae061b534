"""An edge that lies off alone: left out where it is little, doubtful where it is more."""

from dataclasses import replace

import numpy as np
import pytest

from app.metrology.detection.acceptance import check_measurements
from app.metrology.detection.edges.dimension_test import find_unobserved_planes
from app.metrology.detection.edges.measure_all import EdgeMeasurements, measure_edges
from app.metrology.detection.visibility import wireframe
from tests.metrology.rendered_block import RenderedBlock, render_block

pytestmark = pytest.mark.slow

MADE_MM = 0.002
SIDE = "crest:1:L"


@pytest.fixture(scope="module")
def shown() -> RenderedBlock:
    return render_block(1, merlons=4, azimuth=0.4)


def with_one_edge_off(shown: RenderedBlock, by_px: float) -> EdgeMeasurements:
    """The block's edges, of one side but one, and that moved across itself."""
    grey = shown.image.astype(float)
    found = measure_edges(grey, wireframe(shown.block), shown.camera, 0.7, MADE_MM)
    assert found is not None
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


def test_an_edge_a_little_off_is_left_out_and_its_side_named(shown: RenderedBlock) -> None:
    found = with_one_edge_off(shown, 0.6)
    assert SIDE in np.array(found.frame.names)[found.at.edge[found.used]]
    rest, against = check_measurements(shown.image.astype(float), found, MADE_MM)
    assert against is None
    assert SIDE not in np.array(rest.frame.names)[rest.at.edge[rest.used]]
    assert (0, 2) in find_unobserved_planes(rest)


def test_an_edge_further_off_is_doubtful(shown: RenderedBlock) -> None:
    _, against = check_measurements(
        shown.image.astype(float), with_one_edge_off(shown, 1.4), MADE_MM
    )
    assert against is not None
    assert against.definite

"""Edges that run on beyond where a certificate ends the block, in clear pictures and noisy ones."""

from dataclasses import replace

import numpy as np
import pytest

from app.metrology.detection.edges.edge_overrun import find_overrun
from app.metrology.detection.edges.measure_all import measure_edges
from app.metrology.detection.rejection import RejectionReason
from app.metrology.detection.visibility import wireframe
from app.metrology.targets.crenellated_block import Crenellated
from tests.metrology.rendered_block import RenderedBlock, render_block

MADE_MM = 0.002


@pytest.fixture(scope="module")
def shown() -> RenderedBlock:
    return render_block(1, merlons=4)


def runs_on(shown: RenderedBlock, block: Crenellated, noise: float) -> RejectionReason | None:
    """What is objected to ``block`` in the picture, with so many grey levels of noise added."""
    rng = np.random.default_rng(7)
    grey = shown.image + noise * rng.standard_normal(shown.image.shape)
    found = measure_edges(grey, wireframe(block), shown.camera, 0.7, MADE_MM)
    assert found is not None
    return find_overrun(grey, found)


@pytest.mark.parametrize("noise", [0.0, 15.0, 22.0])
@pytest.mark.parametrize("kept", [slice(2, None), slice(0, -2)])
def test_a_longer_block_is_reported(shown: RenderedBlock, noise: float, kept: slice) -> None:
    shorter = replace(shown.block, edges_x_mm=shown.block.edges_x_mm[kept])
    against = runs_on(shown, shorter, noise)
    assert against is not None
    assert "continues beyond its" in str(against.text)


@pytest.mark.parametrize("noise", [0.0, 15.0, 22.0])
def test_the_block_of_the_certificate_does_not_run_on(shown: RenderedBlock, noise: float) -> None:
    assert runs_on(shown, shown.block, noise) is None

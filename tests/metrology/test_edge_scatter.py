"""What edge points are said to scatter by, and what is left to the block's certificate."""

import numpy as np
import pytest

from app.metrology.detection.edges.scatter import estimate_scatter
from app.metrology.detection.edges.stations import EdgeStations

PARTS, POINTS, SIGMA_PX = 40, 30, 0.02


def on_edges() -> EdgeStations:
    part = np.repeat(np.arange(PARTS), POINTS)
    two = np.zeros((len(part), 2))
    return EdgeStations(
        part, part, np.zeros((len(part), 3)), two, two, two, two[:, 0], two.astype(np.int64), 1.0
    )


@pytest.mark.parametrize(
    ("moved_px", "certificate_px", "least", "most"),
    [(0.0, 0.0, 1.0, 1.3), (0.08, 0.08, 1.0, 12.0), (0.08, 0.0, 15.0, 30.0)],
)
def test_what_the_certificate_moves_is_not_counted_twice(
    moved_px: float, certificate_px: float, least: float, most: float
) -> None:
    rng = np.random.default_rng(4)
    at = on_edges()
    sigma, none = np.full(len(at.part), SIGMA_PX), np.zeros(len(at.part))
    off = sigma * rng.normal(size=len(sigma)) + np.repeat(moved_px * rng.normal(size=PARTS), POINTS)
    used, along, together = estimate_scatter(
        off, at, np.ones(len(off), np.bool_), sigma, none, none + certificate_px
    )
    assert used.mean() > 0.99
    assert along == pytest.approx(1.0, abs=0.15)
    assert least <= np.median(together) <= most

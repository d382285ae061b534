"""The bench of the 3D view, on a short scan."""

import pytest

from app.bench.station.view import PIECE, run, table

pytestmark = [pytest.mark.device, pytest.mark.soak]


def test_a_second_viewer_gets_all_and_the_colours_change() -> None:
    points = 8 * PIECE
    found = run(points)
    assert found.points == points
    assert 50_000 < found.points_displayed <= points
    assert found.join_s > 0
    assert found.join_mb > 15 * found.points_displayed / 2**20
    assert 0 < found.recolour_s < 60
    assert len(table(found)) == 5

"""The laser's line across a lit board: its points lie on it, and say how far off they may be."""

import numpy as np
import pytest

from crenel.metrology.chessboard.lit_line import detect_lit_board
from tests.bench.lit_board_sessions import draw_lit_session


@pytest.mark.slow
@pytest.mark.parametrize("seed", [6, 5, 1], ids=["thin", "clipped", "clipped, small"])
def test_points_of_a_line_across_squares_lie_on_it_and_not_on_edges(seed: int) -> None:
    session = draw_lit_session(seed)
    image = next(session.pictures())
    _, line, _ = detect_lit_board(image, session.board, session.axis)
    off = session.offsets_px(0, line.stripe)
    assert len(off) > 60
    pulls = off / line.stripe.sigma_px
    assert np.median(np.abs(pulls)) < 1.3
    assert np.sqrt(np.mean(np.clip(pulls, -5, 5) ** 2)) < 2.0

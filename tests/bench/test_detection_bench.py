"""The benchmark of the detection judges as it says."""

from dataclasses import replace

import numpy as np
import pytest

from app.bench.metrology.detection import (
    DetectionBench,
    certificate_of,
    corner_errors,
    deceive,
    found_in,
    search,
)
from hardware.simulator.rendering.degradations import Shot, draw_shot

SEED = 3


@pytest.fixture(scope="module")
def shot() -> Shot:
    return draw_shot(SEED)


def test_a_found_block_is_right_and_one_elsewhere_is_wrong(shot: Shot) -> None:
    assert search(shot, SEED).outcome == "right"
    aside = replace(shot.optics, cx_px=shot.optics.cx_px + 2.0)
    assert search(replace(shot, optics=aside), SEED).outcome == "wrong"


def test_errors_are_those_of_the_corners(shot: Shot) -> None:
    found = found_in(shot, certificate_of(shot.certificate))
    errors, _ = corner_errors(found, shot)
    aside = replace(shot.optics, cx_px=shot.optics.cx_px - 2.0)
    moved, sigmas = corner_errors(found, replace(shot, optics=aside))
    assert np.allclose(moved - errors, [2.0, 0.0])
    assert sigmas.min() > 3.0


def test_the_table_counts_every_picture(shot: Shot) -> None:
    one = search(shot, SEED)
    refused = replace(one, outcome="object-unclear")
    bench = DetectionBench([one, refused, replace(one, outcome="wrong")], [deceive(shot, SEED)])
    assert (bench.right, bench.wrong, bench.believed) == (1, 1, 0)
    assert any(line.split()[:5] == ["all", "3", "33.3", "%", "1"] for line in bench.lines())
    assert "refused as object-unclear: 1" in bench.lines()


def test_shadows_that_run_along_hidden_sides_are_no_wrong_size() -> None:
    """A comb of one pitch, its crests as bright as its floors: they end where they should."""
    assert search(draw_shot(5031), 5031).outcome == "right"


def test_a_narrow_merlon_s_wrong_side_is_told_amid_tool_marks() -> None:
    assert not deceive(draw_shot(5111), 5111).accepted


def test_a_wrong_size_that_the_picture_hides_is_named() -> None:
    """Cut off by the frame, and faces alike: merlon 1's right side does not show."""
    found = deceive(draw_shot(5137), 5137)
    assert found.believed
    assert found.named
    assert any("(1 of them with the remark" in line for line in DetectionBench([], [found]).lines())

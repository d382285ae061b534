"""The tip's place told by the adjustment, beside errors of the arm's links."""

from dataclasses import replace

import numpy as np
import pytest

from app.bench.simulated import USUAL, SetUp, Station, drawn, station_of
from app.metrology.adjustment.scales import Scales
from app.metrology.adjustment.solve import Adjusted, adjust
from app.metrology.adjustment.tip_place import about_tip_place, tip_place
from app.metrology.findings import LIMITS
from app.metrology.frames import Floats

IN_PLACE = np.zeros(3)
POOR = replace(USUAL, links_mm=0.03, links_rad=7.5e-5)


def station(poses: int, scales: Scales = USUAL) -> Station:
    return station_of(SetUp("tip", poses, seed=4, scales=scales))


def solved(on: Station, seed: int, off_mm: Floats) -> Adjusted:
    """By an arm's file that has the tip off by (3,) in the flange frame."""
    session = drawn(on, np.random.default_rng(seed))
    touches = session.problem.touches
    assert touches is not None
    moved = replace(touches, tips_mm=touches.tips_mm + touches.R_arm_flange @ off_mm)
    return adjust(replace(session.problem, touches=moved), session.start)


@pytest.mark.parametrize("poses", [1, 6])
@pytest.mark.parametrize("off_mm", [(0.0, 0.0, 0.1), (-0.3, 0.2, 0.0)])
def test_a_tip_off_its_place_is_named_with_where_it_is(
    poses: int, off_mm: tuple[float, float, float]
) -> None:
    found = solved(station(poses), 3, np.array(off_mm))
    told = tip_place(found)
    assert told is not None
    wrong = told.off_mm + off_mm  # the true place is back from the file's
    assert np.all(np.abs(wrong) < 4 * np.sqrt(np.diag(told.covariance_mm2)))
    assert np.all(np.abs(wrong) < 0.05)
    (said,) = about_tip_place(found, LIMITS)
    assert said.code == "tip-place"
    assert said.quality == ("bad" if np.linalg.norm(off_mm) > 0.15 else "attention")


@pytest.mark.parametrize("scales", [USUAL, POOR])
def test_a_tip_in_its_place_is_not_doubted_for_the_arms_errors(scales: Scales) -> None:
    on = station(3, scales)
    for seed in range(20):
        assert not about_tip_place(solved(on, seed, IN_PLACE), LIMITS)


def test_a_poor_arm_does_not_hide_a_tip_far_off() -> None:
    on = station(3, POOR)
    for seed in range(6):
        assert about_tip_place(solved(on, seed, np.array([0.4, 0.3, 0.2])), LIMITS)

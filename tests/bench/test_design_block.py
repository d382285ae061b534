"""Blocks for two random sensors: simulated calibrations are as accurate as was stated."""

from pathlib import Path

import pytest

from tests.bench.design_block import LIMIT, draw_design, measure_sensor
from tests.bench.rows import rms

pytestmark = pytest.mark.slow
SESSIONS = 2
K = 2.0
"""Expanded: the rms of so few sessions scatters."""


@pytest.mark.parametrize("seed", [1, pytest.param(6, marks=pytest.mark.soak)])
def test_calibrations_are_as_accurate_as_stated(seed: int, tmp_path: Path) -> None:
    made_for = draw_design(seed)
    found = measure_sensor(made_for, seed, SESSIONS, tmp_path)
    assert not found.refused
    design = made_for.design
    assert rms(found.one_pose_um) < LIMIT * K * design.one_pose.total_um
    assert rms(found.eight_poses_um) < LIMIT * K * design.eight_poses.total_um
    assert rms(found.eight_claimed_um) < LIMIT * design.eight_poses.total_um

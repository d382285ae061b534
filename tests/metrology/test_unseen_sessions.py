"""Whole sessions of blocks, arms and cameras drawn at random, against their truth."""

from pathlib import Path

import numpy as np
import pytest

from app.formats.session.calibration_session import read_session
from app.metrology.calibration.one_pose import calibrate_one_pose
from app.workflows.calibrate import one_pose_inputs
from hardware.simulator.session import SessionPlan, render_session
from tests.metrology.true_points import Truth
from tests.running.usual import usual

pytestmark = pytest.mark.slow

PLANS = {
    "upside down, seven joints": SessionPlan(joints=7, roll_rad=np.pi),
    "stripe along the rows, both lights": SessionPlan(roll_rad=np.pi / 2, lighting="both"),
    # a column of the picture crosses crests and floors
    "turned by 30 degrees": SessionPlan(roll_rad=np.radians(30)),
    "turned by -35 degrees, both lights": SessionPlan(roll_rad=np.radians(-35), lighting="both"),
    "a barrel of a lens": SessionPlan(distortion=(-0.12, 0.0, 0.0, 0.0, 0.0)),
}


@pytest.mark.parametrize(
    ("seed", "plan"), usual(enumerate(PLANS.values(), 501), {0, 3, 4}, pytest.mark.soak), ids=PLANS
)
def test_points_lie_where_the_light_fell(seed: int, plan: SessionPlan, tmp_path: Path) -> None:
    render_session(tmp_path, seed, plan)
    session = read_session(tmp_path)
    found = calibrate_one_pose(one_pose_inputs(session, session.poses[0]))
    truth = Truth(tmp_path)
    assert truth.sensor_rms_um(found) < 4
    assert truth.flange_rms_um(found) < 3 * found.total_um

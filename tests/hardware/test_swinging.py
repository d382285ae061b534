"""The hand's swing: the tip stays in its seat while the arm goes round it."""

import numpy as np
import pytest

from hardware.twin.kinematics import ArmModel, tip_centre
from hardware.twin.motion import Motion
from hardware.twin.swinging import seat_centre, swing_path, way_into_seat
from hardware.twin.variety import demo_arm, random_arm

ARMS = {
    "demonstration": demo_arm(),
    "six": random_arm(np.random.default_rng(3), 6),
    "seven": random_arm(np.random.default_rng(4), 7),
}


@pytest.mark.parametrize("name", ARMS)
def test_the_tip_stays_in_the_seat_while_the_joints_turn(name: str) -> None:
    arm: ArmModel = ARMS[name]
    rng = np.random.default_rng(0)
    into = way_into_seat(arm, 0, np.full(arm.joint_count, 0.3), rng, 1.0)
    centre = seat_centre(arm, 0)
    np.testing.assert_allclose(tip_centre(arm, into.q_rad[-1]), centre, atol=1e-5)
    assert tip_centre(arm, into.q_rad[0])[2] == pytest.approx(centre[2] + 25.0, abs=1e-4)
    path = swing_path(arm, into.q_rad[-1], rng)
    motion = Motion(into.q_rad[-1])
    end_ns = motion.play(path, 0)
    q = motion.at_all(np.linspace(0, end_ns, 800).astype(np.int64))
    off_mm = np.linalg.norm([tip_centre(arm, one) - centre for one in q], axis=1)
    assert off_mm.max() < 0.02
    assert np.ptp(q, axis=0).max() > np.radians(60)
    limits = arm.limits_rad
    assert np.all((q > limits[:, 0]) & (q < limits[:, 1]))

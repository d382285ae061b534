"""The simulated operator's swing: the tip stays in its seat while the arm goes round it."""

import numpy as np
import pytest

from crenel_hardware.simulator.devices.kinematics import ArmModel, tip_centre
from crenel_hardware.simulator.devices.motion import Motion
from crenel_hardware.simulator.operator.swinging import (
    BAR_MM,
    BARS,
    bar_end,
    path_into_seat,
    path_onto_sphere,
    seat_centre,
    swing_path,
)
from crenel_hardware.simulator.scene.random_scenes import demo_arm, random_arm

pytestmark = pytest.mark.slow

ARMS = {
    "demonstration": demo_arm(),
    "six": random_arm(np.random.default_rng(3), 6),
    "seven": random_arm(np.random.default_rng(4), 7),
}


@pytest.mark.parametrize("name", ARMS)
def test_the_tip_stays_in_the_seat_while_the_joints_turn(name: str) -> None:
    arm: ArmModel = ARMS[name]
    rng = np.random.default_rng(0)
    centre = seat_centre(arm, 0)
    into = path_into_seat(arm, centre, np.full(arm.joint_count, 0.3), rng, 1.0)
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


@pytest.mark.parametrize("position", range(len(BARS)))
def test_the_bars_ends_are_its_length_apart_and_the_arm_swings_in_both(position: int) -> None:
    arm: ArmModel = ARMS["demonstration"]
    ends = [bar_end(arm, position, end) for end in (0, 1)]
    assert np.linalg.norm(ends[1] - ends[0]) == pytest.approx(BAR_MM)
    for centre in ends:
        into = path_into_seat(
            arm, centre, np.full(arm.joint_count, 0.3), np.random.default_rng(0), 1.0
        )
        np.testing.assert_allclose(tip_centre(arm, into.q_rad[-1]), centre, atol=1e-5)


def test_the_ball_is_touched_all_over_its_top_and_from_outside() -> None:
    arm: ArmModel = ARMS["demonstration"]
    rng = np.random.default_rng(0)
    ball, radius_mm = seat_centre(arm, 1), 15.0
    q = np.full(arm.joint_count, 0.3)
    touched = []
    for index in range(12):
        onto = path_onto_sphere(arm, ball, radius_mm, index, q, rng)
        far = [float(np.linalg.norm(tip_centre(arm, one) - ball)) for one in onto.q_rad]
        assert far[-1] == pytest.approx(radius_mm, abs=1e-4)
        assert min(far) > radius_mm - 1e-3
        assert far[0] > radius_mm + 5
        touched.append(tip_centre(arm, onto.q_rad[-1]) - ball)
        q = onto.q_rad[-1]
    assert np.linalg.matrix_rank(np.array(touched) / radius_mm, tol=0.5) == 3

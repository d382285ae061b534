"""The daily check: figures along the axes and in space, the verdict, and what is refused."""

from dataclasses import replace

import numpy as np
import pytest

from crenel.metrology.arm.identification.articulation import (
    ArticulationLimits,
    articulation_verdict,
    check_articulation,
    tip_spread_um,
)
from crenel.metrology.arm.kinematics import tip_centres
from tests.metrology.arm_sessions import collect_observations, nominal_arm
from tests.metrology.refusals import refusal_of
from tests.simulated_arm_sessions import ArmSessionPlan, SimulatedArmSession, draw_arm_session


@pytest.fixture(scope="module")
def session() -> SimulatedArmSession:
    plan = ArmSessionPlan(seats=2, points_per_seat=200, spheres=0, bar_lengths_mm=())
    return draw_arm_session(8, replace(plan, imperfection_um=0.0, touch_sd_mm=0.0))


def test_a_perfect_arm_shows_its_encoders_noise_alone(session: SimulatedArmSession) -> None:
    arm = nominal_arm(session.nominal_arm)
    for seat in collect_observations(session).seats:
        found = check_articulation(arm, seat.q_rad)
        assert found.points == 200
        np.testing.assert_allclose(found.two_sigma_um, found.encoders_two_sigma_um, rtol=0.2)
        np.testing.assert_allclose(found.centre_mm, tip_centres(arm, seat.q_rad).mean(axis=0))
        assert found.verdict == "none"


def test_the_figures_in_space_are_those_of_the_standard(session: SimulatedArmSession) -> None:
    arm = nominal_arm(session.nominal_arm)
    seat = collect_observations(session).seats[0]
    found = check_articulation(arm, seat.q_rad)
    tips = tip_centres(arm, seat.q_rad)
    away = 1e3 * np.linalg.norm(tips - tips.mean(axis=0), axis=1)
    assert found.largest_um == pytest.approx(away.max())
    assert found.two_s_um == pytest.approx(2 * np.sqrt(np.sum(away**2) / (len(away) - 1)))
    # 2 s over all axes together is the root sum of squares of those along the axes
    assert found.two_s_um == pytest.approx(np.linalg.norm(found.two_sigma_um))
    assert found.largest_um > found.half_range_um.max()


def test_the_figures_along_the_axes_are_half_range_and_two_sigma() -> None:
    tips = np.array([[0.0, 0.0, 1.0], [0.03, 0.0, 1.0], [0.01, -0.02, 1.0]])
    half_range, two_sigma = tip_spread_um(tips)
    np.testing.assert_allclose(half_range, [15.0, 10.0, 0.0])
    np.testing.assert_allclose(two_sigma, 2e3 * np.std(tips, axis=0, ddof=1))


@pytest.mark.parametrize(
    ("limits", "verdict"),
    [
        (ArticulationLimits(), "none"),
        (ArticulationLimits(20.0), "pass"),
        (ArticulationLimits(14.9), "fail"),
        (ArticulationLimits(None, 35.0), "pass"),
        (ArticulationLimits(20.0, 29.0), "fail"),
    ],
)
def test_every_axis_keeps_every_limit_that_is_set(limits: ArticulationLimits, verdict: str) -> None:
    half_range, two_sigma = np.array([15.0, 10.0, 3.0]), np.array([20.0, 30.0, 5.0])
    assert articulation_verdict(half_range, two_sigma, limits) == verdict


def test_few_points_and_an_arm_that_hardly_moved_are_refused(session: SimulatedArmSession) -> None:
    arm, seat = nominal_arm(session.nominal_arm), collect_observations(session).seats[0]
    few, still = seat.q_rad[:9], np.repeat(seat.q_rad[:1], 30, axis=0)
    assert refusal_of(check_articulation, arm, few, label="set 1").code == "too-few-points"
    refusal = refusal_of(check_articulation, arm, still, label="set 1")
    assert refusal.code == "arm-hardly-moved"
    assert "set 1" in str(refusal.what)

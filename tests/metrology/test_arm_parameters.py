"""The arm's parameters as a vector: exact derivatives, and which of them can be estimated."""

from dataclasses import replace

import numpy as np
import pytest

from crenel.metrology.arm.identification.initial_unknowns import initial_unknowns
from crenel.metrology.arm.identification.least_squares import reduce_system, settle_centres
from crenel.metrology.arm.identification.observations import ArmObservations
from crenel.metrology.arm.identification.parameter_selection import (
    candidates,
    parameter_limits,
    select_parameters,
)
from crenel.metrology.arm.identification.parameters import (
    parameter_names,
    parameter_values,
    tip_jacobian,
    with_parameters,
)
from crenel.metrology.arm.identification.scatter import Scatter
from crenel.metrology.arm.kinematics import Arm, tip_centres, tip_covariances
from crenel_hardware.simulator.devices.kinematics import ArmLink, ArmModel
from tests.metrology.arm_sessions import collect_observations, nominal_arm
from tests.metrology.builders import random_arm
from tests.metrology.numerics import differences
from tests.simulated_arm_sessions import ArmSessionPlan, draw_arm_session

RIGHT = np.pi / 2


@pytest.mark.parametrize("joints", [6, 7])
def test_every_derivative_agrees_with_numerical_differences(joints: int) -> None:
    rng = np.random.default_rng(joints)
    arm = random_arm(rng, joints, with_errors=True)
    q = rng.uniform(-3, 3, (4, joints))
    tips, J = tip_jacobian(arm, q)
    np.testing.assert_allclose(tips, tip_centres(arm, q), atol=1e-9)
    values = parameter_values(arm)
    assert J.shape == (4, 3, len(values)) == (4, 3, len(parameter_names(arm)))
    steps = [1e-6 if name.endswith("_rad") else 1e-3 for name in parameter_names(arm)]
    slopes = differences(lambda by: tip_centres(with_parameters(arm, values + by), q), steps)
    np.testing.assert_allclose(J, slopes, atol=2e-4)


def test_the_vector_holds_the_whole_geometry() -> None:
    arm = random_arm(np.random.default_rng(3), 7, with_errors=True)
    assert with_parameters(arm, parameter_values(arm)) == arm
    assert len(set(parameter_names(arm))) == 73


def test_the_encoders_noise_is_that_of_the_arm() -> None:
    rng = np.random.default_rng(5)
    arm = random_arm(rng, 6, with_errors=True)
    q = rng.uniform(-3, 3, (10, 6))
    turning = [i for i, name in enumerate(parameter_names(arm)) if name.endswith(".theta_rad")]
    by_encoders = tip_jacobian(arm, q)[1][:, :, turning] * arm.encoder_sd_rad
    covariances = by_encoders @ by_encoders.mT
    np.testing.assert_allclose(covariances, tip_covariances(arm, q), rtol=1e-9, atol=1e-18)


def layout(*links: tuple[float, float, float]) -> ArmModel:
    """An arm of links (a, alpha in quarter turns, d), its tip well off the last axis."""
    return ArmModel(
        tuple(ArmLink(a, quarter * RIGHT, d, 0.3 * i) for i, (a, quarter, d) in enumerate(links)),
        tip_mm=(25.0, -30.0, 150.0),
        tip_diameter_mm=4.0,
    )


LAYOUTS = {
    "elbow": layout((0, -1, 300), (560, 0, 0), (30, -1, 0), (0, 1, 500), (0, -1, 0), (0, 0, 80)),
    "three parallel": layout(
        (0, 1, 150), (420, 0, 0), (390, 0, 0), (0, 1, 130), (0, -1, 100), (0, 0, 90)
    ),
    "spherical shoulder": layout(
        (0, -1, 300), (0, 1, 0), (0, -1, 600), (35, 1, 0), (-35, -1, 520), (0, 1, 0), (0, 0, 80)
    ),
    "parallel of seven": layout(
        (0, -1, 300), (550, 0, 0), (0, 1, 0), (0, -1, 420), (0, 1, 0), (0, -1, 100), (0, 0, 80)
    ),
}
SMALL = ArmSessionPlan(
    points_per_seat=16,
    spheres=1,
    points_per_sphere=16,
    bar_lengths_mm=(600.0,),
    positions_per_bar=5,
    points_per_end=3,
)


def exact_session(seed: int, model: ArmModel, seats: int = 6) -> ArmObservations:
    plan = replace(SMALL, imperfection_um=0.0, seats=seats)
    return collect_observations(draw_arm_session(seed, plan, model))


def chosen(arm: Arm, observations: ArmObservations) -> set[str]:
    data = observations.stacked
    everything, scatter = np.ones(data.points), Scatter(touch_mm=0.01)
    at = settle_centres(data, initial_unknowns(arm, data), everything, scatter)
    choice = candidates(arm, bool(observations.bars))
    system = reduce_system(data, at, choice.order, everything, scatter)
    limits = parameter_limits(arm, choice.order)
    moved, held = select_parameters(system.rows, system.others, choice.order, limits)
    names = parameter_names(arm)
    assert {*moved.tolist(), *held, *choice.fixed} == set(range(len(names)))
    return {names[i] for i in moved}


@pytest.mark.parametrize("name", LAYOUTS)
def test_as_many_parameters_move_as_a_chain_has(name: str) -> None:
    """4 a joint; 4 less for the flange, 2 less for the base, 3 more for the tip."""
    model = LAYOUTS[name]
    arm = nominal_arm(model)
    moved = chosen(arm, exact_session(4, model))
    assert len(moved) == 4 * model.joint_count - 3
    assert {"tip.x_mm", "tip.y_mm", "tip.z_mm"} <= moved
    last = arm.joints[-1].name
    assert not moved & {"J1.d_mm", "J1.theta_rad", f"{last}.a_mm", f"{last}.theta_rad"}


@pytest.mark.parametrize("name", LAYOUTS)
def test_parallel_axes_are_described_by_an_error_term(name: str) -> None:
    model = LAYOUTS[name]
    moved = chosen(nominal_arm(model), exact_session(4, model))
    parallel = [i for i, link in enumerate(model.links[:-1]) if link.alpha_rad == 0]
    assert {n for n in moved if ".error." in n} == {f"J{i + 1}.error.ry_rad" for i in parallel}
    for i in parallel:  # of the two d along parallel axes one is redundant
        assert not {f"J{i + 1}.d_mm", f"J{i + 2}.d_mm"} <= moved


def test_without_a_length_the_longest_link_holds_the_scale() -> None:
    arm = nominal_arm(LAYOUTS["elbow"])
    moved = chosen(arm, ArmObservations(exact_session(4, LAYOUTS["elbow"], seats=9).seats))
    assert "J2.a_mm" not in moved
    assert len(moved) == 4 * 6 - 4
    assert "scale" in candidates(arm, with_lengths=False).fixed.values()


def test_a_tip_on_the_last_axis_shows_nothing_of_that_joint() -> None:
    model = replace(LAYOUTS["elbow"], tip_mm=(0.0, 0.0, 150.0))
    moved = chosen(nominal_arm(model), exact_session(4, model))
    assert len(moved) == 4 * 6 - 3 - 2
    assert len(moved & {"J5.a_mm", "J5.alpha_rad", "J5.d_mm", "J5.theta_rad"}) == 2


def test_joints_that_stand_still_show_nothing_of_their_links() -> None:
    model = LAYOUTS["elbow"]
    session = exact_session(1, model)
    for seat in session.seats:
        seat.q_rad[:, 3:] = 0.4
    moved = chosen(nominal_arm(model), ArmObservations(session.seats))
    # what is behind the third joint is one rigid body: three coordinates of the tip
    assert not any(name.startswith(("J4", "J5", "J6")) for name in moved)
    assert len(moved) <= 4 * 3 - 3

"""The arm identified: truth found, uncertainty honest, errors fall, bad points refused."""

import re
from dataclasses import replace

import numpy as np
import pytest

from crenel.metrology.arm.identification.identify import Identification, identify
from crenel.metrology.arm.identification.observations import ArmObservations
from crenel.metrology.arm.identification.parameter_selection import candidates
from crenel.metrology.arm.identification.parameters import parameter_values
from crenel.metrology.arm.identification.robust_solve import fit_arm
from crenel.metrology.arm.kinematics import Arm, tip_covariances
from crenel.metrology.transforms import Floats
from tests.metrology.arm_sessions import (
    collect_observations,
    fresh_poses,
    length_errors_um,
    nominal_arm,
    volumetric_error_um,
)
from tests.metrology.refusals import refusal_of
from tests.refusals import refused_as
from tests.running.usual import usual
from tests.simulated_arm_sessions import ArmSessionPlan, SimulatedArmSession, draw_arm_session
from tests.uncertainty_ratio import EXACT, ratio_of_rms

pytestmark = pytest.mark.slow

PLAN = ArmSessionPlan(
    seats=7,
    points_per_seat=20,
    spheres=2,
    points_per_sphere=18,
    bar_lengths_mm=(500.0, 850.0),
    positions_per_bar=3,
    points_per_end=3,
)


@pytest.fixture(scope="module")
def session() -> SimulatedArmSession:
    return draw_arm_session(11, PLAN)


@pytest.fixture(scope="module")
def arm(session: SimulatedArmSession) -> Arm:
    """As its datasheet has it."""
    return nominal_arm(session.nominal_arm)


@pytest.fixture(scope="module")
def good(session: SimulatedArmSession) -> ArmObservations:
    """Everything that was touched."""
    return collect_observations(session)


@pytest.fixture(scope="module")
def identified(arm: Arm, good: ArmObservations) -> Identification:
    return identify(arm, good)


@pytest.mark.parametrize("joints", usual([7, 6], 1, pytest.mark.soak))
def test_perfect_points_give_the_true_arm(joints: int) -> None:
    exact = replace(PLAN, joints=joints, touch_sd_mm=0.0, bar_sd_mm=0.0, encoder_noise=False)
    session = draw_arm_session(20 + joints, exact)
    arm = nominal_arm(session.nominal_arm)
    assert volumetric_error_um(session.arm, arm) > 150
    result = identify(arm, collect_observations(session))
    assert volumetric_error_um(session.arm, result.arm) < 0.5
    assert result.outliers == ()


@pytest.mark.parametrize("seed", usual(range(6), 2, pytest.mark.soak))
def test_a_250_um_arm_falls_to_its_encoders_noise(seed: int) -> None:
    session = draw_arm_session(100 + seed, replace(PLAN, joints=6 + seed % 2))
    arm = nominal_arm(session.nominal_arm)
    result = identify(arm, collect_observations(session))
    before, after = (volumetric_error_um(session.arm, a) for a in (arm, result.arm))
    q = fresh_poses(session.arm)
    noise_um = 1e3 * np.sqrt(np.mean(np.trace(tip_covariances(arm, q), axis1=1, axis2=2)))
    assert after < noise_um
    assert after < before / 20
    assert length_errors_um(session.arm, result.arm) < length_errors_um(session.arm, arm) / 20
    # what the result says of itself
    assert result.volume_before_mm * 1e3 == pytest.approx(before, rel=0.25)
    assert after < 3 * result.volume_after_mm * 1e3
    assert result.validation.ratio > 5
    assert 0.8 < result.validation.after.normalised < 1.2
    assert len(result.outliers) <= 1


def noisy(observations: ArmObservations, arm: Arm, rng: np.random.Generator) -> ArmObservations:
    """The same touches read by noisy encoders, the bars' lengths off their certificates."""

    def read(q: Floats) -> Floats:
        return np.asarray(q + rng.normal(0, 1, q.shape) * arm.encoder_sd_rad)

    off_mm = rng.normal(0, 0.003)
    return ArmObservations(
        tuple(replace(seat, q_rad=read(seat.q_rad)) for seat in observations.seats),
        tuple(replace(sphere, q_rad=read(sphere.q_rad)) for sphere in observations.spheres),
        tuple(
            replace(
                bar,
                length_mm=bar.length_mm + off_mm,
                q_rad=(read(bar.q_rad[0]), read(bar.q_rad[1])),
            )
            for bar in observations.bars
        ),
    )


@pytest.mark.parametrize("joints", usual([7, 6], 1, pytest.mark.soak))
def test_noisy_solves_scatter_as_the_covariance_says(joints: int) -> None:
    plan = ArmSessionPlan(
        joints=joints,
        seats=5,
        points_per_seat=14,
        spheres=2,
        points_per_sphere=15,
        bar_lengths_mm=(700.0,),
        positions_per_bar=5,
        points_per_end=3,
        touch_sd_mm=0.0,
        bar_sd_mm=0.003,
        encoder_noise=False,
    )
    session = draw_arm_session(joints, plan)
    arm, exact = nominal_arm(session.nominal_arm), collect_observations(session)
    rng, choice = np.random.default_rng(1), candidates(arm, with_lengths=True)
    columns = fit_arm(arm, noisy(exact, arm, rng).stacked, choice).moved
    fits = [fit_arm(arm, noisy(exact, arm, rng).stacked, choice, columns) for _ in range(18)]
    values = np.array([parameter_values(fit.at.arm)[columns] for fit in fits])
    covariance = np.mean([fit.covariance for fit in fits], axis=0)
    whitened = np.linalg.solve(np.linalg.cholesky(covariance), (values - values.mean(axis=0)).T)
    freedom = (len(fits) - 1) * len(columns)
    observed = float(np.sqrt(np.sum(whitened**2) / freedom))
    ratio_of_rms(1.0, observed, freedom).assert_within(*EXACT, k=2.5)


def test_the_touch_noise_is_found(identified: Identification) -> None:
    assert identified.scatter.touch_mm == pytest.approx(0.003, abs=0.0015)
    rough = draw_arm_session(11, replace(PLAN, touch_sd_mm=0.02))
    result = identify(nominal_arm(rough.nominal_arm), collect_observations(rough))
    assert result.scatter.touch_mm == pytest.approx(0.02, rel=0.15)


def test_a_separate_set_shows_the_improvement(arm: Arm, good: ArmObservations) -> None:
    fitted, check = good.part([0, 1, 2, 3, 4, 7, 9, 10, 12, 13]), good.part([5, 6, 8, 11, 14])
    result = identify(arm, fitted, check)
    assert result.validation.separate
    assert result.validation.places == 5
    assert result.validation.ratio > 5


def test_seats_alone_keep_the_nominal_scale(
    session: SimulatedArmSession, arm: Arm, good: ArmObservations
) -> None:
    result = identify(arm, ArmObservations(good.seats))
    assert any("ball bar" in str(text) for text in result.warnings)
    assert [held.name for held in result.fixed if held.reason == "scale"]
    before, after = (volumetric_error_um(session.arm, a) for a in (arm, result.arm))
    assert after < before
    assert result.validation.ratio > 5


def test_an_arm_that_is_right_is_left_alone() -> None:
    session = draw_arm_session(30, replace(PLAN, imperfection_um=0.0))
    arm = nominal_arm(session.nominal_arm)
    refusal = refusal_of(identify, arm, collect_observations(session))
    assert refusal.code == "identification-no-better"
    assert "already" in str(refusal.why)


def with_seat(good: ArmObservations, at: int, q_rad: Floats) -> ArmObservations:
    """The same with other angles of one seat."""
    seats = [*good.seats]
    seats[at] = replace(seats[at], q_rad=q_rad)
    return replace(good, seats=tuple(seats))


def test_bad_points_are_named_and_do_no_harm(
    session: SimulatedArmSession, arm: Arm, good: ArmObservations
) -> None:
    seat, sphere = good.seats[2], good.spheres[1]
    q_seat, q_sphere = seat.q_rad.copy(), sphere.q_rad.copy()
    q_seat[4, 1] += 0.002
    q_sphere[6, 2] -= 0.003
    spheres = (good.spheres[0], replace(sphere, q_rad=q_sphere))
    result = identify(arm, replace(with_seat(good, 2, q_seat), spheres=spheres))
    named = {(str(outlier.place), outlier.number) for outlier in result.outliers}
    assert {(f"seat {seat.name}", 5), (f"sphere {sphere.name}", 7)} <= named
    assert len(named) <= 3
    assert volumetric_error_um(session.arm, result.arm) < 10


def test_points_of_which_one_is_off_are_named(arm: Arm, good: ArmObservations) -> None:
    bar = good.bars[0]
    q_end = bar.q_rad[0][:2].copy()
    q_end[1, 1] += 0.001
    bars = (replace(bar, q_rad=(q_end, bar.q_rad[1])), *good.bars[1:])
    result = identify(arm, replace(good, bars=bars))
    assert not result.outliers
    (warning,) = result.warnings
    assert re.search(
        r"one of these points is off.* end A, point 1;.* end A, point 2\.", str(warning)
    )


@pytest.mark.parametrize("moved_um", usual([150, 2000], 1, pytest.mark.soak))
def test_a_seat_that_moved_is_refused(arm: Arm, good: ArmObservations, moved_um: float) -> None:
    # the same postures, the base turned a little: the tip lies elsewhere from then on
    q, distance_mm = good.seats[3].q_rad.copy(), 600.0
    q[12:, 0] += moved_um * 1e-3 / distance_mm
    with refused_as("seat-moved", "1 to 12", where=good.seats[3].name):
        identify(arm, with_seat(good, 3, q))


def test_points_of_two_seats_under_one_name_are_refused(arm: Arm, good: ArmObservations) -> None:
    mixed = np.concatenate([good.seats[0].q_rad[:10], good.seats[1].q_rad[:10]])
    one_name = replace(good, seats=(replace(good.seats[0], q_rad=mixed),))
    refusal = refusal_of(identify, arm, one_name)
    assert refusal.code in ("seat-moved", "place-disagrees")
    assert good.seats[0].name in str(refusal.what)


def test_a_wrong_tip_diameter_is_seen_in_the_spheres(arm: Arm, good: ArmObservations) -> None:
    wrong = replace(arm, tip=replace(arm.tip, diameter_mm=arm.tip.diameter_mm + 1.0))
    refusal = refusal_of(identify, wrong, good)
    assert refusal.code == "tip-diameter"
    (reported,) = re.findall(r"diameter is probably ([\d.]+) mm", str(refusal.why))
    assert float(reported) == pytest.approx(arm.tip.diameter_mm, abs=0.02)


def test_an_arm_that_hardly_moved_is_refused(arm: Arm, good: ArmObservations) -> None:
    q = good.seats[0].q_rad[0] + np.random.default_rng(0).normal(0, 0.01, (12, 6))
    still = replace(good, seats=(*good.seats[1:], replace(good.seats[0], q_rad=q)))
    assert refusal_of(identify, arm, still).code == "arm-hardly-moved"


@pytest.mark.parametrize(("part", "code"), [([0, 1], "too-few-places"), ([0, 1, 2, 3], "too-few")])
def test_too_little_is_refused(arm: Arm, good: ArmObservations, part: list[int], code: str) -> None:
    few = good.part(part)
    few = replace(few, seats=tuple(replace(s, q_rad=s.q_rad[:5]) for s in few.seats))
    assert refusal_of(identify, arm, few).code.startswith(code)


def test_angles_of_another_arm_are_refused(arm: Arm, good: ArmObservations) -> None:
    other = draw_arm_session(12, replace(PLAN, seats=1, spheres=0, bar_lengths_mm=()))
    refusal = refusal_of(identify, nominal_arm(other.nominal_arm), good)
    assert refusal.code == "arm-does-not-fit"
    joints = list(arm.joints)
    joints[3] = replace(joints[3], sign=-joints[3].sign)
    assert refusal_of(identify, replace(arm, joints=tuple(joints)), good).remedy


def test_a_wrong_length_of_a_bar_is_found_by_the_others(arm: Arm, good: ArmObservations) -> None:
    bars = tuple(replace(b, length_mm=b.length_mm + (b.name == "B2") * 0.5) for b in good.bars)
    refusal = refusal_of(identify, arm, replace(good, bars=bars))
    assert refusal.code == "bar-length"
    assert "bar B2" in str(refusal.what)

    def only(length_mm: float) -> ArmObservations:
        wrong = tuple(replace(b, length_mm=length_mm) for b in bars if b.name == "B2")
        return replace(good, bars=wrong)

    result = identify(arm, replace(only(851.5), spheres=()))
    assert any("bar B2" in str(text) for text in result.warnings)
    # spheres show it, too: they are seen larger with the whole arm
    assert "bar's length" in str(refusal_of(identify, arm, only(852.5)).why)


def test_a_joint_that_reads_the_same_everywhere_is_refused(arm: Arm, good: ArmObservations) -> None:
    def stuck(q: Floats) -> Floats:
        return np.column_stack([q[:, :5], np.full(len(q), 0.5)])

    bad = ArmObservations(tuple(replace(s, q_rad=stuck(s.q_rad)) for s in good.seats))
    refusal = refusal_of(identify, arm, bad)
    assert refusal.code == "joint-still"
    assert "J6" in str(refusal.what)


def test_the_same_points_again_are_refused(arm: Arm, good: ArmObservations) -> None:
    assert refusal_of(identify, arm, ArmObservations((good.seats[0],) * 5)).code == "points-twice"


def test_a_new_tip_is_found(session: SimulatedArmSession, arm: Arm, good: ArmObservations) -> None:
    other = replace(arm, tip=replace(arm.tip, x_mm=arm.tip.x_mm + 20, z_mm=arm.tip.z_mm - 25))
    result = identify(other, good)
    assert volumetric_error_um(session.arm, result.arm) < 10
    assert any("tip.z_mm changes" in str(text) for text in result.warnings)


def test_the_arms_reach_decides_what_the_covariance_is_worth(
    arm: Arm, good: ArmObservations, identified: Identification
) -> None:
    less = identify(arm, good.part([0, 2, 4, 5, 7, 9, 12, 13]))
    assert less.volume_after_mm > identified.volume_after_mm


def test_one_sphere_of_another_size_is_named(
    arm: Arm, good: ArmObservations, identified: Identification
) -> None:
    def with_wrong(by_mm: float) -> ArmObservations:
        wrong = replace(good.spheres[0], diameter_mm=good.spheres[0].diameter_mm + by_mm)
        return replace(good, spheres=(wrong, *good.spheres[1:]))

    refusal = refusal_of(identify, arm, with_wrong(0.2))
    assert refusal.code == "sphere-diameter"
    assert "sphere K" in str(refusal.what)
    assert refusal_of(identify, arm, with_wrong(-1.0)).code == "sphere-diameter"
    assert not any("sphere" in str(text) for text in identified.warnings)


def test_a_length_in_another_unit_is_recognised(arm: Arm, good: ArmObservations) -> None:
    metres = tuple(replace(bar, length_mm=bar.length_mm / 1000) for bar in good.bars)
    refusal = refusal_of(identify, arm, replace(good, bars=metres))
    assert refusal.code == "bar-length"
    assert "millimetres" in str(refusal.remedy)


def test_spheres_and_nominals_outvote_a_single_bar(arm: Arm, good: ArmObservations) -> None:
    only = tuple(replace(b, length_mm=b.length_mm + 1.2) for b in good.bars if b.name == "B2")
    refusal = refusal_of(identify, arm, replace(good, bars=only))
    assert refusal.code == "bar-length"
    assert "bar B2" in str(refusal.what)


def test_points_of_the_fit_do_not_check_it(arm: Arm, good: ArmObservations) -> None:
    check = replace(good, seats=(), bars=())
    assert refusal_of(identify, arm, good, check).code == "check-seen"


def test_strongly_correlated_parameters_are_named(arm: Arm, good: ArmObservations) -> None:
    result = identify(arm, good.part([0, 1, 2, 3, 4, 5, 6]))
    moved = {one.name for one in result.changes}
    strengths = [abs(rho) for _, _, rho in result.correlations]
    assert strengths == sorted(strengths, reverse=True)
    assert all({first, second} <= moved for first, second, _ in result.correlations)

"""Robots identified from what a laser tracker measured: as good as least squares can be, honest."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from scipy.optimize import least_squares

from crenel.metrology.arm.identification.coordinate_rows import (
    coordinate_residuals,
    coordinate_rows,
)
from crenel.metrology.arm.identification.identify import Identification, identify
from crenel.metrology.arm.identification.initial_unknowns import initial_unknowns
from crenel.metrology.arm.identification.least_squares import apply_change, reduce_system
from crenel.metrology.arm.identification.observations import BASE, ArmObservations, Coordinates
from crenel.metrology.arm.identification.parameter_selection import candidates_of
from crenel.metrology.arm.identification.parameters import (
    parameter_names,
    parameter_values,
    with_parameters,
)
from crenel.metrology.arm.identification.robust_solve import fit_arm
from crenel.metrology.arm.identification.scatter import Scatter
from crenel.metrology.arm.kinematics import Arm, Tip, tip_centres
from crenel.metrology.transforms import (
    Floats,
    apply,
    inverse,
    rigid_fit,
    se3_exp,
    vector_from_rotation,
)
from tests.metrology.numerics import differences, rms_length
from tests.metrology.refusals import refusal_of
from tests.present import present
from tests.refusals import refused_as
from tests.running.usual import usual
from tests.simulated_robots import Tracker, ball_bar, built, measure, postures, robot, swing
from tests.uncertainty_ratio import EXACT, ratio_of_rms

pytestmark = pytest.mark.slow

REFLECTOR = Tip(-40.0, 60.0, 25.0, 1.0)


def plain_least_squares(arm: Arm, found: Coordinates, names: list[str]) -> tuple[Arm, Floats]:
    """The arm and the tracker's frame by least squares of the same parameters, without weights."""
    moved = [parameter_names(arm).index(name) for name in names]
    given = parameter_values(arm)
    start = rigid_fit(found.points_mm, tip_centres(arm, found.q_rad))

    def unpacked(x: Floats) -> tuple[Arm, Floats]:
        values = given.copy()
        values[moved] += x[6:]
        return with_parameters(arm, values), np.asarray(se3_exp(x[:6]) @ start)

    def off(x: Floats) -> Floats:
        changed, T = unpacked(x)
        return np.asarray((apply(T, tip_centres(changed, found.q_rad)) - found.points_mm).ravel())

    return unpacked(least_squares(off, np.zeros(6 + len(moved)), x_scale="jac").x)


@dataclass(frozen=True)
class Measured:
    """A robot by its datasheet and as it is built, and a tracker beside it."""

    rng: np.random.Generator
    arm: Arm
    true: Arm
    tracker: Tracker

    def exact(self, count: int) -> Coordinates:
        """Points without noise to check a fit by."""
        tracker = replace(self.tracker, sd_mm=0.0)
        return measure(self.true, postures(self.arm, count, self.rng), tracker, self.rng)


Session = tuple[Measured, Coordinates]


def drawn(seed: int, axes: int = 6) -> Measured:
    rng = np.random.default_rng(seed)
    arm = robot(axes)
    return Measured(rng, arm, built(arm, rng), Tracker.somewhere(rng))


def held_out_mm(arm: Arm, T_tracker_arm: Floats, check: Coordinates) -> float:
    """Rms distance of points that no fit has seen."""
    return rms_length(apply(T_tracker_arm, tip_centres(arm, check.q_rad)) - check.points_mm)


def identified(arm: Arm, *found: Coordinates) -> Identification:
    return identify(arm, ArmObservations(coordinates=found))


@pytest.mark.parametrize("axes", usual([7, 6], 1, pytest.mark.soak))
@pytest.mark.parametrize("poses", usual([50, 200], 1, pytest.mark.soak))
def test_as_good_as_least_squares_on_the_same_coordinates(axes: int, poses: int) -> None:
    case = drawn(axes * poses, axes)
    arm = case.arm
    found = measure(case.true, postures(arm, poses, case.rng), case.tracker, case.rng)
    check = case.exact(400)
    result = identified(arm, found)
    peer, T = plain_least_squares(arm, found, [one.name for one in result.changes])
    ours = held_out_mm(result.arm, result.frames[0].T_frame_arm, check)
    assert ours < 1.03 * held_out_mm(peer, T, check)
    assert ours < 0.05
    given = rigid_fit(check.points_mm, tip_centres(arm, check.q_rad))
    assert ours < held_out_mm(arm, given, check) / 15
    assert result.outliers == ()
    assert result.size_known
    left = present(result.validation.after.coordinates_um)
    assert left / 1e3 == pytest.approx(np.sqrt(3) * 0.05, rel=0.35)


def test_wrong_points_are_named_and_do_no_harm() -> None:
    case = drawn(3)
    arm, q = case.arm, postures(case.arm, 80, case.rng)
    bad = measure(case.true, q, case.tracker, np.random.default_rng(1), outliers=6)
    good = measure(case.true, q, case.tracker, np.random.default_rng(1))
    wrong = np.flatnonzero(np.linalg.norm(bad.points_mm - good.points_mm, axis=1) > 1.0)
    result = identified(arm, bad)
    assert {one.number for one in result.outliers} == {bad.lines[i] for i in wrong}
    right = good.part(~np.isin(np.arange(80), wrong))
    peer, T = plain_least_squares(arm, right, [one.name for one in result.changes])
    check = case.exact(300)
    ours = held_out_mm(result.arm, result.frames[0].T_frame_arm, check)
    assert ours < 1.03 * held_out_mm(peer, T, check)


def test_full_poses_know_the_arm_better() -> None:
    case = drawn(8)
    q, check = postures(case.arm, 60, case.rng), case.exact(400)
    errors: list[float] = []
    for full in (False, True):
        found = measure(case.true, q, case.tracker, np.random.default_rng(2), full)
        result = identified(case.arm, found)
        errors.append(held_out_mm(result.arm, result.frames[0].T_frame_arm, check))
    assert errors[1] < errors[0]
    turned = present(result.markers[0].rotation)
    np.testing.assert_allclose(vector_from_rotation(turned), [0.3, -0.2, 0.9], atol=1e-3)
    angle = present(result.validation.after.rotations_deg)
    assert np.deg2rad(angle) == pytest.approx(np.sqrt(3) * 2e-4, rel=0.35)


@pytest.mark.parametrize("full", usual([True, False], 1, pytest.mark.soak))
def test_the_covariance_is_the_scatter_of_repeated_measurements(full: bool) -> None:
    case = drawn(17)
    arm, q = case.arm, postures(case.arm, 60, case.rng)

    def repeated() -> ArmObservations:
        found = measure(case.true, q, case.tracker, case.rng, full)
        return ArmObservations(coordinates=(found,))

    first = repeated()
    choice = candidates_of(arm, first)
    moved = fit_arm(arm, first.stacked, choice).moved
    fits = [fit_arm(arm, repeated().stacked, choice, moved) for _ in range(12)]
    values = np.array([parameter_values(fit.at.arm)[moved] for fit in fits])
    covariance = np.mean([fit.covariance for fit in fits], axis=0)
    off = (values - values.mean(axis=0)).T
    whitened = np.linalg.solve(np.linalg.cholesky(covariance), off)
    freedom = (len(fits) - 1) * len(moved)
    observed = float(np.sqrt(np.sum(whitened**2) / freedom))
    ratio_of_rms(1.0, observed, freedom).assert_within(*EXACT)


@pytest.mark.parametrize("axes", [6, 7])
@pytest.mark.parametrize("poses", [15, 25, 60])
def test_held_is_held_and_what_moved_is_listed(axes: int, poses: int) -> None:
    rng = np.random.default_rng(poses)
    arm = robot(axes)
    found = measure(built(arm, rng), postures(arm, poses, rng), Tracker.somewhere(rng, 0.3), rng)
    given = ArmObservations(coordinates=(found,))
    fit = fit_arm(arm, given.stacked, candidates_of(arm, given))
    before, after = parameter_values(arm), parameter_values(fit.at.arm)
    held = np.setdiff1d(np.arange(len(before)), fit.moved)
    np.testing.assert_array_equal(after[held], before[held])
    assert set(held) == set(fit.fixed)
    assert len(fit.covariance) == len(fit.moved)
    assert np.all(after[fit.moved] != before[fit.moved])


def test_markers_and_set_ups_are_found() -> None:
    rng = np.random.default_rng(5)
    arm = robot(6)
    true = built(arm, rng)
    reflector = replace(true, tip=REFLECTOR)
    first, second = Tracker.somewhere(rng), Tracker.somewhere(rng)
    found = (
        measure(true, postures(arm, 40, rng), first, rng, frame="a"),
        measure(reflector, postures(arm, 40, rng), first, rng, frame="a", marker="r"),
        measure(reflector, postures(arm, 30, rng), second, rng, frame="b", marker="r"),
    )
    result = identified(arm, *found)
    assert [frame.name for frame in result.frames] == ["a", "b"]
    for frame, tracker in zip(result.frames, (first, second), strict=True):
        off = frame.T_frame_arm[:3, 3] - tracker.T_tracker_arm[:3, 3]
        assert frame.standard_uncertainty_mm is not None
        # the base of the built arm differs from that of the datasheet by a few tenths
        assert np.linalg.norm(off) < 2.0
    marker = next(one for one in result.markers if one.name == "r")
    assert marker.standard_uncertainty_mm is not None
    assert np.linalg.norm(marker.offset_mm - REFLECTOR.centre_mm) < 2.0
    check = measure(reflector, postures(arm, 100, rng), first, rng)
    x, y, z = (float(one) for one in marker.offset_mm)
    seen = replace(result.arm, tip=Tip(x, y, z, 1.0))
    assert held_out_mm(seen, result.frames[0].T_frame_arm, check) < 0.13


def test_coordinates_stand_beside_seats() -> None:
    case = drawn(6)
    rng, arm = case.rng, case.arm
    reflector = replace(case.true, tip=REFLECTOR)
    measured = measure(reflector, postures(arm, 60, rng), case.tracker, rng, marker="r")
    seats = tuple(swing(case.true, f"S{i}", rng) for i in range(3))
    result = identify(arm, ArmObservations(seats, coordinates=(measured,)))
    assert {"tip.x_mm", "tip.y_mm", "tip.z_mm"} <= {one.name for one in result.changes}
    assert result.validation.after.seats_um is not None
    assert result.validation.after.coordinates_um is not None
    assert held_out_mm(result.arm, result.frames[0].T_frame_arm, case.exact(200)) < 0.1
    unnamed = ArmObservations(seats, coordinates=(replace(measured, marker="tip"),))
    assert refusal_of(identify, arm, unnamed).code == "marker-not-tip"


def test_a_bar_of_another_length_contradicts_the_coordinates() -> None:
    rng = np.random.default_rng(7)
    arm = robot(6)
    true = built(arm, rng)
    found = measure(true, postures(arm, 60, rng), Tracker.somewhere(rng), rng)
    good = [ball_bar(true, "B1", f"P{i}", 300.0, rng) for i in range(3)]
    result = identify(arm, ArmObservations(bars=tuple(good), coordinates=(found,)))
    assert not any("B1" in str(text) for text in result.warnings)
    wrong = tuple(replace(bar, length_mm=300.5) for bar in good)
    with refused_as("bar-length", "coordinates scatter", where="bar B1"):
        identify(arm, ArmObservations(bars=wrong, coordinates=(found,)))


def with_longer(arm: Arm, name: str, by_mm: float) -> Arm:
    """An arm of which one parameter is larger."""
    values = parameter_values(arm)
    values[parameter_names(arm).index(name)] += by_mm
    return with_parameters(arm, values)


def test_a_given_marker_shows_the_last_link() -> None:
    rng = np.random.default_rng(9)
    arm = robot(6)
    true = built(arm, rng)
    true = replace(with_longer(true, "J6.d_mm", 0.4), tip=REFLECTOR)
    found = measure(true, postures(arm, 80, rng), Tracker.somewhere(rng), rng, marker="r")
    result = identified(arm, replace(found, offset_mm=REFLECTOR.centre_mm))
    change = next(one for one in result.changes if one.name == "J6.d_mm")
    assert abs(change.after - 72.4) < 4 * change.standard_uncertainty
    assert result.markers[0].standard_uncertainty_mm is None
    assert not any(one.name.startswith("tip.") for one in result.changes)


def test_coordinates_in_the_arms_own_frame_move_its_base() -> None:
    rng = np.random.default_rng(10)
    arm = robot(6)
    true = with_longer(built(arm, rng), "J1.d_mm", 0.5)
    found = measure(true, postures(arm, 80, rng), Tracker(np.eye(4)), rng, frame=BASE)
    result = identified(arm, found)
    change = next(one for one in result.changes if one.name == "J1.d_mm")
    assert abs(change.after - 290.5) < 4 * change.standard_uncertainty
    assert result.frames[0].standard_uncertainty_mm is None


def test_every_derivative_agrees_with_numerical_differences() -> None:
    rng = np.random.default_rng(4)
    arm = robot(6)
    tracker = Tracker.somewhere(rng)
    found = measure(built(arm, rng), postures(arm, 8, rng), tracker, rng, True, marker="r")
    data = ArmObservations(coordinates=(found,)).stacked
    columns = np.arange(len(parameter_names(arm)))
    at, scatter = initial_unknowns(arm, data), Scatter(1.0, 1.0, 1.0)
    rows = coordinate_rows(data, at, columns, scatter)
    system = reduce_system(data, at, columns, np.ones(8), scatter)

    def whitened(change: Floats) -> Floats:
        changed = apply_change(data, at, columns, change, system)
        return coordinate_residuals(data, changed, scatter).whitened

    slopes = differences(whitened, [1e-5] * (rows.shape[2] - 1))
    np.testing.assert_allclose(rows[:, :, :-1], slopes, atol=2e-2, rtol=1e-3)


@pytest.fixture(scope="module")
def session() -> Session:
    case = drawn(2)
    q = postures(case.arm, 60, case.rng)
    return case, measure(case.true, q, case.tracker, case.rng, True)


def test_coordinates_in_metres_are_recognised(session: Session) -> None:
    case, found = session
    with refused_as("coordinates-unit", "metres", "millimetres"):
        identified(case.arm, replace(found, points_mm=found.points_mm / 1000))


@pytest.mark.parametrize("later", usual([10, 30], 1, pytest.mark.soak))
def test_points_of_two_set_ups_under_one_name_are_refused(session: Session, later: int) -> None:
    case, found = session
    arm, true = case.arm, case.true
    rng = np.random.default_rng(1)
    other = measure(true, postures(arm, later, rng), Tracker.somewhere(rng), rng, True)
    other = replace(other, lines=tuple(range(100, 100 + later)))
    first = found.part(np.arange(60) < 40)
    with refused_as("frames-mixed", "column frame", where="line 100"):
        identified(arm, first, other)
    named = replace(other, frame="second")
    assert len(identified(arm, first, named).frames) == 2


def test_rotations_in_another_order_are_refused(session: Session) -> None:
    case, found = session
    other = replace(found, rotations=np.swapaxes(present(found.rotations), 1, 2))
    assert refusal_of(identified, case.arm, other).code == "rotations-do-not-fit"


def test_fewer_poses_than_unknowns_are_refused(session: Session) -> None:
    case, _ = session
    rng = np.random.default_rng(1)

    def of_poses(count: int) -> Coordinates:
        return measure(case.true, postures(case.arm, count, rng), case.tracker, rng)

    with refused_as("too-few-points", "8 poses", where="coordinates.csv"):
        identified(case.arm, of_poses(8))
    few = identified(case.arm, of_poses(15))
    assert any("15 poses" in str(text) for text in few.warnings)
    assert refusal_of(identified, case.arm, of_poses(3)).code.startswith("too")


def test_angles_of_other_poses_are_refused() -> None:
    """Of an arm of four joints, as every pair of faults of its joints is tried."""
    rng = np.random.default_rng(2)
    arm = robot(6)
    arm = replace(arm, joints=arm.joints[:4])
    found = measure(built(arm, rng), postures(arm, 30, rng), Tracker.somewhere(rng), rng, True)
    backwards = replace(found, q_rad=found.q_rad[::-1])
    assert refusal_of(identified, arm, backwards).code == "arm-does-not-fit"
    joints = list(arm.joints)
    joints[1] = replace(joints[1], sign=-1)
    refusal = refusal_of(identified, replace(arm, joints=tuple(joints)), found)
    assert refusal.code in ("arm-does-not-fit", "coordinates-unit")


def test_a_separate_set_up_checks_the_result(session: Session) -> None:
    case, found = session
    arm, true, tracker = case.arm, case.true, case.tracker
    rng = np.random.default_rng(7)
    moved = replace(tracker, T_tracker_arm=inverse(tracker.T_tracker_arm))
    check = (
        measure(true, postures(arm, 20, rng), tracker, rng, True),
        measure(true, postures(arm, 20, rng), moved, rng, True, frame="another day"),
    )
    given = ArmObservations(coordinates=(found,))
    result = identify(arm, given, ArmObservations(coordinates=check))
    assert result.validation.separate
    assert result.validation.places == 40
    assert result.validation.after.coordinates_um == pytest.approx(87, rel=0.3)

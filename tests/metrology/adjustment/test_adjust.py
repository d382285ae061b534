"""The adjustment on simulated measurements: derivatives, exactness, and honest covariance."""

from dataclasses import replace

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.metrology.adjustment.block.nominal_block import estimate_block
from crenel.metrology.adjustment.core.arm_errors import tip_shift
from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult, solve_adjustment
from crenel.metrology.adjustment.core.hand_eye import mounting_by_motion
from crenel.metrology.adjustment.core.information import information_at
from crenel.metrology.adjustment.core.linearise import linearise
from crenel.metrology.adjustment.core.parameters import SENSOR, parameter_layout
from crenel.metrology.adjustment.core.uncertainty import (
    BUDGET,
    NAMES,
    covariance_by_source,
    estimate_uncertainty,
    link_names,
    measuring_volume,
    sensor_jacobian,
)
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.transforms import Floats, apply, inverse, rigid, rotation_from_vector, se3_exp
from tests.bench.metrology.calibration import SET_UPS, run
from tests.bench.metrology.simulated import Draw, SetUp, draw_session, draw_setup
from tests.metrology.numerics import differences
from tests.present import present
from tests.uncertainty_ratio import EXACT, UncertaintyRatio, ratio_of_deviations

pytestmark = pytest.mark.slow

SMALL = SetUp("three poses", 3, joints=7, contacts_per_face=5, seed=3)


@pytest.fixture(scope="module")
def draw() -> Draw:
    return draw_session(draw_setup(SMALL), np.random.default_rng(1))


def everything(draw: Draw, step: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """All residuals after a step from the truth, and their derivatives there."""
    at = parameter_layout(draw.problem)
    linear = linearise(draw.problem, at, draw.truth.apply_step(step, at))
    assert linear.contacts is not None
    residuals, jacobians = [linear.contacts.residuals_mm], [linear.contacts.jacobian]
    for scene, groups in zip(linear.scenes, linear.rows, strict=True):
        for rows in groups:
            residuals.append(rows.residuals)
            jacobians.append(rows.jacobian @ scene.by_unknowns)
    return np.concatenate(residuals), np.concatenate(jacobians)


def test_the_derivatives_by_every_unknown_are_those_that_differences_give(draw: Draw) -> None:
    count = parameter_layout(draw.problem).count
    _, found = everything(draw, np.zeros(count))
    steps = np.where(np.arange(count) < 4, 1e-3, 1e-6)
    slopes = differences(lambda step: everything(draw, step)[0], steps)
    for k, slope in enumerate(slopes.T):
        largest = max(float(np.abs(slope).max()), 1e-3)
        np.testing.assert_allclose(found[:, k], slope, atol=1e-3 * largest, err_msg=f"{k}")


def test_measurements_without_noise_give_the_truth() -> None:
    station = draw_setup(SetUp("exact", 4, seed=5))
    draw = draw_session(station, np.random.default_rng(2), noisy=False)
    found = solve_adjustment(draw.problem, draw.start)
    uv = measuring_volume(found).uv_px
    points = sensor_points(found.state.camera, found.state.plane, uv)
    true = sensor_points(station.camera, station.plane, uv)
    off = apply(found.state.T_flange_cam, points) - apply(station.T_flange_cam, true)
    assert np.abs(off).max() < 1e-4


def test_the_budget_adds_up_to_the_covariance(draw: Draw) -> None:
    found = solve_adjustment(draw.problem, draw.start)
    parts = covariance_by_source(found)
    assert set(parts) == {name for name, _ in BUDGET} | {"distortion"}
    of_sensor = np.sum(list(parts.values()), axis=0)[SENSOR, SENSOR]
    expected = found.uncertainty[SENSOR, SENSOR]
    np.testing.assert_allclose(of_sensor, expected, rtol=1e-6, atol=1e-12)
    T_cam_sensor = rigid(rotation_from_vector(np.array([0.3, 0.1, 2.0])), np.array([1.0, 2, 130]))
    worth = estimate_uncertainty(found, T_cam_sensor)
    total = np.sqrt(sum(row.value_um**2 for row in worth.rows))
    assert worth.total_um == pytest.approx(total)
    assert present(worth.plane).angle_arcsec > 0
    known = present(worth.map)
    assert known.calibrated.any()
    assert not known.calibrated.all()
    inside = known.u_um[known.calibrated]
    assert inside.min() > 0
    # the frame of the sensor is a choice: neither its place nor the budget depend on it
    elsewhere = estimate_uncertainty(found, np.eye(4))
    assert elsewhere.total_um == pytest.approx(worth.total_um)


def test_claims_hold_over_many_solves() -> None:
    (kept,) = run(30, setups=(replace(SET_UPS[0], contacts_per_face=8),))
    assert kept.failed == 0
    assert 0 < kept.without_sampling.error < kept.over_bound.error < 0.1
    UncertaintyRatio(kept.over_bound.value, kept.over_bound.error).assert_within(*EXACT, k=2)
    known = kept.without_sampling
    UncertaintyRatio(known.value, known.error).assert_within(highest=1.04)
    # without the sampling variation of thirty draws, which is ten times what is left
    ratio = kept.claimed_um / (known.value * kept.bound_um)
    UncertaintyRatio(ratio, ratio * known.error / known.value).assert_within()


def errors_in_the_arm_frame(draw: Draw, found: AdjustmentResult) -> tuple[Floats, Floats, Floats]:
    """Errors (G, 3) mm of points in the arm frame, in the posture of the first picture and with the
    estimated links; their squares (G,) as they are claimed, and as they would be if sensor and
    links were estimated apart."""
    uv = measuring_volume(found).uv_px
    T, by_links = found.problem.motion.T_arm_flange[0], found.problem.motion.by_links[0]
    in_flange, in_arm = [], []
    for state in (found.state, draw.truth):
        points = sensor_points(state.camera, state.plane, uv)
        in_flange.append(apply(state.T_flange_cam, points))
        in_arm.append(apply(se3_exp(by_links @ state.links) @ T, in_flange[-1]))
    at = found.linear.at
    J = np.zeros((len(uv), 3, at.count))
    J[:, :, SENSOR] = np.einsum("ij,gjk->gik", T[:3, :3], sensor_jacobian(found.state, uv))
    J[:, :, at.links] = [tip_shift(T, point) @ by_links for point in in_flange[0]]
    apart = found.uncertainty.copy()
    apart[SENSOR, at.links], apart[at.links, SENSOR] = 0.0, 0.0
    joint, alone = (np.einsum("gik,kl,gil->g", J, C, J) for C in (found.uncertainty, apart))
    return in_arm[0] - in_arm[1], joint, alone


def test_points_in_the_arm_frame_are_known_by_sensor_and_links_together() -> None:
    station = draw_setup(replace(SET_UPS[0], contacts_per_face=8))
    rms: list[tuple[float, ...]] = []
    for seed in range(30):
        draw = draw_session(station, np.random.default_rng(seed))
        errors, *claims = errors_in_the_arm_frame(draw, solve_adjustment(draw.problem, draw.start))
        squares = (np.sum(errors**2, axis=1), *claims)
        rms.append(tuple(float(np.sqrt(np.mean(square))) for square in squares))
    observed, claimed, apart = np.array(rms).T
    ratio_of_deviations(claimed, observed).assert_within(*EXACT)
    assert np.mean(claimed) < 0.97 * np.mean(apart)


def test_the_links_are_named_beside_the_sensor(draw: Draw) -> None:
    found = solve_adjustment(draw.problem, draw.start)
    known = estimate_uncertainty(found, np.eye(4))
    links = link_names(7)
    assert known.names == (*NAMES, *links)
    assert (links[0], links[-1]) == ("link1_rx", "link7_tz")
    at = found.linear.at.links
    np.testing.assert_array_equal(known.links, found.state.links)
    here = known.names.index(links[0])
    np.testing.assert_allclose(known.covariance[here:, here:], found.uncertainty[at, at])
    # the intrinsic parameters are unknowns themselves
    np.testing.assert_allclose(known.covariance[:4, here:], found.uncertainty[:4, at])


def test_more_poses_are_known_better() -> None:
    claims = []
    for poses in (1, 4, 8):
        setup = SetUp("", poses, seed=7)
        draw = draw_session(draw_setup(setup), np.random.default_rng(0), noisy=False)
        exact = information_at(draw.problem, draw.truth, setup.scales)
        claims.append(estimate_uncertainty(exact, np.eye(4)).total_um)
    assert claims[0] > claims[1] > claims[2]


def moving(count: int, axes: np.ndarray, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Flange poses turned about some axes, and how a camera on the flange sees an object."""
    X = rigid(rotation_from_vector(np.array([0.1, 3.0, 0.2])), np.array([5.0, -60.0, 210.0]))
    Z = rigid(rotation_from_vector(np.array([0.0, 0.1, 0.5])), np.array([500.0, 100.0, 90.0]))
    flange, seen = [], []
    for _ in range(count):
        turn = rotation_from_vector(axes.T @ rng.uniform(-0.5, 0.5, len(axes)))
        T = rigid(turn, np.array([480.0, 80.0, 300.0]) + rng.uniform(-50, 50, 3))
        flange.append(T)
        seen.append(inverse(T @ X) @ Z)
    return np.array(flange), np.array(seen)


def test_the_mounting_follows_from_motion_alone() -> None:
    flange, seen = moving(8, np.eye(3), np.random.default_rng(3))
    found = mounting_by_motion(flange, seen, 50.0)
    assert found.off_mm.max() < 1e-6
    assert not found.contradicts.any()
    flange[2] = flange[5]
    found = mounting_by_motion(flange, seen, 50.0)
    assert np.flatnonzero(found.contradicts).tolist() == [2]


def test_turns_about_one_axis_are_refused_and_the_axis_named() -> None:
    axis = np.array([[0.0, 0.0, 1.0]])
    with pytest.raises(OperationError, match=r"about one axis, \([+−]?0.00 [+−]?0.00 [+−]1.00\)"):
        mounting_by_motion(*moving(6, axis, np.random.default_rng(4)), 50.0)
    with pytest.raises(OperationError, match="all alike"):
        mounting_by_motion(*moving(6, 0.01 * np.eye(3), np.random.default_rng(5)), 50.0)


def test_the_camera_of_a_state_is_its_own_frame(draw: Draw) -> None:
    camera = solve_adjustment(draw.problem, draw.start).state.camera
    np.testing.assert_array_equal(camera.rotation, np.eye(3))
    np.testing.assert_array_equal(camera.translation_mm, np.zeros(3))


def test_edges_of_a_drawing_are_estimated_beside_the_calibration() -> None:
    faces = ("crest", "front", "back", "left", "right")
    setup = SetUp("drawn", 4, faces=faces, tolerance_mm=0.1, seed=31)
    draw = draw_session(draw_setup(setup), np.random.default_rng(31))
    found = solve_adjustment(draw.problem, draw.start)
    made = estimate_block(found)
    edges = slice(0, len(draw.truth.coordinates) - 5)
    off_mm = (found.state.coordinates - draw.truth.coordinates)[edges]
    drawn_off_mm = (draw.problem.prior.coordinates - draw.truth.coordinates)[edges]
    assert np.std(off_mm) < 0.1 * np.std(drawn_off_mm)
    assert np.max(np.abs(off_mm - off_mm.mean()) / made.sd_mm[edges]) < 5
    assert not made.undetermined
    touched_less = replace(setup, faces=("crest", "front", "left"), poses=1)
    draw = draw_session(draw_setup(touched_less), np.random.default_rng(32))
    assert "width" in estimate_block(solve_adjustment(draw.problem, draw.start)).undetermined

"""The calibration on a chessboard: truth, Jacobians, contacts, and bad input in words."""

import re
from collections.abc import Sequence
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel.errors import OperationError
from crenel.metrology.adjustment.board.add_laser import add_laser
from crenel.metrology.adjustment.board.calibrate import (
    BoardCalibration,
    calibrate_board,
    observe_board,
)
from crenel.metrology.adjustment.board.initial_guess import BoardObservation
from crenel.metrology.adjustment.board.laser_lines import line_scatter
from crenel.metrology.adjustment.board.observations import BoardView
from crenel.metrology.adjustment.board.problem import BoardInputs
from crenel.metrology.adjustment.board.surface import (
    board_prior,
    evaluate_surface,
    surface_height_mm,
)
from crenel.metrology.adjustment.core.kept_sensor import KeptSensor
from crenel.metrology.adjustment.core.uncertainty import KEPT
from crenel.metrology.calibration.observation_model import SceneModel
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.projection import COUNT
from crenel.metrology.stripe import empty_stripe
from crenel.metrology.transforms import Floats, apply, inverse, rigid
from tests.metrology.boards import (
    BOARD,
    K1,
    NORMAL,
    OFFSET_MM,
    POSES,
    T_ARM_OBJ,
    T_FLANGE_CAM,
    TIP,
    K,
    Look,
    inputs,
    picture,
)
from tests.metrology.builders import BLOCK
from tests.metrology.refusals import refusal_of
from tests.metrology.seen_boards import BoardErrors, camera_at, error_um, session
from tests.running.usual import usual

pytestmark = pytest.mark.slow
MOVED = rigid(Rotation.from_rotvec([0.1, 0.0, 0.4]).as_matrix(), np.array([90.0, -40.0, 15.0]))


@pytest.fixture(scope="module")
def given() -> BoardInputs:
    return inputs()


@pytest.fixture(scope="module")
def found(given: BoardInputs) -> BoardCalibration:
    return calibrate_board(given)


def test_the_truth_is_found(found: BoardCalibration) -> None:
    state = found.adjustment.state
    off = inverse(T_FLANGE_CAM) @ state.T_flange_cam
    assert np.linalg.norm(off[:3, 3]) < 0.15
    assert np.degrees(np.linalg.norm(Rotation.from_matrix(off[:3, :3]).as_rotvec())) < 0.03
    assert state.camera.matrix[0, 0] == pytest.approx(K[0, 0], rel=2e-3)
    assert state.camera.distortion[0] == pytest.approx(K1, abs=0.03)
    assert np.degrees(np.arccos(abs(state.plane.normal @ NORMAL))) < 0.1
    assert abs(state.plane.offset_mm) == pytest.approx(OFFSET_MM, abs=0.1)
    assert np.linalg.norm((found.T_arm_obj - T_ARM_OBJ)[:3, 3]) < 0.1
    assert [pose.number for pose in found.poses if pose.used] == list(range(1, 9))


def test_reconstructed_points_are_as_good_as_said(found: BoardCalibration) -> None:
    assert error_um(found) < 3 * found.uncertainty.total_um
    assert found.uncertainty.total_um < 150


def test_the_surfaces_slopes_are_its_derivatives() -> None:
    rng = np.random.default_rng(0)
    coordinates = rng.normal(0, 1, len(board_prior(BOARD).names))
    at, h = rng.uniform(-20, 80, (6, 2)), 1e-4
    reported = evaluate_surface(BOARD, coordinates, at)
    for k, way in enumerate(np.eye(2) * h):
        ahead, behind = (surface_height_mm(BOARD, coordinates, at + s * way) for s in (1, -1))
        assert (ahead - behind) / (2 * h) == pytest.approx(reported.slope[:, k], abs=1e-7)


def test_the_views_jacobian_is_right(given: BoardInputs, found: BoardCalibration) -> None:
    """Against differences, for every parameter, on a bent board."""
    seen, T = given.observations[6], POSES[6]
    camera = replace(camera_at(T), distortion=np.array([K1, 0.1, 1e-3, -1e-3, 0]))
    plane = LaserPlane(T[:3, :3].T @ NORMAL, float(OFFSET_MM - NORMAL @ T[:3, 3]))
    rng = np.random.default_rng(1)
    prior = board_prior(BOARD)
    values = prior.coordinates + rng.normal(0, 0.05, len(prior.names))
    view = BoardView(BOARD, seen.detection, seen.stripe, np.ones(len(seen.stripe.u), np.bool_))
    view = view.reclassify_stripe(camera, plane, values)
    reported = view.rows(camera, plane, values)
    scene = SceneModel(camera, plane, BLOCK)
    count = COUNT + 3
    for k in [*range(count + 3), count + 9, count + 30, count + 80, count + 120]:
        h = 1e-4 if k < 4 else 1e-6 if k < count else 1e-4
        ends = []
        for way in (1, -1):
            moved, there = scene, values.copy()
            if k < count:
                step = np.zeros(len(scene.names))
                step[k] = way * h
                moved = scene.apply_step(step)
            else:
                there[k - count] += way * h
            ends.append(view.rows(moved.camera, moved.plane, there))
        for kind in (0, 1):
            slope = (ends[0][kind].residuals - ends[1][kind].residuals) / (2 * h)
            scale = max(float(np.abs(slope).max()), 1.0)
            # a line is taken as straight at each point, so its slopes hold to a share
            share = 1e-5 if kind == 0 else 2e-2
            assert np.abs(slope - reported[kind].jacobian[:, k]).max() < share * scale, (k, kind)


@cache
def unlit(k: int) -> BoardObservation:
    """Of the pose of this index, the laser being off."""
    dark = picture(POSES[k], Look(laser=False), k)
    return observe_board(k + 1, BOARD, dark, None, "v", laser_on=False)


def without_lines(given: BoardInputs, poses: Sequence[int]) -> BoardInputs:
    """The same with these poses (by index) as pictures with the laser off show them."""
    seen = list(given.observations)
    for k in poses:
        seen[k] = unlit(k)
        assert not len(seen[k].stripe.u)
    return replace(given, observations=tuple(seen))


def of_poses(given: BoardInputs, kept: Sequence[int]) -> BoardInputs:
    """Those of these indices alone."""
    seen = tuple(given.observations[k] for k in kept)
    return replace(given, observations=seen, readings=given.readings[kept])


def test_poses_without_a_line_tell_the_rest(given: BoardInputs, found: BoardCalibration) -> None:
    """Better than without them; the plane follows from the others, and they are named."""
    dark = (1, 3, 6)
    some = calibrate_board(without_lines(given, dark))
    assert [pose.number for pose in some.poses if pose.used] == list(range(1, 9))
    assert [pose.number for pose in some.poses if not pose.stripe_points] == [2, 3, 4, 6, 7]
    assert not any(pose.reason for pose in some.poses)
    (stripe,) = (str(one.text) for one in some.findings if one.code == "stripe")
    assert "Poses 2, 3, 4, 6, 7 have none and determine only camera and mounting" in stripe
    fewer = calibrate_board(of_poses(given, [k for k in range(len(POSES)) if k not in dark]))
    assert found.uncertainty.total_um <= some.uncertainty.total_um < fewer.uncertainty.total_um
    assert np.degrees(np.arccos(abs(some.adjustment.state.plane.normal @ NORMAL))) < 0.2


def contradicting(given: BoardInputs, k: int) -> BoardInputs:
    """The same, but that the pose of this index is elsewhere."""
    readings = given.readings.copy()
    readings[k, :3, 3] += [15.0, -10.0, 5.0]
    return replace(given, readings=readings)


def test_two_lines_are_enough_and_one_is_not(given: BoardInputs) -> None:
    two = calibrate_board(without_lines(given, range(1, 7)))
    assert [pose.number for pose in two.poses if pose.stripe_points] == [1, 8]
    assert abs(two.adjustment.state.plane.offset_mm) == pytest.approx(OFFSET_MM, abs=0.5)
    refusal = refusal_of(calibrate_board, without_lines(given, range(1, 8)))
    assert refusal.code == "stripe-not-found"
    assert re.search("in 1 of 8 pictures.*one more picture", refusal.line)
    # the last line but one is that of a pose that contradicts
    with pytest.raises(OperationError, match="in 1 of 7 pictures"):
        calibrate_board(without_lines(contradicting(given, 0), range(1, 7)))


def test_camera_and_mounting_come_without_a_laser_which_is_added_later() -> None:
    """The board lies elsewhere by then, and the laser is seen in few pictures."""
    alone = calibrate_board(replace(session(0), with_laser=False))
    known = alone.uncertainty
    assert alone.plane is None
    assert known.map is None
    assert "no-laser-plane" in [one.code for one in alone.findings]
    assert "plane_offset" not in known.names
    camera, T = alone.camera, alone.T_flange_sensor
    kept = KeptSensor(camera, T, known.names, known.covariance, known.pivot_mm)
    later = session(1)
    dark = [replace(one, stripe=empty_stripe("v")) for one in later.observations[2:6]]
    seen = (*later.observations[:2], *dark, *later.observations[6:])
    later = replace(later, observations=seen, readings=MOVED @ later.readings)
    whole = add_laser(later, kept)
    assert np.array_equal(whole.camera.matrix, camera.matrix)
    assert np.allclose(whole.T_flange_sensor, T, atol=1e-9)
    assert error_um(whole) < 3 * whole.uncertainty.total_um
    (of_kept,) = (row for row in whole.uncertainty.rows if row.source == KEPT)
    assert 0 < of_kept.value_um < whole.uncertainty.total_um
    assert "camera-kept" in [one.code for one in whole.findings]
    other = replace(kept, camera=replace(camera, matrix=camera.matrix * [[1.02], [1.02], [1.0]]))
    assert refusal_of(add_laser, later, other).code == "camera-changed"
    assert refusal_of(add_laser, replace(later, with_laser=False), kept).code == "laser-was-off"


def touching(count: int, radius_mm: float) -> Floats:
    """``T_arm_flange`` (N, 4, 4) with the tip on the board, its centre a radius above it."""
    rng = np.random.default_rng(5)
    poses = []
    for _ in range(count):
        turn = Rotation.from_rotvec(rng.normal(0, 0.2, 3)).as_matrix()
        tip = apply(T_ARM_OBJ, np.array([[*rng.uniform(0, 50, 2), radius_mm]]))[0]
        poses.append(rigid(turn, tip - turn @ TIP.centre_mm))
    return np.array(poses)


def test_contacts_are_used_where_given(given: BoardInputs, found: BoardCalibration) -> None:
    touched = calibrate_board(replace(given, contact_readings=touching(12, 3.0)))
    contacts = touched.adjustment.linear.contacts
    assert contacts is not None
    assert np.sqrt(np.mean(contacts.residuals_mm**2)) < 0.05
    assert touched.uncertainty.total_um < found.uncertainty.total_um
    assert "contact points" in {row.source for row in touched.uncertainty.rows}
    assert "contact points" not in {row.source for row in found.uncertainty.rows}


def test_a_wrong_square_size_is_refused(given: BoardInputs) -> None:
    wrong = replace(BOARD, square_mm=12.0)
    words = r"(9\.9|10\.0)\d* mm wide: its certificate states 12 mm"
    with pytest.raises(OperationError, match=words):
        calibrate_board(replace(given, board=wrong))


def test_a_pose_that_contradicts_is_named(given: BoardInputs) -> None:
    result = calibrate_board(contradicting(given, 3))
    assert [pose.number for pose in result.poses if not pose.used] == [4]
    assert any("Pose 4" in str(finding.text) for finding in result.findings)


def test_a_line_that_contradicts_is_named(given: BoardInputs) -> None:
    moved = picture(POSES[4], Look(offset_mm=OFFSET_MM + 3.0), 4)
    seen = list(given.observations)
    seen[4] = observe_board(5, BOARD, moved, None, "v")
    result = calibrate_board(replace(given, observations=tuple(seen)))
    named = [pose.number for pose in result.poses if "laser line" in str(pose.reason)]
    assert named == [5]
    assert abs(result.adjustment.state.plane.offset_mm) == pytest.approx(OFFSET_MM, abs=0.1)


def test_what_does_not_determine_it_is_refused(given: BoardInputs) -> None:
    off_board = refusal_of(calibrate_board, replace(given, contact_readings=touching(12, 9.0)))
    assert off_board.code == "contacts-off-board"
    assert "off the board" in off_board.line
    alike = np.array([rigid(np.eye(3), T[:3, 3]) for T in given.readings])
    unmoved = refusal_of(calibrate_board, replace(given, readings=alike))
    assert unmoved.code == "poses-alike"
    assert "poses that are all alike do not determine the sensor's position" in unmoved.line
    assert refusal_of(calibrate_board, of_poses(given, [0, 1])).code == "too-few-poses"
    empty = given.observations[2].stripe
    seen = tuple(replace(pose, stripe=empty) for pose in given.observations)
    unlit_all = refusal_of(calibrate_board, replace(given, observations=seen))
    assert unlit_all.code == "stripe-not-found"
    assert "the laser line lies on the board in 0 of 8 pictures" in unlit_all.line


@pytest.mark.parametrize("seed", usual(range(2), 1, pytest.mark.soak))
@pytest.mark.parametrize(("line_mm", "least", "most"), [(0.005, 0.004, 0.03), (0.2, 0.1, 0.4)])
def test_a_steady_laser_is_known(line_mm: float, least: float, most: float, seed: int) -> None:
    """Both are far from what is usual, which is thought of only where little is seen."""
    errors = BoardErrors(turn_rad=5e-5, shift_mm=0.02, line_mm=line_mm, line_rad=line_mm / 50)
    off_mm, _ = line_scatter(calibrate_board(session(seed, errors, rows_apart=4)).adjustment)
    assert least < off_mm < most

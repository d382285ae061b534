"""Arms in the modified convention and arms of five joints, beside the robotics toolbox."""

import json
import warnings
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel.formats.datasheets.arm import arm_document, read_arm
from crenel.metrology.adjustment.core.arm_errors import arm_motion
from crenel.metrology.arm.identification.identify import identify
from crenel.metrology.arm.identification.observations import ArmObservations
from crenel.metrology.arm.identification.parameters import pose_jacobian
from crenel.metrology.arm.kinematics import (
    Arm,
    flange_pose,
    flange_poses,
    geometric_jacobian,
    link_transforms,
    tip_centres,
)
from crenel.metrology.arm.link_error import LinkError, error_from_transform, error_transform
from crenel.metrology.arm.modified_dh import standard_from_modified
from crenel.metrology.transforms import apply, rigid, rigid_fit
from tests.metrology.builders import random_arm
from tests.metrology.numerics import flange_slopes, rms_length
from tests.metrology.toolbox import toolbox_pose
from tests.running.usual import usual
from tests.simulated_robots import Tracker, built, measure, postures, swing

JOINTS = [5, 6, 7]


def converted(modified: Arm) -> Arm:
    base, joints = standard_from_modified(modified.joints)
    return replace(modified, joints=joints, base=base)


@pytest.mark.parametrize("joints", JOINTS)
@pytest.mark.parametrize("with_errors", [False, True])
def test_the_converted_arm_is_that_of_the_toolbox(joints: int, with_errors: bool) -> None:
    rng = np.random.default_rng(joints)
    for _ in range(5):
        modified = random_arm(rng, joints, with_errors)
        arm = converted(modified)
        assert arm.base.x_mm == modified.joints[0].a_mm
        for q in rng.uniform(-3, 3, (4, joints)):
            expected = toolbox_pose(modified, q, "modified")
            np.testing.assert_allclose(flange_pose(arm, q), expected, atol=1e-9)


def test_a_whole_arm_of_the_toolbox_agrees_too() -> None:
    """A Puma 560 as the toolbox itself states it, six modified links at once."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        from roboticstoolbox import DHRobot, RevoluteMDH
        from roboticstoolbox.models.DH import Puma560

        rows = [(link.a, link.alpha, link.d) for link in Puma560().links]
        robot = DHRobot([RevoluteMDH(a=a, alpha=alpha, d=d) for a, alpha, d in rows])
    rng = np.random.default_rng(3)
    joints = tuple(
        replace(joint, a_mm=a, alpha_rad=alpha, d_mm=d, theta_rad=0.0, sign=1)
        for joint, (a, alpha, d) in zip(random_arm(rng).joints, rows, strict=True)
    )
    arm = converted(replace(random_arm(rng), joints=joints))
    for q in rng.uniform(-3, 3, (5, 6)):
        np.testing.assert_allclose(flange_pose(arm, q), robot.fkine(q).A, atol=1e-12)


@pytest.mark.parametrize("joints", JOINTS)
def test_a_modified_file_is_read_and_written_as_standard(tmp_path: Path, joints: int) -> None:
    rng = np.random.default_rng(20 + joints)
    modified = random_arm(rng, joints, with_errors=True)
    path = tmp_path / "arm.json"
    arm_document(modified).write(path)
    document = json.loads(path.read_text())
    document["convention"] = "dh-modified"
    document["base"] = {"x_mm": 3.0, "y_mm": -2.0, "rz_deg": 40.0, "ry_deg": 5.0}
    path.write_text(json.dumps(document))
    arm = read_arm(path)
    T = error_transform(LinkError(3.0, -2.0, 0.0, 0.0, np.radians(5.0), np.radians(40.0)))
    q = rng.uniform(-3, 3, (5, joints))
    for row in q:
        expected = T @ toolbox_pose(modified, row, "modified")
        np.testing.assert_allclose(flange_pose(arm, row), expected, atol=1e-9)
    again = tmp_path / "again.json"
    arm_document(arm).write(again)
    assert json.loads(again.read_text())["convention"] == "dh-standard"
    np.testing.assert_allclose(flange_poses(read_arm(again), q), flange_poses(arm, q), atol=1e-9)


def test_every_transform_has_error_terms() -> None:
    turns = [Rotation.random(random_state=seed).as_matrix() for seed in range(50)]
    anywhere = [rigid(R, np.array([1.0, -2.0, 3.0])) for R in turns]
    upright = [LinkError(rx_rad=0.3, ry_rad=ry, rz_rad=-0.5) for ry in (np.pi / 2, -np.pi / 2)]
    for T in (*anywhere, *map(error_transform, upright)):
        np.testing.assert_allclose(error_transform(error_from_transform(T)), T, atol=1e-12)


@pytest.mark.parametrize("joints", JOINTS)
def test_derivatives_hold_with_a_base(joints: int) -> None:
    rng = np.random.default_rng(30 + joints)
    arm = converted(random_arm(rng, joints, with_errors=True))
    q, point = rng.uniform(-3, 3, joints), np.array([10.0, -20.0, 150.0])
    J = flange_slopes(arm, q, point)
    np.testing.assert_allclose(geometric_jacobian(arm, q, point), J, atol=1e-4)

    motion = arm_motion(arm, q[None])
    T = flange_pose(arm, q)
    np.testing.assert_allclose(motion.T_arm_flange[0], T, atol=1e-9)
    turn, shift = motion.by_noise[0, :3], motion.by_noise[0, 3:]
    at = (T @ [*point, 1.0])[:3]
    np.testing.assert_allclose(turn, J[3:], atol=1e-6)
    np.testing.assert_allclose(shift + np.cross(turn.T, at).T, J[:3], atol=1e-4)

    poses = pose_jacobian(arm, q[None])
    np.testing.assert_allclose(poses.tips_mm, tip_centres(arm, q[None]), atol=1e-9)
    signs = np.array([joint.sign for joint in arm.joints])
    tip = flange_slopes(arm, q, arm.tip.centre_mm)
    by_theta = slice(3, 10 * joints, 10)
    np.testing.assert_allclose(poses.by_parameters[0, :, by_theta] * signs, tip[:3], atol=1e-4)
    np.testing.assert_allclose(poses.turns[0, :, by_theta] * signs, tip[3:], atol=1e-6)


def test_links_lead_from_the_arm_frame_to_the_flange() -> None:
    rng = np.random.default_rng(8)
    arm = converted(random_arm(rng, 6, with_errors=True))
    q = rng.uniform(-3, 3, (1, 6))
    T = np.eye(4)
    for link in link_transforms(arm, q)[:, 0]:
        T = T @ link
    np.testing.assert_allclose(T, flange_pose(arm, q[0]), atol=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("with_base", usual([True, False], 1, pytest.mark.soak))
def test_five_joints_are_identified_from_coordinates_and_seats(with_base: bool) -> None:
    rng = np.random.default_rng(4)
    nominal = random_arm(rng, 5)
    limited = tuple(replace(joint, limits_rad=(-2.0, 2.0)) for joint in nominal.joints)
    nominal = replace(nominal, joints=limited)
    if with_base:
        nominal = converted(nominal)
    true = built(nominal, rng)
    zero = np.zeros((1, 5))
    assert np.linalg.norm(tip_centres(true, zero) - tip_centres(nominal, zero)) > 0.1
    measured = measure(true, postures(nominal, 80, rng), Tracker.somewhere(rng, 0.02), rng)
    seats = tuple(swing(true, f"cone {i}", rng) for i in range(2))
    found = identify(nominal, ArmObservations(seats=seats, coordinates=(measured,)))
    assert found.arm.base == nominal.base
    q = postures(nominal, 200, rng)
    # the arm is known up to where its base stands
    is_, ought = tip_centres(found.arm, q), tip_centres(true, q)
    assert rms_length(apply(rigid_fit(is_, ought), is_) - ought) < 0.03

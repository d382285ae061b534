"""The simulated arm's kinematics against an independent library, and its own inverse."""

from dataclasses import replace

import numpy as np
import pytest
from roboticstoolbox import DHRobot, RevoluteDH
from scipy.spatial.transform import Rotation

from crenel_hardware.simulator.devices.kinematics import (
    ArmLink,
    ArmModel,
    ErrorSource,
    UnreachableError,
    flange_pose,
    flange_poses,
    follow_poses,
    perturb_arm,
    solve_joints,
    tip_centre,
    translation,
)
from crenel_hardware.simulator.scene.random_scenes import demo_arm, random_arm


@pytest.mark.parametrize("joints", [6, 7])
@pytest.mark.parametrize("seed", range(4))
def test_poses_agree_with_an_independent_library(joints: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    arm = random_arm(rng, joints)
    robot = DHRobot([RevoluteDH(d=k.d_mm, a=k.a_mm, alpha=k.alpha_rad) for k in arm.links])
    for q in rng.uniform(-2, 2, (5, joints)):
        shifted = [k.sign * v + k.theta_rad for k, v in zip(arm.links, q, strict=True)]
        assert np.allclose(flange_pose(arm, q), robot.fkine(shifted).A, atol=1e-9)


def test_an_error_is_shifted_first_and_turned_about_z_last() -> None:
    link = ArmLink(10.0, 0.3, 20.0, error_mm_rad=(1.0, 2.0, 3.0, 0.1, 0.2, 0.3))
    wrong = ArmModel((link,), (0.0, 0.0, 0.0), 1.0)
    right = ArmModel((replace(link, error_mm_rad=(0.0,) * 6),), (0.0, 0.0, 0.0), 1.0)
    q = np.array([0.4])
    E = np.linalg.inv(flange_pose(right, q)) @ flange_pose(wrong, q)
    assert np.allclose(E[:3, 3], [1, 2, 3])
    assert np.allclose(E[:3, :3], Rotation.from_euler("xyz", [0.1, 0.2, 0.3]).as_matrix())


@pytest.mark.parametrize("wrong_in", ["links", "parameters"])
def test_an_imperfect_arm_is_off_by_micrometres(wrong_in: ErrorSource) -> None:
    rng = np.random.default_rng(0)
    arm = random_arm(rng)
    wrong = perturb_arm(arm, 80.0, rng, wrong_in)
    q = rng.uniform(-1, 1, (400, 6))
    ideal, true = flange_poses(arm, q), flange_poses(wrong, q)
    tips = [T[:, :3, :3] @ np.array(arm.tip_mm) + T[:, :3, 3] for T in (ideal, true)]
    distance_um = 1000 * np.linalg.norm(tips[0] - tips[1], axis=1)
    assert 30 < np.sqrt(np.mean(distance_um**2)) < 1500


@pytest.mark.parametrize("joints", [6, 7])
@pytest.mark.parametrize("seed", range(5))
def test_the_inverse_reaches_a_pose_within_the_limits(joints: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    arm = perturb_arm(random_arm(rng, joints), 60.0, rng)
    target = flange_pose(arm, rng.uniform(-1.5, 1.5, joints))
    q = solve_joints(arm, target, np.zeros(joints), rng)
    assert np.allclose(flange_pose(arm, q), target, atol=1e-6)
    assert np.all(q >= arm.limits_rad[:, 0])
    assert np.all(q <= arm.limits_rad[:, 1])


@pytest.mark.parametrize("joints", [6, 7])
def test_joints_follow_a_path_without_a_jump(joints: int) -> None:
    rng = np.random.default_rng(3)
    arm = demo_arm() if joints == 6 else random_arm(rng, 7)
    q0 = np.array([0.2, 0.5, 0.4, 0.3, 0.7, 0.1, 0.2])[:joints]
    start = flange_pose(arm, q0)
    path = np.stack([translation(0.0, 0.4 * i, -0.2 * i) @ start for i in range(100)])
    q = follow_poses(arm, path, q0)
    assert np.allclose(flange_poses(arm, q), path, atol=1e-6)
    assert np.max(np.abs(np.diff(q, axis=0))) < 0.02


def test_what_is_out_of_reach_is_refused() -> None:
    arm = demo_arm()
    with pytest.raises(UnreachableError, match="no joint angles reach"):
        solve_joints(arm, translation(5000.0, 0.0, 0.0), np.zeros(6), np.random.default_rng(0), 5)


def test_the_tip_sits_on_the_flange() -> None:
    arm = demo_arm()
    q = np.array([0.1, 0.2, 0.3, 0.4, 0.5, 0.6])
    T = flange_pose(arm, q)
    assert np.allclose((np.linalg.inv(T) @ [*tip_centre(arm, q), 1.0])[:3], arm.tip_mm)


def test_an_arm_of_too_many_joints_is_refused() -> None:
    with pytest.raises(ValueError, match="an arm may have 16 joints, not 17"):
        ArmModel((ArmLink(1.0, 0.0, 0.0),) * 17, (0.0, 0.0, 0.0), 1.0)

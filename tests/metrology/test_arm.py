"""The arm's kinematics against the robotics toolbox and numerical derivatives."""

import numpy as np
import pytest

from crenel.metrology.arm.kinematics import (
    flange_pose,
    flange_poses,
    geometric_jacobian,
    tip_centres,
    tip_covariances,
)
from crenel.metrology.arm.link_error import LinkError, error_transform
from tests.metrology.builders import random_arm
from tests.metrology.numerics import flange_slopes
from tests.metrology.toolbox import toolbox_pose

pytestmark = pytest.mark.usefixtures("variant")


@pytest.mark.parametrize("joints", [6, 7])
@pytest.mark.parametrize("with_errors", [False, True])
def test_forward_kinematics_agree_with_the_robotics_toolbox(joints: int, with_errors: bool) -> None:
    rng = np.random.default_rng(joints)
    arm = random_arm(rng, joints, with_errors)
    for q in rng.uniform(-3, 3, (5, joints)):
        np.testing.assert_allclose(flange_pose(arm, q), toolbox_pose(arm, q, "standard"), atol=1e-9)


def test_many_poses_at_once_equal_one_at_a_time() -> None:
    rng = np.random.default_rng(5)
    arm = random_arm(rng, 7, with_errors=True)
    q = rng.uniform(-3, 3, (50, 7))
    T = flange_poses(arm, q)
    assert T.shape == (50, 4, 4)
    for one, angles in zip(T, q, strict=True):
        np.testing.assert_allclose(one, flange_pose(arm, angles), atol=1e-12)
    expected = (T[7] @ [*arm.tip.centre_mm, 1.0])[:3]
    np.testing.assert_allclose(tip_centres(arm, q)[7], expected, atol=1e-9)


@pytest.mark.parametrize("joints", [6, 7])
def test_the_jacobian_agrees_with_numerical_differences(joints: int) -> None:
    rng = np.random.default_rng(10 + joints)
    arm = random_arm(rng, joints, with_errors=True)
    q = rng.uniform(-3, 3, joints)
    point = np.array([10.0, -20.0, 150.0])
    J, slopes = geometric_jacobian(arm, q, point), flange_slopes(arm, q, point)
    np.testing.assert_allclose(J[:3], slopes[:3], atol=1e-4)
    np.testing.assert_allclose(J[3:], slopes[3:], atol=1e-6)


def test_the_tip_scatters_as_its_covariance_says() -> None:
    rng = np.random.default_rng(21)
    arm = random_arm(rng)
    q = rng.uniform(-2, 2, 6)
    noisy = q + rng.normal(0, 1, (20000, 6)) * arm.encoder_sd_rad
    observed = np.cov(tip_centres(arm, noisy).T)
    predicted = tip_covariances(arm, q[None])[0]
    # 20 000 readings know a variance to 1 %
    np.testing.assert_allclose(observed, predicted, atol=0.03 * np.trace(predicted))


def test_the_error_transform_follows_its_definition() -> None:
    from scipy.spatial.transform import Rotation

    error = LinkError(0.1, -0.2, 0.3, 0.01, -0.02, 0.03)
    T = error_transform(error)
    # T(x, y, z) Rz Ry Rx is extrinsic x, then y, then z
    expected = Rotation.from_euler("xyz", [0.01, -0.02, 0.03]).as_matrix()
    np.testing.assert_allclose(T[:3, :3], expected, atol=1e-14)
    np.testing.assert_allclose(T[:3, 3], [0.1, -0.2, 0.3])

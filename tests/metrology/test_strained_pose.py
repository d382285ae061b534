"""Poses that strain an arm."""

from dataclasses import replace

import numpy as np
import pytest

from crenel.metrology.arm.strained_pose import Strain, strain_of
from tests.station.conftest import REST_RAD, six_axis_arm

LIMIT = np.radians(170.0)


@pytest.mark.parametrize(
    ("joint", "angle_rad", "limit_rad", "expected"),
    [
        (0, 0.0, LIMIT, None),
        (4, LIMIT - np.radians(1.0), LIMIT, "stop"),
        (4, LIMIT - np.radians(5.0), LIMIT, None),
        (2, np.radians(-90.0), LIMIT, "straight"),
        (2, np.radians(70.0), LIMIT, "base"),
        (0, 3.99, 4.0, None),  # a joint that turns endlessly has no stop
    ],
)
def test_a_strained_pose_is_named(
    joint: int, angle_rad: float, limit_rad: float, expected: Strain | None
) -> None:
    arm = six_axis_arm()
    joints = tuple(replace(one, limits_rad=(-limit_rad, limit_rad)) for one in arm.joints)
    q = REST_RAD.copy()
    q[joint] = angle_rad
    assert strain_of(replace(arm, joints=joints), q) == expected

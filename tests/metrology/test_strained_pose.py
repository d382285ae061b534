"""Poses that strain an arm."""

from dataclasses import replace

import numpy as np
import pytest

from app.metrology.arm.strained_pose import Strain, strain_of
from tests.station.conftest import REST_RAD, six_axis_arm

LIMIT = np.radians(170.0)


@pytest.mark.parametrize(
    ("joint", "angle_rad", "expected"),
    [
        (0, 0.0, None),
        (4, LIMIT - np.radians(1.0), "stop"),
        (4, LIMIT - np.radians(5.0), None),
        (2, np.radians(-90.0), "straight"),
        (2, np.radians(70.0), "base"),
    ],
)
def test_a_strained_pose_is_named(joint: int, angle_rad: float, expected: Strain | None) -> None:
    arm = six_axis_arm()
    joints = tuple(replace(one, limits_rad=(-LIMIT, LIMIT)) for one in arm.joints)
    q = REST_RAD.copy()
    q[joint] = angle_rad
    assert strain_of(replace(arm, joints=joints), q) == expected


def test_a_joint_that_turns_endlessly_has_no_stop() -> None:
    arm = six_axis_arm()
    joints = tuple(replace(one, limits_rad=(-4.0, 4.0)) for one in arm.joints)
    q = REST_RAD.copy()
    q[0] = 3.99
    assert strain_of(replace(arm, joints=joints), q) is None

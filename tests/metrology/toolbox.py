"""Arms as the robotics toolbox has them."""

import warnings
from typing import Literal

import numpy as np

from crenel.metrology.arm.kinematics import Arm
from crenel.metrology.arm.link_error import error_transform
from crenel.metrology.transforms import Floats


def toolbox_pose(arm: Arm, q: Floats, convention: Literal["standard", "modified"]) -> Floats:
    """The flange by the toolbox, of the Denavit-Hartenberg parameters and errors of an arm."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        from roboticstoolbox import DHRobot, RevoluteDH, RevoluteMDH

        kind = RevoluteDH if convention == "standard" else RevoluteMDH
        T = np.eye(4)
        for joint, angle in zip(arm.joints, q, strict=True):
            link = kind(d=joint.d_mm, a=joint.a_mm, alpha=joint.alpha_rad)
            A = DHRobot([link]).fkine([joint.sign * angle + joint.theta_rad]).A
            T = T @ A @ error_transform(joint.error)
        return T

"""Poses in which an arm bends or is badly conditioned: touches there are worse than elsewhere."""

import math
from typing import Literal

import numpy as np

from crenel.metrology.arm.kinematics import Arm, points_with_jacobians
from crenel.metrology.transforms import Floats

STOP_RAD = np.radians(3.0)
"""Nearer to its stop, a joint is pressed against it by the operator's hand."""
STRAIGHT = 0.07
"""Smallest over largest effect of the joints on the flange's position: with a straight elbow,
nothing moves it along the arm."""
NEAR_SHARE = 0.15
"""A share of the reach: nearer to the base's axis, joints turn far for small movements."""

Strain = Literal["stop", "straight", "base"]


def strain_of(arm: Arm, q_rad: Floats) -> Strain | None:
    """Why a pose strains the arm; None if it does not.

    Args:
        q_rad: (n,) encoder angles, before sign and offset.

    Source:
        Makers of arms advise against measuring at the stops, at full extension and close to the
        base (for example ASME B89.4.22 places its seats between 20 % and 80 % of the reach).
    """
    limits = np.array([joint.limits_rad for joint in arm.joints])
    bounded = np.ptp(limits, axis=1) < 2 * np.pi
    distance = np.minimum(q_rad - limits[:, 0], limits[:, 1] - q_rad)
    if (distance[bounded] < STOP_RAD).any():
        return "stop"
    origins_mm, jacobians = points_with_jacobians(arm, np.asarray(q_rad)[None], np.zeros(3))
    singular = np.linalg.svd(jacobians[0, :3], compute_uv=False)
    if singular[-1] < STRAIGHT * singular[0]:
        return "straight"
    reach = sum(math.hypot(joint.a_mm, joint.d_mm) for joint in arm.joints)
    return "base" if math.hypot(*origins_mm[0, :2]) < NEAR_SHARE * reach else None

"""Arms in the modified Denavit-Hartenberg form (Craig) as arms in the standard form, exactly.

A modified link is ``M_i = Rx(alpha_i) Tx(a_i) Rz(q_i + theta_i) Tz(d_i) E_i``: its length and twist
come before its joint. Regrouping the chain at the joints' axes leaves

    base = Rx(alpha_1) Tx(a_1),
    A_i = Rz(q_i + theta_i) Tz(d_i) Tx(a_i+1) Rx(alpha_i+1), without the last two at the last joint,

which are standard links, since rotation about and translation along one axis commute. The error
transform ``E_i`` moves behind the following length and twist ``X``, where it is ``inv(X) E_i X``.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from crenel.metrology.arm.kinematics import Joint
from crenel.metrology.arm.link_error import LinkError, error_from_transform, error_transform
from crenel.metrology.transforms import Floats, inverse


def standard_from_modified(joints: Sequence[Joint]) -> tuple[LinkError, tuple[Joint, ...]]:
    """The base transform and the standard joints of a modified chain.

    Args:
        joints: ``a_mm`` and ``alpha_rad`` of each are those before its joint; its error transform
            is that behind it.

    Returns:
        ``Arm.base`` and ``Arm.joints``: ``flange_poses`` are those of the modified chain.

    Source:
        Craig, Introduction to Robotics, section 3.4: link parameters with frames at the near end.
    """
    base = LinkError(x_mm=joints[0].a_mm, rx_rad=joints[0].alpha_rad)
    standard = []
    for i, joint in enumerate(joints):
        if i + 1 < len(joints):
            a_mm, alpha_rad = joints[i + 1].a_mm, joints[i + 1].alpha_rad
        else:
            a_mm, alpha_rad = 0.0, 0.0
        error = joint.error
        if error != LinkError():
            X = error_transform(LinkError(x_mm=a_mm, rx_rad=alpha_rad))
            error = error_from_transform(_express_behind(error_transform(error), X))
        standard.append(replace(joint, a_mm=a_mm, alpha_rad=alpha_rad, error=error))
    return base, tuple(standard)


def _express_behind(E: Floats, X: Floats) -> Floats:
    """``inv(X) E X``: the same motion, expressed in the frame behind X."""
    return np.asarray(inverse(X) @ E @ X)

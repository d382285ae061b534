"""Chains of rotary joints with every link frame near the arm.

A Denavit-Hartenberg link puts its frame where the common normal meets the next axis. If two axes
are nearly parallel, that is anywhere: kilometres away after a factory calibration. Such a link is
written as Hayati's, ``Rz(theta) Tx(a) Rx(alpha) Ry(ry)``: its frame is where the next axis meets
the x-y plane of the frame before, and its error term ``ry`` (Eq. 3) takes the place of d.
"""

from collections.abc import Sequence
from dataclasses import replace
from math import asin, atan2, hypot, pi

import numpy as np

from crenel.metrology.arm.kinematics import Arm, Joint, link_transforms
from crenel.metrology.arm.link_error import LinkError, error_from_transform, error_transform
from crenel.metrology.transforms import Floats, inverse

PARALLEL = 0.1
"""Axes with a smaller sine between them are parallel: E's ry is their angle (Hayati), not d."""
SHORTER = 2.0
"""Frames are far away if the links with near frames are this many times shorter in all."""
_NOTHING = 1e-11


def with_near_frames(arm: Arm) -> Arm:
    """The same arm with its link frames near it, if some are far away.

    Returns:
        An arm whose ``flange_poses`` are those of ``arm``; ``arm`` itself if its frames are near.

    Source:
        Hayati and Mirmirani, Improving the absolute positioning accuracy of robot manipulators,
        Journal of Robotic Systems 2 (1985), for links between nearly parallel axes.
    """
    without_base = replace(arm, base=LinkError())
    links = link_transforms(without_base, np.zeros((1, arm.joint_count)))[:, 0]
    joints = joints_of_links(links, arm.joints)
    if chain_length_mm(arm.joints) < SHORTER * chain_length_mm(joints):
        return arm
    return replace(arm, joints=joints, frames_moved_mm=max(abs(one.d_mm) for one in arm.joints))


def chain_length_mm(joints: Sequence[Joint]) -> float:
    """Sum of the lengths and offsets of all links."""
    return sum(abs(joint.a_mm) + abs(joint.d_mm) for joint in joints)


def joints_of_links(links: Floats, joints: Sequence[Joint]) -> tuple[Joint, ...]:
    """Joints whose links are, with all angles zero, those of a chain, with near frames.

    Frames about one axis differ by a screw along it, which commutes with the joint: it moves from
    the link before the axis to the link behind it.

    Args:
        links: (n, 4, 4): what follows the rotation of joint i about its z axis, up to the frame
            whose z axis is that of joint i + 1; of the last joint, up to the flange.
        joints: their names, signs, limits and encoders.

    Returns:
        The joints; the frame of the first joint is that of the chain.
    """
    found = []
    screw = np.eye(4)  # from the near frame before the joint to that of the chain
    for k, joint in enumerate(joints):
        M = inverse(screw) @ links[k]
        if k + 1 == len(joints):
            found.append(_last_joint(joint, M))
            break
        one, along_mm = _link_to_axis(joint, M)
        found.append(one)
        turned = M[:3, :3].T @ _link(one)[:3, :3]
        screw = error_transform(LinkError(z_mm=along_mm, rz_rad=atan2(turned[1, 0], turned[0, 0])))
    return tuple(found)


def _link_to_axis(joint: Joint, M: Floats) -> tuple[Joint, float]:
    """The link to the z axis of M, and how far along that axis its frame lies from M's, mm."""
    (vx, vy, vz), p = M[:3, 2], M[:3, 3]
    sine = hypot(vx, vy)
    if sine < PARALLEL:
        along = -p[2] / vz
        x, y, _ = p + along * M[:3, 2]
        theta = _half_turn(atan2(y, x)) if hypot(x, y) > _NOTHING else 0.0
        c, s = np.cos(theta), np.sin(theta)
        tilt = LinkError(ry_rad=_clean(asin(c * vx + s * vy)))
        alpha = atan2(s * vx - c * vy, vz)
        return _with_link(joint, theta, 0.0, c * x + s * y, alpha, tilt), float(along)
    theta = _half_turn(atan2(vx, -vy))  # along the common normal
    c, s = np.cos(theta), np.sin(theta)
    across, rises = -s * p[0] + c * p[1], -s * vx + c * vy
    along = -across / rises
    alpha = atan2(-rises, vz)
    d, a = p[2] + along * vz, c * p[0] + s * p[1]
    return _with_link(joint, theta, d, a, alpha, LinkError()), float(along)


def _last_joint(joint: Joint, M: Floats) -> Joint:
    """The link to the flange; what no Denavit-Hartenberg link can be is its error transform."""
    theta, alpha = atan2(M[1, 0], M[0, 0]), atan2(M[2, 1], M[2, 2])
    a = np.cos(theta) * M[0, 3] + np.sin(theta) * M[1, 3]
    one = _with_link(joint, theta, M[2, 3], a, alpha, LinkError())
    rest = error_from_transform(inverse(_link(one)) @ M)
    terms = (rest.x_mm, rest.y_mm, rest.z_mm, rest.rx_rad, rest.ry_rad, rest.rz_rad)
    return replace(one, error=LinkError(*map(_clean, terms)))


def _with_link(
    joint: Joint, theta: float, d_mm: float, a_mm: float, alpha: float, error: LinkError
) -> Joint:
    return replace(
        joint,
        theta_rad=_clean(theta),
        d_mm=_clean(d_mm),
        a_mm=_clean(a_mm),
        alpha_rad=_clean(alpha),
        error=error,
    )


def _link(joint: Joint) -> Floats:
    """(4, 4) of a link with its error, at the angle zero."""
    about_z = LinkError(z_mm=joint.d_mm, rz_rad=joint.theta_rad)
    along_x = LinkError(x_mm=joint.a_mm, rx_rad=joint.alpha_rad)
    return np.asarray(
        error_transform(about_z) @ error_transform(along_x) @ error_transform(joint.error)
    )


def _half_turn(angle: float) -> float:
    """The direction of the same line within a quarter turn of zero."""
    if angle > pi / 2 + _NOTHING:
        return angle - pi
    return angle + pi if angle <= -pi / 2 + _NOTHING else angle


def _clean(value: float) -> float:
    """Without what rounding leaves of zero."""
    return 0.0 if abs(value) < _NOTHING else float(value)

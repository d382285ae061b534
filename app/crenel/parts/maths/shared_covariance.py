"""The joint covariance of the errors that everything shares, from what files state of it."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.adjustment.core.uncertainty import LINK_AXES, link_names
from crenel.metrology.arm.identification.parameters import (
    parameter_names,
    parameter_values,
    with_parameters,
)
from crenel.metrology.arm.kinematics import Arm, link_transforms
from crenel.metrology.arm.link_error import error_from_transform, error_transform
from crenel.metrology.transforms import Floats, inverse, se3_exp, vector_from_rotation
from crenel.parts.maths.point_errors import LINKS_FROM, TIP_NAMES, name_shared_errors

STEP = 1e-6


@dataclass(frozen=True)
class ArmCovariance:
    """Covariance of the errors of links (6n) and tip (3), a twist (rad, mm) behind each link."""

    links: Floats
    tip: Floats


def place_by_name(names: Sequence[str], matrix: Floats, joint_count: int) -> Floats:
    """The covariance (P, P) of all shared errors, 0 where nothing is stated.

    Args:
        names: what the rows of ``matrix`` (K, K) belong to; others than those of
            ``name_shared_errors`` are left out.
    """
    all_names = name_shared_errors(joint_count)
    rows = [k for k, name in enumerate(names) if name in all_names]
    at = [all_names.index(names[k]) for k in rows]
    found = np.zeros((len(all_names), len(all_names)))
    found[np.ix_(at, at)] = matrix[np.ix_(rows, rows)]
    return found


def covariance_root(covariance: Floats) -> Floats:
    """(K, K) whose product with its transpose is a covariance (K, K), also of one that has no
    inverse."""
    scale = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    per_sd = np.divide(1.0, scale, out=np.zeros_like(scale), where=scale > 0)
    values, vectors = np.linalg.eigh(covariance * np.outer(per_sd, per_sd))
    return np.asarray(scale[:, None] * vectors * np.sqrt(np.maximum(values, 0.0)))


def has_links(names: Sequence[str], joint_count: int) -> bool:
    """Whether a covariance of these parameters has all links of an arm."""
    return set(link_names(joint_count)) <= set(names)


def add_arm(shared: Floats, arm: ArmCovariance) -> Floats:
    """The covariance (P, P) with links and tip that are independent of the sensor."""
    found = shared.copy()
    links = slice(LINKS_FROM, len(shared) - len(TIP_NAMES))
    tip = slice(links.stop, links.stop + 3)
    found[links, links] += arm.links
    found[tip, tip] += arm.tip
    return found


def tip_covariance(names: Sequence[str], matrix: Floats) -> Floats:
    """(3, 3) of the tip in the flange frame, by the covariance of an identification."""
    found = np.zeros((3, 3))
    own = ("tip.x_mm", "tip.y_mm", "tip.z_mm")
    rows = [k for k, name in enumerate(names) if name in own]
    at = [own.index(names[k]) for k in rows]
    found[np.ix_(at, at)] = matrix[np.ix_(rows, rows)]
    return found


def arm_by_identification(arm: Arm, names: Sequence[str], matrix: Floats) -> ArmCovariance:
    """What identified parameters leave of errors of links and tip.

    Args:
        names: as in the file, angles in degrees: ``J2.alpha_deg``, ``J3.error.x_mm``.
        matrix: (K, K) their covariance.
    """
    known = {name: k for k, name in enumerate(parameter_names(arm))}
    values = parameter_values(arm)
    by_parameters = np.zeros((6 * arm.joint_count, len(names)))
    before = _links(arm)
    for column, name in enumerate(names):
        in_rad = name.replace("_deg", "_rad")
        if in_rad not in known or name.startswith("tip."):
            continue
        moved = values.copy()
        moved[known[in_rad]] += STEP
        change = inverse(before) @ _links(with_parameters(arm, moved))
        twists = np.concatenate([vector_from_rotation(change[:, :3, :3]), change[:, :3, 3]], axis=1)
        unit = np.pi / 180 if in_rad != name else 1.0
        by_parameters[:, column] = twists.ravel() / STEP * unit
    return ArmCovariance(
        np.asarray(by_parameters @ matrix @ by_parameters.T), tip_covariance(names, matrix)
    )


def arm_by_scales(joint_count: int, links_rad: float, links_mm: float) -> ArmCovariance:
    """Errors of links of these standard deviations, all independent."""
    turns = np.array([axis.startswith("r") for axis in LINK_AXES])
    sds = np.tile(np.where(turns, links_rad, links_mm), joint_count)
    return ArmCovariance(np.diag(sds**2), np.zeros((3, 3)))


def with_links(arm: Arm, links: Floats) -> Arm:
    """The arm with errors (6n,) of its links put right, each a twist behind its link."""
    joints = (
        replace(one, error=error_from_transform(error_transform(one.error) @ se3_exp(twist)))
        for one, twist in zip(arm.joints, links.reshape(-1, 6), strict=True)
    )
    return replace(arm, joints=tuple(joints))


def _links(arm: Arm) -> Floats:
    """(n, 4, 4) at zero angles, the base left out."""
    links = link_transforms(arm, np.zeros((1, arm.joint_count)))[:, 0]
    links[0] = inverse(error_transform(arm.base)) @ links[0]
    return np.asarray(links)


def reading_sds(arm: Arm, factor: float | None, least_rad: float) -> NDArray[np.float64] | None:
    """Noise (n,) of each encoder, rad; None if it is unknown.

    A noise of 0 in the datasheet means unknown: then it is ``factor`` times ``least_rad``, as a
    calibration estimated it, if one did.
    """
    stated = arm.encoder_sd_rad
    if (stated > 0).all():
        return stated
    if factor is None:
        return None
    return np.where(stated > 0, stated, factor * least_rad)

"""Tip check: compares the tip with the arm's datasheet by probing a sphere of known size.

The apparent size of the sphere gives the tip diameter. The scatter, with the wrist turned
differently each time, shows whether the tip is at the position in the datasheet.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from crenel.gauges.quick.maths.probed_gauge import (
    agree_on_probed_sphere,
    fit_agreeing_sphere,
    sphere_through,
)
from crenel.metrology.arm.kinematics import Arm, flange_poses, tip_centres
from crenel.metrology.decision import GUARDED_95, Decision, DecisionRule, decide
from crenel.metrology.transforms import Floats

OTHER_TIP_MM = 0.3
"""A diameter that is off by this belongs to another tip (or another sphere)."""
BEND_SDS = 3.0
BEND_CONTACTS = 8
LEAST_TURN_RAD = float(np.deg2rad(25.0))
"""Minimum difference of the stylus directions for a bend to be detectable."""
K = 2.0

Cause = Literal["sound", "other-tip", "small", "large", "bent", "outlier", "scatter", "unsure"]


@dataclass(frozen=True)
class TipCheck:
    """The result of the contact points on one sphere."""

    contact_count: int
    diameter_mm: float
    """Diameter of the tip, from the contact points and the sphere's certificate."""
    error_um: float
    """Error of the diameter relative to the datasheet."""
    expanded_uncertainty_um: float
    """Its expanded uncertainty, k = 2."""
    scatter_um: float
    """Largest distance of a contact point from the sphere that fits those that agree."""
    bend_um: float | None
    """Distance of the tip centre from its position in the datasheet; None if the wrist was not
    turned enough."""
    error_decision: Decision
    """The decision on the diameter's error alone."""
    decision: Decision
    """``fail`` too if the scatter is beyond the limit."""
    cause: Cause
    outliers: tuple[int, ...]
    """Contact points, from 0, that contradict the others; only the scatter includes them."""


def check_tip(
    arm: Arm,
    q_rad: Floats,
    sphere_diameter_mm: float,
    sphere_sd_mm: float = 0.0,
    limit_um: float | None = None,
    rule: DecisionRule = GUARDED_95,
) -> TipCheck:
    """Judges the tip by contact points on a calibrated sphere.

    The apparent size of the sphere gives the tip diameter. The scatter, with the wrist turned
    differently each time, shows whether the tip is at the position in the datasheet.

    Args:
        arm: the arm with its tip from the datasheet.
        q_rad: (N, n) encoder angles at the contact points.
        sphere_diameter_mm, sphere_sd_mm: from the certificate, with its standard uncertainty.
        limit_um: for the error of the diameter and for the scatter; None: no decision.
        rule: by which the error of the diameter is judged.

    Returns:
        Errors in µm, the expanded uncertainty (k = 2), the decision by the rule and the cause.

    Raises:
        OperationError: ``too-few-touches`` or ``touches-too-close``.
    """
    agreement = agree_on_probed_sphere(arm, q_rad, sphere_diameter_mm / 2)
    # a bent tip makes all contact points disagree
    kept = agreement.kept | agreement.doubtful.any()
    found = fit_agreeing_sphere(arm, q_rad, sphere_diameter_mm / 2, kept)
    # the sphere appears larger by the excess of the tip over its datasheet
    error_mm = 2 * (found.radius_mm - sphere_diameter_mm / 2)
    sd_mm = float(np.hypot(2 * found.radius_sd_mm, sphere_sd_mm))
    tips = tip_centres(arm, q_rad)
    centre, free_mm, _ = sphere_through(tips[kept])
    off_um = 1e3 * np.abs(np.linalg.norm(tips - centre, axis=1) - free_mm)
    scatter_um = float(np.max(off_um))
    bend = _bend_mm(arm, q_rad, tips, sphere_through(tips)[0])
    error_um, expanded_um = 1e3 * error_mm, 1e3 * K * sd_mm
    both_limits = bool(np.isfinite(sd_mm))  # an unknown size has no probability between them
    of_error = decide(error_um, limit_um, 1e3 * sd_mm, rule, signed=both_limits)
    decision = of_error
    if limit_um is not None and scatter_um > limit_um:
        decision = "fail"
    return TipCheck(
        contact_count=len(q_rad),
        diameter_mm=arm.tip.diameter_mm + error_mm,
        error_um=error_um,
        expanded_uncertainty_um=expanded_um,
        scatter_um=scatter_um,
        bend_um=None if bend is None else 1e3 * bend[0],
        error_decision=of_error,
        decision=decision,
        cause=_cause(error_um, off_um, kept, expanded_um, bend, decision, limit_um),
        outliers=tuple(map(int, np.flatnonzero(~kept))),
    )


def _cause(
    error_um: float,
    off_um: Floats,
    kept: NDArray[np.bool_],
    expanded_um: float,
    bend: tuple[float, float] | None,
    decision: Decision,
    limit_um: float | None,
) -> Cause:
    if decision in ("pass", "none"):
        return "sound"
    limit, scatter_um = limit_um or 0.0, float(np.max(off_um))
    unproven = abs(error_um) <= limit and scatter_um <= limit
    if decision == "uncertain" or unproven:
        return "unsure"
    if scatter_um > limit:
        bent = bend is not None and bend[0] > BEND_SDS * bend[1] and 1e3 * bend[0] > limit
        if bent:
            return "bent"
        return "outlier" if float(np.max(off_um[kept])) <= limit else "scatter"
    if abs(error_um) > max(1e3 * OTHER_TIP_MM, expanded_um):
        return "other-tip"
    return "small" if error_um < 0 else "large"


def _bend_mm(arm: Arm, q_rad: Floats, tips: Floats, centre: Floats) -> tuple[float, float] | None:
    """Distance of the tip centre from its position in the flange frame, and the sd of that
    distance."""
    R = flange_poses(arm, q_rad)[:, :3, :3]
    stylus = R @ (arm.tip.centre_mm / np.linalg.norm(arm.tip.centre_mm))
    turned = float(np.arccos(np.clip(np.min(stylus @ stylus.T), -1.0, 1.0)))
    if len(tips) < BEND_CONTACTS or turned < LEAST_TURN_RAD:
        return None
    outward = (tips - centre) / np.linalg.norm(tips - centre, axis=1)[:, None]
    off = np.linalg.norm(tips - centre, axis=1)
    # of the sphere: centre and size; of the tip: position in the flange frame
    J = np.column_stack([outward, np.ones(len(tips)), -np.einsum("ni,nij->nj", outward, R)])
    if np.linalg.cond(J) > 1e3:
        return None
    solved = np.linalg.lstsq(J, off, rcond=None)[0]
    residuals = off - J @ solved
    freedom = max(len(off) - J.shape[1], 1)
    cofactors = np.linalg.inv(J.T @ J)[4:, 4:]
    sd = float(np.sqrt(residuals @ residuals / freedom * np.linalg.eigvalsh(cofactors)[-1]))
    return float(np.linalg.norm(solved[4:])), sd

"""Whether the probe's tip is as in the arm's datasheet: a sphere of known size is probed.

Its apparent size gives the tip's diameter; the scatter, with the wrist turned differently each
time, shows whether the tip sits where the datasheet has it.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from app.metrology.arm.kinematics import Arm, flange_poses, tip_centres
from app.metrology.gauges.conformity import Decision, decide
from app.metrology.gauges.probed_gauge import fit_probed_sphere, sphere_through
from app.metrology.transforms import Floats

OTHER_TIP_MM = 0.3
"""A diameter so far off is another tip's (or another sphere's)."""
BEND_SDS = 3.0
BEND_CONTACTS = 8
LEAST_TURN_RAD = float(np.deg2rad(25.0))
"""The stylus' directions must differ by so much for a bend to show."""
K = 2.0

Cause = Literal["sound", "other-tip", "small", "large", "bent", "scatter", "unsure"]


@dataclass(frozen=True)
class TipCheck:
    """What the touches of one sphere show of the tip."""

    contact_count: int
    diameter_mm: float
    """Of the tip, by the touches and the sphere's certificate."""
    error_um: float
    """Of the diameter against the datasheet."""
    expanded_uncertainty_um: float
    """Of the same, k = 2."""
    scatter_um: float
    """Largest distance of a touch from the sphere that fits them all."""
    bend_um: float | None
    """How far the tip's centre seems to be from where the datasheet has it; None where the
    wrist was not turned enough."""
    decision: Decision
    cause: Cause


def check_tip(
    arm: Arm,
    q_rad: Floats,
    sphere_diameter_mm: float,
    sphere_sd_mm: float = 0.0,
    limit_um: float | None = None,
) -> TipCheck:
    """Judges the tip by contact points on a calibrated sphere.

    The apparent size of the sphere gives the diameter of the tip; the scatter, with the wrist
    turned differently each time, shows whether the tip sits where the datasheet has it.

    Args:
        arm: the arm with its tip by the datasheet.
        q_rad: (N, n) encoder angles at the contact points.
        sphere_diameter_mm, sphere_sd_mm: by the certificate, with its standard uncertainty.
        limit_um: of the error of the diameter and of the scatter; None: nothing is decided.

    Returns:
        Errors in µm, the expanded uncertainty (k = 2), the decision by ISO 14253-1 and the cause.

    Raises:
        OperationError: as ``fit_probed_sphere``.
    """
    found = fit_probed_sphere(arm, q_rad, sphere_diameter_mm / 2)
    # the touches have the sphere bigger by what the tip is bigger than in its datasheet
    error_mm = 2 * (found.radius_mm - sphere_diameter_mm / 2)
    sd_mm = float(np.hypot(2 * found.radius_sd_mm, sphere_sd_mm))
    tips = tip_centres(arm, q_rad)
    centre, free_mm, _ = sphere_through(tips)
    scatter_um = 1e3 * float(np.max(np.abs(np.linalg.norm(tips - centre, axis=1) - free_mm)))
    bend = _bend_mm(arm, q_rad, tips, centre)
    error_um, expanded_um = 1e3 * error_mm, 1e3 * K * sd_mm
    decision = decide(error_um, limit_um, expanded_um)
    if limit_um is not None and scatter_um > limit_um:
        decision = "fail"
    return TipCheck(
        contact_count=len(q_rad),
        diameter_mm=arm.tip.diameter_mm + error_mm,
        error_um=error_um,
        expanded_uncertainty_um=expanded_um,
        scatter_um=scatter_um,
        bend_um=None if bend is None else 1e3 * bend[0],
        decision=decision,
        cause=_cause(error_um, scatter_um, expanded_um, bend, decision, limit_um),
    )


def _cause(
    error_um: float,
    scatter_um: float,
    expanded_um: float,
    bend: tuple[float, float] | None,
    decision: Decision,
    limit_um: float | None,
) -> Cause:
    if decision in ("pass", "none"):
        return "sound"
    if decision == "uncertain":
        return "unsure"
    limit = limit_um or 0.0
    if scatter_um > limit:
        bent = bend is not None and bend[0] > BEND_SDS * bend[1] and 1e3 * bend[0] > limit
        return "bent" if bent else "scatter"
    if abs(error_um) > max(1e3 * OTHER_TIP_MM, expanded_um):
        return "other-tip"
    return "small" if error_um < 0 else "large"


def _bend_mm(arm: Arm, q_rad: Floats, tips: Floats, centre: Floats) -> tuple[float, float] | None:
    """How far the tip's centre is off its place in the flange frame, and its own sd."""
    R = flange_poses(arm, q_rad)[:, :3, :3]
    stylus = R @ (arm.tip.centre_mm / np.linalg.norm(arm.tip.centre_mm))
    turned = float(np.arccos(np.clip(np.min(stylus @ stylus.T), -1.0, 1.0)))
    if len(tips) < BEND_CONTACTS or turned < LEAST_TURN_RAD:
        return None
    outward = (tips - centre) / np.linalg.norm(tips - centre, axis=1)[:, None]
    off = np.linalg.norm(tips - centre, axis=1)
    # of the sphere: its centre and size; of the tip: where it is in the flange frame
    J = np.column_stack([outward, np.ones(len(tips)), -np.einsum("ni,nij->nj", outward, R)])
    if np.linalg.cond(J) > 1e3:
        return None
    solved = np.linalg.lstsq(J, off, rcond=None)[0]
    residuals = off - J @ solved
    freedom = max(len(off) - J.shape[1], 1)
    cofactors = np.linalg.inv(J.T @ J)[4:, 4:]
    sd = float(np.sqrt(residuals @ residuals / freedom * np.linalg.eigvalsh(cofactors)[-1]))
    return float(np.linalg.norm(solved[4:])), sd

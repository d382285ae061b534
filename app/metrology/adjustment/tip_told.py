"""Whether contacts and pictures speak for a tip of another diameter than the arm's file has."""

from dataclasses import replace

import numpy as np

from app.metrology.adjustment.solve import Adjusted, adjust
from app.metrology.findings import Finding
from app.metrology.refusal import Refusal

# A tip's diameter is doubted beyond this many deviations, and this much.
TIP_SIGMAS, TIP_MM = 4.0, 0.02
# A wrong tip makes the arm look noisy, and then hides in that noise: from so many deviations
# on it is looked at with the noise that is left with the tip that suits best.
SUSPECTED_SIGMAS = 2.5
# A share of the contacts' information below which they tell nothing of the tip's radius: on
# three faces it goes with the block's place, and what is left is rounding.
UNSEEN = 1e-6


def about_tip(found: Adjusted) -> list[Finding]:
    """Whether contacts and pictures would agree better with a tip of another diameter."""
    told = radius_told(found)
    if told is None or not _beyond(told, SUSPECTED_SIGMAS):
        return []
    assert found.problem.touches is not None
    touches = found.problem.touches
    suited = replace(touches, radius_mm=touches.radius_mm + told[0])
    try:
        again = adjust(replace(found.problem, touches=suited), found.state)
    except Refusal:
        return []
    left = radius_told(again)
    if left is None or not _beyond((told[0] + left[0], left[1]), TIP_SIGMAS):
        return []
    given, told_mm = 2 * touches.radius_mm, 2 * (suited.radius_mm + left[0])
    return [
        Finding(
            "attention",
            "tip-diameter",
            f"Contacts and pictures agree better with a tip of {told_mm:.3f} mm "
            f"(± {2 * left[1]:.3f}) than with {given:.3f} mm.",
            "Check which tip is mounted, its diameter, and that this is the block.",
        )
    ]


def radius_told(found: Adjusted) -> tuple[float, float] | None:
    """By how much (mm) the tip's radius should be larger, and the standard deviation of that;
    None where nothing tells it.

    The radius is added to the adjustment as one more unknown, in one step.
    """
    contacts = found.linear.contacts
    if contacts is None:
        return None
    weight = 1 / contacts.variances(found.scales)
    by_radius = -np.ones(len(weight))
    J = contacts.jacobian
    pulled = J.T @ (weight * by_radius)
    free = float(weight.sum() - pulled @ found.covariance @ pulled)
    if free <= UNSEEN * float(weight.sum()):
        return None
    return -float(by_radius @ (weight * contacts.residuals_mm)) / free, free**-0.5


def _beyond(told: tuple[float, float], sigmas: float) -> bool:
    off_mm, sd_mm = told
    return abs(off_mm) >= max(sigmas * sd_mm, TIP_MM / 2)

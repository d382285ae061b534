"""Contact points that lie off the face on which all others and the pictures agree."""

from dataclasses import replace

import numpy as np

from app.metrology.adjustment.core.gauss_newton import AdjustmentResult, solve_adjustment
from app.metrology.adjustment.core.variance_components import USUAL_CONTACT_MM
from app.metrology.robust import sigma_from_median

# With fewer contact points than this, no outlier can be identified.
FEWEST_CONTACTS = 5
SIGMAS = 4.0
# Share of a contact point that the others must determine before it is judged.
LEAST_REDUNDANCY = 0.05


def remove_outlier_contacts(found: AdjustmentResult) -> AdjustmentResult:
    """Adjusts without the contact points that disagree with the others, worst first; ``kept`` marks
    the others. Fewer than half are excluded."""
    touches = found.problem.contacts
    if touches is None:
        return found
    while 2 * (int((~touches.inliers).sum()) + 1) < len(touches):
        outlier = find_outlier_contact(found)
        if outlier is None:
            break
        touches = replace(touches, inliers=touches.inliers & (np.arange(len(touches)) != outlier))
        found = solve_adjustment(replace(found.problem, contacts=touches), found.state)
    return found


def find_outlier_contact(found: AdjustmentResult) -> int | None:
    """The row of the contact point that is furthest off relative to the scatter of the others
    (their median, which a few outliers do not affect), and beyond what a usual touch and the noise
    of the readings explain; None if there is none."""
    contacts, touches = found.linear.contacts, found.problem.contacts
    if contacts is None or touches is None or len(contacts.residuals_mm) < FEWEST_CONTACTS:
        return None
    J, variance = contacts.jacobian, contacts.variances(found.scales)
    spare = np.maximum(
        1 - np.einsum("nu,uv,nv->n", J, found.covariance, J) / variance, LEAST_REDUNDANCY
    )
    off_mm = np.abs(contacts.residuals_mm) / np.sqrt(spare)
    usual_mm = np.sqrt(contacts.variances(replace(found.scales, touch_mm=USUAL_CONTACT_MM)))
    scatter_mm = max(sigma_from_median(off_mm), 1e-9)
    # few contact points determine their scatter poorly
    limit = SIGMAS * (1 + 4.0 / len(off_mm))
    off = np.minimum(off_mm / (limit * scatter_mm), off_mm / (SIGMAS * usual_mm))
    worst = int(np.argmax(off))
    return int(np.flatnonzero(touches.inliers)[worst]) if off[worst] > 1 else None

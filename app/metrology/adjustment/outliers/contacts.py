"""Contact points that lie off the face on which all others and the pictures agree."""

from dataclasses import replace

import numpy as np

from app.metrology.adjustment.core.gauss_newton import AdjustmentResult, solve_adjustment
from app.metrology.adjustment.core.linearise import ContactEquations
from app.metrology.adjustment.core.variance_components import USUAL_CONTACT_MM
from app.metrology.robust import huber_weights, sigma_from_median
from app.metrology.transforms import Floats

# With fewer contact points than this, no outlier can be identified.
FEWEST_CONTACTS = 5
SIGMAS = 4.0
# Share of a contact point that the others must determine before it is judged.
LEAST_REDUNDANCY = 0.05
# Deviations beyond this many standard deviations weigh less.
HUBER, ROBUST_STEPS = 1.5, 15
LEAST_SCATTER_MM = 1e-6


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
    off_mm = _robust_deviations_mm(contacts, found)
    usual_mm = np.sqrt(contacts.variances(replace(found.scales, touch_mm=USUAL_CONTACT_MM)))
    scatter_mm = max(sigma_from_median(off_mm), LEAST_SCATTER_MM)
    # few contact points determine their scatter poorly
    limit = SIGMAS * (1 + 4.0 / len(off_mm))
    off = np.minimum(off_mm / (limit * scatter_mm), off_mm / (SIGMAS * usual_mm))
    worst = int(np.argmax(off))
    return int(np.flatnonzero(touches.inliers)[worst]) if off[worst] > 1 else None


def _robust_deviations_mm(contacts: ContactEquations, found: AdjustmentResult) -> Floats:
    """(N,) magnitudes of the residuals about what most contact points and the pictures agree on.

    An outlier raises the estimated noise of all touches, so that they hardly move the board any
    more: all others then lie off it by the same, which hides the outlier. Here their own scatter
    weighs them (Huber's estimate, by steps of the linear equations), and each residual is divided
    by the root of its redundancy.
    """
    J, residuals_mm = contacts.jacobian, contacts.residuals_mm
    given = 1 / contacts.variances(found.scales)
    spread = J @ found.covariance @ J.T
    weights = given
    deviations_mm = np.abs(residuals_mm)
    for _ in range(ROBUST_STEPS):
        # the residuals and their covariance by the board, once these weights have moved it
        change = np.eye(len(given)) - spread * (given - weights)
        moved = np.linalg.solve(change, np.column_stack([spread, residuals_mm]))
        redundancy = np.maximum(1 - np.diag(moved[:, :-1]) * weights, LEAST_REDUNDANCY)
        deviations_mm = np.abs(moved[:, -1]) / np.sqrt(redundancy)
        scatter_mm = max(sigma_from_median(deviations_mm), LEAST_SCATTER_MM)
        weights = huber_weights(deviations_mm, HUBER * scatter_mm) / scatter_mm**2
    return deviations_mm

"""Contact points that lie off the face on which all others and the pictures agree."""

from dataclasses import replace

import numpy as np

from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult, solve_adjustment
from crenel.metrology.adjustment.core.variance_components import USUAL_CONTACT_MM
from crenel.metrology.fitting.outlier_search import Disagreement, Outliers, find_outlier_points
from crenel.metrology.fitting.touched_shape import CONTACT_SD_MM, refuse_doubt

# With fewer contact points than this, no outlier can be identified.
FEWEST_CONTACTS = 4


def remove_outlier_contacts(found: AdjustmentResult) -> AdjustmentResult:
    """Adjusts without the contact points that contradict the others; ``inliers`` marks the others.
    Fewer than half are excluded.

    Raises:
        OperationError: as ``refuse_doubt``.
    """
    touches = found.problem.contacts
    if touches is None:
        return found
    inliers = touches.inliers.copy()
    while True:
        own, outliers = np.flatnonzero(inliers), find_outlier_contacts(found)
        if len(outliers.doubtful) < len(own):  # else no contact point is the cause
            refuse_doubt(np.isin(np.arange(len(touches)), own[list(outliers.doubtful)]))
        left = inliers & ~np.isin(np.arange(len(touches)), own[list(outliers.points)])
        if not outliers.points or 2 * int((~left).sum()) >= len(touches):
            return found
        inliers = left
        contacts = replace(touches, inliers=inliers)
        found = solve_adjustment(replace(found.problem, contacts=contacts), found.state)


def find_outlier_contacts(found: AdjustmentResult) -> Outliers:
    """Which of the contact points that count contradict the others and the pictures.

    An outlier raises the estimated noise of all touches, so that they hardly move the board any
    more: all others then lie off it by the same. So each is judged as if it were touched as well as
    is usual, by its residual from what the pictures alone say, of which the covariance follows
    from that of the adjustment.
    """
    contacts = found.linear.contacts
    if contacts is None or len(contacts.residuals_mm) < FEWEST_CONTACTS:
        return Outliers()
    J = contacts.jacobian
    given = contacts.variances(found.scales)
    usual = contacts.variances(replace(found.scales, touch_mm=USUAL_CONTACT_MM))
    # inverse covariance of these residuals, with the variances of the adjustment, then the usual
    by_given = J / given[:, None]
    information = np.diag(1 / given) - by_given @ found.covariance @ by_given.T
    both = np.column_stack([information, contacts.residuals_mm / given])
    solved = np.linalg.solve(np.eye(len(given)) + information * (usual - given), both)
    sds = np.sqrt(usual)
    whitened = sds[:, None] * solved[:, :-1] * sds
    most = max(CONTACT_SD_MM**2 / float(np.min(usual)), 1.0)
    return find_outlier_points(
        Disagreement((whitened + whitened.T) / 2, sds * solved[:, -1], 1, most)
    )

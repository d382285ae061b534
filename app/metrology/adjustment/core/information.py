"""The information of a session without noise: what any adjustment of it could know at best."""

import numpy as np

from app.metrology.adjustment.core.gauss_newton import AdjustmentResult, free_covariance
from app.metrology.adjustment.core.linearise import assemble_normal_equations, linearise
from app.metrology.adjustment.core.observations import AdjustmentProblem
from app.metrology.adjustment.core.parameters import LENS, AdjustmentState, parameter_layout
from app.metrology.adjustment.core.robust_weights import unit_weights
from app.metrology.adjustment.core.variance_components import Scales


def information_at(
    problem: AdjustmentProblem, truth: AdjustmentState, scales: Scales
) -> AdjustmentResult:
    """The adjustment's normal matrix at the truth, with true weights.

    Args:
        problem: observations without noise.
        truth: the state that they belong to; lens terms that are zero there are held.
        scales: noise of arm and contacts.

    Returns:
        The truth with its covariance.

    Raises:
        OperationError: ``adjustment-failed``, where an unknown is not determined.

    Source:
        The inverse of the normal matrix is the (Bayesian) Cramér-Rao bound for all unknowns.
    """
    at = parameter_layout(problem)
    linear = linearise(problem, at, truth)
    weights = tuple(
        (unit_weights(len(shape.sigma)), unit_weights(len(stripe.sigma)))
        for shape, stripe in linear.rows
    )
    parts, _ = assemble_normal_equations(linear, weights).with_scales(scales)
    free = np.ones(at.count, dtype=np.bool_)
    free[np.arange(LENS.start, LENS.stop)] = truth.camera.distortion[:4] != 0
    covariance = free_covariance(np.sum(list(parts.values()), axis=0), free)
    return AdjustmentResult(
        linear, scales, free, covariance, parts, weights, scales_estimated=False
    )

"""The information of a session without noise: what any adjustment of it could know at best."""

from dataclasses import replace

import numpy as np

from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult, free_covariance
from crenel.metrology.adjustment.core.linearise import (
    Linearisation,
    NormalEquations,
    PoseWeights,
    assemble_normal_equations,
    linearise,
)
from crenel.metrology.adjustment.core.observations import AdjustmentProblem
from crenel.metrology.adjustment.core.parameters import LENS, AdjustmentState, parameter_layout
from crenel.metrology.adjustment.core.robust_weights import unit_weights
from crenel.metrology.adjustment.core.variance_components import Scales
from crenel.metrology.transforms import Floats


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
    return solve_information(exact_equations(problem, truth), scales)


def exact_equations(problem: AdjustmentProblem, truth: AdjustmentState) -> NormalEquations:
    """The normal equations at the truth, with true weights; arguments as ``information_at``."""
    at = parameter_layout(problem)
    linear = linearise(problem, at, truth)
    return assemble_normal_equations(linear, _true_weights(linear))


def _true_weights(linear: Linearisation) -> PoseWeights:
    return tuple(
        (unit_weights(len(shape.sigma)), unit_weights(len(stripe.sigma)))
        for shape, stripe in linear.rows
    )


def with_certificate(equations: NormalEquations, sd_mm: Floats) -> NormalEquations:
    """The same with other standard uncertainties (B,) of the object's coordinates."""
    linear = equations.linear
    prior = replace(linear.problem.prior, sd=sd_mm)
    problem = replace(linear.problem, prior=prior)
    return replace(equations, linear=replace(linear, problem=problem))


def solve_information(equations: NormalEquations, scales: Scales) -> AdjustmentResult:
    """The adjustment at the truth; arguments, result and error as ``information_at``."""
    linear = equations.linear
    parts, _ = equations.with_scales(scales)
    free = np.ones(linear.at.count, dtype=np.bool_)
    free[np.arange(LENS.start, LENS.stop)] = linear.state.camera.distortion[:4] != 0
    covariance = free_covariance(np.sum(list(parts.values()), axis=0), free)
    weights = _true_weights(linear)
    return AdjustmentResult(
        linear, scales, free, covariance, parts, weights, scales_estimated=False
    )

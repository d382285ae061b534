"""The most likely values of all unknowns: Gauss-Newton, with weights and scales updated on the
way."""

from dataclasses import dataclass, replace
from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray
from scipy.linalg.lapack import dpotrf, dpotri

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.adjustment.core.linearise import (
    Linearisation,
    NormalEquations,
    PoseWeights,
    assemble_normal_equations,
    linearise,
)
from crenel.metrology.adjustment.core.link_error_prior import estimate_link_size_covariance
from crenel.metrology.adjustment.core.observations import AdjustmentProblem
from crenel.metrology.adjustment.core.parameters import (
    CAMERA,
    LENS,
    MOUNT,
    PLANE,
    AdjustmentState,
    ParameterLayout,
    parameter_layout,
)
from crenel.metrology.adjustment.core.robust_weights import robust_weights
from crenel.metrology.adjustment.core.variance_components import (
    Scales,
    default_scales,
    estimate_contact_sd,
    estimate_link_errors,
    estimate_noise_factor,
    iterate_scales,
)
from crenel.metrology.transforms import Floats

# Lens terms, each held at zero unless it exceeds its standard deviation by this factor: larger for
# terms that lenses seldom need, which are tried first.
LENS_TERMS = (((2, 3), 5.0), ((1,), 3.0), ((0,), 2.0))
# Maximum number of times that points are judged again after the adjustment.
MOST_REWEIGHTINGS = 4
# Judgements are equal if at most this share of points changed, and weights changed by at most this.
SAME_POINTS, SAME_WEIGHTS = 0.003, 0.05
# Scales are estimated in the first iterations only, so that the rest converge.
ROUNDS_OF_SCALES = 4
MOST_ROUNDS = 30
CONVERGED = 1e-3  # converged if the step is smaller than this relative to every standard deviation


@dataclass(frozen=True)
class AdjustmentResult:
    """The most likely state, its covariance (U, U) at these noise levels, and how well all
    observations agree with it.

    ``parts`` splits the normal matrix by ``linearise.SOURCES``; ``free`` (U,) are the unknowns that
    were not held (lens terms that are not significant are held at zero). ``scales_estimated`` says
    whether the noise levels were estimated from the data. ``by_kept`` (U, U) is the covariance
    that a camera and mounting of an earlier calibration carry into the state, if they were kept.
    """

    linear: Linearisation
    scales: Scales
    free: NDArray[np.bool_]
    covariance: Floats
    parts: dict[str, Floats]
    weights: PoseWeights
    scales_estimated: bool
    by_kept: Floats | None = None

    @property
    def problem(self) -> AdjustmentProblem:
        return self.linear.problem

    @property
    def state(self) -> AdjustmentState:
        return self.linear.state

    @property
    def layout(self) -> ParameterLayout:
        return self.linear.at

    @cached_property
    def link_size_covariance(self) -> Floats:
        """(U, U) additional covariance because the size of the link errors is not exactly known."""
        if not (self.scales_estimated and len(self.state.links)):
            return np.zeros_like(self.covariance)
        return estimate_link_size_covariance(
            assemble_normal_equations(self.linear, self.weights), self.scales, self.free
        )

    @property
    def uncertainty(self) -> Floats:
        """(U, U) covariance of the state, including those of the unknown size of the link errors
        and of what was kept."""
        own = self.covariance + self.link_size_covariance
        return np.asarray(own if self.by_kept is None else own + self.by_kept)


def solve_adjustment(
    problem: AdjustmentProblem, start: AdjustmentState, known: Scales | None = None
) -> AdjustmentResult:
    """The state of maximum likelihood for all observations, by Gauss-Newton.

    Outliers are excluded and noise levels estimated on the way. Lens terms that do not clearly
    exceed their standard uncertainty are held at zero, one group after another. The sizes of the
    link errors are known only roughly, which increases the uncertainty.

    Args:
        problem: the observations of all poses, contact points and the certificate.
        start: start of the iteration.
        known: noise levels; None: they are estimated from the data.

    Returns:
        The state of U unknowns with its covariance (U, U), k = 1.

    Raises:
        OperationError: ``too-few-edges`` or ``adjustment-failed``.

    Source:
        Variance components: Förstner's estimate, iterated.
    """
    at = parameter_layout(problem)
    free = np.ones(at.count, dtype=np.bool_)
    free[PLANE] = problem.has_lines
    free[CAMERA] = free[MOUNT] = not problem.keeps_sensor
    scales = known or default_scales(problem.motion.usual_factor)
    rounds = 0 if known else ROUNDS_OF_SCALES
    linear = linearise(problem, at, start)
    judgements = _weigh_observations(linear)
    for _ in range(MOST_REWEIGHTINGS):
        found = _iterate(*_bin_views(linear, judgements), scales, free, rounds)
        found = _drop_lens_terms(found, rounds)
        scales, free = found.scales, found.free
        # With all points, not the few merged ones.
        linear = linearise(problem, at, found.state)
        again = _weigh_observations(linear)
        if _alike(again, judgements):
            break
        judgements = again
    return replace(found, linear=linear, weights=judgements)


def _weigh_observations(linear: Linearisation) -> PoseWeights:
    judgements = tuple(
        (robust_weights(shape), robust_weights(stripe)) for shape, stripe in linear.rows
    )
    _require_enough(judgements, linear.problem)
    return judgements


def _alike(a: PoseWeights, b: PoseWeights) -> bool:
    """Whether nearly the same points count, with nearly the same weights."""
    for ours, theirs in zip(a, b, strict=True):
        for one, other in zip(ours, theirs, strict=True):
            if not len(one.inliers):
                continue
            if np.mean(one.inliers != other.inliers) > SAME_POINTS:
                return False
            if np.mean(np.abs(np.log(one.inflation / other.inflation))) > SAME_WEIGHTS:
                return False
    return True


def _drop_lens_terms(found: AdjustmentResult, rounds_of_scales: int) -> AdjustmentResult:
    """Adjusts again without the lens terms that are not significant.

    Each term is judged with those before it held at zero; the model is linear for such small
    values.
    """
    free, state, C = found.free.copy(), found.state, found.covariance
    for term, significant in LENS_TERMS:
        where = [LENS.start + k for k in term]
        if not free[where].any():
            continue
        value = state.camera.distortion[list(term)]
        answer = np.linalg.solve(C[np.ix_(where, where)], np.column_stack([value, C[where]]))
        if float(value @ answer[:, 0]) > significant**2:
            if term == (2, 3):
                continue
            break  # lower terms stay with the higher ones
        state = state.apply_step(-C[:, where] @ answer[:, 0], found.layout)
        C = C - C[:, where] @ answer[:, 1:]
        free[where] = False
    if np.array_equal(free, found.free):
        return found
    linear = linearise(found.problem, found.layout, _without_lens(state, free))
    return _iterate(linear, found.weights, found.scales, free, rounds_of_scales)


def _without_lens(state: AdjustmentState, free: NDArray[np.bool_]) -> AdjustmentState:
    """The state with exactly zero for the lens terms that are held."""
    distortion = state.camera.distortion.copy()
    distortion[:4][~free[LENS]] = 0.0
    return replace(state, camera=replace(state.camera, distortion=distortion))


def _bin_views(linear: Linearisation, judgements: PoseWeights) -> tuple[Linearisation, PoseWeights]:
    """The problem with adjacent points merged, for the iterations of the adjustment."""
    problem = linear.problem
    few = [
        view.bin_points(rows, judgement)
        for view, rows, judgement in zip(problem.views, linear.rows, judgements, strict=True)
    ]
    fewer = replace(problem, views=tuple(view for view, _ in few))
    return linearise(fewer, linear.at, linear.state), tuple(judgement for _, judgement in few)


@np.errstate(over="ignore", invalid="ignore")
def _iterate(
    linear: Linearisation,
    judgements: PoseWeights,
    scales: Scales,
    free: NDArray[np.bool_],
    rounds_of_scales: int,
) -> AdjustmentResult:
    """Gauss-Newton with points and weights as judged; the scales are estimated on the way.

    A divergent iteration is refused, so that overflows need no error of their own.
    """
    at = linear.at
    for turn in range(MOST_ROUNDS):
        equations = assemble_normal_equations(linear, judgements)
        if turn < rounds_of_scales:
            scales = iterate_scales(scales, partial(_update_scales, equations, free))
        parts, g = equations.with_scales(scales)
        covariance = free_covariance(np.sum(list(parts.values()), axis=0), free)
        step = -covariance @ g
        if not (np.isfinite(step).all() and (np.diag(covariance)[free] > 0).all()):
            break
        largest = float(np.max(np.abs(step[free]) / np.sqrt(np.diag(covariance)[free])))
        if largest < CONVERGED and turn > 0:
            scales_estimated = rounds_of_scales > 0
            return AdjustmentResult(
                linear, scales, free, covariance, parts, judgements, scales_estimated
            )
        linear = linearise(linear.problem, at, linear.state.apply_step(step, at))
    raise no_convergence_error()


def no_convergence_error() -> OperationError:
    """The error if there is no minimum, or a meaningless one."""
    return OperationError(
        "adjustment-failed",
        message("calibrations-unknowns-did-settle-what-seen"),
        message("pictures-contacts-certificate-contradict-each-other"),
        message("check-object-pictures-every-picture-belongs"),
    )


def _update_scales(equations: NormalEquations, free: NDArray[np.bool_], scales: Scales) -> Scales:
    """The scales that correspond to the residuals after the step of this iteration."""
    linear, at = equations.linear, equations.linear.at
    parts, g = equations.with_scales(scales)
    covariance = free_covariance(np.sum(list(parts.values()), axis=0), free)
    step = -covariance @ g
    own = np.diag(covariance)
    moves = linear.problem.motion
    sd = np.tile(moves.noise_sd, len(linear.problem.views))
    noise = (linear.state.noise.ravel() + step[at.noise]) / sd
    touch = scales.touch_mm
    contacts = linear.contacts
    if contacts is not None:
        J = contacts.jacobian
        touch = estimate_contact_sd(
            contacts.residuals_mm + J @ step,
            scales.noise**2 * contacts.noise_mm2,
            np.einsum("nu,nu->n", J @ covariance, J),
            scales,
        )
    factor = estimate_noise_factor(noise, own[at.noise] / sd**2, scales.noise, moves.usual_factor)
    return Scales(
        *estimate_link_errors(linear.state.links + step[at.links], own[at.links], scales),
        max(factor, moves.least_factor),
        touch,
    )


def _require_enough(judgements: PoseWeights, problem: AdjustmentProblem) -> None:
    found = sum(int(np.sum(one.inliers)) for pair in judgements for one in pair)
    wanted = 11 + 6 * len(problem.views)
    if found < wanted + 4:
        raise OperationError(
            "too-few-edges",
            message("usable-edge-stripe-points-poses", found=found, views=len(problem.views)),
            message("they-do-not-determine-camera"),
            message("bring-more-object-into-picture-sharp"),
        )


def free_covariance(N: Floats, free: NDArray[np.bool_]) -> Floats:
    """The covariance of the free unknowns, with zeros for those that are held.

    Args:
        N: (U, U) normal matrix.
        free: (U,) unknowns that are not held.

    Returns:
        (U, U).

    Raises:
        OperationError: ``adjustment-failed``, where an unknown is not determined.

    Example:
        >>> free_covariance(np.diag([4.0, 0.0, 1.0]), np.array([True, False, True])).tolist()
        [[0.25, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
    """
    own = N[np.ix_(free, free)]
    if not (np.diag(own) > 0).all():
        raise no_convergence_error()
    scale = 1 / np.sqrt(np.diag(own))
    both = np.outer(scale, scale)
    factor, undetermined = dpotrf(own * both, lower=True)
    if undetermined:
        raise no_convergence_error()
    lower, _ = dpotri(factor, lower=True)
    covariance = np.zeros_like(N)
    covariance[np.ix_(free, free)] = (np.tril(lower) + np.tril(lower, -1).T) * both
    return covariance

"""The most likely values of all unknowns: Gauss-Newton, weights and scales judged on the way."""

from dataclasses import dataclass, replace
from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray

from app.errors import Refusal
from app.metrology.adjustment.core.linearise import Judgements, Linear, Normal, linearise, normal
from app.metrology.adjustment.core.link_error_prior import by_link_sizes
from app.metrology.adjustment.core.observations import Problem
from app.metrology.adjustment.core.parameters import LENS, Layout, State, layout_of
from app.metrology.adjustment.core.robust_weights import judged
from app.metrology.adjustment.core.variance_components import (
    Scales,
    links_told,
    settled,
    told_by,
    touch_told,
    usual_scales,
)
from app.metrology.transforms import Floats

# Terms of the lens, each dropped unless it exceeds its deviation so many times: more for
# those that lenses seldom need, which are tried first.
LENS_TERMS = (((2, 3), 5.0), ((1,), 3.0), ((0,), 2.0))
# Points are judged anew after the adjustment, so often at most.
MOST_JUDGEMENTS = 4
# Judgements are alike where so few points changed sides, and weights by so little.
KEPT_ALIKE, WEIGHED_ALIKE = 0.003, 0.05
# Scales are told in the first rounds only, so that the rest converge.
ROUNDS_OF_SCALES = 4
MOST_ROUNDS = 30
SETTLED = 1e-3  # a step this small against every standard deviation


@dataclass(frozen=True)
class Adjusted:
    """The most likely state, its covariance (U, U) for the scales told, and how well all agrees
    with it.

    ``parts`` splits the normal matrix by ``linear.SOURCES``; ``free`` (U,) are the
    unknowns that were not held (lens terms that are not significant are held at zero).
    ``scales_told`` is whether the data told the scales; they were known before otherwise.
    """

    linear: Linear
    scales: Scales
    free: NDArray[np.bool_]
    covariance: Floats
    parts: dict[str, Floats]
    judgements: Judgements
    rounds: int
    scales_told: bool

    @property
    def problem(self) -> Problem:
        return self.linear.problem

    @property
    def state(self) -> State:
        return self.linear.state

    @property
    def layout(self) -> Layout:
        return self.linear.at

    @cached_property
    def by_link_sizes(self) -> Floats:
        """(U, U) what comes beside of not knowing how large the links' errors are."""
        if not (self.scales_told and len(self.state.links)):
            return np.zeros_like(self.covariance)
        return by_link_sizes(normal(self.linear, self.judgements), self.scales, self.free)

    @property
    def uncertainty(self) -> Floats:
        """(U, U) covariance of the state, all told."""
        return np.asarray(self.covariance + self.by_link_sizes)


def adjust(problem: Problem, start: State, known: Scales | None = None) -> Adjusted:
    """The most likely state for all that was seen, touched and certified.

    Lens terms that do not exceed their deviation clearly are held at zero, one group
    after another. The noise's scales are told by the data, unless they are ``known``; how
    large the links' errors are is told so loosely that the uncertainty grows by it.

    Raises:
        Refusal: fewer observations than unknowns, or no minimum found.
    """
    at = layout_of(problem)
    free = np.ones(at.count, dtype=np.bool_)
    scales = known or usual_scales(problem.motion.usual_factor)
    rounds = 0 if known else ROUNDS_OF_SCALES
    linear = linearise(problem, at, start)
    judgements = _judged(linear)
    for _ in range(MOST_JUDGEMENTS):
        found = _settled(*_merged(linear, judgements), scales, free, rounds)
        found = _lens_chosen(found, rounds)
        scales, free = found.scales, found.free
        # With every point, not the few that were made of them.
        linear = linearise(problem, at, found.state)
        again = _judged(linear)
        if _alike(again, judgements):
            break
        judgements = again
    return replace(found, linear=linear, judgements=judgements)


def _judged(linear: Linear) -> Judgements:
    judgements = tuple((judged(shape), judged(stripe)) for shape, stripe in linear.rows)
    _require_enough(judgements, linear.problem)
    return judgements


def _alike(a: Judgements, b: Judgements) -> bool:
    """Whether nearly the same points count, for nearly as much."""
    for ours, theirs in zip(a, b, strict=True):
        for one, other in zip(ours, theirs, strict=True):
            if not len(one.kept):
                continue
            if np.mean(one.kept != other.kept) > KEPT_ALIKE:
                return False
            if np.mean(np.abs(np.log(one.inflation / other.inflation))) > WEIGHED_ALIKE:
                return False
    return True


def _lens_chosen(found: Adjusted, rounds_of_scales: int) -> Adjusted:
    """Adjusted again without the lens terms that are not significant.

    Each is judged with those before it held at zero, which is linear in so small values.
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
        state = state.moved(-C[:, where] @ answer[:, 0], found.layout)
        C = C - C[:, where] @ answer[:, 1:]
        free[where] = False
    if np.array_equal(free, found.free):
        return found
    linear = linearise(found.problem, found.layout, _without_lens(state, free))
    return _settled(linear, found.judgements, found.scales, free, rounds_of_scales)


def _without_lens(state: State, free: NDArray[np.bool_]) -> State:
    """With exactly zero for the lens terms that are held."""
    distortion = state.camera.distortion.copy()
    distortion[:4][~free[LENS]] = 0.0
    return replace(state, camera=replace(state.camera, distortion=distortion))


def _merged(linear: Linear, judgements: Judgements) -> tuple[Linear, Judgements]:
    """The same with neighbouring points put together, for the rounds of the adjustment."""
    problem = linear.problem
    few = [
        view.merged(rows, judgement)
        for view, rows, judgement in zip(problem.views, linear.rows, judgements, strict=True)
    ]
    fewer = replace(problem, views=tuple(view for view, _ in few))
    return linearise(fewer, linear.at, linear.state), tuple(judgement for _, judgement in few)


@np.errstate(over="ignore", invalid="ignore")
def _settled(
    linear: Linear,
    judgements: Judgements,
    scales: Scales,
    free: NDArray[np.bool_],
    rounds_of_scales: int,
) -> Adjusted:
    """Gauss-Newton with points and weights as they were judged, the scales told on the way.

    Where it runs away, it is refused, so that numbers too large need no word of their own.
    """
    at = linear.at
    for turn in range(MOST_ROUNDS):
        equations = normal(linear, judgements)
        if turn < rounds_of_scales:
            scales = settled(scales, partial(_told, equations, free))
        parts, g = equations.with_scales(scales)
        covariance = embedded(np.sum(list(parts.values()), axis=0), free)
        step = -covariance @ g
        if not (np.isfinite(step).all() and (np.diag(covariance)[free] > 0).all()):
            break
        largest = float(np.max(np.abs(step[free]) / np.sqrt(np.diag(covariance)[free])))
        if largest < SETTLED and turn > 0:
            told = rounds_of_scales > 0
            return Adjusted(linear, scales, free, covariance, parts, judgements, turn + 1, told)
        linear = linearise(linear.problem, at, linear.state.moved(step, at))
    raise unsettled()


def unsettled() -> Refusal:
    """The refusal where no minimum is found, or one that says nothing."""
    return Refusal(
        "adjustment-failed",
        "the calibration's unknowns did not settle on what was seen and touched",
        "the pictures, the contacts and the certificate contradict each other",
        "check that this is the object in the pictures, and that every picture belongs to"
        " its arm pose",
    )


def _told(equations: Normal, free: NDArray[np.bool_], scales: Scales) -> Scales:
    """The scales that the residuals after this round's step speak for."""
    linear, at = equations.linear, equations.linear.at
    parts, g = equations.with_scales(scales)
    covariance = embedded(np.sum(list(parts.values()), axis=0), free)
    step = -covariance @ g
    own = np.diag(covariance)
    moves = linear.problem.motion
    sd = np.tile(moves.noise_sd, len(linear.problem.views))
    noise = (linear.state.noise.ravel() + step[at.noise]) / sd
    touch = scales.touch_mm
    contacts = linear.contacts
    if contacts is not None:
        J = contacts.jacobian
        touch = touch_told(
            contacts.residuals_mm + J @ step,
            scales.noise**2 * contacts.noise_mm2,
            np.einsum("nu,nu->n", J @ covariance, J),
            scales,
        )
    factor = told_by(noise, own[at.noise] / sd**2, scales.noise, moves.usual_factor)
    return Scales(
        *links_told(linear.state.links + step[at.links], own[at.links], scales),
        max(factor, moves.least_factor),
        touch,
    )


def _require_enough(judgements: Judgements, problem: Problem) -> None:
    found = sum(int(np.sum(one.kept)) for pair in judgements for one in pair)
    wanted = 11 + 6 * len(problem.views)
    if found < wanted + 4:
        raise Refusal(
            "too-few-edges",
            f"{found} usable edge and stripe points in {len(problem.views)} poses",
            "they do not determine the camera",
            "bring more of the object into the picture, sharp and well lit",
        )


def embedded(N: Floats, free: NDArray[np.bool_]) -> Floats:
    """The covariance (U, U) of the free unknowns, with zeros for those that are held.

    Raises:
        Refusal: ``adjustment-failed``: some unknown is not determined.
    """
    own = N[np.ix_(free, free)]
    if not (np.diag(own) > 0).all():
        raise unsettled()
    scale = 1 / np.sqrt(np.diag(own))
    covariance = np.zeros_like(N)
    try:
        inverted = np.linalg.inv(own * np.outer(scale, scale)) * np.outer(scale, scale)
    except np.linalg.LinAlgError:
        raise unsettled() from None
    covariance[np.ix_(free, free)] = inverted
    return covariance

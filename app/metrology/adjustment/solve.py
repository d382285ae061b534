"""The most likely values of all unknowns: Gauss-Newton, weights and scales judged on the way."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from app.metrology.adjustment.evidence import Problem
from app.metrology.adjustment.linear import Judgements, Linear, Normal, linearise, normal
from app.metrology.adjustment.scales import (
    USUAL_LINKS_MM,
    USUAL_LINKS_RAD,
    Scales,
    settled,
    told_by,
    touch_told,
    usual_scales,
)
from app.metrology.adjustment.state import LENS, Layout, State, layout_of
from app.metrology.adjustment.weighing import judged
from app.metrology.frames import Floats
from app.metrology.refusal import Refusal

# Terms of the lens, each dropped unless it exceeds its deviation so many times: more for
# those that lenses seldom need, which are tried first.
LENS_TERMS = (((2, 3), 5.0), ((1,), 3.0), ((0,), 2.0))
# Outliers, scatter and scales are judged anew in the first rounds only, so that the rest
# converge.
ROUNDS_OF_JUDGING = 4
MOST_ROUNDS = 30
SETTLED = 1e-3  # a step this small against every standard deviation


@dataclass(frozen=True)
class Adjusted:
    """The most likely state, its covariance (U, U), and how well all agrees with it.

    ``parts`` splits the normal matrix by ``linear.SOURCES``; ``free`` (U,) are the
    unknowns that were not held (lens terms that are not significant are held at zero).
    """

    linear: Linear
    scales: Scales
    free: NDArray[np.bool_]
    covariance: Floats
    parts: dict[str, Floats]
    judgements: Judgements
    rounds: int

    @property
    def problem(self) -> Problem:
        return self.linear.problem

    @property
    def state(self) -> State:
        return self.linear.state

    @property
    def layout(self) -> Layout:
        return self.linear.at


def adjust(problem: Problem, start: State) -> Adjusted:
    """The most likely state for all that was seen, touched and certified.

    Lens terms that do not exceed their deviation clearly are held at zero, one group
    after another.

    Raises:
        Refusal: fewer observations than unknowns, or no minimum found.
    """
    at = layout_of(problem)
    free = np.ones(at.count, dtype=np.bool_)
    best = _adjust(problem, start, usual_scales(problem.motion.usual_factor), free)
    for term, significant in LENS_TERMS:
        where = [LENS.start + k for k in term]
        value = best.state.camera.distortion[list(term)]
        square = float(value @ np.linalg.solve(best.covariance[np.ix_(where, where)], value))
        if square > significant**2:
            if term == (2, 3):
                continue
            break  # lower terms stay with the higher ones
        free = free.copy()
        free[where] = False
        best = _adjust(problem, _without(best.state, term), best.scales, free)
    return best


def _without(state: State, term: Sequence[int]) -> State:
    distortion = state.camera.distortion.copy()
    distortion[list(term)] = 0.0
    return replace(state, camera=replace(state.camera, distortion=distortion))


def _adjust(problem: Problem, state: State, scales: Scales, free: NDArray[np.bool_]) -> Adjusted:
    at = layout_of(problem)
    judgements: Judgements = ()
    for turn in range(MOST_ROUNDS):
        linear = linearise(problem, at, state)
        if turn < ROUNDS_OF_JUDGING:
            judgements = tuple((judged(shape), judged(stripe)) for shape, stripe in linear.rows)
            _require_enough(judgements, problem)
        equations = normal(linear, judgements)
        if turn < ROUNDS_OF_JUDGING:
            scales = settled(scales, partial(_told, equations, free))
        parts, g = equations.with_scales(scales)
        covariance = embedded(np.sum(list(parts.values()), axis=0), free)
        step = -covariance @ g
        largest = float(np.max(np.abs(step[free]) / np.sqrt(np.diag(covariance)[free])))
        if largest < SETTLED and turn >= ROUNDS_OF_JUDGING - 1:
            return Adjusted(linear, scales, free, covariance, parts, judgements, turn + 1)
        state = state.moved(step, at)
    raise Refusal(
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
    links, of_links = linear.state.links + step[at.links], own[at.links]
    turning = np.arange(len(links)) % 6 < 3
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
        told_by(links[turning], of_links[turning], scales.links_rad, USUAL_LINKS_RAD),
        told_by(links[~turning], of_links[~turning], scales.links_mm, USUAL_LINKS_MM),
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
    """The covariance (U, U) of the free unknowns, with zeros for those that are held."""
    own = N[np.ix_(free, free)]
    scale = 1 / np.sqrt(np.diag(own))
    covariance = np.zeros_like(N)
    inverted = np.linalg.inv(own * np.outer(scale, scale)) * np.outer(scale, scale)
    covariance[np.ix_(free, free)] = inverted
    return covariance

"""How large the links' errors are is itself not known, and the result's uncertainty grows by that.

One set of contacts determines the size of turns and shifts to half of their value or so. With
the likeliest size alone the covariance would be believed as if that were certain; what the
result moves by from size to size, each counted by how well it explains all that was measured,
adds to it (Kass and Steffey 1989, their first order, for hierarchical models in general). The
covariance itself stays that of the estimated size.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from app.metrology.adjustment.core.linearise import NormalEquations
from app.metrology.adjustment.core.variance_components import Scales, size_prior
from app.metrology.transforms import Floats

# Sizes looked at, as factors of those estimated, of turns and of shifts alike.
FACTORS = np.exp(np.linspace(-1.5, 1.5, 7))


def estimate_link_size_covariance(
    equations: NormalEquations, scales: Scales, free: NDArray[np.bool_]
) -> Floats:
    """What not knowing the sizes of the links' errors adds to the state's covariance (U, U).

    Args:
        equations: at the minimum, about which they are taken as linear.
        scales: as estimated; sizes around them are looked at, noise and touches as they are.
        free: (U,) the unknowns that are not held.
    """
    at = equations.linear.at
    parts, _ = equations.with_scales(scales)
    links = np.arange(at.count)[at.links]
    others = np.setdiff1d(np.flatnonzero(free), links)
    start = equations.linear.state.links
    N = np.sum([part for source, part in parts.items() if source != "links"], axis=0)
    # The other unknowns follow the links, so that each size costs a small system only.
    scale = 1 / np.sqrt(np.diag(N)[others])
    A = N[np.ix_(others, others)] * np.outer(scale, scale)
    B = N[np.ix_(others, links)] * scale[:, None]
    followed = np.linalg.solve(A, B)
    S = N[np.ix_(links, links)] - B.T @ followed
    sizes = [
        replace(scales, links_rad=scales.links_rad * turn, links_mm=scales.links_mm * shift)
        for turn in FACTORS
        for shift in FACTORS
    ]
    # At the minimum the data pull the links as hard as the estimated size holds them back.
    pull = -start / scales.link_error_sds(len(start) // 6) ** 2
    found = [
        link_likelihood(S, pull, start, size.link_error_sds(len(start) // 6)) for size in sizes
    ]
    log = np.array([one + size_prior(size) for (one, *_), size in zip(found, sizes, strict=True)])
    weight = np.exp(log - log.max())
    steps = np.array([step for _, step, _ in found]) * np.sqrt(weight / weight.sum())[:, None]
    by = np.zeros((at.count, len(links)))
    by[links], by[others] = np.eye(len(links)), -scale[:, None] * followed
    moves = by @ steps.T
    return np.asarray(moves @ moves.T)


def link_likelihood(
    S: Floats, pull: Floats, start: Floats, sd: Floats
) -> tuple[float, Floats, Floats]:
    """How likely it is that links (and what else is unknown beside them) err by so much: the
    logarithm but for a constant, their step (L,) there, and its covariance (L, L).

    Args:
        S: (L, L) the data's information about them.
        pull: (L,) the data's gradient at ``start`` (L,).
        sd: (L,) of their errors.
    """
    # In units of the size, so that the matrix is near the unit matrix where nothing is known.
    H = S * np.outer(sd, sd) + np.eye(len(sd))
    r = pull * sd + start / sd
    inverted = np.linalg.inv(H)
    answer = inverted @ r
    log = 0.5 * (r @ answer - np.linalg.slogdet(H)[1] - np.sum((start / sd) ** 2))
    return float(log), -sd * answer, inverted * np.outer(sd, sd)

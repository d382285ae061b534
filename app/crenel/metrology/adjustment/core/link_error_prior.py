"""The size of the link errors is itself uncertain, which increases the uncertainty of the result.

One set of contact points determines the size of rotations and translations to about half of their
value. The covariance at the likeliest size alone would treat that size as certain. The variation of
the result between sizes, each weighted by how well it explains all measurements, is added (Kass and
Steffey 1989, their first order, for hierarchical models in general). The covariance itself stays
that of the estimated size.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.adjustment.core.linearise import NormalEquations
from crenel.metrology.adjustment.core.variance_components import Scales, size_prior
from crenel.metrology.transforms import Floats

# Sizes considered, as factors of the estimated ones, for rotations and translations alike.
FACTORS = np.exp(np.linspace(-1.5, 1.5, 7))


def estimate_link_size_covariance(
    equations: NormalEquations, scales: Scales, free: NDArray[np.bool_]
) -> Floats:
    """Additional covariance (U, U) of the state because the size of the link errors is uncertain.

    Args:
        equations: at the minimum, about which they are linearised.
        scales: as estimated; sizes around them are considered, with noise and touch unchanged.
        free: (U,) the unknowns that are not held.
    """
    at = equations.linear.at
    parts, _ = equations.with_scales(scales)
    links = np.arange(at.count)[at.links]
    others = np.setdiff1d(np.flatnonzero(free), links)
    start = equations.linear.state.links
    N = np.sum([part for source, part in parts.items() if source != "links"], axis=0)
    # The other unknowns follow the links, so that each size needs only a small system.
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
    # At the minimum, the gradient of the data balances that of the prior of the estimated size.
    pull = -start / scales.link_error_sds(len(start) // 6) ** 2
    sds = np.array([size.link_error_sds(len(start) // 6) for size in sizes])
    log, steps, _ = link_likelihood(S, pull, start, sds)
    log += [size_prior(size) for size in sizes]
    weight = np.exp(log - log.max())
    steps *= np.sqrt(weight / weight.sum())[:, None]
    by = np.zeros((at.count, len(links)))
    by[links], by[others] = np.eye(len(links)), -scale[:, None] * followed
    moves = by @ steps.T
    return np.asarray(moves @ moves.T)


def link_likelihood(
    S: Floats, pull: Floats, start: Floats, sd: Floats
) -> tuple[Floats, Floats, Floats]:
    """Likelihood of link errors, or other unknowns, of some sizes at once: its logarithm (...,) up
    to a constant, the step (..., L) of the unknowns there, and its covariance (..., L, L).

    Args:
        S: (..., L, L) information of the data about them.
        pull: (..., L) gradient of the data at ``start`` (L,).
        sd: (..., L) standard deviations of their errors.
    """
    # In units of the size, so that the matrix is near the identity if nothing is known.
    squared = sd[..., :, None] * sd[..., None, :]
    H = S * squared + np.eye(sd.shape[-1])
    r = pull * sd + start / sd
    inverted = np.linalg.inv(H)
    answer = np.einsum("...ij,...j->...i", inverted, r)
    log = np.sum(r * answer - (start / sd) ** 2, axis=-1) - np.linalg.slogdet(H)[1]
    return np.asarray(0.5 * log), -sd * answer, inverted * squared

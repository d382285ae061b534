"""The likelihood of one fault in all contact points or in the certificate (a wrong tip, a block
that moved or differs in size) against no fault.

A fault makes the arm look worse than it is: the link errors and the noise of the readings absorb it
and hide it. The size of the fault is therefore one more unknown. The sizes of link errors and noise
are estimated again with and without it, and the two are compared by how well they explain all
measurements (Bayes factor; Kass and Raftery 1995).
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult
from crenel.metrology.adjustment.core.linearise import assemble_normal_equations, prior_information
from crenel.metrology.adjustment.core.link_error_prior import link_likelihood
from crenel.metrology.adjustment.core.variance_components import USUAL_COUNT, Scales, size_prior
from crenel.metrology.transforms import Floats

# Sizes of the link errors, as factors of the estimated ones; rotations and translations change
# together within this much (logarithms).
FACTORS = np.exp(np.linspace(-6.0, 1.5, 13))
TOGETHER = 1.3
# Noise is considered between the usual and the estimated value, in steps of at most this factor.
NOISE_STEP, MOST_NOISES = 1.5, 6


@dataclass(frozen=True)
class FaultHypothesis:
    """A fault that changes the residuals of the contact points (N that count) by ``by`` (N, K), and
    the deviation of the object's coordinates (B,) from their prior by ``by_prior`` (B, K), per unit
    of its K sizes. Their prior standard deviation is one of ``sds`` (K,), each equally likely."""

    by: Floats
    by_prior: Floats
    sds: tuple[Floats, ...]


@dataclass(frozen=True)
class FaultEstimate:
    """Sizes (K,) of a fault, their covariance (K, K), and twice the logarithm of its Bayes factor
    against no fault."""

    sizes: Floats
    covariance: Floats
    evidence: float


@dataclass(frozen=True)
class _ReducedSystem:
    """Information on link errors and all hypotheses' sizes (L + K), with the other unknowns
    eliminated, at one noise level: matrix, gradient, and the part of the log-likelihood that does
    not depend on them."""

    S: Floats
    pull: Floats
    log: float


@dataclass(frozen=True)
class _WithoutLinks:
    """The same on the hypotheses' sizes alone, for each of Z sizes of the link errors, which are
    eliminated, too: (Z, K, K), (Z, K), and the log-likelihoods (Z,) without a fault."""

    S: Floats
    pull: Floats
    log: Floats


@dataclass(frozen=True)
class _ConditionalEstimates:
    """Sizes (Z, K) of a fault at one noise level and Z sizes of the link errors, their covariances
    (Z, K, K), and the log-likelihoods (Z,)."""

    log: Floats
    sizes: Floats
    covariance: Floats


def estimate_faults(
    found: AdjustmentResult, hypotheses: Sequence[FaultHypothesis]
) -> list[FaultEstimate]:
    """The evidence of each hypothesis by itself, with everything else linearised at the minimum."""
    scales, start = found.scales, found.state.links
    by = np.hstack([one.by for one in hypotheses])
    by_prior = np.hstack([one.by_prior for one in hypotheses])
    ends = np.cumsum([one.by.shape[1] for one in hypotheses])
    own = [np.arange(end - one.by.shape[1], end) for one, end in zip(hypotheses, ends, strict=True)]
    sizes = _link_scales(scales)
    priors = np.array([size_prior(size) for size in sizes])
    link_sds = np.array([size.link_error_sds(len(start) // 6) for size in sizes])
    none: list[Floats] = []
    each: list[list[_ConditionalEstimates]] = [[] for _ in hypotheses]
    for noise in _noise_levels(found):
        reduced = _reduce_system(found, by, by_prior, replace(scales, noise=noise))
        without_links = _eliminate_links(reduced, start, link_sds, priors)
        none.append(without_links.log)
        for estimates, hypothesis, columns in zip(each, hypotheses, own, strict=True):
            estimates += [
                _estimate_conditional(without_links, columns, sds, len(hypothesis.sds))
                for sds in hypothesis.sds
            ]
    return [_average_estimates(estimates, np.concatenate(none)) for estimates in each]


def _eliminate_links(
    reduced: _ReducedSystem, start: Floats, sds: Floats, priors: Floats
) -> _WithoutLinks:
    """For each of Z sizes of the link errors, ``sds`` (Z, L), with the logarithms (Z,) of their
    prior densities."""
    links, faults = slice(0, len(start)), slice(len(start), None)
    log, step, covariance = link_likelihood(
        reduced.S[links, links], reduced.pull[links], start, sds
    )
    across = reduced.S[links, faults]
    return _WithoutLinks(
        reduced.S[faults, faults] - across.T @ covariance @ across,
        reduced.pull[faults] + step @ across,
        reduced.log + priors + log,
    )


def _estimate_conditional(
    system: _WithoutLinks, columns: NDArray[np.intp], sds: Floats, of: int
) -> _ConditionalEstimates:
    """With a fault's ``columns`` of all hypotheses' sizes, and one of its ``of`` priors' sds."""
    log, step, covariance = link_likelihood(
        system.S[:, columns[:, None], columns],
        system.pull[:, columns],
        np.zeros(len(sds)),
        np.broadcast_to(sds, (len(system.log), len(sds))),
    )
    return _ConditionalEstimates(system.log + log - np.log(of), step, covariance)


def _average_estimates(estimates: Sequence[_ConditionalEstimates], none: Floats) -> FaultEstimate:
    logs = np.concatenate([one.log for one in estimates])
    weight = np.exp(logs - logs.max())
    weight /= weight.sum()
    sizes = np.concatenate([one.sizes for one in estimates])
    mean = weight @ sizes
    covariances = np.concatenate([one.covariance for one in estimates])
    covariance = np.einsum("s,sij->ij", weight, covariances)
    covariance += np.einsum("s,si,sj->ij", weight, sizes - mean, sizes - mean)
    without = float(np.logaddexp.reduce(none))
    return FaultEstimate(mean, covariance, 2 * (float(np.logaddexp.reduce(logs)) - without))


def _reduce_system(
    found: AdjustmentResult, by: Floats, by_prior: Floats, scales: Scales
) -> _ReducedSystem:
    equations = assemble_normal_equations(found.linear, found.weights)
    at, start = equations.linear.at, equations.linear.state.links
    parts, g = equations.with_scales(scales)
    N = np.sum([part for source, part in parts.items() if source != "links"], axis=0)
    links = np.arange(at.count)[at.links]
    others = np.setdiff1d(np.flatnonzero(found.free), links)
    across, among, pull, log = _hypothesis_terms(found, by, by_prior, scales)
    # gradient of the data by the links, without their prior
    pull = np.concatenate([g[links] - start / scales.link_error_sds(len(start) // 6) ** 2, pull])
    scale = 1 / np.sqrt(np.diag(N)[others])
    A = N[np.ix_(others, others)] * np.outer(scale, scale)
    B = np.hstack([N[np.ix_(others, links)], across[others]]) * scale[:, None]
    solved = np.linalg.solve(A, np.column_stack([B, g[others] * scale]))
    S = np.block([[N[np.ix_(links, links)], across[links]], [across[links].T, among]])
    log += 0.5 * float((g[others] * scale) @ solved[:, -1]) + float(np.sum(np.log(scale)))
    log -= 0.5 * float(np.linalg.slogdet(A)[1])
    return _ReducedSystem(S - B.T @ solved[:, :-1], pull - B.T @ solved[:, -1], log)


def _hypothesis_terms(
    found: AdjustmentResult, by: Floats, by_prior: Floats, scales: Scales
) -> tuple[Floats, Floats, Floats, float]:
    """The hypotheses' part of the normal equations (U, K), (K, K) and of the gradient (K,); and the
    log-likelihood of contact points and noise without them."""
    prior, at = found.problem.prior, found.layout
    weighed = by_prior / prior.sd[:, None] ** 2
    across = np.zeros((at.count, by.shape[1]))
    across[at.coordinates] = weighed
    among = by_prior.T @ weighed
    pull = weighed.T @ (found.state.coordinates - prior.coordinates)
    log = _noise_log(found, scales)
    contacts = found.linear.contacts
    if contacts is not None:
        variance, off = contacts.variances(scales), contacts.residuals_mm
        weighed = by / variance[:, None]
        across += contacts.jacobian.T @ weighed
        among += by.T @ weighed
        pull += weighed.T @ off
        log -= 0.5 * float(np.sum(np.log(variance) + off**2 / variance))
    return across, among, pull, log


def _noise_log(found: AdjustmentResult, scales: Scales) -> float:
    """Log-likelihood of the readings' noise at one noise level, including the prior of that
    level."""
    ((_, _, sd, off),) = (
        known for known in prior_information(found.linear, scales) if known[0] == "encoders"
    )
    usual = found.problem.motion.usual_factor / scales.noise
    prior = USUAL_COUNT * (np.log(usual) - usual**2 / 2)
    return float(prior - np.sum(np.log(sd)) - 0.5 * np.sum((off / sd) ** 2))


def _noise_levels(found: AdjustmentResult) -> Floats:
    noise, usual = found.scales.noise, found.problem.motion.usual_factor
    least = max(min(usual, noise), found.problem.motion.least_factor)
    steps = int(np.ceil(np.log(max(noise / least, 1.0)) / np.log(NOISE_STEP)))
    return np.geomspace(least, max(noise, least), min(steps, MOST_NOISES) + 1)[::-1]


def _link_scales(scales: Scales) -> list[Scales]:
    return [
        replace(scales, links_rad=scales.links_rad * turn, links_mm=scales.links_mm * shift)
        for turn in FACTORS
        for shift in FACTORS
        if abs(np.log(turn / shift)) < TOGETHER
    ]

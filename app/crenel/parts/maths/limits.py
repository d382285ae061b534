"""Decisions on dimensions against two limits, one limit, or a zone about a place."""

import numpy as np
from scipy.special import ndtr

from crenel.metrology.decision import Decision, DecisionRule
from crenel.metrology.transforms import Floats

NODES = 401
WIDTH_SDS = 9.0
DRAWS = 4_000


def decide_between(
    value: float,
    lower: float | None,
    upper: float | None,
    standard_uncertainty: float,
    rule: DecisionRule,
) -> Decision:
    """Whether a value lies between its limits; None: there is no limit on this side.

    Limits that are close to each other for the uncertainty are judged by the probability between
    them, as by ``decide``.
    """
    if lower is None and upper is None:
        return "none"
    low = -np.inf if lower is None else lower
    high = np.inf if upper is None else upper
    if rule.guard_factor == 0 or standard_uncertainty == 0:
        return "pass" if low <= value <= high else "fail"
    inside = float(
        ndtr((high - value) / standard_uncertainty) - ndtr((low - value) / standard_uncertainty)
    )
    return decide_by_probability(inside, rule)


def decide_by_probability(inside: float, rule: DecisionRule) -> Decision:
    """The decision where a value conforms with this probability."""
    proven = float(ndtr(rule.guard_factor))
    if inside >= proven:
        return "pass"
    if inside <= 1 - proven or rule.bearer == "supplier":
        return "fail"
    return "pass" if rule.bearer == "user" else "uncertain"


def probability_within(radius: float, centre: Floats, covariance: Floats) -> float:
    """P(|delta| <= radius) of a normal vector, by quadrature along its axes.

    Args:
        centre: (k,) the vector found, k = 1 to 3.
        covariance: (k, k) of it.
    """
    variances, axes = np.linalg.eigh(covariance)
    sds = np.sqrt(np.maximum(variances, 1e-24))[::-1]
    return _within(radius**2, (axes.T @ centre)[::-1], sds)


def _within(square: float, centre: Floats, sds: Floats) -> float:
    if square <= 0:
        return 0.0
    reach = np.sqrt(square)
    if len(centre) == 1:
        return float(ndtr((reach - centre[0]) / sds[0]) - ndtr((-reach - centre[0]) / sds[0]))
    low = max(-reach, centre[0] - WIDTH_SDS * sds[0])
    high = min(reach, centre[0] + WIDTH_SDS * sds[0])
    if low >= high:
        return 0.0
    nodes, weights = np.polynomial.legendre.leggauss(NODES if len(centre) == 2 else 101)
    x = (low + high) / 2 + (high - low) / 2 * nodes
    density = np.exp(-0.5 * ((x - centre[0]) / sds[0]) ** 2) / (sds[0] * np.sqrt(2 * np.pi))
    if len(centre) == 2:
        half = np.sqrt(np.maximum(square - x**2, 0.0))
        rest = ndtr((half - centre[1]) / sds[1]) - ndtr((-half - centre[1]) / sds[1])
    else:
        rest = np.array([_within(square - one**2, centre[1:], sds[1:]) for one in x])
    return float(np.clip((high - low) / 2 * np.sum(weights * density * rest), 0.0, 1.0))


def length_by_chance(covariance: Floats) -> float:
    """The mean length of a normal vector (k,) about zero with a covariance (k, k)."""
    variances = np.linalg.eigvalsh(covariance)
    drawn = np.random.default_rng(0).normal(size=(DRAWS, len(variances)))
    return float(np.mean(np.linalg.norm(drawn * np.sqrt(np.maximum(variances, 0.0)), axis=1)))

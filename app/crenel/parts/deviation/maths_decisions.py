"""Decisions on a map of deviations: of each cell, and of the whole as one tolerance."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr, ndtri

from crenel.metrology.decision import DecisionRule, decide
from crenel.metrology.transforms import Floats

IN, OUT, UNDECIDED = 0, 1, 2
CODES = {"pass": IN, "fail": OUT, "uncertain": UNDECIDED, "none": UNDECIDED}
DRAWS = 2000
SURE = 0.95
LEAST_POINTS = 3
"""A cell of fewer decides nothing: one point that is off would."""
MOST_CHORD = 0.2
"""Of the tolerance: facets farther from the surface decide nothing."""
Profile = Literal["pass", "fail", "undecided"]


@dataclass(frozen=True)
class DeviationLimits:
    """What deviations are permitted, mm, outward positive."""

    lower_mm: float
    upper_mm: float

    @property
    def middle_mm(self) -> float:
        return (self.lower_mm + self.upper_mm) / 2

    @property
    def width_mm(self) -> float:
        return self.upper_mm - self.lower_mm


@dataclass(frozen=True)
class ProfileDecision:
    """The tolerance of the whole surface as one characteristic."""

    decision: Profile
    probability: float
    """That all of the surface is within its limits."""


def decide_cells(
    deviation_mm: Floats,
    standard_uncertainty_mm: Floats,
    limits: DeviationLimits,
    rule: DecisionRule,
) -> NDArray[np.uint8]:
    """(C,) ``IN``, ``OUT`` or ``UNDECIDED`` by the rule; undecided where u is not known (NaN)."""
    half = limits.width_mm / 2
    pairs = zip(deviation_mm - limits.middle_mm, standard_uncertainty_mm, strict=True)
    codes = (
        CODES[decide(float(off), half, float(u), rule, signed=True)] if u >= 0 else UNDECIDED
        for off, u in pairs
    )
    return np.fromiter(codes, np.uint8, len(deviation_mm))


def temper_decisions(
    decisions: NDArray[np.uint8],
    around: NDArray[np.uint8],
    deviation_mm: Floats,
    standard_uncertainty_mm: Floats,
) -> NDArray[np.uint8]:
    """Decisions (C,) of cells without those that many cells together bring about by chance.

    A cell stays in if the mean of it and its neighbours, decided as ``around``, is in as well. It
    stays out if a perfect part would show such a deviation in fewer than one of 20 maps.
    """
    found = decisions.copy()
    found[(decisions == IN) & (around != IN)] = UNDECIDED
    by_chance = np.abs(deviation_mm) < _rare(len(decisions)) * standard_uncertainty_mm
    found[(decisions == OUT) & by_chance] = UNDECIDED
    return found


def count_by_chance(
    standard_uncertainty_mm: Floats, limits: DeviationLimits, rule: DecisionRule
) -> float:
    """How many cells would be decided as out, on average, if all were as drawn."""
    u = standard_uncertainty_mm[standard_uncertainty_mm > 0]
    rare = _rare(len(standard_uncertainty_mm))
    above = np.maximum((limits.upper_mm + rule.guard_factor * u) / u, rare)
    below = np.minimum((limits.lower_mm - rule.guard_factor * u) / u, -rare)
    return float(np.sum(ndtr(-above) + ndtr(below)))


def _rare(cells: int) -> float:
    """Standard uncertainties that no one of so many cells exceeds by chance, in 19 of 20 maps."""
    return float(-ndtri((1 - SURE) / (2 * max(cells, 1))))


def decide_profile(
    deviation_mm: Floats, errors: Iterable[Floats], limits: DeviationLimits
) -> ProfileDecision:
    """Whether all cells are within the limits, by draws of their errors together.

    Args:
        errors: (C, D) each, mm.
    """
    within, draws = 0, 0
    for one in errors:
        true = deviation_mm[:, None] - one
        is_in = (true.max(axis=0) <= limits.upper_mm) & (true.min(axis=0) >= limits.lower_mm)
        within, draws = within + int(is_in.sum()), draws + one.shape[1]
    share = within / max(draws, 1)
    decision: Profile = "undecided"
    if share >= SURE:
        decision = "pass"
    elif share <= 1 - SURE:
        decision = "fail"
    return ProfileDecision(decision, share)

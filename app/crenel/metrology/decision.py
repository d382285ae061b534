"""One decision rule for everything that is judged against a limit."""

from dataclasses import dataclass
from typing import Literal

from scipy.special import ndtr

Decision = Literal["pass", "fail", "uncertain", "none"]
Bearer = Literal["prover", "supplier", "user"]
"""Who bears the uncertainty: whoever has to prove something, the supplier, or the user."""


@dataclass(frozen=True)
class DecisionRule:
    """How a value, its uncertainty and its limit become a decision.

    A value that is within its limit by more than the guard band conforms; one that is beyond by
    more than that does not. In between, it is ``uncertain``, unless one party bears the
    uncertainty: the supplier, who must then prove conformity, or the user, who must prove
    nonconformity.
    """

    name: str
    standard: str
    edition: str
    guard_factor: float
    """The guard band in standard uncertainties; 0: simple acceptance."""
    bearer: Bearer = "prover"


GUARDED_95 = DecisionRule("guarded-95", "ISO 14253-1", "2017", 1.65)
"""The default of the standard: conformity with 95 %, one-sided."""
EXPANDED_K2 = DecisionRule("expanded-k2", "ISO 14253-1", "1998", 2.0)
"""The older practice: the expanded uncertainty is the guard band."""
SIMPLE = DecisionRule("simple", "ILAC-G8", "09/2019", 0.0)
"""Simple acceptance: the uncertainty is stated and not applied."""
RULES = {rule.name: rule for rule in (GUARDED_95, EXPANDED_K2, SIMPLE)}


def decide(
    value: float,
    limit: float | None,
    standard_uncertainty: float,
    rule: DecisionRule = GUARDED_95,
    signed: bool = False,
) -> Decision:
    """Whether a value keeps its limit.

    Args:
        value: the measured error.
        limit: the largest permissible absolute value, in the same unit; None: no limit.
        standard_uncertainty: k = 1, in the same unit.
        signed: the value has two limits, plus and minus; if they are close to each other against
            the uncertainty, the probability between both counts.

    Returns:
        ``pass`` or ``fail`` where that holds in spite of the uncertainty, else ``uncertain``;
        ``none`` without a limit.

    Source:
        ISO 14253-1; for close limits, the probability of conformity of JCGM 106:2012, 7.

    Example:
        >>> [decide(value, 10.0, 1.0) for value in (-8.0, 9.0, 12.0)]
        ['pass', 'uncertain', 'fail']
        >>> decide(9.0, 10.0, 1.0, SIMPLE)
        'pass'
    """
    if limit is None:
        return "none"
    if rule.guard_factor == 0 or standard_uncertainty == 0:
        return "pass" if abs(value) <= limit else "fail"
    if signed and limit < 2 * standard_uncertainty:
        inside = ndtr((limit - value) / standard_uncertainty)
        inside -= ndtr((-limit - value) / standard_uncertainty)
        proven = float(ndtr(rule.guard_factor))
        conforms, fails = inside >= proven, inside <= 1 - proven
    else:
        guard = rule.guard_factor * standard_uncertainty
        conforms, fails = abs(value) + guard <= limit, abs(value) - guard > limit
    if conforms:
        return "pass"
    if fails or rule.bearer == "supplier":
        return "fail"
    return "pass" if rule.bearer == "user" else "uncertain"

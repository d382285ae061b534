"""Why a figure of a verification keeps its limit or not, in one sentence."""

from dataclasses import dataclass
from typing import Literal

from crenel.messages.limits import beside_limit
from crenel.messages.message import Text, message, quantity
from crenel.messages.uncertainty import uncertainty_quantity
from crenel.metrology.decision import EXPANDED_K2, Decision, DecisionRule


@dataclass(frozen=True)
class Judgement:
    """A figure and its decision."""

    title: Text
    value: float
    limit: float | None
    standard_uncertainty: float
    """The one that it is judged by, k = 1."""
    unit: Literal["µm", "″"]
    decision: Decision
    signed: bool


def describe_judgement(judged: Judgement, rule: DecisionRule) -> Text:
    """The sentence, by the size of the guard band.

    Args:
        judged: the figure.
        rule: by which it was judged.
    """
    unit, limit, title = judged.unit, judged.limit, judged.title
    size, guard = abs(judged.value), rule.guard_factor * judged.standard_uncertainty
    if limit is None:
        return message("there-no-limit", title=title, value=quantity(size, unit))
    shown, most = beside_limit(size, limit, unit)
    if guard == 0:
        how = "within" if size <= limit else "beyond"
        return message("figure-without-guard", title=title, value=shown, limit=most, how=how)
    band = uncertainty_quantity(guard, unit)
    if judged.signed and limit < 2 * judged.standard_uncertainty:
        return message(
            "figure-between-close-limits",
            title=title,
            value=shown,
            limit=most,
            guard=band,
            decision=judged.decision,
        )
    if size + guard <= limit:
        if rule.name == EXPANDED_K2.name:
            return message(
                "figure-within-limit", title=title, value=shown, limit=most, uncertainty=band
            )
        return message("figure-within-guard", title=title, value=shown, limit=most, guard=band)
    if size - guard > limit:
        if rule.name == EXPANDED_K2.name:
            return message(
                "figure-beyond-limit", title=title, value=shown, limit=most, uncertainty=band
            )
        return message("figure-beyond-guard", title=title, value=shown, limit=most, guard=band)
    if rule.name == EXPANDED_K2.name and judged.decision == "uncertain":
        return message("figure-near-limit", title=title, value=shown, limit=most, uncertainty=band)
    return message(
        "figure-near-guard",
        title=title,
        value=shown,
        limit=most,
        guard=band,
        decision=judged.decision,
    )

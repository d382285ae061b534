"""Figures from values: symbol, limit, test value uncertainty, decision and one sentence each."""

from collections.abc import Sequence
from dataclasses import dataclass

from crenel.gauges.judgement.document import PerformanceFigure, PerformanceVerdict
from crenel.gauges.plan.document import PerformancePlan
from crenel.gauges.plan.document_symbols import TITLES, Quantity, symbol_of
from crenel.messages.limits import beside_limit
from crenel.messages.message import Text, message, quantity
from crenel.messages.uncertainty import uncertainty_quantity
from crenel.metrology.decision import Decision, decide

K = 2.0


@dataclass(frozen=True)
class Measured:
    """A quantity's value in µm, or why there is none."""

    quantity: Quantity
    value_um: float | None
    values_um: tuple[float | None, ...] = ()
    test_sd_um: float | None = None
    """Standard test value uncertainty; None if it cannot be stated."""
    problem: Text = ""
    data: tuple[str, ...] = ()
    length_mm: float = 0.0
    """At which a limit that grows with the length applies."""


def refuse(measured: Measured, problems: Sequence[Text]) -> Measured:
    """A quantity without its value if its artefact cannot serve.

    Args:
        problems: of the artefact; empty if it can.
    """
    if not problems:
        return measured
    problem = measured.problem or problems[0]
    return Measured(measured.quantity, None, problem=problem, data=measured.data)


def judge_figure(
    plan: PerformancePlan, measured: Measured, why_open: Text = ""
) -> PerformanceFigure:
    """A figure with its decision by the plan's rule.

    Args:
        why_open: why it is not decided, as the temperature was not steady or the artefact's
            expansion is unknown; empty if it is decided.
    """
    symbol = symbol_of(plan.edition, measured.quantity)
    title = TITLES[measured.quantity]
    permissible = plan.limit(measured.quantity)
    limit = None if permissible is None else permissible.at(measured.length_mm)
    value, decision = measured.value_um, "none"
    judged: Decision = "none"
    if measured.problem:
        value = None
    elif value is not None:
        judged = decide(
            value, limit, measured.test_sd_um or 0.0, plan.rule.rule, signed=symbol.signed
        )
    decision = "uncertain" if why_open and judged != "none" else judged
    expanded = None if measured.test_sd_um is None else K * measured.test_sd_um
    return PerformanceFigure(
        quantity=measured.quantity,
        symbol=symbol.symbol,
        title=title,
        value=value,
        values=measured.values_um,
        test_uncertainty=expanded,
        limit=limit,
        decision=decision,
        reason=_reason(title, value, limit, expanded, decision, measured.problem or why_open),
        problem=measured.problem,
        data=measured.data,
    )


def judge_all(figures: Sequence[PerformanceFigure]) -> PerformanceVerdict:
    """As bad as the worst figure; undecided if a figure with a limit has no value."""
    decisions = {figure.decision for figure in figures}
    unknown = any(figure.limit is not None and figure.value is None for figure in figures)
    if "fail" in decisions:
        return PerformanceVerdict(result="fail", text=message("performance-limits-broken"))
    stated = any(figure.value is not None for figure in figures)
    if stated and all(figure.limit is None for figure in figures):
        return PerformanceVerdict(result="uncertain", text=message("performance-no-limit-entered"))
    if unknown or "uncertain" in decisions or decisions <= {"none"}:
        return PerformanceVerdict(result="uncertain", text=message("performance-not-decided"))
    return PerformanceVerdict(result="pass", text=message("performance-limits-kept"))


def _reason(
    title: Text,
    value: float | None,
    limit: float | None,
    expanded: float | None,
    decision: Decision,
    problem: Text,
) -> Text:
    if value is None:
        return message("performance-no-value", title=title, problem=problem)
    if limit is None:
        return message("there-no-limit", title=title, value=quantity(value, "µm", 1))
    size, most = beside_limit(value, limit, "µm", 1)
    known = {
        "title": title,
        "value": size,
        "limit": most,
        "uncertainty": uncertainty_quantity(expanded or 0.0, "µm"),
    }
    if problem:
        return message("performance-conditions-not-met", title=title, value=size, problem=problem)
    if decision == "pass":
        return message("performance-within-limit", **known)
    if decision == "fail":
        return message("performance-beyond-limit", **known)
    return message("performance-near-limit", **known)


def find_unused_limits(plan: PerformancePlan, measured: Sequence[Measured]) -> tuple[Text, ...]:
    """Limits of quantities that this test does not measure."""
    has = {one.quantity for one in measured}
    return tuple(
        message("performance-limit-unused", title=TITLES[limit.quantity])
        for limit in plan.limits
        if limit.quantity not in has
    )

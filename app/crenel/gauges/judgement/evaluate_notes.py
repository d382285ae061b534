"""What should be known of a test by its plan."""

from collections.abc import Sequence

from crenel.gauges.judgement.evaluate import Measured
from crenel.gauges.plan.document import PerformancePlan
from crenel.gauges.plan.document_symbols import TITLES
from crenel.messages.message import Text, message, quantity


def find_unused_limits(plan: PerformancePlan, measured: Sequence[Measured]) -> tuple[Text, ...]:
    """Limits of quantities that this test does not measure."""
    has = {one.quantity for one in measured}
    return tuple(
        message("performance-limit-unused", title=TITLES[limit.quantity])
        for limit in plan.limits
        if limit.quantity not in has
    )


def plan_notes(plan: PerformancePlan, filtered: Text) -> tuple[Text, ...]:
    """The filters, and what else should be known.

    Args:
        filtered: what the scans were filtered by; empty if by nothing.
    """
    notes: list[Text] = []
    if filtered:
        notes.append(filtered)
    if plan.kind == "sphere":
        if not filtered:
            notes.append(message("performance-no-filter"))
        gate = plan.gate
        notes.append(
            message(
                "performance-gate",
                shell=quantity(gate.shell_mm, "mm", 1),
                incidence=quantity(gate.incidence_deg, "°"),
                cone=quantity(gate.cone_deg, "°"),
            )
        )
        if plan.positions == 1:
            notes.append(message("performance-one-position"))
    if plan.kind == "plane":
        notes.append(message("performance-plane-is-addition"))
    return tuple(notes)

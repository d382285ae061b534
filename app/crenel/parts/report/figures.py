"""Dimensions against their limits, in the report of an inspection."""

from crenel.messages.message import Text, message
from crenel.parts.document_results import DimensionResult, InspectionFile
from crenel.parts.report.tables import OUTCOMES, dimension_value
from crenel.report.figure import Figure
from crenel.report.limits_figure import LimitedValue, draw_limits

LABELS = 150.0


def limits_picture(document: InspectionFile) -> tuple[Figure[Text], Text] | None:
    """Each dimension in its band of limits, with U as a bar; None where none has limits."""
    values = [bar for one in document.dimensions if (bar := _bar(one)) is not None]
    if not values:
        return None
    figure = draw_limits(values, LABELS, message("part-limit-mark"))
    return figure, message("part-values-in-their-bands")


def _bar(one: DimensionResult) -> LimitedValue | None:
    """A dimension from the middle of its band; from its nominal if it has one limit only."""
    lower, upper, off = one.lower, one.upper, one.value - one.nominal
    middle = 0.0 if lower is None or upper is None else (lower + upper) / 2
    edge = upper if upper is not None else lower
    if edge is None or edge == middle:
        return None
    if (lower is None and edge < 0) or (upper is None and edge > 0):
        return None  # the band does not contain the nominal, from which it would be drawn
    u = one.standard_uncertainty or 0.0
    return LimitedValue(
        one.id,
        dimension_value(one),
        off - middle,
        2 * u,
        abs(edge - middle),
        OUTCOMES[one.decision],
    )

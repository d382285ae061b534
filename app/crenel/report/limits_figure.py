"""Values against their limits, with their uncertainties: of verifications and performance tests."""

from collections.abc import Sequence
from dataclasses import dataclass

from crenel.messages.message import Text, message
from crenel.metrology.decision import Decision
from crenel.report.figure import (
    BLUE,
    FAINT,
    GROUND,
    INK,
    LINE,
    ORANGE,
    RED,
    SOFT,
    WHITE,
    Dot,
    Figure,
    Polyline,
)

WIDTH, END = 520.0, 452.0
"""The width of the drawing, and where its scale ends; the values follow."""
ROW = 23.0


@dataclass(frozen=True)
class LimitedValue:
    """A value with its limit; all numbers are of one unit."""

    title: Text
    text: Text
    """The value with its unit."""
    value: float
    uncertainty: float
    """Expanded, that the limit is judged by."""
    limit: float
    decision: Decision
    others: Sequence[float] = ()
    """What the value was found from: of each cloud, or of each position."""

    @property
    def reach(self) -> float:
        """The end of the uncertainty that is farther from zero, in shares of the limit."""
        return (abs(self.value) + self.uncertainty) / self.limit


def draw_limits(values: Sequence[LimitedValue], labels: float, mark: Text) -> Figure[Text]:
    """Each value in shares of its limit, with its uncertainty as a bar.

    Args:
        labels: width for the titles, in points.
        mark: what the limits are called.
    """
    figure = Figure[Text](
        WIDTH, ROW * max(len(values), 1) + 26, message("figures-against-their-limits")
    )
    width = END - labels
    reach = max((one.reach for one in values), default=1.0)
    scale = width / (2 * max(1.2, 1.05 * reach))
    zero = labels + width / 2
    for row, one in enumerate(values):
        y = ROW * row + 13.5
        figure.box((labels, y - 6.5), width, 13, GROUND)
        for other in one.others:
            figure.items.append(Dot((zero + other / one.limit * scale, y), 1.9, "", FAINT, 0.7))
        at = zero + one.value / one.limit * scale
        u = one.uncertainty / one.limit * scale
        colour = {"pass": BLUE, "fail": RED}.get(one.decision, ORANGE)
        figure.line((at - u, y), (at + u, y), stroke=colour, width=2)
        figure.items.append(Dot((at, y), 3, colour, WHITE, 0.6))
        figure.label((labels - 8, y + 3), one.title, 7.5, SOFT, "end")
        figure.label((END + 8, y + 3), one.text, 8, INK)
    bottom = ROW * len(values) + 4
    figure.line((zero, 2.0), (zero, bottom), stroke=LINE)
    for sign in (-1, 1):
        x = zero + sign * scale
        figure.items.append(Polyline(((x, 2.0), (x, bottom)), RED, 1, dash=(3, 2)))
        figure.label((x, bottom + 11), mark, 7.5, RED, "middle")
    return figure

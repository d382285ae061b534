"""The figures of a performance test: values against their limits, lengths, seats, placements."""

from collections.abc import Sequence

from crenel.gauges.judgement.document import LengthPoint, PerformanceFigure, PerformanceFile
from crenel.gauges.plan.document_symbols import value_of
from crenel.messages.message import Text, message, quantity, signed
from crenel.report.figure import (
    BLUE,
    FAINT,
    GROUND,
    LINE,
    PANEL,
    RED,
    SOFT,
    WHITE,
    Dot,
    Figure,
    Polyline,
)
from crenel.report.formatting import micrometres
from crenel.report.limits_figure import LimitedValue, draw_limits

LABELS = 234.0
"""Wide enough for the longest title of a figure, in every language."""
SHIFT = 1.3
"""Between the places of one length, so that equal errors are seen apart."""


def limits_figure(figures: Sequence[PerformanceFigure]) -> tuple[Figure[Text], Text] | None:
    """Each figure in shares of its limit, with the values of all positions; None without limits."""
    limited = [
        LimitedValue(
            one.title,
            micrometres(one.value),
            one.value,
            one.test_uncertainty or 0.0,
            one.limit,
            one.decision,
            [value for value in one.values if value is not None] if len(one.values) < 10 else [],
        )
        for one in figures
        if one.limit is not None and one.value is not None
    ]
    if not limited:
        return None
    return draw_limits(limited, LABELS, "MPE"), message("performance-values-against-limits")


def lengths_pictures(lengths: Sequence[LengthPoint]) -> list[tuple[Figure[Text], Text]]:
    """Those by touch and those by scan, as far as there are."""
    groups = ([one for one in lengths if one.by == by] for by in ("touch", "scan"))
    return [lengths_figure(group) for group in groups if group]


def lengths_figure(lengths: Sequence[LengthPoint]) -> tuple[Figure[Text], Text]:
    """The errors of all lengths over the length, with the band of the permissible error."""
    figure = Figure[Text](520, 196, message("errors-of-lengths"))
    left, width, top, height = 50.0, 455.0, 6.0, 160.0
    longest = max(point.length_mm for point in lengths)
    reach = max(max(abs(point.error_um), point.limit_um or 0.0) for point in lengths)
    scale = height / (2.2 * max(reach, 1.0))
    middle = top + height / 2

    def at(length_mm: float, error_um: float) -> tuple[float, float]:
        return left + 12 + length_mm / longest * (width - 30), middle - error_um * scale

    figure.box((left, top), width, height, PANEL, LINE)
    limits = sorted({(one.length_mm, one.limit_um) for one in lengths if one.limit_um is not None})
    if limits:
        upper = tuple(at(length, limit) for length, limit in limits)
        lower = tuple(at(length, -limit) for length, limit in limits)
        figure.face(*upper, *reversed(lower), fill=GROUND)
        for edge in (upper, lower):
            figure.items.append(Polyline(edge, RED, 1, dash=(4, 3)))
    figure.line((left, middle), (left + width, middle), stroke=FAINT, width=0.6)
    figure.label((left - 4, middle + 2.5), "0", 7, FAINT, "end")
    for sign in (-1, 1):
        tick = (left - 4, middle - sign * reach * scale + 2.5)
        figure.label(tick, signed(sign * reach, "µm"), 7, FAINT, "end")
    middle_place = (1 + max(one.place for one in lengths)) / 2
    for one in lengths:
        x, y = at(one.length_mm, one.error_um)
        outside = one.limit_um is not None and abs(one.error_um) > one.limit_um
        point = (x + SHIFT * (one.place - middle_place), y)
        figure.items.append(Dot(point, 1.7, RED if outside else BLUE, WHITE, 0.3))
        if outside:
            figure.label((point[0] + 4, y + 2.5), str(one.place), 7, RED)
    for length in sorted({one.length_mm for one in lengths}):
        x, _ = at(length, 0.0)
        figure.label((x, top + height + 12), quantity(length, "mm"), 7, SOFT, "middle")
    return figure, message("errors-of-lengths-caption", count=len(lengths), by=lengths[0].by)


def bar_pictures(document: PerformanceFile) -> list[tuple[Figure[Text], Text]]:
    """Measurements, seats and placements of the contact test, or orientations of a plate."""
    return [
        bars_figure(one)
        for one in document.figures
        if value_of(one.quantity) and any(value is not None for value in one.values)
    ]


def bars_figure(one: PerformanceFigure) -> tuple[Figure[Text], Text]:
    """One bar for each value, with the limit, or else with the largest value."""
    values = one.values
    figure = Figure[Text](250, 130, one.title)
    left, width, top, height = 40.0, 205.0, 6.0, 104.0
    known = [value for value in values if value is not None]
    limit = one.limit or 0.0
    high, low = max([limit, 0.0, *known]), min([0.0, *known])
    if low < 0:
        low = min(low, -limit)
    span = 1.1 * max(high - low, 1.0)
    base = top + 4 + high / span * (height - 8)
    scale = (height - 8) / span
    figure.box((left, top), width, height, PANEL, LINE)
    step = width / len(values)
    for i, value in enumerate(values):
        x = left + (i + 0.5) * step
        if value is not None:
            colour = RED if one.limit is not None and abs(value) > one.limit else BLUE
            thickness = min(0.6 * step, 22.0)
            upper, lower = min(base, base - value * scale), max(base, base - value * scale)
            figure.box((x - thickness / 2, upper), thickness, lower - upper, colour)
        if len(values) <= 10 or (i + 1) % 5 == 0 or i == 0:
            figure.label((x, top + height + 11), str(i + 1), 7, FAINT, "middle")
    figure.line((left, base), (left + width, base), stroke=FAINT, width=0.6)
    figure.label((left - 4, base + 2.5), "0", 7, FAINT, "end")
    if one.limit is None and known:
        largest = max(known, key=abs)
        figure.label((left - 4, base - largest * scale + 2.5), quantity(largest), 7, FAINT, "end")
    for edge in (limit, -limit) if low < 0 else (limit,):
        if one.limit is not None:
            y = base - edge * scale
            figure.items.append(Polyline(((left, y), (left + width, y)), RED, 1, dash=(4, 3)))
            figure.label((left - 4, y + 2.5), quantity(edge), 7, RED, "end")
    limited = "no" if one.limit is None else "yes"
    return figure, message(
        "performance-bars-caption", title=one.title, of=value_of(one.quantity), limited=limited
    )

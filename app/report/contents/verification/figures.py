"""The figures of a verification: its limits, its clouds, and each cloud about its fitted shape."""

import numpy as np

from app.formats.results.verification import VerificationFile
from app.messages.message import Text, message, quantity, signed
from app.report.contents.limits_figure import LimitedValue, draw_limits
from app.report.figure import (
    BLUE,
    FAINT,
    GROUND,
    LINE,
    PANEL,
    SOFT,
    Dot,
    Figure,
)
from app.report.formatting import error_value
from app.workflows.measure_gauge import MapFile

LABELS = 192.0
"""Wide enough for the longest title of a figure, in every language."""
TICK_SPACE = 7.0
"""Between the numbers at a plot's side, so that none lies over another."""
INSIDE = ("#fbe3cd", "#f4bd8b", "#e8904a", "#b45309")
OUTSIDE = ("#d6e8fb", "#a9cff6", "#5a9be4", "#1d5bd0")
# The scale ends where all but so few of the cells lie within.
WITHIN = 0.98


def limit_figure(document: VerificationFile) -> tuple[Figure[Text], Text]:
    """Each figure in shares of its limit, with its uncertainty and each cloud's own value."""
    limited = [
        LimitedValue(
            one.title,
            error_value(one.value, one.unit),
            one.value,
            one.judging_uncertainty,
            one.limit,
            one.decision,
            one.clouds,
        )
        for one in document.figures
        if one.limit is not None
    ]
    figure = draw_limits(limited, LABELS, message("limit-mark"))
    return figure, message("values-shares-their-limits-bar-expanded")


def cloud_plot(document: VerificationFile, name: str, title: Text) -> tuple[Figure[Text], Text]:
    """One error of each cloud, over the clouds (article, Figs. 7-11)."""
    values = [getattr(cloud, name) for cloud in document.clouds]
    known = [float(value) for value in values if value is not None]
    low, high = min([0.0, *known]), max([0.0, *known])
    span = max(high - low, 1e-9) * 1.15
    figure = Figure[Text](250, 120, title)
    left, width, bottom, height = 34.0, 208.0, 100.0, 88.0
    figure.box((left, bottom - height), width, height, PANEL, LINE)

    def y(value: float) -> float:
        return bottom - 4 - (value - low) / span * (height - 8)

    figure.line((left, y(0.0)), (left + width, y(0.0)), stroke=FAINT, width=0.6)
    figure.label((left - 4, y(0.0) + 2.5), "0", 7, FAINT, "end")
    labelled = [0.0]
    for value in (max(known, key=abs), min(known, key=abs)):
        # a number that would lie over another is in the table only
        if all(abs(y(value) - y(other)) >= TICK_SPACE for other in labelled):
            figure.label((left - 4, y(value) + 2.5), quantity(value), 7, FAINT, "end")
            labelled.append(value)
    step = width / len(values)
    for i, value in enumerate(values):
        x = left + (i + 0.5) * step
        figure.label((x, bottom + 10), str(i + 1), 7, FAINT, "middle")
        if value is not None:
            figure.items.append(Dot((x, y(value)), 2.6, BLUE))
    return figure, message("cloud-cloud", title=title)


def deviation_figure(name: str, cells: MapFile) -> tuple[Figure[Text], Text]:
    """The cells of a cloud's map, blue outside the shape and orange inside it."""
    x, y = np.array(cells.x_mm), np.array(cells.y_mm)
    off = np.array(cells.deviation_um)
    end = max(float(np.quantile(np.abs(off), WITHIN)), 0.1)
    figure = Figure[Text](165, 165, message("residuals-gauge", name=name))
    wide = max(float(np.ptp(x)), float(np.ptp(y))) + cells.cell_mm
    scale = 140 / wide
    figure.box((0, 0), 165, 140, GROUND)
    left = (165 - (float(np.ptp(x)) + cells.cell_mm) * scale) / 2
    top = (140 - (float(np.ptp(y)) + cells.cell_mm) * scale) / 2
    size = cells.cell_mm * scale
    for across, up, value in zip(x - x.min(), y.max() - y, off, strict=True):
        figure.box((left + across * scale, top + up * scale), size, size, _colour(value, end))
    for i, colour in enumerate((*reversed(INSIDE), *OUTSIDE)):
        figure.box((42 + 10 * i, 147), 10, 8, colour)
    figure.label((38, 154), signed(-end, "µm"), 7, SOFT, "end")
    figure.label((126, 154), signed(end, "µm"), 7, SOFT)
    figure.label((2, 137), message("wide", wide=quantity(wide, "mm")), 6.5, FAINT)
    return figure, message("distance-fitted-shape-blue-outside-orange", name=name)


def _colour(value: float, end: float) -> str:
    scale = OUTSIDE if value >= 0 else INSIDE
    return scale[min(len(scale) - 1, int(abs(value) / end * len(scale)))]

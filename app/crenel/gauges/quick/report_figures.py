"""The figures of a verification: its limits, its clouds, and each cloud about its fitted shape."""

import numpy as np

from crenel.gauges.quick.document import VerificationFile
from crenel.gauges.quick.evaluate_deviation_maps import MapFile
from crenel.messages.message import Text, join, message, quantity, signed
from crenel.metrology.colormaps import BALANCE, map_colours
from crenel.report.figure import (
    BLUE,
    FAINT,
    GROUND,
    INK,
    LINE,
    PANEL,
    SOFT,
    Dot,
    Figure,
    Point,
)
from crenel.report.formatting import error_value
from crenel.report.limits_figure import LimitedValue, draw_limits

LABELS = 192.0
"""Wide enough for the longest title of a figure, in every language."""
TICK_SPACE = 7.0
"""Between the numbers at a plot's side, so that none lies over another."""
MAP_SIDE = 140.0
"""The side of a deviation map; its legend is below."""
STOPS = 8
"""Colours in the legend of a deviation map."""
RING = 3.0
"""Radius of the ring about an outlier."""


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


def deviation_figure(name: str, cells: MapFile, end_um: float) -> tuple[Figure[Text], Text]:
    """The cells of a cloud's map, blue inside the shape and orange outside it, with a ring about
    each outlier.

    Args:
        end_um: of the scale, on both sides.
    """
    figure = Figure[Text](165, 165, message("residuals-gauge", name=name))
    size_mm = cells.cell_mm
    x = np.array([*cells.x_mm, *(one.x_mm for one in cells.outliers)])
    y = np.array([*cells.y_mm, *(one.y_mm for one in cells.outliers)])
    wide = max(float(np.ptp(x)), float(np.ptp(y))) + size_mm
    scale = MAP_SIDE / wide
    figure.box((0, 0), 165, MAP_SIDE, GROUND)
    left = (165 - (float(np.ptp(x)) + size_mm) * scale) / 2
    top = (MAP_SIDE - (float(np.ptp(y)) + size_mm) * scale) / 2

    def place(x_mm: float, y_mm: float) -> Point:
        """The place of the upper left corner of a cell."""
        return left + (x_mm - x.min()) * scale, top + (y.max() - y_mm) * scale

    for x_mm, y_mm, value in zip(cells.x_mm, cells.y_mm, cells.deviation_um, strict=True):
        side = size_mm * scale
        figure.box(place(x_mm, y_mm), side, side, deviation_colour(value, end_um))
    for one in cells.outliers:
        corner = place(one.x_mm, one.y_mm)
        at = (corner[0] + size_mm * scale / 2, corner[1] + size_mm * scale / 2)
        colour = deviation_colour(one.deviation_um, end_um)
        figure.items.append(Dot(at, RING, colour, INK, 1.2 if one.is_end else 0.6))
    for i in range(STOPS):
        share = 2 * (i + 0.5) / STOPS - 1
        colour = deviation_colour(share * end_um, end_um)
        figure.box((42 + 80 / STOPS * i, 147), 80 / STOPS, 8, colour)
    figure.label((38, 154), signed(-end_um, "µm"), 7, SOFT, "end")
    figure.label((126, 154), signed(end_um, "µm"), 7, SOFT)
    figure.label((2, 137), message("wide", wide=quantity(wide, "mm")), 6.5, FAINT)
    return figure, _deviation_caption(name, cells)


def deviation_colour(value: float, end: float) -> str:
    """The colour of a deviation on the scale that every page and report has."""
    red, green, blue = map_colours(np.array([value]), -end, end, BALANCE)[0].tolist()
    return f"#{red:02x}{green:02x}{blue:02x}"


def _deviation_caption(name: str, cells: MapFile) -> Text:
    ends = [one.deviation_um for one in cells.outliers if one.is_end]
    caption = message("distance-fitted-shape-blue-inside-orange-outside", name=name)
    if not ends:
        return caption
    outliers = message(
        "map-outliers-or-none",
        points=cells.outlier_points,
        low=signed(min(ends), "µm", 1),
        high=signed(max(ends), "µm", 1),
    )
    return join([caption, outliers], " ")

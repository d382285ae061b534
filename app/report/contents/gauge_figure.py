"""How a cloud lies about its fitted shape."""

import numpy as np

from app.messages.message import Text, message, quantity, signed
from app.report.figure import FAINT, GROUND, SOFT, Figure
from app.workflows.measure_gauge import MapFile

INSIDE = ("#fbe3cd", "#f4bd8b", "#e8904a", "#b45309")
OUTSIDE = ("#d6e8fb", "#a9cff6", "#5a9be4", "#1d5bd0")
# The scale ends where all but so few of the cells lie within.
WITHIN = 0.98


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
